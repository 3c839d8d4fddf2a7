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

struct type_31 {
    member: array<array<f64, 3>>,
}

struct type_32 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_34 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_35 {
    member: f64,
    member_1: f64,
}

struct type_40 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_41 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_42 {
    member: u32,
    member_1: f64,
}

struct type_43 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_46 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
@group(0) @binding(0) 
var<storage> params: type_28;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> positions: type_31;
@group(0) @binding(3) 
var<storage> elements: type_24;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_46;

fn function_(param: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_6446_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_6446_ = param_2;
    } else {
        phi_6446_ = param_1;
    }
    let _e26 = phi_6446_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_6010_: bool;
    var phi_6011_: bool;
    var phi_6012_: bool;
    var phi_6013_: bool;
    var phi_6017_: bool;
    var phi_5990_: bool;
    var phi_5991_: bool;
    var phi_5992_: bool;
    var phi_5993_: bool;
    var phi_5994_: bool;
    var phi_5995_: bool;
    var phi_5999_: bool;
    var phi_6018_: bool;
    var phi_6048_: array<f64, 3>;
    var phi_6049_: bool;
    var phi_6050_: array<f64, 3>;
    var phi_6051_: bool;
    var phi_6297_: f64;
    var phi_6299_: f64;
    var phi_6341_: f64;
    var phi_6343_: f64;
    var phi_6391_: f64;
    var phi_6393_: f64;
    var phi_6102_: f64;
    var phi_6104_: f64;
    var phi_6152_: f64;
    var phi_6154_: f64;
    var phi_6199_: f64;
    var phi_6201_: f64;
    var phi_6252_: f64;
    var phi_6254_: f64;
    var phi_6408_: array<array<f64, 3>, 4>;
    var phi_6416_: array<f64, 3>;

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
                    phi_5990_ = (_e78 <= _e70);
                    phi_5991_ = false;
                } else {
                    phi_5990_ = bool();
                    phi_5991_ = true;
                }
                let _e99 = phi_5990_;
                let _e101 = phi_5991_;
                phi_5992_ = _e99;
                phi_5993_ = _e101;
            } else {
                phi_5992_ = bool();
                phi_5993_ = true;
            }
            let _e103 = phi_5992_;
            let _e105 = phi_5993_;
            phi_5994_ = _e103;
            phi_5995_ = _e105;
        } else {
            phi_5994_ = bool();
            phi_5995_ = true;
        }
        let _e107 = phi_5994_;
        let _e109 = phi_5995_;
        if _e109 {
            phi_5999_ = false;
        } else {
            phi_5999_ = _e107;
        }
        let _e111 = phi_5999_;
        phi_6018_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_6010_ = ((_e74 + _e78) <= _e70);
                phi_6011_ = false;
            } else {
                phi_6010_ = bool();
                phi_6011_ = true;
            }
            let _e85 = phi_6010_;
            let _e87 = phi_6011_;
            phi_6012_ = _e85;
            phi_6013_ = _e87;
        } else {
            phi_6012_ = bool();
            phi_6013_ = true;
        }
        let _e89 = phi_6012_;
        let _e91 = phi_6013_;
        if _e91 {
            phi_6017_ = false;
        } else {
            phi_6017_ = _e89;
        }
        let _e93 = phi_6017_;
        phi_6018_ = _e93;
    }
    let _e113 = phi_6018_;
    if (_e68 > _e69) {
        if _e113 {
            phi_6048_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_6049_ = false;
        } else {
            phi_6048_ = array<f64, 3>();
            phi_6049_ = true;
        }
        let _e138 = phi_6048_;
        let _e140 = phi_6049_;
        phi_6050_ = _e138;
        phi_6051_ = _e140;
    } else {
        phi_6050_ = array<f64, 3>();
        phi_6051_ = true;
    }
    let _e142 = phi_6050_;
    let _e144 = phi_6051_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_6102_ = _e307;
                } else {
                    phi_6102_ = f64(1f);
                }
                let _e315 = phi_6102_;
                phi_6104_ = _e315;
            } else {
                phi_6104_ = f64(0f);
            }
            let _e317 = phi_6104_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_6152_ = _e353;
                } else {
                    phi_6152_ = f64(1f);
                }
                let _e361 = phi_6152_;
                phi_6154_ = _e361;
            } else {
                phi_6154_ = f64(0f);
            }
            let _e363 = phi_6154_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_6199_ = _e396;
                } else {
                    phi_6199_ = f64(1f);
                }
                let _e404 = phi_6199_;
                phi_6201_ = _e404;
            } else {
                phi_6201_ = f64(0f);
            }
            let _e406 = phi_6201_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_6252_ = _e445;
                } else {
                    phi_6252_ = f64(1f);
                }
                let _e453 = phi_6252_;
                phi_6254_ = _e453;
            } else {
                phi_6254_ = f64(0f);
            }
            let _e455 = phi_6254_;
            phi_6408_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_6297_ = _e174;
                } else {
                    phi_6297_ = f64(1f);
                }
                let _e182 = phi_6297_;
                phi_6299_ = _e182;
            } else {
                phi_6299_ = f64(0f);
            }
            let _e184 = phi_6299_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_6341_ = _e214;
                } else {
                    phi_6341_ = f64(1f);
                }
                let _e222 = phi_6341_;
                phi_6343_ = _e222;
            } else {
                phi_6343_ = f64(0f);
            }
            let _e224 = phi_6343_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_6391_ = _e260;
                } else {
                    phi_6391_ = f64(1f);
                }
                let _e268 = phi_6391_;
                phi_6393_ = _e268;
            } else {
                phi_6393_ = f64(0f);
            }
            let _e270 = phi_6393_;
            phi_6408_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_6408_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_6416_ = _e475;
    } else {
        phi_6416_ = _e142;
    }
    let _e477 = phi_6416_;
    return _e477;
}

