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
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_28;
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
    var phi_9040_: array<f64, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_9040_ = param_2;
    } else {
        phi_9040_ = param_1;
    }
    let _e26 = phi_9040_;
    return _e26;
}

fn function_2(param_3: array<f64, 3>, param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: u32) -> array<f64, 3> {
    var phi_8604_: bool;
    var phi_8605_: bool;
    var phi_8606_: bool;
    var phi_8607_: bool;
    var phi_8611_: bool;
    var phi_8584_: bool;
    var phi_8585_: bool;
    var phi_8586_: bool;
    var phi_8587_: bool;
    var phi_8588_: bool;
    var phi_8589_: bool;
    var phi_8593_: bool;
    var phi_8612_: bool;
    var phi_8642_: array<f64, 3>;
    var phi_8643_: bool;
    var phi_8644_: array<f64, 3>;
    var phi_8645_: bool;
    var phi_8891_: f64;
    var phi_8893_: f64;
    var phi_8935_: f64;
    var phi_8937_: f64;
    var phi_8985_: f64;
    var phi_8987_: f64;
    var phi_8696_: f64;
    var phi_8698_: f64;
    var phi_8746_: f64;
    var phi_8748_: f64;
    var phi_8793_: f64;
    var phi_8795_: f64;
    var phi_8846_: f64;
    var phi_8848_: f64;
    var phi_9002_: array<array<f64, 3>, 4>;
    var phi_9010_: array<f64, 3>;

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
                    phi_8584_ = (_e78 <= _e70);
                    phi_8585_ = false;
                } else {
                    phi_8584_ = bool();
                    phi_8585_ = true;
                }
                let _e99 = phi_8584_;
                let _e101 = phi_8585_;
                phi_8586_ = _e99;
                phi_8587_ = _e101;
            } else {
                phi_8586_ = bool();
                phi_8587_ = true;
            }
            let _e103 = phi_8586_;
            let _e105 = phi_8587_;
            phi_8588_ = _e103;
            phi_8589_ = _e105;
        } else {
            phi_8588_ = bool();
            phi_8589_ = true;
        }
        let _e107 = phi_8588_;
        let _e109 = phi_8589_;
        if _e109 {
            phi_8593_ = false;
        } else {
            phi_8593_ = _e107;
        }
        let _e111 = phi_8593_;
        phi_8612_ = _e111;
    } else {
        if (_e74 >= _e69) {
            if (_e78 >= _e69) {
                phi_8604_ = ((_e74 + _e78) <= _e70);
                phi_8605_ = false;
            } else {
                phi_8604_ = bool();
                phi_8605_ = true;
            }
            let _e85 = phi_8604_;
            let _e87 = phi_8605_;
            phi_8606_ = _e85;
            phi_8607_ = _e87;
        } else {
            phi_8606_ = bool();
            phi_8607_ = true;
        }
        let _e89 = phi_8606_;
        let _e91 = phi_8607_;
        if _e91 {
            phi_8611_ = false;
        } else {
            phi_8611_ = _e89;
        }
        let _e93 = phi_8611_;
        phi_8612_ = _e93;
    }
    let _e113 = phi_8612_;
    if (_e68 > _e69) {
        if _e113 {
            phi_8642_ = array<f64, 3>((param_3[0] - ((param_4[0] * _e74) + (param_5[0] * _e78))), (param_3[1] - ((param_4[1] * _e74) + (param_5[1] * _e78))), (param_3[2] - ((param_4[2] * _e74) + (param_5[2] * _e78))));
            phi_8643_ = false;
        } else {
            phi_8642_ = array<f64, 3>();
            phi_8643_ = true;
        }
        let _e138 = phi_8642_;
        let _e140 = phi_8643_;
        phi_8644_ = _e138;
        phi_8645_ = _e140;
    } else {
        phi_8644_ = array<f64, 3>();
        phi_8645_ = true;
    }
    let _e142 = phi_8644_;
    let _e144 = phi_8645_;
    if _e144 {
        let _e147 = (param_3[0] - param_4[0]);
        let _e150 = (param_3[1] - param_4[1]);
        let _e153 = (param_3[2] - param_4[2]);
        if (param_6 != 0u) {
            let _e307 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e307 > f64(0f)) {
                if (_e307 < f64(1f)) {
                    phi_8696_ = _e307;
                } else {
                    phi_8696_ = f64(1f);
                }
                let _e315 = phi_8696_;
                phi_8698_ = _e315;
            } else {
                phi_8698_ = f64(0f);
            }
            let _e317 = phi_8698_;
            let _e353 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e353 > f64(0f)) {
                if (_e353 < f64(1f)) {
                    phi_8746_ = _e353;
                } else {
                    phi_8746_ = f64(1f);
                }
                let _e361 = phi_8746_;
                phi_8748_ = _e361;
            } else {
                phi_8748_ = f64(0f);
            }
            let _e363 = phi_8748_;
            let _e396 = ((((_e147 * param_5[0]) + (_e150 * param_5[1])) + (_e153 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e396 > f64(0f)) {
                if (_e396 < f64(1f)) {
                    phi_8793_ = _e396;
                } else {
                    phi_8793_ = f64(1f);
                }
                let _e404 = phi_8793_;
                phi_8795_ = _e404;
            } else {
                phi_8795_ = f64(0f);
            }
            let _e406 = phi_8795_;
            let _e419 = (param_3[0] - param_5[0]);
            let _e422 = (param_3[1] - param_5[1]);
            let _e425 = (param_3[2] - param_5[2]);
            let _e445 = ((((_e419 * param_4[0]) + (_e422 * param_4[1])) + (_e425 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e445 > f64(0f)) {
                if (_e445 < f64(1f)) {
                    phi_8846_ = _e445;
                } else {
                    phi_8846_ = f64(1f);
                }
                let _e453 = phi_8846_;
                phi_8848_ = _e453;
            } else {
                phi_8848_ = f64(0f);
            }
            let _e455 = phi_8848_;
            phi_9002_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e317)), (param_3[1] - (param_4[1] * _e317)), (param_3[2] - (param_4[2] * _e317))), array<f64, 3>((param_3[0] - (param_5[0] * _e363)), (param_3[1] - (param_5[1] * _e363)), (param_3[2] - (param_5[2] * _e363))), array<f64, 3>((_e147 - (param_5[0] * _e406)), (_e150 - (param_5[1] * _e406)), (_e153 - (param_5[2] * _e406))), array<f64, 3>((_e419 - (param_4[0] * _e455)), (_e422 - (param_4[1] * _e455)), (_e425 - (param_4[2] * _e455))));
        } else {
            let _e157 = (param_5[0] - param_4[0]);
            let _e160 = (param_5[1] - param_4[1]);
            let _e163 = (param_5[2] - param_4[2]);
            let _e174 = ((((_e147 * _e157) + (_e150 * _e160)) + (_e153 * _e163)) / (((_e157 * _e157) + (_e160 * _e160)) + (_e163 * _e163)));
            if (_e174 > f64(0f)) {
                if (_e174 < f64(1f)) {
                    phi_8891_ = _e174;
                } else {
                    phi_8891_ = f64(1f);
                }
                let _e182 = phi_8891_;
                phi_8893_ = _e182;
            } else {
                phi_8893_ = f64(0f);
            }
            let _e184 = phi_8893_;
            let _e191 = array<f64, 3>((_e147 - (_e157 * _e184)), (_e150 - (_e160 * _e184)), (_e153 - (_e163 * _e184)));
            let _e214 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
            if (_e214 > f64(0f)) {
                if (_e214 < f64(1f)) {
                    phi_8935_ = _e214;
                } else {
                    phi_8935_ = f64(1f);
                }
                let _e222 = phi_8935_;
                phi_8937_ = _e222;
            } else {
                phi_8937_ = f64(0f);
            }
            let _e224 = phi_8937_;
            let _e260 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
            if (_e260 > f64(0f)) {
                if (_e260 < f64(1f)) {
                    phi_8985_ = _e260;
                } else {
                    phi_8985_ = f64(1f);
                }
                let _e268 = phi_8985_;
                phi_8987_ = _e268;
            } else {
                phi_8987_ = f64(0f);
            }
            let _e270 = phi_8987_;
            phi_9002_ = array<array<f64, 3>, 4>(array<f64, 3>((param_3[0] - (param_4[0] * _e224)), (param_3[1] - (param_4[1] * _e224)), (param_3[2] - (param_4[2] * _e224))), array<f64, 3>((param_3[0] - (param_5[0] * _e270)), (param_3[1] - (param_5[1] * _e270)), (param_3[2] - (param_5[2] * _e270))), _e191, _e191);
        }
        let _e468 = phi_9002_;
        let _e471 = function_1(_e468[0], _e468[1]);
        let _e473 = function_1(_e471, _e468[2]);
        let _e475 = function_1(_e473, _e468[3]);
        phi_9010_ = _e475;
    } else {
        phi_9010_ = _e142;
    }
    let _e477 = phi_9010_;
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
    var phi_241_: u32;
    var phi_257_: u32;
    var phi_278_: u32;
    var phi_279_: u32;
    var phi_282_: type_9;
    var phi_283_: type_9;
    var phi_306_: type_9;
    var phi_564_: type_42;
    var phi_658_: f64;
    var phi_664_: f64;
    var phi_669_: f64;
    var phi_675_: f64;
    var phi_680_: f64;
    var phi_686_: f64;
    var phi_692_: f64;
    var phi_697_: f64;
    var phi_703_: f64;
    var phi_708_: f64;
    var phi_713_: f64;
    var phi_720_: f64;
    var phi_726_: f64;
    var phi_731_: f64;
    var phi_737_: f64;
    var phi_742_: f64;
    var phi_748_: f64;
    var phi_754_: f64;
    var phi_759_: f64;
    var phi_765_: f64;
    var phi_770_: f64;
    var phi_775_: f64;
    var phi_782_: f64;
    var phi_788_: f64;
    var phi_793_: f64;
    var phi_799_: f64;
    var phi_804_: f64;
    var phi_810_: f64;
    var phi_816_: f64;
    var phi_821_: f64;
    var phi_827_: f64;
    var phi_832_: f64;
    var phi_837_: f64;
    var phi_843_: f64;
    var phi_848_: f64;
    var phi_857_: bool;
    var phi_881_: u64;
    var phi_893_: f64;
    var phi_894_: f64;
    var phi_925_: type_43;
    var phi_926_: bool;
    var phi_927_: type_43;
    var phi_928_: bool;
    var phi_929_: type_43;
    var phi_930_: bool;
    var phi_935_: type_43;
    var phi_1217_: f64;
    var phi_1224_: f64;
    var phi_1229_: f64;
    var phi_1236_: f64;
    var phi_1241_: f64;
    var phi_1254_: f64;
    var phi_1261_: f64;
    var phi_1266_: f64;
    var phi_1273_: f64;
    var phi_1278_: f64;
    var phi_1283_: f64;
    var phi_1300_: f64;
    var phi_1307_: f64;
    var phi_1312_: f64;
    var phi_1319_: f64;
    var phi_1324_: f64;
    var phi_1338_: f64;
    var phi_1345_: f64;
    var phi_1350_: f64;
    var phi_1357_: f64;
    var phi_1362_: f64;
    var phi_1367_: f64;
    var phi_1384_: f64;
    var phi_1391_: f64;
    var phi_1396_: f64;
    var phi_1403_: f64;
    var phi_1408_: f64;
    var phi_1422_: f64;
    var phi_1429_: f64;
    var phi_1434_: f64;
    var phi_1441_: f64;
    var phi_1446_: f64;
    var phi_1451_: f64;
    var phi_1488_: f64;
    var phi_1494_: f64;
    var phi_1501_: f64;
    var phi_1508_: f64;
    var phi_1514_: f64;
    var phi_1521_: f64;
    var phi_1527_: f64;
    var phi_1533_: f64;
    var phi_1539_: f64;
    var phi_1546_: f64;
    var phi_1553_: f64;
    var phi_1581_: f64;
    var phi_1586_: f64;
    var phi_1591_: f64;
    var phi_1596_: f64;
    var phi_1601_: f64;
    var phi_1606_: f64;
    var phi_1617_: f64;
    var phi_4357_: f64;
    var phi_4363_: f64;
    var phi_4368_: f64;
    var phi_4374_: f64;
    var phi_4380_: f64;
    var phi_4385_: f64;
    var phi_4390_: f64;
    var phi_4400_: bool;
    var phi_4407_: f64;
    var phi_4415_: f64;
    var phi_4458_: type_16;
    var phi_4461_: f64;
    var phi_4482_: bool;
    var phi_4488_: type_17;
    var phi_4459_: type_16;
    var phi_4502_: type_17;
    var phi_4462_: f64;
    var local_13: f64;
    var phi_4451_: f64;
    var phi_4515_: f64;
    var phi_4521_: f64;
    var phi_4546_: type_9;
    var phi_4549_: u32;
    var phi_4547_: type_9;
    var phi_4572_: type_9;
    var phi_4616_: u32;
    var phi_4617_: u32;
    var phi_4550_: u32;
    var phi_4618_: u32;
    var phi_4638_: type_9;
    var phi_4639_: type_9;
    var phi_4662_: type_9;
    var phi_4716_: f64;
    var phi_4723_: f64;
    var phi_4735_: bool;
    var phi_4736_: bool;
    var phi_4737_: bool;
    var phi_4738_: bool;
    var phi_4742_: bool;
    var phi_4754_: type_45;
    var phi_4755_: type_45;
    var phi_4756_: bool;
    var phi_4757_: type_45;
    var phi_4758_: bool;
    var phi_4771_: f64;
    var phi_4784_: type_9;
    var phi_4787_: f64;
    var phi_4789_: f64;
    var phi_4791_: f64;
    var phi_4785_: type_9;
    var phi_4814_: type_9;
    var phi_4841_: f64;
    var phi_4842_: f64;
    var phi_4870_: f64;
    var phi_4886_: f64;
    var phi_4893_: bool;
    var phi_4894_: bool;
    var phi_4895_: bool;
    var phi_4901_: f64;
    var phi_4902_: f64;
    var phi_4903_: bool;
    var phi_4788_: f64;
    var phi_4790_: f64;
    var phi_4792_: f64;
    var phi_4904_: f64;
    var phi_4905_: bool;
    var phi_4906_: bool;
    var local_14: bool;
    var phi_4910_: f64;
    var phi_4911_: f64;
    var phi_4921_: f64;
    var phi_4926_: type_9;
    var phi_4929_: f64;
    var phi_4927_: type_9;
    var phi_4952_: type_9;
    var phi_4983_: f64;
    var phi_4984_: bool;
    var phi_4985_: f64;
    var phi_4986_: bool;
    var phi_4987_: bool;
    var phi_4988_: bool;
    var phi_4989_: f64;
    var phi_4930_: f64;
    var phi_4990_: bool;
    var phi_4991_: bool;
    var phi_4992_: bool;
    var phi_4993_: bool;
    var local_15: bool;
    var phi_4997_: bool;
    var phi_4998_: bool;
    var phi_5002_: bool;
    var phi_5006_: f64;
    var phi_5007_: f64;
    var phi_5009_: type_45;
    var phi_5040_: f64;
    var phi_5047_: f64;
    var phi_5052_: f64;
    var phi_5059_: f64;
    var phi_5064_: f64;
    var phi_5077_: f64;
    var phi_5084_: f64;
    var phi_5089_: f64;
    var phi_5096_: f64;
    var phi_5101_: f64;
    var phi_5106_: f64;
    var phi_5165_: f64;
    var phi_5171_: f64;
    var phi_5176_: f64;
    var phi_5182_: f64;
    var phi_5187_: f64;
    var phi_5201_: f64;
    var phi_5207_: f64;
    var phi_5212_: f64;
    var phi_5218_: f64;
    var phi_5223_: f64;
    var phi_5249_: f64;
    var phi_5256_: f64;
    var phi_5261_: f64;
    var phi_5268_: f64;
    var phi_5273_: f64;
    var phi_5286_: f64;
    var phi_5293_: f64;
    var phi_5298_: f64;
    var phi_5305_: f64;
    var phi_5310_: f64;
    var phi_5315_: f64;
    var phi_5374_: f64;
    var phi_5380_: f64;
    var phi_5385_: f64;
    var phi_5391_: f64;
    var phi_5396_: f64;
    var phi_5410_: f64;
    var phi_5416_: f64;
    var phi_5421_: f64;
    var phi_5427_: f64;
    var phi_5432_: f64;
    var phi_5458_: f64;
    var phi_5465_: f64;
    var phi_5470_: f64;
    var phi_5477_: f64;
    var phi_5482_: f64;
    var phi_5495_: f64;
    var phi_5502_: f64;
    var phi_5507_: f64;
    var phi_5514_: f64;
    var phi_5519_: f64;
    var phi_5524_: f64;
    var phi_5583_: f64;
    var phi_5589_: f64;
    var phi_5594_: f64;
    var phi_5600_: f64;
    var phi_5605_: f64;
    var phi_5619_: f64;
    var phi_5625_: f64;
    var phi_5630_: f64;
    var phi_5636_: f64;
    var phi_5641_: f64;
    var phi_5690_: f64;
    var phi_5696_: f64;
    var phi_5724_: f64;
    var phi_5730_: f64;
    var phi_5735_: u32;
    var phi_5736_: u32;
    var phi_5706_: f64;
    var phi_5712_: f64;
    var phi_5717_: u32;
    var phi_5718_: u32;
    var phi_5737_: u32;
    var phi_5738_: u32;
    var phi_5811_: f64;
    var phi_5823_: f64;
    var phi_5966_: f64;
    var phi_5972_: f64;
    var phi_5979_: f64;
    var phi_6035_: type_9;
    var phi_6038_: bool;
    var phi_6036_: type_9;
    var phi_6061_: type_9;
    var phi_6088_: bool;
    var phi_6089_: bool;
    var phi_6039_: bool;
    var phi_6090_: bool;
    var phi_6091_: bool;
    var local_16: bool;
    var phi_6095_: bool;
    var local_17: bool;
    var phi_6102_: u32;
    var phi_6103_: u32;
    var phi_6104_: bool;
    var phi_6105_: u32;
    var phi_6106_: u32;
    var phi_6107_: bool;
    var phi_6111_: u32;
    var phi_6132_: bool;
    var phi_6133_: bool;
    var phi_6134_: bool;
    var phi_6283_: f64;
    var phi_6290_: f64;
    var phi_6295_: f64;
    var phi_6302_: f64;
    var phi_6307_: f64;
    var phi_6320_: f64;
    var phi_6327_: f64;
    var phi_6332_: f64;
    var phi_6339_: f64;
    var phi_6344_: f64;
    var phi_6349_: f64;
    var phi_6366_: f64;
    var phi_6373_: f64;
    var phi_6378_: f64;
    var phi_6385_: f64;
    var phi_6390_: f64;
    var phi_6404_: f64;
    var phi_6411_: f64;
    var phi_6416_: f64;
    var phi_6423_: f64;
    var phi_6428_: f64;
    var phi_6433_: f64;
    var phi_6450_: f64;
    var phi_6457_: f64;
    var phi_6462_: f64;
    var phi_6469_: f64;
    var phi_6474_: f64;
    var phi_6488_: f64;
    var phi_6495_: f64;
    var phi_6500_: f64;
    var phi_6507_: f64;
    var phi_6512_: f64;
    var phi_6517_: f64;
    var phi_6561_: type_9;
    var phi_6564_: f64;
    var phi_6566_: f64;
    var phi_6568_: f64;
    var phi_6570_: bool;
    var phi_6572_: u32;
    var phi_6562_: type_9;
    var phi_6595_: type_9;
    var phi_6710_: f64;
    var phi_6716_: f64;
    var phi_6722_: f64;
    var phi_6724_: array<f64, 3>;
    var phi_6731_: f64;
    var phi_6738_: f64;
    var phi_6746_: f64;
    var phi_6792_: type_16;
    var phi_6795_: f64;
    var phi_6816_: bool;
    var phi_6822_: type_17;
    var phi_6793_: type_16;
    var phi_6836_: type_17;
    var phi_6796_: f64;
    var local_18: f64;
    var phi_6785_: f64;
    var phi_6849_: f64;
    var phi_6918_: f64;
    var phi_6924_: f64;
    var phi_6933_: f64;
    var phi_6939_: f64;
    var phi_6948_: f64;
    var phi_6954_: f64;
    var phi_6963_: f64;
    var phi_6969_: f64;
    var phi_6975_: type_34;
    var phi_6976_: bool;
    var phi_6977_: type_34;
    var phi_6978_: bool;
    var phi_6988_: type_34;
    var phi_7160_: bool;
    var phi_7161_: bool;
    var phi_7162_: bool;
    var phi_7163_: bool;
    var phi_7164_: bool;
    var phi_7165_: bool;
    var phi_7169_: bool;
    var phi_7467_: bool;
    var phi_7468_: bool;
    var phi_7469_: bool;
    var phi_7470_: bool;
    var phi_7471_: bool;
    var phi_7472_: bool;
    var phi_7476_: bool;
    var phi_7480_: bool;
    var phi_7491_: bool;
    var phi_7492_: bool;
    var phi_7566_: bool;
    var phi_7567_: bool;
    var phi_7590_: f64;
    var phi_7591_: bool;
    var phi_7592_: f64;
    var phi_7593_: bool;
    var phi_7594_: f64;
    var phi_7595_: bool;
    var phi_7596_: bool;
    var phi_7601_: f64;
    var phi_7602_: bool;
    var phi_7606_: f64;
    var phi_7638_: bool;
    var phi_7639_: bool;
    var phi_7662_: f64;
    var phi_7663_: bool;
    var phi_7664_: f64;
    var phi_7665_: bool;
    var phi_7666_: f64;
    var phi_7667_: bool;
    var phi_7668_: bool;
    var phi_7673_: f64;
    var phi_7674_: bool;
    var phi_7678_: f64;
    var phi_7683_: f64;
    var phi_7715_: bool;
    var phi_7716_: bool;
    var phi_7739_: f64;
    var phi_7740_: bool;
    var phi_7741_: f64;
    var phi_7742_: bool;
    var phi_7743_: f64;
    var phi_7744_: bool;
    var phi_7745_: bool;
    var phi_7750_: f64;
    var phi_7751_: bool;
    var phi_7755_: f64;
    var phi_7787_: bool;
    var phi_7788_: bool;
    var phi_7811_: f64;
    var phi_7812_: bool;
    var phi_7813_: f64;
    var phi_7814_: bool;
    var phi_7815_: f64;
    var phi_7816_: bool;
    var phi_7817_: bool;
    var phi_7822_: f64;
    var phi_7823_: bool;
    var phi_7827_: f64;
    var phi_7832_: f64;
    var phi_7837_: f64;
    var phi_7842_: f64;
    var phi_7852_: f64;
    var phi_7853_: f64;
    var phi_7854_: bool;
    var phi_7855_: f64;
    var phi_7856_: f64;
    var phi_7857_: bool;
    var phi_7858_: bool;
    var phi_7859_: bool;
    var phi_7860_: f64;
    var phi_7861_: f64;
    var phi_7862_: bool;
    var phi_7863_: bool;
    var phi_7864_: bool;
    var phi_7865_: bool;
    var phi_7866_: f64;
    var phi_7867_: f64;
    var phi_7868_: bool;
    var phi_7869_: bool;
    var phi_7870_: bool;
    var phi_7871_: bool;
    var phi_7957_: f64;
    var phi_8030_: f64;
    var phi_8035_: f64;
    var phi_8108_: f64;
    var phi_8181_: f64;
    var phi_8186_: f64;
    var phi_8207_: f64;
    var phi_8208_: f64;
    var phi_8209_: f64;
    var phi_7884_: bool;
    var phi_8211_: u32;
    var phi_8212_: f64;
    var phi_8213_: bool;
    var phi_8214_: bool;
    var phi_8215_: bool;
    var phi_8216_: u32;
    var phi_8217_: f64;
    var phi_8218_: f64;
    var phi_8219_: f64;
    var phi_8220_: bool;
    var phi_8221_: u32;
    var phi_8222_: bool;
    var phi_8223_: bool;
    var phi_8224_: bool;
    var phi_8225_: bool;
    var phi_8226_: bool;
    var phi_8235_: f64;
    var phi_8240_: f64;
    var phi_8250_: bool;
    var phi_8254_: bool;
    var phi_8255_: f64;
    var phi_8256_: f64;
    var phi_8257_: f64;
    var phi_8258_: bool;
    var phi_8259_: u32;
    var phi_8260_: bool;
    var phi_8261_: bool;
    var phi_8262_: bool;
    var phi_8263_: bool;
    var phi_8264_: bool;
    var phi_6565_: f64;
    var phi_6567_: f64;
    var phi_6569_: f64;
    var phi_6571_: bool;
    var phi_6573_: u32;
    var phi_8265_: f64;
    var phi_8266_: bool;
    var phi_8267_: bool;
    var phi_8268_: bool;
    var phi_8269_: bool;
    var phi_8270_: bool;
    var phi_8271_: bool;
    var local_19: bool;
    var phi_8275_: f64;
    var phi_8276_: bool;
    var phi_8277_: bool;
    var phi_8278_: bool;
    var phi_8279_: bool;
    var phi_8284_: type_44;
    var phi_8285_: bool;
    var phi_8286_: bool;
    var phi_8287_: bool;
    var local_20: f64;
    var phi_8292_: type_44;
    var phi_8293_: bool;
    var phi_8294_: bool;
    var phi_8299_: type_44;
    var phi_8300_: bool;
    var phi_8301_: bool;
    var phi_8306_: type_44;
    var phi_8307_: bool;
    var phi_8311_: type_44;
    var phi_8318_: bool;
    var phi_8319_: f64;
    var phi_8320_: bool;
    var phi_8321_: bool;
    var phi_8322_: bool;
    var phi_8323_: f64;
    var phi_8324_: bool;
    var phi_8325_: bool;
    var phi_8326_: bool;
    var phi_8327_: f64;
    var phi_8328_: bool;
    var phi_8329_: bool;
    var phi_8330_: bool;
    var phi_8331_: bool;
    var phi_8335_: bool;
    var phi_8336_: bool;
    var phi_8337_: bool;
    var phi_8338_: f64;
    var phi_8339_: type_45;
    var phi_8340_: bool;
    var phi_8341_: bool;
    var phi_8342_: bool;
    var phi_8343_: bool;
    var local_21: bool;
    var phi_8348_: type_44;
    var phi_8349_: bool;
    var phi_8350_: bool;
    var local_22: f64;
    var phi_8355_: type_44;
    var phi_8356_: bool;
    var local_23: type_45;
    var phi_8362_: type_44;
    var phi_8363_: bool;
    var phi_8367_: type_44;
    var phi_1774_: f64;
    var phi_1781_: f64;
    var phi_1786_: f64;
    var phi_1793_: f64;
    var phi_1798_: f64;
    var phi_1811_: f64;
    var phi_1818_: f64;
    var phi_1823_: f64;
    var phi_1830_: f64;
    var phi_1835_: f64;
    var phi_1840_: f64;
    var phi_1857_: f64;
    var phi_1864_: f64;
    var phi_1869_: f64;
    var phi_1876_: f64;
    var phi_1881_: f64;
    var phi_1895_: f64;
    var phi_1902_: f64;
    var phi_1907_: f64;
    var phi_1914_: f64;
    var phi_1919_: f64;
    var phi_1924_: f64;
    var phi_1941_: f64;
    var phi_1948_: f64;
    var phi_1953_: f64;
    var phi_1960_: f64;
    var phi_1965_: f64;
    var phi_1979_: f64;
    var phi_1986_: f64;
    var phi_1991_: f64;
    var phi_1998_: f64;
    var phi_2003_: f64;
    var phi_2008_: f64;
    var phi_2052_: type_9;
    var phi_2055_: f64;
    var phi_2057_: f64;
    var phi_2059_: f64;
    var phi_2061_: bool;
    var phi_2063_: u32;
    var phi_2053_: type_9;
    var phi_2086_: type_9;
    var phi_2201_: f64;
    var phi_2207_: f64;
    var phi_2213_: f64;
    var phi_2215_: array<f64, 3>;
    var phi_2222_: f64;
    var phi_2229_: f64;
    var phi_2237_: f64;
    var phi_2283_: type_16;
    var phi_2286_: f64;
    var phi_2307_: bool;
    var phi_2313_: type_17;
    var phi_2284_: type_16;
    var phi_2327_: type_17;
    var phi_2287_: f64;
    var local_24: f64;
    var phi_2276_: f64;
    var phi_2340_: f64;
    var phi_2409_: f64;
    var phi_2415_: f64;
    var phi_2424_: f64;
    var phi_2430_: f64;
    var phi_2439_: f64;
    var phi_2445_: f64;
    var phi_2454_: f64;
    var phi_2460_: f64;
    var phi_2466_: type_34;
    var phi_2467_: bool;
    var phi_2468_: type_34;
    var phi_2469_: bool;
    var phi_2479_: type_34;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_2654_: bool;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_2660_: bool;
    var phi_2958_: bool;
    var phi_2959_: bool;
    var phi_2960_: bool;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2963_: bool;
    var phi_2967_: bool;
    var phi_2971_: bool;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_3057_: bool;
    var phi_3058_: bool;
    var phi_3081_: f64;
    var phi_3082_: bool;
    var phi_3083_: f64;
    var phi_3084_: bool;
    var phi_3085_: f64;
    var phi_3086_: bool;
    var phi_3087_: bool;
    var phi_3092_: f64;
    var phi_3093_: bool;
    var phi_3097_: f64;
    var phi_3129_: bool;
    var phi_3130_: bool;
    var phi_3153_: f64;
    var phi_3154_: bool;
    var phi_3155_: f64;
    var phi_3156_: bool;
    var phi_3157_: f64;
    var phi_3158_: bool;
    var phi_3159_: bool;
    var phi_3164_: f64;
    var phi_3165_: bool;
    var phi_3169_: f64;
    var phi_3174_: f64;
    var phi_3206_: bool;
    var phi_3207_: bool;
    var phi_3230_: f64;
    var phi_3231_: bool;
    var phi_3232_: f64;
    var phi_3233_: bool;
    var phi_3234_: f64;
    var phi_3235_: bool;
    var phi_3236_: bool;
    var phi_3241_: f64;
    var phi_3242_: bool;
    var phi_3246_: f64;
    var phi_3278_: bool;
    var phi_3279_: bool;
    var phi_3302_: f64;
    var phi_3303_: bool;
    var phi_3304_: f64;
    var phi_3305_: bool;
    var phi_3306_: f64;
    var phi_3307_: bool;
    var phi_3308_: bool;
    var phi_3313_: f64;
    var phi_3314_: bool;
    var phi_3318_: f64;
    var phi_3323_: f64;
    var phi_3328_: f64;
    var phi_3333_: f64;
    var phi_3343_: f64;
    var phi_3344_: f64;
    var phi_3345_: bool;
    var phi_3346_: f64;
    var phi_3347_: f64;
    var phi_3348_: bool;
    var phi_3349_: bool;
    var phi_3350_: bool;
    var phi_3351_: f64;
    var phi_3352_: f64;
    var phi_3353_: bool;
    var phi_3354_: bool;
    var phi_3355_: bool;
    var phi_3356_: bool;
    var phi_3357_: f64;
    var phi_3358_: f64;
    var phi_3359_: bool;
    var phi_3360_: bool;
    var phi_3361_: bool;
    var phi_3362_: bool;
    var phi_3448_: f64;
    var phi_3521_: f64;
    var phi_3526_: f64;
    var phi_3599_: f64;
    var phi_3672_: f64;
    var phi_3677_: f64;
    var phi_3698_: f64;
    var phi_3699_: f64;
    var phi_3700_: f64;
    var phi_3375_: bool;
    var phi_3702_: u32;
    var phi_3703_: f64;
    var phi_3704_: bool;
    var phi_3705_: bool;
    var phi_3706_: bool;
    var phi_3707_: u32;
    var phi_3708_: f64;
    var phi_3709_: f64;
    var phi_3710_: f64;
    var phi_3711_: bool;
    var phi_3712_: u32;
    var phi_3713_: bool;
    var phi_3714_: bool;
    var phi_3715_: bool;
    var phi_3716_: bool;
    var phi_3717_: bool;
    var phi_3726_: f64;
    var phi_3731_: f64;
    var phi_3741_: bool;
    var phi_3745_: bool;
    var phi_3746_: f64;
    var phi_3747_: f64;
    var phi_3748_: f64;
    var phi_3749_: bool;
    var phi_3750_: u32;
    var phi_3751_: bool;
    var phi_3752_: bool;
    var phi_3753_: bool;
    var phi_3754_: bool;
    var phi_3755_: bool;
    var phi_2056_: f64;
    var phi_2058_: f64;
    var phi_2060_: f64;
    var phi_2062_: bool;
    var phi_2064_: u32;
    var phi_3756_: f64;
    var phi_3757_: bool;
    var phi_3758_: bool;
    var phi_3759_: bool;
    var phi_3760_: bool;
    var phi_3761_: bool;
    var phi_3762_: bool;
    var local_25: bool;
    var phi_3766_: f64;
    var phi_3767_: bool;
    var phi_3768_: bool;
    var phi_3769_: bool;
    var phi_3770_: bool;
    var phi_3775_: type_44;
    var phi_3776_: bool;
    var phi_3777_: bool;
    var phi_3778_: bool;
    var local_26: f64;
    var phi_3783_: type_44;
    var phi_3784_: bool;
    var phi_3785_: bool;
    var phi_3790_: type_44;
    var phi_3791_: bool;
    var phi_3792_: bool;
    var phi_3797_: type_44;
    var phi_3798_: bool;
    var phi_3802_: type_44;
    var phi_3816_: type_9;
    var phi_3817_: type_9;
    var phi_3840_: type_9;
    var phi_3861_: f64;
    var phi_3991_: type_16;
    var phi_3994_: f64;
    var phi_4015_: bool;
    var phi_4021_: type_17;
    var phi_3992_: type_16;
    var phi_4035_: type_17;
    var phi_3995_: f64;
    var local_27: f64;
    var phi_3984_: f64;
    var phi_4048_: f64;
    var phi_4066_: f64;
    var phi_4073_: f64;
    var phi_4078_: f64;
    var phi_4085_: f64;
    var phi_4090_: f64;
    var phi_4103_: f64;
    var phi_4110_: f64;
    var phi_4115_: f64;
    var phi_4122_: f64;
    var phi_4127_: f64;
    var phi_4132_: f64;
    var phi_4149_: f64;
    var phi_4156_: f64;
    var phi_4161_: f64;
    var phi_4168_: f64;
    var phi_4173_: f64;
    var phi_4187_: f64;
    var phi_4194_: f64;
    var phi_4199_: f64;
    var phi_4206_: f64;
    var phi_4211_: f64;
    var phi_4216_: f64;
    var phi_4233_: f64;
    var phi_4240_: f64;
    var phi_4245_: f64;
    var phi_4252_: f64;
    var phi_4257_: f64;
    var phi_4271_: f64;
    var phi_4278_: f64;
    var phi_4283_: f64;
    var phi_4290_: f64;
    var phi_4295_: f64;
    var phi_4300_: f64;
    var phi_4324_: bool;
    var phi_4325_: bool;
    var phi_4326_: bool;
    var local_28: bool;
    var phi_4331_: type_44;
    var phi_4332_: bool;
    var phi_4337_: type_44;
    var phi_4338_: bool;
    var phi_4340_: type_44;
    var phi_4341_: type_44;
    var phi_4342_: bool;
    var phi_4346_: type_44;
    var phi_8371_: type_44;
    var phi_8372_: type_44;
    var phi_8385_: type_32;
    var phi_8408_: u32;
    var phi_8412_: type_22;
    var phi_8413_: bool;
    var phi_8432_: u32;
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
        phi_241_ = _e128;
    } else {
        phi_241_ = _e130;
    }
    let _e133 = phi_241_;
    let _e134 = (_e133 / 64u);
    if ((_e133 % 64u) > 0u) {
        phi_257_ = (_e134 + 1u);
    } else {
        phi_257_ = _e134;
    }
    let _e139 = phi_257_;
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
            phi_278_ = (_e143 + 1u);
        } else {
            phi_278_ = _e143;
        }
        let _e149 = phi_278_;
        phi_279_ = _e149;
    } else {
        phi_279_ = 0u;
    }
    let _e151 = phi_279_;
    phi_282_ = type_9(0u, _e151);
    loop {
        let _e154 = phi_282_;
        if (_e154.member < _e154.member_1) {
            phi_283_ = type_9((_e154.member + 1u), _e154.member_1);
            phi_306_ = type_9(1u, _e154.member);
        } else {
            phi_283_ = _e154;
            phi_306_ = type_9(0u, type_9().member_1);
        }
        let _e166 = phi_283_;
        let _e168 = phi_306_;
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
                    phi_564_ = type_42(array<array<f64, 3>, 4>(_e281, _e282, _e283, _e284), array<array<f64, 3>, 4>(_e286, _e287, _e288, _e289));
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
                    phi_564_ = type_42(array<array<f64, 3>, 4>(_e199, _e207, _e215, _e223), array<array<f64, 3>, 4>(_e205, _e213, _e221, _e229));
                }
                let _e293 = phi_564_;
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
                    phi_658_ = -(_e300);
                } else {
                    phi_658_ = _e300;
                }
                let _e385 = phi_658_;
                if (_e303 < 0.0lf) {
                    phi_664_ = -(_e303);
                } else {
                    phi_664_ = _e303;
                }
                let _e389 = phi_664_;
                if (_e385 > _e389) {
                    phi_669_ = _e385;
                } else {
                    phi_669_ = _e389;
                }
                let _e392 = phi_669_;
                if (_e306 < 0.0lf) {
                    phi_675_ = -(_e306);
                } else {
                    phi_675_ = _e306;
                }
                let _e396 = phi_675_;
                if (_e392 > _e396) {
                    phi_680_ = _e392;
                } else {
                    phi_680_ = _e396;
                }
                let _e399 = phi_680_;
                if (_e312 < 0.0lf) {
                    phi_686_ = -(_e312);
                } else {
                    phi_686_ = _e312;
                }
                let _e403 = phi_686_;
                if (_e315 < 0.0lf) {
                    phi_692_ = -(_e315);
                } else {
                    phi_692_ = _e315;
                }
                let _e407 = phi_692_;
                if (_e403 > _e407) {
                    phi_697_ = _e403;
                } else {
                    phi_697_ = _e407;
                }
                let _e410 = phi_697_;
                if (_e318 < 0.0lf) {
                    phi_703_ = -(_e318);
                } else {
                    phi_703_ = _e318;
                }
                let _e414 = phi_703_;
                if (_e410 > _e414) {
                    phi_708_ = _e410;
                } else {
                    phi_708_ = _e414;
                }
                let _e417 = phi_708_;
                if (_e399 > _e417) {
                    phi_713_ = _e399;
                } else {
                    phi_713_ = _e417;
                }
                let _e420 = phi_713_;
                let _e421 = (_e420 + _e371);
                if (_e325 < 0.0lf) {
                    phi_720_ = -(_e325);
                } else {
                    phi_720_ = _e325;
                }
                let _e425 = phi_720_;
                if (_e328 < 0.0lf) {
                    phi_726_ = -(_e328);
                } else {
                    phi_726_ = _e328;
                }
                let _e429 = phi_726_;
                if (_e425 > _e429) {
                    phi_731_ = _e425;
                } else {
                    phi_731_ = _e429;
                }
                let _e432 = phi_731_;
                if (_e331 < 0.0lf) {
                    phi_737_ = -(_e331);
                } else {
                    phi_737_ = _e331;
                }
                let _e436 = phi_737_;
                if (_e432 > _e436) {
                    phi_742_ = _e432;
                } else {
                    phi_742_ = _e436;
                }
                let _e439 = phi_742_;
                if (_e337 < 0.0lf) {
                    phi_748_ = -(_e337);
                } else {
                    phi_748_ = _e337;
                }
                let _e443 = phi_748_;
                if (_e340 < 0.0lf) {
                    phi_754_ = -(_e340);
                } else {
                    phi_754_ = _e340;
                }
                let _e447 = phi_754_;
                if (_e443 > _e447) {
                    phi_759_ = _e443;
                } else {
                    phi_759_ = _e447;
                }
                let _e450 = phi_759_;
                if (_e343 < 0.0lf) {
                    phi_765_ = -(_e343);
                } else {
                    phi_765_ = _e343;
                }
                let _e454 = phi_765_;
                if (_e450 > _e454) {
                    phi_770_ = _e450;
                } else {
                    phi_770_ = _e454;
                }
                let _e457 = phi_770_;
                if (_e439 > _e457) {
                    phi_775_ = _e439;
                } else {
                    phi_775_ = _e457;
                }
                let _e460 = phi_775_;
                let _e461 = (_e460 + _e371);
                if (_e350 < 0.0lf) {
                    phi_782_ = -(_e350);
                } else {
                    phi_782_ = _e350;
                }
                let _e465 = phi_782_;
                if (_e353 < 0.0lf) {
                    phi_788_ = -(_e353);
                } else {
                    phi_788_ = _e353;
                }
                let _e469 = phi_788_;
                if (_e465 > _e469) {
                    phi_793_ = _e465;
                } else {
                    phi_793_ = _e469;
                }
                let _e472 = phi_793_;
                if (_e356 < 0.0lf) {
                    phi_799_ = -(_e356);
                } else {
                    phi_799_ = _e356;
                }
                let _e476 = phi_799_;
                if (_e472 > _e476) {
                    phi_804_ = _e472;
                } else {
                    phi_804_ = _e476;
                }
                let _e479 = phi_804_;
                if (_e362 < 0.0lf) {
                    phi_810_ = -(_e362);
                } else {
                    phi_810_ = _e362;
                }
                let _e483 = phi_810_;
                if (_e365 < 0.0lf) {
                    phi_816_ = -(_e365);
                } else {
                    phi_816_ = _e365;
                }
                let _e487 = phi_816_;
                if (_e483 > _e487) {
                    phi_821_ = _e483;
                } else {
                    phi_821_ = _e487;
                }
                let _e490 = phi_821_;
                if (_e368 < 0.0lf) {
                    phi_827_ = -(_e368);
                } else {
                    phi_827_ = _e368;
                }
                let _e494 = phi_827_;
                if (_e490 > _e494) {
                    phi_832_ = _e490;
                } else {
                    phi_832_ = _e494;
                }
                let _e497 = phi_832_;
                if (_e479 > _e497) {
                    phi_837_ = _e479;
                } else {
                    phi_837_ = _e497;
                }
                let _e500 = phi_837_;
                let _e501 = (_e500 + _e371);
                if (_e421 > _e461) {
                    phi_843_ = _e421;
                } else {
                    phi_843_ = _e461;
                }
                let _e504 = phi_843_;
                if (_e504 > _e501) {
                    phi_848_ = _e504;
                } else {
                    phi_848_ = _e501;
                }
                let _e507 = phi_848_;
                if (_e507 <= f64(65536f)) {
                    phi_857_ = (_e507 >= f64((1f / 65536f)));
                } else {
                    phi_857_ = false;
                }
                let _e514 = phi_857_;
                if _e514 {
                    phi_929_ = type_43();
                    phi_930_ = true;
                } else {
                    if (_e507 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e507) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e521 = (9214364837600034816lu - (bitcast<u64>(_e507) & 9218868437227405312lu));
                            if (_e521 > 4503599627370496lu) {
                                phi_881_ = _e521;
                            } else {
                                phi_881_ = 4503599627370496lu;
                            }
                            let _e524 = phi_881_;
                            let _e525 = bitcast<f64>(_e524);
                            let _e526 = (_e381 * _e525);
                            if (_e381 > f64(0f)) {
                                if (_e526 > 2.2250738585072014e-308lf) {
                                    phi_893_ = _e526;
                                } else {
                                    phi_893_ = 2.2250738585072014e-308lf;
                                }
                                let _e531 = phi_893_;
                                phi_894_ = _e531;
                            } else {
                                phi_894_ = _e526;
                            }
                            let _e533 = phi_894_;
                            phi_925_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>((_e300 * _e525), (_e303 * _e525), (_e306 * _e525)), array<f64, 3>((_e312 * _e525), (_e315 * _e525), (_e318 * _e525))), array<array<f64, 3>, 2>(array<f64, 3>((_e325 * _e525), (_e328 * _e525), (_e331 * _e525)), array<f64, 3>((_e337 * _e525), (_e340 * _e525), (_e343 * _e525))), array<array<f64, 3>, 2>(array<f64, 3>((_e350 * _e525), (_e353 * _e525), (_e356 * _e525)), array<f64, 3>((_e362 * _e525), (_e365 * _e525), (_e368 * _e525))), (_e371 * _e525)), _e533);
                            phi_926_ = false;
                        } else {
                            phi_925_ = type_43();
                            phi_926_ = true;
                        }
                        let _e565 = phi_925_;
                        let _e567 = phi_926_;
                        phi_927_ = _e565;
                        phi_928_ = _e567;
                    } else {
                        phi_927_ = type_43();
                        phi_928_ = true;
                    }
                    let _e569 = phi_927_;
                    let _e571 = phi_928_;
                    phi_929_ = _e569;
                    phi_930_ = _e571;
                }
                let _e573 = phi_929_;
                let _e575 = phi_930_;
                if _e575 {
                    phi_935_ = type_43(type_40(array<array<f64, 3>, 2>(array<f64, 3>(_e300, _e303, _e306), array<f64, 3>(_e312, _e315, _e318)), array<array<f64, 3>, 2>(array<f64, 3>(_e325, _e328, _e331), array<f64, 3>(_e337, _e340, _e343)), array<array<f64, 3>, 2>(array<f64, 3>(_e350, _e353, _e356), array<f64, 3>(_e362, _e365, _e368)), _e371), _e381);
                } else {
                    phi_935_ = _e573;
                }
                let _e578 = phi_935_;
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
                    phi_1217_ = -(_e776[0]);
                } else {
                    phi_1217_ = _e776[0];
                }
                let _e783 = phi_1217_;
                if (_e776[1] < 0.0lf) {
                    phi_1224_ = -(_e776[1]);
                } else {
                    phi_1224_ = _e776[1];
                }
                let _e787 = phi_1224_;
                if (_e783 > _e787) {
                    phi_1229_ = _e783;
                } else {
                    phi_1229_ = _e787;
                }
                let _e790 = phi_1229_;
                if (_e776[2] < 0.0lf) {
                    phi_1236_ = -(_e776[2]);
                } else {
                    phi_1236_ = _e776[2];
                }
                let _e794 = phi_1236_;
                if (_e790 > _e794) {
                    phi_1241_ = _e790;
                } else {
                    phi_1241_ = _e794;
                }
                let _e797 = phi_1241_;
                let _e800 = local_12.member[1u];
                if (_e800[0] < 0.0lf) {
                    phi_1254_ = -(_e800[0]);
                } else {
                    phi_1254_ = _e800[0];
                }
                let _e807 = phi_1254_;
                if (_e800[1] < 0.0lf) {
                    phi_1261_ = -(_e800[1]);
                } else {
                    phi_1261_ = _e800[1];
                }
                let _e811 = phi_1261_;
                if (_e807 > _e811) {
                    phi_1266_ = _e807;
                } else {
                    phi_1266_ = _e811;
                }
                let _e814 = phi_1266_;
                if (_e800[2] < 0.0lf) {
                    phi_1273_ = -(_e800[2]);
                } else {
                    phi_1273_ = _e800[2];
                }
                let _e818 = phi_1273_;
                if (_e814 > _e818) {
                    phi_1278_ = _e814;
                } else {
                    phi_1278_ = _e818;
                }
                let _e821 = phi_1278_;
                if (_e797 > _e821) {
                    phi_1283_ = _e797;
                } else {
                    phi_1283_ = _e821;
                }
                let _e824 = phi_1283_;
                let _e826 = local_12.member_3;
                let _e827 = (_e824 + _e826);
                let _e830 = local_12.member_1[0u];
                if (_e830[0] < 0.0lf) {
                    phi_1300_ = -(_e830[0]);
                } else {
                    phi_1300_ = _e830[0];
                }
                let _e837 = phi_1300_;
                if (_e830[1] < 0.0lf) {
                    phi_1307_ = -(_e830[1]);
                } else {
                    phi_1307_ = _e830[1];
                }
                let _e841 = phi_1307_;
                if (_e837 > _e841) {
                    phi_1312_ = _e837;
                } else {
                    phi_1312_ = _e841;
                }
                let _e844 = phi_1312_;
                if (_e830[2] < 0.0lf) {
                    phi_1319_ = -(_e830[2]);
                } else {
                    phi_1319_ = _e830[2];
                }
                let _e848 = phi_1319_;
                if (_e844 > _e848) {
                    phi_1324_ = _e844;
                } else {
                    phi_1324_ = _e848;
                }
                let _e851 = phi_1324_;
                let _e854 = local_12.member_1[1u];
                if (_e854[0] < 0.0lf) {
                    phi_1338_ = -(_e854[0]);
                } else {
                    phi_1338_ = _e854[0];
                }
                let _e861 = phi_1338_;
                if (_e854[1] < 0.0lf) {
                    phi_1345_ = -(_e854[1]);
                } else {
                    phi_1345_ = _e854[1];
                }
                let _e865 = phi_1345_;
                if (_e861 > _e865) {
                    phi_1350_ = _e861;
                } else {
                    phi_1350_ = _e865;
                }
                let _e868 = phi_1350_;
                if (_e854[2] < 0.0lf) {
                    phi_1357_ = -(_e854[2]);
                } else {
                    phi_1357_ = _e854[2];
                }
                let _e872 = phi_1357_;
                if (_e868 > _e872) {
                    phi_1362_ = _e868;
                } else {
                    phi_1362_ = _e872;
                }
                let _e875 = phi_1362_;
                if (_e851 > _e875) {
                    phi_1367_ = _e851;
                } else {
                    phi_1367_ = _e875;
                }
                let _e878 = phi_1367_;
                let _e880 = local_12.member_3;
                let _e881 = (_e878 + _e880);
                let _e884 = local_12.member_2[0u];
                if (_e884[0] < 0.0lf) {
                    phi_1384_ = -(_e884[0]);
                } else {
                    phi_1384_ = _e884[0];
                }
                let _e891 = phi_1384_;
                if (_e884[1] < 0.0lf) {
                    phi_1391_ = -(_e884[1]);
                } else {
                    phi_1391_ = _e884[1];
                }
                let _e895 = phi_1391_;
                if (_e891 > _e895) {
                    phi_1396_ = _e891;
                } else {
                    phi_1396_ = _e895;
                }
                let _e898 = phi_1396_;
                if (_e884[2] < 0.0lf) {
                    phi_1403_ = -(_e884[2]);
                } else {
                    phi_1403_ = _e884[2];
                }
                let _e902 = phi_1403_;
                if (_e898 > _e902) {
                    phi_1408_ = _e898;
                } else {
                    phi_1408_ = _e902;
                }
                let _e905 = phi_1408_;
                let _e908 = local_12.member_2[1u];
                if (_e908[0] < 0.0lf) {
                    phi_1422_ = -(_e908[0]);
                } else {
                    phi_1422_ = _e908[0];
                }
                let _e915 = phi_1422_;
                if (_e908[1] < 0.0lf) {
                    phi_1429_ = -(_e908[1]);
                } else {
                    phi_1429_ = _e908[1];
                }
                let _e919 = phi_1429_;
                if (_e915 > _e919) {
                    phi_1434_ = _e915;
                } else {
                    phi_1434_ = _e919;
                }
                let _e922 = phi_1434_;
                if (_e908[2] < 0.0lf) {
                    phi_1441_ = -(_e908[2]);
                } else {
                    phi_1441_ = _e908[2];
                }
                let _e926 = phi_1441_;
                if (_e922 > _e926) {
                    phi_1446_ = _e922;
                } else {
                    phi_1446_ = _e926;
                }
                let _e929 = phi_1446_;
                if (_e905 > _e929) {
                    phi_1451_ = _e905;
                } else {
                    phi_1451_ = _e929;
                }
                let _e932 = phi_1451_;
                let _e934 = local_12.member_3;
                let _e935 = (_e932 + _e934);
                let _e936 = f64(1f);
                let _e937 = f64(8f);
                let _e939 = ((_e881 * _e937) * _e935);
                let _e947 = local_12.member_3;
                if (_e633 < 0.0lf) {
                    phi_1488_ = -(_e633);
                } else {
                    phi_1488_ = _e633;
                }
                let _e967 = phi_1488_;
                if (_e636 < 0.0lf) {
                    phi_1494_ = -(_e636);
                } else {
                    phi_1494_ = _e636;
                }
                let _e971 = phi_1494_;
                if (_e639 < 0.0lf) {
                    phi_1501_ = -(_e639);
                } else {
                    phi_1501_ = _e639;
                }
                let _e976 = phi_1501_;
                let _e977 = ((_e967 + _e971) + _e976);
                if (_e654 < 0.0lf) {
                    phi_1508_ = -(_e654);
                } else {
                    phi_1508_ = _e654;
                }
                let _e981 = phi_1508_;
                if (_e657 < 0.0lf) {
                    phi_1514_ = -(_e657);
                } else {
                    phi_1514_ = _e657;
                }
                let _e985 = phi_1514_;
                if (_e660 < 0.0lf) {
                    phi_1521_ = -(_e660);
                } else {
                    phi_1521_ = _e660;
                }
                let _e990 = phi_1521_;
                let _e991 = ((_e981 + _e985) + _e990);
                if (_e977 > _e991) {
                    phi_1527_ = _e977;
                } else {
                    phi_1527_ = _e991;
                }
                let _e994 = phi_1527_;
                if (_e703 < 0.0lf) {
                    phi_1533_ = -(_e703);
                } else {
                    phi_1533_ = _e703;
                }
                let _e998 = phi_1533_;
                if (_e704 < 0.0lf) {
                    phi_1539_ = -(_e704);
                } else {
                    phi_1539_ = _e704;
                }
                let _e1002 = phi_1539_;
                if (_e705 < 0.0lf) {
                    phi_1546_ = -(_e705);
                } else {
                    phi_1546_ = _e705;
                }
                let _e1007 = phi_1546_;
                let _e1009 = (((_e998 + _e1002) + _e1007) * f64(0.5f));
                if (_e994 > _e1009) {
                    phi_1553_ = _e994;
                } else {
                    phi_1553_ = _e1009;
                }
                let _e1012 = phi_1553_;
                let _e1018 = local_12.member_3;
                let _e1032 = (((((_e827 * _e937) * _e939) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e947 * f64(19f)) * ((_e827 * (_e881 + _e935)) + (_e881 * _e935)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e936 + _e827) * ((_e936 + _e881) * (_e936 + _e935)))));
                let _e1033 = f64(3f);
                let _e1034 = (_e716 * _e1033);
                let _e1035 = (_e773 * _e1033);
                if (_e1034 < _e1035) {
                    phi_1581_ = _e1034;
                } else {
                    phi_1581_ = _e1035;
                }
                let _e1038 = phi_1581_;
                if (_e739 < _e762) {
                    phi_1586_ = _e739;
                } else {
                    phi_1586_ = _e762;
                }
                let _e1041 = phi_1586_;
                if (_e1038 < _e1041) {
                    phi_1591_ = _e1038;
                } else {
                    phi_1591_ = _e1041;
                }
                let _e1044 = phi_1591_;
                if (_e1034 > _e1035) {
                    phi_1596_ = _e1034;
                } else {
                    phi_1596_ = _e1035;
                }
                let _e1047 = phi_1596_;
                if (_e739 > _e762) {
                    phi_1601_ = _e739;
                } else {
                    phi_1601_ = _e762;
                }
                let _e1050 = phi_1601_;
                if (_e1047 > _e1050) {
                    phi_1606_ = _e1047;
                } else {
                    phi_1606_ = _e1050;
                }
                let _e1053 = phi_1606_;
                let _e1059 = -(_e1053);
                if (_e1044 > _e1059) {
                    phi_1617_ = _e1044;
                } else {
                    phi_1617_ = _e1059;
                }
                let _e1062 = phi_1617_;
                if ((_e1062 - (_e1032 + ((_e578.member_1 * (((_e1012 + (_e939 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1018 * f64(6f)) * (_e881 + _e935))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e936 + _e881) * (_e936 + _e935))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                    phi_8372_ = type_44(0u, type_44().member_1);
                } else {
                    if (_e578.member_1 > f64(0f)) {
                        let _e3762 = f64(1f);
                        let _e3763 = f64(0f);
                        let _e3766 = local_12.member[0u];
                        let _e3772 = local_12.member_1[0u];
                        let _e3778 = local_12.member_2[0u];
                        let _e3782 = (_e3766[0] - _e3772[0]);
                        let _e3783 = (_e3766[1] - _e3772[1]);
                        let _e3784 = (_e3766[2] - _e3772[2]);
                        let _e3793 = local_12.member[1u];
                        let _e3799 = local_12.member_1[1u];
                        let _e3805 = local_12.member_2[1u];
                        let _e3809 = (_e3793[0] - _e3799[0]);
                        let _e3810 = (_e3793[1] - _e3799[1]);
                        let _e3811 = (_e3793[2] - _e3799[2]);
                        let _e3820 = local_12.member[0u];
                        if (_e3820[0] < 0.0lf) {
                            phi_1774_ = -(_e3820[0]);
                        } else {
                            phi_1774_ = _e3820[0];
                        }
                        let _e3827 = phi_1774_;
                        if (_e3820[1] < 0.0lf) {
                            phi_1781_ = -(_e3820[1]);
                        } else {
                            phi_1781_ = _e3820[1];
                        }
                        let _e3831 = phi_1781_;
                        if (_e3827 > _e3831) {
                            phi_1786_ = _e3827;
                        } else {
                            phi_1786_ = _e3831;
                        }
                        let _e3834 = phi_1786_;
                        if (_e3820[2] < 0.0lf) {
                            phi_1793_ = -(_e3820[2]);
                        } else {
                            phi_1793_ = _e3820[2];
                        }
                        let _e3838 = phi_1793_;
                        if (_e3834 > _e3838) {
                            phi_1798_ = _e3834;
                        } else {
                            phi_1798_ = _e3838;
                        }
                        let _e3841 = phi_1798_;
                        let _e3844 = local_12.member[1u];
                        if (_e3844[0] < 0.0lf) {
                            phi_1811_ = -(_e3844[0]);
                        } else {
                            phi_1811_ = _e3844[0];
                        }
                        let _e3851 = phi_1811_;
                        if (_e3844[1] < 0.0lf) {
                            phi_1818_ = -(_e3844[1]);
                        } else {
                            phi_1818_ = _e3844[1];
                        }
                        let _e3855 = phi_1818_;
                        if (_e3851 > _e3855) {
                            phi_1823_ = _e3851;
                        } else {
                            phi_1823_ = _e3855;
                        }
                        let _e3858 = phi_1823_;
                        if (_e3844[2] < 0.0lf) {
                            phi_1830_ = -(_e3844[2]);
                        } else {
                            phi_1830_ = _e3844[2];
                        }
                        let _e3862 = phi_1830_;
                        if (_e3858 > _e3862) {
                            phi_1835_ = _e3858;
                        } else {
                            phi_1835_ = _e3862;
                        }
                        let _e3865 = phi_1835_;
                        if (_e3841 > _e3865) {
                            phi_1840_ = _e3841;
                        } else {
                            phi_1840_ = _e3865;
                        }
                        let _e3868 = phi_1840_;
                        let _e3870 = local_12.member_3;
                        let _e3874 = local_12.member_1[0u];
                        if (_e3874[0] < 0.0lf) {
                            phi_1857_ = -(_e3874[0]);
                        } else {
                            phi_1857_ = _e3874[0];
                        }
                        let _e3881 = phi_1857_;
                        if (_e3874[1] < 0.0lf) {
                            phi_1864_ = -(_e3874[1]);
                        } else {
                            phi_1864_ = _e3874[1];
                        }
                        let _e3885 = phi_1864_;
                        if (_e3881 > _e3885) {
                            phi_1869_ = _e3881;
                        } else {
                            phi_1869_ = _e3885;
                        }
                        let _e3888 = phi_1869_;
                        if (_e3874[2] < 0.0lf) {
                            phi_1876_ = -(_e3874[2]);
                        } else {
                            phi_1876_ = _e3874[2];
                        }
                        let _e3892 = phi_1876_;
                        if (_e3888 > _e3892) {
                            phi_1881_ = _e3888;
                        } else {
                            phi_1881_ = _e3892;
                        }
                        let _e3895 = phi_1881_;
                        let _e3898 = local_12.member_1[1u];
                        if (_e3898[0] < 0.0lf) {
                            phi_1895_ = -(_e3898[0]);
                        } else {
                            phi_1895_ = _e3898[0];
                        }
                        let _e3905 = phi_1895_;
                        if (_e3898[1] < 0.0lf) {
                            phi_1902_ = -(_e3898[1]);
                        } else {
                            phi_1902_ = _e3898[1];
                        }
                        let _e3909 = phi_1902_;
                        if (_e3905 > _e3909) {
                            phi_1907_ = _e3905;
                        } else {
                            phi_1907_ = _e3909;
                        }
                        let _e3912 = phi_1907_;
                        if (_e3898[2] < 0.0lf) {
                            phi_1914_ = -(_e3898[2]);
                        } else {
                            phi_1914_ = _e3898[2];
                        }
                        let _e3916 = phi_1914_;
                        if (_e3912 > _e3916) {
                            phi_1919_ = _e3912;
                        } else {
                            phi_1919_ = _e3916;
                        }
                        let _e3919 = phi_1919_;
                        if (_e3895 > _e3919) {
                            phi_1924_ = _e3895;
                        } else {
                            phi_1924_ = _e3919;
                        }
                        let _e3922 = phi_1924_;
                        let _e3924 = local_12.member_3;
                        let _e3928 = local_12.member_2[0u];
                        if (_e3928[0] < 0.0lf) {
                            phi_1941_ = -(_e3928[0]);
                        } else {
                            phi_1941_ = _e3928[0];
                        }
                        let _e3935 = phi_1941_;
                        if (_e3928[1] < 0.0lf) {
                            phi_1948_ = -(_e3928[1]);
                        } else {
                            phi_1948_ = _e3928[1];
                        }
                        let _e3939 = phi_1948_;
                        if (_e3935 > _e3939) {
                            phi_1953_ = _e3935;
                        } else {
                            phi_1953_ = _e3939;
                        }
                        let _e3942 = phi_1953_;
                        if (_e3928[2] < 0.0lf) {
                            phi_1960_ = -(_e3928[2]);
                        } else {
                            phi_1960_ = _e3928[2];
                        }
                        let _e3946 = phi_1960_;
                        if (_e3942 > _e3946) {
                            phi_1965_ = _e3942;
                        } else {
                            phi_1965_ = _e3946;
                        }
                        let _e3949 = phi_1965_;
                        let _e3952 = local_12.member_2[1u];
                        if (_e3952[0] < 0.0lf) {
                            phi_1979_ = -(_e3952[0]);
                        } else {
                            phi_1979_ = _e3952[0];
                        }
                        let _e3959 = phi_1979_;
                        if (_e3952[1] < 0.0lf) {
                            phi_1986_ = -(_e3952[1]);
                        } else {
                            phi_1986_ = _e3952[1];
                        }
                        let _e3963 = phi_1986_;
                        if (_e3959 > _e3963) {
                            phi_1991_ = _e3959;
                        } else {
                            phi_1991_ = _e3963;
                        }
                        let _e3966 = phi_1991_;
                        if (_e3952[2] < 0.0lf) {
                            phi_1998_ = -(_e3952[2]);
                        } else {
                            phi_1998_ = _e3952[2];
                        }
                        let _e3970 = phi_1998_;
                        if (_e3966 > _e3970) {
                            phi_2003_ = _e3966;
                        } else {
                            phi_2003_ = _e3970;
                        }
                        let _e3973 = phi_2003_;
                        if (_e3949 > _e3973) {
                            phi_2008_ = _e3949;
                        } else {
                            phi_2008_ = _e3973;
                        }
                        let _e3976 = phi_2008_;
                        let _e3978 = local_12.member_3;
                        let _e3986 = local_12.member_3;
                        let _e3993 = f64(0f);
                        let _e3994 = f64(1f);
                        local_9 = type_34(array<f64, 4>(_e3993, _e3993, _e3993, _e3993), array<f64, 4>(_e3993, _e3993, _e3993, _e3993), array<f64, 4>(_e3994, _e3994, _e3994, _e3994));
                        phi_2052_ = type_9(0u, 96u);
                        phi_2055_ = _e3763;
                        phi_2057_ = _e3763;
                        phi_2059_ = _e3763;
                        phi_2061_ = false;
                        phi_2063_ = 0u;
                        loop {
                            let _e4000 = phi_2052_;
                            let _e4002 = phi_2055_;
                            let _e4004 = phi_2057_;
                            let _e4006 = phi_2059_;
                            let _e4008 = phi_2061_;
                            let _e4010 = phi_2063_;
                            local_44 = _e4004;
                            local_26 = _e4002;
                            if (_e4000.member < _e4000.member_1) {
                                phi_2053_ = type_9((_e4000.member + 1u), _e4000.member_1);
                                phi_2086_ = type_9(1u, _e4000.member);
                            } else {
                                phi_2053_ = _e4000;
                                phi_2086_ = type_9(0u, type_9().member_1);
                            }
                            let _e4022 = phi_2053_;
                            let _e4024 = phi_2086_;
                            if (bitcast<i32>(_e4024.member) != 0i) {
                                let _e4030 = local_12.member[0u];
                                let _e4036 = local_12.member[1u];
                                let _e4052 = local_12.member_1[0u];
                                let _e4058 = local_12.member_1[1u];
                                let _e4074 = local_12.member_2[0u];
                                let _e4080 = local_12.member_2[1u];
                                let _e4094 = function_2(array<f64, 3>((_e4030[0] + ((_e4036[0] - _e4030[0]) * _e4002)), (_e4030[1] + ((_e4036[1] - _e4030[1]) * _e4002)), (_e4030[2] + ((_e4036[2] - _e4030[2]) * _e4002))), array<f64, 3>((_e4052[0] + ((_e4058[0] - _e4052[0]) * _e4002)), (_e4052[1] + ((_e4058[1] - _e4052[1]) * _e4002)), (_e4052[2] + ((_e4058[2] - _e4052[2]) * _e4002))), array<f64, 3>((_e4074[0] + ((_e4080[0] - _e4074[0]) * _e4002)), (_e4074[1] + ((_e4080[1] - _e4074[1]) * _e4002)), (_e4074[2] + ((_e4080[2] - _e4074[2]) * _e4002))), 1u);
                                if (_e4010 == 0u) {
                                    phi_2215_ = _e4094;
                                } else {
                                    let _e4096 = f64(0f);
                                    if (_e4010 == 1u) {
                                        phi_2201_ = _e4094[0];
                                    } else {
                                        phi_2201_ = _e4096;
                                    }
                                    let _e4100 = phi_2201_;
                                    if (_e4010 == 2u) {
                                        phi_2207_ = _e4094[1];
                                    } else {
                                        phi_2207_ = _e4096;
                                    }
                                    let _e4104 = phi_2207_;
                                    if (_e4010 == 3u) {
                                        phi_2213_ = _e4094[2];
                                    } else {
                                        phi_2213_ = _e4096;
                                    }
                                    let _e4108 = phi_2213_;
                                    phi_2215_ = array<f64, 3>(_e4100, _e4104, _e4108);
                                }
                                let _e4111 = phi_2215_;
                                if (_e4111[0] < 0.0lf) {
                                    phi_2222_ = -(_e4111[0]);
                                } else {
                                    phi_2222_ = _e4111[0];
                                }
                                let _e4116 = phi_2222_;
                                if (_e4111[1] < 0.0lf) {
                                    phi_2229_ = -(_e4111[1]);
                                } else {
                                    phi_2229_ = _e4111[1];
                                }
                                let _e4121 = phi_2229_;
                                if (_e4111[2] < 0.0lf) {
                                    phi_2237_ = -(_e4111[2]);
                                } else {
                                    phi_2237_ = _e4111[2];
                                }
                                let _e4127 = phi_2237_;
                                let _e4128 = ((_e4116 + _e4121) + _e4127);
                                if (_e4128 > f64(0f)) {
                                    if ((bitcast<u64>(_e4128) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e4135 = (f64(1f) / _e4128);
                                        let _e4137 = (_e4111[0] * _e4135);
                                        let _e4139 = (_e4111[1] * _e4135);
                                        let _e4141 = (_e4111[2] * _e4135);
                                        let _e4146 = (((_e4137 * _e4137) + (_e4139 * _e4139)) + (_e4141 * _e4141));
                                        if (_e4146 <= 2.2250738585072014e-308lf) {
                                            if (_e4146 > 0.0lf) {
                                                phi_2276_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_2276_ = 0.0lf;
                                            }
                                            let _e4198 = phi_2276_;
                                            phi_2340_ = _e4198;
                                        } else {
                                            phi_2283_ = type_16(0i, 5i);
                                            phi_2286_ = bitcast<f64>(((bitcast<u64>(_e4146) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e4153 = phi_2283_;
                                                let _e4155 = phi_2286_;
                                                local_24 = _e4155;
                                                if (_e4153.member < _e4153.member_1) {
                                                    let _e4162 = (_e4153.member + 1i);
                                                    if ((false == (_e4162 > _e4153.member)) != false) {
                                                        phi_2307_ = true;
                                                    } else {
                                                        phi_2307_ = false;
                                                    }
                                                    let _e4167 = phi_2307_;
                                                    if _e4167 {
                                                        phi_2313_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_2313_ = type_17(1u, _e4162);
                                                    }
                                                    let _e4172 = phi_2313_;
                                                    phi_2284_ = type_16(_e4172.member_1, _e4153.member_1);
                                                    phi_2327_ = type_17(1u, _e4153.member);
                                                } else {
                                                    phi_2284_ = _e4153;
                                                    phi_2327_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e4178 = phi_2284_;
                                                let _e4180 = phi_2327_;
                                                let _e4183 = (bitcast<i32>(_e4180.member) != 0i);
                                                if _e4183 {
                                                    phi_2287_ = (0.5lf * (_e4155 + (_e4146 / _e4155)));
                                                } else {
                                                    phi_2287_ = f64();
                                                }
                                                let _e4188 = phi_2287_;
                                                continue;
                                                continuing {
                                                    phi_2283_ = _e4178;
                                                    phi_2286_ = _e4188;
                                                    break if !(_e4183);
                                                }
                                            }
                                            let _e4193 = local_24;
                                            phi_2340_ = (_e4193 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e4200 = phi_2340_;
                                        let _e4202 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e4209 = ((((((((_e3868 + _e3870) + (_e3922 + _e3924)) + (_e3976 + _e3978)) * (1.1102230246251565e-16lf * f64(16f))) + (_e3986 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e578.member_1 * _e4200) * (f64(1f) + _e4202)));
                                        let _e4214 = (((_e4137 * _e3766[0]) + (_e4139 * _e3766[1])) + (_e4141 * _e3766[2]));
                                        let _e4219 = (((_e4137 * _e3782) + (_e4139 * _e3783)) + (_e4141 * _e3784));
                                        let _e4224 = (((_e4137 * (_e3766[0] - _e3778[0])) + (_e4139 * (_e3766[1] - _e3778[1]))) + (_e4141 * (_e3766[2] - _e3778[2])));
                                        let _e4229 = (((_e4137 * (_e3782 - _e3778[0])) + (_e4139 * (_e3783 - _e3778[1]))) + (_e4141 * (_e3784 - _e3778[2])));
                                        let _e4235 = (((_e4137 * _e3793[0]) + (_e4139 * _e3793[1])) + (_e4141 * _e3793[2]));
                                        let _e4240 = (((_e4137 * _e3809) + (_e4139 * _e3810)) + (_e4141 * _e3811));
                                        let _e4245 = (((_e4137 * (_e3793[0] - _e3805[0])) + (_e4139 * (_e3793[1] - _e3805[1]))) + (_e4141 * (_e3793[2] - _e3805[2])));
                                        let _e4250 = (((_e4137 * (_e3809 - _e3805[0])) + (_e4139 * (_e3810 - _e3805[1]))) + (_e4141 * (_e3811 - _e3805[2])));
                                        if (_e4214 < 0.0lf) {
                                            phi_2409_ = -(_e4214);
                                        } else {
                                            phi_2409_ = _e4214;
                                        }
                                        let _e4255 = phi_2409_;
                                        if (_e4235 < 0.0lf) {
                                            phi_2415_ = -(_e4235);
                                        } else {
                                            phi_2415_ = _e4235;
                                        }
                                        let _e4259 = phi_2415_;
                                        if (_e4219 < 0.0lf) {
                                            phi_2424_ = -(_e4219);
                                        } else {
                                            phi_2424_ = _e4219;
                                        }
                                        let _e4266 = phi_2424_;
                                        if (_e4240 < 0.0lf) {
                                            phi_2430_ = -(_e4240);
                                        } else {
                                            phi_2430_ = _e4240;
                                        }
                                        let _e4270 = phi_2430_;
                                        if (_e4224 < 0.0lf) {
                                            phi_2439_ = -(_e4224);
                                        } else {
                                            phi_2439_ = _e4224;
                                        }
                                        let _e4277 = phi_2439_;
                                        if (_e4245 < 0.0lf) {
                                            phi_2445_ = -(_e4245);
                                        } else {
                                            phi_2445_ = _e4245;
                                        }
                                        let _e4281 = phi_2445_;
                                        if (_e4229 < 0.0lf) {
                                            phi_2454_ = -(_e4229);
                                        } else {
                                            phi_2454_ = _e4229;
                                        }
                                        let _e4288 = phi_2454_;
                                        if (_e4250 < 0.0lf) {
                                            phi_2460_ = -(_e4250);
                                        } else {
                                            phi_2460_ = _e4250;
                                        }
                                        let _e4292 = phi_2460_;
                                        phi_2466_ = type_34(array<f64, 4>(_e4214, _e4219, _e4224, _e4229), array<f64, 4>(_e4235, _e4240, _e4245, _e4250), array<f64, 4>((_e4209 + ((_e4255 + _e4259) * _e4202)), (_e4209 + ((_e4266 + _e4270) * _e4202)), (_e4209 + ((_e4277 + _e4281) * _e4202)), (_e4209 + ((_e4288 + _e4292) * _e4202))));
                                        phi_2467_ = false;
                                    } else {
                                        phi_2466_ = type_34();
                                        phi_2467_ = true;
                                    }
                                    let _e4299 = phi_2466_;
                                    let _e4301 = phi_2467_;
                                    phi_2468_ = _e4299;
                                    phi_2469_ = _e4301;
                                } else {
                                    phi_2468_ = type_34();
                                    phi_2469_ = true;
                                }
                                let _e4303 = phi_2468_;
                                let _e4305 = phi_2469_;
                                if _e4305 {
                                    let _e4306 = f64(0f);
                                    let _e4307 = f64(1f);
                                    phi_2479_ = type_34(array<f64, 4>(_e4306, _e4306, _e4306, _e4306), array<f64, 4>(_e4306, _e4306, _e4306, _e4306), array<f64, 4>(_e4307, _e4307, _e4307, _e4307));
                                } else {
                                    phi_2479_ = _e4303;
                                }
                                let _e4313 = phi_2479_;
                                local_10 = type_34(array<f64, 4>(_e4313.member[0], _e4313.member[1], _e4313.member[2], _e4313.member[3]), array<f64, 4>(_e4313.member_1[0], _e4313.member_1[1], _e4313.member_1[2], _e4313.member_1[3]), array<f64, 4>(_e4313.member_2[0], _e4313.member_2[1], _e4313.member_2[2], _e4313.member_2[3]));
                                let _e4333 = (_e4002 - _e4006);
                                let _e4335 = f64(0f);
                                let _e4338 = local_10.member[0u];
                                let _e4341 = local_10.member_1[0u];
                                let _e4344 = local_10.member[0u];
                                let _e4350 = local_10.member_2[0u];
                                if (((_e4338 + ((_e4341 - _e4344) * _e4002)) - _e4350) > _e4335) {
                                    let _e4355 = local_10.member[1u];
                                    let _e4358 = local_10.member_1[1u];
                                    let _e4361 = local_10.member[1u];
                                    let _e4367 = local_10.member_2[1u];
                                    if (((_e4355 + ((_e4358 - _e4361) * _e4002)) - _e4367) > _e4335) {
                                        let _e4372 = local_10.member[2u];
                                        let _e4375 = local_10.member_1[2u];
                                        let _e4378 = local_10.member[2u];
                                        let _e4384 = local_10.member_2[2u];
                                        if (((_e4372 + ((_e4375 - _e4378) * _e4002)) - _e4384) > _e4335) {
                                            let _e4389 = local_10.member[3u];
                                            let _e4392 = local_10.member_1[3u];
                                            let _e4395 = local_10.member[3u];
                                            let _e4401 = local_10.member_2[3u];
                                            phi_2651_ = (((_e4389 + ((_e4392 - _e4395) * _e4002)) - _e4401) > _e4335);
                                            phi_2652_ = false;
                                        } else {
                                            phi_2651_ = bool();
                                            phi_2652_ = true;
                                        }
                                        let _e4405 = phi_2651_;
                                        let _e4407 = phi_2652_;
                                        phi_2653_ = _e4405;
                                        phi_2654_ = _e4407;
                                    } else {
                                        phi_2653_ = bool();
                                        phi_2654_ = true;
                                    }
                                    let _e4409 = phi_2653_;
                                    let _e4411 = phi_2654_;
                                    phi_2655_ = _e4409;
                                    phi_2656_ = _e4411;
                                } else {
                                    phi_2655_ = bool();
                                    phi_2656_ = true;
                                }
                                let _e4413 = phi_2655_;
                                let _e4415 = phi_2656_;
                                if _e4415 {
                                    phi_2660_ = false;
                                } else {
                                    phi_2660_ = _e4413;
                                }
                                let _e4417 = phi_2660_;
                                if _e4417 {
                                    if (_e4002 <= _e4004) {
                                        phi_2971_ = true;
                                    } else {
                                        let _e4419 = f64(0f);
                                        let _e4422 = local_9.member[0u];
                                        let _e4425 = local_9.member_1[0u];
                                        let _e4428 = local_9.member[0u];
                                        let _e4434 = local_9.member_2[0u];
                                        let _e4438 = local_10.member[0u];
                                        let _e4441 = local_10.member_1[0u];
                                        let _e4444 = local_10.member[0u];
                                        let _e4450 = local_10.member_2[0u];
                                        if ((((_e4422 + ((_e4425 - _e4428) * _e4002)) - _e4434) + ((_e4438 + ((_e4441 - _e4444) * _e4006)) - _e4450)) > _e4419) {
                                            let _e4456 = local_9.member[1u];
                                            let _e4459 = local_9.member_1[1u];
                                            let _e4462 = local_9.member[1u];
                                            let _e4468 = local_9.member_2[1u];
                                            let _e4472 = local_10.member[1u];
                                            let _e4475 = local_10.member_1[1u];
                                            let _e4478 = local_10.member[1u];
                                            let _e4484 = local_10.member_2[1u];
                                            if ((((_e4456 + ((_e4459 - _e4462) * _e4002)) - _e4468) + ((_e4472 + ((_e4475 - _e4478) * _e4006)) - _e4484)) > _e4419) {
                                                let _e4490 = local_9.member[2u];
                                                let _e4493 = local_9.member_1[2u];
                                                let _e4496 = local_9.member[2u];
                                                let _e4502 = local_9.member_2[2u];
                                                let _e4506 = local_10.member[2u];
                                                let _e4509 = local_10.member_1[2u];
                                                let _e4512 = local_10.member[2u];
                                                let _e4518 = local_10.member_2[2u];
                                                if ((((_e4490 + ((_e4493 - _e4496) * _e4002)) - _e4502) + ((_e4506 + ((_e4509 - _e4512) * _e4006)) - _e4518)) > _e4419) {
                                                    let _e4524 = local_9.member[3u];
                                                    let _e4527 = local_9.member_1[3u];
                                                    let _e4530 = local_9.member[3u];
                                                    let _e4536 = local_9.member_2[3u];
                                                    let _e4540 = local_10.member[3u];
                                                    let _e4543 = local_10.member_1[3u];
                                                    let _e4546 = local_10.member[3u];
                                                    let _e4552 = local_10.member_2[3u];
                                                    phi_2958_ = ((((_e4524 + ((_e4527 - _e4530) * _e4002)) - _e4536) + ((_e4540 + ((_e4543 - _e4546) * _e4006)) - _e4552)) > _e4419);
                                                    phi_2959_ = false;
                                                } else {
                                                    phi_2958_ = bool();
                                                    phi_2959_ = true;
                                                }
                                                let _e4557 = phi_2958_;
                                                let _e4559 = phi_2959_;
                                                phi_2960_ = _e4557;
                                                phi_2961_ = _e4559;
                                            } else {
                                                phi_2960_ = bool();
                                                phi_2961_ = true;
                                            }
                                            let _e4561 = phi_2960_;
                                            let _e4563 = phi_2961_;
                                            phi_2962_ = _e4561;
                                            phi_2963_ = _e4563;
                                        } else {
                                            phi_2962_ = bool();
                                            phi_2963_ = true;
                                        }
                                        let _e4565 = phi_2962_;
                                        let _e4567 = phi_2963_;
                                        if _e4567 {
                                            phi_2967_ = false;
                                        } else {
                                            phi_2967_ = _e4565;
                                        }
                                        let _e4569 = phi_2967_;
                                        phi_2971_ = _e4569;
                                    }
                                    let _e4571 = phi_2971_;
                                    if _e4571 {
                                        if _e4008 {
                                            if (_e4002 >= _e3762) {
                                                phi_2982_ = false;
                                            } else {
                                                phi_2982_ = true;
                                            }
                                            let _e4574 = phi_2982_;
                                            phi_2983_ = _e4574;
                                        } else {
                                            phi_2983_ = true;
                                        }
                                        let _e4576 = phi_2983_;
                                        if _e4576 {
                                            local_9 = type_34(array<f64, 4>(_e4313.member[0], _e4313.member[1], _e4313.member[2], _e4313.member[3]), array<f64, 4>(_e4313.member_1[0], _e4313.member_1[1], _e4313.member_1[2], _e4313.member_1[3]), array<f64, 4>(_e4313.member_2[0], _e4313.member_2[1], _e4313.member_2[2], _e4313.member_2[3]));
                                            let _e4598 = local_9.member[0u];
                                            let _e4601 = local_9.member_1[0u];
                                            let _e4604 = local_9.member_2[0u];
                                            if (_e4598 > _e4604) {
                                                if (_e4601 > _e4604) {
                                                    phi_3057_ = false;
                                                } else {
                                                    phi_3057_ = true;
                                                }
                                                let _e4608 = phi_3057_;
                                                phi_3058_ = _e4608;
                                            } else {
                                                phi_3058_ = true;
                                            }
                                            let _e4610 = phi_3058_;
                                            if _e4610 {
                                                let _e4611 = (_e4601 >= _e4598);
                                                if _e4611 {
                                                    phi_3083_ = f64();
                                                    phi_3084_ = false;
                                                } else {
                                                    if ((_e4598 - _e4601) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3081_ = (((_e4598 - _e4604) / (_e4598 - _e4601)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3082_ = false;
                                                    } else {
                                                        phi_3081_ = f64();
                                                        phi_3082_ = true;
                                                    }
                                                    let _e4625 = phi_3081_;
                                                    let _e4627 = phi_3082_;
                                                    phi_3083_ = _e4625;
                                                    phi_3084_ = _e4627;
                                                }
                                                let _e4629 = phi_3083_;
                                                let _e4631 = phi_3084_;
                                                phi_3085_ = _e4629;
                                                phi_3086_ = _e4611;
                                                phi_3087_ = _e4631;
                                            } else {
                                                phi_3085_ = f64();
                                                phi_3086_ = true;
                                                phi_3087_ = false;
                                            }
                                            let _e4633 = phi_3085_;
                                            let _e4635 = phi_3086_;
                                            let _e4637 = phi_3087_;
                                            if _e4635 {
                                                phi_3092_ = f64(2f);
                                                phi_3093_ = true;
                                            } else {
                                                phi_3092_ = _e4002;
                                                phi_3093_ = _e4637;
                                            }
                                            let _e4640 = phi_3092_;
                                            let _e4642 = phi_3093_;
                                            if _e4642 {
                                                phi_3097_ = _e4640;
                                            } else {
                                                phi_3097_ = _e4633;
                                            }
                                            let _e4644 = phi_3097_;
                                            let _e4647 = local_9.member[1u];
                                            let _e4650 = local_9.member_1[1u];
                                            let _e4653 = local_9.member_2[1u];
                                            if (_e4647 > _e4653) {
                                                if (_e4650 > _e4653) {
                                                    phi_3129_ = false;
                                                } else {
                                                    phi_3129_ = true;
                                                }
                                                let _e4657 = phi_3129_;
                                                phi_3130_ = _e4657;
                                            } else {
                                                phi_3130_ = true;
                                            }
                                            let _e4659 = phi_3130_;
                                            if _e4659 {
                                                let _e4660 = (_e4650 >= _e4647);
                                                if _e4660 {
                                                    phi_3155_ = f64();
                                                    phi_3156_ = false;
                                                } else {
                                                    if ((_e4647 - _e4650) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3153_ = (((_e4647 - _e4653) / (_e4647 - _e4650)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3154_ = false;
                                                    } else {
                                                        phi_3153_ = f64();
                                                        phi_3154_ = true;
                                                    }
                                                    let _e4674 = phi_3153_;
                                                    let _e4676 = phi_3154_;
                                                    phi_3155_ = _e4674;
                                                    phi_3156_ = _e4676;
                                                }
                                                let _e4678 = phi_3155_;
                                                let _e4680 = phi_3156_;
                                                phi_3157_ = _e4678;
                                                phi_3158_ = _e4660;
                                                phi_3159_ = _e4680;
                                            } else {
                                                phi_3157_ = f64();
                                                phi_3158_ = true;
                                                phi_3159_ = false;
                                            }
                                            let _e4682 = phi_3157_;
                                            let _e4684 = phi_3158_;
                                            let _e4686 = phi_3159_;
                                            if _e4684 {
                                                phi_3164_ = f64(2f);
                                                phi_3165_ = true;
                                            } else {
                                                phi_3164_ = _e4002;
                                                phi_3165_ = _e4686;
                                            }
                                            let _e4689 = phi_3164_;
                                            let _e4691 = phi_3165_;
                                            if _e4691 {
                                                phi_3169_ = _e4689;
                                            } else {
                                                phi_3169_ = _e4682;
                                            }
                                            let _e4693 = phi_3169_;
                                            if (_e4644 < _e4693) {
                                                phi_3174_ = _e4644;
                                            } else {
                                                phi_3174_ = _e4693;
                                            }
                                            let _e4696 = phi_3174_;
                                            let _e4699 = local_9.member[2u];
                                            let _e4702 = local_9.member_1[2u];
                                            let _e4705 = local_9.member_2[2u];
                                            if (_e4699 > _e4705) {
                                                if (_e4702 > _e4705) {
                                                    phi_3206_ = false;
                                                } else {
                                                    phi_3206_ = true;
                                                }
                                                let _e4709 = phi_3206_;
                                                phi_3207_ = _e4709;
                                            } else {
                                                phi_3207_ = true;
                                            }
                                            let _e4711 = phi_3207_;
                                            if _e4711 {
                                                let _e4712 = (_e4702 >= _e4699);
                                                if _e4712 {
                                                    phi_3232_ = f64();
                                                    phi_3233_ = false;
                                                } else {
                                                    if ((_e4699 - _e4702) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3230_ = (((_e4699 - _e4705) / (_e4699 - _e4702)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3231_ = false;
                                                    } else {
                                                        phi_3230_ = f64();
                                                        phi_3231_ = true;
                                                    }
                                                    let _e4726 = phi_3230_;
                                                    let _e4728 = phi_3231_;
                                                    phi_3232_ = _e4726;
                                                    phi_3233_ = _e4728;
                                                }
                                                let _e4730 = phi_3232_;
                                                let _e4732 = phi_3233_;
                                                phi_3234_ = _e4730;
                                                phi_3235_ = _e4712;
                                                phi_3236_ = _e4732;
                                            } else {
                                                phi_3234_ = f64();
                                                phi_3235_ = true;
                                                phi_3236_ = false;
                                            }
                                            let _e4734 = phi_3234_;
                                            let _e4736 = phi_3235_;
                                            let _e4738 = phi_3236_;
                                            if _e4736 {
                                                phi_3241_ = f64(2f);
                                                phi_3242_ = true;
                                            } else {
                                                phi_3241_ = _e4002;
                                                phi_3242_ = _e4738;
                                            }
                                            let _e4741 = phi_3241_;
                                            let _e4743 = phi_3242_;
                                            if _e4743 {
                                                phi_3246_ = _e4741;
                                            } else {
                                                phi_3246_ = _e4734;
                                            }
                                            let _e4745 = phi_3246_;
                                            let _e4748 = local_9.member[3u];
                                            let _e4751 = local_9.member_1[3u];
                                            let _e4754 = local_9.member_2[3u];
                                            if (_e4748 > _e4754) {
                                                if (_e4751 > _e4754) {
                                                    phi_3278_ = false;
                                                } else {
                                                    phi_3278_ = true;
                                                }
                                                let _e4758 = phi_3278_;
                                                phi_3279_ = _e4758;
                                            } else {
                                                phi_3279_ = true;
                                            }
                                            let _e4760 = phi_3279_;
                                            if _e4760 {
                                                let _e4761 = (_e4751 >= _e4748);
                                                if _e4761 {
                                                    phi_3304_ = f64();
                                                    phi_3305_ = false;
                                                } else {
                                                    if ((_e4748 - _e4751) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                        phi_3302_ = (((_e4748 - _e4754) / (_e4748 - _e4751)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                        phi_3303_ = false;
                                                    } else {
                                                        phi_3302_ = f64();
                                                        phi_3303_ = true;
                                                    }
                                                    let _e4775 = phi_3302_;
                                                    let _e4777 = phi_3303_;
                                                    phi_3304_ = _e4775;
                                                    phi_3305_ = _e4777;
                                                }
                                                let _e4779 = phi_3304_;
                                                let _e4781 = phi_3305_;
                                                phi_3306_ = _e4779;
                                                phi_3307_ = _e4761;
                                                phi_3308_ = _e4781;
                                            } else {
                                                phi_3306_ = f64();
                                                phi_3307_ = true;
                                                phi_3308_ = false;
                                            }
                                            let _e4783 = phi_3306_;
                                            let _e4785 = phi_3307_;
                                            let _e4787 = phi_3308_;
                                            if _e4785 {
                                                phi_3313_ = f64(2f);
                                                phi_3314_ = true;
                                            } else {
                                                phi_3313_ = _e4002;
                                                phi_3314_ = _e4787;
                                            }
                                            let _e4790 = phi_3313_;
                                            let _e4792 = phi_3314_;
                                            if _e4792 {
                                                phi_3318_ = _e4790;
                                            } else {
                                                phi_3318_ = _e4783;
                                            }
                                            let _e4794 = phi_3318_;
                                            if (_e4745 < _e4794) {
                                                phi_3323_ = _e4745;
                                            } else {
                                                phi_3323_ = _e4794;
                                            }
                                            let _e4797 = phi_3323_;
                                            if (_e4696 < _e4797) {
                                                phi_3328_ = _e4696;
                                            } else {
                                                phi_3328_ = _e4797;
                                            }
                                            let _e4800 = phi_3328_;
                                            if (_e4800 > _e4002) {
                                                phi_3333_ = _e4800;
                                            } else {
                                                phi_3333_ = _e4002;
                                            }
                                            let _e4803 = phi_3333_;
                                            let _e4804 = (_e4803 > _e3762);
                                            if _e4804 {
                                                phi_3344_ = f64();
                                                phi_3345_ = false;
                                            } else {
                                                if _e4008 {
                                                    phi_3343_ = (_e4333 + _e4333);
                                                } else {
                                                    phi_3343_ = (_e3762 - _e4002);
                                                }
                                                let _e4808 = phi_3343_;
                                                phi_3344_ = _e4808;
                                                phi_3345_ = true;
                                            }
                                            let _e4810 = phi_3344_;
                                            let _e4812 = phi_3345_;
                                            phi_3346_ = _e4803;
                                            phi_3347_ = _e4810;
                                            phi_3348_ = _e4812;
                                            phi_3349_ = _e4804;
                                            phi_3350_ = false;
                                        } else {
                                            phi_3346_ = f64();
                                            phi_3347_ = f64();
                                            phi_3348_ = false;
                                            phi_3349_ = false;
                                            phi_3350_ = true;
                                        }
                                        let _e4814 = phi_3346_;
                                        let _e4816 = phi_3347_;
                                        let _e4818 = phi_3348_;
                                        let _e4820 = phi_3349_;
                                        let _e4822 = phi_3350_;
                                        phi_3351_ = _e4814;
                                        phi_3352_ = _e4816;
                                        phi_3353_ = false;
                                        phi_3354_ = _e4818;
                                        phi_3355_ = _e4820;
                                        phi_3356_ = _e4822;
                                    } else {
                                        phi_3351_ = f64();
                                        phi_3352_ = f64();
                                        phi_3353_ = true;
                                        phi_3354_ = false;
                                        phi_3355_ = false;
                                        phi_3356_ = false;
                                    }
                                    let _e4824 = phi_3351_;
                                    let _e4826 = phi_3352_;
                                    let _e4828 = phi_3353_;
                                    let _e4830 = phi_3354_;
                                    let _e4832 = phi_3355_;
                                    let _e4834 = phi_3356_;
                                    phi_3357_ = _e4824;
                                    phi_3358_ = _e4826;
                                    phi_3359_ = _e4828;
                                    phi_3360_ = _e4830;
                                    phi_3361_ = _e4832;
                                    phi_3362_ = _e4834;
                                } else {
                                    phi_3357_ = f64();
                                    phi_3358_ = f64();
                                    phi_3359_ = true;
                                    phi_3360_ = false;
                                    phi_3361_ = false;
                                    phi_3362_ = false;
                                }
                                let _e4836 = phi_3357_;
                                let _e4838 = phi_3358_;
                                let _e4840 = phi_3359_;
                                let _e4842 = phi_3360_;
                                let _e4844 = phi_3361_;
                                let _e4846 = phi_3362_;
                                if _e4840 {
                                    if (_e4002 <= _e4004) {
                                        let _e5012 = (_e4010 + 1u);
                                        let _e5013 = (_e5012 > 3u);
                                        if _e5013 {
                                            phi_3375_ = false;
                                        } else {
                                            phi_3375_ = true;
                                        }
                                        let _e5015 = phi_3375_;
                                        phi_3702_ = _e5012;
                                        phi_3703_ = f64();
                                        phi_3704_ = false;
                                        phi_3705_ = _e5015;
                                        phi_3706_ = _e5013;
                                    } else {
                                        let _e4850 = local_9.member[0u];
                                        let _e4853 = local_9.member_1[0u];
                                        let _e4856 = local_9.member[0u];
                                        let _e4862 = local_9.member_2[0u];
                                        let _e4863 = ((_e4850 + ((_e4853 - _e4856) * _e4006)) - _e4862);
                                        let _e4866 = local_9.member[1u];
                                        let _e4869 = local_9.member_1[1u];
                                        let _e4872 = local_9.member[1u];
                                        let _e4878 = local_9.member_2[1u];
                                        let _e4879 = ((_e4866 + ((_e4869 - _e4872) * _e4006)) - _e4878);
                                        if (_e4863 < _e4879) {
                                            phi_3448_ = _e4863;
                                        } else {
                                            phi_3448_ = _e4879;
                                        }
                                        let _e4882 = phi_3448_;
                                        let _e4885 = local_9.member[2u];
                                        let _e4888 = local_9.member_1[2u];
                                        let _e4891 = local_9.member[2u];
                                        let _e4897 = local_9.member_2[2u];
                                        let _e4898 = ((_e4885 + ((_e4888 - _e4891) * _e4006)) - _e4897);
                                        let _e4901 = local_9.member[3u];
                                        let _e4904 = local_9.member_1[3u];
                                        let _e4907 = local_9.member[3u];
                                        let _e4913 = local_9.member_2[3u];
                                        let _e4914 = ((_e4901 + ((_e4904 - _e4907) * _e4006)) - _e4913);
                                        if (_e4898 < _e4914) {
                                            phi_3521_ = _e4898;
                                        } else {
                                            phi_3521_ = _e4914;
                                        }
                                        let _e4917 = phi_3521_;
                                        if (_e4882 < _e4917) {
                                            phi_3526_ = _e4882;
                                        } else {
                                            phi_3526_ = _e4917;
                                        }
                                        let _e4920 = phi_3526_;
                                        let _e4923 = local_10.member[0u];
                                        let _e4926 = local_10.member_1[0u];
                                        let _e4929 = local_10.member[0u];
                                        let _e4935 = local_10.member_2[0u];
                                        let _e4936 = ((_e4923 + ((_e4926 - _e4929) * _e4002)) - _e4935);
                                        let _e4939 = local_10.member[1u];
                                        let _e4942 = local_10.member_1[1u];
                                        let _e4945 = local_10.member[1u];
                                        let _e4951 = local_10.member_2[1u];
                                        let _e4952 = ((_e4939 + ((_e4942 - _e4945) * _e4002)) - _e4951);
                                        if (_e4936 < _e4952) {
                                            phi_3599_ = _e4936;
                                        } else {
                                            phi_3599_ = _e4952;
                                        }
                                        let _e4955 = phi_3599_;
                                        let _e4958 = local_10.member[2u];
                                        let _e4961 = local_10.member_1[2u];
                                        let _e4964 = local_10.member[2u];
                                        let _e4970 = local_10.member_2[2u];
                                        let _e4971 = ((_e4958 + ((_e4961 - _e4964) * _e4002)) - _e4970);
                                        let _e4974 = local_10.member[3u];
                                        let _e4977 = local_10.member_1[3u];
                                        let _e4980 = local_10.member[3u];
                                        let _e4986 = local_10.member_2[3u];
                                        let _e4987 = ((_e4974 + ((_e4977 - _e4980) * _e4002)) - _e4986);
                                        if (_e4971 < _e4987) {
                                            phi_3672_ = _e4971;
                                        } else {
                                            phi_3672_ = _e4987;
                                        }
                                        let _e4990 = phi_3672_;
                                        if (_e4955 < _e4990) {
                                            phi_3677_ = _e4955;
                                        } else {
                                            phi_3677_ = _e4990;
                                        }
                                        let _e4993 = phi_3677_;
                                        let _e4994 = f64(0.0625f);
                                        let _e4996 = f64(0.9f);
                                        if (_e4993 > f64(0f)) {
                                            phi_3700_ = f64(0.5f);
                                        } else {
                                            let _e5002 = (f64(0.95f) * (_e4920 / (_e4920 - _e4993)));
                                            if (_e5002 > _e4994) {
                                                if (_e5002 < _e4996) {
                                                    phi_3698_ = _e5002;
                                                } else {
                                                    phi_3698_ = _e4996;
                                                }
                                                let _e5006 = phi_3698_;
                                                phi_3699_ = _e5006;
                                            } else {
                                                phi_3699_ = _e4994;
                                            }
                                            let _e5008 = phi_3699_;
                                            phi_3700_ = _e5008;
                                        }
                                        let _e5010 = phi_3700_;
                                        phi_3702_ = u32();
                                        phi_3703_ = (_e4333 * _e5010);
                                        phi_3704_ = true;
                                        phi_3705_ = false;
                                        phi_3706_ = false;
                                    }
                                    let _e5017 = phi_3702_;
                                    let _e5019 = phi_3703_;
                                    let _e5021 = phi_3704_;
                                    let _e5023 = phi_3705_;
                                    let _e5025 = phi_3706_;
                                    phi_3707_ = _e5017;
                                    phi_3708_ = _e4004;
                                    phi_3709_ = _e5019;
                                    phi_3710_ = _e4006;
                                    phi_3711_ = _e4008;
                                    phi_3712_ = _e4010;
                                    phi_3713_ = _e5021;
                                    phi_3714_ = _e5023;
                                    phi_3715_ = _e5025;
                                    phi_3716_ = false;
                                    phi_3717_ = false;
                                } else {
                                    phi_3707_ = u32();
                                    phi_3708_ = _e4836;
                                    phi_3709_ = _e4838;
                                    phi_3710_ = _e4002;
                                    phi_3711_ = true;
                                    phi_3712_ = 0u;
                                    phi_3713_ = _e4842;
                                    phi_3714_ = false;
                                    phi_3715_ = false;
                                    phi_3716_ = _e4844;
                                    phi_3717_ = _e4846;
                                }
                                let _e5027 = phi_3707_;
                                let _e5029 = phi_3708_;
                                let _e5031 = phi_3709_;
                                let _e5033 = phi_3710_;
                                let _e5035 = phi_3711_;
                                let _e5037 = phi_3712_;
                                let _e5039 = phi_3713_;
                                let _e5041 = phi_3714_;
                                let _e5043 = phi_3715_;
                                let _e5045 = phi_3716_;
                                let _e5047 = phi_3717_;
                                if _e5039 {
                                    let _e5048 = (_e5033 + _e5031);
                                    if (_e5048 > _e5029) {
                                        phi_3726_ = _e5048;
                                    } else {
                                        phi_3726_ = _e5029;
                                    }
                                    let _e5051 = phi_3726_;
                                    if (_e5051 < _e3762) {
                                        phi_3731_ = _e5051;
                                    } else {
                                        phi_3731_ = _e3762;
                                    }
                                    let _e5054 = phi_3731_;
                                    if !(_e4008) {
                                        phi_3741_ = true;
                                    } else {
                                        phi_3741_ = ((_e5054 - _e5033) > f64(0.0000000037252903f));
                                    }
                                    let _e5059 = phi_3741_;
                                    if _e5059 {
                                        phi_3745_ = false;
                                    } else {
                                        phi_3745_ = true;
                                    }
                                    let _e5061 = phi_3745_;
                                    phi_3746_ = _e5054;
                                    phi_3747_ = _e5029;
                                    phi_3748_ = _e5033;
                                    phi_3749_ = _e5035;
                                    phi_3750_ = _e5037;
                                    phi_3751_ = _e5059;
                                    phi_3752_ = _e5061;
                                    phi_3753_ = false;
                                    phi_3754_ = false;
                                    phi_3755_ = false;
                                } else {
                                    phi_3746_ = _e4002;
                                    phi_3747_ = _e4004;
                                    phi_3748_ = _e4006;
                                    phi_3749_ = _e4008;
                                    phi_3750_ = _e5027;
                                    phi_3751_ = _e5041;
                                    phi_3752_ = false;
                                    phi_3753_ = _e5043;
                                    phi_3754_ = _e5045;
                                    phi_3755_ = _e5047;
                                }
                                let _e5063 = phi_3746_;
                                let _e5065 = phi_3747_;
                                let _e5067 = phi_3748_;
                                let _e5069 = phi_3749_;
                                let _e5071 = phi_3750_;
                                let _e5073 = phi_3751_;
                                let _e5075 = phi_3752_;
                                let _e5077 = phi_3753_;
                                let _e5079 = phi_3754_;
                                let _e5081 = phi_3755_;
                                phi_2056_ = _e5063;
                                phi_2058_ = _e5065;
                                phi_2060_ = _e5067;
                                phi_2062_ = _e5069;
                                phi_2064_ = _e5071;
                                phi_3756_ = _e5029;
                                phi_3757_ = _e5073;
                                phi_3758_ = _e5075;
                                phi_3759_ = false;
                                phi_3760_ = _e5077;
                                phi_3761_ = _e5079;
                                phi_3762_ = _e5081;
                            } else {
                                phi_2056_ = f64();
                                phi_2058_ = f64();
                                phi_2060_ = f64();
                                phi_2062_ = bool();
                                phi_2064_ = u32();
                                phi_3756_ = f64();
                                phi_3757_ = false;
                                phi_3758_ = false;
                                phi_3759_ = true;
                                phi_3760_ = false;
                                phi_3761_ = false;
                                phi_3762_ = false;
                            }
                            let _e5083 = phi_2056_;
                            let _e5085 = phi_2058_;
                            let _e5087 = phi_2060_;
                            let _e5089 = phi_2062_;
                            let _e5091 = phi_2064_;
                            let _e5093 = phi_3756_;
                            let _e5095 = phi_3757_;
                            let _e5097 = phi_3758_;
                            let _e5099 = phi_3759_;
                            let _e5101 = phi_3760_;
                            let _e5103 = phi_3761_;
                            let _e5105 = phi_3762_;
                            local_25 = _e5097;
                            local_43 = _e5093;
                            local_45 = _e5099;
                            local_46 = _e5101;
                            local_47 = _e5103;
                            local_48 = _e5105;
                            continue;
                            continuing {
                                phi_2052_ = _e4022;
                                phi_2055_ = _e5083;
                                phi_2057_ = _e5085;
                                phi_2059_ = _e5087;
                                phi_2061_ = _e5089;
                                phi_2063_ = _e5091;
                                break if !(_e5095);
                            }
                        }
                        let _e5108 = local_25;
                        if _e5108 {
                            let _e6433 = local_43;
                            phi_3766_ = _e6433;
                            phi_3767_ = true;
                            phi_3768_ = false;
                            phi_3769_ = false;
                            phi_3770_ = false;
                        } else {
                            let _e6435 = local_44;
                            phi_3766_ = _e6435;
                            let _e6438 = local_45;
                            phi_3767_ = _e6438;
                            let _e6441 = local_46;
                            phi_3768_ = _e6441;
                            let _e6444 = local_47;
                            phi_3769_ = _e6444;
                            let _e6447 = local_48;
                            phi_3770_ = _e6447;
                        }
                        let _e5110 = phi_3766_;
                        let _e5112 = phi_3767_;
                        let _e5114 = phi_3768_;
                        let _e5116 = phi_3769_;
                        let _e5118 = phi_3770_;
                        if _e5112 {
                            phi_3775_ = type_44(1u, _e5110);
                            phi_3776_ = false;
                            phi_3777_ = false;
                            phi_3778_ = false;
                        } else {
                            phi_3775_ = type_44();
                            phi_3776_ = _e5114;
                            phi_3777_ = _e5116;
                            phi_3778_ = _e5118;
                        }
                        let _e5121 = phi_3775_;
                        let _e5123 = phi_3776_;
                        let _e5125 = phi_3777_;
                        let _e5127 = phi_3778_;
                        if _e5123 {
                            let _e5129 = local_26;
                            phi_3783_ = type_44(1u, _e5129);
                            phi_3784_ = false;
                            phi_3785_ = false;
                        } else {
                            phi_3783_ = type_44();
                            phi_3784_ = _e5125;
                            phi_3785_ = _e5127;
                        }
                        let _e5132 = phi_3783_;
                        let _e5134 = phi_3784_;
                        let _e5136 = phi_3785_;
                        if _e5134 {
                            phi_3790_ = type_44(0u, type_44().member_1);
                            phi_3791_ = false;
                            phi_3792_ = true;
                        } else {
                            phi_3790_ = _e5132;
                            phi_3791_ = _e5136;
                            phi_3792_ = _e5123;
                        }
                        let _e5140 = phi_3790_;
                        let _e5142 = phi_3791_;
                        let _e5144 = phi_3792_;
                        if _e5142 {
                            phi_3797_ = type_44(0u, type_44().member_1);
                            phi_3798_ = true;
                        } else {
                            phi_3797_ = _e5140;
                            phi_3798_ = _e5144;
                        }
                        let _e5148 = phi_3797_;
                        let _e5150 = phi_3798_;
                        if _e5150 {
                            phi_3802_ = _e5148;
                        } else {
                            phi_3802_ = _e5121;
                        }
                        let _e5152 = phi_3802_;
                        if (_e5152.member != 0u) {
                            local_11[0u] = 0f;
                            local_11[1u] = (0.02f * 0.0000005f);
                            local_11[2u] = (1.8f * 0.0000005f);
                            phi_3816_ = type_9(0u, 3u);
                            loop {
                                let _e5164 = phi_3816_;
                                if (_e5164.member < _e5164.member_1) {
                                    phi_3817_ = type_9((_e5164.member + 1u), _e5164.member_1);
                                    phi_3840_ = type_9(1u, _e5164.member);
                                } else {
                                    phi_3817_ = _e5164;
                                    phi_3840_ = type_9(0u, type_9().member_1);
                                }
                                let _e5176 = phi_3817_;
                                let _e5178 = phi_3840_;
                                if (bitcast<i32>(_e5178.member) != 0i) {
                                    let _e5184 = local_11[_e5178.member_1];
                                    let _e5186 = (_e5152.member_1 + f64(_e5184));
                                    if (_e5186 < _e3762) {
                                        phi_3861_ = _e5186;
                                    } else {
                                        phi_3861_ = _e3762;
                                    }
                                    let _e5189 = phi_3861_;
                                    let _e5192 = local_12.member[0u];
                                    let _e5198 = local_12.member[1u];
                                    let _e5214 = local_12.member_1[0u];
                                    let _e5220 = local_12.member_1[1u];
                                    let _e5236 = local_12.member_2[0u];
                                    let _e5242 = local_12.member_2[1u];
                                    let _e5256 = function_2(array<f64, 3>((_e5192[0] + ((_e5198[0] - _e5192[0]) * _e5189)), (_e5192[1] + ((_e5198[1] - _e5192[1]) * _e5189)), (_e5192[2] + ((_e5198[2] - _e5192[2]) * _e5189))), array<f64, 3>((_e5214[0] + ((_e5220[0] - _e5214[0]) * _e5189)), (_e5214[1] + ((_e5220[1] - _e5214[1]) * _e5189)), (_e5214[2] + ((_e5220[2] - _e5214[2]) * _e5189))), array<f64, 3>((_e5236[0] + ((_e5242[0] - _e5236[0]) * _e5189)), (_e5236[1] + ((_e5242[1] - _e5236[1]) * _e5189)), (_e5236[2] + ((_e5242[2] - _e5236[2]) * _e5189))), 1u);
                                    let _e5267 = (((_e5256[0] * _e5256[0]) + (_e5256[1] * _e5256[1])) + (_e5256[2] * _e5256[2]));
                                    if (_e5267 <= 2.2250738585072014e-308lf) {
                                        if (_e5267 > 0.0lf) {
                                            phi_3984_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_3984_ = 0.0lf;
                                        }
                                        let _e5319 = phi_3984_;
                                        phi_4048_ = _e5319;
                                    } else {
                                        phi_3991_ = type_16(0i, 5i);
                                        phi_3994_ = bitcast<f64>(((bitcast<u64>(_e5267) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e5274 = phi_3991_;
                                            let _e5276 = phi_3994_;
                                            local_27 = _e5276;
                                            if (_e5274.member < _e5274.member_1) {
                                                let _e5283 = (_e5274.member + 1i);
                                                if ((false == (_e5283 > _e5274.member)) != false) {
                                                    phi_4015_ = true;
                                                } else {
                                                    phi_4015_ = false;
                                                }
                                                let _e5288 = phi_4015_;
                                                if _e5288 {
                                                    phi_4021_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_4021_ = type_17(1u, _e5283);
                                                }
                                                let _e5293 = phi_4021_;
                                                phi_3992_ = type_16(_e5293.member_1, _e5274.member_1);
                                                phi_4035_ = type_17(1u, _e5274.member);
                                            } else {
                                                phi_3992_ = _e5274;
                                                phi_4035_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e5299 = phi_3992_;
                                            let _e5301 = phi_4035_;
                                            let _e5304 = (bitcast<i32>(_e5301.member) != 0i);
                                            if _e5304 {
                                                phi_3995_ = (0.5lf * (_e5276 + (_e5267 / _e5276)));
                                            } else {
                                                phi_3995_ = f64();
                                            }
                                            let _e5309 = phi_3995_;
                                            continue;
                                            continuing {
                                                phi_3991_ = _e5299;
                                                phi_3994_ = _e5309;
                                                break if !(_e5304);
                                            }
                                        }
                                        let _e5314 = local_27;
                                        phi_4048_ = (_e5314 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e5321 = phi_4048_;
                                    let _e5329 = local_12.member[0u];
                                    if (_e5329[0] < 0.0lf) {
                                        phi_4066_ = -(_e5329[0]);
                                    } else {
                                        phi_4066_ = _e5329[0];
                                    }
                                    let _e5336 = phi_4066_;
                                    if (_e5329[1] < 0.0lf) {
                                        phi_4073_ = -(_e5329[1]);
                                    } else {
                                        phi_4073_ = _e5329[1];
                                    }
                                    let _e5340 = phi_4073_;
                                    if (_e5336 > _e5340) {
                                        phi_4078_ = _e5336;
                                    } else {
                                        phi_4078_ = _e5340;
                                    }
                                    let _e5343 = phi_4078_;
                                    if (_e5329[2] < 0.0lf) {
                                        phi_4085_ = -(_e5329[2]);
                                    } else {
                                        phi_4085_ = _e5329[2];
                                    }
                                    let _e5347 = phi_4085_;
                                    if (_e5343 > _e5347) {
                                        phi_4090_ = _e5343;
                                    } else {
                                        phi_4090_ = _e5347;
                                    }
                                    let _e5350 = phi_4090_;
                                    let _e5353 = local_12.member[1u];
                                    if (_e5353[0] < 0.0lf) {
                                        phi_4103_ = -(_e5353[0]);
                                    } else {
                                        phi_4103_ = _e5353[0];
                                    }
                                    let _e5360 = phi_4103_;
                                    if (_e5353[1] < 0.0lf) {
                                        phi_4110_ = -(_e5353[1]);
                                    } else {
                                        phi_4110_ = _e5353[1];
                                    }
                                    let _e5364 = phi_4110_;
                                    if (_e5360 > _e5364) {
                                        phi_4115_ = _e5360;
                                    } else {
                                        phi_4115_ = _e5364;
                                    }
                                    let _e5367 = phi_4115_;
                                    if (_e5353[2] < 0.0lf) {
                                        phi_4122_ = -(_e5353[2]);
                                    } else {
                                        phi_4122_ = _e5353[2];
                                    }
                                    let _e5371 = phi_4122_;
                                    if (_e5367 > _e5371) {
                                        phi_4127_ = _e5367;
                                    } else {
                                        phi_4127_ = _e5371;
                                    }
                                    let _e5374 = phi_4127_;
                                    if (_e5350 > _e5374) {
                                        phi_4132_ = _e5350;
                                    } else {
                                        phi_4132_ = _e5374;
                                    }
                                    let _e5377 = phi_4132_;
                                    let _e5379 = local_12.member_3;
                                    let _e5383 = local_12.member_1[0u];
                                    if (_e5383[0] < 0.0lf) {
                                        phi_4149_ = -(_e5383[0]);
                                    } else {
                                        phi_4149_ = _e5383[0];
                                    }
                                    let _e5390 = phi_4149_;
                                    if (_e5383[1] < 0.0lf) {
                                        phi_4156_ = -(_e5383[1]);
                                    } else {
                                        phi_4156_ = _e5383[1];
                                    }
                                    let _e5394 = phi_4156_;
                                    if (_e5390 > _e5394) {
                                        phi_4161_ = _e5390;
                                    } else {
                                        phi_4161_ = _e5394;
                                    }
                                    let _e5397 = phi_4161_;
                                    if (_e5383[2] < 0.0lf) {
                                        phi_4168_ = -(_e5383[2]);
                                    } else {
                                        phi_4168_ = _e5383[2];
                                    }
                                    let _e5401 = phi_4168_;
                                    if (_e5397 > _e5401) {
                                        phi_4173_ = _e5397;
                                    } else {
                                        phi_4173_ = _e5401;
                                    }
                                    let _e5404 = phi_4173_;
                                    let _e5407 = local_12.member_1[1u];
                                    if (_e5407[0] < 0.0lf) {
                                        phi_4187_ = -(_e5407[0]);
                                    } else {
                                        phi_4187_ = _e5407[0];
                                    }
                                    let _e5414 = phi_4187_;
                                    if (_e5407[1] < 0.0lf) {
                                        phi_4194_ = -(_e5407[1]);
                                    } else {
                                        phi_4194_ = _e5407[1];
                                    }
                                    let _e5418 = phi_4194_;
                                    if (_e5414 > _e5418) {
                                        phi_4199_ = _e5414;
                                    } else {
                                        phi_4199_ = _e5418;
                                    }
                                    let _e5421 = phi_4199_;
                                    if (_e5407[2] < 0.0lf) {
                                        phi_4206_ = -(_e5407[2]);
                                    } else {
                                        phi_4206_ = _e5407[2];
                                    }
                                    let _e5425 = phi_4206_;
                                    if (_e5421 > _e5425) {
                                        phi_4211_ = _e5421;
                                    } else {
                                        phi_4211_ = _e5425;
                                    }
                                    let _e5428 = phi_4211_;
                                    if (_e5404 > _e5428) {
                                        phi_4216_ = _e5404;
                                    } else {
                                        phi_4216_ = _e5428;
                                    }
                                    let _e5431 = phi_4216_;
                                    let _e5433 = local_12.member_3;
                                    let _e5437 = local_12.member_2[0u];
                                    if (_e5437[0] < 0.0lf) {
                                        phi_4233_ = -(_e5437[0]);
                                    } else {
                                        phi_4233_ = _e5437[0];
                                    }
                                    let _e5444 = phi_4233_;
                                    if (_e5437[1] < 0.0lf) {
                                        phi_4240_ = -(_e5437[1]);
                                    } else {
                                        phi_4240_ = _e5437[1];
                                    }
                                    let _e5448 = phi_4240_;
                                    if (_e5444 > _e5448) {
                                        phi_4245_ = _e5444;
                                    } else {
                                        phi_4245_ = _e5448;
                                    }
                                    let _e5451 = phi_4245_;
                                    if (_e5437[2] < 0.0lf) {
                                        phi_4252_ = -(_e5437[2]);
                                    } else {
                                        phi_4252_ = _e5437[2];
                                    }
                                    let _e5455 = phi_4252_;
                                    if (_e5451 > _e5455) {
                                        phi_4257_ = _e5451;
                                    } else {
                                        phi_4257_ = _e5455;
                                    }
                                    let _e5458 = phi_4257_;
                                    let _e5461 = local_12.member_2[1u];
                                    if (_e5461[0] < 0.0lf) {
                                        phi_4271_ = -(_e5461[0]);
                                    } else {
                                        phi_4271_ = _e5461[0];
                                    }
                                    let _e5468 = phi_4271_;
                                    if (_e5461[1] < 0.0lf) {
                                        phi_4278_ = -(_e5461[1]);
                                    } else {
                                        phi_4278_ = _e5461[1];
                                    }
                                    let _e5472 = phi_4278_;
                                    if (_e5468 > _e5472) {
                                        phi_4283_ = _e5468;
                                    } else {
                                        phi_4283_ = _e5472;
                                    }
                                    let _e5475 = phi_4283_;
                                    if (_e5461[2] < 0.0lf) {
                                        phi_4290_ = -(_e5461[2]);
                                    } else {
                                        phi_4290_ = _e5461[2];
                                    }
                                    let _e5479 = phi_4290_;
                                    if (_e5475 > _e5479) {
                                        phi_4295_ = _e5475;
                                    } else {
                                        phi_4295_ = _e5479;
                                    }
                                    let _e5482 = phi_4295_;
                                    if (_e5458 > _e5482) {
                                        phi_4300_ = _e5458;
                                    } else {
                                        phi_4300_ = _e5482;
                                    }
                                    let _e5485 = phi_4300_;
                                    let _e5487 = local_12.member_3;
                                    let _e5495 = local_12.member_3;
                                    let _e5505 = (((_e5321 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5377 + _e5379) + (_e5431 + _e5433)) + (_e5485 + _e5487)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5495 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e578.member_1);
                                    if _e5505 {
                                        phi_4324_ = false;
                                    } else {
                                        phi_4324_ = true;
                                    }
                                    let _e5507 = phi_4324_;
                                    phi_4325_ = _e5507;
                                    phi_4326_ = _e5505;
                                } else {
                                    phi_4325_ = false;
                                    phi_4326_ = false;
                                }
                                let _e5509 = phi_4325_;
                                let _e5511 = phi_4326_;
                                local_28 = _e5511;
                                continue;
                                continuing {
                                    phi_3816_ = _e5176;
                                    break if !(_e5509);
                                }
                            }
                            let _e5514 = local_28;
                            if _e5514 {
                                phi_4331_ = type_44(1u, _e5152.member_1);
                                phi_4332_ = false;
                            } else {
                                phi_4331_ = type_44();
                                phi_4332_ = true;
                            }
                            let _e5517 = phi_4331_;
                            let _e5519 = phi_4332_;
                            if _e5519 {
                                phi_4337_ = type_44(2u, _e5152.member_1);
                                phi_4338_ = false;
                            } else {
                                phi_4337_ = type_44();
                                phi_4338_ = true;
                            }
                            let _e5522 = phi_4337_;
                            let _e5524 = phi_4338_;
                            phi_4340_ = _e5522;
                            phi_4341_ = _e5517;
                            phi_4342_ = _e5524;
                        } else {
                            phi_4340_ = type_44();
                            phi_4341_ = type_44(0u, type_44().member_1);
                            phi_4342_ = true;
                        }
                        let _e5526 = phi_4340_;
                        let _e5528 = phi_4341_;
                        let _e5530 = phi_4342_;
                        if _e5530 {
                            phi_4346_ = _e5528;
                        } else {
                            phi_4346_ = _e5526;
                        }
                        let _e5532 = phi_4346_;
                        phi_8371_ = _e5532;
                    } else {
                        if (_e716 < 0.0lf) {
                            phi_4357_ = -(_e716);
                        } else {
                            phi_4357_ = _e716;
                        }
                        let _e1073 = phi_4357_;
                        if (_e739 < 0.0lf) {
                            phi_4363_ = -(_e739);
                        } else {
                            phi_4363_ = _e739;
                        }
                        let _e1077 = phi_4363_;
                        if (_e1073 > _e1077) {
                            phi_4368_ = _e1073;
                        } else {
                            phi_4368_ = _e1077;
                        }
                        let _e1080 = phi_4368_;
                        if (_e762 < 0.0lf) {
                            phi_4374_ = -(_e762);
                        } else {
                            phi_4374_ = _e762;
                        }
                        let _e1084 = phi_4374_;
                        if (_e773 < 0.0lf) {
                            phi_4380_ = -(_e773);
                        } else {
                            phi_4380_ = _e773;
                        }
                        let _e1088 = phi_4380_;
                        if (_e1084 > _e1088) {
                            phi_4385_ = _e1084;
                        } else {
                            phi_4385_ = _e1088;
                        }
                        let _e1091 = phi_4385_;
                        if (_e1080 > _e1091) {
                            phi_4390_ = _e1080;
                        } else {
                            phi_4390_ = _e1091;
                        }
                        let _e1094 = phi_4390_;
                        let _e1096 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1097 = f64(1f);
                        if (_e1094 >= _e1096) {
                            phi_4400_ = (_e1094 <= (_e1097 / _e1096));
                        } else {
                            phi_4400_ = false;
                        }
                        let _e1102 = phi_4400_;
                        if _e1102 {
                            phi_4407_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_4407_ = f64(2f);
                        }
                        let _e1107 = phi_4407_;
                        let _e1109 = ((_e1032 * f64(0.34f)) + (_e1094 * _e1107));
                        if _e1102 {
                            phi_4415_ = (_e1097 / _e1094);
                        } else {
                            phi_4415_ = f64(0f);
                        }
                        let _e1113 = phi_4415_;
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
                                    phi_4451_ = (1.464336215552873e-154lf * 2.0lf);
                                } else {
                                    phi_4451_ = 0.0lf;
                                }
                                let _e1184 = phi_4451_;
                                phi_4515_ = _e1184;
                            } else {
                                phi_4458_ = type_16(0i, 5i);
                                phi_4461_ = bitcast<f64>(((bitcast<u64>(_e1131) / 2lu) + 2303426169912950784lu));
                                loop {
                                    let _e1139 = phi_4458_;
                                    let _e1141 = phi_4461_;
                                    local_13 = _e1141;
                                    if (_e1139.member < _e1139.member_1) {
                                        let _e1148 = (_e1139.member + 1i);
                                        if ((false == (_e1148 > _e1139.member)) != false) {
                                            phi_4482_ = true;
                                        } else {
                                            phi_4482_ = false;
                                        }
                                        let _e1153 = phi_4482_;
                                        if _e1153 {
                                            phi_4488_ = type_17(0u, type_17().member_1);
                                        } else {
                                            phi_4488_ = type_17(1u, _e1148);
                                        }
                                        let _e1158 = phi_4488_;
                                        phi_4459_ = type_16(_e1158.member_1, _e1139.member_1);
                                        phi_4502_ = type_17(1u, _e1139.member);
                                    } else {
                                        phi_4459_ = _e1139;
                                        phi_4502_ = type_17(0u, type_17().member_1);
                                    }
                                    let _e1164 = phi_4459_;
                                    let _e1166 = phi_4502_;
                                    let _e1169 = (bitcast<i32>(_e1166.member) != 0i);
                                    if _e1169 {
                                        phi_4462_ = (0.5lf * (_e1141 + (_e1131 / _e1141)));
                                    } else {
                                        phi_4462_ = f64();
                                    }
                                    let _e1174 = phi_4462_;
                                    continue;
                                    continuing {
                                        phi_4458_ = _e1164;
                                        phi_4461_ = _e1174;
                                        break if !(_e1169);
                                    }
                                }
                                let _e1179 = local_13;
                                phi_4515_ = (_e1179 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                            }
                            let _e1186 = phi_4515_;
                            if (_e1123 < _e1114) {
                                phi_4521_ = -(_e1186);
                            } else {
                                phi_4521_ = _e1186;
                            }
                            let _e1190 = phi_4521_;
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
                            phi_4546_ = type_9(0u, 2u);
                            phi_4549_ = 1u;
                            loop {
                                let _e1211 = phi_4546_;
                                let _e1213 = phi_4549_;
                                local_29 = _e1213;
                                if (_e1211.member < _e1211.member_1) {
                                    phi_4547_ = type_9((_e1211.member + 1u), _e1211.member_1);
                                    phi_4572_ = type_9(1u, _e1211.member);
                                } else {
                                    phi_4547_ = _e1211;
                                    phi_4572_ = type_9(0u, type_9().member_1);
                                }
                                let _e1225 = phi_4547_;
                                let _e1227 = phi_4572_;
                                let _e1231 = (bitcast<i32>(_e1227.member) != 0i);
                                if _e1231 {
                                    let _e1233 = local_7[_e1227.member_1];
                                    if (_e1233 > _e1114) {
                                        let _e1236 = local_7[_e1227.member_1];
                                        if (_e1236 < _e1115) {
                                            let _e1239 = local_7[_e1227.member_1];
                                            local_6[_e1213] = _e1239;
                                            phi_4616_ = (_e1213 + 1u);
                                        } else {
                                            phi_4616_ = _e1213;
                                        }
                                        let _e1243 = phi_4616_;
                                        phi_4617_ = _e1243;
                                    } else {
                                        phi_4617_ = _e1213;
                                    }
                                    let _e1245 = phi_4617_;
                                    phi_4550_ = _e1245;
                                } else {
                                    phi_4550_ = u32();
                                }
                                let _e1247 = phi_4550_;
                                continue;
                                continuing {
                                    phi_4546_ = _e1225;
                                    phi_4549_ = _e1247;
                                    break if !(_e1231);
                                }
                            }
                            let _e5758 = local_29;
                            phi_4618_ = _e5758;
                        } else {
                            phi_4618_ = 1u;
                        }
                        let _e1250 = phi_4618_;
                        local_6[_e1250] = _e1115;
                        let _e1252 = local_6;
                        local_8 = _e1252;
                        phi_4638_ = type_9(0u, _e1250);
                        loop {
                            let _e1255 = phi_4638_;
                            if (_e1255.member < _e1255.member_1) {
                                phi_4639_ = type_9((_e1255.member + 1u), _e1255.member_1);
                                phi_4662_ = type_9(1u, _e1255.member);
                            } else {
                                phi_4639_ = _e1255;
                                phi_4662_ = type_9(0u, type_9().member_1);
                            }
                            let _e1267 = phi_4639_;
                            let _e1269 = phi_4662_;
                            if (bitcast<i32>(_e1269.member) != 0i) {
                                let _e1275 = local_8[_e1269.member_1];
                                let _e1278 = local_8[(_e1269.member_1 + 1u)];
                                let _e1280 = (f64(1f) - _e1275);
                                let _e1291 = ((((_e716 * _e1280) + (_e739 * _e1275)) * (_e1280 * _e1280)) + (((_e762 * _e1280) + (_e773 * _e1275)) * (_e1275 * _e1275)));
                                let _e1293 = (f64(1f) - _e1278);
                                let _e1304 = ((((_e716 * _e1293) + (_e739 * _e1278)) * (_e1293 * _e1293)) + (((_e762 * _e1293) + (_e773 * _e1278)) * (_e1278 * _e1278)));
                                if (_e1291 < 0.0lf) {
                                    phi_4716_ = -(_e1291);
                                } else {
                                    phi_4716_ = _e1291;
                                }
                                let _e1308 = phi_4716_;
                                let _e1309 = (_e1308 > _e1109);
                                if (_e1304 < 0.0lf) {
                                    phi_4723_ = -(_e1304);
                                } else {
                                    phi_4723_ = _e1304;
                                }
                                let _e1313 = phi_4723_;
                                let _e1314 = (_e1313 > _e1109);
                                let _e1315 = f64(0f);
                                if _e1309 {
                                    if _e1314 {
                                        phi_4735_ = ((_e1291 > _e1315) != (_e1304 > _e1315));
                                        phi_4736_ = false;
                                    } else {
                                        phi_4735_ = bool();
                                        phi_4736_ = true;
                                    }
                                    let _e1320 = phi_4735_;
                                    let _e1322 = phi_4736_;
                                    phi_4737_ = _e1320;
                                    phi_4738_ = _e1322;
                                } else {
                                    phi_4737_ = bool();
                                    phi_4738_ = true;
                                }
                                let _e1324 = phi_4737_;
                                let _e1326 = phi_4738_;
                                if _e1326 {
                                    phi_4742_ = false;
                                } else {
                                    phi_4742_ = _e1324;
                                }
                                let _e1328 = phi_4742_;
                                if _e1309 {
                                    if _e1314 {
                                        if _e1328 {
                                            phi_4754_ = type_45();
                                        } else {
                                            phi_4754_ = type_45(f64(1f), _e1315, _e1328);
                                        }
                                        let _e1332 = phi_4754_;
                                        phi_4755_ = _e1332;
                                        phi_4756_ = _e1328;
                                    } else {
                                        phi_4755_ = type_45();
                                        phi_4756_ = true;
                                    }
                                    let _e1334 = phi_4755_;
                                    let _e1336 = phi_4756_;
                                    phi_4757_ = _e1334;
                                    phi_4758_ = _e1336;
                                } else {
                                    phi_4757_ = type_45();
                                    phi_4758_ = true;
                                }
                                let _e1338 = phi_4757_;
                                let _e1340 = phi_4758_;
                                if _e1340 {
                                    if _e1309 {
                                        if (_e1291 < _e1315) {
                                            phi_4771_ = f64(-1f);
                                        } else {
                                            phi_4771_ = f64(1f);
                                        }
                                        let _e1345 = phi_4771_;
                                        let _e1346 = f64(0.00000000000022737368f);
                                        let _e1347 = f64(0.5f);
                                        let _e1348 = f64(3f);
                                        let _e1351 = (_e762 - _e739);
                                        phi_4784_ = type_9(0u, 64u);
                                        phi_4787_ = _e1278;
                                        phi_4789_ = _e1275;
                                        phi_4791_ = (_e1347 * (_e1275 + _e1278));
                                        loop {
                                            let _e1357 = phi_4784_;
                                            let _e1359 = phi_4787_;
                                            let _e1361 = phi_4789_;
                                            let _e1363 = phi_4791_;
                                            local_31 = _e1361;
                                            if (_e1357.member < _e1357.member_1) {
                                                phi_4785_ = type_9((_e1357.member + 1u), _e1357.member_1);
                                                phi_4814_ = type_9(1u, _e1357.member);
                                            } else {
                                                phi_4785_ = _e1357;
                                                phi_4814_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1375 = phi_4785_;
                                            let _e1377 = phi_4814_;
                                            if (bitcast<i32>(_e1377.member) != 0i) {
                                                let _e1382 = (f64(1f) - _e1363);
                                                let _e1395 = ((_e1345 * ((((_e716 * _e1382) + (_e739 * _e1363)) * (_e1382 * _e1382)) + (((_e762 * _e1382) + (_e773 * _e1363)) * (_e1363 * _e1363)))) - _e1109);
                                                if (_e1395 > f64(0f)) {
                                                    phi_4841_ = _e1359;
                                                    phi_4842_ = _e1363;
                                                } else {
                                                    phi_4841_ = _e1363;
                                                    phi_4842_ = _e1361;
                                                }
                                                let _e1399 = phi_4841_;
                                                let _e1401 = phi_4842_;
                                                let _e1403 = ((_e1399 - _e1401) > _e1346);
                                                if _e1403 {
                                                    let _e1405 = (f64(1f) - _e1363);
                                                    let _e1417 = (-(_e1395) / (_e1345 * (((((_e739 - (_e1348 * _e716)) * _e1405) + (_e1351 * _e1363)) * _e1405) + (((_e1351 * _e1405) + (((_e1348 * _e773) - _e762) * _e1363)) * _e1363))));
                                                    if (_e1395 > f64(0f)) {
                                                        phi_4870_ = (_e1347 * _e1346);
                                                    } else {
                                                        phi_4870_ = -((_e1347 * _e1346));
                                                    }
                                                    let _e1424 = phi_4870_;
                                                    let _e1426 = ((_e1363 + _e1417) + _e1424);
                                                    if (_e1426 > _e1401) {
                                                        if (_e1426 < _e1399) {
                                                            if (_e1417 < 0.0lf) {
                                                                phi_4886_ = -(_e1417);
                                                            } else {
                                                                phi_4886_ = _e1417;
                                                            }
                                                            let _e1432 = phi_4886_;
                                                            if (_e1432 < (_e1347 * (_e1399 - _e1401))) {
                                                                phi_4893_ = false;
                                                            } else {
                                                                phi_4893_ = true;
                                                            }
                                                            let _e1437 = phi_4893_;
                                                            phi_4894_ = _e1437;
                                                        } else {
                                                            phi_4894_ = true;
                                                        }
                                                        let _e1439 = phi_4894_;
                                                        phi_4895_ = _e1439;
                                                    } else {
                                                        phi_4895_ = true;
                                                    }
                                                    let _e1441 = phi_4895_;
                                                    if _e1441 {
                                                        phi_4901_ = (_e1347 * (_e1401 + _e1399));
                                                    } else {
                                                        phi_4901_ = _e1426;
                                                    }
                                                    let _e1445 = phi_4901_;
                                                    phi_4902_ = _e1445;
                                                    phi_4903_ = false;
                                                } else {
                                                    phi_4902_ = f64();
                                                    phi_4903_ = true;
                                                }
                                                let _e1447 = phi_4902_;
                                                let _e1449 = phi_4903_;
                                                phi_4788_ = _e1399;
                                                phi_4790_ = _e1401;
                                                phi_4792_ = _e1447;
                                                phi_4904_ = _e1401;
                                                phi_4905_ = _e1403;
                                                phi_4906_ = _e1449;
                                            } else {
                                                phi_4788_ = f64();
                                                phi_4790_ = f64();
                                                phi_4792_ = f64();
                                                phi_4904_ = f64();
                                                phi_4905_ = false;
                                                phi_4906_ = false;
                                            }
                                            let _e1451 = phi_4788_;
                                            let _e1453 = phi_4790_;
                                            let _e1455 = phi_4792_;
                                            let _e1457 = phi_4904_;
                                            let _e1459 = phi_4905_;
                                            let _e1461 = phi_4906_;
                                            local_14 = _e1461;
                                            local_30 = _e1457;
                                            continue;
                                            continuing {
                                                phi_4784_ = _e1375;
                                                phi_4787_ = _e1451;
                                                phi_4789_ = _e1453;
                                                phi_4791_ = _e1455;
                                                break if !(_e1459);
                                            }
                                        }
                                        let _e1464 = local_14;
                                        if _e1464 {
                                            let _e5800 = local_30;
                                            phi_4910_ = _e5800;
                                        } else {
                                            let _e5802 = local_31;
                                            phi_4910_ = _e5802;
                                        }
                                        let _e1466 = phi_4910_;
                                        phi_4911_ = _e1466;
                                    } else {
                                        phi_4911_ = _e1275;
                                    }
                                    let _e1468 = phi_4911_;
                                    if _e1314 {
                                        if (_e1304 < _e1315) {
                                            phi_4921_ = f64(-1f);
                                        } else {
                                            phi_4921_ = f64(1f);
                                        }
                                        let _e1473 = phi_4921_;
                                        phi_4926_ = type_9(0u, 64u);
                                        phi_4929_ = f64((2f * 0.00000000000022737368f));
                                        loop {
                                            let _e1477 = phi_4926_;
                                            let _e1479 = phi_4929_;
                                            if (_e1477.member < _e1477.member_1) {
                                                phi_4927_ = type_9((_e1477.member + 1u), _e1477.member_1);
                                                phi_4952_ = type_9(1u, _e1477.member);
                                            } else {
                                                phi_4927_ = _e1477;
                                                phi_4952_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e1491 = phi_4927_;
                                            let _e1493 = phi_4952_;
                                            if (bitcast<i32>(_e1493.member) != 0i) {
                                                let _e1497 = (_e1468 + _e1479);
                                                if (_e1497 < _e1278) {
                                                    let _e1500 = (f64(1f) - _e1497);
                                                    let _e1513 = ((_e1473 * ((((_e716 * _e1500) + (_e739 * _e1497)) * (_e1500 * _e1500)) + (((_e762 * _e1500) + (_e773 * _e1497)) * (_e1497 * _e1497)))) > _e1109);
                                                    if _e1513 {
                                                        phi_4983_ = f64();
                                                        phi_4984_ = false;
                                                    } else {
                                                        phi_4983_ = (_e1479 + _e1479);
                                                        phi_4984_ = true;
                                                    }
                                                    let _e1516 = phi_4983_;
                                                    let _e1518 = phi_4984_;
                                                    phi_4985_ = _e1516;
                                                    phi_4986_ = _e1518;
                                                    phi_4987_ = _e1513;
                                                    phi_4988_ = false;
                                                } else {
                                                    phi_4985_ = f64();
                                                    phi_4986_ = false;
                                                    phi_4987_ = false;
                                                    phi_4988_ = true;
                                                }
                                                let _e1520 = phi_4985_;
                                                let _e1522 = phi_4986_;
                                                let _e1524 = phi_4987_;
                                                let _e1526 = phi_4988_;
                                                phi_4989_ = _e1497;
                                                phi_4930_ = _e1520;
                                                phi_4990_ = _e1522;
                                                phi_4991_ = _e1524;
                                                phi_4992_ = _e1526;
                                                phi_4993_ = false;
                                            } else {
                                                phi_4989_ = f64();
                                                phi_4930_ = f64();
                                                phi_4990_ = false;
                                                phi_4991_ = false;
                                                phi_4992_ = false;
                                                phi_4993_ = true;
                                            }
                                            let _e1528 = phi_4989_;
                                            let _e1530 = phi_4930_;
                                            let _e1532 = phi_4990_;
                                            let _e1534 = phi_4991_;
                                            let _e1536 = phi_4992_;
                                            let _e1538 = phi_4993_;
                                            local_15 = _e1534;
                                            local_32 = _e1536;
                                            local_33 = _e1538;
                                            local_34 = _e1528;
                                            continue;
                                            continuing {
                                                phi_4926_ = _e1491;
                                                phi_4929_ = _e1530;
                                                break if !(_e1532);
                                            }
                                        }
                                        let _e1541 = local_15;
                                        if _e1541 {
                                            phi_4997_ = false;
                                            phi_4998_ = false;
                                        } else {
                                            let _e5824 = local_32;
                                            phi_4997_ = _e5824;
                                            let _e5827 = local_33;
                                            phi_4998_ = _e5827;
                                        }
                                        let _e1543 = phi_4997_;
                                        let _e1545 = phi_4998_;
                                        if _e1543 {
                                            phi_5002_ = true;
                                        } else {
                                            phi_5002_ = _e1545;
                                        }
                                        let _e1547 = phi_5002_;
                                        if _e1547 {
                                            phi_5006_ = _e1278;
                                        } else {
                                            let _e5831 = local_34;
                                            phi_5006_ = _e5831;
                                        }
                                        let _e1549 = phi_5006_;
                                        phi_5007_ = _e1549;
                                    } else {
                                        phi_5007_ = _e1278;
                                    }
                                    let _e1551 = phi_5007_;
                                    phi_5009_ = type_45(_e1468, _e1551, _e1328);
                                } else {
                                    phi_5009_ = _e1338;
                                }
                                let _e1554 = phi_5009_;
                                if (_e1554.member > _e1554.member_1) {
                                    phi_8327_ = f64();
                                    phi_8328_ = true;
                                    phi_8329_ = false;
                                    phi_8330_ = false;
                                    phi_8331_ = false;
                                } else {
                                    let _e1562 = ((_e1554.member_1 - _e1554.member) * f64(0.5f));
                                    let _e1563 = (_e1554.member + _e1562);
                                    let _e1566 = (_e1562 + (1.1102230246251565e-16lf * f64(4f)));
                                    let _e1568 = local_12.member_3;
                                    let _e1571 = local_12.member[0u];
                                    if (_e1571[0] < 0.0lf) {
                                        phi_5040_ = -(_e1571[0]);
                                    } else {
                                        phi_5040_ = _e1571[0];
                                    }
                                    let _e1578 = phi_5040_;
                                    if (_e1571[1] < 0.0lf) {
                                        phi_5047_ = -(_e1571[1]);
                                    } else {
                                        phi_5047_ = _e1571[1];
                                    }
                                    let _e1582 = phi_5047_;
                                    if (_e1578 > _e1582) {
                                        phi_5052_ = _e1578;
                                    } else {
                                        phi_5052_ = _e1582;
                                    }
                                    let _e1585 = phi_5052_;
                                    if (_e1571[2] < 0.0lf) {
                                        phi_5059_ = -(_e1571[2]);
                                    } else {
                                        phi_5059_ = _e1571[2];
                                    }
                                    let _e1589 = phi_5059_;
                                    if (_e1585 > _e1589) {
                                        phi_5064_ = _e1585;
                                    } else {
                                        phi_5064_ = _e1589;
                                    }
                                    let _e1592 = phi_5064_;
                                    let _e1594 = local_12.member[1u];
                                    if (_e1594[0] < 0.0lf) {
                                        phi_5077_ = -(_e1594[0]);
                                    } else {
                                        phi_5077_ = _e1594[0];
                                    }
                                    let _e1601 = phi_5077_;
                                    if (_e1594[1] < 0.0lf) {
                                        phi_5084_ = -(_e1594[1]);
                                    } else {
                                        phi_5084_ = _e1594[1];
                                    }
                                    let _e1605 = phi_5084_;
                                    if (_e1601 > _e1605) {
                                        phi_5089_ = _e1601;
                                    } else {
                                        phi_5089_ = _e1605;
                                    }
                                    let _e1608 = phi_5089_;
                                    if (_e1594[2] < 0.0lf) {
                                        phi_5096_ = -(_e1594[2]);
                                    } else {
                                        phi_5096_ = _e1594[2];
                                    }
                                    let _e1612 = phi_5096_;
                                    if (_e1608 > _e1612) {
                                        phi_5101_ = _e1608;
                                    } else {
                                        phi_5101_ = _e1612;
                                    }
                                    let _e1615 = phi_5101_;
                                    if (_e1592 > _e1615) {
                                        phi_5106_ = _e1592;
                                    } else {
                                        phi_5106_ = _e1615;
                                    }
                                    let _e1618 = phi_5106_;
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
                                        phi_5165_ = -(_e1649);
                                    } else {
                                        phi_5165_ = _e1649;
                                    }
                                    let _e1655 = phi_5165_;
                                    if (_e1650 < 0.0lf) {
                                        phi_5171_ = -(_e1650);
                                    } else {
                                        phi_5171_ = _e1650;
                                    }
                                    let _e1659 = phi_5171_;
                                    if (_e1655 > _e1659) {
                                        phi_5176_ = _e1655;
                                    } else {
                                        phi_5176_ = _e1659;
                                    }
                                    let _e1662 = phi_5176_;
                                    if (_e1651 < 0.0lf) {
                                        phi_5182_ = -(_e1651);
                                    } else {
                                        phi_5182_ = _e1651;
                                    }
                                    let _e1666 = phi_5182_;
                                    if (_e1662 > _e1666) {
                                        phi_5187_ = _e1662;
                                    } else {
                                        phi_5187_ = _e1666;
                                    }
                                    let _e1669 = phi_5187_;
                                    let _e1677 = ((((_e1566 * _e1669) * f64(1.01f)) + ((_e1618 + _e1568) * (1.1102230246251565e-16lf * f64(8f)))) + _e1568);
                                    if (_e1636 < 0.0lf) {
                                        phi_5201_ = -(_e1636);
                                    } else {
                                        phi_5201_ = _e1636;
                                    }
                                    let _e1681 = phi_5201_;
                                    if (_e1637 < 0.0lf) {
                                        phi_5207_ = -(_e1637);
                                    } else {
                                        phi_5207_ = _e1637;
                                    }
                                    let _e1685 = phi_5207_;
                                    if (_e1681 > _e1685) {
                                        phi_5212_ = _e1681;
                                    } else {
                                        phi_5212_ = _e1685;
                                    }
                                    let _e1688 = phi_5212_;
                                    if (_e1638 < 0.0lf) {
                                        phi_5218_ = -(_e1638);
                                    } else {
                                        phi_5218_ = _e1638;
                                    }
                                    let _e1692 = phi_5218_;
                                    if (_e1688 > _e1692) {
                                        phi_5223_ = _e1688;
                                    } else {
                                        phi_5223_ = _e1692;
                                    }
                                    let _e1695 = phi_5223_;
                                    local_2 = type_35(array<f64, 3>(_e1636, _e1637, _e1638), _e1677, (_e1695 + _e1677));
                                    let _e1701 = local_12.member_3;
                                    let _e1703 = local_12.member_1[0u];
                                    if (_e1703[0] < 0.0lf) {
                                        phi_5249_ = -(_e1703[0]);
                                    } else {
                                        phi_5249_ = _e1703[0];
                                    }
                                    let _e1710 = phi_5249_;
                                    if (_e1703[1] < 0.0lf) {
                                        phi_5256_ = -(_e1703[1]);
                                    } else {
                                        phi_5256_ = _e1703[1];
                                    }
                                    let _e1714 = phi_5256_;
                                    if (_e1710 > _e1714) {
                                        phi_5261_ = _e1710;
                                    } else {
                                        phi_5261_ = _e1714;
                                    }
                                    let _e1717 = phi_5261_;
                                    if (_e1703[2] < 0.0lf) {
                                        phi_5268_ = -(_e1703[2]);
                                    } else {
                                        phi_5268_ = _e1703[2];
                                    }
                                    let _e1721 = phi_5268_;
                                    if (_e1717 > _e1721) {
                                        phi_5273_ = _e1717;
                                    } else {
                                        phi_5273_ = _e1721;
                                    }
                                    let _e1724 = phi_5273_;
                                    let _e1726 = local_12.member_1[1u];
                                    if (_e1726[0] < 0.0lf) {
                                        phi_5286_ = -(_e1726[0]);
                                    } else {
                                        phi_5286_ = _e1726[0];
                                    }
                                    let _e1733 = phi_5286_;
                                    if (_e1726[1] < 0.0lf) {
                                        phi_5293_ = -(_e1726[1]);
                                    } else {
                                        phi_5293_ = _e1726[1];
                                    }
                                    let _e1737 = phi_5293_;
                                    if (_e1733 > _e1737) {
                                        phi_5298_ = _e1733;
                                    } else {
                                        phi_5298_ = _e1737;
                                    }
                                    let _e1740 = phi_5298_;
                                    if (_e1726[2] < 0.0lf) {
                                        phi_5305_ = -(_e1726[2]);
                                    } else {
                                        phi_5305_ = _e1726[2];
                                    }
                                    let _e1744 = phi_5305_;
                                    if (_e1740 > _e1744) {
                                        phi_5310_ = _e1740;
                                    } else {
                                        phi_5310_ = _e1744;
                                    }
                                    let _e1747 = phi_5310_;
                                    if (_e1724 > _e1747) {
                                        phi_5315_ = _e1724;
                                    } else {
                                        phi_5315_ = _e1747;
                                    }
                                    let _e1750 = phi_5315_;
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
                                        phi_5374_ = -(_e1781);
                                    } else {
                                        phi_5374_ = _e1781;
                                    }
                                    let _e1787 = phi_5374_;
                                    if (_e1782 < 0.0lf) {
                                        phi_5380_ = -(_e1782);
                                    } else {
                                        phi_5380_ = _e1782;
                                    }
                                    let _e1791 = phi_5380_;
                                    if (_e1787 > _e1791) {
                                        phi_5385_ = _e1787;
                                    } else {
                                        phi_5385_ = _e1791;
                                    }
                                    let _e1794 = phi_5385_;
                                    if (_e1783 < 0.0lf) {
                                        phi_5391_ = -(_e1783);
                                    } else {
                                        phi_5391_ = _e1783;
                                    }
                                    let _e1798 = phi_5391_;
                                    if (_e1794 > _e1798) {
                                        phi_5396_ = _e1794;
                                    } else {
                                        phi_5396_ = _e1798;
                                    }
                                    let _e1801 = phi_5396_;
                                    let _e1809 = ((((_e1566 * _e1801) * f64(1.01f)) + ((_e1750 + _e1701) * (1.1102230246251565e-16lf * f64(8f)))) + _e1701);
                                    if (_e1768 < 0.0lf) {
                                        phi_5410_ = -(_e1768);
                                    } else {
                                        phi_5410_ = _e1768;
                                    }
                                    let _e1813 = phi_5410_;
                                    if (_e1769 < 0.0lf) {
                                        phi_5416_ = -(_e1769);
                                    } else {
                                        phi_5416_ = _e1769;
                                    }
                                    let _e1817 = phi_5416_;
                                    if (_e1813 > _e1817) {
                                        phi_5421_ = _e1813;
                                    } else {
                                        phi_5421_ = _e1817;
                                    }
                                    let _e1820 = phi_5421_;
                                    if (_e1770 < 0.0lf) {
                                        phi_5427_ = -(_e1770);
                                    } else {
                                        phi_5427_ = _e1770;
                                    }
                                    let _e1824 = phi_5427_;
                                    if (_e1820 > _e1824) {
                                        phi_5432_ = _e1820;
                                    } else {
                                        phi_5432_ = _e1824;
                                    }
                                    let _e1827 = phi_5432_;
                                    local_3 = type_35(array<f64, 3>(_e1768, _e1769, _e1770), _e1809, (_e1827 + _e1809));
                                    let _e1833 = local_12.member_3;
                                    let _e1835 = local_12.member_2[0u];
                                    if (_e1835[0] < 0.0lf) {
                                        phi_5458_ = -(_e1835[0]);
                                    } else {
                                        phi_5458_ = _e1835[0];
                                    }
                                    let _e1842 = phi_5458_;
                                    if (_e1835[1] < 0.0lf) {
                                        phi_5465_ = -(_e1835[1]);
                                    } else {
                                        phi_5465_ = _e1835[1];
                                    }
                                    let _e1846 = phi_5465_;
                                    if (_e1842 > _e1846) {
                                        phi_5470_ = _e1842;
                                    } else {
                                        phi_5470_ = _e1846;
                                    }
                                    let _e1849 = phi_5470_;
                                    if (_e1835[2] < 0.0lf) {
                                        phi_5477_ = -(_e1835[2]);
                                    } else {
                                        phi_5477_ = _e1835[2];
                                    }
                                    let _e1853 = phi_5477_;
                                    if (_e1849 > _e1853) {
                                        phi_5482_ = _e1849;
                                    } else {
                                        phi_5482_ = _e1853;
                                    }
                                    let _e1856 = phi_5482_;
                                    let _e1858 = local_12.member_2[1u];
                                    if (_e1858[0] < 0.0lf) {
                                        phi_5495_ = -(_e1858[0]);
                                    } else {
                                        phi_5495_ = _e1858[0];
                                    }
                                    let _e1865 = phi_5495_;
                                    if (_e1858[1] < 0.0lf) {
                                        phi_5502_ = -(_e1858[1]);
                                    } else {
                                        phi_5502_ = _e1858[1];
                                    }
                                    let _e1869 = phi_5502_;
                                    if (_e1865 > _e1869) {
                                        phi_5507_ = _e1865;
                                    } else {
                                        phi_5507_ = _e1869;
                                    }
                                    let _e1872 = phi_5507_;
                                    if (_e1858[2] < 0.0lf) {
                                        phi_5514_ = -(_e1858[2]);
                                    } else {
                                        phi_5514_ = _e1858[2];
                                    }
                                    let _e1876 = phi_5514_;
                                    if (_e1872 > _e1876) {
                                        phi_5519_ = _e1872;
                                    } else {
                                        phi_5519_ = _e1876;
                                    }
                                    let _e1879 = phi_5519_;
                                    if (_e1856 > _e1879) {
                                        phi_5524_ = _e1856;
                                    } else {
                                        phi_5524_ = _e1879;
                                    }
                                    let _e1882 = phi_5524_;
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
                                        phi_5583_ = -(_e1913);
                                    } else {
                                        phi_5583_ = _e1913;
                                    }
                                    let _e1919 = phi_5583_;
                                    if (_e1914 < 0.0lf) {
                                        phi_5589_ = -(_e1914);
                                    } else {
                                        phi_5589_ = _e1914;
                                    }
                                    let _e1923 = phi_5589_;
                                    if (_e1919 > _e1923) {
                                        phi_5594_ = _e1919;
                                    } else {
                                        phi_5594_ = _e1923;
                                    }
                                    let _e1926 = phi_5594_;
                                    if (_e1915 < 0.0lf) {
                                        phi_5600_ = -(_e1915);
                                    } else {
                                        phi_5600_ = _e1915;
                                    }
                                    let _e1930 = phi_5600_;
                                    if (_e1926 > _e1930) {
                                        phi_5605_ = _e1926;
                                    } else {
                                        phi_5605_ = _e1930;
                                    }
                                    let _e1933 = phi_5605_;
                                    let _e1941 = ((((_e1566 * _e1933) * f64(1.01f)) + ((_e1882 + _e1833) * (1.1102230246251565e-16lf * f64(8f)))) + _e1833);
                                    if (_e1900 < 0.0lf) {
                                        phi_5619_ = -(_e1900);
                                    } else {
                                        phi_5619_ = _e1900;
                                    }
                                    let _e1945 = phi_5619_;
                                    if (_e1901 < 0.0lf) {
                                        phi_5625_ = -(_e1901);
                                    } else {
                                        phi_5625_ = _e1901;
                                    }
                                    let _e1949 = phi_5625_;
                                    if (_e1945 > _e1949) {
                                        phi_5630_ = _e1945;
                                    } else {
                                        phi_5630_ = _e1949;
                                    }
                                    let _e1952 = phi_5630_;
                                    if (_e1902 < 0.0lf) {
                                        phi_5636_ = -(_e1902);
                                    } else {
                                        phi_5636_ = _e1902;
                                    }
                                    let _e1956 = phi_5636_;
                                    if (_e1952 > _e1956) {
                                        phi_5641_ = _e1952;
                                    } else {
                                        phi_5641_ = _e1956;
                                    }
                                    let _e1959 = phi_5641_;
                                    local_4 = type_35(array<f64, 3>(_e1900, _e1901, _e1902), _e1941, (_e1959 + _e1941));
                                    let _e1964 = local_3.member;
                                    let _e1969 = local_4.member;
                                    let _e1975 = ((_e1964[1] * _e1969[2]) - (_e1964[2] * _e1969[1]));
                                    let _e1978 = ((_e1964[2] * _e1969[0]) - (_e1964[0] * _e1969[2]));
                                    let _e1981 = ((_e1964[0] * _e1969[1]) - (_e1964[1] * _e1969[0]));
                                    if (_e1975 < 0.0lf) {
                                        phi_5690_ = -(_e1975);
                                    } else {
                                        phi_5690_ = _e1975;
                                    }
                                    let _e1985 = phi_5690_;
                                    if (_e1978 < 0.0lf) {
                                        phi_5696_ = -(_e1978);
                                    } else {
                                        phi_5696_ = _e1978;
                                    }
                                    let _e1989 = phi_5696_;
                                    if (_e1985 > _e1989) {
                                        if (_e1975 < 0.0lf) {
                                            phi_5706_ = -(_e1975);
                                        } else {
                                            phi_5706_ = _e1975;
                                        }
                                        let _e2007 = phi_5706_;
                                        if (_e1981 < 0.0lf) {
                                            phi_5712_ = -(_e1981);
                                        } else {
                                            phi_5712_ = _e1981;
                                        }
                                        let _e2011 = phi_5712_;
                                        if (_e2007 > _e2011) {
                                            phi_5717_ = 2u;
                                            phi_5718_ = 1u;
                                        } else {
                                            phi_5717_ = 1u;
                                            phi_5718_ = 0u;
                                        }
                                        let _e2014 = phi_5717_;
                                        let _e2016 = phi_5718_;
                                        phi_5737_ = _e2014;
                                        phi_5738_ = _e2016;
                                    } else {
                                        if (_e1978 < 0.0lf) {
                                            phi_5724_ = -(_e1978);
                                        } else {
                                            phi_5724_ = _e1978;
                                        }
                                        let _e1994 = phi_5724_;
                                        if (_e1981 < 0.0lf) {
                                            phi_5730_ = -(_e1981);
                                        } else {
                                            phi_5730_ = _e1981;
                                        }
                                        let _e1998 = phi_5730_;
                                        if (_e1994 > _e1998) {
                                            phi_5735_ = 0u;
                                            phi_5736_ = 2u;
                                        } else {
                                            phi_5735_ = 1u;
                                            phi_5736_ = 0u;
                                        }
                                        let _e2001 = phi_5735_;
                                        let _e2003 = phi_5736_;
                                        phi_5737_ = _e2001;
                                        phi_5738_ = _e2003;
                                    }
                                    let _e2018 = phi_5737_;
                                    let _e2020 = phi_5738_;
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
                                        phi_5811_ = -(_e2035);
                                    } else {
                                        phi_5811_ = _e2035;
                                    }
                                    let _e2075 = phi_5811_;
                                    if (_e2075 > _e2071) {
                                        if (_e2035 < f64(0f)) {
                                            phi_5823_ = f64(-1f);
                                        } else {
                                            phi_5823_ = f64(1f);
                                        }
                                        let _e2082 = phi_5823_;
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
                                            phi_5966_ = -(_e2185);
                                        } else {
                                            phi_5966_ = _e2185;
                                        }
                                        let _e2191 = phi_5966_;
                                        if (_e2186 < 0.0lf) {
                                            phi_5972_ = -(_e2186);
                                        } else {
                                            phi_5972_ = _e2186;
                                        }
                                        let _e2195 = phi_5972_;
                                        if (_e2187 < 0.0lf) {
                                            phi_5979_ = -(_e2187);
                                        } else {
                                            phi_5979_ = _e2187;
                                        }
                                        let _e2200 = phi_5979_;
                                        let _e2204 = (((_e2191 + _e2195) + _e2200) * (1.1102230246251565e-16lf * f64(4f)));
                                        local_5 = array<type_36, 4>(type_36(_e2186, _e2133), type_36(_e2187, _e2184), type_36((_e2185 - _e2186), ((_e2071 + _e2133) + _e2204)), type_36((_e2185 - _e2187), ((_e2071 + _e2184) + _e2204)));
                                        phi_6035_ = type_9(0u, 4u);
                                        phi_6038_ = true;
                                        loop {
                                            let _e2217 = phi_6035_;
                                            let _e2219 = phi_6038_;
                                            local_17 = _e2219;
                                            if (_e2217.member < _e2217.member_1) {
                                                phi_6036_ = type_9((_e2217.member + 1u), _e2217.member_1);
                                                phi_6061_ = type_9(1u, _e2217.member);
                                            } else {
                                                phi_6036_ = _e2217;
                                                phi_6061_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2231 = phi_6036_;
                                            let _e2233 = phi_6061_;
                                            if (bitcast<i32>(_e2233.member) != 0i) {
                                                let _e2240 = local_5[_e2233.member_1].member;
                                                let _e2243 = local_5[_e2233.member_1].member_1;
                                                let _e2245 = (_e2240 < -(_e2243));
                                                if _e2245 {
                                                    phi_6088_ = bool();
                                                    phi_6089_ = false;
                                                } else {
                                                    phi_6088_ = (_e2219 && (_e2240 > _e2243));
                                                    phi_6089_ = true;
                                                }
                                                let _e2249 = phi_6088_;
                                                let _e2251 = phi_6089_;
                                                phi_6039_ = _e2249;
                                                phi_6090_ = _e2251;
                                                phi_6091_ = _e2245;
                                            } else {
                                                phi_6039_ = bool();
                                                phi_6090_ = false;
                                                phi_6091_ = false;
                                            }
                                            let _e2253 = phi_6039_;
                                            let _e2255 = phi_6090_;
                                            let _e2257 = phi_6091_;
                                            local_16 = _e2257;
                                            continue;
                                            continuing {
                                                phi_6035_ = _e2231;
                                                phi_6038_ = _e2253;
                                                break if !(_e2255);
                                            }
                                        }
                                        let _e2260 = local_16;
                                        if _e2260 {
                                            phi_6095_ = false;
                                        } else {
                                            phi_6095_ = true;
                                        }
                                        let _e2262 = phi_6095_;
                                        if _e2262 {
                                            let _e2264 = local_17;
                                            if _e2264 {
                                                phi_6102_ = 1u;
                                            } else {
                                                phi_6102_ = 2u;
                                            }
                                            let _e2266 = phi_6102_;
                                            phi_6103_ = _e2266;
                                            phi_6104_ = false;
                                        } else {
                                            phi_6103_ = u32();
                                            phi_6104_ = true;
                                        }
                                        let _e2268 = phi_6103_;
                                        let _e2270 = phi_6104_;
                                        phi_6105_ = _e2268;
                                        phi_6106_ = 0u;
                                        phi_6107_ = _e2270;
                                    } else {
                                        phi_6105_ = u32();
                                        phi_6106_ = 2u;
                                        phi_6107_ = true;
                                    }
                                    let _e2272 = phi_6105_;
                                    let _e2274 = phi_6106_;
                                    let _e2276 = phi_6107_;
                                    if _e2276 {
                                        phi_6111_ = _e2274;
                                    } else {
                                        phi_6111_ = _e2272;
                                    }
                                    let _e2278 = phi_6111_;
                                    let _e2279 = (_e2278 == 0u);
                                    if _e2279 {
                                        phi_8323_ = f64();
                                        phi_8324_ = false;
                                        phi_8325_ = false;
                                        phi_8326_ = false;
                                    } else {
                                        if (_e2278 == 1u) {
                                            if _e1554.member_2 {
                                                if ((_e1554.member_1 - _e1554.member) <= f64(0.0000005f)) {
                                                    phi_6132_ = false;
                                                } else {
                                                    phi_6132_ = true;
                                                }
                                                let _e2288 = phi_6132_;
                                                phi_6133_ = _e2288;
                                            } else {
                                                phi_6133_ = true;
                                            }
                                            let _e2290 = phi_6133_;
                                            phi_6134_ = _e2290;
                                        } else {
                                            phi_6134_ = true;
                                        }
                                        let _e2292 = phi_6134_;
                                        if _e2292 {
                                            let _e2298 = local_12.member[0u];
                                            let _e2304 = local_12.member_1[0u];
                                            let _e2310 = local_12.member_2[0u];
                                            let _e2314 = (_e2298[0] - _e2304[0]);
                                            let _e2315 = (_e2298[1] - _e2304[1]);
                                            let _e2316 = (_e2298[2] - _e2304[2]);
                                            let _e2325 = local_12.member[1u];
                                            let _e2331 = local_12.member_1[1u];
                                            let _e2337 = local_12.member_2[1u];
                                            let _e2341 = (_e2325[0] - _e2331[0]);
                                            let _e2342 = (_e2325[1] - _e2331[1]);
                                            let _e2343 = (_e2325[2] - _e2331[2]);
                                            let _e2352 = local_12.member[0u];
                                            if (_e2352[0] < 0.0lf) {
                                                phi_6283_ = -(_e2352[0]);
                                            } else {
                                                phi_6283_ = _e2352[0];
                                            }
                                            let _e2359 = phi_6283_;
                                            if (_e2352[1] < 0.0lf) {
                                                phi_6290_ = -(_e2352[1]);
                                            } else {
                                                phi_6290_ = _e2352[1];
                                            }
                                            let _e2363 = phi_6290_;
                                            if (_e2359 > _e2363) {
                                                phi_6295_ = _e2359;
                                            } else {
                                                phi_6295_ = _e2363;
                                            }
                                            let _e2366 = phi_6295_;
                                            if (_e2352[2] < 0.0lf) {
                                                phi_6302_ = -(_e2352[2]);
                                            } else {
                                                phi_6302_ = _e2352[2];
                                            }
                                            let _e2370 = phi_6302_;
                                            if (_e2366 > _e2370) {
                                                phi_6307_ = _e2366;
                                            } else {
                                                phi_6307_ = _e2370;
                                            }
                                            let _e2373 = phi_6307_;
                                            let _e2376 = local_12.member[1u];
                                            if (_e2376[0] < 0.0lf) {
                                                phi_6320_ = -(_e2376[0]);
                                            } else {
                                                phi_6320_ = _e2376[0];
                                            }
                                            let _e2383 = phi_6320_;
                                            if (_e2376[1] < 0.0lf) {
                                                phi_6327_ = -(_e2376[1]);
                                            } else {
                                                phi_6327_ = _e2376[1];
                                            }
                                            let _e2387 = phi_6327_;
                                            if (_e2383 > _e2387) {
                                                phi_6332_ = _e2383;
                                            } else {
                                                phi_6332_ = _e2387;
                                            }
                                            let _e2390 = phi_6332_;
                                            if (_e2376[2] < 0.0lf) {
                                                phi_6339_ = -(_e2376[2]);
                                            } else {
                                                phi_6339_ = _e2376[2];
                                            }
                                            let _e2394 = phi_6339_;
                                            if (_e2390 > _e2394) {
                                                phi_6344_ = _e2390;
                                            } else {
                                                phi_6344_ = _e2394;
                                            }
                                            let _e2397 = phi_6344_;
                                            if (_e2373 > _e2397) {
                                                phi_6349_ = _e2373;
                                            } else {
                                                phi_6349_ = _e2397;
                                            }
                                            let _e2400 = phi_6349_;
                                            let _e2402 = local_12.member_3;
                                            let _e2406 = local_12.member_1[0u];
                                            if (_e2406[0] < 0.0lf) {
                                                phi_6366_ = -(_e2406[0]);
                                            } else {
                                                phi_6366_ = _e2406[0];
                                            }
                                            let _e2413 = phi_6366_;
                                            if (_e2406[1] < 0.0lf) {
                                                phi_6373_ = -(_e2406[1]);
                                            } else {
                                                phi_6373_ = _e2406[1];
                                            }
                                            let _e2417 = phi_6373_;
                                            if (_e2413 > _e2417) {
                                                phi_6378_ = _e2413;
                                            } else {
                                                phi_6378_ = _e2417;
                                            }
                                            let _e2420 = phi_6378_;
                                            if (_e2406[2] < 0.0lf) {
                                                phi_6385_ = -(_e2406[2]);
                                            } else {
                                                phi_6385_ = _e2406[2];
                                            }
                                            let _e2424 = phi_6385_;
                                            if (_e2420 > _e2424) {
                                                phi_6390_ = _e2420;
                                            } else {
                                                phi_6390_ = _e2424;
                                            }
                                            let _e2427 = phi_6390_;
                                            let _e2430 = local_12.member_1[1u];
                                            if (_e2430[0] < 0.0lf) {
                                                phi_6404_ = -(_e2430[0]);
                                            } else {
                                                phi_6404_ = _e2430[0];
                                            }
                                            let _e2437 = phi_6404_;
                                            if (_e2430[1] < 0.0lf) {
                                                phi_6411_ = -(_e2430[1]);
                                            } else {
                                                phi_6411_ = _e2430[1];
                                            }
                                            let _e2441 = phi_6411_;
                                            if (_e2437 > _e2441) {
                                                phi_6416_ = _e2437;
                                            } else {
                                                phi_6416_ = _e2441;
                                            }
                                            let _e2444 = phi_6416_;
                                            if (_e2430[2] < 0.0lf) {
                                                phi_6423_ = -(_e2430[2]);
                                            } else {
                                                phi_6423_ = _e2430[2];
                                            }
                                            let _e2448 = phi_6423_;
                                            if (_e2444 > _e2448) {
                                                phi_6428_ = _e2444;
                                            } else {
                                                phi_6428_ = _e2448;
                                            }
                                            let _e2451 = phi_6428_;
                                            if (_e2427 > _e2451) {
                                                phi_6433_ = _e2427;
                                            } else {
                                                phi_6433_ = _e2451;
                                            }
                                            let _e2454 = phi_6433_;
                                            let _e2456 = local_12.member_3;
                                            let _e2460 = local_12.member_2[0u];
                                            if (_e2460[0] < 0.0lf) {
                                                phi_6450_ = -(_e2460[0]);
                                            } else {
                                                phi_6450_ = _e2460[0];
                                            }
                                            let _e2467 = phi_6450_;
                                            if (_e2460[1] < 0.0lf) {
                                                phi_6457_ = -(_e2460[1]);
                                            } else {
                                                phi_6457_ = _e2460[1];
                                            }
                                            let _e2471 = phi_6457_;
                                            if (_e2467 > _e2471) {
                                                phi_6462_ = _e2467;
                                            } else {
                                                phi_6462_ = _e2471;
                                            }
                                            let _e2474 = phi_6462_;
                                            if (_e2460[2] < 0.0lf) {
                                                phi_6469_ = -(_e2460[2]);
                                            } else {
                                                phi_6469_ = _e2460[2];
                                            }
                                            let _e2478 = phi_6469_;
                                            if (_e2474 > _e2478) {
                                                phi_6474_ = _e2474;
                                            } else {
                                                phi_6474_ = _e2478;
                                            }
                                            let _e2481 = phi_6474_;
                                            let _e2484 = local_12.member_2[1u];
                                            if (_e2484[0] < 0.0lf) {
                                                phi_6488_ = -(_e2484[0]);
                                            } else {
                                                phi_6488_ = _e2484[0];
                                            }
                                            let _e2491 = phi_6488_;
                                            if (_e2484[1] < 0.0lf) {
                                                phi_6495_ = -(_e2484[1]);
                                            } else {
                                                phi_6495_ = _e2484[1];
                                            }
                                            let _e2495 = phi_6495_;
                                            if (_e2491 > _e2495) {
                                                phi_6500_ = _e2491;
                                            } else {
                                                phi_6500_ = _e2495;
                                            }
                                            let _e2498 = phi_6500_;
                                            if (_e2484[2] < 0.0lf) {
                                                phi_6507_ = -(_e2484[2]);
                                            } else {
                                                phi_6507_ = _e2484[2];
                                            }
                                            let _e2502 = phi_6507_;
                                            if (_e2498 > _e2502) {
                                                phi_6512_ = _e2498;
                                            } else {
                                                phi_6512_ = _e2502;
                                            }
                                            let _e2505 = phi_6512_;
                                            if (_e2481 > _e2505) {
                                                phi_6517_ = _e2481;
                                            } else {
                                                phi_6517_ = _e2505;
                                            }
                                            let _e2508 = phi_6517_;
                                            let _e2510 = local_12.member_3;
                                            let _e2518 = local_12.member_3;
                                            let _e2525 = f64(0f);
                                            let _e2526 = f64(1f);
                                            local = type_34(array<f64, 4>(_e2525, _e2525, _e2525, _e2525), array<f64, 4>(_e2525, _e2525, _e2525, _e2525), array<f64, 4>(_e2526, _e2526, _e2526, _e2526));
                                            phi_6561_ = type_9(0u, 96u);
                                            phi_6564_ = _e1554.member;
                                            phi_6566_ = _e1554.member;
                                            phi_6568_ = _e1554.member;
                                            phi_6570_ = false;
                                            phi_6572_ = 0u;
                                            loop {
                                                let _e2532 = phi_6561_;
                                                let _e2534 = phi_6564_;
                                                let _e2536 = phi_6566_;
                                                let _e2538 = phi_6568_;
                                                let _e2540 = phi_6570_;
                                                let _e2542 = phi_6572_;
                                                local_36 = _e2536;
                                                local_20 = _e2534;
                                                if (_e2532.member < _e2532.member_1) {
                                                    phi_6562_ = type_9((_e2532.member + 1u), _e2532.member_1);
                                                    phi_6595_ = type_9(1u, _e2532.member);
                                                } else {
                                                    phi_6562_ = _e2532;
                                                    phi_6595_ = type_9(0u, type_9().member_1);
                                                }
                                                let _e2554 = phi_6562_;
                                                let _e2556 = phi_6595_;
                                                if (bitcast<i32>(_e2556.member) != 0i) {
                                                    let _e2562 = local_12.member[0u];
                                                    let _e2568 = local_12.member[1u];
                                                    let _e2584 = local_12.member_1[0u];
                                                    let _e2590 = local_12.member_1[1u];
                                                    let _e2606 = local_12.member_2[0u];
                                                    let _e2612 = local_12.member_2[1u];
                                                    let _e2626 = function_2(array<f64, 3>((_e2562[0] + ((_e2568[0] - _e2562[0]) * _e2534)), (_e2562[1] + ((_e2568[1] - _e2562[1]) * _e2534)), (_e2562[2] + ((_e2568[2] - _e2562[2]) * _e2534))), array<f64, 3>((_e2584[0] + ((_e2590[0] - _e2584[0]) * _e2534)), (_e2584[1] + ((_e2590[1] - _e2584[1]) * _e2534)), (_e2584[2] + ((_e2590[2] - _e2584[2]) * _e2534))), array<f64, 3>((_e2606[0] + ((_e2612[0] - _e2606[0]) * _e2534)), (_e2606[1] + ((_e2612[1] - _e2606[1]) * _e2534)), (_e2606[2] + ((_e2612[2] - _e2606[2]) * _e2534))), 1u);
                                                    if (_e2542 == 0u) {
                                                        phi_6724_ = _e2626;
                                                    } else {
                                                        let _e2628 = f64(0f);
                                                        if (_e2542 == 1u) {
                                                            phi_6710_ = _e2626[0];
                                                        } else {
                                                            phi_6710_ = _e2628;
                                                        }
                                                        let _e2632 = phi_6710_;
                                                        if (_e2542 == 2u) {
                                                            phi_6716_ = _e2626[1];
                                                        } else {
                                                            phi_6716_ = _e2628;
                                                        }
                                                        let _e2636 = phi_6716_;
                                                        if (_e2542 == 3u) {
                                                            phi_6722_ = _e2626[2];
                                                        } else {
                                                            phi_6722_ = _e2628;
                                                        }
                                                        let _e2640 = phi_6722_;
                                                        phi_6724_ = array<f64, 3>(_e2632, _e2636, _e2640);
                                                    }
                                                    let _e2643 = phi_6724_;
                                                    if (_e2643[0] < 0.0lf) {
                                                        phi_6731_ = -(_e2643[0]);
                                                    } else {
                                                        phi_6731_ = _e2643[0];
                                                    }
                                                    let _e2648 = phi_6731_;
                                                    if (_e2643[1] < 0.0lf) {
                                                        phi_6738_ = -(_e2643[1]);
                                                    } else {
                                                        phi_6738_ = _e2643[1];
                                                    }
                                                    let _e2653 = phi_6738_;
                                                    if (_e2643[2] < 0.0lf) {
                                                        phi_6746_ = -(_e2643[2]);
                                                    } else {
                                                        phi_6746_ = _e2643[2];
                                                    }
                                                    let _e2659 = phi_6746_;
                                                    let _e2660 = ((_e2648 + _e2653) + _e2659);
                                                    if (_e2660 > f64(0f)) {
                                                        if ((bitcast<u64>(_e2660) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                            let _e2667 = (f64(1f) / _e2660);
                                                            let _e2669 = (_e2643[0] * _e2667);
                                                            let _e2671 = (_e2643[1] * _e2667);
                                                            let _e2673 = (_e2643[2] * _e2667);
                                                            let _e2678 = (((_e2669 * _e2669) + (_e2671 * _e2671)) + (_e2673 * _e2673));
                                                            if (_e2678 <= 2.2250738585072014e-308lf) {
                                                                if (_e2678 > 0.0lf) {
                                                                    phi_6785_ = (1.464336215552873e-154lf * 2.0lf);
                                                                } else {
                                                                    phi_6785_ = 0.0lf;
                                                                }
                                                                let _e2730 = phi_6785_;
                                                                phi_6849_ = _e2730;
                                                            } else {
                                                                phi_6792_ = type_16(0i, 5i);
                                                                phi_6795_ = bitcast<f64>(((bitcast<u64>(_e2678) / 2lu) + 2303426169912950784lu));
                                                                loop {
                                                                    let _e2685 = phi_6792_;
                                                                    let _e2687 = phi_6795_;
                                                                    local_18 = _e2687;
                                                                    if (_e2685.member < _e2685.member_1) {
                                                                        let _e2694 = (_e2685.member + 1i);
                                                                        if ((false == (_e2694 > _e2685.member)) != false) {
                                                                            phi_6816_ = true;
                                                                        } else {
                                                                            phi_6816_ = false;
                                                                        }
                                                                        let _e2699 = phi_6816_;
                                                                        if _e2699 {
                                                                            phi_6822_ = type_17(0u, type_17().member_1);
                                                                        } else {
                                                                            phi_6822_ = type_17(1u, _e2694);
                                                                        }
                                                                        let _e2704 = phi_6822_;
                                                                        phi_6793_ = type_16(_e2704.member_1, _e2685.member_1);
                                                                        phi_6836_ = type_17(1u, _e2685.member);
                                                                    } else {
                                                                        phi_6793_ = _e2685;
                                                                        phi_6836_ = type_17(0u, type_17().member_1);
                                                                    }
                                                                    let _e2710 = phi_6793_;
                                                                    let _e2712 = phi_6836_;
                                                                    let _e2715 = (bitcast<i32>(_e2712.member) != 0i);
                                                                    if _e2715 {
                                                                        phi_6796_ = (0.5lf * (_e2687 + (_e2678 / _e2687)));
                                                                    } else {
                                                                        phi_6796_ = f64();
                                                                    }
                                                                    let _e2720 = phi_6796_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_6792_ = _e2710;
                                                                        phi_6795_ = _e2720;
                                                                        break if !(_e2715);
                                                                    }
                                                                }
                                                                let _e2725 = local_18;
                                                                phi_6849_ = (_e2725 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                            }
                                                            let _e2732 = phi_6849_;
                                                            let _e2734 = (1.1102230246251565e-16lf * f64(12f));
                                                            let _e2741 = ((((((((_e2400 + _e2402) + (_e2454 + _e2456)) + (_e2508 + _e2510)) * (1.1102230246251565e-16lf * f64(16f))) + (_e2518 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((f64(0f) * _e2732) * (f64(1f) + _e2734)));
                                                            let _e2746 = (((_e2669 * _e2298[0]) + (_e2671 * _e2298[1])) + (_e2673 * _e2298[2]));
                                                            let _e2751 = (((_e2669 * _e2314) + (_e2671 * _e2315)) + (_e2673 * _e2316));
                                                            let _e2756 = (((_e2669 * (_e2298[0] - _e2310[0])) + (_e2671 * (_e2298[1] - _e2310[1]))) + (_e2673 * (_e2298[2] - _e2310[2])));
                                                            let _e2761 = (((_e2669 * (_e2314 - _e2310[0])) + (_e2671 * (_e2315 - _e2310[1]))) + (_e2673 * (_e2316 - _e2310[2])));
                                                            let _e2767 = (((_e2669 * _e2325[0]) + (_e2671 * _e2325[1])) + (_e2673 * _e2325[2]));
                                                            let _e2772 = (((_e2669 * _e2341) + (_e2671 * _e2342)) + (_e2673 * _e2343));
                                                            let _e2777 = (((_e2669 * (_e2325[0] - _e2337[0])) + (_e2671 * (_e2325[1] - _e2337[1]))) + (_e2673 * (_e2325[2] - _e2337[2])));
                                                            let _e2782 = (((_e2669 * (_e2341 - _e2337[0])) + (_e2671 * (_e2342 - _e2337[1]))) + (_e2673 * (_e2343 - _e2337[2])));
                                                            if (_e2746 < 0.0lf) {
                                                                phi_6918_ = -(_e2746);
                                                            } else {
                                                                phi_6918_ = _e2746;
                                                            }
                                                            let _e2787 = phi_6918_;
                                                            if (_e2767 < 0.0lf) {
                                                                phi_6924_ = -(_e2767);
                                                            } else {
                                                                phi_6924_ = _e2767;
                                                            }
                                                            let _e2791 = phi_6924_;
                                                            if (_e2751 < 0.0lf) {
                                                                phi_6933_ = -(_e2751);
                                                            } else {
                                                                phi_6933_ = _e2751;
                                                            }
                                                            let _e2798 = phi_6933_;
                                                            if (_e2772 < 0.0lf) {
                                                                phi_6939_ = -(_e2772);
                                                            } else {
                                                                phi_6939_ = _e2772;
                                                            }
                                                            let _e2802 = phi_6939_;
                                                            if (_e2756 < 0.0lf) {
                                                                phi_6948_ = -(_e2756);
                                                            } else {
                                                                phi_6948_ = _e2756;
                                                            }
                                                            let _e2809 = phi_6948_;
                                                            if (_e2777 < 0.0lf) {
                                                                phi_6954_ = -(_e2777);
                                                            } else {
                                                                phi_6954_ = _e2777;
                                                            }
                                                            let _e2813 = phi_6954_;
                                                            if (_e2761 < 0.0lf) {
                                                                phi_6963_ = -(_e2761);
                                                            } else {
                                                                phi_6963_ = _e2761;
                                                            }
                                                            let _e2820 = phi_6963_;
                                                            if (_e2782 < 0.0lf) {
                                                                phi_6969_ = -(_e2782);
                                                            } else {
                                                                phi_6969_ = _e2782;
                                                            }
                                                            let _e2824 = phi_6969_;
                                                            phi_6975_ = type_34(array<f64, 4>(_e2746, _e2751, _e2756, _e2761), array<f64, 4>(_e2767, _e2772, _e2777, _e2782), array<f64, 4>((_e2741 + ((_e2787 + _e2791) * _e2734)), (_e2741 + ((_e2798 + _e2802) * _e2734)), (_e2741 + ((_e2809 + _e2813) * _e2734)), (_e2741 + ((_e2820 + _e2824) * _e2734))));
                                                            phi_6976_ = false;
                                                        } else {
                                                            phi_6975_ = type_34();
                                                            phi_6976_ = true;
                                                        }
                                                        let _e2831 = phi_6975_;
                                                        let _e2833 = phi_6976_;
                                                        phi_6977_ = _e2831;
                                                        phi_6978_ = _e2833;
                                                    } else {
                                                        phi_6977_ = type_34();
                                                        phi_6978_ = true;
                                                    }
                                                    let _e2835 = phi_6977_;
                                                    let _e2837 = phi_6978_;
                                                    if _e2837 {
                                                        let _e2838 = f64(0f);
                                                        let _e2839 = f64(1f);
                                                        phi_6988_ = type_34(array<f64, 4>(_e2838, _e2838, _e2838, _e2838), array<f64, 4>(_e2838, _e2838, _e2838, _e2838), array<f64, 4>(_e2839, _e2839, _e2839, _e2839));
                                                    } else {
                                                        phi_6988_ = _e2835;
                                                    }
                                                    let _e2845 = phi_6988_;
                                                    local_1 = type_34(array<f64, 4>(_e2845.member[0], _e2845.member[1], _e2845.member[2], _e2845.member[3]), array<f64, 4>(_e2845.member_1[0], _e2845.member_1[1], _e2845.member_1[2], _e2845.member_1[3]), array<f64, 4>(_e2845.member_2[0], _e2845.member_2[1], _e2845.member_2[2], _e2845.member_2[3]));
                                                    let _e2865 = (_e2534 - _e2538);
                                                    let _e2867 = f64(0f);
                                                    let _e2870 = local_1.member[0u];
                                                    let _e2873 = local_1.member_1[0u];
                                                    let _e2876 = local_1.member[0u];
                                                    let _e2882 = local_1.member_2[0u];
                                                    if (((_e2870 + ((_e2873 - _e2876) * _e2534)) - _e2882) > _e2867) {
                                                        let _e2887 = local_1.member[1u];
                                                        let _e2890 = local_1.member_1[1u];
                                                        let _e2893 = local_1.member[1u];
                                                        let _e2899 = local_1.member_2[1u];
                                                        if (((_e2887 + ((_e2890 - _e2893) * _e2534)) - _e2899) > _e2867) {
                                                            let _e2904 = local_1.member[2u];
                                                            let _e2907 = local_1.member_1[2u];
                                                            let _e2910 = local_1.member[2u];
                                                            let _e2916 = local_1.member_2[2u];
                                                            if (((_e2904 + ((_e2907 - _e2910) * _e2534)) - _e2916) > _e2867) {
                                                                let _e2921 = local_1.member[3u];
                                                                let _e2924 = local_1.member_1[3u];
                                                                let _e2927 = local_1.member[3u];
                                                                let _e2933 = local_1.member_2[3u];
                                                                phi_7160_ = (((_e2921 + ((_e2924 - _e2927) * _e2534)) - _e2933) > _e2867);
                                                                phi_7161_ = false;
                                                            } else {
                                                                phi_7160_ = bool();
                                                                phi_7161_ = true;
                                                            }
                                                            let _e2937 = phi_7160_;
                                                            let _e2939 = phi_7161_;
                                                            phi_7162_ = _e2937;
                                                            phi_7163_ = _e2939;
                                                        } else {
                                                            phi_7162_ = bool();
                                                            phi_7163_ = true;
                                                        }
                                                        let _e2941 = phi_7162_;
                                                        let _e2943 = phi_7163_;
                                                        phi_7164_ = _e2941;
                                                        phi_7165_ = _e2943;
                                                    } else {
                                                        phi_7164_ = bool();
                                                        phi_7165_ = true;
                                                    }
                                                    let _e2945 = phi_7164_;
                                                    let _e2947 = phi_7165_;
                                                    if _e2947 {
                                                        phi_7169_ = false;
                                                    } else {
                                                        phi_7169_ = _e2945;
                                                    }
                                                    let _e2949 = phi_7169_;
                                                    if _e2949 {
                                                        if (_e2534 <= _e2536) {
                                                            phi_7480_ = true;
                                                        } else {
                                                            let _e2951 = f64(0f);
                                                            let _e2954 = local.member[0u];
                                                            let _e2957 = local.member_1[0u];
                                                            let _e2960 = local.member[0u];
                                                            let _e2966 = local.member_2[0u];
                                                            let _e2970 = local_1.member[0u];
                                                            let _e2973 = local_1.member_1[0u];
                                                            let _e2976 = local_1.member[0u];
                                                            let _e2982 = local_1.member_2[0u];
                                                            if ((((_e2954 + ((_e2957 - _e2960) * _e2534)) - _e2966) + ((_e2970 + ((_e2973 - _e2976) * _e2538)) - _e2982)) > _e2951) {
                                                                let _e2988 = local.member[1u];
                                                                let _e2991 = local.member_1[1u];
                                                                let _e2994 = local.member[1u];
                                                                let _e3000 = local.member_2[1u];
                                                                let _e3004 = local_1.member[1u];
                                                                let _e3007 = local_1.member_1[1u];
                                                                let _e3010 = local_1.member[1u];
                                                                let _e3016 = local_1.member_2[1u];
                                                                if ((((_e2988 + ((_e2991 - _e2994) * _e2534)) - _e3000) + ((_e3004 + ((_e3007 - _e3010) * _e2538)) - _e3016)) > _e2951) {
                                                                    let _e3022 = local.member[2u];
                                                                    let _e3025 = local.member_1[2u];
                                                                    let _e3028 = local.member[2u];
                                                                    let _e3034 = local.member_2[2u];
                                                                    let _e3038 = local_1.member[2u];
                                                                    let _e3041 = local_1.member_1[2u];
                                                                    let _e3044 = local_1.member[2u];
                                                                    let _e3050 = local_1.member_2[2u];
                                                                    if ((((_e3022 + ((_e3025 - _e3028) * _e2534)) - _e3034) + ((_e3038 + ((_e3041 - _e3044) * _e2538)) - _e3050)) > _e2951) {
                                                                        let _e3056 = local.member[3u];
                                                                        let _e3059 = local.member_1[3u];
                                                                        let _e3062 = local.member[3u];
                                                                        let _e3068 = local.member_2[3u];
                                                                        let _e3072 = local_1.member[3u];
                                                                        let _e3075 = local_1.member_1[3u];
                                                                        let _e3078 = local_1.member[3u];
                                                                        let _e3084 = local_1.member_2[3u];
                                                                        phi_7467_ = ((((_e3056 + ((_e3059 - _e3062) * _e2534)) - _e3068) + ((_e3072 + ((_e3075 - _e3078) * _e2538)) - _e3084)) > _e2951);
                                                                        phi_7468_ = false;
                                                                    } else {
                                                                        phi_7467_ = bool();
                                                                        phi_7468_ = true;
                                                                    }
                                                                    let _e3089 = phi_7467_;
                                                                    let _e3091 = phi_7468_;
                                                                    phi_7469_ = _e3089;
                                                                    phi_7470_ = _e3091;
                                                                } else {
                                                                    phi_7469_ = bool();
                                                                    phi_7470_ = true;
                                                                }
                                                                let _e3093 = phi_7469_;
                                                                let _e3095 = phi_7470_;
                                                                phi_7471_ = _e3093;
                                                                phi_7472_ = _e3095;
                                                            } else {
                                                                phi_7471_ = bool();
                                                                phi_7472_ = true;
                                                            }
                                                            let _e3097 = phi_7471_;
                                                            let _e3099 = phi_7472_;
                                                            if _e3099 {
                                                                phi_7476_ = false;
                                                            } else {
                                                                phi_7476_ = _e3097;
                                                            }
                                                            let _e3101 = phi_7476_;
                                                            phi_7480_ = _e3101;
                                                        }
                                                        let _e3103 = phi_7480_;
                                                        if _e3103 {
                                                            if _e2540 {
                                                                if (_e2534 >= _e1554.member_1) {
                                                                    phi_7491_ = false;
                                                                } else {
                                                                    phi_7491_ = true;
                                                                }
                                                                let _e3106 = phi_7491_;
                                                                phi_7492_ = _e3106;
                                                            } else {
                                                                phi_7492_ = true;
                                                            }
                                                            let _e3108 = phi_7492_;
                                                            if _e3108 {
                                                                local = type_34(array<f64, 4>(_e2845.member[0], _e2845.member[1], _e2845.member[2], _e2845.member[3]), array<f64, 4>(_e2845.member_1[0], _e2845.member_1[1], _e2845.member_1[2], _e2845.member_1[3]), array<f64, 4>(_e2845.member_2[0], _e2845.member_2[1], _e2845.member_2[2], _e2845.member_2[3]));
                                                                let _e3130 = local.member[0u];
                                                                let _e3133 = local.member_1[0u];
                                                                let _e3136 = local.member_2[0u];
                                                                if (_e3130 > _e3136) {
                                                                    if (_e3133 > _e3136) {
                                                                        phi_7566_ = false;
                                                                    } else {
                                                                        phi_7566_ = true;
                                                                    }
                                                                    let _e3140 = phi_7566_;
                                                                    phi_7567_ = _e3140;
                                                                } else {
                                                                    phi_7567_ = true;
                                                                }
                                                                let _e3142 = phi_7567_;
                                                                if _e3142 {
                                                                    let _e3143 = (_e3133 >= _e3130);
                                                                    if _e3143 {
                                                                        phi_7592_ = f64();
                                                                        phi_7593_ = false;
                                                                    } else {
                                                                        if ((_e3130 - _e3133) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7590_ = (((_e3130 - _e3136) / (_e3130 - _e3133)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7591_ = false;
                                                                        } else {
                                                                            phi_7590_ = f64();
                                                                            phi_7591_ = true;
                                                                        }
                                                                        let _e3157 = phi_7590_;
                                                                        let _e3159 = phi_7591_;
                                                                        phi_7592_ = _e3157;
                                                                        phi_7593_ = _e3159;
                                                                    }
                                                                    let _e3161 = phi_7592_;
                                                                    let _e3163 = phi_7593_;
                                                                    phi_7594_ = _e3161;
                                                                    phi_7595_ = _e3143;
                                                                    phi_7596_ = _e3163;
                                                                } else {
                                                                    phi_7594_ = f64();
                                                                    phi_7595_ = true;
                                                                    phi_7596_ = false;
                                                                }
                                                                let _e3165 = phi_7594_;
                                                                let _e3167 = phi_7595_;
                                                                let _e3169 = phi_7596_;
                                                                if _e3167 {
                                                                    phi_7601_ = f64(2f);
                                                                    phi_7602_ = true;
                                                                } else {
                                                                    phi_7601_ = _e2534;
                                                                    phi_7602_ = _e3169;
                                                                }
                                                                let _e3172 = phi_7601_;
                                                                let _e3174 = phi_7602_;
                                                                if _e3174 {
                                                                    phi_7606_ = _e3172;
                                                                } else {
                                                                    phi_7606_ = _e3165;
                                                                }
                                                                let _e3176 = phi_7606_;
                                                                let _e3179 = local.member[1u];
                                                                let _e3182 = local.member_1[1u];
                                                                let _e3185 = local.member_2[1u];
                                                                if (_e3179 > _e3185) {
                                                                    if (_e3182 > _e3185) {
                                                                        phi_7638_ = false;
                                                                    } else {
                                                                        phi_7638_ = true;
                                                                    }
                                                                    let _e3189 = phi_7638_;
                                                                    phi_7639_ = _e3189;
                                                                } else {
                                                                    phi_7639_ = true;
                                                                }
                                                                let _e3191 = phi_7639_;
                                                                if _e3191 {
                                                                    let _e3192 = (_e3182 >= _e3179);
                                                                    if _e3192 {
                                                                        phi_7664_ = f64();
                                                                        phi_7665_ = false;
                                                                    } else {
                                                                        if ((_e3179 - _e3182) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7662_ = (((_e3179 - _e3185) / (_e3179 - _e3182)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7663_ = false;
                                                                        } else {
                                                                            phi_7662_ = f64();
                                                                            phi_7663_ = true;
                                                                        }
                                                                        let _e3206 = phi_7662_;
                                                                        let _e3208 = phi_7663_;
                                                                        phi_7664_ = _e3206;
                                                                        phi_7665_ = _e3208;
                                                                    }
                                                                    let _e3210 = phi_7664_;
                                                                    let _e3212 = phi_7665_;
                                                                    phi_7666_ = _e3210;
                                                                    phi_7667_ = _e3192;
                                                                    phi_7668_ = _e3212;
                                                                } else {
                                                                    phi_7666_ = f64();
                                                                    phi_7667_ = true;
                                                                    phi_7668_ = false;
                                                                }
                                                                let _e3214 = phi_7666_;
                                                                let _e3216 = phi_7667_;
                                                                let _e3218 = phi_7668_;
                                                                if _e3216 {
                                                                    phi_7673_ = f64(2f);
                                                                    phi_7674_ = true;
                                                                } else {
                                                                    phi_7673_ = _e2534;
                                                                    phi_7674_ = _e3218;
                                                                }
                                                                let _e3221 = phi_7673_;
                                                                let _e3223 = phi_7674_;
                                                                if _e3223 {
                                                                    phi_7678_ = _e3221;
                                                                } else {
                                                                    phi_7678_ = _e3214;
                                                                }
                                                                let _e3225 = phi_7678_;
                                                                if (_e3176 < _e3225) {
                                                                    phi_7683_ = _e3176;
                                                                } else {
                                                                    phi_7683_ = _e3225;
                                                                }
                                                                let _e3228 = phi_7683_;
                                                                let _e3231 = local.member[2u];
                                                                let _e3234 = local.member_1[2u];
                                                                let _e3237 = local.member_2[2u];
                                                                if (_e3231 > _e3237) {
                                                                    if (_e3234 > _e3237) {
                                                                        phi_7715_ = false;
                                                                    } else {
                                                                        phi_7715_ = true;
                                                                    }
                                                                    let _e3241 = phi_7715_;
                                                                    phi_7716_ = _e3241;
                                                                } else {
                                                                    phi_7716_ = true;
                                                                }
                                                                let _e3243 = phi_7716_;
                                                                if _e3243 {
                                                                    let _e3244 = (_e3234 >= _e3231);
                                                                    if _e3244 {
                                                                        phi_7741_ = f64();
                                                                        phi_7742_ = false;
                                                                    } else {
                                                                        if ((_e3231 - _e3234) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7739_ = (((_e3231 - _e3237) / (_e3231 - _e3234)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7740_ = false;
                                                                        } else {
                                                                            phi_7739_ = f64();
                                                                            phi_7740_ = true;
                                                                        }
                                                                        let _e3258 = phi_7739_;
                                                                        let _e3260 = phi_7740_;
                                                                        phi_7741_ = _e3258;
                                                                        phi_7742_ = _e3260;
                                                                    }
                                                                    let _e3262 = phi_7741_;
                                                                    let _e3264 = phi_7742_;
                                                                    phi_7743_ = _e3262;
                                                                    phi_7744_ = _e3244;
                                                                    phi_7745_ = _e3264;
                                                                } else {
                                                                    phi_7743_ = f64();
                                                                    phi_7744_ = true;
                                                                    phi_7745_ = false;
                                                                }
                                                                let _e3266 = phi_7743_;
                                                                let _e3268 = phi_7744_;
                                                                let _e3270 = phi_7745_;
                                                                if _e3268 {
                                                                    phi_7750_ = f64(2f);
                                                                    phi_7751_ = true;
                                                                } else {
                                                                    phi_7750_ = _e2534;
                                                                    phi_7751_ = _e3270;
                                                                }
                                                                let _e3273 = phi_7750_;
                                                                let _e3275 = phi_7751_;
                                                                if _e3275 {
                                                                    phi_7755_ = _e3273;
                                                                } else {
                                                                    phi_7755_ = _e3266;
                                                                }
                                                                let _e3277 = phi_7755_;
                                                                let _e3280 = local.member[3u];
                                                                let _e3283 = local.member_1[3u];
                                                                let _e3286 = local.member_2[3u];
                                                                if (_e3280 > _e3286) {
                                                                    if (_e3283 > _e3286) {
                                                                        phi_7787_ = false;
                                                                    } else {
                                                                        phi_7787_ = true;
                                                                    }
                                                                    let _e3290 = phi_7787_;
                                                                    phi_7788_ = _e3290;
                                                                } else {
                                                                    phi_7788_ = true;
                                                                }
                                                                let _e3292 = phi_7788_;
                                                                if _e3292 {
                                                                    let _e3293 = (_e3283 >= _e3280);
                                                                    if _e3293 {
                                                                        phi_7813_ = f64();
                                                                        phi_7814_ = false;
                                                                    } else {
                                                                        if ((_e3280 - _e3283) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                            phi_7811_ = (((_e3280 - _e3286) / (_e3280 - _e3283)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                            phi_7812_ = false;
                                                                        } else {
                                                                            phi_7811_ = f64();
                                                                            phi_7812_ = true;
                                                                        }
                                                                        let _e3307 = phi_7811_;
                                                                        let _e3309 = phi_7812_;
                                                                        phi_7813_ = _e3307;
                                                                        phi_7814_ = _e3309;
                                                                    }
                                                                    let _e3311 = phi_7813_;
                                                                    let _e3313 = phi_7814_;
                                                                    phi_7815_ = _e3311;
                                                                    phi_7816_ = _e3293;
                                                                    phi_7817_ = _e3313;
                                                                } else {
                                                                    phi_7815_ = f64();
                                                                    phi_7816_ = true;
                                                                    phi_7817_ = false;
                                                                }
                                                                let _e3315 = phi_7815_;
                                                                let _e3317 = phi_7816_;
                                                                let _e3319 = phi_7817_;
                                                                if _e3317 {
                                                                    phi_7822_ = f64(2f);
                                                                    phi_7823_ = true;
                                                                } else {
                                                                    phi_7822_ = _e2534;
                                                                    phi_7823_ = _e3319;
                                                                }
                                                                let _e3322 = phi_7822_;
                                                                let _e3324 = phi_7823_;
                                                                if _e3324 {
                                                                    phi_7827_ = _e3322;
                                                                } else {
                                                                    phi_7827_ = _e3315;
                                                                }
                                                                let _e3326 = phi_7827_;
                                                                if (_e3277 < _e3326) {
                                                                    phi_7832_ = _e3277;
                                                                } else {
                                                                    phi_7832_ = _e3326;
                                                                }
                                                                let _e3329 = phi_7832_;
                                                                if (_e3228 < _e3329) {
                                                                    phi_7837_ = _e3228;
                                                                } else {
                                                                    phi_7837_ = _e3329;
                                                                }
                                                                let _e3332 = phi_7837_;
                                                                if (_e3332 > _e2534) {
                                                                    phi_7842_ = _e3332;
                                                                } else {
                                                                    phi_7842_ = _e2534;
                                                                }
                                                                let _e3335 = phi_7842_;
                                                                let _e3336 = (_e3335 > _e1554.member_1);
                                                                if _e3336 {
                                                                    phi_7853_ = f64();
                                                                    phi_7854_ = false;
                                                                } else {
                                                                    if _e2540 {
                                                                        phi_7852_ = (_e2865 + _e2865);
                                                                    } else {
                                                                        phi_7852_ = (_e1554.member_1 - _e2534);
                                                                    }
                                                                    let _e3340 = phi_7852_;
                                                                    phi_7853_ = _e3340;
                                                                    phi_7854_ = true;
                                                                }
                                                                let _e3342 = phi_7853_;
                                                                let _e3344 = phi_7854_;
                                                                phi_7855_ = _e3335;
                                                                phi_7856_ = _e3342;
                                                                phi_7857_ = _e3344;
                                                                phi_7858_ = _e3336;
                                                                phi_7859_ = false;
                                                            } else {
                                                                phi_7855_ = f64();
                                                                phi_7856_ = f64();
                                                                phi_7857_ = false;
                                                                phi_7858_ = false;
                                                                phi_7859_ = true;
                                                            }
                                                            let _e3346 = phi_7855_;
                                                            let _e3348 = phi_7856_;
                                                            let _e3350 = phi_7857_;
                                                            let _e3352 = phi_7858_;
                                                            let _e3354 = phi_7859_;
                                                            phi_7860_ = _e3346;
                                                            phi_7861_ = _e3348;
                                                            phi_7862_ = false;
                                                            phi_7863_ = _e3350;
                                                            phi_7864_ = _e3352;
                                                            phi_7865_ = _e3354;
                                                        } else {
                                                            phi_7860_ = f64();
                                                            phi_7861_ = f64();
                                                            phi_7862_ = true;
                                                            phi_7863_ = false;
                                                            phi_7864_ = false;
                                                            phi_7865_ = false;
                                                        }
                                                        let _e3356 = phi_7860_;
                                                        let _e3358 = phi_7861_;
                                                        let _e3360 = phi_7862_;
                                                        let _e3362 = phi_7863_;
                                                        let _e3364 = phi_7864_;
                                                        let _e3366 = phi_7865_;
                                                        phi_7866_ = _e3356;
                                                        phi_7867_ = _e3358;
                                                        phi_7868_ = _e3360;
                                                        phi_7869_ = _e3362;
                                                        phi_7870_ = _e3364;
                                                        phi_7871_ = _e3366;
                                                    } else {
                                                        phi_7866_ = f64();
                                                        phi_7867_ = f64();
                                                        phi_7868_ = true;
                                                        phi_7869_ = false;
                                                        phi_7870_ = false;
                                                        phi_7871_ = false;
                                                    }
                                                    let _e3368 = phi_7866_;
                                                    let _e3370 = phi_7867_;
                                                    let _e3372 = phi_7868_;
                                                    let _e3374 = phi_7869_;
                                                    let _e3376 = phi_7870_;
                                                    let _e3378 = phi_7871_;
                                                    if _e3372 {
                                                        if (_e2534 <= _e2536) {
                                                            let _e3544 = (_e2542 + 1u);
                                                            let _e3545 = (_e3544 > 3u);
                                                            if _e3545 {
                                                                phi_7884_ = false;
                                                            } else {
                                                                phi_7884_ = true;
                                                            }
                                                            let _e3547 = phi_7884_;
                                                            phi_8211_ = _e3544;
                                                            phi_8212_ = f64();
                                                            phi_8213_ = false;
                                                            phi_8214_ = _e3547;
                                                            phi_8215_ = _e3545;
                                                        } else {
                                                            let _e3382 = local.member[0u];
                                                            let _e3385 = local.member_1[0u];
                                                            let _e3388 = local.member[0u];
                                                            let _e3394 = local.member_2[0u];
                                                            let _e3395 = ((_e3382 + ((_e3385 - _e3388) * _e2538)) - _e3394);
                                                            let _e3398 = local.member[1u];
                                                            let _e3401 = local.member_1[1u];
                                                            let _e3404 = local.member[1u];
                                                            let _e3410 = local.member_2[1u];
                                                            let _e3411 = ((_e3398 + ((_e3401 - _e3404) * _e2538)) - _e3410);
                                                            if (_e3395 < _e3411) {
                                                                phi_7957_ = _e3395;
                                                            } else {
                                                                phi_7957_ = _e3411;
                                                            }
                                                            let _e3414 = phi_7957_;
                                                            let _e3417 = local.member[2u];
                                                            let _e3420 = local.member_1[2u];
                                                            let _e3423 = local.member[2u];
                                                            let _e3429 = local.member_2[2u];
                                                            let _e3430 = ((_e3417 + ((_e3420 - _e3423) * _e2538)) - _e3429);
                                                            let _e3433 = local.member[3u];
                                                            let _e3436 = local.member_1[3u];
                                                            let _e3439 = local.member[3u];
                                                            let _e3445 = local.member_2[3u];
                                                            let _e3446 = ((_e3433 + ((_e3436 - _e3439) * _e2538)) - _e3445);
                                                            if (_e3430 < _e3446) {
                                                                phi_8030_ = _e3430;
                                                            } else {
                                                                phi_8030_ = _e3446;
                                                            }
                                                            let _e3449 = phi_8030_;
                                                            if (_e3414 < _e3449) {
                                                                phi_8035_ = _e3414;
                                                            } else {
                                                                phi_8035_ = _e3449;
                                                            }
                                                            let _e3452 = phi_8035_;
                                                            let _e3455 = local_1.member[0u];
                                                            let _e3458 = local_1.member_1[0u];
                                                            let _e3461 = local_1.member[0u];
                                                            let _e3467 = local_1.member_2[0u];
                                                            let _e3468 = ((_e3455 + ((_e3458 - _e3461) * _e2534)) - _e3467);
                                                            let _e3471 = local_1.member[1u];
                                                            let _e3474 = local_1.member_1[1u];
                                                            let _e3477 = local_1.member[1u];
                                                            let _e3483 = local_1.member_2[1u];
                                                            let _e3484 = ((_e3471 + ((_e3474 - _e3477) * _e2534)) - _e3483);
                                                            if (_e3468 < _e3484) {
                                                                phi_8108_ = _e3468;
                                                            } else {
                                                                phi_8108_ = _e3484;
                                                            }
                                                            let _e3487 = phi_8108_;
                                                            let _e3490 = local_1.member[2u];
                                                            let _e3493 = local_1.member_1[2u];
                                                            let _e3496 = local_1.member[2u];
                                                            let _e3502 = local_1.member_2[2u];
                                                            let _e3503 = ((_e3490 + ((_e3493 - _e3496) * _e2534)) - _e3502);
                                                            let _e3506 = local_1.member[3u];
                                                            let _e3509 = local_1.member_1[3u];
                                                            let _e3512 = local_1.member[3u];
                                                            let _e3518 = local_1.member_2[3u];
                                                            let _e3519 = ((_e3506 + ((_e3509 - _e3512) * _e2534)) - _e3518);
                                                            if (_e3503 < _e3519) {
                                                                phi_8181_ = _e3503;
                                                            } else {
                                                                phi_8181_ = _e3519;
                                                            }
                                                            let _e3522 = phi_8181_;
                                                            if (_e3487 < _e3522) {
                                                                phi_8186_ = _e3487;
                                                            } else {
                                                                phi_8186_ = _e3522;
                                                            }
                                                            let _e3525 = phi_8186_;
                                                            let _e3526 = f64(0.0625f);
                                                            let _e3528 = f64(0.9f);
                                                            if (_e3525 > f64(0f)) {
                                                                phi_8209_ = f64(0.5f);
                                                            } else {
                                                                let _e3534 = (f64(0.95f) * (_e3452 / (_e3452 - _e3525)));
                                                                if (_e3534 > _e3526) {
                                                                    if (_e3534 < _e3528) {
                                                                        phi_8207_ = _e3534;
                                                                    } else {
                                                                        phi_8207_ = _e3528;
                                                                    }
                                                                    let _e3538 = phi_8207_;
                                                                    phi_8208_ = _e3538;
                                                                } else {
                                                                    phi_8208_ = _e3526;
                                                                }
                                                                let _e3540 = phi_8208_;
                                                                phi_8209_ = _e3540;
                                                            }
                                                            let _e3542 = phi_8209_;
                                                            phi_8211_ = u32();
                                                            phi_8212_ = (_e2865 * _e3542);
                                                            phi_8213_ = true;
                                                            phi_8214_ = false;
                                                            phi_8215_ = false;
                                                        }
                                                        let _e3549 = phi_8211_;
                                                        let _e3551 = phi_8212_;
                                                        let _e3553 = phi_8213_;
                                                        let _e3555 = phi_8214_;
                                                        let _e3557 = phi_8215_;
                                                        phi_8216_ = _e3549;
                                                        phi_8217_ = _e2536;
                                                        phi_8218_ = _e3551;
                                                        phi_8219_ = _e2538;
                                                        phi_8220_ = _e2540;
                                                        phi_8221_ = _e2542;
                                                        phi_8222_ = _e3553;
                                                        phi_8223_ = _e3555;
                                                        phi_8224_ = _e3557;
                                                        phi_8225_ = false;
                                                        phi_8226_ = false;
                                                    } else {
                                                        phi_8216_ = u32();
                                                        phi_8217_ = _e3368;
                                                        phi_8218_ = _e3370;
                                                        phi_8219_ = _e2534;
                                                        phi_8220_ = true;
                                                        phi_8221_ = 0u;
                                                        phi_8222_ = _e3374;
                                                        phi_8223_ = false;
                                                        phi_8224_ = false;
                                                        phi_8225_ = _e3376;
                                                        phi_8226_ = _e3378;
                                                    }
                                                    let _e3559 = phi_8216_;
                                                    let _e3561 = phi_8217_;
                                                    let _e3563 = phi_8218_;
                                                    let _e3565 = phi_8219_;
                                                    let _e3567 = phi_8220_;
                                                    let _e3569 = phi_8221_;
                                                    let _e3571 = phi_8222_;
                                                    let _e3573 = phi_8223_;
                                                    let _e3575 = phi_8224_;
                                                    let _e3577 = phi_8225_;
                                                    let _e3579 = phi_8226_;
                                                    if _e3571 {
                                                        let _e3580 = (_e3565 + _e3563);
                                                        if (_e3580 > _e3561) {
                                                            phi_8235_ = _e3580;
                                                        } else {
                                                            phi_8235_ = _e3561;
                                                        }
                                                        let _e3583 = phi_8235_;
                                                        if (_e3583 < _e1554.member_1) {
                                                            phi_8240_ = _e3583;
                                                        } else {
                                                            phi_8240_ = _e1554.member_1;
                                                        }
                                                        let _e3586 = phi_8240_;
                                                        if !(_e2540) {
                                                            phi_8250_ = true;
                                                        } else {
                                                            phi_8250_ = ((_e3586 - _e3565) > f64(0.0000000037252903f));
                                                        }
                                                        let _e3591 = phi_8250_;
                                                        if _e3591 {
                                                            phi_8254_ = false;
                                                        } else {
                                                            phi_8254_ = true;
                                                        }
                                                        let _e3593 = phi_8254_;
                                                        phi_8255_ = _e3586;
                                                        phi_8256_ = _e3561;
                                                        phi_8257_ = _e3565;
                                                        phi_8258_ = _e3567;
                                                        phi_8259_ = _e3569;
                                                        phi_8260_ = _e3591;
                                                        phi_8261_ = _e3593;
                                                        phi_8262_ = false;
                                                        phi_8263_ = false;
                                                        phi_8264_ = false;
                                                    } else {
                                                        phi_8255_ = _e2534;
                                                        phi_8256_ = _e2536;
                                                        phi_8257_ = _e2538;
                                                        phi_8258_ = _e2540;
                                                        phi_8259_ = _e3559;
                                                        phi_8260_ = _e3573;
                                                        phi_8261_ = false;
                                                        phi_8262_ = _e3575;
                                                        phi_8263_ = _e3577;
                                                        phi_8264_ = _e3579;
                                                    }
                                                    let _e3595 = phi_8255_;
                                                    let _e3597 = phi_8256_;
                                                    let _e3599 = phi_8257_;
                                                    let _e3601 = phi_8258_;
                                                    let _e3603 = phi_8259_;
                                                    let _e3605 = phi_8260_;
                                                    let _e3607 = phi_8261_;
                                                    let _e3609 = phi_8262_;
                                                    let _e3611 = phi_8263_;
                                                    let _e3613 = phi_8264_;
                                                    phi_6565_ = _e3595;
                                                    phi_6567_ = _e3597;
                                                    phi_6569_ = _e3599;
                                                    phi_6571_ = _e3601;
                                                    phi_6573_ = _e3603;
                                                    phi_8265_ = _e3561;
                                                    phi_8266_ = _e3605;
                                                    phi_8267_ = _e3607;
                                                    phi_8268_ = false;
                                                    phi_8269_ = _e3609;
                                                    phi_8270_ = _e3611;
                                                    phi_8271_ = _e3613;
                                                } else {
                                                    phi_6565_ = f64();
                                                    phi_6567_ = f64();
                                                    phi_6569_ = f64();
                                                    phi_6571_ = bool();
                                                    phi_6573_ = u32();
                                                    phi_8265_ = f64();
                                                    phi_8266_ = false;
                                                    phi_8267_ = false;
                                                    phi_8268_ = true;
                                                    phi_8269_ = false;
                                                    phi_8270_ = false;
                                                    phi_8271_ = false;
                                                }
                                                let _e3615 = phi_6565_;
                                                let _e3617 = phi_6567_;
                                                let _e3619 = phi_6569_;
                                                let _e3621 = phi_6571_;
                                                let _e3623 = phi_6573_;
                                                let _e3625 = phi_8265_;
                                                let _e3627 = phi_8266_;
                                                let _e3629 = phi_8267_;
                                                let _e3631 = phi_8268_;
                                                let _e3633 = phi_8269_;
                                                let _e3635 = phi_8270_;
                                                let _e3637 = phi_8271_;
                                                local_19 = _e3629;
                                                local_35 = _e3625;
                                                local_37 = _e3631;
                                                local_38 = _e3633;
                                                local_39 = _e3635;
                                                local_40 = _e3637;
                                                continue;
                                                continuing {
                                                    phi_6561_ = _e2554;
                                                    phi_6564_ = _e3615;
                                                    phi_6566_ = _e3617;
                                                    phi_6568_ = _e3619;
                                                    phi_6570_ = _e3621;
                                                    phi_6572_ = _e3623;
                                                    break if !(_e3627);
                                                }
                                            }
                                            let _e3640 = local_19;
                                            if _e3640 {
                                                let _e6151 = local_35;
                                                phi_8275_ = _e6151;
                                                phi_8276_ = true;
                                                phi_8277_ = false;
                                                phi_8278_ = false;
                                                phi_8279_ = false;
                                            } else {
                                                let _e6153 = local_36;
                                                phi_8275_ = _e6153;
                                                let _e6156 = local_37;
                                                phi_8276_ = _e6156;
                                                let _e6159 = local_38;
                                                phi_8277_ = _e6159;
                                                let _e6162 = local_39;
                                                phi_8278_ = _e6162;
                                                let _e6165 = local_40;
                                                phi_8279_ = _e6165;
                                            }
                                            let _e3642 = phi_8275_;
                                            let _e3644 = phi_8276_;
                                            let _e3646 = phi_8277_;
                                            let _e3648 = phi_8278_;
                                            let _e3650 = phi_8279_;
                                            if _e3644 {
                                                phi_8284_ = type_44(1u, _e3642);
                                                phi_8285_ = false;
                                                phi_8286_ = false;
                                                phi_8287_ = false;
                                            } else {
                                                phi_8284_ = type_44();
                                                phi_8285_ = _e3646;
                                                phi_8286_ = _e3648;
                                                phi_8287_ = _e3650;
                                            }
                                            let _e3653 = phi_8284_;
                                            let _e3655 = phi_8285_;
                                            let _e3657 = phi_8286_;
                                            let _e3659 = phi_8287_;
                                            if _e3655 {
                                                let _e3661 = local_20;
                                                phi_8292_ = type_44(1u, _e3661);
                                                phi_8293_ = false;
                                                phi_8294_ = false;
                                            } else {
                                                phi_8292_ = type_44();
                                                phi_8293_ = _e3657;
                                                phi_8294_ = _e3659;
                                            }
                                            let _e3664 = phi_8292_;
                                            let _e3666 = phi_8293_;
                                            let _e3668 = phi_8294_;
                                            if _e3666 {
                                                phi_8299_ = type_44(0u, type_44().member_1);
                                                phi_8300_ = false;
                                                phi_8301_ = true;
                                            } else {
                                                phi_8299_ = _e3664;
                                                phi_8300_ = _e3668;
                                                phi_8301_ = _e3655;
                                            }
                                            let _e3672 = phi_8299_;
                                            let _e3674 = phi_8300_;
                                            let _e3676 = phi_8301_;
                                            if _e3674 {
                                                phi_8306_ = type_44(0u, type_44().member_1);
                                                phi_8307_ = true;
                                            } else {
                                                phi_8306_ = _e3672;
                                                phi_8307_ = _e3676;
                                            }
                                            let _e3680 = phi_8306_;
                                            let _e3682 = phi_8307_;
                                            if _e3682 {
                                                phi_8311_ = _e3680;
                                            } else {
                                                phi_8311_ = _e3653;
                                            }
                                            let _e3684 = phi_8311_;
                                            let _e3687 = (_e3684.member != 0u);
                                            if _e3687 {
                                                phi_8318_ = false;
                                            } else {
                                                phi_8318_ = true;
                                            }
                                            let _e3689 = phi_8318_;
                                            phi_8319_ = _e3684.member_1;
                                            phi_8320_ = _e3689;
                                            phi_8321_ = _e3687;
                                            phi_8322_ = false;
                                        } else {
                                            phi_8319_ = f64();
                                            phi_8320_ = false;
                                            phi_8321_ = false;
                                            phi_8322_ = true;
                                        }
                                        let _e3691 = phi_8319_;
                                        let _e3693 = phi_8320_;
                                        let _e3695 = phi_8321_;
                                        let _e3697 = phi_8322_;
                                        phi_8323_ = _e3691;
                                        phi_8324_ = _e3693;
                                        phi_8325_ = _e3695;
                                        phi_8326_ = _e3697;
                                    }
                                    let _e3699 = phi_8323_;
                                    let _e3701 = phi_8324_;
                                    let _e3703 = phi_8325_;
                                    let _e3705 = phi_8326_;
                                    phi_8327_ = _e3699;
                                    phi_8328_ = _e2279;
                                    phi_8329_ = _e3701;
                                    phi_8330_ = _e3703;
                                    phi_8331_ = _e3705;
                                }
                                let _e3707 = phi_8327_;
                                let _e3709 = phi_8328_;
                                let _e3711 = phi_8329_;
                                let _e3713 = phi_8330_;
                                let _e3715 = phi_8331_;
                                if _e3709 {
                                    phi_8335_ = true;
                                    phi_8336_ = false;
                                    phi_8337_ = false;
                                } else {
                                    phi_8335_ = _e3711;
                                    phi_8336_ = _e3713;
                                    phi_8337_ = _e3715;
                                }
                                let _e3717 = phi_8335_;
                                let _e3719 = phi_8336_;
                                let _e3721 = phi_8337_;
                                phi_8338_ = _e3707;
                                phi_8339_ = _e1554;
                                phi_8340_ = _e3717;
                                phi_8341_ = false;
                                phi_8342_ = _e3719;
                                phi_8343_ = _e3721;
                            } else {
                                phi_8338_ = f64();
                                phi_8339_ = type_45();
                                phi_8340_ = false;
                                phi_8341_ = true;
                                phi_8342_ = false;
                                phi_8343_ = false;
                            }
                            let _e3723 = phi_8338_;
                            let _e3725 = phi_8339_;
                            let _e3727 = phi_8340_;
                            let _e3729 = phi_8341_;
                            let _e3731 = phi_8342_;
                            let _e3733 = phi_8343_;
                            local_21 = _e3729;
                            local_41 = _e3731;
                            local_42 = _e3733;
                            local_22 = _e3723;
                            local_23 = _e3725;
                            continue;
                            continuing {
                                phi_4638_ = _e1267;
                                break if !(_e3727);
                            }
                        }
                        let _e3736 = local_21;
                        if _e3736 {
                            phi_8348_ = type_44(0u, type_44().member_1);
                            phi_8349_ = false;
                            phi_8350_ = false;
                        } else {
                            phi_8348_ = type_44();
                            let _e6207 = local_41;
                            phi_8349_ = _e6207;
                            let _e6210 = local_42;
                            phi_8350_ = _e6210;
                        }
                        let _e3740 = phi_8348_;
                        let _e3742 = phi_8349_;
                        let _e3744 = phi_8350_;
                        if _e3742 {
                            let _e3746 = local_22;
                            phi_8355_ = type_44(2u, _e3746);
                            phi_8356_ = false;
                        } else {
                            phi_8355_ = type_44();
                            phi_8356_ = _e3744;
                        }
                        let _e3749 = phi_8355_;
                        let _e3751 = phi_8356_;
                        if _e3751 {
                            let _e3753 = local_23;
                            phi_8362_ = type_44(1u, _e3753.member);
                            phi_8363_ = true;
                        } else {
                            phi_8362_ = _e3749;
                            phi_8363_ = _e3742;
                        }
                        let _e3757 = phi_8362_;
                        let _e3759 = phi_8363_;
                        if _e3759 {
                            phi_8367_ = _e3757;
                        } else {
                            phi_8367_ = _e3740;
                        }
                        let _e3761 = phi_8367_;
                        phi_8371_ = _e3761;
                    }
                    let _e5534 = phi_8371_;
                    phi_8372_ = _e5534;
                }
                let _e5538 = phi_8372_;
                switch bitcast<i32>(_e5538.member) {
                    case 0: {
                        phi_8385_ = type_32(0u, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e5544 = function_(_e5538.member_1);
                        phi_8385_ = type_32(0u, _e5544, true);
                        break;
                    }
                    case 2: {
                        let _e5542 = function_(_e5538.member_1);
                        phi_8385_ = type_32(1u, _e5542, true);
                        break;
                    }
                    default: {
                        phi_8385_ = type_32();
                        break;
                    }
                }
                let _e5547 = phi_8385_;
                if _e5547.member_2 {
                    let _e5554 = (_e5547.member_1[1] >> bitcast<u32>(20i));
                    if (_e5554 <= 896u) {
                        phi_8408_ = 0u;
                    } else {
                        phi_8408_ = ((((_e5554 - 896u) << bitcast<u32>(23i)) | ((_e5547.member_1[1] & 1048575u) << bitcast<u32>(3i))) | (_e5547.member_1[0] >> bitcast<u32>(29i)));
                    }
                    let _e5569 = phi_8408_;
                    let _e5571 = atomicMin((&earliest.member[0u]), _e5569);
                }
                phi_8412_ = type_22(1u, _e5547.member, _e181, _e184, _e5547.member_1);
                phi_8413_ = _e5547.member_2;
            } else {
                phi_8412_ = type_22(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u));
                phi_8413_ = false;
            }
            let _e5573 = phi_8412_;
            let _e5575 = phi_8413_;
            let _e5578 = params.member.member.member_1;
            if ((_e5578 & 16u) != 0u) {
                if (_e110 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e5575 {
                    let _e5584 = atomicAdd((&counters[0u]), 1u);
                    phi_8432_ = _e5584;
                } else {
                    phi_8432_ = 0u;
                }
                let _e5586 = phi_8432_;
                workgroupBarrier();
                if (_e110 == 0u) {
                    let _e5589 = atomicLoad((&counters[0u]));
                    if (_e5589 > 0u) {
                        let _e5592 = atomicAdd((&contacts.member[0u]), _e5589);
                        atomicStore((&counters[1u]), _e5592);
                    }
                }
                workgroupBarrier();
                let _e5595 = atomicLoad((&counters[1u]));
                let _e5596 = (_e5595 + _e5586);
                if _e5575 {
                    let _e5599 = params.member.member_1.member_3;
                    if (_e5596 < _e5599) {
                        let _e5601 = (6u * _e5596);
                        atomicStore((&contacts.member[(4u + _e5601)]), _e5573.member);
                        atomicStore((&contacts.member[(_e5601 + 5u)]), _e5573.member_1);
                        atomicStore((&contacts.member[(_e5601 + 6u)]), _e5573.member_2);
                        atomicStore((&contacts.member[(_e5601 + 7u)]), _e5573.member_3);
                        atomicStore((&contacts.member[(_e5601 + 8u)]), _e5573.member_4[0]);
                        atomicStore((&contacts.member[(_e5601 + 9u)]), _e5573.member_4[1]);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_282_ = _e166;
            break if !(_e172);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
