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

struct type_15 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_22 {
    member: u32,
}

struct type_23 {
    member: type_7,
    member_1: type_8,
    member_2: type_22,
}

struct type_24 {
    member: type_23,
}

struct type_27 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_29 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

struct type_31 {
    member: array<array<f64, 3>>,
}

@group(0) @binding(0) 
var<storage> params: type_24;
@group(0) @binding(1) 
var<storage> positions: type_31;
@group(0) @binding(2) 
var<storage, read_write> paths: type_17;
@group(0) @binding(3) 
var<storage, read_write> keys: type_27;
@group(0) @binding(4) 
var<storage, read_write> boxes: type_21;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var local_1: type_19;
    var local_2: array<f64, 3>;
    var local_3: array<f64, 3>;
    var local_4: type_15;
    var local_5: type_29;
    var local_6: type_29;
    var phi_171_: f64;
    var phi_178_: f64;
    var phi_185_: f64;
    var phi_193_: f64;
    var phi_200_: f64;
    var phi_207_: f64;
    var phi_237_: type_9;
    var phi_238_: type_9;
    var phi_261_: type_9;
    var phi_288_: bool;
    var phi_305_: f64;
    var phi_306_: f64;
    var phi_307_: f64;
    var phi_334_: bool;
    var phi_351_: f64;
    var phi_352_: f64;
    var phi_353_: f64;
    var phi_408_: type_9;
    var phi_409_: type_9;
    var phi_432_: type_9;
    var phi_480_: bool;
    var phi_497_: f32;
    var phi_498_: f32;
    var phi_499_: f32;
    var phi_501_: f32;
    var phi_518_: bool;
    var phi_535_: f32;
    var phi_536_: f32;
    var phi_537_: f32;
    var phi_538_: f32;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_567_: f32;
    var phi_599_: bool;
    var phi_616_: f32;
    var phi_617_: f32;
    var phi_618_: f32;
    var phi_620_: f32;
    var phi_637_: bool;
    var phi_654_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_686_: f32;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_748_: array<u32, 2>;
    var phi_749_: bool;
    var phi_750_: array<u32, 2>;
    var phi_751_: bool;
    var phi_757_: array<u32, 2>;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_784_: array<u32, 2>;
    var phi_785_: bool;
    var phi_786_: array<u32, 2>;
    var phi_787_: bool;
    var phi_793_: array<u32, 2>;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_820_: array<u32, 2>;
    var phi_821_: bool;
    var phi_822_: array<u32, 2>;
    var phi_823_: bool;
    var phi_829_: array<u32, 2>;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_856_: array<u32, 2>;
    var phi_857_: bool;
    var phi_858_: array<u32, 2>;
    var phi_859_: bool;
    var phi_865_: array<u32, 2>;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_892_: array<u32, 2>;
    var phi_893_: bool;
    var phi_894_: array<u32, 2>;
    var phi_895_: bool;
    var phi_901_: array<u32, 2>;
    var phi_920_: bool;
    var phi_921_: bool;
    var phi_928_: array<u32, 2>;
    var phi_929_: bool;
    var phi_930_: array<u32, 2>;
    var phi_931_: bool;
    var phi_937_: array<u32, 2>;
    var phi_943_: type_9;
    var phi_944_: type_9;
    var phi_967_: type_9;
    var phi_999_: bool;
    var phi_1016_: f32;
    var phi_1017_: f32;
    var phi_1018_: f32;
    var phi_1020_: f32;
    var phi_1026_: f32;
    var phi_1031_: f32;
    var phi_1062_: bool;
    var phi_1079_: f32;
    var phi_1080_: f32;
    var phi_1081_: f32;
    var phi_1082_: f32;
    var phi_1088_: f32;
    var phi_1093_: f32;
    var phi_1126_: type_9;
    var phi_1127_: type_9;
    var phi_1150_: type_9;
    var phi_1171_: bool;
    var phi_1194_: bool;
    var phi_1198_: f32;
    var phi_1207_: f32;
    var phi_1228_: bool;
    var phi_1251_: bool;
    var phi_1255_: f32;
    var phi_1264_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e38 = id_2;
    let _e39 = n_2;
    let _e40 = lane_2;
    let _e52 = ((((_e38.y * _e39.x) + _e38.x) * 256u) + _e40);
    let _e56 = params.member.member.member[0u];
    if (_e52 < _e56) {
        let _e60 = positions.member[_e52];
        let _e63 = params.member.member.member[0u];
        let _e66 = positions.member[(_e63 + _e52)];
        if (_e60[0] < _e66[0]) {
            phi_171_ = _e60[0];
        } else {
            phi_171_ = _e66[0];
        }
        let _e72 = phi_171_;
        if (_e60[1] < _e66[1]) {
            phi_178_ = _e60[1];
        } else {
            phi_178_ = _e66[1];
        }
        let _e77 = phi_178_;
        if (_e60[2] < _e66[2]) {
            phi_185_ = _e60[2];
        } else {
            phi_185_ = _e66[2];
        }
        let _e82 = phi_185_;
        if (_e60[0] > _e66[0]) {
            phi_193_ = _e60[0];
        } else {
            phi_193_ = _e66[0];
        }
        let _e87 = phi_193_;
        if (_e60[1] > _e66[1]) {
            phi_200_ = _e60[1];
        } else {
            phi_200_ = _e66[1];
        }
        let _e92 = phi_200_;
        if (_e60[2] > _e66[2]) {
            phi_207_ = _e60[2];
        } else {
            phi_207_ = _e66[2];
        }
        let _e97 = phi_207_;
        let _e99 = params.member.member.member_9;
        let _e106 = bitcast<f64>(((u64(_e99[1]) * 4294967296lu) + u64(_e99[0])));
        if (_e106 > f64(0f)) {
            local_5 = type_29(array<f64, 3>(_e72, _e77, _e82), array<f64, 3>(_e87, _e92, _e97));
            phi_237_ = type_9(0u, 3u);
            loop {
                let _e116 = phi_237_;
                if (_e116.member < _e116.member_1) {
                    phi_238_ = type_9((_e116.member + 1u), _e116.member_1);
                    phi_261_ = type_9(1u, _e116.member);
                } else {
                    phi_238_ = _e116;
                    phi_261_ = type_9(0u, type_9().member_1);
                }
                let _e128 = phi_238_;
                let _e130 = phi_261_;
                let _e134 = (bitcast<i32>(_e130.member) != 0i);
                if _e134 {
                    let _e137 = local_5.member[_e130.member_1];
                    let _e139 = -((_e137 - _e106));
                    let _e140 = bitcast<u64>(_e139);
                    if ((_e140 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_288_ = (_e139 < 0.0lf);
                    } else {
                        phi_288_ = true;
                    }
                    let _e145 = phi_288_;
                    if _e145 {
                        if (_e139 > 0.0lf) {
                            phi_306_ = bitcast<f64>((_e140 + 1lu));
                        } else {
                            if (_e139 < 0.0lf) {
                                phi_305_ = bitcast<f64>((_e140 - 1lu));
                            } else {
                                phi_305_ = 5e-324lf;
                            }
                            let _e151 = phi_305_;
                            phi_306_ = _e151;
                        }
                        let _e155 = phi_306_;
                        phi_307_ = _e155;
                    } else {
                        phi_307_ = _e139;
                    }
                    let _e157 = phi_307_;
                    local_5.member[_e130.member_1] = -(_e157);
                    let _e163 = local_5.member_1[_e130.member_1];
                    let _e164 = (_e163 + _e106);
                    let _e165 = bitcast<u64>(_e164);
                    if ((_e165 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_334_ = (_e164 < 0.0lf);
                    } else {
                        phi_334_ = true;
                    }
                    let _e170 = phi_334_;
                    if _e170 {
                        if (_e164 > 0.0lf) {
                            phi_352_ = bitcast<f64>((_e165 + 1lu));
                        } else {
                            if (_e164 < 0.0lf) {
                                phi_351_ = bitcast<f64>((_e165 - 1lu));
                            } else {
                                phi_351_ = 5e-324lf;
                            }
                            let _e176 = phi_351_;
                            phi_352_ = _e176;
                        }
                        let _e180 = phi_352_;
                        phi_353_ = _e180;
                    } else {
                        phi_353_ = _e164;
                    }
                    let _e182 = phi_353_;
                    local_5.member_1[_e130.member_1] = _e182;
                }
                continue;
                continuing {
                    phi_237_ = _e128;
                    break if !(_e134);
                }
            }
        } else {
            local_5 = type_29(array<f64, 3>(_e72, _e77, _e82), array<f64, 3>(_e87, _e92, _e97));
        }
        let _e186 = local_5;
        local_6 = _e186;
        local_2 = array<f64, 3>(_e60[0], _e60[1], _e60[2]);
        local_3 = array<f64, 3>(_e66[0], _e66[1], _e66[2]);
        local_4.member = array<f32, 4>(0f, 0f, 0f, 0f);
        local_4.member_1 = array<f32, 4>(0f, 0f, 0f, 0f);
        phi_408_ = type_9(0u, 3u);
        loop {
            let _e199 = phi_408_;
            if (_e199.member < _e199.member_1) {
                phi_409_ = type_9((_e199.member + 1u), _e199.member_1);
                phi_432_ = type_9(1u, _e199.member);
            } else {
                phi_409_ = _e199;
                phi_432_ = type_9(0u, type_9().member_1);
            }
            let _e211 = phi_409_;
            let _e213 = phi_432_;
            let _e217 = (bitcast<i32>(_e213.member) != 0i);
            if _e217 {
                let _e220 = params.member.member.member_8[_e213.member_1];
                let _e227 = bitcast<f64>(((u64(_e220[1]) * 4294967296lu) + u64(_e220[0])));
                let _e229 = local_2[_e213.member_1];
                let _e230 = (_e229 - _e227);
                let _e231 = f32(_e230);
                if (f64(_e231) > _e230) {
                    let _e234 = -(_e231);
                    let _e235 = bitcast<u32>(_e234);
                    if ((_e235 & 2139095040u) == 2139095040u) {
                        phi_480_ = (_e234 < 0f);
                    } else {
                        phi_480_ = true;
                    }
                    let _e240 = phi_480_;
                    if _e240 {
                        if (_e234 > 0f) {
                            phi_498_ = bitcast<f32>((_e235 + 1u));
                        } else {
                            if (_e234 < 0f) {
                                phi_497_ = bitcast<f32>((_e235 - 1u));
                            } else {
                                phi_497_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e246 = phi_497_;
                            phi_498_ = _e246;
                        }
                        let _e250 = phi_498_;
                        phi_499_ = _e250;
                    } else {
                        phi_499_ = _e234;
                    }
                    let _e252 = phi_499_;
                    phi_501_ = -(_e252);
                } else {
                    phi_501_ = _e231;
                }
                let _e255 = phi_501_;
                let _e256 = f32(_e230);
                if (f64(_e256) < _e230) {
                    let _e259 = bitcast<u32>(_e256);
                    if ((_e259 & 2139095040u) == 2139095040u) {
                        phi_518_ = (_e256 < 0f);
                    } else {
                        phi_518_ = true;
                    }
                    let _e264 = phi_518_;
                    if _e264 {
                        if (_e256 > 0f) {
                            phi_536_ = bitcast<f32>((_e259 + 1u));
                        } else {
                            if (_e256 < 0f) {
                                phi_535_ = bitcast<f32>((_e259 - 1u));
                            } else {
                                phi_535_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e270 = phi_535_;
                            phi_536_ = _e270;
                        }
                        let _e274 = phi_536_;
                        phi_537_ = _e274;
                    } else {
                        phi_537_ = _e256;
                    }
                    let _e276 = phi_537_;
                    phi_538_ = _e276;
                } else {
                    phi_538_ = _e256;
                }
                let _e278 = phi_538_;
                let _e280 = (_e230 - f64(_e255));
                let _e282 = (f64(_e278) - _e230);
                if (_e280 < _e282) {
                    phi_563_ = true;
                } else {
                    if (_e280 == _e282) {
                        if ((bitcast<u32>(_e255) & 1u) == 0u) {
                            phi_557_ = false;
                        } else {
                            phi_557_ = true;
                        }
                        let _e289 = phi_557_;
                        phi_558_ = _e289;
                    } else {
                        phi_558_ = true;
                    }
                    let _e291 = phi_558_;
                    if _e291 {
                        phi_562_ = false;
                    } else {
                        phi_562_ = true;
                    }
                    let _e293 = phi_562_;
                    phi_563_ = _e293;
                }
                let _e295 = phi_563_;
                if _e295 {
                    phi_567_ = _e255;
                } else {
                    phi_567_ = _e278;
                }
                let _e297 = phi_567_;
                local_4.member[_e213.member_1] = _e297;
                let _e301 = local_3[_e213.member_1];
                let _e302 = (_e301 - _e227);
                let _e303 = f32(_e302);
                if (f64(_e303) > _e302) {
                    let _e306 = -(_e303);
                    let _e307 = bitcast<u32>(_e306);
                    if ((_e307 & 2139095040u) == 2139095040u) {
                        phi_599_ = (_e306 < 0f);
                    } else {
                        phi_599_ = true;
                    }
                    let _e312 = phi_599_;
                    if _e312 {
                        if (_e306 > 0f) {
                            phi_617_ = bitcast<f32>((_e307 + 1u));
                        } else {
                            if (_e306 < 0f) {
                                phi_616_ = bitcast<f32>((_e307 - 1u));
                            } else {
                                phi_616_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e318 = phi_616_;
                            phi_617_ = _e318;
                        }
                        let _e322 = phi_617_;
                        phi_618_ = _e322;
                    } else {
                        phi_618_ = _e306;
                    }
                    let _e324 = phi_618_;
                    phi_620_ = -(_e324);
                } else {
                    phi_620_ = _e303;
                }
                let _e327 = phi_620_;
                let _e328 = f32(_e302);
                if (f64(_e328) < _e302) {
                    let _e331 = bitcast<u32>(_e328);
                    if ((_e331 & 2139095040u) == 2139095040u) {
                        phi_637_ = (_e328 < 0f);
                    } else {
                        phi_637_ = true;
                    }
                    let _e336 = phi_637_;
                    if _e336 {
                        if (_e328 > 0f) {
                            phi_655_ = bitcast<f32>((_e331 + 1u));
                        } else {
                            if (_e328 < 0f) {
                                phi_654_ = bitcast<f32>((_e331 - 1u));
                            } else {
                                phi_654_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e342 = phi_654_;
                            phi_655_ = _e342;
                        }
                        let _e346 = phi_655_;
                        phi_656_ = _e346;
                    } else {
                        phi_656_ = _e328;
                    }
                    let _e348 = phi_656_;
                    phi_657_ = _e348;
                } else {
                    phi_657_ = _e328;
                }
                let _e350 = phi_657_;
                let _e352 = (_e302 - f64(_e327));
                let _e354 = (f64(_e350) - _e302);
                if (_e352 < _e354) {
                    phi_682_ = true;
                } else {
                    if (_e352 == _e354) {
                        if ((bitcast<u32>(_e327) & 1u) == 0u) {
                            phi_676_ = false;
                        } else {
                            phi_676_ = true;
                        }
                        let _e361 = phi_676_;
                        phi_677_ = _e361;
                    } else {
                        phi_677_ = true;
                    }
                    let _e363 = phi_677_;
                    if _e363 {
                        phi_681_ = false;
                    } else {
                        phi_681_ = true;
                    }
                    let _e365 = phi_681_;
                    phi_682_ = _e365;
                }
                let _e367 = phi_682_;
                if _e367 {
                    phi_686_ = _e327;
                } else {
                    phi_686_ = _e350;
                }
                let _e369 = phi_686_;
                local_4.member_1[_e213.member_1] = _e369;
            }
            continue;
            continuing {
                phi_408_ = _e211;
                break if !(_e217);
            }
        }
        let _e373 = local_4;
        paths.member[_e52] = type_15(array<f32, 4>(_e373.member[0], _e373.member[1], _e373.member[2], _e373.member[3]), array<f32, 4>(_e373.member_1[0], _e373.member_1[1], _e373.member_1[2], _e373.member_1[3]));
        let _e389 = local_6.member;
        let _e394 = local_6.member_1;
        let _e398 = bitcast<u64>(_e389[0]);
        let _e399 = u32(_e398);
        let _e401 = u32((_e398 / 4294967296lu));
        if ((_e401 >> bitcast<u32>(31i)) == 0u) {
            phi_750_ = array<u32, 2>();
            phi_751_ = true;
        } else {
            if (_e401 == 2147483648u) {
                if (_e399 == 0u) {
                    phi_740_ = false;
                } else {
                    phi_740_ = true;
                }
                let _e408 = phi_740_;
                phi_741_ = _e408;
            } else {
                phi_741_ = true;
            }
            let _e410 = phi_741_;
            if _e410 {
                phi_748_ = array<u32, 2>(~(_e399), ~(_e401));
                phi_749_ = false;
            } else {
                phi_748_ = array<u32, 2>();
                phi_749_ = true;
            }
            let _e415 = phi_748_;
            let _e417 = phi_749_;
            phi_750_ = _e415;
            phi_751_ = _e417;
        }
        let _e419 = phi_750_;
        let _e421 = phi_751_;
        if _e421 {
            phi_757_ = array<u32, 2>(_e399, (_e401 | 2147483648u));
        } else {
            phi_757_ = _e419;
        }
        let _e425 = phi_757_;
        let _e426 = bitcast<u64>(_e389[1]);
        let _e427 = u32(_e426);
        let _e429 = u32((_e426 / 4294967296lu));
        if ((_e429 >> bitcast<u32>(31i)) == 0u) {
            phi_786_ = array<u32, 2>();
            phi_787_ = true;
        } else {
            if (_e429 == 2147483648u) {
                if (_e427 == 0u) {
                    phi_776_ = false;
                } else {
                    phi_776_ = true;
                }
                let _e436 = phi_776_;
                phi_777_ = _e436;
            } else {
                phi_777_ = true;
            }
            let _e438 = phi_777_;
            if _e438 {
                phi_784_ = array<u32, 2>(~(_e427), ~(_e429));
                phi_785_ = false;
            } else {
                phi_784_ = array<u32, 2>();
                phi_785_ = true;
            }
            let _e443 = phi_784_;
            let _e445 = phi_785_;
            phi_786_ = _e443;
            phi_787_ = _e445;
        }
        let _e447 = phi_786_;
        let _e449 = phi_787_;
        if _e449 {
            phi_793_ = array<u32, 2>(_e427, (_e429 | 2147483648u));
        } else {
            phi_793_ = _e447;
        }
        let _e453 = phi_793_;
        let _e454 = bitcast<u64>(_e389[2]);
        let _e455 = u32(_e454);
        let _e457 = u32((_e454 / 4294967296lu));
        if ((_e457 >> bitcast<u32>(31i)) == 0u) {
            phi_822_ = array<u32, 2>();
            phi_823_ = true;
        } else {
            if (_e457 == 2147483648u) {
                if (_e455 == 0u) {
                    phi_812_ = false;
                } else {
                    phi_812_ = true;
                }
                let _e464 = phi_812_;
                phi_813_ = _e464;
            } else {
                phi_813_ = true;
            }
            let _e466 = phi_813_;
            if _e466 {
                phi_820_ = array<u32, 2>(~(_e455), ~(_e457));
                phi_821_ = false;
            } else {
                phi_820_ = array<u32, 2>();
                phi_821_ = true;
            }
            let _e471 = phi_820_;
            let _e473 = phi_821_;
            phi_822_ = _e471;
            phi_823_ = _e473;
        }
        let _e475 = phi_822_;
        let _e477 = phi_823_;
        if _e477 {
            phi_829_ = array<u32, 2>(_e455, (_e457 | 2147483648u));
        } else {
            phi_829_ = _e475;
        }
        let _e481 = phi_829_;
        let _e482 = bitcast<u64>(_e394[0]);
        let _e483 = u32(_e482);
        let _e485 = u32((_e482 / 4294967296lu));
        if ((_e485 >> bitcast<u32>(31i)) == 0u) {
            phi_858_ = array<u32, 2>();
            phi_859_ = true;
        } else {
            if (_e485 == 2147483648u) {
                if (_e483 == 0u) {
                    phi_848_ = false;
                } else {
                    phi_848_ = true;
                }
                let _e492 = phi_848_;
                phi_849_ = _e492;
            } else {
                phi_849_ = true;
            }
            let _e494 = phi_849_;
            if _e494 {
                phi_856_ = array<u32, 2>(~(_e483), ~(_e485));
                phi_857_ = false;
            } else {
                phi_856_ = array<u32, 2>();
                phi_857_ = true;
            }
            let _e499 = phi_856_;
            let _e501 = phi_857_;
            phi_858_ = _e499;
            phi_859_ = _e501;
        }
        let _e503 = phi_858_;
        let _e505 = phi_859_;
        if _e505 {
            phi_865_ = array<u32, 2>(_e483, (_e485 | 2147483648u));
        } else {
            phi_865_ = _e503;
        }
        let _e509 = phi_865_;
        let _e510 = bitcast<u64>(_e394[1]);
        let _e511 = u32(_e510);
        let _e513 = u32((_e510 / 4294967296lu));
        if ((_e513 >> bitcast<u32>(31i)) == 0u) {
            phi_894_ = array<u32, 2>();
            phi_895_ = true;
        } else {
            if (_e513 == 2147483648u) {
                if (_e511 == 0u) {
                    phi_884_ = false;
                } else {
                    phi_884_ = true;
                }
                let _e520 = phi_884_;
                phi_885_ = _e520;
            } else {
                phi_885_ = true;
            }
            let _e522 = phi_885_;
            if _e522 {
                phi_892_ = array<u32, 2>(~(_e511), ~(_e513));
                phi_893_ = false;
            } else {
                phi_892_ = array<u32, 2>();
                phi_893_ = true;
            }
            let _e527 = phi_892_;
            let _e529 = phi_893_;
            phi_894_ = _e527;
            phi_895_ = _e529;
        }
        let _e531 = phi_894_;
        let _e533 = phi_895_;
        if _e533 {
            phi_901_ = array<u32, 2>(_e511, (_e513 | 2147483648u));
        } else {
            phi_901_ = _e531;
        }
        let _e537 = phi_901_;
        let _e538 = bitcast<u64>(_e394[2]);
        let _e539 = u32(_e538);
        let _e541 = u32((_e538 / 4294967296lu));
        if ((_e541 >> bitcast<u32>(31i)) == 0u) {
            phi_930_ = array<u32, 2>();
            phi_931_ = true;
        } else {
            if (_e541 == 2147483648u) {
                if (_e539 == 0u) {
                    phi_920_ = false;
                } else {
                    phi_920_ = true;
                }
                let _e548 = phi_920_;
                phi_921_ = _e548;
            } else {
                phi_921_ = true;
            }
            let _e550 = phi_921_;
            if _e550 {
                phi_928_ = array<u32, 2>(~(_e539), ~(_e541));
                phi_929_ = false;
            } else {
                phi_928_ = array<u32, 2>();
                phi_929_ = true;
            }
            let _e555 = phi_928_;
            let _e557 = phi_929_;
            phi_930_ = _e555;
            phi_931_ = _e557;
        }
        let _e559 = phi_930_;
        let _e561 = phi_931_;
        if _e561 {
            phi_937_ = array<u32, 2>(_e539, (_e541 | 2147483648u));
        } else {
            phi_937_ = _e559;
        }
        let _e565 = phi_937_;
        keys.member[_e52] = array<array<u32, 2>, 6>(_e425, _e453, _e481, _e509, _e537, _e565);
        local_1 = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_943_ = type_9(0u, 3u);
        loop {
            let _e569 = phi_943_;
            if (_e569.member < _e569.member_1) {
                phi_944_ = type_9((_e569.member + 1u), _e569.member_1);
                phi_967_ = type_9(1u, _e569.member);
            } else {
                phi_944_ = _e569;
                phi_967_ = type_9(0u, type_9().member_1);
            }
            let _e581 = phi_944_;
            let _e583 = phi_967_;
            let _e587 = (bitcast<i32>(_e583.member) != 0i);
            if _e587 {
                let _e590 = local_6.member[_e583.member_1];
                let _e591 = f32(_e590);
                if (f64(_e591) > _e590) {
                    let _e594 = -(_e591);
                    let _e595 = bitcast<u32>(_e594);
                    if ((_e595 & 2139095040u) == 2139095040u) {
                        phi_999_ = (_e594 < 0f);
                    } else {
                        phi_999_ = true;
                    }
                    let _e600 = phi_999_;
                    if _e600 {
                        if (_e594 > 0f) {
                            phi_1017_ = bitcast<f32>((_e595 + 1u));
                        } else {
                            if (_e594 < 0f) {
                                phi_1016_ = bitcast<f32>((_e595 - 1u));
                            } else {
                                phi_1016_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e606 = phi_1016_;
                            phi_1017_ = _e606;
                        }
                        let _e610 = phi_1017_;
                        phi_1018_ = _e610;
                    } else {
                        phi_1018_ = _e594;
                    }
                    let _e612 = phi_1018_;
                    phi_1020_ = -(_e612);
                } else {
                    phi_1020_ = _e591;
                }
                let _e615 = phi_1020_;
                let _e616 = -(290000000000000000000000000000000000000f);
                if (_e615 > _e616) {
                    phi_1026_ = _e615;
                } else {
                    phi_1026_ = _e616;
                }
                let _e619 = phi_1026_;
                if (_e619 < 290000000000000000000000000000000000000f) {
                    phi_1031_ = _e619;
                } else {
                    phi_1031_ = 290000000000000000000000000000000000000f;
                }
                let _e622 = phi_1031_;
                local_1.member[_e583.member_1] = _e622;
                let _e627 = local_6.member_1[_e583.member_1];
                let _e628 = f32(_e627);
                if (f64(_e628) < _e627) {
                    let _e631 = bitcast<u32>(_e628);
                    if ((_e631 & 2139095040u) == 2139095040u) {
                        phi_1062_ = (_e628 < 0f);
                    } else {
                        phi_1062_ = true;
                    }
                    let _e636 = phi_1062_;
                    if _e636 {
                        if (_e628 > 0f) {
                            phi_1080_ = bitcast<f32>((_e631 + 1u));
                        } else {
                            if (_e628 < 0f) {
                                phi_1079_ = bitcast<f32>((_e631 - 1u));
                            } else {
                                phi_1079_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e642 = phi_1079_;
                            phi_1080_ = _e642;
                        }
                        let _e646 = phi_1080_;
                        phi_1081_ = _e646;
                    } else {
                        phi_1081_ = _e628;
                    }
                    let _e648 = phi_1081_;
                    phi_1082_ = _e648;
                } else {
                    phi_1082_ = _e628;
                }
                let _e650 = phi_1082_;
                let _e651 = -(290000000000000000000000000000000000000f);
                if (_e650 > _e651) {
                    phi_1088_ = _e650;
                } else {
                    phi_1088_ = _e651;
                }
                let _e654 = phi_1088_;
                if (_e654 < 290000000000000000000000000000000000000f) {
                    phi_1093_ = _e654;
                } else {
                    phi_1093_ = 290000000000000000000000000000000000000f;
                }
                let _e657 = phi_1093_;
                local_1.member_1[_e583.member_1] = _e657;
            }
            continue;
            continuing {
                phi_943_ = _e581;
                break if !(_e587);
            }
        }
        let _e661 = local_1;
        local = _e661;
        phi_1126_ = type_9(0u, 3u);
        loop {
            let _e663 = phi_1126_;
            if (_e663.member < _e663.member_1) {
                phi_1127_ = type_9((_e663.member + 1u), _e663.member_1);
                phi_1150_ = type_9(1u, _e663.member);
            } else {
                phi_1127_ = _e663;
                phi_1150_ = type_9(0u, type_9().member_1);
            }
            let _e675 = phi_1127_;
            let _e677 = phi_1150_;
            let _e681 = (bitcast<i32>(_e677.member) != 0i);
            if _e681 {
                let _e684 = local.member[_e677.member_1];
                if (_e684 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1171_ = (_e684 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1171_ = false;
                }
                let _e689 = phi_1171_;
                if _e689 {
                    let _e695 = local_6.member[_e677.member_1];
                    let _e697 = bitcast<u64>(-(_e695));
                    let _e700 = u32((_e697 / 4294967296lu));
                    if ((_e700 >> bitcast<u32>(31i)) == 0u) {
                        phi_1194_ = ((u32(_e697) | _e700) != 0u);
                    } else {
                        phi_1194_ = false;
                    }
                    let _e707 = phi_1194_;
                    if _e707 {
                        phi_1198_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1198_ = 0f;
                    }
                    let _e709 = phi_1198_;
                    phi_1207_ = -(_e709);
                } else {
                    let _e692 = local.member[_e677.member_1];
                    phi_1207_ = _e692;
                }
                let _e712 = phi_1207_;
                local.member[_e677.member_1] = _e712;
                let _e717 = local.member_1[_e677.member_1];
                if (_e717 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1228_ = (_e717 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1228_ = false;
                }
                let _e722 = phi_1228_;
                if _e722 {
                    let _e728 = local_6.member_1[_e677.member_1];
                    let _e729 = bitcast<u64>(_e728);
                    let _e732 = u32((_e729 / 4294967296lu));
                    if ((_e732 >> bitcast<u32>(31i)) == 0u) {
                        phi_1251_ = ((u32(_e729) | _e732) != 0u);
                    } else {
                        phi_1251_ = false;
                    }
                    let _e739 = phi_1251_;
                    if _e739 {
                        phi_1255_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1255_ = 0f;
                    }
                    let _e741 = phi_1255_;
                    phi_1264_ = _e741;
                } else {
                    let _e725 = local.member_1[_e677.member_1];
                    phi_1264_ = _e725;
                }
                let _e743 = phi_1264_;
                local.member_1[_e677.member_1] = _e743;
            }
            continue;
            continuing {
                phi_1126_ = _e675;
                break if !(_e681);
            }
        }
        let _e747 = local;
        boxes.member[_e52] = type_19(array<f32, 3>(_e747.member[0], _e747.member[1], _e747.member[2]), array<f32, 3>(_e747.member_1[0], _e747.member_1[1], _e747.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
