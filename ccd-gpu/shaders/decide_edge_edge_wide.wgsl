struct type_8 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_9 {
    member: type_8,
}

struct type_12 {
    member: array<u32>,
}

struct type_14 {
    member: array<array<u32, 2>>,
}

struct type_17 {
    member: i32,
    member_1: i32,
}

struct type_18 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: u32,
    member_1: u32,
}

struct type_23 {
    member: array<array<f64, 3>>,
}

struct type_25 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_30 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_32 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_33 {
    member: f64,
    member_1: f64,
}

struct type_38 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_39 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_40 {
    member: u32,
    member_1: f64,
}

struct type_41 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_44 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> paths: type_27;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_44;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> wide: type_23;
@group(0) @binding(3) 
var<storage> elements: type_14;
@group(0) @binding(4) 
var<storage> input: type_12;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_44;

fn function_(param: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_6441_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_6441_ = param_2;
    } else {
        phi_6441_ = param_1;
    }
    let _e26 = phi_6441_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_6005_: bool;
    var phi_6006_: bool;
    var phi_6007_: bool;
    var phi_6008_: bool;
    var phi_6012_: bool;
    var phi_5985_: bool;
    var phi_5986_: bool;
    var phi_5987_: bool;
    var phi_5988_: bool;
    var phi_5989_: bool;
    var phi_5990_: bool;
    var phi_5994_: bool;
    var phi_6013_: bool;
    var phi_6043_: array<f64, 3>;
    var phi_6044_: bool;
    var phi_6045_: array<f64, 3>;
    var phi_6046_: bool;
    var phi_6292_: f64;
    var phi_6294_: f64;
    var phi_6336_: f64;
    var phi_6338_: f64;
    var phi_6386_: f64;
    var phi_6388_: f64;
    var phi_6097_: f64;
    var phi_6099_: f64;
    var phi_6147_: f64;
    var phi_6149_: f64;
    var phi_6194_: f64;
    var phi_6196_: f64;
    var phi_6247_: f64;
    var phi_6249_: f64;
    var phi_6403_: array<array<f64, 3>, 4>;
    var phi_6411_: array<f64, 3>;

    let _e21 = (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2]));
    let _e32 = (((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2]));
    let _e43 = (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2]));
    let _e54 = (((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2]));
    let _e65 = (((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2]));
    let _e68 = ((_e21 * _e43) - (_e32 * _e32));
    let _e69 = f64(0f);
    let _e70 = f64(1f);
    let _e74 = (((_e54 * _e43) - (_e65 * _e32)) / _e68);
    let _e78 = (((_e65 * _e21) - (_e54 * _e32)) / _e68);
    if (param_6 != 0u) {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                if (_e74 <= _e70) {
                    phi_5985_ = (_e78 <= _e70);
                    phi_5986_ = false;
                } else {
                    phi_5985_ = bool();
                    phi_5986_ = true;
                }
                let _e99 = phi_5985_;
                let _e101 = phi_5986_;
                phi_5987_ = _e99;
                phi_5988_ = _e101;
            } else {
                phi_5987_ = bool();
                phi_5988_ = true;
            }
            let _e103 = phi_5987_;
            let _e105 = phi_5988_;
            phi_5989_ = _e103;
            phi_5990_ = _e105;
        } else {
            phi_5989_ = bool();
            phi_5990_ = true;
        }
        let _e107 = phi_5989_;
        let _e109 = phi_5990_;
        if _e109 {
            phi_5994_ = false;
        } else {
            phi_5994_ = _e107;
        }
        let _e111 = phi_5994_;
        phi_6013_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_6005_ = ((_e74 + _e78) <= _e70);
                phi_6006_ = false;
            } else {
                phi_6005_ = bool();
                phi_6006_ = true;
            }
            let _e85 = phi_6005_;
            let _e87 = phi_6006_;
            phi_6007_ = _e85;
            phi_6008_ = _e87;
        } else {
            phi_6007_ = bool();
            phi_6008_ = true;
        }
        let _e89 = phi_6007_;
        let _e91 = phi_6008_;
        if _e91 {
            phi_6012_ = false;
        } else {
            phi_6012_ = _e89;
        }
        let _e93 = phi_6012_;
        phi_6013_ = _e93;
    }
    let _e113 = phi_6013_;
    if (_e68 > _e69) {
        if _e113 {
            phi_6043_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_6044_ = false;
        } else {
            phi_6043_ = array<f64, 3>();
            phi_6044_ = true;
        }
        let _e138 = phi_6043_;
        let _e140 = phi_6044_;
        phi_6045_ = _e138;
        phi_6046_ = _e140;
    } else {
        phi_6045_ = array<f64, 3>();
        phi_6046_ = true;
    }
    let _e142 = phi_6045_;
    let _e144 = phi_6046_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_6097_ = _e307;
                } else {
                    phi_6097_ = f64(1f);
                }
                let _e315 = phi_6097_;
                phi_6099_ = _e315;
            } else {
                phi_6099_ = f64(0f);
            }
            let _e317 = phi_6099_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_6147_ = _e353;
                } else {
                    phi_6147_ = f64(1f);
                }
                let _e361 = phi_6147_;
                phi_6149_ = _e361;
            } else {
                phi_6149_ = f64(0f);
            }
            let _e363 = phi_6149_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_6194_ = _e396;
                } else {
                    phi_6194_ = f64(1f);
                }
                let _e404 = phi_6194_;
                phi_6196_ = _e404;
            } else {
                phi_6196_ = f64(0f);
            }
            let _e406 = phi_6196_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_6247_ = _e445;
                } else {
                    phi_6247_ = f64(1f);
                }
                let _e453 = phi_6247_;
                phi_6249_ = _e453;
            } else {
                phi_6249_ = f64(0f);
            }
            let _e455 = phi_6249_;
            phi_6403_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_6292_ = _e174;
                } else {
                    phi_6292_ = f64(1f);
                }
                let _e182 = phi_6292_;
                phi_6294_ = _e182;
            } else {
                phi_6294_ = f64(0f);
            }
            let _e184 = phi_6294_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_6336_ = _e214;
                } else {
                    phi_6336_ = f64(1f);
                }
                let _e222 = phi_6336_;
                phi_6338_ = _e222;
            } else {
                phi_6338_ = f64(0f);
            }
            let _e224 = phi_6338_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_6386_ = _e260;
                } else {
                    phi_6386_ = f64(1f);
                }
                let _e268 = phi_6386_;
                phi_6388_ = _e268;
            } else {
                phi_6388_ = f64(0f);
            }
            let _e270 = phi_6388_;
            phi_6403_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_6403_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_6411_ = _e475;
    } else {
        phi_6411_ = _e142;
    }
    let _e477 = phi_6411_;
    return _e477;
}

