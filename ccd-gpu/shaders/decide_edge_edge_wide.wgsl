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
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_35 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_36 {
    member: f64,
    member_1: f64,
}

struct type_40 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_42 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_43 {
    member: type_40,
    member_1: f64,
}

struct type_44 {
    member: u32,
    member_1: f64,
}

struct type_45 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_48 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
@group(0) @binding(0) 
var<storage> params: type_28;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_48;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> positions: type_31;
@group(0) @binding(3) 
var<storage> elements: type_24;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_48;

fn function_(param: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_8939_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_8939_ = param_2;
    } else {
        phi_8939_ = param_1;
    }
    let _e26 = phi_8939_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_8503_: bool;
    var phi_8504_: bool;
    var phi_8505_: bool;
    var phi_8506_: bool;
    var phi_8510_: bool;
    var phi_8483_: bool;
    var phi_8484_: bool;
    var phi_8485_: bool;
    var phi_8486_: bool;
    var phi_8487_: bool;
    var phi_8488_: bool;
    var phi_8492_: bool;
    var phi_8511_: bool;
    var phi_8541_: array<f64, 3>;
    var phi_8542_: bool;
    var phi_8543_: array<f64, 3>;
    var phi_8544_: bool;
    var phi_8790_: f64;
    var phi_8792_: f64;
    var phi_8834_: f64;
    var phi_8836_: f64;
    var phi_8884_: f64;
    var phi_8886_: f64;
    var phi_8595_: f64;
    var phi_8597_: f64;
    var phi_8645_: f64;
    var phi_8647_: f64;
    var phi_8692_: f64;
    var phi_8694_: f64;
    var phi_8745_: f64;
    var phi_8747_: f64;
    var phi_8901_: array<array<f64, 3>, 4>;
    var phi_8909_: array<f64, 3>;

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
                    phi_8483_ = (_e78 <= _e70);
                    phi_8484_ = false;
                } else {
                    phi_8483_ = bool();
                    phi_8484_ = true;
                }
                let _e99 = phi_8483_;
                let _e101 = phi_8484_;
                phi_8485_ = _e99;
                phi_8486_ = _e101;
            } else {
                phi_8485_ = bool();
                phi_8486_ = true;
            }
            let _e103 = phi_8485_;
            let _e105 = phi_8486_;
            phi_8487_ = _e103;
            phi_8488_ = _e105;
        } else {
            phi_8487_ = bool();
            phi_8488_ = true;
        }
        let _e107 = phi_8487_;
        let _e109 = phi_8488_;
        if _e109 {
            phi_8492_ = false;
        } else {
            phi_8492_ = _e107;
        }
        let _e111 = phi_8492_;
        phi_8511_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_8503_ = ((_e74 + _e78) <= _e70);
                phi_8504_ = false;
            } else {
                phi_8503_ = bool();
                phi_8504_ = true;
            }
            let _e85 = phi_8503_;
            let _e87 = phi_8504_;
            phi_8505_ = _e85;
            phi_8506_ = _e87;
        } else {
            phi_8505_ = bool();
            phi_8506_ = true;
        }
        let _e89 = phi_8505_;
        let _e91 = phi_8506_;
        if _e91 {
            phi_8510_ = false;
        } else {
            phi_8510_ = _e89;
        }
        let _e93 = phi_8510_;
        phi_8511_ = _e93;
    }
    let _e113 = phi_8511_;
    if (_e68 > _e69) {
        if _e113 {
            phi_8541_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_8542_ = false;
        } else {
            phi_8541_ = array<f64, 3>();
            phi_8542_ = true;
        }
        let _e138 = phi_8541_;
        let _e140 = phi_8542_;
        phi_8543_ = _e138;
        phi_8544_ = _e140;
    } else {
        phi_8543_ = array<f64, 3>();
        phi_8544_ = true;
    }
    let _e142 = phi_8543_;
    let _e144 = phi_8544_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_8595_ = _e307;
                } else {
                    phi_8595_ = f64(1f);
                }
                let _e315 = phi_8595_;
                phi_8597_ = _e315;
            } else {
                phi_8597_ = f64(0f);
            }
            let _e317 = phi_8597_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_8645_ = _e353;
                } else {
                    phi_8645_ = f64(1f);
                }
                let _e361 = phi_8645_;
                phi_8647_ = _e361;
            } else {
                phi_8647_ = f64(0f);
            }
            let _e363 = phi_8647_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_8692_ = _e396;
                } else {
                    phi_8692_ = f64(1f);
                }
                let _e404 = phi_8692_;
                phi_8694_ = _e404;
            } else {
                phi_8694_ = f64(0f);
            }
            let _e406 = phi_8694_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_8745_ = _e445;
                } else {
                    phi_8745_ = f64(1f);
                }
                let _e453 = phi_8745_;
                phi_8747_ = _e453;
            } else {
                phi_8747_ = f64(0f);
            }
            let _e455 = phi_8747_;
            phi_8901_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_8790_ = _e174;
                } else {
                    phi_8790_ = f64(1f);
                }
                let _e182 = phi_8790_;
                phi_8792_ = _e182;
            } else {
                phi_8792_ = f64(0f);
            }
            let _e184 = phi_8792_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_8834_ = _e214;
                } else {
                    phi_8834_ = f64(1f);
                }
                let _e222 = phi_8834_;
                phi_8836_ = _e222;
            } else {
                phi_8836_ = f64(0f);
            }
            let _e224 = phi_8836_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_8884_ = _e260;
                } else {
                    phi_8884_ = f64(1f);
                }
                let _e268 = phi_8884_;
                phi_8886_ = _e268;
            } else {
                phi_8886_ = f64(0f);
            }
            let _e270 = phi_8886_;
            phi_8901_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_8901_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_8909_ = _e475;
    } else {
        phi_8909_ = _e142;
    }
    let _e477 = phi_8909_;
    return _e477;
}

