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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_19 {
    member: array<type_17>,
}

struct type_22 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_23 {
    member: u32,
}

struct type_24 {
    member: type_7,
    member_1: type_8,
    member_2: type_23,
}

struct type_25 {
    member: type_24,
}

struct type_27 {
    member: array<array<u32, 3>>,
}

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_22;
@group(0) @binding(5) 
var<storage> input: type_10;
@group(0) @binding(6) 
var<storage, read_write> output: type_30;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_25;
@group(0) @binding(1) 
var<storage> boxes: type_19;
@group(0) @binding(2) 
var<storage> elements: type_27;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_112_: bool;
    var phi_113_: bool;
    var phi_117_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_113_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_112_ = (param[0] > param_1[0]);
        } else {
            phi_112_ = false;
        }
        let _e14 = phi_112_;
        phi_113_ = _e14;
    }
    let _e16 = phi_113_;
    if _e16 {
        phi_117_ = param_1;
    } else {
        phi_117_ = param;
    }
    let _e18 = phi_117_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_136_: bool;
    var phi_137_: bool;
    var phi_141_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_137_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_136_ = (param_3[0] > param_2[0]);
        } else {
            phi_136_ = false;
        }
        let _e14 = phi_136_;
        phi_137_ = _e14;
    }
    let _e16 = phi_137_;
    if _e16 {
        phi_141_ = param_3;
    } else {
        phi_141_ = param_2;
    }
    let _e18 = phi_141_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_160_: bool;
    var phi_161_: bool;
    var phi_165_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_161_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_160_ = (param_4[0] > param_5[0]);
        } else {
            phi_160_ = false;
        }
        let _e14 = phi_160_;
        phi_161_ = _e14;
    }
    let _e16 = phi_161_;
    if _e16 {
        phi_165_ = param_5;
    } else {
        phi_165_ = param_4;
    }
    let _e18 = phi_165_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_184_: bool;
    var phi_185_: bool;
    var phi_189_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_185_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_184_ = (param_7[0] > param_6[0]);
        } else {
            phi_184_ = false;
        }
        let _e14 = phi_184_;
        phi_185_ = _e14;
    }
    let _e16 = phi_185_;
    if _e16 {
        phi_189_ = param_7;
    } else {
        phi_189_ = param_6;
    }
    let _e18 = phi_189_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_208_: bool;
    var phi_209_: bool;
    var phi_213_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_209_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_208_ = (param_8[0] > param_9[0]);
        } else {
            phi_208_ = false;
        }
        let _e14 = phi_208_;
        phi_209_ = _e14;
    }
    let _e16 = phi_209_;
    if _e16 {
        phi_213_ = param_9;
    } else {
        phi_213_ = param_8;
    }
    let _e18 = phi_213_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_232_: bool;
    var phi_233_: bool;
    var phi_237_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_233_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_232_ = (param_11[0] > param_10[0]);
        } else {
            phi_232_ = false;
        }
        let _e14 = phi_232_;
        phi_233_ = _e14;
    }
    let _e16 = phi_233_;
    if _e16 {
        phi_237_ = param_11;
    } else {
        phi_237_ = param_10;
    }
    let _e18 = phi_237_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_279_: u32;
    var phi_289_: u32;
    var phi_296_: u32;
    var phi_312_: u32;
    var phi_333_: u32;
    var phi_334_: u32;
    var phi_337_: type_12;
    var phi_338_: type_12;
    var phi_361_: type_12;
    var phi_482_: bool;
    var phi_489_: bool;
    var phi_497_: bool;
    var phi_518_: bool;
    var phi_519_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_570_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_728_: type_14;
    var phi_731_: u32;
    var phi_733_: u32;
    var phi_754_: bool;
    var phi_760_: type_15;
    var phi_729_: type_14;
    var phi_774_: type_15;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_849_: bool;
    var phi_855_: u32;
    var phi_856_: u32;
    var phi_857_: u32;
    var phi_858_: u32;
    var phi_859_: bool;
    var phi_732_: u32;
    var phi_734_: u32;
    var phi_860_: bool;
    var local: u32;
    var local_1: u32;
    var phi_908_: bool;
    var phi_909_: bool;
    var phi_910_: bool;
    var phi_911_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_920_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1435_: bool;
    var phi_1436_: bool;
    var phi_1526_: bool;
    var phi_1527_: bool;
    var phi_1531_: bool;
    var phi_1532_: bool;
    var phi_1533_: bool;
    var phi_1537_: bool;
    var phi_1538_: bool;
    var phi_1539_: bool;
    var phi_1540_: bool;
    var phi_1541_: bool;
    var phi_1545_: bool;
    var phi_1557_: u32;
    var phi_1558_: bool;
    var phi_1559_: u32;
    var phi_1560_: bool;
    var phi_1561_: type_12;
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
    let _e51 = params.member.member_1.member_2;
    let _e53 = input.member[0u];
    if (_e51 < _e53) {
        phi_279_ = _e51;
    } else {
        phi_279_ = _e53;
    }
    let _e56 = phi_279_;
    let _e58 = params.member.member_1.member_1;
    if (_e56 > _e58) {
        let _e61 = params.member.member_1.member_1;
        phi_289_ = (_e56 - _e61);
    } else {
        phi_289_ = 0u;
    }
    let _e64 = phi_289_;
    let _e66 = params.member.member_1.member;
    if (_e66 < _e64) {
        phi_296_ = _e66;
    } else {
        phi_296_ = _e64;
    }
    let _e69 = phi_296_;
    let _e70 = (_e69 / 128u);
    if ((_e69 % 128u) > 0u) {
        phi_312_ = (_e70 + 1u);
    } else {
        phi_312_ = _e70;
    }
    let _e75 = phi_312_;
    if (_e75 > _e45) {
        let _e77 = (_e75 - _e45);
        if (_e48 == 0u) {
            return;
        }
        let _e79 = (_e77 / _e48);
        if (_e48 == 0u) {
            return;
        }
        if ((_e77 % _e48) > 0u) {
            phi_333_ = (_e79 + 1u);
        } else {
            phi_333_ = _e79;
        }
        let _e85 = phi_333_;
        phi_334_ = _e85;
    } else {
        phi_334_ = 0u;
    }
    let _e87 = phi_334_;
    phi_337_ = type_12(0u, _e87);
    loop {
        let _e90 = phi_337_;
        if (_e90.member < _e90.member_1) {
            phi_338_ = type_12((_e90.member + 1u), _e90.member_1);
            phi_361_ = type_12(1u, _e90.member);
        } else {
            phi_338_ = _e90;
            phi_361_ = type_12(0u, type_12().member_1);
        }
        let _e102 = phi_338_;
        let _e104 = phi_361_;
        let _e108 = (bitcast<i32>(_e104.member) != 0i);
        if _e108 {
            let _e112 = (((_e45 + (_e104.member_1 * _e48)) * 128u) + _e33);
            if (_e33 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e112 < _e69) {
                let _e118 = params.member.member_1.member_1;
                let _e120 = (2u * (_e118 + _e112));
                let _e123 = input.member[(4u + _e120)];
                let _e126 = input.member[(_e120 + 5u)];
                let _e129 = elements.member[_e126];
                let _e133 = params.member.member.member_2[2u];
                let _e136 = boxes.member[_e123];
                let _e138 = boxes.member[(_e133 + _e126)];
                let _e141 = params.member.member.member_1;
                if ((_e141 & 1u) != 0u) {
                    if (_e129[0] == _e123) {
                        phi_482_ = true;
                    } else {
                        phi_482_ = (_e129[0] == _e123);
                    }
                    let _e148 = phi_482_;
                    if (_e129[1] == _e123) {
                        phi_489_ = true;
                    } else {
                        phi_489_ = (_e129[1] == _e123);
                    }
                    let _e153 = phi_489_;
                    if (_e129[2] == _e123) {
                        phi_497_ = true;
                    } else {
                        phi_497_ = (_e129[2] == _e123);
                    }
                    let _e159 = phi_497_;
                    if ((_e148 || _e153) || _e159) {
                        phi_518_ = false;
                    } else {
                        phi_518_ = true;
                    }
                    let _e162 = phi_518_;
                    phi_519_ = _e162;
                } else {
                    phi_519_ = true;
                }
                let _e164 = phi_519_;
                if _e164 {
                    let _e166 = params.member.member.member_1;
                    if ((_e166 & 2u) != 0u) {
                        let _e170 = bodies.member[_e123];
                        let _e173 = bodies.member[_e129[0]];
                        if ((_e170 / 4u) != (_e173 / 4u)) {
                            phi_563_ = true;
                        } else {
                            if ((_e170 & 2u) == 0u) {
                                phi_562_ = false;
                            } else {
                                phi_562_ = true;
                            }
                            let _e180 = phi_562_;
                            phi_563_ = _e180;
                        }
                        let _e182 = phi_563_;
                        if _e182 {
                            phi_570_ = (((_e170 & _e173) & 1u) == 0u);
                        } else {
                            phi_570_ = false;
                        }
                        let _e187 = phi_570_;
                        if _e187 {
                            let _e189 = params.member.member.member_1;
                            if ((_e189 & 4u) != 0u) {
                                let _e194 = params.member.member.member[0u];
                                let _e196 = bodies.member[_e194];
                                let _e199 = bodies.member[(_e194 + 1u)];
                                let _e204 = ((_e194 + 4u) + (2u * (_e170 >> bitcast<u32>(2i))));
                                let _e209 = ((_e194 + 4u) + (2u * (_e173 >> bitcast<u32>(2i))));
                                let _e211 = bodies.member[_e204];
                                let _e213 = bodies.member[_e209];
                                let _e222 = bodies.member[((((_e194 + 4u) + (2u * _e196)) + (_e211 * _e199)) + (_e213 / 32u))];
                                let _e225 = bodies.member[(_e204 + 1u)];
                                let _e228 = bodies.member[(_e209 + 1u)];
                                if (_e225 == _e228) {
                                    if (((_e222 >> bitcast<u32>(((_e213 % 32u) & 31u))) & 1u) == 1u) {
                                        phi_686_ = true;
                                    } else {
                                        phi_686_ = ((_e170 >> bitcast<u32>(2i)) == (_e173 >> bitcast<u32>(2i)));
                                    }
                                    let _e242 = phi_686_;
                                    phi_687_ = _e242;
                                } else {
                                    phi_687_ = false;
                                }
                                let _e244 = phi_687_;
                                if _e244 {
                                    let _e247 = bodies.member[(_e194 + 2u)];
                                    let _e250 = bodies.member[(_e194 + 3u)];
                                    let _e251 = (_e250 + _e194);
                                    phi_728_ = type_14(0i, 32i);
                                    phi_731_ = _e247;
                                    phi_733_ = 0u;
                                    loop {
                                        let _e253 = phi_728_;
                                        let _e255 = phi_731_;
                                        let _e257 = phi_733_;
                                        local = _e257;
                                        local_1 = _e257;
                                        if (_e253.member < _e253.member_1) {
                                            let _e264 = (_e253.member + 1i);
                                            if ((false == (_e264 > _e253.member)) != false) {
                                                phi_754_ = true;
                                            } else {
                                                phi_754_ = false;
                                            }
                                            let _e269 = phi_754_;
                                            if _e269 {
                                                phi_760_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_760_ = type_15(1u, _e264);
                                            }
                                            let _e274 = phi_760_;
                                            phi_729_ = type_14(_e274.member_1, _e253.member_1);
                                            phi_774_ = type_15(1u, _e253.member);
                                        } else {
                                            phi_729_ = _e253;
                                            phi_774_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e280 = phi_729_;
                                        let _e282 = phi_774_;
                                        if (bitcast<i32>(_e282.member) != 0i) {
                                            if (_e257 >= _e255) {
                                                phi_857_ = u32();
                                                phi_858_ = u32();
                                                phi_859_ = false;
                                            } else {
                                                let _e289 = (_e257 + ((_e255 - _e257) / 2u));
                                                let _e291 = (_e251 + (3u * _e289));
                                                let _e293 = bodies.member[_e291];
                                                let _e296 = bodies.member[(_e291 + 1u)];
                                                let _e299 = bodies.member[(_e291 + 2u)];
                                                if (_e293 == 0u) {
                                                    if (_e296 < _e123) {
                                                        phi_844_ = false;
                                                    } else {
                                                        if (_e296 == _e123) {
                                                            if (_e299 < _e126) {
                                                                phi_842_ = false;
                                                            } else {
                                                                phi_842_ = true;
                                                            }
                                                            let _e305 = phi_842_;
                                                            phi_843_ = _e305;
                                                        } else {
                                                            phi_843_ = true;
                                                        }
                                                        let _e307 = phi_843_;
                                                        phi_844_ = _e307;
                                                    }
                                                    let _e309 = phi_844_;
                                                    phi_845_ = _e309;
                                                } else {
                                                    phi_845_ = true;
                                                }
                                                let _e311 = phi_845_;
                                                if _e311 {
                                                    phi_849_ = false;
                                                } else {
                                                    phi_849_ = true;
                                                }
                                                let _e313 = phi_849_;
                                                if _e313 {
                                                    phi_855_ = _e255;
                                                    phi_856_ = (_e289 + 1u);
                                                } else {
                                                    phi_855_ = _e289;
                                                    phi_856_ = _e257;
                                                }
                                                let _e316 = phi_855_;
                                                let _e318 = phi_856_;
                                                phi_857_ = _e316;
                                                phi_858_ = _e318;
                                                phi_859_ = true;
                                            }
                                            let _e320 = phi_857_;
                                            let _e322 = phi_858_;
                                            let _e324 = phi_859_;
                                            phi_732_ = _e320;
                                            phi_734_ = _e322;
                                            phi_860_ = _e324;
                                        } else {
                                            phi_732_ = u32();
                                            phi_734_ = u32();
                                            phi_860_ = false;
                                        }
                                        let _e326 = phi_732_;
                                        let _e328 = phi_734_;
                                        let _e330 = phi_860_;
                                        continue;
                                        continuing {
                                            phi_728_ = _e280;
                                            phi_731_ = _e326;
                                            phi_733_ = _e328;
                                            break if !(_e330);
                                        }
                                    }
                                    let _e333 = local;
                                    if (_e333 < _e247) {
                                        let _e336 = local_1;
                                        let _e338 = (_e251 + (3u * _e336));
                                        let _e340 = bodies.member[_e338];
                                        if (_e340 == 0u) {
                                            let _e344 = bodies.member[(_e338 + 1u)];
                                            if (_e344 == _e123) {
                                                let _e348 = bodies.member[(_e338 + 2u)];
                                                phi_908_ = (_e348 == _e126);
                                                phi_909_ = false;
                                            } else {
                                                phi_908_ = bool();
                                                phi_909_ = true;
                                            }
                                            let _e351 = phi_908_;
                                            let _e353 = phi_909_;
                                            phi_910_ = _e351;
                                            phi_911_ = _e353;
                                        } else {
                                            phi_910_ = bool();
                                            phi_911_ = true;
                                        }
                                        let _e355 = phi_910_;
                                        let _e357 = phi_911_;
                                        if _e357 {
                                            phi_915_ = false;
                                        } else {
                                            phi_915_ = _e355;
                                        }
                                        let _e359 = phi_915_;
                                        phi_916_ = _e359;
                                    } else {
                                        phi_916_ = false;
                                    }
                                    let _e361 = phi_916_;
                                    phi_920_ = _e361;
                                } else {
                                    phi_920_ = true;
                                }
                                let _e363 = phi_920_;
                                if _e363 {
                                    phi_924_ = false;
                                } else {
                                    phi_924_ = true;
                                }
                                let _e365 = phi_924_;
                                phi_925_ = _e365;
                            } else {
                                phi_925_ = true;
                            }
                            let _e367 = phi_925_;
                            if _e367 {
                                phi_929_ = false;
                            } else {
                                phi_929_ = true;
                            }
                            let _e369 = phi_929_;
                            phi_930_ = _e369;
                        } else {
                            phi_930_ = true;
                        }
                        let _e371 = phi_930_;
                        if _e371 {
                            phi_934_ = false;
                        } else {
                            phi_934_ = true;
                        }
                        let _e373 = phi_934_;
                        phi_935_ = _e373;
                    } else {
                        phi_935_ = true;
                    }
                    let _e375 = phi_935_;
                    if _e375 {
                        let _e377 = params.member.member.member_1;
                        if ((_e377 & 32u) != 0u) {
                            let _e381 = params.member.member.member_6;
                            let _e422 = (((((_e136.member_1[0] - _e138.member[0]) > _e381) && ((_e138.member_1[0] - _e136.member[0]) > _e381)) && (((_e136.member_1[1] - _e138.member[1]) > _e381) && ((_e138.member_1[1] - _e136.member[1]) > _e381))) && (((_e136.member_1[2] - _e138.member[2]) > _e381) && ((_e138.member_1[2] - _e136.member[2]) > _e381)));
                            if _e422 {
                                phi_1531_ = bool();
                            } else {
                                let _e424 = keys.member[_e123];
                                let _e427 = keys.member[_e123];
                                let _e429 = function_(_e424[0], _e427[0]);
                                let _e431 = keys.member[_e123];
                                let _e433 = function_(_e429, _e431[0]);
                                let _e436 = keys.member[_e129[0]];
                                let _e440 = keys.member[_e129[1]];
                                let _e442 = function_1(_e436[3], _e440[3]);
                                let _e445 = keys.member[_e129[2]];
                                let _e447 = function_1(_e442, _e445[3]);
                                if (_e433[1] > _e447[1]) {
                                    phi_1069_ = true;
                                } else {
                                    if (_e433[1] == _e447[1]) {
                                        phi_1068_ = (_e433[0] > _e447[0]);
                                    } else {
                                        phi_1068_ = false;
                                    }
                                    let _e458 = phi_1068_;
                                    phi_1069_ = _e458;
                                }
                                let _e460 = phi_1069_;
                                let _e464 = keys.member[_e129[0]];
                                let _e468 = keys.member[_e129[1]];
                                let _e470 = function_(_e464[0], _e468[0]);
                                let _e473 = keys.member[_e129[2]];
                                let _e475 = function_(_e470, _e473[0]);
                                let _e477 = keys.member[_e123];
                                let _e480 = keys.member[_e123];
                                let _e482 = function_1(_e477[3], _e480[3]);
                                let _e484 = keys.member[_e123];
                                let _e486 = function_1(_e482, _e484[3]);
                                if (_e475[1] > _e486[1]) {
                                    phi_1160_ = true;
                                } else {
                                    if (_e475[1] == _e486[1]) {
                                        phi_1159_ = (_e475[0] > _e486[0]);
                                    } else {
                                        phi_1159_ = false;
                                    }
                                    let _e497 = phi_1159_;
                                    phi_1160_ = _e497;
                                }
                                let _e499 = phi_1160_;
                                let _e503 = keys.member[_e123];
                                let _e506 = keys.member[_e123];
                                let _e508 = function_2(_e503[1], _e506[1]);
                                let _e510 = keys.member[_e123];
                                let _e512 = function_2(_e508, _e510[1]);
                                let _e515 = keys.member[_e129[0]];
                                let _e519 = keys.member[_e129[1]];
                                let _e521 = function_3(_e515[4], _e519[4]);
                                let _e524 = keys.member[_e129[2]];
                                let _e526 = function_3(_e521, _e524[4]);
                                if (_e512[1] > _e526[1]) {
                                    phi_1252_ = true;
                                } else {
                                    if (_e512[1] == _e526[1]) {
                                        phi_1251_ = (_e512[0] > _e526[0]);
                                    } else {
                                        phi_1251_ = false;
                                    }
                                    let _e537 = phi_1251_;
                                    phi_1252_ = _e537;
                                }
                                let _e539 = phi_1252_;
                                let _e543 = keys.member[_e129[0]];
                                let _e547 = keys.member[_e129[1]];
                                let _e549 = function_2(_e543[1], _e547[1]);
                                let _e552 = keys.member[_e129[2]];
                                let _e554 = function_2(_e549, _e552[1]);
                                let _e556 = keys.member[_e123];
                                let _e559 = keys.member[_e123];
                                let _e561 = function_3(_e556[4], _e559[4]);
                                let _e563 = keys.member[_e123];
                                let _e565 = function_3(_e561, _e563[4]);
                                if (_e554[1] > _e565[1]) {
                                    phi_1343_ = true;
                                } else {
                                    if (_e554[1] == _e565[1]) {
                                        phi_1342_ = (_e554[0] > _e565[0]);
                                    } else {
                                        phi_1342_ = false;
                                    }
                                    let _e576 = phi_1342_;
                                    phi_1343_ = _e576;
                                }
                                let _e578 = phi_1343_;
                                let _e583 = keys.member[_e123];
                                let _e586 = keys.member[_e123];
                                let _e588 = function_4(_e583[2], _e586[2]);
                                let _e590 = keys.member[_e123];
                                let _e592 = function_4(_e588, _e590[2]);
                                let _e595 = keys.member[_e129[0]];
                                let _e599 = keys.member[_e129[1]];
                                let _e601 = function_5(_e595[5], _e599[5]);
                                let _e604 = keys.member[_e129[2]];
                                let _e606 = function_5(_e601, _e604[5]);
                                if (_e592[1] > _e606[1]) {
                                    phi_1436_ = true;
                                } else {
                                    if (_e592[1] == _e606[1]) {
                                        phi_1435_ = (_e592[0] > _e606[0]);
                                    } else {
                                        phi_1435_ = false;
                                    }
                                    let _e617 = phi_1435_;
                                    phi_1436_ = _e617;
                                }
                                let _e619 = phi_1436_;
                                let _e623 = keys.member[_e129[0]];
                                let _e627 = keys.member[_e129[1]];
                                let _e629 = function_4(_e623[2], _e627[2]);
                                let _e632 = keys.member[_e129[2]];
                                let _e634 = function_4(_e629, _e632[2]);
                                let _e636 = keys.member[_e123];
                                let _e639 = keys.member[_e123];
                                let _e641 = function_5(_e636[5], _e639[5]);
                                let _e643 = keys.member[_e123];
                                let _e645 = function_5(_e641, _e643[5]);
                                if (_e634[1] > _e645[1]) {
                                    phi_1527_ = true;
                                } else {
                                    if (_e634[1] == _e645[1]) {
                                        phi_1526_ = (_e634[0] > _e645[0]);
                                    } else {
                                        phi_1526_ = false;
                                    }
                                    let _e656 = phi_1526_;
                                    phi_1527_ = _e656;
                                }
                                let _e658 = phi_1527_;
                                phi_1531_ = (((!(_e460) && !(_e499)) && (!(_e539) && !(_e578))) && (!(_e619) && !(_e658)));
                            }
                            let _e663 = phi_1531_;
                            phi_1532_ = _e663;
                            phi_1533_ = _e422;
                        } else {
                            phi_1532_ = bool();
                            phi_1533_ = true;
                        }
                        let _e665 = phi_1532_;
                        let _e667 = phi_1533_;
                        if _e667 {
                            phi_1537_ = false;
                        } else {
                            phi_1537_ = true;
                        }
                        let _e669 = phi_1537_;
                        phi_1538_ = _e665;
                        phi_1539_ = _e669;
                    } else {
                        phi_1538_ = false;
                        phi_1539_ = true;
                    }
                    let _e671 = phi_1538_;
                    let _e673 = phi_1539_;
                    phi_1540_ = _e671;
                    phi_1541_ = _e673;
                } else {
                    phi_1540_ = false;
                    phi_1541_ = true;
                }
                let _e675 = phi_1540_;
                let _e677 = phi_1541_;
                if _e677 {
                    phi_1545_ = _e675;
                } else {
                    phi_1545_ = true;
                }
                let _e679 = phi_1545_;
                if _e679 {
                    let _e681 = atomicAdd((&counters[1u]), 1u);
                    let _e683 = atomicAdd((&counters[0u]), 1u);
                    phi_1557_ = _e683;
                    phi_1558_ = true;
                } else {
                    phi_1557_ = 0u;
                    phi_1558_ = false;
                }
                let _e685 = phi_1557_;
                let _e687 = phi_1558_;
                phi_1559_ = _e685;
                phi_1560_ = _e687;
                phi_1561_ = type_12(_e123, _e126);
            } else {
                phi_1559_ = 0u;
                phi_1560_ = false;
                phi_1561_ = type_12(0u, 0u);
            }
            let _e689 = phi_1559_;
            let _e691 = phi_1560_;
            let _e693 = phi_1561_;
            workgroupBarrier();
            if (_e33 == 0u) {
                let _e696 = atomicLoad((&counters[0u]));
                let _e698 = atomicLoad((&counters[1u]));
                if (_e696 > 0u) {
                    let _e701 = atomicAdd((&output.member[0u]), _e696);
                    if ((_e701 + _e696) < _e701) {
                        let _e705 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e701);
                }
                if (_e698 > 0u) {
                    let _e709 = atomicAdd((&output.member[1u]), _e698);
                    if ((_e709 + _e698) < _e709) {
                        let _e713 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e691 {
                let _e715 = params.member.member_1.member_3;
                let _e717 = atomicLoad((&counters[2u]));
                let _e718 = (_e717 + _e689);
                if (_e718 < _e715) {
                    let _e722 = (2u * _e718);
                    atomicStore((&output.member[(4u + _e722)]), _e693.member);
                    atomicStore((&output.member[(_e722 + 5u)]), _e693.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_337_ = _e102;
            break if !(_e108);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_listed_vertex_face(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
