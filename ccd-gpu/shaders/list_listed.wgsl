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

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(6) 
var<storage, read_write> output: type_28;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(1) 
var<storage> boxes: type_21;
@group(0) @binding(3) 
var<storage> bodies: type_13;
@group(0) @binding(4) 
var<storage> keys: type_24;
@group(0) @binding(5) 
var<storage> input: type_13;
@group(0) @binding(2) 
var<storage> elements: type_13;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_108_: bool;
    var phi_109_: bool;
    var phi_113_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_109_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_108_ = (param[0] > param_1[0]);
        } else {
            phi_108_ = false;
        }
        let _e14 = phi_108_;
        phi_109_ = _e14;
    }
    let _e16 = phi_109_;
    if _e16 {
        phi_113_ = param_1;
    } else {
        phi_113_ = param;
    }
    let _e18 = phi_113_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_132_: bool;
    var phi_133_: bool;
    var phi_137_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_133_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_132_ = (param_3[0] > param_2[0]);
        } else {
            phi_132_ = false;
        }
        let _e14 = phi_132_;
        phi_133_ = _e14;
    }
    let _e16 = phi_133_;
    if _e16 {
        phi_137_ = param_3;
    } else {
        phi_137_ = param_2;
    }
    let _e18 = phi_137_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_156_: bool;
    var phi_157_: bool;
    var phi_161_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_157_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_156_ = (param_4[0] > param_5[0]);
        } else {
            phi_156_ = false;
        }
        let _e14 = phi_156_;
        phi_157_ = _e14;
    }
    let _e16 = phi_157_;
    if _e16 {
        phi_161_ = param_5;
    } else {
        phi_161_ = param_4;
    }
    let _e18 = phi_161_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_180_: bool;
    var phi_181_: bool;
    var phi_185_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_181_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_180_ = (param_7[0] > param_6[0]);
        } else {
            phi_180_ = false;
        }
        let _e14 = phi_180_;
        phi_181_ = _e14;
    }
    let _e16 = phi_181_;
    if _e16 {
        phi_185_ = param_7;
    } else {
        phi_185_ = param_6;
    }
    let _e18 = phi_185_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_204_: bool;
    var phi_205_: bool;
    var phi_209_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_205_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_204_ = (param_8[0] > param_9[0]);
        } else {
            phi_204_ = false;
        }
        let _e14 = phi_204_;
        phi_205_ = _e14;
    }
    let _e16 = phi_205_;
    if _e16 {
        phi_209_ = param_9;
    } else {
        phi_209_ = param_8;
    }
    let _e18 = phi_209_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_228_: bool;
    var phi_229_: bool;
    var phi_233_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_229_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_228_ = (param_11[0] > param_10[0]);
        } else {
            phi_228_ = false;
        }
        let _e14 = phi_228_;
        phi_229_ = _e14;
    }
    let _e16 = phi_229_;
    if _e16 {
        phi_233_ = param_11;
    } else {
        phi_233_ = param_10;
    }
    let _e18 = phi_233_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_278_: u32;
    var phi_288_: u32;
    var phi_295_: u32;
    var phi_311_: u32;
    var phi_332_: u32;
    var phi_333_: u32;
    var phi_336_: type_9;
    var phi_337_: type_9;
    var phi_360_: type_9;
    var phi_495_: type_25;
    var phi_509_: array<u32, 3>;
    var phi_510_: array<u32, 3>;
    var phi_532_: array<u32, 2>;
    var phi_600_: bool;
    var phi_606_: bool;
    var phi_574_: bool;
    var phi_581_: bool;
    var phi_589_: bool;
    var phi_608_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_665_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_817_: u32;
    var phi_818_: u32;
    var phi_819_: u32;
    var phi_820_: u32;
    var phi_823_: type_16;
    var phi_826_: u32;
    var phi_828_: u32;
    var phi_849_: bool;
    var phi_855_: type_17;
    var phi_824_: type_16;
    var phi_869_: type_17;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_944_: bool;
    var phi_945_: bool;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_954_: bool;
    var phi_827_: u32;
    var phi_829_: u32;
    var phi_955_: bool;
    var local: u32;
    var local_1: u32;
    var phi_1003_: bool;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1015_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1029_: bool;
    var phi_1030_: bool;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1260_: bool;
    var phi_1261_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1449_: bool;
    var phi_1450_: bool;
    var phi_1545_: bool;
    var phi_1546_: bool;
    var phi_1639_: bool;
    var phi_1640_: bool;
    var phi_1644_: bool;
    var phi_1645_: bool;
    var phi_1646_: bool;
    var phi_1650_: bool;
    var phi_1651_: bool;
    var phi_1652_: bool;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1658_: bool;
    var phi_1670_: u32;
    var phi_1671_: bool;
    var phi_1672_: u32;
    var phi_1673_: bool;
    var phi_1674_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e31 = id_2;
    let _e32 = n_2;
    let _e33 = lane_2;
    let _e45 = ((_e31.y * _e32.x) + _e31.x);
    let _e48 = (_e32.x * _e32.y);
    let _e52 = params.member.member_2.member;
    let _e54 = params.member.member_1.member_2;
    let _e56 = input.member[0u];
    if (_e54 < _e56) {
        phi_278_ = _e54;
    } else {
        phi_278_ = _e56;
    }
    let _e59 = phi_278_;
    let _e61 = params.member.member_1.member_1;
    if (_e59 > _e61) {
        let _e64 = params.member.member_1.member_1;
        phi_288_ = (_e59 - _e64);
    } else {
        phi_288_ = 0u;
    }
    let _e67 = phi_288_;
    let _e69 = params.member.member_1.member;
    if (_e69 < _e67) {
        phi_295_ = _e69;
    } else {
        phi_295_ = _e67;
    }
    let _e72 = phi_295_;
    let _e73 = (_e72 / 128u);
    if ((_e72 % 128u) > 0u) {
        phi_311_ = (_e73 + 1u);
    } else {
        phi_311_ = _e73;
    }
    let _e78 = phi_311_;
    if (_e78 > _e45) {
        let _e80 = (_e78 - _e45);
        if (_e48 == 0u) {
            return;
        }
        let _e82 = (_e80 / _e48);
        if (_e48 == 0u) {
            return;
        }
        if ((_e80 % _e48) > 0u) {
            phi_332_ = (_e82 + 1u);
        } else {
            phi_332_ = _e82;
        }
        let _e88 = phi_332_;
        phi_333_ = _e88;
    } else {
        phi_333_ = 0u;
    }
    let _e90 = phi_333_;
    phi_336_ = type_9(0u, _e90);
    loop {
        let _e93 = phi_336_;
        if (_e93.member < _e93.member_1) {
            phi_337_ = type_9((_e93.member + 1u), _e93.member_1);
            phi_360_ = type_9(1u, _e93.member);
        } else {
            phi_337_ = _e93;
            phi_360_ = type_9(0u, type_9().member_1);
        }
        let _e105 = phi_337_;
        let _e107 = phi_360_;
        let _e111 = (bitcast<i32>(_e107.member) != 0i);
        if _e111 {
            let _e115 = (((_e45 + (_e107.member_1 * _e48)) * 128u) + _e33);
            if (_e33 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e115 < _e72) {
                let _e121 = params.member.member_1.member_1;
                let _e123 = (2u * (_e121 + _e115));
                let _e126 = input.member[(4u + _e123)];
                let _e129 = input.member[(_e123 + 5u)];
                if (_e52 == 0u) {
                    let _e146 = (3u * _e129);
                    let _e148 = elements.member[_e146];
                    let _e151 = elements.member[(_e146 + 1u)];
                    let _e154 = elements.member[(_e146 + 2u)];
                    phi_495_ = type_25(0u, array<u32, 4>(_e126, _e148, _e151, _e154));
                } else {
                    let _e132 = (2u * _e126);
                    let _e133 = (2u * _e129);
                    let _e135 = elements.member[_e132];
                    let _e137 = elements.member[_e133];
                    let _e140 = elements.member[(_e132 + 1u)];
                    let _e143 = elements.member[(_e133 + 1u)];
                    phi_495_ = type_25(1u, array<u32, 4>(_e135, _e140, _e137, _e143));
                }
                let _e158 = phi_495_;
                if (_e52 == 0u) {
                    phi_509_ = array<u32, 3>(_e158.member_1[1], _e158.member_1[2], _e158.member_1[3]);
                    phi_510_ = array<u32, 3>(_e158.member_1[0], _e158.member_1[0], _e158.member_1[0]);
                } else {
                    phi_509_ = array<u32, 3>(_e158.member_1[2], _e158.member_1[3], _e158.member_1[3]);
                    phi_510_ = array<u32, 3>(_e158.member_1[0], _e158.member_1[1], _e158.member_1[1]);
                }
                let _e170 = phi_509_;
                let _e172 = phi_510_;
                if (_e52 == 0u) {
                    let _e186 = params.member.member.member_2[2u];
                    phi_532_ = array<u32, 2>(_e126, (_e186 + _e129));
                } else {
                    let _e177 = params.member.member.member_2[1u];
                    let _e181 = params.member.member.member_2[1u];
                    phi_532_ = array<u32, 2>((_e177 + _e126), (_e181 + _e129));
                }
                let _e190 = phi_532_;
                let _e194 = boxes.member[_e190[0]];
                let _e196 = boxes.member[_e190[1]];
                let _e199 = params.member.member.member_1;
                if ((_e199 & 1u) != 0u) {
                    if (_e52 == 0u) {
                        if (_e170[0] == _e172[0]) {
                            phi_574_ = true;
                        } else {
                            phi_574_ = (_e170[0] == _e172[0]);
                        }
                        let _e221 = phi_574_;
                        if (_e170[1] == _e172[0]) {
                            phi_581_ = true;
                        } else {
                            phi_581_ = (_e170[1] == _e172[0]);
                        }
                        let _e226 = phi_581_;
                        if (_e170[2] == _e172[0]) {
                            phi_589_ = true;
                        } else {
                            phi_589_ = (_e170[2] == _e172[0]);
                        }
                        let _e232 = phi_589_;
                        phi_608_ = ((_e221 || _e226) || _e232);
                    } else {
                        if (_e170[0] == _e172[0]) {
                            phi_600_ = true;
                        } else {
                            phi_600_ = (_e170[0] == _e172[1]);
                        }
                        let _e210 = phi_600_;
                        if (_e170[1] == _e172[0]) {
                            phi_606_ = true;
                        } else {
                            phi_606_ = (_e170[1] == _e172[1]);
                        }
                        let _e214 = phi_606_;
                        phi_608_ = (_e210 || _e214);
                    }
                    let _e235 = phi_608_;
                    if _e235 {
                        phi_612_ = false;
                    } else {
                        phi_612_ = true;
                    }
                    let _e237 = phi_612_;
                    phi_613_ = _e237;
                } else {
                    phi_613_ = true;
                }
                let _e239 = phi_613_;
                if _e239 {
                    let _e241 = params.member.member.member_1;
                    if ((_e241 & 2u) != 0u) {
                        let _e246 = bodies.member[_e172[0]];
                        let _e249 = bodies.member[_e170[0]];
                        if ((_e246 / 4u) != (_e249 / 4u)) {
                            phi_658_ = true;
                        } else {
                            if ((_e246 & 2u) == 0u) {
                                phi_657_ = false;
                            } else {
                                phi_657_ = true;
                            }
                            let _e256 = phi_657_;
                            phi_658_ = _e256;
                        }
                        let _e258 = phi_658_;
                        if _e258 {
                            phi_665_ = (((_e246 & _e249) & 1u) == 0u);
                        } else {
                            phi_665_ = false;
                        }
                        let _e263 = phi_665_;
                        if _e263 {
                            let _e265 = params.member.member.member_1;
                            if ((_e265 & 4u) != 0u) {
                                let _e270 = params.member.member.member[0u];
                                let _e272 = bodies.member[_e270];
                                let _e275 = bodies.member[(_e270 + 1u)];
                                let _e280 = ((_e270 + 4u) + (2u * (_e246 >> bitcast<u32>(2i))));
                                let _e285 = ((_e270 + 4u) + (2u * (_e249 >> bitcast<u32>(2i))));
                                let _e287 = bodies.member[_e280];
                                let _e289 = bodies.member[_e285];
                                let _e298 = bodies.member[((((_e270 + 4u) + (2u * _e272)) + (_e287 * _e275)) + (_e289 / 32u))];
                                let _e301 = bodies.member[(_e280 + 1u)];
                                let _e304 = bodies.member[(_e285 + 1u)];
                                if (_e301 == _e304) {
                                    if (((_e298 >> bitcast<u32>(((_e289 % 32u) & 31u))) & 1u) == 1u) {
                                        phi_781_ = true;
                                    } else {
                                        phi_781_ = ((_e246 >> bitcast<u32>(2i)) == (_e249 >> bitcast<u32>(2i)));
                                    }
                                    let _e318 = phi_781_;
                                    phi_782_ = _e318;
                                } else {
                                    phi_782_ = false;
                                }
                                let _e320 = phi_782_;
                                if _e320 {
                                    let _e323 = bodies.member[(_e270 + 2u)];
                                    let _e326 = bodies.member[(_e270 + 3u)];
                                    let _e327 = (_e326 + _e270);
                                    if (_e52 == 1u) {
                                        if (_e129 < _e126) {
                                            phi_817_ = _e126;
                                            phi_818_ = _e129;
                                        } else {
                                            phi_817_ = _e129;
                                            phi_818_ = _e126;
                                        }
                                        let _e331 = phi_817_;
                                        let _e333 = phi_818_;
                                        phi_819_ = _e331;
                                        phi_820_ = _e333;
                                    } else {
                                        phi_819_ = _e129;
                                        phi_820_ = _e126;
                                    }
                                    let _e335 = phi_819_;
                                    let _e337 = phi_820_;
                                    phi_823_ = type_16(0i, 32i);
                                    phi_826_ = _e323;
                                    phi_828_ = 0u;
                                    loop {
                                        let _e339 = phi_823_;
                                        let _e341 = phi_826_;
                                        let _e343 = phi_828_;
                                        local = _e343;
                                        local_1 = _e343;
                                        if (_e339.member < _e339.member_1) {
                                            let _e350 = (_e339.member + 1i);
                                            if ((false == (_e350 > _e339.member)) != false) {
                                                phi_849_ = true;
                                            } else {
                                                phi_849_ = false;
                                            }
                                            let _e355 = phi_849_;
                                            if _e355 {
                                                phi_855_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_855_ = type_17(1u, _e350);
                                            }
                                            let _e360 = phi_855_;
                                            phi_824_ = type_16(_e360.member_1, _e339.member_1);
                                            phi_869_ = type_17(1u, _e339.member);
                                        } else {
                                            phi_824_ = _e339;
                                            phi_869_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e366 = phi_824_;
                                        let _e368 = phi_869_;
                                        if (bitcast<i32>(_e368.member) != 0i) {
                                            if (_e343 >= _e341) {
                                                phi_952_ = u32();
                                                phi_953_ = u32();
                                                phi_954_ = false;
                                            } else {
                                                let _e375 = (_e343 + ((_e341 - _e343) / 2u));
                                                let _e377 = (_e327 + (3u * _e375));
                                                let _e379 = bodies.member[_e377];
                                                let _e382 = bodies.member[(_e377 + 1u)];
                                                let _e385 = bodies.member[(_e377 + 2u)];
                                                if (_e379 < _e52) {
                                                    phi_945_ = true;
                                                } else {
                                                    if (_e379 == _e52) {
                                                        if (_e382 < _e337) {
                                                            phi_939_ = false;
                                                        } else {
                                                            if (_e382 == _e337) {
                                                                if (_e385 < _e335) {
                                                                    phi_937_ = false;
                                                                } else {
                                                                    phi_937_ = true;
                                                                }
                                                                let _e392 = phi_937_;
                                                                phi_938_ = _e392;
                                                            } else {
                                                                phi_938_ = true;
                                                            }
                                                            let _e394 = phi_938_;
                                                            phi_939_ = _e394;
                                                        }
                                                        let _e396 = phi_939_;
                                                        phi_940_ = _e396;
                                                    } else {
                                                        phi_940_ = true;
                                                    }
                                                    let _e398 = phi_940_;
                                                    if _e398 {
                                                        phi_944_ = false;
                                                    } else {
                                                        phi_944_ = true;
                                                    }
                                                    let _e400 = phi_944_;
                                                    phi_945_ = _e400;
                                                }
                                                let _e402 = phi_945_;
                                                if _e402 {
                                                    phi_950_ = _e341;
                                                    phi_951_ = (_e375 + 1u);
                                                } else {
                                                    phi_950_ = _e375;
                                                    phi_951_ = _e343;
                                                }
                                                let _e405 = phi_950_;
                                                let _e407 = phi_951_;
                                                phi_952_ = _e405;
                                                phi_953_ = _e407;
                                                phi_954_ = true;
                                            }
                                            let _e409 = phi_952_;
                                            let _e411 = phi_953_;
                                            let _e413 = phi_954_;
                                            phi_827_ = _e409;
                                            phi_829_ = _e411;
                                            phi_955_ = _e413;
                                        } else {
                                            phi_827_ = u32();
                                            phi_829_ = u32();
                                            phi_955_ = false;
                                        }
                                        let _e415 = phi_827_;
                                        let _e417 = phi_829_;
                                        let _e419 = phi_955_;
                                        continue;
                                        continuing {
                                            phi_823_ = _e366;
                                            phi_826_ = _e415;
                                            phi_828_ = _e417;
                                            break if !(_e419);
                                        }
                                    }
                                    let _e422 = local;
                                    if (_e422 < _e323) {
                                        let _e425 = local_1;
                                        let _e427 = (_e327 + (3u * _e425));
                                        let _e429 = bodies.member[_e427];
                                        if (_e429 == _e52) {
                                            let _e433 = bodies.member[(_e427 + 1u)];
                                            if (_e433 == _e337) {
                                                let _e437 = bodies.member[(_e427 + 2u)];
                                                phi_1003_ = (_e437 == _e335);
                                                phi_1004_ = false;
                                            } else {
                                                phi_1003_ = bool();
                                                phi_1004_ = true;
                                            }
                                            let _e440 = phi_1003_;
                                            let _e442 = phi_1004_;
                                            phi_1005_ = _e440;
                                            phi_1006_ = _e442;
                                        } else {
                                            phi_1005_ = bool();
                                            phi_1006_ = true;
                                        }
                                        let _e444 = phi_1005_;
                                        let _e446 = phi_1006_;
                                        if _e446 {
                                            phi_1010_ = false;
                                        } else {
                                            phi_1010_ = _e444;
                                        }
                                        let _e448 = phi_1010_;
                                        phi_1011_ = _e448;
                                    } else {
                                        phi_1011_ = false;
                                    }
                                    let _e450 = phi_1011_;
                                    phi_1015_ = _e450;
                                } else {
                                    phi_1015_ = true;
                                }
                                let _e452 = phi_1015_;
                                if _e452 {
                                    phi_1019_ = false;
                                } else {
                                    phi_1019_ = true;
                                }
                                let _e454 = phi_1019_;
                                phi_1020_ = _e454;
                            } else {
                                phi_1020_ = true;
                            }
                            let _e456 = phi_1020_;
                            if _e456 {
                                phi_1024_ = false;
                            } else {
                                phi_1024_ = true;
                            }
                            let _e458 = phi_1024_;
                            phi_1025_ = _e458;
                        } else {
                            phi_1025_ = true;
                        }
                        let _e460 = phi_1025_;
                        if _e460 {
                            phi_1029_ = false;
                        } else {
                            phi_1029_ = true;
                        }
                        let _e462 = phi_1029_;
                        phi_1030_ = _e462;
                    } else {
                        phi_1030_ = true;
                    }
                    let _e464 = phi_1030_;
                    if _e464 {
                        let _e466 = params.member.member.member_1;
                        if ((_e466 & 32u) != 0u) {
                            let _e470 = params.member.member.member_6;
                            let _e511 = (((((_e194.member_1[0] - _e196.member[0]) > _e470) && ((_e196.member_1[0] - _e194.member[0]) > _e470)) && (((_e194.member_1[1] - _e196.member[1]) > _e470) && ((_e196.member_1[1] - _e194.member[1]) > _e470))) && (((_e194.member_1[2] - _e196.member[2]) > _e470) && ((_e196.member_1[2] - _e194.member[2]) > _e470)));
                            if _e511 {
                                phi_1644_ = bool();
                            } else {
                                let _e514 = keys.member[_e172[0]];
                                let _e518 = keys.member[_e172[1]];
                                let _e520 = function_(_e514[0], _e518[0]);
                                let _e523 = keys.member[_e172[2]];
                                let _e525 = function_(_e520, _e523[0]);
                                let _e528 = keys.member[_e170[0]];
                                let _e532 = keys.member[_e170[1]];
                                let _e534 = function_1(_e528[3], _e532[3]);
                                let _e537 = keys.member[_e170[2]];
                                let _e539 = function_1(_e534, _e537[3]);
                                if (_e525[1] > _e539[1]) {
                                    phi_1167_ = true;
                                } else {
                                    if (_e525[1] == _e539[1]) {
                                        phi_1166_ = (_e525[0] > _e539[0]);
                                    } else {
                                        phi_1166_ = false;
                                    }
                                    let _e550 = phi_1166_;
                                    phi_1167_ = _e550;
                                }
                                let _e552 = phi_1167_;
                                let _e556 = keys.member[_e170[0]];
                                let _e560 = keys.member[_e170[1]];
                                let _e562 = function_(_e556[0], _e560[0]);
                                let _e565 = keys.member[_e170[2]];
                                let _e567 = function_(_e562, _e565[0]);
                                let _e570 = keys.member[_e172[0]];
                                let _e574 = keys.member[_e172[1]];
                                let _e576 = function_1(_e570[3], _e574[3]);
                                let _e579 = keys.member[_e172[2]];
                                let _e581 = function_1(_e576, _e579[3]);
                                if (_e567[1] > _e581[1]) {
                                    phi_1261_ = true;
                                } else {
                                    if (_e567[1] == _e581[1]) {
                                        phi_1260_ = (_e567[0] > _e581[0]);
                                    } else {
                                        phi_1260_ = false;
                                    }
                                    let _e592 = phi_1260_;
                                    phi_1261_ = _e592;
                                }
                                let _e594 = phi_1261_;
                                let _e599 = keys.member[_e172[0]];
                                let _e603 = keys.member[_e172[1]];
                                let _e605 = function_2(_e599[1], _e603[1]);
                                let _e608 = keys.member[_e172[2]];
                                let _e610 = function_2(_e605, _e608[1]);
                                let _e613 = keys.member[_e170[0]];
                                let _e617 = keys.member[_e170[1]];
                                let _e619 = function_3(_e613[4], _e617[4]);
                                let _e622 = keys.member[_e170[2]];
                                let _e624 = function_3(_e619, _e622[4]);
                                if (_e610[1] > _e624[1]) {
                                    phi_1356_ = true;
                                } else {
                                    if (_e610[1] == _e624[1]) {
                                        phi_1355_ = (_e610[0] > _e624[0]);
                                    } else {
                                        phi_1355_ = false;
                                    }
                                    let _e635 = phi_1355_;
                                    phi_1356_ = _e635;
                                }
                                let _e637 = phi_1356_;
                                let _e641 = keys.member[_e170[0]];
                                let _e645 = keys.member[_e170[1]];
                                let _e647 = function_2(_e641[1], _e645[1]);
                                let _e650 = keys.member[_e170[2]];
                                let _e652 = function_2(_e647, _e650[1]);
                                let _e655 = keys.member[_e172[0]];
                                let _e659 = keys.member[_e172[1]];
                                let _e661 = function_3(_e655[4], _e659[4]);
                                let _e664 = keys.member[_e172[2]];
                                let _e666 = function_3(_e661, _e664[4]);
                                if (_e652[1] > _e666[1]) {
                                    phi_1450_ = true;
                                } else {
                                    if (_e652[1] == _e666[1]) {
                                        phi_1449_ = (_e652[0] > _e666[0]);
                                    } else {
                                        phi_1449_ = false;
                                    }
                                    let _e677 = phi_1449_;
                                    phi_1450_ = _e677;
                                }
                                let _e679 = phi_1450_;
                                let _e685 = keys.member[_e172[0]];
                                let _e689 = keys.member[_e172[1]];
                                let _e691 = function_4(_e685[2], _e689[2]);
                                let _e694 = keys.member[_e172[2]];
                                let _e696 = function_4(_e691, _e694[2]);
                                let _e699 = keys.member[_e170[0]];
                                let _e703 = keys.member[_e170[1]];
                                let _e705 = function_5(_e699[5], _e703[5]);
                                let _e708 = keys.member[_e170[2]];
                                let _e710 = function_5(_e705, _e708[5]);
                                if (_e696[1] > _e710[1]) {
                                    phi_1546_ = true;
                                } else {
                                    if (_e696[1] == _e710[1]) {
                                        phi_1545_ = (_e696[0] > _e710[0]);
                                    } else {
                                        phi_1545_ = false;
                                    }
                                    let _e721 = phi_1545_;
                                    phi_1546_ = _e721;
                                }
                                let _e723 = phi_1546_;
                                let _e727 = keys.member[_e170[0]];
                                let _e731 = keys.member[_e170[1]];
                                let _e733 = function_4(_e727[2], _e731[2]);
                                let _e736 = keys.member[_e170[2]];
                                let _e738 = function_4(_e733, _e736[2]);
                                let _e741 = keys.member[_e172[0]];
                                let _e745 = keys.member[_e172[1]];
                                let _e747 = function_5(_e741[5], _e745[5]);
                                let _e750 = keys.member[_e172[2]];
                                let _e752 = function_5(_e747, _e750[5]);
                                if (_e738[1] > _e752[1]) {
                                    phi_1640_ = true;
                                } else {
                                    if (_e738[1] == _e752[1]) {
                                        phi_1639_ = (_e738[0] > _e752[0]);
                                    } else {
                                        phi_1639_ = false;
                                    }
                                    let _e763 = phi_1639_;
                                    phi_1640_ = _e763;
                                }
                                let _e765 = phi_1640_;
                                phi_1644_ = (((!(_e552) && !(_e594)) && (!(_e637) && !(_e679))) && (!(_e723) && !(_e765)));
                            }
                            let _e770 = phi_1644_;
                            phi_1645_ = _e770;
                            phi_1646_ = _e511;
                        } else {
                            phi_1645_ = bool();
                            phi_1646_ = true;
                        }
                        let _e772 = phi_1645_;
                        let _e774 = phi_1646_;
                        if _e774 {
                            phi_1650_ = false;
                        } else {
                            phi_1650_ = true;
                        }
                        let _e776 = phi_1650_;
                        phi_1651_ = _e772;
                        phi_1652_ = _e776;
                    } else {
                        phi_1651_ = false;
                        phi_1652_ = true;
                    }
                    let _e778 = phi_1651_;
                    let _e780 = phi_1652_;
                    phi_1653_ = _e778;
                    phi_1654_ = _e780;
                } else {
                    phi_1653_ = false;
                    phi_1654_ = true;
                }
                let _e782 = phi_1653_;
                let _e784 = phi_1654_;
                if _e784 {
                    phi_1658_ = _e782;
                } else {
                    phi_1658_ = true;
                }
                let _e786 = phi_1658_;
                if _e786 {
                    let _e788 = atomicAdd((&counters[1u]), 1u);
                    let _e790 = atomicAdd((&counters[0u]), 1u);
                    phi_1670_ = _e790;
                    phi_1671_ = true;
                } else {
                    phi_1670_ = 0u;
                    phi_1671_ = false;
                }
                let _e792 = phi_1670_;
                let _e794 = phi_1671_;
                phi_1672_ = _e792;
                phi_1673_ = _e794;
                phi_1674_ = type_9(_e126, _e129);
            } else {
                phi_1672_ = 0u;
                phi_1673_ = false;
                phi_1674_ = type_9(0u, 0u);
            }
            let _e796 = phi_1672_;
            let _e798 = phi_1673_;
            let _e800 = phi_1674_;
            workgroupBarrier();
            if (_e33 == 0u) {
                let _e803 = atomicLoad((&counters[0u]));
                let _e805 = atomicLoad((&counters[1u]));
                if (_e803 > 0u) {
                    let _e808 = atomicAdd((&output.member[0u]), _e803);
                    if ((_e808 + _e803) < _e808) {
                        let _e812 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e808);
                }
                if (_e805 > 0u) {
                    let _e816 = atomicAdd((&output.member[1u]), _e805);
                    if ((_e816 + _e805) < _e816) {
                        let _e820 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e798 {
                let _e822 = params.member.member_1.member_3;
                let _e824 = atomicLoad((&counters[2u]));
                let _e825 = (_e824 + _e796);
                if (_e825 < _e822) {
                    let _e829 = (2u * _e825);
                    atomicStore((&output.member[(4u + _e829)]), _e800.member);
                    atomicStore((&output.member[(_e829 + 5u)]), _e800.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_336_ = _e105;
            break if !(_e111);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_listed(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
