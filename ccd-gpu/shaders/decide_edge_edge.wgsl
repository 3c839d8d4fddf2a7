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

struct type_28 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_29 {
    member: f32,
    member_1: f32,
}

struct type_32 {
    member: type_26,
    member_1: f32,
}

struct type_33 {
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

@group(0) @binding(0) 
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> paths: type_23;
@group(0) @binding(2) 
var<storage> elements: type_14;
@group(0) @binding(3) 
var<storage> input: type_12;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_39;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_39;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_39;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(param: f32) -> array<u32, 2> {
    var phi_8623_: array<u32, 2>;
    var phi_8624_: array<u32, 2>;
    var phi_8625_: bool;
    var phi_8629_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_8624_ = array<u32, 2>();
        phi_8625_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_8623_ = array<u32, 2>();
        } else {
            phi_8623_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_8623_;
        phi_8624_ = _e31;
        phi_8625_ = _e17;
    }
    let _e33 = phi_8624_;
    let _e35 = phi_8625_;
    if _e35 {
        phi_8629_ = array<u32, 2>(0u, 0u);
    } else {
        phi_8629_ = _e33;
    }
    let _e37 = phi_8629_;
    return _e37;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_8602_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_8602_ = param_2;
    } else {
        phi_8602_ = param_1;
    }
    let _e26 = phi_8602_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_8194_: bool;
    var phi_8195_: bool;
    var phi_8196_: bool;
    var phi_8197_: bool;
    var phi_8201_: bool;
    var phi_8174_: bool;
    var phi_8175_: bool;
    var phi_8176_: bool;
    var phi_8177_: bool;
    var phi_8178_: bool;
    var phi_8179_: bool;
    var phi_8183_: bool;
    var phi_8202_: bool;
    var phi_8232_: array<f32, 3>;
    var phi_8233_: bool;
    var phi_8234_: array<f32, 3>;
    var phi_8235_: bool;
    var phi_8462_: f32;
    var phi_8463_: f32;
    var phi_8502_: f32;
    var phi_8503_: f32;
    var phi_8548_: f32;
    var phi_8549_: f32;
    var phi_8283_: f32;
    var phi_8284_: f32;
    var phi_8329_: f32;
    var phi_8330_: f32;
    var phi_8372_: f32;
    var phi_8373_: f32;
    var phi_8421_: f32;
    var phi_8422_: f32;
    var phi_8564_: array<array<f32, 3>, 4>;
    var phi_8572_: array<f32, 3>;

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
                    phi_8174_ = (_e76 <= 1f);
                    phi_8175_ = false;
                } else {
                    phi_8174_ = bool();
                    phi_8175_ = true;
                }
                let _e97 = phi_8174_;
                let _e99 = phi_8175_;
                phi_8176_ = _e97;
                phi_8177_ = _e99;
            } else {
                phi_8176_ = bool();
                phi_8177_ = true;
            }
            let _e101 = phi_8176_;
            let _e103 = phi_8177_;
            phi_8178_ = _e101;
            phi_8179_ = _e103;
        } else {
            phi_8178_ = bool();
            phi_8179_ = true;
        }
        let _e105 = phi_8178_;
        let _e107 = phi_8179_;
        if _e107 {
            phi_8183_ = false;
        } else {
            phi_8183_ = _e105;
        }
        let _e109 = phi_8183_;
        phi_8202_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_8194_ = ((_e72 + _e76) <= 1f);
                phi_8195_ = false;
            } else {
                phi_8194_ = bool();
                phi_8195_ = true;
            }
            let _e83 = phi_8194_;
            let _e85 = phi_8195_;
            phi_8196_ = _e83;
            phi_8197_ = _e85;
        } else {
            phi_8196_ = bool();
            phi_8197_ = true;
        }
        let _e87 = phi_8196_;
        let _e89 = phi_8197_;
        if _e89 {
            phi_8201_ = false;
        } else {
            phi_8201_ = _e87;
        }
        let _e91 = phi_8201_;
        phi_8202_ = _e91;
    }
    let _e111 = phi_8202_;
    if (_e68 > 0f) {
        if _e111 {
            phi_8232_ = array<f32, 3>((param_3[0] - ((param_4[0] * _e72) + (param_5[0] * _e76))), (param_3[1] - ((param_4[1] * _e72) + (param_5[1] * _e76))), (param_3[2] - ((param_4[2] * _e72) + (param_5[2] * _e76))));
            phi_8233_ = false;
        } else {
            phi_8232_ = array<f32, 3>();
            phi_8233_ = true;
        }
        let _e136 = phi_8232_;
        let _e138 = phi_8233_;
        phi_8234_ = _e136;
        phi_8235_ = _e138;
    } else {
        phi_8234_ = array<f32, 3>();
        phi_8235_ = true;
    }
    let _e140 = phi_8234_;
    let _e142 = phi_8235_;
    if _e142 {
        let _e145 = (param_3[0] - param_4[0]);
        let _e148 = (param_3[1] - param_4[1]);
        let _e151 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e293 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_8283_ = _e293;
                } else {
                    phi_8283_ = 1f;
                }
                let _e297 = phi_8283_;
                phi_8284_ = _e297;
            } else {
                phi_8284_ = 0f;
            }
            let _e299 = phi_8284_;
            let _e335 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_8329_ = _e335;
                } else {
                    phi_8329_ = 1f;
                }
                let _e339 = phi_8329_;
                phi_8330_ = _e339;
            } else {
                phi_8330_ = 0f;
            }
            let _e341 = phi_8330_;
            let _e374 = ((((_e145 * param_5[0]) + (_e148 * param_5[1])) + (_e151 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_8372_ = _e374;
                } else {
                    phi_8372_ = 1f;
                }
                let _e378 = phi_8372_;
                phi_8373_ = _e378;
            } else {
                phi_8373_ = 0f;
            }
            let _e380 = phi_8373_;
            let _e393 = (param_3[0] - param_5[0]);
            let _e396 = (param_3[1] - param_5[1]);
            let _e399 = (param_3[2] - param_5[2]);
            let _e419 = ((((_e393 * param_4[0]) + (_e396 * param_4[1])) + (_e399 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_8421_ = _e419;
                } else {
                    phi_8421_ = 1f;
                }
                let _e423 = phi_8421_;
                phi_8422_ = _e423;
            } else {
                phi_8422_ = 0f;
            }
            let _e425 = phi_8422_;
            phi_8564_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e299)), (param_3[1] - (param_4[1] * _e299)), (param_3[2] - (param_4[2] * _e299))), array<f32, 3>((param_3[0] - (param_5[0] * _e341)), (param_3[1] - (param_5[1] * _e341)), (param_3[2] - (param_5[2] * _e341))), array<f32, 3>((_e145 - (param_5[0] * _e380)), (_e148 - (param_5[1] * _e380)), (_e151 - (param_5[2] * _e380))), array<f32, 3>((_e393 - (param_4[0] * _e425)), (_e396 - (param_4[1] * _e425)), (_e399 - (param_4[2] * _e425))));
        } else {
            let _e155 = (param_5[0] - param_4[0]);
            let _e158 = (param_5[1] - param_4[1]);
            let _e161 = (param_5[2] - param_4[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_8462_ = _e172;
                } else {
                    phi_8462_ = 1f;
                }
                let _e176 = phi_8462_;
                phi_8463_ = _e176;
            } else {
                phi_8463_ = 0f;
            }
            let _e178 = phi_8463_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_8502_ = _e208;
                } else {
                    phi_8502_ = 1f;
                }
                let _e212 = phi_8502_;
                phi_8503_ = _e212;
            } else {
                phi_8503_ = 0f;
            }
            let _e214 = phi_8503_;
            let _e250 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_8548_ = _e250;
                } else {
                    phi_8548_ = 1f;
                }
                let _e254 = phi_8548_;
                phi_8549_ = _e254;
            } else {
                phi_8549_ = 0f;
            }
            let _e256 = phi_8549_;
            phi_8564_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e214)), (param_3[1] - (param_4[1] * _e214)), (param_3[2] - (param_4[2] * _e214))), array<f32, 3>((param_3[0] - (param_5[0] * _e256)), (param_3[1] - (param_5[1] * _e256)), (param_3[2] - (param_5[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_8564_;
        let _e441 = function_1(_e438[0], _e438[1]);
        let _e443 = function_1(_e441, _e438[2]);
        let _e445 = function_1(_e443, _e438[3]);
        phi_8572_ = _e445;
    } else {
        phi_8572_ = _e140;
    }
    let _e447 = phi_8572_;
    return _e447;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_28;
    var local_2: type_24;
    var local_3: type_24;
    var local_4: type_24;
    var local_5: array<type_29, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: type_28;
    var local_10: type_28;
    var local_11: array<f32, 3>;
    var local_12: type_26;
    var phi_216_: u32;
    var phi_232_: u32;
    var phi_253_: u32;
    var phi_254_: u32;
    var phi_257_: type_19;
    var phi_258_: type_19;
    var phi_281_: type_19;
    var phi_457_: f32;
    var phi_463_: f32;
    var phi_468_: f32;
    var phi_474_: f32;
    var phi_479_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_496_: f32;
    var phi_502_: f32;
    var phi_507_: f32;
    var phi_512_: f32;
    var phi_519_: f32;
    var phi_525_: f32;
    var phi_530_: f32;
    var phi_536_: f32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_558_: f32;
    var phi_564_: f32;
    var phi_569_: f32;
    var phi_574_: f32;
    var phi_581_: f32;
    var phi_587_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_620_: f32;
    var phi_626_: f32;
    var phi_631_: f32;
    var phi_636_: f32;
    var phi_642_: f32;
    var phi_647_: f32;
    var phi_654_: bool;
    var phi_678_: u32;
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_721_: type_32;
    var phi_722_: bool;
    var phi_723_: type_32;
    var phi_724_: bool;
    var phi_725_: type_32;
    var phi_726_: bool;
    var phi_731_: type_32;
    var phi_1013_: f32;
    var phi_1020_: f32;
    var phi_1025_: f32;
    var phi_1032_: f32;
    var phi_1037_: f32;
    var phi_1050_: f32;
    var phi_1057_: f32;
    var phi_1062_: f32;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1096_: f32;
    var phi_1103_: f32;
    var phi_1108_: f32;
    var phi_1115_: f32;
    var phi_1120_: f32;
    var phi_1134_: f32;
    var phi_1141_: f32;
    var phi_1146_: f32;
    var phi_1153_: f32;
    var phi_1158_: f32;
    var phi_1163_: f32;
    var phi_1180_: f32;
    var phi_1187_: f32;
    var phi_1192_: f32;
    var phi_1199_: f32;
    var phi_1204_: f32;
    var phi_1218_: f32;
    var phi_1225_: f32;
    var phi_1230_: f32;
    var phi_1237_: f32;
    var phi_1242_: f32;
    var phi_1247_: f32;
    var phi_1278_: f32;
    var phi_1284_: f32;
    var phi_1291_: f32;
    var phi_1298_: f32;
    var phi_1304_: f32;
    var phi_1311_: f32;
    var phi_1317_: f32;
    var phi_1323_: f32;
    var phi_1329_: f32;
    var phi_1336_: f32;
    var phi_1343_: f32;
    var phi_1367_: f32;
    var phi_1372_: f32;
    var phi_1377_: f32;
    var phi_1382_: f32;
    var phi_1387_: f32;
    var phi_1392_: f32;
    var phi_1402_: f32;
    var phi_4051_: f32;
    var phi_4057_: f32;
    var phi_4062_: f32;
    var phi_4068_: f32;
    var phi_4074_: f32;
    var phi_4079_: f32;
    var phi_4084_: f32;
    var phi_4092_: bool;
    var phi_4097_: f32;
    var phi_4104_: f32;
    var phi_4144_: type_17;
    var phi_4147_: f32;
    var phi_4168_: bool;
    var phi_4174_: type_18;
    var phi_4145_: type_17;
    var phi_4188_: type_18;
    var phi_4148_: f32;
    var local_13: f32;
    var phi_4137_: f32;
    var phi_4201_: f32;
    var phi_4207_: f32;
    var phi_4232_: type_19;
    var phi_4235_: u32;
    var phi_4233_: type_19;
    var phi_4258_: type_19;
    var phi_4302_: u32;
    var phi_4303_: u32;
    var phi_4236_: u32;
    var phi_4304_: u32;
    var phi_4324_: type_19;
    var phi_4325_: type_19;
    var phi_4348_: type_19;
    var phi_4400_: f32;
    var phi_4407_: f32;
    var phi_4418_: bool;
    var phi_4419_: bool;
    var phi_4420_: bool;
    var phi_4421_: bool;
    var phi_4425_: bool;
    var phi_4436_: type_35;
    var phi_4437_: type_35;
    var phi_4438_: bool;
    var phi_4439_: type_35;
    var phi_4440_: bool;
    var phi_4451_: f32;
    var phi_4461_: type_19;
    var phi_4464_: f32;
    var phi_4466_: f32;
    var phi_4468_: f32;
    var phi_4462_: type_19;
    var phi_4491_: type_19;
    var phi_4516_: f32;
    var phi_4517_: f32;
    var phi_4543_: f32;
    var phi_4559_: f32;
    var phi_4566_: bool;
    var phi_4567_: bool;
    var phi_4568_: bool;
    var phi_4574_: f32;
    var phi_4575_: f32;
    var phi_4576_: bool;
    var phi_4465_: f32;
    var phi_4467_: f32;
    var phi_4469_: f32;
    var phi_4577_: f32;
    var phi_4578_: bool;
    var phi_4579_: bool;
    var local_14: bool;
    var phi_4583_: f32;
    var phi_4584_: f32;
    var phi_4592_: f32;
    var phi_4596_: type_19;
    var phi_4599_: f32;
    var phi_4597_: type_19;
    var phi_4622_: type_19;
    var phi_4652_: f32;
    var phi_4653_: bool;
    var phi_4654_: f32;
    var phi_4655_: bool;
    var phi_4656_: bool;
    var phi_4657_: bool;
    var phi_4658_: f32;
    var phi_4600_: f32;
    var phi_4659_: bool;
    var phi_4660_: bool;
    var phi_4661_: bool;
    var phi_4662_: bool;
    var local_15: bool;
    var phi_4666_: bool;
    var phi_4667_: bool;
    var phi_4671_: bool;
    var phi_4675_: f32;
    var phi_4676_: f32;
    var phi_4678_: type_35;
    var phi_4707_: f32;
    var phi_4714_: f32;
    var phi_4719_: f32;
    var phi_4726_: f32;
    var phi_4731_: f32;
    var phi_4744_: f32;
    var phi_4751_: f32;
    var phi_4756_: f32;
    var phi_4763_: f32;
    var phi_4768_: f32;
    var phi_4773_: f32;
    var phi_4832_: f32;
    var phi_4838_: f32;
    var phi_4843_: f32;
    var phi_4849_: f32;
    var phi_4854_: f32;
    var phi_4866_: f32;
    var phi_4872_: f32;
    var phi_4877_: f32;
    var phi_4883_: f32;
    var phi_4888_: f32;
    var phi_4914_: f32;
    var phi_4921_: f32;
    var phi_4926_: f32;
    var phi_4933_: f32;
    var phi_4938_: f32;
    var phi_4951_: f32;
    var phi_4958_: f32;
    var phi_4963_: f32;
    var phi_4970_: f32;
    var phi_4975_: f32;
    var phi_4980_: f32;
    var phi_5039_: f32;
    var phi_5045_: f32;
    var phi_5050_: f32;
    var phi_5056_: f32;
    var phi_5061_: f32;
    var phi_5073_: f32;
    var phi_5079_: f32;
    var phi_5084_: f32;
    var phi_5090_: f32;
    var phi_5095_: f32;
    var phi_5121_: f32;
    var phi_5128_: f32;
    var phi_5133_: f32;
    var phi_5140_: f32;
    var phi_5145_: f32;
    var phi_5158_: f32;
    var phi_5165_: f32;
    var phi_5170_: f32;
    var phi_5177_: f32;
    var phi_5182_: f32;
    var phi_5187_: f32;
    var phi_5246_: f32;
    var phi_5252_: f32;
    var phi_5257_: f32;
    var phi_5263_: f32;
    var phi_5268_: f32;
    var phi_5280_: f32;
    var phi_5286_: f32;
    var phi_5291_: f32;
    var phi_5297_: f32;
    var phi_5302_: f32;
    var phi_5351_: f32;
    var phi_5357_: f32;
    var phi_5385_: f32;
    var phi_5391_: f32;
    var phi_5396_: u32;
    var phi_5397_: u32;
    var phi_5367_: f32;
    var phi_5373_: f32;
    var phi_5378_: u32;
    var phi_5379_: u32;
    var phi_5398_: u32;
    var phi_5399_: u32;
    var phi_5468_: f32;
    var phi_5477_: f32;
    var phi_5612_: f32;
    var phi_5618_: f32;
    var phi_5625_: f32;
    var phi_5668_: type_19;
    var phi_5671_: bool;
    var phi_5669_: type_19;
    var phi_5694_: type_19;
    var phi_5721_: bool;
    var phi_5722_: bool;
    var phi_5672_: bool;
    var phi_5723_: bool;
    var phi_5724_: bool;
    var local_16: bool;
    var phi_5728_: bool;
    var local_17: bool;
    var phi_5735_: u32;
    var phi_5736_: u32;
    var phi_5737_: bool;
    var phi_5738_: u32;
    var phi_5739_: u32;
    var phi_5740_: bool;
    var phi_5744_: u32;
    var phi_5764_: bool;
    var phi_5765_: bool;
    var phi_5766_: bool;
    var phi_5914_: f32;
    var phi_5921_: f32;
    var phi_5926_: f32;
    var phi_5933_: f32;
    var phi_5938_: f32;
    var phi_5951_: f32;
    var phi_5958_: f32;
    var phi_5963_: f32;
    var phi_5970_: f32;
    var phi_5975_: f32;
    var phi_5980_: f32;
    var phi_5997_: f32;
    var phi_6004_: f32;
    var phi_6009_: f32;
    var phi_6016_: f32;
    var phi_6021_: f32;
    var phi_6035_: f32;
    var phi_6042_: f32;
    var phi_6047_: f32;
    var phi_6054_: f32;
    var phi_6059_: f32;
    var phi_6064_: f32;
    var phi_6081_: f32;
    var phi_6088_: f32;
    var phi_6093_: f32;
    var phi_6100_: f32;
    var phi_6105_: f32;
    var phi_6119_: f32;
    var phi_6126_: f32;
    var phi_6131_: f32;
    var phi_6138_: f32;
    var phi_6143_: f32;
    var phi_6148_: f32;
    var phi_6187_: type_19;
    var phi_6190_: f32;
    var phi_6192_: f32;
    var phi_6194_: f32;
    var phi_6188_: type_19;
    var phi_6217_: type_19;
    var phi_6329_: f32;
    var phi_6336_: f32;
    var phi_6344_: f32;
    var phi_6388_: type_17;
    var phi_6391_: f32;
    var phi_6412_: bool;
    var phi_6418_: type_18;
    var phi_6389_: type_17;
    var phi_6432_: type_18;
    var phi_6392_: f32;
    var local_18: f32;
    var phi_6381_: f32;
    var phi_6445_: f32;
    var phi_6511_: f32;
    var phi_6517_: f32;
    var phi_6526_: f32;
    var phi_6532_: f32;
    var phi_6541_: f32;
    var phi_6547_: f32;
    var phi_6556_: f32;
    var phi_6562_: f32;
    var phi_6568_: type_28;
    var phi_6569_: bool;
    var phi_6570_: type_28;
    var phi_6571_: bool;
    var phi_6579_: type_28;
    var phi_6749_: bool;
    var phi_6750_: bool;
    var phi_6751_: bool;
    var phi_6752_: bool;
    var phi_6753_: bool;
    var phi_6754_: bool;
    var phi_6758_: bool;
    var phi_7055_: bool;
    var phi_7056_: bool;
    var phi_7057_: bool;
    var phi_7058_: bool;
    var phi_7059_: bool;
    var phi_7060_: bool;
    var phi_7064_: bool;
    var phi_7068_: bool;
    var phi_7080_: bool;
    var phi_7081_: bool;
    var phi_7155_: bool;
    var phi_7156_: bool;
    var phi_7176_: f32;
    var phi_7177_: bool;
    var phi_7178_: f32;
    var phi_7179_: bool;
    var phi_7180_: f32;
    var phi_7181_: bool;
    var phi_7182_: bool;
    var phi_7186_: f32;
    var phi_7187_: bool;
    var phi_7191_: f32;
    var phi_7223_: bool;
    var phi_7224_: bool;
    var phi_7244_: f32;
    var phi_7245_: bool;
    var phi_7246_: f32;
    var phi_7247_: bool;
    var phi_7248_: f32;
    var phi_7249_: bool;
    var phi_7250_: bool;
    var phi_7254_: f32;
    var phi_7255_: bool;
    var phi_7259_: f32;
    var phi_7264_: f32;
    var phi_7296_: bool;
    var phi_7297_: bool;
    var phi_7317_: f32;
    var phi_7318_: bool;
    var phi_7319_: f32;
    var phi_7320_: bool;
    var phi_7321_: f32;
    var phi_7322_: bool;
    var phi_7323_: bool;
    var phi_7327_: f32;
    var phi_7328_: bool;
    var phi_7332_: f32;
    var phi_7364_: bool;
    var phi_7365_: bool;
    var phi_7385_: f32;
    var phi_7386_: bool;
    var phi_7387_: f32;
    var phi_7388_: bool;
    var phi_7389_: f32;
    var phi_7390_: bool;
    var phi_7391_: bool;
    var phi_7395_: f32;
    var phi_7396_: bool;
    var phi_7400_: f32;
    var phi_7405_: f32;
    var phi_7410_: f32;
    var phi_7415_: f32;
    var phi_7426_: f32;
    var phi_7427_: f32;
    var phi_7428_: bool;
    var phi_7429_: f32;
    var phi_7430_: f32;
    var phi_7431_: bool;
    var phi_7432_: bool;
    var phi_7433_: bool;
    var phi_7434_: f32;
    var phi_7435_: f32;
    var phi_7436_: bool;
    var phi_7437_: bool;
    var phi_7438_: bool;
    var phi_7439_: bool;
    var phi_7440_: f32;
    var phi_7441_: f32;
    var phi_7442_: bool;
    var phi_7443_: bool;
    var phi_7444_: bool;
    var phi_7445_: bool;
    var phi_7525_: f32;
    var phi_7598_: f32;
    var phi_7603_: f32;
    var phi_7676_: f32;
    var phi_7749_: f32;
    var phi_7754_: f32;
    var phi_7770_: f32;
    var phi_7771_: f32;
    var phi_7772_: f32;
    var phi_7774_: f32;
    var phi_7775_: bool;
    var phi_7776_: f32;
    var phi_7777_: f32;
    var phi_7778_: f32;
    var phi_7779_: bool;
    var phi_7780_: bool;
    var phi_7781_: bool;
    var phi_7782_: bool;
    var phi_7791_: f32;
    var phi_7796_: f32;
    var phi_7806_: bool;
    var phi_7810_: bool;
    var phi_7811_: f32;
    var phi_7812_: bool;
    var phi_7813_: bool;
    var phi_7814_: bool;
    var phi_7815_: bool;
    var phi_7816_: bool;
    var phi_6191_: f32;
    var phi_6193_: f32;
    var phi_6195_: f32;
    var phi_7817_: f32;
    var phi_7818_: bool;
    var phi_7819_: bool;
    var phi_7820_: bool;
    var phi_7821_: bool;
    var phi_7822_: bool;
    var phi_7823_: bool;
    var local_19: bool;
    var phi_7827_: f32;
    var phi_7828_: bool;
    var phi_7829_: bool;
    var phi_7830_: bool;
    var phi_7831_: bool;
    var phi_7836_: type_33;
    var phi_7837_: bool;
    var phi_7838_: bool;
    var phi_7839_: bool;
    var local_20: f32;
    var phi_7844_: type_33;
    var phi_7845_: bool;
    var phi_7846_: bool;
    var phi_7851_: type_33;
    var phi_7852_: bool;
    var phi_7853_: bool;
    var phi_7858_: type_33;
    var phi_7859_: bool;
    var phi_7863_: type_33;
    var phi_7870_: bool;
    var phi_7871_: f32;
    var phi_7872_: bool;
    var phi_7873_: bool;
    var phi_7874_: bool;
    var phi_7875_: f32;
    var phi_7876_: bool;
    var phi_7877_: bool;
    var phi_7878_: bool;
    var phi_7879_: f32;
    var phi_7880_: bool;
    var phi_7881_: bool;
    var phi_7882_: bool;
    var phi_7883_: bool;
    var phi_7887_: bool;
    var phi_7888_: bool;
    var phi_7889_: bool;
    var phi_7890_: f32;
    var phi_7891_: type_35;
    var phi_7892_: bool;
    var phi_7893_: bool;
    var phi_7894_: bool;
    var phi_7895_: bool;
    var local_21: bool;
    var phi_7900_: type_33;
    var phi_7901_: bool;
    var phi_7902_: bool;
    var local_22: f32;
    var phi_7907_: type_33;
    var phi_7908_: bool;
    var local_23: type_35;
    var phi_7914_: type_33;
    var phi_7915_: bool;
    var phi_7919_: type_33;
    var phi_1555_: f32;
    var phi_1562_: f32;
    var phi_1567_: f32;
    var phi_1574_: f32;
    var phi_1579_: f32;
    var phi_1592_: f32;
    var phi_1599_: f32;
    var phi_1604_: f32;
    var phi_1611_: f32;
    var phi_1616_: f32;
    var phi_1621_: f32;
    var phi_1638_: f32;
    var phi_1645_: f32;
    var phi_1650_: f32;
    var phi_1657_: f32;
    var phi_1662_: f32;
    var phi_1676_: f32;
    var phi_1683_: f32;
    var phi_1688_: f32;
    var phi_1695_: f32;
    var phi_1700_: f32;
    var phi_1705_: f32;
    var phi_1722_: f32;
    var phi_1729_: f32;
    var phi_1734_: f32;
    var phi_1741_: f32;
    var phi_1746_: f32;
    var phi_1760_: f32;
    var phi_1767_: f32;
    var phi_1772_: f32;
    var phi_1779_: f32;
    var phi_1784_: f32;
    var phi_1789_: f32;
    var phi_1828_: type_19;
    var phi_1831_: f32;
    var phi_1833_: f32;
    var phi_1835_: f32;
    var phi_1829_: type_19;
    var phi_1858_: type_19;
    var phi_1970_: f32;
    var phi_1977_: f32;
    var phi_1985_: f32;
    var phi_2029_: type_17;
    var phi_2032_: f32;
    var phi_2053_: bool;
    var phi_2059_: type_18;
    var phi_2030_: type_17;
    var phi_2073_: type_18;
    var phi_2033_: f32;
    var local_24: f32;
    var phi_2022_: f32;
    var phi_2086_: f32;
    var phi_2152_: f32;
    var phi_2158_: f32;
    var phi_2167_: f32;
    var phi_2173_: f32;
    var phi_2182_: f32;
    var phi_2188_: f32;
    var phi_2197_: f32;
    var phi_2203_: f32;
    var phi_2209_: type_28;
    var phi_2210_: bool;
    var phi_2211_: type_28;
    var phi_2212_: bool;
    var phi_2220_: type_28;
    var phi_2390_: bool;
    var phi_2391_: bool;
    var phi_2392_: bool;
    var phi_2393_: bool;
    var phi_2394_: bool;
    var phi_2395_: bool;
    var phi_2399_: bool;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2698_: bool;
    var phi_2699_: bool;
    var phi_2700_: bool;
    var phi_2701_: bool;
    var phi_2705_: bool;
    var phi_2709_: bool;
    var phi_2721_: bool;
    var phi_2722_: bool;
    var phi_2796_: bool;
    var phi_2797_: bool;
    var phi_2817_: f32;
    var phi_2818_: bool;
    var phi_2819_: f32;
    var phi_2820_: bool;
    var phi_2821_: f32;
    var phi_2822_: bool;
    var phi_2823_: bool;
    var phi_2827_: f32;
    var phi_2828_: bool;
    var phi_2832_: f32;
    var phi_2864_: bool;
    var phi_2865_: bool;
    var phi_2885_: f32;
    var phi_2886_: bool;
    var phi_2887_: f32;
    var phi_2888_: bool;
    var phi_2889_: f32;
    var phi_2890_: bool;
    var phi_2891_: bool;
    var phi_2895_: f32;
    var phi_2896_: bool;
    var phi_2900_: f32;
    var phi_2905_: f32;
    var phi_2937_: bool;
    var phi_2938_: bool;
    var phi_2958_: f32;
    var phi_2959_: bool;
    var phi_2960_: f32;
    var phi_2961_: bool;
    var phi_2962_: f32;
    var phi_2963_: bool;
    var phi_2964_: bool;
    var phi_2968_: f32;
    var phi_2969_: bool;
    var phi_2973_: f32;
    var phi_3005_: bool;
    var phi_3006_: bool;
    var phi_3026_: f32;
    var phi_3027_: bool;
    var phi_3028_: f32;
    var phi_3029_: bool;
    var phi_3030_: f32;
    var phi_3031_: bool;
    var phi_3032_: bool;
    var phi_3036_: f32;
    var phi_3037_: bool;
    var phi_3041_: f32;
    var phi_3046_: f32;
    var phi_3051_: f32;
    var phi_3056_: f32;
    var phi_3067_: f32;
    var phi_3068_: f32;
    var phi_3069_: bool;
    var phi_3070_: f32;
    var phi_3071_: f32;
    var phi_3072_: bool;
    var phi_3073_: bool;
    var phi_3074_: bool;
    var phi_3075_: f32;
    var phi_3076_: f32;
    var phi_3077_: bool;
    var phi_3078_: bool;
    var phi_3079_: bool;
    var phi_3080_: bool;
    var phi_3081_: f32;
    var phi_3082_: f32;
    var phi_3083_: bool;
    var phi_3084_: bool;
    var phi_3085_: bool;
    var phi_3086_: bool;
    var phi_3166_: f32;
    var phi_3239_: f32;
    var phi_3244_: f32;
    var phi_3317_: f32;
    var phi_3390_: f32;
    var phi_3395_: f32;
    var phi_3411_: f32;
    var phi_3412_: f32;
    var phi_3413_: f32;
    var phi_3415_: f32;
    var phi_3416_: bool;
    var phi_3417_: f32;
    var phi_3418_: f32;
    var phi_3419_: f32;
    var phi_3420_: bool;
    var phi_3421_: bool;
    var phi_3422_: bool;
    var phi_3423_: bool;
    var phi_3432_: f32;
    var phi_3437_: f32;
    var phi_3447_: bool;
    var phi_3451_: bool;
    var phi_3452_: f32;
    var phi_3453_: bool;
    var phi_3454_: bool;
    var phi_3455_: bool;
    var phi_3456_: bool;
    var phi_3457_: bool;
    var phi_1832_: f32;
    var phi_1834_: f32;
    var phi_1836_: f32;
    var phi_3458_: f32;
    var phi_3459_: bool;
    var phi_3460_: bool;
    var phi_3461_: bool;
    var phi_3462_: bool;
    var phi_3463_: bool;
    var phi_3464_: bool;
    var local_25: bool;
    var phi_3468_: f32;
    var phi_3469_: bool;
    var phi_3470_: bool;
    var phi_3471_: bool;
    var phi_3472_: bool;
    var phi_3477_: type_33;
    var phi_3478_: bool;
    var phi_3479_: bool;
    var phi_3480_: bool;
    var local_26: f32;
    var phi_3485_: type_33;
    var phi_3486_: bool;
    var phi_3487_: bool;
    var phi_3492_: type_33;
    var phi_3493_: bool;
    var phi_3494_: bool;
    var phi_3499_: type_33;
    var phi_3500_: bool;
    var phi_3504_: type_33;
    var phi_3518_: type_19;
    var phi_3519_: type_19;
    var phi_3542_: type_19;
    var phi_3562_: f32;
    var phi_3692_: type_17;
    var phi_3695_: f32;
    var phi_3716_: bool;
    var phi_3722_: type_18;
    var phi_3693_: type_17;
    var phi_3736_: type_18;
    var phi_3696_: f32;
    var local_27: f32;
    var phi_3685_: f32;
    var phi_3749_: f32;
    var phi_3765_: f32;
    var phi_3772_: f32;
    var phi_3777_: f32;
    var phi_3784_: f32;
    var phi_3789_: f32;
    var phi_3802_: f32;
    var phi_3809_: f32;
    var phi_3814_: f32;
    var phi_3821_: f32;
    var phi_3826_: f32;
    var phi_3831_: f32;
    var phi_3848_: f32;
    var phi_3855_: f32;
    var phi_3860_: f32;
    var phi_3867_: f32;
    var phi_3872_: f32;
    var phi_3886_: f32;
    var phi_3893_: f32;
    var phi_3898_: f32;
    var phi_3905_: f32;
    var phi_3910_: f32;
    var phi_3915_: f32;
    var phi_3932_: f32;
    var phi_3939_: f32;
    var phi_3944_: f32;
    var phi_3951_: f32;
    var phi_3956_: f32;
    var phi_3970_: f32;
    var phi_3977_: f32;
    var phi_3982_: f32;
    var phi_3989_: f32;
    var phi_3994_: f32;
    var phi_3999_: f32;
    var phi_4019_: bool;
    var phi_4020_: bool;
    var phi_4021_: bool;
    var local_28: bool;
    var phi_4026_: type_33;
    var phi_4027_: bool;
    var phi_4032_: type_33;
    var phi_4033_: bool;
    var phi_4035_: type_33;
    var phi_4036_: type_33;
    var phi_4037_: bool;
    var phi_4041_: type_33;
    var phi_7923_: type_33;
    var phi_7924_: type_33;
    var phi_7937_: type_36;
    var phi_7944_: bool;
    var phi_7968_: u32;
    var phi_7972_: type_27;
    var phi_7973_: bool;
    var phi_7974_: bool;
    var phi_7992_: u32;
    var phi_8054_: u32;
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
    let _e122 = params.member.member_15;
    let _e124 = input.member[0u];
    if (_e122 < _e124) {
        phi_216_ = _e122;
    } else {
        phi_216_ = _e124;
    }
    let _e127 = phi_216_;
    let _e128 = (_e127 / 64u);
    if ((_e127 % 64u) > 0u) {
        phi_232_ = (_e128 + 1u);
    } else {
        phi_232_ = _e128;
    }
    let _e133 = phi_232_;
    if (_e133 > _e117) {
        let _e135 = (_e133 - _e117);
        if (_e120 == 0u) {
            return;
        }
        let _e137 = (_e135 / _e120);
        if (_e120 == 0u) {
            return;
        }
        if ((_e135 % _e120) > 0u) {
            phi_253_ = (_e137 + 1u);
        } else {
            phi_253_ = _e137;
        }
        let _e143 = phi_253_;
        phi_254_ = _e143;
    } else {
        phi_254_ = 0u;
    }
    let _e145 = phi_254_;
    phi_257_ = type_19(0u, _e145);
    loop {
        let _e148 = phi_257_;
        if (_e148.member < _e148.member_1) {
            phi_258_ = type_19((_e148.member + 1u), _e148.member_1);
            phi_281_ = type_19(1u, _e148.member);
        } else {
            phi_258_ = _e148;
            phi_281_ = type_19(0u, type_19().member_1);
        }
        let _e160 = phi_258_;
        let _e162 = phi_281_;
        let _e166 = (bitcast<i32>(_e162.member) != 0i);
        if _e166 {
            let _e170 = (((_e117 + (_e162.member_1 * _e120)) * 64u) + _e105);
            let _e172 = params.member.member_8;
            if (_e170 < _e127) {
                let _e175 = (2u * _e170);
                let _e178 = input.member[(4u + _e175)];
                let _e181 = input.member[(_e175 + 5u)];
                let _e183 = elements.member[_e178];
                let _e185 = elements.member[_e181];
                let _e191 = paths.member[_e183[0]];
                let _e193 = paths.member[_e183[1]];
                let _e199 = paths.member[_e185[0]];
                let _e201 = paths.member[_e185[1]];
                let _e231 = params.member.member_4;
                let _e232 = (_e199.member[0] - _e191.member[0]);
                let _e233 = (_e199.member[1] - _e191.member[1]);
                let _e234 = (_e199.member[2] - _e191.member[2]);
                let _e236 = (_e199.member_1[0] - _e191.member_1[0]);
                let _e237 = (_e199.member_1[1] - _e191.member_1[1]);
                let _e238 = (_e199.member_1[2] - _e191.member_1[2]);
                let _e241 = (_e193.member[0] - _e191.member[0]);
                let _e242 = (_e193.member[1] - _e191.member[1]);
                let _e243 = (_e193.member[2] - _e191.member[2]);
                let _e245 = (_e193.member_1[0] - _e191.member_1[0]);
                let _e246 = (_e193.member_1[1] - _e191.member_1[1]);
                let _e247 = (_e193.member_1[2] - _e191.member_1[2]);
                let _e250 = (_e199.member[0] - _e201.member[0]);
                let _e251 = (_e199.member[1] - _e201.member[1]);
                let _e252 = (_e199.member[2] - _e201.member[2]);
                let _e254 = (_e199.member_1[0] - _e201.member_1[0]);
                let _e255 = (_e199.member_1[1] - _e201.member_1[1]);
                let _e256 = (_e199.member_1[2] - _e201.member_1[2]);
                let _e259 = (_e231 + _e231);
                let _e262 = params.member.member_5;
                if (_e232 < 0f) {
                    phi_457_ = -(_e232);
                } else {
                    phi_457_ = _e232;
                }
                let _e266 = phi_457_;
                if (_e233 < 0f) {
                    phi_463_ = -(_e233);
                } else {
                    phi_463_ = _e233;
                }
                let _e270 = phi_463_;
                if (_e266 > _e270) {
                    phi_468_ = _e266;
                } else {
                    phi_468_ = _e270;
                }
                let _e273 = phi_468_;
                if (_e234 < 0f) {
                    phi_474_ = -(_e234);
                } else {
                    phi_474_ = _e234;
                }
                let _e277 = phi_474_;
                if (_e273 > _e277) {
                    phi_479_ = _e273;
                } else {
                    phi_479_ = _e277;
                }
                let _e280 = phi_479_;
                if (_e236 < 0f) {
                    phi_485_ = -(_e236);
                } else {
                    phi_485_ = _e236;
                }
                let _e284 = phi_485_;
                if (_e237 < 0f) {
                    phi_491_ = -(_e237);
                } else {
                    phi_491_ = _e237;
                }
                let _e288 = phi_491_;
                if (_e284 > _e288) {
                    phi_496_ = _e284;
                } else {
                    phi_496_ = _e288;
                }
                let _e291 = phi_496_;
                if (_e238 < 0f) {
                    phi_502_ = -(_e238);
                } else {
                    phi_502_ = _e238;
                }
                let _e295 = phi_502_;
                if (_e291 > _e295) {
                    phi_507_ = _e291;
                } else {
                    phi_507_ = _e295;
                }
                let _e298 = phi_507_;
                if (_e280 > _e298) {
                    phi_512_ = _e280;
                } else {
                    phi_512_ = _e298;
                }
                let _e301 = phi_512_;
                let _e302 = (_e301 + _e259);
                if (_e241 < 0f) {
                    phi_519_ = -(_e241);
                } else {
                    phi_519_ = _e241;
                }
                let _e306 = phi_519_;
                if (_e242 < 0f) {
                    phi_525_ = -(_e242);
                } else {
                    phi_525_ = _e242;
                }
                let _e310 = phi_525_;
                if (_e306 > _e310) {
                    phi_530_ = _e306;
                } else {
                    phi_530_ = _e310;
                }
                let _e313 = phi_530_;
                if (_e243 < 0f) {
                    phi_536_ = -(_e243);
                } else {
                    phi_536_ = _e243;
                }
                let _e317 = phi_536_;
                if (_e313 > _e317) {
                    phi_541_ = _e313;
                } else {
                    phi_541_ = _e317;
                }
                let _e320 = phi_541_;
                if (_e245 < 0f) {
                    phi_547_ = -(_e245);
                } else {
                    phi_547_ = _e245;
                }
                let _e324 = phi_547_;
                if (_e246 < 0f) {
                    phi_553_ = -(_e246);
                } else {
                    phi_553_ = _e246;
                }
                let _e328 = phi_553_;
                if (_e324 > _e328) {
                    phi_558_ = _e324;
                } else {
                    phi_558_ = _e328;
                }
                let _e331 = phi_558_;
                if (_e247 < 0f) {
                    phi_564_ = -(_e247);
                } else {
                    phi_564_ = _e247;
                }
                let _e335 = phi_564_;
                if (_e331 > _e335) {
                    phi_569_ = _e331;
                } else {
                    phi_569_ = _e335;
                }
                let _e338 = phi_569_;
                if (_e320 > _e338) {
                    phi_574_ = _e320;
                } else {
                    phi_574_ = _e338;
                }
                let _e341 = phi_574_;
                let _e342 = (_e341 + _e259);
                if (_e250 < 0f) {
                    phi_581_ = -(_e250);
                } else {
                    phi_581_ = _e250;
                }
                let _e346 = phi_581_;
                if (_e251 < 0f) {
                    phi_587_ = -(_e251);
                } else {
                    phi_587_ = _e251;
                }
                let _e350 = phi_587_;
                if (_e346 > _e350) {
                    phi_592_ = _e346;
                } else {
                    phi_592_ = _e350;
                }
                let _e353 = phi_592_;
                if (_e252 < 0f) {
                    phi_598_ = -(_e252);
                } else {
                    phi_598_ = _e252;
                }
                let _e357 = phi_598_;
                if (_e353 > _e357) {
                    phi_603_ = _e353;
                } else {
                    phi_603_ = _e357;
                }
                let _e360 = phi_603_;
                if (_e254 < 0f) {
                    phi_609_ = -(_e254);
                } else {
                    phi_609_ = _e254;
                }
                let _e364 = phi_609_;
                if (_e255 < 0f) {
                    phi_615_ = -(_e255);
                } else {
                    phi_615_ = _e255;
                }
                let _e368 = phi_615_;
                if (_e364 > _e368) {
                    phi_620_ = _e364;
                } else {
                    phi_620_ = _e368;
                }
                let _e371 = phi_620_;
                if (_e256 < 0f) {
                    phi_626_ = -(_e256);
                } else {
                    phi_626_ = _e256;
                }
                let _e375 = phi_626_;
                if (_e371 > _e375) {
                    phi_631_ = _e371;
                } else {
                    phi_631_ = _e375;
                }
                let _e378 = phi_631_;
                if (_e360 > _e378) {
                    phi_636_ = _e360;
                } else {
                    phi_636_ = _e378;
                }
                let _e381 = phi_636_;
                let _e382 = (_e381 + _e259);
                if (_e302 > _e342) {
                    phi_642_ = _e302;
                } else {
                    phi_642_ = _e342;
                }
                let _e385 = phi_642_;
                if (_e385 > _e382) {
                    phi_647_ = _e385;
                } else {
                    phi_647_ = _e382;
                }
                let _e388 = phi_647_;
                if (_e388 <= 65536f) {
                    phi_654_ = (_e388 >= (1f / 65536f));
                } else {
                    phi_654_ = false;
                }
                let _e393 = phi_654_;
                if _e393 {
                    phi_725_ = type_32();
                    phi_726_ = true;
                } else {
                    if (_e388 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e388) & 2139095040u) != 2139095040u) {
                            let _e400 = (2130706432u - (bitcast<u32>(_e388) & 2139095040u));
                            if (_e400 > 8388608u) {
                                phi_678_ = _e400;
                            } else {
                                phi_678_ = 8388608u;
                            }
                            let _e403 = phi_678_;
                            let _e404 = bitcast<f32>(_e403);
                            let _e405 = (_e262 * _e404);
                            if (_e262 > 0f) {
                                if (_e405 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_689_ = _e405;
                                } else {
                                    phi_689_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e409 = phi_689_;
                                phi_690_ = _e409;
                            } else {
                                phi_690_ = _e405;
                            }
                            let _e411 = phi_690_;
                            phi_721_ = type_32(type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e232 * _e404), (_e233 * _e404), (_e234 * _e404)), array<f32, 3>((_e236 * _e404), (_e237 * _e404), (_e238 * _e404))), array<array<f32, 3>, 2>(array<f32, 3>((_e241 * _e404), (_e242 * _e404), (_e243 * _e404)), array<f32, 3>((_e245 * _e404), (_e246 * _e404), (_e247 * _e404))), array<array<f32, 3>, 2>(array<f32, 3>((_e250 * _e404), (_e251 * _e404), (_e252 * _e404)), array<f32, 3>((_e254 * _e404), (_e255 * _e404), (_e256 * _e404))), (_e259 * _e404)), _e411);
                            phi_722_ = false;
                        } else {
                            phi_721_ = type_32();
                            phi_722_ = true;
                        }
                        let _e443 = phi_721_;
                        let _e445 = phi_722_;
                        phi_723_ = _e443;
                        phi_724_ = _e445;
                    } else {
                        phi_723_ = type_32();
                        phi_724_ = true;
                    }
                    let _e447 = phi_723_;
                    let _e449 = phi_724_;
                    phi_725_ = _e447;
                    phi_726_ = _e449;
                }
                let _e451 = phi_725_;
                let _e453 = phi_726_;
                if _e453 {
                    phi_731_ = type_32(type_26(array<array<f32, 3>, 2>(array<f32, 3>(_e232, _e233, _e234), array<f32, 3>(_e236, _e237, _e238)), array<array<f32, 3>, 2>(array<f32, 3>(_e241, _e242, _e243), array<f32, 3>(_e245, _e246, _e247)), array<array<f32, 3>, 2>(array<f32, 3>(_e250, _e251, _e252), array<f32, 3>(_e254, _e255, _e256)), _e259), _e262);
                } else {
                    phi_731_ = _e451;
                }
                let _e456 = phi_731_;
                local_12 = type_26(array<array<f32, 3>, 2>(array<f32, 3>(_e456.member.member[0][0], _e456.member.member[0][1], _e456.member.member[0][2]), array<f32, 3>(_e456.member.member[1][0], _e456.member.member[1][1], _e456.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e456.member.member_1[0][0], _e456.member.member_1[0][1], _e456.member.member_1[0][2]), array<f32, 3>(_e456.member.member_1[1][0], _e456.member.member_1[1][1], _e456.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e456.member.member_2[0][0], _e456.member.member_2[0][1], _e456.member.member_2[0][2]), array<f32, 3>(_e456.member.member_2[1][0], _e456.member.member_2[1][1], _e456.member.member_2[1][2])), _e456.member.member_3);
                let _e499 = local_12.member_1[0u];
                let _e505 = local_12.member_2[0u];
                let _e511 = ((_e499[1] * _e505[2]) - (_e499[2] * _e505[1]));
                let _e514 = ((_e499[2] * _e505[0]) - (_e499[0] * _e505[2]));
                let _e517 = ((_e499[0] * _e505[1]) - (_e499[1] * _e505[0]));
                let _e520 = local_12.member_1[1u];
                let _e526 = local_12.member_2[1u];
                let _e532 = ((_e520[1] * _e526[2]) - (_e520[2] * _e526[1]));
                let _e535 = ((_e520[2] * _e526[0]) - (_e520[0] * _e526[2]));
                let _e538 = ((_e520[0] * _e526[1]) - (_e520[1] * _e526[0]));
                let _e541 = local_12.member_1[0u];
                let _e547 = local_12.member_2[1u];
                let _e562 = local_12.member_1[1u];
                let _e568 = local_12.member_2[0u];
                let _e581 = (((_e541[1] * _e547[2]) - (_e541[2] * _e547[1])) + ((_e562[1] * _e568[2]) - (_e562[2] * _e568[1])));
                let _e582 = (((_e541[2] * _e547[0]) - (_e541[0] * _e547[2])) + ((_e562[2] * _e568[0]) - (_e562[0] * _e568[2])));
                let _e583 = (((_e541[0] * _e547[1]) - (_e541[1] * _e547[0])) + ((_e562[0] * _e568[1]) - (_e562[1] * _e568[0])));
                let _e586 = local_12.member[0u];
                let _e594 = (((_e586[0] * _e511) + (_e586[1] * _e514)) + (_e586[2] * _e517));
                let _e597 = local_12.member[1u];
                let _e608 = local_12.member[0u];
                let _e617 = ((((_e597[0] * _e511) + (_e597[1] * _e514)) + (_e597[2] * _e517)) + (((_e608[0] * _e581) + (_e608[1] * _e582)) + (_e608[2] * _e583)));
                let _e620 = local_12.member[0u];
                let _e631 = local_12.member[1u];
                let _e640 = ((((_e620[0] * _e532) + (_e620[1] * _e535)) + (_e620[2] * _e538)) + (((_e631[0] * _e581) + (_e631[1] * _e582)) + (_e631[2] * _e583)));
                let _e643 = local_12.member[1u];
                let _e651 = (((_e643[0] * _e532) + (_e643[1] * _e535)) + (_e643[2] * _e538));
                let _e654 = local_12.member[0u];
                if (_e654[0] < 0f) {
                    phi_1013_ = -(_e654[0]);
                } else {
                    phi_1013_ = _e654[0];
                }
                let _e661 = phi_1013_;
                if (_e654[1] < 0f) {
                    phi_1020_ = -(_e654[1]);
                } else {
                    phi_1020_ = _e654[1];
                }
                let _e665 = phi_1020_;
                if (_e661 > _e665) {
                    phi_1025_ = _e661;
                } else {
                    phi_1025_ = _e665;
                }
                let _e668 = phi_1025_;
                if (_e654[2] < 0f) {
                    phi_1032_ = -(_e654[2]);
                } else {
                    phi_1032_ = _e654[2];
                }
                let _e672 = phi_1032_;
                if (_e668 > _e672) {
                    phi_1037_ = _e668;
                } else {
                    phi_1037_ = _e672;
                }
                let _e675 = phi_1037_;
                let _e678 = local_12.member[1u];
                if (_e678[0] < 0f) {
                    phi_1050_ = -(_e678[0]);
                } else {
                    phi_1050_ = _e678[0];
                }
                let _e685 = phi_1050_;
                if (_e678[1] < 0f) {
                    phi_1057_ = -(_e678[1]);
                } else {
                    phi_1057_ = _e678[1];
                }
                let _e689 = phi_1057_;
                if (_e685 > _e689) {
                    phi_1062_ = _e685;
                } else {
                    phi_1062_ = _e689;
                }
                let _e692 = phi_1062_;
                if (_e678[2] < 0f) {
                    phi_1069_ = -(_e678[2]);
                } else {
                    phi_1069_ = _e678[2];
                }
                let _e696 = phi_1069_;
                if (_e692 > _e696) {
                    phi_1074_ = _e692;
                } else {
                    phi_1074_ = _e696;
                }
                let _e699 = phi_1074_;
                if (_e675 > _e699) {
                    phi_1079_ = _e675;
                } else {
                    phi_1079_ = _e699;
                }
                let _e702 = phi_1079_;
                let _e704 = local_12.member_3;
                let _e705 = (_e702 + _e704);
                let _e708 = local_12.member_1[0u];
                if (_e708[0] < 0f) {
                    phi_1096_ = -(_e708[0]);
                } else {
                    phi_1096_ = _e708[0];
                }
                let _e715 = phi_1096_;
                if (_e708[1] < 0f) {
                    phi_1103_ = -(_e708[1]);
                } else {
                    phi_1103_ = _e708[1];
                }
                let _e719 = phi_1103_;
                if (_e715 > _e719) {
                    phi_1108_ = _e715;
                } else {
                    phi_1108_ = _e719;
                }
                let _e722 = phi_1108_;
                if (_e708[2] < 0f) {
                    phi_1115_ = -(_e708[2]);
                } else {
                    phi_1115_ = _e708[2];
                }
                let _e726 = phi_1115_;
                if (_e722 > _e726) {
                    phi_1120_ = _e722;
                } else {
                    phi_1120_ = _e726;
                }
                let _e729 = phi_1120_;
                let _e732 = local_12.member_1[1u];
                if (_e732[0] < 0f) {
                    phi_1134_ = -(_e732[0]);
                } else {
                    phi_1134_ = _e732[0];
                }
                let _e739 = phi_1134_;
                if (_e732[1] < 0f) {
                    phi_1141_ = -(_e732[1]);
                } else {
                    phi_1141_ = _e732[1];
                }
                let _e743 = phi_1141_;
                if (_e739 > _e743) {
                    phi_1146_ = _e739;
                } else {
                    phi_1146_ = _e743;
                }
                let _e746 = phi_1146_;
                if (_e732[2] < 0f) {
                    phi_1153_ = -(_e732[2]);
                } else {
                    phi_1153_ = _e732[2];
                }
                let _e750 = phi_1153_;
                if (_e746 > _e750) {
                    phi_1158_ = _e746;
                } else {
                    phi_1158_ = _e750;
                }
                let _e753 = phi_1158_;
                if (_e729 > _e753) {
                    phi_1163_ = _e729;
                } else {
                    phi_1163_ = _e753;
                }
                let _e756 = phi_1163_;
                let _e758 = local_12.member_3;
                let _e759 = (_e756 + _e758);
                let _e762 = local_12.member_2[0u];
                if (_e762[0] < 0f) {
                    phi_1180_ = -(_e762[0]);
                } else {
                    phi_1180_ = _e762[0];
                }
                let _e769 = phi_1180_;
                if (_e762[1] < 0f) {
                    phi_1187_ = -(_e762[1]);
                } else {
                    phi_1187_ = _e762[1];
                }
                let _e773 = phi_1187_;
                if (_e769 > _e773) {
                    phi_1192_ = _e769;
                } else {
                    phi_1192_ = _e773;
                }
                let _e776 = phi_1192_;
                if (_e762[2] < 0f) {
                    phi_1199_ = -(_e762[2]);
                } else {
                    phi_1199_ = _e762[2];
                }
                let _e780 = phi_1199_;
                if (_e776 > _e780) {
                    phi_1204_ = _e776;
                } else {
                    phi_1204_ = _e780;
                }
                let _e783 = phi_1204_;
                let _e786 = local_12.member_2[1u];
                if (_e786[0] < 0f) {
                    phi_1218_ = -(_e786[0]);
                } else {
                    phi_1218_ = _e786[0];
                }
                let _e793 = phi_1218_;
                if (_e786[1] < 0f) {
                    phi_1225_ = -(_e786[1]);
                } else {
                    phi_1225_ = _e786[1];
                }
                let _e797 = phi_1225_;
                if (_e793 > _e797) {
                    phi_1230_ = _e793;
                } else {
                    phi_1230_ = _e797;
                }
                let _e800 = phi_1230_;
                if (_e786[2] < 0f) {
                    phi_1237_ = -(_e786[2]);
                } else {
                    phi_1237_ = _e786[2];
                }
                let _e804 = phi_1237_;
                if (_e800 > _e804) {
                    phi_1242_ = _e800;
                } else {
                    phi_1242_ = _e804;
                }
                let _e807 = phi_1242_;
                if (_e783 > _e807) {
                    phi_1247_ = _e783;
                } else {
                    phi_1247_ = _e807;
                }
                let _e810 = phi_1247_;
                let _e812 = local_12.member_3;
                let _e813 = (_e810 + _e812);
                let _e815 = ((_e759 * 8f) * _e813);
                let _e822 = local_12.member_3;
                if (_e511 < 0f) {
                    phi_1278_ = -(_e511);
                } else {
                    phi_1278_ = _e511;
                }
                let _e839 = phi_1278_;
                if (_e514 < 0f) {
                    phi_1284_ = -(_e514);
                } else {
                    phi_1284_ = _e514;
                }
                let _e843 = phi_1284_;
                if (_e517 < 0f) {
                    phi_1291_ = -(_e517);
                } else {
                    phi_1291_ = _e517;
                }
                let _e848 = phi_1291_;
                let _e849 = ((_e839 + _e843) + _e848);
                if (_e532 < 0f) {
                    phi_1298_ = -(_e532);
                } else {
                    phi_1298_ = _e532;
                }
                let _e853 = phi_1298_;
                if (_e535 < 0f) {
                    phi_1304_ = -(_e535);
                } else {
                    phi_1304_ = _e535;
                }
                let _e857 = phi_1304_;
                if (_e538 < 0f) {
                    phi_1311_ = -(_e538);
                } else {
                    phi_1311_ = _e538;
                }
                let _e862 = phi_1311_;
                let _e863 = ((_e853 + _e857) + _e862);
                if (_e849 > _e863) {
                    phi_1317_ = _e849;
                } else {
                    phi_1317_ = _e863;
                }
                let _e866 = phi_1317_;
                if (_e581 < 0f) {
                    phi_1323_ = -(_e581);
                } else {
                    phi_1323_ = _e581;
                }
                let _e870 = phi_1323_;
                if (_e582 < 0f) {
                    phi_1329_ = -(_e582);
                } else {
                    phi_1329_ = _e582;
                }
                let _e874 = phi_1329_;
                if (_e583 < 0f) {
                    phi_1336_ = -(_e583);
                } else {
                    phi_1336_ = _e583;
                }
                let _e879 = phi_1336_;
                let _e881 = (((_e870 + _e874) + _e879) * 0.5f);
                if (_e866 > _e881) {
                    phi_1343_ = _e866;
                } else {
                    phi_1343_ = _e881;
                }
                let _e884 = phi_1343_;
                let _e889 = local_12.member_3;
                let _e901 = (((((_e705 * 8f) * _e815) * (0.000000059604645f * (524f / 64f))) + ((_e822 * 19f) * ((_e705 * (_e759 + _e813)) + (_e759 * _e813)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e705) * ((1f + _e759) * (1f + _e813)))));
                let _e902 = (_e594 * 3f);
                let _e903 = (_e651 * 3f);
                if (_e902 < _e903) {
                    phi_1367_ = _e902;
                } else {
                    phi_1367_ = _e903;
                }
                let _e906 = phi_1367_;
                if (_e617 < _e640) {
                    phi_1372_ = _e617;
                } else {
                    phi_1372_ = _e640;
                }
                let _e909 = phi_1372_;
                if (_e906 < _e909) {
                    phi_1377_ = _e906;
                } else {
                    phi_1377_ = _e909;
                }
                let _e912 = phi_1377_;
                if (_e902 > _e903) {
                    phi_1382_ = _e902;
                } else {
                    phi_1382_ = _e903;
                }
                let _e915 = phi_1382_;
                if (_e617 > _e640) {
                    phi_1387_ = _e617;
                } else {
                    phi_1387_ = _e640;
                }
                let _e918 = phi_1387_;
                if (_e915 > _e918) {
                    phi_1392_ = _e915;
                } else {
                    phi_1392_ = _e918;
                }
                let _e921 = phi_1392_;
                let _e926 = -(_e921);
                if (_e912 > _e926) {
                    phi_1402_ = _e912;
                } else {
                    phi_1402_ = _e926;
                }
                let _e929 = phi_1402_;
                if ((_e929 - (_e901 + ((_e456.member_1 * (((_e884 + (_e815 * (0.000000059604645f * 8f))) + ((_e889 * 6f) * (_e759 + _e813))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e759) * (1f + _e813))))) * (3f * 1.0001f)))) > 0f) {
                    phi_7924_ = type_33(0u, type_33().member_1);
                } else {
                    if (_e456.member_1 > 0f) {
                        let _e3495 = local_12.member[0u];
                        let _e3501 = local_12.member_1[0u];
                        let _e3507 = local_12.member_2[0u];
                        let _e3511 = (_e3495[0] - _e3501[0]);
                        let _e3512 = (_e3495[1] - _e3501[1]);
                        let _e3513 = (_e3495[2] - _e3501[2]);
                        let _e3522 = local_12.member[1u];
                        let _e3528 = local_12.member_1[1u];
                        let _e3534 = local_12.member_2[1u];
                        let _e3538 = (_e3522[0] - _e3528[0]);
                        let _e3539 = (_e3522[1] - _e3528[1]);
                        let _e3540 = (_e3522[2] - _e3528[2]);
                        let _e3549 = local_12.member[0u];
                        if (_e3549[0] < 0f) {
                            phi_1555_ = -(_e3549[0]);
                        } else {
                            phi_1555_ = _e3549[0];
                        }
                        let _e3556 = phi_1555_;
                        if (_e3549[1] < 0f) {
                            phi_1562_ = -(_e3549[1]);
                        } else {
                            phi_1562_ = _e3549[1];
                        }
                        let _e3560 = phi_1562_;
                        if (_e3556 > _e3560) {
                            phi_1567_ = _e3556;
                        } else {
                            phi_1567_ = _e3560;
                        }
                        let _e3563 = phi_1567_;
                        if (_e3549[2] < 0f) {
                            phi_1574_ = -(_e3549[2]);
                        } else {
                            phi_1574_ = _e3549[2];
                        }
                        let _e3567 = phi_1574_;
                        if (_e3563 > _e3567) {
                            phi_1579_ = _e3563;
                        } else {
                            phi_1579_ = _e3567;
                        }
                        let _e3570 = phi_1579_;
                        let _e3573 = local_12.member[1u];
                        if (_e3573[0] < 0f) {
                            phi_1592_ = -(_e3573[0]);
                        } else {
                            phi_1592_ = _e3573[0];
                        }
                        let _e3580 = phi_1592_;
                        if (_e3573[1] < 0f) {
                            phi_1599_ = -(_e3573[1]);
                        } else {
                            phi_1599_ = _e3573[1];
                        }
                        let _e3584 = phi_1599_;
                        if (_e3580 > _e3584) {
                            phi_1604_ = _e3580;
                        } else {
                            phi_1604_ = _e3584;
                        }
                        let _e3587 = phi_1604_;
                        if (_e3573[2] < 0f) {
                            phi_1611_ = -(_e3573[2]);
                        } else {
                            phi_1611_ = _e3573[2];
                        }
                        let _e3591 = phi_1611_;
                        if (_e3587 > _e3591) {
                            phi_1616_ = _e3587;
                        } else {
                            phi_1616_ = _e3591;
                        }
                        let _e3594 = phi_1616_;
                        if (_e3570 > _e3594) {
                            phi_1621_ = _e3570;
                        } else {
                            phi_1621_ = _e3594;
                        }
                        let _e3597 = phi_1621_;
                        let _e3599 = local_12.member_3;
                        let _e3603 = local_12.member_1[0u];
                        if (_e3603[0] < 0f) {
                            phi_1638_ = -(_e3603[0]);
                        } else {
                            phi_1638_ = _e3603[0];
                        }
                        let _e3610 = phi_1638_;
                        if (_e3603[1] < 0f) {
                            phi_1645_ = -(_e3603[1]);
                        } else {
                            phi_1645_ = _e3603[1];
                        }
                        let _e3614 = phi_1645_;
                        if (_e3610 > _e3614) {
                            phi_1650_ = _e3610;
                        } else {
                            phi_1650_ = _e3614;
                        }
                        let _e3617 = phi_1650_;
                        if (_e3603[2] < 0f) {
                            phi_1657_ = -(_e3603[2]);
                        } else {
                            phi_1657_ = _e3603[2];
                        }
                        let _e3621 = phi_1657_;
                        if (_e3617 > _e3621) {
                            phi_1662_ = _e3617;
                        } else {
                            phi_1662_ = _e3621;
                        }
                        let _e3624 = phi_1662_;
                        let _e3627 = local_12.member_1[1u];
                        if (_e3627[0] < 0f) {
                            phi_1676_ = -(_e3627[0]);
                        } else {
                            phi_1676_ = _e3627[0];
                        }
                        let _e3634 = phi_1676_;
                        if (_e3627[1] < 0f) {
                            phi_1683_ = -(_e3627[1]);
                        } else {
                            phi_1683_ = _e3627[1];
                        }
                        let _e3638 = phi_1683_;
                        if (_e3634 > _e3638) {
                            phi_1688_ = _e3634;
                        } else {
                            phi_1688_ = _e3638;
                        }
                        let _e3641 = phi_1688_;
                        if (_e3627[2] < 0f) {
                            phi_1695_ = -(_e3627[2]);
                        } else {
                            phi_1695_ = _e3627[2];
                        }
                        let _e3645 = phi_1695_;
                        if (_e3641 > _e3645) {
                            phi_1700_ = _e3641;
                        } else {
                            phi_1700_ = _e3645;
                        }
                        let _e3648 = phi_1700_;
                        if (_e3624 > _e3648) {
                            phi_1705_ = _e3624;
                        } else {
                            phi_1705_ = _e3648;
                        }
                        let _e3651 = phi_1705_;
                        let _e3653 = local_12.member_3;
                        let _e3657 = local_12.member_2[0u];
                        if (_e3657[0] < 0f) {
                            phi_1722_ = -(_e3657[0]);
                        } else {
                            phi_1722_ = _e3657[0];
                        }
                        let _e3664 = phi_1722_;
                        if (_e3657[1] < 0f) {
                            phi_1729_ = -(_e3657[1]);
                        } else {
                            phi_1729_ = _e3657[1];
                        }
                        let _e3668 = phi_1729_;
                        if (_e3664 > _e3668) {
                            phi_1734_ = _e3664;
                        } else {
                            phi_1734_ = _e3668;
                        }
                        let _e3671 = phi_1734_;
                        if (_e3657[2] < 0f) {
                            phi_1741_ = -(_e3657[2]);
                        } else {
                            phi_1741_ = _e3657[2];
                        }
                        let _e3675 = phi_1741_;
                        if (_e3671 > _e3675) {
                            phi_1746_ = _e3671;
                        } else {
                            phi_1746_ = _e3675;
                        }
                        let _e3678 = phi_1746_;
                        let _e3681 = local_12.member_2[1u];
                        if (_e3681[0] < 0f) {
                            phi_1760_ = -(_e3681[0]);
                        } else {
                            phi_1760_ = _e3681[0];
                        }
                        let _e3688 = phi_1760_;
                        if (_e3681[1] < 0f) {
                            phi_1767_ = -(_e3681[1]);
                        } else {
                            phi_1767_ = _e3681[1];
                        }
                        let _e3692 = phi_1767_;
                        if (_e3688 > _e3692) {
                            phi_1772_ = _e3688;
                        } else {
                            phi_1772_ = _e3692;
                        }
                        let _e3695 = phi_1772_;
                        if (_e3681[2] < 0f) {
                            phi_1779_ = -(_e3681[2]);
                        } else {
                            phi_1779_ = _e3681[2];
                        }
                        let _e3699 = phi_1779_;
                        if (_e3695 > _e3699) {
                            phi_1784_ = _e3695;
                        } else {
                            phi_1784_ = _e3699;
                        }
                        let _e3702 = phi_1784_;
                        if (_e3678 > _e3702) {
                            phi_1789_ = _e3678;
                        } else {
                            phi_1789_ = _e3702;
                        }
                        let _e3705 = phi_1789_;
                        let _e3707 = local_12.member_3;
                        let _e3714 = local_12.member_3;
                        local_9 = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_1828_ = type_19(0u, 96u);
                        phi_1831_ = 0f;
                        phi_1833_ = 0f;
                        phi_1835_ = 0f;
                        loop {
                            let _e3720 = phi_1828_;
                            let _e3722 = phi_1831_;
                            let _e3724 = phi_1833_;
                            let _e3726 = phi_1835_;
                            local_44 = _e3724;
                            local_26 = _e3722;
                            if (_e3720.member < _e3720.member_1) {
                                phi_1829_ = type_19((_e3720.member + 1u), _e3720.member_1);
                                phi_1858_ = type_19(1u, _e3720.member);
                            } else {
                                phi_1829_ = _e3720;
                                phi_1858_ = type_19(0u, type_19().member_1);
                            }
                            let _e3738 = phi_1829_;
                            let _e3740 = phi_1858_;
                            if (bitcast<i32>(_e3740.member) != 0i) {
                                let _e3747 = local_12.member[0u];
                                let _e3753 = local_12.member[1u];
                                let _e3769 = local_12.member_1[0u];
                                let _e3775 = local_12.member_1[1u];
                                let _e3791 = local_12.member_2[0u];
                                let _e3797 = local_12.member_2[1u];
                                let _e3811 = function_2(array<f32, 3>((_e3747[0] + ((_e3753[0] - _e3747[0]) * _e3722)), (_e3747[1] + ((_e3753[1] - _e3747[1]) * _e3722)), (_e3747[2] + ((_e3753[2] - _e3747[2]) * _e3722))), array<f32, 3>((_e3769[0] + ((_e3775[0] - _e3769[0]) * _e3722)), (_e3769[1] + ((_e3775[1] - _e3769[1]) * _e3722)), (_e3769[2] + ((_e3775[2] - _e3769[2]) * _e3722))), array<f32, 3>((_e3791[0] + ((_e3797[0] - _e3791[0]) * _e3722)), (_e3791[1] + ((_e3797[1] - _e3791[1]) * _e3722)), (_e3791[2] + ((_e3797[2] - _e3791[2]) * _e3722))), 1u);
                                if (_e3811[0] < 0f) {
                                    phi_1970_ = -(_e3811[0]);
                                } else {
                                    phi_1970_ = _e3811[0];
                                }
                                let _e3816 = phi_1970_;
                                if (_e3811[1] < 0f) {
                                    phi_1977_ = -(_e3811[1]);
                                } else {
                                    phi_1977_ = _e3811[1];
                                }
                                let _e3821 = phi_1977_;
                                if (_e3811[2] < 0f) {
                                    phi_1985_ = -(_e3811[2]);
                                } else {
                                    phi_1985_ = _e3811[2];
                                }
                                let _e3827 = phi_1985_;
                                let _e3828 = ((_e3816 + _e3821) + _e3827);
                                if (_e3828 > 0f) {
                                    if ((bitcast<u32>(_e3828) & 2139095040u) != 2139095040u) {
                                        let _e3833 = (1f / _e3828);
                                        let _e3835 = (_e3811[0] * _e3833);
                                        let _e3837 = (_e3811[1] * _e3833);
                                        let _e3839 = (_e3811[2] * _e3833);
                                        let _e3844 = (((_e3835 * _e3835) + (_e3837 * _e3837)) + (_e3839 * _e3839));
                                        if (_e3844 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3844 > 0f) {
                                                phi_2022_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2022_ = 0f;
                                            }
                                            let _e3897 = phi_2022_;
                                            phi_2086_ = _e3897;
                                        } else {
                                            phi_2029_ = type_17(0i, 5i);
                                            phi_2032_ = bitcast<f32>(((bitcast<u32>(_e3844) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3852 = phi_2029_;
                                                let _e3854 = phi_2032_;
                                                local_24 = _e3854;
                                                if (_e3852.member < _e3852.member_1) {
                                                    let _e3861 = (_e3852.member + 1i);
                                                    if ((false == (_e3861 > _e3852.member)) != false) {
                                                        phi_2053_ = true;
                                                    } else {
                                                        phi_2053_ = false;
                                                    }
                                                    let _e3866 = phi_2053_;
                                                    if _e3866 {
                                                        phi_2059_ = type_18(0u, type_18().member_1);
                                                    } else {
                                                        phi_2059_ = type_18(1u, _e3861);
                                                    }
                                                    let _e3871 = phi_2059_;
                                                    phi_2030_ = type_17(_e3871.member_1, _e3852.member_1);
                                                    phi_2073_ = type_18(1u, _e3852.member);
                                                } else {
                                                    phi_2030_ = _e3852;
                                                    phi_2073_ = type_18(0u, type_18().member_1);
                                                }
                                                let _e3877 = phi_2030_;
                                                let _e3879 = phi_2073_;
                                                let _e3882 = (bitcast<i32>(_e3879.member) != 0i);
                                                if _e3882 {
                                                    phi_2033_ = (0.5f * (_e3854 + (_e3844 / _e3854)));
                                                } else {
                                                    phi_2033_ = f32();
                                                }
                                                let _e3887 = phi_2033_;
                                                continue;
                                                continuing {
                                                    phi_2029_ = _e3877;
                                                    phi_2032_ = _e3887;
                                                    break if !(_e3882);
                                                }
                                            }
                                            let _e3892 = local_24;
                                            phi_2086_ = (_e3892 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3899 = phi_2086_;
                                        let _e3900 = (0.000000059604645f * 12f);
                                        let _e3905 = ((((((((_e3597 + _e3599) + (_e3651 + _e3653)) + (_e3705 + _e3707)) * (0.000000059604645f * 16f)) + (_e3714 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e456.member_1 * _e3899) * (1f + _e3900)));
                                        let _e3910 = (((_e3835 * _e3495[0]) + (_e3837 * _e3495[1])) + (_e3839 * _e3495[2]));
                                        let _e3915 = (((_e3835 * _e3511) + (_e3837 * _e3512)) + (_e3839 * _e3513));
                                        let _e3920 = (((_e3835 * (_e3495[0] - _e3507[0])) + (_e3837 * (_e3495[1] - _e3507[1]))) + (_e3839 * (_e3495[2] - _e3507[2])));
                                        let _e3925 = (((_e3835 * (_e3511 - _e3507[0])) + (_e3837 * (_e3512 - _e3507[1]))) + (_e3839 * (_e3513 - _e3507[2])));
                                        let _e3931 = (((_e3835 * _e3522[0]) + (_e3837 * _e3522[1])) + (_e3839 * _e3522[2]));
                                        let _e3936 = (((_e3835 * _e3538) + (_e3837 * _e3539)) + (_e3839 * _e3540));
                                        let _e3941 = (((_e3835 * (_e3522[0] - _e3534[0])) + (_e3837 * (_e3522[1] - _e3534[1]))) + (_e3839 * (_e3522[2] - _e3534[2])));
                                        let _e3946 = (((_e3835 * (_e3538 - _e3534[0])) + (_e3837 * (_e3539 - _e3534[1]))) + (_e3839 * (_e3540 - _e3534[2])));
                                        if (_e3910 < 0f) {
                                            phi_2152_ = -(_e3910);
                                        } else {
                                            phi_2152_ = _e3910;
                                        }
                                        let _e3951 = phi_2152_;
                                        if (_e3931 < 0f) {
                                            phi_2158_ = -(_e3931);
                                        } else {
                                            phi_2158_ = _e3931;
                                        }
                                        let _e3955 = phi_2158_;
                                        if (_e3915 < 0f) {
                                            phi_2167_ = -(_e3915);
                                        } else {
                                            phi_2167_ = _e3915;
                                        }
                                        let _e3962 = phi_2167_;
                                        if (_e3936 < 0f) {
                                            phi_2173_ = -(_e3936);
                                        } else {
                                            phi_2173_ = _e3936;
                                        }
                                        let _e3966 = phi_2173_;
                                        if (_e3920 < 0f) {
                                            phi_2182_ = -(_e3920);
                                        } else {
                                            phi_2182_ = _e3920;
                                        }
                                        let _e3973 = phi_2182_;
                                        if (_e3941 < 0f) {
                                            phi_2188_ = -(_e3941);
                                        } else {
                                            phi_2188_ = _e3941;
                                        }
                                        let _e3977 = phi_2188_;
                                        if (_e3925 < 0f) {
                                            phi_2197_ = -(_e3925);
                                        } else {
                                            phi_2197_ = _e3925;
                                        }
                                        let _e3984 = phi_2197_;
                                        if (_e3946 < 0f) {
                                            phi_2203_ = -(_e3946);
                                        } else {
                                            phi_2203_ = _e3946;
                                        }
                                        let _e3988 = phi_2203_;
                                        phi_2209_ = type_28(array<f32, 4>(_e3910, _e3915, _e3920, _e3925), array<f32, 4>(_e3931, _e3936, _e3941, _e3946), array<f32, 4>((_e3905 + ((_e3951 + _e3955) * _e3900)), (_e3905 + ((_e3962 + _e3966) * _e3900)), (_e3905 + ((_e3973 + _e3977) * _e3900)), (_e3905 + ((_e3984 + _e3988) * _e3900))));
                                        phi_2210_ = false;
                                    } else {
                                        phi_2209_ = type_28();
                                        phi_2210_ = true;
                                    }
                                    let _e3995 = phi_2209_;
                                    let _e3997 = phi_2210_;
                                    phi_2211_ = _e3995;
                                    phi_2212_ = _e3997;
                                } else {
                                    phi_2211_ = type_28();
                                    phi_2212_ = true;
                                }
                                let _e3999 = phi_2211_;
                                let _e4001 = phi_2212_;
                                if _e4001 {
                                    phi_2220_ = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2220_ = _e3999;
                                }
                                let _e4003 = phi_2220_;
                                local_10 = type_28(array<f32, 4>(_e4003.member[0], _e4003.member[1], _e4003.member[2], _e4003.member[3]), array<f32, 4>(_e4003.member_1[0], _e4003.member_1[1], _e4003.member_1[2], _e4003.member_1[3]), array<f32, 4>(_e4003.member_2[0], _e4003.member_2[1], _e4003.member_2[2], _e4003.member_2[3]));
                                let _e4023 = (_e3722 - _e3726);
                                let _e4026 = local_10.member[0u];
                                let _e4029 = local_10.member_1[0u];
                                let _e4032 = local_10.member[0u];
                                let _e4038 = local_10.member_2[0u];
                                if (((_e4026 + ((_e4029 - _e4032) * _e3722)) - _e4038) > 0f) {
                                    let _e4043 = local_10.member[1u];
                                    let _e4046 = local_10.member_1[1u];
                                    let _e4049 = local_10.member[1u];
                                    let _e4055 = local_10.member_2[1u];
                                    if (((_e4043 + ((_e4046 - _e4049) * _e3722)) - _e4055) > 0f) {
                                        let _e4060 = local_10.member[2u];
                                        let _e4063 = local_10.member_1[2u];
                                        let _e4066 = local_10.member[2u];
                                        let _e4072 = local_10.member_2[2u];
                                        if (((_e4060 + ((_e4063 - _e4066) * _e3722)) - _e4072) > 0f) {
                                            let _e4077 = local_10.member[3u];
                                            let _e4080 = local_10.member_1[3u];
                                            let _e4083 = local_10.member[3u];
                                            let _e4089 = local_10.member_2[3u];
                                            phi_2390_ = (((_e4077 + ((_e4080 - _e4083) * _e3722)) - _e4089) > 0f);
                                            phi_2391_ = false;
                                        } else {
                                            phi_2390_ = bool();
                                            phi_2391_ = true;
                                        }
                                        let _e4093 = phi_2390_;
                                        let _e4095 = phi_2391_;
                                        phi_2392_ = _e4093;
                                        phi_2393_ = _e4095;
                                    } else {
                                        phi_2392_ = bool();
                                        phi_2393_ = true;
                                    }
                                    let _e4097 = phi_2392_;
                                    let _e4099 = phi_2393_;
                                    phi_2394_ = _e4097;
                                    phi_2395_ = _e4099;
                                } else {
                                    phi_2394_ = bool();
                                    phi_2395_ = true;
                                }
                                let _e4101 = phi_2394_;
                                let _e4103 = phi_2395_;
                                if _e4103 {
                                    phi_2399_ = false;
                                } else {
                                    phi_2399_ = _e4101;
                                }
                                let _e4105 = phi_2399_;
                                if _e4105 {
                                    if (_e3722 <= _e3724) {
                                        phi_2709_ = true;
                                    } else {
                                        let _e4109 = local_9.member[0u];
                                        let _e4112 = local_9.member_1[0u];
                                        let _e4115 = local_9.member[0u];
                                        let _e4121 = local_9.member_2[0u];
                                        let _e4125 = local_10.member[0u];
                                        let _e4128 = local_10.member_1[0u];
                                        let _e4131 = local_10.member[0u];
                                        let _e4137 = local_10.member_2[0u];
                                        if ((((_e4109 + ((_e4112 - _e4115) * _e3722)) - _e4121) + ((_e4125 + ((_e4128 - _e4131) * _e3726)) - _e4137)) > 0f) {
                                            let _e4143 = local_9.member[1u];
                                            let _e4146 = local_9.member_1[1u];
                                            let _e4149 = local_9.member[1u];
                                            let _e4155 = local_9.member_2[1u];
                                            let _e4159 = local_10.member[1u];
                                            let _e4162 = local_10.member_1[1u];
                                            let _e4165 = local_10.member[1u];
                                            let _e4171 = local_10.member_2[1u];
                                            if ((((_e4143 + ((_e4146 - _e4149) * _e3722)) - _e4155) + ((_e4159 + ((_e4162 - _e4165) * _e3726)) - _e4171)) > 0f) {
                                                let _e4177 = local_9.member[2u];
                                                let _e4180 = local_9.member_1[2u];
                                                let _e4183 = local_9.member[2u];
                                                let _e4189 = local_9.member_2[2u];
                                                let _e4193 = local_10.member[2u];
                                                let _e4196 = local_10.member_1[2u];
                                                let _e4199 = local_10.member[2u];
                                                let _e4205 = local_10.member_2[2u];
                                                if ((((_e4177 + ((_e4180 - _e4183) * _e3722)) - _e4189) + ((_e4193 + ((_e4196 - _e4199) * _e3726)) - _e4205)) > 0f) {
                                                    let _e4211 = local_9.member[3u];
                                                    let _e4214 = local_9.member_1[3u];
                                                    let _e4217 = local_9.member[3u];
                                                    let _e4223 = local_9.member_2[3u];
                                                    let _e4227 = local_10.member[3u];
                                                    let _e4230 = local_10.member_1[3u];
                                                    let _e4233 = local_10.member[3u];
                                                    let _e4239 = local_10.member_2[3u];
                                                    phi_2696_ = ((((_e4211 + ((_e4214 - _e4217) * _e3722)) - _e4223) + ((_e4227 + ((_e4230 - _e4233) * _e3726)) - _e4239)) > 0f);
                                                    phi_2697_ = false;
                                                } else {
                                                    phi_2696_ = bool();
                                                    phi_2697_ = true;
                                                }
                                                let _e4244 = phi_2696_;
                                                let _e4246 = phi_2697_;
                                                phi_2698_ = _e4244;
                                                phi_2699_ = _e4246;
                                            } else {
                                                phi_2698_ = bool();
                                                phi_2699_ = true;
                                            }
                                            let _e4248 = phi_2698_;
                                            let _e4250 = phi_2699_;
                                            phi_2700_ = _e4248;
                                            phi_2701_ = _e4250;
                                        } else {
                                            phi_2700_ = bool();
                                            phi_2701_ = true;
                                        }
                                        let _e4252 = phi_2700_;
                                        let _e4254 = phi_2701_;
                                        if _e4254 {
                                            phi_2705_ = false;
                                        } else {
                                            phi_2705_ = _e4252;
                                        }
                                        let _e4256 = phi_2705_;
                                        phi_2709_ = _e4256;
                                    }
                                    let _e4258 = phi_2709_;
                                    if _e4258 {
                                        if (_e3740.member_1 > 0u) {
                                            if (_e3722 >= 1f) {
                                                phi_2721_ = false;
                                            } else {
                                                phi_2721_ = true;
                                            }
                                            let _e4262 = phi_2721_;
                                            phi_2722_ = _e4262;
                                        } else {
                                            phi_2722_ = true;
                                        }
                                        let _e4264 = phi_2722_;
                                        if _e4264 {
                                            local_9 = type_28(array<f32, 4>(_e4003.member[0], _e4003.member[1], _e4003.member[2], _e4003.member[3]), array<f32, 4>(_e4003.member_1[0], _e4003.member_1[1], _e4003.member_1[2], _e4003.member_1[3]), array<f32, 4>(_e4003.member_2[0], _e4003.member_2[1], _e4003.member_2[2], _e4003.member_2[3]));
                                            let _e4286 = local_9.member[0u];
                                            let _e4289 = local_9.member_1[0u];
                                            let _e4292 = local_9.member_2[0u];
                                            if (_e4286 > _e4292) {
                                                if (_e4289 > _e4292) {
                                                    phi_2796_ = false;
                                                } else {
                                                    phi_2796_ = true;
                                                }
                                                let _e4296 = phi_2796_;
                                                phi_2797_ = _e4296;
                                            } else {
                                                phi_2797_ = true;
                                            }
                                            let _e4298 = phi_2797_;
                                            if _e4298 {
                                                let _e4299 = (_e4289 >= _e4286);
                                                if _e4299 {
                                                    phi_2819_ = f32();
                                                    phi_2820_ = false;
                                                } else {
                                                    if ((_e4286 - _e4289) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2817_ = (((_e4286 - _e4292) / (_e4286 - _e4289)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2818_ = false;
                                                    } else {
                                                        phi_2817_ = f32();
                                                        phi_2818_ = true;
                                                    }
                                                    let _e4310 = phi_2817_;
                                                    let _e4312 = phi_2818_;
                                                    phi_2819_ = _e4310;
                                                    phi_2820_ = _e4312;
                                                }
                                                let _e4314 = phi_2819_;
                                                let _e4316 = phi_2820_;
                                                phi_2821_ = _e4314;
                                                phi_2822_ = _e4299;
                                                phi_2823_ = _e4316;
                                            } else {
                                                phi_2821_ = f32();
                                                phi_2822_ = true;
                                                phi_2823_ = false;
                                            }
                                            let _e4318 = phi_2821_;
                                            let _e4320 = phi_2822_;
                                            let _e4322 = phi_2823_;
                                            if _e4320 {
                                                phi_2827_ = 2f;
                                                phi_2828_ = true;
                                            } else {
                                                phi_2827_ = _e3722;
                                                phi_2828_ = _e4322;
                                            }
                                            let _e4324 = phi_2827_;
                                            let _e4326 = phi_2828_;
                                            if _e4326 {
                                                phi_2832_ = _e4324;
                                            } else {
                                                phi_2832_ = _e4318;
                                            }
                                            let _e4328 = phi_2832_;
                                            let _e4331 = local_9.member[1u];
                                            let _e4334 = local_9.member_1[1u];
                                            let _e4337 = local_9.member_2[1u];
                                            if (_e4331 > _e4337) {
                                                if (_e4334 > _e4337) {
                                                    phi_2864_ = false;
                                                } else {
                                                    phi_2864_ = true;
                                                }
                                                let _e4341 = phi_2864_;
                                                phi_2865_ = _e4341;
                                            } else {
                                                phi_2865_ = true;
                                            }
                                            let _e4343 = phi_2865_;
                                            if _e4343 {
                                                let _e4344 = (_e4334 >= _e4331);
                                                if _e4344 {
                                                    phi_2887_ = f32();
                                                    phi_2888_ = false;
                                                } else {
                                                    if ((_e4331 - _e4334) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2885_ = (((_e4331 - _e4337) / (_e4331 - _e4334)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2886_ = false;
                                                    } else {
                                                        phi_2885_ = f32();
                                                        phi_2886_ = true;
                                                    }
                                                    let _e4355 = phi_2885_;
                                                    let _e4357 = phi_2886_;
                                                    phi_2887_ = _e4355;
                                                    phi_2888_ = _e4357;
                                                }
                                                let _e4359 = phi_2887_;
                                                let _e4361 = phi_2888_;
                                                phi_2889_ = _e4359;
                                                phi_2890_ = _e4344;
                                                phi_2891_ = _e4361;
                                            } else {
                                                phi_2889_ = f32();
                                                phi_2890_ = true;
                                                phi_2891_ = false;
                                            }
                                            let _e4363 = phi_2889_;
                                            let _e4365 = phi_2890_;
                                            let _e4367 = phi_2891_;
                                            if _e4365 {
                                                phi_2895_ = 2f;
                                                phi_2896_ = true;
                                            } else {
                                                phi_2895_ = _e3722;
                                                phi_2896_ = _e4367;
                                            }
                                            let _e4369 = phi_2895_;
                                            let _e4371 = phi_2896_;
                                            if _e4371 {
                                                phi_2900_ = _e4369;
                                            } else {
                                                phi_2900_ = _e4363;
                                            }
                                            let _e4373 = phi_2900_;
                                            if (_e4328 < _e4373) {
                                                phi_2905_ = _e4328;
                                            } else {
                                                phi_2905_ = _e4373;
                                            }
                                            let _e4376 = phi_2905_;
                                            let _e4379 = local_9.member[2u];
                                            let _e4382 = local_9.member_1[2u];
                                            let _e4385 = local_9.member_2[2u];
                                            if (_e4379 > _e4385) {
                                                if (_e4382 > _e4385) {
                                                    phi_2937_ = false;
                                                } else {
                                                    phi_2937_ = true;
                                                }
                                                let _e4389 = phi_2937_;
                                                phi_2938_ = _e4389;
                                            } else {
                                                phi_2938_ = true;
                                            }
                                            let _e4391 = phi_2938_;
                                            if _e4391 {
                                                let _e4392 = (_e4382 >= _e4379);
                                                if _e4392 {
                                                    phi_2960_ = f32();
                                                    phi_2961_ = false;
                                                } else {
                                                    if ((_e4379 - _e4382) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2958_ = (((_e4379 - _e4385) / (_e4379 - _e4382)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2959_ = false;
                                                    } else {
                                                        phi_2958_ = f32();
                                                        phi_2959_ = true;
                                                    }
                                                    let _e4403 = phi_2958_;
                                                    let _e4405 = phi_2959_;
                                                    phi_2960_ = _e4403;
                                                    phi_2961_ = _e4405;
                                                }
                                                let _e4407 = phi_2960_;
                                                let _e4409 = phi_2961_;
                                                phi_2962_ = _e4407;
                                                phi_2963_ = _e4392;
                                                phi_2964_ = _e4409;
                                            } else {
                                                phi_2962_ = f32();
                                                phi_2963_ = true;
                                                phi_2964_ = false;
                                            }
                                            let _e4411 = phi_2962_;
                                            let _e4413 = phi_2963_;
                                            let _e4415 = phi_2964_;
                                            if _e4413 {
                                                phi_2968_ = 2f;
                                                phi_2969_ = true;
                                            } else {
                                                phi_2968_ = _e3722;
                                                phi_2969_ = _e4415;
                                            }
                                            let _e4417 = phi_2968_;
                                            let _e4419 = phi_2969_;
                                            if _e4419 {
                                                phi_2973_ = _e4417;
                                            } else {
                                                phi_2973_ = _e4411;
                                            }
                                            let _e4421 = phi_2973_;
                                            let _e4424 = local_9.member[3u];
                                            let _e4427 = local_9.member_1[3u];
                                            let _e4430 = local_9.member_2[3u];
                                            if (_e4424 > _e4430) {
                                                if (_e4427 > _e4430) {
                                                    phi_3005_ = false;
                                                } else {
                                                    phi_3005_ = true;
                                                }
                                                let _e4434 = phi_3005_;
                                                phi_3006_ = _e4434;
                                            } else {
                                                phi_3006_ = true;
                                            }
                                            let _e4436 = phi_3006_;
                                            if _e4436 {
                                                let _e4437 = (_e4427 >= _e4424);
                                                if _e4437 {
                                                    phi_3028_ = f32();
                                                    phi_3029_ = false;
                                                } else {
                                                    if ((_e4424 - _e4427) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3026_ = (((_e4424 - _e4430) / (_e4424 - _e4427)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3027_ = false;
                                                    } else {
                                                        phi_3026_ = f32();
                                                        phi_3027_ = true;
                                                    }
                                                    let _e4448 = phi_3026_;
                                                    let _e4450 = phi_3027_;
                                                    phi_3028_ = _e4448;
                                                    phi_3029_ = _e4450;
                                                }
                                                let _e4452 = phi_3028_;
                                                let _e4454 = phi_3029_;
                                                phi_3030_ = _e4452;
                                                phi_3031_ = _e4437;
                                                phi_3032_ = _e4454;
                                            } else {
                                                phi_3030_ = f32();
                                                phi_3031_ = true;
                                                phi_3032_ = false;
                                            }
                                            let _e4456 = phi_3030_;
                                            let _e4458 = phi_3031_;
                                            let _e4460 = phi_3032_;
                                            if _e4458 {
                                                phi_3036_ = 2f;
                                                phi_3037_ = true;
                                            } else {
                                                phi_3036_ = _e3722;
                                                phi_3037_ = _e4460;
                                            }
                                            let _e4462 = phi_3036_;
                                            let _e4464 = phi_3037_;
                                            if _e4464 {
                                                phi_3041_ = _e4462;
                                            } else {
                                                phi_3041_ = _e4456;
                                            }
                                            let _e4466 = phi_3041_;
                                            if (_e4421 < _e4466) {
                                                phi_3046_ = _e4421;
                                            } else {
                                                phi_3046_ = _e4466;
                                            }
                                            let _e4469 = phi_3046_;
                                            if (_e4376 < _e4469) {
                                                phi_3051_ = _e4376;
                                            } else {
                                                phi_3051_ = _e4469;
                                            }
                                            let _e4472 = phi_3051_;
                                            if (_e4472 > _e3722) {
                                                phi_3056_ = _e4472;
                                            } else {
                                                phi_3056_ = _e3722;
                                            }
                                            let _e4475 = phi_3056_;
                                            let _e4476 = (_e4475 > 1f);
                                            if _e4476 {
                                                phi_3068_ = f32();
                                                phi_3069_ = false;
                                            } else {
                                                if (_e3740.member_1 == 0u) {
                                                    phi_3067_ = (1f - _e3722);
                                                } else {
                                                    phi_3067_ = (_e4023 + _e4023);
                                                }
                                                let _e4481 = phi_3067_;
                                                phi_3068_ = _e4481;
                                                phi_3069_ = true;
                                            }
                                            let _e4483 = phi_3068_;
                                            let _e4485 = phi_3069_;
                                            phi_3070_ = _e4475;
                                            phi_3071_ = _e4483;
                                            phi_3072_ = _e4485;
                                            phi_3073_ = _e4476;
                                            phi_3074_ = false;
                                        } else {
                                            phi_3070_ = f32();
                                            phi_3071_ = f32();
                                            phi_3072_ = false;
                                            phi_3073_ = false;
                                            phi_3074_ = true;
                                        }
                                        let _e4487 = phi_3070_;
                                        let _e4489 = phi_3071_;
                                        let _e4491 = phi_3072_;
                                        let _e4493 = phi_3073_;
                                        let _e4495 = phi_3074_;
                                        phi_3075_ = _e4487;
                                        phi_3076_ = _e4489;
                                        phi_3077_ = false;
                                        phi_3078_ = _e4491;
                                        phi_3079_ = _e4493;
                                        phi_3080_ = _e4495;
                                    } else {
                                        phi_3075_ = f32();
                                        phi_3076_ = f32();
                                        phi_3077_ = true;
                                        phi_3078_ = false;
                                        phi_3079_ = false;
                                        phi_3080_ = false;
                                    }
                                    let _e4497 = phi_3075_;
                                    let _e4499 = phi_3076_;
                                    let _e4501 = phi_3077_;
                                    let _e4503 = phi_3078_;
                                    let _e4505 = phi_3079_;
                                    let _e4507 = phi_3080_;
                                    phi_3081_ = _e4497;
                                    phi_3082_ = _e4499;
                                    phi_3083_ = _e4501;
                                    phi_3084_ = _e4503;
                                    phi_3085_ = _e4505;
                                    phi_3086_ = _e4507;
                                } else {
                                    phi_3081_ = f32();
                                    phi_3082_ = f32();
                                    phi_3083_ = true;
                                    phi_3084_ = false;
                                    phi_3085_ = false;
                                    phi_3086_ = false;
                                }
                                let _e4509 = phi_3081_;
                                let _e4511 = phi_3082_;
                                let _e4513 = phi_3083_;
                                let _e4515 = phi_3084_;
                                let _e4517 = phi_3085_;
                                let _e4519 = phi_3086_;
                                if _e4513 {
                                    let _e4520 = (_e3722 <= _e3724);
                                    if _e4520 {
                                        phi_3415_ = f32();
                                        phi_3416_ = false;
                                    } else {
                                        let _e4523 = local_9.member[0u];
                                        let _e4526 = local_9.member_1[0u];
                                        let _e4529 = local_9.member[0u];
                                        let _e4535 = local_9.member_2[0u];
                                        let _e4536 = ((_e4523 + ((_e4526 - _e4529) * _e3726)) - _e4535);
                                        let _e4539 = local_9.member[1u];
                                        let _e4542 = local_9.member_1[1u];
                                        let _e4545 = local_9.member[1u];
                                        let _e4551 = local_9.member_2[1u];
                                        let _e4552 = ((_e4539 + ((_e4542 - _e4545) * _e3726)) - _e4551);
                                        if (_e4536 < _e4552) {
                                            phi_3166_ = _e4536;
                                        } else {
                                            phi_3166_ = _e4552;
                                        }
                                        let _e4555 = phi_3166_;
                                        let _e4558 = local_9.member[2u];
                                        let _e4561 = local_9.member_1[2u];
                                        let _e4564 = local_9.member[2u];
                                        let _e4570 = local_9.member_2[2u];
                                        let _e4571 = ((_e4558 + ((_e4561 - _e4564) * _e3726)) - _e4570);
                                        let _e4574 = local_9.member[3u];
                                        let _e4577 = local_9.member_1[3u];
                                        let _e4580 = local_9.member[3u];
                                        let _e4586 = local_9.member_2[3u];
                                        let _e4587 = ((_e4574 + ((_e4577 - _e4580) * _e3726)) - _e4586);
                                        if (_e4571 < _e4587) {
                                            phi_3239_ = _e4571;
                                        } else {
                                            phi_3239_ = _e4587;
                                        }
                                        let _e4590 = phi_3239_;
                                        if (_e4555 < _e4590) {
                                            phi_3244_ = _e4555;
                                        } else {
                                            phi_3244_ = _e4590;
                                        }
                                        let _e4593 = phi_3244_;
                                        let _e4596 = local_10.member[0u];
                                        let _e4599 = local_10.member_1[0u];
                                        let _e4602 = local_10.member[0u];
                                        let _e4608 = local_10.member_2[0u];
                                        let _e4609 = ((_e4596 + ((_e4599 - _e4602) * _e3722)) - _e4608);
                                        let _e4612 = local_10.member[1u];
                                        let _e4615 = local_10.member_1[1u];
                                        let _e4618 = local_10.member[1u];
                                        let _e4624 = local_10.member_2[1u];
                                        let _e4625 = ((_e4612 + ((_e4615 - _e4618) * _e3722)) - _e4624);
                                        if (_e4609 < _e4625) {
                                            phi_3317_ = _e4609;
                                        } else {
                                            phi_3317_ = _e4625;
                                        }
                                        let _e4628 = phi_3317_;
                                        let _e4631 = local_10.member[2u];
                                        let _e4634 = local_10.member_1[2u];
                                        let _e4637 = local_10.member[2u];
                                        let _e4643 = local_10.member_2[2u];
                                        let _e4644 = ((_e4631 + ((_e4634 - _e4637) * _e3722)) - _e4643);
                                        let _e4647 = local_10.member[3u];
                                        let _e4650 = local_10.member_1[3u];
                                        let _e4653 = local_10.member[3u];
                                        let _e4659 = local_10.member_2[3u];
                                        let _e4660 = ((_e4647 + ((_e4650 - _e4653) * _e3722)) - _e4659);
                                        if (_e4644 < _e4660) {
                                            phi_3390_ = _e4644;
                                        } else {
                                            phi_3390_ = _e4660;
                                        }
                                        let _e4663 = phi_3390_;
                                        if (_e4628 < _e4663) {
                                            phi_3395_ = _e4628;
                                        } else {
                                            phi_3395_ = _e4663;
                                        }
                                        let _e4666 = phi_3395_;
                                        if (_e4666 > 0f) {
                                            phi_3413_ = 0.5f;
                                        } else {
                                            let _e4670 = (0.95f * (_e4593 / (_e4593 - _e4666)));
                                            if (_e4670 > 0.0625f) {
                                                if (_e4670 < 0.9f) {
                                                    phi_3411_ = _e4670;
                                                } else {
                                                    phi_3411_ = 0.9f;
                                                }
                                                let _e4674 = phi_3411_;
                                                phi_3412_ = _e4674;
                                            } else {
                                                phi_3412_ = 0.0625f;
                                            }
                                            let _e4676 = phi_3412_;
                                            phi_3413_ = _e4676;
                                        }
                                        let _e4678 = phi_3413_;
                                        phi_3415_ = (_e4023 * _e4678);
                                        phi_3416_ = true;
                                    }
                                    let _e4681 = phi_3415_;
                                    let _e4683 = phi_3416_;
                                    phi_3417_ = _e3724;
                                    phi_3418_ = _e4681;
                                    phi_3419_ = _e3726;
                                    phi_3420_ = _e4683;
                                    phi_3421_ = _e4520;
                                    phi_3422_ = false;
                                    phi_3423_ = false;
                                } else {
                                    phi_3417_ = _e4509;
                                    phi_3418_ = _e4511;
                                    phi_3419_ = _e3722;
                                    phi_3420_ = _e4515;
                                    phi_3421_ = false;
                                    phi_3422_ = _e4517;
                                    phi_3423_ = _e4519;
                                }
                                let _e4685 = phi_3417_;
                                let _e4687 = phi_3418_;
                                let _e4689 = phi_3419_;
                                let _e4691 = phi_3420_;
                                let _e4693 = phi_3421_;
                                let _e4695 = phi_3422_;
                                let _e4697 = phi_3423_;
                                if _e4691 {
                                    let _e4698 = (_e4689 + _e4687);
                                    if (_e4698 > _e4685) {
                                        phi_3432_ = _e4698;
                                    } else {
                                        phi_3432_ = _e4685;
                                    }
                                    let _e4701 = phi_3432_;
                                    if (_e4701 < 1f) {
                                        phi_3437_ = _e4701;
                                    } else {
                                        phi_3437_ = 1f;
                                    }
                                    let _e4704 = phi_3437_;
                                    if (_e3740.member_1 > 0u) {
                                        phi_3447_ = ((_e4704 - _e4689) > 0.0000000037252903f);
                                    } else {
                                        phi_3447_ = true;
                                    }
                                    let _e4709 = phi_3447_;
                                    if _e4709 {
                                        phi_3451_ = false;
                                    } else {
                                        phi_3451_ = true;
                                    }
                                    let _e4711 = phi_3451_;
                                    phi_3452_ = _e4704;
                                    phi_3453_ = _e4709;
                                    phi_3454_ = _e4711;
                                    phi_3455_ = false;
                                    phi_3456_ = false;
                                    phi_3457_ = false;
                                } else {
                                    phi_3452_ = f32();
                                    phi_3453_ = false;
                                    phi_3454_ = false;
                                    phi_3455_ = _e4693;
                                    phi_3456_ = _e4695;
                                    phi_3457_ = _e4697;
                                }
                                let _e4713 = phi_3452_;
                                let _e4715 = phi_3453_;
                                let _e4717 = phi_3454_;
                                let _e4719 = phi_3455_;
                                let _e4721 = phi_3456_;
                                let _e4723 = phi_3457_;
                                phi_1832_ = _e4713;
                                phi_1834_ = _e4685;
                                phi_1836_ = _e4689;
                                phi_3458_ = _e4685;
                                phi_3459_ = _e4715;
                                phi_3460_ = _e4717;
                                phi_3461_ = false;
                                phi_3462_ = _e4719;
                                phi_3463_ = _e4721;
                                phi_3464_ = _e4723;
                            } else {
                                phi_1832_ = f32();
                                phi_1834_ = f32();
                                phi_1836_ = f32();
                                phi_3458_ = f32();
                                phi_3459_ = false;
                                phi_3460_ = false;
                                phi_3461_ = true;
                                phi_3462_ = false;
                                phi_3463_ = false;
                                phi_3464_ = false;
                            }
                            let _e4725 = phi_1832_;
                            let _e4727 = phi_1834_;
                            let _e4729 = phi_1836_;
                            let _e4731 = phi_3458_;
                            let _e4733 = phi_3459_;
                            let _e4735 = phi_3460_;
                            let _e4737 = phi_3461_;
                            let _e4739 = phi_3462_;
                            let _e4741 = phi_3463_;
                            let _e4743 = phi_3464_;
                            local_25 = _e4735;
                            local_43 = _e4731;
                            local_45 = _e4737;
                            local_46 = _e4739;
                            local_47 = _e4741;
                            local_48 = _e4743;
                            continue;
                            continuing {
                                phi_1828_ = _e3738;
                                phi_1831_ = _e4725;
                                phi_1833_ = _e4727;
                                phi_1835_ = _e4729;
                                break if !(_e4733);
                            }
                        }
                        let _e4746 = local_25;
                        if _e4746 {
                            let _e6054 = local_43;
                            phi_3468_ = _e6054;
                            phi_3469_ = true;
                            phi_3470_ = false;
                            phi_3471_ = false;
                            phi_3472_ = false;
                        } else {
                            let _e6056 = local_44;
                            phi_3468_ = _e6056;
                            let _e6059 = local_45;
                            phi_3469_ = _e6059;
                            let _e6062 = local_46;
                            phi_3470_ = _e6062;
                            let _e6065 = local_47;
                            phi_3471_ = _e6065;
                            let _e6068 = local_48;
                            phi_3472_ = _e6068;
                        }
                        let _e4748 = phi_3468_;
                        let _e4750 = phi_3469_;
                        let _e4752 = phi_3470_;
                        let _e4754 = phi_3471_;
                        let _e4756 = phi_3472_;
                        if _e4750 {
                            phi_3477_ = type_33(1u, _e4748);
                            phi_3478_ = false;
                            phi_3479_ = false;
                            phi_3480_ = false;
                        } else {
                            phi_3477_ = type_33();
                            phi_3478_ = _e4752;
                            phi_3479_ = _e4754;
                            phi_3480_ = _e4756;
                        }
                        let _e4759 = phi_3477_;
                        let _e4761 = phi_3478_;
                        let _e4763 = phi_3479_;
                        let _e4765 = phi_3480_;
                        if _e4761 {
                            let _e4767 = local_26;
                            phi_3485_ = type_33(1u, _e4767);
                            phi_3486_ = false;
                            phi_3487_ = false;
                        } else {
                            phi_3485_ = type_33();
                            phi_3486_ = _e4763;
                            phi_3487_ = _e4765;
                        }
                        let _e4770 = phi_3485_;
                        let _e4772 = phi_3486_;
                        let _e4774 = phi_3487_;
                        if _e4772 {
                            phi_3492_ = type_33(0u, type_33().member_1);
                            phi_3493_ = false;
                            phi_3494_ = true;
                        } else {
                            phi_3492_ = _e4770;
                            phi_3493_ = _e4774;
                            phi_3494_ = _e4761;
                        }
                        let _e4778 = phi_3492_;
                        let _e4780 = phi_3493_;
                        let _e4782 = phi_3494_;
                        if _e4780 {
                            phi_3499_ = type_33(0u, type_33().member_1);
                            phi_3500_ = true;
                        } else {
                            phi_3499_ = _e4778;
                            phi_3500_ = _e4782;
                        }
                        let _e4786 = phi_3499_;
                        let _e4788 = phi_3500_;
                        if _e4788 {
                            phi_3504_ = _e4786;
                        } else {
                            phi_3504_ = _e4759;
                        }
                        let _e4790 = phi_3504_;
                        if (_e4790.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_3518_ = type_19(0u, 3u);
                            loop {
                                let _e4802 = phi_3518_;
                                if (_e4802.member < _e4802.member_1) {
                                    phi_3519_ = type_19((_e4802.member + 1u), _e4802.member_1);
                                    phi_3542_ = type_19(1u, _e4802.member);
                                } else {
                                    phi_3519_ = _e4802;
                                    phi_3542_ = type_19(0u, type_19().member_1);
                                }
                                let _e4814 = phi_3519_;
                                let _e4816 = phi_3542_;
                                if (bitcast<i32>(_e4816.member) != 0i) {
                                    let _e4822 = local_11[_e4816.member_1];
                                    let _e4823 = (_e4790.member_1 + _e4822);
                                    if (_e4823 < 1f) {
                                        phi_3562_ = _e4823;
                                    } else {
                                        phi_3562_ = 1f;
                                    }
                                    let _e4826 = phi_3562_;
                                    let _e4829 = local_12.member[0u];
                                    let _e4835 = local_12.member[1u];
                                    let _e4851 = local_12.member_1[0u];
                                    let _e4857 = local_12.member_1[1u];
                                    let _e4873 = local_12.member_2[0u];
                                    let _e4879 = local_12.member_2[1u];
                                    let _e4893 = function_2(array<f32, 3>((_e4829[0] + ((_e4835[0] - _e4829[0]) * _e4826)), (_e4829[1] + ((_e4835[1] - _e4829[1]) * _e4826)), (_e4829[2] + ((_e4835[2] - _e4829[2]) * _e4826))), array<f32, 3>((_e4851[0] + ((_e4857[0] - _e4851[0]) * _e4826)), (_e4851[1] + ((_e4857[1] - _e4851[1]) * _e4826)), (_e4851[2] + ((_e4857[2] - _e4851[2]) * _e4826))), array<f32, 3>((_e4873[0] + ((_e4879[0] - _e4873[0]) * _e4826)), (_e4873[1] + ((_e4879[1] - _e4873[1]) * _e4826)), (_e4873[2] + ((_e4879[2] - _e4873[2]) * _e4826))), 1u);
                                    let _e4904 = (((_e4893[0] * _e4893[0]) + (_e4893[1] * _e4893[1])) + (_e4893[2] * _e4893[2]));
                                    if (_e4904 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4904 > 0f) {
                                            phi_3685_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3685_ = 0f;
                                        }
                                        let _e4957 = phi_3685_;
                                        phi_3749_ = _e4957;
                                    } else {
                                        phi_3692_ = type_17(0i, 5i);
                                        phi_3695_ = bitcast<f32>(((bitcast<u32>(_e4904) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4912 = phi_3692_;
                                            let _e4914 = phi_3695_;
                                            local_27 = _e4914;
                                            if (_e4912.member < _e4912.member_1) {
                                                let _e4921 = (_e4912.member + 1i);
                                                if ((false == (_e4921 > _e4912.member)) != false) {
                                                    phi_3716_ = true;
                                                } else {
                                                    phi_3716_ = false;
                                                }
                                                let _e4926 = phi_3716_;
                                                if _e4926 {
                                                    phi_3722_ = type_18(0u, type_18().member_1);
                                                } else {
                                                    phi_3722_ = type_18(1u, _e4921);
                                                }
                                                let _e4931 = phi_3722_;
                                                phi_3693_ = type_17(_e4931.member_1, _e4912.member_1);
                                                phi_3736_ = type_18(1u, _e4912.member);
                                            } else {
                                                phi_3693_ = _e4912;
                                                phi_3736_ = type_18(0u, type_18().member_1);
                                            }
                                            let _e4937 = phi_3693_;
                                            let _e4939 = phi_3736_;
                                            let _e4942 = (bitcast<i32>(_e4939.member) != 0i);
                                            if _e4942 {
                                                phi_3696_ = (0.5f * (_e4914 + (_e4904 / _e4914)));
                                            } else {
                                                phi_3696_ = f32();
                                            }
                                            let _e4947 = phi_3696_;
                                            continue;
                                            continuing {
                                                phi_3692_ = _e4937;
                                                phi_3695_ = _e4947;
                                                break if !(_e4942);
                                            }
                                        }
                                        let _e4952 = local_27;
                                        phi_3749_ = (_e4952 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e4959 = phi_3749_;
                                    let _e4965 = local_12.member[0u];
                                    if (_e4965[0] < 0f) {
                                        phi_3765_ = -(_e4965[0]);
                                    } else {
                                        phi_3765_ = _e4965[0];
                                    }
                                    let _e4972 = phi_3765_;
                                    if (_e4965[1] < 0f) {
                                        phi_3772_ = -(_e4965[1]);
                                    } else {
                                        phi_3772_ = _e4965[1];
                                    }
                                    let _e4976 = phi_3772_;
                                    if (_e4972 > _e4976) {
                                        phi_3777_ = _e4972;
                                    } else {
                                        phi_3777_ = _e4976;
                                    }
                                    let _e4979 = phi_3777_;
                                    if (_e4965[2] < 0f) {
                                        phi_3784_ = -(_e4965[2]);
                                    } else {
                                        phi_3784_ = _e4965[2];
                                    }
                                    let _e4983 = phi_3784_;
                                    if (_e4979 > _e4983) {
                                        phi_3789_ = _e4979;
                                    } else {
                                        phi_3789_ = _e4983;
                                    }
                                    let _e4986 = phi_3789_;
                                    let _e4989 = local_12.member[1u];
                                    if (_e4989[0] < 0f) {
                                        phi_3802_ = -(_e4989[0]);
                                    } else {
                                        phi_3802_ = _e4989[0];
                                    }
                                    let _e4996 = phi_3802_;
                                    if (_e4989[1] < 0f) {
                                        phi_3809_ = -(_e4989[1]);
                                    } else {
                                        phi_3809_ = _e4989[1];
                                    }
                                    let _e5000 = phi_3809_;
                                    if (_e4996 > _e5000) {
                                        phi_3814_ = _e4996;
                                    } else {
                                        phi_3814_ = _e5000;
                                    }
                                    let _e5003 = phi_3814_;
                                    if (_e4989[2] < 0f) {
                                        phi_3821_ = -(_e4989[2]);
                                    } else {
                                        phi_3821_ = _e4989[2];
                                    }
                                    let _e5007 = phi_3821_;
                                    if (_e5003 > _e5007) {
                                        phi_3826_ = _e5003;
                                    } else {
                                        phi_3826_ = _e5007;
                                    }
                                    let _e5010 = phi_3826_;
                                    if (_e4986 > _e5010) {
                                        phi_3831_ = _e4986;
                                    } else {
                                        phi_3831_ = _e5010;
                                    }
                                    let _e5013 = phi_3831_;
                                    let _e5015 = local_12.member_3;
                                    let _e5019 = local_12.member_1[0u];
                                    if (_e5019[0] < 0f) {
                                        phi_3848_ = -(_e5019[0]);
                                    } else {
                                        phi_3848_ = _e5019[0];
                                    }
                                    let _e5026 = phi_3848_;
                                    if (_e5019[1] < 0f) {
                                        phi_3855_ = -(_e5019[1]);
                                    } else {
                                        phi_3855_ = _e5019[1];
                                    }
                                    let _e5030 = phi_3855_;
                                    if (_e5026 > _e5030) {
                                        phi_3860_ = _e5026;
                                    } else {
                                        phi_3860_ = _e5030;
                                    }
                                    let _e5033 = phi_3860_;
                                    if (_e5019[2] < 0f) {
                                        phi_3867_ = -(_e5019[2]);
                                    } else {
                                        phi_3867_ = _e5019[2];
                                    }
                                    let _e5037 = phi_3867_;
                                    if (_e5033 > _e5037) {
                                        phi_3872_ = _e5033;
                                    } else {
                                        phi_3872_ = _e5037;
                                    }
                                    let _e5040 = phi_3872_;
                                    let _e5043 = local_12.member_1[1u];
                                    if (_e5043[0] < 0f) {
                                        phi_3886_ = -(_e5043[0]);
                                    } else {
                                        phi_3886_ = _e5043[0];
                                    }
                                    let _e5050 = phi_3886_;
                                    if (_e5043[1] < 0f) {
                                        phi_3893_ = -(_e5043[1]);
                                    } else {
                                        phi_3893_ = _e5043[1];
                                    }
                                    let _e5054 = phi_3893_;
                                    if (_e5050 > _e5054) {
                                        phi_3898_ = _e5050;
                                    } else {
                                        phi_3898_ = _e5054;
                                    }
                                    let _e5057 = phi_3898_;
                                    if (_e5043[2] < 0f) {
                                        phi_3905_ = -(_e5043[2]);
                                    } else {
                                        phi_3905_ = _e5043[2];
                                    }
                                    let _e5061 = phi_3905_;
                                    if (_e5057 > _e5061) {
                                        phi_3910_ = _e5057;
                                    } else {
                                        phi_3910_ = _e5061;
                                    }
                                    let _e5064 = phi_3910_;
                                    if (_e5040 > _e5064) {
                                        phi_3915_ = _e5040;
                                    } else {
                                        phi_3915_ = _e5064;
                                    }
                                    let _e5067 = phi_3915_;
                                    let _e5069 = local_12.member_3;
                                    let _e5073 = local_12.member_2[0u];
                                    if (_e5073[0] < 0f) {
                                        phi_3932_ = -(_e5073[0]);
                                    } else {
                                        phi_3932_ = _e5073[0];
                                    }
                                    let _e5080 = phi_3932_;
                                    if (_e5073[1] < 0f) {
                                        phi_3939_ = -(_e5073[1]);
                                    } else {
                                        phi_3939_ = _e5073[1];
                                    }
                                    let _e5084 = phi_3939_;
                                    if (_e5080 > _e5084) {
                                        phi_3944_ = _e5080;
                                    } else {
                                        phi_3944_ = _e5084;
                                    }
                                    let _e5087 = phi_3944_;
                                    if (_e5073[2] < 0f) {
                                        phi_3951_ = -(_e5073[2]);
                                    } else {
                                        phi_3951_ = _e5073[2];
                                    }
                                    let _e5091 = phi_3951_;
                                    if (_e5087 > _e5091) {
                                        phi_3956_ = _e5087;
                                    } else {
                                        phi_3956_ = _e5091;
                                    }
                                    let _e5094 = phi_3956_;
                                    let _e5097 = local_12.member_2[1u];
                                    if (_e5097[0] < 0f) {
                                        phi_3970_ = -(_e5097[0]);
                                    } else {
                                        phi_3970_ = _e5097[0];
                                    }
                                    let _e5104 = phi_3970_;
                                    if (_e5097[1] < 0f) {
                                        phi_3977_ = -(_e5097[1]);
                                    } else {
                                        phi_3977_ = _e5097[1];
                                    }
                                    let _e5108 = phi_3977_;
                                    if (_e5104 > _e5108) {
                                        phi_3982_ = _e5104;
                                    } else {
                                        phi_3982_ = _e5108;
                                    }
                                    let _e5111 = phi_3982_;
                                    if (_e5097[2] < 0f) {
                                        phi_3989_ = -(_e5097[2]);
                                    } else {
                                        phi_3989_ = _e5097[2];
                                    }
                                    let _e5115 = phi_3989_;
                                    if (_e5111 > _e5115) {
                                        phi_3994_ = _e5111;
                                    } else {
                                        phi_3994_ = _e5115;
                                    }
                                    let _e5118 = phi_3994_;
                                    if (_e5094 > _e5118) {
                                        phi_3999_ = _e5094;
                                    } else {
                                        phi_3999_ = _e5118;
                                    }
                                    let _e5121 = phi_3999_;
                                    let _e5123 = local_12.member_3;
                                    let _e5130 = local_12.member_3;
                                    let _e5137 = (((_e4959 * (1f + (0.000000059604645f * 8f))) + (((((((_e5013 + _e5015) + (_e5067 + _e5069)) + (_e5121 + _e5123)) * (0.000000059604645f * 16f)) + (_e5130 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e456.member_1);
                                    if _e5137 {
                                        phi_4019_ = false;
                                    } else {
                                        phi_4019_ = true;
                                    }
                                    let _e5139 = phi_4019_;
                                    phi_4020_ = _e5139;
                                    phi_4021_ = _e5137;
                                } else {
                                    phi_4020_ = false;
                                    phi_4021_ = false;
                                }
                                let _e5141 = phi_4020_;
                                let _e5143 = phi_4021_;
                                local_28 = _e5143;
                                continue;
                                continuing {
                                    phi_3518_ = _e4814;
                                    break if !(_e5141);
                                }
                            }
                            let _e5146 = local_28;
                            if _e5146 {
                                phi_4026_ = type_33(1u, _e4790.member_1);
                                phi_4027_ = false;
                            } else {
                                phi_4026_ = type_33();
                                phi_4027_ = true;
                            }
                            let _e5149 = phi_4026_;
                            let _e5151 = phi_4027_;
                            if _e5151 {
                                phi_4032_ = type_33(2u, _e4790.member_1);
                                phi_4033_ = false;
                            } else {
                                phi_4032_ = type_33();
                                phi_4033_ = true;
                            }
                            let _e5154 = phi_4032_;
                            let _e5156 = phi_4033_;
                            phi_4035_ = _e5154;
                            phi_4036_ = _e5149;
                            phi_4037_ = _e5156;
                        } else {
                            phi_4035_ = type_33();
                            phi_4036_ = type_33(0u, type_33().member_1);
                            phi_4037_ = true;
                        }
                        let _e5158 = phi_4035_;
                        let _e5160 = phi_4036_;
                        let _e5162 = phi_4037_;
                        if _e5162 {
                            phi_4041_ = _e5160;
                        } else {
                            phi_4041_ = _e5158;
                        }
                        let _e5164 = phi_4041_;
                        phi_7923_ = _e5164;
                    } else {
                        if (_e594 < 0f) {
                            phi_4051_ = -(_e594);
                        } else {
                            phi_4051_ = _e594;
                        }
                        let _e937 = phi_4051_;
                        if (_e617 < 0f) {
                            phi_4057_ = -(_e617);
                        } else {
                            phi_4057_ = _e617;
                        }
                        let _e941 = phi_4057_;
                        if (_e937 > _e941) {
                            phi_4062_ = _e937;
                        } else {
                            phi_4062_ = _e941;
                        }
                        let _e944 = phi_4062_;
                        if (_e640 < 0f) {
                            phi_4068_ = -(_e640);
                        } else {
                            phi_4068_ = _e640;
                        }
                        let _e948 = phi_4068_;
                        if (_e651 < 0f) {
                            phi_4074_ = -(_e651);
                        } else {
                            phi_4074_ = _e651;
                        }
                        let _e952 = phi_4074_;
                        if (_e948 > _e952) {
                            phi_4079_ = _e948;
                        } else {
                            phi_4079_ = _e952;
                        }
                        let _e955 = phi_4079_;
                        if (_e944 > _e955) {
                            phi_4084_ = _e944;
                        } else {
                            phi_4084_ = _e955;
                        }
                        let _e958 = phi_4084_;
                        let _e959 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e958 >= _e959) {
                            phi_4092_ = (_e958 <= (1f / _e959));
                        } else {
                            phi_4092_ = false;
                        }
                        let _e964 = phi_4092_;
                        if _e964 {
                            phi_4097_ = (0.000000059604645f * 256f);
                        } else {
                            phi_4097_ = 2f;
                        }
                        let _e967 = phi_4097_;
                        let _e969 = ((_e901 * 0.34f) + (_e958 * _e967));
                        if _e964 {
                            phi_4104_ = (1f / _e958);
                        } else {
                            phi_4104_ = 0f;
                        }
                        let _e972 = phi_4104_;
                        let _e978 = ((_e617 - (3f * _e594)) * _e972);
                        let _e979 = ((_e640 - _e617) * _e972);
                        let _e980 = (((3f * _e651) - _e640) * _e972);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e987 = ((_e979 * _e979) - (_e978 * _e980));
                        if (_e987 > 0f) {
                            if (_e987 <= 0.000000000000000000000000000000000000011754944f) {
                                if (_e987 > 0f) {
                                    phi_4137_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_4137_ = 0f;
                                }
                                let _e1041 = phi_4137_;
                                phi_4201_ = _e1041;
                            } else {
                                phi_4144_ = type_17(0i, 5i);
                                phi_4147_ = bitcast<f32>(((bitcast<u32>(_e987) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e996 = phi_4144_;
                                    let _e998 = phi_4147_;
                                    local_13 = _e998;
                                    if (_e996.member < _e996.member_1) {
                                        let _e1005 = (_e996.member + 1i);
                                        if ((false == (_e1005 > _e996.member)) != false) {
                                            phi_4168_ = true;
                                        } else {
                                            phi_4168_ = false;
                                        }
                                        let _e1010 = phi_4168_;
                                        if _e1010 {
                                            phi_4174_ = type_18(0u, type_18().member_1);
                                        } else {
                                            phi_4174_ = type_18(1u, _e1005);
                                        }
                                        let _e1015 = phi_4174_;
                                        phi_4145_ = type_17(_e1015.member_1, _e996.member_1);
                                        phi_4188_ = type_18(1u, _e996.member);
                                    } else {
                                        phi_4145_ = _e996;
                                        phi_4188_ = type_18(0u, type_18().member_1);
                                    }
                                    let _e1021 = phi_4145_;
                                    let _e1023 = phi_4188_;
                                    let _e1026 = (bitcast<i32>(_e1023.member) != 0i);
                                    if _e1026 {
                                        phi_4148_ = (0.5f * (_e998 + (_e987 / _e998)));
                                    } else {
                                        phi_4148_ = f32();
                                    }
                                    let _e1031 = phi_4148_;
                                    continue;
                                    continuing {
                                        phi_4144_ = _e1021;
                                        phi_4147_ = _e1031;
                                        break if !(_e1026);
                                    }
                                }
                                let _e1036 = local_13;
                                phi_4201_ = (_e1036 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1043 = phi_4201_;
                            if (_e979 < 0f) {
                                phi_4207_ = -(_e1043);
                            } else {
                                phi_4207_ = _e1043;
                            }
                            let _e1047 = phi_4207_;
                            let _e1049 = -((_e979 + _e1047));
                            local_7[0u] = (_e1049 / (_e1049 + _e980));
                            local_7[1u] = (_e978 / (_e978 + _e1049));
                            let _e1058 = local_7[1u];
                            let _e1059 = local_7[0u];
                            if (_e1058 < _e1059) {
                                let _e1062 = local_7[1u];
                                let _e1064 = local_7[0u];
                                local_7[0u] = _e1062;
                                local_7[1u] = _e1064;
                            }
                            phi_4232_ = type_19(0u, 2u);
                            phi_4235_ = 1u;
                            loop {
                                let _e1068 = phi_4232_;
                                let _e1070 = phi_4235_;
                                local_29 = _e1070;
                                if (_e1068.member < _e1068.member_1) {
                                    phi_4233_ = type_19((_e1068.member + 1u), _e1068.member_1);
                                    phi_4258_ = type_19(1u, _e1068.member);
                                } else {
                                    phi_4233_ = _e1068;
                                    phi_4258_ = type_19(0u, type_19().member_1);
                                }
                                let _e1082 = phi_4233_;
                                let _e1084 = phi_4258_;
                                let _e1088 = (bitcast<i32>(_e1084.member) != 0i);
                                if _e1088 {
                                    let _e1090 = local_7[_e1084.member_1];
                                    if (_e1090 > 0f) {
                                        let _e1093 = local_7[_e1084.member_1];
                                        if (_e1093 < 1f) {
                                            let _e1096 = local_7[_e1084.member_1];
                                            local_6[_e1070] = _e1096;
                                            phi_4302_ = (_e1070 + 1u);
                                        } else {
                                            phi_4302_ = _e1070;
                                        }
                                        let _e1100 = phi_4302_;
                                        phi_4303_ = _e1100;
                                    } else {
                                        phi_4303_ = _e1070;
                                    }
                                    let _e1102 = phi_4303_;
                                    phi_4236_ = _e1102;
                                } else {
                                    phi_4236_ = u32();
                                }
                                let _e1104 = phi_4236_;
                                continue;
                                continuing {
                                    phi_4232_ = _e1082;
                                    phi_4235_ = _e1104;
                                    break if !(_e1088);
                                }
                            }
                            let _e5419 = local_29;
                            phi_4304_ = _e5419;
                        } else {
                            phi_4304_ = 1u;
                        }
                        let _e1107 = phi_4304_;
                        local_6[_e1107] = 1f;
                        let _e1109 = local_6;
                        local_8 = _e1109;
                        phi_4324_ = type_19(0u, _e1107);
                        loop {
                            let _e1112 = phi_4324_;
                            if (_e1112.member < _e1112.member_1) {
                                phi_4325_ = type_19((_e1112.member + 1u), _e1112.member_1);
                                phi_4348_ = type_19(1u, _e1112.member);
                            } else {
                                phi_4325_ = _e1112;
                                phi_4348_ = type_19(0u, type_19().member_1);
                            }
                            let _e1124 = phi_4325_;
                            let _e1126 = phi_4348_;
                            if (bitcast<i32>(_e1126.member) != 0i) {
                                let _e1132 = local_8[_e1126.member_1];
                                let _e1135 = local_8[(_e1126.member_1 + 1u)];
                                let _e1136 = (1f - _e1132);
                                let _e1147 = ((((_e594 * _e1136) + (_e617 * _e1132)) * (_e1136 * _e1136)) + (((_e640 * _e1136) + (_e651 * _e1132)) * (_e1132 * _e1132)));
                                let _e1148 = (1f - _e1135);
                                let _e1159 = ((((_e594 * _e1148) + (_e617 * _e1135)) * (_e1148 * _e1148)) + (((_e640 * _e1148) + (_e651 * _e1135)) * (_e1135 * _e1135)));
                                if (_e1147 < 0f) {
                                    phi_4400_ = -(_e1147);
                                } else {
                                    phi_4400_ = _e1147;
                                }
                                let _e1163 = phi_4400_;
                                let _e1164 = (_e1163 > _e969);
                                if (_e1159 < 0f) {
                                    phi_4407_ = -(_e1159);
                                } else {
                                    phi_4407_ = _e1159;
                                }
                                let _e1168 = phi_4407_;
                                let _e1169 = (_e1168 > _e969);
                                if _e1164 {
                                    if _e1169 {
                                        phi_4418_ = ((_e1147 > 0f) != (_e1159 > 0f));
                                        phi_4419_ = false;
                                    } else {
                                        phi_4418_ = bool();
                                        phi_4419_ = true;
                                    }
                                    let _e1174 = phi_4418_;
                                    let _e1176 = phi_4419_;
                                    phi_4420_ = _e1174;
                                    phi_4421_ = _e1176;
                                } else {
                                    phi_4420_ = bool();
                                    phi_4421_ = true;
                                }
                                let _e1178 = phi_4420_;
                                let _e1180 = phi_4421_;
                                if _e1180 {
                                    phi_4425_ = false;
                                } else {
                                    phi_4425_ = _e1178;
                                }
                                let _e1182 = phi_4425_;
                                if _e1164 {
                                    if _e1169 {
                                        if _e1182 {
                                            phi_4436_ = type_35();
                                        } else {
                                            phi_4436_ = type_35(1f, 0f, _e1182);
                                        }
                                        let _e1185 = phi_4436_;
                                        phi_4437_ = _e1185;
                                        phi_4438_ = _e1182;
                                    } else {
                                        phi_4437_ = type_35();
                                        phi_4438_ = true;
                                    }
                                    let _e1187 = phi_4437_;
                                    let _e1189 = phi_4438_;
                                    phi_4439_ = _e1187;
                                    phi_4440_ = _e1189;
                                } else {
                                    phi_4439_ = type_35();
                                    phi_4440_ = true;
                                }
                                let _e1191 = phi_4439_;
                                let _e1193 = phi_4440_;
                                if _e1193 {
                                    if _e1164 {
                                        if (_e1147 < 0f) {
                                            phi_4451_ = -1f;
                                        } else {
                                            phi_4451_ = 1f;
                                        }
                                        let _e1196 = phi_4451_;
                                        let _e1199 = (_e640 - _e617);
                                        phi_4461_ = type_19(0u, 64u);
                                        phi_4464_ = _e1135;
                                        phi_4466_ = _e1132;
                                        phi_4468_ = (0.5f * (_e1132 + _e1135));
                                        loop {
                                            let _e1205 = phi_4461_;
                                            let _e1207 = phi_4464_;
                                            let _e1209 = phi_4466_;
                                            let _e1211 = phi_4468_;
                                            local_31 = _e1209;
                                            if (_e1205.member < _e1205.member_1) {
                                                phi_4462_ = type_19((_e1205.member + 1u), _e1205.member_1);
                                                phi_4491_ = type_19(1u, _e1205.member);
                                            } else {
                                                phi_4462_ = _e1205;
                                                phi_4491_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1223 = phi_4462_;
                                            let _e1225 = phi_4491_;
                                            if (bitcast<i32>(_e1225.member) != 0i) {
                                                let _e1229 = (1f - _e1211);
                                                let _e1242 = ((_e1196 * ((((_e594 * _e1229) + (_e617 * _e1211)) * (_e1229 * _e1229)) + (((_e640 * _e1229) + (_e651 * _e1211)) * (_e1211 * _e1211)))) - _e969);
                                                if (_e1242 > 0f) {
                                                    phi_4516_ = _e1207;
                                                    phi_4517_ = _e1211;
                                                } else {
                                                    phi_4516_ = _e1211;
                                                    phi_4517_ = _e1209;
                                                }
                                                let _e1245 = phi_4516_;
                                                let _e1247 = phi_4517_;
                                                let _e1249 = ((_e1245 - _e1247) > 0.00000000000022737368f);
                                                if _e1249 {
                                                    let _e1250 = (1f - _e1211);
                                                    let _e1262 = (-(_e1242) / (_e1196 * (((((_e617 - (3f * _e594)) * _e1250) + (_e1199 * _e1211)) * _e1250) + (((_e1199 * _e1250) + (((3f * _e651) - _e640) * _e1211)) * _e1211))));
                                                    if (_e1242 > 0f) {
                                                        phi_4543_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4543_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1268 = phi_4543_;
                                                    let _e1270 = ((_e1211 + _e1262) + _e1268);
                                                    if (_e1270 > _e1247) {
                                                        if (_e1270 < _e1245) {
                                                            if (_e1262 < 0f) {
                                                                phi_4559_ = -(_e1262);
                                                            } else {
                                                                phi_4559_ = _e1262;
                                                            }
                                                            let _e1276 = phi_4559_;
                                                            if (_e1276 < (0.5f * (_e1245 - _e1247))) {
                                                                phi_4566_ = false;
                                                            } else {
                                                                phi_4566_ = true;
                                                            }
                                                            let _e1281 = phi_4566_;
                                                            phi_4567_ = _e1281;
                                                        } else {
                                                            phi_4567_ = true;
                                                        }
                                                        let _e1283 = phi_4567_;
                                                        phi_4568_ = _e1283;
                                                    } else {
                                                        phi_4568_ = true;
                                                    }
                                                    let _e1285 = phi_4568_;
                                                    if _e1285 {
                                                        phi_4574_ = (0.5f * (_e1247 + _e1245));
                                                    } else {
                                                        phi_4574_ = _e1270;
                                                    }
                                                    let _e1289 = phi_4574_;
                                                    phi_4575_ = _e1289;
                                                    phi_4576_ = false;
                                                } else {
                                                    phi_4575_ = f32();
                                                    phi_4576_ = true;
                                                }
                                                let _e1291 = phi_4575_;
                                                let _e1293 = phi_4576_;
                                                phi_4465_ = _e1245;
                                                phi_4467_ = _e1247;
                                                phi_4469_ = _e1291;
                                                phi_4577_ = _e1247;
                                                phi_4578_ = _e1249;
                                                phi_4579_ = _e1293;
                                            } else {
                                                phi_4465_ = f32();
                                                phi_4467_ = f32();
                                                phi_4469_ = f32();
                                                phi_4577_ = f32();
                                                phi_4578_ = false;
                                                phi_4579_ = false;
                                            }
                                            let _e1295 = phi_4465_;
                                            let _e1297 = phi_4467_;
                                            let _e1299 = phi_4469_;
                                            let _e1301 = phi_4577_;
                                            let _e1303 = phi_4578_;
                                            let _e1305 = phi_4579_;
                                            local_14 = _e1305;
                                            local_30 = _e1301;
                                            continue;
                                            continuing {
                                                phi_4461_ = _e1223;
                                                phi_4464_ = _e1295;
                                                phi_4466_ = _e1297;
                                                phi_4468_ = _e1299;
                                                break if !(_e1303);
                                            }
                                        }
                                        let _e1308 = local_14;
                                        if _e1308 {
                                            let _e5461 = local_30;
                                            phi_4583_ = _e5461;
                                        } else {
                                            let _e5463 = local_31;
                                            phi_4583_ = _e5463;
                                        }
                                        let _e1310 = phi_4583_;
                                        phi_4584_ = _e1310;
                                    } else {
                                        phi_4584_ = _e1132;
                                    }
                                    let _e1312 = phi_4584_;
                                    if _e1169 {
                                        if (_e1159 < 0f) {
                                            phi_4592_ = -1f;
                                        } else {
                                            phi_4592_ = 1f;
                                        }
                                        let _e1315 = phi_4592_;
                                        phi_4596_ = type_19(0u, 64u);
                                        phi_4599_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1318 = phi_4596_;
                                            let _e1320 = phi_4599_;
                                            if (_e1318.member < _e1318.member_1) {
                                                phi_4597_ = type_19((_e1318.member + 1u), _e1318.member_1);
                                                phi_4622_ = type_19(1u, _e1318.member);
                                            } else {
                                                phi_4597_ = _e1318;
                                                phi_4622_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e1332 = phi_4597_;
                                            let _e1334 = phi_4622_;
                                            if (bitcast<i32>(_e1334.member) != 0i) {
                                                let _e1338 = (_e1312 + _e1320);
                                                if (_e1338 < _e1135) {
                                                    let _e1340 = (1f - _e1338);
                                                    let _e1353 = ((_e1315 * ((((_e594 * _e1340) + (_e617 * _e1338)) * (_e1340 * _e1340)) + (((_e640 * _e1340) + (_e651 * _e1338)) * (_e1338 * _e1338)))) > _e969);
                                                    if _e1353 {
                                                        phi_4652_ = f32();
                                                        phi_4653_ = false;
                                                    } else {
                                                        phi_4652_ = (_e1320 + _e1320);
                                                        phi_4653_ = true;
                                                    }
                                                    let _e1356 = phi_4652_;
                                                    let _e1358 = phi_4653_;
                                                    phi_4654_ = _e1356;
                                                    phi_4655_ = _e1358;
                                                    phi_4656_ = _e1353;
                                                    phi_4657_ = false;
                                                } else {
                                                    phi_4654_ = f32();
                                                    phi_4655_ = false;
                                                    phi_4656_ = false;
                                                    phi_4657_ = true;
                                                }
                                                let _e1360 = phi_4654_;
                                                let _e1362 = phi_4655_;
                                                let _e1364 = phi_4656_;
                                                let _e1366 = phi_4657_;
                                                phi_4658_ = _e1338;
                                                phi_4600_ = _e1360;
                                                phi_4659_ = _e1362;
                                                phi_4660_ = _e1364;
                                                phi_4661_ = _e1366;
                                                phi_4662_ = false;
                                            } else {
                                                phi_4658_ = f32();
                                                phi_4600_ = f32();
                                                phi_4659_ = false;
                                                phi_4660_ = false;
                                                phi_4661_ = false;
                                                phi_4662_ = true;
                                            }
                                            let _e1368 = phi_4658_;
                                            let _e1370 = phi_4600_;
                                            let _e1372 = phi_4659_;
                                            let _e1374 = phi_4660_;
                                            let _e1376 = phi_4661_;
                                            let _e1378 = phi_4662_;
                                            local_15 = _e1374;
                                            local_32 = _e1376;
                                            local_33 = _e1378;
                                            local_34 = _e1368;
                                            continue;
                                            continuing {
                                                phi_4596_ = _e1332;
                                                phi_4599_ = _e1370;
                                                break if !(_e1372);
                                            }
                                        }
                                        let _e1381 = local_15;
                                        if _e1381 {
                                            phi_4666_ = false;
                                            phi_4667_ = false;
                                        } else {
                                            let _e5485 = local_32;
                                            phi_4666_ = _e5485;
                                            let _e5488 = local_33;
                                            phi_4667_ = _e5488;
                                        }
                                        let _e1383 = phi_4666_;
                                        let _e1385 = phi_4667_;
                                        if _e1383 {
                                            phi_4671_ = true;
                                        } else {
                                            phi_4671_ = _e1385;
                                        }
                                        let _e1387 = phi_4671_;
                                        if _e1387 {
                                            phi_4675_ = _e1135;
                                        } else {
                                            let _e5492 = local_34;
                                            phi_4675_ = _e5492;
                                        }
                                        let _e1389 = phi_4675_;
                                        phi_4676_ = _e1389;
                                    } else {
                                        phi_4676_ = _e1135;
                                    }
                                    let _e1391 = phi_4676_;
                                    phi_4678_ = type_35(_e1312, _e1391, _e1182);
                                } else {
                                    phi_4678_ = _e1191;
                                }
                                let _e1394 = phi_4678_;
                                if (_e1394.member > _e1394.member_1) {
                                    phi_7879_ = f32();
                                    phi_7880_ = true;
                                    phi_7881_ = false;
                                    phi_7882_ = false;
                                    phi_7883_ = false;
                                } else {
                                    let _e1401 = ((_e1394.member_1 - _e1394.member) * 0.5f);
                                    let _e1402 = (_e1394.member + _e1401);
                                    let _e1404 = (_e1401 + (0.000000059604645f * 4f));
                                    let _e1406 = local_12.member_3;
                                    let _e1409 = local_12.member[0u];
                                    if (_e1409[0] < 0f) {
                                        phi_4707_ = -(_e1409[0]);
                                    } else {
                                        phi_4707_ = _e1409[0];
                                    }
                                    let _e1416 = phi_4707_;
                                    if (_e1409[1] < 0f) {
                                        phi_4714_ = -(_e1409[1]);
                                    } else {
                                        phi_4714_ = _e1409[1];
                                    }
                                    let _e1420 = phi_4714_;
                                    if (_e1416 > _e1420) {
                                        phi_4719_ = _e1416;
                                    } else {
                                        phi_4719_ = _e1420;
                                    }
                                    let _e1423 = phi_4719_;
                                    if (_e1409[2] < 0f) {
                                        phi_4726_ = -(_e1409[2]);
                                    } else {
                                        phi_4726_ = _e1409[2];
                                    }
                                    let _e1427 = phi_4726_;
                                    if (_e1423 > _e1427) {
                                        phi_4731_ = _e1423;
                                    } else {
                                        phi_4731_ = _e1427;
                                    }
                                    let _e1430 = phi_4731_;
                                    let _e1432 = local_12.member[1u];
                                    if (_e1432[0] < 0f) {
                                        phi_4744_ = -(_e1432[0]);
                                    } else {
                                        phi_4744_ = _e1432[0];
                                    }
                                    let _e1439 = phi_4744_;
                                    if (_e1432[1] < 0f) {
                                        phi_4751_ = -(_e1432[1]);
                                    } else {
                                        phi_4751_ = _e1432[1];
                                    }
                                    let _e1443 = phi_4751_;
                                    if (_e1439 > _e1443) {
                                        phi_4756_ = _e1439;
                                    } else {
                                        phi_4756_ = _e1443;
                                    }
                                    let _e1446 = phi_4756_;
                                    if (_e1432[2] < 0f) {
                                        phi_4763_ = -(_e1432[2]);
                                    } else {
                                        phi_4763_ = _e1432[2];
                                    }
                                    let _e1450 = phi_4763_;
                                    if (_e1446 > _e1450) {
                                        phi_4768_ = _e1446;
                                    } else {
                                        phi_4768_ = _e1450;
                                    }
                                    let _e1453 = phi_4768_;
                                    if (_e1430 > _e1453) {
                                        phi_4773_ = _e1430;
                                    } else {
                                        phi_4773_ = _e1453;
                                    }
                                    let _e1456 = phi_4773_;
                                    let _e1459 = local_12.member[0u];
                                    let _e1464 = local_12.member[1u];
                                    let _e1474 = (_e1459[0] + ((_e1464[0] - _e1459[0]) * _e1402));
                                    let _e1475 = (_e1459[1] + ((_e1464[1] - _e1459[1]) * _e1402));
                                    let _e1476 = (_e1459[2] + ((_e1464[2] - _e1459[2]) * _e1402));
                                    let _e1478 = local_12.member[1u];
                                    let _e1483 = local_12.member[0u];
                                    let _e1487 = (_e1478[0] - _e1483[0]);
                                    let _e1488 = (_e1478[1] - _e1483[1]);
                                    let _e1489 = (_e1478[2] - _e1483[2]);
                                    if (_e1487 < 0f) {
                                        phi_4832_ = -(_e1487);
                                    } else {
                                        phi_4832_ = _e1487;
                                    }
                                    let _e1493 = phi_4832_;
                                    if (_e1488 < 0f) {
                                        phi_4838_ = -(_e1488);
                                    } else {
                                        phi_4838_ = _e1488;
                                    }
                                    let _e1497 = phi_4838_;
                                    if (_e1493 > _e1497) {
                                        phi_4843_ = _e1493;
                                    } else {
                                        phi_4843_ = _e1497;
                                    }
                                    let _e1500 = phi_4843_;
                                    if (_e1489 < 0f) {
                                        phi_4849_ = -(_e1489);
                                    } else {
                                        phi_4849_ = _e1489;
                                    }
                                    let _e1504 = phi_4849_;
                                    if (_e1500 > _e1504) {
                                        phi_4854_ = _e1500;
                                    } else {
                                        phi_4854_ = _e1504;
                                    }
                                    let _e1507 = phi_4854_;
                                    let _e1513 = ((((_e1404 * _e1507) * 1.01f) + ((_e1456 + _e1406) * (0.000000059604645f * 8f))) + _e1406);
                                    if (_e1474 < 0f) {
                                        phi_4866_ = -(_e1474);
                                    } else {
                                        phi_4866_ = _e1474;
                                    }
                                    let _e1517 = phi_4866_;
                                    if (_e1475 < 0f) {
                                        phi_4872_ = -(_e1475);
                                    } else {
                                        phi_4872_ = _e1475;
                                    }
                                    let _e1521 = phi_4872_;
                                    if (_e1517 > _e1521) {
                                        phi_4877_ = _e1517;
                                    } else {
                                        phi_4877_ = _e1521;
                                    }
                                    let _e1524 = phi_4877_;
                                    if (_e1476 < 0f) {
                                        phi_4883_ = -(_e1476);
                                    } else {
                                        phi_4883_ = _e1476;
                                    }
                                    let _e1528 = phi_4883_;
                                    if (_e1524 > _e1528) {
                                        phi_4888_ = _e1524;
                                    } else {
                                        phi_4888_ = _e1528;
                                    }
                                    let _e1531 = phi_4888_;
                                    local_2 = type_24(array<f32, 3>(_e1474, _e1475, _e1476), _e1513, (_e1531 + _e1513));
                                    let _e1537 = local_12.member_3;
                                    let _e1539 = local_12.member_1[0u];
                                    if (_e1539[0] < 0f) {
                                        phi_4914_ = -(_e1539[0]);
                                    } else {
                                        phi_4914_ = _e1539[0];
                                    }
                                    let _e1546 = phi_4914_;
                                    if (_e1539[1] < 0f) {
                                        phi_4921_ = -(_e1539[1]);
                                    } else {
                                        phi_4921_ = _e1539[1];
                                    }
                                    let _e1550 = phi_4921_;
                                    if (_e1546 > _e1550) {
                                        phi_4926_ = _e1546;
                                    } else {
                                        phi_4926_ = _e1550;
                                    }
                                    let _e1553 = phi_4926_;
                                    if (_e1539[2] < 0f) {
                                        phi_4933_ = -(_e1539[2]);
                                    } else {
                                        phi_4933_ = _e1539[2];
                                    }
                                    let _e1557 = phi_4933_;
                                    if (_e1553 > _e1557) {
                                        phi_4938_ = _e1553;
                                    } else {
                                        phi_4938_ = _e1557;
                                    }
                                    let _e1560 = phi_4938_;
                                    let _e1562 = local_12.member_1[1u];
                                    if (_e1562[0] < 0f) {
                                        phi_4951_ = -(_e1562[0]);
                                    } else {
                                        phi_4951_ = _e1562[0];
                                    }
                                    let _e1569 = phi_4951_;
                                    if (_e1562[1] < 0f) {
                                        phi_4958_ = -(_e1562[1]);
                                    } else {
                                        phi_4958_ = _e1562[1];
                                    }
                                    let _e1573 = phi_4958_;
                                    if (_e1569 > _e1573) {
                                        phi_4963_ = _e1569;
                                    } else {
                                        phi_4963_ = _e1573;
                                    }
                                    let _e1576 = phi_4963_;
                                    if (_e1562[2] < 0f) {
                                        phi_4970_ = -(_e1562[2]);
                                    } else {
                                        phi_4970_ = _e1562[2];
                                    }
                                    let _e1580 = phi_4970_;
                                    if (_e1576 > _e1580) {
                                        phi_4975_ = _e1576;
                                    } else {
                                        phi_4975_ = _e1580;
                                    }
                                    let _e1583 = phi_4975_;
                                    if (_e1560 > _e1583) {
                                        phi_4980_ = _e1560;
                                    } else {
                                        phi_4980_ = _e1583;
                                    }
                                    let _e1586 = phi_4980_;
                                    let _e1589 = local_12.member_1[0u];
                                    let _e1594 = local_12.member_1[1u];
                                    let _e1604 = (_e1589[0] + ((_e1594[0] - _e1589[0]) * _e1402));
                                    let _e1605 = (_e1589[1] + ((_e1594[1] - _e1589[1]) * _e1402));
                                    let _e1606 = (_e1589[2] + ((_e1594[2] - _e1589[2]) * _e1402));
                                    let _e1608 = local_12.member_1[1u];
                                    let _e1613 = local_12.member_1[0u];
                                    let _e1617 = (_e1608[0] - _e1613[0]);
                                    let _e1618 = (_e1608[1] - _e1613[1]);
                                    let _e1619 = (_e1608[2] - _e1613[2]);
                                    if (_e1617 < 0f) {
                                        phi_5039_ = -(_e1617);
                                    } else {
                                        phi_5039_ = _e1617;
                                    }
                                    let _e1623 = phi_5039_;
                                    if (_e1618 < 0f) {
                                        phi_5045_ = -(_e1618);
                                    } else {
                                        phi_5045_ = _e1618;
                                    }
                                    let _e1627 = phi_5045_;
                                    if (_e1623 > _e1627) {
                                        phi_5050_ = _e1623;
                                    } else {
                                        phi_5050_ = _e1627;
                                    }
                                    let _e1630 = phi_5050_;
                                    if (_e1619 < 0f) {
                                        phi_5056_ = -(_e1619);
                                    } else {
                                        phi_5056_ = _e1619;
                                    }
                                    let _e1634 = phi_5056_;
                                    if (_e1630 > _e1634) {
                                        phi_5061_ = _e1630;
                                    } else {
                                        phi_5061_ = _e1634;
                                    }
                                    let _e1637 = phi_5061_;
                                    let _e1643 = ((((_e1404 * _e1637) * 1.01f) + ((_e1586 + _e1537) * (0.000000059604645f * 8f))) + _e1537);
                                    if (_e1604 < 0f) {
                                        phi_5073_ = -(_e1604);
                                    } else {
                                        phi_5073_ = _e1604;
                                    }
                                    let _e1647 = phi_5073_;
                                    if (_e1605 < 0f) {
                                        phi_5079_ = -(_e1605);
                                    } else {
                                        phi_5079_ = _e1605;
                                    }
                                    let _e1651 = phi_5079_;
                                    if (_e1647 > _e1651) {
                                        phi_5084_ = _e1647;
                                    } else {
                                        phi_5084_ = _e1651;
                                    }
                                    let _e1654 = phi_5084_;
                                    if (_e1606 < 0f) {
                                        phi_5090_ = -(_e1606);
                                    } else {
                                        phi_5090_ = _e1606;
                                    }
                                    let _e1658 = phi_5090_;
                                    if (_e1654 > _e1658) {
                                        phi_5095_ = _e1654;
                                    } else {
                                        phi_5095_ = _e1658;
                                    }
                                    let _e1661 = phi_5095_;
                                    local_3 = type_24(array<f32, 3>(_e1604, _e1605, _e1606), _e1643, (_e1661 + _e1643));
                                    let _e1667 = local_12.member_3;
                                    let _e1669 = local_12.member_2[0u];
                                    if (_e1669[0] < 0f) {
                                        phi_5121_ = -(_e1669[0]);
                                    } else {
                                        phi_5121_ = _e1669[0];
                                    }
                                    let _e1676 = phi_5121_;
                                    if (_e1669[1] < 0f) {
                                        phi_5128_ = -(_e1669[1]);
                                    } else {
                                        phi_5128_ = _e1669[1];
                                    }
                                    let _e1680 = phi_5128_;
                                    if (_e1676 > _e1680) {
                                        phi_5133_ = _e1676;
                                    } else {
                                        phi_5133_ = _e1680;
                                    }
                                    let _e1683 = phi_5133_;
                                    if (_e1669[2] < 0f) {
                                        phi_5140_ = -(_e1669[2]);
                                    } else {
                                        phi_5140_ = _e1669[2];
                                    }
                                    let _e1687 = phi_5140_;
                                    if (_e1683 > _e1687) {
                                        phi_5145_ = _e1683;
                                    } else {
                                        phi_5145_ = _e1687;
                                    }
                                    let _e1690 = phi_5145_;
                                    let _e1692 = local_12.member_2[1u];
                                    if (_e1692[0] < 0f) {
                                        phi_5158_ = -(_e1692[0]);
                                    } else {
                                        phi_5158_ = _e1692[0];
                                    }
                                    let _e1699 = phi_5158_;
                                    if (_e1692[1] < 0f) {
                                        phi_5165_ = -(_e1692[1]);
                                    } else {
                                        phi_5165_ = _e1692[1];
                                    }
                                    let _e1703 = phi_5165_;
                                    if (_e1699 > _e1703) {
                                        phi_5170_ = _e1699;
                                    } else {
                                        phi_5170_ = _e1703;
                                    }
                                    let _e1706 = phi_5170_;
                                    if (_e1692[2] < 0f) {
                                        phi_5177_ = -(_e1692[2]);
                                    } else {
                                        phi_5177_ = _e1692[2];
                                    }
                                    let _e1710 = phi_5177_;
                                    if (_e1706 > _e1710) {
                                        phi_5182_ = _e1706;
                                    } else {
                                        phi_5182_ = _e1710;
                                    }
                                    let _e1713 = phi_5182_;
                                    if (_e1690 > _e1713) {
                                        phi_5187_ = _e1690;
                                    } else {
                                        phi_5187_ = _e1713;
                                    }
                                    let _e1716 = phi_5187_;
                                    let _e1719 = local_12.member_2[0u];
                                    let _e1724 = local_12.member_2[1u];
                                    let _e1734 = (_e1719[0] + ((_e1724[0] - _e1719[0]) * _e1402));
                                    let _e1735 = (_e1719[1] + ((_e1724[1] - _e1719[1]) * _e1402));
                                    let _e1736 = (_e1719[2] + ((_e1724[2] - _e1719[2]) * _e1402));
                                    let _e1738 = local_12.member_2[1u];
                                    let _e1743 = local_12.member_2[0u];
                                    let _e1747 = (_e1738[0] - _e1743[0]);
                                    let _e1748 = (_e1738[1] - _e1743[1]);
                                    let _e1749 = (_e1738[2] - _e1743[2]);
                                    if (_e1747 < 0f) {
                                        phi_5246_ = -(_e1747);
                                    } else {
                                        phi_5246_ = _e1747;
                                    }
                                    let _e1753 = phi_5246_;
                                    if (_e1748 < 0f) {
                                        phi_5252_ = -(_e1748);
                                    } else {
                                        phi_5252_ = _e1748;
                                    }
                                    let _e1757 = phi_5252_;
                                    if (_e1753 > _e1757) {
                                        phi_5257_ = _e1753;
                                    } else {
                                        phi_5257_ = _e1757;
                                    }
                                    let _e1760 = phi_5257_;
                                    if (_e1749 < 0f) {
                                        phi_5263_ = -(_e1749);
                                    } else {
                                        phi_5263_ = _e1749;
                                    }
                                    let _e1764 = phi_5263_;
                                    if (_e1760 > _e1764) {
                                        phi_5268_ = _e1760;
                                    } else {
                                        phi_5268_ = _e1764;
                                    }
                                    let _e1767 = phi_5268_;
                                    let _e1773 = ((((_e1404 * _e1767) * 1.01f) + ((_e1716 + _e1667) * (0.000000059604645f * 8f))) + _e1667);
                                    if (_e1734 < 0f) {
                                        phi_5280_ = -(_e1734);
                                    } else {
                                        phi_5280_ = _e1734;
                                    }
                                    let _e1777 = phi_5280_;
                                    if (_e1735 < 0f) {
                                        phi_5286_ = -(_e1735);
                                    } else {
                                        phi_5286_ = _e1735;
                                    }
                                    let _e1781 = phi_5286_;
                                    if (_e1777 > _e1781) {
                                        phi_5291_ = _e1777;
                                    } else {
                                        phi_5291_ = _e1781;
                                    }
                                    let _e1784 = phi_5291_;
                                    if (_e1736 < 0f) {
                                        phi_5297_ = -(_e1736);
                                    } else {
                                        phi_5297_ = _e1736;
                                    }
                                    let _e1788 = phi_5297_;
                                    if (_e1784 > _e1788) {
                                        phi_5302_ = _e1784;
                                    } else {
                                        phi_5302_ = _e1788;
                                    }
                                    let _e1791 = phi_5302_;
                                    local_4 = type_24(array<f32, 3>(_e1734, _e1735, _e1736), _e1773, (_e1791 + _e1773));
                                    let _e1796 = local_3.member;
                                    let _e1801 = local_4.member;
                                    let _e1807 = ((_e1796[1] * _e1801[2]) - (_e1796[2] * _e1801[1]));
                                    let _e1810 = ((_e1796[2] * _e1801[0]) - (_e1796[0] * _e1801[2]));
                                    let _e1813 = ((_e1796[0] * _e1801[1]) - (_e1796[1] * _e1801[0]));
                                    if (_e1807 < 0f) {
                                        phi_5351_ = -(_e1807);
                                    } else {
                                        phi_5351_ = _e1807;
                                    }
                                    let _e1817 = phi_5351_;
                                    if (_e1810 < 0f) {
                                        phi_5357_ = -(_e1810);
                                    } else {
                                        phi_5357_ = _e1810;
                                    }
                                    let _e1821 = phi_5357_;
                                    if (_e1817 > _e1821) {
                                        if (_e1807 < 0f) {
                                            phi_5367_ = -(_e1807);
                                        } else {
                                            phi_5367_ = _e1807;
                                        }
                                        let _e1839 = phi_5367_;
                                        if (_e1813 < 0f) {
                                            phi_5373_ = -(_e1813);
                                        } else {
                                            phi_5373_ = _e1813;
                                        }
                                        let _e1843 = phi_5373_;
                                        if (_e1839 > _e1843) {
                                            phi_5378_ = 2u;
                                            phi_5379_ = 1u;
                                        } else {
                                            phi_5378_ = 1u;
                                            phi_5379_ = 0u;
                                        }
                                        let _e1846 = phi_5378_;
                                        let _e1848 = phi_5379_;
                                        phi_5398_ = _e1846;
                                        phi_5399_ = _e1848;
                                    } else {
                                        if (_e1810 < 0f) {
                                            phi_5385_ = -(_e1810);
                                        } else {
                                            phi_5385_ = _e1810;
                                        }
                                        let _e1826 = phi_5385_;
                                        if (_e1813 < 0f) {
                                            phi_5391_ = -(_e1813);
                                        } else {
                                            phi_5391_ = _e1813;
                                        }
                                        let _e1830 = phi_5391_;
                                        if (_e1826 > _e1830) {
                                            phi_5396_ = 0u;
                                            phi_5397_ = 2u;
                                        } else {
                                            phi_5396_ = 1u;
                                            phi_5397_ = 0u;
                                        }
                                        let _e1833 = phi_5396_;
                                        let _e1835 = phi_5397_;
                                        phi_5398_ = _e1833;
                                        phi_5399_ = _e1835;
                                    }
                                    let _e1850 = phi_5398_;
                                    let _e1852 = phi_5399_;
                                    let _e1855 = local_3.member[_e1852];
                                    let _e1858 = local_4.member[_e1850];
                                    let _e1862 = local_3.member[_e1850];
                                    let _e1865 = local_4.member[_e1852];
                                    let _e1867 = ((_e1855 * _e1858) - (_e1862 * _e1865));
                                    let _e1869 = local_3.member_1;
                                    let _e1871 = local_4.member_2;
                                    let _e1874 = local_3.member_2;
                                    let _e1876 = local_4.member_1;
                                    let _e1881 = local_3.member_2;
                                    let _e1884 = local_4.member_2;
                                    let _e1892 = local_3.member_2;
                                    let _e1895 = local_4.member_2;
                                    let _e1899 = (((((_e1869 * _e1871) + (_e1874 * _e1876)) * 2.01f) + (((_e1881 * 2f) * (_e1884 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1892) * (1f + _e1895))));
                                    if (_e1867 < 0f) {
                                        phi_5468_ = -(_e1867);
                                    } else {
                                        phi_5468_ = _e1867;
                                    }
                                    let _e1903 = phi_5468_;
                                    if (_e1903 > _e1899) {
                                        if (_e1867 < 0f) {
                                            phi_5477_ = -1f;
                                        } else {
                                            phi_5477_ = 1f;
                                        }
                                        let _e1907 = phi_5477_;
                                        let _e1910 = local_2.member[_e1852];
                                        let _e1913 = local_4.member[_e1850];
                                        let _e1917 = local_2.member[_e1850];
                                        let _e1920 = local_4.member[_e1852];
                                        let _e1924 = local_2.member_1;
                                        let _e1926 = local_4.member_2;
                                        let _e1929 = local_2.member_2;
                                        let _e1931 = local_4.member_1;
                                        let _e1936 = local_2.member_2;
                                        let _e1939 = local_4.member_2;
                                        let _e1947 = local_2.member_2;
                                        let _e1950 = local_4.member_2;
                                        let _e1954 = (((((_e1924 * _e1926) + (_e1929 * _e1931)) * 2.01f) + (((_e1936 * 2f) * (_e1939 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1947) * (1f + _e1950))));
                                        let _e1957 = local_3.member[_e1852];
                                        let _e1960 = local_2.member[_e1850];
                                        let _e1964 = local_3.member[_e1850];
                                        let _e1967 = local_2.member[_e1852];
                                        let _e1971 = local_3.member_1;
                                        let _e1973 = local_2.member_2;
                                        let _e1976 = local_3.member_2;
                                        let _e1978 = local_2.member_1;
                                        let _e1983 = local_3.member_2;
                                        let _e1986 = local_2.member_2;
                                        let _e1994 = local_3.member_2;
                                        let _e1997 = local_2.member_2;
                                        let _e2001 = (((((_e1971 * _e1973) + (_e1976 * _e1978)) * 2.01f) + (((_e1983 * 2f) * (_e1986 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e1994) * (1f + _e1997))));
                                        let _e2002 = (_e1867 * _e1907);
                                        let _e2003 = (((_e1910 * _e1913) - (_e1917 * _e1920)) * _e1907);
                                        let _e2004 = (((_e1957 * _e1960) - (_e1964 * _e1967)) * _e1907);
                                        if (_e2002 < 0f) {
                                            phi_5612_ = -(_e2002);
                                        } else {
                                            phi_5612_ = _e2002;
                                        }
                                        let _e2008 = phi_5612_;
                                        if (_e2003 < 0f) {
                                            phi_5618_ = -(_e2003);
                                        } else {
                                            phi_5618_ = _e2003;
                                        }
                                        let _e2012 = phi_5618_;
                                        if (_e2004 < 0f) {
                                            phi_5625_ = -(_e2004);
                                        } else {
                                            phi_5625_ = _e2004;
                                        }
                                        let _e2017 = phi_5625_;
                                        let _e2020 = (((_e2008 + _e2012) + _e2017) * (0.000000059604645f * 4f));
                                        local_5[0u].member = _e2003;
                                        local_5[0u].member_1 = _e1954;
                                        local_5[1u].member = _e2004;
                                        local_5[1u].member_1 = _e2001;
                                        local_5[2u].member = (_e2002 - _e2003);
                                        local_5[2u].member_1 = ((_e1899 + _e1954) + _e2020);
                                        local_5[3u].member = (_e2002 - _e2004);
                                        local_5[3u].member_1 = ((_e1899 + _e2001) + _e2020);
                                        phi_5668_ = type_19(0u, 4u);
                                        phi_5671_ = true;
                                        loop {
                                            let _e2041 = phi_5668_;
                                            let _e2043 = phi_5671_;
                                            local_17 = _e2043;
                                            if (_e2041.member < _e2041.member_1) {
                                                phi_5669_ = type_19((_e2041.member + 1u), _e2041.member_1);
                                                phi_5694_ = type_19(1u, _e2041.member);
                                            } else {
                                                phi_5669_ = _e2041;
                                                phi_5694_ = type_19(0u, type_19().member_1);
                                            }
                                            let _e2055 = phi_5669_;
                                            let _e2057 = phi_5694_;
                                            if (bitcast<i32>(_e2057.member) != 0i) {
                                                let _e2064 = local_5[_e2057.member_1].member;
                                                let _e2067 = local_5[_e2057.member_1].member_1;
                                                let _e2069 = (_e2064 < -(_e2067));
                                                if _e2069 {
                                                    phi_5721_ = bool();
                                                    phi_5722_ = false;
                                                } else {
                                                    phi_5721_ = (_e2043 && (_e2064 > _e2067));
                                                    phi_5722_ = true;
                                                }
                                                let _e2073 = phi_5721_;
                                                let _e2075 = phi_5722_;
                                                phi_5672_ = _e2073;
                                                phi_5723_ = _e2075;
                                                phi_5724_ = _e2069;
                                            } else {
                                                phi_5672_ = bool();
                                                phi_5723_ = false;
                                                phi_5724_ = false;
                                            }
                                            let _e2077 = phi_5672_;
                                            let _e2079 = phi_5723_;
                                            let _e2081 = phi_5724_;
                                            local_16 = _e2081;
                                            continue;
                                            continuing {
                                                phi_5668_ = _e2055;
                                                phi_5671_ = _e2077;
                                                break if !(_e2079);
                                            }
                                        }
                                        let _e2084 = local_16;
                                        if _e2084 {
                                            phi_5728_ = false;
                                        } else {
                                            phi_5728_ = true;
                                        }
                                        let _e2086 = phi_5728_;
                                        if _e2086 {
                                            let _e2088 = local_17;
                                            if _e2088 {
                                                phi_5735_ = 1u;
                                            } else {
                                                phi_5735_ = 2u;
                                            }
                                            let _e2090 = phi_5735_;
                                            phi_5736_ = _e2090;
                                            phi_5737_ = false;
                                        } else {
                                            phi_5736_ = u32();
                                            phi_5737_ = true;
                                        }
                                        let _e2092 = phi_5736_;
                                        let _e2094 = phi_5737_;
                                        phi_5738_ = _e2092;
                                        phi_5739_ = 0u;
                                        phi_5740_ = _e2094;
                                    } else {
                                        phi_5738_ = u32();
                                        phi_5739_ = 2u;
                                        phi_5740_ = true;
                                    }
                                    let _e2096 = phi_5738_;
                                    let _e2098 = phi_5739_;
                                    let _e2100 = phi_5740_;
                                    if _e2100 {
                                        phi_5744_ = _e2098;
                                    } else {
                                        phi_5744_ = _e2096;
                                    }
                                    let _e2102 = phi_5744_;
                                    let _e2103 = (_e2102 == 0u);
                                    if _e2103 {
                                        phi_7875_ = f32();
                                        phi_7876_ = false;
                                        phi_7877_ = false;
                                        phi_7878_ = false;
                                    } else {
                                        if (_e2102 == 1u) {
                                            if _e1394.member_2 {
                                                if ((_e1394.member_1 - _e1394.member) <= 0.0000005f) {
                                                    phi_5764_ = false;
                                                } else {
                                                    phi_5764_ = true;
                                                }
                                                let _e2111 = phi_5764_;
                                                phi_5765_ = _e2111;
                                            } else {
                                                phi_5765_ = true;
                                            }
                                            let _e2113 = phi_5765_;
                                            phi_5766_ = _e2113;
                                        } else {
                                            phi_5766_ = true;
                                        }
                                        let _e2115 = phi_5766_;
                                        if _e2115 {
                                            let _e2120 = local_12.member[0u];
                                            let _e2126 = local_12.member_1[0u];
                                            let _e2132 = local_12.member_2[0u];
                                            let _e2136 = (_e2120[0] - _e2126[0]);
                                            let _e2137 = (_e2120[1] - _e2126[1]);
                                            let _e2138 = (_e2120[2] - _e2126[2]);
                                            let _e2147 = local_12.member[1u];
                                            let _e2153 = local_12.member_1[1u];
                                            let _e2159 = local_12.member_2[1u];
                                            let _e2163 = (_e2147[0] - _e2153[0]);
                                            let _e2164 = (_e2147[1] - _e2153[1]);
                                            let _e2165 = (_e2147[2] - _e2153[2]);
                                            let _e2174 = local_12.member[0u];
                                            if (_e2174[0] < 0f) {
                                                phi_5914_ = -(_e2174[0]);
                                            } else {
                                                phi_5914_ = _e2174[0];
                                            }
                                            let _e2181 = phi_5914_;
                                            if (_e2174[1] < 0f) {
                                                phi_5921_ = -(_e2174[1]);
                                            } else {
                                                phi_5921_ = _e2174[1];
                                            }
                                            let _e2185 = phi_5921_;
                                            if (_e2181 > _e2185) {
                                                phi_5926_ = _e2181;
                                            } else {
                                                phi_5926_ = _e2185;
                                            }
                                            let _e2188 = phi_5926_;
                                            if (_e2174[2] < 0f) {
                                                phi_5933_ = -(_e2174[2]);
                                            } else {
                                                phi_5933_ = _e2174[2];
                                            }
                                            let _e2192 = phi_5933_;
                                            if (_e2188 > _e2192) {
                                                phi_5938_ = _e2188;
                                            } else {
                                                phi_5938_ = _e2192;
                                            }
                                            let _e2195 = phi_5938_;
                                            let _e2198 = local_12.member[1u];
                                            if (_e2198[0] < 0f) {
                                                phi_5951_ = -(_e2198[0]);
                                            } else {
                                                phi_5951_ = _e2198[0];
                                            }
                                            let _e2205 = phi_5951_;
                                            if (_e2198[1] < 0f) {
                                                phi_5958_ = -(_e2198[1]);
                                            } else {
                                                phi_5958_ = _e2198[1];
                                            }
                                            let _e2209 = phi_5958_;
                                            if (_e2205 > _e2209) {
                                                phi_5963_ = _e2205;
                                            } else {
                                                phi_5963_ = _e2209;
                                            }
                                            let _e2212 = phi_5963_;
                                            if (_e2198[2] < 0f) {
                                                phi_5970_ = -(_e2198[2]);
                                            } else {
                                                phi_5970_ = _e2198[2];
                                            }
                                            let _e2216 = phi_5970_;
                                            if (_e2212 > _e2216) {
                                                phi_5975_ = _e2212;
                                            } else {
                                                phi_5975_ = _e2216;
                                            }
                                            let _e2219 = phi_5975_;
                                            if (_e2195 > _e2219) {
                                                phi_5980_ = _e2195;
                                            } else {
                                                phi_5980_ = _e2219;
                                            }
                                            let _e2222 = phi_5980_;
                                            let _e2224 = local_12.member_3;
                                            let _e2228 = local_12.member_1[0u];
                                            if (_e2228[0] < 0f) {
                                                phi_5997_ = -(_e2228[0]);
                                            } else {
                                                phi_5997_ = _e2228[0];
                                            }
                                            let _e2235 = phi_5997_;
                                            if (_e2228[1] < 0f) {
                                                phi_6004_ = -(_e2228[1]);
                                            } else {
                                                phi_6004_ = _e2228[1];
                                            }
                                            let _e2239 = phi_6004_;
                                            if (_e2235 > _e2239) {
                                                phi_6009_ = _e2235;
                                            } else {
                                                phi_6009_ = _e2239;
                                            }
                                            let _e2242 = phi_6009_;
                                            if (_e2228[2] < 0f) {
                                                phi_6016_ = -(_e2228[2]);
                                            } else {
                                                phi_6016_ = _e2228[2];
                                            }
                                            let _e2246 = phi_6016_;
                                            if (_e2242 > _e2246) {
                                                phi_6021_ = _e2242;
                                            } else {
                                                phi_6021_ = _e2246;
                                            }
                                            let _e2249 = phi_6021_;
                                            let _e2252 = local_12.member_1[1u];
                                            if (_e2252[0] < 0f) {
                                                phi_6035_ = -(_e2252[0]);
                                            } else {
                                                phi_6035_ = _e2252[0];
                                            }
                                            let _e2259 = phi_6035_;
                                            if (_e2252[1] < 0f) {
                                                phi_6042_ = -(_e2252[1]);
                                            } else {
                                                phi_6042_ = _e2252[1];
                                            }
                                            let _e2263 = phi_6042_;
                                            if (_e2259 > _e2263) {
                                                phi_6047_ = _e2259;
                                            } else {
                                                phi_6047_ = _e2263;
                                            }
                                            let _e2266 = phi_6047_;
                                            if (_e2252[2] < 0f) {
                                                phi_6054_ = -(_e2252[2]);
                                            } else {
                                                phi_6054_ = _e2252[2];
                                            }
                                            let _e2270 = phi_6054_;
                                            if (_e2266 > _e2270) {
                                                phi_6059_ = _e2266;
                                            } else {
                                                phi_6059_ = _e2270;
                                            }
                                            let _e2273 = phi_6059_;
                                            if (_e2249 > _e2273) {
                                                phi_6064_ = _e2249;
                                            } else {
                                                phi_6064_ = _e2273;
                                            }
                                            let _e2276 = phi_6064_;
                                            let _e2278 = local_12.member_3;
                                            let _e2282 = local_12.member_2[0u];
                                            if (_e2282[0] < 0f) {
                                                phi_6081_ = -(_e2282[0]);
                                            } else {
                                                phi_6081_ = _e2282[0];
                                            }
                                            let _e2289 = phi_6081_;
                                            if (_e2282[1] < 0f) {
                                                phi_6088_ = -(_e2282[1]);
                                            } else {
                                                phi_6088_ = _e2282[1];
                                            }
                                            let _e2293 = phi_6088_;
                                            if (_e2289 > _e2293) {
                                                phi_6093_ = _e2289;
                                            } else {
                                                phi_6093_ = _e2293;
                                            }
                                            let _e2296 = phi_6093_;
                                            if (_e2282[2] < 0f) {
                                                phi_6100_ = -(_e2282[2]);
                                            } else {
                                                phi_6100_ = _e2282[2];
                                            }
                                            let _e2300 = phi_6100_;
                                            if (_e2296 > _e2300) {
                                                phi_6105_ = _e2296;
                                            } else {
                                                phi_6105_ = _e2300;
                                            }
                                            let _e2303 = phi_6105_;
                                            let _e2306 = local_12.member_2[1u];
                                            if (_e2306[0] < 0f) {
                                                phi_6119_ = -(_e2306[0]);
                                            } else {
                                                phi_6119_ = _e2306[0];
                                            }
                                            let _e2313 = phi_6119_;
                                            if (_e2306[1] < 0f) {
                                                phi_6126_ = -(_e2306[1]);
                                            } else {
                                                phi_6126_ = _e2306[1];
                                            }
                                            let _e2317 = phi_6126_;
                                            if (_e2313 > _e2317) {
                                                phi_6131_ = _e2313;
                                            } else {
                                                phi_6131_ = _e2317;
                                            }
                                            let _e2320 = phi_6131_;
                                            if (_e2306[2] < 0f) {
                                                phi_6138_ = -(_e2306[2]);
                                            } else {
                                                phi_6138_ = _e2306[2];
                                            }
                                            let _e2324 = phi_6138_;
                                            if (_e2320 > _e2324) {
                                                phi_6143_ = _e2320;
                                            } else {
                                                phi_6143_ = _e2324;
                                            }
                                            let _e2327 = phi_6143_;
                                            if (_e2303 > _e2327) {
                                                phi_6148_ = _e2303;
                                            } else {
                                                phi_6148_ = _e2327;
                                            }
                                            let _e2330 = phi_6148_;
                                            let _e2332 = local_12.member_3;
                                            let _e2339 = local_12.member_3;
                                            local = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_6187_ = type_19(0u, 96u);
                                            phi_6190_ = _e1394.member;
                                            phi_6192_ = _e1394.member;
                                            phi_6194_ = _e1394.member;
                                            loop {
                                                let _e2345 = phi_6187_;
                                                let _e2347 = phi_6190_;
                                                let _e2349 = phi_6192_;
                                                let _e2351 = phi_6194_;
                                                local_36 = _e2349;
                                                local_20 = _e2347;
                                                if (_e2345.member < _e2345.member_1) {
                                                    phi_6188_ = type_19((_e2345.member + 1u), _e2345.member_1);
                                                    phi_6217_ = type_19(1u, _e2345.member);
                                                } else {
                                                    phi_6188_ = _e2345;
                                                    phi_6217_ = type_19(0u, type_19().member_1);
                                                }
                                                let _e2363 = phi_6188_;
                                                let _e2365 = phi_6217_;
                                                if (bitcast<i32>(_e2365.member) != 0i) {
                                                    let _e2372 = local_12.member[0u];
                                                    let _e2378 = local_12.member[1u];
                                                    let _e2394 = local_12.member_1[0u];
                                                    let _e2400 = local_12.member_1[1u];
                                                    let _e2416 = local_12.member_2[0u];
                                                    let _e2422 = local_12.member_2[1u];
                                                    let _e2436 = function_2(array<f32, 3>((_e2372[0] + ((_e2378[0] - _e2372[0]) * _e2347)), (_e2372[1] + ((_e2378[1] - _e2372[1]) * _e2347)), (_e2372[2] + ((_e2378[2] - _e2372[2]) * _e2347))), array<f32, 3>((_e2394[0] + ((_e2400[0] - _e2394[0]) * _e2347)), (_e2394[1] + ((_e2400[1] - _e2394[1]) * _e2347)), (_e2394[2] + ((_e2400[2] - _e2394[2]) * _e2347))), array<f32, 3>((_e2416[0] + ((_e2422[0] - _e2416[0]) * _e2347)), (_e2416[1] + ((_e2422[1] - _e2416[1]) * _e2347)), (_e2416[2] + ((_e2422[2] - _e2416[2]) * _e2347))), 1u);
                                                    if (_e2436[0] < 0f) {
                                                        phi_6329_ = -(_e2436[0]);
                                                    } else {
                                                        phi_6329_ = _e2436[0];
                                                    }
                                                    let _e2441 = phi_6329_;
                                                    if (_e2436[1] < 0f) {
                                                        phi_6336_ = -(_e2436[1]);
                                                    } else {
                                                        phi_6336_ = _e2436[1];
                                                    }
                                                    let _e2446 = phi_6336_;
                                                    if (_e2436[2] < 0f) {
                                                        phi_6344_ = -(_e2436[2]);
                                                    } else {
                                                        phi_6344_ = _e2436[2];
                                                    }
                                                    let _e2452 = phi_6344_;
                                                    let _e2453 = ((_e2441 + _e2446) + _e2452);
                                                    if (_e2453 > 0f) {
                                                        if ((bitcast<u32>(_e2453) & 2139095040u) != 2139095040u) {
                                                            let _e2458 = (1f / _e2453);
                                                            let _e2460 = (_e2436[0] * _e2458);
                                                            let _e2462 = (_e2436[1] * _e2458);
                                                            let _e2464 = (_e2436[2] * _e2458);
                                                            let _e2469 = (((_e2460 * _e2460) + (_e2462 * _e2462)) + (_e2464 * _e2464));
                                                            if (_e2469 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2469 > 0f) {
                                                                    phi_6381_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6381_ = 0f;
                                                                }
                                                                let _e2522 = phi_6381_;
                                                                phi_6445_ = _e2522;
                                                            } else {
                                                                phi_6388_ = type_17(0i, 5i);
                                                                phi_6391_ = bitcast<f32>(((bitcast<u32>(_e2469) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2477 = phi_6388_;
                                                                    let _e2479 = phi_6391_;
                                                                    local_18 = _e2479;
                                                                    if (_e2477.member < _e2477.member_1) {
                                                                        let _e2486 = (_e2477.member + 1i);
                                                                        if ((false == (_e2486 > _e2477.member)) != false) {
                                                                            phi_6412_ = true;
                                                                        } else {
                                                                            phi_6412_ = false;
                                                                        }
                                                                        let _e2491 = phi_6412_;
                                                                        if _e2491 {
                                                                            phi_6418_ = type_18(0u, type_18().member_1);
                                                                        } else {
                                                                            phi_6418_ = type_18(1u, _e2486);
                                                                        }
                                                                        let _e2496 = phi_6418_;
                                                                        phi_6389_ = type_17(_e2496.member_1, _e2477.member_1);
                                                                        phi_6432_ = type_18(1u, _e2477.member);
                                                                    } else {
                                                                        phi_6389_ = _e2477;
                                                                        phi_6432_ = type_18(0u, type_18().member_1);
                                                                    }
                                                                    let _e2502 = phi_6389_;
                                                                    let _e2504 = phi_6432_;
                                                                    let _e2507 = (bitcast<i32>(_e2504.member) != 0i);
                                                                    if _e2507 {
                                                                        phi_6392_ = (0.5f * (_e2479 + (_e2469 / _e2479)));
                                                                    } else {
                                                                        phi_6392_ = f32();
                                                                    }
                                                                    let _e2512 = phi_6392_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6388_ = _e2502;
                                                                        phi_6391_ = _e2512;
                                                                        break if !(_e2507);
                                                                    }
                                                                }
                                                                let _e2517 = local_18;
                                                                phi_6445_ = (_e2517 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2524 = phi_6445_;
                                                            let _e2525 = (0.000000059604645f * 12f);
                                                            let _e2530 = ((((((((_e2222 + _e2224) + (_e2276 + _e2278)) + (_e2330 + _e2332)) * (0.000000059604645f * 16f)) + (_e2339 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2524) * (1f + _e2525)));
                                                            let _e2535 = (((_e2460 * _e2120[0]) + (_e2462 * _e2120[1])) + (_e2464 * _e2120[2]));
                                                            let _e2540 = (((_e2460 * _e2136) + (_e2462 * _e2137)) + (_e2464 * _e2138));
                                                            let _e2545 = (((_e2460 * (_e2120[0] - _e2132[0])) + (_e2462 * (_e2120[1] - _e2132[1]))) + (_e2464 * (_e2120[2] - _e2132[2])));
                                                            let _e2550 = (((_e2460 * (_e2136 - _e2132[0])) + (_e2462 * (_e2137 - _e2132[1]))) + (_e2464 * (_e2138 - _e2132[2])));
                                                            let _e2556 = (((_e2460 * _e2147[0]) + (_e2462 * _e2147[1])) + (_e2464 * _e2147[2]));
                                                            let _e2561 = (((_e2460 * _e2163) + (_e2462 * _e2164)) + (_e2464 * _e2165));
                                                            let _e2566 = (((_e2460 * (_e2147[0] - _e2159[0])) + (_e2462 * (_e2147[1] - _e2159[1]))) + (_e2464 * (_e2147[2] - _e2159[2])));
                                                            let _e2571 = (((_e2460 * (_e2163 - _e2159[0])) + (_e2462 * (_e2164 - _e2159[1]))) + (_e2464 * (_e2165 - _e2159[2])));
                                                            if (_e2535 < 0f) {
                                                                phi_6511_ = -(_e2535);
                                                            } else {
                                                                phi_6511_ = _e2535;
                                                            }
                                                            let _e2576 = phi_6511_;
                                                            if (_e2556 < 0f) {
                                                                phi_6517_ = -(_e2556);
                                                            } else {
                                                                phi_6517_ = _e2556;
                                                            }
                                                            let _e2580 = phi_6517_;
                                                            if (_e2540 < 0f) {
                                                                phi_6526_ = -(_e2540);
                                                            } else {
                                                                phi_6526_ = _e2540;
                                                            }
                                                            let _e2587 = phi_6526_;
                                                            if (_e2561 < 0f) {
                                                                phi_6532_ = -(_e2561);
                                                            } else {
                                                                phi_6532_ = _e2561;
                                                            }
                                                            let _e2591 = phi_6532_;
                                                            if (_e2545 < 0f) {
                                                                phi_6541_ = -(_e2545);
                                                            } else {
                                                                phi_6541_ = _e2545;
                                                            }
                                                            let _e2598 = phi_6541_;
                                                            if (_e2566 < 0f) {
                                                                phi_6547_ = -(_e2566);
                                                            } else {
                                                                phi_6547_ = _e2566;
                                                            }
                                                            let _e2602 = phi_6547_;
                                                            if (_e2550 < 0f) {
                                                                phi_6556_ = -(_e2550);
                                                            } else {
                                                                phi_6556_ = _e2550;
                                                            }
                                                            let _e2609 = phi_6556_;
                                                            if (_e2571 < 0f) {
                                                                phi_6562_ = -(_e2571);
                                                            } else {
                                                                phi_6562_ = _e2571;
                                                            }
                                                            let _e2613 = phi_6562_;
                                                            phi_6568_ = type_28(array<f32, 4>(_e2535, _e2540, _e2545, _e2550), array<f32, 4>(_e2556, _e2561, _e2566, _e2571), array<f32, 4>((_e2530 + ((_e2576 + _e2580) * _e2525)), (_e2530 + ((_e2587 + _e2591) * _e2525)), (_e2530 + ((_e2598 + _e2602) * _e2525)), (_e2530 + ((_e2609 + _e2613) * _e2525))));
                                                            phi_6569_ = false;
                                                        } else {
                                                            phi_6568_ = type_28();
                                                            phi_6569_ = true;
                                                        }
                                                        let _e2620 = phi_6568_;
                                                        let _e2622 = phi_6569_;
                                                        phi_6570_ = _e2620;
                                                        phi_6571_ = _e2622;
                                                    } else {
                                                        phi_6570_ = type_28();
                                                        phi_6571_ = true;
                                                    }
                                                    let _e2624 = phi_6570_;
                                                    let _e2626 = phi_6571_;
                                                    if _e2626 {
                                                        phi_6579_ = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_6579_ = _e2624;
                                                    }
                                                    let _e2628 = phi_6579_;
                                                    local_1 = type_28(array<f32, 4>(_e2628.member[0], _e2628.member[1], _e2628.member[2], _e2628.member[3]), array<f32, 4>(_e2628.member_1[0], _e2628.member_1[1], _e2628.member_1[2], _e2628.member_1[3]), array<f32, 4>(_e2628.member_2[0], _e2628.member_2[1], _e2628.member_2[2], _e2628.member_2[3]));
                                                    let _e2648 = (_e2347 - _e2351);
                                                    let _e2651 = local_1.member[0u];
                                                    let _e2654 = local_1.member_1[0u];
                                                    let _e2657 = local_1.member[0u];
                                                    let _e2663 = local_1.member_2[0u];
                                                    if (((_e2651 + ((_e2654 - _e2657) * _e2347)) - _e2663) > 0f) {
                                                        let _e2668 = local_1.member[1u];
                                                        let _e2671 = local_1.member_1[1u];
                                                        let _e2674 = local_1.member[1u];
                                                        let _e2680 = local_1.member_2[1u];
                                                        if (((_e2668 + ((_e2671 - _e2674) * _e2347)) - _e2680) > 0f) {
                                                            let _e2685 = local_1.member[2u];
                                                            let _e2688 = local_1.member_1[2u];
                                                            let _e2691 = local_1.member[2u];
                                                            let _e2697 = local_1.member_2[2u];
                                                            if (((_e2685 + ((_e2688 - _e2691) * _e2347)) - _e2697) > 0f) {
                                                                let _e2702 = local_1.member[3u];
                                                                let _e2705 = local_1.member_1[3u];
                                                                let _e2708 = local_1.member[3u];
                                                                let _e2714 = local_1.member_2[3u];
                                                                phi_6749_ = (((_e2702 + ((_e2705 - _e2708) * _e2347)) - _e2714) > 0f);
                                                                phi_6750_ = false;
                                                            } else {
                                                                phi_6749_ = bool();
                                                                phi_6750_ = true;
                                                            }
                                                            let _e2718 = phi_6749_;
                                                            let _e2720 = phi_6750_;
                                                            phi_6751_ = _e2718;
                                                            phi_6752_ = _e2720;
                                                        } else {
                                                            phi_6751_ = bool();
                                                            phi_6752_ = true;
                                                        }
                                                        let _e2722 = phi_6751_;
                                                        let _e2724 = phi_6752_;
                                                        phi_6753_ = _e2722;
                                                        phi_6754_ = _e2724;
                                                    } else {
                                                        phi_6753_ = bool();
                                                        phi_6754_ = true;
                                                    }
                                                    let _e2726 = phi_6753_;
                                                    let _e2728 = phi_6754_;
                                                    if _e2728 {
                                                        phi_6758_ = false;
                                                    } else {
                                                        phi_6758_ = _e2726;
                                                    }
                                                    let _e2730 = phi_6758_;
                                                    if _e2730 {
                                                        if (_e2347 <= _e2349) {
                                                            phi_7068_ = true;
                                                        } else {
                                                            let _e2734 = local.member[0u];
                                                            let _e2737 = local.member_1[0u];
                                                            let _e2740 = local.member[0u];
                                                            let _e2746 = local.member_2[0u];
                                                            let _e2750 = local_1.member[0u];
                                                            let _e2753 = local_1.member_1[0u];
                                                            let _e2756 = local_1.member[0u];
                                                            let _e2762 = local_1.member_2[0u];
                                                            if ((((_e2734 + ((_e2737 - _e2740) * _e2347)) - _e2746) + ((_e2750 + ((_e2753 - _e2756) * _e2351)) - _e2762)) > 0f) {
                                                                let _e2768 = local.member[1u];
                                                                let _e2771 = local.member_1[1u];
                                                                let _e2774 = local.member[1u];
                                                                let _e2780 = local.member_2[1u];
                                                                let _e2784 = local_1.member[1u];
                                                                let _e2787 = local_1.member_1[1u];
                                                                let _e2790 = local_1.member[1u];
                                                                let _e2796 = local_1.member_2[1u];
                                                                if ((((_e2768 + ((_e2771 - _e2774) * _e2347)) - _e2780) + ((_e2784 + ((_e2787 - _e2790) * _e2351)) - _e2796)) > 0f) {
                                                                    let _e2802 = local.member[2u];
                                                                    let _e2805 = local.member_1[2u];
                                                                    let _e2808 = local.member[2u];
                                                                    let _e2814 = local.member_2[2u];
                                                                    let _e2818 = local_1.member[2u];
                                                                    let _e2821 = local_1.member_1[2u];
                                                                    let _e2824 = local_1.member[2u];
                                                                    let _e2830 = local_1.member_2[2u];
                                                                    if ((((_e2802 + ((_e2805 - _e2808) * _e2347)) - _e2814) + ((_e2818 + ((_e2821 - _e2824) * _e2351)) - _e2830)) > 0f) {
                                                                        let _e2836 = local.member[3u];
                                                                        let _e2839 = local.member_1[3u];
                                                                        let _e2842 = local.member[3u];
                                                                        let _e2848 = local.member_2[3u];
                                                                        let _e2852 = local_1.member[3u];
                                                                        let _e2855 = local_1.member_1[3u];
                                                                        let _e2858 = local_1.member[3u];
                                                                        let _e2864 = local_1.member_2[3u];
                                                                        phi_7055_ = ((((_e2836 + ((_e2839 - _e2842) * _e2347)) - _e2848) + ((_e2852 + ((_e2855 - _e2858) * _e2351)) - _e2864)) > 0f);
                                                                        phi_7056_ = false;
                                                                    } else {
                                                                        phi_7055_ = bool();
                                                                        phi_7056_ = true;
                                                                    }
                                                                    let _e2869 = phi_7055_;
                                                                    let _e2871 = phi_7056_;
                                                                    phi_7057_ = _e2869;
                                                                    phi_7058_ = _e2871;
                                                                } else {
                                                                    phi_7057_ = bool();
                                                                    phi_7058_ = true;
                                                                }
                                                                let _e2873 = phi_7057_;
                                                                let _e2875 = phi_7058_;
                                                                phi_7059_ = _e2873;
                                                                phi_7060_ = _e2875;
                                                            } else {
                                                                phi_7059_ = bool();
                                                                phi_7060_ = true;
                                                            }
                                                            let _e2877 = phi_7059_;
                                                            let _e2879 = phi_7060_;
                                                            if _e2879 {
                                                                phi_7064_ = false;
                                                            } else {
                                                                phi_7064_ = _e2877;
                                                            }
                                                            let _e2881 = phi_7064_;
                                                            phi_7068_ = _e2881;
                                                        }
                                                        let _e2883 = phi_7068_;
                                                        if _e2883 {
                                                            if (_e2365.member_1 > 0u) {
                                                                if (_e2347 >= _e1394.member_1) {
                                                                    phi_7080_ = false;
                                                                } else {
                                                                    phi_7080_ = true;
                                                                }
                                                                let _e2887 = phi_7080_;
                                                                phi_7081_ = _e2887;
                                                            } else {
                                                                phi_7081_ = true;
                                                            }
                                                            let _e2889 = phi_7081_;
                                                            if _e2889 {
                                                                local = type_28(array<f32, 4>(_e2628.member[0], _e2628.member[1], _e2628.member[2], _e2628.member[3]), array<f32, 4>(_e2628.member_1[0], _e2628.member_1[1], _e2628.member_1[2], _e2628.member_1[3]), array<f32, 4>(_e2628.member_2[0], _e2628.member_2[1], _e2628.member_2[2], _e2628.member_2[3]));
                                                                let _e2911 = local.member[0u];
                                                                let _e2914 = local.member_1[0u];
                                                                let _e2917 = local.member_2[0u];
                                                                if (_e2911 > _e2917) {
                                                                    if (_e2914 > _e2917) {
                                                                        phi_7155_ = false;
                                                                    } else {
                                                                        phi_7155_ = true;
                                                                    }
                                                                    let _e2921 = phi_7155_;
                                                                    phi_7156_ = _e2921;
                                                                } else {
                                                                    phi_7156_ = true;
                                                                }
                                                                let _e2923 = phi_7156_;
                                                                if _e2923 {
                                                                    let _e2924 = (_e2914 >= _e2911);
                                                                    if _e2924 {
                                                                        phi_7178_ = f32();
                                                                        phi_7179_ = false;
                                                                    } else {
                                                                        if ((_e2911 - _e2914) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7176_ = (((_e2911 - _e2917) / (_e2911 - _e2914)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7177_ = false;
                                                                        } else {
                                                                            phi_7176_ = f32();
                                                                            phi_7177_ = true;
                                                                        }
                                                                        let _e2935 = phi_7176_;
                                                                        let _e2937 = phi_7177_;
                                                                        phi_7178_ = _e2935;
                                                                        phi_7179_ = _e2937;
                                                                    }
                                                                    let _e2939 = phi_7178_;
                                                                    let _e2941 = phi_7179_;
                                                                    phi_7180_ = _e2939;
                                                                    phi_7181_ = _e2924;
                                                                    phi_7182_ = _e2941;
                                                                } else {
                                                                    phi_7180_ = f32();
                                                                    phi_7181_ = true;
                                                                    phi_7182_ = false;
                                                                }
                                                                let _e2943 = phi_7180_;
                                                                let _e2945 = phi_7181_;
                                                                let _e2947 = phi_7182_;
                                                                if _e2945 {
                                                                    phi_7186_ = 2f;
                                                                    phi_7187_ = true;
                                                                } else {
                                                                    phi_7186_ = _e2347;
                                                                    phi_7187_ = _e2947;
                                                                }
                                                                let _e2949 = phi_7186_;
                                                                let _e2951 = phi_7187_;
                                                                if _e2951 {
                                                                    phi_7191_ = _e2949;
                                                                } else {
                                                                    phi_7191_ = _e2943;
                                                                }
                                                                let _e2953 = phi_7191_;
                                                                let _e2956 = local.member[1u];
                                                                let _e2959 = local.member_1[1u];
                                                                let _e2962 = local.member_2[1u];
                                                                if (_e2956 > _e2962) {
                                                                    if (_e2959 > _e2962) {
                                                                        phi_7223_ = false;
                                                                    } else {
                                                                        phi_7223_ = true;
                                                                    }
                                                                    let _e2966 = phi_7223_;
                                                                    phi_7224_ = _e2966;
                                                                } else {
                                                                    phi_7224_ = true;
                                                                }
                                                                let _e2968 = phi_7224_;
                                                                if _e2968 {
                                                                    let _e2969 = (_e2959 >= _e2956);
                                                                    if _e2969 {
                                                                        phi_7246_ = f32();
                                                                        phi_7247_ = false;
                                                                    } else {
                                                                        if ((_e2956 - _e2959) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7244_ = (((_e2956 - _e2962) / (_e2956 - _e2959)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7245_ = false;
                                                                        } else {
                                                                            phi_7244_ = f32();
                                                                            phi_7245_ = true;
                                                                        }
                                                                        let _e2980 = phi_7244_;
                                                                        let _e2982 = phi_7245_;
                                                                        phi_7246_ = _e2980;
                                                                        phi_7247_ = _e2982;
                                                                    }
                                                                    let _e2984 = phi_7246_;
                                                                    let _e2986 = phi_7247_;
                                                                    phi_7248_ = _e2984;
                                                                    phi_7249_ = _e2969;
                                                                    phi_7250_ = _e2986;
                                                                } else {
                                                                    phi_7248_ = f32();
                                                                    phi_7249_ = true;
                                                                    phi_7250_ = false;
                                                                }
                                                                let _e2988 = phi_7248_;
                                                                let _e2990 = phi_7249_;
                                                                let _e2992 = phi_7250_;
                                                                if _e2990 {
                                                                    phi_7254_ = 2f;
                                                                    phi_7255_ = true;
                                                                } else {
                                                                    phi_7254_ = _e2347;
                                                                    phi_7255_ = _e2992;
                                                                }
                                                                let _e2994 = phi_7254_;
                                                                let _e2996 = phi_7255_;
                                                                if _e2996 {
                                                                    phi_7259_ = _e2994;
                                                                } else {
                                                                    phi_7259_ = _e2988;
                                                                }
                                                                let _e2998 = phi_7259_;
                                                                if (_e2953 < _e2998) {
                                                                    phi_7264_ = _e2953;
                                                                } else {
                                                                    phi_7264_ = _e2998;
                                                                }
                                                                let _e3001 = phi_7264_;
                                                                let _e3004 = local.member[2u];
                                                                let _e3007 = local.member_1[2u];
                                                                let _e3010 = local.member_2[2u];
                                                                if (_e3004 > _e3010) {
                                                                    if (_e3007 > _e3010) {
                                                                        phi_7296_ = false;
                                                                    } else {
                                                                        phi_7296_ = true;
                                                                    }
                                                                    let _e3014 = phi_7296_;
                                                                    phi_7297_ = _e3014;
                                                                } else {
                                                                    phi_7297_ = true;
                                                                }
                                                                let _e3016 = phi_7297_;
                                                                if _e3016 {
                                                                    let _e3017 = (_e3007 >= _e3004);
                                                                    if _e3017 {
                                                                        phi_7319_ = f32();
                                                                        phi_7320_ = false;
                                                                    } else {
                                                                        if ((_e3004 - _e3007) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7317_ = (((_e3004 - _e3010) / (_e3004 - _e3007)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7318_ = false;
                                                                        } else {
                                                                            phi_7317_ = f32();
                                                                            phi_7318_ = true;
                                                                        }
                                                                        let _e3028 = phi_7317_;
                                                                        let _e3030 = phi_7318_;
                                                                        phi_7319_ = _e3028;
                                                                        phi_7320_ = _e3030;
                                                                    }
                                                                    let _e3032 = phi_7319_;
                                                                    let _e3034 = phi_7320_;
                                                                    phi_7321_ = _e3032;
                                                                    phi_7322_ = _e3017;
                                                                    phi_7323_ = _e3034;
                                                                } else {
                                                                    phi_7321_ = f32();
                                                                    phi_7322_ = true;
                                                                    phi_7323_ = false;
                                                                }
                                                                let _e3036 = phi_7321_;
                                                                let _e3038 = phi_7322_;
                                                                let _e3040 = phi_7323_;
                                                                if _e3038 {
                                                                    phi_7327_ = 2f;
                                                                    phi_7328_ = true;
                                                                } else {
                                                                    phi_7327_ = _e2347;
                                                                    phi_7328_ = _e3040;
                                                                }
                                                                let _e3042 = phi_7327_;
                                                                let _e3044 = phi_7328_;
                                                                if _e3044 {
                                                                    phi_7332_ = _e3042;
                                                                } else {
                                                                    phi_7332_ = _e3036;
                                                                }
                                                                let _e3046 = phi_7332_;
                                                                let _e3049 = local.member[3u];
                                                                let _e3052 = local.member_1[3u];
                                                                let _e3055 = local.member_2[3u];
                                                                if (_e3049 > _e3055) {
                                                                    if (_e3052 > _e3055) {
                                                                        phi_7364_ = false;
                                                                    } else {
                                                                        phi_7364_ = true;
                                                                    }
                                                                    let _e3059 = phi_7364_;
                                                                    phi_7365_ = _e3059;
                                                                } else {
                                                                    phi_7365_ = true;
                                                                }
                                                                let _e3061 = phi_7365_;
                                                                if _e3061 {
                                                                    let _e3062 = (_e3052 >= _e3049);
                                                                    if _e3062 {
                                                                        phi_7387_ = f32();
                                                                        phi_7388_ = false;
                                                                    } else {
                                                                        if ((_e3049 - _e3052) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7385_ = (((_e3049 - _e3055) / (_e3049 - _e3052)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7386_ = false;
                                                                        } else {
                                                                            phi_7385_ = f32();
                                                                            phi_7386_ = true;
                                                                        }
                                                                        let _e3073 = phi_7385_;
                                                                        let _e3075 = phi_7386_;
                                                                        phi_7387_ = _e3073;
                                                                        phi_7388_ = _e3075;
                                                                    }
                                                                    let _e3077 = phi_7387_;
                                                                    let _e3079 = phi_7388_;
                                                                    phi_7389_ = _e3077;
                                                                    phi_7390_ = _e3062;
                                                                    phi_7391_ = _e3079;
                                                                } else {
                                                                    phi_7389_ = f32();
                                                                    phi_7390_ = true;
                                                                    phi_7391_ = false;
                                                                }
                                                                let _e3081 = phi_7389_;
                                                                let _e3083 = phi_7390_;
                                                                let _e3085 = phi_7391_;
                                                                if _e3083 {
                                                                    phi_7395_ = 2f;
                                                                    phi_7396_ = true;
                                                                } else {
                                                                    phi_7395_ = _e2347;
                                                                    phi_7396_ = _e3085;
                                                                }
                                                                let _e3087 = phi_7395_;
                                                                let _e3089 = phi_7396_;
                                                                if _e3089 {
                                                                    phi_7400_ = _e3087;
                                                                } else {
                                                                    phi_7400_ = _e3081;
                                                                }
                                                                let _e3091 = phi_7400_;
                                                                if (_e3046 < _e3091) {
                                                                    phi_7405_ = _e3046;
                                                                } else {
                                                                    phi_7405_ = _e3091;
                                                                }
                                                                let _e3094 = phi_7405_;
                                                                if (_e3001 < _e3094) {
                                                                    phi_7410_ = _e3001;
                                                                } else {
                                                                    phi_7410_ = _e3094;
                                                                }
                                                                let _e3097 = phi_7410_;
                                                                if (_e3097 > _e2347) {
                                                                    phi_7415_ = _e3097;
                                                                } else {
                                                                    phi_7415_ = _e2347;
                                                                }
                                                                let _e3100 = phi_7415_;
                                                                let _e3101 = (_e3100 > _e1394.member_1);
                                                                if _e3101 {
                                                                    phi_7427_ = f32();
                                                                    phi_7428_ = false;
                                                                } else {
                                                                    if (_e2365.member_1 == 0u) {
                                                                        phi_7426_ = (_e1394.member_1 - _e2347);
                                                                    } else {
                                                                        phi_7426_ = (_e2648 + _e2648);
                                                                    }
                                                                    let _e3106 = phi_7426_;
                                                                    phi_7427_ = _e3106;
                                                                    phi_7428_ = true;
                                                                }
                                                                let _e3108 = phi_7427_;
                                                                let _e3110 = phi_7428_;
                                                                phi_7429_ = _e3100;
                                                                phi_7430_ = _e3108;
                                                                phi_7431_ = _e3110;
                                                                phi_7432_ = _e3101;
                                                                phi_7433_ = false;
                                                            } else {
                                                                phi_7429_ = f32();
                                                                phi_7430_ = f32();
                                                                phi_7431_ = false;
                                                                phi_7432_ = false;
                                                                phi_7433_ = true;
                                                            }
                                                            let _e3112 = phi_7429_;
                                                            let _e3114 = phi_7430_;
                                                            let _e3116 = phi_7431_;
                                                            let _e3118 = phi_7432_;
                                                            let _e3120 = phi_7433_;
                                                            phi_7434_ = _e3112;
                                                            phi_7435_ = _e3114;
                                                            phi_7436_ = false;
                                                            phi_7437_ = _e3116;
                                                            phi_7438_ = _e3118;
                                                            phi_7439_ = _e3120;
                                                        } else {
                                                            phi_7434_ = f32();
                                                            phi_7435_ = f32();
                                                            phi_7436_ = true;
                                                            phi_7437_ = false;
                                                            phi_7438_ = false;
                                                            phi_7439_ = false;
                                                        }
                                                        let _e3122 = phi_7434_;
                                                        let _e3124 = phi_7435_;
                                                        let _e3126 = phi_7436_;
                                                        let _e3128 = phi_7437_;
                                                        let _e3130 = phi_7438_;
                                                        let _e3132 = phi_7439_;
                                                        phi_7440_ = _e3122;
                                                        phi_7441_ = _e3124;
                                                        phi_7442_ = _e3126;
                                                        phi_7443_ = _e3128;
                                                        phi_7444_ = _e3130;
                                                        phi_7445_ = _e3132;
                                                    } else {
                                                        phi_7440_ = f32();
                                                        phi_7441_ = f32();
                                                        phi_7442_ = true;
                                                        phi_7443_ = false;
                                                        phi_7444_ = false;
                                                        phi_7445_ = false;
                                                    }
                                                    let _e3134 = phi_7440_;
                                                    let _e3136 = phi_7441_;
                                                    let _e3138 = phi_7442_;
                                                    let _e3140 = phi_7443_;
                                                    let _e3142 = phi_7444_;
                                                    let _e3144 = phi_7445_;
                                                    if _e3138 {
                                                        let _e3145 = (_e2347 <= _e2349);
                                                        if _e3145 {
                                                            phi_7774_ = f32();
                                                            phi_7775_ = false;
                                                        } else {
                                                            let _e3148 = local.member[0u];
                                                            let _e3151 = local.member_1[0u];
                                                            let _e3154 = local.member[0u];
                                                            let _e3160 = local.member_2[0u];
                                                            let _e3161 = ((_e3148 + ((_e3151 - _e3154) * _e2351)) - _e3160);
                                                            let _e3164 = local.member[1u];
                                                            let _e3167 = local.member_1[1u];
                                                            let _e3170 = local.member[1u];
                                                            let _e3176 = local.member_2[1u];
                                                            let _e3177 = ((_e3164 + ((_e3167 - _e3170) * _e2351)) - _e3176);
                                                            if (_e3161 < _e3177) {
                                                                phi_7525_ = _e3161;
                                                            } else {
                                                                phi_7525_ = _e3177;
                                                            }
                                                            let _e3180 = phi_7525_;
                                                            let _e3183 = local.member[2u];
                                                            let _e3186 = local.member_1[2u];
                                                            let _e3189 = local.member[2u];
                                                            let _e3195 = local.member_2[2u];
                                                            let _e3196 = ((_e3183 + ((_e3186 - _e3189) * _e2351)) - _e3195);
                                                            let _e3199 = local.member[3u];
                                                            let _e3202 = local.member_1[3u];
                                                            let _e3205 = local.member[3u];
                                                            let _e3211 = local.member_2[3u];
                                                            let _e3212 = ((_e3199 + ((_e3202 - _e3205) * _e2351)) - _e3211);
                                                            if (_e3196 < _e3212) {
                                                                phi_7598_ = _e3196;
                                                            } else {
                                                                phi_7598_ = _e3212;
                                                            }
                                                            let _e3215 = phi_7598_;
                                                            if (_e3180 < _e3215) {
                                                                phi_7603_ = _e3180;
                                                            } else {
                                                                phi_7603_ = _e3215;
                                                            }
                                                            let _e3218 = phi_7603_;
                                                            let _e3221 = local_1.member[0u];
                                                            let _e3224 = local_1.member_1[0u];
                                                            let _e3227 = local_1.member[0u];
                                                            let _e3233 = local_1.member_2[0u];
                                                            let _e3234 = ((_e3221 + ((_e3224 - _e3227) * _e2347)) - _e3233);
                                                            let _e3237 = local_1.member[1u];
                                                            let _e3240 = local_1.member_1[1u];
                                                            let _e3243 = local_1.member[1u];
                                                            let _e3249 = local_1.member_2[1u];
                                                            let _e3250 = ((_e3237 + ((_e3240 - _e3243) * _e2347)) - _e3249);
                                                            if (_e3234 < _e3250) {
                                                                phi_7676_ = _e3234;
                                                            } else {
                                                                phi_7676_ = _e3250;
                                                            }
                                                            let _e3253 = phi_7676_;
                                                            let _e3256 = local_1.member[2u];
                                                            let _e3259 = local_1.member_1[2u];
                                                            let _e3262 = local_1.member[2u];
                                                            let _e3268 = local_1.member_2[2u];
                                                            let _e3269 = ((_e3256 + ((_e3259 - _e3262) * _e2347)) - _e3268);
                                                            let _e3272 = local_1.member[3u];
                                                            let _e3275 = local_1.member_1[3u];
                                                            let _e3278 = local_1.member[3u];
                                                            let _e3284 = local_1.member_2[3u];
                                                            let _e3285 = ((_e3272 + ((_e3275 - _e3278) * _e2347)) - _e3284);
                                                            if (_e3269 < _e3285) {
                                                                phi_7749_ = _e3269;
                                                            } else {
                                                                phi_7749_ = _e3285;
                                                            }
                                                            let _e3288 = phi_7749_;
                                                            if (_e3253 < _e3288) {
                                                                phi_7754_ = _e3253;
                                                            } else {
                                                                phi_7754_ = _e3288;
                                                            }
                                                            let _e3291 = phi_7754_;
                                                            if (_e3291 > 0f) {
                                                                phi_7772_ = 0.5f;
                                                            } else {
                                                                let _e3295 = (0.95f * (_e3218 / (_e3218 - _e3291)));
                                                                if (_e3295 > 0.0625f) {
                                                                    if (_e3295 < 0.9f) {
                                                                        phi_7770_ = _e3295;
                                                                    } else {
                                                                        phi_7770_ = 0.9f;
                                                                    }
                                                                    let _e3299 = phi_7770_;
                                                                    phi_7771_ = _e3299;
                                                                } else {
                                                                    phi_7771_ = 0.0625f;
                                                                }
                                                                let _e3301 = phi_7771_;
                                                                phi_7772_ = _e3301;
                                                            }
                                                            let _e3303 = phi_7772_;
                                                            phi_7774_ = (_e2648 * _e3303);
                                                            phi_7775_ = true;
                                                        }
                                                        let _e3306 = phi_7774_;
                                                        let _e3308 = phi_7775_;
                                                        phi_7776_ = _e2349;
                                                        phi_7777_ = _e3306;
                                                        phi_7778_ = _e2351;
                                                        phi_7779_ = _e3308;
                                                        phi_7780_ = _e3145;
                                                        phi_7781_ = false;
                                                        phi_7782_ = false;
                                                    } else {
                                                        phi_7776_ = _e3134;
                                                        phi_7777_ = _e3136;
                                                        phi_7778_ = _e2347;
                                                        phi_7779_ = _e3140;
                                                        phi_7780_ = false;
                                                        phi_7781_ = _e3142;
                                                        phi_7782_ = _e3144;
                                                    }
                                                    let _e3310 = phi_7776_;
                                                    let _e3312 = phi_7777_;
                                                    let _e3314 = phi_7778_;
                                                    let _e3316 = phi_7779_;
                                                    let _e3318 = phi_7780_;
                                                    let _e3320 = phi_7781_;
                                                    let _e3322 = phi_7782_;
                                                    if _e3316 {
                                                        let _e3323 = (_e3314 + _e3312);
                                                        if (_e3323 > _e3310) {
                                                            phi_7791_ = _e3323;
                                                        } else {
                                                            phi_7791_ = _e3310;
                                                        }
                                                        let _e3326 = phi_7791_;
                                                        if (_e3326 < _e1394.member_1) {
                                                            phi_7796_ = _e3326;
                                                        } else {
                                                            phi_7796_ = _e1394.member_1;
                                                        }
                                                        let _e3329 = phi_7796_;
                                                        if (_e2365.member_1 > 0u) {
                                                            phi_7806_ = ((_e3329 - _e3314) > 0.0000000037252903f);
                                                        } else {
                                                            phi_7806_ = true;
                                                        }
                                                        let _e3334 = phi_7806_;
                                                        if _e3334 {
                                                            phi_7810_ = false;
                                                        } else {
                                                            phi_7810_ = true;
                                                        }
                                                        let _e3336 = phi_7810_;
                                                        phi_7811_ = _e3329;
                                                        phi_7812_ = _e3334;
                                                        phi_7813_ = _e3336;
                                                        phi_7814_ = false;
                                                        phi_7815_ = false;
                                                        phi_7816_ = false;
                                                    } else {
                                                        phi_7811_ = f32();
                                                        phi_7812_ = false;
                                                        phi_7813_ = false;
                                                        phi_7814_ = _e3318;
                                                        phi_7815_ = _e3320;
                                                        phi_7816_ = _e3322;
                                                    }
                                                    let _e3338 = phi_7811_;
                                                    let _e3340 = phi_7812_;
                                                    let _e3342 = phi_7813_;
                                                    let _e3344 = phi_7814_;
                                                    let _e3346 = phi_7815_;
                                                    let _e3348 = phi_7816_;
                                                    phi_6191_ = _e3338;
                                                    phi_6193_ = _e3310;
                                                    phi_6195_ = _e3314;
                                                    phi_7817_ = _e3310;
                                                    phi_7818_ = _e3340;
                                                    phi_7819_ = _e3342;
                                                    phi_7820_ = false;
                                                    phi_7821_ = _e3344;
                                                    phi_7822_ = _e3346;
                                                    phi_7823_ = _e3348;
                                                } else {
                                                    phi_6191_ = f32();
                                                    phi_6193_ = f32();
                                                    phi_6195_ = f32();
                                                    phi_7817_ = f32();
                                                    phi_7818_ = false;
                                                    phi_7819_ = false;
                                                    phi_7820_ = true;
                                                    phi_7821_ = false;
                                                    phi_7822_ = false;
                                                    phi_7823_ = false;
                                                }
                                                let _e3350 = phi_6191_;
                                                let _e3352 = phi_6193_;
                                                let _e3354 = phi_6195_;
                                                let _e3356 = phi_7817_;
                                                let _e3358 = phi_7818_;
                                                let _e3360 = phi_7819_;
                                                let _e3362 = phi_7820_;
                                                let _e3364 = phi_7821_;
                                                let _e3366 = phi_7822_;
                                                let _e3368 = phi_7823_;
                                                local_19 = _e3360;
                                                local_35 = _e3356;
                                                local_37 = _e3362;
                                                local_38 = _e3364;
                                                local_39 = _e3366;
                                                local_40 = _e3368;
                                                continue;
                                                continuing {
                                                    phi_6187_ = _e2363;
                                                    phi_6190_ = _e3350;
                                                    phi_6192_ = _e3352;
                                                    phi_6194_ = _e3354;
                                                    break if !(_e3358);
                                                }
                                            }
                                            let _e3371 = local_19;
                                            if _e3371 {
                                                let _e5792 = local_35;
                                                phi_7827_ = _e5792;
                                                phi_7828_ = true;
                                                phi_7829_ = false;
                                                phi_7830_ = false;
                                                phi_7831_ = false;
                                            } else {
                                                let _e5794 = local_36;
                                                phi_7827_ = _e5794;
                                                let _e5797 = local_37;
                                                phi_7828_ = _e5797;
                                                let _e5800 = local_38;
                                                phi_7829_ = _e5800;
                                                let _e5803 = local_39;
                                                phi_7830_ = _e5803;
                                                let _e5806 = local_40;
                                                phi_7831_ = _e5806;
                                            }
                                            let _e3373 = phi_7827_;
                                            let _e3375 = phi_7828_;
                                            let _e3377 = phi_7829_;
                                            let _e3379 = phi_7830_;
                                            let _e3381 = phi_7831_;
                                            if _e3375 {
                                                phi_7836_ = type_33(1u, _e3373);
                                                phi_7837_ = false;
                                                phi_7838_ = false;
                                                phi_7839_ = false;
                                            } else {
                                                phi_7836_ = type_33();
                                                phi_7837_ = _e3377;
                                                phi_7838_ = _e3379;
                                                phi_7839_ = _e3381;
                                            }
                                            let _e3384 = phi_7836_;
                                            let _e3386 = phi_7837_;
                                            let _e3388 = phi_7838_;
                                            let _e3390 = phi_7839_;
                                            if _e3386 {
                                                let _e3392 = local_20;
                                                phi_7844_ = type_33(1u, _e3392);
                                                phi_7845_ = false;
                                                phi_7846_ = false;
                                            } else {
                                                phi_7844_ = type_33();
                                                phi_7845_ = _e3388;
                                                phi_7846_ = _e3390;
                                            }
                                            let _e3395 = phi_7844_;
                                            let _e3397 = phi_7845_;
                                            let _e3399 = phi_7846_;
                                            if _e3397 {
                                                phi_7851_ = type_33(0u, type_33().member_1);
                                                phi_7852_ = false;
                                                phi_7853_ = true;
                                            } else {
                                                phi_7851_ = _e3395;
                                                phi_7852_ = _e3399;
                                                phi_7853_ = _e3386;
                                            }
                                            let _e3403 = phi_7851_;
                                            let _e3405 = phi_7852_;
                                            let _e3407 = phi_7853_;
                                            if _e3405 {
                                                phi_7858_ = type_33(0u, type_33().member_1);
                                                phi_7859_ = true;
                                            } else {
                                                phi_7858_ = _e3403;
                                                phi_7859_ = _e3407;
                                            }
                                            let _e3411 = phi_7858_;
                                            let _e3413 = phi_7859_;
                                            if _e3413 {
                                                phi_7863_ = _e3411;
                                            } else {
                                                phi_7863_ = _e3384;
                                            }
                                            let _e3415 = phi_7863_;
                                            let _e3418 = (_e3415.member != 0u);
                                            if _e3418 {
                                                phi_7870_ = false;
                                            } else {
                                                phi_7870_ = true;
                                            }
                                            let _e3420 = phi_7870_;
                                            phi_7871_ = _e3415.member_1;
                                            phi_7872_ = _e3420;
                                            phi_7873_ = _e3418;
                                            phi_7874_ = false;
                                        } else {
                                            phi_7871_ = f32();
                                            phi_7872_ = false;
                                            phi_7873_ = false;
                                            phi_7874_ = true;
                                        }
                                        let _e3422 = phi_7871_;
                                        let _e3424 = phi_7872_;
                                        let _e3426 = phi_7873_;
                                        let _e3428 = phi_7874_;
                                        phi_7875_ = _e3422;
                                        phi_7876_ = _e3424;
                                        phi_7877_ = _e3426;
                                        phi_7878_ = _e3428;
                                    }
                                    let _e3430 = phi_7875_;
                                    let _e3432 = phi_7876_;
                                    let _e3434 = phi_7877_;
                                    let _e3436 = phi_7878_;
                                    phi_7879_ = _e3430;
                                    phi_7880_ = _e2103;
                                    phi_7881_ = _e3432;
                                    phi_7882_ = _e3434;
                                    phi_7883_ = _e3436;
                                }
                                let _e3438 = phi_7879_;
                                let _e3440 = phi_7880_;
                                let _e3442 = phi_7881_;
                                let _e3444 = phi_7882_;
                                let _e3446 = phi_7883_;
                                if _e3440 {
                                    phi_7887_ = true;
                                    phi_7888_ = false;
                                    phi_7889_ = false;
                                } else {
                                    phi_7887_ = _e3442;
                                    phi_7888_ = _e3444;
                                    phi_7889_ = _e3446;
                                }
                                let _e3448 = phi_7887_;
                                let _e3450 = phi_7888_;
                                let _e3452 = phi_7889_;
                                phi_7890_ = _e3438;
                                phi_7891_ = _e1394;
                                phi_7892_ = _e3448;
                                phi_7893_ = false;
                                phi_7894_ = _e3450;
                                phi_7895_ = _e3452;
                            } else {
                                phi_7890_ = f32();
                                phi_7891_ = type_35();
                                phi_7892_ = false;
                                phi_7893_ = true;
                                phi_7894_ = false;
                                phi_7895_ = false;
                            }
                            let _e3454 = phi_7890_;
                            let _e3456 = phi_7891_;
                            let _e3458 = phi_7892_;
                            let _e3460 = phi_7893_;
                            let _e3462 = phi_7894_;
                            let _e3464 = phi_7895_;
                            local_21 = _e3460;
                            local_41 = _e3462;
                            local_42 = _e3464;
                            local_22 = _e3454;
                            local_23 = _e3456;
                            continue;
                            continuing {
                                phi_4324_ = _e1124;
                                break if !(_e3458);
                            }
                        }
                        let _e3467 = local_21;
                        if _e3467 {
                            phi_7900_ = type_33(0u, type_33().member_1);
                            phi_7901_ = false;
                            phi_7902_ = false;
                        } else {
                            phi_7900_ = type_33();
                            let _e5848 = local_41;
                            phi_7901_ = _e5848;
                            let _e5851 = local_42;
                            phi_7902_ = _e5851;
                        }
                        let _e3471 = phi_7900_;
                        let _e3473 = phi_7901_;
                        let _e3475 = phi_7902_;
                        if _e3473 {
                            let _e3477 = local_22;
                            phi_7907_ = type_33(2u, _e3477);
                            phi_7908_ = false;
                        } else {
                            phi_7907_ = type_33();
                            phi_7908_ = _e3475;
                        }
                        let _e3480 = phi_7907_;
                        let _e3482 = phi_7908_;
                        if _e3482 {
                            let _e3484 = local_23;
                            phi_7914_ = type_33(1u, _e3484.member);
                            phi_7915_ = true;
                        } else {
                            phi_7914_ = _e3480;
                            phi_7915_ = _e3473;
                        }
                        let _e3488 = phi_7914_;
                        let _e3490 = phi_7915_;
                        if _e3490 {
                            phi_7919_ = _e3488;
                        } else {
                            phi_7919_ = _e3471;
                        }
                        let _e3492 = phi_7919_;
                        phi_7923_ = _e3492;
                    }
                    let _e5166 = phi_7923_;
                    phi_7924_ = _e5166;
                }
                let _e5170 = phi_7924_;
                switch bitcast<i32>(_e5170.member) {
                    case 0: {
                        phi_7937_ = type_36(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5176 = function_(_e5170.member_1);
                        phi_7937_ = type_36(0u, _e5176, true);
                        break;
                    }
                    case 2: {
                        let _e5174 = function_(_e5170.member_1);
                        phi_7937_ = type_36(1u, _e5174, true);
                        break;
                    }
                    default: {
                        phi_7937_ = type_36();
                        break;
                    }
                }
                let _e5179 = phi_7937_;
                if _e5179.member_2 {
                    phi_7944_ = (_e5179.member == 0u);
                } else {
                    phi_7944_ = false;
                }
                let _e5184 = phi_7944_;
                if _e5184 {
                    let _e5192 = (_e5179.member_1[1] >> bitcast<u32>(20i));
                    if (_e5192 <= 896u) {
                        phi_7968_ = 0u;
                    } else {
                        phi_7968_ = ((((_e5192 - 896u) << bitcast<u32>(23i)) | ((_e5179.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5179.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5207 = phi_7968_;
                    let _e5209 = atomicMin((&earliest.member[0u]), _e5207);
                }
                phi_7972_ = type_27(_e172, 0u, _e178, _e181, _e5179.member_1);
                phi_7973_ = _e5184;
                phi_7974_ = (_e5179.member != 0u);
            } else {
                phi_7972_ = type_27(_e172, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_7973_ = false;
                phi_7974_ = false;
            }
            let _e5211 = phi_7972_;
            let _e5213 = phi_7973_;
            let _e5215 = phi_7974_;
            let _e5217 = params.member.member_1;
            if ((_e5217 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5213 {
                    let _e5223 = atomicAdd((&counters[0u]), 1u);
                    phi_7992_ = _e5223;
                } else {
                    phi_7992_ = 0u;
                }
                let _e5225 = phi_7992_;
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
                if _e5213 {
                    let _e5237 = params.member.member_16;
                    if (_e5235 < _e5237) {
                        let _e5239 = (6u * _e5235);
                        atomicStore((&contacts.member[(4u + _e5239)]), _e5211.member);
                        atomicStore((&contacts.member[(_e5239 + 5u)]), _e5211.member_1);
                        atomicStore((&contacts.member[(_e5239 + 6u)]), _e5211.member_2);
                        atomicStore((&contacts.member[(_e5239 + 7u)]), _e5211.member_3);
                        atomicStore((&contacts.member[(_e5239 + 8u)]), _e5211.member_4[0]);
                        atomicStore((&contacts.member[(_e5239 + 9u)]), _e5211.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5215 {
                let _e5263 = atomicAdd((&counters[0u]), 1u);
                phi_8054_ = _e5263;
            } else {
                phi_8054_ = 0u;
            }
            let _e5265 = phi_8054_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5268 = atomicLoad((&counters[0u]));
                if (_e5268 > 0u) {
                    let _e5271 = atomicAdd((&undecided.member[0u]), _e5268);
                    atomicStore((&counters[1u]), _e5271);
                }
            }
            workgroupBarrier();
            let _e5274 = atomicLoad((&counters[1u]));
            let _e5275 = (_e5274 + _e5265);
            if _e5215 {
                atomicStore((&undecided.member[(4u + (2u * _e5275))]), _e5211.member_2);
                atomicStore((&undecided.member[((2u * _e5275) + 5u)]), _e5211.member_3);
            }
        }
        continue;
        continuing {
            phi_257_ = _e160;
            break if !(_e166);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
