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

struct type_31 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_32 {
    member: f32,
    member_1: f32,
}

struct type_35 {
    member: type_25,
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
@group(0) @binding(3) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_29;
@group(0) @binding(2) 
var<storage> elements: type_22;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_42;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_42;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_42;

fn function_(param: f32) -> array<u32, 2> {
    var phi_8732_: array<u32, 2>;
    var phi_8733_: array<u32, 2>;
    var phi_8734_: bool;
    var phi_8738_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_8733_ = array<u32, 2>();
        phi_8734_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_8732_ = array<u32, 2>();
        } else {
            phi_8732_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_8732_;
        phi_8733_ = _e31;
        phi_8734_ = _e17;
    }
    let _e33 = phi_8733_;
    let _e35 = phi_8734_;
    if _e35 {
        phi_8738_ = array<u32, 2>(0u, 0u);
    } else {
        phi_8738_ = _e33;
    }
    let _e37 = phi_8738_;
    return _e37;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_8711_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_8711_ = param_2;
    } else {
        phi_8711_ = param_1;
    }
    let _e26 = phi_8711_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_8303_: bool;
    var phi_8304_: bool;
    var phi_8305_: bool;
    var phi_8306_: bool;
    var phi_8310_: bool;
    var phi_8283_: bool;
    var phi_8284_: bool;
    var phi_8285_: bool;
    var phi_8286_: bool;
    var phi_8287_: bool;
    var phi_8288_: bool;
    var phi_8292_: bool;
    var phi_8311_: bool;
    var phi_8341_: array<f32, 3>;
    var phi_8342_: bool;
    var phi_8343_: array<f32, 3>;
    var phi_8344_: bool;
    var phi_8571_: f32;
    var phi_8572_: f32;
    var phi_8611_: f32;
    var phi_8612_: f32;
    var phi_8657_: f32;
    var phi_8658_: f32;
    var phi_8392_: f32;
    var phi_8393_: f32;
    var phi_8438_: f32;
    var phi_8439_: f32;
    var phi_8481_: f32;
    var phi_8482_: f32;
    var phi_8530_: f32;
    var phi_8531_: f32;
    var phi_8673_: array<array<f32, 3>, 4>;
    var phi_8681_: array<f32, 3>;

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
                    phi_8283_ = (_e76 <= 1f);
                    phi_8284_ = false;
                } else {
                    phi_8283_ = bool();
                    phi_8284_ = true;
                }
                let _e97 = phi_8283_;
                let _e99 = phi_8284_;
                phi_8285_ = _e97;
                phi_8286_ = _e99;
            } else {
                phi_8285_ = bool();
                phi_8286_ = true;
            }
            let _e101 = phi_8285_;
            let _e103 = phi_8286_;
            phi_8287_ = _e101;
            phi_8288_ = _e103;
        } else {
            phi_8287_ = bool();
            phi_8288_ = true;
        }
        let _e105 = phi_8287_;
        let _e107 = phi_8288_;
        if _e107 {
            phi_8292_ = false;
        } else {
            phi_8292_ = _e105;
        }
        let _e109 = phi_8292_;
        phi_8311_ = _e109;
    } else {
        if (_e72 >= 0f) {
            if (_e76 >= 0f) {
                phi_8303_ = ((_e72 + _e76) <= 1f);
                phi_8304_ = false;
            } else {
                phi_8303_ = bool();
                phi_8304_ = true;
            }
            let _e83 = phi_8303_;
            let _e85 = phi_8304_;
            phi_8305_ = _e83;
            phi_8306_ = _e85;
        } else {
            phi_8305_ = bool();
            phi_8306_ = true;
        }
        let _e87 = phi_8305_;
        let _e89 = phi_8306_;
        if _e89 {
            phi_8310_ = false;
        } else {
            phi_8310_ = _e87;
        }
        let _e91 = phi_8310_;
        phi_8311_ = _e91;
    }
    let _e111 = phi_8311_;
    if (_e68 > 0f) {
        if _e111 {
            phi_8341_ = array<f32, 3>((param_3[0] - ((param_4[0] * _e72) + (param_5[0] * _e76))), (param_3[1] - ((param_4[1] * _e72) + (param_5[1] * _e76))), (param_3[2] - ((param_4[2] * _e72) + (param_5[2] * _e76))));
            phi_8342_ = false;
        } else {
            phi_8341_ = array<f32, 3>();
            phi_8342_ = true;
        }
        let _e136 = phi_8341_;
        let _e138 = phi_8342_;
        phi_8343_ = _e136;
        phi_8344_ = _e138;
    } else {
        phi_8343_ = array<f32, 3>();
        phi_8344_ = true;
    }
    let _e140 = phi_8343_;
    let _e142 = phi_8344_;
    if _e142 {
        let _e145 = (param_3[0] - param_4[0]);
        let _e148 = (param_3[1] - param_4[1]);
        let _e151 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e293 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e293 > 0f) {
                if (_e293 < 1f) {
                    phi_8392_ = _e293;
                } else {
                    phi_8392_ = 1f;
                }
                let _e297 = phi_8392_;
                phi_8393_ = _e297;
            } else {
                phi_8393_ = 0f;
            }
            let _e299 = phi_8393_;
            let _e335 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_8438_ = _e335;
                } else {
                    phi_8438_ = 1f;
                }
                let _e339 = phi_8438_;
                phi_8439_ = _e339;
            } else {
                phi_8439_ = 0f;
            }
            let _e341 = phi_8439_;
            let _e374 = ((((_e145 * param_5[0]) + (_e148 * param_5[1])) + (_e151 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e374 > 0f) {
                if (_e374 < 1f) {
                    phi_8481_ = _e374;
                } else {
                    phi_8481_ = 1f;
                }
                let _e378 = phi_8481_;
                phi_8482_ = _e378;
            } else {
                phi_8482_ = 0f;
            }
            let _e380 = phi_8482_;
            let _e393 = (param_3[0] - param_5[0]);
            let _e396 = (param_3[1] - param_5[1]);
            let _e399 = (param_3[2] - param_5[2]);
            let _e419 = ((((_e393 * param_4[0]) + (_e396 * param_4[1])) + (_e399 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e419 > 0f) {
                if (_e419 < 1f) {
                    phi_8530_ = _e419;
                } else {
                    phi_8530_ = 1f;
                }
                let _e423 = phi_8530_;
                phi_8531_ = _e423;
            } else {
                phi_8531_ = 0f;
            }
            let _e425 = phi_8531_;
            phi_8673_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e299)), (param_3[1] - (param_4[1] * _e299)), (param_3[2] - (param_4[2] * _e299))), array<f32, 3>((param_3[0] - (param_5[0] * _e341)), (param_3[1] - (param_5[1] * _e341)), (param_3[2] - (param_5[2] * _e341))), array<f32, 3>((_e145 - (param_5[0] * _e380)), (_e148 - (param_5[1] * _e380)), (_e151 - (param_5[2] * _e380))), array<f32, 3>((_e393 - (param_4[0] * _e425)), (_e396 - (param_4[1] * _e425)), (_e399 - (param_4[2] * _e425))));
        } else {
            let _e155 = (param_5[0] - param_4[0]);
            let _e158 = (param_5[1] - param_4[1]);
            let _e161 = (param_5[2] - param_4[2]);
            let _e172 = ((((_e145 * _e155) + (_e148 * _e158)) + (_e151 * _e161)) / (((_e155 * _e155) + (_e158 * _e158)) + (_e161 * _e161)));
            if (_e172 > 0f) {
                if (_e172 < 1f) {
                    phi_8571_ = _e172;
                } else {
                    phi_8571_ = 1f;
                }
                let _e176 = phi_8571_;
                phi_8572_ = _e176;
            } else {
                phi_8572_ = 0f;
            }
            let _e178 = phi_8572_;
            let _e185 = array<f32, 3>((_e145 - (_e155 * _e178)), (_e148 - (_e158 * _e178)), (_e151 - (_e161 * _e178)));
            let _e208 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e208 > 0f) {
                if (_e208 < 1f) {
                    phi_8611_ = _e208;
                } else {
                    phi_8611_ = 1f;
                }
                let _e212 = phi_8611_;
                phi_8612_ = _e212;
            } else {
                phi_8612_ = 0f;
            }
            let _e214 = phi_8612_;
            let _e250 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e250 > 0f) {
                if (_e250 < 1f) {
                    phi_8657_ = _e250;
                } else {
                    phi_8657_ = 1f;
                }
                let _e254 = phi_8657_;
                phi_8658_ = _e254;
            } else {
                phi_8658_ = 0f;
            }
            let _e256 = phi_8658_;
            phi_8673_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e214)), (param_3[1] - (param_4[1] * _e214)), (param_3[2] - (param_4[2] * _e214))), array<f32, 3>((param_3[0] - (param_5[0] * _e256)), (param_3[1] - (param_5[1] * _e256)), (param_3[2] - (param_5[2] * _e256))), _e185, _e185);
        }
        let _e438 = phi_8673_;
        let _e441 = function_1(_e438[0], _e438[1]);
        let _e443 = function_1(_e441, _e438[2]);
        let _e445 = function_1(_e443, _e438[3]);
        phi_8681_ = _e445;
    } else {
        phi_8681_ = _e140;
    }
    let _e447 = phi_8681_;
    return _e447;
}