fn function_3(param_7: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param_7[0]), f64(param_7[1]), f64(param_7[2]));
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: type_32;
    var local_3: type_32;
    var local_4: type_32;
    var local_5: array<type_33, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: array<f64, 4>;
    var local_9: array<array<f64, 3>, 4>;
    var local_10: array<array<f64, 3>, 4>;
    var local_11: array<f32, 3>;
    var local_12: type_38;
    var phi_225_: u32;
    var phi_241_: u32;
    var phi_262_: u32;
    var phi_263_: u32;
    var phi_266_: type_19;
    var phi_267_: type_19;
    var phi_290_: type_19;
    var phi_549_: type_39;
    var phi_918_: f64;
    var phi_925_: f64;
    var phi_930_: f64;
    var phi_937_: f64;
    var phi_942_: f64;
    var phi_955_: f64;
    var phi_962_: f64;
    var phi_967_: f64;
    var phi_974_: f64;
    var phi_979_: f64;
    var phi_984_: f64;
    var phi_1001_: f64;
    var phi_1008_: f64;
    var phi_1013_: f64;
    var phi_1020_: f64;
    var phi_1025_: f64;
    var phi_1039_: f64;
    var phi_1046_: f64;
    var phi_1051_: f64;
    var phi_1058_: f64;
    var phi_1063_: f64;
    var phi_1068_: f64;
    var phi_1085_: f64;
    var phi_1092_: f64;
    var phi_1097_: f64;
    var phi_1104_: f64;
    var phi_1109_: f64;
    var phi_1123_: f64;
    var phi_1130_: f64;
    var phi_1135_: f64;
    var phi_1142_: f64;
    var phi_1147_: f64;
    var phi_1152_: f64;
    var phi_1189_: f64;
    var phi_1195_: f64;
    var phi_1202_: f64;
    var phi_1209_: f64;
    var phi_1215_: f64;
    var phi_1222_: f64;
    var phi_1228_: f64;
    var phi_1234_: f64;
    var phi_1240_: f64;
    var phi_1247_: f64;
    var phi_1254_: f64;
    var phi_1282_: f64;
    var phi_1287_: f64;
    var phi_1292_: f64;
    var phi_1297_: f64;
    var phi_1302_: f64;
    var phi_1307_: f64;
    var phi_1318_: f64;
    var phi_2901_: f64;
    var phi_2907_: f64;
    var phi_2912_: f64;
    var phi_2918_: f64;
    var phi_2924_: f64;
    var phi_2929_: f64;
    var phi_2934_: f64;
    var phi_2944_: bool;
    var phi_2951_: f64;
    var phi_2959_: f64;
    var phi_3002_: type_17;
    var phi_3005_: f64;
    var phi_3026_: bool;
    var phi_3032_: type_18;
    var phi_3003_: type_17;
    var phi_3046_: type_18;
    var phi_3006_: f64;
    var local_13: f64;
    var phi_2995_: f64;
    var phi_3059_: f64;
    var phi_3065_: f64;
    var phi_3090_: type_19;
    var phi_3093_: u32;
    var phi_3091_: type_19;
    var phi_3116_: type_19;
    var phi_3160_: u32;
    var phi_3161_: u32;
    var phi_3094_: u32;
    var phi_3162_: u32;
    var phi_3182_: type_19;
    var phi_3183_: type_19;
    var phi_3206_: type_19;
    var phi_3260_: f64;
    var phi_3267_: f64;
    var phi_3279_: bool;
    var phi_3280_: bool;
    var phi_3281_: bool;
    var phi_3282_: bool;
    var phi_3286_: bool;
    var phi_3298_: type_41;
    var phi_3299_: type_41;
    var phi_3300_: bool;
    var phi_3301_: type_41;
    var phi_3302_: bool;
    var phi_3315_: f64;
    var phi_3328_: type_19;
    var phi_3331_: f64;
    var phi_3333_: f64;
    var phi_3335_: f64;
    var phi_3329_: type_19;
    var phi_3358_: type_19;
    var phi_3385_: f64;
    var phi_3386_: f64;
    var phi_3414_: f64;
    var phi_3430_: f64;
    var phi_3437_: bool;
    var phi_3438_: bool;
    var phi_3439_: bool;
    var phi_3445_: f64;
    var phi_3446_: f64;
    var phi_3447_: bool;
    var phi_3332_: f64;
    var phi_3334_: f64;
    var phi_3336_: f64;
    var phi_3448_: f64;
    var phi_3449_: bool;
    var phi_3450_: bool;
    var local_14: bool;
    var phi_3454_: f64;
    var phi_3455_: f64;
    var phi_3463_: type_19;
    var phi_3466_: f64;
    var phi_3464_: type_19;
    var phi_3489_: type_19;
    var phi_3532_: f64;
    var phi_3542_: f64;
    var phi_3552_: bool;
    var phi_3554_: bool;
    var phi_3559_: f64;
    var phi_3560_: bool;
    var phi_3561_: f64;
    var phi_3562_: bool;
    var phi_3563_: bool;
    var phi_3564_: bool;
    var phi_3565_: f64;
    var phi_3467_: f64;
    var phi_3566_: bool;
    var phi_3567_: bool;
    var phi_3568_: bool;
    var phi_3569_: bool;
    var local_15: bool;
    var phi_3573_: bool;
    var phi_3574_: bool;
    var phi_3578_: bool;
    var phi_3582_: f64;
    var phi_3583_: f64;
    var phi_3585_: type_41;
    var phi_3616_: f64;
    var phi_3623_: f64;
    var phi_3628_: f64;
    var phi_3635_: f64;
    var phi_3640_: f64;
    var phi_3653_: f64;
    var phi_3660_: f64;
    var phi_3665_: f64;
    var phi_3672_: f64;
    var phi_3677_: f64;
    var phi_3682_: f64;
    var phi_3741_: f64;
    var phi_3747_: f64;
    var phi_3752_: f64;
    var phi_3758_: f64;
    var phi_3763_: f64;
    var phi_3777_: f64;
    var phi_3783_: f64;
    var phi_3788_: f64;
    var phi_3794_: f64;
    var phi_3799_: f64;
    var phi_3825_: f64;
    var phi_3832_: f64;
    var phi_3837_: f64;
    var phi_3844_: f64;
    var phi_3849_: f64;
    var phi_3862_: f64;
    var phi_3869_: f64;
    var phi_3874_: f64;
    var phi_3881_: f64;
    var phi_3886_: f64;
    var phi_3891_: f64;
    var phi_3950_: f64;
    var phi_3956_: f64;
    var phi_3961_: f64;
    var phi_3967_: f64;
    var phi_3972_: f64;
    var phi_3986_: f64;
    var phi_3992_: f64;
    var phi_3997_: f64;
    var phi_4003_: f64;
    var phi_4008_: f64;
    var phi_4034_: f64;
    var phi_4041_: f64;
    var phi_4046_: f64;
    var phi_4053_: f64;
    var phi_4058_: f64;
    var phi_4071_: f64;
    var phi_4078_: f64;
    var phi_4083_: f64;
    var phi_4090_: f64;
    var phi_4095_: f64;
    var phi_4100_: f64;
    var phi_4159_: f64;
    var phi_4165_: f64;
    var phi_4170_: f64;
    var phi_4176_: f64;
    var phi_4181_: f64;
    var phi_4195_: f64;
    var phi_4201_: f64;
    var phi_4206_: f64;
    var phi_4212_: f64;
    var phi_4217_: f64;
    var phi_4266_: f64;
    var phi_4272_: f64;
    var phi_4300_: f64;
    var phi_4306_: f64;
    var phi_4311_: u32;
    var phi_4312_: u32;
    var phi_4282_: f64;
    var phi_4288_: f64;
    var phi_4293_: u32;
    var phi_4294_: u32;
    var phi_4313_: u32;
    var phi_4314_: u32;
    var phi_4385_: f64;
    var phi_4397_: f64;
    var phi_4536_: f64;
    var phi_4542_: f64;
    var phi_4549_: f64;
    var phi_4593_: type_19;
    var phi_4596_: bool;
    var phi_4594_: type_19;
    var phi_4619_: type_19;
    var phi_4646_: bool;
    var phi_4647_: bool;
    var phi_4597_: bool;
    var phi_4648_: bool;
    var phi_4649_: bool;
    var local_16: bool;
    var phi_4653_: bool;
    var local_17: bool;
    var phi_4660_: u32;
    var phi_4661_: u32;
    var phi_4662_: bool;
    var phi_4663_: u32;
    var phi_4664_: u32;
    var phi_4665_: bool;
    var phi_4669_: u32;
    var phi_4690_: bool;
    var phi_4691_: bool;
    var phi_4692_: bool;
    var phi_4889_: f64;
    var phi_4896_: f64;
    var phi_4901_: f64;
    var phi_4908_: f64;
    var phi_4913_: f64;
    var phi_4926_: f64;
    var phi_4933_: f64;
    var phi_4938_: f64;
    var phi_4945_: f64;
    var phi_4950_: f64;
    var phi_4955_: f64;
    var phi_4972_: f64;
    var phi_4979_: f64;
    var phi_4984_: f64;
    var phi_4991_: f64;
    var phi_4996_: f64;
    var phi_5010_: f64;
    var phi_5017_: f64;
    var phi_5022_: f64;
    var phi_5029_: f64;
    var phi_5034_: f64;
    var phi_5039_: f64;
    var phi_5056_: f64;
    var phi_5063_: f64;
    var phi_5068_: f64;
    var phi_5075_: f64;
    var phi_5080_: f64;
    var phi_5094_: f64;
    var phi_5101_: f64;
    var phi_5106_: f64;
    var phi_5113_: f64;
    var phi_5118_: f64;
    var phi_5123_: f64;
    var phi_5143_: type_19;
    var phi_5146_: f64;
    var phi_5144_: type_19;
    var phi_5169_: type_19;
    var phi_5280_: f64;
    var phi_5287_: f64;
    var phi_5295_: f64;
    var phi_5340_: type_17;
    var phi_5343_: f64;
    var phi_5364_: bool;
    var phi_5370_: type_18;
    var phi_5341_: type_17;
    var phi_5384_: type_18;
    var phi_5344_: f64;
    var local_18: f64;
    var phi_5333_: f64;
    var phi_5397_: f64;
    var phi_5410_: type_19;
    var phi_5413_: f64;
    var phi_5411_: type_19;
    var phi_5436_: type_19;
    var phi_5487_: f64;
    var phi_5493_: f64;
    var phi_5507_: bool;
    var phi_5508_: bool;
    var phi_5542_: f64;
    var phi_5543_: f64;
    var phi_5544_: f64;
    var phi_5545_: bool;
    var phi_5549_: bool;
    var phi_5550_: f64;
    var phi_5551_: bool;
    var phi_5552_: bool;
    var phi_5553_: bool;
    var phi_5554_: f64;
    var phi_5555_: bool;
    var phi_5556_: bool;
    var phi_5557_: bool;
    var phi_5414_: f64;
    var phi_5558_: bool;
    var phi_5559_: bool;
    var phi_5560_: bool;
    var phi_5561_: bool;
    var local_19: bool;
    var local_20: f64;
    var local_21: f64;
    var local_22: f64;
    var phi_5579_: bool;
    var phi_5580_: bool;
    var phi_5581_: bool;
    var phi_5582_: bool;
    var phi_5583_: bool;
    var phi_5584_: bool;
    var phi_5585_: bool;
    var phi_5586_: bool;
    var phi_5587_: bool;
    var phi_5588_: bool;
    var phi_5589_: bool;
    var phi_5590_: bool;
    var phi_5591_: bool;
    var phi_5592_: f64;
    var phi_5593_: f64;
    var phi_5594_: bool;
    var phi_5595_: bool;
    var phi_5596_: bool;
    var phi_5597_: bool;
    var phi_5598_: bool;
    var phi_5599_: bool;
    var phi_5600_: bool;
    var phi_5601_: f64;
    var phi_5602_: f64;
    var phi_5603_: bool;
    var phi_5604_: bool;
    var phi_5605_: bool;
    var phi_5606_: bool;
    var phi_5607_: bool;
    var phi_5608_: bool;
    var phi_5609_: bool;
    var phi_5610_: bool;
    var phi_5611_: f64;
    var phi_5147_: f64;
    var phi_5612_: bool;
    var phi_5613_: bool;
    var phi_5614_: bool;
    var phi_5615_: bool;
    var phi_5616_: bool;
    var phi_5617_: bool;
    var phi_5618_: bool;
    var phi_5619_: bool;
    var phi_5620_: bool;
    var local_23: bool;
    var phi_5625_: type_40;
    var phi_5626_: bool;
    var phi_5627_: bool;
    var phi_5628_: bool;
    var phi_5629_: bool;
    var phi_5630_: bool;
    var phi_5631_: bool;
    var phi_5632_: bool;
    var phi_5636_: f64;
    var phi_5637_: bool;
    var phi_5638_: bool;
    var phi_5639_: bool;
    var phi_5640_: bool;
    var phi_5641_: bool;
    var phi_5642_: bool;
    var phi_5643_: bool;
    var phi_5648_: type_40;
    var phi_5649_: bool;
    var phi_5650_: bool;
    var phi_5651_: bool;
    var phi_5652_: bool;
    var phi_5653_: bool;
    var phi_5654_: bool;
    var local_24: f64;
    var phi_5659_: type_40;
    var phi_5660_: bool;
    var phi_5661_: bool;
    var phi_5662_: bool;
    var phi_5663_: bool;
    var phi_5664_: bool;
    var local_25: f64;
    var phi_5669_: type_40;
    var phi_5670_: bool;
    var phi_5671_: bool;
    var phi_5672_: bool;
    var phi_5673_: bool;
    var local_26: f64;
    var phi_5678_: type_40;
    var phi_5679_: bool;
    var phi_5680_: bool;
    var phi_5681_: bool;
    var phi_5682_: bool;
    var phi_5686_: type_40;
    var phi_5687_: bool;
    var phi_5688_: bool;
    var phi_5689_: bool;
    var phi_5693_: bool;
    var phi_5694_: bool;
    var phi_5698_: bool;
    var phi_5699_: bool;
    var phi_5703_: bool;
    var phi_5704_: bool;
    var local_27: f64;
    var phi_5709_: type_40;
    var phi_5710_: bool;
    var phi_5714_: type_40;
    var phi_5721_: bool;
    var phi_5722_: f64;
    var phi_5723_: bool;
    var phi_5724_: bool;
    var phi_5725_: bool;
    var phi_5726_: f64;
    var phi_5727_: bool;
    var phi_5728_: bool;
    var phi_5729_: bool;
    var phi_5730_: f64;
    var phi_5731_: bool;
    var phi_5732_: bool;
    var phi_5733_: bool;
    var phi_5734_: bool;
    var phi_5738_: bool;
    var phi_5739_: bool;
    var phi_5740_: bool;
    var phi_5741_: f64;
    var phi_5742_: type_41;
    var phi_5743_: bool;
    var phi_5744_: bool;
    var phi_5745_: bool;
    var phi_5746_: bool;
    var local_28: bool;
    var phi_5751_: type_40;
    var phi_5752_: bool;
    var phi_5753_: bool;
    var local_29: f64;
    var phi_5758_: type_40;
    var phi_5759_: bool;
    var local_30: type_41;
    var phi_5765_: type_40;
    var phi_5766_: bool;
    var phi_5770_: type_40;
    var phi_1521_: f64;
    var phi_1528_: f64;
    var phi_1533_: f64;
    var phi_1540_: f64;
    var phi_1545_: f64;
    var phi_1558_: f64;
    var phi_1565_: f64;
    var phi_1570_: f64;
    var phi_1577_: f64;
    var phi_1582_: f64;
    var phi_1587_: f64;
    var phi_1604_: f64;
    var phi_1611_: f64;
    var phi_1616_: f64;
    var phi_1623_: f64;
    var phi_1628_: f64;
    var phi_1642_: f64;
    var phi_1649_: f64;
    var phi_1654_: f64;
    var phi_1661_: f64;
    var phi_1666_: f64;
    var phi_1671_: f64;
    var phi_1688_: f64;
    var phi_1695_: f64;
    var phi_1700_: f64;
    var phi_1707_: f64;
    var phi_1712_: f64;
    var phi_1726_: f64;
    var phi_1733_: f64;
    var phi_1738_: f64;
    var phi_1745_: f64;
    var phi_1750_: f64;
    var phi_1755_: f64;
    var phi_1775_: type_19;
    var phi_1778_: f64;
    var phi_1776_: type_19;
    var phi_1801_: type_19;
    var phi_1912_: f64;
    var phi_1919_: f64;
    var phi_1927_: f64;
    var phi_1972_: type_17;
    var phi_1975_: f64;
    var phi_1996_: bool;
    var phi_2002_: type_18;
    var phi_1973_: type_17;
    var phi_2016_: type_18;
    var phi_1976_: f64;
    var local_31: f64;
    var phi_1965_: f64;
    var phi_2029_: f64;
    var phi_2042_: type_19;
    var phi_2045_: f64;
    var phi_2043_: type_19;
    var phi_2068_: type_19;
    var phi_2119_: f64;
    var phi_2125_: f64;
    var phi_2139_: bool;
    var phi_2140_: bool;
    var phi_2174_: f64;
    var phi_2175_: f64;
    var phi_2176_: f64;
    var phi_2177_: bool;
    var phi_2181_: bool;
    var phi_2182_: f64;
    var phi_2183_: bool;
    var phi_2184_: bool;
    var phi_2185_: bool;
    var phi_2186_: f64;
    var phi_2187_: bool;
    var phi_2188_: bool;
    var phi_2189_: bool;
    var phi_2046_: f64;
    var phi_2190_: bool;
    var phi_2191_: bool;
    var phi_2192_: bool;
    var phi_2193_: bool;
    var local_32: bool;
    var local_33: f64;
    var local_34: f64;
    var local_35: f64;
    var phi_2211_: bool;
    var phi_2212_: bool;
    var phi_2213_: bool;
    var phi_2214_: bool;
    var phi_2215_: bool;
    var phi_2216_: bool;
    var phi_2217_: bool;
    var phi_2218_: bool;
    var phi_2219_: bool;
    var phi_2220_: bool;
    var phi_2221_: bool;
    var phi_2222_: bool;
    var phi_2223_: bool;
    var phi_2224_: f64;
    var phi_2225_: f64;
    var phi_2226_: bool;
    var phi_2227_: bool;
    var phi_2228_: bool;
    var phi_2229_: bool;
    var phi_2230_: bool;
    var phi_2231_: bool;
    var phi_2232_: bool;
    var phi_2233_: f64;
    var phi_2234_: f64;
    var phi_2235_: bool;
    var phi_2236_: bool;
    var phi_2237_: bool;
    var phi_2238_: bool;
    var phi_2239_: bool;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2242_: bool;
    var phi_2243_: f64;
    var phi_1779_: f64;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2252_: bool;
    var local_36: bool;
    var phi_2257_: type_40;
    var phi_2258_: bool;
    var phi_2259_: bool;
    var phi_2260_: bool;
    var phi_2261_: bool;
    var phi_2262_: bool;
    var phi_2263_: bool;
    var phi_2264_: bool;
    var phi_2268_: f64;
    var phi_2269_: bool;
    var phi_2270_: bool;
    var phi_2271_: bool;
    var phi_2272_: bool;
    var phi_2273_: bool;
    var phi_2274_: bool;
    var phi_2275_: bool;
    var phi_2280_: type_40;
    var phi_2281_: bool;
    var phi_2282_: bool;
    var phi_2283_: bool;
    var phi_2284_: bool;
    var phi_2285_: bool;
    var phi_2286_: bool;
    var local_37: f64;
    var phi_2291_: type_40;
    var phi_2292_: bool;
    var phi_2293_: bool;
    var phi_2294_: bool;
    var phi_2295_: bool;
    var phi_2296_: bool;
    var local_38: f64;
    var phi_2301_: type_40;
    var phi_2302_: bool;
    var phi_2303_: bool;
    var phi_2304_: bool;
    var phi_2305_: bool;
    var local_39: f64;
    var phi_2310_: type_40;
    var phi_2311_: bool;
    var phi_2312_: bool;
    var phi_2313_: bool;
    var phi_2314_: bool;
    var phi_2318_: type_40;
    var phi_2319_: bool;
    var phi_2320_: bool;
    var phi_2321_: bool;
    var phi_2325_: bool;
    var phi_2326_: bool;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_2335_: bool;
    var phi_2336_: bool;
    var local_40: f64;
    var phi_2341_: type_40;
    var phi_2342_: bool;
    var phi_2346_: type_40;
    var phi_2360_: type_19;
    var phi_2361_: type_19;
    var phi_2384_: type_19;
    var phi_2405_: f64;
    var phi_2535_: type_17;
    var phi_2538_: f64;
    var phi_2559_: bool;
    var phi_2565_: type_18;
    var phi_2536_: type_17;
    var phi_2579_: type_18;
    var phi_2539_: f64;
    var local_41: f64;
    var phi_2528_: f64;
    var phi_2592_: f64;
    var phi_2610_: f64;
    var phi_2617_: f64;
    var phi_2622_: f64;
    var phi_2629_: f64;
    var phi_2634_: f64;
    var phi_2647_: f64;
    var phi_2654_: f64;
    var phi_2659_: f64;
    var phi_2666_: f64;
    var phi_2671_: f64;
    var phi_2676_: f64;
    var phi_2693_: f64;
    var phi_2700_: f64;
    var phi_2705_: f64;
    var phi_2712_: f64;
    var phi_2717_: f64;
    var phi_2731_: f64;
    var phi_2738_: f64;
    var phi_2743_: f64;
    var phi_2750_: f64;
    var phi_2755_: f64;
    var phi_2760_: f64;
    var phi_2777_: f64;
    var phi_2784_: f64;
    var phi_2789_: f64;
    var phi_2796_: f64;
    var phi_2801_: f64;
    var phi_2815_: f64;
    var phi_2822_: f64;
    var phi_2827_: f64;
    var phi_2834_: f64;
    var phi_2839_: f64;
    var phi_2844_: f64;
    var phi_2868_: bool;
    var phi_2869_: bool;
    var phi_2870_: bool;
    var local_42: bool;
    var phi_2875_: type_40;
    var phi_2876_: bool;
    var phi_2881_: type_40;
    var phi_2882_: bool;
    var phi_2884_: type_40;
    var phi_2885_: type_40;
    var phi_2886_: bool;
    var phi_2890_: type_40;
    var phi_5774_: type_40;
    var phi_5775_: type_40;
    var phi_5788_: type_30;
    var phi_5811_: u32;
    var phi_5815_: type_29;
    var phi_5816_: bool;
    var phi_5834_: u32;
    var local_43: u32;
    var local_44: f64;
    var local_45: f64;
    var local_46: bool;
    var local_47: bool;
    var local_48: f64;
    var local_49: bool;
    var local_50: bool;
    var local_51: f64;
    var local_52: f64;
    var local_53: bool;
    var local_54: bool;
    var local_55: bool;
    var local_56: bool;
    var local_57: bool;
    var local_58: bool;
    var local_59: bool;
    var local_60: f64;
    var local_61: f64;
    var local_62: bool;
    var local_63: bool;
    var local_64: bool;
    var local_65: bool;
    var local_66: bool;
    var local_67: f64;
    var local_68: f64;
    var local_69: bool;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: bool;
    var local_76: f64;
    var local_77: f64;
    var local_78: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e99 = id_2;
    let _e100 = n_2;
    let _e101 = lane_2;
    let _e113 = ((_e99.y * _e100.x) + _e99.x);
    let _e116 = (_e100.x * _e100.y);
    let _e118 = params.member.member_15;
    let _e120 = input.member[0u];
    if (_e118 < _e120) {
        phi_225_ = _e118;
    } else {
        phi_225_ = _e120;
    }
    let _e123 = phi_225_;
    let _e124 = (_e123 / 64u);
    if ((_e123 % 64u) > 0u) {
        phi_241_ = (_e124 + 1u);
    } else {
        phi_241_ = _e124;
    }
    let _e129 = phi_241_;
    if (_e129 > _e113) {
        let _e131 = (_e129 - _e113);
        if (_e116 == 0u) {
            return;
        }
        let _e133 = (_e131 / _e116);
        if (_e116 == 0u) {
            return;
        }
        if ((_e131 % _e116) > 0u) {
            phi_262_ = (_e133 + 1u);
        } else {
            phi_262_ = _e133;
        }
        let _e139 = phi_262_;
        phi_263_ = _e139;
    } else {
        phi_263_ = 0u;
    }
    let _e141 = phi_263_;
    phi_266_ = type_19(0u, _e141);
    loop {
        let _e144 = phi_266_;
        if (_e144.member < _e144.member_1) {
            phi_267_ = type_19((_e144.member + 1u), _e144.member_1);
            phi_290_ = type_19(1u, _e144.member);
        } else {
            phi_267_ = _e144;
            phi_290_ = type_19(0u, type_19().member_1);
        }
        let _e156 = phi_267_;
        let _e158 = phi_290_;
        let _e162 = (bitcast<i32>(_e158.member) != 0i);
        if _e162 {
            let _e166 = (((_e113 + (_e158.member_1 * _e116)) * 64u) + _e101);
            let _e168 = params.member.member_8;
            if (_e166 < _e123) {
                let _e171 = (2u * _e166);
                let _e174 = input.member[(4u + _e171)];
                let _e177 = input.member[(_e171 + 5u)];
                let _e179 = elements.member[_e174];
                let _e181 = elements.member[_e177];
                let _e187 = params.member.member_1;
                if ((_e187 & 8u) != 0u) {
                    let _e226 = paths.member[_e179[0]];
                    let _e228 = paths.member[_e179[1]];
                    let _e234 = paths.member[_e181[0]];
                    let _e236 = paths.member[_e181[1]];
                    let _e273 = function_3(array<f32, 3>(_e226.member[0], _e226.member[1], _e226.member[2]));
                    let _e274 = function_3(array<f32, 3>(_e228.member[0], _e228.member[1], _e228.member[2]));
                    let _e275 = function_3(array<f32, 3>(_e234.member[0], _e234.member[1], _e234.member[2]));
                    let _e276 = function_3(array<f32, 3>(_e236.member[0], _e236.member[1], _e236.member[2]));
                    let _e278 = function_3(array<f32, 3>(_e226.member_1[0], _e226.member_1[1], _e226.member_1[2]));
                    let _e279 = function_3(array<f32, 3>(_e228.member_1[0], _e228.member_1[1], _e228.member_1[2]));
                    let _e280 = function_3(array<f32, 3>(_e234.member_1[0], _e234.member_1[1], _e234.member_1[2]));
                    let _e281 = function_3(array<f32, 3>(_e236.member_1[0], _e236.member_1[1], _e236.member_1[2]));
                    phi_549_ = type_39(array<array<f64, 3>, 4>(_e273, _e274, _e275, _e276), array<array<f64, 3>, 4>(_e278, _e279, _e280, _e281));
                } else {
                    let _e191 = wide.member[_e179[0]];
                    let _e194 = params.member.member[0u];
                    let _e197 = wide.member[(_e194 + _e179[0])];
                    let _e199 = wide.member[_e179[1]];
                    let _e202 = params.member.member[0u];
                    let _e205 = wide.member[(_e202 + _e179[1])];
                    let _e207 = wide.member[_e181[0]];
                    let _e210 = params.member.member[0u];
                    let _e213 = wide.member[(_e210 + _e181[0])];
                    let _e215 = wide.member[_e181[1]];
                    let _e218 = params.member.member[0u];
                    let _e221 = wide.member[(_e218 + _e181[1])];
                    phi_549_ = type_39(array<array<f64, 3>, 4>(_e191, _e199, _e207, _e215), array<array<f64, 3>, 4>(_e197, _e205, _e213, _e221));
                }
                let _e285 = phi_549_;
                local_12 = type_38(array<array<f64, 3>, 2>(array<f64, 3>((_e285.member[2][0] - _e285.member[0][0]), (_e285.member[2][1] - _e285.member[0][1]), (_e285.member[2][2] - _e285.member[0][2])), array<f64, 3>((_e285.member_1[2][0] - _e285.member_1[0][0]), (_e285.member_1[2][1] - _e285.member_1[0][1]), (_e285.member_1[2][2] - _e285.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e285.member[1][0] - _e285.member[0][0]), (_e285.member[1][1] - _e285.member[0][1]), (_e285.member[1][2] - _e285.member[0][2])), array<f64, 3>((_e285.member_1[1][0] - _e285.member_1[0][0]), (_e285.member_1[1][1] - _e285.member_1[0][1]), (_e285.member_1[1][2] - _e285.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e285.member[2][0] - _e285.member[3][0]), (_e285.member[2][1] - _e285.member[3][1]), (_e285.member[2][2] - _e285.member[3][2])), array<f64, 3>((_e285.member_1[2][0] - _e285.member_1[3][0]), (_e285.member_1[2][1] - _e285.member_1[3][1]), (_e285.member_1[2][2] - _e285.member_1[3][2]))), (0.0lf + 0.0lf));
                let _e366 = params.member.member_7;
                let _e373 = bitcast<f64>(((u64(_e366[1]) * 4294967296lu) + u64(_e366[0])));
                let _e374 = f64(0f);
                let _e377 = local_12.member_1[0u];
                let _e383 = local_12.member_2[0u];
                let _e389 = ((_e377[1] * _e383[2]) - (_e377[2] * _e383[1]));
                let _e392 = ((_e377[2] * _e383[0]) - (_e377[0] * _e383[2]));
                let _e395 = ((_e377[0] * _e383[1]) - (_e377[1] * _e383[0]));
                let _e398 = local_12.member_1[1u];
                let _e404 = local_12.member_2[1u];
                let _e410 = ((_e398[1] * _e404[2]) - (_e398[2] * _e404[1]));
                let _e413 = ((_e398[2] * _e404[0]) - (_e398[0] * _e404[2]));
                let _e416 = ((_e398[0] * _e404[1]) - (_e398[1] * _e404[0]));
                let _e419 = local_12.member_1[0u];
                let _e425 = local_12.member_2[1u];
                let _e440 = local_12.member_1[1u];
                let _e446 = local_12.member_2[0u];
                let _e459 = (((_e419[1] * _e425[2]) - (_e419[2] * _e425[1])) + ((_e440[1] * _e446[2]) - (_e440[2] * _e446[1])));
                let _e460 = (((_e419[2] * _e425[0]) - (_e419[0] * _e425[2])) + ((_e440[2] * _e446[0]) - (_e440[0] * _e446[2])));
                let _e461 = (((_e419[0] * _e425[1]) - (_e419[1] * _e425[0])) + ((_e440[0] * _e446[1]) - (_e440[1] * _e446[0])));
                let _e464 = local_12.member[0u];
                let _e472 = (((_e464[0] * _e389) + (_e464[1] * _e392)) + (_e464[2] * _e395));
                let _e475 = local_12.member[1u];
                let _e486 = local_12.member[0u];
                let _e495 = ((((_e475[0] * _e389) + (_e475[1] * _e392)) + (_e475[2] * _e395)) + (((_e486[0] * _e459) + (_e486[1] * _e460)) + (_e486[2] * _e461)));
                let _e498 = local_12.member[0u];
                let _e509 = local_12.member[1u];
                let _e518 = ((((_e498[0] * _e410) + (_e498[1] * _e413)) + (_e498[2] * _e416)) + (((_e509[0] * _e459) + (_e509[1] * _e460)) + (_e509[2] * _e461)));
                let _e521 = local_12.member[1u];
                let _e529 = (((_e521[0] * _e410) + (_e521[1] * _e413)) + (_e521[2] * _e416));
                let _e532 = local_12.member[0u];
                if (_e532[0] < 0.0lf) {
                    phi_918_ = -(_e532[0]);
                } else {
                    phi_918_ = _e532[0];
                }
                let _e539 = phi_918_;
                if (_e532[1] < 0.0lf) {
                    phi_925_ = -(_e532[1]);
                } else {
                    phi_925_ = _e532[1];
                }
                let _e543 = phi_925_;
                if (_e539 > _e543) {
                    phi_930_ = _e539;
                } else {
                    phi_930_ = _e543;
                }
                let _e546 = phi_930_;
                if (_e532[2] < 0.0lf) {
                    phi_937_ = -(_e532[2]);
                } else {
                    phi_937_ = _e532[2];
                }
                let _e550 = phi_937_;
                if (_e546 > _e550) {
                    phi_942_ = _e546;
                } else {
                    phi_942_ = _e550;
                }
                let _e553 = phi_942_;
                let _e556 = local_12.member[1u];
                if (_e556[0] < 0.0lf) {
                    phi_955_ = -(_e556[0]);
                } else {
                    phi_955_ = _e556[0];
                }
                let _e563 = phi_955_;
                if (_e556[1] < 0.0lf) {
                    phi_962_ = -(_e556[1]);
                } else {
                    phi_962_ = _e556[1];
                }
                let _e567 = phi_962_;
                if (_e563 > _e567) {
                    phi_967_ = _e563;
                } else {
                    phi_967_ = _e567;
                }
                let _e570 = phi_967_;
                if (_e556[2] < 0.0lf) {
                    phi_974_ = -(_e556[2]);
                } else {
                    phi_974_ = _e556[2];
                }
                let _e574 = phi_974_;
                if (_e570 > _e574) {
                    phi_979_ = _e570;
                } else {
                    phi_979_ = _e574;
                }
                let _e577 = phi_979_;
                if (_e553 > _e577) {
                    phi_984_ = _e553;
                } else {
                    phi_984_ = _e577;
                }
                let _e580 = phi_984_;
                let _e582 = local_12.member_3;
                let _e583 = (_e580 + _e582);
                let _e586 = local_12.member_1[0u];
                if (_e586[0] < 0.0lf) {
                    phi_1001_ = -(_e586[0]);
                } else {
                    phi_1001_ = _e586[0];
                }
                let _e593 = phi_1001_;
                if (_e586[1] < 0.0lf) {
                    phi_1008_ = -(_e586[1]);
                } else {
                    phi_1008_ = _e586[1];
                }
                let _e597 = phi_1008_;
                if (_e593 > _e597) {
                    phi_1013_ = _e593;
                } else {
                    phi_1013_ = _e597;
                }
                let _e600 = phi_1013_;
                if (_e586[2] < 0.0lf) {
                    phi_1020_ = -(_e586[2]);
                } else {
                    phi_1020_ = _e586[2];
                }
                let _e604 = phi_1020_;
                if (_e600 > _e604) {
                    phi_1025_ = _e600;
                } else {
                    phi_1025_ = _e604;
                }
                let _e607 = phi_1025_;
                let _e610 = local_12.member_1[1u];
                if (_e610[0] < 0.0lf) {
                    phi_1039_ = -(_e610[0]);
                } else {
                    phi_1039_ = _e610[0];
                }
                let _e617 = phi_1039_;
                if (_e610[1] < 0.0lf) {
                    phi_1046_ = -(_e610[1]);
                } else {
                    phi_1046_ = _e610[1];
                }
                let _e621 = phi_1046_;
                if (_e617 > _e621) {
                    phi_1051_ = _e617;
                } else {
                    phi_1051_ = _e621;
                }
                let _e624 = phi_1051_;
                if (_e610[2] < 0.0lf) {
                    phi_1058_ = -(_e610[2]);
                } else {
                    phi_1058_ = _e610[2];
                }
                let _e628 = phi_1058_;
                if (_e624 > _e628) {
                    phi_1063_ = _e624;
                } else {
                    phi_1063_ = _e628;
                }
                let _e631 = phi_1063_;
                if (_e607 > _e631) {
                    phi_1068_ = _e607;
                } else {
                    phi_1068_ = _e631;
                }
                let _e634 = phi_1068_;
                let _e636 = local_12.member_3;
                let _e637 = (_e634 + _e636);
                let _e640 = local_12.member_2[0u];
                if (_e640[0] < 0.0lf) {
                    phi_1085_ = -(_e640[0]);
                } else {
                    phi_1085_ = _e640[0];
                }
                let _e647 = phi_1085_;
                if (_e640[1] < 0.0lf) {
                    phi_1092_ = -(_e640[1]);
                } else {
                    phi_1092_ = _e640[1];
                }
                let _e651 = phi_1092_;
                if (_e647 > _e651) {
                    phi_1097_ = _e647;
                } else {
                    phi_1097_ = _e651;
                }
                let _e654 = phi_1097_;
                if (_e640[2] < 0.0lf) {
                    phi_1104_ = -(_e640[2]);
                } else {
                    phi_1104_ = _e640[2];
                }
                let _e658 = phi_1104_;
                if (_e654 > _e658) {
                    phi_1109_ = _e654;
                } else {
                    phi_1109_ = _e658;
                }
                let _e661 = phi_1109_;
                let _e664 = local_12.member_2[1u];
                if (_e664[0] < 0.0lf) {
                    phi_1123_ = -(_e664[0]);
                } else {
                    phi_1123_ = _e664[0];
                }
                let _e671 = phi_1123_;
                if (_e664[1] < 0.0lf) {
                    phi_1130_ = -(_e664[1]);
                } else {
                    phi_1130_ = _e664[1];
                }
                let _e675 = phi_1130_;
                if (_e671 > _e675) {
                    phi_1135_ = _e671;
                } else {
                    phi_1135_ = _e675;
                }
                let _e678 = phi_1135_;
                if (_e664[2] < 0.0lf) {
                    phi_1142_ = -(_e664[2]);
                } else {
                    phi_1142_ = _e664[2];
                }
                let _e682 = phi_1142_;
                if (_e678 > _e682) {
                    phi_1147_ = _e678;
                } else {
                    phi_1147_ = _e682;
                }
                let _e685 = phi_1147_;
                if (_e661 > _e685) {
                    phi_1152_ = _e661;
                } else {
                    phi_1152_ = _e685;
                }
                let _e688 = phi_1152_;
                let _e690 = local_12.member_3;
                let _e691 = (_e688 + _e690);
                let _e692 = f64(1f);
                let _e693 = f64(8f);
                let _e695 = ((_e637 * _e693) * _e691);
                let _e703 = local_12.member_3;
                if (_e389 < 0.0lf) {
                    phi_1189_ = -(_e389);
                } else {
                    phi_1189_ = _e389;
                }
                let _e723 = phi_1189_;
                if (_e392 < 0.0lf) {
                    phi_1195_ = -(_e392);
                } else {
                    phi_1195_ = _e392;
                }
                let _e727 = phi_1195_;
                if (_e395 < 0.0lf) {
                    phi_1202_ = -(_e395);
                } else {
                    phi_1202_ = _e395;
                }
                let _e732 = phi_1202_;
                let _e733 = ((_e723 + _e727) + _e732);
                if (_e410 < 0.0lf) {
                    phi_1209_ = -(_e410);
                } else {
                    phi_1209_ = _e410;
                }
                let _e737 = phi_1209_;
                if (_e413 < 0.0lf) {
                    phi_1215_ = -(_e413);
                } else {
                    phi_1215_ = _e413;
                }
                let _e741 = phi_1215_;
                if (_e416 < 0.0lf) {
                    phi_1222_ = -(_e416);
                } else {
                    phi_1222_ = _e416;
                }
                let _e746 = phi_1222_;
                let _e747 = ((_e737 + _e741) + _e746);
                if (_e733 > _e747) {
                    phi_1228_ = _e733;
                } else {
                    phi_1228_ = _e747;
                }
                let _e750 = phi_1228_;
                if (_e459 < 0.0lf) {
                    phi_1234_ = -(_e459);
                } else {
                    phi_1234_ = _e459;
                }
                let _e754 = phi_1234_;
                if (_e460 < 0.0lf) {
                    phi_1240_ = -(_e460);
                } else {
                    phi_1240_ = _e460;
                }
                let _e758 = phi_1240_;
                if (_e461 < 0.0lf) {
                    phi_1247_ = -(_e461);
                } else {
                    phi_1247_ = _e461;
                }
                let _e763 = phi_1247_;
                let _e765 = (((_e754 + _e758) + _e763) * f64(0.5f));
                if (_e750 > _e765) {
                    phi_1254_ = _e750;
                } else {
                    phi_1254_ = _e765;
                }
                let _e768 = phi_1254_;
                let _e774 = local_12.member_3;
                let _e788 = (((((_e583 * _e693) * _e695) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e703 * f64(19f)) * ((_e583 * (_e637 + _e691)) + (_e637 * _e691)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e692 + _e583) * ((_e692 + _e637) * (_e692 + _e691)))));
                let _e789 = f64(3f);
                let _e790 = (_e472 * _e789);
                let _e791 = (_e529 * _e789);
                if (_e790 < _e791) {
                    phi_1282_ = _e790;
                } else {
                    phi_1282_ = _e791;
                }
                let _e794 = phi_1282_;
                if (_e495 < _e518) {
                    phi_1287_ = _e495;
                } else {
                    phi_1287_ = _e518;
                }
                let _e797 = phi_1287_;
                if (_e794 < _e797) {
                    phi_1292_ = _e794;
                } else {
                    phi_1292_ = _e797;
                }
                let _e800 = phi_1292_;
                if (_e790 > _e791) {
                    phi_1297_ = _e790;
                } else {
                    phi_1297_ = _e791;
                }
                let _e803 = phi_1297_;
                if (_e495 > _e518) {
                    phi_1302_ = _e495;
                } else {
                    phi_1302_ = _e518;
                }
                let _e806 = phi_1302_;
                if (_e803 > _e806) {
                    phi_1307_ = _e803;
                } else {
                    phi_1307_ = _e806;
                }
                let _e809 = phi_1307_;
                let _e815 = -(_e809);
                if (_e800 > _e815) {
                    phi_1318_ = _e800;
                } else {
                    phi_1318_ = _e815;
                }
                let _e818 = phi_1318_;
                if ((_e818 - (_e788 + ((_e373 * (((_e768 + (_e695 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e774 * f64(6f)) * (_e637 + _e691))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e692 + _e637) * (_e692 + _e691))))) * f64((3f * 1.0001f))))) > _e374) {
                    phi_5775_ = type_40(0u, type_40().member_1);
                } else {
                    if (_e373 > _e374) {
                        let _e2916 = f64(1f);
                        let _e2920 = local_12.member[0u];
                        let _e2926 = local_12.member_1[0u];
                        let _e2932 = local_12.member_2[0u];
                        let _e2936 = (_e2920[0] - _e2926[0]);
                        let _e2937 = (_e2920[1] - _e2926[1]);
                        let _e2938 = (_e2920[2] - _e2926[2]);
                        local_9 = array<array<f64, 3>, 4>(_e2920, array<f64, 3>(_e2936, _e2937, _e2938), array<f64, 3>((_e2920[0] - _e2932[0]), (_e2920[1] - _e2932[1]), (_e2920[2] - _e2932[2])), array<f64, 3>((_e2936 - _e2932[0]), (_e2937 - _e2932[1]), (_e2938 - _e2932[2])));
                        let _e2951 = local_12.member[1u];
                        let _e2957 = local_12.member_1[1u];
                        let _e2963 = local_12.member_2[1u];
                        let _e2967 = (_e2951[0] - _e2957[0]);
                        let _e2968 = (_e2951[1] - _e2957[1]);
                        let _e2969 = (_e2951[2] - _e2957[2]);
                        local_10 = array<array<f64, 3>, 4>(_e2951, array<f64, 3>(_e2967, _e2968, _e2969), array<f64, 3>((_e2951[0] - _e2963[0]), (_e2951[1] - _e2963[1]), (_e2951[2] - _e2963[2])), array<f64, 3>((_e2967 - _e2963[0]), (_e2968 - _e2963[1]), (_e2969 - _e2963[2])));
                        let _e2982 = local_12.member[0u];
                        if (_e2982[0] < 0.0lf) {
                            phi_1521_ = -(_e2982[0]);
                        } else {
                            phi_1521_ = _e2982[0];
                        }
                        let _e2989 = phi_1521_;
                        if (_e2982[1] < 0.0lf) {
                            phi_1528_ = -(_e2982[1]);
                        } else {
                            phi_1528_ = _e2982[1];
                        }
                        let _e2993 = phi_1528_;
                        if (_e2989 > _e2993) {
                            phi_1533_ = _e2989;
                        } else {
                            phi_1533_ = _e2993;
                        }
                        let _e2996 = phi_1533_;
                        if (_e2982[2] < 0.0lf) {
                            phi_1540_ = -(_e2982[2]);
                        } else {
                            phi_1540_ = _e2982[2];
                        }
                        let _e3000 = phi_1540_;
                        if (_e2996 > _e3000) {
                            phi_1545_ = _e2996;
                        } else {
                            phi_1545_ = _e3000;
                        }
                        let _e3003 = phi_1545_;
                        let _e3006 = local_12.member[1u];
                        if (_e3006[0] < 0.0lf) {
                            phi_1558_ = -(_e3006[0]);
                        } else {
                            phi_1558_ = _e3006[0];
                        }
                        let _e3013 = phi_1558_;
                        if (_e3006[1] < 0.0lf) {
                            phi_1565_ = -(_e3006[1]);
                        } else {
                            phi_1565_ = _e3006[1];
                        }
                        let _e3017 = phi_1565_;
                        if (_e3013 > _e3017) {
                            phi_1570_ = _e3013;
                        } else {
                            phi_1570_ = _e3017;
                        }
                        let _e3020 = phi_1570_;
                        if (_e3006[2] < 0.0lf) {
                            phi_1577_ = -(_e3006[2]);
                        } else {
                            phi_1577_ = _e3006[2];
                        }
                        let _e3024 = phi_1577_;
                        if (_e3020 > _e3024) {
                            phi_1582_ = _e3020;
                        } else {
                            phi_1582_ = _e3024;
                        }
                        let _e3027 = phi_1582_;
                        if (_e3003 > _e3027) {
                            phi_1587_ = _e3003;
                        } else {
                            phi_1587_ = _e3027;
                        }
                        let _e3030 = phi_1587_;
                        let _e3032 = local_12.member_3;
                        let _e3036 = local_12.member_1[0u];
                        if (_e3036[0] < 0.0lf) {
                            phi_1604_ = -(_e3036[0]);
                        } else {
                            phi_1604_ = _e3036[0];
                        }
                        let _e3043 = phi_1604_;
                        if (_e3036[1] < 0.0lf) {
                            phi_1611_ = -(_e3036[1]);
                        } else {
                            phi_1611_ = _e3036[1];
                        }
                        let _e3047 = phi_1611_;
                        if (_e3043 > _e3047) {
                            phi_1616_ = _e3043;
                        } else {
                            phi_1616_ = _e3047;
                        }
                        let _e3050 = phi_1616_;
                        if (_e3036[2] < 0.0lf) {
                            phi_1623_ = -(_e3036[2]);
                        } else {
                            phi_1623_ = _e3036[2];
                        }
                        let _e3054 = phi_1623_;
                        if (_e3050 > _e3054) {
                            phi_1628_ = _e3050;
                        } else {
                            phi_1628_ = _e3054;
                        }
                        let _e3057 = phi_1628_;
                        let _e3060 = local_12.member_1[1u];
                        if (_e3060[0] < 0.0lf) {
                            phi_1642_ = -(_e3060[0]);
                        } else {
                            phi_1642_ = _e3060[0];
                        }
                        let _e3067 = phi_1642_;
                        if (_e3060[1] < 0.0lf) {
                            phi_1649_ = -(_e3060[1]);
                        } else {
                            phi_1649_ = _e3060[1];
                        }
                        let _e3071 = phi_1649_;
                        if (_e3067 > _e3071) {
                            phi_1654_ = _e3067;
                        } else {
                            phi_1654_ = _e3071;
                        }
                        let _e3074 = phi_1654_;
                        if (_e3060[2] < 0.0lf) {
                            phi_1661_ = -(_e3060[2]);
                        } else {
                            phi_1661_ = _e3060[2];
                        }
                        let _e3078 = phi_1661_;
                        if (_e3074 > _e3078) {
                            phi_1666_ = _e3074;
                        } else {
                            phi_1666_ = _e3078;
                        }
                        let _e3081 = phi_1666_;
                        if (_e3057 > _e3081) {
                            phi_1671_ = _e3057;
                        } else {
                            phi_1671_ = _e3081;
                        }
                        let _e3084 = phi_1671_;
                        let _e3086 = local_12.member_3;
                        let _e3090 = local_12.member_2[0u];
                        if (_e3090[0] < 0.0lf) {
                            phi_1688_ = -(_e3090[0]);
                        } else {
                            phi_1688_ = _e3090[0];
                        }
                        let _e3097 = phi_1688_;
                        if (_e3090[1] < 0.0lf) {
                            phi_1695_ = -(_e3090[1]);
                        } else {
                            phi_1695_ = _e3090[1];
                        }
                        let _e3101 = phi_1695_;
                        if (_e3097 > _e3101) {
                            phi_1700_ = _e3097;
                        } else {
                            phi_1700_ = _e3101;
                        }
                        let _e3104 = phi_1700_;
                        if (_e3090[2] < 0.0lf) {
                            phi_1707_ = -(_e3090[2]);
                        } else {
                            phi_1707_ = _e3090[2];
                        }
                        let _e3108 = phi_1707_;
                        if (_e3104 > _e3108) {
                            phi_1712_ = _e3104;
                        } else {
                            phi_1712_ = _e3108;
                        }
                        let _e3111 = phi_1712_;
                        let _e3114 = local_12.member_2[1u];
                        if (_e3114[0] < 0.0lf) {
                            phi_1726_ = -(_e3114[0]);
                        } else {
                            phi_1726_ = _e3114[0];
                        }
                        let _e3121 = phi_1726_;
                        if (_e3114[1] < 0.0lf) {
                            phi_1733_ = -(_e3114[1]);
                        } else {
                            phi_1733_ = _e3114[1];
                        }
                        let _e3125 = phi_1733_;
                        if (_e3121 > _e3125) {
                            phi_1738_ = _e3121;
                        } else {
                            phi_1738_ = _e3125;
                        }
                        let _e3128 = phi_1738_;
                        if (_e3114[2] < 0.0lf) {
                            phi_1745_ = -(_e3114[2]);
                        } else {
                            phi_1745_ = _e3114[2];
                        }
                        let _e3132 = phi_1745_;
                        if (_e3128 > _e3132) {
                            phi_1750_ = _e3128;
                        } else {
                            phi_1750_ = _e3132;
                        }
                        let _e3135 = phi_1750_;
                        if (_e3111 > _e3135) {
                            phi_1755_ = _e3111;
                        } else {
                            phi_1755_ = _e3135;
                        }
                        let _e3138 = phi_1755_;
                        let _e3140 = local_12.member_3;
                        let _e3148 = local_12.member_3;
                        phi_1775_ = type_19(0u, 48u);
                        phi_1778_ = f64(0f);
                        loop {
                            let _e3157 = phi_1775_;
                            let _e3159 = phi_1778_;
                            local_77 = _e3159;
                            local_37 = _e3159;
                            local_38 = _e3159;
                            local_39 = _e3159;
                            local_40 = _e3159;
                            if (_e3157.member < _e3157.member_1) {
                                phi_1776_ = type_19((_e3157.member + 1u), _e3157.member_1);
                                phi_1801_ = type_19(1u, _e3157.member);
                            } else {
                                phi_1776_ = _e3157;
                                phi_1801_ = type_19(0u, type_19().member_1);
                            }
                            let _e3171 = phi_1776_;
                            let _e3173 = phi_1801_;
                            if (bitcast<i32>(_e3173.member) != 0i) {
                                let _e3179 = local_12.member[0u];
                                let _e3185 = local_12.member[1u];
                                let _e3201 = local_12.member_1[0u];
                                let _e3207 = local_12.member_1[1u];
                                let _e3223 = local_12.member_2[0u];
                                let _e3229 = local_12.member_2[1u];
                                let _e3243 = function_2(array<f64, 3>((_e3179[0] + ((_e3185[0] - _e3179[0]) * _e3159)), (_e3179[1] + ((_e3185[1] - _e3179[1]) * _e3159)), (_e3179[2] + ((_e3185[2] - _e3179[2]) * _e3159))), array<f64, 3>((_e3201[0] + ((_e3207[0] - _e3201[0]) * _e3159)), (_e3201[1] + ((_e3207[1] - _e3201[1]) * _e3159)), (_e3201[2] + ((_e3207[2] - _e3201[2]) * _e3159))), array<f64, 3>((_e3223[0] + ((_e3229[0] - _e3223[0]) * _e3159)), (_e3223[1] + ((_e3229[1] - _e3223[1]) * _e3159)), (_e3223[2] + ((_e3229[2] - _e3223[2]) * _e3159))), 1u);
                                if (_e3243[0] < 0.0lf) {
                                    phi_1912_ = -(_e3243[0]);
                                } else {
                                    phi_1912_ = _e3243[0];
                                }
                                let _e3248 = phi_1912_;
                                if (_e3243[1] < 0.0lf) {
                                    phi_1919_ = -(_e3243[1]);
                                } else {
                                    phi_1919_ = _e3243[1];
                                }
                                let _e3253 = phi_1919_;
                                if (_e3243[2] < 0.0lf) {
                                    phi_1927_ = -(_e3243[2]);
                                } else {
                                    phi_1927_ = _e3243[2];
                                }
                                let _e3259 = phi_1927_;
                                let _e3260 = ((_e3248 + _e3253) + _e3259);
                                if (_e3260 > f64(0f)) {
                                    if ((bitcast<u64>(_e3260) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3266 = (f64(1f) / _e3260);
                                        let _e3268 = (_e3243[0] * _e3266);
                                        let _e3270 = (_e3243[1] * _e3266);
                                        let _e3272 = (_e3243[2] * _e3266);
                                        let _e3277 = (((_e3268 * _e3268) + (_e3270 * _e3270)) + (_e3272 * _e3272));
                                        if (_e3277 <= 2.2250738585072014e-308lf) {
                                            if (_e3277 > 0.0lf) {
                                                phi_1965_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_1965_ = 0.0lf;
                                            }
                                            let _e3329 = phi_1965_;
                                            phi_2029_ = _e3329;
                                        } else {
                                            phi_1972_ = type_17(0i, 5i);
                                            phi_1975_ = bitcast<f64>(((bitcast<u64>(_e3277) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3284 = phi_1972_;
                                                let _e3286 = phi_1975_;
                                                local_31 = _e3286;
                                                if (_e3284.member < _e3284.member_1) {
                                                    let _e3293 = (_e3284.member + 1i);
                                                    if ((false == (_e3293 > _e3284.member)) != false) {
                                                        phi_1996_ = true;
                                                    } else {
                                                        phi_1996_ = false;
                                                    }
                                                    let _e3298 = phi_1996_;
                                                    if _e3298 {
                                                        phi_2002_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2002_ = type_18(1u, _e3293);
                                                    }
                                                    let _e3303 = phi_2002_;
                                                    phi_1973_ = type_17(_e3303.member_1, _e3284.member_1);
                                                    phi_2016_ = type_18(1u, _e3284.member);
                                                } else {
                                                    phi_1973_ = _e3284;
                                                    phi_2016_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3309 = phi_1973_;
                                                let _e3311 = phi_2016_;
                                                let _e3314 = (bitcast<i32>(_e3311.member) != 0i);
                                                if _e3314 {
                                                    phi_1976_ = (0.5lf * (_e3286 + (_e3277 / _e3286)));
                                                } else {
                                                    phi_1976_ = f64();
                                                }
                                                let _e3319 = phi_1976_;
                                                continue;
                                                continuing {
                                                    phi_1972_ = _e3309;
                                                    phi_1975_ = _e3319;
                                                    break if !(_e3314);
                                                }
                                            }
                                            let _e3324 = local_31;
                                            phi_2029_ = (_e3324 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3331 = phi_2029_;
                                        phi_2042_ = type_19(0u, 4u);
                                        phi_2045_ = f64(2f);
                                        loop {
                                            let _e3343 = phi_2042_;
                                            let _e3345 = phi_2045_;
                                            local_33 = _e3345;
                                            local_34 = _e3345;
                                            local_35 = _e3345;
                                            local_67 = _e3345;
                                            local_68 = _e3345;
                                            if (_e3343.member < _e3343.member_1) {
                                                phi_2043_ = type_19((_e3343.member + 1u), _e3343.member_1);
                                                phi_2068_ = type_19(1u, _e3343.member);
                                            } else {
                                                phi_2043_ = _e3343;
                                                phi_2068_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e3357 = phi_2043_;
                                            let _e3359 = phi_2068_;
                                            if (bitcast<i32>(_e3359.member) != 0i) {
                                                let _e3365 = local_9[_e3359.member_1];
                                                let _e3373 = (((_e3268 * _e3365[0]) + (_e3270 * _e3365[1])) + (_e3272 * _e3365[2]));
                                                let _e3375 = local_10[_e3359.member_1];
                                                let _e3383 = (((_e3268 * _e3375[0]) + (_e3270 * _e3375[1])) + (_e3272 * _e3375[2]));
                                                if (_e3373 < 0.0lf) {
                                                    phi_2119_ = -(_e3373);
                                                } else {
                                                    phi_2119_ = _e3373;
                                                }
                                                let _e3387 = phi_2119_;
                                                if (_e3383 < 0.0lf) {
                                                    phi_2125_ = -(_e3383);
                                                } else {
                                                    phi_2125_ = _e3383;
                                                }
                                                let _e3391 = phi_2125_;
                                                let _e3396 = (((((((((_e3030 + _e3032) + (_e3084 + _e3086)) + (_e3138 + _e3140)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3148 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e373 * _e3331) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3387 + _e3391) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3373 > _e3396) {
                                                    if (_e3383 > _e3396) {
                                                        phi_2139_ = false;
                                                    } else {
                                                        phi_2139_ = true;
                                                    }
                                                    let _e3400 = phi_2139_;
                                                    phi_2140_ = _e3400;
                                                } else {
                                                    phi_2140_ = true;
                                                }
                                                let _e3402 = phi_2140_;
                                                if _e3402 {
                                                    if ((_e3373 + ((_e3383 - _e3373) * _e3159)) > _e3396) {
                                                        if (_e3383 < _e3373) {
                                                            let _e3411 = ((_e3373 - _e3383) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e3411 {
                                                                let _e3419 = (((_e3373 - _e3396) / (_e3373 - _e3383)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e3345 < _e3419) {
                                                                    phi_2174_ = _e3345;
                                                                } else {
                                                                    phi_2174_ = _e3419;
                                                                }
                                                                let _e3422 = phi_2174_;
                                                                phi_2175_ = _e3422;
                                                            } else {
                                                                phi_2175_ = f64();
                                                            }
                                                            let _e3424 = phi_2175_;
                                                            phi_2176_ = _e3424;
                                                            phi_2177_ = _e3411;
                                                        } else {
                                                            phi_2176_ = _e3345;
                                                            phi_2177_ = true;
                                                        }
                                                        let _e3426 = phi_2176_;
                                                        let _e3428 = phi_2177_;
                                                        if _e3428 {
                                                            phi_2181_ = false;
                                                        } else {
                                                            phi_2181_ = true;
                                                        }
                                                        let _e3430 = phi_2181_;
                                                        phi_2182_ = _e3426;
                                                        phi_2183_ = _e3428;
                                                        phi_2184_ = _e3430;
                                                        phi_2185_ = false;
                                                    } else {
                                                        phi_2182_ = f64();
                                                        phi_2183_ = false;
                                                        phi_2184_ = false;
                                                        phi_2185_ = true;
                                                    }
                                                    let _e3432 = phi_2182_;
                                                    let _e3434 = phi_2183_;
                                                    let _e3436 = phi_2184_;
                                                    let _e3438 = phi_2185_;
                                                    phi_2186_ = _e3432;
                                                    phi_2187_ = _e3434;
                                                    phi_2188_ = _e3436;
                                                    phi_2189_ = _e3438;
                                                } else {
                                                    phi_2186_ = _e3345;
                                                    phi_2187_ = true;
                                                    phi_2188_ = false;
                                                    phi_2189_ = false;
                                                }
                                                let _e3440 = phi_2186_;
                                                let _e3442 = phi_2187_;
                                                let _e3444 = phi_2188_;
                                                let _e3446 = phi_2189_;
                                                phi_2046_ = _e3440;
                                                phi_2190_ = _e3442;
                                                phi_2191_ = false;
                                                phi_2192_ = _e3444;
                                                phi_2193_ = _e3446;
                                            } else {
                                                phi_2046_ = f64();
                                                phi_2190_ = false;
                                                phi_2191_ = true;
                                                phi_2192_ = false;
                                                phi_2193_ = false;
                                            }
                                            let _e3448 = phi_2046_;
                                            let _e3450 = phi_2190_;
                                            let _e3452 = phi_2191_;
                                            let _e3454 = phi_2192_;
                                            let _e3456 = phi_2193_;
                                            local_32 = _e3452;
                                            local_65 = _e3454;
                                            local_66 = _e3456;
                                            continue;
                                            continuing {
                                                phi_2042_ = _e3357;
                                                phi_2045_ = _e3448;
                                                break if !(_e3450);
                                            }
                                        }
                                        let _e3459 = local_32;
                                        if _e3459 {
                                            let _e3461 = local_33;
                                            let _e3462 = (_e3461 > _e2916);
                                            if _e3462 {
                                                phi_2215_ = false;
                                                phi_2216_ = false;
                                                phi_2217_ = false;
                                            } else {
                                                let _e3464 = local_34;
                                                if (_e3464 > _e3159) {
                                                    let _e3467 = local_35;
                                                    let _e3470 = ((_e3467 - _e3159) < f64(0.00000000023283064f));
                                                    if _e3470 {
                                                        phi_2211_ = false;
                                                    } else {
                                                        phi_2211_ = true;
                                                    }
                                                    let _e3472 = phi_2211_;
                                                    phi_2212_ = _e3472;
                                                    phi_2213_ = _e3470;
                                                    phi_2214_ = false;
                                                } else {
                                                    phi_2212_ = false;
                                                    phi_2213_ = false;
                                                    phi_2214_ = true;
                                                }
                                                let _e3474 = phi_2212_;
                                                let _e3476 = phi_2213_;
                                                let _e3478 = phi_2214_;
                                                phi_2215_ = _e3474;
                                                phi_2216_ = _e3476;
                                                phi_2217_ = _e3478;
                                            }
                                            let _e3480 = phi_2215_;
                                            let _e3482 = phi_2216_;
                                            let _e3484 = phi_2217_;
                                            phi_2218_ = _e3480;
                                            phi_2219_ = _e3462;
                                            phi_2220_ = _e3482;
                                            phi_2221_ = _e3484;
                                            phi_2222_ = false;
                                            phi_2223_ = false;
                                        } else {
                                            phi_2218_ = false;
                                            phi_2219_ = false;
                                            phi_2220_ = false;
                                            phi_2221_ = false;
                                            let _e4756 = local_65;
                                            phi_2222_ = _e4756;
                                            let _e4759 = local_66;
                                            phi_2223_ = _e4759;
                                        }
                                        let _e3486 = phi_2218_;
                                        let _e3488 = phi_2219_;
                                        let _e3490 = phi_2220_;
                                        let _e3492 = phi_2221_;
                                        let _e3494 = phi_2222_;
                                        let _e3496 = phi_2223_;
                                        let _e4762 = local_67;
                                        phi_2224_ = _e4762;
                                        let _e4765 = local_68;
                                        phi_2225_ = _e4765;
                                        phi_2226_ = _e3486;
                                        phi_2227_ = _e3488;
                                        phi_2228_ = _e3490;
                                        phi_2229_ = _e3492;
                                        phi_2230_ = _e3494;
                                        phi_2231_ = _e3496;
                                        phi_2232_ = false;
                                    } else {
                                        phi_2224_ = f64();
                                        phi_2225_ = f64();
                                        phi_2226_ = false;
                                        phi_2227_ = false;
                                        phi_2228_ = false;
                                        phi_2229_ = false;
                                        phi_2230_ = false;
                                        phi_2231_ = false;
                                        phi_2232_ = true;
                                    }
                                    let _e3498 = phi_2224_;
                                    let _e3500 = phi_2225_;
                                    let _e3502 = phi_2226_;
                                    let _e3504 = phi_2227_;
                                    let _e3506 = phi_2228_;
                                    let _e3508 = phi_2229_;
                                    let _e3510 = phi_2230_;
                                    let _e3512 = phi_2231_;
                                    let _e3514 = phi_2232_;
                                    phi_2233_ = _e3498;
                                    phi_2234_ = _e3500;
                                    phi_2235_ = _e3502;
                                    phi_2236_ = _e3504;
                                    phi_2237_ = _e3506;
                                    phi_2238_ = _e3508;
                                    phi_2239_ = _e3510;
                                    phi_2240_ = _e3512;
                                    phi_2241_ = _e3514;
                                    phi_2242_ = false;
                                } else {
                                    phi_2233_ = f64();
                                    phi_2234_ = f64();
                                    phi_2235_ = false;
                                    phi_2236_ = false;
                                    phi_2237_ = false;
                                    phi_2238_ = false;
                                    phi_2239_ = false;
                                    phi_2240_ = false;
                                    phi_2241_ = false;
                                    phi_2242_ = true;
                                }
                                let _e3516 = phi_2233_;
                                let _e3518 = phi_2234_;
                                let _e3520 = phi_2235_;
                                let _e3522 = phi_2236_;
                                let _e3524 = phi_2237_;
                                let _e3526 = phi_2238_;
                                let _e3528 = phi_2239_;
                                let _e3530 = phi_2240_;
                                let _e3532 = phi_2241_;
                                let _e3534 = phi_2242_;
                                phi_2243_ = _e3516;
                                phi_1779_ = _e3518;
                                phi_2244_ = _e3520;
                                phi_2245_ = _e3522;
                                phi_2246_ = _e3524;
                                phi_2247_ = false;
                                phi_2248_ = _e3526;
                                phi_2249_ = _e3528;
                                phi_2250_ = _e3530;
                                phi_2251_ = _e3532;
                                phi_2252_ = _e3534;
                            } else {
                                phi_2243_ = f64();
                                phi_1779_ = f64();
                                phi_2244_ = false;
                                phi_2245_ = false;
                                phi_2246_ = false;
                                phi_2247_ = true;
                                phi_2248_ = false;
                                phi_2249_ = false;
                                phi_2250_ = false;
                                phi_2251_ = false;
                                phi_2252_ = false;
                            }
                            let _e3536 = phi_2243_;
                            let _e3538 = phi_1779_;
                            let _e3540 = phi_2244_;
                            let _e3542 = phi_2245_;
                            let _e3544 = phi_2246_;
                            let _e3546 = phi_2247_;
                            let _e3548 = phi_2248_;
                            let _e3550 = phi_2249_;
                            let _e3552 = phi_2250_;
                            let _e3554 = phi_2251_;
                            let _e3556 = phi_2252_;
                            local_36 = _e3542;
                            local_69 = _e3544;
                            local_70 = _e3546;
                            local_71 = _e3548;
                            local_72 = _e3550;
                            local_73 = _e3552;
                            local_74 = _e3554;
                            local_75 = _e3556;
                            local_76 = _e3536;
                            local_78 = _e3542;
                            continue;
                            continuing {
                                phi_1775_ = _e3171;
                                phi_1778_ = _e3538;
                                break if !(_e3540);
                            }
                        }
                        let _e3559 = local_36;
                        if _e3559 {
                            phi_2257_ = type_40(0u, type_40().member_1);
                            phi_2258_ = false;
                            phi_2259_ = false;
                            phi_2260_ = false;
                            phi_2261_ = false;
                            phi_2262_ = false;
                            phi_2263_ = false;
                            phi_2264_ = false;
                        } else {
                            phi_2257_ = type_40();
                            let _e4798 = local_69;
                            phi_2258_ = _e4798;
                            let _e4801 = local_70;
                            phi_2259_ = _e4801;
                            let _e4804 = local_71;
                            phi_2260_ = _e4804;
                            let _e4807 = local_72;
                            phi_2261_ = _e4807;
                            let _e4810 = local_73;
                            phi_2262_ = _e4810;
                            let _e4813 = local_74;
                            phi_2263_ = _e4813;
                            let _e4816 = local_75;
                            phi_2264_ = _e4816;
                        }
                        let _e3563 = phi_2257_;
                        let _e3565 = phi_2258_;
                        let _e3567 = phi_2259_;
                        let _e3569 = phi_2260_;
                        let _e3571 = phi_2261_;
                        let _e3573 = phi_2262_;
                        let _e3575 = phi_2263_;
                        let _e3577 = phi_2264_;
                        if _e3565 {
                            let _e4819 = local_76;
                            phi_2268_ = _e4819;
                            phi_2269_ = true;
                            phi_2270_ = false;
                            phi_2271_ = false;
                            phi_2272_ = false;
                            phi_2273_ = false;
                            phi_2274_ = false;
                            phi_2275_ = false;
                        } else {
                            let _e4821 = local_77;
                            phi_2268_ = _e4821;
                            phi_2269_ = _e3567;
                            phi_2270_ = _e3569;
                            phi_2271_ = _e3571;
                            phi_2272_ = _e3573;
                            let _e4828 = local_78;
                            phi_2273_ = _e4828;
                            phi_2274_ = _e3575;
                            phi_2275_ = _e3577;
                        }
                        let _e3579 = phi_2268_;
                        let _e3581 = phi_2269_;
                        let _e3583 = phi_2270_;
                        let _e3585 = phi_2271_;
                        let _e3587 = phi_2272_;
                        let _e3589 = phi_2273_;
                        let _e3591 = phi_2274_;
                        let _e3593 = phi_2275_;
                        if _e3581 {
                            phi_2280_ = type_40(1u, _e3579);
                            phi_2281_ = false;
                            phi_2282_ = false;
                            phi_2283_ = false;
                            phi_2284_ = false;
                            phi_2285_ = false;
                            phi_2286_ = false;
                        } else {
                            phi_2280_ = type_40();
                            phi_2281_ = _e3583;
                            phi_2282_ = _e3585;
                            phi_2283_ = _e3587;
                            phi_2284_ = _e3589;
                            phi_2285_ = _e3591;
                            phi_2286_ = _e3593;
                        }
                        let _e3596 = phi_2280_;
                        let _e3598 = phi_2281_;
                        let _e3600 = phi_2282_;
                        let _e3602 = phi_2283_;
                        let _e3604 = phi_2284_;
                        let _e3606 = phi_2285_;
                        let _e3608 = phi_2286_;
                        if _e3598 {
                            let _e3610 = local_37;
                            phi_2291_ = type_40(1u, _e3610);
                            phi_2292_ = false;
                            phi_2293_ = false;
                            phi_2294_ = true;
                            phi_2295_ = false;
                            phi_2296_ = false;
                        } else {
                            phi_2291_ = _e3563;
                            phi_2292_ = _e3600;
                            phi_2293_ = _e3602;
                            phi_2294_ = _e3604;
                            phi_2295_ = _e3606;
                            phi_2296_ = _e3608;
                        }
                        let _e3613 = phi_2291_;
                        let _e3615 = phi_2292_;
                        let _e3617 = phi_2293_;
                        let _e3619 = phi_2294_;
                        let _e3621 = phi_2295_;
                        let _e3623 = phi_2296_;
                        if _e3615 {
                            let _e3625 = local_38;
                            phi_2301_ = type_40(1u, _e3625);
                            phi_2302_ = false;
                            phi_2303_ = false;
                            phi_2304_ = false;
                            phi_2305_ = false;
                        } else {
                            phi_2301_ = type_40();
                            phi_2302_ = _e3617;
                            phi_2303_ = _e3619;
                            phi_2304_ = _e3621;
                            phi_2305_ = _e3623;
                        }
                        let _e3628 = phi_2301_;
                        let _e3630 = phi_2302_;
                        let _e3632 = phi_2303_;
                        let _e3634 = phi_2304_;
                        let _e3636 = phi_2305_;
                        if _e3630 {
                            let _e3638 = local_39;
                            phi_2310_ = type_40(1u, _e3638);
                            phi_2311_ = true;
                            phi_2312_ = false;
                            phi_2313_ = false;
                            phi_2314_ = false;
                        } else {
                            phi_2310_ = _e3628;
                            phi_2311_ = _e3615;
                            phi_2312_ = _e3632;
                            phi_2313_ = _e3634;
                            phi_2314_ = _e3636;
                        }
                        let _e3641 = phi_2310_;
                        let _e3643 = phi_2311_;
                        let _e3645 = phi_2312_;
                        let _e3647 = phi_2313_;
                        let _e3649 = phi_2314_;
                        if _e3643 {
                            phi_2318_ = _e3641;
                            phi_2319_ = true;
                            phi_2320_ = false;
                            phi_2321_ = false;
                        } else {
                            phi_2318_ = _e3613;
                            phi_2319_ = _e3645;
                            phi_2320_ = _e3647;
                            phi_2321_ = _e3649;
                        }
                        let _e3651 = phi_2318_;
                        let _e3653 = phi_2319_;
                        let _e3655 = phi_2320_;
                        let _e3657 = phi_2321_;
                        if _e3653 {
                            phi_2325_ = false;
                            phi_2326_ = false;
                        } else {
                            phi_2325_ = _e3655;
                            phi_2326_ = _e3657;
                        }
                        let _e3659 = phi_2325_;
                        let _e3661 = phi_2326_;
                        if _e3659 {
                            phi_2330_ = false;
                            phi_2331_ = false;
                        } else {
                            phi_2330_ = _e3661;
                            phi_2331_ = _e3653;
                        }
                        let _e3663 = phi_2330_;
                        let _e3665 = phi_2331_;
                        if _e3663 {
                            phi_2335_ = true;
                            phi_2336_ = false;
                        } else {
                            phi_2335_ = _e3659;
                            phi_2336_ = _e3665;
                        }
                        let _e3667 = phi_2335_;
                        let _e3669 = phi_2336_;
                        if _e3667 {
                            let _e3671 = local_40;
                            phi_2341_ = type_40(1u, _e3671);
                            phi_2342_ = true;
                        } else {
                            phi_2341_ = _e3651;
                            phi_2342_ = _e3669;
                        }
                        let _e3674 = phi_2341_;
                        let _e3676 = phi_2342_;
                        if _e3676 {
                            phi_2346_ = _e3674;
                        } else {
                            phi_2346_ = _e3596;
                        }
                        let _e3678 = phi_2346_;
                        if (_e3678.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_2360_ = type_19(0u, 3u);
                            loop {
                                let _e3690 = phi_2360_;
                                if (_e3690.member < _e3690.member_1) {
                                    phi_2361_ = type_19((_e3690.member + 1u), _e3690.member_1);
                                    phi_2384_ = type_19(1u, _e3690.member);
                                } else {
                                    phi_2361_ = _e3690;
                                    phi_2384_ = type_19(0u, type_19().member_1);
                                }
                                let _e3702 = phi_2361_;
                                let _e3704 = phi_2384_;
                                if (bitcast<i32>(_e3704.member) != 0i) {
                                    let _e3710 = local_11[_e3704.member_1];
                                    let _e3712 = (_e3678.member_1 + f64(_e3710));
                                    if (_e3712 < _e2916) {
                                        phi_2405_ = _e3712;
                                    } else {
                                        phi_2405_ = _e2916;
                                    }
                                    let _e3715 = phi_2405_;
                                    let _e3718 = local_12.member[0u];
                                    let _e3724 = local_12.member[1u];
                                    let _e3740 = local_12.member_1[0u];
                                    let _e3746 = local_12.member_1[1u];
                                    let _e3762 = local_12.member_2[0u];
                                    let _e3768 = local_12.member_2[1u];
                                    let _e3782 = function_2(array<f64, 3>((_e3718[0] + ((_e3724[0] - _e3718[0]) * _e3715)), (_e3718[1] + ((_e3724[1] - _e3718[1]) * _e3715)), (_e3718[2] + ((_e3724[2] - _e3718[2]) * _e3715))), array<f64, 3>((_e3740[0] + ((_e3746[0] - _e3740[0]) * _e3715)), (_e3740[1] + ((_e3746[1] - _e3740[1]) * _e3715)), (_e3740[2] + ((_e3746[2] - _e3740[2]) * _e3715))), array<f64, 3>((_e3762[0] + ((_e3768[0] - _e3762[0]) * _e3715)), (_e3762[1] + ((_e3768[1] - _e3762[1]) * _e3715)), (_e3762[2] + ((_e3768[2] - _e3762[2]) * _e3715))), 1u);
                                    let _e3793 = (((_e3782[0] * _e3782[0]) + (_e3782[1] * _e3782[1])) + (_e3782[2] * _e3782[2]));
                                    if (_e3793 <= 2.2250738585072014e-308lf) {
                                        if (_e3793 > 0.0lf) {
                                            phi_2528_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_2528_ = 0.0lf;
                                        }
                                        let _e3845 = phi_2528_;
                                        phi_2592_ = _e3845;
                                    } else {
                                        phi_2535_ = type_17(0i, 5i);
                                        phi_2538_ = bitcast<f64>(((bitcast<u64>(_e3793) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e3800 = phi_2535_;
                                            let _e3802 = phi_2538_;
                                            local_41 = _e3802;
                                            if (_e3800.member < _e3800.member_1) {
                                                let _e3809 = (_e3800.member + 1i);
                                                if ((false == (_e3809 > _e3800.member)) != false) {
                                                    phi_2559_ = true;
                                                } else {
                                                    phi_2559_ = false;
                                                }
                                                let _e3814 = phi_2559_;
                                                if _e3814 {
                                                    phi_2565_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_2565_ = type_18(1u, _e3809);
                                                }
                                                let _e3819 = phi_2565_;
                                                phi_2536_ = type_17(_e3819.member_1, _e3800.member_1);
                                                phi_2579_ = type_18(1u, _e3800.member);
                                            } else {
                                                phi_2536_ = _e3800;
                                                phi_2579_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e3825 = phi_2536_;
                                            let _e3827 = phi_2579_;
                                            let _e3830 = (bitcast<i32>(_e3827.member) != 0i);
                                            if _e3830 {
                                                phi_2539_ = (0.5lf * (_e3802 + (_e3793 / _e3802)));
                                            } else {
                                                phi_2539_ = f64();
                                            }
                                            let _e3835 = phi_2539_;
                                            continue;
                                            continuing {
                                                phi_2535_ = _e3825;
                                                phi_2538_ = _e3835;
                                                break if !(_e3830);
                                            }
                                        }
                                        let _e3840 = local_41;
                                        phi_2592_ = (_e3840 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e3847 = phi_2592_;
                                    let _e3855 = local_12.member[0u];
                                    if (_e3855[0] < 0.0lf) {
                                        phi_2610_ = -(_e3855[0]);
                                    } else {
                                        phi_2610_ = _e3855[0];
                                    }
                                    let _e3862 = phi_2610_;
                                    if (_e3855[1] < 0.0lf) {
                                        phi_2617_ = -(_e3855[1]);
                                    } else {
                                        phi_2617_ = _e3855[1];
                                    }
                                    let _e3866 = phi_2617_;
                                    if (_e3862 > _e3866) {
                                        phi_2622_ = _e3862;
                                    } else {
                                        phi_2622_ = _e3866;
                                    }
                                    let _e3869 = phi_2622_;
                                    if (_e3855[2] < 0.0lf) {
                                        phi_2629_ = -(_e3855[2]);
                                    } else {
                                        phi_2629_ = _e3855[2];
                                    }
                                    let _e3873 = phi_2629_;
                                    if (_e3869 > _e3873) {
                                        phi_2634_ = _e3869;
                                    } else {
                                        phi_2634_ = _e3873;
                                    }
                                    let _e3876 = phi_2634_;
                                    let _e3879 = local_12.member[1u];
                                    if (_e3879[0] < 0.0lf) {
                                        phi_2647_ = -(_e3879[0]);
                                    } else {
                                        phi_2647_ = _e3879[0];
                                    }
                                    let _e3886 = phi_2647_;
                                    if (_e3879[1] < 0.0lf) {
                                        phi_2654_ = -(_e3879[1]);
                                    } else {
                                        phi_2654_ = _e3879[1];
                                    }
                                    let _e3890 = phi_2654_;
                                    if (_e3886 > _e3890) {
                                        phi_2659_ = _e3886;
                                    } else {
                                        phi_2659_ = _e3890;
                                    }
                                    let _e3893 = phi_2659_;
                                    if (_e3879[2] < 0.0lf) {
                                        phi_2666_ = -(_e3879[2]);
                                    } else {
                                        phi_2666_ = _e3879[2];
                                    }
                                    let _e3897 = phi_2666_;
                                    if (_e3893 > _e3897) {
                                        phi_2671_ = _e3893;
                                    } else {
                                        phi_2671_ = _e3897;
                                    }
                                    let _e3900 = phi_2671_;
                                    if (_e3876 > _e3900) {
                                        phi_2676_ = _e3876;
                                    } else {
                                        phi_2676_ = _e3900;
                                    }
                                    let _e3903 = phi_2676_;
                                    let _e3905 = local_12.member_3;
                                    let _e3909 = local_12.member_1[0u];
                                    if (_e3909[0] < 0.0lf) {
                                        phi_2693_ = -(_e3909[0]);
                                    } else {
                                        phi_2693_ = _e3909[0];
                                    }
                                    let _e3916 = phi_2693_;
                                    if (_e3909[1] < 0.0lf) {
                                        phi_2700_ = -(_e3909[1]);
                                    } else {
                                        phi_2700_ = _e3909[1];
                                    }
                                    let _e3920 = phi_2700_;
                                    if (_e3916 > _e3920) {
                                        phi_2705_ = _e3916;
                                    } else {
                                        phi_2705_ = _e3920;
                                    }
                                    let _e3923 = phi_2705_;
                                    if (_e3909[2] < 0.0lf) {
                                        phi_2712_ = -(_e3909[2]);
                                    } else {
                                        phi_2712_ = _e3909[2];
                                    }
                                    let _e3927 = phi_2712_;
                                    if (_e3923 > _e3927) {
                                        phi_2717_ = _e3923;
                                    } else {
                                        phi_2717_ = _e3927;
                                    }
                                    let _e3930 = phi_2717_;
                                    let _e3933 = local_12.member_1[1u];
                                    if (_e3933[0] < 0.0lf) {
                                        phi_2731_ = -(_e3933[0]);
                                    } else {
                                        phi_2731_ = _e3933[0];
                                    }
                                    let _e3940 = phi_2731_;
                                    if (_e3933[1] < 0.0lf) {
                                        phi_2738_ = -(_e3933[1]);
                                    } else {
                                        phi_2738_ = _e3933[1];
                                    }
                                    let _e3944 = phi_2738_;
                                    if (_e3940 > _e3944) {
                                        phi_2743_ = _e3940;
                                    } else {
                                        phi_2743_ = _e3944;
                                    }
                                    let _e3947 = phi_2743_;
                                    if (_e3933[2] < 0.0lf) {
                                        phi_2750_ = -(_e3933[2]);
                                    } else {
                                        phi_2750_ = _e3933[2];
                                    }
                                    let _e3951 = phi_2750_;
                                    if (_e3947 > _e3951) {
                                        phi_2755_ = _e3947;
                                    } else {
                                        phi_2755_ = _e3951;
                                    }
                                    let _e3954 = phi_2755_;
                                    if (_e3930 > _e3954) {
                                        phi_2760_ = _e3930;
                                    } else {
                                        phi_2760_ = _e3954;
                                    }
                                    let _e3957 = phi_2760_;
                                    let _e3959 = local_12.member_3;
                                    let _e3963 = local_12.member_2[0u];
                                    if (_e3963[0] < 0.0lf) {
                                        phi_2777_ = -(_e3963[0]);
                                    } else {
                                        phi_2777_ = _e3963[0];
                                    }
                                    let _e3970 = phi_2777_;
                                    if (_e3963[1] < 0.0lf) {
                                        phi_2784_ = -(_e3963[1]);
                                    } else {
                                        phi_2784_ = _e3963[1];
                                    }
                                    let _e3974 = phi_2784_;
                                    if (_e3970 > _e3974) {
                                        phi_2789_ = _e3970;
                                    } else {
                                        phi_2789_ = _e3974;
                                    }
                                    let _e3977 = phi_2789_;
                                    if (_e3963[2] < 0.0lf) {
                                        phi_2796_ = -(_e3963[2]);
                                    } else {
                                        phi_2796_ = _e3963[2];
                                    }
                                    let _e3981 = phi_2796_;
                                    if (_e3977 > _e3981) {
                                        phi_2801_ = _e3977;
                                    } else {
                                        phi_2801_ = _e3981;
                                    }
                                    let _e3984 = phi_2801_;
                                    let _e3987 = local_12.member_2[1u];
                                    if (_e3987[0] < 0.0lf) {
                                        phi_2815_ = -(_e3987[0]);
                                    } else {
                                        phi_2815_ = _e3987[0];
                                    }
                                    let _e3994 = phi_2815_;
                                    if (_e3987[1] < 0.0lf) {
                                        phi_2822_ = -(_e3987[1]);
                                    } else {
                                        phi_2822_ = _e3987[1];
                                    }
                                    let _e3998 = phi_2822_;
                                    if (_e3994 > _e3998) {
                                        phi_2827_ = _e3994;
                                    } else {
                                        phi_2827_ = _e3998;
                                    }
                                    let _e4001 = phi_2827_;
                                    if (_e3987[2] < 0.0lf) {
                                        phi_2834_ = -(_e3987[2]);
                                    } else {
                                        phi_2834_ = _e3987[2];
                                    }
                                    let _e4005 = phi_2834_;
                                    if (_e4001 > _e4005) {
                                        phi_2839_ = _e4001;
                                    } else {
                                        phi_2839_ = _e4005;
                                    }
                                    let _e4008 = phi_2839_;
                                    if (_e3984 > _e4008) {
                                        phi_2844_ = _e3984;
                                    } else {
                                        phi_2844_ = _e4008;
                                    }
                                    let _e4011 = phi_2844_;
                                    let _e4013 = local_12.member_3;
                                    let _e4021 = local_12.member_3;
                                    let _e4031 = (((_e3847 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e3903 + _e3905) + (_e3957 + _e3959)) + (_e4011 + _e4013)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4021 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e373);
                                    if _e4031 {
                                        phi_2868_ = false;
                                    } else {
                                        phi_2868_ = true;
                                    }
                                    let _e4033 = phi_2868_;
                                    phi_2869_ = _e4033;
                                    phi_2870_ = _e4031;
                                } else {
                                    phi_2869_ = false;
                                    phi_2870_ = false;
                                }
                                let _e4035 = phi_2869_;
                                let _e4037 = phi_2870_;
                                local_42 = _e4037;
                                continue;
                                continuing {
                                    phi_2360_ = _e3702;
                                    break if !(_e4035);
                                }
                            }
                            let _e4040 = local_42;
                            if _e4040 {
                                phi_2875_ = type_40(1u, _e3678.member_1);
                                phi_2876_ = false;
                            } else {
                                phi_2875_ = type_40();
                                phi_2876_ = true;
                            }
                            let _e4043 = phi_2875_;
                            let _e4045 = phi_2876_;
                            if _e4045 {
                                phi_2881_ = type_40(2u, _e3678.member_1);
                                phi_2882_ = false;
                            } else {
                                phi_2881_ = type_40();
                                phi_2882_ = true;
                            }
                            let _e4048 = phi_2881_;
                            let _e4050 = phi_2882_;
                            phi_2884_ = _e4048;
                            phi_2885_ = _e4043;
                            phi_2886_ = _e4050;
                        } else {
                            phi_2884_ = type_40();
                            phi_2885_ = type_40(0u, type_40().member_1);
                            phi_2886_ = true;
                        }
                        let _e4052 = phi_2884_;
                        let _e4054 = phi_2885_;
                        let _e4056 = phi_2886_;
                        if _e4056 {
                            phi_2890_ = _e4054;
                        } else {
                            phi_2890_ = _e4052;
                        }
                        let _e4058 = phi_2890_;
                        phi_5774_ = _e4058;
                    } else {
                        if (_e472 < 0.0lf) {
                            phi_2901_ = -(_e472);
                        } else {
                            phi_2901_ = _e472;
                        }
                        let _e827 = phi_2901_;
                        if (_e495 < 0.0lf) {
                            phi_2907_ = -(_e495);
                        } else {
                            phi_2907_ = _e495;
                        }
                        let _e831 = phi_2907_;
                        if (_e827 > _e831) {
                            phi_2912_ = _e827;
                        } else {
                            phi_2912_ = _e831;
                        }
                        let _e834 = phi_2912_;
                        if (_e518 < 0.0lf) {
                            phi_2918_ = -(_e518);
                        } else {
                            phi_2918_ = _e518;
                        }
                        let _e838 = phi_2918_;
                        if (_e529 < 0.0lf) {
                            phi_2924_ = -(_e529);
                        } else {
                            phi_2924_ = _e529;
                        }
                        let _e842 = phi_2924_;
                        if (_e838 > _e842) {
                            phi_2929_ = _e838;
                        } else {
                            phi_2929_ = _e842;
                        }
                        let _e845 = phi_2929_;
                        if (_e834 > _e845) {
                            phi_2934_ = _e834;
                        } else {
                            phi_2934_ = _e845;
                        }
                        let _e848 = phi_2934_;
                        let _e850 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e851 = f64(1f);
                        if (_e848 >= _e850) {
                            phi_2944_ = (_e848 <= (_e851 / _e850));
                        } else {
                            phi_2944_ = false;
                        }
                        let _e856 = phi_2944_;
                        if _e856 {
                            phi_2951_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_2951_ = f64(2f);
                        }
                        let _e861 = phi_2951_;
                        let _e863 = ((_e788 * f64(0.34f)) + (_e848 * _e861));
                        if _e856 {
                            phi_2959_ = (_e851 / _e848);
                        } else {
                            phi_2959_ = f64(0f);
                        }
                        let _e867 = phi_2959_;
                        let _e868 = f64(0f);
                        let _e869 = f64(1f);
                        let _e870 = f64(3f);
                        let _e876 = ((_e495 - (_e870 * _e472)) * _e867);
                        let _e877 = ((_e518 - _e495) * _e867);
                        let _e878 = (((_e870 * _e529) - _e518) * _e867);
                        local_6[0u] = _e868;
                        local_6[1u] = _e869;
                        local_6[2u] = _e869;
                        local_6[3u] = _e869;
                        let _e885 = ((_e877 * _e877) - (_e876 * _e878));
                        if (_e885 > _e868) {
                            if (_e885 <= 2.2250738585072014e-308lf) {
                                if (_e885 > 0.0lf) {
                                    phi_2995_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_2995_ = 0.0lf;
                                }
                                let _e938 = phi_2995_;
                                phi_3059_ = _e938;
                            } else {
                                phi_3002_ = type_17(0i, 5i);
                                phi_3005_ = bitcast<f64>(((bitcast<u64>(_e885) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e893 = phi_3002_;
                                    let _e895 = phi_3005_;
                                    local_13 = _e895;
                                    if (_e893.member < _e893.member_1) {
                                        let _e902 = (_e893.member + 1i);
                                        if ((false == (_e902 > _e893.member)) != false) {
                                            phi_3026_ = true;
                                        } else {
                                            phi_3026_ = false;
                                        }
                                        let _e907 = phi_3026_;
                                        if _e907 {
                                            phi_3032_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_3032_ = type_18(1u, _e902);
                                        }
                                        let _e912 = phi_3032_;
                                        phi_3003_ = type_17(_e912.member_1, _e893.member_1);
                                        phi_3046_ = type_18(1u, _e893.member);
                                    } else {
                                        phi_3003_ = _e893;
                                        phi_3046_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e918 = phi_3003_;
                                    let _e920 = phi_3046_;
                                    let _e923 = (bitcast<i32>(_e920.member) != 0i);
                                    if _e923 {
                                        phi_3006_ = (0.5lf * (_e895 + (_e885 / _e895)));
                                    } else {
                                        phi_3006_ = f64();
                                    }
                                    let _e928 = phi_3006_;
                                    continue;
                                    continuing {
                                        phi_3002_ = _e918;
                                        phi_3005_ = _e928;
                                        break if !(_e923);
                                    }
                                }
                                let _e933 = local_13;
                                phi_3059_ = (_e933 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e940 = phi_3059_;
                            if (_e877 < _e868) {
                                phi_3065_ = -(_e940);
                            } else {
                                phi_3065_ = _e940;
                            }
                            let _e944 = phi_3065_;
                            let _e946 = -((_e877 + _e944));
                            local_7[0u] = (_e946 / (_e946 + _e878));
                            local_7[1u] = (_e876 / (_e876 + _e946));
                            let _e955 = local_7[1u];
                            let _e956 = local_7[0u];
                            if (_e955 < _e956) {
                                let _e959 = local_7[1u];
                                let _e961 = local_7[0u];
                                local_7[0u] = _e959;
                                local_7[1u] = _e961;
                            }
                            phi_3090_ = type_19(0u, 2u);
                            phi_3093_ = 1u;
                            loop {
                                let _e965 = phi_3090_;
                                let _e967 = phi_3093_;
                                local_43 = _e967;
                                if (_e965.member < _e965.member_1) {
                                    phi_3091_ = type_19((_e965.member + 1u), _e965.member_1);
                                    phi_3116_ = type_19(1u, _e965.member);
                                } else {
                                    phi_3091_ = _e965;
                                    phi_3116_ = type_19(0u, type_19().member_1);
                                }
                                let _e979 = phi_3091_;
                                let _e981 = phi_3116_;
                                let _e985 = (bitcast<i32>(_e981.member) != 0i);
                                if _e985 {
                                    let _e987 = local_7[_e981.member_1];
                                    if (_e987 > _e868) {
                                        let _e990 = local_7[_e981.member_1];
                                        if (_e990 < _e869) {
                                            let _e993 = local_7[_e981.member_1];
                                            local_6[_e967] = _e993;
                                            phi_3160_ = (_e967 + 1u);
                                        } else {
                                            phi_3160_ = _e967;
                                        }
                                        let _e997 = phi_3160_;
                                        phi_3161_ = _e997;
                                    } else {
                                        phi_3161_ = _e967;
                                    }
                                    let _e999 = phi_3161_;
                                    phi_3094_ = _e999;
                                } else {
                                    phi_3094_ = u32();
                                }
                                let _e1001 = phi_3094_;
                                continue;
                                continuing {
                                    phi_3090_ = _e979;
                                    phi_3093_ = _e1001;
                                    break if !(_e985);
                                }
                            }
                            let _e4236 = local_43;
                            phi_3162_ = _e4236;
                        } else {
                            phi_3162_ = 1u;
                        }
                        let _e1004 = phi_3162_;
                        local_6[_e1004] = _e869;
                        let _e1006 = local_6;
                        local_8 = _e1006;
                        phi_3182_ = type_19(0u, _e1004);
                        loop {
                            let _e1009 = phi_3182_;
                            if (_e1009.member < _e1009.member_1) {
                                phi_3183_ = type_19((_e1009.member + 1u), _e1009.member_1);
                                phi_3206_ = type_19(1u, _e1009.member);
                            } else {
                                phi_3183_ = _e1009;
                                phi_3206_ = type_19(0u, type_19().member_1);
                            }
                            let _e1021 = phi_3183_;
                            let _e1023 = phi_3206_;
                            if (bitcast<i32>(_e1023.member) != 0i) {
                                let _e1029 = local_8[_e1023.member_1];
                                let _e1032 = local_8[(_e1023.member_1 + 1u)];
                                let _e1034 = (f64(1f) - _e1029);
                                let _e1045 = ((((_e472 * _e1034) + (_e495 * _e1029)) * (_e1034 * _e1034)) + (((_e518 * _e1034) + (_e529 * _e1029)) * (_e1029 * _e1029)));
                                let _e1047 = (f64(1f) - _e1032);
                                let _e1058 = ((((_e472 * _e1047) + (_e495 * _e1032)) * (_e1047 * _e1047)) + (((_e518 * _e1047) + (_e529 * _e1032)) * (_e1032 * _e1032)));
                                if (_e1045 < 0.0lf) {
                                    phi_3260_ = -(_e1045);
                                } else {
                                    phi_3260_ = _e1045;
                                }
                                let _e1062 = phi_3260_;
                                let _e1063 = (_e1062 > _e863);
                                if (_e1058 < 0.0lf) {
                                    phi_3267_ = -(_e1058);
                                } else {
                                    phi_3267_ = _e1058;
                                }
                                let _e1067 = phi_3267_;
                                let _e1068 = (_e1067 > _e863);
                                let _e1069 = f64(0f);
                                if _e1063 {
                                    if _e1068 {
                                        phi_3279_ = ((_e1045 > _e1069) != (_e1058 > _e1069));
                                        phi_3280_ = false;
                                    } else {
                                        phi_3279_ = bool();
                                        phi_3280_ = true;
                                    }
                                    let _e1074 = phi_3279_;
                                    let _e1076 = phi_3280_;
                                    phi_3281_ = _e1074;
                                    phi_3282_ = _e1076;
                                } else {
                                    phi_3281_ = bool();
                                    phi_3282_ = true;
                                }
                                let _e1078 = phi_3281_;
                                let _e1080 = phi_3282_;
                                if _e1080 {
                                    phi_3286_ = false;
                                } else {
                                    phi_3286_ = _e1078;
                                }
                                let _e1082 = phi_3286_;
                                if _e1063 {
                                    if _e1068 {
                                        if _e1082 {
                                            phi_3298_ = type_41();
                                        } else {
                                            phi_3298_ = type_41(f64(1f), _e1069, _e1082);
                                        }
                                        let _e1086 = phi_3298_;
                                        phi_3299_ = _e1086;
                                        phi_3300_ = _e1082;
                                    } else {
                                        phi_3299_ = type_41();
                                        phi_3300_ = true;
                                    }
                                    let _e1088 = phi_3299_;
                                    let _e1090 = phi_3300_;
                                    phi_3301_ = _e1088;
                                    phi_3302_ = _e1090;
                                } else {
                                    phi_3301_ = type_41();
                                    phi_3302_ = true;
                                }
                                let _e1092 = phi_3301_;
                                let _e1094 = phi_3302_;
                                if _e1094 {
                                    if _e1063 {
                                        if (_e1045 < _e1069) {
                                            phi_3315_ = f64(-1f);
                                        } else {
                                            phi_3315_ = f64(1f);
                                        }
                                        let _e1099 = phi_3315_;
                                        let _e1100 = f64(0.00000000000022737368f);
                                        let _e1101 = f64(0.5f);
                                        let _e1102 = f64(3f);
                                        let _e1105 = (_e518 - _e495);
                                        phi_3328_ = type_19(0u, 64u);
                                        phi_3331_ = _e1032;
                                        phi_3333_ = _e1029;
                                        phi_3335_ = (_e1101 * (_e1029 + _e1032));
                                        loop {
                                            let _e1111 = phi_3328_;
                                            let _e1113 = phi_3331_;
                                            let _e1115 = phi_3333_;
                                            let _e1117 = phi_3335_;
                                            local_45 = _e1115;
                                            if (_e1111.member < _e1111.member_1) {
                                                phi_3329_ = type_19((_e1111.member + 1u), _e1111.member_1);
                                                phi_3358_ = type_19(1u, _e1111.member);
                                            } else {
                                                phi_3329_ = _e1111;
                                                phi_3358_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1129 = phi_3329_;
                                            let _e1131 = phi_3358_;
                                            if (bitcast<i32>(_e1131.member) != 0i) {
                                                let _e1136 = (f64(1f) - _e1117);
                                                let _e1149 = ((_e1099 * ((((_e472 * _e1136) + (_e495 * _e1117)) * (_e1136 * _e1136)) + (((_e518 * _e1136) + (_e529 * _e1117)) * (_e1117 * _e1117)))) - _e863);
                                                if (_e1149 > f64(0f)) {
                                                    phi_3385_ = _e1113;
                                                    phi_3386_ = _e1117;
                                                } else {
                                                    phi_3385_ = _e1117;
                                                    phi_3386_ = _e1115;
                                                }
                                                let _e1153 = phi_3385_;
                                                let _e1155 = phi_3386_;
                                                let _e1157 = ((_e1153 - _e1155) > _e1100);
                                                if _e1157 {
                                                    let _e1159 = (f64(1f) - _e1117);
                                                    let _e1171 = (-(_e1149) / (_e1099 * (((((_e495 - (_e1102 * _e472)) * _e1159) + (_e1105 * _e1117)) * _e1159) + (((_e1105 * _e1159) + (((_e1102 * _e529) - _e518) * _e1117)) * _e1117))));
                                                    if (_e1149 > f64(0f)) {
                                                        phi_3414_ = (_e1101 * _e1100);
                                                    } else {
                                                        phi_3414_ = -((_e1101 * _e1100));
                                                    }
                                                    let _e1178 = phi_3414_;
                                                    let _e1180 = ((_e1117 + _e1171) + _e1178);
                                                    if (_e1180 > _e1155) {
                                                        if (_e1180 < _e1153) {
                                                            if (_e1171 < 0.0lf) {
                                                                phi_3430_ = -(_e1171);
                                                            } else {
                                                                phi_3430_ = _e1171;
                                                            }
                                                            let _e1186 = phi_3430_;
                                                            if (_e1186 < (_e1101 * (_e1153 - _e1155))) {
                                                                phi_3437_ = false;
                                                            } else {
                                                                phi_3437_ = true;
                                                            }
                                                            let _e1191 = phi_3437_;
                                                            phi_3438_ = _e1191;
                                                        } else {
                                                            phi_3438_ = true;
                                                        }
                                                        let _e1193 = phi_3438_;
                                                        phi_3439_ = _e1193;
                                                    } else {
                                                        phi_3439_ = true;
                                                    }
                                                    let _e1195 = phi_3439_;
                                                    if _e1195 {
                                                        phi_3445_ = (_e1101 * (_e1155 + _e1153));
                                                    } else {
                                                        phi_3445_ = _e1180;
                                                    }
                                                    let _e1199 = phi_3445_;
                                                    phi_3446_ = _e1199;
                                                    phi_3447_ = false;
                                                } else {
                                                    phi_3446_ = f64();
                                                    phi_3447_ = true;
                                                }
                                                let _e1201 = phi_3446_;
                                                let _e1203 = phi_3447_;
                                                phi_3332_ = _e1153;
                                                phi_3334_ = _e1155;
                                                phi_3336_ = _e1201;
                                                phi_3448_ = _e1155;
                                                phi_3449_ = _e1157;
                                                phi_3450_ = _e1203;
                                            } else {
                                                phi_3332_ = f64();
                                                phi_3334_ = f64();
                                                phi_3336_ = f64();
                                                phi_3448_ = f64();
                                                phi_3449_ = false;
                                                phi_3450_ = false;
                                            }
                                            let _e1205 = phi_3332_;
                                            let _e1207 = phi_3334_;
                                            let _e1209 = phi_3336_;
                                            let _e1211 = phi_3448_;
                                            let _e1213 = phi_3449_;
                                            let _e1215 = phi_3450_;
                                            local_14 = _e1215;
                                            local_44 = _e1211;
                                            continue;
                                            continuing {
                                                phi_3328_ = _e1129;
                                                phi_3331_ = _e1205;
                                                phi_3333_ = _e1207;
                                                phi_3335_ = _e1209;
                                                break if !(_e1213);
                                            }
                                        }
                                        let _e1218 = local_14;
                                        if _e1218 {
                                            let _e4278 = local_44;
                                            phi_3454_ = _e4278;
                                        } else {
                                            let _e4280 = local_45;
                                            phi_3454_ = _e4280;
                                        }
                                        let _e1220 = phi_3454_;
                                        phi_3455_ = _e1220;
                                    } else {
                                        phi_3455_ = _e1029;
                                    }
                                    let _e1222 = phi_3455_;
                                    if _e1068 {
                                        phi_3463_ = type_19(0u, 64u);
                                        phi_3466_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1226 = phi_3463_;
                                            let _e1228 = phi_3466_;
                                            if (_e1226.member < _e1226.member_1) {
                                                phi_3464_ = type_19((_e1226.member + 1u), _e1226.member_1);
                                                phi_3489_ = type_19(1u, _e1226.member);
                                            } else {
                                                phi_3464_ = _e1226;
                                                phi_3489_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1240 = phi_3464_;
                                            let _e1242 = phi_3489_;
                                            if (bitcast<i32>(_e1242.member) != 0i) {
                                                let _e1246 = (_e1222 + _e1228);
                                                if (_e1246 < _e1032) {
                                                    let _e1249 = (f64(1f) - _e1246);
                                                    let _e1260 = ((((_e472 * _e1249) + (_e495 * _e1246)) * (_e1249 * _e1249)) + (((_e518 * _e1249) + (_e529 * _e1246)) * (_e1246 * _e1246)));
                                                    let _e1262 = (f64(1f) - _e1222);
                                                    let _e1273 = ((((_e472 * _e1262) + (_e495 * _e1222)) * (_e1262 * _e1262)) + (((_e518 * _e1262) + (_e529 * _e1222)) * (_e1222 * _e1222)));
                                                    if (_e1260 < 0.0lf) {
                                                        phi_3532_ = -(_e1260);
                                                    } else {
                                                        phi_3532_ = _e1260;
                                                    }
                                                    let _e1277 = phi_3532_;
                                                    if (_e1277 > _e863) {
                                                        if (_e1273 < 0.0lf) {
                                                            phi_3542_ = -(_e1273);
                                                        } else {
                                                            phi_3542_ = _e1273;
                                                        }
                                                        let _e1282 = phi_3542_;
                                                        if (_e1282 > _e863) {
                                                            phi_3552_ = ((_e1260 > f64(0f)) == (_e1273 > f64(0f)));
                                                        } else {
                                                            phi_3552_ = false;
                                                        }
                                                        let _e1290 = phi_3552_;
                                                        phi_3554_ = !(_e1290);
                                                    } else {
                                                        phi_3554_ = false;
                                                    }
                                                    let _e1293 = phi_3554_;
                                                    if _e1293 {
                                                        phi_3559_ = f64();
                                                        phi_3560_ = false;
                                                    } else {
                                                        phi_3559_ = (_e1228 + _e1228);
                                                        phi_3560_ = true;
                                                    }
                                                    let _e1296 = phi_3559_;
                                                    let _e1298 = phi_3560_;
                                                    phi_3561_ = _e1296;
                                                    phi_3562_ = _e1298;
                                                    phi_3563_ = _e1293;
                                                    phi_3564_ = false;
                                                } else {
                                                    phi_3561_ = f64();
                                                    phi_3562_ = false;
                                                    phi_3563_ = false;
                                                    phi_3564_ = true;
                                                }
                                                let _e1300 = phi_3561_;
                                                let _e1302 = phi_3562_;
                                                let _e1304 = phi_3563_;
                                                let _e1306 = phi_3564_;
                                                phi_3565_ = _e1246;
                                                phi_3467_ = _e1300;
                                                phi_3566_ = _e1302;
                                                phi_3567_ = _e1304;
                                                phi_3568_ = _e1306;
                                                phi_3569_ = false;
                                            } else {
                                                phi_3565_ = f64();
                                                phi_3467_ = f64();
                                                phi_3566_ = false;
                                                phi_3567_ = false;
                                                phi_3568_ = false;
                                                phi_3569_ = true;
                                            }
                                            let _e1308 = phi_3565_;
                                            let _e1310 = phi_3467_;
                                            let _e1312 = phi_3566_;
                                            let _e1314 = phi_3567_;
                                            let _e1316 = phi_3568_;
                                            let _e1318 = phi_3569_;
                                            local_15 = _e1314;
                                            local_46 = _e1316;
                                            local_47 = _e1318;
                                            local_48 = _e1308;
                                            continue;
                                            continuing {
                                                phi_3463_ = _e1240;
                                                phi_3466_ = _e1310;
                                                break if !(_e1312);
                                            }
                                        }
                                        let _e1321 = local_15;
                                        if _e1321 {
                                            phi_3573_ = false;
                                            phi_3574_ = false;
                                        } else {
                                            let _e4305 = local_46;
                                            phi_3573_ = _e4305;
                                            let _e4308 = local_47;
                                            phi_3574_ = _e4308;
                                        }
                                        let _e1323 = phi_3573_;
                                        let _e1325 = phi_3574_;
                                        if _e1323 {
                                            phi_3578_ = true;
                                        } else {
                                            phi_3578_ = _e1325;
                                        }
                                        let _e1327 = phi_3578_;
                                        if _e1327 {
                                            phi_3582_ = _e1032;
                                        } else {
                                            let _e4312 = local_48;
                                            phi_3582_ = _e4312;
                                        }
                                        let _e1329 = phi_3582_;
                                        phi_3583_ = _e1329;
                                    } else {
                                        phi_3583_ = _e1032;
                                    }
                                    let _e1331 = phi_3583_;
                                    phi_3585_ = type_41(_e1222, _e1331, _e1082);
                                } else {
                                    phi_3585_ = _e1092;
                                }
                                let _e1334 = phi_3585_;
                                if (_e1334.member > _e1334.member_1) {
                                    phi_5730_ = f64();
                                    phi_5731_ = true;
                                    phi_5732_ = false;
                                    phi_5733_ = false;
                                    phi_5734_ = false;
                                } else {
                                    let _e1342 = ((_e1334.member_1 - _e1334.member) * f64(0.5f));
                                    let _e1343 = (_e1334.member + _e1342);
                                    let _e1346 = (_e1342 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1348 = local_12.member_3;
                                    let _e1351 = local_12.member[0u];
                                    if (_e1351[0] < 0.0lf) {
                                        phi_3616_ = -(_e1351[0]);
                                    } else {
                                        phi_3616_ = _e1351[0];
                                    }
                                    let _e1358 = phi_3616_;
                                    if (_e1351[1] < 0.0lf) {
                                        phi_3623_ = -(_e1351[1]);
                                    } else {
                                        phi_3623_ = _e1351[1];
                                    }
                                    let _e1362 = phi_3623_;
                                    if (_e1358 > _e1362) {
                                        phi_3628_ = _e1358;
                                    } else {
                                        phi_3628_ = _e1362;
                                    }
                                    let _e1365 = phi_3628_;
                                    if (_e1351[2] < 0.0lf) {
                                        phi_3635_ = -(_e1351[2]);
                                    } else {
                                        phi_3635_ = _e1351[2];
                                    }
                                    let _e1369 = phi_3635_;
                                    if (_e1365 > _e1369) {
                                        phi_3640_ = _e1365;
                                    } else {
                                        phi_3640_ = _e1369;
                                    }
                                    let _e1372 = phi_3640_;
                                    let _e1374 = local_12.member[1u];
                                    if (_e1374[0] < 0.0lf) {
                                        phi_3653_ = -(_e1374[0]);
                                    } else {
                                        phi_3653_ = _e1374[0];
                                    }
                                    let _e1381 = phi_3653_;
                                    if (_e1374[1] < 0.0lf) {
                                        phi_3660_ = -(_e1374[1]);
                                    } else {
                                        phi_3660_ = _e1374[1];
                                    }
                                    let _e1385 = phi_3660_;
                                    if (_e1381 > _e1385) {
                                        phi_3665_ = _e1381;
                                    } else {
                                        phi_3665_ = _e1385;
                                    }
                                    let _e1388 = phi_3665_;
                                    if (_e1374[2] < 0.0lf) {
                                        phi_3672_ = -(_e1374[2]);
                                    } else {
                                        phi_3672_ = _e1374[2];
                                    }
                                    let _e1392 = phi_3672_;
                                    if (_e1388 > _e1392) {
                                        phi_3677_ = _e1388;
                                    } else {
                                        phi_3677_ = _e1392;
                                    }
                                    let _e1395 = phi_3677_;
                                    if (_e1372 > _e1395) {
                                        phi_3682_ = _e1372;
                                    } else {
                                        phi_3682_ = _e1395;
                                    }
                                    let _e1398 = phi_3682_;
                                    let _e1401 = local_12.member[0u];
                                    let _e1406 = local_12.member[1u];
                                    let _e1416 = (_e1401[0] + ((_e1406[0] - _e1401[0]) * _e1343));
                                    let _e1417 = (_e1401[1] + ((_e1406[1] - _e1401[1]) * _e1343));
                                    let _e1418 = (_e1401[2] + ((_e1406[2] - _e1401[2]) * _e1343));
                                    let _e1420 = local_12.member[1u];
                                    let _e1425 = local_12.member[0u];
                                    let _e1429 = (_e1420[0] - _e1425[0]);
                                    let _e1430 = (_e1420[1] - _e1425[1]);
                                    let _e1431 = (_e1420[2] - _e1425[2]);
                                    if (_e1429 < 0.0lf) {
                                        phi_3741_ = -(_e1429);
                                    } else {
                                        phi_3741_ = _e1429;
                                    }
                                    let _e1435 = phi_3741_;
                                    if (_e1430 < 0.0lf) {
                                        phi_3747_ = -(_e1430);
                                    } else {
                                        phi_3747_ = _e1430;
                                    }
                                    let _e1439 = phi_3747_;
                                    if (_e1435 > _e1439) {
                                        phi_3752_ = _e1435;
                                    } else {
                                        phi_3752_ = _e1439;
                                    }
                                    let _e1442 = phi_3752_;
                                    if (_e1431 < 0.0lf) {
                                        phi_3758_ = -(_e1431);
                                    } else {
                                        phi_3758_ = _e1431;
                                    }
                                    let _e1446 = phi_3758_;
                                    if (_e1442 > _e1446) {
                                        phi_3763_ = _e1442;
                                    } else {
                                        phi_3763_ = _e1446;
                                    }
                                    let _e1449 = phi_3763_;
                                    let _e1457 = ((((_e1346 * _e1449) * f64(1.01f)) + ((_e1398 + _e1348) * (1.1102230246251565e-16lf * f64(8f)))) + _e1348);
                                    if (_e1416 < 0.0lf) {
                                        phi_3777_ = -(_e1416);
                                    } else {
                                        phi_3777_ = _e1416;
                                    }
                                    let _e1461 = phi_3777_;
                                    if (_e1417 < 0.0lf) {
                                        phi_3783_ = -(_e1417);
                                    } else {
                                        phi_3783_ = _e1417;
                                    }
                                    let _e1465 = phi_3783_;
                                    if (_e1461 > _e1465) {
                                        phi_3788_ = _e1461;
                                    } else {
                                        phi_3788_ = _e1465;
                                    }
                                    let _e1468 = phi_3788_;
                                    if (_e1418 < 0.0lf) {
                                        phi_3794_ = -(_e1418);
                                    } else {
                                        phi_3794_ = _e1418;
                                    }
                                    let _e1472 = phi_3794_;
                                    if (_e1468 > _e1472) {
                                        phi_3799_ = _e1468;
                                    } else {
                                        phi_3799_ = _e1472;
                                    }
                                    let _e1475 = phi_3799_;
                                    local_2 = type_32(array<f64, 3>(_e1416, _e1417, _e1418), _e1457, (_e1475 + _e1457));
                                    let _e1481 = local_12.member_3;
                                    let _e1483 = local_12.member_1[0u];
                                    if (_e1483[0] < 0.0lf) {
                                        phi_3825_ = -(_e1483[0]);
                                    } else {
                                        phi_3825_ = _e1483[0];
                                    }
                                    let _e1490 = phi_3825_;
                                    if (_e1483[1] < 0.0lf) {
                                        phi_3832_ = -(_e1483[1]);
                                    } else {
                                        phi_3832_ = _e1483[1];
                                    }
                                    let _e1494 = phi_3832_;
                                    if (_e1490 > _e1494) {
                                        phi_3837_ = _e1490;
                                    } else {
                                        phi_3837_ = _e1494;
                                    }
                                    let _e1497 = phi_3837_;
                                    if (_e1483[2] < 0.0lf) {
                                        phi_3844_ = -(_e1483[2]);
                                    } else {
                                        phi_3844_ = _e1483[2];
                                    }
                                    let _e1501 = phi_3844_;
                                    if (_e1497 > _e1501) {
                                        phi_3849_ = _e1497;
                                    } else {
                                        phi_3849_ = _e1501;
                                    }
                                    let _e1504 = phi_3849_;
                                    let _e1506 = local_12.member_1[1u];
                                    if (_e1506[0] < 0.0lf) {
                                        phi_3862_ = -(_e1506[0]);
                                    } else {
                                        phi_3862_ = _e1506[0];
                                    }
                                    let _e1513 = phi_3862_;
                                    if (_e1506[1] < 0.0lf) {
                                        phi_3869_ = -(_e1506[1]);
                                    } else {
                                        phi_3869_ = _e1506[1];
                                    }
                                    let _e1517 = phi_3869_;
                                    if (_e1513 > _e1517) {
                                        phi_3874_ = _e1513;
                                    } else {
                                        phi_3874_ = _e1517;
                                    }
                                    let _e1520 = phi_3874_;
                                    if (_e1506[2] < 0.0lf) {
                                        phi_3881_ = -(_e1506[2]);
                                    } else {
                                        phi_3881_ = _e1506[2];
                                    }
                                    let _e1524 = phi_3881_;
                                    if (_e1520 > _e1524) {
                                        phi_3886_ = _e1520;
                                    } else {
                                        phi_3886_ = _e1524;
                                    }
                                    let _e1527 = phi_3886_;
                                    if (_e1504 > _e1527) {
                                        phi_3891_ = _e1504;
                                    } else {
                                        phi_3891_ = _e1527;
                                    }
                                    let _e1530 = phi_3891_;
                                    let _e1533 = local_12.member_1[0u];
                                    let _e1538 = local_12.member_1[1u];
                                    let _e1548 = (_e1533[0] + ((_e1538[0] - _e1533[0]) * _e1343));
                                    let _e1549 = (_e1533[1] + ((_e1538[1] - _e1533[1]) * _e1343));
                                    let _e1550 = (_e1533[2] + ((_e1538[2] - _e1533[2]) * _e1343));
                                    let _e1552 = local_12.member_1[1u];
                                    let _e1557 = local_12.member_1[0u];
                                    let _e1561 = (_e1552[0] - _e1557[0]);
                                    let _e1562 = (_e1552[1] - _e1557[1]);
                                    let _e1563 = (_e1552[2] - _e1557[2]);
                                    if (_e1561 < 0.0lf) {
                                        phi_3950_ = -(_e1561);
                                    } else {
                                        phi_3950_ = _e1561;
                                    }
                                    let _e1567 = phi_3950_;
                                    if (_e1562 < 0.0lf) {
                                        phi_3956_ = -(_e1562);
                                    } else {
                                        phi_3956_ = _e1562;
                                    }
                                    let _e1571 = phi_3956_;
                                    if (_e1567 > _e1571) {
                                        phi_3961_ = _e1567;
                                    } else {
                                        phi_3961_ = _e1571;
                                    }
                                    let _e1574 = phi_3961_;
                                    if (_e1563 < 0.0lf) {
                                        phi_3967_ = -(_e1563);
                                    } else {
                                        phi_3967_ = _e1563;
                                    }
                                    let _e1578 = phi_3967_;
                                    if (_e1574 > _e1578) {
                                        phi_3972_ = _e1574;
                                    } else {
                                        phi_3972_ = _e1578;
                                    }
                                    let _e1581 = phi_3972_;
                                    let _e1589 = ((((_e1346 * _e1581) * f64(1.01f)) + ((_e1530 + _e1481) * (1.1102230246251565e-16lf * f64(8f)))) + _e1481);
                                    if (_e1548 < 0.0lf) {
                                        phi_3986_ = -(_e1548);
                                    } else {
                                        phi_3986_ = _e1548;
                                    }
                                    let _e1593 = phi_3986_;
                                    if (_e1549 < 0.0lf) {
                                        phi_3992_ = -(_e1549);
                                    } else {
                                        phi_3992_ = _e1549;
                                    }
                                    let _e1597 = phi_3992_;
                                    if (_e1593 > _e1597) {
                                        phi_3997_ = _e1593;
                                    } else {
                                        phi_3997_ = _e1597;
                                    }
                                    let _e1600 = phi_3997_;
                                    if (_e1550 < 0.0lf) {
                                        phi_4003_ = -(_e1550);
                                    } else {
                                        phi_4003_ = _e1550;
                                    }
                                    let _e1604 = phi_4003_;
                                    if (_e1600 > _e1604) {
                                        phi_4008_ = _e1600;
                                    } else {
                                        phi_4008_ = _e1604;
                                    }
                                    let _e1607 = phi_4008_;
                                    local_3 = type_32(array<f64, 3>(_e1548, _e1549, _e1550), _e1589, (_e1607 + _e1589));
                                    let _e1613 = local_12.member_3;
                                    let _e1615 = local_12.member_2[0u];
                                    if (_e1615[0] < 0.0lf) {
                                        phi_4034_ = -(_e1615[0]);
                                    } else {
                                        phi_4034_ = _e1615[0];
                                    }
                                    let _e1622 = phi_4034_;
                                    if (_e1615[1] < 0.0lf) {
                                        phi_4041_ = -(_e1615[1]);
                                    } else {
                                        phi_4041_ = _e1615[1];
                                    }
                                    let _e1626 = phi_4041_;
                                    if (_e1622 > _e1626) {
                                        phi_4046_ = _e1622;
                                    } else {
                                        phi_4046_ = _e1626;
                                    }
                                    let _e1629 = phi_4046_;
                                    if (_e1615[2] < 0.0lf) {
                                        phi_4053_ = -(_e1615[2]);
                                    } else {
                                        phi_4053_ = _e1615[2];
                                    }
                                    let _e1633 = phi_4053_;
                                    if (_e1629 > _e1633) {
                                        phi_4058_ = _e1629;
                                    } else {
                                        phi_4058_ = _e1633;
                                    }
                                    let _e1636 = phi_4058_;
                                    let _e1638 = local_12.member_2[1u];
                                    if (_e1638[0] < 0.0lf) {
                                        phi_4071_ = -(_e1638[0]);
                                    } else {
                                        phi_4071_ = _e1638[0];
                                    }
                                    let _e1645 = phi_4071_;
                                    if (_e1638[1] < 0.0lf) {
                                        phi_4078_ = -(_e1638[1]);
                                    } else {
                                        phi_4078_ = _e1638[1];
                                    }
                                    let _e1649 = phi_4078_;
                                    if (_e1645 > _e1649) {
                                        phi_4083_ = _e1645;
                                    } else {
                                        phi_4083_ = _e1649;
                                    }
                                    let _e1652 = phi_4083_;
                                    if (_e1638[2] < 0.0lf) {
                                        phi_4090_ = -(_e1638[2]);
                                    } else {
                                        phi_4090_ = _e1638[2];
                                    }
                                    let _e1656 = phi_4090_;
                                    if (_e1652 > _e1656) {
                                        phi_4095_ = _e1652;
                                    } else {
                                        phi_4095_ = _e1656;
                                    }
                                    let _e1659 = phi_4095_;
                                    if (_e1636 > _e1659) {
                                        phi_4100_ = _e1636;
                                    } else {
                                        phi_4100_ = _e1659;
                                    }
                                    let _e1662 = phi_4100_;
                                    let _e1665 = local_12.member_2[0u];
                                    let _e1670 = local_12.member_2[1u];
                                    let _e1680 = (_e1665[0] + ((_e1670[0] - _e1665[0]) * _e1343));
                                    let _e1681 = (_e1665[1] + ((_e1670[1] - _e1665[1]) * _e1343));
                                    let _e1682 = (_e1665[2] + ((_e1670[2] - _e1665[2]) * _e1343));
                                    let _e1684 = local_12.member_2[1u];
                                    let _e1689 = local_12.member_2[0u];
                                    let _e1693 = (_e1684[0] - _e1689[0]);
                                    let _e1694 = (_e1684[1] - _e1689[1]);
                                    let _e1695 = (_e1684[2] - _e1689[2]);
                                    if (_e1693 < 0.0lf) {
                                        phi_4159_ = -(_e1693);
                                    } else {
                                        phi_4159_ = _e1693;
                                    }
                                    let _e1699 = phi_4159_;
                                    if (_e1694 < 0.0lf) {
                                        phi_4165_ = -(_e1694);
                                    } else {
                                        phi_4165_ = _e1694;
                                    }
                                    let _e1703 = phi_4165_;
                                    if (_e1699 > _e1703) {
                                        phi_4170_ = _e1699;
                                    } else {
                                        phi_4170_ = _e1703;
                                    }
                                    let _e1706 = phi_4170_;
                                    if (_e1695 < 0.0lf) {
                                        phi_4176_ = -(_e1695);
                                    } else {
                                        phi_4176_ = _e1695;
                                    }
                                    let _e1710 = phi_4176_;
                                    if (_e1706 > _e1710) {
                                        phi_4181_ = _e1706;
                                    } else {
                                        phi_4181_ = _e1710;
                                    }
                                    let _e1713 = phi_4181_;
                                    let _e1721 = ((((_e1346 * _e1713) * f64(1.01f)) + ((_e1662 + _e1613) * (1.1102230246251565e-16lf * f64(8f)))) + _e1613);
                                    if (_e1680 < 0.0lf) {
                                        phi_4195_ = -(_e1680);
                                    } else {
                                        phi_4195_ = _e1680;
                                    }
                                    let _e1725 = phi_4195_;
                                    if (_e1681 < 0.0lf) {
                                        phi_4201_ = -(_e1681);
                                    } else {
                                        phi_4201_ = _e1681;
                                    }
                                    let _e1729 = phi_4201_;
                                    if (_e1725 > _e1729) {
                                        phi_4206_ = _e1725;
                                    } else {
                                        phi_4206_ = _e1729;
                                    }
                                    let _e1732 = phi_4206_;
                                    if (_e1682 < 0.0lf) {
                                        phi_4212_ = -(_e1682);
                                    } else {
                                        phi_4212_ = _e1682;
                                    }
                                    let _e1736 = phi_4212_;
                                    if (_e1732 > _e1736) {
                                        phi_4217_ = _e1732;
                                    } else {
                                        phi_4217_ = _e1736;
                                    }
                                    let _e1739 = phi_4217_;
                                    local_4 = type_32(array<f64, 3>(_e1680, _e1681, _e1682), _e1721, (_e1739 + _e1721));
                                    let _e1744 = local_3.member;
                                    let _e1749 = local_4.member;
                                    let _e1755 = ((_e1744[1] * _e1749[2]) - (_e1744[2] * _e1749[1]));
                                    let _e1758 = ((_e1744[2] * _e1749[0]) - (_e1744[0] * _e1749[2]));
                                    let _e1761 = ((_e1744[0] * _e1749[1]) - (_e1744[1] * _e1749[0]));
                                    if (_e1755 < 0.0lf) {
                                        phi_4266_ = -(_e1755);
                                    } else {
                                        phi_4266_ = _e1755;
                                    }
                                    let _e1765 = phi_4266_;
                                    if (_e1758 < 0.0lf) {
                                        phi_4272_ = -(_e1758);
                                    } else {
                                        phi_4272_ = _e1758;
                                    }
                                    let _e1769 = phi_4272_;
                                    if (_e1765 > _e1769) {
                                        if (_e1755 < 0.0lf) {
                                            phi_4282_ = -(_e1755);
                                        } else {
                                            phi_4282_ = _e1755;
                                        }
                                        let _e1787 = phi_4282_;
                                        if (_e1761 < 0.0lf) {
                                            phi_4288_ = -(_e1761);
                                        } else {
                                            phi_4288_ = _e1761;
                                        }
                                        let _e1791 = phi_4288_;
                                        if (_e1787 > _e1791) {
                                            phi_4293_ = 2u;
                                            phi_4294_ = 1u;
                                        } else {
                                            phi_4293_ = 1u;
                                            phi_4294_ = 0u;
                                        }
                                        let _e1794 = phi_4293_;
                                        let _e1796 = phi_4294_;
                                        phi_4313_ = _e1794;
                                        phi_4314_ = _e1796;
                                    } else {
                                        if (_e1758 < 0.0lf) {
                                            phi_4300_ = -(_e1758);
                                        } else {
                                            phi_4300_ = _e1758;
                                        }
                                        let _e1774 = phi_4300_;
                                        if (_e1761 < 0.0lf) {
                                            phi_4306_ = -(_e1761);
                                        } else {
                                            phi_4306_ = _e1761;
                                        }
                                        let _e1778 = phi_4306_;
                                        if (_e1774 > _e1778) {
                                            phi_4311_ = 0u;
                                            phi_4312_ = 2u;
                                        } else {
                                            phi_4311_ = 1u;
                                            phi_4312_ = 0u;
                                        }
                                        let _e1781 = phi_4311_;
                                        let _e1783 = phi_4312_;
                                        phi_4313_ = _e1781;
                                        phi_4314_ = _e1783;
                                    }
                                    let _e1798 = phi_4313_;
                                    let _e1800 = phi_4314_;
                                    let _e1803 = local_3.member[_e1800];
                                    let _e1806 = local_4.member[_e1798];
                                    let _e1810 = local_3.member[_e1798];
                                    let _e1813 = local_4.member[_e1800];
                                    let _e1815 = ((_e1803 * _e1806) - (_e1810 * _e1813));
                                    let _e1816 = f64(1f);
                                    let _e1818 = local_3.member_1;
                                    let _e1820 = local_4.member_2;
                                    let _e1823 = local_3.member_2;
                                    let _e1825 = local_4.member_1;
                                    let _e1831 = local_3.member_2;
                                    let _e1833 = local_4.member_2;
                                    let _e1842 = local_3.member_2;
                                    let _e1845 = local_4.member_2;
                                    let _e1849 = (((((_e1818 * _e1820) + (_e1823 * _e1825)) * f64(2.01f)) + ((_e1831 * _e1833) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1816 + _e1842) * (_e1816 + _e1845))));
                                    if (_e1815 < 0.0lf) {
                                        phi_4385_ = -(_e1815);
                                    } else {
                                        phi_4385_ = _e1815;
                                    }
                                    let _e1853 = phi_4385_;
                                    if (_e1853 > _e1849) {
                                        if (_e1815 < f64(0f)) {
                                            phi_4397_ = f64(-1f);
                                        } else {
                                            phi_4397_ = f64(1f);
                                        }
                                        let _e1860 = phi_4397_;
                                        let _e1863 = local_2.member[_e1800];
                                        let _e1866 = local_4.member[_e1798];
                                        let _e1870 = local_2.member[_e1798];
                                        let _e1873 = local_4.member[_e1800];
                                        let _e1876 = f64(1f);
                                        let _e1878 = local_2.member_1;
                                        let _e1880 = local_4.member_2;
                                        let _e1883 = local_2.member_2;
                                        let _e1885 = local_4.member_1;
                                        let _e1891 = local_2.member_2;
                                        let _e1893 = local_4.member_2;
                                        let _e1902 = local_2.member_2;
                                        let _e1905 = local_4.member_2;
                                        let _e1909 = (((((_e1878 * _e1880) + (_e1883 * _e1885)) * f64(2.01f)) + ((_e1891 * _e1893) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1876 + _e1902) * (_e1876 + _e1905))));
                                        let _e1912 = local_3.member[_e1800];
                                        let _e1915 = local_2.member[_e1798];
                                        let _e1919 = local_3.member[_e1798];
                                        let _e1922 = local_2.member[_e1800];
                                        let _e1925 = f64(1f);
                                        let _e1927 = local_3.member_1;
                                        let _e1929 = local_2.member_2;
                                        let _e1932 = local_3.member_2;
                                        let _e1934 = local_2.member_1;
                                        let _e1940 = local_3.member_2;
                                        let _e1942 = local_2.member_2;
                                        let _e1951 = local_3.member_2;
                                        let _e1954 = local_2.member_2;
                                        let _e1958 = (((((_e1927 * _e1929) + (_e1932 * _e1934)) * f64(2.01f)) + ((_e1940 * _e1942) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1925 + _e1951) * (_e1925 + _e1954))));
                                        let _e1959 = (_e1815 * _e1860);
                                        let _e1960 = (((_e1863 * _e1866) - (_e1870 * _e1873)) * _e1860);
                                        let _e1961 = (((_e1912 * _e1915) - (_e1919 * _e1922)) * _e1860);
                                        if (_e1959 < 0.0lf) {
                                            phi_4536_ = -(_e1959);
                                        } else {
                                            phi_4536_ = _e1959;
                                        }
                                        let _e1965 = phi_4536_;
                                        if (_e1960 < 0.0lf) {
                                            phi_4542_ = -(_e1960);
                                        } else {
                                            phi_4542_ = _e1960;
                                        }
                                        let _e1969 = phi_4542_;
                                        if (_e1961 < 0.0lf) {
                                            phi_4549_ = -(_e1961);
                                        } else {
                                            phi_4549_ = _e1961;
                                        }
                                        let _e1974 = phi_4549_;
                                        let _e1978 = (((_e1965 + _e1969) + _e1974) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_5[0u].member = _e1960;
                                        local_5[0u].member_1 = _e1909;
                                        local_5[1u].member = _e1961;
                                        local_5[1u].member_1 = _e1958;
                                        local_5[2u].member = (_e1959 - _e1960);
                                        local_5[2u].member_1 = ((_e1849 + _e1909) + _e1978);
                                        local_5[3u].member = (_e1959 - _e1961);
                                        local_5[3u].member_1 = ((_e1849 + _e1958) + _e1978);
                                        phi_4593_ = type_19(0u, 4u);
                                        phi_4596_ = true;
                                        loop {
                                            let _e1999 = phi_4593_;
                                            let _e2001 = phi_4596_;
                                            local_17 = _e2001;
                                            if (_e1999.member < _e1999.member_1) {
                                                phi_4594_ = type_19((_e1999.member + 1u), _e1999.member_1);
                                                phi_4619_ = type_19(1u, _e1999.member);
                                            } else {
                                                phi_4594_ = _e1999;
                                                phi_4619_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e2013 = phi_4594_;
                                            let _e2015 = phi_4619_;
                                            if (bitcast<i32>(_e2015.member) != 0i) {
                                                let _e2022 = local_5[_e2015.member_1].member;
                                                let _e2025 = local_5[_e2015.member_1].member_1;
                                                let _e2027 = (_e2022 < -(_e2025));
                                                if _e2027 {
                                                    phi_4646_ = bool();
                                                    phi_4647_ = false;
                                                } else {
                                                    phi_4646_ = (_e2001 && (_e2022 > _e2025));
                                                    phi_4647_ = true;
                                                }
                                                let _e2031 = phi_4646_;
                                                let _e2033 = phi_4647_;
                                                phi_4597_ = _e2031;
                                                phi_4648_ = _e2033;
                                                phi_4649_ = _e2027;
                                            } else {
                                                phi_4597_ = bool();
                                                phi_4648_ = false;
                                                phi_4649_ = false;
                                            }
                                            let _e2035 = phi_4597_;
                                            let _e2037 = phi_4648_;
                                            let _e2039 = phi_4649_;
                                            local_16 = _e2039;
                                            continue;
                                            continuing {
                                                phi_4593_ = _e2013;
                                                phi_4596_ = _e2035;
                                                break if !(_e2037);
                                            }
                                        }
                                        let _e2042 = local_16;
                                        if _e2042 {
                                            phi_4653_ = false;
                                        } else {
                                            phi_4653_ = true;
                                        }
                                        let _e2044 = phi_4653_;
                                        if _e2044 {
                                            let _e2046 = local_17;
                                            if _e2046 {
                                                phi_4660_ = 1u;
                                            } else {
                                                phi_4660_ = 2u;
                                            }
                                            let _e2048 = phi_4660_;
                                            phi_4661_ = _e2048;
                                            phi_4662_ = false;
                                        } else {
                                            phi_4661_ = u32();
                                            phi_4662_ = true;
                                        }
                                        let _e2050 = phi_4661_;
                                        let _e2052 = phi_4662_;
                                        phi_4663_ = _e2050;
                                        phi_4664_ = 0u;
                                        phi_4665_ = _e2052;
                                    } else {
                                        phi_4663_ = u32();
                                        phi_4664_ = 2u;
                                        phi_4665_ = true;
                                    }
                                    let _e2054 = phi_4663_;
                                    let _e2056 = phi_4664_;
                                    let _e2058 = phi_4665_;
                                    if _e2058 {
                                        phi_4669_ = _e2056;
                                    } else {
                                        phi_4669_ = _e2054;
                                    }
                                    let _e2060 = phi_4669_;
                                    let _e2061 = (_e2060 == 0u);
                                    if _e2061 {
                                        phi_5726_ = f64();
                                        phi_5727_ = false;
                                        phi_5728_ = false;
                                        phi_5729_ = false;
                                    } else {
                                        if (_e2060 == 1u) {
                                            if _e1334.member_2 {
                                                if ((_e1334.member_1 - _e1334.member) <= f64(0.0000005f)) {
                                                    phi_4690_ = false;
                                                } else {
                                                    phi_4690_ = true;
                                                }
                                                let _e2070 = phi_4690_;
                                                phi_4691_ = _e2070;
                                            } else {
                                                phi_4691_ = true;
                                            }
                                            let _e2072 = phi_4691_;
                                            phi_4692_ = _e2072;
                                        } else {
                                            phi_4692_ = true;
                                        }
                                        let _e2074 = phi_4692_;
                                        if _e2074 {
                                            let _e2080 = local_12.member[0u];
                                            let _e2086 = local_12.member_1[0u];
                                            let _e2092 = local_12.member_2[0u];
                                            let _e2096 = (_e2080[0] - _e2086[0]);
                                            let _e2097 = (_e2080[1] - _e2086[1]);
                                            let _e2098 = (_e2080[2] - _e2086[2]);
                                            local = array<array<f64, 3>, 4>(_e2080, array<f64, 3>(_e2096, _e2097, _e2098), array<f64, 3>((_e2080[0] - _e2092[0]), (_e2080[1] - _e2092[1]), (_e2080[2] - _e2092[2])), array<f64, 3>((_e2096 - _e2092[0]), (_e2097 - _e2092[1]), (_e2098 - _e2092[2])));
                                            let _e2111 = local_12.member[1u];
                                            let _e2117 = local_12.member_1[1u];
                                            let _e2123 = local_12.member_2[1u];
                                            let _e2127 = (_e2111[0] - _e2117[0]);
                                            let _e2128 = (_e2111[1] - _e2117[1]);
                                            let _e2129 = (_e2111[2] - _e2117[2]);
                                            local_1 = array<array<f64, 3>, 4>(_e2111, array<f64, 3>(_e2127, _e2128, _e2129), array<f64, 3>((_e2111[0] - _e2123[0]), (_e2111[1] - _e2123[1]), (_e2111[2] - _e2123[2])), array<f64, 3>((_e2127 - _e2123[0]), (_e2128 - _e2123[1]), (_e2129 - _e2123[2])));
                                            let _e2142 = local_12.member[0u];
                                            if (_e2142[0] < 0.0lf) {
                                                phi_4889_ = -(_e2142[0]);
                                            } else {
                                                phi_4889_ = _e2142[0];
                                            }
                                            let _e2149 = phi_4889_;
                                            if (_e2142[1] < 0.0lf) {
                                                phi_4896_ = -(_e2142[1]);
                                            } else {
                                                phi_4896_ = _e2142[1];
                                            }
                                            let _e2153 = phi_4896_;
                                            if (_e2149 > _e2153) {
                                                phi_4901_ = _e2149;
                                            } else {
                                                phi_4901_ = _e2153;
                                            }
                                            let _e2156 = phi_4901_;
                                            if (_e2142[2] < 0.0lf) {
                                                phi_4908_ = -(_e2142[2]);
                                            } else {
                                                phi_4908_ = _e2142[2];
                                            }
                                            let _e2160 = phi_4908_;
                                            if (_e2156 > _e2160) {
                                                phi_4913_ = _e2156;
                                            } else {
                                                phi_4913_ = _e2160;
                                            }
                                            let _e2163 = phi_4913_;
                                            let _e2166 = local_12.member[1u];
                                            if (_e2166[0] < 0.0lf) {
                                                phi_4926_ = -(_e2166[0]);
                                            } else {
                                                phi_4926_ = _e2166[0];
                                            }
                                            let _e2173 = phi_4926_;
                                            if (_e2166[1] < 0.0lf) {
                                                phi_4933_ = -(_e2166[1]);
                                            } else {
                                                phi_4933_ = _e2166[1];
                                            }
                                            let _e2177 = phi_4933_;
                                            if (_e2173 > _e2177) {
                                                phi_4938_ = _e2173;
                                            } else {
                                                phi_4938_ = _e2177;
                                            }
                                            let _e2180 = phi_4938_;
                                            if (_e2166[2] < 0.0lf) {
                                                phi_4945_ = -(_e2166[2]);
                                            } else {
                                                phi_4945_ = _e2166[2];
                                            }
                                            let _e2184 = phi_4945_;
                                            if (_e2180 > _e2184) {
                                                phi_4950_ = _e2180;
                                            } else {
                                                phi_4950_ = _e2184;
                                            }
                                            let _e2187 = phi_4950_;
                                            if (_e2163 > _e2187) {
                                                phi_4955_ = _e2163;
                                            } else {
                                                phi_4955_ = _e2187;
                                            }
                                            let _e2190 = phi_4955_;
                                            let _e2192 = local_12.member_3;
                                            let _e2196 = local_12.member_1[0u];
                                            if (_e2196[0] < 0.0lf) {
                                                phi_4972_ = -(_e2196[0]);
                                            } else {
                                                phi_4972_ = _e2196[0];
                                            }
                                            let _e2203 = phi_4972_;
                                            if (_e2196[1] < 0.0lf) {
                                                phi_4979_ = -(_e2196[1]);
                                            } else {
                                                phi_4979_ = _e2196[1];
                                            }
                                            let _e2207 = phi_4979_;
                                            if (_e2203 > _e2207) {
                                                phi_4984_ = _e2203;
                                            } else {
                                                phi_4984_ = _e2207;
                                            }
                                            let _e2210 = phi_4984_;
                                            if (_e2196[2] < 0.0lf) {
                                                phi_4991_ = -(_e2196[2]);
                                            } else {
                                                phi_4991_ = _e2196[2];
                                            }
                                            let _e2214 = phi_4991_;
                                            if (_e2210 > _e2214) {
                                                phi_4996_ = _e2210;
                                            } else {
                                                phi_4996_ = _e2214;
                                            }
                                            let _e2217 = phi_4996_;
                                            let _e2220 = local_12.member_1[1u];
                                            if (_e2220[0] < 0.0lf) {
                                                phi_5010_ = -(_e2220[0]);
                                            } else {
                                                phi_5010_ = _e2220[0];
                                            }
                                            let _e2227 = phi_5010_;
                                            if (_e2220[1] < 0.0lf) {
                                                phi_5017_ = -(_e2220[1]);
                                            } else {
                                                phi_5017_ = _e2220[1];
                                            }
                                            let _e2231 = phi_5017_;
                                            if (_e2227 > _e2231) {
                                                phi_5022_ = _e2227;
                                            } else {
                                                phi_5022_ = _e2231;
                                            }
                                            let _e2234 = phi_5022_;
                                            if (_e2220[2] < 0.0lf) {
                                                phi_5029_ = -(_e2220[2]);
                                            } else {
                                                phi_5029_ = _e2220[2];
                                            }
                                            let _e2238 = phi_5029_;
                                            if (_e2234 > _e2238) {
                                                phi_5034_ = _e2234;
                                            } else {
                                                phi_5034_ = _e2238;
                                            }
                                            let _e2241 = phi_5034_;
                                            if (_e2217 > _e2241) {
                                                phi_5039_ = _e2217;
                                            } else {
                                                phi_5039_ = _e2241;
                                            }
                                            let _e2244 = phi_5039_;
                                            let _e2246 = local_12.member_3;
                                            let _e2250 = local_12.member_2[0u];
                                            if (_e2250[0] < 0.0lf) {
                                                phi_5056_ = -(_e2250[0]);
                                            } else {
                                                phi_5056_ = _e2250[0];
                                            }
                                            let _e2257 = phi_5056_;
                                            if (_e2250[1] < 0.0lf) {
                                                phi_5063_ = -(_e2250[1]);
                                            } else {
                                                phi_5063_ = _e2250[1];
                                            }
                                            let _e2261 = phi_5063_;
                                            if (_e2257 > _e2261) {
                                                phi_5068_ = _e2257;
                                            } else {
                                                phi_5068_ = _e2261;
                                            }
                                            let _e2264 = phi_5068_;
                                            if (_e2250[2] < 0.0lf) {
                                                phi_5075_ = -(_e2250[2]);
                                            } else {
                                                phi_5075_ = _e2250[2];
                                            }
                                            let _e2268 = phi_5075_;
                                            if (_e2264 > _e2268) {
                                                phi_5080_ = _e2264;
                                            } else {
                                                phi_5080_ = _e2268;
                                            }
                                            let _e2271 = phi_5080_;
                                            let _e2274 = local_12.member_2[1u];
                                            if (_e2274[0] < 0.0lf) {
                                                phi_5094_ = -(_e2274[0]);
                                            } else {
                                                phi_5094_ = _e2274[0];
                                            }
                                            let _e2281 = phi_5094_;
                                            if (_e2274[1] < 0.0lf) {
                                                phi_5101_ = -(_e2274[1]);
                                            } else {
                                                phi_5101_ = _e2274[1];
                                            }
                                            let _e2285 = phi_5101_;
                                            if (_e2281 > _e2285) {
                                                phi_5106_ = _e2281;
                                            } else {
                                                phi_5106_ = _e2285;
                                            }
                                            let _e2288 = phi_5106_;
                                            if (_e2274[2] < 0.0lf) {
                                                phi_5113_ = -(_e2274[2]);
                                            } else {
                                                phi_5113_ = _e2274[2];
                                            }
                                            let _e2292 = phi_5113_;
                                            if (_e2288 > _e2292) {
                                                phi_5118_ = _e2288;
                                            } else {
                                                phi_5118_ = _e2292;
                                            }
                                            let _e2295 = phi_5118_;
                                            if (_e2271 > _e2295) {
                                                phi_5123_ = _e2271;
                                            } else {
                                                phi_5123_ = _e2295;
                                            }
                                            let _e2298 = phi_5123_;
                                            let _e2300 = local_12.member_3;
                                            let _e2308 = local_12.member_3;
                                            phi_5143_ = type_19(0u, 48u);
                                            phi_5146_ = _e1334.member;
                                            loop {
                                                let _e2317 = phi_5143_;
                                                let _e2319 = phi_5146_;
                                                local_61 = _e2319;
                                                local_24 = _e2319;
                                                local_25 = _e2319;
                                                local_26 = _e2319;
                                                local_27 = _e2319;
                                                if (_e2317.member < _e2317.member_1) {
                                                    phi_5144_ = type_19((_e2317.member + 1u), _e2317.member_1);
                                                    phi_5169_ = type_19(1u, _e2317.member);
                                                } else {
                                                    phi_5144_ = _e2317;
                                                    phi_5169_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2331 = phi_5144_;
                                                let _e2333 = phi_5169_;
                                                if (bitcast<i32>(_e2333.member) != 0i) {
                                                    let _e2339 = local_12.member[0u];
                                                    let _e2345 = local_12.member[1u];
                                                    let _e2361 = local_12.member_1[0u];
                                                    let _e2367 = local_12.member_1[1u];
                                                    let _e2383 = local_12.member_2[0u];
                                                    let _e2389 = local_12.member_2[1u];
                                                    let _e2403 = function_2(array<f64, 3>((_e2339[0] + ((_e2345[0] - _e2339[0]) * _e2319)), (_e2339[1] + ((_e2345[1] - _e2339[1]) * _e2319)), (_e2339[2] + ((_e2345[2] - _e2339[2]) * _e2319))), array<f64, 3>((_e2361[0] + ((_e2367[0] - _e2361[0]) * _e2319)), (_e2361[1] + ((_e2367[1] - _e2361[1]) * _e2319)), (_e2361[2] + ((_e2367[2] - _e2361[2]) * _e2319))), array<f64, 3>((_e2383[0] + ((_e2389[0] - _e2383[0]) * _e2319)), (_e2383[1] + ((_e2389[1] - _e2383[1]) * _e2319)), (_e2383[2] + ((_e2389[2] - _e2383[2]) * _e2319))), 1u);
                                                    if (_e2403[0] < 0.0lf) {
                                                        phi_5280_ = -(_e2403[0]);
                                                    } else {
                                                        phi_5280_ = _e2403[0];
                                                    }
                                                    let _e2408 = phi_5280_;
                                                    if (_e2403[1] < 0.0lf) {
                                                        phi_5287_ = -(_e2403[1]);
                                                    } else {
                                                        phi_5287_ = _e2403[1];
                                                    }
                                                    let _e2413 = phi_5287_;
                                                    if (_e2403[2] < 0.0lf) {
                                                        phi_5295_ = -(_e2403[2]);
                                                    } else {
                                                        phi_5295_ = _e2403[2];
                                                    }
                                                    let _e2419 = phi_5295_;
                                                    let _e2420 = ((_e2408 + _e2413) + _e2419);
                                                    if (_e2420 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2420) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2426 = (f64(1f) / _e2420);
                                                            let _e2428 = (_e2403[0] * _e2426);
                                                            let _e2430 = (_e2403[1] * _e2426);
                                                            let _e2432 = (_e2403[2] * _e2426);
                                                            let _e2437 = (((_e2428 * _e2428) + (_e2430 * _e2430)) + (_e2432 * _e2432));
                                                            if (_e2437 <= 2.2250738585072014e-308lf) {
                                                                if (_e2437 > 0.0lf) {
                                                                    phi_5333_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_5333_ = 0.0lf;
                                                                }
                                                                let _e2489 = phi_5333_;
                                                                phi_5397_ = _e2489;
                                                            } else {
                                                                phi_5340_ = type_17(0i, 5i);
                                                                phi_5343_ = bitcast<f64>(((bitcast<u64>(_e2437) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2444 = phi_5340_;
                                                                    let _e2446 = phi_5343_;
                                                                    local_18 = _e2446;
                                                                    if (_e2444.member < _e2444.member_1) {
                                                                        let _e2453 = (_e2444.member + 1i);
                                                                        if ((false == (_e2453 > _e2444.member)) != false) {
                                                                            phi_5364_ = true;
                                                                        } else {
                                                                            phi_5364_ = false;
                                                                        }
                                                                        let _e2458 = phi_5364_;
                                                                        if _e2458 {
                                                                            phi_5370_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_5370_ = type_18(1u, _e2453);
                                                                        }
                                                                        let _e2463 = phi_5370_;
                                                                        phi_5341_ = type_17(_e2463.member_1, _e2444.member_1);
                                                                        phi_5384_ = type_18(1u, _e2444.member);
                                                                    } else {
                                                                        phi_5341_ = _e2444;
                                                                        phi_5384_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2469 = phi_5341_;
                                                                    let _e2471 = phi_5384_;
                                                                    let _e2474 = (bitcast<i32>(_e2471.member) != 0i);
                                                                    if _e2474 {
                                                                        phi_5344_ = (0.5lf * (_e2446 + (_e2437 / _e2446)));
                                                                    } else {
                                                                        phi_5344_ = f64();
                                                                    }
                                                                    let _e2479 = phi_5344_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_5340_ = _e2469;
                                                                        phi_5343_ = _e2479;
                                                                        break if !(_e2474);
                                                                    }
                                                                }
                                                                let _e2484 = local_18;
                                                                phi_5397_ = (_e2484 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2491 = phi_5397_;
                                                            phi_5410_ = type_19(0u, 4u);
                                                            phi_5413_ = f64(2f);
                                                            loop {
                                                                let _e2503 = phi_5410_;
                                                                let _e2505 = phi_5413_;
                                                                local_20 = _e2505;
                                                                local_21 = _e2505;
                                                                local_22 = _e2505;
                                                                local_51 = _e2505;
                                                                local_52 = _e2505;
                                                                if (_e2503.member < _e2503.member_1) {
                                                                    phi_5411_ = type_19((_e2503.member + 1u), _e2503.member_1);
                                                                    phi_5436_ = type_19(1u, _e2503.member);
                                                                } else {
                                                                    phi_5411_ = _e2503;
                                                                    phi_5436_ = type_19(0u, type_19().member_1);
                                                                }
                                                                let _e2517 = phi_5411_;
                                                                let _e2519 = phi_5436_;
                                                                if (bitcast<i32>(_e2519.member) != 0i) {
                                                                    let _e2525 = local[_e2519.member_1];
                                                                    let _e2533 = (((_e2428 * _e2525[0]) + (_e2430 * _e2525[1])) + (_e2432 * _e2525[2]));
                                                                    let _e2535 = local_1[_e2519.member_1];
                                                                    let _e2543 = (((_e2428 * _e2535[0]) + (_e2430 * _e2535[1])) + (_e2432 * _e2535[2]));
                                                                    if (_e2533 < 0.0lf) {
                                                                        phi_5487_ = -(_e2533);
                                                                    } else {
                                                                        phi_5487_ = _e2533;
                                                                    }
                                                                    let _e2547 = phi_5487_;
                                                                    if (_e2543 < 0.0lf) {
                                                                        phi_5493_ = -(_e2543);
                                                                    } else {
                                                                        phi_5493_ = _e2543;
                                                                    }
                                                                    let _e2551 = phi_5493_;
                                                                    let _e2556 = (((((((((_e2190 + _e2192) + (_e2244 + _e2246)) + (_e2298 + _e2300)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2308 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2491) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2547 + _e2551) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2533 > _e2556) {
                                                                        if (_e2543 > _e2556) {
                                                                            phi_5507_ = false;
                                                                        } else {
                                                                            phi_5507_ = true;
                                                                        }
                                                                        let _e2560 = phi_5507_;
                                                                        phi_5508_ = _e2560;
                                                                    } else {
                                                                        phi_5508_ = true;
                                                                    }
                                                                    let _e2562 = phi_5508_;
                                                                    if _e2562 {
                                                                        if ((_e2533 + ((_e2543 - _e2533) * _e2319)) > _e2556) {
                                                                            if (_e2543 < _e2533) {
                                                                                let _e2571 = ((_e2533 - _e2543) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2571 {
                                                                                    let _e2579 = (((_e2533 - _e2556) / (_e2533 - _e2543)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2505 < _e2579) {
                                                                                        phi_5542_ = _e2505;
                                                                                    } else {
                                                                                        phi_5542_ = _e2579;
                                                                                    }
                                                                                    let _e2582 = phi_5542_;
                                                                                    phi_5543_ = _e2582;
                                                                                } else {
                                                                                    phi_5543_ = f64();
                                                                                }
                                                                                let _e2584 = phi_5543_;
                                                                                phi_5544_ = _e2584;
                                                                                phi_5545_ = _e2571;
                                                                            } else {
                                                                                phi_5544_ = _e2505;
                                                                                phi_5545_ = true;
                                                                            }
                                                                            let _e2586 = phi_5544_;
                                                                            let _e2588 = phi_5545_;
                                                                            if _e2588 {
                                                                                phi_5549_ = false;
                                                                            } else {
                                                                                phi_5549_ = true;
                                                                            }
                                                                            let _e2590 = phi_5549_;
                                                                            phi_5550_ = _e2586;
                                                                            phi_5551_ = _e2588;
                                                                            phi_5552_ = _e2590;
                                                                            phi_5553_ = false;
                                                                        } else {
                                                                            phi_5550_ = f64();
                                                                            phi_5551_ = false;
                                                                            phi_5552_ = false;
                                                                            phi_5553_ = true;
                                                                        }
                                                                        let _e2592 = phi_5550_;
                                                                        let _e2594 = phi_5551_;
                                                                        let _e2596 = phi_5552_;
                                                                        let _e2598 = phi_5553_;
                                                                        phi_5554_ = _e2592;
                                                                        phi_5555_ = _e2594;
                                                                        phi_5556_ = _e2596;
                                                                        phi_5557_ = _e2598;
                                                                    } else {
                                                                        phi_5554_ = _e2505;
                                                                        phi_5555_ = true;
                                                                        phi_5556_ = false;
                                                                        phi_5557_ = false;
                                                                    }
                                                                    let _e2600 = phi_5554_;
                                                                    let _e2602 = phi_5555_;
                                                                    let _e2604 = phi_5556_;
                                                                    let _e2606 = phi_5557_;
                                                                    phi_5414_ = _e2600;
                                                                    phi_5558_ = _e2602;
                                                                    phi_5559_ = false;
                                                                    phi_5560_ = _e2604;
                                                                    phi_5561_ = _e2606;
                                                                } else {
                                                                    phi_5414_ = f64();
                                                                    phi_5558_ = false;
                                                                    phi_5559_ = true;
                                                                    phi_5560_ = false;
                                                                    phi_5561_ = false;
                                                                }
                                                                let _e2608 = phi_5414_;
                                                                let _e2610 = phi_5558_;
                                                                let _e2612 = phi_5559_;
                                                                let _e2614 = phi_5560_;
                                                                let _e2616 = phi_5561_;
                                                                local_19 = _e2612;
                                                                local_49 = _e2614;
                                                                local_50 = _e2616;
                                                                continue;
                                                                continuing {
                                                                    phi_5410_ = _e2517;
                                                                    phi_5413_ = _e2608;
                                                                    break if !(_e2610);
                                                                }
                                                            }
                                                            let _e2619 = local_19;
                                                            if _e2619 {
                                                                let _e2621 = local_20;
                                                                let _e2622 = (_e2621 > _e1334.member_1);
                                                                if _e2622 {
                                                                    phi_5583_ = false;
                                                                    phi_5584_ = false;
                                                                    phi_5585_ = false;
                                                                } else {
                                                                    let _e2624 = local_21;
                                                                    if (_e2624 > _e2319) {
                                                                        let _e2627 = local_22;
                                                                        let _e2630 = ((_e2627 - _e2319) < f64(0.00000000023283064f));
                                                                        if _e2630 {
                                                                            phi_5579_ = false;
                                                                        } else {
                                                                            phi_5579_ = true;
                                                                        }
                                                                        let _e2632 = phi_5579_;
                                                                        phi_5580_ = _e2632;
                                                                        phi_5581_ = _e2630;
                                                                        phi_5582_ = false;
                                                                    } else {
                                                                        phi_5580_ = false;
                                                                        phi_5581_ = false;
                                                                        phi_5582_ = true;
                                                                    }
                                                                    let _e2634 = phi_5580_;
                                                                    let _e2636 = phi_5581_;
                                                                    let _e2638 = phi_5582_;
                                                                    phi_5583_ = _e2634;
                                                                    phi_5584_ = _e2636;
                                                                    phi_5585_ = _e2638;
                                                                }
                                                                let _e2640 = phi_5583_;
                                                                let _e2642 = phi_5584_;
                                                                let _e2644 = phi_5585_;
                                                                phi_5586_ = _e2640;
                                                                phi_5587_ = _e2622;
                                                                phi_5588_ = _e2642;
                                                                phi_5589_ = _e2644;
                                                                phi_5590_ = false;
                                                                phi_5591_ = false;
                                                            } else {
                                                                phi_5586_ = false;
                                                                phi_5587_ = false;
                                                                phi_5588_ = false;
                                                                phi_5589_ = false;
                                                                let _e4510 = local_49;
                                                                phi_5590_ = _e4510;
                                                                let _e4513 = local_50;
                                                                phi_5591_ = _e4513;
                                                            }
                                                            let _e2646 = phi_5586_;
                                                            let _e2648 = phi_5587_;
                                                            let _e2650 = phi_5588_;
                                                            let _e2652 = phi_5589_;
                                                            let _e2654 = phi_5590_;
                                                            let _e2656 = phi_5591_;
                                                            let _e4516 = local_51;
                                                            phi_5592_ = _e4516;
                                                            let _e4519 = local_52;
                                                            phi_5593_ = _e4519;
                                                            phi_5594_ = _e2646;
                                                            phi_5595_ = _e2648;
                                                            phi_5596_ = _e2650;
                                                            phi_5597_ = _e2652;
                                                            phi_5598_ = _e2654;
                                                            phi_5599_ = _e2656;
                                                            phi_5600_ = false;
                                                        } else {
                                                            phi_5592_ = f64();
                                                            phi_5593_ = f64();
                                                            phi_5594_ = false;
                                                            phi_5595_ = false;
                                                            phi_5596_ = false;
                                                            phi_5597_ = false;
                                                            phi_5598_ = false;
                                                            phi_5599_ = false;
                                                            phi_5600_ = true;
                                                        }
                                                        let _e2658 = phi_5592_;
                                                        let _e2660 = phi_5593_;
                                                        let _e2662 = phi_5594_;
                                                        let _e2664 = phi_5595_;
                                                        let _e2666 = phi_5596_;
                                                        let _e2668 = phi_5597_;
                                                        let _e2670 = phi_5598_;
                                                        let _e2672 = phi_5599_;
                                                        let _e2674 = phi_5600_;
                                                        phi_5601_ = _e2658;
                                                        phi_5602_ = _e2660;
                                                        phi_5603_ = _e2662;
                                                        phi_5604_ = _e2664;
                                                        phi_5605_ = _e2666;
                                                        phi_5606_ = _e2668;
                                                        phi_5607_ = _e2670;
                                                        phi_5608_ = _e2672;
                                                        phi_5609_ = _e2674;
                                                        phi_5610_ = false;
                                                    } else {
                                                        phi_5601_ = f64();
                                                        phi_5602_ = f64();
                                                        phi_5603_ = false;
                                                        phi_5604_ = false;
                                                        phi_5605_ = false;
                                                        phi_5606_ = false;
                                                        phi_5607_ = false;
                                                        phi_5608_ = false;
                                                        phi_5609_ = false;
                                                        phi_5610_ = true;
                                                    }
                                                    let _e2676 = phi_5601_;
                                                    let _e2678 = phi_5602_;
                                                    let _e2680 = phi_5603_;
                                                    let _e2682 = phi_5604_;
                                                    let _e2684 = phi_5605_;
                                                    let _e2686 = phi_5606_;
                                                    let _e2688 = phi_5607_;
                                                    let _e2690 = phi_5608_;
                                                    let _e2692 = phi_5609_;
                                                    let _e2694 = phi_5610_;
                                                    phi_5611_ = _e2676;
                                                    phi_5147_ = _e2678;
                                                    phi_5612_ = _e2680;
                                                    phi_5613_ = _e2682;
                                                    phi_5614_ = _e2684;
                                                    phi_5615_ = false;
                                                    phi_5616_ = _e2686;
                                                    phi_5617_ = _e2688;
                                                    phi_5618_ = _e2690;
                                                    phi_5619_ = _e2692;
                                                    phi_5620_ = _e2694;
                                                } else {
                                                    phi_5611_ = f64();
                                                    phi_5147_ = f64();
                                                    phi_5612_ = false;
                                                    phi_5613_ = false;
                                                    phi_5614_ = false;
                                                    phi_5615_ = true;
                                                    phi_5616_ = false;
                                                    phi_5617_ = false;
                                                    phi_5618_ = false;
                                                    phi_5619_ = false;
                                                    phi_5620_ = false;
                                                }
                                                let _e2696 = phi_5611_;
                                                let _e2698 = phi_5147_;
                                                let _e2700 = phi_5612_;
                                                let _e2702 = phi_5613_;
                                                let _e2704 = phi_5614_;
                                                let _e2706 = phi_5615_;
                                                let _e2708 = phi_5616_;
                                                let _e2710 = phi_5617_;
                                                let _e2712 = phi_5618_;
                                                let _e2714 = phi_5619_;
                                                let _e2716 = phi_5620_;
                                                local_23 = _e2702;
                                                local_53 = _e2704;
                                                local_54 = _e2706;
                                                local_55 = _e2708;
                                                local_56 = _e2710;
                                                local_57 = _e2712;
                                                local_58 = _e2714;
                                                local_59 = _e2716;
                                                local_60 = _e2696;
                                                local_62 = _e2702;
                                                continue;
                                                continuing {
                                                    phi_5143_ = _e2331;
                                                    phi_5146_ = _e2698;
                                                    break if !(_e2700);
                                                }
                                            }
                                            let _e2719 = local_23;
                                            if _e2719 {
                                                phi_5625_ = type_40(0u, type_40().member_1);
                                                phi_5626_ = false;
                                                phi_5627_ = false;
                                                phi_5628_ = false;
                                                phi_5629_ = false;
                                                phi_5630_ = false;
                                                phi_5631_ = false;
                                                phi_5632_ = false;
                                            } else {
                                                phi_5625_ = type_40();
                                                let _e4552 = local_53;
                                                phi_5626_ = _e4552;
                                                let _e4555 = local_54;
                                                phi_5627_ = _e4555;
                                                let _e4558 = local_55;
                                                phi_5628_ = _e4558;
                                                let _e4561 = local_56;
                                                phi_5629_ = _e4561;
                                                let _e4564 = local_57;
                                                phi_5630_ = _e4564;
                                                let _e4567 = local_58;
                                                phi_5631_ = _e4567;
                                                let _e4570 = local_59;
                                                phi_5632_ = _e4570;
                                            }
                                            let _e2723 = phi_5625_;
                                            let _e2725 = phi_5626_;
                                            let _e2727 = phi_5627_;
                                            let _e2729 = phi_5628_;
                                            let _e2731 = phi_5629_;
                                            let _e2733 = phi_5630_;
                                            let _e2735 = phi_5631_;
                                            let _e2737 = phi_5632_;
                                            if _e2725 {
                                                let _e4573 = local_60;
                                                phi_5636_ = _e4573;
                                                phi_5637_ = true;
                                                phi_5638_ = false;
                                                phi_5639_ = false;
                                                phi_5640_ = false;
                                                phi_5641_ = false;
                                                phi_5642_ = false;
                                                phi_5643_ = false;
                                            } else {
                                                let _e4575 = local_61;
                                                phi_5636_ = _e4575;
                                                phi_5637_ = _e2727;
                                                phi_5638_ = _e2729;
                                                phi_5639_ = _e2731;
                                                phi_5640_ = _e2733;
                                                let _e4582 = local_62;
                                                phi_5641_ = _e4582;
                                                phi_5642_ = _e2735;
                                                phi_5643_ = _e2737;
                                            }
                                            let _e2739 = phi_5636_;
                                            let _e2741 = phi_5637_;
                                            let _e2743 = phi_5638_;
                                            let _e2745 = phi_5639_;
                                            let _e2747 = phi_5640_;
                                            let _e2749 = phi_5641_;
                                            let _e2751 = phi_5642_;
                                            let _e2753 = phi_5643_;
                                            if _e2741 {
                                                phi_5648_ = type_40(1u, _e2739);
                                                phi_5649_ = false;
                                                phi_5650_ = false;
                                                phi_5651_ = false;
                                                phi_5652_ = false;
                                                phi_5653_ = false;
                                                phi_5654_ = false;
                                            } else {
                                                phi_5648_ = type_40();
                                                phi_5649_ = _e2743;
                                                phi_5650_ = _e2745;
                                                phi_5651_ = _e2747;
                                                phi_5652_ = _e2749;
                                                phi_5653_ = _e2751;
                                                phi_5654_ = _e2753;
                                            }
                                            let _e2756 = phi_5648_;
                                            let _e2758 = phi_5649_;
                                            let _e2760 = phi_5650_;
                                            let _e2762 = phi_5651_;
                                            let _e2764 = phi_5652_;
                                            let _e2766 = phi_5653_;
                                            let _e2768 = phi_5654_;
                                            if _e2758 {
                                                let _e2770 = local_24;
                                                phi_5659_ = type_40(1u, _e2770);
                                                phi_5660_ = false;
                                                phi_5661_ = false;
                                                phi_5662_ = true;
                                                phi_5663_ = false;
                                                phi_5664_ = false;
                                            } else {
                                                phi_5659_ = _e2723;
                                                phi_5660_ = _e2760;
                                                phi_5661_ = _e2762;
                                                phi_5662_ = _e2764;
                                                phi_5663_ = _e2766;
                                                phi_5664_ = _e2768;
                                            }
                                            let _e2773 = phi_5659_;
                                            let _e2775 = phi_5660_;
                                            let _e2777 = phi_5661_;
                                            let _e2779 = phi_5662_;
                                            let _e2781 = phi_5663_;
                                            let _e2783 = phi_5664_;
                                            if _e2775 {
                                                let _e2785 = local_25;
                                                phi_5669_ = type_40(1u, _e2785);
                                                phi_5670_ = false;
                                                phi_5671_ = false;
                                                phi_5672_ = false;
                                                phi_5673_ = false;
                                            } else {
                                                phi_5669_ = type_40();
                                                phi_5670_ = _e2777;
                                                phi_5671_ = _e2779;
                                                phi_5672_ = _e2781;
                                                phi_5673_ = _e2783;
                                            }
                                            let _e2788 = phi_5669_;
                                            let _e2790 = phi_5670_;
                                            let _e2792 = phi_5671_;
                                            let _e2794 = phi_5672_;
                                            let _e2796 = phi_5673_;
                                            if _e2790 {
                                                let _e2798 = local_26;
                                                phi_5678_ = type_40(1u, _e2798);
                                                phi_5679_ = true;
                                                phi_5680_ = false;
                                                phi_5681_ = false;
                                                phi_5682_ = false;
                                            } else {
                                                phi_5678_ = _e2788;
                                                phi_5679_ = _e2775;
                                                phi_5680_ = _e2792;
                                                phi_5681_ = _e2794;
                                                phi_5682_ = _e2796;
                                            }
                                            let _e2801 = phi_5678_;
                                            let _e2803 = phi_5679_;
                                            let _e2805 = phi_5680_;
                                            let _e2807 = phi_5681_;
                                            let _e2809 = phi_5682_;
                                            if _e2803 {
                                                phi_5686_ = _e2801;
                                                phi_5687_ = true;
                                                phi_5688_ = false;
                                                phi_5689_ = false;
                                            } else {
                                                phi_5686_ = _e2773;
                                                phi_5687_ = _e2805;
                                                phi_5688_ = _e2807;
                                                phi_5689_ = _e2809;
                                            }
                                            let _e2811 = phi_5686_;
                                            let _e2813 = phi_5687_;
                                            let _e2815 = phi_5688_;
                                            let _e2817 = phi_5689_;
                                            if _e2813 {
                                                phi_5693_ = false;
                                                phi_5694_ = false;
                                            } else {
                                                phi_5693_ = _e2815;
                                                phi_5694_ = _e2817;
                                            }
                                            let _e2819 = phi_5693_;
                                            let _e2821 = phi_5694_;
                                            if _e2819 {
                                                phi_5698_ = false;
                                                phi_5699_ = false;
                                            } else {
                                                phi_5698_ = _e2821;
                                                phi_5699_ = _e2813;
                                            }
                                            let _e2823 = phi_5698_;
                                            let _e2825 = phi_5699_;
                                            if _e2823 {
                                                phi_5703_ = true;
                                                phi_5704_ = false;
                                            } else {
                                                phi_5703_ = _e2819;
                                                phi_5704_ = _e2825;
                                            }
                                            let _e2827 = phi_5703_;
                                            let _e2829 = phi_5704_;
                                            if _e2827 {
                                                let _e2831 = local_27;
                                                phi_5709_ = type_40(1u, _e2831);
                                                phi_5710_ = true;
                                            } else {
                                                phi_5709_ = _e2811;
                                                phi_5710_ = _e2829;
                                            }
                                            let _e2834 = phi_5709_;
                                            let _e2836 = phi_5710_;
                                            if _e2836 {
                                                phi_5714_ = _e2834;
                                            } else {
                                                phi_5714_ = _e2756;
                                            }
                                            let _e2838 = phi_5714_;
                                            let _e2841 = (_e2838.member != 0u);
                                            if _e2841 {
                                                phi_5721_ = false;
                                            } else {
                                                phi_5721_ = true;
                                            }
                                            let _e2843 = phi_5721_;
                                            phi_5722_ = _e2838.member_1;
                                            phi_5723_ = _e2843;
                                            phi_5724_ = _e2841;
                                            phi_5725_ = false;
                                        } else {
                                            phi_5722_ = f64();
                                            phi_5723_ = false;
                                            phi_5724_ = false;
                                            phi_5725_ = true;
                                        }
                                        let _e2845 = phi_5722_;
                                        let _e2847 = phi_5723_;
                                        let _e2849 = phi_5724_;
                                        let _e2851 = phi_5725_;
                                        phi_5726_ = _e2845;
                                        phi_5727_ = _e2847;
                                        phi_5728_ = _e2849;
                                        phi_5729_ = _e2851;
                                    }
                                    let _e2853 = phi_5726_;
                                    let _e2855 = phi_5727_;
                                    let _e2857 = phi_5728_;
                                    let _e2859 = phi_5729_;
                                    phi_5730_ = _e2853;
                                    phi_5731_ = _e2061;
                                    phi_5732_ = _e2855;
                                    phi_5733_ = _e2857;
                                    phi_5734_ = _e2859;
                                }
                                let _e2861 = phi_5730_;
                                let _e2863 = phi_5731_;
                                let _e2865 = phi_5732_;
                                let _e2867 = phi_5733_;
                                let _e2869 = phi_5734_;
                                if _e2863 {
                                    phi_5738_ = true;
                                    phi_5739_ = false;
                                    phi_5740_ = false;
                                } else {
                                    phi_5738_ = _e2865;
                                    phi_5739_ = _e2867;
                                    phi_5740_ = _e2869;
                                }
                                let _e2871 = phi_5738_;
                                let _e2873 = phi_5739_;
                                let _e2875 = phi_5740_;
                                phi_5741_ = _e2861;
                                phi_5742_ = _e1334;
                                phi_5743_ = _e2871;
                                phi_5744_ = false;
                                phi_5745_ = _e2873;
                                phi_5746_ = _e2875;
                            } else {
                                phi_5741_ = f64();
                                phi_5742_ = type_41();
                                phi_5743_ = false;
                                phi_5744_ = true;
                                phi_5745_ = false;
                                phi_5746_ = false;
                            }
                            let _e2877 = phi_5741_;
                            let _e2879 = phi_5742_;
                            let _e2881 = phi_5743_;
                            let _e2883 = phi_5744_;
                            let _e2885 = phi_5745_;
                            let _e2887 = phi_5746_;
                            local_28 = _e2883;
                            local_63 = _e2885;
                            local_64 = _e2887;
                            local_29 = _e2877;
                            local_30 = _e2879;
                            continue;
                            continuing {
                                phi_3182_ = _e1021;
                                break if !(_e2881);
                            }
                        }
                        let _e2890 = local_28;
                        if _e2890 {
                            phi_5751_ = type_40(0u, type_40().member_1);
                            phi_5752_ = false;
                            phi_5753_ = false;
                        } else {
                            phi_5751_ = type_40();
                            let _e4652 = local_63;
                            phi_5752_ = _e4652;
                            let _e4655 = local_64;
                            phi_5753_ = _e4655;
                        }
                        let _e2894 = phi_5751_;
                        let _e2896 = phi_5752_;
                        let _e2898 = phi_5753_;
                        if _e2896 {
                            let _e2900 = local_29;
                            phi_5758_ = type_40(2u, _e2900);
                            phi_5759_ = false;
                        } else {
                            phi_5758_ = type_40();
                            phi_5759_ = _e2898;
                        }
                        let _e2903 = phi_5758_;
                        let _e2905 = phi_5759_;
                        if _e2905 {
                            let _e2907 = local_30;
                            phi_5765_ = type_40(1u, _e2907.member);
                            phi_5766_ = true;
                        } else {
                            phi_5765_ = _e2903;
                            phi_5766_ = _e2896;
                        }
                        let _e2911 = phi_5765_;
                        let _e2913 = phi_5766_;
                        if _e2913 {
                            phi_5770_ = _e2911;
                        } else {
                            phi_5770_ = _e2894;
                        }
                        let _e2915 = phi_5770_;
                        phi_5774_ = _e2915;
                    }
                    let _e4060 = phi_5774_;
                    phi_5775_ = _e4060;
                }
                let _e4064 = phi_5775_;
                switch bitcast<i32>(_e4064.member) {
                    case 0: {
                        phi_5788_ = type_30(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4070 = function_(_e4064.member_1);
                        phi_5788_ = type_30(0u, _e4070, true);
                        break;
                    }
                    case 2: {
                        let _e4068 = function_(_e4064.member_1);
                        phi_5788_ = type_30(1u, _e4068, true);
                        break;
                    }
                    default: {
                        phi_5788_ = type_30();
                        break;
                    }
                }
                let _e4073 = phi_5788_;
                if _e4073.member_2 {
                    let _e4080 = (_e4073.member_1[1] >> bitcast<u32>(20i));
                    if (_e4080 <= 896u) {
                        phi_5811_ = 0u;
                    } else {
                        phi_5811_ = ((((_e4080 - 896u) << bitcast<u32>(23i)) | ((_e4073.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4073.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4095 = phi_5811_;
                    let _e4097 = atomicMin((&earliest.member[0u]), _e4095);
                }
                phi_5815_ = type_29(_e168, _e4073.member, _e174, _e177, _e4073.member_1);
                phi_5816_ = _e4073.member_2;
            } else {
                phi_5815_ = type_29(_e168, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_5816_ = false;
            }
            let _e4099 = phi_5815_;
            let _e4101 = phi_5816_;
            let _e4103 = params.member.member_1;
            if ((_e4103 & 16u) != 0u) {
                if (_e101 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4101 {
                    let _e4109 = atomicAdd((&counters[0u]), 1u);
                    phi_5834_ = _e4109;
                } else {
                    phi_5834_ = 0u;
                }
                let _e4111 = phi_5834_;
                workgroupBarrier();
                if (_e101 == 0u) {
                    let _e4114 = atomicLoad((&counters[0u]));
                    if (_e4114 > 0u) {
                        let _e4117 = atomicAdd((&contacts.member[0u]), _e4114);
                        atomicStore((&counters[1u]), _e4117);
                    }
                }
                workgroupBarrier();
                let _e4120 = atomicLoad((&counters[1u]));
                let _e4121 = (_e4120 + _e4111);
                if _e4101 {
                    let _e4123 = params.member.member_16;
                    if (_e4121 < _e4123) {
                        let _e4125 = (6u * _e4121);
                        atomicStore((&contacts.member[(4u + _e4125)]), _e4099.member);
                        atomicStore((&contacts.member[(_e4125 + 5u)]), _e4099.member_1);
                        atomicStore((&contacts.member[(_e4125 + 6u)]), _e4099.member_2);
                        atomicStore((&contacts.member[(_e4125 + 7u)]), _e4099.member_3);
                        atomicStore((&contacts.member[(_e4125 + 8u)]), _e4099.member_4[0]);
                        atomicStore((&contacts.member[(_e4125 + 9u)]), _e4099.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_266_ = _e156;
            break if !(_e162);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
