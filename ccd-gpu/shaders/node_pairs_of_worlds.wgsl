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

struct type_11 {
    member: array<u32>,
}

struct type_16 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_31 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_22;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> hits: array<u32, 2048>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(2) 
var<storage> worlds: type_11;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> output: type_31;
var<workgroup> ranges: array<u32, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var phi_161_: u32;
    var phi_198_: u32;
    var phi_199_: u32;
    var phi_207_: u32;
    var phi_223_: u32;
    var phi_246_: u32;
    var phi_247_: u32;
    var phi_250_: type_9;
    var phi_251_: type_9;
    var phi_274_: type_9;
    var phi_321_: u32;
    var phi_322_: u32;
    var phi_330_: u32;
    var phi_344_: u32;
    var phi_401_: array<u32, 2>;
    var phi_425_: type_9;
    var phi_428_: u32;
    var phi_426_: type_9;
    var phi_451_: type_9;
    var phi_429_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_469_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_478_: u32;
    var phi_521_: type_9;
    var phi_524_: u32;
    var phi_522_: type_9;
    var phi_547_: type_9;
    var phi_525_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_565_: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_574_: u32;
    var phi_619_: array<u32, 2>;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_822_: type_24;
    var phi_831_: bool;
    var phi_840_: type_9;
    var phi_843_: u32;
    var phi_841_: type_9;
    var phi_866_: type_9;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_938_: bool;
    var phi_955_: bool;
    var phi_973_: u32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_844_: u32;
    var phi_979_: type_9;
    var phi_982_: u32;
    var phi_980_: type_9;
    var phi_1005_: type_9;
    var phi_1055_: u32;
    var phi_1056_: bool;
    var phi_983_: u32;
    var phi_1057_: bool;
    var phi_1064_: u32;
    var phi_1098_: type_9;
    var phi_1099_: type_9;
    var phi_1122_: type_9;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var local_9: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e42 = id_2;
    let _e43 = n_2;
    let _e44 = lane_2;
    let _e54 = ((_e42.y * _e43.x) + _e42.x);
    let _e57 = (_e43.x * _e43.y);
    let _e61 = params.member.member_1.member_2;
    let _e63 = input.member[0u];
    if (_e61 < _e63) {
        phi_161_ = _e61;
    } else {
        phi_161_ = _e63;
    }
    let _e66 = phi_161_;
    let _e67 = (_e44 / 32u);
    let _e68 = (_e44 % 32u);
    let _e71 = params.member.member_1.member_1;
    if (_e66 > _e71) {
        let _e75 = params.member.member_1.member_1;
        let _e76 = (_e66 - _e75);
        let _e79 = params.member.member_2.member_3;
        if (_e79 == 0u) {
            return;
        }
        let _e81 = (_e76 / _e79);
        if (_e79 == 0u) {
            return;
        }
        if ((_e76 % _e79) > 0u) {
            phi_198_ = (_e81 + 1u);
        } else {
            phi_198_ = _e81;
        }
        let _e87 = phi_198_;
        phi_199_ = _e87;
    } else {
        phi_199_ = 0u;
    }
    let _e89 = phi_199_;
    let _e92 = params.member.member_2.member_4;
    if (_e92 < _e89) {
        phi_207_ = _e92;
    } else {
        phi_207_ = _e89;
    }
    let _e95 = phi_207_;
    let _e96 = (_e95 / 4u);
    if ((_e95 % 4u) > 0u) {
        phi_223_ = (_e96 + 1u);
    } else {
        phi_223_ = _e96;
    }
    let _e101 = phi_223_;
    if (_e101 > _e54) {
        let _e103 = (_e101 - _e54);
        if (_e57 == 0u) {
            return;
        }
        let _e105 = (_e103 / _e57);
        if (_e57 == 0u) {
            return;
        }
        if ((_e103 % _e57) > 0u) {
            phi_246_ = (_e105 + 1u);
        } else {
            phi_246_ = _e105;
        }
        let _e111 = phi_246_;
        phi_247_ = _e111;
    } else {
        phi_247_ = 0u;
    }
    let _e113 = phi_247_;
    phi_250_ = type_9(0u, _e113);
    loop {
        let _e116 = phi_250_;
        if (_e116.member < _e116.member_1) {
            phi_251_ = type_9((_e116.member + 1u), _e116.member_1);
            phi_274_ = type_9(1u, _e116.member);
        } else {
            phi_251_ = _e116;
            phi_274_ = type_9(0u, type_9().member_1);
        }
        let _e128 = phi_251_;
        let _e130 = phi_274_;
        let _e134 = (bitcast<i32>(_e130.member) != 0i);
        if _e134 {
            let _e139 = (((_e54 + (_e130.member_1 * _e57)) * 4u) + (_e44 / 32u));
            let _e142 = params.member.member_1.member_1;
            if (_e66 > _e142) {
                let _e146 = params.member.member_1.member_1;
                let _e147 = (_e66 - _e146);
                let _e150 = params.member.member_2.member_3;
                if (_e150 == 0u) {
                    return;
                }
                let _e152 = (_e147 / _e150);
                if (_e150 == 0u) {
                    return;
                }
                if ((_e147 % _e150) > 0u) {
                    phi_321_ = (_e152 + 1u);
                } else {
                    phi_321_ = _e152;
                }
                let _e158 = phi_321_;
                phi_322_ = _e158;
            } else {
                phi_322_ = 0u;
            }
            let _e160 = phi_322_;
            let _e163 = params.member.member_2.member_4;
            if (_e163 < _e160) {
                phi_330_ = _e163;
            } else {
                phi_330_ = _e160;
            }
            let _e166 = phi_330_;
            let _e167 = (_e139 < _e166);
            let _e170 = params.member.member_1.member_1;
            let _e173 = params.member.member_2.member_3;
            if _e167 {
                phi_344_ = (_e139 * _e173);
            } else {
                phi_344_ = 0u;
            }
            let _e176 = phi_344_;
            let _e178 = (2u * (_e170 + _e176));
            let _e181 = input.member[(4u + _e178)];
            let _e184 = input.member[(_e178 + 5u)];
            if (_e44 < 8u) {
                atomicStore((&counters[_e44]), 0u);
            }
            workgroupBarrier();
            if (_e68 == 0u) {
                firsts[(2u * _e67)] = (_e181 * 32u);
                firsts[((2u * _e67) + 1u)] = (_e184 * 32u);
            }
            let _e197 = params.member.member_2.member_1;
            if (_e197 == 0u) {
                phi_401_ = array<u32, 2>(0u, 2u);
            } else {
                phi_401_ = array<u32, 2>(1u, 1u);
            }
            let _e200 = phi_401_;
            let _e203 = params.member.member_2.member_2;
            let _e204 = (_e203 - 1u);
            let _e207 = params.member.member.member;
            local = array<u32, 3>(_e207[0], _e207[1], _e207[2]);
            let _e215 = ((_e181 * 32u) + _e68);
            let _e217 = local[_e200[0]];
            phi_425_ = type_9(0u, _e204);
            phi_428_ = 1u;
            loop {
                let _e220 = phi_425_;
                let _e222 = phi_428_;
                local_1 = _e222;
                local_2 = _e222;
                local_3 = _e222;
                local_4 = _e222;
                if (_e220.member < _e220.member_1) {
                    phi_426_ = type_9((_e220.member + 1u), _e220.member_1);
                    phi_451_ = type_9(1u, _e220.member);
                } else {
                    phi_426_ = _e220;
                    phi_451_ = type_9(0u, type_9().member_1);
                }
                let _e234 = phi_426_;
                let _e236 = phi_451_;
                let _e239 = (bitcast<i32>(_e236.member) != 0i);
                if _e239 {
                    phi_429_ = (_e222 * 32u);
                } else {
                    phi_429_ = u32();
                }
                let _e242 = phi_429_;
                continue;
                continuing {
                    phi_425_ = _e234;
                    phi_428_ = _e242;
                    break if !(_e239);
                }
            }
            let _e246 = local_1;
            if (_e246 == 0u) {
                return;
            }
            let _e249 = local_2;
            let _e250 = ((_e217 - 1u) / _e249);
            if (_e250 < _e215) {
                phi_469_ = _e250;
            } else {
                phi_469_ = _e215;
            }
            let _e253 = phi_469_;
            let _e255 = local_3;
            let _e256 = (_e253 * _e255);
            let _e258 = local_4;
            let _e260 = (_e256 + (_e258 - 1u));
            let _e261 = (_e217 - 1u);
            if (_e261 < _e260) {
                phi_478_ = _e261;
            } else {
                phi_478_ = _e260;
            }
            let _e264 = phi_478_;
            let _e268 = params.member.member_2.member[0u][_e200[0]];
            let _e271 = worlds.member[(_e268 + _e256)];
            let _e276 = worlds.member[(_e268 + _e264)];
            let _e277 = ((_e271 << bitcast<u32>(16i)) | _e276);
            let _e279 = ((_e184 * 32u) + _e68);
            let _e281 = local[_e200[1]];
            phi_521_ = type_9(0u, _e204);
            phi_524_ = 1u;
            loop {
                let _e284 = phi_521_;
                let _e286 = phi_524_;
                local_5 = _e286;
                local_6 = _e286;
                local_7 = _e286;
                local_8 = _e286;
                if (_e284.member < _e284.member_1) {
                    phi_522_ = type_9((_e284.member + 1u), _e284.member_1);
                    phi_547_ = type_9(1u, _e284.member);
                } else {
                    phi_522_ = _e284;
                    phi_547_ = type_9(0u, type_9().member_1);
                }
                let _e298 = phi_522_;
                let _e300 = phi_547_;
                let _e303 = (bitcast<i32>(_e300.member) != 0i);
                if _e303 {
                    phi_525_ = (_e286 * 32u);
                } else {
                    phi_525_ = u32();
                }
                let _e306 = phi_525_;
                continue;
                continuing {
                    phi_521_ = _e298;
                    phi_524_ = _e306;
                    break if !(_e303);
                }
            }
            let _e310 = local_5;
            if (_e310 == 0u) {
                return;
            }
            let _e313 = local_6;
            let _e314 = ((_e281 - 1u) / _e313);
            if (_e314 < _e279) {
                phi_565_ = _e314;
            } else {
                phi_565_ = _e279;
            }
            let _e317 = phi_565_;
            let _e319 = local_7;
            let _e320 = (_e317 * _e319);
            let _e322 = local_8;
            let _e324 = (_e320 + (_e322 - 1u));
            let _e325 = (_e281 - 1u);
            if (_e325 < _e324) {
                phi_574_ = _e325;
            } else {
                phi_574_ = _e324;
            }
            let _e328 = phi_574_;
            let _e332 = params.member.member_2.member[0u][_e200[1]];
            let _e335 = worlds.member[(_e332 + _e320)];
            let _e340 = worlds.member[(_e332 + _e328)];
            ranges[_e44] = ((_e335 << bitcast<u32>(16i)) | _e340);
            let _e345 = params.member.member_2.member_1;
            if (_e345 == 0u) {
                phi_619_ = array<u32, 2>(0u, 2u);
            } else {
                phi_619_ = array<u32, 2>(1u, 1u);
            }
            let _e348 = phi_619_;
            let _e351 = (_e44 / 32u);
            let _e352 = (_e44 % 32u);
            let _e354 = params.member.member_2.member_2;
            let _e358 = params.member.member_2.member[_e354][_e348[0]];
            let _e361 = nodes.member[(_e358 + _e181)];
            let _e375 = params.member.member_2.member_2;
            let _e379 = params.member.member_2.member[_e375][_e348[1]];
            let _e382 = nodes.member[(_e379 + _e184)];
            let _e396 = params.member.member_2.member_2;
            let _e403 = params.member.member_2.member[(_e396 - 1u)][_e348[0]];
            let _e406 = nodes.member[(_e403 + ((_e181 * 32u) + _e352))];
            let _e423 = params.member.member_2.member_2;
            let _e430 = params.member.member_2.member[(_e423 - 1u)][_e348[1]];
            let _e433 = nodes.member[(_e430 + ((_e184 * 32u) + _e352))];
            if _e167 {
                if ((((((_e433.member.x <= _e361.member_1.y) && (_e361.member.x <= _e433.member_1.y)) && (_e433.member.y <= _e361.member_2.x)) && (_e361.member.y <= _e433.member_2.x)) && (_e433.member_1.x <= _e361.member_2.y)) && (_e361.member_1.x <= _e433.member_2.y)) {
                    let _e459 = atomicAdd((&counters[_e351]), 1u);
                    let _e460 = ((_e351 * 32u) + _e459);
                    columns[_e460] = type_24(array<f32, 3>(_e433.member.x, _e433.member.y, _e433.member_1.x), array<f32, 3>(_e433.member_1.y, _e433.member_2.x, _e433.member_2.y));
                    names[_e460] = _e352;
                }
            }
            workgroupBarrier();
            if _e167 {
                if ((((((_e406.member.x <= _e382.member_1.y) && (_e382.member.x <= _e406.member_1.y)) && (_e406.member.y <= _e382.member_2.x)) && (_e382.member.y <= _e406.member_2.x)) && (_e406.member_1.x <= _e382.member_2.y)) && (_e382.member_1.x <= _e406.member_2.y)) {
                    phi_817_ = false;
                } else {
                    phi_817_ = true;
                }
                let _e478 = phi_817_;
                phi_818_ = _e478;
            } else {
                phi_818_ = true;
            }
            let _e480 = phi_818_;
            if _e480 {
                phi_822_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_822_ = type_24(array<f32, 3>(_e406.member.x, _e406.member.y, _e406.member_1.x), array<f32, 3>(_e406.member_1.y, _e406.member_2.x, _e406.member_2.y));
            }
            let _e482 = phi_822_;
            let _e485 = params.member.member_2.member_1;
            if (_e485 == 1u) {
                phi_831_ = (_e181 == _e184);
            } else {
                phi_831_ = false;
            }
            let _e489 = phi_831_;
            let _e490 = (_e44 / 32u);
            let _e491 = (_e44 % 32u);
            let _e493 = atomicLoad((&counters[_e490]));
            phi_840_ = type_9(0u, _e493);
            phi_843_ = 0u;
            loop {
                let _e496 = phi_840_;
                let _e498 = phi_843_;
                local_9 = _e498;
                if (_e496.member < _e496.member_1) {
                    phi_841_ = type_9((_e496.member + 1u), _e496.member_1);
                    phi_866_ = type_9(1u, _e496.member);
                } else {
                    phi_841_ = _e496;
                    phi_866_ = type_9(0u, type_9().member_1);
                }
                let _e510 = phi_841_;
                let _e512 = phi_866_;
                let _e516 = (bitcast<i32>(_e512.member) != 0i);
                if _e516 {
                    let _e520 = names[((_e490 * 32u) + _e512.member_1)];
                    let _e524 = columns[((_e490 * 32u) + _e512.member_1)];
                    if ((((((_e482.member[0] <= _e524.member_1[0]) && (_e524.member[0] <= _e482.member_1[0])) && (_e482.member[1] <= _e524.member_1[1])) && (_e524.member[1] <= _e482.member_1[1])) && (_e482.member[2] <= _e524.member_1[2])) && (_e524.member[2] <= _e482.member_1[2])) {
                        if _e489 {
                            let _e556 = (_e491 < _e520);
                            if _e556 {
                                phi_932_ = bool();
                            } else {
                                if (_e491 == _e520) {
                                    phi_931_ = true;
                                } else {
                                    phi_931_ = false;
                                }
                                let _e559 = phi_931_;
                                phi_932_ = _e559;
                            }
                            let _e561 = phi_932_;
                            phi_933_ = _e561;
                            phi_934_ = _e556;
                        } else {
                            phi_933_ = bool();
                            phi_934_ = true;
                        }
                        let _e563 = phi_933_;
                        let _e565 = phi_934_;
                        if _e565 {
                            phi_938_ = true;
                        } else {
                            phi_938_ = _e563;
                        }
                        let _e567 = phi_938_;
                        if _e567 {
                            let _e571 = ranges[((_e490 * 32u) + _e520)];
                            if ((_e277 >> bitcast<u32>(16i)) <= (_e571 & 65535u)) {
                                phi_955_ = ((_e571 >> bitcast<u32>(16i)) <= (_e277 & 65535u));
                            } else {
                                phi_955_ = false;
                            }
                            let _e581 = phi_955_;
                            if _e581 {
                                let _e583 = atomicAdd((&counters[4u]), 1u);
                                if (_e583 < 2048u) {
                                    hits[_e583] = (((_e490 << bitcast<u32>(10i)) | (_e491 << bitcast<u32>(5i))) | _e520);
                                    phi_973_ = _e498;
                                } else {
                                    phi_973_ = (_e498 | (1u << bitcast<u32>((_e512.member_1 & 31u))));
                                }
                                let _e597 = phi_973_;
                                phi_974_ = _e597;
                            } else {
                                phi_974_ = _e498;
                            }
                            let _e599 = phi_974_;
                            phi_975_ = _e599;
                        } else {
                            phi_975_ = _e498;
                        }
                        let _e601 = phi_975_;
                        phi_976_ = _e601;
                    } else {
                        phi_976_ = _e498;
                    }
                    let _e603 = phi_976_;
                    phi_844_ = _e603;
                } else {
                    phi_844_ = u32();
                }
                let _e605 = phi_844_;
                continue;
                continuing {
                    phi_840_ = _e510;
                    phi_843_ = _e605;
                    break if !(_e516);
                }
            }
            phi_979_ = type_9(0u, 32u);
            let _e803 = local_9;
            phi_982_ = _e803;
            loop {
                let _e608 = phi_979_;
                let _e610 = phi_982_;
                if (_e608.member < _e608.member_1) {
                    phi_980_ = type_9((_e608.member + 1u), _e608.member_1);
                    phi_1005_ = type_9(1u, _e608.member);
                } else {
                    phi_980_ = _e608;
                    phi_1005_ = type_9(0u, type_9().member_1);
                }
                let _e622 = phi_980_;
                let _e624 = phi_1005_;
                if (bitcast<i32>(_e624.member) != 0i) {
                    if (_e610 == 0u) {
                        phi_1055_ = u32();
                        phi_1056_ = false;
                    } else {
                        let _e635 = names[((_e67 * 32u) + select(firstTrailingBit(_e610), 32u, (_e610 == 0u)))];
                        let _e644 = params.member.member_1.member_3;
                        let _e646 = atomicAdd((&output.member[0u]), 1u);
                        if ((_e646 + 1u) < _e646) {
                            let _e650 = atomicAdd((&output.member[2u]), 1u);
                        }
                        if (_e646 < _e644) {
                            let _e652 = (2u * _e646);
                            atomicStore((&output.member[(4u + _e652)]), ((_e181 * 32u) + _e68));
                            atomicStore((&output.member[(_e652 + 5u)]), ((_e184 * 32u) + _e635));
                        }
                        phi_1055_ = (_e610 & (_e610 - 1u));
                        phi_1056_ = true;
                    }
                    let _e658 = phi_1055_;
                    let _e660 = phi_1056_;
                    phi_983_ = _e658;
                    phi_1057_ = _e660;
                } else {
                    phi_983_ = u32();
                    phi_1057_ = false;
                }
                let _e662 = phi_983_;
                let _e664 = phi_1057_;
                continue;
                continuing {
                    phi_979_ = _e622;
                    phi_982_ = _e662;
                    break if !(_e664);
                }
            }
            workgroupBarrier();
            let _e667 = atomicLoad((&counters[4u]));
            if (2048u < _e667) {
                phi_1064_ = 2048u;
            } else {
                phi_1064_ = _e667;
            }
            let _e670 = phi_1064_;
            if (_e44 == 0u) {
                atomicStore((&counters[5u]), _e670);
            }
            workgroupBarrier();
            if (_e44 == 0u) {
                let _e675 = atomicLoad((&counters[5u]));
                if (_e675 > 0u) {
                    let _e678 = atomicAdd((&output.member[0u]), _e675);
                    if ((_e678 + _e675) < _e678) {
                        let _e682 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e678);
                }
            }
            workgroupBarrier();
            let _e685 = atomicLoad((&counters[6u]));
            phi_1098_ = type_9(0u, 16u);
            loop {
                let _e687 = phi_1098_;
                if (_e687.member < _e687.member_1) {
                    phi_1099_ = type_9((_e687.member + 1u), _e687.member_1);
                    phi_1122_ = type_9(1u, _e687.member);
                } else {
                    phi_1099_ = _e687;
                    phi_1122_ = type_9(0u, type_9().member_1);
                }
                let _e699 = phi_1099_;
                let _e701 = phi_1122_;
                if (bitcast<i32>(_e701.member) != 0i) {
                    let _e707 = (_e44 + (_e701.member_1 * 128u));
                    if (_e707 >= _e670) {
                        phi_1167_ = false;
                    } else {
                        let _e710 = hits[_e707];
                        let _e713 = ((_e710 >> bitcast<u32>(10i)) & 3u);
                        let _e720 = firsts[(2u * _e713)];
                        let _e725 = firsts[((2u * _e713) + 1u)];
                        let _e729 = params.member.member_1.member_3;
                        let _e730 = (_e685 + _e707);
                        if (_e730 < _e729) {
                            let _e732 = (2u * _e730);
                            atomicStore((&output.member[(4u + _e732)]), (_e720 + ((_e710 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[(_e732 + 5u)]), (_e725 + (_e710 & 31u)));
                        }
                        phi_1167_ = true;
                    }
                    let _e738 = phi_1167_;
                    phi_1168_ = _e738;
                } else {
                    phi_1168_ = false;
                }
                let _e740 = phi_1168_;
                continue;
                continuing {
                    phi_1098_ = _e699;
                    break if !(_e740);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_250_ = _e128;
            break if !(_e134);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
