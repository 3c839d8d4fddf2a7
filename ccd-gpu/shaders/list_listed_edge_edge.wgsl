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
    member: array<array<u32, 2>>,
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
}

struct type_26 {
    member: type_7,
    member_1: type_8,
    member_2: type_25,
}

struct type_27 {
    member: type_26,
}

struct type_30 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> bodies: type_10;
@group(0) @binding(4) 
var<storage> keys: type_24;
@group(0) @binding(5) 
var<storage> input: type_10;
@group(0) @binding(6) 
var<storage, read_write> output: type_30;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_27;
@group(0) @binding(1) 
var<storage> boxes: type_21;
@group(0) @binding(2) 
var<storage> elements: type_17;

fn function_(param: array<u32, 2>, param_1: array<u32, 2>) -> array<u32, 2> {
    var phi_111_: bool;
    var phi_112_: bool;
    var phi_116_: array<u32, 2>;

    if (param[1] > param_1[1]) {
        phi_112_ = true;
    } else {
        if (param[1] == param_1[1]) {
            phi_111_ = (param[0] > param_1[0]);
        } else {
            phi_111_ = false;
        }
        let _e14 = phi_111_;
        phi_112_ = _e14;
    }
    let _e16 = phi_112_;
    if _e16 {
        phi_116_ = param_1;
    } else {
        phi_116_ = param;
    }
    let _e18 = phi_116_;
    return _e18;
}

fn function_1(param_2: array<u32, 2>, param_3: array<u32, 2>) -> array<u32, 2> {
    var phi_135_: bool;
    var phi_136_: bool;
    var phi_140_: array<u32, 2>;

    if (param_3[1] > param_2[1]) {
        phi_136_ = true;
    } else {
        if (param_3[1] == param_2[1]) {
            phi_135_ = (param_3[0] > param_2[0]);
        } else {
            phi_135_ = false;
        }
        let _e14 = phi_135_;
        phi_136_ = _e14;
    }
    let _e16 = phi_136_;
    if _e16 {
        phi_140_ = param_3;
    } else {
        phi_140_ = param_2;
    }
    let _e18 = phi_140_;
    return _e18;
}

fn function_2(param_4: array<u32, 2>, param_5: array<u32, 2>) -> array<u32, 2> {
    var phi_159_: bool;
    var phi_160_: bool;
    var phi_164_: array<u32, 2>;

    if (param_4[1] > param_5[1]) {
        phi_160_ = true;
    } else {
        if (param_4[1] == param_5[1]) {
            phi_159_ = (param_4[0] > param_5[0]);
        } else {
            phi_159_ = false;
        }
        let _e14 = phi_159_;
        phi_160_ = _e14;
    }
    let _e16 = phi_160_;
    if _e16 {
        phi_164_ = param_5;
    } else {
        phi_164_ = param_4;
    }
    let _e18 = phi_164_;
    return _e18;
}

fn function_3(param_6: array<u32, 2>, param_7: array<u32, 2>) -> array<u32, 2> {
    var phi_183_: bool;
    var phi_184_: bool;
    var phi_188_: array<u32, 2>;

    if (param_7[1] > param_6[1]) {
        phi_184_ = true;
    } else {
        if (param_7[1] == param_6[1]) {
            phi_183_ = (param_7[0] > param_6[0]);
        } else {
            phi_183_ = false;
        }
        let _e14 = phi_183_;
        phi_184_ = _e14;
    }
    let _e16 = phi_184_;
    if _e16 {
        phi_188_ = param_7;
    } else {
        phi_188_ = param_6;
    }
    let _e18 = phi_188_;
    return _e18;
}

fn function_4(param_8: array<u32, 2>, param_9: array<u32, 2>) -> array<u32, 2> {
    var phi_207_: bool;
    var phi_208_: bool;
    var phi_212_: array<u32, 2>;

    if (param_8[1] > param_9[1]) {
        phi_208_ = true;
    } else {
        if (param_8[1] == param_9[1]) {
            phi_207_ = (param_8[0] > param_9[0]);
        } else {
            phi_207_ = false;
        }
        let _e14 = phi_207_;
        phi_208_ = _e14;
    }
    let _e16 = phi_208_;
    if _e16 {
        phi_212_ = param_9;
    } else {
        phi_212_ = param_8;
    }
    let _e18 = phi_212_;
    return _e18;
}

