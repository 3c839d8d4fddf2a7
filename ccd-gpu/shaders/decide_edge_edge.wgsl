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

struct type_30 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_31 {
    member: f32,
    member_1: f32,
}

struct type_34 {
    member: type_28,
    member_1: f32,
}

struct type_35 {
    member: u32,
    member_1: f32,
}

struct type_37 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_38 {
    member: u32,
    member_1: array<u32, 2>,
    member_2: bool,
}

struct type_41 {
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
var<storage, read_write> contacts: type_41;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_41;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_41;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(param: f32) -> array<u32, 2> {
    var phi_8633_: array<u32, 2>;
    var phi_8634_: array<u32, 2>;
    var phi_8635_: bool;
    var phi_8639_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_8634_ = array<u32, 2>();
        phi_8635_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_8633_ = array<u32, 2>();
        } else {
            phi_8633_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_8633_;
        phi_8634_ = _e31;
        phi_8635_ = _e17;
    }
    let _e33 = phi_8634_;
    let _e35 = phi_8635_;
    if _e35 {
        phi_8639_ = array<u32, 2>(0u, 0u);
    } else {
        phi_8639_ = _e33;
    }
    let _e37 = phi_8639_;
    return _e37;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_8612_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_8612_ = param_2;
    } else {
        phi_8612_ = param_1;
    }
    let _e26 = phi_8612_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_8204_: bool;
    var phi_8205_: bool;
    var phi_8206_: bool;
    var phi_8207_: bool;
    var phi_8211_: bool;
    var phi_8184_: bool;
    var phi_8185_: bool;
    var phi_8186_: bool;
    var phi_8187_: bool;
    var phi_8188_: bool;
    var phi_8189_: bool;
    var phi_8193_: bool;
    var phi_8212_: bool;
    var phi_8242_: array<f32, 3>;
    var phi_8243_: bool;
    var phi_8244_: array<f32, 3>;
    var phi_8245_: bool;
    var phi_8472_: f32;
    var phi_8473_: f32;
    var phi_8512_: f32;
    var phi_8513_: f32;
    var phi_8558_: f32;
    var phi_8559_: f32;
    var phi_8293_: f32;
    var phi_8294_: f32;
    var phi_8339_: f32;
    var phi_8340_: f32;
    var phi_8382_: f32;
    var phi_8383_: f32;
    var phi_8431_: f32;
    var phi_8432_: f32;
    var phi_8574_: array<array<f32, 3>, 4>;
    var phi_8582_: array<f32, 3>;

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
                    phi_8184_ = (_e76 <= 1f);
                    phi_8185_ = false;
                } else {
                    phi_8184_ = bool();
                    phi_8185_ = true;
                }
                let _e97 = phi_8184_;
                let _e99 = phi_8185_;
                phi_8186_ = _e97;
                phi_8187_ = _e99;
            } else {
                phi_8186_ = bool();
                phi_8187_ = true;
            }
            let _e101 = phi_8186_;
            let _e103 = phi_8187_;
            phi_8188_ = _e101;
            phi_8189_ = _e103;
        } else {
            phi_8188_ = bool();
            phi_8189_ = true;
        }
        let _e105 = phi_8188_;
        let _e107 = phi_8189_;
        if _e107 {
            phi_8193_ = false;
        } else {
            phi_8193_ = _e105;
        }
        let _e109 = phi_8193_;
        phi_8212_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_8204_ = ((_e72 + _e76) <= 1f);
                phi_8205_ = false;
            } else {
                phi_8204_ = bool();
                phi_8205_ = true;
            }
            let _e83 = phi_8204_;
            let _e85 = phi_8205_;
            phi_8206_ = _e83;
            phi_8207_ = _e85;
        } else {
            phi_8206_ = bool();
            phi_8207_ = true;
        }
        let _e87 = phi_8206_;
        let _e89 = phi_8207_;
        if _e89 {
            phi_8211_ = false;
        } else {
            phi_8211_ = _e87;
        }
        let _e91 = phi_8211_;
        phi_8212_ = _e91;
    }
    let _e111 = phi_8212_;
    if (_e68 > 0f) {
        if _e111 {
            phi_8242_ = array<f32, 3>((param_3[0] - ((param_4[0] * _e72) + (param_5[0] * _e76))), (param_3[1] - ((param_4[1] * _e72) + (param_5[1] * _e76))), (param_3[2] - ((param_4[2] * _e72) + (param_5[2] * _e76))));
            phi_8243_ = false;
        } else {
            phi_8242_ = array<f32, 3>();
            phi_8243_ = true;
        }
        let _e136 = phi_8242_;
        let _e138 = phi_8243_;
        phi_8244_ = _e136;
        phi_8245_ = _e138;
    } else {
        phi_8244_ = array<f32, 3>();
        phi_8245_ = true;
    }
    let _e140 = phi_8244_;
    let _e142 = phi_8245_;
    if _e142 {
        let _e145 = (param_3[0] - param_4[0]);
        let _e148 = (param_3[1] - param_4[1]);
        let _e151 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e293 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_8293_ = _e293;
                } else {
                    phi_8293_ = 1f;
                }
                let _e297 = phi_8293_;
                phi_8294_ = _e297;
            } else {
                phi_8294_ = 0f;
            }
            let _e299 = phi_8294_;
            let _e335 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_8339_ = _e335;
                } else {
                    phi_8339_ = 1f;
                }
                let _e339 = phi_8339_;
                phi_8340_ = _e339;
            } else {
                phi_8340_ = 0f;
            }
            let _e341 = phi_8340_;
            let _e374 = ((((_e145 * param_5[0]) + (_e148 * param_5[1])) + (_e151 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_8382_ = _e374;
                } else {
                    phi_8382_ = 1f;
                }
                let _e378 = phi_8382_;
                phi_8383_ = _e378;
            } else {
                phi_8383_ = 0f;
            }
            let _e380 = phi_8383_;
            let _e393 = (param_3[0] - param_5[0]);
            let _e396 = (param_3[1] - param_5[1]);
            let _e399 = (param_3[2] - param_5[2]);
            let _e419 = ((((_e393 * param_4[0]) + (_e396 * param_4[1])) + (_e399 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_8431_ = _e419;
                } else {
                    phi_8431_ = 1f;
                }
                let _e423 = phi_8431_;
                phi_8432_ = _e423;
            } else {
                phi_8432_ = 0f;
            }
            let _e425 = phi_8432_;
            phi_8574_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e299)), (param_3[1] - (param_4[1] * _e299)), (param_3[2] - (param_4[2] * _e299))), array<f32, 3>((param_3[0] - (param_5[0] * _e341)), (param_3[1] - (param_5[1] * _e341)), (param_3[2] - (param_5[2] * _e341))), array<f32, 3>((_e145 - (param_5[0] * _e380)), (_e148 - (param_5[1] * _e380)), (_e151 - (param_5[2] * _e380))), array<f32, 3>((_e393 - (param_4[0] * _e425)), (_e396 - (param_4[1] * _e425)), (_e399 - (param_4[2] * _e425))));
        } else {
            let _e155 = (param_5[0] - param_4[0]);
            let _e158 = (param_5[1] - param_4[1]);
            let _e161 = (param_5[2] - param_4[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_8472_ = _e172;
                } else {
                    phi_8472_ = 1f;
                }
                let _e176 = phi_8472_;
                phi_8473_ = _e176;
            } else {
                phi_8473_ = 0f;
            }
            let _e178 = phi_8473_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_8512_ = _e208;
                } else {
                    phi_8512_ = 1f;
                }
                let _e212 = phi_8512_;
                phi_8513_ = _e212;
            } else {
                phi_8513_ = 0f;
            }
            let _e214 = phi_8513_;
            let _e250 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_8558_ = _e250;
                } else {
                    phi_8558_ = 1f;
                }
                let _e254 = phi_8558_;
                phi_8559_ = _e254;
            } else {
                phi_8559_ = 0f;
            }
            let _e256 = phi_8559_;
            phi_8574_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e214)), (param_3[1] - (param_4[1] * _e214)), (param_3[2] - (param_4[2] * _e214))), array<f32, 3>((param_3[0] - (param_5[0] * _e256)), (param_3[1] - (param_5[1] * _e256)), (param_3[2] - (param_5[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_8574_;
        let _e441 = function_1(_e438[0], _e438[1]);
        let _e443 = function_1(_e441, _e438[2]);
        let _e445 = function_1(_e443, _e438[3]);
        phi_8582_ = _e445;
    } else {
        phi_8582_ = _e140;
    }
    let _e447 = phi_8582_;
    return _e447;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_30;
    var local_1: type_30;
    var local_2: type_29;
    var local_3: type_29;
    var local_4: type_29;
    var local_5: array<type_31, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: type_30;
    var local_10: type_30;
    var local_11: array<f32, 3>;
    var local_12: type_28;
    var phi_220_: u32;
    var phi_236_: u32;
    var phi_257_: u32;
    var phi_258_: u32;
    var phi_261_: type_9;
    var phi_262_: type_9;
    var phi_285_: type_9;
    var phi_460_: f32;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_488_: f32;
    var phi_494_: f32;
    var phi_499_: f32;
    var phi_505_: f32;
    var phi_510_: f32;
    var phi_515_: f32;
    var phi_522_: f32;
    var phi_528_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_544_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_561_: f32;
    var phi_567_: f32;
    var phi_572_: f32;
    var phi_577_: f32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_595_: f32;
    var phi_601_: f32;
    var phi_606_: f32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_634_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_650_: f32;
    var phi_657_: bool;
    var phi_681_: u32;
    var phi_692_: f32;
    var phi_693_: f32;
    var phi_724_: type_34;
    var phi_725_: bool;
    var phi_726_: type_34;
    var phi_727_: bool;
    var phi_728_: type_34;
    var phi_729_: bool;
    var phi_734_: type_34;
    var phi_1016_: f32;
    var phi_1023_: f32;
    var phi_1028_: f32;
    var phi_1035_: f32;
    var phi_1040_: f32;
    var phi_1053_: f32;
    var phi_1060_: f32;
    var phi_1065_: f32;
    var phi_1072_: f32;
    var phi_1077_: f32;
    var phi_1082_: f32;
    var phi_1099_: f32;
    var phi_1106_: f32;
    var phi_1111_: f32;
    var phi_1118_: f32;
    var phi_1123_: f32;
    var phi_1137_: f32;
    var phi_1144_: f32;
    var phi_1149_: f32;
    var phi_1156_: f32;
    var phi_1161_: f32;
    var phi_1166_: f32;
    var phi_1183_: f32;
    var phi_1190_: f32;
    var phi_1195_: f32;
    var phi_1202_: f32;
    var phi_1207_: f32;
    var phi_1221_: f32;
    var phi_1228_: f32;
    var phi_1233_: f32;
    var phi_1240_: f32;
    var phi_1245_: f32;
    var phi_1250_: f32;
    var phi_1281_: f32;
    var phi_1287_: f32;
    var phi_1294_: f32;
    var phi_1301_: f32;
    var phi_1307_: f32;
    var phi_1314_: f32;
    var phi_1320_: f32;
    var phi_1326_: f32;
    var phi_1332_: f32;
    var phi_1339_: f32;
    var phi_1346_: f32;
    var phi_1370_: f32;
    var phi_1375_: f32;
    var phi_1380_: f32;
    var phi_1385_: f32;
    var phi_1390_: f32;
    var phi_1395_: f32;
    var phi_1405_: f32;
    var phi_4054_: f32;
    var phi_4060_: f32;
    var phi_4065_: f32;
    var phi_4071_: f32;
    var phi_4077_: f32;
    var phi_4082_: f32;
    var phi_4087_: f32;
    var phi_4095_: bool;
    var phi_4100_: f32;
    var phi_4107_: f32;
    var phi_4147_: type_14;
    var phi_4150_: f32;
    var phi_4171_: bool;
    var phi_4177_: type_15;
    var phi_4148_: type_14;
    var phi_4191_: type_15;
    var phi_4151_: f32;
    var local_13: f32;
    var phi_4140_: f32;
    var phi_4204_: f32;
    var phi_4210_: f32;
    var phi_4235_: type_9;
    var phi_4238_: u32;
    var phi_4236_: type_9;
    var phi_4261_: type_9;
    var phi_4305_: u32;
    var phi_4306_: u32;
    var phi_4239_: u32;
    var phi_4307_: u32;
    var phi_4327_: type_9;
    var phi_4328_: type_9;
    var phi_4351_: type_9;
    var phi_4403_: f32;
    var phi_4410_: f32;
    var phi_4421_: bool;
    var phi_4422_: bool;
    var phi_4423_: bool;
    var phi_4424_: bool;
    var phi_4428_: bool;
    var phi_4439_: type_37;
    var phi_4440_: type_37;
    var phi_4441_: bool;
    var phi_4442_: type_37;
    var phi_4443_: bool;
    var phi_4454_: f32;
    var phi_4464_: type_9;
    var phi_4467_: f32;
    var phi_4469_: f32;
    var phi_4471_: f32;
    var phi_4465_: type_9;
    var phi_4494_: type_9;
    var phi_4519_: f32;
    var phi_4520_: f32;
    var phi_4546_: f32;
    var phi_4562_: f32;
    var phi_4569_: bool;
    var phi_4570_: bool;
    var phi_4571_: bool;
    var phi_4577_: f32;
    var phi_4578_: f32;
    var phi_4579_: bool;
    var phi_4468_: f32;
    var phi_4470_: f32;
    var phi_4472_: f32;
    var phi_4580_: f32;
    var phi_4581_: bool;
    var phi_4582_: bool;
    var local_14: bool;
    var phi_4586_: f32;
    var phi_4587_: f32;
    var phi_4595_: f32;
    var phi_4599_: type_9;
    var phi_4602_: f32;
    var phi_4600_: type_9;
    var phi_4625_: type_9;
    var phi_4655_: f32;
    var phi_4656_: bool;
    var phi_4657_: f32;
    var phi_4658_: bool;
    var phi_4659_: bool;
    var phi_4660_: bool;
    var phi_4661_: f32;
    var phi_4603_: f32;
    var phi_4662_: bool;
    var phi_4663_: bool;
    var phi_4664_: bool;
    var phi_4665_: bool;
    var local_15: bool;
    var phi_4669_: bool;
    var phi_4670_: bool;
    var phi_4674_: bool;
    var phi_4678_: f32;
    var phi_4679_: f32;
    var phi_4681_: type_37;
    var phi_4710_: f32;
    var phi_4717_: f32;
    var phi_4722_: f32;
    var phi_4729_: f32;
    var phi_4734_: f32;
    var phi_4747_: f32;
    var phi_4754_: f32;
    var phi_4759_: f32;
    var phi_4766_: f32;
    var phi_4771_: f32;
    var phi_4776_: f32;
    var phi_4835_: f32;
    var phi_4841_: f32;
    var phi_4846_: f32;
    var phi_4852_: f32;
    var phi_4857_: f32;
    var phi_4869_: f32;
    var phi_4875_: f32;
    var phi_4880_: f32;
    var phi_4886_: f32;
    var phi_4891_: f32;
    var phi_4917_: f32;
    var phi_4924_: f32;
    var phi_4929_: f32;
    var phi_4936_: f32;
    var phi_4941_: f32;
    var phi_4954_: f32;
    var phi_4961_: f32;
    var phi_4966_: f32;
    var phi_4973_: f32;
    var phi_4978_: f32;
    var phi_4983_: f32;
    var phi_5042_: f32;
    var phi_5048_: f32;
    var phi_5053_: f32;
    var phi_5059_: f32;
    var phi_5064_: f32;
    var phi_5076_: f32;
    var phi_5082_: f32;
    var phi_5087_: f32;
    var phi_5093_: f32;
    var phi_5098_: f32;
    var phi_5124_: f32;
    var phi_5131_: f32;
    var phi_5136_: f32;
    var phi_5143_: f32;
    var phi_5148_: f32;
    var phi_5161_: f32;
    var phi_5168_: f32;
    var phi_5173_: f32;
    var phi_5180_: f32;
    var phi_5185_: f32;
    var phi_5190_: f32;
    var phi_5249_: f32;
    var phi_5255_: f32;
    var phi_5260_: f32;
    var phi_5266_: f32;
    var phi_5271_: f32;
    var phi_5283_: f32;
    var phi_5289_: f32;
    var phi_5294_: f32;
    var phi_5300_: f32;
    var phi_5305_: f32;
    var phi_5354_: f32;
    var phi_5360_: f32;
    var phi_5388_: f32;
    var phi_5394_: f32;
    var phi_5399_: u32;
    var phi_5400_: u32;
    var phi_5370_: f32;
    var phi_5376_: f32;
    var phi_5381_: u32;
    var phi_5382_: u32;
    var phi_5401_: u32;
    var phi_5402_: u32;
    var phi_5471_: f32;
    var phi_5480_: f32;
    var phi_5615_: f32;
    var phi_5621_: f32;
    var phi_5628_: f32;
    var phi_5671_: type_9;
    var phi_5674_: bool;
    var phi_5672_: type_9;
    var phi_5697_: type_9;
    var phi_5724_: bool;
    var phi_5725_: bool;
    var phi_5675_: bool;
    var phi_5726_: bool;
    var phi_5727_: bool;
    var local_16: bool;
    var phi_5731_: bool;
    var local_17: bool;
    var phi_5738_: u32;
    var phi_5739_: u32;
    var phi_5740_: bool;
    var phi_5741_: u32;
    var phi_5742_: u32;
    var phi_5743_: bool;
    var phi_5747_: u32;
    var phi_5767_: bool;
    var phi_5768_: bool;
    var phi_5769_: bool;
    var phi_5917_: f32;
    var phi_5924_: f32;
    var phi_5929_: f32;
    var phi_5936_: f32;
    var phi_5941_: f32;
    var phi_5954_: f32;
    var phi_5961_: f32;
    var phi_5966_: f32;
    var phi_5973_: f32;
    var phi_5978_: f32;
    var phi_5983_: f32;
    var phi_6000_: f32;
    var phi_6007_: f32;
    var phi_6012_: f32;
    var phi_6019_: f32;
    var phi_6024_: f32;
    var phi_6038_: f32;
    var phi_6045_: f32;
    var phi_6050_: f32;
    var phi_6057_: f32;
    var phi_6062_: f32;
    var phi_6067_: f32;
    var phi_6084_: f32;
    var phi_6091_: f32;
    var phi_6096_: f32;
    var phi_6103_: f32;
    var phi_6108_: f32;
    var phi_6122_: f32;
    var phi_6129_: f32;
    var phi_6134_: f32;
    var phi_6141_: f32;
    var phi_6146_: f32;
    var phi_6151_: f32;
    var phi_6190_: type_9;
    var phi_6193_: f32;
    var phi_6195_: f32;
    var phi_6197_: f32;
    var phi_6191_: type_9;
    var phi_6220_: type_9;
    var phi_6332_: f32;
    var phi_6339_: f32;
    var phi_6347_: f32;
    var phi_6391_: type_14;
    var phi_6394_: f32;
    var phi_6415_: bool;
    var phi_6421_: type_15;
    var phi_6392_: type_14;
    var phi_6435_: type_15;
    var phi_6395_: f32;
    var local_18: f32;
    var phi_6384_: f32;
    var phi_6448_: f32;
    var phi_6514_: f32;
    var phi_6520_: f32;
    var phi_6529_: f32;
    var phi_6535_: f32;
    var phi_6544_: f32;
    var phi_6550_: f32;
    var phi_6559_: f32;
    var phi_6565_: f32;
    var phi_6571_: type_30;
    var phi_6572_: bool;
    var phi_6573_: type_30;
    var phi_6574_: bool;
    var phi_6582_: type_30;
    var phi_6752_: bool;
    var phi_6753_: bool;
    var phi_6754_: bool;
    var phi_6755_: bool;
    var phi_6756_: bool;
    var phi_6757_: bool;
    var phi_6761_: bool;
    var phi_7058_: bool;
    var phi_7059_: bool;
    var phi_7060_: bool;
    var phi_7061_: bool;
    var phi_7062_: bool;
    var phi_7063_: bool;
    var phi_7067_: bool;
    var phi_7071_: bool;
    var phi_7083_: bool;
    var phi_7084_: bool;
    var phi_7158_: bool;
    var phi_7159_: bool;
    var phi_7179_: f32;
    var phi_7180_: bool;
    var phi_7181_: f32;
    var phi_7182_: bool;
    var phi_7183_: f32;
    var phi_7184_: bool;
    var phi_7185_: bool;
    var phi_7189_: f32;
    var phi_7190_: bool;
    var phi_7194_: f32;
    var phi_7226_: bool;
    var phi_7227_: bool;
    var phi_7247_: f32;
    var phi_7248_: bool;
    var phi_7249_: f32;
    var phi_7250_: bool;
    var phi_7251_: f32;
    var phi_7252_: bool;
    var phi_7253_: bool;
    var phi_7257_: f32;
    var phi_7258_: bool;
    var phi_7262_: f32;
    var phi_7267_: f32;
    var phi_7299_: bool;
    var phi_7300_: bool;
    var phi_7320_: f32;
    var phi_7321_: bool;
    var phi_7322_: f32;
    var phi_7323_: bool;
    var phi_7324_: f32;
    var phi_7325_: bool;
    var phi_7326_: bool;
    var phi_7330_: f32;
    var phi_7331_: bool;
    var phi_7335_: f32;
    var phi_7367_: bool;
    var phi_7368_: bool;
    var phi_7388_: f32;
    var phi_7389_: bool;
    var phi_7390_: f32;
    var phi_7391_: bool;
    var phi_7392_: f32;
    var phi_7393_: bool;
    var phi_7394_: bool;
    var phi_7398_: f32;
    var phi_7399_: bool;
    var phi_7403_: f32;
    var phi_7408_: f32;
    var phi_7413_: f32;
    var phi_7418_: f32;
    var phi_7429_: f32;
    var phi_7430_: f32;
    var phi_7431_: bool;
    var phi_7432_: f32;
    var phi_7433_: f32;
    var phi_7434_: bool;
    var phi_7435_: bool;
    var phi_7436_: bool;
    var phi_7437_: f32;
    var phi_7438_: f32;
    var phi_7439_: bool;
    var phi_7440_: bool;
    var phi_7441_: bool;
    var phi_7442_: bool;
    var phi_7443_: f32;
    var phi_7444_: f32;
    var phi_7445_: bool;
    var phi_7446_: bool;
    var phi_7447_: bool;
    var phi_7448_: bool;
    var phi_7528_: f32;
    var phi_7601_: f32;
    var phi_7606_: f32;
    var phi_7679_: f32;
    var phi_7752_: f32;
    var phi_7757_: f32;
    var phi_7773_: f32;
    var phi_7774_: f32;
    var phi_7775_: f32;
    var phi_7777_: f32;
    var phi_7778_: bool;
    var phi_7779_: f32;
    var phi_7780_: f32;
    var phi_7781_: f32;
    var phi_7782_: bool;
    var phi_7783_: bool;
    var phi_7784_: bool;
    var phi_7785_: bool;
    var phi_7794_: f32;
    var phi_7799_: f32;
    var phi_7809_: bool;
    var phi_7813_: bool;
    var phi_7814_: f32;
    var phi_7815_: bool;
    var phi_7816_: bool;
    var phi_7817_: bool;
    var phi_7818_: bool;
    var phi_7819_: bool;
    var phi_6194_: f32;
    var phi_6196_: f32;
    var phi_6198_: f32;
    var phi_7820_: f32;
    var phi_7821_: bool;
    var phi_7822_: bool;
    var phi_7823_: bool;
    var phi_7824_: bool;
    var phi_7825_: bool;
    var phi_7826_: bool;
    var local_19: bool;
    var phi_7830_: f32;
    var phi_7831_: bool;
    var phi_7832_: bool;
    var phi_7833_: bool;
    var phi_7834_: bool;
    var phi_7839_: type_35;
    var phi_7840_: bool;
    var phi_7841_: bool;
    var phi_7842_: bool;
    var local_20: f32;
    var phi_7847_: type_35;
    var phi_7848_: bool;
    var phi_7849_: bool;
    var phi_7854_: type_35;
    var phi_7855_: bool;
    var phi_7856_: bool;
    var phi_7861_: type_35;
    var phi_7862_: bool;
    var phi_7866_: type_35;
    var phi_7873_: bool;
    var phi_7874_: f32;
    var phi_7875_: bool;
    var phi_7876_: bool;
    var phi_7877_: bool;
    var phi_7878_: f32;
    var phi_7879_: bool;
    var phi_7880_: bool;
    var phi_7881_: bool;
    var phi_7882_: f32;
    var phi_7883_: bool;
    var phi_7884_: bool;
    var phi_7885_: bool;
    var phi_7886_: bool;
    var phi_7890_: bool;
    var phi_7891_: bool;
    var phi_7892_: bool;
    var phi_7893_: f32;
    var phi_7894_: type_37;
    var phi_7895_: bool;
    var phi_7896_: bool;
    var phi_7897_: bool;
    var phi_7898_: bool;
    var local_21: bool;
    var phi_7903_: type_35;
    var phi_7904_: bool;
    var phi_7905_: bool;
    var local_22: f32;
    var phi_7910_: type_35;
    var phi_7911_: bool;
    var local_23: type_37;
    var phi_7917_: type_35;
    var phi_7918_: bool;
    var phi_7922_: type_35;
    var phi_1558_: f32;
    var phi_1565_: f32;
    var phi_1570_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1595_: f32;
    var phi_1602_: f32;
    var phi_1607_: f32;
    var phi_1614_: f32;
    var phi_1619_: f32;
    var phi_1624_: f32;
    var phi_1641_: f32;
    var phi_1648_: f32;
    var phi_1653_: f32;
    var phi_1660_: f32;
    var phi_1665_: f32;
    var phi_1679_: f32;
    var phi_1686_: f32;
    var phi_1691_: f32;
    var phi_1698_: f32;
    var phi_1703_: f32;
    var phi_1708_: f32;
    var phi_1725_: f32;
    var phi_1732_: f32;
    var phi_1737_: f32;
    var phi_1744_: f32;
    var phi_1749_: f32;
    var phi_1763_: f32;
    var phi_1770_: f32;
    var phi_1775_: f32;
    var phi_1782_: f32;
    var phi_1787_: f32;
    var phi_1792_: f32;
    var phi_1831_: type_9;
    var phi_1834_: f32;
    var phi_1836_: f32;
    var phi_1838_: f32;
    var phi_1832_: type_9;
    var phi_1861_: type_9;
    var phi_1973_: f32;
    var phi_1980_: f32;
    var phi_1988_: f32;
    var phi_2032_: type_14;
    var phi_2035_: f32;
    var phi_2056_: bool;
    var phi_2062_: type_15;
    var phi_2033_: type_14;
    var phi_2076_: type_15;
    var phi_2036_: f32;
    var local_24: f32;
    var phi_2025_: f32;
    var phi_2089_: f32;
    var phi_2155_: f32;
    var phi_2161_: f32;
    var phi_2170_: f32;
    var phi_2176_: f32;
    var phi_2185_: f32;
    var phi_2191_: f32;
    var phi_2200_: f32;
    var phi_2206_: f32;
    var phi_2212_: type_30;
    var phi_2213_: bool;
    var phi_2214_: type_30;
    var phi_2215_: bool;
    var phi_2223_: type_30;
    var phi_2393_: bool;
    var phi_2394_: bool;
    var phi_2395_: bool;
    var phi_2396_: bool;
    var phi_2397_: bool;
    var phi_2398_: bool;
    var phi_2402_: bool;
    var phi_2699_: bool;
    var phi_2700_: bool;
    var phi_2701_: bool;
    var phi_2702_: bool;
    var phi_2703_: bool;
    var phi_2704_: bool;
    var phi_2708_: bool;
    var phi_2712_: bool;
    var phi_2724_: bool;
    var phi_2725_: bool;
    var phi_2799_: bool;
    var phi_2800_: bool;
    var phi_2820_: f32;
    var phi_2821_: bool;
    var phi_2822_: f32;
    var phi_2823_: bool;
    var phi_2824_: f32;
    var phi_2825_: bool;
    var phi_2826_: bool;
    var phi_2830_: f32;
    var phi_2831_: bool;
    var phi_2835_: f32;
    var phi_2867_: bool;
    var phi_2868_: bool;
    var phi_2888_: f32;
    var phi_2889_: bool;
    var phi_2890_: f32;
    var phi_2891_: bool;
    var phi_2892_: f32;
    var phi_2893_: bool;
    var phi_2894_: bool;
    var phi_2898_: f32;
    var phi_2899_: bool;
    var phi_2903_: f32;
    var phi_2908_: f32;
    var phi_2940_: bool;
    var phi_2941_: bool;
    var phi_2961_: f32;
    var phi_2962_: bool;
    var phi_2963_: f32;
    var phi_2964_: bool;
    var phi_2965_: f32;
    var phi_2966_: bool;
    var phi_2967_: bool;
    var phi_2971_: f32;
    var phi_2972_: bool;
    var phi_2976_: f32;
    var phi_3008_: bool;
    var phi_3009_: bool;
    var phi_3029_: f32;
    var phi_3030_: bool;
    var phi_3031_: f32;
    var phi_3032_: bool;
    var phi_3033_: f32;
    var phi_3034_: bool;
    var phi_3035_: bool;
    var phi_3039_: f32;
    var phi_3040_: bool;
    var phi_3044_: f32;
    var phi_3049_: f32;
    var phi_3054_: f32;
    var phi_3059_: f32;
    var phi_3070_: f32;
    var phi_3071_: f32;
    var phi_3072_: bool;
    var phi_3073_: f32;
    var phi_3074_: f32;
    var phi_3075_: bool;
    var phi_3076_: bool;
    var phi_3077_: bool;
    var phi_3078_: f32;
    var phi_3079_: f32;
    var phi_3080_: bool;
    var phi_3081_: bool;
    var phi_3082_: bool;
    var phi_3083_: bool;
    var phi_3084_: f32;
    var phi_3085_: f32;
    var phi_3086_: bool;
    var phi_3087_: bool;
    var phi_3088_: bool;
    var phi_3089_: bool;
    var phi_3169_: f32;
    var phi_3242_: f32;
    var phi_3247_: f32;
    var phi_3320_: f32;
    var phi_3393_: f32;
    var phi_3398_: f32;
    var phi_3414_: f32;
    var phi_3415_: f32;
    var phi_3416_: f32;
    var phi_3418_: f32;
    var phi_3419_: bool;
    var phi_3420_: f32;
    var phi_3421_: f32;
    var phi_3422_: f32;
    var phi_3423_: bool;
    var phi_3424_: bool;
    var phi_3425_: bool;
    var phi_3426_: bool;
    var phi_3435_: f32;
    var phi_3440_: f32;
    var phi_3450_: bool;
    var phi_3454_: bool;
    var phi_3455_: f32;
    var phi_3456_: bool;
    var phi_3457_: bool;
    var phi_3458_: bool;
    var phi_3459_: bool;
    var phi_3460_: bool;
    var phi_1835_: f32;
    var phi_1837_: f32;
    var phi_1839_: f32;
    var phi_3461_: f32;
    var phi_3462_: bool;
    var phi_3463_: bool;
    var phi_3464_: bool;
    var phi_3465_: bool;
    var phi_3466_: bool;
    var phi_3467_: bool;
    var local_25: bool;
    var phi_3471_: f32;
    var phi_3472_: bool;
    var phi_3473_: bool;
    var phi_3474_: bool;
    var phi_3475_: bool;
    var phi_3480_: type_35;
    var phi_3481_: bool;
    var phi_3482_: bool;
    var phi_3483_: bool;
    var local_26: f32;
    var phi_3488_: type_35;
    var phi_3489_: bool;
    var phi_3490_: bool;
    var phi_3495_: type_35;
    var phi_3496_: bool;
    var phi_3497_: bool;
    var phi_3502_: type_35;
    var phi_3503_: bool;
    var phi_3507_: type_35;
    var phi_3521_: type_9;
    var phi_3522_: type_9;
    var phi_3545_: type_9;
    var phi_3565_: f32;
    var phi_3695_: type_14;
    var phi_3698_: f32;
    var phi_3719_: bool;
    var phi_3725_: type_15;
    var phi_3696_: type_14;
    var phi_3739_: type_15;
    var phi_3699_: f32;
    var local_27: f32;
    var phi_3688_: f32;
    var phi_3752_: f32;
    var phi_3768_: f32;
    var phi_3775_: f32;
    var phi_3780_: f32;
    var phi_3787_: f32;
    var phi_3792_: f32;
    var phi_3805_: f32;
    var phi_3812_: f32;
    var phi_3817_: f32;
    var phi_3824_: f32;
    var phi_3829_: f32;
    var phi_3834_: f32;
    var phi_3851_: f32;
    var phi_3858_: f32;
    var phi_3863_: f32;
    var phi_3870_: f32;
    var phi_3875_: f32;
    var phi_3889_: f32;
    var phi_3896_: f32;
    var phi_3901_: f32;
    var phi_3908_: f32;
    var phi_3913_: f32;
    var phi_3918_: f32;
    var phi_3935_: f32;
    var phi_3942_: f32;
    var phi_3947_: f32;
    var phi_3954_: f32;
    var phi_3959_: f32;
    var phi_3973_: f32;
    var phi_3980_: f32;
    var phi_3985_: f32;
    var phi_3992_: f32;
    var phi_3997_: f32;
    var phi_4002_: f32;
    var phi_4022_: bool;
    var phi_4023_: bool;
    var phi_4024_: bool;
    var local_28: bool;
    var phi_4029_: type_35;
    var phi_4030_: bool;
    var phi_4035_: type_35;
    var phi_4036_: bool;
    var phi_4038_: type_35;
    var phi_4039_: type_35;
    var phi_4040_: bool;
    var phi_4044_: type_35;
    var phi_7926_: type_35;
    var phi_7927_: type_35;
    var phi_7940_: type_38;
    var phi_7947_: bool;
    var phi_7971_: u32;
    var phi_7975_: type_20;
    var phi_7976_: bool;
    var phi_7977_: bool;
    var phi_7996_: u32;
    var phi_8059_: u32;
    var local_29: u32;
    var local_30: f32;
    var local_31: f32;
    var local_32: bool;
    var local_33: bool;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;
    var local_37: bool;
    var local_38: bool;
    var local_39: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: f32;
    var local_44: f32;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e103 = id_2;
    let _e104 = n_2;
    let _e105 = lane_2;
    let _e117 = ((_e103.y * _e104.x) + _e103.x);
    let _e120 = (_e104.x * _e104.y);
    let _e123 = params.member.member_1.member_2;
    let _e125 = input.member[0u];
    if (_e123 < _e125) {
        phi_220_ = _e123;
    } else {
        phi_220_ = _e125;
    }
    let _e128 = phi_220_;
    let _e129 = (_e128 / 64u);
    if ((_e128 % 64u) > 0u) {
        phi_236_ = (_e129 + 1u);
    } else {
        phi_236_ = _e129;
    }
    let _e134 = phi_236_;
    if (_e134 > _e117) {
        let _e136 = (_e134 - _e117);
        if (_e120 == 0u) {
            return;
        }
        let _e138 = (_e136 / _e120);
        if (_e120 == 0u) {
            return;
        }
        if ((_e136 % _e120) > 0u) {
            phi_257_ = (_e138 + 1u);
        } else {
            phi_257_ = _e138;
        }
        let _e144 = phi_257_;
        phi_258_ = _e144;
    } else {
        phi_258_ = 0u;
    }
    let _e146 = phi_258_;
    phi_261_ = type_9(0u, _e146);
    loop {
        let _e149 = phi_261_;
        if (_e149.member < _e149.member_1) {
            phi_262_ = type_9((_e149.member + 1u), _e149.member_1);
            phi_285_ = type_9(1u, _e149.member);
        } else {
            phi_262_ = _e149;
            phi_285_ = type_9(0u, type_9().member_1);
        }
        let _e161 = phi_262_;
        let _e163 = phi_285_;
        let _e167 = (bitcast<i32>(_e163.member) != 0i);
        if _e167 {
            let _e171 = (((_e117 + (_e163.member_1 * _e120)) * 64u) + _e105);
            if (_e171 < _e128) {
                let _e173 = (2u * _e171);
                let _e176 = input.member[(4u + _e173)];
                let _e179 = input.member[(_e173 + 5u)];
                let _e182 = elements.member[_e176];
                let _e184 = elements.member[_e179];
                let _e190 = paths.member[_e182[0]];
                let _e192 = paths.member[_e182[1]];
                let _e198 = paths.member[_e184[0]];
                let _e200 = paths.member[_e184[1]];
                let _e230 = params.member.member.member_4;
                let _e231 = (_e198.member[0] - _e190.member[0]);
                let _e232 = (_e198.member[1] - _e190.member[1]);
                let _e233 = (_e198.member[2] - _e190.member[2]);
                let _e235 = (_e198.member_1[0] - _e190.member_1[0]);
                let _e236 = (_e198.member_1[1] - _e190.member_1[1]);
                let _e237 = (_e198.member_1[2] - _e190.member_1[2]);
                let _e240 = (_e192.member[0] - _e190.member[0]);
                let _e241 = (_e192.member[1] - _e190.member[1]);
                let _e242 = (_e192.member[2] - _e190.member[2]);
                let _e244 = (_e192.member_1[0] - _e190.member_1[0]);
                let _e245 = (_e192.member_1[1] - _e190.member_1[1]);
                let _e246 = (_e192.member_1[2] - _e190.member_1[2]);
                let _e249 = (_e198.member[0] - _e200.member[0]);
                let _e250 = (_e198.member[1] - _e200.member[1]);
                let _e251 = (_e198.member[2] - _e200.member[2]);
                let _e253 = (_e198.member_1[0] - _e200.member_1[0]);
                let _e254 = (_e198.member_1[1] - _e200.member_1[1]);
                let _e255 = (_e198.member_1[2] - _e200.member_1[2]);
                let _e258 = (_e230 + _e230);
                let _e261 = params.member.member.member_5;
                if (_e231 < 0f) {
                    phi_460_ = -(_e231);
                } else {
                    phi_460_ = _e231;
                }
                let _e265 = phi_460_;
                if (_e232 < 0f) {
                    phi_466_ = -(_e232);
                } else {
                    phi_466_ = _e232;
                }
                let _e269 = phi_466_;
                if (_e265 > _e269) {
                    phi_471_ = _e265;
                } else {
                    phi_471_ = _e269;
                }
                let _e272 = phi_471_;
                if (_e233 < 0f) {
                    phi_477_ = -(_e233);
                } else {
                    phi_477_ = _e233;
                }
                let _e276 = phi_477_;
                if (_e272 > _e276) {
                    phi_482_ = _e272;
                } else {
                    phi_482_ = _e276;
                }
                let _e279 = phi_482_;
                if (_e235 < 0f) {
                    phi_488_ = -(_e235);
                } else {
                    phi_488_ = _e235;
                }
                let _e283 = phi_488_;
                if (_e236 < 0f) {
                    phi_494_ = -(_e236);
                } else {
                    phi_494_ = _e236;
                }
                let _e287 = phi_494_;
                if (_e283 > _e287) {
                    phi_499_ = _e283;
                } else {
                    phi_499_ = _e287;
                }
                let _e290 = phi_499_;
                if (_e237 < 0f) {
                    phi_505_ = -(_e237);
                } else {
                    phi_505_ = _e237;
                }
                let _e294 = phi_505_;
                if (_e290 > _e294) {
                    phi_510_ = _e290;
                } else {
                    phi_510_ = _e294;
                }
                let _e297 = phi_510_;
                if (_e279 > _e297) {
                    phi_515_ = _e279;
                } else {
                    phi_515_ = _e297;
                }
                let _e300 = phi_515_;
                let _e301 = (_e300 + _e258);
                if (_e240 < 0f) {
                    phi_522_ = -(_e240);
                } else {
                    phi_522_ = _e240;
                }
                let _e305 = phi_522_;
                if (_e241 < 0f) {
                    phi_528_ = -(_e241);
                } else {
                    phi_528_ = _e241;
                }
                let _e309 = phi_528_;
                if (_e305 > _e309) {
                    phi_533_ = _e305;
                } else {
                    phi_533_ = _e309;
                }
                let _e312 = phi_533_;
                if (_e242 < 0f) {
                    phi_539_ = -(_e242);
                } else {
                    phi_539_ = _e242;
                }
                let _e316 = phi_539_;
                if (_e312 > _e316) {
                    phi_544_ = _e312;
                } else {
                    phi_544_ = _e316;
                }
                let _e319 = phi_544_;
                if (_e244 < 0f) {
                    phi_550_ = -(_e244);
                } else {
                    phi_550_ = _e244;
                }
                let _e323 = phi_550_;
                if (_e245 < 0f) {
                    phi_556_ = -(_e245);
                } else {
                    phi_556_ = _e245;
                }
                let _e327 = phi_556_;
                if (_e323 > _e327) {
                    phi_561_ = _e323;
                } else {
                    phi_561_ = _e327;
                }
                let _e330 = phi_561_;
                if (_e246 < 0f) {
                    phi_567_ = -(_e246);
                } else {
                    phi_567_ = _e246;
                }
                let _e334 = phi_567_;
                if (_e330 > _e334) {
                    phi_572_ = _e330;
                } else {
                    phi_572_ = _e334;
                }
                let _e337 = phi_572_;
                if (_e319 > _e337) {
                    phi_577_ = _e319;
                } else {
                    phi_577_ = _e337;
                }
                let _e340 = phi_577_;
                let _e341 = (_e340 + _e258);
                if (_e249 < 0f) {
                    phi_584_ = -(_e249);
                } else {
                    phi_584_ = _e249;
                }
                let _e345 = phi_584_;
                if (_e250 < 0f) {
                    phi_590_ = -(_e250);
                } else {
                    phi_590_ = _e250;
                }
                let _e349 = phi_590_;
                if (_e345 > _e349) {
                    phi_595_ = _e345;
                } else {
                    phi_595_ = _e349;
                }
                let _e352 = phi_595_;
                if (_e251 < 0f) {
                    phi_601_ = -(_e251);
                } else {
                    phi_601_ = _e251;
                }
                let _e356 = phi_601_;
                if (_e352 > _e356) {
                    phi_606_ = _e352;
                } else {
                    phi_606_ = _e356;
                }
                let _e359 = phi_606_;
                if (_e253 < 0f) {
                    phi_612_ = -(_e253);
                } else {
                    phi_612_ = _e253;
                }
                let _e363 = phi_612_;
                if (_e254 < 0f) {
                    phi_618_ = -(_e254);
                } else {
                    phi_618_ = _e254;
                }
                let _e367 = phi_618_;
                if (_e363 > _e367) {
                    phi_623_ = _e363;
                } else {
                    phi_623_ = _e367;
                }
                let _e370 = phi_623_;
                if (_e255 < 0f) {
                    phi_629_ = -(_e255);
                } else {
                    phi_629_ = _e255;
                }
                let _e374 = phi_629_;
                if (_e370 > _e374) {
                    phi_634_ = _e370;
                } else {
                    phi_634_ = _e374;
                }
                let _e377 = phi_634_;
                if (_e359 > _e377) {
                    phi_639_ = _e359;
                } else {
                    phi_639_ = _e377;
                }
                let _e380 = phi_639_;
                let _e381 = (_e380 + _e258);
                if (_e301 > _e341) {
                    phi_645_ = _e301;
                } else {
                    phi_645_ = _e341;
                }
                let _e384 = phi_645_;
                if (_e384 > _e381) {
                    phi_650_ = _e384;
                } else {
                    phi_650_ = _e381;
                }
                let _e387 = phi_650_;
                if (_e387 <= 65536f) {
                    phi_657_ = (_e387 >= (1f / 65536f));
                } else {
                    phi_657_ = false;
                }
                let _e392 = phi_657_;
                if _e392 {
                    phi_728_ = type_34();
                    phi_729_ = true;
                } else {
                    if (_e387 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e387) & 2139095040u) != 2139095040u) {
                            let _e399 = (2130706432u - (bitcast<u32>(_e387) & 2139095040u));
                            if (_e399 > 8388608u) {
                                phi_681_ = _e399;
                            } else {
                                phi_681_ = 8388608u;
                            }
                            let _e402 = phi_681_;
                            let _e403 = bitcast<f32>(_e402);
                            let _e404 = (_e261 * _e403);
                            if (_e261 > 0f) {
                                if (_e404 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_692_ = _e404;
                                } else {
                                    phi_692_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e408 = phi_692_;
                                phi_693_ = _e408;
                            } else {
                                phi_693_ = _e404;
                            }
                            let _e410 = phi_693_;
                            phi_724_ = type_34(type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e231 * _e403), (_e232 * _e403), (_e233 * _e403)), array<f32, 3>((_e235 * _e403), (_e236 * _e403), (_e237 * _e403))), array<array<f32, 3>, 2>(array<f32, 3>((_e240 * _e403), (_e241 * _e403), (_e242 * _e403)), array<f32, 3>((_e244 * _e403), (_e245 * _e403), (_e246 * _e403))), array<array<f32, 3>, 2>(array<f32, 3>((_e249 * _e403), (_e250 * _e403), (_e251 * _e403)), array<f32, 3>((_e253 * _e403), (_e254 * _e403), (_e255 * _e403))), (_e258 * _e403)), _e410);
                            phi_725_ = false;
                        } else {
                            phi_724_ = type_34();
                            phi_725_ = true;
                        }
                        let _e442 = phi_724_;
                        let _e444 = phi_725_;
                        phi_726_ = _e442;
                        phi_727_ = _e444;
                    } else {
                        phi_726_ = type_34();
                        phi_727_ = true;
                    }
                    let _e446 = phi_726_;
                    let _e448 = phi_727_;
                    phi_728_ = _e446;
                    phi_729_ = _e448;
                }
                let _e450 = phi_728_;
                let _e452 = phi_729_;
                if _e452 {
                    phi_734_ = type_34(type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e231, _e232, _e233), array<f32, 3>(_e235, _e236, _e237)), array<array<f32, 3>, 2>(array<f32, 3>(_e240, _e241, _e242), array<f32, 3>(_e244, _e245, _e246)), array<array<f32, 3>, 2>(array<f32, 3>(_e249, _e250, _e251), array<f32, 3>(_e253, _e254, _e255)), _e258), _e261);
                } else {
                    phi_734_ = _e450;
                }
                let _e455 = phi_734_;
                local_12 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e455.member.member[0][0], _e455.member.member[0][1], _e455.member.member[0][2]), array<f32, 3>(_e455.member.member[1][0], _e455.member.member[1][1], _e455.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e455.member.member_1[0][0], _e455.member.member_1[0][1], _e455.member.member_1[0][2]), array<f32, 3>(_e455.member.member_1[1][0], _e455.member.member_1[1][1], _e455.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e455.member.member_2[0][0], _e455.member.member_2[0][1], _e455.member.member_2[0][2]), array<f32, 3>(_e455.member.member_2[1][0], _e455.member.member_2[1][1], _e455.member.member_2[1][2])), _e455.member.member_3);
                let _e498 = local_12.member_1[0u];
                let _e504 = local_12.member_2[0u];
                let _e510 = ((_e498[1] * _e504[2]) - (_e498[2] * _e504[1]));
                let _e513 = ((_e498[2] * _e504[0]) - (_e498[0] * _e504[2]));
                let _e516 = ((_e498[0] * _e504[1]) - (_e498[1] * _e504[0]));
                let _e519 = local_12.member_1[1u];
                let _e525 = local_12.member_2[1u];
                let _e531 = ((_e519[1] * _e525[2]) - (_e519[2] * _e525[1]));
                let _e534 = ((_e519[2] * _e525[0]) - (_e519[0] * _e525[2]));
                let _e537 = ((_e519[0] * _e525[1]) - (_e519[1] * _e525[0]));
                let _e540 = local_12.member_1[0u];
                let _e546 = local_12.member_2[1u];
                let _e561 = local_12.member_1[1u];
                let _e567 = local_12.member_2[0u];
                let _e580 = (((_e540[1] * _e546[2]) - (_e540[2] * _e546[1])) + ((_e561[1] * _e567[2]) - (_e561[2] * _e567[1])));
                let _e581 = (((_e540[2] * _e546[0]) - (_e540[0] * _e546[2])) + ((_e561[2] * _e567[0]) - (_e561[0] * _e567[2])));
                let _e582 = (((_e540[0] * _e546[1]) - (_e540[1] * _e546[0])) + ((_e561[0] * _e567[1]) - (_e561[1] * _e567[0])));
                let _e585 = local_12.member[0u];
                let _e593 = (((_e585[0] * _e510) + (_e585[1] * _e513)) + (_e585[2] * _e516));
                let _e596 = local_12.member[1u];
                let _e607 = local_12.member[0u];
                let _e616 = ((((_e596[0] * _e510) + (_e596[1] * _e513)) + (_e596[2] * _e516)) + (((_e607[0] * _e580) + (_e607[1] * _e581)) + (_e607[2] * _e582)));
                let _e619 = local_12.member[0u];
                let _e630 = local_12.member[1u];
                let _e639 = ((((_e619[0] * _e531) + (_e619[1] * _e534)) + (_e619[2] * _e537)) + (((_e630[0] * _e580) + (_e630[1] * _e581)) + (_e630[2] * _e582)));
                let _e642 = local_12.member[1u];
                let _e650 = (((_e642[0] * _e531) + (_e642[1] * _e534)) + (_e642[2] * _e537));
                let _e653 = local_12.member[0u];
                if (_e653[0] < 0f) {
                    phi_1016_ = -(_e653[0]);
                } else {
                    phi_1016_ = _e653[0];
                }
                let _e660 = phi_1016_;
                if (_e653[1] < 0f) {
                    phi_1023_ = -(_e653[1]);
                } else {
                    phi_1023_ = _e653[1];
                }
                let _e664 = phi_1023_;
                if (_e660 > _e664) {
                    phi_1028_ = _e660;
                } else {
                    phi_1028_ = _e664;
                }
                let _e667 = phi_1028_;
                if (_e653[2] < 0f) {
                    phi_1035_ = -(_e653[2]);
                } else {
                    phi_1035_ = _e653[2];
                }
                let _e671 = phi_1035_;
                if (_e667 > _e671) {
                    phi_1040_ = _e667;
                } else {
                    phi_1040_ = _e671;
                }
                let _e674 = phi_1040_;
                let _e677 = local_12.member[1u];
                if (_e677[0] < 0f) {
                    phi_1053_ = -(_e677[0]);
                } else {
                    phi_1053_ = _e677[0];
                }
                let _e684 = phi_1053_;
                if (_e677[1] < 0f) {
                    phi_1060_ = -(_e677[1]);
                } else {
                    phi_1060_ = _e677[1];
                }
                let _e688 = phi_1060_;
                if (_e684 > _e688) {
                    phi_1065_ = _e684;
                } else {
                    phi_1065_ = _e688;
                }
                let _e691 = phi_1065_;
                if (_e677[2] < 0f) {
                    phi_1072_ = -(_e677[2]);
                } else {
                    phi_1072_ = _e677[2];
                }
                let _e695 = phi_1072_;
                if (_e691 > _e695) {
                    phi_1077_ = _e691;
                } else {
                    phi_1077_ = _e695;
                }
                let _e698 = phi_1077_;
                if (_e674 > _e698) {
                    phi_1082_ = _e674;
                } else {
                    phi_1082_ = _e698;
                }
                let _e701 = phi_1082_;
                let _e703 = local_12.member_3;
                let _e704 = (_e701 + _e703);
                let _e707 = local_12.member_1[0u];
                if (_e707[0] < 0f) {
                    phi_1099_ = -(_e707[0]);
                } else {
                    phi_1099_ = _e707[0];
                }
                let _e714 = phi_1099_;
                if (_e707[1] < 0f) {
                    phi_1106_ = -(_e707[1]);
                } else {
                    phi_1106_ = _e707[1];
                }
                let _e718 = phi_1106_;
                if (_e714 > _e718) {
                    phi_1111_ = _e714;
                } else {
                    phi_1111_ = _e718;
                }
                let _e721 = phi_1111_;
                if (_e707[2] < 0f) {
                    phi_1118_ = -(_e707[2]);
                } else {
                    phi_1118_ = _e707[2];
                }
                let _e725 = phi_1118_;
                if (_e721 > _e725) {
                    phi_1123_ = _e721;
                } else {
                    phi_1123_ = _e725;
                }
                let _e728 = phi_1123_;
                let _e731 = local_12.member_1[1u];
                if (_e731[0] < 0f) {
                    phi_1137_ = -(_e731[0]);
                } else {
                    phi_1137_ = _e731[0];
                }
                let _e738 = phi_1137_;
                if (_e731[1] < 0f) {
                    phi_1144_ = -(_e731[1]);
                } else {
                    phi_1144_ = _e731[1];
                }
                let _e742 = phi_1144_;
                if (_e738 > _e742) {
                    phi_1149_ = _e738;
                } else {
                    phi_1149_ = _e742;
                }
                let _e745 = phi_1149_;
                if (_e731[2] < 0f) {
                    phi_1156_ = -(_e731[2]);
                } else {
                    phi_1156_ = _e731[2];
                }
                let _e749 = phi_1156_;
                if (_e745 > _e749) {
                    phi_1161_ = _e745;
                } else {
                    phi_1161_ = _e749;
                }
                let _e752 = phi_1161_;
                if (_e728 > _e752) {
                    phi_1166_ = _e728;
                } else {
                    phi_1166_ = _e752;
                }
                let _e755 = phi_1166_;
                let _e757 = local_12.member_3;
                let _e758 = (_e755 + _e757);
                let _e761 = local_12.member_2[0u];
                if (_e761[0] < 0f) {
                    phi_1183_ = -(_e761[0]);
                } else {
                    phi_1183_ = _e761[0];
                }
                let _e768 = phi_1183_;
                if (_e761[1] < 0f) {
                    phi_1190_ = -(_e761[1]);
                } else {
                    phi_1190_ = _e761[1];
                }
                let _e772 = phi_1190_;
                if (_e768 > _e772) {
                    phi_1195_ = _e768;
                } else {
                    phi_1195_ = _e772;
                }
                let _e775 = phi_1195_;
                if (_e761[2] < 0f) {
                    phi_1202_ = -(_e761[2]);
                } else {
                    phi_1202_ = _e761[2];
                }
                let _e779 = phi_1202_;
                if (_e775 > _e779) {
                    phi_1207_ = _e775;
                } else {
                    phi_1207_ = _e779;
                }
                let _e782 = phi_1207_;
                let _e785 = local_12.member_2[1u];
                if (_e785[0] < 0f) {
                    phi_1221_ = -(_e785[0]);
                } else {
                    phi_1221_ = _e785[0];
                }
                let _e792 = phi_1221_;
                if (_e785[1] < 0f) {
                    phi_1228_ = -(_e785[1]);
                } else {
                    phi_1228_ = _e785[1];
                }
                let _e796 = phi_1228_;
                if (_e792 > _e796) {
                    phi_1233_ = _e792;
                } else {
                    phi_1233_ = _e796;
                }
                let _e799 = phi_1233_;
                if (_e785[2] < 0f) {
                    phi_1240_ = -(_e785[2]);
                } else {
                    phi_1240_ = _e785[2];
                }
                let _e803 = phi_1240_;
                if (_e799 > _e803) {
                    phi_1245_ = _e799;
                } else {
                    phi_1245_ = _e803;
                }
                let _e806 = phi_1245_;
                if (_e782 > _e806) {
                    phi_1250_ = _e782;
                } else {
                    phi_1250_ = _e806;
                }
                let _e809 = phi_1250_;
                let _e811 = local_12.member_3;
                let _e812 = (_e809 + _e811);
                let _e814 = ((_e758 * 8f) * _e812);
                let _e821 = local_12.member_3;
                if (_e510 < 0f) {
                    phi_1281_ = -(_e510);
                } else {
                    phi_1281_ = _e510;
                }
                let _e838 = phi_1281_;
                if (_e513 < 0f) {
                    phi_1287_ = -(_e513);
                } else {
                    phi_1287_ = _e513;
                }
                let _e842 = phi_1287_;
                if (_e516 < 0f) {
                    phi_1294_ = -(_e516);
                } else {
                    phi_1294_ = _e516;
                }
                let _e847 = phi_1294_;
                let _e848 = ((_e838 + _e842) + _e847);
                if (_e531 < 0f) {
                    phi_1301_ = -(_e531);
                } else {
                    phi_1301_ = _e531;
                }
                let _e852 = phi_1301_;
                if (_e534 < 0f) {
                    phi_1307_ = -(_e534);
                } else {
                    phi_1307_ = _e534;
                }
                let _e856 = phi_1307_;
                if (_e537 < 0f) {
                    phi_1314_ = -(_e537);
                } else {
                    phi_1314_ = _e537;
                }
                let _e861 = phi_1314_;
                let _e862 = ((_e852 + _e856) + _e861);
                if (_e848 > _e862) {
                    phi_1320_ = _e848;
                } else {
                    phi_1320_ = _e862;
                }
                let _e865 = phi_1320_;
                if (_e580 < 0f) {
                    phi_1326_ = -(_e580);
                } else {
                    phi_1326_ = _e580;
                }
                let _e869 = phi_1326_;
                if (_e581 < 0f) {
                    phi_1332_ = -(_e581);
                } else {
                    phi_1332_ = _e581;
                }
                let _e873 = phi_1332_;
                if (_e582 < 0f) {
                    phi_1339_ = -(_e582);
                } else {
                    phi_1339_ = _e582;
                }
                let _e878 = phi_1339_;
                let _e880 = (((_e869 + _e873) + _e878) * 0.5f);
                if (_e865 > _e880) {
                    phi_1346_ = _e865;
                } else {
                    phi_1346_ = _e880;
                }
                let _e883 = phi_1346_;
                let _e888 = local_12.member_3;
                let _e900 = (((((_e704 * 8f) * _e814) * (0.000000059604645f * (524f / 64f))) + ((_e821 * 19f) * ((_e704 * (_e758 + _e812)) + (_e758 * _e812)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e704) * ((1f + _e758) * (1f + _e812)))));
                let _e901 = (_e593 * 3f);
                let _e902 = (_e650 * 3f);
                if (_e901 < _e902) {
                    phi_1370_ = _e901;
                } else {
                    phi_1370_ = _e902;
                }
                let _e905 = phi_1370_;
                if (_e616 < _e639) {
                    phi_1375_ = _e616;
                } else {
                    phi_1375_ = _e639;
                }
                let _e908 = phi_1375_;
                if (_e905 < _e908) {
                    phi_1380_ = _e905;
                } else {
                    phi_1380_ = _e908;
                }
                let _e911 = phi_1380_;
                if (_e901 > _e902) {
                    phi_1385_ = _e901;
                } else {
                    phi_1385_ = _e902;
                }
                let _e914 = phi_1385_;
                if (_e616 > _e639) {
                    phi_1390_ = _e616;
                } else {
                    phi_1390_ = _e639;
                }
                let _e917 = phi_1390_;
                if (_e914 > _e917) {
                    phi_1395_ = _e914;
                } else {
                    phi_1395_ = _e917;
                }
                let _e920 = phi_1395_;
                let _e925 = -(_e920);
                if (_e911 > _e925) {
                    phi_1405_ = _e911;
                } else {
                    phi_1405_ = _e925;
                }
                let _e928 = phi_1405_;
                if ((_e928 - (_e900 + ((_e455.member_1 * (((_e883 + (_e814 * (0.000000059604645f * 8f))) + ((_e888 * 6f) * (_e758 + _e812))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e758) * (1f + _e812))))) * (3f * 1.0001f)))) > 0f) {
                    phi_7927_ = type_35(0u, type_35().member_1);
                } else {
                    if (_e455.member_1 > 0f) {
                        let _e3494 = local_12.member[0u];
                        let _e3500 = local_12.member_1[0u];
                        let _e3506 = local_12.member_2[0u];
                        let _e3510 = (_e3494[0] - _e3500[0]);
                        let _e3511 = (_e3494[1] - _e3500[1]);
                        let _e3512 = (_e3494[2] - _e3500[2]);
                        let _e3521 = local_12.member[1u];
                        let _e3527 = local_12.member_1[1u];
                        let _e3533 = local_12.member_2[1u];
                        let _e3537 = (_e3521[0] - _e3527[0]);
                        let _e3538 = (_e3521[1] - _e3527[1]);
                        let _e3539 = (_e3521[2] - _e3527[2]);
                        let _e3548 = local_12.member[0u];
                        if (_e3548[0] < 0f) {
                            phi_1558_ = -(_e3548[0]);
                        } else {
                            phi_1558_ = _e3548[0];
                        }
                        let _e3555 = phi_1558_;
                        if (_e3548[1] < 0f) {
                            phi_1565_ = -(_e3548[1]);
                        } else {
                            phi_1565_ = _e3548[1];
                        }
                        let _e3559 = phi_1565_;
                        if (_e3555 > _e3559) {
                            phi_1570_ = _e3555;
                        } else {
                            phi_1570_ = _e3559;
                        }
                        let _e3562 = phi_1570_;
                        if (_e3548[2] < 0f) {
                            phi_1577_ = -(_e3548[2]);
                        } else {
                            phi_1577_ = _e3548[2];
                        }
                        let _e3566 = phi_1577_;
                        if (_e3562 > _e3566) {
                            phi_1582_ = _e3562;
                        } else {
                            phi_1582_ = _e3566;
                        }
                        let _e3569 = phi_1582_;
                        let _e3572 = local_12.member[1u];
                        if (_e3572[0] < 0f) {
                            phi_1595_ = -(_e3572[0]);
                        } else {
                            phi_1595_ = _e3572[0];
                        }
                        let _e3579 = phi_1595_;
                        if (_e3572[1] < 0f) {
                            phi_1602_ = -(_e3572[1]);
                        } else {
                            phi_1602_ = _e3572[1];
                        }
                        let _e3583 = phi_1602_;
                        if (_e3579 > _e3583) {
                            phi_1607_ = _e3579;
                        } else {
                            phi_1607_ = _e3583;
                        }
                        let _e3586 = phi_1607_;
                        if (_e3572[2] < 0f) {
                            phi_1614_ = -(_e3572[2]);
                        } else {
                            phi_1614_ = _e3572[2];
                        }
                        let _e3590 = phi_1614_;
                        if (_e3586 > _e3590) {
                            phi_1619_ = _e3586;
                        } else {
                            phi_1619_ = _e3590;
                        }
                        let _e3593 = phi_1619_;
                        if (_e3569 > _e3593) {
                            phi_1624_ = _e3569;
                        } else {
                            phi_1624_ = _e3593;
                        }
                        let _e3596 = phi_1624_;
                        let _e3598 = local_12.member_3;
                        let _e3602 = local_12.member_1[0u];
                        if (_e3602[0] < 0f) {
                            phi_1641_ = -(_e3602[0]);
                        } else {
                            phi_1641_ = _e3602[0];
                        }
                        let _e3609 = phi_1641_;
                        if (_e3602[1] < 0f) {
                            phi_1648_ = -(_e3602[1]);
                        } else {
                            phi_1648_ = _e3602[1];
                        }
                        let _e3613 = phi_1648_;
                        if (_e3609 > _e3613) {
                            phi_1653_ = _e3609;
                        } else {
                            phi_1653_ = _e3613;
                        }
                        let _e3616 = phi_1653_;
                        if (_e3602[2] < 0f) {
                            phi_1660_ = -(_e3602[2]);
                        } else {
                            phi_1660_ = _e3602[2];
                        }
                        let _e3620 = phi_1660_;
                        if (_e3616 > _e3620) {
                            phi_1665_ = _e3616;
                        } else {
                            phi_1665_ = _e3620;
                        }
                        let _e3623 = phi_1665_;
                        let _e3626 = local_12.member_1[1u];
                        if (_e3626[0] < 0f) {
                            phi_1679_ = -(_e3626[0]);
                        } else {
                            phi_1679_ = _e3626[0];
                        }
                        let _e3633 = phi_1679_;
                        if (_e3626[1] < 0f) {
                            phi_1686_ = -(_e3626[1]);
                        } else {
                            phi_1686_ = _e3626[1];
                        }
                        let _e3637 = phi_1686_;
                        if (_e3633 > _e3637) {
                            phi_1691_ = _e3633;
                        } else {
                            phi_1691_ = _e3637;
                        }
                        let _e3640 = phi_1691_;
                        if (_e3626[2] < 0f) {
                            phi_1698_ = -(_e3626[2]);
                        } else {
                            phi_1698_ = _e3626[2];
                        }
                        let _e3644 = phi_1698_;
                        if (_e3640 > _e3644) {
                            phi_1703_ = _e3640;
                        } else {
                            phi_1703_ = _e3644;
                        }
                        let _e3647 = phi_1703_;
                        if (_e3623 > _e3647) {
                            phi_1708_ = _e3623;
                        } else {
                            phi_1708_ = _e3647;
                        }
                        let _e3650 = phi_1708_;
                        let _e3652 = local_12.member_3;
                        let _e3656 = local_12.member_2[0u];
                        if (_e3656[0] < 0f) {
                            phi_1725_ = -(_e3656[0]);
                        } else {
                            phi_1725_ = _e3656[0];
                        }
                        let _e3663 = phi_1725_;
                        if (_e3656[1] < 0f) {
                            phi_1732_ = -(_e3656[1]);
                        } else {
                            phi_1732_ = _e3656[1];
                        }
                        let _e3667 = phi_1732_;
                        if (_e3663 > _e3667) {
                            phi_1737_ = _e3663;
                        } else {
                            phi_1737_ = _e3667;
                        }
                        let _e3670 = phi_1737_;
                        if (_e3656[2] < 0f) {
                            phi_1744_ = -(_e3656[2]);
                        } else {
                            phi_1744_ = _e3656[2];
                        }
                        let _e3674 = phi_1744_;
                        if (_e3670 > _e3674) {
                            phi_1749_ = _e3670;
                        } else {
                            phi_1749_ = _e3674;
                        }
                        let _e3677 = phi_1749_;
                        let _e3680 = local_12.member_2[1u];
                        if (_e3680[0] < 0f) {
                            phi_1763_ = -(_e3680[0]);
                        } else {
                            phi_1763_ = _e3680[0];
                        }
                        let _e3687 = phi_1763_;
                        if (_e3680[1] < 0f) {
                            phi_1770_ = -(_e3680[1]);
                        } else {
                            phi_1770_ = _e3680[1];
                        }
                        let _e3691 = phi_1770_;
                        if (_e3687 > _e3691) {
                            phi_1775_ = _e3687;
                        } else {
                            phi_1775_ = _e3691;
                        }
                        let _e3694 = phi_1775_;
                        if (_e3680[2] < 0f) {
                            phi_1782_ = -(_e3680[2]);
                        } else {
                            phi_1782_ = _e3680[2];
                        }
                        let _e3698 = phi_1782_;
                        if (_e3694 > _e3698) {
                            phi_1787_ = _e3694;
                        } else {
                            phi_1787_ = _e3698;
                        }
                        let _e3701 = phi_1787_;
                        if (_e3677 > _e3701) {
                            phi_1792_ = _e3677;
                        } else {
                            phi_1792_ = _e3701;
                        }
                        let _e3704 = phi_1792_;
                        let _e3706 = local_12.member_3;
                        let _e3713 = local_12.member_3;
                        local_9 = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_1831_ = type_9(0u, 96u);
                        phi_1834_ = 0f;
                        phi_1836_ = 0f;
                        phi_1838_ = 0f;
                        loop {
                            let _e3719 = phi_1831_;
                            let _e3721 = phi_1834_;
                            let _e3723 = phi_1836_;
                            let _e3725 = phi_1838_;
                            local_44 = _e3723;
                            local_26 = _e3721;
                            if (_e3719.member < _e3719.member_1) {
                                phi_1832_ = type_9((_e3719.member + 1u), _e3719.member_1);
                                phi_1861_ = type_9(1u, _e3719.member);
                            } else {
                                phi_1832_ = _e3719;
                                phi_1861_ = type_9(0u, type_9().member_1);
                            }
                            let _e3737 = phi_1832_;
                            let _e3739 = phi_1861_;
                            if (bitcast<i32>(_e3739.member) != 0i) {
                                let _e3746 = local_12.member[0u];
                                let _e3752 = local_12.member[1u];
                                let _e3768 = local_12.member_1[0u];
                                let _e3774 = local_12.member_1[1u];
                                let _e3790 = local_12.member_2[0u];
                                let _e3796 = local_12.member_2[1u];
                                let _e3810 = function_2(array<f32, 3>((_e3746[0] + ((_e3752[0] - _e3746[0]) * _e3721)), (_e3746[1] + ((_e3752[1] - _e3746[1]) * _e3721)), (_e3746[2] + ((_e3752[2] - _e3746[2]) * _e3721))), array<f32, 3>((_e3768[0] + ((_e3774[0] - _e3768[0]) * _e3721)), (_e3768[1] + ((_e3774[1] - _e3768[1]) * _e3721)), (_e3768[2] + ((_e3774[2] - _e3768[2]) * _e3721))), array<f32, 3>((_e3790[0] + ((_e3796[0] - _e3790[0]) * _e3721)), (_e3790[1] + ((_e3796[1] - _e3790[1]) * _e3721)), (_e3790[2] + ((_e3796[2] - _e3790[2]) * _e3721))), 1u);
                                if (_e3810[0] < 0f) {
                                    phi_1973_ = -(_e3810[0]);
                                } else {
                                    phi_1973_ = _e3810[0];
                                }
                                let _e3815 = phi_1973_;
                                if (_e3810[1] < 0f) {
                                    phi_1980_ = -(_e3810[1]);
                                } else {
                                    phi_1980_ = _e3810[1];
                                }
                                let _e3820 = phi_1980_;
                                if (_e3810[2] < 0f) {
                                    phi_1988_ = -(_e3810[2]);
                                } else {
                                    phi_1988_ = _e3810[2];
                                }
                                let _e3826 = phi_1988_;
                                let _e3827 = ((_e3815 + _e3820) + _e3826);
                                if (_e3827 > 0f) {
                                    if ((bitcast<u32>(_e3827) & 2139095040u) != 2139095040u) {
                                        let _e3832 = (1f / _e3827);
                                        let _e3834 = (_e3810[0] * _e3832);
                                        let _e3836 = (_e3810[1] * _e3832);
                                        let _e3838 = (_e3810[2] * _e3832);
                                        let _e3843 = (((_e3834 * _e3834) + (_e3836 * _e3836)) + (_e3838 * _e3838));
                                        if (_e3843 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3843 > 0f) {
                                                phi_2025_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2025_ = 0f;
                                            }
                                            let _e3896 = phi_2025_;
                                            phi_2089_ = _e3896;
                                        } else {
                                            phi_2032_ = type_14(0i, 5i);
                                            phi_2035_ = bitcast<f32>(((bitcast<u32>(_e3843) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3851 = phi_2032_;
                                                let _e3853 = phi_2035_;
                                                local_24 = _e3853;
                                                if (_e3851.member < _e3851.member_1) {
                                                    let _e3860 = (_e3851.member + 1i);
                                                    if ((false == (_e3860 > _e3851.member)) != false) {
                                                        phi_2056_ = true;
                                                    } else {
                                                        phi_2056_ = false;
                                                    }
                                                    let _e3865 = phi_2056_;
                                                    if _e3865 {
                                                        phi_2062_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_2062_ = type_15(1u, _e3860);
                                                    }
                                                    let _e3870 = phi_2062_;
                                                    phi_2033_ = type_14(_e3870.member_1, _e3851.member_1);
                                                    phi_2076_ = type_15(1u, _e3851.member);
                                                } else {
                                                    phi_2033_ = _e3851;
                                                    phi_2076_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3876 = phi_2033_;
                                                let _e3878 = phi_2076_;
                                                let _e3881 = (bitcast<i32>(_e3878.member) != 0i);
                                                if _e3881 {
                                                    phi_2036_ = (0.5f * (_e3853 + (_e3843 / _e3853)));
                                                } else {
                                                    phi_2036_ = f32();
                                                }
                                                let _e3886 = phi_2036_;
                                                continue;
                                                continuing {
                                                    phi_2032_ = _e3876;
                                                    phi_2035_ = _e3886;
                                                    break if !(_e3881);
                                                }
                                            }
                                            let _e3891 = local_24;
                                            phi_2089_ = (_e3891 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3898 = phi_2089_;
                                        let _e3899 = (0.000000059604645f * 12f);
                                        let _e3904 = ((((((((_e3596 + _e3598) + (_e3650 + _e3652)) + (_e3704 + _e3706)) * (0.000000059604645f * 16f)) + (_e3713 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e455.member_1 * _e3898) * (1f + _e3899)));
                                        let _e3909 = (((_e3834 * _e3494[0]) + (_e3836 * _e3494[1])) + (_e3838 * _e3494[2]));
                                        let _e3914 = (((_e3834 * _e3510) + (_e3836 * _e3511)) + (_e3838 * _e3512));
                                        let _e3919 = (((_e3834 * (_e3494[0] - _e3506[0])) + (_e3836 * (_e3494[1] - _e3506[1]))) + (_e3838 * (_e3494[2] - _e3506[2])));
                                        let _e3924 = (((_e3834 * (_e3510 - _e3506[0])) + (_e3836 * (_e3511 - _e3506[1]))) + (_e3838 * (_e3512 - _e3506[2])));
                                        let _e3930 = (((_e3834 * _e3521[0]) + (_e3836 * _e3521[1])) + (_e3838 * _e3521[2]));
                                        let _e3935 = (((_e3834 * _e3537) + (_e3836 * _e3538)) + (_e3838 * _e3539));
                                        let _e3940 = (((_e3834 * (_e3521[0] - _e3533[0])) + (_e3836 * (_e3521[1] - _e3533[1]))) + (_e3838 * (_e3521[2] - _e3533[2])));
                                        let _e3945 = (((_e3834 * (_e3537 - _e3533[0])) + (_e3836 * (_e3538 - _e3533[1]))) + (_e3838 * (_e3539 - _e3533[2])));
                                        if (_e3909 < 0f) {
                                            phi_2155_ = -(_e3909);
                                        } else {
                                            phi_2155_ = _e3909;
                                        }
                                        let _e3950 = phi_2155_;
                                        if (_e3930 < 0f) {
                                            phi_2161_ = -(_e3930);
                                        } else {
                                            phi_2161_ = _e3930;
                                        }
                                        let _e3954 = phi_2161_;
                                        if (_e3914 < 0f) {
                                            phi_2170_ = -(_e3914);
                                        } else {
                                            phi_2170_ = _e3914;
                                        }
                                        let _e3961 = phi_2170_;
                                        if (_e3935 < 0f) {
                                            phi_2176_ = -(_e3935);
                                        } else {
                                            phi_2176_ = _e3935;
                                        }
                                        let _e3965 = phi_2176_;
                                        if (_e3919 < 0f) {
                                            phi_2185_ = -(_e3919);
                                        } else {
                                            phi_2185_ = _e3919;
                                        }
                                        let _e3972 = phi_2185_;
                                        if (_e3940 < 0f) {
                                            phi_2191_ = -(_e3940);
                                        } else {
                                            phi_2191_ = _e3940;
                                        }
                                        let _e3976 = phi_2191_;
                                        if (_e3924 < 0f) {
                                            phi_2200_ = -(_e3924);
                                        } else {
                                            phi_2200_ = _e3924;
                                        }
                                        let _e3983 = phi_2200_;
                                        if (_e3945 < 0f) {
                                            phi_2206_ = -(_e3945);
                                        } else {
                                            phi_2206_ = _e3945;
                                        }
                                        let _e3987 = phi_2206_;
                                        phi_2212_ = type_30(array<f32, 4>(_e3909, _e3914, _e3919, _e3924), array<f32, 4>(_e3930, _e3935, _e3940, _e3945), array<f32, 4>((_e3904 + ((_e3950 + _e3954) * _e3899)), (_e3904 + ((_e3961 + _e3965) * _e3899)), (_e3904 + ((_e3972 + _e3976) * _e3899)), (_e3904 + ((_e3983 + _e3987) * _e3899))));
                                        phi_2213_ = false;
                                    } else {
                                        phi_2212_ = type_30();
                                        phi_2213_ = true;
                                    }
                                    let _e3994 = phi_2212_;
                                    let _e3996 = phi_2213_;
                                    phi_2214_ = _e3994;
                                    phi_2215_ = _e3996;
                                } else {
                                    phi_2214_ = type_30();
                                    phi_2215_ = true;
                                }
                                let _e3998 = phi_2214_;
                                let _e4000 = phi_2215_;
                                if _e4000 {
                                    phi_2223_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2223_ = _e3998;
                                }
                                let _e4002 = phi_2223_;
                                local_10 = type_30(array<f32, 4>(_e4002.member[0], _e4002.member[1], _e4002.member[2], _e4002.member[3]), array<f32, 4>(_e4002.member_1[0], _e4002.member_1[1], _e4002.member_1[2], _e4002.member_1[3]), array<f32, 4>(_e4002.member_2[0], _e4002.member_2[1], _e4002.member_2[2], _e4002.member_2[3]));
                                let _e4022 = (_e3721 - _e3725);
                                let _e4025 = local_10.member[0u];
                                let _e4028 = local_10.member_1[0u];
                                let _e4031 = local_10.member[0u];
                                let _e4037 = local_10.member_2[0u];
                                if (((_e4025 + ((_e4028 - _e4031) * _e3721)) - _e4037) > 0f) {
                                    let _e4042 = local_10.member[1u];
                                    let _e4045 = local_10.member_1[1u];
                                    let _e4048 = local_10.member[1u];
                                    let _e4054 = local_10.member_2[1u];
                                    if (((_e4042 + ((_e4045 - _e4048) * _e3721)) - _e4054) > 0f) {
                                        let _e4059 = local_10.member[2u];
                                        let _e4062 = local_10.member_1[2u];
                                        let _e4065 = local_10.member[2u];
                                        let _e4071 = local_10.member_2[2u];
                                        if (((_e4059 + ((_e4062 - _e4065) * _e3721)) - _e4071) > 0f) {
                                            let _e4076 = local_10.member[3u];
                                            let _e4079 = local_10.member_1[3u];
                                            let _e4082 = local_10.member[3u];
                                            let _e4088 = local_10.member_2[3u];
                                            phi_2393_ = (((_e4076 + ((_e4079 - _e4082) * _e3721)) - _e4088) > 0f);
                                            phi_2394_ = false;
                                        } else {
                                            phi_2393_ = bool();
                                            phi_2394_ = true;
                                        }
                                        let _e4092 = phi_2393_;
                                        let _e4094 = phi_2394_;
                                        phi_2395_ = _e4092;
                                        phi_2396_ = _e4094;
                                    } else {
                                        phi_2395_ = bool();
                                        phi_2396_ = true;
                                    }
                                    let _e4096 = phi_2395_;
                                    let _e4098 = phi_2396_;
                                    phi_2397_ = _e4096;
                                    phi_2398_ = _e4098;
                                } else {
                                    phi_2397_ = bool();
                                    phi_2398_ = true;
                                }
                                let _e4100 = phi_2397_;
                                let _e4102 = phi_2398_;
                                if _e4102 {
                                    phi_2402_ = false;
                                } else {
                                    phi_2402_ = _e4100;
                                }
                                let _e4104 = phi_2402_;
                                if _e4104 {
                                    if (_e3721 <= _e3723) {
                                        phi_2712_ = true;
                                    } else {
                                        let _e4108 = local_9.member[0u];
                                        let _e4111 = local_9.member_1[0u];
                                        let _e4114 = local_9.member[0u];
                                        let _e4120 = local_9.member_2[0u];
                                        let _e4124 = local_10.member[0u];
                                        let _e4127 = local_10.member_1[0u];
                                        let _e4130 = local_10.member[0u];
                                        let _e4136 = local_10.member_2[0u];
                                        if ((((_e4108 + ((_e4111 - _e4114) * _e3721)) - _e4120) + ((_e4124 + ((_e4127 - _e4130) * _e3725)) - _e4136)) > 0f) {
                                            let _e4142 = local_9.member[1u];
                                            let _e4145 = local_9.member_1[1u];
                                            let _e4148 = local_9.member[1u];
                                            let _e4154 = local_9.member_2[1u];
                                            let _e4158 = local_10.member[1u];
                                            let _e4161 = local_10.member_1[1u];
                                            let _e4164 = local_10.member[1u];
                                            let _e4170 = local_10.member_2[1u];
                                            if ((((_e4142 + ((_e4145 - _e4148) * _e3721)) - _e4154) + ((_e4158 + ((_e4161 - _e4164) * _e3725)) - _e4170)) > 0f) {
                                                let _e4176 = local_9.member[2u];
                                                let _e4179 = local_9.member_1[2u];
                                                let _e4182 = local_9.member[2u];
                                                let _e4188 = local_9.member_2[2u];
                                                let _e4192 = local_10.member[2u];
                                                let _e4195 = local_10.member_1[2u];
                                                let _e4198 = local_10.member[2u];
                                                let _e4204 = local_10.member_2[2u];
                                                if ((((_e4176 + ((_e4179 - _e4182) * _e3721)) - _e4188) + ((_e4192 + ((_e4195 - _e4198) * _e3725)) - _e4204)) > 0f) {
                                                    let _e4210 = local_9.member[3u];
                                                    let _e4213 = local_9.member_1[3u];
                                                    let _e4216 = local_9.member[3u];
                                                    let _e4222 = local_9.member_2[3u];
                                                    let _e4226 = local_10.member[3u];
                                                    let _e4229 = local_10.member_1[3u];
                                                    let _e4232 = local_10.member[3u];
                                                    let _e4238 = local_10.member_2[3u];
                                                    phi_2699_ = ((((_e4210 + ((_e4213 - _e4216) * _e3721)) - _e4222) + ((_e4226 + ((_e4229 - _e4232) * _e3725)) - _e4238)) > 0f);
                                                    phi_2700_ = false;
                                                } else {
                                                    phi_2699_ = bool();
                                                    phi_2700_ = true;
                                                }
                                                let _e4243 = phi_2699_;
                                                let _e4245 = phi_2700_;
                                                phi_2701_ = _e4243;
                                                phi_2702_ = _e4245;
                                            } else {
                                                phi_2701_ = bool();
                                                phi_2702_ = true;
                                            }
                                            let _e4247 = phi_2701_;
                                            let _e4249 = phi_2702_;
                                            phi_2703_ = _e4247;
                                            phi_2704_ = _e4249;
                                        } else {
                                            phi_2703_ = bool();
                                            phi_2704_ = true;
                                        }
                                        let _e4251 = phi_2703_;
                                        let _e4253 = phi_2704_;
                                        if _e4253 {
                                            phi_2708_ = false;
                                        } else {
                                            phi_2708_ = _e4251;
                                        }
                                        let _e4255 = phi_2708_;
                                        phi_2712_ = _e4255;
                                    }
                                    let _e4257 = phi_2712_;
                                    if _e4257 {
                                        if (_e3739.member_1 > 0u) {
                                            if (_e3721 >= 1f) {
                                                phi_2724_ = false;
                                            } else {
                                                phi_2724_ = true;
                                            }
                                            let _e4261 = phi_2724_;
                                            phi_2725_ = _e4261;
                                        } else {
                                            phi_2725_ = true;
                                        }
                                        let _e4263 = phi_2725_;
                                        if _e4263 {
                                            local_9 = type_30(array<f32, 4>(_e4002.member[0], _e4002.member[1], _e4002.member[2], _e4002.member[3]), array<f32, 4>(_e4002.member_1[0], _e4002.member_1[1], _e4002.member_1[2], _e4002.member_1[3]), array<f32, 4>(_e4002.member_2[0], _e4002.member_2[1], _e4002.member_2[2], _e4002.member_2[3]));
                                            let _e4285 = local_9.member[0u];
                                            let _e4288 = local_9.member_1[0u];
                                            let _e4291 = local_9.member_2[0u];
                                            if (_e4285 > _e4291) {
                                                if (_e4288 > _e4291) {
                                                    phi_2799_ = false;
                                                } else {
                                                    phi_2799_ = true;
                                                }
                                                let _e4295 = phi_2799_;
                                                phi_2800_ = _e4295;
                                            } else {
                                                phi_2800_ = true;
                                            }
                                            let _e4297 = phi_2800_;
                                            if _e4297 {
                                                let _e4298 = (_e4288 >= _e4285);
                                                if _e4298 {
                                                    phi_2822_ = f32();
                                                    phi_2823_ = false;
                                                } else {
                                                    if ((_e4285 - _e4288) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2820_ = (((_e4285 - _e4291) / (_e4285 - _e4288)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2821_ = false;
                                                    } else {
                                                        phi_2820_ = f32();
                                                        phi_2821_ = true;
                                                    }
                                                    let _e4309 = phi_2820_;
                                                    let _e4311 = phi_2821_;
                                                    phi_2822_ = _e4309;
                                                    phi_2823_ = _e4311;
                                                }
                                                let _e4313 = phi_2822_;
                                                let _e4315 = phi_2823_;
                                                phi_2824_ = _e4313;
                                                phi_2825_ = _e4298;
                                                phi_2826_ = _e4315;
                                            } else {
                                                phi_2824_ = f32();
                                                phi_2825_ = true;
                                                phi_2826_ = false;
                                            }
                                            let _e4317 = phi_2824_;
                                            let _e4319 = phi_2825_;
                                            let _e4321 = phi_2826_;
                                            if _e4319 {
                                                phi_2830_ = 2f;
                                                phi_2831_ = true;
                                            } else {
                                                phi_2830_ = _e3721;
                                                phi_2831_ = _e4321;
                                            }
                                            let _e4323 = phi_2830_;
                                            let _e4325 = phi_2831_;
                                            if _e4325 {
                                                phi_2835_ = _e4323;
                                            } else {
                                                phi_2835_ = _e4317;
                                            }
                                            let _e4327 = phi_2835_;
                                            let _e4330 = local_9.member[1u];
                                            let _e4333 = local_9.member_1[1u];
                                            let _e4336 = local_9.member_2[1u];
                                            if (_e4330 > _e4336) {
                                                if (_e4333 > _e4336) {
                                                    phi_2867_ = false;
                                                } else {
                                                    phi_2867_ = true;
                                                }
                                                let _e4340 = phi_2867_;
                                                phi_2868_ = _e4340;
                                            } else {
                                                phi_2868_ = true;
                                            }
                                            let _e4342 = phi_2868_;
                                            if _e4342 {
                                                let _e4343 = (_e4333 >= _e4330);
                                                if _e4343 {
                                                    phi_2890_ = f32();
                                                    phi_2891_ = false;
                                                } else {
                                                    if ((_e4330 - _e4333) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2888_ = (((_e4330 - _e4336) / (_e4330 - _e4333)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2889_ = false;
                                                    } else {
                                                        phi_2888_ = f32();
                                                        phi_2889_ = true;
                                                    }
                                                    let _e4354 = phi_2888_;
                                                    let _e4356 = phi_2889_;
                                                    phi_2890_ = _e4354;
                                                    phi_2891_ = _e4356;
                                                }
                                                let _e4358 = phi_2890_;
                                                let _e4360 = phi_2891_;
                                                phi_2892_ = _e4358;
                                                phi_2893_ = _e4343;
                                                phi_2894_ = _e4360;
                                            } else {
                                                phi_2892_ = f32();
                                                phi_2893_ = true;
                                                phi_2894_ = false;
                                            }
                                            let _e4362 = phi_2892_;
                                            let _e4364 = phi_2893_;
                                            let _e4366 = phi_2894_;
                                            if _e4364 {
                                                phi_2898_ = 2f;
                                                phi_2899_ = true;
                                            } else {
                                                phi_2898_ = _e3721;
                                                phi_2899_ = _e4366;
                                            }
                                            let _e4368 = phi_2898_;
                                            let _e4370 = phi_2899_;
                                            if _e4370 {
                                                phi_2903_ = _e4368;
                                            } else {
                                                phi_2903_ = _e4362;
                                            }
                                            let _e4372 = phi_2903_;
                                            if (_e4327 < _e4372) {
                                                phi_2908_ = _e4327;
                                            } else {
                                                phi_2908_ = _e4372;
                                            }
                                            let _e4375 = phi_2908_;
                                            let _e4378 = local_9.member[2u];
                                            let _e4381 = local_9.member_1[2u];
                                            let _e4384 = local_9.member_2[2u];
                                            if (_e4378 > _e4384) {
                                                if (_e4381 > _e4384) {
                                                    phi_2940_ = false;
                                                } else {
                                                    phi_2940_ = true;
                                                }
                                                let _e4388 = phi_2940_;
                                                phi_2941_ = _e4388;
                                            } else {
                                                phi_2941_ = true;
                                            }
                                            let _e4390 = phi_2941_;
                                            if _e4390 {
                                                let _e4391 = (_e4381 >= _e4378);
                                                if _e4391 {
                                                    phi_2963_ = f32();
                                                    phi_2964_ = false;
                                                } else {
                                                    if ((_e4378 - _e4381) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2961_ = (((_e4378 - _e4384) / (_e4378 - _e4381)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2962_ = false;
                                                    } else {
                                                        phi_2961_ = f32();
                                                        phi_2962_ = true;
                                                    }
                                                    let _e4402 = phi_2961_;
                                                    let _e4404 = phi_2962_;
                                                    phi_2963_ = _e4402;
                                                    phi_2964_ = _e4404;
                                                }
                                                let _e4406 = phi_2963_;
                                                let _e4408 = phi_2964_;
                                                phi_2965_ = _e4406;
                                                phi_2966_ = _e4391;
                                                phi_2967_ = _e4408;
                                            } else {
                                                phi_2965_ = f32();
                                                phi_2966_ = true;
                                                phi_2967_ = false;
                                            }
                                            let _e4410 = phi_2965_;
                                            let _e4412 = phi_2966_;
                                            let _e4414 = phi_2967_;
                                            if _e4412 {
                                                phi_2971_ = 2f;
                                                phi_2972_ = true;
                                            } else {
                                                phi_2971_ = _e3721;
                                                phi_2972_ = _e4414;
                                            }
                                            let _e4416 = phi_2971_;
                                            let _e4418 = phi_2972_;
                                            if _e4418 {
                                                phi_2976_ = _e4416;
                                            } else {
                                                phi_2976_ = _e4410;
                                            }
                                            let _e4420 = phi_2976_;
                                            let _e4423 = local_9.member[3u];
                                            let _e4426 = local_9.member_1[3u];
                                            let _e4429 = local_9.member_2[3u];
                                            if (_e4423 > _e4429) {
                                                if (_e4426 > _e4429) {
                                                    phi_3008_ = false;
                                                } else {
                                                    phi_3008_ = true;
                                                }
                                                let _e4433 = phi_3008_;
                                                phi_3009_ = _e4433;
                                            } else {
                                                phi_3009_ = true;
                                            }
                                            let _e4435 = phi_3009_;
                                            if _e4435 {
                                                let _e4436 = (_e4426 >= _e4423);
                                                if _e4436 {
                                                    phi_3031_ = f32();
                                                    phi_3032_ = false;
                                                } else {
                                                    if ((_e4423 - _e4426) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3029_ = (((_e4423 - _e4429) / (_e4423 - _e4426)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3030_ = false;
                                                    } else {
                                                        phi_3029_ = f32();
                                                        phi_3030_ = true;
                                                    }
                                                    let _e4447 = phi_3029_;
                                                    let _e4449 = phi_3030_;
                                                    phi_3031_ = _e4447;
                                                    phi_3032_ = _e4449;
                                                }
                                                let _e4451 = phi_3031_;
                                                let _e4453 = phi_3032_;
                                                phi_3033_ = _e4451;
                                                phi_3034_ = _e4436;
                                                phi_3035_ = _e4453;
                                            } else {
                                                phi_3033_ = f32();
                                                phi_3034_ = true;
                                                phi_3035_ = false;
                                            }
                                            let _e4455 = phi_3033_;
                                            let _e4457 = phi_3034_;
                                            let _e4459 = phi_3035_;
                                            if _e4457 {
                                                phi_3039_ = 2f;
                                                phi_3040_ = true;
                                            } else {
                                                phi_3039_ = _e3721;
                                                phi_3040_ = _e4459;
                                            }
                                            let _e4461 = phi_3039_;
                                            let _e4463 = phi_3040_;
                                            if _e4463 {
                                                phi_3044_ = _e4461;
                                            } else {
                                                phi_3044_ = _e4455;
                                            }
                                            let _e4465 = phi_3044_;
                                            if (_e4420 < _e4465) {
                                                phi_3049_ = _e4420;
                                            } else {
                                                phi_3049_ = _e4465;
                                            }
                                            let _e4468 = phi_3049_;
                                            if (_e4375 < _e4468) {
                                                phi_3054_ = _e4375;
                                            } else {
                                                phi_3054_ = _e4468;
                                            }
                                            let _e4471 = phi_3054_;
                                            if (_e4471 > _e3721) {
                                                phi_3059_ = _e4471;
                                            } else {
                                                phi_3059_ = _e3721;
                                            }
                                            let _e4474 = phi_3059_;
                                            let _e4475 = (_e4474 > 1f);
                                            if _e4475 {
                                                phi_3071_ = f32();
                                                phi_3072_ = false;
                                            } else {
                                                if (_e3739.member_1 == 0u) {
                                                    phi_3070_ = (1f - _e3721);
                                                } else {
                                                    phi_3070_ = (_e4022 + _e4022);
                                                }
                                                let _e4480 = phi_3070_;
                                                phi_3071_ = _e4480;
                                                phi_3072_ = true;
                                            }
                                            let _e4482 = phi_3071_;
                                            let _e4484 = phi_3072_;
                                            phi_3073_ = _e4474;
                                            phi_3074_ = _e4482;
                                            phi_3075_ = _e4484;
                                            phi_3076_ = _e4475;
                                            phi_3077_ = false;
                                        } else {
                                            phi_3073_ = f32();
                                            phi_3074_ = f32();
                                            phi_3075_ = false;
                                            phi_3076_ = false;
                                            phi_3077_ = true;
                                        }
                                        let _e4486 = phi_3073_;
                                        let _e4488 = phi_3074_;
                                        let _e4490 = phi_3075_;
                                        let _e4492 = phi_3076_;
                                        let _e4494 = phi_3077_;
                                        phi_3078_ = _e4486;
                                        phi_3079_ = _e4488;
                                        phi_3080_ = false;
                                        phi_3081_ = _e4490;
                                        phi_3082_ = _e4492;
                                        phi_3083_ = _e4494;
                                    } else {
                                        phi_3078_ = f32();
                                        phi_3079_ = f32();
                                        phi_3080_ = true;
                                        phi_3081_ = false;
                                        phi_3082_ = false;
                                        phi_3083_ = false;
                                    }
                                    let _e4496 = phi_3078_;
                                    let _e4498 = phi_3079_;
                                    let _e4500 = phi_3080_;
                                    let _e4502 = phi_3081_;
                                    let _e4504 = phi_3082_;
                                    let _e4506 = phi_3083_;
                                    phi_3084_ = _e4496;
                                    phi_3085_ = _e4498;
                                    phi_3086_ = _e4500;
                                    phi_3087_ = _e4502;
                                    phi_3088_ = _e4504;
                                    phi_3089_ = _e4506;
                                } else {
                                    phi_3084_ = f32();
                                    phi_3085_ = f32();
                                    phi_3086_ = true;
                                    phi_3087_ = false;
                                    phi_3088_ = false;
                                    phi_3089_ = false;
                                }
                                let _e4508 = phi_3084_;
                                let _e4510 = phi_3085_;
                                let _e4512 = phi_3086_;
                                let _e4514 = phi_3087_;
                                let _e4516 = phi_3088_;
                                let _e4518 = phi_3089_;
                                if _e4512 {
                                    let _e4519 = (_e3721 <= _e3723);
                                    if _e4519 {
                                        phi_3418_ = f32();
                                        phi_3419_ = false;
                                    } else {
                                        let _e4522 = local_9.member[0u];
                                        let _e4525 = local_9.member_1[0u];
                                        let _e4528 = local_9.member[0u];
                                        let _e4534 = local_9.member_2[0u];
                                        let _e4535 = ((_e4522 + ((_e4525 - _e4528) * _e3725)) - _e4534);
                                        let _e4538 = local_9.member[1u];
                                        let _e4541 = local_9.member_1[1u];
                                        let _e4544 = local_9.member[1u];
                                        let _e4550 = local_9.member_2[1u];
                                        let _e4551 = ((_e4538 + ((_e4541 - _e4544) * _e3725)) - _e4550);
                                        if (_e4535 < _e4551) {
                                            phi_3169_ = _e4535;
                                        } else {
                                            phi_3169_ = _e4551;
                                        }
                                        let _e4554 = phi_3169_;
                                        let _e4557 = local_9.member[2u];
                                        let _e4560 = local_9.member_1[2u];
                                        let _e4563 = local_9.member[2u];
                                        let _e4569 = local_9.member_2[2u];
                                        let _e4570 = ((_e4557 + ((_e4560 - _e4563) * _e3725)) - _e4569);
                                        let _e4573 = local_9.member[3u];
                                        let _e4576 = local_9.member_1[3u];
                                        let _e4579 = local_9.member[3u];
                                        let _e4585 = local_9.member_2[3u];
                                        let _e4586 = ((_e4573 + ((_e4576 - _e4579) * _e3725)) - _e4585);
                                        if (_e4570 < _e4586) {
                                            phi_3242_ = _e4570;
                                        } else {
                                            phi_3242_ = _e4586;
                                        }
                                        let _e4589 = phi_3242_;
                                        if (_e4554 < _e4589) {
                                            phi_3247_ = _e4554;
                                        } else {
                                            phi_3247_ = _e4589;
                                        }
                                        let _e4592 = phi_3247_;
                                        let _e4595 = local_10.member[0u];
                                        let _e4598 = local_10.member_1[0u];
                                        let _e4601 = local_10.member[0u];
                                        let _e4607 = local_10.member_2[0u];
                                        let _e4608 = ((_e4595 + ((_e4598 - _e4601) * _e3721)) - _e4607);
                                        let _e4611 = local_10.member[1u];
                                        let _e4614 = local_10.member_1[1u];
                                        let _e4617 = local_10.member[1u];
                                        let _e4623 = local_10.member_2[1u];
                                        let _e4624 = ((_e4611 + ((_e4614 - _e4617) * _e3721)) - _e4623);
                                        if (_e4608 < _e4624) {
                                            phi_3320_ = _e4608;
                                        } else {
                                            phi_3320_ = _e4624;
                                        }
                                        let _e4627 = phi_3320_;
                                        let _e4630 = local_10.member[2u];
                                        let _e4633 = local_10.member_1[2u];
                                        let _e4636 = local_10.member[2u];
                                        let _e4642 = local_10.member_2[2u];
                                        let _e4643 = ((_e4630 + ((_e4633 - _e4636) * _e3721)) - _e4642);
                                        let _e4646 = local_10.member[3u];
                                        let _e4649 = local_10.member_1[3u];
                                        let _e4652 = local_10.member[3u];
                                        let _e4658 = local_10.member_2[3u];
                                        let _e4659 = ((_e4646 + ((_e4649 - _e4652) * _e3721)) - _e4658);
                                        if (_e4643 < _e4659) {
                                            phi_3393_ = _e4643;
                                        } else {
                                            phi_3393_ = _e4659;
                                        }
                                        let _e4662 = phi_3393_;
                                        if (_e4627 < _e4662) {
                                            phi_3398_ = _e4627;
                                        } else {
                                            phi_3398_ = _e4662;
                                        }
                                        let _e4665 = phi_3398_;
                                        if (_e4665 > 0f) {
                                            phi_3416_ = 0.5f;
                                        } else {
                                            let _e4669 = (0.95f * (_e4592 / (_e4592 - _e4665)));
                                            if (_e4669 > 0.0625f) {
                                                if (_e4669 < 0.9f) {
                                                    phi_3414_ = _e4669;
                                                } else {
                                                    phi_3414_ = 0.9f;
                                                }
                                                let _e4673 = phi_3414_;
                                                phi_3415_ = _e4673;
                                            } else {
                                                phi_3415_ = 0.0625f;
                                            }
                                            let _e4675 = phi_3415_;
                                            phi_3416_ = _e4675;
                                        }
                                        let _e4677 = phi_3416_;
                                        phi_3418_ = (_e4022 * _e4677);
                                        phi_3419_ = true;
                                    }
                                    let _e4680 = phi_3418_;
                                    let _e4682 = phi_3419_;
                                    phi_3420_ = _e3723;
                                    phi_3421_ = _e4680;
                                    phi_3422_ = _e3725;
                                    phi_3423_ = _e4682;
                                    phi_3424_ = _e4519;
                                    phi_3425_ = false;
                                    phi_3426_ = false;
                                } else {
                                    phi_3420_ = _e4508;
                                    phi_3421_ = _e4510;
                                    phi_3422_ = _e3721;
                                    phi_3423_ = _e4514;
                                    phi_3424_ = false;
                                    phi_3425_ = _e4516;
                                    phi_3426_ = _e4518;
                                }
                                let _e4684 = phi_3420_;
                                let _e4686 = phi_3421_;
                                let _e4688 = phi_3422_;
                                let _e4690 = phi_3423_;
                                let _e4692 = phi_3424_;
                                let _e4694 = phi_3425_;
                                let _e4696 = phi_3426_;
                                if _e4690 {
                                    let _e4697 = (_e4688 + _e4686);
                                    if (_e4697 > _e4684) {
                                        phi_3435_ = _e4697;
                                    } else {
                                        phi_3435_ = _e4684;
                                    }
                                    let _e4700 = phi_3435_;
                                    if (_e4700 < 1f) {
                                        phi_3440_ = _e4700;
                                    } else {
                                        phi_3440_ = 1f;
                                    }
                                    let _e4703 = phi_3440_;
                                    if (_e3739.member_1 > 0u) {
                                        phi_3450_ = ((_e4703 - _e4688) > 0.0000000037252903f);
                                    } else {
                                        phi_3450_ = true;
                                    }
                                    let _e4708 = phi_3450_;
                                    if _e4708 {
                                        phi_3454_ = false;
                                    } else {
                                        phi_3454_ = true;
                                    }
                                    let _e4710 = phi_3454_;
                                    phi_3455_ = _e4703;
                                    phi_3456_ = _e4708;
                                    phi_3457_ = _e4710;
                                    phi_3458_ = false;
                                    phi_3459_ = false;
                                    phi_3460_ = false;
                                } else {
                                    phi_3455_ = f32();
                                    phi_3456_ = false;
                                    phi_3457_ = false;
                                    phi_3458_ = _e4692;
                                    phi_3459_ = _e4694;
                                    phi_3460_ = _e4696;
                                }
                                let _e4712 = phi_3455_;
                                let _e4714 = phi_3456_;
                                let _e4716 = phi_3457_;
                                let _e4718 = phi_3458_;
                                let _e4720 = phi_3459_;
                                let _e4722 = phi_3460_;
                                phi_1835_ = _e4712;
                                phi_1837_ = _e4684;
                                phi_1839_ = _e4688;
                                phi_3461_ = _e4684;
                                phi_3462_ = _e4714;
                                phi_3463_ = _e4716;
                                phi_3464_ = false;
                                phi_3465_ = _e4718;
                                phi_3466_ = _e4720;
                                phi_3467_ = _e4722;
                            } else {
                                phi_1835_ = f32();
                                phi_1837_ = f32();
                                phi_1839_ = f32();
                                phi_3461_ = f32();
                                phi_3462_ = false;
                                phi_3463_ = false;
                                phi_3464_ = true;
                                phi_3465_ = false;
                                phi_3466_ = false;
                                phi_3467_ = false;
                            }
                            let _e4724 = phi_1835_;
                            let _e4726 = phi_1837_;
                            let _e4728 = phi_1839_;
                            let _e4730 = phi_3461_;
                            let _e4732 = phi_3462_;
                            let _e4734 = phi_3463_;
                            let _e4736 = phi_3464_;
                            let _e4738 = phi_3465_;
                            let _e4740 = phi_3466_;
                            let _e4742 = phi_3467_;
                            local_25 = _e4734;
                            local_43 = _e4730;
                            local_45 = _e4736;
                            local_46 = _e4738;
                            local_47 = _e4740;
                            local_48 = _e4742;
                            continue;
                            continuing {
                                phi_1831_ = _e3737;
                                phi_1834_ = _e4724;
                                phi_1836_ = _e4726;
                                phi_1838_ = _e4728;
                                break if !(_e4732);
                            }
                        }
                        let _e4745 = local_25;
                        if _e4745 {
                            let _e6058 = local_43;
                            phi_3471_ = _e6058;
                            phi_3472_ = true;
                            phi_3473_ = false;
                            phi_3474_ = false;
                            phi_3475_ = false;
                        } else {
                            let _e6060 = local_44;
                            phi_3471_ = _e6060;
                            let _e6063 = local_45;
                            phi_3472_ = _e6063;
                            let _e6066 = local_46;
                            phi_3473_ = _e6066;
                            let _e6069 = local_47;
                            phi_3474_ = _e6069;
                            let _e6072 = local_48;
                            phi_3475_ = _e6072;
                        }
                        let _e4747 = phi_3471_;
                        let _e4749 = phi_3472_;
                        let _e4751 = phi_3473_;
                        let _e4753 = phi_3474_;
                        let _e4755 = phi_3475_;
                        if _e4749 {
                            phi_3480_ = type_35(1u, _e4747);
                            phi_3481_ = false;
                            phi_3482_ = false;
                            phi_3483_ = false;
                        } else {
                            phi_3480_ = type_35();
                            phi_3481_ = _e4751;
                            phi_3482_ = _e4753;
                            phi_3483_ = _e4755;
                        }
                        let _e4758 = phi_3480_;
                        let _e4760 = phi_3481_;
                        let _e4762 = phi_3482_;
                        let _e4764 = phi_3483_;
                        if _e4760 {
                            let _e4766 = local_26;
                            phi_3488_ = type_35(1u, _e4766);
                            phi_3489_ = false;
                            phi_3490_ = false;
                        } else {
                            phi_3488_ = type_35();
                            phi_3489_ = _e4762;
                            phi_3490_ = _e4764;
                        }
                        let _e4769 = phi_3488_;
                        let _e4771 = phi_3489_;
                        let _e4773 = phi_3490_;
                        if _e4771 {
                            phi_3495_ = type_35(0u, type_35().member_1);
                            phi_3496_ = false;
                            phi_3497_ = true;
                        } else {
                            phi_3495_ = _e4769;
                            phi_3496_ = _e4773;
                            phi_3497_ = _e4760;
                        }
                        let _e4777 = phi_3495_;
                        let _e4779 = phi_3496_;
                        let _e4781 = phi_3497_;
                        if _e4779 {
                            phi_3502_ = type_35(0u, type_35().member_1);
                            phi_3503_ = true;
                        } else {
                            phi_3502_ = _e4777;
                            phi_3503_ = _e4781;
                        }
                        let _e4785 = phi_3502_;
                        let _e4787 = phi_3503_;
                        if _e4787 {
                            phi_3507_ = _e4785;
                        } else {
                            phi_3507_ = _e4758;
                        }
                        let _e4789 = phi_3507_;
                        if (_e4789.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_3521_ = type_9(0u, 3u);
                            loop {
                                let _e4801 = phi_3521_;
                                if (_e4801.member < _e4801.member_1) {
                                    phi_3522_ = type_9((_e4801.member + 1u), _e4801.member_1);
                                    phi_3545_ = type_9(1u, _e4801.member);
                                } else {
                                    phi_3522_ = _e4801;
                                    phi_3545_ = type_9(0u, type_9().member_1);
                                }
                                let _e4813 = phi_3522_;
                                let _e4815 = phi_3545_;
                                if (bitcast<i32>(_e4815.member) != 0i) {
                                    let _e4821 = local_11[_e4815.member_1];
                                    let _e4822 = (_e4789.member_1 + _e4821);
                                    if (_e4822 < 1f) {
                                        phi_3565_ = _e4822;
                                    } else {
                                        phi_3565_ = 1f;
                                    }
                                    let _e4825 = phi_3565_;
                                    let _e4828 = local_12.member[0u];
                                    let _e4834 = local_12.member[1u];
                                    let _e4850 = local_12.member_1[0u];
                                    let _e4856 = local_12.member_1[1u];
                                    let _e4872 = local_12.member_2[0u];
                                    let _e4878 = local_12.member_2[1u];
                                    let _e4892 = function_2(array<f32, 3>((_e4828[0] + ((_e4834[0] - _e4828[0]) * _e4825)), (_e4828[1] + ((_e4834[1] - _e4828[1]) * _e4825)), (_e4828[2] + ((_e4834[2] - _e4828[2]) * _e4825))), array<f32, 3>((_e4850[0] + ((_e4856[0] - _e4850[0]) * _e4825)), (_e4850[1] + ((_e4856[1] - _e4850[1]) * _e4825)), (_e4850[2] + ((_e4856[2] - _e4850[2]) * _e4825))), array<f32, 3>((_e4872[0] + ((_e4878[0] - _e4872[0]) * _e4825)), (_e4872[1] + ((_e4878[1] - _e4872[1]) * _e4825)), (_e4872[2] + ((_e4878[2] - _e4872[2]) * _e4825))), 1u);
                                    let _e4903 = (((_e4892[0] * _e4892[0]) + (_e4892[1] * _e4892[1])) + (_e4892[2] * _e4892[2]));
                                    if (_e4903 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4903 > 0f) {
                                            phi_3688_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3688_ = 0f;
                                        }
                                        let _e4956 = phi_3688_;
                                        phi_3752_ = _e4956;
                                    } else {
                                        phi_3695_ = type_14(0i, 5i);
                                        phi_3698_ = bitcast<f32>(((bitcast<u32>(_e4903) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4911 = phi_3695_;
                                            let _e4913 = phi_3698_;
                                            local_27 = _e4913;
                                            if (_e4911.member < _e4911.member_1) {
                                                let _e4920 = (_e4911.member + 1i);
                                                if ((false == (_e4920 > _e4911.member)) != false) {
                                                    phi_3719_ = true;
                                                } else {
                                                    phi_3719_ = false;
                                                }
                                                let _e4925 = phi_3719_;
                                                if _e4925 {
                                                    phi_3725_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3725_ = type_15(1u, _e4920);
                                                }
                                                let _e4930 = phi_3725_;
                                                phi_3696_ = type_14(_e4930.member_1, _e4911.member_1);
                                                phi_3739_ = type_15(1u, _e4911.member);
                                            } else {
                                                phi_3696_ = _e4911;
                                                phi_3739_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e4936 = phi_3696_;
                                            let _e4938 = phi_3739_;
                                            let _e4941 = (bitcast<i32>(_e4938.member) != 0i);
                                            if _e4941 {
                                                phi_3699_ = (0.5f * (_e4913 + (_e4903 / _e4913)));
                                            } else {
                                                phi_3699_ = f32();
                                            }
                                            let _e4946 = phi_3699_;
                                            continue;
                                            continuing {
                                                phi_3695_ = _e4936;
                                                phi_3698_ = _e4946;
                                                break if !(_e4941);
                                            }
                                        }
                                        let _e4951 = local_27;
                                        phi_3752_ = (_e4951 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4958 = phi_3752_;
                                    let _e4964 = local_12.member[0u];
                                    if (_e4964[0] < 0f) {
                                        phi_3768_ = -(_e4964[0]);
                                    } else {
                                        phi_3768_ = _e4964[0];
                                    }
                                    let _e4971 = phi_3768_;
                                    if (_e4964[1] < 0f) {
                                        phi_3775_ = -(_e4964[1]);
                                    } else {
                                        phi_3775_ = _e4964[1];
                                    }
                                    let _e4975 = phi_3775_;
                                    if (_e4971 > _e4975) {
                                        phi_3780_ = _e4971;
                                    } else {
                                        phi_3780_ = _e4975;
                                    }
                                    let _e4978 = phi_3780_;
                                    if (_e4964[2] < 0f) {
                                        phi_3787_ = -(_e4964[2]);
                                    } else {
                                        phi_3787_ = _e4964[2];
                                    }
                                    let _e4982 = phi_3787_;
                                    if (_e4978 > _e4982) {
                                        phi_3792_ = _e4978;
                                    } else {
                                        phi_3792_ = _e4982;
                                    }
                                    let _e4985 = phi_3792_;
                                    let _e4988 = local_12.member[1u];
                                    if (_e4988[0] < 0f) {
                                        phi_3805_ = -(_e4988[0]);
                                    } else {
                                        phi_3805_ = _e4988[0];
                                    }
                                    let _e4995 = phi_3805_;
                                    if (_e4988[1] < 0f) {
                                        phi_3812_ = -(_e4988[1]);
                                    } else {
                                        phi_3812_ = _e4988[1];
                                    }
                                    let _e4999 = phi_3812_;
                                    if (_e4995 > _e4999) {
                                        phi_3817_ = _e4995;
                                    } else {
                                        phi_3817_ = _e4999;
                                    }
                                    let _e5002 = phi_3817_;
                                    if (_e4988[2] < 0f) {
                                        phi_3824_ = -(_e4988[2]);
                                    } else {
                                        phi_3824_ = _e4988[2];
                                    }
                                    let _e5006 = phi_3824_;
                                    if (_e5002 > _e5006) {
                                        phi_3829_ = _e5002;
                                    } else {
                                        phi_3829_ = _e5006;
                                    }
                                    let _e5009 = phi_3829_;
                                    if (_e4985 > _e5009) {
                                        phi_3834_ = _e4985;
                                    } else {
                                        phi_3834_ = _e5009;
                                    }
                                    let _e5012 = phi_3834_;
                                    let _e5014 = local_12.member_3;
                                    let _e5018 = local_12.member_1[0u];
                                    if (_e5018[0] < 0f) {
                                        phi_3851_ = -(_e5018[0]);
                                    } else {
                                        phi_3851_ = _e5018[0];
                                    }
                                    let _e5025 = phi_3851_;
                                    if (_e5018[1] < 0f) {
                                        phi_3858_ = -(_e5018[1]);
                                    } else {
                                        phi_3858_ = _e5018[1];
                                    }
                                    let _e5029 = phi_3858_;
                                    if (_e5025 > _e5029) {
                                        phi_3863_ = _e5025;
                                    } else {
                                        phi_3863_ = _e5029;
                                    }
                                    let _e5032 = phi_3863_;
                                    if (_e5018[2] < 0f) {
                                        phi_3870_ = -(_e5018[2]);
                                    } else {
                                        phi_3870_ = _e5018[2];
                                    }
                                    let _e5036 = phi_3870_;
                                    if (_e5032 > _e5036) {
                                        phi_3875_ = _e5032;
                                    } else {
                                        phi_3875_ = _e5036;
                                    }
                                    let _e5039 = phi_3875_;
                                    let _e5042 = local_12.member_1[1u];
                                    if (_e5042[0] < 0f) {
                                        phi_3889_ = -(_e5042[0]);
                                    } else {
                                        phi_3889_ = _e5042[0];
                                    }
                                    let _e5049 = phi_3889_;
                                    if (_e5042[1] < 0f) {
                                        phi_3896_ = -(_e5042[1]);
                                    } else {
                                        phi_3896_ = _e5042[1];
                                    }
                                    let _e5053 = phi_3896_;
                                    if (_e5049 > _e5053) {
                                        phi_3901_ = _e5049;
                                    } else {
                                        phi_3901_ = _e5053;
                                    }
                                    let _e5056 = phi_3901_;
                                    if (_e5042[2] < 0f) {
                                        phi_3908_ = -(_e5042[2]);
                                    } else {
                                        phi_3908_ = _e5042[2];
                                    }
                                    let _e5060 = phi_3908_;
                                    if (_e5056 > _e5060) {
                                        phi_3913_ = _e5056;
                                    } else {
                                        phi_3913_ = _e5060;
                                    }
                                    let _e5063 = phi_3913_;
                                    if (_e5039 > _e5063) {
                                        phi_3918_ = _e5039;
                                    } else {
                                        phi_3918_ = _e5063;
                                    }
                                    let _e5066 = phi_3918_;
                                    let _e5068 = local_12.member_3;
                                    let _e5072 = local_12.member_2[0u];
                                    if (_e5072[0] < 0f) {
                                        phi_3935_ = -(_e5072[0]);
                                    } else {
                                        phi_3935_ = _e5072[0];
                                    }
                                    let _e5079 = phi_3935_;
                                    if (_e5072[1] < 0f) {
                                        phi_3942_ = -(_e5072[1]);
                                    } else {
                                        phi_3942_ = _e5072[1];
                                    }
                                    let _e5083 = phi_3942_;
                                    if (_e5079 > _e5083) {
                                        phi_3947_ = _e5079;
                                    } else {
                                        phi_3947_ = _e5083;
                                    }
                                    let _e5086 = phi_3947_;
                                    if (_e5072[2] < 0f) {
                                        phi_3954_ = -(_e5072[2]);
                                    } else {
                                        phi_3954_ = _e5072[2];
                                    }
                                    let _e5090 = phi_3954_;
                                    if (_e5086 > _e5090) {
                                        phi_3959_ = _e5086;
                                    } else {
                                        phi_3959_ = _e5090;
                                    }
                                    let _e5093 = phi_3959_;
                                    let _e5096 = local_12.member_2[1u];
                                    if (_e5096[0] < 0f) {
                                        phi_3973_ = -(_e5096[0]);
                                    } else {
                                        phi_3973_ = _e5096[0];
                                    }
                                    let _e5103 = phi_3973_;
                                    if (_e5096[1] < 0f) {
                                        phi_3980_ = -(_e5096[1]);
                                    } else {
                                        phi_3980_ = _e5096[1];
                                    }
                                    let _e5107 = phi_3980_;
                                    if (_e5103 > _e5107) {
                                        phi_3985_ = _e5103;
                                    } else {
                                        phi_3985_ = _e5107;
                                    }
                                    let _e5110 = phi_3985_;
                                    if (_e5096[2] < 0f) {
                                        phi_3992_ = -(_e5096[2]);
                                    } else {
                                        phi_3992_ = _e5096[2];
                                    }
                                    let _e5114 = phi_3992_;
                                    if (_e5110 > _e5114) {
                                        phi_3997_ = _e5110;
                                    } else {
                                        phi_3997_ = _e5114;
                                    }
                                    let _e5117 = phi_3997_;
                                    if (_e5093 > _e5117) {
                                        phi_4002_ = _e5093;
                                    } else {
                                        phi_4002_ = _e5117;
                                    }
                                    let _e5120 = phi_4002_;
                                    let _e5122 = local_12.member_3;
                                    let _e5129 = local_12.member_3;
                                    let _e5136 = (((_e4958 * (1f + (0.000000059604645f * 8f))) + (((((((_e5012 + _e5014) + (_e5066 + _e5068)) + (_e5120 + _e5122)) * (0.000000059604645f * 16f)) + (_e5129 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e455.member_1);
                                    if _e5136 {
                                        phi_4022_ = false;
                                    } else {
                                        phi_4022_ = true;
                                    }
                                    let _e5138 = phi_4022_;
                                    phi_4023_ = _e5138;
                                    phi_4024_ = _e5136;
                                } else {
                                    phi_4023_ = false;
                                    phi_4024_ = false;
                                }
                                let _e5140 = phi_4023_;
                                let _e5142 = phi_4024_;
                                local_28 = _e5142;
                                continue;
                                continuing {
                                    phi_3521_ = _e4813;
                                    break if !(_e5140);
                                }
                            }
                            let _e5145 = local_28;
                            if _e5145 {
                                phi_4029_ = type_35(1u, _e4789.member_1);
                                phi_4030_ = false;
                            } else {
                                phi_4029_ = type_35();
                                phi_4030_ = true;
                            }
                            let _e5148 = phi_4029_;
                            let _e5150 = phi_4030_;
                            if _e5150 {
                                phi_4035_ = type_35(2u, _e4789.member_1);
                                phi_4036_ = false;
                            } else {
                                phi_4035_ = type_35();
                                phi_4036_ = true;
                            }
                            let _e5153 = phi_4035_;
                            let _e5155 = phi_4036_;
                            phi_4038_ = _e5153;
                            phi_4039_ = _e5148;
                            phi_4040_ = _e5155;
                        } else {
                            phi_4038_ = type_35();
                            phi_4039_ = type_35(0u, type_35().member_1);
                            phi_4040_ = true;
                        }
                        let _e5157 = phi_4038_;
                        let _e5159 = phi_4039_;
                        let _e5161 = phi_4040_;
                        if _e5161 {
                            phi_4044_ = _e5159;
                        } else {
                            phi_4044_ = _e5157;
                        }
                        let _e5163 = phi_4044_;
                        phi_7926_ = _e5163;
                    } else {
                        if (_e593 < 0f) {
                            phi_4054_ = -(_e593);
                        } else {
                            phi_4054_ = _e593;
                        }
                        let _e936 = phi_4054_;
                        if (_e616 < 0f) {
                            phi_4060_ = -(_e616);
                        } else {
                            phi_4060_ = _e616;
                        }
                        let _e940 = phi_4060_;
                        if (_e936 > _e940) {
                            phi_4065_ = _e936;
                        } else {
                            phi_4065_ = _e940;
                        }
                        let _e943 = phi_4065_;
                        if (_e639 < 0f) {
                            phi_4071_ = -(_e639);
                        } else {
                            phi_4071_ = _e639;
                        }
                        let _e947 = phi_4071_;
                        if (_e650 < 0f) {
                            phi_4077_ = -(_e650);
                        } else {
                            phi_4077_ = _e650;
                        }
                        let _e951 = phi_4077_;
                        if (_e947 > _e951) {
                            phi_4082_ = _e947;
                        } else {
                            phi_4082_ = _e951;
                        }
                        let _e954 = phi_4082_;
                        if (_e943 > _e954) {
                            phi_4087_ = _e943;
                        } else {
                            phi_4087_ = _e954;
                        }
                        let _e957 = phi_4087_;
                        let _e958 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e957 >= _e958) {
                            phi_4095_ = (_e957 <= (1f / _e958));
                        } else {
                            phi_4095_ = false;
                        }
                        let _e963 = phi_4095_;
                        if _e963 {
                            phi_4100_ = (0.000000059604645f * 256f);
                        } else {
                            phi_4100_ = 2f;
                        }
                        let _e966 = phi_4100_;
                        let _e968 = ((_e900 * 0.34f) + (_e957 * _e966));
                        if _e963 {
                            phi_4107_ = (1f / _e957);
                        } else {
                            phi_4107_ = 0f;
                        }
                        let _e971 = phi_4107_;
                        let _e977 = ((_e616 - (3f * _e593)) * _e971);
                        let _e978 = ((_e639 - _e616) * _e971);
                        let _e979 = (((3f * _e650) - _e639) * _e971);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e986 = ((_e978 * _e978) - (_e977 * _e979));
                        if (_e986 > 0f) {
                            if (_e986 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e986 > 0f) {
                                    phi_4140_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_4140_ = 0f;
                                }
                                let _e1040 = phi_4140_;
                                phi_4204_ = _e1040;
                            } else {
                                phi_4147_ = type_14(0i, 5i);
                                phi_4150_ = bitcast<f32>(((bitcast<u32>(_e986) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e995 = phi_4147_;
                                    let _e997 = phi_4150_;
                                    local_13 = _e997;
                                    if (_e995.member < _e995.member_1) {
                                        let _e1004 = (_e995.member + 1i);
                                        if ((false == (_e1004 > _e995.member)) != false) {
                                            phi_4171_ = true;
                                        } else {
                                            phi_4171_ = false;
                                        }
                                        let _e1009 = phi_4171_;
                                        if _e1009 {
                                            phi_4177_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_4177_ = type_15(1u, _e1004);
                                        }
                                        let _e1014 = phi_4177_;
                                        phi_4148_ = type_14(_e1014.member_1, _e995.member_1);
                                        phi_4191_ = type_15(1u, _e995.member);
                                    } else {
                                        phi_4148_ = _e995;
                                        phi_4191_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e1020 = phi_4148_;
                                    let _e1022 = phi_4191_;
                                    let _e1025 = (bitcast<i32>(_e1022.member) != 0i);
                                    if _e1025 {
                                        phi_4151_ = (0.5f * (_e997 + (_e986 / _e997)));
                                    } else {
                                        phi_4151_ = f32();
                                    }
                                    let _e1030 = phi_4151_;
                                    continue;
                                    continuing {
                                        phi_4147_ = _e1020;
                                        phi_4150_ = _e1030;
                                        break if !(_e1025);
                                    }
                                }
                                let _e1035 = local_13;
                                phi_4204_ = (_e1035 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1042 = phi_4204_;
                            if (_e978 < 0f) {
                                phi_4210_ = -(_e1042);
                            } else {
                                phi_4210_ = _e1042;
                            }
                            let _e1046 = phi_4210_;
                            let _e1048 = -((_e978 + _e1046));
                            local_7[0u] = (_e1048 / (_e1048 + _e979));
                            local_7[1u] = (_e977 / (_e977 + _e1048));
                            let _e1057 = local_7[1u];
                            let _e1058 = local_7[0u];
                            if (_e1057 < _e1058) {
                                let _e1061 = local_7[1u];
                                let _e1063 = local_7[0u];
                                local_7[0u] = _e1061;
                                local_7[1u] = _e1063;
                            }
                            phi_4235_ = type_9(0u, 2u);
                            phi_4238_ = 1u;
                            loop {
                                let _e1067 = phi_4235_;
                                let _e1069 = phi_4238_;
                                local_29 = _e1069;
                                if (_e1067.member < _e1067.member_1) {
                                    phi_4236_ = type_9((_e1067.member + 1u), _e1067.member_1);
                                    phi_4261_ = type_9(1u, _e1067.member);
                                } else {
                                    phi_4236_ = _e1067;
                                    phi_4261_ = type_9(0u, type_9().member_1);
                                }
                                let _e1081 = phi_4236_;
                                let _e1083 = phi_4261_;
                                let _e1087 = (bitcast<i32>(_e1083.member) != 0i);
                                if _e1087 {
                                    let _e1089 = local_7[_e1083.member_1];
                                    if (_e1089 > 0f) {
                                        let _e1092 = local_7[_e1083.member_1];
                                        if (_e1092 < 1f) {
                                            let _e1095 = local_7[_e1083.member_1];
                                            local_6[_e1069] = _e1095;
                                            phi_4305_ = (_e1069 + 1u);
                                        } else {
                                            phi_4305_ = _e1069;
                                        }
                                        let _e1099 = phi_4305_;
                                        phi_4306_ = _e1099;
                                    } else {
                                        phi_4306_ = _e1069;
                                    }
                                    let _e1101 = phi_4306_;
                                    phi_4239_ = _e1101;
                                } else {
                                    phi_4239_ = u32();
                                }
                                let _e1103 = phi_4239_;
                                continue;
                                continuing {
                                    phi_4235_ = _e1081;
                                    phi_4238_ = _e1103;
                                    break if !(_e1087);
                                }
                            }
                            let _e5423 = local_29;
                            phi_4307_ = _e5423;
                        } else {
                            phi_4307_ = 1u;
                        }
                        let _e1106 = phi_4307_;
                        local_6[_e1106] = 1f;
                        let _e1108 = local_6;
                        local_8 = _e1108;
                        phi_4327_ = type_9(0u, _e1106);
                        loop {
                            let _e1111 = phi_4327_;
                            if (_e1111.member < _e1111.member_1) {
                                phi_4328_ = type_9((_e1111.member + 1u), _e1111.member_1);
                                phi_4351_ = type_9(1u, _e1111.member);
                            } else {
                                phi_4328_ = _e1111;
                                phi_4351_ = type_9(0u, type_9().member_1);
                            }
                            let _e1123 = phi_4328_;
                            let _e1125 = phi_4351_;
                            if (bitcast<i32>(_e1125.member) != 0i) {
                                let _e1131 = local_8[_e1125.member_1];
                                let _e1134 = local_8[(_e1125.member_1 + 1u)];
                                let _e1135 = (1f - _e1131);
                                let _e1146 = ((((_e593 * _e1135) + (_e616 * _e1131)) * (_e1135 * _e1135)) + (((_e639 * _e1135) + (_e650 * _e1131)) * (_e1131 * _e1131)));
                                let _e1147 = (1f - _e1134);
                                let _e1158 = ((((_e593 * _e1147) + (_e616 * _e1134)) * (_e1147 * _e1147)) + (((_e639 * _e1147) + (_e650 * _e1134)) * (_e1134 * _e1134)));
                                if (_e1146 < 0f) {
                                    phi_4403_ = -(_e1146);
                                } else {
                                    phi_4403_ = _e1146;
                                }
                                let _e1162 = phi_4403_;
                                let _e1163 = (_e1162 > _e968);
                                if (_e1158 < 0f) {
                                    phi_4410_ = -(_e1158);
                                } else {
                                    phi_4410_ = _e1158;
                                }
                                let _e1167 = phi_4410_;
                                let _e1168 = (_e1167 > _e968);
                                if _e1163 {
                                    if _e1168 {
                                        phi_4421_ = ((_e1146 > 0f) != (_e1158 > 0f));
                                        phi_4422_ = false;
                                    } else {
                                        phi_4421_ = bool();
                                        phi_4422_ = true;
                                    }
                                    let _e1173 = phi_4421_;
                                    let _e1175 = phi_4422_;
                                    phi_4423_ = _e1173;
                                    phi_4424_ = _e1175;
                                } else {
                                    phi_4423_ = bool();
                                    phi_4424_ = true;
                                }
                                let _e1177 = phi_4423_;
                                let _e1179 = phi_4424_;
                                if _e1179 {
                                    phi_4428_ = false;
                                } else {
                                    phi_4428_ = _e1177;
                                }
                                let _e1181 = phi_4428_;
                                if _e1163 {
                                    if _e1168 {
                                        if _e1181 {
                                            phi_4439_ = type_37();
                                        } else {
                                            phi_4439_ = type_37(1f, 0f, _e1181);
                                        }
                                        let _e1184 = phi_4439_;
                                        phi_4440_ = _e1184;
                                        phi_4441_ = _e1181;
                                    } else {
                                        phi_4440_ = type_37();
                                        phi_4441_ = true;
                                    }
                                    let _e1186 = phi_4440_;
                                    let _e1188 = phi_4441_;
                                    phi_4442_ = _e1186;
                                    phi_4443_ = _e1188;
                                } else {
                                    phi_4442_ = type_37();
                                    phi_4443_ = true;
                                }
                                let _e1190 = phi_4442_;
                                let _e1192 = phi_4443_;
                                if _e1192 {
                                    if _e1163 {
                                        if (_e1146 < 0f) {
                                            phi_4454_ = -1f;
                                        } else {
                                            phi_4454_ = 1f;
                                        }
                                        let _e1195 = phi_4454_;
                                        let _e1198 = (_e639 - _e616);
                                        phi_4464_ = type_9(0u, 64u);
                                        phi_4467_ = _e1134;
                                        phi_4469_ = _e1131;
                                        phi_4471_ = (0.5f * (_e1131 + _e1134));
                                        loop {
                                            let _e1204 = phi_4464_;
                                            let _e1206 = phi_4467_;
                                            let _e1208 = phi_4469_;
                                            let _e1210 = phi_4471_;
                                            local_31 = _e1208;
                                            if (_e1204.member < _e1204.member_1) {
                                                phi_4465_ = type_9((_e1204.member + 1u), _e1204.member_1);
                                                phi_4494_ = type_9(1u, _e1204.member);
                                            } else {
                                                phi_4465_ = _e1204;
                                                phi_4494_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1222 = phi_4465_;
                                            let _e1224 = phi_4494_;
                                            if (bitcast<i32>(_e1224.member) != 0i) {
                                                let _e1228 = (1f - _e1210);
                                                let _e1241 = ((_e1195 * ((((_e593 * _e1228) + (_e616 * _e1210)) * (_e1228 * _e1228)) + (((_e639 * _e1228) + (_e650 * _e1210)) * (_e1210 * _e1210)))) - _e968);
                                                if (_e1241 > 0f) {
                                                    phi_4519_ = _e1206;
                                                    phi_4520_ = _e1210;
                                                } else {
                                                    phi_4519_ = _e1210;
                                                    phi_4520_ = _e1208;
                                                }
                                                let _e1244 = phi_4519_;
                                                let _e1246 = phi_4520_;
                                                let _e1248 = ((_e1244 - _e1246) > 0.00000000000022737368f);
                                                if _e1248 {
                                                    let _e1249 = (1f - _e1210);
                                                    let _e1261 = (-(_e1241) / (_e1195 * (((((_e616 - (3f * _e593)) * _e1249) + (_e1198 * _e1210)) * _e1249) + (((_e1198 * _e1249) + (((3f * _e650) - _e639) * _e1210)) * _e1210))));
                                                    if (_e1241 > 0f) {
                                                        phi_4546_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4546_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1267 = phi_4546_;
                                                    let _e1269 = ((_e1210 + _e1261) + _e1267);
                                                    if (_e1269 > _e1246) {
                                                        if (_e1269 < _e1244) {
                                                            if (_e1261 < 0f) {
                                                                phi_4562_ = -(_e1261);
                                                            } else {
                                                                phi_4562_ = _e1261;
                                                            }
                                                            let _e1275 = phi_4562_;
                                                            if (_e1275 < (0.5f * (_e1244 - _e1246))) {
                                                                phi_4569_ = false;
                                                            } else {
                                                                phi_4569_ = true;
                                                            }
                                                            let _e1280 = phi_4569_;
                                                            phi_4570_ = _e1280;
                                                        } else {
                                                            phi_4570_ = true;
                                                        }
                                                        let _e1282 = phi_4570_;
                                                        phi_4571_ = _e1282;
                                                    } else {
                                                        phi_4571_ = true;
                                                    }
                                                    let _e1284 = phi_4571_;
                                                    if _e1284 {
                                                        phi_4577_ = (0.5f * (_e1246 + _e1244));
                                                    } else {
                                                        phi_4577_ = _e1269;
                                                    }
                                                    let _e1288 = phi_4577_;
                                                    phi_4578_ = _e1288;
                                                    phi_4579_ = false;
                                                } else {
                                                    phi_4578_ = f32();
                                                    phi_4579_ = true;
                                                }
                                                let _e1290 = phi_4578_;
                                                let _e1292 = phi_4579_;
                                                phi_4468_ = _e1244;
                                                phi_4470_ = _e1246;
                                                phi_4472_ = _e1290;
                                                phi_4580_ = _e1246;
                                                phi_4581_ = _e1248;
                                                phi_4582_ = _e1292;
                                            } else {
                                                phi_4468_ = f32();
                                                phi_4470_ = f32();
                                                phi_4472_ = f32();
                                                phi_4580_ = f32();
                                                phi_4581_ = false;
                                                phi_4582_ = false;
                                            }
                                            let _e1294 = phi_4468_;
                                            let _e1296 = phi_4470_;
                                            let _e1298 = phi_4472_;
                                            let _e1300 = phi_4580_;
                                            let _e1302 = phi_4581_;
                                            let _e1304 = phi_4582_;
                                            local_14 = _e1304;
                                            local_30 = _e1300;
                                            continue;
                                            continuing {
                                                phi_4464_ = _e1222;
                                                phi_4467_ = _e1294;
                                                phi_4469_ = _e1296;
                                                phi_4471_ = _e1298;
                                                break if !(_e1302);
                                            }
                                        }
                                        let _e1307 = local_14;
                                        if _e1307 {
                                            let _e5465 = local_30;
                                            phi_4586_ = _e5465;
                                        } else {
                                            let _e5467 = local_31;
                                            phi_4586_ = _e5467;
                                        }
                                        let _e1309 = phi_4586_;
                                        phi_4587_ = _e1309;
                                    } else {
                                        phi_4587_ = _e1131;
                                    }
                                    let _e1311 = phi_4587_;
                                    if _e1168 {
                                        if (_e1158 < 0f) {
                                            phi_4595_ = -1f;
                                        } else {
                                            phi_4595_ = 1f;
                                        }
                                        let _e1314 = phi_4595_;
                                        phi_4599_ = type_9(0u, 64u);
                                        phi_4602_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1317 = phi_4599_;
                                            let _e1319 = phi_4602_;
                                            if (_e1317.member < _e1317.member_1) {
                                                phi_4600_ = type_9((_e1317.member + 1u), _e1317.member_1);
                                                phi_4625_ = type_9(1u, _e1317.member);
                                            } else {
                                                phi_4600_ = _e1317;
                                                phi_4625_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1331 = phi_4600_;
                                            let _e1333 = phi_4625_;
                                            if (bitcast<i32>(_e1333.member) != 0i) {
                                                let _e1337 = (_e1311 + _e1319);
                                                if (_e1337 < _e1134) {
                                                    let _e1339 = (1f - _e1337);
                                                    let _e1352 = ((_e1314 * ((((_e593 * _e1339) + (_e616 * _e1337)) * (_e1339 * _e1339)) + (((_e639 * _e1339) + (_e650 * _e1337)) * (_e1337 * _e1337)))) > _e968);
                                                    if _e1352 {
                                                        phi_4655_ = f32();
                                                        phi_4656_ = false;
                                                    } else {
                                                        phi_4655_ = (_e1319 + _e1319);
                                                        phi_4656_ = true;
                                                    }
                                                    let _e1355 = phi_4655_;
                                                    let _e1357 = phi_4656_;
                                                    phi_4657_ = _e1355;
                                                    phi_4658_ = _e1357;
                                                    phi_4659_ = _e1352;
                                                    phi_4660_ = false;
                                                } else {
                                                    phi_4657_ = f32();
                                                    phi_4658_ = false;
                                                    phi_4659_ = false;
                                                    phi_4660_ = true;
                                                }
                                                let _e1359 = phi_4657_;
                                                let _e1361 = phi_4658_;
                                                let _e1363 = phi_4659_;
                                                let _e1365 = phi_4660_;
                                                phi_4661_ = _e1337;
                                                phi_4603_ = _e1359;
                                                phi_4662_ = _e1361;
                                                phi_4663_ = _e1363;
                                                phi_4664_ = _e1365;
                                                phi_4665_ = false;
                                            } else {
                                                phi_4661_ = f32();
                                                phi_4603_ = f32();
                                                phi_4662_ = false;
                                                phi_4663_ = false;
                                                phi_4664_ = false;
                                                phi_4665_ = true;
                                            }
                                            let _e1367 = phi_4661_;
                                            let _e1369 = phi_4603_;
                                            let _e1371 = phi_4662_;
                                            let _e1373 = phi_4663_;
                                            let _e1375 = phi_4664_;
                                            let _e1377 = phi_4665_;
                                            local_15 = _e1373;
                                            local_32 = _e1375;
                                            local_33 = _e1377;
                                            local_34 = _e1367;
                                            continue;
                                            continuing {
                                                phi_4599_ = _e1331;
                                                phi_4602_ = _e1369;
                                                break if !(_e1371);
                                            }
                                        }
                                        let _e1380 = local_15;
                                        if _e1380 {
                                            phi_4669_ = false;
                                            phi_4670_ = false;
                                        } else {
                                            let _e5489 = local_32;
                                            phi_4669_ = _e5489;
                                            let _e5492 = local_33;
                                            phi_4670_ = _e5492;
                                        }
                                        let _e1382 = phi_4669_;
                                        let _e1384 = phi_4670_;
                                        if _e1382 {
                                            phi_4674_ = true;
                                        } else {
                                            phi_4674_ = _e1384;
                                        }
                                        let _e1386 = phi_4674_;
                                        if _e1386 {
                                            phi_4678_ = _e1134;
                                        } else {
                                            let _e5496 = local_34;
                                            phi_4678_ = _e5496;
                                        }
                                        let _e1388 = phi_4678_;
                                        phi_4679_ = _e1388;
                                    } else {
                                        phi_4679_ = _e1134;
                                    }
                                    let _e1390 = phi_4679_;
                                    phi_4681_ = type_37(_e1311, _e1390, _e1181);
                                } else {
                                    phi_4681_ = _e1190;
                                }
                                let _e1393 = phi_4681_;
                                if (_e1393.member > _e1393.member_1) {
                                    phi_7882_ = f32();
                                    phi_7883_ = true;
                                    phi_7884_ = false;
                                    phi_7885_ = false;
                                    phi_7886_ = false;
                                } else {
                                    let _e1400 = ((_e1393.member_1 - _e1393.member) * 0.5f);
                                    let _e1401 = (_e1393.member + _e1400);
                                    let _e1403 = (_e1400 + (0.000000059604645f * 4f));
                                    let _e1405 = local_12.member_3;
                                    let _e1408 = local_12.member[0u];
                                    if (_e1408[0] < 0f) {
                                        phi_4710_ = -(_e1408[0]);
                                    } else {
                                        phi_4710_ = _e1408[0];
                                    }
                                    let _e1415 = phi_4710_;
                                    if (_e1408[1] < 0f) {
                                        phi_4717_ = -(_e1408[1]);
                                    } else {
                                        phi_4717_ = _e1408[1];
                                    }
                                    let _e1419 = phi_4717_;
                                    if (_e1415 > _e1419) {
                                        phi_4722_ = _e1415;
                                    } else {
                                        phi_4722_ = _e1419;
                                    }
                                    let _e1422 = phi_4722_;
                                    if (_e1408[2] < 0f) {
                                        phi_4729_ = -(_e1408[2]);
                                    } else {
                                        phi_4729_ = _e1408[2];
                                    }
                                    let _e1426 = phi_4729_;
                                    if (_e1422 > _e1426) {
                                        phi_4734_ = _e1422;
                                    } else {
                                        phi_4734_ = _e1426;
                                    }
                                    let _e1429 = phi_4734_;
                                    let _e1431 = local_12.member[1u];
                                    if (_e1431[0] < 0f) {
                                        phi_4747_ = -(_e1431[0]);
                                    } else {
                                        phi_4747_ = _e1431[0];
                                    }
                                    let _e1438 = phi_4747_;
                                    if (_e1431[1] < 0f) {
                                        phi_4754_ = -(_e1431[1]);
                                    } else {
                                        phi_4754_ = _e1431[1];
                                    }
                                    let _e1442 = phi_4754_;
                                    if (_e1438 > _e1442) {
                                        phi_4759_ = _e1438;
                                    } else {
                                        phi_4759_ = _e1442;
                                    }
                                    let _e1445 = phi_4759_;
                                    if (_e1431[2] < 0f) {
                                        phi_4766_ = -(_e1431[2]);
                                    } else {
                                        phi_4766_ = _e1431[2];
                                    }
                                    let _e1449 = phi_4766_;
                                    if (_e1445 > _e1449) {
                                        phi_4771_ = _e1445;
                                    } else {
                                        phi_4771_ = _e1449;
                                    }
                                    let _e1452 = phi_4771_;
                                    if (_e1429 > _e1452) {
                                        phi_4776_ = _e1429;
                                    } else {
                                        phi_4776_ = _e1452;
                                    }
                                    let _e1455 = phi_4776_;
                                    let _e1458 = local_12.member[0u];
                                    let _e1463 = local_12.member[1u];
                                    let _e1473 = (_e1458[0] + ((_e1463[0] - _e1458[0]) * _e1401));
                                    let _e1474 = (_e1458[1] + ((_e1463[1] - _e1458[1]) * _e1401));
                                    let _e1475 = (_e1458[2] + ((_e1463[2] - _e1458[2]) * _e1401));
                                    let _e1477 = local_12.member[1u];
                                    let _e1482 = local_12.member[0u];
                                    let _e1486 = (_e1477[0] - _e1482[0]);
                                    let _e1487 = (_e1477[1] - _e1482[1]);
                                    let _e1488 = (_e1477[2] - _e1482[2]);
                                    if (_e1486 < 0f) {
                                        phi_4835_ = -(_e1486);
                                    } else {
                                        phi_4835_ = _e1486;
                                    }
                                    let _e1492 = phi_4835_;
                                    if (_e1487 < 0f) {
                                        phi_4841_ = -(_e1487);
                                    } else {
                                        phi_4841_ = _e1487;
                                    }
                                    let _e1496 = phi_4841_;
                                    if (_e1492 > _e1496) {
                                        phi_4846_ = _e1492;
                                    } else {
                                        phi_4846_ = _e1496;
                                    }
                                    let _e1499 = phi_4846_;
                                    if (_e1488 < 0f) {
                                        phi_4852_ = -(_e1488);
                                    } else {
                                        phi_4852_ = _e1488;
                                    }
                                    let _e1503 = phi_4852_;
                                    if (_e1499 > _e1503) {
                                        phi_4857_ = _e1499;
                                    } else {
                                        phi_4857_ = _e1503;
                                    }
                                    let _e1506 = phi_4857_;
                                    let _e1512 = ((((_e1403 * _e1506) * 1.01f) + ((_e1455 + _e1405) * (0.000000059604645f * 8f))) + _e1405);
                                    if (_e1473 < 0f) {
                                        phi_4869_ = -(_e1473);
                                    } else {
                                        phi_4869_ = _e1473;
                                    }
                                    let _e1516 = phi_4869_;
                                    if (_e1474 < 0f) {
                                        phi_4875_ = -(_e1474);
                                    } else {
                                        phi_4875_ = _e1474;
                                    }
                                    let _e1520 = phi_4875_;
                                    if (_e1516 > _e1520) {
                                        phi_4880_ = _e1516;
                                    } else {
                                        phi_4880_ = _e1520;
                                    }
                                    let _e1523 = phi_4880_;
                                    if (_e1475 < 0f) {
                                        phi_4886_ = -(_e1475);
                                    } else {
                                        phi_4886_ = _e1475;
                                    }
                                    let _e1527 = phi_4886_;
                                    if (_e1523 > _e1527) {
                                        phi_4891_ = _e1523;
                                    } else {
                                        phi_4891_ = _e1527;
                                    }
                                    let _e1530 = phi_4891_;
                                    local_2 = type_29(array<f32, 3>(_e1473, _e1474, _e1475), _e1512, (_e1530 + _e1512));
                                    let _e1536 = local_12.member_3;
                                    let _e1538 = local_12.member_1[0u];
                                    if (_e1538[0] < 0f) {
                                        phi_4917_ = -(_e1538[0]);
                                    } else {
                                        phi_4917_ = _e1538[0];
                                    }
                                    let _e1545 = phi_4917_;
                                    if (_e1538[1] < 0f) {
                                        phi_4924_ = -(_e1538[1]);
                                    } else {
                                        phi_4924_ = _e1538[1];
                                    }
                                    let _e1549 = phi_4924_;
                                    if (_e1545 > _e1549) {
                                        phi_4929_ = _e1545;
                                    } else {
                                        phi_4929_ = _e1549;
                                    }
                                    let _e1552 = phi_4929_;
                                    if (_e1538[2] < 0f) {
                                        phi_4936_ = -(_e1538[2]);
                                    } else {
                                        phi_4936_ = _e1538[2];
                                    }
                                    let _e1556 = phi_4936_;
                                    if (_e1552 > _e1556) {
                                        phi_4941_ = _e1552;
                                    } else {
                                        phi_4941_ = _e1556;
                                    }
                                    let _e1559 = phi_4941_;
                                    let _e1561 = local_12.member_1[1u];
                                    if (_e1561[0] < 0f) {
                                        phi_4954_ = -(_e1561[0]);
                                    } else {
                                        phi_4954_ = _e1561[0];
                                    }
                                    let _e1568 = phi_4954_;
                                    if (_e1561[1] < 0f) {
                                        phi_4961_ = -(_e1561[1]);
                                    } else {
                                        phi_4961_ = _e1561[1];
                                    }
                                    let _e1572 = phi_4961_;
                                    if (_e1568 > _e1572) {
                                        phi_4966_ = _e1568;
                                    } else {
                                        phi_4966_ = _e1572;
                                    }
                                    let _e1575 = phi_4966_;
                                    if (_e1561[2] < 0f) {
                                        phi_4973_ = -(_e1561[2]);
                                    } else {
                                        phi_4973_ = _e1561[2];
                                    }
                                    let _e1579 = phi_4973_;
                                    if (_e1575 > _e1579) {
                                        phi_4978_ = _e1575;
                                    } else {
                                        phi_4978_ = _e1579;
                                    }
                                    let _e1582 = phi_4978_;
                                    if (_e1559 > _e1582) {
                                        phi_4983_ = _e1559;
                                    } else {
                                        phi_4983_ = _e1582;
                                    }
                                    let _e1585 = phi_4983_;
                                    let _e1588 = local_12.member_1[0u];
                                    let _e1593 = local_12.member_1[1u];
                                    let _e1603 = (_e1588[0] + ((_e1593[0] - _e1588[0]) * _e1401));
                                    let _e1604 = (_e1588[1] + ((_e1593[1] - _e1588[1]) * _e1401));
                                    let _e1605 = (_e1588[2] + ((_e1593[2] - _e1588[2]) * _e1401));
                                    let _e1607 = local_12.member_1[1u];
                                    let _e1612 = local_12.member_1[0u];
                                    let _e1616 = (_e1607[0] - _e1612[0]);
                                    let _e1617 = (_e1607[1] - _e1612[1]);
                                    let _e1618 = (_e1607[2] - _e1612[2]);
                                    if (_e1616 < 0f) {
                                        phi_5042_ = -(_e1616);
                                    } else {
                                        phi_5042_ = _e1616;
                                    }
                                    let _e1622 = phi_5042_;
                                    if (_e1617 < 0f) {
                                        phi_5048_ = -(_e1617);
                                    } else {
                                        phi_5048_ = _e1617;
                                    }
                                    let _e1626 = phi_5048_;
                                    if (_e1622 > _e1626) {
                                        phi_5053_ = _e1622;
                                    } else {
                                        phi_5053_ = _e1626;
                                    }
                                    let _e1629 = phi_5053_;
                                    if (_e1618 < 0f) {
                                        phi_5059_ = -(_e1618);
                                    } else {
                                        phi_5059_ = _e1618;
                                    }
                                    let _e1633 = phi_5059_;
                                    if (_e1629 > _e1633) {
                                        phi_5064_ = _e1629;
                                    } else {
                                        phi_5064_ = _e1633;
                                    }
                                    let _e1636 = phi_5064_;
                                    let _e1642 = ((((_e1403 * _e1636) * 1.01f) + ((_e1585 + _e1536) * (0.000000059604645f * 8f))) + _e1536);
                                    if (_e1603 < 0f) {
                                        phi_5076_ = -(_e1603);
                                    } else {
                                        phi_5076_ = _e1603;
                                    }
                                    let _e1646 = phi_5076_;
                                    if (_e1604 < 0f) {
                                        phi_5082_ = -(_e1604);
                                    } else {
                                        phi_5082_ = _e1604;
                                    }
                                    let _e1650 = phi_5082_;
                                    if (_e1646 > _e1650) {
                                        phi_5087_ = _e1646;
                                    } else {
                                        phi_5087_ = _e1650;
                                    }
                                    let _e1653 = phi_5087_;
                                    if (_e1605 < 0f) {
                                        phi_5093_ = -(_e1605);
                                    } else {
                                        phi_5093_ = _e1605;
                                    }
                                    let _e1657 = phi_5093_;
                                    if (_e1653 > _e1657) {
                                        phi_5098_ = _e1653;
                                    } else {
                                        phi_5098_ = _e1657;
                                    }
                                    let _e1660 = phi_5098_;
                                    local_3 = type_29(array<f32, 3>(_e1603, _e1604, _e1605), _e1642, (_e1660 + _e1642));
                                    let _e1666 = local_12.member_3;
                                    let _e1668 = local_12.member_2[0u];
                                    if (_e1668[0] < 0f) {
                                        phi_5124_ = -(_e1668[0]);
                                    } else {
                                        phi_5124_ = _e1668[0];
                                    }
                                    let _e1675 = phi_5124_;
                                    if (_e1668[1] < 0f) {
                                        phi_5131_ = -(_e1668[1]);
                                    } else {
                                        phi_5131_ = _e1668[1];
                                    }
                                    let _e1679 = phi_5131_;
                                    if (_e1675 > _e1679) {
                                        phi_5136_ = _e1675;
                                    } else {
                                        phi_5136_ = _e1679;
                                    }
                                    let _e1682 = phi_5136_;
                                    if (_e1668[2] < 0f) {
                                        phi_5143_ = -(_e1668[2]);
                                    } else {
                                        phi_5143_ = _e1668[2];
                                    }
                                    let _e1686 = phi_5143_;
                                    if (_e1682 > _e1686) {
                                        phi_5148_ = _e1682;
                                    } else {
                                        phi_5148_ = _e1686;
                                    }
                                    let _e1689 = phi_5148_;
                                    let _e1691 = local_12.member_2[1u];
                                    if (_e1691[0] < 0f) {
                                        phi_5161_ = -(_e1691[0]);
                                    } else {
                                        phi_5161_ = _e1691[0];
                                    }
                                    let _e1698 = phi_5161_;
                                    if (_e1691[1] < 0f) {
                                        phi_5168_ = -(_e1691[1]);
                                    } else {
                                        phi_5168_ = _e1691[1];
                                    }
                                    let _e1702 = phi_5168_;
                                    if (_e1698 > _e1702) {
                                        phi_5173_ = _e1698;
                                    } else {
                                        phi_5173_ = _e1702;
                                    }
                                    let _e1705 = phi_5173_;
                                    if (_e1691[2] < 0f) {
                                        phi_5180_ = -(_e1691[2]);
                                    } else {
                                        phi_5180_ = _e1691[2];
                                    }
                                    let _e1709 = phi_5180_;
                                    if (_e1705 > _e1709) {
                                        phi_5185_ = _e1705;
                                    } else {
                                        phi_5185_ = _e1709;
                                    }
                                    let _e1712 = phi_5185_;
                                    if (_e1689 > _e1712) {
                                        phi_5190_ = _e1689;
                                    } else {
                                        phi_5190_ = _e1712;
                                    }
                                    let _e1715 = phi_5190_;
                                    let _e1718 = local_12.member_2[0u];
                                    let _e1723 = local_12.member_2[1u];
                                    let _e1733 = (_e1718[0] + ((_e1723[0] - _e1718[0]) * _e1401));
                                    let _e1734 = (_e1718[1] + ((_e1723[1] - _e1718[1]) * _e1401));
                                    let _e1735 = (_e1718[2] + ((_e1723[2] - _e1718[2]) * _e1401));
                                    let _e1737 = local_12.member_2[1u];
                                    let _e1742 = local_12.member_2[0u];
                                    let _e1746 = (_e1737[0] - _e1742[0]);
                                    let _e1747 = (_e1737[1] - _e1742[1]);
                                    let _e1748 = (_e1737[2] - _e1742[2]);
                                    if (_e1746 < 0f) {
                                        phi_5249_ = -(_e1746);
                                    } else {
                                        phi_5249_ = _e1746;
                                    }
                                    let _e1752 = phi_5249_;
                                    if (_e1747 < 0f) {
                                        phi_5255_ = -(_e1747);
                                    } else {
                                        phi_5255_ = _e1747;
                                    }
                                    let _e1756 = phi_5255_;
                                    if (_e1752 > _e1756) {
                                        phi_5260_ = _e1752;
                                    } else {
                                        phi_5260_ = _e1756;
                                    }
                                    let _e1759 = phi_5260_;
                                    if (_e1748 < 0f) {
                                        phi_5266_ = -(_e1748);
                                    } else {
                                        phi_5266_ = _e1748;
                                    }
                                    let _e1763 = phi_5266_;
                                    if (_e1759 > _e1763) {
                                        phi_5271_ = _e1759;
                                    } else {
                                        phi_5271_ = _e1763;
                                    }
                                    let _e1766 = phi_5271_;
                                    let _e1772 = ((((_e1403 * _e1766) * 1.01f) + ((_e1715 + _e1666) * (0.000000059604645f * 8f))) + _e1666);
                                    if (_e1733 < 0f) {
                                        phi_5283_ = -(_e1733);
                                    } else {
                                        phi_5283_ = _e1733;
                                    }
                                    let _e1776 = phi_5283_;
                                    if (_e1734 < 0f) {
                                        phi_5289_ = -(_e1734);
                                    } else {
                                        phi_5289_ = _e1734;
                                    }
                                    let _e1780 = phi_5289_;
                                    if (_e1776 > _e1780) {
                                        phi_5294_ = _e1776;
                                    } else {
                                        phi_5294_ = _e1780;
                                    }
                                    let _e1783 = phi_5294_;
                                    if (_e1735 < 0f) {
                                        phi_5300_ = -(_e1735);
                                    } else {
                                        phi_5300_ = _e1735;
                                    }
                                    let _e1787 = phi_5300_;
                                    if (_e1783 > _e1787) {
                                        phi_5305_ = _e1783;
                                    } else {
                                        phi_5305_ = _e1787;
                                    }
                                    let _e1790 = phi_5305_;
                                    local_4 = type_29(array<f32, 3>(_e1733, _e1734, _e1735), _e1772, (_e1790 + _e1772));
                                    let _e1795 = local_3.member;
                                    let _e1800 = local_4.member;
                                    let _e1806 = ((_e1795[1] * _e1800[2]) - (_e1795[2] * _e1800[1]));
                                    let _e1809 = ((_e1795[2] * _e1800[0]) - (_e1795[0] * _e1800[2]));
                                    let _e1812 = ((_e1795[0] * _e1800[1]) - (_e1795[1] * _e1800[0]));
                                    if (_e1806 < 0f) {
                                        phi_5354_ = -(_e1806);
                                    } else {
                                        phi_5354_ = _e1806;
                                    }
                                    let _e1816 = phi_5354_;
                                    if (_e1809 < 0f) {
                                        phi_5360_ = -(_e1809);
                                    } else {
                                        phi_5360_ = _e1809;
                                    }
                                    let _e1820 = phi_5360_;
                                    if (_e1816 > _e1820) {
                                        if (_e1806 < 0f) {
                                            phi_5370_ = -(_e1806);
                                        } else {
                                            phi_5370_ = _e1806;
                                        }
                                        let _e1838 = phi_5370_;
                                        if (_e1812 < 0f) {
                                            phi_5376_ = -(_e1812);
                                        } else {
                                            phi_5376_ = _e1812;
                                        }
                                        let _e1842 = phi_5376_;
                                        if (_e1838 > _e1842) {
                                            phi_5381_ = 2u;
                                            phi_5382_ = 1u;
                                        } else {
                                            phi_5381_ = 1u;
                                            phi_5382_ = 0u;
                                        }
                                        let _e1845 = phi_5381_;
                                        let _e1847 = phi_5382_;
                                        phi_5401_ = _e1845;
                                        phi_5402_ = _e1847;
                                    } else {
                                        if (_e1809 < 0f) {
                                            phi_5388_ = -(_e1809);
                                        } else {
                                            phi_5388_ = _e1809;
                                        }
                                        let _e1825 = phi_5388_;
                                        if (_e1812 < 0f) {
                                            phi_5394_ = -(_e1812);
                                        } else {
                                            phi_5394_ = _e1812;
                                        }
                                        let _e1829 = phi_5394_;
                                        if (_e1825 > _e1829) {
                                            phi_5399_ = 0u;
                                            phi_5400_ = 2u;
                                        } else {
                                            phi_5399_ = 1u;
                                            phi_5400_ = 0u;
                                        }
                                        let _e1832 = phi_5399_;
                                        let _e1834 = phi_5400_;
                                        phi_5401_ = _e1832;
                                        phi_5402_ = _e1834;
                                    }
                                    let _e1849 = phi_5401_;
                                    let _e1851 = phi_5402_;
                                    let _e1854 = local_3.member[_e1851];
                                    let _e1857 = local_4.member[_e1849];
                                    let _e1861 = local_3.member[_e1849];
                                    let _e1864 = local_4.member[_e1851];
                                    let _e1866 = ((_e1854 * _e1857) - (_e1861 * _e1864));
                                    let _e1868 = local_3.member_1;
                                    let _e1870 = local_4.member_2;
                                    let _e1873 = local_3.member_2;
                                    let _e1875 = local_4.member_1;
                                    let _e1880 = local_3.member_2;
                                    let _e1883 = local_4.member_2;
                                    let _e1891 = local_3.member_2;
                                    let _e1894 = local_4.member_2;
                                    let _e1898 = (((((_e1868 * _e1870) + (_e1873 * _e1875)) * 2.01f) + (((_e1880 * 2f) * (_e1883 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1891) * (1f + _e1894))));
                                    if (_e1866 < 0f) {
                                        phi_5471_ = -(_e1866);
                                    } else {
                                        phi_5471_ = _e1866;
                                    }
                                    let _e1902 = phi_5471_;
                                    if (_e1902 > _e1898) {
                                        if (_e1866 < 0f) {
                                            phi_5480_ = -1f;
                                        } else {
                                            phi_5480_ = 1f;
                                        }
                                        let _e1906 = phi_5480_;
                                        let _e1909 = local_2.member[_e1851];
                                        let _e1912 = local_4.member[_e1849];
                                        let _e1916 = local_2.member[_e1849];
                                        let _e1919 = local_4.member[_e1851];
                                        let _e1923 = local_2.member_1;
                                        let _e1925 = local_4.member_2;
                                        let _e1928 = local_2.member_2;
                                        let _e1930 = local_4.member_1;
                                        let _e1935 = local_2.member_2;
                                        let _e1938 = local_4.member_2;
                                        let _e1946 = local_2.member_2;
                                        let _e1949 = local_4.member_2;
                                        let _e1953 = (((((_e1923 * _e1925) + (_e1928 * _e1930)) * 2.01f) + (((_e1935 * 2f) * (_e1938 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1946) * (1f + _e1949))));
                                        let _e1956 = local_3.member[_e1851];
                                        let _e1959 = local_2.member[_e1849];
                                        let _e1963 = local_3.member[_e1849];
                                        let _e1966 = local_2.member[_e1851];
                                        let _e1970 = local_3.member_1;
                                        let _e1972 = local_2.member_2;
                                        let _e1975 = local_3.member_2;
                                        let _e1977 = local_2.member_1;
                                        let _e1982 = local_3.member_2;
                                        let _e1985 = local_2.member_2;
                                        let _e1993 = local_3.member_2;
                                        let _e1996 = local_2.member_2;
                                        let _e2000 = (((((_e1970 * _e1972) + (_e1975 * _e1977)) * 2.01f) + (((_e1982 * 2f) * (_e1985 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1993) * (1f + _e1996))));
                                        let _e2001 = (_e1866 * _e1906);
                                        let _e2002 = (((_e1909 * _e1912) - (_e1916 * _e1919)) * _e1906);
                                        let _e2003 = (((_e1956 * _e1959) - (_e1963 * _e1966)) * _e1906);
                                        if (_e2001 < 0f) {
                                            phi_5615_ = -(_e2001);
                                        } else {
                                            phi_5615_ = _e2001;
                                        }
                                        let _e2007 = phi_5615_;
                                        if (_e2002 < 0f) {
                                            phi_5621_ = -(_e2002);
                                        } else {
                                            phi_5621_ = _e2002;
                                        }
                                        let _e2011 = phi_5621_;
                                        if (_e2003 < 0f) {
                                            phi_5628_ = -(_e2003);
                                        } else {
                                            phi_5628_ = _e2003;
                                        }
                                        let _e2016 = phi_5628_;
                                        let _e2019 = (((_e2007 + _e2011) + _e2016) * (0.000000059604645f * 4f));
                                        local_5[0u].member = _e2002;
                                        local_5[0u].member_1 = _e1953;
                                        local_5[1u].member = _e2003;
                                        local_5[1u].member_1 = _e2000;
                                        local_5[2u].member = (_e2001 - _e2002);
                                        local_5[2u].member_1 = ((_e1898 + _e1953) + _e2019);
                                        local_5[3u].member = (_e2001 - _e2003);
                                        local_5[3u].member_1 = ((_e1898 + _e2000) + _e2019);
                                        phi_5671_ = type_9(0u, 4u);
                                        phi_5674_ = true;
                                        loop {
                                            let _e2040 = phi_5671_;
                                            let _e2042 = phi_5674_;
                                            local_17 = _e2042;
                                            if (_e2040.member < _e2040.member_1) {
                                                phi_5672_ = type_9((_e2040.member + 1u), _e2040.member_1);
                                                phi_5697_ = type_9(1u, _e2040.member);
                                            } else {
                                                phi_5672_ = _e2040;
                                                phi_5697_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2054 = phi_5672_;
                                            let _e2056 = phi_5697_;
                                            if (bitcast<i32>(_e2056.member) != 0i) {
                                                let _e2063 = local_5[_e2056.member_1].member;
                                                let _e2066 = local_5[_e2056.member_1].member_1;
                                                let _e2068 = (_e2063 < -(_e2066));
                                                if _e2068 {
                                                    phi_5724_ = bool();
                                                    phi_5725_ = false;
                                                } else {
                                                    phi_5724_ = (_e2042 && (_e2063 > _e2066));
                                                    phi_5725_ = true;
                                                }
                                                let _e2072 = phi_5724_;
                                                let _e2074 = phi_5725_;
                                                phi_5675_ = _e2072;
                                                phi_5726_ = _e2074;
                                                phi_5727_ = _e2068;
                                            } else {
                                                phi_5675_ = bool();
                                                phi_5726_ = false;
                                                phi_5727_ = false;
                                            }
                                            let _e2076 = phi_5675_;
                                            let _e2078 = phi_5726_;
                                            let _e2080 = phi_5727_;
                                            local_16 = _e2080;
                                            continue;
                                            continuing {
                                                phi_5671_ = _e2054;
                                                phi_5674_ = _e2076;
                                                break if !(_e2078);
                                            }
                                        }
                                        let _e2083 = local_16;
                                        if _e2083 {
                                            phi_5731_ = false;
                                        } else {
                                            phi_5731_ = true;
                                        }
                                        let _e2085 = phi_5731_;
                                        if _e2085 {
                                            let _e2087 = local_17;
                                            if _e2087 {
                                                phi_5738_ = 1u;
                                            } else {
                                                phi_5738_ = 2u;
                                            }
                                            let _e2089 = phi_5738_;
                                            phi_5739_ = _e2089;
                                            phi_5740_ = false;
                                        } else {
                                            phi_5739_ = u32();
                                            phi_5740_ = true;
                                        }
                                        let _e2091 = phi_5739_;
                                        let _e2093 = phi_5740_;
                                        phi_5741_ = _e2091;
                                        phi_5742_ = 0u;
                                        phi_5743_ = _e2093;
                                    } else {
                                        phi_5741_ = u32();
                                        phi_5742_ = 2u;
                                        phi_5743_ = true;
                                    }
                                    let _e2095 = phi_5741_;
                                    let _e2097 = phi_5742_;
                                    let _e2099 = phi_5743_;
                                    if _e2099 {
                                        phi_5747_ = _e2097;
                                    } else {
                                        phi_5747_ = _e2095;
                                    }
                                    let _e2101 = phi_5747_;
                                    let _e2102 = (_e2101 == 0u);
                                    if _e2102 {
                                        phi_7878_ = f32();
                                        phi_7879_ = false;
                                        phi_7880_ = false;
                                        phi_7881_ = false;
                                    } else {
                                        if (_e2101 == 1u) {
                                            if _e1393.member_2 {
                                                if ((_e1393.member_1 - _e1393.member) <= 0.0000005f) {
                                                    phi_5767_ = false;
                                                } else {
                                                    phi_5767_ = true;
                                                }
                                                let _e2110 = phi_5767_;
                                                phi_5768_ = _e2110;
                                            } else {
                                                phi_5768_ = true;
                                            }
                                            let _e2112 = phi_5768_;
                                            phi_5769_ = _e2112;
                                        } else {
                                            phi_5769_ = true;
                                        }
                                        let _e2114 = phi_5769_;
                                        if _e2114 {
                                            let _e2119 = local_12.member[0u];
                                            let _e2125 = local_12.member_1[0u];
                                            let _e2131 = local_12.member_2[0u];
                                            let _e2135 = (_e2119[0] - _e2125[0]);
                                            let _e2136 = (_e2119[1] - _e2125[1]);
                                            let _e2137 = (_e2119[2] - _e2125[2]);
                                            let _e2146 = local_12.member[1u];
                                            let _e2152 = local_12.member_1[1u];
                                            let _e2158 = local_12.member_2[1u];
                                            let _e2162 = (_e2146[0] - _e2152[0]);
                                            let _e2163 = (_e2146[1] - _e2152[1]);
                                            let _e2164 = (_e2146[2] - _e2152[2]);
                                            let _e2173 = local_12.member[0u];
                                            if (_e2173[0] < 0f) {
                                                phi_5917_ = -(_e2173[0]);
                                            } else {
                                                phi_5917_ = _e2173[0];
                                            }
                                            let _e2180 = phi_5917_;
                                            if (_e2173[1] < 0f) {
                                                phi_5924_ = -(_e2173[1]);
                                            } else {
                                                phi_5924_ = _e2173[1];
                                            }
                                            let _e2184 = phi_5924_;
                                            if (_e2180 > _e2184) {
                                                phi_5929_ = _e2180;
                                            } else {
                                                phi_5929_ = _e2184;
                                            }
                                            let _e2187 = phi_5929_;
                                            if (_e2173[2] < 0f) {
                                                phi_5936_ = -(_e2173[2]);
                                            } else {
                                                phi_5936_ = _e2173[2];
                                            }
                                            let _e2191 = phi_5936_;
                                            if (_e2187 > _e2191) {
                                                phi_5941_ = _e2187;
                                            } else {
                                                phi_5941_ = _e2191;
                                            }
                                            let _e2194 = phi_5941_;
                                            let _e2197 = local_12.member[1u];
                                            if (_e2197[0] < 0f) {
                                                phi_5954_ = -(_e2197[0]);
                                            } else {
                                                phi_5954_ = _e2197[0];
                                            }
                                            let _e2204 = phi_5954_;
                                            if (_e2197[1] < 0f) {
                                                phi_5961_ = -(_e2197[1]);
                                            } else {
                                                phi_5961_ = _e2197[1];
                                            }
                                            let _e2208 = phi_5961_;
                                            if (_e2204 > _e2208) {
                                                phi_5966_ = _e2204;
                                            } else {
                                                phi_5966_ = _e2208;
                                            }
                                            let _e2211 = phi_5966_;
                                            if (_e2197[2] < 0f) {
                                                phi_5973_ = -(_e2197[2]);
                                            } else {
                                                phi_5973_ = _e2197[2];
                                            }
                                            let _e2215 = phi_5973_;
                                            if (_e2211 > _e2215) {
                                                phi_5978_ = _e2211;
                                            } else {
                                                phi_5978_ = _e2215;
                                            }
                                            let _e2218 = phi_5978_;
                                            if (_e2194 > _e2218) {
                                                phi_5983_ = _e2194;
                                            } else {
                                                phi_5983_ = _e2218;
                                            }
                                            let _e2221 = phi_5983_;
                                            let _e2223 = local_12.member_3;
                                            let _e2227 = local_12.member_1[0u];
                                            if (_e2227[0] < 0f) {
                                                phi_6000_ = -(_e2227[0]);
                                            } else {
                                                phi_6000_ = _e2227[0];
                                            }
                                            let _e2234 = phi_6000_;
                                            if (_e2227[1] < 0f) {
                                                phi_6007_ = -(_e2227[1]);
                                            } else {
                                                phi_6007_ = _e2227[1];
                                            }
                                            let _e2238 = phi_6007_;
                                            if (_e2234 > _e2238) {
                                                phi_6012_ = _e2234;
                                            } else {
                                                phi_6012_ = _e2238;
                                            }
                                            let _e2241 = phi_6012_;
                                            if (_e2227[2] < 0f) {
                                                phi_6019_ = -(_e2227[2]);
                                            } else {
                                                phi_6019_ = _e2227[2];
                                            }
                                            let _e2245 = phi_6019_;
                                            if (_e2241 > _e2245) {
                                                phi_6024_ = _e2241;
                                            } else {
                                                phi_6024_ = _e2245;
                                            }
                                            let _e2248 = phi_6024_;
                                            let _e2251 = local_12.member_1[1u];
                                            if (_e2251[0] < 0f) {
                                                phi_6038_ = -(_e2251[0]);
                                            } else {
                                                phi_6038_ = _e2251[0];
                                            }
                                            let _e2258 = phi_6038_;
                                            if (_e2251[1] < 0f) {
                                                phi_6045_ = -(_e2251[1]);
                                            } else {
                                                phi_6045_ = _e2251[1];
                                            }
                                            let _e2262 = phi_6045_;
                                            if (_e2258 > _e2262) {
                                                phi_6050_ = _e2258;
                                            } else {
                                                phi_6050_ = _e2262;
                                            }
                                            let _e2265 = phi_6050_;
                                            if (_e2251[2] < 0f) {
                                                phi_6057_ = -(_e2251[2]);
                                            } else {
                                                phi_6057_ = _e2251[2];
                                            }
                                            let _e2269 = phi_6057_;
                                            if (_e2265 > _e2269) {
                                                phi_6062_ = _e2265;
                                            } else {
                                                phi_6062_ = _e2269;
                                            }
                                            let _e2272 = phi_6062_;
                                            if (_e2248 > _e2272) {
                                                phi_6067_ = _e2248;
                                            } else {
                                                phi_6067_ = _e2272;
                                            }
                                            let _e2275 = phi_6067_;
                                            let _e2277 = local_12.member_3;
                                            let _e2281 = local_12.member_2[0u];
                                            if (_e2281[0] < 0f) {
                                                phi_6084_ = -(_e2281[0]);
                                            } else {
                                                phi_6084_ = _e2281[0];
                                            }
                                            let _e2288 = phi_6084_;
                                            if (_e2281[1] < 0f) {
                                                phi_6091_ = -(_e2281[1]);
                                            } else {
                                                phi_6091_ = _e2281[1];
                                            }
                                            let _e2292 = phi_6091_;
                                            if (_e2288 > _e2292) {
                                                phi_6096_ = _e2288;
                                            } else {
                                                phi_6096_ = _e2292;
                                            }
                                            let _e2295 = phi_6096_;
                                            if (_e2281[2] < 0f) {
                                                phi_6103_ = -(_e2281[2]);
                                            } else {
                                                phi_6103_ = _e2281[2];
                                            }
                                            let _e2299 = phi_6103_;
                                            if (_e2295 > _e2299) {
                                                phi_6108_ = _e2295;
                                            } else {
                                                phi_6108_ = _e2299;
                                            }
                                            let _e2302 = phi_6108_;
                                            let _e2305 = local_12.member_2[1u];
                                            if (_e2305[0] < 0f) {
                                                phi_6122_ = -(_e2305[0]);
                                            } else {
                                                phi_6122_ = _e2305[0];
                                            }
                                            let _e2312 = phi_6122_;
                                            if (_e2305[1] < 0f) {
                                                phi_6129_ = -(_e2305[1]);
                                            } else {
                                                phi_6129_ = _e2305[1];
                                            }
                                            let _e2316 = phi_6129_;
                                            if (_e2312 > _e2316) {
                                                phi_6134_ = _e2312;
                                            } else {
                                                phi_6134_ = _e2316;
                                            }
                                            let _e2319 = phi_6134_;
                                            if (_e2305[2] < 0f) {
                                                phi_6141_ = -(_e2305[2]);
                                            } else {
                                                phi_6141_ = _e2305[2];
                                            }
                                            let _e2323 = phi_6141_;
                                            if (_e2319 > _e2323) {
                                                phi_6146_ = _e2319;
                                            } else {
                                                phi_6146_ = _e2323;
                                            }
                                            let _e2326 = phi_6146_;
                                            if (_e2302 > _e2326) {
                                                phi_6151_ = _e2302;
                                            } else {
                                                phi_6151_ = _e2326;
                                            }
                                            let _e2329 = phi_6151_;
                                            let _e2331 = local_12.member_3;
                                            let _e2338 = local_12.member_3;
                                            local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_6190_ = type_9(0u, 96u);
                                            phi_6193_ = _e1393.member;
                                            phi_6195_ = _e1393.member;
                                            phi_6197_ = _e1393.member;
                                            loop {
                                                let _e2344 = phi_6190_;
                                                let _e2346 = phi_6193_;
                                                let _e2348 = phi_6195_;
                                                let _e2350 = phi_6197_;
                                                local_36 = _e2348;
                                                local_20 = _e2346;
                                                if (_e2344.member < _e2344.member_1) {
                                                    phi_6191_ = type_9((_e2344.member + 1u), _e2344.member_1);
                                                    phi_6220_ = type_9(1u, _e2344.member);
                                                } else {
                                                    phi_6191_ = _e2344;
                                                    phi_6220_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2362 = phi_6191_;
                                                let _e2364 = phi_6220_;
                                                if (bitcast<i32>(_e2364.member) != 0i) {
                                                    let _e2371 = local_12.member[0u];
                                                    let _e2377 = local_12.member[1u];
                                                    let _e2393 = local_12.member_1[0u];
                                                    let _e2399 = local_12.member_1[1u];
                                                    let _e2415 = local_12.member_2[0u];
                                                    let _e2421 = local_12.member_2[1u];
                                                    let _e2435 = function_2(array<f32, 3>((_e2371[0] + ((_e2377[0] - _e2371[0]) * _e2346)), (_e2371[1] + ((_e2377[1] - _e2371[1]) * _e2346)), (_e2371[2] + ((_e2377[2] - _e2371[2]) * _e2346))), array<f32, 3>((_e2393[0] + ((_e2399[0] - _e2393[0]) * _e2346)), (_e2393[1] + ((_e2399[1] - _e2393[1]) * _e2346)), (_e2393[2] + ((_e2399[2] - _e2393[2]) * _e2346))), array<f32, 3>((_e2415[0] + ((_e2421[0] - _e2415[0]) * _e2346)), (_e2415[1] + ((_e2421[1] - _e2415[1]) * _e2346)), (_e2415[2] + ((_e2421[2] - _e2415[2]) * _e2346))), 1u);
                                                    if (_e2435[0] < 0f) {
                                                        phi_6332_ = -(_e2435[0]);
                                                    } else {
                                                        phi_6332_ = _e2435[0];
                                                    }
                                                    let _e2440 = phi_6332_;
                                                    if (_e2435[1] < 0f) {
                                                        phi_6339_ = -(_e2435[1]);
                                                    } else {
                                                        phi_6339_ = _e2435[1];
                                                    }
                                                    let _e2445 = phi_6339_;
                                                    if (_e2435[2] < 0f) {
                                                        phi_6347_ = -(_e2435[2]);
                                                    } else {
                                                        phi_6347_ = _e2435[2];
                                                    }
                                                    let _e2451 = phi_6347_;
                                                    let _e2452 = ((_e2440 + _e2445) + _e2451);
                                                    if (_e2452 > 0f) {
                                                        if ((bitcast<u32>(_e2452) & 2139095040u) != 2139095040u) {
                                                            let _e2457 = (1f / _e2452);
                                                            let _e2459 = (_e2435[0] * _e2457);
                                                            let _e2461 = (_e2435[1] * _e2457);
                                                            let _e2463 = (_e2435[2] * _e2457);
                                                            let _e2468 = (((_e2459 * _e2459) + (_e2461 * _e2461)) + (_e2463 * _e2463));
                                                            if (_e2468 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2468 > 0f) {
                                                                    phi_6384_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6384_ = 0f;
                                                                }
                                                                let _e2521 = phi_6384_;
                                                                phi_6448_ = _e2521;
                                                            } else {
                                                                phi_6391_ = type_14(0i, 5i);
                                                                phi_6394_ = bitcast<f32>(((bitcast<u32>(_e2468) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2476 = phi_6391_;
                                                                    let _e2478 = phi_6394_;
                                                                    local_18 = _e2478;
                                                                    if (_e2476.member < _e2476.member_1) {
                                                                        let _e2485 = (_e2476.member + 1i);
                                                                        if ((false == (_e2485 > _e2476.member)) != false) {
                                                                            phi_6415_ = true;
                                                                        } else {
                                                                            phi_6415_ = false;
                                                                        }
                                                                        let _e2490 = phi_6415_;
                                                                        if _e2490 {
                                                                            phi_6421_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_6421_ = type_15(1u, _e2485);
                                                                        }
                                                                        let _e2495 = phi_6421_;
                                                                        phi_6392_ = type_14(_e2495.member_1, _e2476.member_1);
                                                                        phi_6435_ = type_15(1u, _e2476.member);
                                                                    } else {
                                                                        phi_6392_ = _e2476;
                                                                        phi_6435_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2501 = phi_6392_;
                                                                    let _e2503 = phi_6435_;
                                                                    let _e2506 = (bitcast<i32>(_e2503.member) != 0i);
                                                                    if _e2506 {
                                                                        phi_6395_ = (0.5f * (_e2478 + (_e2468 / _e2478)));
                                                                    } else {
                                                                        phi_6395_ = f32();
                                                                    }
                                                                    let _e2511 = phi_6395_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6391_ = _e2501;
                                                                        phi_6394_ = _e2511;
                                                                        break if !(_e2506);
                                                                    }
                                                                }
                                                                let _e2516 = local_18;
                                                                phi_6448_ = (_e2516 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2523 = phi_6448_;
                                                            let _e2524 = (0.000000059604645f * 12f);
                                                            let _e2529 = ((((((((_e2221 + _e2223) + (_e2275 + _e2277)) + (_e2329 + _e2331)) * (0.000000059604645f * 16f)) + (_e2338 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2523) * (1f + _e2524)));
                                                            let _e2534 = (((_e2459 * _e2119[0]) + (_e2461 * _e2119[1])) + (_e2463 * _e2119[2]));
                                                            let _e2539 = (((_e2459 * _e2135) + (_e2461 * _e2136)) + (_e2463 * _e2137));
                                                            let _e2544 = (((_e2459 * (_e2119[0] - _e2131[0])) + (_e2461 * (_e2119[1] - _e2131[1]))) + (_e2463 * (_e2119[2] - _e2131[2])));
                                                            let _e2549 = (((_e2459 * (_e2135 - _e2131[0])) + (_e2461 * (_e2136 - _e2131[1]))) + (_e2463 * (_e2137 - _e2131[2])));
                                                            let _e2555 = (((_e2459 * _e2146[0]) + (_e2461 * _e2146[1])) + (_e2463 * _e2146[2]));
                                                            let _e2560 = (((_e2459 * _e2162) + (_e2461 * _e2163)) + (_e2463 * _e2164));
                                                            let _e2565 = (((_e2459 * (_e2146[0] - _e2158[0])) + (_e2461 * (_e2146[1] - _e2158[1]))) + (_e2463 * (_e2146[2] - _e2158[2])));
                                                            let _e2570 = (((_e2459 * (_e2162 - _e2158[0])) + (_e2461 * (_e2163 - _e2158[1]))) + (_e2463 * (_e2164 - _e2158[2])));
                                                            if (_e2534 < 0f) {
                                                                phi_6514_ = -(_e2534);
                                                            } else {
                                                                phi_6514_ = _e2534;
                                                            }
                                                            let _e2575 = phi_6514_;
                                                            if (_e2555 < 0f) {
                                                                phi_6520_ = -(_e2555);
                                                            } else {
                                                                phi_6520_ = _e2555;
                                                            }
                                                            let _e2579 = phi_6520_;
                                                            if (_e2539 < 0f) {
                                                                phi_6529_ = -(_e2539);
                                                            } else {
                                                                phi_6529_ = _e2539;
                                                            }
                                                            let _e2586 = phi_6529_;
                                                            if (_e2560 < 0f) {
                                                                phi_6535_ = -(_e2560);
                                                            } else {
                                                                phi_6535_ = _e2560;
                                                            }
                                                            let _e2590 = phi_6535_;
                                                            if (_e2544 < 0f) {
                                                                phi_6544_ = -(_e2544);
                                                            } else {
                                                                phi_6544_ = _e2544;
                                                            }
                                                            let _e2597 = phi_6544_;
                                                            if (_e2565 < 0f) {
                                                                phi_6550_ = -(_e2565);
                                                            } else {
                                                                phi_6550_ = _e2565;
                                                            }
                                                            let _e2601 = phi_6550_;
                                                            if (_e2549 < 0f) {
                                                                phi_6559_ = -(_e2549);
                                                            } else {
                                                                phi_6559_ = _e2549;
                                                            }
                                                            let _e2608 = phi_6559_;
                                                            if (_e2570 < 0f) {
                                                                phi_6565_ = -(_e2570);
                                                            } else {
                                                                phi_6565_ = _e2570;
                                                            }
                                                            let _e2612 = phi_6565_;
                                                            phi_6571_ = type_30(array<f32, 4>(_e2534, _e2539, _e2544, _e2549), array<f32, 4>(_e2555, _e2560, _e2565, _e2570), array<f32, 4>((_e2529 + ((_e2575 + _e2579) * _e2524)), (_e2529 + ((_e2586 + _e2590) * _e2524)), (_e2529 + ((_e2597 + _e2601) * _e2524)), (_e2529 + ((_e2608 + _e2612) * _e2524))));
                                                            phi_6572_ = false;
                                                        } else {
                                                            phi_6571_ = type_30();
                                                            phi_6572_ = true;
                                                        }
                                                        let _e2619 = phi_6571_;
                                                        let _e2621 = phi_6572_;
                                                        phi_6573_ = _e2619;
                                                        phi_6574_ = _e2621;
                                                    } else {
                                                        phi_6573_ = type_30();
                                                        phi_6574_ = true;
                                                    }
                                                    let _e2623 = phi_6573_;
                                                    let _e2625 = phi_6574_;
                                                    if _e2625 {
                                                        phi_6582_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_6582_ = _e2623;
                                                    }
                                                    let _e2627 = phi_6582_;
                                                    local_1 = type_30(array<f32, 4>(_e2627.member[0], _e2627.member[1], _e2627.member[2], _e2627.member[3]), array<f32, 4>(_e2627.member_1[0], _e2627.member_1[1], _e2627.member_1[2], _e2627.member_1[3]), array<f32, 4>(_e2627.member_2[0], _e2627.member_2[1], _e2627.member_2[2], _e2627.member_2[3]));
                                                    let _e2647 = (_e2346 - _e2350);
                                                    let _e2650 = local_1.member[0u];
                                                    let _e2653 = local_1.member_1[0u];
                                                    let _e2656 = local_1.member[0u];
                                                    let _e2662 = local_1.member_2[0u];
                                                    if (((_e2650 + ((_e2653 - _e2656) * _e2346)) - _e2662) > 0f) {
                                                        let _e2667 = local_1.member[1u];
                                                        let _e2670 = local_1.member_1[1u];
                                                        let _e2673 = local_1.member[1u];
                                                        let _e2679 = local_1.member_2[1u];
                                                        if (((_e2667 + ((_e2670 - _e2673) * _e2346)) - _e2679) > 0f) {
                                                            let _e2684 = local_1.member[2u];
                                                            let _e2687 = local_1.member_1[2u];
                                                            let _e2690 = local_1.member[2u];
                                                            let _e2696 = local_1.member_2[2u];
                                                            if (((_e2684 + ((_e2687 - _e2690) * _e2346)) - _e2696) > 0f) {
                                                                let _e2701 = local_1.member[3u];
                                                                let _e2704 = local_1.member_1[3u];
                                                                let _e2707 = local_1.member[3u];
                                                                let _e2713 = local_1.member_2[3u];
                                                                phi_6752_ = (((_e2701 + ((_e2704 - _e2707) * _e2346)) - _e2713) > 0f);
                                                                phi_6753_ = false;
                                                            } else {
                                                                phi_6752_ = bool();
                                                                phi_6753_ = true;
                                                            }
                                                            let _e2717 = phi_6752_;
                                                            let _e2719 = phi_6753_;
                                                            phi_6754_ = _e2717;
                                                            phi_6755_ = _e2719;
                                                        } else {
                                                            phi_6754_ = bool();
                                                            phi_6755_ = true;
                                                        }
                                                        let _e2721 = phi_6754_;
                                                        let _e2723 = phi_6755_;
                                                        phi_6756_ = _e2721;
                                                        phi_6757_ = _e2723;
                                                    } else {
                                                        phi_6756_ = bool();
                                                        phi_6757_ = true;
                                                    }
                                                    let _e2725 = phi_6756_;
                                                    let _e2727 = phi_6757_;
                                                    if _e2727 {
                                                        phi_6761_ = false;
                                                    } else {
                                                        phi_6761_ = _e2725;
                                                    }
                                                    let _e2729 = phi_6761_;
                                                    if _e2729 {
                                                        if (_e2346 <= _e2348) {
                                                            phi_7071_ = true;
                                                        } else {
                                                            let _e2733 = local.member[0u];
                                                            let _e2736 = local.member_1[0u];
                                                            let _e2739 = local.member[0u];
                                                            let _e2745 = local.member_2[0u];
                                                            let _e2749 = local_1.member[0u];
                                                            let _e2752 = local_1.member_1[0u];
                                                            let _e2755 = local_1.member[0u];
                                                            let _e2761 = local_1.member_2[0u];
                                                            if ((((_e2733 + ((_e2736 - _e2739) * _e2346)) - _e2745) + ((_e2749 + ((_e2752 - _e2755) * _e2350)) - _e2761)) > 0f) {
                                                                let _e2767 = local.member[1u];
                                                                let _e2770 = local.member_1[1u];
                                                                let _e2773 = local.member[1u];
                                                                let _e2779 = local.member_2[1u];
                                                                let _e2783 = local_1.member[1u];
                                                                let _e2786 = local_1.member_1[1u];
                                                                let _e2789 = local_1.member[1u];
                                                                let _e2795 = local_1.member_2[1u];
                                                                if ((((_e2767 + ((_e2770 - _e2773) * _e2346)) - _e2779) + ((_e2783 + ((_e2786 - _e2789) * _e2350)) - _e2795)) > 0f) {
                                                                    let _e2801 = local.member[2u];
                                                                    let _e2804 = local.member_1[2u];
                                                                    let _e2807 = local.member[2u];
                                                                    let _e2813 = local.member_2[2u];
                                                                    let _e2817 = local_1.member[2u];
                                                                    let _e2820 = local_1.member_1[2u];
                                                                    let _e2823 = local_1.member[2u];
                                                                    let _e2829 = local_1.member_2[2u];
                                                                    if ((((_e2801 + ((_e2804 - _e2807) * _e2346)) - _e2813) + ((_e2817 + ((_e2820 - _e2823) * _e2350)) - _e2829)) > 0f) {
                                                                        let _e2835 = local.member[3u];
                                                                        let _e2838 = local.member_1[3u];
                                                                        let _e2841 = local.member[3u];
                                                                        let _e2847 = local.member_2[3u];
                                                                        let _e2851 = local_1.member[3u];
                                                                        let _e2854 = local_1.member_1[3u];
                                                                        let _e2857 = local_1.member[3u];
                                                                        let _e2863 = local_1.member_2[3u];
                                                                        phi_7058_ = ((((_e2835 + ((_e2838 - _e2841) * _e2346)) - _e2847) + ((_e2851 + ((_e2854 - _e2857) * _e2350)) - _e2863)) > 0f);
                                                                        phi_7059_ = false;
                                                                    } else {
                                                                        phi_7058_ = bool();
                                                                        phi_7059_ = true;
                                                                    }
                                                                    let _e2868 = phi_7058_;
                                                                    let _e2870 = phi_7059_;
                                                                    phi_7060_ = _e2868;
                                                                    phi_7061_ = _e2870;
                                                                } else {
                                                                    phi_7060_ = bool();
                                                                    phi_7061_ = true;
                                                                }
                                                                let _e2872 = phi_7060_;
                                                                let _e2874 = phi_7061_;
                                                                phi_7062_ = _e2872;
                                                                phi_7063_ = _e2874;
                                                            } else {
                                                                phi_7062_ = bool();
                                                                phi_7063_ = true;
                                                            }
                                                            let _e2876 = phi_7062_;
                                                            let _e2878 = phi_7063_;
                                                            if _e2878 {
                                                                phi_7067_ = false;
                                                            } else {
                                                                phi_7067_ = _e2876;
                                                            }
                                                            let _e2880 = phi_7067_;
                                                            phi_7071_ = _e2880;
                                                        }
                                                        let _e2882 = phi_7071_;
                                                        if _e2882 {
                                                            if (_e2364.member_1 > 0u) {
                                                                if (_e2346 >= _e1393.member_1) {
                                                                    phi_7083_ = false;
                                                                } else {
                                                                    phi_7083_ = true;
                                                                }
                                                                let _e2886 = phi_7083_;
                                                                phi_7084_ = _e2886;
                                                            } else {
                                                                phi_7084_ = true;
                                                            }
                                                            let _e2888 = phi_7084_;
                                                            if _e2888 {
                                                                local = type_30(array<f32, 4>(_e2627.member[0], _e2627.member[1], _e2627.member[2], _e2627.member[3]), array<f32, 4>(_e2627.member_1[0], _e2627.member_1[1], _e2627.member_1[2], _e2627.member_1[3]), array<f32, 4>(_e2627.member_2[0], _e2627.member_2[1], _e2627.member_2[2], _e2627.member_2[3]));
                                                                let _e2910 = local.member[0u];
                                                                let _e2913 = local.member_1[0u];
                                                                let _e2916 = local.member_2[0u];
                                                                if (_e2910 > _e2916) {
                                                                    if (_e2913 > _e2916) {
                                                                        phi_7158_ = false;
                                                                    } else {
                                                                        phi_7158_ = true;
                                                                    }
                                                                    let _e2920 = phi_7158_;
                                                                    phi_7159_ = _e2920;
                                                                } else {
                                                                    phi_7159_ = true;
                                                                }
                                                                let _e2922 = phi_7159_;
                                                                if _e2922 {
                                                                    let _e2923 = (_e2913 >= _e2910);
                                                                    if _e2923 {
                                                                        phi_7181_ = f32();
                                                                        phi_7182_ = false;
                                                                    } else {
                                                                        if ((_e2910 - _e2913) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7179_ = (((_e2910 - _e2916) / (_e2910 - _e2913)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7180_ = false;
                                                                        } else {
                                                                            phi_7179_ = f32();
                                                                            phi_7180_ = true;
                                                                        }
                                                                        let _e2934 = phi_7179_;
                                                                        let _e2936 = phi_7180_;
                                                                        phi_7181_ = _e2934;
                                                                        phi_7182_ = _e2936;
                                                                    }
                                                                    let _e2938 = phi_7181_;
                                                                    let _e2940 = phi_7182_;
                                                                    phi_7183_ = _e2938;
                                                                    phi_7184_ = _e2923;
                                                                    phi_7185_ = _e2940;
                                                                } else {
                                                                    phi_7183_ = f32();
                                                                    phi_7184_ = true;
                                                                    phi_7185_ = false;
                                                                }
                                                                let _e2942 = phi_7183_;
                                                                let _e2944 = phi_7184_;
                                                                let _e2946 = phi_7185_;
                                                                if _e2944 {
                                                                    phi_7189_ = 2f;
                                                                    phi_7190_ = true;
                                                                } else {
                                                                    phi_7189_ = _e2346;
                                                                    phi_7190_ = _e2946;
                                                                }
                                                                let _e2948 = phi_7189_;
                                                                let _e2950 = phi_7190_;
                                                                if _e2950 {
                                                                    phi_7194_ = _e2948;
                                                                } else {
                                                                    phi_7194_ = _e2942;
                                                                }
                                                                let _e2952 = phi_7194_;
                                                                let _e2955 = local.member[1u];
                                                                let _e2958 = local.member_1[1u];
                                                                let _e2961 = local.member_2[1u];
                                                                if (_e2955 > _e2961) {
                                                                    if (_e2958 > _e2961) {
                                                                        phi_7226_ = false;
                                                                    } else {
                                                                        phi_7226_ = true;
                                                                    }
                                                                    let _e2965 = phi_7226_;
                                                                    phi_7227_ = _e2965;
                                                                } else {
                                                                    phi_7227_ = true;
                                                                }
                                                                let _e2967 = phi_7227_;
                                                                if _e2967 {
                                                                    let _e2968 = (_e2958 >= _e2955);
                                                                    if _e2968 {
                                                                        phi_7249_ = f32();
                                                                        phi_7250_ = false;
                                                                    } else {
                                                                        if ((_e2955 - _e2958) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7247_ = (((_e2955 - _e2961) / (_e2955 - _e2958)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7248_ = false;
                                                                        } else {
                                                                            phi_7247_ = f32();
                                                                            phi_7248_ = true;
                                                                        }
                                                                        let _e2979 = phi_7247_;
                                                                        let _e2981 = phi_7248_;
                                                                        phi_7249_ = _e2979;
                                                                        phi_7250_ = _e2981;
                                                                    }
                                                                    let _e2983 = phi_7249_;
                                                                    let _e2985 = phi_7250_;
                                                                    phi_7251_ = _e2983;
                                                                    phi_7252_ = _e2968;
                                                                    phi_7253_ = _e2985;
                                                                } else {
                                                                    phi_7251_ = f32();
                                                                    phi_7252_ = true;
                                                                    phi_7253_ = false;
                                                                }
                                                                let _e2987 = phi_7251_;
                                                                let _e2989 = phi_7252_;
                                                                let _e2991 = phi_7253_;
                                                                if _e2989 {
                                                                    phi_7257_ = 2f;
                                                                    phi_7258_ = true;
                                                                } else {
                                                                    phi_7257_ = _e2346;
                                                                    phi_7258_ = _e2991;
                                                                }
                                                                let _e2993 = phi_7257_;
                                                                let _e2995 = phi_7258_;
                                                                if _e2995 {
                                                                    phi_7262_ = _e2993;
                                                                } else {
                                                                    phi_7262_ = _e2987;
                                                                }
                                                                let _e2997 = phi_7262_;
                                                                if (_e2952 < _e2997) {
                                                                    phi_7267_ = _e2952;
                                                                } else {
                                                                    phi_7267_ = _e2997;
                                                                }
                                                                let _e3000 = phi_7267_;
                                                                let _e3003 = local.member[2u];
                                                                let _e3006 = local.member_1[2u];
                                                                let _e3009 = local.member_2[2u];
                                                                if (_e3003 > _e3009) {
                                                                    if (_e3006 > _e3009) {
                                                                        phi_7299_ = false;
                                                                    } else {
                                                                        phi_7299_ = true;
                                                                    }
                                                                    let _e3013 = phi_7299_;
                                                                    phi_7300_ = _e3013;
                                                                } else {
                                                                    phi_7300_ = true;
                                                                }
                                                                let _e3015 = phi_7300_;
                                                                if _e3015 {
                                                                    let _e3016 = (_e3006 >= _e3003);
                                                                    if _e3016 {
                                                                        phi_7322_ = f32();
                                                                        phi_7323_ = false;
                                                                    } else {
                                                                        if ((_e3003 - _e3006) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7320_ = (((_e3003 - _e3009) / (_e3003 - _e3006)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7321_ = false;
                                                                        } else {
                                                                            phi_7320_ = f32();
                                                                            phi_7321_ = true;
                                                                        }
                                                                        let _e3027 = phi_7320_;
                                                                        let _e3029 = phi_7321_;
                                                                        phi_7322_ = _e3027;
                                                                        phi_7323_ = _e3029;
                                                                    }
                                                                    let _e3031 = phi_7322_;
                                                                    let _e3033 = phi_7323_;
                                                                    phi_7324_ = _e3031;
                                                                    phi_7325_ = _e3016;
                                                                    phi_7326_ = _e3033;
                                                                } else {
                                                                    phi_7324_ = f32();
                                                                    phi_7325_ = true;
                                                                    phi_7326_ = false;
                                                                }
                                                                let _e3035 = phi_7324_;
                                                                let _e3037 = phi_7325_;
                                                                let _e3039 = phi_7326_;
                                                                if _e3037 {
                                                                    phi_7330_ = 2f;
                                                                    phi_7331_ = true;
                                                                } else {
                                                                    phi_7330_ = _e2346;
                                                                    phi_7331_ = _e3039;
                                                                }
                                                                let _e3041 = phi_7330_;
                                                                let _e3043 = phi_7331_;
                                                                if _e3043 {
                                                                    phi_7335_ = _e3041;
                                                                } else {
                                                                    phi_7335_ = _e3035;
                                                                }
                                                                let _e3045 = phi_7335_;
                                                                let _e3048 = local.member[3u];
                                                                let _e3051 = local.member_1[3u];
                                                                let _e3054 = local.member_2[3u];
                                                                if (_e3048 > _e3054) {
                                                                    if (_e3051 > _e3054) {
                                                                        phi_7367_ = false;
                                                                    } else {
                                                                        phi_7367_ = true;
                                                                    }
                                                                    let _e3058 = phi_7367_;
                                                                    phi_7368_ = _e3058;
                                                                } else {
                                                                    phi_7368_ = true;
                                                                }
                                                                let _e3060 = phi_7368_;
                                                                if _e3060 {
                                                                    let _e3061 = (_e3051 >= _e3048);
                                                                    if _e3061 {
                                                                        phi_7390_ = f32();
                                                                        phi_7391_ = false;
                                                                    } else {
                                                                        if ((_e3048 - _e3051) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7388_ = (((_e3048 - _e3054) / (_e3048 - _e3051)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7389_ = false;
                                                                        } else {
                                                                            phi_7388_ = f32();
                                                                            phi_7389_ = true;
                                                                        }
                                                                        let _e3072 = phi_7388_;
                                                                        let _e3074 = phi_7389_;
                                                                        phi_7390_ = _e3072;
                                                                        phi_7391_ = _e3074;
                                                                    }
                                                                    let _e3076 = phi_7390_;
                                                                    let _e3078 = phi_7391_;
                                                                    phi_7392_ = _e3076;
                                                                    phi_7393_ = _e3061;
                                                                    phi_7394_ = _e3078;
                                                                } else {
                                                                    phi_7392_ = f32();
                                                                    phi_7393_ = true;
                                                                    phi_7394_ = false;
                                                                }
                                                                let _e3080 = phi_7392_;
                                                                let _e3082 = phi_7393_;
                                                                let _e3084 = phi_7394_;
                                                                if _e3082 {
                                                                    phi_7398_ = 2f;
                                                                    phi_7399_ = true;
                                                                } else {
                                                                    phi_7398_ = _e2346;
                                                                    phi_7399_ = _e3084;
                                                                }
                                                                let _e3086 = phi_7398_;
                                                                let _e3088 = phi_7399_;
                                                                if _e3088 {
                                                                    phi_7403_ = _e3086;
                                                                } else {
                                                                    phi_7403_ = _e3080;
                                                                }
                                                                let _e3090 = phi_7403_;
                                                                if (_e3045 < _e3090) {
                                                                    phi_7408_ = _e3045;
                                                                } else {
                                                                    phi_7408_ = _e3090;
                                                                }
                                                                let _e3093 = phi_7408_;
                                                                if (_e3000 < _e3093) {
                                                                    phi_7413_ = _e3000;
                                                                } else {
                                                                    phi_7413_ = _e3093;
                                                                }
                                                                let _e3096 = phi_7413_;
                                                                if (_e3096 > _e2346) {
                                                                    phi_7418_ = _e3096;
                                                                } else {
                                                                    phi_7418_ = _e2346;
                                                                }
                                                                let _e3099 = phi_7418_;
                                                                let _e3100 = (_e3099 > _e1393.member_1);
                                                                if _e3100 {
                                                                    phi_7430_ = f32();
                                                                    phi_7431_ = false;
                                                                } else {
                                                                    if (_e2364.member_1 == 0u) {
                                                                        phi_7429_ = (_e1393.member_1 - _e2346);
                                                                    } else {
                                                                        phi_7429_ = (_e2647 + _e2647);
                                                                    }
                                                                    let _e3105 = phi_7429_;
                                                                    phi_7430_ = _e3105;
                                                                    phi_7431_ = true;
                                                                }
                                                                let _e3107 = phi_7430_;
                                                                let _e3109 = phi_7431_;
                                                                phi_7432_ = _e3099;
                                                                phi_7433_ = _e3107;
                                                                phi_7434_ = _e3109;
                                                                phi_7435_ = _e3100;
                                                                phi_7436_ = false;
                                                            } else {
                                                                phi_7432_ = f32();
                                                                phi_7433_ = f32();
                                                                phi_7434_ = false;
                                                                phi_7435_ = false;
                                                                phi_7436_ = true;
                                                            }
                                                            let _e3111 = phi_7432_;
                                                            let _e3113 = phi_7433_;
                                                            let _e3115 = phi_7434_;
                                                            let _e3117 = phi_7435_;
                                                            let _e3119 = phi_7436_;
                                                            phi_7437_ = _e3111;
                                                            phi_7438_ = _e3113;
                                                            phi_7439_ = false;
                                                            phi_7440_ = _e3115;
                                                            phi_7441_ = _e3117;
                                                            phi_7442_ = _e3119;
                                                        } else {
                                                            phi_7437_ = f32();
                                                            phi_7438_ = f32();
                                                            phi_7439_ = true;
                                                            phi_7440_ = false;
                                                            phi_7441_ = false;
                                                            phi_7442_ = false;
                                                        }
                                                        let _e3121 = phi_7437_;
                                                        let _e3123 = phi_7438_;
                                                        let _e3125 = phi_7439_;
                                                        let _e3127 = phi_7440_;
                                                        let _e3129 = phi_7441_;
                                                        let _e3131 = phi_7442_;
                                                        phi_7443_ = _e3121;
                                                        phi_7444_ = _e3123;
                                                        phi_7445_ = _e3125;
                                                        phi_7446_ = _e3127;
                                                        phi_7447_ = _e3129;
                                                        phi_7448_ = _e3131;
                                                    } else {
                                                        phi_7443_ = f32();
                                                        phi_7444_ = f32();
                                                        phi_7445_ = true;
                                                        phi_7446_ = false;
                                                        phi_7447_ = false;
                                                        phi_7448_ = false;
                                                    }
                                                    let _e3133 = phi_7443_;
                                                    let _e3135 = phi_7444_;
                                                    let _e3137 = phi_7445_;
                                                    let _e3139 = phi_7446_;
                                                    let _e3141 = phi_7447_;
                                                    let _e3143 = phi_7448_;
                                                    if _e3137 {
                                                        let _e3144 = (_e2346 <= _e2348);
                                                        if _e3144 {
                                                            phi_7777_ = f32();
                                                            phi_7778_ = false;
                                                        } else {
                                                            let _e3147 = local.member[0u];
                                                            let _e3150 = local.member_1[0u];
                                                            let _e3153 = local.member[0u];
                                                            let _e3159 = local.member_2[0u];
                                                            let _e3160 = ((_e3147 + ((_e3150 - _e3153) * _e2350)) - _e3159);
                                                            let _e3163 = local.member[1u];
                                                            let _e3166 = local.member_1[1u];
                                                            let _e3169 = local.member[1u];
                                                            let _e3175 = local.member_2[1u];
                                                            let _e3176 = ((_e3163 + ((_e3166 - _e3169) * _e2350)) - _e3175);
                                                            if (_e3160 < _e3176) {
                                                                phi_7528_ = _e3160;
                                                            } else {
                                                                phi_7528_ = _e3176;
                                                            }
                                                            let _e3179 = phi_7528_;
                                                            let _e3182 = local.member[2u];
                                                            let _e3185 = local.member_1[2u];
                                                            let _e3188 = local.member[2u];
                                                            let _e3194 = local.member_2[2u];
                                                            let _e3195 = ((_e3182 + ((_e3185 - _e3188) * _e2350)) - _e3194);
                                                            let _e3198 = local.member[3u];
                                                            let _e3201 = local.member_1[3u];
                                                            let _e3204 = local.member[3u];
                                                            let _e3210 = local.member_2[3u];
                                                            let _e3211 = ((_e3198 + ((_e3201 - _e3204) * _e2350)) - _e3210);
                                                            if (_e3195 < _e3211) {
                                                                phi_7601_ = _e3195;
                                                            } else {
                                                                phi_7601_ = _e3211;
                                                            }
                                                            let _e3214 = phi_7601_;
                                                            if (_e3179 < _e3214) {
                                                                phi_7606_ = _e3179;
                                                            } else {
                                                                phi_7606_ = _e3214;
                                                            }
                                                            let _e3217 = phi_7606_;
                                                            let _e3220 = local_1.member[0u];
                                                            let _e3223 = local_1.member_1[0u];
                                                            let _e3226 = local_1.member[0u];
                                                            let _e3232 = local_1.member_2[0u];
                                                            let _e3233 = ((_e3220 + ((_e3223 - _e3226) * _e2346)) - _e3232);
                                                            let _e3236 = local_1.member[1u];
                                                            let _e3239 = local_1.member_1[1u];
                                                            let _e3242 = local_1.member[1u];
                                                            let _e3248 = local_1.member_2[1u];
                                                            let _e3249 = ((_e3236 + ((_e3239 - _e3242) * _e2346)) - _e3248);
                                                            if (_e3233 < _e3249) {
                                                                phi_7679_ = _e3233;
                                                            } else {
                                                                phi_7679_ = _e3249;
                                                            }
                                                            let _e3252 = phi_7679_;
                                                            let _e3255 = local_1.member[2u];
                                                            let _e3258 = local_1.member_1[2u];
                                                            let _e3261 = local_1.member[2u];
                                                            let _e3267 = local_1.member_2[2u];
                                                            let _e3268 = ((_e3255 + ((_e3258 - _e3261) * _e2346)) - _e3267);
                                                            let _e3271 = local_1.member[3u];
                                                            let _e3274 = local_1.member_1[3u];
                                                            let _e3277 = local_1.member[3u];
                                                            let _e3283 = local_1.member_2[3u];
                                                            let _e3284 = ((_e3271 + ((_e3274 - _e3277) * _e2346)) - _e3283);
                                                            if (_e3268 < _e3284) {
                                                                phi_7752_ = _e3268;
                                                            } else {
                                                                phi_7752_ = _e3284;
                                                            }
                                                            let _e3287 = phi_7752_;
                                                            if (_e3252 < _e3287) {
                                                                phi_7757_ = _e3252;
                                                            } else {
                                                                phi_7757_ = _e3287;
                                                            }
                                                            let _e3290 = phi_7757_;
                                                            if (_e3290 > 0f) {
                                                                phi_7775_ = 0.5f;
                                                            } else {
                                                                let _e3294 = (0.95f * (_e3217 / (_e3217 - _e3290)));
                                                                if (_e3294 > 0.0625f) {
                                                                    if (_e3294 < 0.9f) {
                                                                        phi_7773_ = _e3294;
                                                                    } else {
                                                                        phi_7773_ = 0.9f;
                                                                    }
                                                                    let _e3298 = phi_7773_;
                                                                    phi_7774_ = _e3298;
                                                                } else {
                                                                    phi_7774_ = 0.0625f;
                                                                }
                                                                let _e3300 = phi_7774_;
                                                                phi_7775_ = _e3300;
                                                            }
                                                            let _e3302 = phi_7775_;
                                                            phi_7777_ = (_e2647 * _e3302);
                                                            phi_7778_ = true;
                                                        }
                                                        let _e3305 = phi_7777_;
                                                        let _e3307 = phi_7778_;
                                                        phi_7779_ = _e2348;
                                                        phi_7780_ = _e3305;
                                                        phi_7781_ = _e2350;
                                                        phi_7782_ = _e3307;
                                                        phi_7783_ = _e3144;
                                                        phi_7784_ = false;
                                                        phi_7785_ = false;
                                                    } else {
                                                        phi_7779_ = _e3133;
                                                        phi_7780_ = _e3135;
                                                        phi_7781_ = _e2346;
                                                        phi_7782_ = _e3139;
                                                        phi_7783_ = false;
                                                        phi_7784_ = _e3141;
                                                        phi_7785_ = _e3143;
                                                    }
                                                    let _e3309 = phi_7779_;
                                                    let _e3311 = phi_7780_;
                                                    let _e3313 = phi_7781_;
                                                    let _e3315 = phi_7782_;
                                                    let _e3317 = phi_7783_;
                                                    let _e3319 = phi_7784_;
                                                    let _e3321 = phi_7785_;
                                                    if _e3315 {
                                                        let _e3322 = (_e3313 + _e3311);
                                                        if (_e3322 > _e3309) {
                                                            phi_7794_ = _e3322;
                                                        } else {
                                                            phi_7794_ = _e3309;
                                                        }
                                                        let _e3325 = phi_7794_;
                                                        if (_e3325 < _e1393.member_1) {
                                                            phi_7799_ = _e3325;
                                                        } else {
                                                            phi_7799_ = _e1393.member_1;
                                                        }
                                                        let _e3328 = phi_7799_;
                                                        if (_e2364.member_1 > 0u) {
                                                            phi_7809_ = ((_e3328 - _e3313) > 0.0000000037252903f);
                                                        } else {
                                                            phi_7809_ = true;
                                                        }
                                                        let _e3333 = phi_7809_;
                                                        if _e3333 {
                                                            phi_7813_ = false;
                                                        } else {
                                                            phi_7813_ = true;
                                                        }
                                                        let _e3335 = phi_7813_;
                                                        phi_7814_ = _e3328;
                                                        phi_7815_ = _e3333;
                                                        phi_7816_ = _e3335;
                                                        phi_7817_ = false;
                                                        phi_7818_ = false;
                                                        phi_7819_ = false;
                                                    } else {
                                                        phi_7814_ = f32();
                                                        phi_7815_ = false;
                                                        phi_7816_ = false;
                                                        phi_7817_ = _e3317;
                                                        phi_7818_ = _e3319;
                                                        phi_7819_ = _e3321;
                                                    }
                                                    let _e3337 = phi_7814_;
                                                    let _e3339 = phi_7815_;
                                                    let _e3341 = phi_7816_;
                                                    let _e3343 = phi_7817_;
                                                    let _e3345 = phi_7818_;
                                                    let _e3347 = phi_7819_;
                                                    phi_6194_ = _e3337;
                                                    phi_6196_ = _e3309;
                                                    phi_6198_ = _e3313;
                                                    phi_7820_ = _e3309;
                                                    phi_7821_ = _e3339;
                                                    phi_7822_ = _e3341;
                                                    phi_7823_ = false;
                                                    phi_7824_ = _e3343;
                                                    phi_7825_ = _e3345;
                                                    phi_7826_ = _e3347;
                                                } else {
                                                    phi_6194_ = f32();
                                                    phi_6196_ = f32();
                                                    phi_6198_ = f32();
                                                    phi_7820_ = f32();
                                                    phi_7821_ = false;
                                                    phi_7822_ = false;
                                                    phi_7823_ = true;
                                                    phi_7824_ = false;
                                                    phi_7825_ = false;
                                                    phi_7826_ = false;
                                                }
                                                let _e3349 = phi_6194_;
                                                let _e3351 = phi_6196_;
                                                let _e3353 = phi_6198_;
                                                let _e3355 = phi_7820_;
                                                let _e3357 = phi_7821_;
                                                let _e3359 = phi_7822_;
                                                let _e3361 = phi_7823_;
                                                let _e3363 = phi_7824_;
                                                let _e3365 = phi_7825_;
                                                let _e3367 = phi_7826_;
                                                local_19 = _e3359;
                                                local_35 = _e3355;
                                                local_37 = _e3361;
                                                local_38 = _e3363;
                                                local_39 = _e3365;
                                                local_40 = _e3367;
                                                continue;
                                                continuing {
                                                    phi_6190_ = _e2362;
                                                    phi_6193_ = _e3349;
                                                    phi_6195_ = _e3351;
                                                    phi_6197_ = _e3353;
                                                    break if !(_e3357);
                                                }
                                            }
                                            let _e3370 = local_19;
                                            if _e3370 {
                                                let _e5796 = local_35;
                                                phi_7830_ = _e5796;
                                                phi_7831_ = true;
                                                phi_7832_ = false;
                                                phi_7833_ = false;
                                                phi_7834_ = false;
                                            } else {
                                                let _e5798 = local_36;
                                                phi_7830_ = _e5798;
                                                let _e5801 = local_37;
                                                phi_7831_ = _e5801;
                                                let _e5804 = local_38;
                                                phi_7832_ = _e5804;
                                                let _e5807 = local_39;
                                                phi_7833_ = _e5807;
                                                let _e5810 = local_40;
                                                phi_7834_ = _e5810;
                                            }
                                            let _e3372 = phi_7830_;
                                            let _e3374 = phi_7831_;
                                            let _e3376 = phi_7832_;
                                            let _e3378 = phi_7833_;
                                            let _e3380 = phi_7834_;
                                            if _e3374 {
                                                phi_7839_ = type_35(1u, _e3372);
                                                phi_7840_ = false;
                                                phi_7841_ = false;
                                                phi_7842_ = false;
                                            } else {
                                                phi_7839_ = type_35();
                                                phi_7840_ = _e3376;
                                                phi_7841_ = _e3378;
                                                phi_7842_ = _e3380;
                                            }
                                            let _e3383 = phi_7839_;
                                            let _e3385 = phi_7840_;
                                            let _e3387 = phi_7841_;
                                            let _e3389 = phi_7842_;
                                            if _e3385 {
                                                let _e3391 = local_20;
                                                phi_7847_ = type_35(1u, _e3391);
                                                phi_7848_ = false;
                                                phi_7849_ = false;
                                            } else {
                                                phi_7847_ = type_35();
                                                phi_7848_ = _e3387;
                                                phi_7849_ = _e3389;
                                            }
                                            let _e3394 = phi_7847_;
                                            let _e3396 = phi_7848_;
                                            let _e3398 = phi_7849_;
                                            if _e3396 {
                                                phi_7854_ = type_35(0u, type_35().member_1);
                                                phi_7855_ = false;
                                                phi_7856_ = true;
                                            } else {
                                                phi_7854_ = _e3394;
                                                phi_7855_ = _e3398;
                                                phi_7856_ = _e3385;
                                            }
                                            let _e3402 = phi_7854_;
                                            let _e3404 = phi_7855_;
                                            let _e3406 = phi_7856_;
                                            if _e3404 {
                                                phi_7861_ = type_35(0u, type_35().member_1);
                                                phi_7862_ = true;
                                            } else {
                                                phi_7861_ = _e3402;
                                                phi_7862_ = _e3406;
                                            }
                                            let _e3410 = phi_7861_;
                                            let _e3412 = phi_7862_;
                                            if _e3412 {
                                                phi_7866_ = _e3410;
                                            } else {
                                                phi_7866_ = _e3383;
                                            }
                                            let _e3414 = phi_7866_;
                                            let _e3417 = (_e3414.member != 0u);
                                            if _e3417 {
                                                phi_7873_ = false;
                                            } else {
                                                phi_7873_ = true;
                                            }
                                            let _e3419 = phi_7873_;
                                            phi_7874_ = _e3414.member_1;
                                            phi_7875_ = _e3419;
                                            phi_7876_ = _e3417;
                                            phi_7877_ = false;
                                        } else {
                                            phi_7874_ = f32();
                                            phi_7875_ = false;
                                            phi_7876_ = false;
                                            phi_7877_ = true;
                                        }
                                        let _e3421 = phi_7874_;
                                        let _e3423 = phi_7875_;
                                        let _e3425 = phi_7876_;
                                        let _e3427 = phi_7877_;
                                        phi_7878_ = _e3421;
                                        phi_7879_ = _e3423;
                                        phi_7880_ = _e3425;
                                        phi_7881_ = _e3427;
                                    }
                                    let _e3429 = phi_7878_;
                                    let _e3431 = phi_7879_;
                                    let _e3433 = phi_7880_;
                                    let _e3435 = phi_7881_;
                                    phi_7882_ = _e3429;
                                    phi_7883_ = _e2102;
                                    phi_7884_ = _e3431;
                                    phi_7885_ = _e3433;
                                    phi_7886_ = _e3435;
                                }
                                let _e3437 = phi_7882_;
                                let _e3439 = phi_7883_;
                                let _e3441 = phi_7884_;
                                let _e3443 = phi_7885_;
                                let _e3445 = phi_7886_;
                                if _e3439 {
                                    phi_7890_ = true;
                                    phi_7891_ = false;
                                    phi_7892_ = false;
                                } else {
                                    phi_7890_ = _e3441;
                                    phi_7891_ = _e3443;
                                    phi_7892_ = _e3445;
                                }
                                let _e3447 = phi_7890_;
                                let _e3449 = phi_7891_;
                                let _e3451 = phi_7892_;
                                phi_7893_ = _e3437;
                                phi_7894_ = _e1393;
                                phi_7895_ = _e3447;
                                phi_7896_ = false;
                                phi_7897_ = _e3449;
                                phi_7898_ = _e3451;
                            } else {
                                phi_7893_ = f32();
                                phi_7894_ = type_37();
                                phi_7895_ = false;
                                phi_7896_ = true;
                                phi_7897_ = false;
                                phi_7898_ = false;
                            }
                            let _e3453 = phi_7893_;
                            let _e3455 = phi_7894_;
                            let _e3457 = phi_7895_;
                            let _e3459 = phi_7896_;
                            let _e3461 = phi_7897_;
                            let _e3463 = phi_7898_;
                            local_21 = _e3459;
                            local_41 = _e3461;
                            local_42 = _e3463;
                            local_22 = _e3453;
                            local_23 = _e3455;
                            continue;
                            continuing {
                                phi_4327_ = _e1123;
                                break if !(_e3457);
                            }
                        }
                        let _e3466 = local_21;
                        if _e3466 {
                            phi_7903_ = type_35(0u, type_35().member_1);
                            phi_7904_ = false;
                            phi_7905_ = false;
                        } else {
                            phi_7903_ = type_35();
                            let _e5852 = local_41;
                            phi_7904_ = _e5852;
                            let _e5855 = local_42;
                            phi_7905_ = _e5855;
                        }
                        let _e3470 = phi_7903_;
                        let _e3472 = phi_7904_;
                        let _e3474 = phi_7905_;
                        if _e3472 {
                            let _e3476 = local_22;
                            phi_7910_ = type_35(2u, _e3476);
                            phi_7911_ = false;
                        } else {
                            phi_7910_ = type_35();
                            phi_7911_ = _e3474;
                        }
                        let _e3479 = phi_7910_;
                        let _e3481 = phi_7911_;
                        if _e3481 {
                            let _e3483 = local_23;
                            phi_7917_ = type_35(1u, _e3483.member);
                            phi_7918_ = true;
                        } else {
                            phi_7917_ = _e3479;
                            phi_7918_ = _e3472;
                        }
                        let _e3487 = phi_7917_;
                        let _e3489 = phi_7918_;
                        if _e3489 {
                            phi_7922_ = _e3487;
                        } else {
                            phi_7922_ = _e3470;
                        }
                        let _e3491 = phi_7922_;
                        phi_7926_ = _e3491;
                    }
                    let _e5165 = phi_7926_;
                    phi_7927_ = _e5165;
                }
                let _e5169 = phi_7927_;
                switch bitcast<i32>(_e5169.member) {
                    case 0: {
                        phi_7940_ = type_38(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5175 = function_(_e5169.member_1);
                        phi_7940_ = type_38(0u, _e5175, true);
                        break;
                    }
                    case 2: {
                        let _e5173 = function_(_e5169.member_1);
                        phi_7940_ = type_38(1u, _e5173, true);
                        break;
                    }
                    default: {
                        phi_7940_ = type_38();
                        break;
                    }
                }
                let _e5178 = phi_7940_;
                if _e5178.member_2 {
                    phi_7947_ = (_e5178.member == 0u);
                } else {
                    phi_7947_ = false;
                }
                let _e5183 = phi_7947_;
                if _e5183 {
                    let _e5191 = (_e5178.member_1[1] >> bitcast<u32>(20i));
                    if (_e5191 <= 896u) {
                        phi_7971_ = 0u;
                    } else {
                        phi_7971_ = ((((_e5191 - 896u) << bitcast<u32>(23i)) | ((_e5178.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5178.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5206 = phi_7971_;
                    let _e5208 = atomicMin((&earliest.member[0u]), _e5206);
                }
                phi_7975_ = type_20(1u, 0u, _e176, _e179, _e5178.member_1);
                phi_7976_ = _e5183;
                phi_7977_ = (_e5178.member != 0u);
            } else {
                phi_7975_ = type_20(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7976_ = false;
                phi_7977_ = false;
            }
            let _e5210 = phi_7975_;
            let _e5212 = phi_7976_;
            let _e5214 = phi_7977_;
            let _e5217 = params.member.member.member_1;
            if ((_e5217 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5212 {
                    let _e5223 = atomicAdd((&counters[0u]), 1u);
                    phi_7996_ = _e5223;
                } else {
                    phi_7996_ = 0u;
                }
                let _e5225 = phi_7996_;
                workgroupBarrier();
                if (_e105 == 0u) {
                    let _e5228 = atomicLoad((&counters[0u]));
                    if (_e5228 > 0u) {
                        let _e5231 = atomicAdd((&contacts.member[0u]), _e5228);
                        atomicStore((&counters[1u]), _e5231);
                    }
                }
                workgroupBarrier();
                let _e5234 = atomicLoad((&counters[1u]));
                let _e5235 = (_e5234 + _e5225);
                if _e5212 {
                    let _e5238 = params.member.member_1.member_3;
                    if (_e5235 < _e5238) {
                        let _e5240 = (6u * _e5235);
                        atomicStore((&contacts.member[(4u + _e5240)]), _e5210.member);
                        atomicStore((&contacts.member[(_e5240 + 5u)]), _e5210.member_1);
                        atomicStore((&contacts.member[(_e5240 + 6u)]), _e5210.member_2);
                        atomicStore((&contacts.member[(_e5240 + 7u)]), _e5210.member_3);
                        atomicStore((&contacts.member[(_e5240 + 8u)]), _e5210.member_4[0]);
                        atomicStore((&contacts.member[(_e5240 + 9u)]), _e5210.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5214 {
                let _e5264 = atomicAdd((&counters[0u]), 1u);
                phi_8059_ = _e5264;
            } else {
                phi_8059_ = 0u;
            }
            let _e5266 = phi_8059_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5269 = atomicLoad((&counters[0u]));
                if (_e5269 > 0u) {
                    let _e5272 = atomicAdd((&undecided.member[0u]), _e5269);
                    atomicStore((&counters[1u]), _e5272);
                }
            }
            workgroupBarrier();
            let _e5275 = atomicLoad((&counters[1u]));
            let _e5276 = (_e5275 + _e5266);
            if _e5214 {
                let _e5279 = params.member.member_2.member;
                if (_e5276 < _e5279) {
                    let _e5283 = (2u * _e5276);
                    atomicStore((&undecided.member[(4u + _e5283)]), _e5210.member_2);
                    atomicStore((&undecided.member[(_e5283 + 5u)]), _e5210.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_261_ = _e161;
            break if !(_e167);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