fn function_3(param_7: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param_7[0]), f64(param_7[1]), f64(param_7[2]));
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f64, 3>, 4>;
    var local_1: array<array<f64, 3>, 4>;
    var local_2: type_34;
    var local_3: type_34;
    var local_4: type_34;
    var local_5: array<type_35, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: array<f64, 4>;
    var local_9: array<array<f64, 3>, 4>;
    var local_10: array<array<f64, 3>, 4>;
    var local_11: array<f32, 3>;
    var local_12: type_40;
    var phi_229_: u32;
    var phi_245_: u32;
    var phi_266_: u32;
    var phi_267_: u32;
    var phi_270_: type_9;
    var phi_271_: type_9;
    var phi_294_: type_9;
    var phi_552_: type_41;
    var phi_921_: f64;
    var phi_928_: f64;
    var phi_933_: f64;
    var phi_940_: f64;
    var phi_945_: f64;
    var phi_958_: f64;
    var phi_965_: f64;
    var phi_970_: f64;
    var phi_977_: f64;
    var phi_982_: f64;
    var phi_987_: f64;
    var phi_1004_: f64;
    var phi_1011_: f64;
    var phi_1016_: f64;
    var phi_1023_: f64;
    var phi_1028_: f64;
    var phi_1042_: f64;
    var phi_1049_: f64;
    var phi_1054_: f64;
    var phi_1061_: f64;
    var phi_1066_: f64;
    var phi_1071_: f64;
    var phi_1088_: f64;
    var phi_1095_: f64;
    var phi_1100_: f64;
    var phi_1107_: f64;
    var phi_1112_: f64;
    var phi_1126_: f64;
    var phi_1133_: f64;
    var phi_1138_: f64;
    var phi_1145_: f64;
    var phi_1150_: f64;
    var phi_1155_: f64;
    var phi_1192_: f64;
    var phi_1198_: f64;
    var phi_1205_: f64;
    var phi_1212_: f64;
    var phi_1218_: f64;
    var phi_1225_: f64;
    var phi_1231_: f64;
    var phi_1237_: f64;
    var phi_1243_: f64;
    var phi_1250_: f64;
    var phi_1257_: f64;
    var phi_1285_: f64;
    var phi_1290_: f64;
    var phi_1295_: f64;
    var phi_1300_: f64;
    var phi_1305_: f64;
    var phi_1310_: f64;
    var phi_1321_: f64;
    var phi_2904_: f64;
    var phi_2910_: f64;
    var phi_2915_: f64;
    var phi_2921_: f64;
    var phi_2927_: f64;
    var phi_2932_: f64;
    var phi_2937_: f64;
    var phi_2947_: bool;
    var phi_2954_: f64;
    var phi_2962_: f64;
    var phi_3005_: type_16;
    var phi_3008_: f64;
    var phi_3029_: bool;
    var phi_3035_: type_17;
    var phi_3006_: type_16;
    var phi_3049_: type_17;
    var phi_3009_: f64;
    var local_13: f64;
    var phi_2998_: f64;
    var phi_3062_: f64;
    var phi_3068_: f64;
    var phi_3093_: type_9;
    var phi_3096_: u32;
    var phi_3094_: type_9;
    var phi_3119_: type_9;
    var phi_3163_: u32;
    var phi_3164_: u32;
    var phi_3097_: u32;
    var phi_3165_: u32;
    var phi_3185_: type_9;
    var phi_3186_: type_9;
    var phi_3209_: type_9;
    var phi_3263_: f64;
    var phi_3270_: f64;
    var phi_3282_: bool;
    var phi_3283_: bool;
    var phi_3284_: bool;
    var phi_3285_: bool;
    var phi_3289_: bool;
    var phi_3301_: type_43;
    var phi_3302_: type_43;
    var phi_3303_: bool;
    var phi_3304_: type_43;
    var phi_3305_: bool;
    var phi_3318_: f64;
    var phi_3331_: type_9;
    var phi_3334_: f64;
    var phi_3336_: f64;
    var phi_3338_: f64;
    var phi_3332_: type_9;
    var phi_3361_: type_9;
    var phi_3388_: f64;
    var phi_3389_: f64;
    var phi_3417_: f64;
    var phi_3433_: f64;
    var phi_3440_: bool;
    var phi_3441_: bool;
    var phi_3442_: bool;
    var phi_3448_: f64;
    var phi_3449_: f64;
    var phi_3450_: bool;
    var phi_3335_: f64;
    var phi_3337_: f64;
    var phi_3339_: f64;
    var phi_3451_: f64;
    var phi_3452_: bool;
    var phi_3453_: bool;
    var local_14: bool;
    var phi_3457_: f64;
    var phi_3458_: f64;
    var phi_3466_: type_9;
    var phi_3469_: f64;
    var phi_3467_: type_9;
    var phi_3492_: type_9;
    var phi_3535_: f64;
    var phi_3545_: f64;
    var phi_3555_: bool;
    var phi_3557_: bool;
    var phi_3562_: f64;
    var phi_3563_: bool;
    var phi_3564_: f64;
    var phi_3565_: bool;
    var phi_3566_: bool;
    var phi_3567_: bool;
    var phi_3568_: f64;
    var phi_3470_: f64;
    var phi_3569_: bool;
    var phi_3570_: bool;
    var phi_3571_: bool;
    var phi_3572_: bool;
    var local_15: bool;
    var phi_3576_: bool;
    var phi_3577_: bool;
    var phi_3581_: bool;
    var phi_3585_: f64;
    var phi_3586_: f64;
    var phi_3588_: type_43;
    var phi_3619_: f64;
    var phi_3626_: f64;
    var phi_3631_: f64;
    var phi_3638_: f64;
    var phi_3643_: f64;
    var phi_3656_: f64;
    var phi_3663_: f64;
    var phi_3668_: f64;
    var phi_3675_: f64;
    var phi_3680_: f64;
    var phi_3685_: f64;
    var phi_3744_: f64;
    var phi_3750_: f64;
    var phi_3755_: f64;
    var phi_3761_: f64;
    var phi_3766_: f64;
    var phi_3780_: f64;
    var phi_3786_: f64;
    var phi_3791_: f64;
    var phi_3797_: f64;
    var phi_3802_: f64;
    var phi_3828_: f64;
    var phi_3835_: f64;
    var phi_3840_: f64;
    var phi_3847_: f64;
    var phi_3852_: f64;
    var phi_3865_: f64;
    var phi_3872_: f64;
    var phi_3877_: f64;
    var phi_3884_: f64;
    var phi_3889_: f64;
    var phi_3894_: f64;
    var phi_3953_: f64;
    var phi_3959_: f64;
    var phi_3964_: f64;
    var phi_3970_: f64;
    var phi_3975_: f64;
    var phi_3989_: f64;
    var phi_3995_: f64;
    var phi_4000_: f64;
    var phi_4006_: f64;
    var phi_4011_: f64;
    var phi_4037_: f64;
    var phi_4044_: f64;
    var phi_4049_: f64;
    var phi_4056_: f64;
    var phi_4061_: f64;
    var phi_4074_: f64;
    var phi_4081_: f64;
    var phi_4086_: f64;
    var phi_4093_: f64;
    var phi_4098_: f64;
    var phi_4103_: f64;
    var phi_4162_: f64;
    var phi_4168_: f64;
    var phi_4173_: f64;
    var phi_4179_: f64;
    var phi_4184_: f64;
    var phi_4198_: f64;
    var phi_4204_: f64;
    var phi_4209_: f64;
    var phi_4215_: f64;
    var phi_4220_: f64;
    var phi_4269_: f64;
    var phi_4275_: f64;
    var phi_4303_: f64;
    var phi_4309_: f64;
    var phi_4314_: u32;
    var phi_4315_: u32;
    var phi_4285_: f64;
    var phi_4291_: f64;
    var phi_4296_: u32;
    var phi_4297_: u32;
    var phi_4316_: u32;
    var phi_4317_: u32;
    var phi_4388_: f64;
    var phi_4400_: f64;
    var phi_4539_: f64;
    var phi_4545_: f64;
    var phi_4552_: f64;
    var phi_4596_: type_9;
    var phi_4599_: bool;
    var phi_4597_: type_9;
    var phi_4622_: type_9;
    var phi_4649_: bool;
    var phi_4650_: bool;
    var phi_4600_: bool;
    var phi_4651_: bool;
    var phi_4652_: bool;
    var local_16: bool;
    var phi_4656_: bool;
    var local_17: bool;
    var phi_4663_: u32;
    var phi_4664_: u32;
    var phi_4665_: bool;
    var phi_4666_: u32;
    var phi_4667_: u32;
    var phi_4668_: bool;
    var phi_4672_: u32;
    var phi_4693_: bool;
    var phi_4694_: bool;
    var phi_4695_: bool;
    var phi_4892_: f64;
    var phi_4899_: f64;
    var phi_4904_: f64;
    var phi_4911_: f64;
    var phi_4916_: f64;
    var phi_4929_: f64;
    var phi_4936_: f64;
    var phi_4941_: f64;
    var phi_4948_: f64;
    var phi_4953_: f64;
    var phi_4958_: f64;
    var phi_4975_: f64;
    var phi_4982_: f64;
    var phi_4987_: f64;
    var phi_4994_: f64;
    var phi_4999_: f64;
    var phi_5013_: f64;
    var phi_5020_: f64;
    var phi_5025_: f64;
    var phi_5032_: f64;
    var phi_5037_: f64;
    var phi_5042_: f64;
    var phi_5059_: f64;
    var phi_5066_: f64;
    var phi_5071_: f64;
    var phi_5078_: f64;
    var phi_5083_: f64;
    var phi_5097_: f64;
    var phi_5104_: f64;
    var phi_5109_: f64;
    var phi_5116_: f64;
    var phi_5121_: f64;
    var phi_5126_: f64;
    var phi_5146_: type_9;
    var phi_5149_: f64;
    var phi_5147_: type_9;
    var phi_5172_: type_9;
    var phi_5283_: f64;
    var phi_5290_: f64;
    var phi_5298_: f64;
    var phi_5343_: type_16;
    var phi_5346_: f64;
    var phi_5367_: bool;
    var phi_5373_: type_17;
    var phi_5344_: type_16;
    var phi_5387_: type_17;
    var phi_5347_: f64;
    var local_18: f64;
    var phi_5336_: f64;
    var phi_5400_: f64;
    var phi_5413_: type_9;
    var phi_5416_: f64;
    var phi_5414_: type_9;
    var phi_5439_: type_9;
    var phi_5490_: f64;
    var phi_5496_: f64;
    var phi_5510_: bool;
    var phi_5511_: bool;
    var phi_5545_: f64;
    var phi_5546_: f64;
    var phi_5547_: f64;
    var phi_5548_: bool;
    var phi_5552_: bool;
    var phi_5553_: f64;
    var phi_5554_: bool;
    var phi_5555_: bool;
    var phi_5556_: bool;
    var phi_5557_: f64;
    var phi_5558_: bool;
    var phi_5559_: bool;
    var phi_5560_: bool;
    var phi_5417_: f64;
    var phi_5561_: bool;
    var phi_5562_: bool;
    var phi_5563_: bool;
    var phi_5564_: bool;
    var local_19: bool;
    var local_20: f64;
    var local_21: f64;
    var local_22: f64;
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
    var phi_5592_: bool;
    var phi_5593_: bool;
    var phi_5594_: bool;
    var phi_5595_: f64;
    var phi_5596_: f64;
    var phi_5597_: bool;
    var phi_5598_: bool;
    var phi_5599_: bool;
    var phi_5600_: bool;
    var phi_5601_: bool;
    var phi_5602_: bool;
    var phi_5603_: bool;
    var phi_5604_: f64;
    var phi_5605_: f64;
    var phi_5606_: bool;
    var phi_5607_: bool;
    var phi_5608_: bool;
    var phi_5609_: bool;
    var phi_5610_: bool;
    var phi_5611_: bool;
    var phi_5612_: bool;
    var phi_5613_: bool;
    var phi_5614_: f64;
    var phi_5150_: f64;
    var phi_5615_: bool;
    var phi_5616_: bool;
    var phi_5617_: bool;
    var phi_5618_: bool;
    var phi_5619_: bool;
    var phi_5620_: bool;
    var phi_5621_: bool;
    var phi_5622_: bool;
    var phi_5623_: bool;
    var local_23: bool;
    var phi_5628_: type_42;
    var phi_5629_: bool;
    var phi_5630_: bool;
    var phi_5631_: bool;
    var phi_5632_: bool;
    var phi_5633_: bool;
    var phi_5634_: bool;
    var phi_5635_: bool;
    var phi_5639_: f64;
    var phi_5640_: bool;
    var phi_5641_: bool;
    var phi_5642_: bool;
    var phi_5643_: bool;
    var phi_5644_: bool;
    var phi_5645_: bool;
    var phi_5646_: bool;
    var phi_5651_: type_42;
    var phi_5652_: bool;
    var phi_5653_: bool;
    var phi_5654_: bool;
    var phi_5655_: bool;
    var phi_5656_: bool;
    var phi_5657_: bool;
    var local_24: f64;
    var phi_5662_: type_42;
    var phi_5663_: bool;
    var phi_5664_: bool;
    var phi_5665_: bool;
    var phi_5666_: bool;
    var phi_5667_: bool;
    var local_25: f64;
    var phi_5672_: type_42;
    var phi_5673_: bool;
    var phi_5674_: bool;
    var phi_5675_: bool;
    var phi_5676_: bool;
    var local_26: f64;
    var phi_5681_: type_42;
    var phi_5682_: bool;
    var phi_5683_: bool;
    var phi_5684_: bool;
    var phi_5685_: bool;
    var phi_5689_: type_42;
    var phi_5690_: bool;
    var phi_5691_: bool;
    var phi_5692_: bool;
    var phi_5696_: bool;
    var phi_5697_: bool;
    var phi_5701_: bool;
    var phi_5702_: bool;
    var phi_5706_: bool;
    var phi_5707_: bool;
    var local_27: f64;
    var phi_5712_: type_42;
    var phi_5713_: bool;
    var phi_5717_: type_42;
    var phi_5724_: bool;
    var phi_5725_: f64;
    var phi_5726_: bool;
    var phi_5727_: bool;
    var phi_5728_: bool;
    var phi_5729_: f64;
    var phi_5730_: bool;
    var phi_5731_: bool;
    var phi_5732_: bool;
    var phi_5733_: f64;
    var phi_5734_: bool;
    var phi_5735_: bool;
    var phi_5736_: bool;
    var phi_5737_: bool;
    var phi_5741_: bool;
    var phi_5742_: bool;
    var phi_5743_: bool;
    var phi_5744_: f64;
    var phi_5745_: type_43;
    var phi_5746_: bool;
    var phi_5747_: bool;
    var phi_5748_: bool;
    var phi_5749_: bool;
    var local_28: bool;
    var phi_5754_: type_42;
    var phi_5755_: bool;
    var phi_5756_: bool;
    var local_29: f64;
    var phi_5761_: type_42;
    var phi_5762_: bool;
    var local_30: type_43;
    var phi_5768_: type_42;
    var phi_5769_: bool;
    var phi_5773_: type_42;
    var phi_1524_: f64;
    var phi_1531_: f64;
    var phi_1536_: f64;
    var phi_1543_: f64;
    var phi_1548_: f64;
    var phi_1561_: f64;
    var phi_1568_: f64;
    var phi_1573_: f64;
    var phi_1580_: f64;
    var phi_1585_: f64;
    var phi_1590_: f64;
    var phi_1607_: f64;
    var phi_1614_: f64;
    var phi_1619_: f64;
    var phi_1626_: f64;
    var phi_1631_: f64;
    var phi_1645_: f64;
    var phi_1652_: f64;
    var phi_1657_: f64;
    var phi_1664_: f64;
    var phi_1669_: f64;
    var phi_1674_: f64;
    var phi_1691_: f64;
    var phi_1698_: f64;
    var phi_1703_: f64;
    var phi_1710_: f64;
    var phi_1715_: f64;
    var phi_1729_: f64;
    var phi_1736_: f64;
    var phi_1741_: f64;
    var phi_1748_: f64;
    var phi_1753_: f64;
    var phi_1758_: f64;
    var phi_1778_: type_9;
    var phi_1781_: f64;
    var phi_1779_: type_9;
    var phi_1804_: type_9;
    var phi_1915_: f64;
    var phi_1922_: f64;
    var phi_1930_: f64;
    var phi_1975_: type_16;
    var phi_1978_: f64;
    var phi_1999_: bool;
    var phi_2005_: type_17;
    var phi_1976_: type_16;
    var phi_2019_: type_17;
    var phi_1979_: f64;
    var local_31: f64;
    var phi_1968_: f64;
    var phi_2032_: f64;
    var phi_2045_: type_9;
    var phi_2048_: f64;
    var phi_2046_: type_9;
    var phi_2071_: type_9;
    var phi_2122_: f64;
    var phi_2128_: f64;
    var phi_2142_: bool;
    var phi_2143_: bool;
    var phi_2177_: f64;
    var phi_2178_: f64;
    var phi_2179_: f64;
    var phi_2180_: bool;
    var phi_2184_: bool;
    var phi_2185_: f64;
    var phi_2186_: bool;
    var phi_2187_: bool;
    var phi_2188_: bool;
    var phi_2189_: f64;
    var phi_2190_: bool;
    var phi_2191_: bool;
    var phi_2192_: bool;
    var phi_2049_: f64;
    var phi_2193_: bool;
    var phi_2194_: bool;
    var phi_2195_: bool;
    var phi_2196_: bool;
    var local_32: bool;
    var local_33: f64;
    var local_34: f64;
    var local_35: f64;
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
    var phi_2224_: bool;
    var phi_2225_: bool;
    var phi_2226_: bool;
    var phi_2227_: f64;
    var phi_2228_: f64;
    var phi_2229_: bool;
    var phi_2230_: bool;
    var phi_2231_: bool;
    var phi_2232_: bool;
    var phi_2233_: bool;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2236_: f64;
    var phi_2237_: f64;
    var phi_2238_: bool;
    var phi_2239_: bool;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2244_: bool;
    var phi_2245_: bool;
    var phi_2246_: f64;
    var phi_1782_: f64;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_2254_: bool;
    var phi_2255_: bool;
    var local_36: bool;
    var phi_2260_: type_42;
    var phi_2261_: bool;
    var phi_2262_: bool;
    var phi_2263_: bool;
    var phi_2264_: bool;
    var phi_2265_: bool;
    var phi_2266_: bool;
    var phi_2267_: bool;
    var phi_2271_: f64;
    var phi_2272_: bool;
    var phi_2273_: bool;
    var phi_2274_: bool;
    var phi_2275_: bool;
    var phi_2276_: bool;
    var phi_2277_: bool;
    var phi_2278_: bool;
    var phi_2283_: type_42;
    var phi_2284_: bool;
    var phi_2285_: bool;
    var phi_2286_: bool;
    var phi_2287_: bool;
    var phi_2288_: bool;
    var phi_2289_: bool;
    var local_37: f64;
    var phi_2294_: type_42;
    var phi_2295_: bool;
    var phi_2296_: bool;
    var phi_2297_: bool;
    var phi_2298_: bool;
    var phi_2299_: bool;
    var local_38: f64;
    var phi_2304_: type_42;
    var phi_2305_: bool;
    var phi_2306_: bool;
    var phi_2307_: bool;
    var phi_2308_: bool;
    var local_39: f64;
    var phi_2313_: type_42;
    var phi_2314_: bool;
    var phi_2315_: bool;
    var phi_2316_: bool;
    var phi_2317_: bool;
    var phi_2321_: type_42;
    var phi_2322_: bool;
    var phi_2323_: bool;
    var phi_2324_: bool;
    var phi_2328_: bool;
    var phi_2329_: bool;
    var phi_2333_: bool;
    var phi_2334_: bool;
    var phi_2338_: bool;
    var phi_2339_: bool;
    var local_40: f64;
    var phi_2344_: type_42;
    var phi_2345_: bool;
    var phi_2349_: type_42;
    var phi_2363_: type_9;
    var phi_2364_: type_9;
    var phi_2387_: type_9;
    var phi_2408_: f64;
    var phi_2538_: type_16;
    var phi_2541_: f64;
    var phi_2562_: bool;
    var phi_2568_: type_17;
    var phi_2539_: type_16;
    var phi_2582_: type_17;
    var phi_2542_: f64;
    var local_41: f64;
    var phi_2531_: f64;
    var phi_2595_: f64;
    var phi_2613_: f64;
    var phi_2620_: f64;
    var phi_2625_: f64;
    var phi_2632_: f64;
    var phi_2637_: f64;
    var phi_2650_: f64;
    var phi_2657_: f64;
    var phi_2662_: f64;
    var phi_2669_: f64;
    var phi_2674_: f64;
    var phi_2679_: f64;
    var phi_2696_: f64;
    var phi_2703_: f64;
    var phi_2708_: f64;
    var phi_2715_: f64;
    var phi_2720_: f64;
    var phi_2734_: f64;
    var phi_2741_: f64;
    var phi_2746_: f64;
    var phi_2753_: f64;
    var phi_2758_: f64;
    var phi_2763_: f64;
    var phi_2780_: f64;
    var phi_2787_: f64;
    var phi_2792_: f64;
    var phi_2799_: f64;
    var phi_2804_: f64;
    var phi_2818_: f64;
    var phi_2825_: f64;
    var phi_2830_: f64;
    var phi_2837_: f64;
    var phi_2842_: f64;
    var phi_2847_: f64;
    var phi_2871_: bool;
    var phi_2872_: bool;
    var phi_2873_: bool;
    var local_42: bool;
    var phi_2878_: type_42;
    var phi_2879_: bool;
    var phi_2884_: type_42;
    var phi_2885_: bool;
    var phi_2887_: type_42;
    var phi_2888_: type_42;
    var phi_2889_: bool;
    var phi_2893_: type_42;
    var phi_5777_: type_42;
    var phi_5778_: type_42;
    var phi_5791_: type_32;
    var phi_5814_: u32;
    var phi_5818_: type_22;
    var phi_5819_: bool;
    var phi_5838_: u32;
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
    let _e119 = params.member.member_1.member_2;
    let _e121 = input.member[0u];
    if (_e119 < _e121) {
        phi_229_ = _e119;
    } else {
        phi_229_ = _e121;
    }
    let _e124 = phi_229_;
    let _e125 = (_e124 / 64u);
    if ((_e124 % 64u) > 0u) {
        phi_245_ = (_e125 + 1u);
    } else {
        phi_245_ = _e125;
    }
    let _e130 = phi_245_;
    if (_e130 > _e113) {
        let _e132 = (_e130 - _e113);
        if (_e116 == 0u) {
            return;
        }
        let _e134 = (_e132 / _e116);
        if (_e116 == 0u) {
            return;
        }
        if ((_e132 % _e116) > 0u) {
            phi_266_ = (_e134 + 1u);
        } else {
            phi_266_ = _e134;
        }
        let _e140 = phi_266_;
        phi_267_ = _e140;
    } else {
        phi_267_ = 0u;
    }
    let _e142 = phi_267_;
    phi_270_ = type_9(0u, _e142);
    loop {
        let _e145 = phi_270_;
        if (_e145.member < _e145.member_1) {
            phi_271_ = type_9((_e145.member + 1u), _e145.member_1);
            phi_294_ = type_9(1u, _e145.member);
        } else {
            phi_271_ = _e145;
            phi_294_ = type_9(0u, type_9().member_1);
        }
        let _e157 = phi_271_;
        let _e159 = phi_294_;
        let _e163 = (bitcast<i32>(_e159.member) != 0i);
        if _e163 {
            let _e167 = (((_e113 + (_e159.member_1 * _e116)) * 64u) + _e101);
            if (_e167 < _e124) {
                let _e169 = (2u * _e167);
                let _e172 = input.member[(4u + _e169)];
                let _e175 = input.member[(_e169 + 5u)];
                let _e178 = elements.member[_e172];
                let _e180 = elements.member[_e175];
                let _e186 = params.member.member.member_1;
                if ((_e186 & 8u) != 0u) {
                    let _e225 = paths.member[_e178[0]];
                    let _e227 = paths.member[_e178[1]];
                    let _e233 = paths.member[_e180[0]];
                    let _e235 = paths.member[_e180[1]];
                    let _e272 = function_3(array<f32, 3>(_e225.member[0], _e225.member[1], _e225.member[2]));
                    let _e273 = function_3(array<f32, 3>(_e227.member[0], _e227.member[1], _e227.member[2]));
                    let _e274 = function_3(array<f32, 3>(_e233.member[0], _e233.member[1], _e233.member[2]));
                    let _e275 = function_3(array<f32, 3>(_e235.member[0], _e235.member[1], _e235.member[2]));
                    let _e277 = function_3(array<f32, 3>(_e225.member_1[0], _e225.member_1[1], _e225.member_1[2]));
                    let _e278 = function_3(array<f32, 3>(_e227.member_1[0], _e227.member_1[1], _e227.member_1[2]));
                    let _e279 = function_3(array<f32, 3>(_e233.member_1[0], _e233.member_1[1], _e233.member_1[2]));
                    let _e280 = function_3(array<f32, 3>(_e235.member_1[0], _e235.member_1[1], _e235.member_1[2]));
                    phi_552_ = type_41(array<array<f64, 3>, 4>(_e272, _e273, _e274, _e275), array<array<f64, 3>, 4>(_e277, _e278, _e279, _e280));
                } else {
                    let _e190 = positions.member[_e178[0]];
                    let _e193 = params.member.member.member[0u];
                    let _e196 = positions.member[(_e193 + _e178[0])];
                    let _e198 = positions.member[_e178[1]];
                    let _e201 = params.member.member.member[0u];
                    let _e204 = positions.member[(_e201 + _e178[1])];
                    let _e206 = positions.member[_e180[0]];
                    let _e209 = params.member.member.member[0u];
                    let _e212 = positions.member[(_e209 + _e180[0])];
                    let _e214 = positions.member[_e180[1]];
                    let _e217 = params.member.member.member[0u];
                    let _e220 = positions.member[(_e217 + _e180[1])];
                    phi_552_ = type_41(array<array<f64, 3>, 4>(_e190, _e198, _e206, _e214), array<array<f64, 3>, 4>(_e196, _e204, _e212, _e220));
                }
                let _e284 = phi_552_;
                local_12 = type_40(array<array<f64, 3>, 2>(array<f64, 3>((_e284.member[2][0] - _e284.member[0][0]), (_e284.member[2][1] - _e284.member[0][1]), (_e284.member[2][2] - _e284.member[0][2])), array<f64, 3>((_e284.member_1[2][0] - _e284.member_1[0][0]), (_e284.member_1[2][1] - _e284.member_1[0][1]), (_e284.member_1[2][2] - _e284.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e284.member[1][0] - _e284.member[0][0]), (_e284.member[1][1] - _e284.member[0][1]), (_e284.member[1][2] - _e284.member[0][2])), array<f64, 3>((_e284.member_1[1][0] - _e284.member_1[0][0]), (_e284.member_1[1][1] - _e284.member_1[0][1]), (_e284.member_1[1][2] - _e284.member_1[0][2]))), array<array<f64, 3>, 2>(array<f64, 3>((_e284.member[2][0] - _e284.member[3][0]), (_e284.member[2][1] - _e284.member[3][1]), (_e284.member[2][2] - _e284.member[3][2])), array<f64, 3>((_e284.member_1[2][0] - _e284.member_1[3][0]), (_e284.member_1[2][1] - _e284.member_1[3][1]), (_e284.member_1[2][2] - _e284.member_1[3][2]))), (0.0lf + 0.0lf));
                let _e365 = params.member.member.member_7;
                let _e372 = bitcast<f64>(((u64(_e365[1]) * 4294967296lu) + u64(_e365[0])));
                let _e373 = f64(0f);
                let _e376 = local_12.member_1[0u];
                let _e382 = local_12.member_2[0u];
                let _e388 = ((_e376[1] * _e382[2]) - (_e376[2] * _e382[1]));
                let _e391 = ((_e376[2] * _e382[0]) - (_e376[0] * _e382[2]));
                let _e394 = ((_e376[0] * _e382[1]) - (_e376[1] * _e382[0]));
                let _e397 = local_12.member_1[1u];
                let _e403 = local_12.member_2[1u];
                let _e409 = ((_e397[1] * _e403[2]) - (_e397[2] * _e403[1]));
                let _e412 = ((_e397[2] * _e403[0]) - (_e397[0] * _e403[2]));
                let _e415 = ((_e397[0] * _e403[1]) - (_e397[1] * _e403[0]));
                let _e418 = local_12.member_1[0u];
                let _e424 = local_12.member_2[1u];
                let _e439 = local_12.member_1[1u];
                let _e445 = local_12.member_2[0u];
                let _e458 = (((_e418[1] * _e424[2]) - (_e418[2] * _e424[1])) + ((_e439[1] * _e445[2]) - (_e439[2] * _e445[1])));
                let _e459 = (((_e418[2] * _e424[0]) - (_e418[0] * _e424[2])) + ((_e439[2] * _e445[0]) - (_e439[0] * _e445[2])));
                let _e460 = (((_e418[0] * _e424[1]) - (_e418[1] * _e424[0])) + ((_e439[0] * _e445[1]) - (_e439[1] * _e445[0])));
                let _e463 = local_12.member[0u];
                let _e471 = (((_e463[0] * _e388) + (_e463[1] * _e391)) + (_e463[2] * _e394));
                let _e474 = local_12.member[1u];
                let _e485 = local_12.member[0u];
                let _e494 = ((((_e474[0] * _e388) + (_e474[1] * _e391)) + (_e474[2] * _e394)) + (((_e485[0] * _e458) + (_e485[1] * _e459)) + (_e485[2] * _e460)));
                let _e497 = local_12.member[0u];
                let _e508 = local_12.member[1u];
                let _e517 = ((((_e497[0] * _e409) + (_e497[1] * _e412)) + (_e497[2] * _e415)) + (((_e508[0] * _e458) + (_e508[1] * _e459)) + (_e508[2] * _e460)));
                let _e520 = local_12.member[1u];
                let _e528 = (((_e520[0] * _e409) + (_e520[1] * _e412)) + (_e520[2] * _e415));
                let _e531 = local_12.member[0u];
                if (_e531[0] < 0.0lf) {
                    phi_921_ = -(_e531[0]);
                } else {
                    phi_921_ = _e531[0];
                }
                let _e538 = phi_921_;
                if (_e531[1] < 0.0lf) {
                    phi_928_ = -(_e531[1]);
                } else {
                    phi_928_ = _e531[1];
                }
                let _e542 = phi_928_;
                if (_e538 > _e542) {
                    phi_933_ = _e538;
                } else {
                    phi_933_ = _e542;
                }
                let _e545 = phi_933_;
                if (_e531[2] < 0.0lf) {
                    phi_940_ = -(_e531[2]);
                } else {
                    phi_940_ = _e531[2];
                }
                let _e549 = phi_940_;
                if (_e545 > _e549) {
                    phi_945_ = _e545;
                } else {
                    phi_945_ = _e549;
                }
                let _e552 = phi_945_;
                let _e555 = local_12.member[1u];
                if (_e555[0] < 0.0lf) {
                    phi_958_ = -(_e555[0]);
                } else {
                    phi_958_ = _e555[0];
                }
                let _e562 = phi_958_;
                if (_e555[1] < 0.0lf) {
                    phi_965_ = -(_e555[1]);
                } else {
                    phi_965_ = _e555[1];
                }
                let _e566 = phi_965_;
                if (_e562 > _e566) {
                    phi_970_ = _e562;
                } else {
                    phi_970_ = _e566;
                }
                let _e569 = phi_970_;
                if (_e555[2] < 0.0lf) {
                    phi_977_ = -(_e555[2]);
                } else {
                    phi_977_ = _e555[2];
                }
                let _e573 = phi_977_;
                if (_e569 > _e573) {
                    phi_982_ = _e569;
                } else {
                    phi_982_ = _e573;
                }
                let _e576 = phi_982_;
                if (_e552 > _e576) {
                    phi_987_ = _e552;
                } else {
                    phi_987_ = _e576;
                }
                let _e579 = phi_987_;
                let _e581 = local_12.member_3;
                let _e582 = (_e579 + _e581);
                let _e585 = local_12.member_1[0u];
                if (_e585[0] < 0.0lf) {
                    phi_1004_ = -(_e585[0]);
                } else {
                    phi_1004_ = _e585[0];
                }
                let _e592 = phi_1004_;
                if (_e585[1] < 0.0lf) {
                    phi_1011_ = -(_e585[1]);
                } else {
                    phi_1011_ = _e585[1];
                }
                let _e596 = phi_1011_;
                if (_e592 > _e596) {
                    phi_1016_ = _e592;
                } else {
                    phi_1016_ = _e596;
                }
                let _e599 = phi_1016_;
                if (_e585[2] < 0.0lf) {
                    phi_1023_ = -(_e585[2]);
                } else {
                    phi_1023_ = _e585[2];
                }
                let _e603 = phi_1023_;
                if (_e599 > _e603) {
                    phi_1028_ = _e599;
                } else {
                    phi_1028_ = _e603;
                }
                let _e606 = phi_1028_;
                let _e609 = local_12.member_1[1u];
                if (_e609[0] < 0.0lf) {
                    phi_1042_ = -(_e609[0]);
                } else {
                    phi_1042_ = _e609[0];
                }
                let _e616 = phi_1042_;
                if (_e609[1] < 0.0lf) {
                    phi_1049_ = -(_e609[1]);
                } else {
                    phi_1049_ = _e609[1];
                }
                let _e620 = phi_1049_;
                if (_e616 > _e620) {
                    phi_1054_ = _e616;
                } else {
                    phi_1054_ = _e620;
                }
                let _e623 = phi_1054_;
                if (_e609[2] < 0.0lf) {
                    phi_1061_ = -(_e609[2]);
                } else {
                    phi_1061_ = _e609[2];
                }
                let _e627 = phi_1061_;
                if (_e623 > _e627) {
                    phi_1066_ = _e623;
                } else {
                    phi_1066_ = _e627;
                }
                let _e630 = phi_1066_;
                if (_e606 > _e630) {
                    phi_1071_ = _e606;
                } else {
                    phi_1071_ = _e630;
                }
                let _e633 = phi_1071_;
                let _e635 = local_12.member_3;
                let _e636 = (_e633 + _e635);
                let _e639 = local_12.member_2[0u];
                if (_e639[0] < 0.0lf) {
                    phi_1088_ = -(_e639[0]);
                } else {
                    phi_1088_ = _e639[0];
                }
                let _e646 = phi_1088_;
                if (_e639[1] < 0.0lf) {
                    phi_1095_ = -(_e639[1]);
                } else {
                    phi_1095_ = _e639[1];
                }
                let _e650 = phi_1095_;
                if (_e646 > _e650) {
                    phi_1100_ = _e646;
                } else {
                    phi_1100_ = _e650;
                }
                let _e653 = phi_1100_;
                if (_e639[2] < 0.0lf) {
                    phi_1107_ = -(_e639[2]);
                } else {
                    phi_1107_ = _e639[2];
                }
                let _e657 = phi_1107_;
                if (_e653 > _e657) {
                    phi_1112_ = _e653;
                } else {
                    phi_1112_ = _e657;
                }
                let _e660 = phi_1112_;
                let _e663 = local_12.member_2[1u];
                if (_e663[0] < 0.0lf) {
                    phi_1126_ = -(_e663[0]);
                } else {
                    phi_1126_ = _e663[0];
                }
                let _e670 = phi_1126_;
                if (_e663[1] < 0.0lf) {
                    phi_1133_ = -(_e663[1]);
                } else {
                    phi_1133_ = _e663[1];
                }
                let _e674 = phi_1133_;
                if (_e670 > _e674) {
                    phi_1138_ = _e670;
                } else {
                    phi_1138_ = _e674;
                }
                let _e677 = phi_1138_;
                if (_e663[2] < 0.0lf) {
                    phi_1145_ = -(_e663[2]);
                } else {
                    phi_1145_ = _e663[2];
                }
                let _e681 = phi_1145_;
                if (_e677 > _e681) {
                    phi_1150_ = _e677;
                } else {
                    phi_1150_ = _e681;
                }
                let _e684 = phi_1150_;
                if (_e660 > _e684) {
                    phi_1155_ = _e660;
                } else {
                    phi_1155_ = _e684;
                }
                let _e687 = phi_1155_;
                let _e689 = local_12.member_3;
                let _e690 = (_e687 + _e689);
                let _e691 = f64(1f);
                let _e692 = f64(8f);
                let _e694 = ((_e636 * _e692) * _e690);
                let _e702 = local_12.member_3;
                if (_e388 < 0.0lf) {
                    phi_1192_ = -(_e388);
                } else {
                    phi_1192_ = _e388;
                }
                let _e722 = phi_1192_;
                if (_e391 < 0.0lf) {
                    phi_1198_ = -(_e391);
                } else {
                    phi_1198_ = _e391;
                }
                let _e726 = phi_1198_;
                if (_e394 < 0.0lf) {
                    phi_1205_ = -(_e394);
                } else {
                    phi_1205_ = _e394;
                }
                let _e731 = phi_1205_;
                let _e732 = ((_e722 + _e726) + _e731);
                if (_e409 < 0.0lf) {
                    phi_1212_ = -(_e409);
                } else {
                    phi_1212_ = _e409;
                }
                let _e736 = phi_1212_;
                if (_e412 < 0.0lf) {
                    phi_1218_ = -(_e412);
                } else {
                    phi_1218_ = _e412;
                }
                let _e740 = phi_1218_;
                if (_e415 < 0.0lf) {
                    phi_1225_ = -(_e415);
                } else {
                    phi_1225_ = _e415;
                }
                let _e745 = phi_1225_;
                let _e746 = ((_e736 + _e740) + _e745);
                if (_e732 > _e746) {
                    phi_1231_ = _e732;
                } else {
                    phi_1231_ = _e746;
                }
                let _e749 = phi_1231_;
                if (_e458 < 0.0lf) {
                    phi_1237_ = -(_e458);
                } else {
                    phi_1237_ = _e458;
                }
                let _e753 = phi_1237_;
                if (_e459 < 0.0lf) {
                    phi_1243_ = -(_e459);
                } else {
                    phi_1243_ = _e459;
                }
                let _e757 = phi_1243_;
                if (_e460 < 0.0lf) {
                    phi_1250_ = -(_e460);
                } else {
                    phi_1250_ = _e460;
                }
                let _e762 = phi_1250_;
                let _e764 = (((_e753 + _e757) + _e762) * f64(0.5f));
                if (_e749 > _e764) {
                    phi_1257_ = _e749;
                } else {
                    phi_1257_ = _e764;
                }
                let _e767 = phi_1257_;
                let _e773 = local_12.member_3;
                let _e787 = (((((_e582 * _e692) * _e694) * (1.1102230246251565e-16lf * f64((490f / 64f)))) + ((_e702 * f64(19f)) * ((_e582 * (_e636 + _e690)) + (_e636 * _e690)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e691 + _e582) * ((_e691 + _e636) * (_e691 + _e690)))));
                let _e788 = f64(3f);
                let _e789 = (_e471 * _e788);
                let _e790 = (_e528 * _e788);
                if (_e789 < _e790) {
                    phi_1285_ = _e789;
                } else {
                    phi_1285_ = _e790;
                }
                let _e793 = phi_1285_;
                if (_e494 < _e517) {
                    phi_1290_ = _e494;
                } else {
                    phi_1290_ = _e517;
                }
                let _e796 = phi_1290_;
                if (_e793 < _e796) {
                    phi_1295_ = _e793;
                } else {
                    phi_1295_ = _e796;
                }
                let _e799 = phi_1295_;
                if (_e789 > _e790) {
                    phi_1300_ = _e789;
                } else {
                    phi_1300_ = _e790;
                }
                let _e802 = phi_1300_;
                if (_e494 > _e517) {
                    phi_1305_ = _e494;
                } else {
                    phi_1305_ = _e517;
                }
                let _e805 = phi_1305_;
                if (_e802 > _e805) {
                    phi_1310_ = _e802;
                } else {
                    phi_1310_ = _e805;
                }
                let _e808 = phi_1310_;
                let _e814 = -(_e808);
                if (_e799 > _e814) {
                    phi_1321_ = _e799;
                } else {
                    phi_1321_ = _e814;
                }
                let _e817 = phi_1321_;
                if ((_e817 - (_e787 + ((_e372 * (((_e767 + (_e694 * (1.1102230246251565e-16lf * f64(4f)))) + ((_e773 * f64(6f)) * (_e636 + _e690))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e691 + _e636) * (_e691 + _e690))))) * f64((3f * 1.0001f))))) > _e373) {
                    phi_5778_ = type_42(0u, type_42().member_1);
                } else {
                    if (_e372 > _e373) {
                        let _e2915 = f64(1f);
                        let _e2919 = local_12.member[0u];
                        let _e2925 = local_12.member_1[0u];
                        let _e2931 = local_12.member_2[0u];
                        let _e2935 = (_e2919[0] - _e2925[0]);
                        let _e2936 = (_e2919[1] - _e2925[1]);
                        let _e2937 = (_e2919[2] - _e2925[2]);
                        local_9 = array<array<f64, 3>, 4>(_e2919, array<f64, 3>(_e2935, _e2936, _e2937), array<f64, 3>((_e2919[0] - _e2931[0]), (_e2919[1] - _e2931[1]), (_e2919[2] - _e2931[2])), array<f64, 3>((_e2935 - _e2931[0]), (_e2936 - _e2931[1]), (_e2937 - _e2931[2])));
                        let _e2950 = local_12.member[1u];
                        let _e2956 = local_12.member_1[1u];
                        let _e2962 = local_12.member_2[1u];
                        let _e2966 = (_e2950[0] - _e2956[0]);
                        let _e2967 = (_e2950[1] - _e2956[1]);
                        let _e2968 = (_e2950[2] - _e2956[2]);
                        local_10 = array<array<f64, 3>, 4>(_e2950, array<f64, 3>(_e2966, _e2967, _e2968), array<f64, 3>((_e2950[0] - _e2962[0]), (_e2950[1] - _e2962[1]), (_e2950[2] - _e2962[2])), array<f64, 3>((_e2966 - _e2962[0]), (_e2967 - _e2962[1]), (_e2968 - _e2962[2])));
                        let _e2981 = local_12.member[0u];
                        if (_e2981[0] < 0.0lf) {
                            phi_1524_ = -(_e2981[0]);
                        } else {
                            phi_1524_ = _e2981[0];
                        }
                        let _e2988 = phi_1524_;
                        if (_e2981[1] < 0.0lf) {
                            phi_1531_ = -(_e2981[1]);
                        } else {
                            phi_1531_ = _e2981[1];
                        }
                        let _e2992 = phi_1531_;
                        if (_e2988 > _e2992) {
                            phi_1536_ = _e2988;
                        } else {
                            phi_1536_ = _e2992;
                        }
                        let _e2995 = phi_1536_;
                        if (_e2981[2] < 0.0lf) {
                            phi_1543_ = -(_e2981[2]);
                        } else {
                            phi_1543_ = _e2981[2];
                        }
                        let _e2999 = phi_1543_;
                        if (_e2995 > _e2999) {
                            phi_1548_ = _e2995;
                        } else {
                            phi_1548_ = _e2999;
                        }
                        let _e3002 = phi_1548_;
                        let _e3005 = local_12.member[1u];
                        if (_e3005[0] < 0.0lf) {
                            phi_1561_ = -(_e3005[0]);
                        } else {
                            phi_1561_ = _e3005[0];
                        }
                        let _e3012 = phi_1561_;
                        if (_e3005[1] < 0.0lf) {
                            phi_1568_ = -(_e3005[1]);
                        } else {
                            phi_1568_ = _e3005[1];
                        }
                        let _e3016 = phi_1568_;
                        if (_e3012 > _e3016) {
                            phi_1573_ = _e3012;
                        } else {
                            phi_1573_ = _e3016;
                        }
                        let _e3019 = phi_1573_;
                        if (_e3005[2] < 0.0lf) {
                            phi_1580_ = -(_e3005[2]);
                        } else {
                            phi_1580_ = _e3005[2];
                        }
                        let _e3023 = phi_1580_;
                        if (_e3019 > _e3023) {
                            phi_1585_ = _e3019;
                        } else {
                            phi_1585_ = _e3023;
                        }
                        let _e3026 = phi_1585_;
                        if (_e3002 > _e3026) {
                            phi_1590_ = _e3002;
                        } else {
                            phi_1590_ = _e3026;
                        }
                        let _e3029 = phi_1590_;
                        let _e3031 = local_12.member_3;
                        let _e3035 = local_12.member_1[0u];
                        if (_e3035[0] < 0.0lf) {
                            phi_1607_ = -(_e3035[0]);
                        } else {
                            phi_1607_ = _e3035[0];
                        }
                        let _e3042 = phi_1607_;
                        if (_e3035[1] < 0.0lf) {
                            phi_1614_ = -(_e3035[1]);
                        } else {
                            phi_1614_ = _e3035[1];
                        }
                        let _e3046 = phi_1614_;
                        if (_e3042 > _e3046) {
                            phi_1619_ = _e3042;
                        } else {
                            phi_1619_ = _e3046;
                        }
                        let _e3049 = phi_1619_;
                        if (_e3035[2] < 0.0lf) {
                            phi_1626_ = -(_e3035[2]);
                        } else {
                            phi_1626_ = _e3035[2];
                        }
                        let _e3053 = phi_1626_;
                        if (_e3049 > _e3053) {
                            phi_1631_ = _e3049;
                        } else {
                            phi_1631_ = _e3053;
                        }
                        let _e3056 = phi_1631_;
                        let _e3059 = local_12.member_1[1u];
                        if (_e3059[0] < 0.0lf) {
                            phi_1645_ = -(_e3059[0]);
                        } else {
                            phi_1645_ = _e3059[0];
                        }
                        let _e3066 = phi_1645_;
                        if (_e3059[1] < 0.0lf) {
                            phi_1652_ = -(_e3059[1]);
                        } else {
                            phi_1652_ = _e3059[1];
                        }
                        let _e3070 = phi_1652_;
                        if (_e3066 > _e3070) {
                            phi_1657_ = _e3066;
                        } else {
                            phi_1657_ = _e3070;
                        }
                        let _e3073 = phi_1657_;
                        if (_e3059[2] < 0.0lf) {
                            phi_1664_ = -(_e3059[2]);
                        } else {
                            phi_1664_ = _e3059[2];
                        }
                        let _e3077 = phi_1664_;
                        if (_e3073 > _e3077) {
                            phi_1669_ = _e3073;
                        } else {
                            phi_1669_ = _e3077;
                        }
                        let _e3080 = phi_1669_;
                        if (_e3056 > _e3080) {
                            phi_1674_ = _e3056;
                        } else {
                            phi_1674_ = _e3080;
                        }
                        let _e3083 = phi_1674_;
                        let _e3085 = local_12.member_3;
                        let _e3089 = local_12.member_2[0u];
                        if (_e3089[0] < 0.0lf) {
                            phi_1691_ = -(_e3089[0]);
                        } else {
                            phi_1691_ = _e3089[0];
                        }
                        let _e3096 = phi_1691_;
                        if (_e3089[1] < 0.0lf) {
                            phi_1698_ = -(_e3089[1]);
                        } else {
                            phi_1698_ = _e3089[1];
                        }
                        let _e3100 = phi_1698_;
                        if (_e3096 > _e3100) {
                            phi_1703_ = _e3096;
                        } else {
                            phi_1703_ = _e3100;
                        }
                        let _e3103 = phi_1703_;
                        if (_e3089[2] < 0.0lf) {
                            phi_1710_ = -(_e3089[2]);
                        } else {
                            phi_1710_ = _e3089[2];
                        }
                        let _e3107 = phi_1710_;
                        if (_e3103 > _e3107) {
                            phi_1715_ = _e3103;
                        } else {
                            phi_1715_ = _e3107;
                        }
                        let _e3110 = phi_1715_;
                        let _e3113 = local_12.member_2[1u];
                        if (_e3113[0] < 0.0lf) {
                            phi_1729_ = -(_e3113[0]);
                        } else {
                            phi_1729_ = _e3113[0];
                        }
                        let _e3120 = phi_1729_;
                        if (_e3113[1] < 0.0lf) {
                            phi_1736_ = -(_e3113[1]);
                        } else {
                            phi_1736_ = _e3113[1];
                        }
                        let _e3124 = phi_1736_;
                        if (_e3120 > _e3124) {
                            phi_1741_ = _e3120;
                        } else {
                            phi_1741_ = _e3124;
                        }
                        let _e3127 = phi_1741_;
                        if (_e3113[2] < 0.0lf) {
                            phi_1748_ = -(_e3113[2]);
                        } else {
                            phi_1748_ = _e3113[2];
                        }
                        let _e3131 = phi_1748_;
                        if (_e3127 > _e3131) {
                            phi_1753_ = _e3127;
                        } else {
                            phi_1753_ = _e3131;
                        }
                        let _e3134 = phi_1753_;
                        if (_e3110 > _e3134) {
                            phi_1758_ = _e3110;
                        } else {
                            phi_1758_ = _e3134;
                        }
                        let _e3137 = phi_1758_;
                        let _e3139 = local_12.member_3;
                        let _e3147 = local_12.member_3;
                        phi_1778_ = type_9(0u, 48u);
                        phi_1781_ = f64(0f);
                        loop {
                            let _e3156 = phi_1778_;
                            let _e3158 = phi_1781_;
                            local_77 = _e3158;
                            local_37 = _e3158;
                            local_38 = _e3158;
                            local_39 = _e3158;
                            local_40 = _e3158;
                            if (_e3156.member < _e3156.member_1) {
                                phi_1779_ = type_9((_e3156.member + 1u), _e3156.member_1);
                                phi_1804_ = type_9(1u, _e3156.member);
                            } else {
                                phi_1779_ = _e3156;
                                phi_1804_ = type_9(0u, type_9().member_1);
                            }
                            let _e3170 = phi_1779_;
                            let _e3172 = phi_1804_;
                            if (bitcast<i32>(_e3172.member) != 0i) {
                                let _e3178 = local_12.member[0u];
                                let _e3184 = local_12.member[1u];
                                let _e3200 = local_12.member_1[0u];
                                let _e3206 = local_12.member_1[1u];
                                let _e3222 = local_12.member_2[0u];
                                let _e3228 = local_12.member_2[1u];
                                let _e3242 = function_2(array<f64, 3>((_e3178[0] + ((_e3184[0] - _e3178[0]) * _e3158)), (_e3178[1] + ((_e3184[1] - _e3178[1]) * _e3158)), (_e3178[2] + ((_e3184[2] - _e3178[2]) * _e3158))), array<f64, 3>((_e3200[0] + ((_e3206[0] - _e3200[0]) * _e3158)), (_e3200[1] + ((_e3206[1] - _e3200[1]) * _e3158)), (_e3200[2] + ((_e3206[2] - _e3200[2]) * _e3158))), array<f64, 3>((_e3222[0] + ((_e3228[0] - _e3222[0]) * _e3158)), (_e3222[1] + ((_e3228[1] - _e3222[1]) * _e3158)), (_e3222[2] + ((_e3228[2] - _e3222[2]) * _e3158))), 1u);
                                if (_e3242[0] < 0.0lf) {
                                    phi_1915_ = -(_e3242[0]);
                                } else {
                                    phi_1915_ = _e3242[0];
                                }
                                let _e3247 = phi_1915_;
                                if (_e3242[1] < 0.0lf) {
                                    phi_1922_ = -(_e3242[1]);
                                } else {
                                    phi_1922_ = _e3242[1];
                                }
                                let _e3252 = phi_1922_;
                                if (_e3242[2] < 0.0lf) {
                                    phi_1930_ = -(_e3242[2]);
                                } else {
                                    phi_1930_ = _e3242[2];
                                }
                                let _e3258 = phi_1930_;
                                let _e3259 = ((_e3247 + _e3252) + _e3258);
                                if (_e3259 > f64(0f)) {
                                    if ((bitcast<u64>(_e3259) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e3265 = (f64(1f) / _e3259);
                                        let _e3267 = (_e3242[0] * _e3265);
                                        let _e3269 = (_e3242[1] * _e3265);
                                        let _e3271 = (_e3242[2] * _e3265);
                                        let _e3276 = (((_e3267 * _e3267) + (_e3269 * _e3269)) + (_e3271 * _e3271));
                                        if (_e3276 <= 2.2250738585072014e-308lf) {
                                            if (_e3276 > 0.0lf) {
                                                phi_1968_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_1968_ = 0.0lf;
                                            }
                                            let _e3328 = phi_1968_;
                                            phi_2032_ = _e3328;
                                        } else {
                                            phi_1975_ = type_16(0i, 5i);
                                            phi_1978_ = bitcast<f64>(((bitcast<u64>(_e3276) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e3283 = phi_1975_;
                                                let _e3285 = phi_1978_;
                                                local_31 = _e3285;
                                                if (_e3283.member < _e3283.member_1) {
                                                    let _e3292 = (_e3283.member + 1i);
                                                    if ((false == (_e3292 > _e3283.member)) != false) {
                                                        phi_1999_ = true;
                                                    } else {
                                                        phi_1999_ = false;
                                                    }
                                                    let _e3297 = phi_1999_;
                                                    if _e3297 {
                                                        phi_2005_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2005_ = type_17(1u, _e3292);
                                                    }
                                                    let _e3302 = phi_2005_;
                                                    phi_1976_ = type_16(_e3302.member_1, _e3283.member_1);
                                                    phi_2019_ = type_17(1u, _e3283.member);
                                                } else {
                                                    phi_1976_ = _e3283;
                                                    phi_2019_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e3308 = phi_1976_;
                                                let _e3310 = phi_2019_;
                                                let _e3313 = (bitcast<i32>(_e3310.member) != 0i);
                                                if _e3313 {
                                                    phi_1979_ = (0.5lf * (_e3285 + (_e3276 / _e3285)));
                                                } else {
                                                    phi_1979_ = f64();
                                                }
                                                let _e3318 = phi_1979_;
                                                continue;
                                                continuing {
                                                    phi_1975_ = _e3308;
                                                    phi_1978_ = _e3318;
                                                    break if !(_e3313);
                                                }
                                            }
                                            let _e3323 = local_31;
                                            phi_2032_ = (_e3323 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e3330 = phi_2032_;
                                        phi_2045_ = type_9(0u, 4u);
                                        phi_2048_ = f64(2f);
                                        loop {
                                            let _e3342 = phi_2045_;
                                            let _e3344 = phi_2048_;
                                            local_33 = _e3344;
                                            local_34 = _e3344;
                                            local_35 = _e3344;
                                            local_67 = _e3344;
                                            local_68 = _e3344;
                                            if (_e3342.member < _e3342.member_1) {
                                                phi_2046_ = type_9((_e3342.member + 1u), _e3342.member_1);
                                                phi_2071_ = type_9(1u, _e3342.member);
                                            } else {
                                                phi_2046_ = _e3342;
                                                phi_2071_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e3356 = phi_2046_;
                                            let _e3358 = phi_2071_;
                                            if (bitcast<i32>(_e3358.member) != 0i) {
                                                let _e3364 = local_9[_e3358.member_1];
                                                let _e3372 = (((_e3267 * _e3364[0]) + (_e3269 * _e3364[1])) + (_e3271 * _e3364[2]));
                                                let _e3374 = local_10[_e3358.member_1];
                                                let _e3382 = (((_e3267 * _e3374[0]) + (_e3269 * _e3374[1])) + (_e3271 * _e3374[2]));
                                                if (_e3372 < 0.0lf) {
                                                    phi_2122_ = -(_e3372);
                                                } else {
                                                    phi_2122_ = _e3372;
                                                }
                                                let _e3386 = phi_2122_;
                                                if (_e3382 < 0.0lf) {
                                                    phi_2128_ = -(_e3382);
                                                } else {
                                                    phi_2128_ = _e3382;
                                                }
                                                let _e3390 = phi_2128_;
                                                let _e3395 = (((((((((_e3029 + _e3031) + (_e3083 + _e3085)) + (_e3137 + _e3139)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3147 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e372 * _e3330) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e3386 + _e3390) * (1.1102230246251565e-16lf * f64(8f))));
                                                if (_e3372 > _e3395) {
                                                    if (_e3382 > _e3395) {
                                                        phi_2142_ = false;
                                                    } else {
                                                        phi_2142_ = true;
                                                    }
                                                    let _e3399 = phi_2142_;
                                                    phi_2143_ = _e3399;
                                                } else {
                                                    phi_2143_ = true;
                                                }
                                                let _e3401 = phi_2143_;
                                                if _e3401 {
                                                    if ((_e3372 + ((_e3382 - _e3372) * _e3158)) > _e3395) {
                                                        if (_e3382 < _e3372) {
                                                            let _e3410 = ((_e3372 - _e3382) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                            if _e3410 {
                                                                let _e3418 = (((_e3372 - _e3395) / (_e3372 - _e3382)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                if (_e3344 < _e3418) {
                                                                    phi_2177_ = _e3344;
                                                                } else {
                                                                    phi_2177_ = _e3418;
                                                                }
                                                                let _e3421 = phi_2177_;
                                                                phi_2178_ = _e3421;
                                                            } else {
                                                                phi_2178_ = f64();
                                                            }
                                                            let _e3423 = phi_2178_;
                                                            phi_2179_ = _e3423;
                                                            phi_2180_ = _e3410;
                                                        } else {
                                                            phi_2179_ = _e3344;
                                                            phi_2180_ = true;
                                                        }
                                                        let _e3425 = phi_2179_;
                                                        let _e3427 = phi_2180_;
                                                        if _e3427 {
                                                            phi_2184_ = false;
                                                        } else {
                                                            phi_2184_ = true;
                                                        }
                                                        let _e3429 = phi_2184_;
                                                        phi_2185_ = _e3425;
                                                        phi_2186_ = _e3427;
                                                        phi_2187_ = _e3429;
                                                        phi_2188_ = false;
                                                    } else {
                                                        phi_2185_ = f64();
                                                        phi_2186_ = false;
                                                        phi_2187_ = false;
                                                        phi_2188_ = true;
                                                    }
                                                    let _e3431 = phi_2185_;
                                                    let _e3433 = phi_2186_;
                                                    let _e3435 = phi_2187_;
                                                    let _e3437 = phi_2188_;
                                                    phi_2189_ = _e3431;
                                                    phi_2190_ = _e3433;
                                                    phi_2191_ = _e3435;
                                                    phi_2192_ = _e3437;
                                                } else {
                                                    phi_2189_ = _e3344;
                                                    phi_2190_ = true;
                                                    phi_2191_ = false;
                                                    phi_2192_ = false;
                                                }
                                                let _e3439 = phi_2189_;
                                                let _e3441 = phi_2190_;
                                                let _e3443 = phi_2191_;
                                                let _e3445 = phi_2192_;
                                                phi_2049_ = _e3439;
                                                phi_2193_ = _e3441;
                                                phi_2194_ = false;
                                                phi_2195_ = _e3443;
                                                phi_2196_ = _e3445;
                                            } else {
                                                phi_2049_ = f64();
                                                phi_2193_ = false;
                                                phi_2194_ = true;
                                                phi_2195_ = false;
                                                phi_2196_ = false;
                                            }
                                            let _e3447 = phi_2049_;
                                            let _e3449 = phi_2193_;
                                            let _e3451 = phi_2194_;
                                            let _e3453 = phi_2195_;
                                            let _e3455 = phi_2196_;
                                            local_32 = _e3451;
                                            local_65 = _e3453;
                                            local_66 = _e3455;
                                            continue;
                                            continuing {
                                                phi_2045_ = _e3356;
                                                phi_2048_ = _e3447;
                                                break if !(_e3449);
                                            }
                                        }
                                        let _e3458 = local_32;
                                        if _e3458 {
                                            let _e3460 = local_33;
                                            let _e3461 = (_e3460 > _e2915);
                                            if _e3461 {
                                                phi_2218_ = false;
                                                phi_2219_ = false;
                                                phi_2220_ = false;
                                            } else {
                                                let _e3463 = local_34;
                                                if (_e3463 > _e3158) {
                                                    let _e3466 = local_35;
                                                    let _e3469 = ((_e3466 - _e3158) < f64(0.00000000023283064f));
                                                    if _e3469 {
                                                        phi_2214_ = false;
                                                    } else {
                                                        phi_2214_ = true;
                                                    }
                                                    let _e3471 = phi_2214_;
                                                    phi_2215_ = _e3471;
                                                    phi_2216_ = _e3469;
                                                    phi_2217_ = false;
                                                } else {
                                                    phi_2215_ = false;
                                                    phi_2216_ = false;
                                                    phi_2217_ = true;
                                                }
                                                let _e3473 = phi_2215_;
                                                let _e3475 = phi_2216_;
                                                let _e3477 = phi_2217_;
                                                phi_2218_ = _e3473;
                                                phi_2219_ = _e3475;
                                                phi_2220_ = _e3477;
                                            }
                                            let _e3479 = phi_2218_;
                                            let _e3481 = phi_2219_;
                                            let _e3483 = phi_2220_;
                                            phi_2221_ = _e3479;
                                            phi_2222_ = _e3461;
                                            phi_2223_ = _e3481;
                                            phi_2224_ = _e3483;
                                            phi_2225_ = false;
                                            phi_2226_ = false;
                                        } else {
                                            phi_2221_ = false;
                                            phi_2222_ = false;
                                            phi_2223_ = false;
                                            phi_2224_ = false;
                                            let _e4757 = local_65;
                                            phi_2225_ = _e4757;
                                            let _e4760 = local_66;
                                            phi_2226_ = _e4760;
                                        }
                                        let _e3485 = phi_2221_;
                                        let _e3487 = phi_2222_;
                                        let _e3489 = phi_2223_;
                                        let _e3491 = phi_2224_;
                                        let _e3493 = phi_2225_;
                                        let _e3495 = phi_2226_;
                                        let _e4763 = local_67;
                                        phi_2227_ = _e4763;
                                        let _e4766 = local_68;
                                        phi_2228_ = _e4766;
                                        phi_2229_ = _e3485;
                                        phi_2230_ = _e3487;
                                        phi_2231_ = _e3489;
                                        phi_2232_ = _e3491;
                                        phi_2233_ = _e3493;
                                        phi_2234_ = _e3495;
                                        phi_2235_ = false;
                                    } else {
                                        phi_2227_ = f64();
                                        phi_2228_ = f64();
                                        phi_2229_ = false;
                                        phi_2230_ = false;
                                        phi_2231_ = false;
                                        phi_2232_ = false;
                                        phi_2233_ = false;
                                        phi_2234_ = false;
                                        phi_2235_ = true;
                                    }
                                    let _e3497 = phi_2227_;
                                    let _e3499 = phi_2228_;
                                    let _e3501 = phi_2229_;
                                    let _e3503 = phi_2230_;
                                    let _e3505 = phi_2231_;
                                    let _e3507 = phi_2232_;
                                    let _e3509 = phi_2233_;
                                    let _e3511 = phi_2234_;
                                    let _e3513 = phi_2235_;
                                    phi_2236_ = _e3497;
                                    phi_2237_ = _e3499;
                                    phi_2238_ = _e3501;
                                    phi_2239_ = _e3503;
                                    phi_2240_ = _e3505;
                                    phi_2241_ = _e3507;
                                    phi_2242_ = _e3509;
                                    phi_2243_ = _e3511;
                                    phi_2244_ = _e3513;
                                    phi_2245_ = false;
                                } else {
                                    phi_2236_ = f64();
                                    phi_2237_ = f64();
                                    phi_2238_ = false;
                                    phi_2239_ = false;
                                    phi_2240_ = false;
                                    phi_2241_ = false;
                                    phi_2242_ = false;
                                    phi_2243_ = false;
                                    phi_2244_ = false;
                                    phi_2245_ = true;
                                }
                                let _e3515 = phi_2236_;
                                let _e3517 = phi_2237_;
                                let _e3519 = phi_2238_;
                                let _e3521 = phi_2239_;
                                let _e3523 = phi_2240_;
                                let _e3525 = phi_2241_;
                                let _e3527 = phi_2242_;
                                let _e3529 = phi_2243_;
                                let _e3531 = phi_2244_;
                                let _e3533 = phi_2245_;
                                phi_2246_ = _e3515;
                                phi_1782_ = _e3517;
                                phi_2247_ = _e3519;
                                phi_2248_ = _e3521;
                                phi_2249_ = _e3523;
                                phi_2250_ = false;
                                phi_2251_ = _e3525;
                                phi_2252_ = _e3527;
                                phi_2253_ = _e3529;
                                phi_2254_ = _e3531;
                                phi_2255_ = _e3533;
                            } else {
                                phi_2246_ = f64();
                                phi_1782_ = f64();
                                phi_2247_ = false;
                                phi_2248_ = false;
                                phi_2249_ = false;
                                phi_2250_ = true;
                                phi_2251_ = false;
                                phi_2252_ = false;
                                phi_2253_ = false;
                                phi_2254_ = false;
                                phi_2255_ = false;
                            }
                            let _e3535 = phi_2246_;
                            let _e3537 = phi_1782_;
                            let _e3539 = phi_2247_;
                            let _e3541 = phi_2248_;
                            let _e3543 = phi_2249_;
                            let _e3545 = phi_2250_;
                            let _e3547 = phi_2251_;
                            let _e3549 = phi_2252_;
                            let _e3551 = phi_2253_;
                            let _e3553 = phi_2254_;
                            let _e3555 = phi_2255_;
                            local_36 = _e3541;
                            local_69 = _e3543;
                            local_70 = _e3545;
                            local_71 = _e3547;
                            local_72 = _e3549;
                            local_73 = _e3551;
                            local_74 = _e3553;
                            local_75 = _e3555;
                            local_76 = _e3535;
                            local_78 = _e3541;
                            continue;
                            continuing {
                                phi_1778_ = _e3170;
                                phi_1781_ = _e3537;
                                break if !(_e3539);
                            }
                        }
                        let _e3558 = local_36;
                        if _e3558 {
                            phi_2260_ = type_42(0u, type_42().member_1);
                            phi_2261_ = false;
                            phi_2262_ = false;
                            phi_2263_ = false;
                            phi_2264_ = false;
                            phi_2265_ = false;
                            phi_2266_ = false;
                            phi_2267_ = false;
                        } else {
                            phi_2260_ = type_42();
                            let _e4799 = local_69;
                            phi_2261_ = _e4799;
                            let _e4802 = local_70;
                            phi_2262_ = _e4802;
                            let _e4805 = local_71;
                            phi_2263_ = _e4805;
                            let _e4808 = local_72;
                            phi_2264_ = _e4808;
                            let _e4811 = local_73;
                            phi_2265_ = _e4811;
                            let _e4814 = local_74;
                            phi_2266_ = _e4814;
                            let _e4817 = local_75;
                            phi_2267_ = _e4817;
                        }
                        let _e3562 = phi_2260_;
                        let _e3564 = phi_2261_;
                        let _e3566 = phi_2262_;
                        let _e3568 = phi_2263_;
                        let _e3570 = phi_2264_;
                        let _e3572 = phi_2265_;
                        let _e3574 = phi_2266_;
                        let _e3576 = phi_2267_;
                        if _e3564 {
                            let _e4820 = local_76;
                            phi_2271_ = _e4820;
                            phi_2272_ = true;
                            phi_2273_ = false;
                            phi_2274_ = false;
                            phi_2275_ = false;
                            phi_2276_ = false;
                            phi_2277_ = false;
                            phi_2278_ = false;
                        } else {
                            let _e4822 = local_77;
                            phi_2271_ = _e4822;
                            phi_2272_ = _e3566;
                            phi_2273_ = _e3568;
                            phi_2274_ = _e3570;
                            phi_2275_ = _e3572;
                            let _e4829 = local_78;
                            phi_2276_ = _e4829;
                            phi_2277_ = _e3574;
                            phi_2278_ = _e3576;
                        }
                        let _e3578 = phi_2271_;
                        let _e3580 = phi_2272_;
                        let _e3582 = phi_2273_;
                        let _e3584 = phi_2274_;
                        let _e3586 = phi_2275_;
                        let _e3588 = phi_2276_;
                        let _e3590 = phi_2277_;
                        let _e3592 = phi_2278_;
                        if _e3580 {
                            phi_2283_ = type_42(1u, _e3578);
                            phi_2284_ = false;
                            phi_2285_ = false;
                            phi_2286_ = false;
                            phi_2287_ = false;
                            phi_2288_ = false;
                            phi_2289_ = false;
                        } else {
                            phi_2283_ = type_42();
                            phi_2284_ = _e3582;
                            phi_2285_ = _e3584;
                            phi_2286_ = _e3586;
                            phi_2287_ = _e3588;
                            phi_2288_ = _e3590;
                            phi_2289_ = _e3592;
                        }
                        let _e3595 = phi_2283_;
                        let _e3597 = phi_2284_;
                        let _e3599 = phi_2285_;
                        let _e3601 = phi_2286_;
                        let _e3603 = phi_2287_;
                        let _e3605 = phi_2288_;
                        let _e3607 = phi_2289_;
                        if _e3597 {
                            let _e3609 = local_37;
                            phi_2294_ = type_42(1u, _e3609);
                            phi_2295_ = false;
                            phi_2296_ = false;
                            phi_2297_ = true;
                            phi_2298_ = false;
                            phi_2299_ = false;
                        } else {
                            phi_2294_ = _e3562;
                            phi_2295_ = _e3599;
                            phi_2296_ = _e3601;
                            phi_2297_ = _e3603;
                            phi_2298_ = _e3605;
                            phi_2299_ = _e3607;
                        }
                        let _e3612 = phi_2294_;
                        let _e3614 = phi_2295_;
                        let _e3616 = phi_2296_;
                        let _e3618 = phi_2297_;
                        let _e3620 = phi_2298_;
                        let _e3622 = phi_2299_;
                        if _e3614 {
                            let _e3624 = local_38;
                            phi_2304_ = type_42(1u, _e3624);
                            phi_2305_ = false;
                            phi_2306_ = false;
                            phi_2307_ = false;
                            phi_2308_ = false;
                        } else {
                            phi_2304_ = type_42();
                            phi_2305_ = _e3616;
                            phi_2306_ = _e3618;
                            phi_2307_ = _e3620;
                            phi_2308_ = _e3622;
                        }
                        let _e3627 = phi_2304_;
                        let _e3629 = phi_2305_;
                        let _e3631 = phi_2306_;
                        let _e3633 = phi_2307_;
                        let _e3635 = phi_2308_;
                        if _e3629 {
                            let _e3637 = local_39;
                            phi_2313_ = type_42(1u, _e3637);
                            phi_2314_ = true;
                            phi_2315_ = false;
                            phi_2316_ = false;
                            phi_2317_ = false;
                        } else {
                            phi_2313_ = _e3627;
                            phi_2314_ = _e3614;
                            phi_2315_ = _e3631;
                            phi_2316_ = _e3633;
                            phi_2317_ = _e3635;
                        }
                        let _e3640 = phi_2313_;
                        let _e3642 = phi_2314_;
                        let _e3644 = phi_2315_;
                        let _e3646 = phi_2316_;
                        let _e3648 = phi_2317_;
                        if _e3642 {
                            phi_2321_ = _e3640;
                            phi_2322_ = true;
                            phi_2323_ = false;
                            phi_2324_ = false;
                        } else {
                            phi_2321_ = _e3612;
                            phi_2322_ = _e3644;
                            phi_2323_ = _e3646;
                            phi_2324_ = _e3648;
                        }
                        let _e3650 = phi_2321_;
                        let _e3652 = phi_2322_;
                        let _e3654 = phi_2323_;
                        let _e3656 = phi_2324_;
                        if _e3652 {
                            phi_2328_ = false;
                            phi_2329_ = false;
                        } else {
                            phi_2328_ = _e3654;
                            phi_2329_ = _e3656;
                        }
                        let _e3658 = phi_2328_;
                        let _e3660 = phi_2329_;
                        if _e3658 {
                            phi_2333_ = false;
                            phi_2334_ = false;
                        } else {
                            phi_2333_ = _e3660;
                            phi_2334_ = _e3652;
                        }
                        let _e3662 = phi_2333_;
                        let _e3664 = phi_2334_;
                        if _e3662 {
                            phi_2338_ = true;
                            phi_2339_ = false;
                        } else {
                            phi_2338_ = _e3658;
                            phi_2339_ = _e3664;
                        }
                        let _e3666 = phi_2338_;
                        let _e3668 = phi_2339_;
                        if _e3666 {
                            let _e3670 = local_40;
                            phi_2344_ = type_42(1u, _e3670);
                            phi_2345_ = true;
                        } else {
                            phi_2344_ = _e3650;
                            phi_2345_ = _e3668;
                        }
                        let _e3673 = phi_2344_;
                        let _e3675 = phi_2345_;
                        if _e3675 {
                            phi_2349_ = _e3673;
                        } else {
                            phi_2349_ = _e3595;
                        }
                        let _e3677 = phi_2349_;
                        if (_e3677.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_2363_ = type_9(0u, 3u);
                            loop {
                                let _e3689 = phi_2363_;
                                if (_e3689.member < _e3689.member_1) {
                                    phi_2364_ = type_9((_e3689.member + 1u), _e3689.member_1);
                                    phi_2387_ = type_9(1u, _e3689.member);
                                } else {
                                    phi_2364_ = _e3689;
                                    phi_2387_ = type_9(0u, type_9().member_1);
                                }
                                let _e3701 = phi_2364_;
                                let _e3703 = phi_2387_;
                                if (bitcast<i32>(_e3703.member) != 0i) {
                                    let _e3709 = local_11[_e3703.member_1];
                                    let _e3711 = (_e3677.member_1 + f64(_e3709));
                                    if (_e3711 < _e2915) {
                                        phi_2408_ = _e3711;
                                    } else {
                                        phi_2408_ = _e2915;
                                    }
                                    let _e3714 = phi_2408_;
                                    let _e3717 = local_12.member[0u];
                                    let _e3723 = local_12.member[1u];
                                    let _e3739 = local_12.member_1[0u];
                                    let _e3745 = local_12.member_1[1u];
                                    let _e3761 = local_12.member_2[0u];
                                    let _e3767 = local_12.member_2[1u];
                                    let _e3781 = function_2(array<f64, 3>((_e3717[0] + ((_e3723[0] - _e3717[0]) * _e3714)), (_e3717[1] + ((_e3723[1] - _e3717[1]) * _e3714)), (_e3717[2] + ((_e3723[2] - _e3717[2]) * _e3714))), array<f64, 3>((_e3739[0] + ((_e3745[0] - _e3739[0]) * _e3714)), (_e3739[1] + ((_e3745[1] - _e3739[1]) * _e3714)), (_e3739[2] + ((_e3745[2] - _e3739[2]) * _e3714))), array<f64, 3>((_e3761[0] + ((_e3767[0] - _e3761[0]) * _e3714)), (_e3761[1] + ((_e3767[1] - _e3761[1]) * _e3714)), (_e3761[2] + ((_e3767[2] - _e3761[2]) * _e3714))), 1u);
                                    let _e3792 = (((_e3781[0] * _e3781[0]) + (_e3781[1] * _e3781[1])) + (_e3781[2] * _e3781[2]));
                                    if (_e3792 <= 2.2250738585072014e-308lf) {
                                        if (_e3792 > 0.0lf) {
                                            phi_2531_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_2531_ = 0.0lf;
                                        }
                                        let _e3844 = phi_2531_;
                                        phi_2595_ = _e3844;
                                    } else {
                                        phi_2538_ = type_16(0i, 5i);
                                        phi_2541_ = bitcast<f64>(((bitcast<u64>(_e3792) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e3799 = phi_2538_;
                                            let _e3801 = phi_2541_;
                                            local_41 = _e3801;
                                            if (_e3799.member < _e3799.member_1) {
                                                let _e3808 = (_e3799.member + 1i);
                                                if ((false == (_e3808 > _e3799.member)) != false) {
                                                    phi_2562_ = true;
                                                } else {
                                                    phi_2562_ = false;
                                                }
                                                let _e3813 = phi_2562_;
                                                if _e3813 {
                                                    phi_2568_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_2568_ = type_17(1u, _e3808);
                                                }
                                                let _e3818 = phi_2568_;
                                                phi_2539_ = type_16(_e3818.member_1, _e3799.member_1);
                                                phi_2582_ = type_17(1u, _e3799.member);
                                            } else {
                                                phi_2539_ = _e3799;
                                                phi_2582_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e3824 = phi_2539_;
                                            let _e3826 = phi_2582_;
                                            let _e3829 = (bitcast<i32>(_e3826.member) != 0i);
                                            if _e3829 {
                                                phi_2542_ = (0.5lf * (_e3801 + (_e3792 / _e3801)));
                                            } else {
                                                phi_2542_ = f64();
                                            }
                                            let _e3834 = phi_2542_;
                                            continue;
                                            continuing {
                                                phi_2538_ = _e3824;
                                                phi_2541_ = _e3834;
                                                break if !(_e3829);
                                            }
                                        }
                                        let _e3839 = local_41;
                                        phi_2595_ = (_e3839 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e3846 = phi_2595_;
                                    let _e3854 = local_12.member[0u];
                                    if (_e3854[0] < 0.0lf) {
                                        phi_2613_ = -(_e3854[0]);
                                    } else {
                                        phi_2613_ = _e3854[0];
                                    }
                                    let _e3861 = phi_2613_;
                                    if (_e3854[1] < 0.0lf) {
                                        phi_2620_ = -(_e3854[1]);
                                    } else {
                                        phi_2620_ = _e3854[1];
                                    }
                                    let _e3865 = phi_2620_;
                                    if (_e3861 > _e3865) {
                                        phi_2625_ = _e3861;
                                    } else {
                                        phi_2625_ = _e3865;
                                    }
                                    let _e3868 = phi_2625_;
                                    if (_e3854[2] < 0.0lf) {
                                        phi_2632_ = -(_e3854[2]);
                                    } else {
                                        phi_2632_ = _e3854[2];
                                    }
                                    let _e3872 = phi_2632_;
                                    if (_e3868 > _e3872) {
                                        phi_2637_ = _e3868;
                                    } else {
                                        phi_2637_ = _e3872;
                                    }
                                    let _e3875 = phi_2637_;
                                    let _e3878 = local_12.member[1u];
                                    if (_e3878[0] < 0.0lf) {
                                        phi_2650_ = -(_e3878[0]);
                                    } else {
                                        phi_2650_ = _e3878[0];
                                    }
                                    let _e3885 = phi_2650_;
                                    if (_e3878[1] < 0.0lf) {
                                        phi_2657_ = -(_e3878[1]);
                                    } else {
                                        phi_2657_ = _e3878[1];
                                    }
                                    let _e3889 = phi_2657_;
                                    if (_e3885 > _e3889) {
                                        phi_2662_ = _e3885;
                                    } else {
                                        phi_2662_ = _e3889;
                                    }
                                    let _e3892 = phi_2662_;
                                    if (_e3878[2] < 0.0lf) {
                                        phi_2669_ = -(_e3878[2]);
                                    } else {
                                        phi_2669_ = _e3878[2];
                                    }
                                    let _e3896 = phi_2669_;
                                    if (_e3892 > _e3896) {
                                        phi_2674_ = _e3892;
                                    } else {
                                        phi_2674_ = _e3896;
                                    }
                                    let _e3899 = phi_2674_;
                                    if (_e3875 > _e3899) {
                                        phi_2679_ = _e3875;
                                    } else {
                                        phi_2679_ = _e3899;
                                    }
                                    let _e3902 = phi_2679_;
                                    let _e3904 = local_12.member_3;
                                    let _e3908 = local_12.member_1[0u];
                                    if (_e3908[0] < 0.0lf) {
                                        phi_2696_ = -(_e3908[0]);
                                    } else {
                                        phi_2696_ = _e3908[0];
                                    }
                                    let _e3915 = phi_2696_;
                                    if (_e3908[1] < 0.0lf) {
                                        phi_2703_ = -(_e3908[1]);
                                    } else {
                                        phi_2703_ = _e3908[1];
                                    }
                                    let _e3919 = phi_2703_;
                                    if (_e3915 > _e3919) {
                                        phi_2708_ = _e3915;
                                    } else {
                                        phi_2708_ = _e3919;
                                    }
                                    let _e3922 = phi_2708_;
                                    if (_e3908[2] < 0.0lf) {
                                        phi_2715_ = -(_e3908[2]);
                                    } else {
                                        phi_2715_ = _e3908[2];
                                    }
                                    let _e3926 = phi_2715_;
                                    if (_e3922 > _e3926) {
                                        phi_2720_ = _e3922;
                                    } else {
                                        phi_2720_ = _e3926;
                                    }
                                    let _e3929 = phi_2720_;
                                    let _e3932 = local_12.member_1[1u];
                                    if (_e3932[0] < 0.0lf) {
                                        phi_2734_ = -(_e3932[0]);
                                    } else {
                                        phi_2734_ = _e3932[0];
                                    }
                                    let _e3939 = phi_2734_;
                                    if (_e3932[1] < 0.0lf) {
                                        phi_2741_ = -(_e3932[1]);
                                    } else {
                                        phi_2741_ = _e3932[1];
                                    }
                                    let _e3943 = phi_2741_;
                                    if (_e3939 > _e3943) {
                                        phi_2746_ = _e3939;
                                    } else {
                                        phi_2746_ = _e3943;
                                    }
                                    let _e3946 = phi_2746_;
                                    if (_e3932[2] < 0.0lf) {
                                        phi_2753_ = -(_e3932[2]);
                                    } else {
                                        phi_2753_ = _e3932[2];
                                    }
                                    let _e3950 = phi_2753_;
                                    if (_e3946 > _e3950) {
                                        phi_2758_ = _e3946;
                                    } else {
                                        phi_2758_ = _e3950;
                                    }
                                    let _e3953 = phi_2758_;
                                    if (_e3929 > _e3953) {
                                        phi_2763_ = _e3929;
                                    } else {
                                        phi_2763_ = _e3953;
                                    }
                                    let _e3956 = phi_2763_;
                                    let _e3958 = local_12.member_3;
                                    let _e3962 = local_12.member_2[0u];
                                    if (_e3962[0] < 0.0lf) {
                                        phi_2780_ = -(_e3962[0]);
                                    } else {
                                        phi_2780_ = _e3962[0];
                                    }
                                    let _e3969 = phi_2780_;
                                    if (_e3962[1] < 0.0lf) {
                                        phi_2787_ = -(_e3962[1]);
                                    } else {
                                        phi_2787_ = _e3962[1];
                                    }
                                    let _e3973 = phi_2787_;
                                    if (_e3969 > _e3973) {
                                        phi_2792_ = _e3969;
                                    } else {
                                        phi_2792_ = _e3973;
                                    }
                                    let _e3976 = phi_2792_;
                                    if (_e3962[2] < 0.0lf) {
                                        phi_2799_ = -(_e3962[2]);
                                    } else {
                                        phi_2799_ = _e3962[2];
                                    }
                                    let _e3980 = phi_2799_;
                                    if (_e3976 > _e3980) {
                                        phi_2804_ = _e3976;
                                    } else {
                                        phi_2804_ = _e3980;
                                    }
                                    let _e3983 = phi_2804_;
                                    let _e3986 = local_12.member_2[1u];
                                    if (_e3986[0] < 0.0lf) {
                                        phi_2818_ = -(_e3986[0]);
                                    } else {
                                        phi_2818_ = _e3986[0];
                                    }
                                    let _e3993 = phi_2818_;
                                    if (_e3986[1] < 0.0lf) {
                                        phi_2825_ = -(_e3986[1]);
                                    } else {
                                        phi_2825_ = _e3986[1];
                                    }
                                    let _e3997 = phi_2825_;
                                    if (_e3993 > _e3997) {
                                        phi_2830_ = _e3993;
                                    } else {
                                        phi_2830_ = _e3997;
                                    }
                                    let _e4000 = phi_2830_;
                                    if (_e3986[2] < 0.0lf) {
                                        phi_2837_ = -(_e3986[2]);
                                    } else {
                                        phi_2837_ = _e3986[2];
                                    }
                                    let _e4004 = phi_2837_;
                                    if (_e4000 > _e4004) {
                                        phi_2842_ = _e4000;
                                    } else {
                                        phi_2842_ = _e4004;
                                    }
                                    let _e4007 = phi_2842_;
                                    if (_e3983 > _e4007) {
                                        phi_2847_ = _e3983;
                                    } else {
                                        phi_2847_ = _e4007;
                                    }
                                    let _e4010 = phi_2847_;
                                    let _e4012 = local_12.member_3;
                                    let _e4020 = local_12.member_3;
                                    let _e4030 = (((_e3846 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e3902 + _e3904) + (_e3956 + _e3958)) + (_e4010 + _e4012)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4020 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e372);
                                    if _e4030 {
                                        phi_2871_ = false;
                                    } else {
                                        phi_2871_ = true;
                                    }
                                    let _e4032 = phi_2871_;
                                    phi_2872_ = _e4032;
                                    phi_2873_ = _e4030;
                                } else {
                                    phi_2872_ = false;
                                    phi_2873_ = false;
                                }
                                let _e4034 = phi_2872_;
                                let _e4036 = phi_2873_;
                                local_42 = _e4036;
                                continue;
                                continuing {
                                    phi_2363_ = _e3701;
                                    break if !(_e4034);
                                }
                            }
                            let _e4039 = local_42;
                            if _e4039 {
                                phi_2878_ = type_42(1u, _e3677.member_1);
                                phi_2879_ = false;
                            } else {
                                phi_2878_ = type_42();
                                phi_2879_ = true;
                            }
                            let _e4042 = phi_2878_;
                            let _e4044 = phi_2879_;
                            if _e4044 {
                                phi_2884_ = type_42(2u, _e3677.member_1);
                                phi_2885_ = false;
                            } else {
                                phi_2884_ = type_42();
                                phi_2885_ = true;
                            }
                            let _e4047 = phi_2884_;
                            let _e4049 = phi_2885_;
                            phi_2887_ = _e4047;
                            phi_2888_ = _e4042;
                            phi_2889_ = _e4049;
                        } else {
                            phi_2887_ = type_42();
                            phi_2888_ = type_42(0u, type_42().member_1);
                            phi_2889_ = true;
                        }
                        let _e4051 = phi_2887_;
                        let _e4053 = phi_2888_;
                        let _e4055 = phi_2889_;
                        if _e4055 {
                            phi_2893_ = _e4053;
                        } else {
                            phi_2893_ = _e4051;
                        }
                        let _e4057 = phi_2893_;
                        phi_5777_ = _e4057;
                    } else {
                        if (_e471 < 0.0lf) {
                            phi_2904_ = -(_e471);
                        } else {
                            phi_2904_ = _e471;
                        }
                        let _e826 = phi_2904_;
                        if (_e494 < 0.0lf) {
                            phi_2910_ = -(_e494);
                        } else {
                            phi_2910_ = _e494;
                        }
                        let _e830 = phi_2910_;
                        if (_e826 > _e830) {
                            phi_2915_ = _e826;
                        } else {
                            phi_2915_ = _e830;
                        }
                        let _e833 = phi_2915_;
                        if (_e517 < 0.0lf) {
                            phi_2921_ = -(_e517);
                        } else {
                            phi_2921_ = _e517;
                        }
                        let _e837 = phi_2921_;
                        if (_e528 < 0.0lf) {
                            phi_2927_ = -(_e528);
                        } else {
                            phi_2927_ = _e528;
                        }
                        let _e841 = phi_2927_;
                        if (_e837 > _e841) {
                            phi_2932_ = _e837;
                        } else {
                            phi_2932_ = _e841;
                        }
                        let _e844 = phi_2932_;
                        if (_e833 > _e844) {
                            phi_2937_ = _e833;
                        } else {
                            phi_2937_ = _e844;
                        }
                        let _e847 = phi_2937_;
                        let _e849 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e850 = f64(1f);
                        if (_e847 >= _e849) {
                            phi_2947_ = (_e847 <= (_e850 / _e849));
                        } else {
                            phi_2947_ = false;
                        }
                        let _e855 = phi_2947_;
                        if _e855 {
                            phi_2954_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_2954_ = f64(2f);
                        }
                        let _e860 = phi_2954_;
                        let _e862 = ((_e787 * f64(0.34f)) + (_e847 * _e860));
                        if _e855 {
                            phi_2962_ = (_e850 / _e847);
                        } else {
                            phi_2962_ = f64(0f);
                        }
                        let _e866 = phi_2962_;
                        let _e867 = f64(0f);
                        let _e868 = f64(1f);
                        let _e869 = f64(3f);
                        let _e875 = ((_e494 - (_e869 * _e471)) * _e866);
                        let _e876 = ((_e517 - _e494) * _e866);
                        let _e877 = (((_e869 * _e528) - _e517) * _e866);
                        local_6[0u] = _e867;
                        local_6[1u] = _e868;
                        local_6[2u] = _e868;
                        local_6[3u] = _e868;
                        let _e884 = ((_e876 * _e876) - (_e875 * _e877));
                        if (_e884 > _e867) {
                            if (_e884 <= 2.2250738585072014e-308lf) {
                                if (_e884 > 0.0lf) {
                                    phi_2998_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_2998_ = 0.0lf;
                                }
                                let _e937 = phi_2998_;
                                phi_3062_ = _e937;
                            } else {
                                phi_3005_ = type_16(0i, 5i);
                                phi_3008_ = bitcast<f64>(((bitcast<u64>(_e884) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e892 = phi_3005_;
                                    let _e894 = phi_3008_;
                                    local_13 = _e894;
                                    if (_e892.member < _e892.member_1) {
                                        let _e901 = (_e892.member + 1i);
                                        if ((false == (_e901 > _e892.member)) != false) {
                                            phi_3029_ = true;
                                        } else {
                                            phi_3029_ = false;
                                        }
                                        let _e906 = phi_3029_;
                                        if _e906 {
                                            phi_3035_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_3035_ = type_17(1u, _e901);
                                        }
                                        let _e911 = phi_3035_;
                                        phi_3006_ = type_16(_e911.member_1, _e892.member_1);
                                        phi_3049_ = type_17(1u, _e892.member);
                                    } else {
                                        phi_3006_ = _e892;
                                        phi_3049_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e917 = phi_3006_;
                                    let _e919 = phi_3049_;
                                    let _e922 = (bitcast<i32>(_e919.member) != 0i);
                                    if _e922 {
                                        phi_3009_ = (0.5lf * (_e894 + (_e884 / _e894)));
                                    } else {
                                        phi_3009_ = f64();
                                    }
                                    let _e927 = phi_3009_;
                                    continue;
                                    continuing {
                                        phi_3005_ = _e917;
                                        phi_3008_ = _e927;
                                        break if !(_e922);
                                    }
                                }
                                let _e932 = local_13;
                                phi_3062_ = (_e932 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e939 = phi_3062_;
                            if (_e876 < _e867) {
                                phi_3068_ = -(_e939);
                            } else {
                                phi_3068_ = _e939;
                            }
                            let _e943 = phi_3068_;
                            let _e945 = -((_e876 + _e943));
                            local_7[0u] = (_e945 / (_e945 + _e877));
                            local_7[1u] = (_e875 / (_e875 + _e945));
                            let _e954 = local_7[1u];
                            let _e955 = local_7[0u];
                            if (_e954 < _e955) {
                                let _e958 = local_7[1u];
                                let _e960 = local_7[0u];
                                local_7[0u] = _e958;
                                local_7[1u] = _e960;
                            }
                            phi_3093_ = type_9(0u, 2u);
                            phi_3096_ = 1u;
                            loop {
                                let _e964 = phi_3093_;
                                let _e966 = phi_3096_;
                                local_43 = _e966;
                                if (_e964.member < _e964.member_1) {
                                    phi_3094_ = type_9((_e964.member + 1u), _e964.member_1);
                                    phi_3119_ = type_9(1u, _e964.member);
                                } else {
                                    phi_3094_ = _e964;
                                    phi_3119_ = type_9(0u, type_9().member_1);
                                }
                                let _e978 = phi_3094_;
                                let _e980 = phi_3119_;
                                let _e984 = (bitcast<i32>(_e980.member) != 0i);
                                if _e984 {
                                    let _e986 = local_7[_e980.member_1];
                                    if (_e986 > _e867) {
                                        let _e989 = local_7[_e980.member_1];
                                        if (_e989 < _e868) {
                                            let _e992 = local_7[_e980.member_1];
                                            local_6[_e966] = _e992;
                                            phi_3163_ = (_e966 + 1u);
                                        } else {
                                            phi_3163_ = _e966;
                                        }
                                        let _e996 = phi_3163_;
                                        phi_3164_ = _e996;
                                    } else {
                                        phi_3164_ = _e966;
                                    }
                                    let _e998 = phi_3164_;
                                    phi_3097_ = _e998;
                                } else {
                                    phi_3097_ = u32();
                                }
                                let _e1000 = phi_3097_;
                                continue;
                                continuing {
                                    phi_3093_ = _e978;
                                    phi_3096_ = _e1000;
                                    break if !(_e984);
                                }
                            }
                            let _e4237 = local_43;
                            phi_3165_ = _e4237;
                        } else {
                            phi_3165_ = 1u;
                        }
                        let _e1003 = phi_3165_;
                        local_6[_e1003] = _e868;
                        let _e1005 = local_6;
                        local_8 = _e1005;
                        phi_3185_ = type_9(0u, _e1003);
                        loop {
                            let _e1008 = phi_3185_;
                            if (_e1008.member < _e1008.member_1) {
                                phi_3186_ = type_9((_e1008.member + 1u), _e1008.member_1);
                                phi_3209_ = type_9(1u, _e1008.member);
                            } else {
                                phi_3186_ = _e1008;
                                phi_3209_ = type_9(0u, type_9().member_1);
                            }
                            let _e1020 = phi_3186_;
                            let _e1022 = phi_3209_;
                            if (bitcast<i32>(_e1022.member) != 0i) {
                                let _e1028 = local_8[_e1022.member_1];
                                let _e1031 = local_8[(_e1022.member_1 + 1u)];
                                let _e1033 = (f64(1f) - _e1028);
                                let _e1044 = ((((_e471 * _e1033) + (_e494 * _e1028)) * (_e1033 * _e1033)) + (((_e517 * _e1033) + (_e528 * _e1028)) * (_e1028 * _e1028)));
                                let _e1046 = (f64(1f) - _e1031);
                                let _e1057 = ((((_e471 * _e1046) + (_e494 * _e1031)) * (_e1046 * _e1046)) + (((_e517 * _e1046) + (_e528 * _e1031)) * (_e1031 * _e1031)));
                                if (_e1044 < 0.0lf) {
                                    phi_3263_ = -(_e1044);
                                } else {
                                    phi_3263_ = _e1044;
                                }
                                let _e1061 = phi_3263_;
                                let _e1062 = (_e1061 > _e862);
                                if (_e1057 < 0.0lf) {
                                    phi_3270_ = -(_e1057);
                                } else {
                                    phi_3270_ = _e1057;
                                }
                                let _e1066 = phi_3270_;
                                let _e1067 = (_e1066 > _e862);
                                let _e1068 = f64(0f);
                                if _e1062 {
                                    if _e1067 {
                                        phi_3282_ = ((_e1044 > _e1068) != (_e1057 > _e1068));
                                        phi_3283_ = false;
                                    } else {
                                        phi_3282_ = bool();
                                        phi_3283_ = true;
                                    }
                                    let _e1073 = phi_3282_;
                                    let _e1075 = phi_3283_;
                                    phi_3284_ = _e1073;
                                    phi_3285_ = _e1075;
                                } else {
                                    phi_3284_ = bool();
                                    phi_3285_ = true;
                                }
                                let _e1077 = phi_3284_;
                                let _e1079 = phi_3285_;
                                if _e1079 {
                                    phi_3289_ = false;
                                } else {
                                    phi_3289_ = _e1077;
                                }
                                let _e1081 = phi_3289_;
                                if _e1062 {
                                    if _e1067 {
                                        if _e1081 {
                                            phi_3301_ = type_43();
                                        } else {
                                            phi_3301_ = type_43(f64(1f), _e1068, _e1081);
                                        }
                                        let _e1085 = phi_3301_;
                                        phi_3302_ = _e1085;
                                        phi_3303_ = _e1081;
                                    } else {
                                        phi_3302_ = type_43();
                                        phi_3303_ = true;
                                    }
                                    let _e1087 = phi_3302_;
                                    let _e1089 = phi_3303_;
                                    phi_3304_ = _e1087;
                                    phi_3305_ = _e1089;
                                } else {
                                    phi_3304_ = type_43();
                                    phi_3305_ = true;
                                }
                                let _e1091 = phi_3304_;
                                let _e1093 = phi_3305_;
                                if _e1093 {
                                    if _e1062 {
                                        if (_e1044 < _e1068) {
                                            phi_3318_ = f64(-1f);
                                        } else {
                                            phi_3318_ = f64(1f);
                                        }
                                        let _e1098 = phi_3318_;
                                        let _e1099 = f64(0.00000000000022737368f);
                                        let _e1100 = f64(0.5f);
                                        let _e1101 = f64(3f);
                                        let _e1104 = (_e517 - _e494);
                                        phi_3331_ = type_9(0u, 64u);
                                        phi_3334_ = _e1031;
                                        phi_3336_ = _e1028;
                                        phi_3338_ = (_e1100 * (_e1028 + _e1031));
                                        loop {
                                            let _e1110 = phi_3331_;
                                            let _e1112 = phi_3334_;
                                            let _e1114 = phi_3336_;
                                            let _e1116 = phi_3338_;
                                            local_45 = _e1114;
                                            if (_e1110.member < _e1110.member_1) {
                                                phi_3332_ = type_9((_e1110.member + 1u), _e1110.member_1);
                                                phi_3361_ = type_9(1u, _e1110.member);
                                            } else {
                                                phi_3332_ = _e1110;
                                                phi_3361_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1128 = phi_3332_;
                                            let _e1130 = phi_3361_;
                                            if (bitcast<i32>(_e1130.member) != 0i) {
                                                let _e1135 = (f64(1f) - _e1116);
                                                let _e1148 = ((_e1098 * ((((_e471 * _e1135) + (_e494 * _e1116)) * (_e1135 * _e1135)) + (((_e517 * _e1135) + (_e528 * _e1116)) * (_e1116 * _e1116)))) - _e862);
                                                if (_e1148 > f64(0f)) {
                                                    phi_3388_ = _e1112;
                                                    phi_3389_ = _e1116;
                                                } else {
                                                    phi_3388_ = _e1116;
                                                    phi_3389_ = _e1114;
                                                }
                                                let _e1152 = phi_3388_;
                                                let _e1154 = phi_3389_;
                                                let _e1156 = ((_e1152 - _e1154) > _e1099);
                                                if _e1156 {
                                                    let _e1158 = (f64(1f) - _e1116);
                                                    let _e1170 = (-(_e1148) / (_e1098 * (((((_e494 - (_e1101 * _e471)) * _e1158) + (_e1104 * _e1116)) * _e1158) + (((_e1104 * _e1158) + (((_e1101 * _e528) - _e517) * _e1116)) * _e1116))));
                                                    if (_e1148 > f64(0f)) {
                                                        phi_3417_ = (_e1100 * _e1099);
                                                    } else {
                                                        phi_3417_ = -((_e1100 * _e1099));
                                                    }
                                                    let _e1177 = phi_3417_;
                                                    let _e1179 = ((_e1116 + _e1170) + _e1177);
                                                    if (_e1179 > _e1154) {
                                                        if (_e1179 < _e1152) {
                                                            if (_e1170 < 0.0lf) {
                                                                phi_3433_ = -(_e1170);
                                                            } else {
                                                                phi_3433_ = _e1170;
                                                            }
                                                            let _e1185 = phi_3433_;
                                                            if (_e1185 < (_e1100 * (_e1152 - _e1154))) {
                                                                phi_3440_ = false;
                                                            } else {
                                                                phi_3440_ = true;
                                                            }
                                                            let _e1190 = phi_3440_;
                                                            phi_3441_ = _e1190;
                                                        } else {
                                                            phi_3441_ = true;
                                                        }
                                                        let _e1192 = phi_3441_;
                                                        phi_3442_ = _e1192;
                                                    } else {
                                                        phi_3442_ = true;
                                                    }
                                                    let _e1194 = phi_3442_;
                                                    if _e1194 {
                                                        phi_3448_ = (_e1100 * (_e1154 + _e1152));
                                                    } else {
                                                        phi_3448_ = _e1179;
                                                    }
                                                    let _e1198 = phi_3448_;
                                                    phi_3449_ = _e1198;
                                                    phi_3450_ = false;
                                                } else {
                                                    phi_3449_ = f64();
                                                    phi_3450_ = true;
                                                }
                                                let _e1200 = phi_3449_;
                                                let _e1202 = phi_3450_;
                                                phi_3335_ = _e1152;
                                                phi_3337_ = _e1154;
                                                phi_3339_ = _e1200;
                                                phi_3451_ = _e1154;
                                                phi_3452_ = _e1156;
                                                phi_3453_ = _e1202;
                                            } else {
                                                phi_3335_ = f64();
                                                phi_3337_ = f64();
                                                phi_3339_ = f64();
                                                phi_3451_ = f64();
                                                phi_3452_ = false;
                                                phi_3453_ = false;
                                            }
                                            let _e1204 = phi_3335_;
                                            let _e1206 = phi_3337_;
                                            let _e1208 = phi_3339_;
                                            let _e1210 = phi_3451_;
                                            let _e1212 = phi_3452_;
                                            let _e1214 = phi_3453_;
                                            local_14 = _e1214;
                                            local_44 = _e1210;
                                            continue;
                                            continuing {
                                                phi_3331_ = _e1128;
                                                phi_3334_ = _e1204;
                                                phi_3336_ = _e1206;
                                                phi_3338_ = _e1208;
                                                break if !(_e1212);
                                            }
                                        }
                                        let _e1217 = local_14;
                                        if _e1217 {
                                            let _e4279 = local_44;
                                            phi_3457_ = _e4279;
                                        } else {
                                            let _e4281 = local_45;
                                            phi_3457_ = _e4281;
                                        }
                                        let _e1219 = phi_3457_;
                                        phi_3458_ = _e1219;
                                    } else {
                                        phi_3458_ = _e1028;
                                    }
                                    let _e1221 = phi_3458_;
                                    if _e1067 {
                                        phi_3466_ = type_9(0u, 64u);
                                        phi_3469_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1225 = phi_3466_;
                                            let _e1227 = phi_3469_;
                                            if (_e1225.member < _e1225.member_1) {
                                                phi_3467_ = type_9((_e1225.member + 1u), _e1225.member_1);
                                                phi_3492_ = type_9(1u, _e1225.member);
                                            } else {
                                                phi_3467_ = _e1225;
                                                phi_3492_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1239 = phi_3467_;
                                            let _e1241 = phi_3492_;
                                            if (bitcast<i32>(_e1241.member) != 0i) {
                                                let _e1245 = (_e1221 + _e1227);
                                                if (_e1245 < _e1031) {
                                                    let _e1248 = (f64(1f) - _e1245);
                                                    let _e1259 = ((((_e471 * _e1248) + (_e494 * _e1245)) * (_e1248 * _e1248)) + (((_e517 * _e1248) + (_e528 * _e1245)) * (_e1245 * _e1245)));
                                                    let _e1261 = (f64(1f) - _e1221);
                                                    let _e1272 = ((((_e471 * _e1261) + (_e494 * _e1221)) * (_e1261 * _e1261)) + (((_e517 * _e1261) + (_e528 * _e1221)) * (_e1221 * _e1221)));
                                                    if (_e1259 < 0.0lf) {
                                                        phi_3535_ = -(_e1259);
                                                    } else {
                                                        phi_3535_ = _e1259;
                                                    }
                                                    let _e1276 = phi_3535_;
                                                    if (_e1276 > _e862) {
                                                        if (_e1272 < 0.0lf) {
                                                            phi_3545_ = -(_e1272);
                                                        } else {
                                                            phi_3545_ = _e1272;
                                                        }
                                                        let _e1281 = phi_3545_;
                                                        if (_e1281 > _e862) {
                                                            phi_3555_ = ((_e1259 > f64(0f)) == (_e1272 > f64(0f)));
                                                        } else {
                                                            phi_3555_ = false;
                                                        }
                                                        let _e1289 = phi_3555_;
                                                        phi_3557_ = !(_e1289);
                                                    } else {
                                                        phi_3557_ = false;
                                                    }
                                                    let _e1292 = phi_3557_;
                                                    if _e1292 {
                                                        phi_3562_ = f64();
                                                        phi_3563_ = false;
                                                    } else {
                                                        phi_3562_ = (_e1227 + _e1227);
                                                        phi_3563_ = true;
                                                    }
                                                    let _e1295 = phi_3562_;
                                                    let _e1297 = phi_3563_;
                                                    phi_3564_ = _e1295;
                                                    phi_3565_ = _e1297;
                                                    phi_3566_ = _e1292;
                                                    phi_3567_ = false;
                                                } else {
                                                    phi_3564_ = f64();
                                                    phi_3565_ = false;
                                                    phi_3566_ = false;
                                                    phi_3567_ = true;
                                                }
                                                let _e1299 = phi_3564_;
                                                let _e1301 = phi_3565_;
                                                let _e1303 = phi_3566_;
                                                let _e1305 = phi_3567_;
                                                phi_3568_ = _e1245;
                                                phi_3470_ = _e1299;
                                                phi_3569_ = _e1301;
                                                phi_3570_ = _e1303;
                                                phi_3571_ = _e1305;
                                                phi_3572_ = false;
                                            } else {
                                                phi_3568_ = f64();
                                                phi_3470_ = f64();
                                                phi_3569_ = false;
                                                phi_3570_ = false;
                                                phi_3571_ = false;
                                                phi_3572_ = true;
                                            }
                                            let _e1307 = phi_3568_;
                                            let _e1309 = phi_3470_;
                                            let _e1311 = phi_3569_;
                                            let _e1313 = phi_3570_;
                                            let _e1315 = phi_3571_;
                                            let _e1317 = phi_3572_;
                                            local_15 = _e1313;
                                            local_46 = _e1315;
                                            local_47 = _e1317;
                                            local_48 = _e1307;
                                            continue;
                                            continuing {
                                                phi_3466_ = _e1239;
                                                phi_3469_ = _e1309;
                                                break if !(_e1311);
                                            }
                                        }
                                        let _e1320 = local_15;
                                        if _e1320 {
                                            phi_3576_ = false;
                                            phi_3577_ = false;
                                        } else {
                                            let _e4306 = local_46;
                                            phi_3576_ = _e4306;
                                            let _e4309 = local_47;
                                            phi_3577_ = _e4309;
                                        }
                                        let _e1322 = phi_3576_;
                                        let _e1324 = phi_3577_;
                                        if _e1322 {
                                            phi_3581_ = true;
                                        } else {
                                            phi_3581_ = _e1324;
                                        }
                                        let _e1326 = phi_3581_;
                                        if _e1326 {
                                            phi_3585_ = _e1031;
                                        } else {
                                            let _e4313 = local_48;
                                            phi_3585_ = _e4313;
                                        }
                                        let _e1328 = phi_3585_;
                                        phi_3586_ = _e1328;
                                    } else {
                                        phi_3586_ = _e1031;
                                    }
                                    let _e1330 = phi_3586_;
                                    phi_3588_ = type_43(_e1221, _e1330, _e1081);
                                } else {
                                    phi_3588_ = _e1091;
                                }
                                let _e1333 = phi_3588_;
                                if (_e1333.member > _e1333.member_1) {
                                    phi_5733_ = f64();
                                    phi_5734_ = true;
                                    phi_5735_ = false;
                                    phi_5736_ = false;
                                    phi_5737_ = false;
                                } else {
                                    let _e1341 = ((_e1333.member_1 - _e1333.member) * f64(0.5f));
                                    let _e1342 = (_e1333.member + _e1341);
                                    let _e1345 = (_e1341 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1347 = local_12.member_3;
                                    let _e1350 = local_12.member[0u];
                                    if (_e1350[0] < 0.0lf) {
                                        phi_3619_ = -(_e1350[0]);
                                    } else {
                                        phi_3619_ = _e1350[0];
                                    }
                                    let _e1357 = phi_3619_;
                                    if (_e1350[1] < 0.0lf) {
                                        phi_3626_ = -(_e1350[1]);
                                    } else {
                                        phi_3626_ = _e1350[1];
                                    }
                                    let _e1361 = phi_3626_;
                                    if (_e1357 > _e1361) {
                                        phi_3631_ = _e1357;
                                    } else {
                                        phi_3631_ = _e1361;
                                    }
                                    let _e1364 = phi_3631_;
                                    if (_e1350[2] < 0.0lf) {
                                        phi_3638_ = -(_e1350[2]);
                                    } else {
                                        phi_3638_ = _e1350[2];
                                    }
                                    let _e1368 = phi_3638_;
                                    if (_e1364 > _e1368) {
                                        phi_3643_ = _e1364;
                                    } else {
                                        phi_3643_ = _e1368;
                                    }
                                    let _e1371 = phi_3643_;
                                    let _e1373 = local_12.member[1u];
                                    if (_e1373[0] < 0.0lf) {
                                        phi_3656_ = -(_e1373[0]);
                                    } else {
                                        phi_3656_ = _e1373[0];
                                    }
                                    let _e1380 = phi_3656_;
                                    if (_e1373[1] < 0.0lf) {
                                        phi_3663_ = -(_e1373[1]);
                                    } else {
                                        phi_3663_ = _e1373[1];
                                    }
                                    let _e1384 = phi_3663_;
                                    if (_e1380 > _e1384) {
                                        phi_3668_ = _e1380;
                                    } else {
                                        phi_3668_ = _e1384;
                                    }
                                    let _e1387 = phi_3668_;
                                    if (_e1373[2] < 0.0lf) {
                                        phi_3675_ = -(_e1373[2]);
                                    } else {
                                        phi_3675_ = _e1373[2];
                                    }
                                    let _e1391 = phi_3675_;
                                    if (_e1387 > _e1391) {
                                        phi_3680_ = _e1387;
                                    } else {
                                        phi_3680_ = _e1391;
                                    }
                                    let _e1394 = phi_3680_;
                                    if (_e1371 > _e1394) {
                                        phi_3685_ = _e1371;
                                    } else {
                                        phi_3685_ = _e1394;
                                    }
                                    let _e1397 = phi_3685_;
                                    let _e1400 = local_12.member[0u];
                                    let _e1405 = local_12.member[1u];
                                    let _e1415 = (_e1400[0] + ((_e1405[0] - _e1400[0]) * _e1342));
                                    let _e1416 = (_e1400[1] + ((_e1405[1] - _e1400[1]) * _e1342));
                                    let _e1417 = (_e1400[2] + ((_e1405[2] - _e1400[2]) * _e1342));
                                    let _e1419 = local_12.member[1u];
                                    let _e1424 = local_12.member[0u];
                                    let _e1428 = (_e1419[0] - _e1424[0]);
                                    let _e1429 = (_e1419[1] - _e1424[1]);
                                    let _e1430 = (_e1419[2] - _e1424[2]);
                                    if (_e1428 < 0.0lf) {
                                        phi_3744_ = -(_e1428);
                                    } else {
                                        phi_3744_ = _e1428;
                                    }
                                    let _e1434 = phi_3744_;
                                    if (_e1429 < 0.0lf) {
                                        phi_3750_ = -(_e1429);
                                    } else {
                                        phi_3750_ = _e1429;
                                    }
                                    let _e1438 = phi_3750_;
                                    if (_e1434 > _e1438) {
                                        phi_3755_ = _e1434;
                                    } else {
                                        phi_3755_ = _e1438;
                                    }
                                    let _e1441 = phi_3755_;
                                    if (_e1430 < 0.0lf) {
                                        phi_3761_ = -(_e1430);
                                    } else {
                                        phi_3761_ = _e1430;
                                    }
                                    let _e1445 = phi_3761_;
                                    if (_e1441 > _e1445) {
                                        phi_3766_ = _e1441;
                                    } else {
                                        phi_3766_ = _e1445;
                                    }
                                    let _e1448 = phi_3766_;
                                    let _e1456 = ((((_e1345 * _e1448) * f64(1.01f)) + ((_e1397 + _e1347) * (1.1102230246251565e-16lf * f64(8f)))) + _e1347);
                                    if (_e1415 < 0.0lf) {
                                        phi_3780_ = -(_e1415);
                                    } else {
                                        phi_3780_ = _e1415;
                                    }
                                    let _e1460 = phi_3780_;
                                    if (_e1416 < 0.0lf) {
                                        phi_3786_ = -(_e1416);
                                    } else {
                                        phi_3786_ = _e1416;
                                    }
                                    let _e1464 = phi_3786_;
                                    if (_e1460 > _e1464) {
                                        phi_3791_ = _e1460;
                                    } else {
                                        phi_3791_ = _e1464;
                                    }
                                    let _e1467 = phi_3791_;
                                    if (_e1417 < 0.0lf) {
                                        phi_3797_ = -(_e1417);
                                    } else {
                                        phi_3797_ = _e1417;
                                    }
                                    let _e1471 = phi_3797_;
                                    if (_e1467 > _e1471) {
                                        phi_3802_ = _e1467;
                                    } else {
                                        phi_3802_ = _e1471;
                                    }
                                    let _e1474 = phi_3802_;
                                    local_2 = type_34(array<f64, 3>(_e1415, _e1416, _e1417), _e1456, (_e1474 + _e1456));
                                    let _e1480 = local_12.member_3;
                                    let _e1482 = local_12.member_1[0u];
                                    if (_e1482[0] < 0.0lf) {
                                        phi_3828_ = -(_e1482[0]);
                                    } else {
                                        phi_3828_ = _e1482[0];
                                    }
                                    let _e1489 = phi_3828_;
                                    if (_e1482[1] < 0.0lf) {
                                        phi_3835_ = -(_e1482[1]);
                                    } else {
                                        phi_3835_ = _e1482[1];
                                    }
                                    let _e1493 = phi_3835_;
                                    if (_e1489 > _e1493) {
                                        phi_3840_ = _e1489;
                                    } else {
                                        phi_3840_ = _e1493;
                                    }
                                    let _e1496 = phi_3840_;
                                    if (_e1482[2] < 0.0lf) {
                                        phi_3847_ = -(_e1482[2]);
                                    } else {
                                        phi_3847_ = _e1482[2];
                                    }
                                    let _e1500 = phi_3847_;
                                    if (_e1496 > _e1500) {
                                        phi_3852_ = _e1496;
                                    } else {
                                        phi_3852_ = _e1500;
                                    }
                                    let _e1503 = phi_3852_;
                                    let _e1505 = local_12.member_1[1u];
                                    if (_e1505[0] < 0.0lf) {
                                        phi_3865_ = -(_e1505[0]);
                                    } else {
                                        phi_3865_ = _e1505[0];
                                    }
                                    let _e1512 = phi_3865_;
                                    if (_e1505[1] < 0.0lf) {
                                        phi_3872_ = -(_e1505[1]);
                                    } else {
                                        phi_3872_ = _e1505[1];
                                    }
                                    let _e1516 = phi_3872_;
                                    if (_e1512 > _e1516) {
                                        phi_3877_ = _e1512;
                                    } else {
                                        phi_3877_ = _e1516;
                                    }
                                    let _e1519 = phi_3877_;
                                    if (_e1505[2] < 0.0lf) {
                                        phi_3884_ = -(_e1505[2]);
                                    } else {
                                        phi_3884_ = _e1505[2];
                                    }
                                    let _e1523 = phi_3884_;
                                    if (_e1519 > _e1523) {
                                        phi_3889_ = _e1519;
                                    } else {
                                        phi_3889_ = _e1523;
                                    }
                                    let _e1526 = phi_3889_;
                                    if (_e1503 > _e1526) {
                                        phi_3894_ = _e1503;
                                    } else {
                                        phi_3894_ = _e1526;
                                    }
                                    let _e1529 = phi_3894_;
                                    let _e1532 = local_12.member_1[0u];
                                    let _e1537 = local_12.member_1[1u];
                                    let _e1547 = (_e1532[0] + ((_e1537[0] - _e1532[0]) * _e1342));
                                    let _e1548 = (_e1532[1] + ((_e1537[1] - _e1532[1]) * _e1342));
                                    let _e1549 = (_e1532[2] + ((_e1537[2] - _e1532[2]) * _e1342));
                                    let _e1551 = local_12.member_1[1u];
                                    let _e1556 = local_12.member_1[0u];
                                    let _e1560 = (_e1551[0] - _e1556[0]);
                                    let _e1561 = (_e1551[1] - _e1556[1]);
                                    let _e1562 = (_e1551[2] - _e1556[2]);
                                    if (_e1560 < 0.0lf) {
                                        phi_3953_ = -(_e1560);
                                    } else {
                                        phi_3953_ = _e1560;
                                    }
                                    let _e1566 = phi_3953_;
                                    if (_e1561 < 0.0lf) {
                                        phi_3959_ = -(_e1561);
                                    } else {
                                        phi_3959_ = _e1561;
                                    }
                                    let _e1570 = phi_3959_;
                                    if (_e1566 > _e1570) {
                                        phi_3964_ = _e1566;
                                    } else {
                                        phi_3964_ = _e1570;
                                    }
                                    let _e1573 = phi_3964_;
                                    if (_e1562 < 0.0lf) {
                                        phi_3970_ = -(_e1562);
                                    } else {
                                        phi_3970_ = _e1562;
                                    }
                                    let _e1577 = phi_3970_;
                                    if (_e1573 > _e1577) {
                                        phi_3975_ = _e1573;
                                    } else {
                                        phi_3975_ = _e1577;
                                    }
                                    let _e1580 = phi_3975_;
                                    let _e1588 = ((((_e1345 * _e1580) * f64(1.01f)) + ((_e1529 + _e1480) * (1.1102230246251565e-16lf * f64(8f)))) + _e1480);
                                    if (_e1547 < 0.0lf) {
                                        phi_3989_ = -(_e1547);
                                    } else {
                                        phi_3989_ = _e1547;
                                    }
                                    let _e1592 = phi_3989_;
                                    if (_e1548 < 0.0lf) {
                                        phi_3995_ = -(_e1548);
                                    } else {
                                        phi_3995_ = _e1548;
                                    }
                                    let _e1596 = phi_3995_;
                                    if (_e1592 > _e1596) {
                                        phi_4000_ = _e1592;
                                    } else {
                                        phi_4000_ = _e1596;
                                    }
                                    let _e1599 = phi_4000_;
                                    if (_e1549 < 0.0lf) {
                                        phi_4006_ = -(_e1549);
                                    } else {
                                        phi_4006_ = _e1549;
                                    }
                                    let _e1603 = phi_4006_;
                                    if (_e1599 > _e1603) {
                                        phi_4011_ = _e1599;
                                    } else {
                                        phi_4011_ = _e1603;
                                    }
                                    let _e1606 = phi_4011_;
                                    local_3 = type_34(array<f64, 3>(_e1547, _e1548, _e1549), _e1588, (_e1606 + _e1588));
                                    let _e1612 = local_12.member_3;
                                    let _e1614 = local_12.member_2[0u];
                                    if (_e1614[0] < 0.0lf) {
                                        phi_4037_ = -(_e1614[0]);
                                    } else {
                                        phi_4037_ = _e1614[0];
                                    }
                                    let _e1621 = phi_4037_;
                                    if (_e1614[1] < 0.0lf) {
                                        phi_4044_ = -(_e1614[1]);
                                    } else {
                                        phi_4044_ = _e1614[1];
                                    }
                                    let _e1625 = phi_4044_;
                                    if (_e1621 > _e1625) {
                                        phi_4049_ = _e1621;
                                    } else {
                                        phi_4049_ = _e1625;
                                    }
                                    let _e1628 = phi_4049_;
                                    if (_e1614[2] < 0.0lf) {
                                        phi_4056_ = -(_e1614[2]);
                                    } else {
                                        phi_4056_ = _e1614[2];
                                    }
                                    let _e1632 = phi_4056_;
                                    if (_e1628 > _e1632) {
                                        phi_4061_ = _e1628;
                                    } else {
                                        phi_4061_ = _e1632;
                                    }
                                    let _e1635 = phi_4061_;
                                    let _e1637 = local_12.member_2[1u];
                                    if (_e1637[0] < 0.0lf) {
                                        phi_4074_ = -(_e1637[0]);
                                    } else {
                                        phi_4074_ = _e1637[0];
                                    }
                                    let _e1644 = phi_4074_;
                                    if (_e1637[1] < 0.0lf) {
                                        phi_4081_ = -(_e1637[1]);
                                    } else {
                                        phi_4081_ = _e1637[1];
                                    }
                                    let _e1648 = phi_4081_;
                                    if (_e1644 > _e1648) {
                                        phi_4086_ = _e1644;
                                    } else {
                                        phi_4086_ = _e1648;
                                    }
                                    let _e1651 = phi_4086_;
                                    if (_e1637[2] < 0.0lf) {
                                        phi_4093_ = -(_e1637[2]);
                                    } else {
                                        phi_4093_ = _e1637[2];
                                    }
                                    let _e1655 = phi_4093_;
                                    if (_e1651 > _e1655) {
                                        phi_4098_ = _e1651;
                                    } else {
                                        phi_4098_ = _e1655;
                                    }
                                    let _e1658 = phi_4098_;
                                    if (_e1635 > _e1658) {
                                        phi_4103_ = _e1635;
                                    } else {
                                        phi_4103_ = _e1658;
                                    }
                                    let _e1661 = phi_4103_;
                                    let _e1664 = local_12.member_2[0u];
                                    let _e1669 = local_12.member_2[1u];
                                    let _e1679 = (_e1664[0] + ((_e1669[0] - _e1664[0]) * _e1342));
                                    let _e1680 = (_e1664[1] + ((_e1669[1] - _e1664[1]) * _e1342));
                                    let _e1681 = (_e1664[2] + ((_e1669[2] - _e1664[2]) * _e1342));
                                    let _e1683 = local_12.member_2[1u];
                                    let _e1688 = local_12.member_2[0u];
                                    let _e1692 = (_e1683[0] - _e1688[0]);
                                    let _e1693 = (_e1683[1] - _e1688[1]);
                                    let _e1694 = (_e1683[2] - _e1688[2]);
                                    if (_e1692 < 0.0lf) {
                                        phi_4162_ = -(_e1692);
                                    } else {
                                        phi_4162_ = _e1692;
                                    }
                                    let _e1698 = phi_4162_;
                                    if (_e1693 < 0.0lf) {
                                        phi_4168_ = -(_e1693);
                                    } else {
                                        phi_4168_ = _e1693;
                                    }
                                    let _e1702 = phi_4168_;
                                    if (_e1698 > _e1702) {
                                        phi_4173_ = _e1698;
                                    } else {
                                        phi_4173_ = _e1702;
                                    }
                                    let _e1705 = phi_4173_;
                                    if (_e1694 < 0.0lf) {
                                        phi_4179_ = -(_e1694);
                                    } else {
                                        phi_4179_ = _e1694;
                                    }
                                    let _e1709 = phi_4179_;
                                    if (_e1705 > _e1709) {
                                        phi_4184_ = _e1705;
                                    } else {
                                        phi_4184_ = _e1709;
                                    }
                                    let _e1712 = phi_4184_;
                                    let _e1720 = ((((_e1345 * _e1712) * f64(1.01f)) + ((_e1661 + _e1612) * (1.1102230246251565e-16lf * f64(8f)))) + _e1612);
                                    if (_e1679 < 0.0lf) {
                                        phi_4198_ = -(_e1679);
                                    } else {
                                        phi_4198_ = _e1679;
                                    }
                                    let _e1724 = phi_4198_;
                                    if (_e1680 < 0.0lf) {
                                        phi_4204_ = -(_e1680);
                                    } else {
                                        phi_4204_ = _e1680;
                                    }
                                    let _e1728 = phi_4204_;
                                    if (_e1724 > _e1728) {
                                        phi_4209_ = _e1724;
                                    } else {
                                        phi_4209_ = _e1728;
                                    }
                                    let _e1731 = phi_4209_;
                                    if (_e1681 < 0.0lf) {
                                        phi_4215_ = -(_e1681);
                                    } else {
                                        phi_4215_ = _e1681;
                                    }
                                    let _e1735 = phi_4215_;
                                    if (_e1731 > _e1735) {
                                        phi_4220_ = _e1731;
                                    } else {
                                        phi_4220_ = _e1735;
                                    }
                                    let _e1738 = phi_4220_;
                                    local_4 = type_34(array<f64, 3>(_e1679, _e1680, _e1681), _e1720, (_e1738 + _e1720));
                                    let _e1743 = local_3.member;
                                    let _e1748 = local_4.member;
                                    let _e1754 = ((_e1743[1] * _e1748[2]) - (_e1743[2] * _e1748[1]));
                                    let _e1757 = ((_e1743[2] * _e1748[0]) - (_e1743[0] * _e1748[2]));
                                    let _e1760 = ((_e1743[0] * _e1748[1]) - (_e1743[1] * _e1748[0]));
                                    if (_e1754 < 0.0lf) {
                                        phi_4269_ = -(_e1754);
                                    } else {
                                        phi_4269_ = _e1754;
                                    }
                                    let _e1764 = phi_4269_;
                                    if (_e1757 < 0.0lf) {
                                        phi_4275_ = -(_e1757);
                                    } else {
                                        phi_4275_ = _e1757;
                                    }
                                    let _e1768 = phi_4275_;
                                    if (_e1764 > _e1768) {
                                        if (_e1754 < 0.0lf) {
                                            phi_4285_ = -(_e1754);
                                        } else {
                                            phi_4285_ = _e1754;
                                        }
                                        let _e1786 = phi_4285_;
                                        if (_e1760 < 0.0lf) {
                                            phi_4291_ = -(_e1760);
                                        } else {
                                            phi_4291_ = _e1760;
                                        }
                                        let _e1790 = phi_4291_;
                                        if (_e1786 > _e1790) {
                                            phi_4296_ = 2u;
                                            phi_4297_ = 1u;
                                        } else {
                                            phi_4296_ = 1u;
                                            phi_4297_ = 0u;
                                        }
                                        let _e1793 = phi_4296_;
                                        let _e1795 = phi_4297_;
                                        phi_4316_ = _e1793;
                                        phi_4317_ = _e1795;
                                    } else {
                                        if (_e1757 < 0.0lf) {
                                            phi_4303_ = -(_e1757);
                                        } else {
                                            phi_4303_ = _e1757;
                                        }
                                        let _e1773 = phi_4303_;
                                        if (_e1760 < 0.0lf) {
                                            phi_4309_ = -(_e1760);
                                        } else {
                                            phi_4309_ = _e1760;
                                        }
                                        let _e1777 = phi_4309_;
                                        if (_e1773 > _e1777) {
                                            phi_4314_ = 0u;
                                            phi_4315_ = 2u;
                                        } else {
                                            phi_4314_ = 1u;
                                            phi_4315_ = 0u;
                                        }
                                        let _e1780 = phi_4314_;
                                        let _e1782 = phi_4315_;
                                        phi_4316_ = _e1780;
                                        phi_4317_ = _e1782;
                                    }
                                    let _e1797 = phi_4316_;
                                    let _e1799 = phi_4317_;
                                    let _e1802 = local_3.member[_e1799];
                                    let _e1805 = local_4.member[_e1797];
                                    let _e1809 = local_3.member[_e1797];
                                    let _e1812 = local_4.member[_e1799];
                                    let _e1814 = ((_e1802 * _e1805) - (_e1809 * _e1812));
                                    let _e1815 = f64(1f);
                                    let _e1817 = local_3.member_1;
                                    let _e1819 = local_4.member_2;
                                    let _e1822 = local_3.member_2;
                                    let _e1824 = local_4.member_1;
                                    let _e1830 = local_3.member_2;
                                    let _e1832 = local_4.member_2;
                                    let _e1841 = local_3.member_2;
                                    let _e1844 = local_4.member_2;
                                    let _e1848 = (((((_e1817 * _e1819) + (_e1822 * _e1824)) * f64(2.01f)) + ((_e1830 * _e1832) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1815 + _e1841) * (_e1815 + _e1844))));
                                    if (_e1814 < 0.0lf) {
                                        phi_4388_ = -(_e1814);
                                    } else {
                                        phi_4388_ = _e1814;
                                    }
                                    let _e1852 = phi_4388_;
                                    if (_e1852 > _e1848) {
                                        if (_e1814 < f64(0f)) {
                                            phi_4400_ = f64(-1f);
                                        } else {
                                            phi_4400_ = f64(1f);
                                        }
                                        let _e1859 = phi_4400_;
                                        let _e1862 = local_2.member[_e1799];
                                        let _e1865 = local_4.member[_e1797];
                                        let _e1869 = local_2.member[_e1797];
                                        let _e1872 = local_4.member[_e1799];
                                        let _e1875 = f64(1f);
                                        let _e1877 = local_2.member_1;
                                        let _e1879 = local_4.member_2;
                                        let _e1882 = local_2.member_2;
                                        let _e1884 = local_4.member_1;
                                        let _e1890 = local_2.member_2;
                                        let _e1892 = local_4.member_2;
                                        let _e1901 = local_2.member_2;
                                        let _e1904 = local_4.member_2;
                                        let _e1908 = (((((_e1877 * _e1879) + (_e1882 * _e1884)) * f64(2.01f)) + ((_e1890 * _e1892) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1875 + _e1901) * (_e1875 + _e1904))));
                                        let _e1911 = local_3.member[_e1799];
                                        let _e1914 = local_2.member[_e1797];
                                        let _e1918 = local_3.member[_e1797];
                                        let _e1921 = local_2.member[_e1799];
                                        let _e1924 = f64(1f);
                                        let _e1926 = local_3.member_1;
                                        let _e1928 = local_2.member_2;
                                        let _e1931 = local_3.member_2;
                                        let _e1933 = local_2.member_1;
                                        let _e1939 = local_3.member_2;
                                        let _e1941 = local_2.member_2;
                                        let _e1950 = local_3.member_2;
                                        let _e1953 = local_2.member_2;
                                        let _e1957 = (((((_e1926 * _e1928) + (_e1931 * _e1933)) * f64(2.01f)) + ((_e1939 * _e1941) * (1.1102230246251565e-16lf * f64(8f)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1924 + _e1950) * (_e1924 + _e1953))));
                                        let _e1958 = (_e1814 * _e1859);
                                        let _e1959 = (((_e1862 * _e1865) - (_e1869 * _e1872)) * _e1859);
                                        let _e1960 = (((_e1911 * _e1914) - (_e1918 * _e1921)) * _e1859);
                                        if (_e1958 < 0.0lf) {
                                            phi_4539_ = -(_e1958);
                                        } else {
                                            phi_4539_ = _e1958;
                                        }
                                        let _e1964 = phi_4539_;
                                        if (_e1959 < 0.0lf) {
                                            phi_4545_ = -(_e1959);
                                        } else {
                                            phi_4545_ = _e1959;
                                        }
                                        let _e1968 = phi_4545_;
                                        if (_e1960 < 0.0lf) {
                                            phi_4552_ = -(_e1960);
                                        } else {
                                            phi_4552_ = _e1960;
                                        }
                                        let _e1973 = phi_4552_;
                                        let _e1977 = (((_e1964 + _e1968) + _e1973) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_5[0u].member = _e1959;
                                        local_5[0u].member_1 = _e1908;
                                        local_5[1u].member = _e1960;
                                        local_5[1u].member_1 = _e1957;
                                        local_5[2u].member = (_e1958 - _e1959);
                                        local_5[2u].member_1 = ((_e1848 + _e1908) + _e1977);
                                        local_5[3u].member = (_e1958 - _e1960);
                                        local_5[3u].member_1 = ((_e1848 + _e1957) + _e1977);
                                        phi_4596_ = type_9(0u, 4u);
                                        phi_4599_ = true;
                                        loop {
                                            let _e1998 = phi_4596_;
                                            let _e2000 = phi_4599_;
                                            local_17 = _e2000;
                                            if (_e1998.member < _e1998.member_1) {
                                                phi_4597_ = type_9((_e1998.member + 1u), _e1998.member_1);
                                                phi_4622_ = type_9(1u, _e1998.member);
                                            } else {
                                                phi_4597_ = _e1998;
                                                phi_4622_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2012 = phi_4597_;
                                            let _e2014 = phi_4622_;
                                            if (bitcast<i32>(_e2014.member) != 0i) {
                                                let _e2021 = local_5[_e2014.member_1].member;
                                                let _e2024 = local_5[_e2014.member_1].member_1;
                                                let _e2026 = (_e2021 < -(_e2024));
                                                if _e2026 {
                                                    phi_4649_ = bool();
                                                    phi_4650_ = false;
                                                } else {
                                                    phi_4649_ = (_e2000 && (_e2021 > _e2024));
                                                    phi_4650_ = true;
                                                }
                                                let _e2030 = phi_4649_;
                                                let _e2032 = phi_4650_;
                                                phi_4600_ = _e2030;
                                                phi_4651_ = _e2032;
                                                phi_4652_ = _e2026;
                                            } else {
                                                phi_4600_ = bool();
                                                phi_4651_ = false;
                                                phi_4652_ = false;
                                            }
                                            let _e2034 = phi_4600_;
                                            let _e2036 = phi_4651_;
                                            let _e2038 = phi_4652_;
                                            local_16 = _e2038;
                                            continue;
                                            continuing {
                                                phi_4596_ = _e2012;
                                                phi_4599_ = _e2034;
                                                break if !(_e2036);
                                            }
                                        }
                                        let _e2041 = local_16;
                                        if _e2041 {
                                            phi_4656_ = false;
                                        } else {
                                            phi_4656_ = true;
                                        }
                                        let _e2043 = phi_4656_;
                                        if _e2043 {
                                            let _e2045 = local_17;
                                            if _e2045 {
                                                phi_4663_ = 1u;
                                            } else {
                                                phi_4663_ = 2u;
                                            }
                                            let _e2047 = phi_4663_;
                                            phi_4664_ = _e2047;
                                            phi_4665_ = false;
                                        } else {
                                            phi_4664_ = u32();
                                            phi_4665_ = true;
                                        }
                                        let _e2049 = phi_4664_;
                                        let _e2051 = phi_4665_;
                                        phi_4666_ = _e2049;
                                        phi_4667_ = 0u;
                                        phi_4668_ = _e2051;
                                    } else {
                                        phi_4666_ = u32();
                                        phi_4667_ = 2u;
                                        phi_4668_ = true;
                                    }
                                    let _e2053 = phi_4666_;
                                    let _e2055 = phi_4667_;
                                    let _e2057 = phi_4668_;
                                    if _e2057 {
                                        phi_4672_ = _e2055;
                                    } else {
                                        phi_4672_ = _e2053;
                                    }
                                    let _e2059 = phi_4672_;
                                    let _e2060 = (_e2059 == 0u);
                                    if _e2060 {
                                        phi_5729_ = f64();
                                        phi_5730_ = false;
                                        phi_5731_ = false;
                                        phi_5732_ = false;
                                    } else {
                                        if (_e2059 == 1u) {
                                            if _e1333.member_2 {
                                                if ((_e1333.member_1 - _e1333.member) <= f64(0.0000005f)) {
                                                    phi_4693_ = false;
                                                } else {
                                                    phi_4693_ = true;
                                                }
                                                let _e2069 = phi_4693_;
                                                phi_4694_ = _e2069;
                                            } else {
                                                phi_4694_ = true;
                                            }
                                            let _e2071 = phi_4694_;
                                            phi_4695_ = _e2071;
                                        } else {
                                            phi_4695_ = true;
                                        }
                                        let _e2073 = phi_4695_;
                                        if _e2073 {
                                            let _e2079 = local_12.member[0u];
                                            let _e2085 = local_12.member_1[0u];
                                            let _e2091 = local_12.member_2[0u];
                                            let _e2095 = (_e2079[0] - _e2085[0]);
                                            let _e2096 = (_e2079[1] - _e2085[1]);
                                            let _e2097 = (_e2079[2] - _e2085[2]);
                                            local = array<array<f64, 3>, 4>(_e2079, array<f64, 3>(_e2095, _e2096, _e2097), array<f64, 3>((_e2079[0] - _e2091[0]), (_e2079[1] - _e2091[1]), (_e2079[2] - _e2091[2])), array<f64, 3>((_e2095 - _e2091[0]), (_e2096 - _e2091[1]), (_e2097 - _e2091[2])));
                                            let _e2110 = local_12.member[1u];
                                            let _e2116 = local_12.member_1[1u];
                                            let _e2122 = local_12.member_2[1u];
                                            let _e2126 = (_e2110[0] - _e2116[0]);
                                            let _e2127 = (_e2110[1] - _e2116[1]);
                                            let _e2128 = (_e2110[2] - _e2116[2]);
                                            local_1 = array<array<f64, 3>, 4>(_e2110, array<f64, 3>(_e2126, _e2127, _e2128), array<f64, 3>((_e2110[0] - _e2122[0]), (_e2110[1] - _e2122[1]), (_e2110[2] - _e2122[2])), array<f64, 3>((_e2126 - _e2122[0]), (_e2127 - _e2122[1]), (_e2128 - _e2122[2])));
                                            let _e2141 = local_12.member[0u];
                                            if (_e2141[0] < 0.0lf) {
                                                phi_4892_ = -(_e2141[0]);
                                            } else {
                                                phi_4892_ = _e2141[0];
                                            }
                                            let _e2148 = phi_4892_;
                                            if (_e2141[1] < 0.0lf) {
                                                phi_4899_ = -(_e2141[1]);
                                            } else {
                                                phi_4899_ = _e2141[1];
                                            }
                                            let _e2152 = phi_4899_;
                                            if (_e2148 > _e2152) {
                                                phi_4904_ = _e2148;
                                            } else {
                                                phi_4904_ = _e2152;
                                            }
                                            let _e2155 = phi_4904_;
                                            if (_e2141[2] < 0.0lf) {
                                                phi_4911_ = -(_e2141[2]);
                                            } else {
                                                phi_4911_ = _e2141[2];
                                            }
                                            let _e2159 = phi_4911_;
                                            if (_e2155 > _e2159) {
                                                phi_4916_ = _e2155;
                                            } else {
                                                phi_4916_ = _e2159;
                                            }
                                            let _e2162 = phi_4916_;
                                            let _e2165 = local_12.member[1u];
                                            if (_e2165[0] < 0.0lf) {
                                                phi_4929_ = -(_e2165[0]);
                                            } else {
                                                phi_4929_ = _e2165[0];
                                            }
                                            let _e2172 = phi_4929_;
                                            if (_e2165[1] < 0.0lf) {
                                                phi_4936_ = -(_e2165[1]);
                                            } else {
                                                phi_4936_ = _e2165[1];
                                            }
                                            let _e2176 = phi_4936_;
                                            if (_e2172 > _e2176) {
                                                phi_4941_ = _e2172;
                                            } else {
                                                phi_4941_ = _e2176;
                                            }
                                            let _e2179 = phi_4941_;
                                            if (_e2165[2] < 0.0lf) {
                                                phi_4948_ = -(_e2165[2]);
                                            } else {
                                                phi_4948_ = _e2165[2];
                                            }
                                            let _e2183 = phi_4948_;
                                            if (_e2179 > _e2183) {
                                                phi_4953_ = _e2179;
                                            } else {
                                                phi_4953_ = _e2183;
                                            }
                                            let _e2186 = phi_4953_;
                                            if (_e2162 > _e2186) {
                                                phi_4958_ = _e2162;
                                            } else {
                                                phi_4958_ = _e2186;
                                            }
                                            let _e2189 = phi_4958_;
                                            let _e2191 = local_12.member_3;
                                            let _e2195 = local_12.member_1[0u];
                                            if (_e2195[0] < 0.0lf) {
                                                phi_4975_ = -(_e2195[0]);
                                            } else {
                                                phi_4975_ = _e2195[0];
                                            }
                                            let _e2202 = phi_4975_;
                                            if (_e2195[1] < 0.0lf) {
                                                phi_4982_ = -(_e2195[1]);
                                            } else {
                                                phi_4982_ = _e2195[1];
                                            }
                                            let _e2206 = phi_4982_;
                                            if (_e2202 > _e2206) {
                                                phi_4987_ = _e2202;
                                            } else {
                                                phi_4987_ = _e2206;
                                            }
                                            let _e2209 = phi_4987_;
                                            if (_e2195[2] < 0.0lf) {
                                                phi_4994_ = -(_e2195[2]);
                                            } else {
                                                phi_4994_ = _e2195[2];
                                            }
                                            let _e2213 = phi_4994_;
                                            if (_e2209 > _e2213) {
                                                phi_4999_ = _e2209;
                                            } else {
                                                phi_4999_ = _e2213;
                                            }
                                            let _e2216 = phi_4999_;
                                            let _e2219 = local_12.member_1[1u];
                                            if (_e2219[0] < 0.0lf) {
                                                phi_5013_ = -(_e2219[0]);
                                            } else {
                                                phi_5013_ = _e2219[0];
                                            }
                                            let _e2226 = phi_5013_;
                                            if (_e2219[1] < 0.0lf) {
                                                phi_5020_ = -(_e2219[1]);
                                            } else {
                                                phi_5020_ = _e2219[1];
                                            }
                                            let _e2230 = phi_5020_;
                                            if (_e2226 > _e2230) {
                                                phi_5025_ = _e2226;
                                            } else {
                                                phi_5025_ = _e2230;
                                            }
                                            let _e2233 = phi_5025_;
                                            if (_e2219[2] < 0.0lf) {
                                                phi_5032_ = -(_e2219[2]);
                                            } else {
                                                phi_5032_ = _e2219[2];
                                            }
                                            let _e2237 = phi_5032_;
                                            if (_e2233 > _e2237) {
                                                phi_5037_ = _e2233;
                                            } else {
                                                phi_5037_ = _e2237;
                                            }
                                            let _e2240 = phi_5037_;
                                            if (_e2216 > _e2240) {
                                                phi_5042_ = _e2216;
                                            } else {
                                                phi_5042_ = _e2240;
                                            }
                                            let _e2243 = phi_5042_;
                                            let _e2245 = local_12.member_3;
                                            let _e2249 = local_12.member_2[0u];
                                            if (_e2249[0] < 0.0lf) {
                                                phi_5059_ = -(_e2249[0]);
                                            } else {
                                                phi_5059_ = _e2249[0];
                                            }
                                            let _e2256 = phi_5059_;
                                            if (_e2249[1] < 0.0lf) {
                                                phi_5066_ = -(_e2249[1]);
                                            } else {
                                                phi_5066_ = _e2249[1];
                                            }
                                            let _e2260 = phi_5066_;
                                            if (_e2256 > _e2260) {
                                                phi_5071_ = _e2256;
                                            } else {
                                                phi_5071_ = _e2260;
                                            }
                                            let _e2263 = phi_5071_;
                                            if (_e2249[2] < 0.0lf) {
                                                phi_5078_ = -(_e2249[2]);
                                            } else {
                                                phi_5078_ = _e2249[2];
                                            }
                                            let _e2267 = phi_5078_;
                                            if (_e2263 > _e2267) {
                                                phi_5083_ = _e2263;
                                            } else {
                                                phi_5083_ = _e2267;
                                            }
                                            let _e2270 = phi_5083_;
                                            let _e2273 = local_12.member_2[1u];
                                            if (_e2273[0] < 0.0lf) {
                                                phi_5097_ = -(_e2273[0]);
                                            } else {
                                                phi_5097_ = _e2273[0];
                                            }
                                            let _e2280 = phi_5097_;
                                            if (_e2273[1] < 0.0lf) {
                                                phi_5104_ = -(_e2273[1]);
                                            } else {
                                                phi_5104_ = _e2273[1];
                                            }
                                            let _e2284 = phi_5104_;
                                            if (_e2280 > _e2284) {
                                                phi_5109_ = _e2280;
                                            } else {
                                                phi_5109_ = _e2284;
                                            }
                                            let _e2287 = phi_5109_;
                                            if (_e2273[2] < 0.0lf) {
                                                phi_5116_ = -(_e2273[2]);
                                            } else {
                                                phi_5116_ = _e2273[2];
                                            }
                                            let _e2291 = phi_5116_;
                                            if (_e2287 > _e2291) {
                                                phi_5121_ = _e2287;
                                            } else {
                                                phi_5121_ = _e2291;
                                            }
                                            let _e2294 = phi_5121_;
                                            if (_e2270 > _e2294) {
                                                phi_5126_ = _e2270;
                                            } else {
                                                phi_5126_ = _e2294;
                                            }
                                            let _e2297 = phi_5126_;
                                            let _e2299 = local_12.member_3;
                                            let _e2307 = local_12.member_3;
                                            phi_5146_ = type_9(0u, 48u);
                                            phi_5149_ = _e1333.member;
                                            loop {
                                                let _e2316 = phi_5146_;
                                                let _e2318 = phi_5149_;
                                                local_61 = _e2318;
                                                local_24 = _e2318;
                                                local_25 = _e2318;
                                                local_26 = _e2318;
                                                local_27 = _e2318;
                                                if (_e2316.member < _e2316.member_1) {
                                                    phi_5147_ = type_9((_e2316.member + 1u), _e2316.member_1);
                                                    phi_5172_ = type_9(1u, _e2316.member);
                                                } else {
                                                    phi_5147_ = _e2316;
                                                    phi_5172_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2330 = phi_5147_;
                                                let _e2332 = phi_5172_;
                                                if (bitcast<i32>(_e2332.member) != 0i) {
                                                    let _e2338 = local_12.member[0u];
                                                    let _e2344 = local_12.member[1u];
                                                    let _e2360 = local_12.member_1[0u];
                                                    let _e2366 = local_12.member_1[1u];
                                                    let _e2382 = local_12.member_2[0u];
                                                    let _e2388 = local_12.member_2[1u];
                                                    let _e2402 = function_2(array<f64, 3>((_e2338[0] + ((_e2344[0] - _e2338[0]) * _e2318)), (_e2338[1] + ((_e2344[1] - _e2338[1]) * _e2318)), (_e2338[2] + ((_e2344[2] - _e2338[2]) * _e2318))), array<f64, 3>((_e2360[0] + ((_e2366[0] - _e2360[0]) * _e2318)), (_e2360[1] + ((_e2366[1] - _e2360[1]) * _e2318)), (_e2360[2] + ((_e2366[2] - _e2360[2]) * _e2318))), array<f64, 3>((_e2382[0] + ((_e2388[0] - _e2382[0]) * _e2318)), (_e2382[1] + ((_e2388[1] - _e2382[1]) * _e2318)), (_e2382[2] + ((_e2388[2] - _e2382[2]) * _e2318))), 1u);
                                                    if (_e2402[0] < 0.0lf) {
                                                        phi_5283_ = -(_e2402[0]);
                                                    } else {
                                                        phi_5283_ = _e2402[0];
                                                    }
                                                    let _e2407 = phi_5283_;
                                                    if (_e2402[1] < 0.0lf) {
                                                        phi_5290_ = -(_e2402[1]);
                                                    } else {
                                                        phi_5290_ = _e2402[1];
                                                    }
                                                    let _e2412 = phi_5290_;
                                                    if (_e2402[2] < 0.0lf) {
                                                        phi_5298_ = -(_e2402[2]);
                                                    } else {
                                                        phi_5298_ = _e2402[2];
                                                    }
                                                    let _e2418 = phi_5298_;
                                                    let _e2419 = ((_e2407 + _e2412) + _e2418);
                                                    if (_e2419 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2419) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2425 = (f64(1f) / _e2419);
                                                            let _e2427 = (_e2402[0] * _e2425);
                                                            let _e2429 = (_e2402[1] * _e2425);
                                                            let _e2431 = (_e2402[2] * _e2425);
                                                            let _e2436 = (((_e2427 * _e2427) + (_e2429 * _e2429)) + (_e2431 * _e2431));
                                                            if (_e2436 <= 2.2250738585072014e-308lf) {
                                                                if (_e2436 > 0.0lf) {
                                                                    phi_5336_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_5336_ = 0.0lf;
                                                                }
                                                                let _e2488 = phi_5336_;
                                                                phi_5400_ = _e2488;
                                                            } else {
                                                                phi_5343_ = type_16(0i, 5i);
                                                                phi_5346_ = bitcast<f64>(((bitcast<u64>(_e2436) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2443 = phi_5343_;
                                                                    let _e2445 = phi_5346_;
                                                                    local_18 = _e2445;
                                                                    if (_e2443.member < _e2443.member_1) {
                                                                        let _e2452 = (_e2443.member + 1i);
                                                                        if ((false == (_e2452 > _e2443.member)) != false) {
                                                                            phi_5367_ = true;
                                                                        } else {
                                                                            phi_5367_ = false;
                                                                        }
                                                                        let _e2457 = phi_5367_;
                                                                        if _e2457 {
                                                                            phi_5373_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_5373_ = type_17(1u, _e2452);
                                                                        }
                                                                        let _e2462 = phi_5373_;
                                                                        phi_5344_ = type_16(_e2462.member_1, _e2443.member_1);
                                                                        phi_5387_ = type_17(1u, _e2443.member);
                                                                    } else {
                                                                        phi_5344_ = _e2443;
                                                                        phi_5387_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2468 = phi_5344_;
                                                                    let _e2470 = phi_5387_;
                                                                    let _e2473 = (bitcast<i32>(_e2470.member) != 0i);
                                                                    if _e2473 {
                                                                        phi_5347_ = (0.5lf * (_e2445 + (_e2436 / _e2445)));
                                                                    } else {
                                                                        phi_5347_ = f64();
                                                                    }
                                                                    let _e2478 = phi_5347_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_5343_ = _e2468;
                                                                        phi_5346_ = _e2478;
                                                                        break if !(_e2473);
                                                                    }
                                                                }
                                                                let _e2483 = local_18;
                                                                phi_5400_ = (_e2483 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2490 = phi_5400_;
                                                            phi_5413_ = type_9(0u, 4u);
                                                            phi_5416_ = f64(2f);
                                                            loop {
                                                                let _e2502 = phi_5413_;
                                                                let _e2504 = phi_5416_;
                                                                local_20 = _e2504;
                                                                local_21 = _e2504;
                                                                local_22 = _e2504;
                                                                local_51 = _e2504;
                                                                local_52 = _e2504;
                                                                if (_e2502.member < _e2502.member_1) {
                                                                    phi_5414_ = type_9((_e2502.member + 1u), _e2502.member_1);
                                                                    phi_5439_ = type_9(1u, _e2502.member);
                                                                } else {
                                                                    phi_5414_ = _e2502;
                                                                    phi_5439_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e2516 = phi_5414_;
                                                                let _e2518 = phi_5439_;
                                                                if (bitcast<i32>(_e2518.member) != 0i) {
                                                                    let _e2524 = local[_e2518.member_1];
                                                                    let _e2532 = (((_e2427 * _e2524[0]) + (_e2429 * _e2524[1])) + (_e2431 * _e2524[2]));
                                                                    let _e2534 = local_1[_e2518.member_1];
                                                                    let _e2542 = (((_e2427 * _e2534[0]) + (_e2429 * _e2534[1])) + (_e2431 * _e2534[2]));
                                                                    if (_e2532 < 0.0lf) {
                                                                        phi_5490_ = -(_e2532);
                                                                    } else {
                                                                        phi_5490_ = _e2532;
                                                                    }
                                                                    let _e2546 = phi_5490_;
                                                                    if (_e2542 < 0.0lf) {
                                                                        phi_5496_ = -(_e2542);
                                                                    } else {
                                                                        phi_5496_ = _e2542;
                                                                    }
                                                                    let _e2550 = phi_5496_;
                                                                    let _e2555 = (((((((((_e2189 + _e2191) + (_e2243 + _e2245)) + (_e2297 + _e2299)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2307 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2490) * (f64(1f) + (1.1102230246251565e-16lf * f64(8f))))) + ((_e2546 + _e2550) * (1.1102230246251565e-16lf * f64(8f))));
                                                                    if (_e2532 > _e2555) {
                                                                        if (_e2542 > _e2555) {
                                                                            phi_5510_ = false;
                                                                        } else {
                                                                            phi_5510_ = true;
                                                                        }
                                                                        let _e2559 = phi_5510_;
                                                                        phi_5511_ = _e2559;
                                                                    } else {
                                                                        phi_5511_ = true;
                                                                    }
                                                                    let _e2561 = phi_5511_;
                                                                    if _e2561 {
                                                                        if ((_e2532 + ((_e2542 - _e2532) * _e2318)) > _e2555) {
                                                                            if (_e2542 < _e2532) {
                                                                                let _e2570 = ((_e2532 - _e2542) <= (f64(0.25f) / 2.2250738585072014e-308lf));
                                                                                if _e2570 {
                                                                                    let _e2578 = (((_e2532 - _e2555) / (_e2532 - _e2542)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    if (_e2504 < _e2578) {
                                                                                        phi_5545_ = _e2504;
                                                                                    } else {
                                                                                        phi_5545_ = _e2578;
                                                                                    }
                                                                                    let _e2581 = phi_5545_;
                                                                                    phi_5546_ = _e2581;
                                                                                } else {
                                                                                    phi_5546_ = f64();
                                                                                }
                                                                                let _e2583 = phi_5546_;
                                                                                phi_5547_ = _e2583;
                                                                                phi_5548_ = _e2570;
                                                                            } else {
                                                                                phi_5547_ = _e2504;
                                                                                phi_5548_ = true;
                                                                            }
                                                                            let _e2585 = phi_5547_;
                                                                            let _e2587 = phi_5548_;
                                                                            if _e2587 {
                                                                                phi_5552_ = false;
                                                                            } else {
                                                                                phi_5552_ = true;
                                                                            }
                                                                            let _e2589 = phi_5552_;
                                                                            phi_5553_ = _e2585;
                                                                            phi_5554_ = _e2587;
                                                                            phi_5555_ = _e2589;
                                                                            phi_5556_ = false;
                                                                        } else {
                                                                            phi_5553_ = f64();
                                                                            phi_5554_ = false;
                                                                            phi_5555_ = false;
                                                                            phi_5556_ = true;
                                                                        }
                                                                        let _e2591 = phi_5553_;
                                                                        let _e2593 = phi_5554_;
                                                                        let _e2595 = phi_5555_;
                                                                        let _e2597 = phi_5556_;
                                                                        phi_5557_ = _e2591;
                                                                        phi_5558_ = _e2593;
                                                                        phi_5559_ = _e2595;
                                                                        phi_5560_ = _e2597;
                                                                    } else {
                                                                        phi_5557_ = _e2504;
                                                                        phi_5558_ = true;
                                                                        phi_5559_ = false;
                                                                        phi_5560_ = false;
                                                                    }
                                                                    let _e2599 = phi_5557_;
                                                                    let _e2601 = phi_5558_;
                                                                    let _e2603 = phi_5559_;
                                                                    let _e2605 = phi_5560_;
                                                                    phi_5417_ = _e2599;
                                                                    phi_5561_ = _e2601;
                                                                    phi_5562_ = false;
                                                                    phi_5563_ = _e2603;
                                                                    phi_5564_ = _e2605;
                                                                } else {
                                                                    phi_5417_ = f64();
                                                                    phi_5561_ = false;
                                                                    phi_5562_ = true;
                                                                    phi_5563_ = false;
                                                                    phi_5564_ = false;
                                                                }
                                                                let _e2607 = phi_5417_;
                                                                let _e2609 = phi_5561_;
                                                                let _e2611 = phi_5562_;
                                                                let _e2613 = phi_5563_;
                                                                let _e2615 = phi_5564_;
                                                                local_19 = _e2611;
                                                                local_49 = _e2613;
                                                                local_50 = _e2615;
                                                                continue;
                                                                continuing {
                                                                    phi_5413_ = _e2516;
                                                                    phi_5416_ = _e2607;
                                                                    break if !(_e2609);
                                                                }
                                                            }
                                                            let _e2618 = local_19;
                                                            if _e2618 {
                                                                let _e2620 = local_20;
                                                                let _e2621 = (_e2620 > _e1333.member_1);
                                                                if _e2621 {
                                                                    phi_5586_ = false;
                                                                    phi_5587_ = false;
                                                                    phi_5588_ = false;
                                                                } else {
                                                                    let _e2623 = local_21;
                                                                    if (_e2623 > _e2318) {
                                                                        let _e2626 = local_22;
                                                                        let _e2629 = ((_e2626 - _e2318) < f64(0.00000000023283064f));
                                                                        if _e2629 {
                                                                            phi_5582_ = false;
                                                                        } else {
                                                                            phi_5582_ = true;
                                                                        }
                                                                        let _e2631 = phi_5582_;
                                                                        phi_5583_ = _e2631;
                                                                        phi_5584_ = _e2629;
                                                                        phi_5585_ = false;
                                                                    } else {
                                                                        phi_5583_ = false;
                                                                        phi_5584_ = false;
                                                                        phi_5585_ = true;
                                                                    }
                                                                    let _e2633 = phi_5583_;
                                                                    let _e2635 = phi_5584_;
                                                                    let _e2637 = phi_5585_;
                                                                    phi_5586_ = _e2633;
                                                                    phi_5587_ = _e2635;
                                                                    phi_5588_ = _e2637;
                                                                }
                                                                let _e2639 = phi_5586_;
                                                                let _e2641 = phi_5587_;
                                                                let _e2643 = phi_5588_;
                                                                phi_5589_ = _e2639;
                                                                phi_5590_ = _e2621;
                                                                phi_5591_ = _e2641;
                                                                phi_5592_ = _e2643;
                                                                phi_5593_ = false;
                                                                phi_5594_ = false;
                                                            } else {
                                                                phi_5589_ = false;
                                                                phi_5590_ = false;
                                                                phi_5591_ = false;
                                                                phi_5592_ = false;
                                                                let _e4511 = local_49;
                                                                phi_5593_ = _e4511;
                                                                let _e4514 = local_50;
                                                                phi_5594_ = _e4514;
                                                            }
                                                            let _e2645 = phi_5589_;
                                                            let _e2647 = phi_5590_;
                                                            let _e2649 = phi_5591_;
                                                            let _e2651 = phi_5592_;
                                                            let _e2653 = phi_5593_;
                                                            let _e2655 = phi_5594_;
                                                            let _e4517 = local_51;
                                                            phi_5595_ = _e4517;
                                                            let _e4520 = local_52;
                                                            phi_5596_ = _e4520;
                                                            phi_5597_ = _e2645;
                                                            phi_5598_ = _e2647;
                                                            phi_5599_ = _e2649;
                                                            phi_5600_ = _e2651;
                                                            phi_5601_ = _e2653;
                                                            phi_5602_ = _e2655;
                                                            phi_5603_ = false;
                                                        } else {
                                                            phi_5595_ = f64();
                                                            phi_5596_ = f64();
                                                            phi_5597_ = false;
                                                            phi_5598_ = false;
                                                            phi_5599_ = false;
                                                            phi_5600_ = false;
                                                            phi_5601_ = false;
                                                            phi_5602_ = false;
                                                            phi_5603_ = true;
                                                        }
                                                        let _e2657 = phi_5595_;
                                                        let _e2659 = phi_5596_;
                                                        let _e2661 = phi_5597_;
                                                        let _e2663 = phi_5598_;
                                                        let _e2665 = phi_5599_;
                                                        let _e2667 = phi_5600_;
                                                        let _e2669 = phi_5601_;
                                                        let _e2671 = phi_5602_;
                                                        let _e2673 = phi_5603_;
                                                        phi_5604_ = _e2657;
                                                        phi_5605_ = _e2659;
                                                        phi_5606_ = _e2661;
                                                        phi_5607_ = _e2663;
                                                        phi_5608_ = _e2665;
                                                        phi_5609_ = _e2667;
                                                        phi_5610_ = _e2669;
                                                        phi_5611_ = _e2671;
                                                        phi_5612_ = _e2673;
                                                        phi_5613_ = false;
                                                    } else {
                                                        phi_5604_ = f64();
                                                        phi_5605_ = f64();
                                                        phi_5606_ = false;
                                                        phi_5607_ = false;
                                                        phi_5608_ = false;
                                                        phi_5609_ = false;
                                                        phi_5610_ = false;
                                                        phi_5611_ = false;
                                                        phi_5612_ = false;
                                                        phi_5613_ = true;
                                                    }
                                                    let _e2675 = phi_5604_;
                                                    let _e2677 = phi_5605_;
                                                    let _e2679 = phi_5606_;
                                                    let _e2681 = phi_5607_;
                                                    let _e2683 = phi_5608_;
                                                    let _e2685 = phi_5609_;
                                                    let _e2687 = phi_5610_;
                                                    let _e2689 = phi_5611_;
                                                    let _e2691 = phi_5612_;
                                                    let _e2693 = phi_5613_;
                                                    phi_5614_ = _e2675;
                                                    phi_5150_ = _e2677;
                                                    phi_5615_ = _e2679;
                                                    phi_5616_ = _e2681;
                                                    phi_5617_ = _e2683;
                                                    phi_5618_ = false;
                                                    phi_5619_ = _e2685;
                                                    phi_5620_ = _e2687;
                                                    phi_5621_ = _e2689;
                                                    phi_5622_ = _e2691;
                                                    phi_5623_ = _e2693;
                                                } else {
                                                    phi_5614_ = f64();
                                                    phi_5150_ = f64();
                                                    phi_5615_ = false;
                                                    phi_5616_ = false;
                                                    phi_5617_ = false;
                                                    phi_5618_ = true;
                                                    phi_5619_ = false;
                                                    phi_5620_ = false;
                                                    phi_5621_ = false;
                                                    phi_5622_ = false;
                                                    phi_5623_ = false;
                                                }
                                                let _e2695 = phi_5614_;
                                                let _e2697 = phi_5150_;
                                                let _e2699 = phi_5615_;
                                                let _e2701 = phi_5616_;
                                                let _e2703 = phi_5617_;
                                                let _e2705 = phi_5618_;
                                                let _e2707 = phi_5619_;
                                                let _e2709 = phi_5620_;
                                                let _e2711 = phi_5621_;
                                                let _e2713 = phi_5622_;
                                                let _e2715 = phi_5623_;
                                                local_23 = _e2701;
                                                local_53 = _e2703;
                                                local_54 = _e2705;
                                                local_55 = _e2707;
                                                local_56 = _e2709;
                                                local_57 = _e2711;
                                                local_58 = _e2713;
                                                local_59 = _e2715;
                                                local_60 = _e2695;
                                                local_62 = _e2701;
                                                continue;
                                                continuing {
                                                    phi_5146_ = _e2330;
                                                    phi_5149_ = _e2697;
                                                    break if !(_e2699);
                                                }
                                            }
                                            let _e2718 = local_23;
                                            if _e2718 {
                                                phi_5628_ = type_42(0u, type_42().member_1);
                                                phi_5629_ = false;
                                                phi_5630_ = false;
                                                phi_5631_ = false;
                                                phi_5632_ = false;
                                                phi_5633_ = false;
                                                phi_5634_ = false;
                                                phi_5635_ = false;
                                            } else {
                                                phi_5628_ = type_42();
                                                let _e4553 = local_53;
                                                phi_5629_ = _e4553;
                                                let _e4556 = local_54;
                                                phi_5630_ = _e4556;
                                                let _e4559 = local_55;
                                                phi_5631_ = _e4559;
                                                let _e4562 = local_56;
                                                phi_5632_ = _e4562;
                                                let _e4565 = local_57;
                                                phi_5633_ = _e4565;
                                                let _e4568 = local_58;
                                                phi_5634_ = _e4568;
                                                let _e4571 = local_59;
                                                phi_5635_ = _e4571;
                                            }
                                            let _e2722 = phi_5628_;
                                            let _e2724 = phi_5629_;
                                            let _e2726 = phi_5630_;
                                            let _e2728 = phi_5631_;
                                            let _e2730 = phi_5632_;
                                            let _e2732 = phi_5633_;
                                            let _e2734 = phi_5634_;
                                            let _e2736 = phi_5635_;
                                            if _e2724 {
                                                let _e4574 = local_60;
                                                phi_5639_ = _e4574;
                                                phi_5640_ = true;
                                                phi_5641_ = false;
                                                phi_5642_ = false;
                                                phi_5643_ = false;
                                                phi_5644_ = false;
                                                phi_5645_ = false;
                                                phi_5646_ = false;
                                            } else {
                                                let _e4576 = local_61;
                                                phi_5639_ = _e4576;
                                                phi_5640_ = _e2726;
                                                phi_5641_ = _e2728;
                                                phi_5642_ = _e2730;
                                                phi_5643_ = _e2732;
                                                let _e4583 = local_62;
                                                phi_5644_ = _e4583;
                                                phi_5645_ = _e2734;
                                                phi_5646_ = _e2736;
                                            }
                                            let _e2738 = phi_5639_;
                                            let _e2740 = phi_5640_;
                                            let _e2742 = phi_5641_;
                                            let _e2744 = phi_5642_;
                                            let _e2746 = phi_5643_;
                                            let _e2748 = phi_5644_;
                                            let _e2750 = phi_5645_;
                                            let _e2752 = phi_5646_;
                                            if _e2740 {
                                                phi_5651_ = type_42(1u, _e2738);
                                                phi_5652_ = false;
                                                phi_5653_ = false;
                                                phi_5654_ = false;
                                                phi_5655_ = false;
                                                phi_5656_ = false;
                                                phi_5657_ = false;
                                            } else {
                                                phi_5651_ = type_42();
                                                phi_5652_ = _e2742;
                                                phi_5653_ = _e2744;
                                                phi_5654_ = _e2746;
                                                phi_5655_ = _e2748;
                                                phi_5656_ = _e2750;
                                                phi_5657_ = _e2752;
                                            }
                                            let _e2755 = phi_5651_;
                                            let _e2757 = phi_5652_;
                                            let _e2759 = phi_5653_;
                                            let _e2761 = phi_5654_;
                                            let _e2763 = phi_5655_;
                                            let _e2765 = phi_5656_;
                                            let _e2767 = phi_5657_;
                                            if _e2757 {
                                                let _e2769 = local_24;
                                                phi_5662_ = type_42(1u, _e2769);
                                                phi_5663_ = false;
                                                phi_5664_ = false;
                                                phi_5665_ = true;
                                                phi_5666_ = false;
                                                phi_5667_ = false;
                                            } else {
                                                phi_5662_ = _e2722;
                                                phi_5663_ = _e2759;
                                                phi_5664_ = _e2761;
                                                phi_5665_ = _e2763;
                                                phi_5666_ = _e2765;
                                                phi_5667_ = _e2767;
                                            }
                                            let _e2772 = phi_5662_;
                                            let _e2774 = phi_5663_;
                                            let _e2776 = phi_5664_;
                                            let _e2778 = phi_5665_;
                                            let _e2780 = phi_5666_;
                                            let _e2782 = phi_5667_;
                                            if _e2774 {
                                                let _e2784 = local_25;
                                                phi_5672_ = type_42(1u, _e2784);
                                                phi_5673_ = false;
                                                phi_5674_ = false;
                                                phi_5675_ = false;
                                                phi_5676_ = false;
                                            } else {
                                                phi_5672_ = type_42();
                                                phi_5673_ = _e2776;
                                                phi_5674_ = _e2778;
                                                phi_5675_ = _e2780;
                                                phi_5676_ = _e2782;
                                            }
                                            let _e2787 = phi_5672_;
                                            let _e2789 = phi_5673_;
                                            let _e2791 = phi_5674_;
                                            let _e2793 = phi_5675_;
                                            let _e2795 = phi_5676_;
                                            if _e2789 {
                                                let _e2797 = local_26;
                                                phi_5681_ = type_42(1u, _e2797);
                                                phi_5682_ = true;
                                                phi_5683_ = false;
                                                phi_5684_ = false;
                                                phi_5685_ = false;
                                            } else {
                                                phi_5681_ = _e2787;
                                                phi_5682_ = _e2774;
                                                phi_5683_ = _e2791;
                                                phi_5684_ = _e2793;
                                                phi_5685_ = _e2795;
                                            }
                                            let _e2800 = phi_5681_;
                                            let _e2802 = phi_5682_;
                                            let _e2804 = phi_5683_;
                                            let _e2806 = phi_5684_;
                                            let _e2808 = phi_5685_;
                                            if _e2802 {
                                                phi_5689_ = _e2800;
                                                phi_5690_ = true;
                                                phi_5691_ = false;
                                                phi_5692_ = false;
                                            } else {
                                                phi_5689_ = _e2772;
                                                phi_5690_ = _e2804;
                                                phi_5691_ = _e2806;
                                                phi_5692_ = _e2808;
                                            }
                                            let _e2810 = phi_5689_;
                                            let _e2812 = phi_5690_;
                                            let _e2814 = phi_5691_;
                                            let _e2816 = phi_5692_;
                                            if _e2812 {
                                                phi_5696_ = false;
                                                phi_5697_ = false;
                                            } else {
                                                phi_5696_ = _e2814;
                                                phi_5697_ = _e2816;
                                            }
                                            let _e2818 = phi_5696_;
                                            let _e2820 = phi_5697_;
                                            if _e2818 {
                                                phi_5701_ = false;
                                                phi_5702_ = false;
                                            } else {
                                                phi_5701_ = _e2820;
                                                phi_5702_ = _e2812;
                                            }
                                            let _e2822 = phi_5701_;
                                            let _e2824 = phi_5702_;
                                            if _e2822 {
                                                phi_5706_ = true;
                                                phi_5707_ = false;
                                            } else {
                                                phi_5706_ = _e2818;
                                                phi_5707_ = _e2824;
                                            }
                                            let _e2826 = phi_5706_;
                                            let _e2828 = phi_5707_;
                                            if _e2826 {
                                                let _e2830 = local_27;
                                                phi_5712_ = type_42(1u, _e2830);
                                                phi_5713_ = true;
                                            } else {
                                                phi_5712_ = _e2810;
                                                phi_5713_ = _e2828;
                                            }
                                            let _e2833 = phi_5712_;
                                            let _e2835 = phi_5713_;
                                            if _e2835 {
                                                phi_5717_ = _e2833;
                                            } else {
                                                phi_5717_ = _e2755;
                                            }
                                            let _e2837 = phi_5717_;
                                            let _e2840 = (_e2837.member != 0u);
                                            if _e2840 {
                                                phi_5724_ = false;
                                            } else {
                                                phi_5724_ = true;
                                            }
                                            let _e2842 = phi_5724_;
                                            phi_5725_ = _e2837.member_1;
                                            phi_5726_ = _e2842;
                                            phi_5727_ = _e2840;
                                            phi_5728_ = false;
                                        } else {
                                            phi_5725_ = f64();
                                            phi_5726_ = false;
                                            phi_5727_ = false;
                                            phi_5728_ = true;
                                        }
                                        let _e2844 = phi_5725_;
                                        let _e2846 = phi_5726_;
                                        let _e2848 = phi_5727_;
                                        let _e2850 = phi_5728_;
                                        phi_5729_ = _e2844;
                                        phi_5730_ = _e2846;
                                        phi_5731_ = _e2848;
                                        phi_5732_ = _e2850;
                                    }
                                    let _e2852 = phi_5729_;
                                    let _e2854 = phi_5730_;
                                    let _e2856 = phi_5731_;
                                    let _e2858 = phi_5732_;
                                    phi_5733_ = _e2852;
                                    phi_5734_ = _e2060;
                                    phi_5735_ = _e2854;
                                    phi_5736_ = _e2856;
                                    phi_5737_ = _e2858;
                                }
                                let _e2860 = phi_5733_;
                                let _e2862 = phi_5734_;
                                let _e2864 = phi_5735_;
                                let _e2866 = phi_5736_;
                                let _e2868 = phi_5737_;
                                if _e2862 {
                                    phi_5741_ = true;
                                    phi_5742_ = false;
                                    phi_5743_ = false;
                                } else {
                                    phi_5741_ = _e2864;
                                    phi_5742_ = _e2866;
                                    phi_5743_ = _e2868;
                                }
                                let _e2870 = phi_5741_;
                                let _e2872 = phi_5742_;
                                let _e2874 = phi_5743_;
                                phi_5744_ = _e2860;
                                phi_5745_ = _e1333;
                                phi_5746_ = _e2870;
                                phi_5747_ = false;
                                phi_5748_ = _e2872;
                                phi_5749_ = _e2874;
                            } else {
                                phi_5744_ = f64();
                                phi_5745_ = type_43();
                                phi_5746_ = false;
                                phi_5747_ = true;
                                phi_5748_ = false;
                                phi_5749_ = false;
                            }
                            let _e2876 = phi_5744_;
                            let _e2878 = phi_5745_;
                            let _e2880 = phi_5746_;
                            let _e2882 = phi_5747_;
                            let _e2884 = phi_5748_;
                            let _e2886 = phi_5749_;
                            local_28 = _e2882;
                            local_63 = _e2884;
                            local_64 = _e2886;
                            local_29 = _e2876;
                            local_30 = _e2878;
                            continue;
                            continuing {
                                phi_3185_ = _e1020;
                                break if !(_e2880);
                            }
                        }
                        let _e2889 = local_28;
                        if _e2889 {
                            phi_5754_ = type_42(0u, type_42().member_1);
                            phi_5755_ = false;
                            phi_5756_ = false;
                        } else {
                            phi_5754_ = type_42();
                            let _e4653 = local_63;
                            phi_5755_ = _e4653;
                            let _e4656 = local_64;
                            phi_5756_ = _e4656;
                        }
                        let _e2893 = phi_5754_;
                        let _e2895 = phi_5755_;
                        let _e2897 = phi_5756_;
                        if _e2895 {
                            let _e2899 = local_29;
                            phi_5761_ = type_42(2u, _e2899);
                            phi_5762_ = false;
                        } else {
                            phi_5761_ = type_42();
                            phi_5762_ = _e2897;
                        }
                        let _e2902 = phi_5761_;
                        let _e2904 = phi_5762_;
                        if _e2904 {
                            let _e2906 = local_30;
                            phi_5768_ = type_42(1u, _e2906.member);
                            phi_5769_ = true;
                        } else {
                            phi_5768_ = _e2902;
                            phi_5769_ = _e2895;
                        }
                        let _e2910 = phi_5768_;
                        let _e2912 = phi_5769_;
                        if _e2912 {
                            phi_5773_ = _e2910;
                        } else {
                            phi_5773_ = _e2893;
                        }
                        let _e2914 = phi_5773_;
                        phi_5777_ = _e2914;
                    }
                    let _e4059 = phi_5777_;
                    phi_5778_ = _e4059;
                }
                let _e4063 = phi_5778_;
                switch bitcast<i32>(_e4063.member) {
                    case 0: {
                        phi_5791_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e4069 = function_(_e4063.member_1);
                        phi_5791_ = type_32(0u, _e4069, true);
                        break;
                    }
                    case 2: {
                        let _e4067 = function_(_e4063.member_1);
                        phi_5791_ = type_32(1u, _e4067, true);
                        break;
                    }
                    default: {
                        phi_5791_ = type_32();
                        break;
                    }
                }
                let _e4072 = phi_5791_;
                if _e4072.member_2 {
                    let _e4079 = (_e4072.member_1[1] >> bitcast<u32>(20i));
                    if (_e4079 <= 896u) {
                        phi_5814_ = 0u;
                    } else {
                        phi_5814_ = ((((_e4079 - 896u) << bitcast<u32>(23i)) | ((_e4072.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e4072.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e4094 = phi_5814_;
                    let _e4096 = atomicMin((&earliest.member[0u]), _e4094);
                }
                phi_5818_ = type_22(1u, _e4072.member, _e172, _e175, _e4072.member_1);
                phi_5819_ = _e4072.member_2;
            } else {
                phi_5818_ = type_22(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_5819_ = false;
            }
            let _e4098 = phi_5818_;
            let _e4100 = phi_5819_;
            let _e4103 = params.member.member.member_1;
            if ((_e4103 & 16u) != 0u) {
                if (_e101 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e4100 {
                    let _e4109 = atomicAdd((&counters[0u]), 1u);
                    phi_5838_ = _e4109;
                } else {
                    phi_5838_ = 0u;
                }
                let _e4111 = phi_5838_;
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
                if _e4100 {
                    let _e4124 = params.member.member_1.member_3;
                    if (_e4121 < _e4124) {
                        let _e4126 = (6u * _e4121);
                        atomicStore((&contacts.member[(4u + _e4126)]), _e4098.member);
                        atomicStore((&contacts.member[(_e4126 + 5u)]), _e4098.member_1);
                        atomicStore((&contacts.member[(_e4126 + 6u)]), _e4098.member_2);
                        atomicStore((&contacts.member[(_e4126 + 7u)]), _e4098.member_3);
                        atomicStore((&contacts.member[(_e4126 + 8u)]), _e4098.member_4[0]);
                        atomicStore((&contacts.member[(_e4126 + 9u)]), _e4098.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_270_ = _e157;
            break if !(_e163);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