fn function_5(param_10: array<u32, 2>, param_11: array<u32, 2>) -> array<u32, 2> {
    var phi_231_: bool;
    var phi_232_: bool;
    var phi_236_: array<u32, 2>;

    if (param_11[1] > param_10[1]) {
        phi_232_ = true;
    } else {
        if (param_11[1] == param_10[1]) {
            phi_231_ = (param_11[0] > param_10[0]);
        } else {
            phi_231_ = false;
        }
        let _e14 = phi_231_;
        phi_232_ = _e14;
    }
    let _e16 = phi_232_;
    if _e16 {
        phi_236_ = param_11;
    } else {
        phi_236_ = param_10;
    }
    let _e18 = phi_236_;
    return _e18;
}

fn function_6(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_278_: u32;
    var phi_288_: u32;
    var phi_295_: u32;
    var phi_311_: u32;
    var phi_332_: u32;
    var phi_333_: u32;
    var phi_336_: type_12;
    var phi_337_: type_12;
    var phi_360_: type_12;
    var phi_515_: bool;
    var phi_521_: bool;
    var phi_527_: bool;
    var phi_528_: bool;
    var phi_570_: bool;
    var phi_571_: bool;
    var phi_578_: bool;
    var phi_694_: bool;
    var phi_695_: bool;
    var phi_730_: u32;
    var phi_731_: u32;
    var phi_736_: type_14;
    var phi_739_: u32;
    var phi_741_: u32;
    var phi_762_: bool;
    var phi_768_: type_15;
    var phi_737_: type_14;
    var phi_782_: type_15;
    var phi_850_: bool;
    var phi_851_: bool;
    var phi_852_: bool;
    var phi_853_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_863_: u32;
    var phi_864_: u32;
    var phi_865_: u32;
    var phi_866_: u32;
    var phi_867_: bool;
    var phi_740_: u32;
    var phi_742_: u32;
    var phi_868_: bool;
    var local: u32;
    var local_1: u32;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_928_: bool;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_942_: bool;
    var phi_943_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1428_: bool;
    var phi_1429_: bool;
    var phi_1516_: bool;
    var phi_1517_: bool;
    var phi_1521_: bool;
    var phi_1522_: bool;
    var phi_1523_: bool;
    var phi_1527_: bool;
    var phi_1528_: bool;
    var phi_1529_: bool;
    var phi_1530_: bool;
    var phi_1531_: bool;
    var phi_1535_: bool;
    var phi_1547_: u32;
    var phi_1548_: bool;
    var phi_1549_: u32;
    var phi_1550_: bool;
    var phi_1551_: type_12;
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
        phi_278_ = _e51;
    } else {
        phi_278_ = _e53;
    }
    let _e56 = phi_278_;
    let _e58 = params.member.member_1.member_1;
    if (_e56 > _e58) {
        let _e61 = params.member.member_1.member_1;
        phi_288_ = (_e56 - _e61);
    } else {
        phi_288_ = 0u;
    }
    let _e64 = phi_288_;
    let _e66 = params.member.member_1.member;
    if (_e66 < _e64) {
        phi_295_ = _e66;
    } else {
        phi_295_ = _e64;
    }
    let _e69 = phi_295_;
    let _e70 = (_e69 / 128u);
    if ((_e69 % 128u) > 0u) {
        phi_311_ = (_e70 + 1u);
    } else {
        phi_311_ = _e70;
    }
    let _e75 = phi_311_;
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
            phi_332_ = (_e79 + 1u);
        } else {
            phi_332_ = _e79;
        }
        let _e85 = phi_332_;
        phi_333_ = _e85;
    } else {
        phi_333_ = 0u;
    }
    let _e87 = phi_333_;
    phi_336_ = type_12(0u, _e87);
    loop {
        let _e90 = phi_336_;
        if (_e90.member < _e90.member_1) {
            phi_337_ = type_12((_e90.member + 1u), _e90.member_1);
            phi_360_ = type_12(1u, _e90.member);
        } else {
            phi_337_ = _e90;
            phi_360_ = type_12(0u, type_12().member_1);
        }
        let _e102 = phi_337_;
        let _e104 = phi_360_;
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
                let _e129 = elements.member[_e123];
                let _e131 = elements.member[_e126];
                let _e141 = params.member.member.member_2[1u];
                let _e145 = params.member.member.member_2[1u];
                let _e148 = boxes.member[(_e141 + _e123)];
                let _e150 = boxes.member[(_e145 + _e126)];
                let _e153 = params.member.member.member_1;
                if ((_e153 & 1u) != 0u) {
                    if (_e131[0] == _e129[0]) {
                        phi_515_ = true;
                    } else {
                        phi_515_ = (_e131[0] == _e129[1]);
                    }
                    let _e159 = phi_515_;
                    if (_e131[1] == _e129[0]) {
                        phi_521_ = true;
                    } else {
                        phi_521_ = (_e131[1] == _e129[1]);
                    }
                    let _e163 = phi_521_;
                    if (_e159 || _e163) {
                        phi_527_ = false;
                    } else {
                        phi_527_ = true;
                    }
                    let _e166 = phi_527_;
                    phi_528_ = _e166;
                } else {
                    phi_528_ = true;
                }
                let _e168 = phi_528_;
                if _e168 {
                    let _e170 = params.member.member.member_1;
                    if ((_e170 & 2u) != 0u) {
                        let _e174 = bodies.member[_e129[0]];
                        let _e176 = bodies.member[_e131[0]];
                        if ((_e174 / 4u) != (_e176 / 4u)) {
                            phi_571_ = true;
                        } else {
                            if ((_e174 & 2u) == 0u) {
                                phi_570_ = false;
                            } else {
                                phi_570_ = true;
                            }
                            let _e183 = phi_570_;
                            phi_571_ = _e183;
                        }
                        let _e185 = phi_571_;
                        if _e185 {
                            phi_578_ = (((_e174 & _e176) & 1u) == 0u);
                        } else {
                            phi_578_ = false;
                        }
                        let _e190 = phi_578_;
                        if _e190 {
                            let _e192 = params.member.member.member_1;
                            if ((_e192 & 4u) != 0u) {
                                let _e197 = params.member.member.member[0u];
                                let _e199 = bodies.member[_e197];
                                let _e202 = bodies.member[(_e197 + 1u)];
                                let _e207 = ((_e197 + 4u) + (2u * (_e174 >> bitcast<u32>(2i))));
                                let _e212 = ((_e197 + 4u) + (2u * (_e176 >> bitcast<u32>(2i))));
                                let _e214 = bodies.member[_e207];
                                let _e216 = bodies.member[_e212];
                                let _e225 = bodies.member[((((_e197 + 4u) + (2u * _e199)) + (_e214 * _e202)) + (_e216 / 32u))];
                                let _e228 = bodies.member[(_e207 + 1u)];
                                let _e231 = bodies.member[(_e212 + 1u)];
                                if (_e228 == _e231) {
                                    if (((_e225 >> bitcast<u32>(((_e216 % 32u) & 31u))) & 1u) == 1u) {
                                        phi_694_ = true;
                                    } else {
                                        phi_694_ = ((_e174 >> bitcast<u32>(2i)) == (_e176 >> bitcast<u32>(2i)));
                                    }
                                    let _e245 = phi_694_;
                                    phi_695_ = _e245;
                                } else {
                                    phi_695_ = false;
                                }
                                let _e247 = phi_695_;
                                if _e247 {
                                    let _e250 = bodies.member[(_e197 + 2u)];
                                    let _e253 = bodies.member[(_e197 + 3u)];
                                    let _e254 = (_e253 + _e197);
                                    if (_e126 < _e123) {
                                        phi_730_ = _e123;
                                        phi_731_ = _e126;
                                    } else {
                                        phi_730_ = _e126;
                                        phi_731_ = _e123;
                                    }
                                    let _e257 = phi_730_;
                                    let _e259 = phi_731_;
                                    phi_736_ = type_14(0i, 32i);
                                    phi_739_ = _e250;
                                    phi_741_ = 0u;
                                    loop {
                                        let _e261 = phi_736_;
                                        let _e263 = phi_739_;
                                        let _e265 = phi_741_;
                                        local = _e265;
                                        local_1 = _e265;
                                        if (_e261.member < _e261.member_1) {
                                            let _e272 = (_e261.member + 1i);
                                            if ((false == (_e272 > _e261.member)) != false) {
                                                phi_762_ = true;
                                            } else {
                                                phi_762_ = false;
                                            }
                                            let _e277 = phi_762_;
                                            if _e277 {
                                                phi_768_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_768_ = type_15(1u, _e272);
                                            }
                                            let _e282 = phi_768_;
                                            phi_737_ = type_14(_e282.member_1, _e261.member_1);
                                            phi_782_ = type_15(1u, _e261.member);
                                        } else {
                                            phi_737_ = _e261;
                                            phi_782_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e288 = phi_737_;
                                        let _e290 = phi_782_;
                                        if (bitcast<i32>(_e290.member) != 0i) {
                                            if (_e265 >= _e263) {
                                                phi_865_ = u32();
                                                phi_866_ = u32();
                                                phi_867_ = false;
                                            } else {
                                                let _e297 = (_e265 + ((_e263 - _e265) / 2u));
                                                let _e299 = (_e254 + (3u * _e297));
                                                let _e301 = bodies.member[_e299];
                                                let _e304 = bodies.member[(_e299 + 1u)];
                                                let _e307 = bodies.member[(_e299 + 2u)];
                                                if (_e301 < 1u) {
                                                    phi_858_ = true;
                                                } else {
                                                    if (_e301 == 1u) {
                                                        if (_e304 < _e259) {
                                                            phi_852_ = false;
                                                        } else {
                                                            if (_e304 == _e259) {
                                                                if (_e307 < _e257) {
                                                                    phi_850_ = false;
                                                                } else {
                                                                    phi_850_ = true;
                                                                }
                                                                let _e314 = phi_850_;
                                                                phi_851_ = _e314;
                                                            } else {
                                                                phi_851_ = true;
                                                            }
                                                            let _e316 = phi_851_;
                                                            phi_852_ = _e316;
                                                        }
                                                        let _e318 = phi_852_;
                                                        phi_853_ = _e318;
                                                    } else {
                                                        phi_853_ = true;
                                                    }
                                                    let _e320 = phi_853_;
                                                    if _e320 {
                                                        phi_857_ = false;
                                                    } else {
                                                        phi_857_ = true;
                                                    }
                                                    let _e322 = phi_857_;
                                                    phi_858_ = _e322;
                                                }
                                                let _e324 = phi_858_;
                                                if _e324 {
                                                    phi_863_ = _e263;
                                                    phi_864_ = (_e297 + 1u);
                                                } else {
                                                    phi_863_ = _e297;
                                                    phi_864_ = _e265;
                                                }
                                                let _e327 = phi_863_;
                                                let _e329 = phi_864_;
                                                phi_865_ = _e327;
                                                phi_866_ = _e329;
                                                phi_867_ = true;
                                            }
                                            let _e331 = phi_865_;
                                            let _e333 = phi_866_;
                                            let _e335 = phi_867_;
                                            phi_740_ = _e331;
                                            phi_742_ = _e333;
                                            phi_868_ = _e335;
                                        } else {
                                            phi_740_ = u32();
                                            phi_742_ = u32();
                                            phi_868_ = false;
                                        }
                                        let _e337 = phi_740_;
                                        let _e339 = phi_742_;
                                        let _e341 = phi_868_;
                                        continue;
                                        continuing {
                                            phi_736_ = _e288;
                                            phi_739_ = _e337;
                                            phi_741_ = _e339;
                                            break if !(_e341);
                                        }
                                    }
                                    let _e344 = local;
                                    if (_e344 < _e250) {
                                        let _e347 = local_1;
                                        let _e349 = (_e254 + (3u * _e347));
                                        let _e351 = bodies.member[_e349];
                                        if (_e351 == 1u) {
                                            let _e355 = bodies.member[(_e349 + 1u)];
                                            if (_e355 == _e259) {
                                                let _e359 = bodies.member[(_e349 + 2u)];
                                                phi_916_ = (_e359 == _e257);
                                                phi_917_ = false;
                                            } else {
                                                phi_916_ = bool();
                                                phi_917_ = true;
                                            }
                                            let _e362 = phi_916_;
                                            let _e364 = phi_917_;
                                            phi_918_ = _e362;
                                            phi_919_ = _e364;
                                        } else {
                                            phi_918_ = bool();
                                            phi_919_ = true;
                                        }
                                        let _e366 = phi_918_;
                                        let _e368 = phi_919_;
                                        if _e368 {
                                            phi_923_ = false;
                                        } else {
                                            phi_923_ = _e366;
                                        }
                                        let _e370 = phi_923_;
                                        phi_924_ = _e370;
                                    } else {
                                        phi_924_ = false;
                                    }
                                    let _e372 = phi_924_;
                                    phi_928_ = _e372;
                                } else {
                                    phi_928_ = true;
                                }
                                let _e374 = phi_928_;
                                if _e374 {
                                    phi_932_ = false;
                                } else {
                                    phi_932_ = true;
                                }
                                let _e376 = phi_932_;
                                phi_933_ = _e376;
                            } else {
                                phi_933_ = true;
                            }
                            let _e378 = phi_933_;
                            if _e378 {
                                phi_937_ = false;
                            } else {
                                phi_937_ = true;
                            }
                            let _e380 = phi_937_;
                            phi_938_ = _e380;
                        } else {
                            phi_938_ = true;
                        }
                        let _e382 = phi_938_;
                        if _e382 {
                            phi_942_ = false;
                        } else {
                            phi_942_ = true;
                        }
                        let _e384 = phi_942_;
                        phi_943_ = _e384;
                    } else {
                        phi_943_ = true;
                    }
                    let _e386 = phi_943_;
                    if _e386 {
                        let _e388 = params.member.member.member_1;
                        if ((_e388 & 32u) != 0u) {
                            let _e392 = params.member.member.member_6;
                            let _e433 = (((((_e148.member_1[0] - _e150.member[0]) > _e392) && ((_e150.member_1[0] - _e148.member[0]) > _e392)) && (((_e148.member_1[1] - _e150.member[1]) > _e392) && ((_e150.member_1[1] - _e148.member[1]) > _e392))) && (((_e148.member_1[2] - _e150.member[2]) > _e392) && ((_e150.member_1[2] - _e148.member[2]) > _e392)));
                            if _e433 {
                                phi_1521_ = bool();
                            } else {
                                let _e435 = keys.member[_e129[0]];
                                let _e438 = keys.member[_e129[1]];
                                let _e440 = function_(_e435[0], _e438[0]);
                                let _e442 = keys.member[_e129[1]];
                                let _e444 = function_(_e440, _e442[0]);
                                let _e446 = keys.member[_e131[0]];
                                let _e449 = keys.member[_e131[1]];
                                let _e451 = function_1(_e446[3], _e449[3]);
                                let _e453 = keys.member[_e131[1]];
                                let _e455 = function_1(_e451, _e453[3]);
                                if (_e444[1] > _e455[1]) {
                                    phi_1074_ = true;
                                } else {
                                    if (_e444[1] == _e455[1]) {
                                        phi_1073_ = (_e444[0] > _e455[0]);
                                    } else {
                                        phi_1073_ = false;
                                    }
                                    let _e466 = phi_1073_;
                                    phi_1074_ = _e466;
                                }
                                let _e468 = phi_1074_;
                                let _e471 = keys.member[_e131[0]];
                                let _e474 = keys.member[_e131[1]];
                                let _e476 = function_(_e471[0], _e474[0]);
                                let _e478 = keys.member[_e131[1]];
                                let _e480 = function_(_e476, _e478[0]);
                                let _e482 = keys.member[_e129[0]];
                                let _e485 = keys.member[_e129[1]];
                                let _e487 = function_1(_e482[3], _e485[3]);
                                let _e489 = keys.member[_e129[1]];
                                let _e491 = function_1(_e487, _e489[3]);
                                if (_e480[1] > _e491[1]) {
                                    phi_1162_ = true;
                                } else {
                                    if (_e480[1] == _e491[1]) {
                                        phi_1161_ = (_e480[0] > _e491[0]);
                                    } else {
                                        phi_1161_ = false;
                                    }
                                    let _e502 = phi_1161_;
                                    phi_1162_ = _e502;
                                }
                                let _e504 = phi_1162_;
                                let _e508 = keys.member[_e129[0]];
                                let _e511 = keys.member[_e129[1]];
                                let _e513 = function_2(_e508[1], _e511[1]);
                                let _e515 = keys.member[_e129[1]];
                                let _e517 = function_2(_e513, _e515[1]);
                                let _e519 = keys.member[_e131[0]];
                                let _e522 = keys.member[_e131[1]];
                                let _e524 = function_3(_e519[4], _e522[4]);
                                let _e526 = keys.member[_e131[1]];
                                let _e528 = function_3(_e524, _e526[4]);
                                if (_e517[1] > _e528[1]) {
                                    phi_1251_ = true;
                                } else {
                                    if (_e517[1] == _e528[1]) {
                                        phi_1250_ = (_e517[0] > _e528[0]);
                                    } else {
                                        phi_1250_ = false;
                                    }
                                    let _e539 = phi_1250_;
                                    phi_1251_ = _e539;
                                }
                                let _e541 = phi_1251_;
                                let _e544 = keys.member[_e131[0]];
                                let _e547 = keys.member[_e131[1]];
                                let _e549 = function_2(_e544[1], _e547[1]);
                                let _e551 = keys.member[_e131[1]];
                                let _e553 = function_2(_e549, _e551[1]);
                                let _e555 = keys.member[_e129[0]];
                                let _e558 = keys.member[_e129[1]];
                                let _e560 = function_3(_e555[4], _e558[4]);
                                let _e562 = keys.member[_e129[1]];
                                let _e564 = function_3(_e560, _e562[4]);
                                if (_e553[1] > _e564[1]) {
                                    phi_1339_ = true;
                                } else {
                                    if (_e553[1] == _e564[1]) {
                                        phi_1338_ = (_e553[0] > _e564[0]);
                                    } else {
                                        phi_1338_ = false;
                                    }
                                    let _e575 = phi_1338_;
                                    phi_1339_ = _e575;
                                }
                                let _e577 = phi_1339_;
                                let _e582 = keys.member[_e129[0]];
                                let _e585 = keys.member[_e129[1]];
                                let _e587 = function_4(_e582[2], _e585[2]);
                                let _e589 = keys.member[_e129[1]];
                                let _e591 = function_4(_e587, _e589[2]);
                                let _e593 = keys.member[_e131[0]];
                                let _e596 = keys.member[_e131[1]];
                                let _e598 = function_5(_e593[5], _e596[5]);
                                let _e600 = keys.member[_e131[1]];
                                let _e602 = function_5(_e598, _e600[5]);
                                if (_e591[1] > _e602[1]) {
                                    phi_1429_ = true;
                                } else {
                                    if (_e591[1] == _e602[1]) {
                                        phi_1428_ = (_e591[0] > _e602[0]);
                                    } else {
                                        phi_1428_ = false;
                                    }
                                    let _e613 = phi_1428_;
                                    phi_1429_ = _e613;
                                }
                                let _e615 = phi_1429_;
                                let _e618 = keys.member[_e131[0]];
                                let _e621 = keys.member[_e131[1]];
                                let _e623 = function_4(_e618[2], _e621[2]);
                                let _e625 = keys.member[_e131[1]];
                                let _e627 = function_4(_e623, _e625[2]);
                                let _e629 = keys.member[_e129[0]];
                                let _e632 = keys.member[_e129[1]];
                                let _e634 = function_5(_e629[5], _e632[5]);
                                let _e636 = keys.member[_e129[1]];
                                let _e638 = function_5(_e634, _e636[5]);
                                if (_e627[1] > _e638[1]) {
                                    phi_1517_ = true;
                                } else {
                                    if (_e627[1] == _e638[1]) {
                                        phi_1516_ = (_e627[0] > _e638[0]);
                                    } else {
                                        phi_1516_ = false;
                                    }
                                    let _e649 = phi_1516_;
                                    phi_1517_ = _e649;
                                }
                                let _e651 = phi_1517_;
                                phi_1521_ = (((!(_e468) && !(_e504)) && (!(_e541) && !(_e577))) && (!(_e615) && !(_e651)));
                            }
                            let _e656 = phi_1521_;
                            phi_1522_ = _e656;
                            phi_1523_ = _e433;
                        } else {
                            phi_1522_ = bool();
                            phi_1523_ = true;
                        }
                        let _e658 = phi_1522_;
                        let _e660 = phi_1523_;
                        if _e660 {
                            phi_1527_ = false;
                        } else {
                            phi_1527_ = true;
                        }
                        let _e662 = phi_1527_;
                        phi_1528_ = _e658;
                        phi_1529_ = _e662;
                    } else {
                        phi_1528_ = false;
                        phi_1529_ = true;
                    }
                    let _e664 = phi_1528_;
                    let _e666 = phi_1529_;
                    phi_1530_ = _e664;
                    phi_1531_ = _e666;
                } else {
                    phi_1530_ = false;
                    phi_1531_ = true;
                }
                let _e668 = phi_1530_;
                let _e670 = phi_1531_;
                if _e670 {
                    phi_1535_ = _e668;
                } else {
                    phi_1535_ = true;
                }
                let _e672 = phi_1535_;
                if _e672 {
                    let _e674 = atomicAdd((&counters[1u]), 1u);
                    let _e676 = atomicAdd((&counters[0u]), 1u);
                    phi_1547_ = _e676;
                    phi_1548_ = true;
                } else {
                    phi_1547_ = 0u;
                    phi_1548_ = false;
                }
                let _e678 = phi_1547_;
                let _e680 = phi_1548_;
                phi_1549_ = _e678;
                phi_1550_ = _e680;
                phi_1551_ = type_12(_e123, _e126);
            } else {
                phi_1549_ = 0u;
                phi_1550_ = false;
                phi_1551_ = type_12(0u, 0u);
            }
            let _e682 = phi_1549_;
            let _e684 = phi_1550_;
            let _e686 = phi_1551_;
            workgroupBarrier();
            if (_e33 == 0u) {
                let _e689 = atomicLoad((&counters[0u]));
                let _e691 = atomicLoad((&counters[1u]));
                if (_e689 > 0u) {
                    let _e694 = atomicAdd((&output.member[0u]), _e689);
                    if ((_e694 + _e689) < _e694) {
                        let _e698 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e694);
                }
                if (_e691 > 0u) {
                    let _e702 = atomicAdd((&output.member[1u]), _e691);
                    if ((_e702 + _e691) < _e702) {
                        let _e706 = atomicAdd((&output.member[3u]), 1u);
                    }
                }
            }
            workgroupBarrier();
            if _e684 {
                let _e708 = params.member.member_1.member_3;
                let _e710 = atomicLoad((&counters[2u]));
                let _e711 = (_e710 + _e682);
                if (_e711 < _e708) {
                    let _e715 = (2u * _e711);
                    atomicStore((&output.member[(4u + _e715)]), _e686.member);
                    atomicStore((&output.member[(_e715 + 5u)]), _e686.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_336_ = _e102;
            break if !(_e108);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn list_listed_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_6(id, n, lane);
}
