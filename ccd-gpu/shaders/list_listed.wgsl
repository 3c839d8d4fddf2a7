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
    member_11: f32,
    member_12: f32,
    member_13: f32,
    member_14: array<u32, 2>,
    member_15: array<u32, 2>,
    member_16: array<u32, 2>,
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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_24 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_25 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
var<workgroup> counters: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage, read_write> output: type_29;
@group(0) @binding(1) 
var<storage> boxes: type_21;
@group(0) @binding(2) 
var<storage> elements: type_13;
@group(0) @binding(3) 
var<storage> bodies: type_13;
@group(0) @binding(4) 
var<storage> keys: type_24;
@group(0) @binding(5) 
var<storage> input: type_13;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_110_: bool;
    var phi_111_: bool;
    var phi_115_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_111_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_110_ = (param[0] > param_1[0]);
        } else {
            phi_110_ = false;
        }
        let _e14 = phi_110_;
        phi_111_ = _e14;
    }
    let _e16 = phi_111_;
    if _e16 {
        phi_115_ = param_1;
    } else {
        phi_115_ = param;
    }
    let _e18 = phi_115_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_134_: bool;
    var phi_135_: bool;
    var phi_139_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_135_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_134_ = (param_3[0] > param_2[0]);
        } else {
            phi_134_ = false;
        }
        let _e14 = phi_134_;
        phi_135_ = _e14;
    }
    let _e16 = phi_135_;
    if _e16 {
        phi_139_ = param_3;
    } else {
        phi_139_ = param_2;
    }
    let _e18 = phi_139_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_158_: bool;
    var phi_159_: bool;
    var phi_163_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_159_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_158_ = (param_4[0] > param_5[0]);
        } else {
            phi_158_ = false;
        }
        let _e14 = phi_158_;
        phi_159_ = _e14;
    }
    let _e16 = phi_159_;
    if _e16 {
        phi_163_ = param_5;
    } else {
        phi_163_ = param_4;
    }
    let _e18 = phi_163_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_182_: bool;
    var phi_183_: bool;
    var phi_187_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_183_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_182_ = (param_7[0] > param_6[0]);
        } else {
            phi_182_ = false;
        }
        let _e14 = phi_182_;
        phi_183_ = _e14;
    }
    let _e16 = phi_183_;
    if _e16 {
        phi_187_ = param_7;
    } else {
        phi_187_ = param_6;
    }
    let _e18 = phi_187_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_206_: bool;
    var phi_207_: bool;
    var phi_211_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_207_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_206_ = (param_8[0] > param_9[0]);
        } else {
            phi_206_ = false;
        }
        let _e14 = phi_206_;
        phi_207_ = _e14;
    }
    let _e16 = phi_207_;
    if _e16 {
        phi_211_ = param_9;
    } else {
        phi_211_ = param_8;
    }
    let _e18 = phi_211_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_230_: bool;
    var phi_231_: bool;
    var phi_235_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_231_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_230_ = (param_11[0] > param_10[0]);
        } else {
            phi_230_ = false;
        }
        let _e14 = phi_230_;
        phi_231_ = _e14;
    }
    let _e16 = phi_231_;
    if _e16 {
        phi_235_ = param_11;
    } else {
        phi_235_ = param_10;
    }
    let _e18 = phi_235_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_280_: u32;
    var phi_290_: u32;
    var phi_297_: u32;
    var phi_313_: u32;
    var phi_334_: u32;
    var phi_335_: u32;
    var phi_338_: type_9;
    var phi_339_: type_9;
    var phi_362_: type_9;
    var phi_496_: type_25;
    var phi_510_: array<u32, 3>;
    var phi_511_: array<u32, 3>;
    var phi_533_: array<u32, 2>;
    var phi_601_: bool;
    var phi_607_: bool;
    var phi_575_: bool;
    var phi_582_: bool;
    var phi_590_: bool;
    var phi_609_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_666_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_818_: u32;
    var phi_819_: u32;
    var phi_820_: u32;
    var phi_821_: u32;
    var phi_824_: type_16;
    var phi_827_: u32;
    var phi_829_: u32;
    var phi_850_: bool;
    var phi_856_: type_17;
    var phi_825_: type_16;
    var phi_870_: type_17;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_941_: bool;
    var phi_945_: bool;
    var phi_946_: bool;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_955_: bool;
    var phi_828_: u32;
    var phi_830_: u32;
    var phi_956_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1007_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1016_: bool;
    var phi_1020_: bool;
    var phi_1021_: bool;
    var phi_1025_: bool;
    var phi_1026_: bool;
    var phi_1030_: bool;
    var phi_1031_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1261_: bool;
    var phi_1262_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1546_: bool;
    var phi_1547_: bool;
    var phi_1640_: bool;
    var phi_1641_: bool;
    var phi_1645_: bool;
    var phi_1646_: bool;
    var phi_1647_: bool;
    var phi_1651_: bool;
    var phi_1652_: bool;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1659_: bool;
    var phi_1665_: u32;
    var phi_1666_: u32;
    var phi_1667_: bool;
    var phi_1668_: type_9;
    var phi_1695_: u32;
    var phi_1718_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e33 = id_2;
    let _e34 = n_2;
    let _e35 = lane_2;
    let _e47 = ((_e33.y * _e34.x) + _e33.x);
    let _e50 = (_e34.x * _e34.y);
    let _e54 = params.member.member_2.member;
    let _e56 = params.member.member_1.member_2;
    let _e58 = input.member[0u];
    if (_e56 < _e58) {
        phi_280_ = _e56;
    } else {
        phi_280_ = _e58;
    }
    let _e61 = phi_280_;
    let _e63 = params.member.member_1.member_1;
    if (_e61 > _e63) {
        let _e66 = params.member.member_1.member_1;
        phi_290_ = (_e61 - _e66);
    } else {
        phi_290_ = 0u;
    }
    let _e69 = phi_290_;
    let _e71 = params.member.member_1.member;
    if (_e71 < _e69) {
        phi_297_ = _e71;
    } else {
        phi_297_ = _e69;
    }
    let _e74 = phi_297_;
    let _e75 = (_e74 / 128u);
    if ((_e74 % 128u) > 0u) {
        phi_313_ = (_e75 + 1u);
    } else {
        phi_313_ = _e75;
    }
    let _e80 = phi_313_;
    if (_e80 > _e47) {
        let _e82 = (_e80 - _e47);
        if (_e50 == 0u) {
            return;
        }
        let _e84 = (_e82 / _e50);
        if (_e50 == 0u) {
            return;
        }
        if ((_e82 % _e50) > 0u) {
            phi_334_ = (_e84 + 1u);
        } else {
            phi_334_ = _e84;
        }
        let _e90 = phi_334_;
        phi_335_ = _e90;
    } else {
        phi_335_ = 0u;
    }
    let _e92 = phi_335_;
    phi_338_ = type_9(0u, _e92);
    loop {
        let _e95 = phi_338_;
        if (_e95.member < _e95.member_1) {
            phi_339_ = type_9((_e95.member + 1u), _e95.member_1);
            phi_362_ = type_9(1u, _e95.member);
        } else {
            phi_339_ = _e95;
            phi_362_ = type_9(0u, type_9().member_1);
        }
        let _e107 = phi_339_;
        let _e109 = phi_362_;
        let _e113 = (bitcast<i32>(_e109.member) != 0i);
        if _e113 {
            let _e117 = (((_e47 + (_e109.member_1 * _e50)) * 128u) + _e35);
            if (_e35 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if (_e117 < _e74) {
                let _e122 = params.member.member_1.member_1;
                let _e124 = (2u * (_e122 + _e117));
                let _e127 = input.member[(4u + _e124)];
                let _e130 = input.member[(_e124 + 5u)];
                if (_e54 == 0u) {
                    let _e147 = (3u * _e130);
                    let _e149 = elements.member[_e147];
                    let _e152 = elements.member[(_e147 + 1u)];
                    let _e155 = elements.member[(_e147 + 2u)];
                    phi_496_ = type_25(0u, array<u32, 4>(_e127, _e149, _e152, _e155));
                } else {
                    let _e133 = (2u * _e127);
                    let _e134 = (2u * _e130);
                    let _e136 = elements.member[_e133];
                    let _e138 = elements.member[_e134];
                    let _e141 = elements.member[(_e133 + 1u)];
                    let _e144 = elements.member[(_e134 + 1u)];
                    phi_496_ = type_25(1u, array<u32, 4>(_e136, _e141, _e138, _e144));
                }
                let _e159 = phi_496_;
                if (_e54 == 0u) {
                    phi_510_ = array<u32, 3>(_e159.member_1[1], _e159.member_1[2], _e159.member_1[3]);
                    phi_511_ = array<u32, 3>(_e159.member_1[0], _e159.member_1[0], _e159.member_1[0]);
                } else {
                    phi_510_ = array<u32, 3>(_e159.member_1[2], _e159.member_1[3], _e159.member_1[3]);
                    phi_511_ = array<u32, 3>(_e159.member_1[0], _e159.member_1[1], _e159.member_1[1]);
                }
                let _e171 = phi_510_;
                let _e173 = phi_511_;
                if (_e54 == 0u) {
                    let _e187 = params.member.member.member_2[2u];
                    phi_533_ = array<u32, 2>(_e127, (_e187 + _e130));
                } else {
                    let _e178 = params.member.member.member_2[1u];
                    let _e182 = params.member.member.member_2[1u];
                    phi_533_ = array<u32, 2>((_e178 + _e127), (_e182 + _e130));
                }
                let _e191 = phi_533_;
                let _e195 = boxes.member[_e191[0]];
                let _e197 = boxes.member[_e191[1]];
                let _e200 = params.member.member.member_1;
                if ((_e200 & 1u) != 0u) {
                    if (_e54 == 0u) {
                        if (_e171[0] == _e173[0]) {
                            phi_575_ = true;
                        } else {
                            phi_575_ = (_e171[0] == _e173[0]);
                        }
                        let _e222 = phi_575_;
                        if (_e171[1] == _e173[0]) {
                            phi_582_ = true;
                        } else {
                            phi_582_ = (_e171[1] == _e173[0]);
                        }
                        let _e227 = phi_582_;
                        if (_e171[2] == _e173[0]) {
                            phi_590_ = true;
                        } else {
                            phi_590_ = (_e171[2] == _e173[0]);
                        }
                        let _e233 = phi_590_;
                        phi_609_ = ((_e222 || _e227) || _e233);
                    } else {
                        if (_e171[0] == _e173[0]) {
                            phi_601_ = true;
                        } else {
                            phi_601_ = (_e171[0] == _e173[1]);
                        }
                        let _e211 = phi_601_;
                        if (_e171[1] == _e173[0]) {
                            phi_607_ = true;
                        } else {
                            phi_607_ = (_e171[1] == _e173[1]);
                        }
                        let _e215 = phi_607_;
                        phi_609_ = (_e211 || _e215);
                    }
                    let _e236 = phi_609_;
                    if _e236 {
                        phi_613_ = false;
                    } else {
                        phi_613_ = true;
                    }
                    let _e238 = phi_613_;
                    phi_614_ = _e238;
                } else {
                    phi_614_ = true;
                }
                let _e240 = phi_614_;
                if _e240 {
                    let _e242 = params.member.member.member_1;
                    if ((_e242 & 2u) != 0u) {
                        let _e247 = bodies.member[_e173[0]];
                        let _e250 = bodies.member[_e171[0]];
                        if ((_e247 / 4u) != (_e250 / 4u)) {
                            phi_659_ = true;
                        } else {
                            if ((_e247 & 2u) == 0u) {
                                phi_658_ = false;
                            } else {
                                phi_658_ = true;
                            }
                            let _e257 = phi_658_;
                            phi_659_ = _e257;
                        }
                        let _e259 = phi_659_;
                        if _e259 {
                            phi_666_ = (((_e247 & _e250) & 1u) == 0u);
                        } else {
                            phi_666_ = false;
                        }
                        let _e264 = phi_666_;
                        if _e264 {
                            let _e266 = params.member.member.member_1;
                            if ((_e266 & 4u) != 0u) {
                                let _e271 = params.member.member.member[0u];
                                let _e273 = bodies.member[_e271];
                                let _e276 = bodies.member[(_e271 + 1u)];
                                let _e281 = ((_e271 + 4u) + (2u * (_e247 >> bitcast<u32>(2i))));
                                let _e286 = ((_e271 + 4u) + (2u * (_e250 >> bitcast<u32>(2i))));
                                let _e288 = bodies.member[_e281];
                                let _e290 = bodies.member[_e286];
                                let _e299 = bodies.member[((((_e271 + 4u) + (2u * _e273)) + (_e288 * _e276)) + (_e290 / 32u))];
                                let _e302 = bodies.member[(_e281 + 1u)];
                                let _e305 = bodies.member[(_e286 + 1u)];
                                if (_e302 == _e305) {
                                    if (((_e299 >> bitcast<u32>(((_e290 % 32u) & 31u))) & 1u) == 1u) {
                                        phi_782_ = true;
                                    } else {
                                        phi_782_ = ((_e247 >> bitcast<u32>(2i)) == (_e250 >> bitcast<u32>(2i)));
                                    }
                                    let _e319 = phi_782_;
                                    phi_783_ = _e319;
                                } else {
                                    phi_783_ = false;
                                }
                                let _e321 = phi_783_;
                                if _e321 {
                                    let _e324 = bodies.member[(_e271 + 2u)];
                                    let _e327 = bodies.member[(_e271 + 3u)];
                                    let _e328 = (_e327 + _e271);
                                    if (_e54 == 1u) {
                                        if (_e130 < _e127) {
                                            phi_818_ = _e127;
                                            phi_819_ = _e130;
                                        } else {
                                            phi_818_ = _e130;
                                            phi_819_ = _e127;
                                        }
                                        let _e332 = phi_818_;
                                        let _e334 = phi_819_;
                                        phi_820_ = _e332;
                                        phi_821_ = _e334;
                                    } else {
                                        phi_820_ = _e130;
                                        phi_821_ = _e127;
                                    }
                                    let _e336 = phi_820_;
                                    let _e338 = phi_821_;
                                    phi_824_ = type_16(0i, 32i);
                                    phi_827_ = _e324;
                                    phi_829_ = 0u;
                                    loop {
                                        let _e340 = phi_824_;
                                        let _e342 = phi_827_;
                                        let _e344 = phi_829_;
                                        local = _e344;
                                        local_1 = _e344;
                                        if (_e340.member < _e340.member_1) {
                                            let _e351 = (_e340.member + 1i);
                                            if ((false == (_e351 > _e340.member)) != false) {
                                                phi_850_ = true;
                                            } else {
                                                phi_850_ = false;
                                            }
                                            let _e356 = phi_850_;
                                            if _e356 {
                                                phi_856_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_856_ = type_17(1u, _e351);
                                            }
                                            let _e361 = phi_856_;
                                            phi_825_ = type_16(_e361.member_1, _e340.member_1);
                                            phi_870_ = type_17(1u, _e340.member);
                                        } else {
                                            phi_825_ = _e340;
                                            phi_870_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e367 = phi_825_;
                                        let _e369 = phi_870_;
                                        if (bitcast<i32>(_e369.member) != 0i) {
                                            if (_e344 >= _e342) {
                                                phi_953_ = u32();
                                                phi_954_ = u32();
                                                phi_955_ = false;
                                            } else {
                                                let _e376 = (_e344 + ((_e342 - _e344) / 2u));
                                                let _e378 = (_e328 + (3u * _e376));
                                                let _e380 = bodies.member[_e378];
                                                let _e383 = bodies.member[(_e378 + 1u)];
                                                let _e386 = bodies.member[(_e378 + 2u)];
                                                if (_e380 < _e54) {
                                                    phi_946_ = true;
                                                } else {
                                                    if (_e380 == _e54) {
                                                        if (_e383 < _e338) {
                                                            phi_940_ = false;
                                                        } else {
                                                            if (_e383 == _e338) {
                                                                if (_e386 < _e336) {
                                                                    phi_938_ = false;
                                                                } else {
                                                                    phi_938_ = true;
                                                                }
                                                                let _e393 = phi_938_;
                                                                phi_939_ = _e393;
                                                            } else {
                                                                phi_939_ = true;
                                                            }
                                                            let _e395 = phi_939_;
                                                            phi_940_ = _e395;
                                                        }
                                                        let _e397 = phi_940_;
                                                        phi_941_ = _e397;
                                                    } else {
                                                        phi_941_ = true;
                                                    }
                                                    let _e399 = phi_941_;
                                                    if _e399 {
                                                        phi_945_ = false;
                                                    } else {
                                                        phi_945_ = true;
                                                    }
                                                    let _e401 = phi_945_;
                                                    phi_946_ = _e401;
                                                }
                                                let _e403 = phi_946_;
                                                if _e403 {
                                                    phi_951_ = _e342;
                                                    phi_952_ = (_e376 + 1u);
                                                } else {
                                                    phi_951_ = _e376;
                                                    phi_952_ = _e344;
                                                }
                                                let _e406 = phi_951_;
                                                let _e408 = phi_952_;
                                                phi_953_ = _e406;
                                                phi_954_ = _e408;
                                                phi_955_ = true;
                                            }
                                            let _e410 = phi_953_;
                                            let _e412 = phi_954_;
                                            let _e414 = phi_955_;
                                            phi_828_ = _e410;
                                            phi_830_ = _e412;
                                            phi_956_ = _e414;
                                        } else {
                                            phi_828_ = u32();
                                            phi_830_ = u32();
                                            phi_956_ = false;
                                        }
                                        let _e416 = phi_828_;
                                        let _e418 = phi_830_;
                                        let _e420 = phi_956_;
                                        continue;
                                        continuing {
                                            phi_824_ = _e367;
                                            phi_827_ = _e416;
                                            phi_829_ = _e418;
                                            break if !(_e420);
                                        }
                                    }
                                    let _e423 = local;
                                    if (_e423 < _e324) {
                                        let _e426 = local_1;
                                        let _e428 = (_e328 + (3u * _e426));
                                        let _e430 = bodies.member[_e428];
                                        if (_e430 == _e54) {
                                            let _e434 = bodies.member[(_e428 + 1u)];
                                            if (_e434 == _e338) {
                                                let _e438 = bodies.member[(_e428 + 2u)];
                                                phi_1004_ = (_e438 == _e336);
                                                phi_1005_ = false;
                                            } else {
                                                phi_1004_ = bool();
                                                phi_1005_ = true;
                                            }
                                            let _e441 = phi_1004_;
                                            let _e443 = phi_1005_;
                                            phi_1006_ = _e441;
                                            phi_1007_ = _e443;
                                        } else {
                                            phi_1006_ = bool();
                                            phi_1007_ = true;
                                        }
                                        let _e445 = phi_1006_;
                                        let _e447 = phi_1007_;
                                        if _e447 {
                                            phi_1011_ = false;
                                        } else {
                                            phi_1011_ = _e445;
                                        }
                                        let _e449 = phi_1011_;
                                        phi_1012_ = _e449;
                                    } else {
                                        phi_1012_ = false;
                                    }
                                    let _e451 = phi_1012_;
                                    phi_1016_ = _e451;
                                } else {
                                    phi_1016_ = true;
                                }
                                let _e453 = phi_1016_;
                                if _e453 {
                                    phi_1020_ = false;
                                } else {
                                    phi_1020_ = true;
                                }
                                let _e455 = phi_1020_;
                                phi_1021_ = _e455;
                            } else {
                                phi_1021_ = true;
                            }
                            let _e457 = phi_1021_;
                            if _e457 {
                                phi_1025_ = false;
                            } else {
                                phi_1025_ = true;
                            }
                            let _e459 = phi_1025_;
                            phi_1026_ = _e459;
                        } else {
                            phi_1026_ = true;
                        }
                        let _e461 = phi_1026_;
                        if _e461 {
                            phi_1030_ = false;
                        } else {
                            phi_1030_ = true;
                        }
                        let _e463 = phi_1030_;
                        phi_1031_ = _e463;
                    } else {
                        phi_1031_ = true;
                    }
                    let _e465 = phi_1031_;
                    if _e465 {
                        let _e467 = params.member.member.member_1;
                        if ((_e467 & 32u) != 0u) {
                            let _e471 = params.member.member.member_6;
                            let _e512 = (((((_e195.member_1[0] - _e197.member[0]) > _e471) && ((_e197.member_1[0] - _e195.member[0]) > _e471)) && (((_e195.member_1[1] - _e197.member[1]) > _e471) && ((_e197.member_1[1] - _e195.member[1]) > _e471))) && (((_e195.member_1[2] - _e197.member[2]) > _e471) && ((_e197.member_1[2] - _e195.member[2]) > _e471)));
                            if _e512 {
                                phi_1645_ = bool();
                            } else {
                                let _e515 = keys.member[_e173[0]];
                                let _e519 = keys.member[_e173[1]];
                                let _e521 = function_(_e515[0], _e519[0]);
                                let _e524 = keys.member[_e173[2]];
                                let _e526 = function_(_e521, _e524[0]);
                                let _e529 = keys.member[_e171[0]];
                                let _e533 = keys.member[_e171[1]];
                                let _e535 = function_1(_e529[3], _e533[3]);
                                let _e538 = keys.member[_e171[2]];
                                let _e540 = function_1(_e535, _e538[3]);
                                if (_e526[1] > _e540[1]) {
                                    phi_1168_ = true;
                                } else {
                                    if (_e526[1] == _e540[1]) {
                                        phi_1167_ = (_e526[0] > _e540[0]);
                                    } else {
                                        phi_1167_ = false;
                                    }
                                    let _e551 = phi_1167_;
                                    phi_1168_ = _e551;
                                }
                                let _e553 = phi_1168_;
                                let _e557 = keys.member[_e171[0]];
                                let _e561 = keys.member[_e171[1]];
                                let _e563 = function_(_e557[0], _e561[0]);
                                let _e566 = keys.member[_e171[2]];
                                let _e568 = function_(_e563, _e566[0]);
                                let _e571 = keys.member[_e173[0]];
                                let _e575 = keys.member[_e173[1]];
                                let _e577 = function_1(_e571[3], _e575[3]);
                                let _e580 = keys.member[_e173[2]];
                                let _e582 = function_1(_e577, _e580[3]);
                                if (_e568[1] > _e582[1]) {
                                    phi_1262_ = true;
                                } else {
                                    if (_e568[1] == _e582[1]) {
                                        phi_1261_ = (_e568[0] > _e582[0]);
                                    } else {
                                        phi_1261_ = false;
                                    }
                                    let _e593 = phi_1261_;
                                    phi_1262_ = _e593;
                                }
                                let _e595 = phi_1262_;
                                let _e600 = keys.member[_e173[0]];
                                let _e604 = keys.member[_e173[1]];
                                let _e606 = function_2(_e600[1], _e604[1]);
                                let _e609 = keys.member[_e173[2]];
                                let _e611 = function_2(_e606, _e609[1]);
                                let _e614 = keys.member[_e171[0]];
                                let _e618 = keys.member[_e171[1]];
                                let _e620 = function_3(_e614[4], _e618[4]);
                                let _e623 = keys.member[_e171[2]];
                                let _e625 = function_3(_e620, _e623[4]);
                                if (_e611[1] > _e625[1]) {
                                    phi_1357_ = true;
                                } else {
                                    if (_e611[1] == _e625[1]) {
                                        phi_1356_ = (_e611[0] > _e625[0]);
                                    } else {
                                        phi_1356_ = false;
                                    }
                                    let _e636 = phi_1356_;
                                    phi_1357_ = _e636;
                                }
                                let _e638 = phi_1357_;
                                let _e642 = keys.member[_e171[0]];
                                let _e646 = keys.member[_e171[1]];
                                let _e648 = function_2(_e642[1], _e646[1]);
                                let _e651 = keys.member[_e171[2]];
                                let _e653 = function_2(_e648, _e651[1]);
                                let _e656 = keys.member[_e173[0]];
                                let _e660 = keys.member[_e173[1]];
                                let _e662 = function_3(_e656[4], _e660[4]);
                                let _e665 = keys.member[_e173[2]];
                                let _e667 = function_3(_e662, _e665[4]);
                                if (_e653[1] > _e667[1]) {
                                    phi_1451_ = true;
                                } else {
                                    if (_e653[1] == _e667[1]) {
                                        phi_1450_ = (_e653[0] > _e667[0]);
                                    } else {
                                        phi_1450_ = false;
                                    }
                                    let _e678 = phi_1450_;
                                    phi_1451_ = _e678;
                                }
                                let _e680 = phi_1451_;
                                let _e686 = keys.member[_e173[0]];
                                let _e690 = keys.member[_e173[1]];
                                let _e692 = function_4(_e686[2], _e690[2]);
                                let _e695 = keys.member[_e173[2]];
                                let _e697 = function_4(_e692, _e695[2]);
                                let _e700 = keys.member[_e171[0]];
                                let _e704 = keys.member[_e171[1]];
                                let _e706 = function_5(_e700[5], _e704[5]);
                                let _e709 = keys.member[_e171[2]];
                                let _e711 = function_5(_e706, _e709[5]);
                                if (_e697[1] > _e711[1]) {
                                    phi_1547_ = true;
                                } else {
                                    if (_e697[1] == _e711[1]) {
                                        phi_1546_ = (_e697[0] > _e711[0]);
                                    } else {
                                        phi_1546_ = false;
                                    }
                                    let _e722 = phi_1546_;
                                    phi_1547_ = _e722;
                                }
                                let _e724 = phi_1547_;
                                let _e728 = keys.member[_e171[0]];
                                let _e732 = keys.member[_e171[1]];
                                let _e734 = function_4(_e728[2], _e732[2]);
                                let _e737 = keys.member[_e171[2]];
                                let _e739 = function_4(_e734, _e737[2]);
                                let _e742 = keys.member[_e173[0]];
                                let _e746 = keys.member[_e173[1]];
                                let _e748 = function_5(_e742[5], _e746[5]);
                                let _e751 = keys.member[_e173[2]];
                                let _e753 = function_5(_e748, _e751[5]);
                                if (_e739[1] > _e753[1]) {
                                    phi_1641_ = true;
                                } else {
                                    if (_e739[1] == _e753[1]) {
                                        phi_1640_ = (_e739[0] > _e753[0]);
                                    } else {
                                        phi_1640_ = false;
                                    }
                                    let _e764 = phi_1640_;
                                    phi_1641_ = _e764;
                                }
                                let _e766 = phi_1641_;
                                phi_1645_ = (((!(_e553) && !(_e595)) && (!(_e638) && !(_e680))) && (!(_e724) && !(_e766)));
                            }
                            let _e771 = phi_1645_;
                            phi_1646_ = _e771;
                            phi_1647_ = _e512;
                        } else {
                            phi_1646_ = bool();
                            phi_1647_ = true;
                        }
                        let _e773 = phi_1646_;
                        let _e775 = phi_1647_;
                        if _e775 {
                            phi_1651_ = false;
                        } else {
                            phi_1651_ = true;
                        }
                        let _e777 = phi_1651_;
                        phi_1652_ = _e773;
                        phi_1653_ = _e777;
                    } else {
                        phi_1652_ = false;
                        phi_1653_ = true;
                    }
                    let _e779 = phi_1652_;
                    let _e781 = phi_1653_;
                    phi_1654_ = _e779;
                    phi_1655_ = _e781;
                } else {
                    phi_1654_ = false;
                    phi_1655_ = true;
                }
                let _e783 = phi_1654_;
                let _e785 = phi_1655_;
                if _e785 {
                    phi_1659_ = _e783;
                } else {
                    phi_1659_ = true;
                }
                let _e787 = phi_1659_;
                if _e787 {
                    let _e789 = atomicAdd((&counters[0u]), 1u);
                    phi_1665_ = _e789;
                } else {
                    phi_1665_ = 0u;
                }
                let _e791 = phi_1665_;
                phi_1666_ = _e791;
                phi_1667_ = _e787;
                phi_1668_ = type_9(_e127, _e130);
            } else {
                phi_1666_ = 0u;
                phi_1667_ = false;
                phi_1668_ = type_9(0u, 0u);
            }
            let _e793 = phi_1666_;
            let _e795 = phi_1667_;
            let _e797 = phi_1668_;
            workgroupBarrier();
            if (_e35 == 0u) {
                let _e800 = atomicLoad((&counters[0u]));
                if (_e800 > 0u) {
                    let _e804 = params.member.member.member_1;
                    if ((_e804 & 1024u) != 0u) {
                        let _e814 = atomicAdd((&output.member[0u]), _e800);
                        let _e815 = (_e814 + _e800);
                        if (_e815 < _e814) {
                            phi_1695_ = 4294967295u;
                        } else {
                            phi_1695_ = _e815;
                        }
                        let _e818 = phi_1695_;
                        let _e821 = params.member.member_1.member_3;
                        if (_e818 > _e821) {
                            let _e824 = atomicMax((&output.member[2u]), _e818);
                        }
                        phi_1718_ = _e814;
                    } else {
                        let _e808 = atomicAdd((&output.member[0u]), _e800);
                        if ((_e808 + _e800) < _e808) {
                            let _e812 = atomicAdd((&output.member[2u]), 1u);
                        }
                        phi_1718_ = _e808;
                    }
                    let _e826 = phi_1718_;
                    atomicStore((&counters[1u]), _e826);
                    let _e829 = atomicAdd((&output.member[1u]), _e800);
                    if ((_e829 + _e800) < _e829) {
                        let _e833 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e795 {
                let _e835 = params.member.member_1.member_3;
                let _e837 = atomicLoad((&counters[1u]));
                let _e838 = (_e837 + _e793);
                if (_e838 < _e835) {
                    let _e842 = (2u * _e838);
                    atomicStore((&output.member[(4u + _e842)]), _e797.member);
                    atomicStore((&output.member[(_e842 + 5u)]), _e797.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_338_ = _e107;
            break if !(_e113);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_listed(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
