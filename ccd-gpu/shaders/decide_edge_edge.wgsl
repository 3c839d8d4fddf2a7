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
}

struct type_22 {
    member: array<array<u32, 2>>,
}

struct type_24 {
    member: u32,
}

struct type_25 {
    member: type_7,
    member_1: type_8,
    member_2: type_24,
}

struct type_26 {
    member: type_25,
}

struct type_28 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_31 {
    member: f32,
    member_1: f32,
}

struct type_34 {
    member: u32,
    member_1: f32,
}

struct type_35 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_36 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_39 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(0) 
var<storage> params: type_26;
@group(0) @binding(2) 
var<storage> elements: type_22;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_39;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_39;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_39;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(param: f32) -> array<u32, 2> {
    var phi_6187_: array<u32, 2>;
    var phi_6188_: array<u32, 2>;
    var phi_6189_: bool;
    var phi_6193_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_6188_ = array<u32, 2>();
        phi_6189_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_6187_ = array<u32, 2>();
        } else {
            phi_6187_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_6187_;
        phi_6188_ = _e31;
        phi_6189_ = _e17;
    }
    let _e33 = phi_6188_;
    let _e35 = phi_6189_;
    if _e35 {
        phi_6193_ = array<u32, 2>(0u, 0u);
    } else {
        phi_6193_ = _e33;
    }
    let _e37 = phi_6193_;
    return _e37;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_6166_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_6166_ = param_2;
    } else {
        phi_6166_ = param_1;
    }
    let _e26 = phi_6166_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_5758_: bool;
    var phi_5759_: bool;
    var phi_5760_: bool;
    var phi_5761_: bool;
    var phi_5765_: bool;
    var phi_5738_: bool;
    var phi_5739_: bool;
    var phi_5740_: bool;
    var phi_5741_: bool;
    var phi_5742_: bool;
    var phi_5743_: bool;
    var phi_5747_: bool;
    var phi_5766_: bool;
    var phi_5796_: array<f32, 3>;
    var phi_5797_: bool;
    var phi_5798_: array<f32, 3>;
    var phi_5799_: bool;
    var phi_6026_: f32;
    var phi_6027_: f32;
    var phi_6066_: f32;
    var phi_6067_: f32;
    var phi_6112_: f32;
    var phi_6113_: f32;
    var phi_5847_: f32;
    var phi_5848_: f32;
    var phi_5893_: f32;
    var phi_5894_: f32;
    var phi_5936_: f32;
    var phi_5937_: f32;
    var phi_5985_: f32;
    var phi_5986_: f32;
    var phi_6128_: array<array<f32, 3>, 4>;
    var phi_6136_: array<f32, 3>;

    let _e21 = (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2]));
    let _e32 = (((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2]));
    let _e43 = (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2]));
    let _e54 = (((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2]));
    let _e65 = (((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2]));
    let _e68 = ((_e21 * _e43) - (_e32 * _e32));
    let _e72 = (((_e54 * _e43) - (_e65 * _e32)) / _e68);
    let _e76 = (((_e65 * _e21) - (_e54 * _e32)) / _e68);
    if (param_6 != 0u) {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                if (_e72 <= 1f) {
                    phi_5738_ = (_e76 <= 1f);
                    phi_5739_ = false;
                } else {
                    phi_5738_ = bool();
                    phi_5739_ = true;
                }
                let _e97 = phi_5738_;
                let _e99 = phi_5739_;
                phi_5740_ = _e97;
                phi_5741_ = _e99;
            } else {
                phi_5740_ = bool();
                phi_5741_ = true;
            }
            let _e101 = phi_5740_;
            let _e103 = phi_5741_;
            phi_5742_ = _e101;
            phi_5743_ = _e103;
        } else {
            phi_5742_ = bool();
            phi_5743_ = true;
        }
        let _e105 = phi_5742_;
        let _e107 = phi_5743_;
        if _e107 {
            phi_5747_ = false;
        } else {
            phi_5747_ = _e105;
        }
        let _e109 = phi_5747_;
        phi_5766_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_5758_ = ((_e72 + _e76) <= 1f);
                phi_5759_ = false;
            } else {
                phi_5758_ = bool();
                phi_5759_ = true;
            }
            let _e83 = phi_5758_;
            let _e85 = phi_5759_;
            phi_5760_ = _e83;
            phi_5761_ = _e85;
        } else {
            phi_5760_ = bool();
            phi_5761_ = true;
        }
        let _e87 = phi_5760_;
        let _e89 = phi_5761_;
        if _e89 {
            phi_5765_ = false;
        } else {
            phi_5765_ = _e87;
        }
        let _e91 = phi_5765_;
        phi_5766_ = _e91;
    }
    let _e111 = phi_5766_;
    if (_e68 > 0f) {
        if _e111 {
            phi_5796_ = array<f32, 3>((param_3[0] - ((param_4[0] * _e72) + (param_5[0] * _e76))), (param_3[1] - ((param_4[1] * _e72) + (param_5[1] * _e76))), (param_3[2] - ((param_4[2] * _e72) + (param_5[2] * _e76))));
            phi_5797_ = false;
        } else {
            phi_5796_ = array<f32, 3>();
            phi_5797_ = true;
        }
        let _e136 = phi_5796_;
        let _e138 = phi_5797_;
        phi_5798_ = _e136;
        phi_5799_ = _e138;
    } else {
        phi_5798_ = array<f32, 3>();
        phi_5799_ = true;
    }
    let _e140 = phi_5798_;
    let _e142 = phi_5799_;
    if _e142 {
        let _e145 = (param_3[0] - param_4[0]);
        let _e148 = (param_3[1] - param_4[1]);
        let _e151 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e293 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_5847_ = _e293;
                } else {
                    phi_5847_ = 1f;
                }
                let _e297 = phi_5847_;
                phi_5848_ = _e297;
            } else {
                phi_5848_ = 0f;
            }
            let _e299 = phi_5848_;
            let _e335 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_5893_ = _e335;
                } else {
                    phi_5893_ = 1f;
                }
                let _e339 = phi_5893_;
                phi_5894_ = _e339;
            } else {
                phi_5894_ = 0f;
            }
            let _e341 = phi_5894_;
            let _e374 = ((((_e145 * param_5[0]) + (_e148 * param_5[1])) + (_e151 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_5936_ = _e374;
                } else {
                    phi_5936_ = 1f;
                }
                let _e378 = phi_5936_;
                phi_5937_ = _e378;
            } else {
                phi_5937_ = 0f;
            }
            let _e380 = phi_5937_;
            let _e393 = (param_3[0] - param_5[0]);
            let _e396 = (param_3[1] - param_5[1]);
            let _e399 = (param_3[2] - param_5[2]);
            let _e419 = ((((_e393 * param_4[0]) + (_e396 * param_4[1])) + (_e399 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_5985_ = _e419;
                } else {
                    phi_5985_ = 1f;
                }
                let _e423 = phi_5985_;
                phi_5986_ = _e423;
            } else {
                phi_5986_ = 0f;
            }
            let _e425 = phi_5986_;
            phi_6128_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e299)), (param_3[1] - (param_4[1] * _e299)), (param_3[2] - (param_4[2] * _e299))), array<f32, 3>((param_3[0] - (param_5[0] * _e341)), (param_3[1] - (param_5[1] * _e341)), (param_3[2] - (param_5[2] * _e341))), array<f32, 3>((_e145 - (param_5[0] * _e380)), (_e148 - (param_5[1] * _e380)), (_e151 - (param_5[2] * _e380))), array<f32, 3>((_e393 - (param_4[0] * _e425)), (_e396 - (param_4[1] * _e425)), (_e399 - (param_4[2] * _e425))));
        } else {
            let _e155 = (param_5[0] - param_4[0]);
            let _e158 = (param_5[1] - param_4[1]);
            let _e161 = (param_5[2] - param_4[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_6026_ = _e172;
                } else {
                    phi_6026_ = 1f;
                }
                let _e176 = phi_6026_;
                phi_6027_ = _e176;
            } else {
                phi_6027_ = 0f;
            }
            let _e178 = phi_6027_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_6066_ = _e208;
                } else {
                    phi_6066_ = 1f;
                }
                let _e212 = phi_6066_;
                phi_6067_ = _e212;
            } else {
                phi_6067_ = 0f;
            }
            let _e214 = phi_6067_;
            let _e250 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_6112_ = _e250;
                } else {
                    phi_6112_ = 1f;
                }
                let _e254 = phi_6112_;
                phi_6113_ = _e254;
            } else {
                phi_6113_ = 0f;
            }
            let _e256 = phi_6113_;
            phi_6128_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e214)), (param_3[1] - (param_4[1] * _e214)), (param_3[2] - (param_4[2] * _e214))), array<f32, 3>((param_3[0] - (param_5[0] * _e256)), (param_3[1] - (param_5[1] * _e256)), (param_3[2] - (param_5[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_6128_;
        let _e441 = function_1(_e438[0], _e438[1]);
        let _e443 = function_1(_e441, _e438[2]);
        let _e445 = function_1(_e443, _e438[3]);
        phi_6136_ = _e445;
    } else {
        phi_6136_ = _e140;
    }
    let _e447 = phi_6136_;
    return _e447;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: type_29;
    var local_3: type_29;
    var local_4: type_29;
    var local_5: array<type_31, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: array<array<f32, 3>, 4>;
    var local_10: array<array<f32, 3>, 4>;
    var local_11: array<f32, 3>;
    var local_12: type_28;
    var phi_211_: u32;
    var phi_227_: u32;
    var phi_248_: u32;
    var phi_249_: u32;
    var phi_252_: type_9;
    var phi_253_: type_9;
    var phi_276_: type_9;
    var phi_725_: f32;
    var phi_732_: f32;
    var phi_737_: f32;
    var phi_744_: f32;
    var phi_749_: f32;
    var phi_762_: f32;
    var phi_769_: f32;
    var phi_774_: f32;
    var phi_781_: f32;
    var phi_786_: f32;
    var phi_791_: f32;
    var phi_808_: f32;
    var phi_815_: f32;
    var phi_820_: f32;
    var phi_827_: f32;
    var phi_832_: f32;
    var phi_846_: f32;
    var phi_853_: f32;
    var phi_858_: f32;
    var phi_865_: f32;
    var phi_870_: f32;
    var phi_875_: f32;
    var phi_892_: f32;
    var phi_899_: f32;
    var phi_904_: f32;
    var phi_911_: f32;
    var phi_916_: f32;
    var phi_930_: f32;
    var phi_937_: f32;
    var phi_942_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_959_: f32;
    var phi_990_: f32;
    var phi_996_: f32;
    var phi_1003_: f32;
    var phi_1010_: f32;
    var phi_1016_: f32;
    var phi_1023_: f32;
    var phi_1029_: f32;
    var phi_1035_: f32;
    var phi_1041_: f32;
    var phi_1048_: f32;
    var phi_1055_: f32;
    var phi_1079_: f32;
    var phi_1084_: f32;
    var phi_1089_: f32;
    var phi_1094_: f32;
    var phi_1099_: f32;
    var phi_1104_: f32;
    var phi_1114_: f32;
    var phi_2673_: f32;
    var phi_2679_: f32;
    var phi_2684_: f32;
    var phi_2690_: f32;
    var phi_2696_: f32;
    var phi_2701_: f32;
    var phi_2706_: f32;
    var phi_2714_: bool;
    var phi_2719_: f32;
    var phi_2726_: f32;
    var phi_2766_: type_14;
    var phi_2769_: f32;
    var phi_2790_: bool;
    var phi_2796_: type_15;
    var phi_2767_: type_14;
    var phi_2810_: type_15;
    var phi_2770_: f32;
    var local_13: f32;
    var phi_2759_: f32;
    var phi_2823_: f32;
    var phi_2829_: f32;
    var phi_2854_: type_9;
    var phi_2857_: u32;
    var phi_2855_: type_9;
    var phi_2880_: type_9;
    var phi_2924_: u32;
    var phi_2925_: u32;
    var phi_2858_: u32;
    var phi_2926_: u32;
    var phi_2946_: type_9;
    var phi_2947_: type_9;
    var phi_2970_: type_9;
    var phi_3022_: f32;
    var phi_3029_: f32;
    var phi_3040_: bool;
    var phi_3041_: bool;
    var phi_3042_: bool;
    var phi_3043_: bool;
    var phi_3047_: bool;
    var phi_3058_: type_35;
    var phi_3059_: type_35;
    var phi_3060_: bool;
    var phi_3061_: type_35;
    var phi_3062_: bool;
    var phi_3073_: f32;
    var phi_3083_: type_9;
    var phi_3086_: f32;
    var phi_3088_: f32;
    var phi_3090_: f32;
    var phi_3084_: type_9;
    var phi_3113_: type_9;
    var phi_3138_: f32;
    var phi_3139_: f32;
    var phi_3165_: f32;
    var phi_3181_: f32;
    var phi_3188_: bool;
    var phi_3189_: bool;
    var phi_3190_: bool;
    var phi_3196_: f32;
    var phi_3197_: f32;
    var phi_3198_: bool;
    var phi_3087_: f32;
    var phi_3089_: f32;
    var phi_3091_: f32;
    var phi_3199_: f32;
    var phi_3200_: bool;
    var phi_3201_: bool;
    var local_14: bool;
    var phi_3205_: f32;
    var phi_3206_: f32;
    var phi_3213_: type_9;
    var phi_3216_: f32;
    var phi_3214_: type_9;
    var phi_3239_: type_9;
    var phi_3280_: f32;
    var phi_3290_: f32;
    var phi_3298_: bool;
    var phi_3300_: bool;
    var phi_3305_: f32;
    var phi_3306_: bool;
    var phi_3307_: f32;
    var phi_3308_: bool;
    var phi_3309_: bool;
    var phi_3310_: bool;
    var phi_3311_: f32;
    var phi_3217_: f32;
    var phi_3312_: bool;
    var phi_3313_: bool;
    var phi_3314_: bool;
    var phi_3315_: bool;
    var local_15: bool;
    var phi_3319_: bool;
    var phi_3320_: bool;
    var phi_3324_: bool;
    var phi_3328_: f32;
    var phi_3329_: f32;
    var phi_3331_: type_35;
    var phi_3360_: f32;
    var phi_3367_: f32;
    var phi_3372_: f32;
    var phi_3379_: f32;
    var phi_3384_: f32;
    var phi_3397_: f32;
    var phi_3404_: f32;
    var phi_3409_: f32;
    var phi_3416_: f32;
    var phi_3421_: f32;
    var phi_3426_: f32;
    var phi_3485_: f32;
    var phi_3491_: f32;
    var phi_3496_: f32;
    var phi_3502_: f32;
    var phi_3507_: f32;
    var phi_3519_: f32;
    var phi_3525_: f32;
    var phi_3530_: f32;
    var phi_3536_: f32;
    var phi_3541_: f32;
    var phi_3567_: f32;
    var phi_3574_: f32;
    var phi_3579_: f32;
    var phi_3586_: f32;
    var phi_3591_: f32;
    var phi_3604_: f32;
    var phi_3611_: f32;
    var phi_3616_: f32;
    var phi_3623_: f32;
    var phi_3628_: f32;
    var phi_3633_: f32;
    var phi_3692_: f32;
    var phi_3698_: f32;
    var phi_3703_: f32;
    var phi_3709_: f32;
    var phi_3714_: f32;
    var phi_3726_: f32;
    var phi_3732_: f32;
    var phi_3737_: f32;
    var phi_3743_: f32;
    var phi_3748_: f32;
    var phi_3774_: f32;
    var phi_3781_: f32;
    var phi_3786_: f32;
    var phi_3793_: f32;
    var phi_3798_: f32;
    var phi_3811_: f32;
    var phi_3818_: f32;
    var phi_3823_: f32;
    var phi_3830_: f32;
    var phi_3835_: f32;
    var phi_3840_: f32;
    var phi_3899_: f32;
    var phi_3905_: f32;
    var phi_3910_: f32;
    var phi_3916_: f32;
    var phi_3921_: f32;
    var phi_3933_: f32;
    var phi_3939_: f32;
    var phi_3944_: f32;
    var phi_3950_: f32;
    var phi_3955_: f32;
    var phi_4004_: f32;
    var phi_4010_: f32;
    var phi_4038_: f32;
    var phi_4044_: f32;
    var phi_4049_: u32;
    var phi_4050_: u32;
    var phi_4020_: f32;
    var phi_4026_: f32;
    var phi_4031_: u32;
    var phi_4032_: u32;
    var phi_4051_: u32;
    var phi_4052_: u32;
    var phi_4119_: f32;
    var phi_4128_: f32;
    var phi_4259_: f32;
    var phi_4265_: f32;
    var phi_4272_: f32;
    var phi_4315_: type_9;
    var phi_4318_: bool;
    var phi_4316_: type_9;
    var phi_4341_: type_9;
    var phi_4368_: bool;
    var phi_4369_: bool;
    var phi_4319_: bool;
    var phi_4370_: bool;
    var phi_4371_: bool;
    var local_16: bool;
    var phi_4375_: bool;
    var local_17: bool;
    var phi_4382_: u32;
    var phi_4383_: u32;
    var phi_4384_: bool;
    var phi_4385_: u32;
    var phi_4386_: u32;
    var phi_4387_: bool;
    var phi_4391_: u32;
    var phi_4411_: bool;
    var phi_4412_: bool;
    var phi_4413_: bool;
    var phi_4609_: f32;
    var phi_4616_: f32;
    var phi_4621_: f32;
    var phi_4628_: f32;
    var phi_4633_: f32;
    var phi_4646_: f32;
    var phi_4653_: f32;
    var phi_4658_: f32;
    var phi_4665_: f32;
    var phi_4670_: f32;
    var phi_4675_: f32;
    var phi_4692_: f32;
    var phi_4699_: f32;
    var phi_4704_: f32;
    var phi_4711_: f32;
    var phi_4716_: f32;
    var phi_4730_: f32;
    var phi_4737_: f32;
    var phi_4742_: f32;
    var phi_4749_: f32;
    var phi_4754_: f32;
    var phi_4759_: f32;
    var phi_4776_: f32;
    var phi_4783_: f32;
    var phi_4788_: f32;
    var phi_4795_: f32;
    var phi_4800_: f32;
    var phi_4814_: f32;
    var phi_4821_: f32;
    var phi_4826_: f32;
    var phi_4833_: f32;
    var phi_4838_: f32;
    var phi_4843_: f32;
    var phi_4859_: type_9;
    var phi_4862_: f32;
    var phi_4860_: type_9;
    var phi_4885_: type_9;
    var phi_4996_: f32;
    var phi_5003_: f32;
    var phi_5011_: f32;
    var phi_5055_: type_14;
    var phi_5058_: f32;
    var phi_5079_: bool;
    var phi_5085_: type_15;
    var phi_5056_: type_14;
    var phi_5099_: type_15;
    var phi_5059_: f32;
    var local_18: f32;
    var phi_5048_: f32;
    var phi_5112_: f32;
    var phi_5121_: type_9;
    var phi_5124_: f32;
    var phi_5122_: type_9;
    var phi_5147_: type_9;
    var phi_5198_: f32;
    var phi_5204_: f32;
    var phi_5217_: bool;
    var phi_5218_: bool;
    var phi_5249_: f32;
    var phi_5250_: f32;
    var phi_5251_: f32;
    var phi_5252_: bool;
    var phi_5256_: bool;
    var phi_5257_: f32;
    var phi_5258_: bool;
    var phi_5259_: bool;
    var phi_5260_: bool;
    var phi_5261_: f32;
    var phi_5262_: bool;
    var phi_5263_: bool;
    var phi_5264_: bool;
    var phi_5125_: f32;
    var phi_5265_: bool;
    var phi_5266_: bool;
    var phi_5267_: bool;
    var phi_5268_: bool;
    var local_19: bool;
    var local_20: f32;
    var local_21: f32;
    var local_22: f32;
    var phi_5285_: bool;
    var phi_5286_: bool;
    var phi_5287_: bool;
    var phi_5288_: bool;
    var phi_5289_: bool;
    var phi_5290_: bool;
    var phi_5291_: bool;
    var phi_5292_: bool;
    var phi_5293_: bool;
    var phi_5294_: bool;
    var phi_5295_: bool;
    var phi_5296_: bool;
    var phi_5297_: bool;
    var phi_5298_: f32;
    var phi_5299_: f32;
    var phi_5300_: bool;
    var phi_5301_: bool;
    var phi_5302_: bool;
    var phi_5303_: bool;
    var phi_5304_: bool;
    var phi_5305_: bool;
    var phi_5306_: bool;
    var phi_5307_: f32;
    var phi_5308_: f32;
    var phi_5309_: bool;
    var phi_5310_: bool;
    var phi_5311_: bool;
    var phi_5312_: bool;
    var phi_5313_: bool;
    var phi_5314_: bool;
    var phi_5315_: bool;
    var phi_5316_: bool;
    var phi_5317_: f32;
    var phi_4863_: f32;
    var phi_5318_: bool;
    var phi_5319_: bool;
    var phi_5320_: bool;
    var phi_5321_: bool;
    var phi_5322_: bool;
    var phi_5323_: bool;
    var phi_5324_: bool;
    var phi_5325_: bool;
    var phi_5326_: bool;
    var local_23: bool;
    var phi_5331_: type_34;
    var phi_5332_: bool;
    var phi_5333_: bool;
    var phi_5334_: bool;
    var phi_5335_: bool;
    var phi_5336_: bool;
    var phi_5337_: bool;
    var phi_5338_: bool;
    var phi_5342_: f32;
    var phi_5343_: bool;
    var phi_5344_: bool;
    var phi_5345_: bool;
    var phi_5346_: bool;
    var phi_5347_: bool;
    var phi_5348_: bool;
    var phi_5349_: bool;
    var phi_5354_: type_34;
    var phi_5355_: bool;
    var phi_5356_: bool;
    var phi_5357_: bool;
    var phi_5358_: bool;
    var phi_5359_: bool;
    var phi_5360_: bool;
    var local_24: f32;
    var phi_5365_: type_34;
    var phi_5366_: bool;
    var phi_5367_: bool;
    var phi_5368_: bool;
    var phi_5369_: bool;
    var phi_5370_: bool;
    var local_25: f32;
    var phi_5375_: type_34;
    var phi_5376_: bool;
    var phi_5377_: bool;
    var phi_5378_: bool;
    var phi_5379_: bool;
    var local_26: f32;
    var phi_5384_: type_34;
    var phi_5385_: bool;
    var phi_5386_: bool;
    var phi_5387_: bool;
    var phi_5388_: bool;
    var phi_5392_: type_34;
    var phi_5393_: bool;
    var phi_5394_: bool;
    var phi_5395_: bool;
    var phi_5399_: bool;
    var phi_5400_: bool;
    var phi_5404_: bool;
    var phi_5405_: bool;
    var phi_5409_: bool;
    var phi_5410_: bool;
    var local_27: f32;
    var phi_5415_: type_34;
    var phi_5416_: bool;
    var phi_5420_: type_34;
    var phi_5427_: bool;
    var phi_5428_: f32;
    var phi_5429_: bool;
    var phi_5430_: bool;
    var phi_5431_: bool;
    var phi_5432_: f32;
    var phi_5433_: bool;
    var phi_5434_: bool;
    var phi_5435_: bool;
    var phi_5436_: f32;
    var phi_5437_: bool;
    var phi_5438_: bool;
    var phi_5439_: bool;
    var phi_5440_: bool;
    var phi_5444_: bool;
    var phi_5445_: bool;
    var phi_5446_: bool;
    var phi_5447_: f32;
    var phi_5448_: type_35;
    var phi_5449_: bool;
    var phi_5450_: bool;
    var phi_5451_: bool;
    var phi_5452_: bool;
    var local_28: bool;
    var phi_5457_: type_34;
    var phi_5458_: bool;
    var phi_5459_: bool;
    var local_29: f32;
    var phi_5464_: type_34;
    var phi_5465_: bool;
    var local_30: type_35;
    var phi_5471_: type_34;
    var phi_5472_: bool;
    var phi_5476_: type_34;
    var phi_1315_: f32;
    var phi_1322_: f32;
    var phi_1327_: f32;
    var phi_1334_: f32;
    var phi_1339_: f32;
    var phi_1352_: f32;
    var phi_1359_: f32;
    var phi_1364_: f32;
    var phi_1371_: f32;
    var phi_1376_: f32;
    var phi_1381_: f32;
    var phi_1398_: f32;
    var phi_1405_: f32;
    var phi_1410_: f32;
    var phi_1417_: f32;
    var phi_1422_: f32;
    var phi_1436_: f32;
    var phi_1443_: f32;
    var phi_1448_: f32;
    var phi_1455_: f32;
    var phi_1460_: f32;
    var phi_1465_: f32;
    var phi_1482_: f32;
    var phi_1489_: f32;
    var phi_1494_: f32;
    var phi_1501_: f32;
    var phi_1506_: f32;
    var phi_1520_: f32;
    var phi_1527_: f32;
    var phi_1532_: f32;
    var phi_1539_: f32;
    var phi_1544_: f32;
    var phi_1549_: f32;
    var phi_1565_: type_9;
    var phi_1568_: f32;
    var phi_1566_: type_9;
    var phi_1591_: type_9;
    var phi_1702_: f32;
    var phi_1709_: f32;
    var phi_1717_: f32;
    var phi_1761_: type_14;
    var phi_1764_: f32;
    var phi_1785_: bool;
    var phi_1791_: type_15;
    var phi_1762_: type_14;
    var phi_1805_: type_15;
    var phi_1765_: f32;
    var local_31: f32;
    var phi_1754_: f32;
    var phi_1818_: f32;
    var phi_1827_: type_9;
    var phi_1830_: f32;
    var phi_1828_: type_9;
    var phi_1853_: type_9;
    var phi_1904_: f32;
    var phi_1910_: f32;
    var phi_1923_: bool;
    var phi_1924_: bool;
    var phi_1955_: f32;
    var phi_1956_: f32;
    var phi_1957_: f32;
    var phi_1958_: bool;
    var phi_1962_: bool;
    var phi_1963_: f32;
    var phi_1964_: bool;
    var phi_1965_: bool;
    var phi_1966_: bool;
    var phi_1967_: f32;
    var phi_1968_: bool;
    var phi_1969_: bool;
    var phi_1970_: bool;
    var phi_1831_: f32;
    var phi_1971_: bool;
    var phi_1972_: bool;
    var phi_1973_: bool;
    var phi_1974_: bool;
    var local_32: bool;
    var local_33: f32;
    var local_34: f32;
    var local_35: f32;
    var phi_1991_: bool;
    var phi_1992_: bool;
    var phi_1993_: bool;
    var phi_1994_: bool;
    var phi_1995_: bool;
    var phi_1996_: bool;
    var phi_1997_: bool;
    var phi_1998_: bool;
    var phi_1999_: bool;
    var phi_2000_: bool;
    var phi_2001_: bool;
    var phi_2002_: bool;
    var phi_2003_: bool;
    var phi_2004_: f32;
    var phi_2005_: f32;
    var phi_2006_: bool;
    var phi_2007_: bool;
    var phi_2008_: bool;
    var phi_2009_: bool;
    var phi_2010_: bool;
    var phi_2011_: bool;
    var phi_2012_: bool;
    var phi_2013_: f32;
    var phi_2014_: f32;
    var phi_2015_: bool;
    var phi_2016_: bool;
    var phi_2017_: bool;
    var phi_2018_: bool;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2023_: f32;
    var phi_1569_: f32;
    var phi_2024_: bool;
    var phi_2025_: bool;
    var phi_2026_: bool;
    var phi_2027_: bool;
    var phi_2028_: bool;
    var phi_2029_: bool;
    var phi_2030_: bool;
    var phi_2031_: bool;
    var phi_2032_: bool;
    var local_36: bool;
    var phi_2037_: type_34;
    var phi_2038_: bool;
    var phi_2039_: bool;
    var phi_2040_: bool;
    var phi_2041_: bool;
    var phi_2042_: bool;
    var phi_2043_: bool;
    var phi_2044_: bool;
    var phi_2048_: f32;
    var phi_2049_: bool;
    var phi_2050_: bool;
    var phi_2051_: bool;
    var phi_2052_: bool;
    var phi_2053_: bool;
    var phi_2054_: bool;
    var phi_2055_: bool;
    var phi_2060_: type_34;
    var phi_2061_: bool;
    var phi_2062_: bool;
    var phi_2063_: bool;
    var phi_2064_: bool;
    var phi_2065_: bool;
    var phi_2066_: bool;
    var local_37: f32;
    var phi_2071_: type_34;
    var phi_2072_: bool;
    var phi_2073_: bool;
    var phi_2074_: bool;
    var phi_2075_: bool;
    var phi_2076_: bool;
    var local_38: f32;
    var phi_2081_: type_34;
    var phi_2082_: bool;
    var phi_2083_: bool;
    var phi_2084_: bool;
    var phi_2085_: bool;
    var local_39: f32;
    var phi_2090_: type_34;
    var phi_2091_: bool;
    var phi_2092_: bool;
    var phi_2093_: bool;
    var phi_2094_: bool;
    var phi_2098_: type_34;
    var phi_2099_: bool;
    var phi_2100_: bool;
    var phi_2101_: bool;
    var phi_2105_: bool;
    var phi_2106_: bool;
    var phi_2110_: bool;
    var phi_2111_: bool;
    var phi_2115_: bool;
    var phi_2116_: bool;
    var local_40: f32;
    var phi_2121_: type_34;
    var phi_2122_: bool;
    var phi_2126_: type_34;
    var phi_2140_: type_9;
    var phi_2141_: type_9;
    var phi_2164_: type_9;
    var phi_2184_: f32;
    var phi_2314_: type_14;
    var phi_2317_: f32;
    var phi_2338_: bool;
    var phi_2344_: type_15;
    var phi_2315_: type_14;
    var phi_2358_: type_15;
    var phi_2318_: f32;
    var local_41: f32;
    var phi_2307_: f32;
    var phi_2371_: f32;
    var phi_2387_: f32;
    var phi_2394_: f32;
    var phi_2399_: f32;
    var phi_2406_: f32;
    var phi_2411_: f32;
    var phi_2424_: f32;
    var phi_2431_: f32;
    var phi_2436_: f32;
    var phi_2443_: f32;
    var phi_2448_: f32;
    var phi_2453_: f32;
    var phi_2470_: f32;
    var phi_2477_: f32;
    var phi_2482_: f32;
    var phi_2489_: f32;
    var phi_2494_: f32;
    var phi_2508_: f32;
    var phi_2515_: f32;
    var phi_2520_: f32;
    var phi_2527_: f32;
    var phi_2532_: f32;
    var phi_2537_: f32;
    var phi_2554_: f32;
    var phi_2561_: f32;
    var phi_2566_: f32;
    var phi_2573_: f32;
    var phi_2578_: f32;
    var phi_2592_: f32;
    var phi_2599_: f32;
    var phi_2604_: f32;
    var phi_2611_: f32;
    var phi_2616_: f32;
    var phi_2621_: f32;
    var phi_2641_: bool;
    var phi_2642_: bool;
    var phi_2643_: bool;
    var local_42: bool;
    var phi_2648_: type_34;
    var phi_2649_: bool;
    var phi_2654_: type_34;
    var phi_2655_: bool;
    var phi_2657_: type_34;
    var phi_2658_: type_34;
    var phi_2659_: bool;
    var phi_2663_: type_34;
    var phi_5480_: type_34;
    var phi_5481_: type_34;
    var phi_5494_: type_36;
    var phi_5501_: bool;
    var phi_5525_: u32;
    var phi_5529_: type_20;
    var phi_5530_: bool;
    var phi_5531_: bool;
    var phi_5550_: u32;
    var phi_5613_: u32;
    var local_43: u32;
    var local_44: f32;
    var local_45: f32;
    var local_46: bool;
    var local_47: bool;
    var local_48: f32;
    var local_49: bool;
    var local_50: bool;
    var local_51: f32;
    var local_52: f32;
    var local_53: bool;
    var local_54: bool;
    var local_55: bool;
    var local_56: bool;
    var local_57: bool;
    var local_58: bool;
    var local_59: bool;
    var local_60: f32;
    var local_61: f32;
    var local_62: bool;
    var local_63: bool;
    var local_64: bool;
    var local_65: bool;
    var local_66: bool;
    var local_67: f32;
    var local_68: f32;
    var local_69: bool;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: bool;
    var local_76: f32;
    var local_77: f32;
    var local_78: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e92 = id_2;
    let _e93 = n_2;
    let _e94 = lane_2;
    let _e106 = ((_e92.y * _e93.x) + _e92.x);
    let _e109 = (_e93.x * _e93.y);
    let _e112 = params.member.member_1.member_2;
    let _e114 = input.member[0u];
    if (_e112 < _e114) {
        phi_211_ = _e112;
    } else {
        phi_211_ = _e114;
    }
    let _e117 = phi_211_;
    let _e118 = (_e117 / 64u);
    if ((_e117 % 64u) > 0u) {
        phi_227_ = (_e118 + 1u);
    } else {
        phi_227_ = _e118;
    }
    let _e123 = phi_227_;
    if (_e123 > _e106) {
        let _e125 = (_e123 - _e106);
        if (_e109 == 0u) {
            return;
        }
        let _e127 = (_e125 / _e109);
        if (_e109 == 0u) {
            return;
        }
        if ((_e125 % _e109) > 0u) {
            phi_248_ = (_e127 + 1u);
        } else {
            phi_248_ = _e127;
        }
        let _e133 = phi_248_;
        phi_249_ = _e133;
    } else {
        phi_249_ = 0u;
    }
    let _e135 = phi_249_;
    phi_252_ = type_9(0u, _e135);
    loop {
        let _e138 = phi_252_;
        if (_e138.member < _e138.member_1) {
            phi_253_ = type_9((_e138.member + 1u), _e138.member_1);
            phi_276_ = type_9(1u, _e138.member);
        } else {
            phi_253_ = _e138;
            phi_276_ = type_9(0u, type_9().member_1);
        }
        let _e150 = phi_253_;
        let _e152 = phi_276_;
        let _e156 = (bitcast<i32>(_e152.member) != 0i);
        if _e156 {
            let _e160 = (((_e106 + (_e152.member_1 * _e109)) * 64u) + _e94);
            if (_e160 < _e117) {
                let _e162 = (2u * _e160);
                let _e165 = input.member[(4u + _e162)];
                let _e168 = input.member[(_e162 + 5u)];
                let _e171 = elements.member[_e165];
                let _e173 = elements.member[_e168];
                let _e179 = paths.member[_e171[0]];
                let _e181 = paths.member[_e171[1]];
                let _e187 = paths.member[_e173[0]];
                let _e189 = paths.member[_e173[1]];
                let _e219 = params.member.member.member_4;
                local_12 = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e187.member[0] - _e179.member[0]), (_e187.member[1] - _e179.member[1]), (_e187.member[2] - _e179.member[2])), array<f32, 3>((_e187.member_1[0] - _e179.member_1[0]), (_e187.member_1[1] - _e179.member_1[1]), (_e187.member_1[2] - _e179.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e181.member[0] - _e179.member[0]), (_e181.member[1] - _e179.member[1]), (_e181.member[2] - _e179.member[2])), array<f32, 3>((_e181.member_1[0] - _e179.member_1[0]), (_e181.member_1[1] - _e179.member_1[1]), (_e181.member_1[2] - _e179.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e187.member[0] - _e189.member[0]), (_e187.member[1] - _e189.member[1]), (_e187.member[2] - _e189.member[2])), array<f32, 3>((_e187.member_1[0] - _e189.member_1[0]), (_e187.member_1[1] - _e189.member_1[1]), (_e187.member_1[2] - _e189.member_1[2]))), (_e219 + _e219));
                let _e250 = params.member.member.member_5;
                let _e253 = local_12.member_1[0u];
                let _e259 = local_12.member_2[0u];
                let _e265 = ((_e253[1] * _e259[2]) - (_e253[2] * _e259[1]));
                let _e268 = ((_e253[2] * _e259[0]) - (_e253[0] * _e259[2]));
                let _e271 = ((_e253[0] * _e259[1]) - (_e253[1] * _e259[0]));
                let _e274 = local_12.member_1[1u];
                let _e280 = local_12.member_2[1u];
                let _e286 = ((_e274[1] * _e280[2]) - (_e274[2] * _e280[1]));
                let _e289 = ((_e274[2] * _e280[0]) - (_e274[0] * _e280[2]));
                let _e292 = ((_e274[0] * _e280[1]) - (_e274[1] * _e280[0]));
                let _e295 = local_12.member_1[0u];
                let _e301 = local_12.member_2[1u];
                let _e316 = local_12.member_1[1u];
                let _e322 = local_12.member_2[0u];
                let _e335 = (((_e295[1] * _e301[2]) - (_e295[2] * _e301[1])) + ((_e316[1] * _e322[2]) - (_e316[2] * _e322[1])));
                let _e336 = (((_e295[2] * _e301[0]) - (_e295[0] * _e301[2])) + ((_e316[2] * _e322[0]) - (_e316[0] * _e322[2])));
                let _e337 = (((_e295[0] * _e301[1]) - (_e295[1] * _e301[0])) + ((_e316[0] * _e322[1]) - (_e316[1] * _e322[0])));
                let _e340 = local_12.member[0u];
                let _e348 = (((_e340[0] * _e265) + (_e340[1] * _e268)) + (_e340[2] * _e271));
                let _e351 = local_12.member[1u];
                let _e362 = local_12.member[0u];
                let _e371 = ((((_e351[0] * _e265) + (_e351[1] * _e268)) + (_e351[2] * _e271)) + (((_e362[0] * _e335) + (_e362[1] * _e336)) + (_e362[2] * _e337)));
                let _e374 = local_12.member[0u];
                let _e385 = local_12.member[1u];
                let _e394 = ((((_e374[0] * _e286) + (_e374[1] * _e289)) + (_e374[2] * _e292)) + (((_e385[0] * _e335) + (_e385[1] * _e336)) + (_e385[2] * _e337)));
                let _e397 = local_12.member[1u];
                let _e405 = (((_e397[0] * _e286) + (_e397[1] * _e289)) + (_e397[2] * _e292));
                let _e408 = local_12.member[0u];
                if (_e408[0] < 0f) {
                    phi_725_ = -(_e408[0]);
                } else {
                    phi_725_ = _e408[0];
                }
                let _e415 = phi_725_;
                if (_e408[1] < 0f) {
                    phi_732_ = -(_e408[1]);
                } else {
                    phi_732_ = _e408[1];
                }
                let _e419 = phi_732_;
                if (_e415 > _e419) {
                    phi_737_ = _e415;
                } else {
                    phi_737_ = _e419;
                }
                let _e422 = phi_737_;
                if (_e408[2] < 0f) {
                    phi_744_ = -(_e408[2]);
                } else {
                    phi_744_ = _e408[2];
                }
                let _e426 = phi_744_;
                if (_e422 > _e426) {
                    phi_749_ = _e422;
                } else {
                    phi_749_ = _e426;
                }
                let _e429 = phi_749_;
                let _e432 = local_12.member[1u];
                if (_e432[0] < 0f) {
                    phi_762_ = -(_e432[0]);
                } else {
                    phi_762_ = _e432[0];
                }
                let _e439 = phi_762_;
                if (_e432[1] < 0f) {
                    phi_769_ = -(_e432[1]);
                } else {
                    phi_769_ = _e432[1];
                }
                let _e443 = phi_769_;
                if (_e439 > _e443) {
                    phi_774_ = _e439;
                } else {
                    phi_774_ = _e443;
                }
                let _e446 = phi_774_;
                if (_e432[2] < 0f) {
                    phi_781_ = -(_e432[2]);
                } else {
                    phi_781_ = _e432[2];
                }
                let _e450 = phi_781_;
                if (_e446 > _e450) {
                    phi_786_ = _e446;
                } else {
                    phi_786_ = _e450;
                }
                let _e453 = phi_786_;
                if (_e429 > _e453) {
                    phi_791_ = _e429;
                } else {
                    phi_791_ = _e453;
                }
                let _e456 = phi_791_;
                let _e458 = local_12.member_3;
                let _e459 = (_e456 + _e458);
                let _e462 = local_12.member_1[0u];
                if (_e462[0] < 0f) {
                    phi_808_ = -(_e462[0]);
                } else {
                    phi_808_ = _e462[0];
                }
                let _e469 = phi_808_;
                if (_e462[1] < 0f) {
                    phi_815_ = -(_e462[1]);
                } else {
                    phi_815_ = _e462[1];
                }
                let _e473 = phi_815_;
                if (_e469 > _e473) {
                    phi_820_ = _e469;
                } else {
                    phi_820_ = _e473;
                }
                let _e476 = phi_820_;
                if (_e462[2] < 0f) {
                    phi_827_ = -(_e462[2]);
                } else {
                    phi_827_ = _e462[2];
                }
                let _e480 = phi_827_;
                if (_e476 > _e480) {
                    phi_832_ = _e476;
                } else {
                    phi_832_ = _e480;
                }
                let _e483 = phi_832_;
                let _e486 = local_12.member_1[1u];
                if (_e486[0] < 0f) {
                    phi_846_ = -(_e486[0]);
                } else {
                    phi_846_ = _e486[0];
                }
                let _e493 = phi_846_;
                if (_e486[1] < 0f) {
                    phi_853_ = -(_e486[1]);
                } else {
                    phi_853_ = _e486[1];
                }
                let _e497 = phi_853_;
                if (_e493 > _e497) {
                    phi_858_ = _e493;
                } else {
                    phi_858_ = _e497;
                }
                let _e500 = phi_858_;
                if (_e486[2] < 0f) {
                    phi_865_ = -(_e486[2]);
                } else {
                    phi_865_ = _e486[2];
                }
                let _e504 = phi_865_;
                if (_e500 > _e504) {
                    phi_870_ = _e500;
                } else {
                    phi_870_ = _e504;
                }
                let _e507 = phi_870_;
                if (_e483 > _e507) {
                    phi_875_ = _e483;
                } else {
                    phi_875_ = _e507;
                }
                let _e510 = phi_875_;
                let _e512 = local_12.member_3;
                let _e513 = (_e510 + _e512);
                let _e516 = local_12.member_2[0u];
                if (_e516[0] < 0f) {
                    phi_892_ = -(_e516[0]);
                } else {
                    phi_892_ = _e516[0];
                }
                let _e523 = phi_892_;
                if (_e516[1] < 0f) {
                    phi_899_ = -(_e516[1]);
                } else {
                    phi_899_ = _e516[1];
                }
                let _e527 = phi_899_;
                if (_e523 > _e527) {
                    phi_904_ = _e523;
                } else {
                    phi_904_ = _e527;
                }
                let _e530 = phi_904_;
                if (_e516[2] < 0f) {
                    phi_911_ = -(_e516[2]);
                } else {
                    phi_911_ = _e516[2];
                }
                let _e534 = phi_911_;
                if (_e530 > _e534) {
                    phi_916_ = _e530;
                } else {
                    phi_916_ = _e534;
                }
                let _e537 = phi_916_;
                let _e540 = local_12.member_2[1u];
                if (_e540[0] < 0f) {
                    phi_930_ = -(_e540[0]);
                } else {
                    phi_930_ = _e540[0];
                }
                let _e547 = phi_930_;
                if (_e540[1] < 0f) {
                    phi_937_ = -(_e540[1]);
                } else {
                    phi_937_ = _e540[1];
                }
                let _e551 = phi_937_;
                if (_e547 > _e551) {
                    phi_942_ = _e547;
                } else {
                    phi_942_ = _e551;
                }
                let _e554 = phi_942_;
                if (_e540[2] < 0f) {
                    phi_949_ = -(_e540[2]);
                } else {
                    phi_949_ = _e540[2];
                }
                let _e558 = phi_949_;
                if (_e554 > _e558) {
                    phi_954_ = _e554;
                } else {
                    phi_954_ = _e558;
                }
                let _e561 = phi_954_;
                if (_e537 > _e561) {
                    phi_959_ = _e537;
                } else {
                    phi_959_ = _e561;
                }
                let _e564 = phi_959_;
                let _e566 = local_12.member_3;
                let _e567 = (_e564 + _e566);
                let _e569 = ((_e513 * 8f) * _e567);
                let _e576 = local_12.member_3;
                if (_e265 < 0f) {
                    phi_990_ = -(_e265);
                } else {
                    phi_990_ = _e265;
                }
                let _e593 = phi_990_;
                if (_e268 < 0f) {
                    phi_996_ = -(_e268);
                } else {
                    phi_996_ = _e268;
                }
                let _e597 = phi_996_;
                if (_e271 < 0f) {
                    phi_1003_ = -(_e271);
                } else {
                    phi_1003_ = _e271;
                }
                let _e602 = phi_1003_;
                let _e603 = ((_e593 + _e597) + _e602);
                if (_e286 < 0f) {
                    phi_1010_ = -(_e286);
                } else {
                    phi_1010_ = _e286;
                }
                let _e607 = phi_1010_;
                if (_e289 < 0f) {
                    phi_1016_ = -(_e289);
                } else {
                    phi_1016_ = _e289;
                }
                let _e611 = phi_1016_;
                if (_e292 < 0f) {
                    phi_1023_ = -(_e292);
                } else {
                    phi_1023_ = _e292;
                }
                let _e616 = phi_1023_;
                let _e617 = ((_e607 + _e611) + _e616);
                if (_e603 > _e617) {
                    phi_1029_ = _e603;
                } else {
                    phi_1029_ = _e617;
                }
                let _e620 = phi_1029_;
                if (_e335 < 0f) {
                    phi_1035_ = -(_e335);
                } else {
                    phi_1035_ = _e335;
                }
                let _e624 = phi_1035_;
                if (_e336 < 0f) {
                    phi_1041_ = -(_e336);
                } else {
                    phi_1041_ = _e336;
                }
                let _e628 = phi_1041_;
                if (_e337 < 0f) {
                    phi_1048_ = -(_e337);
                } else {
                    phi_1048_ = _e337;
                }
                let _e633 = phi_1048_;
                let _e635 = (((_e624 + _e628) + _e633) * 0.5f);
                if (_e620 > _e635) {
                    phi_1055_ = _e620;
                } else {
                    phi_1055_ = _e635;
                }
                let _e638 = phi_1055_;
                let _e643 = local_12.member_3;
                let _e655 = (((((_e459 * 8f) * _e569) * (0.000000059604645f * (490f / 64f))) + ((_e576 * 19f) * ((_e459 * (_e513 + _e567)) + (_e513 * _e567)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e459) * ((1f + _e513) * (1f + _e567)))));
                let _e656 = (_e348 * 3f);
                let _e657 = (_e405 * 3f);
                if (_e656 < _e657) {
                    phi_1079_ = _e656;
                } else {
                    phi_1079_ = _e657;
                }
                let _e660 = phi_1079_;
                if (_e371 < _e394) {
                    phi_1084_ = _e371;
                } else {
                    phi_1084_ = _e394;
                }
                let _e663 = phi_1084_;
                if (_e660 < _e663) {
                    phi_1089_ = _e660;
                } else {
                    phi_1089_ = _e663;
                }
                let _e666 = phi_1089_;
                if (_e656 > _e657) {
                    phi_1094_ = _e656;
                } else {
                    phi_1094_ = _e657;
                }
                let _e669 = phi_1094_;
                if (_e371 > _e394) {
                    phi_1099_ = _e371;
                } else {
                    phi_1099_ = _e394;
                }
                let _e672 = phi_1099_;
                if (_e669 > _e672) {
                    phi_1104_ = _e669;
                } else {
                    phi_1104_ = _e672;
                }
                let _e675 = phi_1104_;
                let _e680 = -(_e675);
                if (_e666 > _e680) {
                    phi_1114_ = _e666;
                } else {
                    phi_1114_ = _e680;
                }
                let _e683 = phi_1114_;
                if ((_e683 - (_e655 + ((_e250 * (((_e638 + (_e569 * (0.000000059604645f * 4f))) + ((_e643 * 6f) * (_e513 + _e567))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e513) * (1f + _e567))))) * (3f * 1.0001f)))) > 0f) {
                    phi_5481_ = type_34(0u, type_34().member_1);
                } else {
                    if (_e250 > 0f) {
                        let _e2718 = local_12.member[0u];
                        let _e2724 = local_12.member_1[0u];
                        let _e2730 = local_12.member_2[0u];
                        let _e2734 = (_e2718[0] - _e2724[0]);
                        let _e2735 = (_e2718[1] - _e2724[1]);
                        let _e2736 = (_e2718[2] - _e2724[2]);
                        local_9 = array<array<f32, 3>, 4>(_e2718, array<f32, 3>(_e2734, _e2735, _e2736), array<f32, 3>((_e2718[0] - _e2730[0]), (_e2718[1] - _e2730[1]), (_e2718[2] - _e2730[2])), array<f32, 3>((_e2734 - _e2730[0]), (_e2735 - _e2730[1]), (_e2736 - _e2730[2])));
                        let _e2749 = local_12.member[1u];
                        let _e2755 = local_12.member_1[1u];
                        let _e2761 = local_12.member_2[1u];
                        let _e2765 = (_e2749[0] - _e2755[0]);
                        let _e2766 = (_e2749[1] - _e2755[1]);
                        let _e2767 = (_e2749[2] - _e2755[2]);
                        local_10 = array<array<f32, 3>, 4>(_e2749, array<f32, 3>(_e2765, _e2766, _e2767), array<f32, 3>((_e2749[0] - _e2761[0]), (_e2749[1] - _e2761[1]), (_e2749[2] - _e2761[2])), array<f32, 3>((_e2765 - _e2761[0]), (_e2766 - _e2761[1]), (_e2767 - _e2761[2])));
                        let _e2780 = local_12.member[0u];
                        if (_e2780[0] < 0f) {
                            phi_1315_ = -(_e2780[0]);
                        } else {
                            phi_1315_ = _e2780[0];
                        }
                        let _e2787 = phi_1315_;
                        if (_e2780[1] < 0f) {
                            phi_1322_ = -(_e2780[1]);
                        } else {
                            phi_1322_ = _e2780[1];
                        }
                        let _e2791 = phi_1322_;
                        if (_e2787 > _e2791) {
                            phi_1327_ = _e2787;
                        } else {
                            phi_1327_ = _e2791;
                        }
                        let _e2794 = phi_1327_;
                        if (_e2780[2] < 0f) {
                            phi_1334_ = -(_e2780[2]);
                        } else {
                            phi_1334_ = _e2780[2];
                        }
                        let _e2798 = phi_1334_;
                        if (_e2794 > _e2798) {
                            phi_1339_ = _e2794;
                        } else {
                            phi_1339_ = _e2798;
                        }
                        let _e2801 = phi_1339_;
                        let _e2804 = local_12.member[1u];
                        if (_e2804[0] < 0f) {
                            phi_1352_ = -(_e2804[0]);
                        } else {
                            phi_1352_ = _e2804[0];
                        }
                        let _e2811 = phi_1352_;
                        if (_e2804[1] < 0f) {
                            phi_1359_ = -(_e2804[1]);
                        } else {
                            phi_1359_ = _e2804[1];
                        }
                        let _e2815 = phi_1359_;
                        if (_e2811 > _e2815) {
                            phi_1364_ = _e2811;
                        } else {
                            phi_1364_ = _e2815;
                        }
                        let _e2818 = phi_1364_;
                        if (_e2804[2] < 0f) {
                            phi_1371_ = -(_e2804[2]);
                        } else {
                            phi_1371_ = _e2804[2];
                        }
                        let _e2822 = phi_1371_;
                        if (_e2818 > _e2822) {
                            phi_1376_ = _e2818;
                        } else {
                            phi_1376_ = _e2822;
                        }
                        let _e2825 = phi_1376_;
                        if (_e2801 > _e2825) {
                            phi_1381_ = _e2801;
                        } else {
                            phi_1381_ = _e2825;
                        }
                        let _e2828 = phi_1381_;
                        let _e2830 = local_12.member_3;
                        let _e2834 = local_12.member_1[0u];
                        if (_e2834[0] < 0f) {
                            phi_1398_ = -(_e2834[0]);
                        } else {
                            phi_1398_ = _e2834[0];
                        }
                        let _e2841 = phi_1398_;
                        if (_e2834[1] < 0f) {
                            phi_1405_ = -(_e2834[1]);
                        } else {
                            phi_1405_ = _e2834[1];
                        }
                        let _e2845 = phi_1405_;
                        if (_e2841 > _e2845) {
                            phi_1410_ = _e2841;
                        } else {
                            phi_1410_ = _e2845;
                        }
                        let _e2848 = phi_1410_;
                        if (_e2834[2] < 0f) {
                            phi_1417_ = -(_e2834[2]);
                        } else {
                            phi_1417_ = _e2834[2];
                        }
                        let _e2852 = phi_1417_;
                        if (_e2848 > _e2852) {
                            phi_1422_ = _e2848;
                        } else {
                            phi_1422_ = _e2852;
                        }
                        let _e2855 = phi_1422_;
                        let _e2858 = local_12.member_1[1u];
                        if (_e2858[0] < 0f) {
                            phi_1436_ = -(_e2858[0]);
                        } else {
                            phi_1436_ = _e2858[0];
                        }
                        let _e2865 = phi_1436_;
                        if (_e2858[1] < 0f) {
                            phi_1443_ = -(_e2858[1]);
                        } else {
                            phi_1443_ = _e2858[1];
                        }
                        let _e2869 = phi_1443_;
                        if (_e2865 > _e2869) {
                            phi_1448_ = _e2865;
                        } else {
                            phi_1448_ = _e2869;
                        }
                        let _e2872 = phi_1448_;
                        if (_e2858[2] < 0f) {
                            phi_1455_ = -(_e2858[2]);
                        } else {
                            phi_1455_ = _e2858[2];
                        }
                        let _e2876 = phi_1455_;
                        if (_e2872 > _e2876) {
                            phi_1460_ = _e2872;
                        } else {
                            phi_1460_ = _e2876;
                        }
                        let _e2879 = phi_1460_;
                        if (_e2855 > _e2879) {
                            phi_1465_ = _e2855;
                        } else {
                            phi_1465_ = _e2879;
                        }
                        let _e2882 = phi_1465_;
                        let _e2884 = local_12.member_3;
                        let _e2888 = local_12.member_2[0u];
                        if (_e2888[0] < 0f) {
                            phi_1482_ = -(_e2888[0]);
                        } else {
                            phi_1482_ = _e2888[0];
                        }
                        let _e2895 = phi_1482_;
                        if (_e2888[1] < 0f) {
                            phi_1489_ = -(_e2888[1]);
                        } else {
                            phi_1489_ = _e2888[1];
                        }
                        let _e2899 = phi_1489_;
                        if (_e2895 > _e2899) {
                            phi_1494_ = _e2895;
                        } else {
                            phi_1494_ = _e2899;
                        }
                        let _e2902 = phi_1494_;
                        if (_e2888[2] < 0f) {
                            phi_1501_ = -(_e2888[2]);
                        } else {
                            phi_1501_ = _e2888[2];
                        }
                        let _e2906 = phi_1501_;
                        if (_e2902 > _e2906) {
                            phi_1506_ = _e2902;
                        } else {
                            phi_1506_ = _e2906;
                        }
                        let _e2909 = phi_1506_;
                        let _e2912 = local_12.member_2[1u];
                        if (_e2912[0] < 0f) {
                            phi_1520_ = -(_e2912[0]);
                        } else {
                            phi_1520_ = _e2912[0];
                        }
                        let _e2919 = phi_1520_;
                        if (_e2912[1] < 0f) {
                            phi_1527_ = -(_e2912[1]);
                        } else {
                            phi_1527_ = _e2912[1];
                        }
                        let _e2923 = phi_1527_;
                        if (_e2919 > _e2923) {
                            phi_1532_ = _e2919;
                        } else {
                            phi_1532_ = _e2923;
                        }
                        let _e2926 = phi_1532_;
                        if (_e2912[2] < 0f) {
                            phi_1539_ = -(_e2912[2]);
                        } else {
                            phi_1539_ = _e2912[2];
                        }
                        let _e2930 = phi_1539_;
                        if (_e2926 > _e2930) {
                            phi_1544_ = _e2926;
                        } else {
                            phi_1544_ = _e2930;
                        }
                        let _e2933 = phi_1544_;
                        if (_e2909 > _e2933) {
                            phi_1549_ = _e2909;
                        } else {
                            phi_1549_ = _e2933;
                        }
                        let _e2936 = phi_1549_;
                        let _e2938 = local_12.member_3;
                        let _e2945 = local_12.member_3;
                        phi_1565_ = type_9(0u, 48u);
                        phi_1568_ = 0f;
                        loop {
                            let _e2951 = phi_1565_;
                            let _e2953 = phi_1568_;
                            local_77 = _e2953;
                            local_37 = _e2953;
                            local_38 = _e2953;
                            local_39 = _e2953;
                            local_40 = _e2953;
                            if (_e2951.member < _e2951.member_1) {
                                phi_1566_ = type_9((_e2951.member + 1u), _e2951.member_1);
                                phi_1591_ = type_9(1u, _e2951.member);
                            } else {
                                phi_1566_ = _e2951;
                                phi_1591_ = type_9(0u, type_9().member_1);
                            }
                            let _e2965 = phi_1566_;
                            let _e2967 = phi_1591_;
                            if (bitcast<i32>(_e2967.member) != 0i) {
                                let _e2973 = local_12.member[0u];
                                let _e2979 = local_12.member[1u];
                                let _e2995 = local_12.member_1[0u];
                                let _e3001 = local_12.member_1[1u];
                                let _e3017 = local_12.member_2[0u];
                                let _e3023 = local_12.member_2[1u];
                                let _e3037 = function_2(array<f32, 3>((_e2973[0] + ((_e2979[0] - _e2973[0]) * _e2953)), (_e2973[1] + ((_e2979[1] - _e2973[1]) * _e2953)), (_e2973[2] + ((_e2979[2] - _e2973[2]) * _e2953))), array<f32, 3>((_e2995[0] + ((_e3001[0] - _e2995[0]) * _e2953)), (_e2995[1] + ((_e3001[1] - _e2995[1]) * _e2953)), (_e2995[2] + ((_e3001[2] - _e2995[2]) * _e2953))), array<f32, 3>((_e3017[0] + ((_e3023[0] - _e3017[0]) * _e2953)), (_e3017[1] + ((_e3023[1] - _e3017[1]) * _e2953)), (_e3017[2] + ((_e3023[2] - _e3017[2]) * _e2953))), 1u);
                                if (_e3037[0] < 0f) {
                                    phi_1702_ = -(_e3037[0]);
                                } else {
                                    phi_1702_ = _e3037[0];
                                }
                                let _e3042 = phi_1702_;
                                if (_e3037[1] < 0f) {
                                    phi_1709_ = -(_e3037[1]);
                                } else {
                                    phi_1709_ = _e3037[1];
                                }
                                let _e3047 = phi_1709_;
                                if (_e3037[2] < 0f) {
                                    phi_1717_ = -(_e3037[2]);
                                } else {
                                    phi_1717_ = _e3037[2];
                                }
                                let _e3053 = phi_1717_;
                                let _e3054 = ((_e3042 + _e3047) + _e3053);
                                if (_e3054 > 0f) {
                                    if ((bitcast<u32>(_e3054) & 2139095040u) != 2139095040u) {
                                        let _e3059 = (1f / _e3054);
                                        let _e3061 = (_e3037[0] * _e3059);
                                        let _e3063 = (_e3037[1] * _e3059);
                                        let _e3065 = (_e3037[2] * _e3059);
                                        let _e3070 = (((_e3061 * _e3061) + (_e3063 * _e3063)) + (_e3065 * _e3065));
                                        if (_e3070 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3070 > 0f) {
                                                phi_1754_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_1754_ = 0f;
                                            }
                                            let _e3123 = phi_1754_;
                                            phi_1818_ = _e3123;
                                        } else {
                                            phi_1761_ = type_14(0i, 5i);
                                            phi_1764_ = bitcast<f32>(((bitcast<u32>(_e3070) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3078 = phi_1761_;
                                                let _e3080 = phi_1764_;
                                                local_31 = _e3080;
                                                if (_e3078.member < _e3078.member_1) {
                                                    let _e3087 = (_e3078.member + 1i);
                                                    if ((false == (_e3087 > _e3078.member)) != false) {
                                                        phi_1785_ = true;
                                                    } else {
                                                        phi_1785_ = false;
                                                    }
                                                    let _e3092 = phi_1785_;
                                                    if _e3092 {
                                                        phi_1791_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_1791_ = type_15(1u, _e3087);
                                                    }
                                                    let _e3097 = phi_1791_;
                                                    phi_1762_ = type_14(_e3097.member_1, _e3078.member_1);
                                                    phi_1805_ = type_15(1u, _e3078.member);
                                                } else {
                                                    phi_1762_ = _e3078;
                                                    phi_1805_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3103 = phi_1762_;
                                                let _e3105 = phi_1805_;
                                                let _e3108 = (bitcast<i32>(_e3105.member) != 0i);
                                                if _e3108 {
                                                    phi_1765_ = (0.5f * (_e3080 + (_e3070 / _e3080)));
                                                } else {
                                                    phi_1765_ = f32();
                                                }
                                                let _e3113 = phi_1765_;
                                                continue;
                                                continuing {
                                                    phi_1761_ = _e3103;
                                                    phi_1764_ = _e3113;
                                                    break if !(_e3108);
                                                }
                                            }
                                            let _e3118 = local_31;
                                            phi_1818_ = (_e3118 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3125 = phi_1818_;
                                        phi_1827_ = type_9(0u, 4u);
                                        phi_1830_ = 2f;
                                        loop {
                                            let _e3133 = phi_1827_;
                                            let _e3135 = phi_1830_;
                                            local_33 = _e3135;
                                            local_34 = _e3135;
                                            local_35 = _e3135;
                                            local_67 = _e3135;
                                            local_68 = _e3135;
                                            if (_e3133.member < _e3133.member_1) {
                                                phi_1828_ = type_9((_e3133.member + 1u), _e3133.member_1);
                                                phi_1853_ = type_9(1u, _e3133.member);
                                            } else {
                                                phi_1828_ = _e3133;
                                                phi_1853_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e3147 = phi_1828_;
                                            let _e3149 = phi_1853_;
                                            if (bitcast<i32>(_e3149.member) != 0i) {
                                                let _e3155 = local_9[_e3149.member_1];
                                                let _e3163 = (((_e3061 * _e3155[0]) + (_e3063 * _e3155[1])) + (_e3065 * _e3155[2]));
                                                let _e3165 = local_10[_e3149.member_1];
                                                let _e3173 = (((_e3061 * _e3165[0]) + (_e3063 * _e3165[1])) + (_e3065 * _e3165[2]));
                                                if (_e3163 < 0f) {
                                                    phi_1904_ = -(_e3163);
                                                } else {
                                                    phi_1904_ = _e3163;
                                                }
                                                let _e3177 = phi_1904_;
                                                if (_e3173 < 0f) {
                                                    phi_1910_ = -(_e3173);
                                                } else {
                                                    phi_1910_ = _e3173;
                                                }
                                                let _e3181 = phi_1910_;
                                                let _e3185 = (((((((((_e2828 + _e2830) + (_e2882 + _e2884)) + (_e2936 + _e2938)) * (0.000000059604645f * 16f)) + (_e2945 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e250 * _e3125) * (1f + (0.000000059604645f * 8f)))) + ((_e3177 + _e3181) * (0.000000059604645f * 8f)));
                                                if (_e3163 > _e3185) {
                                                    if (_e3173 > _e3185) {
                                                        phi_1923_ = false;
                                                    } else {
                                                        phi_1923_ = true;
                                                    }
                                                    let _e3189 = phi_1923_;
                                                    phi_1924_ = _e3189;
                                                } else {
                                                    phi_1924_ = true;
                                                }
                                                let _e3191 = phi_1924_;
                                                if _e3191 {
                                                    if ((_e3163 + ((_e3173 - _e3163) * _e2953)) > _e3185) {
                                                        if (_e3173 < _e3163) {
                                                            let _e3199 = ((_e3163 - _e3173) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3199 {
                                                                let _e3205 = (((_e3163 - _e3185) / (_e3163 - _e3173)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3135 < _e3205) {
                                                                    phi_1955_ = _e3135;
                                                                } else {
                                                                    phi_1955_ = _e3205;
                                                                }
                                                                let _e3208 = phi_1955_;
                                                                phi_1956_ = _e3208;
                                                            } else {
                                                                phi_1956_ = f32();
                                                            }
                                                            let _e3210 = phi_1956_;
                                                            phi_1957_ = _e3210;
                                                            phi_1958_ = _e3199;
                                                        } else {
                                                            phi_1957_ = _e3135;
                                                            phi_1958_ = true;
                                                        }
                                                        let _e3212 = phi_1957_;
                                                        let _e3214 = phi_1958_;
                                                        if _e3214 {
                                                            phi_1962_ = false;
                                                        } else {
                                                            phi_1962_ = true;
                                                        }
                                                        let _e3216 = phi_1962_;
                                                        phi_1963_ = _e3212;
                                                        phi_1964_ = _e3214;
                                                        phi_1965_ = _e3216;
                                                        phi_1966_ = false;
                                                    } else {
                                                        phi_1963_ = f32();
                                                        phi_1964_ = false;
                                                        phi_1965_ = false;
                                                        phi_1966_ = true;
                                                    }
                                                    let _e3218 = phi_1963_;
                                                    let _e3220 = phi_1964_;
                                                    let _e3222 = phi_1965_;
                                                    let _e3224 = phi_1966_;
                                                    phi_1967_ = _e3218;
                                                    phi_1968_ = _e3220;
                                                    phi_1969_ = _e3222;
                                                    phi_1970_ = _e3224;
                                                } else {
                                                    phi_1967_ = _e3135;
                                                    phi_1968_ = true;
                                                    phi_1969_ = false;
                                                    phi_1970_ = false;
                                                }
                                                let _e3226 = phi_1967_;
                                                let _e3228 = phi_1968_;
                                                let _e3230 = phi_1969_;
                                                let _e3232 = phi_1970_;
                                                phi_1831_ = _e3226;
                                                phi_1971_ = _e3228;
                                                phi_1972_ = false;
                                                phi_1973_ = _e3230;
                                                phi_1974_ = _e3232;
                                            } else {
                                                phi_1831_ = f32();
                                                phi_1971_ = false;
                                                phi_1972_ = true;
                                                phi_1973_ = false;
                                                phi_1974_ = false;
                                            }
                                            let _e3234 = phi_1831_;
                                            let _e3236 = phi_1971_;
                                            let _e3238 = phi_1972_;
                                            let _e3240 = phi_1973_;
                                            let _e3242 = phi_1974_;
                                            local_32 = _e3238;
                                            local_65 = _e3240;
                                            local_66 = _e3242;
                                            continue;
                                            continuing {
                                                phi_1827_ = _e3147;
                                                phi_1830_ = _e3234;
                                                break if !(_e3236);
                                            }
                                        }
                                        let _e3245 = local_32;
                                        if _e3245 {
                                            let _e3247 = local_33;
                                            let _e3248 = (_e3247 > 1f);
                                            if _e3248 {
                                                phi_1995_ = false;
                                                phi_1996_ = false;
                                                phi_1997_ = false;
                                            } else {
                                                let _e3250 = local_34;
                                                if (_e3250 > _e2953) {
                                                    let _e3253 = local_35;
                                                    let _e3255 = ((_e3253 - _e2953) < 0.00000000023283064f);
                                                    if _e3255 {
                                                        phi_1991_ = false;
                                                    } else {
                                                        phi_1991_ = true;
                                                    }
                                                    let _e3257 = phi_1991_;
                                                    phi_1992_ = _e3257;
                                                    phi_1993_ = _e3255;
                                                    phi_1994_ = false;
                                                } else {
                                                    phi_1992_ = false;
                                                    phi_1993_ = false;
                                                    phi_1994_ = true;
                                                }
                                                let _e3259 = phi_1992_;
                                                let _e3261 = phi_1993_;
                                                let _e3263 = phi_1994_;
                                                phi_1995_ = _e3259;
                                                phi_1996_ = _e3261;
                                                phi_1997_ = _e3263;
                                            }
                                            let _e3265 = phi_1995_;
                                            let _e3267 = phi_1996_;
                                            let _e3269 = phi_1997_;
                                            phi_1998_ = _e3265;
                                            phi_1999_ = _e3248;
                                            phi_2000_ = _e3267;
                                            phi_2001_ = _e3269;
                                            phi_2002_ = false;
                                            phi_2003_ = false;
                                        } else {
                                            phi_1998_ = false;
                                            phi_1999_ = false;
                                            phi_2000_ = false;
                                            phi_2001_ = false;
                                            let _e4571 = local_65;
                                            phi_2002_ = _e4571;
                                            let _e4574 = local_66;
                                            phi_2003_ = _e4574;
                                        }
                                        let _e3271 = phi_1998_;
                                        let _e3273 = phi_1999_;
                                        let _e3275 = phi_2000_;
                                        let _e3277 = phi_2001_;
                                        let _e3279 = phi_2002_;
                                        let _e3281 = phi_2003_;
                                        let _e4577 = local_67;
                                        phi_2004_ = _e4577;
                                        let _e4580 = local_68;
                                        phi_2005_ = _e4580;
                                        phi_2006_ = _e3271;
                                        phi_2007_ = _e3273;
                                        phi_2008_ = _e3275;
                                        phi_2009_ = _e3277;
                                        phi_2010_ = _e3279;
                                        phi_2011_ = _e3281;
                                        phi_2012_ = false;
                                    } else {
                                        phi_2004_ = f32();
                                        phi_2005_ = f32();
                                        phi_2006_ = false;
                                        phi_2007_ = false;
                                        phi_2008_ = false;
                                        phi_2009_ = false;
                                        phi_2010_ = false;
                                        phi_2011_ = false;
                                        phi_2012_ = true;
                                    }
                                    let _e3283 = phi_2004_;
                                    let _e3285 = phi_2005_;
                                    let _e3287 = phi_2006_;
                                    let _e3289 = phi_2007_;
                                    let _e3291 = phi_2008_;
                                    let _e3293 = phi_2009_;
                                    let _e3295 = phi_2010_;
                                    let _e3297 = phi_2011_;
                                    let _e3299 = phi_2012_;
                                    phi_2013_ = _e3283;
                                    phi_2014_ = _e3285;
                                    phi_2015_ = _e3287;
                                    phi_2016_ = _e3289;
                                    phi_2017_ = _e3291;
                                    phi_2018_ = _e3293;
                                    phi_2019_ = _e3295;
                                    phi_2020_ = _e3297;
                                    phi_2021_ = _e3299;
                                    phi_2022_ = false;
                                } else {
                                    phi_2013_ = f32();
                                    phi_2014_ = f32();
                                    phi_2015_ = false;
                                    phi_2016_ = false;
                                    phi_2017_ = false;
                                    phi_2018_ = false;
                                    phi_2019_ = false;
                                    phi_2020_ = false;
                                    phi_2021_ = false;
                                    phi_2022_ = true;
                                }
                                let _e3301 = phi_2013_;
                                let _e3303 = phi_2014_;
                                let _e3305 = phi_2015_;
                                let _e3307 = phi_2016_;
                                let _e3309 = phi_2017_;
                                let _e3311 = phi_2018_;
                                let _e3313 = phi_2019_;
                                let _e3315 = phi_2020_;
                                let _e3317 = phi_2021_;
                                let _e3319 = phi_2022_;
                                phi_2023_ = _e3301;
                                phi_1569_ = _e3303;
                                phi_2024_ = _e3305;
                                phi_2025_ = _e3307;
                                phi_2026_ = _e3309;
                                phi_2027_ = false;
                                phi_2028_ = _e3311;
                                phi_2029_ = _e3313;
                                phi_2030_ = _e3315;
                                phi_2031_ = _e3317;
                                phi_2032_ = _e3319;
                            } else {
                                phi_2023_ = f32();
                                phi_1569_ = f32();
                                phi_2024_ = false;
                                phi_2025_ = false;
                                phi_2026_ = false;
                                phi_2027_ = true;
                                phi_2028_ = false;
                                phi_2029_ = false;
                                phi_2030_ = false;
                                phi_2031_ = false;
                                phi_2032_ = false;
                            }
                            let _e3321 = phi_2023_;
                            let _e3323 = phi_1569_;
                            let _e3325 = phi_2024_;
                            let _e3327 = phi_2025_;
                            let _e3329 = phi_2026_;
                            let _e3331 = phi_2027_;
                            let _e3333 = phi_2028_;
                            let _e3335 = phi_2029_;
                            let _e3337 = phi_2030_;
                            let _e3339 = phi_2031_;
                            let _e3341 = phi_2032_;
                            local_36 = _e3327;
                            local_69 = _e3329;
                            local_70 = _e3331;
                            local_71 = _e3333;
                            local_72 = _e3335;
                            local_73 = _e3337;
                            local_74 = _e3339;
                            local_75 = _e3341;
                            local_76 = _e3321;
                            local_78 = _e3327;
                            continue;
                            continuing {
                                phi_1565_ = _e2965;
                                phi_1568_ = _e3323;
                                break if !(_e3325);
                            }
                        }
                        let _e3344 = local_36;
                        if _e3344 {
                            phi_2037_ = type_34(0u, type_34().member_1);
                            phi_2038_ = false;
                            phi_2039_ = false;
                            phi_2040_ = false;
                            phi_2041_ = false;
                            phi_2042_ = false;
                            phi_2043_ = false;
                            phi_2044_ = false;
                        } else {
                            phi_2037_ = type_34();
                            let _e4613 = local_69;
                            phi_2038_ = _e4613;
                            let _e4616 = local_70;
                            phi_2039_ = _e4616;
                            let _e4619 = local_71;
                            phi_2040_ = _e4619;
                            let _e4622 = local_72;
                            phi_2041_ = _e4622;
                            let _e4625 = local_73;
                            phi_2042_ = _e4625;
                            let _e4628 = local_74;
                            phi_2043_ = _e4628;
                            let _e4631 = local_75;
                            phi_2044_ = _e4631;
                        }
                        let _e3348 = phi_2037_;
                        let _e3350 = phi_2038_;
                        let _e3352 = phi_2039_;
                        let _e3354 = phi_2040_;
                        let _e3356 = phi_2041_;
                        let _e3358 = phi_2042_;
                        let _e3360 = phi_2043_;
                        let _e3362 = phi_2044_;
                        if _e3350 {
                            let _e4634 = local_76;
                            phi_2048_ = _e4634;
                            phi_2049_ = true;
                            phi_2050_ = false;
                            phi_2051_ = false;
                            phi_2052_ = false;
                            phi_2053_ = false;
                            phi_2054_ = false;
                            phi_2055_ = false;
                        } else {
                            let _e4636 = local_77;
                            phi_2048_ = _e4636;
                            phi_2049_ = _e3352;
                            phi_2050_ = _e3354;
                            phi_2051_ = _e3356;
                            phi_2052_ = _e3358;
                            let _e4643 = local_78;
                            phi_2053_ = _e4643;
                            phi_2054_ = _e3360;
                            phi_2055_ = _e3362;
                        }
                        let _e3364 = phi_2048_;
                        let _e3366 = phi_2049_;
                        let _e3368 = phi_2050_;
                        let _e3370 = phi_2051_;
                        let _e3372 = phi_2052_;
                        let _e3374 = phi_2053_;
                        let _e3376 = phi_2054_;
                        let _e3378 = phi_2055_;
                        if _e3366 {
                            phi_2060_ = type_34(1u, _e3364);
                            phi_2061_ = false;
                            phi_2062_ = false;
                            phi_2063_ = false;
                            phi_2064_ = false;
                            phi_2065_ = false;
                            phi_2066_ = false;
                        } else {
                            phi_2060_ = type_34();
                            phi_2061_ = _e3368;
                            phi_2062_ = _e3370;
                            phi_2063_ = _e3372;
                            phi_2064_ = _e3374;
                            phi_2065_ = _e3376;
                            phi_2066_ = _e3378;
                        }
                        let _e3381 = phi_2060_;
                        let _e3383 = phi_2061_;
                        let _e3385 = phi_2062_;
                        let _e3387 = phi_2063_;
                        let _e3389 = phi_2064_;
                        let _e3391 = phi_2065_;
                        let _e3393 = phi_2066_;
                        if _e3383 {
                            let _e3395 = local_37;
                            phi_2071_ = type_34(1u, _e3395);
                            phi_2072_ = false;
                            phi_2073_ = false;
                            phi_2074_ = true;
                            phi_2075_ = false;
                            phi_2076_ = false;
                        } else {
                            phi_2071_ = _e3348;
                            phi_2072_ = _e3385;
                            phi_2073_ = _e3387;
                            phi_2074_ = _e3389;
                            phi_2075_ = _e3391;
                            phi_2076_ = _e3393;
                        }
                        let _e3398 = phi_2071_;
                        let _e3400 = phi_2072_;
                        let _e3402 = phi_2073_;
                        let _e3404 = phi_2074_;
                        let _e3406 = phi_2075_;
                        let _e3408 = phi_2076_;
                        if _e3400 {
                            let _e3410 = local_38;
                            phi_2081_ = type_34(1u, _e3410);
                            phi_2082_ = false;
                            phi_2083_ = false;
                            phi_2084_ = false;
                            phi_2085_ = false;
                        } else {
                            phi_2081_ = type_34();
                            phi_2082_ = _e3402;
                            phi_2083_ = _e3404;
                            phi_2084_ = _e3406;
                            phi_2085_ = _e3408;
                        }
                        let _e3413 = phi_2081_;
                        let _e3415 = phi_2082_;
                        let _e3417 = phi_2083_;
                        let _e3419 = phi_2084_;
                        let _e3421 = phi_2085_;
                        if _e3415 {
                            let _e3423 = local_39;
                            phi_2090_ = type_34(1u, _e3423);
                            phi_2091_ = true;
                            phi_2092_ = false;
                            phi_2093_ = false;
                            phi_2094_ = false;
                        } else {
                            phi_2090_ = _e3413;
                            phi_2091_ = _e3400;
                            phi_2092_ = _e3417;
                            phi_2093_ = _e3419;
                            phi_2094_ = _e3421;
                        }
                        let _e3426 = phi_2090_;
                        let _e3428 = phi_2091_;
                        let _e3430 = phi_2092_;
                        let _e3432 = phi_2093_;
                        let _e3434 = phi_2094_;
                        if _e3428 {
                            phi_2098_ = _e3426;
                            phi_2099_ = true;
                            phi_2100_ = false;
                            phi_2101_ = false;
                        } else {
                            phi_2098_ = _e3398;
                            phi_2099_ = _e3430;
                            phi_2100_ = _e3432;
                            phi_2101_ = _e3434;
                        }
                        let _e3436 = phi_2098_;
                        let _e3438 = phi_2099_;
                        let _e3440 = phi_2100_;
                        let _e3442 = phi_2101_;
                        if _e3438 {
                            phi_2105_ = false;
                            phi_2106_ = false;
                        } else {
                            phi_2105_ = _e3440;
                            phi_2106_ = _e3442;
                        }
                        let _e3444 = phi_2105_;
                        let _e3446 = phi_2106_;
                        if _e3444 {
                            phi_2110_ = false;
                            phi_2111_ = false;
                        } else {
                            phi_2110_ = _e3446;
                            phi_2111_ = _e3438;
                        }
                        let _e3448 = phi_2110_;
                        let _e3450 = phi_2111_;
                        if _e3448 {
                            phi_2115_ = true;
                            phi_2116_ = false;
                        } else {
                            phi_2115_ = _e3444;
                            phi_2116_ = _e3450;
                        }
                        let _e3452 = phi_2115_;
                        let _e3454 = phi_2116_;
                        if _e3452 {
                            let _e3456 = local_40;
                            phi_2121_ = type_34(1u, _e3456);
                            phi_2122_ = true;
                        } else {
                            phi_2121_ = _e3436;
                            phi_2122_ = _e3454;
                        }
                        let _e3459 = phi_2121_;
                        let _e3461 = phi_2122_;
                        if _e3461 {
                            phi_2126_ = _e3459;
                        } else {
                            phi_2126_ = _e3381;
                        }
                        let _e3463 = phi_2126_;
                        if (_e3463.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_2140_ = type_9(0u, 3u);
                            loop {
                                let _e3475 = phi_2140_;
                                if (_e3475.member < _e3475.member_1) {
                                    phi_2141_ = type_9((_e3475.member + 1u), _e3475.member_1);
                                    phi_2164_ = type_9(1u, _e3475.member);
                                } else {
                                    phi_2141_ = _e3475;
                                    phi_2164_ = type_9(0u, type_9().member_1);
                                }
                                let _e3487 = phi_2141_;
                                let _e3489 = phi_2164_;
                                if (bitcast<i32>(_e3489.member) != 0i) {
                                    let _e3495 = local_11[_e3489.member_1];
                                    let _e3496 = (_e3463.member_1 + _e3495);
                                    if (_e3496 < 1f) {
                                        phi_2184_ = _e3496;
                                    } else {
                                        phi_2184_ = 1f;
                                    }
                                    let _e3499 = phi_2184_;
                                    let _e3502 = local_12.member[0u];
                                    let _e3508 = local_12.member[1u];
                                    let _e3524 = local_12.member_1[0u];
                                    let _e3530 = local_12.member_1[1u];
                                    let _e3546 = local_12.member_2[0u];
                                    let _e3552 = local_12.member_2[1u];
                                    let _e3566 = function_2(array<f32, 3>((_e3502[0] + ((_e3508[0] - _e3502[0]) * _e3499)), (_e3502[1] + ((_e3508[1] - _e3502[1]) * _e3499)), (_e3502[2] + ((_e3508[2] - _e3502[2]) * _e3499))), array<f32, 3>((_e3524[0] + ((_e3530[0] - _e3524[0]) * _e3499)), (_e3524[1] + ((_e3530[1] - _e3524[1]) * _e3499)), (_e3524[2] + ((_e3530[2] - _e3524[2]) * _e3499))), array<f32, 3>((_e3546[0] + ((_e3552[0] - _e3546[0]) * _e3499)), (_e3546[1] + ((_e3552[1] - _e3546[1]) * _e3499)), (_e3546[2] + ((_e3552[2] - _e3546[2]) * _e3499))), 1u);
                                    let _e3577 = (((_e3566[0] * _e3566[0]) + (_e3566[1] * _e3566[1])) + (_e3566[2] * _e3566[2]));
                                    if (_e3577 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e3577 > 0f) {
                                            phi_2307_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_2307_ = 0f;
                                        }
                                        let _e3630 = phi_2307_;
                                        phi_2371_ = _e3630;
                                    } else {
                                        phi_2314_ = type_14(0i, 5i);
                                        phi_2317_ = bitcast<f32>(((bitcast<u32>(_e3577) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e3585 = phi_2314_;
                                            let _e3587 = phi_2317_;
                                            local_41 = _e3587;
                                            if (_e3585.member < _e3585.member_1) {
                                                let _e3594 = (_e3585.member + 1i);
                                                if ((false == (_e3594 > _e3585.member)) != false) {
                                                    phi_2338_ = true;
                                                } else {
                                                    phi_2338_ = false;
                                                }
                                                let _e3599 = phi_2338_;
                                                if _e3599 {
                                                    phi_2344_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_2344_ = type_15(1u, _e3594);
                                                }
                                                let _e3604 = phi_2344_;
                                                phi_2315_ = type_14(_e3604.member_1, _e3585.member_1);
                                                phi_2358_ = type_15(1u, _e3585.member);
                                            } else {
                                                phi_2315_ = _e3585;
                                                phi_2358_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e3610 = phi_2315_;
                                            let _e3612 = phi_2358_;
                                            let _e3615 = (bitcast<i32>(_e3612.member) != 0i);
                                            if _e3615 {
                                                phi_2318_ = (0.5f * (_e3587 + (_e3577 / _e3587)));
                                            } else {
                                                phi_2318_ = f32();
                                            }
                                            let _e3620 = phi_2318_;
                                            continue;
                                            continuing {
                                                phi_2314_ = _e3610;
                                                phi_2317_ = _e3620;
                                                break if !(_e3615);
                                            }
                                        }
                                        let _e3625 = local_41;
                                        phi_2371_ = (_e3625 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e3632 = phi_2371_;
                                    let _e3638 = local_12.member[0u];
                                    if (_e3638[0] < 0f) {
                                        phi_2387_ = -(_e3638[0]);
                                    } else {
                                        phi_2387_ = _e3638[0];
                                    }
                                    let _e3645 = phi_2387_;
                                    if (_e3638[1] < 0f) {
                                        phi_2394_ = -(_e3638[1]);
                                    } else {
                                        phi_2394_ = _e3638[1];
                                    }
                                    let _e3649 = phi_2394_;
                                    if (_e3645 > _e3649) {
                                        phi_2399_ = _e3645;
                                    } else {
                                        phi_2399_ = _e3649;
                                    }
                                    let _e3652 = phi_2399_;
                                    if (_e3638[2] < 0f) {
                                        phi_2406_ = -(_e3638[2]);
                                    } else {
                                        phi_2406_ = _e3638[2];
                                    }
                                    let _e3656 = phi_2406_;
                                    if (_e3652 > _e3656) {
                                        phi_2411_ = _e3652;
                                    } else {
                                        phi_2411_ = _e3656;
                                    }
                                    let _e3659 = phi_2411_;
                                    let _e3662 = local_12.member[1u];
                                    if (_e3662[0] < 0f) {
                                        phi_2424_ = -(_e3662[0]);
                                    } else {
                                        phi_2424_ = _e3662[0];
                                    }
                                    let _e3669 = phi_2424_;
                                    if (_e3662[1] < 0f) {
                                        phi_2431_ = -(_e3662[1]);
                                    } else {
                                        phi_2431_ = _e3662[1];
                                    }
                                    let _e3673 = phi_2431_;
                                    if (_e3669 > _e3673) {
                                        phi_2436_ = _e3669;
                                    } else {
                                        phi_2436_ = _e3673;
                                    }
                                    let _e3676 = phi_2436_;
                                    if (_e3662[2] < 0f) {
                                        phi_2443_ = -(_e3662[2]);
                                    } else {
                                        phi_2443_ = _e3662[2];
                                    }
                                    let _e3680 = phi_2443_;
                                    if (_e3676 > _e3680) {
                                        phi_2448_ = _e3676;
                                    } else {
                                        phi_2448_ = _e3680;
                                    }
                                    let _e3683 = phi_2448_;
                                    if (_e3659 > _e3683) {
                                        phi_2453_ = _e3659;
                                    } else {
                                        phi_2453_ = _e3683;
                                    }
                                    let _e3686 = phi_2453_;
                                    let _e3688 = local_12.member_3;
                                    let _e3692 = local_12.member_1[0u];
                                    if (_e3692[0] < 0f) {
                                        phi_2470_ = -(_e3692[0]);
                                    } else {
                                        phi_2470_ = _e3692[0];
                                    }
                                    let _e3699 = phi_2470_;
                                    if (_e3692[1] < 0f) {
                                        phi_2477_ = -(_e3692[1]);
                                    } else {
                                        phi_2477_ = _e3692[1];
                                    }
                                    let _e3703 = phi_2477_;
                                    if (_e3699 > _e3703) {
                                        phi_2482_ = _e3699;
                                    } else {
                                        phi_2482_ = _e3703;
                                    }
                                    let _e3706 = phi_2482_;
                                    if (_e3692[2] < 0f) {
                                        phi_2489_ = -(_e3692[2]);
                                    } else {
                                        phi_2489_ = _e3692[2];
                                    }
                                    let _e3710 = phi_2489_;
                                    if (_e3706 > _e3710) {
                                        phi_2494_ = _e3706;
                                    } else {
                                        phi_2494_ = _e3710;
                                    }
                                    let _e3713 = phi_2494_;
                                    let _e3716 = local_12.member_1[1u];
                                    if (_e3716[0] < 0f) {
                                        phi_2508_ = -(_e3716[0]);
                                    } else {
                                        phi_2508_ = _e3716[0];
                                    }
                                    let _e3723 = phi_2508_;
                                    if (_e3716[1] < 0f) {
                                        phi_2515_ = -(_e3716[1]);
                                    } else {
                                        phi_2515_ = _e3716[1];
                                    }
                                    let _e3727 = phi_2515_;
                                    if (_e3723 > _e3727) {
                                        phi_2520_ = _e3723;
                                    } else {
                                        phi_2520_ = _e3727;
                                    }
                                    let _e3730 = phi_2520_;
                                    if (_e3716[2] < 0f) {
                                        phi_2527_ = -(_e3716[2]);
                                    } else {
                                        phi_2527_ = _e3716[2];
                                    }
                                    let _e3734 = phi_2527_;
                                    if (_e3730 > _e3734) {
                                        phi_2532_ = _e3730;
                                    } else {
                                        phi_2532_ = _e3734;
                                    }
                                    let _e3737 = phi_2532_;
                                    if (_e3713 > _e3737) {
                                        phi_2537_ = _e3713;
                                    } else {
                                        phi_2537_ = _e3737;
                                    }
                                    let _e3740 = phi_2537_;
                                    let _e3742 = local_12.member_3;
                                    let _e3746 = local_12.member_2[0u];
                                    if (_e3746[0] < 0f) {
                                        phi_2554_ = -(_e3746[0]);
                                    } else {
                                        phi_2554_ = _e3746[0];
                                    }
                                    let _e3753 = phi_2554_;
                                    if (_e3746[1] < 0f) {
                                        phi_2561_ = -(_e3746[1]);
                                    } else {
                                        phi_2561_ = _e3746[1];
                                    }
                                    let _e3757 = phi_2561_;
                                    if (_e3753 > _e3757) {
                                        phi_2566_ = _e3753;
                                    } else {
                                        phi_2566_ = _e3757;
                                    }
                                    let _e3760 = phi_2566_;
                                    if (_e3746[2] < 0f) {
                                        phi_2573_ = -(_e3746[2]);
                                    } else {
                                        phi_2573_ = _e3746[2];
                                    }
                                    let _e3764 = phi_2573_;
                                    if (_e3760 > _e3764) {
                                        phi_2578_ = _e3760;
                                    } else {
                                        phi_2578_ = _e3764;
                                    }
                                    let _e3767 = phi_2578_;
                                    let _e3770 = local_12.member_2[1u];
                                    if (_e3770[0] < 0f) {
                                        phi_2592_ = -(_e3770[0]);
                                    } else {
                                        phi_2592_ = _e3770[0];
                                    }
                                    let _e3777 = phi_2592_;
                                    if (_e3770[1] < 0f) {
                                        phi_2599_ = -(_e3770[1]);
                                    } else {
                                        phi_2599_ = _e3770[1];
                                    }
                                    let _e3781 = phi_2599_;
                                    if (_e3777 > _e3781) {
                                        phi_2604_ = _e3777;
                                    } else {
                                        phi_2604_ = _e3781;
                                    }
                                    let _e3784 = phi_2604_;
                                    if (_e3770[2] < 0f) {
                                        phi_2611_ = -(_e3770[2]);
                                    } else {
                                        phi_2611_ = _e3770[2];
                                    }
                                    let _e3788 = phi_2611_;
                                    if (_e3784 > _e3788) {
                                        phi_2616_ = _e3784;
                                    } else {
                                        phi_2616_ = _e3788;
                                    }
                                    let _e3791 = phi_2616_;
                                    if (_e3767 > _e3791) {
                                        phi_2621_ = _e3767;
                                    } else {
                                        phi_2621_ = _e3791;
                                    }
                                    let _e3794 = phi_2621_;
                                    let _e3796 = local_12.member_3;
                                    let _e3803 = local_12.member_3;
                                    let _e3810 = (((_e3632 * (1f + (0.000000059604645f * 8f))) + (((((((_e3686 + _e3688) + (_e3740 + _e3742)) + (_e3794 + _e3796)) * (0.000000059604645f * 16f)) + (_e3803 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e250);
                                    if _e3810 {
                                        phi_2641_ = false;
                                    } else {
                                        phi_2641_ = true;
                                    }
                                    let _e3812 = phi_2641_;
                                    phi_2642_ = _e3812;
                                    phi_2643_ = _e3810;
                                } else {
                                    phi_2642_ = false;
                                    phi_2643_ = false;
                                }
                                let _e3814 = phi_2642_;
                                let _e3816 = phi_2643_;
                                local_42 = _e3816;
                                continue;
                                continuing {
                                    phi_2140_ = _e3487;
                                    break if !(_e3814);
                                }
                            }
                            let _e3819 = local_42;
                            if _e3819 {
                                phi_2648_ = type_34(1u, _e3463.member_1);
                                phi_2649_ = false;
                            } else {
                                phi_2648_ = type_34();
                                phi_2649_ = true;
                            }
                            let _e3822 = phi_2648_;
                            let _e3824 = phi_2649_;
                            if _e3824 {
                                phi_2654_ = type_34(2u, _e3463.member_1);
                                phi_2655_ = false;
                            } else {
                                phi_2654_ = type_34();
                                phi_2655_ = true;
                            }
                            let _e3827 = phi_2654_;
                            let _e3829 = phi_2655_;
                            phi_2657_ = _e3827;
                            phi_2658_ = _e3822;
                            phi_2659_ = _e3829;
                        } else {
                            phi_2657_ = type_34();
                            phi_2658_ = type_34(0u, type_34().member_1);
                            phi_2659_ = true;
                        }
                        let _e3831 = phi_2657_;
                        let _e3833 = phi_2658_;
                        let _e3835 = phi_2659_;
                        if _e3835 {
                            phi_2663_ = _e3833;
                        } else {
                            phi_2663_ = _e3831;
                        }
                        let _e3837 = phi_2663_;
                        phi_5480_ = _e3837;
                    } else {
                        if (_e348 < 0f) {
                            phi_2673_ = -(_e348);
                        } else {
                            phi_2673_ = _e348;
                        }
                        let _e691 = phi_2673_;
                        if (_e371 < 0f) {
                            phi_2679_ = -(_e371);
                        } else {
                            phi_2679_ = _e371;
                        }
                        let _e695 = phi_2679_;
                        if (_e691 > _e695) {
                            phi_2684_ = _e691;
                        } else {
                            phi_2684_ = _e695;
                        }
                        let _e698 = phi_2684_;
                        if (_e394 < 0f) {
                            phi_2690_ = -(_e394);
                        } else {
                            phi_2690_ = _e394;
                        }
                        let _e702 = phi_2690_;
                        if (_e405 < 0f) {
                            phi_2696_ = -(_e405);
                        } else {
                            phi_2696_ = _e405;
                        }
                        let _e706 = phi_2696_;
                        if (_e702 > _e706) {
                            phi_2701_ = _e702;
                        } else {
                            phi_2701_ = _e706;
                        }
                        let _e709 = phi_2701_;
                        if (_e698 > _e709) {
                            phi_2706_ = _e698;
                        } else {
                            phi_2706_ = _e709;
                        }
                        let _e712 = phi_2706_;
                        let _e713 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e712 >= _e713) {
                            phi_2714_ = (_e712 <= (1f / _e713));
                        } else {
                            phi_2714_ = false;
                        }
                        let _e718 = phi_2714_;
                        if _e718 {
                            phi_2719_ = (0.000000059604645f * 256f);
                        } else {
                            phi_2719_ = 2f;
                        }
                        let _e721 = phi_2719_;
                        let _e723 = ((_e655 * 0.34f) + (_e712 * _e721));
                        if _e718 {
                            phi_2726_ = (1f / _e712);
                        } else {
                            phi_2726_ = 0f;
                        }
                        let _e726 = phi_2726_;
                        let _e732 = ((_e371 - (3f * _e348)) * _e726);
                        let _e733 = ((_e394 - _e371) * _e726);
                        let _e734 = (((3f * _e405) - _e394) * _e726);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e741 = ((_e733 * _e733) - (_e732 * _e734));
                        if (_e741 > 0f) {
                            if (_e741 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e741 > 0f) {
                                    phi_2759_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_2759_ = 0f;
                                }
                                let _e795 = phi_2759_;
                                phi_2823_ = _e795;
                            } else {
                                phi_2766_ = type_14(0i, 5i);
                                phi_2769_ = bitcast<f32>(((bitcast<u32>(_e741) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e750 = phi_2766_;
                                    let _e752 = phi_2769_;
                                    local_13 = _e752;
                                    if (_e750.member < _e750.member_1) {
                                        let _e759 = (_e750.member + 1i);
                                        if ((false == (_e759 > _e750.member)) != false) {
                                            phi_2790_ = true;
                                        } else {
                                            phi_2790_ = false;
                                        }
                                        let _e764 = phi_2790_;
                                        if _e764 {
                                            phi_2796_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_2796_ = type_15(1u, _e759);
                                        }
                                        let _e769 = phi_2796_;
                                        phi_2767_ = type_14(_e769.member_1, _e750.member_1);
                                        phi_2810_ = type_15(1u, _e750.member);
                                    } else {
                                        phi_2767_ = _e750;
                                        phi_2810_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e775 = phi_2767_;
                                    let _e777 = phi_2810_;
                                    let _e780 = (bitcast<i32>(_e777.member) != 0i);
                                    if _e780 {
                                        phi_2770_ = (0.5f * (_e752 + (_e741 / _e752)));
                                    } else {
                                        phi_2770_ = f32();
                                    }
                                    let _e785 = phi_2770_;
                                    continue;
                                    continuing {
                                        phi_2766_ = _e775;
                                        phi_2769_ = _e785;
                                        break if !(_e780);
                                    }
                                }
                                let _e790 = local_13;
                                phi_2823_ = (_e790 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e797 = phi_2823_;
                            if (_e733 < 0f) {
                                phi_2829_ = -(_e797);
                            } else {
                                phi_2829_ = _e797;
                            }
                            let _e801 = phi_2829_;
                            let _e803 = -((_e733 + _e801));
                            local_7[0u] = (_e803 / (_e803 + _e734));
                            local_7[1u] = (_e732 / (_e732 + _e803));
                            let _e812 = local_7[1u];
                            let _e813 = local_7[0u];
                            if (_e812 < _e813) {
                                let _e816 = local_7[1u];
                                let _e818 = local_7[0u];
                                local_7[0u] = _e816;
                                local_7[1u] = _e818;
                            }
                            phi_2854_ = type_9(0u, 2u);
                            phi_2857_ = 1u;
                            loop {
                                let _e822 = phi_2854_;
                                let _e824 = phi_2857_;
                                local_43 = _e824;
                                if (_e822.member < _e822.member_1) {
                                    phi_2855_ = type_9((_e822.member + 1u), _e822.member_1);
                                    phi_2880_ = type_9(1u, _e822.member);
                                } else {
                                    phi_2855_ = _e822;
                                    phi_2880_ = type_9(0u, type_9().member_1);
                                }
                                let _e836 = phi_2855_;
                                let _e838 = phi_2880_;
                                let _e842 = (bitcast<i32>(_e838.member) != 0i);
                                if _e842 {
                                    let _e844 = local_7[_e838.member_1];
                                    if (_e844 > 0f) {
                                        let _e847 = local_7[_e838.member_1];
                                        if (_e847 < 1f) {
                                            let _e850 = local_7[_e838.member_1];
                                            local_6[_e824] = _e850;
                                            phi_2924_ = (_e824 + 1u);
                                        } else {
                                            phi_2924_ = _e824;
                                        }
                                        let _e854 = phi_2924_;
                                        phi_2925_ = _e854;
                                    } else {
                                        phi_2925_ = _e824;
                                    }
                                    let _e856 = phi_2925_;
                                    phi_2858_ = _e856;
                                } else {
                                    phi_2858_ = u32();
                                }
                                let _e858 = phi_2858_;
                                continue;
                                continuing {
                                    phi_2854_ = _e836;
                                    phi_2857_ = _e858;
                                    break if !(_e842);
                                }
                            }
                            let _e4051 = local_43;
                            phi_2926_ = _e4051;
                        } else {
                            phi_2926_ = 1u;
                        }
                        let _e861 = phi_2926_;
                        local_6[_e861] = 1f;
                        let _e863 = local_6;
                        local_8 = _e863;
                        phi_2946_ = type_9(0u, _e861);
                        loop {
                            let _e866 = phi_2946_;
                            if (_e866.member < _e866.member_1) {
                                phi_2947_ = type_9((_e866.member + 1u), _e866.member_1);
                                phi_2970_ = type_9(1u, _e866.member);
                            } else {
                                phi_2947_ = _e866;
                                phi_2970_ = type_9(0u, type_9().member_1);
                            }
                            let _e878 = phi_2947_;
                            let _e880 = phi_2970_;
                            if (bitcast<i32>(_e880.member) != 0i) {
                                let _e886 = local_8[_e880.member_1];
                                let _e889 = local_8[(_e880.member_1 + 1u)];
                                let _e890 = (1f - _e886);
                                let _e901 = ((((_e348 * _e890) + (_e371 * _e886)) * (_e890 * _e890)) + (((_e394 * _e890) + (_e405 * _e886)) * (_e886 * _e886)));
                                let _e902 = (1f - _e889);
                                let _e913 = ((((_e348 * _e902) + (_e371 * _e889)) * (_e902 * _e902)) + (((_e394 * _e902) + (_e405 * _e889)) * (_e889 * _e889)));
                                if (_e901 < 0f) {
                                    phi_3022_ = -(_e901);
                                } else {
                                    phi_3022_ = _e901;
                                }
                                let _e917 = phi_3022_;
                                let _e918 = (_e917 > _e723);
                                if (_e913 < 0f) {
                                    phi_3029_ = -(_e913);
                                } else {
                                    phi_3029_ = _e913;
                                }
                                let _e922 = phi_3029_;
                                let _e923 = (_e922 > _e723);
                                if _e918 {
                                    if _e923 {
                                        phi_3040_ = ((_e901 > 0f) != (_e913 > 0f));
                                        phi_3041_ = false;
                                    } else {
                                        phi_3040_ = bool();
                                        phi_3041_ = true;
                                    }
                                    let _e928 = phi_3040_;
                                    let _e930 = phi_3041_;
                                    phi_3042_ = _e928;
                                    phi_3043_ = _e930;
                                } else {
                                    phi_3042_ = bool();
                                    phi_3043_ = true;
                                }
                                let _e932 = phi_3042_;
                                let _e934 = phi_3043_;
                                if _e934 {
                                    phi_3047_ = false;
                                } else {
                                    phi_3047_ = _e932;
                                }
                                let _e936 = phi_3047_;
                                if _e918 {
                                    if _e923 {
                                        if _e936 {
                                            phi_3058_ = type_35();
                                        } else {
                                            phi_3058_ = type_35(1f, 0f, _e936);
                                        }
                                        let _e939 = phi_3058_;
                                        phi_3059_ = _e939;
                                        phi_3060_ = _e936;
                                    } else {
                                        phi_3059_ = type_35();
                                        phi_3060_ = true;
                                    }
                                    let _e941 = phi_3059_;
                                    let _e943 = phi_3060_;
                                    phi_3061_ = _e941;
                                    phi_3062_ = _e943;
                                } else {
                                    phi_3061_ = type_35();
                                    phi_3062_ = true;
                                }
                                let _e945 = phi_3061_;
                                let _e947 = phi_3062_;
                                if _e947 {
                                    if _e918 {
                                        if (_e901 < 0f) {
                                            phi_3073_ = -1f;
                                        } else {
                                            phi_3073_ = 1f;
                                        }
                                        let _e950 = phi_3073_;
                                        let _e953 = (_e394 - _e371);
                                        phi_3083_ = type_9(0u, 64u);
                                        phi_3086_ = _e889;
                                        phi_3088_ = _e886;
                                        phi_3090_ = (0.5f * (_e886 + _e889));
                                        loop {
                                            let _e959 = phi_3083_;
                                            let _e961 = phi_3086_;
                                            let _e963 = phi_3088_;
                                            let _e965 = phi_3090_;
                                            local_45 = _e963;
                                            if (_e959.member < _e959.member_1) {
                                                phi_3084_ = type_9((_e959.member + 1u), _e959.member_1);
                                                phi_3113_ = type_9(1u, _e959.member);
                                            } else {
                                                phi_3084_ = _e959;
                                                phi_3113_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e977 = phi_3084_;
                                            let _e979 = phi_3113_;
                                            if (bitcast<i32>(_e979.member) != 0i) {
                                                let _e983 = (1f - _e965);
                                                let _e996 = ((_e950 * ((((_e348 * _e983) + (_e371 * _e965)) * (_e983 * _e983)) + (((_e394 * _e983) + (_e405 * _e965)) * (_e965 * _e965)))) - _e723);
                                                if (_e996 > 0f) {
                                                    phi_3138_ = _e961;
                                                    phi_3139_ = _e965;
                                                } else {
                                                    phi_3138_ = _e965;
                                                    phi_3139_ = _e963;
                                                }
                                                let _e999 = phi_3138_;
                                                let _e1001 = phi_3139_;
                                                let _e1003 = ((_e999 - _e1001) > 0.00000000000022737368f);
                                                if _e1003 {
                                                    let _e1004 = (1f - _e965);
                                                    let _e1016 = (-(_e996) / (_e950 * (((((_e371 - (3f * _e348)) * _e1004) + (_e953 * _e965)) * _e1004) + (((_e953 * _e1004) + (((3f * _e405) - _e394) * _e965)) * _e965))));
                                                    if (_e996 > 0f) {
                                                        phi_3165_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_3165_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1022 = phi_3165_;
                                                    let _e1024 = ((_e965 + _e1016) + _e1022);
                                                    if (_e1024 > _e1001) {
                                                        if (_e1024 < _e999) {
                                                            if (_e1016 < 0f) {
                                                                phi_3181_ = -(_e1016);
                                                            } else {
                                                                phi_3181_ = _e1016;
                                                            }
                                                            let _e1030 = phi_3181_;
                                                            if (_e1030 < (0.5f * (_e999 - _e1001))) {
                                                                phi_3188_ = false;
                                                            } else {
                                                                phi_3188_ = true;
                                                            }
                                                            let _e1035 = phi_3188_;
                                                            phi_3189_ = _e1035;
                                                        } else {
                                                            phi_3189_ = true;
                                                        }
                                                        let _e1037 = phi_3189_;
                                                        phi_3190_ = _e1037;
                                                    } else {
                                                        phi_3190_ = true;
                                                    }
                                                    let _e1039 = phi_3190_;
                                                    if _e1039 {
                                                        phi_3196_ = (0.5f * (_e1001 + _e999));
                                                    } else {
                                                        phi_3196_ = _e1024;
                                                    }
                                                    let _e1043 = phi_3196_;
                                                    phi_3197_ = _e1043;
                                                    phi_3198_ = false;
                                                } else {
                                                    phi_3197_ = f32();
                                                    phi_3198_ = true;
                                                }
                                                let _e1045 = phi_3197_;
                                                let _e1047 = phi_3198_;
                                                phi_3087_ = _e999;
                                                phi_3089_ = _e1001;
                                                phi_3091_ = _e1045;
                                                phi_3199_ = _e1001;
                                                phi_3200_ = _e1003;
                                                phi_3201_ = _e1047;
                                            } else {
                                                phi_3087_ = f32();
                                                phi_3089_ = f32();
                                                phi_3091_ = f32();
                                                phi_3199_ = f32();
                                                phi_3200_ = false;
                                                phi_3201_ = false;
                                            }
                                            let _e1049 = phi_3087_;
                                            let _e1051 = phi_3089_;
                                            let _e1053 = phi_3091_;
                                            let _e1055 = phi_3199_;
                                            let _e1057 = phi_3200_;
                                            let _e1059 = phi_3201_;
                                            local_14 = _e1059;
                                            local_44 = _e1055;
                                            continue;
                                            continuing {
                                                phi_3083_ = _e977;
                                                phi_3086_ = _e1049;
                                                phi_3088_ = _e1051;
                                                phi_3090_ = _e1053;
                                                break if !(_e1057);
                                            }
                                        }
                                        let _e1062 = local_14;
                                        if _e1062 {
                                            let _e4093 = local_44;
                                            phi_3205_ = _e4093;
                                        } else {
                                            let _e4095 = local_45;
                                            phi_3205_ = _e4095;
                                        }
                                        let _e1064 = phi_3205_;
                                        phi_3206_ = _e1064;
                                    } else {
                                        phi_3206_ = _e886;
                                    }
                                    let _e1066 = phi_3206_;
                                    if _e923 {
                                        phi_3213_ = type_9(0u, 64u);
                                        phi_3216_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1069 = phi_3213_;
                                            let _e1071 = phi_3216_;
                                            if (_e1069.member < _e1069.member_1) {
                                                phi_3214_ = type_9((_e1069.member + 1u), _e1069.member_1);
                                                phi_3239_ = type_9(1u, _e1069.member);
                                            } else {
                                                phi_3214_ = _e1069;
                                                phi_3239_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1083 = phi_3214_;
                                            let _e1085 = phi_3239_;
                                            if (bitcast<i32>(_e1085.member) != 0i) {
                                                let _e1089 = (_e1066 + _e1071);
                                                if (_e1089 < _e889) {
                                                    let _e1091 = (1f - _e1089);
                                                    let _e1102 = ((((_e348 * _e1091) + (_e371 * _e1089)) * (_e1091 * _e1091)) + (((_e394 * _e1091) + (_e405 * _e1089)) * (_e1089 * _e1089)));
                                                    let _e1103 = (1f - _e1066);
                                                    let _e1114 = ((((_e348 * _e1103) + (_e371 * _e1066)) * (_e1103 * _e1103)) + (((_e394 * _e1103) + (_e405 * _e1066)) * (_e1066 * _e1066)));
                                                    if (_e1102 < 0f) {
                                                        phi_3280_ = -(_e1102);
                                                    } else {
                                                        phi_3280_ = _e1102;
                                                    }
                                                    let _e1118 = phi_3280_;
                                                    if (_e1118 > _e723) {
                                                        if (_e1114 < 0f) {
                                                            phi_3290_ = -(_e1114);
                                                        } else {
                                                            phi_3290_ = _e1114;
                                                        }
                                                        let _e1123 = phi_3290_;
                                                        if (_e1123 > _e723) {
                                                            phi_3298_ = ((_e1102 > 0f) == (_e1114 > 0f));
                                                        } else {
                                                            phi_3298_ = false;
                                                        }
                                                        let _e1129 = phi_3298_;
                                                        phi_3300_ = !(_e1129);
                                                    } else {
                                                        phi_3300_ = false;
                                                    }
                                                    let _e1132 = phi_3300_;
                                                    if _e1132 {
                                                        phi_3305_ = f32();
                                                        phi_3306_ = false;
                                                    } else {
                                                        phi_3305_ = (_e1071 + _e1071);
                                                        phi_3306_ = true;
                                                    }
                                                    let _e1135 = phi_3305_;
                                                    let _e1137 = phi_3306_;
                                                    phi_3307_ = _e1135;
                                                    phi_3308_ = _e1137;
                                                    phi_3309_ = _e1132;
                                                    phi_3310_ = false;
                                                } else {
                                                    phi_3307_ = f32();
                                                    phi_3308_ = false;
                                                    phi_3309_ = false;
                                                    phi_3310_ = true;
                                                }
                                                let _e1139 = phi_3307_;
                                                let _e1141 = phi_3308_;
                                                let _e1143 = phi_3309_;
                                                let _e1145 = phi_3310_;
                                                phi_3311_ = _e1089;
                                                phi_3217_ = _e1139;
                                                phi_3312_ = _e1141;
                                                phi_3313_ = _e1143;
                                                phi_3314_ = _e1145;
                                                phi_3315_ = false;
                                            } else {
                                                phi_3311_ = f32();
                                                phi_3217_ = f32();
                                                phi_3312_ = false;
                                                phi_3313_ = false;
                                                phi_3314_ = false;
                                                phi_3315_ = true;
                                            }
                                            let _e1147 = phi_3311_;
                                            let _e1149 = phi_3217_;
                                            let _e1151 = phi_3312_;
                                            let _e1153 = phi_3313_;
                                            let _e1155 = phi_3314_;
                                            let _e1157 = phi_3315_;
                                            local_15 = _e1153;
                                            local_46 = _e1155;
                                            local_47 = _e1157;
                                            local_48 = _e1147;
                                            continue;
                                            continuing {
                                                phi_3213_ = _e1083;
                                                phi_3216_ = _e1149;
                                                break if !(_e1151);
                                            }
                                        }
                                        let _e1160 = local_15;
                                        if _e1160 {
                                            phi_3319_ = false;
                                            phi_3320_ = false;
                                        } else {
                                            let _e4120 = local_46;
                                            phi_3319_ = _e4120;
                                            let _e4123 = local_47;
                                            phi_3320_ = _e4123;
                                        }
                                        let _e1162 = phi_3319_;
                                        let _e1164 = phi_3320_;
                                        if _e1162 {
                                            phi_3324_ = true;
                                        } else {
                                            phi_3324_ = _e1164;
                                        }
                                        let _e1166 = phi_3324_;
                                        if _e1166 {
                                            phi_3328_ = _e889;
                                        } else {
                                            let _e4127 = local_48;
                                            phi_3328_ = _e4127;
                                        }
                                        let _e1168 = phi_3328_;
                                        phi_3329_ = _e1168;
                                    } else {
                                        phi_3329_ = _e889;
                                    }
                                    let _e1170 = phi_3329_;
                                    phi_3331_ = type_35(_e1066, _e1170, _e936);
                                } else {
                                    phi_3331_ = _e945;
                                }
                                let _e1173 = phi_3331_;
                                if (_e1173.member > _e1173.member_1) {
                                    phi_5436_ = f32();
                                    phi_5437_ = true;
                                    phi_5438_ = false;
                                    phi_5439_ = false;
                                    phi_5440_ = false;
                                } else {
                                    let _e1180 = ((_e1173.member_1 - _e1173.member) * 0.5f);
                                    let _e1181 = (_e1173.member + _e1180);
                                    let _e1183 = (_e1180 + (0.000000059604645f * 4f));
                                    let _e1185 = local_12.member_3;
                                    let _e1188 = local_12.member[0u];
                                    if (_e1188[0] < 0f) {
                                        phi_3360_ = -(_e1188[0]);
                                    } else {
                                        phi_3360_ = _e1188[0];
                                    }
                                    let _e1195 = phi_3360_;
                                    if (_e1188[1] < 0f) {
                                        phi_3367_ = -(_e1188[1]);
                                    } else {
                                        phi_3367_ = _e1188[1];
                                    }
                                    let _e1199 = phi_3367_;
                                    if (_e1195 > _e1199) {
                                        phi_3372_ = _e1195;
                                    } else {
                                        phi_3372_ = _e1199;
                                    }
                                    let _e1202 = phi_3372_;
                                    if (_e1188[2] < 0f) {
                                        phi_3379_ = -(_e1188[2]);
                                    } else {
                                        phi_3379_ = _e1188[2];
                                    }
                                    let _e1206 = phi_3379_;
                                    if (_e1202 > _e1206) {
                                        phi_3384_ = _e1202;
                                    } else {
                                        phi_3384_ = _e1206;
                                    }
                                    let _e1209 = phi_3384_;
                                    let _e1211 = local_12.member[1u];
                                    if (_e1211[0] < 0f) {
                                        phi_3397_ = -(_e1211[0]);
                                    } else {
                                        phi_3397_ = _e1211[0];
                                    }
                                    let _e1218 = phi_3397_;
                                    if (_e1211[1] < 0f) {
                                        phi_3404_ = -(_e1211[1]);
                                    } else {
                                        phi_3404_ = _e1211[1];
                                    }
                                    let _e1222 = phi_3404_;
                                    if (_e1218 > _e1222) {
                                        phi_3409_ = _e1218;
                                    } else {
                                        phi_3409_ = _e1222;
                                    }
                                    let _e1225 = phi_3409_;
                                    if (_e1211[2] < 0f) {
                                        phi_3416_ = -(_e1211[2]);
                                    } else {
                                        phi_3416_ = _e1211[2];
                                    }
                                    let _e1229 = phi_3416_;
                                    if (_e1225 > _e1229) {
                                        phi_3421_ = _e1225;
                                    } else {
                                        phi_3421_ = _e1229;
                                    }
                                    let _e1232 = phi_3421_;
                                    if (_e1209 > _e1232) {
                                        phi_3426_ = _e1209;
                                    } else {
                                        phi_3426_ = _e1232;
                                    }
                                    let _e1235 = phi_3426_;
                                    let _e1238 = local_12.member[0u];
                                    let _e1243 = local_12.member[1u];
                                    let _e1253 = (_e1238[0] + ((_e1243[0] - _e1238[0]) * _e1181));
                                    let _e1254 = (_e1238[1] + ((_e1243[1] - _e1238[1]) * _e1181));
                                    let _e1255 = (_e1238[2] + ((_e1243[2] - _e1238[2]) * _e1181));
                                    let _e1257 = local_12.member[1u];
                                    let _e1262 = local_12.member[0u];
                                    let _e1266 = (_e1257[0] - _e1262[0]);
                                    let _e1267 = (_e1257[1] - _e1262[1]);
                                    let _e1268 = (_e1257[2] - _e1262[2]);
                                    if (_e1266 < 0f) {
                                        phi_3485_ = -(_e1266);
                                    } else {
                                        phi_3485_ = _e1266;
                                    }
                                    let _e1272 = phi_3485_;
                                    if (_e1267 < 0f) {
                                        phi_3491_ = -(_e1267);
                                    } else {
                                        phi_3491_ = _e1267;
                                    }
                                    let _e1276 = phi_3491_;
                                    if (_e1272 > _e1276) {
                                        phi_3496_ = _e1272;
                                    } else {
                                        phi_3496_ = _e1276;
                                    }
                                    let _e1279 = phi_3496_;
                                    if (_e1268 < 0f) {
                                        phi_3502_ = -(_e1268);
                                    } else {
                                        phi_3502_ = _e1268;
                                    }
                                    let _e1283 = phi_3502_;
                                    if (_e1279 > _e1283) {
                                        phi_3507_ = _e1279;
                                    } else {
                                        phi_3507_ = _e1283;
                                    }
                                    let _e1286 = phi_3507_;
                                    let _e1292 = ((((_e1183 * _e1286) * 1.01f) + ((_e1235 + _e1185) * (0.000000059604645f * 8f))) + _e1185);
                                    if (_e1253 < 0f) {
                                        phi_3519_ = -(_e1253);
                                    } else {
                                        phi_3519_ = _e1253;
                                    }
                                    let _e1296 = phi_3519_;
                                    if (_e1254 < 0f) {
                                        phi_3525_ = -(_e1254);
                                    } else {
                                        phi_3525_ = _e1254;
                                    }
                                    let _e1300 = phi_3525_;
                                    if (_e1296 > _e1300) {
                                        phi_3530_ = _e1296;
                                    } else {
                                        phi_3530_ = _e1300;
                                    }
                                    let _e1303 = phi_3530_;
                                    if (_e1255 < 0f) {
                                        phi_3536_ = -(_e1255);
                                    } else {
                                        phi_3536_ = _e1255;
                                    }
                                    let _e1307 = phi_3536_;
                                    if (_e1303 > _e1307) {
                                        phi_3541_ = _e1303;
                                    } else {
                                        phi_3541_ = _e1307;
                                    }
                                    let _e1310 = phi_3541_;
                                    local_2 = type_29(array<f32, 3>(_e1253, _e1254, _e1255), _e1292, (_e1310 + _e1292));
                                    let _e1316 = local_12.member_3;
                                    let _e1318 = local_12.member_1[0u];
                                    if (_e1318[0] < 0f) {
                                        phi_3567_ = -(_e1318[0]);
                                    } else {
                                        phi_3567_ = _e1318[0];
                                    }
                                    let _e1325 = phi_3567_;
                                    if (_e1318[1] < 0f) {
                                        phi_3574_ = -(_e1318[1]);
                                    } else {
                                        phi_3574_ = _e1318[1];
                                    }
                                    let _e1329 = phi_3574_;
                                    if (_e1325 > _e1329) {
                                        phi_3579_ = _e1325;
                                    } else {
                                        phi_3579_ = _e1329;
                                    }
                                    let _e1332 = phi_3579_;
                                    if (_e1318[2] < 0f) {
                                        phi_3586_ = -(_e1318[2]);
                                    } else {
                                        phi_3586_ = _e1318[2];
                                    }
                                    let _e1336 = phi_3586_;
                                    if (_e1332 > _e1336) {
                                        phi_3591_ = _e1332;
                                    } else {
                                        phi_3591_ = _e1336;
                                    }
                                    let _e1339 = phi_3591_;
                                    let _e1341 = local_12.member_1[1u];
                                    if (_e1341[0] < 0f) {
                                        phi_3604_ = -(_e1341[0]);
                                    } else {
                                        phi_3604_ = _e1341[0];
                                    }
                                    let _e1348 = phi_3604_;
                                    if (_e1341[1] < 0f) {
                                        phi_3611_ = -(_e1341[1]);
                                    } else {
                                        phi_3611_ = _e1341[1];
                                    }
                                    let _e1352 = phi_3611_;
                                    if (_e1348 > _e1352) {
                                        phi_3616_ = _e1348;
                                    } else {
                                        phi_3616_ = _e1352;
                                    }
                                    let _e1355 = phi_3616_;
                                    if (_e1341[2] < 0f) {
                                        phi_3623_ = -(_e1341[2]);
                                    } else {
                                        phi_3623_ = _e1341[2];
                                    }
                                    let _e1359 = phi_3623_;
                                    if (_e1355 > _e1359) {
                                        phi_3628_ = _e1355;
                                    } else {
                                        phi_3628_ = _e1359;
                                    }
                                    let _e1362 = phi_3628_;
                                    if (_e1339 > _e1362) {
                                        phi_3633_ = _e1339;
                                    } else {
                                        phi_3633_ = _e1362;
                                    }
                                    let _e1365 = phi_3633_;
                                    let _e1368 = local_12.member_1[0u];
                                    let _e1373 = local_12.member_1[1u];
                                    let _e1383 = (_e1368[0] + ((_e1373[0] - _e1368[0]) * _e1181));
                                    let _e1384 = (_e1368[1] + ((_e1373[1] - _e1368[1]) * _e1181));
                                    let _e1385 = (_e1368[2] + ((_e1373[2] - _e1368[2]) * _e1181));
                                    let _e1387 = local_12.member_1[1u];
                                    let _e1392 = local_12.member_1[0u];
                                    let _e1396 = (_e1387[0] - _e1392[0]);
                                    let _e1397 = (_e1387[1] - _e1392[1]);
                                    let _e1398 = (_e1387[2] - _e1392[2]);
                                    if (_e1396 < 0f) {
                                        phi_3692_ = -(_e1396);
                                    } else {
                                        phi_3692_ = _e1396;
                                    }
                                    let _e1402 = phi_3692_;
                                    if (_e1397 < 0f) {
                                        phi_3698_ = -(_e1397);
                                    } else {
                                        phi_3698_ = _e1397;
                                    }
                                    let _e1406 = phi_3698_;
                                    if (_e1402 > _e1406) {
                                        phi_3703_ = _e1402;
                                    } else {
                                        phi_3703_ = _e1406;
                                    }
                                    let _e1409 = phi_3703_;
                                    if (_e1398 < 0f) {
                                        phi_3709_ = -(_e1398);
                                    } else {
                                        phi_3709_ = _e1398;
                                    }
                                    let _e1413 = phi_3709_;
                                    if (_e1409 > _e1413) {
                                        phi_3714_ = _e1409;
                                    } else {
                                        phi_3714_ = _e1413;
                                    }
                                    let _e1416 = phi_3714_;
                                    let _e1422 = ((((_e1183 * _e1416) * 1.01f) + ((_e1365 + _e1316) * (0.000000059604645f * 8f))) + _e1316);
                                    if (_e1383 < 0f) {
                                        phi_3726_ = -(_e1383);
                                    } else {
                                        phi_3726_ = _e1383;
                                    }
                                    let _e1426 = phi_3726_;
                                    if (_e1384 < 0f) {
                                        phi_3732_ = -(_e1384);
                                    } else {
                                        phi_3732_ = _e1384;
                                    }
                                    let _e1430 = phi_3732_;
                                    if (_e1426 > _e1430) {
                                        phi_3737_ = _e1426;
                                    } else {
                                        phi_3737_ = _e1430;
                                    }
                                    let _e1433 = phi_3737_;
                                    if (_e1385 < 0f) {
                                        phi_3743_ = -(_e1385);
                                    } else {
                                        phi_3743_ = _e1385;
                                    }
                                    let _e1437 = phi_3743_;
                                    if (_e1433 > _e1437) {
                                        phi_3748_ = _e1433;
                                    } else {
                                        phi_3748_ = _e1437;
                                    }
                                    let _e1440 = phi_3748_;
                                    local_3 = type_29(array<f32, 3>(_e1383, _e1384, _e1385), _e1422, (_e1440 + _e1422));
                                    let _e1446 = local_12.member_3;
                                    let _e1448 = local_12.member_2[0u];
                                    if (_e1448[0] < 0f) {
                                        phi_3774_ = -(_e1448[0]);
                                    } else {
                                        phi_3774_ = _e1448[0];
                                    }
                                    let _e1455 = phi_3774_;
                                    if (_e1448[1] < 0f) {
                                        phi_3781_ = -(_e1448[1]);
                                    } else {
                                        phi_3781_ = _e1448[1];
                                    }
                                    let _e1459 = phi_3781_;
                                    if (_e1455 > _e1459) {
                                        phi_3786_ = _e1455;
                                    } else {
                                        phi_3786_ = _e1459;
                                    }
                                    let _e1462 = phi_3786_;
                                    if (_e1448[2] < 0f) {
                                        phi_3793_ = -(_e1448[2]);
                                    } else {
                                        phi_3793_ = _e1448[2];
                                    }
                                    let _e1466 = phi_3793_;
                                    if (_e1462 > _e1466) {
                                        phi_3798_ = _e1462;
                                    } else {
                                        phi_3798_ = _e1466;
                                    }
                                    let _e1469 = phi_3798_;
                                    let _e1471 = local_12.member_2[1u];
                                    if (_e1471[0] < 0f) {
                                        phi_3811_ = -(_e1471[0]);
                                    } else {
                                        phi_3811_ = _e1471[0];
                                    }
                                    let _e1478 = phi_3811_;
                                    if (_e1471[1] < 0f) {
                                        phi_3818_ = -(_e1471[1]);
                                    } else {
                                        phi_3818_ = _e1471[1];
                                    }
                                    let _e1482 = phi_3818_;
                                    if (_e1478 > _e1482) {
                                        phi_3823_ = _e1478;
                                    } else {
                                        phi_3823_ = _e1482;
                                    }
                                    let _e1485 = phi_3823_;
                                    if (_e1471[2] < 0f) {
                                        phi_3830_ = -(_e1471[2]);
                                    } else {
                                        phi_3830_ = _e1471[2];
                                    }
                                    let _e1489 = phi_3830_;
                                    if (_e1485 > _e1489) {
                                        phi_3835_ = _e1485;
                                    } else {
                                        phi_3835_ = _e1489;
                                    }
                                    let _e1492 = phi_3835_;
                                    if (_e1469 > _e1492) {
                                        phi_3840_ = _e1469;
                                    } else {
                                        phi_3840_ = _e1492;
                                    }
                                    let _e1495 = phi_3840_;
                                    let _e1498 = local_12.member_2[0u];
                                    let _e1503 = local_12.member_2[1u];
                                    let _e1513 = (_e1498[0] + ((_e1503[0] - _e1498[0]) * _e1181));
                                    let _e1514 = (_e1498[1] + ((_e1503[1] - _e1498[1]) * _e1181));
                                    let _e1515 = (_e1498[2] + ((_e1503[2] - _e1498[2]) * _e1181));
                                    let _e1517 = local_12.member_2[1u];
                                    let _e1522 = local_12.member_2[0u];
                                    let _e1526 = (_e1517[0] - _e1522[0]);
                                    let _e1527 = (_e1517[1] - _e1522[1]);
                                    let _e1528 = (_e1517[2] - _e1522[2]);
                                    if (_e1526 < 0f) {
                                        phi_3899_ = -(_e1526);
                                    } else {
                                        phi_3899_ = _e1526;
                                    }
                                    let _e1532 = phi_3899_;
                                    if (_e1527 < 0f) {
                                        phi_3905_ = -(_e1527);
                                    } else {
                                        phi_3905_ = _e1527;
                                    }
                                    let _e1536 = phi_3905_;
                                    if (_e1532 > _e1536) {
                                        phi_3910_ = _e1532;
                                    } else {
                                        phi_3910_ = _e1536;
                                    }
                                    let _e1539 = phi_3910_;
                                    if (_e1528 < 0f) {
                                        phi_3916_ = -(_e1528);
                                    } else {
                                        phi_3916_ = _e1528;
                                    }
                                    let _e1543 = phi_3916_;
                                    if (_e1539 > _e1543) {
                                        phi_3921_ = _e1539;
                                    } else {
                                        phi_3921_ = _e1543;
                                    }
                                    let _e1546 = phi_3921_;
                                    let _e1552 = ((((_e1183 * _e1546) * 1.01f) + ((_e1495 + _e1446) * (0.000000059604645f * 8f))) + _e1446);
                                    if (_e1513 < 0f) {
                                        phi_3933_ = -(_e1513);
                                    } else {
                                        phi_3933_ = _e1513;
                                    }
                                    let _e1556 = phi_3933_;
                                    if (_e1514 < 0f) {
                                        phi_3939_ = -(_e1514);
                                    } else {
                                        phi_3939_ = _e1514;
                                    }
                                    let _e1560 = phi_3939_;
                                    if (_e1556 > _e1560) {
                                        phi_3944_ = _e1556;
                                    } else {
                                        phi_3944_ = _e1560;
                                    }
                                    let _e1563 = phi_3944_;
                                    if (_e1515 < 0f) {
                                        phi_3950_ = -(_e1515);
                                    } else {
                                        phi_3950_ = _e1515;
                                    }
                                    let _e1567 = phi_3950_;
                                    if (_e1563 > _e1567) {
                                        phi_3955_ = _e1563;
                                    } else {
                                        phi_3955_ = _e1567;
                                    }
                                    let _e1570 = phi_3955_;
                                    local_4 = type_29(array<f32, 3>(_e1513, _e1514, _e1515), _e1552, (_e1570 + _e1552));
                                    let _e1575 = local_3.member;
                                    let _e1580 = local_4.member;
                                    let _e1586 = ((_e1575[1] * _e1580[2]) - (_e1575[2] * _e1580[1]));
                                    let _e1589 = ((_e1575[2] * _e1580[0]) - (_e1575[0] * _e1580[2]));
                                    let _e1592 = ((_e1575[0] * _e1580[1]) - (_e1575[1] * _e1580[0]));
                                    if (_e1586 < 0f) {
                                        phi_4004_ = -(_e1586);
                                    } else {
                                        phi_4004_ = _e1586;
                                    }
                                    let _e1596 = phi_4004_;
                                    if (_e1589 < 0f) {
                                        phi_4010_ = -(_e1589);
                                    } else {
                                        phi_4010_ = _e1589;
                                    }
                                    let _e1600 = phi_4010_;
                                    if (_e1596 > _e1600) {
                                        if (_e1586 < 0f) {
                                            phi_4020_ = -(_e1586);
                                        } else {
                                            phi_4020_ = _e1586;
                                        }
                                        let _e1618 = phi_4020_;
                                        if (_e1592 < 0f) {
                                            phi_4026_ = -(_e1592);
                                        } else {
                                            phi_4026_ = _e1592;
                                        }
                                        let _e1622 = phi_4026_;
                                        if (_e1618 > _e1622) {
                                            phi_4031_ = 2u;
                                            phi_4032_ = 1u;
                                        } else {
                                            phi_4031_ = 1u;
                                            phi_4032_ = 0u;
                                        }
                                        let _e1625 = phi_4031_;
                                        let _e1627 = phi_4032_;
                                        phi_4051_ = _e1625;
                                        phi_4052_ = _e1627;
                                    } else {
                                        if (_e1589 < 0f) {
                                            phi_4038_ = -(_e1589);
                                        } else {
                                            phi_4038_ = _e1589;
                                        }
                                        let _e1605 = phi_4038_;
                                        if (_e1592 < 0f) {
                                            phi_4044_ = -(_e1592);
                                        } else {
                                            phi_4044_ = _e1592;
                                        }
                                        let _e1609 = phi_4044_;
                                        if (_e1605 > _e1609) {
                                            phi_4049_ = 0u;
                                            phi_4050_ = 2u;
                                        } else {
                                            phi_4049_ = 1u;
                                            phi_4050_ = 0u;
                                        }
                                        let _e1612 = phi_4049_;
                                        let _e1614 = phi_4050_;
                                        phi_4051_ = _e1612;
                                        phi_4052_ = _e1614;
                                    }
                                    let _e1629 = phi_4051_;
                                    let _e1631 = phi_4052_;
                                    let _e1634 = local_3.member[_e1631];
                                    let _e1637 = local_4.member[_e1629];
                                    let _e1641 = local_3.member[_e1629];
                                    let _e1644 = local_4.member[_e1631];
                                    let _e1646 = ((_e1634 * _e1637) - (_e1641 * _e1644));
                                    let _e1648 = local_3.member_1;
                                    let _e1650 = local_4.member_2;
                                    let _e1653 = local_3.member_2;
                                    let _e1655 = local_4.member_1;
                                    let _e1660 = local_3.member_2;
                                    let _e1662 = local_4.member_2;
                                    let _e1669 = local_3.member_2;
                                    let _e1672 = local_4.member_2;
                                    let _e1676 = (((((_e1648 * _e1650) + (_e1653 * _e1655)) * 2.01f) + ((_e1660 * _e1662) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1669) * (1f + _e1672))));
                                    if (_e1646 < 0f) {
                                        phi_4119_ = -(_e1646);
                                    } else {
                                        phi_4119_ = _e1646;
                                    }
                                    let _e1680 = phi_4119_;
                                    if (_e1680 > _e1676) {
                                        if (_e1646 < 0f) {
                                            phi_4128_ = -1f;
                                        } else {
                                            phi_4128_ = 1f;
                                        }
                                        let _e1684 = phi_4128_;
                                        let _e1687 = local_2.member[_e1631];
                                        let _e1690 = local_4.member[_e1629];
                                        let _e1694 = local_2.member[_e1629];
                                        let _e1697 = local_4.member[_e1631];
                                        let _e1701 = local_2.member_1;
                                        let _e1703 = local_4.member_2;
                                        let _e1706 = local_2.member_2;
                                        let _e1708 = local_4.member_1;
                                        let _e1713 = local_2.member_2;
                                        let _e1715 = local_4.member_2;
                                        let _e1722 = local_2.member_2;
                                        let _e1725 = local_4.member_2;
                                        let _e1729 = (((((_e1701 * _e1703) + (_e1706 * _e1708)) * 2.01f) + ((_e1713 * _e1715) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1722) * (1f + _e1725))));
                                        let _e1732 = local_3.member[_e1631];
                                        let _e1735 = local_2.member[_e1629];
                                        let _e1739 = local_3.member[_e1629];
                                        let _e1742 = local_2.member[_e1631];
                                        let _e1746 = local_3.member_1;
                                        let _e1748 = local_2.member_2;
                                        let _e1751 = local_3.member_2;
                                        let _e1753 = local_2.member_1;
                                        let _e1758 = local_3.member_2;
                                        let _e1760 = local_2.member_2;
                                        let _e1767 = local_3.member_2;
                                        let _e1770 = local_2.member_2;
                                        let _e1774 = (((((_e1746 * _e1748) + (_e1751 * _e1753)) * 2.01f) + ((_e1758 * _e1760) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1767) * (1f + _e1770))));
                                        let _e1775 = (_e1646 * _e1684);
                                        let _e1776 = (((_e1687 * _e1690) - (_e1694 * _e1697)) * _e1684);
                                        let _e1777 = (((_e1732 * _e1735) - (_e1739 * _e1742)) * _e1684);
                                        if (_e1775 < 0f) {
                                            phi_4259_ = -(_e1775);
                                        } else {
                                            phi_4259_ = _e1775;
                                        }
                                        let _e1781 = phi_4259_;
                                        if (_e1776 < 0f) {
                                            phi_4265_ = -(_e1776);
                                        } else {
                                            phi_4265_ = _e1776;
                                        }
                                        let _e1785 = phi_4265_;
                                        if (_e1777 < 0f) {
                                            phi_4272_ = -(_e1777);
                                        } else {
                                            phi_4272_ = _e1777;
                                        }
                                        let _e1790 = phi_4272_;
                                        let _e1793 = (((_e1781 + _e1785) + _e1790) * (0.000000059604645f * 4f));
                                        local_5[0u].member = _e1776;
                                        local_5[0u].member_1 = _e1729;
                                        local_5[1u].member = _e1777;
                                        local_5[1u].member_1 = _e1774;
                                        local_5[2u].member = (_e1775 - _e1776);
                                        local_5[2u].member_1 = ((_e1676 + _e1729) + _e1793);
                                        local_5[3u].member = (_e1775 - _e1777);
                                        local_5[3u].member_1 = ((_e1676 + _e1774) + _e1793);
                                        phi_4315_ = type_9(0u, 4u);
                                        phi_4318_ = true;
                                        loop {
                                            let _e1814 = phi_4315_;
                                            let _e1816 = phi_4318_;
                                            local_17 = _e1816;
                                            if (_e1814.member < _e1814.member_1) {
                                                phi_4316_ = type_9((_e1814.member + 1u), _e1814.member_1);
                                                phi_4341_ = type_9(1u, _e1814.member);
                                            } else {
                                                phi_4316_ = _e1814;
                                                phi_4341_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1828 = phi_4316_;
                                            let _e1830 = phi_4341_;
                                            if (bitcast<i32>(_e1830.member) != 0i) {
                                                let _e1837 = local_5[_e1830.member_1].member;
                                                let _e1840 = local_5[_e1830.member_1].member_1;
                                                let _e1842 = (_e1837 < -(_e1840));
                                                if _e1842 {
                                                    phi_4368_ = bool();
                                                    phi_4369_ = false;
                                                } else {
                                                    phi_4368_ = (_e1816 && (_e1837 > _e1840));
                                                    phi_4369_ = true;
                                                }
                                                let _e1846 = phi_4368_;
                                                let _e1848 = phi_4369_;
                                                phi_4319_ = _e1846;
                                                phi_4370_ = _e1848;
                                                phi_4371_ = _e1842;
                                            } else {
                                                phi_4319_ = bool();
                                                phi_4370_ = false;
                                                phi_4371_ = false;
                                            }
                                            let _e1850 = phi_4319_;
                                            let _e1852 = phi_4370_;
                                            let _e1854 = phi_4371_;
                                            local_16 = _e1854;
                                            continue;
                                            continuing {
                                                phi_4315_ = _e1828;
                                                phi_4318_ = _e1850;
                                                break if !(_e1852);
                                            }
                                        }
                                        let _e1857 = local_16;
                                        if _e1857 {
                                            phi_4375_ = false;
                                        } else {
                                            phi_4375_ = true;
                                        }
                                        let _e1859 = phi_4375_;
                                        if _e1859 {
                                            let _e1861 = local_17;
                                            if _e1861 {
                                                phi_4382_ = 1u;
                                            } else {
                                                phi_4382_ = 2u;
                                            }
                                            let _e1863 = phi_4382_;
                                            phi_4383_ = _e1863;
                                            phi_4384_ = false;
                                        } else {
                                            phi_4383_ = u32();
                                            phi_4384_ = true;
                                        }
                                        let _e1865 = phi_4383_;
                                        let _e1867 = phi_4384_;
                                        phi_4385_ = _e1865;
                                        phi_4386_ = 0u;
                                        phi_4387_ = _e1867;
                                    } else {
                                        phi_4385_ = u32();
                                        phi_4386_ = 2u;
                                        phi_4387_ = true;
                                    }
                                    let _e1869 = phi_4385_;
                                    let _e1871 = phi_4386_;
                                    let _e1873 = phi_4387_;
                                    if _e1873 {
                                        phi_4391_ = _e1871;
                                    } else {
                                        phi_4391_ = _e1869;
                                    }
                                    let _e1875 = phi_4391_;
                                    let _e1876 = (_e1875 == 0u);
                                    if _e1876 {
                                        phi_5432_ = f32();
                                        phi_5433_ = false;
                                        phi_5434_ = false;
                                        phi_5435_ = false;
                                    } else {
                                        if (_e1875 == 1u) {
                                            if _e1173.member_2 {
                                                if ((_e1173.member_1 - _e1173.member) <= 0.0000005f) {
                                                    phi_4411_ = false;
                                                } else {
                                                    phi_4411_ = true;
                                                }
                                                let _e1884 = phi_4411_;
                                                phi_4412_ = _e1884;
                                            } else {
                                                phi_4412_ = true;
                                            }
                                            let _e1886 = phi_4412_;
                                            phi_4413_ = _e1886;
                                        } else {
                                            phi_4413_ = true;
                                        }
                                        let _e1888 = phi_4413_;
                                        if _e1888 {
                                            let _e1893 = local_12.member[0u];
                                            let _e1899 = local_12.member_1[0u];
                                            let _e1905 = local_12.member_2[0u];
                                            let _e1909 = (_e1893[0] - _e1899[0]);
                                            let _e1910 = (_e1893[1] - _e1899[1]);
                                            let _e1911 = (_e1893[2] - _e1899[2]);
                                            local = array<array<f32, 3>, 4>(_e1893, array<f32, 3>(_e1909, _e1910, _e1911), array<f32, 3>((_e1893[0] - _e1905[0]), (_e1893[1] - _e1905[1]), (_e1893[2] - _e1905[2])), array<f32, 3>((_e1909 - _e1905[0]), (_e1910 - _e1905[1]), (_e1911 - _e1905[2])));
                                            let _e1924 = local_12.member[1u];
                                            let _e1930 = local_12.member_1[1u];
                                            let _e1936 = local_12.member_2[1u];
                                            let _e1940 = (_e1924[0] - _e1930[0]);
                                            let _e1941 = (_e1924[1] - _e1930[1]);
                                            let _e1942 = (_e1924[2] - _e1930[2]);
                                            local_1 = array<array<f32, 3>, 4>(_e1924, array<f32, 3>(_e1940, _e1941, _e1942), array<f32, 3>((_e1924[0] - _e1936[0]), (_e1924[1] - _e1936[1]), (_e1924[2] - _e1936[2])), array<f32, 3>((_e1940 - _e1936[0]), (_e1941 - _e1936[1]), (_e1942 - _e1936[2])));
                                            let _e1955 = local_12.member[0u];
                                            if (_e1955[0] < 0f) {
                                                phi_4609_ = -(_e1955[0]);
                                            } else {
                                                phi_4609_ = _e1955[0];
                                            }
                                            let _e1962 = phi_4609_;
                                            if (_e1955[1] < 0f) {
                                                phi_4616_ = -(_e1955[1]);
                                            } else {
                                                phi_4616_ = _e1955[1];
                                            }
                                            let _e1966 = phi_4616_;
                                            if (_e1962 > _e1966) {
                                                phi_4621_ = _e1962;
                                            } else {
                                                phi_4621_ = _e1966;
                                            }
                                            let _e1969 = phi_4621_;
                                            if (_e1955[2] < 0f) {
                                                phi_4628_ = -(_e1955[2]);
                                            } else {
                                                phi_4628_ = _e1955[2];
                                            }
                                            let _e1973 = phi_4628_;
                                            if (_e1969 > _e1973) {
                                                phi_4633_ = _e1969;
                                            } else {
                                                phi_4633_ = _e1973;
                                            }
                                            let _e1976 = phi_4633_;
                                            let _e1979 = local_12.member[1u];
                                            if (_e1979[0] < 0f) {
                                                phi_4646_ = -(_e1979[0]);
                                            } else {
                                                phi_4646_ = _e1979[0];
                                            }
                                            let _e1986 = phi_4646_;
                                            if (_e1979[1] < 0f) {
                                                phi_4653_ = -(_e1979[1]);
                                            } else {
                                                phi_4653_ = _e1979[1];
                                            }
                                            let _e1990 = phi_4653_;
                                            if (_e1986 > _e1990) {
                                                phi_4658_ = _e1986;
                                            } else {
                                                phi_4658_ = _e1990;
                                            }
                                            let _e1993 = phi_4658_;
                                            if (_e1979[2] < 0f) {
                                                phi_4665_ = -(_e1979[2]);
                                            } else {
                                                phi_4665_ = _e1979[2];
                                            }
                                            let _e1997 = phi_4665_;
                                            if (_e1993 > _e1997) {
                                                phi_4670_ = _e1993;
                                            } else {
                                                phi_4670_ = _e1997;
                                            }
                                            let _e2000 = phi_4670_;
                                            if (_e1976 > _e2000) {
                                                phi_4675_ = _e1976;
                                            } else {
                                                phi_4675_ = _e2000;
                                            }
                                            let _e2003 = phi_4675_;
                                            let _e2005 = local_12.member_3;
                                            let _e2009 = local_12.member_1[0u];
                                            if (_e2009[0] < 0f) {
                                                phi_4692_ = -(_e2009[0]);
                                            } else {
                                                phi_4692_ = _e2009[0];
                                            }
                                            let _e2016 = phi_4692_;
                                            if (_e2009[1] < 0f) {
                                                phi_4699_ = -(_e2009[1]);
                                            } else {
                                                phi_4699_ = _e2009[1];
                                            }
                                            let _e2020 = phi_4699_;
                                            if (_e2016 > _e2020) {
                                                phi_4704_ = _e2016;
                                            } else {
                                                phi_4704_ = _e2020;
                                            }
                                            let _e2023 = phi_4704_;
                                            if (_e2009[2] < 0f) {
                                                phi_4711_ = -(_e2009[2]);
                                            } else {
                                                phi_4711_ = _e2009[2];
                                            }
                                            let _e2027 = phi_4711_;
                                            if (_e2023 > _e2027) {
                                                phi_4716_ = _e2023;
                                            } else {
                                                phi_4716_ = _e2027;
                                            }
                                            let _e2030 = phi_4716_;
                                            let _e2033 = local_12.member_1[1u];
                                            if (_e2033[0] < 0f) {
                                                phi_4730_ = -(_e2033[0]);
                                            } else {
                                                phi_4730_ = _e2033[0];
                                            }
                                            let _e2040 = phi_4730_;
                                            if (_e2033[1] < 0f) {
                                                phi_4737_ = -(_e2033[1]);
                                            } else {
                                                phi_4737_ = _e2033[1];
                                            }
                                            let _e2044 = phi_4737_;
                                            if (_e2040 > _e2044) {
                                                phi_4742_ = _e2040;
                                            } else {
                                                phi_4742_ = _e2044;
                                            }
                                            let _e2047 = phi_4742_;
                                            if (_e2033[2] < 0f) {
                                                phi_4749_ = -(_e2033[2]);
                                            } else {
                                                phi_4749_ = _e2033[2];
                                            }
                                            let _e2051 = phi_4749_;
                                            if (_e2047 > _e2051) {
                                                phi_4754_ = _e2047;
                                            } else {
                                                phi_4754_ = _e2051;
                                            }
                                            let _e2054 = phi_4754_;
                                            if (_e2030 > _e2054) {
                                                phi_4759_ = _e2030;
                                            } else {
                                                phi_4759_ = _e2054;
                                            }
                                            let _e2057 = phi_4759_;
                                            let _e2059 = local_12.member_3;
                                            let _e2063 = local_12.member_2[0u];
                                            if (_e2063[0] < 0f) {
                                                phi_4776_ = -(_e2063[0]);
                                            } else {
                                                phi_4776_ = _e2063[0];
                                            }
                                            let _e2070 = phi_4776_;
                                            if (_e2063[1] < 0f) {
                                                phi_4783_ = -(_e2063[1]);
                                            } else {
                                                phi_4783_ = _e2063[1];
                                            }
                                            let _e2074 = phi_4783_;
                                            if (_e2070 > _e2074) {
                                                phi_4788_ = _e2070;
                                            } else {
                                                phi_4788_ = _e2074;
                                            }
                                            let _e2077 = phi_4788_;
                                            if (_e2063[2] < 0f) {
                                                phi_4795_ = -(_e2063[2]);
                                            } else {
                                                phi_4795_ = _e2063[2];
                                            }
                                            let _e2081 = phi_4795_;
                                            if (_e2077 > _e2081) {
                                                phi_4800_ = _e2077;
                                            } else {
                                                phi_4800_ = _e2081;
                                            }
                                            let _e2084 = phi_4800_;
                                            let _e2087 = local_12.member_2[1u];
                                            if (_e2087[0] < 0f) {
                                                phi_4814_ = -(_e2087[0]);
                                            } else {
                                                phi_4814_ = _e2087[0];
                                            }
                                            let _e2094 = phi_4814_;
                                            if (_e2087[1] < 0f) {
                                                phi_4821_ = -(_e2087[1]);
                                            } else {
                                                phi_4821_ = _e2087[1];
                                            }
                                            let _e2098 = phi_4821_;
                                            if (_e2094 > _e2098) {
                                                phi_4826_ = _e2094;
                                            } else {
                                                phi_4826_ = _e2098;
                                            }
                                            let _e2101 = phi_4826_;
                                            if (_e2087[2] < 0f) {
                                                phi_4833_ = -(_e2087[2]);
                                            } else {
                                                phi_4833_ = _e2087[2];
                                            }
                                            let _e2105 = phi_4833_;
                                            if (_e2101 > _e2105) {
                                                phi_4838_ = _e2101;
                                            } else {
                                                phi_4838_ = _e2105;
                                            }
                                            let _e2108 = phi_4838_;
                                            if (_e2084 > _e2108) {
                                                phi_4843_ = _e2084;
                                            } else {
                                                phi_4843_ = _e2108;
                                            }
                                            let _e2111 = phi_4843_;
                                            let _e2113 = local_12.member_3;
                                            let _e2120 = local_12.member_3;
                                            phi_4859_ = type_9(0u, 48u);
                                            phi_4862_ = _e1173.member;
                                            loop {
                                                let _e2126 = phi_4859_;
                                                let _e2128 = phi_4862_;
                                                local_61 = _e2128;
                                                local_24 = _e2128;
                                                local_25 = _e2128;
                                                local_26 = _e2128;
                                                local_27 = _e2128;
                                                if (_e2126.member < _e2126.member_1) {
                                                    phi_4860_ = type_9((_e2126.member + 1u), _e2126.member_1);
                                                    phi_4885_ = type_9(1u, _e2126.member);
                                                } else {
                                                    phi_4860_ = _e2126;
                                                    phi_4885_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2140 = phi_4860_;
                                                let _e2142 = phi_4885_;
                                                if (bitcast<i32>(_e2142.member) != 0i) {
                                                    let _e2148 = local_12.member[0u];
                                                    let _e2154 = local_12.member[1u];
                                                    let _e2170 = local_12.member_1[0u];
                                                    let _e2176 = local_12.member_1[1u];
                                                    let _e2192 = local_12.member_2[0u];
                                                    let _e2198 = local_12.member_2[1u];
                                                    let _e2212 = function_2(array<f32, 3>((_e2148[0] + ((_e2154[0] - _e2148[0]) * _e2128)), (_e2148[1] + ((_e2154[1] - _e2148[1]) * _e2128)), (_e2148[2] + ((_e2154[2] - _e2148[2]) * _e2128))), array<f32, 3>((_e2170[0] + ((_e2176[0] - _e2170[0]) * _e2128)), (_e2170[1] + ((_e2176[1] - _e2170[1]) * _e2128)), (_e2170[2] + ((_e2176[2] - _e2170[2]) * _e2128))), array<f32, 3>((_e2192[0] + ((_e2198[0] - _e2192[0]) * _e2128)), (_e2192[1] + ((_e2198[1] - _e2192[1]) * _e2128)), (_e2192[2] + ((_e2198[2] - _e2192[2]) * _e2128))), 1u);
                                                    if (_e2212[0] < 0f) {
                                                        phi_4996_ = -(_e2212[0]);
                                                    } else {
                                                        phi_4996_ = _e2212[0];
                                                    }
                                                    let _e2217 = phi_4996_;
                                                    if (_e2212[1] < 0f) {
                                                        phi_5003_ = -(_e2212[1]);
                                                    } else {
                                                        phi_5003_ = _e2212[1];
                                                    }
                                                    let _e2222 = phi_5003_;
                                                    if (_e2212[2] < 0f) {
                                                        phi_5011_ = -(_e2212[2]);
                                                    } else {
                                                        phi_5011_ = _e2212[2];
                                                    }
                                                    let _e2228 = phi_5011_;
                                                    let _e2229 = ((_e2217 + _e2222) + _e2228);
                                                    if (_e2229 > 0f) {
                                                        if ((bitcast<u32>(_e2229) & 2139095040u) != 2139095040u) {
                                                            let _e2234 = (1f / _e2229);
                                                            let _e2236 = (_e2212[0] * _e2234);
                                                            let _e2238 = (_e2212[1] * _e2234);
                                                            let _e2240 = (_e2212[2] * _e2234);
                                                            let _e2245 = (((_e2236 * _e2236) + (_e2238 * _e2238)) + (_e2240 * _e2240));
                                                            if (_e2245 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2245 > 0f) {
                                                                    phi_5048_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_5048_ = 0f;
                                                                }
                                                                let _e2298 = phi_5048_;
                                                                phi_5112_ = _e2298;
                                                            } else {
                                                                phi_5055_ = type_14(0i, 5i);
                                                                phi_5058_ = bitcast<f32>(((bitcast<u32>(_e2245) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2253 = phi_5055_;
                                                                    let _e2255 = phi_5058_;
                                                                    local_18 = _e2255;
                                                                    if (_e2253.member < _e2253.member_1) {
                                                                        let _e2262 = (_e2253.member + 1i);
                                                                        if ((false == (_e2262 > _e2253.member)) != false) {
                                                                            phi_5079_ = true;
                                                                        } else {
                                                                            phi_5079_ = false;
                                                                        }
                                                                        let _e2267 = phi_5079_;
                                                                        if _e2267 {
                                                                            phi_5085_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_5085_ = type_15(1u, _e2262);
                                                                        }
                                                                        let _e2272 = phi_5085_;
                                                                        phi_5056_ = type_14(_e2272.member_1, _e2253.member_1);
                                                                        phi_5099_ = type_15(1u, _e2253.member);
                                                                    } else {
                                                                        phi_5056_ = _e2253;
                                                                        phi_5099_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2278 = phi_5056_;
                                                                    let _e2280 = phi_5099_;
                                                                    let _e2283 = (bitcast<i32>(_e2280.member) != 0i);
                                                                    if _e2283 {
                                                                        phi_5059_ = (0.5f * (_e2255 + (_e2245 / _e2255)));
                                                                    } else {
                                                                        phi_5059_ = f32();
                                                                    }
                                                                    let _e2288 = phi_5059_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_5055_ = _e2278;
                                                                        phi_5058_ = _e2288;
                                                                        break if !(_e2283);
                                                                    }
                                                                }
                                                                let _e2293 = local_18;
                                                                phi_5112_ = (_e2293 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2300 = phi_5112_;
                                                            phi_5121_ = type_9(0u, 4u);
                                                            phi_5124_ = 2f;
                                                            loop {
                                                                let _e2308 = phi_5121_;
                                                                let _e2310 = phi_5124_;
                                                                local_20 = _e2310;
                                                                local_21 = _e2310;
                                                                local_22 = _e2310;
                                                                local_51 = _e2310;
                                                                local_52 = _e2310;
                                                                if (_e2308.member < _e2308.member_1) {
                                                                    phi_5122_ = type_9((_e2308.member + 1u), _e2308.member_1);
                                                                    phi_5147_ = type_9(1u, _e2308.member);
                                                                } else {
                                                                    phi_5122_ = _e2308;
                                                                    phi_5147_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e2322 = phi_5122_;
                                                                let _e2324 = phi_5147_;
                                                                if (bitcast<i32>(_e2324.member) != 0i) {
                                                                    let _e2330 = local[_e2324.member_1];
                                                                    let _e2338 = (((_e2236 * _e2330[0]) + (_e2238 * _e2330[1])) + (_e2240 * _e2330[2]));
                                                                    let _e2340 = local_1[_e2324.member_1];
                                                                    let _e2348 = (((_e2236 * _e2340[0]) + (_e2238 * _e2340[1])) + (_e2240 * _e2340[2]));
                                                                    if (_e2338 < 0f) {
                                                                        phi_5198_ = -(_e2338);
                                                                    } else {
                                                                        phi_5198_ = _e2338;
                                                                    }
                                                                    let _e2352 = phi_5198_;
                                                                    if (_e2348 < 0f) {
                                                                        phi_5204_ = -(_e2348);
                                                                    } else {
                                                                        phi_5204_ = _e2348;
                                                                    }
                                                                    let _e2356 = phi_5204_;
                                                                    let _e2360 = (((((((((_e2003 + _e2005) + (_e2057 + _e2059)) + (_e2111 + _e2113)) * (0.000000059604645f * 16f)) + (_e2120 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2300) * (1f + (0.000000059604645f * 8f)))) + ((_e2352 + _e2356) * (0.000000059604645f * 8f)));
                                                                    if (_e2338 > _e2360) {
                                                                        if (_e2348 > _e2360) {
                                                                            phi_5217_ = false;
                                                                        } else {
                                                                            phi_5217_ = true;
                                                                        }
                                                                        let _e2364 = phi_5217_;
                                                                        phi_5218_ = _e2364;
                                                                    } else {
                                                                        phi_5218_ = true;
                                                                    }
                                                                    let _e2366 = phi_5218_;
                                                                    if _e2366 {
                                                                        if ((_e2338 + ((_e2348 - _e2338) * _e2128)) > _e2360) {
                                                                            if (_e2348 < _e2338) {
                                                                                let _e2374 = ((_e2338 - _e2348) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2374 {
                                                                                    let _e2380 = (((_e2338 - _e2360) / (_e2338 - _e2348)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2310 < _e2380) {
                                                                                        phi_5249_ = _e2310;
                                                                                    } else {
                                                                                        phi_5249_ = _e2380;
                                                                                    }
                                                                                    let _e2383 = phi_5249_;
                                                                                    phi_5250_ = _e2383;
                                                                                } else {
                                                                                    phi_5250_ = f32();
                                                                                }
                                                                                let _e2385 = phi_5250_;
                                                                                phi_5251_ = _e2385;
                                                                                phi_5252_ = _e2374;
                                                                            } else {
                                                                                phi_5251_ = _e2310;
                                                                                phi_5252_ = true;
                                                                            }
                                                                            let _e2387 = phi_5251_;
                                                                            let _e2389 = phi_5252_;
                                                                            if _e2389 {
                                                                                phi_5256_ = false;
                                                                            } else {
                                                                                phi_5256_ = true;
                                                                            }
                                                                            let _e2391 = phi_5256_;
                                                                            phi_5257_ = _e2387;
                                                                            phi_5258_ = _e2389;
                                                                            phi_5259_ = _e2391;
                                                                            phi_5260_ = false;
                                                                        } else {
                                                                            phi_5257_ = f32();
                                                                            phi_5258_ = false;
                                                                            phi_5259_ = false;
                                                                            phi_5260_ = true;
                                                                        }
                                                                        let _e2393 = phi_5257_;
                                                                        let _e2395 = phi_5258_;
                                                                        let _e2397 = phi_5259_;
                                                                        let _e2399 = phi_5260_;
                                                                        phi_5261_ = _e2393;
                                                                        phi_5262_ = _e2395;
                                                                        phi_5263_ = _e2397;
                                                                        phi_5264_ = _e2399;
                                                                    } else {
                                                                        phi_5261_ = _e2310;
                                                                        phi_5262_ = true;
                                                                        phi_5263_ = false;
                                                                        phi_5264_ = false;
                                                                    }
                                                                    let _e2401 = phi_5261_;
                                                                    let _e2403 = phi_5262_;
                                                                    let _e2405 = phi_5263_;
                                                                    let _e2407 = phi_5264_;
                                                                    phi_5125_ = _e2401;
                                                                    phi_5265_ = _e2403;
                                                                    phi_5266_ = false;
                                                                    phi_5267_ = _e2405;
                                                                    phi_5268_ = _e2407;
                                                                } else {
                                                                    phi_5125_ = f32();
                                                                    phi_5265_ = false;
                                                                    phi_5266_ = true;
                                                                    phi_5267_ = false;
                                                                    phi_5268_ = false;
                                                                }
                                                                let _e2409 = phi_5125_;
                                                                let _e2411 = phi_5265_;
                                                                let _e2413 = phi_5266_;
                                                                let _e2415 = phi_5267_;
                                                                let _e2417 = phi_5268_;
                                                                local_19 = _e2413;
                                                                local_49 = _e2415;
                                                                local_50 = _e2417;
                                                                continue;
                                                                continuing {
                                                                    phi_5121_ = _e2322;
                                                                    phi_5124_ = _e2409;
                                                                    break if !(_e2411);
                                                                }
                                                            }
                                                            let _e2420 = local_19;
                                                            if _e2420 {
                                                                let _e2422 = local_20;
                                                                let _e2423 = (_e2422 > _e1173.member_1);
                                                                if _e2423 {
                                                                    phi_5289_ = false;
                                                                    phi_5290_ = false;
                                                                    phi_5291_ = false;
                                                                } else {
                                                                    let _e2425 = local_21;
                                                                    if (_e2425 > _e2128) {
                                                                        let _e2428 = local_22;
                                                                        let _e2430 = ((_e2428 - _e2128) < 0.00000000023283064f);
                                                                        if _e2430 {
                                                                            phi_5285_ = false;
                                                                        } else {
                                                                            phi_5285_ = true;
                                                                        }
                                                                        let _e2432 = phi_5285_;
                                                                        phi_5286_ = _e2432;
                                                                        phi_5287_ = _e2430;
                                                                        phi_5288_ = false;
                                                                    } else {
                                                                        phi_5286_ = false;
                                                                        phi_5287_ = false;
                                                                        phi_5288_ = true;
                                                                    }
                                                                    let _e2434 = phi_5286_;
                                                                    let _e2436 = phi_5287_;
                                                                    let _e2438 = phi_5288_;
                                                                    phi_5289_ = _e2434;
                                                                    phi_5290_ = _e2436;
                                                                    phi_5291_ = _e2438;
                                                                }
                                                                let _e2440 = phi_5289_;
                                                                let _e2442 = phi_5290_;
                                                                let _e2444 = phi_5291_;
                                                                phi_5292_ = _e2440;
                                                                phi_5293_ = _e2423;
                                                                phi_5294_ = _e2442;
                                                                phi_5295_ = _e2444;
                                                                phi_5296_ = false;
                                                                phi_5297_ = false;
                                                            } else {
                                                                phi_5292_ = false;
                                                                phi_5293_ = false;
                                                                phi_5294_ = false;
                                                                phi_5295_ = false;
                                                                let _e4325 = local_49;
                                                                phi_5296_ = _e4325;
                                                                let _e4328 = local_50;
                                                                phi_5297_ = _e4328;
                                                            }
                                                            let _e2446 = phi_5292_;
                                                            let _e2448 = phi_5293_;
                                                            let _e2450 = phi_5294_;
                                                            let _e2452 = phi_5295_;
                                                            let _e2454 = phi_5296_;
                                                            let _e2456 = phi_5297_;
                                                            let _e4331 = local_51;
                                                            phi_5298_ = _e4331;
                                                            let _e4334 = local_52;
                                                            phi_5299_ = _e4334;
                                                            phi_5300_ = _e2446;
                                                            phi_5301_ = _e2448;
                                                            phi_5302_ = _e2450;
                                                            phi_5303_ = _e2452;
                                                            phi_5304_ = _e2454;
                                                            phi_5305_ = _e2456;
                                                            phi_5306_ = false;
                                                        } else {
                                                            phi_5298_ = f32();
                                                            phi_5299_ = f32();
                                                            phi_5300_ = false;
                                                            phi_5301_ = false;
                                                            phi_5302_ = false;
                                                            phi_5303_ = false;
                                                            phi_5304_ = false;
                                                            phi_5305_ = false;
                                                            phi_5306_ = true;
                                                        }
                                                        let _e2458 = phi_5298_;
                                                        let _e2460 = phi_5299_;
                                                        let _e2462 = phi_5300_;
                                                        let _e2464 = phi_5301_;
                                                        let _e2466 = phi_5302_;
                                                        let _e2468 = phi_5303_;
                                                        let _e2470 = phi_5304_;
                                                        let _e2472 = phi_5305_;
                                                        let _e2474 = phi_5306_;
                                                        phi_5307_ = _e2458;
                                                        phi_5308_ = _e2460;
                                                        phi_5309_ = _e2462;
                                                        phi_5310_ = _e2464;
                                                        phi_5311_ = _e2466;
                                                        phi_5312_ = _e2468;
                                                        phi_5313_ = _e2470;
                                                        phi_5314_ = _e2472;
                                                        phi_5315_ = _e2474;
                                                        phi_5316_ = false;
                                                    } else {
                                                        phi_5307_ = f32();
                                                        phi_5308_ = f32();
                                                        phi_5309_ = false;
                                                        phi_5310_ = false;
                                                        phi_5311_ = false;
                                                        phi_5312_ = false;
                                                        phi_5313_ = false;
                                                        phi_5314_ = false;
                                                        phi_5315_ = false;
                                                        phi_5316_ = true;
                                                    }
                                                    let _e2476 = phi_5307_;
                                                    let _e2478 = phi_5308_;
                                                    let _e2480 = phi_5309_;
                                                    let _e2482 = phi_5310_;
                                                    let _e2484 = phi_5311_;
                                                    let _e2486 = phi_5312_;
                                                    let _e2488 = phi_5313_;
                                                    let _e2490 = phi_5314_;
                                                    let _e2492 = phi_5315_;
                                                    let _e2494 = phi_5316_;
                                                    phi_5317_ = _e2476;
                                                    phi_4863_ = _e2478;
                                                    phi_5318_ = _e2480;
                                                    phi_5319_ = _e2482;
                                                    phi_5320_ = _e2484;
                                                    phi_5321_ = false;
                                                    phi_5322_ = _e2486;
                                                    phi_5323_ = _e2488;
                                                    phi_5324_ = _e2490;
                                                    phi_5325_ = _e2492;
                                                    phi_5326_ = _e2494;
                                                } else {
                                                    phi_5317_ = f32();
                                                    phi_4863_ = f32();
                                                    phi_5318_ = false;
                                                    phi_5319_ = false;
                                                    phi_5320_ = false;
                                                    phi_5321_ = true;
                                                    phi_5322_ = false;
                                                    phi_5323_ = false;
                                                    phi_5324_ = false;
                                                    phi_5325_ = false;
                                                    phi_5326_ = false;
                                                }
                                                let _e2496 = phi_5317_;
                                                let _e2498 = phi_4863_;
                                                let _e2500 = phi_5318_;
                                                let _e2502 = phi_5319_;
                                                let _e2504 = phi_5320_;
                                                let _e2506 = phi_5321_;
                                                let _e2508 = phi_5322_;
                                                let _e2510 = phi_5323_;
                                                let _e2512 = phi_5324_;
                                                let _e2514 = phi_5325_;
                                                let _e2516 = phi_5326_;
                                                local_23 = _e2502;
                                                local_53 = _e2504;
                                                local_54 = _e2506;
                                                local_55 = _e2508;
                                                local_56 = _e2510;
                                                local_57 = _e2512;
                                                local_58 = _e2514;
                                                local_59 = _e2516;
                                                local_60 = _e2496;
                                                local_62 = _e2502;
                                                continue;
                                                continuing {
                                                    phi_4859_ = _e2140;
                                                    phi_4862_ = _e2498;
                                                    break if !(_e2500);
                                                }
                                            }
                                            let _e2519 = local_23;
                                            if _e2519 {
                                                phi_5331_ = type_34(0u, type_34().member_1);
                                                phi_5332_ = false;
                                                phi_5333_ = false;
                                                phi_5334_ = false;
                                                phi_5335_ = false;
                                                phi_5336_ = false;
                                                phi_5337_ = false;
                                                phi_5338_ = false;
                                            } else {
                                                phi_5331_ = type_34();
                                                let _e4367 = local_53;
                                                phi_5332_ = _e4367;
                                                let _e4370 = local_54;
                                                phi_5333_ = _e4370;
                                                let _e4373 = local_55;
                                                phi_5334_ = _e4373;
                                                let _e4376 = local_56;
                                                phi_5335_ = _e4376;
                                                let _e4379 = local_57;
                                                phi_5336_ = _e4379;
                                                let _e4382 = local_58;
                                                phi_5337_ = _e4382;
                                                let _e4385 = local_59;
                                                phi_5338_ = _e4385;
                                            }
                                            let _e2523 = phi_5331_;
                                            let _e2525 = phi_5332_;
                                            let _e2527 = phi_5333_;
                                            let _e2529 = phi_5334_;
                                            let _e2531 = phi_5335_;
                                            let _e2533 = phi_5336_;
                                            let _e2535 = phi_5337_;
                                            let _e2537 = phi_5338_;
                                            if _e2525 {
                                                let _e4388 = local_60;
                                                phi_5342_ = _e4388;
                                                phi_5343_ = true;
                                                phi_5344_ = false;
                                                phi_5345_ = false;
                                                phi_5346_ = false;
                                                phi_5347_ = false;
                                                phi_5348_ = false;
                                                phi_5349_ = false;
                                            } else {
                                                let _e4390 = local_61;
                                                phi_5342_ = _e4390;
                                                phi_5343_ = _e2527;
                                                phi_5344_ = _e2529;
                                                phi_5345_ = _e2531;
                                                phi_5346_ = _e2533;
                                                let _e4397 = local_62;
                                                phi_5347_ = _e4397;
                                                phi_5348_ = _e2535;
                                                phi_5349_ = _e2537;
                                            }
                                            let _e2539 = phi_5342_;
                                            let _e2541 = phi_5343_;
                                            let _e2543 = phi_5344_;
                                            let _e2545 = phi_5345_;
                                            let _e2547 = phi_5346_;
                                            let _e2549 = phi_5347_;
                                            let _e2551 = phi_5348_;
                                            let _e2553 = phi_5349_;
                                            if _e2541 {
                                                phi_5354_ = type_34(1u, _e2539);
                                                phi_5355_ = false;
                                                phi_5356_ = false;
                                                phi_5357_ = false;
                                                phi_5358_ = false;
                                                phi_5359_ = false;
                                                phi_5360_ = false;
                                            } else {
                                                phi_5354_ = type_34();
                                                phi_5355_ = _e2543;
                                                phi_5356_ = _e2545;
                                                phi_5357_ = _e2547;
                                                phi_5358_ = _e2549;
                                                phi_5359_ = _e2551;
                                                phi_5360_ = _e2553;
                                            }
                                            let _e2556 = phi_5354_;
                                            let _e2558 = phi_5355_;
                                            let _e2560 = phi_5356_;
                                            let _e2562 = phi_5357_;
                                            let _e2564 = phi_5358_;
                                            let _e2566 = phi_5359_;
                                            let _e2568 = phi_5360_;
                                            if _e2558 {
                                                let _e2570 = local_24;
                                                phi_5365_ = type_34(1u, _e2570);
                                                phi_5366_ = false;
                                                phi_5367_ = false;
                                                phi_5368_ = true;
                                                phi_5369_ = false;
                                                phi_5370_ = false;
                                            } else {
                                                phi_5365_ = _e2523;
                                                phi_5366_ = _e2560;
                                                phi_5367_ = _e2562;
                                                phi_5368_ = _e2564;
                                                phi_5369_ = _e2566;
                                                phi_5370_ = _e2568;
                                            }
                                            let _e2573 = phi_5365_;
                                            let _e2575 = phi_5366_;
                                            let _e2577 = phi_5367_;
                                            let _e2579 = phi_5368_;
                                            let _e2581 = phi_5369_;
                                            let _e2583 = phi_5370_;
                                            if _e2575 {
                                                let _e2585 = local_25;
                                                phi_5375_ = type_34(1u, _e2585);
                                                phi_5376_ = false;
                                                phi_5377_ = false;
                                                phi_5378_ = false;
                                                phi_5379_ = false;
                                            } else {
                                                phi_5375_ = type_34();
                                                phi_5376_ = _e2577;
                                                phi_5377_ = _e2579;
                                                phi_5378_ = _e2581;
                                                phi_5379_ = _e2583;
                                            }
                                            let _e2588 = phi_5375_;
                                            let _e2590 = phi_5376_;
                                            let _e2592 = phi_5377_;
                                            let _e2594 = phi_5378_;
                                            let _e2596 = phi_5379_;
                                            if _e2590 {
                                                let _e2598 = local_26;
                                                phi_5384_ = type_34(1u, _e2598);
                                                phi_5385_ = true;
                                                phi_5386_ = false;
                                                phi_5387_ = false;
                                                phi_5388_ = false;
                                            } else {
                                                phi_5384_ = _e2588;
                                                phi_5385_ = _e2575;
                                                phi_5386_ = _e2592;
                                                phi_5387_ = _e2594;
                                                phi_5388_ = _e2596;
                                            }
                                            let _e2601 = phi_5384_;
                                            let _e2603 = phi_5385_;
                                            let _e2605 = phi_5386_;
                                            let _e2607 = phi_5387_;
                                            let _e2609 = phi_5388_;
                                            if _e2603 {
                                                phi_5392_ = _e2601;
                                                phi_5393_ = true;
                                                phi_5394_ = false;
                                                phi_5395_ = false;
                                            } else {
                                                phi_5392_ = _e2573;
                                                phi_5393_ = _e2605;
                                                phi_5394_ = _e2607;
                                                phi_5395_ = _e2609;
                                            }
                                            let _e2611 = phi_5392_;
                                            let _e2613 = phi_5393_;
                                            let _e2615 = phi_5394_;
                                            let _e2617 = phi_5395_;
                                            if _e2613 {
                                                phi_5399_ = false;
                                                phi_5400_ = false;
                                            } else {
                                                phi_5399_ = _e2615;
                                                phi_5400_ = _e2617;
                                            }
                                            let _e2619 = phi_5399_;
                                            let _e2621 = phi_5400_;
                                            if _e2619 {
                                                phi_5404_ = false;
                                                phi_5405_ = false;
                                            } else {
                                                phi_5404_ = _e2621;
                                                phi_5405_ = _e2613;
                                            }
                                            let _e2623 = phi_5404_;
                                            let _e2625 = phi_5405_;
                                            if _e2623 {
                                                phi_5409_ = true;
                                                phi_5410_ = false;
                                            } else {
                                                phi_5409_ = _e2619;
                                                phi_5410_ = _e2625;
                                            }
                                            let _e2627 = phi_5409_;
                                            let _e2629 = phi_5410_;
                                            if _e2627 {
                                                let _e2631 = local_27;
                                                phi_5415_ = type_34(1u, _e2631);
                                                phi_5416_ = true;
                                            } else {
                                                phi_5415_ = _e2611;
                                                phi_5416_ = _e2629;
                                            }
                                            let _e2634 = phi_5415_;
                                            let _e2636 = phi_5416_;
                                            if _e2636 {
                                                phi_5420_ = _e2634;
                                            } else {
                                                phi_5420_ = _e2556;
                                            }
                                            let _e2638 = phi_5420_;
                                            let _e2641 = (_e2638.member != 0u);
                                            if _e2641 {
                                                phi_5427_ = false;
                                            } else {
                                                phi_5427_ = true;
                                            }
                                            let _e2643 = phi_5427_;
                                            phi_5428_ = _e2638.member_1;
                                            phi_5429_ = _e2643;
                                            phi_5430_ = _e2641;
                                            phi_5431_ = false;
                                        } else {
                                            phi_5428_ = f32();
                                            phi_5429_ = false;
                                            phi_5430_ = false;
                                            phi_5431_ = true;
                                        }
                                        let _e2645 = phi_5428_;
                                        let _e2647 = phi_5429_;
                                        let _e2649 = phi_5430_;
                                        let _e2651 = phi_5431_;
                                        phi_5432_ = _e2645;
                                        phi_5433_ = _e2647;
                                        phi_5434_ = _e2649;
                                        phi_5435_ = _e2651;
                                    }
                                    let _e2653 = phi_5432_;
                                    let _e2655 = phi_5433_;
                                    let _e2657 = phi_5434_;
                                    let _e2659 = phi_5435_;
                                    phi_5436_ = _e2653;
                                    phi_5437_ = _e1876;
                                    phi_5438_ = _e2655;
                                    phi_5439_ = _e2657;
                                    phi_5440_ = _e2659;
                                }
                                let _e2661 = phi_5436_;
                                let _e2663 = phi_5437_;
                                let _e2665 = phi_5438_;
                                let _e2667 = phi_5439_;
                                let _e2669 = phi_5440_;
                                if _e2663 {
                                    phi_5444_ = true;
                                    phi_5445_ = false;
                                    phi_5446_ = false;
                                } else {
                                    phi_5444_ = _e2665;
                                    phi_5445_ = _e2667;
                                    phi_5446_ = _e2669;
                                }
                                let _e2671 = phi_5444_;
                                let _e2673 = phi_5445_;
                                let _e2675 = phi_5446_;
                                phi_5447_ = _e2661;
                                phi_5448_ = _e1173;
                                phi_5449_ = _e2671;
                                phi_5450_ = false;
                                phi_5451_ = _e2673;
                                phi_5452_ = _e2675;
                            } else {
                                phi_5447_ = f32();
                                phi_5448_ = type_35();
                                phi_5449_ = false;
                                phi_5450_ = true;
                                phi_5451_ = false;
                                phi_5452_ = false;
                            }
                            let _e2677 = phi_5447_;
                            let _e2679 = phi_5448_;
                            let _e2681 = phi_5449_;
                            let _e2683 = phi_5450_;
                            let _e2685 = phi_5451_;
                            let _e2687 = phi_5452_;
                            local_28 = _e2683;
                            local_63 = _e2685;
                            local_64 = _e2687;
                            local_29 = _e2677;
                            local_30 = _e2679;
                            continue;
                            continuing {
                                phi_2946_ = _e878;
                                break if !(_e2681);
                            }
                        }
                        let _e2690 = local_28;
                        if _e2690 {
                            phi_5457_ = type_34(0u, type_34().member_1);
                            phi_5458_ = false;
                            phi_5459_ = false;
                        } else {
                            phi_5457_ = type_34();
                            let _e4467 = local_63;
                            phi_5458_ = _e4467;
                            let _e4470 = local_64;
                            phi_5459_ = _e4470;
                        }
                        let _e2694 = phi_5457_;
                        let _e2696 = phi_5458_;
                        let _e2698 = phi_5459_;
                        if _e2696 {
                            let _e2700 = local_29;
                            phi_5464_ = type_34(2u, _e2700);
                            phi_5465_ = false;
                        } else {
                            phi_5464_ = type_34();
                            phi_5465_ = _e2698;
                        }
                        let _e2703 = phi_5464_;
                        let _e2705 = phi_5465_;
                        if _e2705 {
                            let _e2707 = local_30;
                            phi_5471_ = type_34(1u, _e2707.member);
                            phi_5472_ = true;
                        } else {
                            phi_5471_ = _e2703;
                            phi_5472_ = _e2696;
                        }
                        let _e2711 = phi_5471_;
                        let _e2713 = phi_5472_;
                        if _e2713 {
                            phi_5476_ = _e2711;
                        } else {
                            phi_5476_ = _e2694;
                        }
                        let _e2715 = phi_5476_;
                        phi_5480_ = _e2715;
                    }
                    let _e3839 = phi_5480_;
                    phi_5481_ = _e3839;
                }
                let _e3843 = phi_5481_;
                switch bitcast<i32>(_e3843.member) {
                    case 0: {
                        phi_5494_ = type_36(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e3849 = function_(_e3843.member_1);
                        phi_5494_ = type_36(0u, _e3849, true);
                        break;
                    }
                    case 2: {
                        let _e3847 = function_(_e3843.member_1);
                        phi_5494_ = type_36(1u, _e3847, true);
                        break;
                    }
                    default: {
                        phi_5494_ = type_36();
                        break;
                    }
                }
                let _e3852 = phi_5494_;
                if _e3852.member_2 {
                    phi_5501_ = (_e3852.member == 0u);
                } else {
                    phi_5501_ = false;
                }
                let _e3857 = phi_5501_;
                if _e3857 {
                    let _e3865 = (_e3852.member_1[1] >> bitcast<u32>(20i));
                    if (_e3865 <= 896u) {
                        phi_5525_ = 0u;
                    } else {
                        phi_5525_ = ((((_e3865 - 896u) << bitcast<u32>(23i)) | ((_e3852.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e3852.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e3880 = phi_5525_;
                    let _e3882 = atomicMin((&earliest.member[0u]), _e3880);
                }
                phi_5529_ = type_20(1u, 0u, _e165, _e168, _e3852.member_1);
                phi_5530_ = _e3857;
                phi_5531_ = (_e3852.member != 0u);
            } else {
                phi_5529_ = type_20(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_5530_ = false;
                phi_5531_ = false;
            }
            let _e3884 = phi_5529_;
            let _e3886 = phi_5530_;
            let _e3888 = phi_5531_;
            let _e3891 = params.member.member.member_1;
            if ((_e3891 & 16u) != 0u) {
                if (_e94 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e3886 {
                    let _e3897 = atomicAdd((&counters[0u]), 1u);
                    phi_5550_ = _e3897;
                } else {
                    phi_5550_ = 0u;
                }
                let _e3899 = phi_5550_;
                workgroupBarrier();
                if (_e94 == 0u) {
                    let _e3902 = atomicLoad((&counters[0u]));
                    if (_e3902 > 0u) {
                        let _e3905 = atomicAdd((&contacts.member[0u]), _e3902);
                        atomicStore((&counters[1u]), _e3905);
                    }
                }
                workgroupBarrier();
                let _e3908 = atomicLoad((&counters[1u]));
                let _e3909 = (_e3908 + _e3899);
                if _e3886 {
                    let _e3912 = params.member.member_1.member_3;
                    if (_e3909 < _e3912) {
                        let _e3914 = (6u * _e3909);
                        atomicStore((&contacts.member[(4u + _e3914)]), _e3884.member);
                        atomicStore((&contacts.member[(_e3914 + 5u)]), _e3884.member_1);
                        atomicStore((&contacts.member[(_e3914 + 6u)]), _e3884.member_2);
                        atomicStore((&contacts.member[(_e3914 + 7u)]), _e3884.member_3);
                        atomicStore((&contacts.member[(_e3914 + 8u)]), _e3884.member_4[0]);
                        atomicStore((&contacts.member[(_e3914 + 9u)]), _e3884.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e94 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3888 {
                let _e3938 = atomicAdd((&counters[0u]), 1u);
                phi_5613_ = _e3938;
            } else {
                phi_5613_ = 0u;
            }
            let _e3940 = phi_5613_;
            workgroupBarrier();
            if (_e94 == 0u) {
                let _e3943 = atomicLoad((&counters[0u]));
                if (_e3943 > 0u) {
                    let _e3946 = atomicAdd((&undecided.member[0u]), _e3943);
                    atomicStore((&counters[1u]), _e3946);
                }
            }
            workgroupBarrier();
            let _e3949 = atomicLoad((&counters[1u]));
            let _e3950 = (_e3949 + _e3940);
            if _e3888 {
                let _e3953 = params.member.member_2.member;
                if (_e3950 < _e3953) {
                    let _e3957 = (2u * _e3950);
                    atomicStore((&undecided.member[(4u + _e3957)]), _e3884.member_2);
                    atomicStore((&undecided.member[(_e3957 + 5u)]), _e3884.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_252_ = _e150;
            break if !(_e156);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
