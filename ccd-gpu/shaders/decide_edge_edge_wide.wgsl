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

struct type_49 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
@group(0) @binding(0) 
var<storage> params: type_28;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_49;
@group(0) @binding(2) 
var<storage> positions: type_31;
@group(0) @binding(3) 
var<storage> elements: type_24;
@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_49;

fn function_(param: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_1(param_1: array<f64, 3>, param_2: array<f64, 3>) -> array<f64, 3> {
    var phi_9025_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_9025_ = param_2;
    } else {
        phi_9025_ = param_1;
    }
    let _e26 = phi_9025_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_8589_: bool;
    var phi_8590_: bool;
    var phi_8591_: bool;
    var phi_8592_: bool;
    var phi_8596_: bool;
    var phi_8569_: bool;
    var phi_8570_: bool;
    var phi_8571_: bool;
    var phi_8572_: bool;
    var phi_8573_: bool;
    var phi_8574_: bool;
    var phi_8578_: bool;
    var phi_8597_: bool;
    var phi_8627_: array<f64, 3>;
    var phi_8628_: bool;
    var phi_8629_: array<f64, 3>;
    var phi_8630_: bool;
    var phi_8876_: f64;
    var phi_8878_: f64;
    var phi_8920_: f64;
    var phi_8922_: f64;
    var phi_8970_: f64;
    var phi_8972_: f64;
    var phi_8681_: f64;
    var phi_8683_: f64;
    var phi_8731_: f64;
    var phi_8733_: f64;
    var phi_8778_: f64;
    var phi_8780_: f64;
    var phi_8831_: f64;
    var phi_8833_: f64;
    var phi_8987_: array<array<f64, 3>, 4>;
    var phi_8995_: array<f64, 3>;

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
                    phi_8569_ = (_e78 <= _e70);
                    phi_8570_ = false;
                } else {
                    phi_8569_ = bool();
                    phi_8570_ = true;
                }
                let _e99 = phi_8569_;
                let _e101 = phi_8570_;
                phi_8571_ = _e99;
                phi_8572_ = _e101;
            } else {
                phi_8571_ = bool();
                phi_8572_ = true;
            }
            let _e103 = phi_8571_;
            let _e105 = phi_8572_;
            phi_8573_ = _e103;
            phi_8574_ = _e105;
        } else {
            phi_8573_ = bool();
            phi_8574_ = true;
        }
        let _e107 = phi_8573_;
        let _e109 = phi_8574_;
        if _e109 {
            phi_8578_ = false;
        } else {
            phi_8578_ = _e107;
        }
        let _e111 = phi_8578_;
        phi_8597_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_8589_ = ((_e74 + _e78) <= _e70);
                phi_8590_ = false;
            } else {
                phi_8589_ = bool();
                phi_8590_ = true;
            }
            let _e85 = phi_8589_;
            let _e87 = phi_8590_;
            phi_8591_ = _e85;
            phi_8592_ = _e87;
        } else {
            phi_8591_ = bool();
            phi_8592_ = true;
        }
        let _e89 = phi_8591_;
        let _e91 = phi_8592_;
        if _e91 {
            phi_8596_ = false;
        } else {
            phi_8596_ = _e89;
        }
        let _e93 = phi_8596_;
        phi_8597_ = _e93;
    }
    let _e113 = phi_8597_;
    if (_e68 > _e69) {
        if _e113 {
            phi_8627_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_8628_ = false;
        } else {
            phi_8627_ = array<f64, 3>();
            phi_8628_ = true;
        }
        let _e138 = phi_8627_;
        let _e140 = phi_8628_;
        phi_8629_ = _e138;
        phi_8630_ = _e140;
    } else {
        phi_8629_ = array<f64, 3>();
        phi_8630_ = true;
    }
    let _e142 = phi_8629_;
    let _e144 = phi_8630_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_8681_ = _e307;
                } else {
                    phi_8681_ = f64(1f);
                }
                let _e315 = phi_8681_;
                phi_8683_ = _e315;
            } else {
                phi_8683_ = f64(0f);
            }
            let _e317 = phi_8683_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_8731_ = _e353;
                } else {
                    phi_8731_ = f64(1f);
                }
                let _e361 = phi_8731_;
                phi_8733_ = _e361;
            } else {
                phi_8733_ = f64(0f);
            }
            let _e363 = phi_8733_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_8778_ = _e396;
                } else {
                    phi_8778_ = f64(1f);
                }
                let _e404 = phi_8778_;
                phi_8780_ = _e404;
            } else {
                phi_8780_ = f64(0f);
            }
            let _e406 = phi_8780_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_8831_ = _e445;
                } else {
                    phi_8831_ = f64(1f);
                }
                let _e453 = phi_8831_;
                phi_8833_ = _e453;
            } else {
                phi_8833_ = f64(0f);
            }
            let _e455 = phi_8833_;
            phi_8987_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_8876_ = _e174;
                } else {
                    phi_8876_ = f64(1f);
                }
                let _e182 = phi_8876_;
                phi_8878_ = _e182;
            } else {
                phi_8878_ = f64(0f);
            }
            let _e184 = phi_8878_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_8920_ = _e214;
                } else {
                    phi_8920_ = f64(1f);
                }
                let _e222 = phi_8920_;
                phi_8922_ = _e222;
            } else {
                phi_8922_ = f64(0f);
            }
            let _e224 = phi_8922_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_8970_ = _e260;
                } else {
                    phi_8970_ = f64(1f);
                }
                let _e268 = phi_8970_;
                phi_8972_ = _e268;
            } else {
                phi_8972_ = f64(0f);
            }
            let _e270 = phi_8972_;
            phi_8987_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_8987_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_8995_ = _e475;
    } else {
        phi_8995_ = _e142;
    }
    let _e477 = phi_8995_;
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
    var phi_4354_: f64;
    var phi_4360_: f64;
    var phi_4365_: f64;
    var phi_4371_: f64;
    var phi_4377_: f64;
    var phi_4382_: f64;
    var phi_4387_: f64;
    var phi_4397_: bool;
    var phi_4404_: f64;
    var phi_4412_: f64;
    var phi_4455_: type_16;
    var phi_4458_: f64;
    var phi_4479_: bool;
    var phi_4485_: type_17;
    var phi_4456_: type_16;
    var phi_4499_: type_17;
    var phi_4459_: f64;
    var local_13: f64;
    var phi_4448_: f64;
    var phi_4512_: f64;
    var phi_4518_: f64;
    var phi_4543_: type_9;
    var phi_4546_: u32;
    var phi_4544_: type_9;
    var phi_4569_: type_9;
    var phi_4613_: u32;
    var phi_4614_: u32;
    var phi_4547_: u32;
    var phi_4615_: u32;
    var phi_4635_: type_9;
    var phi_4636_: type_9;
    var phi_4659_: type_9;
    var phi_4713_: f64;
    var phi_4720_: f64;
    var phi_4732_: bool;
    var phi_4733_: bool;
    var phi_4734_: bool;
    var phi_4735_: bool;
    var phi_4739_: bool;
    var phi_4751_: type_45;
    var phi_4752_: type_45;
    var phi_4753_: bool;
    var phi_4754_: type_45;
    var phi_4755_: bool;
    var phi_4768_: f64;
    var phi_4781_: type_9;
    var phi_4784_: f64;
    var phi_4786_: f64;
    var phi_4788_: f64;
    var phi_4782_: type_9;
    var phi_4811_: type_9;
    var phi_4838_: f64;
    var phi_4839_: f64;
    var phi_4867_: f64;
    var phi_4883_: f64;
    var phi_4890_: bool;
    var phi_4891_: bool;
    var phi_4892_: bool;
    var phi_4898_: f64;
    var phi_4899_: f64;
    var phi_4900_: bool;
    var phi_4785_: f64;
    var phi_4787_: f64;
    var phi_4789_: f64;
    var phi_4901_: f64;
    var phi_4902_: bool;
    var phi_4903_: bool;
    var local_14: bool;
    var phi_4907_: f64;
    var phi_4908_: f64;
    var phi_4918_: f64;
    var phi_4923_: type_9;
    var phi_4926_: f64;
    var phi_4924_: type_9;
    var phi_4949_: type_9;
    var phi_4980_: f64;
    var phi_4981_: bool;
    var phi_4982_: f64;
    var phi_4983_: bool;
    var phi_4984_: bool;
    var phi_4985_: bool;
    var phi_4986_: f64;
    var phi_4927_: f64;
    var phi_4987_: bool;
    var phi_4988_: bool;
    var phi_4989_: bool;
    var phi_4990_: bool;
    var local_15: bool;
    var phi_4994_: bool;
    var phi_4995_: bool;
    var phi_4999_: bool;
    var phi_5003_: f64;
    var phi_5004_: f64;
    var phi_5006_: type_45;
    var phi_5037_: f64;
    var phi_5044_: f64;
    var phi_5049_: f64;
    var phi_5056_: f64;
    var phi_5061_: f64;
    var phi_5074_: f64;
    var phi_5081_: f64;
    var phi_5086_: f64;
    var phi_5093_: f64;
    var phi_5098_: f64;
    var phi_5103_: f64;
    var phi_5162_: f64;
    var phi_5168_: f64;
    var phi_5173_: f64;
    var phi_5179_: f64;
    var phi_5184_: f64;
    var phi_5198_: f64;
    var phi_5204_: f64;
    var phi_5209_: f64;
    var phi_5215_: f64;
    var phi_5220_: f64;
    var phi_5246_: f64;
    var phi_5253_: f64;
    var phi_5258_: f64;
    var phi_5265_: f64;
    var phi_5270_: f64;
    var phi_5283_: f64;
    var phi_5290_: f64;
    var phi_5295_: f64;
    var phi_5302_: f64;
    var phi_5307_: f64;
    var phi_5312_: f64;
    var phi_5371_: f64;
    var phi_5377_: f64;
    var phi_5382_: f64;
    var phi_5388_: f64;
    var phi_5393_: f64;
    var phi_5407_: f64;
    var phi_5413_: f64;
    var phi_5418_: f64;
    var phi_5424_: f64;
    var phi_5429_: f64;
    var phi_5455_: f64;
    var phi_5462_: f64;
    var phi_5467_: f64;
    var phi_5474_: f64;
    var phi_5479_: f64;
    var phi_5492_: f64;
    var phi_5499_: f64;
    var phi_5504_: f64;
    var phi_5511_: f64;
    var phi_5516_: f64;
    var phi_5521_: f64;
    var phi_5580_: f64;
    var phi_5586_: f64;
    var phi_5591_: f64;
    var phi_5597_: f64;
    var phi_5602_: f64;
    var phi_5616_: f64;
    var phi_5622_: f64;
    var phi_5627_: f64;
    var phi_5633_: f64;
    var phi_5638_: f64;
    var phi_5687_: f64;
    var phi_5693_: f64;
    var phi_5721_: f64;
    var phi_5727_: f64;
    var phi_5732_: u32;
    var phi_5733_: u32;
    var phi_5703_: f64;
    var phi_5709_: f64;
    var phi_5714_: u32;
    var phi_5715_: u32;
    var phi_5734_: u32;
    var phi_5735_: u32;
    var phi_5808_: f64;
    var phi_5820_: f64;
    var phi_5963_: f64;
    var phi_5969_: f64;
    var phi_5976_: f64;
    var phi_6020_: type_9;
    var phi_6023_: bool;
    var phi_6021_: type_9;
    var phi_6046_: type_9;
    var phi_6073_: bool;
    var phi_6074_: bool;
    var phi_6024_: bool;
    var phi_6075_: bool;
    var phi_6076_: bool;
    var local_16: bool;
    var phi_6080_: bool;
    var local_17: bool;
    var phi_6087_: u32;
    var phi_6088_: u32;
    var phi_6089_: bool;
    var phi_6090_: u32;
    var phi_6091_: u32;
    var phi_6092_: bool;
    var phi_6096_: u32;
    var phi_6117_: bool;
    var phi_6118_: bool;
    var phi_6119_: bool;
    var phi_6268_: f64;
    var phi_6275_: f64;
    var phi_6280_: f64;
    var phi_6287_: f64;
    var phi_6292_: f64;
    var phi_6305_: f64;
    var phi_6312_: f64;
    var phi_6317_: f64;
    var phi_6324_: f64;
    var phi_6329_: f64;
    var phi_6334_: f64;
    var phi_6351_: f64;
    var phi_6358_: f64;
    var phi_6363_: f64;
    var phi_6370_: f64;
    var phi_6375_: f64;
    var phi_6389_: f64;
    var phi_6396_: f64;
    var phi_6401_: f64;
    var phi_6408_: f64;
    var phi_6413_: f64;
    var phi_6418_: f64;
    var phi_6435_: f64;
    var phi_6442_: f64;
    var phi_6447_: f64;
    var phi_6454_: f64;
    var phi_6459_: f64;
    var phi_6473_: f64;
    var phi_6480_: f64;
    var phi_6485_: f64;
    var phi_6492_: f64;
    var phi_6497_: f64;
    var phi_6502_: f64;
    var phi_6546_: type_9;
    var phi_6549_: f64;
    var phi_6551_: f64;
    var phi_6553_: f64;
    var phi_6555_: bool;
    var phi_6557_: u32;
    var phi_6547_: type_9;
    var phi_6580_: type_9;
    var phi_6695_: f64;
    var phi_6701_: f64;
    var phi_6707_: f64;
    var phi_6709_: array<f64, 3>;
    var phi_6716_: f64;
    var phi_6723_: f64;
    var phi_6731_: f64;
    var phi_6777_: type_16;
    var phi_6780_: f64;
    var phi_6801_: bool;
    var phi_6807_: type_17;
    var phi_6778_: type_16;
    var phi_6821_: type_17;
    var phi_6781_: f64;
    var local_18: f64;
    var phi_6770_: f64;
    var phi_6834_: f64;
    var phi_6903_: f64;
    var phi_6909_: f64;
    var phi_6918_: f64;
    var phi_6924_: f64;
    var phi_6933_: f64;
    var phi_6939_: f64;
    var phi_6948_: f64;
    var phi_6954_: f64;
    var phi_6960_: type_34;
    var phi_6961_: bool;
    var phi_6962_: type_34;
    var phi_6963_: bool;
    var phi_6973_: type_34;
    var phi_7145_: bool;
    var phi_7146_: bool;
    var phi_7147_: bool;
    var phi_7148_: bool;
    var phi_7149_: bool;
    var phi_7150_: bool;
    var phi_7154_: bool;
    var phi_7452_: bool;
    var phi_7453_: bool;
    var phi_7454_: bool;
    var phi_7455_: bool;
    var phi_7456_: bool;
    var phi_7457_: bool;
    var phi_7461_: bool;
    var phi_7465_: bool;
    var phi_7476_: bool;
    var phi_7477_: bool;
    var phi_7551_: bool;
    var phi_7552_: bool;
    var phi_7575_: f64;
    var phi_7576_: bool;
    var phi_7577_: f64;
    var phi_7578_: bool;
    var phi_7579_: f64;
    var phi_7580_: bool;
    var phi_7581_: bool;
    var phi_7586_: f64;
    var phi_7587_: bool;
    var phi_7591_: f64;
    var phi_7623_: bool;
    var phi_7624_: bool;
    var phi_7647_: f64;
    var phi_7648_: bool;
    var phi_7649_: f64;
    var phi_7650_: bool;
    var phi_7651_: f64;
    var phi_7652_: bool;
    var phi_7653_: bool;
    var phi_7658_: f64;
    var phi_7659_: bool;
    var phi_7663_: f64;
    var phi_7668_: f64;
    var phi_7700_: bool;
    var phi_7701_: bool;
    var phi_7724_: f64;
    var phi_7725_: bool;
    var phi_7726_: f64;
    var phi_7727_: bool;
    var phi_7728_: f64;
    var phi_7729_: bool;
    var phi_7730_: bool;
    var phi_7735_: f64;
    var phi_7736_: bool;
    var phi_7740_: f64;
    var phi_7772_: bool;
    var phi_7773_: bool;
    var phi_7796_: f64;
    var phi_7797_: bool;
    var phi_7798_: f64;
    var phi_7799_: bool;
    var phi_7800_: f64;
    var phi_7801_: bool;
    var phi_7802_: bool;
    var phi_7807_: f64;
    var phi_7808_: bool;
    var phi_7812_: f64;
    var phi_7817_: f64;
    var phi_7822_: f64;
    var phi_7827_: f64;
    var phi_7837_: f64;
    var phi_7838_: f64;
    var phi_7839_: bool;
    var phi_7840_: f64;
    var phi_7841_: f64;
    var phi_7842_: bool;
    var phi_7843_: bool;
    var phi_7844_: bool;
    var phi_7845_: f64;
    var phi_7846_: f64;
    var phi_7847_: bool;
    var phi_7848_: bool;
    var phi_7849_: bool;
    var phi_7850_: bool;
    var phi_7851_: f64;
    var phi_7852_: f64;
    var phi_7853_: bool;
    var phi_7854_: bool;
    var phi_7855_: bool;
    var phi_7856_: bool;
    var phi_7942_: f64;
    var phi_8015_: f64;
    var phi_8020_: f64;
    var phi_8093_: f64;
    var phi_8166_: f64;
    var phi_8171_: f64;
    var phi_8192_: f64;
    var phi_8193_: f64;
    var phi_8194_: f64;
    var phi_7869_: bool;
    var phi_8196_: u32;
    var phi_8197_: f64;
    var phi_8198_: bool;
    var phi_8199_: bool;
    var phi_8200_: bool;
    var phi_8201_: u32;
    var phi_8202_: f64;
    var phi_8203_: f64;
    var phi_8204_: f64;
    var phi_8205_: bool;
    var phi_8206_: u32;
    var phi_8207_: bool;
    var phi_8208_: bool;
    var phi_8209_: bool;
    var phi_8210_: bool;
    var phi_8211_: bool;
    var phi_8220_: f64;
    var phi_8225_: f64;
    var phi_8235_: bool;
    var phi_8239_: bool;
    var phi_8240_: f64;
    var phi_8241_: f64;
    var phi_8242_: f64;
    var phi_8243_: bool;
    var phi_8244_: u32;
    var phi_8245_: bool;
    var phi_8246_: bool;
    var phi_8247_: bool;
    var phi_8248_: bool;
    var phi_8249_: bool;
    var phi_6550_: f64;
    var phi_6552_: f64;
    var phi_6554_: f64;
    var phi_6556_: bool;
    var phi_6558_: u32;
    var phi_8250_: f64;
    var phi_8251_: bool;
    var phi_8252_: bool;
    var phi_8253_: bool;
    var phi_8254_: bool;
    var phi_8255_: bool;
    var phi_8256_: bool;
    var local_19: bool;
    var phi_8260_: f64;
    var phi_8261_: bool;
    var phi_8262_: bool;
    var phi_8263_: bool;
    var phi_8264_: bool;
    var phi_8269_: type_44;
    var phi_8270_: bool;
    var phi_8271_: bool;
    var phi_8272_: bool;
    var local_20: f64;
    var phi_8277_: type_44;
    var phi_8278_: bool;
    var phi_8279_: bool;
    var phi_8284_: type_44;
    var phi_8285_: bool;
    var phi_8286_: bool;
    var phi_8291_: type_44;
    var phi_8292_: bool;
    var phi_8296_: type_44;
    var phi_8303_: bool;
    var phi_8304_: f64;
    var phi_8305_: bool;
    var phi_8306_: bool;
    var phi_8307_: bool;
    var phi_8308_: f64;
    var phi_8309_: bool;
    var phi_8310_: bool;
    var phi_8311_: bool;
    var phi_8312_: f64;
    var phi_8313_: bool;
    var phi_8314_: bool;
    var phi_8315_: bool;
    var phi_8316_: bool;
    var phi_8320_: bool;
    var phi_8321_: bool;
    var phi_8322_: bool;
    var phi_8323_: f64;
    var phi_8324_: type_45;
    var phi_8325_: bool;
    var phi_8326_: bool;
    var phi_8327_: bool;
    var phi_8328_: bool;
    var local_21: bool;
    var phi_8333_: type_44;
    var phi_8334_: bool;
    var phi_8335_: bool;
    var local_22: f64;
    var phi_8340_: type_44;
    var phi_8341_: bool;
    var local_23: type_45;
    var phi_8347_: type_44;
    var phi_8348_: bool;
    var phi_8352_: type_44;
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
    var phi_2058_: bool;
    var phi_2060_: u32;
    var phi_2050_: type_9;
    var phi_2083_: type_9;
    var phi_2198_: f64;
    var phi_2204_: f64;
    var phi_2210_: f64;
    var phi_2212_: array<f64, 3>;
    var phi_2219_: f64;
    var phi_2226_: f64;
    var phi_2234_: f64;
    var phi_2280_: type_16;
    var phi_2283_: f64;
    var phi_2304_: bool;
    var phi_2310_: type_17;
    var phi_2281_: type_16;
    var phi_2324_: type_17;
    var phi_2284_: f64;
    var local_24: f64;
    var phi_2273_: f64;
    var phi_2337_: f64;
    var phi_2406_: f64;
    var phi_2412_: f64;
    var phi_2421_: f64;
    var phi_2427_: f64;
    var phi_2436_: f64;
    var phi_2442_: f64;
    var phi_2451_: f64;
    var phi_2457_: f64;
    var phi_2463_: type_34;
    var phi_2464_: bool;
    var phi_2465_: type_34;
    var phi_2466_: bool;
    var phi_2476_: type_34;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_2657_: bool;
    var phi_2955_: bool;
    var phi_2956_: bool;
    var phi_2957_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2964_: bool;
    var phi_2968_: bool;
    var phi_2979_: bool;
    var phi_2980_: bool;
    var phi_3054_: bool;
    var phi_3055_: bool;
    var phi_3078_: f64;
    var phi_3079_: bool;
    var phi_3080_: f64;
    var phi_3081_: bool;
    var phi_3082_: f64;
    var phi_3083_: bool;
    var phi_3084_: bool;
    var phi_3089_: f64;
    var phi_3090_: bool;
    var phi_3094_: f64;
    var phi_3126_: bool;
    var phi_3127_: bool;
    var phi_3150_: f64;
    var phi_3151_: bool;
    var phi_3152_: f64;
    var phi_3153_: bool;
    var phi_3154_: f64;
    var phi_3155_: bool;
    var phi_3156_: bool;
    var phi_3161_: f64;
    var phi_3162_: bool;
    var phi_3166_: f64;
    var phi_3171_: f64;
    var phi_3203_: bool;
    var phi_3204_: bool;
    var phi_3227_: f64;
    var phi_3228_: bool;
    var phi_3229_: f64;
    var phi_3230_: bool;
    var phi_3231_: f64;
    var phi_3232_: bool;
    var phi_3233_: bool;
    var phi_3238_: f64;
    var phi_3239_: bool;
    var phi_3243_: f64;
    var phi_3275_: bool;
    var phi_3276_: bool;
    var phi_3299_: f64;
    var phi_3300_: bool;
    var phi_3301_: f64;
    var phi_3302_: bool;
    var phi_3303_: f64;
    var phi_3304_: bool;
    var phi_3305_: bool;
    var phi_3310_: f64;
    var phi_3311_: bool;
    var phi_3315_: f64;
    var phi_3320_: f64;
    var phi_3325_: f64;
    var phi_3330_: f64;
    var phi_3340_: f64;
    var phi_3341_: f64;
    var phi_3342_: bool;
    var phi_3343_: f64;
    var phi_3344_: f64;
    var phi_3345_: bool;
    var phi_3346_: bool;
    var phi_3347_: bool;
    var phi_3348_: f64;
    var phi_3349_: f64;
    var phi_3350_: bool;
    var phi_3351_: bool;
    var phi_3352_: bool;
    var phi_3353_: bool;
    var phi_3354_: f64;
    var phi_3355_: f64;
    var phi_3356_: bool;
    var phi_3357_: bool;
    var phi_3358_: bool;
    var phi_3359_: bool;
    var phi_3445_: f64;
    var phi_3518_: f64;
    var phi_3523_: f64;
    var phi_3596_: f64;
    var phi_3669_: f64;
    var phi_3674_: f64;
    var phi_3695_: f64;
    var phi_3696_: f64;
    var phi_3697_: f64;
    var phi_3372_: bool;
    var phi_3699_: u32;
    var phi_3700_: f64;
    var phi_3701_: bool;
    var phi_3702_: bool;
    var phi_3703_: bool;
    var phi_3704_: u32;
    var phi_3705_: f64;
    var phi_3706_: f64;
    var phi_3707_: f64;
    var phi_3708_: bool;
    var phi_3709_: u32;
    var phi_3710_: bool;
    var phi_3711_: bool;
    var phi_3712_: bool;
    var phi_3713_: bool;
    var phi_3714_: bool;
    var phi_3723_: f64;
    var phi_3728_: f64;
    var phi_3738_: bool;
    var phi_3742_: bool;
    var phi_3743_: f64;
    var phi_3744_: f64;
    var phi_3745_: f64;
    var phi_3746_: bool;
    var phi_3747_: u32;
    var phi_3748_: bool;
    var phi_3749_: bool;
    var phi_3750_: bool;
    var phi_3751_: bool;
    var phi_3752_: bool;
    var phi_2053_: f64;
    var phi_2055_: f64;
    var phi_2057_: f64;
    var phi_2059_: bool;
    var phi_2061_: u32;
    var phi_3753_: f64;
    var phi_3754_: bool;
    var phi_3755_: bool;
    var phi_3756_: bool;
    var phi_3757_: bool;
    var phi_3758_: bool;
    var phi_3759_: bool;
    var local_25: bool;
    var phi_3763_: f64;
    var phi_3764_: bool;
    var phi_3765_: bool;
    var phi_3766_: bool;
    var phi_3767_: bool;
    var phi_3772_: type_44;
    var phi_3773_: bool;
    var phi_3774_: bool;
    var phi_3775_: bool;
    var local_26: f64;
    var phi_3780_: type_44;
    var phi_3781_: bool;
    var phi_3782_: bool;
    var phi_3787_: type_44;
    var phi_3788_: bool;
    var phi_3789_: bool;
    var phi_3794_: type_44;
    var phi_3795_: bool;
    var phi_3799_: type_44;
    var phi_3813_: type_9;
    var phi_3814_: type_9;
    var phi_3837_: type_9;
    var phi_3858_: f64;
    var phi_3988_: type_16;
    var phi_3991_: f64;
    var phi_4012_: bool;
    var phi_4018_: type_17;
    var phi_3989_: type_16;
    var phi_4032_: type_17;
    var phi_3992_: f64;
    var local_27: f64;
    var phi_3981_: f64;
    var phi_4045_: f64;
    var phi_4063_: f64;
    var phi_4070_: f64;
    var phi_4075_: f64;
    var phi_4082_: f64;
    var phi_4087_: f64;
    var phi_4100_: f64;
    var phi_4107_: f64;
    var phi_4112_: f64;
    var phi_4119_: f64;
    var phi_4124_: f64;
    var phi_4129_: f64;
    var phi_4146_: f64;
    var phi_4153_: f64;
    var phi_4158_: f64;
    var phi_4165_: f64;
    var phi_4170_: f64;
    var phi_4184_: f64;
    var phi_4191_: f64;
    var phi_4196_: f64;
    var phi_4203_: f64;
    var phi_4208_: f64;
    var phi_4213_: f64;
    var phi_4230_: f64;
    var phi_4237_: f64;
    var phi_4242_: f64;
    var phi_4249_: f64;
    var phi_4254_: f64;
    var phi_4268_: f64;
    var phi_4275_: f64;
    var phi_4280_: f64;
    var phi_4287_: f64;
    var phi_4292_: f64;
    var phi_4297_: f64;
    var phi_4321_: bool;
    var phi_4322_: bool;
    var phi_4323_: bool;
    var local_28: bool;
    var phi_4328_: type_44;
    var phi_4329_: bool;
    var phi_4334_: type_44;
    var phi_4335_: bool;
    var phi_4337_: type_44;
    var phi_4338_: type_44;
    var phi_4339_: bool;
    var phi_4343_: type_44;
    var phi_8356_: type_44;
    var phi_8357_: type_44;
    var phi_8370_: type_32;
    var phi_8393_: u32;
    var phi_8397_: type_22;
    var phi_8398_: bool;
    var phi_8417_: u32;
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
                    phi_8357_ = type_44(0u, type_44().member_1);
                } else {
                    if (_e578.member_1 > f64(0f)) {
                        let _e3770 = f64(1f);
                        let _e3771 = f64(0f);
                        let _e3774 = local_12.member[0u];
                        let _e3780 = local_12.member_1[0u];
                        let _e3786 = local_12.member_2[0u];
                        let _e3790 = (_e3774[0] - _e3780[0]);
                        let _e3791 = (_e3774[1] - _e3780[1]);
                        let _e3792 = (_e3774[2] - _e3780[2]);
                        let _e3801 = local_12.member[1u];
                        let _e3807 = local_12.member_1[1u];
                        let _e3813 = local_12.member_2[1u];
                        let _e3817 = (_e3801[0] - _e3807[0]);
                        let _e3818 = (_e3801[1] - _e3807[1]);
                        let _e3819 = (_e3801[2] - _e3807[2]);
                        let _e3828 = local_12.member[0u];
                        if (_e3828[0] < 0.0lf) {
                            phi_1771_ = -(_e3828[0]);
                        } else {
                            phi_1771_ = _e3828[0];
                        }
                        let _e3835 = phi_1771_;
                        if (_e3828[1] < 0.0lf) {
                            phi_1778_ = -(_e3828[1]);
                        } else {
                            phi_1778_ = _e3828[1];
                        }
                        let _e3839 = phi_1778_;
                        if (_e3835 > _e3839) {
                            phi_1783_ = _e3835;
                        } else {
                            phi_1783_ = _e3839;
                        }
                        let _e3842 = phi_1783_;
                        if (_e3828[2] < 0.0lf) {
                            phi_1790_ = -(_e3828[2]);
                        } else {
                            phi_1790_ = _e3828[2];
                        }
                        let _e3846 = phi_1790_;
                        if (_e3842 > _e3846) {
                            phi_1795_ = _e3842;
                        } else {
                            phi_1795_ = _e3846;
                        }
                        let _e3849 = phi_1795_;
                        let _e3852 = local_12.member[1u];
                        if (_e3852[0] < 0.0lf) {
                            phi_1808_ = -(_e3852[0]);
                        } else {
                            phi_1808_ = _e3852[0];
                        }
                        let _e3859 = phi_1808_;
                        if (_e3852[1] < 0.0lf) {
                            phi_1815_ = -(_e3852[1]);
                        } else {
                            phi_1815_ = _e3852[1];
                        }
                        let _e3863 = phi_1815_;
                        if (_e3859 > _e3863) {
                            phi_1820_ = _e3859;
                        } else {
                            phi_1820_ = _e3863;
                        }
                        let _e3866 = phi_1820_;
                        if (_e3852[2] < 0.0lf) {
                            phi_1827_ = -(_e3852[2]);
                        } else {
                            phi_1827_ = _e3852[2];
                        }
                        let _e3870 = phi_1827_;
                        if (_e3866 > _e3870) {
                            phi_1832_ = _e3866;
                        } else {
                            phi_1832_ = _e3870;
                        }
                        let _e3873 = phi_1832_;
                        if (_e3849 > _e3873) {
                            phi_1837_ = _e3849;
                        } else {
                            phi_1837_ = _e3873;
                        }
                        let _e3876 = phi_1837_;
                        let _e3878 = local_12.member_3;
                        let _e3882 = local_12.member_1[0u];
                        if (_e3882[0] < 0.0lf) {
                            phi_1854_ = -(_e3882[0]);
                        } else {
                            phi_1854_ = _e3882[0];
                        }
                        let _e3889 = phi_1854_;
                        if (_e3882[1] < 0.0lf) {
                            phi_1861_ = -(_e3882[1]);
                        } else {
                            phi_1861_ = _e3882[1];
                        }
                        let _e3893 = phi_1861_;
                        if (_e3889 > _e3893) {
                            phi_1866_ = _e3889;
                        } else {
                            phi_1866_ = _e3893;
                        }
                        let _e3896 = phi_1866_;
                        if (_e3882[2] < 0.0lf) {
                            phi_1873_ = -(_e3882[2]);
                        } else {
                            phi_1873_ = _e3882[2];
                        }
                        let _e3900 = phi_1873_;
                        if (_e3896 > _e3900) {
                            phi_1878_ = _e3896;
                        } else {
                            phi_1878_ = _e3900;
                        }
                        let _e3903 = phi_1878_;
                        let _e3906 = local_12.member_1[1u];
                        if (_e3906[0] < 0.0lf) {
                            phi_1892_ = -(_e3906[0]);
                        } else {
                            phi_1892_ = _e3906[0];
                        }
                        let _e3913 = phi_1892_;
                        if (_e3906[1] < 0.0lf) {
                            phi_1899_ = -(_e3906[1]);
                        } else {
                            phi_1899_ = _e3906[1];
                        }
                        let _e3917 = phi_1899_;
                        if (_e3913 > _e3917) {
                            phi_1904_ = _e3913;
                        } else {
                            phi_1904_ = _e3917;
                        }
                        let _e3920 = phi_1904_;
                        if (_e3906[2] < 0.0lf) {
                            phi_1911_ = -(_e3906[2]);
                        } else {
                            phi_1911_ = _e3906[2];
                        }
                        let _e3924 = phi_1911_;
                        if (_e3920 > _e3924) {
                            phi_1916_ = _e3920;
                        } else {
                            phi_1916_ = _e3924;
                        }
                        let _e3927 = phi_1916_;
                        if (_e3903 > _e3927) {
                            phi_1921_ = _e3903;
                        } else {
                            phi_1921_ = _e3927;
                        }
                        let _e3930 = phi_1921_;
                        let _e3932 = local_12.member_3;
                        let _e3936 = local_12.member_2[0u];
                        if (_e3936[0] < 0.0lf) {
                            phi_1938_ = -(_e3936[0]);
                        } else {
                            phi_1938_ = _e3936[0];
                        }
                        let _e3943 = phi_1938_;
                        if (_e3936[1] < 0.0lf) {
                            phi_1945_ = -(_e3936[1]);
                        } else {
                            phi_1945_ = _e3936[1];
                        }
                        let _e3947 = phi_1945_;
                        if (_e3943 > _e3947) {
                            phi_1950_ = _e3943;
                        } else {
                            phi_1950_ = _e3947;
                        }
                        let _e3950 = phi_1950_;
                        if (_e3936[2] < 0.0lf) {
                            phi_1957_ = -(_e3936[2]);
                        } else {
                            phi_1957_ = _e3936[2];
                        }
                        let _e3954 = phi_1957_;
                        if (_e3950 > _e3954) {
                            phi_1962_ = _e3950;
                        } else {
                            phi_1962_ = _e3954;
                        }
                        let _e3957 = phi_1962_;
                        let _e3960 = local_12.member_2[1u];
                        if (_e3960[0] < 0.0lf) {
                            phi_1976_ = -(_e3960[0]);
                        } else {
                            phi_1976_ = _e3960[0];
                        }
                        let _e3967 = phi_1976_;
                        if (_e3960[1] < 0.0lf) {
                            phi_1983_ = -(_e3960[1]);
                        } else {
                            phi_1983_ = _e3960[1];
                        }
                        let _e3971 = phi_1983_;
                        if (_e3967 > _e3971) {
                            phi_1988_ = _e3967;
                        } else {
                            phi_1988_ = _e3971;
                        }
                        let _e3974 = phi_1988_;
                        if (_e3960[2] < 0.0lf) {
                            phi_1995_ = -(_e3960[2]);
                        } else {
                            phi_1995_ = _e3960[2];
                        }
                        let _e3978 = phi_1995_;
                        if (_e3974 > _e3978) {
                            phi_2000_ = _e3974;
                        } else {
                            phi_2000_ = _e3978;
                        }
                        let _e3981 = phi_2000_;
                        if (_e3957 > _e3981) {
                            phi_2005_ = _e3957;
                        } else {
                            phi_2005_ = _e3981;
                        }
                        let _e3984 = phi_2005_;
                        let _e3986 = local_12.member_3;
                        let _e3994 = local_12.member_3;
                        let _e4001 = f64(0f);
                        let _e4002 = f64(1f);
                        local_9 = type_34(array<f64, 4>(_e4001, _e4001, _e4001, _e4001), array<f64, 4>(_e4001, _e4001, _e4001, _e4001), array<f64, 4>(_e4002, _e4002, _e4002, _e4002));
                        phi_2049_ = type_9(0u, 96u);
                        phi_2052_ = _e3771;
                        phi_2054_ = _e3771;
                        phi_2056_ = _e3771;
                        phi_2058_ = false;
                        phi_2060_ = 0u;
                        loop {
                            let _e4008 = phi_2049_;
                            let _e4010 = phi_2052_;
                            let _e4012 = phi_2054_;
                            let _e4014 = phi_2056_;
                            let _e4016 = phi_2058_;
                            let _e4018 = phi_2060_;
                            local_44 = _e4012;
                            local_26 = _e4010;
                            if (_e4008.member < _e4008.member_1) {
                                phi_2050_ = type_9((_e4008.member + 1u), _e4008.member_1);
                                phi_2083_ = type_9(1u, _e4008.member);
                            } else {
                                phi_2050_ = _e4008;
                                phi_2083_ = type_9(0u, type_9().member_1);
                            }
                            let _e4030 = phi_2050_;
                            let _e4032 = phi_2083_;
                            if (bitcast<i32>(_e4032.member) != 0i) {
                                let _e4038 = local_12.member[0u];
                                let _e4044 = local_12.member[1u];
                                let _e4060 = local_12.member_1[0u];
                                let _e4066 = local_12.member_1[1u];
                                let _e4082 = local_12.member_2[0u];
                                let _e4088 = local_12.member_2[1u];
                                let _e4102 = function_2(array<f64, 3>((_e4038[0] + ((_e4044[0] - _e4038[0]) * _e4010)), (_e4038[1] + ((_e4044[1] - _e4038[1]) * _e4010)), (_e4038[2] + ((_e4044[2] - _e4038[2]) * _e4010))), array<f64, 3>((_e4060[0] + ((_e4066[0] - _e4060[0]) * _e4010)), (_e4060[1] + ((_e4066[1] - _e4060[1]) * _e4010)), (_e4060[2] + ((_e4066[2] - _e4060[2]) * _e4010))), array<f64, 3>((_e4082[0] + ((_e4088[0] - _e4082[0]) * _e4010)), (_e4082[1] + ((_e4088[1] - _e4082[1]) * _e4010)), (_e4082[2] + ((_e4088[2] - _e4082[2]) * _e4010))), 1u);
                                if (_e4018 == 0u) {
                                    phi_2212_ = _e4102;
                                } else {
                                    let _e4104 = f64(0f);
                                    if (_e4018 == 1u) {
                                        phi_2198_ = _e4102[0];
                                    } else {
                                        phi_2198_ = _e4104;
                                    }
                                    let _e4108 = phi_2198_;
                                    if (_e4018 == 2u) {
                                        phi_2204_ = _e4102[1];
                                    } else {
                                        phi_2204_ = _e4104;
                                    }
                                    let _e4112 = phi_2204_;
                                    if (_e4018 == 3u) {
                                        phi_2210_ = _e4102[2];
                                    } else {
                                        phi_2210_ = _e4104;
                                    }
                                    let _e4116 = phi_2210_;
                                    phi_2212_ = array<f64, 3>(_e4108, _e4112, _e4116);
                                }
                                let _e4119 = phi_2212_;
                                if (_e4119[0] < 0.0lf) {
                                    phi_2219_ = -(_e4119[0]);
                                } else {
                                    phi_2219_ = _e4119[0];
                                }
                                let _e4124 = phi_2219_;
                                if (_e4119[1] < 0.0lf) {
                                    phi_2226_ = -(_e4119[1]);
                                } else {
                                    phi_2226_ = _e4119[1];
                                }
                                let _e4129 = phi_2226_;
                                if (_e4119[2] < 0.0lf) {
                                    phi_2234_ = -(_e4119[2]);
                                } else {
                                    phi_2234_ = _e4119[2];
                                }
                                let _e4135 = phi_2234_;
                                let _e4136 = ((_e4124 + _e4129) + _e4135);
                                if (_e4136 > f64(0f)) {
                                    if ((bitcast<u64>(_e4136) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4143 = (f64(1f) / _e4136);
                                        let _e4145 = (_e4119[0] * _e4143);
                                        let _e4147 = (_e4119[1] * _e4143);
                                        let _e4149 = (_e4119[2] * _e4143);
                                        let _e4154 = (((_e4145 * _e4145) + (_e4147 * _e4147)) + (_e4149 * _e4149));
                                        if (_e4154 <= 2.2250738585072014e-308lf) {
                                            if (_e4154 > 0.0lf) {
                                                phi_2273_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2273_ = 0.0lf;
                                            }
                                            let _e4206 = phi_2273_;
                                            phi_2337_ = _e4206;
                                        } else {
                                            phi_2280_ = type_16(0i, 5i);
                                            phi_2283_ = bitcast<f64>(((bitcast<u64>(_e4154) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4161 = phi_2280_;
                                                let _e4163 = phi_2283_;
                                                local_24 = _e4163;
                                                if (_e4161.member < _e4161.member_1) {
                                                    let _e4170 = (_e4161.member + 1i);
                                                    if ((false == (_e4170 > _e4161.member)) != false) {
                                                        phi_2304_ = true;
                                                    } else {
                                                        phi_2304_ = false;
                                                    }
                                                    let _e4175 = phi_2304_;
                                                    if _e4175 {
                                                        phi_2310_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2310_ = type_17(1u, _e4170);
                                                    }
                                                    let _e4180 = phi_2310_;
                                                    phi_2281_ = type_16(_e4180.member_1, _e4161.member_1);
                                                    phi_2324_ = type_17(1u, _e4161.member);
                                                } else {
                                                    phi_2281_ = _e4161;
                                                    phi_2324_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e4186 = phi_2281_;
                                                let _e4188 = phi_2324_;
                                                let _e4191 = (bitcast<i32>(_e4188.member) != 0i);
                                                if _e4191 {
                                                    phi_2284_ = (0.5lf * (_e4163 + (_e4154 / _e4163)));
                                                } else {
                                                    phi_2284_ = f64();
                                                }
                                                let _e4196 = phi_2284_;
                                                continue;
                                                continuing {
                                                    phi_2280_ = _e4186;
                                                    phi_2283_ = _e4196;
                                                    break if !(_e4191);
                                                }
                                            }
                                            let _e4201 = local_24;
                                            phi_2337_ = (_e4201 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4208 = phi_2337_;
                                        let _e4210 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4217 = ((((((((_e3876 + _e3878) + (_e3930 + _e3932)) + (_e3984 + _e3986)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3994 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e578.member_1 * _e4208) * (f64(1f) + _e4210)));
                                        let _e4222 = (((_e4145 * _e3774[0]) + (_e4147 * _e3774[1])) + (_e4149 * _e3774[2]));
                                        let _e4227 = (((_e4145 * _e3790) + (_e4147 * _e3791)) + (_e4149 * _e3792));
                                        let _e4232 = (((_e4145 * (_e3774[0] - _e3786[0])) + (_e4147 * (_e3774[1] - _e3786[1]))) + (_e4149 * (_e3774[2] - _e3786[2])));
                                        let _e4237 = (((_e4145 * (_e3790 - _e3786[0])) + (_e4147 * (_e3791 - _e3786[1]))) + (_e4149 * (_e3792 - _e3786[2])));
                                        let _e4243 = (((_e4145 * _e3801[0]) + (_e4147 * _e3801[1])) + (_e4149 * _e3801[2]));
                                        let _e4248 = (((_e4145 * _e3817) + (_e4147 * _e3818)) + (_e4149 * _e3819));
                                        let _e4253 = (((_e4145 * (_e3801[0] - _e3813[0])) + (_e4147 * (_e3801[1] - _e3813[1]))) + (_e4149 * (_e3801[2] - _e3813[2])));
                                        let _e4258 = (((_e4145 * (_e3817 - _e3813[0])) + (_e4147 * (_e3818 - _e3813[1]))) + (_e4149 * (_e3819 - _e3813[2])));
                                        if (_e4222 < 0.0lf) {
                                            phi_2406_ = -(_e4222);
                                        } else {
                                            phi_2406_ = _e4222;
                                        }
                                        let _e4263 = phi_2406_;
                                        if (_e4243 < 0.0lf) {
                                            phi_2412_ = -(_e4243);
                                        } else {
                                            phi_2412_ = _e4243;
                                        }
                                        let _e4267 = phi_2412_;
                                        if (_e4227 < 0.0lf) {
                                            phi_2421_ = -(_e4227);
                                        } else {
                                            phi_2421_ = _e4227;
                                        }
                                        let _e4274 = phi_2421_;
                                        if (_e4248 < 0.0lf) {
                                            phi_2427_ = -(_e4248);
                                        } else {
                                            phi_2427_ = _e4248;
                                        }
                                        let _e4278 = phi_2427_;
                                        if (_e4232 < 0.0lf) {
                                            phi_2436_ = -(_e4232);
                                        } else {
                                            phi_2436_ = _e4232;
                                        }
                                        let _e4285 = phi_2436_;
                                        if (_e4253 < 0.0lf) {
                                            phi_2442_ = -(_e4253);
                                        } else {
                                            phi_2442_ = _e4253;
                                        }
                                        let _e4289 = phi_2442_;
                                        if (_e4237 < 0.0lf) {
                                            phi_2451_ = -(_e4237);
                                        } else {
                                            phi_2451_ = _e4237;
                                        }
                                        let _e4296 = phi_2451_;
                                        if (_e4258 < 0.0lf) {
                                            phi_2457_ = -(_e4258);
                                        } else {
                                            phi_2457_ = _e4258;
                                        }
                                        let _e4300 = phi_2457_;
                                        phi_2463_ = type_34(array<f64, 4>(_e4222, _e4227, _e4232, _e4237), array<f64, 4>(_e4243, _e4248, _e4253, _e4258), array<f64, 4>((_e4217 + ((_e4263 + _e4267) * _e4210)), (_e4217 + ((_e4274 + _e4278) * _e4210)), (_e4217 + ((_e4285 + _e4289) * _e4210)), (_e4217 + ((_e4296 + _e4300) * _e4210))));
                                        phi_2464_ = false;
                                    } else {
                                        phi_2463_ = type_34();
                                        phi_2464_ = true;
                                    }
                                    let _e4307 = phi_2463_;
                                    let _e4309 = phi_2464_;
                                    phi_2465_ = _e4307;
                                    phi_2466_ = _e4309;
                                } else {
                                    phi_2465_ = type_34();
                                    phi_2466_ = true;
                                }
                                let _e4311 = phi_2465_;
                                let _e4313 = phi_2466_;
                                if _e4313 {
                                    let _e4314 = f64(0f);
                                    let _e4315 = f64(1f);
                                    phi_2476_ = type_34(array<f64, 4>(_e4314, _e4314, _e4314, _e4314), array<f64, 4>(_e4314, _e4314, _e4314, _e4314), array<f64, 4>(_e4315, _e4315, _e4315, _e4315));
                                } else {
                                    phi_2476_ = _e4311;
                                }
                                let _e4321 = phi_2476_;
                                local_10 = type_34(array<f64, 4>(_e4321.member[0], _e4321.member[1], _e4321.member[2], _e4321.member[3]), array<f64, 4>(_e4321.member_1[0], _e4321.member_1[1], _e4321.member_1[2], _e4321.member_1[3]), array<f64, 4>(_e4321.member_2[0], _e4321.member_2[1], _e4321.member_2[2], _e4321.member_2[3]));
                                let _e4341 = (_e4010 - _e4014);
                                let _e4343 = f64(0f);
                                let _e4346 = local_10.member[0u];
                                let _e4349 = local_10.member_1[0u];
                                let _e4352 = local_10.member[0u];
                                let _e4358 = local_10.member_2[0u];
                                if (((_e4346 + ((_e4349 - _e4352) * _e4010)) - _e4358) > _e4343) {
                                    let _e4363 = local_10.member[1u];
                                    let _e4366 = local_10.member_1[1u];
                                    let _e4369 = local_10.member[1u];
                                    let _e4375 = local_10.member_2[1u];
                                    if (((_e4363 + ((_e4366 - _e4369) * _e4010)) - _e4375) > _e4343) {
                                        let _e4380 = local_10.member[2u];
                                        let _e4383 = local_10.member_1[2u];
                                        let _e4386 = local_10.member[2u];
                                        let _e4392 = local_10.member_2[2u];
                                        if (((_e4380 + ((_e4383 - _e4386) * _e4010)) - _e4392) > _e4343) {
                                            let _e4397 = local_10.member[3u];
                                            let _e4400 = local_10.member_1[3u];
                                            let _e4403 = local_10.member[3u];
                                            let _e4409 = local_10.member_2[3u];
                                            phi_2648_ = (((_e4397 + ((_e4400 - _e4403) * _e4010)) - _e4409) > _e4343);
                                            phi_2649_ = false;
                                        } else {
                                            phi_2648_ = bool();
                                            phi_2649_ = true;
                                        }
                                        let _e4413 = phi_2648_;
                                        let _e4415 = phi_2649_;
                                        phi_2650_ = _e4413;
                                        phi_2651_ = _e4415;
                                    } else {
                                        phi_2650_ = bool();
                                        phi_2651_ = true;
                                    }
                                    let _e4417 = phi_2650_;
                                    let _e4419 = phi_2651_;
                                    phi_2652_ = _e4417;
                                    phi_2653_ = _e4419;
                                } else {
                                    phi_2652_ = bool();
                                    phi_2653_ = true;
                                }
                                let _e4421 = phi_2652_;
                                let _e4423 = phi_2653_;
                                if _e4423 {
                                    phi_2657_ = false;
                                } else {
                                    phi_2657_ = _e4421;
                                }
                                let _e4425 = phi_2657_;
                                if _e4425 {
                                    if (_e4010 <= _e4012) {
                                        phi_2968_ = true;
                                    } else {
                                        let _e4427 = f64(0f);
                                        let _e4430 = local_9.member[0u];
                                        let _e4433 = local_9.member_1[0u];
                                        let _e4436 = local_9.member[0u];
                                        let _e4442 = local_9.member_2[0u];
                                        let _e4446 = local_10.member[0u];
                                        let _e4449 = local_10.member_1[0u];
                                        let _e4452 = local_10.member[0u];
                                        let _e4458 = local_10.member_2[0u];
                                        if ((((_e4430 + ((_e4433 - _e4436) * _e4010)) - _e4442) + ((_e4446 + ((_e4449 - _e4452) * _e4014)) - _e4458)) > _e4427) {
                                            let _e4464 = local_9.member[1u];
                                            let _e4467 = local_9.member_1[1u];
                                            let _e4470 = local_9.member[1u];
                                            let _e4476 = local_9.member_2[1u];
                                            let _e4480 = local_10.member[1u];
                                            let _e4483 = local_10.member_1[1u];
                                            let _e4486 = local_10.member[1u];
                                            let _e4492 = local_10.member_2[1u];
                                            if ((((_e4464 + ((_e4467 - _e4470) * _e4010)) - _e4476) + ((_e4480 + ((_e4483 - _e4486) * _e4014)) - _e4492)) > _e4427) {
                                                let _e4498 = local_9.member[2u];
                                                let _e4501 = local_9.member_1[2u];
                                                let _e4504 = local_9.member[2u];
                                                let _e4510 = local_9.member_2[2u];
                                                let _e4514 = local_10.member[2u];
                                                let _e4517 = local_10.member_1[2u];
                                                let _e4520 = local_10.member[2u];
                                                let _e4526 = local_10.member_2[2u];
                                                if ((((_e4498 + ((_e4501 - _e4504) * _e4010)) - _e4510) + ((_e4514 + ((_e4517 - _e4520) * _e4014)) - _e4526)) > _e4427) {
                                                    let _e4532 = local_9.member[3u];
                                                    let _e4535 = local_9.member_1[3u];
                                                    let _e4538 = local_9.member[3u];
                                                    let _e4544 = local_9.member_2[3u];
                                                    let _e4548 = local_10.member[3u];
                                                    let _e4551 = local_10.member_1[3u];
                                                    let _e4554 = local_10.member[3u];
                                                    let _e4560 = local_10.member_2[3u];
                                                    phi_2955_ = ((((_e4532 + ((_e4535 - _e4538) * _e4010)) - _e4544) + ((_e4548 + ((_e4551 - _e4554) * _e4014)) - _e4560)) > _e4427);
                                                    phi_2956_ = false;
                                                } else {
                                                    phi_2955_ = bool();
                                                    phi_2956_ = true;
                                                }
                                                let _e4565 = phi_2955_;
                                                let _e4567 = phi_2956_;
                                                phi_2957_ = _e4565;
                                                phi_2958_ = _e4567;
                                            } else {
                                                phi_2957_ = bool();
                                                phi_2958_ = true;
                                            }
                                            let _e4569 = phi_2957_;
                                            let _e4571 = phi_2958_;
                                            phi_2959_ = _e4569;
                                            phi_2960_ = _e4571;
                                        } else {
                                            phi_2959_ = bool();
                                            phi_2960_ = true;
                                        }
                                        let _e4573 = phi_2959_;
                                        let _e4575 = phi_2960_;
                                        if _e4575 {
                                            phi_2964_ = false;
                                        } else {
                                            phi_2964_ = _e4573;
                                        }
                                        let _e4577 = phi_2964_;
                                        phi_2968_ = _e4577;
                                    }
                                    let _e4579 = phi_2968_;
                                    if _e4579 {
                                        if _e4016 {
                                            if (_e4010 >= _e3770) {
                                                phi_2979_ = false;
                                            } else {
                                                phi_2979_ = true;
                                            }
                                            let _e4582 = phi_2979_;
                                            phi_2980_ = _e4582;
                                        } else {
                                            phi_2980_ = true;
                                        }
                                        let _e4584 = phi_2980_;
                                        if _e4584 {
                                            local_9 = type_34(array<f64, 4>(_e4321.member[0], _e4321.member[1], _e4321.member[2], _e4321.member[3]), array<f64, 4>(_e4321.member_1[0], _e4321.member_1[1], _e4321.member_1[2], _e4321.member_1[3]), array<f64, 4>(_e4321.member_2[0], _e4321.member_2[1], _e4321.member_2[2], _e4321.member_2[3]));
                                            let _e4606 = local_9.member[0u];
                                            let _e4609 = local_9.member_1[0u];
                                            let _e4612 = local_9.member_2[0u];
                                            if (_e4606 > _e4612) {
                                                if (_e4609 > _e4612) {
                                                    phi_3054_ = false;
                                                } else {
                                                    phi_3054_ = true;
                                                }
                                                let _e4616 = phi_3054_;
                                                phi_3055_ = _e4616;
                                            } else {
                                                phi_3055_ = true;
                                            }
                                            let _e4618 = phi_3055_;
                                            if _e4618 {
                                                let _e4619 = (_e4609 >= _e4606);
                                                if _e4619 {
                                                    phi_3080_ = f64();
                                                    phi_3081_ = false;
                                                } else {
                                                    if ((_e4606 - _e4609) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3078_ = (((_e4606 - _e4612) / (_e4606 - _e4609)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3079_ = false;
                                                    } else {
                                                        phi_3078_ = f64();
                                                        phi_3079_ = true;
                                                    }
                                                    let _e4633 = phi_3078_;
                                                    let _e4635 = phi_3079_;
                                                    phi_3080_ = _e4633;
                                                    phi_3081_ = _e4635;
                                                }
                                                let _e4637 = phi_3080_;
                                                let _e4639 = phi_3081_;
                                                phi_3082_ = _e4637;
                                                phi_3083_ = _e4619;
                                                phi_3084_ = _e4639;
                                            } else {
                                                phi_3082_ = f64();
                                                phi_3083_ = true;
                                                phi_3084_ = false;
                                            }
                                            let _e4641 = phi_3082_;
                                            let _e4643 = phi_3083_;
                                            let _e4645 = phi_3084_;
                                            if _e4643 {
                                                phi_3089_ = f64(2f);
                                                phi_3090_ = true;
                                            } else {
                                                phi_3089_ = _e4010;
                                                phi_3090_ = _e4645;
                                            }
                                            let _e4648 = phi_3089_;
                                            let _e4650 = phi_3090_;
                                            if _e4650 {
                                                phi_3094_ = _e4648;
                                            } else {
                                                phi_3094_ = _e4641;
                                            }
                                            let _e4652 = phi_3094_;
                                            let _e4655 = local_9.member[1u];
                                            let _e4658 = local_9.member_1[1u];
                                            let _e4661 = local_9.member_2[1u];
                                            if (_e4655 > _e4661) {
                                                if (_e4658 > _e4661) {
                                                    phi_3126_ = false;
                                                } else {
                                                    phi_3126_ = true;
                                                }
                                                let _e4665 = phi_3126_;
                                                phi_3127_ = _e4665;
                                            } else {
                                                phi_3127_ = true;
                                            }
                                            let _e4667 = phi_3127_;
                                            if _e4667 {
                                                let _e4668 = (_e4658 >= _e4655);
                                                if _e4668 {
                                                    phi_3152_ = f64();
                                                    phi_3153_ = false;
                                                } else {
                                                    if ((_e4655 - _e4658) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3150_ = (((_e4655 - _e4661) / (_e4655 - _e4658)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3151_ = false;
                                                    } else {
                                                        phi_3150_ = f64();
                                                        phi_3151_ = true;
                                                    }
                                                    let _e4682 = phi_3150_;
                                                    let _e4684 = phi_3151_;
                                                    phi_3152_ = _e4682;
                                                    phi_3153_ = _e4684;
                                                }
                                                let _e4686 = phi_3152_;
                                                let _e4688 = phi_3153_;
                                                phi_3154_ = _e4686;
                                                phi_3155_ = _e4668;
                                                phi_3156_ = _e4688;
                                            } else {
                                                phi_3154_ = f64();
                                                phi_3155_ = true;
                                                phi_3156_ = false;
                                            }
                                            let _e4690 = phi_3154_;
                                            let _e4692 = phi_3155_;
                                            let _e4694 = phi_3156_;
                                            if _e4692 {
                                                phi_3161_ = f64(2f);
                                                phi_3162_ = true;
                                            } else {
                                                phi_3161_ = _e4010;
                                                phi_3162_ = _e4694;
                                            }
                                            let _e4697 = phi_3161_;
                                            let _e4699 = phi_3162_;
                                            if _e4699 {
                                                phi_3166_ = _e4697;
                                            } else {
                                                phi_3166_ = _e4690;
                                            }
                                            let _e4701 = phi_3166_;
                                            if (_e4652 < _e4701) {
                                                phi_3171_ = _e4652;
                                            } else {
                                                phi_3171_ = _e4701;
                                            }
                                            let _e4704 = phi_3171_;
                                            let _e4707 = local_9.member[2u];
                                            let _e4710 = local_9.member_1[2u];
                                            let _e4713 = local_9.member_2[2u];
                                            if (_e4707 > _e4713) {
                                                if (_e4710 > _e4713) {
                                                    phi_3203_ = false;
                                                } else {
                                                    phi_3203_ = true;
                                                }
                                                let _e4717 = phi_3203_;
                                                phi_3204_ = _e4717;
                                            } else {
                                                phi_3204_ = true;
                                            }
                                            let _e4719 = phi_3204_;
                                            if _e4719 {
                                                let _e4720 = (_e4710 >= _e4707);
                                                if _e4720 {
                                                    phi_3229_ = f64();
                                                    phi_3230_ = false;
                                                } else {
                                                    if ((_e4707 - _e4710) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3227_ = (((_e4707 - _e4713) / (_e4707 - _e4710)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3228_ = false;
                                                    } else {
                                                        phi_3227_ = f64();
                                                        phi_3228_ = true;
                                                    }
                                                    let _e4734 = phi_3227_;
                                                    let _e4736 = phi_3228_;
                                                    phi_3229_ = _e4734;
                                                    phi_3230_ = _e4736;
                                                }
                                                let _e4738 = phi_3229_;
                                                let _e4740 = phi_3230_;
                                                phi_3231_ = _e4738;
                                                phi_3232_ = _e4720;
                                                phi_3233_ = _e4740;
                                            } else {
                                                phi_3231_ = f64();
                                                phi_3232_ = true;
                                                phi_3233_ = false;
                                            }
                                            let _e4742 = phi_3231_;
                                            let _e4744 = phi_3232_;
                                            let _e4746 = phi_3233_;
                                            if _e4744 {
                                                phi_3238_ = f64(2f);
                                                phi_3239_ = true;
                                            } else {
                                                phi_3238_ = _e4010;
                                                phi_3239_ = _e4746;
                                            }
                                            let _e4749 = phi_3238_;
                                            let _e4751 = phi_3239_;
                                            if _e4751 {
                                                phi_3243_ = _e4749;
                                            } else {
                                                phi_3243_ = _e4742;
                                            }
                                            let _e4753 = phi_3243_;
                                            let _e4756 = local_9.member[3u];
                                            let _e4759 = local_9.member_1[3u];
                                            let _e4762 = local_9.member_2[3u];
                                            if (_e4756 > _e4762) {
                                                if (_e4759 > _e4762) {
                                                    phi_3275_ = false;
                                                } else {
                                                    phi_3275_ = true;
                                                }
                                                let _e4766 = phi_3275_;
                                                phi_3276_ = _e4766;
                                            } else {
                                                phi_3276_ = true;
                                            }
                                            let _e4768 = phi_3276_;
                                            if _e4768 {
                                                let _e4769 = (_e4759 >= _e4756);
                                                if _e4769 {
                                                    phi_3301_ = f64();
                                                    phi_3302_ = false;
                                                } else {
                                                    if ((_e4756 - _e4759) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3299_ = (((_e4756 - _e4762) / (_e4756 - _e4759)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3300_ = false;
                                                    } else {
                                                        phi_3299_ = f64();
                                                        phi_3300_ = true;
                                                    }
                                                    let _e4783 = phi_3299_;
                                                    let _e4785 = phi_3300_;
                                                    phi_3301_ = _e4783;
                                                    phi_3302_ = _e4785;
                                                }
                                                let _e4787 = phi_3301_;
                                                let _e4789 = phi_3302_;
                                                phi_3303_ = _e4787;
                                                phi_3304_ = _e4769;
                                                phi_3305_ = _e4789;
                                            } else {
                                                phi_3303_ = f64();
                                                phi_3304_ = true;
                                                phi_3305_ = false;
                                            }
                                            let _e4791 = phi_3303_;
                                            let _e4793 = phi_3304_;
                                            let _e4795 = phi_3305_;
                                            if _e4793 {
                                                phi_3310_ = f64(2f);
                                                phi_3311_ = true;
                                            } else {
                                                phi_3310_ = _e4010;
                                                phi_3311_ = _e4795;
                                            }
                                            let _e4798 = phi_3310_;
                                            let _e4800 = phi_3311_;
                                            if _e4800 {
                                                phi_3315_ = _e4798;
                                            } else {
                                                phi_3315_ = _e4791;
                                            }
                                            let _e4802 = phi_3315_;
                                            if (_e4753 < _e4802) {
                                                phi_3320_ = _e4753;
                                            } else {
                                                phi_3320_ = _e4802;
                                            }
                                            let _e4805 = phi_3320_;
                                            if (_e4704 < _e4805) {
                                                phi_3325_ = _e4704;
                                            } else {
                                                phi_3325_ = _e4805;
                                            }
                                            let _e4808 = phi_3325_;
                                            if (_e4808 > _e4010) {
                                                phi_3330_ = _e4808;
                                            } else {
                                                phi_3330_ = _e4010;
                                            }
                                            let _e4811 = phi_3330_;
                                            let _e4812 = (_e4811 > _e3770);
                                            if _e4812 {
                                                phi_3341_ = f64();
                                                phi_3342_ = false;
                                            } else {
                                                if _e4016 {
                                                    phi_3340_ = (_e4341 + _e4341);
                                                } else {
                                                    phi_3340_ = (_e3770 - _e4010);
                                                }
                                                let _e4816 = phi_3340_;
                                                phi_3341_ = _e4816;
                                                phi_3342_ = true;
                                            }
                                            let _e4818 = phi_3341_;
                                            let _e4820 = phi_3342_;
                                            phi_3343_ = _e4811;
                                            phi_3344_ = _e4818;
                                            phi_3345_ = _e4820;
                                            phi_3346_ = _e4812;
                                            phi_3347_ = false;
                                        } else {
                                            phi_3343_ = f64();
                                            phi_3344_ = f64();
                                            phi_3345_ = false;
                                            phi_3346_ = false;
                                            phi_3347_ = true;
                                        }
                                        let _e4822 = phi_3343_;
                                        let _e4824 = phi_3344_;
                                        let _e4826 = phi_3345_;
                                        let _e4828 = phi_3346_;
                                        let _e4830 = phi_3347_;
                                        phi_3348_ = _e4822;
                                        phi_3349_ = _e4824;
                                        phi_3350_ = false;
                                        phi_3351_ = _e4826;
                                        phi_3352_ = _e4828;
                                        phi_3353_ = _e4830;
                                    } else {
                                        phi_3348_ = f64();
                                        phi_3349_ = f64();
                                        phi_3350_ = true;
                                        phi_3351_ = false;
                                        phi_3352_ = false;
                                        phi_3353_ = false;
                                    }
                                    let _e4832 = phi_3348_;
                                    let _e4834 = phi_3349_;
                                    let _e4836 = phi_3350_;
                                    let _e4838 = phi_3351_;
                                    let _e4840 = phi_3352_;
                                    let _e4842 = phi_3353_;
                                    phi_3354_ = _e4832;
                                    phi_3355_ = _e4834;
                                    phi_3356_ = _e4836;
                                    phi_3357_ = _e4838;
                                    phi_3358_ = _e4840;
                                    phi_3359_ = _e4842;
                                } else {
                                    phi_3354_ = f64();
                                    phi_3355_ = f64();
                                    phi_3356_ = true;
                                    phi_3357_ = false;
                                    phi_3358_ = false;
                                    phi_3359_ = false;
                                }
                                let _e4844 = phi_3354_;
                                let _e4846 = phi_3355_;
                                let _e4848 = phi_3356_;
                                let _e4850 = phi_3357_;
                                let _e4852 = phi_3358_;
                                let _e4854 = phi_3359_;
                                if _e4848 {
                                    if (_e4010 <= _e4012) {
                                        let _e5020 = (_e4018 + 1u);
                                        let _e5021 = (_e5020 > 3u);
                                        if _e5021 {
                                            phi_3372_ = false;
                                        } else {
                                            phi_3372_ = true;
                                        }
                                        let _e5023 = phi_3372_;
                                        phi_3699_ = _e5020;
                                        phi_3700_ = f64();
                                        phi_3701_ = false;
                                        phi_3702_ = _e5023;
                                        phi_3703_ = _e5021;
                                    } else {
                                        let _e4858 = local_9.member[0u];
                                        let _e4861 = local_9.member_1[0u];
                                        let _e4864 = local_9.member[0u];
                                        let _e4870 = local_9.member_2[0u];
                                        let _e4871 = ((_e4858 + ((_e4861 - _e4864) * _e4014)) - _e4870);
                                        let _e4874 = local_9.member[1u];
                                        let _e4877 = local_9.member_1[1u];
                                        let _e4880 = local_9.member[1u];
                                        let _e4886 = local_9.member_2[1u];
                                        let _e4887 = ((_e4874 + ((_e4877 - _e4880) * _e4014)) - _e4886);
                                        if (_e4871 < _e4887) {
                                            phi_3445_ = _e4871;
                                        } else {
                                            phi_3445_ = _e4887;
                                        }
                                        let _e4890 = phi_3445_;
                                        let _e4893 = local_9.member[2u];
                                        let _e4896 = local_9.member_1[2u];
                                        let _e4899 = local_9.member[2u];
                                        let _e4905 = local_9.member_2[2u];
                                        let _e4906 = ((_e4893 + ((_e4896 - _e4899) * _e4014)) - _e4905);
                                        let _e4909 = local_9.member[3u];
                                        let _e4912 = local_9.member_1[3u];
                                        let _e4915 = local_9.member[3u];
                                        let _e4921 = local_9.member_2[3u];
                                        let _e4922 = ((_e4909 + ((_e4912 - _e4915) * _e4014)) - _e4921);
                                        if (_e4906 < _e4922) {
                                            phi_3518_ = _e4906;
                                        } else {
                                            phi_3518_ = _e4922;
                                        }
                                        let _e4925 = phi_3518_;
                                        if (_e4890 < _e4925) {
                                            phi_3523_ = _e4890;
                                        } else {
                                            phi_3523_ = _e4925;
                                        }
                                        let _e4928 = phi_3523_;
                                        let _e4931 = local_10.member[0u];
                                        let _e4934 = local_10.member_1[0u];
                                        let _e4937 = local_10.member[0u];
                                        let _e4943 = local_10.member_2[0u];
                                        let _e4944 = ((_e4931 + ((_e4934 - _e4937) * _e4010)) - _e4943);
                                        let _e4947 = local_10.member[1u];
                                        let _e4950 = local_10.member_1[1u];
                                        let _e4953 = local_10.member[1u];
                                        let _e4959 = local_10.member_2[1u];
                                        let _e4960 = ((_e4947 + ((_e4950 - _e4953) * _e4010)) - _e4959);
                                        if (_e4944 < _e4960) {
                                            phi_3596_ = _e4944;
                                        } else {
                                            phi_3596_ = _e4960;
                                        }
                                        let _e4963 = phi_3596_;
                                        let _e4966 = local_10.member[2u];
                                        let _e4969 = local_10.member_1[2u];
                                        let _e4972 = local_10.member[2u];
                                        let _e4978 = local_10.member_2[2u];
                                        let _e4979 = ((_e4966 + ((_e4969 - _e4972) * _e4010)) - _e4978);
                                        let _e4982 = local_10.member[3u];
                                        let _e4985 = local_10.member_1[3u];
                                        let _e4988 = local_10.member[3u];
                                        let _e4994 = local_10.member_2[3u];
                                        let _e4995 = ((_e4982 + ((_e4985 - _e4988) * _e4010)) - _e4994);
                                        if (_e4979 < _e4995) {
                                            phi_3669_ = _e4979;
                                        } else {
                                            phi_3669_ = _e4995;
                                        }
                                        let _e4998 = phi_3669_;
                                        if (_e4963 < _e4998) {
                                            phi_3674_ = _e4963;
                                        } else {
                                            phi_3674_ = _e4998;
                                        }
                                        let _e5001 = phi_3674_;
                                        let _e5002 = f64(0.0625f);
                                        let _e5004 = f64(0.9f);
                                        if (_e5001 > f64(0f)) {
                                            phi_3697_ = f64(0.5f);
                                        } else {
                                            let _e5010 = (f64(0.95f) * (_e4928 / (_e4928 - _e5001)));
                                            if (_e5010 > _e5002) {
                                                if (_e5010 < _e5004) {
                                                    phi_3695_ = _e5010;
                                                } else {
                                                    phi_3695_ = _e5004;
                                                }
                                                let _e5014 = phi_3695_;
                                                phi_3696_ = _e5014;
                                            } else {
                                                phi_3696_ = _e5002;
                                            }
                                            let _e5016 = phi_3696_;
                                            phi_3697_ = _e5016;
                                        }
                                        let _e5018 = phi_3697_;
                                        phi_3699_ = u32();
                                        phi_3700_ = (_e4341 * _e5018);
                                        phi_3701_ = true;
                                        phi_3702_ = false;
                                        phi_3703_ = false;
                                    }
                                    let _e5025 = phi_3699_;
                                    let _e5027 = phi_3700_;
                                    let _e5029 = phi_3701_;
                                    let _e5031 = phi_3702_;
                                    let _e5033 = phi_3703_;
                                    phi_3704_ = _e5025;
                                    phi_3705_ = _e4012;
                                    phi_3706_ = _e5027;
                                    phi_3707_ = _e4014;
                                    phi_3708_ = _e4016;
                                    phi_3709_ = _e4018;
                                    phi_3710_ = _e5029;
                                    phi_3711_ = _e5031;
                                    phi_3712_ = _e5033;
                                    phi_3713_ = false;
                                    phi_3714_ = false;
                                } else {
                                    phi_3704_ = u32();
                                    phi_3705_ = _e4844;
                                    phi_3706_ = _e4846;
                                    phi_3707_ = _e4010;
                                    phi_3708_ = true;
                                    phi_3709_ = 0u;
                                    phi_3710_ = _e4850;
                                    phi_3711_ = false;
                                    phi_3712_ = false;
                                    phi_3713_ = _e4852;
                                    phi_3714_ = _e4854;
                                }
                                let _e5035 = phi_3704_;
                                let _e5037 = phi_3705_;
                                let _e5039 = phi_3706_;
                                let _e5041 = phi_3707_;
                                let _e5043 = phi_3708_;
                                let _e5045 = phi_3709_;
                                let _e5047 = phi_3710_;
                                let _e5049 = phi_3711_;
                                let _e5051 = phi_3712_;
                                let _e5053 = phi_3713_;
                                let _e5055 = phi_3714_;
                                if _e5047 {
                                    let _e5056 = (_e5041 + _e5039);
                                    if (_e5056 > _e5037) {
                                        phi_3723_ = _e5056;
                                    } else {
                                        phi_3723_ = _e5037;
                                    }
                                    let _e5059 = phi_3723_;
                                    if (_e5059 < _e3770) {
                                        phi_3728_ = _e5059;
                                    } else {
                                        phi_3728_ = _e3770;
                                    }
                                    let _e5062 = phi_3728_;
                                    if !(_e4016) {
                                        phi_3738_ = true;
                                    } else {
                                        phi_3738_ = ((_e5062 - _e5041) > f64(0.0000000037252903f));
                                    }
                                    let _e5067 = phi_3738_;
                                    if _e5067 {
                                        phi_3742_ = false;
                                    } else {
                                        phi_3742_ = true;
                                    }
                                    let _e5069 = phi_3742_;
                                    phi_3743_ = _e5062;
                                    phi_3744_ = _e5037;
                                    phi_3745_ = _e5041;
                                    phi_3746_ = _e5043;
                                    phi_3747_ = _e5045;
                                    phi_3748_ = _e5067;
                                    phi_3749_ = _e5069;
                                    phi_3750_ = false;
                                    phi_3751_ = false;
                                    phi_3752_ = false;
                                } else {
                                    phi_3743_ = _e4010;
                                    phi_3744_ = _e4012;
                                    phi_3745_ = _e4014;
                                    phi_3746_ = _e4016;
                                    phi_3747_ = _e5035;
                                    phi_3748_ = _e5049;
                                    phi_3749_ = false;
                                    phi_3750_ = _e5051;
                                    phi_3751_ = _e5053;
                                    phi_3752_ = _e5055;
                                }
                                let _e5071 = phi_3743_;
                                let _e5073 = phi_3744_;
                                let _e5075 = phi_3745_;
                                let _e5077 = phi_3746_;
                                let _e5079 = phi_3747_;
                                let _e5081 = phi_3748_;
                                let _e5083 = phi_3749_;
                                let _e5085 = phi_3750_;
                                let _e5087 = phi_3751_;
                                let _e5089 = phi_3752_;
                                phi_2053_ = _e5071;
                                phi_2055_ = _e5073;
                                phi_2057_ = _e5075;
                                phi_2059_ = _e5077;
                                phi_2061_ = _e5079;
                                phi_3753_ = _e5037;
                                phi_3754_ = _e5081;
                                phi_3755_ = _e5083;
                                phi_3756_ = false;
                                phi_3757_ = _e5085;
                                phi_3758_ = _e5087;
                                phi_3759_ = _e5089;
                            } else {
                                phi_2053_ = f64();
                                phi_2055_ = f64();
                                phi_2057_ = f64();
                                phi_2059_ = bool();
                                phi_2061_ = u32();
                                phi_3753_ = f64();
                                phi_3754_ = false;
                                phi_3755_ = false;
                                phi_3756_ = true;
                                phi_3757_ = false;
                                phi_3758_ = false;
                                phi_3759_ = false;
                            }
                            let _e5091 = phi_2053_;
                            let _e5093 = phi_2055_;
                            let _e5095 = phi_2057_;
                            let _e5097 = phi_2059_;
                            let _e5099 = phi_2061_;
                            let _e5101 = phi_3753_;
                            let _e5103 = phi_3754_;
                            let _e5105 = phi_3755_;
                            let _e5107 = phi_3756_;
                            let _e5109 = phi_3757_;
                            let _e5111 = phi_3758_;
                            let _e5113 = phi_3759_;
                            local_25 = _e5105;
                            local_43 = _e5101;
                            local_45 = _e5107;
                            local_46 = _e5109;
                            local_47 = _e5111;
                            local_48 = _e5113;
                            continue;
                            continuing {
                                phi_2049_ = _e4030;
                                phi_2052_ = _e5091;
                                phi_2054_ = _e5093;
                                phi_2056_ = _e5095;
                                phi_2058_ = _e5097;
                                phi_2060_ = _e5099;
                                break if !(_e5103);
                            }
                        }
                        let _e5116 = local_25;
                        if _e5116 {
                            let _e6441 = local_43;
                            phi_3763_ = _e6441;
                            phi_3764_ = true;
                            phi_3765_ = false;
                            phi_3766_ = false;
                            phi_3767_ = false;
                        } else {
                            let _e6443 = local_44;
                            phi_3763_ = _e6443;
                            let _e6446 = local_45;
                            phi_3764_ = _e6446;
                            let _e6449 = local_46;
                            phi_3765_ = _e6449;
                            let _e6452 = local_47;
                            phi_3766_ = _e6452;
                            let _e6455 = local_48;
                            phi_3767_ = _e6455;
                        }
                        let _e5118 = phi_3763_;
                        let _e5120 = phi_3764_;
                        let _e5122 = phi_3765_;
                        let _e5124 = phi_3766_;
                        let _e5126 = phi_3767_;
                        if _e5120 {
                            phi_3772_ = type_44(1u, _e5118);
                            phi_3773_ = false;
                            phi_3774_ = false;
                            phi_3775_ = false;
                        } else {
                            phi_3772_ = type_44();
                            phi_3773_ = _e5122;
                            phi_3774_ = _e5124;
                            phi_3775_ = _e5126;
                        }
                        let _e5129 = phi_3772_;
                        let _e5131 = phi_3773_;
                        let _e5133 = phi_3774_;
                        let _e5135 = phi_3775_;
                        if _e5131 {
                            let _e5137 = local_26;
                            phi_3780_ = type_44(1u, _e5137);
                            phi_3781_ = false;
                            phi_3782_ = false;
                        } else {
                            phi_3780_ = type_44();
                            phi_3781_ = _e5133;
                            phi_3782_ = _e5135;
                        }
                        let _e5140 = phi_3780_;
                        let _e5142 = phi_3781_;
                        let _e5144 = phi_3782_;
                        if _e5142 {
                            phi_3787_ = type_44(0u, type_44().member_1);
                            phi_3788_ = false;
                            phi_3789_ = true;
                        } else {
                            phi_3787_ = _e5140;
                            phi_3788_ = _e5144;
                            phi_3789_ = _e5131;
                        }
                        let _e5148 = phi_3787_;
                        let _e5150 = phi_3788_;
                        let _e5152 = phi_3789_;
                        if _e5150 {
                            phi_3794_ = type_44(0u, type_44().member_1);
                            phi_3795_ = true;
                        } else {
                            phi_3794_ = _e5148;
                            phi_3795_ = _e5152;
                        }
                        let _e5156 = phi_3794_;
                        let _e5158 = phi_3795_;
                        if _e5158 {
                            phi_3799_ = _e5156;
                        } else {
                            phi_3799_ = _e5129;
                        }
                        let _e5160 = phi_3799_;
                        if (_e5160.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_3813_ = type_9(0u, 3u);
                            loop {
                                let _e5172 = phi_3813_;
                                if (_e5172.member < _e5172.member_1) {
                                    phi_3814_ = type_9((_e5172.member + 1u), _e5172.member_1);
                                    phi_3837_ = type_9(1u, _e5172.member);
                                } else {
                                    phi_3814_ = _e5172;
                                    phi_3837_ = type_9(0u, type_9().member_1);
                                }
                                let _e5184 = phi_3814_;
                                let _e5186 = phi_3837_;
                                if (bitcast<i32>(_e5186.member) != 0i) {
                                    let _e5192 = local_11[_e5186.member_1];
                                    let _e5194 = (_e5160.member_1 + f64(_e5192));
                                    if (_e5194 < _e3770) {
                                        phi_3858_ = _e5194;
                                    } else {
                                        phi_3858_ = _e3770;
                                    }
                                    let _e5197 = phi_3858_;
                                    let _e5200 = local_12.member[0u];
                                    let _e5206 = local_12.member[1u];
                                    let _e5222 = local_12.member_1[0u];
                                    let _e5228 = local_12.member_1[1u];
                                    let _e5244 = local_12.member_2[0u];
                                    let _e5250 = local_12.member_2[1u];
                                    let _e5264 = function_2(array<f64, 3>((_e5200[0] + ((_e5206[0] - _e5200[0]) * _e5197)), (_e5200[1] + ((_e5206[1] - _e5200[1]) * _e5197)), (_e5200[2] + ((_e5206[2] - _e5200[2]) * _e5197))), array<f64, 3>((_e5222[0] + ((_e5228[0] - _e5222[0]) * _e5197)), (_e5222[1] + ((_e5228[1] - _e5222[1]) * _e5197)), (_e5222[2] + ((_e5228[2] - _e5222[2]) * _e5197))), array<f64, 3>((_e5244[0] + ((_e5250[0] - _e5244[0]) * _e5197)), (_e5244[1] + ((_e5250[1] - _e5244[1]) * _e5197)), (_e5244[2] + ((_e5250[2] - _e5244[2]) * _e5197))), 1u);
                                    let _e5275 = (((_e5264[0] * _e5264[0]) + (_e5264[1] * _e5264[1])) + (_e5264[2] * _e5264[2]));
                                    if (_e5275 <= 2.2250738585072014e-308lf) {
                                        if (_e5275 > 0.0lf) {
                                            phi_3981_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3981_ = 0.0lf;
                                        }
                                        let _e5327 = phi_3981_;
                                        phi_4045_ = _e5327;
                                    } else {
                                        phi_3988_ = type_16(0i, 5i);
                                        phi_3991_ = bitcast<f64>(((bitcast<u64>(_e5275) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e5282 = phi_3988_;
                                            let _e5284 = phi_3991_;
                                            local_27 = _e5284;
                                            if (_e5282.member < _e5282.member_1) {
                                                let _e5291 = (_e5282.member + 1i);
                                                if ((false == (_e5291 > _e5282.member)) != false) {
                                                    phi_4012_ = true;
                                                } else {
                                                    phi_4012_ = false;
                                                }
                                                let _e5296 = phi_4012_;
                                                if _e5296 {
                                                    phi_4018_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_4018_ = type_17(1u, _e5291);
                                                }
                                                let _e5301 = phi_4018_;
                                                phi_3989_ = type_16(_e5301.member_1, _e5282.member_1);
                                                phi_4032_ = type_17(1u, _e5282.member);
                                            } else {
                                                phi_3989_ = _e5282;
                                                phi_4032_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e5307 = phi_3989_;
                                            let _e5309 = phi_4032_;
                                            let _e5312 = (bitcast<i32>(_e5309.member) != 0i);
                                            if _e5312 {
                                                phi_3992_ = (0.5lf * (_e5284 + (_e5275 / _e5284)));
                                            } else {
                                                phi_3992_ = f64();
                                            }
                                            let _e5317 = phi_3992_;
                                            continue;
                                            continuing {
                                                phi_3988_ = _e5307;
                                                phi_3991_ = _e5317;
                                                break if !(_e5312);
                                            }
                                        }
                                        let _e5322 = local_27;
                                        phi_4045_ = (_e5322 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e5329 = phi_4045_;
                                    let _e5337 = local_12.member[0u];
                                    if (_e5337[0] < 0.0lf) {
                                        phi_4063_ = -(_e5337[0]);
                                    } else {
                                        phi_4063_ = _e5337[0];
                                    }
                                    let _e5344 = phi_4063_;
                                    if (_e5337[1] < 0.0lf) {
                                        phi_4070_ = -(_e5337[1]);
                                    } else {
                                        phi_4070_ = _e5337[1];
                                    }
                                    let _e5348 = phi_4070_;
                                    if (_e5344 > _e5348) {
                                        phi_4075_ = _e5344;
                                    } else {
                                        phi_4075_ = _e5348;
                                    }
                                    let _e5351 = phi_4075_;
                                    if (_e5337[2] < 0.0lf) {
                                        phi_4082_ = -(_e5337[2]);
                                    } else {
                                        phi_4082_ = _e5337[2];
                                    }
                                    let _e5355 = phi_4082_;
                                    if (_e5351 > _e5355) {
                                        phi_4087_ = _e5351;
                                    } else {
                                        phi_4087_ = _e5355;
                                    }
                                    let _e5358 = phi_4087_;
                                    let _e5361 = local_12.member[1u];
                                    if (_e5361[0] < 0.0lf) {
                                        phi_4100_ = -(_e5361[0]);
                                    } else {
                                        phi_4100_ = _e5361[0];
                                    }
                                    let _e5368 = phi_4100_;
                                    if (_e5361[1] < 0.0lf) {
                                        phi_4107_ = -(_e5361[1]);
                                    } else {
                                        phi_4107_ = _e5361[1];
                                    }
                                    let _e5372 = phi_4107_;
                                    if (_e5368 > _e5372) {
                                        phi_4112_ = _e5368;
                                    } else {
                                        phi_4112_ = _e5372;
                                    }
                                    let _e5375 = phi_4112_;
                                    if (_e5361[2] < 0.0lf) {
                                        phi_4119_ = -(_e5361[2]);
                                    } else {
                                        phi_4119_ = _e5361[2];
                                    }
                                    let _e5379 = phi_4119_;
                                    if (_e5375 > _e5379) {
                                        phi_4124_ = _e5375;
                                    } else {
                                        phi_4124_ = _e5379;
                                    }
                                    let _e5382 = phi_4124_;
                                    if (_e5358 > _e5382) {
                                        phi_4129_ = _e5358;
                                    } else {
                                        phi_4129_ = _e5382;
                                    }
                                    let _e5385 = phi_4129_;
                                    let _e5387 = local_12.member_3;
                                    let _e5391 = local_12.member_1[0u];
                                    if (_e5391[0] < 0.0lf) {
                                        phi_4146_ = -(_e5391[0]);
                                    } else {
                                        phi_4146_ = _e5391[0];
                                    }
                                    let _e5398 = phi_4146_;
                                    if (_e5391[1] < 0.0lf) {
                                        phi_4153_ = -(_e5391[1]);
                                    } else {
                                        phi_4153_ = _e5391[1];
                                    }
                                    let _e5402 = phi_4153_;
                                    if (_e5398 > _e5402) {
                                        phi_4158_ = _e5398;
                                    } else {
                                        phi_4158_ = _e5402;
                                    }
                                    let _e5405 = phi_4158_;
                                    if (_e5391[2] < 0.0lf) {
                                        phi_4165_ = -(_e5391[2]);
                                    } else {
                                        phi_4165_ = _e5391[2];
                                    }
                                    let _e5409 = phi_4165_;
                                    if (_e5405 > _e5409) {
                                        phi_4170_ = _e5405;
                                    } else {
                                        phi_4170_ = _e5409;
                                    }
                                    let _e5412 = phi_4170_;
                                    let _e5415 = local_12.member_1[1u];
                                    if (_e5415[0] < 0.0lf) {
                                        phi_4184_ = -(_e5415[0]);
                                    } else {
                                        phi_4184_ = _e5415[0];
                                    }
                                    let _e5422 = phi_4184_;
                                    if (_e5415[1] < 0.0lf) {
                                        phi_4191_ = -(_e5415[1]);
                                    } else {
                                        phi_4191_ = _e5415[1];
                                    }
                                    let _e5426 = phi_4191_;
                                    if (_e5422 > _e5426) {
                                        phi_4196_ = _e5422;
                                    } else {
                                        phi_4196_ = _e5426;
                                    }
                                    let _e5429 = phi_4196_;
                                    if (_e5415[2] < 0.0lf) {
                                        phi_4203_ = -(_e5415[2]);
                                    } else {
                                        phi_4203_ = _e5415[2];
                                    }
                                    let _e5433 = phi_4203_;
                                    if (_e5429 > _e5433) {
                                        phi_4208_ = _e5429;
                                    } else {
                                        phi_4208_ = _e5433;
                                    }
                                    let _e5436 = phi_4208_;
                                    if (_e5412 > _e5436) {
                                        phi_4213_ = _e5412;
                                    } else {
                                        phi_4213_ = _e5436;
                                    }
                                    let _e5439 = phi_4213_;
                                    let _e5441 = local_12.member_3;
                                    let _e5445 = local_12.member_2[0u];
                                    if (_e5445[0] < 0.0lf) {
                                        phi_4230_ = -(_e5445[0]);
                                    } else {
                                        phi_4230_ = _e5445[0];
                                    }
                                    let _e5452 = phi_4230_;
                                    if (_e5445[1] < 0.0lf) {
                                        phi_4237_ = -(_e5445[1]);
                                    } else {
                                        phi_4237_ = _e5445[1];
                                    }
                                    let _e5456 = phi_4237_;
                                    if (_e5452 > _e5456) {
                                        phi_4242_ = _e5452;
                                    } else {
                                        phi_4242_ = _e5456;
                                    }
                                    let _e5459 = phi_4242_;
                                    if (_e5445[2] < 0.0lf) {
                                        phi_4249_ = -(_e5445[2]);
                                    } else {
                                        phi_4249_ = _e5445[2];
                                    }
                                    let _e5463 = phi_4249_;
                                    if (_e5459 > _e5463) {
                                        phi_4254_ = _e5459;
                                    } else {
                                        phi_4254_ = _e5463;
                                    }
                                    let _e5466 = phi_4254_;
                                    let _e5469 = local_12.member_2[1u];
                                    if (_e5469[0] < 0.0lf) {
                                        phi_4268_ = -(_e5469[0]);
                                    } else {
                                        phi_4268_ = _e5469[0];
                                    }
                                    let _e5476 = phi_4268_;
                                    if (_e5469[1] < 0.0lf) {
                                        phi_4275_ = -(_e5469[1]);
                                    } else {
                                        phi_4275_ = _e5469[1];
                                    }
                                    let _e5480 = phi_4275_;
                                    if (_e5476 > _e5480) {
                                        phi_4280_ = _e5476;
                                    } else {
                                        phi_4280_ = _e5480;
                                    }
                                    let _e5483 = phi_4280_;
                                    if (_e5469[2] < 0.0lf) {
                                        phi_4287_ = -(_e5469[2]);
                                    } else {
                                        phi_4287_ = _e5469[2];
                                    }
                                    let _e5487 = phi_4287_;
                                    if (_e5483 > _e5487) {
                                        phi_4292_ = _e5483;
                                    } else {
                                        phi_4292_ = _e5487;
                                    }
                                    let _e5490 = phi_4292_;
                                    if (_e5466 > _e5490) {
                                        phi_4297_ = _e5466;
                                    } else {
                                        phi_4297_ = _e5490;
                                    }
                                    let _e5493 = phi_4297_;
                                    let _e5495 = local_12.member_3;
                                    let _e5503 = local_12.member_3;
                                    let _e5513 = (((_e5329 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5385 + _e5387) + (_e5439 + _e5441)) + (_e5493 + _e5495)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5503 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e578.member_1);
                                    if _e5513 {
                                        phi_4321_ = false;
                                    } else {
                                        phi_4321_ = true;
                                    }
                                    let _e5515 = phi_4321_;
                                    phi_4322_ = _e5515;
                                    phi_4323_ = _e5513;
                                } else {
                                    phi_4322_ = false;
                                    phi_4323_ = false;
                                }
                                let _e5517 = phi_4322_;
                                let _e5519 = phi_4323_;
                                local_28 = _e5519;
                                continue;
                                continuing {
                                    phi_3813_ = _e5184;
                                    break if !(_e5517);
                                }
                            }
                            let _e5522 = local_28;
                            if _e5522 {
                                phi_4328_ = type_44(1u, _e5160.member_1);
                                phi_4329_ = false;
                            } else {
                                phi_4328_ = type_44();
                                phi_4329_ = true;
                            }
                            let _e5525 = phi_4328_;
                            let _e5527 = phi_4329_;
                            if _e5527 {
                                phi_4334_ = type_44(2u, _e5160.member_1);
                                phi_4335_ = false;
                            } else {
                                phi_4334_ = type_44();
                                phi_4335_ = true;
                            }
                            let _e5530 = phi_4334_;
                            let _e5532 = phi_4335_;
                            phi_4337_ = _e5530;
                            phi_4338_ = _e5525;
                            phi_4339_ = _e5532;
                        } else {
                            phi_4337_ = type_44();
                            phi_4338_ = type_44(0u, type_44().member_1);
                            phi_4339_ = true;
                        }
                        let _e5534 = phi_4337_;
                        let _e5536 = phi_4338_;
                        let _e5538 = phi_4339_;
                        if _e5538 {
                            phi_4343_ = _e5536;
                        } else {
                            phi_4343_ = _e5534;
                        }
                        let _e5540 = phi_4343_;
                        phi_8356_ = _e5540;
                    } else {
                        if (_e716 < 0.0lf) {
                            phi_4354_ = -(_e716);
                        } else {
                            phi_4354_ = _e716;
                        }
                        let _e1073 = phi_4354_;
                        if (_e739 < 0.0lf) {
                            phi_4360_ = -(_e739);
                        } else {
                            phi_4360_ = _e739;
                        }
                        let _e1077 = phi_4360_;
                        if (_e1073 > _e1077) {
                            phi_4365_ = _e1073;
                        } else {
                            phi_4365_ = _e1077;
                        }
                        let _e1080 = phi_4365_;
                        if (_e762 < 0.0lf) {
                            phi_4371_ = -(_e762);
                        } else {
                            phi_4371_ = _e762;
                        }
                        let _e1084 = phi_4371_;
                        if (_e773 < 0.0lf) {
                            phi_4377_ = -(_e773);
                        } else {
                            phi_4377_ = _e773;
                        }
                        let _e1088 = phi_4377_;
                        if (_e1084 > _e1088) {
                            phi_4382_ = _e1084;
                        } else {
                            phi_4382_ = _e1088;
                        }
                        let _e1091 = phi_4382_;
                        if (_e1080 > _e1091) {
                            phi_4387_ = _e1080;
                        } else {
                            phi_4387_ = _e1091;
                        }
                        let _e1094 = phi_4387_;
                        let _e1096 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1097 = f64(1f);
                        if (_e1094 >= _e1096) {
                            phi_4397_ = (_e1094 <= (_e1097 / _e1096));
                        } else {
                            phi_4397_ = false;
                        }
                        let _e1102 = phi_4397_;
                        if _e1102 {
                            phi_4404_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4404_ = f64(2f);
                        }
                        let _e1107 = phi_4404_;
                        let _e1109 = ((_e1032 * f64(0.34f)) + (_e1094 * _e1107));
                        if _e1102 {
                            phi_4412_ = (_e1097 / _e1094);
                        } else {
                            phi_4412_ = f64(0f);
                        }
                        let _e1113 = phi_4412_;
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
                                    phi_4448_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4448_ = 0.0lf;
                                }
                                let _e1184 = phi_4448_;
                                phi_4512_ = _e1184;
                            } else {
                                phi_4455_ = type_16(0i, 5i);
                                phi_4458_ = bitcast<f64>(((bitcast<u64>(_e1131) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1139 = phi_4455_;
                                    let _e1141 = phi_4458_;
                                    local_13 = _e1141;
                                    if (_e1139.member < _e1139.member_1) {
                                        let _e1148 = (_e1139.member + 1i);
                                        if ((false == (_e1148 > _e1139.member)) != false) {
                                            phi_4479_ = true;
                                        } else {
                                            phi_4479_ = false;
                                        }
                                        let _e1153 = phi_4479_;
                                        if _e1153 {
                                            phi_4485_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_4485_ = type_17(1u, _e1148);
                                        }
                                        let _e1158 = phi_4485_;
                                        phi_4456_ = type_16(_e1158.member_1, _e1139.member_1);
                                        phi_4499_ = type_17(1u, _e1139.member);
                                    } else {
                                        phi_4456_ = _e1139;
                                        phi_4499_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e1164 = phi_4456_;
                                    let _e1166 = phi_4499_;
                                    let _e1169 = (bitcast<i32>(_e1166.member) != 0i);
                                    if _e1169 {
                                        phi_4459_ = (0.5lf * (_e1141 + (_e1131 / _e1141)));
                                    } else {
                                        phi_4459_ = f64();
                                    }
                                    let _e1174 = phi_4459_;
                                    continue;
                                    continuing {
                                        phi_4455_ = _e1164;
                                        phi_4458_ = _e1174;
                                        break if !(_e1169);
                                    }
                                }
                                let _e1179 = local_13;
                                phi_4512_ = (_e1179 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1186 = phi_4512_;
                            if (_e1123 < _e1114) {
                                phi_4518_ = -(_e1186);
                            } else {
                                phi_4518_ = _e1186;
                            }
                            let _e1190 = phi_4518_;
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
                            phi_4543_ = type_9(0u, 2u);
                            phi_4546_ = 1u;
                            loop {
                                let _e1211 = phi_4543_;
                                let _e1213 = phi_4546_;
                                local_29 = _e1213;
                                if (_e1211.member < _e1211.member_1) {
                                    phi_4544_ = type_9((_e1211.member + 1u), _e1211.member_1);
                                    phi_4569_ = type_9(1u, _e1211.member);
                                } else {
                                    phi_4544_ = _e1211;
                                    phi_4569_ = type_9(0u, type_9().member_1);
                                }
                                let _e1225 = phi_4544_;
                                let _e1227 = phi_4569_;
                                let _e1231 = (bitcast<i32>(_e1227.member) != 0i);
                                if _e1231 {
                                    let _e1233 = local_7[_e1227.member_1];
                                    if (_e1233 > _e1114) {
                                        let _e1236 = local_7[_e1227.member_1];
                                        if (_e1236 < _e1115) {
                                            let _e1239 = local_7[_e1227.member_1];
                                            local_6[_e1213] = _e1239;
                                            phi_4613_ = (_e1213 + 1u);
                                        } else {
                                            phi_4613_ = _e1213;
                                        }
                                        let _e1243 = phi_4613_;
                                        phi_4614_ = _e1243;
                                    } else {
                                        phi_4614_ = _e1213;
                                    }
                                    let _e1245 = phi_4614_;
                                    phi_4547_ = _e1245;
                                } else {
                                    phi_4547_ = u32();
                                }
                                let _e1247 = phi_4547_;
                                continue;
                                continuing {
                                    phi_4543_ = _e1225;
                                    phi_4546_ = _e1247;
                                    break if !(_e1231);
                                }
                            }
                            let _e5766 = local_29;
                            phi_4615_ = _e5766;
                        } else {
                            phi_4615_ = 1u;
                        }
                        let _e1250 = phi_4615_;
                        local_6[_e1250] = _e1115;
                        let _e1252 = local_6;
                        local_8 = _e1252;
                        phi_4635_ = type_9(0u, _e1250);
                        loop {
                            let _e1255 = phi_4635_;
                            if (_e1255.member < _e1255.member_1) {
                                phi_4636_ = type_9((_e1255.member + 1u), _e1255.member_1);
                                phi_4659_ = type_9(1u, _e1255.member);
                            } else {
                                phi_4636_ = _e1255;
                                phi_4659_ = type_9(0u, type_9().member_1);
                            }
                            let _e1267 = phi_4636_;
                            let _e1269 = phi_4659_;
                            if (bitcast<i32>(_e1269.member) != 0i) {
                                let _e1275 = local_8[_e1269.member_1];
                                let _e1278 = local_8[(_e1269.member_1 + 1u)];
                                let _e1280 = (f64(1f) - _e1275);
                                let _e1291 = ((((_e716 * _e1280) + (_e739 * _e1275)) * (_e1280 * _e1280)) + (((_e762 * _e1280) + (_e773 * _e1275)) * (_e1275 * _e1275)));
                                let _e1293 = (f64(1f) - _e1278);
                                let _e1304 = ((((_e716 * _e1293) + (_e739 * _e1278)) * (_e1293 * _e1293)) + (((_e762 * _e1293) + (_e773 * _e1278)) * (_e1278 * _e1278)));
                                if (_e1291 < 0.0lf) {
                                    phi_4713_ = -(_e1291);
                                } else {
                                    phi_4713_ = _e1291;
                                }
                                let _e1308 = phi_4713_;
                                let _e1309 = (_e1308 > _e1109);
                                if (_e1304 < 0.0lf) {
                                    phi_4720_ = -(_e1304);
                                } else {
                                    phi_4720_ = _e1304;
                                }
                                let _e1313 = phi_4720_;
                                let _e1314 = (_e1313 > _e1109);
                                let _e1315 = f64(0f);
                                if _e1309 {
                                    if _e1314 {
                                        phi_4732_ = ((_e1291 > _e1315) != (_e1304 > _e1315));
                                        phi_4733_ = false;
                                    } else {
                                        phi_4732_ = bool();
                                        phi_4733_ = true;
                                    }
                                    let _e1320 = phi_4732_;
                                    let _e1322 = phi_4733_;
                                    phi_4734_ = _e1320;
                                    phi_4735_ = _e1322;
                                } else {
                                    phi_4734_ = bool();
                                    phi_4735_ = true;
                                }
                                let _e1324 = phi_4734_;
                                let _e1326 = phi_4735_;
                                if _e1326 {
                                    phi_4739_ = false;
                                } else {
                                    phi_4739_ = _e1324;
                                }
                                let _e1328 = phi_4739_;
                                if _e1309 {
                                    if _e1314 {
                                        if _e1328 {
                                            phi_4751_ = type_45();
                                        } else {
                                            phi_4751_ = type_45(f64(1f), _e1315, _e1328);
                                        }
                                        let _e1332 = phi_4751_;
                                        phi_4752_ = _e1332;
                                        phi_4753_ = _e1328;
                                    } else {
                                        phi_4752_ = type_45();
                                        phi_4753_ = true;
                                    }
                                    let _e1334 = phi_4752_;
                                    let _e1336 = phi_4753_;
                                    phi_4754_ = _e1334;
                                    phi_4755_ = _e1336;
                                } else {
                                    phi_4754_ = type_45();
                                    phi_4755_ = true;
                                }
                                let _e1338 = phi_4754_;
                                let _e1340 = phi_4755_;
                                if _e1340 {
                                    if _e1309 {
                                        if (_e1291 < _e1315) {
                                            phi_4768_ = f64(-1f);
                                        } else {
                                            phi_4768_ = f64(1f);
                                        }
                                        let _e1345 = phi_4768_;
                                        let _e1346 = f64(0.00000000000022737368f);
                                        let _e1347 = f64(0.5f);
                                        let _e1348 = f64(3f);
                                        let _e1351 = (_e762 - _e739);
                                        phi_4781_ = type_9(0u, 64u);
                                        phi_4784_ = _e1278;
                                        phi_4786_ = _e1275;
                                        phi_4788_ = (_e1347 * (_e1275 + _e1278));
                                        loop {
                                            let _e1357 = phi_4781_;
                                            let _e1359 = phi_4784_;
                                            let _e1361 = phi_4786_;
                                            let _e1363 = phi_4788_;
                                            local_31 = _e1361;
                                            if (_e1357.member < _e1357.member_1) {
                                                phi_4782_ = type_9((_e1357.member + 1u), _e1357.member_1);
                                                phi_4811_ = type_9(1u, _e1357.member);
                                            } else {
                                                phi_4782_ = _e1357;
                                                phi_4811_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1375 = phi_4782_;
                                            let _e1377 = phi_4811_;
                                            if (bitcast<i32>(_e1377.member) != 0i) {
                                                let _e1382 = (f64(1f) - _e1363);
                                                let _e1395 = ((_e1345 * ((((_e716 * _e1382) + (_e739 * _e1363)) * (_e1382 * _e1382)) + (((_e762 * _e1382) + (_e773 * _e1363)) * (_e1363 * _e1363)))) - _e1109);
                                                if (_e1395 > f64(0f)) {
                                                    phi_4838_ = _e1359;
                                                    phi_4839_ = _e1363;
                                                } else {
                                                    phi_4838_ = _e1363;
                                                    phi_4839_ = _e1361;
                                                }
                                                let _e1399 = phi_4838_;
                                                let _e1401 = phi_4839_;
                                                let _e1403 = ((_e1399 - _e1401) > _e1346);
                                                if _e1403 {
                                                    let _e1405 = (f64(1f) - _e1363);
                                                    let _e1417 = (-(_e1395) / (_e1345 * (((((_e739 - (_e1348 * _e716)) * _e1405) + (_e1351 * _e1363)) * _e1405) + (((_e1351 * _e1405) + (((_e1348 * _e773) - _e762) * _e1363)) * _e1363))));
                                                    if (_e1395 > f64(0f)) {
                                                        phi_4867_ = (_e1347 * _e1346);
                                                    } else {
                                                        phi_4867_ = -((_e1347 * _e1346));
                                                    }
                                                    let _e1424 = phi_4867_;
                                                    let _e1426 = ((_e1363 + _e1417) + _e1424);
                                                    if (_e1426 > _e1401) {
                                                        if (_e1426 < _e1399) {
                                                            if (_e1417 < 0.0lf) {
                                                                phi_4883_ = -(_e1417);
                                                            } else {
                                                                phi_4883_ = _e1417;
                                                            }
                                                            let _e1432 = phi_4883_;
                                                            if (_e1432 < (_e1347 * (_e1399 - _e1401))) {
                                                                phi_4890_ = false;
                                                            } else {
                                                                phi_4890_ = true;
                                                            }
                                                            let _e1437 = phi_4890_;
                                                            phi_4891_ = _e1437;
                                                        } else {
                                                            phi_4891_ = true;
                                                        }
                                                        let _e1439 = phi_4891_;
                                                        phi_4892_ = _e1439;
                                                    } else {
                                                        phi_4892_ = true;
                                                    }
                                                    let _e1441 = phi_4892_;
                                                    if _e1441 {
                                                        phi_4898_ = (_e1347 * (_e1401 + _e1399));
                                                    } else {
                                                        phi_4898_ = _e1426;
                                                    }
                                                    let _e1445 = phi_4898_;
                                                    phi_4899_ = _e1445;
                                                    phi_4900_ = false;
                                                } else {
                                                    phi_4899_ = f64();
                                                    phi_4900_ = true;
                                                }
                                                let _e1447 = phi_4899_;
                                                let _e1449 = phi_4900_;
                                                phi_4785_ = _e1399;
                                                phi_4787_ = _e1401;
                                                phi_4789_ = _e1447;
                                                phi_4901_ = _e1401;
                                                phi_4902_ = _e1403;
                                                phi_4903_ = _e1449;
                                            } else {
                                                phi_4785_ = f64();
                                                phi_4787_ = f64();
                                                phi_4789_ = f64();
                                                phi_4901_ = f64();
                                                phi_4902_ = false;
                                                phi_4903_ = false;
                                            }
                                            let _e1451 = phi_4785_;
                                            let _e1453 = phi_4787_;
                                            let _e1455 = phi_4789_;
                                            let _e1457 = phi_4901_;
                                            let _e1459 = phi_4902_;
                                            let _e1461 = phi_4903_;
                                            local_14 = _e1461;
                                            local_30 = _e1457;
                                            continue;
                                            continuing {
                                                phi_4781_ = _e1375;
                                                phi_4784_ = _e1451;
                                                phi_4786_ = _e1453;
                                                phi_4788_ = _e1455;
                                                break if !(_e1459);
                                            }
                                        }
                                        let _e1464 = local_14;
                                        if _e1464 {
                                            let _e5808 = local_30;
                                            phi_4907_ = _e5808;
                                        } else {
                                            let _e5810 = local_31;
                                            phi_4907_ = _e5810;
                                        }
                                        let _e1466 = phi_4907_;
                                        phi_4908_ = _e1466;
                                    } else {
                                        phi_4908_ = _e1275;
                                    }
                                    let _e1468 = phi_4908_;
                                    if _e1314 {
                                        if (_e1304 < _e1315) {
                                            phi_4918_ = f64(-1f);
                                        } else {
                                            phi_4918_ = f64(1f);
                                        }
                                        let _e1473 = phi_4918_;
                                        phi_4923_ = type_9(0u, 64u);
                                        phi_4926_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1477 = phi_4923_;
                                            let _e1479 = phi_4926_;
                                            if (_e1477.member < _e1477.member_1) {
                                                phi_4924_ = type_9((_e1477.member + 1u), _e1477.member_1);
                                                phi_4949_ = type_9(1u, _e1477.member);
                                            } else {
                                                phi_4924_ = _e1477;
                                                phi_4949_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1491 = phi_4924_;
                                            let _e1493 = phi_4949_;
                                            if (bitcast<i32>(_e1493.member) != 0i) {
                                                let _e1497 = (_e1468 + _e1479);
                                                if (_e1497 < _e1278) {
                                                    let _e1500 = (f64(1f) - _e1497);
                                                    let _e1513 = ((_e1473 * ((((_e716 * _e1500) + (_e739 * _e1497)) * (_e1500 * _e1500)) + (((_e762 * _e1500) + (_e773 * _e1497)) * (_e1497 * _e1497)))) > _e1109);
                                                    if _e1513 {
                                                        phi_4980_ = f64();
                                                        phi_4981_ = false;
                                                    } else {
                                                        phi_4980_ = (_e1479 + _e1479);
                                                        phi_4981_ = true;
                                                    }
                                                    let _e1516 = phi_4980_;
                                                    let _e1518 = phi_4981_;
                                                    phi_4982_ = _e1516;
                                                    phi_4983_ = _e1518;
                                                    phi_4984_ = _e1513;
                                                    phi_4985_ = false;
                                                } else {
                                                    phi_4982_ = f64();
                                                    phi_4983_ = false;
                                                    phi_4984_ = false;
                                                    phi_4985_ = true;
                                                }
                                                let _e1520 = phi_4982_;
                                                let _e1522 = phi_4983_;
                                                let _e1524 = phi_4984_;
                                                let _e1526 = phi_4985_;
                                                phi_4986_ = _e1497;
                                                phi_4927_ = _e1520;
                                                phi_4987_ = _e1522;
                                                phi_4988_ = _e1524;
                                                phi_4989_ = _e1526;
                                                phi_4990_ = false;
                                            } else {
                                                phi_4986_ = f64();
                                                phi_4927_ = f64();
                                                phi_4987_ = false;
                                                phi_4988_ = false;
                                                phi_4989_ = false;
                                                phi_4990_ = true;
                                            }
                                            let _e1528 = phi_4986_;
                                            let _e1530 = phi_4927_;
                                            let _e1532 = phi_4987_;
                                            let _e1534 = phi_4988_;
                                            let _e1536 = phi_4989_;
                                            let _e1538 = phi_4990_;
                                            local_15 = _e1534;
                                            local_32 = _e1536;
                                            local_33 = _e1538;
                                            local_34 = _e1528;
                                            continue;
                                            continuing {
                                                phi_4923_ = _e1491;
                                                phi_4926_ = _e1530;
                                                break if !(_e1532);
                                            }
                                        }
                                        let _e1541 = local_15;
                                        if _e1541 {
                                            phi_4994_ = false;
                                            phi_4995_ = false;
                                        } else {
                                            let _e5832 = local_32;
                                            phi_4994_ = _e5832;
                                            let _e5835 = local_33;
                                            phi_4995_ = _e5835;
                                        }
                                        let _e1543 = phi_4994_;
                                        let _e1545 = phi_4995_;
                                        if _e1543 {
                                            phi_4999_ = true;
                                        } else {
                                            phi_4999_ = _e1545;
                                        }
                                        let _e1547 = phi_4999_;
                                        if _e1547 {
                                            phi_5003_ = _e1278;
                                        } else {
                                            let _e5839 = local_34;
                                            phi_5003_ = _e5839;
                                        }
                                        let _e1549 = phi_5003_;
                                        phi_5004_ = _e1549;
                                    } else {
                                        phi_5004_ = _e1278;
                                    }
                                    let _e1551 = phi_5004_;
                                    phi_5006_ = type_45(_e1468, _e1551, _e1328);
                                } else {
                                    phi_5006_ = _e1338;
                                }
                                let _e1554 = phi_5006_;
                                if (_e1554.member > _e1554.member_1) {
                                    phi_8312_ = f64();
                                    phi_8313_ = true;
                                    phi_8314_ = false;
                                    phi_8315_ = false;
                                    phi_8316_ = false;
                                } else {
                                    let _e1562 = ((_e1554.member_1 - _e1554.member) * f64(0.5f));
                                    let _e1563 = (_e1554.member + _e1562);
                                    let _e1566 = (_e1562 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1568 = local_12.member_3;
                                    let _e1571 = local_12.member[0u];
                                    if (_e1571[0] < 0.0lf) {
                                        phi_5037_ = -(_e1571[0]);
                                    } else {
                                        phi_5037_ = _e1571[0];
                                    }
                                    let _e1578 = phi_5037_;
                                    if (_e1571[1] < 0.0lf) {
                                        phi_5044_ = -(_e1571[1]);
                                    } else {
                                        phi_5044_ = _e1571[1];
                                    }
                                    let _e1582 = phi_5044_;
                                    if (_e1578 > _e1582) {
                                        phi_5049_ = _e1578;
                                    } else {
                                        phi_5049_ = _e1582;
                                    }
                                    let _e1585 = phi_5049_;
                                    if (_e1571[2] < 0.0lf) {
                                        phi_5056_ = -(_e1571[2]);
                                    } else {
                                        phi_5056_ = _e1571[2];
                                    }
                                    let _e1589 = phi_5056_;
                                    if (_e1585 > _e1589) {
                                        phi_5061_ = _e1585;
                                    } else {
                                        phi_5061_ = _e1589;
                                    }
                                    let _e1592 = phi_5061_;
                                    let _e1594 = local_12.member[1u];
                                    if (_e1594[0] < 0.0lf) {
                                        phi_5074_ = -(_e1594[0]);
                                    } else {
                                        phi_5074_ = _e1594[0];
                                    }
                                    let _e1601 = phi_5074_;
                                    if (_e1594[1] < 0.0lf) {
                                        phi_5081_ = -(_e1594[1]);
                                    } else {
                                        phi_5081_ = _e1594[1];
                                    }
                                    let _e1605 = phi_5081_;
                                    if (_e1601 > _e1605) {
                                        phi_5086_ = _e1601;
                                    } else {
                                        phi_5086_ = _e1605;
                                    }
                                    let _e1608 = phi_5086_;
                                    if (_e1594[2] < 0.0lf) {
                                        phi_5093_ = -(_e1594[2]);
                                    } else {
                                        phi_5093_ = _e1594[2];
                                    }
                                    let _e1612 = phi_5093_;
                                    if (_e1608 > _e1612) {
                                        phi_5098_ = _e1608;
                                    } else {
                                        phi_5098_ = _e1612;
                                    }
                                    let _e1615 = phi_5098_;
                                    if (_e1592 > _e1615) {
                                        phi_5103_ = _e1592;
                                    } else {
                                        phi_5103_ = _e1615;
                                    }
                                    let _e1618 = phi_5103_;
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
                                        phi_5162_ = -(_e1649);
                                    } else {
                                        phi_5162_ = _e1649;
                                    }
                                    let _e1655 = phi_5162_;
                                    if (_e1650 < 0.0lf) {
                                        phi_5168_ = -(_e1650);
                                    } else {
                                        phi_5168_ = _e1650;
                                    }
                                    let _e1659 = phi_5168_;
                                    if (_e1655 > _e1659) {
                                        phi_5173_ = _e1655;
                                    } else {
                                        phi_5173_ = _e1659;
                                    }
                                    let _e1662 = phi_5173_;
                                    if (_e1651 < 0.0lf) {
                                        phi_5179_ = -(_e1651);
                                    } else {
                                        phi_5179_ = _e1651;
                                    }
                                    let _e1666 = phi_5179_;
                                    if (_e1662 > _e1666) {
                                        phi_5184_ = _e1662;
                                    } else {
                                        phi_5184_ = _e1666;
                                    }
                                    let _e1669 = phi_5184_;
                                    let _e1677 = ((((_e1566 * _e1669) * f64(1.01f)) + ((_e1618 + _e1568) * (1.1102230246251565e-16lf * f64(8f)))) + _e1568);
                                    if (_e1636 < 0.0lf) {
                                        phi_5198_ = -(_e1636);
                                    } else {
                                        phi_5198_ = _e1636;
                                    }
                                    let _e1681 = phi_5198_;
                                    if (_e1637 < 0.0lf) {
                                        phi_5204_ = -(_e1637);
                                    } else {
                                        phi_5204_ = _e1637;
                                    }
                                    let _e1685 = phi_5204_;
                                    if (_e1681 > _e1685) {
                                        phi_5209_ = _e1681;
                                    } else {
                                        phi_5209_ = _e1685;
                                    }
                                    let _e1688 = phi_5209_;
                                    if (_e1638 < 0.0lf) {
                                        phi_5215_ = -(_e1638);
                                    } else {
                                        phi_5215_ = _e1638;
                                    }
                                    let _e1692 = phi_5215_;
                                    if (_e1688 > _e1692) {
                                        phi_5220_ = _e1688;
                                    } else {
                                        phi_5220_ = _e1692;
                                    }
                                    let _e1695 = phi_5220_;
                                    local_2 = type_35(array<f64, 3>(_e1636, _e1637, _e1638), _e1677, (_e1695 + _e1677));
                                    let _e1701 = local_12.member_3;
                                    let _e1703 = local_12.member_1[0u];
                                    if (_e1703[0] < 0.0lf) {
                                        phi_5246_ = -(_e1703[0]);
                                    } else {
                                        phi_5246_ = _e1703[0];
                                    }
                                    let _e1710 = phi_5246_;
                                    if (_e1703[1] < 0.0lf) {
                                        phi_5253_ = -(_e1703[1]);
                                    } else {
                                        phi_5253_ = _e1703[1];
                                    }
                                    let _e1714 = phi_5253_;
                                    if (_e1710 > _e1714) {
                                        phi_5258_ = _e1710;
                                    } else {
                                        phi_5258_ = _e1714;
                                    }
                                    let _e1717 = phi_5258_;
                                    if (_e1703[2] < 0.0lf) {
                                        phi_5265_ = -(_e1703[2]);
                                    } else {
                                        phi_5265_ = _e1703[2];
                                    }
                                    let _e1721 = phi_5265_;
                                    if (_e1717 > _e1721) {
                                        phi_5270_ = _e1717;
                                    } else {
                                        phi_5270_ = _e1721;
                                    }
                                    let _e1724 = phi_5270_;
                                    let _e1726 = local_12.member_1[1u];
                                    if (_e1726[0] < 0.0lf) {
                                        phi_5283_ = -(_e1726[0]);
                                    } else {
                                        phi_5283_ = _e1726[0];
                                    }
                                    let _e1733 = phi_5283_;
                                    if (_e1726[1] < 0.0lf) {
                                        phi_5290_ = -(_e1726[1]);
                                    } else {
                                        phi_5290_ = _e1726[1];
                                    }
                                    let _e1737 = phi_5290_;
                                    if (_e1733 > _e1737) {
                                        phi_5295_ = _e1733;
                                    } else {
                                        phi_5295_ = _e1737;
                                    }
                                    let _e1740 = phi_5295_;
                                    if (_e1726[2] < 0.0lf) {
                                        phi_5302_ = -(_e1726[2]);
                                    } else {
                                        phi_5302_ = _e1726[2];
                                    }
                                    let _e1744 = phi_5302_;
                                    if (_e1740 > _e1744) {
                                        phi_5307_ = _e1740;
                                    } else {
                                        phi_5307_ = _e1744;
                                    }
                                    let _e1747 = phi_5307_;
                                    if (_e1724 > _e1747) {
                                        phi_5312_ = _e1724;
                                    } else {
                                        phi_5312_ = _e1747;
                                    }
                                    let _e1750 = phi_5312_;
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
                                        phi_5371_ = -(_e1781);
                                    } else {
                                        phi_5371_ = _e1781;
                                    }
                                    let _e1787 = phi_5371_;
                                    if (_e1782 < 0.0lf) {
                                        phi_5377_ = -(_e1782);
                                    } else {
                                        phi_5377_ = _e1782;
                                    }
                                    let _e1791 = phi_5377_;
                                    if (_e1787 > _e1791) {
                                        phi_5382_ = _e1787;
                                    } else {
                                        phi_5382_ = _e1791;
                                    }
                                    let _e1794 = phi_5382_;
                                    if (_e1783 < 0.0lf) {
                                        phi_5388_ = -(_e1783);
                                    } else {
                                        phi_5388_ = _e1783;
                                    }
                                    let _e1798 = phi_5388_;
                                    if (_e1794 > _e1798) {
                                        phi_5393_ = _e1794;
                                    } else {
                                        phi_5393_ = _e1798;
                                    }
                                    let _e1801 = phi_5393_;
                                    let _e1809 = ((((_e1566 * _e1801) * f64(1.01f)) + ((_e1750 + _e1701) * (1.1102230246251565e-16lf * f64(8f)))) + _e1701);
                                    if (_e1768 < 0.0lf) {
                                        phi_5407_ = -(_e1768);
                                    } else {
                                        phi_5407_ = _e1768;
                                    }
                                    let _e1813 = phi_5407_;
                                    if (_e1769 < 0.0lf) {
                                        phi_5413_ = -(_e1769);
                                    } else {
                                        phi_5413_ = _e1769;
                                    }
                                    let _e1817 = phi_5413_;
                                    if (_e1813 > _e1817) {
                                        phi_5418_ = _e1813;
                                    } else {
                                        phi_5418_ = _e1817;
                                    }
                                    let _e1820 = phi_5418_;
                                    if (_e1770 < 0.0lf) {
                                        phi_5424_ = -(_e1770);
                                    } else {
                                        phi_5424_ = _e1770;
                                    }
                                    let _e1824 = phi_5424_;
                                    if (_e1820 > _e1824) {
                                        phi_5429_ = _e1820;
                                    } else {
                                        phi_5429_ = _e1824;
                                    }
                                    let _e1827 = phi_5429_;
                                    local_3 = type_35(array<f64, 3>(_e1768, _e1769, _e1770), _e1809, (_e1827 + _e1809));
                                    let _e1833 = local_12.member_3;
                                    let _e1835 = local_12.member_2[0u];
                                    if (_e1835[0] < 0.0lf) {
                                        phi_5455_ = -(_e1835[0]);
                                    } else {
                                        phi_5455_ = _e1835[0];
                                    }
                                    let _e1842 = phi_5455_;
                                    if (_e1835[1] < 0.0lf) {
                                        phi_5462_ = -(_e1835[1]);
                                    } else {
                                        phi_5462_ = _e1835[1];
                                    }
                                    let _e1846 = phi_5462_;
                                    if (_e1842 > _e1846) {
                                        phi_5467_ = _e1842;
                                    } else {
                                        phi_5467_ = _e1846;
                                    }
                                    let _e1849 = phi_5467_;
                                    if (_e1835[2] < 0.0lf) {
                                        phi_5474_ = -(_e1835[2]);
                                    } else {
                                        phi_5474_ = _e1835[2];
                                    }
                                    let _e1853 = phi_5474_;
                                    if (_e1849 > _e1853) {
                                        phi_5479_ = _e1849;
                                    } else {
                                        phi_5479_ = _e1853;
                                    }
                                    let _e1856 = phi_5479_;
                                    let _e1858 = local_12.member_2[1u];
                                    if (_e1858[0] < 0.0lf) {
                                        phi_5492_ = -(_e1858[0]);
                                    } else {
                                        phi_5492_ = _e1858[0];
                                    }
                                    let _e1865 = phi_5492_;
                                    if (_e1858[1] < 0.0lf) {
                                        phi_5499_ = -(_e1858[1]);
                                    } else {
                                        phi_5499_ = _e1858[1];
                                    }
                                    let _e1869 = phi_5499_;
                                    if (_e1865 > _e1869) {
                                        phi_5504_ = _e1865;
                                    } else {
                                        phi_5504_ = _e1869;
                                    }
                                    let _e1872 = phi_5504_;
                                    if (_e1858[2] < 0.0lf) {
                                        phi_5511_ = -(_e1858[2]);
                                    } else {
                                        phi_5511_ = _e1858[2];
                                    }
                                    let _e1876 = phi_5511_;
                                    if (_e1872 > _e1876) {
                                        phi_5516_ = _e1872;
                                    } else {
                                        phi_5516_ = _e1876;
                                    }
                                    let _e1879 = phi_5516_;
                                    if (_e1856 > _e1879) {
                                        phi_5521_ = _e1856;
                                    } else {
                                        phi_5521_ = _e1879;
                                    }
                                    let _e1882 = phi_5521_;
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
                                        phi_5580_ = -(_e1913);
                                    } else {
                                        phi_5580_ = _e1913;
                                    }
                                    let _e1919 = phi_5580_;
                                    if (_e1914 < 0.0lf) {
                                        phi_5586_ = -(_e1914);
                                    } else {
                                        phi_5586_ = _e1914;
                                    }
                                    let _e1923 = phi_5586_;
                                    if (_e1919 > _e1923) {
                                        phi_5591_ = _e1919;
                                    } else {
                                        phi_5591_ = _e1923;
                                    }
                                    let _e1926 = phi_5591_;
                                    if (_e1915 < 0.0lf) {
                                        phi_5597_ = -(_e1915);
                                    } else {
                                        phi_5597_ = _e1915;
                                    }
                                    let _e1930 = phi_5597_;
                                    if (_e1926 > _e1930) {
                                        phi_5602_ = _e1926;
                                    } else {
                                        phi_5602_ = _e1930;
                                    }
                                    let _e1933 = phi_5602_;
                                    let _e1941 = ((((_e1566 * _e1933) * f64(1.01f)) + ((_e1882 + _e1833) * (1.1102230246251565e-16lf * f64(8f)))) + _e1833);
                                    if (_e1900 < 0.0lf) {
                                        phi_5616_ = -(_e1900);
                                    } else {
                                        phi_5616_ = _e1900;
                                    }
                                    let _e1945 = phi_5616_;
                                    if (_e1901 < 0.0lf) {
                                        phi_5622_ = -(_e1901);
                                    } else {
                                        phi_5622_ = _e1901;
                                    }
                                    let _e1949 = phi_5622_;
                                    if (_e1945 > _e1949) {
                                        phi_5627_ = _e1945;
                                    } else {
                                        phi_5627_ = _e1949;
                                    }
                                    let _e1952 = phi_5627_;
                                    if (_e1902 < 0.0lf) {
                                        phi_5633_ = -(_e1902);
                                    } else {
                                        phi_5633_ = _e1902;
                                    }
                                    let _e1956 = phi_5633_;
                                    if (_e1952 > _e1956) {
                                        phi_5638_ = _e1952;
                                    } else {
                                        phi_5638_ = _e1956;
                                    }
                                    let _e1959 = phi_5638_;
                                    local_4 = type_35(array<f64, 3>(_e1900, _e1901, _e1902), _e1941, (_e1959 + _e1941));
                                    let _e1964 = local_3.member;
                                    let _e1969 = local_4.member;
                                    let _e1975 = ((_e1964[1] * _e1969[2]) - (_e1964[2] * _e1969[1]));
                                    let _e1978 = ((_e1964[2] * _e1969[0]) - (_e1964[0] * _e1969[2]));
                                    let _e1981 = ((_e1964[0] * _e1969[1]) - (_e1964[1] * _e1969[0]));
                                    if (_e1975 < 0.0lf) {
                                        phi_5687_ = -(_e1975);
                                    } else {
                                        phi_5687_ = _e1975;
                                    }
                                    let _e1985 = phi_5687_;
                                    if (_e1978 < 0.0lf) {
                                        phi_5693_ = -(_e1978);
                                    } else {
                                        phi_5693_ = _e1978;
                                    }
                                    let _e1989 = phi_5693_;
                                    if (_e1985 > _e1989) {
                                        if (_e1975 < 0.0lf) {
                                            phi_5703_ = -(_e1975);
                                        } else {
                                            phi_5703_ = _e1975;
                                        }
                                        let _e2007 = phi_5703_;
                                        if (_e1981 < 0.0lf) {
                                            phi_5709_ = -(_e1981);
                                        } else {
                                            phi_5709_ = _e1981;
                                        }
                                        let _e2011 = phi_5709_;
                                        if (_e2007 > _e2011) {
                                            phi_5714_ = 2u;
                                            phi_5715_ = 1u;
                                        } else {
                                            phi_5714_ = 1u;
                                            phi_5715_ = 0u;
                                        }
                                        let _e2014 = phi_5714_;
                                        let _e2016 = phi_5715_;
                                        phi_5734_ = _e2014;
                                        phi_5735_ = _e2016;
                                    } else {
                                        if (_e1978 < 0.0lf) {
                                            phi_5721_ = -(_e1978);
                                        } else {
                                            phi_5721_ = _e1978;
                                        }
                                        let _e1994 = phi_5721_;
                                        if (_e1981 < 0.0lf) {
                                            phi_5727_ = -(_e1981);
                                        } else {
                                            phi_5727_ = _e1981;
                                        }
                                        let _e1998 = phi_5727_;
                                        if (_e1994 > _e1998) {
                                            phi_5732_ = 0u;
                                            phi_5733_ = 2u;
                                        } else {
                                            phi_5732_ = 1u;
                                            phi_5733_ = 0u;
                                        }
                                        let _e2001 = phi_5732_;
                                        let _e2003 = phi_5733_;
                                        phi_5734_ = _e2001;
                                        phi_5735_ = _e2003;
                                    }
                                    let _e2018 = phi_5734_;
                                    let _e2020 = phi_5735_;
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
                                        phi_5808_ = -(_e2035);
                                    } else {
                                        phi_5808_ = _e2035;
                                    }
                                    let _e2075 = phi_5808_;
                                    if (_e2075 > _e2071) {
                                        if (_e2035 < f64(0f)) {
                                            phi_5820_ = f64(-1f);
                                        } else {
                                            phi_5820_ = f64(1f);
                                        }
                                        let _e2082 = phi_5820_;
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
                                            phi_5963_ = -(_e2185);
                                        } else {
                                            phi_5963_ = _e2185;
                                        }
                                        let _e2191 = phi_5963_;
                                        if (_e2186 < 0.0lf) {
                                            phi_5969_ = -(_e2186);
                                        } else {
                                            phi_5969_ = _e2186;
                                        }
                                        let _e2195 = phi_5969_;
                                        if (_e2187 < 0.0lf) {
                                            phi_5976_ = -(_e2187);
                                        } else {
                                            phi_5976_ = _e2187;
                                        }
                                        let _e2200 = phi_5976_;
                                        let _e2204 = (((_e2191 + _e2195) + _e2200) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_5[0u].member = _e2186;
                                        local_5[0u].member_1 = _e2133;
                                        local_5[1u].member = _e2187;
                                        local_5[1u].member_1 = _e2184;
                                        local_5[2u].member = (_e2185 - _e2186);
                                        local_5[2u].member_1 = ((_e2071 + _e2133) + _e2204);
                                        local_5[3u].member = (_e2185 - _e2187);
                                        local_5[3u].member_1 = ((_e2071 + _e2184) + _e2204);
                                        phi_6020_ = type_9(0u, 4u);
                                        phi_6023_ = true;
                                        loop {
                                            let _e2225 = phi_6020_;
                                            let _e2227 = phi_6023_;
                                            local_17 = _e2227;
                                            if (_e2225.member < _e2225.member_1) {
                                                phi_6021_ = type_9((_e2225.member + 1u), _e2225.member_1);
                                                phi_6046_ = type_9(1u, _e2225.member);
                                            } else {
                                                phi_6021_ = _e2225;
                                                phi_6046_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2239 = phi_6021_;
                                            let _e2241 = phi_6046_;
                                            if (bitcast<i32>(_e2241.member) != 0i) {
                                                let _e2248 = local_5[_e2241.member_1].member;
                                                let _e2251 = local_5[_e2241.member_1].member_1;
                                                let _e2253 = (_e2248 < -(_e2251));
                                                if _e2253 {
                                                    phi_6073_ = bool();
                                                    phi_6074_ = false;
                                                } else {
                                                    phi_6073_ = (_e2227 && (_e2248 > _e2251));
                                                    phi_6074_ = true;
                                                }
                                                let _e2257 = phi_6073_;
                                                let _e2259 = phi_6074_;
                                                phi_6024_ = _e2257;
                                                phi_6075_ = _e2259;
                                                phi_6076_ = _e2253;
                                            } else {
                                                phi_6024_ = bool();
                                                phi_6075_ = false;
                                                phi_6076_ = false;
                                            }
                                            let _e2261 = phi_6024_;
                                            let _e2263 = phi_6075_;
                                            let _e2265 = phi_6076_;
                                            local_16 = _e2265;
                                            continue;
                                            continuing {
                                                phi_6020_ = _e2239;
                                                phi_6023_ = _e2261;
                                                break if !(_e2263);
                                            }
                                        }
                                        let _e2268 = local_16;
                                        if _e2268 {
                                            phi_6080_ = false;
                                        } else {
                                            phi_6080_ = true;
                                        }
                                        let _e2270 = phi_6080_;
                                        if _e2270 {
                                            let _e2272 = local_17;
                                            if _e2272 {
                                                phi_6087_ = 1u;
                                            } else {
                                                phi_6087_ = 2u;
                                            }
                                            let _e2274 = phi_6087_;
                                            phi_6088_ = _e2274;
                                            phi_6089_ = false;
                                        } else {
                                            phi_6088_ = u32();
                                            phi_6089_ = true;
                                        }
                                        let _e2276 = phi_6088_;
                                        let _e2278 = phi_6089_;
                                        phi_6090_ = _e2276;
                                        phi_6091_ = 0u;
                                        phi_6092_ = _e2278;
                                    } else {
                                        phi_6090_ = u32();
                                        phi_6091_ = 2u;
                                        phi_6092_ = true;
                                    }
                                    let _e2280 = phi_6090_;
                                    let _e2282 = phi_6091_;
                                    let _e2284 = phi_6092_;
                                    if _e2284 {
                                        phi_6096_ = _e2282;
                                    } else {
                                        phi_6096_ = _e2280;
                                    }
                                    let _e2286 = phi_6096_;
                                    let _e2287 = (_e2286 == 0u);
                                    if _e2287 {
                                        phi_8308_ = f64();
                                        phi_8309_ = false;
                                        phi_8310_ = false;
                                        phi_8311_ = false;
                                    } else {
                                        if (_e2286 == 1u) {
                                            if _e1554.member_2 {
                                                if ((_e1554.member_1 - _e1554.member) <= f64(0.0000005f)) {
                                                    phi_6117_ = false;
                                                } else {
                                                    phi_6117_ = true;
                                                }
                                                let _e2296 = phi_6117_;
                                                phi_6118_ = _e2296;
                                            } else {
                                                phi_6118_ = true;
                                            }
                                            let _e2298 = phi_6118_;
                                            phi_6119_ = _e2298;
                                        } else {
                                            phi_6119_ = true;
                                        }
                                        let _e2300 = phi_6119_;
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
                                                phi_6268_ = -(_e2360[0]);
                                            } else {
                                                phi_6268_ = _e2360[0];
                                            }
                                            let _e2367 = phi_6268_;
                                            if (_e2360[1] < 0.0lf) {
                                                phi_6275_ = -(_e2360[1]);
                                            } else {
                                                phi_6275_ = _e2360[1];
                                            }
                                            let _e2371 = phi_6275_;
                                            if (_e2367 > _e2371) {
                                                phi_6280_ = _e2367;
                                            } else {
                                                phi_6280_ = _e2371;
                                            }
                                            let _e2374 = phi_6280_;
                                            if (_e2360[2] < 0.0lf) {
                                                phi_6287_ = -(_e2360[2]);
                                            } else {
                                                phi_6287_ = _e2360[2];
                                            }
                                            let _e2378 = phi_6287_;
                                            if (_e2374 > _e2378) {
                                                phi_6292_ = _e2374;
                                            } else {
                                                phi_6292_ = _e2378;
                                            }
                                            let _e2381 = phi_6292_;
                                            let _e2384 = local_12.member[1u];
                                            if (_e2384[0] < 0.0lf) {
                                                phi_6305_ = -(_e2384[0]);
                                            } else {
                                                phi_6305_ = _e2384[0];
                                            }
                                            let _e2391 = phi_6305_;
                                            if (_e2384[1] < 0.0lf) {
                                                phi_6312_ = -(_e2384[1]);
                                            } else {
                                                phi_6312_ = _e2384[1];
                                            }
                                            let _e2395 = phi_6312_;
                                            if (_e2391 > _e2395) {
                                                phi_6317_ = _e2391;
                                            } else {
                                                phi_6317_ = _e2395;
                                            }
                                            let _e2398 = phi_6317_;
                                            if (_e2384[2] < 0.0lf) {
                                                phi_6324_ = -(_e2384[2]);
                                            } else {
                                                phi_6324_ = _e2384[2];
                                            }
                                            let _e2402 = phi_6324_;
                                            if (_e2398 > _e2402) {
                                                phi_6329_ = _e2398;
                                            } else {
                                                phi_6329_ = _e2402;
                                            }
                                            let _e2405 = phi_6329_;
                                            if (_e2381 > _e2405) {
                                                phi_6334_ = _e2381;
                                            } else {
                                                phi_6334_ = _e2405;
                                            }
                                            let _e2408 = phi_6334_;
                                            let _e2410 = local_12.member_3;
                                            let _e2414 = local_12.member_1[0u];
                                            if (_e2414[0] < 0.0lf) {
                                                phi_6351_ = -(_e2414[0]);
                                            } else {
                                                phi_6351_ = _e2414[0];
                                            }
                                            let _e2421 = phi_6351_;
                                            if (_e2414[1] < 0.0lf) {
                                                phi_6358_ = -(_e2414[1]);
                                            } else {
                                                phi_6358_ = _e2414[1];
                                            }
                                            let _e2425 = phi_6358_;
                                            if (_e2421 > _e2425) {
                                                phi_6363_ = _e2421;
                                            } else {
                                                phi_6363_ = _e2425;
                                            }
                                            let _e2428 = phi_6363_;
                                            if (_e2414[2] < 0.0lf) {
                                                phi_6370_ = -(_e2414[2]);
                                            } else {
                                                phi_6370_ = _e2414[2];
                                            }
                                            let _e2432 = phi_6370_;
                                            if (_e2428 > _e2432) {
                                                phi_6375_ = _e2428;
                                            } else {
                                                phi_6375_ = _e2432;
                                            }
                                            let _e2435 = phi_6375_;
                                            let _e2438 = local_12.member_1[1u];
                                            if (_e2438[0] < 0.0lf) {
                                                phi_6389_ = -(_e2438[0]);
                                            } else {
                                                phi_6389_ = _e2438[0];
                                            }
                                            let _e2445 = phi_6389_;
                                            if (_e2438[1] < 0.0lf) {
                                                phi_6396_ = -(_e2438[1]);
                                            } else {
                                                phi_6396_ = _e2438[1];
                                            }
                                            let _e2449 = phi_6396_;
                                            if (_e2445 > _e2449) {
                                                phi_6401_ = _e2445;
                                            } else {
                                                phi_6401_ = _e2449;
                                            }
                                            let _e2452 = phi_6401_;
                                            if (_e2438[2] < 0.0lf) {
                                                phi_6408_ = -(_e2438[2]);
                                            } else {
                                                phi_6408_ = _e2438[2];
                                            }
                                            let _e2456 = phi_6408_;
                                            if (_e2452 > _e2456) {
                                                phi_6413_ = _e2452;
                                            } else {
                                                phi_6413_ = _e2456;
                                            }
                                            let _e2459 = phi_6413_;
                                            if (_e2435 > _e2459) {
                                                phi_6418_ = _e2435;
                                            } else {
                                                phi_6418_ = _e2459;
                                            }
                                            let _e2462 = phi_6418_;
                                            let _e2464 = local_12.member_3;
                                            let _e2468 = local_12.member_2[0u];
                                            if (_e2468[0] < 0.0lf) {
                                                phi_6435_ = -(_e2468[0]);
                                            } else {
                                                phi_6435_ = _e2468[0];
                                            }
                                            let _e2475 = phi_6435_;
                                            if (_e2468[1] < 0.0lf) {
                                                phi_6442_ = -(_e2468[1]);
                                            } else {
                                                phi_6442_ = _e2468[1];
                                            }
                                            let _e2479 = phi_6442_;
                                            if (_e2475 > _e2479) {
                                                phi_6447_ = _e2475;
                                            } else {
                                                phi_6447_ = _e2479;
                                            }
                                            let _e2482 = phi_6447_;
                                            if (_e2468[2] < 0.0lf) {
                                                phi_6454_ = -(_e2468[2]);
                                            } else {
                                                phi_6454_ = _e2468[2];
                                            }
                                            let _e2486 = phi_6454_;
                                            if (_e2482 > _e2486) {
                                                phi_6459_ = _e2482;
                                            } else {
                                                phi_6459_ = _e2486;
                                            }
                                            let _e2489 = phi_6459_;
                                            let _e2492 = local_12.member_2[1u];
                                            if (_e2492[0] < 0.0lf) {
                                                phi_6473_ = -(_e2492[0]);
                                            } else {
                                                phi_6473_ = _e2492[0];
                                            }
                                            let _e2499 = phi_6473_;
                                            if (_e2492[1] < 0.0lf) {
                                                phi_6480_ = -(_e2492[1]);
                                            } else {
                                                phi_6480_ = _e2492[1];
                                            }
                                            let _e2503 = phi_6480_;
                                            if (_e2499 > _e2503) {
                                                phi_6485_ = _e2499;
                                            } else {
                                                phi_6485_ = _e2503;
                                            }
                                            let _e2506 = phi_6485_;
                                            if (_e2492[2] < 0.0lf) {
                                                phi_6492_ = -(_e2492[2]);
                                            } else {
                                                phi_6492_ = _e2492[2];
                                            }
                                            let _e2510 = phi_6492_;
                                            if (_e2506 > _e2510) {
                                                phi_6497_ = _e2506;
                                            } else {
                                                phi_6497_ = _e2510;
                                            }
                                            let _e2513 = phi_6497_;
                                            if (_e2489 > _e2513) {
                                                phi_6502_ = _e2489;
                                            } else {
                                                phi_6502_ = _e2513;
                                            }
                                            let _e2516 = phi_6502_;
                                            let _e2518 = local_12.member_3;
                                            let _e2526 = local_12.member_3;
                                            let _e2533 = f64(0f);
                                            let _e2534 = f64(1f);
                                            local = type_34(array<f64, 4>(_e2533, _e2533, _e2533, _e2533), array<f64, 4>(_e2533, _e2533, _e2533, _e2533), array<f64, 4>(_e2534, _e2534, _e2534, _e2534));
                                            phi_6546_ = type_9(0u, 96u);
                                            phi_6549_ = _e1554.member;
                                            phi_6551_ = _e1554.member;
                                            phi_6553_ = _e1554.member;
                                            phi_6555_ = false;
                                            phi_6557_ = 0u;
                                            loop {
                                                let _e2540 = phi_6546_;
                                                let _e2542 = phi_6549_;
                                                let _e2544 = phi_6551_;
                                                let _e2546 = phi_6553_;
                                                let _e2548 = phi_6555_;
                                                let _e2550 = phi_6557_;
                                                local_36 = _e2544;
                                                local_20 = _e2542;
                                                if (_e2540.member < _e2540.member_1) {
                                                    phi_6547_ = type_9((_e2540.member + 1u), _e2540.member_1);
                                                    phi_6580_ = type_9(1u, _e2540.member);
                                                } else {
                                                    phi_6547_ = _e2540;
                                                    phi_6580_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2562 = phi_6547_;
                                                let _e2564 = phi_6580_;
                                                if (bitcast<i32>(_e2564.member) != 0i) {
                                                    let _e2570 = local_12.member[0u];
                                                    let _e2576 = local_12.member[1u];
                                                    let _e2592 = local_12.member_1[0u];
                                                    let _e2598 = local_12.member_1[1u];
                                                    let _e2614 = local_12.member_2[0u];
                                                    let _e2620 = local_12.member_2[1u];
                                                    let _e2634 = function_2(array<f64, 3>((_e2570[0] + ((_e2576[0] - _e2570[0]) * _e2542)), (_e2570[1] + ((_e2576[1] - _e2570[1]) * _e2542)), (_e2570[2] + ((_e2576[2] - _e2570[2]) * _e2542))), array<f64, 3>((_e2592[0] + ((_e2598[0] - _e2592[0]) * _e2542)), (_e2592[1] + ((_e2598[1] - _e2592[1]) * _e2542)), (_e2592[2] + ((_e2598[2] - _e2592[2]) * _e2542))), array<f64, 3>((_e2614[0] + ((_e2620[0] - _e2614[0]) * _e2542)), (_e2614[1] + ((_e2620[1] - _e2614[1]) * _e2542)), (_e2614[2] + ((_e2620[2] - _e2614[2]) * _e2542))), 1u);
                                                    if (_e2550 == 0u) {
                                                        phi_6709_ = _e2634;
                                                    } else {
                                                        let _e2636 = f64(0f);
                                                        if (_e2550 == 1u) {
                                                            phi_6695_ = _e2634[0];
                                                        } else {
                                                            phi_6695_ = _e2636;
                                                        }
                                                        let _e2640 = phi_6695_;
                                                        if (_e2550 == 2u) {
                                                            phi_6701_ = _e2634[1];
                                                        } else {
                                                            phi_6701_ = _e2636;
                                                        }
                                                        let _e2644 = phi_6701_;
                                                        if (_e2550 == 3u) {
                                                            phi_6707_ = _e2634[2];
                                                        } else {
                                                            phi_6707_ = _e2636;
                                                        }
                                                        let _e2648 = phi_6707_;
                                                        phi_6709_ = array<f64, 3>(_e2640, _e2644, _e2648);
                                                    }
                                                    let _e2651 = phi_6709_;
                                                    if (_e2651[0] < 0.0lf) {
                                                        phi_6716_ = -(_e2651[0]);
                                                    } else {
                                                        phi_6716_ = _e2651[0];
                                                    }
                                                    let _e2656 = phi_6716_;
                                                    if (_e2651[1] < 0.0lf) {
                                                        phi_6723_ = -(_e2651[1]);
                                                    } else {
                                                        phi_6723_ = _e2651[1];
                                                    }
                                                    let _e2661 = phi_6723_;
                                                    if (_e2651[2] < 0.0lf) {
                                                        phi_6731_ = -(_e2651[2]);
                                                    } else {
                                                        phi_6731_ = _e2651[2];
                                                    }
                                                    let _e2667 = phi_6731_;
                                                    let _e2668 = ((_e2656 + _e2661) + _e2667);
                                                    if (_e2668 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2668) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2675 = (f64(1f) / _e2668);
                                                            let _e2677 = (_e2651[0] * _e2675);
                                                            let _e2679 = (_e2651[1] * _e2675);
                                                            let _e2681 = (_e2651[2] * _e2675);
                                                            let _e2686 = (((_e2677 * _e2677) + (_e2679 * _e2679)) + (_e2681 * _e2681));
                                                            if (_e2686 <= 2.2250738585072014e-308lf) {
                                                                if (_e2686 > 0.0lf) {
                                                                    phi_6770_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6770_ = 0.0lf;
                                                                }
                                                                let _e2738 = phi_6770_;
                                                                phi_6834_ = _e2738;
                                                            } else {
                                                                phi_6777_ = type_16(0i, 5i);
                                                                phi_6780_ = bitcast<f64>(((bitcast<u64>(_e2686) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2693 = phi_6777_;
                                                                    let _e2695 = phi_6780_;
                                                                    local_18 = _e2695;
                                                                    if (_e2693.member < _e2693.member_1) {
                                                                        let _e2702 = (_e2693.member + 1i);
                                                                        if ((false == (_e2702 > _e2693.member)) != false) {
                                                                            phi_6801_ = true;
                                                                        } else {
                                                                            phi_6801_ = false;
                                                                        }
                                                                        let _e2707 = phi_6801_;
                                                                        if _e2707 {
                                                                            phi_6807_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_6807_ = type_17(1u, _e2702);
                                                                        }
                                                                        let _e2712 = phi_6807_;
                                                                        phi_6778_ = type_16(_e2712.member_1, _e2693.member_1);
                                                                        phi_6821_ = type_17(1u, _e2693.member);
                                                                    } else {
                                                                        phi_6778_ = _e2693;
                                                                        phi_6821_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2718 = phi_6778_;
                                                                    let _e2720 = phi_6821_;
                                                                    let _e2723 = (bitcast<i32>(_e2720.member) != 0i);
                                                                    if _e2723 {
                                                                        phi_6781_ = (0.5lf * (_e2695 + (_e2686 / _e2695)));
                                                                    } else {
                                                                        phi_6781_ = f64();
                                                                    }
                                                                    let _e2728 = phi_6781_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6777_ = _e2718;
                                                                        phi_6780_ = _e2728;
                                                                        break if !(_e2723);
                                                                    }
                                                                }
                                                                let _e2733 = local_18;
                                                                phi_6834_ = (_e2733 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2740 = phi_6834_;
                                                            let _e2742 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2749 = ((((((((_e2408 + _e2410) + (_e2462 + _e2464)) + (_e2516 + _e2518)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2526 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2740) * (f64(1f) + _e2742)));
                                                            let _e2754 = (((_e2677 * _e2306[0]) + (_e2679 * _e2306[1])) + (_e2681 * _e2306[2]));
                                                            let _e2759 = (((_e2677 * _e2322) + (_e2679 * _e2323)) + (_e2681 * _e2324));
                                                            let _e2764 = (((_e2677 * (_e2306[0] - _e2318[0])) + (_e2679 * (_e2306[1] - _e2318[1]))) + (_e2681 * (_e2306[2] - _e2318[2])));
                                                            let _e2769 = (((_e2677 * (_e2322 - _e2318[0])) + (_e2679 * (_e2323 - _e2318[1]))) + (_e2681 * (_e2324 - _e2318[2])));
                                                            let _e2775 = (((_e2677 * _e2333[0]) + (_e2679 * _e2333[1])) + (_e2681 * _e2333[2]));
                                                            let _e2780 = (((_e2677 * _e2349) + (_e2679 * _e2350)) + (_e2681 * _e2351));
                                                            let _e2785 = (((_e2677 * (_e2333[0] - _e2345[0])) + (_e2679 * (_e2333[1] - _e2345[1]))) + (_e2681 * (_e2333[2] - _e2345[2])));
                                                            let _e2790 = (((_e2677 * (_e2349 - _e2345[0])) + (_e2679 * (_e2350 - _e2345[1]))) + (_e2681 * (_e2351 - _e2345[2])));
                                                            if (_e2754 < 0.0lf) {
                                                                phi_6903_ = -(_e2754);
                                                            } else {
                                                                phi_6903_ = _e2754;
                                                            }
                                                            let _e2795 = phi_6903_;
                                                            if (_e2775 < 0.0lf) {
                                                                phi_6909_ = -(_e2775);
                                                            } else {
                                                                phi_6909_ = _e2775;
                                                            }
                                                            let _e2799 = phi_6909_;
                                                            if (_e2759 < 0.0lf) {
                                                                phi_6918_ = -(_e2759);
                                                            } else {
                                                                phi_6918_ = _e2759;
                                                            }
                                                            let _e2806 = phi_6918_;
                                                            if (_e2780 < 0.0lf) {
                                                                phi_6924_ = -(_e2780);
                                                            } else {
                                                                phi_6924_ = _e2780;
                                                            }
                                                            let _e2810 = phi_6924_;
                                                            if (_e2764 < 0.0lf) {
                                                                phi_6933_ = -(_e2764);
                                                            } else {
                                                                phi_6933_ = _e2764;
                                                            }
                                                            let _e2817 = phi_6933_;
                                                            if (_e2785 < 0.0lf) {
                                                                phi_6939_ = -(_e2785);
                                                            } else {
                                                                phi_6939_ = _e2785;
                                                            }
                                                            let _e2821 = phi_6939_;
                                                            if (_e2769 < 0.0lf) {
                                                                phi_6948_ = -(_e2769);
                                                            } else {
                                                                phi_6948_ = _e2769;
                                                            }
                                                            let _e2828 = phi_6948_;
                                                            if (_e2790 < 0.0lf) {
                                                                phi_6954_ = -(_e2790);
                                                            } else {
                                                                phi_6954_ = _e2790;
                                                            }
                                                            let _e2832 = phi_6954_;
                                                            phi_6960_ = type_34(array<f64, 4>(_e2754, _e2759, _e2764, _e2769), array<f64, 4>(_e2775, _e2780, _e2785, _e2790), array<f64, 4>((_e2749 + ((_e2795 + _e2799) * _e2742)), (_e2749 + ((_e2806 + _e2810) * _e2742)), (_e2749 + ((_e2817 + _e2821) * _e2742)), (_e2749 + ((_e2828 + _e2832) * _e2742))));
                                                            phi_6961_ = false;
                                                        } else {
                                                            phi_6960_ = type_34();
                                                            phi_6961_ = true;
                                                        }
                                                        let _e2839 = phi_6960_;
                                                        let _e2841 = phi_6961_;
                                                        phi_6962_ = _e2839;
                                                        phi_6963_ = _e2841;
                                                    } else {
                                                        phi_6962_ = type_34();
                                                        phi_6963_ = true;
                                                    }
                                                    let _e2843 = phi_6962_;
                                                    let _e2845 = phi_6963_;
                                                    if _e2845 {
                                                        let _e2846 = f64(0f);
                                                        let _e2847 = f64(1f);
                                                        phi_6973_ = type_34(array<f64, 4>(_e2846, _e2846, _e2846, _e2846), array<f64, 4>(_e2846, _e2846, _e2846, _e2846), array<f64, 4>(_e2847, _e2847, _e2847, _e2847));
                                                    } else {
                                                        phi_6973_ = _e2843;
                                                    }
                                                    let _e2853 = phi_6973_;
                                                    local_1 = type_34(array<f64, 4>(_e2853.member[0], _e2853.member[1], _e2853.member[2], _e2853.member[3]), array<f64, 4>(_e2853.member_1[0], _e2853.member_1[1], _e2853.member_1[2], _e2853.member_1[3]), array<f64, 4>(_e2853.member_2[0], _e2853.member_2[1], _e2853.member_2[2], _e2853.member_2[3]));
                                                    let _e2873 = (_e2542 - _e2546);
                                                    let _e2875 = f64(0f);
                                                    let _e2878 = local_1.member[0u];
                                                    let _e2881 = local_1.member_1[0u];
                                                    let _e2884 = local_1.member[0u];
                                                    let _e2890 = local_1.member_2[0u];
                                                    if (((_e2878 + ((_e2881 - _e2884) * _e2542)) - _e2890) > _e2875) {
                                                        let _e2895 = local_1.member[1u];
                                                        let _e2898 = local_1.member_1[1u];
                                                        let _e2901 = local_1.member[1u];
                                                        let _e2907 = local_1.member_2[1u];
                                                        if (((_e2895 + ((_e2898 - _e2901) * _e2542)) - _e2907) > _e2875) {
                                                            let _e2912 = local_1.member[2u];
                                                            let _e2915 = local_1.member_1[2u];
                                                            let _e2918 = local_1.member[2u];
                                                            let _e2924 = local_1.member_2[2u];
                                                            if (((_e2912 + ((_e2915 - _e2918) * _e2542)) - _e2924) > _e2875) {
                                                                let _e2929 = local_1.member[3u];
                                                                let _e2932 = local_1.member_1[3u];
                                                                let _e2935 = local_1.member[3u];
                                                                let _e2941 = local_1.member_2[3u];
                                                                phi_7145_ = (((_e2929 + ((_e2932 - _e2935) * _e2542)) - _e2941) > _e2875);
                                                                phi_7146_ = false;
                                                            } else {
                                                                phi_7145_ = bool();
                                                                phi_7146_ = true;
                                                            }
                                                            let _e2945 = phi_7145_;
                                                            let _e2947 = phi_7146_;
                                                            phi_7147_ = _e2945;
                                                            phi_7148_ = _e2947;
                                                        } else {
                                                            phi_7147_ = bool();
                                                            phi_7148_ = true;
                                                        }
                                                        let _e2949 = phi_7147_;
                                                        let _e2951 = phi_7148_;
                                                        phi_7149_ = _e2949;
                                                        phi_7150_ = _e2951;
                                                    } else {
                                                        phi_7149_ = bool();
                                                        phi_7150_ = true;
                                                    }
                                                    let _e2953 = phi_7149_;
                                                    let _e2955 = phi_7150_;
                                                    if _e2955 {
                                                        phi_7154_ = false;
                                                    } else {
                                                        phi_7154_ = _e2953;
                                                    }
                                                    let _e2957 = phi_7154_;
                                                    if _e2957 {
                                                        if (_e2542 <= _e2544) {
                                                            phi_7465_ = true;
                                                        } else {
                                                            let _e2959 = f64(0f);
                                                            let _e2962 = local.member[0u];
                                                            let _e2965 = local.member_1[0u];
                                                            let _e2968 = local.member[0u];
                                                            let _e2974 = local.member_2[0u];
                                                            let _e2978 = local_1.member[0u];
                                                            let _e2981 = local_1.member_1[0u];
                                                            let _e2984 = local_1.member[0u];
                                                            let _e2990 = local_1.member_2[0u];
                                                            if ((((_e2962 + ((_e2965 - _e2968) * _e2542)) - _e2974) + ((_e2978 + ((_e2981 - _e2984) * _e2546)) - _e2990)) > _e2959) {
                                                                let _e2996 = local.member[1u];
                                                                let _e2999 = local.member_1[1u];
                                                                let _e3002 = local.member[1u];
                                                                let _e3008 = local.member_2[1u];
                                                                let _e3012 = local_1.member[1u];
                                                                let _e3015 = local_1.member_1[1u];
                                                                let _e3018 = local_1.member[1u];
                                                                let _e3024 = local_1.member_2[1u];
                                                                if ((((_e2996 + ((_e2999 - _e3002) * _e2542)) - _e3008) + ((_e3012 + ((_e3015 - _e3018) * _e2546)) - _e3024)) > _e2959) {
                                                                    let _e3030 = local.member[2u];
                                                                    let _e3033 = local.member_1[2u];
                                                                    let _e3036 = local.member[2u];
                                                                    let _e3042 = local.member_2[2u];
                                                                    let _e3046 = local_1.member[2u];
                                                                    let _e3049 = local_1.member_1[2u];
                                                                    let _e3052 = local_1.member[2u];
                                                                    let _e3058 = local_1.member_2[2u];
                                                                    if ((((_e3030 + ((_e3033 - _e3036) * _e2542)) - _e3042) + ((_e3046 + ((_e3049 - _e3052) * _e2546)) - _e3058)) > _e2959) {
                                                                        let _e3064 = local.member[3u];
                                                                        let _e3067 = local.member_1[3u];
                                                                        let _e3070 = local.member[3u];
                                                                        let _e3076 = local.member_2[3u];
                                                                        let _e3080 = local_1.member[3u];
                                                                        let _e3083 = local_1.member_1[3u];
                                                                        let _e3086 = local_1.member[3u];
                                                                        let _e3092 = local_1.member_2[3u];
                                                                        phi_7452_ = ((((_e3064 + ((_e3067 - _e3070) * _e2542)) - _e3076) + ((_e3080 + ((_e3083 - _e3086) * _e2546)) - _e3092)) > _e2959);
                                                                        phi_7453_ = false;
                                                                    } else {
                                                                        phi_7452_ = bool();
                                                                        phi_7453_ = true;
                                                                    }
                                                                    let _e3097 = phi_7452_;
                                                                    let _e3099 = phi_7453_;
                                                                    phi_7454_ = _e3097;
                                                                    phi_7455_ = _e3099;
                                                                } else {
                                                                    phi_7454_ = bool();
                                                                    phi_7455_ = true;
                                                                }
                                                                let _e3101 = phi_7454_;
                                                                let _e3103 = phi_7455_;
                                                                phi_7456_ = _e3101;
                                                                phi_7457_ = _e3103;
                                                            } else {
                                                                phi_7456_ = bool();
                                                                phi_7457_ = true;
                                                            }
                                                            let _e3105 = phi_7456_;
                                                            let _e3107 = phi_7457_;
                                                            if _e3107 {
                                                                phi_7461_ = false;
                                                            } else {
                                                                phi_7461_ = _e3105;
                                                            }
                                                            let _e3109 = phi_7461_;
                                                            phi_7465_ = _e3109;
                                                        }
                                                        let _e3111 = phi_7465_;
                                                        if _e3111 {
                                                            if _e2548 {
                                                                if (_e2542 >= _e1554.member_1) {
                                                                    phi_7476_ = false;
                                                                } else {
                                                                    phi_7476_ = true;
                                                                }
                                                                let _e3114 = phi_7476_;
                                                                phi_7477_ = _e3114;
                                                            } else {
                                                                phi_7477_ = true;
                                                            }
                                                            let _e3116 = phi_7477_;
                                                            if _e3116 {
                                                                local = type_34(array<f64, 4>(_e2853.member[0], _e2853.member[1], _e2853.member[2], _e2853.member[3]), array<f64, 4>(_e2853.member_1[0], _e2853.member_1[1], _e2853.member_1[2], _e2853.member_1[3]), array<f64, 4>(_e2853.member_2[0], _e2853.member_2[1], _e2853.member_2[2], _e2853.member_2[3]));
                                                                let _e3138 = local.member[0u];
                                                                let _e3141 = local.member_1[0u];
                                                                let _e3144 = local.member_2[0u];
                                                                if (_e3138 > _e3144) {
                                                                    if (_e3141 > _e3144) {
                                                                        phi_7551_ = false;
                                                                    } else {
                                                                        phi_7551_ = true;
                                                                    }
                                                                    let _e3148 = phi_7551_;
                                                                    phi_7552_ = _e3148;
                                                                } else {
                                                                    phi_7552_ = true;
                                                                }
                                                                let _e3150 = phi_7552_;
                                                                if _e3150 {
                                                                    let _e3151 = (_e3141 >= _e3138);
                                                                    if _e3151 {
                                                                        phi_7577_ = f64();
                                                                        phi_7578_ = false;
                                                                    } else {
                                                                        if ((_e3138 - _e3141) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7575_ = (((_e3138 - _e3144) / (_e3138 - _e3141)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7576_ = false;
                                                                        } else {
                                                                            phi_7575_ = f64();
                                                                            phi_7576_ = true;
                                                                        }
                                                                        let _e3165 = phi_7575_;
                                                                        let _e3167 = phi_7576_;
                                                                        phi_7577_ = _e3165;
                                                                        phi_7578_ = _e3167;
                                                                    }
                                                                    let _e3169 = phi_7577_;
                                                                    let _e3171 = phi_7578_;
                                                                    phi_7579_ = _e3169;
                                                                    phi_7580_ = _e3151;
                                                                    phi_7581_ = _e3171;
                                                                } else {
                                                                    phi_7579_ = f64();
                                                                    phi_7580_ = true;
                                                                    phi_7581_ = false;
                                                                }
                                                                let _e3173 = phi_7579_;
                                                                let _e3175 = phi_7580_;
                                                                let _e3177 = phi_7581_;
                                                                if _e3175 {
                                                                    phi_7586_ = f64(2f);
                                                                    phi_7587_ = true;
                                                                } else {
                                                                    phi_7586_ = _e2542;
                                                                    phi_7587_ = _e3177;
                                                                }
                                                                let _e3180 = phi_7586_;
                                                                let _e3182 = phi_7587_;
                                                                if _e3182 {
                                                                    phi_7591_ = _e3180;
                                                                } else {
                                                                    phi_7591_ = _e3173;
                                                                }
                                                                let _e3184 = phi_7591_;
                                                                let _e3187 = local.member[1u];
                                                                let _e3190 = local.member_1[1u];
                                                                let _e3193 = local.member_2[1u];
                                                                if (_e3187 > _e3193) {
                                                                    if (_e3190 > _e3193) {
                                                                        phi_7623_ = false;
                                                                    } else {
                                                                        phi_7623_ = true;
                                                                    }
                                                                    let _e3197 = phi_7623_;
                                                                    phi_7624_ = _e3197;
                                                                } else {
                                                                    phi_7624_ = true;
                                                                }
                                                                let _e3199 = phi_7624_;
                                                                if _e3199 {
                                                                    let _e3200 = (_e3190 >= _e3187);
                                                                    if _e3200 {
                                                                        phi_7649_ = f64();
                                                                        phi_7650_ = false;
                                                                    } else {
                                                                        if ((_e3187 - _e3190) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7647_ = (((_e3187 - _e3193) / (_e3187 - _e3190)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7648_ = false;
                                                                        } else {
                                                                            phi_7647_ = f64();
                                                                            phi_7648_ = true;
                                                                        }
                                                                        let _e3214 = phi_7647_;
                                                                        let _e3216 = phi_7648_;
                                                                        phi_7649_ = _e3214;
                                                                        phi_7650_ = _e3216;
                                                                    }
                                                                    let _e3218 = phi_7649_;
                                                                    let _e3220 = phi_7650_;
                                                                    phi_7651_ = _e3218;
                                                                    phi_7652_ = _e3200;
                                                                    phi_7653_ = _e3220;
                                                                } else {
                                                                    phi_7651_ = f64();
                                                                    phi_7652_ = true;
                                                                    phi_7653_ = false;
                                                                }
                                                                let _e3222 = phi_7651_;
                                                                let _e3224 = phi_7652_;
                                                                let _e3226 = phi_7653_;
                                                                if _e3224 {
                                                                    phi_7658_ = f64(2f);
                                                                    phi_7659_ = true;
                                                                } else {
                                                                    phi_7658_ = _e2542;
                                                                    phi_7659_ = _e3226;
                                                                }
                                                                let _e3229 = phi_7658_;
                                                                let _e3231 = phi_7659_;
                                                                if _e3231 {
                                                                    phi_7663_ = _e3229;
                                                                } else {
                                                                    phi_7663_ = _e3222;
                                                                }
                                                                let _e3233 = phi_7663_;
                                                                if (_e3184 < _e3233) {
                                                                    phi_7668_ = _e3184;
                                                                } else {
                                                                    phi_7668_ = _e3233;
                                                                }
                                                                let _e3236 = phi_7668_;
                                                                let _e3239 = local.member[2u];
                                                                let _e3242 = local.member_1[2u];
                                                                let _e3245 = local.member_2[2u];
                                                                if (_e3239 > _e3245) {
                                                                    if (_e3242 > _e3245) {
                                                                        phi_7700_ = false;
                                                                    } else {
                                                                        phi_7700_ = true;
                                                                    }
                                                                    let _e3249 = phi_7700_;
                                                                    phi_7701_ = _e3249;
                                                                } else {
                                                                    phi_7701_ = true;
                                                                }
                                                                let _e3251 = phi_7701_;
                                                                if _e3251 {
                                                                    let _e3252 = (_e3242 >= _e3239);
                                                                    if _e3252 {
                                                                        phi_7726_ = f64();
                                                                        phi_7727_ = false;
                                                                    } else {
                                                                        if ((_e3239 - _e3242) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7724_ = (((_e3239 - _e3245) / (_e3239 - _e3242)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7725_ = false;
                                                                        } else {
                                                                            phi_7724_ = f64();
                                                                            phi_7725_ = true;
                                                                        }
                                                                        let _e3266 = phi_7724_;
                                                                        let _e3268 = phi_7725_;
                                                                        phi_7726_ = _e3266;
                                                                        phi_7727_ = _e3268;
                                                                    }
                                                                    let _e3270 = phi_7726_;
                                                                    let _e3272 = phi_7727_;
                                                                    phi_7728_ = _e3270;
                                                                    phi_7729_ = _e3252;
                                                                    phi_7730_ = _e3272;
                                                                } else {
                                                                    phi_7728_ = f64();
                                                                    phi_7729_ = true;
                                                                    phi_7730_ = false;
                                                                }
                                                                let _e3274 = phi_7728_;
                                                                let _e3276 = phi_7729_;
                                                                let _e3278 = phi_7730_;
                                                                if _e3276 {
                                                                    phi_7735_ = f64(2f);
                                                                    phi_7736_ = true;
                                                                } else {
                                                                    phi_7735_ = _e2542;
                                                                    phi_7736_ = _e3278;
                                                                }
                                                                let _e3281 = phi_7735_;
                                                                let _e3283 = phi_7736_;
                                                                if _e3283 {
                                                                    phi_7740_ = _e3281;
                                                                } else {
                                                                    phi_7740_ = _e3274;
                                                                }
                                                                let _e3285 = phi_7740_;
                                                                let _e3288 = local.member[3u];
                                                                let _e3291 = local.member_1[3u];
                                                                let _e3294 = local.member_2[3u];
                                                                if (_e3288 > _e3294) {
                                                                    if (_e3291 > _e3294) {
                                                                        phi_7772_ = false;
                                                                    } else {
                                                                        phi_7772_ = true;
                                                                    }
                                                                    let _e3298 = phi_7772_;
                                                                    phi_7773_ = _e3298;
                                                                } else {
                                                                    phi_7773_ = true;
                                                                }
                                                                let _e3300 = phi_7773_;
                                                                if _e3300 {
                                                                    let _e3301 = (_e3291 >= _e3288);
                                                                    if _e3301 {
                                                                        phi_7798_ = f64();
                                                                        phi_7799_ = false;
                                                                    } else {
                                                                        if ((_e3288 - _e3291) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7796_ = (((_e3288 - _e3294) / (_e3288 - _e3291)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7797_ = false;
                                                                        } else {
                                                                            phi_7796_ = f64();
                                                                            phi_7797_ = true;
                                                                        }
                                                                        let _e3315 = phi_7796_;
                                                                        let _e3317 = phi_7797_;
                                                                        phi_7798_ = _e3315;
                                                                        phi_7799_ = _e3317;
                                                                    }
                                                                    let _e3319 = phi_7798_;
                                                                    let _e3321 = phi_7799_;
                                                                    phi_7800_ = _e3319;
                                                                    phi_7801_ = _e3301;
                                                                    phi_7802_ = _e3321;
                                                                } else {
                                                                    phi_7800_ = f64();
                                                                    phi_7801_ = true;
                                                                    phi_7802_ = false;
                                                                }
                                                                let _e3323 = phi_7800_;
                                                                let _e3325 = phi_7801_;
                                                                let _e3327 = phi_7802_;
                                                                if _e3325 {
                                                                    phi_7807_ = f64(2f);
                                                                    phi_7808_ = true;
                                                                } else {
                                                                    phi_7807_ = _e2542;
                                                                    phi_7808_ = _e3327;
                                                                }
                                                                let _e3330 = phi_7807_;
                                                                let _e3332 = phi_7808_;
                                                                if _e3332 {
                                                                    phi_7812_ = _e3330;
                                                                } else {
                                                                    phi_7812_ = _e3323;
                                                                }
                                                                let _e3334 = phi_7812_;
                                                                if (_e3285 < _e3334) {
                                                                    phi_7817_ = _e3285;
                                                                } else {
                                                                    phi_7817_ = _e3334;
                                                                }
                                                                let _e3337 = phi_7817_;
                                                                if (_e3236 < _e3337) {
                                                                    phi_7822_ = _e3236;
                                                                } else {
                                                                    phi_7822_ = _e3337;
                                                                }
                                                                let _e3340 = phi_7822_;
                                                                if (_e3340 > _e2542) {
                                                                    phi_7827_ = _e3340;
                                                                } else {
                                                                    phi_7827_ = _e2542;
                                                                }
                                                                let _e3343 = phi_7827_;
                                                                let _e3344 = (_e3343 > _e1554.member_1);
                                                                if _e3344 {
                                                                    phi_7838_ = f64();
                                                                    phi_7839_ = false;
                                                                } else {
                                                                    if _e2548 {
                                                                        phi_7837_ = (_e2873 + _e2873);
                                                                    } else {
                                                                        phi_7837_ = (_e1554.member_1 - _e2542);
                                                                    }
                                                                    let _e3348 = phi_7837_;
                                                                    phi_7838_ = _e3348;
                                                                    phi_7839_ = true;
                                                                }
                                                                let _e3350 = phi_7838_;
                                                                let _e3352 = phi_7839_;
                                                                phi_7840_ = _e3343;
                                                                phi_7841_ = _e3350;
                                                                phi_7842_ = _e3352;
                                                                phi_7843_ = _e3344;
                                                                phi_7844_ = false;
                                                            } else {
                                                                phi_7840_ = f64();
                                                                phi_7841_ = f64();
                                                                phi_7842_ = false;
                                                                phi_7843_ = false;
                                                                phi_7844_ = true;
                                                            }
                                                            let _e3354 = phi_7840_;
                                                            let _e3356 = phi_7841_;
                                                            let _e3358 = phi_7842_;
                                                            let _e3360 = phi_7843_;
                                                            let _e3362 = phi_7844_;
                                                            phi_7845_ = _e3354;
                                                            phi_7846_ = _e3356;
                                                            phi_7847_ = false;
                                                            phi_7848_ = _e3358;
                                                            phi_7849_ = _e3360;
                                                            phi_7850_ = _e3362;
                                                        } else {
                                                            phi_7845_ = f64();
                                                            phi_7846_ = f64();
                                                            phi_7847_ = true;
                                                            phi_7848_ = false;
                                                            phi_7849_ = false;
                                                            phi_7850_ = false;
                                                        }
                                                        let _e3364 = phi_7845_;
                                                        let _e3366 = phi_7846_;
                                                        let _e3368 = phi_7847_;
                                                        let _e3370 = phi_7848_;
                                                        let _e3372 = phi_7849_;
                                                        let _e3374 = phi_7850_;
                                                        phi_7851_ = _e3364;
                                                        phi_7852_ = _e3366;
                                                        phi_7853_ = _e3368;
                                                        phi_7854_ = _e3370;
                                                        phi_7855_ = _e3372;
                                                        phi_7856_ = _e3374;
                                                    } else {
                                                        phi_7851_ = f64();
                                                        phi_7852_ = f64();
                                                        phi_7853_ = true;
                                                        phi_7854_ = false;
                                                        phi_7855_ = false;
                                                        phi_7856_ = false;
                                                    }
                                                    let _e3376 = phi_7851_;
                                                    let _e3378 = phi_7852_;
                                                    let _e3380 = phi_7853_;
                                                    let _e3382 = phi_7854_;
                                                    let _e3384 = phi_7855_;
                                                    let _e3386 = phi_7856_;
                                                    if _e3380 {
                                                        if (_e2542 <= _e2544) {
                                                            let _e3552 = (_e2550 + 1u);
                                                            let _e3553 = (_e3552 > 3u);
                                                            if _e3553 {
                                                                phi_7869_ = false;
                                                            } else {
                                                                phi_7869_ = true;
                                                            }
                                                            let _e3555 = phi_7869_;
                                                            phi_8196_ = _e3552;
                                                            phi_8197_ = f64();
                                                            phi_8198_ = false;
                                                            phi_8199_ = _e3555;
                                                            phi_8200_ = _e3553;
                                                        } else {
                                                            let _e3390 = local.member[0u];
                                                            let _e3393 = local.member_1[0u];
                                                            let _e3396 = local.member[0u];
                                                            let _e3402 = local.member_2[0u];
                                                            let _e3403 = ((_e3390 + ((_e3393 - _e3396) * _e2546)) - _e3402);
                                                            let _e3406 = local.member[1u];
                                                            let _e3409 = local.member_1[1u];
                                                            let _e3412 = local.member[1u];
                                                            let _e3418 = local.member_2[1u];
                                                            let _e3419 = ((_e3406 + ((_e3409 - _e3412) * _e2546)) - _e3418);
                                                            if (_e3403 < _e3419) {
                                                                phi_7942_ = _e3403;
                                                            } else {
                                                                phi_7942_ = _e3419;
                                                            }
                                                            let _e3422 = phi_7942_;
                                                            let _e3425 = local.member[2u];
                                                            let _e3428 = local.member_1[2u];
                                                            let _e3431 = local.member[2u];
                                                            let _e3437 = local.member_2[2u];
                                                            let _e3438 = ((_e3425 + ((_e3428 - _e3431) * _e2546)) - _e3437);
                                                            let _e3441 = local.member[3u];
                                                            let _e3444 = local.member_1[3u];
                                                            let _e3447 = local.member[3u];
                                                            let _e3453 = local.member_2[3u];
                                                            let _e3454 = ((_e3441 + ((_e3444 - _e3447) * _e2546)) - _e3453);
                                                            if (_e3438 < _e3454) {
                                                                phi_8015_ = _e3438;
                                                            } else {
                                                                phi_8015_ = _e3454;
                                                            }
                                                            let _e3457 = phi_8015_;
                                                            if (_e3422 < _e3457) {
                                                                phi_8020_ = _e3422;
                                                            } else {
                                                                phi_8020_ = _e3457;
                                                            }
                                                            let _e3460 = phi_8020_;
                                                            let _e3463 = local_1.member[0u];
                                                            let _e3466 = local_1.member_1[0u];
                                                            let _e3469 = local_1.member[0u];
                                                            let _e3475 = local_1.member_2[0u];
                                                            let _e3476 = ((_e3463 + ((_e3466 - _e3469) * _e2542)) - _e3475);
                                                            let _e3479 = local_1.member[1u];
                                                            let _e3482 = local_1.member_1[1u];
                                                            let _e3485 = local_1.member[1u];
                                                            let _e3491 = local_1.member_2[1u];
                                                            let _e3492 = ((_e3479 + ((_e3482 - _e3485) * _e2542)) - _e3491);
                                                            if (_e3476 < _e3492) {
                                                                phi_8093_ = _e3476;
                                                            } else {
                                                                phi_8093_ = _e3492;
                                                            }
                                                            let _e3495 = phi_8093_;
                                                            let _e3498 = local_1.member[2u];
                                                            let _e3501 = local_1.member_1[2u];
                                                            let _e3504 = local_1.member[2u];
                                                            let _e3510 = local_1.member_2[2u];
                                                            let _e3511 = ((_e3498 + ((_e3501 - _e3504) * _e2542)) - _e3510);
                                                            let _e3514 = local_1.member[3u];
                                                            let _e3517 = local_1.member_1[3u];
                                                            let _e3520 = local_1.member[3u];
                                                            let _e3526 = local_1.member_2[3u];
                                                            let _e3527 = ((_e3514 + ((_e3517 - _e3520) * _e2542)) - _e3526);
                                                            if (_e3511 < _e3527) {
                                                                phi_8166_ = _e3511;
                                                            } else {
                                                                phi_8166_ = _e3527;
                                                            }
                                                            let _e3530 = phi_8166_;
                                                            if (_e3495 < _e3530) {
                                                                phi_8171_ = _e3495;
                                                            } else {
                                                                phi_8171_ = _e3530;
                                                            }
                                                            let _e3533 = phi_8171_;
                                                            let _e3534 = f64(0.0625f);
                                                            let _e3536 = f64(0.9f);
                                                            if (_e3533 > f64(0f)) {
                                                                phi_8194_ = f64(0.5f);
                                                            } else {
                                                                let _e3542 = (f64(0.95f) * (_e3460 / (_e3460 - _e3533)));
                                                                if (_e3542 > _e3534) {
                                                                    if (_e3542 < _e3536) {
                                                                        phi_8192_ = _e3542;
                                                                    } else {
                                                                        phi_8192_ = _e3536;
                                                                    }
                                                                    let _e3546 = phi_8192_;
                                                                    phi_8193_ = _e3546;
                                                                } else {
                                                                    phi_8193_ = _e3534;
                                                                }
                                                                let _e3548 = phi_8193_;
                                                                phi_8194_ = _e3548;
                                                            }
                                                            let _e3550 = phi_8194_;
                                                            phi_8196_ = u32();
                                                            phi_8197_ = (_e2873 * _e3550);
                                                            phi_8198_ = true;
                                                            phi_8199_ = false;
                                                            phi_8200_ = false;
                                                        }
                                                        let _e3557 = phi_8196_;
                                                        let _e3559 = phi_8197_;
                                                        let _e3561 = phi_8198_;
                                                        let _e3563 = phi_8199_;
                                                        let _e3565 = phi_8200_;
                                                        phi_8201_ = _e3557;
                                                        phi_8202_ = _e2544;
                                                        phi_8203_ = _e3559;
                                                        phi_8204_ = _e2546;
                                                        phi_8205_ = _e2548;
                                                        phi_8206_ = _e2550;
                                                        phi_8207_ = _e3561;
                                                        phi_8208_ = _e3563;
                                                        phi_8209_ = _e3565;
                                                        phi_8210_ = false;
                                                        phi_8211_ = false;
                                                    } else {
                                                        phi_8201_ = u32();
                                                        phi_8202_ = _e3376;
                                                        phi_8203_ = _e3378;
                                                        phi_8204_ = _e2542;
                                                        phi_8205_ = true;
                                                        phi_8206_ = 0u;
                                                        phi_8207_ = _e3382;
                                                        phi_8208_ = false;
                                                        phi_8209_ = false;
                                                        phi_8210_ = _e3384;
                                                        phi_8211_ = _e3386;
                                                    }
                                                    let _e3567 = phi_8201_;
                                                    let _e3569 = phi_8202_;
                                                    let _e3571 = phi_8203_;
                                                    let _e3573 = phi_8204_;
                                                    let _e3575 = phi_8205_;
                                                    let _e3577 = phi_8206_;
                                                    let _e3579 = phi_8207_;
                                                    let _e3581 = phi_8208_;
                                                    let _e3583 = phi_8209_;
                                                    let _e3585 = phi_8210_;
                                                    let _e3587 = phi_8211_;
                                                    if _e3579 {
                                                        let _e3588 = (_e3573 + _e3571);
                                                        if (_e3588 > _e3569) {
                                                            phi_8220_ = _e3588;
                                                        } else {
                                                            phi_8220_ = _e3569;
                                                        }
                                                        let _e3591 = phi_8220_;
                                                        if (_e3591 < _e1554.member_1) {
                                                            phi_8225_ = _e3591;
                                                        } else {
                                                            phi_8225_ = _e1554.member_1;
                                                        }
                                                        let _e3594 = phi_8225_;
                                                        if !(_e2548) {
                                                            phi_8235_ = true;
                                                        } else {
                                                            phi_8235_ = ((_e3594 - _e3573) > f64(0.0000000037252903f));
                                                        }
                                                        let _e3599 = phi_8235_;
                                                        if _e3599 {
                                                            phi_8239_ = false;
                                                        } else {
                                                            phi_8239_ = true;
                                                        }
                                                        let _e3601 = phi_8239_;
                                                        phi_8240_ = _e3594;
                                                        phi_8241_ = _e3569;
                                                        phi_8242_ = _e3573;
                                                        phi_8243_ = _e3575;
                                                        phi_8244_ = _e3577;
                                                        phi_8245_ = _e3599;
                                                        phi_8246_ = _e3601;
                                                        phi_8247_ = false;
                                                        phi_8248_ = false;
                                                        phi_8249_ = false;
                                                    } else {
                                                        phi_8240_ = _e2542;
                                                        phi_8241_ = _e2544;
                                                        phi_8242_ = _e2546;
                                                        phi_8243_ = _e2548;
                                                        phi_8244_ = _e3567;
                                                        phi_8245_ = _e3581;
                                                        phi_8246_ = false;
                                                        phi_8247_ = _e3583;
                                                        phi_8248_ = _e3585;
                                                        phi_8249_ = _e3587;
                                                    }
                                                    let _e3603 = phi_8240_;
                                                    let _e3605 = phi_8241_;
                                                    let _e3607 = phi_8242_;
                                                    let _e3609 = phi_8243_;
                                                    let _e3611 = phi_8244_;
                                                    let _e3613 = phi_8245_;
                                                    let _e3615 = phi_8246_;
                                                    let _e3617 = phi_8247_;
                                                    let _e3619 = phi_8248_;
                                                    let _e3621 = phi_8249_;
                                                    phi_6550_ = _e3603;
                                                    phi_6552_ = _e3605;
                                                    phi_6554_ = _e3607;
                                                    phi_6556_ = _e3609;
                                                    phi_6558_ = _e3611;
                                                    phi_8250_ = _e3569;
                                                    phi_8251_ = _e3613;
                                                    phi_8252_ = _e3615;
                                                    phi_8253_ = false;
                                                    phi_8254_ = _e3617;
                                                    phi_8255_ = _e3619;
                                                    phi_8256_ = _e3621;
                                                } else {
                                                    phi_6550_ = f64();
                                                    phi_6552_ = f64();
                                                    phi_6554_ = f64();
                                                    phi_6556_ = bool();
                                                    phi_6558_ = u32();
                                                    phi_8250_ = f64();
                                                    phi_8251_ = false;
                                                    phi_8252_ = false;
                                                    phi_8253_ = true;
                                                    phi_8254_ = false;
                                                    phi_8255_ = false;
                                                    phi_8256_ = false;
                                                }
                                                let _e3623 = phi_6550_;
                                                let _e3625 = phi_6552_;
                                                let _e3627 = phi_6554_;
                                                let _e3629 = phi_6556_;
                                                let _e3631 = phi_6558_;
                                                let _e3633 = phi_8250_;
                                                let _e3635 = phi_8251_;
                                                let _e3637 = phi_8252_;
                                                let _e3639 = phi_8253_;
                                                let _e3641 = phi_8254_;
                                                let _e3643 = phi_8255_;
                                                let _e3645 = phi_8256_;
                                                local_19 = _e3637;
                                                local_35 = _e3633;
                                                local_37 = _e3639;
                                                local_38 = _e3641;
                                                local_39 = _e3643;
                                                local_40 = _e3645;
                                                continue;
                                                continuing {
                                                    phi_6546_ = _e2562;
                                                    phi_6549_ = _e3623;
                                                    phi_6551_ = _e3625;
                                                    phi_6553_ = _e3627;
                                                    phi_6555_ = _e3629;
                                                    phi_6557_ = _e3631;
                                                    break if !(_e3635);
                                                }
                                            }
                                            let _e3648 = local_19;
                                            if _e3648 {
                                                let _e6159 = local_35;
                                                phi_8260_ = _e6159;
                                                phi_8261_ = true;
                                                phi_8262_ = false;
                                                phi_8263_ = false;
                                                phi_8264_ = false;
                                            } else {
                                                let _e6161 = local_36;
                                                phi_8260_ = _e6161;
                                                let _e6164 = local_37;
                                                phi_8261_ = _e6164;
                                                let _e6167 = local_38;
                                                phi_8262_ = _e6167;
                                                let _e6170 = local_39;
                                                phi_8263_ = _e6170;
                                                let _e6173 = local_40;
                                                phi_8264_ = _e6173;
                                            }
                                            let _e3650 = phi_8260_;
                                            let _e3652 = phi_8261_;
                                            let _e3654 = phi_8262_;
                                            let _e3656 = phi_8263_;
                                            let _e3658 = phi_8264_;
                                            if _e3652 {
                                                phi_8269_ = type_44(1u, _e3650);
                                                phi_8270_ = false;
                                                phi_8271_ = false;
                                                phi_8272_ = false;
                                            } else {
                                                phi_8269_ = type_44();
                                                phi_8270_ = _e3654;
                                                phi_8271_ = _e3656;
                                                phi_8272_ = _e3658;
                                            }
                                            let _e3661 = phi_8269_;
                                            let _e3663 = phi_8270_;
                                            let _e3665 = phi_8271_;
                                            let _e3667 = phi_8272_;
                                            if _e3663 {
                                                let _e3669 = local_20;
                                                phi_8277_ = type_44(1u, _e3669);
                                                phi_8278_ = false;
                                                phi_8279_ = false;
                                            } else {
                                                phi_8277_ = type_44();
                                                phi_8278_ = _e3665;
                                                phi_8279_ = _e3667;
                                            }
                                            let _e3672 = phi_8277_;
                                            let _e3674 = phi_8278_;
                                            let _e3676 = phi_8279_;
                                            if _e3674 {
                                                phi_8284_ = type_44(0u, type_44().member_1);
                                                phi_8285_ = false;
                                                phi_8286_ = true;
                                            } else {
                                                phi_8284_ = _e3672;
                                                phi_8285_ = _e3676;
                                                phi_8286_ = _e3663;
                                            }
                                            let _e3680 = phi_8284_;
                                            let _e3682 = phi_8285_;
                                            let _e3684 = phi_8286_;
                                            if _e3682 {
                                                phi_8291_ = type_44(0u, type_44().member_1);
                                                phi_8292_ = true;
                                            } else {
                                                phi_8291_ = _e3680;
                                                phi_8292_ = _e3684;
                                            }
                                            let _e3688 = phi_8291_;
                                            let _e3690 = phi_8292_;
                                            if _e3690 {
                                                phi_8296_ = _e3688;
                                            } else {
                                                phi_8296_ = _e3661;
                                            }
                                            let _e3692 = phi_8296_;
                                            let _e3695 = (_e3692.member != 0u);
                                            if _e3695 {
                                                phi_8303_ = false;
                                            } else {
                                                phi_8303_ = true;
                                            }
                                            let _e3697 = phi_8303_;
                                            phi_8304_ = _e3692.member_1;
                                            phi_8305_ = _e3697;
                                            phi_8306_ = _e3695;
                                            phi_8307_ = false;
                                        } else {
                                            phi_8304_ = f64();
                                            phi_8305_ = false;
                                            phi_8306_ = false;
                                            phi_8307_ = true;
                                        }
                                        let _e3699 = phi_8304_;
                                        let _e3701 = phi_8305_;
                                        let _e3703 = phi_8306_;
                                        let _e3705 = phi_8307_;
                                        phi_8308_ = _e3699;
                                        phi_8309_ = _e3701;
                                        phi_8310_ = _e3703;
                                        phi_8311_ = _e3705;
                                    }
                                    let _e3707 = phi_8308_;
                                    let _e3709 = phi_8309_;
                                    let _e3711 = phi_8310_;
                                    let _e3713 = phi_8311_;
                                    phi_8312_ = _e3707;
                                    phi_8313_ = _e2287;
                                    phi_8314_ = _e3709;
                                    phi_8315_ = _e3711;
                                    phi_8316_ = _e3713;
                                }
                                let _e3715 = phi_8312_;
                                let _e3717 = phi_8313_;
                                let _e3719 = phi_8314_;
                                let _e3721 = phi_8315_;
                                let _e3723 = phi_8316_;
                                if _e3717 {
                                    phi_8320_ = true;
                                    phi_8321_ = false;
                                    phi_8322_ = false;
                                } else {
                                    phi_8320_ = _e3719;
                                    phi_8321_ = _e3721;
                                    phi_8322_ = _e3723;
                                }
                                let _e3725 = phi_8320_;
                                let _e3727 = phi_8321_;
                                let _e3729 = phi_8322_;
                                phi_8323_ = _e3715;
                                phi_8324_ = _e1554;
                                phi_8325_ = _e3725;
                                phi_8326_ = false;
                                phi_8327_ = _e3727;
                                phi_8328_ = _e3729;
                            } else {
                                phi_8323_ = f64();
                                phi_8324_ = type_45();
                                phi_8325_ = false;
                                phi_8326_ = true;
                                phi_8327_ = false;
                                phi_8328_ = false;
                            }
                            let _e3731 = phi_8323_;
                            let _e3733 = phi_8324_;
                            let _e3735 = phi_8325_;
                            let _e3737 = phi_8326_;
                            let _e3739 = phi_8327_;
                            let _e3741 = phi_8328_;
                            local_21 = _e3737;
                            local_41 = _e3739;
                            local_42 = _e3741;
                            local_22 = _e3731;
                            local_23 = _e3733;
                            continue;
                            continuing {
                                phi_4635_ = _e1267;
                                break if !(_e3735);
                            }
                        }
                        let _e3744 = local_21;
                        if _e3744 {
                            phi_8333_ = type_44(0u, type_44().member_1);
                            phi_8334_ = false;
                            phi_8335_ = false;
                        } else {
                            phi_8333_ = type_44();
                            let _e6215 = local_41;
                            phi_8334_ = _e6215;
                            let _e6218 = local_42;
                            phi_8335_ = _e6218;
                        }
                        let _e3748 = phi_8333_;
                        let _e3750 = phi_8334_;
                        let _e3752 = phi_8335_;
                        if _e3750 {
                            let _e3754 = local_22;
                            phi_8340_ = type_44(2u, _e3754);
                            phi_8341_ = false;
                        } else {
                            phi_8340_ = type_44();
                            phi_8341_ = _e3752;
                        }
                        let _e3757 = phi_8340_;
                        let _e3759 = phi_8341_;
                        if _e3759 {
                            let _e3761 = local_23;
                            phi_8347_ = type_44(1u, _e3761.member);
                            phi_8348_ = true;
                        } else {
                            phi_8347_ = _e3757;
                            phi_8348_ = _e3750;
                        }
                        let _e3765 = phi_8347_;
                        let _e3767 = phi_8348_;
                        if _e3767 {
                            phi_8352_ = _e3765;
                        } else {
                            phi_8352_ = _e3748;
                        }
                        let _e3769 = phi_8352_;
                        phi_8356_ = _e3769;
                    }
                    let _e5542 = phi_8356_;
                    phi_8357_ = _e5542;
                }
                let _e5546 = phi_8357_;
                switch bitcast<i32>(_e5546.member) {
                    case 0: {
                        phi_8370_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5552 = function_(_e5546.member_1);
                        phi_8370_ = type_32(0u, _e5552, true);
                        break;
                    }
                    case 2: {
                        let _e5550 = function_(_e5546.member_1);
                        phi_8370_ = type_32(1u, _e5550, true);
                        break;
                    }
                    default: {
                        phi_8370_ = type_32();
                        break;
                    }
                }
                let _e5555 = phi_8370_;
                if _e5555.member_2 {
                    let _e5562 = (_e5555.member_1[1] >> bitcast<u32>(20i));
                    if (_e5562 <= 896u) {
                        phi_8393_ = 0u;
                    } else {
                        phi_8393_ = ((((_e5562 - 896u) << bitcast<u32>(23i)) | ((_e5555.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5555.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5577 = phi_8393_;
                    let _e5579 = atomicMin((&earliest.member[0u]), _e5577);
                }
                phi_8397_ = type_22(1u, _e5555.member, _e181, _e184, _e5555.member_1);
                phi_8398_ = _e5555.member_2;
            } else {
                phi_8397_ = type_22(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8398_ = false;
            }
            let _e5581 = phi_8397_;
            let _e5583 = phi_8398_;
            let _e5586 = params.member.member.member_1;
            if ((_e5586 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5583 {
                    let _e5592 = atomicAdd((&counters[0u]), 1u);
                    phi_8417_ = _e5592;
                } else {
                    phi_8417_ = 0u;
                }
                let _e5594 = phi_8417_;
                workgroupBarrier();
                if (_e110 == 0u) {
                    let _e5597 = atomicLoad((&counters[0u]));
                    if (_e5597 > 0u) {
                        let _e5600 = atomicAdd((&contacts.member[0u]), _e5597);
                        atomicStore((&counters[1u]), _e5600);
                    }
                }
                workgroupBarrier();
                let _e5603 = atomicLoad((&counters[1u]));
                let _e5604 = (_e5603 + _e5594);
                if _e5583 {
                    let _e5607 = params.member.member_1.member_3;
                    if (_e5604 < _e5607) {
                        let _e5609 = (6u * _e5604);
                        atomicStore((&contacts.member[(4u + _e5609)]), _e5581.member);
                        atomicStore((&contacts.member[(_e5609 + 5u)]), _e5581.member_1);
                        atomicStore((&contacts.member[(_e5609 + 6u)]), _e5581.member_2);
                        atomicStore((&contacts.member[(_e5609 + 7u)]), _e5581.member_3);
                        atomicStore((&contacts.member[(_e5609 + 8u)]), _e5581.member_4[0]);
                        atomicStore((&contacts.member[(_e5609 + 9u)]), _e5581.member_4[1]);
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
