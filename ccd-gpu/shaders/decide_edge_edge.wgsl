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

struct type_42 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(0) 
var<storage> params: type_26;
@group(0) @binding(3) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_22;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_42;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_42;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_42;

fn function_(param: f32) -> array<u32, 2> {
    var phi_8717_: array<u32, 2>;
    var phi_8718_: array<u32, 2>;
    var phi_8719_: bool;
    var phi_8723_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_8718_ = array<u32, 2>();
        phi_8719_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_8717_ = array<u32, 2>();
        } else {
            phi_8717_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_8717_;
        phi_8718_ = _e31;
        phi_8719_ = _e17;
    }
    let _e33 = phi_8718_;
    let _e35 = phi_8719_;
    if _e35 {
        phi_8723_ = array<u32, 2>(0u, 0u);
    } else {
        phi_8723_ = _e33;
    }
    let _e37 = phi_8723_;
    return _e37;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_8696_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_8696_ = param_2;
    } else {
        phi_8696_ = param_1;
    }
    let _e26 = phi_8696_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_8288_: bool;
    var phi_8289_: bool;
    var phi_8290_: bool;
    var phi_8291_: bool;
    var phi_8295_: bool;
    var phi_8268_: bool;
    var phi_8269_: bool;
    var phi_8270_: bool;
    var phi_8271_: bool;
    var phi_8272_: bool;
    var phi_8273_: bool;
    var phi_8277_: bool;
    var phi_8296_: bool;
    var phi_8326_: array<f32, 3>;
    var phi_8327_: bool;
    var phi_8328_: array<f32, 3>;
    var phi_8329_: bool;
    var phi_8556_: f32;
    var phi_8557_: f32;
    var phi_8596_: f32;
    var phi_8597_: f32;
    var phi_8642_: f32;
    var phi_8643_: f32;
    var phi_8377_: f32;
    var phi_8378_: f32;
    var phi_8423_: f32;
    var phi_8424_: f32;
    var phi_8466_: f32;
    var phi_8467_: f32;
    var phi_8515_: f32;
    var phi_8516_: f32;
    var phi_8658_: array<array<f32, 3>, 4>;
    var phi_8666_: array<f32, 3>;

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
                    phi_8268_ = (_e76 <= 1f);
                    phi_8269_ = false;
                } else {
                    phi_8268_ = bool();
                    phi_8269_ = true;
                }
                let _e97 = phi_8268_;
                let _e99 = phi_8269_;
                phi_8270_ = _e97;
                phi_8271_ = _e99;
            } else {
                phi_8270_ = bool();
                phi_8271_ = true;
            }
            let _e101 = phi_8270_;
            let _e103 = phi_8271_;
            phi_8272_ = _e101;
            phi_8273_ = _e103;
        } else {
            phi_8272_ = bool();
            phi_8273_ = true;
        }
        let _e105 = phi_8272_;
        let _e107 = phi_8273_;
        if _e107 {
            phi_8277_ = false;
        } else {
            phi_8277_ = _e105;
        }
        let _e109 = phi_8277_;
        phi_8296_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_8288_ = ((_e72 + _e76) <= 1f);
                phi_8289_ = false;
            } else {
                phi_8288_ = bool();
                phi_8289_ = true;
            }
            let _e83 = phi_8288_;
            let _e85 = phi_8289_;
            phi_8290_ = _e83;
            phi_8291_ = _e85;
        } else {
            phi_8290_ = bool();
            phi_8291_ = true;
        }
        let _e87 = phi_8290_;
        let _e89 = phi_8291_;
        if _e89 {
            phi_8295_ = false;
        } else {
            phi_8295_ = _e87;
        }
        let _e91 = phi_8295_;
        phi_8296_ = _e91;
    }
    let _e111 = phi_8296_;
    if (_e68 > 0f) {
        if _e111 {
            phi_8326_ = array<f32, 3>((param_3[0] - ((param_4[0] * _e72) + (param_5[0] * _e76))), (param_3[1] - ((param_4[1] * _e72) + (param_5[1] * _e76))), (param_3[2] - ((param_4[2] * _e72) + (param_5[2] * _e76))));
            phi_8327_ = false;
        } else {
            phi_8326_ = array<f32, 3>();
            phi_8327_ = true;
        }
        let _e136 = phi_8326_;
        let _e138 = phi_8327_;
        phi_8328_ = _e136;
        phi_8329_ = _e138;
    } else {
        phi_8328_ = array<f32, 3>();
        phi_8329_ = true;
    }
    let _e140 = phi_8328_;
    let _e142 = phi_8329_;
    if _e142 {
        let _e145 = (param_3[0] - param_4[0]);
        let _e148 = (param_3[1] - param_4[1]);
        let _e151 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e293 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_8377_ = _e293;
                } else {
                    phi_8377_ = 1f;
                }
                let _e297 = phi_8377_;
                phi_8378_ = _e297;
            } else {
                phi_8378_ = 0f;
            }
            let _e299 = phi_8378_;
            let _e335 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_8423_ = _e335;
                } else {
                    phi_8423_ = 1f;
                }
                let _e339 = phi_8423_;
                phi_8424_ = _e339;
            } else {
                phi_8424_ = 0f;
            }
            let _e341 = phi_8424_;
            let _e374 = ((((_e145 * param_5[0]) + (_e148 * param_5[1])) + (_e151 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_8466_ = _e374;
                } else {
                    phi_8466_ = 1f;
                }
                let _e378 = phi_8466_;
                phi_8467_ = _e378;
            } else {
                phi_8467_ = 0f;
            }
            let _e380 = phi_8467_;
            let _e393 = (param_3[0] - param_5[0]);
            let _e396 = (param_3[1] - param_5[1]);
            let _e399 = (param_3[2] - param_5[2]);
            let _e419 = ((((_e393 * param_4[0]) + (_e396 * param_4[1])) + (_e399 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_8515_ = _e419;
                } else {
                    phi_8515_ = 1f;
                }
                let _e423 = phi_8515_;
                phi_8516_ = _e423;
            } else {
                phi_8516_ = 0f;
            }
            let _e425 = phi_8516_;
            phi_8658_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e299)), (param_3[1] - (param_4[1] * _e299)), (param_3[2] - (param_4[2] * _e299))), array<f32, 3>((param_3[0] - (param_5[0] * _e341)), (param_3[1] - (param_5[1] * _e341)), (param_3[2] - (param_5[2] * _e341))), array<f32, 3>((_e145 - (param_5[0] * _e380)), (_e148 - (param_5[1] * _e380)), (_e151 - (param_5[2] * _e380))), array<f32, 3>((_e393 - (param_4[0] * _e425)), (_e396 - (param_4[1] * _e425)), (_e399 - (param_4[2] * _e425))));
        } else {
            let _e155 = (param_5[0] - param_4[0]);
            let _e158 = (param_5[1] - param_4[1]);
            let _e161 = (param_5[2] - param_4[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_8556_ = _e172;
                } else {
                    phi_8556_ = 1f;
                }
                let _e176 = phi_8556_;
                phi_8557_ = _e176;
            } else {
                phi_8557_ = 0f;
            }
            let _e178 = phi_8557_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_8596_ = _e208;
                } else {
                    phi_8596_ = 1f;
                }
                let _e212 = phi_8596_;
                phi_8597_ = _e212;
            } else {
                phi_8597_ = 0f;
            }
            let _e214 = phi_8597_;
            let _e250 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_8642_ = _e250;
                } else {
                    phi_8642_ = 1f;
                }
                let _e254 = phi_8642_;
                phi_8643_ = _e254;
            } else {
                phi_8643_ = 0f;
            }
            let _e256 = phi_8643_;
            phi_8658_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e214)), (param_3[1] - (param_4[1] * _e214)), (param_3[2] - (param_4[2] * _e214))), array<f32, 3>((param_3[0] - (param_5[0] * _e256)), (param_3[1] - (param_5[1] * _e256)), (param_3[2] - (param_5[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_8658_;
        let _e441 = function_1(_e438[0], _e438[1]);
        let _e443 = function_1(_e441, _e438[2]);
        let _e445 = function_1(_e443, _e438[3]);
        phi_8666_ = _e445;
    } else {
        phi_8666_ = _e140;
    }
    let _e447 = phi_8666_;
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
    var phi_4096_: f32;
    var phi_4102_: f32;
    var phi_4107_: f32;
    var phi_4113_: f32;
    var phi_4119_: f32;
    var phi_4124_: f32;
    var phi_4129_: f32;
    var phi_4137_: bool;
    var phi_4142_: f32;
    var phi_4149_: f32;
    var phi_4189_: type_14;
    var phi_4192_: f32;
    var phi_4213_: bool;
    var phi_4219_: type_15;
    var phi_4190_: type_14;
    var phi_4233_: type_15;
    var phi_4193_: f32;
    var local_13: f32;
    var phi_4182_: f32;
    var phi_4246_: f32;
    var phi_4252_: f32;
    var phi_4277_: type_9;
    var phi_4280_: u32;
    var phi_4278_: type_9;
    var phi_4303_: type_9;
    var phi_4347_: u32;
    var phi_4348_: u32;
    var phi_4281_: u32;
    var phi_4349_: u32;
    var phi_4369_: type_9;
    var phi_4370_: type_9;
    var phi_4393_: type_9;
    var phi_4445_: f32;
    var phi_4452_: f32;
    var phi_4463_: bool;
    var phi_4464_: bool;
    var phi_4465_: bool;
    var phi_4466_: bool;
    var phi_4470_: bool;
    var phi_4481_: type_37;
    var phi_4482_: type_37;
    var phi_4483_: bool;
    var phi_4484_: type_37;
    var phi_4485_: bool;
    var phi_4496_: f32;
    var phi_4506_: type_9;
    var phi_4509_: f32;
    var phi_4511_: f32;
    var phi_4513_: f32;
    var phi_4507_: type_9;
    var phi_4536_: type_9;
    var phi_4561_: f32;
    var phi_4562_: f32;
    var phi_4588_: f32;
    var phi_4604_: f32;
    var phi_4611_: bool;
    var phi_4612_: bool;
    var phi_4613_: bool;
    var phi_4619_: f32;
    var phi_4620_: f32;
    var phi_4621_: bool;
    var phi_4510_: f32;
    var phi_4512_: f32;
    var phi_4514_: f32;
    var phi_4622_: f32;
    var phi_4623_: bool;
    var phi_4624_: bool;
    var local_14: bool;
    var phi_4628_: f32;
    var phi_4629_: f32;
    var phi_4637_: f32;
    var phi_4641_: type_9;
    var phi_4644_: f32;
    var phi_4642_: type_9;
    var phi_4667_: type_9;
    var phi_4697_: f32;
    var phi_4698_: bool;
    var phi_4699_: f32;
    var phi_4700_: bool;
    var phi_4701_: bool;
    var phi_4702_: bool;
    var phi_4703_: f32;
    var phi_4645_: f32;
    var phi_4704_: bool;
    var phi_4705_: bool;
    var phi_4706_: bool;
    var phi_4707_: bool;
    var local_15: bool;
    var phi_4711_: bool;
    var phi_4712_: bool;
    var phi_4716_: bool;
    var phi_4720_: f32;
    var phi_4721_: f32;
    var phi_4723_: type_37;
    var phi_4752_: f32;
    var phi_4759_: f32;
    var phi_4764_: f32;
    var phi_4771_: f32;
    var phi_4776_: f32;
    var phi_4789_: f32;
    var phi_4796_: f32;
    var phi_4801_: f32;
    var phi_4808_: f32;
    var phi_4813_: f32;
    var phi_4818_: f32;
    var phi_4877_: f32;
    var phi_4883_: f32;
    var phi_4888_: f32;
    var phi_4894_: f32;
    var phi_4899_: f32;
    var phi_4911_: f32;
    var phi_4917_: f32;
    var phi_4922_: f32;
    var phi_4928_: f32;
    var phi_4933_: f32;
    var phi_4959_: f32;
    var phi_4966_: f32;
    var phi_4971_: f32;
    var phi_4978_: f32;
    var phi_4983_: f32;
    var phi_4996_: f32;
    var phi_5003_: f32;
    var phi_5008_: f32;
    var phi_5015_: f32;
    var phi_5020_: f32;
    var phi_5025_: f32;
    var phi_5084_: f32;
    var phi_5090_: f32;
    var phi_5095_: f32;
    var phi_5101_: f32;
    var phi_5106_: f32;
    var phi_5118_: f32;
    var phi_5124_: f32;
    var phi_5129_: f32;
    var phi_5135_: f32;
    var phi_5140_: f32;
    var phi_5166_: f32;
    var phi_5173_: f32;
    var phi_5178_: f32;
    var phi_5185_: f32;
    var phi_5190_: f32;
    var phi_5203_: f32;
    var phi_5210_: f32;
    var phi_5215_: f32;
    var phi_5222_: f32;
    var phi_5227_: f32;
    var phi_5232_: f32;
    var phi_5291_: f32;
    var phi_5297_: f32;
    var phi_5302_: f32;
    var phi_5308_: f32;
    var phi_5313_: f32;
    var phi_5325_: f32;
    var phi_5331_: f32;
    var phi_5336_: f32;
    var phi_5342_: f32;
    var phi_5347_: f32;
    var phi_5396_: f32;
    var phi_5402_: f32;
    var phi_5430_: f32;
    var phi_5436_: f32;
    var phi_5441_: u32;
    var phi_5442_: u32;
    var phi_5412_: f32;
    var phi_5418_: f32;
    var phi_5423_: u32;
    var phi_5424_: u32;
    var phi_5443_: u32;
    var phi_5444_: u32;
    var phi_5513_: f32;
    var phi_5522_: f32;
    var phi_5657_: f32;
    var phi_5663_: f32;
    var phi_5670_: f32;
    var phi_5713_: type_9;
    var phi_5716_: bool;
    var phi_5714_: type_9;
    var phi_5739_: type_9;
    var phi_5766_: bool;
    var phi_5767_: bool;
    var phi_5717_: bool;
    var phi_5768_: bool;
    var phi_5769_: bool;
    var local_16: bool;
    var phi_5773_: bool;
    var local_17: bool;
    var phi_5780_: u32;
    var phi_5781_: u32;
    var phi_5782_: bool;
    var phi_5783_: u32;
    var phi_5784_: u32;
    var phi_5785_: bool;
    var phi_5789_: u32;
    var phi_5809_: bool;
    var phi_5810_: bool;
    var phi_5811_: bool;
    var phi_5959_: f32;
    var phi_5966_: f32;
    var phi_5971_: f32;
    var phi_5978_: f32;
    var phi_5983_: f32;
    var phi_5996_: f32;
    var phi_6003_: f32;
    var phi_6008_: f32;
    var phi_6015_: f32;
    var phi_6020_: f32;
    var phi_6025_: f32;
    var phi_6042_: f32;
    var phi_6049_: f32;
    var phi_6054_: f32;
    var phi_6061_: f32;
    var phi_6066_: f32;
    var phi_6080_: f32;
    var phi_6087_: f32;
    var phi_6092_: f32;
    var phi_6099_: f32;
    var phi_6104_: f32;
    var phi_6109_: f32;
    var phi_6126_: f32;
    var phi_6133_: f32;
    var phi_6138_: f32;
    var phi_6145_: f32;
    var phi_6150_: f32;
    var phi_6164_: f32;
    var phi_6171_: f32;
    var phi_6176_: f32;
    var phi_6183_: f32;
    var phi_6188_: f32;
    var phi_6193_: f32;
    var phi_6232_: type_9;
    var phi_6235_: f32;
    var phi_6237_: f32;
    var phi_6239_: f32;
    var phi_6241_: bool;
    var phi_6243_: u32;
    var phi_6233_: type_9;
    var phi_6266_: type_9;
    var phi_6380_: f32;
    var phi_6386_: f32;
    var phi_6392_: f32;
    var phi_6394_: array<f32, 3>;
    var phi_6401_: f32;
    var phi_6408_: f32;
    var phi_6416_: f32;
    var phi_6460_: type_14;
    var phi_6463_: f32;
    var phi_6484_: bool;
    var phi_6490_: type_15;
    var phi_6461_: type_14;
    var phi_6504_: type_15;
    var phi_6464_: f32;
    var local_18: f32;
    var phi_6453_: f32;
    var phi_6517_: f32;
    var phi_6583_: f32;
    var phi_6589_: f32;
    var phi_6598_: f32;
    var phi_6604_: f32;
    var phi_6613_: f32;
    var phi_6619_: f32;
    var phi_6628_: f32;
    var phi_6634_: f32;
    var phi_6640_: type_30;
    var phi_6641_: bool;
    var phi_6642_: type_30;
    var phi_6643_: bool;
    var phi_6651_: type_30;
    var phi_6822_: bool;
    var phi_6823_: bool;
    var phi_6824_: bool;
    var phi_6825_: bool;
    var phi_6826_: bool;
    var phi_6827_: bool;
    var phi_6831_: bool;
    var phi_7128_: bool;
    var phi_7129_: bool;
    var phi_7130_: bool;
    var phi_7131_: bool;
    var phi_7132_: bool;
    var phi_7133_: bool;
    var phi_7137_: bool;
    var phi_7141_: bool;
    var phi_7152_: bool;
    var phi_7153_: bool;
    var phi_7227_: bool;
    var phi_7228_: bool;
    var phi_7248_: f32;
    var phi_7249_: bool;
    var phi_7250_: f32;
    var phi_7251_: bool;
    var phi_7252_: f32;
    var phi_7253_: bool;
    var phi_7254_: bool;
    var phi_7258_: f32;
    var phi_7259_: bool;
    var phi_7263_: f32;
    var phi_7295_: bool;
    var phi_7296_: bool;
    var phi_7316_: f32;
    var phi_7317_: bool;
    var phi_7318_: f32;
    var phi_7319_: bool;
    var phi_7320_: f32;
    var phi_7321_: bool;
    var phi_7322_: bool;
    var phi_7326_: f32;
    var phi_7327_: bool;
    var phi_7331_: f32;
    var phi_7336_: f32;
    var phi_7368_: bool;
    var phi_7369_: bool;
    var phi_7389_: f32;
    var phi_7390_: bool;
    var phi_7391_: f32;
    var phi_7392_: bool;
    var phi_7393_: f32;
    var phi_7394_: bool;
    var phi_7395_: bool;
    var phi_7399_: f32;
    var phi_7400_: bool;
    var phi_7404_: f32;
    var phi_7436_: bool;
    var phi_7437_: bool;
    var phi_7457_: f32;
    var phi_7458_: bool;
    var phi_7459_: f32;
    var phi_7460_: bool;
    var phi_7461_: f32;
    var phi_7462_: bool;
    var phi_7463_: bool;
    var phi_7467_: f32;
    var phi_7468_: bool;
    var phi_7472_: f32;
    var phi_7477_: f32;
    var phi_7482_: f32;
    var phi_7487_: f32;
    var phi_7497_: f32;
    var phi_7498_: f32;
    var phi_7499_: bool;
    var phi_7500_: f32;
    var phi_7501_: f32;
    var phi_7502_: bool;
    var phi_7503_: bool;
    var phi_7504_: bool;
    var phi_7505_: f32;
    var phi_7506_: f32;
    var phi_7507_: bool;
    var phi_7508_: bool;
    var phi_7509_: bool;
    var phi_7510_: bool;
    var phi_7511_: f32;
    var phi_7512_: f32;
    var phi_7513_: bool;
    var phi_7514_: bool;
    var phi_7515_: bool;
    var phi_7516_: bool;
    var phi_7602_: f32;
    var phi_7675_: f32;
    var phi_7680_: f32;
    var phi_7753_: f32;
    var phi_7826_: f32;
    var phi_7831_: f32;
    var phi_7847_: f32;
    var phi_7848_: f32;
    var phi_7849_: f32;
    var phi_7529_: bool;
    var phi_7851_: u32;
    var phi_7852_: f32;
    var phi_7853_: bool;
    var phi_7854_: bool;
    var phi_7855_: bool;
    var phi_7856_: u32;
    var phi_7857_: f32;
    var phi_7858_: f32;
    var phi_7859_: f32;
    var phi_7860_: bool;
    var phi_7861_: u32;
    var phi_7862_: bool;
    var phi_7863_: bool;
    var phi_7864_: bool;
    var phi_7865_: bool;
    var phi_7866_: bool;
    var phi_7875_: f32;
    var phi_7880_: f32;
    var phi_7889_: bool;
    var phi_7893_: bool;
    var phi_7894_: f32;
    var phi_7895_: f32;
    var phi_7896_: f32;
    var phi_7897_: bool;
    var phi_7898_: u32;
    var phi_7899_: bool;
    var phi_7900_: bool;
    var phi_7901_: bool;
    var phi_7902_: bool;
    var phi_7903_: bool;
    var phi_6236_: f32;
    var phi_6238_: f32;
    var phi_6240_: f32;
    var phi_6242_: bool;
    var phi_6244_: u32;
    var phi_7904_: f32;
    var phi_7905_: bool;
    var phi_7906_: bool;
    var phi_7907_: bool;
    var phi_7908_: bool;
    var phi_7909_: bool;
    var phi_7910_: bool;
    var local_19: bool;
    var phi_7914_: f32;
    var phi_7915_: bool;
    var phi_7916_: bool;
    var phi_7917_: bool;
    var phi_7918_: bool;
    var phi_7923_: type_35;
    var phi_7924_: bool;
    var phi_7925_: bool;
    var phi_7926_: bool;
    var local_20: f32;
    var phi_7931_: type_35;
    var phi_7932_: bool;
    var phi_7933_: bool;
    var phi_7938_: type_35;
    var phi_7939_: bool;
    var phi_7940_: bool;
    var phi_7945_: type_35;
    var phi_7946_: bool;
    var phi_7950_: type_35;
    var phi_7957_: bool;
    var phi_7958_: f32;
    var phi_7959_: bool;
    var phi_7960_: bool;
    var phi_7961_: bool;
    var phi_7962_: f32;
    var phi_7963_: bool;
    var phi_7964_: bool;
    var phi_7965_: bool;
    var phi_7966_: f32;
    var phi_7967_: bool;
    var phi_7968_: bool;
    var phi_7969_: bool;
    var phi_7970_: bool;
    var phi_7974_: bool;
    var phi_7975_: bool;
    var phi_7976_: bool;
    var phi_7977_: f32;
    var phi_7978_: type_37;
    var phi_7979_: bool;
    var phi_7980_: bool;
    var phi_7981_: bool;
    var phi_7982_: bool;
    var local_21: bool;
    var phi_7987_: type_35;
    var phi_7988_: bool;
    var phi_7989_: bool;
    var local_22: f32;
    var phi_7994_: type_35;
    var phi_7995_: bool;
    var local_23: type_37;
    var phi_8001_: type_35;
    var phi_8002_: bool;
    var phi_8006_: type_35;
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
    var phi_1840_: bool;
    var phi_1842_: u32;
    var phi_1832_: type_9;
    var phi_1865_: type_9;
    var phi_1979_: f32;
    var phi_1985_: f32;
    var phi_1991_: f32;
    var phi_1993_: array<f32, 3>;
    var phi_2000_: f32;
    var phi_2007_: f32;
    var phi_2015_: f32;
    var phi_2059_: type_14;
    var phi_2062_: f32;
    var phi_2083_: bool;
    var phi_2089_: type_15;
    var phi_2060_: type_14;
    var phi_2103_: type_15;
    var phi_2063_: f32;
    var local_24: f32;
    var phi_2052_: f32;
    var phi_2116_: f32;
    var phi_2182_: f32;
    var phi_2188_: f32;
    var phi_2197_: f32;
    var phi_2203_: f32;
    var phi_2212_: f32;
    var phi_2218_: f32;
    var phi_2227_: f32;
    var phi_2233_: f32;
    var phi_2239_: type_30;
    var phi_2240_: bool;
    var phi_2241_: type_30;
    var phi_2242_: bool;
    var phi_2250_: type_30;
    var phi_2421_: bool;
    var phi_2422_: bool;
    var phi_2423_: bool;
    var phi_2424_: bool;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var phi_2430_: bool;
    var phi_2727_: bool;
    var phi_2728_: bool;
    var phi_2729_: bool;
    var phi_2730_: bool;
    var phi_2731_: bool;
    var phi_2732_: bool;
    var phi_2736_: bool;
    var phi_2740_: bool;
    var phi_2751_: bool;
    var phi_2752_: bool;
    var phi_2826_: bool;
    var phi_2827_: bool;
    var phi_2847_: f32;
    var phi_2848_: bool;
    var phi_2849_: f32;
    var phi_2850_: bool;
    var phi_2851_: f32;
    var phi_2852_: bool;
    var phi_2853_: bool;
    var phi_2857_: f32;
    var phi_2858_: bool;
    var phi_2862_: f32;
    var phi_2894_: bool;
    var phi_2895_: bool;
    var phi_2915_: f32;
    var phi_2916_: bool;
    var phi_2917_: f32;
    var phi_2918_: bool;
    var phi_2919_: f32;
    var phi_2920_: bool;
    var phi_2921_: bool;
    var phi_2925_: f32;
    var phi_2926_: bool;
    var phi_2930_: f32;
    var phi_2935_: f32;
    var phi_2967_: bool;
    var phi_2968_: bool;
    var phi_2988_: f32;
    var phi_2989_: bool;
    var phi_2990_: f32;
    var phi_2991_: bool;
    var phi_2992_: f32;
    var phi_2993_: bool;
    var phi_2994_: bool;
    var phi_2998_: f32;
    var phi_2999_: bool;
    var phi_3003_: f32;
    var phi_3035_: bool;
    var phi_3036_: bool;
    var phi_3056_: f32;
    var phi_3057_: bool;
    var phi_3058_: f32;
    var phi_3059_: bool;
    var phi_3060_: f32;
    var phi_3061_: bool;
    var phi_3062_: bool;
    var phi_3066_: f32;
    var phi_3067_: bool;
    var phi_3071_: f32;
    var phi_3076_: f32;
    var phi_3081_: f32;
    var phi_3086_: f32;
    var phi_3096_: f32;
    var phi_3097_: f32;
    var phi_3098_: bool;
    var phi_3099_: f32;
    var phi_3100_: f32;
    var phi_3101_: bool;
    var phi_3102_: bool;
    var phi_3103_: bool;
    var phi_3104_: f32;
    var phi_3105_: f32;
    var phi_3106_: bool;
    var phi_3107_: bool;
    var phi_3108_: bool;
    var phi_3109_: bool;
    var phi_3110_: f32;
    var phi_3111_: f32;
    var phi_3112_: bool;
    var phi_3113_: bool;
    var phi_3114_: bool;
    var phi_3115_: bool;
    var phi_3201_: f32;
    var phi_3274_: f32;
    var phi_3279_: f32;
    var phi_3352_: f32;
    var phi_3425_: f32;
    var phi_3430_: f32;
    var phi_3446_: f32;
    var phi_3447_: f32;
    var phi_3448_: f32;
    var phi_3128_: bool;
    var phi_3450_: u32;
    var phi_3451_: f32;
    var phi_3452_: bool;
    var phi_3453_: bool;
    var phi_3454_: bool;
    var phi_3455_: u32;
    var phi_3456_: f32;
    var phi_3457_: f32;
    var phi_3458_: f32;
    var phi_3459_: bool;
    var phi_3460_: u32;
    var phi_3461_: bool;
    var phi_3462_: bool;
    var phi_3463_: bool;
    var phi_3464_: bool;
    var phi_3465_: bool;
    var phi_3474_: f32;
    var phi_3479_: f32;
    var phi_3488_: bool;
    var phi_3492_: bool;
    var phi_3493_: f32;
    var phi_3494_: f32;
    var phi_3495_: f32;
    var phi_3496_: bool;
    var phi_3497_: u32;
    var phi_3498_: bool;
    var phi_3499_: bool;
    var phi_3500_: bool;
    var phi_3501_: bool;
    var phi_3502_: bool;
    var phi_1835_: f32;
    var phi_1837_: f32;
    var phi_1839_: f32;
    var phi_1841_: bool;
    var phi_1843_: u32;
    var phi_3503_: f32;
    var phi_3504_: bool;
    var phi_3505_: bool;
    var phi_3506_: bool;
    var phi_3507_: bool;
    var phi_3508_: bool;
    var phi_3509_: bool;
    var local_25: bool;
    var phi_3513_: f32;
    var phi_3514_: bool;
    var phi_3515_: bool;
    var phi_3516_: bool;
    var phi_3517_: bool;
    var phi_3522_: type_35;
    var phi_3523_: bool;
    var phi_3524_: bool;
    var phi_3525_: bool;
    var local_26: f32;
    var phi_3530_: type_35;
    var phi_3531_: bool;
    var phi_3532_: bool;
    var phi_3537_: type_35;
    var phi_3538_: bool;
    var phi_3539_: bool;
    var phi_3544_: type_35;
    var phi_3545_: bool;
    var phi_3549_: type_35;
    var phi_3563_: type_9;
    var phi_3564_: type_9;
    var phi_3587_: type_9;
    var phi_3607_: f32;
    var phi_3737_: type_14;
    var phi_3740_: f32;
    var phi_3761_: bool;
    var phi_3767_: type_15;
    var phi_3738_: type_14;
    var phi_3781_: type_15;
    var phi_3741_: f32;
    var local_27: f32;
    var phi_3730_: f32;
    var phi_3794_: f32;
    var phi_3810_: f32;
    var phi_3817_: f32;
    var phi_3822_: f32;
    var phi_3829_: f32;
    var phi_3834_: f32;
    var phi_3847_: f32;
    var phi_3854_: f32;
    var phi_3859_: f32;
    var phi_3866_: f32;
    var phi_3871_: f32;
    var phi_3876_: f32;
    var phi_3893_: f32;
    var phi_3900_: f32;
    var phi_3905_: f32;
    var phi_3912_: f32;
    var phi_3917_: f32;
    var phi_3931_: f32;
    var phi_3938_: f32;
    var phi_3943_: f32;
    var phi_3950_: f32;
    var phi_3955_: f32;
    var phi_3960_: f32;
    var phi_3977_: f32;
    var phi_3984_: f32;
    var phi_3989_: f32;
    var phi_3996_: f32;
    var phi_4001_: f32;
    var phi_4015_: f32;
    var phi_4022_: f32;
    var phi_4027_: f32;
    var phi_4034_: f32;
    var phi_4039_: f32;
    var phi_4044_: f32;
    var phi_4064_: bool;
    var phi_4065_: bool;
    var phi_4066_: bool;
    var local_28: bool;
    var phi_4071_: type_35;
    var phi_4072_: bool;
    var phi_4077_: type_35;
    var phi_4078_: bool;
    var phi_4080_: type_35;
    var phi_4081_: type_35;
    var phi_4082_: bool;
    var phi_4086_: type_35;
    var phi_8010_: type_35;
    var phi_8011_: type_35;
    var phi_8024_: type_38;
    var phi_8031_: bool;
    var phi_8055_: u32;
    var phi_8059_: type_20;
    var phi_8060_: bool;
    var phi_8061_: bool;
    var phi_8080_: u32;
    var phi_8143_: u32;
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
                    phi_8011_ = type_35(0u, type_35().member_1);
                } else {
                    if (_e455.member_1 > 0f) {
                        let _e3541 = local_12.member[0u];
                        let _e3547 = local_12.member_1[0u];
                        let _e3553 = local_12.member_2[0u];
                        let _e3557 = (_e3541[0] - _e3547[0]);
                        let _e3558 = (_e3541[1] - _e3547[1]);
                        let _e3559 = (_e3541[2] - _e3547[2]);
                        let _e3568 = local_12.member[1u];
                        let _e3574 = local_12.member_1[1u];
                        let _e3580 = local_12.member_2[1u];
                        let _e3584 = (_e3568[0] - _e3574[0]);
                        let _e3585 = (_e3568[1] - _e3574[1]);
                        let _e3586 = (_e3568[2] - _e3574[2]);
                        let _e3595 = local_12.member[0u];
                        if (_e3595[0] < 0f) {
                            phi_1558_ = -(_e3595[0]);
                        } else {
                            phi_1558_ = _e3595[0];
                        }
                        let _e3602 = phi_1558_;
                        if (_e3595[1] < 0f) {
                            phi_1565_ = -(_e3595[1]);
                        } else {
                            phi_1565_ = _e3595[1];
                        }
                        let _e3606 = phi_1565_;
                        if (_e3602 > _e3606) {
                            phi_1570_ = _e3602;
                        } else {
                            phi_1570_ = _e3606;
                        }
                        let _e3609 = phi_1570_;
                        if (_e3595[2] < 0f) {
                            phi_1577_ = -(_e3595[2]);
                        } else {
                            phi_1577_ = _e3595[2];
                        }
                        let _e3613 = phi_1577_;
                        if (_e3609 > _e3613) {
                            phi_1582_ = _e3609;
                        } else {
                            phi_1582_ = _e3613;
                        }
                        let _e3616 = phi_1582_;
                        let _e3619 = local_12.member[1u];
                        if (_e3619[0] < 0f) {
                            phi_1595_ = -(_e3619[0]);
                        } else {
                            phi_1595_ = _e3619[0];
                        }
                        let _e3626 = phi_1595_;
                        if (_e3619[1] < 0f) {
                            phi_1602_ = -(_e3619[1]);
                        } else {
                            phi_1602_ = _e3619[1];
                        }
                        let _e3630 = phi_1602_;
                        if (_e3626 > _e3630) {
                            phi_1607_ = _e3626;
                        } else {
                            phi_1607_ = _e3630;
                        }
                        let _e3633 = phi_1607_;
                        if (_e3619[2] < 0f) {
                            phi_1614_ = -(_e3619[2]);
                        } else {
                            phi_1614_ = _e3619[2];
                        }
                        let _e3637 = phi_1614_;
                        if (_e3633 > _e3637) {
                            phi_1619_ = _e3633;
                        } else {
                            phi_1619_ = _e3637;
                        }
                        let _e3640 = phi_1619_;
                        if (_e3616 > _e3640) {
                            phi_1624_ = _e3616;
                        } else {
                            phi_1624_ = _e3640;
                        }
                        let _e3643 = phi_1624_;
                        let _e3645 = local_12.member_3;
                        let _e3649 = local_12.member_1[0u];
                        if (_e3649[0] < 0f) {
                            phi_1641_ = -(_e3649[0]);
                        } else {
                            phi_1641_ = _e3649[0];
                        }
                        let _e3656 = phi_1641_;
                        if (_e3649[1] < 0f) {
                            phi_1648_ = -(_e3649[1]);
                        } else {
                            phi_1648_ = _e3649[1];
                        }
                        let _e3660 = phi_1648_;
                        if (_e3656 > _e3660) {
                            phi_1653_ = _e3656;
                        } else {
                            phi_1653_ = _e3660;
                        }
                        let _e3663 = phi_1653_;
                        if (_e3649[2] < 0f) {
                            phi_1660_ = -(_e3649[2]);
                        } else {
                            phi_1660_ = _e3649[2];
                        }
                        let _e3667 = phi_1660_;
                        if (_e3663 > _e3667) {
                            phi_1665_ = _e3663;
                        } else {
                            phi_1665_ = _e3667;
                        }
                        let _e3670 = phi_1665_;
                        let _e3673 = local_12.member_1[1u];
                        if (_e3673[0] < 0f) {
                            phi_1679_ = -(_e3673[0]);
                        } else {
                            phi_1679_ = _e3673[0];
                        }
                        let _e3680 = phi_1679_;
                        if (_e3673[1] < 0f) {
                            phi_1686_ = -(_e3673[1]);
                        } else {
                            phi_1686_ = _e3673[1];
                        }
                        let _e3684 = phi_1686_;
                        if (_e3680 > _e3684) {
                            phi_1691_ = _e3680;
                        } else {
                            phi_1691_ = _e3684;
                        }
                        let _e3687 = phi_1691_;
                        if (_e3673[2] < 0f) {
                            phi_1698_ = -(_e3673[2]);
                        } else {
                            phi_1698_ = _e3673[2];
                        }
                        let _e3691 = phi_1698_;
                        if (_e3687 > _e3691) {
                            phi_1703_ = _e3687;
                        } else {
                            phi_1703_ = _e3691;
                        }
                        let _e3694 = phi_1703_;
                        if (_e3670 > _e3694) {
                            phi_1708_ = _e3670;
                        } else {
                            phi_1708_ = _e3694;
                        }
                        let _e3697 = phi_1708_;
                        let _e3699 = local_12.member_3;
                        let _e3703 = local_12.member_2[0u];
                        if (_e3703[0] < 0f) {
                            phi_1725_ = -(_e3703[0]);
                        } else {
                            phi_1725_ = _e3703[0];
                        }
                        let _e3710 = phi_1725_;
                        if (_e3703[1] < 0f) {
                            phi_1732_ = -(_e3703[1]);
                        } else {
                            phi_1732_ = _e3703[1];
                        }
                        let _e3714 = phi_1732_;
                        if (_e3710 > _e3714) {
                            phi_1737_ = _e3710;
                        } else {
                            phi_1737_ = _e3714;
                        }
                        let _e3717 = phi_1737_;
                        if (_e3703[2] < 0f) {
                            phi_1744_ = -(_e3703[2]);
                        } else {
                            phi_1744_ = _e3703[2];
                        }
                        let _e3721 = phi_1744_;
                        if (_e3717 > _e3721) {
                            phi_1749_ = _e3717;
                        } else {
                            phi_1749_ = _e3721;
                        }
                        let _e3724 = phi_1749_;
                        let _e3727 = local_12.member_2[1u];
                        if (_e3727[0] < 0f) {
                            phi_1763_ = -(_e3727[0]);
                        } else {
                            phi_1763_ = _e3727[0];
                        }
                        let _e3734 = phi_1763_;
                        if (_e3727[1] < 0f) {
                            phi_1770_ = -(_e3727[1]);
                        } else {
                            phi_1770_ = _e3727[1];
                        }
                        let _e3738 = phi_1770_;
                        if (_e3734 > _e3738) {
                            phi_1775_ = _e3734;
                        } else {
                            phi_1775_ = _e3738;
                        }
                        let _e3741 = phi_1775_;
                        if (_e3727[2] < 0f) {
                            phi_1782_ = -(_e3727[2]);
                        } else {
                            phi_1782_ = _e3727[2];
                        }
                        let _e3745 = phi_1782_;
                        if (_e3741 > _e3745) {
                            phi_1787_ = _e3741;
                        } else {
                            phi_1787_ = _e3745;
                        }
                        let _e3748 = phi_1787_;
                        if (_e3724 > _e3748) {
                            phi_1792_ = _e3724;
                        } else {
                            phi_1792_ = _e3748;
                        }
                        let _e3751 = phi_1792_;
                        let _e3753 = local_12.member_3;
                        let _e3760 = local_12.member_3;
                        local_9 = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_1831_ = type_9(0u, 96u);
                        phi_1834_ = 0f;
                        phi_1836_ = 0f;
                        phi_1838_ = 0f;
                        phi_1840_ = false;
                        phi_1842_ = 0u;
                        loop {
                            let _e3766 = phi_1831_;
                            let _e3768 = phi_1834_;
                            let _e3770 = phi_1836_;
                            let _e3772 = phi_1838_;
                            let _e3774 = phi_1840_;
                            let _e3776 = phi_1842_;
                            local_44 = _e3770;
                            local_26 = _e3768;
                            if (_e3766.member < _e3766.member_1) {
                                phi_1832_ = type_9((_e3766.member + 1u), _e3766.member_1);
                                phi_1865_ = type_9(1u, _e3766.member);
                            } else {
                                phi_1832_ = _e3766;
                                phi_1865_ = type_9(0u, type_9().member_1);
                            }
                            let _e3788 = phi_1832_;
                            let _e3790 = phi_1865_;
                            if (bitcast<i32>(_e3790.member) != 0i) {
                                let _e3796 = local_12.member[0u];
                                let _e3802 = local_12.member[1u];
                                let _e3818 = local_12.member_1[0u];
                                let _e3824 = local_12.member_1[1u];
                                let _e3840 = local_12.member_2[0u];
                                let _e3846 = local_12.member_2[1u];
                                let _e3860 = function_2(array<f32, 3>((_e3796[0] + ((_e3802[0] - _e3796[0]) * _e3768)), (_e3796[1] + ((_e3802[1] - _e3796[1]) * _e3768)), (_e3796[2] + ((_e3802[2] - _e3796[2]) * _e3768))), array<f32, 3>((_e3818[0] + ((_e3824[0] - _e3818[0]) * _e3768)), (_e3818[1] + ((_e3824[1] - _e3818[1]) * _e3768)), (_e3818[2] + ((_e3824[2] - _e3818[2]) * _e3768))), array<f32, 3>((_e3840[0] + ((_e3846[0] - _e3840[0]) * _e3768)), (_e3840[1] + ((_e3846[1] - _e3840[1]) * _e3768)), (_e3840[2] + ((_e3846[2] - _e3840[2]) * _e3768))), 1u);
                                if (_e3776 == 0u) {
                                    phi_1993_ = _e3860;
                                } else {
                                    if (_e3776 == 1u) {
                                        phi_1979_ = _e3860[0];
                                    } else {
                                        phi_1979_ = 0f;
                                    }
                                    let _e3865 = phi_1979_;
                                    if (_e3776 == 2u) {
                                        phi_1985_ = _e3860[1];
                                    } else {
                                        phi_1985_ = 0f;
                                    }
                                    let _e3869 = phi_1985_;
                                    if (_e3776 == 3u) {
                                        phi_1991_ = _e3860[2];
                                    } else {
                                        phi_1991_ = 0f;
                                    }
                                    let _e3873 = phi_1991_;
                                    phi_1993_ = array<f32, 3>(_e3865, _e3869, _e3873);
                                }
                                let _e3876 = phi_1993_;
                                if (_e3876[0] < 0f) {
                                    phi_2000_ = -(_e3876[0]);
                                } else {
                                    phi_2000_ = _e3876[0];
                                }
                                let _e3881 = phi_2000_;
                                if (_e3876[1] < 0f) {
                                    phi_2007_ = -(_e3876[1]);
                                } else {
                                    phi_2007_ = _e3876[1];
                                }
                                let _e3886 = phi_2007_;
                                if (_e3876[2] < 0f) {
                                    phi_2015_ = -(_e3876[2]);
                                } else {
                                    phi_2015_ = _e3876[2];
                                }
                                let _e3892 = phi_2015_;
                                let _e3893 = ((_e3881 + _e3886) + _e3892);
                                if (_e3893 > 0f) {
                                    if ((bitcast<u32>(_e3893) & 2139095040u) != 2139095040u) {
                                        let _e3898 = (1f / _e3893);
                                        let _e3900 = (_e3876[0] * _e3898);
                                        let _e3902 = (_e3876[1] * _e3898);
                                        let _e3904 = (_e3876[2] * _e3898);
                                        let _e3909 = (((_e3900 * _e3900) + (_e3902 * _e3902)) + (_e3904 * _e3904));
                                        if (_e3909 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3909 > 0f) {
                                                phi_2052_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2052_ = 0f;
                                            }
                                            let _e3962 = phi_2052_;
                                            phi_2116_ = _e3962;
                                        } else {
                                            phi_2059_ = type_14(0i, 5i);
                                            phi_2062_ = bitcast<f32>(((bitcast<u32>(_e3909) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3917 = phi_2059_;
                                                let _e3919 = phi_2062_;
                                                local_24 = _e3919;
                                                if (_e3917.member < _e3917.member_1) {
                                                    let _e3926 = (_e3917.member + 1i);
                                                    if ((false == (_e3926 > _e3917.member)) != false) {
                                                        phi_2083_ = true;
                                                    } else {
                                                        phi_2083_ = false;
                                                    }
                                                    let _e3931 = phi_2083_;
                                                    if _e3931 {
                                                        phi_2089_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_2089_ = type_15(1u, _e3926);
                                                    }
                                                    let _e3936 = phi_2089_;
                                                    phi_2060_ = type_14(_e3936.member_1, _e3917.member_1);
                                                    phi_2103_ = type_15(1u, _e3917.member);
                                                } else {
                                                    phi_2060_ = _e3917;
                                                    phi_2103_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3942 = phi_2060_;
                                                let _e3944 = phi_2103_;
                                                let _e3947 = (bitcast<i32>(_e3944.member) != 0i);
                                                if _e3947 {
                                                    phi_2063_ = (0.5f * (_e3919 + (_e3909 / _e3919)));
                                                } else {
                                                    phi_2063_ = f32();
                                                }
                                                let _e3952 = phi_2063_;
                                                continue;
                                                continuing {
                                                    phi_2059_ = _e3942;
                                                    phi_2062_ = _e3952;
                                                    break if !(_e3947);
                                                }
                                            }
                                            let _e3957 = local_24;
                                            phi_2116_ = (_e3957 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3964 = phi_2116_;
                                        let _e3965 = (0.000000059604645f * 12f);
                                        let _e3970 = ((((((((_e3643 + _e3645) + (_e3697 + _e3699)) + (_e3751 + _e3753)) * (0.000000059604645f * 16f)) + (_e3760 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e455.member_1 * _e3964) * (1f + _e3965)));
                                        let _e3975 = (((_e3900 * _e3541[0]) + (_e3902 * _e3541[1])) + (_e3904 * _e3541[2]));
                                        let _e3980 = (((_e3900 * _e3557) + (_e3902 * _e3558)) + (_e3904 * _e3559));
                                        let _e3985 = (((_e3900 * (_e3541[0] - _e3553[0])) + (_e3902 * (_e3541[1] - _e3553[1]))) + (_e3904 * (_e3541[2] - _e3553[2])));
                                        let _e3990 = (((_e3900 * (_e3557 - _e3553[0])) + (_e3902 * (_e3558 - _e3553[1]))) + (_e3904 * (_e3559 - _e3553[2])));
                                        let _e3996 = (((_e3900 * _e3568[0]) + (_e3902 * _e3568[1])) + (_e3904 * _e3568[2]));
                                        let _e4001 = (((_e3900 * _e3584) + (_e3902 * _e3585)) + (_e3904 * _e3586));
                                        let _e4006 = (((_e3900 * (_e3568[0] - _e3580[0])) + (_e3902 * (_e3568[1] - _e3580[1]))) + (_e3904 * (_e3568[2] - _e3580[2])));
                                        let _e4011 = (((_e3900 * (_e3584 - _e3580[0])) + (_e3902 * (_e3585 - _e3580[1]))) + (_e3904 * (_e3586 - _e3580[2])));
                                        if (_e3975 < 0f) {
                                            phi_2182_ = -(_e3975);
                                        } else {
                                            phi_2182_ = _e3975;
                                        }
                                        let _e4016 = phi_2182_;
                                        if (_e3996 < 0f) {
                                            phi_2188_ = -(_e3996);
                                        } else {
                                            phi_2188_ = _e3996;
                                        }
                                        let _e4020 = phi_2188_;
                                        if (_e3980 < 0f) {
                                            phi_2197_ = -(_e3980);
                                        } else {
                                            phi_2197_ = _e3980;
                                        }
                                        let _e4027 = phi_2197_;
                                        if (_e4001 < 0f) {
                                            phi_2203_ = -(_e4001);
                                        } else {
                                            phi_2203_ = _e4001;
                                        }
                                        let _e4031 = phi_2203_;
                                        if (_e3985 < 0f) {
                                            phi_2212_ = -(_e3985);
                                        } else {
                                            phi_2212_ = _e3985;
                                        }
                                        let _e4038 = phi_2212_;
                                        if (_e4006 < 0f) {
                                            phi_2218_ = -(_e4006);
                                        } else {
                                            phi_2218_ = _e4006;
                                        }
                                        let _e4042 = phi_2218_;
                                        if (_e3990 < 0f) {
                                            phi_2227_ = -(_e3990);
                                        } else {
                                            phi_2227_ = _e3990;
                                        }
                                        let _e4049 = phi_2227_;
                                        if (_e4011 < 0f) {
                                            phi_2233_ = -(_e4011);
                                        } else {
                                            phi_2233_ = _e4011;
                                        }
                                        let _e4053 = phi_2233_;
                                        phi_2239_ = type_30(array<f32, 4>(_e3975, _e3980, _e3985, _e3990), array<f32, 4>(_e3996, _e4001, _e4006, _e4011), array<f32, 4>((_e3970 + ((_e4016 + _e4020) * _e3965)), (_e3970 + ((_e4027 + _e4031) * _e3965)), (_e3970 + ((_e4038 + _e4042) * _e3965)), (_e3970 + ((_e4049 + _e4053) * _e3965))));
                                        phi_2240_ = false;
                                    } else {
                                        phi_2239_ = type_30();
                                        phi_2240_ = true;
                                    }
                                    let _e4060 = phi_2239_;
                                    let _e4062 = phi_2240_;
                                    phi_2241_ = _e4060;
                                    phi_2242_ = _e4062;
                                } else {
                                    phi_2241_ = type_30();
                                    phi_2242_ = true;
                                }
                                let _e4064 = phi_2241_;
                                let _e4066 = phi_2242_;
                                if _e4066 {
                                    phi_2250_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2250_ = _e4064;
                                }
                                let _e4068 = phi_2250_;
                                local_10 = type_30(array<f32, 4>(_e4068.member[0], _e4068.member[1], _e4068.member[2], _e4068.member[3]), array<f32, 4>(_e4068.member_1[0], _e4068.member_1[1], _e4068.member_1[2], _e4068.member_1[3]), array<f32, 4>(_e4068.member_2[0], _e4068.member_2[1], _e4068.member_2[2], _e4068.member_2[3]));
                                let _e4088 = (_e3768 - _e3772);
                                let _e4092 = local_10.member[0u];
                                let _e4095 = local_10.member_1[0u];
                                let _e4098 = local_10.member[0u];
                                let _e4104 = local_10.member_2[0u];
                                if (((_e4092 + ((_e4095 - _e4098) * _e3768)) - _e4104) > 0f) {
                                    let _e4109 = local_10.member[1u];
                                    let _e4112 = local_10.member_1[1u];
                                    let _e4115 = local_10.member[1u];
                                    let _e4121 = local_10.member_2[1u];
                                    if (((_e4109 + ((_e4112 - _e4115) * _e3768)) - _e4121) > 0f) {
                                        let _e4126 = local_10.member[2u];
                                        let _e4129 = local_10.member_1[2u];
                                        let _e4132 = local_10.member[2u];
                                        let _e4138 = local_10.member_2[2u];
                                        if (((_e4126 + ((_e4129 - _e4132) * _e3768)) - _e4138) > 0f) {
                                            let _e4143 = local_10.member[3u];
                                            let _e4146 = local_10.member_1[3u];
                                            let _e4149 = local_10.member[3u];
                                            let _e4155 = local_10.member_2[3u];
                                            phi_2421_ = (((_e4143 + ((_e4146 - _e4149) * _e3768)) - _e4155) > 0f);
                                            phi_2422_ = false;
                                        } else {
                                            phi_2421_ = bool();
                                            phi_2422_ = true;
                                        }
                                        let _e4159 = phi_2421_;
                                        let _e4161 = phi_2422_;
                                        phi_2423_ = _e4159;
                                        phi_2424_ = _e4161;
                                    } else {
                                        phi_2423_ = bool();
                                        phi_2424_ = true;
                                    }
                                    let _e4163 = phi_2423_;
                                    let _e4165 = phi_2424_;
                                    phi_2425_ = _e4163;
                                    phi_2426_ = _e4165;
                                } else {
                                    phi_2425_ = bool();
                                    phi_2426_ = true;
                                }
                                let _e4167 = phi_2425_;
                                let _e4169 = phi_2426_;
                                if _e4169 {
                                    phi_2430_ = false;
                                } else {
                                    phi_2430_ = _e4167;
                                }
                                let _e4171 = phi_2430_;
                                if _e4171 {
                                    if (_e3768 <= _e3770) {
                                        phi_2740_ = true;
                                    } else {
                                        let _e4175 = local_9.member[0u];
                                        let _e4178 = local_9.member_1[0u];
                                        let _e4181 = local_9.member[0u];
                                        let _e4187 = local_9.member_2[0u];
                                        let _e4191 = local_10.member[0u];
                                        let _e4194 = local_10.member_1[0u];
                                        let _e4197 = local_10.member[0u];
                                        let _e4203 = local_10.member_2[0u];
                                        if ((((_e4175 + ((_e4178 - _e4181) * _e3768)) - _e4187) + ((_e4191 + ((_e4194 - _e4197) * _e3772)) - _e4203)) > 0f) {
                                            let _e4209 = local_9.member[1u];
                                            let _e4212 = local_9.member_1[1u];
                                            let _e4215 = local_9.member[1u];
                                            let _e4221 = local_9.member_2[1u];
                                            let _e4225 = local_10.member[1u];
                                            let _e4228 = local_10.member_1[1u];
                                            let _e4231 = local_10.member[1u];
                                            let _e4237 = local_10.member_2[1u];
                                            if ((((_e4209 + ((_e4212 - _e4215) * _e3768)) - _e4221) + ((_e4225 + ((_e4228 - _e4231) * _e3772)) - _e4237)) > 0f) {
                                                let _e4243 = local_9.member[2u];
                                                let _e4246 = local_9.member_1[2u];
                                                let _e4249 = local_9.member[2u];
                                                let _e4255 = local_9.member_2[2u];
                                                let _e4259 = local_10.member[2u];
                                                let _e4262 = local_10.member_1[2u];
                                                let _e4265 = local_10.member[2u];
                                                let _e4271 = local_10.member_2[2u];
                                                if ((((_e4243 + ((_e4246 - _e4249) * _e3768)) - _e4255) + ((_e4259 + ((_e4262 - _e4265) * _e3772)) - _e4271)) > 0f) {
                                                    let _e4277 = local_9.member[3u];
                                                    let _e4280 = local_9.member_1[3u];
                                                    let _e4283 = local_9.member[3u];
                                                    let _e4289 = local_9.member_2[3u];
                                                    let _e4293 = local_10.member[3u];
                                                    let _e4296 = local_10.member_1[3u];
                                                    let _e4299 = local_10.member[3u];
                                                    let _e4305 = local_10.member_2[3u];
                                                    phi_2727_ = ((((_e4277 + ((_e4280 - _e4283) * _e3768)) - _e4289) + ((_e4293 + ((_e4296 - _e4299) * _e3772)) - _e4305)) > 0f);
                                                    phi_2728_ = false;
                                                } else {
                                                    phi_2727_ = bool();
                                                    phi_2728_ = true;
                                                }
                                                let _e4310 = phi_2727_;
                                                let _e4312 = phi_2728_;
                                                phi_2729_ = _e4310;
                                                phi_2730_ = _e4312;
                                            } else {
                                                phi_2729_ = bool();
                                                phi_2730_ = true;
                                            }
                                            let _e4314 = phi_2729_;
                                            let _e4316 = phi_2730_;
                                            phi_2731_ = _e4314;
                                            phi_2732_ = _e4316;
                                        } else {
                                            phi_2731_ = bool();
                                            phi_2732_ = true;
                                        }
                                        let _e4318 = phi_2731_;
                                        let _e4320 = phi_2732_;
                                        if _e4320 {
                                            phi_2736_ = false;
                                        } else {
                                            phi_2736_ = _e4318;
                                        }
                                        let _e4322 = phi_2736_;
                                        phi_2740_ = _e4322;
                                    }
                                    let _e4324 = phi_2740_;
                                    if _e4324 {
                                        if _e3774 {
                                            if (_e3768 >= 1f) {
                                                phi_2751_ = false;
                                            } else {
                                                phi_2751_ = true;
                                            }
                                            let _e4327 = phi_2751_;
                                            phi_2752_ = _e4327;
                                        } else {
                                            phi_2752_ = true;
                                        }
                                        let _e4329 = phi_2752_;
                                        if _e4329 {
                                            local_9 = type_30(array<f32, 4>(_e4068.member[0], _e4068.member[1], _e4068.member[2], _e4068.member[3]), array<f32, 4>(_e4068.member_1[0], _e4068.member_1[1], _e4068.member_1[2], _e4068.member_1[3]), array<f32, 4>(_e4068.member_2[0], _e4068.member_2[1], _e4068.member_2[2], _e4068.member_2[3]));
                                            let _e4351 = local_9.member[0u];
                                            let _e4354 = local_9.member_1[0u];
                                            let _e4357 = local_9.member_2[0u];
                                            if (_e4351 > _e4357) {
                                                if (_e4354 > _e4357) {
                                                    phi_2826_ = false;
                                                } else {
                                                    phi_2826_ = true;
                                                }
                                                let _e4361 = phi_2826_;
                                                phi_2827_ = _e4361;
                                            } else {
                                                phi_2827_ = true;
                                            }
                                            let _e4363 = phi_2827_;
                                            if _e4363 {
                                                let _e4364 = (_e4354 >= _e4351);
                                                if _e4364 {
                                                    phi_2849_ = f32();
                                                    phi_2850_ = false;
                                                } else {
                                                    if ((_e4351 - _e4354) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2847_ = (((_e4351 - _e4357) / (_e4351 - _e4354)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2848_ = false;
                                                    } else {
                                                        phi_2847_ = f32();
                                                        phi_2848_ = true;
                                                    }
                                                    let _e4375 = phi_2847_;
                                                    let _e4377 = phi_2848_;
                                                    phi_2849_ = _e4375;
                                                    phi_2850_ = _e4377;
                                                }
                                                let _e4379 = phi_2849_;
                                                let _e4381 = phi_2850_;
                                                phi_2851_ = _e4379;
                                                phi_2852_ = _e4364;
                                                phi_2853_ = _e4381;
                                            } else {
                                                phi_2851_ = f32();
                                                phi_2852_ = true;
                                                phi_2853_ = false;
                                            }
                                            let _e4383 = phi_2851_;
                                            let _e4385 = phi_2852_;
                                            let _e4387 = phi_2853_;
                                            if _e4385 {
                                                phi_2857_ = 2f;
                                                phi_2858_ = true;
                                            } else {
                                                phi_2857_ = _e3768;
                                                phi_2858_ = _e4387;
                                            }
                                            let _e4389 = phi_2857_;
                                            let _e4391 = phi_2858_;
                                            if _e4391 {
                                                phi_2862_ = _e4389;
                                            } else {
                                                phi_2862_ = _e4383;
                                            }
                                            let _e4393 = phi_2862_;
                                            let _e4396 = local_9.member[1u];
                                            let _e4399 = local_9.member_1[1u];
                                            let _e4402 = local_9.member_2[1u];
                                            if (_e4396 > _e4402) {
                                                if (_e4399 > _e4402) {
                                                    phi_2894_ = false;
                                                } else {
                                                    phi_2894_ = true;
                                                }
                                                let _e4406 = phi_2894_;
                                                phi_2895_ = _e4406;
                                            } else {
                                                phi_2895_ = true;
                                            }
                                            let _e4408 = phi_2895_;
                                            if _e4408 {
                                                let _e4409 = (_e4399 >= _e4396);
                                                if _e4409 {
                                                    phi_2917_ = f32();
                                                    phi_2918_ = false;
                                                } else {
                                                    if ((_e4396 - _e4399) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2915_ = (((_e4396 - _e4402) / (_e4396 - _e4399)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2916_ = false;
                                                    } else {
                                                        phi_2915_ = f32();
                                                        phi_2916_ = true;
                                                    }
                                                    let _e4420 = phi_2915_;
                                                    let _e4422 = phi_2916_;
                                                    phi_2917_ = _e4420;
                                                    phi_2918_ = _e4422;
                                                }
                                                let _e4424 = phi_2917_;
                                                let _e4426 = phi_2918_;
                                                phi_2919_ = _e4424;
                                                phi_2920_ = _e4409;
                                                phi_2921_ = _e4426;
                                            } else {
                                                phi_2919_ = f32();
                                                phi_2920_ = true;
                                                phi_2921_ = false;
                                            }
                                            let _e4428 = phi_2919_;
                                            let _e4430 = phi_2920_;
                                            let _e4432 = phi_2921_;
                                            if _e4430 {
                                                phi_2925_ = 2f;
                                                phi_2926_ = true;
                                            } else {
                                                phi_2925_ = _e3768;
                                                phi_2926_ = _e4432;
                                            }
                                            let _e4434 = phi_2925_;
                                            let _e4436 = phi_2926_;
                                            if _e4436 {
                                                phi_2930_ = _e4434;
                                            } else {
                                                phi_2930_ = _e4428;
                                            }
                                            let _e4438 = phi_2930_;
                                            if (_e4393 < _e4438) {
                                                phi_2935_ = _e4393;
                                            } else {
                                                phi_2935_ = _e4438;
                                            }
                                            let _e4441 = phi_2935_;
                                            let _e4444 = local_9.member[2u];
                                            let _e4447 = local_9.member_1[2u];
                                            let _e4450 = local_9.member_2[2u];
                                            if (_e4444 > _e4450) {
                                                if (_e4447 > _e4450) {
                                                    phi_2967_ = false;
                                                } else {
                                                    phi_2967_ = true;
                                                }
                                                let _e4454 = phi_2967_;
                                                phi_2968_ = _e4454;
                                            } else {
                                                phi_2968_ = true;
                                            }
                                            let _e4456 = phi_2968_;
                                            if _e4456 {
                                                let _e4457 = (_e4447 >= _e4444);
                                                if _e4457 {
                                                    phi_2990_ = f32();
                                                    phi_2991_ = false;
                                                } else {
                                                    if ((_e4444 - _e4447) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2988_ = (((_e4444 - _e4450) / (_e4444 - _e4447)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2989_ = false;
                                                    } else {
                                                        phi_2988_ = f32();
                                                        phi_2989_ = true;
                                                    }
                                                    let _e4468 = phi_2988_;
                                                    let _e4470 = phi_2989_;
                                                    phi_2990_ = _e4468;
                                                    phi_2991_ = _e4470;
                                                }
                                                let _e4472 = phi_2990_;
                                                let _e4474 = phi_2991_;
                                                phi_2992_ = _e4472;
                                                phi_2993_ = _e4457;
                                                phi_2994_ = _e4474;
                                            } else {
                                                phi_2992_ = f32();
                                                phi_2993_ = true;
                                                phi_2994_ = false;
                                            }
                                            let _e4476 = phi_2992_;
                                            let _e4478 = phi_2993_;
                                            let _e4480 = phi_2994_;
                                            if _e4478 {
                                                phi_2998_ = 2f;
                                                phi_2999_ = true;
                                            } else {
                                                phi_2998_ = _e3768;
                                                phi_2999_ = _e4480;
                                            }
                                            let _e4482 = phi_2998_;
                                            let _e4484 = phi_2999_;
                                            if _e4484 {
                                                phi_3003_ = _e4482;
                                            } else {
                                                phi_3003_ = _e4476;
                                            }
                                            let _e4486 = phi_3003_;
                                            let _e4489 = local_9.member[3u];
                                            let _e4492 = local_9.member_1[3u];
                                            let _e4495 = local_9.member_2[3u];
                                            if (_e4489 > _e4495) {
                                                if (_e4492 > _e4495) {
                                                    phi_3035_ = false;
                                                } else {
                                                    phi_3035_ = true;
                                                }
                                                let _e4499 = phi_3035_;
                                                phi_3036_ = _e4499;
                                            } else {
                                                phi_3036_ = true;
                                            }
                                            let _e4501 = phi_3036_;
                                            if _e4501 {
                                                let _e4502 = (_e4492 >= _e4489);
                                                if _e4502 {
                                                    phi_3058_ = f32();
                                                    phi_3059_ = false;
                                                } else {
                                                    if ((_e4489 - _e4492) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3056_ = (((_e4489 - _e4495) / (_e4489 - _e4492)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3057_ = false;
                                                    } else {
                                                        phi_3056_ = f32();
                                                        phi_3057_ = true;
                                                    }
                                                    let _e4513 = phi_3056_;
                                                    let _e4515 = phi_3057_;
                                                    phi_3058_ = _e4513;
                                                    phi_3059_ = _e4515;
                                                }
                                                let _e4517 = phi_3058_;
                                                let _e4519 = phi_3059_;
                                                phi_3060_ = _e4517;
                                                phi_3061_ = _e4502;
                                                phi_3062_ = _e4519;
                                            } else {
                                                phi_3060_ = f32();
                                                phi_3061_ = true;
                                                phi_3062_ = false;
                                            }
                                            let _e4521 = phi_3060_;
                                            let _e4523 = phi_3061_;
                                            let _e4525 = phi_3062_;
                                            if _e4523 {
                                                phi_3066_ = 2f;
                                                phi_3067_ = true;
                                            } else {
                                                phi_3066_ = _e3768;
                                                phi_3067_ = _e4525;
                                            }
                                            let _e4527 = phi_3066_;
                                            let _e4529 = phi_3067_;
                                            if _e4529 {
                                                phi_3071_ = _e4527;
                                            } else {
                                                phi_3071_ = _e4521;
                                            }
                                            let _e4531 = phi_3071_;
                                            if (_e4486 < _e4531) {
                                                phi_3076_ = _e4486;
                                            } else {
                                                phi_3076_ = _e4531;
                                            }
                                            let _e4534 = phi_3076_;
                                            if (_e4441 < _e4534) {
                                                phi_3081_ = _e4441;
                                            } else {
                                                phi_3081_ = _e4534;
                                            }
                                            let _e4537 = phi_3081_;
                                            if (_e4537 > _e3768) {
                                                phi_3086_ = _e4537;
                                            } else {
                                                phi_3086_ = _e3768;
                                            }
                                            let _e4540 = phi_3086_;
                                            let _e4541 = (_e4540 > 1f);
                                            if _e4541 {
                                                phi_3097_ = f32();
                                                phi_3098_ = false;
                                            } else {
                                                if _e3774 {
                                                    phi_3096_ = (_e4088 + _e4088);
                                                } else {
                                                    phi_3096_ = (1f - _e3768);
                                                }
                                                let _e4545 = phi_3096_;
                                                phi_3097_ = _e4545;
                                                phi_3098_ = true;
                                            }
                                            let _e4547 = phi_3097_;
                                            let _e4549 = phi_3098_;
                                            phi_3099_ = _e4540;
                                            phi_3100_ = _e4547;
                                            phi_3101_ = _e4549;
                                            phi_3102_ = _e4541;
                                            phi_3103_ = false;
                                        } else {
                                            phi_3099_ = f32();
                                            phi_3100_ = f32();
                                            phi_3101_ = false;
                                            phi_3102_ = false;
                                            phi_3103_ = true;
                                        }
                                        let _e4551 = phi_3099_;
                                        let _e4553 = phi_3100_;
                                        let _e4555 = phi_3101_;
                                        let _e4557 = phi_3102_;
                                        let _e4559 = phi_3103_;
                                        phi_3104_ = _e4551;
                                        phi_3105_ = _e4553;
                                        phi_3106_ = false;
                                        phi_3107_ = _e4555;
                                        phi_3108_ = _e4557;
                                        phi_3109_ = _e4559;
                                    } else {
                                        phi_3104_ = f32();
                                        phi_3105_ = f32();
                                        phi_3106_ = true;
                                        phi_3107_ = false;
                                        phi_3108_ = false;
                                        phi_3109_ = false;
                                    }
                                    let _e4561 = phi_3104_;
                                    let _e4563 = phi_3105_;
                                    let _e4565 = phi_3106_;
                                    let _e4567 = phi_3107_;
                                    let _e4569 = phi_3108_;
                                    let _e4571 = phi_3109_;
                                    phi_3110_ = _e4561;
                                    phi_3111_ = _e4563;
                                    phi_3112_ = _e4565;
                                    phi_3113_ = _e4567;
                                    phi_3114_ = _e4569;
                                    phi_3115_ = _e4571;
                                } else {
                                    phi_3110_ = f32();
                                    phi_3111_ = f32();
                                    phi_3112_ = true;
                                    phi_3113_ = false;
                                    phi_3114_ = false;
                                    phi_3115_ = false;
                                }
                                let _e4573 = phi_3110_;
                                let _e4575 = phi_3111_;
                                let _e4577 = phi_3112_;
                                let _e4579 = phi_3113_;
                                let _e4581 = phi_3114_;
                                let _e4583 = phi_3115_;
                                if _e4577 {
                                    if (_e3768 <= _e3770) {
                                        let _e4744 = (_e3776 + 1u);
                                        let _e4745 = (_e4744 > 3u);
                                        if _e4745 {
                                            phi_3128_ = false;
                                        } else {
                                            phi_3128_ = true;
                                        }
                                        let _e4747 = phi_3128_;
                                        phi_3450_ = _e4744;
                                        phi_3451_ = f32();
                                        phi_3452_ = false;
                                        phi_3453_ = _e4747;
                                        phi_3454_ = _e4745;
                                    } else {
                                        let _e4587 = local_9.member[0u];
                                        let _e4590 = local_9.member_1[0u];
                                        let _e4593 = local_9.member[0u];
                                        let _e4599 = local_9.member_2[0u];
                                        let _e4600 = ((_e4587 + ((_e4590 - _e4593) * _e3772)) - _e4599);
                                        let _e4603 = local_9.member[1u];
                                        let _e4606 = local_9.member_1[1u];
                                        let _e4609 = local_9.member[1u];
                                        let _e4615 = local_9.member_2[1u];
                                        let _e4616 = ((_e4603 + ((_e4606 - _e4609) * _e3772)) - _e4615);
                                        if (_e4600 < _e4616) {
                                            phi_3201_ = _e4600;
                                        } else {
                                            phi_3201_ = _e4616;
                                        }
                                        let _e4619 = phi_3201_;
                                        let _e4622 = local_9.member[2u];
                                        let _e4625 = local_9.member_1[2u];
                                        let _e4628 = local_9.member[2u];
                                        let _e4634 = local_9.member_2[2u];
                                        let _e4635 = ((_e4622 + ((_e4625 - _e4628) * _e3772)) - _e4634);
                                        let _e4638 = local_9.member[3u];
                                        let _e4641 = local_9.member_1[3u];
                                        let _e4644 = local_9.member[3u];
                                        let _e4650 = local_9.member_2[3u];
                                        let _e4651 = ((_e4638 + ((_e4641 - _e4644) * _e3772)) - _e4650);
                                        if (_e4635 < _e4651) {
                                            phi_3274_ = _e4635;
                                        } else {
                                            phi_3274_ = _e4651;
                                        }
                                        let _e4654 = phi_3274_;
                                        if (_e4619 < _e4654) {
                                            phi_3279_ = _e4619;
                                        } else {
                                            phi_3279_ = _e4654;
                                        }
                                        let _e4657 = phi_3279_;
                                        let _e4660 = local_10.member[0u];
                                        let _e4663 = local_10.member_1[0u];
                                        let _e4666 = local_10.member[0u];
                                        let _e4672 = local_10.member_2[0u];
                                        let _e4673 = ((_e4660 + ((_e4663 - _e4666) * _e3768)) - _e4672);
                                        let _e4676 = local_10.member[1u];
                                        let _e4679 = local_10.member_1[1u];
                                        let _e4682 = local_10.member[1u];
                                        let _e4688 = local_10.member_2[1u];
                                        let _e4689 = ((_e4676 + ((_e4679 - _e4682) * _e3768)) - _e4688);
                                        if (_e4673 < _e4689) {
                                            phi_3352_ = _e4673;
                                        } else {
                                            phi_3352_ = _e4689;
                                        }
                                        let _e4692 = phi_3352_;
                                        let _e4695 = local_10.member[2u];
                                        let _e4698 = local_10.member_1[2u];
                                        let _e4701 = local_10.member[2u];
                                        let _e4707 = local_10.member_2[2u];
                                        let _e4708 = ((_e4695 + ((_e4698 - _e4701) * _e3768)) - _e4707);
                                        let _e4711 = local_10.member[3u];
                                        let _e4714 = local_10.member_1[3u];
                                        let _e4717 = local_10.member[3u];
                                        let _e4723 = local_10.member_2[3u];
                                        let _e4724 = ((_e4711 + ((_e4714 - _e4717) * _e3768)) - _e4723);
                                        if (_e4708 < _e4724) {
                                            phi_3425_ = _e4708;
                                        } else {
                                            phi_3425_ = _e4724;
                                        }
                                        let _e4727 = phi_3425_;
                                        if (_e4692 < _e4727) {
                                            phi_3430_ = _e4692;
                                        } else {
                                            phi_3430_ = _e4727;
                                        }
                                        let _e4730 = phi_3430_;
                                        if (_e4730 > 0f) {
                                            phi_3448_ = 0.5f;
                                        } else {
                                            let _e4734 = (0.95f * (_e4657 / (_e4657 - _e4730)));
                                            if (_e4734 > 0.0625f) {
                                                if (_e4734 < 0.9f) {
                                                    phi_3446_ = _e4734;
                                                } else {
                                                    phi_3446_ = 0.9f;
                                                }
                                                let _e4738 = phi_3446_;
                                                phi_3447_ = _e4738;
                                            } else {
                                                phi_3447_ = 0.0625f;
                                            }
                                            let _e4740 = phi_3447_;
                                            phi_3448_ = _e4740;
                                        }
                                        let _e4742 = phi_3448_;
                                        phi_3450_ = u32();
                                        phi_3451_ = (_e4088 * _e4742);
                                        phi_3452_ = true;
                                        phi_3453_ = false;
                                        phi_3454_ = false;
                                    }
                                    let _e4749 = phi_3450_;
                                    let _e4751 = phi_3451_;
                                    let _e4753 = phi_3452_;
                                    let _e4755 = phi_3453_;
                                    let _e4757 = phi_3454_;
                                    phi_3455_ = _e4749;
                                    phi_3456_ = _e3770;
                                    phi_3457_ = _e4751;
                                    phi_3458_ = _e3772;
                                    phi_3459_ = _e3774;
                                    phi_3460_ = _e3776;
                                    phi_3461_ = _e4753;
                                    phi_3462_ = _e4755;
                                    phi_3463_ = _e4757;
                                    phi_3464_ = false;
                                    phi_3465_ = false;
                                } else {
                                    phi_3455_ = u32();
                                    phi_3456_ = _e4573;
                                    phi_3457_ = _e4575;
                                    phi_3458_ = _e3768;
                                    phi_3459_ = true;
                                    phi_3460_ = 0u;
                                    phi_3461_ = _e4579;
                                    phi_3462_ = false;
                                    phi_3463_ = false;
                                    phi_3464_ = _e4581;
                                    phi_3465_ = _e4583;
                                }
                                let _e4759 = phi_3455_;
                                let _e4761 = phi_3456_;
                                let _e4763 = phi_3457_;
                                let _e4765 = phi_3458_;
                                let _e4767 = phi_3459_;
                                let _e4769 = phi_3460_;
                                let _e4771 = phi_3461_;
                                let _e4773 = phi_3462_;
                                let _e4775 = phi_3463_;
                                let _e4777 = phi_3464_;
                                let _e4779 = phi_3465_;
                                if _e4771 {
                                    let _e4780 = (_e4765 + _e4763);
                                    if (_e4780 > _e4761) {
                                        phi_3474_ = _e4780;
                                    } else {
                                        phi_3474_ = _e4761;
                                    }
                                    let _e4783 = phi_3474_;
                                    if (_e4783 < 1f) {
                                        phi_3479_ = _e4783;
                                    } else {
                                        phi_3479_ = 1f;
                                    }
                                    let _e4786 = phi_3479_;
                                    if !(_e3774) {
                                        phi_3488_ = true;
                                    } else {
                                        phi_3488_ = ((_e4786 - _e4765) > 0.0000000037252903f);
                                    }
                                    let _e4790 = phi_3488_;
                                    if _e4790 {
                                        phi_3492_ = false;
                                    } else {
                                        phi_3492_ = true;
                                    }
                                    let _e4792 = phi_3492_;
                                    phi_3493_ = _e4786;
                                    phi_3494_ = _e4761;
                                    phi_3495_ = _e4765;
                                    phi_3496_ = _e4767;
                                    phi_3497_ = _e4769;
                                    phi_3498_ = _e4790;
                                    phi_3499_ = _e4792;
                                    phi_3500_ = false;
                                    phi_3501_ = false;
                                    phi_3502_ = false;
                                } else {
                                    phi_3493_ = _e3768;
                                    phi_3494_ = _e3770;
                                    phi_3495_ = _e3772;
                                    phi_3496_ = _e3774;
                                    phi_3497_ = _e4759;
                                    phi_3498_ = _e4773;
                                    phi_3499_ = false;
                                    phi_3500_ = _e4775;
                                    phi_3501_ = _e4777;
                                    phi_3502_ = _e4779;
                                }
                                let _e4794 = phi_3493_;
                                let _e4796 = phi_3494_;
                                let _e4798 = phi_3495_;
                                let _e4800 = phi_3496_;
                                let _e4802 = phi_3497_;
                                let _e4804 = phi_3498_;
                                let _e4806 = phi_3499_;
                                let _e4808 = phi_3500_;
                                let _e4810 = phi_3501_;
                                let _e4812 = phi_3502_;
                                phi_1835_ = _e4794;
                                phi_1837_ = _e4796;
                                phi_1839_ = _e4798;
                                phi_1841_ = _e4800;
                                phi_1843_ = _e4802;
                                phi_3503_ = _e4761;
                                phi_3504_ = _e4804;
                                phi_3505_ = _e4806;
                                phi_3506_ = false;
                                phi_3507_ = _e4808;
                                phi_3508_ = _e4810;
                                phi_3509_ = _e4812;
                            } else {
                                phi_1835_ = f32();
                                phi_1837_ = f32();
                                phi_1839_ = f32();
                                phi_1841_ = bool();
                                phi_1843_ = u32();
                                phi_3503_ = f32();
                                phi_3504_ = false;
                                phi_3505_ = false;
                                phi_3506_ = true;
                                phi_3507_ = false;
                                phi_3508_ = false;
                                phi_3509_ = false;
                            }
                            let _e4814 = phi_1835_;
                            let _e4816 = phi_1837_;
                            let _e4818 = phi_1839_;
                            let _e4820 = phi_1841_;
                            let _e4822 = phi_1843_;
                            let _e4824 = phi_3503_;
                            let _e4826 = phi_3504_;
                            let _e4828 = phi_3505_;
                            let _e4830 = phi_3506_;
                            let _e4832 = phi_3507_;
                            let _e4834 = phi_3508_;
                            let _e4836 = phi_3509_;
                            local_25 = _e4828;
                            local_43 = _e4824;
                            local_45 = _e4830;
                            local_46 = _e4832;
                            local_47 = _e4834;
                            local_48 = _e4836;
                            continue;
                            continuing {
                                phi_1831_ = _e3788;
                                phi_1834_ = _e4814;
                                phi_1836_ = _e4816;
                                phi_1838_ = _e4818;
                                phi_1840_ = _e4820;
                                phi_1842_ = _e4822;
                                break if !(_e4826);
                            }
                        }
                        let _e4839 = local_25;
                        if _e4839 {
                            let _e6192 = local_43;
                            phi_3513_ = _e6192;
                            phi_3514_ = true;
                            phi_3515_ = false;
                            phi_3516_ = false;
                            phi_3517_ = false;
                        } else {
                            let _e6194 = local_44;
                            phi_3513_ = _e6194;
                            let _e6197 = local_45;
                            phi_3514_ = _e6197;
                            let _e6200 = local_46;
                            phi_3515_ = _e6200;
                            let _e6203 = local_47;
                            phi_3516_ = _e6203;
                            let _e6206 = local_48;
                            phi_3517_ = _e6206;
                        }
                        let _e4841 = phi_3513_;
                        let _e4843 = phi_3514_;
                        let _e4845 = phi_3515_;
                        let _e4847 = phi_3516_;
                        let _e4849 = phi_3517_;
                        if _e4843 {
                            phi_3522_ = type_35(1u, _e4841);
                            phi_3523_ = false;
                            phi_3524_ = false;
                            phi_3525_ = false;
                        } else {
                            phi_3522_ = type_35();
                            phi_3523_ = _e4845;
                            phi_3524_ = _e4847;
                            phi_3525_ = _e4849;
                        }
                        let _e4852 = phi_3522_;
                        let _e4854 = phi_3523_;
                        let _e4856 = phi_3524_;
                        let _e4858 = phi_3525_;
                        if _e4854 {
                            let _e4860 = local_26;
                            phi_3530_ = type_35(1u, _e4860);
                            phi_3531_ = false;
                            phi_3532_ = false;
                        } else {
                            phi_3530_ = type_35();
                            phi_3531_ = _e4856;
                            phi_3532_ = _e4858;
                        }
                        let _e4863 = phi_3530_;
                        let _e4865 = phi_3531_;
                        let _e4867 = phi_3532_;
                        if _e4865 {
                            phi_3537_ = type_35(0u, type_35().member_1);
                            phi_3538_ = false;
                            phi_3539_ = true;
                        } else {
                            phi_3537_ = _e4863;
                            phi_3538_ = _e4867;
                            phi_3539_ = _e4854;
                        }
                        let _e4871 = phi_3537_;
                        let _e4873 = phi_3538_;
                        let _e4875 = phi_3539_;
                        if _e4873 {
                            phi_3544_ = type_35(0u, type_35().member_1);
                            phi_3545_ = true;
                        } else {
                            phi_3544_ = _e4871;
                            phi_3545_ = _e4875;
                        }
                        let _e4879 = phi_3544_;
                        let _e4881 = phi_3545_;
                        if _e4881 {
                            phi_3549_ = _e4879;
                        } else {
                            phi_3549_ = _e4852;
                        }
                        let _e4883 = phi_3549_;
                        if (_e4883.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_3563_ = type_9(0u, 3u);
                            loop {
                                let _e4895 = phi_3563_;
                                if (_e4895.member < _e4895.member_1) {
                                    phi_3564_ = type_9((_e4895.member + 1u), _e4895.member_1);
                                    phi_3587_ = type_9(1u, _e4895.member);
                                } else {
                                    phi_3564_ = _e4895;
                                    phi_3587_ = type_9(0u, type_9().member_1);
                                }
                                let _e4907 = phi_3564_;
                                let _e4909 = phi_3587_;
                                if (bitcast<i32>(_e4909.member) != 0i) {
                                    let _e4915 = local_11[_e4909.member_1];
                                    let _e4916 = (_e4883.member_1 + _e4915);
                                    if (_e4916 < 1f) {
                                        phi_3607_ = _e4916;
                                    } else {
                                        phi_3607_ = 1f;
                                    }
                                    let _e4919 = phi_3607_;
                                    let _e4922 = local_12.member[0u];
                                    let _e4928 = local_12.member[1u];
                                    let _e4944 = local_12.member_1[0u];
                                    let _e4950 = local_12.member_1[1u];
                                    let _e4966 = local_12.member_2[0u];
                                    let _e4972 = local_12.member_2[1u];
                                    let _e4986 = function_2(array<f32, 3>((_e4922[0] + ((_e4928[0] - _e4922[0]) * _e4919)), (_e4922[1] + ((_e4928[1] - _e4922[1]) * _e4919)), (_e4922[2] + ((_e4928[2] - _e4922[2]) * _e4919))), array<f32, 3>((_e4944[0] + ((_e4950[0] - _e4944[0]) * _e4919)), (_e4944[1] + ((_e4950[1] - _e4944[1]) * _e4919)), (_e4944[2] + ((_e4950[2] - _e4944[2]) * _e4919))), array<f32, 3>((_e4966[0] + ((_e4972[0] - _e4966[0]) * _e4919)), (_e4966[1] + ((_e4972[1] - _e4966[1]) * _e4919)), (_e4966[2] + ((_e4972[2] - _e4966[2]) * _e4919))), 1u);
                                    let _e4997 = (((_e4986[0] * _e4986[0]) + (_e4986[1] * _e4986[1])) + (_e4986[2] * _e4986[2]));
                                    if (_e4997 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4997 > 0f) {
                                            phi_3730_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3730_ = 0f;
                                        }
                                        let _e5050 = phi_3730_;
                                        phi_3794_ = _e5050;
                                    } else {
                                        phi_3737_ = type_14(0i, 5i);
                                        phi_3740_ = bitcast<f32>(((bitcast<u32>(_e4997) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e5005 = phi_3737_;
                                            let _e5007 = phi_3740_;
                                            local_27 = _e5007;
                                            if (_e5005.member < _e5005.member_1) {
                                                let _e5014 = (_e5005.member + 1i);
                                                if ((false == (_e5014 > _e5005.member)) != false) {
                                                    phi_3761_ = true;
                                                } else {
                                                    phi_3761_ = false;
                                                }
                                                let _e5019 = phi_3761_;
                                                if _e5019 {
                                                    phi_3767_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3767_ = type_15(1u, _e5014);
                                                }
                                                let _e5024 = phi_3767_;
                                                phi_3738_ = type_14(_e5024.member_1, _e5005.member_1);
                                                phi_3781_ = type_15(1u, _e5005.member);
                                            } else {
                                                phi_3738_ = _e5005;
                                                phi_3781_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e5030 = phi_3738_;
                                            let _e5032 = phi_3781_;
                                            let _e5035 = (bitcast<i32>(_e5032.member) != 0i);
                                            if _e5035 {
                                                phi_3741_ = (0.5f * (_e5007 + (_e4997 / _e5007)));
                                            } else {
                                                phi_3741_ = f32();
                                            }
                                            let _e5040 = phi_3741_;
                                            continue;
                                            continuing {
                                                phi_3737_ = _e5030;
                                                phi_3740_ = _e5040;
                                                break if !(_e5035);
                                            }
                                        }
                                        let _e5045 = local_27;
                                        phi_3794_ = (_e5045 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e5052 = phi_3794_;
                                    let _e5058 = local_12.member[0u];
                                    if (_e5058[0] < 0f) {
                                        phi_3810_ = -(_e5058[0]);
                                    } else {
                                        phi_3810_ = _e5058[0];
                                    }
                                    let _e5065 = phi_3810_;
                                    if (_e5058[1] < 0f) {
                                        phi_3817_ = -(_e5058[1]);
                                    } else {
                                        phi_3817_ = _e5058[1];
                                    }
                                    let _e5069 = phi_3817_;
                                    if (_e5065 > _e5069) {
                                        phi_3822_ = _e5065;
                                    } else {
                                        phi_3822_ = _e5069;
                                    }
                                    let _e5072 = phi_3822_;
                                    if (_e5058[2] < 0f) {
                                        phi_3829_ = -(_e5058[2]);
                                    } else {
                                        phi_3829_ = _e5058[2];
                                    }
                                    let _e5076 = phi_3829_;
                                    if (_e5072 > _e5076) {
                                        phi_3834_ = _e5072;
                                    } else {
                                        phi_3834_ = _e5076;
                                    }
                                    let _e5079 = phi_3834_;
                                    let _e5082 = local_12.member[1u];
                                    if (_e5082[0] < 0f) {
                                        phi_3847_ = -(_e5082[0]);
                                    } else {
                                        phi_3847_ = _e5082[0];
                                    }
                                    let _e5089 = phi_3847_;
                                    if (_e5082[1] < 0f) {
                                        phi_3854_ = -(_e5082[1]);
                                    } else {
                                        phi_3854_ = _e5082[1];
                                    }
                                    let _e5093 = phi_3854_;
                                    if (_e5089 > _e5093) {
                                        phi_3859_ = _e5089;
                                    } else {
                                        phi_3859_ = _e5093;
                                    }
                                    let _e5096 = phi_3859_;
                                    if (_e5082[2] < 0f) {
                                        phi_3866_ = -(_e5082[2]);
                                    } else {
                                        phi_3866_ = _e5082[2];
                                    }
                                    let _e5100 = phi_3866_;
                                    if (_e5096 > _e5100) {
                                        phi_3871_ = _e5096;
                                    } else {
                                        phi_3871_ = _e5100;
                                    }
                                    let _e5103 = phi_3871_;
                                    if (_e5079 > _e5103) {
                                        phi_3876_ = _e5079;
                                    } else {
                                        phi_3876_ = _e5103;
                                    }
                                    let _e5106 = phi_3876_;
                                    let _e5108 = local_12.member_3;
                                    let _e5112 = local_12.member_1[0u];
                                    if (_e5112[0] < 0f) {
                                        phi_3893_ = -(_e5112[0]);
                                    } else {
                                        phi_3893_ = _e5112[0];
                                    }
                                    let _e5119 = phi_3893_;
                                    if (_e5112[1] < 0f) {
                                        phi_3900_ = -(_e5112[1]);
                                    } else {
                                        phi_3900_ = _e5112[1];
                                    }
                                    let _e5123 = phi_3900_;
                                    if (_e5119 > _e5123) {
                                        phi_3905_ = _e5119;
                                    } else {
                                        phi_3905_ = _e5123;
                                    }
                                    let _e5126 = phi_3905_;
                                    if (_e5112[2] < 0f) {
                                        phi_3912_ = -(_e5112[2]);
                                    } else {
                                        phi_3912_ = _e5112[2];
                                    }
                                    let _e5130 = phi_3912_;
                                    if (_e5126 > _e5130) {
                                        phi_3917_ = _e5126;
                                    } else {
                                        phi_3917_ = _e5130;
                                    }
                                    let _e5133 = phi_3917_;
                                    let _e5136 = local_12.member_1[1u];
                                    if (_e5136[0] < 0f) {
                                        phi_3931_ = -(_e5136[0]);
                                    } else {
                                        phi_3931_ = _e5136[0];
                                    }
                                    let _e5143 = phi_3931_;
                                    if (_e5136[1] < 0f) {
                                        phi_3938_ = -(_e5136[1]);
                                    } else {
                                        phi_3938_ = _e5136[1];
                                    }
                                    let _e5147 = phi_3938_;
                                    if (_e5143 > _e5147) {
                                        phi_3943_ = _e5143;
                                    } else {
                                        phi_3943_ = _e5147;
                                    }
                                    let _e5150 = phi_3943_;
                                    if (_e5136[2] < 0f) {
                                        phi_3950_ = -(_e5136[2]);
                                    } else {
                                        phi_3950_ = _e5136[2];
                                    }
                                    let _e5154 = phi_3950_;
                                    if (_e5150 > _e5154) {
                                        phi_3955_ = _e5150;
                                    } else {
                                        phi_3955_ = _e5154;
                                    }
                                    let _e5157 = phi_3955_;
                                    if (_e5133 > _e5157) {
                                        phi_3960_ = _e5133;
                                    } else {
                                        phi_3960_ = _e5157;
                                    }
                                    let _e5160 = phi_3960_;
                                    let _e5162 = local_12.member_3;
                                    let _e5166 = local_12.member_2[0u];
                                    if (_e5166[0] < 0f) {
                                        phi_3977_ = -(_e5166[0]);
                                    } else {
                                        phi_3977_ = _e5166[0];
                                    }
                                    let _e5173 = phi_3977_;
                                    if (_e5166[1] < 0f) {
                                        phi_3984_ = -(_e5166[1]);
                                    } else {
                                        phi_3984_ = _e5166[1];
                                    }
                                    let _e5177 = phi_3984_;
                                    if (_e5173 > _e5177) {
                                        phi_3989_ = _e5173;
                                    } else {
                                        phi_3989_ = _e5177;
                                    }
                                    let _e5180 = phi_3989_;
                                    if (_e5166[2] < 0f) {
                                        phi_3996_ = -(_e5166[2]);
                                    } else {
                                        phi_3996_ = _e5166[2];
                                    }
                                    let _e5184 = phi_3996_;
                                    if (_e5180 > _e5184) {
                                        phi_4001_ = _e5180;
                                    } else {
                                        phi_4001_ = _e5184;
                                    }
                                    let _e5187 = phi_4001_;
                                    let _e5190 = local_12.member_2[1u];
                                    if (_e5190[0] < 0f) {
                                        phi_4015_ = -(_e5190[0]);
                                    } else {
                                        phi_4015_ = _e5190[0];
                                    }
                                    let _e5197 = phi_4015_;
                                    if (_e5190[1] < 0f) {
                                        phi_4022_ = -(_e5190[1]);
                                    } else {
                                        phi_4022_ = _e5190[1];
                                    }
                                    let _e5201 = phi_4022_;
                                    if (_e5197 > _e5201) {
                                        phi_4027_ = _e5197;
                                    } else {
                                        phi_4027_ = _e5201;
                                    }
                                    let _e5204 = phi_4027_;
                                    if (_e5190[2] < 0f) {
                                        phi_4034_ = -(_e5190[2]);
                                    } else {
                                        phi_4034_ = _e5190[2];
                                    }
                                    let _e5208 = phi_4034_;
                                    if (_e5204 > _e5208) {
                                        phi_4039_ = _e5204;
                                    } else {
                                        phi_4039_ = _e5208;
                                    }
                                    let _e5211 = phi_4039_;
                                    if (_e5187 > _e5211) {
                                        phi_4044_ = _e5187;
                                    } else {
                                        phi_4044_ = _e5211;
                                    }
                                    let _e5214 = phi_4044_;
                                    let _e5216 = local_12.member_3;
                                    let _e5223 = local_12.member_3;
                                    let _e5230 = (((_e5052 * (1f + (0.000000059604645f * 8f))) + (((((((_e5106 + _e5108) + (_e5160 + _e5162)) + (_e5214 + _e5216)) * (0.000000059604645f * 16f)) + (_e5223 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e455.member_1);
                                    if _e5230 {
                                        phi_4064_ = false;
                                    } else {
                                        phi_4064_ = true;
                                    }
                                    let _e5232 = phi_4064_;
                                    phi_4065_ = _e5232;
                                    phi_4066_ = _e5230;
                                } else {
                                    phi_4065_ = false;
                                    phi_4066_ = false;
                                }
                                let _e5234 = phi_4065_;
                                let _e5236 = phi_4066_;
                                local_28 = _e5236;
                                continue;
                                continuing {
                                    phi_3563_ = _e4907;
                                    break if !(_e5234);
                                }
                            }
                            let _e5239 = local_28;
                            if _e5239 {
                                phi_4071_ = type_35(1u, _e4883.member_1);
                                phi_4072_ = false;
                            } else {
                                phi_4071_ = type_35();
                                phi_4072_ = true;
                            }
                            let _e5242 = phi_4071_;
                            let _e5244 = phi_4072_;
                            if _e5244 {
                                phi_4077_ = type_35(2u, _e4883.member_1);
                                phi_4078_ = false;
                            } else {
                                phi_4077_ = type_35();
                                phi_4078_ = true;
                            }
                            let _e5247 = phi_4077_;
                            let _e5249 = phi_4078_;
                            phi_4080_ = _e5247;
                            phi_4081_ = _e5242;
                            phi_4082_ = _e5249;
                        } else {
                            phi_4080_ = type_35();
                            phi_4081_ = type_35(0u, type_35().member_1);
                            phi_4082_ = true;
                        }
                        let _e5251 = phi_4080_;
                        let _e5253 = phi_4081_;
                        let _e5255 = phi_4082_;
                        if _e5255 {
                            phi_4086_ = _e5253;
                        } else {
                            phi_4086_ = _e5251;
                        }
                        let _e5257 = phi_4086_;
                        phi_8010_ = _e5257;
                    } else {
                        if (_e593 < 0f) {
                            phi_4096_ = -(_e593);
                        } else {
                            phi_4096_ = _e593;
                        }
                        let _e936 = phi_4096_;
                        if (_e616 < 0f) {
                            phi_4102_ = -(_e616);
                        } else {
                            phi_4102_ = _e616;
                        }
                        let _e940 = phi_4102_;
                        if (_e936 > _e940) {
                            phi_4107_ = _e936;
                        } else {
                            phi_4107_ = _e940;
                        }
                        let _e943 = phi_4107_;
                        if (_e639 < 0f) {
                            phi_4113_ = -(_e639);
                        } else {
                            phi_4113_ = _e639;
                        }
                        let _e947 = phi_4113_;
                        if (_e650 < 0f) {
                            phi_4119_ = -(_e650);
                        } else {
                            phi_4119_ = _e650;
                        }
                        let _e951 = phi_4119_;
                        if (_e947 > _e951) {
                            phi_4124_ = _e947;
                        } else {
                            phi_4124_ = _e951;
                        }
                        let _e954 = phi_4124_;
                        if (_e943 > _e954) {
                            phi_4129_ = _e943;
                        } else {
                            phi_4129_ = _e954;
                        }
                        let _e957 = phi_4129_;
                        let _e958 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e957 >= _e958) {
                            phi_4137_ = (_e957 <= (1f / _e958));
                        } else {
                            phi_4137_ = false;
                        }
                        let _e963 = phi_4137_;
                        if _e963 {
                            phi_4142_ = (0.000000059604645f * 256f);
                        } else {
                            phi_4142_ = 2f;
                        }
                        let _e966 = phi_4142_;
                        let _e968 = ((_e900 * 0.34f) + (_e957 * _e966));
                        if _e963 {
                            phi_4149_ = (1f / _e957);
                        } else {
                            phi_4149_ = 0f;
                        }
                        let _e971 = phi_4149_;
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
                                    phi_4182_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_4182_ = 0f;
                                }
                                let _e1040 = phi_4182_;
                                phi_4246_ = _e1040;
                            } else {
                                phi_4189_ = type_14(0i, 5i);
                                phi_4192_ = bitcast<f32>(((bitcast<u32>(_e986) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e995 = phi_4189_;
                                    let _e997 = phi_4192_;
                                    local_13 = _e997;
                                    if (_e995.member < _e995.member_1) {
                                        let _e1004 = (_e995.member + 1i);
                                        if ((false == (_e1004 > _e995.member)) != false) {
                                            phi_4213_ = true;
                                        } else {
                                            phi_4213_ = false;
                                        }
                                        let _e1009 = phi_4213_;
                                        if _e1009 {
                                            phi_4219_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_4219_ = type_15(1u, _e1004);
                                        }
                                        let _e1014 = phi_4219_;
                                        phi_4190_ = type_14(_e1014.member_1, _e995.member_1);
                                        phi_4233_ = type_15(1u, _e995.member);
                                    } else {
                                        phi_4190_ = _e995;
                                        phi_4233_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e1020 = phi_4190_;
                                    let _e1022 = phi_4233_;
                                    let _e1025 = (bitcast<i32>(_e1022.member) != 0i);
                                    if _e1025 {
                                        phi_4193_ = (0.5f * (_e997 + (_e986 / _e997)));
                                    } else {
                                        phi_4193_ = f32();
                                    }
                                    let _e1030 = phi_4193_;
                                    continue;
                                    continuing {
                                        phi_4189_ = _e1020;
                                        phi_4192_ = _e1030;
                                        break if !(_e1025);
                                    }
                                }
                                let _e1035 = local_13;
                                phi_4246_ = (_e1035 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1042 = phi_4246_;
                            if (_e978 < 0f) {
                                phi_4252_ = -(_e1042);
                            } else {
                                phi_4252_ = _e1042;
                            }
                            let _e1046 = phi_4252_;
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
                            phi_4277_ = type_9(0u, 2u);
                            phi_4280_ = 1u;
                            loop {
                                let _e1067 = phi_4277_;
                                let _e1069 = phi_4280_;
                                local_29 = _e1069;
                                if (_e1067.member < _e1067.member_1) {
                                    phi_4278_ = type_9((_e1067.member + 1u), _e1067.member_1);
                                    phi_4303_ = type_9(1u, _e1067.member);
                                } else {
                                    phi_4278_ = _e1067;
                                    phi_4303_ = type_9(0u, type_9().member_1);
                                }
                                let _e1081 = phi_4278_;
                                let _e1083 = phi_4303_;
                                let _e1087 = (bitcast<i32>(_e1083.member) != 0i);
                                if _e1087 {
                                    let _e1089 = local_7[_e1083.member_1];
                                    if (_e1089 > 0f) {
                                        let _e1092 = local_7[_e1083.member_1];
                                        if (_e1092 < 1f) {
                                            let _e1095 = local_7[_e1083.member_1];
                                            local_6[_e1069] = _e1095;
                                            phi_4347_ = (_e1069 + 1u);
                                        } else {
                                            phi_4347_ = _e1069;
                                        }
                                        let _e1099 = phi_4347_;
                                        phi_4348_ = _e1099;
                                    } else {
                                        phi_4348_ = _e1069;
                                    }
                                    let _e1101 = phi_4348_;
                                    phi_4281_ = _e1101;
                                } else {
                                    phi_4281_ = u32();
                                }
                                let _e1103 = phi_4281_;
                                continue;
                                continuing {
                                    phi_4277_ = _e1081;
                                    phi_4280_ = _e1103;
                                    break if !(_e1087);
                                }
                            }
                            let _e5517 = local_29;
                            phi_4349_ = _e5517;
                        } else {
                            phi_4349_ = 1u;
                        }
                        let _e1106 = phi_4349_;
                        local_6[_e1106] = 1f;
                        let _e1108 = local_6;
                        local_8 = _e1108;
                        phi_4369_ = type_9(0u, _e1106);
                        loop {
                            let _e1111 = phi_4369_;
                            if (_e1111.member < _e1111.member_1) {
                                phi_4370_ = type_9((_e1111.member + 1u), _e1111.member_1);
                                phi_4393_ = type_9(1u, _e1111.member);
                            } else {
                                phi_4370_ = _e1111;
                                phi_4393_ = type_9(0u, type_9().member_1);
                            }
                            let _e1123 = phi_4370_;
                            let _e1125 = phi_4393_;
                            if (bitcast<i32>(_e1125.member) != 0i) {
                                let _e1131 = local_8[_e1125.member_1];
                                let _e1134 = local_8[(_e1125.member_1 + 1u)];
                                let _e1135 = (1f - _e1131);
                                let _e1146 = ((((_e593 * _e1135) + (_e616 * _e1131)) * (_e1135 * _e1135)) + (((_e639 * _e1135) + (_e650 * _e1131)) * (_e1131 * _e1131)));
                                let _e1147 = (1f - _e1134);
                                let _e1158 = ((((_e593 * _e1147) + (_e616 * _e1134)) * (_e1147 * _e1147)) + (((_e639 * _e1147) + (_e650 * _e1134)) * (_e1134 * _e1134)));
                                if (_e1146 < 0f) {
                                    phi_4445_ = -(_e1146);
                                } else {
                                    phi_4445_ = _e1146;
                                }
                                let _e1162 = phi_4445_;
                                let _e1163 = (_e1162 > _e968);
                                if (_e1158 < 0f) {
                                    phi_4452_ = -(_e1158);
                                } else {
                                    phi_4452_ = _e1158;
                                }
                                let _e1167 = phi_4452_;
                                let _e1168 = (_e1167 > _e968);
                                if _e1163 {
                                    if _e1168 {
                                        phi_4463_ = ((_e1146 > 0f) != (_e1158 > 0f));
                                        phi_4464_ = false;
                                    } else {
                                        phi_4463_ = bool();
                                        phi_4464_ = true;
                                    }
                                    let _e1173 = phi_4463_;
                                    let _e1175 = phi_4464_;
                                    phi_4465_ = _e1173;
                                    phi_4466_ = _e1175;
                                } else {
                                    phi_4465_ = bool();
                                    phi_4466_ = true;
                                }
                                let _e1177 = phi_4465_;
                                let _e1179 = phi_4466_;
                                if _e1179 {
                                    phi_4470_ = false;
                                } else {
                                    phi_4470_ = _e1177;
                                }
                                let _e1181 = phi_4470_;
                                if _e1163 {
                                    if _e1168 {
                                        if _e1181 {
                                            phi_4481_ = type_37();
                                        } else {
                                            phi_4481_ = type_37(1f, 0f, _e1181);
                                        }
                                        let _e1184 = phi_4481_;
                                        phi_4482_ = _e1184;
                                        phi_4483_ = _e1181;
                                    } else {
                                        phi_4482_ = type_37();
                                        phi_4483_ = true;
                                    }
                                    let _e1186 = phi_4482_;
                                    let _e1188 = phi_4483_;
                                    phi_4484_ = _e1186;
                                    phi_4485_ = _e1188;
                                } else {
                                    phi_4484_ = type_37();
                                    phi_4485_ = true;
                                }
                                let _e1190 = phi_4484_;
                                let _e1192 = phi_4485_;
                                if _e1192 {
                                    if _e1163 {
                                        if (_e1146 < 0f) {
                                            phi_4496_ = -1f;
                                        } else {
                                            phi_4496_ = 1f;
                                        }
                                        let _e1195 = phi_4496_;
                                        let _e1198 = (_e639 - _e616);
                                        phi_4506_ = type_9(0u, 64u);
                                        phi_4509_ = _e1134;
                                        phi_4511_ = _e1131;
                                        phi_4513_ = (0.5f * (_e1131 + _e1134));
                                        loop {
                                            let _e1204 = phi_4506_;
                                            let _e1206 = phi_4509_;
                                            let _e1208 = phi_4511_;
                                            let _e1210 = phi_4513_;
                                            local_31 = _e1208;
                                            if (_e1204.member < _e1204.member_1) {
                                                phi_4507_ = type_9((_e1204.member + 1u), _e1204.member_1);
                                                phi_4536_ = type_9(1u, _e1204.member);
                                            } else {
                                                phi_4507_ = _e1204;
                                                phi_4536_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1222 = phi_4507_;
                                            let _e1224 = phi_4536_;
                                            if (bitcast<i32>(_e1224.member) != 0i) {
                                                let _e1228 = (1f - _e1210);
                                                let _e1241 = ((_e1195 * ((((_e593 * _e1228) + (_e616 * _e1210)) * (_e1228 * _e1228)) + (((_e639 * _e1228) + (_e650 * _e1210)) * (_e1210 * _e1210)))) - _e968);
                                                if (_e1241 > 0f) {
                                                    phi_4561_ = _e1206;
                                                    phi_4562_ = _e1210;
                                                } else {
                                                    phi_4561_ = _e1210;
                                                    phi_4562_ = _e1208;
                                                }
                                                let _e1244 = phi_4561_;
                                                let _e1246 = phi_4562_;
                                                let _e1248 = ((_e1244 - _e1246) > 0.00000000000022737368f);
                                                if _e1248 {
                                                    let _e1249 = (1f - _e1210);
                                                    let _e1261 = (-(_e1241) / (_e1195 * (((((_e616 - (3f * _e593)) * _e1249) + (_e1198 * _e1210)) * _e1249) + (((_e1198 * _e1249) + (((3f * _e650) - _e639) * _e1210)) * _e1210))));
                                                    if (_e1241 > 0f) {
                                                        phi_4588_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4588_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1267 = phi_4588_;
                                                    let _e1269 = ((_e1210 + _e1261) + _e1267);
                                                    if (_e1269 > _e1246) {
                                                        if (_e1269 < _e1244) {
                                                            if (_e1261 < 0f) {
                                                                phi_4604_ = -(_e1261);
                                                            } else {
                                                                phi_4604_ = _e1261;
                                                            }
                                                            let _e1275 = phi_4604_;
                                                            if (_e1275 < (0.5f * (_e1244 - _e1246))) {
                                                                phi_4611_ = false;
                                                            } else {
                                                                phi_4611_ = true;
                                                            }
                                                            let _e1280 = phi_4611_;
                                                            phi_4612_ = _e1280;
                                                        } else {
                                                            phi_4612_ = true;
                                                        }
                                                        let _e1282 = phi_4612_;
                                                        phi_4613_ = _e1282;
                                                    } else {
                                                        phi_4613_ = true;
                                                    }
                                                    let _e1284 = phi_4613_;
                                                    if _e1284 {
                                                        phi_4619_ = (0.5f * (_e1246 + _e1244));
                                                    } else {
                                                        phi_4619_ = _e1269;
                                                    }
                                                    let _e1288 = phi_4619_;
                                                    phi_4620_ = _e1288;
                                                    phi_4621_ = false;
                                                } else {
                                                    phi_4620_ = f32();
                                                    phi_4621_ = true;
                                                }
                                                let _e1290 = phi_4620_;
                                                let _e1292 = phi_4621_;
                                                phi_4510_ = _e1244;
                                                phi_4512_ = _e1246;
                                                phi_4514_ = _e1290;
                                                phi_4622_ = _e1246;
                                                phi_4623_ = _e1248;
                                                phi_4624_ = _e1292;
                                            } else {
                                                phi_4510_ = f32();
                                                phi_4512_ = f32();
                                                phi_4514_ = f32();
                                                phi_4622_ = f32();
                                                phi_4623_ = false;
                                                phi_4624_ = false;
                                            }
                                            let _e1294 = phi_4510_;
                                            let _e1296 = phi_4512_;
                                            let _e1298 = phi_4514_;
                                            let _e1300 = phi_4622_;
                                            let _e1302 = phi_4623_;
                                            let _e1304 = phi_4624_;
                                            local_14 = _e1304;
                                            local_30 = _e1300;
                                            continue;
                                            continuing {
                                                phi_4506_ = _e1222;
                                                phi_4509_ = _e1294;
                                                phi_4511_ = _e1296;
                                                phi_4513_ = _e1298;
                                                break if !(_e1302);
                                            }
                                        }
                                        let _e1307 = local_14;
                                        if _e1307 {
                                            let _e5559 = local_30;
                                            phi_4628_ = _e5559;
                                        } else {
                                            let _e5561 = local_31;
                                            phi_4628_ = _e5561;
                                        }
                                        let _e1309 = phi_4628_;
                                        phi_4629_ = _e1309;
                                    } else {
                                        phi_4629_ = _e1131;
                                    }
                                    let _e1311 = phi_4629_;
                                    if _e1168 {
                                        if (_e1158 < 0f) {
                                            phi_4637_ = -1f;
                                        } else {
                                            phi_4637_ = 1f;
                                        }
                                        let _e1314 = phi_4637_;
                                        phi_4641_ = type_9(0u, 64u);
                                        phi_4644_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1317 = phi_4641_;
                                            let _e1319 = phi_4644_;
                                            if (_e1317.member < _e1317.member_1) {
                                                phi_4642_ = type_9((_e1317.member + 1u), _e1317.member_1);
                                                phi_4667_ = type_9(1u, _e1317.member);
                                            } else {
                                                phi_4642_ = _e1317;
                                                phi_4667_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1331 = phi_4642_;
                                            let _e1333 = phi_4667_;
                                            if (bitcast<i32>(_e1333.member) != 0i) {
                                                let _e1337 = (_e1311 + _e1319);
                                                if (_e1337 < _e1134) {
                                                    let _e1339 = (1f - _e1337);
                                                    let _e1352 = ((_e1314 * ((((_e593 * _e1339) + (_e616 * _e1337)) * (_e1339 * _e1339)) + (((_e639 * _e1339) + (_e650 * _e1337)) * (_e1337 * _e1337)))) > _e968);
                                                    if _e1352 {
                                                        phi_4697_ = f32();
                                                        phi_4698_ = false;
                                                    } else {
                                                        phi_4697_ = (_e1319 + _e1319);
                                                        phi_4698_ = true;
                                                    }
                                                    let _e1355 = phi_4697_;
                                                    let _e1357 = phi_4698_;
                                                    phi_4699_ = _e1355;
                                                    phi_4700_ = _e1357;
                                                    phi_4701_ = _e1352;
                                                    phi_4702_ = false;
                                                } else {
                                                    phi_4699_ = f32();
                                                    phi_4700_ = false;
                                                    phi_4701_ = false;
                                                    phi_4702_ = true;
                                                }
                                                let _e1359 = phi_4699_;
                                                let _e1361 = phi_4700_;
                                                let _e1363 = phi_4701_;
                                                let _e1365 = phi_4702_;
                                                phi_4703_ = _e1337;
                                                phi_4645_ = _e1359;
                                                phi_4704_ = _e1361;
                                                phi_4705_ = _e1363;
                                                phi_4706_ = _e1365;
                                                phi_4707_ = false;
                                            } else {
                                                phi_4703_ = f32();
                                                phi_4645_ = f32();
                                                phi_4704_ = false;
                                                phi_4705_ = false;
                                                phi_4706_ = false;
                                                phi_4707_ = true;
                                            }
                                            let _e1367 = phi_4703_;
                                            let _e1369 = phi_4645_;
                                            let _e1371 = phi_4704_;
                                            let _e1373 = phi_4705_;
                                            let _e1375 = phi_4706_;
                                            let _e1377 = phi_4707_;
                                            local_15 = _e1373;
                                            local_32 = _e1375;
                                            local_33 = _e1377;
                                            local_34 = _e1367;
                                            continue;
                                            continuing {
                                                phi_4641_ = _e1331;
                                                phi_4644_ = _e1369;
                                                break if !(_e1371);
                                            }
                                        }
                                        let _e1380 = local_15;
                                        if _e1380 {
                                            phi_4711_ = false;
                                            phi_4712_ = false;
                                        } else {
                                            let _e5583 = local_32;
                                            phi_4711_ = _e5583;
                                            let _e5586 = local_33;
                                            phi_4712_ = _e5586;
                                        }
                                        let _e1382 = phi_4711_;
                                        let _e1384 = phi_4712_;
                                        if _e1382 {
                                            phi_4716_ = true;
                                        } else {
                                            phi_4716_ = _e1384;
                                        }
                                        let _e1386 = phi_4716_;
                                        if _e1386 {
                                            phi_4720_ = _e1134;
                                        } else {
                                            let _e5590 = local_34;
                                            phi_4720_ = _e5590;
                                        }
                                        let _e1388 = phi_4720_;
                                        phi_4721_ = _e1388;
                                    } else {
                                        phi_4721_ = _e1134;
                                    }
                                    let _e1390 = phi_4721_;
                                    phi_4723_ = type_37(_e1311, _e1390, _e1181);
                                } else {
                                    phi_4723_ = _e1190;
                                }
                                let _e1393 = phi_4723_;
                                if (_e1393.member > _e1393.member_1) {
                                    phi_7966_ = f32();
                                    phi_7967_ = true;
                                    phi_7968_ = false;
                                    phi_7969_ = false;
                                    phi_7970_ = false;
                                } else {
                                    let _e1400 = ((_e1393.member_1 - _e1393.member) * 0.5f);
                                    let _e1401 = (_e1393.member + _e1400);
                                    let _e1403 = (_e1400 + (0.000000059604645f * 4f));
                                    let _e1405 = local_12.member_3;
                                    let _e1408 = local_12.member[0u];
                                    if (_e1408[0] < 0f) {
                                        phi_4752_ = -(_e1408[0]);
                                    } else {
                                        phi_4752_ = _e1408[0];
                                    }
                                    let _e1415 = phi_4752_;
                                    if (_e1408[1] < 0f) {
                                        phi_4759_ = -(_e1408[1]);
                                    } else {
                                        phi_4759_ = _e1408[1];
                                    }
                                    let _e1419 = phi_4759_;
                                    if (_e1415 > _e1419) {
                                        phi_4764_ = _e1415;
                                    } else {
                                        phi_4764_ = _e1419;
                                    }
                                    let _e1422 = phi_4764_;
                                    if (_e1408[2] < 0f) {
                                        phi_4771_ = -(_e1408[2]);
                                    } else {
                                        phi_4771_ = _e1408[2];
                                    }
                                    let _e1426 = phi_4771_;
                                    if (_e1422 > _e1426) {
                                        phi_4776_ = _e1422;
                                    } else {
                                        phi_4776_ = _e1426;
                                    }
                                    let _e1429 = phi_4776_;
                                    let _e1431 = local_12.member[1u];
                                    if (_e1431[0] < 0f) {
                                        phi_4789_ = -(_e1431[0]);
                                    } else {
                                        phi_4789_ = _e1431[0];
                                    }
                                    let _e1438 = phi_4789_;
                                    if (_e1431[1] < 0f) {
                                        phi_4796_ = -(_e1431[1]);
                                    } else {
                                        phi_4796_ = _e1431[1];
                                    }
                                    let _e1442 = phi_4796_;
                                    if (_e1438 > _e1442) {
                                        phi_4801_ = _e1438;
                                    } else {
                                        phi_4801_ = _e1442;
                                    }
                                    let _e1445 = phi_4801_;
                                    if (_e1431[2] < 0f) {
                                        phi_4808_ = -(_e1431[2]);
                                    } else {
                                        phi_4808_ = _e1431[2];
                                    }
                                    let _e1449 = phi_4808_;
                                    if (_e1445 > _e1449) {
                                        phi_4813_ = _e1445;
                                    } else {
                                        phi_4813_ = _e1449;
                                    }
                                    let _e1452 = phi_4813_;
                                    if (_e1429 > _e1452) {
                                        phi_4818_ = _e1429;
                                    } else {
                                        phi_4818_ = _e1452;
                                    }
                                    let _e1455 = phi_4818_;
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
                                        phi_4877_ = -(_e1486);
                                    } else {
                                        phi_4877_ = _e1486;
                                    }
                                    let _e1492 = phi_4877_;
                                    if (_e1487 < 0f) {
                                        phi_4883_ = -(_e1487);
                                    } else {
                                        phi_4883_ = _e1487;
                                    }
                                    let _e1496 = phi_4883_;
                                    if (_e1492 > _e1496) {
                                        phi_4888_ = _e1492;
                                    } else {
                                        phi_4888_ = _e1496;
                                    }
                                    let _e1499 = phi_4888_;
                                    if (_e1488 < 0f) {
                                        phi_4894_ = -(_e1488);
                                    } else {
                                        phi_4894_ = _e1488;
                                    }
                                    let _e1503 = phi_4894_;
                                    if (_e1499 > _e1503) {
                                        phi_4899_ = _e1499;
                                    } else {
                                        phi_4899_ = _e1503;
                                    }
                                    let _e1506 = phi_4899_;
                                    let _e1512 = ((((_e1403 * _e1506) * 1.01f) + ((_e1455 + _e1405) * (0.000000059604645f * 8f))) + _e1405);
                                    if (_e1473 < 0f) {
                                        phi_4911_ = -(_e1473);
                                    } else {
                                        phi_4911_ = _e1473;
                                    }
                                    let _e1516 = phi_4911_;
                                    if (_e1474 < 0f) {
                                        phi_4917_ = -(_e1474);
                                    } else {
                                        phi_4917_ = _e1474;
                                    }
                                    let _e1520 = phi_4917_;
                                    if (_e1516 > _e1520) {
                                        phi_4922_ = _e1516;
                                    } else {
                                        phi_4922_ = _e1520;
                                    }
                                    let _e1523 = phi_4922_;
                                    if (_e1475 < 0f) {
                                        phi_4928_ = -(_e1475);
                                    } else {
                                        phi_4928_ = _e1475;
                                    }
                                    let _e1527 = phi_4928_;
                                    if (_e1523 > _e1527) {
                                        phi_4933_ = _e1523;
                                    } else {
                                        phi_4933_ = _e1527;
                                    }
                                    let _e1530 = phi_4933_;
                                    local_2 = type_29(array<f32, 3>(_e1473, _e1474, _e1475), _e1512, (_e1530 + _e1512));
                                    let _e1536 = local_12.member_3;
                                    let _e1538 = local_12.member_1[0u];
                                    if (_e1538[0] < 0f) {
                                        phi_4959_ = -(_e1538[0]);
                                    } else {
                                        phi_4959_ = _e1538[0];
                                    }
                                    let _e1545 = phi_4959_;
                                    if (_e1538[1] < 0f) {
                                        phi_4966_ = -(_e1538[1]);
                                    } else {
                                        phi_4966_ = _e1538[1];
                                    }
                                    let _e1549 = phi_4966_;
                                    if (_e1545 > _e1549) {
                                        phi_4971_ = _e1545;
                                    } else {
                                        phi_4971_ = _e1549;
                                    }
                                    let _e1552 = phi_4971_;
                                    if (_e1538[2] < 0f) {
                                        phi_4978_ = -(_e1538[2]);
                                    } else {
                                        phi_4978_ = _e1538[2];
                                    }
                                    let _e1556 = phi_4978_;
                                    if (_e1552 > _e1556) {
                                        phi_4983_ = _e1552;
                                    } else {
                                        phi_4983_ = _e1556;
                                    }
                                    let _e1559 = phi_4983_;
                                    let _e1561 = local_12.member_1[1u];
                                    if (_e1561[0] < 0f) {
                                        phi_4996_ = -(_e1561[0]);
                                    } else {
                                        phi_4996_ = _e1561[0];
                                    }
                                    let _e1568 = phi_4996_;
                                    if (_e1561[1] < 0f) {
                                        phi_5003_ = -(_e1561[1]);
                                    } else {
                                        phi_5003_ = _e1561[1];
                                    }
                                    let _e1572 = phi_5003_;
                                    if (_e1568 > _e1572) {
                                        phi_5008_ = _e1568;
                                    } else {
                                        phi_5008_ = _e1572;
                                    }
                                    let _e1575 = phi_5008_;
                                    if (_e1561[2] < 0f) {
                                        phi_5015_ = -(_e1561[2]);
                                    } else {
                                        phi_5015_ = _e1561[2];
                                    }
                                    let _e1579 = phi_5015_;
                                    if (_e1575 > _e1579) {
                                        phi_5020_ = _e1575;
                                    } else {
                                        phi_5020_ = _e1579;
                                    }
                                    let _e1582 = phi_5020_;
                                    if (_e1559 > _e1582) {
                                        phi_5025_ = _e1559;
                                    } else {
                                        phi_5025_ = _e1582;
                                    }
                                    let _e1585 = phi_5025_;
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
                                        phi_5084_ = -(_e1616);
                                    } else {
                                        phi_5084_ = _e1616;
                                    }
                                    let _e1622 = phi_5084_;
                                    if (_e1617 < 0f) {
                                        phi_5090_ = -(_e1617);
                                    } else {
                                        phi_5090_ = _e1617;
                                    }
                                    let _e1626 = phi_5090_;
                                    if (_e1622 > _e1626) {
                                        phi_5095_ = _e1622;
                                    } else {
                                        phi_5095_ = _e1626;
                                    }
                                    let _e1629 = phi_5095_;
                                    if (_e1618 < 0f) {
                                        phi_5101_ = -(_e1618);
                                    } else {
                                        phi_5101_ = _e1618;
                                    }
                                    let _e1633 = phi_5101_;
                                    if (_e1629 > _e1633) {
                                        phi_5106_ = _e1629;
                                    } else {
                                        phi_5106_ = _e1633;
                                    }
                                    let _e1636 = phi_5106_;
                                    let _e1642 = ((((_e1403 * _e1636) * 1.01f) + ((_e1585 + _e1536) * (0.000000059604645f * 8f))) + _e1536);
                                    if (_e1603 < 0f) {
                                        phi_5118_ = -(_e1603);
                                    } else {
                                        phi_5118_ = _e1603;
                                    }
                                    let _e1646 = phi_5118_;
                                    if (_e1604 < 0f) {
                                        phi_5124_ = -(_e1604);
                                    } else {
                                        phi_5124_ = _e1604;
                                    }
                                    let _e1650 = phi_5124_;
                                    if (_e1646 > _e1650) {
                                        phi_5129_ = _e1646;
                                    } else {
                                        phi_5129_ = _e1650;
                                    }
                                    let _e1653 = phi_5129_;
                                    if (_e1605 < 0f) {
                                        phi_5135_ = -(_e1605);
                                    } else {
                                        phi_5135_ = _e1605;
                                    }
                                    let _e1657 = phi_5135_;
                                    if (_e1653 > _e1657) {
                                        phi_5140_ = _e1653;
                                    } else {
                                        phi_5140_ = _e1657;
                                    }
                                    let _e1660 = phi_5140_;
                                    local_3 = type_29(array<f32, 3>(_e1603, _e1604, _e1605), _e1642, (_e1660 + _e1642));
                                    let _e1666 = local_12.member_3;
                                    let _e1668 = local_12.member_2[0u];
                                    if (_e1668[0] < 0f) {
                                        phi_5166_ = -(_e1668[0]);
                                    } else {
                                        phi_5166_ = _e1668[0];
                                    }
                                    let _e1675 = phi_5166_;
                                    if (_e1668[1] < 0f) {
                                        phi_5173_ = -(_e1668[1]);
                                    } else {
                                        phi_5173_ = _e1668[1];
                                    }
                                    let _e1679 = phi_5173_;
                                    if (_e1675 > _e1679) {
                                        phi_5178_ = _e1675;
                                    } else {
                                        phi_5178_ = _e1679;
                                    }
                                    let _e1682 = phi_5178_;
                                    if (_e1668[2] < 0f) {
                                        phi_5185_ = -(_e1668[2]);
                                    } else {
                                        phi_5185_ = _e1668[2];
                                    }
                                    let _e1686 = phi_5185_;
                                    if (_e1682 > _e1686) {
                                        phi_5190_ = _e1682;
                                    } else {
                                        phi_5190_ = _e1686;
                                    }
                                    let _e1689 = phi_5190_;
                                    let _e1691 = local_12.member_2[1u];
                                    if (_e1691[0] < 0f) {
                                        phi_5203_ = -(_e1691[0]);
                                    } else {
                                        phi_5203_ = _e1691[0];
                                    }
                                    let _e1698 = phi_5203_;
                                    if (_e1691[1] < 0f) {
                                        phi_5210_ = -(_e1691[1]);
                                    } else {
                                        phi_5210_ = _e1691[1];
                                    }
                                    let _e1702 = phi_5210_;
                                    if (_e1698 > _e1702) {
                                        phi_5215_ = _e1698;
                                    } else {
                                        phi_5215_ = _e1702;
                                    }
                                    let _e1705 = phi_5215_;
                                    if (_e1691[2] < 0f) {
                                        phi_5222_ = -(_e1691[2]);
                                    } else {
                                        phi_5222_ = _e1691[2];
                                    }
                                    let _e1709 = phi_5222_;
                                    if (_e1705 > _e1709) {
                                        phi_5227_ = _e1705;
                                    } else {
                                        phi_5227_ = _e1709;
                                    }
                                    let _e1712 = phi_5227_;
                                    if (_e1689 > _e1712) {
                                        phi_5232_ = _e1689;
                                    } else {
                                        phi_5232_ = _e1712;
                                    }
                                    let _e1715 = phi_5232_;
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
                                        phi_5291_ = -(_e1746);
                                    } else {
                                        phi_5291_ = _e1746;
                                    }
                                    let _e1752 = phi_5291_;
                                    if (_e1747 < 0f) {
                                        phi_5297_ = -(_e1747);
                                    } else {
                                        phi_5297_ = _e1747;
                                    }
                                    let _e1756 = phi_5297_;
                                    if (_e1752 > _e1756) {
                                        phi_5302_ = _e1752;
                                    } else {
                                        phi_5302_ = _e1756;
                                    }
                                    let _e1759 = phi_5302_;
                                    if (_e1748 < 0f) {
                                        phi_5308_ = -(_e1748);
                                    } else {
                                        phi_5308_ = _e1748;
                                    }
                                    let _e1763 = phi_5308_;
                                    if (_e1759 > _e1763) {
                                        phi_5313_ = _e1759;
                                    } else {
                                        phi_5313_ = _e1763;
                                    }
                                    let _e1766 = phi_5313_;
                                    let _e1772 = ((((_e1403 * _e1766) * 1.01f) + ((_e1715 + _e1666) * (0.000000059604645f * 8f))) + _e1666);
                                    if (_e1733 < 0f) {
                                        phi_5325_ = -(_e1733);
                                    } else {
                                        phi_5325_ = _e1733;
                                    }
                                    let _e1776 = phi_5325_;
                                    if (_e1734 < 0f) {
                                        phi_5331_ = -(_e1734);
                                    } else {
                                        phi_5331_ = _e1734;
                                    }
                                    let _e1780 = phi_5331_;
                                    if (_e1776 > _e1780) {
                                        phi_5336_ = _e1776;
                                    } else {
                                        phi_5336_ = _e1780;
                                    }
                                    let _e1783 = phi_5336_;
                                    if (_e1735 < 0f) {
                                        phi_5342_ = -(_e1735);
                                    } else {
                                        phi_5342_ = _e1735;
                                    }
                                    let _e1787 = phi_5342_;
                                    if (_e1783 > _e1787) {
                                        phi_5347_ = _e1783;
                                    } else {
                                        phi_5347_ = _e1787;
                                    }
                                    let _e1790 = phi_5347_;
                                    local_4 = type_29(array<f32, 3>(_e1733, _e1734, _e1735), _e1772, (_e1790 + _e1772));
                                    let _e1795 = local_3.member;
                                    let _e1800 = local_4.member;
                                    let _e1806 = ((_e1795[1] * _e1800[2]) - (_e1795[2] * _e1800[1]));
                                    let _e1809 = ((_e1795[2] * _e1800[0]) - (_e1795[0] * _e1800[2]));
                                    let _e1812 = ((_e1795[0] * _e1800[1]) - (_e1795[1] * _e1800[0]));
                                    if (_e1806 < 0f) {
                                        phi_5396_ = -(_e1806);
                                    } else {
                                        phi_5396_ = _e1806;
                                    }
                                    let _e1816 = phi_5396_;
                                    if (_e1809 < 0f) {
                                        phi_5402_ = -(_e1809);
                                    } else {
                                        phi_5402_ = _e1809;
                                    }
                                    let _e1820 = phi_5402_;
                                    if (_e1816 > _e1820) {
                                        if (_e1806 < 0f) {
                                            phi_5412_ = -(_e1806);
                                        } else {
                                            phi_5412_ = _e1806;
                                        }
                                        let _e1838 = phi_5412_;
                                        if (_e1812 < 0f) {
                                            phi_5418_ = -(_e1812);
                                        } else {
                                            phi_5418_ = _e1812;
                                        }
                                        let _e1842 = phi_5418_;
                                        if (_e1838 > _e1842) {
                                            phi_5423_ = 2u;
                                            phi_5424_ = 1u;
                                        } else {
                                            phi_5423_ = 1u;
                                            phi_5424_ = 0u;
                                        }
                                        let _e1845 = phi_5423_;
                                        let _e1847 = phi_5424_;
                                        phi_5443_ = _e1845;
                                        phi_5444_ = _e1847;
                                    } else {
                                        if (_e1809 < 0f) {
                                            phi_5430_ = -(_e1809);
                                        } else {
                                            phi_5430_ = _e1809;
                                        }
                                        let _e1825 = phi_5430_;
                                        if (_e1812 < 0f) {
                                            phi_5436_ = -(_e1812);
                                        } else {
                                            phi_5436_ = _e1812;
                                        }
                                        let _e1829 = phi_5436_;
                                        if (_e1825 > _e1829) {
                                            phi_5441_ = 0u;
                                            phi_5442_ = 2u;
                                        } else {
                                            phi_5441_ = 1u;
                                            phi_5442_ = 0u;
                                        }
                                        let _e1832 = phi_5441_;
                                        let _e1834 = phi_5442_;
                                        phi_5443_ = _e1832;
                                        phi_5444_ = _e1834;
                                    }
                                    let _e1849 = phi_5443_;
                                    let _e1851 = phi_5444_;
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
                                        phi_5513_ = -(_e1866);
                                    } else {
                                        phi_5513_ = _e1866;
                                    }
                                    let _e1902 = phi_5513_;
                                    if (_e1902 > _e1898) {
                                        if (_e1866 < 0f) {
                                            phi_5522_ = -1f;
                                        } else {
                                            phi_5522_ = 1f;
                                        }
                                        let _e1906 = phi_5522_;
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
                                            phi_5657_ = -(_e2001);
                                        } else {
                                            phi_5657_ = _e2001;
                                        }
                                        let _e2007 = phi_5657_;
                                        if (_e2002 < 0f) {
                                            phi_5663_ = -(_e2002);
                                        } else {
                                            phi_5663_ = _e2002;
                                        }
                                        let _e2011 = phi_5663_;
                                        if (_e2003 < 0f) {
                                            phi_5670_ = -(_e2003);
                                        } else {
                                            phi_5670_ = _e2003;
                                        }
                                        let _e2016 = phi_5670_;
                                        let _e2019 = (((_e2007 + _e2011) + _e2016) * (0.000000059604645f * 4f));
                                        local_5[0u].member = _e2002;
                                        local_5[0u].member_1 = _e1953;
                                        local_5[1u].member = _e2003;
                                        local_5[1u].member_1 = _e2000;
                                        local_5[2u].member = (_e2001 - _e2002);
                                        local_5[2u].member_1 = ((_e1898 + _e1953) + _e2019);
                                        local_5[3u].member = (_e2001 - _e2003);
                                        local_5[3u].member_1 = ((_e1898 + _e2000) + _e2019);
                                        phi_5713_ = type_9(0u, 4u);
                                        phi_5716_ = true;
                                        loop {
                                            let _e2040 = phi_5713_;
                                            let _e2042 = phi_5716_;
                                            local_17 = _e2042;
                                            if (_e2040.member < _e2040.member_1) {
                                                phi_5714_ = type_9((_e2040.member + 1u), _e2040.member_1);
                                                phi_5739_ = type_9(1u, _e2040.member);
                                            } else {
                                                phi_5714_ = _e2040;
                                                phi_5739_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2054 = phi_5714_;
                                            let _e2056 = phi_5739_;
                                            if (bitcast<i32>(_e2056.member) != 0i) {
                                                let _e2063 = local_5[_e2056.member_1].member;
                                                let _e2066 = local_5[_e2056.member_1].member_1;
                                                let _e2068 = (_e2063 < -(_e2066));
                                                if _e2068 {
                                                    phi_5766_ = bool();
                                                    phi_5767_ = false;
                                                } else {
                                                    phi_5766_ = (_e2042 && (_e2063 > _e2066));
                                                    phi_5767_ = true;
                                                }
                                                let _e2072 = phi_5766_;
                                                let _e2074 = phi_5767_;
                                                phi_5717_ = _e2072;
                                                phi_5768_ = _e2074;
                                                phi_5769_ = _e2068;
                                            } else {
                                                phi_5717_ = bool();
                                                phi_5768_ = false;
                                                phi_5769_ = false;
                                            }
                                            let _e2076 = phi_5717_;
                                            let _e2078 = phi_5768_;
                                            let _e2080 = phi_5769_;
                                            local_16 = _e2080;
                                            continue;
                                            continuing {
                                                phi_5713_ = _e2054;
                                                phi_5716_ = _e2076;
                                                break if !(_e2078);
                                            }
                                        }
                                        let _e2083 = local_16;
                                        if _e2083 {
                                            phi_5773_ = false;
                                        } else {
                                            phi_5773_ = true;
                                        }
                                        let _e2085 = phi_5773_;
                                        if _e2085 {
                                            let _e2087 = local_17;
                                            if _e2087 {
                                                phi_5780_ = 1u;
                                            } else {
                                                phi_5780_ = 2u;
                                            }
                                            let _e2089 = phi_5780_;
                                            phi_5781_ = _e2089;
                                            phi_5782_ = false;
                                        } else {
                                            phi_5781_ = u32();
                                            phi_5782_ = true;
                                        }
                                        let _e2091 = phi_5781_;
                                        let _e2093 = phi_5782_;
                                        phi_5783_ = _e2091;
                                        phi_5784_ = 0u;
                                        phi_5785_ = _e2093;
                                    } else {
                                        phi_5783_ = u32();
                                        phi_5784_ = 2u;
                                        phi_5785_ = true;
                                    }
                                    let _e2095 = phi_5783_;
                                    let _e2097 = phi_5784_;
                                    let _e2099 = phi_5785_;
                                    if _e2099 {
                                        phi_5789_ = _e2097;
                                    } else {
                                        phi_5789_ = _e2095;
                                    }
                                    let _e2101 = phi_5789_;
                                    let _e2102 = (_e2101 == 0u);
                                    if _e2102 {
                                        phi_7962_ = f32();
                                        phi_7963_ = false;
                                        phi_7964_ = false;
                                        phi_7965_ = false;
                                    } else {
                                        if (_e2101 == 1u) {
                                            if _e1393.member_2 {
                                                if ((_e1393.member_1 - _e1393.member) <= 0.0000005f) {
                                                    phi_5809_ = false;
                                                } else {
                                                    phi_5809_ = true;
                                                }
                                                let _e2110 = phi_5809_;
                                                phi_5810_ = _e2110;
                                            } else {
                                                phi_5810_ = true;
                                            }
                                            let _e2112 = phi_5810_;
                                            phi_5811_ = _e2112;
                                        } else {
                                            phi_5811_ = true;
                                        }
                                        let _e2114 = phi_5811_;
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
                                                phi_5959_ = -(_e2173[0]);
                                            } else {
                                                phi_5959_ = _e2173[0];
                                            }
                                            let _e2180 = phi_5959_;
                                            if (_e2173[1] < 0f) {
                                                phi_5966_ = -(_e2173[1]);
                                            } else {
                                                phi_5966_ = _e2173[1];
                                            }
                                            let _e2184 = phi_5966_;
                                            if (_e2180 > _e2184) {
                                                phi_5971_ = _e2180;
                                            } else {
                                                phi_5971_ = _e2184;
                                            }
                                            let _e2187 = phi_5971_;
                                            if (_e2173[2] < 0f) {
                                                phi_5978_ = -(_e2173[2]);
                                            } else {
                                                phi_5978_ = _e2173[2];
                                            }
                                            let _e2191 = phi_5978_;
                                            if (_e2187 > _e2191) {
                                                phi_5983_ = _e2187;
                                            } else {
                                                phi_5983_ = _e2191;
                                            }
                                            let _e2194 = phi_5983_;
                                            let _e2197 = local_12.member[1u];
                                            if (_e2197[0] < 0f) {
                                                phi_5996_ = -(_e2197[0]);
                                            } else {
                                                phi_5996_ = _e2197[0];
                                            }
                                            let _e2204 = phi_5996_;
                                            if (_e2197[1] < 0f) {
                                                phi_6003_ = -(_e2197[1]);
                                            } else {
                                                phi_6003_ = _e2197[1];
                                            }
                                            let _e2208 = phi_6003_;
                                            if (_e2204 > _e2208) {
                                                phi_6008_ = _e2204;
                                            } else {
                                                phi_6008_ = _e2208;
                                            }
                                            let _e2211 = phi_6008_;
                                            if (_e2197[2] < 0f) {
                                                phi_6015_ = -(_e2197[2]);
                                            } else {
                                                phi_6015_ = _e2197[2];
                                            }
                                            let _e2215 = phi_6015_;
                                            if (_e2211 > _e2215) {
                                                phi_6020_ = _e2211;
                                            } else {
                                                phi_6020_ = _e2215;
                                            }
                                            let _e2218 = phi_6020_;
                                            if (_e2194 > _e2218) {
                                                phi_6025_ = _e2194;
                                            } else {
                                                phi_6025_ = _e2218;
                                            }
                                            let _e2221 = phi_6025_;
                                            let _e2223 = local_12.member_3;
                                            let _e2227 = local_12.member_1[0u];
                                            if (_e2227[0] < 0f) {
                                                phi_6042_ = -(_e2227[0]);
                                            } else {
                                                phi_6042_ = _e2227[0];
                                            }
                                            let _e2234 = phi_6042_;
                                            if (_e2227[1] < 0f) {
                                                phi_6049_ = -(_e2227[1]);
                                            } else {
                                                phi_6049_ = _e2227[1];
                                            }
                                            let _e2238 = phi_6049_;
                                            if (_e2234 > _e2238) {
                                                phi_6054_ = _e2234;
                                            } else {
                                                phi_6054_ = _e2238;
                                            }
                                            let _e2241 = phi_6054_;
                                            if (_e2227[2] < 0f) {
                                                phi_6061_ = -(_e2227[2]);
                                            } else {
                                                phi_6061_ = _e2227[2];
                                            }
                                            let _e2245 = phi_6061_;
                                            if (_e2241 > _e2245) {
                                                phi_6066_ = _e2241;
                                            } else {
                                                phi_6066_ = _e2245;
                                            }
                                            let _e2248 = phi_6066_;
                                            let _e2251 = local_12.member_1[1u];
                                            if (_e2251[0] < 0f) {
                                                phi_6080_ = -(_e2251[0]);
                                            } else {
                                                phi_6080_ = _e2251[0];
                                            }
                                            let _e2258 = phi_6080_;
                                            if (_e2251[1] < 0f) {
                                                phi_6087_ = -(_e2251[1]);
                                            } else {
                                                phi_6087_ = _e2251[1];
                                            }
                                            let _e2262 = phi_6087_;
                                            if (_e2258 > _e2262) {
                                                phi_6092_ = _e2258;
                                            } else {
                                                phi_6092_ = _e2262;
                                            }
                                            let _e2265 = phi_6092_;
                                            if (_e2251[2] < 0f) {
                                                phi_6099_ = -(_e2251[2]);
                                            } else {
                                                phi_6099_ = _e2251[2];
                                            }
                                            let _e2269 = phi_6099_;
                                            if (_e2265 > _e2269) {
                                                phi_6104_ = _e2265;
                                            } else {
                                                phi_6104_ = _e2269;
                                            }
                                            let _e2272 = phi_6104_;
                                            if (_e2248 > _e2272) {
                                                phi_6109_ = _e2248;
                                            } else {
                                                phi_6109_ = _e2272;
                                            }
                                            let _e2275 = phi_6109_;
                                            let _e2277 = local_12.member_3;
                                            let _e2281 = local_12.member_2[0u];
                                            if (_e2281[0] < 0f) {
                                                phi_6126_ = -(_e2281[0]);
                                            } else {
                                                phi_6126_ = _e2281[0];
                                            }
                                            let _e2288 = phi_6126_;
                                            if (_e2281[1] < 0f) {
                                                phi_6133_ = -(_e2281[1]);
                                            } else {
                                                phi_6133_ = _e2281[1];
                                            }
                                            let _e2292 = phi_6133_;
                                            if (_e2288 > _e2292) {
                                                phi_6138_ = _e2288;
                                            } else {
                                                phi_6138_ = _e2292;
                                            }
                                            let _e2295 = phi_6138_;
                                            if (_e2281[2] < 0f) {
                                                phi_6145_ = -(_e2281[2]);
                                            } else {
                                                phi_6145_ = _e2281[2];
                                            }
                                            let _e2299 = phi_6145_;
                                            if (_e2295 > _e2299) {
                                                phi_6150_ = _e2295;
                                            } else {
                                                phi_6150_ = _e2299;
                                            }
                                            let _e2302 = phi_6150_;
                                            let _e2305 = local_12.member_2[1u];
                                            if (_e2305[0] < 0f) {
                                                phi_6164_ = -(_e2305[0]);
                                            } else {
                                                phi_6164_ = _e2305[0];
                                            }
                                            let _e2312 = phi_6164_;
                                            if (_e2305[1] < 0f) {
                                                phi_6171_ = -(_e2305[1]);
                                            } else {
                                                phi_6171_ = _e2305[1];
                                            }
                                            let _e2316 = phi_6171_;
                                            if (_e2312 > _e2316) {
                                                phi_6176_ = _e2312;
                                            } else {
                                                phi_6176_ = _e2316;
                                            }
                                            let _e2319 = phi_6176_;
                                            if (_e2305[2] < 0f) {
                                                phi_6183_ = -(_e2305[2]);
                                            } else {
                                                phi_6183_ = _e2305[2];
                                            }
                                            let _e2323 = phi_6183_;
                                            if (_e2319 > _e2323) {
                                                phi_6188_ = _e2319;
                                            } else {
                                                phi_6188_ = _e2323;
                                            }
                                            let _e2326 = phi_6188_;
                                            if (_e2302 > _e2326) {
                                                phi_6193_ = _e2302;
                                            } else {
                                                phi_6193_ = _e2326;
                                            }
                                            let _e2329 = phi_6193_;
                                            let _e2331 = local_12.member_3;
                                            let _e2338 = local_12.member_3;
                                            local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_6232_ = type_9(0u, 96u);
                                            phi_6235_ = _e1393.member;
                                            phi_6237_ = _e1393.member;
                                            phi_6239_ = _e1393.member;
                                            phi_6241_ = false;
                                            phi_6243_ = 0u;
                                            loop {
                                                let _e2344 = phi_6232_;
                                                let _e2346 = phi_6235_;
                                                let _e2348 = phi_6237_;
                                                let _e2350 = phi_6239_;
                                                let _e2352 = phi_6241_;
                                                let _e2354 = phi_6243_;
                                                local_36 = _e2348;
                                                local_20 = _e2346;
                                                if (_e2344.member < _e2344.member_1) {
                                                    phi_6233_ = type_9((_e2344.member + 1u), _e2344.member_1);
                                                    phi_6266_ = type_9(1u, _e2344.member);
                                                } else {
                                                    phi_6233_ = _e2344;
                                                    phi_6266_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2366 = phi_6233_;
                                                let _e2368 = phi_6266_;
                                                if (bitcast<i32>(_e2368.member) != 0i) {
                                                    let _e2374 = local_12.member[0u];
                                                    let _e2380 = local_12.member[1u];
                                                    let _e2396 = local_12.member_1[0u];
                                                    let _e2402 = local_12.member_1[1u];
                                                    let _e2418 = local_12.member_2[0u];
                                                    let _e2424 = local_12.member_2[1u];
                                                    let _e2438 = function_2(array<f32, 3>((_e2374[0] + ((_e2380[0] - _e2374[0]) * _e2346)), (_e2374[1] + ((_e2380[1] - _e2374[1]) * _e2346)), (_e2374[2] + ((_e2380[2] - _e2374[2]) * _e2346))), array<f32, 3>((_e2396[0] + ((_e2402[0] - _e2396[0]) * _e2346)), (_e2396[1] + ((_e2402[1] - _e2396[1]) * _e2346)), (_e2396[2] + ((_e2402[2] - _e2396[2]) * _e2346))), array<f32, 3>((_e2418[0] + ((_e2424[0] - _e2418[0]) * _e2346)), (_e2418[1] + ((_e2424[1] - _e2418[1]) * _e2346)), (_e2418[2] + ((_e2424[2] - _e2418[2]) * _e2346))), 1u);
                                                    if (_e2354 == 0u) {
                                                        phi_6394_ = _e2438;
                                                    } else {
                                                        if (_e2354 == 1u) {
                                                            phi_6380_ = _e2438[0];
                                                        } else {
                                                            phi_6380_ = 0f;
                                                        }
                                                        let _e2443 = phi_6380_;
                                                        if (_e2354 == 2u) {
                                                            phi_6386_ = _e2438[1];
                                                        } else {
                                                            phi_6386_ = 0f;
                                                        }
                                                        let _e2447 = phi_6386_;
                                                        if (_e2354 == 3u) {
                                                            phi_6392_ = _e2438[2];
                                                        } else {
                                                            phi_6392_ = 0f;
                                                        }
                                                        let _e2451 = phi_6392_;
                                                        phi_6394_ = array<f32, 3>(_e2443, _e2447, _e2451);
                                                    }
                                                    let _e2454 = phi_6394_;
                                                    if (_e2454[0] < 0f) {
                                                        phi_6401_ = -(_e2454[0]);
                                                    } else {
                                                        phi_6401_ = _e2454[0];
                                                    }
                                                    let _e2459 = phi_6401_;
                                                    if (_e2454[1] < 0f) {
                                                        phi_6408_ = -(_e2454[1]);
                                                    } else {
                                                        phi_6408_ = _e2454[1];
                                                    }
                                                    let _e2464 = phi_6408_;
                                                    if (_e2454[2] < 0f) {
                                                        phi_6416_ = -(_e2454[2]);
                                                    } else {
                                                        phi_6416_ = _e2454[2];
                                                    }
                                                    let _e2470 = phi_6416_;
                                                    let _e2471 = ((_e2459 + _e2464) + _e2470);
                                                    if (_e2471 > 0f) {
                                                        if ((bitcast<u32>(_e2471) & 2139095040u) != 2139095040u) {
                                                            let _e2476 = (1f / _e2471);
                                                            let _e2478 = (_e2454[0] * _e2476);
                                                            let _e2480 = (_e2454[1] * _e2476);
                                                            let _e2482 = (_e2454[2] * _e2476);
                                                            let _e2487 = (((_e2478 * _e2478) + (_e2480 * _e2480)) + (_e2482 * _e2482));
                                                            if (_e2487 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2487 > 0f) {
                                                                    phi_6453_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6453_ = 0f;
                                                                }
                                                                let _e2540 = phi_6453_;
                                                                phi_6517_ = _e2540;
                                                            } else {
                                                                phi_6460_ = type_14(0i, 5i);
                                                                phi_6463_ = bitcast<f32>(((bitcast<u32>(_e2487) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2495 = phi_6460_;
                                                                    let _e2497 = phi_6463_;
                                                                    local_18 = _e2497;
                                                                    if (_e2495.member < _e2495.member_1) {
                                                                        let _e2504 = (_e2495.member + 1i);
                                                                        if ((false == (_e2504 > _e2495.member)) != false) {
                                                                            phi_6484_ = true;
                                                                        } else {
                                                                            phi_6484_ = false;
                                                                        }
                                                                        let _e2509 = phi_6484_;
                                                                        if _e2509 {
                                                                            phi_6490_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_6490_ = type_15(1u, _e2504);
                                                                        }
                                                                        let _e2514 = phi_6490_;
                                                                        phi_6461_ = type_14(_e2514.member_1, _e2495.member_1);
                                                                        phi_6504_ = type_15(1u, _e2495.member);
                                                                    } else {
                                                                        phi_6461_ = _e2495;
                                                                        phi_6504_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2520 = phi_6461_;
                                                                    let _e2522 = phi_6504_;
                                                                    let _e2525 = (bitcast<i32>(_e2522.member) != 0i);
                                                                    if _e2525 {
                                                                        phi_6464_ = (0.5f * (_e2497 + (_e2487 / _e2497)));
                                                                    } else {
                                                                        phi_6464_ = f32();
                                                                    }
                                                                    let _e2530 = phi_6464_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6460_ = _e2520;
                                                                        phi_6463_ = _e2530;
                                                                        break if !(_e2525);
                                                                    }
                                                                }
                                                                let _e2535 = local_18;
                                                                phi_6517_ = (_e2535 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2542 = phi_6517_;
                                                            let _e2543 = (0.000000059604645f * 12f);
                                                            let _e2548 = ((((((((_e2221 + _e2223) + (_e2275 + _e2277)) + (_e2329 + _e2331)) * (0.000000059604645f * 16f)) + (_e2338 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2542) * (1f + _e2543)));
                                                            let _e2553 = (((_e2478 * _e2119[0]) + (_e2480 * _e2119[1])) + (_e2482 * _e2119[2]));
                                                            let _e2558 = (((_e2478 * _e2135) + (_e2480 * _e2136)) + (_e2482 * _e2137));
                                                            let _e2563 = (((_e2478 * (_e2119[0] - _e2131[0])) + (_e2480 * (_e2119[1] - _e2131[1]))) + (_e2482 * (_e2119[2] - _e2131[2])));
                                                            let _e2568 = (((_e2478 * (_e2135 - _e2131[0])) + (_e2480 * (_e2136 - _e2131[1]))) + (_e2482 * (_e2137 - _e2131[2])));
                                                            let _e2574 = (((_e2478 * _e2146[0]) + (_e2480 * _e2146[1])) + (_e2482 * _e2146[2]));
                                                            let _e2579 = (((_e2478 * _e2162) + (_e2480 * _e2163)) + (_e2482 * _e2164));
                                                            let _e2584 = (((_e2478 * (_e2146[0] - _e2158[0])) + (_e2480 * (_e2146[1] - _e2158[1]))) + (_e2482 * (_e2146[2] - _e2158[2])));
                                                            let _e2589 = (((_e2478 * (_e2162 - _e2158[0])) + (_e2480 * (_e2163 - _e2158[1]))) + (_e2482 * (_e2164 - _e2158[2])));
                                                            if (_e2553 < 0f) {
                                                                phi_6583_ = -(_e2553);
                                                            } else {
                                                                phi_6583_ = _e2553;
                                                            }
                                                            let _e2594 = phi_6583_;
                                                            if (_e2574 < 0f) {
                                                                phi_6589_ = -(_e2574);
                                                            } else {
                                                                phi_6589_ = _e2574;
                                                            }
                                                            let _e2598 = phi_6589_;
                                                            if (_e2558 < 0f) {
                                                                phi_6598_ = -(_e2558);
                                                            } else {
                                                                phi_6598_ = _e2558;
                                                            }
                                                            let _e2605 = phi_6598_;
                                                            if (_e2579 < 0f) {
                                                                phi_6604_ = -(_e2579);
                                                            } else {
                                                                phi_6604_ = _e2579;
                                                            }
                                                            let _e2609 = phi_6604_;
                                                            if (_e2563 < 0f) {
                                                                phi_6613_ = -(_e2563);
                                                            } else {
                                                                phi_6613_ = _e2563;
                                                            }
                                                            let _e2616 = phi_6613_;
                                                            if (_e2584 < 0f) {
                                                                phi_6619_ = -(_e2584);
                                                            } else {
                                                                phi_6619_ = _e2584;
                                                            }
                                                            let _e2620 = phi_6619_;
                                                            if (_e2568 < 0f) {
                                                                phi_6628_ = -(_e2568);
                                                            } else {
                                                                phi_6628_ = _e2568;
                                                            }
                                                            let _e2627 = phi_6628_;
                                                            if (_e2589 < 0f) {
                                                                phi_6634_ = -(_e2589);
                                                            } else {
                                                                phi_6634_ = _e2589;
                                                            }
                                                            let _e2631 = phi_6634_;
                                                            phi_6640_ = type_30(array<f32, 4>(_e2553, _e2558, _e2563, _e2568), array<f32, 4>(_e2574, _e2579, _e2584, _e2589), array<f32, 4>((_e2548 + ((_e2594 + _e2598) * _e2543)), (_e2548 + ((_e2605 + _e2609) * _e2543)), (_e2548 + ((_e2616 + _e2620) * _e2543)), (_e2548 + ((_e2627 + _e2631) * _e2543))));
                                                            phi_6641_ = false;
                                                        } else {
                                                            phi_6640_ = type_30();
                                                            phi_6641_ = true;
                                                        }
                                                        let _e2638 = phi_6640_;
                                                        let _e2640 = phi_6641_;
                                                        phi_6642_ = _e2638;
                                                        phi_6643_ = _e2640;
                                                    } else {
                                                        phi_6642_ = type_30();
                                                        phi_6643_ = true;
                                                    }
                                                    let _e2642 = phi_6642_;
                                                    let _e2644 = phi_6643_;
                                                    if _e2644 {
                                                        phi_6651_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_6651_ = _e2642;
                                                    }
                                                    let _e2646 = phi_6651_;
                                                    local_1 = type_30(array<f32, 4>(_e2646.member[0], _e2646.member[1], _e2646.member[2], _e2646.member[3]), array<f32, 4>(_e2646.member_1[0], _e2646.member_1[1], _e2646.member_1[2], _e2646.member_1[3]), array<f32, 4>(_e2646.member_2[0], _e2646.member_2[1], _e2646.member_2[2], _e2646.member_2[3]));
                                                    let _e2666 = (_e2346 - _e2350);
                                                    let _e2670 = local_1.member[0u];
                                                    let _e2673 = local_1.member_1[0u];
                                                    let _e2676 = local_1.member[0u];
                                                    let _e2682 = local_1.member_2[0u];
                                                    if (((_e2670 + ((_e2673 - _e2676) * _e2346)) - _e2682) > 0f) {
                                                        let _e2687 = local_1.member[1u];
                                                        let _e2690 = local_1.member_1[1u];
                                                        let _e2693 = local_1.member[1u];
                                                        let _e2699 = local_1.member_2[1u];
                                                        if (((_e2687 + ((_e2690 - _e2693) * _e2346)) - _e2699) > 0f) {
                                                            let _e2704 = local_1.member[2u];
                                                            let _e2707 = local_1.member_1[2u];
                                                            let _e2710 = local_1.member[2u];
                                                            let _e2716 = local_1.member_2[2u];
                                                            if (((_e2704 + ((_e2707 - _e2710) * _e2346)) - _e2716) > 0f) {
                                                                let _e2721 = local_1.member[3u];
                                                                let _e2724 = local_1.member_1[3u];
                                                                let _e2727 = local_1.member[3u];
                                                                let _e2733 = local_1.member_2[3u];
                                                                phi_6822_ = (((_e2721 + ((_e2724 - _e2727) * _e2346)) - _e2733) > 0f);
                                                                phi_6823_ = false;
                                                            } else {
                                                                phi_6822_ = bool();
                                                                phi_6823_ = true;
                                                            }
                                                            let _e2737 = phi_6822_;
                                                            let _e2739 = phi_6823_;
                                                            phi_6824_ = _e2737;
                                                            phi_6825_ = _e2739;
                                                        } else {
                                                            phi_6824_ = bool();
                                                            phi_6825_ = true;
                                                        }
                                                        let _e2741 = phi_6824_;
                                                        let _e2743 = phi_6825_;
                                                        phi_6826_ = _e2741;
                                                        phi_6827_ = _e2743;
                                                    } else {
                                                        phi_6826_ = bool();
                                                        phi_6827_ = true;
                                                    }
                                                    let _e2745 = phi_6826_;
                                                    let _e2747 = phi_6827_;
                                                    if _e2747 {
                                                        phi_6831_ = false;
                                                    } else {
                                                        phi_6831_ = _e2745;
                                                    }
                                                    let _e2749 = phi_6831_;
                                                    if _e2749 {
                                                        if (_e2346 <= _e2348) {
                                                            phi_7141_ = true;
                                                        } else {
                                                            let _e2753 = local.member[0u];
                                                            let _e2756 = local.member_1[0u];
                                                            let _e2759 = local.member[0u];
                                                            let _e2765 = local.member_2[0u];
                                                            let _e2769 = local_1.member[0u];
                                                            let _e2772 = local_1.member_1[0u];
                                                            let _e2775 = local_1.member[0u];
                                                            let _e2781 = local_1.member_2[0u];
                                                            if ((((_e2753 + ((_e2756 - _e2759) * _e2346)) - _e2765) + ((_e2769 + ((_e2772 - _e2775) * _e2350)) - _e2781)) > 0f) {
                                                                let _e2787 = local.member[1u];
                                                                let _e2790 = local.member_1[1u];
                                                                let _e2793 = local.member[1u];
                                                                let _e2799 = local.member_2[1u];
                                                                let _e2803 = local_1.member[1u];
                                                                let _e2806 = local_1.member_1[1u];
                                                                let _e2809 = local_1.member[1u];
                                                                let _e2815 = local_1.member_2[1u];
                                                                if ((((_e2787 + ((_e2790 - _e2793) * _e2346)) - _e2799) + ((_e2803 + ((_e2806 - _e2809) * _e2350)) - _e2815)) > 0f) {
                                                                    let _e2821 = local.member[2u];
                                                                    let _e2824 = local.member_1[2u];
                                                                    let _e2827 = local.member[2u];
                                                                    let _e2833 = local.member_2[2u];
                                                                    let _e2837 = local_1.member[2u];
                                                                    let _e2840 = local_1.member_1[2u];
                                                                    let _e2843 = local_1.member[2u];
                                                                    let _e2849 = local_1.member_2[2u];
                                                                    if ((((_e2821 + ((_e2824 - _e2827) * _e2346)) - _e2833) + ((_e2837 + ((_e2840 - _e2843) * _e2350)) - _e2849)) > 0f) {
                                                                        let _e2855 = local.member[3u];
                                                                        let _e2858 = local.member_1[3u];
                                                                        let _e2861 = local.member[3u];
                                                                        let _e2867 = local.member_2[3u];
                                                                        let _e2871 = local_1.member[3u];
                                                                        let _e2874 = local_1.member_1[3u];
                                                                        let _e2877 = local_1.member[3u];
                                                                        let _e2883 = local_1.member_2[3u];
                                                                        phi_7128_ = ((((_e2855 + ((_e2858 - _e2861) * _e2346)) - _e2867) + ((_e2871 + ((_e2874 - _e2877) * _e2350)) - _e2883)) > 0f);
                                                                        phi_7129_ = false;
                                                                    } else {
                                                                        phi_7128_ = bool();
                                                                        phi_7129_ = true;
                                                                    }
                                                                    let _e2888 = phi_7128_;
                                                                    let _e2890 = phi_7129_;
                                                                    phi_7130_ = _e2888;
                                                                    phi_7131_ = _e2890;
                                                                } else {
                                                                    phi_7130_ = bool();
                                                                    phi_7131_ = true;
                                                                }
                                                                let _e2892 = phi_7130_;
                                                                let _e2894 = phi_7131_;
                                                                phi_7132_ = _e2892;
                                                                phi_7133_ = _e2894;
                                                            } else {
                                                                phi_7132_ = bool();
                                                                phi_7133_ = true;
                                                            }
                                                            let _e2896 = phi_7132_;
                                                            let _e2898 = phi_7133_;
                                                            if _e2898 {
                                                                phi_7137_ = false;
                                                            } else {
                                                                phi_7137_ = _e2896;
                                                            }
                                                            let _e2900 = phi_7137_;
                                                            phi_7141_ = _e2900;
                                                        }
                                                        let _e2902 = phi_7141_;
                                                        if _e2902 {
                                                            if _e2352 {
                                                                if (_e2346 >= _e1393.member_1) {
                                                                    phi_7152_ = false;
                                                                } else {
                                                                    phi_7152_ = true;
                                                                }
                                                                let _e2905 = phi_7152_;
                                                                phi_7153_ = _e2905;
                                                            } else {
                                                                phi_7153_ = true;
                                                            }
                                                            let _e2907 = phi_7153_;
                                                            if _e2907 {
                                                                local = type_30(array<f32, 4>(_e2646.member[0], _e2646.member[1], _e2646.member[2], _e2646.member[3]), array<f32, 4>(_e2646.member_1[0], _e2646.member_1[1], _e2646.member_1[2], _e2646.member_1[3]), array<f32, 4>(_e2646.member_2[0], _e2646.member_2[1], _e2646.member_2[2], _e2646.member_2[3]));
                                                                let _e2929 = local.member[0u];
                                                                let _e2932 = local.member_1[0u];
                                                                let _e2935 = local.member_2[0u];
                                                                if (_e2929 > _e2935) {
                                                                    if (_e2932 > _e2935) {
                                                                        phi_7227_ = false;
                                                                    } else {
                                                                        phi_7227_ = true;
                                                                    }
                                                                    let _e2939 = phi_7227_;
                                                                    phi_7228_ = _e2939;
                                                                } else {
                                                                    phi_7228_ = true;
                                                                }
                                                                let _e2941 = phi_7228_;
                                                                if _e2941 {
                                                                    let _e2942 = (_e2932 >= _e2929);
                                                                    if _e2942 {
                                                                        phi_7250_ = f32();
                                                                        phi_7251_ = false;
                                                                    } else {
                                                                        if ((_e2929 - _e2932) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7248_ = (((_e2929 - _e2935) / (_e2929 - _e2932)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7249_ = false;
                                                                        } else {
                                                                            phi_7248_ = f32();
                                                                            phi_7249_ = true;
                                                                        }
                                                                        let _e2953 = phi_7248_;
                                                                        let _e2955 = phi_7249_;
                                                                        phi_7250_ = _e2953;
                                                                        phi_7251_ = _e2955;
                                                                    }
                                                                    let _e2957 = phi_7250_;
                                                                    let _e2959 = phi_7251_;
                                                                    phi_7252_ = _e2957;
                                                                    phi_7253_ = _e2942;
                                                                    phi_7254_ = _e2959;
                                                                } else {
                                                                    phi_7252_ = f32();
                                                                    phi_7253_ = true;
                                                                    phi_7254_ = false;
                                                                }
                                                                let _e2961 = phi_7252_;
                                                                let _e2963 = phi_7253_;
                                                                let _e2965 = phi_7254_;
                                                                if _e2963 {
                                                                    phi_7258_ = 2f;
                                                                    phi_7259_ = true;
                                                                } else {
                                                                    phi_7258_ = _e2346;
                                                                    phi_7259_ = _e2965;
                                                                }
                                                                let _e2967 = phi_7258_;
                                                                let _e2969 = phi_7259_;
                                                                if _e2969 {
                                                                    phi_7263_ = _e2967;
                                                                } else {
                                                                    phi_7263_ = _e2961;
                                                                }
                                                                let _e2971 = phi_7263_;
                                                                let _e2974 = local.member[1u];
                                                                let _e2977 = local.member_1[1u];
                                                                let _e2980 = local.member_2[1u];
                                                                if (_e2974 > _e2980) {
                                                                    if (_e2977 > _e2980) {
                                                                        phi_7295_ = false;
                                                                    } else {
                                                                        phi_7295_ = true;
                                                                    }
                                                                    let _e2984 = phi_7295_;
                                                                    phi_7296_ = _e2984;
                                                                } else {
                                                                    phi_7296_ = true;
                                                                }
                                                                let _e2986 = phi_7296_;
                                                                if _e2986 {
                                                                    let _e2987 = (_e2977 >= _e2974);
                                                                    if _e2987 {
                                                                        phi_7318_ = f32();
                                                                        phi_7319_ = false;
                                                                    } else {
                                                                        if ((_e2974 - _e2977) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7316_ = (((_e2974 - _e2980) / (_e2974 - _e2977)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7317_ = false;
                                                                        } else {
                                                                            phi_7316_ = f32();
                                                                            phi_7317_ = true;
                                                                        }
                                                                        let _e2998 = phi_7316_;
                                                                        let _e3000 = phi_7317_;
                                                                        phi_7318_ = _e2998;
                                                                        phi_7319_ = _e3000;
                                                                    }
                                                                    let _e3002 = phi_7318_;
                                                                    let _e3004 = phi_7319_;
                                                                    phi_7320_ = _e3002;
                                                                    phi_7321_ = _e2987;
                                                                    phi_7322_ = _e3004;
                                                                } else {
                                                                    phi_7320_ = f32();
                                                                    phi_7321_ = true;
                                                                    phi_7322_ = false;
                                                                }
                                                                let _e3006 = phi_7320_;
                                                                let _e3008 = phi_7321_;
                                                                let _e3010 = phi_7322_;
                                                                if _e3008 {
                                                                    phi_7326_ = 2f;
                                                                    phi_7327_ = true;
                                                                } else {
                                                                    phi_7326_ = _e2346;
                                                                    phi_7327_ = _e3010;
                                                                }
                                                                let _e3012 = phi_7326_;
                                                                let _e3014 = phi_7327_;
                                                                if _e3014 {
                                                                    phi_7331_ = _e3012;
                                                                } else {
                                                                    phi_7331_ = _e3006;
                                                                }
                                                                let _e3016 = phi_7331_;
                                                                if (_e2971 < _e3016) {
                                                                    phi_7336_ = _e2971;
                                                                } else {
                                                                    phi_7336_ = _e3016;
                                                                }
                                                                let _e3019 = phi_7336_;
                                                                let _e3022 = local.member[2u];
                                                                let _e3025 = local.member_1[2u];
                                                                let _e3028 = local.member_2[2u];
                                                                if (_e3022 > _e3028) {
                                                                    if (_e3025 > _e3028) {
                                                                        phi_7368_ = false;
                                                                    } else {
                                                                        phi_7368_ = true;
                                                                    }
                                                                    let _e3032 = phi_7368_;
                                                                    phi_7369_ = _e3032;
                                                                } else {
                                                                    phi_7369_ = true;
                                                                }
                                                                let _e3034 = phi_7369_;
                                                                if _e3034 {
                                                                    let _e3035 = (_e3025 >= _e3022);
                                                                    if _e3035 {
                                                                        phi_7391_ = f32();
                                                                        phi_7392_ = false;
                                                                    } else {
                                                                        if ((_e3022 - _e3025) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7389_ = (((_e3022 - _e3028) / (_e3022 - _e3025)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7390_ = false;
                                                                        } else {
                                                                            phi_7389_ = f32();
                                                                            phi_7390_ = true;
                                                                        }
                                                                        let _e3046 = phi_7389_;
                                                                        let _e3048 = phi_7390_;
                                                                        phi_7391_ = _e3046;
                                                                        phi_7392_ = _e3048;
                                                                    }
                                                                    let _e3050 = phi_7391_;
                                                                    let _e3052 = phi_7392_;
                                                                    phi_7393_ = _e3050;
                                                                    phi_7394_ = _e3035;
                                                                    phi_7395_ = _e3052;
                                                                } else {
                                                                    phi_7393_ = f32();
                                                                    phi_7394_ = true;
                                                                    phi_7395_ = false;
                                                                }
                                                                let _e3054 = phi_7393_;
                                                                let _e3056 = phi_7394_;
                                                                let _e3058 = phi_7395_;
                                                                if _e3056 {
                                                                    phi_7399_ = 2f;
                                                                    phi_7400_ = true;
                                                                } else {
                                                                    phi_7399_ = _e2346;
                                                                    phi_7400_ = _e3058;
                                                                }
                                                                let _e3060 = phi_7399_;
                                                                let _e3062 = phi_7400_;
                                                                if _e3062 {
                                                                    phi_7404_ = _e3060;
                                                                } else {
                                                                    phi_7404_ = _e3054;
                                                                }
                                                                let _e3064 = phi_7404_;
                                                                let _e3067 = local.member[3u];
                                                                let _e3070 = local.member_1[3u];
                                                                let _e3073 = local.member_2[3u];
                                                                if (_e3067 > _e3073) {
                                                                    if (_e3070 > _e3073) {
                                                                        phi_7436_ = false;
                                                                    } else {
                                                                        phi_7436_ = true;
                                                                    }
                                                                    let _e3077 = phi_7436_;
                                                                    phi_7437_ = _e3077;
                                                                } else {
                                                                    phi_7437_ = true;
                                                                }
                                                                let _e3079 = phi_7437_;
                                                                if _e3079 {
                                                                    let _e3080 = (_e3070 >= _e3067);
                                                                    if _e3080 {
                                                                        phi_7459_ = f32();
                                                                        phi_7460_ = false;
                                                                    } else {
                                                                        if ((_e3067 - _e3070) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7457_ = (((_e3067 - _e3073) / (_e3067 - _e3070)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7458_ = false;
                                                                        } else {
                                                                            phi_7457_ = f32();
                                                                            phi_7458_ = true;
                                                                        }
                                                                        let _e3091 = phi_7457_;
                                                                        let _e3093 = phi_7458_;
                                                                        phi_7459_ = _e3091;
                                                                        phi_7460_ = _e3093;
                                                                    }
                                                                    let _e3095 = phi_7459_;
                                                                    let _e3097 = phi_7460_;
                                                                    phi_7461_ = _e3095;
                                                                    phi_7462_ = _e3080;
                                                                    phi_7463_ = _e3097;
                                                                } else {
                                                                    phi_7461_ = f32();
                                                                    phi_7462_ = true;
                                                                    phi_7463_ = false;
                                                                }
                                                                let _e3099 = phi_7461_;
                                                                let _e3101 = phi_7462_;
                                                                let _e3103 = phi_7463_;
                                                                if _e3101 {
                                                                    phi_7467_ = 2f;
                                                                    phi_7468_ = true;
                                                                } else {
                                                                    phi_7467_ = _e2346;
                                                                    phi_7468_ = _e3103;
                                                                }
                                                                let _e3105 = phi_7467_;
                                                                let _e3107 = phi_7468_;
                                                                if _e3107 {
                                                                    phi_7472_ = _e3105;
                                                                } else {
                                                                    phi_7472_ = _e3099;
                                                                }
                                                                let _e3109 = phi_7472_;
                                                                if (_e3064 < _e3109) {
                                                                    phi_7477_ = _e3064;
                                                                } else {
                                                                    phi_7477_ = _e3109;
                                                                }
                                                                let _e3112 = phi_7477_;
                                                                if (_e3019 < _e3112) {
                                                                    phi_7482_ = _e3019;
                                                                } else {
                                                                    phi_7482_ = _e3112;
                                                                }
                                                                let _e3115 = phi_7482_;
                                                                if (_e3115 > _e2346) {
                                                                    phi_7487_ = _e3115;
                                                                } else {
                                                                    phi_7487_ = _e2346;
                                                                }
                                                                let _e3118 = phi_7487_;
                                                                let _e3119 = (_e3118 > _e1393.member_1);
                                                                if _e3119 {
                                                                    phi_7498_ = f32();
                                                                    phi_7499_ = false;
                                                                } else {
                                                                    if _e2352 {
                                                                        phi_7497_ = (_e2666 + _e2666);
                                                                    } else {
                                                                        phi_7497_ = (_e1393.member_1 - _e2346);
                                                                    }
                                                                    let _e3123 = phi_7497_;
                                                                    phi_7498_ = _e3123;
                                                                    phi_7499_ = true;
                                                                }
                                                                let _e3125 = phi_7498_;
                                                                let _e3127 = phi_7499_;
                                                                phi_7500_ = _e3118;
                                                                phi_7501_ = _e3125;
                                                                phi_7502_ = _e3127;
                                                                phi_7503_ = _e3119;
                                                                phi_7504_ = false;
                                                            } else {
                                                                phi_7500_ = f32();
                                                                phi_7501_ = f32();
                                                                phi_7502_ = false;
                                                                phi_7503_ = false;
                                                                phi_7504_ = true;
                                                            }
                                                            let _e3129 = phi_7500_;
                                                            let _e3131 = phi_7501_;
                                                            let _e3133 = phi_7502_;
                                                            let _e3135 = phi_7503_;
                                                            let _e3137 = phi_7504_;
                                                            phi_7505_ = _e3129;
                                                            phi_7506_ = _e3131;
                                                            phi_7507_ = false;
                                                            phi_7508_ = _e3133;
                                                            phi_7509_ = _e3135;
                                                            phi_7510_ = _e3137;
                                                        } else {
                                                            phi_7505_ = f32();
                                                            phi_7506_ = f32();
                                                            phi_7507_ = true;
                                                            phi_7508_ = false;
                                                            phi_7509_ = false;
                                                            phi_7510_ = false;
                                                        }
                                                        let _e3139 = phi_7505_;
                                                        let _e3141 = phi_7506_;
                                                        let _e3143 = phi_7507_;
                                                        let _e3145 = phi_7508_;
                                                        let _e3147 = phi_7509_;
                                                        let _e3149 = phi_7510_;
                                                        phi_7511_ = _e3139;
                                                        phi_7512_ = _e3141;
                                                        phi_7513_ = _e3143;
                                                        phi_7514_ = _e3145;
                                                        phi_7515_ = _e3147;
                                                        phi_7516_ = _e3149;
                                                    } else {
                                                        phi_7511_ = f32();
                                                        phi_7512_ = f32();
                                                        phi_7513_ = true;
                                                        phi_7514_ = false;
                                                        phi_7515_ = false;
                                                        phi_7516_ = false;
                                                    }
                                                    let _e3151 = phi_7511_;
                                                    let _e3153 = phi_7512_;
                                                    let _e3155 = phi_7513_;
                                                    let _e3157 = phi_7514_;
                                                    let _e3159 = phi_7515_;
                                                    let _e3161 = phi_7516_;
                                                    if _e3155 {
                                                        if (_e2346 <= _e2348) {
                                                            let _e3322 = (_e2354 + 1u);
                                                            let _e3323 = (_e3322 > 3u);
                                                            if _e3323 {
                                                                phi_7529_ = false;
                                                            } else {
                                                                phi_7529_ = true;
                                                            }
                                                            let _e3325 = phi_7529_;
                                                            phi_7851_ = _e3322;
                                                            phi_7852_ = f32();
                                                            phi_7853_ = false;
                                                            phi_7854_ = _e3325;
                                                            phi_7855_ = _e3323;
                                                        } else {
                                                            let _e3165 = local.member[0u];
                                                            let _e3168 = local.member_1[0u];
                                                            let _e3171 = local.member[0u];
                                                            let _e3177 = local.member_2[0u];
                                                            let _e3178 = ((_e3165 + ((_e3168 - _e3171) * _e2350)) - _e3177);
                                                            let _e3181 = local.member[1u];
                                                            let _e3184 = local.member_1[1u];
                                                            let _e3187 = local.member[1u];
                                                            let _e3193 = local.member_2[1u];
                                                            let _e3194 = ((_e3181 + ((_e3184 - _e3187) * _e2350)) - _e3193);
                                                            if (_e3178 < _e3194) {
                                                                phi_7602_ = _e3178;
                                                            } else {
                                                                phi_7602_ = _e3194;
                                                            }
                                                            let _e3197 = phi_7602_;
                                                            let _e3200 = local.member[2u];
                                                            let _e3203 = local.member_1[2u];
                                                            let _e3206 = local.member[2u];
                                                            let _e3212 = local.member_2[2u];
                                                            let _e3213 = ((_e3200 + ((_e3203 - _e3206) * _e2350)) - _e3212);
                                                            let _e3216 = local.member[3u];
                                                            let _e3219 = local.member_1[3u];
                                                            let _e3222 = local.member[3u];
                                                            let _e3228 = local.member_2[3u];
                                                            let _e3229 = ((_e3216 + ((_e3219 - _e3222) * _e2350)) - _e3228);
                                                            if (_e3213 < _e3229) {
                                                                phi_7675_ = _e3213;
                                                            } else {
                                                                phi_7675_ = _e3229;
                                                            }
                                                            let _e3232 = phi_7675_;
                                                            if (_e3197 < _e3232) {
                                                                phi_7680_ = _e3197;
                                                            } else {
                                                                phi_7680_ = _e3232;
                                                            }
                                                            let _e3235 = phi_7680_;
                                                            let _e3238 = local_1.member[0u];
                                                            let _e3241 = local_1.member_1[0u];
                                                            let _e3244 = local_1.member[0u];
                                                            let _e3250 = local_1.member_2[0u];
                                                            let _e3251 = ((_e3238 + ((_e3241 - _e3244) * _e2346)) - _e3250);
                                                            let _e3254 = local_1.member[1u];
                                                            let _e3257 = local_1.member_1[1u];
                                                            let _e3260 = local_1.member[1u];
                                                            let _e3266 = local_1.member_2[1u];
                                                            let _e3267 = ((_e3254 + ((_e3257 - _e3260) * _e2346)) - _e3266);
                                                            if (_e3251 < _e3267) {
                                                                phi_7753_ = _e3251;
                                                            } else {
                                                                phi_7753_ = _e3267;
                                                            }
                                                            let _e3270 = phi_7753_;
                                                            let _e3273 = local_1.member[2u];
                                                            let _e3276 = local_1.member_1[2u];
                                                            let _e3279 = local_1.member[2u];
                                                            let _e3285 = local_1.member_2[2u];
                                                            let _e3286 = ((_e3273 + ((_e3276 - _e3279) * _e2346)) - _e3285);
                                                            let _e3289 = local_1.member[3u];
                                                            let _e3292 = local_1.member_1[3u];
                                                            let _e3295 = local_1.member[3u];
                                                            let _e3301 = local_1.member_2[3u];
                                                            let _e3302 = ((_e3289 + ((_e3292 - _e3295) * _e2346)) - _e3301);
                                                            if (_e3286 < _e3302) {
                                                                phi_7826_ = _e3286;
                                                            } else {
                                                                phi_7826_ = _e3302;
                                                            }
                                                            let _e3305 = phi_7826_;
                                                            if (_e3270 < _e3305) {
                                                                phi_7831_ = _e3270;
                                                            } else {
                                                                phi_7831_ = _e3305;
                                                            }
                                                            let _e3308 = phi_7831_;
                                                            if (_e3308 > 0f) {
                                                                phi_7849_ = 0.5f;
                                                            } else {
                                                                let _e3312 = (0.95f * (_e3235 / (_e3235 - _e3308)));
                                                                if (_e3312 > 0.0625f) {
                                                                    if (_e3312 < 0.9f) {
                                                                        phi_7847_ = _e3312;
                                                                    } else {
                                                                        phi_7847_ = 0.9f;
                                                                    }
                                                                    let _e3316 = phi_7847_;
                                                                    phi_7848_ = _e3316;
                                                                } else {
                                                                    phi_7848_ = 0.0625f;
                                                                }
                                                                let _e3318 = phi_7848_;
                                                                phi_7849_ = _e3318;
                                                            }
                                                            let _e3320 = phi_7849_;
                                                            phi_7851_ = u32();
                                                            phi_7852_ = (_e2666 * _e3320);
                                                            phi_7853_ = true;
                                                            phi_7854_ = false;
                                                            phi_7855_ = false;
                                                        }
                                                        let _e3327 = phi_7851_;
                                                        let _e3329 = phi_7852_;
                                                        let _e3331 = phi_7853_;
                                                        let _e3333 = phi_7854_;
                                                        let _e3335 = phi_7855_;
                                                        phi_7856_ = _e3327;
                                                        phi_7857_ = _e2348;
                                                        phi_7858_ = _e3329;
                                                        phi_7859_ = _e2350;
                                                        phi_7860_ = _e2352;
                                                        phi_7861_ = _e2354;
                                                        phi_7862_ = _e3331;
                                                        phi_7863_ = _e3333;
                                                        phi_7864_ = _e3335;
                                                        phi_7865_ = false;
                                                        phi_7866_ = false;
                                                    } else {
                                                        phi_7856_ = u32();
                                                        phi_7857_ = _e3151;
                                                        phi_7858_ = _e3153;
                                                        phi_7859_ = _e2346;
                                                        phi_7860_ = true;
                                                        phi_7861_ = 0u;
                                                        phi_7862_ = _e3157;
                                                        phi_7863_ = false;
                                                        phi_7864_ = false;
                                                        phi_7865_ = _e3159;
                                                        phi_7866_ = _e3161;
                                                    }
                                                    let _e3337 = phi_7856_;
                                                    let _e3339 = phi_7857_;
                                                    let _e3341 = phi_7858_;
                                                    let _e3343 = phi_7859_;
                                                    let _e3345 = phi_7860_;
                                                    let _e3347 = phi_7861_;
                                                    let _e3349 = phi_7862_;
                                                    let _e3351 = phi_7863_;
                                                    let _e3353 = phi_7864_;
                                                    let _e3355 = phi_7865_;
                                                    let _e3357 = phi_7866_;
                                                    if _e3349 {
                                                        let _e3358 = (_e3343 + _e3341);
                                                        if (_e3358 > _e3339) {
                                                            phi_7875_ = _e3358;
                                                        } else {
                                                            phi_7875_ = _e3339;
                                                        }
                                                        let _e3361 = phi_7875_;
                                                        if (_e3361 < _e1393.member_1) {
                                                            phi_7880_ = _e3361;
                                                        } else {
                                                            phi_7880_ = _e1393.member_1;
                                                        }
                                                        let _e3364 = phi_7880_;
                                                        if !(_e2352) {
                                                            phi_7889_ = true;
                                                        } else {
                                                            phi_7889_ = ((_e3364 - _e3343) > 0.0000000037252903f);
                                                        }
                                                        let _e3368 = phi_7889_;
                                                        if _e3368 {
                                                            phi_7893_ = false;
                                                        } else {
                                                            phi_7893_ = true;
                                                        }
                                                        let _e3370 = phi_7893_;
                                                        phi_7894_ = _e3364;
                                                        phi_7895_ = _e3339;
                                                        phi_7896_ = _e3343;
                                                        phi_7897_ = _e3345;
                                                        phi_7898_ = _e3347;
                                                        phi_7899_ = _e3368;
                                                        phi_7900_ = _e3370;
                                                        phi_7901_ = false;
                                                        phi_7902_ = false;
                                                        phi_7903_ = false;
                                                    } else {
                                                        phi_7894_ = _e2346;
                                                        phi_7895_ = _e2348;
                                                        phi_7896_ = _e2350;
                                                        phi_7897_ = _e2352;
                                                        phi_7898_ = _e3337;
                                                        phi_7899_ = _e3351;
                                                        phi_7900_ = false;
                                                        phi_7901_ = _e3353;
                                                        phi_7902_ = _e3355;
                                                        phi_7903_ = _e3357;
                                                    }
                                                    let _e3372 = phi_7894_;
                                                    let _e3374 = phi_7895_;
                                                    let _e3376 = phi_7896_;
                                                    let _e3378 = phi_7897_;
                                                    let _e3380 = phi_7898_;
                                                    let _e3382 = phi_7899_;
                                                    let _e3384 = phi_7900_;
                                                    let _e3386 = phi_7901_;
                                                    let _e3388 = phi_7902_;
                                                    let _e3390 = phi_7903_;
                                                    phi_6236_ = _e3372;
                                                    phi_6238_ = _e3374;
                                                    phi_6240_ = _e3376;
                                                    phi_6242_ = _e3378;
                                                    phi_6244_ = _e3380;
                                                    phi_7904_ = _e3339;
                                                    phi_7905_ = _e3382;
                                                    phi_7906_ = _e3384;
                                                    phi_7907_ = false;
                                                    phi_7908_ = _e3386;
                                                    phi_7909_ = _e3388;
                                                    phi_7910_ = _e3390;
                                                } else {
                                                    phi_6236_ = f32();
                                                    phi_6238_ = f32();
                                                    phi_6240_ = f32();
                                                    phi_6242_ = bool();
                                                    phi_6244_ = u32();
                                                    phi_7904_ = f32();
                                                    phi_7905_ = false;
                                                    phi_7906_ = false;
                                                    phi_7907_ = true;
                                                    phi_7908_ = false;
                                                    phi_7909_ = false;
                                                    phi_7910_ = false;
                                                }
                                                let _e3392 = phi_6236_;
                                                let _e3394 = phi_6238_;
                                                let _e3396 = phi_6240_;
                                                let _e3398 = phi_6242_;
                                                let _e3400 = phi_6244_;
                                                let _e3402 = phi_7904_;
                                                let _e3404 = phi_7905_;
                                                let _e3406 = phi_7906_;
                                                let _e3408 = phi_7907_;
                                                let _e3410 = phi_7908_;
                                                let _e3412 = phi_7909_;
                                                let _e3414 = phi_7910_;
                                                local_19 = _e3406;
                                                local_35 = _e3402;
                                                local_37 = _e3408;
                                                local_38 = _e3410;
                                                local_39 = _e3412;
                                                local_40 = _e3414;
                                                continue;
                                                continuing {
                                                    phi_6232_ = _e2366;
                                                    phi_6235_ = _e3392;
                                                    phi_6237_ = _e3394;
                                                    phi_6239_ = _e3396;
                                                    phi_6241_ = _e3398;
                                                    phi_6243_ = _e3400;
                                                    break if !(_e3404);
                                                }
                                            }
                                            let _e3417 = local_19;
                                            if _e3417 {
                                                let _e5910 = local_35;
                                                phi_7914_ = _e5910;
                                                phi_7915_ = true;
                                                phi_7916_ = false;
                                                phi_7917_ = false;
                                                phi_7918_ = false;
                                            } else {
                                                let _e5912 = local_36;
                                                phi_7914_ = _e5912;
                                                let _e5915 = local_37;
                                                phi_7915_ = _e5915;
                                                let _e5918 = local_38;
                                                phi_7916_ = _e5918;
                                                let _e5921 = local_39;
                                                phi_7917_ = _e5921;
                                                let _e5924 = local_40;
                                                phi_7918_ = _e5924;
                                            }
                                            let _e3419 = phi_7914_;
                                            let _e3421 = phi_7915_;
                                            let _e3423 = phi_7916_;
                                            let _e3425 = phi_7917_;
                                            let _e3427 = phi_7918_;
                                            if _e3421 {
                                                phi_7923_ = type_35(1u, _e3419);
                                                phi_7924_ = false;
                                                phi_7925_ = false;
                                                phi_7926_ = false;
                                            } else {
                                                phi_7923_ = type_35();
                                                phi_7924_ = _e3423;
                                                phi_7925_ = _e3425;
                                                phi_7926_ = _e3427;
                                            }
                                            let _e3430 = phi_7923_;
                                            let _e3432 = phi_7924_;
                                            let _e3434 = phi_7925_;
                                            let _e3436 = phi_7926_;
                                            if _e3432 {
                                                let _e3438 = local_20;
                                                phi_7931_ = type_35(1u, _e3438);
                                                phi_7932_ = false;
                                                phi_7933_ = false;
                                            } else {
                                                phi_7931_ = type_35();
                                                phi_7932_ = _e3434;
                                                phi_7933_ = _e3436;
                                            }
                                            let _e3441 = phi_7931_;
                                            let _e3443 = phi_7932_;
                                            let _e3445 = phi_7933_;
                                            if _e3443 {
                                                phi_7938_ = type_35(0u, type_35().member_1);
                                                phi_7939_ = false;
                                                phi_7940_ = true;
                                            } else {
                                                phi_7938_ = _e3441;
                                                phi_7939_ = _e3445;
                                                phi_7940_ = _e3432;
                                            }
                                            let _e3449 = phi_7938_;
                                            let _e3451 = phi_7939_;
                                            let _e3453 = phi_7940_;
                                            if _e3451 {
                                                phi_7945_ = type_35(0u, type_35().member_1);
                                                phi_7946_ = true;
                                            } else {
                                                phi_7945_ = _e3449;
                                                phi_7946_ = _e3453;
                                            }
                                            let _e3457 = phi_7945_;
                                            let _e3459 = phi_7946_;
                                            if _e3459 {
                                                phi_7950_ = _e3457;
                                            } else {
                                                phi_7950_ = _e3430;
                                            }
                                            let _e3461 = phi_7950_;
                                            let _e3464 = (_e3461.member != 0u);
                                            if _e3464 {
                                                phi_7957_ = false;
                                            } else {
                                                phi_7957_ = true;
                                            }
                                            let _e3466 = phi_7957_;
                                            phi_7958_ = _e3461.member_1;
                                            phi_7959_ = _e3466;
                                            phi_7960_ = _e3464;
                                            phi_7961_ = false;
                                        } else {
                                            phi_7958_ = f32();
                                            phi_7959_ = false;
                                            phi_7960_ = false;
                                            phi_7961_ = true;
                                        }
                                        let _e3468 = phi_7958_;
                                        let _e3470 = phi_7959_;
                                        let _e3472 = phi_7960_;
                                        let _e3474 = phi_7961_;
                                        phi_7962_ = _e3468;
                                        phi_7963_ = _e3470;
                                        phi_7964_ = _e3472;
                                        phi_7965_ = _e3474;
                                    }
                                    let _e3476 = phi_7962_;
                                    let _e3478 = phi_7963_;
                                    let _e3480 = phi_7964_;
                                    let _e3482 = phi_7965_;
                                    phi_7966_ = _e3476;
                                    phi_7967_ = _e2102;
                                    phi_7968_ = _e3478;
                                    phi_7969_ = _e3480;
                                    phi_7970_ = _e3482;
                                }
                                let _e3484 = phi_7966_;
                                let _e3486 = phi_7967_;
                                let _e3488 = phi_7968_;
                                let _e3490 = phi_7969_;
                                let _e3492 = phi_7970_;
                                if _e3486 {
                                    phi_7974_ = true;
                                    phi_7975_ = false;
                                    phi_7976_ = false;
                                } else {
                                    phi_7974_ = _e3488;
                                    phi_7975_ = _e3490;
                                    phi_7976_ = _e3492;
                                }
                                let _e3494 = phi_7974_;
                                let _e3496 = phi_7975_;
                                let _e3498 = phi_7976_;
                                phi_7977_ = _e3484;
                                phi_7978_ = _e1393;
                                phi_7979_ = _e3494;
                                phi_7980_ = false;
                                phi_7981_ = _e3496;
                                phi_7982_ = _e3498;
                            } else {
                                phi_7977_ = f32();
                                phi_7978_ = type_37();
                                phi_7979_ = false;
                                phi_7980_ = true;
                                phi_7981_ = false;
                                phi_7982_ = false;
                            }
                            let _e3500 = phi_7977_;
                            let _e3502 = phi_7978_;
                            let _e3504 = phi_7979_;
                            let _e3506 = phi_7980_;
                            let _e3508 = phi_7981_;
                            let _e3510 = phi_7982_;
                            local_21 = _e3506;
                            local_41 = _e3508;
                            local_42 = _e3510;
                            local_22 = _e3500;
                            local_23 = _e3502;
                            continue;
                            continuing {
                                phi_4369_ = _e1123;
                                break if !(_e3504);
                            }
                        }
                        let _e3513 = local_21;
                        if _e3513 {
                            phi_7987_ = type_35(0u, type_35().member_1);
                            phi_7988_ = false;
                            phi_7989_ = false;
                        } else {
                            phi_7987_ = type_35();
                            let _e5966 = local_41;
                            phi_7988_ = _e5966;
                            let _e5969 = local_42;
                            phi_7989_ = _e5969;
                        }
                        let _e3517 = phi_7987_;
                        let _e3519 = phi_7988_;
                        let _e3521 = phi_7989_;
                        if _e3519 {
                            let _e3523 = local_22;
                            phi_7994_ = type_35(2u, _e3523);
                            phi_7995_ = false;
                        } else {
                            phi_7994_ = type_35();
                            phi_7995_ = _e3521;
                        }
                        let _e3526 = phi_7994_;
                        let _e3528 = phi_7995_;
                        if _e3528 {
                            let _e3530 = local_23;
                            phi_8001_ = type_35(1u, _e3530.member);
                            phi_8002_ = true;
                        } else {
                            phi_8001_ = _e3526;
                            phi_8002_ = _e3519;
                        }
                        let _e3534 = phi_8001_;
                        let _e3536 = phi_8002_;
                        if _e3536 {
                            phi_8006_ = _e3534;
                        } else {
                            phi_8006_ = _e3517;
                        }
                        let _e3538 = phi_8006_;
                        phi_8010_ = _e3538;
                    }
                    let _e5259 = phi_8010_;
                    phi_8011_ = _e5259;
                }
                let _e5263 = phi_8011_;
                switch bitcast<i32>(_e5263.member) {
                    case 0: {
                        phi_8024_ = type_38(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5269 = function_(_e5263.member_1);
                        phi_8024_ = type_38(0u, _e5269, true);
                        break;
                    }
                    case 2: {
                        let _e5267 = function_(_e5263.member_1);
                        phi_8024_ = type_38(1u, _e5267, true);
                        break;
                    }
                    default: {
                        phi_8024_ = type_38();
                        break;
                    }
                }
                let _e5272 = phi_8024_;
                if _e5272.member_2 {
                    phi_8031_ = (_e5272.member == 0u);
                } else {
                    phi_8031_ = false;
                }
                let _e5277 = phi_8031_;
                if _e5277 {
                    let _e5285 = (_e5272.member_1[1] >> bitcast<u32>(20i));
                    if (_e5285 <= 896u) {
                        phi_8055_ = 0u;
                    } else {
                        phi_8055_ = ((((_e5285 - 896u) << bitcast<u32>(23i)) | ((_e5272.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5272.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5300 = phi_8055_;
                    let _e5302 = atomicMin((&earliest.member[0u]), _e5300);
                }
                phi_8059_ = type_20(1u, 0u, _e176, _e179, _e5272.member_1);
                phi_8060_ = _e5277;
                phi_8061_ = (_e5272.member != 0u);
            } else {
                phi_8059_ = type_20(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8060_ = false;
                phi_8061_ = false;
            }
            let _e5304 = phi_8059_;
            let _e5306 = phi_8060_;
            let _e5308 = phi_8061_;
            let _e5311 = params.member.member.member_1;
            if ((_e5311 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5306 {
                    let _e5317 = atomicAdd((&counters[0u]), 1u);
                    phi_8080_ = _e5317;
                } else {
                    phi_8080_ = 0u;
                }
                let _e5319 = phi_8080_;
                workgroupBarrier();
                if (_e105 == 0u) {
                    let _e5322 = atomicLoad((&counters[0u]));
                    if (_e5322 > 0u) {
                        let _e5325 = atomicAdd((&contacts.member[0u]), _e5322);
                        atomicStore((&counters[1u]), _e5325);
                    }
                }
                workgroupBarrier();
                let _e5328 = atomicLoad((&counters[1u]));
                let _e5329 = (_e5328 + _e5319);
                if _e5306 {
                    let _e5332 = params.member.member_1.member_3;
                    if (_e5329 < _e5332) {
                        let _e5334 = (6u * _e5329);
                        atomicStore((&contacts.member[(4u + _e5334)]), _e5304.member);
                        atomicStore((&contacts.member[(_e5334 + 5u)]), _e5304.member_1);
                        atomicStore((&contacts.member[(_e5334 + 6u)]), _e5304.member_2);
                        atomicStore((&contacts.member[(_e5334 + 7u)]), _e5304.member_3);
                        atomicStore((&contacts.member[(_e5334 + 8u)]), _e5304.member_4[0]);
                        atomicStore((&contacts.member[(_e5334 + 9u)]), _e5304.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5308 {
                let _e5358 = atomicAdd((&counters[0u]), 1u);
                phi_8143_ = _e5358;
            } else {
                phi_8143_ = 0u;
            }
            let _e5360 = phi_8143_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5363 = atomicLoad((&counters[0u]));
                if (_e5363 > 0u) {
                    let _e5366 = atomicAdd((&undecided.member[0u]), _e5363);
                    atomicStore((&counters[1u]), _e5366);
                }
            }
            workgroupBarrier();
            let _e5369 = atomicLoad((&counters[1u]));
            let _e5370 = (_e5369 + _e5360);
            if _e5308 {
                let _e5373 = params.member.member_2.member;
                if (_e5370 < _e5373) {
                    let _e5377 = (2u * _e5370);
                    atomicStore((&undecided.member[(4u + _e5377)]), _e5304.member_2);
                    atomicStore((&undecided.member[(_e5377 + 5u)]), _e5304.member_3);
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