fn function_3(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_31;
    var local_1: type_31;
    var local_2: type_26;
    var local_3: type_26;
    var local_4: type_26;
    var local_5: array<type_32, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: array<f32, 4>;
    var local_9: type_31;
    var local_10: type_31;
    var local_11: array<f32, 3>;
    var local_12: type_25;
    var phi_223_: u32;
    var phi_239_: u32;
    var phi_260_: u32;
    var phi_261_: u32;
    var phi_264_: type_9;
    var phi_265_: type_9;
    var phi_288_: type_9;
    var phi_463_: f32;
    var phi_469_: f32;
    var phi_474_: f32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_502_: f32;
    var phi_508_: f32;
    var phi_513_: f32;
    var phi_518_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_536_: f32;
    var phi_542_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_559_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_575_: f32;
    var phi_580_: f32;
    var phi_587_: f32;
    var phi_593_: f32;
    var phi_598_: f32;
    var phi_604_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_626_: f32;
    var phi_632_: f32;
    var phi_637_: f32;
    var phi_642_: f32;
    var phi_648_: f32;
    var phi_653_: f32;
    var phi_660_: bool;
    var phi_684_: u32;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_727_: type_35;
    var phi_728_: bool;
    var phi_729_: type_35;
    var phi_730_: bool;
    var phi_731_: type_35;
    var phi_732_: bool;
    var phi_737_: type_35;
    var phi_1019_: f32;
    var phi_1026_: f32;
    var phi_1031_: f32;
    var phi_1038_: f32;
    var phi_1043_: f32;
    var phi_1056_: f32;
    var phi_1063_: f32;
    var phi_1068_: f32;
    var phi_1075_: f32;
    var phi_1080_: f32;
    var phi_1085_: f32;
    var phi_1102_: f32;
    var phi_1109_: f32;
    var phi_1114_: f32;
    var phi_1121_: f32;
    var phi_1126_: f32;
    var phi_1140_: f32;
    var phi_1147_: f32;
    var phi_1152_: f32;
    var phi_1159_: f32;
    var phi_1164_: f32;
    var phi_1169_: f32;
    var phi_1186_: f32;
    var phi_1193_: f32;
    var phi_1198_: f32;
    var phi_1205_: f32;
    var phi_1210_: f32;
    var phi_1224_: f32;
    var phi_1231_: f32;
    var phi_1236_: f32;
    var phi_1243_: f32;
    var phi_1248_: f32;
    var phi_1253_: f32;
    var phi_1284_: f32;
    var phi_1290_: f32;
    var phi_1297_: f32;
    var phi_1304_: f32;
    var phi_1310_: f32;
    var phi_1317_: f32;
    var phi_1323_: f32;
    var phi_1329_: f32;
    var phi_1335_: f32;
    var phi_1342_: f32;
    var phi_1349_: f32;
    var phi_1373_: f32;
    var phi_1378_: f32;
    var phi_1383_: f32;
    var phi_1388_: f32;
    var phi_1393_: f32;
    var phi_1398_: f32;
    var phi_1408_: f32;
    var phi_4099_: f32;
    var phi_4105_: f32;
    var phi_4110_: f32;
    var phi_4116_: f32;
    var phi_4122_: f32;
    var phi_4127_: f32;
    var phi_4132_: f32;
    var phi_4140_: bool;
    var phi_4145_: f32;
    var phi_4152_: f32;
    var phi_4192_: type_14;
    var phi_4195_: f32;
    var phi_4216_: bool;
    var phi_4222_: type_15;
    var phi_4193_: type_14;
    var phi_4236_: type_15;
    var phi_4196_: f32;
    var local_13: f32;
    var phi_4185_: f32;
    var phi_4249_: f32;
    var phi_4255_: f32;
    var phi_4280_: type_9;
    var phi_4283_: u32;
    var phi_4281_: type_9;
    var phi_4306_: type_9;
    var phi_4350_: u32;
    var phi_4351_: u32;
    var phi_4284_: u32;
    var phi_4352_: u32;
    var phi_4372_: type_9;
    var phi_4373_: type_9;
    var phi_4396_: type_9;
    var phi_4448_: f32;
    var phi_4455_: f32;
    var phi_4466_: bool;
    var phi_4467_: bool;
    var phi_4468_: bool;
    var phi_4469_: bool;
    var phi_4473_: bool;
    var phi_4484_: type_37;
    var phi_4485_: type_37;
    var phi_4486_: bool;
    var phi_4487_: type_37;
    var phi_4488_: bool;
    var phi_4499_: f32;
    var phi_4509_: type_9;
    var phi_4512_: f32;
    var phi_4514_: f32;
    var phi_4516_: f32;
    var phi_4510_: type_9;
    var phi_4539_: type_9;
    var phi_4564_: f32;
    var phi_4565_: f32;
    var phi_4591_: f32;
    var phi_4607_: f32;
    var phi_4614_: bool;
    var phi_4615_: bool;
    var phi_4616_: bool;
    var phi_4622_: f32;
    var phi_4623_: f32;
    var phi_4624_: bool;
    var phi_4513_: f32;
    var phi_4515_: f32;
    var phi_4517_: f32;
    var phi_4625_: f32;
    var phi_4626_: bool;
    var phi_4627_: bool;
    var local_14: bool;
    var phi_4631_: f32;
    var phi_4632_: f32;
    var phi_4640_: f32;
    var phi_4644_: type_9;
    var phi_4647_: f32;
    var phi_4645_: type_9;
    var phi_4670_: type_9;
    var phi_4700_: f32;
    var phi_4701_: bool;
    var phi_4702_: f32;
    var phi_4703_: bool;
    var phi_4704_: bool;
    var phi_4705_: bool;
    var phi_4706_: f32;
    var phi_4648_: f32;
    var phi_4707_: bool;
    var phi_4708_: bool;
    var phi_4709_: bool;
    var phi_4710_: bool;
    var local_15: bool;
    var phi_4714_: bool;
    var phi_4715_: bool;
    var phi_4719_: bool;
    var phi_4723_: f32;
    var phi_4724_: f32;
    var phi_4726_: type_37;
    var phi_4755_: f32;
    var phi_4762_: f32;
    var phi_4767_: f32;
    var phi_4774_: f32;
    var phi_4779_: f32;
    var phi_4792_: f32;
    var phi_4799_: f32;
    var phi_4804_: f32;
    var phi_4811_: f32;
    var phi_4816_: f32;
    var phi_4821_: f32;
    var phi_4880_: f32;
    var phi_4886_: f32;
    var phi_4891_: f32;
    var phi_4897_: f32;
    var phi_4902_: f32;
    var phi_4914_: f32;
    var phi_4920_: f32;
    var phi_4925_: f32;
    var phi_4931_: f32;
    var phi_4936_: f32;
    var phi_4962_: f32;
    var phi_4969_: f32;
    var phi_4974_: f32;
    var phi_4981_: f32;
    var phi_4986_: f32;
    var phi_4999_: f32;
    var phi_5006_: f32;
    var phi_5011_: f32;
    var phi_5018_: f32;
    var phi_5023_: f32;
    var phi_5028_: f32;
    var phi_5087_: f32;
    var phi_5093_: f32;
    var phi_5098_: f32;
    var phi_5104_: f32;
    var phi_5109_: f32;
    var phi_5121_: f32;
    var phi_5127_: f32;
    var phi_5132_: f32;
    var phi_5138_: f32;
    var phi_5143_: f32;
    var phi_5169_: f32;
    var phi_5176_: f32;
    var phi_5181_: f32;
    var phi_5188_: f32;
    var phi_5193_: f32;
    var phi_5206_: f32;
    var phi_5213_: f32;
    var phi_5218_: f32;
    var phi_5225_: f32;
    var phi_5230_: f32;
    var phi_5235_: f32;
    var phi_5294_: f32;
    var phi_5300_: f32;
    var phi_5305_: f32;
    var phi_5311_: f32;
    var phi_5316_: f32;
    var phi_5328_: f32;
    var phi_5334_: f32;
    var phi_5339_: f32;
    var phi_5345_: f32;
    var phi_5350_: f32;
    var phi_5399_: f32;
    var phi_5405_: f32;
    var phi_5433_: f32;
    var phi_5439_: f32;
    var phi_5444_: u32;
    var phi_5445_: u32;
    var phi_5415_: f32;
    var phi_5421_: f32;
    var phi_5426_: u32;
    var phi_5427_: u32;
    var phi_5446_: u32;
    var phi_5447_: u32;
    var phi_5516_: f32;
    var phi_5525_: f32;
    var phi_5660_: f32;
    var phi_5666_: f32;
    var phi_5673_: f32;
    var phi_5728_: type_9;
    var phi_5731_: bool;
    var phi_5729_: type_9;
    var phi_5754_: type_9;
    var phi_5781_: bool;
    var phi_5782_: bool;
    var phi_5732_: bool;
    var phi_5783_: bool;
    var phi_5784_: bool;
    var local_16: bool;
    var phi_5788_: bool;
    var local_17: bool;
    var phi_5795_: u32;
    var phi_5796_: u32;
    var phi_5797_: bool;
    var phi_5798_: u32;
    var phi_5799_: u32;
    var phi_5800_: bool;
    var phi_5804_: u32;
    var phi_5824_: bool;
    var phi_5825_: bool;
    var phi_5826_: bool;
    var phi_5974_: f32;
    var phi_5981_: f32;
    var phi_5986_: f32;
    var phi_5993_: f32;
    var phi_5998_: f32;
    var phi_6011_: f32;
    var phi_6018_: f32;
    var phi_6023_: f32;
    var phi_6030_: f32;
    var phi_6035_: f32;
    var phi_6040_: f32;
    var phi_6057_: f32;
    var phi_6064_: f32;
    var phi_6069_: f32;
    var phi_6076_: f32;
    var phi_6081_: f32;
    var phi_6095_: f32;
    var phi_6102_: f32;
    var phi_6107_: f32;
    var phi_6114_: f32;
    var phi_6119_: f32;
    var phi_6124_: f32;
    var phi_6141_: f32;
    var phi_6148_: f32;
    var phi_6153_: f32;
    var phi_6160_: f32;
    var phi_6165_: f32;
    var phi_6179_: f32;
    var phi_6186_: f32;
    var phi_6191_: f32;
    var phi_6198_: f32;
    var phi_6203_: f32;
    var phi_6208_: f32;
    var phi_6247_: type_9;
    var phi_6250_: f32;
    var phi_6252_: f32;
    var phi_6254_: f32;
    var phi_6256_: bool;
    var phi_6258_: u32;
    var phi_6248_: type_9;
    var phi_6281_: type_9;
    var phi_6395_: f32;
    var phi_6401_: f32;
    var phi_6407_: f32;
    var phi_6409_: array<f32, 3>;
    var phi_6416_: f32;
    var phi_6423_: f32;
    var phi_6431_: f32;
    var phi_6475_: type_14;
    var phi_6478_: f32;
    var phi_6499_: bool;
    var phi_6505_: type_15;
    var phi_6476_: type_14;
    var phi_6519_: type_15;
    var phi_6479_: f32;
    var local_18: f32;
    var phi_6468_: f32;
    var phi_6532_: f32;
    var phi_6598_: f32;
    var phi_6604_: f32;
    var phi_6613_: f32;
    var phi_6619_: f32;
    var phi_6628_: f32;
    var phi_6634_: f32;
    var phi_6643_: f32;
    var phi_6649_: f32;
    var phi_6655_: type_31;
    var phi_6656_: bool;
    var phi_6657_: type_31;
    var phi_6658_: bool;
    var phi_6666_: type_31;
    var phi_6837_: bool;
    var phi_6838_: bool;
    var phi_6839_: bool;
    var phi_6840_: bool;
    var phi_6841_: bool;
    var phi_6842_: bool;
    var phi_6846_: bool;
    var phi_7143_: bool;
    var phi_7144_: bool;
    var phi_7145_: bool;
    var phi_7146_: bool;
    var phi_7147_: bool;
    var phi_7148_: bool;
    var phi_7152_: bool;
    var phi_7156_: bool;
    var phi_7167_: bool;
    var phi_7168_: bool;
    var phi_7242_: bool;
    var phi_7243_: bool;
    var phi_7263_: f32;
    var phi_7264_: bool;
    var phi_7265_: f32;
    var phi_7266_: bool;
    var phi_7267_: f32;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7273_: f32;
    var phi_7274_: bool;
    var phi_7278_: f32;
    var phi_7310_: bool;
    var phi_7311_: bool;
    var phi_7331_: f32;
    var phi_7332_: bool;
    var phi_7333_: f32;
    var phi_7334_: bool;
    var phi_7335_: f32;
    var phi_7336_: bool;
    var phi_7337_: bool;
    var phi_7341_: f32;
    var phi_7342_: bool;
    var phi_7346_: f32;
    var phi_7351_: f32;
    var phi_7383_: bool;
    var phi_7384_: bool;
    var phi_7404_: f32;
    var phi_7405_: bool;
    var phi_7406_: f32;
    var phi_7407_: bool;
    var phi_7408_: f32;
    var phi_7409_: bool;
    var phi_7410_: bool;
    var phi_7414_: f32;
    var phi_7415_: bool;
    var phi_7419_: f32;
    var phi_7451_: bool;
    var phi_7452_: bool;
    var phi_7472_: f32;
    var phi_7473_: bool;
    var phi_7474_: f32;
    var phi_7475_: bool;
    var phi_7476_: f32;
    var phi_7477_: bool;
    var phi_7478_: bool;
    var phi_7482_: f32;
    var phi_7483_: bool;
    var phi_7487_: f32;
    var phi_7492_: f32;
    var phi_7497_: f32;
    var phi_7502_: f32;
    var phi_7512_: f32;
    var phi_7513_: f32;
    var phi_7514_: bool;
    var phi_7515_: f32;
    var phi_7516_: f32;
    var phi_7517_: bool;
    var phi_7518_: bool;
    var phi_7519_: bool;
    var phi_7520_: f32;
    var phi_7521_: f32;
    var phi_7522_: bool;
    var phi_7523_: bool;
    var phi_7524_: bool;
    var phi_7525_: bool;
    var phi_7526_: f32;
    var phi_7527_: f32;
    var phi_7528_: bool;
    var phi_7529_: bool;
    var phi_7530_: bool;
    var phi_7531_: bool;
    var phi_7617_: f32;
    var phi_7690_: f32;
    var phi_7695_: f32;
    var phi_7768_: f32;
    var phi_7841_: f32;
    var phi_7846_: f32;
    var phi_7862_: f32;
    var phi_7863_: f32;
    var phi_7864_: f32;
    var phi_7544_: bool;
    var phi_7866_: u32;
    var phi_7867_: f32;
    var phi_7868_: bool;
    var phi_7869_: bool;
    var phi_7870_: bool;
    var phi_7871_: u32;
    var phi_7872_: f32;
    var phi_7873_: f32;
    var phi_7874_: f32;
    var phi_7875_: bool;
    var phi_7876_: u32;
    var phi_7877_: bool;
    var phi_7878_: bool;
    var phi_7879_: bool;
    var phi_7880_: bool;
    var phi_7881_: bool;
    var phi_7890_: f32;
    var phi_7895_: f32;
    var phi_7904_: bool;
    var phi_7908_: bool;
    var phi_7909_: f32;
    var phi_7910_: f32;
    var phi_7911_: f32;
    var phi_7912_: bool;
    var phi_7913_: u32;
    var phi_7914_: bool;
    var phi_7915_: bool;
    var phi_7916_: bool;
    var phi_7917_: bool;
    var phi_7918_: bool;
    var phi_6251_: f32;
    var phi_6253_: f32;
    var phi_6255_: f32;
    var phi_6257_: bool;
    var phi_6259_: u32;
    var phi_7919_: f32;
    var phi_7920_: bool;
    var phi_7921_: bool;
    var phi_7922_: bool;
    var phi_7923_: bool;
    var phi_7924_: bool;
    var phi_7925_: bool;
    var local_19: bool;
    var phi_7929_: f32;
    var phi_7930_: bool;
    var phi_7931_: bool;
    var phi_7932_: bool;
    var phi_7933_: bool;
    var phi_7938_: type_30;
    var phi_7939_: bool;
    var phi_7940_: bool;
    var phi_7941_: bool;
    var local_20: f32;
    var phi_7946_: type_30;
    var phi_7947_: bool;
    var phi_7948_: bool;
    var phi_7953_: type_30;
    var phi_7954_: bool;
    var phi_7955_: bool;
    var phi_7960_: type_30;
    var phi_7961_: bool;
    var phi_7965_: type_30;
    var phi_7972_: bool;
    var phi_7973_: f32;
    var phi_7974_: bool;
    var phi_7975_: bool;
    var phi_7976_: bool;
    var phi_7977_: f32;
    var phi_7978_: bool;
    var phi_7979_: bool;
    var phi_7980_: bool;
    var phi_7981_: f32;
    var phi_7982_: bool;
    var phi_7983_: bool;
    var phi_7984_: bool;
    var phi_7985_: bool;
    var phi_7989_: bool;
    var phi_7990_: bool;
    var phi_7991_: bool;
    var phi_7992_: f32;
    var phi_7993_: type_37;
    var phi_7994_: bool;
    var phi_7995_: bool;
    var phi_7996_: bool;
    var phi_7997_: bool;
    var local_21: bool;
    var phi_8002_: type_30;
    var phi_8003_: bool;
    var phi_8004_: bool;
    var local_22: f32;
    var phi_8009_: type_30;
    var phi_8010_: bool;
    var local_23: type_37;
    var phi_8016_: type_30;
    var phi_8017_: bool;
    var phi_8021_: type_30;
    var phi_1561_: f32;
    var phi_1568_: f32;
    var phi_1573_: f32;
    var phi_1580_: f32;
    var phi_1585_: f32;
    var phi_1598_: f32;
    var phi_1605_: f32;
    var phi_1610_: f32;
    var phi_1617_: f32;
    var phi_1622_: f32;
    var phi_1627_: f32;
    var phi_1644_: f32;
    var phi_1651_: f32;
    var phi_1656_: f32;
    var phi_1663_: f32;
    var phi_1668_: f32;
    var phi_1682_: f32;
    var phi_1689_: f32;
    var phi_1694_: f32;
    var phi_1701_: f32;
    var phi_1706_: f32;
    var phi_1711_: f32;
    var phi_1728_: f32;
    var phi_1735_: f32;
    var phi_1740_: f32;
    var phi_1747_: f32;
    var phi_1752_: f32;
    var phi_1766_: f32;
    var phi_1773_: f32;
    var phi_1778_: f32;
    var phi_1785_: f32;
    var phi_1790_: f32;
    var phi_1795_: f32;
    var phi_1834_: type_9;
    var phi_1837_: f32;
    var phi_1839_: f32;
    var phi_1841_: f32;
    var phi_1843_: bool;
    var phi_1845_: u32;
    var phi_1835_: type_9;
    var phi_1868_: type_9;
    var phi_1982_: f32;
    var phi_1988_: f32;
    var phi_1994_: f32;
    var phi_1996_: array<f32, 3>;
    var phi_2003_: f32;
    var phi_2010_: f32;
    var phi_2018_: f32;
    var phi_2062_: type_14;
    var phi_2065_: f32;
    var phi_2086_: bool;
    var phi_2092_: type_15;
    var phi_2063_: type_14;
    var phi_2106_: type_15;
    var phi_2066_: f32;
    var local_24: f32;
    var phi_2055_: f32;
    var phi_2119_: f32;
    var phi_2185_: f32;
    var phi_2191_: f32;
    var phi_2200_: f32;
    var phi_2206_: f32;
    var phi_2215_: f32;
    var phi_2221_: f32;
    var phi_2230_: f32;
    var phi_2236_: f32;
    var phi_2242_: type_31;
    var phi_2243_: bool;
    var phi_2244_: type_31;
    var phi_2245_: bool;
    var phi_2253_: type_31;
    var phi_2424_: bool;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2433_: bool;
    var phi_2730_: bool;
    var phi_2731_: bool;
    var phi_2732_: bool;
    var phi_2733_: bool;
    var phi_2734_: bool;
    var phi_2735_: bool;
    var phi_2739_: bool;
    var phi_2743_: bool;
    var phi_2754_: bool;
    var phi_2755_: bool;
    var phi_2829_: bool;
    var phi_2830_: bool;
    var phi_2850_: f32;
    var phi_2851_: bool;
    var phi_2852_: f32;
    var phi_2853_: bool;
    var phi_2854_: f32;
    var phi_2855_: bool;
    var phi_2856_: bool;
    var phi_2860_: f32;
    var phi_2861_: bool;
    var phi_2865_: f32;
    var phi_2897_: bool;
    var phi_2898_: bool;
    var phi_2918_: f32;
    var phi_2919_: bool;
    var phi_2920_: f32;
    var phi_2921_: bool;
    var phi_2922_: f32;
    var phi_2923_: bool;
    var phi_2924_: bool;
    var phi_2928_: f32;
    var phi_2929_: bool;
    var phi_2933_: f32;
    var phi_2938_: f32;
    var phi_2970_: bool;
    var phi_2971_: bool;
    var phi_2991_: f32;
    var phi_2992_: bool;
    var phi_2993_: f32;
    var phi_2994_: bool;
    var phi_2995_: f32;
    var phi_2996_: bool;
    var phi_2997_: bool;
    var phi_3001_: f32;
    var phi_3002_: bool;
    var phi_3006_: f32;
    var phi_3038_: bool;
    var phi_3039_: bool;
    var phi_3059_: f32;
    var phi_3060_: bool;
    var phi_3061_: f32;
    var phi_3062_: bool;
    var phi_3063_: f32;
    var phi_3064_: bool;
    var phi_3065_: bool;
    var phi_3069_: f32;
    var phi_3070_: bool;
    var phi_3074_: f32;
    var phi_3079_: f32;
    var phi_3084_: f32;
    var phi_3089_: f32;
    var phi_3099_: f32;
    var phi_3100_: f32;
    var phi_3101_: bool;
    var phi_3102_: f32;
    var phi_3103_: f32;
    var phi_3104_: bool;
    var phi_3105_: bool;
    var phi_3106_: bool;
    var phi_3107_: f32;
    var phi_3108_: f32;
    var phi_3109_: bool;
    var phi_3110_: bool;
    var phi_3111_: bool;
    var phi_3112_: bool;
    var phi_3113_: f32;
    var phi_3114_: f32;
    var phi_3115_: bool;
    var phi_3116_: bool;
    var phi_3117_: bool;
    var phi_3118_: bool;
    var phi_3204_: f32;
    var phi_3277_: f32;
    var phi_3282_: f32;
    var phi_3355_: f32;
    var phi_3428_: f32;
    var phi_3433_: f32;
    var phi_3449_: f32;
    var phi_3450_: f32;
    var phi_3451_: f32;
    var phi_3131_: bool;
    var phi_3453_: u32;
    var phi_3454_: f32;
    var phi_3455_: bool;
    var phi_3456_: bool;
    var phi_3457_: bool;
    var phi_3458_: u32;
    var phi_3459_: f32;
    var phi_3460_: f32;
    var phi_3461_: f32;
    var phi_3462_: bool;
    var phi_3463_: u32;
    var phi_3464_: bool;
    var phi_3465_: bool;
    var phi_3466_: bool;
    var phi_3467_: bool;
    var phi_3468_: bool;
    var phi_3477_: f32;
    var phi_3482_: f32;
    var phi_3491_: bool;
    var phi_3495_: bool;
    var phi_3496_: f32;
    var phi_3497_: f32;
    var phi_3498_: f32;
    var phi_3499_: bool;
    var phi_3500_: u32;
    var phi_3501_: bool;
    var phi_3502_: bool;
    var phi_3503_: bool;
    var phi_3504_: bool;
    var phi_3505_: bool;
    var phi_1838_: f32;
    var phi_1840_: f32;
    var phi_1842_: f32;
    var phi_1844_: bool;
    var phi_1846_: u32;
    var phi_3506_: f32;
    var phi_3507_: bool;
    var phi_3508_: bool;
    var phi_3509_: bool;
    var phi_3510_: bool;
    var phi_3511_: bool;
    var phi_3512_: bool;
    var local_25: bool;
    var phi_3516_: f32;
    var phi_3517_: bool;
    var phi_3518_: bool;
    var phi_3519_: bool;
    var phi_3520_: bool;
    var phi_3525_: type_30;
    var phi_3526_: bool;
    var phi_3527_: bool;
    var phi_3528_: bool;
    var local_26: f32;
    var phi_3533_: type_30;
    var phi_3534_: bool;
    var phi_3535_: bool;
    var phi_3540_: type_30;
    var phi_3541_: bool;
    var phi_3542_: bool;
    var phi_3547_: type_30;
    var phi_3548_: bool;
    var phi_3552_: type_30;
    var phi_3566_: type_9;
    var phi_3567_: type_9;
    var phi_3590_: type_9;
    var phi_3610_: f32;
    var phi_3740_: type_14;
    var phi_3743_: f32;
    var phi_3764_: bool;
    var phi_3770_: type_15;
    var phi_3741_: type_14;
    var phi_3784_: type_15;
    var phi_3744_: f32;
    var local_27: f32;
    var phi_3733_: f32;
    var phi_3797_: f32;
    var phi_3813_: f32;
    var phi_3820_: f32;
    var phi_3825_: f32;
    var phi_3832_: f32;
    var phi_3837_: f32;
    var phi_3850_: f32;
    var phi_3857_: f32;
    var phi_3862_: f32;
    var phi_3869_: f32;
    var phi_3874_: f32;
    var phi_3879_: f32;
    var phi_3896_: f32;
    var phi_3903_: f32;
    var phi_3908_: f32;
    var phi_3915_: f32;
    var phi_3920_: f32;
    var phi_3934_: f32;
    var phi_3941_: f32;
    var phi_3946_: f32;
    var phi_3953_: f32;
    var phi_3958_: f32;
    var phi_3963_: f32;
    var phi_3980_: f32;
    var phi_3987_: f32;
    var phi_3992_: f32;
    var phi_3999_: f32;
    var phi_4004_: f32;
    var phi_4018_: f32;
    var phi_4025_: f32;
    var phi_4030_: f32;
    var phi_4037_: f32;
    var phi_4042_: f32;
    var phi_4047_: f32;
    var phi_4067_: bool;
    var phi_4068_: bool;
    var phi_4069_: bool;
    var local_28: bool;
    var phi_4074_: type_30;
    var phi_4075_: bool;
    var phi_4080_: type_30;
    var phi_4081_: bool;
    var phi_4083_: type_30;
    var phi_4084_: type_30;
    var phi_4085_: bool;
    var phi_4089_: type_30;
    var phi_8025_: type_30;
    var phi_8026_: type_30;
    var phi_8039_: type_38;
    var phi_8046_: bool;
    var phi_8070_: u32;
    var phi_8074_: type_20;
    var phi_8075_: bool;
    var phi_8076_: bool;
    var phi_8095_: u32;
    var phi_8158_: u32;
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
        phi_223_ = _e123;
    } else {
        phi_223_ = _e125;
    }
    let _e128 = phi_223_;
    let _e129 = (_e128 / 64u);
    if ((_e128 % 64u) > 0u) {
        phi_239_ = (_e129 + 1u);
    } else {
        phi_239_ = _e129;
    }
    let _e134 = phi_239_;
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
            phi_260_ = (_e138 + 1u);
        } else {
            phi_260_ = _e138;
        }
        let _e144 = phi_260_;
        phi_261_ = _e144;
    } else {
        phi_261_ = 0u;
    }
    let _e146 = phi_261_;
    phi_264_ = type_9(0u, _e146);
    loop {
        let _e149 = phi_264_;
        if (_e149.member < _e149.member_1) {
            phi_265_ = type_9((_e149.member + 1u), _e149.member_1);
            phi_288_ = type_9(1u, _e149.member);
        } else {
            phi_265_ = _e149;
            phi_288_ = type_9(0u, type_9().member_1);
        }
        let _e161 = phi_265_;
        let _e163 = phi_288_;
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
                    phi_463_ = -(_e231);
                } else {
                    phi_463_ = _e231;
                }
                let _e265 = phi_463_;
                if (_e232 < 0f) {
                    phi_469_ = -(_e232);
                } else {
                    phi_469_ = _e232;
                }
                let _e269 = phi_469_;
                if (_e265 > _e269) {
                    phi_474_ = _e265;
                } else {
                    phi_474_ = _e269;
                }
                let _e272 = phi_474_;
                if (_e233 < 0f) {
                    phi_480_ = -(_e233);
                } else {
                    phi_480_ = _e233;
                }
                let _e276 = phi_480_;
                if (_e272 > _e276) {
                    phi_485_ = _e272;
                } else {
                    phi_485_ = _e276;
                }
                let _e279 = phi_485_;
                if (_e235 < 0f) {
                    phi_491_ = -(_e235);
                } else {
                    phi_491_ = _e235;
                }
                let _e283 = phi_491_;
                if (_e236 < 0f) {
                    phi_497_ = -(_e236);
                } else {
                    phi_497_ = _e236;
                }
                let _e287 = phi_497_;
                if (_e283 > _e287) {
                    phi_502_ = _e283;
                } else {
                    phi_502_ = _e287;
                }
                let _e290 = phi_502_;
                if (_e237 < 0f) {
                    phi_508_ = -(_e237);
                } else {
                    phi_508_ = _e237;
                }
                let _e294 = phi_508_;
                if (_e290 > _e294) {
                    phi_513_ = _e290;
                } else {
                    phi_513_ = _e294;
                }
                let _e297 = phi_513_;
                if (_e279 > _e297) {
                    phi_518_ = _e279;
                } else {
                    phi_518_ = _e297;
                }
                let _e300 = phi_518_;
                let _e301 = (_e300 + _e258);
                if (_e240 < 0f) {
                    phi_525_ = -(_e240);
                } else {
                    phi_525_ = _e240;
                }
                let _e305 = phi_525_;
                if (_e241 < 0f) {
                    phi_531_ = -(_e241);
                } else {
                    phi_531_ = _e241;
                }
                let _e309 = phi_531_;
                if (_e305 > _e309) {
                    phi_536_ = _e305;
                } else {
                    phi_536_ = _e309;
                }
                let _e312 = phi_536_;
                if (_e242 < 0f) {
                    phi_542_ = -(_e242);
                } else {
                    phi_542_ = _e242;
                }
                let _e316 = phi_542_;
                if (_e312 > _e316) {
                    phi_547_ = _e312;
                } else {
                    phi_547_ = _e316;
                }
                let _e319 = phi_547_;
                if (_e244 < 0f) {
                    phi_553_ = -(_e244);
                } else {
                    phi_553_ = _e244;
                }
                let _e323 = phi_553_;
                if (_e245 < 0f) {
                    phi_559_ = -(_e245);
                } else {
                    phi_559_ = _e245;
                }
                let _e327 = phi_559_;
                if (_e323 > _e327) {
                    phi_564_ = _e323;
                } else {
                    phi_564_ = _e327;
                }
                let _e330 = phi_564_;
                if (_e246 < 0f) {
                    phi_570_ = -(_e246);
                } else {
                    phi_570_ = _e246;
                }
                let _e334 = phi_570_;
                if (_e330 > _e334) {
                    phi_575_ = _e330;
                } else {
                    phi_575_ = _e334;
                }
                let _e337 = phi_575_;
                if (_e319 > _e337) {
                    phi_580_ = _e319;
                } else {
                    phi_580_ = _e337;
                }
                let _e340 = phi_580_;
                let _e341 = (_e340 + _e258);
                if (_e249 < 0f) {
                    phi_587_ = -(_e249);
                } else {
                    phi_587_ = _e249;
                }
                let _e345 = phi_587_;
                if (_e250 < 0f) {
                    phi_593_ = -(_e250);
                } else {
                    phi_593_ = _e250;
                }
                let _e349 = phi_593_;
                if (_e345 > _e349) {
                    phi_598_ = _e345;
                } else {
                    phi_598_ = _e349;
                }
                let _e352 = phi_598_;
                if (_e251 < 0f) {
                    phi_604_ = -(_e251);
                } else {
                    phi_604_ = _e251;
                }
                let _e356 = phi_604_;
                if (_e352 > _e356) {
                    phi_609_ = _e352;
                } else {
                    phi_609_ = _e356;
                }
                let _e359 = phi_609_;
                if (_e253 < 0f) {
                    phi_615_ = -(_e253);
                } else {
                    phi_615_ = _e253;
                }
                let _e363 = phi_615_;
                if (_e254 < 0f) {
                    phi_621_ = -(_e254);
                } else {
                    phi_621_ = _e254;
                }
                let _e367 = phi_621_;
                if (_e363 > _e367) {
                    phi_626_ = _e363;
                } else {
                    phi_626_ = _e367;
                }
                let _e370 = phi_626_;
                if (_e255 < 0f) {
                    phi_632_ = -(_e255);
                } else {
                    phi_632_ = _e255;
                }
                let _e374 = phi_632_;
                if (_e370 > _e374) {
                    phi_637_ = _e370;
                } else {
                    phi_637_ = _e374;
                }
                let _e377 = phi_637_;
                if (_e359 > _e377) {
                    phi_642_ = _e359;
                } else {
                    phi_642_ = _e377;
                }
                let _e380 = phi_642_;
                let _e381 = (_e380 + _e258);
                if (_e301 > _e341) {
                    phi_648_ = _e301;
                } else {
                    phi_648_ = _e341;
                }
                let _e384 = phi_648_;
                if (_e384 > _e381) {
                    phi_653_ = _e384;
                } else {
                    phi_653_ = _e381;
                }
                let _e387 = phi_653_;
                if (_e387 <= 65536f) {
                    phi_660_ = (_e387 >= (1f / 65536f));
                } else {
                    phi_660_ = false;
                }
                let _e392 = phi_660_;
                if _e392 {
                    phi_731_ = type_35();
                    phi_732_ = true;
                } else {
                    if (_e387 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e387) & 2139095040u) != 2139095040u) {
                            let _e399 = (2130706432u - (bitcast<u32>(_e387) & 2139095040u));
                            if (_e399 > 8388608u) {
                                phi_684_ = _e399;
                            } else {
                                phi_684_ = 8388608u;
                            }
                            let _e402 = phi_684_;
                            let _e403 = bitcast<f32>(_e402);
                            let _e404 = (_e261 * _e403);
                            if (_e261 > 0f) {
                                if (_e404 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_695_ = _e404;
                                } else {
                                    phi_695_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e408 = phi_695_;
                                phi_696_ = _e408;
                            } else {
                                phi_696_ = _e404;
                            }
                            let _e410 = phi_696_;
                            phi_727_ = type_35(type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e231 * _e403), (_e232 * _e403), (_e233 * _e403)), array<f32, 3>((_e235 * _e403), (_e236 * _e403), (_e237 * _e403))), array<array<f32, 3>, 2>(array<f32, 3>((_e240 * _e403), (_e241 * _e403), (_e242 * _e403)), array<f32, 3>((_e244 * _e403), (_e245 * _e403), (_e246 * _e403))), array<array<f32, 3>, 2>(array<f32, 3>((_e249 * _e403), (_e250 * _e403), (_e251 * _e403)), array<f32, 3>((_e253 * _e403), (_e254 * _e403), (_e255 * _e403))), (_e258 * _e403)), _e410);
                            phi_728_ = false;
                        } else {
                            phi_727_ = type_35();
                            phi_728_ = true;
                        }
                        let _e442 = phi_727_;
                        let _e444 = phi_728_;
                        phi_729_ = _e442;
                        phi_730_ = _e444;
                    } else {
                        phi_729_ = type_35();
                        phi_730_ = true;
                    }
                    let _e446 = phi_729_;
                    let _e448 = phi_730_;
                    phi_731_ = _e446;
                    phi_732_ = _e448;
                }
                let _e450 = phi_731_;
                let _e452 = phi_732_;
                if _e452 {
                    phi_737_ = type_35(type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e231, _e232, _e233), array<f32, 3>(_e235, _e236, _e237)), array<array<f32, 3>, 2>(array<f32, 3>(_e240, _e241, _e242), array<f32, 3>(_e244, _e245, _e246)), array<array<f32, 3>, 2>(array<f32, 3>(_e249, _e250, _e251), array<f32, 3>(_e253, _e254, _e255)), _e258), _e261);
                } else {
                    phi_737_ = _e450;
                }
                let _e455 = phi_737_;
                local_12 = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e455.member.member[0][0], _e455.member.member[0][1], _e455.member.member[0][2]), array<f32, 3>(_e455.member.member[1][0], _e455.member.member[1][1], _e455.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e455.member.member_1[0][0], _e455.member.member_1[0][1], _e455.member.member_1[0][2]), array<f32, 3>(_e455.member.member_1[1][0], _e455.member.member_1[1][1], _e455.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e455.member.member_2[0][0], _e455.member.member_2[0][1], _e455.member.member_2[0][2]), array<f32, 3>(_e455.member.member_2[1][0], _e455.member.member_2[1][1], _e455.member.member_2[1][2])), _e455.member.member_3);
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
                    phi_1019_ = -(_e653[0]);
                } else {
                    phi_1019_ = _e653[0];
                }
                let _e660 = phi_1019_;
                if (_e653[1] < 0f) {
                    phi_1026_ = -(_e653[1]);
                } else {
                    phi_1026_ = _e653[1];
                }
                let _e664 = phi_1026_;
                if (_e660 > _e664) {
                    phi_1031_ = _e660;
                } else {
                    phi_1031_ = _e664;
                }
                let _e667 = phi_1031_;
                if (_e653[2] < 0f) {
                    phi_1038_ = -(_e653[2]);
                } else {
                    phi_1038_ = _e653[2];
                }
                let _e671 = phi_1038_;
                if (_e667 > _e671) {
                    phi_1043_ = _e667;
                } else {
                    phi_1043_ = _e671;
                }
                let _e674 = phi_1043_;
                let _e677 = local_12.member[1u];
                if (_e677[0] < 0f) {
                    phi_1056_ = -(_e677[0]);
                } else {
                    phi_1056_ = _e677[0];
                }
                let _e684 = phi_1056_;
                if (_e677[1] < 0f) {
                    phi_1063_ = -(_e677[1]);
                } else {
                    phi_1063_ = _e677[1];
                }
                let _e688 = phi_1063_;
                if (_e684 > _e688) {
                    phi_1068_ = _e684;
                } else {
                    phi_1068_ = _e688;
                }
                let _e691 = phi_1068_;
                if (_e677[2] < 0f) {
                    phi_1075_ = -(_e677[2]);
                } else {
                    phi_1075_ = _e677[2];
                }
                let _e695 = phi_1075_;
                if (_e691 > _e695) {
                    phi_1080_ = _e691;
                } else {
                    phi_1080_ = _e695;
                }
                let _e698 = phi_1080_;
                if (_e674 > _e698) {
                    phi_1085_ = _e674;
                } else {
                    phi_1085_ = _e698;
                }
                let _e701 = phi_1085_;
                let _e703 = local_12.member_3;
                let _e704 = (_e701 + _e703);
                let _e707 = local_12.member_1[0u];
                if (_e707[0] < 0f) {
                    phi_1102_ = -(_e707[0]);
                } else {
                    phi_1102_ = _e707[0];
                }
                let _e714 = phi_1102_;
                if (_e707[1] < 0f) {
                    phi_1109_ = -(_e707[1]);
                } else {
                    phi_1109_ = _e707[1];
                }
                let _e718 = phi_1109_;
                if (_e714 > _e718) {
                    phi_1114_ = _e714;
                } else {
                    phi_1114_ = _e718;
                }
                let _e721 = phi_1114_;
                if (_e707[2] < 0f) {
                    phi_1121_ = -(_e707[2]);
                } else {
                    phi_1121_ = _e707[2];
                }
                let _e725 = phi_1121_;
                if (_e721 > _e725) {
                    phi_1126_ = _e721;
                } else {
                    phi_1126_ = _e725;
                }
                let _e728 = phi_1126_;
                let _e731 = local_12.member_1[1u];
                if (_e731[0] < 0f) {
                    phi_1140_ = -(_e731[0]);
                } else {
                    phi_1140_ = _e731[0];
                }
                let _e738 = phi_1140_;
                if (_e731[1] < 0f) {
                    phi_1147_ = -(_e731[1]);
                } else {
                    phi_1147_ = _e731[1];
                }
                let _e742 = phi_1147_;
                if (_e738 > _e742) {
                    phi_1152_ = _e738;
                } else {
                    phi_1152_ = _e742;
                }
                let _e745 = phi_1152_;
                if (_e731[2] < 0f) {
                    phi_1159_ = -(_e731[2]);
                } else {
                    phi_1159_ = _e731[2];
                }
                let _e749 = phi_1159_;
                if (_e745 > _e749) {
                    phi_1164_ = _e745;
                } else {
                    phi_1164_ = _e749;
                }
                let _e752 = phi_1164_;
                if (_e728 > _e752) {
                    phi_1169_ = _e728;
                } else {
                    phi_1169_ = _e752;
                }
                let _e755 = phi_1169_;
                let _e757 = local_12.member_3;
                let _e758 = (_e755 + _e757);
                let _e761 = local_12.member_2[0u];
                if (_e761[0] < 0f) {
                    phi_1186_ = -(_e761[0]);
                } else {
                    phi_1186_ = _e761[0];
                }
                let _e768 = phi_1186_;
                if (_e761[1] < 0f) {
                    phi_1193_ = -(_e761[1]);
                } else {
                    phi_1193_ = _e761[1];
                }
                let _e772 = phi_1193_;
                if (_e768 > _e772) {
                    phi_1198_ = _e768;
                } else {
                    phi_1198_ = _e772;
                }
                let _e775 = phi_1198_;
                if (_e761[2] < 0f) {
                    phi_1205_ = -(_e761[2]);
                } else {
                    phi_1205_ = _e761[2];
                }
                let _e779 = phi_1205_;
                if (_e775 > _e779) {
                    phi_1210_ = _e775;
                } else {
                    phi_1210_ = _e779;
                }
                let _e782 = phi_1210_;
                let _e785 = local_12.member_2[1u];
                if (_e785[0] < 0f) {
                    phi_1224_ = -(_e785[0]);
                } else {
                    phi_1224_ = _e785[0];
                }
                let _e792 = phi_1224_;
                if (_e785[1] < 0f) {
                    phi_1231_ = -(_e785[1]);
                } else {
                    phi_1231_ = _e785[1];
                }
                let _e796 = phi_1231_;
                if (_e792 > _e796) {
                    phi_1236_ = _e792;
                } else {
                    phi_1236_ = _e796;
                }
                let _e799 = phi_1236_;
                if (_e785[2] < 0f) {
                    phi_1243_ = -(_e785[2]);
                } else {
                    phi_1243_ = _e785[2];
                }
                let _e803 = phi_1243_;
                if (_e799 > _e803) {
                    phi_1248_ = _e799;
                } else {
                    phi_1248_ = _e803;
                }
                let _e806 = phi_1248_;
                if (_e782 > _e806) {
                    phi_1253_ = _e782;
                } else {
                    phi_1253_ = _e806;
                }
                let _e809 = phi_1253_;
                let _e811 = local_12.member_3;
                let _e812 = (_e809 + _e811);
                let _e814 = ((_e758 * 8f) * _e812);
                let _e821 = local_12.member_3;
                if (_e510 < 0f) {
                    phi_1284_ = -(_e510);
                } else {
                    phi_1284_ = _e510;
                }
                let _e838 = phi_1284_;
                if (_e513 < 0f) {
                    phi_1290_ = -(_e513);
                } else {
                    phi_1290_ = _e513;
                }
                let _e842 = phi_1290_;
                if (_e516 < 0f) {
                    phi_1297_ = -(_e516);
                } else {
                    phi_1297_ = _e516;
                }
                let _e847 = phi_1297_;
                let _e848 = ((_e838 + _e842) + _e847);
                if (_e531 < 0f) {
                    phi_1304_ = -(_e531);
                } else {
                    phi_1304_ = _e531;
                }
                let _e852 = phi_1304_;
                if (_e534 < 0f) {
                    phi_1310_ = -(_e534);
                } else {
                    phi_1310_ = _e534;
                }
                let _e856 = phi_1310_;
                if (_e537 < 0f) {
                    phi_1317_ = -(_e537);
                } else {
                    phi_1317_ = _e537;
                }
                let _e861 = phi_1317_;
                let _e862 = ((_e852 + _e856) + _e861);
                if (_e848 > _e862) {
                    phi_1323_ = _e848;
                } else {
                    phi_1323_ = _e862;
                }
                let _e865 = phi_1323_;
                if (_e580 < 0f) {
                    phi_1329_ = -(_e580);
                } else {
                    phi_1329_ = _e580;
                }
                let _e869 = phi_1329_;
                if (_e581 < 0f) {
                    phi_1335_ = -(_e581);
                } else {
                    phi_1335_ = _e581;
                }
                let _e873 = phi_1335_;
                if (_e582 < 0f) {
                    phi_1342_ = -(_e582);
                } else {
                    phi_1342_ = _e582;
                }
                let _e878 = phi_1342_;
                let _e880 = (((_e869 + _e873) + _e878) * 0.5f);
                if (_e865 > _e880) {
                    phi_1349_ = _e865;
                } else {
                    phi_1349_ = _e880;
                }
                let _e883 = phi_1349_;
                let _e888 = local_12.member_3;
                let _e900 = (((((_e704 * 8f) * _e814) * (0.000000059604645f * (524f / 64f))) + ((_e821 * 19f) * ((_e704 * (_e758 + _e812)) + (_e758 * _e812)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e704) * ((1f + _e758) * (1f + _e812)))));
                let _e901 = (_e593 * 3f);
                let _e902 = (_e650 * 3f);
                if (_e901 < _e902) {
                    phi_1373_ = _e901;
                } else {
                    phi_1373_ = _e902;
                }
                let _e905 = phi_1373_;
                if (_e616 < _e639) {
                    phi_1378_ = _e616;
                } else {
                    phi_1378_ = _e639;
                }
                let _e908 = phi_1378_;
                if (_e905 < _e908) {
                    phi_1383_ = _e905;
                } else {
                    phi_1383_ = _e908;
                }
                let _e911 = phi_1383_;
                if (_e901 > _e902) {
                    phi_1388_ = _e901;
                } else {
                    phi_1388_ = _e902;
                }
                let _e914 = phi_1388_;
                if (_e616 > _e639) {
                    phi_1393_ = _e616;
                } else {
                    phi_1393_ = _e639;
                }
                let _e917 = phi_1393_;
                if (_e914 > _e917) {
                    phi_1398_ = _e914;
                } else {
                    phi_1398_ = _e917;
                }
                let _e920 = phi_1398_;
                let _e925 = -(_e920);
                if (_e911 > _e925) {
                    phi_1408_ = _e911;
                } else {
                    phi_1408_ = _e925;
                }
                let _e928 = phi_1408_;
                if ((_e928 - (_e900 + ((_e455.member_1 * (((_e883 + (_e814 * (0.000000059604645f * 8f))) + ((_e888 * 6f) * (_e758 + _e812))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e758) * (1f + _e812))))) * (3f * 1.0001f)))) > 0f) {
                    phi_8026_ = type_30(0u, type_30().member_1);
                } else {
                    if (_e455.member_1 > 0f) {
                        let _e3533 = local_12.member[0u];
                        let _e3539 = local_12.member_1[0u];
                        let _e3545 = local_12.member_2[0u];
                        let _e3549 = (_e3533[0] - _e3539[0]);
                        let _e3550 = (_e3533[1] - _e3539[1]);
                        let _e3551 = (_e3533[2] - _e3539[2]);
                        let _e3560 = local_12.member[1u];
                        let _e3566 = local_12.member_1[1u];
                        let _e3572 = local_12.member_2[1u];
                        let _e3576 = (_e3560[0] - _e3566[0]);
                        let _e3577 = (_e3560[1] - _e3566[1]);
                        let _e3578 = (_e3560[2] - _e3566[2]);
                        let _e3587 = local_12.member[0u];
                        if (_e3587[0] < 0f) {
                            phi_1561_ = -(_e3587[0]);
                        } else {
                            phi_1561_ = _e3587[0];
                        }
                        let _e3594 = phi_1561_;
                        if (_e3587[1] < 0f) {
                            phi_1568_ = -(_e3587[1]);
                        } else {
                            phi_1568_ = _e3587[1];
                        }
                        let _e3598 = phi_1568_;
                        if (_e3594 > _e3598) {
                            phi_1573_ = _e3594;
                        } else {
                            phi_1573_ = _e3598;
                        }
                        let _e3601 = phi_1573_;
                        if (_e3587[2] < 0f) {
                            phi_1580_ = -(_e3587[2]);
                        } else {
                            phi_1580_ = _e3587[2];
                        }
                        let _e3605 = phi_1580_;
                        if (_e3601 > _e3605) {
                            phi_1585_ = _e3601;
                        } else {
                            phi_1585_ = _e3605;
                        }
                        let _e3608 = phi_1585_;
                        let _e3611 = local_12.member[1u];
                        if (_e3611[0] < 0f) {
                            phi_1598_ = -(_e3611[0]);
                        } else {
                            phi_1598_ = _e3611[0];
                        }
                        let _e3618 = phi_1598_;
                        if (_e3611[1] < 0f) {
                            phi_1605_ = -(_e3611[1]);
                        } else {
                            phi_1605_ = _e3611[1];
                        }
                        let _e3622 = phi_1605_;
                        if (_e3618 > _e3622) {
                            phi_1610_ = _e3618;
                        } else {
                            phi_1610_ = _e3622;
                        }
                        let _e3625 = phi_1610_;
                        if (_e3611[2] < 0f) {
                            phi_1617_ = -(_e3611[2]);
                        } else {
                            phi_1617_ = _e3611[2];
                        }
                        let _e3629 = phi_1617_;
                        if (_e3625 > _e3629) {
                            phi_1622_ = _e3625;
                        } else {
                            phi_1622_ = _e3629;
                        }
                        let _e3632 = phi_1622_;
                        if (_e3608 > _e3632) {
                            phi_1627_ = _e3608;
                        } else {
                            phi_1627_ = _e3632;
                        }
                        let _e3635 = phi_1627_;
                        let _e3637 = local_12.member_3;
                        let _e3641 = local_12.member_1[0u];
                        if (_e3641[0] < 0f) {
                            phi_1644_ = -(_e3641[0]);
                        } else {
                            phi_1644_ = _e3641[0];
                        }
                        let _e3648 = phi_1644_;
                        if (_e3641[1] < 0f) {
                            phi_1651_ = -(_e3641[1]);
                        } else {
                            phi_1651_ = _e3641[1];
                        }
                        let _e3652 = phi_1651_;
                        if (_e3648 > _e3652) {
                            phi_1656_ = _e3648;
                        } else {
                            phi_1656_ = _e3652;
                        }
                        let _e3655 = phi_1656_;
                        if (_e3641[2] < 0f) {
                            phi_1663_ = -(_e3641[2]);
                        } else {
                            phi_1663_ = _e3641[2];
                        }
                        let _e3659 = phi_1663_;
                        if (_e3655 > _e3659) {
                            phi_1668_ = _e3655;
                        } else {
                            phi_1668_ = _e3659;
                        }
                        let _e3662 = phi_1668_;
                        let _e3665 = local_12.member_1[1u];
                        if (_e3665[0] < 0f) {
                            phi_1682_ = -(_e3665[0]);
                        } else {
                            phi_1682_ = _e3665[0];
                        }
                        let _e3672 = phi_1682_;
                        if (_e3665[1] < 0f) {
                            phi_1689_ = -(_e3665[1]);
                        } else {
                            phi_1689_ = _e3665[1];
                        }
                        let _e3676 = phi_1689_;
                        if (_e3672 > _e3676) {
                            phi_1694_ = _e3672;
                        } else {
                            phi_1694_ = _e3676;
                        }
                        let _e3679 = phi_1694_;
                        if (_e3665[2] < 0f) {
                            phi_1701_ = -(_e3665[2]);
                        } else {
                            phi_1701_ = _e3665[2];
                        }
                        let _e3683 = phi_1701_;
                        if (_e3679 > _e3683) {
                            phi_1706_ = _e3679;
                        } else {
                            phi_1706_ = _e3683;
                        }
                        let _e3686 = phi_1706_;
                        if (_e3662 > _e3686) {
                            phi_1711_ = _e3662;
                        } else {
                            phi_1711_ = _e3686;
                        }
                        let _e3689 = phi_1711_;
                        let _e3691 = local_12.member_3;
                        let _e3695 = local_12.member_2[0u];
                        if (_e3695[0] < 0f) {
                            phi_1728_ = -(_e3695[0]);
                        } else {
                            phi_1728_ = _e3695[0];
                        }
                        let _e3702 = phi_1728_;
                        if (_e3695[1] < 0f) {
                            phi_1735_ = -(_e3695[1]);
                        } else {
                            phi_1735_ = _e3695[1];
                        }
                        let _e3706 = phi_1735_;
                        if (_e3702 > _e3706) {
                            phi_1740_ = _e3702;
                        } else {
                            phi_1740_ = _e3706;
                        }
                        let _e3709 = phi_1740_;
                        if (_e3695[2] < 0f) {
                            phi_1747_ = -(_e3695[2]);
                        } else {
                            phi_1747_ = _e3695[2];
                        }
                        let _e3713 = phi_1747_;
                        if (_e3709 > _e3713) {
                            phi_1752_ = _e3709;
                        } else {
                            phi_1752_ = _e3713;
                        }
                        let _e3716 = phi_1752_;
                        let _e3719 = local_12.member_2[1u];
                        if (_e3719[0] < 0f) {
                            phi_1766_ = -(_e3719[0]);
                        } else {
                            phi_1766_ = _e3719[0];
                        }
                        let _e3726 = phi_1766_;
                        if (_e3719[1] < 0f) {
                            phi_1773_ = -(_e3719[1]);
                        } else {
                            phi_1773_ = _e3719[1];
                        }
                        let _e3730 = phi_1773_;
                        if (_e3726 > _e3730) {
                            phi_1778_ = _e3726;
                        } else {
                            phi_1778_ = _e3730;
                        }
                        let _e3733 = phi_1778_;
                        if (_e3719[2] < 0f) {
                            phi_1785_ = -(_e3719[2]);
                        } else {
                            phi_1785_ = _e3719[2];
                        }
                        let _e3737 = phi_1785_;
                        if (_e3733 > _e3737) {
                            phi_1790_ = _e3733;
                        } else {
                            phi_1790_ = _e3737;
                        }
                        let _e3740 = phi_1790_;
                        if (_e3716 > _e3740) {
                            phi_1795_ = _e3716;
                        } else {
                            phi_1795_ = _e3740;
                        }
                        let _e3743 = phi_1795_;
                        let _e3745 = local_12.member_3;
                        let _e3752 = local_12.member_3;
                        local_9 = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                        phi_1834_ = type_9(0u, 96u);
                        phi_1837_ = 0f;
                        phi_1839_ = 0f;
                        phi_1841_ = 0f;
                        phi_1843_ = false;
                        phi_1845_ = 0u;
                        loop {
                            let _e3758 = phi_1834_;
                            let _e3760 = phi_1837_;
                            let _e3762 = phi_1839_;
                            let _e3764 = phi_1841_;
                            let _e3766 = phi_1843_;
                            let _e3768 = phi_1845_;
                            local_44 = _e3762;
                            local_26 = _e3760;
                            if (_e3758.member < _e3758.member_1) {
                                phi_1835_ = type_9((_e3758.member + 1u), _e3758.member_1);
                                phi_1868_ = type_9(1u, _e3758.member);
                            } else {
                                phi_1835_ = _e3758;
                                phi_1868_ = type_9(0u, type_9().member_1);
                            }
                            let _e3780 = phi_1835_;
                            let _e3782 = phi_1868_;
                            if (bitcast<i32>(_e3782.member) != 0i) {
                                let _e3788 = local_12.member[0u];
                                let _e3794 = local_12.member[1u];
                                let _e3810 = local_12.member_1[0u];
                                let _e3816 = local_12.member_1[1u];
                                let _e3832 = local_12.member_2[0u];
                                let _e3838 = local_12.member_2[1u];
                                let _e3852 = function_2(array<f32, 3>((_e3788[0] + ((_e3794[0] - _e3788[0]) * _e3760)), (_e3788[1] + ((_e3794[1] - _e3788[1]) * _e3760)), (_e3788[2] + ((_e3794[2] - _e3788[2]) * _e3760))), array<f32, 3>((_e3810[0] + ((_e3816[0] - _e3810[0]) * _e3760)), (_e3810[1] + ((_e3816[1] - _e3810[1]) * _e3760)), (_e3810[2] + ((_e3816[2] - _e3810[2]) * _e3760))), array<f32, 3>((_e3832[0] + ((_e3838[0] - _e3832[0]) * _e3760)), (_e3832[1] + ((_e3838[1] - _e3832[1]) * _e3760)), (_e3832[2] + ((_e3838[2] - _e3832[2]) * _e3760))), 1u);
                                if (_e3768 == 0u) {
                                    phi_1996_ = _e3852;
                                } else {
                                    if (_e3768 == 1u) {
                                        phi_1982_ = _e3852[0];
                                    } else {
                                        phi_1982_ = 0f;
                                    }
                                    let _e3857 = phi_1982_;
                                    if (_e3768 == 2u) {
                                        phi_1988_ = _e3852[1];
                                    } else {
                                        phi_1988_ = 0f;
                                    }
                                    let _e3861 = phi_1988_;
                                    if (_e3768 == 3u) {
                                        phi_1994_ = _e3852[2];
                                    } else {
                                        phi_1994_ = 0f;
                                    }
                                    let _e3865 = phi_1994_;
                                    phi_1996_ = array<f32, 3>(_e3857, _e3861, _e3865);
                                }
                                let _e3868 = phi_1996_;
                                if (_e3868[0] < 0f) {
                                    phi_2003_ = -(_e3868[0]);
                                } else {
                                    phi_2003_ = _e3868[0];
                                }
                                let _e3873 = phi_2003_;
                                if (_e3868[1] < 0f) {
                                    phi_2010_ = -(_e3868[1]);
                                } else {
                                    phi_2010_ = _e3868[1];
                                }
                                let _e3878 = phi_2010_;
                                if (_e3868[2] < 0f) {
                                    phi_2018_ = -(_e3868[2]);
                                } else {
                                    phi_2018_ = _e3868[2];
                                }
                                let _e3884 = phi_2018_;
                                let _e3885 = ((_e3873 + _e3878) + _e3884);
                                if (_e3885 > 0f) {
                                    if ((bitcast<u32>(_e3885) & 2139095040u) != 2139095040u) {
                                        let _e3890 = (1f / _e3885);
                                        let _e3892 = (_e3868[0] * _e3890);
                                        let _e3894 = (_e3868[1] * _e3890);
                                        let _e3896 = (_e3868[2] * _e3890);
                                        let _e3901 = (((_e3892 * _e3892) + (_e3894 * _e3894)) + (_e3896 * _e3896));
                                        if (_e3901 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e3901 > 0f) {
                                                phi_2055_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_2055_ = 0f;
                                            }
                                            let _e3954 = phi_2055_;
                                            phi_2119_ = _e3954;
                                        } else {
                                            phi_2062_ = type_14(0i, 5i);
                                            phi_2065_ = bitcast<f32>(((bitcast<u32>(_e3901) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e3909 = phi_2062_;
                                                let _e3911 = phi_2065_;
                                                local_24 = _e3911;
                                                if (_e3909.member < _e3909.member_1) {
                                                    let _e3918 = (_e3909.member + 1i);
                                                    if ((false == (_e3918 > _e3909.member)) != false) {
                                                        phi_2086_ = true;
                                                    } else {
                                                        phi_2086_ = false;
                                                    }
                                                    let _e3923 = phi_2086_;
                                                    if _e3923 {
                                                        phi_2092_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_2092_ = type_15(1u, _e3918);
                                                    }
                                                    let _e3928 = phi_2092_;
                                                    phi_2063_ = type_14(_e3928.member_1, _e3909.member_1);
                                                    phi_2106_ = type_15(1u, _e3909.member);
                                                } else {
                                                    phi_2063_ = _e3909;
                                                    phi_2106_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e3934 = phi_2063_;
                                                let _e3936 = phi_2106_;
                                                let _e3939 = (bitcast<i32>(_e3936.member) != 0i);
                                                if _e3939 {
                                                    phi_2066_ = (0.5f * (_e3911 + (_e3901 / _e3911)));
                                                } else {
                                                    phi_2066_ = f32();
                                                }
                                                let _e3944 = phi_2066_;
                                                continue;
                                                continuing {
                                                    phi_2062_ = _e3934;
                                                    phi_2065_ = _e3944;
                                                    break if !(_e3939);
                                                }
                                            }
                                            let _e3949 = local_24;
                                            phi_2119_ = (_e3949 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e3956 = phi_2119_;
                                        let _e3957 = (0.000000059604645f * 12f);
                                        let _e3962 = ((((((((_e3635 + _e3637) + (_e3689 + _e3691)) + (_e3743 + _e3745)) * (0.000000059604645f * 16f)) + (_e3752 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e455.member_1 * _e3956) * (1f + _e3957)));
                                        let _e3967 = (((_e3892 * _e3533[0]) + (_e3894 * _e3533[1])) + (_e3896 * _e3533[2]));
                                        let _e3972 = (((_e3892 * _e3549) + (_e3894 * _e3550)) + (_e3896 * _e3551));
                                        let _e3977 = (((_e3892 * (_e3533[0] - _e3545[0])) + (_e3894 * (_e3533[1] - _e3545[1]))) + (_e3896 * (_e3533[2] - _e3545[2])));
                                        let _e3982 = (((_e3892 * (_e3549 - _e3545[0])) + (_e3894 * (_e3550 - _e3545[1]))) + (_e3896 * (_e3551 - _e3545[2])));
                                        let _e3988 = (((_e3892 * _e3560[0]) + (_e3894 * _e3560[1])) + (_e3896 * _e3560[2]));
                                        let _e3993 = (((_e3892 * _e3576) + (_e3894 * _e3577)) + (_e3896 * _e3578));
                                        let _e3998 = (((_e3892 * (_e3560[0] - _e3572[0])) + (_e3894 * (_e3560[1] - _e3572[1]))) + (_e3896 * (_e3560[2] - _e3572[2])));
                                        let _e4003 = (((_e3892 * (_e3576 - _e3572[0])) + (_e3894 * (_e3577 - _e3572[1]))) + (_e3896 * (_e3578 - _e3572[2])));
                                        if (_e3967 < 0f) {
                                            phi_2185_ = -(_e3967);
                                        } else {
                                            phi_2185_ = _e3967;
                                        }
                                        let _e4008 = phi_2185_;
                                        if (_e3988 < 0f) {
                                            phi_2191_ = -(_e3988);
                                        } else {
                                            phi_2191_ = _e3988;
                                        }
                                        let _e4012 = phi_2191_;
                                        if (_e3972 < 0f) {
                                            phi_2200_ = -(_e3972);
                                        } else {
                                            phi_2200_ = _e3972;
                                        }
                                        let _e4019 = phi_2200_;
                                        if (_e3993 < 0f) {
                                            phi_2206_ = -(_e3993);
                                        } else {
                                            phi_2206_ = _e3993;
                                        }
                                        let _e4023 = phi_2206_;
                                        if (_e3977 < 0f) {
                                            phi_2215_ = -(_e3977);
                                        } else {
                                            phi_2215_ = _e3977;
                                        }
                                        let _e4030 = phi_2215_;
                                        if (_e3998 < 0f) {
                                            phi_2221_ = -(_e3998);
                                        } else {
                                            phi_2221_ = _e3998;
                                        }
                                        let _e4034 = phi_2221_;
                                        if (_e3982 < 0f) {
                                            phi_2230_ = -(_e3982);
                                        } else {
                                            phi_2230_ = _e3982;
                                        }
                                        let _e4041 = phi_2230_;
                                        if (_e4003 < 0f) {
                                            phi_2236_ = -(_e4003);
                                        } else {
                                            phi_2236_ = _e4003;
                                        }
                                        let _e4045 = phi_2236_;
                                        phi_2242_ = type_31(array<f32, 4>(_e3967, _e3972, _e3977, _e3982), array<f32, 4>(_e3988, _e3993, _e3998, _e4003), array<f32, 4>((_e3962 + ((_e4008 + _e4012) * _e3957)), (_e3962 + ((_e4019 + _e4023) * _e3957)), (_e3962 + ((_e4030 + _e4034) * _e3957)), (_e3962 + ((_e4041 + _e4045) * _e3957))));
                                        phi_2243_ = false;
                                    } else {
                                        phi_2242_ = type_31();
                                        phi_2243_ = true;
                                    }
                                    let _e4052 = phi_2242_;
                                    let _e4054 = phi_2243_;
                                    phi_2244_ = _e4052;
                                    phi_2245_ = _e4054;
                                } else {
                                    phi_2244_ = type_31();
                                    phi_2245_ = true;
                                }
                                let _e4056 = phi_2244_;
                                let _e4058 = phi_2245_;
                                if _e4058 {
                                    phi_2253_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_2253_ = _e4056;
                                }
                                let _e4060 = phi_2253_;
                                local_10 = type_31(array<f32, 4>(_e4060.member[0], _e4060.member[1], _e4060.member[2], _e4060.member[3]), array<f32, 4>(_e4060.member_1[0], _e4060.member_1[1], _e4060.member_1[2], _e4060.member_1[3]), array<f32, 4>(_e4060.member_2[0], _e4060.member_2[1], _e4060.member_2[2], _e4060.member_2[3]));
                                let _e4080 = (_e3760 - _e3764);
                                let _e4084 = local_10.member[0u];
                                let _e4087 = local_10.member_1[0u];
                                let _e4090 = local_10.member[0u];
                                let _e4096 = local_10.member_2[0u];
                                if (((_e4084 + ((_e4087 - _e4090) * _e3760)) - _e4096) > 0f) {
                                    let _e4101 = local_10.member[1u];
                                    let _e4104 = local_10.member_1[1u];
                                    let _e4107 = local_10.member[1u];
                                    let _e4113 = local_10.member_2[1u];
                                    if (((_e4101 + ((_e4104 - _e4107) * _e3760)) - _e4113) > 0f) {
                                        let _e4118 = local_10.member[2u];
                                        let _e4121 = local_10.member_1[2u];
                                        let _e4124 = local_10.member[2u];
                                        let _e4130 = local_10.member_2[2u];
                                        if (((_e4118 + ((_e4121 - _e4124) * _e3760)) - _e4130) > 0f) {
                                            let _e4135 = local_10.member[3u];
                                            let _e4138 = local_10.member_1[3u];
                                            let _e4141 = local_10.member[3u];
                                            let _e4147 = local_10.member_2[3u];
                                            phi_2424_ = (((_e4135 + ((_e4138 - _e4141) * _e3760)) - _e4147) > 0f);
                                            phi_2425_ = false;
                                        } else {
                                            phi_2424_ = bool();
                                            phi_2425_ = true;
                                        }
                                        let _e4151 = phi_2424_;
                                        let _e4153 = phi_2425_;
                                        phi_2426_ = _e4151;
                                        phi_2427_ = _e4153;
                                    } else {
                                        phi_2426_ = bool();
                                        phi_2427_ = true;
                                    }
                                    let _e4155 = phi_2426_;
                                    let _e4157 = phi_2427_;
                                    phi_2428_ = _e4155;
                                    phi_2429_ = _e4157;
                                } else {
                                    phi_2428_ = bool();
                                    phi_2429_ = true;
                                }
                                let _e4159 = phi_2428_;
                                let _e4161 = phi_2429_;
                                if _e4161 {
                                    phi_2433_ = false;
                                } else {
                                    phi_2433_ = _e4159;
                                }
                                let _e4163 = phi_2433_;
                                if _e4163 {
                                    if (_e3760 <= _e3762) {
                                        phi_2743_ = true;
                                    } else {
                                        let _e4167 = local_9.member[0u];
                                        let _e4170 = local_9.member_1[0u];
                                        let _e4173 = local_9.member[0u];
                                        let _e4179 = local_9.member_2[0u];
                                        let _e4183 = local_10.member[0u];
                                        let _e4186 = local_10.member_1[0u];
                                        let _e4189 = local_10.member[0u];
                                        let _e4195 = local_10.member_2[0u];
                                        if ((((_e4167 + ((_e4170 - _e4173) * _e3760)) - _e4179) + ((_e4183 + ((_e4186 - _e4189) * _e3764)) - _e4195)) > 0f) {
                                            let _e4201 = local_9.member[1u];
                                            let _e4204 = local_9.member_1[1u];
                                            let _e4207 = local_9.member[1u];
                                            let _e4213 = local_9.member_2[1u];
                                            let _e4217 = local_10.member[1u];
                                            let _e4220 = local_10.member_1[1u];
                                            let _e4223 = local_10.member[1u];
                                            let _e4229 = local_10.member_2[1u];
                                            if ((((_e4201 + ((_e4204 - _e4207) * _e3760)) - _e4213) + ((_e4217 + ((_e4220 - _e4223) * _e3764)) - _e4229)) > 0f) {
                                                let _e4235 = local_9.member[2u];
                                                let _e4238 = local_9.member_1[2u];
                                                let _e4241 = local_9.member[2u];
                                                let _e4247 = local_9.member_2[2u];
                                                let _e4251 = local_10.member[2u];
                                                let _e4254 = local_10.member_1[2u];
                                                let _e4257 = local_10.member[2u];
                                                let _e4263 = local_10.member_2[2u];
                                                if ((((_e4235 + ((_e4238 - _e4241) * _e3760)) - _e4247) + ((_e4251 + ((_e4254 - _e4257) * _e3764)) - _e4263)) > 0f) {
                                                    let _e4269 = local_9.member[3u];
                                                    let _e4272 = local_9.member_1[3u];
                                                    let _e4275 = local_9.member[3u];
                                                    let _e4281 = local_9.member_2[3u];
                                                    let _e4285 = local_10.member[3u];
                                                    let _e4288 = local_10.member_1[3u];
                                                    let _e4291 = local_10.member[3u];
                                                    let _e4297 = local_10.member_2[3u];
                                                    phi_2730_ = ((((_e4269 + ((_e4272 - _e4275) * _e3760)) - _e4281) + ((_e4285 + ((_e4288 - _e4291) * _e3764)) - _e4297)) > 0f);
                                                    phi_2731_ = false;
                                                } else {
                                                    phi_2730_ = bool();
                                                    phi_2731_ = true;
                                                }
                                                let _e4302 = phi_2730_;
                                                let _e4304 = phi_2731_;
                                                phi_2732_ = _e4302;
                                                phi_2733_ = _e4304;
                                            } else {
                                                phi_2732_ = bool();
                                                phi_2733_ = true;
                                            }
                                            let _e4306 = phi_2732_;
                                            let _e4308 = phi_2733_;
                                            phi_2734_ = _e4306;
                                            phi_2735_ = _e4308;
                                        } else {
                                            phi_2734_ = bool();
                                            phi_2735_ = true;
                                        }
                                        let _e4310 = phi_2734_;
                                        let _e4312 = phi_2735_;
                                        if _e4312 {
                                            phi_2739_ = false;
                                        } else {
                                            phi_2739_ = _e4310;
                                        }
                                        let _e4314 = phi_2739_;
                                        phi_2743_ = _e4314;
                                    }
                                    let _e4316 = phi_2743_;
                                    if _e4316 {
                                        if _e3766 {
                                            if (_e3760 >= 1f) {
                                                phi_2754_ = false;
                                            } else {
                                                phi_2754_ = true;
                                            }
                                            let _e4319 = phi_2754_;
                                            phi_2755_ = _e4319;
                                        } else {
                                            phi_2755_ = true;
                                        }
                                        let _e4321 = phi_2755_;
                                        if _e4321 {
                                            local_9 = type_31(array<f32, 4>(_e4060.member[0], _e4060.member[1], _e4060.member[2], _e4060.member[3]), array<f32, 4>(_e4060.member_1[0], _e4060.member_1[1], _e4060.member_1[2], _e4060.member_1[3]), array<f32, 4>(_e4060.member_2[0], _e4060.member_2[1], _e4060.member_2[2], _e4060.member_2[3]));
                                            let _e4343 = local_9.member[0u];
                                            let _e4346 = local_9.member_1[0u];
                                            let _e4349 = local_9.member_2[0u];
                                            if (_e4343 > _e4349) {
                                                if (_e4346 > _e4349) {
                                                    phi_2829_ = false;
                                                } else {
                                                    phi_2829_ = true;
                                                }
                                                let _e4353 = phi_2829_;
                                                phi_2830_ = _e4353;
                                            } else {
                                                phi_2830_ = true;
                                            }
                                            let _e4355 = phi_2830_;
                                            if _e4355 {
                                                let _e4356 = (_e4346 >= _e4343);
                                                if _e4356 {
                                                    phi_2852_ = f32();
                                                    phi_2853_ = false;
                                                } else {
                                                    if ((_e4343 - _e4346) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2850_ = (((_e4343 - _e4349) / (_e4343 - _e4346)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2851_ = false;
                                                    } else {
                                                        phi_2850_ = f32();
                                                        phi_2851_ = true;
                                                    }
                                                    let _e4367 = phi_2850_;
                                                    let _e4369 = phi_2851_;
                                                    phi_2852_ = _e4367;
                                                    phi_2853_ = _e4369;
                                                }
                                                let _e4371 = phi_2852_;
                                                let _e4373 = phi_2853_;
                                                phi_2854_ = _e4371;
                                                phi_2855_ = _e4356;
                                                phi_2856_ = _e4373;
                                            } else {
                                                phi_2854_ = f32();
                                                phi_2855_ = true;
                                                phi_2856_ = false;
                                            }
                                            let _e4375 = phi_2854_;
                                            let _e4377 = phi_2855_;
                                            let _e4379 = phi_2856_;
                                            if _e4377 {
                                                phi_2860_ = 2f;
                                                phi_2861_ = true;
                                            } else {
                                                phi_2860_ = _e3760;
                                                phi_2861_ = _e4379;
                                            }
                                            let _e4381 = phi_2860_;
                                            let _e4383 = phi_2861_;
                                            if _e4383 {
                                                phi_2865_ = _e4381;
                                            } else {
                                                phi_2865_ = _e4375;
                                            }
                                            let _e4385 = phi_2865_;
                                            let _e4388 = local_9.member[1u];
                                            let _e4391 = local_9.member_1[1u];
                                            let _e4394 = local_9.member_2[1u];
                                            if (_e4388 > _e4394) {
                                                if (_e4391 > _e4394) {
                                                    phi_2897_ = false;
                                                } else {
                                                    phi_2897_ = true;
                                                }
                                                let _e4398 = phi_2897_;
                                                phi_2898_ = _e4398;
                                            } else {
                                                phi_2898_ = true;
                                            }
                                            let _e4400 = phi_2898_;
                                            if _e4400 {
                                                let _e4401 = (_e4391 >= _e4388);
                                                if _e4401 {
                                                    phi_2920_ = f32();
                                                    phi_2921_ = false;
                                                } else {
                                                    if ((_e4388 - _e4391) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2918_ = (((_e4388 - _e4394) / (_e4388 - _e4391)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2919_ = false;
                                                    } else {
                                                        phi_2918_ = f32();
                                                        phi_2919_ = true;
                                                    }
                                                    let _e4412 = phi_2918_;
                                                    let _e4414 = phi_2919_;
                                                    phi_2920_ = _e4412;
                                                    phi_2921_ = _e4414;
                                                }
                                                let _e4416 = phi_2920_;
                                                let _e4418 = phi_2921_;
                                                phi_2922_ = _e4416;
                                                phi_2923_ = _e4401;
                                                phi_2924_ = _e4418;
                                            } else {
                                                phi_2922_ = f32();
                                                phi_2923_ = true;
                                                phi_2924_ = false;
                                            }
                                            let _e4420 = phi_2922_;
                                            let _e4422 = phi_2923_;
                                            let _e4424 = phi_2924_;
                                            if _e4422 {
                                                phi_2928_ = 2f;
                                                phi_2929_ = true;
                                            } else {
                                                phi_2928_ = _e3760;
                                                phi_2929_ = _e4424;
                                            }
                                            let _e4426 = phi_2928_;
                                            let _e4428 = phi_2929_;
                                            if _e4428 {
                                                phi_2933_ = _e4426;
                                            } else {
                                                phi_2933_ = _e4420;
                                            }
                                            let _e4430 = phi_2933_;
                                            if (_e4385 < _e4430) {
                                                phi_2938_ = _e4385;
                                            } else {
                                                phi_2938_ = _e4430;
                                            }
                                            let _e4433 = phi_2938_;
                                            let _e4436 = local_9.member[2u];
                                            let _e4439 = local_9.member_1[2u];
                                            let _e4442 = local_9.member_2[2u];
                                            if (_e4436 > _e4442) {
                                                if (_e4439 > _e4442) {
                                                    phi_2970_ = false;
                                                } else {
                                                    phi_2970_ = true;
                                                }
                                                let _e4446 = phi_2970_;
                                                phi_2971_ = _e4446;
                                            } else {
                                                phi_2971_ = true;
                                            }
                                            let _e4448 = phi_2971_;
                                            if _e4448 {
                                                let _e4449 = (_e4439 >= _e4436);
                                                if _e4449 {
                                                    phi_2993_ = f32();
                                                    phi_2994_ = false;
                                                } else {
                                                    if ((_e4436 - _e4439) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_2991_ = (((_e4436 - _e4442) / (_e4436 - _e4439)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_2992_ = false;
                                                    } else {
                                                        phi_2991_ = f32();
                                                        phi_2992_ = true;
                                                    }
                                                    let _e4460 = phi_2991_;
                                                    let _e4462 = phi_2992_;
                                                    phi_2993_ = _e4460;
                                                    phi_2994_ = _e4462;
                                                }
                                                let _e4464 = phi_2993_;
                                                let _e4466 = phi_2994_;
                                                phi_2995_ = _e4464;
                                                phi_2996_ = _e4449;
                                                phi_2997_ = _e4466;
                                            } else {
                                                phi_2995_ = f32();
                                                phi_2996_ = true;
                                                phi_2997_ = false;
                                            }
                                            let _e4468 = phi_2995_;
                                            let _e4470 = phi_2996_;
                                            let _e4472 = phi_2997_;
                                            if _e4470 {
                                                phi_3001_ = 2f;
                                                phi_3002_ = true;
                                            } else {
                                                phi_3001_ = _e3760;
                                                phi_3002_ = _e4472;
                                            }
                                            let _e4474 = phi_3001_;
                                            let _e4476 = phi_3002_;
                                            if _e4476 {
                                                phi_3006_ = _e4474;
                                            } else {
                                                phi_3006_ = _e4468;
                                            }
                                            let _e4478 = phi_3006_;
                                            let _e4481 = local_9.member[3u];
                                            let _e4484 = local_9.member_1[3u];
                                            let _e4487 = local_9.member_2[3u];
                                            if (_e4481 > _e4487) {
                                                if (_e4484 > _e4487) {
                                                    phi_3038_ = false;
                                                } else {
                                                    phi_3038_ = true;
                                                }
                                                let _e4491 = phi_3038_;
                                                phi_3039_ = _e4491;
                                            } else {
                                                phi_3039_ = true;
                                            }
                                            let _e4493 = phi_3039_;
                                            if _e4493 {
                                                let _e4494 = (_e4484 >= _e4481);
                                                if _e4494 {
                                                    phi_3061_ = f32();
                                                    phi_3062_ = false;
                                                } else {
                                                    if ((_e4481 - _e4484) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                        phi_3059_ = (((_e4481 - _e4487) / (_e4481 - _e4484)) * (1f - (0.000000059604645f * 16f)));
                                                        phi_3060_ = false;
                                                    } else {
                                                        phi_3059_ = f32();
                                                        phi_3060_ = true;
                                                    }
                                                    let _e4505 = phi_3059_;
                                                    let _e4507 = phi_3060_;
                                                    phi_3061_ = _e4505;
                                                    phi_3062_ = _e4507;
                                                }
                                                let _e4509 = phi_3061_;
                                                let _e4511 = phi_3062_;
                                                phi_3063_ = _e4509;
                                                phi_3064_ = _e4494;
                                                phi_3065_ = _e4511;
                                            } else {
                                                phi_3063_ = f32();
                                                phi_3064_ = true;
                                                phi_3065_ = false;
                                            }
                                            let _e4513 = phi_3063_;
                                            let _e4515 = phi_3064_;
                                            let _e4517 = phi_3065_;
                                            if _e4515 {
                                                phi_3069_ = 2f;
                                                phi_3070_ = true;
                                            } else {
                                                phi_3069_ = _e3760;
                                                phi_3070_ = _e4517;
                                            }
                                            let _e4519 = phi_3069_;
                                            let _e4521 = phi_3070_;
                                            if _e4521 {
                                                phi_3074_ = _e4519;
                                            } else {
                                                phi_3074_ = _e4513;
                                            }
                                            let _e4523 = phi_3074_;
                                            if (_e4478 < _e4523) {
                                                phi_3079_ = _e4478;
                                            } else {
                                                phi_3079_ = _e4523;
                                            }
                                            let _e4526 = phi_3079_;
                                            if (_e4433 < _e4526) {
                                                phi_3084_ = _e4433;
                                            } else {
                                                phi_3084_ = _e4526;
                                            }
                                            let _e4529 = phi_3084_;
                                            if (_e4529 > _e3760) {
                                                phi_3089_ = _e4529;
                                            } else {
                                                phi_3089_ = _e3760;
                                            }
                                            let _e4532 = phi_3089_;
                                            let _e4533 = (_e4532 > 1f);
                                            if _e4533 {
                                                phi_3100_ = f32();
                                                phi_3101_ = false;
                                            } else {
                                                if _e3766 {
                                                    phi_3099_ = (_e4080 + _e4080);
                                                } else {
                                                    phi_3099_ = (1f - _e3760);
                                                }
                                                let _e4537 = phi_3099_;
                                                phi_3100_ = _e4537;
                                                phi_3101_ = true;
                                            }
                                            let _e4539 = phi_3100_;
                                            let _e4541 = phi_3101_;
                                            phi_3102_ = _e4532;
                                            phi_3103_ = _e4539;
                                            phi_3104_ = _e4541;
                                            phi_3105_ = _e4533;
                                            phi_3106_ = false;
                                        } else {
                                            phi_3102_ = f32();
                                            phi_3103_ = f32();
                                            phi_3104_ = false;
                                            phi_3105_ = false;
                                            phi_3106_ = true;
                                        }
                                        let _e4543 = phi_3102_;
                                        let _e4545 = phi_3103_;
                                        let _e4547 = phi_3104_;
                                        let _e4549 = phi_3105_;
                                        let _e4551 = phi_3106_;
                                        phi_3107_ = _e4543;
                                        phi_3108_ = _e4545;
                                        phi_3109_ = false;
                                        phi_3110_ = _e4547;
                                        phi_3111_ = _e4549;
                                        phi_3112_ = _e4551;
                                    } else {
                                        phi_3107_ = f32();
                                        phi_3108_ = f32();
                                        phi_3109_ = true;
                                        phi_3110_ = false;
                                        phi_3111_ = false;
                                        phi_3112_ = false;
                                    }
                                    let _e4553 = phi_3107_;
                                    let _e4555 = phi_3108_;
                                    let _e4557 = phi_3109_;
                                    let _e4559 = phi_3110_;
                                    let _e4561 = phi_3111_;
                                    let _e4563 = phi_3112_;
                                    phi_3113_ = _e4553;
                                    phi_3114_ = _e4555;
                                    phi_3115_ = _e4557;
                                    phi_3116_ = _e4559;
                                    phi_3117_ = _e4561;
                                    phi_3118_ = _e4563;
                                } else {
                                    phi_3113_ = f32();
                                    phi_3114_ = f32();
                                    phi_3115_ = true;
                                    phi_3116_ = false;
                                    phi_3117_ = false;
                                    phi_3118_ = false;
                                }
                                let _e4565 = phi_3113_;
                                let _e4567 = phi_3114_;
                                let _e4569 = phi_3115_;
                                let _e4571 = phi_3116_;
                                let _e4573 = phi_3117_;
                                let _e4575 = phi_3118_;
                                if _e4569 {
                                    if (_e3760 <= _e3762) {
                                        let _e4736 = (_e3768 + 1u);
                                        let _e4737 = (_e4736 > 3u);
                                        if _e4737 {
                                            phi_3131_ = false;
                                        } else {
                                            phi_3131_ = true;
                                        }
                                        let _e4739 = phi_3131_;
                                        phi_3453_ = _e4736;
                                        phi_3454_ = f32();
                                        phi_3455_ = false;
                                        phi_3456_ = _e4739;
                                        phi_3457_ = _e4737;
                                    } else {
                                        let _e4579 = local_9.member[0u];
                                        let _e4582 = local_9.member_1[0u];
                                        let _e4585 = local_9.member[0u];
                                        let _e4591 = local_9.member_2[0u];
                                        let _e4592 = ((_e4579 + ((_e4582 - _e4585) * _e3764)) - _e4591);
                                        let _e4595 = local_9.member[1u];
                                        let _e4598 = local_9.member_1[1u];
                                        let _e4601 = local_9.member[1u];
                                        let _e4607 = local_9.member_2[1u];
                                        let _e4608 = ((_e4595 + ((_e4598 - _e4601) * _e3764)) - _e4607);
                                        if (_e4592 < _e4608) {
                                            phi_3204_ = _e4592;
                                        } else {
                                            phi_3204_ = _e4608;
                                        }
                                        let _e4611 = phi_3204_;
                                        let _e4614 = local_9.member[2u];
                                        let _e4617 = local_9.member_1[2u];
                                        let _e4620 = local_9.member[2u];
                                        let _e4626 = local_9.member_2[2u];
                                        let _e4627 = ((_e4614 + ((_e4617 - _e4620) * _e3764)) - _e4626);
                                        let _e4630 = local_9.member[3u];
                                        let _e4633 = local_9.member_1[3u];
                                        let _e4636 = local_9.member[3u];
                                        let _e4642 = local_9.member_2[3u];
                                        let _e4643 = ((_e4630 + ((_e4633 - _e4636) * _e3764)) - _e4642);
                                        if (_e4627 < _e4643) {
                                            phi_3277_ = _e4627;
                                        } else {
                                            phi_3277_ = _e4643;
                                        }
                                        let _e4646 = phi_3277_;
                                        if (_e4611 < _e4646) {
                                            phi_3282_ = _e4611;
                                        } else {
                                            phi_3282_ = _e4646;
                                        }
                                        let _e4649 = phi_3282_;
                                        let _e4652 = local_10.member[0u];
                                        let _e4655 = local_10.member_1[0u];
                                        let _e4658 = local_10.member[0u];
                                        let _e4664 = local_10.member_2[0u];
                                        let _e4665 = ((_e4652 + ((_e4655 - _e4658) * _e3760)) - _e4664);
                                        let _e4668 = local_10.member[1u];
                                        let _e4671 = local_10.member_1[1u];
                                        let _e4674 = local_10.member[1u];
                                        let _e4680 = local_10.member_2[1u];
                                        let _e4681 = ((_e4668 + ((_e4671 - _e4674) * _e3760)) - _e4680);
                                        if (_e4665 < _e4681) {
                                            phi_3355_ = _e4665;
                                        } else {
                                            phi_3355_ = _e4681;
                                        }
                                        let _e4684 = phi_3355_;
                                        let _e4687 = local_10.member[2u];
                                        let _e4690 = local_10.member_1[2u];
                                        let _e4693 = local_10.member[2u];
                                        let _e4699 = local_10.member_2[2u];
                                        let _e4700 = ((_e4687 + ((_e4690 - _e4693) * _e3760)) - _e4699);
                                        let _e4703 = local_10.member[3u];
                                        let _e4706 = local_10.member_1[3u];
                                        let _e4709 = local_10.member[3u];
                                        let _e4715 = local_10.member_2[3u];
                                        let _e4716 = ((_e4703 + ((_e4706 - _e4709) * _e3760)) - _e4715);
                                        if (_e4700 < _e4716) {
                                            phi_3428_ = _e4700;
                                        } else {
                                            phi_3428_ = _e4716;
                                        }
                                        let _e4719 = phi_3428_;
                                        if (_e4684 < _e4719) {
                                            phi_3433_ = _e4684;
                                        } else {
                                            phi_3433_ = _e4719;
                                        }
                                        let _e4722 = phi_3433_;
                                        if (_e4722 > 0f) {
                                            phi_3451_ = 0.5f;
                                        } else {
                                            let _e4726 = (0.95f * (_e4649 / (_e4649 - _e4722)));
                                            if (_e4726 > 0.0625f) {
                                                if (_e4726 < 0.9f) {
                                                    phi_3449_ = _e4726;
                                                } else {
                                                    phi_3449_ = 0.9f;
                                                }
                                                let _e4730 = phi_3449_;
                                                phi_3450_ = _e4730;
                                            } else {
                                                phi_3450_ = 0.0625f;
                                            }
                                            let _e4732 = phi_3450_;
                                            phi_3451_ = _e4732;
                                        }
                                        let _e4734 = phi_3451_;
                                        phi_3453_ = u32();
                                        phi_3454_ = (_e4080 * _e4734);
                                        phi_3455_ = true;
                                        phi_3456_ = false;
                                        phi_3457_ = false;
                                    }
                                    let _e4741 = phi_3453_;
                                    let _e4743 = phi_3454_;
                                    let _e4745 = phi_3455_;
                                    let _e4747 = phi_3456_;
                                    let _e4749 = phi_3457_;
                                    phi_3458_ = _e4741;
                                    phi_3459_ = _e3762;
                                    phi_3460_ = _e4743;
                                    phi_3461_ = _e3764;
                                    phi_3462_ = _e3766;
                                    phi_3463_ = _e3768;
                                    phi_3464_ = _e4745;
                                    phi_3465_ = _e4747;
                                    phi_3466_ = _e4749;
                                    phi_3467_ = false;
                                    phi_3468_ = false;
                                } else {
                                    phi_3458_ = u32();
                                    phi_3459_ = _e4565;
                                    phi_3460_ = _e4567;
                                    phi_3461_ = _e3760;
                                    phi_3462_ = true;
                                    phi_3463_ = 0u;
                                    phi_3464_ = _e4571;
                                    phi_3465_ = false;
                                    phi_3466_ = false;
                                    phi_3467_ = _e4573;
                                    phi_3468_ = _e4575;
                                }
                                let _e4751 = phi_3458_;
                                let _e4753 = phi_3459_;
                                let _e4755 = phi_3460_;
                                let _e4757 = phi_3461_;
                                let _e4759 = phi_3462_;
                                let _e4761 = phi_3463_;
                                let _e4763 = phi_3464_;
                                let _e4765 = phi_3465_;
                                let _e4767 = phi_3466_;
                                let _e4769 = phi_3467_;
                                let _e4771 = phi_3468_;
                                if _e4763 {
                                    let _e4772 = (_e4757 + _e4755);
                                    if (_e4772 > _e4753) {
                                        phi_3477_ = _e4772;
                                    } else {
                                        phi_3477_ = _e4753;
                                    }
                                    let _e4775 = phi_3477_;
                                    if (_e4775 < 1f) {
                                        phi_3482_ = _e4775;
                                    } else {
                                        phi_3482_ = 1f;
                                    }
                                    let _e4778 = phi_3482_;
                                    if !(_e3766) {
                                        phi_3491_ = true;
                                    } else {
                                        phi_3491_ = ((_e4778 - _e4757) > 0.0000000037252903f);
                                    }
                                    let _e4782 = phi_3491_;
                                    if _e4782 {
                                        phi_3495_ = false;
                                    } else {
                                        phi_3495_ = true;
                                    }
                                    let _e4784 = phi_3495_;
                                    phi_3496_ = _e4778;
                                    phi_3497_ = _e4753;
                                    phi_3498_ = _e4757;
                                    phi_3499_ = _e4759;
                                    phi_3500_ = _e4761;
                                    phi_3501_ = _e4782;
                                    phi_3502_ = _e4784;
                                    phi_3503_ = false;
                                    phi_3504_ = false;
                                    phi_3505_ = false;
                                } else {
                                    phi_3496_ = _e3760;
                                    phi_3497_ = _e3762;
                                    phi_3498_ = _e3764;
                                    phi_3499_ = _e3766;
                                    phi_3500_ = _e4751;
                                    phi_3501_ = _e4765;
                                    phi_3502_ = false;
                                    phi_3503_ = _e4767;
                                    phi_3504_ = _e4769;
                                    phi_3505_ = _e4771;
                                }
                                let _e4786 = phi_3496_;
                                let _e4788 = phi_3497_;
                                let _e4790 = phi_3498_;
                                let _e4792 = phi_3499_;
                                let _e4794 = phi_3500_;
                                let _e4796 = phi_3501_;
                                let _e4798 = phi_3502_;
                                let _e4800 = phi_3503_;
                                let _e4802 = phi_3504_;
                                let _e4804 = phi_3505_;
                                phi_1838_ = _e4786;
                                phi_1840_ = _e4788;
                                phi_1842_ = _e4790;
                                phi_1844_ = _e4792;
                                phi_1846_ = _e4794;
                                phi_3506_ = _e4753;
                                phi_3507_ = _e4796;
                                phi_3508_ = _e4798;
                                phi_3509_ = false;
                                phi_3510_ = _e4800;
                                phi_3511_ = _e4802;
                                phi_3512_ = _e4804;
                            } else {
                                phi_1838_ = f32();
                                phi_1840_ = f32();
                                phi_1842_ = f32();
                                phi_1844_ = bool();
                                phi_1846_ = u32();
                                phi_3506_ = f32();
                                phi_3507_ = false;
                                phi_3508_ = false;
                                phi_3509_ = true;
                                phi_3510_ = false;
                                phi_3511_ = false;
                                phi_3512_ = false;
                            }
                            let _e4806 = phi_1838_;
                            let _e4808 = phi_1840_;
                            let _e4810 = phi_1842_;
                            let _e4812 = phi_1844_;
                            let _e4814 = phi_1846_;
                            let _e4816 = phi_3506_;
                            let _e4818 = phi_3507_;
                            let _e4820 = phi_3508_;
                            let _e4822 = phi_3509_;
                            let _e4824 = phi_3510_;
                            let _e4826 = phi_3511_;
                            let _e4828 = phi_3512_;
                            local_25 = _e4820;
                            local_43 = _e4816;
                            local_45 = _e4822;
                            local_46 = _e4824;
                            local_47 = _e4826;
                            local_48 = _e4828;
                            continue;
                            continuing {
                                phi_1834_ = _e3780;
                                phi_1837_ = _e4806;
                                phi_1839_ = _e4808;
                                phi_1841_ = _e4810;
                                phi_1843_ = _e4812;
                                phi_1845_ = _e4814;
                                break if !(_e4818);
                            }
                        }
                        let _e4831 = local_25;
                        if _e4831 {
                            let _e6184 = local_43;
                            phi_3516_ = _e6184;
                            phi_3517_ = true;
                            phi_3518_ = false;
                            phi_3519_ = false;
                            phi_3520_ = false;
                        } else {
                            let _e6186 = local_44;
                            phi_3516_ = _e6186;
                            let _e6189 = local_45;
                            phi_3517_ = _e6189;
                            let _e6192 = local_46;
                            phi_3518_ = _e6192;
                            let _e6195 = local_47;
                            phi_3519_ = _e6195;
                            let _e6198 = local_48;
                            phi_3520_ = _e6198;
                        }
                        let _e4833 = phi_3516_;
                        let _e4835 = phi_3517_;
                        let _e4837 = phi_3518_;
                        let _e4839 = phi_3519_;
                        let _e4841 = phi_3520_;
                        if _e4835 {
                            phi_3525_ = type_30(1u, _e4833);
                            phi_3526_ = false;
                            phi_3527_ = false;
                            phi_3528_ = false;
                        } else {
                            phi_3525_ = type_30();
                            phi_3526_ = _e4837;
                            phi_3527_ = _e4839;
                            phi_3528_ = _e4841;
                        }
                        let _e4844 = phi_3525_;
                        let _e4846 = phi_3526_;
                        let _e4848 = phi_3527_;
                        let _e4850 = phi_3528_;
                        if _e4846 {
                            let _e4852 = local_26;
                            phi_3533_ = type_30(1u, _e4852);
                            phi_3534_ = false;
                            phi_3535_ = false;
                        } else {
                            phi_3533_ = type_30();
                            phi_3534_ = _e4848;
                            phi_3535_ = _e4850;
                        }
                        let _e4855 = phi_3533_;
                        let _e4857 = phi_3534_;
                        let _e4859 = phi_3535_;
                        if _e4857 {
                            phi_3540_ = type_30(0u, type_30().member_1);
                            phi_3541_ = false;
                            phi_3542_ = true;
                        } else {
                            phi_3540_ = _e4855;
                            phi_3541_ = _e4859;
                            phi_3542_ = _e4846;
                        }
                        let _e4863 = phi_3540_;
                        let _e4865 = phi_3541_;
                        let _e4867 = phi_3542_;
                        if _e4865 {
                            phi_3547_ = type_30(0u, type_30().member_1);
                            phi_3548_ = true;
                        } else {
                            phi_3547_ = _e4863;
                            phi_3548_ = _e4867;
                        }
                        let _e4871 = phi_3547_;
                        let _e4873 = phi_3548_;
                        if _e4873 {
                            phi_3552_ = _e4871;
                        } else {
                            phi_3552_ = _e4844;
                        }
                        let _e4875 = phi_3552_;
                        if (_e4875.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_3566_ = type_9(0u, 3u);
                            loop {
                                let _e4887 = phi_3566_;
                                if (_e4887.member < _e4887.member_1) {
                                    phi_3567_ = type_9((_e4887.member + 1u), _e4887.member_1);
                                    phi_3590_ = type_9(1u, _e4887.member);
                                } else {
                                    phi_3567_ = _e4887;
                                    phi_3590_ = type_9(0u, type_9().member_1);
                                }
                                let _e4899 = phi_3567_;
                                let _e4901 = phi_3590_;
                                if (bitcast<i32>(_e4901.member) != 0i) {
                                    let _e4907 = local_11[_e4901.member_1];
                                    let _e4908 = (_e4875.member_1 + _e4907);
                                    if (_e4908 < 1f) {
                                        phi_3610_ = _e4908;
                                    } else {
                                        phi_3610_ = 1f;
                                    }
                                    let _e4911 = phi_3610_;
                                    let _e4914 = local_12.member[0u];
                                    let _e4920 = local_12.member[1u];
                                    let _e4936 = local_12.member_1[0u];
                                    let _e4942 = local_12.member_1[1u];
                                    let _e4958 = local_12.member_2[0u];
                                    let _e4964 = local_12.member_2[1u];
                                    let _e4978 = function_2(array<f32, 3>((_e4914[0] + ((_e4920[0] - _e4914[0]) * _e4911)), (_e4914[1] + ((_e4920[1] - _e4914[1]) * _e4911)), (_e4914[2] + ((_e4920[2] - _e4914[2]) * _e4911))), array<f32, 3>((_e4936[0] + ((_e4942[0] - _e4936[0]) * _e4911)), (_e4936[1] + ((_e4942[1] - _e4936[1]) * _e4911)), (_e4936[2] + ((_e4942[2] - _e4936[2]) * _e4911))), array<f32, 3>((_e4958[0] + ((_e4964[0] - _e4958[0]) * _e4911)), (_e4958[1] + ((_e4964[1] - _e4958[1]) * _e4911)), (_e4958[2] + ((_e4964[2] - _e4958[2]) * _e4911))), 1u);
                                    let _e4989 = (((_e4978[0] * _e4978[0]) + (_e4978[1] * _e4978[1])) + (_e4978[2] * _e4978[2]));
                                    if (_e4989 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e4989 > 0f) {
                                            phi_3733_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3733_ = 0f;
                                        }
                                        let _e5042 = phi_3733_;
                                        phi_3797_ = _e5042;
                                    } else {
                                        phi_3740_ = type_14(0i, 5i);
                                        phi_3743_ = bitcast<f32>(((bitcast<u32>(_e4989) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e4997 = phi_3740_;
                                            let _e4999 = phi_3743_;
                                            local_27 = _e4999;
                                            if (_e4997.member < _e4997.member_1) {
                                                let _e5006 = (_e4997.member + 1i);
                                                if ((false == (_e5006 > _e4997.member)) != false) {
                                                    phi_3764_ = true;
                                                } else {
                                                    phi_3764_ = false;
                                                }
                                                let _e5011 = phi_3764_;
                                                if _e5011 {
                                                    phi_3770_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3770_ = type_15(1u, _e5006);
                                                }
                                                let _e5016 = phi_3770_;
                                                phi_3741_ = type_14(_e5016.member_1, _e4997.member_1);
                                                phi_3784_ = type_15(1u, _e4997.member);
                                            } else {
                                                phi_3741_ = _e4997;
                                                phi_3784_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e5022 = phi_3741_;
                                            let _e5024 = phi_3784_;
                                            let _e5027 = (bitcast<i32>(_e5024.member) != 0i);
                                            if _e5027 {
                                                phi_3744_ = (0.5f * (_e4999 + (_e4989 / _e4999)));
                                            } else {
                                                phi_3744_ = f32();
                                            }
                                            let _e5032 = phi_3744_;
                                            continue;
                                            continuing {
                                                phi_3740_ = _e5022;
                                                phi_3743_ = _e5032;
                                                break if !(_e5027);
                                            }
                                        }
                                        let _e5037 = local_27;
                                        phi_3797_ = (_e5037 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e5044 = phi_3797_;
                                    let _e5050 = local_12.member[0u];
                                    if (_e5050[0] < 0f) {
                                        phi_3813_ = -(_e5050[0]);
                                    } else {
                                        phi_3813_ = _e5050[0];
                                    }
                                    let _e5057 = phi_3813_;
                                    if (_e5050[1] < 0f) {
                                        phi_3820_ = -(_e5050[1]);
                                    } else {
                                        phi_3820_ = _e5050[1];
                                    }
                                    let _e5061 = phi_3820_;
                                    if (_e5057 > _e5061) {
                                        phi_3825_ = _e5057;
                                    } else {
                                        phi_3825_ = _e5061;
                                    }
                                    let _e5064 = phi_3825_;
                                    if (_e5050[2] < 0f) {
                                        phi_3832_ = -(_e5050[2]);
                                    } else {
                                        phi_3832_ = _e5050[2];
                                    }
                                    let _e5068 = phi_3832_;
                                    if (_e5064 > _e5068) {
                                        phi_3837_ = _e5064;
                                    } else {
                                        phi_3837_ = _e5068;
                                    }
                                    let _e5071 = phi_3837_;
                                    let _e5074 = local_12.member[1u];
                                    if (_e5074[0] < 0f) {
                                        phi_3850_ = -(_e5074[0]);
                                    } else {
                                        phi_3850_ = _e5074[0];
                                    }
                                    let _e5081 = phi_3850_;
                                    if (_e5074[1] < 0f) {
                                        phi_3857_ = -(_e5074[1]);
                                    } else {
                                        phi_3857_ = _e5074[1];
                                    }
                                    let _e5085 = phi_3857_;
                                    if (_e5081 > _e5085) {
                                        phi_3862_ = _e5081;
                                    } else {
                                        phi_3862_ = _e5085;
                                    }
                                    let _e5088 = phi_3862_;
                                    if (_e5074[2] < 0f) {
                                        phi_3869_ = -(_e5074[2]);
                                    } else {
                                        phi_3869_ = _e5074[2];
                                    }
                                    let _e5092 = phi_3869_;
                                    if (_e5088 > _e5092) {
                                        phi_3874_ = _e5088;
                                    } else {
                                        phi_3874_ = _e5092;
                                    }
                                    let _e5095 = phi_3874_;
                                    if (_e5071 > _e5095) {
                                        phi_3879_ = _e5071;
                                    } else {
                                        phi_3879_ = _e5095;
                                    }
                                    let _e5098 = phi_3879_;
                                    let _e5100 = local_12.member_3;
                                    let _e5104 = local_12.member_1[0u];
                                    if (_e5104[0] < 0f) {
                                        phi_3896_ = -(_e5104[0]);
                                    } else {
                                        phi_3896_ = _e5104[0];
                                    }
                                    let _e5111 = phi_3896_;
                                    if (_e5104[1] < 0f) {
                                        phi_3903_ = -(_e5104[1]);
                                    } else {
                                        phi_3903_ = _e5104[1];
                                    }
                                    let _e5115 = phi_3903_;
                                    if (_e5111 > _e5115) {
                                        phi_3908_ = _e5111;
                                    } else {
                                        phi_3908_ = _e5115;
                                    }
                                    let _e5118 = phi_3908_;
                                    if (_e5104[2] < 0f) {
                                        phi_3915_ = -(_e5104[2]);
                                    } else {
                                        phi_3915_ = _e5104[2];
                                    }
                                    let _e5122 = phi_3915_;
                                    if (_e5118 > _e5122) {
                                        phi_3920_ = _e5118;
                                    } else {
                                        phi_3920_ = _e5122;
                                    }
                                    let _e5125 = phi_3920_;
                                    let _e5128 = local_12.member_1[1u];
                                    if (_e5128[0] < 0f) {
                                        phi_3934_ = -(_e5128[0]);
                                    } else {
                                        phi_3934_ = _e5128[0];
                                    }
                                    let _e5135 = phi_3934_;
                                    if (_e5128[1] < 0f) {
                                        phi_3941_ = -(_e5128[1]);
                                    } else {
                                        phi_3941_ = _e5128[1];
                                    }
                                    let _e5139 = phi_3941_;
                                    if (_e5135 > _e5139) {
                                        phi_3946_ = _e5135;
                                    } else {
                                        phi_3946_ = _e5139;
                                    }
                                    let _e5142 = phi_3946_;
                                    if (_e5128[2] < 0f) {
                                        phi_3953_ = -(_e5128[2]);
                                    } else {
                                        phi_3953_ = _e5128[2];
                                    }
                                    let _e5146 = phi_3953_;
                                    if (_e5142 > _e5146) {
                                        phi_3958_ = _e5142;
                                    } else {
                                        phi_3958_ = _e5146;
                                    }
                                    let _e5149 = phi_3958_;
                                    if (_e5125 > _e5149) {
                                        phi_3963_ = _e5125;
                                    } else {
                                        phi_3963_ = _e5149;
                                    }
                                    let _e5152 = phi_3963_;
                                    let _e5154 = local_12.member_3;
                                    let _e5158 = local_12.member_2[0u];
                                    if (_e5158[0] < 0f) {
                                        phi_3980_ = -(_e5158[0]);
                                    } else {
                                        phi_3980_ = _e5158[0];
                                    }
                                    let _e5165 = phi_3980_;
                                    if (_e5158[1] < 0f) {
                                        phi_3987_ = -(_e5158[1]);
                                    } else {
                                        phi_3987_ = _e5158[1];
                                    }
                                    let _e5169 = phi_3987_;
                                    if (_e5165 > _e5169) {
                                        phi_3992_ = _e5165;
                                    } else {
                                        phi_3992_ = _e5169;
                                    }
                                    let _e5172 = phi_3992_;
                                    if (_e5158[2] < 0f) {
                                        phi_3999_ = -(_e5158[2]);
                                    } else {
                                        phi_3999_ = _e5158[2];
                                    }
                                    let _e5176 = phi_3999_;
                                    if (_e5172 > _e5176) {
                                        phi_4004_ = _e5172;
                                    } else {
                                        phi_4004_ = _e5176;
                                    }
                                    let _e5179 = phi_4004_;
                                    let _e5182 = local_12.member_2[1u];
                                    if (_e5182[0] < 0f) {
                                        phi_4018_ = -(_e5182[0]);
                                    } else {
                                        phi_4018_ = _e5182[0];
                                    }
                                    let _e5189 = phi_4018_;
                                    if (_e5182[1] < 0f) {
                                        phi_4025_ = -(_e5182[1]);
                                    } else {
                                        phi_4025_ = _e5182[1];
                                    }
                                    let _e5193 = phi_4025_;
                                    if (_e5189 > _e5193) {
                                        phi_4030_ = _e5189;
                                    } else {
                                        phi_4030_ = _e5193;
                                    }
                                    let _e5196 = phi_4030_;
                                    if (_e5182[2] < 0f) {
                                        phi_4037_ = -(_e5182[2]);
                                    } else {
                                        phi_4037_ = _e5182[2];
                                    }
                                    let _e5200 = phi_4037_;
                                    if (_e5196 > _e5200) {
                                        phi_4042_ = _e5196;
                                    } else {
                                        phi_4042_ = _e5200;
                                    }
                                    let _e5203 = phi_4042_;
                                    if (_e5179 > _e5203) {
                                        phi_4047_ = _e5179;
                                    } else {
                                        phi_4047_ = _e5203;
                                    }
                                    let _e5206 = phi_4047_;
                                    let _e5208 = local_12.member_3;
                                    let _e5215 = local_12.member_3;
                                    let _e5222 = (((_e5044 * (1f + (0.000000059604645f * 8f))) + (((((((_e5098 + _e5100) + (_e5152 + _e5154)) + (_e5206 + _e5208)) * (0.000000059604645f * 16f)) + (_e5215 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e455.member_1);
                                    if _e5222 {
                                        phi_4067_ = false;
                                    } else {
                                        phi_4067_ = true;
                                    }
                                    let _e5224 = phi_4067_;
                                    phi_4068_ = _e5224;
                                    phi_4069_ = _e5222;
                                } else {
                                    phi_4068_ = false;
                                    phi_4069_ = false;
                                }
                                let _e5226 = phi_4068_;
                                let _e5228 = phi_4069_;
                                local_28 = _e5228;
                                continue;
                                continuing {
                                    phi_3566_ = _e4899;
                                    break if !(_e5226);
                                }
                            }
                            let _e5231 = local_28;
                            if _e5231 {
                                phi_4074_ = type_30(1u, _e4875.member_1);
                                phi_4075_ = false;
                            } else {
                                phi_4074_ = type_30();
                                phi_4075_ = true;
                            }
                            let _e5234 = phi_4074_;
                            let _e5236 = phi_4075_;
                            if _e5236 {
                                phi_4080_ = type_30(2u, _e4875.member_1);
                                phi_4081_ = false;
                            } else {
                                phi_4080_ = type_30();
                                phi_4081_ = true;
                            }
                            let _e5239 = phi_4080_;
                            let _e5241 = phi_4081_;
                            phi_4083_ = _e5239;
                            phi_4084_ = _e5234;
                            phi_4085_ = _e5241;
                        } else {
                            phi_4083_ = type_30();
                            phi_4084_ = type_30(0u, type_30().member_1);
                            phi_4085_ = true;
                        }
                        let _e5243 = phi_4083_;
                        let _e5245 = phi_4084_;
                        let _e5247 = phi_4085_;
                        if _e5247 {
                            phi_4089_ = _e5245;
                        } else {
                            phi_4089_ = _e5243;
                        }
                        let _e5249 = phi_4089_;
                        phi_8025_ = _e5249;
                    } else {
                        if (_e593 < 0f) {
                            phi_4099_ = -(_e593);
                        } else {
                            phi_4099_ = _e593;
                        }
                        let _e936 = phi_4099_;
                        if (_e616 < 0f) {
                            phi_4105_ = -(_e616);
                        } else {
                            phi_4105_ = _e616;
                        }
                        let _e940 = phi_4105_;
                        if (_e936 > _e940) {
                            phi_4110_ = _e936;
                        } else {
                            phi_4110_ = _e940;
                        }
                        let _e943 = phi_4110_;
                        if (_e639 < 0f) {
                            phi_4116_ = -(_e639);
                        } else {
                            phi_4116_ = _e639;
                        }
                        let _e947 = phi_4116_;
                        if (_e650 < 0f) {
                            phi_4122_ = -(_e650);
                        } else {
                            phi_4122_ = _e650;
                        }
                        let _e951 = phi_4122_;
                        if (_e947 > _e951) {
                            phi_4127_ = _e947;
                        } else {
                            phi_4127_ = _e951;
                        }
                        let _e954 = phi_4127_;
                        if (_e943 > _e954) {
                            phi_4132_ = _e943;
                        } else {
                            phi_4132_ = _e954;
                        }
                        let _e957 = phi_4132_;
                        let _e958 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e957 >= _e958) {
                            phi_4140_ = (_e957 <= (1f / _e958));
                        } else {
                            phi_4140_ = false;
                        }
                        let _e963 = phi_4140_;
                        if _e963 {
                            phi_4145_ = (0.000000059604645f * 256f);
                        } else {
                            phi_4145_ = 2f;
                        }
                        let _e966 = phi_4145_;
                        let _e968 = ((_e900 * 0.34f) + (_e957 * _e966));
                        if _e963 {
                            phi_4152_ = (1f / _e957);
                        } else {
                            phi_4152_ = 0f;
                        }
                        let _e971 = phi_4152_;
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
                                    phi_4185_ = (0.000000000000000000106433627f * 2f);
                                } else {
                                    phi_4185_ = 0f;
                                }
                                let _e1040 = phi_4185_;
                                phi_4249_ = _e1040;
                            } else {
                                phi_4192_ = type_14(0i, 5i);
                                phi_4195_ = bitcast<f32>(((bitcast<u32>(_e986) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e995 = phi_4192_;
                                    let _e997 = phi_4195_;
                                    local_13 = _e997;
                                    if (_e995.member < _e995.member_1) {
                                        let _e1004 = (_e995.member + 1i);
                                        if ((false == (_e1004 > _e995.member)) != false) {
                                            phi_4216_ = true;
                                        } else {
                                            phi_4216_ = false;
                                        }
                                        let _e1009 = phi_4216_;
                                        if _e1009 {
                                            phi_4222_ = type_15(0u, type_15().member_1);
                                        } else {
                                            phi_4222_ = type_15(1u, _e1004);
                                        }
                                        let _e1014 = phi_4222_;
                                        phi_4193_ = type_14(_e1014.member_1, _e995.member_1);
                                        phi_4236_ = type_15(1u, _e995.member);
                                    } else {
                                        phi_4193_ = _e995;
                                        phi_4236_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e1020 = phi_4193_;
                                    let _e1022 = phi_4236_;
                                    let _e1025 = (bitcast<i32>(_e1022.member) != 0i);
                                    if _e1025 {
                                        phi_4196_ = (0.5f * (_e997 + (_e986 / _e997)));
                                    } else {
                                        phi_4196_ = f32();
                                    }
                                    let _e1030 = phi_4196_;
                                    continue;
                                    continuing {
                                        phi_4192_ = _e1020;
                                        phi_4195_ = _e1030;
                                        break if !(_e1025);
                                    }
                                }
                                let _e1035 = local_13;
                                phi_4249_ = (_e1035 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e1042 = phi_4249_;
                            if (_e978 < 0f) {
                                phi_4255_ = -(_e1042);
                            } else {
                                phi_4255_ = _e1042;
                            }
                            let _e1046 = phi_4255_;
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
                            phi_4280_ = type_9(0u, 2u);
                            phi_4283_ = 1u;
                            loop {
                                let _e1067 = phi_4280_;
                                let _e1069 = phi_4283_;
                                local_29 = _e1069;
                                if (_e1067.member < _e1067.member_1) {
                                    phi_4281_ = type_9((_e1067.member + 1u), _e1067.member_1);
                                    phi_4306_ = type_9(1u, _e1067.member);
                                } else {
                                    phi_4281_ = _e1067;
                                    phi_4306_ = type_9(0u, type_9().member_1);
                                }
                                let _e1081 = phi_4281_;
                                let _e1083 = phi_4306_;
                                let _e1087 = (bitcast<i32>(_e1083.member) != 0i);
                                if _e1087 {
                                    let _e1089 = local_7[_e1083.member_1];
                                    if (_e1089 > 0f) {
                                        let _e1092 = local_7[_e1083.member_1];
                                        if (_e1092 < 1f) {
                                            let _e1095 = local_7[_e1083.member_1];
                                            local_6[_e1069] = _e1095;
                                            phi_4350_ = (_e1069 + 1u);
                                        } else {
                                            phi_4350_ = _e1069;
                                        }
                                        let _e1099 = phi_4350_;
                                        phi_4351_ = _e1099;
                                    } else {
                                        phi_4351_ = _e1069;
                                    }
                                    let _e1101 = phi_4351_;
                                    phi_4284_ = _e1101;
                                } else {
                                    phi_4284_ = u32();
                                }
                                let _e1103 = phi_4284_;
                                continue;
                                continuing {
                                    phi_4280_ = _e1081;
                                    phi_4283_ = _e1103;
                                    break if !(_e1087);
                                }
                            }
                            let _e5509 = local_29;
                            phi_4352_ = _e5509;
                        } else {
                            phi_4352_ = 1u;
                        }
                        let _e1106 = phi_4352_;
                        local_6[_e1106] = 1f;
                        let _e1108 = local_6;
                        local_8 = _e1108;
                        phi_4372_ = type_9(0u, _e1106);
                        loop {
                            let _e1111 = phi_4372_;
                            if (_e1111.member < _e1111.member_1) {
                                phi_4373_ = type_9((_e1111.member + 1u), _e1111.member_1);
                                phi_4396_ = type_9(1u, _e1111.member);
                            } else {
                                phi_4373_ = _e1111;
                                phi_4396_ = type_9(0u, type_9().member_1);
                            }
                            let _e1123 = phi_4373_;
                            let _e1125 = phi_4396_;
                            if (bitcast<i32>(_e1125.member) != 0i) {
                                let _e1131 = local_8[_e1125.member_1];
                                let _e1134 = local_8[(_e1125.member_1 + 1u)];
                                let _e1135 = (1f - _e1131);
                                let _e1146 = ((((_e593 * _e1135) + (_e616 * _e1131)) * (_e1135 * _e1135)) + (((_e639 * _e1135) + (_e650 * _e1131)) * (_e1131 * _e1131)));
                                let _e1147 = (1f - _e1134);
                                let _e1158 = ((((_e593 * _e1147) + (_e616 * _e1134)) * (_e1147 * _e1147)) + (((_e639 * _e1147) + (_e650 * _e1134)) * (_e1134 * _e1134)));
                                if (_e1146 < 0f) {
                                    phi_4448_ = -(_e1146);
                                } else {
                                    phi_4448_ = _e1146;
                                }
                                let _e1162 = phi_4448_;
                                let _e1163 = (_e1162 > _e968);
                                if (_e1158 < 0f) {
                                    phi_4455_ = -(_e1158);
                                } else {
                                    phi_4455_ = _e1158;
                                }
                                let _e1167 = phi_4455_;
                                let _e1168 = (_e1167 > _e968);
                                if _e1163 {
                                    if _e1168 {
                                        phi_4466_ = ((_e1146 > 0f) != (_e1158 > 0f));
                                        phi_4467_ = false;
                                    } else {
                                        phi_4466_ = bool();
                                        phi_4467_ = true;
                                    }
                                    let _e1173 = phi_4466_;
                                    let _e1175 = phi_4467_;
                                    phi_4468_ = _e1173;
                                    phi_4469_ = _e1175;
                                } else {
                                    phi_4468_ = bool();
                                    phi_4469_ = true;
                                }
                                let _e1177 = phi_4468_;
                                let _e1179 = phi_4469_;
                                if _e1179 {
                                    phi_4473_ = false;
                                } else {
                                    phi_4473_ = _e1177;
                                }
                                let _e1181 = phi_4473_;
                                if _e1163 {
                                    if _e1168 {
                                        if _e1181 {
                                            phi_4484_ = type_37();
                                        } else {
                                            phi_4484_ = type_37(1f, 0f, _e1181);
                                        }
                                        let _e1184 = phi_4484_;
                                        phi_4485_ = _e1184;
                                        phi_4486_ = _e1181;
                                    } else {
                                        phi_4485_ = type_37();
                                        phi_4486_ = true;
                                    }
                                    let _e1186 = phi_4485_;
                                    let _e1188 = phi_4486_;
                                    phi_4487_ = _e1186;
                                    phi_4488_ = _e1188;
                                } else {
                                    phi_4487_ = type_37();
                                    phi_4488_ = true;
                                }
                                let _e1190 = phi_4487_;
                                let _e1192 = phi_4488_;
                                if _e1192 {
                                    if _e1163 {
                                        if (_e1146 < 0f) {
                                            phi_4499_ = -1f;
                                        } else {
                                            phi_4499_ = 1f;
                                        }
                                        let _e1195 = phi_4499_;
                                        let _e1198 = (_e639 - _e616);
                                        phi_4509_ = type_9(0u, 64u);
                                        phi_4512_ = _e1134;
                                        phi_4514_ = _e1131;
                                        phi_4516_ = (0.5f * (_e1131 + _e1134));
                                        loop {
                                            let _e1204 = phi_4509_;
                                            let _e1206 = phi_4512_;
                                            let _e1208 = phi_4514_;
                                            let _e1210 = phi_4516_;
                                            local_31 = _e1208;
                                            if (_e1204.member < _e1204.member_1) {
                                                phi_4510_ = type_9((_e1204.member + 1u), _e1204.member_1);
                                                phi_4539_ = type_9(1u, _e1204.member);
                                            } else {
                                                phi_4510_ = _e1204;
                                                phi_4539_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1222 = phi_4510_;
                                            let _e1224 = phi_4539_;
                                            if (bitcast<i32>(_e1224.member) != 0i) {
                                                let _e1228 = (1f - _e1210);
                                                let _e1241 = ((_e1195 * ((((_e593 * _e1228) + (_e616 * _e1210)) * (_e1228 * _e1228)) + (((_e639 * _e1228) + (_e650 * _e1210)) * (_e1210 * _e1210)))) - _e968);
                                                if (_e1241 > 0f) {
                                                    phi_4564_ = _e1206;
                                                    phi_4565_ = _e1210;
                                                } else {
                                                    phi_4564_ = _e1210;
                                                    phi_4565_ = _e1208;
                                                }
                                                let _e1244 = phi_4564_;
                                                let _e1246 = phi_4565_;
                                                let _e1248 = ((_e1244 - _e1246) > 0.00000000000022737368f);
                                                if _e1248 {
                                                    let _e1249 = (1f - _e1210);
                                                    let _e1261 = (-(_e1241) / (_e1195 * (((((_e616 - (3f * _e593)) * _e1249) + (_e1198 * _e1210)) * _e1249) + (((_e1198 * _e1249) + (((3f * _e650) - _e639) * _e1210)) * _e1210))));
                                                    if (_e1241 > 0f) {
                                                        phi_4591_ = (0.5f * 0.00000000000022737368f);
                                                    } else {
                                                        phi_4591_ = -((0.5f * 0.00000000000022737368f));
                                                    }
                                                    let _e1267 = phi_4591_;
                                                    let _e1269 = ((_e1210 + _e1261) + _e1267);
                                                    if (_e1269 > _e1246) {
                                                        if (_e1269 < _e1244) {
                                                            if (_e1261 < 0f) {
                                                                phi_4607_ = -(_e1261);
                                                            } else {
                                                                phi_4607_ = _e1261;
                                                            }
                                                            let _e1275 = phi_4607_;
                                                            if (_e1275 < (0.5f * (_e1244 - _e1246))) {
                                                                phi_4614_ = false;
                                                            } else {
                                                                phi_4614_ = true;
                                                            }
                                                            let _e1280 = phi_4614_;
                                                            phi_4615_ = _e1280;
                                                        } else {
                                                            phi_4615_ = true;
                                                        }
                                                        let _e1282 = phi_4615_;
                                                        phi_4616_ = _e1282;
                                                    } else {
                                                        phi_4616_ = true;
                                                    }
                                                    let _e1284 = phi_4616_;
                                                    if _e1284 {
                                                        phi_4622_ = (0.5f * (_e1246 + _e1244));
                                                    } else {
                                                        phi_4622_ = _e1269;
                                                    }
                                                    let _e1288 = phi_4622_;
                                                    phi_4623_ = _e1288;
                                                    phi_4624_ = false;
                                                } else {
                                                    phi_4623_ = f32();
                                                    phi_4624_ = true;
                                                }
                                                let _e1290 = phi_4623_;
                                                let _e1292 = phi_4624_;
                                                phi_4513_ = _e1244;
                                                phi_4515_ = _e1246;
                                                phi_4517_ = _e1290;
                                                phi_4625_ = _e1246;
                                                phi_4626_ = _e1248;
                                                phi_4627_ = _e1292;
                                            } else {
                                                phi_4513_ = f32();
                                                phi_4515_ = f32();
                                                phi_4517_ = f32();
                                                phi_4625_ = f32();
                                                phi_4626_ = false;
                                                phi_4627_ = false;
                                            }
                                            let _e1294 = phi_4513_;
                                            let _e1296 = phi_4515_;
                                            let _e1298 = phi_4517_;
                                            let _e1300 = phi_4625_;
                                            let _e1302 = phi_4626_;
                                            let _e1304 = phi_4627_;
                                            local_14 = _e1304;
                                            local_30 = _e1300;
                                            continue;
                                            continuing {
                                                phi_4509_ = _e1222;
                                                phi_4512_ = _e1294;
                                                phi_4514_ = _e1296;
                                                phi_4516_ = _e1298;
                                                break if !(_e1302);
                                            }
                                        }
                                        let _e1307 = local_14;
                                        if _e1307 {
                                            let _e5551 = local_30;
                                            phi_4631_ = _e5551;
                                        } else {
                                            let _e5553 = local_31;
                                            phi_4631_ = _e5553;
                                        }
                                        let _e1309 = phi_4631_;
                                        phi_4632_ = _e1309;
                                    } else {
                                        phi_4632_ = _e1131;
                                    }
                                    let _e1311 = phi_4632_;
                                    if _e1168 {
                                        if (_e1158 < 0f) {
                                            phi_4640_ = -1f;
                                        } else {
                                            phi_4640_ = 1f;
                                        }
                                        let _e1314 = phi_4640_;
                                        phi_4644_ = type_9(0u, 64u);
                                        phi_4647_ = (2f * 0.00000000000022737368f);
                                        loop {
                                            let _e1317 = phi_4644_;
                                            let _e1319 = phi_4647_;
                                            if (_e1317.member < _e1317.member_1) {
                                                phi_4645_ = type_9((_e1317.member + 1u), _e1317.member_1);
                                                phi_4670_ = type_9(1u, _e1317.member);
                                            } else {
                                                phi_4645_ = _e1317;
                                                phi_4670_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1331 = phi_4645_;
                                            let _e1333 = phi_4670_;
                                            if (bitcast<i32>(_e1333.member) != 0i) {
                                                let _e1337 = (_e1311 + _e1319);
                                                if (_e1337 < _e1134) {
                                                    let _e1339 = (1f - _e1337);
                                                    let _e1352 = ((_e1314 * ((((_e593 * _e1339) + (_e616 * _e1337)) * (_e1339 * _e1339)) + (((_e639 * _e1339) + (_e650 * _e1337)) * (_e1337 * _e1337)))) > _e968);
                                                    if _e1352 {
                                                        phi_4700_ = f32();
                                                        phi_4701_ = false;
                                                    } else {
                                                        phi_4700_ = (_e1319 + _e1319);
                                                        phi_4701_ = true;
                                                    }
                                                    let _e1355 = phi_4700_;
                                                    let _e1357 = phi_4701_;
                                                    phi_4702_ = _e1355;
                                                    phi_4703_ = _e1357;
                                                    phi_4704_ = _e1352;
                                                    phi_4705_ = false;
                                                } else {
                                                    phi_4702_ = f32();
                                                    phi_4703_ = false;
                                                    phi_4704_ = false;
                                                    phi_4705_ = true;
                                                }
                                                let _e1359 = phi_4702_;
                                                let _e1361 = phi_4703_;
                                                let _e1363 = phi_4704_;
                                                let _e1365 = phi_4705_;
                                                phi_4706_ = _e1337;
                                                phi_4648_ = _e1359;
                                                phi_4707_ = _e1361;
                                                phi_4708_ = _e1363;
                                                phi_4709_ = _e1365;
                                                phi_4710_ = false;
                                            } else {
                                                phi_4706_ = f32();
                                                phi_4648_ = f32();
                                                phi_4707_ = false;
                                                phi_4708_ = false;
                                                phi_4709_ = false;
                                                phi_4710_ = true;
                                            }
                                            let _e1367 = phi_4706_;
                                            let _e1369 = phi_4648_;
                                            let _e1371 = phi_4707_;
                                            let _e1373 = phi_4708_;
                                            let _e1375 = phi_4709_;
                                            let _e1377 = phi_4710_;
                                            local_15 = _e1373;
                                            local_32 = _e1375;
                                            local_33 = _e1377;
                                            local_34 = _e1367;
                                            continue;
                                            continuing {
                                                phi_4644_ = _e1331;
                                                phi_4647_ = _e1369;
                                                break if !(_e1371);
                                            }
                                        }
                                        let _e1380 = local_15;
                                        if _e1380 {
                                            phi_4714_ = false;
                                            phi_4715_ = false;
                                        } else {
                                            let _e5575 = local_32;
                                            phi_4714_ = _e5575;
                                            let _e5578 = local_33;
                                            phi_4715_ = _e5578;
                                        }
                                        let _e1382 = phi_4714_;
                                        let _e1384 = phi_4715_;
                                        if _e1382 {
                                            phi_4719_ = true;
                                        } else {
                                            phi_4719_ = _e1384;
                                        }
                                        let _e1386 = phi_4719_;
                                        if _e1386 {
                                            phi_4723_ = _e1134;
                                        } else {
                                            let _e5582 = local_34;
                                            phi_4723_ = _e5582;
                                        }
                                        let _e1388 = phi_4723_;
                                        phi_4724_ = _e1388;
                                    } else {
                                        phi_4724_ = _e1134;
                                    }
                                    let _e1390 = phi_4724_;
                                    phi_4726_ = type_37(_e1311, _e1390, _e1181);
                                } else {
                                    phi_4726_ = _e1190;
                                }
                                let _e1393 = phi_4726_;
                                if (_e1393.member > _e1393.member_1) {
                                    phi_7981_ = f32();
                                    phi_7982_ = true;
                                    phi_7983_ = false;
                                    phi_7984_ = false;
                                    phi_7985_ = false;
                                } else {
                                    let _e1400 = ((_e1393.member_1 - _e1393.member) * 0.5f);
                                    let _e1401 = (_e1393.member + _e1400);
                                    let _e1403 = (_e1400 + (0.000000059604645f * 4f));
                                    let _e1405 = local_12.member_3;
                                    let _e1408 = local_12.member[0u];
                                    if (_e1408[0] < 0f) {
                                        phi_4755_ = -(_e1408[0]);
                                    } else {
                                        phi_4755_ = _e1408[0];
                                    }
                                    let _e1415 = phi_4755_;
                                    if (_e1408[1] < 0f) {
                                        phi_4762_ = -(_e1408[1]);
                                    } else {
                                        phi_4762_ = _e1408[1];
                                    }
                                    let _e1419 = phi_4762_;
                                    if (_e1415 > _e1419) {
                                        phi_4767_ = _e1415;
                                    } else {
                                        phi_4767_ = _e1419;
                                    }
                                    let _e1422 = phi_4767_;
                                    if (_e1408[2] < 0f) {
                                        phi_4774_ = -(_e1408[2]);
                                    } else {
                                        phi_4774_ = _e1408[2];
                                    }
                                    let _e1426 = phi_4774_;
                                    if (_e1422 > _e1426) {
                                        phi_4779_ = _e1422;
                                    } else {
                                        phi_4779_ = _e1426;
                                    }
                                    let _e1429 = phi_4779_;
                                    let _e1431 = local_12.member[1u];
                                    if (_e1431[0] < 0f) {
                                        phi_4792_ = -(_e1431[0]);
                                    } else {
                                        phi_4792_ = _e1431[0];
                                    }
                                    let _e1438 = phi_4792_;
                                    if (_e1431[1] < 0f) {
                                        phi_4799_ = -(_e1431[1]);
                                    } else {
                                        phi_4799_ = _e1431[1];
                                    }
                                    let _e1442 = phi_4799_;
                                    if (_e1438 > _e1442) {
                                        phi_4804_ = _e1438;
                                    } else {
                                        phi_4804_ = _e1442;
                                    }
                                    let _e1445 = phi_4804_;
                                    if (_e1431[2] < 0f) {
                                        phi_4811_ = -(_e1431[2]);
                                    } else {
                                        phi_4811_ = _e1431[2];
                                    }
                                    let _e1449 = phi_4811_;
                                    if (_e1445 > _e1449) {
                                        phi_4816_ = _e1445;
                                    } else {
                                        phi_4816_ = _e1449;
                                    }
                                    let _e1452 = phi_4816_;
                                    if (_e1429 > _e1452) {
                                        phi_4821_ = _e1429;
                                    } else {
                                        phi_4821_ = _e1452;
                                    }
                                    let _e1455 = phi_4821_;
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
                                        phi_4880_ = -(_e1486);
                                    } else {
                                        phi_4880_ = _e1486;
                                    }
                                    let _e1492 = phi_4880_;
                                    if (_e1487 < 0f) {
                                        phi_4886_ = -(_e1487);
                                    } else {
                                        phi_4886_ = _e1487;
                                    }
                                    let _e1496 = phi_4886_;
                                    if (_e1492 > _e1496) {
                                        phi_4891_ = _e1492;
                                    } else {
                                        phi_4891_ = _e1496;
                                    }
                                    let _e1499 = phi_4891_;
                                    if (_e1488 < 0f) {
                                        phi_4897_ = -(_e1488);
                                    } else {
                                        phi_4897_ = _e1488;
                                    }
                                    let _e1503 = phi_4897_;
                                    if (_e1499 > _e1503) {
                                        phi_4902_ = _e1499;
                                    } else {
                                        phi_4902_ = _e1503;
                                    }
                                    let _e1506 = phi_4902_;
                                    let _e1512 = ((((_e1403 * _e1506) * 1.01f) + ((_e1455 + _e1405) * (0.000000059604645f * 8f))) + _e1405);
                                    if (_e1473 < 0f) {
                                        phi_4914_ = -(_e1473);
                                    } else {
                                        phi_4914_ = _e1473;
                                    }
                                    let _e1516 = phi_4914_;
                                    if (_e1474 < 0f) {
                                        phi_4920_ = -(_e1474);
                                    } else {
                                        phi_4920_ = _e1474;
                                    }
                                    let _e1520 = phi_4920_;
                                    if (_e1516 > _e1520) {
                                        phi_4925_ = _e1516;
                                    } else {
                                        phi_4925_ = _e1520;
                                    }
                                    let _e1523 = phi_4925_;
                                    if (_e1475 < 0f) {
                                        phi_4931_ = -(_e1475);
                                    } else {
                                        phi_4931_ = _e1475;
                                    }
                                    let _e1527 = phi_4931_;
                                    if (_e1523 > _e1527) {
                                        phi_4936_ = _e1523;
                                    } else {
                                        phi_4936_ = _e1527;
                                    }
                                    let _e1530 = phi_4936_;
                                    local_2 = type_26(array<f32, 3>(_e1473, _e1474, _e1475), _e1512, (_e1530 + _e1512));
                                    let _e1536 = local_12.member_3;
                                    let _e1538 = local_12.member_1[0u];
                                    if (_e1538[0] < 0f) {
                                        phi_4962_ = -(_e1538[0]);
                                    } else {
                                        phi_4962_ = _e1538[0];
                                    }
                                    let _e1545 = phi_4962_;
                                    if (_e1538[1] < 0f) {
                                        phi_4969_ = -(_e1538[1]);
                                    } else {
                                        phi_4969_ = _e1538[1];
                                    }
                                    let _e1549 = phi_4969_;
                                    if (_e1545 > _e1549) {
                                        phi_4974_ = _e1545;
                                    } else {
                                        phi_4974_ = _e1549;
                                    }
                                    let _e1552 = phi_4974_;
                                    if (_e1538[2] < 0f) {
                                        phi_4981_ = -(_e1538[2]);
                                    } else {
                                        phi_4981_ = _e1538[2];
                                    }
                                    let _e1556 = phi_4981_;
                                    if (_e1552 > _e1556) {
                                        phi_4986_ = _e1552;
                                    } else {
                                        phi_4986_ = _e1556;
                                    }
                                    let _e1559 = phi_4986_;
                                    let _e1561 = local_12.member_1[1u];
                                    if (_e1561[0] < 0f) {
                                        phi_4999_ = -(_e1561[0]);
                                    } else {
                                        phi_4999_ = _e1561[0];
                                    }
                                    let _e1568 = phi_4999_;
                                    if (_e1561[1] < 0f) {
                                        phi_5006_ = -(_e1561[1]);
                                    } else {
                                        phi_5006_ = _e1561[1];
                                    }
                                    let _e1572 = phi_5006_;
                                    if (_e1568 > _e1572) {
                                        phi_5011_ = _e1568;
                                    } else {
                                        phi_5011_ = _e1572;
                                    }
                                    let _e1575 = phi_5011_;
                                    if (_e1561[2] < 0f) {
                                        phi_5018_ = -(_e1561[2]);
                                    } else {
                                        phi_5018_ = _e1561[2];
                                    }
                                    let _e1579 = phi_5018_;
                                    if (_e1575 > _e1579) {
                                        phi_5023_ = _e1575;
                                    } else {
                                        phi_5023_ = _e1579;
                                    }
                                    let _e1582 = phi_5023_;
                                    if (_e1559 > _e1582) {
                                        phi_5028_ = _e1559;
                                    } else {
                                        phi_5028_ = _e1582;
                                    }
                                    let _e1585 = phi_5028_;
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
                                        phi_5087_ = -(_e1616);
                                    } else {
                                        phi_5087_ = _e1616;
                                    }
                                    let _e1622 = phi_5087_;
                                    if (_e1617 < 0f) {
                                        phi_5093_ = -(_e1617);
                                    } else {
                                        phi_5093_ = _e1617;
                                    }
                                    let _e1626 = phi_5093_;
                                    if (_e1622 > _e1626) {
                                        phi_5098_ = _e1622;
                                    } else {
                                        phi_5098_ = _e1626;
                                    }
                                    let _e1629 = phi_5098_;
                                    if (_e1618 < 0f) {
                                        phi_5104_ = -(_e1618);
                                    } else {
                                        phi_5104_ = _e1618;
                                    }
                                    let _e1633 = phi_5104_;
                                    if (_e1629 > _e1633) {
                                        phi_5109_ = _e1629;
                                    } else {
                                        phi_5109_ = _e1633;
                                    }
                                    let _e1636 = phi_5109_;
                                    let _e1642 = ((((_e1403 * _e1636) * 1.01f) + ((_e1585 + _e1536) * (0.000000059604645f * 8f))) + _e1536);
                                    if (_e1603 < 0f) {
                                        phi_5121_ = -(_e1603);
                                    } else {
                                        phi_5121_ = _e1603;
                                    }
                                    let _e1646 = phi_5121_;
                                    if (_e1604 < 0f) {
                                        phi_5127_ = -(_e1604);
                                    } else {
                                        phi_5127_ = _e1604;
                                    }
                                    let _e1650 = phi_5127_;
                                    if (_e1646 > _e1650) {
                                        phi_5132_ = _e1646;
                                    } else {
                                        phi_5132_ = _e1650;
                                    }
                                    let _e1653 = phi_5132_;
                                    if (_e1605 < 0f) {
                                        phi_5138_ = -(_e1605);
                                    } else {
                                        phi_5138_ = _e1605;
                                    }
                                    let _e1657 = phi_5138_;
                                    if (_e1653 > _e1657) {
                                        phi_5143_ = _e1653;
                                    } else {
                                        phi_5143_ = _e1657;
                                    }
                                    let _e1660 = phi_5143_;
                                    local_3 = type_26(array<f32, 3>(_e1603, _e1604, _e1605), _e1642, (_e1660 + _e1642));
                                    let _e1666 = local_12.member_3;
                                    let _e1668 = local_12.member_2[0u];
                                    if (_e1668[0] < 0f) {
                                        phi_5169_ = -(_e1668[0]);
                                    } else {
                                        phi_5169_ = _e1668[0];
                                    }
                                    let _e1675 = phi_5169_;
                                    if (_e1668[1] < 0f) {
                                        phi_5176_ = -(_e1668[1]);
                                    } else {
                                        phi_5176_ = _e1668[1];
                                    }
                                    let _e1679 = phi_5176_;
                                    if (_e1675 > _e1679) {
                                        phi_5181_ = _e1675;
                                    } else {
                                        phi_5181_ = _e1679;
                                    }
                                    let _e1682 = phi_5181_;
                                    if (_e1668[2] < 0f) {
                                        phi_5188_ = -(_e1668[2]);
                                    } else {
                                        phi_5188_ = _e1668[2];
                                    }
                                    let _e1686 = phi_5188_;
                                    if (_e1682 > _e1686) {
                                        phi_5193_ = _e1682;
                                    } else {
                                        phi_5193_ = _e1686;
                                    }
                                    let _e1689 = phi_5193_;
                                    let _e1691 = local_12.member_2[1u];
                                    if (_e1691[0] < 0f) {
                                        phi_5206_ = -(_e1691[0]);
                                    } else {
                                        phi_5206_ = _e1691[0];
                                    }
                                    let _e1698 = phi_5206_;
                                    if (_e1691[1] < 0f) {
                                        phi_5213_ = -(_e1691[1]);
                                    } else {
                                        phi_5213_ = _e1691[1];
                                    }
                                    let _e1702 = phi_5213_;
                                    if (_e1698 > _e1702) {
                                        phi_5218_ = _e1698;
                                    } else {
                                        phi_5218_ = _e1702;
                                    }
                                    let _e1705 = phi_5218_;
                                    if (_e1691[2] < 0f) {
                                        phi_5225_ = -(_e1691[2]);
                                    } else {
                                        phi_5225_ = _e1691[2];
                                    }
                                    let _e1709 = phi_5225_;
                                    if (_e1705 > _e1709) {
                                        phi_5230_ = _e1705;
                                    } else {
                                        phi_5230_ = _e1709;
                                    }
                                    let _e1712 = phi_5230_;
                                    if (_e1689 > _e1712) {
                                        phi_5235_ = _e1689;
                                    } else {
                                        phi_5235_ = _e1712;
                                    }
                                    let _e1715 = phi_5235_;
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
                                        phi_5294_ = -(_e1746);
                                    } else {
                                        phi_5294_ = _e1746;
                                    }
                                    let _e1752 = phi_5294_;
                                    if (_e1747 < 0f) {
                                        phi_5300_ = -(_e1747);
                                    } else {
                                        phi_5300_ = _e1747;
                                    }
                                    let _e1756 = phi_5300_;
                                    if (_e1752 > _e1756) {
                                        phi_5305_ = _e1752;
                                    } else {
                                        phi_5305_ = _e1756;
                                    }
                                    let _e1759 = phi_5305_;
                                    if (_e1748 < 0f) {
                                        phi_5311_ = -(_e1748);
                                    } else {
                                        phi_5311_ = _e1748;
                                    }
                                    let _e1763 = phi_5311_;
                                    if (_e1759 > _e1763) {
                                        phi_5316_ = _e1759;
                                    } else {
                                        phi_5316_ = _e1763;
                                    }
                                    let _e1766 = phi_5316_;
                                    let _e1772 = ((((_e1403 * _e1766) * 1.01f) + ((_e1715 + _e1666) * (0.000000059604645f * 8f))) + _e1666);
                                    if (_e1733 < 0f) {
                                        phi_5328_ = -(_e1733);
                                    } else {
                                        phi_5328_ = _e1733;
                                    }
                                    let _e1776 = phi_5328_;
                                    if (_e1734 < 0f) {
                                        phi_5334_ = -(_e1734);
                                    } else {
                                        phi_5334_ = _e1734;
                                    }
                                    let _e1780 = phi_5334_;
                                    if (_e1776 > _e1780) {
                                        phi_5339_ = _e1776;
                                    } else {
                                        phi_5339_ = _e1780;
                                    }
                                    let _e1783 = phi_5339_;
                                    if (_e1735 < 0f) {
                                        phi_5345_ = -(_e1735);
                                    } else {
                                        phi_5345_ = _e1735;
                                    }
                                    let _e1787 = phi_5345_;
                                    if (_e1783 > _e1787) {
                                        phi_5350_ = _e1783;
                                    } else {
                                        phi_5350_ = _e1787;
                                    }
                                    let _e1790 = phi_5350_;
                                    local_4 = type_26(array<f32, 3>(_e1733, _e1734, _e1735), _e1772, (_e1790 + _e1772));
                                    let _e1795 = local_3.member;
                                    let _e1800 = local_4.member;
                                    let _e1806 = ((_e1795[1] * _e1800[2]) - (_e1795[2] * _e1800[1]));
                                    let _e1809 = ((_e1795[2] * _e1800[0]) - (_e1795[0] * _e1800[2]));
                                    let _e1812 = ((_e1795[0] * _e1800[1]) - (_e1795[1] * _e1800[0]));
                                    if (_e1806 < 0f) {
                                        phi_5399_ = -(_e1806);
                                    } else {
                                        phi_5399_ = _e1806;
                                    }
                                    let _e1816 = phi_5399_;
                                    if (_e1809 < 0f) {
                                        phi_5405_ = -(_e1809);
                                    } else {
                                        phi_5405_ = _e1809;
                                    }
                                    let _e1820 = phi_5405_;
                                    if (_e1816 > _e1820) {
                                        if (_e1806 < 0f) {
                                            phi_5415_ = -(_e1806);
                                        } else {
                                            phi_5415_ = _e1806;
                                        }
                                        let _e1838 = phi_5415_;
                                        if (_e1812 < 0f) {
                                            phi_5421_ = -(_e1812);
                                        } else {
                                            phi_5421_ = _e1812;
                                        }
                                        let _e1842 = phi_5421_;
                                        if (_e1838 > _e1842) {
                                            phi_5426_ = 2u;
                                            phi_5427_ = 1u;
                                        } else {
                                            phi_5426_ = 1u;
                                            phi_5427_ = 0u;
                                        }
                                        let _e1845 = phi_5426_;
                                        let _e1847 = phi_5427_;
                                        phi_5446_ = _e1845;
                                        phi_5447_ = _e1847;
                                    } else {
                                        if (_e1809 < 0f) {
                                            phi_5433_ = -(_e1809);
                                        } else {
                                            phi_5433_ = _e1809;
                                        }
                                        let _e1825 = phi_5433_;
                                        if (_e1812 < 0f) {
                                            phi_5439_ = -(_e1812);
                                        } else {
                                            phi_5439_ = _e1812;
                                        }
                                        let _e1829 = phi_5439_;
                                        if (_e1825 > _e1829) {
                                            phi_5444_ = 0u;
                                            phi_5445_ = 2u;
                                        } else {
                                            phi_5444_ = 1u;
                                            phi_5445_ = 0u;
                                        }
                                        let _e1832 = phi_5444_;
                                        let _e1834 = phi_5445_;
                                        phi_5446_ = _e1832;
                                        phi_5447_ = _e1834;
                                    }
                                    let _e1849 = phi_5446_;
                                    let _e1851 = phi_5447_;
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
                                        phi_5516_ = -(_e1866);
                                    } else {
                                        phi_5516_ = _e1866;
                                    }
                                    let _e1902 = phi_5516_;
                                    if (_e1902 > _e1898) {
                                        if (_e1866 < 0f) {
                                            phi_5525_ = -1f;
                                        } else {
                                            phi_5525_ = 1f;
                                        }
                                        let _e1906 = phi_5525_;
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
                                            phi_5660_ = -(_e2001);
                                        } else {
                                            phi_5660_ = _e2001;
                                        }
                                        let _e2007 = phi_5660_;
                                        if (_e2002 < 0f) {
                                            phi_5666_ = -(_e2002);
                                        } else {
                                            phi_5666_ = _e2002;
                                        }
                                        let _e2011 = phi_5666_;
                                        if (_e2003 < 0f) {
                                            phi_5673_ = -(_e2003);
                                        } else {
                                            phi_5673_ = _e2003;
                                        }
                                        let _e2016 = phi_5673_;
                                        let _e2019 = (((_e2007 + _e2011) + _e2016) * (0.000000059604645f * 4f));
                                        local_5 = array<type_32, 4>(type_32(_e2002, _e1953), type_32(_e2003, _e2000), type_32((_e2001 - _e2002), ((_e1898 + _e1953) + _e2019)), type_32((_e2001 - _e2003), ((_e1898 + _e2000) + _e2019)));
                                        phi_5728_ = type_9(0u, 4u);
                                        phi_5731_ = true;
                                        loop {
                                            let _e2032 = phi_5728_;
                                            let _e2034 = phi_5731_;
                                            local_17 = _e2034;
                                            if (_e2032.member < _e2032.member_1) {
                                                phi_5729_ = type_9((_e2032.member + 1u), _e2032.member_1);
                                                phi_5754_ = type_9(1u, _e2032.member);
                                            } else {
                                                phi_5729_ = _e2032;
                                                phi_5754_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2046 = phi_5729_;
                                            let _e2048 = phi_5754_;
                                            if (bitcast<i32>(_e2048.member) != 0i) {
                                                let _e2055 = local_5[_e2048.member_1].member;
                                                let _e2058 = local_5[_e2048.member_1].member_1;
                                                let _e2060 = (_e2055 < -(_e2058));
                                                if _e2060 {
                                                    phi_5781_ = bool();
                                                    phi_5782_ = false;
                                                } else {
                                                    phi_5781_ = (_e2034 && (_e2055 > _e2058));
                                                    phi_5782_ = true;
                                                }
                                                let _e2064 = phi_5781_;
                                                let _e2066 = phi_5782_;
                                                phi_5732_ = _e2064;
                                                phi_5783_ = _e2066;
                                                phi_5784_ = _e2060;
                                            } else {
                                                phi_5732_ = bool();
                                                phi_5783_ = false;
                                                phi_5784_ = false;
                                            }
                                            let _e2068 = phi_5732_;
                                            let _e2070 = phi_5783_;
                                            let _e2072 = phi_5784_;
                                            local_16 = _e2072;
                                            continue;
                                            continuing {
                                                phi_5728_ = _e2046;
                                                phi_5731_ = _e2068;
                                                break if !(_e2070);
                                            }
                                        }
                                        let _e2075 = local_16;
                                        if _e2075 {
                                            phi_5788_ = false;
                                        } else {
                                            phi_5788_ = true;
                                        }
                                        let _e2077 = phi_5788_;
                                        if _e2077 {
                                            let _e2079 = local_17;
                                            if _e2079 {
                                                phi_5795_ = 1u;
                                            } else {
                                                phi_5795_ = 2u;
                                            }
                                            let _e2081 = phi_5795_;
                                            phi_5796_ = _e2081;
                                            phi_5797_ = false;
                                        } else {
                                            phi_5796_ = u32();
                                            phi_5797_ = true;
                                        }
                                        let _e2083 = phi_5796_;
                                        let _e2085 = phi_5797_;
                                        phi_5798_ = _e2083;
                                        phi_5799_ = 0u;
                                        phi_5800_ = _e2085;
                                    } else {
                                        phi_5798_ = u32();
                                        phi_5799_ = 2u;
                                        phi_5800_ = true;
                                    }
                                    let _e2087 = phi_5798_;
                                    let _e2089 = phi_5799_;
                                    let _e2091 = phi_5800_;
                                    if _e2091 {
                                        phi_5804_ = _e2089;
                                    } else {
                                        phi_5804_ = _e2087;
                                    }
                                    let _e2093 = phi_5804_;
                                    let _e2094 = (_e2093 == 0u);
                                    if _e2094 {
                                        phi_7977_ = f32();
                                        phi_7978_ = false;
                                        phi_7979_ = false;
                                        phi_7980_ = false;
                                    } else {
                                        if (_e2093 == 1u) {
                                            if _e1393.member_2 {
                                                if ((_e1393.member_1 - _e1393.member) <= 0.0000005f) {
                                                    phi_5824_ = false;
                                                } else {
                                                    phi_5824_ = true;
                                                }
                                                let _e2102 = phi_5824_;
                                                phi_5825_ = _e2102;
                                            } else {
                                                phi_5825_ = true;
                                            }
                                            let _e2104 = phi_5825_;
                                            phi_5826_ = _e2104;
                                        } else {
                                            phi_5826_ = true;
                                        }
                                        let _e2106 = phi_5826_;
                                        if _e2106 {
                                            let _e2111 = local_12.member[0u];
                                            let _e2117 = local_12.member_1[0u];
                                            let _e2123 = local_12.member_2[0u];
                                            let _e2127 = (_e2111[0] - _e2117[0]);
                                            let _e2128 = (_e2111[1] - _e2117[1]);
                                            let _e2129 = (_e2111[2] - _e2117[2]);
                                            let _e2138 = local_12.member[1u];
                                            let _e2144 = local_12.member_1[1u];
                                            let _e2150 = local_12.member_2[1u];
                                            let _e2154 = (_e2138[0] - _e2144[0]);
                                            let _e2155 = (_e2138[1] - _e2144[1]);
                                            let _e2156 = (_e2138[2] - _e2144[2]);
                                            let _e2165 = local_12.member[0u];
                                            if (_e2165[0] < 0f) {
                                                phi_5974_ = -(_e2165[0]);
                                            } else {
                                                phi_5974_ = _e2165[0];
                                            }
                                            let _e2172 = phi_5974_;
                                            if (_e2165[1] < 0f) {
                                                phi_5981_ = -(_e2165[1]);
                                            } else {
                                                phi_5981_ = _e2165[1];
                                            }
                                            let _e2176 = phi_5981_;
                                            if (_e2172 > _e2176) {
                                                phi_5986_ = _e2172;
                                            } else {
                                                phi_5986_ = _e2176;
                                            }
                                            let _e2179 = phi_5986_;
                                            if (_e2165[2] < 0f) {
                                                phi_5993_ = -(_e2165[2]);
                                            } else {
                                                phi_5993_ = _e2165[2];
                                            }
                                            let _e2183 = phi_5993_;
                                            if (_e2179 > _e2183) {
                                                phi_5998_ = _e2179;
                                            } else {
                                                phi_5998_ = _e2183;
                                            }
                                            let _e2186 = phi_5998_;
                                            let _e2189 = local_12.member[1u];
                                            if (_e2189[0] < 0f) {
                                                phi_6011_ = -(_e2189[0]);
                                            } else {
                                                phi_6011_ = _e2189[0];
                                            }
                                            let _e2196 = phi_6011_;
                                            if (_e2189[1] < 0f) {
                                                phi_6018_ = -(_e2189[1]);
                                            } else {
                                                phi_6018_ = _e2189[1];
                                            }
                                            let _e2200 = phi_6018_;
                                            if (_e2196 > _e2200) {
                                                phi_6023_ = _e2196;
                                            } else {
                                                phi_6023_ = _e2200;
                                            }
                                            let _e2203 = phi_6023_;
                                            if (_e2189[2] < 0f) {
                                                phi_6030_ = -(_e2189[2]);
                                            } else {
                                                phi_6030_ = _e2189[2];
                                            }
                                            let _e2207 = phi_6030_;
                                            if (_e2203 > _e2207) {
                                                phi_6035_ = _e2203;
                                            } else {
                                                phi_6035_ = _e2207;
                                            }
                                            let _e2210 = phi_6035_;
                                            if (_e2186 > _e2210) {
                                                phi_6040_ = _e2186;
                                            } else {
                                                phi_6040_ = _e2210;
                                            }
                                            let _e2213 = phi_6040_;
                                            let _e2215 = local_12.member_3;
                                            let _e2219 = local_12.member_1[0u];
                                            if (_e2219[0] < 0f) {
                                                phi_6057_ = -(_e2219[0]);
                                            } else {
                                                phi_6057_ = _e2219[0];
                                            }
                                            let _e2226 = phi_6057_;
                                            if (_e2219[1] < 0f) {
                                                phi_6064_ = -(_e2219[1]);
                                            } else {
                                                phi_6064_ = _e2219[1];
                                            }
                                            let _e2230 = phi_6064_;
                                            if (_e2226 > _e2230) {
                                                phi_6069_ = _e2226;
                                            } else {
                                                phi_6069_ = _e2230;
                                            }
                                            let _e2233 = phi_6069_;
                                            if (_e2219[2] < 0f) {
                                                phi_6076_ = -(_e2219[2]);
                                            } else {
                                                phi_6076_ = _e2219[2];
                                            }
                                            let _e2237 = phi_6076_;
                                            if (_e2233 > _e2237) {
                                                phi_6081_ = _e2233;
                                            } else {
                                                phi_6081_ = _e2237;
                                            }
                                            let _e2240 = phi_6081_;
                                            let _e2243 = local_12.member_1[1u];
                                            if (_e2243[0] < 0f) {
                                                phi_6095_ = -(_e2243[0]);
                                            } else {
                                                phi_6095_ = _e2243[0];
                                            }
                                            let _e2250 = phi_6095_;
                                            if (_e2243[1] < 0f) {
                                                phi_6102_ = -(_e2243[1]);
                                            } else {
                                                phi_6102_ = _e2243[1];
                                            }
                                            let _e2254 = phi_6102_;
                                            if (_e2250 > _e2254) {
                                                phi_6107_ = _e2250;
                                            } else {
                                                phi_6107_ = _e2254;
                                            }
                                            let _e2257 = phi_6107_;
                                            if (_e2243[2] < 0f) {
                                                phi_6114_ = -(_e2243[2]);
                                            } else {
                                                phi_6114_ = _e2243[2];
                                            }
                                            let _e2261 = phi_6114_;
                                            if (_e2257 > _e2261) {
                                                phi_6119_ = _e2257;
                                            } else {
                                                phi_6119_ = _e2261;
                                            }
                                            let _e2264 = phi_6119_;
                                            if (_e2240 > _e2264) {
                                                phi_6124_ = _e2240;
                                            } else {
                                                phi_6124_ = _e2264;
                                            }
                                            let _e2267 = phi_6124_;
                                            let _e2269 = local_12.member_3;
                                            let _e2273 = local_12.member_2[0u];
                                            if (_e2273[0] < 0f) {
                                                phi_6141_ = -(_e2273[0]);
                                            } else {
                                                phi_6141_ = _e2273[0];
                                            }
                                            let _e2280 = phi_6141_;
                                            if (_e2273[1] < 0f) {
                                                phi_6148_ = -(_e2273[1]);
                                            } else {
                                                phi_6148_ = _e2273[1];
                                            }
                                            let _e2284 = phi_6148_;
                                            if (_e2280 > _e2284) {
                                                phi_6153_ = _e2280;
                                            } else {
                                                phi_6153_ = _e2284;
                                            }
                                            let _e2287 = phi_6153_;
                                            if (_e2273[2] < 0f) {
                                                phi_6160_ = -(_e2273[2]);
                                            } else {
                                                phi_6160_ = _e2273[2];
                                            }
                                            let _e2291 = phi_6160_;
                                            if (_e2287 > _e2291) {
                                                phi_6165_ = _e2287;
                                            } else {
                                                phi_6165_ = _e2291;
                                            }
                                            let _e2294 = phi_6165_;
                                            let _e2297 = local_12.member_2[1u];
                                            if (_e2297[0] < 0f) {
                                                phi_6179_ = -(_e2297[0]);
                                            } else {
                                                phi_6179_ = _e2297[0];
                                            }
                                            let _e2304 = phi_6179_;
                                            if (_e2297[1] < 0f) {
                                                phi_6186_ = -(_e2297[1]);
                                            } else {
                                                phi_6186_ = _e2297[1];
                                            }
                                            let _e2308 = phi_6186_;
                                            if (_e2304 > _e2308) {
                                                phi_6191_ = _e2304;
                                            } else {
                                                phi_6191_ = _e2308;
                                            }
                                            let _e2311 = phi_6191_;
                                            if (_e2297[2] < 0f) {
                                                phi_6198_ = -(_e2297[2]);
                                            } else {
                                                phi_6198_ = _e2297[2];
                                            }
                                            let _e2315 = phi_6198_;
                                            if (_e2311 > _e2315) {
                                                phi_6203_ = _e2311;
                                            } else {
                                                phi_6203_ = _e2315;
                                            }
                                            let _e2318 = phi_6203_;
                                            if (_e2294 > _e2318) {
                                                phi_6208_ = _e2294;
                                            } else {
                                                phi_6208_ = _e2318;
                                            }
                                            let _e2321 = phi_6208_;
                                            let _e2323 = local_12.member_3;
                                            let _e2330 = local_12.member_3;
                                            local = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            phi_6247_ = type_9(0u, 96u);
                                            phi_6250_ = _e1393.member;
                                            phi_6252_ = _e1393.member;
                                            phi_6254_ = _e1393.member;
                                            phi_6256_ = false;
                                            phi_6258_ = 0u;
                                            loop {
                                                let _e2336 = phi_6247_;
                                                let _e2338 = phi_6250_;
                                                let _e2340 = phi_6252_;
                                                let _e2342 = phi_6254_;
                                                let _e2344 = phi_6256_;
                                                let _e2346 = phi_6258_;
                                                local_36 = _e2340;
                                                local_20 = _e2338;
                                                if (_e2336.member < _e2336.member_1) {
                                                    phi_6248_ = type_9((_e2336.member + 1u), _e2336.member_1);
                                                    phi_6281_ = type_9(1u, _e2336.member);
                                                } else {
                                                    phi_6248_ = _e2336;
                                                    phi_6281_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2358 = phi_6248_;
                                                let _e2360 = phi_6281_;
                                                if (bitcast<i32>(_e2360.member) != 0i) {
                                                    let _e2366 = local_12.member[0u];
                                                    let _e2372 = local_12.member[1u];
                                                    let _e2388 = local_12.member_1[0u];
                                                    let _e2394 = local_12.member_1[1u];
                                                    let _e2410 = local_12.member_2[0u];
                                                    let _e2416 = local_12.member_2[1u];
                                                    let _e2430 = function_2(array<f32, 3>((_e2366[0] + ((_e2372[0] - _e2366[0]) * _e2338)), (_e2366[1] + ((_e2372[1] - _e2366[1]) * _e2338)), (_e2366[2] + ((_e2372[2] - _e2366[2]) * _e2338))), array<f32, 3>((_e2388[0] + ((_e2394[0] - _e2388[0]) * _e2338)), (_e2388[1] + ((_e2394[1] - _e2388[1]) * _e2338)), (_e2388[2] + ((_e2394[2] - _e2388[2]) * _e2338))), array<f32, 3>((_e2410[0] + ((_e2416[0] - _e2410[0]) * _e2338)), (_e2410[1] + ((_e2416[1] - _e2410[1]) * _e2338)), (_e2410[2] + ((_e2416[2] - _e2410[2]) * _e2338))), 1u);
                                                    if (_e2346 == 0u) {
                                                        phi_6409_ = _e2430;
                                                    } else {
                                                        if (_e2346 == 1u) {
                                                            phi_6395_ = _e2430[0];
                                                        } else {
                                                            phi_6395_ = 0f;
                                                        }
                                                        let _e2435 = phi_6395_;
                                                        if (_e2346 == 2u) {
                                                            phi_6401_ = _e2430[1];
                                                        } else {
                                                            phi_6401_ = 0f;
                                                        }
                                                        let _e2439 = phi_6401_;
                                                        if (_e2346 == 3u) {
                                                            phi_6407_ = _e2430[2];
                                                        } else {
                                                            phi_6407_ = 0f;
                                                        }
                                                        let _e2443 = phi_6407_;
                                                        phi_6409_ = array<f32, 3>(_e2435, _e2439, _e2443);
                                                    }
                                                    let _e2446 = phi_6409_;
                                                    if (_e2446[0] < 0f) {
                                                        phi_6416_ = -(_e2446[0]);
                                                    } else {
                                                        phi_6416_ = _e2446[0];
                                                    }
                                                    let _e2451 = phi_6416_;
                                                    if (_e2446[1] < 0f) {
                                                        phi_6423_ = -(_e2446[1]);
                                                    } else {
                                                        phi_6423_ = _e2446[1];
                                                    }
                                                    let _e2456 = phi_6423_;
                                                    if (_e2446[2] < 0f) {
                                                        phi_6431_ = -(_e2446[2]);
                                                    } else {
                                                        phi_6431_ = _e2446[2];
                                                    }
                                                    let _e2462 = phi_6431_;
                                                    let _e2463 = ((_e2451 + _e2456) + _e2462);
                                                    if (_e2463 > 0f) {
                                                        if ((bitcast<u32>(_e2463) & 2139095040u) != 2139095040u) {
                                                            let _e2468 = (1f / _e2463);
                                                            let _e2470 = (_e2446[0] * _e2468);
                                                            let _e2472 = (_e2446[1] * _e2468);
                                                            let _e2474 = (_e2446[2] * _e2468);
                                                            let _e2479 = (((_e2470 * _e2470) + (_e2472 * _e2472)) + (_e2474 * _e2474));
                                                            if (_e2479 <= 0.000000000000000000000000000000000000011754944f) {
                                                                if (_e2479 > 0f) {
                                                                    phi_6468_ = (0.000000000000000000106433627f * 2f);
                                                                } else {
                                                                    phi_6468_ = 0f;
                                                                }
                                                                let _e2532 = phi_6468_;
                                                                phi_6532_ = _e2532;
                                                            } else {
                                                                phi_6475_ = type_14(0i, 5i);
                                                                phi_6478_ = bitcast<f32>(((bitcast<u32>(_e2479) >> bitcast<u32>(1i)) + 532369198u));
                                                                loop {
                                                                    let _e2487 = phi_6475_;
                                                                    let _e2489 = phi_6478_;
                                                                    local_18 = _e2489;
                                                                    if (_e2487.member < _e2487.member_1) {
                                                                        let _e2496 = (_e2487.member + 1i);
                                                                        if ((false == (_e2496 > _e2487.member)) != false) {
                                                                            phi_6499_ = true;
                                                                        } else {
                                                                            phi_6499_ = false;
                                                                        }
                                                                        let _e2501 = phi_6499_;
                                                                        if _e2501 {
                                                                            phi_6505_ = type_15(0u, type_15().member_1);
                                                                        } else {
                                                                            phi_6505_ = type_15(1u, _e2496);
                                                                        }
                                                                        let _e2506 = phi_6505_;
                                                                        phi_6476_ = type_14(_e2506.member_1, _e2487.member_1);
                                                                        phi_6519_ = type_15(1u, _e2487.member);
                                                                    } else {
                                                                        phi_6476_ = _e2487;
                                                                        phi_6519_ = type_15(0u, type_15().member_1);
                                                                    }
                                                                    let _e2512 = phi_6476_;
                                                                    let _e2514 = phi_6519_;
                                                                    let _e2517 = (bitcast<i32>(_e2514.member) != 0i);
                                                                    if _e2517 {
                                                                        phi_6479_ = (0.5f * (_e2489 + (_e2479 / _e2489)));
                                                                    } else {
                                                                        phi_6479_ = f32();
                                                                    }
                                                                    let _e2522 = phi_6479_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6475_ = _e2512;
                                                                        phi_6478_ = _e2522;
                                                                        break if !(_e2517);
                                                                    }
                                                                }
                                                                let _e2527 = local_18;
                                                                phi_6532_ = (_e2527 * (1f + (8f * 0.000000059604645f)));
                                                            }
                                                            let _e2534 = phi_6532_;
                                                            let _e2535 = (0.000000059604645f * 12f);
                                                            let _e2540 = ((((((((_e2213 + _e2215) + (_e2267 + _e2269)) + (_e2321 + _e2323)) * (0.000000059604645f * 16f)) + (_e2330 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e2534) * (1f + _e2535)));
                                                            let _e2545 = (((_e2470 * _e2111[0]) + (_e2472 * _e2111[1])) + (_e2474 * _e2111[2]));
                                                            let _e2550 = (((_e2470 * _e2127) + (_e2472 * _e2128)) + (_e2474 * _e2129));
                                                            let _e2555 = (((_e2470 * (_e2111[0] - _e2123[0])) + (_e2472 * (_e2111[1] - _e2123[1]))) + (_e2474 * (_e2111[2] - _e2123[2])));
                                                            let _e2560 = (((_e2470 * (_e2127 - _e2123[0])) + (_e2472 * (_e2128 - _e2123[1]))) + (_e2474 * (_e2129 - _e2123[2])));
                                                            let _e2566 = (((_e2470 * _e2138[0]) + (_e2472 * _e2138[1])) + (_e2474 * _e2138[2]));
                                                            let _e2571 = (((_e2470 * _e2154) + (_e2472 * _e2155)) + (_e2474 * _e2156));
                                                            let _e2576 = (((_e2470 * (_e2138[0] - _e2150[0])) + (_e2472 * (_e2138[1] - _e2150[1]))) + (_e2474 * (_e2138[2] - _e2150[2])));
                                                            let _e2581 = (((_e2470 * (_e2154 - _e2150[0])) + (_e2472 * (_e2155 - _e2150[1]))) + (_e2474 * (_e2156 - _e2150[2])));
                                                            if (_e2545 < 0f) {
                                                                phi_6598_ = -(_e2545);
                                                            } else {
                                                                phi_6598_ = _e2545;
                                                            }
                                                            let _e2586 = phi_6598_;
                                                            if (_e2566 < 0f) {
                                                                phi_6604_ = -(_e2566);
                                                            } else {
                                                                phi_6604_ = _e2566;
                                                            }
                                                            let _e2590 = phi_6604_;
                                                            if (_e2550 < 0f) {
                                                                phi_6613_ = -(_e2550);
                                                            } else {
                                                                phi_6613_ = _e2550;
                                                            }
                                                            let _e2597 = phi_6613_;
                                                            if (_e2571 < 0f) {
                                                                phi_6619_ = -(_e2571);
                                                            } else {
                                                                phi_6619_ = _e2571;
                                                            }
                                                            let _e2601 = phi_6619_;
                                                            if (_e2555 < 0f) {
                                                                phi_6628_ = -(_e2555);
                                                            } else {
                                                                phi_6628_ = _e2555;
                                                            }
                                                            let _e2608 = phi_6628_;
                                                            if (_e2576 < 0f) {
                                                                phi_6634_ = -(_e2576);
                                                            } else {
                                                                phi_6634_ = _e2576;
                                                            }
                                                            let _e2612 = phi_6634_;
                                                            if (_e2560 < 0f) {
                                                                phi_6643_ = -(_e2560);
                                                            } else {
                                                                phi_6643_ = _e2560;
                                                            }
                                                            let _e2619 = phi_6643_;
                                                            if (_e2581 < 0f) {
                                                                phi_6649_ = -(_e2581);
                                                            } else {
                                                                phi_6649_ = _e2581;
                                                            }
                                                            let _e2623 = phi_6649_;
                                                            phi_6655_ = type_31(array<f32, 4>(_e2545, _e2550, _e2555, _e2560), array<f32, 4>(_e2566, _e2571, _e2576, _e2581), array<f32, 4>((_e2540 + ((_e2586 + _e2590) * _e2535)), (_e2540 + ((_e2597 + _e2601) * _e2535)), (_e2540 + ((_e2608 + _e2612) * _e2535)), (_e2540 + ((_e2619 + _e2623) * _e2535))));
                                                            phi_6656_ = false;
                                                        } else {
                                                            phi_6655_ = type_31();
                                                            phi_6656_ = true;
                                                        }
                                                        let _e2630 = phi_6655_;
                                                        let _e2632 = phi_6656_;
                                                        phi_6657_ = _e2630;
                                                        phi_6658_ = _e2632;
                                                    } else {
                                                        phi_6657_ = type_31();
                                                        phi_6658_ = true;
                                                    }
                                                    let _e2634 = phi_6657_;
                                                    let _e2636 = phi_6658_;
                                                    if _e2636 {
                                                        phi_6666_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    } else {
                                                        phi_6666_ = _e2634;
                                                    }
                                                    let _e2638 = phi_6666_;
                                                    local_1 = type_31(array<f32, 4>(_e2638.member[0], _e2638.member[1], _e2638.member[2], _e2638.member[3]), array<f32, 4>(_e2638.member_1[0], _e2638.member_1[1], _e2638.member_1[2], _e2638.member_1[3]), array<f32, 4>(_e2638.member_2[0], _e2638.member_2[1], _e2638.member_2[2], _e2638.member_2[3]));
                                                    let _e2658 = (_e2338 - _e2342);
                                                    let _e2662 = local_1.member[0u];
                                                    let _e2665 = local_1.member_1[0u];
                                                    let _e2668 = local_1.member[0u];
                                                    let _e2674 = local_1.member_2[0u];
                                                    if (((_e2662 + ((_e2665 - _e2668) * _e2338)) - _e2674) > 0f) {
                                                        let _e2679 = local_1.member[1u];
                                                        let _e2682 = local_1.member_1[1u];
                                                        let _e2685 = local_1.member[1u];
                                                        let _e2691 = local_1.member_2[1u];
                                                        if (((_e2679 + ((_e2682 - _e2685) * _e2338)) - _e2691) > 0f) {
                                                            let _e2696 = local_1.member[2u];
                                                            let _e2699 = local_1.member_1[2u];
                                                            let _e2702 = local_1.member[2u];
                                                            let _e2708 = local_1.member_2[2u];
                                                            if (((_e2696 + ((_e2699 - _e2702) * _e2338)) - _e2708) > 0f) {
                                                                let _e2713 = local_1.member[3u];
                                                                let _e2716 = local_1.member_1[3u];
                                                                let _e2719 = local_1.member[3u];
                                                                let _e2725 = local_1.member_2[3u];
                                                                phi_6837_ = (((_e2713 + ((_e2716 - _e2719) * _e2338)) - _e2725) > 0f);
                                                                phi_6838_ = false;
                                                            } else {
                                                                phi_6837_ = bool();
                                                                phi_6838_ = true;
                                                            }
                                                            let _e2729 = phi_6837_;
                                                            let _e2731 = phi_6838_;
                                                            phi_6839_ = _e2729;
                                                            phi_6840_ = _e2731;
                                                        } else {
                                                            phi_6839_ = bool();
                                                            phi_6840_ = true;
                                                        }
                                                        let _e2733 = phi_6839_;
                                                        let _e2735 = phi_6840_;
                                                        phi_6841_ = _e2733;
                                                        phi_6842_ = _e2735;
                                                    } else {
                                                        phi_6841_ = bool();
                                                        phi_6842_ = true;
                                                    }
                                                    let _e2737 = phi_6841_;
                                                    let _e2739 = phi_6842_;
                                                    if _e2739 {
                                                        phi_6846_ = false;
                                                    } else {
                                                        phi_6846_ = _e2737;
                                                    }
                                                    let _e2741 = phi_6846_;
                                                    if _e2741 {
                                                        if (_e2338 <= _e2340) {
                                                            phi_7156_ = true;
                                                        } else {
                                                            let _e2745 = local.member[0u];
                                                            let _e2748 = local.member_1[0u];
                                                            let _e2751 = local.member[0u];
                                                            let _e2757 = local.member_2[0u];
                                                            let _e2761 = local_1.member[0u];
                                                            let _e2764 = local_1.member_1[0u];
                                                            let _e2767 = local_1.member[0u];
                                                            let _e2773 = local_1.member_2[0u];
                                                            if ((((_e2745 + ((_e2748 - _e2751) * _e2338)) - _e2757) + ((_e2761 + ((_e2764 - _e2767) * _e2342)) - _e2773)) > 0f) {
                                                                let _e2779 = local.member[1u];
                                                                let _e2782 = local.member_1[1u];
                                                                let _e2785 = local.member[1u];
                                                                let _e2791 = local.member_2[1u];
                                                                let _e2795 = local_1.member[1u];
                                                                let _e2798 = local_1.member_1[1u];
                                                                let _e2801 = local_1.member[1u];
                                                                let _e2807 = local_1.member_2[1u];
                                                                if ((((_e2779 + ((_e2782 - _e2785) * _e2338)) - _e2791) + ((_e2795 + ((_e2798 - _e2801) * _e2342)) - _e2807)) > 0f) {
                                                                    let _e2813 = local.member[2u];
                                                                    let _e2816 = local.member_1[2u];
                                                                    let _e2819 = local.member[2u];
                                                                    let _e2825 = local.member_2[2u];
                                                                    let _e2829 = local_1.member[2u];
                                                                    let _e2832 = local_1.member_1[2u];
                                                                    let _e2835 = local_1.member[2u];
                                                                    let _e2841 = local_1.member_2[2u];
                                                                    if ((((_e2813 + ((_e2816 - _e2819) * _e2338)) - _e2825) + ((_e2829 + ((_e2832 - _e2835) * _e2342)) - _e2841)) > 0f) {
                                                                        let _e2847 = local.member[3u];
                                                                        let _e2850 = local.member_1[3u];
                                                                        let _e2853 = local.member[3u];
                                                                        let _e2859 = local.member_2[3u];
                                                                        let _e2863 = local_1.member[3u];
                                                                        let _e2866 = local_1.member_1[3u];
                                                                        let _e2869 = local_1.member[3u];
                                                                        let _e2875 = local_1.member_2[3u];
                                                                        phi_7143_ = ((((_e2847 + ((_e2850 - _e2853) * _e2338)) - _e2859) + ((_e2863 + ((_e2866 - _e2869) * _e2342)) - _e2875)) > 0f);
                                                                        phi_7144_ = false;
                                                                    } else {
                                                                        phi_7143_ = bool();
                                                                        phi_7144_ = true;
                                                                    }
                                                                    let _e2880 = phi_7143_;
                                                                    let _e2882 = phi_7144_;
                                                                    phi_7145_ = _e2880;
                                                                    phi_7146_ = _e2882;
                                                                } else {
                                                                    phi_7145_ = bool();
                                                                    phi_7146_ = true;
                                                                }
                                                                let _e2884 = phi_7145_;
                                                                let _e2886 = phi_7146_;
                                                                phi_7147_ = _e2884;
                                                                phi_7148_ = _e2886;
                                                            } else {
                                                                phi_7147_ = bool();
                                                                phi_7148_ = true;
                                                            }
                                                            let _e2888 = phi_7147_;
                                                            let _e2890 = phi_7148_;
                                                            if _e2890 {
                                                                phi_7152_ = false;
                                                            } else {
                                                                phi_7152_ = _e2888;
                                                            }
                                                            let _e2892 = phi_7152_;
                                                            phi_7156_ = _e2892;
                                                        }
                                                        let _e2894 = phi_7156_;
                                                        if _e2894 {
                                                            if _e2344 {
                                                                if (_e2338 >= _e1393.member_1) {
                                                                    phi_7167_ = false;
                                                                } else {
                                                                    phi_7167_ = true;
                                                                }
                                                                let _e2897 = phi_7167_;
                                                                phi_7168_ = _e2897;
                                                            } else {
                                                                phi_7168_ = true;
                                                            }
                                                            let _e2899 = phi_7168_;
                                                            if _e2899 {
                                                                local = type_31(array<f32, 4>(_e2638.member[0], _e2638.member[1], _e2638.member[2], _e2638.member[3]), array<f32, 4>(_e2638.member_1[0], _e2638.member_1[1], _e2638.member_1[2], _e2638.member_1[3]), array<f32, 4>(_e2638.member_2[0], _e2638.member_2[1], _e2638.member_2[2], _e2638.member_2[3]));
                                                                let _e2921 = local.member[0u];
                                                                let _e2924 = local.member_1[0u];
                                                                let _e2927 = local.member_2[0u];
                                                                if (_e2921 > _e2927) {
                                                                    if (_e2924 > _e2927) {
                                                                        phi_7242_ = false;
                                                                    } else {
                                                                        phi_7242_ = true;
                                                                    }
                                                                    let _e2931 = phi_7242_;
                                                                    phi_7243_ = _e2931;
                                                                } else {
                                                                    phi_7243_ = true;
                                                                }
                                                                let _e2933 = phi_7243_;
                                                                if _e2933 {
                                                                    let _e2934 = (_e2924 >= _e2921);
                                                                    if _e2934 {
                                                                        phi_7265_ = f32();
                                                                        phi_7266_ = false;
                                                                    } else {
                                                                        if ((_e2921 - _e2924) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7263_ = (((_e2921 - _e2927) / (_e2921 - _e2924)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7264_ = false;
                                                                        } else {
                                                                            phi_7263_ = f32();
                                                                            phi_7264_ = true;
                                                                        }
                                                                        let _e2945 = phi_7263_;
                                                                        let _e2947 = phi_7264_;
                                                                        phi_7265_ = _e2945;
                                                                        phi_7266_ = _e2947;
                                                                    }
                                                                    let _e2949 = phi_7265_;
                                                                    let _e2951 = phi_7266_;
                                                                    phi_7267_ = _e2949;
                                                                    phi_7268_ = _e2934;
                                                                    phi_7269_ = _e2951;
                                                                } else {
                                                                    phi_7267_ = f32();
                                                                    phi_7268_ = true;
                                                                    phi_7269_ = false;
                                                                }
                                                                let _e2953 = phi_7267_;
                                                                let _e2955 = phi_7268_;
                                                                let _e2957 = phi_7269_;
                                                                if _e2955 {
                                                                    phi_7273_ = 2f;
                                                                    phi_7274_ = true;
                                                                } else {
                                                                    phi_7273_ = _e2338;
                                                                    phi_7274_ = _e2957;
                                                                }
                                                                let _e2959 = phi_7273_;
                                                                let _e2961 = phi_7274_;
                                                                if _e2961 {
                                                                    phi_7278_ = _e2959;
                                                                } else {
                                                                    phi_7278_ = _e2953;
                                                                }
                                                                let _e2963 = phi_7278_;
                                                                let _e2966 = local.member[1u];
                                                                let _e2969 = local.member_1[1u];
                                                                let _e2972 = local.member_2[1u];
                                                                if (_e2966 > _e2972) {
                                                                    if (_e2969 > _e2972) {
                                                                        phi_7310_ = false;
                                                                    } else {
                                                                        phi_7310_ = true;
                                                                    }
                                                                    let _e2976 = phi_7310_;
                                                                    phi_7311_ = _e2976;
                                                                } else {
                                                                    phi_7311_ = true;
                                                                }
                                                                let _e2978 = phi_7311_;
                                                                if _e2978 {
                                                                    let _e2979 = (_e2969 >= _e2966);
                                                                    if _e2979 {
                                                                        phi_7333_ = f32();
                                                                        phi_7334_ = false;
                                                                    } else {
                                                                        if ((_e2966 - _e2969) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7331_ = (((_e2966 - _e2972) / (_e2966 - _e2969)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7332_ = false;
                                                                        } else {
                                                                            phi_7331_ = f32();
                                                                            phi_7332_ = true;
                                                                        }
                                                                        let _e2990 = phi_7331_;
                                                                        let _e2992 = phi_7332_;
                                                                        phi_7333_ = _e2990;
                                                                        phi_7334_ = _e2992;
                                                                    }
                                                                    let _e2994 = phi_7333_;
                                                                    let _e2996 = phi_7334_;
                                                                    phi_7335_ = _e2994;
                                                                    phi_7336_ = _e2979;
                                                                    phi_7337_ = _e2996;
                                                                } else {
                                                                    phi_7335_ = f32();
                                                                    phi_7336_ = true;
                                                                    phi_7337_ = false;
                                                                }
                                                                let _e2998 = phi_7335_;
                                                                let _e3000 = phi_7336_;
                                                                let _e3002 = phi_7337_;
                                                                if _e3000 {
                                                                    phi_7341_ = 2f;
                                                                    phi_7342_ = true;
                                                                } else {
                                                                    phi_7341_ = _e2338;
                                                                    phi_7342_ = _e3002;
                                                                }
                                                                let _e3004 = phi_7341_;
                                                                let _e3006 = phi_7342_;
                                                                if _e3006 {
                                                                    phi_7346_ = _e3004;
                                                                } else {
                                                                    phi_7346_ = _e2998;
                                                                }
                                                                let _e3008 = phi_7346_;
                                                                if (_e2963 < _e3008) {
                                                                    phi_7351_ = _e2963;
                                                                } else {
                                                                    phi_7351_ = _e3008;
                                                                }
                                                                let _e3011 = phi_7351_;
                                                                let _e3014 = local.member[2u];
                                                                let _e3017 = local.member_1[2u];
                                                                let _e3020 = local.member_2[2u];
                                                                if (_e3014 > _e3020) {
                                                                    if (_e3017 > _e3020) {
                                                                        phi_7383_ = false;
                                                                    } else {
                                                                        phi_7383_ = true;
                                                                    }
                                                                    let _e3024 = phi_7383_;
                                                                    phi_7384_ = _e3024;
                                                                } else {
                                                                    phi_7384_ = true;
                                                                }
                                                                let _e3026 = phi_7384_;
                                                                if _e3026 {
                                                                    let _e3027 = (_e3017 >= _e3014);
                                                                    if _e3027 {
                                                                        phi_7406_ = f32();
                                                                        phi_7407_ = false;
                                                                    } else {
                                                                        if ((_e3014 - _e3017) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7404_ = (((_e3014 - _e3020) / (_e3014 - _e3017)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7405_ = false;
                                                                        } else {
                                                                            phi_7404_ = f32();
                                                                            phi_7405_ = true;
                                                                        }
                                                                        let _e3038 = phi_7404_;
                                                                        let _e3040 = phi_7405_;
                                                                        phi_7406_ = _e3038;
                                                                        phi_7407_ = _e3040;
                                                                    }
                                                                    let _e3042 = phi_7406_;
                                                                    let _e3044 = phi_7407_;
                                                                    phi_7408_ = _e3042;
                                                                    phi_7409_ = _e3027;
                                                                    phi_7410_ = _e3044;
                                                                } else {
                                                                    phi_7408_ = f32();
                                                                    phi_7409_ = true;
                                                                    phi_7410_ = false;
                                                                }
                                                                let _e3046 = phi_7408_;
                                                                let _e3048 = phi_7409_;
                                                                let _e3050 = phi_7410_;
                                                                if _e3048 {
                                                                    phi_7414_ = 2f;
                                                                    phi_7415_ = true;
                                                                } else {
                                                                    phi_7414_ = _e2338;
                                                                    phi_7415_ = _e3050;
                                                                }
                                                                let _e3052 = phi_7414_;
                                                                let _e3054 = phi_7415_;
                                                                if _e3054 {
                                                                    phi_7419_ = _e3052;
                                                                } else {
                                                                    phi_7419_ = _e3046;
                                                                }
                                                                let _e3056 = phi_7419_;
                                                                let _e3059 = local.member[3u];
                                                                let _e3062 = local.member_1[3u];
                                                                let _e3065 = local.member_2[3u];
                                                                if (_e3059 > _e3065) {
                                                                    if (_e3062 > _e3065) {
                                                                        phi_7451_ = false;
                                                                    } else {
                                                                        phi_7451_ = true;
                                                                    }
                                                                    let _e3069 = phi_7451_;
                                                                    phi_7452_ = _e3069;
                                                                } else {
                                                                    phi_7452_ = true;
                                                                }
                                                                let _e3071 = phi_7452_;
                                                                if _e3071 {
                                                                    let _e3072 = (_e3062 >= _e3059);
                                                                    if _e3072 {
                                                                        phi_7474_ = f32();
                                                                        phi_7475_ = false;
                                                                    } else {
                                                                        if ((_e3059 - _e3062) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                            phi_7472_ = (((_e3059 - _e3065) / (_e3059 - _e3062)) * (1f - (0.000000059604645f * 16f)));
                                                                            phi_7473_ = false;
                                                                        } else {
                                                                            phi_7472_ = f32();
                                                                            phi_7473_ = true;
                                                                        }
                                                                        let _e3083 = phi_7472_;
                                                                        let _e3085 = phi_7473_;
                                                                        phi_7474_ = _e3083;
                                                                        phi_7475_ = _e3085;
                                                                    }
                                                                    let _e3087 = phi_7474_;
                                                                    let _e3089 = phi_7475_;
                                                                    phi_7476_ = _e3087;
                                                                    phi_7477_ = _e3072;
                                                                    phi_7478_ = _e3089;
                                                                } else {
                                                                    phi_7476_ = f32();
                                                                    phi_7477_ = true;
                                                                    phi_7478_ = false;
                                                                }
                                                                let _e3091 = phi_7476_;
                                                                let _e3093 = phi_7477_;
                                                                let _e3095 = phi_7478_;
                                                                if _e3093 {
                                                                    phi_7482_ = 2f;
                                                                    phi_7483_ = true;
                                                                } else {
                                                                    phi_7482_ = _e2338;
                                                                    phi_7483_ = _e3095;
                                                                }
                                                                let _e3097 = phi_7482_;
                                                                let _e3099 = phi_7483_;
                                                                if _e3099 {
                                                                    phi_7487_ = _e3097;
                                                                } else {
                                                                    phi_7487_ = _e3091;
                                                                }
                                                                let _e3101 = phi_7487_;
                                                                if (_e3056 < _e3101) {
                                                                    phi_7492_ = _e3056;
                                                                } else {
                                                                    phi_7492_ = _e3101;
                                                                }
                                                                let _e3104 = phi_7492_;
                                                                if (_e3011 < _e3104) {
                                                                    phi_7497_ = _e3011;
                                                                } else {
                                                                    phi_7497_ = _e3104;
                                                                }
                                                                let _e3107 = phi_7497_;
                                                                if (_e3107 > _e2338) {
                                                                    phi_7502_ = _e3107;
                                                                } else {
                                                                    phi_7502_ = _e2338;
                                                                }
                                                                let _e3110 = phi_7502_;
                                                                let _e3111 = (_e3110 > _e1393.member_1);
                                                                if _e3111 {
                                                                    phi_7513_ = f32();
                                                                    phi_7514_ = false;
                                                                } else {
                                                                    if _e2344 {
                                                                        phi_7512_ = (_e2658 + _e2658);
                                                                    } else {
                                                                        phi_7512_ = (_e1393.member_1 - _e2338);
                                                                    }
                                                                    let _e3115 = phi_7512_;
                                                                    phi_7513_ = _e3115;
                                                                    phi_7514_ = true;
                                                                }
                                                                let _e3117 = phi_7513_;
                                                                let _e3119 = phi_7514_;
                                                                phi_7515_ = _e3110;
                                                                phi_7516_ = _e3117;
                                                                phi_7517_ = _e3119;
                                                                phi_7518_ = _e3111;
                                                                phi_7519_ = false;
                                                            } else {
                                                                phi_7515_ = f32();
                                                                phi_7516_ = f32();
                                                                phi_7517_ = false;
                                                                phi_7518_ = false;
                                                                phi_7519_ = true;
                                                            }
                                                            let _e3121 = phi_7515_;
                                                            let _e3123 = phi_7516_;
                                                            let _e3125 = phi_7517_;
                                                            let _e3127 = phi_7518_;
                                                            let _e3129 = phi_7519_;
                                                            phi_7520_ = _e3121;
                                                            phi_7521_ = _e3123;
                                                            phi_7522_ = false;
                                                            phi_7523_ = _e3125;
                                                            phi_7524_ = _e3127;
                                                            phi_7525_ = _e3129;
                                                        } else {
                                                            phi_7520_ = f32();
                                                            phi_7521_ = f32();
                                                            phi_7522_ = true;
                                                            phi_7523_ = false;
                                                            phi_7524_ = false;
                                                            phi_7525_ = false;
                                                        }
                                                        let _e3131 = phi_7520_;
                                                        let _e3133 = phi_7521_;
                                                        let _e3135 = phi_7522_;
                                                        let _e3137 = phi_7523_;
                                                        let _e3139 = phi_7524_;
                                                        let _e3141 = phi_7525_;
                                                        phi_7526_ = _e3131;
                                                        phi_7527_ = _e3133;
                                                        phi_7528_ = _e3135;
                                                        phi_7529_ = _e3137;
                                                        phi_7530_ = _e3139;
                                                        phi_7531_ = _e3141;
                                                    } else {
                                                        phi_7526_ = f32();
                                                        phi_7527_ = f32();
                                                        phi_7528_ = true;
                                                        phi_7529_ = false;
                                                        phi_7530_ = false;
                                                        phi_7531_ = false;
                                                    }
                                                    let _e3143 = phi_7526_;
                                                    let _e3145 = phi_7527_;
                                                    let _e3147 = phi_7528_;
                                                    let _e3149 = phi_7529_;
                                                    let _e3151 = phi_7530_;
                                                    let _e3153 = phi_7531_;
                                                    if _e3147 {
                                                        if (_e2338 <= _e2340) {
                                                            let _e3314 = (_e2346 + 1u);
                                                            let _e3315 = (_e3314 > 3u);
                                                            if _e3315 {
                                                                phi_7544_ = false;
                                                            } else {
                                                                phi_7544_ = true;
                                                            }
                                                            let _e3317 = phi_7544_;
                                                            phi_7866_ = _e3314;
                                                            phi_7867_ = f32();
                                                            phi_7868_ = false;
                                                            phi_7869_ = _e3317;
                                                            phi_7870_ = _e3315;
                                                        } else {
                                                            let _e3157 = local.member[0u];
                                                            let _e3160 = local.member_1[0u];
                                                            let _e3163 = local.member[0u];
                                                            let _e3169 = local.member_2[0u];
                                                            let _e3170 = ((_e3157 + ((_e3160 - _e3163) * _e2342)) - _e3169);
                                                            let _e3173 = local.member[1u];
                                                            let _e3176 = local.member_1[1u];
                                                            let _e3179 = local.member[1u];
                                                            let _e3185 = local.member_2[1u];
                                                            let _e3186 = ((_e3173 + ((_e3176 - _e3179) * _e2342)) - _e3185);
                                                            if (_e3170 < _e3186) {
                                                                phi_7617_ = _e3170;
                                                            } else {
                                                                phi_7617_ = _e3186;
                                                            }
                                                            let _e3189 = phi_7617_;
                                                            let _e3192 = local.member[2u];
                                                            let _e3195 = local.member_1[2u];
                                                            let _e3198 = local.member[2u];
                                                            let _e3204 = local.member_2[2u];
                                                            let _e3205 = ((_e3192 + ((_e3195 - _e3198) * _e2342)) - _e3204);
                                                            let _e3208 = local.member[3u];
                                                            let _e3211 = local.member_1[3u];
                                                            let _e3214 = local.member[3u];
                                                            let _e3220 = local.member_2[3u];
                                                            let _e3221 = ((_e3208 + ((_e3211 - _e3214) * _e2342)) - _e3220);
                                                            if (_e3205 < _e3221) {
                                                                phi_7690_ = _e3205;
                                                            } else {
                                                                phi_7690_ = _e3221;
                                                            }
                                                            let _e3224 = phi_7690_;
                                                            if (_e3189 < _e3224) {
                                                                phi_7695_ = _e3189;
                                                            } else {
                                                                phi_7695_ = _e3224;
                                                            }
                                                            let _e3227 = phi_7695_;
                                                            let _e3230 = local_1.member[0u];
                                                            let _e3233 = local_1.member_1[0u];
                                                            let _e3236 = local_1.member[0u];
                                                            let _e3242 = local_1.member_2[0u];
                                                            let _e3243 = ((_e3230 + ((_e3233 - _e3236) * _e2338)) - _e3242);
                                                            let _e3246 = local_1.member[1u];
                                                            let _e3249 = local_1.member_1[1u];
                                                            let _e3252 = local_1.member[1u];
                                                            let _e3258 = local_1.member_2[1u];
                                                            let _e3259 = ((_e3246 + ((_e3249 - _e3252) * _e2338)) - _e3258);
                                                            if (_e3243 < _e3259) {
                                                                phi_7768_ = _e3243;
                                                            } else {
                                                                phi_7768_ = _e3259;
                                                            }
                                                            let _e3262 = phi_7768_;
                                                            let _e3265 = local_1.member[2u];
                                                            let _e3268 = local_1.member_1[2u];
                                                            let _e3271 = local_1.member[2u];
                                                            let _e3277 = local_1.member_2[2u];
                                                            let _e3278 = ((_e3265 + ((_e3268 - _e3271) * _e2338)) - _e3277);
                                                            let _e3281 = local_1.member[3u];
                                                            let _e3284 = local_1.member_1[3u];
                                                            let _e3287 = local_1.member[3u];
                                                            let _e3293 = local_1.member_2[3u];
                                                            let _e3294 = ((_e3281 + ((_e3284 - _e3287) * _e2338)) - _e3293);
                                                            if (_e3278 < _e3294) {
                                                                phi_7841_ = _e3278;
                                                            } else {
                                                                phi_7841_ = _e3294;
                                                            }
                                                            let _e3297 = phi_7841_;
                                                            if (_e3262 < _e3297) {
                                                                phi_7846_ = _e3262;
                                                            } else {
                                                                phi_7846_ = _e3297;
                                                            }
                                                            let _e3300 = phi_7846_;
                                                            if (_e3300 > 0f) {
                                                                phi_7864_ = 0.5f;
                                                            } else {
                                                                let _e3304 = (0.95f * (_e3227 / (_e3227 - _e3300)));
                                                                if (_e3304 > 0.0625f) {
                                                                    if (_e3304 < 0.9f) {
                                                                        phi_7862_ = _e3304;
                                                                    } else {
                                                                        phi_7862_ = 0.9f;
                                                                    }
                                                                    let _e3308 = phi_7862_;
                                                                    phi_7863_ = _e3308;
                                                                } else {
                                                                    phi_7863_ = 0.0625f;
                                                                }
                                                                let _e3310 = phi_7863_;
                                                                phi_7864_ = _e3310;
                                                            }
                                                            let _e3312 = phi_7864_;
                                                            phi_7866_ = u32();
                                                            phi_7867_ = (_e2658 * _e3312);
                                                            phi_7868_ = true;
                                                            phi_7869_ = false;
                                                            phi_7870_ = false;
                                                        }
                                                        let _e3319 = phi_7866_;
                                                        let _e3321 = phi_7867_;
                                                        let _e3323 = phi_7868_;
                                                        let _e3325 = phi_7869_;
                                                        let _e3327 = phi_7870_;
                                                        phi_7871_ = _e3319;
                                                        phi_7872_ = _e2340;
                                                        phi_7873_ = _e3321;
                                                        phi_7874_ = _e2342;
                                                        phi_7875_ = _e2344;
                                                        phi_7876_ = _e2346;
                                                        phi_7877_ = _e3323;
                                                        phi_7878_ = _e3325;
                                                        phi_7879_ = _e3327;
                                                        phi_7880_ = false;
                                                        phi_7881_ = false;
                                                    } else {
                                                        phi_7871_ = u32();
                                                        phi_7872_ = _e3143;
                                                        phi_7873_ = _e3145;
                                                        phi_7874_ = _e2338;
                                                        phi_7875_ = true;
                                                        phi_7876_ = 0u;
                                                        phi_7877_ = _e3149;
                                                        phi_7878_ = false;
                                                        phi_7879_ = false;
                                                        phi_7880_ = _e3151;
                                                        phi_7881_ = _e3153;
                                                    }
                                                    let _e3329 = phi_7871_;
                                                    let _e3331 = phi_7872_;
                                                    let _e3333 = phi_7873_;
                                                    let _e3335 = phi_7874_;
                                                    let _e3337 = phi_7875_;
                                                    let _e3339 = phi_7876_;
                                                    let _e3341 = phi_7877_;
                                                    let _e3343 = phi_7878_;
                                                    let _e3345 = phi_7879_;
                                                    let _e3347 = phi_7880_;
                                                    let _e3349 = phi_7881_;
                                                    if _e3341 {
                                                        let _e3350 = (_e3335 + _e3333);
                                                        if (_e3350 > _e3331) {
                                                            phi_7890_ = _e3350;
                                                        } else {
                                                            phi_7890_ = _e3331;
                                                        }
                                                        let _e3353 = phi_7890_;
                                                        if (_e3353 < _e1393.member_1) {
                                                            phi_7895_ = _e3353;
                                                        } else {
                                                            phi_7895_ = _e1393.member_1;
                                                        }
                                                        let _e3356 = phi_7895_;
                                                        if !(_e2344) {
                                                            phi_7904_ = true;
                                                        } else {
                                                            phi_7904_ = ((_e3356 - _e3335) > 0.0000000037252903f);
                                                        }
                                                        let _e3360 = phi_7904_;
                                                        if _e3360 {
                                                            phi_7908_ = false;
                                                        } else {
                                                            phi_7908_ = true;
                                                        }
                                                        let _e3362 = phi_7908_;
                                                        phi_7909_ = _e3356;
                                                        phi_7910_ = _e3331;
                                                        phi_7911_ = _e3335;
                                                        phi_7912_ = _e3337;
                                                        phi_7913_ = _e3339;
                                                        phi_7914_ = _e3360;
                                                        phi_7915_ = _e3362;
                                                        phi_7916_ = false;
                                                        phi_7917_ = false;
                                                        phi_7918_ = false;
                                                    } else {
                                                        phi_7909_ = _e2338;
                                                        phi_7910_ = _e2340;
                                                        phi_7911_ = _e2342;
                                                        phi_7912_ = _e2344;
                                                        phi_7913_ = _e3329;
                                                        phi_7914_ = _e3343;
                                                        phi_7915_ = false;
                                                        phi_7916_ = _e3345;
                                                        phi_7917_ = _e3347;
                                                        phi_7918_ = _e3349;
                                                    }
                                                    let _e3364 = phi_7909_;
                                                    let _e3366 = phi_7910_;
                                                    let _e3368 = phi_7911_;
                                                    let _e3370 = phi_7912_;
                                                    let _e3372 = phi_7913_;
                                                    let _e3374 = phi_7914_;
                                                    let _e3376 = phi_7915_;
                                                    let _e3378 = phi_7916_;
                                                    let _e3380 = phi_7917_;
                                                    let _e3382 = phi_7918_;
                                                    phi_6251_ = _e3364;
                                                    phi_6253_ = _e3366;
                                                    phi_6255_ = _e3368;
                                                    phi_6257_ = _e3370;
                                                    phi_6259_ = _e3372;
                                                    phi_7919_ = _e3331;
                                                    phi_7920_ = _e3374;
                                                    phi_7921_ = _e3376;
                                                    phi_7922_ = false;
                                                    phi_7923_ = _e3378;
                                                    phi_7924_ = _e3380;
                                                    phi_7925_ = _e3382;
                                                } else {
                                                    phi_6251_ = f32();
                                                    phi_6253_ = f32();
                                                    phi_6255_ = f32();
                                                    phi_6257_ = bool();
                                                    phi_6259_ = u32();
                                                    phi_7919_ = f32();
                                                    phi_7920_ = false;
                                                    phi_7921_ = false;
                                                    phi_7922_ = true;
                                                    phi_7923_ = false;
                                                    phi_7924_ = false;
                                                    phi_7925_ = false;
                                                }
                                                let _e3384 = phi_6251_;
                                                let _e3386 = phi_6253_;
                                                let _e3388 = phi_6255_;
                                                let _e3390 = phi_6257_;
                                                let _e3392 = phi_6259_;
                                                let _e3394 = phi_7919_;
                                                let _e3396 = phi_7920_;
                                                let _e3398 = phi_7921_;
                                                let _e3400 = phi_7922_;
                                                let _e3402 = phi_7923_;
                                                let _e3404 = phi_7924_;
                                                let _e3406 = phi_7925_;
                                                local_19 = _e3398;
                                                local_35 = _e3394;
                                                local_37 = _e3400;
                                                local_38 = _e3402;
                                                local_39 = _e3404;
                                                local_40 = _e3406;
                                                continue;
                                                continuing {
                                                    phi_6247_ = _e2358;
                                                    phi_6250_ = _e3384;
                                                    phi_6252_ = _e3386;
                                                    phi_6254_ = _e3388;
                                                    phi_6256_ = _e3390;
                                                    phi_6258_ = _e3392;
                                                    break if !(_e3396);
                                                }
                                            }
                                            let _e3409 = local_19;
                                            if _e3409 {
                                                let _e5902 = local_35;
                                                phi_7929_ = _e5902;
                                                phi_7930_ = true;
                                                phi_7931_ = false;
                                                phi_7932_ = false;
                                                phi_7933_ = false;
                                            } else {
                                                let _e5904 = local_36;
                                                phi_7929_ = _e5904;
                                                let _e5907 = local_37;
                                                phi_7930_ = _e5907;
                                                let _e5910 = local_38;
                                                phi_7931_ = _e5910;
                                                let _e5913 = local_39;
                                                phi_7932_ = _e5913;
                                                let _e5916 = local_40;
                                                phi_7933_ = _e5916;
                                            }
                                            let _e3411 = phi_7929_;
                                            let _e3413 = phi_7930_;
                                            let _e3415 = phi_7931_;
                                            let _e3417 = phi_7932_;
                                            let _e3419 = phi_7933_;
                                            if _e3413 {
                                                phi_7938_ = type_30(1u, _e3411);
                                                phi_7939_ = false;
                                                phi_7940_ = false;
                                                phi_7941_ = false;
                                            } else {
                                                phi_7938_ = type_30();
                                                phi_7939_ = _e3415;
                                                phi_7940_ = _e3417;
                                                phi_7941_ = _e3419;
                                            }
                                            let _e3422 = phi_7938_;
                                            let _e3424 = phi_7939_;
                                            let _e3426 = phi_7940_;
                                            let _e3428 = phi_7941_;
                                            if _e3424 {
                                                let _e3430 = local_20;
                                                phi_7946_ = type_30(1u, _e3430);
                                                phi_7947_ = false;
                                                phi_7948_ = false;
                                            } else {
                                                phi_7946_ = type_30();
                                                phi_7947_ = _e3426;
                                                phi_7948_ = _e3428;
                                            }
                                            let _e3433 = phi_7946_;
                                            let _e3435 = phi_7947_;
                                            let _e3437 = phi_7948_;
                                            if _e3435 {
                                                phi_7953_ = type_30(0u, type_30().member_1);
                                                phi_7954_ = false;
                                                phi_7955_ = true;
                                            } else {
                                                phi_7953_ = _e3433;
                                                phi_7954_ = _e3437;
                                                phi_7955_ = _e3424;
                                            }
                                            let _e3441 = phi_7953_;
                                            let _e3443 = phi_7954_;
                                            let _e3445 = phi_7955_;
                                            if _e3443 {
                                                phi_7960_ = type_30(0u, type_30().member_1);
                                                phi_7961_ = true;
                                            } else {
                                                phi_7960_ = _e3441;
                                                phi_7961_ = _e3445;
                                            }
                                            let _e3449 = phi_7960_;
                                            let _e3451 = phi_7961_;
                                            if _e3451 {
                                                phi_7965_ = _e3449;
                                            } else {
                                                phi_7965_ = _e3422;
                                            }
                                            let _e3453 = phi_7965_;
                                            let _e3456 = (_e3453.member != 0u);
                                            if _e3456 {
                                                phi_7972_ = false;
                                            } else {
                                                phi_7972_ = true;
                                            }
                                            let _e3458 = phi_7972_;
                                            phi_7973_ = _e3453.member_1;
                                            phi_7974_ = _e3458;
                                            phi_7975_ = _e3456;
                                            phi_7976_ = false;
                                        } else {
                                            phi_7973_ = f32();
                                            phi_7974_ = false;
                                            phi_7975_ = false;
                                            phi_7976_ = true;
                                        }
                                        let _e3460 = phi_7973_;
                                        let _e3462 = phi_7974_;
                                        let _e3464 = phi_7975_;
                                        let _e3466 = phi_7976_;
                                        phi_7977_ = _e3460;
                                        phi_7978_ = _e3462;
                                        phi_7979_ = _e3464;
                                        phi_7980_ = _e3466;
                                    }
                                    let _e3468 = phi_7977_;
                                    let _e3470 = phi_7978_;
                                    let _e3472 = phi_7979_;
                                    let _e3474 = phi_7980_;
                                    phi_7981_ = _e3468;
                                    phi_7982_ = _e2094;
                                    phi_7983_ = _e3470;
                                    phi_7984_ = _e3472;
                                    phi_7985_ = _e3474;
                                }
                                let _e3476 = phi_7981_;
                                let _e3478 = phi_7982_;
                                let _e3480 = phi_7983_;
                                let _e3482 = phi_7984_;
                                let _e3484 = phi_7985_;
                                if _e3478 {
                                    phi_7989_ = true;
                                    phi_7990_ = false;
                                    phi_7991_ = false;
                                } else {
                                    phi_7989_ = _e3480;
                                    phi_7990_ = _e3482;
                                    phi_7991_ = _e3484;
                                }
                                let _e3486 = phi_7989_;
                                let _e3488 = phi_7990_;
                                let _e3490 = phi_7991_;
                                phi_7992_ = _e3476;
                                phi_7993_ = _e1393;
                                phi_7994_ = _e3486;
                                phi_7995_ = false;
                                phi_7996_ = _e3488;
                                phi_7997_ = _e3490;
                            } else {
                                phi_7992_ = f32();
                                phi_7993_ = type_37();
                                phi_7994_ = false;
                                phi_7995_ = true;
                                phi_7996_ = false;
                                phi_7997_ = false;
                            }
                            let _e3492 = phi_7992_;
                            let _e3494 = phi_7993_;
                            let _e3496 = phi_7994_;
                            let _e3498 = phi_7995_;
                            let _e3500 = phi_7996_;
                            let _e3502 = phi_7997_;
                            local_21 = _e3498;
                            local_41 = _e3500;
                            local_42 = _e3502;
                            local_22 = _e3492;
                            local_23 = _e3494;
                            continue;
                            continuing {
                                phi_4372_ = _e1123;
                                break if !(_e3496);
                            }
                        }
                        let _e3505 = local_21;
                        if _e3505 {
                            phi_8002_ = type_30(0u, type_30().member_1);
                            phi_8003_ = false;
                            phi_8004_ = false;
                        } else {
                            phi_8002_ = type_30();
                            let _e5958 = local_41;
                            phi_8003_ = _e5958;
                            let _e5961 = local_42;
                            phi_8004_ = _e5961;
                        }
                        let _e3509 = phi_8002_;
                        let _e3511 = phi_8003_;
                        let _e3513 = phi_8004_;
                        if _e3511 {
                            let _e3515 = local_22;
                            phi_8009_ = type_30(2u, _e3515);
                            phi_8010_ = false;
                        } else {
                            phi_8009_ = type_30();
                            phi_8010_ = _e3513;
                        }
                        let _e3518 = phi_8009_;
                        let _e3520 = phi_8010_;
                        if _e3520 {
                            let _e3522 = local_23;
                            phi_8016_ = type_30(1u, _e3522.member);
                            phi_8017_ = true;
                        } else {
                            phi_8016_ = _e3518;
                            phi_8017_ = _e3511;
                        }
                        let _e3526 = phi_8016_;
                        let _e3528 = phi_8017_;
                        if _e3528 {
                            phi_8021_ = _e3526;
                        } else {
                            phi_8021_ = _e3509;
                        }
                        let _e3530 = phi_8021_;
                        phi_8025_ = _e3530;
                    }
                    let _e5251 = phi_8025_;
                    phi_8026_ = _e5251;
                }
                let _e5255 = phi_8026_;
                switch bitcast<i32>(_e5255.member) {
                    case 0: {
                        phi_8039_ = type_38(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5261 = function_(_e5255.member_1);
                        phi_8039_ = type_38(0u, _e5261, true);
                        break;
                    }
                    case 2: {
                        let _e5259 = function_(_e5255.member_1);
                        phi_8039_ = type_38(1u, _e5259, true);
                        break;
                    }
                    default: {
                        phi_8039_ = type_38();
                        break;
                    }
                }
                let _e5264 = phi_8039_;
                if _e5264.member_2 {
                    phi_8046_ = (_e5264.member == 0u);
                } else {
                    phi_8046_ = false;
                }
                let _e5269 = phi_8046_;
                if _e5269 {
                    let _e5277 = (_e5264.member_1[1] >> bitcast<u32>(20i));
                    if (_e5277 <= 896u) {
                        phi_8070_ = 0u;
                    } else {
                        phi_8070_ = ((((_e5277 - 896u) << bitcast<u32>(23i)) | ((_e5264.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5264.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5292 = phi_8070_;
                    let _e5294 = atomicMin((&earliest.member[0u]), _e5292);
                }
                phi_8074_ = type_20(1u, 0u, _e176, _e179, _e5264.member_1);
                phi_8075_ = _e5269;
                phi_8076_ = (_e5264.member != 0u);
            } else {
                phi_8074_ = type_20(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8075_ = false;
                phi_8076_ = false;
            }
            let _e5296 = phi_8074_;
            let _e5298 = phi_8075_;
            let _e5300 = phi_8076_;
            let _e5303 = params.member.member.member_1;
            if ((_e5303 & 16u) != 0u) {
                if (_e105 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5298 {
                    let _e5309 = atomicAdd((&counters[0u]), 1u);
                    phi_8095_ = _e5309;
                } else {
                    phi_8095_ = 0u;
                }
                let _e5311 = phi_8095_;
                workgroupBarrier();
                if (_e105 == 0u) {
                    let _e5314 = atomicLoad((&counters[0u]));
                    if (_e5314 > 0u) {
                        let _e5317 = atomicAdd((&contacts.member[0u]), _e5314);
                        atomicStore((&counters[1u]), _e5317);
                    }
                }
                workgroupBarrier();
                let _e5320 = atomicLoad((&counters[1u]));
                let _e5321 = (_e5320 + _e5311);
                if _e5298 {
                    let _e5324 = params.member.member_1.member_3;
                    if (_e5321 < _e5324) {
                        let _e5326 = (6u * _e5321);
                        atomicStore((&contacts.member[(4u + _e5326)]), _e5296.member);
                        atomicStore((&contacts.member[(_e5326 + 5u)]), _e5296.member_1);
                        atomicStore((&contacts.member[(_e5326 + 6u)]), _e5296.member_2);
                        atomicStore((&contacts.member[(_e5326 + 7u)]), _e5296.member_3);
                        atomicStore((&contacts.member[(_e5326 + 8u)]), _e5296.member_4[0]);
                        atomicStore((&contacts.member[(_e5326 + 9u)]), _e5296.member_4[1]);
                    }
                }
            }
            workgroupBarrier();
            if (_e105 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e5300 {
                let _e5350 = atomicAdd((&counters[0u]), 1u);
                phi_8158_ = _e5350;
            } else {
                phi_8158_ = 0u;
            }
            let _e5352 = phi_8158_;
            workgroupBarrier();
            if (_e105 == 0u) {
                let _e5355 = atomicLoad((&counters[0u]));
                if (_e5355 > 0u) {
                    let _e5358 = atomicAdd((&undecided.member[0u]), _e5355);
                    atomicStore((&counters[1u]), _e5358);
                }
            }
            workgroupBarrier();
            let _e5361 = atomicLoad((&counters[1u]));
            let _e5362 = (_e5361 + _e5352);
            if _e5300 {
                let _e5365 = params.member.member_2.member;
                if (_e5362 < _e5365) {
                    let _e5369 = (2u * _e5362);
                    atomicStore((&undecided.member[(4u + _e5369)]), _e5296.member_2);
                    atomicStore((&undecided.member[(_e5369 + 5u)]), _e5296.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_264_ = _e161;
            break if !(_e167);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_3(id, n, lane);
}
