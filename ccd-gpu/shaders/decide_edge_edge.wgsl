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
    var phi_15852_: array<u32, 2>;
    var phi_15853_: array<u32, 2>;
    var phi_15854_: bool;
    var phi_15858_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_15853_ = array<u32, 2>();
        phi_15854_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_15852_ = array<u32, 2>();
        } else {
            phi_15852_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_15852_;
        phi_15853_ = _e31;
        phi_15854_ = _e17;
    }
    let _e33 = phi_15853_;
    let _e35 = phi_15854_;
    if _e35 {
        phi_15858_ = array<u32, 2>(0u, 0u);
    } else {
        phi_15858_ = _e33;
    }
    let _e37 = phi_15858_;
    return _e37;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_15831_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_15831_ = param_2;
    } else {
        phi_15831_ = param_1;
    }
    let _e26 = phi_15831_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_15692_: f32;
    var phi_15693_: f32;
    var phi_15732_: f32;
    var phi_15733_: f32;
    var phi_15778_: f32;
    var phi_15779_: f32;
    var phi_15513_: f32;
    var phi_15514_: f32;
    var phi_15559_: f32;
    var phi_15560_: f32;
    var phi_15602_: f32;
    var phi_15603_: f32;
    var phi_15651_: f32;
    var phi_15652_: f32;
    var phi_15794_: array<array<f32, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e157 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_15513_ = _e157;
            } else {
                phi_15513_ = 1f;
            }
            let _e161 = phi_15513_;
            phi_15514_ = _e161;
        } else {
            phi_15514_ = 0f;
        }
        let _e163 = phi_15514_;
        let _e199 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_15559_ = _e199;
            } else {
                phi_15559_ = 1f;
            }
            let _e203 = phi_15559_;
            phi_15560_ = _e203;
        } else {
            phi_15560_ = 0f;
        }
        let _e205 = phi_15560_;
        let _e238 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_15602_ = _e238;
            } else {
                phi_15602_ = 1f;
            }
            let _e242 = phi_15602_;
            phi_15603_ = _e242;
        } else {
            phi_15603_ = 0f;
        }
        let _e244 = phi_15603_;
        let _e257 = (param_3[0] - param_5[0]);
        let _e260 = (param_3[1] - param_5[1]);
        let _e263 = (param_3[2] - param_5[2]);
        let _e283 = ((((_e257 * param_4[0]) + (_e260 * param_4[1])) + (_e263 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_15651_ = _e283;
            } else {
                phi_15651_ = 1f;
            }
            let _e287 = phi_15651_;
            phi_15652_ = _e287;
        } else {
            phi_15652_ = 0f;
        }
        let _e289 = phi_15652_;
        phi_15794_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e163)), (param_3[1] - (param_4[1] * _e163)), (param_3[2] - (param_4[2] * _e163))), array<f32, 3>((param_3[0] - (param_5[0] * _e205)), (param_3[1] - (param_5[1] * _e205)), (param_3[2] - (param_5[2] * _e205))), array<f32, 3>((_e9 - (param_5[0] * _e244)), (_e12 - (param_5[1] * _e244)), (_e15 - (param_5[2] * _e244))), array<f32, 3>((_e257 - (param_4[0] * _e289)), (_e260 - (param_4[1] * _e289)), (_e263 - (param_4[2] * _e289))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_15692_ = _e36;
            } else {
                phi_15692_ = 1f;
            }
            let _e40 = phi_15692_;
            phi_15693_ = _e40;
        } else {
            phi_15693_ = 0f;
        }
        let _e42 = phi_15693_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_15732_ = _e72;
            } else {
                phi_15732_ = 1f;
            }
            let _e76 = phi_15732_;
            phi_15733_ = _e76;
        } else {
            phi_15733_ = 0f;
        }
        let _e78 = phi_15733_;
        let _e114 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_15778_ = _e114;
            } else {
                phi_15778_ = 1f;
            }
            let _e118 = phi_15778_;
            phi_15779_ = _e118;
        } else {
            phi_15779_ = 0f;
        }
        let _e120 = phi_15779_;
        phi_15794_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e78)), (param_3[1] - (param_4[1] * _e78)), (param_3[2] - (param_4[2] * _e78))), array<f32, 3>((param_3[0] - (param_5[0] * _e120)), (param_3[1] - (param_5[1] * _e120)), (param_3[2] - (param_5[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_15794_;
    let _e305 = function_1(_e302[0], _e302[1]);
    let _e307 = function_1(_e305, _e302[2]);
    let _e309 = function_1(_e307, _e302[3]);
    return _e309;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_15414_: bool;
    var phi_15415_: bool;
    var phi_15416_: bool;
    var phi_15417_: bool;
    var phi_15421_: bool;
    var phi_15394_: bool;
    var phi_15395_: bool;
    var phi_15396_: bool;
    var phi_15397_: bool;
    var phi_15398_: bool;
    var phi_15399_: bool;
    var phi_15403_: bool;
    var phi_15422_: bool;
    var phi_15455_: array<f32, 3>;
    var phi_15456_: bool;
    var phi_15457_: array<f32, 3>;
    var phi_15458_: bool;
    var phi_15463_: array<f32, 3>;

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
                    phi_15394_ = (_e78 <= 1f);
                    phi_15395_ = false;
                } else {
                    phi_15394_ = bool();
                    phi_15395_ = true;
                }
                let _e99 = phi_15394_;
                let _e101 = phi_15395_;
                phi_15396_ = _e99;
                phi_15397_ = _e101;
            } else {
                phi_15396_ = bool();
                phi_15397_ = true;
            }
            let _e103 = phi_15396_;
            let _e105 = phi_15397_;
            phi_15398_ = _e103;
            phi_15399_ = _e105;
        } else {
            phi_15398_ = bool();
            phi_15399_ = true;
        }
        let _e107 = phi_15398_;
        let _e109 = phi_15399_;
        if _e109 {
            phi_15403_ = false;
        } else {
            phi_15403_ = _e107;
        }
        let _e111 = phi_15403_;
        phi_15422_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_15414_ = ((_e74 + _e78) <= 1f);
                phi_15415_ = false;
            } else {
                phi_15414_ = bool();
                phi_15415_ = true;
            }
            let _e85 = phi_15414_;
            let _e87 = phi_15415_;
            phi_15416_ = _e85;
            phi_15417_ = _e87;
        } else {
            phi_15416_ = bool();
            phi_15417_ = true;
        }
        let _e89 = phi_15416_;
        let _e91 = phi_15417_;
        if _e91 {
            phi_15421_ = false;
        } else {
            phi_15421_ = _e89;
        }
        let _e93 = phi_15421_;
        phi_15422_ = _e93;
    }
    let _e113 = phi_15422_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_15455_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_15456_ = false;
        } else {
            phi_15455_ = array<f32, 3>();
            phi_15456_ = true;
        }
        let _e141 = phi_15455_;
        let _e143 = phi_15456_;
        phi_15457_ = _e141;
        phi_15458_ = _e143;
    } else {
        phi_15457_ = array<f32, 3>();
        phi_15458_ = true;
    }
    let _e145 = phi_15457_;
    let _e147 = phi_15458_;
    if _e147 {
        let _e148 = function_2(param_7, param_8, param_9, param_10);
        phi_15463_ = _e148;
    } else {
        phi_15463_ = _e145;
    }
    let _e150 = phi_15463_;
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
    var phi_251_: u32;
    var phi_267_: u32;
    var phi_288_: u32;
    var phi_289_: u32;
    var phi_292_: type_12;
    var phi_293_: type_12;
    var phi_316_: type_12;
    var phi_504_: array<u32, 2>;
    var phi_505_: array<u32, 2>;
    var phi_506_: bool;
    var phi_510_: array<u32, 2>;
    var phi_524_: bool;
    var phi_540_: bool;
    var phi_546_: f32;
    var phi_552_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_585_: f32;
    var phi_591_: f32;
    var phi_596_: f32;
    var phi_601_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_619_: f32;
    var phi_625_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_642_: f32;
    var phi_647_: f32;
    var phi_653_: f32;
    var phi_658_: f32;
    var phi_663_: f32;
    var phi_670_: f32;
    var phi_676_: f32;
    var phi_681_: f32;
    var phi_687_: f32;
    var phi_692_: f32;
    var phi_698_: f32;
    var phi_704_: f32;
    var phi_709_: f32;
    var phi_715_: f32;
    var phi_720_: f32;
    var phi_725_: f32;
    var phi_731_: f32;
    var phi_736_: f32;
    var phi_743_: bool;
    var phi_767_: u32;
    var phi_778_: f32;
    var phi_779_: f32;
    var phi_810_: type_38;
    var phi_811_: bool;
    var phi_812_: type_38;
    var phi_813_: bool;
    var phi_814_: type_38;
    var phi_815_: bool;
    var phi_820_: type_38;
    var phi_7766_: f32;
    var phi_7773_: f32;
    var phi_7778_: f32;
    var phi_7785_: f32;
    var phi_7790_: f32;
    var phi_7803_: f32;
    var phi_7810_: f32;
    var phi_7815_: f32;
    var phi_7822_: f32;
    var phi_7827_: f32;
    var phi_7832_: f32;
    var phi_7849_: f32;
    var phi_7856_: f32;
    var phi_7861_: f32;
    var phi_7868_: f32;
    var phi_7873_: f32;
    var phi_7887_: f32;
    var phi_7894_: f32;
    var phi_7899_: f32;
    var phi_7906_: f32;
    var phi_7911_: f32;
    var phi_7916_: f32;
    var phi_7933_: f32;
    var phi_7940_: f32;
    var phi_7945_: f32;
    var phi_7952_: f32;
    var phi_7957_: f32;
    var phi_7971_: f32;
    var phi_7978_: f32;
    var phi_7983_: f32;
    var phi_7990_: f32;
    var phi_7995_: f32;
    var phi_8000_: f32;
    var phi_8031_: f32;
    var phi_8037_: f32;
    var phi_8044_: f32;
    var phi_8051_: f32;
    var phi_8057_: f32;
    var phi_8064_: f32;
    var phi_8070_: f32;
    var phi_8076_: f32;
    var phi_8082_: f32;
    var phi_8089_: f32;
    var phi_8096_: f32;
    var phi_8120_: f32;
    var phi_8125_: f32;
    var phi_8130_: f32;
    var phi_8135_: f32;
    var phi_8140_: f32;
    var phi_8145_: f32;
    var phi_8155_: f32;
    var phi_8168_: f32;
    var phi_8174_: f32;
    var phi_8179_: f32;
    var phi_8185_: f32;
    var phi_8191_: f32;
    var phi_8196_: f32;
    var phi_8201_: f32;
    var phi_8209_: bool;
    var phi_8214_: f32;
    var phi_8221_: f32;
    var phi_8227_: f32;
    var phi_8245_: f32;
    var phi_8393_: f32;
    var phi_8400_: f32;
    var phi_8405_: f32;
    var phi_8412_: f32;
    var phi_8417_: f32;
    var phi_8430_: f32;
    var phi_8437_: f32;
    var phi_8442_: f32;
    var phi_8449_: f32;
    var phi_8454_: f32;
    var phi_8459_: f32;
    var phi_8476_: f32;
    var phi_8483_: f32;
    var phi_8488_: f32;
    var phi_8495_: f32;
    var phi_8500_: f32;
    var phi_8514_: f32;
    var phi_8521_: f32;
    var phi_8526_: f32;
    var phi_8533_: f32;
    var phi_8538_: f32;
    var phi_8543_: f32;
    var phi_8560_: f32;
    var phi_8567_: f32;
    var phi_8572_: f32;
    var phi_8579_: f32;
    var phi_8584_: f32;
    var phi_8598_: f32;
    var phi_8605_: f32;
    var phi_8610_: f32;
    var phi_8617_: f32;
    var phi_8622_: f32;
    var phi_8627_: f32;
    var phi_8745_: f32;
    var phi_8752_: f32;
    var phi_8760_: f32;
    var phi_8804_: type_14;
    var phi_8807_: f32;
    var phi_8828_: bool;
    var phi_8834_: type_15;
    var phi_8805_: type_14;
    var phi_8848_: type_15;
    var phi_8808_: f32;
    var local_19: f32;
    var phi_8797_: f32;
    var phi_8861_: f32;
    var phi_8927_: f32;
    var phi_8933_: f32;
    var phi_8942_: f32;
    var phi_8948_: f32;
    var phi_8957_: f32;
    var phi_8963_: f32;
    var phi_8972_: f32;
    var phi_8978_: f32;
    var phi_8984_: type_32;
    var phi_8985_: bool;
    var phi_8986_: type_32;
    var phi_8987_: bool;
    var phi_8995_: type_32;
    var phi_9164_: bool;
    var phi_9165_: bool;
    var phi_9166_: bool;
    var phi_9167_: bool;
    var phi_9168_: bool;
    var phi_9169_: bool;
    var phi_9173_: bool;
    var phi_9200_: f32;
    var phi_9254_: type_14;
    var phi_9257_: f32;
    var phi_9278_: bool;
    var phi_9284_: type_15;
    var phi_9255_: type_14;
    var phi_9298_: type_15;
    var phi_9258_: f32;
    var local_20: f32;
    var phi_9247_: f32;
    var phi_9311_: f32;
    var phi_9377_: f32;
    var phi_9383_: f32;
    var phi_9392_: f32;
    var phi_9398_: f32;
    var phi_9407_: f32;
    var phi_9413_: f32;
    var phi_9422_: f32;
    var phi_9428_: f32;
    var phi_9434_: type_32;
    var phi_9435_: bool;
    var phi_9436_: type_32;
    var phi_9437_: bool;
    var phi_9445_: type_32;
    var phi_9614_: bool;
    var phi_9615_: bool;
    var phi_9616_: bool;
    var phi_9617_: bool;
    var phi_9618_: bool;
    var phi_9619_: bool;
    var phi_9623_: bool;
    var phi_9656_: f32;
    var phi_9704_: type_14;
    var phi_9707_: f32;
    var phi_9728_: bool;
    var phi_9734_: type_15;
    var phi_9705_: type_14;
    var phi_9748_: type_15;
    var phi_9708_: f32;
    var local_21: f32;
    var phi_9697_: f32;
    var phi_9761_: f32;
    var phi_9827_: f32;
    var phi_9833_: f32;
    var phi_9842_: f32;
    var phi_9848_: f32;
    var phi_9857_: f32;
    var phi_9863_: f32;
    var phi_9872_: f32;
    var phi_9878_: f32;
    var phi_9884_: type_32;
    var phi_9885_: bool;
    var phi_9886_: type_32;
    var phi_9887_: bool;
    var phi_9895_: type_32;
    var phi_10064_: bool;
    var phi_10065_: bool;
    var phi_10066_: bool;
    var phi_10067_: bool;
    var phi_10068_: bool;
    var phi_10069_: bool;
    var phi_10073_: bool;
    var phi_10113_: f32;
    var phi_10154_: type_14;
    var phi_10157_: f32;
    var phi_10178_: bool;
    var phi_10184_: type_15;
    var phi_10155_: type_14;
    var phi_10198_: type_15;
    var phi_10158_: f32;
    var local_22: f32;
    var phi_10147_: f32;
    var phi_10211_: f32;
    var phi_10277_: f32;
    var phi_10283_: f32;
    var phi_10292_: f32;
    var phi_10298_: f32;
    var phi_10307_: f32;
    var phi_10313_: f32;
    var phi_10322_: f32;
    var phi_10328_: f32;
    var phi_10334_: type_32;
    var phi_10335_: bool;
    var phi_10336_: type_32;
    var phi_10337_: bool;
    var phi_10345_: type_32;
    var phi_10514_: bool;
    var phi_10515_: bool;
    var phi_10516_: bool;
    var phi_10517_: bool;
    var phi_10518_: bool;
    var phi_10519_: bool;
    var phi_10523_: bool;
    var phi_10524_: bool;
    var phi_10525_: bool;
    var phi_10526_: bool;
    var phi_10527_: bool;
    var phi_10528_: bool;
    var phi_10532_: bool;
    var phi_10538_: type_30;
    var phi_10539_: bool;
    var phi_10540_: type_30;
    var phi_10541_: bool;
    var phi_10584_: type_14;
    var phi_10587_: f32;
    var phi_10608_: bool;
    var phi_10614_: type_15;
    var phi_10585_: type_14;
    var phi_10628_: type_15;
    var phi_10588_: f32;
    var local_23: f32;
    var phi_10577_: f32;
    var phi_10641_: f32;
    var phi_10647_: f32;
    var phi_10672_: type_12;
    var phi_10675_: u32;
    var phi_10673_: type_12;
    var phi_10698_: type_12;
    var phi_10742_: u32;
    var phi_10743_: u32;
    var phi_10676_: u32;
    var phi_10744_: u32;
    var phi_10764_: type_12;
    var phi_10765_: type_12;
    var phi_10788_: type_12;
    var phi_10807_: f32;
    var phi_10820_: f32;
    var phi_10854_: f32;
    var phi_10861_: f32;
    var phi_10872_: bool;
    var phi_10873_: bool;
    var phi_10874_: bool;
    var phi_10875_: bool;
    var phi_10879_: bool;
    var phi_10890_: type_41;
    var phi_10891_: type_41;
    var phi_10892_: bool;
    var phi_10893_: type_41;
    var phi_10894_: bool;
    var phi_10905_: f32;
    var phi_10915_: type_12;
    var phi_10918_: f32;
    var phi_10920_: f32;
    var phi_10922_: f32;
    var phi_10916_: type_12;
    var phi_10945_: type_12;
    var phi_10970_: f32;
    var phi_10971_: f32;
    var phi_10997_: f32;
    var phi_11013_: f32;
    var phi_11020_: bool;
    var phi_11021_: bool;
    var phi_11022_: bool;
    var phi_11028_: f32;
    var phi_11029_: f32;
    var phi_11030_: bool;
    var phi_10919_: f32;
    var phi_10921_: f32;
    var phi_10923_: f32;
    var phi_11031_: f32;
    var phi_11032_: bool;
    var phi_11033_: bool;
    var local_24: bool;
    var phi_11037_: f32;
    var phi_11038_: f32;
    var phi_11046_: f32;
    var phi_11050_: type_12;
    var phi_11053_: f32;
    var phi_11051_: type_12;
    var phi_11076_: type_12;
    var phi_11106_: f32;
    var phi_11107_: bool;
    var phi_11108_: f32;
    var phi_11109_: bool;
    var phi_11110_: bool;
    var phi_11111_: bool;
    var phi_11112_: f32;
    var phi_11054_: f32;
    var phi_11113_: bool;
    var phi_11114_: bool;
    var phi_11115_: bool;
    var phi_11116_: bool;
    var local_25: bool;
    var phi_11120_: bool;
    var phi_11121_: bool;
    var phi_11125_: bool;
    var phi_11129_: f32;
    var phi_11130_: f32;
    var phi_11132_: type_41;
    var phi_11161_: f32;
    var phi_11168_: f32;
    var phi_11173_: f32;
    var phi_11180_: f32;
    var phi_11185_: f32;
    var phi_11198_: f32;
    var phi_11205_: f32;
    var phi_11210_: f32;
    var phi_11217_: f32;
    var phi_11222_: f32;
    var phi_11227_: f32;
    var phi_11286_: f32;
    var phi_11292_: f32;
    var phi_11297_: f32;
    var phi_11303_: f32;
    var phi_11308_: f32;
    var phi_11320_: f32;
    var phi_11326_: f32;
    var phi_11331_: f32;
    var phi_11337_: f32;
    var phi_11342_: f32;
    var phi_11368_: f32;
    var phi_11375_: f32;
    var phi_11380_: f32;
    var phi_11387_: f32;
    var phi_11392_: f32;
    var phi_11405_: f32;
    var phi_11412_: f32;
    var phi_11417_: f32;
    var phi_11424_: f32;
    var phi_11429_: f32;
    var phi_11434_: f32;
    var phi_11493_: f32;
    var phi_11499_: f32;
    var phi_11504_: f32;
    var phi_11510_: f32;
    var phi_11515_: f32;
    var phi_11527_: f32;
    var phi_11533_: f32;
    var phi_11538_: f32;
    var phi_11544_: f32;
    var phi_11549_: f32;
    var phi_11575_: f32;
    var phi_11582_: f32;
    var phi_11587_: f32;
    var phi_11594_: f32;
    var phi_11599_: f32;
    var phi_11612_: f32;
    var phi_11619_: f32;
    var phi_11624_: f32;
    var phi_11631_: f32;
    var phi_11636_: f32;
    var phi_11641_: f32;
    var phi_11700_: f32;
    var phi_11706_: f32;
    var phi_11711_: f32;
    var phi_11717_: f32;
    var phi_11722_: f32;
    var phi_11734_: f32;
    var phi_11740_: f32;
    var phi_11745_: f32;
    var phi_11751_: f32;
    var phi_11756_: f32;
    var phi_11805_: f32;
    var phi_11811_: f32;
    var phi_11839_: f32;
    var phi_11845_: f32;
    var phi_11850_: u32;
    var phi_11851_: u32;
    var phi_11821_: f32;
    var phi_11827_: f32;
    var phi_11832_: u32;
    var phi_11833_: u32;
    var phi_11852_: u32;
    var phi_11853_: u32;
    var phi_11922_: f32;
    var phi_11931_: f32;
    var phi_12066_: f32;
    var phi_12072_: f32;
    var phi_12079_: f32;
    var phi_12134_: type_12;
    var phi_12137_: bool;
    var phi_12135_: type_12;
    var phi_12160_: type_12;
    var phi_12187_: bool;
    var phi_12188_: bool;
    var phi_12138_: bool;
    var phi_12189_: bool;
    var phi_12190_: bool;
    var local_26: bool;
    var phi_12194_: bool;
    var local_27: bool;
    var phi_12201_: u32;
    var phi_12202_: u32;
    var phi_12203_: bool;
    var phi_12204_: u32;
    var phi_12205_: u32;
    var phi_12206_: bool;
    var phi_12210_: u32;
    var phi_12220_: bool;
    var phi_12232_: bool;
    var phi_12233_: bool;
    var phi_12381_: f32;
    var phi_12388_: f32;
    var phi_12393_: f32;
    var phi_12400_: f32;
    var phi_12405_: f32;
    var phi_12418_: f32;
    var phi_12425_: f32;
    var phi_12430_: f32;
    var phi_12437_: f32;
    var phi_12442_: f32;
    var phi_12447_: f32;
    var phi_12464_: f32;
    var phi_12471_: f32;
    var phi_12476_: f32;
    var phi_12483_: f32;
    var phi_12488_: f32;
    var phi_12502_: f32;
    var phi_12509_: f32;
    var phi_12514_: f32;
    var phi_12521_: f32;
    var phi_12526_: f32;
    var phi_12531_: f32;
    var phi_12548_: f32;
    var phi_12555_: f32;
    var phi_12560_: f32;
    var phi_12567_: f32;
    var phi_12572_: f32;
    var phi_12586_: f32;
    var phi_12593_: f32;
    var phi_12598_: f32;
    var phi_12605_: f32;
    var phi_12610_: f32;
    var phi_12615_: f32;
    var phi_12656_: type_12;
    var phi_12659_: f32;
    var phi_12661_: f32;
    var phi_12663_: f32;
    var phi_12665_: f32;
    var phi_12667_: bool;
    var phi_12669_: u32;
    var phi_12657_: type_12;
    var phi_12692_: type_12;
    var phi_12806_: f32;
    var phi_12812_: f32;
    var phi_12818_: f32;
    var phi_12820_: array<f32, 3>;
    var phi_12827_: f32;
    var phi_12834_: f32;
    var phi_12842_: f32;
    var phi_12886_: type_14;
    var phi_12889_: f32;
    var phi_12910_: bool;
    var phi_12916_: type_15;
    var phi_12887_: type_14;
    var phi_12930_: type_15;
    var phi_12890_: f32;
    var local_28: f32;
    var phi_12879_: f32;
    var phi_12943_: f32;
    var phi_13009_: f32;
    var phi_13015_: f32;
    var phi_13024_: f32;
    var phi_13030_: f32;
    var phi_13039_: f32;
    var phi_13045_: f32;
    var phi_13054_: f32;
    var phi_13060_: f32;
    var phi_13066_: type_32;
    var phi_13067_: bool;
    var phi_13068_: type_32;
    var phi_13069_: bool;
    var phi_13077_: type_32;
    var phi_13248_: bool;
    var phi_13249_: bool;
    var phi_13250_: bool;
    var phi_13251_: bool;
    var phi_13252_: bool;
    var phi_13253_: bool;
    var phi_13257_: bool;
    var phi_13554_: bool;
    var phi_13555_: bool;
    var phi_13556_: bool;
    var phi_13557_: bool;
    var phi_13558_: bool;
    var phi_13559_: bool;
    var phi_13563_: bool;
    var phi_13567_: bool;
    var phi_13578_: bool;
    var phi_13579_: bool;
    var phi_13653_: bool;
    var phi_13654_: bool;
    var phi_13674_: f32;
    var phi_13675_: bool;
    var phi_13676_: f32;
    var phi_13677_: bool;
    var phi_13678_: f32;
    var phi_13679_: bool;
    var phi_13680_: bool;
    var phi_13684_: f32;
    var phi_13685_: bool;
    var phi_13689_: f32;
    var phi_13721_: bool;
    var phi_13722_: bool;
    var phi_13742_: f32;
    var phi_13743_: bool;
    var phi_13744_: f32;
    var phi_13745_: bool;
    var phi_13746_: f32;
    var phi_13747_: bool;
    var phi_13748_: bool;
    var phi_13752_: f32;
    var phi_13753_: bool;
    var phi_13757_: f32;
    var phi_13762_: f32;
    var phi_13794_: bool;
    var phi_13795_: bool;
    var phi_13815_: f32;
    var phi_13816_: bool;
    var phi_13817_: f32;
    var phi_13818_: bool;
    var phi_13819_: f32;
    var phi_13820_: bool;
    var phi_13821_: bool;
    var phi_13825_: f32;
    var phi_13826_: bool;
    var phi_13830_: f32;
    var phi_13862_: bool;
    var phi_13863_: bool;
    var phi_13883_: f32;
    var phi_13884_: bool;
    var phi_13885_: f32;
    var phi_13886_: bool;
    var phi_13887_: f32;
    var phi_13888_: bool;
    var phi_13889_: bool;
    var phi_13893_: f32;
    var phi_13894_: bool;
    var phi_13898_: f32;
    var phi_13903_: f32;
    var phi_13908_: f32;
    var phi_13913_: f32;
    var phi_14407_: bool;
    var phi_14408_: bool;
    var phi_14413_: f32;
    var phi_14415_: f32;
    var phi_14418_: f32;
    var phi_14419_: f32;
    var phi_14420_: bool;
    var phi_14422_: f32;
    var phi_14423_: f32;
    var phi_14424_: f32;
    var phi_14426_: bool;
    var phi_14427_: bool;
    var phi_14429_: bool;
    var phi_14430_: f32;
    var phi_14431_: f32;
    var phi_14432_: f32;
    var phi_14434_: bool;
    var phi_14435_: bool;
    var phi_14436_: bool;
    var phi_14438_: bool;
    var phi_14439_: f32;
    var phi_14440_: f32;
    var phi_14441_: f32;
    var phi_14443_: bool;
    var phi_14444_: bool;
    var phi_14445_: bool;
    var phi_14447_: bool;
    var phi_14533_: f32;
    var phi_14606_: f32;
    var phi_14611_: f32;
    var phi_14684_: f32;
    var phi_14757_: f32;
    var phi_14762_: f32;
    var phi_14778_: f32;
    var phi_14779_: f32;
    var phi_14780_: f32;
    var phi_14460_: bool;
    var phi_14782_: u32;
    var phi_14783_: f32;
    var phi_14784_: bool;
    var phi_14785_: bool;
    var phi_14786_: bool;
    var phi_14787_: u32;
    var phi_14788_: f32;
    var phi_14789_: f32;
    var phi_14790_: f32;
    var phi_14791_: f32;
    var phi_14792_: bool;
    var phi_14793_: u32;
    var phi_14794_: bool;
    var phi_14795_: bool;
    var phi_14796_: bool;
    var phi_14797_: bool;
    var phi_14799_: bool;
    var phi_14808_: f32;
    var phi_14813_: f32;
    var phi_14822_: bool;
    var phi_14826_: bool;
    var phi_14827_: f32;
    var phi_14828_: f32;
    var phi_14829_: f32;
    var phi_14830_: f32;
    var phi_14831_: bool;
    var phi_14832_: u32;
    var phi_14833_: bool;
    var phi_14834_: bool;
    var phi_14835_: bool;
    var phi_14836_: bool;
    var phi_14838_: bool;
    var phi_12660_: f32;
    var phi_12662_: f32;
    var phi_12664_: f32;
    var phi_12666_: f32;
    var phi_12668_: bool;
    var phi_12670_: u32;
    var phi_14839_: f32;
    var phi_14841_: bool;
    var phi_14842_: bool;
    var phi_14843_: bool;
    var phi_14844_: bool;
    var phi_14846_: bool;
    var phi_14847_: bool;
    var local_29: bool;
    var phi_14851_: bool;
    var phi_14852_: bool;
    var phi_14854_: bool;
    var phi_14855_: bool;
    var local_30: f32;
    var phi_14860_: type_30;
    var phi_14861_: bool;
    var phi_14863_: bool;
    var phi_14864_: bool;
    var phi_14865_: bool;
    var phi_14870_: type_30;
    var phi_14872_: bool;
    var phi_14873_: bool;
    var phi_14874_: bool;
    var phi_14875_: bool;
    var phi_14887_: f32;
    var phi_14888_: bool;
    var phi_14889_: bool;
    var phi_14890_: bool;
    var phi_14895_: type_30;
    var phi_14896_: bool;
    var phi_14897_: bool;
    var phi_14902_: type_30;
    var phi_14903_: bool;
    var phi_14907_: type_30;
    var phi_14914_: bool;
    var phi_14915_: f32;
    var phi_14916_: bool;
    var phi_14917_: bool;
    var phi_14918_: bool;
    var phi_14919_: bool;
    var phi_14920_: f32;
    var phi_14921_: f32;
    var phi_14922_: bool;
    var phi_14923_: bool;
    var phi_14924_: bool;
    var phi_14925_: bool;
    var phi_14926_: f32;
    var phi_14927_: f32;
    var phi_14928_: bool;
    var phi_14929_: bool;
    var phi_14930_: bool;
    var phi_14931_: bool;
    var phi_14935_: bool;
    var phi_14936_: bool;
    var phi_14937_: bool;
    var phi_14938_: type_41;
    var phi_14939_: bool;
    var phi_14940_: f32;
    var phi_14941_: f32;
    var phi_14942_: type_41;
    var phi_14943_: bool;
    var phi_14944_: bool;
    var phi_14945_: bool;
    var phi_14946_: bool;
    var phi_14950_: bool;
    var phi_14951_: bool;
    var phi_14952_: bool;
    var phi_14953_: type_41;
    var phi_14954_: bool;
    var phi_14955_: f32;
    var phi_14956_: f32;
    var phi_14957_: type_41;
    var phi_14958_: bool;
    var phi_14959_: bool;
    var phi_14960_: bool;
    var phi_14961_: bool;
    var local_31: bool;
    var phi_14966_: type_30;
    var phi_14967_: bool;
    var phi_14968_: bool;
    var local_32: bool;
    var local_33: type_41;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;
    var phi_14982_: type_30;
    var phi_14983_: bool;
    var phi_14984_: type_30;
    var phi_14985_: bool;
    var local_37: f32;
    var phi_14990_: type_30;
    var phi_14991_: type_30;
    var phi_14992_: bool;
    var local_38: type_41;
    var phi_14998_: type_30;
    var phi_14999_: bool;
    var phi_15003_: type_30;
    var phi_15004_: type_30;
    var phi_15005_: bool;
    var phi_15009_: type_30;
    var phi_15010_: type_30;
    var phi_15011_: bool;
    var phi_15015_: type_30;
    var phi_15026_: bool;
    var phi_15027_: bool;
    var phi_15031_: bool;
    var phi_15035_: u32;
    var phi_994_: type_14;
    var phi_997_: f32;
    var phi_1018_: bool;
    var phi_1024_: type_15;
    var phi_995_: type_14;
    var phi_1038_: type_15;
    var phi_998_: f32;
    var local_39: f32;
    var phi_987_: f32;
    var phi_1051_: f32;
    var phi_1067_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1086_: f32;
    var phi_1091_: f32;
    var phi_1104_: f32;
    var phi_1111_: f32;
    var phi_1116_: f32;
    var phi_1123_: f32;
    var phi_1128_: f32;
    var phi_1133_: f32;
    var phi_1150_: f32;
    var phi_1157_: f32;
    var phi_1162_: f32;
    var phi_1169_: f32;
    var phi_1174_: f32;
    var phi_1188_: f32;
    var phi_1195_: f32;
    var phi_1200_: f32;
    var phi_1207_: f32;
    var phi_1212_: f32;
    var phi_1217_: f32;
    var phi_1234_: f32;
    var phi_1241_: f32;
    var phi_1246_: f32;
    var phi_1253_: f32;
    var phi_1258_: f32;
    var phi_1272_: f32;
    var phi_1279_: f32;
    var phi_1284_: f32;
    var phi_1291_: f32;
    var phi_1296_: f32;
    var phi_1301_: f32;
    var phi_1562_: f32;
    var phi_1569_: f32;
    var phi_1574_: f32;
    var phi_1581_: f32;
    var phi_1586_: f32;
    var phi_1599_: f32;
    var phi_1606_: f32;
    var phi_1611_: f32;
    var phi_1618_: f32;
    var phi_1623_: f32;
    var phi_1628_: f32;
    var phi_1645_: f32;
    var phi_1652_: f32;
    var phi_1657_: f32;
    var phi_1664_: f32;
    var phi_1669_: f32;
    var phi_1683_: f32;
    var phi_1690_: f32;
    var phi_1695_: f32;
    var phi_1702_: f32;
    var phi_1707_: f32;
    var phi_1712_: f32;
    var phi_1729_: f32;
    var phi_1736_: f32;
    var phi_1741_: f32;
    var phi_1748_: f32;
    var phi_1753_: f32;
    var phi_1767_: f32;
    var phi_1774_: f32;
    var phi_1779_: f32;
    var phi_1786_: f32;
    var phi_1791_: f32;
    var phi_1796_: f32;
    var phi_1827_: f32;
    var phi_1833_: f32;
    var phi_1840_: f32;
    var phi_1847_: f32;
    var phi_1853_: f32;
    var phi_1860_: f32;
    var phi_1866_: f32;
    var phi_1872_: f32;
    var phi_1878_: f32;
    var phi_1885_: f32;
    var phi_1892_: f32;
    var phi_1916_: f32;
    var phi_1921_: f32;
    var phi_1926_: f32;
    var phi_1931_: f32;
    var phi_1936_: f32;
    var phi_1941_: f32;
    var phi_1951_: f32;
    var phi_1960_: type_39;
    var phi_1961_: bool;
    var phi_1962_: type_39;
    var phi_1963_: bool;
    var phi_1969_: type_14;
    var phi_1972_: f32;
    var phi_1974_: u32;
    var phi_1976_: f32;
    var phi_1997_: bool;
    var phi_2003_: type_15;
    var phi_1970_: type_14;
    var phi_2017_: type_15;
    var phi_2032_: bool;
    var phi_2033_: bool;
    var phi_2179_: f32;
    var phi_2186_: f32;
    var phi_2191_: f32;
    var phi_2198_: f32;
    var phi_2203_: f32;
    var phi_2216_: f32;
    var phi_2223_: f32;
    var phi_2228_: f32;
    var phi_2235_: f32;
    var phi_2240_: f32;
    var phi_2245_: f32;
    var phi_2262_: f32;
    var phi_2269_: f32;
    var phi_2274_: f32;
    var phi_2281_: f32;
    var phi_2286_: f32;
    var phi_2300_: f32;
    var phi_2307_: f32;
    var phi_2312_: f32;
    var phi_2319_: f32;
    var phi_2324_: f32;
    var phi_2329_: f32;
    var phi_2346_: f32;
    var phi_2353_: f32;
    var phi_2358_: f32;
    var phi_2365_: f32;
    var phi_2370_: f32;
    var phi_2384_: f32;
    var phi_2391_: f32;
    var phi_2396_: f32;
    var phi_2403_: f32;
    var phi_2408_: f32;
    var phi_2413_: f32;
    var phi_2454_: type_12;
    var phi_2457_: f32;
    var phi_2459_: f32;
    var phi_2461_: f32;
    var phi_2463_: f32;
    var phi_2465_: bool;
    var phi_2467_: u32;
    var phi_2455_: type_12;
    var phi_2490_: type_12;
    var phi_2604_: f32;
    var phi_2610_: f32;
    var phi_2616_: f32;
    var phi_2618_: array<f32, 3>;
    var phi_2625_: f32;
    var phi_2632_: f32;
    var phi_2640_: f32;
    var phi_2684_: type_14;
    var phi_2687_: f32;
    var phi_2708_: bool;
    var phi_2714_: type_15;
    var phi_2685_: type_14;
    var phi_2728_: type_15;
    var phi_2688_: f32;
    var local_40: f32;
    var phi_2677_: f32;
    var phi_2741_: f32;
    var phi_2807_: f32;
    var phi_2813_: f32;
    var phi_2822_: f32;
    var phi_2828_: f32;
    var phi_2837_: f32;
    var phi_2843_: f32;
    var phi_2852_: f32;
    var phi_2858_: f32;
    var phi_2864_: type_32;
    var phi_2865_: bool;
    var phi_2866_: type_32;
    var phi_2867_: bool;
    var phi_2875_: type_32;
    var phi_3046_: bool;
    var phi_3047_: bool;
    var phi_3048_: bool;
    var phi_3049_: bool;
    var phi_3050_: bool;
    var phi_3051_: bool;
    var phi_3055_: bool;
    var phi_3352_: bool;
    var phi_3353_: bool;
    var phi_3354_: bool;
    var phi_3355_: bool;
    var phi_3356_: bool;
    var phi_3357_: bool;
    var phi_3361_: bool;
    var phi_3365_: bool;
    var phi_3376_: bool;
    var phi_3377_: bool;
    var phi_3451_: bool;
    var phi_3452_: bool;
    var phi_3472_: f32;
    var phi_3473_: bool;
    var phi_3474_: f32;
    var phi_3475_: bool;
    var phi_3476_: f32;
    var phi_3477_: bool;
    var phi_3478_: bool;
    var phi_3482_: f32;
    var phi_3483_: bool;
    var phi_3487_: f32;
    var phi_3519_: bool;
    var phi_3520_: bool;
    var phi_3540_: f32;
    var phi_3541_: bool;
    var phi_3542_: f32;
    var phi_3543_: bool;
    var phi_3544_: f32;
    var phi_3545_: bool;
    var phi_3546_: bool;
    var phi_3550_: f32;
    var phi_3551_: bool;
    var phi_3555_: f32;
    var phi_3560_: f32;
    var phi_3592_: bool;
    var phi_3593_: bool;
    var phi_3613_: f32;
    var phi_3614_: bool;
    var phi_3615_: f32;
    var phi_3616_: bool;
    var phi_3617_: f32;
    var phi_3618_: bool;
    var phi_3619_: bool;
    var phi_3623_: f32;
    var phi_3624_: bool;
    var phi_3628_: f32;
    var phi_3660_: bool;
    var phi_3661_: bool;
    var phi_3681_: f32;
    var phi_3682_: bool;
    var phi_3683_: f32;
    var phi_3684_: bool;
    var phi_3685_: f32;
    var phi_3686_: bool;
    var phi_3687_: bool;
    var phi_3691_: f32;
    var phi_3692_: bool;
    var phi_3696_: f32;
    var phi_3701_: f32;
    var phi_3706_: f32;
    var phi_3711_: f32;
    var phi_3724_: f32;
    var phi_3861_: type_14;
    var phi_3864_: f32;
    var phi_3885_: bool;
    var phi_3891_: type_15;
    var phi_3862_: type_14;
    var phi_3905_: type_15;
    var phi_3865_: f32;
    var local_41: f32;
    var phi_3854_: f32;
    var phi_3918_: f32;
    var phi_3934_: f32;
    var phi_3941_: f32;
    var phi_3946_: f32;
    var phi_3953_: f32;
    var phi_3958_: f32;
    var phi_3971_: f32;
    var phi_3978_: f32;
    var phi_3983_: f32;
    var phi_3990_: f32;
    var phi_3995_: f32;
    var phi_4000_: f32;
    var phi_4017_: f32;
    var phi_4024_: f32;
    var phi_4029_: f32;
    var phi_4036_: f32;
    var phi_4041_: f32;
    var phi_4055_: f32;
    var phi_4062_: f32;
    var phi_4067_: f32;
    var phi_4074_: f32;
    var phi_4079_: f32;
    var phi_4084_: f32;
    var phi_4101_: f32;
    var phi_4108_: f32;
    var phi_4113_: f32;
    var phi_4120_: f32;
    var phi_4125_: f32;
    var phi_4139_: f32;
    var phi_4146_: f32;
    var phi_4151_: f32;
    var phi_4158_: f32;
    var phi_4163_: f32;
    var phi_4168_: f32;
    var phi_4188_: bool;
    var phi_4189_: bool;
    var phi_4190_: bool;
    var phi_4205_: bool;
    var phi_4206_: bool;
    var phi_4211_: f32;
    var phi_4213_: f32;
    var phi_4214_: f32;
    var phi_4215_: bool;
    var phi_4216_: f32;
    var phi_4217_: f32;
    var phi_4218_: bool;
    var phi_4219_: bool;
    var phi_4220_: f32;
    var phi_4221_: f32;
    var phi_4222_: f32;
    var phi_4223_: f32;
    var phi_4224_: bool;
    var phi_4225_: bool;
    var phi_4226_: bool;
    var phi_4227_: bool;
    var phi_4228_: f32;
    var phi_4229_: f32;
    var phi_4230_: f32;
    var phi_4231_: f32;
    var phi_4232_: bool;
    var phi_4233_: bool;
    var phi_4234_: bool;
    var phi_4235_: bool;
    var phi_4236_: bool;
    var phi_4237_: f32;
    var phi_4238_: f32;
    var phi_4239_: f32;
    var phi_4240_: f32;
    var phi_4241_: bool;
    var phi_4242_: bool;
    var phi_4243_: bool;
    var phi_4244_: bool;
    var phi_4245_: bool;
    var phi_4331_: f32;
    var phi_4404_: f32;
    var phi_4409_: f32;
    var phi_4482_: f32;
    var phi_4555_: f32;
    var phi_4560_: f32;
    var phi_4576_: f32;
    var phi_4577_: f32;
    var phi_4578_: f32;
    var phi_4258_: bool;
    var phi_4580_: u32;
    var phi_4581_: f32;
    var phi_4582_: bool;
    var phi_4583_: bool;
    var phi_4584_: bool;
    var phi_4585_: u32;
    var phi_4586_: f32;
    var phi_4587_: f32;
    var phi_4588_: f32;
    var phi_4589_: f32;
    var phi_4590_: bool;
    var phi_4591_: u32;
    var phi_4592_: bool;
    var phi_4593_: bool;
    var phi_4594_: bool;
    var phi_4595_: bool;
    var phi_4596_: bool;
    var phi_4597_: bool;
    var phi_4606_: f32;
    var phi_4611_: f32;
    var phi_4620_: bool;
    var phi_4624_: bool;
    var phi_4625_: f32;
    var phi_4626_: f32;
    var phi_4627_: f32;
    var phi_4628_: f32;
    var phi_4629_: bool;
    var phi_4630_: u32;
    var phi_4631_: bool;
    var phi_4632_: bool;
    var phi_4633_: bool;
    var phi_4634_: bool;
    var phi_4635_: bool;
    var phi_4636_: bool;
    var phi_2458_: f32;
    var phi_2460_: f32;
    var phi_2462_: f32;
    var phi_2464_: f32;
    var phi_2466_: bool;
    var phi_2468_: u32;
    var phi_4637_: f32;
    var phi_4638_: f32;
    var phi_4639_: bool;
    var phi_4640_: bool;
    var phi_4641_: bool;
    var phi_4642_: bool;
    var phi_4643_: bool;
    var phi_4644_: bool;
    var phi_4645_: bool;
    var local_42: bool;
    var phi_4649_: bool;
    var phi_4650_: bool;
    var phi_4651_: bool;
    var phi_4652_: bool;
    var phi_4653_: bool;
    var local_43: f32;
    var phi_4658_: type_30;
    var phi_4659_: bool;
    var phi_4660_: bool;
    var phi_4661_: bool;
    var phi_4662_: bool;
    var phi_4663_: bool;
    var phi_4668_: type_30;
    var phi_4669_: bool;
    var phi_4670_: bool;
    var phi_4671_: bool;
    var phi_4672_: bool;
    var phi_4673_: bool;
    var phi_4677_: f32;
    var phi_4678_: bool;
    var phi_4679_: bool;
    var phi_4680_: bool;
    var phi_4681_: bool;
    var phi_4685_: f32;
    var phi_4686_: bool;
    var phi_4687_: bool;
    var phi_4688_: bool;
    var phi_4693_: type_30;
    var phi_4694_: bool;
    var phi_4695_: bool;
    var phi_4700_: type_30;
    var phi_4701_: bool;
    var phi_4705_: type_30;
    var phi_4712_: f32;
    var phi_4713_: bool;
    var phi_4825_: f32;
    var phi_4832_: f32;
    var phi_4840_: f32;
    var phi_4991_: f32;
    var phi_4998_: f32;
    var phi_5003_: f32;
    var phi_5010_: f32;
    var phi_5015_: f32;
    var phi_5028_: f32;
    var phi_5035_: f32;
    var phi_5040_: f32;
    var phi_5047_: f32;
    var phi_5052_: f32;
    var phi_5057_: f32;
    var phi_5074_: f32;
    var phi_5081_: f32;
    var phi_5086_: f32;
    var phi_5093_: f32;
    var phi_5098_: f32;
    var phi_5112_: f32;
    var phi_5119_: f32;
    var phi_5124_: f32;
    var phi_5131_: f32;
    var phi_5136_: f32;
    var phi_5141_: f32;
    var phi_5158_: f32;
    var phi_5165_: f32;
    var phi_5170_: f32;
    var phi_5177_: f32;
    var phi_5182_: f32;
    var phi_5196_: f32;
    var phi_5203_: f32;
    var phi_5208_: f32;
    var phi_5215_: f32;
    var phi_5220_: f32;
    var phi_5225_: f32;
    var phi_5333_: type_14;
    var phi_5336_: f32;
    var phi_5357_: bool;
    var phi_5363_: type_15;
    var phi_5334_: type_14;
    var phi_5377_: type_15;
    var phi_5337_: f32;
    var local_44: f32;
    var phi_5326_: f32;
    var phi_5390_: f32;
    var phi_5524_: f32;
    var phi_5530_: f32;
    var phi_5539_: f32;
    var phi_5545_: f32;
    var phi_5554_: f32;
    var phi_5560_: f32;
    var phi_5569_: f32;
    var phi_5575_: f32;
    var phi_5625_: type_14;
    var phi_5628_: f32;
    var phi_5649_: bool;
    var phi_5655_: type_15;
    var phi_5626_: type_14;
    var phi_5669_: type_15;
    var phi_5629_: f32;
    var local_45: f32;
    var phi_5618_: f32;
    var phi_5682_: f32;
    var phi_5714_: type_14;
    var phi_5717_: f32;
    var phi_5738_: bool;
    var phi_5744_: type_15;
    var phi_5715_: type_14;
    var phi_5758_: type_15;
    var phi_5718_: f32;
    var local_46: f32;
    var phi_5707_: f32;
    var phi_5771_: f32;
    var phi_5787_: f32;
    var phi_5794_: f32;
    var phi_5799_: f32;
    var phi_5806_: f32;
    var phi_5811_: f32;
    var phi_5824_: f32;
    var phi_5831_: f32;
    var phi_5836_: f32;
    var phi_5843_: f32;
    var phi_5848_: f32;
    var phi_5853_: f32;
    var phi_5870_: f32;
    var phi_5877_: f32;
    var phi_5882_: f32;
    var phi_5889_: f32;
    var phi_5894_: f32;
    var phi_5908_: f32;
    var phi_5915_: f32;
    var phi_5920_: f32;
    var phi_5927_: f32;
    var phi_5932_: f32;
    var phi_5937_: f32;
    var phi_5954_: f32;
    var phi_5961_: f32;
    var phi_5966_: f32;
    var phi_5973_: f32;
    var phi_5978_: f32;
    var phi_5992_: f32;
    var phi_5999_: f32;
    var phi_6004_: f32;
    var phi_6011_: f32;
    var phi_6016_: f32;
    var phi_6021_: f32;
    var phi_6062_: f32;
    var phi_6068_: f32;
    var phi_6079_: type_12;
    var phi_6082_: f32;
    var phi_6080_: type_12;
    var phi_6105_: type_12;
    var phi_6134_: f32;
    var phi_6140_: f32;
    var phi_6153_: f32;
    var phi_6083_: f32;
    var local_47: f32;
    var local_48: f32;
    var phi_6181_: type_14;
    var phi_6184_: f32;
    var phi_6205_: bool;
    var phi_6211_: type_15;
    var phi_6182_: type_14;
    var phi_6225_: type_15;
    var phi_6185_: f32;
    var local_49: f32;
    var phi_6174_: f32;
    var phi_6238_: f32;
    var phi_6243_: type_12;
    var phi_6246_: f32;
    var phi_6248_: bool;
    var phi_6250_: bool;
    var phi_6244_: type_12;
    var phi_6273_: type_12;
    var phi_6310_: f32;
    var phi_6317_: f32;
    var phi_6325_: f32;
    var phi_6333_: f32;
    var phi_6340_: f32;
    var phi_6348_: f32;
    var phi_6354_: f32;
    var phi_6372_: f32;
    var phi_6378_: f32;
    var phi_6385_: f32;
    var phi_6411_: f32;
    var phi_6417_: f32;
    var phi_6453_: bool;
    var phi_6460_: bool;
    var phi_6473_: f32;
    var phi_6479_: f32;
    var phi_6480_: f32;
    var phi_6481_: f32;
    var phi_6247_: f32;
    var phi_6249_: bool;
    var phi_6251_: bool;
    var local_50: f32;
    var phi_6486_: f32;
    var local_51: bool;
    var local_52: bool;
    var phi_6495_: type_40;
    var phi_6496_: type_40;
    var phi_6497_: bool;
    var local_53: bool;
    var phi_6514_: f32;
    var phi_6515_: f32;
    var phi_6518_: type_12;
    var phi_6521_: f32;
    var phi_6523_: f32;
    var phi_6519_: type_12;
    var phi_6546_: type_12;
    var phi_6629_: f32;
    var phi_6630_: f32;
    var phi_6631_: f32;
    var phi_6614_: f32;
    var phi_6632_: f32;
    var phi_6633_: f32;
    var phi_6522_: f32;
    var phi_6524_: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var phi_6794_: bool;
    var phi_6795_: bool;
    var phi_6796_: bool;
    var phi_6797_: bool;
    var phi_6798_: bool;
    var phi_6799_: bool;
    var phi_6803_: bool;
    var phi_6807_: bool;
    var phi_6808_: bool;
    var phi_6809_: bool;
    var phi_6813_: f32;
    var phi_6816_: type_40;
    var phi_6817_: type_40;
    var phi_6818_: bool;
    var phi_6819_: type_40;
    var phi_6820_: type_40;
    var phi_6821_: bool;
    var phi_6826_: type_40;
    var phi_6827_: type_40;
    var phi_6828_: bool;
    var phi_6832_: type_40;
    var phi_6833_: type_40;
    var phi_6834_: bool;
    var phi_6835_: bool;
    var phi_6836_: type_40;
    var phi_6837_: type_40;
    var phi_6838_: bool;
    var phi_6839_: bool;
    var phi_6844_: type_40;
    var phi_6845_: bool;
    var phi_6849_: type_40;
    var phi_6865_: f32;
    var phi_6866_: f32;
    var phi_6867_: bool;
    var phi_6868_: f32;
    var phi_6869_: f32;
    var phi_6870_: bool;
    var phi_6871_: bool;
    var phi_6872_: bool;
    var phi_6873_: f32;
    var phi_6874_: f32;
    var phi_6875_: bool;
    var phi_6876_: bool;
    var phi_6877_: bool;
    var phi_6878_: f32;
    var phi_6879_: u32;
    var phi_6880_: f32;
    var phi_6881_: type_40;
    var phi_6882_: u32;
    var phi_6883_: u32;
    var phi_6884_: bool;
    var phi_6885_: bool;
    var phi_6886_: bool;
    var phi_6887_: f32;
    var phi_6888_: u32;
    var phi_6889_: f32;
    var phi_6890_: type_40;
    var phi_6891_: u32;
    var phi_6892_: u32;
    var phi_6893_: bool;
    var phi_6894_: bool;
    var phi_6895_: bool;
    var phi_6896_: bool;
    var phi_6897_: bool;
    var phi_6898_: f32;
    var phi_1973_: f32;
    var phi_1975_: u32;
    var phi_1977_: f32;
    var phi_6899_: type_40;
    var phi_6900_: u32;
    var phi_6901_: f32;
    var phi_6902_: u32;
    var phi_6903_: bool;
    var phi_6904_: bool;
    var phi_6905_: bool;
    var phi_6906_: bool;
    var phi_6907_: bool;
    var phi_6908_: bool;
    var local_57: bool;
    var phi_6912_: bool;
    var phi_6913_: bool;
    var phi_6914_: bool;
    var phi_6915_: bool;
    var local_58: type_40;
    var local_59: type_40;
    var phi_6932_: u32;
    var local_60: type_40;
    var phi_6937_: type_39;
    var phi_6938_: type_39;
    var phi_6939_: bool;
    var phi_6940_: bool;
    var phi_6941_: bool;
    var phi_6942_: bool;
    var phi_6946_: u32;
    var phi_6947_: f32;
    var phi_6948_: bool;
    var phi_6949_: bool;
    var phi_6950_: bool;
    var phi_6951_: bool;
    var phi_6955_: f32;
    var phi_6956_: u32;
    var phi_6957_: bool;
    var phi_6958_: bool;
    var phi_6959_: bool;
    var phi_6971_: f32;
    var phi_6974_: type_12;
    var phi_6975_: type_12;
    var phi_6998_: type_12;
    var phi_7019_: f32;
    var phi_7149_: type_14;
    var phi_7152_: f32;
    var phi_7173_: bool;
    var phi_7179_: type_15;
    var phi_7150_: type_14;
    var phi_7193_: type_15;
    var phi_7153_: f32;
    var local_61: f32;
    var phi_7142_: f32;
    var phi_7206_: f32;
    var phi_7222_: f32;
    var phi_7229_: f32;
    var phi_7234_: f32;
    var phi_7241_: f32;
    var phi_7246_: f32;
    var phi_7259_: f32;
    var phi_7266_: f32;
    var phi_7271_: f32;
    var phi_7278_: f32;
    var phi_7283_: f32;
    var phi_7288_: f32;
    var phi_7305_: f32;
    var phi_7312_: f32;
    var phi_7317_: f32;
    var phi_7324_: f32;
    var phi_7329_: f32;
    var phi_7343_: f32;
    var phi_7350_: f32;
    var phi_7355_: f32;
    var phi_7362_: f32;
    var phi_7367_: f32;
    var phi_7372_: f32;
    var phi_7389_: f32;
    var phi_7396_: f32;
    var phi_7401_: f32;
    var phi_7408_: f32;
    var phi_7413_: f32;
    var phi_7427_: f32;
    var phi_7434_: f32;
    var phi_7439_: f32;
    var phi_7446_: f32;
    var phi_7451_: f32;
    var phi_7456_: f32;
    var phi_7476_: bool;
    var phi_7477_: bool;
    var phi_7478_: bool;
    var local_62: bool;
    var phi_7486_: u32;
    var phi_7490_: type_39;
    var phi_7491_: bool;
    var phi_7499_: u32;
    var phi_7503_: type_39;
    var phi_7504_: type_39;
    var phi_7505_: bool;
    var phi_7506_: bool;
    var phi_7513_: type_39;
    var phi_7514_: bool;
    var phi_7518_: type_39;
    var phi_7519_: type_39;
    var phi_7520_: bool;
    var phi_7524_: type_39;
    var phi_15039_: type_39;
    var phi_15054_: type_42;
    var phi_15076_: array<u32, 2>;
    var phi_15077_: array<u32, 2>;
    var phi_15078_: bool;
    var phi_15082_: array<u32, 2>;
    var phi_15109_: array<u32, 2>;
    var phi_15110_: array<u32, 2>;
    var phi_15111_: bool;
    var phi_15115_: array<u32, 2>;
    var phi_15118_: bool;
    var phi_15133_: bool;
    var phi_15134_: bool;
    var phi_15142_: bool;
    var phi_15143_: bool;
    var phi_15148_: u32;
    var phi_15156_: bool;
    var phi_15177_: u32;
    var phi_15181_: type_20;
    var phi_15182_: bool;
    var phi_15183_: bool;
    var phi_15202_: u32;
    var phi_15269_: u32;
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
        phi_251_ = _e141;
    } else {
        phi_251_ = _e143;
    }
    let _e146 = phi_251_;
    let _e147 = (_e146 / 64u);
    if ((_e146 % 64u) > 0u) {
        phi_267_ = (_e147 + 1u);
    } else {
        phi_267_ = _e147;
    }
    let _e152 = phi_267_;
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
            phi_288_ = (_e156 + 1u);
        } else {
            phi_288_ = _e156;
        }
        let _e162 = phi_288_;
        phi_289_ = _e162;
    } else {
        phi_289_ = 0u;
    }
    let _e164 = phi_289_;
    phi_292_ = type_12(0u, _e164);
    loop {
        let _e167 = phi_292_;
        if (_e167.member < _e167.member_1) {
            phi_293_ = type_12((_e167.member + 1u), _e167.member_1);
            phi_316_ = type_12(1u, _e167.member);
        } else {
            phi_293_ = _e167;
            phi_316_ = type_12(0u, type_12().member_1);
        }
        let _e179 = phi_293_;
        let _e181 = phi_316_;
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
                let _e279 = params.member.member.member_12;
                let _e280 = bitcast<u32>(_e279);
                if (_e280 < 8388608u) {
                    phi_505_ = array<u32, 2>();
                    phi_506_ = true;
                } else {
                    let _e284 = ((_e280 >> bitcast<u32>(31i)) == 1u);
                    if _e284 {
                        phi_504_ = array<u32, 2>();
                    } else {
                        phi_504_ = array<u32, 2>((_e280 << bitcast<u32>(29i)), ((((_e280 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e280 & 8388607u) >> bitcast<u32>(3i))));
                    }
                    let _e298 = phi_504_;
                    phi_505_ = _e298;
                    phi_506_ = _e284;
                }
                let _e300 = phi_505_;
                let _e302 = phi_506_;
                if _e302 {
                    phi_510_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_510_ = _e300;
                }
                let _e304 = phi_510_;
                let _e308 = params.member.member.member_15[0u];
                if (_e304[0] == _e308) {
                    let _e313 = params.member.member.member_15[1u];
                    phi_524_ = (_e304[1] == _e313);
                } else {
                    phi_524_ = false;
                }
                let _e316 = phi_524_;
                let _e318 = params.member.member.member_5;
                let _e320 = params.member.member.member_11;
                let _e322 = params.member.member.member_12;
                let _e324 = params.member.member.member_13;
                let _e326 = params.member.member.member_1;
                if ((_e326 & 64u) != 0u) {
                    phi_540_ = _e316;
                } else {
                    phi_540_ = false;
                }
                let _e330 = phi_540_;
                if (_e249 < 0f) {
                    phi_546_ = -(_e249);
                } else {
                    phi_546_ = _e249;
                }
                let _e334 = phi_546_;
                if (_e250 < 0f) {
                    phi_552_ = -(_e250);
                } else {
                    phi_552_ = _e250;
                }
                let _e338 = phi_552_;
                if (_e334 > _e338) {
                    phi_557_ = _e334;
                } else {
                    phi_557_ = _e338;
                }
                let _e341 = phi_557_;
                if (_e251 < 0f) {
                    phi_563_ = -(_e251);
                } else {
                    phi_563_ = _e251;
                }
                let _e345 = phi_563_;
                if (_e341 > _e345) {
                    phi_568_ = _e341;
                } else {
                    phi_568_ = _e345;
                }
                let _e348 = phi_568_;
                if (_e253 < 0f) {
                    phi_574_ = -(_e253);
                } else {
                    phi_574_ = _e253;
                }
                let _e352 = phi_574_;
                if (_e254 < 0f) {
                    phi_580_ = -(_e254);
                } else {
                    phi_580_ = _e254;
                }
                let _e356 = phi_580_;
                if (_e352 > _e356) {
                    phi_585_ = _e352;
                } else {
                    phi_585_ = _e356;
                }
                let _e359 = phi_585_;
                if (_e255 < 0f) {
                    phi_591_ = -(_e255);
                } else {
                    phi_591_ = _e255;
                }
                let _e363 = phi_591_;
                if (_e359 > _e363) {
                    phi_596_ = _e359;
                } else {
                    phi_596_ = _e363;
                }
                let _e366 = phi_596_;
                if (_e348 > _e366) {
                    phi_601_ = _e348;
                } else {
                    phi_601_ = _e366;
                }
                let _e369 = phi_601_;
                let _e370 = (_e369 + _e276);
                if (_e258 < 0f) {
                    phi_608_ = -(_e258);
                } else {
                    phi_608_ = _e258;
                }
                let _e374 = phi_608_;
                if (_e259 < 0f) {
                    phi_614_ = -(_e259);
                } else {
                    phi_614_ = _e259;
                }
                let _e378 = phi_614_;
                if (_e374 > _e378) {
                    phi_619_ = _e374;
                } else {
                    phi_619_ = _e378;
                }
                let _e381 = phi_619_;
                if (_e260 < 0f) {
                    phi_625_ = -(_e260);
                } else {
                    phi_625_ = _e260;
                }
                let _e385 = phi_625_;
                if (_e381 > _e385) {
                    phi_630_ = _e381;
                } else {
                    phi_630_ = _e385;
                }
                let _e388 = phi_630_;
                if (_e262 < 0f) {
                    phi_636_ = -(_e262);
                } else {
                    phi_636_ = _e262;
                }
                let _e392 = phi_636_;
                if (_e263 < 0f) {
                    phi_642_ = -(_e263);
                } else {
                    phi_642_ = _e263;
                }
                let _e396 = phi_642_;
                if (_e392 > _e396) {
                    phi_647_ = _e392;
                } else {
                    phi_647_ = _e396;
                }
                let _e399 = phi_647_;
                if (_e264 < 0f) {
                    phi_653_ = -(_e264);
                } else {
                    phi_653_ = _e264;
                }
                let _e403 = phi_653_;
                if (_e399 > _e403) {
                    phi_658_ = _e399;
                } else {
                    phi_658_ = _e403;
                }
                let _e406 = phi_658_;
                if (_e388 > _e406) {
                    phi_663_ = _e388;
                } else {
                    phi_663_ = _e406;
                }
                let _e409 = phi_663_;
                let _e410 = (_e409 + _e276);
                if (_e267 < 0f) {
                    phi_670_ = -(_e267);
                } else {
                    phi_670_ = _e267;
                }
                let _e414 = phi_670_;
                if (_e268 < 0f) {
                    phi_676_ = -(_e268);
                } else {
                    phi_676_ = _e268;
                }
                let _e418 = phi_676_;
                if (_e414 > _e418) {
                    phi_681_ = _e414;
                } else {
                    phi_681_ = _e418;
                }
                let _e421 = phi_681_;
                if (_e269 < 0f) {
                    phi_687_ = -(_e269);
                } else {
                    phi_687_ = _e269;
                }
                let _e425 = phi_687_;
                if (_e421 > _e425) {
                    phi_692_ = _e421;
                } else {
                    phi_692_ = _e425;
                }
                let _e428 = phi_692_;
                if (_e271 < 0f) {
                    phi_698_ = -(_e271);
                } else {
                    phi_698_ = _e271;
                }
                let _e432 = phi_698_;
                if (_e272 < 0f) {
                    phi_704_ = -(_e272);
                } else {
                    phi_704_ = _e272;
                }
                let _e436 = phi_704_;
                if (_e432 > _e436) {
                    phi_709_ = _e432;
                } else {
                    phi_709_ = _e436;
                }
                let _e439 = phi_709_;
                if (_e273 < 0f) {
                    phi_715_ = -(_e273);
                } else {
                    phi_715_ = _e273;
                }
                let _e443 = phi_715_;
                if (_e439 > _e443) {
                    phi_720_ = _e439;
                } else {
                    phi_720_ = _e443;
                }
                let _e446 = phi_720_;
                if (_e428 > _e446) {
                    phi_725_ = _e428;
                } else {
                    phi_725_ = _e446;
                }
                let _e449 = phi_725_;
                let _e450 = (_e449 + _e276);
                if (_e370 > _e410) {
                    phi_731_ = _e370;
                } else {
                    phi_731_ = _e410;
                }
                let _e453 = phi_731_;
                if (_e453 > _e450) {
                    phi_736_ = _e453;
                } else {
                    phi_736_ = _e450;
                }
                let _e456 = phi_736_;
                if (_e456 <= 65536f) {
                    phi_743_ = (_e456 >= (1f / 65536f));
                } else {
                    phi_743_ = false;
                }
                let _e461 = phi_743_;
                if _e461 {
                    phi_814_ = type_38();
                    phi_815_ = true;
                } else {
                    if (_e456 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e456) & 2139095040u) != 2139095040u) {
                            let _e468 = (2130706432u - (bitcast<u32>(_e456) & 2139095040u));
                            if (_e468 > 8388608u) {
                                phi_767_ = _e468;
                            } else {
                                phi_767_ = 8388608u;
                            }
                            let _e471 = phi_767_;
                            let _e472 = bitcast<f32>(_e471);
                            let _e473 = (_e318 * _e472);
                            if (_e318 > 0f) {
                                if (_e473 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_778_ = _e473;
                                } else {
                                    phi_778_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e477 = phi_778_;
                                phi_779_ = _e477;
                            } else {
                                phi_779_ = _e473;
                            }
                            let _e479 = phi_779_;
                            phi_810_ = type_38(type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e249 * _e472), (_e250 * _e472), (_e251 * _e472)), array<f32, 3>((_e253 * _e472), (_e254 * _e472), (_e255 * _e472))), array<array<f32, 3>, 2>(array<f32, 3>((_e258 * _e472), (_e259 * _e472), (_e260 * _e472)), array<f32, 3>((_e262 * _e472), (_e263 * _e472), (_e264 * _e472))), array<array<f32, 3>, 2>(array<f32, 3>((_e267 * _e472), (_e268 * _e472), (_e269 * _e472)), array<f32, 3>((_e271 * _e472), (_e272 * _e472), (_e273 * _e472))), (_e276 * _e472)), _e479);
                            phi_811_ = false;
                        } else {
                            phi_810_ = type_38();
                            phi_811_ = true;
                        }
                        let _e511 = phi_810_;
                        let _e513 = phi_811_;
                        phi_812_ = _e511;
                        phi_813_ = _e513;
                    } else {
                        phi_812_ = type_38();
                        phi_813_ = true;
                    }
                    let _e515 = phi_812_;
                    let _e517 = phi_813_;
                    phi_814_ = _e515;
                    phi_815_ = _e517;
                }
                let _e519 = phi_814_;
                let _e521 = phi_815_;
                if _e521 {
                    phi_820_ = type_38(type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e249, _e250, _e251), array<f32, 3>(_e253, _e254, _e255)), array<array<f32, 3>, 2>(array<f32, 3>(_e258, _e259, _e260), array<f32, 3>(_e262, _e263, _e264)), array<array<f32, 3>, 2>(array<f32, 3>(_e267, _e268, _e269), array<f32, 3>(_e271, _e272, _e273)), _e276), _e318);
                } else {
                    phi_820_ = _e519;
                }
                let _e524 = phi_820_;
                local_18 = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e524.member.member[0][0], _e524.member.member[0][1], _e524.member.member[0][2]), array<f32, 3>(_e524.member.member[1][0], _e524.member.member[1][1], _e524.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e524.member.member_1[0][0], _e524.member.member_1[0][1], _e524.member.member_1[0][2]), array<f32, 3>(_e524.member.member_1[1][0], _e524.member.member_1[1][1], _e524.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e524.member.member_2[0][0], _e524.member.member_2[0][1], _e524.member.member_2[0][2]), array<f32, 3>(_e524.member.member_2[1][0], _e524.member.member_2[1][1], _e524.member.member_2[1][2])), _e524.member.member_3);
                if (_e524.member_1 > 0f) {
                    let _e5209 = local_18.member[0u];
                    let _e5215 = local_18.member[1u];
                    let _e5231 = local_18.member_1[0u];
                    let _e5237 = local_18.member_1[1u];
                    let _e5253 = local_18.member_2[0u];
                    let _e5259 = local_18.member_2[1u];
                    let _e5273 = function_3(array<f32, 3>((_e5209[0] + ((_e5215[0] - _e5209[0]) * _e322)), (_e5209[1] + ((_e5215[1] - _e5209[1]) * _e322)), (_e5209[2] + ((_e5215[2] - _e5209[2]) * _e322))), array<f32, 3>((_e5231[0] + ((_e5237[0] - _e5231[0]) * _e322)), (_e5231[1] + ((_e5237[1] - _e5231[1]) * _e322)), (_e5231[2] + ((_e5237[2] - _e5231[2]) * _e322))), array<f32, 3>((_e5253[0] + ((_e5259[0] - _e5253[0]) * _e322)), (_e5253[1] + ((_e5259[1] - _e5253[1]) * _e322)), (_e5253[2] + ((_e5259[2] - _e5253[2]) * _e322))), 1u);
                    let _e5284 = (((_e5273[0] * _e5273[0]) + (_e5273[1] * _e5273[1])) + (_e5273[2] * _e5273[2]));
                    if (_e5284 <= 0.000000000000000000000000000000000000011754944f) {
                        if (_e5284 > 0f) {
                            phi_987_ = (0.000000000000000000106433627f * 2f);
                        } else {
                            phi_987_ = 0f;
                        }
                        let _e5337 = phi_987_;
                        phi_1051_ = _e5337;
                    } else {
                        phi_994_ = type_14(0i, 5i);
                        phi_997_ = bitcast<f32>(((bitcast<u32>(_e5284) >> bitcast<u32>(1i)) + 532369198u));
                        loop {
                            let _e5292 = phi_994_;
                            let _e5294 = phi_997_;
                            local_39 = _e5294;
                            if (_e5292.member < _e5292.member_1) {
                                let _e5301 = (_e5292.member + 1i);
                                if ((false == (_e5301 > _e5292.member)) != false) {
                                    phi_1018_ = true;
                                } else {
                                    phi_1018_ = false;
                                }
                                let _e5306 = phi_1018_;
                                if _e5306 {
                                    phi_1024_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_1024_ = type_15(1u, _e5301);
                                }
                                let _e5311 = phi_1024_;
                                phi_995_ = type_14(_e5311.member_1, _e5292.member_1);
                                phi_1038_ = type_15(1u, _e5292.member);
                            } else {
                                phi_995_ = _e5292;
                                phi_1038_ = type_15(0u, type_15().member_1);
                            }
                            let _e5317 = phi_995_;
                            let _e5319 = phi_1038_;
                            let _e5322 = (bitcast<i32>(_e5319.member) != 0i);
                            if _e5322 {
                                phi_998_ = (0.5f * (_e5294 + (_e5284 / _e5294)));
                            } else {
                                phi_998_ = f32();
                            }
                            let _e5327 = phi_998_;
                            continue;
                            continuing {
                                phi_994_ = _e5317;
                                phi_997_ = _e5327;
                                break if !(_e5322);
                            }
                        }
                        let _e5332 = local_39;
                        phi_1051_ = (_e5332 * (1f + (8f * 0.000000059604645f)));
                    }
                    let _e5339 = phi_1051_;
                    let _e5345 = local_18.member[0u];
                    if (_e5345[0] < 0f) {
                        phi_1067_ = -(_e5345[0]);
                    } else {
                        phi_1067_ = _e5345[0];
                    }
                    let _e5352 = phi_1067_;
                    if (_e5345[1] < 0f) {
                        phi_1074_ = -(_e5345[1]);
                    } else {
                        phi_1074_ = _e5345[1];
                    }
                    let _e5356 = phi_1074_;
                    if (_e5352 > _e5356) {
                        phi_1079_ = _e5352;
                    } else {
                        phi_1079_ = _e5356;
                    }
                    let _e5359 = phi_1079_;
                    if (_e5345[2] < 0f) {
                        phi_1086_ = -(_e5345[2]);
                    } else {
                        phi_1086_ = _e5345[2];
                    }
                    let _e5363 = phi_1086_;
                    if (_e5359 > _e5363) {
                        phi_1091_ = _e5359;
                    } else {
                        phi_1091_ = _e5363;
                    }
                    let _e5366 = phi_1091_;
                    let _e5369 = local_18.member[1u];
                    if (_e5369[0] < 0f) {
                        phi_1104_ = -(_e5369[0]);
                    } else {
                        phi_1104_ = _e5369[0];
                    }
                    let _e5376 = phi_1104_;
                    if (_e5369[1] < 0f) {
                        phi_1111_ = -(_e5369[1]);
                    } else {
                        phi_1111_ = _e5369[1];
                    }
                    let _e5380 = phi_1111_;
                    if (_e5376 > _e5380) {
                        phi_1116_ = _e5376;
                    } else {
                        phi_1116_ = _e5380;
                    }
                    let _e5383 = phi_1116_;
                    if (_e5369[2] < 0f) {
                        phi_1123_ = -(_e5369[2]);
                    } else {
                        phi_1123_ = _e5369[2];
                    }
                    let _e5387 = phi_1123_;
                    if (_e5383 > _e5387) {
                        phi_1128_ = _e5383;
                    } else {
                        phi_1128_ = _e5387;
                    }
                    let _e5390 = phi_1128_;
                    if (_e5366 > _e5390) {
                        phi_1133_ = _e5366;
                    } else {
                        phi_1133_ = _e5390;
                    }
                    let _e5393 = phi_1133_;
                    let _e5395 = local_18.member_3;
                    let _e5399 = local_18.member_1[0u];
                    if (_e5399[0] < 0f) {
                        phi_1150_ = -(_e5399[0]);
                    } else {
                        phi_1150_ = _e5399[0];
                    }
                    let _e5406 = phi_1150_;
                    if (_e5399[1] < 0f) {
                        phi_1157_ = -(_e5399[1]);
                    } else {
                        phi_1157_ = _e5399[1];
                    }
                    let _e5410 = phi_1157_;
                    if (_e5406 > _e5410) {
                        phi_1162_ = _e5406;
                    } else {
                        phi_1162_ = _e5410;
                    }
                    let _e5413 = phi_1162_;
                    if (_e5399[2] < 0f) {
                        phi_1169_ = -(_e5399[2]);
                    } else {
                        phi_1169_ = _e5399[2];
                    }
                    let _e5417 = phi_1169_;
                    if (_e5413 > _e5417) {
                        phi_1174_ = _e5413;
                    } else {
                        phi_1174_ = _e5417;
                    }
                    let _e5420 = phi_1174_;
                    let _e5423 = local_18.member_1[1u];
                    if (_e5423[0] < 0f) {
                        phi_1188_ = -(_e5423[0]);
                    } else {
                        phi_1188_ = _e5423[0];
                    }
                    let _e5430 = phi_1188_;
                    if (_e5423[1] < 0f) {
                        phi_1195_ = -(_e5423[1]);
                    } else {
                        phi_1195_ = _e5423[1];
                    }
                    let _e5434 = phi_1195_;
                    if (_e5430 > _e5434) {
                        phi_1200_ = _e5430;
                    } else {
                        phi_1200_ = _e5434;
                    }
                    let _e5437 = phi_1200_;
                    if (_e5423[2] < 0f) {
                        phi_1207_ = -(_e5423[2]);
                    } else {
                        phi_1207_ = _e5423[2];
                    }
                    let _e5441 = phi_1207_;
                    if (_e5437 > _e5441) {
                        phi_1212_ = _e5437;
                    } else {
                        phi_1212_ = _e5441;
                    }
                    let _e5444 = phi_1212_;
                    if (_e5420 > _e5444) {
                        phi_1217_ = _e5420;
                    } else {
                        phi_1217_ = _e5444;
                    }
                    let _e5447 = phi_1217_;
                    let _e5449 = local_18.member_3;
                    let _e5453 = local_18.member_2[0u];
                    if (_e5453[0] < 0f) {
                        phi_1234_ = -(_e5453[0]);
                    } else {
                        phi_1234_ = _e5453[0];
                    }
                    let _e5460 = phi_1234_;
                    if (_e5453[1] < 0f) {
                        phi_1241_ = -(_e5453[1]);
                    } else {
                        phi_1241_ = _e5453[1];
                    }
                    let _e5464 = phi_1241_;
                    if (_e5460 > _e5464) {
                        phi_1246_ = _e5460;
                    } else {
                        phi_1246_ = _e5464;
                    }
                    let _e5467 = phi_1246_;
                    if (_e5453[2] < 0f) {
                        phi_1253_ = -(_e5453[2]);
                    } else {
                        phi_1253_ = _e5453[2];
                    }
                    let _e5471 = phi_1253_;
                    if (_e5467 > _e5471) {
                        phi_1258_ = _e5467;
                    } else {
                        phi_1258_ = _e5471;
                    }
                    let _e5474 = phi_1258_;
                    let _e5477 = local_18.member_2[1u];
                    if (_e5477[0] < 0f) {
                        phi_1272_ = -(_e5477[0]);
                    } else {
                        phi_1272_ = _e5477[0];
                    }
                    let _e5484 = phi_1272_;
                    if (_e5477[1] < 0f) {
                        phi_1279_ = -(_e5477[1]);
                    } else {
                        phi_1279_ = _e5477[1];
                    }
                    let _e5488 = phi_1279_;
                    if (_e5484 > _e5488) {
                        phi_1284_ = _e5484;
                    } else {
                        phi_1284_ = _e5488;
                    }
                    let _e5491 = phi_1284_;
                    if (_e5477[2] < 0f) {
                        phi_1291_ = -(_e5477[2]);
                    } else {
                        phi_1291_ = _e5477[2];
                    }
                    let _e5495 = phi_1291_;
                    if (_e5491 > _e5495) {
                        phi_1296_ = _e5491;
                    } else {
                        phi_1296_ = _e5495;
                    }
                    let _e5498 = phi_1296_;
                    if (_e5474 > _e5498) {
                        phi_1301_ = _e5474;
                    } else {
                        phi_1301_ = _e5498;
                    }
                    let _e5501 = phi_1301_;
                    let _e5503 = local_18.member_3;
                    let _e5510 = local_18.member_3;
                    let _e5517 = (((_e5339 * (1f + (0.000000059604645f * 8f))) + (((((((_e5393 + _e5395) + (_e5447 + _e5449)) + (_e5501 + _e5503)) * (0.000000059604645f * 16f)) + (_e5510 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e524.member_1);
                    if _e5517 {
                        phi_1962_ = type_39();
                        phi_1963_ = true;
                    } else {
                        let _e5520 = local_18.member_1[0u];
                        let _e5526 = local_18.member_2[0u];
                        let _e5532 = ((_e5520[1] * _e5526[2]) - (_e5520[2] * _e5526[1]));
                        let _e5535 = ((_e5520[2] * _e5526[0]) - (_e5520[0] * _e5526[2]));
                        let _e5538 = ((_e5520[0] * _e5526[1]) - (_e5520[1] * _e5526[0]));
                        let _e5541 = local_18.member_1[1u];
                        let _e5547 = local_18.member_2[1u];
                        let _e5553 = ((_e5541[1] * _e5547[2]) - (_e5541[2] * _e5547[1]));
                        let _e5556 = ((_e5541[2] * _e5547[0]) - (_e5541[0] * _e5547[2]));
                        let _e5559 = ((_e5541[0] * _e5547[1]) - (_e5541[1] * _e5547[0]));
                        let _e5562 = local_18.member_1[0u];
                        let _e5568 = local_18.member_2[1u];
                        let _e5583 = local_18.member_1[1u];
                        let _e5589 = local_18.member_2[0u];
                        let _e5602 = (((_e5562[1] * _e5568[2]) - (_e5562[2] * _e5568[1])) + ((_e5583[1] * _e5589[2]) - (_e5583[2] * _e5589[1])));
                        let _e5603 = (((_e5562[2] * _e5568[0]) - (_e5562[0] * _e5568[2])) + ((_e5583[2] * _e5589[0]) - (_e5583[0] * _e5589[2])));
                        let _e5604 = (((_e5562[0] * _e5568[1]) - (_e5562[1] * _e5568[0])) + ((_e5583[0] * _e5589[1]) - (_e5583[1] * _e5589[0])));
                        let _e5607 = local_18.member[0u];
                        let _e5618 = local_18.member[1u];
                        let _e5629 = local_18.member[0u];
                        let _e5638 = ((((_e5618[0] * _e5532) + (_e5618[1] * _e5535)) + (_e5618[2] * _e5538)) + (((_e5629[0] * _e5602) + (_e5629[1] * _e5603)) + (_e5629[2] * _e5604)));
                        let _e5641 = local_18.member[0u];
                        let _e5652 = local_18.member[1u];
                        let _e5661 = ((((_e5641[0] * _e5553) + (_e5641[1] * _e5556)) + (_e5641[2] * _e5559)) + (((_e5652[0] * _e5602) + (_e5652[1] * _e5603)) + (_e5652[2] * _e5604)));
                        let _e5664 = local_18.member[1u];
                        let _e5675 = local_18.member[0u];
                        if (_e5675[0] < 0f) {
                            phi_1562_ = -(_e5675[0]);
                        } else {
                            phi_1562_ = _e5675[0];
                        }
                        let _e5682 = phi_1562_;
                        if (_e5675[1] < 0f) {
                            phi_1569_ = -(_e5675[1]);
                        } else {
                            phi_1569_ = _e5675[1];
                        }
                        let _e5686 = phi_1569_;
                        if (_e5682 > _e5686) {
                            phi_1574_ = _e5682;
                        } else {
                            phi_1574_ = _e5686;
                        }
                        let _e5689 = phi_1574_;
                        if (_e5675[2] < 0f) {
                            phi_1581_ = -(_e5675[2]);
                        } else {
                            phi_1581_ = _e5675[2];
                        }
                        let _e5693 = phi_1581_;
                        if (_e5689 > _e5693) {
                            phi_1586_ = _e5689;
                        } else {
                            phi_1586_ = _e5693;
                        }
                        let _e5696 = phi_1586_;
                        let _e5699 = local_18.member[1u];
                        if (_e5699[0] < 0f) {
                            phi_1599_ = -(_e5699[0]);
                        } else {
                            phi_1599_ = _e5699[0];
                        }
                        let _e5706 = phi_1599_;
                        if (_e5699[1] < 0f) {
                            phi_1606_ = -(_e5699[1]);
                        } else {
                            phi_1606_ = _e5699[1];
                        }
                        let _e5710 = phi_1606_;
                        if (_e5706 > _e5710) {
                            phi_1611_ = _e5706;
                        } else {
                            phi_1611_ = _e5710;
                        }
                        let _e5713 = phi_1611_;
                        if (_e5699[2] < 0f) {
                            phi_1618_ = -(_e5699[2]);
                        } else {
                            phi_1618_ = _e5699[2];
                        }
                        let _e5717 = phi_1618_;
                        if (_e5713 > _e5717) {
                            phi_1623_ = _e5713;
                        } else {
                            phi_1623_ = _e5717;
                        }
                        let _e5720 = phi_1623_;
                        if (_e5696 > _e5720) {
                            phi_1628_ = _e5696;
                        } else {
                            phi_1628_ = _e5720;
                        }
                        let _e5723 = phi_1628_;
                        let _e5725 = local_18.member_3;
                        let _e5726 = (_e5723 + _e5725);
                        let _e5729 = local_18.member_1[0u];
                        if (_e5729[0] < 0f) {
                            phi_1645_ = -(_e5729[0]);
                        } else {
                            phi_1645_ = _e5729[0];
                        }
                        let _e5736 = phi_1645_;
                        if (_e5729[1] < 0f) {
                            phi_1652_ = -(_e5729[1]);
                        } else {
                            phi_1652_ = _e5729[1];
                        }
                        let _e5740 = phi_1652_;
                        if (_e5736 > _e5740) {
                            phi_1657_ = _e5736;
                        } else {
                            phi_1657_ = _e5740;
                        }
                        let _e5743 = phi_1657_;
                        if (_e5729[2] < 0f) {
                            phi_1664_ = -(_e5729[2]);
                        } else {
                            phi_1664_ = _e5729[2];
                        }
                        let _e5747 = phi_1664_;
                        if (_e5743 > _e5747) {
                            phi_1669_ = _e5743;
                        } else {
                            phi_1669_ = _e5747;
                        }
                        let _e5750 = phi_1669_;
                        let _e5753 = local_18.member_1[1u];
                        if (_e5753[0] < 0f) {
                            phi_1683_ = -(_e5753[0]);
                        } else {
                            phi_1683_ = _e5753[0];
                        }
                        let _e5760 = phi_1683_;
                        if (_e5753[1] < 0f) {
                            phi_1690_ = -(_e5753[1]);
                        } else {
                            phi_1690_ = _e5753[1];
                        }
                        let _e5764 = phi_1690_;
                        if (_e5760 > _e5764) {
                            phi_1695_ = _e5760;
                        } else {
                            phi_1695_ = _e5764;
                        }
                        let _e5767 = phi_1695_;
                        if (_e5753[2] < 0f) {
                            phi_1702_ = -(_e5753[2]);
                        } else {
                            phi_1702_ = _e5753[2];
                        }
                        let _e5771 = phi_1702_;
                        if (_e5767 > _e5771) {
                            phi_1707_ = _e5767;
                        } else {
                            phi_1707_ = _e5771;
                        }
                        let _e5774 = phi_1707_;
                        if (_e5750 > _e5774) {
                            phi_1712_ = _e5750;
                        } else {
                            phi_1712_ = _e5774;
                        }
                        let _e5777 = phi_1712_;
                        let _e5779 = local_18.member_3;
                        let _e5780 = (_e5777 + _e5779);
                        let _e5783 = local_18.member_2[0u];
                        if (_e5783[0] < 0f) {
                            phi_1729_ = -(_e5783[0]);
                        } else {
                            phi_1729_ = _e5783[0];
                        }
                        let _e5790 = phi_1729_;
                        if (_e5783[1] < 0f) {
                            phi_1736_ = -(_e5783[1]);
                        } else {
                            phi_1736_ = _e5783[1];
                        }
                        let _e5794 = phi_1736_;
                        if (_e5790 > _e5794) {
                            phi_1741_ = _e5790;
                        } else {
                            phi_1741_ = _e5794;
                        }
                        let _e5797 = phi_1741_;
                        if (_e5783[2] < 0f) {
                            phi_1748_ = -(_e5783[2]);
                        } else {
                            phi_1748_ = _e5783[2];
                        }
                        let _e5801 = phi_1748_;
                        if (_e5797 > _e5801) {
                            phi_1753_ = _e5797;
                        } else {
                            phi_1753_ = _e5801;
                        }
                        let _e5804 = phi_1753_;
                        let _e5807 = local_18.member_2[1u];
                        if (_e5807[0] < 0f) {
                            phi_1767_ = -(_e5807[0]);
                        } else {
                            phi_1767_ = _e5807[0];
                        }
                        let _e5814 = phi_1767_;
                        if (_e5807[1] < 0f) {
                            phi_1774_ = -(_e5807[1]);
                        } else {
                            phi_1774_ = _e5807[1];
                        }
                        let _e5818 = phi_1774_;
                        if (_e5814 > _e5818) {
                            phi_1779_ = _e5814;
                        } else {
                            phi_1779_ = _e5818;
                        }
                        let _e5821 = phi_1779_;
                        if (_e5807[2] < 0f) {
                            phi_1786_ = -(_e5807[2]);
                        } else {
                            phi_1786_ = _e5807[2];
                        }
                        let _e5825 = phi_1786_;
                        if (_e5821 > _e5825) {
                            phi_1791_ = _e5821;
                        } else {
                            phi_1791_ = _e5825;
                        }
                        let _e5828 = phi_1791_;
                        if (_e5804 > _e5828) {
                            phi_1796_ = _e5804;
                        } else {
                            phi_1796_ = _e5828;
                        }
                        let _e5831 = phi_1796_;
                        let _e5833 = local_18.member_3;
                        let _e5834 = (_e5831 + _e5833);
                        let _e5836 = ((_e5780 * 8f) * _e5834);
                        let _e5843 = local_18.member_3;
                        if (_e5532 < 0f) {
                            phi_1827_ = -(_e5532);
                        } else {
                            phi_1827_ = _e5532;
                        }
                        let _e5860 = phi_1827_;
                        if (_e5535 < 0f) {
                            phi_1833_ = -(_e5535);
                        } else {
                            phi_1833_ = _e5535;
                        }
                        let _e5864 = phi_1833_;
                        if (_e5538 < 0f) {
                            phi_1840_ = -(_e5538);
                        } else {
                            phi_1840_ = _e5538;
                        }
                        let _e5869 = phi_1840_;
                        let _e5870 = ((_e5860 + _e5864) + _e5869);
                        if (_e5553 < 0f) {
                            phi_1847_ = -(_e5553);
                        } else {
                            phi_1847_ = _e5553;
                        }
                        let _e5874 = phi_1847_;
                        if (_e5556 < 0f) {
                            phi_1853_ = -(_e5556);
                        } else {
                            phi_1853_ = _e5556;
                        }
                        let _e5878 = phi_1853_;
                        if (_e5559 < 0f) {
                            phi_1860_ = -(_e5559);
                        } else {
                            phi_1860_ = _e5559;
                        }
                        let _e5883 = phi_1860_;
                        let _e5884 = ((_e5874 + _e5878) + _e5883);
                        if (_e5870 > _e5884) {
                            phi_1866_ = _e5870;
                        } else {
                            phi_1866_ = _e5884;
                        }
                        let _e5887 = phi_1866_;
                        if (_e5602 < 0f) {
                            phi_1872_ = -(_e5602);
                        } else {
                            phi_1872_ = _e5602;
                        }
                        let _e5891 = phi_1872_;
                        if (_e5603 < 0f) {
                            phi_1878_ = -(_e5603);
                        } else {
                            phi_1878_ = _e5603;
                        }
                        let _e5895 = phi_1878_;
                        if (_e5604 < 0f) {
                            phi_1885_ = -(_e5604);
                        } else {
                            phi_1885_ = _e5604;
                        }
                        let _e5900 = phi_1885_;
                        let _e5902 = (((_e5891 + _e5895) + _e5900) * 0.5f);
                        if (_e5887 > _e5902) {
                            phi_1892_ = _e5887;
                        } else {
                            phi_1892_ = _e5902;
                        }
                        let _e5905 = phi_1892_;
                        let _e5910 = local_18.member_3;
                        let _e5923 = ((((_e5607[0] * _e5532) + (_e5607[1] * _e5535)) + (_e5607[2] * _e5538)) * 3f);
                        let _e5924 = ((((_e5664[0] * _e5553) + (_e5664[1] * _e5556)) + (_e5664[2] * _e5559)) * 3f);
                        if (_e5923 < _e5924) {
                            phi_1916_ = _e5923;
                        } else {
                            phi_1916_ = _e5924;
                        }
                        let _e5927 = phi_1916_;
                        if (_e5638 < _e5661) {
                            phi_1921_ = _e5638;
                        } else {
                            phi_1921_ = _e5661;
                        }
                        let _e5930 = phi_1921_;
                        if (_e5927 < _e5930) {
                            phi_1926_ = _e5927;
                        } else {
                            phi_1926_ = _e5930;
                        }
                        let _e5933 = phi_1926_;
                        if (_e5923 > _e5924) {
                            phi_1931_ = _e5923;
                        } else {
                            phi_1931_ = _e5924;
                        }
                        let _e5936 = phi_1931_;
                        if (_e5638 > _e5661) {
                            phi_1936_ = _e5638;
                        } else {
                            phi_1936_ = _e5661;
                        }
                        let _e5939 = phi_1936_;
                        if (_e5936 > _e5939) {
                            phi_1941_ = _e5936;
                        } else {
                            phi_1941_ = _e5939;
                        }
                        let _e5942 = phi_1941_;
                        let _e5947 = -(_e5942);
                        if (_e5933 > _e5947) {
                            phi_1951_ = _e5933;
                        } else {
                            phi_1951_ = _e5947;
                        }
                        let _e5950 = phi_1951_;
                        if ((_e5950 - ((((((_e5726 * 8f) * _e5836) * (0.000000059604645f * (524f / 64f))) + ((_e5843 * 19f) * ((_e5726 * (_e5780 + _e5834)) + (_e5780 * _e5834)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5726) * ((1f + _e5780) * (1f + _e5834))))) + ((_e524.member_1 * (((_e5905 + (_e5836 * (0.000000059604645f * 8f))) + ((_e5910 * 6f) * (_e5780 + _e5834))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5780) * (1f + _e5834))))) * (3f * 1.0001f)))) > 0f) {
                            phi_1960_ = type_39(type_30(0u, f32()), 0u);
                            phi_1961_ = false;
                        } else {
                            phi_1960_ = type_39();
                            phi_1961_ = true;
                        }
                        let _e5956 = phi_1960_;
                        let _e5958 = phi_1961_;
                        phi_1962_ = _e5956;
                        phi_1963_ = _e5958;
                    }
                    let _e5960 = phi_1962_;
                    let _e5962 = phi_1963_;
                    if _e5962 {
                        phi_1969_ = type_14(0i, 2i);
                        phi_1972_ = _e322;
                        phi_1974_ = 0u;
                        phi_1976_ = _e322;
                        loop {
                            let _e5964 = phi_1969_;
                            let _e5966 = phi_1972_;
                            let _e5968 = phi_1974_;
                            let _e5970 = phi_1976_;
                            local_96 = _e5968;
                            local_99 = _e5966;
                            local_100 = _e5968;
                            if (_e5964.member < _e5964.member_1) {
                                let _e5977 = (_e5964.member + 1i);
                                if ((false == (_e5977 > _e5964.member)) != false) {
                                    phi_1997_ = true;
                                } else {
                                    phi_1997_ = false;
                                }
                                let _e5982 = phi_1997_;
                                if _e5982 {
                                    phi_2003_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_2003_ = type_15(1u, _e5977);
                                }
                                let _e5987 = phi_2003_;
                                phi_1970_ = type_14(_e5987.member_1, _e5964.member_1);
                                phi_2017_ = type_15(1u, _e5964.member);
                            } else {
                                phi_1970_ = _e5964;
                                phi_2017_ = type_15(0u, type_15().member_1);
                            }
                            let _e5993 = phi_1970_;
                            let _e5995 = phi_2017_;
                            if (bitcast<i32>(_e5995.member) != 0i) {
                                if (_e5995.member_1 > 0i) {
                                    phi_2033_ = true;
                                } else {
                                    if _e5517 {
                                        phi_2032_ = false;
                                    } else {
                                        phi_2032_ = true;
                                    }
                                    let _e6002 = phi_2032_;
                                    phi_2033_ = _e6002;
                                }
                                let _e6004 = phi_2033_;
                                if _e6004 {
                                    let _e6007 = local_18.member[0u];
                                    let _e6013 = local_18.member_1[0u];
                                    let _e6019 = local_18.member_2[0u];
                                    let _e6023 = (_e6007[0] - _e6013[0]);
                                    let _e6024 = (_e6007[1] - _e6013[1]);
                                    let _e6025 = (_e6007[2] - _e6013[2]);
                                    let _e6034 = local_18.member[1u];
                                    let _e6040 = local_18.member_1[1u];
                                    let _e6046 = local_18.member_2[1u];
                                    let _e6050 = (_e6034[0] - _e6040[0]);
                                    let _e6051 = (_e6034[1] - _e6040[1]);
                                    let _e6052 = (_e6034[2] - _e6040[2]);
                                    let _e6061 = local_18.member[0u];
                                    if (_e6061[0] < 0f) {
                                        phi_2179_ = -(_e6061[0]);
                                    } else {
                                        phi_2179_ = _e6061[0];
                                    }
                                    let _e6068 = phi_2179_;
                                    if (_e6061[1] < 0f) {
                                        phi_2186_ = -(_e6061[1]);
                                    } else {
                                        phi_2186_ = _e6061[1];
                                    }
                                    let _e6072 = phi_2186_;
                                    if (_e6068 > _e6072) {
                                        phi_2191_ = _e6068;
                                    } else {
                                        phi_2191_ = _e6072;
                                    }
                                    let _e6075 = phi_2191_;
                                    if (_e6061[2] < 0f) {
                                        phi_2198_ = -(_e6061[2]);
                                    } else {
                                        phi_2198_ = _e6061[2];
                                    }
                                    let _e6079 = phi_2198_;
                                    if (_e6075 > _e6079) {
                                        phi_2203_ = _e6075;
                                    } else {
                                        phi_2203_ = _e6079;
                                    }
                                    let _e6082 = phi_2203_;
                                    let _e6085 = local_18.member[1u];
                                    if (_e6085[0] < 0f) {
                                        phi_2216_ = -(_e6085[0]);
                                    } else {
                                        phi_2216_ = _e6085[0];
                                    }
                                    let _e6092 = phi_2216_;
                                    if (_e6085[1] < 0f) {
                                        phi_2223_ = -(_e6085[1]);
                                    } else {
                                        phi_2223_ = _e6085[1];
                                    }
                                    let _e6096 = phi_2223_;
                                    if (_e6092 > _e6096) {
                                        phi_2228_ = _e6092;
                                    } else {
                                        phi_2228_ = _e6096;
                                    }
                                    let _e6099 = phi_2228_;
                                    if (_e6085[2] < 0f) {
                                        phi_2235_ = -(_e6085[2]);
                                    } else {
                                        phi_2235_ = _e6085[2];
                                    }
                                    let _e6103 = phi_2235_;
                                    if (_e6099 > _e6103) {
                                        phi_2240_ = _e6099;
                                    } else {
                                        phi_2240_ = _e6103;
                                    }
                                    let _e6106 = phi_2240_;
                                    if (_e6082 > _e6106) {
                                        phi_2245_ = _e6082;
                                    } else {
                                        phi_2245_ = _e6106;
                                    }
                                    let _e6109 = phi_2245_;
                                    let _e6111 = local_18.member_3;
                                    let _e6115 = local_18.member_1[0u];
                                    if (_e6115[0] < 0f) {
                                        phi_2262_ = -(_e6115[0]);
                                    } else {
                                        phi_2262_ = _e6115[0];
                                    }
                                    let _e6122 = phi_2262_;
                                    if (_e6115[1] < 0f) {
                                        phi_2269_ = -(_e6115[1]);
                                    } else {
                                        phi_2269_ = _e6115[1];
                                    }
                                    let _e6126 = phi_2269_;
                                    if (_e6122 > _e6126) {
                                        phi_2274_ = _e6122;
                                    } else {
                                        phi_2274_ = _e6126;
                                    }
                                    let _e6129 = phi_2274_;
                                    if (_e6115[2] < 0f) {
                                        phi_2281_ = -(_e6115[2]);
                                    } else {
                                        phi_2281_ = _e6115[2];
                                    }
                                    let _e6133 = phi_2281_;
                                    if (_e6129 > _e6133) {
                                        phi_2286_ = _e6129;
                                    } else {
                                        phi_2286_ = _e6133;
                                    }
                                    let _e6136 = phi_2286_;
                                    let _e6139 = local_18.member_1[1u];
                                    if (_e6139[0] < 0f) {
                                        phi_2300_ = -(_e6139[0]);
                                    } else {
                                        phi_2300_ = _e6139[0];
                                    }
                                    let _e6146 = phi_2300_;
                                    if (_e6139[1] < 0f) {
                                        phi_2307_ = -(_e6139[1]);
                                    } else {
                                        phi_2307_ = _e6139[1];
                                    }
                                    let _e6150 = phi_2307_;
                                    if (_e6146 > _e6150) {
                                        phi_2312_ = _e6146;
                                    } else {
                                        phi_2312_ = _e6150;
                                    }
                                    let _e6153 = phi_2312_;
                                    if (_e6139[2] < 0f) {
                                        phi_2319_ = -(_e6139[2]);
                                    } else {
                                        phi_2319_ = _e6139[2];
                                    }
                                    let _e6157 = phi_2319_;
                                    if (_e6153 > _e6157) {
                                        phi_2324_ = _e6153;
                                    } else {
                                        phi_2324_ = _e6157;
                                    }
                                    let _e6160 = phi_2324_;
                                    if (_e6136 > _e6160) {
                                        phi_2329_ = _e6136;
                                    } else {
                                        phi_2329_ = _e6160;
                                    }
                                    let _e6163 = phi_2329_;
                                    let _e6165 = local_18.member_3;
                                    let _e6169 = local_18.member_2[0u];
                                    if (_e6169[0] < 0f) {
                                        phi_2346_ = -(_e6169[0]);
                                    } else {
                                        phi_2346_ = _e6169[0];
                                    }
                                    let _e6176 = phi_2346_;
                                    if (_e6169[1] < 0f) {
                                        phi_2353_ = -(_e6169[1]);
                                    } else {
                                        phi_2353_ = _e6169[1];
                                    }
                                    let _e6180 = phi_2353_;
                                    if (_e6176 > _e6180) {
                                        phi_2358_ = _e6176;
                                    } else {
                                        phi_2358_ = _e6180;
                                    }
                                    let _e6183 = phi_2358_;
                                    if (_e6169[2] < 0f) {
                                        phi_2365_ = -(_e6169[2]);
                                    } else {
                                        phi_2365_ = _e6169[2];
                                    }
                                    let _e6187 = phi_2365_;
                                    if (_e6183 > _e6187) {
                                        phi_2370_ = _e6183;
                                    } else {
                                        phi_2370_ = _e6187;
                                    }
                                    let _e6190 = phi_2370_;
                                    let _e6193 = local_18.member_2[1u];
                                    if (_e6193[0] < 0f) {
                                        phi_2384_ = -(_e6193[0]);
                                    } else {
                                        phi_2384_ = _e6193[0];
                                    }
                                    let _e6200 = phi_2384_;
                                    if (_e6193[1] < 0f) {
                                        phi_2391_ = -(_e6193[1]);
                                    } else {
                                        phi_2391_ = _e6193[1];
                                    }
                                    let _e6204 = phi_2391_;
                                    if (_e6200 > _e6204) {
                                        phi_2396_ = _e6200;
                                    } else {
                                        phi_2396_ = _e6204;
                                    }
                                    let _e6207 = phi_2396_;
                                    if (_e6193[2] < 0f) {
                                        phi_2403_ = -(_e6193[2]);
                                    } else {
                                        phi_2403_ = _e6193[2];
                                    }
                                    let _e6211 = phi_2403_;
                                    if (_e6207 > _e6211) {
                                        phi_2408_ = _e6207;
                                    } else {
                                        phi_2408_ = _e6211;
                                    }
                                    let _e6214 = phi_2408_;
                                    if (_e6190 > _e6214) {
                                        phi_2413_ = _e6190;
                                    } else {
                                        phi_2413_ = _e6214;
                                    }
                                    let _e6217 = phi_2413_;
                                    let _e6219 = local_18.member_3;
                                    let _e6226 = local_18.member_3;
                                    let _e6231 = (_e320 * 0.00390625f);
                                    local_16 = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_2454_ = type_12(0u, 96u);
                                    phi_2457_ = _e5970;
                                    phi_2459_ = _e5970;
                                    phi_2461_ = (_e324 - _e5970);
                                    phi_2463_ = _e5970;
                                    phi_2465_ = false;
                                    phi_2467_ = 0u;
                                    loop {
                                        let _e6234 = phi_2454_;
                                        let _e6236 = phi_2457_;
                                        let _e6238 = phi_2459_;
                                        let _e6240 = phi_2461_;
                                        let _e6242 = phi_2463_;
                                        let _e6244 = phi_2465_;
                                        let _e6246 = phi_2467_;
                                        local_43 = _e6236;
                                        local_86 = _e6238;
                                        if (_e6234.member < _e6234.member_1) {
                                            phi_2455_ = type_12((_e6234.member + 1u), _e6234.member_1);
                                            phi_2490_ = type_12(1u, _e6234.member);
                                        } else {
                                            phi_2455_ = _e6234;
                                            phi_2490_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6258 = phi_2455_;
                                        let _e6260 = phi_2490_;
                                        if (bitcast<i32>(_e6260.member) != 0i) {
                                            let _e6266 = local_18.member[0u];
                                            let _e6272 = local_18.member[1u];
                                            let _e6288 = local_18.member_1[0u];
                                            let _e6294 = local_18.member_1[1u];
                                            let _e6310 = local_18.member_2[0u];
                                            let _e6316 = local_18.member_2[1u];
                                            let _e6330 = function_3(array<f32, 3>((_e6266[0] + ((_e6272[0] - _e6266[0]) * _e6236)), (_e6266[1] + ((_e6272[1] - _e6266[1]) * _e6236)), (_e6266[2] + ((_e6272[2] - _e6266[2]) * _e6236))), array<f32, 3>((_e6288[0] + ((_e6294[0] - _e6288[0]) * _e6236)), (_e6288[1] + ((_e6294[1] - _e6288[1]) * _e6236)), (_e6288[2] + ((_e6294[2] - _e6288[2]) * _e6236))), array<f32, 3>((_e6310[0] + ((_e6316[0] - _e6310[0]) * _e6236)), (_e6310[1] + ((_e6316[1] - _e6310[1]) * _e6236)), (_e6310[2] + ((_e6316[2] - _e6310[2]) * _e6236))), 1u);
                                            if (_e6246 == 0u) {
                                                phi_2618_ = _e6330;
                                            } else {
                                                if (_e6246 == 1u) {
                                                    phi_2604_ = _e6330[0];
                                                } else {
                                                    phi_2604_ = 0f;
                                                }
                                                let _e6335 = phi_2604_;
                                                if (_e6246 == 2u) {
                                                    phi_2610_ = _e6330[1];
                                                } else {
                                                    phi_2610_ = 0f;
                                                }
                                                let _e6339 = phi_2610_;
                                                if (_e6246 == 3u) {
                                                    phi_2616_ = _e6330[2];
                                                } else {
                                                    phi_2616_ = 0f;
                                                }
                                                let _e6343 = phi_2616_;
                                                phi_2618_ = array<f32, 3>(_e6335, _e6339, _e6343);
                                            }
                                            let _e6346 = phi_2618_;
                                            if (_e6346[0] < 0f) {
                                                phi_2625_ = -(_e6346[0]);
                                            } else {
                                                phi_2625_ = _e6346[0];
                                            }
                                            let _e6351 = phi_2625_;
                                            if (_e6346[1] < 0f) {
                                                phi_2632_ = -(_e6346[1]);
                                            } else {
                                                phi_2632_ = _e6346[1];
                                            }
                                            let _e6356 = phi_2632_;
                                            if (_e6346[2] < 0f) {
                                                phi_2640_ = -(_e6346[2]);
                                            } else {
                                                phi_2640_ = _e6346[2];
                                            }
                                            let _e6362 = phi_2640_;
                                            let _e6363 = ((_e6351 + _e6356) + _e6362);
                                            if (_e6363 > 0f) {
                                                if ((bitcast<u32>(_e6363) & 2139095040u) != 2139095040u) {
                                                    let _e6368 = (1f / _e6363);
                                                    let _e6370 = (_e6346[0] * _e6368);
                                                    let _e6372 = (_e6346[1] * _e6368);
                                                    let _e6374 = (_e6346[2] * _e6368);
                                                    let _e6379 = (((_e6370 * _e6370) + (_e6372 * _e6372)) + (_e6374 * _e6374));
                                                    if (_e6379 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e6379 > 0f) {
                                                            phi_2677_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_2677_ = 0f;
                                                        }
                                                        let _e6432 = phi_2677_;
                                                        phi_2741_ = _e6432;
                                                    } else {
                                                        phi_2684_ = type_14(0i, 5i);
                                                        phi_2687_ = bitcast<f32>(((bitcast<u32>(_e6379) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e6387 = phi_2684_;
                                                            let _e6389 = phi_2687_;
                                                            local_40 = _e6389;
                                                            if (_e6387.member < _e6387.member_1) {
                                                                let _e6396 = (_e6387.member + 1i);
                                                                if ((false == (_e6396 > _e6387.member)) != false) {
                                                                    phi_2708_ = true;
                                                                } else {
                                                                    phi_2708_ = false;
                                                                }
                                                                let _e6401 = phi_2708_;
                                                                if _e6401 {
                                                                    phi_2714_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_2714_ = type_15(1u, _e6396);
                                                                }
                                                                let _e6406 = phi_2714_;
                                                                phi_2685_ = type_14(_e6406.member_1, _e6387.member_1);
                                                                phi_2728_ = type_15(1u, _e6387.member);
                                                            } else {
                                                                phi_2685_ = _e6387;
                                                                phi_2728_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e6412 = phi_2685_;
                                                            let _e6414 = phi_2728_;
                                                            let _e6417 = (bitcast<i32>(_e6414.member) != 0i);
                                                            if _e6417 {
                                                                phi_2688_ = (0.5f * (_e6389 + (_e6379 / _e6389)));
                                                            } else {
                                                                phi_2688_ = f32();
                                                            }
                                                            let _e6422 = phi_2688_;
                                                            continue;
                                                            continuing {
                                                                phi_2684_ = _e6412;
                                                                phi_2687_ = _e6422;
                                                                break if !(_e6417);
                                                            }
                                                        }
                                                        let _e6427 = local_40;
                                                        phi_2741_ = (_e6427 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e6434 = phi_2741_;
                                                    let _e6435 = (0.000000059604645f * 12f);
                                                    let _e6440 = ((((((((_e6109 + _e6111) + (_e6163 + _e6165)) + (_e6217 + _e6219)) * (0.000000059604645f * 16f)) + (_e6226 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e524.member_1 * _e6434) * (1f + _e6435)));
                                                    let _e6445 = (((_e6370 * _e6007[0]) + (_e6372 * _e6007[1])) + (_e6374 * _e6007[2]));
                                                    let _e6450 = (((_e6370 * _e6023) + (_e6372 * _e6024)) + (_e6374 * _e6025));
                                                    let _e6455 = (((_e6370 * (_e6007[0] - _e6019[0])) + (_e6372 * (_e6007[1] - _e6019[1]))) + (_e6374 * (_e6007[2] - _e6019[2])));
                                                    let _e6460 = (((_e6370 * (_e6023 - _e6019[0])) + (_e6372 * (_e6024 - _e6019[1]))) + (_e6374 * (_e6025 - _e6019[2])));
                                                    let _e6466 = (((_e6370 * _e6034[0]) + (_e6372 * _e6034[1])) + (_e6374 * _e6034[2]));
                                                    let _e6471 = (((_e6370 * _e6050) + (_e6372 * _e6051)) + (_e6374 * _e6052));
                                                    let _e6476 = (((_e6370 * (_e6034[0] - _e6046[0])) + (_e6372 * (_e6034[1] - _e6046[1]))) + (_e6374 * (_e6034[2] - _e6046[2])));
                                                    let _e6481 = (((_e6370 * (_e6050 - _e6046[0])) + (_e6372 * (_e6051 - _e6046[1]))) + (_e6374 * (_e6052 - _e6046[2])));
                                                    if (_e6445 < 0f) {
                                                        phi_2807_ = -(_e6445);
                                                    } else {
                                                        phi_2807_ = _e6445;
                                                    }
                                                    let _e6486 = phi_2807_;
                                                    if (_e6466 < 0f) {
                                                        phi_2813_ = -(_e6466);
                                                    } else {
                                                        phi_2813_ = _e6466;
                                                    }
                                                    let _e6490 = phi_2813_;
                                                    if (_e6450 < 0f) {
                                                        phi_2822_ = -(_e6450);
                                                    } else {
                                                        phi_2822_ = _e6450;
                                                    }
                                                    let _e6497 = phi_2822_;
                                                    if (_e6471 < 0f) {
                                                        phi_2828_ = -(_e6471);
                                                    } else {
                                                        phi_2828_ = _e6471;
                                                    }
                                                    let _e6501 = phi_2828_;
                                                    if (_e6455 < 0f) {
                                                        phi_2837_ = -(_e6455);
                                                    } else {
                                                        phi_2837_ = _e6455;
                                                    }
                                                    let _e6508 = phi_2837_;
                                                    if (_e6476 < 0f) {
                                                        phi_2843_ = -(_e6476);
                                                    } else {
                                                        phi_2843_ = _e6476;
                                                    }
                                                    let _e6512 = phi_2843_;
                                                    if (_e6460 < 0f) {
                                                        phi_2852_ = -(_e6460);
                                                    } else {
                                                        phi_2852_ = _e6460;
                                                    }
                                                    let _e6519 = phi_2852_;
                                                    if (_e6481 < 0f) {
                                                        phi_2858_ = -(_e6481);
                                                    } else {
                                                        phi_2858_ = _e6481;
                                                    }
                                                    let _e6523 = phi_2858_;
                                                    phi_2864_ = type_32(array<f32, 4>(_e6445, _e6450, _e6455, _e6460), array<f32, 4>(_e6466, _e6471, _e6476, _e6481), array<f32, 4>((_e6440 + ((_e6486 + _e6490) * _e6435)), (_e6440 + ((_e6497 + _e6501) * _e6435)), (_e6440 + ((_e6508 + _e6512) * _e6435)), (_e6440 + ((_e6519 + _e6523) * _e6435))));
                                                    phi_2865_ = false;
                                                } else {
                                                    phi_2864_ = type_32();
                                                    phi_2865_ = true;
                                                }
                                                let _e6530 = phi_2864_;
                                                let _e6532 = phi_2865_;
                                                phi_2866_ = _e6530;
                                                phi_2867_ = _e6532;
                                            } else {
                                                phi_2866_ = type_32();
                                                phi_2867_ = true;
                                            }
                                            let _e6534 = phi_2866_;
                                            let _e6536 = phi_2867_;
                                            if _e6536 {
                                                phi_2875_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_2875_ = _e6534;
                                            }
                                            let _e6538 = phi_2875_;
                                            local_17 = type_32(array<f32, 4>(_e6538.member[0], _e6538.member[1], _e6538.member[2], _e6538.member[3]), array<f32, 4>(_e6538.member_1[0], _e6538.member_1[1], _e6538.member_1[2], _e6538.member_1[3]), array<f32, 4>(_e6538.member_2[0], _e6538.member_2[1], _e6538.member_2[2], _e6538.member_2[3]));
                                            let _e6558 = (_e6236 - _e6242);
                                            let _e6562 = local_17.member[0u];
                                            let _e6565 = local_17.member_1[0u];
                                            let _e6568 = local_17.member[0u];
                                            let _e6574 = local_17.member_2[0u];
                                            if (((_e6562 + ((_e6565 - _e6568) * _e6236)) - _e6574) > 0f) {
                                                let _e6579 = local_17.member[1u];
                                                let _e6582 = local_17.member_1[1u];
                                                let _e6585 = local_17.member[1u];
                                                let _e6591 = local_17.member_2[1u];
                                                if (((_e6579 + ((_e6582 - _e6585) * _e6236)) - _e6591) > 0f) {
                                                    let _e6596 = local_17.member[2u];
                                                    let _e6599 = local_17.member_1[2u];
                                                    let _e6602 = local_17.member[2u];
                                                    let _e6608 = local_17.member_2[2u];
                                                    if (((_e6596 + ((_e6599 - _e6602) * _e6236)) - _e6608) > 0f) {
                                                        let _e6613 = local_17.member[3u];
                                                        let _e6616 = local_17.member_1[3u];
                                                        let _e6619 = local_17.member[3u];
                                                        let _e6625 = local_17.member_2[3u];
                                                        phi_3046_ = (((_e6613 + ((_e6616 - _e6619) * _e6236)) - _e6625) > 0f);
                                                        phi_3047_ = false;
                                                    } else {
                                                        phi_3046_ = bool();
                                                        phi_3047_ = true;
                                                    }
                                                    let _e6629 = phi_3046_;
                                                    let _e6631 = phi_3047_;
                                                    phi_3048_ = _e6629;
                                                    phi_3049_ = _e6631;
                                                } else {
                                                    phi_3048_ = bool();
                                                    phi_3049_ = true;
                                                }
                                                let _e6633 = phi_3048_;
                                                let _e6635 = phi_3049_;
                                                phi_3050_ = _e6633;
                                                phi_3051_ = _e6635;
                                            } else {
                                                phi_3050_ = bool();
                                                phi_3051_ = true;
                                            }
                                            let _e6637 = phi_3050_;
                                            let _e6639 = phi_3051_;
                                            if _e6639 {
                                                phi_3055_ = false;
                                            } else {
                                                phi_3055_ = _e6637;
                                            }
                                            let _e6641 = phi_3055_;
                                            if _e6641 {
                                                if (_e6236 <= _e6238) {
                                                    phi_3365_ = true;
                                                } else {
                                                    let _e6645 = local_16.member[0u];
                                                    let _e6648 = local_16.member_1[0u];
                                                    let _e6651 = local_16.member[0u];
                                                    let _e6657 = local_16.member_2[0u];
                                                    let _e6661 = local_17.member[0u];
                                                    let _e6664 = local_17.member_1[0u];
                                                    let _e6667 = local_17.member[0u];
                                                    let _e6673 = local_17.member_2[0u];
                                                    if ((((_e6645 + ((_e6648 - _e6651) * _e6236)) - _e6657) + ((_e6661 + ((_e6664 - _e6667) * _e6242)) - _e6673)) > 0f) {
                                                        let _e6679 = local_16.member[1u];
                                                        let _e6682 = local_16.member_1[1u];
                                                        let _e6685 = local_16.member[1u];
                                                        let _e6691 = local_16.member_2[1u];
                                                        let _e6695 = local_17.member[1u];
                                                        let _e6698 = local_17.member_1[1u];
                                                        let _e6701 = local_17.member[1u];
                                                        let _e6707 = local_17.member_2[1u];
                                                        if ((((_e6679 + ((_e6682 - _e6685) * _e6236)) - _e6691) + ((_e6695 + ((_e6698 - _e6701) * _e6242)) - _e6707)) > 0f) {
                                                            let _e6713 = local_16.member[2u];
                                                            let _e6716 = local_16.member_1[2u];
                                                            let _e6719 = local_16.member[2u];
                                                            let _e6725 = local_16.member_2[2u];
                                                            let _e6729 = local_17.member[2u];
                                                            let _e6732 = local_17.member_1[2u];
                                                            let _e6735 = local_17.member[2u];
                                                            let _e6741 = local_17.member_2[2u];
                                                            if ((((_e6713 + ((_e6716 - _e6719) * _e6236)) - _e6725) + ((_e6729 + ((_e6732 - _e6735) * _e6242)) - _e6741)) > 0f) {
                                                                let _e6747 = local_16.member[3u];
                                                                let _e6750 = local_16.member_1[3u];
                                                                let _e6753 = local_16.member[3u];
                                                                let _e6759 = local_16.member_2[3u];
                                                                let _e6763 = local_17.member[3u];
                                                                let _e6766 = local_17.member_1[3u];
                                                                let _e6769 = local_17.member[3u];
                                                                let _e6775 = local_17.member_2[3u];
                                                                phi_3352_ = ((((_e6747 + ((_e6750 - _e6753) * _e6236)) - _e6759) + ((_e6763 + ((_e6766 - _e6769) * _e6242)) - _e6775)) > 0f);
                                                                phi_3353_ = false;
                                                            } else {
                                                                phi_3352_ = bool();
                                                                phi_3353_ = true;
                                                            }
                                                            let _e6780 = phi_3352_;
                                                            let _e6782 = phi_3353_;
                                                            phi_3354_ = _e6780;
                                                            phi_3355_ = _e6782;
                                                        } else {
                                                            phi_3354_ = bool();
                                                            phi_3355_ = true;
                                                        }
                                                        let _e6784 = phi_3354_;
                                                        let _e6786 = phi_3355_;
                                                        phi_3356_ = _e6784;
                                                        phi_3357_ = _e6786;
                                                    } else {
                                                        phi_3356_ = bool();
                                                        phi_3357_ = true;
                                                    }
                                                    let _e6788 = phi_3356_;
                                                    let _e6790 = phi_3357_;
                                                    if _e6790 {
                                                        phi_3361_ = false;
                                                    } else {
                                                        phi_3361_ = _e6788;
                                                    }
                                                    let _e6792 = phi_3361_;
                                                    phi_3365_ = _e6792;
                                                }
                                                let _e6794 = phi_3365_;
                                                if _e6794 {
                                                    if _e6244 {
                                                        if (_e6236 >= _e324) {
                                                            phi_3376_ = false;
                                                        } else {
                                                            phi_3376_ = true;
                                                        }
                                                        let _e6797 = phi_3376_;
                                                        phi_3377_ = _e6797;
                                                    } else {
                                                        phi_3377_ = true;
                                                    }
                                                    let _e6799 = phi_3377_;
                                                    if _e6799 {
                                                        local_16 = type_32(array<f32, 4>(_e6538.member[0], _e6538.member[1], _e6538.member[2], _e6538.member[3]), array<f32, 4>(_e6538.member_1[0], _e6538.member_1[1], _e6538.member_1[2], _e6538.member_1[3]), array<f32, 4>(_e6538.member_2[0], _e6538.member_2[1], _e6538.member_2[2], _e6538.member_2[3]));
                                                        let _e6821 = local_16.member[0u];
                                                        let _e6824 = local_16.member_1[0u];
                                                        let _e6827 = local_16.member_2[0u];
                                                        if (_e6821 > _e6827) {
                                                            if (_e6824 > _e6827) {
                                                                phi_3451_ = false;
                                                            } else {
                                                                phi_3451_ = true;
                                                            }
                                                            let _e6831 = phi_3451_;
                                                            phi_3452_ = _e6831;
                                                        } else {
                                                            phi_3452_ = true;
                                                        }
                                                        let _e6833 = phi_3452_;
                                                        if _e6833 {
                                                            let _e6834 = (_e6824 >= _e6821);
                                                            if _e6834 {
                                                                phi_3474_ = f32();
                                                                phi_3475_ = false;
                                                            } else {
                                                                if ((_e6821 - _e6824) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3472_ = (((_e6821 - _e6827) / (_e6821 - _e6824)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3473_ = false;
                                                                } else {
                                                                    phi_3472_ = f32();
                                                                    phi_3473_ = true;
                                                                }
                                                                let _e6845 = phi_3472_;
                                                                let _e6847 = phi_3473_;
                                                                phi_3474_ = _e6845;
                                                                phi_3475_ = _e6847;
                                                            }
                                                            let _e6849 = phi_3474_;
                                                            let _e6851 = phi_3475_;
                                                            phi_3476_ = _e6849;
                                                            phi_3477_ = _e6834;
                                                            phi_3478_ = _e6851;
                                                        } else {
                                                            phi_3476_ = f32();
                                                            phi_3477_ = true;
                                                            phi_3478_ = false;
                                                        }
                                                        let _e6853 = phi_3476_;
                                                        let _e6855 = phi_3477_;
                                                        let _e6857 = phi_3478_;
                                                        if _e6855 {
                                                            phi_3482_ = 2f;
                                                            phi_3483_ = true;
                                                        } else {
                                                            phi_3482_ = _e6236;
                                                            phi_3483_ = _e6857;
                                                        }
                                                        let _e6859 = phi_3482_;
                                                        let _e6861 = phi_3483_;
                                                        if _e6861 {
                                                            phi_3487_ = _e6859;
                                                        } else {
                                                            phi_3487_ = _e6853;
                                                        }
                                                        let _e6863 = phi_3487_;
                                                        let _e6866 = local_16.member[1u];
                                                        let _e6869 = local_16.member_1[1u];
                                                        let _e6872 = local_16.member_2[1u];
                                                        if (_e6866 > _e6872) {
                                                            if (_e6869 > _e6872) {
                                                                phi_3519_ = false;
                                                            } else {
                                                                phi_3519_ = true;
                                                            }
                                                            let _e6876 = phi_3519_;
                                                            phi_3520_ = _e6876;
                                                        } else {
                                                            phi_3520_ = true;
                                                        }
                                                        let _e6878 = phi_3520_;
                                                        if _e6878 {
                                                            let _e6879 = (_e6869 >= _e6866);
                                                            if _e6879 {
                                                                phi_3542_ = f32();
                                                                phi_3543_ = false;
                                                            } else {
                                                                if ((_e6866 - _e6869) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3540_ = (((_e6866 - _e6872) / (_e6866 - _e6869)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3541_ = false;
                                                                } else {
                                                                    phi_3540_ = f32();
                                                                    phi_3541_ = true;
                                                                }
                                                                let _e6890 = phi_3540_;
                                                                let _e6892 = phi_3541_;
                                                                phi_3542_ = _e6890;
                                                                phi_3543_ = _e6892;
                                                            }
                                                            let _e6894 = phi_3542_;
                                                            let _e6896 = phi_3543_;
                                                            phi_3544_ = _e6894;
                                                            phi_3545_ = _e6879;
                                                            phi_3546_ = _e6896;
                                                        } else {
                                                            phi_3544_ = f32();
                                                            phi_3545_ = true;
                                                            phi_3546_ = false;
                                                        }
                                                        let _e6898 = phi_3544_;
                                                        let _e6900 = phi_3545_;
                                                        let _e6902 = phi_3546_;
                                                        if _e6900 {
                                                            phi_3550_ = 2f;
                                                            phi_3551_ = true;
                                                        } else {
                                                            phi_3550_ = _e6236;
                                                            phi_3551_ = _e6902;
                                                        }
                                                        let _e6904 = phi_3550_;
                                                        let _e6906 = phi_3551_;
                                                        if _e6906 {
                                                            phi_3555_ = _e6904;
                                                        } else {
                                                            phi_3555_ = _e6898;
                                                        }
                                                        let _e6908 = phi_3555_;
                                                        if (_e6863 < _e6908) {
                                                            phi_3560_ = _e6863;
                                                        } else {
                                                            phi_3560_ = _e6908;
                                                        }
                                                        let _e6911 = phi_3560_;
                                                        let _e6914 = local_16.member[2u];
                                                        let _e6917 = local_16.member_1[2u];
                                                        let _e6920 = local_16.member_2[2u];
                                                        if (_e6914 > _e6920) {
                                                            if (_e6917 > _e6920) {
                                                                phi_3592_ = false;
                                                            } else {
                                                                phi_3592_ = true;
                                                            }
                                                            let _e6924 = phi_3592_;
                                                            phi_3593_ = _e6924;
                                                        } else {
                                                            phi_3593_ = true;
                                                        }
                                                        let _e6926 = phi_3593_;
                                                        if _e6926 {
                                                            let _e6927 = (_e6917 >= _e6914);
                                                            if _e6927 {
                                                                phi_3615_ = f32();
                                                                phi_3616_ = false;
                                                            } else {
                                                                if ((_e6914 - _e6917) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3613_ = (((_e6914 - _e6920) / (_e6914 - _e6917)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3614_ = false;
                                                                } else {
                                                                    phi_3613_ = f32();
                                                                    phi_3614_ = true;
                                                                }
                                                                let _e6938 = phi_3613_;
                                                                let _e6940 = phi_3614_;
                                                                phi_3615_ = _e6938;
                                                                phi_3616_ = _e6940;
                                                            }
                                                            let _e6942 = phi_3615_;
                                                            let _e6944 = phi_3616_;
                                                            phi_3617_ = _e6942;
                                                            phi_3618_ = _e6927;
                                                            phi_3619_ = _e6944;
                                                        } else {
                                                            phi_3617_ = f32();
                                                            phi_3618_ = true;
                                                            phi_3619_ = false;
                                                        }
                                                        let _e6946 = phi_3617_;
                                                        let _e6948 = phi_3618_;
                                                        let _e6950 = phi_3619_;
                                                        if _e6948 {
                                                            phi_3623_ = 2f;
                                                            phi_3624_ = true;
                                                        } else {
                                                            phi_3623_ = _e6236;
                                                            phi_3624_ = _e6950;
                                                        }
                                                        let _e6952 = phi_3623_;
                                                        let _e6954 = phi_3624_;
                                                        if _e6954 {
                                                            phi_3628_ = _e6952;
                                                        } else {
                                                            phi_3628_ = _e6946;
                                                        }
                                                        let _e6956 = phi_3628_;
                                                        let _e6959 = local_16.member[3u];
                                                        let _e6962 = local_16.member_1[3u];
                                                        let _e6965 = local_16.member_2[3u];
                                                        if (_e6959 > _e6965) {
                                                            if (_e6962 > _e6965) {
                                                                phi_3660_ = false;
                                                            } else {
                                                                phi_3660_ = true;
                                                            }
                                                            let _e6969 = phi_3660_;
                                                            phi_3661_ = _e6969;
                                                        } else {
                                                            phi_3661_ = true;
                                                        }
                                                        let _e6971 = phi_3661_;
                                                        if _e6971 {
                                                            let _e6972 = (_e6962 >= _e6959);
                                                            if _e6972 {
                                                                phi_3683_ = f32();
                                                                phi_3684_ = false;
                                                            } else {
                                                                if ((_e6959 - _e6962) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3681_ = (((_e6959 - _e6965) / (_e6959 - _e6962)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3682_ = false;
                                                                } else {
                                                                    phi_3681_ = f32();
                                                                    phi_3682_ = true;
                                                                }
                                                                let _e6983 = phi_3681_;
                                                                let _e6985 = phi_3682_;
                                                                phi_3683_ = _e6983;
                                                                phi_3684_ = _e6985;
                                                            }
                                                            let _e6987 = phi_3683_;
                                                            let _e6989 = phi_3684_;
                                                            phi_3685_ = _e6987;
                                                            phi_3686_ = _e6972;
                                                            phi_3687_ = _e6989;
                                                        } else {
                                                            phi_3685_ = f32();
                                                            phi_3686_ = true;
                                                            phi_3687_ = false;
                                                        }
                                                        let _e6991 = phi_3685_;
                                                        let _e6993 = phi_3686_;
                                                        let _e6995 = phi_3687_;
                                                        if _e6993 {
                                                            phi_3691_ = 2f;
                                                            phi_3692_ = true;
                                                        } else {
                                                            phi_3691_ = _e6236;
                                                            phi_3692_ = _e6995;
                                                        }
                                                        let _e6997 = phi_3691_;
                                                        let _e6999 = phi_3692_;
                                                        if _e6999 {
                                                            phi_3696_ = _e6997;
                                                        } else {
                                                            phi_3696_ = _e6991;
                                                        }
                                                        let _e7001 = phi_3696_;
                                                        if (_e6956 < _e7001) {
                                                            phi_3701_ = _e6956;
                                                        } else {
                                                            phi_3701_ = _e7001;
                                                        }
                                                        let _e7004 = phi_3701_;
                                                        if (_e6911 < _e7004) {
                                                            phi_3706_ = _e6911;
                                                        } else {
                                                            phi_3706_ = _e7004;
                                                        }
                                                        let _e7007 = phi_3706_;
                                                        if (_e7007 > _e6236) {
                                                            phi_3711_ = _e7007;
                                                        } else {
                                                            phi_3711_ = _e6236;
                                                        }
                                                        let _e7010 = phi_3711_;
                                                        let _e7011 = (_e7010 > _e324);
                                                        if _e7011 {
                                                            phi_4216_ = f32();
                                                            phi_4217_ = f32();
                                                            phi_4218_ = false;
                                                            phi_4219_ = false;
                                                        } else {
                                                            let _e7012 = (_e7010 - _e6236);
                                                            let _e7013 = (_e7012 <= _e6231);
                                                            let _e7015 = (_e7010 + (_e320 * 0.01f));
                                                            if (_e7015 < _e324) {
                                                                phi_3724_ = _e7015;
                                                            } else {
                                                                phi_3724_ = _e324;
                                                            }
                                                            let _e7018 = phi_3724_;
                                                            if _e7013 {
                                                                if (_e524.member_1 > 0f) {
                                                                    let _e7022 = local_18.member[0u];
                                                                    let _e7028 = local_18.member[1u];
                                                                    let _e7044 = local_18.member_1[0u];
                                                                    let _e7050 = local_18.member_1[1u];
                                                                    let _e7066 = local_18.member_2[0u];
                                                                    let _e7072 = local_18.member_2[1u];
                                                                    let _e7086 = function_3(array<f32, 3>((_e7022[0] + ((_e7028[0] - _e7022[0]) * _e7018)), (_e7022[1] + ((_e7028[1] - _e7022[1]) * _e7018)), (_e7022[2] + ((_e7028[2] - _e7022[2]) * _e7018))), array<f32, 3>((_e7044[0] + ((_e7050[0] - _e7044[0]) * _e7018)), (_e7044[1] + ((_e7050[1] - _e7044[1]) * _e7018)), (_e7044[2] + ((_e7050[2] - _e7044[2]) * _e7018))), array<f32, 3>((_e7066[0] + ((_e7072[0] - _e7066[0]) * _e7018)), (_e7066[1] + ((_e7072[1] - _e7066[1]) * _e7018)), (_e7066[2] + ((_e7072[2] - _e7066[2]) * _e7018))), 1u);
                                                                    let _e7097 = (((_e7086[0] * _e7086[0]) + (_e7086[1] * _e7086[1])) + (_e7086[2] * _e7086[2]));
                                                                    if (_e7097 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e7097 > 0f) {
                                                                            phi_3854_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_3854_ = 0f;
                                                                        }
                                                                        let _e7150 = phi_3854_;
                                                                        phi_3918_ = _e7150;
                                                                    } else {
                                                                        phi_3861_ = type_14(0i, 5i);
                                                                        phi_3864_ = bitcast<f32>(((bitcast<u32>(_e7097) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e7105 = phi_3861_;
                                                                            let _e7107 = phi_3864_;
                                                                            local_41 = _e7107;
                                                                            if (_e7105.member < _e7105.member_1) {
                                                                                let _e7114 = (_e7105.member + 1i);
                                                                                if ((false == (_e7114 > _e7105.member)) != false) {
                                                                                    phi_3885_ = true;
                                                                                } else {
                                                                                    phi_3885_ = false;
                                                                                }
                                                                                let _e7119 = phi_3885_;
                                                                                if _e7119 {
                                                                                    phi_3891_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_3891_ = type_15(1u, _e7114);
                                                                                }
                                                                                let _e7124 = phi_3891_;
                                                                                phi_3862_ = type_14(_e7124.member_1, _e7105.member_1);
                                                                                phi_3905_ = type_15(1u, _e7105.member);
                                                                            } else {
                                                                                phi_3862_ = _e7105;
                                                                                phi_3905_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e7130 = phi_3862_;
                                                                            let _e7132 = phi_3905_;
                                                                            let _e7135 = (bitcast<i32>(_e7132.member) != 0i);
                                                                            if _e7135 {
                                                                                phi_3865_ = (0.5f * (_e7107 + (_e7097 / _e7107)));
                                                                            } else {
                                                                                phi_3865_ = f32();
                                                                            }
                                                                            let _e7140 = phi_3865_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_3861_ = _e7130;
                                                                                phi_3864_ = _e7140;
                                                                                break if !(_e7135);
                                                                            }
                                                                        }
                                                                        let _e7145 = local_41;
                                                                        phi_3918_ = (_e7145 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e7152 = phi_3918_;
                                                                    let _e7158 = local_18.member[0u];
                                                                    if (_e7158[0] < 0f) {
                                                                        phi_3934_ = -(_e7158[0]);
                                                                    } else {
                                                                        phi_3934_ = _e7158[0];
                                                                    }
                                                                    let _e7165 = phi_3934_;
                                                                    if (_e7158[1] < 0f) {
                                                                        phi_3941_ = -(_e7158[1]);
                                                                    } else {
                                                                        phi_3941_ = _e7158[1];
                                                                    }
                                                                    let _e7169 = phi_3941_;
                                                                    if (_e7165 > _e7169) {
                                                                        phi_3946_ = _e7165;
                                                                    } else {
                                                                        phi_3946_ = _e7169;
                                                                    }
                                                                    let _e7172 = phi_3946_;
                                                                    if (_e7158[2] < 0f) {
                                                                        phi_3953_ = -(_e7158[2]);
                                                                    } else {
                                                                        phi_3953_ = _e7158[2];
                                                                    }
                                                                    let _e7176 = phi_3953_;
                                                                    if (_e7172 > _e7176) {
                                                                        phi_3958_ = _e7172;
                                                                    } else {
                                                                        phi_3958_ = _e7176;
                                                                    }
                                                                    let _e7179 = phi_3958_;
                                                                    let _e7182 = local_18.member[1u];
                                                                    if (_e7182[0] < 0f) {
                                                                        phi_3971_ = -(_e7182[0]);
                                                                    } else {
                                                                        phi_3971_ = _e7182[0];
                                                                    }
                                                                    let _e7189 = phi_3971_;
                                                                    if (_e7182[1] < 0f) {
                                                                        phi_3978_ = -(_e7182[1]);
                                                                    } else {
                                                                        phi_3978_ = _e7182[1];
                                                                    }
                                                                    let _e7193 = phi_3978_;
                                                                    if (_e7189 > _e7193) {
                                                                        phi_3983_ = _e7189;
                                                                    } else {
                                                                        phi_3983_ = _e7193;
                                                                    }
                                                                    let _e7196 = phi_3983_;
                                                                    if (_e7182[2] < 0f) {
                                                                        phi_3990_ = -(_e7182[2]);
                                                                    } else {
                                                                        phi_3990_ = _e7182[2];
                                                                    }
                                                                    let _e7200 = phi_3990_;
                                                                    if (_e7196 > _e7200) {
                                                                        phi_3995_ = _e7196;
                                                                    } else {
                                                                        phi_3995_ = _e7200;
                                                                    }
                                                                    let _e7203 = phi_3995_;
                                                                    if (_e7179 > _e7203) {
                                                                        phi_4000_ = _e7179;
                                                                    } else {
                                                                        phi_4000_ = _e7203;
                                                                    }
                                                                    let _e7206 = phi_4000_;
                                                                    let _e7208 = local_18.member_3;
                                                                    let _e7212 = local_18.member_1[0u];
                                                                    if (_e7212[0] < 0f) {
                                                                        phi_4017_ = -(_e7212[0]);
                                                                    } else {
                                                                        phi_4017_ = _e7212[0];
                                                                    }
                                                                    let _e7219 = phi_4017_;
                                                                    if (_e7212[1] < 0f) {
                                                                        phi_4024_ = -(_e7212[1]);
                                                                    } else {
                                                                        phi_4024_ = _e7212[1];
                                                                    }
                                                                    let _e7223 = phi_4024_;
                                                                    if (_e7219 > _e7223) {
                                                                        phi_4029_ = _e7219;
                                                                    } else {
                                                                        phi_4029_ = _e7223;
                                                                    }
                                                                    let _e7226 = phi_4029_;
                                                                    if (_e7212[2] < 0f) {
                                                                        phi_4036_ = -(_e7212[2]);
                                                                    } else {
                                                                        phi_4036_ = _e7212[2];
                                                                    }
                                                                    let _e7230 = phi_4036_;
                                                                    if (_e7226 > _e7230) {
                                                                        phi_4041_ = _e7226;
                                                                    } else {
                                                                        phi_4041_ = _e7230;
                                                                    }
                                                                    let _e7233 = phi_4041_;
                                                                    let _e7236 = local_18.member_1[1u];
                                                                    if (_e7236[0] < 0f) {
                                                                        phi_4055_ = -(_e7236[0]);
                                                                    } else {
                                                                        phi_4055_ = _e7236[0];
                                                                    }
                                                                    let _e7243 = phi_4055_;
                                                                    if (_e7236[1] < 0f) {
                                                                        phi_4062_ = -(_e7236[1]);
                                                                    } else {
                                                                        phi_4062_ = _e7236[1];
                                                                    }
                                                                    let _e7247 = phi_4062_;
                                                                    if (_e7243 > _e7247) {
                                                                        phi_4067_ = _e7243;
                                                                    } else {
                                                                        phi_4067_ = _e7247;
                                                                    }
                                                                    let _e7250 = phi_4067_;
                                                                    if (_e7236[2] < 0f) {
                                                                        phi_4074_ = -(_e7236[2]);
                                                                    } else {
                                                                        phi_4074_ = _e7236[2];
                                                                    }
                                                                    let _e7254 = phi_4074_;
                                                                    if (_e7250 > _e7254) {
                                                                        phi_4079_ = _e7250;
                                                                    } else {
                                                                        phi_4079_ = _e7254;
                                                                    }
                                                                    let _e7257 = phi_4079_;
                                                                    if (_e7233 > _e7257) {
                                                                        phi_4084_ = _e7233;
                                                                    } else {
                                                                        phi_4084_ = _e7257;
                                                                    }
                                                                    let _e7260 = phi_4084_;
                                                                    let _e7262 = local_18.member_3;
                                                                    let _e7266 = local_18.member_2[0u];
                                                                    if (_e7266[0] < 0f) {
                                                                        phi_4101_ = -(_e7266[0]);
                                                                    } else {
                                                                        phi_4101_ = _e7266[0];
                                                                    }
                                                                    let _e7273 = phi_4101_;
                                                                    if (_e7266[1] < 0f) {
                                                                        phi_4108_ = -(_e7266[1]);
                                                                    } else {
                                                                        phi_4108_ = _e7266[1];
                                                                    }
                                                                    let _e7277 = phi_4108_;
                                                                    if (_e7273 > _e7277) {
                                                                        phi_4113_ = _e7273;
                                                                    } else {
                                                                        phi_4113_ = _e7277;
                                                                    }
                                                                    let _e7280 = phi_4113_;
                                                                    if (_e7266[2] < 0f) {
                                                                        phi_4120_ = -(_e7266[2]);
                                                                    } else {
                                                                        phi_4120_ = _e7266[2];
                                                                    }
                                                                    let _e7284 = phi_4120_;
                                                                    if (_e7280 > _e7284) {
                                                                        phi_4125_ = _e7280;
                                                                    } else {
                                                                        phi_4125_ = _e7284;
                                                                    }
                                                                    let _e7287 = phi_4125_;
                                                                    let _e7290 = local_18.member_2[1u];
                                                                    if (_e7290[0] < 0f) {
                                                                        phi_4139_ = -(_e7290[0]);
                                                                    } else {
                                                                        phi_4139_ = _e7290[0];
                                                                    }
                                                                    let _e7297 = phi_4139_;
                                                                    if (_e7290[1] < 0f) {
                                                                        phi_4146_ = -(_e7290[1]);
                                                                    } else {
                                                                        phi_4146_ = _e7290[1];
                                                                    }
                                                                    let _e7301 = phi_4146_;
                                                                    if (_e7297 > _e7301) {
                                                                        phi_4151_ = _e7297;
                                                                    } else {
                                                                        phi_4151_ = _e7301;
                                                                    }
                                                                    let _e7304 = phi_4151_;
                                                                    if (_e7290[2] < 0f) {
                                                                        phi_4158_ = -(_e7290[2]);
                                                                    } else {
                                                                        phi_4158_ = _e7290[2];
                                                                    }
                                                                    let _e7308 = phi_4158_;
                                                                    if (_e7304 > _e7308) {
                                                                        phi_4163_ = _e7304;
                                                                    } else {
                                                                        phi_4163_ = _e7308;
                                                                    }
                                                                    let _e7311 = phi_4163_;
                                                                    if (_e7287 > _e7311) {
                                                                        phi_4168_ = _e7287;
                                                                    } else {
                                                                        phi_4168_ = _e7311;
                                                                    }
                                                                    let _e7314 = phi_4168_;
                                                                    let _e7316 = local_18.member_3;
                                                                    let _e7323 = local_18.member_3;
                                                                    if (((_e7152 * (1f + (0.000000059604645f * 8f))) + (((((((_e7206 + _e7208) + (_e7260 + _e7262)) + (_e7314 + _e7316)) * (0.000000059604645f * 16f)) + (_e7323 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e524.member_1) {
                                                                        phi_4188_ = false;
                                                                    } else {
                                                                        phi_4188_ = true;
                                                                    }
                                                                    let _e7332 = phi_4188_;
                                                                    phi_4189_ = _e7332;
                                                                } else {
                                                                    phi_4189_ = true;
                                                                }
                                                                let _e7334 = phi_4189_;
                                                                phi_4190_ = _e7334;
                                                            } else {
                                                                phi_4190_ = true;
                                                            }
                                                            let _e7336 = phi_4190_;
                                                            if _e7336 {
                                                                if _e6244 {
                                                                    if _e7013 {
                                                                        phi_4206_ = true;
                                                                    } else {
                                                                        if (_e7012 <= (_e6240 * 0.25f)) {
                                                                            phi_4205_ = false;
                                                                        } else {
                                                                            phi_4205_ = true;
                                                                        }
                                                                        let _e7341 = phi_4205_;
                                                                        phi_4206_ = _e7341;
                                                                    }
                                                                    let _e7343 = phi_4206_;
                                                                    if _e7343 {
                                                                        phi_4211_ = (_e6558 + _e6558);
                                                                    } else {
                                                                        phi_4211_ = 0f;
                                                                    }
                                                                    let _e7346 = phi_4211_;
                                                                    phi_4213_ = _e7346;
                                                                } else {
                                                                    phi_4213_ = (_e324 - _e6236);
                                                                }
                                                                let _e7348 = phi_4213_;
                                                                phi_4214_ = _e7348;
                                                                phi_4215_ = false;
                                                            } else {
                                                                phi_4214_ = f32();
                                                                phi_4215_ = true;
                                                            }
                                                            let _e7350 = phi_4214_;
                                                            let _e7352 = phi_4215_;
                                                            phi_4216_ = _e7350;
                                                            phi_4217_ = _e7012;
                                                            phi_4218_ = _e7336;
                                                            phi_4219_ = _e7352;
                                                        }
                                                        let _e7354 = phi_4216_;
                                                        let _e7356 = phi_4217_;
                                                        let _e7358 = phi_4218_;
                                                        let _e7360 = phi_4219_;
                                                        phi_4220_ = _e7010;
                                                        phi_4221_ = _e7354;
                                                        phi_4222_ = _e7356;
                                                        phi_4223_ = _e7010;
                                                        phi_4224_ = _e7358;
                                                        phi_4225_ = _e7011;
                                                        phi_4226_ = _e7360;
                                                        phi_4227_ = false;
                                                    } else {
                                                        phi_4220_ = f32();
                                                        phi_4221_ = f32();
                                                        phi_4222_ = f32();
                                                        phi_4223_ = f32();
                                                        phi_4224_ = false;
                                                        phi_4225_ = false;
                                                        phi_4226_ = false;
                                                        phi_4227_ = true;
                                                    }
                                                    let _e7362 = phi_4220_;
                                                    let _e7364 = phi_4221_;
                                                    let _e7366 = phi_4222_;
                                                    let _e7368 = phi_4223_;
                                                    let _e7370 = phi_4224_;
                                                    let _e7372 = phi_4225_;
                                                    let _e7374 = phi_4226_;
                                                    let _e7376 = phi_4227_;
                                                    phi_4228_ = _e7362;
                                                    phi_4229_ = _e7364;
                                                    phi_4230_ = _e7366;
                                                    phi_4231_ = _e7368;
                                                    phi_4232_ = false;
                                                    phi_4233_ = _e7370;
                                                    phi_4234_ = _e7372;
                                                    phi_4235_ = _e7374;
                                                    phi_4236_ = _e7376;
                                                } else {
                                                    phi_4228_ = f32();
                                                    phi_4229_ = f32();
                                                    phi_4230_ = f32();
                                                    phi_4231_ = f32();
                                                    phi_4232_ = true;
                                                    phi_4233_ = false;
                                                    phi_4234_ = false;
                                                    phi_4235_ = false;
                                                    phi_4236_ = false;
                                                }
                                                let _e7378 = phi_4228_;
                                                let _e7380 = phi_4229_;
                                                let _e7382 = phi_4230_;
                                                let _e7384 = phi_4231_;
                                                let _e7386 = phi_4232_;
                                                let _e7388 = phi_4233_;
                                                let _e7390 = phi_4234_;
                                                let _e7392 = phi_4235_;
                                                let _e7394 = phi_4236_;
                                                phi_4237_ = _e7378;
                                                phi_4238_ = _e7380;
                                                phi_4239_ = _e7382;
                                                phi_4240_ = _e7384;
                                                phi_4241_ = _e7386;
                                                phi_4242_ = _e7388;
                                                phi_4243_ = _e7390;
                                                phi_4244_ = _e7392;
                                                phi_4245_ = _e7394;
                                            } else {
                                                phi_4237_ = f32();
                                                phi_4238_ = f32();
                                                phi_4239_ = f32();
                                                phi_4240_ = f32();
                                                phi_4241_ = true;
                                                phi_4242_ = false;
                                                phi_4243_ = false;
                                                phi_4244_ = false;
                                                phi_4245_ = false;
                                            }
                                            let _e7396 = phi_4237_;
                                            let _e7398 = phi_4238_;
                                            let _e7400 = phi_4239_;
                                            let _e7402 = phi_4240_;
                                            let _e7404 = phi_4241_;
                                            let _e7406 = phi_4242_;
                                            let _e7408 = phi_4243_;
                                            let _e7410 = phi_4244_;
                                            let _e7412 = phi_4245_;
                                            if _e7404 {
                                                if (_e6236 <= _e6238) {
                                                    let _e7573 = (_e6246 + 1u);
                                                    let _e7574 = (_e7573 > 3u);
                                                    if _e7574 {
                                                        phi_4258_ = false;
                                                    } else {
                                                        phi_4258_ = true;
                                                    }
                                                    let _e7576 = phi_4258_;
                                                    phi_4580_ = _e7573;
                                                    phi_4581_ = f32();
                                                    phi_4582_ = false;
                                                    phi_4583_ = _e7576;
                                                    phi_4584_ = _e7574;
                                                } else {
                                                    let _e7416 = local_16.member[0u];
                                                    let _e7419 = local_16.member_1[0u];
                                                    let _e7422 = local_16.member[0u];
                                                    let _e7428 = local_16.member_2[0u];
                                                    let _e7429 = ((_e7416 + ((_e7419 - _e7422) * _e6242)) - _e7428);
                                                    let _e7432 = local_16.member[1u];
                                                    let _e7435 = local_16.member_1[1u];
                                                    let _e7438 = local_16.member[1u];
                                                    let _e7444 = local_16.member_2[1u];
                                                    let _e7445 = ((_e7432 + ((_e7435 - _e7438) * _e6242)) - _e7444);
                                                    if (_e7429 < _e7445) {
                                                        phi_4331_ = _e7429;
                                                    } else {
                                                        phi_4331_ = _e7445;
                                                    }
                                                    let _e7448 = phi_4331_;
                                                    let _e7451 = local_16.member[2u];
                                                    let _e7454 = local_16.member_1[2u];
                                                    let _e7457 = local_16.member[2u];
                                                    let _e7463 = local_16.member_2[2u];
                                                    let _e7464 = ((_e7451 + ((_e7454 - _e7457) * _e6242)) - _e7463);
                                                    let _e7467 = local_16.member[3u];
                                                    let _e7470 = local_16.member_1[3u];
                                                    let _e7473 = local_16.member[3u];
                                                    let _e7479 = local_16.member_2[3u];
                                                    let _e7480 = ((_e7467 + ((_e7470 - _e7473) * _e6242)) - _e7479);
                                                    if (_e7464 < _e7480) {
                                                        phi_4404_ = _e7464;
                                                    } else {
                                                        phi_4404_ = _e7480;
                                                    }
                                                    let _e7483 = phi_4404_;
                                                    if (_e7448 < _e7483) {
                                                        phi_4409_ = _e7448;
                                                    } else {
                                                        phi_4409_ = _e7483;
                                                    }
                                                    let _e7486 = phi_4409_;
                                                    let _e7489 = local_17.member[0u];
                                                    let _e7492 = local_17.member_1[0u];
                                                    let _e7495 = local_17.member[0u];
                                                    let _e7501 = local_17.member_2[0u];
                                                    let _e7502 = ((_e7489 + ((_e7492 - _e7495) * _e6236)) - _e7501);
                                                    let _e7505 = local_17.member[1u];
                                                    let _e7508 = local_17.member_1[1u];
                                                    let _e7511 = local_17.member[1u];
                                                    let _e7517 = local_17.member_2[1u];
                                                    let _e7518 = ((_e7505 + ((_e7508 - _e7511) * _e6236)) - _e7517);
                                                    if (_e7502 < _e7518) {
                                                        phi_4482_ = _e7502;
                                                    } else {
                                                        phi_4482_ = _e7518;
                                                    }
                                                    let _e7521 = phi_4482_;
                                                    let _e7524 = local_17.member[2u];
                                                    let _e7527 = local_17.member_1[2u];
                                                    let _e7530 = local_17.member[2u];
                                                    let _e7536 = local_17.member_2[2u];
                                                    let _e7537 = ((_e7524 + ((_e7527 - _e7530) * _e6236)) - _e7536);
                                                    let _e7540 = local_17.member[3u];
                                                    let _e7543 = local_17.member_1[3u];
                                                    let _e7546 = local_17.member[3u];
                                                    let _e7552 = local_17.member_2[3u];
                                                    let _e7553 = ((_e7540 + ((_e7543 - _e7546) * _e6236)) - _e7552);
                                                    if (_e7537 < _e7553) {
                                                        phi_4555_ = _e7537;
                                                    } else {
                                                        phi_4555_ = _e7553;
                                                    }
                                                    let _e7556 = phi_4555_;
                                                    if (_e7521 < _e7556) {
                                                        phi_4560_ = _e7521;
                                                    } else {
                                                        phi_4560_ = _e7556;
                                                    }
                                                    let _e7559 = phi_4560_;
                                                    if (_e7559 > 0f) {
                                                        phi_4578_ = 0.5f;
                                                    } else {
                                                        let _e7563 = (0.95f * (_e7486 / (_e7486 - _e7559)));
                                                        if (_e7563 > 0.0625f) {
                                                            if (_e7563 < 0.9f) {
                                                                phi_4576_ = _e7563;
                                                            } else {
                                                                phi_4576_ = 0.9f;
                                                            }
                                                            let _e7567 = phi_4576_;
                                                            phi_4577_ = _e7567;
                                                        } else {
                                                            phi_4577_ = 0.0625f;
                                                        }
                                                        let _e7569 = phi_4577_;
                                                        phi_4578_ = _e7569;
                                                    }
                                                    let _e7571 = phi_4578_;
                                                    phi_4580_ = u32();
                                                    phi_4581_ = (_e6558 * _e7571);
                                                    phi_4582_ = true;
                                                    phi_4583_ = false;
                                                    phi_4584_ = false;
                                                }
                                                let _e7578 = phi_4580_;
                                                let _e7580 = phi_4581_;
                                                let _e7582 = phi_4582_;
                                                let _e7584 = phi_4583_;
                                                let _e7586 = phi_4584_;
                                                phi_4585_ = _e7578;
                                                phi_4586_ = _e6238;
                                                phi_4587_ = _e7580;
                                                phi_4588_ = _e6240;
                                                phi_4589_ = _e6242;
                                                phi_4590_ = _e6244;
                                                phi_4591_ = _e6246;
                                                phi_4592_ = _e7582;
                                                phi_4593_ = _e7584;
                                                phi_4594_ = _e7586;
                                                phi_4595_ = false;
                                                phi_4596_ = false;
                                                phi_4597_ = false;
                                            } else {
                                                phi_4585_ = u32();
                                                phi_4586_ = _e7396;
                                                phi_4587_ = _e7398;
                                                phi_4588_ = _e7400;
                                                phi_4589_ = _e6236;
                                                phi_4590_ = true;
                                                phi_4591_ = 0u;
                                                phi_4592_ = _e7406;
                                                phi_4593_ = false;
                                                phi_4594_ = false;
                                                phi_4595_ = _e7408;
                                                phi_4596_ = _e7410;
                                                phi_4597_ = _e7412;
                                            }
                                            let _e7588 = phi_4585_;
                                            let _e7590 = phi_4586_;
                                            let _e7592 = phi_4587_;
                                            let _e7594 = phi_4588_;
                                            let _e7596 = phi_4589_;
                                            let _e7598 = phi_4590_;
                                            let _e7600 = phi_4591_;
                                            let _e7602 = phi_4592_;
                                            let _e7604 = phi_4593_;
                                            let _e7606 = phi_4594_;
                                            let _e7608 = phi_4595_;
                                            let _e7610 = phi_4596_;
                                            let _e7612 = phi_4597_;
                                            if _e7602 {
                                                let _e7613 = (_e7596 + _e7592);
                                                if (_e7613 > _e7590) {
                                                    phi_4606_ = _e7613;
                                                } else {
                                                    phi_4606_ = _e7590;
                                                }
                                                let _e7616 = phi_4606_;
                                                if (_e7616 < _e324) {
                                                    phi_4611_ = _e7616;
                                                } else {
                                                    phi_4611_ = _e324;
                                                }
                                                let _e7619 = phi_4611_;
                                                if !(_e6244) {
                                                    phi_4620_ = true;
                                                } else {
                                                    phi_4620_ = ((_e7619 - _e7596) > _e6231);
                                                }
                                                let _e7623 = phi_4620_;
                                                if _e7623 {
                                                    phi_4624_ = false;
                                                } else {
                                                    phi_4624_ = true;
                                                }
                                                let _e7625 = phi_4624_;
                                                phi_4625_ = _e7619;
                                                phi_4626_ = _e7590;
                                                phi_4627_ = _e7594;
                                                phi_4628_ = _e7596;
                                                phi_4629_ = _e7598;
                                                phi_4630_ = _e7600;
                                                phi_4631_ = _e7623;
                                                phi_4632_ = _e7625;
                                                phi_4633_ = false;
                                                phi_4634_ = false;
                                                phi_4635_ = false;
                                                phi_4636_ = false;
                                            } else {
                                                phi_4625_ = _e6236;
                                                phi_4626_ = _e6238;
                                                phi_4627_ = _e6240;
                                                phi_4628_ = _e6242;
                                                phi_4629_ = _e6244;
                                                phi_4630_ = _e7588;
                                                phi_4631_ = _e7604;
                                                phi_4632_ = false;
                                                phi_4633_ = _e7606;
                                                phi_4634_ = _e7608;
                                                phi_4635_ = _e7610;
                                                phi_4636_ = _e7612;
                                            }
                                            let _e7627 = phi_4625_;
                                            let _e7629 = phi_4626_;
                                            let _e7631 = phi_4627_;
                                            let _e7633 = phi_4628_;
                                            let _e7635 = phi_4629_;
                                            let _e7637 = phi_4630_;
                                            let _e7639 = phi_4631_;
                                            let _e7641 = phi_4632_;
                                            let _e7643 = phi_4633_;
                                            let _e7645 = phi_4634_;
                                            let _e7647 = phi_4635_;
                                            let _e7649 = phi_4636_;
                                            phi_2458_ = _e7627;
                                            phi_2460_ = _e7629;
                                            phi_2462_ = _e7631;
                                            phi_2464_ = _e7633;
                                            phi_2466_ = _e7635;
                                            phi_2468_ = _e7637;
                                            phi_4637_ = _e7590;
                                            phi_4638_ = _e7402;
                                            phi_4639_ = _e7639;
                                            phi_4640_ = _e7641;
                                            phi_4641_ = _e7643;
                                            phi_4642_ = _e7645;
                                            phi_4643_ = _e7647;
                                            phi_4644_ = false;
                                            phi_4645_ = _e7649;
                                        } else {
                                            phi_2458_ = f32();
                                            phi_2460_ = f32();
                                            phi_2462_ = f32();
                                            phi_2464_ = f32();
                                            phi_2466_ = bool();
                                            phi_2468_ = u32();
                                            phi_4637_ = f32();
                                            phi_4638_ = f32();
                                            phi_4639_ = false;
                                            phi_4640_ = false;
                                            phi_4641_ = false;
                                            phi_4642_ = false;
                                            phi_4643_ = false;
                                            phi_4644_ = true;
                                            phi_4645_ = false;
                                        }
                                        let _e7651 = phi_2458_;
                                        let _e7653 = phi_2460_;
                                        let _e7655 = phi_2462_;
                                        let _e7657 = phi_2464_;
                                        let _e7659 = phi_2466_;
                                        let _e7661 = phi_2468_;
                                        let _e7663 = phi_4637_;
                                        let _e7665 = phi_4638_;
                                        let _e7667 = phi_4639_;
                                        let _e7669 = phi_4640_;
                                        let _e7671 = phi_4641_;
                                        let _e7673 = phi_4642_;
                                        let _e7675 = phi_4643_;
                                        let _e7677 = phi_4644_;
                                        let _e7679 = phi_4645_;
                                        local_42 = _e7669;
                                        local_78 = _e7671;
                                        local_79 = _e7673;
                                        local_80 = _e7675;
                                        local_81 = _e7677;
                                        local_82 = _e7679;
                                        local_83 = _e7669;
                                        local_84 = _e7665;
                                        local_85 = _e7663;
                                        continue;
                                        continuing {
                                            phi_2454_ = _e6258;
                                            phi_2457_ = _e7651;
                                            phi_2459_ = _e7653;
                                            phi_2461_ = _e7655;
                                            phi_2463_ = _e7657;
                                            phi_2465_ = _e7659;
                                            phi_2467_ = _e7661;
                                            break if !(_e7667);
                                        }
                                    }
                                    let _e7682 = local_42;
                                    if _e7682 {
                                        phi_4649_ = false;
                                        phi_4650_ = false;
                                        phi_4651_ = false;
                                        phi_4652_ = false;
                                        phi_4653_ = false;
                                    } else {
                                        let _e11149 = local_78;
                                        phi_4649_ = _e11149;
                                        let _e11152 = local_79;
                                        phi_4650_ = _e11152;
                                        let _e11155 = local_80;
                                        phi_4651_ = _e11155;
                                        let _e11158 = local_81;
                                        phi_4652_ = _e11158;
                                        let _e11161 = local_82;
                                        phi_4653_ = _e11161;
                                    }
                                    let _e7684 = phi_4649_;
                                    let _e7686 = phi_4650_;
                                    let _e7688 = phi_4651_;
                                    let _e7690 = phi_4652_;
                                    let _e7692 = phi_4653_;
                                    if _e7684 {
                                        let _e7694 = local_43;
                                        phi_4658_ = type_30(1u, _e7694);
                                        phi_4659_ = false;
                                        phi_4660_ = false;
                                        phi_4661_ = false;
                                        phi_4662_ = false;
                                        phi_4663_ = false;
                                    } else {
                                        phi_4658_ = type_30();
                                        phi_4659_ = _e7686;
                                        phi_4660_ = _e7688;
                                        let _e11168 = local_83;
                                        phi_4661_ = _e11168;
                                        phi_4662_ = _e7690;
                                        phi_4663_ = _e7692;
                                    }
                                    let _e7697 = phi_4658_;
                                    let _e7699 = phi_4659_;
                                    let _e7701 = phi_4660_;
                                    let _e7703 = phi_4661_;
                                    let _e7705 = phi_4662_;
                                    let _e7707 = phi_4663_;
                                    if _e7699 {
                                        phi_4668_ = type_30(0u, type_30().member_1);
                                        phi_4669_ = false;
                                        phi_4670_ = false;
                                        phi_4671_ = false;
                                        phi_4672_ = false;
                                        phi_4673_ = true;
                                    } else {
                                        phi_4668_ = _e7697;
                                        phi_4669_ = _e7701;
                                        phi_4670_ = _e7703;
                                        phi_4671_ = _e7705;
                                        phi_4672_ = _e7707;
                                        phi_4673_ = _e7684;
                                    }
                                    let _e7711 = phi_4668_;
                                    let _e7713 = phi_4669_;
                                    let _e7715 = phi_4670_;
                                    let _e7717 = phi_4671_;
                                    let _e7719 = phi_4672_;
                                    let _e7721 = phi_4673_;
                                    if _e7713 {
                                        let _e11179 = local_84;
                                        phi_4677_ = _e11179;
                                        phi_4678_ = true;
                                        phi_4679_ = false;
                                        phi_4680_ = false;
                                        phi_4681_ = false;
                                    } else {
                                        let _e11181 = local_85;
                                        phi_4677_ = _e11181;
                                        phi_4678_ = _e7715;
                                        phi_4679_ = _e7717;
                                        phi_4680_ = _e7719;
                                        phi_4681_ = _e7721;
                                    }
                                    let _e7723 = phi_4677_;
                                    let _e7725 = phi_4678_;
                                    let _e7727 = phi_4679_;
                                    let _e7729 = phi_4680_;
                                    let _e7731 = phi_4681_;
                                    if _e7725 {
                                        phi_4685_ = _e7723;
                                        phi_4686_ = true;
                                        phi_4687_ = false;
                                        phi_4688_ = false;
                                    } else {
                                        let _e11188 = local_86;
                                        phi_4685_ = _e11188;
                                        phi_4686_ = _e7727;
                                        phi_4687_ = _e7729;
                                        phi_4688_ = _e7731;
                                    }
                                    let _e7733 = phi_4685_;
                                    let _e7735 = phi_4686_;
                                    let _e7737 = phi_4687_;
                                    let _e7739 = phi_4688_;
                                    if _e7735 {
                                        phi_4693_ = type_30(1u, _e7733);
                                        phi_4694_ = false;
                                        phi_4695_ = false;
                                    } else {
                                        phi_4693_ = type_30();
                                        phi_4694_ = _e7737;
                                        phi_4695_ = _e7739;
                                    }
                                    let _e7742 = phi_4693_;
                                    let _e7744 = phi_4694_;
                                    let _e7746 = phi_4695_;
                                    if _e7744 {
                                        phi_4700_ = type_30(0u, type_30().member_1);
                                        phi_4701_ = true;
                                    } else {
                                        phi_4700_ = _e7711;
                                        phi_4701_ = _e7746;
                                    }
                                    let _e7750 = phi_4700_;
                                    let _e7752 = phi_4701_;
                                    if _e7752 {
                                        phi_4705_ = _e7750;
                                    } else {
                                        phi_4705_ = _e7742;
                                    }
                                    let _e7754 = phi_4705_;
                                    phi_4712_ = _e7754.member_1;
                                    phi_4713_ = (_e7754.member != 0u);
                                } else {
                                    phi_4712_ = _e5966;
                                    phi_4713_ = true;
                                }
                                let _e7759 = phi_4712_;
                                let _e7761 = phi_4713_;
                                if _e7761 {
                                    let _e7762 = (_e7759 > _e322);
                                    if _e7762 {
                                        phi_6878_ = f32();
                                        phi_6879_ = u32();
                                        phi_6880_ = f32();
                                        phi_6881_ = type_40();
                                        phi_6882_ = u32();
                                        phi_6883_ = u32();
                                        phi_6884_ = false;
                                        phi_6885_ = false;
                                        phi_6886_ = false;
                                    } else {
                                        let _e7765 = local_18.member[0u];
                                        let _e7771 = local_18.member[1u];
                                        let _e7787 = local_18.member_1[0u];
                                        let _e7793 = local_18.member_1[1u];
                                        let _e7809 = local_18.member_2[0u];
                                        let _e7815 = local_18.member_2[1u];
                                        let _e7829 = function_3(array<f32, 3>((_e7765[0] + ((_e7771[0] - _e7765[0]) * _e5970)), (_e7765[1] + ((_e7771[1] - _e7765[1]) * _e5970)), (_e7765[2] + ((_e7771[2] - _e7765[2]) * _e5970))), array<f32, 3>((_e7787[0] + ((_e7793[0] - _e7787[0]) * _e5970)), (_e7787[1] + ((_e7793[1] - _e7787[1]) * _e5970)), (_e7787[2] + ((_e7793[2] - _e7787[2]) * _e5970))), array<f32, 3>((_e7809[0] + ((_e7815[0] - _e7809[0]) * _e5970)), (_e7809[1] + ((_e7815[1] - _e7809[1]) * _e5970)), (_e7809[2] + ((_e7815[2] - _e7809[2]) * _e5970))), 1u);
                                        if (_e7829[0] < 0f) {
                                            phi_4825_ = -(_e7829[0]);
                                        } else {
                                            phi_4825_ = _e7829[0];
                                        }
                                        let _e7834 = phi_4825_;
                                        if (_e7829[1] < 0f) {
                                            phi_4832_ = -(_e7829[1]);
                                        } else {
                                            phi_4832_ = _e7829[1];
                                        }
                                        let _e7839 = phi_4832_;
                                        if (_e7829[2] < 0f) {
                                            phi_4840_ = -(_e7829[2]);
                                        } else {
                                            phi_4840_ = _e7829[2];
                                        }
                                        let _e7845 = phi_4840_;
                                        let _e7846 = ((_e7834 + _e7839) + _e7845);
                                        let _e7849 = local_18.member[0u];
                                        let _e7855 = local_18.member_1[0u];
                                        let _e7861 = local_18.member_2[0u];
                                        let _e7865 = (_e7849[0] - _e7855[0]);
                                        let _e7866 = (_e7849[1] - _e7855[1]);
                                        let _e7867 = (_e7849[2] - _e7855[2]);
                                        let _e7876 = local_18.member[1u];
                                        let _e7882 = local_18.member_1[1u];
                                        let _e7888 = local_18.member_2[1u];
                                        let _e7892 = (_e7876[0] - _e7882[0]);
                                        let _e7893 = (_e7876[1] - _e7882[1]);
                                        let _e7894 = (_e7876[2] - _e7882[2]);
                                        let _e7903 = local_18.member[0u];
                                        if (_e7903[0] < 0f) {
                                            phi_4991_ = -(_e7903[0]);
                                        } else {
                                            phi_4991_ = _e7903[0];
                                        }
                                        let _e7910 = phi_4991_;
                                        if (_e7903[1] < 0f) {
                                            phi_4998_ = -(_e7903[1]);
                                        } else {
                                            phi_4998_ = _e7903[1];
                                        }
                                        let _e7914 = phi_4998_;
                                        if (_e7910 > _e7914) {
                                            phi_5003_ = _e7910;
                                        } else {
                                            phi_5003_ = _e7914;
                                        }
                                        let _e7917 = phi_5003_;
                                        if (_e7903[2] < 0f) {
                                            phi_5010_ = -(_e7903[2]);
                                        } else {
                                            phi_5010_ = _e7903[2];
                                        }
                                        let _e7921 = phi_5010_;
                                        if (_e7917 > _e7921) {
                                            phi_5015_ = _e7917;
                                        } else {
                                            phi_5015_ = _e7921;
                                        }
                                        let _e7924 = phi_5015_;
                                        let _e7927 = local_18.member[1u];
                                        if (_e7927[0] < 0f) {
                                            phi_5028_ = -(_e7927[0]);
                                        } else {
                                            phi_5028_ = _e7927[0];
                                        }
                                        let _e7934 = phi_5028_;
                                        if (_e7927[1] < 0f) {
                                            phi_5035_ = -(_e7927[1]);
                                        } else {
                                            phi_5035_ = _e7927[1];
                                        }
                                        let _e7938 = phi_5035_;
                                        if (_e7934 > _e7938) {
                                            phi_5040_ = _e7934;
                                        } else {
                                            phi_5040_ = _e7938;
                                        }
                                        let _e7941 = phi_5040_;
                                        if (_e7927[2] < 0f) {
                                            phi_5047_ = -(_e7927[2]);
                                        } else {
                                            phi_5047_ = _e7927[2];
                                        }
                                        let _e7945 = phi_5047_;
                                        if (_e7941 > _e7945) {
                                            phi_5052_ = _e7941;
                                        } else {
                                            phi_5052_ = _e7945;
                                        }
                                        let _e7948 = phi_5052_;
                                        if (_e7924 > _e7948) {
                                            phi_5057_ = _e7924;
                                        } else {
                                            phi_5057_ = _e7948;
                                        }
                                        let _e7951 = phi_5057_;
                                        let _e7953 = local_18.member_3;
                                        let _e7957 = local_18.member_1[0u];
                                        if (_e7957[0] < 0f) {
                                            phi_5074_ = -(_e7957[0]);
                                        } else {
                                            phi_5074_ = _e7957[0];
                                        }
                                        let _e7964 = phi_5074_;
                                        if (_e7957[1] < 0f) {
                                            phi_5081_ = -(_e7957[1]);
                                        } else {
                                            phi_5081_ = _e7957[1];
                                        }
                                        let _e7968 = phi_5081_;
                                        if (_e7964 > _e7968) {
                                            phi_5086_ = _e7964;
                                        } else {
                                            phi_5086_ = _e7968;
                                        }
                                        let _e7971 = phi_5086_;
                                        if (_e7957[2] < 0f) {
                                            phi_5093_ = -(_e7957[2]);
                                        } else {
                                            phi_5093_ = _e7957[2];
                                        }
                                        let _e7975 = phi_5093_;
                                        if (_e7971 > _e7975) {
                                            phi_5098_ = _e7971;
                                        } else {
                                            phi_5098_ = _e7975;
                                        }
                                        let _e7978 = phi_5098_;
                                        let _e7981 = local_18.member_1[1u];
                                        if (_e7981[0] < 0f) {
                                            phi_5112_ = -(_e7981[0]);
                                        } else {
                                            phi_5112_ = _e7981[0];
                                        }
                                        let _e7988 = phi_5112_;
                                        if (_e7981[1] < 0f) {
                                            phi_5119_ = -(_e7981[1]);
                                        } else {
                                            phi_5119_ = _e7981[1];
                                        }
                                        let _e7992 = phi_5119_;
                                        if (_e7988 > _e7992) {
                                            phi_5124_ = _e7988;
                                        } else {
                                            phi_5124_ = _e7992;
                                        }
                                        let _e7995 = phi_5124_;
                                        if (_e7981[2] < 0f) {
                                            phi_5131_ = -(_e7981[2]);
                                        } else {
                                            phi_5131_ = _e7981[2];
                                        }
                                        let _e7999 = phi_5131_;
                                        if (_e7995 > _e7999) {
                                            phi_5136_ = _e7995;
                                        } else {
                                            phi_5136_ = _e7999;
                                        }
                                        let _e8002 = phi_5136_;
                                        if (_e7978 > _e8002) {
                                            phi_5141_ = _e7978;
                                        } else {
                                            phi_5141_ = _e8002;
                                        }
                                        let _e8005 = phi_5141_;
                                        let _e8007 = local_18.member_3;
                                        let _e8011 = local_18.member_2[0u];
                                        if (_e8011[0] < 0f) {
                                            phi_5158_ = -(_e8011[0]);
                                        } else {
                                            phi_5158_ = _e8011[0];
                                        }
                                        let _e8018 = phi_5158_;
                                        if (_e8011[1] < 0f) {
                                            phi_5165_ = -(_e8011[1]);
                                        } else {
                                            phi_5165_ = _e8011[1];
                                        }
                                        let _e8022 = phi_5165_;
                                        if (_e8018 > _e8022) {
                                            phi_5170_ = _e8018;
                                        } else {
                                            phi_5170_ = _e8022;
                                        }
                                        let _e8025 = phi_5170_;
                                        if (_e8011[2] < 0f) {
                                            phi_5177_ = -(_e8011[2]);
                                        } else {
                                            phi_5177_ = _e8011[2];
                                        }
                                        let _e8029 = phi_5177_;
                                        if (_e8025 > _e8029) {
                                            phi_5182_ = _e8025;
                                        } else {
                                            phi_5182_ = _e8029;
                                        }
                                        let _e8032 = phi_5182_;
                                        let _e8035 = local_18.member_2[1u];
                                        if (_e8035[0] < 0f) {
                                            phi_5196_ = -(_e8035[0]);
                                        } else {
                                            phi_5196_ = _e8035[0];
                                        }
                                        let _e8042 = phi_5196_;
                                        if (_e8035[1] < 0f) {
                                            phi_5203_ = -(_e8035[1]);
                                        } else {
                                            phi_5203_ = _e8035[1];
                                        }
                                        let _e8046 = phi_5203_;
                                        if (_e8042 > _e8046) {
                                            phi_5208_ = _e8042;
                                        } else {
                                            phi_5208_ = _e8046;
                                        }
                                        let _e8049 = phi_5208_;
                                        if (_e8035[2] < 0f) {
                                            phi_5215_ = -(_e8035[2]);
                                        } else {
                                            phi_5215_ = _e8035[2];
                                        }
                                        let _e8053 = phi_5215_;
                                        if (_e8049 > _e8053) {
                                            phi_5220_ = _e8049;
                                        } else {
                                            phi_5220_ = _e8053;
                                        }
                                        let _e8056 = phi_5220_;
                                        if (_e8032 > _e8056) {
                                            phi_5225_ = _e8032;
                                        } else {
                                            phi_5225_ = _e8056;
                                        }
                                        let _e8059 = phi_5225_;
                                        let _e8061 = local_18.member_3;
                                        let _e8068 = local_18.member_3;
                                        local_14 = type_37(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e7849, array<f32, 3>(_e7865, _e7866, _e7867), array<f32, 3>((_e7849[0] - _e7861[0]), (_e7849[1] - _e7861[1]), (_e7849[2] - _e7861[2])), array<f32, 3>((_e7865 - _e7861[0]), (_e7866 - _e7861[1]), (_e7867 - _e7861[2]))), array<array<f32, 3>, 4>(_e7876, array<f32, 3>(_e7892, _e7893, _e7894), array<f32, 3>((_e7876[0] - _e7888[0]), (_e7876[1] - _e7888[1]), (_e7876[2] - _e7888[2])), array<f32, 3>((_e7892 - _e7888[0]), (_e7893 - _e7888[1]), (_e7894 - _e7888[2])))), ((((((_e7951 + _e7953) + (_e8005 + _e8007)) + (_e8059 + _e8061)) * (0.000000059604645f * 16f)) + (_e8068 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e524.member_1);
                                        let _e8084 = local_14.member_1;
                                        if (_e7846 > _e8084) {
                                            if ((bitcast<u32>(_e7846) & 2139095040u) != 2139095040u) {
                                                let _e8089 = (1f / _e7846);
                                                let _e8091 = (_e7829[0] * _e8089);
                                                let _e8093 = (_e7829[1] * _e8089);
                                                let _e8095 = (_e7829[2] * _e8089);
                                                let _e8100 = (((_e8091 * _e8091) + (_e8093 * _e8093)) + (_e8095 * _e8095));
                                                if (_e8100 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8100 > 0f) {
                                                        phi_5326_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5326_ = 0f;
                                                    }
                                                    let _e8153 = phi_5326_;
                                                    phi_5390_ = _e8153;
                                                } else {
                                                    phi_5333_ = type_14(0i, 5i);
                                                    phi_5336_ = bitcast<f32>(((bitcast<u32>(_e8100) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8108 = phi_5333_;
                                                        let _e8110 = phi_5336_;
                                                        local_44 = _e8110;
                                                        if (_e8108.member < _e8108.member_1) {
                                                            let _e8117 = (_e8108.member + 1i);
                                                            if ((false == (_e8117 > _e8108.member)) != false) {
                                                                phi_5357_ = true;
                                                            } else {
                                                                phi_5357_ = false;
                                                            }
                                                            let _e8122 = phi_5357_;
                                                            if _e8122 {
                                                                phi_5363_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5363_ = type_15(1u, _e8117);
                                                            }
                                                            let _e8127 = phi_5363_;
                                                            phi_5334_ = type_14(_e8127.member_1, _e8108.member_1);
                                                            phi_5377_ = type_15(1u, _e8108.member);
                                                        } else {
                                                            phi_5334_ = _e8108;
                                                            phi_5377_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8133 = phi_5334_;
                                                        let _e8135 = phi_5377_;
                                                        let _e8138 = (bitcast<i32>(_e8135.member) != 0i);
                                                        if _e8138 {
                                                            phi_5337_ = (0.5f * (_e8110 + (_e8100 / _e8110)));
                                                        } else {
                                                            phi_5337_ = f32();
                                                        }
                                                        let _e8143 = phi_5337_;
                                                        continue;
                                                        continuing {
                                                            phi_5333_ = _e8133;
                                                            phi_5336_ = _e8143;
                                                            break if !(_e8138);
                                                        }
                                                    }
                                                    let _e8148 = local_44;
                                                    phi_5390_ = (_e8148 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8155 = phi_5390_;
                                                let _e8156 = (0.000000059604645f * 12f);
                                                let _e8158 = local_14.member_1;
                                                let _e8161 = local_14.member_2;
                                                let _e8165 = ((_e8158 * 1.01f) + ((_e8161 * _e8155) * (1f + _e8156)));
                                                let _e8169 = local_14.member[0u][0u];
                                                let _e8177 = (((_e8091 * _e8169[0]) + (_e8093 * _e8169[1])) + (_e8095 * _e8169[2]));
                                                let _e8181 = local_14.member[0u][1u];
                                                let _e8189 = (((_e8091 * _e8181[0]) + (_e8093 * _e8181[1])) + (_e8095 * _e8181[2]));
                                                let _e8193 = local_14.member[0u][2u];
                                                let _e8201 = (((_e8091 * _e8193[0]) + (_e8093 * _e8193[1])) + (_e8095 * _e8193[2]));
                                                let _e8205 = local_14.member[0u][3u];
                                                let _e8213 = (((_e8091 * _e8205[0]) + (_e8093 * _e8205[1])) + (_e8095 * _e8205[2]));
                                                let _e8217 = local_14.member[1u][0u];
                                                let _e8225 = (((_e8091 * _e8217[0]) + (_e8093 * _e8217[1])) + (_e8095 * _e8217[2]));
                                                let _e8229 = local_14.member[1u][1u];
                                                let _e8237 = (((_e8091 * _e8229[0]) + (_e8093 * _e8229[1])) + (_e8095 * _e8229[2]));
                                                let _e8241 = local_14.member[1u][2u];
                                                let _e8249 = (((_e8091 * _e8241[0]) + (_e8093 * _e8241[1])) + (_e8095 * _e8241[2]));
                                                let _e8253 = local_14.member[1u][3u];
                                                let _e8261 = (((_e8091 * _e8253[0]) + (_e8093 * _e8253[1])) + (_e8095 * _e8253[2]));
                                                if (_e8177 < 0f) {
                                                    phi_5524_ = -(_e8177);
                                                } else {
                                                    phi_5524_ = _e8177;
                                                }
                                                let _e8265 = phi_5524_;
                                                if (_e8225 < 0f) {
                                                    phi_5530_ = -(_e8225);
                                                } else {
                                                    phi_5530_ = _e8225;
                                                }
                                                let _e8269 = phi_5530_;
                                                if (_e8189 < 0f) {
                                                    phi_5539_ = -(_e8189);
                                                } else {
                                                    phi_5539_ = _e8189;
                                                }
                                                let _e8276 = phi_5539_;
                                                if (_e8237 < 0f) {
                                                    phi_5545_ = -(_e8237);
                                                } else {
                                                    phi_5545_ = _e8237;
                                                }
                                                let _e8280 = phi_5545_;
                                                if (_e8201 < 0f) {
                                                    phi_5554_ = -(_e8201);
                                                } else {
                                                    phi_5554_ = _e8201;
                                                }
                                                let _e8287 = phi_5554_;
                                                if (_e8249 < 0f) {
                                                    phi_5560_ = -(_e8249);
                                                } else {
                                                    phi_5560_ = _e8249;
                                                }
                                                let _e8291 = phi_5560_;
                                                if (_e8213 < 0f) {
                                                    phi_5569_ = -(_e8213);
                                                } else {
                                                    phi_5569_ = _e8213;
                                                }
                                                let _e8298 = phi_5569_;
                                                if (_e8261 < 0f) {
                                                    phi_5575_ = -(_e8261);
                                                } else {
                                                    phi_5575_ = _e8261;
                                                }
                                                let _e8302 = phi_5575_;
                                                local_15 = type_32(array<f32, 4>(_e8177, _e8189, _e8201, _e8213), array<f32, 4>(_e8225, _e8237, _e8249, _e8261), array<f32, 4>((_e8165 + ((_e8265 + _e8269) * _e8156)), (_e8165 + ((_e8276 + _e8280) * _e8156)), (_e8165 + ((_e8287 + _e8291) * _e8156)), (_e8165 + ((_e8298 + _e8302) * _e8156))));
                                                let _e8314 = (((_e8091 * _e8091) + (_e8093 * _e8093)) + (_e8095 * _e8095));
                                                if (_e8314 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8314 > 0f) {
                                                        phi_5618_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5618_ = 0f;
                                                    }
                                                    let _e8367 = phi_5618_;
                                                    phi_5682_ = _e8367;
                                                } else {
                                                    phi_5625_ = type_14(0i, 5i);
                                                    phi_5628_ = bitcast<f32>(((bitcast<u32>(_e8314) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8322 = phi_5625_;
                                                        let _e8324 = phi_5628_;
                                                        local_45 = _e8324;
                                                        if (_e8322.member < _e8322.member_1) {
                                                            let _e8331 = (_e8322.member + 1i);
                                                            if ((false == (_e8331 > _e8322.member)) != false) {
                                                                phi_5649_ = true;
                                                            } else {
                                                                phi_5649_ = false;
                                                            }
                                                            let _e8336 = phi_5649_;
                                                            if _e8336 {
                                                                phi_5655_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5655_ = type_15(1u, _e8331);
                                                            }
                                                            let _e8341 = phi_5655_;
                                                            phi_5626_ = type_14(_e8341.member_1, _e8322.member_1);
                                                            phi_5669_ = type_15(1u, _e8322.member);
                                                        } else {
                                                            phi_5626_ = _e8322;
                                                            phi_5669_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8347 = phi_5626_;
                                                        let _e8349 = phi_5669_;
                                                        let _e8352 = (bitcast<i32>(_e8349.member) != 0i);
                                                        if _e8352 {
                                                            phi_5629_ = (0.5f * (_e8324 + (_e8314 / _e8324)));
                                                        } else {
                                                            phi_5629_ = f32();
                                                        }
                                                        let _e8357 = phi_5629_;
                                                        continue;
                                                        continuing {
                                                            phi_5625_ = _e8347;
                                                            phi_5628_ = _e8357;
                                                            break if !(_e8352);
                                                        }
                                                    }
                                                    let _e8362 = local_45;
                                                    phi_5682_ = (_e8362 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8369 = phi_5682_;
                                                let _e8380 = (((_e7829[0] * _e7829[0]) + (_e7829[1] * _e7829[1])) + (_e7829[2] * _e7829[2]));
                                                if (_e8380 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8380 > 0f) {
                                                        phi_5707_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5707_ = 0f;
                                                    }
                                                    let _e8433 = phi_5707_;
                                                    phi_5771_ = _e8433;
                                                } else {
                                                    phi_5714_ = type_14(0i, 5i);
                                                    phi_5717_ = bitcast<f32>(((bitcast<u32>(_e8380) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8388 = phi_5714_;
                                                        let _e8390 = phi_5717_;
                                                        local_46 = _e8390;
                                                        if (_e8388.member < _e8388.member_1) {
                                                            let _e8397 = (_e8388.member + 1i);
                                                            if ((false == (_e8397 > _e8388.member)) != false) {
                                                                phi_5738_ = true;
                                                            } else {
                                                                phi_5738_ = false;
                                                            }
                                                            let _e8402 = phi_5738_;
                                                            if _e8402 {
                                                                phi_5744_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5744_ = type_15(1u, _e8397);
                                                            }
                                                            let _e8407 = phi_5744_;
                                                            phi_5715_ = type_14(_e8407.member_1, _e8388.member_1);
                                                            phi_5758_ = type_15(1u, _e8388.member);
                                                        } else {
                                                            phi_5715_ = _e8388;
                                                            phi_5758_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8413 = phi_5715_;
                                                        let _e8415 = phi_5758_;
                                                        let _e8418 = (bitcast<i32>(_e8415.member) != 0i);
                                                        if _e8418 {
                                                            phi_5718_ = (0.5f * (_e8390 + (_e8380 / _e8390)));
                                                        } else {
                                                            phi_5718_ = f32();
                                                        }
                                                        let _e8423 = phi_5718_;
                                                        continue;
                                                        continuing {
                                                            phi_5714_ = _e8413;
                                                            phi_5717_ = _e8423;
                                                            break if !(_e8418);
                                                        }
                                                    }
                                                    let _e8428 = local_46;
                                                    phi_5771_ = (_e8428 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8435 = phi_5771_;
                                                let _e8441 = local_18.member[0u];
                                                if (_e8441[0] < 0f) {
                                                    phi_5787_ = -(_e8441[0]);
                                                } else {
                                                    phi_5787_ = _e8441[0];
                                                }
                                                let _e8448 = phi_5787_;
                                                if (_e8441[1] < 0f) {
                                                    phi_5794_ = -(_e8441[1]);
                                                } else {
                                                    phi_5794_ = _e8441[1];
                                                }
                                                let _e8452 = phi_5794_;
                                                if (_e8448 > _e8452) {
                                                    phi_5799_ = _e8448;
                                                } else {
                                                    phi_5799_ = _e8452;
                                                }
                                                let _e8455 = phi_5799_;
                                                if (_e8441[2] < 0f) {
                                                    phi_5806_ = -(_e8441[2]);
                                                } else {
                                                    phi_5806_ = _e8441[2];
                                                }
                                                let _e8459 = phi_5806_;
                                                if (_e8455 > _e8459) {
                                                    phi_5811_ = _e8455;
                                                } else {
                                                    phi_5811_ = _e8459;
                                                }
                                                let _e8462 = phi_5811_;
                                                let _e8465 = local_18.member[1u];
                                                if (_e8465[0] < 0f) {
                                                    phi_5824_ = -(_e8465[0]);
                                                } else {
                                                    phi_5824_ = _e8465[0];
                                                }
                                                let _e8472 = phi_5824_;
                                                if (_e8465[1] < 0f) {
                                                    phi_5831_ = -(_e8465[1]);
                                                } else {
                                                    phi_5831_ = _e8465[1];
                                                }
                                                let _e8476 = phi_5831_;
                                                if (_e8472 > _e8476) {
                                                    phi_5836_ = _e8472;
                                                } else {
                                                    phi_5836_ = _e8476;
                                                }
                                                let _e8479 = phi_5836_;
                                                if (_e8465[2] < 0f) {
                                                    phi_5843_ = -(_e8465[2]);
                                                } else {
                                                    phi_5843_ = _e8465[2];
                                                }
                                                let _e8483 = phi_5843_;
                                                if (_e8479 > _e8483) {
                                                    phi_5848_ = _e8479;
                                                } else {
                                                    phi_5848_ = _e8483;
                                                }
                                                let _e8486 = phi_5848_;
                                                if (_e8462 > _e8486) {
                                                    phi_5853_ = _e8462;
                                                } else {
                                                    phi_5853_ = _e8486;
                                                }
                                                let _e8489 = phi_5853_;
                                                let _e8491 = local_18.member_3;
                                                let _e8495 = local_18.member_1[0u];
                                                if (_e8495[0] < 0f) {
                                                    phi_5870_ = -(_e8495[0]);
                                                } else {
                                                    phi_5870_ = _e8495[0];
                                                }
                                                let _e8502 = phi_5870_;
                                                if (_e8495[1] < 0f) {
                                                    phi_5877_ = -(_e8495[1]);
                                                } else {
                                                    phi_5877_ = _e8495[1];
                                                }
                                                let _e8506 = phi_5877_;
                                                if (_e8502 > _e8506) {
                                                    phi_5882_ = _e8502;
                                                } else {
                                                    phi_5882_ = _e8506;
                                                }
                                                let _e8509 = phi_5882_;
                                                if (_e8495[2] < 0f) {
                                                    phi_5889_ = -(_e8495[2]);
                                                } else {
                                                    phi_5889_ = _e8495[2];
                                                }
                                                let _e8513 = phi_5889_;
                                                if (_e8509 > _e8513) {
                                                    phi_5894_ = _e8509;
                                                } else {
                                                    phi_5894_ = _e8513;
                                                }
                                                let _e8516 = phi_5894_;
                                                let _e8519 = local_18.member_1[1u];
                                                if (_e8519[0] < 0f) {
                                                    phi_5908_ = -(_e8519[0]);
                                                } else {
                                                    phi_5908_ = _e8519[0];
                                                }
                                                let _e8526 = phi_5908_;
                                                if (_e8519[1] < 0f) {
                                                    phi_5915_ = -(_e8519[1]);
                                                } else {
                                                    phi_5915_ = _e8519[1];
                                                }
                                                let _e8530 = phi_5915_;
                                                if (_e8526 > _e8530) {
                                                    phi_5920_ = _e8526;
                                                } else {
                                                    phi_5920_ = _e8530;
                                                }
                                                let _e8533 = phi_5920_;
                                                if (_e8519[2] < 0f) {
                                                    phi_5927_ = -(_e8519[2]);
                                                } else {
                                                    phi_5927_ = _e8519[2];
                                                }
                                                let _e8537 = phi_5927_;
                                                if (_e8533 > _e8537) {
                                                    phi_5932_ = _e8533;
                                                } else {
                                                    phi_5932_ = _e8537;
                                                }
                                                let _e8540 = phi_5932_;
                                                if (_e8516 > _e8540) {
                                                    phi_5937_ = _e8516;
                                                } else {
                                                    phi_5937_ = _e8540;
                                                }
                                                let _e8543 = phi_5937_;
                                                let _e8545 = local_18.member_3;
                                                let _e8549 = local_18.member_2[0u];
                                                if (_e8549[0] < 0f) {
                                                    phi_5954_ = -(_e8549[0]);
                                                } else {
                                                    phi_5954_ = _e8549[0];
                                                }
                                                let _e8556 = phi_5954_;
                                                if (_e8549[1] < 0f) {
                                                    phi_5961_ = -(_e8549[1]);
                                                } else {
                                                    phi_5961_ = _e8549[1];
                                                }
                                                let _e8560 = phi_5961_;
                                                if (_e8556 > _e8560) {
                                                    phi_5966_ = _e8556;
                                                } else {
                                                    phi_5966_ = _e8560;
                                                }
                                                let _e8563 = phi_5966_;
                                                if (_e8549[2] < 0f) {
                                                    phi_5973_ = -(_e8549[2]);
                                                } else {
                                                    phi_5973_ = _e8549[2];
                                                }
                                                let _e8567 = phi_5973_;
                                                if (_e8563 > _e8567) {
                                                    phi_5978_ = _e8563;
                                                } else {
                                                    phi_5978_ = _e8567;
                                                }
                                                let _e8570 = phi_5978_;
                                                let _e8573 = local_18.member_2[1u];
                                                if (_e8573[0] < 0f) {
                                                    phi_5992_ = -(_e8573[0]);
                                                } else {
                                                    phi_5992_ = _e8573[0];
                                                }
                                                let _e8580 = phi_5992_;
                                                if (_e8573[1] < 0f) {
                                                    phi_5999_ = -(_e8573[1]);
                                                } else {
                                                    phi_5999_ = _e8573[1];
                                                }
                                                let _e8584 = phi_5999_;
                                                if (_e8580 > _e8584) {
                                                    phi_6004_ = _e8580;
                                                } else {
                                                    phi_6004_ = _e8584;
                                                }
                                                let _e8587 = phi_6004_;
                                                if (_e8573[2] < 0f) {
                                                    phi_6011_ = -(_e8573[2]);
                                                } else {
                                                    phi_6011_ = _e8573[2];
                                                }
                                                let _e8591 = phi_6011_;
                                                if (_e8587 > _e8591) {
                                                    phi_6016_ = _e8587;
                                                } else {
                                                    phi_6016_ = _e8591;
                                                }
                                                let _e8594 = phi_6016_;
                                                if (_e8570 > _e8594) {
                                                    phi_6021_ = _e8570;
                                                } else {
                                                    phi_6021_ = _e8594;
                                                }
                                                let _e8597 = phi_6021_;
                                                let _e8599 = local_18.member_3;
                                                let _e8606 = local_18.member_3;
                                                let _e8616 = ((((_e8435 * (1f + (0.000000059604645f * 8f))) + (((((((_e8489 + _e8491) + (_e8543 + _e8545)) + (_e8597 + _e8599)) * (0.000000059604645f * 16f)) + (_e8606 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e8369) * (1f + (0.000000059604645f * 64f)));
                                                let _e8619 = local_15.member[0u];
                                                let _e8622 = local_15.member_1[0u];
                                                if (_e8619 < 0f) {
                                                    phi_6062_ = -(_e8619);
                                                } else {
                                                    phi_6062_ = _e8619;
                                                }
                                                let _e8627 = phi_6062_;
                                                if (_e8622 < 0f) {
                                                    phi_6068_ = -(_e8622);
                                                } else {
                                                    phi_6068_ = _e8622;
                                                }
                                                let _e8631 = phi_6068_;
                                                phi_6079_ = type_12(1u, 4u);
                                                phi_6082_ = ((_e8619 + ((_e8622 - _e8619) * _e5970)) - ((_e8084 * 1.01f) + ((_e8627 + _e8631) * (0.000000059604645f * 12f))));
                                                loop {
                                                    let _e8641 = phi_6079_;
                                                    let _e8643 = phi_6082_;
                                                    local_47 = _e8643;
                                                    local_48 = _e8643;
                                                    if (_e8641.member < _e8641.member_1) {
                                                        phi_6080_ = type_12((_e8641.member + 1u), _e8641.member_1);
                                                        phi_6105_ = type_12(1u, _e8641.member);
                                                    } else {
                                                        phi_6080_ = _e8641;
                                                        phi_6105_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e8655 = phi_6080_;
                                                    let _e8657 = phi_6105_;
                                                    let _e8661 = (bitcast<i32>(_e8657.member) != 0i);
                                                    if _e8661 {
                                                        let _e8664 = local_15.member[_e8657.member_1];
                                                        let _e8667 = local_15.member_1[_e8657.member_1];
                                                        if (_e8664 < 0f) {
                                                            phi_6134_ = -(_e8664);
                                                        } else {
                                                            phi_6134_ = _e8664;
                                                        }
                                                        let _e8672 = phi_6134_;
                                                        if (_e8667 < 0f) {
                                                            phi_6140_ = -(_e8667);
                                                        } else {
                                                            phi_6140_ = _e8667;
                                                        }
                                                        let _e8676 = phi_6140_;
                                                        let _e8684 = ((_e8664 + ((_e8667 - _e8664) * _e5970)) - ((_e8084 * 1.01f) + ((_e8672 + _e8676) * (0.000000059604645f * 12f))));
                                                        if (_e8643 < _e8684) {
                                                            phi_6153_ = _e8643;
                                                        } else {
                                                            phi_6153_ = _e8684;
                                                        }
                                                        let _e8687 = phi_6153_;
                                                        phi_6083_ = _e8687;
                                                    } else {
                                                        phi_6083_ = f32();
                                                    }
                                                    let _e8689 = phi_6083_;
                                                    continue;
                                                    continuing {
                                                        phi_6079_ = _e8655;
                                                        phi_6082_ = _e8689;
                                                        break if !(_e8661);
                                                    }
                                                }
                                                let _e8692 = local_47;
                                                if (_e8692 > 0f) {
                                                    let _e8696 = local_48;
                                                    let _e8699 = (((_e8616 - _e8696) / _e8616) * 2.02f);
                                                    if (_e8699 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e8699 > 0f) {
                                                            phi_6174_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_6174_ = 0f;
                                                        }
                                                        let _e8752 = phi_6174_;
                                                        phi_6238_ = _e8752;
                                                    } else {
                                                        phi_6181_ = type_14(0i, 5i);
                                                        phi_6184_ = bitcast<f32>(((bitcast<u32>(_e8699) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e8707 = phi_6181_;
                                                            let _e8709 = phi_6184_;
                                                            local_49 = _e8709;
                                                            if (_e8707.member < _e8707.member_1) {
                                                                let _e8716 = (_e8707.member + 1i);
                                                                if ((false == (_e8716 > _e8707.member)) != false) {
                                                                    phi_6205_ = true;
                                                                } else {
                                                                    phi_6205_ = false;
                                                                }
                                                                let _e8721 = phi_6205_;
                                                                if _e8721 {
                                                                    phi_6211_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_6211_ = type_15(1u, _e8716);
                                                                }
                                                                let _e8726 = phi_6211_;
                                                                phi_6182_ = type_14(_e8726.member_1, _e8707.member_1);
                                                                phi_6225_ = type_15(1u, _e8707.member);
                                                            } else {
                                                                phi_6182_ = _e8707;
                                                                phi_6225_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e8732 = phi_6182_;
                                                            let _e8734 = phi_6225_;
                                                            let _e8737 = (bitcast<i32>(_e8734.member) != 0i);
                                                            if _e8737 {
                                                                phi_6185_ = (0.5f * (_e8709 + (_e8699 / _e8709)));
                                                            } else {
                                                                phi_6185_ = f32();
                                                            }
                                                            let _e8742 = phi_6185_;
                                                            continue;
                                                            continuing {
                                                                phi_6181_ = _e8732;
                                                                phi_6184_ = _e8742;
                                                                break if !(_e8737);
                                                            }
                                                        }
                                                        let _e8747 = local_49;
                                                        phi_6238_ = (_e8747 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e8754 = phi_6238_;
                                                    let _e8756 = ((_e8754 * _e8369) * 1.01f);
                                                    phi_6243_ = type_12(0u, 4u);
                                                    phi_6246_ = 2f;
                                                    phi_6248_ = true;
                                                    phi_6250_ = true;
                                                    loop {
                                                        let _e8758 = phi_6243_;
                                                        let _e8760 = phi_6246_;
                                                        let _e8762 = phi_6248_;
                                                        let _e8764 = phi_6250_;
                                                        local_50 = _e8760;
                                                        local_87 = _e8760;
                                                        local_51 = _e8762;
                                                        local_52 = _e8764;
                                                        local_88 = _e8764;
                                                        local_53 = _e8764;
                                                        if (_e8758.member < _e8758.member_1) {
                                                            phi_6244_ = type_12((_e8758.member + 1u), _e8758.member_1);
                                                            phi_6273_ = type_12(1u, _e8758.member);
                                                        } else {
                                                            phi_6244_ = _e8758;
                                                            phi_6273_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e8776 = phi_6244_;
                                                        let _e8778 = phi_6273_;
                                                        let _e8782 = (bitcast<i32>(_e8778.member) != 0i);
                                                        if _e8782 {
                                                            let _e8786 = local_14.member[0u][_e8778.member_1];
                                                            let _e8793 = local_14.member[1u][_e8778.member_1];
                                                            if (_e8786[0] < 0f) {
                                                                phi_6310_ = -(_e8786[0]);
                                                            } else {
                                                                phi_6310_ = _e8786[0];
                                                            }
                                                            let _e8800 = phi_6310_;
                                                            if (_e8786[1] < 0f) {
                                                                phi_6317_ = -(_e8786[1]);
                                                            } else {
                                                                phi_6317_ = _e8786[1];
                                                            }
                                                            let _e8804 = phi_6317_;
                                                            if (_e8786[2] < 0f) {
                                                                phi_6325_ = -(_e8786[2]);
                                                            } else {
                                                                phi_6325_ = _e8786[2];
                                                            }
                                                            let _e8809 = phi_6325_;
                                                            let _e8810 = ((_e8800 + _e8804) + _e8809);
                                                            if (_e8793[0] < 0f) {
                                                                phi_6333_ = -(_e8793[0]);
                                                            } else {
                                                                phi_6333_ = _e8793[0];
                                                            }
                                                            let _e8814 = phi_6333_;
                                                            if (_e8793[1] < 0f) {
                                                                phi_6340_ = -(_e8793[1]);
                                                            } else {
                                                                phi_6340_ = _e8793[1];
                                                            }
                                                            let _e8818 = phi_6340_;
                                                            if (_e8793[2] < 0f) {
                                                                phi_6348_ = -(_e8793[2]);
                                                            } else {
                                                                phi_6348_ = _e8793[2];
                                                            }
                                                            let _e8823 = phi_6348_;
                                                            let _e8824 = ((_e8814 + _e8818) + _e8823);
                                                            if (_e8810 > _e8824) {
                                                                phi_6354_ = _e8810;
                                                            } else {
                                                                phi_6354_ = _e8824;
                                                            }
                                                            let _e8827 = phi_6354_;
                                                            let _e8831 = (_e8793[0] - _e8786[0]);
                                                            let _e8832 = (_e8793[1] - _e8786[1]);
                                                            let _e8833 = (_e8793[2] - _e8786[2]);
                                                            if (_e8831 < 0f) {
                                                                phi_6372_ = -(_e8831);
                                                            } else {
                                                                phi_6372_ = _e8831;
                                                            }
                                                            let _e8837 = phi_6372_;
                                                            if (_e8832 < 0f) {
                                                                phi_6378_ = -(_e8832);
                                                            } else {
                                                                phi_6378_ = _e8832;
                                                            }
                                                            let _e8841 = phi_6378_;
                                                            if (_e8833 < 0f) {
                                                                phi_6385_ = -(_e8833);
                                                            } else {
                                                                phi_6385_ = _e8833;
                                                            }
                                                            let _e8846 = phi_6385_;
                                                            let _e8853 = local_15.member[_e8778.member_1];
                                                            let _e8856 = local_15.member_1[_e8778.member_1];
                                                            if (_e8853 < 0f) {
                                                                phi_6411_ = -(_e8853);
                                                            } else {
                                                                phi_6411_ = _e8853;
                                                            }
                                                            let _e8861 = phi_6411_;
                                                            if (_e8856 < 0f) {
                                                                phi_6417_ = -(_e8856);
                                                            } else {
                                                                phi_6417_ = _e8856;
                                                            }
                                                            let _e8865 = phi_6417_;
                                                            let _e8869 = ((_e8084 * 1.01f) + ((_e8861 + _e8865) * (0.000000059604645f * 12f)));
                                                            let _e8876 = local_15.member_1[_e8778.member_1];
                                                            let _e8879 = local_15.member[_e8778.member_1];
                                                            let _e8880 = (_e8876 - _e8879);
                                                            let _e8883 = ((_e8869 + _e8869) + (_e8756 * ((((_e8837 + _e8841) + _e8846) + (_e8084 * 6f)) * 1.01f)));
                                                            let _e8886 = ((((_e8853 + ((_e8856 - _e8853) * _e5970)) - _e8869) - (_e8756 * ((_e8827 + (_e8084 * 3f)) * 1.01f))) - _e8616);
                                                            let _e8887 = (_e8886 > 0.000000000000000000000000000000000000011754944f);
                                                            let _e8888 = (_e8880 > _e8883);
                                                            if _e8888 {
                                                                phi_6453_ = true;
                                                            } else {
                                                                phi_6453_ = _e8887;
                                                            }
                                                            let _e8890 = phi_6453_;
                                                            if (_e8880 < -(_e8883)) {
                                                                phi_6460_ = true;
                                                            } else {
                                                                phi_6460_ = _e8887;
                                                            }
                                                            let _e8895 = phi_6460_;
                                                            if _e8888 {
                                                                phi_6481_ = _e8760;
                                                            } else {
                                                                if _e8887 {
                                                                    let _e8897 = (_e8883 - _e8880);
                                                                    if (_e8897 > 0.000000000000000000000000000000000000011754944f) {
                                                                        phi_6473_ = _e8897;
                                                                    } else {
                                                                        phi_6473_ = 0.000000000000000000000000000000000000011754944f;
                                                                    }
                                                                    let _e8900 = phi_6473_;
                                                                    let _e8901 = (_e8886 / _e8900);
                                                                    if (_e8760 < _e8901) {
                                                                        phi_6479_ = _e8760;
                                                                    } else {
                                                                        phi_6479_ = _e8901;
                                                                    }
                                                                    let _e8904 = phi_6479_;
                                                                    phi_6480_ = _e8904;
                                                                } else {
                                                                    phi_6480_ = _e8760;
                                                                }
                                                                let _e8906 = phi_6480_;
                                                                phi_6481_ = _e8906;
                                                            }
                                                            let _e8908 = phi_6481_;
                                                            phi_6247_ = _e8908;
                                                            phi_6249_ = (_e8762 && _e8895);
                                                            phi_6251_ = (_e8764 && _e8890);
                                                        } else {
                                                            phi_6247_ = f32();
                                                            phi_6249_ = bool();
                                                            phi_6251_ = bool();
                                                        }
                                                        let _e8910 = phi_6247_;
                                                        let _e8912 = phi_6249_;
                                                        let _e8914 = phi_6251_;
                                                        continue;
                                                        continuing {
                                                            phi_6243_ = _e8776;
                                                            phi_6246_ = _e8910;
                                                            phi_6248_ = _e8912;
                                                            phi_6250_ = _e8914;
                                                            break if !(_e8782);
                                                        }
                                                    }
                                                    let _e8917 = local_50;
                                                    if (_e8917 < 2f) {
                                                        let _e11359 = local_87;
                                                        phi_6486_ = _e11359;
                                                    } else {
                                                        phi_6486_ = 2f;
                                                    }
                                                    let _e8920 = phi_6486_;
                                                    let _e8921 = (_e8920 * 0.999f);
                                                    let _e8923 = local_51;
                                                    if _e8923 {
                                                        let _e8925 = local_52;
                                                        if _e8925 {
                                                            phi_6495_ = type_40();
                                                        } else {
                                                            phi_6495_ = type_40(1u, _e5970, 2f);
                                                        }
                                                        let _e8928 = phi_6495_;
                                                        phi_6496_ = _e8928;
                                                        let _e11366 = local_88;
                                                        phi_6497_ = _e11366;
                                                    } else {
                                                        phi_6496_ = type_40();
                                                        phi_6497_ = true;
                                                    }
                                                    let _e8930 = phi_6496_;
                                                    let _e8932 = phi_6497_;
                                                    if _e8932 {
                                                        let _e8934 = local_53;
                                                        if _e8934 {
                                                            if (_e8921 > (0.000000059604645f * 4096f)) {
                                                                let _e8938 = (_e5970 + _e8921);
                                                                if (_e8938 < _e324) {
                                                                    phi_6514_ = _e8938;
                                                                } else {
                                                                    phi_6514_ = _e324;
                                                                }
                                                                let _e8941 = phi_6514_;
                                                                phi_6515_ = _e8941;
                                                            } else {
                                                                phi_6515_ = _e5970;
                                                            }
                                                            let _e8943 = phi_6515_;
                                                            phi_6518_ = type_12(0u, 4u);
                                                            phi_6521_ = _e8943;
                                                            phi_6523_ = _e5970;
                                                            loop {
                                                                let _e8945 = phi_6518_;
                                                                let _e8947 = phi_6521_;
                                                                let _e8949 = phi_6523_;
                                                                local_54 = _e8947;
                                                                local_55 = _e8949;
                                                                local_56 = _e8949;
                                                                if (_e8945.member < _e8945.member_1) {
                                                                    phi_6519_ = type_12((_e8945.member + 1u), _e8945.member_1);
                                                                    phi_6546_ = type_12(1u, _e8945.member);
                                                                } else {
                                                                    phi_6519_ = _e8945;
                                                                    phi_6546_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e8961 = phi_6519_;
                                                                let _e8963 = phi_6546_;
                                                                let _e8967 = (bitcast<i32>(_e8963.member) != 0i);
                                                                if _e8967 {
                                                                    let _e8970 = local_15.member[_e8963.member_1];
                                                                    let _e8973 = local_15.member_1[_e8963.member_1];
                                                                    let _e8976 = local_15.member[_e8963.member_1];
                                                                    let _e8982 = local_15.member_2[_e8963.member_1];
                                                                    let _e8983 = ((_e8970 + ((_e8973 - _e8976) * _e5970)) - _e8982);
                                                                    let _e8986 = local_15.member_1[_e8963.member_1];
                                                                    let _e8989 = local_15.member[_e8963.member_1];
                                                                    let _e8990 = (_e8986 - _e8989);
                                                                    if (_e8990 > 0f) {
                                                                        let _e9004 = (_e5970 - (_e8983 / _e8990));
                                                                        if (_e8949 > _e9004) {
                                                                            phi_6614_ = _e8949;
                                                                        } else {
                                                                            phi_6614_ = _e9004;
                                                                        }
                                                                        let _e9007 = phi_6614_;
                                                                        phi_6632_ = _e8947;
                                                                        phi_6633_ = _e9007;
                                                                    } else {
                                                                        if (_e8983 > 0f) {
                                                                            if (_e8990 < 0f) {
                                                                                let _e8995 = (_e5970 - (_e8983 / _e8990));
                                                                                if (_e8947 < _e8995) {
                                                                                    phi_6629_ = _e8947;
                                                                                } else {
                                                                                    phi_6629_ = _e8995;
                                                                                }
                                                                                let _e8998 = phi_6629_;
                                                                                phi_6630_ = _e8998;
                                                                            } else {
                                                                                phi_6630_ = _e8947;
                                                                            }
                                                                            let _e9000 = phi_6630_;
                                                                            phi_6631_ = _e9000;
                                                                        } else {
                                                                            phi_6631_ = _e8947;
                                                                        }
                                                                        let _e9002 = phi_6631_;
                                                                        phi_6632_ = _e9002;
                                                                        phi_6633_ = _e8949;
                                                                    }
                                                                    let _e9009 = phi_6632_;
                                                                    let _e9011 = phi_6633_;
                                                                    phi_6522_ = _e9009;
                                                                    phi_6524_ = _e9011;
                                                                } else {
                                                                    phi_6522_ = f32();
                                                                    phi_6524_ = f32();
                                                                }
                                                                let _e9013 = phi_6522_;
                                                                let _e9015 = phi_6524_;
                                                                continue;
                                                                continuing {
                                                                    phi_6518_ = _e8961;
                                                                    phi_6521_ = _e9013;
                                                                    phi_6523_ = _e9015;
                                                                    break if !(_e8967);
                                                                }
                                                            }
                                                            let _e9018 = local_54;
                                                            let _e9020 = local_55;
                                                            let _e9024 = local_56;
                                                            let _e9025 = (_e9024 + ((_e9018 - _e9020) * 0.5f));
                                                            if (_e9025 > _e5970) {
                                                                if (_e9025 <= _e8943) {
                                                                    let _e9030 = local_15.member[0u];
                                                                    let _e9033 = local_15.member_1[0u];
                                                                    let _e9036 = local_15.member[0u];
                                                                    let _e9042 = local_15.member_2[0u];
                                                                    if (((_e9030 + ((_e9033 - _e9036) * _e9025)) - _e9042) > 0f) {
                                                                        let _e9047 = local_15.member[1u];
                                                                        let _e9050 = local_15.member_1[1u];
                                                                        let _e9053 = local_15.member[1u];
                                                                        let _e9059 = local_15.member_2[1u];
                                                                        if (((_e9047 + ((_e9050 - _e9053) * _e9025)) - _e9059) > 0f) {
                                                                            let _e9064 = local_15.member[2u];
                                                                            let _e9067 = local_15.member_1[2u];
                                                                            let _e9070 = local_15.member[2u];
                                                                            let _e9076 = local_15.member_2[2u];
                                                                            if (((_e9064 + ((_e9067 - _e9070) * _e9025)) - _e9076) > 0f) {
                                                                                let _e9081 = local_15.member[3u];
                                                                                let _e9084 = local_15.member_1[3u];
                                                                                let _e9087 = local_15.member[3u];
                                                                                let _e9093 = local_15.member_2[3u];
                                                                                phi_6794_ = (((_e9081 + ((_e9084 - _e9087) * _e9025)) - _e9093) > 0f);
                                                                                phi_6795_ = false;
                                                                            } else {
                                                                                phi_6794_ = bool();
                                                                                phi_6795_ = true;
                                                                            }
                                                                            let _e9097 = phi_6794_;
                                                                            let _e9099 = phi_6795_;
                                                                            phi_6796_ = _e9097;
                                                                            phi_6797_ = _e9099;
                                                                        } else {
                                                                            phi_6796_ = bool();
                                                                            phi_6797_ = true;
                                                                        }
                                                                        let _e9101 = phi_6796_;
                                                                        let _e9103 = phi_6797_;
                                                                        phi_6798_ = _e9101;
                                                                        phi_6799_ = _e9103;
                                                                    } else {
                                                                        phi_6798_ = bool();
                                                                        phi_6799_ = true;
                                                                    }
                                                                    let _e9105 = phi_6798_;
                                                                    let _e9107 = phi_6799_;
                                                                    if _e9107 {
                                                                        phi_6803_ = false;
                                                                    } else {
                                                                        phi_6803_ = _e9105;
                                                                    }
                                                                    let _e9109 = phi_6803_;
                                                                    if _e9109 {
                                                                        phi_6807_ = false;
                                                                    } else {
                                                                        phi_6807_ = true;
                                                                    }
                                                                    let _e9111 = phi_6807_;
                                                                    phi_6808_ = _e9111;
                                                                } else {
                                                                    phi_6808_ = true;
                                                                }
                                                                let _e9113 = phi_6808_;
                                                                phi_6809_ = _e9113;
                                                            } else {
                                                                phi_6809_ = true;
                                                            }
                                                            let _e9115 = phi_6809_;
                                                            if _e9115 {
                                                                phi_6813_ = 2f;
                                                            } else {
                                                                phi_6813_ = _e9025;
                                                            }
                                                            let _e9117 = phi_6813_;
                                                            phi_6816_ = type_40(2u, _e8943, _e9117);
                                                            phi_6817_ = type_40();
                                                            phi_6818_ = false;
                                                        } else {
                                                            phi_6816_ = type_40();
                                                            phi_6817_ = type_40(0u, _e5970, 2f);
                                                            phi_6818_ = true;
                                                        }
                                                        let _e9120 = phi_6816_;
                                                        let _e9122 = phi_6817_;
                                                        let _e9124 = phi_6818_;
                                                        phi_6819_ = _e9120;
                                                        phi_6820_ = _e9122;
                                                        phi_6821_ = _e9124;
                                                    } else {
                                                        phi_6819_ = type_40();
                                                        phi_6820_ = _e8930;
                                                        phi_6821_ = true;
                                                    }
                                                    let _e9126 = phi_6819_;
                                                    let _e9128 = phi_6820_;
                                                    let _e9130 = phi_6821_;
                                                    phi_6826_ = _e9128;
                                                    phi_6827_ = _e9126;
                                                    phi_6828_ = _e9130;
                                                } else {
                                                    phi_6826_ = type_40(0u, _e5970, 2f);
                                                    phi_6827_ = type_40();
                                                    phi_6828_ = true;
                                                }
                                                let _e9132 = phi_6826_;
                                                let _e9134 = phi_6827_;
                                                let _e9136 = phi_6828_;
                                                phi_6832_ = _e9132;
                                                phi_6833_ = _e9134;
                                                phi_6834_ = false;
                                                phi_6835_ = _e9136;
                                            } else {
                                                phi_6832_ = type_40();
                                                phi_6833_ = type_40();
                                                phi_6834_ = true;
                                                phi_6835_ = false;
                                            }
                                            let _e9138 = phi_6832_;
                                            let _e9140 = phi_6833_;
                                            let _e9142 = phi_6834_;
                                            let _e9144 = phi_6835_;
                                            phi_6836_ = _e9138;
                                            phi_6837_ = _e9140;
                                            phi_6838_ = _e9142;
                                            phi_6839_ = _e9144;
                                        } else {
                                            phi_6836_ = type_40();
                                            phi_6837_ = type_40();
                                            phi_6838_ = true;
                                            phi_6839_ = false;
                                        }
                                        let _e9146 = phi_6836_;
                                        let _e9148 = phi_6837_;
                                        let _e9150 = phi_6838_;
                                        let _e9152 = phi_6839_;
                                        if _e9150 {
                                            phi_6844_ = type_40(0u, _e5970, 2f);
                                            phi_6845_ = true;
                                        } else {
                                            phi_6844_ = _e9146;
                                            phi_6845_ = _e9152;
                                        }
                                        let _e9155 = phi_6844_;
                                        let _e9157 = phi_6845_;
                                        if _e9157 {
                                            phi_6849_ = _e9155;
                                        } else {
                                            phi_6849_ = _e9148;
                                        }
                                        let _e9159 = phi_6849_;
                                        if _e330 {
                                            if (_e9159.member == 2u) {
                                                let _e9163 = (_e9159.member_2 <= _e324);
                                                if _e9163 {
                                                    phi_6865_ = _e9159.member_2;
                                                    phi_6866_ = _e9159.member_2;
                                                    phi_6867_ = false;
                                                } else {
                                                    phi_6865_ = f32();
                                                    phi_6866_ = f32();
                                                    phi_6867_ = true;
                                                }
                                                let _e9167 = phi_6865_;
                                                let _e9169 = phi_6866_;
                                                let _e9171 = phi_6867_;
                                                phi_6868_ = _e9167;
                                                phi_6869_ = _e9169;
                                                phi_6870_ = _e9163;
                                                phi_6871_ = _e9171;
                                                phi_6872_ = false;
                                            } else {
                                                phi_6868_ = f32();
                                                phi_6869_ = f32();
                                                phi_6870_ = false;
                                                phi_6871_ = false;
                                                phi_6872_ = true;
                                            }
                                            let _e9173 = phi_6868_;
                                            let _e9175 = phi_6869_;
                                            let _e9177 = phi_6870_;
                                            let _e9179 = phi_6871_;
                                            let _e9181 = phi_6872_;
                                            phi_6873_ = _e9173;
                                            phi_6874_ = _e9175;
                                            phi_6875_ = _e9177;
                                            phi_6876_ = _e9179;
                                            phi_6877_ = _e9181;
                                        } else {
                                            phi_6873_ = f32();
                                            phi_6874_ = f32();
                                            phi_6875_ = false;
                                            phi_6876_ = false;
                                            phi_6877_ = true;
                                        }
                                        let _e9183 = phi_6873_;
                                        let _e9185 = phi_6874_;
                                        let _e9187 = phi_6875_;
                                        let _e9189 = phi_6876_;
                                        let _e9191 = phi_6877_;
                                        phi_6878_ = _e9183;
                                        phi_6879_ = _e9159.member;
                                        phi_6880_ = _e9185;
                                        phi_6881_ = _e9159;
                                        phi_6882_ = _e9159.member;
                                        phi_6883_ = _e9159.member;
                                        phi_6884_ = _e9187;
                                        phi_6885_ = _e9189;
                                        phi_6886_ = _e9191;
                                    }
                                    let _e9193 = phi_6878_;
                                    let _e9195 = phi_6879_;
                                    let _e9197 = phi_6880_;
                                    let _e9199 = phi_6881_;
                                    let _e9201 = phi_6882_;
                                    let _e9203 = phi_6883_;
                                    let _e9205 = phi_6884_;
                                    let _e9207 = phi_6885_;
                                    let _e9209 = phi_6886_;
                                    phi_6887_ = _e9193;
                                    phi_6888_ = _e9195;
                                    phi_6889_ = _e9197;
                                    phi_6890_ = _e9199;
                                    phi_6891_ = _e9201;
                                    phi_6892_ = _e9203;
                                    phi_6893_ = _e9205;
                                    phi_6894_ = _e7762;
                                    phi_6895_ = _e9207;
                                    phi_6896_ = _e9209;
                                    phi_6897_ = false;
                                } else {
                                    phi_6887_ = f32();
                                    phi_6888_ = u32();
                                    phi_6889_ = f32();
                                    phi_6890_ = type_40();
                                    phi_6891_ = u32();
                                    phi_6892_ = u32();
                                    phi_6893_ = false;
                                    phi_6894_ = false;
                                    phi_6895_ = false;
                                    phi_6896_ = false;
                                    phi_6897_ = true;
                                }
                                let _e9211 = phi_6887_;
                                let _e9213 = phi_6888_;
                                let _e9215 = phi_6889_;
                                let _e9217 = phi_6890_;
                                let _e9219 = phi_6891_;
                                let _e9221 = phi_6892_;
                                let _e9223 = phi_6893_;
                                let _e9225 = phi_6894_;
                                let _e9227 = phi_6895_;
                                let _e9229 = phi_6896_;
                                let _e9231 = phi_6897_;
                                phi_6898_ = _e7759;
                                phi_1973_ = _e9211;
                                phi_1975_ = _e9213;
                                phi_1977_ = _e9215;
                                phi_6899_ = _e9217;
                                phi_6900_ = _e9219;
                                phi_6901_ = _e7759;
                                phi_6902_ = _e9221;
                                phi_6903_ = _e9223;
                                phi_6904_ = _e9225;
                                phi_6905_ = _e9227;
                                phi_6906_ = _e9229;
                                phi_6907_ = false;
                                phi_6908_ = _e9231;
                            } else {
                                phi_6898_ = f32();
                                phi_1973_ = f32();
                                phi_1975_ = u32();
                                phi_1977_ = f32();
                                phi_6899_ = type_40();
                                phi_6900_ = u32();
                                phi_6901_ = f32();
                                phi_6902_ = u32();
                                phi_6903_ = false;
                                phi_6904_ = false;
                                phi_6905_ = false;
                                phi_6906_ = false;
                                phi_6907_ = true;
                                phi_6908_ = false;
                            }
                            let _e9233 = phi_6898_;
                            let _e9235 = phi_1973_;
                            let _e9237 = phi_1975_;
                            let _e9239 = phi_1977_;
                            let _e9241 = phi_6899_;
                            let _e9243 = phi_6900_;
                            let _e9245 = phi_6901_;
                            let _e9247 = phi_6902_;
                            let _e9249 = phi_6903_;
                            let _e9251 = phi_6904_;
                            let _e9253 = phi_6905_;
                            let _e9255 = phi_6906_;
                            let _e9257 = phi_6907_;
                            let _e9259 = phi_6908_;
                            local_57 = _e9251;
                            local_89 = _e9253;
                            local_90 = _e9255;
                            local_91 = _e9257;
                            local_92 = _e9259;
                            local_58 = _e9241;
                            local_59 = _e9241;
                            local_93 = _e9243;
                            local_60 = _e9241;
                            local_94 = _e9251;
                            local_95 = _e9247;
                            local_97 = _e9245;
                            local_98 = _e9233;
                            continue;
                            continuing {
                                phi_1969_ = _e5993;
                                phi_1972_ = _e9235;
                                phi_1974_ = _e9237;
                                phi_1976_ = _e9239;
                                break if !(_e9249);
                            }
                        }
                        let _e9262 = local_57;
                        if _e9262 {
                            phi_6912_ = false;
                            phi_6913_ = false;
                            phi_6914_ = false;
                            phi_6915_ = false;
                        } else {
                            let _e11467 = local_89;
                            phi_6912_ = _e11467;
                            let _e11470 = local_90;
                            phi_6913_ = _e11470;
                            let _e11473 = local_91;
                            phi_6914_ = _e11473;
                            let _e11476 = local_92;
                            phi_6915_ = _e11476;
                        }
                        let _e9264 = phi_6912_;
                        let _e9266 = phi_6913_;
                        let _e9268 = phi_6914_;
                        let _e9270 = phi_6915_;
                        if _e9264 {
                            let _e9272 = local_58;
                            if (_e9272.member_1 >= _e324) {
                                phi_6937_ = type_39(type_30(0u, f32()), 0u);
                            } else {
                                let _e9276 = local_59;
                                if (_e9276.member_1 > _e322) {
                                    phi_6932_ = 0u;
                                } else {
                                    let _e11481 = local_93;
                                    phi_6932_ = _e11481;
                                }
                                let _e9280 = phi_6932_;
                                let _e9282 = local_60;
                                phi_6937_ = type_39(type_30(2u, _e9282.member_1), _e9280);
                            }
                            let _e9289 = phi_6937_;
                            phi_6938_ = _e9289;
                            phi_6939_ = false;
                            phi_6940_ = false;
                            phi_6941_ = false;
                            phi_6942_ = false;
                        } else {
                            phi_6938_ = type_39();
                            phi_6939_ = _e9266;
                            let _e11488 = local_94;
                            phi_6940_ = _e11488;
                            phi_6941_ = _e9268;
                            phi_6942_ = _e9270;
                        }
                        let _e9291 = phi_6938_;
                        let _e9293 = phi_6939_;
                        let _e9295 = phi_6940_;
                        let _e9297 = phi_6941_;
                        let _e9299 = phi_6942_;
                        if _e9293 {
                            let _e11493 = local_95;
                            phi_6946_ = _e11493;
                            let _e11498 = local_97;
                            phi_6947_ = _e11498;
                            phi_6948_ = true;
                            phi_6949_ = false;
                            phi_6950_ = false;
                            phi_6951_ = false;
                        } else {
                            let _e11495 = local_96;
                            phi_6946_ = _e11495;
                            let _e11500 = local_98;
                            phi_6947_ = _e11500;
                            phi_6948_ = _e9295;
                            phi_6949_ = _e9297;
                            phi_6950_ = _e9299;
                            phi_6951_ = _e9264;
                        }
                        let _e9301 = phi_6946_;
                        let _e9303 = phi_6947_;
                        let _e9305 = phi_6948_;
                        let _e9307 = phi_6949_;
                        let _e9309 = phi_6950_;
                        let _e9311 = phi_6951_;
                        if _e9305 {
                            phi_6955_ = _e9303;
                            phi_6956_ = _e9301;
                            phi_6957_ = true;
                            phi_6958_ = false;
                            phi_6959_ = false;
                        } else {
                            let _e11507 = local_99;
                            phi_6955_ = _e11507;
                            let _e11510 = local_100;
                            phi_6956_ = _e11510;
                            phi_6957_ = _e9307;
                            phi_6958_ = _e9309;
                            phi_6959_ = _e9311;
                        }
                        let _e9313 = phi_6955_;
                        let _e9315 = phi_6956_;
                        let _e9317 = phi_6957_;
                        let _e9319 = phi_6958_;
                        let _e9321 = phi_6959_;
                        if _e9317 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e320 >= (0.000000059604645f * 8f)) {
                                phi_6971_ = _e320;
                            } else {
                                phi_6971_ = 0f;
                            }
                            let _e9328 = phi_6971_;
                            phi_6974_ = type_12(0u, 3u);
                            loop {
                                let _e9330 = phi_6974_;
                                if (_e9330.member < _e9330.member_1) {
                                    phi_6975_ = type_12((_e9330.member + 1u), _e9330.member_1);
                                    phi_6998_ = type_12(1u, _e9330.member);
                                } else {
                                    phi_6975_ = _e9330;
                                    phi_6998_ = type_12(0u, type_12().member_1);
                                }
                                let _e9342 = phi_6975_;
                                let _e9344 = phi_6998_;
                                if (bitcast<i32>(_e9344.member) != 0i) {
                                    let _e9350 = local_13[_e9344.member_1];
                                    let _e9352 = (_e9313 + (_e9328 * _e9350));
                                    if (_e9352 < _e324) {
                                        phi_7019_ = _e9352;
                                    } else {
                                        phi_7019_ = _e324;
                                    }
                                    let _e9355 = phi_7019_;
                                    let _e9358 = local_18.member[0u];
                                    let _e9364 = local_18.member[1u];
                                    let _e9380 = local_18.member_1[0u];
                                    let _e9386 = local_18.member_1[1u];
                                    let _e9402 = local_18.member_2[0u];
                                    let _e9408 = local_18.member_2[1u];
                                    let _e9422 = function_3(array<f32, 3>((_e9358[0] + ((_e9364[0] - _e9358[0]) * _e9355)), (_e9358[1] + ((_e9364[1] - _e9358[1]) * _e9355)), (_e9358[2] + ((_e9364[2] - _e9358[2]) * _e9355))), array<f32, 3>((_e9380[0] + ((_e9386[0] - _e9380[0]) * _e9355)), (_e9380[1] + ((_e9386[1] - _e9380[1]) * _e9355)), (_e9380[2] + ((_e9386[2] - _e9380[2]) * _e9355))), array<f32, 3>((_e9402[0] + ((_e9408[0] - _e9402[0]) * _e9355)), (_e9402[1] + ((_e9408[1] - _e9402[1]) * _e9355)), (_e9402[2] + ((_e9408[2] - _e9402[2]) * _e9355))), 1u);
                                    let _e9433 = (((_e9422[0] * _e9422[0]) + (_e9422[1] * _e9422[1])) + (_e9422[2] * _e9422[2]));
                                    if (_e9433 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e9433 > 0f) {
                                            phi_7142_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_7142_ = 0f;
                                        }
                                        let _e9486 = phi_7142_;
                                        phi_7206_ = _e9486;
                                    } else {
                                        phi_7149_ = type_14(0i, 5i);
                                        phi_7152_ = bitcast<f32>(((bitcast<u32>(_e9433) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e9441 = phi_7149_;
                                            let _e9443 = phi_7152_;
                                            local_61 = _e9443;
                                            if (_e9441.member < _e9441.member_1) {
                                                let _e9450 = (_e9441.member + 1i);
                                                if ((false == (_e9450 > _e9441.member)) != false) {
                                                    phi_7173_ = true;
                                                } else {
                                                    phi_7173_ = false;
                                                }
                                                let _e9455 = phi_7173_;
                                                if _e9455 {
                                                    phi_7179_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_7179_ = type_15(1u, _e9450);
                                                }
                                                let _e9460 = phi_7179_;
                                                phi_7150_ = type_14(_e9460.member_1, _e9441.member_1);
                                                phi_7193_ = type_15(1u, _e9441.member);
                                            } else {
                                                phi_7150_ = _e9441;
                                                phi_7193_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e9466 = phi_7150_;
                                            let _e9468 = phi_7193_;
                                            let _e9471 = (bitcast<i32>(_e9468.member) != 0i);
                                            if _e9471 {
                                                phi_7153_ = (0.5f * (_e9443 + (_e9433 / _e9443)));
                                            } else {
                                                phi_7153_ = f32();
                                            }
                                            let _e9476 = phi_7153_;
                                            continue;
                                            continuing {
                                                phi_7149_ = _e9466;
                                                phi_7152_ = _e9476;
                                                break if !(_e9471);
                                            }
                                        }
                                        let _e9481 = local_61;
                                        phi_7206_ = (_e9481 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e9488 = phi_7206_;
                                    let _e9494 = local_18.member[0u];
                                    if (_e9494[0] < 0f) {
                                        phi_7222_ = -(_e9494[0]);
                                    } else {
                                        phi_7222_ = _e9494[0];
                                    }
                                    let _e9501 = phi_7222_;
                                    if (_e9494[1] < 0f) {
                                        phi_7229_ = -(_e9494[1]);
                                    } else {
                                        phi_7229_ = _e9494[1];
                                    }
                                    let _e9505 = phi_7229_;
                                    if (_e9501 > _e9505) {
                                        phi_7234_ = _e9501;
                                    } else {
                                        phi_7234_ = _e9505;
                                    }
                                    let _e9508 = phi_7234_;
                                    if (_e9494[2] < 0f) {
                                        phi_7241_ = -(_e9494[2]);
                                    } else {
                                        phi_7241_ = _e9494[2];
                                    }
                                    let _e9512 = phi_7241_;
                                    if (_e9508 > _e9512) {
                                        phi_7246_ = _e9508;
                                    } else {
                                        phi_7246_ = _e9512;
                                    }
                                    let _e9515 = phi_7246_;
                                    let _e9518 = local_18.member[1u];
                                    if (_e9518[0] < 0f) {
                                        phi_7259_ = -(_e9518[0]);
                                    } else {
                                        phi_7259_ = _e9518[0];
                                    }
                                    let _e9525 = phi_7259_;
                                    if (_e9518[1] < 0f) {
                                        phi_7266_ = -(_e9518[1]);
                                    } else {
                                        phi_7266_ = _e9518[1];
                                    }
                                    let _e9529 = phi_7266_;
                                    if (_e9525 > _e9529) {
                                        phi_7271_ = _e9525;
                                    } else {
                                        phi_7271_ = _e9529;
                                    }
                                    let _e9532 = phi_7271_;
                                    if (_e9518[2] < 0f) {
                                        phi_7278_ = -(_e9518[2]);
                                    } else {
                                        phi_7278_ = _e9518[2];
                                    }
                                    let _e9536 = phi_7278_;
                                    if (_e9532 > _e9536) {
                                        phi_7283_ = _e9532;
                                    } else {
                                        phi_7283_ = _e9536;
                                    }
                                    let _e9539 = phi_7283_;
                                    if (_e9515 > _e9539) {
                                        phi_7288_ = _e9515;
                                    } else {
                                        phi_7288_ = _e9539;
                                    }
                                    let _e9542 = phi_7288_;
                                    let _e9544 = local_18.member_3;
                                    let _e9548 = local_18.member_1[0u];
                                    if (_e9548[0] < 0f) {
                                        phi_7305_ = -(_e9548[0]);
                                    } else {
                                        phi_7305_ = _e9548[0];
                                    }
                                    let _e9555 = phi_7305_;
                                    if (_e9548[1] < 0f) {
                                        phi_7312_ = -(_e9548[1]);
                                    } else {
                                        phi_7312_ = _e9548[1];
                                    }
                                    let _e9559 = phi_7312_;
                                    if (_e9555 > _e9559) {
                                        phi_7317_ = _e9555;
                                    } else {
                                        phi_7317_ = _e9559;
                                    }
                                    let _e9562 = phi_7317_;
                                    if (_e9548[2] < 0f) {
                                        phi_7324_ = -(_e9548[2]);
                                    } else {
                                        phi_7324_ = _e9548[2];
                                    }
                                    let _e9566 = phi_7324_;
                                    if (_e9562 > _e9566) {
                                        phi_7329_ = _e9562;
                                    } else {
                                        phi_7329_ = _e9566;
                                    }
                                    let _e9569 = phi_7329_;
                                    let _e9572 = local_18.member_1[1u];
                                    if (_e9572[0] < 0f) {
                                        phi_7343_ = -(_e9572[0]);
                                    } else {
                                        phi_7343_ = _e9572[0];
                                    }
                                    let _e9579 = phi_7343_;
                                    if (_e9572[1] < 0f) {
                                        phi_7350_ = -(_e9572[1]);
                                    } else {
                                        phi_7350_ = _e9572[1];
                                    }
                                    let _e9583 = phi_7350_;
                                    if (_e9579 > _e9583) {
                                        phi_7355_ = _e9579;
                                    } else {
                                        phi_7355_ = _e9583;
                                    }
                                    let _e9586 = phi_7355_;
                                    if (_e9572[2] < 0f) {
                                        phi_7362_ = -(_e9572[2]);
                                    } else {
                                        phi_7362_ = _e9572[2];
                                    }
                                    let _e9590 = phi_7362_;
                                    if (_e9586 > _e9590) {
                                        phi_7367_ = _e9586;
                                    } else {
                                        phi_7367_ = _e9590;
                                    }
                                    let _e9593 = phi_7367_;
                                    if (_e9569 > _e9593) {
                                        phi_7372_ = _e9569;
                                    } else {
                                        phi_7372_ = _e9593;
                                    }
                                    let _e9596 = phi_7372_;
                                    let _e9598 = local_18.member_3;
                                    let _e9602 = local_18.member_2[0u];
                                    if (_e9602[0] < 0f) {
                                        phi_7389_ = -(_e9602[0]);
                                    } else {
                                        phi_7389_ = _e9602[0];
                                    }
                                    let _e9609 = phi_7389_;
                                    if (_e9602[1] < 0f) {
                                        phi_7396_ = -(_e9602[1]);
                                    } else {
                                        phi_7396_ = _e9602[1];
                                    }
                                    let _e9613 = phi_7396_;
                                    if (_e9609 > _e9613) {
                                        phi_7401_ = _e9609;
                                    } else {
                                        phi_7401_ = _e9613;
                                    }
                                    let _e9616 = phi_7401_;
                                    if (_e9602[2] < 0f) {
                                        phi_7408_ = -(_e9602[2]);
                                    } else {
                                        phi_7408_ = _e9602[2];
                                    }
                                    let _e9620 = phi_7408_;
                                    if (_e9616 > _e9620) {
                                        phi_7413_ = _e9616;
                                    } else {
                                        phi_7413_ = _e9620;
                                    }
                                    let _e9623 = phi_7413_;
                                    let _e9626 = local_18.member_2[1u];
                                    if (_e9626[0] < 0f) {
                                        phi_7427_ = -(_e9626[0]);
                                    } else {
                                        phi_7427_ = _e9626[0];
                                    }
                                    let _e9633 = phi_7427_;
                                    if (_e9626[1] < 0f) {
                                        phi_7434_ = -(_e9626[1]);
                                    } else {
                                        phi_7434_ = _e9626[1];
                                    }
                                    let _e9637 = phi_7434_;
                                    if (_e9633 > _e9637) {
                                        phi_7439_ = _e9633;
                                    } else {
                                        phi_7439_ = _e9637;
                                    }
                                    let _e9640 = phi_7439_;
                                    if (_e9626[2] < 0f) {
                                        phi_7446_ = -(_e9626[2]);
                                    } else {
                                        phi_7446_ = _e9626[2];
                                    }
                                    let _e9644 = phi_7446_;
                                    if (_e9640 > _e9644) {
                                        phi_7451_ = _e9640;
                                    } else {
                                        phi_7451_ = _e9644;
                                    }
                                    let _e9647 = phi_7451_;
                                    if (_e9623 > _e9647) {
                                        phi_7456_ = _e9623;
                                    } else {
                                        phi_7456_ = _e9647;
                                    }
                                    let _e9650 = phi_7456_;
                                    let _e9652 = local_18.member_3;
                                    let _e9659 = local_18.member_3;
                                    let _e9666 = (((_e9488 * (1f + (0.000000059604645f * 8f))) + (((((((_e9542 + _e9544) + (_e9596 + _e9598)) + (_e9650 + _e9652)) * (0.000000059604645f * 16f)) + (_e9659 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e524.member_1);
                                    if _e9666 {
                                        phi_7476_ = false;
                                    } else {
                                        phi_7476_ = true;
                                    }
                                    let _e9668 = phi_7476_;
                                    phi_7477_ = _e9668;
                                    phi_7478_ = _e9666;
                                } else {
                                    phi_7477_ = false;
                                    phi_7478_ = false;
                                }
                                let _e9670 = phi_7477_;
                                let _e9672 = phi_7478_;
                                local_62 = _e9672;
                                continue;
                                continuing {
                                    phi_6974_ = _e9342;
                                    break if !(_e9670);
                                }
                            }
                            let _e9675 = local_62;
                            if _e9675 {
                                if (_e9313 > _e322) {
                                    phi_7486_ = 1u;
                                } else {
                                    phi_7486_ = _e9315;
                                }
                                let _e9678 = phi_7486_;
                                phi_7490_ = type_39(type_30(1u, _e9313), _e9678);
                                phi_7491_ = false;
                            } else {
                                phi_7490_ = type_39();
                                phi_7491_ = true;
                            }
                            let _e9682 = phi_7490_;
                            let _e9684 = phi_7491_;
                            if _e9684 {
                                if (_e9313 > _e322) {
                                    phi_7499_ = 0u;
                                } else {
                                    phi_7499_ = _e9315;
                                }
                                let _e9687 = phi_7499_;
                                phi_7503_ = type_39(type_30(2u, _e9313), _e9687);
                            } else {
                                phi_7503_ = _e9682;
                            }
                            let _e9691 = phi_7503_;
                            phi_7504_ = _e9691;
                            phi_7505_ = false;
                            phi_7506_ = false;
                        } else {
                            phi_7504_ = type_39();
                            phi_7505_ = _e9319;
                            phi_7506_ = _e9321;
                        }
                        let _e9693 = phi_7504_;
                        let _e9695 = phi_7505_;
                        let _e9697 = phi_7506_;
                        if _e9695 {
                            phi_7513_ = type_39(type_30(0u, f32()), 0u);
                            phi_7514_ = true;
                        } else {
                            phi_7513_ = _e9291;
                            phi_7514_ = _e9697;
                        }
                        let _e9701 = phi_7513_;
                        let _e9703 = phi_7514_;
                        phi_7518_ = _e9701;
                        phi_7519_ = _e9693;
                        phi_7520_ = _e9703;
                    } else {
                        phi_7518_ = _e5960;
                        phi_7519_ = type_39();
                        phi_7520_ = true;
                    }
                    let _e9705 = phi_7518_;
                    let _e9707 = phi_7519_;
                    let _e9709 = phi_7520_;
                    if _e9709 {
                        phi_7524_ = _e9705;
                    } else {
                        phi_7524_ = _e9707;
                    }
                    let _e9711 = phi_7524_;
                    phi_15039_ = _e9711;
                } else {
                    let _e568 = local_18.member_1[0u];
                    let _e574 = local_18.member_2[0u];
                    let _e580 = ((_e568[1] * _e574[2]) - (_e568[2] * _e574[1]));
                    let _e583 = ((_e568[2] * _e574[0]) - (_e568[0] * _e574[2]));
                    let _e586 = ((_e568[0] * _e574[1]) - (_e568[1] * _e574[0]));
                    let _e589 = local_18.member_1[1u];
                    let _e595 = local_18.member_2[1u];
                    let _e601 = ((_e589[1] * _e595[2]) - (_e589[2] * _e595[1]));
                    let _e604 = ((_e589[2] * _e595[0]) - (_e589[0] * _e595[2]));
                    let _e607 = ((_e589[0] * _e595[1]) - (_e589[1] * _e595[0]));
                    let _e610 = local_18.member_1[0u];
                    let _e616 = local_18.member_2[1u];
                    let _e631 = local_18.member_1[1u];
                    let _e637 = local_18.member_2[0u];
                    let _e650 = (((_e610[1] * _e616[2]) - (_e610[2] * _e616[1])) + ((_e631[1] * _e637[2]) - (_e631[2] * _e637[1])));
                    let _e651 = (((_e610[2] * _e616[0]) - (_e610[0] * _e616[2])) + ((_e631[2] * _e637[0]) - (_e631[0] * _e637[2])));
                    let _e652 = (((_e610[0] * _e616[1]) - (_e610[1] * _e616[0])) + ((_e631[0] * _e637[1]) - (_e631[1] * _e637[0])));
                    let _e655 = local_18.member[0u];
                    let _e663 = (((_e655[0] * _e580) + (_e655[1] * _e583)) + (_e655[2] * _e586));
                    let _e666 = local_18.member[1u];
                    let _e677 = local_18.member[0u];
                    let _e686 = ((((_e666[0] * _e580) + (_e666[1] * _e583)) + (_e666[2] * _e586)) + (((_e677[0] * _e650) + (_e677[1] * _e651)) + (_e677[2] * _e652)));
                    let _e689 = local_18.member[0u];
                    let _e700 = local_18.member[1u];
                    let _e709 = ((((_e689[0] * _e601) + (_e689[1] * _e604)) + (_e689[2] * _e607)) + (((_e700[0] * _e650) + (_e700[1] * _e651)) + (_e700[2] * _e652)));
                    let _e712 = local_18.member[1u];
                    let _e720 = (((_e712[0] * _e601) + (_e712[1] * _e604)) + (_e712[2] * _e607));
                    let _e723 = local_18.member[0u];
                    if (_e723[0] < 0f) {
                        phi_7766_ = -(_e723[0]);
                    } else {
                        phi_7766_ = _e723[0];
                    }
                    let _e730 = phi_7766_;
                    if (_e723[1] < 0f) {
                        phi_7773_ = -(_e723[1]);
                    } else {
                        phi_7773_ = _e723[1];
                    }
                    let _e734 = phi_7773_;
                    if (_e730 > _e734) {
                        phi_7778_ = _e730;
                    } else {
                        phi_7778_ = _e734;
                    }
                    let _e737 = phi_7778_;
                    if (_e723[2] < 0f) {
                        phi_7785_ = -(_e723[2]);
                    } else {
                        phi_7785_ = _e723[2];
                    }
                    let _e741 = phi_7785_;
                    if (_e737 > _e741) {
                        phi_7790_ = _e737;
                    } else {
                        phi_7790_ = _e741;
                    }
                    let _e744 = phi_7790_;
                    let _e747 = local_18.member[1u];
                    if (_e747[0] < 0f) {
                        phi_7803_ = -(_e747[0]);
                    } else {
                        phi_7803_ = _e747[0];
                    }
                    let _e754 = phi_7803_;
                    if (_e747[1] < 0f) {
                        phi_7810_ = -(_e747[1]);
                    } else {
                        phi_7810_ = _e747[1];
                    }
                    let _e758 = phi_7810_;
                    if (_e754 > _e758) {
                        phi_7815_ = _e754;
                    } else {
                        phi_7815_ = _e758;
                    }
                    let _e761 = phi_7815_;
                    if (_e747[2] < 0f) {
                        phi_7822_ = -(_e747[2]);
                    } else {
                        phi_7822_ = _e747[2];
                    }
                    let _e765 = phi_7822_;
                    if (_e761 > _e765) {
                        phi_7827_ = _e761;
                    } else {
                        phi_7827_ = _e765;
                    }
                    let _e768 = phi_7827_;
                    if (_e744 > _e768) {
                        phi_7832_ = _e744;
                    } else {
                        phi_7832_ = _e768;
                    }
                    let _e771 = phi_7832_;
                    let _e773 = local_18.member_3;
                    let _e774 = (_e771 + _e773);
                    let _e777 = local_18.member_1[0u];
                    if (_e777[0] < 0f) {
                        phi_7849_ = -(_e777[0]);
                    } else {
                        phi_7849_ = _e777[0];
                    }
                    let _e784 = phi_7849_;
                    if (_e777[1] < 0f) {
                        phi_7856_ = -(_e777[1]);
                    } else {
                        phi_7856_ = _e777[1];
                    }
                    let _e788 = phi_7856_;
                    if (_e784 > _e788) {
                        phi_7861_ = _e784;
                    } else {
                        phi_7861_ = _e788;
                    }
                    let _e791 = phi_7861_;
                    if (_e777[2] < 0f) {
                        phi_7868_ = -(_e777[2]);
                    } else {
                        phi_7868_ = _e777[2];
                    }
                    let _e795 = phi_7868_;
                    if (_e791 > _e795) {
                        phi_7873_ = _e791;
                    } else {
                        phi_7873_ = _e795;
                    }
                    let _e798 = phi_7873_;
                    let _e801 = local_18.member_1[1u];
                    if (_e801[0] < 0f) {
                        phi_7887_ = -(_e801[0]);
                    } else {
                        phi_7887_ = _e801[0];
                    }
                    let _e808 = phi_7887_;
                    if (_e801[1] < 0f) {
                        phi_7894_ = -(_e801[1]);
                    } else {
                        phi_7894_ = _e801[1];
                    }
                    let _e812 = phi_7894_;
                    if (_e808 > _e812) {
                        phi_7899_ = _e808;
                    } else {
                        phi_7899_ = _e812;
                    }
                    let _e815 = phi_7899_;
                    if (_e801[2] < 0f) {
                        phi_7906_ = -(_e801[2]);
                    } else {
                        phi_7906_ = _e801[2];
                    }
                    let _e819 = phi_7906_;
                    if (_e815 > _e819) {
                        phi_7911_ = _e815;
                    } else {
                        phi_7911_ = _e819;
                    }
                    let _e822 = phi_7911_;
                    if (_e798 > _e822) {
                        phi_7916_ = _e798;
                    } else {
                        phi_7916_ = _e822;
                    }
                    let _e825 = phi_7916_;
                    let _e827 = local_18.member_3;
                    let _e828 = (_e825 + _e827);
                    let _e831 = local_18.member_2[0u];
                    if (_e831[0] < 0f) {
                        phi_7933_ = -(_e831[0]);
                    } else {
                        phi_7933_ = _e831[0];
                    }
                    let _e838 = phi_7933_;
                    if (_e831[1] < 0f) {
                        phi_7940_ = -(_e831[1]);
                    } else {
                        phi_7940_ = _e831[1];
                    }
                    let _e842 = phi_7940_;
                    if (_e838 > _e842) {
                        phi_7945_ = _e838;
                    } else {
                        phi_7945_ = _e842;
                    }
                    let _e845 = phi_7945_;
                    if (_e831[2] < 0f) {
                        phi_7952_ = -(_e831[2]);
                    } else {
                        phi_7952_ = _e831[2];
                    }
                    let _e849 = phi_7952_;
                    if (_e845 > _e849) {
                        phi_7957_ = _e845;
                    } else {
                        phi_7957_ = _e849;
                    }
                    let _e852 = phi_7957_;
                    let _e855 = local_18.member_2[1u];
                    if (_e855[0] < 0f) {
                        phi_7971_ = -(_e855[0]);
                    } else {
                        phi_7971_ = _e855[0];
                    }
                    let _e862 = phi_7971_;
                    if (_e855[1] < 0f) {
                        phi_7978_ = -(_e855[1]);
                    } else {
                        phi_7978_ = _e855[1];
                    }
                    let _e866 = phi_7978_;
                    if (_e862 > _e866) {
                        phi_7983_ = _e862;
                    } else {
                        phi_7983_ = _e866;
                    }
                    let _e869 = phi_7983_;
                    if (_e855[2] < 0f) {
                        phi_7990_ = -(_e855[2]);
                    } else {
                        phi_7990_ = _e855[2];
                    }
                    let _e873 = phi_7990_;
                    if (_e869 > _e873) {
                        phi_7995_ = _e869;
                    } else {
                        phi_7995_ = _e873;
                    }
                    let _e876 = phi_7995_;
                    if (_e852 > _e876) {
                        phi_8000_ = _e852;
                    } else {
                        phi_8000_ = _e876;
                    }
                    let _e879 = phi_8000_;
                    let _e881 = local_18.member_3;
                    let _e882 = (_e879 + _e881);
                    let _e884 = ((_e828 * 8f) * _e882);
                    let _e891 = local_18.member_3;
                    if (_e580 < 0f) {
                        phi_8031_ = -(_e580);
                    } else {
                        phi_8031_ = _e580;
                    }
                    let _e908 = phi_8031_;
                    if (_e583 < 0f) {
                        phi_8037_ = -(_e583);
                    } else {
                        phi_8037_ = _e583;
                    }
                    let _e912 = phi_8037_;
                    if (_e586 < 0f) {
                        phi_8044_ = -(_e586);
                    } else {
                        phi_8044_ = _e586;
                    }
                    let _e917 = phi_8044_;
                    let _e918 = ((_e908 + _e912) + _e917);
                    if (_e601 < 0f) {
                        phi_8051_ = -(_e601);
                    } else {
                        phi_8051_ = _e601;
                    }
                    let _e922 = phi_8051_;
                    if (_e604 < 0f) {
                        phi_8057_ = -(_e604);
                    } else {
                        phi_8057_ = _e604;
                    }
                    let _e926 = phi_8057_;
                    if (_e607 < 0f) {
                        phi_8064_ = -(_e607);
                    } else {
                        phi_8064_ = _e607;
                    }
                    let _e931 = phi_8064_;
                    let _e932 = ((_e922 + _e926) + _e931);
                    if (_e918 > _e932) {
                        phi_8070_ = _e918;
                    } else {
                        phi_8070_ = _e932;
                    }
                    let _e935 = phi_8070_;
                    if (_e650 < 0f) {
                        phi_8076_ = -(_e650);
                    } else {
                        phi_8076_ = _e650;
                    }
                    let _e939 = phi_8076_;
                    if (_e651 < 0f) {
                        phi_8082_ = -(_e651);
                    } else {
                        phi_8082_ = _e651;
                    }
                    let _e943 = phi_8082_;
                    if (_e652 < 0f) {
                        phi_8089_ = -(_e652);
                    } else {
                        phi_8089_ = _e652;
                    }
                    let _e948 = phi_8089_;
                    let _e950 = (((_e939 + _e943) + _e948) * 0.5f);
                    if (_e935 > _e950) {
                        phi_8096_ = _e935;
                    } else {
                        phi_8096_ = _e950;
                    }
                    let _e953 = phi_8096_;
                    let _e958 = local_18.member_3;
                    let _e970 = (((((_e774 * 8f) * _e884) * (0.000000059604645f * (524f / 64f))) + ((_e891 * 19f) * ((_e774 * (_e828 + _e882)) + (_e828 * _e882)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e774) * ((1f + _e828) * (1f + _e882)))));
                    let _e971 = (_e663 * 3f);
                    let _e972 = (_e720 * 3f);
                    if (_e971 < _e972) {
                        phi_8120_ = _e971;
                    } else {
                        phi_8120_ = _e972;
                    }
                    let _e975 = phi_8120_;
                    if (_e686 < _e709) {
                        phi_8125_ = _e686;
                    } else {
                        phi_8125_ = _e709;
                    }
                    let _e978 = phi_8125_;
                    if (_e975 < _e978) {
                        phi_8130_ = _e975;
                    } else {
                        phi_8130_ = _e978;
                    }
                    let _e981 = phi_8130_;
                    if (_e971 > _e972) {
                        phi_8135_ = _e971;
                    } else {
                        phi_8135_ = _e972;
                    }
                    let _e984 = phi_8135_;
                    if (_e686 > _e709) {
                        phi_8140_ = _e686;
                    } else {
                        phi_8140_ = _e709;
                    }
                    let _e987 = phi_8140_;
                    if (_e984 > _e987) {
                        phi_8145_ = _e984;
                    } else {
                        phi_8145_ = _e987;
                    }
                    let _e990 = phi_8145_;
                    let _e995 = -(_e990);
                    if (_e981 > _e995) {
                        phi_8155_ = _e981;
                    } else {
                        phi_8155_ = _e995;
                    }
                    let _e998 = phi_8155_;
                    if ((_e998 - (_e970 + ((0f * (((_e953 + (_e884 * (0.000000059604645f * 8f))) + ((_e958 * 6f) * (_e828 + _e882))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e828) * (1f + _e882))))) * (3f * 1.0001f)))) > 0f) {
                        phi_15009_ = type_30(0u, type_30().member_1);
                        phi_15010_ = type_30();
                        phi_15011_ = true;
                    } else {
                        if (_e663 < 0f) {
                            phi_8168_ = -(_e663);
                        } else {
                            phi_8168_ = _e663;
                        }
                        let _e1005 = phi_8168_;
                        if (_e686 < 0f) {
                            phi_8174_ = -(_e686);
                        } else {
                            phi_8174_ = _e686;
                        }
                        let _e1009 = phi_8174_;
                        if (_e1005 > _e1009) {
                            phi_8179_ = _e1005;
                        } else {
                            phi_8179_ = _e1009;
                        }
                        let _e1012 = phi_8179_;
                        if (_e709 < 0f) {
                            phi_8185_ = -(_e709);
                        } else {
                            phi_8185_ = _e709;
                        }
                        let _e1016 = phi_8185_;
                        if (_e720 < 0f) {
                            phi_8191_ = -(_e720);
                        } else {
                            phi_8191_ = _e720;
                        }
                        let _e1020 = phi_8191_;
                        if (_e1016 > _e1020) {
                            phi_8196_ = _e1016;
                        } else {
                            phi_8196_ = _e1020;
                        }
                        let _e1023 = phi_8196_;
                        if (_e1012 > _e1023) {
                            phi_8201_ = _e1012;
                        } else {
                            phi_8201_ = _e1023;
                        }
                        let _e1026 = phi_8201_;
                        let _e1027 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e1026 >= _e1027) {
                            phi_8209_ = (_e1026 <= (1f / _e1027));
                        } else {
                            phi_8209_ = false;
                        }
                        let _e1032 = phi_8209_;
                        if _e1032 {
                            phi_8214_ = (0.000000059604645f * 256f);
                        } else {
                            phi_8214_ = 2f;
                        }
                        let _e1035 = phi_8214_;
                        let _e1037 = ((_e970 * 0.34f) + (_e1026 * _e1035));
                        if _e1032 {
                            phi_8221_ = (1f / _e1026);
                        } else {
                            phi_8221_ = 0f;
                        }
                        let _e1040 = phi_8221_;
                        let _e1041 = (_e320 * 0.0625f);
                        if (0.00000000000022737368f < _e1041) {
                            phi_8227_ = 0.00000000000022737368f;
                        } else {
                            phi_8227_ = _e1041;
                        }
                        let _e1044 = phi_8227_;
                        let _e1045 = (1f - _e322);
                        let _e1056 = ((((_e663 * _e1045) + (_e686 * _e322)) * (_e1045 * _e1045)) + (((_e709 * _e1045) + (_e720 * _e322)) * (_e322 * _e322)));
                        if (_e1056 < 0f) {
                            phi_8245_ = -(_e1056);
                        } else {
                            phi_8245_ = _e1056;
                        }
                        let _e1060 = phi_8245_;
                        if !((_e1060 > _e1037)) {
                            let _e1065 = local_18.member[0u];
                            let _e1071 = local_18.member_1[0u];
                            let _e1077 = local_18.member_2[0u];
                            let _e1081 = (_e1065[0] - _e1071[0]);
                            let _e1082 = (_e1065[1] - _e1071[1]);
                            let _e1083 = (_e1065[2] - _e1071[2]);
                            let _e1084 = (_e1081 - _e1077[0]);
                            let _e1085 = (_e1082 - _e1077[1]);
                            let _e1086 = (_e1083 - _e1077[2]);
                            let _e1087 = (_e1065[0] - _e1077[0]);
                            let _e1088 = (_e1065[1] - _e1077[1]);
                            let _e1089 = (_e1065[2] - _e1077[2]);
                            let _e1092 = local_18.member[1u];
                            let _e1098 = local_18.member_1[1u];
                            let _e1104 = local_18.member_2[1u];
                            let _e1108 = (_e1092[0] - _e1098[0]);
                            let _e1109 = (_e1092[1] - _e1098[1]);
                            let _e1110 = (_e1092[2] - _e1098[2]);
                            let _e1111 = (_e1108 - _e1104[0]);
                            let _e1112 = (_e1109 - _e1104[1]);
                            let _e1113 = (_e1110 - _e1104[2]);
                            let _e1114 = (_e1092[0] - _e1104[0]);
                            let _e1115 = (_e1092[1] - _e1104[1]);
                            let _e1116 = (_e1092[2] - _e1104[2]);
                            let _e1119 = local_18.member[0u];
                            if (_e1119[0] < 0f) {
                                phi_8393_ = -(_e1119[0]);
                            } else {
                                phi_8393_ = _e1119[0];
                            }
                            let _e1126 = phi_8393_;
                            if (_e1119[1] < 0f) {
                                phi_8400_ = -(_e1119[1]);
                            } else {
                                phi_8400_ = _e1119[1];
                            }
                            let _e1130 = phi_8400_;
                            if (_e1126 > _e1130) {
                                phi_8405_ = _e1126;
                            } else {
                                phi_8405_ = _e1130;
                            }
                            let _e1133 = phi_8405_;
                            if (_e1119[2] < 0f) {
                                phi_8412_ = -(_e1119[2]);
                            } else {
                                phi_8412_ = _e1119[2];
                            }
                            let _e1137 = phi_8412_;
                            if (_e1133 > _e1137) {
                                phi_8417_ = _e1133;
                            } else {
                                phi_8417_ = _e1137;
                            }
                            let _e1140 = phi_8417_;
                            let _e1143 = local_18.member[1u];
                            if (_e1143[0] < 0f) {
                                phi_8430_ = -(_e1143[0]);
                            } else {
                                phi_8430_ = _e1143[0];
                            }
                            let _e1150 = phi_8430_;
                            if (_e1143[1] < 0f) {
                                phi_8437_ = -(_e1143[1]);
                            } else {
                                phi_8437_ = _e1143[1];
                            }
                            let _e1154 = phi_8437_;
                            if (_e1150 > _e1154) {
                                phi_8442_ = _e1150;
                            } else {
                                phi_8442_ = _e1154;
                            }
                            let _e1157 = phi_8442_;
                            if (_e1143[2] < 0f) {
                                phi_8449_ = -(_e1143[2]);
                            } else {
                                phi_8449_ = _e1143[2];
                            }
                            let _e1161 = phi_8449_;
                            if (_e1157 > _e1161) {
                                phi_8454_ = _e1157;
                            } else {
                                phi_8454_ = _e1161;
                            }
                            let _e1164 = phi_8454_;
                            if (_e1140 > _e1164) {
                                phi_8459_ = _e1140;
                            } else {
                                phi_8459_ = _e1164;
                            }
                            let _e1167 = phi_8459_;
                            let _e1169 = local_18.member_3;
                            let _e1173 = local_18.member_1[0u];
                            if (_e1173[0] < 0f) {
                                phi_8476_ = -(_e1173[0]);
                            } else {
                                phi_8476_ = _e1173[0];
                            }
                            let _e1180 = phi_8476_;
                            if (_e1173[1] < 0f) {
                                phi_8483_ = -(_e1173[1]);
                            } else {
                                phi_8483_ = _e1173[1];
                            }
                            let _e1184 = phi_8483_;
                            if (_e1180 > _e1184) {
                                phi_8488_ = _e1180;
                            } else {
                                phi_8488_ = _e1184;
                            }
                            let _e1187 = phi_8488_;
                            if (_e1173[2] < 0f) {
                                phi_8495_ = -(_e1173[2]);
                            } else {
                                phi_8495_ = _e1173[2];
                            }
                            let _e1191 = phi_8495_;
                            if (_e1187 > _e1191) {
                                phi_8500_ = _e1187;
                            } else {
                                phi_8500_ = _e1191;
                            }
                            let _e1194 = phi_8500_;
                            let _e1197 = local_18.member_1[1u];
                            if (_e1197[0] < 0f) {
                                phi_8514_ = -(_e1197[0]);
                            } else {
                                phi_8514_ = _e1197[0];
                            }
                            let _e1204 = phi_8514_;
                            if (_e1197[1] < 0f) {
                                phi_8521_ = -(_e1197[1]);
                            } else {
                                phi_8521_ = _e1197[1];
                            }
                            let _e1208 = phi_8521_;
                            if (_e1204 > _e1208) {
                                phi_8526_ = _e1204;
                            } else {
                                phi_8526_ = _e1208;
                            }
                            let _e1211 = phi_8526_;
                            if (_e1197[2] < 0f) {
                                phi_8533_ = -(_e1197[2]);
                            } else {
                                phi_8533_ = _e1197[2];
                            }
                            let _e1215 = phi_8533_;
                            if (_e1211 > _e1215) {
                                phi_8538_ = _e1211;
                            } else {
                                phi_8538_ = _e1215;
                            }
                            let _e1218 = phi_8538_;
                            if (_e1194 > _e1218) {
                                phi_8543_ = _e1194;
                            } else {
                                phi_8543_ = _e1218;
                            }
                            let _e1221 = phi_8543_;
                            let _e1223 = local_18.member_3;
                            let _e1227 = local_18.member_2[0u];
                            if (_e1227[0] < 0f) {
                                phi_8560_ = -(_e1227[0]);
                            } else {
                                phi_8560_ = _e1227[0];
                            }
                            let _e1234 = phi_8560_;
                            if (_e1227[1] < 0f) {
                                phi_8567_ = -(_e1227[1]);
                            } else {
                                phi_8567_ = _e1227[1];
                            }
                            let _e1238 = phi_8567_;
                            if (_e1234 > _e1238) {
                                phi_8572_ = _e1234;
                            } else {
                                phi_8572_ = _e1238;
                            }
                            let _e1241 = phi_8572_;
                            if (_e1227[2] < 0f) {
                                phi_8579_ = -(_e1227[2]);
                            } else {
                                phi_8579_ = _e1227[2];
                            }
                            let _e1245 = phi_8579_;
                            if (_e1241 > _e1245) {
                                phi_8584_ = _e1241;
                            } else {
                                phi_8584_ = _e1245;
                            }
                            let _e1248 = phi_8584_;
                            let _e1251 = local_18.member_2[1u];
                            if (_e1251[0] < 0f) {
                                phi_8598_ = -(_e1251[0]);
                            } else {
                                phi_8598_ = _e1251[0];
                            }
                            let _e1258 = phi_8598_;
                            if (_e1251[1] < 0f) {
                                phi_8605_ = -(_e1251[1]);
                            } else {
                                phi_8605_ = _e1251[1];
                            }
                            let _e1262 = phi_8605_;
                            if (_e1258 > _e1262) {
                                phi_8610_ = _e1258;
                            } else {
                                phi_8610_ = _e1262;
                            }
                            let _e1265 = phi_8610_;
                            if (_e1251[2] < 0f) {
                                phi_8617_ = -(_e1251[2]);
                            } else {
                                phi_8617_ = _e1251[2];
                            }
                            let _e1269 = phi_8617_;
                            if (_e1265 > _e1269) {
                                phi_8622_ = _e1265;
                            } else {
                                phi_8622_ = _e1269;
                            }
                            let _e1272 = phi_8622_;
                            if (_e1248 > _e1272) {
                                phi_8627_ = _e1248;
                            } else {
                                phi_8627_ = _e1272;
                            }
                            let _e1275 = phi_8627_;
                            let _e1277 = local_18.member_3;
                            let _e1284 = local_18.member_3;
                            let _e1288 = ((((((_e1167 + _e1169) + (_e1221 + _e1223)) + (_e1275 + _e1277)) * (0.000000059604645f * 16f)) + (_e1284 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e1291 = local_18.member[0u];
                            let _e1297 = local_18.member[1u];
                            let _e1313 = local_18.member_1[0u];
                            let _e1319 = local_18.member_1[1u];
                            let _e1335 = local_18.member_2[0u];
                            let _e1341 = local_18.member_2[1u];
                            let _e1355 = function_3(array<f32, 3>((_e1291[0] + ((_e1297[0] - _e1291[0]) * _e322)), (_e1291[1] + ((_e1297[1] - _e1291[1]) * _e322)), (_e1291[2] + ((_e1297[2] - _e1291[2]) * _e322))), array<f32, 3>((_e1313[0] + ((_e1319[0] - _e1313[0]) * _e322)), (_e1313[1] + ((_e1319[1] - _e1313[1]) * _e322)), (_e1313[2] + ((_e1319[2] - _e1313[2]) * _e322))), array<f32, 3>((_e1335[0] + ((_e1341[0] - _e1335[0]) * _e322)), (_e1335[1] + ((_e1341[1] - _e1335[1]) * _e322)), (_e1335[2] + ((_e1341[2] - _e1335[2]) * _e322))), 1u);
                            if (_e1355[0] < 0f) {
                                phi_8745_ = -(_e1355[0]);
                            } else {
                                phi_8745_ = _e1355[0];
                            }
                            let _e1360 = phi_8745_;
                            if (_e1355[1] < 0f) {
                                phi_8752_ = -(_e1355[1]);
                            } else {
                                phi_8752_ = _e1355[1];
                            }
                            let _e1365 = phi_8752_;
                            if (_e1355[2] < 0f) {
                                phi_8760_ = -(_e1355[2]);
                            } else {
                                phi_8760_ = _e1355[2];
                            }
                            let _e1371 = phi_8760_;
                            let _e1372 = ((_e1360 + _e1365) + _e1371);
                            if (_e1372 > 0f) {
                                if ((bitcast<u32>(_e1372) & 2139095040u) != 2139095040u) {
                                    let _e1377 = (1f / _e1372);
                                    let _e1379 = (_e1355[0] * _e1377);
                                    let _e1381 = (_e1355[1] * _e1377);
                                    let _e1383 = (_e1355[2] * _e1377);
                                    let _e1388 = (((_e1379 * _e1379) + (_e1381 * _e1381)) + (_e1383 * _e1383));
                                    if (_e1388 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1388 > 0f) {
                                            phi_8797_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_8797_ = 0f;
                                        }
                                        let _e1441 = phi_8797_;
                                        phi_8861_ = _e1441;
                                    } else {
                                        phi_8804_ = type_14(0i, 5i);
                                        phi_8807_ = bitcast<f32>(((bitcast<u32>(_e1388) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1396 = phi_8804_;
                                            let _e1398 = phi_8807_;
                                            local_19 = _e1398;
                                            if (_e1396.member < _e1396.member_1) {
                                                let _e1405 = (_e1396.member + 1i);
                                                if ((false == (_e1405 > _e1396.member)) != false) {
                                                    phi_8828_ = true;
                                                } else {
                                                    phi_8828_ = false;
                                                }
                                                let _e1410 = phi_8828_;
                                                if _e1410 {
                                                    phi_8834_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_8834_ = type_15(1u, _e1405);
                                                }
                                                let _e1415 = phi_8834_;
                                                phi_8805_ = type_14(_e1415.member_1, _e1396.member_1);
                                                phi_8848_ = type_15(1u, _e1396.member);
                                            } else {
                                                phi_8805_ = _e1396;
                                                phi_8848_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1421 = phi_8805_;
                                            let _e1423 = phi_8848_;
                                            let _e1426 = (bitcast<i32>(_e1423.member) != 0i);
                                            if _e1426 {
                                                phi_8808_ = (0.5f * (_e1398 + (_e1388 / _e1398)));
                                            } else {
                                                phi_8808_ = f32();
                                            }
                                            let _e1431 = phi_8808_;
                                            continue;
                                            continuing {
                                                phi_8804_ = _e1421;
                                                phi_8807_ = _e1431;
                                                break if !(_e1426);
                                            }
                                        }
                                        let _e1436 = local_19;
                                        phi_8861_ = (_e1436 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1443 = phi_8861_;
                                    let _e1444 = (0.000000059604645f * 12f);
                                    let _e1449 = ((_e1288 * 1.01f) + ((0f * _e1443) * (1f + _e1444)));
                                    let _e1454 = (((_e1379 * _e1065[0]) + (_e1381 * _e1065[1])) + (_e1383 * _e1065[2]));
                                    let _e1459 = (((_e1379 * _e1081) + (_e1381 * _e1082)) + (_e1383 * _e1083));
                                    let _e1464 = (((_e1379 * _e1087) + (_e1381 * _e1088)) + (_e1383 * _e1089));
                                    let _e1469 = (((_e1379 * _e1084) + (_e1381 * _e1085)) + (_e1383 * _e1086));
                                    let _e1475 = (((_e1379 * _e1092[0]) + (_e1381 * _e1092[1])) + (_e1383 * _e1092[2]));
                                    let _e1480 = (((_e1379 * _e1108) + (_e1381 * _e1109)) + (_e1383 * _e1110));
                                    let _e1485 = (((_e1379 * _e1114) + (_e1381 * _e1115)) + (_e1383 * _e1116));
                                    let _e1490 = (((_e1379 * _e1111) + (_e1381 * _e1112)) + (_e1383 * _e1113));
                                    if (_e1454 < 0f) {
                                        phi_8927_ = -(_e1454);
                                    } else {
                                        phi_8927_ = _e1454;
                                    }
                                    let _e1495 = phi_8927_;
                                    if (_e1475 < 0f) {
                                        phi_8933_ = -(_e1475);
                                    } else {
                                        phi_8933_ = _e1475;
                                    }
                                    let _e1499 = phi_8933_;
                                    if (_e1459 < 0f) {
                                        phi_8942_ = -(_e1459);
                                    } else {
                                        phi_8942_ = _e1459;
                                    }
                                    let _e1506 = phi_8942_;
                                    if (_e1480 < 0f) {
                                        phi_8948_ = -(_e1480);
                                    } else {
                                        phi_8948_ = _e1480;
                                    }
                                    let _e1510 = phi_8948_;
                                    if (_e1464 < 0f) {
                                        phi_8957_ = -(_e1464);
                                    } else {
                                        phi_8957_ = _e1464;
                                    }
                                    let _e1517 = phi_8957_;
                                    if (_e1485 < 0f) {
                                        phi_8963_ = -(_e1485);
                                    } else {
                                        phi_8963_ = _e1485;
                                    }
                                    let _e1521 = phi_8963_;
                                    if (_e1469 < 0f) {
                                        phi_8972_ = -(_e1469);
                                    } else {
                                        phi_8972_ = _e1469;
                                    }
                                    let _e1528 = phi_8972_;
                                    if (_e1490 < 0f) {
                                        phi_8978_ = -(_e1490);
                                    } else {
                                        phi_8978_ = _e1490;
                                    }
                                    let _e1532 = phi_8978_;
                                    phi_8984_ = type_32(array<f32, 4>(_e1454, _e1459, _e1464, _e1469), array<f32, 4>(_e1475, _e1480, _e1485, _e1490), array<f32, 4>((_e1449 + ((_e1495 + _e1499) * _e1444)), (_e1449 + ((_e1506 + _e1510) * _e1444)), (_e1449 + ((_e1517 + _e1521) * _e1444)), (_e1449 + ((_e1528 + _e1532) * _e1444))));
                                    phi_8985_ = false;
                                } else {
                                    phi_8984_ = type_32();
                                    phi_8985_ = true;
                                }
                                let _e1539 = phi_8984_;
                                let _e1541 = phi_8985_;
                                phi_8986_ = _e1539;
                                phi_8987_ = _e1541;
                            } else {
                                phi_8986_ = type_32();
                                phi_8987_ = true;
                            }
                            let _e1543 = phi_8986_;
                            let _e1545 = phi_8987_;
                            if _e1545 {
                                phi_8995_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                            } else {
                                phi_8995_ = _e1543;
                            }
                            let _e1547 = phi_8995_;
                            local_8 = type_32(array<f32, 4>(_e1547.member[0], _e1547.member[1], _e1547.member[2], _e1547.member[3]), array<f32, 4>(_e1547.member_1[0], _e1547.member_1[1], _e1547.member_1[2], _e1547.member_1[3]), array<f32, 4>(_e1547.member_2[0], _e1547.member_2[1], _e1547.member_2[2], _e1547.member_2[3]));
                            let _e1569 = local_8.member[0u];
                            let _e1572 = local_8.member_1[0u];
                            let _e1575 = local_8.member[0u];
                            let _e1581 = local_8.member_2[0u];
                            if (((_e1569 + ((_e1572 - _e1575) * _e322)) - _e1581) > 0f) {
                                let _e1586 = local_8.member[1u];
                                let _e1589 = local_8.member_1[1u];
                                let _e1592 = local_8.member[1u];
                                let _e1598 = local_8.member_2[1u];
                                if (((_e1586 + ((_e1589 - _e1592) * _e322)) - _e1598) > 0f) {
                                    let _e1603 = local_8.member[2u];
                                    let _e1606 = local_8.member_1[2u];
                                    let _e1609 = local_8.member[2u];
                                    let _e1615 = local_8.member_2[2u];
                                    if (((_e1603 + ((_e1606 - _e1609) * _e322)) - _e1615) > 0f) {
                                        let _e1620 = local_8.member[3u];
                                        let _e1623 = local_8.member_1[3u];
                                        let _e1626 = local_8.member[3u];
                                        let _e1632 = local_8.member_2[3u];
                                        phi_9164_ = (((_e1620 + ((_e1623 - _e1626) * _e322)) - _e1632) > 0f);
                                        phi_9165_ = false;
                                    } else {
                                        phi_9164_ = bool();
                                        phi_9165_ = true;
                                    }
                                    let _e1636 = phi_9164_;
                                    let _e1638 = phi_9165_;
                                    phi_9166_ = _e1636;
                                    phi_9167_ = _e1638;
                                } else {
                                    phi_9166_ = bool();
                                    phi_9167_ = true;
                                }
                                let _e1640 = phi_9166_;
                                let _e1642 = phi_9167_;
                                phi_9168_ = _e1640;
                                phi_9169_ = _e1642;
                            } else {
                                phi_9168_ = bool();
                                phi_9169_ = true;
                            }
                            let _e1644 = phi_9168_;
                            let _e1646 = phi_9169_;
                            if _e1646 {
                                phi_9173_ = false;
                            } else {
                                phi_9173_ = _e1644;
                            }
                            let _e1648 = phi_9173_;
                            if _e1648 {
                                phi_10527_ = bool();
                                phi_10528_ = true;
                            } else {
                                if (_e1355[0] < 0f) {
                                    phi_9200_ = -(_e1355[0]);
                                } else {
                                    phi_9200_ = _e1355[0];
                                }
                                let _e1653 = phi_9200_;
                                let _e1655 = ((_e1653 + 0f) + 0f);
                                if (_e1655 > 0f) {
                                    if ((bitcast<u32>(_e1655) & 2139095040u) != 2139095040u) {
                                        let _e1660 = (1f / _e1655);
                                        let _e1661 = (_e1355[0] * _e1660);
                                        let _e1662 = (0f * _e1660);
                                        let _e1663 = (0f * _e1660);
                                        let _e1668 = (((_e1661 * _e1661) + (_e1662 * _e1662)) + (_e1663 * _e1663));
                                        if (_e1668 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e1668 > 0f) {
                                                phi_9247_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_9247_ = 0f;
                                            }
                                            let _e1721 = phi_9247_;
                                            phi_9311_ = _e1721;
                                        } else {
                                            phi_9254_ = type_14(0i, 5i);
                                            phi_9257_ = bitcast<f32>(((bitcast<u32>(_e1668) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1676 = phi_9254_;
                                                let _e1678 = phi_9257_;
                                                local_20 = _e1678;
                                                if (_e1676.member < _e1676.member_1) {
                                                    let _e1685 = (_e1676.member + 1i);
                                                    if ((false == (_e1685 > _e1676.member)) != false) {
                                                        phi_9278_ = true;
                                                    } else {
                                                        phi_9278_ = false;
                                                    }
                                                    let _e1690 = phi_9278_;
                                                    if _e1690 {
                                                        phi_9284_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_9284_ = type_15(1u, _e1685);
                                                    }
                                                    let _e1695 = phi_9284_;
                                                    phi_9255_ = type_14(_e1695.member_1, _e1676.member_1);
                                                    phi_9298_ = type_15(1u, _e1676.member);
                                                } else {
                                                    phi_9255_ = _e1676;
                                                    phi_9298_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e1701 = phi_9255_;
                                                let _e1703 = phi_9298_;
                                                let _e1706 = (bitcast<i32>(_e1703.member) != 0i);
                                                if _e1706 {
                                                    phi_9258_ = (0.5f * (_e1678 + (_e1668 / _e1678)));
                                                } else {
                                                    phi_9258_ = f32();
                                                }
                                                let _e1711 = phi_9258_;
                                                continue;
                                                continuing {
                                                    phi_9254_ = _e1701;
                                                    phi_9257_ = _e1711;
                                                    break if !(_e1706);
                                                }
                                            }
                                            let _e1716 = local_20;
                                            phi_9311_ = (_e1716 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1723 = phi_9311_;
                                        let _e1724 = (0.000000059604645f * 12f);
                                        let _e1729 = ((_e1288 * 1.01f) + ((0f * _e1723) * (1f + _e1724)));
                                        let _e1734 = (((_e1661 * _e1065[0]) + (_e1662 * _e1065[1])) + (_e1663 * _e1065[2]));
                                        let _e1739 = (((_e1661 * _e1081) + (_e1662 * _e1082)) + (_e1663 * _e1083));
                                        let _e1744 = (((_e1661 * _e1087) + (_e1662 * _e1088)) + (_e1663 * _e1089));
                                        let _e1749 = (((_e1661 * _e1084) + (_e1662 * _e1085)) + (_e1663 * _e1086));
                                        let _e1755 = (((_e1661 * _e1092[0]) + (_e1662 * _e1092[1])) + (_e1663 * _e1092[2]));
                                        let _e1760 = (((_e1661 * _e1108) + (_e1662 * _e1109)) + (_e1663 * _e1110));
                                        let _e1765 = (((_e1661 * _e1114) + (_e1662 * _e1115)) + (_e1663 * _e1116));
                                        let _e1770 = (((_e1661 * _e1111) + (_e1662 * _e1112)) + (_e1663 * _e1113));
                                        if (_e1734 < 0f) {
                                            phi_9377_ = -(_e1734);
                                        } else {
                                            phi_9377_ = _e1734;
                                        }
                                        let _e1775 = phi_9377_;
                                        if (_e1755 < 0f) {
                                            phi_9383_ = -(_e1755);
                                        } else {
                                            phi_9383_ = _e1755;
                                        }
                                        let _e1779 = phi_9383_;
                                        if (_e1739 < 0f) {
                                            phi_9392_ = -(_e1739);
                                        } else {
                                            phi_9392_ = _e1739;
                                        }
                                        let _e1786 = phi_9392_;
                                        if (_e1760 < 0f) {
                                            phi_9398_ = -(_e1760);
                                        } else {
                                            phi_9398_ = _e1760;
                                        }
                                        let _e1790 = phi_9398_;
                                        if (_e1744 < 0f) {
                                            phi_9407_ = -(_e1744);
                                        } else {
                                            phi_9407_ = _e1744;
                                        }
                                        let _e1797 = phi_9407_;
                                        if (_e1765 < 0f) {
                                            phi_9413_ = -(_e1765);
                                        } else {
                                            phi_9413_ = _e1765;
                                        }
                                        let _e1801 = phi_9413_;
                                        if (_e1749 < 0f) {
                                            phi_9422_ = -(_e1749);
                                        } else {
                                            phi_9422_ = _e1749;
                                        }
                                        let _e1808 = phi_9422_;
                                        if (_e1770 < 0f) {
                                            phi_9428_ = -(_e1770);
                                        } else {
                                            phi_9428_ = _e1770;
                                        }
                                        let _e1812 = phi_9428_;
                                        phi_9434_ = type_32(array<f32, 4>(_e1734, _e1739, _e1744, _e1749), array<f32, 4>(_e1755, _e1760, _e1765, _e1770), array<f32, 4>((_e1729 + ((_e1775 + _e1779) * _e1724)), (_e1729 + ((_e1786 + _e1790) * _e1724)), (_e1729 + ((_e1797 + _e1801) * _e1724)), (_e1729 + ((_e1808 + _e1812) * _e1724))));
                                        phi_9435_ = false;
                                    } else {
                                        phi_9434_ = type_32();
                                        phi_9435_ = true;
                                    }
                                    let _e1819 = phi_9434_;
                                    let _e1821 = phi_9435_;
                                    phi_9436_ = _e1819;
                                    phi_9437_ = _e1821;
                                } else {
                                    phi_9436_ = type_32();
                                    phi_9437_ = true;
                                }
                                let _e1823 = phi_9436_;
                                let _e1825 = phi_9437_;
                                if _e1825 {
                                    phi_9445_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_9445_ = _e1823;
                                }
                                let _e1827 = phi_9445_;
                                local_9 = type_32(array<f32, 4>(_e1827.member[0], _e1827.member[1], _e1827.member[2], _e1827.member[3]), array<f32, 4>(_e1827.member_1[0], _e1827.member_1[1], _e1827.member_1[2], _e1827.member_1[3]), array<f32, 4>(_e1827.member_2[0], _e1827.member_2[1], _e1827.member_2[2], _e1827.member_2[3]));
                                let _e1849 = local_9.member[0u];
                                let _e1852 = local_9.member_1[0u];
                                let _e1855 = local_9.member[0u];
                                let _e1861 = local_9.member_2[0u];
                                if (((_e1849 + ((_e1852 - _e1855) * _e322)) - _e1861) > 0f) {
                                    let _e1866 = local_9.member[1u];
                                    let _e1869 = local_9.member_1[1u];
                                    let _e1872 = local_9.member[1u];
                                    let _e1878 = local_9.member_2[1u];
                                    if (((_e1866 + ((_e1869 - _e1872) * _e322)) - _e1878) > 0f) {
                                        let _e1883 = local_9.member[2u];
                                        let _e1886 = local_9.member_1[2u];
                                        let _e1889 = local_9.member[2u];
                                        let _e1895 = local_9.member_2[2u];
                                        if (((_e1883 + ((_e1886 - _e1889) * _e322)) - _e1895) > 0f) {
                                            let _e1900 = local_9.member[3u];
                                            let _e1903 = local_9.member_1[3u];
                                            let _e1906 = local_9.member[3u];
                                            let _e1912 = local_9.member_2[3u];
                                            phi_9614_ = (((_e1900 + ((_e1903 - _e1906) * _e322)) - _e1912) > 0f);
                                            phi_9615_ = false;
                                        } else {
                                            phi_9614_ = bool();
                                            phi_9615_ = true;
                                        }
                                        let _e1916 = phi_9614_;
                                        let _e1918 = phi_9615_;
                                        phi_9616_ = _e1916;
                                        phi_9617_ = _e1918;
                                    } else {
                                        phi_9616_ = bool();
                                        phi_9617_ = true;
                                    }
                                    let _e1920 = phi_9616_;
                                    let _e1922 = phi_9617_;
                                    phi_9618_ = _e1920;
                                    phi_9619_ = _e1922;
                                } else {
                                    phi_9618_ = bool();
                                    phi_9619_ = true;
                                }
                                let _e1924 = phi_9618_;
                                let _e1926 = phi_9619_;
                                if _e1926 {
                                    phi_9623_ = false;
                                } else {
                                    phi_9623_ = _e1924;
                                }
                                let _e1928 = phi_9623_;
                                if _e1928 {
                                    phi_10525_ = bool();
                                    phi_10526_ = true;
                                } else {
                                    if (_e1355[1] < 0f) {
                                        phi_9656_ = -(_e1355[1]);
                                    } else {
                                        phi_9656_ = _e1355[1];
                                    }
                                    let _e1933 = phi_9656_;
                                    let _e1935 = ((0f + _e1933) + 0f);
                                    if (_e1935 > 0f) {
                                        if ((bitcast<u32>(_e1935) & 2139095040u) != 2139095040u) {
                                            let _e1940 = (1f / _e1935);
                                            let _e1941 = (0f * _e1940);
                                            let _e1942 = (_e1355[1] * _e1940);
                                            let _e1943 = (0f * _e1940);
                                            let _e1948 = (((_e1941 * _e1941) + (_e1942 * _e1942)) + (_e1943 * _e1943));
                                            if (_e1948 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1948 > 0f) {
                                                    phi_9697_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_9697_ = 0f;
                                                }
                                                let _e2001 = phi_9697_;
                                                phi_9761_ = _e2001;
                                            } else {
                                                phi_9704_ = type_14(0i, 5i);
                                                phi_9707_ = bitcast<f32>(((bitcast<u32>(_e1948) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1956 = phi_9704_;
                                                    let _e1958 = phi_9707_;
                                                    local_21 = _e1958;
                                                    if (_e1956.member < _e1956.member_1) {
                                                        let _e1965 = (_e1956.member + 1i);
                                                        if ((false == (_e1965 > _e1956.member)) != false) {
                                                            phi_9728_ = true;
                                                        } else {
                                                            phi_9728_ = false;
                                                        }
                                                        let _e1970 = phi_9728_;
                                                        if _e1970 {
                                                            phi_9734_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_9734_ = type_15(1u, _e1965);
                                                        }
                                                        let _e1975 = phi_9734_;
                                                        phi_9705_ = type_14(_e1975.member_1, _e1956.member_1);
                                                        phi_9748_ = type_15(1u, _e1956.member);
                                                    } else {
                                                        phi_9705_ = _e1956;
                                                        phi_9748_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1981 = phi_9705_;
                                                    let _e1983 = phi_9748_;
                                                    let _e1986 = (bitcast<i32>(_e1983.member) != 0i);
                                                    if _e1986 {
                                                        phi_9708_ = (0.5f * (_e1958 + (_e1948 / _e1958)));
                                                    } else {
                                                        phi_9708_ = f32();
                                                    }
                                                    let _e1991 = phi_9708_;
                                                    continue;
                                                    continuing {
                                                        phi_9704_ = _e1981;
                                                        phi_9707_ = _e1991;
                                                        break if !(_e1986);
                                                    }
                                                }
                                                let _e1996 = local_21;
                                                phi_9761_ = (_e1996 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e2003 = phi_9761_;
                                            let _e2004 = (0.000000059604645f * 12f);
                                            let _e2009 = ((_e1288 * 1.01f) + ((0f * _e2003) * (1f + _e2004)));
                                            let _e2014 = (((_e1941 * _e1065[0]) + (_e1942 * _e1065[1])) + (_e1943 * _e1065[2]));
                                            let _e2019 = (((_e1941 * _e1081) + (_e1942 * _e1082)) + (_e1943 * _e1083));
                                            let _e2024 = (((_e1941 * _e1087) + (_e1942 * _e1088)) + (_e1943 * _e1089));
                                            let _e2029 = (((_e1941 * _e1084) + (_e1942 * _e1085)) + (_e1943 * _e1086));
                                            let _e2035 = (((_e1941 * _e1092[0]) + (_e1942 * _e1092[1])) + (_e1943 * _e1092[2]));
                                            let _e2040 = (((_e1941 * _e1108) + (_e1942 * _e1109)) + (_e1943 * _e1110));
                                            let _e2045 = (((_e1941 * _e1114) + (_e1942 * _e1115)) + (_e1943 * _e1116));
                                            let _e2050 = (((_e1941 * _e1111) + (_e1942 * _e1112)) + (_e1943 * _e1113));
                                            if (_e2014 < 0f) {
                                                phi_9827_ = -(_e2014);
                                            } else {
                                                phi_9827_ = _e2014;
                                            }
                                            let _e2055 = phi_9827_;
                                            if (_e2035 < 0f) {
                                                phi_9833_ = -(_e2035);
                                            } else {
                                                phi_9833_ = _e2035;
                                            }
                                            let _e2059 = phi_9833_;
                                            if (_e2019 < 0f) {
                                                phi_9842_ = -(_e2019);
                                            } else {
                                                phi_9842_ = _e2019;
                                            }
                                            let _e2066 = phi_9842_;
                                            if (_e2040 < 0f) {
                                                phi_9848_ = -(_e2040);
                                            } else {
                                                phi_9848_ = _e2040;
                                            }
                                            let _e2070 = phi_9848_;
                                            if (_e2024 < 0f) {
                                                phi_9857_ = -(_e2024);
                                            } else {
                                                phi_9857_ = _e2024;
                                            }
                                            let _e2077 = phi_9857_;
                                            if (_e2045 < 0f) {
                                                phi_9863_ = -(_e2045);
                                            } else {
                                                phi_9863_ = _e2045;
                                            }
                                            let _e2081 = phi_9863_;
                                            if (_e2029 < 0f) {
                                                phi_9872_ = -(_e2029);
                                            } else {
                                                phi_9872_ = _e2029;
                                            }
                                            let _e2088 = phi_9872_;
                                            if (_e2050 < 0f) {
                                                phi_9878_ = -(_e2050);
                                            } else {
                                                phi_9878_ = _e2050;
                                            }
                                            let _e2092 = phi_9878_;
                                            phi_9884_ = type_32(array<f32, 4>(_e2014, _e2019, _e2024, _e2029), array<f32, 4>(_e2035, _e2040, _e2045, _e2050), array<f32, 4>((_e2009 + ((_e2055 + _e2059) * _e2004)), (_e2009 + ((_e2066 + _e2070) * _e2004)), (_e2009 + ((_e2077 + _e2081) * _e2004)), (_e2009 + ((_e2088 + _e2092) * _e2004))));
                                            phi_9885_ = false;
                                        } else {
                                            phi_9884_ = type_32();
                                            phi_9885_ = true;
                                        }
                                        let _e2099 = phi_9884_;
                                        let _e2101 = phi_9885_;
                                        phi_9886_ = _e2099;
                                        phi_9887_ = _e2101;
                                    } else {
                                        phi_9886_ = type_32();
                                        phi_9887_ = true;
                                    }
                                    let _e2103 = phi_9886_;
                                    let _e2105 = phi_9887_;
                                    if _e2105 {
                                        phi_9895_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_9895_ = _e2103;
                                    }
                                    let _e2107 = phi_9895_;
                                    local_10 = type_32(array<f32, 4>(_e2107.member[0], _e2107.member[1], _e2107.member[2], _e2107.member[3]), array<f32, 4>(_e2107.member_1[0], _e2107.member_1[1], _e2107.member_1[2], _e2107.member_1[3]), array<f32, 4>(_e2107.member_2[0], _e2107.member_2[1], _e2107.member_2[2], _e2107.member_2[3]));
                                    let _e2129 = local_10.member[0u];
                                    let _e2132 = local_10.member_1[0u];
                                    let _e2135 = local_10.member[0u];
                                    let _e2141 = local_10.member_2[0u];
                                    if (((_e2129 + ((_e2132 - _e2135) * _e322)) - _e2141) > 0f) {
                                        let _e2146 = local_10.member[1u];
                                        let _e2149 = local_10.member_1[1u];
                                        let _e2152 = local_10.member[1u];
                                        let _e2158 = local_10.member_2[1u];
                                        if (((_e2146 + ((_e2149 - _e2152) * _e322)) - _e2158) > 0f) {
                                            let _e2163 = local_10.member[2u];
                                            let _e2166 = local_10.member_1[2u];
                                            let _e2169 = local_10.member[2u];
                                            let _e2175 = local_10.member_2[2u];
                                            if (((_e2163 + ((_e2166 - _e2169) * _e322)) - _e2175) > 0f) {
                                                let _e2180 = local_10.member[3u];
                                                let _e2183 = local_10.member_1[3u];
                                                let _e2186 = local_10.member[3u];
                                                let _e2192 = local_10.member_2[3u];
                                                phi_10064_ = (((_e2180 + ((_e2183 - _e2186) * _e322)) - _e2192) > 0f);
                                                phi_10065_ = false;
                                            } else {
                                                phi_10064_ = bool();
                                                phi_10065_ = true;
                                            }
                                            let _e2196 = phi_10064_;
                                            let _e2198 = phi_10065_;
                                            phi_10066_ = _e2196;
                                            phi_10067_ = _e2198;
                                        } else {
                                            phi_10066_ = bool();
                                            phi_10067_ = true;
                                        }
                                        let _e2200 = phi_10066_;
                                        let _e2202 = phi_10067_;
                                        phi_10068_ = _e2200;
                                        phi_10069_ = _e2202;
                                    } else {
                                        phi_10068_ = bool();
                                        phi_10069_ = true;
                                    }
                                    let _e2204 = phi_10068_;
                                    let _e2206 = phi_10069_;
                                    if _e2206 {
                                        phi_10073_ = false;
                                    } else {
                                        phi_10073_ = _e2204;
                                    }
                                    let _e2208 = phi_10073_;
                                    if _e2208 {
                                        phi_10524_ = bool();
                                    } else {
                                        if (_e1355[2] < 0f) {
                                            phi_10113_ = -(_e1355[2]);
                                        } else {
                                            phi_10113_ = _e1355[2];
                                        }
                                        let _e2214 = phi_10113_;
                                        let _e2215 = ((0f + 0f) + _e2214);
                                        if (_e2215 > 0f) {
                                            if ((bitcast<u32>(_e2215) & 2139095040u) != 2139095040u) {
                                                let _e2220 = (1f / _e2215);
                                                let _e2221 = (0f * _e2220);
                                                let _e2222 = (0f * _e2220);
                                                let _e2223 = (_e1355[2] * _e2220);
                                                let _e2228 = (((_e2221 * _e2221) + (_e2222 * _e2222)) + (_e2223 * _e2223));
                                                if (_e2228 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e2228 > 0f) {
                                                        phi_10147_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_10147_ = 0f;
                                                    }
                                                    let _e2281 = phi_10147_;
                                                    phi_10211_ = _e2281;
                                                } else {
                                                    phi_10154_ = type_14(0i, 5i);
                                                    phi_10157_ = bitcast<f32>(((bitcast<u32>(_e2228) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2236 = phi_10154_;
                                                        let _e2238 = phi_10157_;
                                                        local_22 = _e2238;
                                                        if (_e2236.member < _e2236.member_1) {
                                                            let _e2245 = (_e2236.member + 1i);
                                                            if ((false == (_e2245 > _e2236.member)) != false) {
                                                                phi_10178_ = true;
                                                            } else {
                                                                phi_10178_ = false;
                                                            }
                                                            let _e2250 = phi_10178_;
                                                            if _e2250 {
                                                                phi_10184_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_10184_ = type_15(1u, _e2245);
                                                            }
                                                            let _e2255 = phi_10184_;
                                                            phi_10155_ = type_14(_e2255.member_1, _e2236.member_1);
                                                            phi_10198_ = type_15(1u, _e2236.member);
                                                        } else {
                                                            phi_10155_ = _e2236;
                                                            phi_10198_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2261 = phi_10155_;
                                                        let _e2263 = phi_10198_;
                                                        let _e2266 = (bitcast<i32>(_e2263.member) != 0i);
                                                        if _e2266 {
                                                            phi_10158_ = (0.5f * (_e2238 + (_e2228 / _e2238)));
                                                        } else {
                                                            phi_10158_ = f32();
                                                        }
                                                        let _e2271 = phi_10158_;
                                                        continue;
                                                        continuing {
                                                            phi_10154_ = _e2261;
                                                            phi_10157_ = _e2271;
                                                            break if !(_e2266);
                                                        }
                                                    }
                                                    let _e2276 = local_22;
                                                    phi_10211_ = (_e2276 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2283 = phi_10211_;
                                                let _e2284 = (0.000000059604645f * 12f);
                                                let _e2289 = ((_e1288 * 1.01f) + ((0f * _e2283) * (1f + _e2284)));
                                                let _e2294 = (((_e2221 * _e1065[0]) + (_e2222 * _e1065[1])) + (_e2223 * _e1065[2]));
                                                let _e2299 = (((_e2221 * _e1081) + (_e2222 * _e1082)) + (_e2223 * _e1083));
                                                let _e2304 = (((_e2221 * _e1087) + (_e2222 * _e1088)) + (_e2223 * _e1089));
                                                let _e2309 = (((_e2221 * _e1084) + (_e2222 * _e1085)) + (_e2223 * _e1086));
                                                let _e2315 = (((_e2221 * _e1092[0]) + (_e2222 * _e1092[1])) + (_e2223 * _e1092[2]));
                                                let _e2320 = (((_e2221 * _e1108) + (_e2222 * _e1109)) + (_e2223 * _e1110));
                                                let _e2325 = (((_e2221 * _e1114) + (_e2222 * _e1115)) + (_e2223 * _e1116));
                                                let _e2330 = (((_e2221 * _e1111) + (_e2222 * _e1112)) + (_e2223 * _e1113));
                                                if (_e2294 < 0f) {
                                                    phi_10277_ = -(_e2294);
                                                } else {
                                                    phi_10277_ = _e2294;
                                                }
                                                let _e2335 = phi_10277_;
                                                if (_e2315 < 0f) {
                                                    phi_10283_ = -(_e2315);
                                                } else {
                                                    phi_10283_ = _e2315;
                                                }
                                                let _e2339 = phi_10283_;
                                                if (_e2299 < 0f) {
                                                    phi_10292_ = -(_e2299);
                                                } else {
                                                    phi_10292_ = _e2299;
                                                }
                                                let _e2346 = phi_10292_;
                                                if (_e2320 < 0f) {
                                                    phi_10298_ = -(_e2320);
                                                } else {
                                                    phi_10298_ = _e2320;
                                                }
                                                let _e2350 = phi_10298_;
                                                if (_e2304 < 0f) {
                                                    phi_10307_ = -(_e2304);
                                                } else {
                                                    phi_10307_ = _e2304;
                                                }
                                                let _e2357 = phi_10307_;
                                                if (_e2325 < 0f) {
                                                    phi_10313_ = -(_e2325);
                                                } else {
                                                    phi_10313_ = _e2325;
                                                }
                                                let _e2361 = phi_10313_;
                                                if (_e2309 < 0f) {
                                                    phi_10322_ = -(_e2309);
                                                } else {
                                                    phi_10322_ = _e2309;
                                                }
                                                let _e2368 = phi_10322_;
                                                if (_e2330 < 0f) {
                                                    phi_10328_ = -(_e2330);
                                                } else {
                                                    phi_10328_ = _e2330;
                                                }
                                                let _e2372 = phi_10328_;
                                                phi_10334_ = type_32(array<f32, 4>(_e2294, _e2299, _e2304, _e2309), array<f32, 4>(_e2315, _e2320, _e2325, _e2330), array<f32, 4>((_e2289 + ((_e2335 + _e2339) * _e2284)), (_e2289 + ((_e2346 + _e2350) * _e2284)), (_e2289 + ((_e2357 + _e2361) * _e2284)), (_e2289 + ((_e2368 + _e2372) * _e2284))));
                                                phi_10335_ = false;
                                            } else {
                                                phi_10334_ = type_32();
                                                phi_10335_ = true;
                                            }
                                            let _e2379 = phi_10334_;
                                            let _e2381 = phi_10335_;
                                            phi_10336_ = _e2379;
                                            phi_10337_ = _e2381;
                                        } else {
                                            phi_10336_ = type_32();
                                            phi_10337_ = true;
                                        }
                                        let _e2383 = phi_10336_;
                                        let _e2385 = phi_10337_;
                                        if _e2385 {
                                            phi_10345_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_10345_ = _e2383;
                                        }
                                        let _e2387 = phi_10345_;
                                        local_11 = type_32(array<f32, 4>(_e2387.member[0], _e2387.member[1], _e2387.member[2], _e2387.member[3]), array<f32, 4>(_e2387.member_1[0], _e2387.member_1[1], _e2387.member_1[2], _e2387.member_1[3]), array<f32, 4>(_e2387.member_2[0], _e2387.member_2[1], _e2387.member_2[2], _e2387.member_2[3]));
                                        let _e2409 = local_11.member[0u];
                                        let _e2412 = local_11.member_1[0u];
                                        let _e2415 = local_11.member[0u];
                                        let _e2421 = local_11.member_2[0u];
                                        if (((_e2409 + ((_e2412 - _e2415) * _e322)) - _e2421) > 0f) {
                                            let _e2426 = local_11.member[1u];
                                            let _e2429 = local_11.member_1[1u];
                                            let _e2432 = local_11.member[1u];
                                            let _e2438 = local_11.member_2[1u];
                                            if (((_e2426 + ((_e2429 - _e2432) * _e322)) - _e2438) > 0f) {
                                                let _e2443 = local_11.member[2u];
                                                let _e2446 = local_11.member_1[2u];
                                                let _e2449 = local_11.member[2u];
                                                let _e2455 = local_11.member_2[2u];
                                                if (((_e2443 + ((_e2446 - _e2449) * _e322)) - _e2455) > 0f) {
                                                    let _e2460 = local_11.member[3u];
                                                    let _e2463 = local_11.member_1[3u];
                                                    let _e2466 = local_11.member[3u];
                                                    let _e2472 = local_11.member_2[3u];
                                                    phi_10514_ = (((_e2460 + ((_e2463 - _e2466) * _e322)) - _e2472) > 0f);
                                                    phi_10515_ = false;
                                                } else {
                                                    phi_10514_ = bool();
                                                    phi_10515_ = true;
                                                }
                                                let _e2476 = phi_10514_;
                                                let _e2478 = phi_10515_;
                                                phi_10516_ = _e2476;
                                                phi_10517_ = _e2478;
                                            } else {
                                                phi_10516_ = bool();
                                                phi_10517_ = true;
                                            }
                                            let _e2480 = phi_10516_;
                                            let _e2482 = phi_10517_;
                                            phi_10518_ = _e2480;
                                            phi_10519_ = _e2482;
                                        } else {
                                            phi_10518_ = bool();
                                            phi_10519_ = true;
                                        }
                                        let _e2484 = phi_10518_;
                                        let _e2486 = phi_10519_;
                                        if _e2486 {
                                            phi_10523_ = false;
                                        } else {
                                            phi_10523_ = _e2484;
                                        }
                                        let _e2488 = phi_10523_;
                                        phi_10524_ = _e2488;
                                    }
                                    let _e2490 = phi_10524_;
                                    phi_10525_ = _e2490;
                                    phi_10526_ = _e2208;
                                }
                                let _e2492 = phi_10525_;
                                let _e2494 = phi_10526_;
                                phi_10527_ = _e2492;
                                phi_10528_ = _e2494;
                            }
                            let _e2496 = phi_10527_;
                            let _e2498 = phi_10528_;
                            if _e2498 {
                                phi_10532_ = true;
                            } else {
                                phi_10532_ = _e2496;
                            }
                            let _e2500 = phi_10532_;
                            if !(_e2500) {
                                phi_10538_ = type_30(2u, _e322);
                                phi_10539_ = false;
                            } else {
                                phi_10538_ = type_30();
                                phi_10539_ = true;
                            }
                            let _e2504 = phi_10538_;
                            let _e2506 = phi_10539_;
                            phi_10540_ = _e2504;
                            phi_10541_ = _e2506;
                        } else {
                            phi_10540_ = type_30();
                            phi_10541_ = true;
                        }
                        let _e2508 = phi_10540_;
                        let _e2510 = phi_10541_;
                        if _e2510 {
                            let _e2516 = ((_e686 - (3f * _e663)) * _e1040);
                            let _e2517 = ((_e709 - _e686) * _e1040);
                            let _e2518 = (((3f * _e720) - _e709) * _e1040);
                            local_6[0u] = 0f;
                            local_6[1u] = 1f;
                            local_6[2u] = 1f;
                            local_6[3u] = 1f;
                            let _e2525 = ((_e2517 * _e2517) - (_e2516 * _e2518));
                            if (_e2525 > 0f) {
                                if (_e2525 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2525 > 0f) {
                                        phi_10577_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_10577_ = 0f;
                                    }
                                    let _e2579 = phi_10577_;
                                    phi_10641_ = _e2579;
                                } else {
                                    phi_10584_ = type_14(0i, 5i);
                                    phi_10587_ = bitcast<f32>(((bitcast<u32>(_e2525) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2534 = phi_10584_;
                                        let _e2536 = phi_10587_;
                                        local_23 = _e2536;
                                        if (_e2534.member < _e2534.member_1) {
                                            let _e2543 = (_e2534.member + 1i);
                                            if ((false == (_e2543 > _e2534.member)) != false) {
                                                phi_10608_ = true;
                                            } else {
                                                phi_10608_ = false;
                                            }
                                            let _e2548 = phi_10608_;
                                            if _e2548 {
                                                phi_10614_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_10614_ = type_15(1u, _e2543);
                                            }
                                            let _e2553 = phi_10614_;
                                            phi_10585_ = type_14(_e2553.member_1, _e2534.member_1);
                                            phi_10628_ = type_15(1u, _e2534.member);
                                        } else {
                                            phi_10585_ = _e2534;
                                            phi_10628_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2559 = phi_10585_;
                                        let _e2561 = phi_10628_;
                                        let _e2564 = (bitcast<i32>(_e2561.member) != 0i);
                                        if _e2564 {
                                            phi_10588_ = (0.5f * (_e2536 + (_e2525 / _e2536)));
                                        } else {
                                            phi_10588_ = f32();
                                        }
                                        let _e2569 = phi_10588_;
                                        continue;
                                        continuing {
                                            phi_10584_ = _e2559;
                                            phi_10587_ = _e2569;
                                            break if !(_e2564);
                                        }
                                    }
                                    let _e2574 = local_23;
                                    phi_10641_ = (_e2574 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2581 = phi_10641_;
                                if (_e2517 < 0f) {
                                    phi_10647_ = -(_e2581);
                                } else {
                                    phi_10647_ = _e2581;
                                }
                                let _e2585 = phi_10647_;
                                let _e2587 = -((_e2517 + _e2585));
                                local_7[0u] = (_e2587 / (_e2587 + _e2518));
                                local_7[1u] = (_e2516 / (_e2516 + _e2587));
                                let _e2596 = local_7[1u];
                                let _e2597 = local_7[0u];
                                if (_e2596 < _e2597) {
                                    let _e2600 = local_7[1u];
                                    let _e2602 = local_7[0u];
                                    local_7[0u] = _e2600;
                                    local_7[1u] = _e2602;
                                }
                                phi_10672_ = type_12(0u, 2u);
                                phi_10675_ = 1u;
                                loop {
                                    let _e2606 = phi_10672_;
                                    let _e2608 = phi_10675_;
                                    local_63 = _e2608;
                                    if (_e2606.member < _e2606.member_1) {
                                        phi_10673_ = type_12((_e2606.member + 1u), _e2606.member_1);
                                        phi_10698_ = type_12(1u, _e2606.member);
                                    } else {
                                        phi_10673_ = _e2606;
                                        phi_10698_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2620 = phi_10673_;
                                    let _e2622 = phi_10698_;
                                    let _e2626 = (bitcast<i32>(_e2622.member) != 0i);
                                    if _e2626 {
                                        let _e2628 = local_7[_e2622.member_1];
                                        if (_e2628 > 0f) {
                                            let _e2631 = local_7[_e2622.member_1];
                                            if (_e2631 < 1f) {
                                                let _e2634 = local_7[_e2622.member_1];
                                                local_6[_e2608] = _e2634;
                                                phi_10742_ = (_e2608 + 1u);
                                            } else {
                                                phi_10742_ = _e2608;
                                            }
                                            let _e2638 = phi_10742_;
                                            phi_10743_ = _e2638;
                                        } else {
                                            phi_10743_ = _e2608;
                                        }
                                        let _e2640 = phi_10743_;
                                        phi_10676_ = _e2640;
                                    } else {
                                        phi_10676_ = u32();
                                    }
                                    let _e2642 = phi_10676_;
                                    continue;
                                    continuing {
                                        phi_10672_ = _e2620;
                                        phi_10675_ = _e2642;
                                        break if !(_e2626);
                                    }
                                }
                                let _e10235 = local_63;
                                phi_10744_ = _e10235;
                            } else {
                                phi_10744_ = 1u;
                            }
                            let _e2645 = phi_10744_;
                            local_6[_e2645] = 1f;
                            let _e2647 = local_6;
                            local_12 = _e2647;
                            phi_10764_ = type_12(0u, _e2645);
                            loop {
                                let _e2650 = phi_10764_;
                                if (_e2650.member < _e2650.member_1) {
                                    phi_10765_ = type_12((_e2650.member + 1u), _e2650.member_1);
                                    phi_10788_ = type_12(1u, _e2650.member);
                                } else {
                                    phi_10765_ = _e2650;
                                    phi_10788_ = type_12(0u, type_12().member_1);
                                }
                                let _e2662 = phi_10765_;
                                let _e2664 = phi_10788_;
                                if (bitcast<i32>(_e2664.member) != 0i) {
                                    let _e2670 = local_12[_e2664.member_1];
                                    if (_e2670 > _e322) {
                                        phi_10807_ = _e2670;
                                    } else {
                                        phi_10807_ = _e322;
                                    }
                                    let _e2673 = phi_10807_;
                                    let _e2676 = local_12[(_e2664.member_1 + 1u)];
                                    if (_e2676 < _e324) {
                                        phi_10820_ = _e2676;
                                    } else {
                                        phi_10820_ = _e324;
                                    }
                                    let _e2679 = phi_10820_;
                                    if (_e2673 <= _e2679) {
                                        let _e2681 = (1f - _e2673);
                                        let _e2692 = ((((_e663 * _e2681) + (_e686 * _e2673)) * (_e2681 * _e2681)) + (((_e709 * _e2681) + (_e720 * _e2673)) * (_e2673 * _e2673)));
                                        let _e2693 = (1f - _e2679);
                                        let _e2704 = ((((_e663 * _e2693) + (_e686 * _e2679)) * (_e2693 * _e2693)) + (((_e709 * _e2693) + (_e720 * _e2679)) * (_e2679 * _e2679)));
                                        if (_e2692 < 0f) {
                                            phi_10854_ = -(_e2692);
                                        } else {
                                            phi_10854_ = _e2692;
                                        }
                                        let _e2708 = phi_10854_;
                                        let _e2709 = (_e2708 > _e1037);
                                        if (_e2704 < 0f) {
                                            phi_10861_ = -(_e2704);
                                        } else {
                                            phi_10861_ = _e2704;
                                        }
                                        let _e2713 = phi_10861_;
                                        let _e2714 = (_e2713 > _e1037);
                                        if _e2709 {
                                            if _e2714 {
                                                phi_10872_ = ((_e2692 > 0f) != (_e2704 > 0f));
                                                phi_10873_ = false;
                                            } else {
                                                phi_10872_ = bool();
                                                phi_10873_ = true;
                                            }
                                            let _e2719 = phi_10872_;
                                            let _e2721 = phi_10873_;
                                            phi_10874_ = _e2719;
                                            phi_10875_ = _e2721;
                                        } else {
                                            phi_10874_ = bool();
                                            phi_10875_ = true;
                                        }
                                        let _e2723 = phi_10874_;
                                        let _e2725 = phi_10875_;
                                        if _e2725 {
                                            phi_10879_ = false;
                                        } else {
                                            phi_10879_ = _e2723;
                                        }
                                        let _e2727 = phi_10879_;
                                        if _e2709 {
                                            if _e2714 {
                                                if _e2727 {
                                                    phi_10890_ = type_41();
                                                } else {
                                                    phi_10890_ = type_41(1f, 0f, _e2727);
                                                }
                                                let _e2730 = phi_10890_;
                                                phi_10891_ = _e2730;
                                                phi_10892_ = _e2727;
                                            } else {
                                                phi_10891_ = type_41();
                                                phi_10892_ = true;
                                            }
                                            let _e2732 = phi_10891_;
                                            let _e2734 = phi_10892_;
                                            phi_10893_ = _e2732;
                                            phi_10894_ = _e2734;
                                        } else {
                                            phi_10893_ = type_41();
                                            phi_10894_ = true;
                                        }
                                        let _e2736 = phi_10893_;
                                        let _e2738 = phi_10894_;
                                        if _e2738 {
                                            if _e2709 {
                                                if (_e2692 < 0f) {
                                                    phi_10905_ = -1f;
                                                } else {
                                                    phi_10905_ = 1f;
                                                }
                                                let _e2741 = phi_10905_;
                                                let _e2744 = (_e709 - _e686);
                                                phi_10915_ = type_12(0u, 64u);
                                                phi_10918_ = _e2679;
                                                phi_10920_ = _e2673;
                                                phi_10922_ = (0.5f * (_e2673 + _e2679));
                                                loop {
                                                    let _e2750 = phi_10915_;
                                                    let _e2752 = phi_10918_;
                                                    let _e2754 = phi_10920_;
                                                    let _e2756 = phi_10922_;
                                                    local_65 = _e2754;
                                                    if (_e2750.member < _e2750.member_1) {
                                                        phi_10916_ = type_12((_e2750.member + 1u), _e2750.member_1);
                                                        phi_10945_ = type_12(1u, _e2750.member);
                                                    } else {
                                                        phi_10916_ = _e2750;
                                                        phi_10945_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2768 = phi_10916_;
                                                    let _e2770 = phi_10945_;
                                                    if (bitcast<i32>(_e2770.member) != 0i) {
                                                        let _e2774 = (1f - _e2756);
                                                        let _e2787 = ((_e2741 * ((((_e663 * _e2774) + (_e686 * _e2756)) * (_e2774 * _e2774)) + (((_e709 * _e2774) + (_e720 * _e2756)) * (_e2756 * _e2756)))) - _e1037);
                                                        if (_e2787 > 0f) {
                                                            phi_10970_ = _e2752;
                                                            phi_10971_ = _e2756;
                                                        } else {
                                                            phi_10970_ = _e2756;
                                                            phi_10971_ = _e2754;
                                                        }
                                                        let _e2790 = phi_10970_;
                                                        let _e2792 = phi_10971_;
                                                        let _e2794 = ((_e2790 - _e2792) > _e1044);
                                                        if _e2794 {
                                                            let _e2795 = (1f - _e2756);
                                                            let _e2807 = (-(_e2787) / (_e2741 * (((((_e686 - (3f * _e663)) * _e2795) + (_e2744 * _e2756)) * _e2795) + (((_e2744 * _e2795) + (((3f * _e720) - _e709) * _e2756)) * _e2756))));
                                                            if (_e2787 > 0f) {
                                                                phi_10997_ = (0.5f * _e1044);
                                                            } else {
                                                                phi_10997_ = -((0.5f * _e1044));
                                                            }
                                                            let _e2813 = phi_10997_;
                                                            let _e2815 = ((_e2756 + _e2807) + _e2813);
                                                            if (_e2815 > _e2792) {
                                                                if (_e2815 < _e2790) {
                                                                    if (_e2807 < 0f) {
                                                                        phi_11013_ = -(_e2807);
                                                                    } else {
                                                                        phi_11013_ = _e2807;
                                                                    }
                                                                    let _e2821 = phi_11013_;
                                                                    if (_e2821 < (0.5f * (_e2790 - _e2792))) {
                                                                        phi_11020_ = false;
                                                                    } else {
                                                                        phi_11020_ = true;
                                                                    }
                                                                    let _e2826 = phi_11020_;
                                                                    phi_11021_ = _e2826;
                                                                } else {
                                                                    phi_11021_ = true;
                                                                }
                                                                let _e2828 = phi_11021_;
                                                                phi_11022_ = _e2828;
                                                            } else {
                                                                phi_11022_ = true;
                                                            }
                                                            let _e2830 = phi_11022_;
                                                            if _e2830 {
                                                                phi_11028_ = (0.5f * (_e2792 + _e2790));
                                                            } else {
                                                                phi_11028_ = _e2815;
                                                            }
                                                            let _e2834 = phi_11028_;
                                                            phi_11029_ = _e2834;
                                                            phi_11030_ = false;
                                                        } else {
                                                            phi_11029_ = f32();
                                                            phi_11030_ = true;
                                                        }
                                                        let _e2836 = phi_11029_;
                                                        let _e2838 = phi_11030_;
                                                        phi_10919_ = _e2790;
                                                        phi_10921_ = _e2792;
                                                        phi_10923_ = _e2836;
                                                        phi_11031_ = _e2792;
                                                        phi_11032_ = _e2794;
                                                        phi_11033_ = _e2838;
                                                    } else {
                                                        phi_10919_ = f32();
                                                        phi_10921_ = f32();
                                                        phi_10923_ = f32();
                                                        phi_11031_ = f32();
                                                        phi_11032_ = false;
                                                        phi_11033_ = false;
                                                    }
                                                    let _e2840 = phi_10919_;
                                                    let _e2842 = phi_10921_;
                                                    let _e2844 = phi_10923_;
                                                    let _e2846 = phi_11031_;
                                                    let _e2848 = phi_11032_;
                                                    let _e2850 = phi_11033_;
                                                    local_24 = _e2850;
                                                    local_64 = _e2846;
                                                    continue;
                                                    continuing {
                                                        phi_10915_ = _e2768;
                                                        phi_10918_ = _e2840;
                                                        phi_10920_ = _e2842;
                                                        phi_10922_ = _e2844;
                                                        break if !(_e2848);
                                                    }
                                                }
                                                let _e2853 = local_24;
                                                if _e2853 {
                                                    let _e10279 = local_64;
                                                    phi_11037_ = _e10279;
                                                } else {
                                                    let _e10281 = local_65;
                                                    phi_11037_ = _e10281;
                                                }
                                                let _e2855 = phi_11037_;
                                                phi_11038_ = _e2855;
                                            } else {
                                                phi_11038_ = _e2673;
                                            }
                                            let _e2857 = phi_11038_;
                                            if _e2714 {
                                                if (_e2704 < 0f) {
                                                    phi_11046_ = -1f;
                                                } else {
                                                    phi_11046_ = 1f;
                                                }
                                                let _e2860 = phi_11046_;
                                                phi_11050_ = type_12(0u, 64u);
                                                phi_11053_ = (_e1044 + _e1044);
                                                loop {
                                                    let _e2863 = phi_11050_;
                                                    let _e2865 = phi_11053_;
                                                    if (_e2863.member < _e2863.member_1) {
                                                        phi_11051_ = type_12((_e2863.member + 1u), _e2863.member_1);
                                                        phi_11076_ = type_12(1u, _e2863.member);
                                                    } else {
                                                        phi_11051_ = _e2863;
                                                        phi_11076_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2877 = phi_11051_;
                                                    let _e2879 = phi_11076_;
                                                    if (bitcast<i32>(_e2879.member) != 0i) {
                                                        let _e2883 = (_e2857 + _e2865);
                                                        if (_e2883 < _e2679) {
                                                            let _e2885 = (1f - _e2883);
                                                            let _e2898 = ((_e2860 * ((((_e663 * _e2885) + (_e686 * _e2883)) * (_e2885 * _e2885)) + (((_e709 * _e2885) + (_e720 * _e2883)) * (_e2883 * _e2883)))) > _e1037);
                                                            if _e2898 {
                                                                phi_11106_ = f32();
                                                                phi_11107_ = false;
                                                            } else {
                                                                phi_11106_ = (_e2865 + _e2865);
                                                                phi_11107_ = true;
                                                            }
                                                            let _e2901 = phi_11106_;
                                                            let _e2903 = phi_11107_;
                                                            phi_11108_ = _e2901;
                                                            phi_11109_ = _e2903;
                                                            phi_11110_ = _e2898;
                                                            phi_11111_ = false;
                                                        } else {
                                                            phi_11108_ = f32();
                                                            phi_11109_ = false;
                                                            phi_11110_ = false;
                                                            phi_11111_ = true;
                                                        }
                                                        let _e2905 = phi_11108_;
                                                        let _e2907 = phi_11109_;
                                                        let _e2909 = phi_11110_;
                                                        let _e2911 = phi_11111_;
                                                        phi_11112_ = _e2883;
                                                        phi_11054_ = _e2905;
                                                        phi_11113_ = _e2907;
                                                        phi_11114_ = _e2909;
                                                        phi_11115_ = _e2911;
                                                        phi_11116_ = false;
                                                    } else {
                                                        phi_11112_ = f32();
                                                        phi_11054_ = f32();
                                                        phi_11113_ = false;
                                                        phi_11114_ = false;
                                                        phi_11115_ = false;
                                                        phi_11116_ = true;
                                                    }
                                                    let _e2913 = phi_11112_;
                                                    let _e2915 = phi_11054_;
                                                    let _e2917 = phi_11113_;
                                                    let _e2919 = phi_11114_;
                                                    let _e2921 = phi_11115_;
                                                    let _e2923 = phi_11116_;
                                                    local_25 = _e2919;
                                                    local_66 = _e2921;
                                                    local_67 = _e2923;
                                                    local_68 = _e2913;
                                                    continue;
                                                    continuing {
                                                        phi_11050_ = _e2877;
                                                        phi_11053_ = _e2915;
                                                        break if !(_e2917);
                                                    }
                                                }
                                                let _e2926 = local_25;
                                                if _e2926 {
                                                    phi_11120_ = false;
                                                    phi_11121_ = false;
                                                } else {
                                                    let _e10303 = local_66;
                                                    phi_11120_ = _e10303;
                                                    let _e10306 = local_67;
                                                    phi_11121_ = _e10306;
                                                }
                                                let _e2928 = phi_11120_;
                                                let _e2930 = phi_11121_;
                                                if _e2928 {
                                                    phi_11125_ = true;
                                                } else {
                                                    phi_11125_ = _e2930;
                                                }
                                                let _e2932 = phi_11125_;
                                                if _e2932 {
                                                    phi_11129_ = _e2679;
                                                } else {
                                                    let _e10310 = local_68;
                                                    phi_11129_ = _e10310;
                                                }
                                                let _e2934 = phi_11129_;
                                                phi_11130_ = _e2934;
                                            } else {
                                                phi_11130_ = _e2679;
                                            }
                                            let _e2936 = phi_11130_;
                                            phi_11132_ = type_41(_e2857, _e2936, _e2727);
                                        } else {
                                            phi_11132_ = _e2736;
                                        }
                                        let _e2939 = phi_11132_;
                                        if (_e2939.member > _e2939.member_1) {
                                            phi_14925_ = bool();
                                            phi_14926_ = f32();
                                            phi_14927_ = f32();
                                            phi_14928_ = true;
                                            phi_14929_ = false;
                                            phi_14930_ = false;
                                            phi_14931_ = false;
                                        } else {
                                            let _e2946 = ((_e2939.member_1 - _e2939.member) * 0.5f);
                                            let _e2947 = (_e2939.member + _e2946);
                                            let _e2949 = (_e2946 + (0.000000059604645f * 4f));
                                            let _e2951 = local_18.member_3;
                                            let _e2954 = local_18.member[0u];
                                            if (_e2954[0] < 0f) {
                                                phi_11161_ = -(_e2954[0]);
                                            } else {
                                                phi_11161_ = _e2954[0];
                                            }
                                            let _e2961 = phi_11161_;
                                            if (_e2954[1] < 0f) {
                                                phi_11168_ = -(_e2954[1]);
                                            } else {
                                                phi_11168_ = _e2954[1];
                                            }
                                            let _e2965 = phi_11168_;
                                            if (_e2961 > _e2965) {
                                                phi_11173_ = _e2961;
                                            } else {
                                                phi_11173_ = _e2965;
                                            }
                                            let _e2968 = phi_11173_;
                                            if (_e2954[2] < 0f) {
                                                phi_11180_ = -(_e2954[2]);
                                            } else {
                                                phi_11180_ = _e2954[2];
                                            }
                                            let _e2972 = phi_11180_;
                                            if (_e2968 > _e2972) {
                                                phi_11185_ = _e2968;
                                            } else {
                                                phi_11185_ = _e2972;
                                            }
                                            let _e2975 = phi_11185_;
                                            let _e2977 = local_18.member[1u];
                                            if (_e2977[0] < 0f) {
                                                phi_11198_ = -(_e2977[0]);
                                            } else {
                                                phi_11198_ = _e2977[0];
                                            }
                                            let _e2984 = phi_11198_;
                                            if (_e2977[1] < 0f) {
                                                phi_11205_ = -(_e2977[1]);
                                            } else {
                                                phi_11205_ = _e2977[1];
                                            }
                                            let _e2988 = phi_11205_;
                                            if (_e2984 > _e2988) {
                                                phi_11210_ = _e2984;
                                            } else {
                                                phi_11210_ = _e2988;
                                            }
                                            let _e2991 = phi_11210_;
                                            if (_e2977[2] < 0f) {
                                                phi_11217_ = -(_e2977[2]);
                                            } else {
                                                phi_11217_ = _e2977[2];
                                            }
                                            let _e2995 = phi_11217_;
                                            if (_e2991 > _e2995) {
                                                phi_11222_ = _e2991;
                                            } else {
                                                phi_11222_ = _e2995;
                                            }
                                            let _e2998 = phi_11222_;
                                            if (_e2975 > _e2998) {
                                                phi_11227_ = _e2975;
                                            } else {
                                                phi_11227_ = _e2998;
                                            }
                                            let _e3001 = phi_11227_;
                                            let _e3004 = local_18.member[0u];
                                            let _e3009 = local_18.member[1u];
                                            let _e3019 = (_e3004[0] + ((_e3009[0] - _e3004[0]) * _e2947));
                                            let _e3020 = (_e3004[1] + ((_e3009[1] - _e3004[1]) * _e2947));
                                            let _e3021 = (_e3004[2] + ((_e3009[2] - _e3004[2]) * _e2947));
                                            let _e3023 = local_18.member[1u];
                                            let _e3028 = local_18.member[0u];
                                            let _e3032 = (_e3023[0] - _e3028[0]);
                                            let _e3033 = (_e3023[1] - _e3028[1]);
                                            let _e3034 = (_e3023[2] - _e3028[2]);
                                            if (_e3032 < 0f) {
                                                phi_11286_ = -(_e3032);
                                            } else {
                                                phi_11286_ = _e3032;
                                            }
                                            let _e3038 = phi_11286_;
                                            if (_e3033 < 0f) {
                                                phi_11292_ = -(_e3033);
                                            } else {
                                                phi_11292_ = _e3033;
                                            }
                                            let _e3042 = phi_11292_;
                                            if (_e3038 > _e3042) {
                                                phi_11297_ = _e3038;
                                            } else {
                                                phi_11297_ = _e3042;
                                            }
                                            let _e3045 = phi_11297_;
                                            if (_e3034 < 0f) {
                                                phi_11303_ = -(_e3034);
                                            } else {
                                                phi_11303_ = _e3034;
                                            }
                                            let _e3049 = phi_11303_;
                                            if (_e3045 > _e3049) {
                                                phi_11308_ = _e3045;
                                            } else {
                                                phi_11308_ = _e3049;
                                            }
                                            let _e3052 = phi_11308_;
                                            let _e3058 = ((((_e2949 * _e3052) * 1.01f) + ((_e3001 + _e2951) * (0.000000059604645f * 8f))) + _e2951);
                                            if (_e3019 < 0f) {
                                                phi_11320_ = -(_e3019);
                                            } else {
                                                phi_11320_ = _e3019;
                                            }
                                            let _e3062 = phi_11320_;
                                            if (_e3020 < 0f) {
                                                phi_11326_ = -(_e3020);
                                            } else {
                                                phi_11326_ = _e3020;
                                            }
                                            let _e3066 = phi_11326_;
                                            if (_e3062 > _e3066) {
                                                phi_11331_ = _e3062;
                                            } else {
                                                phi_11331_ = _e3066;
                                            }
                                            let _e3069 = phi_11331_;
                                            if (_e3021 < 0f) {
                                                phi_11337_ = -(_e3021);
                                            } else {
                                                phi_11337_ = _e3021;
                                            }
                                            let _e3073 = phi_11337_;
                                            if (_e3069 > _e3073) {
                                                phi_11342_ = _e3069;
                                            } else {
                                                phi_11342_ = _e3073;
                                            }
                                            let _e3076 = phi_11342_;
                                            local_2 = type_26(array<f32, 3>(_e3019, _e3020, _e3021), _e3058, (_e3076 + _e3058));
                                            let _e3082 = local_18.member_3;
                                            let _e3084 = local_18.member_1[0u];
                                            if (_e3084[0] < 0f) {
                                                phi_11368_ = -(_e3084[0]);
                                            } else {
                                                phi_11368_ = _e3084[0];
                                            }
                                            let _e3091 = phi_11368_;
                                            if (_e3084[1] < 0f) {
                                                phi_11375_ = -(_e3084[1]);
                                            } else {
                                                phi_11375_ = _e3084[1];
                                            }
                                            let _e3095 = phi_11375_;
                                            if (_e3091 > _e3095) {
                                                phi_11380_ = _e3091;
                                            } else {
                                                phi_11380_ = _e3095;
                                            }
                                            let _e3098 = phi_11380_;
                                            if (_e3084[2] < 0f) {
                                                phi_11387_ = -(_e3084[2]);
                                            } else {
                                                phi_11387_ = _e3084[2];
                                            }
                                            let _e3102 = phi_11387_;
                                            if (_e3098 > _e3102) {
                                                phi_11392_ = _e3098;
                                            } else {
                                                phi_11392_ = _e3102;
                                            }
                                            let _e3105 = phi_11392_;
                                            let _e3107 = local_18.member_1[1u];
                                            if (_e3107[0] < 0f) {
                                                phi_11405_ = -(_e3107[0]);
                                            } else {
                                                phi_11405_ = _e3107[0];
                                            }
                                            let _e3114 = phi_11405_;
                                            if (_e3107[1] < 0f) {
                                                phi_11412_ = -(_e3107[1]);
                                            } else {
                                                phi_11412_ = _e3107[1];
                                            }
                                            let _e3118 = phi_11412_;
                                            if (_e3114 > _e3118) {
                                                phi_11417_ = _e3114;
                                            } else {
                                                phi_11417_ = _e3118;
                                            }
                                            let _e3121 = phi_11417_;
                                            if (_e3107[2] < 0f) {
                                                phi_11424_ = -(_e3107[2]);
                                            } else {
                                                phi_11424_ = _e3107[2];
                                            }
                                            let _e3125 = phi_11424_;
                                            if (_e3121 > _e3125) {
                                                phi_11429_ = _e3121;
                                            } else {
                                                phi_11429_ = _e3125;
                                            }
                                            let _e3128 = phi_11429_;
                                            if (_e3105 > _e3128) {
                                                phi_11434_ = _e3105;
                                            } else {
                                                phi_11434_ = _e3128;
                                            }
                                            let _e3131 = phi_11434_;
                                            let _e3134 = local_18.member_1[0u];
                                            let _e3139 = local_18.member_1[1u];
                                            let _e3149 = (_e3134[0] + ((_e3139[0] - _e3134[0]) * _e2947));
                                            let _e3150 = (_e3134[1] + ((_e3139[1] - _e3134[1]) * _e2947));
                                            let _e3151 = (_e3134[2] + ((_e3139[2] - _e3134[2]) * _e2947));
                                            let _e3153 = local_18.member_1[1u];
                                            let _e3158 = local_18.member_1[0u];
                                            let _e3162 = (_e3153[0] - _e3158[0]);
                                            let _e3163 = (_e3153[1] - _e3158[1]);
                                            let _e3164 = (_e3153[2] - _e3158[2]);
                                            if (_e3162 < 0f) {
                                                phi_11493_ = -(_e3162);
                                            } else {
                                                phi_11493_ = _e3162;
                                            }
                                            let _e3168 = phi_11493_;
                                            if (_e3163 < 0f) {
                                                phi_11499_ = -(_e3163);
                                            } else {
                                                phi_11499_ = _e3163;
                                            }
                                            let _e3172 = phi_11499_;
                                            if (_e3168 > _e3172) {
                                                phi_11504_ = _e3168;
                                            } else {
                                                phi_11504_ = _e3172;
                                            }
                                            let _e3175 = phi_11504_;
                                            if (_e3164 < 0f) {
                                                phi_11510_ = -(_e3164);
                                            } else {
                                                phi_11510_ = _e3164;
                                            }
                                            let _e3179 = phi_11510_;
                                            if (_e3175 > _e3179) {
                                                phi_11515_ = _e3175;
                                            } else {
                                                phi_11515_ = _e3179;
                                            }
                                            let _e3182 = phi_11515_;
                                            let _e3188 = ((((_e2949 * _e3182) * 1.01f) + ((_e3131 + _e3082) * (0.000000059604645f * 8f))) + _e3082);
                                            if (_e3149 < 0f) {
                                                phi_11527_ = -(_e3149);
                                            } else {
                                                phi_11527_ = _e3149;
                                            }
                                            let _e3192 = phi_11527_;
                                            if (_e3150 < 0f) {
                                                phi_11533_ = -(_e3150);
                                            } else {
                                                phi_11533_ = _e3150;
                                            }
                                            let _e3196 = phi_11533_;
                                            if (_e3192 > _e3196) {
                                                phi_11538_ = _e3192;
                                            } else {
                                                phi_11538_ = _e3196;
                                            }
                                            let _e3199 = phi_11538_;
                                            if (_e3151 < 0f) {
                                                phi_11544_ = -(_e3151);
                                            } else {
                                                phi_11544_ = _e3151;
                                            }
                                            let _e3203 = phi_11544_;
                                            if (_e3199 > _e3203) {
                                                phi_11549_ = _e3199;
                                            } else {
                                                phi_11549_ = _e3203;
                                            }
                                            let _e3206 = phi_11549_;
                                            local_3 = type_26(array<f32, 3>(_e3149, _e3150, _e3151), _e3188, (_e3206 + _e3188));
                                            let _e3212 = local_18.member_3;
                                            let _e3214 = local_18.member_2[0u];
                                            if (_e3214[0] < 0f) {
                                                phi_11575_ = -(_e3214[0]);
                                            } else {
                                                phi_11575_ = _e3214[0];
                                            }
                                            let _e3221 = phi_11575_;
                                            if (_e3214[1] < 0f) {
                                                phi_11582_ = -(_e3214[1]);
                                            } else {
                                                phi_11582_ = _e3214[1];
                                            }
                                            let _e3225 = phi_11582_;
                                            if (_e3221 > _e3225) {
                                                phi_11587_ = _e3221;
                                            } else {
                                                phi_11587_ = _e3225;
                                            }
                                            let _e3228 = phi_11587_;
                                            if (_e3214[2] < 0f) {
                                                phi_11594_ = -(_e3214[2]);
                                            } else {
                                                phi_11594_ = _e3214[2];
                                            }
                                            let _e3232 = phi_11594_;
                                            if (_e3228 > _e3232) {
                                                phi_11599_ = _e3228;
                                            } else {
                                                phi_11599_ = _e3232;
                                            }
                                            let _e3235 = phi_11599_;
                                            let _e3237 = local_18.member_2[1u];
                                            if (_e3237[0] < 0f) {
                                                phi_11612_ = -(_e3237[0]);
                                            } else {
                                                phi_11612_ = _e3237[0];
                                            }
                                            let _e3244 = phi_11612_;
                                            if (_e3237[1] < 0f) {
                                                phi_11619_ = -(_e3237[1]);
                                            } else {
                                                phi_11619_ = _e3237[1];
                                            }
                                            let _e3248 = phi_11619_;
                                            if (_e3244 > _e3248) {
                                                phi_11624_ = _e3244;
                                            } else {
                                                phi_11624_ = _e3248;
                                            }
                                            let _e3251 = phi_11624_;
                                            if (_e3237[2] < 0f) {
                                                phi_11631_ = -(_e3237[2]);
                                            } else {
                                                phi_11631_ = _e3237[2];
                                            }
                                            let _e3255 = phi_11631_;
                                            if (_e3251 > _e3255) {
                                                phi_11636_ = _e3251;
                                            } else {
                                                phi_11636_ = _e3255;
                                            }
                                            let _e3258 = phi_11636_;
                                            if (_e3235 > _e3258) {
                                                phi_11641_ = _e3235;
                                            } else {
                                                phi_11641_ = _e3258;
                                            }
                                            let _e3261 = phi_11641_;
                                            let _e3264 = local_18.member_2[0u];
                                            let _e3269 = local_18.member_2[1u];
                                            let _e3279 = (_e3264[0] + ((_e3269[0] - _e3264[0]) * _e2947));
                                            let _e3280 = (_e3264[1] + ((_e3269[1] - _e3264[1]) * _e2947));
                                            let _e3281 = (_e3264[2] + ((_e3269[2] - _e3264[2]) * _e2947));
                                            let _e3283 = local_18.member_2[1u];
                                            let _e3288 = local_18.member_2[0u];
                                            let _e3292 = (_e3283[0] - _e3288[0]);
                                            let _e3293 = (_e3283[1] - _e3288[1]);
                                            let _e3294 = (_e3283[2] - _e3288[2]);
                                            if (_e3292 < 0f) {
                                                phi_11700_ = -(_e3292);
                                            } else {
                                                phi_11700_ = _e3292;
                                            }
                                            let _e3298 = phi_11700_;
                                            if (_e3293 < 0f) {
                                                phi_11706_ = -(_e3293);
                                            } else {
                                                phi_11706_ = _e3293;
                                            }
                                            let _e3302 = phi_11706_;
                                            if (_e3298 > _e3302) {
                                                phi_11711_ = _e3298;
                                            } else {
                                                phi_11711_ = _e3302;
                                            }
                                            let _e3305 = phi_11711_;
                                            if (_e3294 < 0f) {
                                                phi_11717_ = -(_e3294);
                                            } else {
                                                phi_11717_ = _e3294;
                                            }
                                            let _e3309 = phi_11717_;
                                            if (_e3305 > _e3309) {
                                                phi_11722_ = _e3305;
                                            } else {
                                                phi_11722_ = _e3309;
                                            }
                                            let _e3312 = phi_11722_;
                                            let _e3318 = ((((_e2949 * _e3312) * 1.01f) + ((_e3261 + _e3212) * (0.000000059604645f * 8f))) + _e3212);
                                            if (_e3279 < 0f) {
                                                phi_11734_ = -(_e3279);
                                            } else {
                                                phi_11734_ = _e3279;
                                            }
                                            let _e3322 = phi_11734_;
                                            if (_e3280 < 0f) {
                                                phi_11740_ = -(_e3280);
                                            } else {
                                                phi_11740_ = _e3280;
                                            }
                                            let _e3326 = phi_11740_;
                                            if (_e3322 > _e3326) {
                                                phi_11745_ = _e3322;
                                            } else {
                                                phi_11745_ = _e3326;
                                            }
                                            let _e3329 = phi_11745_;
                                            if (_e3281 < 0f) {
                                                phi_11751_ = -(_e3281);
                                            } else {
                                                phi_11751_ = _e3281;
                                            }
                                            let _e3333 = phi_11751_;
                                            if (_e3329 > _e3333) {
                                                phi_11756_ = _e3329;
                                            } else {
                                                phi_11756_ = _e3333;
                                            }
                                            let _e3336 = phi_11756_;
                                            local_4 = type_26(array<f32, 3>(_e3279, _e3280, _e3281), _e3318, (_e3336 + _e3318));
                                            let _e3341 = local_3.member;
                                            let _e3346 = local_4.member;
                                            let _e3352 = ((_e3341[1] * _e3346[2]) - (_e3341[2] * _e3346[1]));
                                            let _e3355 = ((_e3341[2] * _e3346[0]) - (_e3341[0] * _e3346[2]));
                                            let _e3358 = ((_e3341[0] * _e3346[1]) - (_e3341[1] * _e3346[0]));
                                            if (_e3352 < 0f) {
                                                phi_11805_ = -(_e3352);
                                            } else {
                                                phi_11805_ = _e3352;
                                            }
                                            let _e3362 = phi_11805_;
                                            if (_e3355 < 0f) {
                                                phi_11811_ = -(_e3355);
                                            } else {
                                                phi_11811_ = _e3355;
                                            }
                                            let _e3366 = phi_11811_;
                                            if (_e3362 > _e3366) {
                                                if (_e3352 < 0f) {
                                                    phi_11821_ = -(_e3352);
                                                } else {
                                                    phi_11821_ = _e3352;
                                                }
                                                let _e3384 = phi_11821_;
                                                if (_e3358 < 0f) {
                                                    phi_11827_ = -(_e3358);
                                                } else {
                                                    phi_11827_ = _e3358;
                                                }
                                                let _e3388 = phi_11827_;
                                                if (_e3384 > _e3388) {
                                                    phi_11832_ = 2u;
                                                    phi_11833_ = 1u;
                                                } else {
                                                    phi_11832_ = 1u;
                                                    phi_11833_ = 0u;
                                                }
                                                let _e3391 = phi_11832_;
                                                let _e3393 = phi_11833_;
                                                phi_11852_ = _e3391;
                                                phi_11853_ = _e3393;
                                            } else {
                                                if (_e3355 < 0f) {
                                                    phi_11839_ = -(_e3355);
                                                } else {
                                                    phi_11839_ = _e3355;
                                                }
                                                let _e3371 = phi_11839_;
                                                if (_e3358 < 0f) {
                                                    phi_11845_ = -(_e3358);
                                                } else {
                                                    phi_11845_ = _e3358;
                                                }
                                                let _e3375 = phi_11845_;
                                                if (_e3371 > _e3375) {
                                                    phi_11850_ = 0u;
                                                    phi_11851_ = 2u;
                                                } else {
                                                    phi_11850_ = 1u;
                                                    phi_11851_ = 0u;
                                                }
                                                let _e3378 = phi_11850_;
                                                let _e3380 = phi_11851_;
                                                phi_11852_ = _e3378;
                                                phi_11853_ = _e3380;
                                            }
                                            let _e3395 = phi_11852_;
                                            let _e3397 = phi_11853_;
                                            let _e3400 = local_3.member[_e3397];
                                            let _e3403 = local_4.member[_e3395];
                                            let _e3407 = local_3.member[_e3395];
                                            let _e3410 = local_4.member[_e3397];
                                            let _e3412 = ((_e3400 * _e3403) - (_e3407 * _e3410));
                                            let _e3414 = local_3.member_1;
                                            let _e3416 = local_4.member_2;
                                            let _e3419 = local_3.member_2;
                                            let _e3421 = local_4.member_1;
                                            let _e3426 = local_3.member_2;
                                            let _e3429 = local_4.member_2;
                                            let _e3437 = local_3.member_2;
                                            let _e3440 = local_4.member_2;
                                            let _e3444 = (((((_e3414 * _e3416) + (_e3419 * _e3421)) * 2.01f) + (((_e3426 * 2f) * (_e3429 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3437) * (1f + _e3440))));
                                            if (_e3412 < 0f) {
                                                phi_11922_ = -(_e3412);
                                            } else {
                                                phi_11922_ = _e3412;
                                            }
                                            let _e3448 = phi_11922_;
                                            if (_e3448 > _e3444) {
                                                if (_e3412 < 0f) {
                                                    phi_11931_ = -1f;
                                                } else {
                                                    phi_11931_ = 1f;
                                                }
                                                let _e3452 = phi_11931_;
                                                let _e3455 = local_2.member[_e3397];
                                                let _e3458 = local_4.member[_e3395];
                                                let _e3462 = local_2.member[_e3395];
                                                let _e3465 = local_4.member[_e3397];
                                                let _e3469 = local_2.member_1;
                                                let _e3471 = local_4.member_2;
                                                let _e3474 = local_2.member_2;
                                                let _e3476 = local_4.member_1;
                                                let _e3481 = local_2.member_2;
                                                let _e3484 = local_4.member_2;
                                                let _e3492 = local_2.member_2;
                                                let _e3495 = local_4.member_2;
                                                let _e3499 = (((((_e3469 * _e3471) + (_e3474 * _e3476)) * 2.01f) + (((_e3481 * 2f) * (_e3484 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3492) * (1f + _e3495))));
                                                let _e3502 = local_3.member[_e3397];
                                                let _e3505 = local_2.member[_e3395];
                                                let _e3509 = local_3.member[_e3395];
                                                let _e3512 = local_2.member[_e3397];
                                                let _e3516 = local_3.member_1;
                                                let _e3518 = local_2.member_2;
                                                let _e3521 = local_3.member_2;
                                                let _e3523 = local_2.member_1;
                                                let _e3528 = local_3.member_2;
                                                let _e3531 = local_2.member_2;
                                                let _e3539 = local_3.member_2;
                                                let _e3542 = local_2.member_2;
                                                let _e3546 = (((((_e3516 * _e3518) + (_e3521 * _e3523)) * 2.01f) + (((_e3528 * 2f) * (_e3531 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3539) * (1f + _e3542))));
                                                let _e3547 = (_e3412 * _e3452);
                                                let _e3548 = (((_e3455 * _e3458) - (_e3462 * _e3465)) * _e3452);
                                                let _e3549 = (((_e3502 * _e3505) - (_e3509 * _e3512)) * _e3452);
                                                if (_e3547 < 0f) {
                                                    phi_12066_ = -(_e3547);
                                                } else {
                                                    phi_12066_ = _e3547;
                                                }
                                                let _e3553 = phi_12066_;
                                                if (_e3548 < 0f) {
                                                    phi_12072_ = -(_e3548);
                                                } else {
                                                    phi_12072_ = _e3548;
                                                }
                                                let _e3557 = phi_12072_;
                                                if (_e3549 < 0f) {
                                                    phi_12079_ = -(_e3549);
                                                } else {
                                                    phi_12079_ = _e3549;
                                                }
                                                let _e3562 = phi_12079_;
                                                let _e3565 = (((_e3553 + _e3557) + _e3562) * (0.000000059604645f * 4f));
                                                local_5 = array<type_33, 4>(type_33(_e3548, _e3499), type_33(_e3549, _e3546), type_33((_e3547 - _e3548), ((_e3444 + _e3499) + _e3565)), type_33((_e3547 - _e3549), ((_e3444 + _e3546) + _e3565)));
                                                phi_12134_ = type_12(0u, 4u);
                                                phi_12137_ = true;
                                                loop {
                                                    let _e3578 = phi_12134_;
                                                    let _e3580 = phi_12137_;
                                                    local_27 = _e3580;
                                                    if (_e3578.member < _e3578.member_1) {
                                                        phi_12135_ = type_12((_e3578.member + 1u), _e3578.member_1);
                                                        phi_12160_ = type_12(1u, _e3578.member);
                                                    } else {
                                                        phi_12135_ = _e3578;
                                                        phi_12160_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3592 = phi_12135_;
                                                    let _e3594 = phi_12160_;
                                                    if (bitcast<i32>(_e3594.member) != 0i) {
                                                        let _e3601 = local_5[_e3594.member_1].member;
                                                        let _e3604 = local_5[_e3594.member_1].member_1;
                                                        let _e3606 = (_e3601 < -(_e3604));
                                                        if _e3606 {
                                                            phi_12187_ = bool();
                                                            phi_12188_ = false;
                                                        } else {
                                                            phi_12187_ = (_e3580 && (_e3601 > _e3604));
                                                            phi_12188_ = true;
                                                        }
                                                        let _e3610 = phi_12187_;
                                                        let _e3612 = phi_12188_;
                                                        phi_12138_ = _e3610;
                                                        phi_12189_ = _e3612;
                                                        phi_12190_ = _e3606;
                                                    } else {
                                                        phi_12138_ = bool();
                                                        phi_12189_ = false;
                                                        phi_12190_ = false;
                                                    }
                                                    let _e3614 = phi_12138_;
                                                    let _e3616 = phi_12189_;
                                                    let _e3618 = phi_12190_;
                                                    local_26 = _e3618;
                                                    continue;
                                                    continuing {
                                                        phi_12134_ = _e3592;
                                                        phi_12137_ = _e3614;
                                                        break if !(_e3616);
                                                    }
                                                }
                                                let _e3621 = local_26;
                                                if _e3621 {
                                                    phi_12194_ = false;
                                                } else {
                                                    phi_12194_ = true;
                                                }
                                                let _e3623 = phi_12194_;
                                                if _e3623 {
                                                    let _e3625 = local_27;
                                                    if _e3625 {
                                                        phi_12201_ = 1u;
                                                    } else {
                                                        phi_12201_ = 2u;
                                                    }
                                                    let _e3627 = phi_12201_;
                                                    phi_12202_ = _e3627;
                                                    phi_12203_ = false;
                                                } else {
                                                    phi_12202_ = u32();
                                                    phi_12203_ = true;
                                                }
                                                let _e3629 = phi_12202_;
                                                let _e3631 = phi_12203_;
                                                phi_12204_ = _e3629;
                                                phi_12205_ = 0u;
                                                phi_12206_ = _e3631;
                                            } else {
                                                phi_12204_ = u32();
                                                phi_12205_ = 2u;
                                                phi_12206_ = true;
                                            }
                                            let _e3633 = phi_12204_;
                                            let _e3635 = phi_12205_;
                                            let _e3637 = phi_12206_;
                                            if _e3637 {
                                                phi_12210_ = _e3635;
                                            } else {
                                                phi_12210_ = _e3633;
                                            }
                                            let _e3639 = phi_12210_;
                                            let _e3640 = (_e3639 == 0u);
                                            if _e3640 {
                                                phi_14919_ = bool();
                                                phi_14920_ = f32();
                                                phi_14921_ = f32();
                                                phi_14922_ = false;
                                                phi_14923_ = false;
                                                phi_14924_ = false;
                                            } else {
                                                if (_e3639 == 1u) {
                                                    phi_12220_ = _e2939.member_2;
                                                } else {
                                                    phi_12220_ = false;
                                                }
                                                let _e3644 = phi_12220_;
                                                let _e3645 = (_e320 * 0.99f);
                                                if _e3644 {
                                                    if ((_e2939.member_1 - _e2939.member) <= _e3645) {
                                                        phi_12232_ = false;
                                                    } else {
                                                        phi_12232_ = true;
                                                    }
                                                    let _e3651 = phi_12232_;
                                                    phi_12233_ = _e3651;
                                                } else {
                                                    phi_12233_ = true;
                                                }
                                                let _e3653 = phi_12233_;
                                                if _e3653 {
                                                    let _e3658 = local_18.member[0u];
                                                    let _e3664 = local_18.member_1[0u];
                                                    let _e3670 = local_18.member_2[0u];
                                                    let _e3674 = (_e3658[0] - _e3664[0]);
                                                    let _e3675 = (_e3658[1] - _e3664[1]);
                                                    let _e3676 = (_e3658[2] - _e3664[2]);
                                                    let _e3685 = local_18.member[1u];
                                                    let _e3691 = local_18.member_1[1u];
                                                    let _e3697 = local_18.member_2[1u];
                                                    let _e3701 = (_e3685[0] - _e3691[0]);
                                                    let _e3702 = (_e3685[1] - _e3691[1]);
                                                    let _e3703 = (_e3685[2] - _e3691[2]);
                                                    let _e3712 = local_18.member[0u];
                                                    if (_e3712[0] < 0f) {
                                                        phi_12381_ = -(_e3712[0]);
                                                    } else {
                                                        phi_12381_ = _e3712[0];
                                                    }
                                                    let _e3719 = phi_12381_;
                                                    if (_e3712[1] < 0f) {
                                                        phi_12388_ = -(_e3712[1]);
                                                    } else {
                                                        phi_12388_ = _e3712[1];
                                                    }
                                                    let _e3723 = phi_12388_;
                                                    if (_e3719 > _e3723) {
                                                        phi_12393_ = _e3719;
                                                    } else {
                                                        phi_12393_ = _e3723;
                                                    }
                                                    let _e3726 = phi_12393_;
                                                    if (_e3712[2] < 0f) {
                                                        phi_12400_ = -(_e3712[2]);
                                                    } else {
                                                        phi_12400_ = _e3712[2];
                                                    }
                                                    let _e3730 = phi_12400_;
                                                    if (_e3726 > _e3730) {
                                                        phi_12405_ = _e3726;
                                                    } else {
                                                        phi_12405_ = _e3730;
                                                    }
                                                    let _e3733 = phi_12405_;
                                                    let _e3736 = local_18.member[1u];
                                                    if (_e3736[0] < 0f) {
                                                        phi_12418_ = -(_e3736[0]);
                                                    } else {
                                                        phi_12418_ = _e3736[0];
                                                    }
                                                    let _e3743 = phi_12418_;
                                                    if (_e3736[1] < 0f) {
                                                        phi_12425_ = -(_e3736[1]);
                                                    } else {
                                                        phi_12425_ = _e3736[1];
                                                    }
                                                    let _e3747 = phi_12425_;
                                                    if (_e3743 > _e3747) {
                                                        phi_12430_ = _e3743;
                                                    } else {
                                                        phi_12430_ = _e3747;
                                                    }
                                                    let _e3750 = phi_12430_;
                                                    if (_e3736[2] < 0f) {
                                                        phi_12437_ = -(_e3736[2]);
                                                    } else {
                                                        phi_12437_ = _e3736[2];
                                                    }
                                                    let _e3754 = phi_12437_;
                                                    if (_e3750 > _e3754) {
                                                        phi_12442_ = _e3750;
                                                    } else {
                                                        phi_12442_ = _e3754;
                                                    }
                                                    let _e3757 = phi_12442_;
                                                    if (_e3733 > _e3757) {
                                                        phi_12447_ = _e3733;
                                                    } else {
                                                        phi_12447_ = _e3757;
                                                    }
                                                    let _e3760 = phi_12447_;
                                                    let _e3762 = local_18.member_3;
                                                    let _e3766 = local_18.member_1[0u];
                                                    if (_e3766[0] < 0f) {
                                                        phi_12464_ = -(_e3766[0]);
                                                    } else {
                                                        phi_12464_ = _e3766[0];
                                                    }
                                                    let _e3773 = phi_12464_;
                                                    if (_e3766[1] < 0f) {
                                                        phi_12471_ = -(_e3766[1]);
                                                    } else {
                                                        phi_12471_ = _e3766[1];
                                                    }
                                                    let _e3777 = phi_12471_;
                                                    if (_e3773 > _e3777) {
                                                        phi_12476_ = _e3773;
                                                    } else {
                                                        phi_12476_ = _e3777;
                                                    }
                                                    let _e3780 = phi_12476_;
                                                    if (_e3766[2] < 0f) {
                                                        phi_12483_ = -(_e3766[2]);
                                                    } else {
                                                        phi_12483_ = _e3766[2];
                                                    }
                                                    let _e3784 = phi_12483_;
                                                    if (_e3780 > _e3784) {
                                                        phi_12488_ = _e3780;
                                                    } else {
                                                        phi_12488_ = _e3784;
                                                    }
                                                    let _e3787 = phi_12488_;
                                                    let _e3790 = local_18.member_1[1u];
                                                    if (_e3790[0] < 0f) {
                                                        phi_12502_ = -(_e3790[0]);
                                                    } else {
                                                        phi_12502_ = _e3790[0];
                                                    }
                                                    let _e3797 = phi_12502_;
                                                    if (_e3790[1] < 0f) {
                                                        phi_12509_ = -(_e3790[1]);
                                                    } else {
                                                        phi_12509_ = _e3790[1];
                                                    }
                                                    let _e3801 = phi_12509_;
                                                    if (_e3797 > _e3801) {
                                                        phi_12514_ = _e3797;
                                                    } else {
                                                        phi_12514_ = _e3801;
                                                    }
                                                    let _e3804 = phi_12514_;
                                                    if (_e3790[2] < 0f) {
                                                        phi_12521_ = -(_e3790[2]);
                                                    } else {
                                                        phi_12521_ = _e3790[2];
                                                    }
                                                    let _e3808 = phi_12521_;
                                                    if (_e3804 > _e3808) {
                                                        phi_12526_ = _e3804;
                                                    } else {
                                                        phi_12526_ = _e3808;
                                                    }
                                                    let _e3811 = phi_12526_;
                                                    if (_e3787 > _e3811) {
                                                        phi_12531_ = _e3787;
                                                    } else {
                                                        phi_12531_ = _e3811;
                                                    }
                                                    let _e3814 = phi_12531_;
                                                    let _e3816 = local_18.member_3;
                                                    let _e3820 = local_18.member_2[0u];
                                                    if (_e3820[0] < 0f) {
                                                        phi_12548_ = -(_e3820[0]);
                                                    } else {
                                                        phi_12548_ = _e3820[0];
                                                    }
                                                    let _e3827 = phi_12548_;
                                                    if (_e3820[1] < 0f) {
                                                        phi_12555_ = -(_e3820[1]);
                                                    } else {
                                                        phi_12555_ = _e3820[1];
                                                    }
                                                    let _e3831 = phi_12555_;
                                                    if (_e3827 > _e3831) {
                                                        phi_12560_ = _e3827;
                                                    } else {
                                                        phi_12560_ = _e3831;
                                                    }
                                                    let _e3834 = phi_12560_;
                                                    if (_e3820[2] < 0f) {
                                                        phi_12567_ = -(_e3820[2]);
                                                    } else {
                                                        phi_12567_ = _e3820[2];
                                                    }
                                                    let _e3838 = phi_12567_;
                                                    if (_e3834 > _e3838) {
                                                        phi_12572_ = _e3834;
                                                    } else {
                                                        phi_12572_ = _e3838;
                                                    }
                                                    let _e3841 = phi_12572_;
                                                    let _e3844 = local_18.member_2[1u];
                                                    if (_e3844[0] < 0f) {
                                                        phi_12586_ = -(_e3844[0]);
                                                    } else {
                                                        phi_12586_ = _e3844[0];
                                                    }
                                                    let _e3851 = phi_12586_;
                                                    if (_e3844[1] < 0f) {
                                                        phi_12593_ = -(_e3844[1]);
                                                    } else {
                                                        phi_12593_ = _e3844[1];
                                                    }
                                                    let _e3855 = phi_12593_;
                                                    if (_e3851 > _e3855) {
                                                        phi_12598_ = _e3851;
                                                    } else {
                                                        phi_12598_ = _e3855;
                                                    }
                                                    let _e3858 = phi_12598_;
                                                    if (_e3844[2] < 0f) {
                                                        phi_12605_ = -(_e3844[2]);
                                                    } else {
                                                        phi_12605_ = _e3844[2];
                                                    }
                                                    let _e3862 = phi_12605_;
                                                    if (_e3858 > _e3862) {
                                                        phi_12610_ = _e3858;
                                                    } else {
                                                        phi_12610_ = _e3862;
                                                    }
                                                    let _e3865 = phi_12610_;
                                                    if (_e3841 > _e3865) {
                                                        phi_12615_ = _e3841;
                                                    } else {
                                                        phi_12615_ = _e3865;
                                                    }
                                                    let _e3868 = phi_12615_;
                                                    let _e3870 = local_18.member_3;
                                                    let _e3877 = local_18.member_3;
                                                    let _e3882 = (_e320 * 0.00390625f);
                                                    local = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    phi_12656_ = type_12(0u, 96u);
                                                    phi_12659_ = _e2939.member;
                                                    phi_12661_ = _e2939.member;
                                                    phi_12663_ = (_e2939.member_1 - _e2939.member);
                                                    phi_12665_ = _e2939.member;
                                                    phi_12667_ = false;
                                                    phi_12669_ = 0u;
                                                    loop {
                                                        let _e3885 = phi_12656_;
                                                        let _e3887 = phi_12659_;
                                                        let _e3889 = phi_12661_;
                                                        let _e3891 = phi_12663_;
                                                        let _e3893 = phi_12665_;
                                                        let _e3895 = phi_12667_;
                                                        let _e3897 = phi_12669_;
                                                        local_30 = _e3887;
                                                        local_75 = _e3889;
                                                        if (_e3885.member < _e3885.member_1) {
                                                            phi_12657_ = type_12((_e3885.member + 1u), _e3885.member_1);
                                                            phi_12692_ = type_12(1u, _e3885.member);
                                                        } else {
                                                            phi_12657_ = _e3885;
                                                            phi_12692_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e3909 = phi_12657_;
                                                        let _e3911 = phi_12692_;
                                                        if (bitcast<i32>(_e3911.member) != 0i) {
                                                            let _e3917 = local_18.member[0u];
                                                            let _e3923 = local_18.member[1u];
                                                            let _e3939 = local_18.member_1[0u];
                                                            let _e3945 = local_18.member_1[1u];
                                                            let _e3961 = local_18.member_2[0u];
                                                            let _e3967 = local_18.member_2[1u];
                                                            let _e3981 = function_3(array<f32, 3>((_e3917[0] + ((_e3923[0] - _e3917[0]) * _e3887)), (_e3917[1] + ((_e3923[1] - _e3917[1]) * _e3887)), (_e3917[2] + ((_e3923[2] - _e3917[2]) * _e3887))), array<f32, 3>((_e3939[0] + ((_e3945[0] - _e3939[0]) * _e3887)), (_e3939[1] + ((_e3945[1] - _e3939[1]) * _e3887)), (_e3939[2] + ((_e3945[2] - _e3939[2]) * _e3887))), array<f32, 3>((_e3961[0] + ((_e3967[0] - _e3961[0]) * _e3887)), (_e3961[1] + ((_e3967[1] - _e3961[1]) * _e3887)), (_e3961[2] + ((_e3967[2] - _e3961[2]) * _e3887))), 1u);
                                                            if (_e3897 == 0u) {
                                                                phi_12820_ = _e3981;
                                                            } else {
                                                                if (_e3897 == 1u) {
                                                                    phi_12806_ = _e3981[0];
                                                                } else {
                                                                    phi_12806_ = 0f;
                                                                }
                                                                let _e3986 = phi_12806_;
                                                                if (_e3897 == 2u) {
                                                                    phi_12812_ = _e3981[1];
                                                                } else {
                                                                    phi_12812_ = 0f;
                                                                }
                                                                let _e3990 = phi_12812_;
                                                                if (_e3897 == 3u) {
                                                                    phi_12818_ = _e3981[2];
                                                                } else {
                                                                    phi_12818_ = 0f;
                                                                }
                                                                let _e3994 = phi_12818_;
                                                                phi_12820_ = array<f32, 3>(_e3986, _e3990, _e3994);
                                                            }
                                                            let _e3997 = phi_12820_;
                                                            if (_e3997[0] < 0f) {
                                                                phi_12827_ = -(_e3997[0]);
                                                            } else {
                                                                phi_12827_ = _e3997[0];
                                                            }
                                                            let _e4002 = phi_12827_;
                                                            if (_e3997[1] < 0f) {
                                                                phi_12834_ = -(_e3997[1]);
                                                            } else {
                                                                phi_12834_ = _e3997[1];
                                                            }
                                                            let _e4007 = phi_12834_;
                                                            if (_e3997[2] < 0f) {
                                                                phi_12842_ = -(_e3997[2]);
                                                            } else {
                                                                phi_12842_ = _e3997[2];
                                                            }
                                                            let _e4013 = phi_12842_;
                                                            let _e4014 = ((_e4002 + _e4007) + _e4013);
                                                            if (_e4014 > 0f) {
                                                                if ((bitcast<u32>(_e4014) & 2139095040u) != 2139095040u) {
                                                                    let _e4019 = (1f / _e4014);
                                                                    let _e4021 = (_e3997[0] * _e4019);
                                                                    let _e4023 = (_e3997[1] * _e4019);
                                                                    let _e4025 = (_e3997[2] * _e4019);
                                                                    let _e4030 = (((_e4021 * _e4021) + (_e4023 * _e4023)) + (_e4025 * _e4025));
                                                                    if (_e4030 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e4030 > 0f) {
                                                                            phi_12879_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_12879_ = 0f;
                                                                        }
                                                                        let _e4083 = phi_12879_;
                                                                        phi_12943_ = _e4083;
                                                                    } else {
                                                                        phi_12886_ = type_14(0i, 5i);
                                                                        phi_12889_ = bitcast<f32>(((bitcast<u32>(_e4030) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e4038 = phi_12886_;
                                                                            let _e4040 = phi_12889_;
                                                                            local_28 = _e4040;
                                                                            if (_e4038.member < _e4038.member_1) {
                                                                                let _e4047 = (_e4038.member + 1i);
                                                                                if ((false == (_e4047 > _e4038.member)) != false) {
                                                                                    phi_12910_ = true;
                                                                                } else {
                                                                                    phi_12910_ = false;
                                                                                }
                                                                                let _e4052 = phi_12910_;
                                                                                if _e4052 {
                                                                                    phi_12916_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_12916_ = type_15(1u, _e4047);
                                                                                }
                                                                                let _e4057 = phi_12916_;
                                                                                phi_12887_ = type_14(_e4057.member_1, _e4038.member_1);
                                                                                phi_12930_ = type_15(1u, _e4038.member);
                                                                            } else {
                                                                                phi_12887_ = _e4038;
                                                                                phi_12930_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e4063 = phi_12887_;
                                                                            let _e4065 = phi_12930_;
                                                                            let _e4068 = (bitcast<i32>(_e4065.member) != 0i);
                                                                            if _e4068 {
                                                                                phi_12890_ = (0.5f * (_e4040 + (_e4030 / _e4040)));
                                                                            } else {
                                                                                phi_12890_ = f32();
                                                                            }
                                                                            let _e4073 = phi_12890_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_12886_ = _e4063;
                                                                                phi_12889_ = _e4073;
                                                                                break if !(_e4068);
                                                                            }
                                                                        }
                                                                        let _e4078 = local_28;
                                                                        phi_12943_ = (_e4078 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e4085 = phi_12943_;
                                                                    let _e4086 = (0.000000059604645f * 12f);
                                                                    let _e4091 = ((((((((_e3760 + _e3762) + (_e3814 + _e3816)) + (_e3868 + _e3870)) * (0.000000059604645f * 16f)) + (_e3877 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e4085) * (1f + _e4086)));
                                                                    let _e4096 = (((_e4021 * _e3658[0]) + (_e4023 * _e3658[1])) + (_e4025 * _e3658[2]));
                                                                    let _e4101 = (((_e4021 * _e3674) + (_e4023 * _e3675)) + (_e4025 * _e3676));
                                                                    let _e4106 = (((_e4021 * (_e3658[0] - _e3670[0])) + (_e4023 * (_e3658[1] - _e3670[1]))) + (_e4025 * (_e3658[2] - _e3670[2])));
                                                                    let _e4111 = (((_e4021 * (_e3674 - _e3670[0])) + (_e4023 * (_e3675 - _e3670[1]))) + (_e4025 * (_e3676 - _e3670[2])));
                                                                    let _e4117 = (((_e4021 * _e3685[0]) + (_e4023 * _e3685[1])) + (_e4025 * _e3685[2]));
                                                                    let _e4122 = (((_e4021 * _e3701) + (_e4023 * _e3702)) + (_e4025 * _e3703));
                                                                    let _e4127 = (((_e4021 * (_e3685[0] - _e3697[0])) + (_e4023 * (_e3685[1] - _e3697[1]))) + (_e4025 * (_e3685[2] - _e3697[2])));
                                                                    let _e4132 = (((_e4021 * (_e3701 - _e3697[0])) + (_e4023 * (_e3702 - _e3697[1]))) + (_e4025 * (_e3703 - _e3697[2])));
                                                                    if (_e4096 < 0f) {
                                                                        phi_13009_ = -(_e4096);
                                                                    } else {
                                                                        phi_13009_ = _e4096;
                                                                    }
                                                                    let _e4137 = phi_13009_;
                                                                    if (_e4117 < 0f) {
                                                                        phi_13015_ = -(_e4117);
                                                                    } else {
                                                                        phi_13015_ = _e4117;
                                                                    }
                                                                    let _e4141 = phi_13015_;
                                                                    if (_e4101 < 0f) {
                                                                        phi_13024_ = -(_e4101);
                                                                    } else {
                                                                        phi_13024_ = _e4101;
                                                                    }
                                                                    let _e4148 = phi_13024_;
                                                                    if (_e4122 < 0f) {
                                                                        phi_13030_ = -(_e4122);
                                                                    } else {
                                                                        phi_13030_ = _e4122;
                                                                    }
                                                                    let _e4152 = phi_13030_;
                                                                    if (_e4106 < 0f) {
                                                                        phi_13039_ = -(_e4106);
                                                                    } else {
                                                                        phi_13039_ = _e4106;
                                                                    }
                                                                    let _e4159 = phi_13039_;
                                                                    if (_e4127 < 0f) {
                                                                        phi_13045_ = -(_e4127);
                                                                    } else {
                                                                        phi_13045_ = _e4127;
                                                                    }
                                                                    let _e4163 = phi_13045_;
                                                                    if (_e4111 < 0f) {
                                                                        phi_13054_ = -(_e4111);
                                                                    } else {
                                                                        phi_13054_ = _e4111;
                                                                    }
                                                                    let _e4170 = phi_13054_;
                                                                    if (_e4132 < 0f) {
                                                                        phi_13060_ = -(_e4132);
                                                                    } else {
                                                                        phi_13060_ = _e4132;
                                                                    }
                                                                    let _e4174 = phi_13060_;
                                                                    phi_13066_ = type_32(array<f32, 4>(_e4096, _e4101, _e4106, _e4111), array<f32, 4>(_e4117, _e4122, _e4127, _e4132), array<f32, 4>((_e4091 + ((_e4137 + _e4141) * _e4086)), (_e4091 + ((_e4148 + _e4152) * _e4086)), (_e4091 + ((_e4159 + _e4163) * _e4086)), (_e4091 + ((_e4170 + _e4174) * _e4086))));
                                                                    phi_13067_ = false;
                                                                } else {
                                                                    phi_13066_ = type_32();
                                                                    phi_13067_ = true;
                                                                }
                                                                let _e4181 = phi_13066_;
                                                                let _e4183 = phi_13067_;
                                                                phi_13068_ = _e4181;
                                                                phi_13069_ = _e4183;
                                                            } else {
                                                                phi_13068_ = type_32();
                                                                phi_13069_ = true;
                                                            }
                                                            let _e4185 = phi_13068_;
                                                            let _e4187 = phi_13069_;
                                                            if _e4187 {
                                                                phi_13077_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                            } else {
                                                                phi_13077_ = _e4185;
                                                            }
                                                            let _e4189 = phi_13077_;
                                                            local_1 = type_32(array<f32, 4>(_e4189.member[0], _e4189.member[1], _e4189.member[2], _e4189.member[3]), array<f32, 4>(_e4189.member_1[0], _e4189.member_1[1], _e4189.member_1[2], _e4189.member_1[3]), array<f32, 4>(_e4189.member_2[0], _e4189.member_2[1], _e4189.member_2[2], _e4189.member_2[3]));
                                                            let _e4209 = (_e3887 - _e3893);
                                                            let _e4213 = local_1.member[0u];
                                                            let _e4216 = local_1.member_1[0u];
                                                            let _e4219 = local_1.member[0u];
                                                            let _e4225 = local_1.member_2[0u];
                                                            if (((_e4213 + ((_e4216 - _e4219) * _e3887)) - _e4225) > 0f) {
                                                                let _e4230 = local_1.member[1u];
                                                                let _e4233 = local_1.member_1[1u];
                                                                let _e4236 = local_1.member[1u];
                                                                let _e4242 = local_1.member_2[1u];
                                                                if (((_e4230 + ((_e4233 - _e4236) * _e3887)) - _e4242) > 0f) {
                                                                    let _e4247 = local_1.member[2u];
                                                                    let _e4250 = local_1.member_1[2u];
                                                                    let _e4253 = local_1.member[2u];
                                                                    let _e4259 = local_1.member_2[2u];
                                                                    if (((_e4247 + ((_e4250 - _e4253) * _e3887)) - _e4259) > 0f) {
                                                                        let _e4264 = local_1.member[3u];
                                                                        let _e4267 = local_1.member_1[3u];
                                                                        let _e4270 = local_1.member[3u];
                                                                        let _e4276 = local_1.member_2[3u];
                                                                        phi_13248_ = (((_e4264 + ((_e4267 - _e4270) * _e3887)) - _e4276) > 0f);
                                                                        phi_13249_ = false;
                                                                    } else {
                                                                        phi_13248_ = bool();
                                                                        phi_13249_ = true;
                                                                    }
                                                                    let _e4280 = phi_13248_;
                                                                    let _e4282 = phi_13249_;
                                                                    phi_13250_ = _e4280;
                                                                    phi_13251_ = _e4282;
                                                                } else {
                                                                    phi_13250_ = bool();
                                                                    phi_13251_ = true;
                                                                }
                                                                let _e4284 = phi_13250_;
                                                                let _e4286 = phi_13251_;
                                                                phi_13252_ = _e4284;
                                                                phi_13253_ = _e4286;
                                                            } else {
                                                                phi_13252_ = bool();
                                                                phi_13253_ = true;
                                                            }
                                                            let _e4288 = phi_13252_;
                                                            let _e4290 = phi_13253_;
                                                            if _e4290 {
                                                                phi_13257_ = false;
                                                            } else {
                                                                phi_13257_ = _e4288;
                                                            }
                                                            let _e4292 = phi_13257_;
                                                            if _e4292 {
                                                                if (_e3887 <= _e3889) {
                                                                    phi_13567_ = true;
                                                                } else {
                                                                    let _e4296 = local.member[0u];
                                                                    let _e4299 = local.member_1[0u];
                                                                    let _e4302 = local.member[0u];
                                                                    let _e4308 = local.member_2[0u];
                                                                    let _e4312 = local_1.member[0u];
                                                                    let _e4315 = local_1.member_1[0u];
                                                                    let _e4318 = local_1.member[0u];
                                                                    let _e4324 = local_1.member_2[0u];
                                                                    if ((((_e4296 + ((_e4299 - _e4302) * _e3887)) - _e4308) + ((_e4312 + ((_e4315 - _e4318) * _e3893)) - _e4324)) > 0f) {
                                                                        let _e4330 = local.member[1u];
                                                                        let _e4333 = local.member_1[1u];
                                                                        let _e4336 = local.member[1u];
                                                                        let _e4342 = local.member_2[1u];
                                                                        let _e4346 = local_1.member[1u];
                                                                        let _e4349 = local_1.member_1[1u];
                                                                        let _e4352 = local_1.member[1u];
                                                                        let _e4358 = local_1.member_2[1u];
                                                                        if ((((_e4330 + ((_e4333 - _e4336) * _e3887)) - _e4342) + ((_e4346 + ((_e4349 - _e4352) * _e3893)) - _e4358)) > 0f) {
                                                                            let _e4364 = local.member[2u];
                                                                            let _e4367 = local.member_1[2u];
                                                                            let _e4370 = local.member[2u];
                                                                            let _e4376 = local.member_2[2u];
                                                                            let _e4380 = local_1.member[2u];
                                                                            let _e4383 = local_1.member_1[2u];
                                                                            let _e4386 = local_1.member[2u];
                                                                            let _e4392 = local_1.member_2[2u];
                                                                            if ((((_e4364 + ((_e4367 - _e4370) * _e3887)) - _e4376) + ((_e4380 + ((_e4383 - _e4386) * _e3893)) - _e4392)) > 0f) {
                                                                                let _e4398 = local.member[3u];
                                                                                let _e4401 = local.member_1[3u];
                                                                                let _e4404 = local.member[3u];
                                                                                let _e4410 = local.member_2[3u];
                                                                                let _e4414 = local_1.member[3u];
                                                                                let _e4417 = local_1.member_1[3u];
                                                                                let _e4420 = local_1.member[3u];
                                                                                let _e4426 = local_1.member_2[3u];
                                                                                phi_13554_ = ((((_e4398 + ((_e4401 - _e4404) * _e3887)) - _e4410) + ((_e4414 + ((_e4417 - _e4420) * _e3893)) - _e4426)) > 0f);
                                                                                phi_13555_ = false;
                                                                            } else {
                                                                                phi_13554_ = bool();
                                                                                phi_13555_ = true;
                                                                            }
                                                                            let _e4431 = phi_13554_;
                                                                            let _e4433 = phi_13555_;
                                                                            phi_13556_ = _e4431;
                                                                            phi_13557_ = _e4433;
                                                                        } else {
                                                                            phi_13556_ = bool();
                                                                            phi_13557_ = true;
                                                                        }
                                                                        let _e4435 = phi_13556_;
                                                                        let _e4437 = phi_13557_;
                                                                        phi_13558_ = _e4435;
                                                                        phi_13559_ = _e4437;
                                                                    } else {
                                                                        phi_13558_ = bool();
                                                                        phi_13559_ = true;
                                                                    }
                                                                    let _e4439 = phi_13558_;
                                                                    let _e4441 = phi_13559_;
                                                                    if _e4441 {
                                                                        phi_13563_ = false;
                                                                    } else {
                                                                        phi_13563_ = _e4439;
                                                                    }
                                                                    let _e4443 = phi_13563_;
                                                                    phi_13567_ = _e4443;
                                                                }
                                                                let _e4445 = phi_13567_;
                                                                if _e4445 {
                                                                    if _e3895 {
                                                                        if (_e3887 >= _e2939.member_1) {
                                                                            phi_13578_ = false;
                                                                        } else {
                                                                            phi_13578_ = true;
                                                                        }
                                                                        let _e4448 = phi_13578_;
                                                                        phi_13579_ = _e4448;
                                                                    } else {
                                                                        phi_13579_ = true;
                                                                    }
                                                                    let _e4450 = phi_13579_;
                                                                    if _e4450 {
                                                                        local = type_32(array<f32, 4>(_e4189.member[0], _e4189.member[1], _e4189.member[2], _e4189.member[3]), array<f32, 4>(_e4189.member_1[0], _e4189.member_1[1], _e4189.member_1[2], _e4189.member_1[3]), array<f32, 4>(_e4189.member_2[0], _e4189.member_2[1], _e4189.member_2[2], _e4189.member_2[3]));
                                                                        let _e4472 = local.member[0u];
                                                                        let _e4475 = local.member_1[0u];
                                                                        let _e4478 = local.member_2[0u];
                                                                        if (_e4472 > _e4478) {
                                                                            if (_e4475 > _e4478) {
                                                                                phi_13653_ = false;
                                                                            } else {
                                                                                phi_13653_ = true;
                                                                            }
                                                                            let _e4482 = phi_13653_;
                                                                            phi_13654_ = _e4482;
                                                                        } else {
                                                                            phi_13654_ = true;
                                                                        }
                                                                        let _e4484 = phi_13654_;
                                                                        if _e4484 {
                                                                            let _e4485 = (_e4475 >= _e4472);
                                                                            if _e4485 {
                                                                                phi_13676_ = f32();
                                                                                phi_13677_ = false;
                                                                            } else {
                                                                                if ((_e4472 - _e4475) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13674_ = (((_e4472 - _e4478) / (_e4472 - _e4475)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13675_ = false;
                                                                                } else {
                                                                                    phi_13674_ = f32();
                                                                                    phi_13675_ = true;
                                                                                }
                                                                                let _e4496 = phi_13674_;
                                                                                let _e4498 = phi_13675_;
                                                                                phi_13676_ = _e4496;
                                                                                phi_13677_ = _e4498;
                                                                            }
                                                                            let _e4500 = phi_13676_;
                                                                            let _e4502 = phi_13677_;
                                                                            phi_13678_ = _e4500;
                                                                            phi_13679_ = _e4485;
                                                                            phi_13680_ = _e4502;
                                                                        } else {
                                                                            phi_13678_ = f32();
                                                                            phi_13679_ = true;
                                                                            phi_13680_ = false;
                                                                        }
                                                                        let _e4504 = phi_13678_;
                                                                        let _e4506 = phi_13679_;
                                                                        let _e4508 = phi_13680_;
                                                                        if _e4506 {
                                                                            phi_13684_ = 2f;
                                                                            phi_13685_ = true;
                                                                        } else {
                                                                            phi_13684_ = _e3887;
                                                                            phi_13685_ = _e4508;
                                                                        }
                                                                        let _e4510 = phi_13684_;
                                                                        let _e4512 = phi_13685_;
                                                                        if _e4512 {
                                                                            phi_13689_ = _e4510;
                                                                        } else {
                                                                            phi_13689_ = _e4504;
                                                                        }
                                                                        let _e4514 = phi_13689_;
                                                                        let _e4517 = local.member[1u];
                                                                        let _e4520 = local.member_1[1u];
                                                                        let _e4523 = local.member_2[1u];
                                                                        if (_e4517 > _e4523) {
                                                                            if (_e4520 > _e4523) {
                                                                                phi_13721_ = false;
                                                                            } else {
                                                                                phi_13721_ = true;
                                                                            }
                                                                            let _e4527 = phi_13721_;
                                                                            phi_13722_ = _e4527;
                                                                        } else {
                                                                            phi_13722_ = true;
                                                                        }
                                                                        let _e4529 = phi_13722_;
                                                                        if _e4529 {
                                                                            let _e4530 = (_e4520 >= _e4517);
                                                                            if _e4530 {
                                                                                phi_13744_ = f32();
                                                                                phi_13745_ = false;
                                                                            } else {
                                                                                if ((_e4517 - _e4520) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13742_ = (((_e4517 - _e4523) / (_e4517 - _e4520)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13743_ = false;
                                                                                } else {
                                                                                    phi_13742_ = f32();
                                                                                    phi_13743_ = true;
                                                                                }
                                                                                let _e4541 = phi_13742_;
                                                                                let _e4543 = phi_13743_;
                                                                                phi_13744_ = _e4541;
                                                                                phi_13745_ = _e4543;
                                                                            }
                                                                            let _e4545 = phi_13744_;
                                                                            let _e4547 = phi_13745_;
                                                                            phi_13746_ = _e4545;
                                                                            phi_13747_ = _e4530;
                                                                            phi_13748_ = _e4547;
                                                                        } else {
                                                                            phi_13746_ = f32();
                                                                            phi_13747_ = true;
                                                                            phi_13748_ = false;
                                                                        }
                                                                        let _e4549 = phi_13746_;
                                                                        let _e4551 = phi_13747_;
                                                                        let _e4553 = phi_13748_;
                                                                        if _e4551 {
                                                                            phi_13752_ = 2f;
                                                                            phi_13753_ = true;
                                                                        } else {
                                                                            phi_13752_ = _e3887;
                                                                            phi_13753_ = _e4553;
                                                                        }
                                                                        let _e4555 = phi_13752_;
                                                                        let _e4557 = phi_13753_;
                                                                        if _e4557 {
                                                                            phi_13757_ = _e4555;
                                                                        } else {
                                                                            phi_13757_ = _e4549;
                                                                        }
                                                                        let _e4559 = phi_13757_;
                                                                        if (_e4514 < _e4559) {
                                                                            phi_13762_ = _e4514;
                                                                        } else {
                                                                            phi_13762_ = _e4559;
                                                                        }
                                                                        let _e4562 = phi_13762_;
                                                                        let _e4565 = local.member[2u];
                                                                        let _e4568 = local.member_1[2u];
                                                                        let _e4571 = local.member_2[2u];
                                                                        if (_e4565 > _e4571) {
                                                                            if (_e4568 > _e4571) {
                                                                                phi_13794_ = false;
                                                                            } else {
                                                                                phi_13794_ = true;
                                                                            }
                                                                            let _e4575 = phi_13794_;
                                                                            phi_13795_ = _e4575;
                                                                        } else {
                                                                            phi_13795_ = true;
                                                                        }
                                                                        let _e4577 = phi_13795_;
                                                                        if _e4577 {
                                                                            let _e4578 = (_e4568 >= _e4565);
                                                                            if _e4578 {
                                                                                phi_13817_ = f32();
                                                                                phi_13818_ = false;
                                                                            } else {
                                                                                if ((_e4565 - _e4568) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13815_ = (((_e4565 - _e4571) / (_e4565 - _e4568)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13816_ = false;
                                                                                } else {
                                                                                    phi_13815_ = f32();
                                                                                    phi_13816_ = true;
                                                                                }
                                                                                let _e4589 = phi_13815_;
                                                                                let _e4591 = phi_13816_;
                                                                                phi_13817_ = _e4589;
                                                                                phi_13818_ = _e4591;
                                                                            }
                                                                            let _e4593 = phi_13817_;
                                                                            let _e4595 = phi_13818_;
                                                                            phi_13819_ = _e4593;
                                                                            phi_13820_ = _e4578;
                                                                            phi_13821_ = _e4595;
                                                                        } else {
                                                                            phi_13819_ = f32();
                                                                            phi_13820_ = true;
                                                                            phi_13821_ = false;
                                                                        }
                                                                        let _e4597 = phi_13819_;
                                                                        let _e4599 = phi_13820_;
                                                                        let _e4601 = phi_13821_;
                                                                        if _e4599 {
                                                                            phi_13825_ = 2f;
                                                                            phi_13826_ = true;
                                                                        } else {
                                                                            phi_13825_ = _e3887;
                                                                            phi_13826_ = _e4601;
                                                                        }
                                                                        let _e4603 = phi_13825_;
                                                                        let _e4605 = phi_13826_;
                                                                        if _e4605 {
                                                                            phi_13830_ = _e4603;
                                                                        } else {
                                                                            phi_13830_ = _e4597;
                                                                        }
                                                                        let _e4607 = phi_13830_;
                                                                        let _e4610 = local.member[3u];
                                                                        let _e4613 = local.member_1[3u];
                                                                        let _e4616 = local.member_2[3u];
                                                                        if (_e4610 > _e4616) {
                                                                            if (_e4613 > _e4616) {
                                                                                phi_13862_ = false;
                                                                            } else {
                                                                                phi_13862_ = true;
                                                                            }
                                                                            let _e4620 = phi_13862_;
                                                                            phi_13863_ = _e4620;
                                                                        } else {
                                                                            phi_13863_ = true;
                                                                        }
                                                                        let _e4622 = phi_13863_;
                                                                        if _e4622 {
                                                                            let _e4623 = (_e4613 >= _e4610);
                                                                            if _e4623 {
                                                                                phi_13885_ = f32();
                                                                                phi_13886_ = false;
                                                                            } else {
                                                                                if ((_e4610 - _e4613) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13883_ = (((_e4610 - _e4616) / (_e4610 - _e4613)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13884_ = false;
                                                                                } else {
                                                                                    phi_13883_ = f32();
                                                                                    phi_13884_ = true;
                                                                                }
                                                                                let _e4634 = phi_13883_;
                                                                                let _e4636 = phi_13884_;
                                                                                phi_13885_ = _e4634;
                                                                                phi_13886_ = _e4636;
                                                                            }
                                                                            let _e4638 = phi_13885_;
                                                                            let _e4640 = phi_13886_;
                                                                            phi_13887_ = _e4638;
                                                                            phi_13888_ = _e4623;
                                                                            phi_13889_ = _e4640;
                                                                        } else {
                                                                            phi_13887_ = f32();
                                                                            phi_13888_ = true;
                                                                            phi_13889_ = false;
                                                                        }
                                                                        let _e4642 = phi_13887_;
                                                                        let _e4644 = phi_13888_;
                                                                        let _e4646 = phi_13889_;
                                                                        if _e4644 {
                                                                            phi_13893_ = 2f;
                                                                            phi_13894_ = true;
                                                                        } else {
                                                                            phi_13893_ = _e3887;
                                                                            phi_13894_ = _e4646;
                                                                        }
                                                                        let _e4648 = phi_13893_;
                                                                        let _e4650 = phi_13894_;
                                                                        if _e4650 {
                                                                            phi_13898_ = _e4648;
                                                                        } else {
                                                                            phi_13898_ = _e4642;
                                                                        }
                                                                        let _e4652 = phi_13898_;
                                                                        if (_e4607 < _e4652) {
                                                                            phi_13903_ = _e4607;
                                                                        } else {
                                                                            phi_13903_ = _e4652;
                                                                        }
                                                                        let _e4655 = phi_13903_;
                                                                        if (_e4562 < _e4655) {
                                                                            phi_13908_ = _e4562;
                                                                        } else {
                                                                            phi_13908_ = _e4655;
                                                                        }
                                                                        let _e4658 = phi_13908_;
                                                                        if (_e4658 > _e3887) {
                                                                            phi_13913_ = _e4658;
                                                                        } else {
                                                                            phi_13913_ = _e3887;
                                                                        }
                                                                        let _e4661 = phi_13913_;
                                                                        let _e4662 = (_e4661 > _e2939.member_1);
                                                                        if _e4662 {
                                                                            phi_14418_ = f32();
                                                                            phi_14419_ = f32();
                                                                            phi_14420_ = false;
                                                                        } else {
                                                                            let _e4663 = (_e4661 - _e3887);
                                                                            if _e3895 {
                                                                                if (_e4663 <= _e3882) {
                                                                                    phi_14408_ = true;
                                                                                } else {
                                                                                    if (_e4663 <= (_e3891 * 0.25f)) {
                                                                                        phi_14407_ = false;
                                                                                    } else {
                                                                                        phi_14407_ = true;
                                                                                    }
                                                                                    let _e4669 = phi_14407_;
                                                                                    phi_14408_ = _e4669;
                                                                                }
                                                                                let _e4671 = phi_14408_;
                                                                                if _e4671 {
                                                                                    phi_14413_ = (_e4209 + _e4209);
                                                                                } else {
                                                                                    phi_14413_ = 0f;
                                                                                }
                                                                                let _e4674 = phi_14413_;
                                                                                phi_14415_ = _e4674;
                                                                            } else {
                                                                                phi_14415_ = (_e2939.member_1 - _e3887);
                                                                            }
                                                                            let _e4676 = phi_14415_;
                                                                            phi_14418_ = _e4676;
                                                                            phi_14419_ = _e4663;
                                                                            phi_14420_ = true;
                                                                        }
                                                                        let _e4678 = phi_14418_;
                                                                        let _e4680 = phi_14419_;
                                                                        let _e4682 = phi_14420_;
                                                                        phi_14422_ = _e4661;
                                                                        phi_14423_ = _e4678;
                                                                        phi_14424_ = _e4680;
                                                                        phi_14426_ = _e4682;
                                                                        phi_14427_ = _e4662;
                                                                        phi_14429_ = false;
                                                                    } else {
                                                                        phi_14422_ = f32();
                                                                        phi_14423_ = f32();
                                                                        phi_14424_ = f32();
                                                                        phi_14426_ = false;
                                                                        phi_14427_ = false;
                                                                        phi_14429_ = true;
                                                                    }
                                                                    let _e4684 = phi_14422_;
                                                                    let _e4686 = phi_14423_;
                                                                    let _e4688 = phi_14424_;
                                                                    let _e4690 = phi_14426_;
                                                                    let _e4692 = phi_14427_;
                                                                    let _e4694 = phi_14429_;
                                                                    phi_14430_ = _e4684;
                                                                    phi_14431_ = _e4686;
                                                                    phi_14432_ = _e4688;
                                                                    phi_14434_ = false;
                                                                    phi_14435_ = _e4690;
                                                                    phi_14436_ = _e4692;
                                                                    phi_14438_ = _e4694;
                                                                } else {
                                                                    phi_14430_ = f32();
                                                                    phi_14431_ = f32();
                                                                    phi_14432_ = f32();
                                                                    phi_14434_ = true;
                                                                    phi_14435_ = false;
                                                                    phi_14436_ = false;
                                                                    phi_14438_ = false;
                                                                }
                                                                let _e4696 = phi_14430_;
                                                                let _e4698 = phi_14431_;
                                                                let _e4700 = phi_14432_;
                                                                let _e4702 = phi_14434_;
                                                                let _e4704 = phi_14435_;
                                                                let _e4706 = phi_14436_;
                                                                let _e4708 = phi_14438_;
                                                                phi_14439_ = _e4696;
                                                                phi_14440_ = _e4698;
                                                                phi_14441_ = _e4700;
                                                                phi_14443_ = _e4702;
                                                                phi_14444_ = _e4704;
                                                                phi_14445_ = _e4706;
                                                                phi_14447_ = _e4708;
                                                            } else {
                                                                phi_14439_ = f32();
                                                                phi_14440_ = f32();
                                                                phi_14441_ = f32();
                                                                phi_14443_ = true;
                                                                phi_14444_ = false;
                                                                phi_14445_ = false;
                                                                phi_14447_ = false;
                                                            }
                                                            let _e4710 = phi_14439_;
                                                            let _e4712 = phi_14440_;
                                                            let _e4714 = phi_14441_;
                                                            let _e4716 = phi_14443_;
                                                            let _e4718 = phi_14444_;
                                                            let _e4720 = phi_14445_;
                                                            let _e4722 = phi_14447_;
                                                            if _e4716 {
                                                                if (_e3887 <= _e3889) {
                                                                    let _e4883 = (_e3897 + 1u);
                                                                    let _e4884 = (_e4883 > 3u);
                                                                    if _e4884 {
                                                                        phi_14460_ = false;
                                                                    } else {
                                                                        phi_14460_ = true;
                                                                    }
                                                                    let _e4886 = phi_14460_;
                                                                    phi_14782_ = _e4883;
                                                                    phi_14783_ = f32();
                                                                    phi_14784_ = false;
                                                                    phi_14785_ = _e4886;
                                                                    phi_14786_ = _e4884;
                                                                } else {
                                                                    let _e4726 = local.member[0u];
                                                                    let _e4729 = local.member_1[0u];
                                                                    let _e4732 = local.member[0u];
                                                                    let _e4738 = local.member_2[0u];
                                                                    let _e4739 = ((_e4726 + ((_e4729 - _e4732) * _e3893)) - _e4738);
                                                                    let _e4742 = local.member[1u];
                                                                    let _e4745 = local.member_1[1u];
                                                                    let _e4748 = local.member[1u];
                                                                    let _e4754 = local.member_2[1u];
                                                                    let _e4755 = ((_e4742 + ((_e4745 - _e4748) * _e3893)) - _e4754);
                                                                    if (_e4739 < _e4755) {
                                                                        phi_14533_ = _e4739;
                                                                    } else {
                                                                        phi_14533_ = _e4755;
                                                                    }
                                                                    let _e4758 = phi_14533_;
                                                                    let _e4761 = local.member[2u];
                                                                    let _e4764 = local.member_1[2u];
                                                                    let _e4767 = local.member[2u];
                                                                    let _e4773 = local.member_2[2u];
                                                                    let _e4774 = ((_e4761 + ((_e4764 - _e4767) * _e3893)) - _e4773);
                                                                    let _e4777 = local.member[3u];
                                                                    let _e4780 = local.member_1[3u];
                                                                    let _e4783 = local.member[3u];
                                                                    let _e4789 = local.member_2[3u];
                                                                    let _e4790 = ((_e4777 + ((_e4780 - _e4783) * _e3893)) - _e4789);
                                                                    if (_e4774 < _e4790) {
                                                                        phi_14606_ = _e4774;
                                                                    } else {
                                                                        phi_14606_ = _e4790;
                                                                    }
                                                                    let _e4793 = phi_14606_;
                                                                    if (_e4758 < _e4793) {
                                                                        phi_14611_ = _e4758;
                                                                    } else {
                                                                        phi_14611_ = _e4793;
                                                                    }
                                                                    let _e4796 = phi_14611_;
                                                                    let _e4799 = local_1.member[0u];
                                                                    let _e4802 = local_1.member_1[0u];
                                                                    let _e4805 = local_1.member[0u];
                                                                    let _e4811 = local_1.member_2[0u];
                                                                    let _e4812 = ((_e4799 + ((_e4802 - _e4805) * _e3887)) - _e4811);
                                                                    let _e4815 = local_1.member[1u];
                                                                    let _e4818 = local_1.member_1[1u];
                                                                    let _e4821 = local_1.member[1u];
                                                                    let _e4827 = local_1.member_2[1u];
                                                                    let _e4828 = ((_e4815 + ((_e4818 - _e4821) * _e3887)) - _e4827);
                                                                    if (_e4812 < _e4828) {
                                                                        phi_14684_ = _e4812;
                                                                    } else {
                                                                        phi_14684_ = _e4828;
                                                                    }
                                                                    let _e4831 = phi_14684_;
                                                                    let _e4834 = local_1.member[2u];
                                                                    let _e4837 = local_1.member_1[2u];
                                                                    let _e4840 = local_1.member[2u];
                                                                    let _e4846 = local_1.member_2[2u];
                                                                    let _e4847 = ((_e4834 + ((_e4837 - _e4840) * _e3887)) - _e4846);
                                                                    let _e4850 = local_1.member[3u];
                                                                    let _e4853 = local_1.member_1[3u];
                                                                    let _e4856 = local_1.member[3u];
                                                                    let _e4862 = local_1.member_2[3u];
                                                                    let _e4863 = ((_e4850 + ((_e4853 - _e4856) * _e3887)) - _e4862);
                                                                    if (_e4847 < _e4863) {
                                                                        phi_14757_ = _e4847;
                                                                    } else {
                                                                        phi_14757_ = _e4863;
                                                                    }
                                                                    let _e4866 = phi_14757_;
                                                                    if (_e4831 < _e4866) {
                                                                        phi_14762_ = _e4831;
                                                                    } else {
                                                                        phi_14762_ = _e4866;
                                                                    }
                                                                    let _e4869 = phi_14762_;
                                                                    if (_e4869 > 0f) {
                                                                        phi_14780_ = 0.5f;
                                                                    } else {
                                                                        let _e4873 = (0.95f * (_e4796 / (_e4796 - _e4869)));
                                                                        if (_e4873 > 0.0625f) {
                                                                            if (_e4873 < 0.9f) {
                                                                                phi_14778_ = _e4873;
                                                                            } else {
                                                                                phi_14778_ = 0.9f;
                                                                            }
                                                                            let _e4877 = phi_14778_;
                                                                            phi_14779_ = _e4877;
                                                                        } else {
                                                                            phi_14779_ = 0.0625f;
                                                                        }
                                                                        let _e4879 = phi_14779_;
                                                                        phi_14780_ = _e4879;
                                                                    }
                                                                    let _e4881 = phi_14780_;
                                                                    phi_14782_ = u32();
                                                                    phi_14783_ = (_e4209 * _e4881);
                                                                    phi_14784_ = true;
                                                                    phi_14785_ = false;
                                                                    phi_14786_ = false;
                                                                }
                                                                let _e4888 = phi_14782_;
                                                                let _e4890 = phi_14783_;
                                                                let _e4892 = phi_14784_;
                                                                let _e4894 = phi_14785_;
                                                                let _e4896 = phi_14786_;
                                                                phi_14787_ = _e4888;
                                                                phi_14788_ = _e3889;
                                                                phi_14789_ = _e4890;
                                                                phi_14790_ = _e3891;
                                                                phi_14791_ = _e3893;
                                                                phi_14792_ = _e3895;
                                                                phi_14793_ = _e3897;
                                                                phi_14794_ = _e4892;
                                                                phi_14795_ = _e4894;
                                                                phi_14796_ = _e4896;
                                                                phi_14797_ = false;
                                                                phi_14799_ = false;
                                                            } else {
                                                                phi_14787_ = u32();
                                                                phi_14788_ = _e4710;
                                                                phi_14789_ = _e4712;
                                                                phi_14790_ = _e4714;
                                                                phi_14791_ = _e3887;
                                                                phi_14792_ = true;
                                                                phi_14793_ = 0u;
                                                                phi_14794_ = _e4718;
                                                                phi_14795_ = false;
                                                                phi_14796_ = false;
                                                                phi_14797_ = _e4720;
                                                                phi_14799_ = _e4722;
                                                            }
                                                            let _e4898 = phi_14787_;
                                                            let _e4900 = phi_14788_;
                                                            let _e4902 = phi_14789_;
                                                            let _e4904 = phi_14790_;
                                                            let _e4906 = phi_14791_;
                                                            let _e4908 = phi_14792_;
                                                            let _e4910 = phi_14793_;
                                                            let _e4912 = phi_14794_;
                                                            let _e4914 = phi_14795_;
                                                            let _e4916 = phi_14796_;
                                                            let _e4918 = phi_14797_;
                                                            let _e4920 = phi_14799_;
                                                            if _e4912 {
                                                                let _e4921 = (_e4906 + _e4902);
                                                                if (_e4921 > _e4900) {
                                                                    phi_14808_ = _e4921;
                                                                } else {
                                                                    phi_14808_ = _e4900;
                                                                }
                                                                let _e4924 = phi_14808_;
                                                                if (_e4924 < _e2939.member_1) {
                                                                    phi_14813_ = _e4924;
                                                                } else {
                                                                    phi_14813_ = _e2939.member_1;
                                                                }
                                                                let _e4927 = phi_14813_;
                                                                if !(_e3895) {
                                                                    phi_14822_ = true;
                                                                } else {
                                                                    phi_14822_ = ((_e4927 - _e4906) > _e3882);
                                                                }
                                                                let _e4931 = phi_14822_;
                                                                if _e4931 {
                                                                    phi_14826_ = false;
                                                                } else {
                                                                    phi_14826_ = true;
                                                                }
                                                                let _e4933 = phi_14826_;
                                                                phi_14827_ = _e4927;
                                                                phi_14828_ = _e4900;
                                                                phi_14829_ = _e4904;
                                                                phi_14830_ = _e4906;
                                                                phi_14831_ = _e4908;
                                                                phi_14832_ = _e4910;
                                                                phi_14833_ = _e4931;
                                                                phi_14834_ = _e4933;
                                                                phi_14835_ = false;
                                                                phi_14836_ = false;
                                                                phi_14838_ = false;
                                                            } else {
                                                                phi_14827_ = _e3887;
                                                                phi_14828_ = _e3889;
                                                                phi_14829_ = _e3891;
                                                                phi_14830_ = _e3893;
                                                                phi_14831_ = _e3895;
                                                                phi_14832_ = _e4898;
                                                                phi_14833_ = _e4914;
                                                                phi_14834_ = false;
                                                                phi_14835_ = _e4916;
                                                                phi_14836_ = _e4918;
                                                                phi_14838_ = _e4920;
                                                            }
                                                            let _e4935 = phi_14827_;
                                                            let _e4937 = phi_14828_;
                                                            let _e4939 = phi_14829_;
                                                            let _e4941 = phi_14830_;
                                                            let _e4943 = phi_14831_;
                                                            let _e4945 = phi_14832_;
                                                            let _e4947 = phi_14833_;
                                                            let _e4949 = phi_14834_;
                                                            let _e4951 = phi_14835_;
                                                            let _e4953 = phi_14836_;
                                                            let _e4955 = phi_14838_;
                                                            phi_12660_ = _e4935;
                                                            phi_12662_ = _e4937;
                                                            phi_12664_ = _e4939;
                                                            phi_12666_ = _e4941;
                                                            phi_12668_ = _e4943;
                                                            phi_12670_ = _e4945;
                                                            phi_14839_ = _e4900;
                                                            phi_14841_ = _e4947;
                                                            phi_14842_ = _e4949;
                                                            phi_14843_ = _e4951;
                                                            phi_14844_ = _e4953;
                                                            phi_14846_ = false;
                                                            phi_14847_ = _e4955;
                                                        } else {
                                                            phi_12660_ = f32();
                                                            phi_12662_ = f32();
                                                            phi_12664_ = f32();
                                                            phi_12666_ = f32();
                                                            phi_12668_ = bool();
                                                            phi_12670_ = u32();
                                                            phi_14839_ = f32();
                                                            phi_14841_ = false;
                                                            phi_14842_ = false;
                                                            phi_14843_ = false;
                                                            phi_14844_ = false;
                                                            phi_14846_ = true;
                                                            phi_14847_ = false;
                                                        }
                                                        let _e4957 = phi_12660_;
                                                        let _e4959 = phi_12662_;
                                                        let _e4961 = phi_12664_;
                                                        let _e4963 = phi_12666_;
                                                        let _e4965 = phi_12668_;
                                                        let _e4967 = phi_12670_;
                                                        let _e4969 = phi_14839_;
                                                        let _e4971 = phi_14841_;
                                                        let _e4973 = phi_14842_;
                                                        let _e4975 = phi_14843_;
                                                        let _e4977 = phi_14844_;
                                                        let _e4979 = phi_14846_;
                                                        let _e4981 = phi_14847_;
                                                        local_29 = _e4973;
                                                        local_69 = _e4975;
                                                        local_70 = _e4977;
                                                        local_71 = _e4979;
                                                        local_72 = _e4981;
                                                        local_73 = _e4973;
                                                        local_74 = _e4969;
                                                        continue;
                                                        continuing {
                                                            phi_12656_ = _e3909;
                                                            phi_12659_ = _e4957;
                                                            phi_12661_ = _e4959;
                                                            phi_12663_ = _e4961;
                                                            phi_12665_ = _e4963;
                                                            phi_12667_ = _e4965;
                                                            phi_12669_ = _e4967;
                                                            break if !(_e4971);
                                                        }
                                                    }
                                                    let _e4984 = local_29;
                                                    if _e4984 {
                                                        phi_14851_ = false;
                                                        phi_14852_ = false;
                                                        phi_14854_ = false;
                                                        phi_14855_ = false;
                                                    } else {
                                                        let _e10641 = local_69;
                                                        phi_14851_ = _e10641;
                                                        let _e10644 = local_70;
                                                        phi_14852_ = _e10644;
                                                        let _e10647 = local_71;
                                                        phi_14854_ = _e10647;
                                                        let _e10650 = local_72;
                                                        phi_14855_ = _e10650;
                                                    }
                                                    let _e4986 = phi_14851_;
                                                    let _e4988 = phi_14852_;
                                                    let _e4990 = phi_14854_;
                                                    let _e4992 = phi_14855_;
                                                    if _e4986 {
                                                        let _e4994 = local_30;
                                                        phi_14860_ = type_30(1u, _e4994);
                                                        phi_14861_ = false;
                                                        phi_14863_ = false;
                                                        phi_14864_ = false;
                                                        phi_14865_ = false;
                                                    } else {
                                                        phi_14860_ = type_30();
                                                        phi_14861_ = _e4988;
                                                        let _e10656 = local_73;
                                                        phi_14863_ = _e10656;
                                                        phi_14864_ = _e4990;
                                                        phi_14865_ = _e4992;
                                                    }
                                                    let _e4997 = phi_14860_;
                                                    let _e4999 = phi_14861_;
                                                    let _e5001 = phi_14863_;
                                                    let _e5003 = phi_14864_;
                                                    let _e5005 = phi_14865_;
                                                    if _e4999 {
                                                        phi_14870_ = type_30(0u, type_30().member_1);
                                                        phi_14872_ = false;
                                                        phi_14873_ = false;
                                                        phi_14874_ = false;
                                                        phi_14875_ = true;
                                                    } else {
                                                        phi_14870_ = _e4997;
                                                        phi_14872_ = _e5001;
                                                        phi_14873_ = _e5003;
                                                        phi_14874_ = _e5005;
                                                        phi_14875_ = _e4986;
                                                    }
                                                    let _e5009 = phi_14870_;
                                                    let _e5011 = phi_14872_;
                                                    let _e5013 = phi_14873_;
                                                    let _e5015 = phi_14874_;
                                                    let _e5017 = phi_14875_;
                                                    if _e5011 {
                                                        let _e10666 = local_74;
                                                        phi_14887_ = _e10666;
                                                        phi_14888_ = true;
                                                        phi_14889_ = false;
                                                        phi_14890_ = false;
                                                    } else {
                                                        let _e10668 = local_75;
                                                        phi_14887_ = _e10668;
                                                        phi_14888_ = _e5013;
                                                        phi_14889_ = _e5015;
                                                        phi_14890_ = _e5017;
                                                    }
                                                    let _e5019 = phi_14887_;
                                                    let _e5021 = phi_14888_;
                                                    let _e5023 = phi_14889_;
                                                    let _e5025 = phi_14890_;
                                                    if _e5021 {
                                                        phi_14895_ = type_30(1u, _e5019);
                                                        phi_14896_ = false;
                                                        phi_14897_ = false;
                                                    } else {
                                                        phi_14895_ = type_30();
                                                        phi_14896_ = _e5023;
                                                        phi_14897_ = _e5025;
                                                    }
                                                    let _e5028 = phi_14895_;
                                                    let _e5030 = phi_14896_;
                                                    let _e5032 = phi_14897_;
                                                    if _e5030 {
                                                        phi_14902_ = type_30(0u, type_30().member_1);
                                                        phi_14903_ = true;
                                                    } else {
                                                        phi_14902_ = _e5009;
                                                        phi_14903_ = _e5032;
                                                    }
                                                    let _e5036 = phi_14902_;
                                                    let _e5038 = phi_14903_;
                                                    if _e5038 {
                                                        phi_14907_ = _e5036;
                                                    } else {
                                                        phi_14907_ = _e5028;
                                                    }
                                                    let _e5040 = phi_14907_;
                                                    let _e5043 = (_e5040.member != 0u);
                                                    if _e5043 {
                                                        phi_14914_ = false;
                                                    } else {
                                                        phi_14914_ = true;
                                                    }
                                                    let _e5045 = phi_14914_;
                                                    phi_14915_ = _e5040.member_1;
                                                    phi_14916_ = _e5045;
                                                    phi_14917_ = _e5043;
                                                    phi_14918_ = false;
                                                } else {
                                                    phi_14915_ = f32();
                                                    phi_14916_ = false;
                                                    phi_14917_ = false;
                                                    phi_14918_ = true;
                                                }
                                                let _e5047 = phi_14915_;
                                                let _e5049 = phi_14916_;
                                                let _e5051 = phi_14917_;
                                                let _e5053 = phi_14918_;
                                                phi_14919_ = _e3644;
                                                phi_14920_ = _e3645;
                                                phi_14921_ = _e5047;
                                                phi_14922_ = _e5049;
                                                phi_14923_ = _e5051;
                                                phi_14924_ = _e5053;
                                            }
                                            let _e5055 = phi_14919_;
                                            let _e5057 = phi_14920_;
                                            let _e5059 = phi_14921_;
                                            let _e5061 = phi_14922_;
                                            let _e5063 = phi_14923_;
                                            let _e5065 = phi_14924_;
                                            phi_14925_ = _e5055;
                                            phi_14926_ = _e5057;
                                            phi_14927_ = _e5059;
                                            phi_14928_ = _e3640;
                                            phi_14929_ = _e5061;
                                            phi_14930_ = _e5063;
                                            phi_14931_ = _e5065;
                                        }
                                        let _e5067 = phi_14925_;
                                        let _e5069 = phi_14926_;
                                        let _e5071 = phi_14927_;
                                        let _e5073 = phi_14928_;
                                        let _e5075 = phi_14929_;
                                        let _e5077 = phi_14930_;
                                        let _e5079 = phi_14931_;
                                        if _e5073 {
                                            phi_14935_ = false;
                                            phi_14936_ = false;
                                            phi_14937_ = false;
                                        } else {
                                            phi_14935_ = _e5075;
                                            phi_14936_ = _e5077;
                                            phi_14937_ = _e5079;
                                        }
                                        let _e5081 = phi_14935_;
                                        let _e5083 = phi_14936_;
                                        let _e5085 = phi_14937_;
                                        phi_14938_ = _e2939;
                                        phi_14939_ = _e5067;
                                        phi_14940_ = _e5069;
                                        phi_14941_ = _e5071;
                                        phi_14942_ = _e2939;
                                        phi_14943_ = _e5073;
                                        phi_14944_ = _e5081;
                                        phi_14945_ = _e5083;
                                        phi_14946_ = _e5085;
                                    } else {
                                        phi_14938_ = type_41();
                                        phi_14939_ = bool();
                                        phi_14940_ = f32();
                                        phi_14941_ = f32();
                                        phi_14942_ = type_41();
                                        phi_14943_ = true;
                                        phi_14944_ = false;
                                        phi_14945_ = false;
                                        phi_14946_ = false;
                                    }
                                    let _e5087 = phi_14938_;
                                    let _e5089 = phi_14939_;
                                    let _e5091 = phi_14940_;
                                    let _e5093 = phi_14941_;
                                    let _e5095 = phi_14942_;
                                    let _e5097 = phi_14943_;
                                    let _e5099 = phi_14944_;
                                    let _e5101 = phi_14945_;
                                    let _e5103 = phi_14946_;
                                    if _e5097 {
                                        phi_14950_ = true;
                                        phi_14951_ = false;
                                        phi_14952_ = false;
                                    } else {
                                        phi_14950_ = _e5099;
                                        phi_14951_ = _e5101;
                                        phi_14952_ = _e5103;
                                    }
                                    let _e5105 = phi_14950_;
                                    let _e5107 = phi_14951_;
                                    let _e5109 = phi_14952_;
                                    phi_14953_ = _e5087;
                                    phi_14954_ = _e5089;
                                    phi_14955_ = _e5091;
                                    phi_14956_ = _e5093;
                                    phi_14957_ = _e5095;
                                    phi_14958_ = _e5105;
                                    phi_14959_ = false;
                                    phi_14960_ = _e5107;
                                    phi_14961_ = _e5109;
                                } else {
                                    phi_14953_ = type_41();
                                    phi_14954_ = bool();
                                    phi_14955_ = f32();
                                    phi_14956_ = f32();
                                    phi_14957_ = type_41();
                                    phi_14958_ = false;
                                    phi_14959_ = true;
                                    phi_14960_ = false;
                                    phi_14961_ = false;
                                }
                                let _e5111 = phi_14953_;
                                let _e5113 = phi_14954_;
                                let _e5115 = phi_14955_;
                                let _e5117 = phi_14956_;
                                let _e5119 = phi_14957_;
                                let _e5121 = phi_14958_;
                                let _e5123 = phi_14959_;
                                let _e5125 = phi_14960_;
                                let _e5127 = phi_14961_;
                                local_31 = _e5123;
                                local_76 = _e5125;
                                local_77 = _e5127;
                                local_32 = _e5113;
                                local_33 = _e5111;
                                local_34 = _e5117;
                                local_35 = _e5115;
                                local_36 = _e5117;
                                local_37 = _e5117;
                                local_38 = _e5119;
                                continue;
                                continuing {
                                    phi_10764_ = _e2662;
                                    break if !(_e5121);
                                }
                            }
                            let _e5130 = local_31;
                            if _e5130 {
                                phi_14966_ = type_30(0u, type_30().member_1);
                                phi_14967_ = false;
                                phi_14968_ = false;
                            } else {
                                phi_14966_ = type_30();
                                let _e10724 = local_76;
                                phi_14967_ = _e10724;
                                let _e10727 = local_77;
                                phi_14968_ = _e10727;
                            }
                            let _e5134 = phi_14966_;
                            let _e5136 = phi_14967_;
                            let _e5138 = phi_14968_;
                            if _e5136 {
                                let _e5140 = local_32;
                                if _e5140 {
                                    let _e5142 = local_33;
                                    let _e5145 = local_34;
                                    let _e5148 = local_35;
                                    if ((_e5142.member_1 - _e5145) <= _e5148) {
                                        let _e5151 = local_36;
                                        phi_14982_ = type_30(1u, _e5151);
                                        phi_14983_ = false;
                                    } else {
                                        phi_14982_ = type_30();
                                        phi_14983_ = true;
                                    }
                                    let _e5154 = phi_14982_;
                                    let _e5156 = phi_14983_;
                                    phi_14984_ = _e5154;
                                    phi_14985_ = _e5156;
                                } else {
                                    phi_14984_ = type_30();
                                    phi_14985_ = true;
                                }
                                let _e5158 = phi_14984_;
                                let _e5160 = phi_14985_;
                                if _e5160 {
                                    let _e5162 = local_37;
                                    phi_14990_ = type_30(2u, _e5162);
                                } else {
                                    phi_14990_ = _e5158;
                                }
                                let _e5165 = phi_14990_;
                                phi_14991_ = _e5165;
                                phi_14992_ = false;
                            } else {
                                phi_14991_ = type_30();
                                phi_14992_ = _e5138;
                            }
                            let _e5167 = phi_14991_;
                            let _e5169 = phi_14992_;
                            if _e5169 {
                                let _e5171 = local_38;
                                phi_14998_ = type_30(1u, _e5171.member);
                                phi_14999_ = true;
                            } else {
                                phi_14998_ = _e5167;
                                phi_14999_ = _e5136;
                            }
                            let _e5175 = phi_14998_;
                            let _e5177 = phi_14999_;
                            phi_15003_ = _e5175;
                            phi_15004_ = _e5134;
                            phi_15005_ = _e5177;
                        } else {
                            phi_15003_ = _e2508;
                            phi_15004_ = type_30();
                            phi_15005_ = true;
                        }
                        let _e5179 = phi_15003_;
                        let _e5181 = phi_15004_;
                        let _e5183 = phi_15005_;
                        phi_15009_ = _e5179;
                        phi_15010_ = _e5181;
                        phi_15011_ = _e5183;
                    }
                    let _e5187 = phi_15009_;
                    let _e5189 = phi_15010_;
                    let _e5191 = phi_15011_;
                    if _e5191 {
                        phi_15015_ = _e5187;
                    } else {
                        phi_15015_ = _e5189;
                    }
                    let _e5193 = phi_15015_;
                    if (_e5193.member == 1u) {
                        if (_e5193.member_1 > _e322) {
                            phi_15026_ = false;
                        } else {
                            phi_15026_ = true;
                        }
                        let _e5199 = phi_15026_;
                        phi_15027_ = _e5199;
                    } else {
                        phi_15027_ = true;
                    }
                    let _e5201 = phi_15027_;
                    if _e5201 {
                        phi_15031_ = false;
                    } else {
                        phi_15031_ = true;
                    }
                    let _e5203 = phi_15031_;
                    if _e5203 {
                        phi_15035_ = 1u;
                    } else {
                        phi_15035_ = 0u;
                    }
                    let _e5205 = phi_15035_;
                    phi_15039_ = type_39(_e5193, _e5205);
                }
                let _e9713 = phi_15039_;
                switch bitcast<i32>(_e9713.member.member) {
                    case 0: {
                        phi_15054_ = type_42(0u, _e9713.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e9724 = function_(_e9713.member.member_1);
                        phi_15054_ = type_42(0u, _e9713.member_1, _e9724, true);
                        break;
                    }
                    case 2: {
                        let _e9720 = function_(_e9713.member.member_1);
                        phi_15054_ = type_42(1u, _e9713.member_1, _e9720, true);
                        break;
                    }
                    default: {
                        phi_15054_ = type_42();
                        break;
                    }
                }
                let _e9728 = phi_15054_;
                let _e9732 = params.member.member.member_12;
                let _e9733 = bitcast<u32>(_e9732);
                if (_e9733 < 8388608u) {
                    phi_15077_ = array<u32, 2>();
                    phi_15078_ = true;
                } else {
                    let _e9737 = ((_e9733 >> bitcast<u32>(31i)) == 1u);
                    if _e9737 {
                        phi_15076_ = array<u32, 2>();
                    } else {
                        phi_15076_ = array<u32, 2>((_e9733 << bitcast<u32>(29i)), ((((_e9733 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e9733 & 8388607u) >> bitcast<u32>(3i))));
                    }
                    let _e9751 = phi_15076_;
                    phi_15077_ = _e9751;
                    phi_15078_ = _e9737;
                }
                let _e9753 = phi_15077_;
                let _e9755 = phi_15078_;
                if _e9755 {
                    phi_15082_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_15082_ = _e9753;
                }
                let _e9757 = phi_15082_;
                if (_e9728.member_2[0] == _e9757[0]) {
                    let _e9763 = params.member.member.member_12;
                    let _e9764 = bitcast<u32>(_e9763);
                    if (_e9764 < 8388608u) {
                        phi_15110_ = array<u32, 2>();
                        phi_15111_ = true;
                    } else {
                        let _e9768 = ((_e9764 >> bitcast<u32>(31i)) == 1u);
                        if _e9768 {
                            phi_15109_ = array<u32, 2>();
                        } else {
                            phi_15109_ = array<u32, 2>((_e9764 << bitcast<u32>(29i)), ((((_e9764 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e9764 & 8388607u) >> bitcast<u32>(3i))));
                        }
                        let _e9782 = phi_15109_;
                        phi_15110_ = _e9782;
                        phi_15111_ = _e9768;
                    }
                    let _e9784 = phi_15110_;
                    let _e9786 = phi_15111_;
                    if _e9786 {
                        phi_15115_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_15115_ = _e9784;
                    }
                    let _e9788 = phi_15115_;
                    phi_15118_ = (_e9728.member_2[1] == _e9788[1]);
                } else {
                    phi_15118_ = false;
                }
                let _e9792 = phi_15118_;
                let _e9794 = params.member.member.member_1;
                if ((_e9794 & 128u) != 0u) {
                    phi_15134_ = true;
                } else {
                    let _e9798 = params.member.member.member_1;
                    if ((_e9798 & 64u) != 0u) {
                        phi_15133_ = _e9792;
                    } else {
                        phi_15133_ = false;
                    }
                    let _e9802 = phi_15133_;
                    phi_15134_ = _e9802;
                }
                let _e9804 = phi_15134_;
                if _e9728.member_3 {
                    if _e9804 {
                        phi_15142_ = false;
                    } else {
                        phi_15142_ = true;
                    }
                    let _e9807 = phi_15142_;
                    phi_15143_ = _e9807;
                } else {
                    phi_15143_ = true;
                }
                let _e9809 = phi_15143_;
                if _e9809 {
                    phi_15148_ = _e9728.member;
                } else {
                    phi_15148_ = 1u;
                }
                let _e9812 = phi_15148_;
                if _e9728.member_3 {
                    phi_15156_ = (_e9812 == 0u);
                } else {
                    phi_15156_ = false;
                }
                let _e9818 = phi_15156_;
                if _e9818 {
                    let _e9823 = (_e9728.member_2[1] >> bitcast<u32>(20i));
                    if (_e9823 <= 896u) {
                        phi_15177_ = 0u;
                    } else {
                        phi_15177_ = ((((_e9823 - 896u) << bitcast<u32>(23i)) | ((_e9728.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e9728.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e9838 = phi_15177_;
                    let _e9840 = atomicMin((&earliest.member[0u]), _e9838);
                }
                phi_15181_ = type_20(1u, 0u, _e194, _e197, _e9728.member_2, _e9728.member_1);
                phi_15182_ = _e9818;
                phi_15183_ = (_e9812 != 0u);
            } else {
                phi_15181_ = type_20(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15182_ = false;
                phi_15183_ = false;
            }
            let _e9842 = phi_15181_;
            let _e9844 = phi_15182_;
            let _e9846 = phi_15183_;
            let _e9849 = params.member.member.member_1;
            if ((_e9849 & 16u) != 0u) {
                if (_e123 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e9844 {
                    let _e9855 = atomicAdd((&counters[0u]), 1u);
                    phi_15202_ = _e9855;
                } else {
                    phi_15202_ = 0u;
                }
                let _e9857 = phi_15202_;
                workgroupBarrier();
                if (_e123 == 0u) {
                    let _e9860 = atomicLoad((&counters[0u]));
                    if (_e9860 > 0u) {
                        let _e9863 = atomicAdd((&contacts.member[0u]), _e9860);
                        atomicStore((&counters[1u]), _e9863);
                    }
                }
                workgroupBarrier();
                let _e9866 = atomicLoad((&counters[1u]));
                let _e9867 = (_e9866 + _e9857);
                if _e9844 {
                    let _e9870 = params.member.member_1.member_3;
                    if (_e9867 < _e9870) {
                        let _e9872 = (7u * _e9867);
                        atomicStore((&contacts.member[(4u + _e9872)]), _e9842.member);
                        atomicStore((&contacts.member[(_e9872 + 5u)]), _e9842.member_1);
                        atomicStore((&contacts.member[(_e9872 + 6u)]), _e9842.member_2);
                        atomicStore((&contacts.member[(_e9872 + 7u)]), _e9842.member_3);
                        atomicStore((&contacts.member[(_e9872 + 8u)]), _e9842.member_4[0]);
                        atomicStore((&contacts.member[(_e9872 + 9u)]), _e9842.member_4[1]);
                        atomicStore((&contacts.member[(_e9872 + 10u)]), _e9842.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e123 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e9846 {
                let _e9899 = atomicAdd((&counters[0u]), 1u);
                phi_15269_ = _e9899;
            } else {
                phi_15269_ = 0u;
            }
            let _e9901 = phi_15269_;
            workgroupBarrier();
            if (_e123 == 0u) {
                let _e9904 = atomicLoad((&counters[0u]));
                if (_e9904 > 0u) {
                    let _e9907 = atomicAdd((&undecided.member[0u]), _e9904);
                    atomicStore((&counters[1u]), _e9907);
                }
            }
            workgroupBarrier();
            let _e9910 = atomicLoad((&counters[1u]));
            let _e9911 = (_e9910 + _e9901);
            if _e9846 {
                let _e9914 = params.member.member_2.member;
                if (_e9911 < _e9914) {
                    let _e9918 = (2u * _e9911);
                    atomicStore((&undecided.member[(4u + _e9918)]), _e9842.member_2);
                    atomicStore((&undecided.member[(_e9918 + 5u)]), _e9842.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_292_ = _e179;
            break if !(_e185);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
