struct type_6 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 4>,
    member_3: f32,
    member_4: f32,
    member_5: f32,
    member_6: f32,
    member_7: array<u32, 2>,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
    member_18: array<array<u32, 2>, 3>,
    member_19: array<u32, 2>,
    member_20: array<array<u32, 4>, 8>,
}

struct type_15 {
    member: type_13,
}

struct type_19 {
    member: array<type_6>,
}

struct type_26 {
    member: u32,
    member_1: u32,
}

struct type_33 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_35 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

struct type_39 {
    member: array<array<f64, 3>>,
}

struct type_43 {
    member: array<type_33>,
}

struct type_48 {
    member: array<array<array<u32, 2>, 6>>,
}

var<private> id_1: vec3<u32>;
var<private> n_1: vec3<u32>;
var<private> lane_1: u32;
@group(0) @binding(0) 
var<storage> params: type_15;
@group(0) @binding(1) 
var<storage> positions: type_39;
@group(0) @binding(2) 
var<storage, read_write> paths: type_43;
@group(0) @binding(3) 
var<storage, read_write> keys: type_48;
@group(0) @binding(4) 
var<storage, read_write> boxes: type_19;

fn function_() {
    var local: type_6;
    var local_1: type_6;
    var local_2: array<f64, 3>;
    var local_3: array<f64, 3>;
    var local_4: type_33;
    var local_5: type_35;
    var local_6: type_35;
    var local_7: type_35;
    var local_8: type_35;
    var phi_187_: type_26;
    var phi_188_: type_26;
    var phi_211_: type_26;
    var phi_237_: f64;
    var phi_264_: f64;
    var phi_311_: type_26;
    var phi_312_: type_26;
    var phi_335_: type_26;
    var phi_362_: bool;
    var phi_379_: f64;
    var phi_380_: f64;
    var phi_381_: f64;
    var phi_408_: bool;
    var phi_425_: f64;
    var phi_426_: f64;
    var phi_427_: f64;
    var phi_481_: type_26;
    var phi_482_: type_26;
    var phi_505_: type_26;
    var phi_553_: bool;
    var phi_570_: f32;
    var phi_571_: f32;
    var phi_572_: f32;
    var phi_574_: f32;
    var phi_591_: bool;
    var phi_608_: f32;
    var phi_609_: f32;
    var phi_610_: f32;
    var phi_611_: f32;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_640_: f32;
    var phi_672_: bool;
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_691_: f32;
    var phi_693_: f32;
    var phi_710_: bool;
    var phi_727_: f32;
    var phi_728_: f32;
    var phi_729_: f32;
    var phi_730_: f32;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_759_: f32;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_821_: array<u32, 2>;
    var phi_822_: bool;
    var phi_823_: array<u32, 2>;
    var phi_824_: bool;
    var phi_830_: array<u32, 2>;
    var phi_849_: bool;
    var phi_850_: bool;
    var phi_857_: array<u32, 2>;
    var phi_858_: bool;
    var phi_859_: array<u32, 2>;
    var phi_860_: bool;
    var phi_866_: array<u32, 2>;
    var phi_885_: bool;
    var phi_886_: bool;
    var phi_893_: array<u32, 2>;
    var phi_894_: bool;
    var phi_895_: array<u32, 2>;
    var phi_896_: bool;
    var phi_902_: array<u32, 2>;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_929_: array<u32, 2>;
    var phi_930_: bool;
    var phi_931_: array<u32, 2>;
    var phi_932_: bool;
    var phi_938_: array<u32, 2>;
    var phi_957_: bool;
    var phi_958_: bool;
    var phi_965_: array<u32, 2>;
    var phi_966_: bool;
    var phi_967_: array<u32, 2>;
    var phi_968_: bool;
    var phi_974_: array<u32, 2>;
    var phi_993_: bool;
    var phi_994_: bool;
    var phi_1001_: array<u32, 2>;
    var phi_1002_: bool;
    var phi_1003_: array<u32, 2>;
    var phi_1004_: bool;
    var phi_1010_: array<u32, 2>;
    var phi_1016_: type_26;
    var phi_1017_: type_26;
    var phi_1040_: type_26;
    var phi_1072_: bool;
    var phi_1089_: f32;
    var phi_1090_: f32;
    var phi_1091_: f32;
    var phi_1093_: f32;
    var phi_1099_: f32;
    var phi_1104_: f32;
    var phi_1135_: bool;
    var phi_1152_: f32;
    var phi_1153_: f32;
    var phi_1154_: f32;
    var phi_1155_: f32;
    var phi_1161_: f32;
    var phi_1166_: f32;
    var phi_1199_: type_26;
    var phi_1200_: type_26;
    var phi_1223_: type_26;
    var phi_1244_: bool;
    var phi_1267_: bool;
    var phi_1271_: f32;
    var phi_1280_: f32;
    var phi_1301_: bool;
    var phi_1324_: bool;
    var phi_1328_: f32;
    var phi_1337_: f32;

    let _e51 = id_1;
    let _e52 = n_1;
    let _e53 = lane_1;
    let _e65 = ((((_e51.y * _e52.x) + _e51.x) * 256u) + _e53);
    let _e68 = params.member.member[0u];
    if (_e65 < _e68) {
        let _e71 = positions.member[_e65];
        let _e74 = params.member.member[0u];
        let _e77 = positions.member[(_e74 + _e65)];
        local_7 = type_35(array<f64, 3>(_e77[0], _e77[1], _e77[2]), array<f64, 3>(_e77[0], _e77[1], _e77[2]));
        local_6 = type_35(array<f64, 3>(_e71[0], _e71[1], _e71[2]), array<f64, 3>(_e71[0], _e71[1], _e71[2]));
        phi_187_ = type_26(0u, 3u);
        loop {
            let _e97 = phi_187_;
            if (_e97.member < _e97.member_1) {
                phi_188_ = type_26((_e97.member + 1u), _e97.member_1);
                phi_211_ = type_26(1u, _e97.member);
            } else {
                phi_188_ = _e97;
                phi_211_ = type_26(0u, type_26().member_1);
            }
            let _e111 = phi_188_;
            let _e113 = phi_211_;
            let _e117 = (bitcast<i32>(_e113.member) != 0i);
            if _e117 {
                if (_e113.member_1 < 3u) {
                } else {
                    return;
                }
                let _e121 = local_6.member[_e113.member_1];
                if (_e113.member_1 < 3u) {
                } else {
                    return;
                }
                let _e125 = local_7.member[_e113.member_1];
                if (_e121 < _e125) {
                    phi_237_ = _e121;
                } else {
                    phi_237_ = _e125;
                }
                let _e128 = phi_237_;
                if (_e113.member_1 < 3u) {
                } else {
                    return;
                }
                local_6.member[_e113.member_1] = _e128;
                if (_e113.member_1 < 3u) {
                } else {
                    return;
                }
                let _e135 = local_6.member_1[_e113.member_1];
                if (_e113.member_1 < 3u) {
                } else {
                    return;
                }
                let _e139 = local_7.member_1[_e113.member_1];
                if (_e135 > _e139) {
                    phi_264_ = _e135;
                } else {
                    phi_264_ = _e139;
                }
                let _e142 = phi_264_;
                if (_e113.member_1 < 3u) {
                } else {
                    return;
                }
                local_6.member_1[_e113.member_1] = _e142;
            }
            continue;
            continuing {
                phi_187_ = _e111;
                break if !(_e117);
            }
        }
        let _e147 = local_6;
        let _e149 = params.member.member_19;
        let _e156 = bitcast<f64>(((u64(_e149[1]) * 4294967296lu) + u64(_e149[0])));
        if (_e156 > f64(0f)) {
            local_5 = _e147;
            phi_311_ = type_26(0u, 3u);
            loop {
                let _e160 = phi_311_;
                if (_e160.member < _e160.member_1) {
                    phi_312_ = type_26((_e160.member + 1u), _e160.member_1);
                    phi_335_ = type_26(1u, _e160.member);
                } else {
                    phi_312_ = _e160;
                    phi_335_ = type_26(0u, type_26().member_1);
                }
                let _e174 = phi_312_;
                let _e176 = phi_335_;
                let _e180 = (bitcast<i32>(_e176.member) != 0i);
                if _e180 {
                    if (_e176.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e184 = local_5.member[_e176.member_1];
                    let _e186 = -((_e184 - _e156));
                    let _e187 = bitcast<u64>(_e186);
                    if ((_e187 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_362_ = (_e186 < 0.0lf);
                    } else {
                        phi_362_ = true;
                    }
                    let _e192 = phi_362_;
                    if _e192 {
                        if (_e186 > 0.0lf) {
                            phi_380_ = bitcast<f64>((_e187 + 1lu));
                        } else {
                            if (_e186 < 0.0lf) {
                                phi_379_ = bitcast<f64>((_e187 - 1lu));
                            } else {
                                phi_379_ = 5e-324lf;
                            }
                            let _e198 = phi_379_;
                            phi_380_ = _e198;
                        }
                        let _e202 = phi_380_;
                        phi_381_ = _e202;
                    } else {
                        phi_381_ = _e186;
                    }
                    let _e204 = phi_381_;
                    if (_e176.member_1 < 3u) {
                    } else {
                        return;
                    }
                    local_5.member[_e176.member_1] = -(_e204);
                    if (_e176.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e212 = local_5.member_1[_e176.member_1];
                    let _e213 = (_e212 + _e156);
                    let _e214 = bitcast<u64>(_e213);
                    if ((_e214 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_408_ = (_e213 < 0.0lf);
                    } else {
                        phi_408_ = true;
                    }
                    let _e219 = phi_408_;
                    if _e219 {
                        if (_e213 > 0.0lf) {
                            phi_426_ = bitcast<f64>((_e214 + 1lu));
                        } else {
                            if (_e213 < 0.0lf) {
                                phi_425_ = bitcast<f64>((_e214 - 1lu));
                            } else {
                                phi_425_ = 5e-324lf;
                            }
                            let _e225 = phi_425_;
                            phi_426_ = _e225;
                        }
                        let _e229 = phi_426_;
                        phi_427_ = _e229;
                    } else {
                        phi_427_ = _e213;
                    }
                    let _e231 = phi_427_;
                    if (_e176.member_1 < 3u) {
                    } else {
                        return;
                    }
                    local_5.member_1[_e176.member_1] = _e231;
                }
                continue;
                continuing {
                    phi_311_ = _e174;
                    break if !(_e180);
                }
            }
        } else {
            local_5 = _e147;
        }
        let _e236 = local_5;
        local_8 = _e236;
        local_2 = array<f64, 3>(_e71[0], _e71[1], _e71[2]);
        local_3 = array<f64, 3>(_e77[0], _e77[1], _e77[2]);
        local_4.member = array<f32, 4>(0f, 0f, 0f, 0f);
        local_4.member_1 = array<f32, 4>(0f, 0f, 0f, 0f);
        phi_481_ = type_26(0u, 3u);
        loop {
            let _e248 = phi_481_;
            if (_e248.member < _e248.member_1) {
                phi_482_ = type_26((_e248.member + 1u), _e248.member_1);
                phi_505_ = type_26(1u, _e248.member);
            } else {
                phi_482_ = _e248;
                phi_505_ = type_26(0u, type_26().member_1);
            }
            let _e262 = phi_482_;
            let _e264 = phi_505_;
            let _e268 = (bitcast<i32>(_e264.member) != 0i);
            if _e268 {
                if (_e264.member_1 < 3u) {
                } else {
                    return;
                }
                let _e272 = params.member.member_18[_e264.member_1];
                let _e279 = bitcast<f64>(((u64(_e272[1]) * 4294967296lu) + u64(_e272[0])));
                if (_e264.member_1 < 3u) {
                } else {
                    return;
                }
                let _e282 = local_2[_e264.member_1];
                let _e283 = (_e282 - _e279);
                let _e284 = f32(_e283);
                if (f64(_e284) > _e283) {
                    let _e287 = -(_e284);
                    let _e288 = bitcast<u32>(_e287);
                    if ((_e288 & 2139095040u) == 2139095040u) {
                        phi_553_ = (_e287 < 0f);
                    } else {
                        phi_553_ = true;
                    }
                    let _e293 = phi_553_;
                    if _e293 {
                        if (_e287 > 0f) {
                            phi_571_ = bitcast<f32>((_e288 + 1u));
                        } else {
                            if (_e287 < 0f) {
                                phi_570_ = bitcast<f32>((_e288 - 1u));
                            } else {
                                phi_570_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e299 = phi_570_;
                            phi_571_ = _e299;
                        }
                        let _e303 = phi_571_;
                        phi_572_ = _e303;
                    } else {
                        phi_572_ = _e287;
                    }
                    let _e305 = phi_572_;
                    phi_574_ = -(_e305);
                } else {
                    phi_574_ = _e284;
                }
                let _e308 = phi_574_;
                let _e309 = f32(_e283);
                if (f64(_e309) < _e283) {
                    let _e312 = bitcast<u32>(_e309);
                    if ((_e312 & 2139095040u) == 2139095040u) {
                        phi_591_ = (_e309 < 0f);
                    } else {
                        phi_591_ = true;
                    }
                    let _e317 = phi_591_;
                    if _e317 {
                        if (_e309 > 0f) {
                            phi_609_ = bitcast<f32>((_e312 + 1u));
                        } else {
                            if (_e309 < 0f) {
                                phi_608_ = bitcast<f32>((_e312 - 1u));
                            } else {
                                phi_608_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e323 = phi_608_;
                            phi_609_ = _e323;
                        }
                        let _e327 = phi_609_;
                        phi_610_ = _e327;
                    } else {
                        phi_610_ = _e309;
                    }
                    let _e329 = phi_610_;
                    phi_611_ = _e329;
                } else {
                    phi_611_ = _e309;
                }
                let _e331 = phi_611_;
                let _e333 = (_e283 - f64(_e308));
                let _e335 = (f64(_e331) - _e283);
                if (_e333 < _e335) {
                    phi_636_ = true;
                } else {
                    if (_e333 == _e335) {
                        if ((bitcast<u32>(_e308) & 1u) == 0u) {
                            phi_630_ = false;
                        } else {
                            phi_630_ = true;
                        }
                        let _e342 = phi_630_;
                        phi_631_ = _e342;
                    } else {
                        phi_631_ = true;
                    }
                    let _e344 = phi_631_;
                    if _e344 {
                        phi_635_ = false;
                    } else {
                        phi_635_ = true;
                    }
                    let _e346 = phi_635_;
                    phi_636_ = _e346;
                }
                let _e348 = phi_636_;
                if _e348 {
                    phi_640_ = _e308;
                } else {
                    phi_640_ = _e331;
                }
                let _e350 = phi_640_;
                if (_e264.member_1 < 4u) {
                } else {
                    return;
                }
                local_4.member[_e264.member_1] = _e350;
                if (_e264.member_1 < 3u) {
                } else {
                    return;
                }
                let _e356 = local_3[_e264.member_1];
                let _e357 = (_e356 - _e279);
                let _e358 = f32(_e357);
                if (f64(_e358) > _e357) {
                    let _e361 = -(_e358);
                    let _e362 = bitcast<u32>(_e361);
                    if ((_e362 & 2139095040u) == 2139095040u) {
                        phi_672_ = (_e361 < 0f);
                    } else {
                        phi_672_ = true;
                    }
                    let _e367 = phi_672_;
                    if _e367 {
                        if (_e361 > 0f) {
                            phi_690_ = bitcast<f32>((_e362 + 1u));
                        } else {
                            if (_e361 < 0f) {
                                phi_689_ = bitcast<f32>((_e362 - 1u));
                            } else {
                                phi_689_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e373 = phi_689_;
                            phi_690_ = _e373;
                        }
                        let _e377 = phi_690_;
                        phi_691_ = _e377;
                    } else {
                        phi_691_ = _e361;
                    }
                    let _e379 = phi_691_;
                    phi_693_ = -(_e379);
                } else {
                    phi_693_ = _e358;
                }
                let _e382 = phi_693_;
                let _e383 = f32(_e357);
                if (f64(_e383) < _e357) {
                    let _e386 = bitcast<u32>(_e383);
                    if ((_e386 & 2139095040u) == 2139095040u) {
                        phi_710_ = (_e383 < 0f);
                    } else {
                        phi_710_ = true;
                    }
                    let _e391 = phi_710_;
                    if _e391 {
                        if (_e383 > 0f) {
                            phi_728_ = bitcast<f32>((_e386 + 1u));
                        } else {
                            if (_e383 < 0f) {
                                phi_727_ = bitcast<f32>((_e386 - 1u));
                            } else {
                                phi_727_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e397 = phi_727_;
                            phi_728_ = _e397;
                        }
                        let _e401 = phi_728_;
                        phi_729_ = _e401;
                    } else {
                        phi_729_ = _e383;
                    }
                    let _e403 = phi_729_;
                    phi_730_ = _e403;
                } else {
                    phi_730_ = _e383;
                }
                let _e405 = phi_730_;
                let _e407 = (_e357 - f64(_e382));
                let _e409 = (f64(_e405) - _e357);
                if (_e407 < _e409) {
                    phi_755_ = true;
                } else {
                    if (_e407 == _e409) {
                        if ((bitcast<u32>(_e382) & 1u) == 0u) {
                            phi_749_ = false;
                        } else {
                            phi_749_ = true;
                        }
                        let _e416 = phi_749_;
                        phi_750_ = _e416;
                    } else {
                        phi_750_ = true;
                    }
                    let _e418 = phi_750_;
                    if _e418 {
                        phi_754_ = false;
                    } else {
                        phi_754_ = true;
                    }
                    let _e420 = phi_754_;
                    phi_755_ = _e420;
                }
                let _e422 = phi_755_;
                if _e422 {
                    phi_759_ = _e382;
                } else {
                    phi_759_ = _e405;
                }
                let _e424 = phi_759_;
                if (_e264.member_1 < 4u) {
                } else {
                    return;
                }
                local_4.member_1[_e264.member_1] = _e424;
            }
            continue;
            continuing {
                phi_481_ = _e262;
                break if !(_e268);
            }
        }
        let _e429 = local_4;
        paths.member[_e65] = type_33(array<f32, 4>(_e429.member[0], _e429.member[1], _e429.member[2], _e429.member[3]), array<f32, 4>(_e429.member_1[0], _e429.member_1[1], _e429.member_1[2], _e429.member_1[3]));
        let _e445 = local_8.member;
        let _e450 = local_8.member_1;
        let _e454 = bitcast<u64>(_e445[0]);
        let _e455 = u32(_e454);
        let _e457 = u32((_e454 / 4294967296lu));
        if ((_e457 >> bitcast<u32>(31i)) == 0u) {
            phi_823_ = array<u32, 2>();
            phi_824_ = true;
        } else {
            if (_e457 == 2147483648u) {
                if (_e455 == 0u) {
                    phi_813_ = false;
                } else {
                    phi_813_ = true;
                }
                let _e464 = phi_813_;
                phi_814_ = _e464;
            } else {
                phi_814_ = true;
            }
            let _e466 = phi_814_;
            if _e466 {
                phi_821_ = array<u32, 2>(~(_e455), ~(_e457));
                phi_822_ = false;
            } else {
                phi_821_ = array<u32, 2>();
                phi_822_ = true;
            }
            let _e471 = phi_821_;
            let _e473 = phi_822_;
            phi_823_ = _e471;
            phi_824_ = _e473;
        }
        let _e475 = phi_823_;
        let _e477 = phi_824_;
        if _e477 {
            phi_830_ = array<u32, 2>(_e455, (_e457 | 2147483648u));
        } else {
            phi_830_ = _e475;
        }
        let _e481 = phi_830_;
        let _e482 = bitcast<u64>(_e445[1]);
        let _e483 = u32(_e482);
        let _e485 = u32((_e482 / 4294967296lu));
        if ((_e485 >> bitcast<u32>(31i)) == 0u) {
            phi_859_ = array<u32, 2>();
            phi_860_ = true;
        } else {
            if (_e485 == 2147483648u) {
                if (_e483 == 0u) {
                    phi_849_ = false;
                } else {
                    phi_849_ = true;
                }
                let _e492 = phi_849_;
                phi_850_ = _e492;
            } else {
                phi_850_ = true;
            }
            let _e494 = phi_850_;
            if _e494 {
                phi_857_ = array<u32, 2>(~(_e483), ~(_e485));
                phi_858_ = false;
            } else {
                phi_857_ = array<u32, 2>();
                phi_858_ = true;
            }
            let _e499 = phi_857_;
            let _e501 = phi_858_;
            phi_859_ = _e499;
            phi_860_ = _e501;
        }
        let _e503 = phi_859_;
        let _e505 = phi_860_;
        if _e505 {
            phi_866_ = array<u32, 2>(_e483, (_e485 | 2147483648u));
        } else {
            phi_866_ = _e503;
        }
        let _e509 = phi_866_;
        let _e510 = bitcast<u64>(_e445[2]);
        let _e511 = u32(_e510);
        let _e513 = u32((_e510 / 4294967296lu));
        if ((_e513 >> bitcast<u32>(31i)) == 0u) {
            phi_895_ = array<u32, 2>();
            phi_896_ = true;
        } else {
            if (_e513 == 2147483648u) {
                if (_e511 == 0u) {
                    phi_885_ = false;
                } else {
                    phi_885_ = true;
                }
                let _e520 = phi_885_;
                phi_886_ = _e520;
            } else {
                phi_886_ = true;
            }
            let _e522 = phi_886_;
            if _e522 {
                phi_893_ = array<u32, 2>(~(_e511), ~(_e513));
                phi_894_ = false;
            } else {
                phi_893_ = array<u32, 2>();
                phi_894_ = true;
            }
            let _e527 = phi_893_;
            let _e529 = phi_894_;
            phi_895_ = _e527;
            phi_896_ = _e529;
        }
        let _e531 = phi_895_;
        let _e533 = phi_896_;
        if _e533 {
            phi_902_ = array<u32, 2>(_e511, (_e513 | 2147483648u));
        } else {
            phi_902_ = _e531;
        }
        let _e537 = phi_902_;
        let _e538 = bitcast<u64>(_e450[0]);
        let _e539 = u32(_e538);
        let _e541 = u32((_e538 / 4294967296lu));
        if ((_e541 >> bitcast<u32>(31i)) == 0u) {
            phi_931_ = array<u32, 2>();
            phi_932_ = true;
        } else {
            if (_e541 == 2147483648u) {
                if (_e539 == 0u) {
                    phi_921_ = false;
                } else {
                    phi_921_ = true;
                }
                let _e548 = phi_921_;
                phi_922_ = _e548;
            } else {
                phi_922_ = true;
            }
            let _e550 = phi_922_;
            if _e550 {
                phi_929_ = array<u32, 2>(~(_e539), ~(_e541));
                phi_930_ = false;
            } else {
                phi_929_ = array<u32, 2>();
                phi_930_ = true;
            }
            let _e555 = phi_929_;
            let _e557 = phi_930_;
            phi_931_ = _e555;
            phi_932_ = _e557;
        }
        let _e559 = phi_931_;
        let _e561 = phi_932_;
        if _e561 {
            phi_938_ = array<u32, 2>(_e539, (_e541 | 2147483648u));
        } else {
            phi_938_ = _e559;
        }
        let _e565 = phi_938_;
        let _e566 = bitcast<u64>(_e450[1]);
        let _e567 = u32(_e566);
        let _e569 = u32((_e566 / 4294967296lu));
        if ((_e569 >> bitcast<u32>(31i)) == 0u) {
            phi_967_ = array<u32, 2>();
            phi_968_ = true;
        } else {
            if (_e569 == 2147483648u) {
                if (_e567 == 0u) {
                    phi_957_ = false;
                } else {
                    phi_957_ = true;
                }
                let _e576 = phi_957_;
                phi_958_ = _e576;
            } else {
                phi_958_ = true;
            }
            let _e578 = phi_958_;
            if _e578 {
                phi_965_ = array<u32, 2>(~(_e567), ~(_e569));
                phi_966_ = false;
            } else {
                phi_965_ = array<u32, 2>();
                phi_966_ = true;
            }
            let _e583 = phi_965_;
            let _e585 = phi_966_;
            phi_967_ = _e583;
            phi_968_ = _e585;
        }
        let _e587 = phi_967_;
        let _e589 = phi_968_;
        if _e589 {
            phi_974_ = array<u32, 2>(_e567, (_e569 | 2147483648u));
        } else {
            phi_974_ = _e587;
        }
        let _e593 = phi_974_;
        let _e594 = bitcast<u64>(_e450[2]);
        let _e595 = u32(_e594);
        let _e597 = u32((_e594 / 4294967296lu));
        if ((_e597 >> bitcast<u32>(31i)) == 0u) {
            phi_1003_ = array<u32, 2>();
            phi_1004_ = true;
        } else {
            if (_e597 == 2147483648u) {
                if (_e595 == 0u) {
                    phi_993_ = false;
                } else {
                    phi_993_ = true;
                }
                let _e604 = phi_993_;
                phi_994_ = _e604;
            } else {
                phi_994_ = true;
            }
            let _e606 = phi_994_;
            if _e606 {
                phi_1001_ = array<u32, 2>(~(_e595), ~(_e597));
                phi_1002_ = false;
            } else {
                phi_1001_ = array<u32, 2>();
                phi_1002_ = true;
            }
            let _e611 = phi_1001_;
            let _e613 = phi_1002_;
            phi_1003_ = _e611;
            phi_1004_ = _e613;
        }
        let _e615 = phi_1003_;
        let _e617 = phi_1004_;
        if _e617 {
            phi_1010_ = array<u32, 2>(_e595, (_e597 | 2147483648u));
        } else {
            phi_1010_ = _e615;
        }
        let _e621 = phi_1010_;
        keys.member[_e65] = array<array<u32, 2>, 6>(_e481, _e509, _e537, _e565, _e593, _e621);
        local_1 = type_6(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_1016_ = type_26(0u, 3u);
        loop {
            let _e625 = phi_1016_;
            if (_e625.member < _e625.member_1) {
                phi_1017_ = type_26((_e625.member + 1u), _e625.member_1);
                phi_1040_ = type_26(1u, _e625.member);
            } else {
                phi_1017_ = _e625;
                phi_1040_ = type_26(0u, type_26().member_1);
            }
            let _e639 = phi_1017_;
            let _e641 = phi_1040_;
            let _e645 = (bitcast<i32>(_e641.member) != 0i);
            if _e645 {
                if (_e641.member_1 < 3u) {
                } else {
                    return;
                }
                let _e649 = local_8.member[_e641.member_1];
                let _e650 = f32(_e649);
                if (f64(_e650) > _e649) {
                    let _e653 = -(_e650);
                    let _e654 = bitcast<u32>(_e653);
                    if ((_e654 & 2139095040u) == 2139095040u) {
                        phi_1072_ = (_e653 < 0f);
                    } else {
                        phi_1072_ = true;
                    }
                    let _e659 = phi_1072_;
                    if _e659 {
                        if (_e653 > 0f) {
                            phi_1090_ = bitcast<f32>((_e654 + 1u));
                        } else {
                            if (_e653 < 0f) {
                                phi_1089_ = bitcast<f32>((_e654 - 1u));
                            } else {
                                phi_1089_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e665 = phi_1089_;
                            phi_1090_ = _e665;
                        }
                        let _e669 = phi_1090_;
                        phi_1091_ = _e669;
                    } else {
                        phi_1091_ = _e653;
                    }
                    let _e671 = phi_1091_;
                    phi_1093_ = -(_e671);
                } else {
                    phi_1093_ = _e650;
                }
                let _e674 = phi_1093_;
                let _e675 = -(290000000000000000000000000000000000000f);
                if (_e674 > _e675) {
                    phi_1099_ = _e674;
                } else {
                    phi_1099_ = _e675;
                }
                let _e678 = phi_1099_;
                if (_e678 < 290000000000000000000000000000000000000f) {
                    phi_1104_ = _e678;
                } else {
                    phi_1104_ = 290000000000000000000000000000000000000f;
                }
                let _e681 = phi_1104_;
                if (_e641.member_1 < 3u) {
                } else {
                    return;
                }
                local_1.member[_e641.member_1] = _e681;
                if (_e641.member_1 < 3u) {
                } else {
                    return;
                }
                let _e688 = local_8.member_1[_e641.member_1];
                let _e689 = f32(_e688);
                if (f64(_e689) < _e688) {
                    let _e692 = bitcast<u32>(_e689);
                    if ((_e692 & 2139095040u) == 2139095040u) {
                        phi_1135_ = (_e689 < 0f);
                    } else {
                        phi_1135_ = true;
                    }
                    let _e697 = phi_1135_;
                    if _e697 {
                        if (_e689 > 0f) {
                            phi_1153_ = bitcast<f32>((_e692 + 1u));
                        } else {
                            if (_e689 < 0f) {
                                phi_1152_ = bitcast<f32>((_e692 - 1u));
                            } else {
                                phi_1152_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e703 = phi_1152_;
                            phi_1153_ = _e703;
                        }
                        let _e707 = phi_1153_;
                        phi_1154_ = _e707;
                    } else {
                        phi_1154_ = _e689;
                    }
                    let _e709 = phi_1154_;
                    phi_1155_ = _e709;
                } else {
                    phi_1155_ = _e689;
                }
                let _e711 = phi_1155_;
                let _e712 = -(290000000000000000000000000000000000000f);
                if (_e711 > _e712) {
                    phi_1161_ = _e711;
                } else {
                    phi_1161_ = _e712;
                }
                let _e715 = phi_1161_;
                if (_e715 < 290000000000000000000000000000000000000f) {
                    phi_1166_ = _e715;
                } else {
                    phi_1166_ = 290000000000000000000000000000000000000f;
                }
                let _e718 = phi_1166_;
                if (_e641.member_1 < 3u) {
                } else {
                    return;
                }
                local_1.member_1[_e641.member_1] = _e718;
            }
            continue;
            continuing {
                phi_1016_ = _e639;
                break if !(_e645);
            }
        }
        let _e723 = local_1;
        local = _e723;
        phi_1199_ = type_26(0u, 3u);
        loop {
            let _e725 = phi_1199_;
            if (_e725.member < _e725.member_1) {
                phi_1200_ = type_26((_e725.member + 1u), _e725.member_1);
                phi_1223_ = type_26(1u, _e725.member);
            } else {
                phi_1200_ = _e725;
                phi_1223_ = type_26(0u, type_26().member_1);
            }
            let _e739 = phi_1200_;
            let _e741 = phi_1223_;
            let _e745 = (bitcast<i32>(_e741.member) != 0i);
            if _e745 {
                if (_e741.member_1 < 3u) {
                } else {
                    return;
                }
                let _e749 = local.member[_e741.member_1];
                if (_e749 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1244_ = (_e749 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1244_ = false;
                }
                let _e754 = phi_1244_;
                if _e754 {
                    if (_e741.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e762 = local_8.member[_e741.member_1];
                    let _e764 = bitcast<u64>(-(_e762));
                    let _e767 = u32((_e764 / 4294967296lu));
                    if ((_e767 >> bitcast<u32>(31i)) == 0u) {
                        phi_1267_ = ((u32(_e764) | _e767) != 0u);
                    } else {
                        phi_1267_ = false;
                    }
                    let _e774 = phi_1267_;
                    if _e774 {
                        phi_1271_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1271_ = 0f;
                    }
                    let _e776 = phi_1271_;
                    phi_1280_ = -(_e776);
                } else {
                    if (_e741.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e758 = local.member[_e741.member_1];
                    phi_1280_ = _e758;
                }
                let _e779 = phi_1280_;
                if (_e741.member_1 < 3u) {
                } else {
                    return;
                }
                local.member[_e741.member_1] = _e779;
                if (_e741.member_1 < 3u) {
                } else {
                    return;
                }
                let _e786 = local.member_1[_e741.member_1];
                if (_e786 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1301_ = (_e786 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1301_ = false;
                }
                let _e791 = phi_1301_;
                if _e791 {
                    if (_e741.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e799 = local_8.member_1[_e741.member_1];
                    let _e800 = bitcast<u64>(_e799);
                    let _e803 = u32((_e800 / 4294967296lu));
                    if ((_e803 >> bitcast<u32>(31i)) == 0u) {
                        phi_1324_ = ((u32(_e800) | _e803) != 0u);
                    } else {
                        phi_1324_ = false;
                    }
                    let _e810 = phi_1324_;
                    if _e810 {
                        phi_1328_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1328_ = 0f;
                    }
                    let _e812 = phi_1328_;
                    phi_1337_ = _e812;
                } else {
                    if (_e741.member_1 < 3u) {
                    } else {
                        return;
                    }
                    let _e795 = local.member_1[_e741.member_1];
                    phi_1337_ = _e795;
                }
                let _e814 = phi_1337_;
                if (_e741.member_1 < 3u) {
                } else {
                    return;
                }
                local.member_1[_e741.member_1] = _e814;
            }
            continue;
            continuing {
                phi_1199_ = _e739;
                break if !(_e745);
            }
        }
        let _e819 = local;
        boxes.member[_e65] = type_6(array<f32, 3>(_e819.member[0], _e819.member[1], _e819.member[2]), array<f32, 3>(_e819.member_1[0], _e819.member_1[1], _e819.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    id_1 = id;
    n_1 = n;
    lane_1 = lane;
    function_();
}
