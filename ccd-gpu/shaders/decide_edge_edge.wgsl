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

struct type_21 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_26 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_27 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
}

struct type_29 {
    member: f32,
    member_1: f32,
}

struct type_32 {
    member: u32,
    member_1: f32,
}

struct type_33 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_34 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_37 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> paths: type_23;
@group(0) @binding(2) 
var<storage> elements: type_14;
@group(0) @binding(3) 
var<storage> input: type_12;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_37;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_37;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_37;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(param: f32) -> array<u32, 2> {
    var phi_6177_: array<u32, 2>;
    var phi_6178_: array<u32, 2>;
    var phi_6179_: bool;
    var phi_6183_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_6178_ = array<u32, 2>();
        phi_6179_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_6177_ = array<u32, 2>();
        } else {
            phi_6177_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_6177_;
        phi_6178_ = _e31;
        phi_6179_ = _e17;
    }
    let _e33 = phi_6178_;
    let _e35 = phi_6179_;
    if _e35 {
        phi_6183_ = array<u32, 2>(0u, 0u);
    } else {
        phi_6183_ = _e33;
    }
    let _e37 = phi_6183_;
    return _e37;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_6156_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_6156_ = param_2;
    } else {
        phi_6156_ = param_1;
    }
    let _e26 = phi_6156_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_5748_: bool;
    var phi_5749_: bool;
    var phi_5750_: bool;
    var phi_5751_: bool;
    var phi_5755_: bool;
    var phi_5728_: bool;
    var phi_5729_: bool;
    var phi_5730_: bool;
    var phi_5731_: bool;
    var phi_5732_: bool;
    var phi_5733_: bool;
    var phi_5737_: bool;
    var phi_5756_: bool;
    var phi_5786_: array<f32, 3>;
    var phi_5787_: bool;
    var phi_5788_: array<f32, 3>;
    var phi_5789_: bool;
    var phi_6016_: f32;
    var phi_6017_: f32;
    var phi_6056_: f32;
    var phi_6057_: f32;
    var phi_6102_: f32;
    var phi_6103_: f32;
    var phi_5837_: f32;
    var phi_5838_: f32;
    var phi_5883_: f32;
    var phi_5884_: f32;
    var phi_5926_: f32;
    var phi_5927_: f32;
    var phi_5975_: f32;
    var phi_5976_: f32;
    var phi_6118_: array<array<f32, 3>, 4>;
    var phi_6126_: array<f32, 3>;

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
                    phi_5728_ = (_e76 <= 1f);
                    phi_5729_ = false;
                } else {
                    phi_5728_ = bool();
                    phi_5729_ = true;
                }
                let _e97 = phi_5728_;
                let _e99 = phi_5729_;
                phi_5730_ = _e97;
                phi_5731_ = _e99;
            } else {
                phi_5730_ = bool();
                phi_5731_ = true;
            }
            let _e101 = phi_5730_;
            let _e103 = phi_5731_;
            phi_5732_ = _e101;
            phi_5733_ = _e103;
        } else {
            phi_5732_ = bool();
            phi_5733_ = true;
        }
        let _e105 = phi_5732_;
        let _e107 = phi_5733_;
        if _e107 {
            phi_5737_ = false;
        } else {
            phi_5737_ = _e105;
        }
        let _e109 = phi_5737_;
        phi_5756_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_5748_ = ((_e72 + _e76) <= 1f);
                phi_5749_ = false;
            } else {
                phi_5748_ = bool();
                phi_5749_ = true;
            }
            let _e83 = phi_5748_;
            let _e85 = phi_5749_;
            phi_5750_ = _e83;
            phi_5751_ = _e85;
        } else {
            phi_5750_ = bool();
            phi_5751_ = true;
        }
        let _e87 = phi_5750_;
        let _e89 = phi_5751_;
        if _e89 {
            phi_5755_ = false;
        } else {
            phi_5755_ = _e87;
        }
        let _e91 = phi_5755_;
        phi_5756_ = _e91;
    }
    let _e111 = phi_5756_;
    if (_e68 > 0f) {
        if _e111 {
            phi_5786_ = array<f32, 3>((param_3[0] - ((param_4[0] * _e72) + (param_5[0] * _e76))), (param_3[1] - ((param_4[1] * _e72) + (param_5[1] * _e76))), (param_3[2] - ((param_4[2] * _e72) + (param_5[2] * _e76))));
            phi_5787_ = false;
        } else {
            phi_5786_ = array<f32, 3>();
            phi_5787_ = true;
        }
        let _e136 = phi_5786_;
        let _e138 = phi_5787_;
        phi_5788_ = _e136;
        phi_5789_ = _e138;
    } else {
        phi_5788_ = array<f32, 3>();
        phi_5789_ = true;
    }
    let _e140 = phi_5788_;
    let _e142 = phi_5789_;
    if _e142 {
        let _e145 = (param_3[0] - param_4[0]);
        let _e148 = (param_3[1] - param_4[1]);
        let _e151 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e293 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_5837_ = _e293;
                } else {
                    phi_5837_ = 1f;
                }
                let _e297 = phi_5837_;
                phi_5838_ = _e297;
            } else {
                phi_5838_ = 0f;
            }
            let _e299 = phi_5838_;
            let _e335 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_5883_ = _e335;
                } else {
                    phi_5883_ = 1f;
                }
                let _e339 = phi_5883_;
                phi_5884_ = _e339;
            } else {
                phi_5884_ = 0f;
            }
            let _e341 = phi_5884_;
            let _e374 = ((((_e145 * param_5[0]) + (_e148 * param_5[1])) + (_e151 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_5926_ = _e374;
                } else {
                    phi_5926_ = 1f;
                }
                let _e378 = phi_5926_;
                phi_5927_ = _e378;
            } else {
                phi_5927_ = 0f;
            }
            let _e380 = phi_5927_;
            let _e393 = (param_3[0] - param_5[0]);
            let _e396 = (param_3[1] - param_5[1]);
            let _e399 = (param_3[2] - param_5[2]);
            let _e419 = ((((_e393 * param_4[0]) + (_e396 * param_4[1])) + (_e399 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_5975_ = _e419;
                } else {
                    phi_5975_ = 1f;
                }
                let _e423 = phi_5975_;
                phi_5976_ = _e423;
            } else {
                phi_5976_ = 0f;
            }
            let _e425 = phi_5976_;
            phi_6118_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e299)), (param_3[1] - (param_4[1] * _e299)), (param_3[2] - (param_4[2] * _e299))), array<f32, 3>((param_3[0] - (param_5[0] * _e341)), (param_3[1] - (param_5[1] * _e341)), (param_3[2] - (param_5[2] * _e341))), array<f32, 3>((_e145 - (param_5[0] * _e380)), (_e148 - (param_5[1] * _e380)), (_e151 - (param_5[2] * _e380))), array<f32, 3>((_e393 - (param_4[0] * _e425)), (_e396 - (param_4[1] * _e425)), (_e399 - (param_4[2] * _e425))));
        } else {
            let _e155 = (param_5[0] - param_4[0]);
            let _e158 = (param_5[1] - param_4[1]);
            let _e161 = (param_5[2] - param_4[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_6016_ = _e172;
                } else {
                    phi_6016_ = 1f;
                }
                let _e176 = phi_6016_;
                phi_6017_ = _e176;
            } else {
                phi_6017_ = 0f;
            }
            let _e178 = phi_6017_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_6056_ = _e208;
                } else {
                    phi_6056_ = 1f;
                }
                let _e212 = phi_6056_;
                phi_6057_ = _e212;
            } else {
                phi_6057_ = 0f;
            }
            let _e214 = phi_6057_;
            let _e250 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_6102_ = _e250;
                } else {
                    phi_6102_ = 1f;
                }
                let _e254 = phi_6102_;
                phi_6103_ = _e254;
            } else {
                phi_6103_ = 0f;
            }
            let _e256 = phi_6103_;
            phi_6118_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e214)), (param_3[1] - (param_4[1] * _e214)), (param_3[2] - (param_4[2] * _e214))), array<f32, 3>((param_3[0] - (param_5[0] * _e256)), (param_3[1] - (param_5[1] * _e256)), (param_3[2] - (param_5[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_6118_;
        let _e441 = function_1(_e438[0], _e438[1]);
        let _e443 = function_1(_e441, _e438[2]);
        let _e445 = function_1(_e443, _e438[3]);
        phi_6126_ = _e445;
    } else {
        phi_6126_ = _e140;
    }
    let _e447 = phi_6126_;
    return _e447;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<array<f32, 3>, 4>;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: type_24;
    var local_3: type_24;
    var local_4: type_24;
    var local_5: array<type_29, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: array<array<f32, 3>, 4>;
    var local_10: array<array<f32, 3>, 4>;
    var local_11: array<f32, 3>;
    var local_12: type_26;
    var phi_207_: u32;
    var phi_223_: u32;
    var phi_244_: u32;
    var phi_245_: u32;
    var phi_248_: type_19;
    var phi_249_: type_19;
    var phi_272_: type_19;
    var phi_722_: f32;
    var phi_729_: f32;
    var phi_734_: f32;
    var phi_741_: f32;
    var phi_746_: f32;
    var phi_759_: f32;
    var phi_766_: f32;
    var phi_771_: f32;
    var phi_778_: f32;
    var phi_783_: f32;
    var phi_788_: f32;
    var phi_805_: f32;
    var phi_812_: f32;
    var phi_817_: f32;
    var phi_824_: f32;
    var phi_829_: f32;
    var phi_843_: f32;
    var phi_850_: f32;
    var phi_855_: f32;
    var phi_862_: f32;
    var phi_867_: f32;
    var phi_872_: f32;
    var phi_889_: f32;
    var phi_896_: f32;
    var phi_901_: f32;
    var phi_908_: f32;
    var phi_913_: f32;
    var phi_927_: f32;
    var phi_934_: f32;
    var phi_939_: f32;
    var phi_946_: f32;
    var phi_951_: f32;
    var phi_956_: f32;
    var phi_987_: f32;
    var phi_993_: f32;
    var phi_1000_: f32;
    var phi_1007_: f32;
    var phi_1013_: f32;
    var phi_1020_: f32;
    var phi_1026_: f32;
    var phi_1032_: f32;
    var phi_1038_: f32;
    var phi_1045_: f32;
    var phi_1052_: f32;
    var phi_1076_: f32;
    var phi_1081_: f32;
    var phi_1086_: f32;
    var phi_1091_: f32;
    var phi_1096_: f32;
    var phi_1101_: f32;
    var phi_1111_: f32;
    var phi_2670_: f32;
    var phi_2676_: f32;
    var phi_2681_: f32;
    var phi_2687_: f32;
    var phi_2693_: f32;
    var phi_2698_: f32;
    var phi_2703_: f32;
    var phi_2711_: bool;
    var phi_2716_: f32;
    var phi_2723_: f32;
    var phi_2763_: type_17;
    var phi_2766_: f32;
    var phi_2787_: bool;
    var phi_2793_: type_18;
    var phi_2764_: type_17;
    var phi_2807_: type_18;
    var phi_2767_: f32;
    var local_13: f32;
    var phi_2756_: f32;
    var phi_2820_: f32;
    var phi_2826_: f32;
    var phi_2851_: type_19;
    var phi_2854_: u32;
    var phi_2852_: type_19;
    var phi_2877_: type_19;
    var phi_2921_: u32;
    var phi_2922_: u32;
    var phi_2855_: u32;
    var phi_2923_: u32;
    var phi_2943_: type_19;
    var phi_2944_: type_19;
    var phi_2967_: type_19;
    var phi_3019_: f32;
    var phi_3026_: f32;
    var phi_3037_: bool;
    var phi_3038_: bool;
    var phi_3039_: bool;
    var phi_3040_: bool;
    var phi_3044_: bool;
    var phi_3055_: type_33;
    var phi_3056_: type_33;
    var phi_3057_: bool;
    var phi_3058_: type_33;
    var phi_3059_: bool;
    var phi_3070_: f32;
    var phi_3080_: type_19;
    var phi_3083_: f32;
    var phi_3085_: f32;
    var phi_3087_: f32;
    var phi_3081_: type_19;
    var phi_3110_: type_19;
    var phi_3135_: f32;
    var phi_3136_: f32;
    var phi_3162_: f32;
    var phi_3178_: f32;
    var phi_3185_: bool;
    var phi_3186_: bool;
    var phi_3187_: bool;
    var phi_3193_: f32;
    var phi_3194_: f32;
    var phi_3195_: bool;
    var phi_3084_: f32;
    var phi_3086_: f32;
    var phi_3088_: f32;
    var phi_3196_: f32;
    var phi_3197_: bool;
    var phi_3198_: bool;
    var local_14: bool;
    var phi_3202_: f32;
    var phi_3203_: f32;
    var phi_3210_: type_19;
    var phi_3213_: f32;
    var phi_3211_: type_19;
    var phi_3236_: type_19;
    var phi_3277_: f32;
    var phi_3287_: f32;
    var phi_3295_: bool;
    var phi_3297_: bool;
    var phi_3302_: f32;
    var phi_3303_: bool;
    var phi_3304_: f32;
    var phi_3305_: bool;
    var phi_3306_: bool;
    var phi_3307_: bool;
    var phi_3308_: f32;
    var phi_3214_: f32;
    var phi_3309_: bool;
    var phi_3310_: bool;
    var phi_3311_: bool;
    var phi_3312_: bool;
    var local_15: bool;
    var phi_3316_: bool;
    var phi_3317_: bool;
    var phi_3321_: bool;
    var phi_3325_: f32;
    var phi_3326_: f32;
    var phi_3328_: type_33;
    var phi_3357_: f32;
    var phi_3364_: f32;
    var phi_3369_: f32;
    var phi_3376_: f32;
    var phi_3381_: f32;
    var phi_3394_: f32;
    var phi_3401_: f32;
    var phi_3406_: f32;
    var phi_3413_: f32;
    var phi_3418_: f32;
    var phi_3423_: f32;
    var phi_3482_: f32;
    var phi_3488_: f32;
    var phi_3493_: f32;
    var phi_3499_: f32;
    var phi_3504_: f32;
    var phi_3516_: f32;
    var phi_3522_: f32;
    var phi_3527_: f32;
    var phi_3533_: f32;
    var phi_3538_: f32;
    var phi_3564_: f32;
    var phi_3571_: f32;
    var phi_3576_: f32;
    var phi_3583_: f32;
    var phi_3588_: f32;
    var phi_3601_: f32;
    var phi_3608_: f32;
    var phi_3613_: f32;
    var phi_3620_: f32;
    var phi_3625_: f32;
    var phi_3630_: f32;
    var phi_3689_: f32;
    var phi_3695_: f32;
    var phi_3700_: f32;
    var phi_3706_: f32;
    var phi_3711_: f32;
    var phi_3723_: f32;
    var phi_3729_: f32;
    var phi_3734_: f32;
    var phi_3740_: f32;
    var phi_3745_: f32;
    var phi_3771_: f32;
    var phi_3778_: f32;
    var phi_3783_: f32;
    var phi_3790_: f32;
    var phi_3795_: f32;
    var phi_3808_: f32;
    var phi_3815_: f32;
    var phi_3820_: f32;
    var phi_3827_: f32;
    var phi_3832_: f32;
    var phi_3837_: f32;
    var phi_3896_: f32;
    var phi_3902_: f32;
    var phi_3907_: f32;
    var phi_3913_: f32;
    var phi_3918_: f32;
    var phi_3930_: f32;
    var phi_3936_: f32;
    var phi_3941_: f32;
    var phi_3947_: f32;
    var phi_3952_: f32;
    var phi_4001_: f32;
    var phi_4007_: f32;
    var phi_4035_: f32;
    var phi_4041_: f32;
    var phi_4046_: u32;
    var phi_4047_: u32;
    var phi_4017_: f32;
    var phi_4023_: f32;
    var phi_4028_: u32;
    var phi_4029_: u32;
    var phi_4048_: u32;
    var phi_4049_: u32;
    var phi_4116_: f32;
    var phi_4125_: f32;
    var phi_4256_: f32;
    var phi_4262_: f32;
    var phi_4269_: f32;
    var phi_4312_: type_19;
    var phi_4315_: bool;
    var phi_4313_: type_19;
    var phi_4338_: type_19;
    var phi_4365_: bool;
    var phi_4366_: bool;
    var phi_4316_: bool;
    var phi_4367_: bool;
    var phi_4368_: bool;
    var local_16: bool;
    var phi_4372_: bool;
    var local_17: bool;
    var phi_4379_: u32;
    var phi_4380_: u32;
    var phi_4381_: bool;
    var phi_4382_: u32;
    var phi_4383_: u32;
    var phi_4384_: bool;
    var phi_4388_: u32;
    var phi_4408_: bool;
    var phi_4409_: bool;
    var phi_4410_: bool;
    var phi_4606_: f32;
    var phi_4613_: f32;
    var phi_4618_: f32;
    var phi_4625_: f32;
    var phi_4630_: f32;
    var phi_4643_: f32;
    var phi_4650_: f32;
    var phi_4655_: f32;
    var phi_4662_: f32;
    var phi_4667_: f32;
    var phi_4672_: f32;
    var phi_4689_: f32;
    var phi_4696_: f32;
    var phi_4701_: f32;
    var phi_4708_: f32;
    var phi_4713_: f32;
    var phi_4727_: f32;
    var phi_4734_: f32;
    var phi_4739_: f32;
    var phi_4746_: f32;
    var phi_4751_: f32;
    var phi_4756_: f32;
    var phi_4773_: f32;
    var phi_4780_: f32;
    var phi_4785_: f32;
    var phi_4792_: f32;
    var phi_4797_: f32;
    var phi_4811_: f32;
    var phi_4818_: f32;
    var phi_4823_: f32;
    var phi_4830_: f32;
    var phi_4835_: f32;
    var phi_4840_: f32;
    var phi_4856_: type_19;
    var phi_4859_: f32;
    var phi_4857_: type_19;
    var phi_4882_: type_19;
    var phi_4993_: f32;
    var phi_5000_: f32;
    var phi_5008_: f32;
    var phi_5052_: type_17;
    var phi_5055_: f32;
    var phi_5076_: bool;
    var phi_5082_: type_18;
    var phi_5053_: type_17;
    var phi_5096_: type_18;
    var phi_5056_: f32;
    var local_18: f32;
    var phi_5045_: f32;
    var phi_5109_: f32;
    var phi_5118_: type_19;
    var phi_5121_: f32;
    var phi_5119_: type_19;
    var phi_5144_: type_19;
    var phi_5195_: f32;
    var phi_5201_: f32;
    var phi_5214_: bool;
    var phi_5215_: bool;
    var phi_5246_: f32;
    var phi_5247_: f32;
    var phi_5248_: f32;
    var phi_5249_: bool;
    var phi_5253_: bool;
    var phi_5254_: f32;
    var phi_5255_: bool;
    var phi_5256_: bool;
    var phi_5257_: bool;
    var phi_5258_: f32;
    var phi_5259_: bool;
    var phi_5260_: bool;
    var phi_5261_: bool;
    var phi_5122_: f32;
    var phi_5262_: bool;
    var phi_5263_: bool;
    var phi_5264_: bool;
    var phi_5265_: bool;
    var local_19: bool;
    var local_20: f32;
    var local_21: f32;
    var local_22: f32;
    var phi_5282_: bool;
    var phi_5283_: bool;
    var phi_5284_: bool;
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
    var phi_5295_: f32;
    var phi_5296_: f32;
    var phi_5297_: bool;
    var phi_5298_: bool;
    var phi_5299_: bool;
    var phi_5300_: bool;
    var phi_5301_: bool;
    var phi_5302_: bool;
    var phi_5303_: bool;
    var phi_5304_: f32;
    var phi_5305_: f32;
    var phi_5306_: bool;
    var phi_5307_: bool;
    var phi_5308_: bool;
    var phi_5309_: bool;
    var phi_5310_: bool;
    var phi_5311_: bool;
    var phi_5312_: bool;
    var phi_5313_: bool;
    var phi_5314_: f32;
    var phi_4860_: f32;
    var phi_5315_: bool;
    var phi_5316_: bool;
    var phi_5317_: bool;
    var phi_5318_: bool;
    var phi_5319_: bool;
    var phi_5320_: bool;
    var phi_5321_: bool;
    var phi_5322_: bool;
    var phi_5323_: bool;
    var local_23: bool;
    var phi_5328_: type_32;
    var phi_5329_: bool;
    var phi_5330_: bool;
    var phi_5331_: bool;
    var phi_5332_: bool;
    var phi_5333_: bool;
    var phi_5334_: bool;
    var phi_5335_: bool;
    var phi_5339_: f32;
    var phi_5340_: bool;
    var phi_5341_: bool;
    var phi_5342_: bool;
    var phi_5343_: bool;
    var phi_5344_: bool;
    var phi_5345_: bool;
    var phi_5346_: bool;
    var phi_5351_: type_32;
    var phi_5352_: bool;
    var phi_5353_: bool;
    var phi_5354_: bool;
    var phi_5355_: bool;
    var phi_5356_: bool;
    var phi_5357_: bool;
    var local_24: f32;
    var phi_5362_: type_32;
    var phi_5363_: bool;
    var phi_5364_: bool;
    var phi_5365_: bool;
    var phi_5366_: bool;
    var phi_5367_: bool;
    var local_25: f32;
    var phi_5372_: type_32;
    var phi_5373_: bool;
    var phi_5374_: bool;
    var phi_5375_: bool;
    var phi_5376_: bool;
    var local_26: f32;
    var phi_5381_: type_32;
    var phi_5382_: bool;
    var phi_5383_: bool;
    var phi_5384_: bool;
    var phi_5385_: bool;
    var phi_5389_: type_32;
    var phi_5390_: bool;
    var phi_5391_: bool;
    var phi_5392_: bool;
    var phi_5396_: bool;
    var phi_5397_: bool;
    var phi_5401_: bool;
    var phi_5402_: bool;
    var phi_5406_: bool;
    var phi_5407_: bool;
    var local_27: f32;
    var phi_5412_: type_32;
    var phi_5413_: bool;
    var phi_5417_: type_32;
    var phi_5424_: bool;
    var phi_5425_: f32;
    var phi_5426_: bool;
    var phi_5427_: bool;
    var phi_5428_: bool;
    var phi_5429_: f32;
    var phi_5430_: bool;
    var phi_5431_: bool;
    var phi_5432_: bool;
    var phi_5433_: f32;
    var phi_5434_: bool;
    var phi_5435_: bool;
    var phi_5436_: bool;
    var phi_5437_: bool;
    var phi_5441_: bool;
    var phi_5442_: bool;
    var phi_5443_: bool;
    var phi_5444_: f32;
    var phi_5445_: type_33;
    var phi_5446_: bool;
    var phi_5447_: bool;
    var phi_5448_: bool;
    var phi_5449_: bool;
    var local_28: bool;
    var phi_5454_: type_32;
    var phi_5455_: bool;
    var phi_5456_: bool;
    var local_29: f32;
    var phi_5461_: type_32;
    var phi_5462_: bool;
    var local_30: type_33;
    var phi_5468_: type_32;
    var phi_5469_: bool;
    var phi_5473_: type_32;
    var phi_1312_: f32;
    var phi_1319_: f32;
    var phi_1324_: f32;
    var phi_1331_: f32;
    var phi_1336_: f32;
    var phi_1349_: f32;
    var phi_1356_: f32;
    var phi_1361_: f32;
    var phi_1368_: f32;
    var phi_1373_: f32;
    var phi_1378_: f32;
    var phi_1395_: f32;
    var phi_1402_: f32;
    var phi_1407_: f32;
    var phi_1414_: f32;
    var phi_1419_: f32;
    var phi_1433_: f32;
    var phi_1440_: f32;
    var phi_1445_: f32;
    var phi_1452_: f32;
    var phi_1457_: f32;
    var phi_1462_: f32;
    var phi_1479_: f32;
    var phi_1486_: f32;
    var phi_1491_: f32;
    var phi_1498_: f32;
    var phi_1503_: f32;
    var phi_1517_: f32;
    var phi_1524_: f32;
    var phi_1529_: f32;
    var phi_1536_: f32;
    var phi_1541_: f32;
    var phi_1546_: f32;
    var phi_1562_: type_19;
    var phi_1565_: f32;
    var phi_1563_: type_19;
    var phi_1588_: type_19;
    var phi_1699_: f32;
    var phi_1706_: f32;
    var phi_1714_: f32;
    var phi_1758_: type_17;
    var phi_1761_: f32;
    var phi_1782_: bool;
    var phi_1788_: type_18;
    var phi_1759_: type_17;
    var phi_1802_: type_18;
    var phi_1762_: f32;
    var local_31: f32;
    var phi_1751_: f32;
    var phi_1815_: f32;
    var phi_1824_: type_19;
    var phi_1827_: f32;
    var phi_1825_: type_19;
    var phi_1850_: type_19;
    var phi_1901_: f32;
    var phi_1907_: f32;
    var phi_1920_: bool;
    var phi_1921_: bool;
    var phi_1952_: f32;
    var phi_1953_: f32;
    var phi_1954_: f32;
    var phi_1955_: bool;
    var phi_1959_: bool;
    var phi_1960_: f32;
    var phi_1961_: bool;
    var phi_1962_: bool;
    var phi_1963_: bool;
    var phi_1964_: f32;
    var phi_1965_: bool;
    var phi_1966_: bool;
    var phi_1967_: bool;
    var phi_1828_: f32;
    var phi_1968_: bool;
    var phi_1969_: bool;
    var phi_1970_: bool;
    var phi_1971_: bool;
    var local_32: bool;
    var local_33: f32;
    var local_34: f32;
    var local_35: f32;
    var phi_1988_: bool;
    var phi_1989_: bool;
    var phi_1990_: bool;
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
    var phi_2001_: f32;
    var phi_2002_: f32;
    var phi_2003_: bool;
    var phi_2004_: bool;
    var phi_2005_: bool;
    var phi_2006_: bool;
    var phi_2007_: bool;
    var phi_2008_: bool;
    var phi_2009_: bool;
    var phi_2010_: f32;
    var phi_2011_: f32;
    var phi_2012_: bool;
    var phi_2013_: bool;
    var phi_2014_: bool;
    var phi_2015_: bool;
    var phi_2016_: bool;
    var phi_2017_: bool;
    var phi_2018_: bool;
    var phi_2019_: bool;
    var phi_2020_: f32;
    var phi_1566_: f32;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2023_: bool;
    var phi_2024_: bool;
    var phi_2025_: bool;
    var phi_2026_: bool;
    var phi_2027_: bool;
    var phi_2028_: bool;
    var phi_2029_: bool;
    var local_36: bool;
    var phi_2034_: type_32;
    var phi_2035_: bool;
    var phi_2036_: bool;
    var phi_2037_: bool;
    var phi_2038_: bool;
    var phi_2039_: bool;
    var phi_2040_: bool;
    var phi_2041_: bool;
    var phi_2045_: f32;
    var phi_2046_: bool;
    var phi_2047_: bool;
    var phi_2048_: bool;
    var phi_2049_: bool;
    var phi_2050_: bool;
    var phi_2051_: bool;
    var phi_2052_: bool;
    var phi_2057_: type_32;
    var phi_2058_: bool;
    var phi_2059_: bool;
    var phi_2060_: bool;
    var phi_2061_: bool;
    var phi_2062_: bool;
    var phi_2063_: bool;
    var local_37: f32;
    var phi_2068_: type_32;
    var phi_2069_: bool;
    var phi_2070_: bool;
    var phi_2071_: bool;
    var phi_2072_: bool;
    var phi_2073_: bool;
    var local_38: f32;
    var phi_2078_: type_32;
    var phi_2079_: bool;
    var phi_2080_: bool;
    var phi_2081_: bool;
    var phi_2082_: bool;
    var local_39: f32;
    var phi_2087_: type_32;
    var phi_2088_: bool;
    var phi_2089_: bool;
    var phi_2090_: bool;
    var phi_2091_: bool;
    var phi_2095_: type_32;
    var phi_2096_: bool;
    var phi_2097_: bool;
    var phi_2098_: bool;
    var phi_2102_: bool;
    var phi_2103_: bool;
    var phi_2107_: bool;
    var phi_2108_: bool;
    var phi_2112_: bool;
    var phi_2113_: bool;
    var local_40: f32;
    var phi_2118_: type_32;
    var phi_2119_: bool;
    var phi_2123_: type_32;
    var phi_2137_: type_19;
    var phi_2138_: type_19;
    var phi_2161_: type_19;
    var phi_2181_: f32;
    var phi_2311_: type_17;
    var phi_2314_: f32;
    var phi_2335_: bool;
    var phi_2341_: type_18;
    var phi_2312_: type_17;
    var phi_2355_: type_18;
    var phi_2315_: f32;
    var local_41: f32;
    var phi_2304_: f32;
    var phi_2368_: f32;
    var phi_2384_: f32;
    var phi_2391_: f32;
    var phi_2396_: f32;
    var phi_2403_: f32;
    var phi_2408_: f32;
    var phi_2421_: f32;
    var phi_2428_: f32;
    var phi_2433_: f32;
    var phi_2440_: f32;
    var phi_2445_: f32;
    var phi_2450_: f32;
    var phi_2467_: f32;
    var phi_2474_: f32;
    var phi_2479_: f32;
    var phi_2486_: f32;
    var phi_2491_: f32;
    var phi_2505_: f32;
    var phi_2512_: f32;
    var phi_2517_: f32;
    var phi_2524_: f32;
    var phi_2529_: f32;
    var phi_2534_: f32;
    var phi_2551_: f32;
    var phi_2558_: f32;
    var phi_2563_: f32;
    var phi_2570_: f32;
    var phi_2575_: f32;
    var phi_2589_: f32;
    var phi_2596_: f32;
    var phi_2601_: f32;
    var phi_2608_: f32;
    var phi_2613_: f32;
    var phi_2618_: f32;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var local_42: bool;
    var phi_2645_: type_32;
    var phi_2646_: bool;
    var phi_2651_: type_32;
    var phi_2652_: bool;
    var phi_2654_: type_32;
    var phi_2655_: type_32;
    var phi_2656_: bool;
    var phi_2660_: type_32;
    var phi_5477_: type_32;
    var phi_5478_: type_32;
    var phi_5491_: type_34;
    var phi_5498_: bool;
    var phi_5522_: u32;
    var phi_5526_: type_27;
    var phi_5527_: bool;
    var phi_5528_: bool;
    var phi_5546_: u32;
    var phi_5608_: u32;
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
    let _e111 = params.member.member_15;
    let _e113 = input.member[0u];
    if (_e111 < _e113) {
        phi_207_ = _e111;
    } else {
        phi_207_ = _e113;
    }
    let _e116 = phi_207_;
    let _e117 = (_e116 / 64u);
    if ((_e116 % 64u) > 0u) {
        phi_223_ = (_e117 + 1u);
    } else {
        phi_223_ = _e117;
    }
    let _e122 = phi_223_;
    if (_e122 > _e106) {
        let _e124 = (_e122 - _e106);
        if (_e109 == 0u) {
            return;
        }
        let _e126 = (_e124 / _e109);
        if (_e109 == 0u) {
            return;
        }
        if ((_e124 % _e109) > 0u) {
            phi_244_ = (_e126 + 1u);
        } else {
            phi_244_ = _e126;
        }
        let _e132 = phi_244_;
        phi_245_ = _e132;
    } else {
        phi_245_ = 0u;
    }
    let _e134 = phi_245_;
    phi_248_ = type_19(0u, _e134);
    loop {
        let _e137 = phi_248_;
        if (_e137.member < _e137.member_1) {
            phi_249_ = type_19((_e137.member + 1u), _e137.member_1);
            phi_272_ = type_19(1u, _e137.member);
        } else {
            phi_249_ = _e137;
            phi_272_ = type_19(0u, type_19().member_1);
        }
        let _e149 = phi_249_;
        let _e151 = phi_272_;
        let _e155 = (bitcast<i32>(_e151.member) != 0i);
        if _e155 {
            let _e159 = (((_e106 + (_e151.member_1 * _e109)) * 64u) + _e94);
            let _e161 = params.member.member_8;
            if (_e159 < _e116) {
                let _e164 = (2u * _e159);
                let _e167 = input.member[(4u + _e164)];
                let _e170 = input.member[(_e164 + 5u)];
                let _e172 = elements.member[_e167];
                let _e174 = elements.member[_e170];
                let _e180 = paths.member[_e172[0]];
                let _e182 = paths.member[_e172[1]];
                let _e188 = paths.member[_e174[0]];
                let _e190 = paths.member[_e174[1]];
                let _e220 = params.member.member_4;
                local_12 = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e188.member[0] - _e180.member[0]), (_e188.member[1] - _e180.member[1]), (_e188.member[2] - _e180.member[2])), array<f32, 3>((_e188.member_1[0] - _e180.member_1[0]), (_e188.member_1[1] - _e180.member_1[1]), (_e188.member_1[2] - _e180.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e182.member[0] - _e180.member[0]), (_e182.member[1] - _e180.member[1]), (_e182.member[2] - _e180.member[2])), array<f32, 3>((_e182.member_1[0] - _e180.member_1[0]), (_e182.member_1[1] - _e180.member_1[1]), (_e182.member_1[2] - _e180.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e188.member[0] - _e190.member[0]), (_e188.member[1] - _e190.member[1]), (_e188.member[2] - _e190.member[2])), array<f32, 3>((_e188.member_1[0] - _e190.member_1[0]), (_e188.member_1[1] - _e190.member_1[1]), (_e188.member_1[2] - _e190.member_1[2]))), (_e220 + _e220));
                let _e251 = params.member.member_5;
                let _e254 = local_12.member_1[0u];
                let _e260 = local_12.member_2[0u];
                let _e266 = ((_e254[1] * _e260[2]) - (_e254[2] * _e260[1]));
                let _e269 = ((_e254[2] * _e260[0]) - (_e254[0] * _e260[2]));
                let _e272 = ((_e254[0] * _e260[1]) - (_e254[1] * _e260[0]));
                let _e275 = local_12.member_1[1u];
                let _e281 = local_12.member_2[1u];
                let _e287 = ((_e275[1] * _e281[2]) - (_e275[2] * _e281[1]));
                let _e290 = ((_e275[2] * _e281[0]) - (_e275[0] * _e281[2]));
                let _e293 = ((_e275[0] * _e281[1]) - (_e275[1] * _e281[0]));
                let _e296 = local_12.member_1[0u];
                let _e302 = local_12.member_2[1u];
                let _e317 = local_12.member_1[1u];
                let _e323 = local_12.member_2[0u];
                let _e336 = (((_e296[1] * _e302[2]) - (_e296[2] * _e302[1])) + ((_e317[1] * _e323[2]) - (_e317[2] * _e323[1])));
                let _e337 = (((_e296[2] * _e302[0]) - (_e296[0] * _e302[2])) + ((_e317[2] * _e323[0]) - (_e317[0] * _e323[2])));
                let _e338 = (((_e296[0] * _e302[1]) - (_e296[1] * _e302[0])) + ((_e317[0] * _e323[1]) - (_e317[1] * _e323[0])));
                let _e341 = local_12.member[0u];
                let _e349 = (((_e341[0] * _e266) + (_e341[1] * _e269)) + (_e341[2] * _e272));
                let _e352 = local_12.member[1u];
                let _e363 = local_12.member[0u];
                let _e372 = ((((_e352[0] * _e266) + (_e352[1] * _e269)) + (_e352[2] * _e272)) + (((_e363[0] * _e336) + (_e363[1] * _e337)) + (_e363[2] * _e338)));
                let _e375 = local_12.member[0u];
                let _e386 = local_12.member[1u];
                let _e395 = ((((_e375[0] * _e287) + (_e375[1] * _e290)) + (_e375[2] * _e293)) + (((_e386[0] * _e336) + (_e386[1] * _e337)) + (_e386[2] * _e338)));
                let _e398 = local_12.member[1u];
                let _e406 = (((_e398[0] * _e287) + (_e398[1] * _e290)) + (_e398[2] * _e293));
                let _e409 = local_12.member[0u];
                if (_e409[0] < 0f) {
                    phi_722_ = -(_e409[0]);
                } else {
                    phi_722_ = _e409[0];
                }
                let _e416 = phi_722_;
                if (_e409[1] < 0f) {
                    phi_729_ = -(_e409[1]);
                } else {
                    phi_729_ = _e409[1];
                }
                let _e420 = phi_729_;
                if (_e416 > _e420) {
                    phi_734_ = _e416;
                } else {
                    phi_734_ = _e420;
                }
                let _e423 = phi_734_;
                if (_e409[2] < 0f) {
                    phi_741_ = -(_e409[2]);
                } else {
                    phi_741_ = _e409[2];
                }
                let _e427 = phi_741_;
                if (_e423 > _e427) {
                    phi_746_ = _e423;
                } else {
                    phi_746_ = _e427;
                }
                let _e430 = phi_746_;
                let _e433 = local_12.member[1u];
                if (_e433[0] < 0f) {
                    phi_759_ = -(_e433[0]);
                } else {
                    phi_759_ = _e433[0];
                }
                let _e440 = phi_759_;
                if (_e433[1] < 0f) {
                    phi_766_ = -(_e433[1]);
                } else {
                    phi_766_ = _e433[1];
                }
                let _e444 = phi_766_;
                if (_e440 > _e444) {
                    phi_771_ = _e440;
                } else {
                    phi_771_ = _e444;
                }
                let _e447 = phi_771_;
                if (_e433[2] < 0f) {
                    phi_778_ = -(_e433[2]);
                } else {
                    phi_778_ = _e433[2];
                }
                let _e451 = phi_778_;
                if (_e447 > _e451) {
                    phi_783_ = _e447;
                } else {
                    phi_783_ = _e451;
                }
                let _e454 = phi_783_;
                if (_e430 > _e454) {
                    phi_788_ = _e430;
                } else {
                    phi_788_ = _e454;
                }
                let _e457 = phi_788_;
                let _e459 = local_12.member_3;
                let _e460 = (_e457 + _e459);
                let _e463 = local_12.member_1[0u];
                if (_e463[0] < 0f) {
                    phi_805_ = -(_e463[0]);
                } else {
                    phi_805_ = _e463[0];
                }
                let _e470 = phi_805_;
                if (_e463[1] < 0f) {
                    phi_812_ = -(_e463[1]);
                } else {
                    phi_812_ = _e463[1];
                }
                let _e474 = phi_812_;
                if (_e470 > _e474) {
                    phi_817_ = _e470;
                } else {
                    phi_817_ = _e474;
                }
                let _e477 = phi_817_;
                if (_e463[2] < 0f) {
                    phi_824_ = -(_e463[2]);
                } else {
                    phi_824_ = _e463[2];
                }
                let _e481 = phi_824_;
                if (_e477 > _e481) {
                    phi_829_ = _e477;
                } else {
                    phi_829_ = _e481;
                }
                let _e484 = phi_829_;
                let _e487 = local_12.member_1[1u];
                if (_e487[0] < 0f) {
                    phi_843_ = -(_e487[0]);
                } else {
                    phi_843_ = _e487[0];
                }
                let _e494 = phi_843_;
                if (_e487[1] < 0f) {
                    phi_850_ = -(_e487[1]);
                } else {
                    phi_850_ = _e487[1];
                }
                let _e498 = phi_850_;
                if (_e494 > _e498) {
                    phi_855_ = _e494;
                } else {
                    phi_855_ = _e498;
                }
                let _e501 = phi_855_;
                if (_e487[2] < 0f) {
                    phi_862_ = -(_e487[2]);
                } else {
                    phi_862_ = _e487[2];
                }
                let _e505 = phi_862_;
                if (_e501 > _e505) {
                    phi_867_ = _e501;
                } else {
                    phi_867_ = _e505;
                }
                let _e508 = phi_867_;
                if (_e484 > _e508) {
                    phi_872_ = _e484;
                } else {
                    phi_872_ = _e508;
                }
                let _e511 = phi_872_;
                let _e513 = local_12.member_3;
                let _e514 = (_e511 + _e513);
                let _e517 = local_12.member_2[0u];
                if (_e517[0] < 0f) {
                    phi_889_ = -(_e517[0]);
                } else {
                    phi_889_ = _e517[0];
                }
                let _e524 = phi_889_;
                if (_e517[1] < 0f) {
                    phi_896_ = -(_e517[1]);
                } else {
                    phi_896_ = _e517[1];
                }
                let _e528 = phi_896_;
                if (_e524 > _e528) {
                    phi_901_ = _e524;
                } else {
                    phi_901_ = _e528;
                }
                let _e531 = phi_901_;
                if (_e517[2] < 0f) {
                    phi_908_ = -(_e517[2]);
                } else {
                    phi_908_ = _e517[2];
                }
                let _e535 = phi_908_;
                if (_e531 > _e535) {
                    phi_913_ = _e531;
                } else {
                    phi_913_ = _e535;
                }
                let _e538 = phi_913_;
                let _e541 = local_12.member_2[1u];
                if (_e541[0] < 0f) {
                    phi_927_ = -(_e541[0]);
                } else {
                    phi_927_ = _e541[0];
                }
                let _e548 = phi_927_;
                if (_e541[1] < 0f) {
                    phi_934_ = -(_e541[1]);
                } else {
                    phi_934_ = _e541[1];
                }
                let _e552 = phi_934_;
                if (_e548 > _e552) {
                    phi_939_ = _e548;
                } else {
                    phi_939_ = _e552;
                }
                let _e555 = phi_939_;
                if (_e541[2] < 0f) {
                    phi_946_ = -(_e541[2]);
                } else {
                    phi_946_ = _e541[2];
                }
                let _e559 = phi_946_;
                if (_e555 > _e559) {
                    phi_951_ = _e555;
                } else {
                    phi_951_ = _e559;
                }
                let _e562 = phi_951_;
                if (_e538 > _e562) {
                    phi_956_ = _e538;
                } else {
                    phi_956_ = _e562;
                }
                let _e565 = phi_956_;
                let _e567 = local_12.member_3;
                let _e568 = (_e565 + _e567);
                let _e570 = ((_e514 * 8f) * _e568);
                let _e577 = local_12.member_3;
                if (_e266 < 0f) {
                    phi_987_ = -(_e266);
                } else {
                    phi_987_ = _e266;
                }
                let _e594 = phi_987_;
                if (_e269 < 0f) {
                    phi_993_ = -(_e269);
                } else {
                    phi_993_ = _e269;
                }
                let _e598 = phi_993_;
                if (_e272 < 0f) {
                    phi_1000_ = -(_e272);
                } else {
                    phi_1000_ = _e272;
                }
                let _e603 = phi_1000_;
                let _e604 = ((_e594 + _e598) + _e603);
                if (_e287 < 0f) {
                    phi_1007_ = -(_e287);
                } else {
                    phi_1007_ = _e287;
                }
                let _e608 = phi_1007_;
                if (_e290 < 0f) {
                    phi_1013_ = -(_e290);
                } else {
                    phi_1013_ = _e290;
                }
                let _e612 = phi_1013_;
                if (_e293 < 0f) {
                    phi_1020_ = -(_e293);
                } else {
                    phi_1020_ = _e293;
                }
                let _e617 = phi_1020_;
                let _e618 = ((_e608 + _e612) + _e617);
                if (_e604 > _e618) {
                    phi_1026_ = _e604;
                } else {
                    phi_1026_ = _e618;
                }
                let _e621 = phi_1026_;
                if (_e336 < 0f) {
                    phi_1032_ = -(_e336);
                } else {
                    phi_1032_ = _e336;
                }
                let _e625 = phi_1032_;
                if (_e337 < 0f) {
                    phi_1038_ = -(_e337);
                } else {
                    phi_1038_ = _e337;
                }
                let _e629 = phi_1038_;
                if (_e338 < 0f) {
                    phi_1045_ = -(_e338);
                } else {
                    phi_1045_ = _e338;
                }
                let _e634 = phi_1045_;
                let _e636 = (((_e625 + _e629) + _e634) * 0.5f);
                if (_e621 > _e636) {
                    phi_1052_ = _e621;
                } else {
                    phi_1052_ = _e636;
                }
                let _e639 = phi_1052_;
                let _e644 = local_12.member_3;
                let _e656 = (((((_e460 * 8f) * _e570) * (0.000000059604645f * (490f / 64f))) + ((_e577 * 19f) * ((_e460 * (_e514 + _e568)) + (_e514 * _e568)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e460) * ((1f + _e514) * (1f + _e568)))));
                let _e657 = (_e349 * 3f);
                let _e658 = (_e406 * 3f);
                if (_e657 < _e658) {
                    phi_1076_ = _e657;
                } else {
                    phi_1076_ = _e658;
                }
                let _e661 = phi_1076_;
                if (_e372 < _e395) {
                    phi_1081_ = _e372;
                } else {
                    phi_1081_ = _e395;
                }
                let _e664 = phi_1081_;
                if (_e661 < _e664) {
                    phi_1086_ = _e661;
                } else {
                    phi_1086_ = _e664;
                }
                let _e667 = phi_1086_;
                if (_e657 > _e658) {
                    phi_1091_ = _e657;
                } else {
                    phi_1091_ = _e658;
                }
                let _e670 = phi_1091_;
                if (_e372 > _e395) {
                    phi_1096_ = _e372;
                } else {
                    phi_1096_ = _e395;
                }
                let _e673 = phi_1096_;
                if (_e670 > _e673) {
                    phi_1101_ = _e670;
                } else {
                    phi_1101_ = _e673;
                }
                let _e676 = phi_1101_;
                let _e681 = -(_e676);
                if (_e667 > _e681) {
                    phi_1111_ = _e667;
                } else {
                    phi_1111_ = _e681;
                }
                let _e684 = phi_1111_;
                if ((_e684 - (_e656 + ((_e251 * (((_e639 + (_e570 * (0.000000059604645f * 4f))) + ((_e644 * 6f) * (_e514 + _e568))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e514) * (1f + _e568))))) * (3f * 1.0001f)))) > 0f) {
                    phi_5478_ = type_32(0u, type_32().member_1);
                } else {
                    if (_e251 > 0f) {
                        let _e2719 = local_12.member[0u];
                        let _e2725 = local_12.member_1[0u];
                        let _e2731 = local_12.member_2[0u];
                        let _e2735 = (_e2719[0] - _e2725[0]);
                        let _e2736 = (_e2719[1] - _e2725[1]);
                        let _e2737 = (_e2719[2] - _e2725[2]);
                        local_9 = array<array<f32, 3>, 4>(_e2719, array<f32, 3>(_e2735, _e2736, _e2737), array<f32, 3>((_e2719[0] - _e2731[0]), (_e2719[1] - _e2731[1]), (_e2719[2] - _e2731[2])), array<f32, 3>((_e2735 - _e2731[0]), (_e2736 - _e2731[1]), (_e2737 - _e2731[2])));
                        let _e2750 = local_12.member[1u];
                        let _e2756 = local_12.member_1[1u];
                        let _e2762 = local_12.member_2[1u];
                        let _e2766 = (_e2750[0] - _e2756[0]);
                        let _e2767 = (_e2750[1] - _e2756[1]);
                        let _e2768 = (_e2750[2] - _e2756[2]);
                        local_10 = array<array<f32, 3>, 4>(_e2750, array<f32, 3>(_e2766, _e2767, _e2768), array<f32, 3>((_e2750[0] - _e2762[0]), (_e2750[1] - _e2762[1]), (_e2750[2] - _e2762[2])), array<f32, 3>((_e2766 - _e2762[0]), (_e2767 - _e2762[1]), (_e2768 - _e2762[2])));
                        let _e2781 = local_12.member[0u];
                        if (_e2781[0] < 0f) {
                            phi_1312_ = -(_e2781[0]);
                        } else {
                            phi_1312_ = _e2781[0];
                        }
                        let _e2788 = phi_1312_;
                        if (_e2781[1] < 0f) {
                            phi_1319_ = -(_e2781[1]);
                        } else {
                            phi_1319_ = _e2781[1];
                        }
                        let _e2792 = phi_1319_;
                        if (_e2788 > _e2792) {
                            phi_1324_ = _e2788;
                        } else {
                            phi_1324_ = _e2792;
                        }
                        let _e2795 = phi_1324_;
                        if (_e2781[2] < 0f) {
                            phi_1331_ = -(_e2781[2]);
                        } else {
                            phi_1331_ = _e2781[2];
                        }
                        let _e2799 = phi_1331_;
                        if (_e2795 > _e2799) {
                            phi_1336_ = _e2795;
                        } else {
                            phi_1336_ = _e2799;
                        }
                        let _e2802 = phi_1336_;
                        let _e2805 = local_12.member[1u];
                        if (_e2805[0] < 0f) {
                            phi_1349_ = -(_e2805[0]);
                        } else {
                            phi_1349_ = _e2805[0];
                        }
                        let _e2812 = phi_1349_;
                        if (_e2805[1] < 0f) {
                            phi_1356_ = -(_e2805[1]);
                        } else {
                            phi_1356_ = _e2805[1];
                        }
                        let _e2816 = phi_1356_;
                        if (_e2812 > _e2816) {
                            phi_1361_ = _e2812;
                        } else {
                            phi_1361_ = _e2816;
                        }
                        let _e2819 = phi_1361_;
                        if (_e2805[2] < 0f) {
                            phi_1368_ = -(_e2805[2]);
                        } else {
                            phi_1368_ = _e2805[2];
                        }
                        let _e2823 = phi_1368_;
                        if (_e2819 > _e2823) {
                            phi_1373_ = _e2819;
                        } else {
                            phi_1373_ = _e2823;
                        }
                        let _e2826 = phi_1373_;
                        if (_e2802 > _e2826) {
                            phi_1378_ = _e2802;
                        } else {
                            phi_1378_ = _e2826;
                        }
                        let _e2829 = phi_1378_;
                        let _e2831 = local_12.member_3;
                        let _e2835 = local_12.member_1[0u];
                        if (_e2835[0] < 0f) {
                            phi_1395_ = -(_e2835[0]);
                        } else {
                            phi_1395_ = _e2835[0];
                        }
                        let _e2842 = phi_1395_;
                        if (_e2835[1] < 0f) {
                            phi_1402_ = -(_e2835[1]);
                        } else {
                            phi_1402_ = _e2835[1];
                        }
                        let _e2846 = phi_1402_;
                        if (_e2842 > _e2846) {
                            phi_1407_ = _e2842;
                        } else {
                            phi_1407_ = _e2846;
                        }
                        let _e2849 = phi_1407_;
                        if (_e2835[2] < 0f) {
                            phi_1414_ = -(_e2835[2]);
                        } else {
                            phi_1414_ = _e2835[2];
                        }
                        let _e2853 = phi_1414_;
                        if (_e2849 > _e2853) {
                            phi_1419_ = _e2849;
                        } else {
                            phi_1419_ = _e2853;
                        }
                        let _e2856 = phi_1419_;
                        let _e2859 = local_12.member_1[1u];
                        if (_e2859[0] < 0f) {
                            phi_1433_ = -(_e2859[0]);
                        } else {
                            phi_1433_ = _e2859[0];
                        }
                        let _e2866 = phi_1433_;
                        if (_e2859[1] < 0f) {
                            phi_1440_ = -(_e2859[1]);
                        } else {
                            phi_1440_ = _e2859[1];
                        }
                        let _e2870 = phi_1440_;
                        if (_e2866 > _e2870) {
                            phi_1445_ = _e2866;
                        } else {
                            phi_1445_ = _e2870;
                        }
                        let _e2873 = phi_1445_;
                        if (_e2859[2] < 0f) {
                            phi_1452_ = -(_e2859[2]);
                        } else {
                            phi_1452_ = _e2859[2];
                        }
                        let _e2877 = phi_1452_;
                        if (_e2873 > _e2877) {
                            phi_1457_ = _e2873;
                        } else {
                            phi_1457_ = _e2877;
                        }
                        let _e2880 = phi_1457_;
                        if (_e2856 > _e2880) {
                            phi_1462_ = _e2856;
                        } else {
                            phi_1462_ = _e2880;
                        }
                        let _e2883 = phi_1462_;
                        let _e2885 = local_12.member_3;
                        let _e2889 = local_12.member_2[0u];
                        if (_e2889[0] < 0f) {
                            phi_1479_ = -(_e2889[0]);
                        } else {
                            phi_1479_ = _e2889[0];
                        }
                        let _e2896 = phi_1479_;
                        if (_e2889[1] < 0f) {
                            phi_1486_ = -(_e2889[1]);
                        } else {
                            phi_1486_ = _e2889[1];
                        }
                        let _e2900 = phi_1486_;
                        if (_e2896 > _e2900) {
                            phi_1491_ = _e2896;
                        } else {
                            phi_1491_ = _e2900;
                        }
                        let _e2903 = phi_1491_;
                        if (_e2889[2] < 0f) {
                            phi_1498_ = -(_e2889[2]);
                        } else {
                            phi_1498_ = _e2889[2];
                        }
                        let _e2907 = phi_1498_;
                        if (_e2903 > _e2907) {
                            phi_1503_ = _e2903;
                        } else {
                            phi_1503_ = _e2907;
                        }
                        let _e2910 = phi_1503_;
                        let _e2913 = local_12.member_2[1u];
                        if (_e2913[0] < 0f) {
                            phi_1517_ = -(_e2913[0]);
                        } else {
                            phi_1517_ = _e2913[0];
                        }
                        let _e2920 = phi_1517_;
                        if (_e2913[1] < 0f) {
                            phi_1524_ = -(_e2913[1]);
                        } else {
                            phi_1524_ = _e2913[1];
                        }
                        let _e2924 = phi_1524_;
                        if (_e2920 > _e2924) {
                            phi_1529_ = _e2920;
                        } else {
                            phi_1529_ = _e2924;
                        }
                        let _e2927 = phi_1529_;
                        if (_e2913[2] < 0f) {
                            phi_1536_ = -(_e2913[2]);
                        } else {
                            phi_1536_ = _e2913[2];
                        }
                        let _e2931 = phi_1536_;
                        if (_e2927 > _e2931) {
                            phi_1541_ = _e2927;
                        } else {
                            phi_1541_ = _e2931;
                        }
                        let _e2934 = phi_1541_;
                        if (_e2910 > _e2934) {
                            phi_1546_ = _e2910;
                        } else {
                            phi_1546_ = _e2934;
                        }
                        let _e2937 = phi_1546_;
                        let _e2939 = local_12.member_3;
                        let _e2946 = local_12.member_3;
                        phi_1562_ = type_19(0u, 48u);
                        phi_1565_ = 0f;
                        loop {
                            let _e2952 = phi_1562_;
                            let _e2954 = phi_1565_;
                            local_77 = _e2954;
                            local_37 = _e2954;
                            local_38 = _e2954;
                            local_39 = _e2954;
                            local_40 = _e2954;
                            if (_e2952.member < _e2952.member_1) {
                                phi_1563_ = type_19((_e2952.member + 1u), _e2952.member_1);
                                phi_1588_ = type_19(1u, _e2952.member);
                            } else {
                                phi_1563_ = _e2952;
                                phi_1588_ = type_19(0u, type_19().member_1);
                            }
                            let _e2966 = phi_1563_;
                            let _e2968 = phi_1588_;
                            if (bitcast<i32>(_e2968.member) != 0i) {
                                let _e2974 = local_12.member[0u];
                                let _e2980 = local_12.member[1u];
                                let _e2996 = local_12.member_1[0u];
                                let _e3002 = local_12.member_1[1u];
                                let _e3018 = local_12.member_2[0u];
                                let _e3024 = local_12.member_2[1u];
                                let _e3038 = function_2(array<f32, 3>((_e2974[0] + ((_e2980[0] - _e2974[0]) * _e2954)), (_e2974[1] + ((_e2980[1] - _e2974[1]) * _e2954)), (_e2974[2] + ((_e2980[2] - _e2974[2]) * _e2954))), array<f32, 3>((_e2996[0] + ((_e3002[0] - _e2996[0]) * _e2954)), (_e2996[1] + ((_e3002[1] - _e2996[1]) * _e2954)), (_e2996[2] + ((_e3002[2] - _e2996[2]) * _e2954))), array<f32, 3>((_e3018[0] + ((_e3024[0] - _e3018[0]) * _e2954)), (_e3018[1] + ((_e3024[1] - _e3018[1]) * _e2954)), (_e3018[2] + ((_e3024[2] - _e3018[2]) * _e2954))), 1u);
                                if (_e3038[0] < 0f) {
                                    phi_1699_ = -(_e3038[0]);
                                } else {
                                    phi_1699_ = _e3038[0];
                                }
                                let _e3043 = phi_1699_;
                                if (_e3038[1] < 0f) {
                                    phi_1706_ = -(_e3038[1]);
                                } else {
                                    phi_1706_ = _e3038[1];
                                }
                                let _e3048 = phi_1706_;
                                if (_e3038[2] < 0f) {
                                    phi_1714_ = -(_e3038[2]);
                                } else {
                                    phi_1714_ = _e3038[2];
                                }
                                let _e3054 = phi_1714_;
                                let _e3055 = ((_e3043 + _e3048) + _e3054);
                                if (_e3055 > 0f) {
                                    if ((bitcast<u32>(_e3055) & 2139095040u) != 2139095040u) {
                                        let _e3060 = (1f / _e3055);
                                        let _e3062 = (_e3038[0] * _e3060);
                                        let _e3064 = (_e3038[1] * _e3060);
                                        let _e3066 = (_e3038[2] * _e3060);
                                        let _e3071 = (((_e3062 * _e3062) + (_e3064 * _e3064)) + (_e3066 * _e3066));
                                        if (_e3071 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3071 > 0f) {
                                                phi_1751_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_1751_ = 0f;
                                            }
                                            let _e3124 = phi_1751_;
                                            phi_1815_ = _e3124;
                                        } else {
                                            phi_1758_ = type_17(0i, 5i);
                                            phi_1761_ = bitcast<f32>(((bitcast<u32>(_e3071) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3079 = phi_1758_;
                                                let _e3081 = phi_1761_;
                                                local_31 = _e3081;
                                                if (_e3079.member < _e3079.member_1) {
                                                    let _e3088 = (_e3079.member + 1i);
                                                    if ((false == (_e3088 > _e3079.member)) != false) {
                                                        phi_1782_ = true;
                                                    } else {
                                                        phi_1782_ = false;
                                                    }
                                                    let _e3093 = phi_1782_;
                                                    if _e3093 {
                                                        phi_1788_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_1788_ = type_18(1u, _e3088);
                                                    }
                                                    let _e3098 = phi_1788_;
                                                    phi_1759_ = type_17(_e3098.member_1, _e3079.member_1);
                                                    phi_1802_ = type_18(1u, _e3079.member);
                                                } else {
                                                    phi_1759_ = _e3079;
                                                    phi_1802_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3104 = phi_1759_;
                                                let _e3106 = phi_1802_;
                                                let _e3109 = (bitcast<i32>(_e3106.member) != 0i);
                                                if _e3109 {
                                                    phi_1762_ = (0.5f * (_e3081 + (_e3071 / _e3081)));
                                                } else {
                                                    phi_1762_ = f32();
                                                }
                                                let _e3114 = phi_1762_;
                                                continue;
                                                continuing {
                                                    phi_1758_ = _e3104;
                                                    phi_1761_ = _e3114;
                                                    break if !(_e3109);
                                                }
                                            }
                                            let _e3119 = local_31;
                                            phi_1815_ = (_e3119 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3126 = phi_1815_;
                                        phi_1824_ = type_19(0u, 4u);
                                        phi_1827_ = 2f;
                                        loop {
                                            let _e3134 = phi_1824_;
                                            let _e3136 = phi_1827_;
                                            local_33 = _e3136;
                                            local_34 = _e3136;
                                            local_35 = _e3136;
                                            local_67 = _e3136;
                                            local_68 = _e3136;
                                            if (_e3134.member < _e3134.member_1) {
                                                phi_1825_ = type_19((_e3134.member + 1u), _e3134.member_1);
                                                phi_1850_ = type_19(1u, _e3134.member);
                                            } else {
                                                phi_1825_ = _e3134;
                                                phi_1850_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e3148 = phi_1825_;
                                            let _e3150 = phi_1850_;
                                            if (bitcast<i32>(_e3150.member) != 0i) {
                                                let _e3156 = local_9[_e3150.member_1];
                                                let _e3164 = (((_e3062 * _e3156[0]) + (_e3064 * _e3156[1])) + (_e3066 * _e3156[2]));
                                                let _e3166 = local_10[_e3150.member_1];
                                                let _e3174 = (((_e3062 * _e3166[0]) + (_e3064 * _e3166[1])) + (_e3066 * _e3166[2]));
                                                if (_e3164 < 0f) {
                                                    phi_1901_ = -(_e3164);
                                                } else {
                                                    phi_1901_ = _e3164;
                                                }
                                                let _e3178 = phi_1901_;
                                                if (_e3174 < 0f) {
                                                    phi_1907_ = -(_e3174);
                                                } else {
                                                    phi_1907_ = _e3174;
                                                }
                                                let _e3182 = phi_1907_;
                                                let _e3186 = (((((((((_e2829 + _e2831) + (_e2883 + _e2885)) + (_e2937 + _e2939)) * (0.000000059604645f * 16f)) + (_e2946 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e251 * _e3126) * (1f + (0.000000059604645f * 8f)))) + ((_e3178 + _e3182) * (0.000000059604645f * 8f)));
                                                if (_e3164 > _e3186) {
                                                    if (_e3174 > _e3186) {
                                                        phi_1920_ = false;
                                                    } else {
                                                        phi_1920_ = true;
                                                    }
                                                    let _e3190 = phi_1920_;
                                                    phi_1921_ = _e3190;
                                                } else {
                                                    phi_1921_ = true;
                                                }
                                                let _e3192 = phi_1921_;
                                                if _e3192 {
                                                    if ((_e3164 + ((_e3174 - _e3164) * _e2954)) > _e3186) {
                                                        if (_e3174 < _e3164) {
                                                            let _e3200 = ((_e3164 - _e3174) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                            if _e3200 {
                                                                let _e3206 = (((_e3164 - _e3186) / (_e3164 - _e3174)) * (1f - (0.000000059604645f * 16f)));
                                                                if (_e3136 < _e3206) {
                                                                    phi_1952_ = _e3136;
                                                                } else {
                                                                    phi_1952_ = _e3206;
                                                                }
                                                                let _e3209 = phi_1952_;
                                                                phi_1953_ = _e3209;
                                                            } else {
                                                                phi_1953_ = f32();
                                                            }
                                                            let _e3211 = phi_1953_;
                                                            phi_1954_ = _e3211;
                                                            phi_1955_ = _e3200;
                                                        } else {
                                                            phi_1954_ = _e3136;
                                                            phi_1955_ = true;
                                                        }
                                                        let _e3213 = phi_1954_;
                                                        let _e3215 = phi_1955_;
                                                        if _e3215 {
                                                            phi_1959_ = false;
                                                        } else {
                                                            phi_1959_ = true;
                                                        }
                                                        let _e3217 = phi_1959_;
                                                        phi_1960_ = _e3213;
                                                        phi_1961_ = _e3215;
                                                        phi_1962_ = _e3217;
                                                        phi_1963_ = false;
                                                    } else {
                                                        phi_1960_ = f32();
                                                        phi_1961_ = false;
                                                        phi_1962_ = false;
                                                        phi_1963_ = true;
                                                    }
                                                    let _e3219 = phi_1960_;
                                                    let _e3221 = phi_1961_;
                                                    let _e3223 = phi_1962_;
                                                    let _e3225 = phi_1963_;
                                                    phi_1964_ = _e3219;
                                                    phi_1965_ = _e3221;
                                                    phi_1966_ = _e3223;
                                                    phi_1967_ = _e3225;
                                                } else {
                                                    phi_1964_ = _e3136;
                                                    phi_1965_ = true;
                                                    phi_1966_ = false;
                                                    phi_1967_ = false;
                                                }
                                                let _e3227 = phi_1964_;
                                                let _e3229 = phi_1965_;
                                                let _e3231 = phi_1966_;
                                                let _e3233 = phi_1967_;
                                                phi_1828_ = _e3227;
                                                phi_1968_ = _e3229;
                                                phi_1969_ = false;
                                                phi_1970_ = _e3231;
                                                phi_1971_ = _e3233;
                                            } else {
                                                phi_1828_ = f32();
                                                phi_1968_ = false;
                                                phi_1969_ = true;
                                                phi_1970_ = false;
                                                phi_1971_ = false;
                                            }
                                            let _e3235 = phi_1828_;
                                            let _e3237 = phi_1968_;
                                            let _e3239 = phi_1969_;
                                            let _e3241 = phi_1970_;
                                            let _e3243 = phi_1971_;
                                            local_32 = _e3239;
                                            local_65 = _e3241;
                                            local_66 = _e3243;
                                            continue;
                                            continuing {
                                                phi_1824_ = _e3148;
                                                phi_1827_ = _e3235;
                                                break if !(_e3237);
                                            }
                                        }
                                        let _e3246 = local_32;
                                        if _e3246 {
                                            let _e3248 = local_33;
                                            let _e3249 = (_e3248 > 1f);
                                            if _e3249 {
                                                phi_1992_ = false;
                                                phi_1993_ = false;
                                                phi_1994_ = false;
                                            } else {
                                                let _e3251 = local_34;
                                                if (_e3251 > _e2954) {
                                                    let _e3254 = local_35;
                                                    let _e3256 = ((_e3254 - _e2954) < 0.00000000023283064f);
                                                    if _e3256 {
                                                        phi_1988_ = false;
                                                    } else {
                                                        phi_1988_ = true;
                                                    }
                                                    let _e3258 = phi_1988_;
                                                    phi_1989_ = _e3258;
                                                    phi_1990_ = _e3256;
                                                    phi_1991_ = false;
                                                } else {
                                                    phi_1989_ = false;
                                                    phi_1990_ = false;
                                                    phi_1991_ = true;
                                                }
                                                let _e3260 = phi_1989_;
                                                let _e3262 = phi_1990_;
                                                let _e3264 = phi_1991_;
                                                phi_1992_ = _e3260;
                                                phi_1993_ = _e3262;
                                                phi_1994_ = _e3264;
                                            }
                                            let _e3266 = phi_1992_;
                                            let _e3268 = phi_1993_;
                                            let _e3270 = phi_1994_;
                                            phi_1995_ = _e3266;
                                            phi_1996_ = _e3249;
                                            phi_1997_ = _e3268;
                                            phi_1998_ = _e3270;
                                            phi_1999_ = false;
                                            phi_2000_ = false;
                                        } else {
                                            phi_1995_ = false;
                                            phi_1996_ = false;
                                            phi_1997_ = false;
                                            phi_1998_ = false;
                                            let _e4567 = local_65;
                                            phi_1999_ = _e4567;
                                            let _e4570 = local_66;
                                            phi_2000_ = _e4570;
                                        }
                                        let _e3272 = phi_1995_;
                                        let _e3274 = phi_1996_;
                                        let _e3276 = phi_1997_;
                                        let _e3278 = phi_1998_;
                                        let _e3280 = phi_1999_;
                                        let _e3282 = phi_2000_;
                                        let _e4573 = local_67;
                                        phi_2001_ = _e4573;
                                        let _e4576 = local_68;
                                        phi_2002_ = _e4576;
                                        phi_2003_ = _e3272;
                                        phi_2004_ = _e3274;
                                        phi_2005_ = _e3276;
                                        phi_2006_ = _e3278;
                                        phi_2007_ = _e3280;
                                        phi_2008_ = _e3282;
                                        phi_2009_ = false;
                                    } else {
                                        phi_2001_ = f32();
                                        phi_2002_ = f32();
                                        phi_2003_ = false;
                                        phi_2004_ = false;
                                        phi_2005_ = false;
                                        phi_2006_ = false;
                                        phi_2007_ = false;
                                        phi_2008_ = false;
                                        phi_2009_ = true;
                                    }
                                    let _e3284 = phi_2001_;
                                    let _e3286 = phi_2002_;
                                    let _e3288 = phi_2003_;
                                    let _e3290 = phi_2004_;
                                    let _e3292 = phi_2005_;
                                    let _e3294 = phi_2006_;
                                    let _e3296 = phi_2007_;
                                    let _e3298 = phi_2008_;
                                    let _e3300 = phi_2009_;
                                    phi_2010_ = _e3284;
                                    phi_2011_ = _e3286;
                                    phi_2012_ = _e3288;
                                    phi_2013_ = _e3290;
                                    phi_2014_ = _e3292;
                                    phi_2015_ = _e3294;
                                    phi_2016_ = _e3296;
                                    phi_2017_ = _e3298;
                                    phi_2018_ = _e3300;
                                    phi_2019_ = false;
                                } else {
                                    phi_2010_ = f32();
                                    phi_2011_ = f32();
                                    phi_2012_ = false;
                                    phi_2013_ = false;
                                    phi_2014_ = false;
                                    phi_2015_ = false;
                                    phi_2016_ = false;
                                    phi_2017_ = false;
                                    phi_2018_ = false;
                                    phi_2019_ = true;
                                }
                                let _e3302 = phi_2010_;
                                let _e3304 = phi_2011_;
                                let _e3306 = phi_2012_;
                                let _e3308 = phi_2013_;
                                let _e3310 = phi_2014_;
                                let _e3312 = phi_2015_;
                                let _e3314 = phi_2016_;
                                let _e3316 = phi_2017_;
                                let _e3318 = phi_2018_;
                                let _e3320 = phi_2019_;
                                phi_2020_ = _e3302;
                                phi_1566_ = _e3304;
                                phi_2021_ = _e3306;
                                phi_2022_ = _e3308;
                                phi_2023_ = _e3310;
                                phi_2024_ = false;
                                phi_2025_ = _e3312;
                                phi_2026_ = _e3314;
                                phi_2027_ = _e3316;
                                phi_2028_ = _e3318;
                                phi_2029_ = _e3320;
                            } else {
                                phi_2020_ = f32();
                                phi_1566_ = f32();
                                phi_2021_ = false;
                                phi_2022_ = false;
                                phi_2023_ = false;
                                phi_2024_ = true;
                                phi_2025_ = false;
                                phi_2026_ = false;
                                phi_2027_ = false;
                                phi_2028_ = false;
                                phi_2029_ = false;
                            }
                            let _e3322 = phi_2020_;
                            let _e3324 = phi_1566_;
                            let _e3326 = phi_2021_;
                            let _e3328 = phi_2022_;
                            let _e3330 = phi_2023_;
                            let _e3332 = phi_2024_;
                            let _e3334 = phi_2025_;
                            let _e3336 = phi_2026_;
                            let _e3338 = phi_2027_;
                            let _e3340 = phi_2028_;
                            let _e3342 = phi_2029_;
                            local_36 = _e3328;
                            local_69 = _e3330;
                            local_70 = _e3332;
                            local_71 = _e3334;
                            local_72 = _e3336;
                            local_73 = _e3338;
                            local_74 = _e3340;
                            local_75 = _e3342;
                            local_76 = _e3322;
                            local_78 = _e3328;
                            continue;
                            continuing {
                                phi_1562_ = _e2966;
                                phi_1565_ = _e3324;
                                break if !(_e3326);
                            }
                        }
                        let _e3345 = local_36;
                        if _e3345 {
                            phi_2034_ = type_32(0u, type_32().member_1);
                            phi_2035_ = false;
                            phi_2036_ = false;
                            phi_2037_ = false;
                            phi_2038_ = false;
                            phi_2039_ = false;
                            phi_2040_ = false;
                            phi_2041_ = false;
                        } else {
                            phi_2034_ = type_32();
                            let _e4609 = local_69;
                            phi_2035_ = _e4609;
                            let _e4612 = local_70;
                            phi_2036_ = _e4612;
                            let _e4615 = local_71;
                            phi_2037_ = _e4615;
                            let _e4618 = local_72;
                            phi_2038_ = _e4618;
                            let _e4621 = local_73;
                            phi_2039_ = _e4621;
                            let _e4624 = local_74;
                            phi_2040_ = _e4624;
                            let _e4627 = local_75;
                            phi_2041_ = _e4627;
                        }
                        let _e3349 = phi_2034_;
                        let _e3351 = phi_2035_;
                        let _e3353 = phi_2036_;
                        let _e3355 = phi_2037_;
                        let _e3357 = phi_2038_;
                        let _e3359 = phi_2039_;
                        let _e3361 = phi_2040_;
                        let _e3363 = phi_2041_;
                        if _e3351 {
                            let _e4630 = local_76;
                            phi_2045_ = _e4630;
                            phi_2046_ = true;
                            phi_2047_ = false;
                            phi_2048_ = false;
                            phi_2049_ = false;
                            phi_2050_ = false;
                            phi_2051_ = false;
                            phi_2052_ = false;
                        } else {
                            let _e4632 = local_77;
                            phi_2045_ = _e4632;
                            phi_2046_ = _e3353;
                            phi_2047_ = _e3355;
                            phi_2048_ = _e3357;
                            phi_2049_ = _e3359;
                            let _e4639 = local_78;
                            phi_2050_ = _e4639;
                            phi_2051_ = _e3361;
                            phi_2052_ = _e3363;
                        }
                        let _e3365 = phi_2045_;
                        let _e3367 = phi_2046_;
                        let _e3369 = phi_2047_;
                        let _e3371 = phi_2048_;
                        let _e3373 = phi_2049_;
                        let _e3375 = phi_2050_;
                        let _e3377 = phi_2051_;
                        let _e3379 = phi_2052_;
                        if _e3367 {
                            phi_2057_ = type_32(1u, _e3365);
                            phi_2058_ = false;
                            phi_2059_ = false;
                            phi_2060_ = false;
                            phi_2061_ = false;
                            phi_2062_ = false;
                            phi_2063_ = false;
                        } else {
                            phi_2057_ = type_32();
                            phi_2058_ = _e3369;
                            phi_2059_ = _e3371;
                            phi_2060_ = _e3373;
                            phi_2061_ = _e3375;
                            phi_2062_ = _e3377;
                            phi_2063_ = _e3379;
                        }
                        let _e3382 = phi_2057_;
                        let _e3384 = phi_2058_;
                        let _e3386 = phi_2059_;
                        let _e3388 = phi_2060_;
                        let _e3390 = phi_2061_;
                        let _e3392 = phi_2062_;
                        let _e3394 = phi_2063_;
                        if _e3384 {
                            let _e3396 = local_37;
                            phi_2068_ = type_32(1u, _e3396);
                            phi_2069_ = false;
                            phi_2070_ = false;
                            phi_2071_ = true;
                            phi_2072_ = false;
                            phi_2073_ = false;
                        } else {
                            phi_2068_ = _e3349;
                            phi_2069_ = _e3386;
                            phi_2070_ = _e3388;
                            phi_2071_ = _e3390;
                            phi_2072_ = _e3392;
                            phi_2073_ = _e3394;
                        }
                        let _e3399 = phi_2068_;
                        let _e3401 = phi_2069_;
                        let _e3403 = phi_2070_;
                        let _e3405 = phi_2071_;
                        let _e3407 = phi_2072_;
                        let _e3409 = phi_2073_;
                        if _e3401 {
                            let _e3411 = local_38;
                            phi_2078_ = type_32(1u, _e3411);
                            phi_2079_ = false;
                            phi_2080_ = false;
                            phi_2081_ = false;
                            phi_2082_ = false;
                        } else {
                            phi_2078_ = type_32();
                            phi_2079_ = _e3403;
                            phi_2080_ = _e3405;
                            phi_2081_ = _e3407;
                            phi_2082_ = _e3409;
                        }
                        let _e3414 = phi_2078_;
                        let _e3416 = phi_2079_;
                        let _e3418 = phi_2080_;
                        let _e3420 = phi_2081_;
                        let _e3422 = phi_2082_;
                        if _e3416 {
                            let _e3424 = local_39;
                            phi_2087_ = type_32(1u, _e3424);
                            phi_2088_ = true;
                            phi_2089_ = false;
                            phi_2090_ = false;
                            phi_2091_ = false;
                        } else {
                            phi_2087_ = _e3414;
                            phi_2088_ = _e3401;
                            phi_2089_ = _e3418;
                            phi_2090_ = _e3420;
                            phi_2091_ = _e3422;
                        }
                        let _e3427 = phi_2087_;
                        let _e3429 = phi_2088_;
                        let _e3431 = phi_2089_;
                        let _e3433 = phi_2090_;
                        let _e3435 = phi_2091_;
                        if _e3429 {
                            phi_2095_ = _e3427;
                            phi_2096_ = true;
                            phi_2097_ = false;
                            phi_2098_ = false;
                        } else {
                            phi_2095_ = _e3399;
                            phi_2096_ = _e3431;
                            phi_2097_ = _e3433;
                            phi_2098_ = _e3435;
                        }
                        let _e3437 = phi_2095_;
                        let _e3439 = phi_2096_;
                        let _e3441 = phi_2097_;
                        let _e3443 = phi_2098_;
                        if _e3439 {
                            phi_2102_ = false;
                            phi_2103_ = false;
                        } else {
                            phi_2102_ = _e3441;
                            phi_2103_ = _e3443;
                        }
                        let _e3445 = phi_2102_;
                        let _e3447 = phi_2103_;
                        if _e3445 {
                            phi_2107_ = false;
                            phi_2108_ = false;
                        } else {
                            phi_2107_ = _e3447;
                            phi_2108_ = _e3439;
                        }
                        let _e3449 = phi_2107_;
                        let _e3451 = phi_2108_;
                        if _e3449 {
                            phi_2112_ = true;
                            phi_2113_ = false;
                        } else {
                            phi_2112_ = _e3445;
                            phi_2113_ = _e3451;
                        }
                        let _e3453 = phi_2112_;
                        let _e3455 = phi_2113_;
                        if _e3453 {
                            let _e3457 = local_40;
                            phi_2118_ = type_32(1u, _e3457);
                            phi_2119_ = true;
                        } else {
                            phi_2118_ = _e3437;
                            phi_2119_ = _e3455;
                        }
                        let _e3460 = phi_2118_;
                        let _e3462 = phi_2119_;
                        if _e3462 {
                            phi_2123_ = _e3460;
                        } else {
                            phi_2123_ = _e3382;
                        }
                        let _e3464 = phi_2123_;
                        if (_e3464.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_2137_ = type_19(0u, 3u);
                            loop {
                                let _e3476 = phi_2137_;
                                if (_e3476.member < _e3476.member_1) {
                                    phi_2138_ = type_19((_e3476.member + 1u), _e3476.member_1);
                                    phi_2161_ = type_19(1u, _e3476.member);
                                } else {
                                    phi_2138_ = _e3476;
                                    phi_2161_ = type_19(0u, type_19().member_1);
                                }
                                let _e3488 = phi_2138_;
                                let _e3490 = phi_2161_;
                                if (bitcast<i32>(_e3490.member) != 0i) {
                                    let _e3496 = local_11[_e3490.member_1];
                                    let _e3497 = (_e3464.member_1 + _e3496);
                                    if (_e3497 < 1f) {
                                        phi_2181_ = _e3497;
                                    } else {
                                        phi_2181_ = 1f;
                                    }
                                    let _e3500 = phi_2181_;
                                    let _e3503 = local_12.member[0u];
                                    let _e3509 = local_12.member[1u];
                                    let _e3525 = local_12.member_1[0u];
                                    let _e3531 = local_12.member_1[1u];
                                    let _e3547 = local_12.member_2[0u];
                                    let _e3553 = local_12.member_2[1u];
                                    let _e3567 = function_2(array<f32, 3>((_e3503[0] + ((_e3509[0] - _e3503[0]) * _e3500)), (_e3503[1] + ((_e3509[1] - _e3503[1]) * _e3500)), (_e3503[2] + ((_e3509[2] - _e3503[2]) * _e3500))), array<f32, 3>((_e3525[0] + ((_e3531[0] - _e3525[0]) * _e3500)), (_e3525[1] + ((_e3531[1] - _e3525[1]) * _e3500)), (_e3525[2] + ((_e3531[2] - _e3525[2]) * _e3500))), array<f32, 3>((_e3547[0] + ((_e3553[0] - _e3547[0]) * _e3500)), (_e3547[1] + ((_e3553[1] - _e3547[1]) * _e3500)), (_e3547[2] + ((_e3553[2] - _e3547[2]) * _e3500))), 1u);
                                    let _e3578 = (((_e3567[0] * _e3567[0]) + (_e3567[1] * _e3567[1])) + (_e3567[2] * _e3567[2]));
                                    if (_e3578 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e3578 > 0f) {
                                            phi_2304_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_2304_ = 0f;
                                        }
                                        let _e3631 = phi_2304_;
                                        phi_2368_ = _e3631;
                                    } else {
                                        phi_2311_ = type_17(0i, 5i);
                                        phi_2314_ = bitcast<f32>(((bitcast<u32>(_e3578) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e3586 = phi_2311_;
                                            let _e3588 = phi_2314_;
                                            local_41 = _e3588;
                                            if (_e3586.member < _e3586.member_1) {
                                                let _e3595 = (_e3586.member + 1i);
                                                if ((false == (_e3595 > _e3586.member)) != false) {
                                                    phi_2335_ = true;
                                                } else {
                                                    phi_2335_ = false;
                                                }
                                                let _e3600 = phi_2335_;
                                                if _e3600 {
                                                    phi_2341_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_2341_ = type_18(1u, _e3595);
                                                }
                                                let _e3605 = phi_2341_;
                                                phi_2312_ = type_17(_e3605.member_1, _e3586.member_1);
                                                phi_2355_ = type_18(1u, _e3586.member);
                                            } else {
                                                phi_2312_ = _e3586;
                                                phi_2355_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e3611 = phi_2312_;
                                            let _e3613 = phi_2355_;
                                            let _e3616 = (bitcast<i32>(_e3613.member) != 0i);
                                            if _e3616 {
                                                phi_2315_ = (0.5f * (_e3588 + (_e3578 / _e3588)));
                                            } else {
                                                phi_2315_ = f32();
                                            }
                                            let _e3621 = phi_2315_;
                                            continue;
                                            continuing {
                                                phi_2311_ = _e3611;
                                                phi_2314_ = _e3621;
                                                break if !(_e3616);
                                            }
                                        }
                                        let _e3626 = local_41;
                                        phi_2368_ = (_e3626 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e3633 = phi_2368_;
                                    let _e3639 = local_12.member[0u];
                                    if (_e3639[0] < 0f) {
                                        phi_2384_ = -(_e3639[0]);
                                    } else {
                                        phi_2384_ = _e3639[0];
                                    }
                                    let _e3646 = phi_2384_;
                                    if (_e3639[1] < 0f) {
                                        phi_2391_ = -(_e3639[1]);
                                    } else {
                                        phi_2391_ = _e3639[1];
                                    }
                                    let _e3650 = phi_2391_;
                                    if (_e3646 > _e3650) {
                                        phi_2396_ = _e3646;
                                    } else {
                                        phi_2396_ = _e3650;
                                    }
                                    let _e3653 = phi_2396_;
                                    if (_e3639[2] < 0f) {
                                        phi_2403_ = -(_e3639[2]);
                                    } else {
                                        phi_2403_ = _e3639[2];
                                    }
                                    let _e3657 = phi_2403_;
                                    if (_e3653 > _e3657) {
                                        phi_2408_ = _e3653;
                                    } else {
                                        phi_2408_ = _e3657;
                                    }
                                    let _e3660 = phi_2408_;
                                    let _e3663 = local_12.member[1u];
                                    if (_e3663[0] < 0f) {
                                        phi_2421_ = -(_e3663[0]);
                                    } else {
                                        phi_2421_ = _e3663[0];
                                    }
                                    let _e3670 = phi_2421_;
                                    if (_e3663[1] < 0f) {
                                        phi_2428_ = -(_e3663[1]);
                                    } else {
                                        phi_2428_ = _e3663[1];
                                    }
                                    let _e3674 = phi_2428_;
                                    if (_e3670 > _e3674) {
                                        phi_2433_ = _e3670;
                                    } else {
                                        phi_2433_ = _e3674;
                                    }
                                    let _e3677 = phi_2433_;
                                    if (_e3663[2] < 0f) {
                                        phi_2440_ = -(_e3663[2]);
                                    } else {
                                        phi_2440_ = _e3663[2];
                                    }
                                    let _e3681 = phi_2440_;
                                    if (_e3677 > _e3681) {
                                        phi_2445_ = _e3677;
                                    } else {
                                        phi_2445_ = _e3681;
                                    }
                                    let _e3684 = phi_2445_;
                                    if (_e3660 > _e3684) {
                                        phi_2450_ = _e3660;
                                    } else {
                                        phi_2450_ = _e3684;
                                    }
                                    let _e3687 = phi_2450_;
                                    let _e3689 = local_12.member_3;
                                    let _e3693 = local_12.member_1[0u];
                                    if (_e3693[0] < 0f) {
                                        phi_2467_ = -(_e3693[0]);
                                    } else {
                                        phi_2467_ = _e3693[0];
                                    }
                                    let _e3700 = phi_2467_;
                                    if (_e3693[1] < 0f) {
                                        phi_2474_ = -(_e3693[1]);
                                    } else {
                                        phi_2474_ = _e3693[1];
                                    }
                                    let _e3704 = phi_2474_;
                                    if (_e3700 > _e3704) {
                                        phi_2479_ = _e3700;
                                    } else {
                                        phi_2479_ = _e3704;
                                    }
                                    let _e3707 = phi_2479_;
                                    if (_e3693[2] < 0f) {
                                        phi_2486_ = -(_e3693[2]);
                                    } else {
                                        phi_2486_ = _e3693[2];
                                    }
                                    let _e3711 = phi_2486_;
                                    if (_e3707 > _e3711) {
                                        phi_2491_ = _e3707;
                                    } else {
                                        phi_2491_ = _e3711;
                                    }
                                    let _e3714 = phi_2491_;
                                    let _e3717 = local_12.member_1[1u];
                                    if (_e3717[0] < 0f) {
                                        phi_2505_ = -(_e3717[0]);
                                    } else {
                                        phi_2505_ = _e3717[0];
                                    }
                                    let _e3724 = phi_2505_;
                                    if (_e3717[1] < 0f) {
                                        phi_2512_ = -(_e3717[1]);
                                    } else {
                                        phi_2512_ = _e3717[1];
                                    }
                                    let _e3728 = phi_2512_;
                                    if (_e3724 > _e3728) {
                                        phi_2517_ = _e3724;
                                    } else {
                                        phi_2517_ = _e3728;
                                    }
                                    let _e3731 = phi_2517_;
                                    if (_e3717[2] < 0f) {
                                        phi_2524_ = -(_e3717[2]);
                                    } else {
                                        phi_2524_ = _e3717[2];
                                    }
                                    let _e3735 = phi_2524_;
                                    if (_e3731 > _e3735) {
                                        phi_2529_ = _e3731;
                                    } else {
                                        phi_2529_ = _e3735;
                                    }
                                    let _e3738 = phi_2529_;
                                    if (_e3714 > _e3738) {
                                        phi_2534_ = _e3714;
                                    } else {
                                        phi_2534_ = _e3738;
                                    }
                                    let _e3741 = phi_2534_;
                                    let _e3743 = local_12.member_3;
                                    let _e3747 = local_12.member_2[0u];
                                    if (_e3747[0] < 0f) {
                                        phi_2551_ = -(_e3747[0]);
                                    } else {
                                        phi_2551_ = _e3747[0];
                                    }
                                    let _e3754 = phi_2551_;
                                    if (_e3747[1] < 0f) {
                                        phi_2558_ = -(_e3747[1]);
                                    } else {
                                        phi_2558_ = _e3747[1];
                                    }
                                    let _e3758 = phi_2558_;
                                    if (_e3754 > _e3758) {
                                        phi_2563_ = _e3754;
                                    } else {
                                        phi_2563_ = _e3758;
                                    }
                                    let _e3761 = phi_2563_;
                                    if (_e3747[2] < 0f) {
                                        phi_2570_ = -(_e3747[2]);
                                    } else {
                                        phi_2570_ = _e3747[2];
                                    }
                                    let _e3765 = phi_2570_;
                                    if (_e3761 > _e3765) {
                                        phi_2575_ = _e3761;
                                    } else {
                                        phi_2575_ = _e3765;
                                    }
                                    let _e3768 = phi_2575_;
                                    let _e3771 = local_12.member_2[1u];
                                    if (_e3771[0] < 0f) {
                                        phi_2589_ = -(_e3771[0]);
                                    } else {
                                        phi_2589_ = _e3771[0];
                                    }
                                    let _e3778 = phi_2589_;
                                    if (_e3771[1] < 0f) {
                                        phi_2596_ = -(_e3771[1]);
                                    } else {
                                        phi_2596_ = _e3771[1];
                                    }
                                    let _e3782 = phi_2596_;
                                    if (_e3778 > _e3782) {
                                        phi_2601_ = _e3778;
                                    } else {
                                        phi_2601_ = _e3782;
                                    }
                                    let _e3785 = phi_2601_;
                                    if (_e3771[2] < 0f) {
                                        phi_2608_ = -(_e3771[2]);
                                    } else {
                                        phi_2608_ = _e3771[2];
                                    }
                                    let _e3789 = phi_2608_;
                                    if (_e3785 > _e3789) {
                                        phi_2613_ = _e3785;
                                    } else {
                                        phi_2613_ = _e3789;
                                    }
                                    let _e3792 = phi_2613_;
                                    if (_e3768 > _e3792) {
                                        phi_2618_ = _e3768;
                                    } else {
                                        phi_2618_ = _e3792;
                                    }
                                    let _e3795 = phi_2618_;
                                    let _e3797 = local_12.member_3;
                                    let _e3804 = local_12.member_3;
                                    let _e3811 = (((_e3633 * (1f + (0.000000059604645f * 8f))) + (((((((_e3687 + _e3689) + (_e3741 + _e3743)) + (_e3795 + _e3797)) * (0.000000059604645f * 16f)) + (_e3804 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e251);
                                    if _e3811 {
                                        phi_2638_ = false;
                                    } else {
                                        phi_2638_ = true;
                                    }
                                    let _e3813 = phi_2638_;
                                    phi_2639_ = _e3813;
                                    phi_2640_ = _e3811;
                                } else {
                                    phi_2639_ = false;
                                    phi_2640_ = false;
                                }
                                let _e3815 = phi_2639_;
                                let _e3817 = phi_2640_;
                                local_42 = _e3817;
                                continue;
                                continuing {
                                    phi_2137_ = _e3488;
                                    break if !(_e3815);
                                }
                            }
                            let _e3820 = local_42;
                            if _e3820 {
                                phi_2645_ = type_32(1u, _e3464.member_1);
                                phi_2646_ = false;
                            } else {
                                phi_2645_ = type_32();
                                phi_2646_ = true;
                            }
                            let _e3823 = phi_2645_;
                            let _e3825 = phi_2646_;
                            if _e3825 {
                                phi_2651_ = type_32(2u, _e3464.member_1);
                                phi_2652_ = false;
                            } else {
                                phi_2651_ = type_32();
                                phi_2652_ = true;
                            }
                            let _e3828 = phi_2651_;
                            let _e3830 = phi_2652_;
                            phi_2654_ = _e3828;
                            phi_2655_ = _e3823;
                            phi_2656_ = _e3830;
                        } else {
                            phi_2654_ = type_32();
                            phi_2655_ = type_32(0u, type_32().member_1);
                            phi_2656_ = true;
                        }
                        let _e3832 = phi_2654_;
                        let _e3834 = phi_2655_;
                        let _e3836 = phi_2656_;
                        if _e3836 {
                            phi_2660_ = _e3834;
                        } else {
                            phi_2660_ = _e3832;
                        }
                        let _e3838 = phi_2660_;
                        phi_5477_ = _e3838;
                    } else {
                        if (_e349 < 0f) {
                            phi_2670_ = -(_e349);
                        } else {
                            phi_2670_ = _e349;
                        }
                        let _e692 = phi_2670_;
                        if (_e372 < 0f) {
                            phi_2676_ = -(_e372);
                        } else {
                            phi_2676_ = _e372;
                        }
                        let _e696 = phi_2676_;
                        if (_e692 > _e696) {
                            phi_2681_ = _e692;
                        } else {
                            phi_2681_ = _e696;
                        }
                        let _e699 = phi_2681_;
                        if (_e395 < 0f) {
                            phi_2687_ = -(_e395);
                        } else {
                            phi_2687_ = _e395;
                        }
                        let _e703 = phi_2687_;
                        if (_e406 < 0f) {
                            phi_2693_ = -(_e406);
                        } else {
                            phi_2693_ = _e406;
                        }
                        let _e707 = phi_2693_;
                        if (_e703 > _e707) {
                            phi_2698_ = _e703;
                        } else {
                            phi_2698_ = _e707;
                        }
                        let _e710 = phi_2698_;
                        if (_e699 > _e710) {
                            phi_2703_ = _e699;
                        } else {
                            phi_2703_ = _e710;
                        }
                        let _e713 = phi_2703_;
                        let _e714 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e713 >= _e714) {
                            phi_2711_ = (_e713 <= (1f / _e714));
                        } else {
                            phi_2711_ = false;
                        }
                        let _e719 = phi_2711_;
                        if _e719 {
                            phi_2716_ = (0.000000059604645f * 256f);
                        } else {
                            phi_2716_ = 2f;
                        }
                        let _e722 = phi_2716_;
                        let _e724 = ((_e656 * 0.34f) + (_e713 * _e722));
                        if _e719 {
                            phi_2723_ = (1f / _e713);
                        } else {
                            phi_2723_ = 0f;
                        }
                        let _e727 = phi_2723_;
                        let _e733 = ((_e372 - (3f * _e349)) * _e727);
                        let _e734 = ((_e395 - _e372) * _e727);
                        let _e735 = (((3f * _e406) - _e395) * _e727);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e742 = ((_e734 * _e734) - (_e733 * _e735));
                        if (_e742 > 0f) {
                            if (_e742 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e742 > 0f) {
                                    phi_2756_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_2756_ = 0f;
                                }
                                let _e796 = phi_2756_;
                                phi_2820_ = _e796;
                            } else {
                                phi_2763_ = type_17(0i, 5i);
                                phi_2766_ = bitcast<f32>(((bitcast<u32>(_e742) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e751 = phi_2763_;
                                    let _e753 = phi_2766_;
                                    local_13 = _e753;
                                    if (_e751.member < _e751.member_1) {
                                        let _e760 = (_e751.member + 1i);
                                        if ((false == (_e760 > _e751.member)) != false) {
                                            phi_2787_ = true;
                                        } else {
                                            phi_2787_ = false;
                                        }
                                        let _e765 = phi_2787_;
                                        if _e765 {
                                            phi_2793_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_2793_ = type_18(1u, _e760);
                                        }
                                        let _e770 = phi_2793_;
                                        phi_2764_ = type_17(_e770.member_1, _e751.member_1);
                                        phi_2807_ = type_18(1u, _e751.member);
                                    } else {
                                        phi_2764_ = _e751;
                                        phi_2807_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e776 = phi_2764_;
                                    let _e778 = phi_2807_;
                                    let _e781 = (bitcast<i32>(_e778.member) != 0i);
                                    if _e781 {
                                        phi_2767_ = (0.5f * (_e753 + (_e742 / _e753)));
                                    } else {
                                        phi_2767_ = f32();
                                    }
                                    let _e786 = phi_2767_;
                                    continue;
                                    continuing {
                                        phi_2763_ = _e776;
                                        phi_2766_ = _e786;
                                        break if !(_e781);
                                    }
                                }
                                let _e791 = local_13;
                                phi_2820_ = (_e791 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e798 = phi_2820_;
                            if (_e734 < 0f) {
                                phi_2826_ = -(_e798);
                            } else {
                                phi_2826_ = _e798;
                            }
                            let _e802 = phi_2826_;
                            let _e804 = -((_e734 + _e802));
                            local_7[0u] = (_e804 / (_e804 + _e735));
                            local_7[1u] = (_e733 / (_e733 + _e804));
                            let _e813 = local_7[1u];
                            let _e814 = local_7[0u];
                            if (_e813 < _e814) {
                                let _e817 = local_7[1u];
                                let _e819 = local_7[0u];
                                local_7[0u] = _e817;
                                local_7[1u] = _e819;
                            }
                            phi_2851_ = type_19(0u, 2u);
                            phi_2854_ = 1u;
                            loop {
                                let _e823 = phi_2851_;
                                let _e825 = phi_2854_;
                                local_43 = _e825;
                                if (_e823.member < _e823.member_1) {
                                    phi_2852_ = type_19((_e823.member + 1u), _e823.member_1);
                                    phi_2877_ = type_19(1u, _e823.member);
                                } else {
                                    phi_2852_ = _e823;
                                    phi_2877_ = type_19(0u, type_19().member_1);
                                }
                                let _e837 = phi_2852_;
                                let _e839 = phi_2877_;
                                let _e843 = (bitcast<i32>(_e839.member) != 0i);
                                if _e843 {
                                    let _e845 = local_7[_e839.member_1];
                                    if (_e845 > 0f) {
                                        let _e848 = local_7[_e839.member_1];
                                        if (_e848 < 1f) {
                                            let _e851 = local_7[_e839.member_1];
                                            local_6[_e825] = _e851;
                                            phi_2921_ = (_e825 + 1u);
                                        } else {
                                            phi_2921_ = _e825;
                                        }
                                        let _e855 = phi_2921_;
                                        phi_2922_ = _e855;
                                    } else {
                                        phi_2922_ = _e825;
                                    }
                                    let _e857 = phi_2922_;
                                    phi_2855_ = _e857;
                                } else {
                                    phi_2855_ = u32();
                                }
                                let _e859 = phi_2855_;
                                continue;
                                continuing {
                                    phi_2851_ = _e837;
                                    phi_2854_ = _e859;
                                    break if !(_e843);
                                }
                            }
                            let _e4047 = local_43;
                            phi_2923_ = _e4047;
                        } else {
                            phi_2923_ = 1u;
                        }
                        let _e862 = phi_2923_;
                        local_6[_e862] = 1f;
                        let _e864 = local_6;
                        local_8 = _e864;
                        phi_2943_ = type_19(0u, _e862);
                        loop {
                            let _e867 = phi_2943_;
                            if (_e867.member < _e867.member_1) {
                                phi_2944_ = type_19((_e867.member + 1u), _e867.member_1);
                                phi_2967_ = type_19(1u, _e867.member);
                            } else {
                                phi_2944_ = _e867;
                                phi_2967_ = type_19(0u, type_19().member_1);
                            }
                            let _e879 = phi_2944_;
                            let _e881 = phi_2967_;
                            if (bitcast<i32>(_e881.member) != 0i) {
                                let _e887 = local_8[_e881.member_1];
                                let _e890 = local_8[(_e881.member_1 + 1u)];
                                let _e891 = (1f - _e887);
                                let _e902 = ((((_e349 * _e891) + (_e372 * _e887)) * (_e891 * _e891)) + (((_e395 * _e891) + (_e406 * _e887)) * (_e887 * _e887)));
                                let _e903 = (1f - _e890);
                                let _e914 = ((((_e349 * _e903) + (_e372 * _e890)) * (_e903 * _e903)) + (((_e395 * _e903) + (_e406 * _e890)) * (_e890 * _e890)));
                                if (_e902 < 0f) {
                                    phi_3019_ = -(_e902);
                                } else {
                                    phi_3019_ = _e902;
                                }
                                let _e918 = phi_3019_;
                                let _e919 = (_e918 > _e724);
                                if (_e914 < 0f) {
                                    phi_3026_ = -(_e914);
                                } else {
                                    phi_3026_ = _e914;
                                }
                                let _e923 = phi_3026_;
                                let _e924 = (_e923 > _e724);
                                if _e919 {
                                    if _e924 {
                                        phi_3037_ = ((_e902 > 0f) != (_e914 > 0f));
                                        phi_3038_ = false;
                                    } else {
                                        phi_3037_ = bool();
                                        phi_3038_ = true;
                                    }
                                    let _e929 = phi_3037_;
                                    let _e931 = phi_3038_;
                                    phi_3039_ = _e929;
                                    phi_3040_ = _e931;
                                } else {
                                    phi_3039_ = bool();
                                    phi_3040_ = true;
                                }
                                let _e933 = phi_3039_;
                                let _e935 = phi_3040_;
                                if _e935 {
                                    phi_3044_ = false;
                                } else {
                                    phi_3044_ = _e933;
                                }
                                let _e937 = phi_3044_;
                                if _e919 {
                                    if _e924 {
                                        if _e937 {
                                            phi_3055_ = type_33();
                                        } else {
                                            phi_3055_ = type_33(1f, 0f, _e937);
                                        }
                                        let _e940 = phi_3055_;
                                        phi_3056_ = _e940;
                                        phi_3057_ = _e937;
                                    } else {
                                        phi_3056_ = type_33();
                                        phi_3057_ = true;
                                    }
                                    let _e942 = phi_3056_;
                                    let _e944 = phi_3057_;
                                    phi_3058_ = _e942;
                                    phi_3059_ = _e944;
                                } else {
                                    phi_3058_ = type_33();
                                    phi_3059_ = true;
                                }
                                let _e946 = phi_3058_;
                                let _e948 = phi_3059_;
                                if _e948 {
                                    if _e919 {
                                        if (_e902 < 0f) {
                                            phi_3070_ = -1f;
                                        } else {
                                            phi_3070_ = 1f;
                                        }
                                        let _e951 = phi_3070_;
                                        let _e954 = (_e395 - _e372);
                                        phi_3080_ = type_19(0u, 64u);
                                        phi_3083_ = _e890;
                                        phi_3085_ = _e887;
                                        phi_3087_ = (0.5f * (_e887 + _e890));
                                        loop {
                                            let _e960 = phi_3080_;
                                            let _e962 = phi_3083_;
                                            let _e964 = phi_3085_;
                                            let _e966 = phi_3087_;
                                            local_45 = _e964;
                                            if (_e960.member < _e960.member_1) {
                                                phi_3081_ = type_19((_e960.member + 1u), _e960.member_1);
                                                phi_3110_ = type_19(1u, _e960.member);
                                            } else {
                                                phi_3081_ = _e960;
                                                phi_3110_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e978 = phi_3081_;
                                            let _e980 = phi_3110_;
                                            if (bitcast<i32>(_e980.member) != 0i) {
                                                let _e984 = (1f - _e966);
                                                let _e997 = ((_e951 * ((((_e349 * _e984) + (_e372 * _e966)) * (_e984 * _e984)) + (((_e395 * _e984) + (_e406 * _e966)) * (_e966 * _e966)))) - _e724);
                                                if (_e997 > 0f) {
                                                    phi_3135_ = _e962;
                                                    phi_3136_ = _e966;
                                                } else {
                                                    phi_3135_ = _e966;
                                                    phi_3136_ = _e964;
                                                }
                                                let _e1000 = phi_3135_;
                                                let _e1002 = phi_3136_;
                                                let _e1004 = ((_e1000 - _e1002) > 0.00000000000022737368f);
                                                if _e1004 {
                                                    let _e1005 = (1f - _e966);
                                                    let _e1017 = (-(_e997) / (_e951 * (((((_e372 - (3f * _e349)) * _e1005) + (_e954 * _e966)) * _e1005) + (((_e954 * _e1005) + (((3f * _e406) - _e395) * _e966)) * _e966))));
                                                    if (_e997 > 0f) {
                                                        phi_3162_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_3162_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1023 = phi_3162_;
                                                    let _e1025 = ((_e966 + _e1017) + _e1023);
                                                    if (_e1025 > _e1002) {
                                                        if (_e1025 < _e1000) {
                                                            if (_e1017 < 0f) {
                                                                phi_3178_ = -(_e1017);
                                                            } else {
                                                                phi_3178_ = _e1017;
                                                            }
                                                            let _e1031 = phi_3178_;
                                                            if (_e1031 < (0.5f * (_e1000 - _e1002))) {
                                                                phi_3185_ = false;
                                                            } else {
                                                                phi_3185_ = true;
                                                            }
                                                            let _e1036 = phi_3185_;
                                                            phi_3186_ = _e1036;
                                                        } else {
                                                            phi_3186_ = true;
                                                        }
                                                        let _e1038 = phi_3186_;
                                                        phi_3187_ = _e1038;
                                                    } else {
                                                        phi_3187_ = true;
                                                    }
                                                    let _e1040 = phi_3187_;
                                                    if _e1040 {
                                                        phi_3193_ = (0.5f * (_e1002 + _e1000));
                                                    } else {
                                                        phi_3193_ = _e1025;
                                                    }
                                                    let _e1044 = phi_3193_;
                                                    phi_3194_ = _e1044;
                                                    phi_3195_ = false;
                                                } else {
                                                    phi_3194_ = f32();
                                                    phi_3195_ = true;
                                                }
                                                let _e1046 = phi_3194_;
                                                let _e1048 = phi_3195_;
                                                phi_3084_ = _e1000;
                                                phi_3086_ = _e1002;
                                                phi_3088_ = _e1046;
                                                phi_3196_ = _e1002;
                                                phi_3197_ = _e1004;
                                                phi_3198_ = _e1048;
                                            } else {
                                                phi_3084_ = f32();
                                                phi_3086_ = f32();
                                                phi_3088_ = f32();
                                                phi_3196_ = f32();
                                                phi_3197_ = false;
                                                phi_3198_ = false;
                                            }
                                            let _e1050 = phi_3084_;
                                            let _e1052 = phi_3086_;
                                            let _e1054 = phi_3088_;
                                            let _e1056 = phi_3196_;
                                            let _e1058 = phi_3197_;
                                            let _e1060 = phi_3198_;
                                            local_14 = _e1060;
                                            local_44 = _e1056;
                                            continue;
                                            continuing {
                                                phi_3080_ = _e978;
                                                phi_3083_ = _e1050;
                                                phi_3085_ = _e1052;
                                                phi_3087_ = _e1054;
                                                break if !(_e1058);
                                            }
                                        }
                                        let _e1063 = local_14;
                                        if _e1063 {
                                            let _e4089 = local_44;
                                            phi_3202_ = _e4089;
                                        } else {
                                            let _e4091 = local_45;
                                            phi_3202_ = _e4091;
                                        }
                                        let _e1065 = phi_3202_;
                                        phi_3203_ = _e1065;
                                    } else {
                                        phi_3203_ = _e887;
                                    }
                                    let _e1067 = phi_3203_;
                                    if _e924 {
                                        phi_3210_ = type_19(0u, 64u);
                                        phi_3213_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1070 = phi_3210_;
                                            let _e1072 = phi_3213_;
                                            if (_e1070.member < _e1070.member_1) {
                                                phi_3211_ = type_19((_e1070.member + 1u), _e1070.member_1);
                                                phi_3236_ = type_19(1u, _e1070.member);
                                            } else {
                                                phi_3211_ = _e1070;
                                                phi_3236_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1084 = phi_3211_;
                                            let _e1086 = phi_3236_;
                                            if (bitcast<i32>(_e1086.member) != 0i) {
                                                let _e1090 = (_e1067 + _e1072);
                                                if (_e1090 < _e890) {
                                                    let _e1092 = (1f - _e1090);
                                                    let _e1103 = ((((_e349 * _e1092) + (_e372 * _e1090)) * (_e1092 * _e1092)) + (((_e395 * _e1092) + (_e406 * _e1090)) * (_e1090 * _e1090)));
                                                    let _e1104 = (1f - _e1067);
                                                    let _e1115 = ((((_e349 * _e1104) + (_e372 * _e1067)) * (_e1104 * _e1104)) + (((_e395 * _e1104) + (_e406 * _e1067)) * (_e1067 * _e1067)));
                                                    if (_e1103 < 0f) {
                                                        phi_3277_ = -(_e1103);
                                                    } else {
                                                        phi_3277_ = _e1103;
                                                    }
                                                    let _e1119 = phi_3277_;
                                                    if (_e1119 > _e724) {
                                                        if (_e1115 < 0f) {
                                                            phi_3287_ = -(_e1115);
                                                        } else {
                                                            phi_3287_ = _e1115;
                                                        }
                                                        let _e1124 = phi_3287_;
                                                        if (_e1124 > _e724) {
                                                            phi_3295_ = ((_e1103 > 0f) == (_e1115 > 0f));
                                                        } else {
                                                            phi_3295_ = false;
                                                        }
                                                        let _e1130 = phi_3295_;
                                                        phi_3297_ = !(_e1130);
                                                    } else {
                                                        phi_3297_ = false;
                                                    }
                                                    let _e1133 = phi_3297_;
                                                    if _e1133 {
                                                        phi_3302_ = f32();
                                                        phi_3303_ = false;
                                                    } else {
                                                        phi_3302_ = (_e1072 + _e1072);
                                                        phi_3303_ = true;
                                                    }
                                                    let _e1136 = phi_3302_;
                                                    let _e1138 = phi_3303_;
                                                    phi_3304_ = _e1136;
                                                    phi_3305_ = _e1138;
                                                    phi_3306_ = _e1133;
                                                    phi_3307_ = false;
                                                } else {
                                                    phi_3304_ = f32();
                                                    phi_3305_ = false;
                                                    phi_3306_ = false;
                                                    phi_3307_ = true;
                                                }
                                                let _e1140 = phi_3304_;
                                                let _e1142 = phi_3305_;
                                                let _e1144 = phi_3306_;
                                                let _e1146 = phi_3307_;
                                                phi_3308_ = _e1090;
                                                phi_3214_ = _e1140;
                                                phi_3309_ = _e1142;
                                                phi_3310_ = _e1144;
                                                phi_3311_ = _e1146;
                                                phi_3312_ = false;
                                            } else {
                                                phi_3308_ = f32();
                                                phi_3214_ = f32();
                                                phi_3309_ = false;
                                                phi_3310_ = false;
                                                phi_3311_ = false;
                                                phi_3312_ = true;
                                            }
                                            let _e1148 = phi_3308_;
                                            let _e1150 = phi_3214_;
                                            let _e1152 = phi_3309_;
                                            let _e1154 = phi_3310_;
                                            let _e1156 = phi_3311_;
                                            let _e1158 = phi_3312_;
                                            local_15 = _e1154;
                                            local_46 = _e1156;
                                            local_47 = _e1158;
                                            local_48 = _e1148;
                                            continue;
                                            continuing {
                                                phi_3210_ = _e1084;
                                                phi_3213_ = _e1150;
                                                break if !(_e1152);
                                            }
                                        }
                                        let _e1161 = local_15;
                                        if _e1161 {
                                            phi_3316_ = false;
                                            phi_3317_ = false;
                                        } else {
                                            let _e4116 = local_46;
                                            phi_3316_ = _e4116;
                                            let _e4119 = local_47;
                                            phi_3317_ = _e4119;
                                        }
                                        let _e1163 = phi_3316_;
                                        let _e1165 = phi_3317_;
                                        if _e1163 {
                                            phi_3321_ = true;
                                        } else {
                                            phi_3321_ = _e1165;
                                        }
                                        let _e1167 = phi_3321_;
                                        if _e1167 {
                                            phi_3325_ = _e890;
                                        } else {
                                            let _e4123 = local_48;
                                            phi_3325_ = _e4123;
                                        }
                                        let _e1169 = phi_3325_;
                                        phi_3326_ = _e1169;
                                    } else {
                                        phi_3326_ = _e890;
                                    }
                                    let _e1171 = phi_3326_;
                                    phi_3328_ = type_33(_e1067, _e1171, _e937);
                                } else {
                                    phi_3328_ = _e946;
                                }
                                let _e1174 = phi_3328_;
                                if (_e1174.member > _e1174.member_1) {
                                    phi_5433_ = f32();
                                    phi_5434_ = true;
                                    phi_5435_ = false;
                                    phi_5436_ = false;
                                    phi_5437_ = false;
                                } else {
                                    let _e1181 = ((_e1174.member_1 - _e1174.member) * 0.5f);
                                    let _e1182 = (_e1174.member + _e1181);
                                    let _e1184 = (_e1181 + (0.000000059604645f * 4f));
                                    let _e1186 = local_12.member_3;
                                    let _e1189 = local_12.member[0u];
                                    if (_e1189[0] < 0f) {
                                        phi_3357_ = -(_e1189[0]);
                                    } else {
                                        phi_3357_ = _e1189[0];
                                    }
                                    let _e1196 = phi_3357_;
                                    if (_e1189[1] < 0f) {
                                        phi_3364_ = -(_e1189[1]);
                                    } else {
                                        phi_3364_ = _e1189[1];
                                    }
                                    let _e1200 = phi_3364_;
                                    if (_e1196 > _e1200) {
                                        phi_3369_ = _e1196;
                                    } else {
                                        phi_3369_ = _e1200;
                                    }
                                    let _e1203 = phi_3369_;
                                    if (_e1189[2] < 0f) {
                                        phi_3376_ = -(_e1189[2]);
                                    } else {
                                        phi_3376_ = _e1189[2];
                                    }
                                    let _e1207 = phi_3376_;
                                    if (_e1203 > _e1207) {
                                        phi_3381_ = _e1203;
                                    } else {
                                        phi_3381_ = _e1207;
                                    }
                                    let _e1210 = phi_3381_;
                                    let _e1212 = local_12.member[1u];
                                    if (_e1212[0] < 0f) {
                                        phi_3394_ = -(_e1212[0]);
                                    } else {
                                        phi_3394_ = _e1212[0];
                                    }
                                    let _e1219 = phi_3394_;
                                    if (_e1212[1] < 0f) {
                                        phi_3401_ = -(_e1212[1]);
                                    } else {
                                        phi_3401_ = _e1212[1];
                                    }
                                    let _e1223 = phi_3401_;
                                    if (_e1219 > _e1223) {
                                        phi_3406_ = _e1219;
                                    } else {
                                        phi_3406_ = _e1223;
                                    }
                                    let _e1226 = phi_3406_;
                                    if (_e1212[2] < 0f) {
                                        phi_3413_ = -(_e1212[2]);
                                    } else {
                                        phi_3413_ = _e1212[2];
                                    }
                                    let _e1230 = phi_3413_;
                                    if (_e1226 > _e1230) {
                                        phi_3418_ = _e1226;
                                    } else {
                                        phi_3418_ = _e1230;
                                    }
                                    let _e1233 = phi_3418_;
                                    if (_e1210 > _e1233) {
                                        phi_3423_ = _e1210;
                                    } else {
                                        phi_3423_ = _e1233;
                                    }
                                    let _e1236 = phi_3423_;
                                    let _e1239 = local_12.member[0u];
                                    let _e1244 = local_12.member[1u];
                                    let _e1254 = (_e1239[0] + ((_e1244[0] - _e1239[0]) * _e1182));
                                    let _e1255 = (_e1239[1] + ((_e1244[1] - _e1239[1]) * _e1182));
                                    let _e1256 = (_e1239[2] + ((_e1244[2] - _e1239[2]) * _e1182));
                                    let _e1258 = local_12.member[1u];
                                    let _e1263 = local_12.member[0u];
                                    let _e1267 = (_e1258[0] - _e1263[0]);
                                    let _e1268 = (_e1258[1] - _e1263[1]);
                                    let _e1269 = (_e1258[2] - _e1263[2]);
                                    if (_e1267 < 0f) {
                                        phi_3482_ = -(_e1267);
                                    } else {
                                        phi_3482_ = _e1267;
                                    }
                                    let _e1273 = phi_3482_;
                                    if (_e1268 < 0f) {
                                        phi_3488_ = -(_e1268);
                                    } else {
                                        phi_3488_ = _e1268;
                                    }
                                    let _e1277 = phi_3488_;
                                    if (_e1273 > _e1277) {
                                        phi_3493_ = _e1273;
                                    } else {
                                        phi_3493_ = _e1277;
                                    }
                                    let _e1280 = phi_3493_;
                                    if (_e1269 < 0f) {
                                        phi_3499_ = -(_e1269);
                                    } else {
                                        phi_3499_ = _e1269;
                                    }
                                    let _e1284 = phi_3499_;
                                    if (_e1280 > _e1284) {
                                        phi_3504_ = _e1280;
                                    } else {
                                        phi_3504_ = _e1284;
                                    }
                                    let _e1287 = phi_3504_;
                                    let _e1293 = ((((_e1184 * _e1287) * 1.01f) + ((_e1236 + _e1186) * (0.000000059604645f * 8f))) + _e1186);
                                    if (_e1254 < 0f) {
                                        phi_3516_ = -(_e1254);
                                    } else {
                                        phi_3516_ = _e1254;
                                    }
                                    let _e1297 = phi_3516_;
                                    if (_e1255 < 0f) {
                                        phi_3522_ = -(_e1255);
                                    } else {
                                        phi_3522_ = _e1255;
                                    }
                                    let _e1301 = phi_3522_;
                                    if (_e1297 > _e1301) {
                                        phi_3527_ = _e1297;
                                    } else {
                                        phi_3527_ = _e1301;
                                    }
                                    let _e1304 = phi_3527_;
                                    if (_e1256 < 0f) {
                                        phi_3533_ = -(_e1256);
                                    } else {
                                        phi_3533_ = _e1256;
                                    }
                                    let _e1308 = phi_3533_;
                                    if (_e1304 > _e1308) {
                                        phi_3538_ = _e1304;
                                    } else {
                                        phi_3538_ = _e1308;
                                    }
                                    let _e1311 = phi_3538_;
                                    local_2 = type_24(array<f32, 3>(_e1254, _e1255, _e1256), _e1293, (_e1311 + _e1293));
                                    let _e1317 = local_12.member_3;
                                    let _e1319 = local_12.member_1[0u];
                                    if (_e1319[0] < 0f) {
                                        phi_3564_ = -(_e1319[0]);
                                    } else {
                                        phi_3564_ = _e1319[0];
                                    }
                                    let _e1326 = phi_3564_;
                                    if (_e1319[1] < 0f) {
                                        phi_3571_ = -(_e1319[1]);
                                    } else {
                                        phi_3571_ = _e1319[1];
                                    }
                                    let _e1330 = phi_3571_;
                                    if (_e1326 > _e1330) {
                                        phi_3576_ = _e1326;
                                    } else {
                                        phi_3576_ = _e1330;
                                    }
                                    let _e1333 = phi_3576_;
                                    if (_e1319[2] < 0f) {
                                        phi_3583_ = -(_e1319[2]);
                                    } else {
                                        phi_3583_ = _e1319[2];
                                    }
                                    let _e1337 = phi_3583_;
                                    if (_e1333 > _e1337) {
                                        phi_3588_ = _e1333;
                                    } else {
                                        phi_3588_ = _e1337;
                                    }
                                    let _e1340 = phi_3588_;
                                    let _e1342 = local_12.member_1[1u];
                                    if (_e1342[0] < 0f) {
                                        phi_3601_ = -(_e1342[0]);
                                    } else {
                                        phi_3601_ = _e1342[0];
                                    }
                                    let _e1349 = phi_3601_;
                                    if (_e1342[1] < 0f) {
                                        phi_3608_ = -(_e1342[1]);
                                    } else {
                                        phi_3608_ = _e1342[1];
                                    }
                                    let _e1353 = phi_3608_;
                                    if (_e1349 > _e1353) {
                                        phi_3613_ = _e1349;
                                    } else {
                                        phi_3613_ = _e1353;
                                    }
                                    let _e1356 = phi_3613_;
                                    if (_e1342[2] < 0f) {
                                        phi_3620_ = -(_e1342[2]);
                                    } else {
                                        phi_3620_ = _e1342[2];
                                    }
                                    let _e1360 = phi_3620_;
                                    if (_e1356 > _e1360) {
                                        phi_3625_ = _e1356;
                                    } else {
                                        phi_3625_ = _e1360;
                                    }
                                    let _e1363 = phi_3625_;
                                    if (_e1340 > _e1363) {
                                        phi_3630_ = _e1340;
                                    } else {
                                        phi_3630_ = _e1363;
                                    }
                                    let _e1366 = phi_3630_;
                                    let _e1369 = local_12.member_1[0u];
                                    let _e1374 = local_12.member_1[1u];
                                    let _e1384 = (_e1369[0] + ((_e1374[0] - _e1369[0]) * _e1182));
                                    let _e1385 = (_e1369[1] + ((_e1374[1] - _e1369[1]) * _e1182));
                                    let _e1386 = (_e1369[2] + ((_e1374[2] - _e1369[2]) * _e1182));
                                    let _e1388 = local_12.member_1[1u];
                                    let _e1393 = local_12.member_1[0u];
                                    let _e1397 = (_e1388[0] - _e1393[0]);
                                    let _e1398 = (_e1388[1] - _e1393[1]);
                                    let _e1399 = (_e1388[2] - _e1393[2]);
                                    if (_e1397 < 0f) {
                                        phi_3689_ = -(_e1397);
                                    } else {
                                        phi_3689_ = _e1397;
                                    }
                                    let _e1403 = phi_3689_;
                                    if (_e1398 < 0f) {
                                        phi_3695_ = -(_e1398);
                                    } else {
                                        phi_3695_ = _e1398;
                                    }
                                    let _e1407 = phi_3695_;
                                    if (_e1403 > _e1407) {
                                        phi_3700_ = _e1403;
                                    } else {
                                        phi_3700_ = _e1407;
                                    }
                                    let _e1410 = phi_3700_;
                                    if (_e1399 < 0f) {
                                        phi_3706_ = -(_e1399);
                                    } else {
                                        phi_3706_ = _e1399;
                                    }
                                    let _e1414 = phi_3706_;
                                    if (_e1410 > _e1414) {
                                        phi_3711_ = _e1410;
                                    } else {
                                        phi_3711_ = _e1414;
                                    }
                                    let _e1417 = phi_3711_;
                                    let _e1423 = ((((_e1184 * _e1417) * 1.01f) + ((_e1366 + _e1317) * (0.000000059604645f * 8f))) + _e1317);
                                    if (_e1384 < 0f) {
                                        phi_3723_ = -(_e1384);
                                    } else {
                                        phi_3723_ = _e1384;
                                    }
                                    let _e1427 = phi_3723_;
                                    if (_e1385 < 0f) {
                                        phi_3729_ = -(_e1385);
                                    } else {
                                        phi_3729_ = _e1385;
                                    }
                                    let _e1431 = phi_3729_;
                                    if (_e1427 > _e1431) {
                                        phi_3734_ = _e1427;
                                    } else {
                                        phi_3734_ = _e1431;
                                    }
                                    let _e1434 = phi_3734_;
                                    if (_e1386 < 0f) {
                                        phi_3740_ = -(_e1386);
                                    } else {
                                        phi_3740_ = _e1386;
                                    }
                                    let _e1438 = phi_3740_;
                                    if (_e1434 > _e1438) {
                                        phi_3745_ = _e1434;
                                    } else {
                                        phi_3745_ = _e1438;
                                    }
                                    let _e1441 = phi_3745_;
                                    local_3 = type_24(array<f32, 3>(_e1384, _e1385, _e1386), _e1423, (_e1441 + _e1423));
                                    let _e1447 = local_12.member_3;
                                    let _e1449 = local_12.member_2[0u];
                                    if (_e1449[0] < 0f) {
                                        phi_3771_ = -(_e1449[0]);
                                    } else {
                                        phi_3771_ = _e1449[0];
                                    }
                                    let _e1456 = phi_3771_;
                                    if (_e1449[1] < 0f) {
                                        phi_3778_ = -(_e1449[1]);
                                    } else {
                                        phi_3778_ = _e1449[1];
                                    }
                                    let _e1460 = phi_3778_;
                                    if (_e1456 > _e1460) {
                                        phi_3783_ = _e1456;
                                    } else {
                                        phi_3783_ = _e1460;
                                    }
                                    let _e1463 = phi_3783_;
                                    if (_e1449[2] < 0f) {
                                        phi_3790_ = -(_e1449[2]);
                                    } else {
                                        phi_3790_ = _e1449[2];
                                    }
                                    let _e1467 = phi_3790_;
                                    if (_e1463 > _e1467) {
                                        phi_3795_ = _e1463;
                                    } else {
                                        phi_3795_ = _e1467;
                                    }
                                    let _e1470 = phi_3795_;
                                    let _e1472 = local_12.member_2[1u];
                                    if (_e1472[0] < 0f) {
                                        phi_3808_ = -(_e1472[0]);
                                    } else {
                                        phi_3808_ = _e1472[0];
                                    }
                                    let _e1479 = phi_3808_;
                                    if (_e1472[1] < 0f) {
                                        phi_3815_ = -(_e1472[1]);
                                    } else {
                                        phi_3815_ = _e1472[1];
                                    }
                                    let _e1483 = phi_3815_;
                                    if (_e1479 > _e1483) {
                                        phi_3820_ = _e1479;
                                    } else {
                                        phi_3820_ = _e1483;
                                    }
                                    let _e1486 = phi_3820_;
                                    if (_e1472[2] < 0f) {
                                        phi_3827_ = -(_e1472[2]);
                                    } else {
                                        phi_3827_ = _e1472[2];
                                    }
                                    let _e1490 = phi_3827_;
                                    if (_e1486 > _e1490) {
                                        phi_3832_ = _e1486;
                                    } else {
                                        phi_3832_ = _e1490;
                                    }
                                    let _e1493 = phi_3832_;
                                    if (_e1470 > _e1493) {
                                        phi_3837_ = _e1470;
                                    } else {
                                        phi_3837_ = _e1493;
                                    }
                                    let _e1496 = phi_3837_;
                                    let _e1499 = local_12.member_2[0u];
                                    let _e1504 = local_12.member_2[1u];
                                    let _e1514 = (_e1499[0] + ((_e1504[0] - _e1499[0]) * _e1182));
                                    let _e1515 = (_e1499[1] + ((_e1504[1] - _e1499[1]) * _e1182));
                                    let _e1516 = (_e1499[2] + ((_e1504[2] - _e1499[2]) * _e1182));
                                    let _e1518 = local_12.member_2[1u];
                                    let _e1523 = local_12.member_2[0u];
                                    let _e1527 = (_e1518[0] - _e1523[0]);
                                    let _e1528 = (_e1518[1] - _e1523[1]);
                                    let _e1529 = (_e1518[2] - _e1523[2]);
                                    if (_e1527 < 0f) {
                                        phi_3896_ = -(_e1527);
                                    } else {
                                        phi_3896_ = _e1527;
                                    }
                                    let _e1533 = phi_3896_;
                                    if (_e1528 < 0f) {
                                        phi_3902_ = -(_e1528);
                                    } else {
                                        phi_3902_ = _e1528;
                                    }
                                    let _e1537 = phi_3902_;
                                    if (_e1533 > _e1537) {
                                        phi_3907_ = _e1533;
                                    } else {
                                        phi_3907_ = _e1537;
                                    }
                                    let _e1540 = phi_3907_;
                                    if (_e1529 < 0f) {
                                        phi_3913_ = -(_e1529);
                                    } else {
                                        phi_3913_ = _e1529;
                                    }
                                    let _e1544 = phi_3913_;
                                    if (_e1540 > _e1544) {
                                        phi_3918_ = _e1540;
                                    } else {
                                        phi_3918_ = _e1544;
                                    }
                                    let _e1547 = phi_3918_;
                                    let _e1553 = ((((_e1184 * _e1547) * 1.01f) + ((_e1496 + _e1447) * (0.000000059604645f * 8f))) + _e1447);
                                    if (_e1514 < 0f) {
                                        phi_3930_ = -(_e1514);
                                    } else {
                                        phi_3930_ = _e1514;
                                    }
                                    let _e1557 = phi_3930_;
                                    if (_e1515 < 0f) {
                                        phi_3936_ = -(_e1515);
                                    } else {
                                        phi_3936_ = _e1515;
                                    }
                                    let _e1561 = phi_3936_;
                                    if (_e1557 > _e1561) {
                                        phi_3941_ = _e1557;
                                    } else {
                                        phi_3941_ = _e1561;
                                    }
                                    let _e1564 = phi_3941_;
                                    if (_e1516 < 0f) {
                                        phi_3947_ = -(_e1516);
                                    } else {
                                        phi_3947_ = _e1516;
                                    }
                                    let _e1568 = phi_3947_;
                                    if (_e1564 > _e1568) {
                                        phi_3952_ = _e1564;
                                    } else {
                                        phi_3952_ = _e1568;
                                    }
                                    let _e1571 = phi_3952_;
                                    local_4 = type_24(array<f32, 3>(_e1514, _e1515, _e1516), _e1553, (_e1571 + _e1553));
                                    let _e1576 = local_3.member;
                                    let _e1581 = local_4.member;
                                    let _e1587 = ((_e1576[1] * _e1581[2]) - (_e1576[2] * _e1581[1]));
                                    let _e1590 = ((_e1576[2] * _e1581[0]) - (_e1576[0] * _e1581[2]));
                                    let _e1593 = ((_e1576[0] * _e1581[1]) - (_e1576[1] * _e1581[0]));
                                    if (_e1587 < 0f) {
                                        phi_4001_ = -(_e1587);
                                    } else {
                                        phi_4001_ = _e1587;
                                    }
                                    let _e1597 = phi_4001_;
                                    if (_e1590 < 0f) {
                                        phi_4007_ = -(_e1590);
                                    } else {
                                        phi_4007_ = _e1590;
                                    }
                                    let _e1601 = phi_4007_;
                                    if (_e1597 > _e1601) {
                                        if (_e1587 < 0f) {
                                            phi_4017_ = -(_e1587);
                                        } else {
                                            phi_4017_ = _e1587;
                                        }
                                        let _e1619 = phi_4017_;
                                        if (_e1593 < 0f) {
                                            phi_4023_ = -(_e1593);
                                        } else {
                                            phi_4023_ = _e1593;
                                        }
                                        let _e1623 = phi_4023_;
                                        if (_e1619 > _e1623) {
                                            phi_4028_ = 2u;
                                            phi_4029_ = 1u;
                                        } else {
                                            phi_4028_ = 1u;
                                            phi_4029_ = 0u;
                                        }
                                        let _e1626 = phi_4028_;
                                        let _e1628 = phi_4029_;
                                        phi_4048_ = _e1626;
                                        phi_4049_ = _e1628;
                                    } else {
                                        if (_e1590 < 0f) {
                                            phi_4035_ = -(_e1590);
                                        } else {
                                            phi_4035_ = _e1590;
                                        }
                                        let _e1606 = phi_4035_;
                                        if (_e1593 < 0f) {
                                            phi_4041_ = -(_e1593);
                                        } else {
                                            phi_4041_ = _e1593;
                                        }
                                        let _e1610 = phi_4041_;
                                        if (_e1606 > _e1610) {
                                            phi_4046_ = 0u;
                                            phi_4047_ = 2u;
                                        } else {
                                            phi_4046_ = 1u;
                                            phi_4047_ = 0u;
                                        }
                                        let _e1613 = phi_4046_;
                                        let _e1615 = phi_4047_;
                                        phi_4048_ = _e1613;
                                        phi_4049_ = _e1615;
                                    }
                                    let _e1630 = phi_4048_;
                                    let _e1632 = phi_4049_;
                                    let _e1635 = local_3.member[_e1632];
                                    let _e1638 = local_4.member[_e1630];
                                    let _e1642 = local_3.member[_e1630];
                                    let _e1645 = local_4.member[_e1632];
                                    let _e1647 = ((_e1635 * _e1638) - (_e1642 * _e1645));
                                    let _e1649 = local_3.member_1;
                                    let _e1651 = local_4.member_2;
                                    let _e1654 = local_3.member_2;
                                    let _e1656 = local_4.member_1;
                                    let _e1661 = local_3.member_2;
                                    let _e1663 = local_4.member_2;
                                    let _e1670 = local_3.member_2;
                                    let _e1673 = local_4.member_2;
                                    let _e1677 = (((((_e1649 * _e1651) + (_e1654 * _e1656)) * 2.01f) + ((_e1661 * _e1663) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1670) * (1f + _e1673))));
                                    if (_e1647 < 0f) {
                                        phi_4116_ = -(_e1647);
                                    } else {
                                        phi_4116_ = _e1647;
                                    }
                                    let _e1681 = phi_4116_;
                                    if (_e1681 > _e1677) {
                                        if (_e1647 < 0f) {
                                            phi_4125_ = -1f;
                                        } else {
                                            phi_4125_ = 1f;
                                        }
                                        let _e1685 = phi_4125_;
                                        let _e1688 = local_2.member[_e1632];
                                        let _e1691 = local_4.member[_e1630];
                                        let _e1695 = local_2.member[_e1630];
                                        let _e1698 = local_4.member[_e1632];
                                        let _e1702 = local_2.member_1;
                                        let _e1704 = local_4.member_2;
                                        let _e1707 = local_2.member_2;
                                        let _e1709 = local_4.member_1;
                                        let _e1714 = local_2.member_2;
                                        let _e1716 = local_4.member_2;
                                        let _e1723 = local_2.member_2;
                                        let _e1726 = local_4.member_2;
                                        let _e1730 = (((((_e1702 * _e1704) + (_e1707 * _e1709)) * 2.01f) + ((_e1714 * _e1716) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1723) * (1f + _e1726))));
                                        let _e1733 = local_3.member[_e1632];
                                        let _e1736 = local_2.member[_e1630];
                                        let _e1740 = local_3.member[_e1630];
                                        let _e1743 = local_2.member[_e1632];
                                        let _e1747 = local_3.member_1;
                                        let _e1749 = local_2.member_2;
                                        let _e1752 = local_3.member_2;
                                        let _e1754 = local_2.member_1;
                                        let _e1759 = local_3.member_2;
                                        let _e1761 = local_2.member_2;
                                        let _e1768 = local_3.member_2;
                                        let _e1771 = local_2.member_2;
                                        let _e1775 = (((((_e1747 * _e1749) + (_e1752 * _e1754)) * 2.01f) + ((_e1759 * _e1761) * (0.000000059604645f * 8f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1768) * (1f + _e1771))));
                                        let _e1776 = (_e1647 * _e1685);
                                        let _e1777 = (((_e1688 * _e1691) - (_e1695 * _e1698)) * _e1685);
                                        let _e1778 = (((_e1733 * _e1736) - (_e1740 * _e1743)) * _e1685);
                                        if (_e1776 < 0f) {
                                            phi_4256_ = -(_e1776);
                                        } else {
                                            phi_4256_ = _e1776;
                                        }
                                        let _e1782 = phi_4256_;
                                        if (_e1777 < 0f) {
                                            phi_4262_ = -(_e1777);
                                        } else {
                                            phi_4262_ = _e1777;
                                        }
                                        let _e1786 = phi_4262_;
                                        if (_e1778 < 0f) {
                                            phi_4269_ = -(_e1778);
                                        } else {
                                            phi_4269_ = _e1778;
                                        }
                                        let _e1791 = phi_4269_;
                                        let _e1794 = (((_e1782 + _e1786) + _e1791) * (0.000000059604645f * 4f));
                                        local_5[0u].member = _e1777;
                                        local_5[0u].member_1 = _e1730;
                                        local_5[1u].member = _e1778;
                                        local_5[1u].member_1 = _e1775;
                                        local_5[2u].member = (_e1776 - _e1777);
                                        local_5[2u].member_1 = ((_e1677 + _e1730) + _e1794);
                                        local_5[3u].member = (_e1776 - _e1778);
                                        local_5[3u].member_1 = ((_e1677 + _e1775) + _e1794);
                                        phi_4312_ = type_19(0u, 4u);
                                        phi_4315_ = true;
                                        loop {
                                            let _e1815 = phi_4312_;
                                            let _e1817 = phi_4315_;
                                            local_17 = _e1817;
                                            if (_e1815.member < _e1815.member_1) {
                                                phi_4313_ = type_19((_e1815.member + 1u), _e1815.member_1);
                                                phi_4338_ = type_19(1u, _e1815.member);
                                            } else {
                                                phi_4313_ = _e1815;
                                                phi_4338_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1829 = phi_4313_;
                                            let _e1831 = phi_4338_;
                                            if (bitcast<i32>(_e1831.member) != 0i) {
                                                let _e1838 = local_5[_e1831.member_1].member;
                                                let _e1841 = local_5[_e1831.member_1].member_1;
                                                let _e1843 = (_e1838 < -(_e1841));
                                                if _e1843 {
                                                    phi_4365_ = bool();
                                                    phi_4366_ = false;
                                                } else {
                                                    phi_4365_ = (_e1817 && (_e1838 > _e1841));
                                                    phi_4366_ = true;
                                                }
                                                let _e1847 = phi_4365_;
                                                let _e1849 = phi_4366_;
                                                phi_4316_ = _e1847;
                                                phi_4367_ = _e1849;
                                                phi_4368_ = _e1843;
                                            } else {
                                                phi_4316_ = bool();
                                                phi_4367_ = false;
                                                phi_4368_ = false;
                                            }
                                            let _e1851 = phi_4316_;
                                            let _e1853 = phi_4367_;
                                            let _e1855 = phi_4368_;
                                            local_16 = _e1855;
                                            continue;
                                            continuing {
                                                phi_4312_ = _e1829;
                                                phi_4315_ = _e1851;
                                                break if !(_e1853);
                                            }
                                        }
                                        let _e1858 = local_16;
                                        if _e1858 {
                                            phi_4372_ = false;
                                        } else {
                                            phi_4372_ = true;
                                        }
                                        let _e1860 = phi_4372_;
                                        if _e1860 {
                                            let _e1862 = local_17;
                                            if _e1862 {
                                                phi_4379_ = 1u;
                                            } else {
                                                phi_4379_ = 2u;
                                            }
                                            let _e1864 = phi_4379_;
                                            phi_4380_ = _e1864;
                                            phi_4381_ = false;
                                        } else {
                                            phi_4380_ = u32();
                                            phi_4381_ = true;
                                        }
                                        let _e1866 = phi_4380_;
                                        let _e1868 = phi_4381_;
                                        phi_4382_ = _e1866;
                                        phi_4383_ = 0u;
                                        phi_4384_ = _e1868;
                                    } else {
                                        phi_4382_ = u32();
                                        phi_4383_ = 2u;
                                        phi_4384_ = true;
                                    }
                                    let _e1870 = phi_4382_;
                                    let _e1872 = phi_4383_;
                                    let _e1874 = phi_4384_;
                                    if _e1874 {
                                        phi_4388_ = _e1872;
                                    } else {
                                        phi_4388_ = _e1870;
                                    }
                                    let _e1876 = phi_4388_;
                                    let _e1877 = (_e1876 == 0u);
                                    if _e1877 {
                                        phi_5429_ = f32();
                                        phi_5430_ = false;
                                        phi_5431_ = false;
                                        phi_5432_ = false;
                                    } else {
                                        if (_e1876 == 1u) {
                                            if _e1174.member_2 {
                                                if ((_e1174.member_1 - _e1174.member) <= 0.0000005f) {
                                                    phi_4408_ = false;
                                                } else {
                                                    phi_4408_ = true;
                                                }
                                                let _e1885 = phi_4408_;
                                                phi_4409_ = _e1885;
                                            } else {
                                                phi_4409_ = true;
                                            }
                                            let _e1887 = phi_4409_;
                                            phi_4410_ = _e1887;
                                        } else {
                                            phi_4410_ = true;
                                        }
                                        let _e1889 = phi_4410_;
                                        if _e1889 {
                                            let _e1894 = local_12.member[0u];
                                            let _e1900 = local_12.member_1[0u];
                                            let _e1906 = local_12.member_2[0u];
                                            let _e1910 = (_e1894[0] - _e1900[0]);
                                            let _e1911 = (_e1894[1] - _e1900[1]);
                                            let _e1912 = (_e1894[2] - _e1900[2]);
                                            local = array<array<f32, 3>, 4>(_e1894, array<f32, 3>(_e1910, _e1911, _e1912), array<f32, 3>((_e1894[0] - _e1906[0]), (_e1894[1] - _e1906[1]), (_e1894[2] - _e1906[2])), array<f32, 3>((_e1910 - _e1906[0]), (_e1911 - _e1906[1]), (_e1912 - _e1906[2])));
                                            let _e1925 = local_12.member[1u];
                                            let _e1931 = local_12.member_1[1u];
                                            let _e1937 = local_12.member_2[1u];
                                            let _e1941 = (_e1925[0] - _e1931[0]);
                                            let _e1942 = (_e1925[1] - _e1931[1]);
                                            let _e1943 = (_e1925[2] - _e1931[2]);
                                            local_1 = array<array<f32, 3>, 4>(_e1925, array<f32, 3>(_e1941, _e1942, _e1943), array<f32, 3>((_e1925[0] - _e1937[0]), (_e1925[1] - _e1937[1]), (_e1925[2] - _e1937[2])), array<f32, 3>((_e1941 - _e1937[0]), (_e1942 - _e1937[1]), (_e1943 - _e1937[2])));
                                            let _e1956 = local_12.member[0u];
                                            if (_e1956[0] < 0f) {
                                                phi_4606_ = -(_e1956[0]);
                                            } else {
                                                phi_4606_ = _e1956[0];
                                            }
                                            let _e1963 = phi_4606_;
                                            if (_e1956[1] < 0f) {
                                                phi_4613_ = -(_e1956[1]);
                                            } else {
                                                phi_4613_ = _e1956[1];
                                            }
                                            let _e1967 = phi_4613_;
                                            if (_e1963 > _e1967) {
                                                phi_4618_ = _e1963;
                                            } else {
                                                phi_4618_ = _e1967;
                                            }
                                            let _e1970 = phi_4618_;
                                            if (_e1956[2] < 0f) {
                                                phi_4625_ = -(_e1956[2]);
                                            } else {
                                                phi_4625_ = _e1956[2];
                                            }
                                            let _e1974 = phi_4625_;
                                            if (_e1970 > _e1974) {
                                                phi_4630_ = _e1970;
                                            } else {
                                                phi_4630_ = _e1974;
                                            }
                                            let _e1977 = phi_4630_;
                                            let _e1980 = local_12.member[1u];
                                            if (_e1980[0] < 0f) {
                                                phi_4643_ = -(_e1980[0]);
                                            } else {
                                                phi_4643_ = _e1980[0];
                                            }
                                            let _e1987 = phi_4643_;
                                            if (_e1980[1] < 0f) {
                                                phi_4650_ = -(_e1980[1]);
                                            } else {
                                                phi_4650_ = _e1980[1];
                                            }
                                            let _e1991 = phi_4650_;
                                            if (_e1987 > _e1991) {
                                                phi_4655_ = _e1987;
                                            } else {
                                                phi_4655_ = _e1991;
                                            }
                                            let _e1994 = phi_4655_;
                                            if (_e1980[2] < 0f) {
                                                phi_4662_ = -(_e1980[2]);
                                            } else {
                                                phi_4662_ = _e1980[2];
                                            }
                                            let _e1998 = phi_4662_;
                                            if (_e1994 > _e1998) {
                                                phi_4667_ = _e1994;
                                            } else {
                                                phi_4667_ = _e1998;
                                            }
                                            let _e2001 = phi_4667_;
                                            if (_e1977 > _e2001) {
                                                phi_4672_ = _e1977;
                                            } else {
                                                phi_4672_ = _e2001;
                                            }
                                            let _e2004 = phi_4672_;
                                            let _e2006 = local_12.member_3;
                                            let _e2010 = local_12.member_1[0u];
                                            if (_e2010[0] < 0f) {
                                                phi_4689_ = -(_e2010[0]);
                                            } else {
                                                phi_4689_ = _e2010[0];
                                            }
                                            let _e2017 = phi_4689_;
                                            if (_e2010[1] < 0f) {
                                                phi_4696_ = -(_e2010[1]);
                                            } else {
                                                phi_4696_ = _e2010[1];
                                            }
                                            let _e2021 = phi_4696_;
                                            if (_e2017 > _e2021) {
                                                phi_4701_ = _e2017;
                                            } else {
                                                phi_4701_ = _e2021;
                                            }
                                            let _e2024 = phi_4701_;
                                            if (_e2010[2] < 0f) {
                                                phi_4708_ = -(_e2010[2]);
                                            } else {
                                                phi_4708_ = _e2010[2];
                                            }
                                            let _e2028 = phi_4708_;
                                            if (_e2024 > _e2028) {
                                                phi_4713_ = _e2024;
                                            } else {
                                                phi_4713_ = _e2028;
                                            }
                                            let _e2031 = phi_4713_;
                                            let _e2034 = local_12.member_1[1u];
                                            if (_e2034[0] < 0f) {
                                                phi_4727_ = -(_e2034[0]);
                                            } else {
                                                phi_4727_ = _e2034[0];
                                            }
                                            let _e2041 = phi_4727_;
                                            if (_e2034[1] < 0f) {
                                                phi_4734_ = -(_e2034[1]);
                                            } else {
                                                phi_4734_ = _e2034[1];
                                            }
                                            let _e2045 = phi_4734_;
                                            if (_e2041 > _e2045) {
                                                phi_4739_ = _e2041;
                                            } else {
                                                phi_4739_ = _e2045;
                                            }
                                            let _e2048 = phi_4739_;
                                            if (_e2034[2] < 0f) {
                                                phi_4746_ = -(_e2034[2]);
                                            } else {
                                                phi_4746_ = _e2034[2];
                                            }
                                            let _e2052 = phi_4746_;
                                            if (_e2048 > _e2052) {
                                                phi_4751_ = _e2048;
                                            } else {
                                                phi_4751_ = _e2052;
                                            }
                                            let _e2055 = phi_4751_;
                                            if (_e2031 > _e2055) {
                                                phi_4756_ = _e2031;
                                            } else {
                                                phi_4756_ = _e2055;
                                            }
                                            let _e2058 = phi_4756_;
                                            let _e2060 = local_12.member_3;
                                            let _e2064 = local_12.member_2[0u];
                                            if (_e2064[0] < 0f) {
                                                phi_4773_ = -(_e2064[0]);
                                            } else {
                                                phi_4773_ = _e2064[0];
                                            }
                                            let _e2071 = phi_4773_;
                                            if (_e2064[1] < 0f) {
                                                phi_4780_ = -(_e2064[1]);
                                            } else {
                                                phi_4780_ = _e2064[1];
                                            }
                                            let _e2075 = phi_4780_;
                                            if (_e2071 > _e2075) {
                                                phi_4785_ = _e2071;
                                            } else {
                                                phi_4785_ = _e2075;
                                            }
                                            let _e2078 = phi_4785_;
                                            if (_e2064[2] < 0f) {
                                                phi_4792_ = -(_e2064[2]);
                                            } else {
                                                phi_4792_ = _e2064[2];
                                            }
                                            let _e2082 = phi_4792_;
                                            if (_e2078 > _e2082) {
                                                phi_4797_ = _e2078;
                                            } else {
                                                phi_4797_ = _e2082;
                                            }
                                            let _e2085 = phi_4797_;
                                            let _e2088 = local_12.member_2[1u];
                                            if (_e2088[0] < 0f) {
                                                phi_4811_ = -(_e2088[0]);
                                            } else {
                                                phi_4811_ = _e2088[0];
                                            }
                                            let _e2095 = phi_4811_;
                                            if (_e2088[1] < 0f) {
                                                phi_4818_ = -(_e2088[1]);
                                            } else {
                                                phi_4818_ = _e2088[1];
                                            }
                                            let _e2099 = phi_4818_;
                                            if (_e2095 > _e2099) {
                                                phi_4823_ = _e2095;
                                            } else {
                                                phi_4823_ = _e2099;
                                            }
                                            let _e2102 = phi_4823_;
                                            if (_e2088[2] < 0f) {
                                                phi_4830_ = -(_e2088[2]);
                                            } else {
                                                phi_4830_ = _e2088[2];
                                            }
                                            let _e2106 = phi_4830_;
                                            if (_e2102 > _e2106) {
                                                phi_4835_ = _e2102;
                                            } else {
                                                phi_4835_ = _e2106;
                                            }
                                            let _e2109 = phi_4835_;
                                            if (_e2085 > _e2109) {
                                                phi_4840_ = _e2085;
                                            } else {
                                                phi_4840_ = _e2109;
                                            }
                                            let _e2112 = phi_4840_;
                                            let _e2114 = local_12.member_3;
                                            let _e2121 = local_12.member_3;
                                            phi_4856_ = type_19(0u, 48u);
                                            phi_4859_ = _e1174.member;
                                            loop {
                                                let _e2127 = phi_4856_;
                                                let _e2129 = phi_4859_;
                                                local_61 = _e2129;
                                                local_24 = _e2129;
                                                local_25 = _e2129;
                                                local_26 = _e2129;
                                                local_27 = _e2129;
                                                if (_e2127.member < _e2127.member_1) {
                                                    phi_4857_ = type_19((_e2127.member + 1u), _e2127.member_1);
                                                    phi_4882_ = type_19(1u, _e2127.member);
                                                } else {
                                                    phi_4857_ = _e2127;
                                                    phi_4882_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2141 = phi_4857_;
                                                let _e2143 = phi_4882_;
                                                if (bitcast<i32>(_e2143.member) != 0i) {
                                                    let _e2149 = local_12.member[0u];
                                                    let _e2155 = local_12.member[1u];
                                                    let _e2171 = local_12.member_1[0u];
                                                    let _e2177 = local_12.member_1[1u];
                                                    let _e2193 = local_12.member_2[0u];
                                                    let _e2199 = local_12.member_2[1u];
                                                    let _e2213 = function_2(array<f32, 3>((_e2149[0] + ((_e2155[0] - _e2149[0]) * _e2129)), (_e2149[1] + ((_e2155[1] - _e2149[1]) * _e2129)), (_e2149[2] + ((_e2155[2] - _e2149[2]) * _e2129))), array<f32, 3>((_e2171[0] + ((_e2177[0] - _e2171[0]) * _e2129)), (_e2171[1] + ((_e2177[1] - _e2171[1]) * _e2129)), (_e2171[2] + ((_e2177[2] - _e2171[2]) * _e2129))), array<f32, 3>((_e2193[0] + ((_e2199[0] - _e2193[0]) * _e2129)), (_e2193[1] + ((_e2199[1] - _e2193[1]) * _e2129)), (_e2193[2] + ((_e2199[2] - _e2193[2]) * _e2129))), 1u);
                                                    if (_e2213[0] < 0f) {
                                                        phi_4993_ = -(_e2213[0]);
                                                    } else {
                                                        phi_4993_ = _e2213[0];
                                                    }
                                                    let _e2218 = phi_4993_;
                                                    if (_e2213[1] < 0f) {
                                                        phi_5000_ = -(_e2213[1]);
                                                    } else {
                                                        phi_5000_ = _e2213[1];
                                                    }
                                                    let _e2223 = phi_5000_;
                                                    if (_e2213[2] < 0f) {
                                                        phi_5008_ = -(_e2213[2]);
                                                    } else {
                                                        phi_5008_ = _e2213[2];
                                                    }
                                                    let _e2229 = phi_5008_;
                                                    let _e2230 = ((_e2218 + _e2223) + _e2229);
                                                    if (_e2230 > 0f) {
                                                        if ((bitcast<u32>(_e2230) & 2139095040u) != 2139095040u) {
                                                            let _e2235 = (1f / _e2230);
                                                            let _e2237 = (_e2213[0] * _e2235);
                                                            let _e2239 = (_e2213[1] * _e2235);
                                                            let _e2241 = (_e2213[2] * _e2235);
                                                            let _e2246 = (((_e2237 * _e2237) + (_e2239 * _e2239)) + (_e2241 * _e2241));
                                                            if (_e2246 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2246 > 0f) {
                                                                    phi_5045_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_5045_ = 0f;
                                                                }
                                                                let _e2299 = phi_5045_;
                                                                phi_5109_ = _e2299;
                                                            } else {
                                                                phi_5052_ = type_17(0i, 5i);
                                                                phi_5055_ = bitcast<f32>(((bitcast<u32>(_e2246) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2254 = phi_5052_;
                                                                    let _e2256 = phi_5055_;
                                                                    local_18 = _e2256;
                                                                    if (_e2254.member < _e2254.member_1) {
                                                                        let _e2263 = (_e2254.member + 1i);
                                                                        if ((false == (_e2263 > _e2254.member)) != false) {
                                                                            phi_5076_ = true;
                                                                        } else {
                                                                            phi_5076_ = false;
                                                                        }
                                                                        let _e2268 = phi_5076_;
                                                                        if _e2268 {
                                                                            phi_5082_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_5082_ = type_18(1u, _e2263);
                                                                        }
                                                                        let _e2273 = phi_5082_;
                                                                        phi_5053_ = type_17(_e2273.member_1, _e2254.member_1);
                                                                        phi_5096_ = type_18(1u, _e2254.member);
                                                                    } else {
                                                                        phi_5053_ = _e2254;
                                                                        phi_5096_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2279 = phi_5053_;
                                                                    let _e2281 = phi_5096_;
                                                                    let _e2284 = (bitcast<i32>(_e2281.member) != 0i);
                                                                    if _e2284 {
                                                                        phi_5056_ = (0.5f * (_e2256 + (_e2246 / _e2256)));
                                                                    } else {
                                                                        phi_5056_ = f32();
                                                                    }
                                                                    let _e2289 = phi_5056_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_5052_ = _e2279;
                                                                        phi_5055_ = _e2289;
                                                                        break if !(_e2284);
                                                                    }
                                                                }
                                                                let _e2294 = local_18;
                                                                phi_5109_ = (_e2294 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2301 = phi_5109_;
                                                            phi_5118_ = type_19(0u, 4u);
                                                            phi_5121_ = 2f;
                                                            loop {
                                                                let _e2309 = phi_5118_;
                                                                let _e2311 = phi_5121_;
                                                                local_20 = _e2311;
                                                                local_21 = _e2311;
                                                                local_22 = _e2311;
                                                                local_51 = _e2311;
                                                                local_52 = _e2311;
                                                                if (_e2309.member < _e2309.member_1) {
                                                                    phi_5119_ = type_19((_e2309.member + 1u), _e2309.member_1);
                                                                    phi_5144_ = type_19(1u, _e2309.member);
                                                                } else {
                                                                    phi_5119_ = _e2309;
                                                                    phi_5144_ = type_19(0u, type_19().member_1);
                                                                }
                                                                let _e2323 = phi_5119_;
                                                                let _e2325 = phi_5144_;
                                                                if (bitcast<i32>(_e2325.member) != 0i) {
                                                                    let _e2331 = local[_e2325.member_1];
                                                                    let _e2339 = (((_e2237 * _e2331[0]) + (_e2239 * _e2331[1])) + (_e2241 * _e2331[2]));
                                                                    let _e2341 = local_1[_e2325.member_1];
                                                                    let _e2349 = (((_e2237 * _e2341[0]) + (_e2239 * _e2341[1])) + (_e2241 * _e2341[2]));
                                                                    if (_e2339 < 0f) {
                                                                        phi_5195_ = -(_e2339);
                                                                    } else {
                                                                        phi_5195_ = _e2339;
                                                                    }
                                                                    let _e2353 = phi_5195_;
                                                                    if (_e2349 < 0f) {
                                                                        phi_5201_ = -(_e2349);
                                                                    } else {
                                                                        phi_5201_ = _e2349;
                                                                    }
                                                                    let _e2357 = phi_5201_;
                                                                    let _e2361 = (((((((((_e2004 + _e2006) + (_e2058 + _e2060)) + (_e2112 + _e2114)) * (0.000000059604645f * 16f)) + (_e2121 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2301) * (1f + (0.000000059604645f * 8f)))) + ((_e2353 + _e2357) * (0.000000059604645f * 8f)));
                                                                    if (_e2339 > _e2361) {
                                                                        if (_e2349 > _e2361) {
                                                                            phi_5214_ = false;
                                                                        } else {
                                                                            phi_5214_ = true;
                                                                        }
                                                                        let _e2365 = phi_5214_;
                                                                        phi_5215_ = _e2365;
                                                                    } else {
                                                                        phi_5215_ = true;
                                                                    }
                                                                    let _e2367 = phi_5215_;
                                                                    if _e2367 {
                                                                        if ((_e2339 + ((_e2349 - _e2339) * _e2129)) > _e2361) {
                                                                            if (_e2349 < _e2339) {
                                                                                let _e2375 = ((_e2339 - _e2349) <= (0.25f / 0.000000000000000000000000000000000000011754944f));
                                                                                if _e2375 {
                                                                                    let _e2381 = (((_e2339 - _e2361) / (_e2339 - _e2349)) * (1f - (0.000000059604645f * 16f)));
                                                                                    if (_e2311 < _e2381) {
                                                                                        phi_5246_ = _e2311;
                                                                                    } else {
                                                                                        phi_5246_ = _e2381;
                                                                                    }
                                                                                    let _e2384 = phi_5246_;
                                                                                    phi_5247_ = _e2384;
                                                                                } else {
                                                                                    phi_5247_ = f32();
                                                                                }
                                                                                let _e2386 = phi_5247_;
                                                                                phi_5248_ = _e2386;
                                                                                phi_5249_ = _e2375;
                                                                            } else {
                                                                                phi_5248_ = _e2311;
                                                                                phi_5249_ = true;
                                                                            }
                                                                            let _e2388 = phi_5248_;
                                                                            let _e2390 = phi_5249_;
                                                                            if _e2390 {
                                                                                phi_5253_ = false;
                                                                            } else {
                                                                                phi_5253_ = true;
                                                                            }
                                                                            let _e2392 = phi_5253_;
                                                                            phi_5254_ = _e2388;
                                                                            phi_5255_ = _e2390;
                                                                            phi_5256_ = _e2392;
                                                                            phi_5257_ = false;
                                                                        } else {
                                                                            phi_5254_ = f32();
                                                                            phi_5255_ = false;
                                                                            phi_5256_ = false;
                                                                            phi_5257_ = true;
                                                                        }
                                                                        let _e2394 = phi_5254_;
                                                                        let _e2396 = phi_5255_;
                                                                        let _e2398 = phi_5256_;
                                                                        let _e2400 = phi_5257_;
                                                                        phi_5258_ = _e2394;
                                                                        phi_5259_ = _e2396;
                                                                        phi_5260_ = _e2398;
                                                                        phi_5261_ = _e2400;
                                                                    } else {
                                                                        phi_5258_ = _e2311;
                                                                        phi_5259_ = true;
                                                                        phi_5260_ = false;
                                                                        phi_5261_ = false;
                                                                    }
                                                                    let _e2402 = phi_5258_;
                                                                    let _e2404 = phi_5259_;
                                                                    let _e2406 = phi_5260_;
                                                                    let _e2408 = phi_5261_;
                                                                    phi_5122_ = _e2402;
                                                                    phi_5262_ = _e2404;
                                                                    phi_5263_ = false;
                                                                    phi_5264_ = _e2406;
                                                                    phi_5265_ = _e2408;
                                                                } else {
                                                                    phi_5122_ = f32();
                                                                    phi_5262_ = false;
                                                                    phi_5263_ = true;
                                                                    phi_5264_ = false;
                                                                    phi_5265_ = false;
                                                                }
                                                                let _e2410 = phi_5122_;
                                                                let _e2412 = phi_5262_;
                                                                let _e2414 = phi_5263_;
                                                                let _e2416 = phi_5264_;
                                                                let _e2418 = phi_5265_;
                                                                local_19 = _e2414;
                                                                local_49 = _e2416;
                                                                local_50 = _e2418;
                                                                continue;
                                                                continuing {
                                                                    phi_5118_ = _e2323;
                                                                    phi_5121_ = _e2410;
                                                                    break if !(_e2412);
                                                                }
                                                            }
                                                            let _e2421 = local_19;
                                                            if _e2421 {
                                                                let _e2423 = local_20;
                                                                let _e2424 = (_e2423 > _e1174.member_1);
                                                                if _e2424 {
                                                                    phi_5286_ = false;
                                                                    phi_5287_ = false;
                                                                    phi_5288_ = false;
                                                                } else {
                                                                    let _e2426 = local_21;
                                                                    if (_e2426 > _e2129) {
                                                                        let _e2429 = local_22;
                                                                        let _e2431 = ((_e2429 - _e2129) < 0.00000000023283064f);
                                                                        if _e2431 {
                                                                            phi_5282_ = false;
                                                                        } else {
                                                                            phi_5282_ = true;
                                                                        }
                                                                        let _e2433 = phi_5282_;
                                                                        phi_5283_ = _e2433;
                                                                        phi_5284_ = _e2431;
                                                                        phi_5285_ = false;
                                                                    } else {
                                                                        phi_5283_ = false;
                                                                        phi_5284_ = false;
                                                                        phi_5285_ = true;
                                                                    }
                                                                    let _e2435 = phi_5283_;
                                                                    let _e2437 = phi_5284_;
                                                                    let _e2439 = phi_5285_;
                                                                    phi_5286_ = _e2435;
                                                                    phi_5287_ = _e2437;
                                                                    phi_5288_ = _e2439;
                                                                }
                                                                let _e2441 = phi_5286_;
                                                                let _e2443 = phi_5287_;
                                                                let _e2445 = phi_5288_;
                                                                phi_5289_ = _e2441;
                                                                phi_5290_ = _e2424;
                                                                phi_5291_ = _e2443;
                                                                phi_5292_ = _e2445;
                                                                phi_5293_ = false;
                                                                phi_5294_ = false;
                                                            } else {
                                                                phi_5289_ = false;
                                                                phi_5290_ = false;
                                                                phi_5291_ = false;
                                                                phi_5292_ = false;
                                                                let _e4321 = local_49;
                                                                phi_5293_ = _e4321;
                                                                let _e4324 = local_50;
                                                                phi_5294_ = _e4324;
                                                            }
                                                            let _e2447 = phi_5289_;
                                                            let _e2449 = phi_5290_;
                                                            let _e2451 = phi_5291_;
                                                            let _e2453 = phi_5292_;
                                                            let _e2455 = phi_5293_;
                                                            let _e2457 = phi_5294_;
                                                            let _e4327 = local_51;
                                                            phi_5295_ = _e4327;
                                                            let _e4330 = local_52;
                                                            phi_5296_ = _e4330;
                                                            phi_5297_ = _e2447;
                                                            phi_5298_ = _e2449;
                                                            phi_5299_ = _e2451;
                                                            phi_5300_ = _e2453;
                                                            phi_5301_ = _e2455;
                                                            phi_5302_ = _e2457;
                                                            phi_5303_ = false;
                                                        } else {
                                                            phi_5295_ = f32();
                                                            phi_5296_ = f32();
                                                            phi_5297_ = false;
                                                            phi_5298_ = false;
                                                            phi_5299_ = false;
                                                            phi_5300_ = false;
                                                            phi_5301_ = false;
                                                            phi_5302_ = false;
                                                            phi_5303_ = true;
                                                        }
                                                        let _e2459 = phi_5295_;
                                                        let _e2461 = phi_5296_;
                                                        let _e2463 = phi_5297_;
                                                        let _e2465 = phi_5298_;
                                                        let _e2467 = phi_5299_;
                                                        let _e2469 = phi_5300_;
                                                        let _e2471 = phi_5301_;
                                                        let _e2473 = phi_5302_;
                                                        let _e2475 = phi_5303_;
                                                        phi_5304_ = _e2459;
                                                        phi_5305_ = _e2461;
                                                        phi_5306_ = _e2463;
                                                        phi_5307_ = _e2465;
                                                        phi_5308_ = _e2467;
                                                        phi_5309_ = _e2469;
                                                        phi_5310_ = _e2471;
                                                        phi_5311_ = _e2473;
                                                        phi_5312_ = _e2475;
                                                        phi_5313_ = false;
                                                    } else {
                                                        phi_5304_ = f32();
                                                        phi_5305_ = f32();
                                                        phi_5306_ = false;
                                                        phi_5307_ = false;
                                                        phi_5308_ = false;
                                                        phi_5309_ = false;
                                                        phi_5310_ = false;
                                                        phi_5311_ = false;
                                                        phi_5312_ = false;
                                                        phi_5313_ = true;
                                                    }
                                                    let _e2477 = phi_5304_;
                                                    let _e2479 = phi_5305_;
                                                    let _e2481 = phi_5306_;
                                                    let _e2483 = phi_5307_;
                                                    let _e2485 = phi_5308_;
                                                    let _e2487 = phi_5309_;
                                                    let _e2489 = phi_5310_;
                                                    let _e2491 = phi_5311_;
                                                    let _e2493 = phi_5312_;
                                                    let _e2495 = phi_5313_;
                                                    phi_5314_ = _e2477;
                                                    phi_4860_ = _e2479;
                                                    phi_5315_ = _e2481;
                                                    phi_5316_ = _e2483;
                                                    phi_5317_ = _e2485;
                                                    phi_5318_ = false;
                                                    phi_5319_ = _e2487;
                                                    phi_5320_ = _e2489;
                                                    phi_5321_ = _e2491;
                                                    phi_5322_ = _e2493;
                                                    phi_5323_ = _e2495;
                                                } else {
                                                    phi_5314_ = f32();
                                                    phi_4860_ = f32();
                                                    phi_5315_ = false;
                                                    phi_5316_ = false;
                                                    phi_5317_ = false;
                                                    phi_5318_ = true;
                                                    phi_5319_ = false;
                                                    phi_5320_ = false;
                                                    phi_5321_ = false;
                                                    phi_5322_ = false;
                                                    phi_5323_ = false;
                                                }
                                                let _e2497 = phi_5314_;
                                                let _e2499 = phi_4860_;
                                                let _e2501 = phi_5315_;
                                                let _e2503 = phi_5316_;
                                                let _e2505 = phi_5317_;
                                                let _e2507 = phi_5318_;
                                                let _e2509 = phi_5319_;
                                                let _e2511 = phi_5320_;
                                                let _e2513 = phi_5321_;
                                                let _e2515 = phi_5322_;
                                                let _e2517 = phi_5323_;
                                                local_23 = _e2503;
                                                local_53 = _e2505;
                                                local_54 = _e2507;
                                                local_55 = _e2509;
                                                local_56 = _e2511;
                                                local_57 = _e2513;
                                                local_58 = _e2515;
                                                local_59 = _e2517;
                                                local_60 = _e2497;
                                                local_62 = _e2503;
                                                continue;
                                                continuing {
                                                    phi_4856_ = _e2141;
                                                    phi_4859_ = _e2499;
                                                    break if !(_e2501);
                                                }
                                            }
                                            let _e2520 = local_23;
                                            if _e2520 {
                                                phi_5328_ = type_32(0u, type_32().member_1);
                                                phi_5329_ = false;
                                                phi_5330_ = false;
                                                phi_5331_ = false;
                                                phi_5332_ = false;
                                                phi_5333_ = false;
                                                phi_5334_ = false;
                                                phi_5335_ = false;
                                            } else {
                                                phi_5328_ = type_32();
                                                let _e4363 = local_53;
                                                phi_5329_ = _e4363;
                                                let _e4366 = local_54;
                                                phi_5330_ = _e4366;
                                                let _e4369 = local_55;
                                                phi_5331_ = _e4369;
                                                let _e4372 = local_56;
                                                phi_5332_ = _e4372;
                                                let _e4375 = local_57;
                                                phi_5333_ = _e4375;
                                                let _e4378 = local_58;
                                                phi_5334_ = _e4378;
                                                let _e4381 = local_59;
                                                phi_5335_ = _e4381;
                                            }
                                            let _e2524 = phi_5328_;
                                            let _e2526 = phi_5329_;
                                            let _e2528 = phi_5330_;
                                            let _e2530 = phi_5331_;
                                            let _e2532 = phi_5332_;
                                            let _e2534 = phi_5333_;
                                            let _e2536 = phi_5334_;
                                            let _e2538 = phi_5335_;
                                            if _e2526 {
                                                let _e4384 = local_60;
                                                phi_5339_ = _e4384;
                                                phi_5340_ = true;
                                                phi_5341_ = false;
                                                phi_5342_ = false;
                                                phi_5343_ = false;
                                                phi_5344_ = false;
                                                phi_5345_ = false;
                                                phi_5346_ = false;
                                            } else {
                                                let _e4386 = local_61;
                                                phi_5339_ = _e4386;
                                                phi_5340_ = _e2528;
                                                phi_5341_ = _e2530;
                                                phi_5342_ = _e2532;
                                                phi_5343_ = _e2534;
                                                let _e4393 = local_62;
                                                phi_5344_ = _e4393;
                                                phi_5345_ = _e2536;
                                                phi_5346_ = _e2538;
                                            }
                                            let _e2540 = phi_5339_;
                                            let _e2542 = phi_5340_;
                                            let _e2544 = phi_5341_;
                                            let _e2546 = phi_5342_;
                                            let _e2548 = phi_5343_;
                                            let _e2550 = phi_5344_;
                                            let _e2552 = phi_5345_;
                                            let _e2554 = phi_5346_;
                                            if _e2542 {
                                                phi_5351_ = type_32(1u, _e2540);
                                                phi_5352_ = false;
                                                phi_5353_ = false;
                                                phi_5354_ = false;
                                                phi_5355_ = false;
                                                phi_5356_ = false;
                                                phi_5357_ = false;
                                            } else {
                                                phi_5351_ = type_32();
                                                phi_5352_ = _e2544;
                                                phi_5353_ = _e2546;
                                                phi_5354_ = _e2548;
                                                phi_5355_ = _e2550;
                                                phi_5356_ = _e2552;
                                                phi_5357_ = _e2554;
                                            }
                                            let _e2557 = phi_5351_;
                                            let _e2559 = phi_5352_;
                                            let _e2561 = phi_5353_;
                                            let _e2563 = phi_5354_;
                                            let _e2565 = phi_5355_;
                                            let _e2567 = phi_5356_;
                                            let _e2569 = phi_5357_;
                                            if _e2559 {
                                                let _e2571 = local_24;
                                                phi_5362_ = type_32(1u, _e2571);
                                                phi_5363_ = false;
                                                phi_5364_ = false;
                                                phi_5365_ = true;
                                                phi_5366_ = false;
                                                phi_5367_ = false;
                                            } else {
                                                phi_5362_ = _e2524;
                                                phi_5363_ = _e2561;
                                                phi_5364_ = _e2563;
                                                phi_5365_ = _e2565;
                                                phi_5366_ = _e2567;
                                                phi_5367_ = _e2569;
                                            }
                                            let _e2574 = phi_5362_;
                                            let _e2576 = phi_5363_;
                                            let _e2578 = phi_5364_;
                                            let _e2580 = phi_5365_;
                                            let _e2582 = phi_5366_;
                                            let _e2584 = phi_5367_;
                                            if _e2576 {
                                                let _e2586 = local_25;
                                                phi_5372_ = type_32(1u, _e2586);
                                                phi_5373_ = false;
                                                phi_5374_ = false;
                                                phi_5375_ = false;
                                                phi_5376_ = false;
                                            } else {
                                                phi_5372_ = type_32();
                                                phi_5373_ = _e2578;
                                                phi_5374_ = _e2580;
                                                phi_5375_ = _e2582;
                                                phi_5376_ = _e2584;
                                            }
                                            let _e2589 = phi_5372_;
                                            let _e2591 = phi_5373_;
                                            let _e2593 = phi_5374_;
                                            let _e2595 = phi_5375_;
                                            let _e2597 = phi_5376_;
                                            if _e2591 {
                                                let _e2599 = local_26;
                                                phi_5381_ = type_32(1u, _e2599);
                                                phi_5382_ = true;
                                                phi_5383_ = false;
                                                phi_5384_ = false;
                                                phi_5385_ = false;
                                            } else {
                                                phi_5381_ = _e2589;
                                                phi_5382_ = _e2576;
                                                phi_5383_ = _e2593;
                                                phi_5384_ = _e2595;
                                                phi_5385_ = _e2597;
                                            }
                                            let _e2602 = phi_5381_;
                                            let _e2604 = phi_5382_;
                                            let _e2606 = phi_5383_;
                                            let _e2608 = phi_5384_;
                                            let _e2610 = phi_5385_;
                                            if _e2604 {
                                                phi_5389_ = _e2602;
                                                phi_5390_ = true;
                                                phi_5391_ = false;
                                                phi_5392_ = false;
                                            } else {
                                                phi_5389_ = _e2574;
                                                phi_5390_ = _e2606;
                                                phi_5391_ = _e2608;
                                                phi_5392_ = _e2610;
                                            }
                                            let _e2612 = phi_5389_;
                                            let _e2614 = phi_5390_;
                                            let _e2616 = phi_5391_;
                                            let _e2618 = phi_5392_;
                                            if _e2614 {
                                                phi_5396_ = false;
                                                phi_5397_ = false;
                                            } else {
                                                phi_5396_ = _e2616;
                                                phi_5397_ = _e2618;
                                            }
                                            let _e2620 = phi_5396_;
                                            let _e2622 = phi_5397_;
                                            if _e2620 {
                                                phi_5401_ = false;
                                                phi_5402_ = false;
                                            } else {
                                                phi_5401_ = _e2622;
                                                phi_5402_ = _e2614;
                                            }
                                            let _e2624 = phi_5401_;
                                            let _e2626 = phi_5402_;
                                            if _e2624 {
                                                phi_5406_ = true;
                                                phi_5407_ = false;
                                            } else {
                                                phi_5406_ = _e2620;
                                                phi_5407_ = _e2626;
                                            }
                                            let _e2628 = phi_5406_;
                                            let _e2630 = phi_5407_;
                                            if _e2628 {
                                                let _e2632 = local_27;
                                                phi_5412_ = type_32(1u, _e2632);
                                                phi_5413_ = true;
                                            } else {
                                                phi_5412_ = _e2612;
                                                phi_5413_ = _e2630;
                                            }
                                            let _e2635 = phi_5412_;
                                            let _e2637 = phi_5413_;
                                            if _e2637 {
                                                phi_5417_ = _e2635;
                                            } else {
                                                phi_5417_ = _e2557;
                                            }
                                            let _e2639 = phi_5417_;
                                            let _e2642 = (_e2639.member != 0u);
                                            if _e2642 {
                                                phi_5424_ = false;
                                            } else {
                                                phi_5424_ = true;
                                            }
                                            let _e2644 = phi_5424_;
                                            phi_5425_ = _e2639.member_1;
                                            phi_5426_ = _e2644;
                                            phi_5427_ = _e2642;
                                            phi_5428_ = false;
                                        } else {
                                            phi_5425_ = f32();
                                            phi_5426_ = false;
                                            phi_5427_ = false;
                                            phi_5428_ = true;
                                        }
                                        let _e2646 = phi_5425_;
                                        let _e2648 = phi_5426_;
                                        let _e2650 = phi_5427_;
                                        let _e2652 = phi_5428_;
                                        phi_5429_ = _e2646;
                                        phi_5430_ = _e2648;
                                        phi_5431_ = _e2650;
                                        phi_5432_ = _e2652;
                                    }
                                    let _e2654 = phi_5429_;
                                    let _e2656 = phi_5430_;
                                    let _e2658 = phi_5431_;
                                    let _e2660 = phi_5432_;
                                    phi_5433_ = _e2654;
                                    phi_5434_ = _e1877;
                                    phi_5435_ = _e2656;
                                    phi_5436_ = _e2658;
                                    phi_5437_ = _e2660;
                                }
                                let _e2662 = phi_5433_;
                                let _e2664 = phi_5434_;
                                let _e2666 = phi_5435_;
                                let _e2668 = phi_5436_;
                                let _e2670 = phi_5437_;
                                if _e2664 {
                                    phi_5441_ = true;
                                    phi_5442_ = false;
                                    phi_5443_ = false;
                                } else {
                                    phi_5441_ = _e2666;
                                    phi_5442_ = _e2668;
                                    phi_5443_ = _e2670;
                                }
                                let _e2672 = phi_5441_;
                                let _e2674 = phi_5442_;
                                let _e2676 = phi_5443_;
                                phi_5444_ = _e2662;
                                phi_5445_ = _e1174;
                                phi_5446_ = _e2672;
                                phi_5447_ = false;
                                phi_5448_ = _e2674;
                                phi_5449_ = _e2676;
                            } else {
                                phi_5444_ = f32();
                                phi_5445_ = type_33();
                                phi_5446_ = false;
                                phi_5447_ = true;
                                phi_5448_ = false;
                                phi_5449_ = false;
                            }
                            let _e2678 = phi_5444_;
                            let _e2680 = phi_5445_;
                            let _e2682 = phi_5446_;
                            let _e2684 = phi_5447_;
                            let _e2686 = phi_5448_;
                            let _e2688 = phi_5449_;
                            local_28 = _e2684;
                            local_63 = _e2686;
                            local_64 = _e2688;
                            local_29 = _e2678;
                            local_30 = _e2680;
                            continue;
                            continuing {
                                phi_2943_ = _e879;
                                break if !(_e2682);
                            }
                        }
                        let _e2691 = local_28;
                        if _e2691 {
                            phi_5454_ = type_32(0u, type_32().member_1);
                            phi_5455_ = false;
                            phi_5456_ = false;
                        } else {
                            phi_5454_ = type_32();
                            let _e4463 = local_63;
                            phi_5455_ = _e4463;
                            let _e4466 = local_64;
                            phi_5456_ = _e4466;
                        }
                        let _e2695 = phi_5454_;
                        let _e2697 = phi_5455_;
                        let _e2699 = phi_5456_;
                        if _e2697 {
                            let _e2701 = local_29;
                            phi_5461_ = type_32(2u, _e2701);
                            phi_5462_ = false;
                        } else {
                            phi_5461_ = type_32();
                            phi_5462_ = _e2699;
                        }
                        let _e2704 = phi_5461_;
                        let _e2706 = phi_5462_;
                        if _e2706 {
                            let _e2708 = local_30;
                            phi_5468_ = type_32(1u, _e2708.member);
                            phi_5469_ = true;
                        } else {
                            phi_5468_ = _e2704;
                            phi_5469_ = _e2697;
                        }
                        let _e2712 = phi_5468_;
                        let _e2714 = phi_5469_;
                        if _e2714 {
                            phi_5473_ = _e2712;
                        } else {
                            phi_5473_ = _e2695;
                        }
                        let _e2716 = phi_5473_;
                        phi_5477_ = _e2716;
                    }
                    let _e3840 = phi_5477_;
                    phi_5478_ = _e3840;
                }
                let _e3844 = phi_5478_;
                switch bitcast<i32>(_e3844.member) {
                    case 0: {
                        phi_5491_ = type_34(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e3850 = function_(_e3844.member_1);
                        phi_5491_ = type_34(0u, _e3850, true);
                        break;
                    }
                    case 2: {
                        let _e3848 = function_(_e3844.member_1);
                        phi_5491_ = type_34(1u, _e3848, true);
                        break;
                    }
                    default: {
                        phi_5491_ = type_34();
                        break;
                    }
                }
                let _e3853 = phi_5491_;
                if _e3853.member_2 {
                    phi_5498_ = (_e3853.member == 0u);
                } else {
                    phi_5498_ = false;
                }
                let _e3858 = phi_5498_;
                if _e3858 {
                    let _e3866 = (_e3853.member_1[1] >> bitcast<u32>(20i));
                    if (_e3866 <= 896u) {
                        phi_5522_ = 0u;
                    } else {
                        phi_5522_ = ((((_e3866 - 896u) << bitcast<u32>(23i)) | ((_e3853.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e3853.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e3881 = phi_5522_;
                    let _e3883 = atomicMin((&earliest.member[0u]), _e3881);
                }
                phi_5526_ = type_27(_e161, 0u, _e167, _e170, _e3853.member_1);
                phi_5527_ = _e3858;
                phi_5528_ = (_e3853.member != 0u);
            } else {
                phi_5526_ = type_27(_e161, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_5527_ = false;
                phi_5528_ = false;
            }
            let _e3885 = phi_5526_;
            let _e3887 = phi_5527_;
            let _e3889 = phi_5528_;
            let _e3891 = params.member.member_1;
            if ((_e3891 & 16u) != 0u) {
                if (_e94 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e3887 {
                    let _e3897 = atomicAdd((&counters[0u]), 1u);
                    phi_5546_ = _e3897;
                } else {
                    phi_5546_ = 0u;
                }
                let _e3899 = phi_5546_;
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
                if _e3887 {
                    let _e3911 = params.member.member_16;
                    if (_e3909 < _e3911) {
                        let _e3913 = (6u * _e3909);
                        atomicStore((&contacts.member[(4u + _e3913)]), _e3885.member);
                        atomicStore((&contacts.member[(_e3913 + 5u)]), _e3885.member_1);
                        atomicStore((&contacts.member[(_e3913 + 6u)]), _e3885.member_2);
                        atomicStore((&contacts.member[(_e3913 + 7u)]), _e3885.member_3);
                        atomicStore((&contacts.member[(_e3913 + 8u)]), _e3885.member_4[0]);
                        atomicStore((&contacts.member[(_e3913 + 9u)]), _e3885.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e94 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e3889 {
                let _e3937 = atomicAdd((&counters[0u]), 1u);
                phi_5608_ = _e3937;
            } else {
                phi_5608_ = 0u;
            }
            let _e3939 = phi_5608_;
            workgroupBarrier();
            if (_e94 == 0u) {
                let _e3942 = atomicLoad((&counters[0u]));
                if (_e3942 > 0u) {
                    let _e3945 = atomicAdd((&undecided.member[0u]), _e3942);
                    atomicStore((&counters[1u]), _e3945);
                }
            }
            workgroupBarrier();
            let _e3948 = atomicLoad((&counters[1u]));
            let _e3949 = (_e3948 + _e3939);
            if _e3889 {
                atomicStore((&undecided.member[(4u + (2u * _e3949))]), _e3885.member_2);
                atomicStore((&undecided.member[((2u * _e3949) + 5u)]), _e3885.member_3);
            }
        }
        continue;
        continuing {
            phi_248_ = _e149;
            break if !(_e155);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