fn function_3(param_7: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param_7[0]), f64(param_7[1]), f64(param_7[2]));
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_34;
    var local_1: type_34;
    var local_2: type_35;
    var local_3: type_35;
    var local_4: type_35;
    var local_5: array<type_36, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: array<f64, 4>;
    var local_9: type_34;
    var local_10: type_34;
    var local_11: array<f32, 3>;
    var local_12: type_40;
    var phi_238_: u32;
    var phi_254_: u32;
    var phi_275_: u32;
    var phi_276_: u32;
    var phi_279_: type_9;
    var phi_280_: type_9;
    var phi_303_: type_9;
    var phi_561_: type_42;
    var phi_655_: f64;
    var phi_661_: f64;
    var phi_666_: f64;
    var phi_672_: f64;
    var phi_677_: f64;
    var phi_683_: f64;
    var phi_689_: f64;
    var phi_694_: f64;
    var phi_700_: f64;
    var phi_705_: f64;
    var phi_710_: f64;
    var phi_717_: f64;
    var phi_723_: f64;
    var phi_728_: f64;
    var phi_734_: f64;
    var phi_739_: f64;
    var phi_745_: f64;
    var phi_751_: f64;
    var phi_756_: f64;
    var phi_762_: f64;
    var phi_767_: f64;
    var phi_772_: f64;
    var phi_779_: f64;
    var phi_785_: f64;
    var phi_790_: f64;
    var phi_796_: f64;
    var phi_801_: f64;
    var phi_807_: f64;
    var phi_813_: f64;
    var phi_818_: f64;
    var phi_824_: f64;
    var phi_829_: f64;
    var phi_834_: f64;
    var phi_840_: f64;
    var phi_845_: f64;
    var phi_854_: bool;
    var phi_878_: u64;
    var phi_890_: f64;
    var phi_891_: f64;
    var phi_922_: type_43;
    var phi_923_: bool;
    var phi_924_: type_43;
    var phi_925_: bool;
    var phi_926_: type_43;
    var phi_927_: bool;
    var phi_932_: type_43;
    var phi_1214_: f64;
    var phi_1221_: f64;
    var phi_1226_: f64;
    var phi_1233_: f64;
    var phi_1238_: f64;
    var phi_1251_: f64;
    var phi_1258_: f64;
    var phi_1263_: f64;
    var phi_1270_: f64;
    var phi_1275_: f64;
    var phi_1280_: f64;
    var phi_1297_: f64;
    var phi_1304_: f64;
    var phi_1309_: f64;
    var phi_1316_: f64;
    var phi_1321_: f64;
    var phi_1335_: f64;
    var phi_1342_: f64;
    var phi_1347_: f64;
    var phi_1354_: f64;
    var phi_1359_: f64;
    var phi_1364_: f64;
    var phi_1381_: f64;
    var phi_1388_: f64;
    var phi_1393_: f64;
    var phi_1400_: f64;
    var phi_1405_: f64;
    var phi_1419_: f64;
    var phi_1426_: f64;
    var phi_1431_: f64;
    var phi_1438_: f64;
    var phi_1443_: f64;
    var phi_1448_: f64;
    var phi_1485_: f64;
    var phi_1491_: f64;
    var phi_1498_: f64;
    var phi_1505_: f64;
    var phi_1511_: f64;
    var phi_1518_: f64;
    var phi_1524_: f64;
    var phi_1530_: f64;
    var phi_1536_: f64;
    var phi_1543_: f64;
    var phi_1550_: f64;
    var phi_1578_: f64;
    var phi_1583_: f64;
    var phi_1588_: f64;
    var phi_1593_: f64;
    var phi_1598_: f64;
    var phi_1603_: f64;
    var phi_1614_: f64;
    var phi_4311_: f64;
    var phi_4317_: f64;
    var phi_4322_: f64;
    var phi_4328_: f64;
    var phi_4334_: f64;
    var phi_4339_: f64;
    var phi_4344_: f64;
    var phi_4354_: bool;
    var phi_4361_: f64;
    var phi_4369_: f64;
    var phi_4412_: type_16;
    var phi_4415_: f64;
    var phi_4436_: bool;
    var phi_4442_: type_17;
    var phi_4413_: type_16;
    var phi_4456_: type_17;
    var phi_4416_: f64;
    var local_13: f64;
    var phi_4405_: f64;
    var phi_4469_: f64;
    var phi_4475_: f64;
    var phi_4500_: type_9;
    var phi_4503_: u32;
    var phi_4501_: type_9;
    var phi_4526_: type_9;
    var phi_4570_: u32;
    var phi_4571_: u32;
    var phi_4504_: u32;
    var phi_4572_: u32;
    var phi_4592_: type_9;
    var phi_4593_: type_9;
    var phi_4616_: type_9;
    var phi_4670_: f64;
    var phi_4677_: f64;
    var phi_4689_: bool;
    var phi_4690_: bool;
    var phi_4691_: bool;
    var phi_4692_: bool;
    var phi_4696_: bool;
    var phi_4708_: type_45;
    var phi_4709_: type_45;
    var phi_4710_: bool;
    var phi_4711_: type_45;
    var phi_4712_: bool;
    var phi_4725_: f64;
    var phi_4738_: type_9;
    var phi_4741_: f64;
    var phi_4743_: f64;
    var phi_4745_: f64;
    var phi_4739_: type_9;
    var phi_4768_: type_9;
    var phi_4795_: f64;
    var phi_4796_: f64;
    var phi_4824_: f64;
    var phi_4840_: f64;
    var phi_4847_: bool;
    var phi_4848_: bool;
    var phi_4849_: bool;
    var phi_4855_: f64;
    var phi_4856_: f64;
    var phi_4857_: bool;
    var phi_4742_: f64;
    var phi_4744_: f64;
    var phi_4746_: f64;
    var phi_4858_: f64;
    var phi_4859_: bool;
    var phi_4860_: bool;
    var local_14: bool;
    var phi_4864_: f64;
    var phi_4865_: f64;
    var phi_4875_: f64;
    var phi_4880_: type_9;
    var phi_4883_: f64;
    var phi_4881_: type_9;
    var phi_4906_: type_9;
    var phi_4937_: f64;
    var phi_4938_: bool;
    var phi_4939_: f64;
    var phi_4940_: bool;
    var phi_4941_: bool;
    var phi_4942_: bool;
    var phi_4943_: f64;
    var phi_4884_: f64;
    var phi_4944_: bool;
    var phi_4945_: bool;
    var phi_4946_: bool;
    var phi_4947_: bool;
    var local_15: bool;
    var phi_4951_: bool;
    var phi_4952_: bool;
    var phi_4956_: bool;
    var phi_4960_: f64;
    var phi_4961_: f64;
    var phi_4963_: type_45;
    var phi_4994_: f64;
    var phi_5001_: f64;
    var phi_5006_: f64;
    var phi_5013_: f64;
    var phi_5018_: f64;
    var phi_5031_: f64;
    var phi_5038_: f64;
    var phi_5043_: f64;
    var phi_5050_: f64;
    var phi_5055_: f64;
    var phi_5060_: f64;
    var phi_5119_: f64;
    var phi_5125_: f64;
    var phi_5130_: f64;
    var phi_5136_: f64;
    var phi_5141_: f64;
    var phi_5155_: f64;
    var phi_5161_: f64;
    var phi_5166_: f64;
    var phi_5172_: f64;
    var phi_5177_: f64;
    var phi_5203_: f64;
    var phi_5210_: f64;
    var phi_5215_: f64;
    var phi_5222_: f64;
    var phi_5227_: f64;
    var phi_5240_: f64;
    var phi_5247_: f64;
    var phi_5252_: f64;
    var phi_5259_: f64;
    var phi_5264_: f64;
    var phi_5269_: f64;
    var phi_5328_: f64;
    var phi_5334_: f64;
    var phi_5339_: f64;
    var phi_5345_: f64;
    var phi_5350_: f64;
    var phi_5364_: f64;
    var phi_5370_: f64;
    var phi_5375_: f64;
    var phi_5381_: f64;
    var phi_5386_: f64;
    var phi_5412_: f64;
    var phi_5419_: f64;
    var phi_5424_: f64;
    var phi_5431_: f64;
    var phi_5436_: f64;
    var phi_5449_: f64;
    var phi_5456_: f64;
    var phi_5461_: f64;
    var phi_5468_: f64;
    var phi_5473_: f64;
    var phi_5478_: f64;
    var phi_5537_: f64;
    var phi_5543_: f64;
    var phi_5548_: f64;
    var phi_5554_: f64;
    var phi_5559_: f64;
    var phi_5573_: f64;
    var phi_5579_: f64;
    var phi_5584_: f64;
    var phi_5590_: f64;
    var phi_5595_: f64;
    var phi_5644_: f64;
    var phi_5650_: f64;
    var phi_5678_: f64;
    var phi_5684_: f64;
    var phi_5689_: u32;
    var phi_5690_: u32;
    var phi_5660_: f64;
    var phi_5666_: f64;
    var phi_5671_: u32;
    var phi_5672_: u32;
    var phi_5691_: u32;
    var phi_5692_: u32;
    var phi_5765_: f64;
    var phi_5777_: f64;
    var phi_5920_: f64;
    var phi_5926_: f64;
    var phi_5933_: f64;
    var phi_5977_: type_9;
    var phi_5980_: bool;
    var phi_5978_: type_9;
    var phi_6003_: type_9;
    var phi_6030_: bool;
    var phi_6031_: bool;
    var phi_5981_: bool;
    var phi_6032_: bool;
    var phi_6033_: bool;
    var local_16: bool;
    var phi_6037_: bool;
    var local_17: bool;
    var phi_6044_: u32;
    var phi_6045_: u32;
    var phi_6046_: bool;
    var phi_6047_: u32;
    var phi_6048_: u32;
    var phi_6049_: bool;
    var phi_6053_: u32;
    var phi_6074_: bool;
    var phi_6075_: bool;
    var phi_6076_: bool;
    var phi_6225_: f64;
    var phi_6232_: f64;
    var phi_6237_: f64;
    var phi_6244_: f64;
    var phi_6249_: f64;
    var phi_6262_: f64;
    var phi_6269_: f64;
    var phi_6274_: f64;
    var phi_6281_: f64;
    var phi_6286_: f64;
    var phi_6291_: f64;
    var phi_6308_: f64;
    var phi_6315_: f64;
    var phi_6320_: f64;
    var phi_6327_: f64;
    var phi_6332_: f64;
    var phi_6346_: f64;
    var phi_6353_: f64;
    var phi_6358_: f64;
    var phi_6365_: f64;
    var phi_6370_: f64;
    var phi_6375_: f64;
    var phi_6392_: f64;
    var phi_6399_: f64;
    var phi_6404_: f64;
    var phi_6411_: f64;
    var phi_6416_: f64;
    var phi_6430_: f64;
    var phi_6437_: f64;
    var phi_6442_: f64;
    var phi_6449_: f64;
    var phi_6454_: f64;
    var phi_6459_: f64;
    var phi_6503_: type_9;
    var phi_6506_: f64;
    var phi_6508_: f64;
    var phi_6510_: f64;
    var phi_6504_: type_9;
    var phi_6533_: type_9;
    var phi_6645_: f64;
    var phi_6652_: f64;
    var phi_6660_: f64;
    var phi_6706_: type_16;
    var phi_6709_: f64;
    var phi_6730_: bool;
    var phi_6736_: type_17;
    var phi_6707_: type_16;
    var phi_6750_: type_17;
    var phi_6710_: f64;
    var local_18: f64;
    var phi_6699_: f64;
    var phi_6763_: f64;
    var phi_6832_: f64;
    var phi_6838_: f64;
    var phi_6847_: f64;
    var phi_6853_: f64;
    var phi_6862_: f64;
    var phi_6868_: f64;
    var phi_6877_: f64;
    var phi_6883_: f64;
    var phi_6889_: type_34;
    var phi_6890_: bool;
    var phi_6891_: type_34;
    var phi_6892_: bool;
    var phi_6902_: type_34;
    var phi_7073_: bool;
    var phi_7074_: bool;
    var phi_7075_: bool;
    var phi_7076_: bool;
    var phi_7077_: bool;
    var phi_7078_: bool;
    var phi_7082_: bool;
    var phi_7380_: bool;
    var phi_7381_: bool;
    var phi_7382_: bool;
    var phi_7383_: bool;
    var phi_7384_: bool;
    var phi_7385_: bool;
    var phi_7389_: bool;
    var phi_7393_: bool;
    var phi_7405_: bool;
    var phi_7406_: bool;
    var phi_7480_: bool;
    var phi_7481_: bool;
    var phi_7504_: f64;
    var phi_7505_: bool;
    var phi_7506_: f64;
    var phi_7507_: bool;
    var phi_7508_: f64;
    var phi_7509_: bool;
    var phi_7510_: bool;
    var phi_7515_: f64;
    var phi_7516_: bool;
    var phi_7520_: f64;
    var phi_7552_: bool;
    var phi_7553_: bool;
    var phi_7576_: f64;
    var phi_7577_: bool;
    var phi_7578_: f64;
    var phi_7579_: bool;
    var phi_7580_: f64;
    var phi_7581_: bool;
    var phi_7582_: bool;
    var phi_7587_: f64;
    var phi_7588_: bool;
    var phi_7592_: f64;
    var phi_7597_: f64;
    var phi_7629_: bool;
    var phi_7630_: bool;
    var phi_7653_: f64;
    var phi_7654_: bool;
    var phi_7655_: f64;
    var phi_7656_: bool;
    var phi_7657_: f64;
    var phi_7658_: bool;
    var phi_7659_: bool;
    var phi_7664_: f64;
    var phi_7665_: bool;
    var phi_7669_: f64;
    var phi_7701_: bool;
    var phi_7702_: bool;
    var phi_7725_: f64;
    var phi_7726_: bool;
    var phi_7727_: f64;
    var phi_7728_: bool;
    var phi_7729_: f64;
    var phi_7730_: bool;
    var phi_7731_: bool;
    var phi_7736_: f64;
    var phi_7737_: bool;
    var phi_7741_: f64;
    var phi_7746_: f64;
    var phi_7751_: f64;
    var phi_7756_: f64;
    var phi_7767_: f64;
    var phi_7768_: f64;
    var phi_7769_: bool;
    var phi_7770_: f64;
    var phi_7771_: f64;
    var phi_7772_: bool;
    var phi_7773_: bool;
    var phi_7774_: bool;
    var phi_7775_: f64;
    var phi_7776_: f64;
    var phi_7777_: bool;
    var phi_7778_: bool;
    var phi_7779_: bool;
    var phi_7780_: bool;
    var phi_7781_: f64;
    var phi_7782_: f64;
    var phi_7783_: bool;
    var phi_7784_: bool;
    var phi_7785_: bool;
    var phi_7786_: bool;
    var phi_7866_: f64;
    var phi_7939_: f64;
    var phi_7944_: f64;
    var phi_8017_: f64;
    var phi_8090_: f64;
    var phi_8095_: f64;
    var phi_8116_: f64;
    var phi_8117_: f64;
    var phi_8118_: f64;
    var phi_8120_: f64;
    var phi_8121_: bool;
    var phi_8122_: f64;
    var phi_8123_: f64;
    var phi_8124_: f64;
    var phi_8125_: bool;
    var phi_8126_: bool;
    var phi_8127_: bool;
    var phi_8128_: bool;
    var phi_8137_: f64;
    var phi_8142_: f64;
    var phi_8153_: bool;
    var phi_8157_: bool;
    var phi_8158_: f64;
    var phi_8159_: bool;
    var phi_8160_: bool;
    var phi_8161_: bool;
    var phi_8162_: bool;
    var phi_8163_: bool;
    var phi_6507_: f64;
    var phi_6509_: f64;
    var phi_6511_: f64;
    var phi_8164_: f64;
    var phi_8165_: bool;
    var phi_8166_: bool;
    var phi_8167_: bool;
    var phi_8168_: bool;
    var phi_8169_: bool;
    var phi_8170_: bool;
    var local_19: bool;
    var phi_8174_: f64;
    var phi_8175_: bool;
    var phi_8176_: bool;
    var phi_8177_: bool;
    var phi_8178_: bool;
    var phi_8183_: type_44;
    var phi_8184_: bool;
    var phi_8185_: bool;
    var phi_8186_: bool;
    var local_20: f64;
    var phi_8191_: type_44;
    var phi_8192_: bool;
    var phi_8193_: bool;
    var phi_8198_: type_44;
    var phi_8199_: bool;
    var phi_8200_: bool;
    var phi_8205_: type_44;
    var phi_8206_: bool;
    var phi_8210_: type_44;
    var phi_8217_: bool;
    var phi_8218_: f64;
    var phi_8219_: bool;
    var phi_8220_: bool;
    var phi_8221_: bool;
    var phi_8222_: f64;
    var phi_8223_: bool;
    var phi_8224_: bool;
    var phi_8225_: bool;
    var phi_8226_: f64;
    var phi_8227_: bool;
    var phi_8228_: bool;
    var phi_8229_: bool;
    var phi_8230_: bool;
    var phi_8234_: bool;
    var phi_8235_: bool;
    var phi_8236_: bool;
    var phi_8237_: f64;
    var phi_8238_: type_45;
    var phi_8239_: bool;
    var phi_8240_: bool;
    var phi_8241_: bool;
    var phi_8242_: bool;
    var local_21: bool;
    var phi_8247_: type_44;
    var phi_8248_: bool;
    var phi_8249_: bool;
    var local_22: f64;
    var phi_8254_: type_44;
    var phi_8255_: bool;
    var local_23: type_45;
    var phi_8261_: type_44;
    var phi_8262_: bool;
    var phi_8266_: type_44;
    var phi_1771_: f64;
    var phi_1778_: f64;
    var phi_1783_: f64;
    var phi_1790_: f64;
    var phi_1795_: f64;
    var phi_1808_: f64;
    var phi_1815_: f64;
    var phi_1820_: f64;
    var phi_1827_: f64;
    var phi_1832_: f64;
    var phi_1837_: f64;
    var phi_1854_: f64;
    var phi_1861_: f64;
    var phi_1866_: f64;
    var phi_1873_: f64;
    var phi_1878_: f64;
    var phi_1892_: f64;
    var phi_1899_: f64;
    var phi_1904_: f64;
    var phi_1911_: f64;
    var phi_1916_: f64;
    var phi_1921_: f64;
    var phi_1938_: f64;
    var phi_1945_: f64;
    var phi_1950_: f64;
    var phi_1957_: f64;
    var phi_1962_: f64;
    var phi_1976_: f64;
    var phi_1983_: f64;
    var phi_1988_: f64;
    var phi_1995_: f64;
    var phi_2000_: f64;
    var phi_2005_: f64;
    var phi_2049_: type_9;
    var phi_2052_: f64;
    var phi_2054_: f64;
    var phi_2056_: f64;
    var phi_2050_: type_9;
    var phi_2079_: type_9;
    var phi_2191_: f64;
    var phi_2198_: f64;
    var phi_2206_: f64;
    var phi_2252_: type_16;
    var phi_2255_: f64;
    var phi_2276_: bool;
    var phi_2282_: type_17;
    var phi_2253_: type_16;
    var phi_2296_: type_17;
    var phi_2256_: f64;
    var local_24: f64;
    var phi_2245_: f64;
    var phi_2309_: f64;
    var phi_2378_: f64;
    var phi_2384_: f64;
    var phi_2393_: f64;
    var phi_2399_: f64;
    var phi_2408_: f64;
    var phi_2414_: f64;
    var phi_2423_: f64;
    var phi_2429_: f64;
    var phi_2435_: type_34;
    var phi_2436_: bool;
    var phi_2437_: type_34;
    var phi_2438_: bool;
    var phi_2448_: type_34;
    var phi_2619_: bool;
    var phi_2620_: bool;
    var phi_2621_: bool;
    var phi_2622_: bool;
    var phi_2623_: bool;
    var phi_2624_: bool;
    var phi_2628_: bool;
    var phi_2926_: bool;
    var phi_2927_: bool;
    var phi_2928_: bool;
    var phi_2929_: bool;
    var phi_2930_: bool;
    var phi_2931_: bool;
    var phi_2935_: bool;
    var phi_2939_: bool;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_3026_: bool;
    var phi_3027_: bool;
    var phi_3050_: f64;
    var phi_3051_: bool;
    var phi_3052_: f64;
    var phi_3053_: bool;
    var phi_3054_: f64;
    var phi_3055_: bool;
    var phi_3056_: bool;
    var phi_3061_: f64;
    var phi_3062_: bool;
    var phi_3066_: f64;
    var phi_3098_: bool;
    var phi_3099_: bool;
    var phi_3122_: f64;
    var phi_3123_: bool;
    var phi_3124_: f64;
    var phi_3125_: bool;
    var phi_3126_: f64;
    var phi_3127_: bool;
    var phi_3128_: bool;
    var phi_3133_: f64;
    var phi_3134_: bool;
    var phi_3138_: f64;
    var phi_3143_: f64;
    var phi_3175_: bool;
    var phi_3176_: bool;
    var phi_3199_: f64;
    var phi_3200_: bool;
    var phi_3201_: f64;
    var phi_3202_: bool;
    var phi_3203_: f64;
    var phi_3204_: bool;
    var phi_3205_: bool;
    var phi_3210_: f64;
    var phi_3211_: bool;
    var phi_3215_: f64;
    var phi_3247_: bool;
    var phi_3248_: bool;
    var phi_3271_: f64;
    var phi_3272_: bool;
    var phi_3273_: f64;
    var phi_3274_: bool;
    var phi_3275_: f64;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_3282_: f64;
    var phi_3283_: bool;
    var phi_3287_: f64;
    var phi_3292_: f64;
    var phi_3297_: f64;
    var phi_3302_: f64;
    var phi_3313_: f64;
    var phi_3314_: f64;
    var phi_3315_: bool;
    var phi_3316_: f64;
    var phi_3317_: f64;
    var phi_3318_: bool;
    var phi_3319_: bool;
    var phi_3320_: bool;
    var phi_3321_: f64;
    var phi_3322_: f64;
    var phi_3323_: bool;
    var phi_3324_: bool;
    var phi_3325_: bool;
    var phi_3326_: bool;
    var phi_3327_: f64;
    var phi_3328_: f64;
    var phi_3329_: bool;
    var phi_3330_: bool;
    var phi_3331_: bool;
    var phi_3332_: bool;
    var phi_3412_: f64;
    var phi_3485_: f64;
    var phi_3490_: f64;
    var phi_3563_: f64;
    var phi_3636_: f64;
    var phi_3641_: f64;
    var phi_3662_: f64;
    var phi_3663_: f64;
    var phi_3664_: f64;
    var phi_3666_: f64;
    var phi_3667_: bool;
    var phi_3668_: f64;
    var phi_3669_: f64;
    var phi_3670_: f64;
    var phi_3671_: bool;
    var phi_3672_: bool;
    var phi_3673_: bool;
    var phi_3674_: bool;
    var phi_3683_: f64;
    var phi_3688_: f64;
    var phi_3699_: bool;
    var phi_3703_: bool;
    var phi_3704_: f64;
    var phi_3705_: bool;
    var phi_3706_: bool;
    var phi_3707_: bool;
    var phi_3708_: bool;
    var phi_3709_: bool;
    var phi_2053_: f64;
    var phi_2055_: f64;
    var phi_2057_: f64;
    var phi_3710_: f64;
    var phi_3711_: bool;
    var phi_3712_: bool;
    var phi_3713_: bool;
    var phi_3714_: bool;
    var phi_3715_: bool;
    var phi_3716_: bool;
    var local_25: bool;
    var phi_3720_: f64;
    var phi_3721_: bool;
    var phi_3722_: bool;
    var phi_3723_: bool;
    var phi_3724_: bool;
    var phi_3729_: type_44;
    var phi_3730_: bool;
    var phi_3731_: bool;
    var phi_3732_: bool;
    var local_26: f64;
    var phi_3737_: type_44;
    var phi_3738_: bool;
    var phi_3739_: bool;
    var phi_3744_: type_44;
    var phi_3745_: bool;
    var phi_3746_: bool;
    var phi_3751_: type_44;
    var phi_3752_: bool;
    var phi_3756_: type_44;
    var phi_3770_: type_9;
    var phi_3771_: type_9;
    var phi_3794_: type_9;
    var phi_3815_: f64;
    var phi_3945_: type_16;
    var phi_3948_: f64;
    var phi_3969_: bool;
    var phi_3975_: type_17;
    var phi_3946_: type_16;
    var phi_3989_: type_17;
    var phi_3949_: f64;
    var local_27: f64;
    var phi_3938_: f64;
    var phi_4002_: f64;
    var phi_4020_: f64;
    var phi_4027_: f64;
    var phi_4032_: f64;
    var phi_4039_: f64;
    var phi_4044_: f64;
    var phi_4057_: f64;
    var phi_4064_: f64;
    var phi_4069_: f64;
    var phi_4076_: f64;
    var phi_4081_: f64;
    var phi_4086_: f64;
    var phi_4103_: f64;
    var phi_4110_: f64;
    var phi_4115_: f64;
    var phi_4122_: f64;
    var phi_4127_: f64;
    var phi_4141_: f64;
    var phi_4148_: f64;
    var phi_4153_: f64;
    var phi_4160_: f64;
    var phi_4165_: f64;
    var phi_4170_: f64;
    var phi_4187_: f64;
    var phi_4194_: f64;
    var phi_4199_: f64;
    var phi_4206_: f64;
    var phi_4211_: f64;
    var phi_4225_: f64;
    var phi_4232_: f64;
    var phi_4237_: f64;
    var phi_4244_: f64;
    var phi_4249_: f64;
    var phi_4254_: f64;
    var phi_4278_: bool;
    var phi_4279_: bool;
    var phi_4280_: bool;
    var local_28: bool;
    var phi_4285_: type_44;
    var phi_4286_: bool;
    var phi_4291_: type_44;
    var phi_4292_: bool;
    var phi_4294_: type_44;
    var phi_4295_: type_44;
    var phi_4296_: bool;
    var phi_4300_: type_44;
    var phi_8270_: type_44;
    var phi_8271_: type_44;
    var phi_8284_: type_32;
    var phi_8307_: u32;
    var phi_8311_: type_22;
    var phi_8312_: bool;
    var phi_8331_: u32;
    var local_29: u32;
    var local_30: f64;
    var local_31: f64;
    var local_32: bool;
    var local_33: bool;
    var local_34: f64;
    var local_35: f64;
    var local_36: f64;
    var local_37: bool;
    var local_38: bool;
    var local_39: bool;
    var local_40: bool;
    var local_41: bool;
    var local_42: bool;
    var local_43: f64;
    var local_44: f64;
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
    let _e108 = id_2;
    let _e109 = n_2;
    let _e110 = lane_2;
    let _e122 = ((_e108.y * _e109.x) + _e108.x);
    let _e125 = (_e109.x * _e109.y);
    let _e128 = params.member.member_1.member_2;
    let _e130 = input.member[0u];
    if (_e128 < _e130) {
        phi_238_ = _e128;
    } else {
        phi_238_ = _e130;
    }
    let _e133 = phi_238_;
    let _e134 = (_e133 / 64u);
    if ((_e133 % 64u) > 0u) {
        phi_254_ = (_e134 + 1u);
    } else {
        phi_254_ = _e134;
    }
    let _e139 = phi_254_;
    if (_e139 > _e122) {
        let _e141 = (_e139 - _e122);
        if (_e125 == 0u) {
            return;
        }
        let _e143 = (_e141 / _e125);
        if (_e125 == 0u) {
            return;
        }
        if ((_e141 % _e125) > 0u) {
            phi_275_ = (_e143 + 1u);
        } else {
            phi_275_ = _e143;
        }
        let _e149 = phi_275_;
        phi_276_ = _e149;
    } else {
        phi_276_ = 0u;
    }
    let _e151 = phi_276_;
    phi_279_ = type_9(0u, _e151);
    loop {
        let _e154 = phi_279_;
        if (_e154.member < _e154.member_1) {
            phi_280_ = type_9((_e154.member + 1u), _e154.member_1);
            phi_303_ = type_9(1u, _e154.member);
        } else {
            phi_280_ = _e154;
            phi_303_ = type_9(0u, type_9().member_1);
        }
        let _e166 = phi_280_;
        let _e168 = phi_303_;
        let _e172 = (bitcast<i32>(_e168.member) != 0i);
        if _e172 {
            let _e176 = (((_e122 + (_e168.member_1 * _e125)) * 64u) + _e110);
            if (_e176 < _e133) {
                let _e178 = (2u * _e176);
                let _e181 = input.member[(4u + _e178)];
                let _e184 = input.member[(_e178 + 5u)];
                let _e187 = elements.member[_e181];
                let _e189 = elements.member[_e184];
                let _e195 = params.member.member.member_1;
                if ((_e195 & 8u) != 0u) {
                    let _e234 = paths.member[_e187[0]];
                    let _e236 = paths.member[_e187[1]];
                    let _e242 = paths.member[_e189[0]];
                    let _e244 = paths.member[_e189[1]];
                    let _e281 = function_3(array<f32, 3>(_e234.member[0], _e234.member[1], _e234.member[2]));
                    let _e282 = function_3(array<f32, 3>(_e236.member[0], _e236.member[1], _e236.member[2]));
                    let _e283 = function_3(array<f32, 3>(_e242.member[0], _e242.member[1], _e242.member[2]));
                    let _e284 = function_3(array<f32, 3>(_e244.member[0], _e244.member[1], _e244.member[2]));
                    let _e286 = function_3(array<f32, 3>(_e234.member_1[0], _e234.member_1[1], _e234.member_1[2]));
                    let _e287 = function_3(array<f32, 3>(_e236.member_1[0], _e236.member_1[1], _e236.member_1[2]));
                    let _e288 = function_3(array<f32, 3>(_e242.member_1[0], _e242.member_1[1], _e242.member_1[2]));
                    let _e289 = function_3(array<f32, 3>(_e244.member_1[0], _e244.member_1[1], _e244.member_1[2]));
                    phi_561_ = type_42(array<array<f64, 3>, 4>(_e281, _e282, _e283, _e284), array<array<f64, 3>, 4>(_e286, _e287, _e288, _e289));
                } else {
                    let _e199 = positions.member[_e187[0]];
                    let _e202 = params.member.member.member[0u];
                    let _e205 = positions.member[(_e202 + _e187[0])];
                    let _e207 = positions.member[_e187[1]];
                    let _e210 = params.member.member.member[0u];
                    let _e213 = positions.member[(_e210 + _e187[1])];
                    let _e215 = positions.member[_e189[0]];
                    let _e218 = params.member.member.member[0u];
                    let _e221 = positions.member[(_e218 + _e189[0])];
                    let _e223 = positions.member[_e189[1]];
                    let _e226 = params.member.member.member[0u];
                    let _e229 = positions.member[(_e226 + _e189[1])];
                    phi_561_ = type_42(array<array<f64, 3>, 4>(_e199, _e207, _e215, _e223), array<array<f64, 3>, 4>(_e205, _e213, _e221, _e229));
                }
                let _e293 = phi_561_;
                let _e300 = (_e293.member[2][0] - _e293.member[0][0]);
                let _e303 = (_e293.member[2][1] - _e293.member[0][1]);
                let _e306 = (_e293.member[2][2] - _e293.member[0][2]);
                let _e312 = (_e293.member_1[2][0] - _e293.member_1[0][0]);
                let _e315 = (_e293.member_1[2][1] - _e293.member_1[0][1]);
                let _e318 = (_e293.member_1[2][2] - _e293.member_1[0][2]);
                let _e325 = (_e293.member[1][0] - _e293.member[0][0]);
                let _e328 = (_e293.member[1][1] - _e293.member[0][1]);
                let _e331 = (_e293.member[1][2] - _e293.member[0][2]);
                let _e337 = (_e293.member_1[1][0] - _e293.member_1[0][0]);
                let _e340 = (_e293.member_1[1][1] - _e293.member_1[0][1]);
                let _e343 = (_e293.member_1[1][2] - _e293.member_1[0][2]);
                let _e350 = (_e293.member[2][0] - _e293.member[3][0]);
                let _e353 = (_e293.member[2][1] - _e293.member[3][1]);
                let _e356 = (_e293.member[2][2] - _e293.member[3][2]);
                let _e362 = (_e293.member_1[2][0] - _e293.member_1[3][0]);
                let _e365 = (_e293.member_1[2][1] - _e293.member_1[3][1]);
                let _e368 = (_e293.member_1[2][2] - _e293.member_1[3][2]);
                let _e371 = (0.0lf + 0.0lf);
                let _e374 = params.member.member.member_7;
                let _e381 = bitcast<f64>(((u64(_e374[1]) * 4294967296lu) + u64(_e374[0])));
                if (_e300 < 0.0lf) {
                    phi_655_ = -(_e300);
                } else {
                    phi_655_ = _e300;
                }
                let _e385 = phi_655_;
                if (_e303 < 0.0lf) {
                    phi_661_ = -(_e303);
                } else {
                    phi_661_ = _e303;
                }
                let _e389 = phi_661_;
                if (_e385 > _e389) {
                    phi_666_ = _e385;
                } else {
                    phi_666_ = _e389;
                }
                let _e392 = phi_666_;
                if (_e306 < 0.0lf) {
                    phi_672_ = -(_e306);
                } else {
                    phi_672_ = _e306;
                }
                let _e396 = phi_672_;
                if (_e392 > _e396) {
                    phi_677_ = _e392;
                } else {
                    phi_677_ = _e396;
                }
                let _e399 = phi_677_;
                if (_e312 < 0.0lf) {
                    phi_683_ = -(_e312);
                } else {
                    phi_683_ = _e312;
                }
                let _e403 = phi_683_;
                if (_e315 < 0.0lf) {
                    phi_689_ = -(_e315);
                } else {
                    phi_689_ = _e315;
                }
                let _e407 = phi_689_;
                if (_e403 > _e407) {
                    phi_694_ = _e403;
                } else {
                    phi_694_ = _e407;
                }
                let _e410 = phi_694_;
                if (_e318 < 0.0lf) {
                    phi_700_ = -(_e318);
                } else {
                    phi_700_ = _e318;
                }
                let _e414 = phi_700_;
                if (_e410 > _e414) {
                    phi_705_ = _e410;
                } else {
                    phi_705_ = _e414;
                }
                let _e417 = phi_705_;
                if (_e399 > _e417) {
                    phi_710_ = _e399;
                } else {
                    phi_710_ = _e417;
                }
                let _e420 = phi_710_;
                let _e421 = (_e420 + _e371);
                if (_e325 < 0.0lf) {
                    phi_717_ = -(_e325);
                } else {
                    phi_717_ = _e325;
                }
                let _e425 = phi_717_;
                if (_e328 < 0.0lf) {
                    phi_723_ = -(_e328);
                } else {
                    phi_723_ = _e328;
                }
                let _e429 = phi_723_;
                if (_e425 > _e429) {
                    phi_728_ = _e425;
                } else {
                    phi_728_ = _e429;
                }
                let _e432 = phi_728_;
                if (_e331 < 0.0lf) {
                    phi_734_ = -(_e331);
                } else {
                    phi_734_ = _e331;
                }
                let _e436 = phi_734_;
                if (_e432 > _e436) {
                    phi_739_ = _e432;
                } else {
                    phi_739_ = _e436;
                }
                let _e439 = phi_739_;
                if (_e337 < 0.0lf) {
                    phi_745_ = -(_e337);
                } else {
                    phi_745_ = _e337;
                }
                let _e443 = phi_745_;
                if (_e340 < 0.0lf) {
                    phi_751_ = -(_e340);
                } else {
                    phi_751_ = _e340;
                }
                let _e447 = phi_751_;
                if (_e443 > _e447) {
                    phi_756_ = _e443;
                } else {
                    phi_756_ = _e447;
                }
                let _e450 = phi_756_;
                if (_e343 < 0.0lf) {
                    phi_762_ = -(_e343);
                } else {
                    phi_762_ = _e343;
                }
                let _e454 = phi_762_;
                if (_e450 > _e454) {
                    phi_767_ = _e450;
                } else {
                    phi_767_ = _e454;
                }
                let _e457 = phi_767_;
                if (_e439 > _e457) {
                    phi_772_ = _e439;
                } else {
                    phi_772_ = _e457;
                }
                let _e460 = phi_772_;
                let _e461 = (_e460 + _e371);
                if (_e350 < 0.0lf) {
                    phi_779_ = -(_e350);
                } else {
                    phi_779_ = _e350;
                }
                let _e465 = phi_779_;
                if (_e353 < 0.0lf) {
                    phi_785_ = -(_e353);
                } else {
                    phi_785_ = _e353;
                }
                let _e469 = phi_785_;
                if (_e465 > _e469) {
                    phi_790_ = _e465;
                } else {
                    phi_790_ = _e469;
                }
                let _e472 = phi_790_;
                if (_e356 < 0.0lf) {
                    phi_796_ = -(_e356);
                } else {
                    phi_796_ = _e356;
                }
                let _e476 = phi_796_;
                if (_e472 > _e476) {
                    phi_801_ = _e472;
                } else {
                    phi_801_ = _e476;
                }
                let _e479 = phi_801_;
                if (_e362 < 0.0lf) {
                    phi_807_ = -(_e362);
                } else {
                    phi_807_ = _e362;
                }
                let _e483 = phi_807_;
                if (_e365 < 0.0lf) {
                    phi_813_ = -(_e365);
                } else {
                    phi_813_ = _e365;
                }
                let _e487 = phi_813_;
                if (_e483 > _e487) {
                    phi_818_ = _e483;
                } else {
                    phi_818_ = _e487;
                }
                let _e490 = phi_818_;
                if (_e368 < 0.0lf) {
                    phi_824_ = -(_e368);
                } else {
                    phi_824_ = _e368;
                }
                let _e494 = phi_824_;
                if (_e490 > _e494) {
                    phi_829_ = _e490;
                } else {
                    phi_829_ = _e494;
                }
                let _e497 = phi_829_;
                if (_e479 > _e497) {
                    phi_834_ = _e479;
                } else {
                    phi_834_ = _e497;
                }
                let _e500 = phi_834_;
                let _e501 = (_e500 + _e371);
                if (_e421 > _e461) {
                    phi_840_ = _e421;
                } else {
                    phi_840_ = _e461;
                }
                let _e504 = phi_840_;
                if (_e504 > _e501) {
                    phi_845_ = _e504;
                } else {
                    phi_845_ = _e501;
                }
                let _e507 = phi_845_;
                if (_e507 <= f64(65536f)) {
                    phi_854_ = (_e507 >= f64((1f / 65536f)));
                } else {
                    phi_854_ = false;
                }
                let _e514 = phi_854_;
                if _e514 {
                    phi_926_ = type_43();
                    phi_927_ = true;
                } else {
                    if (_e507 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e507) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e521 = (9214364837600034816lu - (bitcast<u64>(_e507) & 9218868437227405312lu));
                            if (_e521 > 4503599627370496lu) {
                                phi_878_ = _e521;
                            } else {
                                phi_878_ = 4503599627370496lu;
                            }
                            let _e524 = phi_878_;
                            let _e525 = bitcast<f64>(_e524);
                            let _e526 = (_e381 * _e525);
                            if (_e381 > f64(0f)) {
                                if (_e526 > 2.2250738585072014e-308lf) {
                                    phi_890_ = _e526;
                                } else {
                                    phi_890_ = 2.2250738585072014e-308lf;
                                }
                                let _e531 = phi_890_;
                                phi_891_ = _e531;
                            } else {
                                phi_891_ = _e526;
                            }
                            let _e533 = phi_891_;
                            phi_922_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>((_e300 * _e525), (_e303 * _e525), (_e306 * _e525)), array<f64, 3>((_e312 * _e525), (_e315 * _e525), (_e318 * _e525))), array<array<f64, 3>, 2>(array<f64, 3>((_e325 * _e525), (_e328 * _e525), (_e331 * _e525)), array<f64, 3>((_e337 * _e525), (_e340 * _e525), (_e343 * _e525))), array<array<f64, 3>, 2>(array<f64, 3>((_e350 * _e525), (_e353 * _e525), (_e356 * _e525)), array<f64, 3>((_e362 * _e525), (_e365 * _e525), (_e368 * _e525))), (_e371 * _e525)), _e533);
                            phi_923_ = false;
                        } else {
                            phi_922_ = type_43();
                            phi_923_ = true;
                        }
                        let _e565 = phi_922_;
                        let _e567 = phi_923_;
                        phi_924_ = _e565;
                        phi_925_ = _e567;
                    } else {
                        phi_924_ = type_43();
                        phi_925_ = true;
                    }
                    let _e569 = phi_924_;
                    let _e571 = phi_925_;
                    phi_926_ = _e569;
                    phi_927_ = _e571;
                }
                let _e573 = phi_926_;
                let _e575 = phi_927_;
                if _e575 {
                    phi_932_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>(_e300, _e303, _e306), array<f64, 3>(_e312, _e315, _e318)), array<array<f64, 3>, 2>(array<f64, 3>(_e325, _e328, _e331), array<f64, 3>(_e337, _e340, _e343)), array<array<f64, 3>, 2>(array<f64, 3>(_e350, _e353, _e356), array<f64, 3>(_e362, _e365, _e368)), _e371), _e381);
                } else {
                    phi_932_ = _e573;
                }
                let _e578 = phi_932_;
                local_12 = type_40(array<array<f64, 3>, 2>(array<f64, 3>(_e578.member.member[0][0], _e578.member.member[0][1], _e578.member.member[0][2]), array<f64, 3>(_e578.member.member[1][0], _e578.member.member[1][1], _e578.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e578.member.member_1[0][0], _e578.member.member_1[0][1], _e578.member.member_1[0][2]), array<f64, 3>(_e578.member.member_1[1][0], _e578.member.member_1[1][1], _e578.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e578.member.member_2[0][0], _e578.member.member_2[0][1], _e578.member.member_2[0][2]), array<f64, 3>(_e578.member.member_2[1][0], _e578.member.member_2[1][1], _e578.member.member_2[1][2])), _e578.member.member_3);
                let _e621 = local_12.member_1[0u];
                let _e627 = local_12.member_2[0u];
                let _e633 = ((_e621[1] * _e627[2]) - (_e621[2] * _e627[1]));
                let _e636 = ((_e621[2] * _e627[0]) - (_e621[0] * _e627[2]));
                let _e639 = ((_e621[0] * _e627[1]) - (_e621[1] * _e627[0]));
                let _e642 = local_12.member_1[1u];
                let _e648 = local_12.member_2[1u];
                let _e654 = ((_e642[1] * _e648[2]) - (_e642[2] * _e648[1]));
                let _e657 = ((_e642[2] * _e648[0]) - (_e642[0] * _e648[2]));
                let _e660 = ((_e642[0] * _e648[1]) - (_e642[1] * _e648[0]));
                let _e663 = local_12.member_1[0u];
                let _e669 = local_12.member_2[1u];
                let _e684 = local_12.member_1[1u];
                let _e690 = local_12.member_2[0u];
                let _e703 = (((_e663[1] * _e669[2]) - (_e663[2] * _e669[1])) + ((_e684[1] * _e690[2]) - (_e684[2] * _e690[1])));
                let _e704 = (((_e663[2] * _e669[0]) - (_e663[0] * _e669[2])) + ((_e684[2] * _e690[0]) - (_e684[0] * _e690[2])));
                let _e705 = (((_e663[0] * _e669[1]) - (_e663[1] * _e669[0])) + ((_e684[0] * _e690[1]) - (_e684[1] * _e690[0])));
                let _e708 = local_12.member[0u];
                let _e716 = (((_e708[0] * _e633) + (_e708[1] * _e636)) + (_e708[2] * _e639));
                let _e719 = local_12.member[1u];
                let _e730 = local_12.member[0u];
                let _e739 = ((((_e719[0] * _e633) + (_e719[1] * _e636)) + (_e719[2] * _e639)) + (((_e730[0] * _e703) + (_e730[1] * _e704)) + (_e730[2] * _e705)));
                let _e742 = local_12.member[0u];
                let _e753 = local_12.member[1u];
                let _e762 = ((((_e742[0] * _e654) + (_e742[1] * _e657)) + (_e742[2] * _e660)) + (((_e753[0] * _e703) + (_e753[1] * _e704)) + (_e753[2] * _e705)));
                let _e765 = local_12.member[1u];
                let _e773 = (((_e765[0] * _e654) + (_e765[1] * _e657)) + (_e765[2] * _e660));
                let _e776 = local_12.member[0u];
                if (_e776[0] < 0.0lf) {
                    phi_1214_ = -(_e776[0]);
                } else {
                    phi_1214_ = _e776[0];
                }
                let _e783 = phi_1214_;
                if (_e776[1] < 0.0lf) {
                    phi_1221_ = -(_e776[1]);
                } else {
                    phi_1221_ = _e776[1];
                }
                let _e787 = phi_1221_;
                if (_e783 > _e787) {
                    phi_1226_ = _e783;
                } else {
                    phi_1226_ = _e787;
                }
                let _e790 = phi_1226_;
                if (_e776[2] < 0.0lf) {
                    phi_1233_ = -(_e776[2]);
                } else {
                    phi_1233_ = _e776[2];
                }
                let _e794 = phi_1233_;
                if (_e790 > _e794) {
                    phi_1238_ = _e790;
                } else {
                    phi_1238_ = _e794;
                }
                let _e797 = phi_1238_;
                let _e800 = local_12.member[1u];
                if (_e800[0] < 0.0lf) {
                    phi_1251_ = -(_e800[0]);
                } else {
                    phi_1251_ = _e800[0];
                }
                let _e807 = phi_1251_;
                if (_e800[1] < 0.0lf) {
                    phi_1258_ = -(_e800[1]);
                } else {
                    phi_1258_ = _e800[1];
                }
                let _e811 = phi_1258_;
                if (_e807 > _e811) {
                    phi_1263_ = _e807;
                } else {
                    phi_1263_ = _e811;
                }
                let _e814 = phi_1263_;
                if (_e800[2] < 0.0lf) {
                    phi_1270_ = -(_e800[2]);
                } else {
                    phi_1270_ = _e800[2];
                }
                let _e818 = phi_1270_;
                if (_e814 > _e818) {
                    phi_1275_ = _e814;
                } else {
                    phi_1275_ = _e818;
                }
                let _e821 = phi_1275_;
                if (_e797 > _e821) {
                    phi_1280_ = _e797;
                } else {
                    phi_1280_ = _e821;
                }
                let _e824 = phi_1280_;
                let _e826 = local_12.member_3;
                let _e827 = (_e824 + _e826);
                let _e830 = local_12.member_1[0u];
                if (_e830[0] < 0.0lf) {
                    phi_1297_ = -(_e830[0]);
                } else {
                    phi_1297_ = _e830[0];
                }
                let _e837 = phi_1297_;
                if (_e830[1] < 0.0lf) {
                    phi_1304_ = -(_e830[1]);
                } else {
                    phi_1304_ = _e830[1];
                }
                let _e841 = phi_1304_;
                if (_e837 > _e841) {
                    phi_1309_ = _e837;
                } else {
                    phi_1309_ = _e841;
                }
                let _e844 = phi_1309_;
                if (_e830[2] < 0.0lf) {
                    phi_1316_ = -(_e830[2]);
                } else {
                    phi_1316_ = _e830[2];
                }
                let _e848 = phi_1316_;
                if (_e844 > _e848) {
                    phi_1321_ = _e844;
                } else {
                    phi_1321_ = _e848;
                }
                let _e851 = phi_1321_;
                let _e854 = local_12.member_1[1u];
                if (_e854[0] < 0.0lf) {
                    phi_1335_ = -(_e854[0]);
                } else {
                    phi_1335_ = _e854[0];
                }
                let _e861 = phi_1335_;
                if (_e854[1] < 0.0lf) {
                    phi_1342_ = -(_e854[1]);
                } else {
                    phi_1342_ = _e854[1];
                }
                let _e865 = phi_1342_;
                if (_e861 > _e865) {
                    phi_1347_ = _e861;
                } else {
                    phi_1347_ = _e865;
                }
                let _e868 = phi_1347_;
                if (_e854[2] < 0.0lf) {
                    phi_1354_ = -(_e854[2]);
                } else {
                    phi_1354_ = _e854[2];
                }
                let _e872 = phi_1354_;
                if (_e868 > _e872) {
                    phi_1359_ = _e868;
                } else {
                    phi_1359_ = _e872;
                }
                let _e875 = phi_1359_;
                if (_e851 > _e875) {
                    phi_1364_ = _e851;
                } else {
                    phi_1364_ = _e875;
                }
                let _e878 = phi_1364_;
                let _e880 = local_12.member_3;
                let _e881 = (_e878 + _e880);
                let _e884 = local_12.member_2[0u];
                if (_e884[0] < 0.0lf) {
                    phi_1381_ = -(_e884[0]);
                } else {
                    phi_1381_ = _e884[0];
                }
                let _e891 = phi_1381_;
                if (_e884[1] < 0.0lf) {
                    phi_1388_ = -(_e884[1]);
                } else {
                    phi_1388_ = _e884[1];
                }
                let _e895 = phi_1388_;
                if (_e891 > _e895) {
                    phi_1393_ = _e891;
                } else {
                    phi_1393_ = _e895;
                }
                let _e898 = phi_1393_;
                if (_e884[2] < 0.0lf) {
                    phi_1400_ = -(_e884[2]);
                } else {
                    phi_1400_ = _e884[2];
                }
                let _e902 = phi_1400_;
                if (_e898 > _e902) {
                    phi_1405_ = _e898;
                } else {
                    phi_1405_ = _e902;
                }
                let _e905 = phi_1405_;
                let _e908 = local_12.member_2[1u];
                if (_e908[0] < 0.0lf) {
                    phi_1419_ = -(_e908[0]);
                } else {
                    phi_1419_ = _e908[0];
                }
                let _e915 = phi_1419_;
                if (_e908[1] < 0.0lf) {
                    phi_1426_ = -(_e908[1]);
                } else {
                    phi_1426_ = _e908[1];
                }
                let _e919 = phi_1426_;
                if (_e915 > _e919) {
                    phi_1431_ = _e915;
                } else {
                    phi_1431_ = _e919;
                }
                let _e922 = phi_1431_;
                if (_e908[2] < 0.0lf) {
                    phi_1438_ = -(_e908[2]);
                } else {
                    phi_1438_ = _e908[2];
                }
                let _e926 = phi_1438_;
                if (_e922 > _e926) {
                    phi_1443_ = _e922;
                } else {
                    phi_1443_ = _e926;
                }
                let _e929 = phi_1443_;
                if (_e905 > _e929) {
                    phi_1448_ = _e905;
                } else {
                    phi_1448_ = _e929;
                }
                let _e932 = phi_1448_;
                let _e934 = local_12.member_3;
                let _e935 = (_e932 + _e934);
                let _e936 = f64(1f);
                let _e937 = f64(8f);
                let _e939 = ((_e881 * _e937) * _e935);
                let _e947 = local_12.member_3;
                if (_e633 < 0.0lf) {
                    phi_1485_ = -(_e633);
                } else {
                    phi_1485_ = _e633;
                }
                let _e967 = phi_1485_;
                if (_e636 < 0.0lf) {
                    phi_1491_ = -(_e636);
                } else {
                    phi_1491_ = _e636;
                }
                let _e971 = phi_1491_;
                if (_e639 < 0.0lf) {
                    phi_1498_ = -(_e639);
                } else {
                    phi_1498_ = _e639;
                }
                let _e976 = phi_1498_;
                let _e977 = ((_e967 + _e971) + _e976);
                if (_e654 < 0.0lf) {
                    phi_1505_ = -(_e654);
                } else {
                    phi_1505_ = _e654;
                }
                let _e981 = phi_1505_;
                if (_e657 < 0.0lf) {
                    phi_1511_ = -(_e657);
                } else {
                    phi_1511_ = _e657;
                }
                let _e985 = phi_1511_;
                if (_e660 < 0.0lf) {
                    phi_1518_ = -(_e660);
                } else {
                    phi_1518_ = _e660;
                }
                let _e990 = phi_1518_;
                let _e991 = ((_e981 + _e985) + _e990);
                if (_e977 > _e991) {
                    phi_1524_ = _e977;
                } else {
                    phi_1524_ = _e991;
                }
                let _e994 = phi_1524_;
                if (_e703 < 0.0lf) {
                    phi_1530_ = -(_e703);
                } else {
                    phi_1530_ = _e703;
                }
                let _e998 = phi_1530_;
                if (_e704 < 0.0lf) {
                    phi_1536_ = -(_e704);
                } else {
                    phi_1536_ = _e704;
                }
                let _e1002 = phi_1536_;
                if (_e705 < 0.0lf) {
                    phi_1543_ = -(_e705);
                } else {
                    phi_1543_ = _e705;
                }
                let _e1007 = phi_1543_;
                let _e1009 = (((_e998 + _e1002) + _e1007) * f64(0.5f));
                if (_e994 > _e1009) {
                    phi_1550_ = _e994;
                } else {
                    phi_1550_ = _e1009;
                }
                let _e1012 = phi_1550_;
                let _e1018 = local_12.member_3;
                let _e1032 = (((((_e827 * _e937) * _e939) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e947 * f64(19f)) * ((_e827 * (_e881 + _e935)) + (_e881 * _e935)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e936 + _e827) * ((_e936 + _e881) * (_e936 + _e935)))));
                let _e1033 = f64(3f);
                let _e1034 = (_e716 * _e1033);
                let _e1035 = (_e773 * _e1033);
                if (_e1034 < _e1035) {
                    phi_1578_ = _e1034;
                } else {
                    phi_1578_ = _e1035;
                }
                let _e1038 = phi_1578_;
                if (_e739 < _e762) {
                    phi_1583_ = _e739;
                } else {
                    phi_1583_ = _e762;
                }
                let _e1041 = phi_1583_;
                if (_e1038 < _e1041) {
                    phi_1588_ = _e1038;
                } else {
                    phi_1588_ = _e1041;
                }
                let _e1044 = phi_1588_;
                if (_e1034 > _e1035) {
                    phi_1593_ = _e1034;
                } else {
                    phi_1593_ = _e1035;
                }
                let _e1047 = phi_1593_;
                if (_e739 > _e762) {
                    phi_1598_ = _e739;
                } else {
                    phi_1598_ = _e762;
                }
                let _e1050 = phi_1598_;
                if (_e1047 > _e1050) {
                    phi_1603_ = _e1047;
                } else {
                    phi_1603_ = _e1050;
                }
                let _e1053 = phi_1603_;
                let _e1059 = -(_e1053);
                if (_e1044 > _e1059) {
                    phi_1614_ = _e1044;
                } else {
                    phi_1614_ = _e1059;
                }
                let _e1062 = phi_1614_;
                if ((_e1062 - (_e1032 + ((_e578.member_1 * (((_e1012 + (_e939 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1018 * f64(6f)) * (_e881 + _e935))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e936 + _e881) * (_e936 + _e935))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                    phi_8271_ = type_44(0u, type_44().member_1);
                } else {
                    if (_e578.member_1 > f64(0f)) {
                        let _e3722 = f64(1f);
                        let _e3723 = f64(0f);
                        let _e3726 = local_12.member[0u];
                        let _e3732 = local_12.member_1[0u];
                        let _e3738 = local_12.member_2[0u];
                        let _e3742 = (_e3726[0] - _e3732[0]);
                        let _e3743 = (_e3726[1] - _e3732[1]);
                        let _e3744 = (_e3726[2] - _e3732[2]);
                        let _e3753 = local_12.member[1u];
                        let _e3759 = local_12.member_1[1u];
                        let _e3765 = local_12.member_2[1u];
                        let _e3769 = (_e3753[0] - _e3759[0]);
                        let _e3770 = (_e3753[1] - _e3759[1]);
                        let _e3771 = (_e3753[2] - _e3759[2]);
                        let _e3780 = local_12.member[0u];
                        if (_e3780[0] < 0.0lf) {
                            phi_1771_ = -(_e3780[0]);
                        } else {
                            phi_1771_ = _e3780[0];
                        }
                        let _e3787 = phi_1771_;
                        if (_e3780[1] < 0.0lf) {
                            phi_1778_ = -(_e3780[1]);
                        } else {
                            phi_1778_ = _e3780[1];
                        }
                        let _e3791 = phi_1778_;
                        if (_e3787 > _e3791) {
                            phi_1783_ = _e3787;
                        } else {
                            phi_1783_ = _e3791;
                        }
                        let _e3794 = phi_1783_;
                        if (_e3780[2] < 0.0lf) {
                            phi_1790_ = -(_e3780[2]);
                        } else {
                            phi_1790_ = _e3780[2];
                        }
                        let _e3798 = phi_1790_;
                        if (_e3794 > _e3798) {
                            phi_1795_ = _e3794;
                        } else {
                            phi_1795_ = _e3798;
                        }
                        let _e3801 = phi_1795_;
                        let _e3804 = local_12.member[1u];
                        if (_e3804[0] < 0.0lf) {
                            phi_1808_ = -(_e3804[0]);
                        } else {
                            phi_1808_ = _e3804[0];
                        }
                        let _e3811 = phi_1808_;
                        if (_e3804[1] < 0.0lf) {
                            phi_1815_ = -(_e3804[1]);
                        } else {
                            phi_1815_ = _e3804[1];
                        }
                        let _e3815 = phi_1815_;
                        if (_e3811 > _e3815) {
                            phi_1820_ = _e3811;
                        } else {
                            phi_1820_ = _e3815;
                        }
                        let _e3818 = phi_1820_;
                        if (_e3804[2] < 0.0lf) {
                            phi_1827_ = -(_e3804[2]);
                        } else {
                            phi_1827_ = _e3804[2];
                        }
                        let _e3822 = phi_1827_;
                        if (_e3818 > _e3822) {
                            phi_1832_ = _e3818;
                        } else {
                            phi_1832_ = _e3822;
                        }
                        let _e3825 = phi_1832_;
                        if (_e3801 > _e3825) {
                            phi_1837_ = _e3801;
                        } else {
                            phi_1837_ = _e3825;
                        }
                        let _e3828 = phi_1837_;
                        let _e3830 = local_12.member_3;
                        let _e3834 = local_12.member_1[0u];
                        if (_e3834[0] < 0.0lf) {
                            phi_1854_ = -(_e3834[0]);
                        } else {
                            phi_1854_ = _e3834[0];
                        }
                        let _e3841 = phi_1854_;
                        if (_e3834[1] < 0.0lf) {
                            phi_1861_ = -(_e3834[1]);
                        } else {
                            phi_1861_ = _e3834[1];
                        }
                        let _e3845 = phi_1861_;
                        if (_e3841 > _e3845) {
                            phi_1866_ = _e3841;
                        } else {
                            phi_1866_ = _e3845;
                        }
                        let _e3848 = phi_1866_;
                        if (_e3834[2] < 0.0lf) {
                            phi_1873_ = -(_e3834[2]);
                        } else {
                            phi_1873_ = _e3834[2];
                        }
                        let _e3852 = phi_1873_;
                        if (_e3848 > _e3852) {
                            phi_1878_ = _e3848;
                        } else {
                            phi_1878_ = _e3852;
                        }
                        let _e3855 = phi_1878_;
                        let _e3858 = local_12.member_1[1u];
                        if (_e3858[0] < 0.0lf) {
                            phi_1892_ = -(_e3858[0]);
                        } else {
                            phi_1892_ = _e3858[0];
                        }
                        let _e3865 = phi_1892_;
                        if (_e3858[1] < 0.0lf) {
                            phi_1899_ = -(_e3858[1]);
                        } else {
                            phi_1899_ = _e3858[1];
                        }
                        let _e3869 = phi_1899_;
                        if (_e3865 > _e3869) {
                            phi_1904_ = _e3865;
                        } else {
                            phi_1904_ = _e3869;
                        }
                        let _e3872 = phi_1904_;
                        if (_e3858[2] < 0.0lf) {
                            phi_1911_ = -(_e3858[2]);
                        } else {
                            phi_1911_ = _e3858[2];
                        }
                        let _e3876 = phi_1911_;
                        if (_e3872 > _e3876) {
                            phi_1916_ = _e3872;
                        } else {
                            phi_1916_ = _e3876;
                        }
                        let _e3879 = phi_1916_;
                        if (_e3855 > _e3879) {
                            phi_1921_ = _e3855;
                        } else {
                            phi_1921_ = _e3879;
                        }
                        let _e3882 = phi_1921_;
                        let _e3884 = local_12.member_3;
                        let _e3888 = local_12.member_2[0u];
                        if (_e3888[0] < 0.0lf) {
                            phi_1938_ = -(_e3888[0]);
                        } else {
                            phi_1938_ = _e3888[0];
                        }
                        let _e3895 = phi_1938_;
                        if (_e3888[1] < 0.0lf) {
                            phi_1945_ = -(_e3888[1]);
                        } else {
                            phi_1945_ = _e3888[1];
                        }
                        let _e3899 = phi_1945_;
                        if (_e3895 > _e3899) {
                            phi_1950_ = _e3895;
                        } else {
                            phi_1950_ = _e3899;
                        }
                        let _e3902 = phi_1950_;
                        if (_e3888[2] < 0.0lf) {
                            phi_1957_ = -(_e3888[2]);
                        } else {
                            phi_1957_ = _e3888[2];
                        }
                        let _e3906 = phi_1957_;
                        if (_e3902 > _e3906) {
                            phi_1962_ = _e3902;
                        } else {
                            phi_1962_ = _e3906;
                        }
                        let _e3909 = phi_1962_;
                        let _e3912 = local_12.member_2[1u];
                        if (_e3912[0] < 0.0lf) {
                            phi_1976_ = -(_e3912[0]);
                        } else {
                            phi_1976_ = _e3912[0];
                        }
                        let _e3919 = phi_1976_;
                        if (_e3912[1] < 0.0lf) {
                            phi_1983_ = -(_e3912[1]);
                        } else {
                            phi_1983_ = _e3912[1];
                        }
                        let _e3923 = phi_1983_;
                        if (_e3919 > _e3923) {
                            phi_1988_ = _e3919;
                        } else {
                            phi_1988_ = _e3923;
                        }
                        let _e3926 = phi_1988_;
                        if (_e3912[2] < 0.0lf) {
                            phi_1995_ = -(_e3912[2]);
                        } else {
                            phi_1995_ = _e3912[2];
                        }
                        let _e3930 = phi_1995_;
                        if (_e3926 > _e3930) {
                            phi_2000_ = _e3926;
                        } else {
                            phi_2000_ = _e3930;
                        }
                        let _e3933 = phi_2000_;
                        if (_e3909 > _e3933) {
                            phi_2005_ = _e3909;
                        } else {
                            phi_2005_ = _e3933;
                        }
                        let _e3936 = phi_2005_;
                        let _e3938 = local_12.member_3;
                        let _e3946 = local_12.member_3;
                        let _e3953 = f64(0f);
                        let _e3954 = f64(1f);
                        local_9 = type_34(array<f64, 4>(_e3953, _e3953, _e3953, _e3953), array<f64, 4>(_e3953, _e3953, _e3953, _e3953), array<f64, 4>(_e3954, _e3954, _e3954, _e3954));
                        phi_2049_ = type_9(0u, 96u);
                        phi_2052_ = _e3723;
                        phi_2054_ = _e3723;
                        phi_2056_ = _e3723;
                        loop {
                            let _e3960 = phi_2049_;
                            let _e3962 = phi_2052_;
                            let _e3964 = phi_2054_;
                            let _e3966 = phi_2056_;
                            local_44 = _e3964;
                            local_26 = _e3962;
                            if (_e3960.member < _e3960.member_1) {
                                phi_2050_ = type_9((_e3960.member + 1u), _e3960.member_1);
                                phi_2079_ = type_9(1u, _e3960.member);
                            } else {
                                phi_2050_ = _e3960;
                                phi_2079_ = type_9(0u, type_9().member_1);
                            }
                            let _e3978 = phi_2050_;
                            let _e3980 = phi_2079_;
                            if (bitcast<i32>(_e3980.member) != 0i) {
                                let _e3987 = local_12.member[0u];
                                let _e3993 = local_12.member[1u];
                                let _e4009 = local_12.member_1[0u];
                                let _e4015 = local_12.member_1[1u];
                                let _e4031 = local_12.member_2[0u];
                                let _e4037 = local_12.member_2[1u];
                                let _e4051 = function_2(array<f64, 3>((_e3987[0] + ((_e3993[0] - _e3987[0]) * _e3962)), (_e3987[1] + ((_e3993[1] - _e3987[1]) * _e3962)), (_e3987[2] + ((_e3993[2] - _e3987[2]) * _e3962))), array<f64, 3>((_e4009[0] + ((_e4015[0] - _e4009[0]) * _e3962)), (_e4009[1] + ((_e4015[1] - _e4009[1]) * _e3962)), (_e4009[2] + ((_e4015[2] - _e4009[2]) * _e3962))), array<f64, 3>((_e4031[0] + ((_e4037[0] - _e4031[0]) * _e3962)), (_e4031[1] + ((_e4037[1] - _e4031[1]) * _e3962)), (_e4031[2] + ((_e4037[2] - _e4031[2]) * _e3962))), 1u);
                                if (_e4051[0] < 0.0lf) {
                                    phi_2191_ = -(_e4051[0]);
                                } else {
                                    phi_2191_ = _e4051[0];
                                }
                                let _e4056 = phi_2191_;
                                if (_e4051[1] < 0.0lf) {
                                    phi_2198_ = -(_e4051[1]);
                                } else {
                                    phi_2198_ = _e4051[1];
                                }
                                let _e4061 = phi_2198_;
                                if (_e4051[2] < 0.0lf) {
                                    phi_2206_ = -(_e4051[2]);
                                } else {
                                    phi_2206_ = _e4051[2];
                                }
                                let _e4067 = phi_2206_;
                                let _e4068 = ((_e4056 + _e4061) + _e4067);
                                if (_e4068 > f64(0f)) {
                                    if ((bitcast<u64>(_e4068) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4075 = (f64(1f) / _e4068);
                                        let _e4077 = (_e4051[0] * _e4075);
                                        let _e4079 = (_e4051[1] * _e4075);
                                        let _e4081 = (_e4051[2] * _e4075);
                                        let _e4086 = (((_e4077 * _e4077) + (_e4079 * _e4079)) + (_e4081 * _e4081));
                                        if (_e4086 <= 2.2250738585072014e-308lf) {
                                            if (_e4086 > 0.0lf) {
                                                phi_2245_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2245_ = 0.0lf;
                                            }
                                            let _e4138 = phi_2245_;
                                            phi_2309_ = _e4138;
                                        } else {
                                            phi_2252_ = type_16(0i, 5i);
                                            phi_2255_ = bitcast<f64>(((bitcast<u64>(_e4086) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4093 = phi_2252_;
                                                let _e4095 = phi_2255_;
                                                local_24 = _e4095;
                                                if (_e4093.member < _e4093.member_1) {
                                                    let _e4102 = (_e4093.member + 1i);
                                                    if ((false == (_e4102 > _e4093.member)) != false) {
                                                        phi_2276_ = true;
                                                    } else {
                                                        phi_2276_ = false;
                                                    }
                                                    let _e4107 = phi_2276_;
                                                    if _e4107 {
                                                        phi_2282_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2282_ = type_17(1u, _e4102);
                                                    }
                                                    let _e4112 = phi_2282_;
                                                    phi_2253_ = type_16(_e4112.member_1, _e4093.member_1);
                                                    phi_2296_ = type_17(1u, _e4093.member);
                                                } else {
                                                    phi_2253_ = _e4093;
                                                    phi_2296_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e4118 = phi_2253_;
                                                let _e4120 = phi_2296_;
                                                let _e4123 = (bitcast<i32>(_e4120.member) != 0i);
                                                if _e4123 {
                                                    phi_2256_ = (0.5lf * (_e4095 + (_e4086 / _e4095)));
                                                } else {
                                                    phi_2256_ = f64();
                                                }
                                                let _e4128 = phi_2256_;
                                                continue;
                                                continuing {
                                                    phi_2252_ = _e4118;
                                                    phi_2255_ = _e4128;
                                                    break if !(_e4123);
                                                }
                                            }
                                            let _e4133 = local_24;
                                            phi_2309_ = (_e4133 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4140 = phi_2309_;
                                        let _e4142 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4149 = ((((((((_e3828 + _e3830) + (_e3882 + _e3884)) + (_e3936 + _e3938)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3946 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e578.member_1 * _e4140) * (f64(1f) + _e4142)));
                                        let _e4154 = (((_e4077 * _e3726[0]) + (_e4079 * _e3726[1])) + (_e4081 * _e3726[2]));
                                        let _e4159 = (((_e4077 * _e3742) + (_e4079 * _e3743)) + (_e4081 * _e3744));
                                        let _e4164 = (((_e4077 * (_e3726[0] - _e3738[0])) + (_e4079 * (_e3726[1] - _e3738[1]))) + (_e4081 * (_e3726[2] - _e3738[2])));
                                        let _e4169 = (((_e4077 * (_e3742 - _e3738[0])) + (_e4079 * (_e3743 - _e3738[1]))) + (_e4081 * (_e3744 - _e3738[2])));
                                        let _e4175 = (((_e4077 * _e3753[0]) + (_e4079 * _e3753[1])) + (_e4081 * _e3753[2]));
                                        let _e4180 = (((_e4077 * _e3769) + (_e4079 * _e3770)) + (_e4081 * _e3771));
                                        let _e4185 = (((_e4077 * (_e3753[0] - _e3765[0])) + (_e4079 * (_e3753[1] - _e3765[1]))) + (_e4081 * (_e3753[2] - _e3765[2])));
                                        let _e4190 = (((_e4077 * (_e3769 - _e3765[0])) + (_e4079 * (_e3770 - _e3765[1]))) + (_e4081 * (_e3771 - _e3765[2])));
                                        if (_e4154 < 0.0lf) {
                                            phi_2378_ = -(_e4154);
                                        } else {
                                            phi_2378_ = _e4154;
                                        }
                                        let _e4195 = phi_2378_;
                                        if (_e4175 < 0.0lf) {
                                            phi_2384_ = -(_e4175);
                                        } else {
                                            phi_2384_ = _e4175;
                                        }
                                        let _e4199 = phi_2384_;
                                        if (_e4159 < 0.0lf) {
                                            phi_2393_ = -(_e4159);
                                        } else {
                                            phi_2393_ = _e4159;
                                        }
                                        let _e4206 = phi_2393_;
                                        if (_e4180 < 0.0lf) {
                                            phi_2399_ = -(_e4180);
                                        } else {
                                            phi_2399_ = _e4180;
                                        }
                                        let _e4210 = phi_2399_;
                                        if (_e4164 < 0.0lf) {
                                            phi_2408_ = -(_e4164);
                                        } else {
                                            phi_2408_ = _e4164;
                                        }
                                        let _e4217 = phi_2408_;
                                        if (_e4185 < 0.0lf) {
                                            phi_2414_ = -(_e4185);
                                        } else {
                                            phi_2414_ = _e4185;
                                        }
                                        let _e4221 = phi_2414_;
                                        if (_e4169 < 0.0lf) {
                                            phi_2423_ = -(_e4169);
                                        } else {
                                            phi_2423_ = _e4169;
                                        }
                                        let _e4228 = phi_2423_;
                                        if (_e4190 < 0.0lf) {
                                            phi_2429_ = -(_e4190);
                                        } else {
                                            phi_2429_ = _e4190;
                                        }
                                        let _e4232 = phi_2429_;
                                        phi_2435_ = type_34(array<f64, 4>(_e4154, _e4159, _e4164, _e4169), array<f64, 4>(_e4175, _e4180, _e4185, _e4190), array<f64, 4>((_e4149 + ((_e4195 + _e4199) * _e4142)), (_e4149 + ((_e4206 + _e4210) * _e4142)), (_e4149 + ((_e4217 + _e4221) * _e4142)), (_e4149 + ((_e4228 + _e4232) * _e4142))));
                                        phi_2436_ = false;
                                    } else {
                                        phi_2435_ = type_34();
                                        phi_2436_ = true;
                                    }
                                    let _e4239 = phi_2435_;
                                    let _e4241 = phi_2436_;
                                    phi_2437_ = _e4239;
                                    phi_2438_ = _e4241;
                                } else {
                                    phi_2437_ = type_34();
                                    phi_2438_ = true;
                                }
                                let _e4243 = phi_2437_;
                                let _e4245 = phi_2438_;
                                if _e4245 {
                                    let _e4246 = f64(0f);
                                    let _e4247 = f64(1f);
                                    phi_2448_ = type_34(array<f64, 4>(_e4246, _e4246, _e4246, _e4246), array<f64, 4>(_e4246, _e4246, _e4246, _e4246), array<f64, 4>(_e4247, _e4247, _e4247, _e4247));
                                } else {
                                    phi_2448_ = _e4243;
                                }
                                let _e4253 = phi_2448_;
                                local_10 = type_34(array<f64, 4>(_e4253.member[0], _e4253.member[1], _e4253.member[2], _e4253.member[3]), array<f64, 4>(_e4253.member_1[0], _e4253.member_1[1], _e4253.member_1[2], _e4253.member_1[3]), array<f64, 4>(_e4253.member_2[0], _e4253.member_2[1], _e4253.member_2[2], _e4253.member_2[3]));
                                let _e4273 = (_e3962 - _e3966);
                                let _e4274 = f64(0f);
                                let _e4277 = local_10.member[0u];
                                let _e4280 = local_10.member_1[0u];
                                let _e4283 = local_10.member[0u];
                                let _e4289 = local_10.member_2[0u];
                                if (((_e4277 + ((_e4280 - _e4283) * _e3962)) - _e4289) > _e4274) {
                                    let _e4294 = local_10.member[1u];
                                    let _e4297 = local_10.member_1[1u];
                                    let _e4300 = local_10.member[1u];
                                    let _e4306 = local_10.member_2[1u];
                                    if (((_e4294 + ((_e4297 - _e4300) * _e3962)) - _e4306) > _e4274) {
                                        let _e4311 = local_10.member[2u];
                                        let _e4314 = local_10.member_1[2u];
                                        let _e4317 = local_10.member[2u];
                                        let _e4323 = local_10.member_2[2u];
                                        if (((_e4311 + ((_e4314 - _e4317) * _e3962)) - _e4323) > _e4274) {
                                            let _e4328 = local_10.member[3u];
                                            let _e4331 = local_10.member_1[3u];
                                            let _e4334 = local_10.member[3u];
                                            let _e4340 = local_10.member_2[3u];
                                            phi_2619_ = (((_e4328 + ((_e4331 - _e4334) * _e3962)) - _e4340) > _e4274);
                                            phi_2620_ = false;
                                        } else {
                                            phi_2619_ = bool();
                                            phi_2620_ = true;
                                        }
                                        let _e4344 = phi_2619_;
                                        let _e4346 = phi_2620_;
                                        phi_2621_ = _e4344;
                                        phi_2622_ = _e4346;
                                    } else {
                                        phi_2621_ = bool();
                                        phi_2622_ = true;
                                    }
                                    let _e4348 = phi_2621_;
                                    let _e4350 = phi_2622_;
                                    phi_2623_ = _e4348;
                                    phi_2624_ = _e4350;
                                } else {
                                    phi_2623_ = bool();
                                    phi_2624_ = true;
                                }
                                let _e4352 = phi_2623_;
                                let _e4354 = phi_2624_;
                                if _e4354 {
                                    phi_2628_ = false;
                                } else {
                                    phi_2628_ = _e4352;
                                }
                                let _e4356 = phi_2628_;
                                if _e4356 {
                                    if (_e3962 <= _e3964) {
                                        phi_2939_ = true;
                                    } else {
                                        let _e4358 = f64(0f);
                                        let _e4361 = local_9.member[0u];
                                        let _e4364 = local_9.member_1[0u];
                                        let _e4367 = local_9.member[0u];
                                        let _e4373 = local_9.member_2[0u];
                                        let _e4377 = local_10.member[0u];
                                        let _e4380 = local_10.member_1[0u];
                                        let _e4383 = local_10.member[0u];
                                        let _e4389 = local_10.member_2[0u];
                                        if ((((_e4361 + ((_e4364 - _e4367) * _e3962)) - _e4373) + ((_e4377 + ((_e4380 - _e4383) * _e3966)) - _e4389)) > _e4358) {
                                            let _e4395 = local_9.member[1u];
                                            let _e4398 = local_9.member_1[1u];
                                            let _e4401 = local_9.member[1u];
                                            let _e4407 = local_9.member_2[1u];
                                            let _e4411 = local_10.member[1u];
                                            let _e4414 = local_10.member_1[1u];
                                            let _e4417 = local_10.member[1u];
                                            let _e4423 = local_10.member_2[1u];
                                            if ((((_e4395 + ((_e4398 - _e4401) * _e3962)) - _e4407) + ((_e4411 + ((_e4414 - _e4417) * _e3966)) - _e4423)) > _e4358) {
                                                let _e4429 = local_9.member[2u];
                                                let _e4432 = local_9.member_1[2u];
                                                let _e4435 = local_9.member[2u];
                                                let _e4441 = local_9.member_2[2u];
                                                let _e4445 = local_10.member[2u];
                                                let _e4448 = local_10.member_1[2u];
                                                let _e4451 = local_10.member[2u];
                                                let _e4457 = local_10.member_2[2u];
                                                if ((((_e4429 + ((_e4432 - _e4435) * _e3962)) - _e4441) + ((_e4445 + ((_e4448 - _e4451) * _e3966)) - _e4457)) > _e4358) {
                                                    let _e4463 = local_9.member[3u];
                                                    let _e4466 = local_9.member_1[3u];
                                                    let _e4469 = local_9.member[3u];
                                                    let _e4475 = local_9.member_2[3u];
                                                    let _e4479 = local_10.member[3u];
                                                    let _e4482 = local_10.member_1[3u];
                                                    let _e4485 = local_10.member[3u];
                                                    let _e4491 = local_10.member_2[3u];
                                                    phi_2926_ = ((((_e4463 + ((_e4466 - _e4469) * _e3962)) - _e4475) + ((_e4479 + ((_e4482 - _e4485) * _e3966)) - _e4491)) > _e4358);
                                                    phi_2927_ = false;
                                                } else {
                                                    phi_2926_ = bool();
                                                    phi_2927_ = true;
                                                }
                                                let _e4496 = phi_2926_;
                                                let _e4498 = phi_2927_;
                                                phi_2928_ = _e4496;
                                                phi_2929_ = _e4498;
                                            } else {
                                                phi_2928_ = bool();
                                                phi_2929_ = true;
                                            }
                                            let _e4500 = phi_2928_;
                                            let _e4502 = phi_2929_;
                                            phi_2930_ = _e4500;
                                            phi_2931_ = _e4502;
                                        } else {
                                            phi_2930_ = bool();
                                            phi_2931_ = true;
                                        }
                                        let _e4504 = phi_2930_;
                                        let _e4506 = phi_2931_;
                                        if _e4506 {
                                            phi_2935_ = false;
                                        } else {
                                            phi_2935_ = _e4504;
                                        }
                                        let _e4508 = phi_2935_;
                                        phi_2939_ = _e4508;
                                    }
                                    let _e4510 = phi_2939_;
                                    if _e4510 {
                                        if (_e3980.member_1 > 0u) {
                                            if (_e3962 >= _e3722) {
                                                phi_2951_ = false;
                                            } else {
                                                phi_2951_ = true;
                                            }
                                            let _e4514 = phi_2951_;
                                            phi_2952_ = _e4514;
                                        } else {
                                            phi_2952_ = true;
                                        }
                                        let _e4516 = phi_2952_;
                                        if _e4516 {
                                            local_9 = type_34(array<f64, 4>(_e4253.member[0], _e4253.member[1], _e4253.member[2], _e4253.member[3]), array<f64, 4>(_e4253.member_1[0], _e4253.member_1[1], _e4253.member_1[2], _e4253.member_1[3]), array<f64, 4>(_e4253.member_2[0], _e4253.member_2[1], _e4253.member_2[2], _e4253.member_2[3]));
                                            let _e4538 = local_9.member[0u];
                                            let _e4541 = local_9.member_1[0u];
                                            let _e4544 = local_9.member_2[0u];
                                            if (_e4538 > _e4544) {
                                                if (_e4541 > _e4544) {
                                                    phi_3026_ = false;
                                                } else {
                                                    phi_3026_ = true;
                                                }
                                                let _e4548 = phi_3026_;
                                                phi_3027_ = _e4548;
                                            } else {
                                                phi_3027_ = true;
                                            }
                                            let _e4550 = phi_3027_;
                                            if _e4550 {
                                                let _e4551 = (_e4541 >= _e4538);
                                                if _e4551 {
                                                    phi_3052_ = f64();
                                                    phi_3053_ = false;
                                                } else {
                                                    if ((_e4538 - _e4541) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3050_ = (((_e4538 - _e4544) / (_e4538 - _e4541)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3051_ = false;
                                                    } else {
                                                        phi_3050_ = f64();
                                                        phi_3051_ = true;
                                                    }
                                                    let _e4565 = phi_3050_;
                                                    let _e4567 = phi_3051_;
                                                    phi_3052_ = _e4565;
                                                    phi_3053_ = _e4567;
                                                }
                                                let _e4569 = phi_3052_;
                                                let _e4571 = phi_3053_;
                                                phi_3054_ = _e4569;
                                                phi_3055_ = _e4551;
                                                phi_3056_ = _e4571;
                                            } else {
                                                phi_3054_ = f64();
                                                phi_3055_ = true;
                                                phi_3056_ = false;
                                            }
                                            let _e4573 = phi_3054_;
                                            let _e4575 = phi_3055_;
                                            let _e4577 = phi_3056_;
                                            if _e4575 {
                                                phi_3061_ = f64(2f);
                                                phi_3062_ = true;
                                            } else {
                                                phi_3061_ = _e3962;
                                                phi_3062_ = _e4577;
                                            }
                                            let _e4580 = phi_3061_;
                                            let _e4582 = phi_3062_;
                                            if _e4582 {
                                                phi_3066_ = _e4580;
                                            } else {
                                                phi_3066_ = _e4573;
                                            }
                                            let _e4584 = phi_3066_;
                                            let _e4587 = local_9.member[1u];
                                            let _e4590 = local_9.member_1[1u];
                                            let _e4593 = local_9.member_2[1u];
                                            if (_e4587 > _e4593) {
                                                if (_e4590 > _e4593) {
                                                    phi_3098_ = false;
                                                } else {
                                                    phi_3098_ = true;
                                                }
                                                let _e4597 = phi_3098_;
                                                phi_3099_ = _e4597;
                                            } else {
                                                phi_3099_ = true;
                                            }
                                            let _e4599 = phi_3099_;
                                            if _e4599 {
                                                let _e4600 = (_e4590 >= _e4587);
                                                if _e4600 {
                                                    phi_3124_ = f64();
                                                    phi_3125_ = false;
                                                } else {
                                                    if ((_e4587 - _e4590) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3122_ = (((_e4587 - _e4593) / (_e4587 - _e4590)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3123_ = false;
                                                    } else {
                                                        phi_3122_ = f64();
                                                        phi_3123_ = true;
                                                    }
                                                    let _e4614 = phi_3122_;
                                                    let _e4616 = phi_3123_;
                                                    phi_3124_ = _e4614;
                                                    phi_3125_ = _e4616;
                                                }
                                                let _e4618 = phi_3124_;
                                                let _e4620 = phi_3125_;
                                                phi_3126_ = _e4618;
                                                phi_3127_ = _e4600;
                                                phi_3128_ = _e4620;
                                            } else {
                                                phi_3126_ = f64();
                                                phi_3127_ = true;
                                                phi_3128_ = false;
                                            }
                                            let _e4622 = phi_3126_;
                                            let _e4624 = phi_3127_;
                                            let _e4626 = phi_3128_;
                                            if _e4624 {
                                                phi_3133_ = f64(2f);
                                                phi_3134_ = true;
                                            } else {
                                                phi_3133_ = _e3962;
                                                phi_3134_ = _e4626;
                                            }
                                            let _e4629 = phi_3133_;
                                            let _e4631 = phi_3134_;
                                            if _e4631 {
                                                phi_3138_ = _e4629;
                                            } else {
                                                phi_3138_ = _e4622;
                                            }
                                            let _e4633 = phi_3138_;
                                            if (_e4584 < _e4633) {
                                                phi_3143_ = _e4584;
                                            } else {
                                                phi_3143_ = _e4633;
                                            }
                                            let _e4636 = phi_3143_;
                                            let _e4639 = local_9.member[2u];
                                            let _e4642 = local_9.member_1[2u];
                                            let _e4645 = local_9.member_2[2u];
                                            if (_e4639 > _e4645) {
                                                if (_e4642 > _e4645) {
                                                    phi_3175_ = false;
                                                } else {
                                                    phi_3175_ = true;
                                                }
                                                let _e4649 = phi_3175_;
                                                phi_3176_ = _e4649;
                                            } else {
                                                phi_3176_ = true;
                                            }
                                            let _e4651 = phi_3176_;
                                            if _e4651 {
                                                let _e4652 = (_e4642 >= _e4639);
                                                if _e4652 {
                                                    phi_3201_ = f64();
                                                    phi_3202_ = false;
                                                } else {
                                                    if ((_e4639 - _e4642) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3199_ = (((_e4639 - _e4645) / (_e4639 - _e4642)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3200_ = false;
                                                    } else {
                                                        phi_3199_ = f64();
                                                        phi_3200_ = true;
                                                    }
                                                    let _e4666 = phi_3199_;
                                                    let _e4668 = phi_3200_;
                                                    phi_3201_ = _e4666;
                                                    phi_3202_ = _e4668;
                                                }
                                                let _e4670 = phi_3201_;
                                                let _e4672 = phi_3202_;
                                                phi_3203_ = _e4670;
                                                phi_3204_ = _e4652;
                                                phi_3205_ = _e4672;
                                            } else {
                                                phi_3203_ = f64();
                                                phi_3204_ = true;
                                                phi_3205_ = false;
                                            }
                                            let _e4674 = phi_3203_;
                                            let _e4676 = phi_3204_;
                                            let _e4678 = phi_3205_;
                                            if _e4676 {
                                                phi_3210_ = f64(2f);
                                                phi_3211_ = true;
                                            } else {
                                                phi_3210_ = _e3962;
                                                phi_3211_ = _e4678;
                                            }
                                            let _e4681 = phi_3210_;
                                            let _e4683 = phi_3211_;
                                            if _e4683 {
                                                phi_3215_ = _e4681;
                                            } else {
                                                phi_3215_ = _e4674;
                                            }
                                            let _e4685 = phi_3215_;
                                            let _e4688 = local_9.member[3u];
                                            let _e4691 = local_9.member_1[3u];
                                            let _e4694 = local_9.member_2[3u];
                                            if (_e4688 > _e4694) {
                                                if (_e4691 > _e4694) {
                                                    phi_3247_ = false;
                                                } else {
                                                    phi_3247_ = true;
                                                }
                                                let _e4698 = phi_3247_;
                                                phi_3248_ = _e4698;
                                            } else {
                                                phi_3248_ = true;
                                            }
                                            let _e4700 = phi_3248_;
                                            if _e4700 {
                                                let _e4701 = (_e4691 >= _e4688);
                                                if _e4701 {
                                                    phi_3273_ = f64();
                                                    phi_3274_ = false;
                                                } else {
                                                    if ((_e4688 - _e4691) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3271_ = (((_e4688 - _e4694) / (_e4688 - _e4691)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3272_ = false;
                                                    } else {
                                                        phi_3271_ = f64();
                                                        phi_3272_ = true;
                                                    }
                                                    let _e4715 = phi_3271_;
                                                    let _e4717 = phi_3272_;
                                                    phi_3273_ = _e4715;
                                                    phi_3274_ = _e4717;
                                                }
                                                let _e4719 = phi_3273_;
                                                let _e4721 = phi_3274_;
                                                phi_3275_ = _e4719;
                                                phi_3276_ = _e4701;
                                                phi_3277_ = _e4721;
                                            } else {
                                                phi_3275_ = f64();
                                                phi_3276_ = true;
                                                phi_3277_ = false;
                                            }
                                            let _e4723 = phi_3275_;
                                            let _e4725 = phi_3276_;
                                            let _e4727 = phi_3277_;
                                            if _e4725 {
                                                phi_3282_ = f64(2f);
                                                phi_3283_ = true;
                                            } else {
                                                phi_3282_ = _e3962;
                                                phi_3283_ = _e4727;
                                            }
                                            let _e4730 = phi_3282_;
                                            let _e4732 = phi_3283_;
                                            if _e4732 {
                                                phi_3287_ = _e4730;
                                            } else {
                                                phi_3287_ = _e4723;
                                            }
                                            let _e4734 = phi_3287_;
                                            if (_e4685 < _e4734) {
                                                phi_3292_ = _e4685;
                                            } else {
                                                phi_3292_ = _e4734;
                                            }
                                            let _e4737 = phi_3292_;
                                            if (_e4636 < _e4737) {
                                                phi_3297_ = _e4636;
                                            } else {
                                                phi_3297_ = _e4737;
                                            }
                                            let _e4740 = phi_3297_;
                                            if (_e4740 > _e3962) {
                                                phi_3302_ = _e4740;
                                            } else {
                                                phi_3302_ = _e3962;
                                            }
                                            let _e4743 = phi_3302_;
                                            let _e4744 = (_e4743 > _e3722);
                                            if _e4744 {
                                                phi_3314_ = f64();
                                                phi_3315_ = false;
                                            } else {
                                                if (_e3980.member_1 == 0u) {
                                                    phi_3313_ = (_e3722 - _e3962);
                                                } else {
                                                    phi_3313_ = (_e4273 + _e4273);
                                                }
                                                let _e4749 = phi_3313_;
                                                phi_3314_ = _e4749;
                                                phi_3315_ = true;
                                            }
                                            let _e4751 = phi_3314_;
                                            let _e4753 = phi_3315_;
                                            phi_3316_ = _e4743;
                                            phi_3317_ = _e4751;
                                            phi_3318_ = _e4753;
                                            phi_3319_ = _e4744;
                                            phi_3320_ = false;
                                        } else {
                                            phi_3316_ = f64();
                                            phi_3317_ = f64();
                                            phi_3318_ = false;
                                            phi_3319_ = false;
                                            phi_3320_ = true;
                                        }
                                        let _e4755 = phi_3316_;
                                        let _e4757 = phi_3317_;
                                        let _e4759 = phi_3318_;
                                        let _e4761 = phi_3319_;
                                        let _e4763 = phi_3320_;
                                        phi_3321_ = _e4755;
                                        phi_3322_ = _e4757;
                                        phi_3323_ = false;
                                        phi_3324_ = _e4759;
                                        phi_3325_ = _e4761;
                                        phi_3326_ = _e4763;
                                    } else {
                                        phi_3321_ = f64();
                                        phi_3322_ = f64();
                                        phi_3323_ = true;
                                        phi_3324_ = false;
                                        phi_3325_ = false;
                                        phi_3326_ = false;
                                    }
                                    let _e4765 = phi_3321_;
                                    let _e4767 = phi_3322_;
                                    let _e4769 = phi_3323_;
                                    let _e4771 = phi_3324_;
                                    let _e4773 = phi_3325_;
                                    let _e4775 = phi_3326_;
                                    phi_3327_ = _e4765;
                                    phi_3328_ = _e4767;
                                    phi_3329_ = _e4769;
                                    phi_3330_ = _e4771;
                                    phi_3331_ = _e4773;
                                    phi_3332_ = _e4775;
                                } else {
                                    phi_3327_ = f64();
                                    phi_3328_ = f64();
                                    phi_3329_ = true;
                                    phi_3330_ = false;
                                    phi_3331_ = false;
                                    phi_3332_ = false;
                                }
                                let _e4777 = phi_3327_;
                                let _e4779 = phi_3328_;
                                let _e4781 = phi_3329_;
                                let _e4783 = phi_3330_;
                                let _e4785 = phi_3331_;
                                let _e4787 = phi_3332_;
                                if _e4781 {
                                    let _e4788 = (_e3962 <= _e3964);
                                    if _e4788 {
                                        phi_3666_ = f64();
                                        phi_3667_ = false;
                                    } else {
                                        let _e4791 = local_9.member[0u];
                                        let _e4794 = local_9.member_1[0u];
                                        let _e4797 = local_9.member[0u];
                                        let _e4803 = local_9.member_2[0u];
                                        let _e4804 = ((_e4791 + ((_e4794 - _e4797) * _e3966)) - _e4803);
                                        let _e4807 = local_9.member[1u];
                                        let _e4810 = local_9.member_1[1u];
                                        let _e4813 = local_9.member[1u];
                                        let _e4819 = local_9.member_2[1u];
                                        let _e4820 = ((_e4807 + ((_e4810 - _e4813) * _e3966)) - _e4819);
                                        if (_e4804 < _e4820) {
                                            phi_3412_ = _e4804;
                                        } else {
                                            phi_3412_ = _e4820;
                                        }
                                        let _e4823 = phi_3412_;
                                        let _e4826 = local_9.member[2u];
                                        let _e4829 = local_9.member_1[2u];
                                        let _e4832 = local_9.member[2u];
                                        let _e4838 = local_9.member_2[2u];
                                        let _e4839 = ((_e4826 + ((_e4829 - _e4832) * _e3966)) - _e4838);
                                        let _e4842 = local_9.member[3u];
                                        let _e4845 = local_9.member_1[3u];
                                        let _e4848 = local_9.member[3u];
                                        let _e4854 = local_9.member_2[3u];
                                        let _e4855 = ((_e4842 + ((_e4845 - _e4848) * _e3966)) - _e4854);
                                        if (_e4839 < _e4855) {
                                            phi_3485_ = _e4839;
                                        } else {
                                            phi_3485_ = _e4855;
                                        }
                                        let _e4858 = phi_3485_;
                                        if (_e4823 < _e4858) {
                                            phi_3490_ = _e4823;
                                        } else {
                                            phi_3490_ = _e4858;
                                        }
                                        let _e4861 = phi_3490_;
                                        let _e4864 = local_10.member[0u];
                                        let _e4867 = local_10.member_1[0u];
                                        let _e4870 = local_10.member[0u];
                                        let _e4876 = local_10.member_2[0u];
                                        let _e4877 = ((_e4864 + ((_e4867 - _e4870) * _e3962)) - _e4876);
                                        let _e4880 = local_10.member[1u];
                                        let _e4883 = local_10.member_1[1u];
                                        let _e4886 = local_10.member[1u];
                                        let _e4892 = local_10.member_2[1u];
                                        let _e4893 = ((_e4880 + ((_e4883 - _e4886) * _e3962)) - _e4892);
                                        if (_e4877 < _e4893) {
                                            phi_3563_ = _e4877;
                                        } else {
                                            phi_3563_ = _e4893;
                                        }
                                        let _e4896 = phi_3563_;
                                        let _e4899 = local_10.member[2u];
                                        let _e4902 = local_10.member_1[2u];
                                        let _e4905 = local_10.member[2u];
                                        let _e4911 = local_10.member_2[2u];
                                        let _e4912 = ((_e4899 + ((_e4902 - _e4905) * _e3962)) - _e4911);
                                        let _e4915 = local_10.member[3u];
                                        let _e4918 = local_10.member_1[3u];
                                        let _e4921 = local_10.member[3u];
                                        let _e4927 = local_10.member_2[3u];
                                        let _e4928 = ((_e4915 + ((_e4918 - _e4921) * _e3962)) - _e4927);
                                        if (_e4912 < _e4928) {
                                            phi_3636_ = _e4912;
                                        } else {
                                            phi_3636_ = _e4928;
                                        }
                                        let _e4931 = phi_3636_;
                                        if (_e4896 < _e4931) {
                                            phi_3641_ = _e4896;
                                        } else {
                                            phi_3641_ = _e4931;
                                        }
                                        let _e4934 = phi_3641_;
                                        let _e4935 = f64(0.0625f);
                                        let _e4937 = f64(0.9f);
                                        if (_e4934 > f64(0f)) {
                                            phi_3664_ = f64(0.5f);
                                        } else {
                                            let _e4943 = (f64(0.95f) * (_e4861 / (_e4861 - _e4934)));
                                            if (_e4943 > _e4935) {
                                                if (_e4943 < _e4937) {
                                                    phi_3662_ = _e4943;
                                                } else {
                                                    phi_3662_ = _e4937;
                                                }
                                                let _e4947 = phi_3662_;
                                                phi_3663_ = _e4947;
                                            } else {
                                                phi_3663_ = _e4935;
                                            }
                                            let _e4949 = phi_3663_;
                                            phi_3664_ = _e4949;
                                        }
                                        let _e4951 = phi_3664_;
                                        phi_3666_ = (_e4273 * _e4951);
                                        phi_3667_ = true;
                                    }
                                    let _e4954 = phi_3666_;
                                    let _e4956 = phi_3667_;
                                    phi_3668_ = _e3964;
                                    phi_3669_ = _e4954;
                                    phi_3670_ = _e3966;
                                    phi_3671_ = _e4956;
                                    phi_3672_ = _e4788;
                                    phi_3673_ = false;
                                    phi_3674_ = false;
                                } else {
                                    phi_3668_ = _e4777;
                                    phi_3669_ = _e4779;
                                    phi_3670_ = _e3962;
                                    phi_3671_ = _e4783;
                                    phi_3672_ = false;
                                    phi_3673_ = _e4785;
                                    phi_3674_ = _e4787;
                                }
                                let _e4958 = phi_3668_;
                                let _e4960 = phi_3669_;
                                let _e4962 = phi_3670_;
                                let _e4964 = phi_3671_;
                                let _e4966 = phi_3672_;
                                let _e4968 = phi_3673_;
                                let _e4970 = phi_3674_;
                                if _e4964 {
                                    let _e4971 = (_e4962 + _e4960);
                                    if (_e4971 > _e4958) {
                                        phi_3683_ = _e4971;
                                    } else {
                                        phi_3683_ = _e4958;
                                    }
                                    let _e4974 = phi_3683_;
                                    if (_e4974 < _e3722) {
                                        phi_3688_ = _e4974;
                                    } else {
                                        phi_3688_ = _e3722;
                                    }
                                    let _e4977 = phi_3688_;
                                    if (_e3980.member_1 > 0u) {
                                        phi_3699_ = ((_e4977 - _e4962) > f64(0.0000000037252903f));
                                    } else {
                                        phi_3699_ = true;
                                    }
                                    let _e4983 = phi_3699_;
                                    if _e4983 {
                                        phi_3703_ = false;
                                    } else {
                                        phi_3703_ = true;
                                    }
                                    let _e4985 = phi_3703_;
                                    phi_3704_ = _e4977;
                                    phi_3705_ = _e4983;
                                    phi_3706_ = _e4985;
                                    phi_3707_ = false;
                                    phi_3708_ = false;
                                    phi_3709_ = false;
                                } else {
                                    phi_3704_ = f64();
                                    phi_3705_ = false;
                                    phi_3706_ = false;
                                    phi_3707_ = _e4966;
                                    phi_3708_ = _e4968;
                                    phi_3709_ = _e4970;
                                }
                                let _e4987 = phi_3704_;
                                let _e4989 = phi_3705_;
                                let _e4991 = phi_3706_;
                                let _e4993 = phi_3707_;
                                let _e4995 = phi_3708_;
                                let _e4997 = phi_3709_;
                                phi_2053_ = _e4987;
                                phi_2055_ = _e4958;
                                phi_2057_ = _e4962;
                                phi_3710_ = _e4958;
                                phi_3711_ = _e4989;
                                phi_3712_ = _e4991;
                                phi_3713_ = false;
                                phi_3714_ = _e4993;
                                phi_3715_ = _e4995;
                                phi_3716_ = _e4997;
                            } else {
                                phi_2053_ = f64();
                                phi_2055_ = f64();
                                phi_2057_ = f64();
                                phi_3710_ = f64();
                                phi_3711_ = false;
                                phi_3712_ = false;
                                phi_3713_ = true;
                                phi_3714_ = false;
                                phi_3715_ = false;
                                phi_3716_ = false;
                            }
                            let _e4999 = phi_2053_;
                            let _e5001 = phi_2055_;
                            let _e5003 = phi_2057_;
                            let _e5005 = phi_3710_;
                            let _e5007 = phi_3711_;
                            let _e5009 = phi_3712_;
                            let _e5011 = phi_3713_;
                            let _e5013 = phi_3714_;
                            let _e5015 = phi_3715_;
                            let _e5017 = phi_3716_;
                            local_25 = _e5009;
                            local_43 = _e5005;
                            local_45 = _e5011;
                            local_46 = _e5013;
                            local_47 = _e5015;
                            local_48 = _e5017;
                            continue;
                            continuing {
                                phi_2049_ = _e3978;
                                phi_2052_ = _e4999;
                                phi_2054_ = _e5001;
                                phi_2056_ = _e5003;
                                break if !(_e5007);
                            }
                        }
                        let _e5020 = local_25;
                        if _e5020 {
                            let _e6305 = local_43;
                            phi_3720_ = _e6305;
                            phi_3721_ = true;
                            phi_3722_ = false;
                            phi_3723_ = false;
                            phi_3724_ = false;
                        } else {
                            let _e6307 = local_44;
                            phi_3720_ = _e6307;
                            let _e6310 = local_45;
                            phi_3721_ = _e6310;
                            let _e6313 = local_46;
                            phi_3722_ = _e6313;
                            let _e6316 = local_47;
                            phi_3723_ = _e6316;
                            let _e6319 = local_48;
                            phi_3724_ = _e6319;
                        }
                        let _e5022 = phi_3720_;
                        let _e5024 = phi_3721_;
                        let _e5026 = phi_3722_;
                        let _e5028 = phi_3723_;
                        let _e5030 = phi_3724_;
                        if _e5024 {
                            phi_3729_ = type_44(1u, _e5022);
                            phi_3730_ = false;
                            phi_3731_ = false;
                            phi_3732_ = false;
                        } else {
                            phi_3729_ = type_44();
                            phi_3730_ = _e5026;
                            phi_3731_ = _e5028;
                            phi_3732_ = _e5030;
                        }
                        let _e5033 = phi_3729_;
                        let _e5035 = phi_3730_;
                        let _e5037 = phi_3731_;
                        let _e5039 = phi_3732_;
                        if _e5035 {
                            let _e5041 = local_26;
                            phi_3737_ = type_44(1u, _e5041);
                            phi_3738_ = false;
                            phi_3739_ = false;
                        } else {
                            phi_3737_ = type_44();
                            phi_3738_ = _e5037;
                            phi_3739_ = _e5039;
                        }
                        let _e5044 = phi_3737_;
                        let _e5046 = phi_3738_;
                        let _e5048 = phi_3739_;
                        if _e5046 {
                            phi_3744_ = type_44(0u, type_44().member_1);
                            phi_3745_ = false;
                            phi_3746_ = true;
                        } else {
                            phi_3744_ = _e5044;
                            phi_3745_ = _e5048;
                            phi_3746_ = _e5035;
                        }
                        let _e5052 = phi_3744_;
                        let _e5054 = phi_3745_;
                        let _e5056 = phi_3746_;
                        if _e5054 {
                            phi_3751_ = type_44(0u, type_44().member_1);
                            phi_3752_ = true;
                        } else {
                            phi_3751_ = _e5052;
                            phi_3752_ = _e5056;
                        }
                        let _e5060 = phi_3751_;
                        let _e5062 = phi_3752_;
                        if _e5062 {
                            phi_3756_ = _e5060;
                        } else {
                            phi_3756_ = _e5033;
                        }
                        let _e5064 = phi_3756_;
                        if (_e5064.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_3770_ = type_9(0u, 3u);
                            loop {
                                let _e5076 = phi_3770_;
                                if (_e5076.member < _e5076.member_1) {
                                    phi_3771_ = type_9((_e5076.member + 1u), _e5076.member_1);
                                    phi_3794_ = type_9(1u, _e5076.member);
                                } else {
                                    phi_3771_ = _e5076;
                                    phi_3794_ = type_9(0u, type_9().member_1);
                                }
                                let _e5088 = phi_3771_;
                                let _e5090 = phi_3794_;
                                if (bitcast<i32>(_e5090.member) != 0i) {
                                    let _e5096 = local_11[_e5090.member_1];
                                    let _e5098 = (_e5064.member_1 + f64(_e5096));
                                    if (_e5098 < _e3722) {
                                        phi_3815_ = _e5098;
                                    } else {
                                        phi_3815_ = _e3722;
                                    }
                                    let _e5101 = phi_3815_;
                                    let _e5104 = local_12.member[0u];
                                    let _e5110 = local_12.member[1u];
                                    let _e5126 = local_12.member_1[0u];
                                    let _e5132 = local_12.member_1[1u];
                                    let _e5148 = local_12.member_2[0u];
                                    let _e5154 = local_12.member_2[1u];
                                    let _e5168 = function_2(array<f64, 3>((_e5104[0] + ((_e5110[0] - _e5104[0]) * _e5101)), (_e5104[1] + ((_e5110[1] - _e5104[1]) * _e5101)), (_e5104[2] + ((_e5110[2] - _e5104[2]) * _e5101))), array<f64, 3>((_e5126[0] + ((_e5132[0] - _e5126[0]) * _e5101)), (_e5126[1] + ((_e5132[1] - _e5126[1]) * _e5101)), (_e5126[2] + ((_e5132[2] - _e5126[2]) * _e5101))), array<f64, 3>((_e5148[0] + ((_e5154[0] - _e5148[0]) * _e5101)), (_e5148[1] + ((_e5154[1] - _e5148[1]) * _e5101)), (_e5148[2] + ((_e5154[2] - _e5148[2]) * _e5101))), 1u);
                                    let _e5179 = (((_e5168[0] * _e5168[0]) + (_e5168[1] * _e5168[1])) + (_e5168[2] * _e5168[2]));
                                    if (_e5179 <= 2.2250738585072014e-308lf) {
                                        if (_e5179 > 0.0lf) {
                                            phi_3938_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3938_ = 0.0lf;
                                        }
                                        let _e5231 = phi_3938_;
                                        phi_4002_ = _e5231;
                                    } else {
                                        phi_3945_ = type_16(0i, 5i);
                                        phi_3948_ = bitcast<f64>(((bitcast<u64>(_e5179) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e5186 = phi_3945_;
                                            let _e5188 = phi_3948_;
                                            local_27 = _e5188;
                                            if (_e5186.member < _e5186.member_1) {
                                                let _e5195 = (_e5186.member + 1i);
                                                if ((false == (_e5195 > _e5186.member)) != false) {
                                                    phi_3969_ = true;
                                                } else {
                                                    phi_3969_ = false;
                                                }
                                                let _e5200 = phi_3969_;
                                                if _e5200 {
                                                    phi_3975_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_3975_ = type_17(1u, _e5195);
                                                }
                                                let _e5205 = phi_3975_;
                                                phi_3946_ = type_16(_e5205.member_1, _e5186.member_1);
                                                phi_3989_ = type_17(1u, _e5186.member);
                                            } else {
                                                phi_3946_ = _e5186;
                                                phi_3989_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e5211 = phi_3946_;
                                            let _e5213 = phi_3989_;
                                            let _e5216 = (bitcast<i32>(_e5213.member) != 0i);
                                            if _e5216 {
                                                phi_3949_ = (0.5lf * (_e5188 + (_e5179 / _e5188)));
                                            } else {
                                                phi_3949_ = f64();
                                            }
                                            let _e5221 = phi_3949_;
                                            continue;
                                            continuing {
                                                phi_3945_ = _e5211;
                                                phi_3948_ = _e5221;
                                                break if !(_e5216);
                                            }
                                        }
                                        let _e5226 = local_27;
                                        phi_4002_ = (_e5226 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e5233 = phi_4002_;
                                    let _e5241 = local_12.member[0u];
                                    if (_e5241[0] < 0.0lf) {
                                        phi_4020_ = -(_e5241[0]);
                                    } else {
                                        phi_4020_ = _e5241[0];
                                    }
                                    let _e5248 = phi_4020_;
                                    if (_e5241[1] < 0.0lf) {
                                        phi_4027_ = -(_e5241[1]);
                                    } else {
                                        phi_4027_ = _e5241[1];
                                    }
                                    let _e5252 = phi_4027_;
                                    if (_e5248 > _e5252) {
                                        phi_4032_ = _e5248;
                                    } else {
                                        phi_4032_ = _e5252;
                                    }
                                    let _e5255 = phi_4032_;
                                    if (_e5241[2] < 0.0lf) {
                                        phi_4039_ = -(_e5241[2]);
                                    } else {
                                        phi_4039_ = _e5241[2];
                                    }
                                    let _e5259 = phi_4039_;
                                    if (_e5255 > _e5259) {
                                        phi_4044_ = _e5255;
                                    } else {
                                        phi_4044_ = _e5259;
                                    }
                                    let _e5262 = phi_4044_;
                                    let _e5265 = local_12.member[1u];
                                    if (_e5265[0] < 0.0lf) {
                                        phi_4057_ = -(_e5265[0]);
                                    } else {
                                        phi_4057_ = _e5265[0];
                                    }
                                    let _e5272 = phi_4057_;
                                    if (_e5265[1] < 0.0lf) {
                                        phi_4064_ = -(_e5265[1]);
                                    } else {
                                        phi_4064_ = _e5265[1];
                                    }
                                    let _e5276 = phi_4064_;
                                    if (_e5272 > _e5276) {
                                        phi_4069_ = _e5272;
                                    } else {
                                        phi_4069_ = _e5276;
                                    }
                                    let _e5279 = phi_4069_;
                                    if (_e5265[2] < 0.0lf) {
                                        phi_4076_ = -(_e5265[2]);
                                    } else {
                                        phi_4076_ = _e5265[2];
                                    }
                                    let _e5283 = phi_4076_;
                                    if (_e5279 > _e5283) {
                                        phi_4081_ = _e5279;
                                    } else {
                                        phi_4081_ = _e5283;
                                    }
                                    let _e5286 = phi_4081_;
                                    if (_e5262 > _e5286) {
                                        phi_4086_ = _e5262;
                                    } else {
                                        phi_4086_ = _e5286;
                                    }
                                    let _e5289 = phi_4086_;
                                    let _e5291 = local_12.member_3;
                                    let _e5295 = local_12.member_1[0u];
                                    if (_e5295[0] < 0.0lf) {
                                        phi_4103_ = -(_e5295[0]);
                                    } else {
                                        phi_4103_ = _e5295[0];
                                    }
                                    let _e5302 = phi_4103_;
                                    if (_e5295[1] < 0.0lf) {
                                        phi_4110_ = -(_e5295[1]);
                                    } else {
                                        phi_4110_ = _e5295[1];
                                    }
                                    let _e5306 = phi_4110_;
                                    if (_e5302 > _e5306) {
                                        phi_4115_ = _e5302;
                                    } else {
                                        phi_4115_ = _e5306;
                                    }
                                    let _e5309 = phi_4115_;
                                    if (_e5295[2] < 0.0lf) {
                                        phi_4122_ = -(_e5295[2]);
                                    } else {
                                        phi_4122_ = _e5295[2];
                                    }
                                    let _e5313 = phi_4122_;
                                    if (_e5309 > _e5313) {
                                        phi_4127_ = _e5309;
                                    } else {
                                        phi_4127_ = _e5313;
                                    }
                                    let _e5316 = phi_4127_;
                                    let _e5319 = local_12.member_1[1u];
                                    if (_e5319[0] < 0.0lf) {
                                        phi_4141_ = -(_e5319[0]);
                                    } else {
                                        phi_4141_ = _e5319[0];
                                    }
                                    let _e5326 = phi_4141_;
                                    if (_e5319[1] < 0.0lf) {
                                        phi_4148_ = -(_e5319[1]);
                                    } else {
                                        phi_4148_ = _e5319[1];
                                    }
                                    let _e5330 = phi_4148_;
                                    if (_e5326 > _e5330) {
                                        phi_4153_ = _e5326;
                                    } else {
                                        phi_4153_ = _e5330;
                                    }
                                    let _e5333 = phi_4153_;
                                    if (_e5319[2] < 0.0lf) {
                                        phi_4160_ = -(_e5319[2]);
                                    } else {
                                        phi_4160_ = _e5319[2];
                                    }
                                    let _e5337 = phi_4160_;
                                    if (_e5333 > _e5337) {
                                        phi_4165_ = _e5333;
                                    } else {
                                        phi_4165_ = _e5337;
                                    }
                                    let _e5340 = phi_4165_;
                                    if (_e5316 > _e5340) {
                                        phi_4170_ = _e5316;
                                    } else {
                                        phi_4170_ = _e5340;
                                    }
                                    let _e5343 = phi_4170_;
                                    let _e5345 = local_12.member_3;
                                    let _e5349 = local_12.member_2[0u];
                                    if (_e5349[0] < 0.0lf) {
                                        phi_4187_ = -(_e5349[0]);
                                    } else {
                                        phi_4187_ = _e5349[0];
                                    }
                                    let _e5356 = phi_4187_;
                                    if (_e5349[1] < 0.0lf) {
                                        phi_4194_ = -(_e5349[1]);
                                    } else {
                                        phi_4194_ = _e5349[1];
                                    }
                                    let _e5360 = phi_4194_;
                                    if (_e5356 > _e5360) {
                                        phi_4199_ = _e5356;
                                    } else {
                                        phi_4199_ = _e5360;
                                    }
                                    let _e5363 = phi_4199_;
                                    if (_e5349[2] < 0.0lf) {
                                        phi_4206_ = -(_e5349[2]);
                                    } else {
                                        phi_4206_ = _e5349[2];
                                    }
                                    let _e5367 = phi_4206_;
                                    if (_e5363 > _e5367) {
                                        phi_4211_ = _e5363;
                                    } else {
                                        phi_4211_ = _e5367;
                                    }
                                    let _e5370 = phi_4211_;
                                    let _e5373 = local_12.member_2[1u];
                                    if (_e5373[0] < 0.0lf) {
                                        phi_4225_ = -(_e5373[0]);
                                    } else {
                                        phi_4225_ = _e5373[0];
                                    }
                                    let _e5380 = phi_4225_;
                                    if (_e5373[1] < 0.0lf) {
                                        phi_4232_ = -(_e5373[1]);
                                    } else {
                                        phi_4232_ = _e5373[1];
                                    }
                                    let _e5384 = phi_4232_;
                                    if (_e5380 > _e5384) {
                                        phi_4237_ = _e5380;
                                    } else {
                                        phi_4237_ = _e5384;
                                    }
                                    let _e5387 = phi_4237_;
                                    if (_e5373[2] < 0.0lf) {
                                        phi_4244_ = -(_e5373[2]);
                                    } else {
                                        phi_4244_ = _e5373[2];
                                    }
                                    let _e5391 = phi_4244_;
                                    if (_e5387 > _e5391) {
                                        phi_4249_ = _e5387;
                                    } else {
                                        phi_4249_ = _e5391;
                                    }
                                    let _e5394 = phi_4249_;
                                    if (_e5370 > _e5394) {
                                        phi_4254_ = _e5370;
                                    } else {
                                        phi_4254_ = _e5394;
                                    }
                                    let _e5397 = phi_4254_;
                                    let _e5399 = local_12.member_3;
                                    let _e5407 = local_12.member_3;
                                    let _e5417 = (((_e5233 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5289 + _e5291) + (_e5343 + _e5345)) + (_e5397 + _e5399)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5407 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e578.member_1);
                                    if _e5417 {
                                        phi_4278_ = false;
                                    } else {
                                        phi_4278_ = true;
                                    }
                                    let _e5419 = phi_4278_;
                                    phi_4279_ = _e5419;
                                    phi_4280_ = _e5417;
                                } else {
                                    phi_4279_ = false;
                                    phi_4280_ = false;
                                }
                                let _e5421 = phi_4279_;
                                let _e5423 = phi_4280_;
                                local_28 = _e5423;
                                continue;
                                continuing {
                                    phi_3770_ = _e5088;
                                    break if !(_e5421);
                                }
                            }
                            let _e5426 = local_28;
                            if _e5426 {
                                phi_4285_ = type_44(1u, _e5064.member_1);
                                phi_4286_ = false;
                            } else {
                                phi_4285_ = type_44();
                                phi_4286_ = true;
                            }
                            let _e5429 = phi_4285_;
                            let _e5431 = phi_4286_;
                            if _e5431 {
                                phi_4291_ = type_44(2u, _e5064.member_1);
                                phi_4292_ = false;
                            } else {
                                phi_4291_ = type_44();
                                phi_4292_ = true;
                            }
                            let _e5434 = phi_4291_;
                            let _e5436 = phi_4292_;
                            phi_4294_ = _e5434;
                            phi_4295_ = _e5429;
                            phi_4296_ = _e5436;
                        } else {
                            phi_4294_ = type_44();
                            phi_4295_ = type_44(0u, type_44().member_1);
                            phi_4296_ = true;
                        }
                        let _e5438 = phi_4294_;
                        let _e5440 = phi_4295_;
                        let _e5442 = phi_4296_;
                        if _e5442 {
                            phi_4300_ = _e5440;
                        } else {
                            phi_4300_ = _e5438;
                        }
                        let _e5444 = phi_4300_;
                        phi_8270_ = _e5444;
                    } else {
                        if (_e716 < 0.0lf) {
                            phi_4311_ = -(_e716);
                        } else {
                            phi_4311_ = _e716;
                        }
                        let _e1073 = phi_4311_;
                        if (_e739 < 0.0lf) {
                            phi_4317_ = -(_e739);
                        } else {
                            phi_4317_ = _e739;
                        }
                        let _e1077 = phi_4317_;
                        if (_e1073 > _e1077) {
                            phi_4322_ = _e1073;
                        } else {
                            phi_4322_ = _e1077;
                        }
                        let _e1080 = phi_4322_;
                        if (_e762 < 0.0lf) {
                            phi_4328_ = -(_e762);
                        } else {
                            phi_4328_ = _e762;
                        }
                        let _e1084 = phi_4328_;
                        if (_e773 < 0.0lf) {
                            phi_4334_ = -(_e773);
                        } else {
                            phi_4334_ = _e773;
                        }
                        let _e1088 = phi_4334_;
                        if (_e1084 > _e1088) {
                            phi_4339_ = _e1084;
                        } else {
                            phi_4339_ = _e1088;
                        }
                        let _e1091 = phi_4339_;
                        if (_e1080 > _e1091) {
                            phi_4344_ = _e1080;
                        } else {
                            phi_4344_ = _e1091;
                        }
                        let _e1094 = phi_4344_;
                        let _e1096 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1097 = f64(1f);
                        if (_e1094 >= _e1096) {
                            phi_4354_ = (_e1094 <= (_e1097 / _e1096));
                        } else {
                            phi_4354_ = false;
                        }
                        let _e1102 = phi_4354_;
                        if _e1102 {
                            phi_4361_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4361_ = f64(2f);
                        }
                        let _e1107 = phi_4361_;
                        let _e1109 = ((_e1032 * f64(0.34f)) + (_e1094 * _e1107));
                        if _e1102 {
                            phi_4369_ = (_e1097 / _e1094);
                        } else {
                            phi_4369_ = f64(0f);
                        }
                        let _e1113 = phi_4369_;
                        let _e1114 = f64(0f);
                        let _e1115 = f64(1f);
                        let _e1116 = f64(3f);
                        let _e1122 = ((_e739 - (_e1116 * _e716)) * _e1113);
                        let _e1123 = ((_e762 - _e739) * _e1113);
                        let _e1124 = (((_e1116 * _e773) - _e762) * _e1113);
                        local_6[0u] = _e1114;
                        local_6[1u] = _e1115;
                        local_6[2u] = _e1115;
                        local_6[3u] = _e1115;
                        let _e1131 = ((_e1123 * _e1123) - (_e1122 * _e1124));
                        if (_e1131 > _e1114) {
                            if (_e1131 <= 2.2250738585072014e-308lf) {
                                if (_e1131 > 0.0lf) {
                                    phi_4405_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4405_ = 0.0lf;
                                }
                                let _e1184 = phi_4405_;
                                phi_4469_ = _e1184;
                            } else {
                                phi_4412_ = type_16(0i, 5i);
                                phi_4415_ = bitcast<f64>(((bitcast<u64>(_e1131) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1139 = phi_4412_;
                                    let _e1141 = phi_4415_;
                                    local_13 = _e1141;
                                    if (_e1139.member < _e1139.member_1) {
                                        let _e1148 = (_e1139.member + 1i);
                                        if ((false == (_e1148 > _e1139.member)) != false) {
                                            phi_4436_ = true;
                                        } else {
                                            phi_4436_ = false;
                                        }
                                        let _e1153 = phi_4436_;
                                        if _e1153 {
                                            phi_4442_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_4442_ = type_17(1u, _e1148);
                                        }
                                        let _e1158 = phi_4442_;
                                        phi_4413_ = type_16(_e1158.member_1, _e1139.member_1);
                                        phi_4456_ = type_17(1u, _e1139.member);
                                    } else {
                                        phi_4413_ = _e1139;
                                        phi_4456_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e1164 = phi_4413_;
                                    let _e1166 = phi_4456_;
                                    let _e1169 = (bitcast<i32>(_e1166.member) != 0i);
                                    if _e1169 {
                                        phi_4416_ = (0.5lf * (_e1141 + (_e1131 / _e1141)));
                                    } else {
                                        phi_4416_ = f64();
                                    }
                                    let _e1174 = phi_4416_;
                                    continue;
                                    continuing {
                                        phi_4412_ = _e1164;
                                        phi_4415_ = _e1174;
                                        break if !(_e1169);
                                    }
                                }
                                let _e1179 = local_13;
                                phi_4469_ = (_e1179 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1186 = phi_4469_;
                            if (_e1123 < _e1114) {
                                phi_4475_ = -(_e1186);
                            } else {
                                phi_4475_ = _e1186;
                            }
                            let _e1190 = phi_4475_;
                            let _e1192 = -((_e1123 + _e1190));
                            local_7[0u] = (_e1192 / (_e1192 + _e1124));
                            local_7[1u] = (_e1122 / (_e1122 + _e1192));
                            let _e1201 = local_7[1u];
                            let _e1202 = local_7[0u];
                            if (_e1201 < _e1202) {
                                let _e1205 = local_7[1u];
                                let _e1207 = local_7[0u];
                                local_7[0u] = _e1205;
                                local_7[1u] = _e1207;
                            }
                            phi_4500_ = type_9(0u, 2u);
                            phi_4503_ = 1u;
                            loop {
                                let _e1211 = phi_4500_;
                                let _e1213 = phi_4503_;
                                local_29 = _e1213;
                                if (_e1211.member < _e1211.member_1) {
                                    phi_4501_ = type_9((_e1211.member + 1u), _e1211.member_1);
                                    phi_4526_ = type_9(1u, _e1211.member);
                                } else {
                                    phi_4501_ = _e1211;
                                    phi_4526_ = type_9(0u, type_9().member_1);
                                }
                                let _e1225 = phi_4501_;
                                let _e1227 = phi_4526_;
                                let _e1231 = (bitcast<i32>(_e1227.member) != 0i);
                                if _e1231 {
                                    let _e1233 = local_7[_e1227.member_1];
                                    if (_e1233 > _e1114) {
                                        let _e1236 = local_7[_e1227.member_1];
                                        if (_e1236 < _e1115) {
                                            let _e1239 = local_7[_e1227.member_1];
                                            local_6[_e1213] = _e1239;
                                            phi_4570_ = (_e1213 + 1u);
                                        } else {
                                            phi_4570_ = _e1213;
                                        }
                                        let _e1243 = phi_4570_;
                                        phi_4571_ = _e1243;
                                    } else {
                                        phi_4571_ = _e1213;
                                    }
                                    let _e1245 = phi_4571_;
                                    phi_4504_ = _e1245;
                                } else {
                                    phi_4504_ = u32();
                                }
                                let _e1247 = phi_4504_;
                                continue;
                                continuing {
                                    phi_4500_ = _e1225;
                                    phi_4503_ = _e1247;
                                    break if !(_e1231);
                                }
                            }
                            let _e5670 = local_29;
                            phi_4572_ = _e5670;
                        } else {
                            phi_4572_ = 1u;
                        }
                        let _e1250 = phi_4572_;
                        local_6[_e1250] = _e1115;
                        let _e1252 = local_6;
                        local_8 = _e1252;
                        phi_4592_ = type_9(0u, _e1250);
                        loop {
                            let _e1255 = phi_4592_;
                            if (_e1255.member < _e1255.member_1) {
                                phi_4593_ = type_9((_e1255.member + 1u), _e1255.member_1);
                                phi_4616_ = type_9(1u, _e1255.member);
                            } else {
                                phi_4593_ = _e1255;
                                phi_4616_ = type_9(0u, type_9().member_1);
                            }
                            let _e1267 = phi_4593_;
                            let _e1269 = phi_4616_;
                            if (bitcast<i32>(_e1269.member) != 0i) {
                                let _e1275 = local_8[_e1269.member_1];
                                let _e1278 = local_8[(_e1269.member_1 + 1u)];
                                let _e1280 = (f64(1f) - _e1275);
                                let _e1291 = ((((_e716 * _e1280) + (_e739 * _e1275)) * (_e1280 * _e1280)) + (((_e762 * _e1280) + (_e773 * _e1275)) * (_e1275 * _e1275)));
                                let _e1293 = (f64(1f) - _e1278);
                                let _e1304 = ((((_e716 * _e1293) + (_e739 * _e1278)) * (_e1293 * _e1293)) + (((_e762 * _e1293) + (_e773 * _e1278)) * (_e1278 * _e1278)));
                                if (_e1291 < 0.0lf) {
                                    phi_4670_ = -(_e1291);
                                } else {
                                    phi_4670_ = _e1291;
                                }
                                let _e1308 = phi_4670_;
                                let _e1309 = (_e1308 > _e1109);
                                if (_e1304 < 0.0lf) {
                                    phi_4677_ = -(_e1304);
                                } else {
                                    phi_4677_ = _e1304;
                                }
                                let _e1313 = phi_4677_;
                                let _e1314 = (_e1313 > _e1109);
                                let _e1315 = f64(0f);
                                if _e1309 {
                                    if _e1314 {
                                        phi_4689_ = ((_e1291 > _e1315) != (_e1304 > _e1315));
                                        phi_4690_ = false;
                                    } else {
                                        phi_4689_ = bool();
                                        phi_4690_ = true;
                                    }
                                    let _e1320 = phi_4689_;
                                    let _e1322 = phi_4690_;
                                    phi_4691_ = _e1320;
                                    phi_4692_ = _e1322;
                                } else {
                                    phi_4691_ = bool();
                                    phi_4692_ = true;
                                }
                                let _e1324 = phi_4691_;
                                let _e1326 = phi_4692_;
                                if _e1326 {
                                    phi_4696_ = false;
                                } else {
                                    phi_4696_ = _e1324;
                                }
                                let _e1328 = phi_4696_;
                                if _e1309 {
                                    if _e1314 {
                                        if _e1328 {
                                            phi_4708_ = type_45();
                                        } else {
                                            phi_4708_ = type_45(f64(1f), _e1315, _e1328);
                                        }
                                        let _e1332 = phi_4708_;
                                        phi_4709_ = _e1332;
                                        phi_4710_ = _e1328;
                                    } else {
                                        phi_4709_ = type_45();
                                        phi_4710_ = true;
                                    }
                                    let _e1334 = phi_4709_;
                                    let _e1336 = phi_4710_;
                                    phi_4711_ = _e1334;
                                    phi_4712_ = _e1336;
                                } else {
                                    phi_4711_ = type_45();
                                    phi_4712_ = true;
                                }
                                let _e1338 = phi_4711_;
                                let _e1340 = phi_4712_;
                                if _e1340 {
                                    if _e1309 {
                                        if (_e1291 < _e1315) {
                                            phi_4725_ = f64(-1f);
                                        } else {
                                            phi_4725_ = f64(1f);
                                        }
                                        let _e1345 = phi_4725_;
                                        let _e1346 = f64(0.00000000000022737368f);
                                        let _e1347 = f64(0.5f);
                                        let _e1348 = f64(3f);
                                        let _e1351 = (_e762 - _e739);
                                        phi_4738_ = type_9(0u, 64u);
                                        phi_4741_ = _e1278;
                                        phi_4743_ = _e1275;
                                        phi_4745_ = (_e1347 * (_e1275 + _e1278));
                                        loop {
                                            let _e1357 = phi_4738_;
                                            let _e1359 = phi_4741_;
                                            let _e1361 = phi_4743_;
                                            let _e1363 = phi_4745_;
                                            local_31 = _e1361;
                                            if (_e1357.member < _e1357.member_1) {
                                                phi_4739_ = type_9((_e1357.member + 1u), _e1357.member_1);
                                                phi_4768_ = type_9(1u, _e1357.member);
                                            } else {
                                                phi_4739_ = _e1357;
                                                phi_4768_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1375 = phi_4739_;
                                            let _e1377 = phi_4768_;
                                            if (bitcast<i32>(_e1377.member) != 0i) {
                                                let _e1382 = (f64(1f) - _e1363);
                                                let _e1395 = ((_e1345 * ((((_e716 * _e1382) + (_e739 * _e1363)) * (_e1382 * _e1382)) + (((_e762 * _e1382) + (_e773 * _e1363)) * (_e1363 * _e1363)))) - _e1109);
                                                if (_e1395 > f64(0f)) {
                                                    phi_4795_ = _e1359;
                                                    phi_4796_ = _e1363;
                                                } else {
                                                    phi_4795_ = _e1363;
                                                    phi_4796_ = _e1361;
                                                }
                                                let _e1399 = phi_4795_;
                                                let _e1401 = phi_4796_;
                                                let _e1403 = ((_e1399 - _e1401) > _e1346);
                                                if _e1403 {
                                                    let _e1405 = (f64(1f) - _e1363);
                                                    let _e1417 = (-(_e1395) / (_e1345 * (((((_e739 - (_e1348 * _e716)) * _e1405) + (_e1351 * _e1363)) * _e1405) + (((_e1351 * _e1405) + (((_e1348 * _e773) - _e762) * _e1363)) * _e1363))));
                                                    if (_e1395 > f64(0f)) {
                                                        phi_4824_ = (_e1347 * _e1346);
                                                    } else {
                                                        phi_4824_ = -((_e1347 * _e1346));
                                                    }
                                                    let _e1424 = phi_4824_;
                                                    let _e1426 = ((_e1363 + _e1417) + _e1424);
                                                    if (_e1426 > _e1401) {
                                                        if (_e1426 < _e1399) {
                                                            if (_e1417 < 0.0lf) {
                                                                phi_4840_ = -(_e1417);
                                                            } else {
                                                                phi_4840_ = _e1417;
                                                            }
                                                            let _e1432 = phi_4840_;
                                                            if (_e1432 < (_e1347 * (_e1399 - _e1401))) {
                                                                phi_4847_ = false;
                                                            } else {
                                                                phi_4847_ = true;
                                                            }
                                                            let _e1437 = phi_4847_;
                                                            phi_4848_ = _e1437;
                                                        } else {
                                                            phi_4848_ = true;
                                                        }
                                                        let _e1439 = phi_4848_;
                                                        phi_4849_ = _e1439;
                                                    } else {
                                                        phi_4849_ = true;
                                                    }
                                                    let _e1441 = phi_4849_;
                                                    if _e1441 {
                                                        phi_4855_ = (_e1347 * (_e1401 + _e1399));
                                                    } else {
                                                        phi_4855_ = _e1426;
                                                    }
                                                    let _e1445 = phi_4855_;
                                                    phi_4856_ = _e1445;
                                                    phi_4857_ = false;
                                                } else {
                                                    phi_4856_ = f64();
                                                    phi_4857_ = true;
                                                }
                                                let _e1447 = phi_4856_;
                                                let _e1449 = phi_4857_;
                                                phi_4742_ = _e1399;
                                                phi_4744_ = _e1401;
                                                phi_4746_ = _e1447;
                                                phi_4858_ = _e1401;
                                                phi_4859_ = _e1403;
                                                phi_4860_ = _e1449;
                                            } else {
                                                phi_4742_ = f64();
                                                phi_4744_ = f64();
                                                phi_4746_ = f64();
                                                phi_4858_ = f64();
                                                phi_4859_ = false;
                                                phi_4860_ = false;
                                            }
                                            let _e1451 = phi_4742_;
                                            let _e1453 = phi_4744_;
                                            let _e1455 = phi_4746_;
                                            let _e1457 = phi_4858_;
                                            let _e1459 = phi_4859_;
                                            let _e1461 = phi_4860_;
                                            local_14 = _e1461;
                                            local_30 = _e1457;
                                            continue;
                                            continuing {
                                                phi_4738_ = _e1375;
                                                phi_4741_ = _e1451;
                                                phi_4743_ = _e1453;
                                                phi_4745_ = _e1455;
                                                break if !(_e1459);
                                            }
                                        }
                                        let _e1464 = local_14;
                                        if _e1464 {
                                            let _e5712 = local_30;
                                            phi_4864_ = _e5712;
                                        } else {
                                            let _e5714 = local_31;
                                            phi_4864_ = _e5714;
                                        }
                                        let _e1466 = phi_4864_;
                                        phi_4865_ = _e1466;
                                    } else {
                                        phi_4865_ = _e1275;
                                    }
                                    let _e1468 = phi_4865_;
                                    if _e1314 {
                                        if (_e1304 < _e1315) {
                                            phi_4875_ = f64(-1f);
                                        } else {
                                            phi_4875_ = f64(1f);
                                        }
                                        let _e1473 = phi_4875_;
                                        phi_4880_ = type_9(0u, 64u);
                                        phi_4883_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1477 = phi_4880_;
                                            let _e1479 = phi_4883_;
                                            if (_e1477.member < _e1477.member_1) {
                                                phi_4881_ = type_9((_e1477.member + 1u), _e1477.member_1);
                                                phi_4906_ = type_9(1u, _e1477.member);
                                            } else {
                                                phi_4881_ = _e1477;
                                                phi_4906_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1491 = phi_4881_;
                                            let _e1493 = phi_4906_;
                                            if (bitcast<i32>(_e1493.member) != 0i) {
                                                let _e1497 = (_e1468 + _e1479);
                                                if (_e1497 < _e1278) {
                                                    let _e1500 = (f64(1f) - _e1497);
                                                    let _e1513 = ((_e1473 * ((((_e716 * _e1500) + (_e739 * _e1497)) * (_e1500 * _e1500)) + (((_e762 * _e1500) + (_e773 * _e1497)) * (_e1497 * _e1497)))) > _e1109);
                                                    if _e1513 {
                                                        phi_4937_ = f64();
                                                        phi_4938_ = false;
                                                    } else {
                                                        phi_4937_ = (_e1479 + _e1479);
                                                        phi_4938_ = true;
                                                    }
                                                    let _e1516 = phi_4937_;
                                                    let _e1518 = phi_4938_;
                                                    phi_4939_ = _e1516;
                                                    phi_4940_ = _e1518;
                                                    phi_4941_ = _e1513;
                                                    phi_4942_ = false;
                                                } else {
                                                    phi_4939_ = f64();
                                                    phi_4940_ = false;
                                                    phi_4941_ = false;
                                                    phi_4942_ = true;
                                                }
                                                let _e1520 = phi_4939_;
                                                let _e1522 = phi_4940_;
                                                let _e1524 = phi_4941_;
                                                let _e1526 = phi_4942_;
                                                phi_4943_ = _e1497;
                                                phi_4884_ = _e1520;
                                                phi_4944_ = _e1522;
                                                phi_4945_ = _e1524;
                                                phi_4946_ = _e1526;
                                                phi_4947_ = false;
                                            } else {
                                                phi_4943_ = f64();
                                                phi_4884_ = f64();
                                                phi_4944_ = false;
                                                phi_4945_ = false;
                                                phi_4946_ = false;
                                                phi_4947_ = true;
                                            }
                                            let _e1528 = phi_4943_;
                                            let _e1530 = phi_4884_;
                                            let _e1532 = phi_4944_;
                                            let _e1534 = phi_4945_;
                                            let _e1536 = phi_4946_;
                                            let _e1538 = phi_4947_;
                                            local_15 = _e1534;
                                            local_32 = _e1536;
                                            local_33 = _e1538;
                                            local_34 = _e1528;
                                            continue;
                                            continuing {
                                                phi_4880_ = _e1491;
                                                phi_4883_ = _e1530;
                                                break if !(_e1532);
                                            }
                                        }
                                        let _e1541 = local_15;
                                        if _e1541 {
                                            phi_4951_ = false;
                                            phi_4952_ = false;
                                        } else {
                                            let _e5736 = local_32;
                                            phi_4951_ = _e5736;
                                            let _e5739 = local_33;
                                            phi_4952_ = _e5739;
                                        }
                                        let _e1543 = phi_4951_;
                                        let _e1545 = phi_4952_;
                                        if _e1543 {
                                            phi_4956_ = true;
                                        } else {
                                            phi_4956_ = _e1545;
                                        }
                                        let _e1547 = phi_4956_;
                                        if _e1547 {
                                            phi_4960_ = _e1278;
                                        } else {
                                            let _e5743 = local_34;
                                            phi_4960_ = _e5743;
                                        }
                                        let _e1549 = phi_4960_;
                                        phi_4961_ = _e1549;
                                    } else {
                                        phi_4961_ = _e1278;
                                    }
                                    let _e1551 = phi_4961_;
                                    phi_4963_ = type_45(_e1468, _e1551, _e1328);
                                } else {
                                    phi_4963_ = _e1338;
                                }
                                let _e1554 = phi_4963_;
                                if (_e1554.member > _e1554.member_1) {
                                    phi_8226_ = f64();
                                    phi_8227_ = true;
                                    phi_8228_ = false;
                                    phi_8229_ = false;
                                    phi_8230_ = false;
                                } else {
                                    let _e1562 = ((_e1554.member_1 - _e1554.member) * f64(0.5f));
                                    let _e1563 = (_e1554.member + _e1562);
                                    let _e1566 = (_e1562 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1568 = local_12.member_3;
                                    let _e1571 = local_12.member[0u];
                                    if (_e1571[0] < 0.0lf) {
                                        phi_4994_ = -(_e1571[0]);
                                    } else {
                                        phi_4994_ = _e1571[0];
                                    }
                                    let _e1578 = phi_4994_;
                                    if (_e1571[1] < 0.0lf) {
                                        phi_5001_ = -(_e1571[1]);
                                    } else {
                                        phi_5001_ = _e1571[1];
                                    }
                                    let _e1582 = phi_5001_;
                                    if (_e1578 > _e1582) {
                                        phi_5006_ = _e1578;
                                    } else {
                                        phi_5006_ = _e1582;
                                    }
                                    let _e1585 = phi_5006_;
                                    if (_e1571[2] < 0.0lf) {
                                        phi_5013_ = -(_e1571[2]);
                                    } else {
                                        phi_5013_ = _e1571[2];
                                    }
                                    let _e1589 = phi_5013_;
                                    if (_e1585 > _e1589) {
                                        phi_5018_ = _e1585;
                                    } else {
                                        phi_5018_ = _e1589;
                                    }
                                    let _e1592 = phi_5018_;
                                    let _e1594 = local_12.member[1u];
                                    if (_e1594[0] < 0.0lf) {
                                        phi_5031_ = -(_e1594[0]);
                                    } else {
                                        phi_5031_ = _e1594[0];
                                    }
                                    let _e1601 = phi_5031_;
                                    if (_e1594[1] < 0.0lf) {
                                        phi_5038_ = -(_e1594[1]);
                                    } else {
                                        phi_5038_ = _e1594[1];
                                    }
                                    let _e1605 = phi_5038_;
                                    if (_e1601 > _e1605) {
                                        phi_5043_ = _e1601;
                                    } else {
                                        phi_5043_ = _e1605;
                                    }
                                    let _e1608 = phi_5043_;
                                    if (_e1594[2] < 0.0lf) {
                                        phi_5050_ = -(_e1594[2]);
                                    } else {
                                        phi_5050_ = _e1594[2];
                                    }
                                    let _e1612 = phi_5050_;
                                    if (_e1608 > _e1612) {
                                        phi_5055_ = _e1608;
                                    } else {
                                        phi_5055_ = _e1612;
                                    }
                                    let _e1615 = phi_5055_;
                                    if (_e1592 > _e1615) {
                                        phi_5060_ = _e1592;
                                    } else {
                                        phi_5060_ = _e1615;
                                    }
                                    let _e1618 = phi_5060_;
                                    let _e1621 = local_12.member[0u];
                                    let _e1626 = local_12.member[1u];
                                    let _e1636 = (_e1621[0] + ((_e1626[0] - _e1621[0]) * _e1563));
                                    let _e1637 = (_e1621[1] + ((_e1626[1] - _e1621[1]) * _e1563));
                                    let _e1638 = (_e1621[2] + ((_e1626[2] - _e1621[2]) * _e1563));
                                    let _e1640 = local_12.member[1u];
                                    let _e1645 = local_12.member[0u];
                                    let _e1649 = (_e1640[0] - _e1645[0]);
                                    let _e1650 = (_e1640[1] - _e1645[1]);
                                    let _e1651 = (_e1640[2] - _e1645[2]);
                                    if (_e1649 < 0.0lf) {
                                        phi_5119_ = -(_e1649);
                                    } else {
                                        phi_5119_ = _e1649;
                                    }
                                    let _e1655 = phi_5119_;
                                    if (_e1650 < 0.0lf) {
                                        phi_5125_ = -(_e1650);
                                    } else {
                                        phi_5125_ = _e1650;
                                    }
                                    let _e1659 = phi_5125_;
                                    if (_e1655 > _e1659) {
                                        phi_5130_ = _e1655;
                                    } else {
                                        phi_5130_ = _e1659;
                                    }
                                    let _e1662 = phi_5130_;
                                    if (_e1651 < 0.0lf) {
                                        phi_5136_ = -(_e1651);
                                    } else {
                                        phi_5136_ = _e1651;
                                    }
                                    let _e1666 = phi_5136_;
                                    if (_e1662 > _e1666) {
                                        phi_5141_ = _e1662;
                                    } else {
                                        phi_5141_ = _e1666;
                                    }
                                    let _e1669 = phi_5141_;
                                    let _e1677 = ((((_e1566 * _e1669) * f64(1.01f)) + ((_e1618 + _e1568) * (1.1102230246251565e-16lf * f64(8f)))) + _e1568);
                                    if (_e1636 < 0.0lf) {
                                        phi_5155_ = -(_e1636);
                                    } else {
                                        phi_5155_ = _e1636;
                                    }
                                    let _e1681 = phi_5155_;
                                    if (_e1637 < 0.0lf) {
                                        phi_5161_ = -(_e1637);
                                    } else {
                                        phi_5161_ = _e1637;
                                    }
                                    let _e1685 = phi_5161_;
                                    if (_e1681 > _e1685) {
                                        phi_5166_ = _e1681;
                                    } else {
                                        phi_5166_ = _e1685;
                                    }
                                    let _e1688 = phi_5166_;
                                    if (_e1638 < 0.0lf) {
                                        phi_5172_ = -(_e1638);
                                    } else {
                                        phi_5172_ = _e1638;
                                    }
                                    let _e1692 = phi_5172_;
                                    if (_e1688 > _e1692) {
                                        phi_5177_ = _e1688;
                                    } else {
                                        phi_5177_ = _e1692;
                                    }
                                    let _e1695 = phi_5177_;
                                    local_2 = type_35(array<f64, 3>(_e1636, _e1637, _e1638), _e1677, (_e1695 + _e1677));
                                    let _e1701 = local_12.member_3;
                                    let _e1703 = local_12.member_1[0u];
                                    if (_e1703[0] < 0.0lf) {
                                        phi_5203_ = -(_e1703[0]);
                                    } else {
                                        phi_5203_ = _e1703[0];
                                    }
                                    let _e1710 = phi_5203_;
                                    if (_e1703[1] < 0.0lf) {
                                        phi_5210_ = -(_e1703[1]);
                                    } else {
                                        phi_5210_ = _e1703[1];
                                    }
                                    let _e1714 = phi_5210_;
                                    if (_e1710 > _e1714) {
                                        phi_5215_ = _e1710;
                                    } else {
                                        phi_5215_ = _e1714;
                                    }
                                    let _e1717 = phi_5215_;
                                    if (_e1703[2] < 0.0lf) {
                                        phi_5222_ = -(_e1703[2]);
                                    } else {
                                        phi_5222_ = _e1703[2];
                                    }
                                    let _e1721 = phi_5222_;
                                    if (_e1717 > _e1721) {
                                        phi_5227_ = _e1717;
                                    } else {
                                        phi_5227_ = _e1721;
                                    }
                                    let _e1724 = phi_5227_;
                                    let _e1726 = local_12.member_1[1u];
                                    if (_e1726[0] < 0.0lf) {
                                        phi_5240_ = -(_e1726[0]);
                                    } else {
                                        phi_5240_ = _e1726[0];
                                    }
                                    let _e1733 = phi_5240_;
                                    if (_e1726[1] < 0.0lf) {
                                        phi_5247_ = -(_e1726[1]);
                                    } else {
                                        phi_5247_ = _e1726[1];
                                    }
                                    let _e1737 = phi_5247_;
                                    if (_e1733 > _e1737) {
                                        phi_5252_ = _e1733;
                                    } else {
                                        phi_5252_ = _e1737;
                                    }
                                    let _e1740 = phi_5252_;
                                    if (_e1726[2] < 0.0lf) {
                                        phi_5259_ = -(_e1726[2]);
                                    } else {
                                        phi_5259_ = _e1726[2];
                                    }
                                    let _e1744 = phi_5259_;
                                    if (_e1740 > _e1744) {
                                        phi_5264_ = _e1740;
                                    } else {
                                        phi_5264_ = _e1744;
                                    }
                                    let _e1747 = phi_5264_;
                                    if (_e1724 > _e1747) {
                                        phi_5269_ = _e1724;
                                    } else {
                                        phi_5269_ = _e1747;
                                    }
                                    let _e1750 = phi_5269_;
                                    let _e1753 = local_12.member_1[0u];
                                    let _e1758 = local_12.member_1[1u];
                                    let _e1768 = (_e1753[0] + ((_e1758[0] - _e1753[0]) * _e1563));
                                    let _e1769 = (_e1753[1] + ((_e1758[1] - _e1753[1]) * _e1563));
                                    let _e1770 = (_e1753[2] + ((_e1758[2] - _e1753[2]) * _e1563));
                                    let _e1772 = local_12.member_1[1u];
                                    let _e1777 = local_12.member_1[0u];
                                    let _e1781 = (_e1772[0] - _e1777[0]);
                                    let _e1782 = (_e1772[1] - _e1777[1]);
                                    let _e1783 = (_e1772[2] - _e1777[2]);
                                    if (_e1781 < 0.0lf) {
                                        phi_5328_ = -(_e1781);
                                    } else {
                                        phi_5328_ = _e1781;
                                    }
                                    let _e1787 = phi_5328_;
                                    if (_e1782 < 0.0lf) {
                                        phi_5334_ = -(_e1782);
                                    } else {
                                        phi_5334_ = _e1782;
                                    }
                                    let _e1791 = phi_5334_;
                                    if (_e1787 > _e1791) {
                                        phi_5339_ = _e1787;
                                    } else {
                                        phi_5339_ = _e1791;
                                    }
                                    let _e1794 = phi_5339_;
                                    if (_e1783 < 0.0lf) {
                                        phi_5345_ = -(_e1783);
                                    } else {
                                        phi_5345_ = _e1783;
                                    }
                                    let _e1798 = phi_5345_;
                                    if (_e1794 > _e1798) {
                                        phi_5350_ = _e1794;
                                    } else {
                                        phi_5350_ = _e1798;
                                    }
                                    let _e1801 = phi_5350_;
                                    let _e1809 = ((((_e1566 * _e1801) * f64(1.01f)) + ((_e1750 + _e1701) * (1.1102230246251565e-16lf * f64(8f)))) + _e1701);
                                    if (_e1768 < 0.0lf) {
                                        phi_5364_ = -(_e1768);
                                    } else {
                                        phi_5364_ = _e1768;
                                    }
                                    let _e1813 = phi_5364_;
                                    if (_e1769 < 0.0lf) {
                                        phi_5370_ = -(_e1769);
                                    } else {
                                        phi_5370_ = _e1769;
                                    }
                                    let _e1817 = phi_5370_;
                                    if (_e1813 > _e1817) {
                                        phi_5375_ = _e1813;
                                    } else {
                                        phi_5375_ = _e1817;
                                    }
                                    let _e1820 = phi_5375_;
                                    if (_e1770 < 0.0lf) {
                                        phi_5381_ = -(_e1770);
                                    } else {
                                        phi_5381_ = _e1770;
                                    }
                                    let _e1824 = phi_5381_;
                                    if (_e1820 > _e1824) {
                                        phi_5386_ = _e1820;
                                    } else {
                                        phi_5386_ = _e1824;
                                    }
                                    let _e1827 = phi_5386_;
                                    local_3 = type_35(array<f64, 3>(_e1768, _e1769, _e1770), _e1809, (_e1827 + _e1809));
                                    let _e1833 = local_12.member_3;
                                    let _e1835 = local_12.member_2[0u];
                                    if (_e1835[0] < 0.0lf) {
                                        phi_5412_ = -(_e1835[0]);
                                    } else {
                                        phi_5412_ = _e1835[0];
                                    }
                                    let _e1842 = phi_5412_;
                                    if (_e1835[1] < 0.0lf) {
                                        phi_5419_ = -(_e1835[1]);
                                    } else {
                                        phi_5419_ = _e1835[1];
                                    }
                                    let _e1846 = phi_5419_;
                                    if (_e1842 > _e1846) {
                                        phi_5424_ = _e1842;
                                    } else {
                                        phi_5424_ = _e1846;
                                    }
                                    let _e1849 = phi_5424_;
                                    if (_e1835[2] < 0.0lf) {
                                        phi_5431_ = -(_e1835[2]);
                                    } else {
                                        phi_5431_ = _e1835[2];
                                    }
                                    let _e1853 = phi_5431_;
                                    if (_e1849 > _e1853) {
                                        phi_5436_ = _e1849;
                                    } else {
                                        phi_5436_ = _e1853;
                                    }
                                    let _e1856 = phi_5436_;
                                    let _e1858 = local_12.member_2[1u];
                                    if (_e1858[0] < 0.0lf) {
                                        phi_5449_ = -(_e1858[0]);
                                    } else {
                                        phi_5449_ = _e1858[0];
                                    }
                                    let _e1865 = phi_5449_;
                                    if (_e1858[1] < 0.0lf) {
                                        phi_5456_ = -(_e1858[1]);
                                    } else {
                                        phi_5456_ = _e1858[1];
                                    }
                                    let _e1869 = phi_5456_;
                                    if (_e1865 > _e1869) {
                                        phi_5461_ = _e1865;
                                    } else {
                                        phi_5461_ = _e1869;
                                    }
                                    let _e1872 = phi_5461_;
                                    if (_e1858[2] < 0.0lf) {
                                        phi_5468_ = -(_e1858[2]);
                                    } else {
                                        phi_5468_ = _e1858[2];
                                    }
                                    let _e1876 = phi_5468_;
                                    if (_e1872 > _e1876) {
                                        phi_5473_ = _e1872;
                                    } else {
                                        phi_5473_ = _e1876;
                                    }
                                    let _e1879 = phi_5473_;
                                    if (_e1856 > _e1879) {
                                        phi_5478_ = _e1856;
                                    } else {
                                        phi_5478_ = _e1879;
                                    }
                                    let _e1882 = phi_5478_;
                                    let _e1885 = local_12.member_2[0u];
                                    let _e1890 = local_12.member_2[1u];
                                    let _e1900 = (_e1885[0] + ((_e1890[0] - _e1885[0]) * _e1563));
                                    let _e1901 = (_e1885[1] + ((_e1890[1] - _e1885[1]) * _e1563));
                                    let _e1902 = (_e1885[2] + ((_e1890[2] - _e1885[2]) * _e1563));
                                    let _e1904 = local_12.member_2[1u];
                                    let _e1909 = local_12.member_2[0u];
                                    let _e1913 = (_e1904[0] - _e1909[0]);
                                    let _e1914 = (_e1904[1] - _e1909[1]);
                                    let _e1915 = (_e1904[2] - _e1909[2]);
                                    if (_e1913 < 0.0lf) {
                                        phi_5537_ = -(_e1913);
                                    } else {
                                        phi_5537_ = _e1913;
                                    }
                                    let _e1919 = phi_5537_;
                                    if (_e1914 < 0.0lf) {
                                        phi_5543_ = -(_e1914);
                                    } else {
                                        phi_5543_ = _e1914;
                                    }
                                    let _e1923 = phi_5543_;
                                    if (_e1919 > _e1923) {
                                        phi_5548_ = _e1919;
                                    } else {
                                        phi_5548_ = _e1923;
                                    }
                                    let _e1926 = phi_5548_;
                                    if (_e1915 < 0.0lf) {
                                        phi_5554_ = -(_e1915);
                                    } else {
                                        phi_5554_ = _e1915;
                                    }
                                    let _e1930 = phi_5554_;
                                    if (_e1926 > _e1930) {
                                        phi_5559_ = _e1926;
                                    } else {
                                        phi_5559_ = _e1930;
                                    }
                                    let _e1933 = phi_5559_;
                                    let _e1941 = ((((_e1566 * _e1933) * f64(1.01f)) + ((_e1882 + _e1833) * (1.1102230246251565e-16lf * f64(8f)))) + _e1833);
                                    if (_e1900 < 0.0lf) {
                                        phi_5573_ = -(_e1900);
                                    } else {
                                        phi_5573_ = _e1900;
                                    }
                                    let _e1945 = phi_5573_;
                                    if (_e1901 < 0.0lf) {
                                        phi_5579_ = -(_e1901);
                                    } else {
                                        phi_5579_ = _e1901;
                                    }
                                    let _e1949 = phi_5579_;
                                    if (_e1945 > _e1949) {
                                        phi_5584_ = _e1945;
                                    } else {
                                        phi_5584_ = _e1949;
                                    }
                                    let _e1952 = phi_5584_;
                                    if (_e1902 < 0.0lf) {
                                        phi_5590_ = -(_e1902);
                                    } else {
                                        phi_5590_ = _e1902;
                                    }
                                    let _e1956 = phi_5590_;
                                    if (_e1952 > _e1956) {
                                        phi_5595_ = _e1952;
                                    } else {
                                        phi_5595_ = _e1956;
                                    }
                                    let _e1959 = phi_5595_;
                                    local_4 = type_35(array<f64, 3>(_e1900, _e1901, _e1902), _e1941, (_e1959 + _e1941));
                                    let _e1964 = local_3.member;
                                    let _e1969 = local_4.member;
                                    let _e1975 = ((_e1964[1] * _e1969[2]) - (_e1964[2] * _e1969[1]));
                                    let _e1978 = ((_e1964[2] * _e1969[0]) - (_e1964[0] * _e1969[2]));
                                    let _e1981 = ((_e1964[0] * _e1969[1]) - (_e1964[1] * _e1969[0]));
                                    if (_e1975 < 0.0lf) {
                                        phi_5644_ = -(_e1975);
                                    } else {
                                        phi_5644_ = _e1975;
                                    }
                                    let _e1985 = phi_5644_;
                                    if (_e1978 < 0.0lf) {
                                        phi_5650_ = -(_e1978);
                                    } else {
                                        phi_5650_ = _e1978;
                                    }
                                    let _e1989 = phi_5650_;
                                    if (_e1985 > _e1989) {
                                        if (_e1975 < 0.0lf) {
                                            phi_5660_ = -(_e1975);
                                        } else {
                                            phi_5660_ = _e1975;
                                        }
                                        let _e2007 = phi_5660_;
                                        if (_e1981 < 0.0lf) {
                                            phi_5666_ = -(_e1981);
                                        } else {
                                            phi_5666_ = _e1981;
                                        }
                                        let _e2011 = phi_5666_;
                                        if (_e2007 > _e2011) {
                                            phi_5671_ = 2u;
                                            phi_5672_ = 1u;
                                        } else {
                                            phi_5671_ = 1u;
                                            phi_5672_ = 0u;
                                        }
                                        let _e2014 = phi_5671_;
                                        let _e2016 = phi_5672_;
                                        phi_5691_ = _e2014;
                                        phi_5692_ = _e2016;
                                    } else {
                                        if (_e1978 < 0.0lf) {
                                            phi_5678_ = -(_e1978);
                                        } else {
                                            phi_5678_ = _e1978;
                                        }
                                        let _e1994 = phi_5678_;
                                        if (_e1981 < 0.0lf) {
                                            phi_5684_ = -(_e1981);
                                        } else {
                                            phi_5684_ = _e1981;
                                        }
                                        let _e1998 = phi_5684_;
                                        if (_e1994 > _e1998) {
                                            phi_5689_ = 0u;
                                            phi_5690_ = 2u;
                                        } else {
                                            phi_5689_ = 1u;
                                            phi_5690_ = 0u;
                                        }
                                        let _e2001 = phi_5689_;
                                        let _e2003 = phi_5690_;
                                        phi_5691_ = _e2001;
                                        phi_5692_ = _e2003;
                                    }
                                    let _e2018 = phi_5691_;
                                    let _e2020 = phi_5692_;
                                    let _e2023 = local_3.member[_e2020];
                                    let _e2026 = local_4.member[_e2018];
                                    let _e2030 = local_3.member[_e2018];
                                    let _e2033 = local_4.member[_e2020];
                                    let _e2035 = ((_e2023 * _e2026) - (_e2030 * _e2033));
                                    let _e2036 = f64(1f);
                                    let _e2037 = f64(2f);
                                    let _e2039 = local_3.member_1;
                                    let _e2041 = local_4.member_2;
                                    let _e2044 = local_3.member_2;
                                    let _e2046 = local_4.member_1;
                                    let _e2052 = local_3.member_2;
                                    let _e2055 = local_4.member_2;
                                    let _e2064 = local_3.member_2;
                                    let _e2067 = local_4.member_2;
                                    let _e2071 = (((((_e2039 * _e2041) + (_e2044 * _e2046)) * f64(2.01f)) + (((_e2052 * _e2037) * (_e2055 * _e2037)) * (1.1102230246251565e-16lf * _e2037))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2036 + _e2064) * (_e2036 + _e2067))));
                                    if (_e2035 < 0.0lf) {
                                        phi_5765_ = -(_e2035);
                                    } else {
                                        phi_5765_ = _e2035;
                                    }
                                    let _e2075 = phi_5765_;
                                    if (_e2075 > _e2071) {
                                        if (_e2035 < f64(0f)) {
                                            phi_5777_ = f64(-1f);
                                        } else {
                                            phi_5777_ = f64(1f);
                                        }
                                        let _e2082 = phi_5777_;
                                        let _e2085 = local_2.member[_e2020];
                                        let _e2088 = local_4.member[_e2018];
                                        let _e2092 = local_2.member[_e2018];
                                        let _e2095 = local_4.member[_e2020];
                                        let _e2098 = f64(1f);
                                        let _e2099 = f64(2f);
                                        let _e2101 = local_2.member_1;
                                        let _e2103 = local_4.member_2;
                                        let _e2106 = local_2.member_2;
                                        let _e2108 = local_4.member_1;
                                        let _e2114 = local_2.member_2;
                                        let _e2117 = local_4.member_2;
                                        let _e2126 = local_2.member_2;
                                        let _e2129 = local_4.member_2;
                                        let _e2133 = (((((_e2101 * _e2103) + (_e2106 * _e2108)) * f64(2.01f)) + (((_e2114 * _e2099) * (_e2117 * _e2099)) * (1.1102230246251565e-16lf * _e2099))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2098 + _e2126) * (_e2098 + _e2129))));
                                        let _e2136 = local_3.member[_e2020];
                                        let _e2139 = local_2.member[_e2018];
                                        let _e2143 = local_3.member[_e2018];
                                        let _e2146 = local_2.member[_e2020];
                                        let _e2149 = f64(1f);
                                        let _e2150 = f64(2f);
                                        let _e2152 = local_3.member_1;
                                        let _e2154 = local_2.member_2;
                                        let _e2157 = local_3.member_2;
                                        let _e2159 = local_2.member_1;
                                        let _e2165 = local_3.member_2;
                                        let _e2168 = local_2.member_2;
                                        let _e2177 = local_3.member_2;
                                        let _e2180 = local_2.member_2;
                                        let _e2184 = (((((_e2152 * _e2154) + (_e2157 * _e2159)) * f64(2.01f)) + (((_e2165 * _e2150) * (_e2168 * _e2150)) * (1.1102230246251565e-16lf * _e2150))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e2149 + _e2177) * (_e2149 + _e2180))));
                                        let _e2185 = (_e2035 * _e2082);
                                        let _e2186 = (((_e2085 * _e2088) - (_e2092 * _e2095)) * _e2082);
                                        let _e2187 = (((_e2136 * _e2139) - (_e2143 * _e2146)) * _e2082);
                                        if (_e2185 < 0.0lf) {
                                            phi_5920_ = -(_e2185);
                                        } else {
                                            phi_5920_ = _e2185;
                                        }
                                        let _e2191 = phi_5920_;
                                        if (_e2186 < 0.0lf) {
                                            phi_5926_ = -(_e2186);
                                        } else {
                                            phi_5926_ = _e2186;
                                        }
                                        let _e2195 = phi_5926_;
                                        if (_e2187 < 0.0lf) {
                                            phi_5933_ = -(_e2187);
                                        } else {
                                            phi_5933_ = _e2187;
                                        }
                                        let _e2200 = phi_5933_;
                                        let _e2204 = (((_e2191 + _e2195) + _e2200) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_5[0u].member = _e2186;
                                        local_5[0u].member_1 = _e2133;
                                        local_5[1u].member = _e2187;
                                        local_5[1u].member_1 = _e2184;
                                        local_5[2u].member = (_e2185 - _e2186);
                                        local_5[2u].member_1 = ((_e2071 + _e2133) + _e2204);
                                        local_5[3u].member = (_e2185 - _e2187);
                                        local_5[3u].member_1 = ((_e2071 + _e2184) + _e2204);
                                        phi_5977_ = type_9(0u, 4u);
                                        phi_5980_ = true;
                                        loop {
                                            let _e2225 = phi_5977_;
                                            let _e2227 = phi_5980_;
                                            local_17 = _e2227;
                                            if (_e2225.member < _e2225.member_1) {
                                                phi_5978_ = type_9((_e2225.member + 1u), _e2225.member_1);
                                                phi_6003_ = type_9(1u, _e2225.member);
                                            } else {
                                                phi_5978_ = _e2225;
                                                phi_6003_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2239 = phi_5978_;
                                            let _e2241 = phi_6003_;
                                            if (bitcast<i32>(_e2241.member) != 0i) {
                                                let _e2248 = local_5[_e2241.member_1].member;
                                                let _e2251 = local_5[_e2241.member_1].member_1;
                                                let _e2253 = (_e2248 < -(_e2251));
                                                if _e2253 {
                                                    phi_6030_ = bool();
                                                    phi_6031_ = false;
                                                } else {
                                                    phi_6030_ = (_e2227 && (_e2248 > _e2251));
                                                    phi_6031_ = true;
                                                }
                                                let _e2257 = phi_6030_;
                                                let _e2259 = phi_6031_;
                                                phi_5981_ = _e2257;
                                                phi_6032_ = _e2259;
                                                phi_6033_ = _e2253;
                                            } else {
                                                phi_5981_ = bool();
                                                phi_6032_ = false;
                                                phi_6033_ = false;
                                            }
                                            let _e2261 = phi_5981_;
                                            let _e2263 = phi_6032_;
                                            let _e2265 = phi_6033_;
                                            local_16 = _e2265;
                                            continue;
                                            continuing {
                                                phi_5977_ = _e2239;
                                                phi_5980_ = _e2261;
                                                break if !(_e2263);
                                            }
                                        }
                                        let _e2268 = local_16;
                                        if _e2268 {
                                            phi_6037_ = false;
                                        } else {
                                            phi_6037_ = true;
                                        }
                                        let _e2270 = phi_6037_;
                                        if _e2270 {
                                            let _e2272 = local_17;
                                            if _e2272 {
                                                phi_6044_ = 1u;
                                            } else {
                                                phi_6044_ = 2u;
                                            }
                                            let _e2274 = phi_6044_;
                                            phi_6045_ = _e2274;
                                            phi_6046_ = false;
                                        } else {
                                            phi_6045_ = u32();
                                            phi_6046_ = true;
                                        }
                                        let _e2276 = phi_6045_;
                                        let _e2278 = phi_6046_;
                                        phi_6047_ = _e2276;
                                        phi_6048_ = 0u;
                                        phi_6049_ = _e2278;
                                    } else {
                                        phi_6047_ = u32();
                                        phi_6048_ = 2u;
                                        phi_6049_ = true;
                                    }
                                    let _e2280 = phi_6047_;
                                    let _e2282 = phi_6048_;
                                    let _e2284 = phi_6049_;
                                    if _e2284 {
                                        phi_6053_ = _e2282;
                                    } else {
                                        phi_6053_ = _e2280;
                                    }
                                    let _e2286 = phi_6053_;
                                    let _e2287 = (_e2286 == 0u);
                                    if _e2287 {
                                        phi_8222_ = f64();
                                        phi_8223_ = false;
                                        phi_8224_ = false;
                                        phi_8225_ = false;
                                    } else {
                                        if (_e2286 == 1u) {
                                            if _e1554.member_2 {
                                                if ((_e1554.member_1 - _e1554.member) <= f64(0.0000005f)) {
                                                    phi_6074_ = false;
                                                } else {
                                                    phi_6074_ = true;
                                                }
                                                let _e2296 = phi_6074_;
                                                phi_6075_ = _e2296;
                                            } else {
                                                phi_6075_ = true;
                                            }
                                            let _e2298 = phi_6075_;
                                            phi_6076_ = _e2298;
                                        } else {
                                            phi_6076_ = true;
                                        }
                                        let _e2300 = phi_6076_;
                                        if _e2300 {
                                            let _e2306 = local_12.member[0u];
                                            let _e2312 = local_12.member_1[0u];
                                            let _e2318 = local_12.member_2[0u];
                                            let _e2322 = (_e2306[0] - _e2312[0]);
                                            let _e2323 = (_e2306[1] - _e2312[1]);
                                            let _e2324 = (_e2306[2] - _e2312[2]);
                                            let _e2333 = local_12.member[1u];
                                            let _e2339 = local_12.member_1[1u];
                                            let _e2345 = local_12.member_2[1u];
                                            let _e2349 = (_e2333[0] - _e2339[0]);
                                            let _e2350 = (_e2333[1] - _e2339[1]);
                                            let _e2351 = (_e2333[2] - _e2339[2]);
                                            let _e2360 = local_12.member[0u];
                                            if (_e2360[0] < 0.0lf) {
                                                phi_6225_ = -(_e2360[0]);
                                            } else {
                                                phi_6225_ = _e2360[0];
                                            }
                                            let _e2367 = phi_6225_;
                                            if (_e2360[1] < 0.0lf) {
                                                phi_6232_ = -(_e2360[1]);
                                            } else {
                                                phi_6232_ = _e2360[1];
                                            }
                                            let _e2371 = phi_6232_;
                                            if (_e2367 > _e2371) {
                                                phi_6237_ = _e2367;
                                            } else {
                                                phi_6237_ = _e2371;
                                            }
                                            let _e2374 = phi_6237_;
                                            if (_e2360[2] < 0.0lf) {
                                                phi_6244_ = -(_e2360[2]);
                                            } else {
                                                phi_6244_ = _e2360[2];
                                            }
                                            let _e2378 = phi_6244_;
                                            if (_e2374 > _e2378) {
                                                phi_6249_ = _e2374;
                                            } else {
                                                phi_6249_ = _e2378;
                                            }
                                            let _e2381 = phi_6249_;
                                            let _e2384 = local_12.member[1u];
                                            if (_e2384[0] < 0.0lf) {
                                                phi_6262_ = -(_e2384[0]);
                                            } else {
                                                phi_6262_ = _e2384[0];
                                            }
                                            let _e2391 = phi_6262_;
                                            if (_e2384[1] < 0.0lf) {
                                                phi_6269_ = -(_e2384[1]);
                                            } else {
                                                phi_6269_ = _e2384[1];
                                            }
                                            let _e2395 = phi_6269_;
                                            if (_e2391 > _e2395) {
                                                phi_6274_ = _e2391;
                                            } else {
                                                phi_6274_ = _e2395;
                                            }
                                            let _e2398 = phi_6274_;
                                            if (_e2384[2] < 0.0lf) {
                                                phi_6281_ = -(_e2384[2]);
                                            } else {
                                                phi_6281_ = _e2384[2];
                                            }
                                            let _e2402 = phi_6281_;
                                            if (_e2398 > _e2402) {
                                                phi_6286_ = _e2398;
                                            } else {
                                                phi_6286_ = _e2402;
                                            }
                                            let _e2405 = phi_6286_;
                                            if (_e2381 > _e2405) {
                                                phi_6291_ = _e2381;
                                            } else {
                                                phi_6291_ = _e2405;
                                            }
                                            let _e2408 = phi_6291_;
                                            let _e2410 = local_12.member_3;
                                            let _e2414 = local_12.member_1[0u];
                                            if (_e2414[0] < 0.0lf) {
                                                phi_6308_ = -(_e2414[0]);
                                            } else {
                                                phi_6308_ = _e2414[0];
                                            }
                                            let _e2421 = phi_6308_;
                                            if (_e2414[1] < 0.0lf) {
                                                phi_6315_ = -(_e2414[1]);
                                            } else {
                                                phi_6315_ = _e2414[1];
                                            }
                                            let _e2425 = phi_6315_;
                                            if (_e2421 > _e2425) {
                                                phi_6320_ = _e2421;
                                            } else {
                                                phi_6320_ = _e2425;
                                            }
                                            let _e2428 = phi_6320_;
                                            if (_e2414[2] < 0.0lf) {
                                                phi_6327_ = -(_e2414[2]);
                                            } else {
                                                phi_6327_ = _e2414[2];
                                            }
                                            let _e2432 = phi_6327_;
                                            if (_e2428 > _e2432) {
                                                phi_6332_ = _e2428;
                                            } else {
                                                phi_6332_ = _e2432;
                                            }
                                            let _e2435 = phi_6332_;
                                            let _e2438 = local_12.member_1[1u];
                                            if (_e2438[0] < 0.0lf) {
                                                phi_6346_ = -(_e2438[0]);
                                            } else {
                                                phi_6346_ = _e2438[0];
                                            }
                                            let _e2445 = phi_6346_;
                                            if (_e2438[1] < 0.0lf) {
                                                phi_6353_ = -(_e2438[1]);
                                            } else {
                                                phi_6353_ = _e2438[1];
                                            }
                                            let _e2449 = phi_6353_;
                                            if (_e2445 > _e2449) {
                                                phi_6358_ = _e2445;
                                            } else {
                                                phi_6358_ = _e2449;
                                            }
                                            let _e2452 = phi_6358_;
                                            if (_e2438[2] < 0.0lf) {
                                                phi_6365_ = -(_e2438[2]);
                                            } else {
                                                phi_6365_ = _e2438[2];
                                            }
                                            let _e2456 = phi_6365_;
                                            if (_e2452 > _e2456) {
                                                phi_6370_ = _e2452;
                                            } else {
                                                phi_6370_ = _e2456;
                                            }
                                            let _e2459 = phi_6370_;
                                            if (_e2435 > _e2459) {
                                                phi_6375_ = _e2435;
                                            } else {
                                                phi_6375_ = _e2459;
                                            }
                                            let _e2462 = phi_6375_;
                                            let _e2464 = local_12.member_3;
                                            let _e2468 = local_12.member_2[0u];
                                            if (_e2468[0] < 0.0lf) {
                                                phi_6392_ = -(_e2468[0]);
                                            } else {
                                                phi_6392_ = _e2468[0];
                                            }
                                            let _e2475 = phi_6392_;
                                            if (_e2468[1] < 0.0lf) {
                                                phi_6399_ = -(_e2468[1]);
                                            } else {
                                                phi_6399_ = _e2468[1];
                                            }
                                            let _e2479 = phi_6399_;
                                            if (_e2475 > _e2479) {
                                                phi_6404_ = _e2475;
                                            } else {
                                                phi_6404_ = _e2479;
                                            }
                                            let _e2482 = phi_6404_;
                                            if (_e2468[2] < 0.0lf) {
                                                phi_6411_ = -(_e2468[2]);
                                            } else {
                                                phi_6411_ = _e2468[2];
                                            }
                                            let _e2486 = phi_6411_;
                                            if (_e2482 > _e2486) {
                                                phi_6416_ = _e2482;
                                            } else {
                                                phi_6416_ = _e2486;
                                            }
                                            let _e2489 = phi_6416_;
                                            let _e2492 = local_12.member_2[1u];
                                            if (_e2492[0] < 0.0lf) {
                                                phi_6430_ = -(_e2492[0]);
                                            } else {
                                                phi_6430_ = _e2492[0];
                                            }
                                            let _e2499 = phi_6430_;
                                            if (_e2492[1] < 0.0lf) {
                                                phi_6437_ = -(_e2492[1]);
                                            } else {
                                                phi_6437_ = _e2492[1];
                                            }
                                            let _e2503 = phi_6437_;
                                            if (_e2499 > _e2503) {
                                                phi_6442_ = _e2499;
                                            } else {
                                                phi_6442_ = _e2503;
                                            }
                                            let _e2506 = phi_6442_;
                                            if (_e2492[2] < 0.0lf) {
                                                phi_6449_ = -(_e2492[2]);
                                            } else {
                                                phi_6449_ = _e2492[2];
                                            }
                                            let _e2510 = phi_6449_;
                                            if (_e2506 > _e2510) {
                                                phi_6454_ = _e2506;
                                            } else {
                                                phi_6454_ = _e2510;
                                            }
                                            let _e2513 = phi_6454_;
                                            if (_e2489 > _e2513) {
                                                phi_6459_ = _e2489;
                                            } else {
                                                phi_6459_ = _e2513;
                                            }
                                            let _e2516 = phi_6459_;
                                            let _e2518 = local_12.member_3;
                                            let _e2526 = local_12.member_3;
                                            let _e2533 = f64(0f);
                                            let _e2534 = f64(1f);
                                            local = type_34(array<f64, 4>(_e2533, _e2533, _e2533, _e2533), array<f64, 4>(_e2533, _e2533, _e2533, _e2533), array<f64, 4>(_e2534, _e2534, _e2534, _e2534));
                                            phi_6503_ = type_9(0u, 96u);
                                            phi_6506_ = _e1554.member;
                                            phi_6508_ = _e1554.member;
                                            phi_6510_ = _e1554.member;
                                            loop {
                                                let _e2540 = phi_6503_;
                                                let _e2542 = phi_6506_;
                                                let _e2544 = phi_6508_;
                                                let _e2546 = phi_6510_;
                                                local_36 = _e2544;
                                                local_20 = _e2542;
                                                if (_e2540.member < _e2540.member_1) {
                                                    phi_6504_ = type_9((_e2540.member + 1u), _e2540.member_1);
                                                    phi_6533_ = type_9(1u, _e2540.member);
                                                } else {
                                                    phi_6504_ = _e2540;
                                                    phi_6533_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2558 = phi_6504_;
                                                let _e2560 = phi_6533_;
                                                if (bitcast<i32>(_e2560.member) != 0i) {
                                                    let _e2567 = local_12.member[0u];
                                                    let _e2573 = local_12.member[1u];
                                                    let _e2589 = local_12.member_1[0u];
                                                    let _e2595 = local_12.member_1[1u];
                                                    let _e2611 = local_12.member_2[0u];
                                                    let _e2617 = local_12.member_2[1u];
                                                    let _e2631 = function_2(array<f64, 3>((_e2567[0] + ((_e2573[0] - _e2567[0]) * _e2542)), (_e2567[1] + ((_e2573[1] - _e2567[1]) * _e2542)), (_e2567[2] + ((_e2573[2] - _e2567[2]) * _e2542))), array<f64, 3>((_e2589[0] + ((_e2595[0] - _e2589[0]) * _e2542)), (_e2589[1] + ((_e2595[1] - _e2589[1]) * _e2542)), (_e2589[2] + ((_e2595[2] - _e2589[2]) * _e2542))), array<f64, 3>((_e2611[0] + ((_e2617[0] - _e2611[0]) * _e2542)), (_e2611[1] + ((_e2617[1] - _e2611[1]) * _e2542)), (_e2611[2] + ((_e2617[2] - _e2611[2]) * _e2542))), 1u);
                                                    if (_e2631[0] < 0.0lf) {
                                                        phi_6645_ = -(_e2631[0]);
                                                    } else {
                                                        phi_6645_ = _e2631[0];
                                                    }
                                                    let _e2636 = phi_6645_;
                                                    if (_e2631[1] < 0.0lf) {
                                                        phi_6652_ = -(_e2631[1]);
                                                    } else {
                                                        phi_6652_ = _e2631[1];
                                                    }
                                                    let _e2641 = phi_6652_;
                                                    if (_e2631[2] < 0.0lf) {
                                                        phi_6660_ = -(_e2631[2]);
                                                    } else {
                                                        phi_6660_ = _e2631[2];
                                                    }
                                                    let _e2647 = phi_6660_;
                                                    let _e2648 = ((_e2636 + _e2641) + _e2647);
                                                    if (_e2648 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2648) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2655 = (f64(1f) / _e2648);
                                                            let _e2657 = (_e2631[0] * _e2655);
                                                            let _e2659 = (_e2631[1] * _e2655);
                                                            let _e2661 = (_e2631[2] * _e2655);
                                                            let _e2666 = (((_e2657 * _e2657) + (_e2659 * _e2659)) + (_e2661 * _e2661));
                                                            if (_e2666 <= 2.2250738585072014e-308lf) {
                                                                if (_e2666 > 0.0lf) {
                                                                    phi_6699_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6699_ = 0.0lf;
                                                                }
                                                                let _e2718 = phi_6699_;
                                                                phi_6763_ = _e2718;
                                                            } else {
                                                                phi_6706_ = type_16(0i, 5i);
                                                                phi_6709_ = bitcast<f64>(((bitcast<u64>(_e2666) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2673 = phi_6706_;
                                                                    let _e2675 = phi_6709_;
                                                                    local_18 = _e2675;
                                                                    if (_e2673.member < _e2673.member_1) {
                                                                        let _e2682 = (_e2673.member + 1i);
                                                                        if ((false == (_e2682 > _e2673.member)) != false) {
                                                                            phi_6730_ = true;
                                                                        } else {
                                                                            phi_6730_ = false;
                                                                        }
                                                                        let _e2687 = phi_6730_;
                                                                        if _e2687 {
                                                                            phi_6736_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_6736_ = type_17(1u, _e2682);
                                                                        }
                                                                        let _e2692 = phi_6736_;
                                                                        phi_6707_ = type_16(_e2692.member_1, _e2673.member_1);
                                                                        phi_6750_ = type_17(1u, _e2673.member);
                                                                    } else {
                                                                        phi_6707_ = _e2673;
                                                                        phi_6750_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2698 = phi_6707_;
                                                                    let _e2700 = phi_6750_;
                                                                    let _e2703 = (bitcast<i32>(_e2700.member) != 0i);
                                                                    if _e2703 {
                                                                        phi_6710_ = (0.5lf * (_e2675 + (_e2666 / _e2675)));
                                                                    } else {
                                                                        phi_6710_ = f64();
                                                                    }
                                                                    let _e2708 = phi_6710_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6706_ = _e2698;
                                                                        phi_6709_ = _e2708;
                                                                        break if !(_e2703);
                                                                    }
                                                                }
                                                                let _e2713 = local_18;
                                                                phi_6763_ = (_e2713 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2720 = phi_6763_;
                                                            let _e2722 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2729 = ((((((((_e2408 + _e2410) + (_e2462 + _e2464)) + (_e2516 + _e2518)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2526 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2720) * (f64(1f) + _e2722)));
                                                            let _e2734 = (((_e2657 * _e2306[0]) + (_e2659 * _e2306[1])) + (_e2661 * _e2306[2]));
                                                            let _e2739 = (((_e2657 * _e2322) + (_e2659 * _e2323)) + (_e2661 * _e2324));
                                                            let _e2744 = (((_e2657 * (_e2306[0] - _e2318[0])) + (_e2659 * (_e2306[1] - _e2318[1]))) + (_e2661 * (_e2306[2] - _e2318[2])));
                                                            let _e2749 = (((_e2657 * (_e2322 - _e2318[0])) + (_e2659 * (_e2323 - _e2318[1]))) + (_e2661 * (_e2324 - _e2318[2])));
                                                            let _e2755 = (((_e2657 * _e2333[0]) + (_e2659 * _e2333[1])) + (_e2661 * _e2333[2]));
                                                            let _e2760 = (((_e2657 * _e2349) + (_e2659 * _e2350)) + (_e2661 * _e2351));
                                                            let _e2765 = (((_e2657 * (_e2333[0] - _e2345[0])) + (_e2659 * (_e2333[1] - _e2345[1]))) + (_e2661 * (_e2333[2] - _e2345[2])));
                                                            let _e2770 = (((_e2657 * (_e2349 - _e2345[0])) + (_e2659 * (_e2350 - _e2345[1]))) + (_e2661 * (_e2351 - _e2345[2])));
                                                            if (_e2734 < 0.0lf) {
                                                                phi_6832_ = -(_e2734);
                                                            } else {
                                                                phi_6832_ = _e2734;
                                                            }
                                                            let _e2775 = phi_6832_;
                                                            if (_e2755 < 0.0lf) {
                                                                phi_6838_ = -(_e2755);
                                                            } else {
                                                                phi_6838_ = _e2755;
                                                            }
                                                            let _e2779 = phi_6838_;
                                                            if (_e2739 < 0.0lf) {
                                                                phi_6847_ = -(_e2739);
                                                            } else {
                                                                phi_6847_ = _e2739;
                                                            }
                                                            let _e2786 = phi_6847_;
                                                            if (_e2760 < 0.0lf) {
                                                                phi_6853_ = -(_e2760);
                                                            } else {
                                                                phi_6853_ = _e2760;
                                                            }
                                                            let _e2790 = phi_6853_;
                                                            if (_e2744 < 0.0lf) {
                                                                phi_6862_ = -(_e2744);
                                                            } else {
                                                                phi_6862_ = _e2744;
                                                            }
                                                            let _e2797 = phi_6862_;
                                                            if (_e2765 < 0.0lf) {
                                                                phi_6868_ = -(_e2765);
                                                            } else {
                                                                phi_6868_ = _e2765;
                                                            }
                                                            let _e2801 = phi_6868_;
                                                            if (_e2749 < 0.0lf) {
                                                                phi_6877_ = -(_e2749);
                                                            } else {
                                                                phi_6877_ = _e2749;
                                                            }
                                                            let _e2808 = phi_6877_;
                                                            if (_e2770 < 0.0lf) {
                                                                phi_6883_ = -(_e2770);
                                                            } else {
                                                                phi_6883_ = _e2770;
                                                            }
                                                            let _e2812 = phi_6883_;
                                                            phi_6889_ = type_34(array<f64, 4>(_e2734, _e2739, _e2744, _e2749), array<f64, 4>(_e2755, _e2760, _e2765, _e2770), array<f64, 4>((_e2729 + ((_e2775 + _e2779) * _e2722)), (_e2729 + ((_e2786 + _e2790) * _e2722)), (_e2729 + ((_e2797 + _e2801) * _e2722)), (_e2729 + ((_e2808 + _e2812) * _e2722))));
                                                            phi_6890_ = false;
                                                        } else {
                                                            phi_6889_ = type_34();
                                                            phi_6890_ = true;
                                                        }
                                                        let _e2819 = phi_6889_;
                                                        let _e2821 = phi_6890_;
                                                        phi_6891_ = _e2819;
                                                        phi_6892_ = _e2821;
                                                    } else {
                                                        phi_6891_ = type_34();
                                                        phi_6892_ = true;
                                                    }
                                                    let _e2823 = phi_6891_;
                                                    let _e2825 = phi_6892_;
                                                    if _e2825 {
                                                        let _e2826 = f64(0f);
                                                        let _e2827 = f64(1f);
                                                        phi_6902_ = type_34(array<f64, 4>(_e2826, _e2826, _e2826, _e2826), array<f64, 4>(_e2826, _e2826, _e2826, _e2826), array<f64, 4>(_e2827, _e2827, _e2827, _e2827));
                                                    } else {
                                                        phi_6902_ = _e2823;
                                                    }
                                                    let _e2833 = phi_6902_;
                                                    local_1 = type_34(array<f64, 4>(_e2833.member[0], _e2833.member[1], _e2833.member[2], _e2833.member[3]), array<f64, 4>(_e2833.member_1[0], _e2833.member_1[1], _e2833.member_1[2], _e2833.member_1[3]), array<f64, 4>(_e2833.member_2[0], _e2833.member_2[1], _e2833.member_2[2], _e2833.member_2[3]));
                                                    let _e2853 = (_e2542 - _e2546);
                                                    let _e2854 = f64(0f);
                                                    let _e2857 = local_1.member[0u];
                                                    let _e2860 = local_1.member_1[0u];
                                                    let _e2863 = local_1.member[0u];
                                                    let _e2869 = local_1.member_2[0u];
                                                    if (((_e2857 + ((_e2860 - _e2863) * _e2542)) - _e2869) > _e2854) {
                                                        let _e2874 = local_1.member[1u];
                                                        let _e2877 = local_1.member_1[1u];
                                                        let _e2880 = local_1.member[1u];
                                                        let _e2886 = local_1.member_2[1u];
                                                        if (((_e2874 + ((_e2877 - _e2880) * _e2542)) - _e2886) > _e2854) {
                                                            let _e2891 = local_1.member[2u];
                                                            let _e2894 = local_1.member_1[2u];
                                                            let _e2897 = local_1.member[2u];
                                                            let _e2903 = local_1.member_2[2u];
                                                            if (((_e2891 + ((_e2894 - _e2897) * _e2542)) - _e2903) > _e2854) {
                                                                let _e2908 = local_1.member[3u];
                                                                let _e2911 = local_1.member_1[3u];
                                                                let _e2914 = local_1.member[3u];
                                                                let _e2920 = local_1.member_2[3u];
                                                                phi_7073_ = (((_e2908 + ((_e2911 - _e2914) * _e2542)) - _e2920) > _e2854);
                                                                phi_7074_ = false;
                                                            } else {
                                                                phi_7073_ = bool();
                                                                phi_7074_ = true;
                                                            }
                                                            let _e2924 = phi_7073_;
                                                            let _e2926 = phi_7074_;
                                                            phi_7075_ = _e2924;
                                                            phi_7076_ = _e2926;
                                                        } else {
                                                            phi_7075_ = bool();
                                                            phi_7076_ = true;
                                                        }
                                                        let _e2928 = phi_7075_;
                                                        let _e2930 = phi_7076_;
                                                        phi_7077_ = _e2928;
                                                        phi_7078_ = _e2930;
                                                    } else {
                                                        phi_7077_ = bool();
                                                        phi_7078_ = true;
                                                    }
                                                    let _e2932 = phi_7077_;
                                                    let _e2934 = phi_7078_;
                                                    if _e2934 {
                                                        phi_7082_ = false;
                                                    } else {
                                                        phi_7082_ = _e2932;
                                                    }
                                                    let _e2936 = phi_7082_;
                                                    if _e2936 {
                                                        if (_e2542 <= _e2544) {
                                                            phi_7393_ = true;
                                                        } else {
                                                            let _e2938 = f64(0f);
                                                            let _e2941 = local.member[0u];
                                                            let _e2944 = local.member_1[0u];
                                                            let _e2947 = local.member[0u];
                                                            let _e2953 = local.member_2[0u];
                                                            let _e2957 = local_1.member[0u];
                                                            let _e2960 = local_1.member_1[0u];
                                                            let _e2963 = local_1.member[0u];
                                                            let _e2969 = local_1.member_2[0u];
                                                            if ((((_e2941 + ((_e2944 - _e2947) * _e2542)) - _e2953) + ((_e2957 + ((_e2960 - _e2963) * _e2546)) - _e2969)) > _e2938) {
                                                                let _e2975 = local.member[1u];
                                                                let _e2978 = local.member_1[1u];
                                                                let _e2981 = local.member[1u];
                                                                let _e2987 = local.member_2[1u];
                                                                let _e2991 = local_1.member[1u];
                                                                let _e2994 = local_1.member_1[1u];
                                                                let _e2997 = local_1.member[1u];
                                                                let _e3003 = local_1.member_2[1u];
                                                                if ((((_e2975 + ((_e2978 - _e2981) * _e2542)) - _e2987) + ((_e2991 + ((_e2994 - _e2997) * _e2546)) - _e3003)) > _e2938) {
                                                                    let _e3009 = local.member[2u];
                                                                    let _e3012 = local.member_1[2u];
                                                                    let _e3015 = local.member[2u];
                                                                    let _e3021 = local.member_2[2u];
                                                                    let _e3025 = local_1.member[2u];
                                                                    let _e3028 = local_1.member_1[2u];
                                                                    let _e3031 = local_1.member[2u];
                                                                    let _e3037 = local_1.member_2[2u];
                                                                    if ((((_e3009 + ((_e3012 - _e3015) * _e2542)) - _e3021) + ((_e3025 + ((_e3028 - _e3031) * _e2546)) - _e3037)) > _e2938) {
                                                                        let _e3043 = local.member[3u];
                                                                        let _e3046 = local.member_1[3u];
                                                                        let _e3049 = local.member[3u];
                                                                        let _e3055 = local.member_2[3u];
                                                                        let _e3059 = local_1.member[3u];
                                                                        let _e3062 = local_1.member_1[3u];
                                                                        let _e3065 = local_1.member[3u];
                                                                        let _e3071 = local_1.member_2[3u];
                                                                        phi_7380_ = ((((_e3043 + ((_e3046 - _e3049) * _e2542)) - _e3055) + ((_e3059 + ((_e3062 - _e3065) * _e2546)) - _e3071)) > _e2938);
                                                                        phi_7381_ = false;
                                                                    } else {
                                                                        phi_7380_ = bool();
                                                                        phi_7381_ = true;
                                                                    }
                                                                    let _e3076 = phi_7380_;
                                                                    let _e3078 = phi_7381_;
                                                                    phi_7382_ = _e3076;
                                                                    phi_7383_ = _e3078;
                                                                } else {
                                                                    phi_7382_ = bool();
                                                                    phi_7383_ = true;
                                                                }
                                                                let _e3080 = phi_7382_;
                                                                let _e3082 = phi_7383_;
                                                                phi_7384_ = _e3080;
                                                                phi_7385_ = _e3082;
                                                            } else {
                                                                phi_7384_ = bool();
                                                                phi_7385_ = true;
                                                            }
                                                            let _e3084 = phi_7384_;
                                                            let _e3086 = phi_7385_;
                                                            if _e3086 {
                                                                phi_7389_ = false;
                                                            } else {
                                                                phi_7389_ = _e3084;
                                                            }
                                                            let _e3088 = phi_7389_;
                                                            phi_7393_ = _e3088;
                                                        }
                                                        let _e3090 = phi_7393_;
                                                        if _e3090 {
                                                            if (_e2560.member_1 > 0u) {
                                                                if (_e2542 >= _e1554.member_1) {
                                                                    phi_7405_ = false;
                                                                } else {
                                                                    phi_7405_ = true;
                                                                }
                                                                let _e3094 = phi_7405_;
                                                                phi_7406_ = _e3094;
                                                            } else {
                                                                phi_7406_ = true;
                                                            }
                                                            let _e3096 = phi_7406_;
                                                            if _e3096 {
                                                                local = type_34(array<f64, 4>(_e2833.member[0], _e2833.member[1], _e2833.member[2], _e2833.member[3]), array<f64, 4>(_e2833.member_1[0], _e2833.member_1[1], _e2833.member_1[2], _e2833.member_1[3]), array<f64, 4>(_e2833.member_2[0], _e2833.member_2[1], _e2833.member_2[2], _e2833.member_2[3]));
                                                                let _e3118 = local.member[0u];
                                                                let _e3121 = local.member_1[0u];
                                                                let _e3124 = local.member_2[0u];
                                                                if (_e3118 > _e3124) {
                                                                    if (_e3121 > _e3124) {
                                                                        phi_7480_ = false;
                                                                    } else {
                                                                        phi_7480_ = true;
                                                                    }
                                                                    let _e3128 = phi_7480_;
                                                                    phi_7481_ = _e3128;
                                                                } else {
                                                                    phi_7481_ = true;
                                                                }
                                                                let _e3130 = phi_7481_;
                                                                if _e3130 {
                                                                    let _e3131 = (_e3121 >= _e3118);
                                                                    if _e3131 {
                                                                        phi_7506_ = f64();
                                                                        phi_7507_ = false;
                                                                    } else {
                                                                        if ((_e3118 - _e3121) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7504_ = (((_e3118 - _e3124) / (_e3118 - _e3121)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7505_ = false;
                                                                        } else {
                                                                            phi_7504_ = f64();
                                                                            phi_7505_ = true;
                                                                        }
                                                                        let _e3145 = phi_7504_;
                                                                        let _e3147 = phi_7505_;
                                                                        phi_7506_ = _e3145;
                                                                        phi_7507_ = _e3147;
                                                                    }
                                                                    let _e3149 = phi_7506_;
                                                                    let _e3151 = phi_7507_;
                                                                    phi_7508_ = _e3149;
                                                                    phi_7509_ = _e3131;
                                                                    phi_7510_ = _e3151;
                                                                } else {
                                                                    phi_7508_ = f64();
                                                                    phi_7509_ = true;
                                                                    phi_7510_ = false;
                                                                }
                                                                let _e3153 = phi_7508_;
                                                                let _e3155 = phi_7509_;
                                                                let _e3157 = phi_7510_;
                                                                if _e3155 {
                                                                    phi_7515_ = f64(2f);
                                                                    phi_7516_ = true;
                                                                } else {
                                                                    phi_7515_ = _e2542;
                                                                    phi_7516_ = _e3157;
                                                                }
                                                                let _e3160 = phi_7515_;
                                                                let _e3162 = phi_7516_;
                                                                if _e3162 {
                                                                    phi_7520_ = _e3160;
                                                                } else {
                                                                    phi_7520_ = _e3153;
                                                                }
                                                                let _e3164 = phi_7520_;
                                                                let _e3167 = local.member[1u];
                                                                let _e3170 = local.member_1[1u];
                                                                let _e3173 = local.member_2[1u];
                                                                if (_e3167 > _e3173) {
                                                                    if (_e3170 > _e3173) {
                                                                        phi_7552_ = false;
                                                                    } else {
                                                                        phi_7552_ = true;
                                                                    }
                                                                    let _e3177 = phi_7552_;
                                                                    phi_7553_ = _e3177;
                                                                } else {
                                                                    phi_7553_ = true;
                                                                }
                                                                let _e3179 = phi_7553_;
                                                                if _e3179 {
                                                                    let _e3180 = (_e3170 >= _e3167);
                                                                    if _e3180 {
                                                                        phi_7578_ = f64();
                                                                        phi_7579_ = false;
                                                                    } else {
                                                                        if ((_e3167 - _e3170) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7576_ = (((_e3167 - _e3173) / (_e3167 - _e3170)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7577_ = false;
                                                                        } else {
                                                                            phi_7576_ = f64();
                                                                            phi_7577_ = true;
                                                                        }
                                                                        let _e3194 = phi_7576_;
                                                                        let _e3196 = phi_7577_;
                                                                        phi_7578_ = _e3194;
                                                                        phi_7579_ = _e3196;
                                                                    }
                                                                    let _e3198 = phi_7578_;
                                                                    let _e3200 = phi_7579_;
                                                                    phi_7580_ = _e3198;
                                                                    phi_7581_ = _e3180;
                                                                    phi_7582_ = _e3200;
                                                                } else {
                                                                    phi_7580_ = f64();
                                                                    phi_7581_ = true;
                                                                    phi_7582_ = false;
                                                                }
                                                                let _e3202 = phi_7580_;
                                                                let _e3204 = phi_7581_;
                                                                let _e3206 = phi_7582_;
                                                                if _e3204 {
                                                                    phi_7587_ = f64(2f);
                                                                    phi_7588_ = true;
                                                                } else {
                                                                    phi_7587_ = _e2542;
                                                                    phi_7588_ = _e3206;
                                                                }
                                                                let _e3209 = phi_7587_;
                                                                let _e3211 = phi_7588_;
                                                                if _e3211 {
                                                                    phi_7592_ = _e3209;
                                                                } else {
                                                                    phi_7592_ = _e3202;
                                                                }
                                                                let _e3213 = phi_7592_;
                                                                if (_e3164 < _e3213) {
                                                                    phi_7597_ = _e3164;
                                                                } else {
                                                                    phi_7597_ = _e3213;
                                                                }
                                                                let _e3216 = phi_7597_;
                                                                let _e3219 = local.member[2u];
                                                                let _e3222 = local.member_1[2u];
                                                                let _e3225 = local.member_2[2u];
                                                                if (_e3219 > _e3225) {
                                                                    if (_e3222 > _e3225) {
                                                                        phi_7629_ = false;
                                                                    } else {
                                                                        phi_7629_ = true;
                                                                    }
                                                                    let _e3229 = phi_7629_;
                                                                    phi_7630_ = _e3229;
                                                                } else {
                                                                    phi_7630_ = true;
                                                                }
                                                                let _e3231 = phi_7630_;
                                                                if _e3231 {
                                                                    let _e3232 = (_e3222 >= _e3219);
                                                                    if _e3232 {
                                                                        phi_7655_ = f64();
                                                                        phi_7656_ = false;
                                                                    } else {
                                                                        if ((_e3219 - _e3222) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7653_ = (((_e3219 - _e3225) / (_e3219 - _e3222)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7654_ = false;
                                                                        } else {
                                                                            phi_7653_ = f64();
                                                                            phi_7654_ = true;
                                                                        }
                                                                        let _e3246 = phi_7653_;
                                                                        let _e3248 = phi_7654_;
                                                                        phi_7655_ = _e3246;
                                                                        phi_7656_ = _e3248;
                                                                    }
                                                                    let _e3250 = phi_7655_;
                                                                    let _e3252 = phi_7656_;
                                                                    phi_7657_ = _e3250;
                                                                    phi_7658_ = _e3232;
                                                                    phi_7659_ = _e3252;
                                                                } else {
                                                                    phi_7657_ = f64();
                                                                    phi_7658_ = true;
                                                                    phi_7659_ = false;
                                                                }
                                                                let _e3254 = phi_7657_;
                                                                let _e3256 = phi_7658_;
                                                                let _e3258 = phi_7659_;
                                                                if _e3256 {
                                                                    phi_7664_ = f64(2f);
                                                                    phi_7665_ = true;
                                                                } else {
                                                                    phi_7664_ = _e2542;
                                                                    phi_7665_ = _e3258;
                                                                }
                                                                let _e3261 = phi_7664_;
                                                                let _e3263 = phi_7665_;
                                                                if _e3263 {
                                                                    phi_7669_ = _e3261;
                                                                } else {
                                                                    phi_7669_ = _e3254;
                                                                }
                                                                let _e3265 = phi_7669_;
                                                                let _e3268 = local.member[3u];
                                                                let _e3271 = local.member_1[3u];
                                                                let _e3274 = local.member_2[3u];
                                                                if (_e3268 > _e3274) {
                                                                    if (_e3271 > _e3274) {
                                                                        phi_7701_ = false;
                                                                    } else {
                                                                        phi_7701_ = true;
                                                                    }
                                                                    let _e3278 = phi_7701_;
                                                                    phi_7702_ = _e3278;
                                                                } else {
                                                                    phi_7702_ = true;
                                                                }
                                                                let _e3280 = phi_7702_;
                                                                if _e3280 {
                                                                    let _e3281 = (_e3271 >= _e3268);
                                                                    if _e3281 {
                                                                        phi_7727_ = f64();
                                                                        phi_7728_ = false;
                                                                    } else {
                                                                        if ((_e3268 - _e3271) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7725_ = (((_e3268 - _e3274) / (_e3268 - _e3271)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7726_ = false;
                                                                        } else {
                                                                            phi_7725_ = f64();
                                                                            phi_7726_ = true;
                                                                        }
                                                                        let _e3295 = phi_7725_;
                                                                        let _e3297 = phi_7726_;
                                                                        phi_7727_ = _e3295;
                                                                        phi_7728_ = _e3297;
                                                                    }
                                                                    let _e3299 = phi_7727_;
                                                                    let _e3301 = phi_7728_;
                                                                    phi_7729_ = _e3299;
                                                                    phi_7730_ = _e3281;
                                                                    phi_7731_ = _e3301;
                                                                } else {
                                                                    phi_7729_ = f64();
                                                                    phi_7730_ = true;
                                                                    phi_7731_ = false;
                                                                }
                                                                let _e3303 = phi_7729_;
                                                                let _e3305 = phi_7730_;
                                                                let _e3307 = phi_7731_;
                                                                if _e3305 {
                                                                    phi_7736_ = f64(2f);
                                                                    phi_7737_ = true;
                                                                } else {
                                                                    phi_7736_ = _e2542;
                                                                    phi_7737_ = _e3307;
                                                                }
                                                                let _e3310 = phi_7736_;
                                                                let _e3312 = phi_7737_;
                                                                if _e3312 {
                                                                    phi_7741_ = _e3310;
                                                                } else {
                                                                    phi_7741_ = _e3303;
                                                                }
                                                                let _e3314 = phi_7741_;
                                                                if (_e3265 < _e3314) {
                                                                    phi_7746_ = _e3265;
                                                                } else {
                                                                    phi_7746_ = _e3314;
                                                                }
                                                                let _e3317 = phi_7746_;
                                                                if (_e3216 < _e3317) {
                                                                    phi_7751_ = _e3216;
                                                                } else {
                                                                    phi_7751_ = _e3317;
                                                                }
                                                                let _e3320 = phi_7751_;
                                                                if (_e3320 > _e2542) {
                                                                    phi_7756_ = _e3320;
                                                                } else {
                                                                    phi_7756_ = _e2542;
                                                                }
                                                                let _e3323 = phi_7756_;
                                                                let _e3324 = (_e3323 > _e1554.member_1);
                                                                if _e3324 {
                                                                    phi_7768_ = f64();
                                                                    phi_7769_ = false;
                                                                } else {
                                                                    if (_e2560.member_1 == 0u) {
                                                                        phi_7767_ = (_e1554.member_1 - _e2542);
                                                                    } else {
                                                                        phi_7767_ = (_e2853 + _e2853);
                                                                    }
                                                                    let _e3329 = phi_7767_;
                                                                    phi_7768_ = _e3329;
                                                                    phi_7769_ = true;
                                                                }
                                                                let _e3331 = phi_7768_;
                                                                let _e3333 = phi_7769_;
                                                                phi_7770_ = _e3323;
                                                                phi_7771_ = _e3331;
                                                                phi_7772_ = _e3333;
                                                                phi_7773_ = _e3324;
                                                                phi_7774_ = false;
                                                            } else {
                                                                phi_7770_ = f64();
                                                                phi_7771_ = f64();
                                                                phi_7772_ = false;
                                                                phi_7773_ = false;
                                                                phi_7774_ = true;
                                                            }
                                                            let _e3335 = phi_7770_;
                                                            let _e3337 = phi_7771_;
                                                            let _e3339 = phi_7772_;
                                                            let _e3341 = phi_7773_;
                                                            let _e3343 = phi_7774_;
                                                            phi_7775_ = _e3335;
                                                            phi_7776_ = _e3337;
                                                            phi_7777_ = false;
                                                            phi_7778_ = _e3339;
                                                            phi_7779_ = _e3341;
                                                            phi_7780_ = _e3343;
                                                        } else {
                                                            phi_7775_ = f64();
                                                            phi_7776_ = f64();
                                                            phi_7777_ = true;
                                                            phi_7778_ = false;
                                                            phi_7779_ = false;
                                                            phi_7780_ = false;
                                                        }
                                                        let _e3345 = phi_7775_;
                                                        let _e3347 = phi_7776_;
                                                        let _e3349 = phi_7777_;
                                                        let _e3351 = phi_7778_;
                                                        let _e3353 = phi_7779_;
                                                        let _e3355 = phi_7780_;
                                                        phi_7781_ = _e3345;
                                                        phi_7782_ = _e3347;
                                                        phi_7783_ = _e3349;
                                                        phi_7784_ = _e3351;
                                                        phi_7785_ = _e3353;
                                                        phi_7786_ = _e3355;
                                                    } else {
                                                        phi_7781_ = f64();
                                                        phi_7782_ = f64();
                                                        phi_7783_ = true;
                                                        phi_7784_ = false;
                                                        phi_7785_ = false;
                                                        phi_7786_ = false;
                                                    }
                                                    let _e3357 = phi_7781_;
                                                    let _e3359 = phi_7782_;
                                                    let _e3361 = phi_7783_;
                                                    let _e3363 = phi_7784_;
                                                    let _e3365 = phi_7785_;
                                                    let _e3367 = phi_7786_;
                                                    if _e3361 {
                                                        let _e3368 = (_e2542 <= _e2544);
                                                        if _e3368 {
                                                            phi_8120_ = f64();
                                                            phi_8121_ = false;
                                                        } else {
                                                            let _e3371 = local.member[0u];
                                                            let _e3374 = local.member_1[0u];
                                                            let _e3377 = local.member[0u];
                                                            let _e3383 = local.member_2[0u];
                                                            let _e3384 = ((_e3371 + ((_e3374 - _e3377) * _e2546)) - _e3383);
                                                            let _e3387 = local.member[1u];
                                                            let _e3390 = local.member_1[1u];
                                                            let _e3393 = local.member[1u];
                                                            let _e3399 = local.member_2[1u];
                                                            let _e3400 = ((_e3387 + ((_e3390 - _e3393) * _e2546)) - _e3399);
                                                            if (_e3384 < _e3400) {
                                                                phi_7866_ = _e3384;
                                                            } else {
                                                                phi_7866_ = _e3400;
                                                            }
                                                            let _e3403 = phi_7866_;
                                                            let _e3406 = local.member[2u];
                                                            let _e3409 = local.member_1[2u];
                                                            let _e3412 = local.member[2u];
                                                            let _e3418 = local.member_2[2u];
                                                            let _e3419 = ((_e3406 + ((_e3409 - _e3412) * _e2546)) - _e3418);
                                                            let _e3422 = local.member[3u];
                                                            let _e3425 = local.member_1[3u];
                                                            let _e3428 = local.member[3u];
                                                            let _e3434 = local.member_2[3u];
                                                            let _e3435 = ((_e3422 + ((_e3425 - _e3428) * _e2546)) - _e3434);
                                                            if (_e3419 < _e3435) {
                                                                phi_7939_ = _e3419;
                                                            } else {
                                                                phi_7939_ = _e3435;
                                                            }
                                                            let _e3438 = phi_7939_;
                                                            if (_e3403 < _e3438) {
                                                                phi_7944_ = _e3403;
                                                            } else {
                                                                phi_7944_ = _e3438;
                                                            }
                                                            let _e3441 = phi_7944_;
                                                            let _e3444 = local_1.member[0u];
                                                            let _e3447 = local_1.member_1[0u];
                                                            let _e3450 = local_1.member[0u];
                                                            let _e3456 = local_1.member_2[0u];
                                                            let _e3457 = ((_e3444 + ((_e3447 - _e3450) * _e2542)) - _e3456);
                                                            let _e3460 = local_1.member[1u];
                                                            let _e3463 = local_1.member_1[1u];
                                                            let _e3466 = local_1.member[1u];
                                                            let _e3472 = local_1.member_2[1u];
                                                            let _e3473 = ((_e3460 + ((_e3463 - _e3466) * _e2542)) - _e3472);
                                                            if (_e3457 < _e3473) {
                                                                phi_8017_ = _e3457;
                                                            } else {
                                                                phi_8017_ = _e3473;
                                                            }
                                                            let _e3476 = phi_8017_;
                                                            let _e3479 = local_1.member[2u];
                                                            let _e3482 = local_1.member_1[2u];
                                                            let _e3485 = local_1.member[2u];
                                                            let _e3491 = local_1.member_2[2u];
                                                            let _e3492 = ((_e3479 + ((_e3482 - _e3485) * _e2542)) - _e3491);
                                                            let _e3495 = local_1.member[3u];
                                                            let _e3498 = local_1.member_1[3u];
                                                            let _e3501 = local_1.member[3u];
                                                            let _e3507 = local_1.member_2[3u];
                                                            let _e3508 = ((_e3495 + ((_e3498 - _e3501) * _e2542)) - _e3507);
                                                            if (_e3492 < _e3508) {
                                                                phi_8090_ = _e3492;
                                                            } else {
                                                                phi_8090_ = _e3508;
                                                            }
                                                            let _e3511 = phi_8090_;
                                                            if (_e3476 < _e3511) {
                                                                phi_8095_ = _e3476;
                                                            } else {
                                                                phi_8095_ = _e3511;
                                                            }
                                                            let _e3514 = phi_8095_;
                                                            let _e3515 = f64(0.0625f);
                                                            let _e3517 = f64(0.9f);
                                                            if (_e3514 > f64(0f)) {
                                                                phi_8118_ = f64(0.5f);
                                                            } else {
                                                                let _e3523 = (f64(0.95f) * (_e3441 / (_e3441 - _e3514)));
                                                                if (_e3523 > _e3515) {
                                                                    if (_e3523 < _e3517) {
                                                                        phi_8116_ = _e3523;
                                                                    } else {
                                                                        phi_8116_ = _e3517;
                                                                    }
                                                                    let _e3527 = phi_8116_;
                                                                    phi_8117_ = _e3527;
                                                                } else {
                                                                    phi_8117_ = _e3515;
                                                                }
                                                                let _e3529 = phi_8117_;
                                                                phi_8118_ = _e3529;
                                                            }
                                                            let _e3531 = phi_8118_;
                                                            phi_8120_ = (_e2853 * _e3531);
                                                            phi_8121_ = true;
                                                        }
                                                        let _e3534 = phi_8120_;
                                                        let _e3536 = phi_8121_;
                                                        phi_8122_ = _e2544;
                                                        phi_8123_ = _e3534;
                                                        phi_8124_ = _e2546;
                                                        phi_8125_ = _e3536;
                                                        phi_8126_ = _e3368;
                                                        phi_8127_ = false;
                                                        phi_8128_ = false;
                                                    } else {
                                                        phi_8122_ = _e3357;
                                                        phi_8123_ = _e3359;
                                                        phi_8124_ = _e2542;
                                                        phi_8125_ = _e3363;
                                                        phi_8126_ = false;
                                                        phi_8127_ = _e3365;
                                                        phi_8128_ = _e3367;
                                                    }
                                                    let _e3538 = phi_8122_;
                                                    let _e3540 = phi_8123_;
                                                    let _e3542 = phi_8124_;
                                                    let _e3544 = phi_8125_;
                                                    let _e3546 = phi_8126_;
                                                    let _e3548 = phi_8127_;
                                                    let _e3550 = phi_8128_;
                                                    if _e3544 {
                                                        let _e3551 = (_e3542 + _e3540);
                                                        if (_e3551 > _e3538) {
                                                            phi_8137_ = _e3551;
                                                        } else {
                                                            phi_8137_ = _e3538;
                                                        }
                                                        let _e3554 = phi_8137_;
                                                        if (_e3554 < _e1554.member_1) {
                                                            phi_8142_ = _e3554;
                                                        } else {
                                                            phi_8142_ = _e1554.member_1;
                                                        }
                                                        let _e3557 = phi_8142_;
                                                        if (_e2560.member_1 > 0u) {
                                                            phi_8153_ = ((_e3557 - _e3542) > f64(0.0000000037252903f));
                                                        } else {
                                                            phi_8153_ = true;
                                                        }
                                                        let _e3563 = phi_8153_;
                                                        if _e3563 {
                                                            phi_8157_ = false;
                                                        } else {
                                                            phi_8157_ = true;
                                                        }
                                                        let _e3565 = phi_8157_;
                                                        phi_8158_ = _e3557;
                                                        phi_8159_ = _e3563;
                                                        phi_8160_ = _e3565;
                                                        phi_8161_ = false;
                                                        phi_8162_ = false;
                                                        phi_8163_ = false;
                                                    } else {
                                                        phi_8158_ = f64();
                                                        phi_8159_ = false;
                                                        phi_8160_ = false;
                                                        phi_8161_ = _e3546;
                                                        phi_8162_ = _e3548;
                                                        phi_8163_ = _e3550;
                                                    }
                                                    let _e3567 = phi_8158_;
                                                    let _e3569 = phi_8159_;
                                                    let _e3571 = phi_8160_;
                                                    let _e3573 = phi_8161_;
                                                    let _e3575 = phi_8162_;
                                                    let _e3577 = phi_8163_;
                                                    phi_6507_ = _e3567;
                                                    phi_6509_ = _e3538;
                                                    phi_6511_ = _e3542;
                                                    phi_8164_ = _e3538;
                                                    phi_8165_ = _e3569;
                                                    phi_8166_ = _e3571;
                                                    phi_8167_ = false;
                                                    phi_8168_ = _e3573;
                                                    phi_8169_ = _e3575;
                                                    phi_8170_ = _e3577;
                                                } else {
                                                    phi_6507_ = f64();
                                                    phi_6509_ = f64();
                                                    phi_6511_ = f64();
                                                    phi_8164_ = f64();
                                                    phi_8165_ = false;
                                                    phi_8166_ = false;
                                                    phi_8167_ = true;
                                                    phi_8168_ = false;
                                                    phi_8169_ = false;
                                                    phi_8170_ = false;
                                                }
                                                let _e3579 = phi_6507_;
                                                let _e3581 = phi_6509_;
                                                let _e3583 = phi_6511_;
                                                let _e3585 = phi_8164_;
                                                let _e3587 = phi_8165_;
                                                let _e3589 = phi_8166_;
                                                let _e3591 = phi_8167_;
                                                let _e3593 = phi_8168_;
                                                let _e3595 = phi_8169_;
                                                let _e3597 = phi_8170_;
                                                local_19 = _e3589;
                                                local_35 = _e3585;
                                                local_37 = _e3591;
                                                local_38 = _e3593;
                                                local_39 = _e3595;
                                                local_40 = _e3597;
                                                continue;
                                                continuing {
                                                    phi_6503_ = _e2558;
                                                    phi_6506_ = _e3579;
                                                    phi_6508_ = _e3581;
                                                    phi_6510_ = _e3583;
                                                    break if !(_e3587);
                                                }
                                            }
                                            let _e3600 = local_19;
                                            if _e3600 {
                                                let _e6043 = local_35;
                                                phi_8174_ = _e6043;
                                                phi_8175_ = true;
                                                phi_8176_ = false;
                                                phi_8177_ = false;
                                                phi_8178_ = false;
                                            } else {
                                                let _e6045 = local_36;
                                                phi_8174_ = _e6045;
                                                let _e6048 = local_37;
                                                phi_8175_ = _e6048;
                                                let _e6051 = local_38;
                                                phi_8176_ = _e6051;
                                                let _e6054 = local_39;
                                                phi_8177_ = _e6054;
                                                let _e6057 = local_40;
                                                phi_8178_ = _e6057;
                                            }
                                            let _e3602 = phi_8174_;
                                            let _e3604 = phi_8175_;
                                            let _e3606 = phi_8176_;
                                            let _e3608 = phi_8177_;
                                            let _e3610 = phi_8178_;
                                            if _e3604 {
                                                phi_8183_ = type_44(1u, _e3602);
                                                phi_8184_ = false;
                                                phi_8185_ = false;
                                                phi_8186_ = false;
                                            } else {
                                                phi_8183_ = type_44();
                                                phi_8184_ = _e3606;
                                                phi_8185_ = _e3608;
                                                phi_8186_ = _e3610;
                                            }
                                            let _e3613 = phi_8183_;
                                            let _e3615 = phi_8184_;
                                            let _e3617 = phi_8185_;
                                            let _e3619 = phi_8186_;
                                            if _e3615 {
                                                let _e3621 = local_20;
                                                phi_8191_ = type_44(1u, _e3621);
                                                phi_8192_ = false;
                                                phi_8193_ = false;
                                            } else {
                                                phi_8191_ = type_44();
                                                phi_8192_ = _e3617;
                                                phi_8193_ = _e3619;
                                            }
                                            let _e3624 = phi_8191_;
                                            let _e3626 = phi_8192_;
                                            let _e3628 = phi_8193_;
                                            if _e3626 {
                                                phi_8198_ = type_44(0u, type_44().member_1);
                                                phi_8199_ = false;
                                                phi_8200_ = true;
                                            } else {
                                                phi_8198_ = _e3624;
                                                phi_8199_ = _e3628;
                                                phi_8200_ = _e3615;
                                            }
                                            let _e3632 = phi_8198_;
                                            let _e3634 = phi_8199_;
                                            let _e3636 = phi_8200_;
                                            if _e3634 {
                                                phi_8205_ = type_44(0u, type_44().member_1);
                                                phi_8206_ = true;
                                            } else {
                                                phi_8205_ = _e3632;
                                                phi_8206_ = _e3636;
                                            }
                                            let _e3640 = phi_8205_;
                                            let _e3642 = phi_8206_;
                                            if _e3642 {
                                                phi_8210_ = _e3640;
                                            } else {
                                                phi_8210_ = _e3613;
                                            }
                                            let _e3644 = phi_8210_;
                                            let _e3647 = (_e3644.member != 0u);
                                            if _e3647 {
                                                phi_8217_ = false;
                                            } else {
                                                phi_8217_ = true;
                                            }
                                            let _e3649 = phi_8217_;
                                            phi_8218_ = _e3644.member_1;
                                            phi_8219_ = _e3649;
                                            phi_8220_ = _e3647;
                                            phi_8221_ = false;
                                        } else {
                                            phi_8218_ = f64();
                                            phi_8219_ = false;
                                            phi_8220_ = false;
                                            phi_8221_ = true;
                                        }
                                        let _e3651 = phi_8218_;
                                        let _e3653 = phi_8219_;
                                        let _e3655 = phi_8220_;
                                        let _e3657 = phi_8221_;
                                        phi_8222_ = _e3651;
                                        phi_8223_ = _e3653;
                                        phi_8224_ = _e3655;
                                        phi_8225_ = _e3657;
                                    }
                                    let _e3659 = phi_8222_;
                                    let _e3661 = phi_8223_;
                                    let _e3663 = phi_8224_;
                                    let _e3665 = phi_8225_;
                                    phi_8226_ = _e3659;
                                    phi_8227_ = _e2287;
                                    phi_8228_ = _e3661;
                                    phi_8229_ = _e3663;
                                    phi_8230_ = _e3665;
                                }
                                let _e3667 = phi_8226_;
                                let _e3669 = phi_8227_;
                                let _e3671 = phi_8228_;
                                let _e3673 = phi_8229_;
                                let _e3675 = phi_8230_;
                                if _e3669 {
                                    phi_8234_ = true;
                                    phi_8235_ = false;
                                    phi_8236_ = false;
                                } else {
                                    phi_8234_ = _e3671;
                                    phi_8235_ = _e3673;
                                    phi_8236_ = _e3675;
                                }
                                let _e3677 = phi_8234_;
                                let _e3679 = phi_8235_;
                                let _e3681 = phi_8236_;
                                phi_8237_ = _e3667;
                                phi_8238_ = _e1554;
                                phi_8239_ = _e3677;
                                phi_8240_ = false;
                                phi_8241_ = _e3679;
                                phi_8242_ = _e3681;
                            } else {
                                phi_8237_ = f64();
                                phi_8238_ = type_45();
                                phi_8239_ = false;
                                phi_8240_ = true;
                                phi_8241_ = false;
                                phi_8242_ = false;
                            }
                            let _e3683 = phi_8237_;
                            let _e3685 = phi_8238_;
                            let _e3687 = phi_8239_;
                            let _e3689 = phi_8240_;
                            let _e3691 = phi_8241_;
                            let _e3693 = phi_8242_;
                            local_21 = _e3689;
                            local_41 = _e3691;
                            local_42 = _e3693;
                            local_22 = _e3683;
                            local_23 = _e3685;
                            continue;
                            continuing {
                                phi_4592_ = _e1267;
                                break if !(_e3687);
                            }
                        }
                        let _e3696 = local_21;
                        if _e3696 {
                            phi_8247_ = type_44(0u, type_44().member_1);
                            phi_8248_ = false;
                            phi_8249_ = false;
                        } else {
                            phi_8247_ = type_44();
                            let _e6099 = local_41;
                            phi_8248_ = _e6099;
                            let _e6102 = local_42;
                            phi_8249_ = _e6102;
                        }
                        let _e3700 = phi_8247_;
                        let _e3702 = phi_8248_;
                        let _e3704 = phi_8249_;
                        if _e3702 {
                            let _e3706 = local_22;
                            phi_8254_ = type_44(2u, _e3706);
                            phi_8255_ = false;
                        } else {
                            phi_8254_ = type_44();
                            phi_8255_ = _e3704;
                        }
                        let _e3709 = phi_8254_;
                        let _e3711 = phi_8255_;
                        if _e3711 {
                            let _e3713 = local_23;
                            phi_8261_ = type_44(1u, _e3713.member);
                            phi_8262_ = true;
                        } else {
                            phi_8261_ = _e3709;
                            phi_8262_ = _e3702;
                        }
                        let _e3717 = phi_8261_;
                        let _e3719 = phi_8262_;
                        if _e3719 {
                            phi_8266_ = _e3717;
                        } else {
                            phi_8266_ = _e3700;
                        }
                        let _e3721 = phi_8266_;
                        phi_8270_ = _e3721;
                    }
                    let _e5446 = phi_8270_;
                    phi_8271_ = _e5446;
                }
                let _e5450 = phi_8271_;
                switch bitcast<i32>(_e5450.member) {
                    case 0: {
                        phi_8284_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5456 = function_(_e5450.member_1);
                        phi_8284_ = type_32(0u, _e5456, true);
                        break;
                    }
                    case 2: {
                        let _e5454 = function_(_e5450.member_1);
                        phi_8284_ = type_32(1u, _e5454, true);
                        break;
                    }
                    default: {
                        phi_8284_ = type_32();
                        break;
                    }
                }
                let _e5459 = phi_8284_;
                if _e5459.member_2 {
                    let _e5466 = (_e5459.member_1[1] >> bitcast<u32>(20i));
                    if (_e5466 <= 896u) {
                        phi_8307_ = 0u;
                    } else {
                        phi_8307_ = ((((_e5466 - 896u) << bitcast<u32>(23i)) | ((_e5459.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5459.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5481 = phi_8307_;
                    let _e5483 = atomicMin((&earliest.member[0u]), _e5481);
                }
                phi_8311_ = type_22(1u, _e5459.member, _e181, _e184, _e5459.member_1);
                phi_8312_ = _e5459.member_2;
            } else {
                phi_8311_ = type_22(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8312_ = false;
            }
            let _e5485 = phi_8311_;
            let _e5487 = phi_8312_;
            let _e5490 = params.member.member.member_1;
            if ((_e5490 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5487 {
                    let _e5496 = atomicAdd((&counters[0u]), 1u);
                    phi_8331_ = _e5496;
                } else {
                    phi_8331_ = 0u;
                }
                let _e5498 = phi_8331_;
                workgroupBarrier();
                if (_e110 == 0u) {
                    let _e5501 = atomicLoad((&counters[0u]));
                    if (_e5501 > 0u) {
                        let _e5504 = atomicAdd((&contacts.member[0u]), _e5501);
                        atomicStore((&counters[1u]), _e5504);
                    }
                }
                workgroupBarrier();
                let _e5507 = atomicLoad((&counters[1u]));
                let _e5508 = (_e5507 + _e5498);
                if _e5487 {
                    let _e5511 = params.member.member_1.member_3;
                    if (_e5508 < _e5511) {
                        let _e5513 = (6u * _e5508);
                        atomicStore((&contacts.member[(4u + _e5513)]), _e5485.member);
                        atomicStore((&contacts.member[(_e5513 + 5u)]), _e5485.member_1);
                        atomicStore((&contacts.member[(_e5513 + 6u)]), _e5485.member_2);
                        atomicStore((&contacts.member[(_e5513 + 7u)]), _e5485.member_3);
                        atomicStore((&contacts.member[(_e5513 + 8u)]), _e5485.member_4[0]);
                        atomicStore((&contacts.member[(_e5513 + 9u)]), _e5485.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_279_ = _e166;
            break if !(_e172);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
