struct type_4 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_10 {
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

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<type_4>,
}

struct type_16 {
    member: u32,
    member_1: u32,
}

struct type_20 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_21 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

struct type_23 {
    member: array<array<f64, 3>>,
}

struct type_25 {
    member: array<type_20>,
}

struct type_28 {
    member: array<array<array<u32, 2>, 6>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> positions: type_23;
@group(0) @binding(2) 
var<storage, read_write> paths: type_25;
@group(0) @binding(3) 
var<storage, read_write> keys: type_28;
@group(0) @binding(4) 
var<storage, read_write> boxes: type_13;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_4;
    var local_1: type_4;
    var local_2: array<f64, 3>;
    var local_3: array<f64, 3>;
    var local_4: type_20;
    var local_5: type_21;
    var local_6: type_21;
    var local_7: type_21;
    var local_8: type_21;
    var phi_187_: type_16;
    var phi_188_: type_16;
    var phi_211_: type_16;
    var phi_237_: f64;
    var phi_264_: f64;
    var phi_311_: type_16;
    var phi_312_: type_16;
    var phi_335_: type_16;
    var phi_362_: bool;
    var phi_379_: f64;
    var phi_380_: f64;
    var phi_381_: f64;
    var phi_408_: bool;
    var phi_425_: f64;
    var phi_426_: f64;
    var phi_427_: f64;
    var phi_481_: type_16;
    var phi_482_: type_16;
    var phi_505_: type_16;
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
    var phi_1016_: type_16;
    var phi_1017_: type_16;
    var phi_1040_: type_16;
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
    var phi_1199_: type_16;
    var phi_1200_: type_16;
    var phi_1223_: type_16;
    var phi_1244_: bool;
    var phi_1267_: bool;
    var phi_1271_: f32;
    var phi_1280_: f32;
    var phi_1301_: bool;
    var phi_1324_: bool;
    var phi_1328_: f32;
    var phi_1337_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e40 = id_2;
    let _e41 = n_2;
    let _e42 = lane_2;
    let _e54 = ((((_e40.y * _e41.x) + _e40.x) * 256u) + _e42);
    let _e57 = params.member.member[0u];
    if (_e54 < _e57) {
        let _e60 = positions.member[_e54];
        let _e63 = params.member.member[0u];
        let _e66 = positions.member[(_e63 + _e54)];
        local_7 = type_21(array<f64, 3>(_e66[0], _e66[1], _e66[2]), array<f64, 3>(_e66[0], _e66[1], _e66[2]));
        local_6 = type_21(array<f64, 3>(_e60[0], _e60[1], _e60[2]), array<f64, 3>(_e60[0], _e60[1], _e60[2]));
        phi_187_ = type_16(0u, 3u);
        loop {
            let _e86 = phi_187_;
            if (_e86.member < _e86.member_1) {
                phi_188_ = type_16((_e86.member + 1u), _e86.member_1);
                phi_211_ = type_16(1u, _e86.member);
            } else {
                phi_188_ = _e86;
                phi_211_ = type_16(0u, type_16().member_1);
            }
            let _e98 = phi_188_;
            let _e100 = phi_211_;
            let _e104 = (bitcast<i32>(_e100.member) != 0i);
            if _e104 {
                let _e107 = local_6.member[_e100.member_1];
                let _e110 = local_7.member[_e100.member_1];
                if (_e107 < _e110) {
                    phi_237_ = _e107;
                } else {
                    phi_237_ = _e110;
                }
                let _e113 = phi_237_;
                local_6.member[_e100.member_1] = _e113;
                let _e118 = local_6.member_1[_e100.member_1];
                let _e121 = local_7.member_1[_e100.member_1];
                if (_e118 > _e121) {
                    phi_264_ = _e118;
                } else {
                    phi_264_ = _e121;
                }
                let _e124 = phi_264_;
                local_6.member_1[_e100.member_1] = _e124;
            }
            continue;
            continuing {
                phi_187_ = _e98;
                break if !(_e104);
            }
        }
        let _e128 = local_6;
        let _e130 = params.member.member_19;
        let _e137 = bitcast<f64>(((u64(_e130[1]) * 4294967296lu) + u64(_e130[0])));
        if (_e137 > f64(0f)) {
            local_5 = _e128;
            phi_311_ = type_16(0u, 3u);
            loop {
                let _e141 = phi_311_;
                if (_e141.member < _e141.member_1) {
                    phi_312_ = type_16((_e141.member + 1u), _e141.member_1);
                    phi_335_ = type_16(1u, _e141.member);
                } else {
                    phi_312_ = _e141;
                    phi_335_ = type_16(0u, type_16().member_1);
                }
                let _e153 = phi_312_;
                let _e155 = phi_335_;
                let _e159 = (bitcast<i32>(_e155.member) != 0i);
                if _e159 {
                    let _e162 = local_5.member[_e155.member_1];
                    let _e164 = -((_e162 - _e137));
                    let _e165 = bitcast<u64>(_e164);
                    if ((_e165 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_362_ = (_e164 < 0.0lf);
                    } else {
                        phi_362_ = true;
                    }
                    let _e170 = phi_362_;
                    if _e170 {
                        if (_e164 > 0.0lf) {
                            phi_380_ = bitcast<f64>((_e165 + 1lu));
                        } else {
                            if (_e164 < 0.0lf) {
                                phi_379_ = bitcast<f64>((_e165 - 1lu));
                            } else {
                                phi_379_ = 5e-324lf;
                            }
                            let _e176 = phi_379_;
                            phi_380_ = _e176;
                        }
                        let _e180 = phi_380_;
                        phi_381_ = _e180;
                    } else {
                        phi_381_ = _e164;
                    }
                    let _e182 = phi_381_;
                    local_5.member[_e155.member_1] = -(_e182);
                    let _e188 = local_5.member_1[_e155.member_1];
                    let _e189 = (_e188 + _e137);
                    let _e190 = bitcast<u64>(_e189);
                    if ((_e190 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_408_ = (_e189 < 0.0lf);
                    } else {
                        phi_408_ = true;
                    }
                    let _e195 = phi_408_;
                    if _e195 {
                        if (_e189 > 0.0lf) {
                            phi_426_ = bitcast<f64>((_e190 + 1lu));
                        } else {
                            if (_e189 < 0.0lf) {
                                phi_425_ = bitcast<f64>((_e190 - 1lu));
                            } else {
                                phi_425_ = 5e-324lf;
                            }
                            let _e201 = phi_425_;
                            phi_426_ = _e201;
                        }
                        let _e205 = phi_426_;
                        phi_427_ = _e205;
                    } else {
                        phi_427_ = _e189;
                    }
                    let _e207 = phi_427_;
                    local_5.member_1[_e155.member_1] = _e207;
                }
                continue;
                continuing {
                    phi_311_ = _e153;
                    break if !(_e159);
                }
            }
        } else {
            local_5 = _e128;
        }
        let _e211 = local_5;
        local_8 = _e211;
        local_2 = array<f64, 3>(_e60[0], _e60[1], _e60[2]);
        local_3 = array<f64, 3>(_e66[0], _e66[1], _e66[2]);
        local_4.member = array<f32, 4>(0f, 0f, 0f, 0f);
        local_4.member_1 = array<f32, 4>(0f, 0f, 0f, 0f);
        phi_481_ = type_16(0u, 3u);
        loop {
            let _e223 = phi_481_;
            if (_e223.member < _e223.member_1) {
                phi_482_ = type_16((_e223.member + 1u), _e223.member_1);
                phi_505_ = type_16(1u, _e223.member);
            } else {
                phi_482_ = _e223;
                phi_505_ = type_16(0u, type_16().member_1);
            }
            let _e235 = phi_482_;
            let _e237 = phi_505_;
            let _e241 = (bitcast<i32>(_e237.member) != 0i);
            if _e241 {
                let _e244 = params.member.member_18[_e237.member_1];
                let _e251 = bitcast<f64>(((u64(_e244[1]) * 4294967296lu) + u64(_e244[0])));
                let _e253 = local_2[_e237.member_1];
                let _e254 = (_e253 - _e251);
                let _e255 = f32(_e254);
                if (f64(_e255) > _e254) {
                    let _e258 = -(_e255);
                    let _e259 = bitcast<u32>(_e258);
                    if ((_e259 & 2139095040u) == 2139095040u) {
                        phi_553_ = (_e258 < 0f);
                    } else {
                        phi_553_ = true;
                    }
                    let _e264 = phi_553_;
                    if _e264 {
                        if (_e258 > 0f) {
                            phi_571_ = bitcast<f32>((_e259 + 1u));
                        } else {
                            if (_e258 < 0f) {
                                phi_570_ = bitcast<f32>((_e259 - 1u));
                            } else {
                                phi_570_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e270 = phi_570_;
                            phi_571_ = _e270;
                        }
                        let _e274 = phi_571_;
                        phi_572_ = _e274;
                    } else {
                        phi_572_ = _e258;
                    }
                    let _e276 = phi_572_;
                    phi_574_ = -(_e276);
                } else {
                    phi_574_ = _e255;
                }
                let _e279 = phi_574_;
                let _e280 = f32(_e254);
                if (f64(_e280) < _e254) {
                    let _e283 = bitcast<u32>(_e280);
                    if ((_e283 & 2139095040u) == 2139095040u) {
                        phi_591_ = (_e280 < 0f);
                    } else {
                        phi_591_ = true;
                    }
                    let _e288 = phi_591_;
                    if _e288 {
                        if (_e280 > 0f) {
                            phi_609_ = bitcast<f32>((_e283 + 1u));
                        } else {
                            if (_e280 < 0f) {
                                phi_608_ = bitcast<f32>((_e283 - 1u));
                            } else {
                                phi_608_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e294 = phi_608_;
                            phi_609_ = _e294;
                        }
                        let _e298 = phi_609_;
                        phi_610_ = _e298;
                    } else {
                        phi_610_ = _e280;
                    }
                    let _e300 = phi_610_;
                    phi_611_ = _e300;
                } else {
                    phi_611_ = _e280;
                }
                let _e302 = phi_611_;
                let _e304 = (_e254 - f64(_e279));
                let _e306 = (f64(_e302) - _e254);
                if (_e304 < _e306) {
                    phi_636_ = true;
                } else {
                    if (_e304 == _e306) {
                        if ((bitcast<u32>(_e279) & 1u) == 0u) {
                            phi_630_ = false;
                        } else {
                            phi_630_ = true;
                        }
                        let _e313 = phi_630_;
                        phi_631_ = _e313;
                    } else {
                        phi_631_ = true;
                    }
                    let _e315 = phi_631_;
                    if _e315 {
                        phi_635_ = false;
                    } else {
                        phi_635_ = true;
                    }
                    let _e317 = phi_635_;
                    phi_636_ = _e317;
                }
                let _e319 = phi_636_;
                if _e319 {
                    phi_640_ = _e279;
                } else {
                    phi_640_ = _e302;
                }
                let _e321 = phi_640_;
                local_4.member[_e237.member_1] = _e321;
                let _e325 = local_3[_e237.member_1];
                let _e326 = (_e325 - _e251);
                let _e327 = f32(_e326);
                if (f64(_e327) > _e326) {
                    let _e330 = -(_e327);
                    let _e331 = bitcast<u32>(_e330);
                    if ((_e331 & 2139095040u) == 2139095040u) {
                        phi_672_ = (_e330 < 0f);
                    } else {
                        phi_672_ = true;
                    }
                    let _e336 = phi_672_;
                    if _e336 {
                        if (_e330 > 0f) {
                            phi_690_ = bitcast<f32>((_e331 + 1u));
                        } else {
                            if (_e330 < 0f) {
                                phi_689_ = bitcast<f32>((_e331 - 1u));
                            } else {
                                phi_689_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e342 = phi_689_;
                            phi_690_ = _e342;
                        }
                        let _e346 = phi_690_;
                        phi_691_ = _e346;
                    } else {
                        phi_691_ = _e330;
                    }
                    let _e348 = phi_691_;
                    phi_693_ = -(_e348);
                } else {
                    phi_693_ = _e327;
                }
                let _e351 = phi_693_;
                let _e352 = f32(_e326);
                if (f64(_e352) < _e326) {
                    let _e355 = bitcast<u32>(_e352);
                    if ((_e355 & 2139095040u) == 2139095040u) {
                        phi_710_ = (_e352 < 0f);
                    } else {
                        phi_710_ = true;
                    }
                    let _e360 = phi_710_;
                    if _e360 {
                        if (_e352 > 0f) {
                            phi_728_ = bitcast<f32>((_e355 + 1u));
                        } else {
                            if (_e352 < 0f) {
                                phi_727_ = bitcast<f32>((_e355 - 1u));
                            } else {
                                phi_727_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e366 = phi_727_;
                            phi_728_ = _e366;
                        }
                        let _e370 = phi_728_;
                        phi_729_ = _e370;
                    } else {
                        phi_729_ = _e352;
                    }
                    let _e372 = phi_729_;
                    phi_730_ = _e372;
                } else {
                    phi_730_ = _e352;
                }
                let _e374 = phi_730_;
                let _e376 = (_e326 - f64(_e351));
                let _e378 = (f64(_e374) - _e326);
                if (_e376 < _e378) {
                    phi_755_ = true;
                } else {
                    if (_e376 == _e378) {
                        if ((bitcast<u32>(_e351) & 1u) == 0u) {
                            phi_749_ = false;
                        } else {
                            phi_749_ = true;
                        }
                        let _e385 = phi_749_;
                        phi_750_ = _e385;
                    } else {
                        phi_750_ = true;
                    }
                    let _e387 = phi_750_;
                    if _e387 {
                        phi_754_ = false;
                    } else {
                        phi_754_ = true;
                    }
                    let _e389 = phi_754_;
                    phi_755_ = _e389;
                }
                let _e391 = phi_755_;
                if _e391 {
                    phi_759_ = _e351;
                } else {
                    phi_759_ = _e374;
                }
                let _e393 = phi_759_;
                local_4.member_1[_e237.member_1] = _e393;
            }
            continue;
            continuing {
                phi_481_ = _e235;
                break if !(_e241);
            }
        }
        let _e397 = local_4;
        paths.member[_e54] = type_20(array<f32, 4>(_e397.member[0], _e397.member[1], _e397.member[2], _e397.member[3]), array<f32, 4>(_e397.member_1[0], _e397.member_1[1], _e397.member_1[2], _e397.member_1[3]));
        let _e413 = local_8.member;
        let _e418 = local_8.member_1;
        let _e422 = bitcast<u64>(_e413[0]);
        let _e423 = u32(_e422);
        let _e425 = u32((_e422 / 4294967296lu));
        if ((_e425 >> bitcast<u32>(31i)) == 0u) {
            phi_823_ = array<u32, 2>();
            phi_824_ = true;
        } else {
            if (_e425 == 2147483648u) {
                if (_e423 == 0u) {
                    phi_813_ = false;
                } else {
                    phi_813_ = true;
                }
                let _e432 = phi_813_;
                phi_814_ = _e432;
            } else {
                phi_814_ = true;
            }
            let _e434 = phi_814_;
            if _e434 {
                phi_821_ = array<u32, 2>(~(_e423), ~(_e425));
                phi_822_ = false;
            } else {
                phi_821_ = array<u32, 2>();
                phi_822_ = true;
            }
            let _e439 = phi_821_;
            let _e441 = phi_822_;
            phi_823_ = _e439;
            phi_824_ = _e441;
        }
        let _e443 = phi_823_;
        let _e445 = phi_824_;
        if _e445 {
            phi_830_ = array<u32, 2>(_e423, (_e425 | 2147483648u));
        } else {
            phi_830_ = _e443;
        }
        let _e449 = phi_830_;
        let _e450 = bitcast<u64>(_e413[1]);
        let _e451 = u32(_e450);
        let _e453 = u32((_e450 / 4294967296lu));
        if ((_e453 >> bitcast<u32>(31i)) == 0u) {
            phi_859_ = array<u32, 2>();
            phi_860_ = true;
        } else {
            if (_e453 == 2147483648u) {
                if (_e451 == 0u) {
                    phi_849_ = false;
                } else {
                    phi_849_ = true;
                }
                let _e460 = phi_849_;
                phi_850_ = _e460;
            } else {
                phi_850_ = true;
            }
            let _e462 = phi_850_;
            if _e462 {
                phi_857_ = array<u32, 2>(~(_e451), ~(_e453));
                phi_858_ = false;
            } else {
                phi_857_ = array<u32, 2>();
                phi_858_ = true;
            }
            let _e467 = phi_857_;
            let _e469 = phi_858_;
            phi_859_ = _e467;
            phi_860_ = _e469;
        }
        let _e471 = phi_859_;
        let _e473 = phi_860_;
        if _e473 {
            phi_866_ = array<u32, 2>(_e451, (_e453 | 2147483648u));
        } else {
            phi_866_ = _e471;
        }
        let _e477 = phi_866_;
        let _e478 = bitcast<u64>(_e413[2]);
        let _e479 = u32(_e478);
        let _e481 = u32((_e478 / 4294967296lu));
        if ((_e481 >> bitcast<u32>(31i)) == 0u) {
            phi_895_ = array<u32, 2>();
            phi_896_ = true;
        } else {
            if (_e481 == 2147483648u) {
                if (_e479 == 0u) {
                    phi_885_ = false;
                } else {
                    phi_885_ = true;
                }
                let _e488 = phi_885_;
                phi_886_ = _e488;
            } else {
                phi_886_ = true;
            }
            let _e490 = phi_886_;
            if _e490 {
                phi_893_ = array<u32, 2>(~(_e479), ~(_e481));
                phi_894_ = false;
            } else {
                phi_893_ = array<u32, 2>();
                phi_894_ = true;
            }
            let _e495 = phi_893_;
            let _e497 = phi_894_;
            phi_895_ = _e495;
            phi_896_ = _e497;
        }
        let _e499 = phi_895_;
        let _e501 = phi_896_;
        if _e501 {
            phi_902_ = array<u32, 2>(_e479, (_e481 | 2147483648u));
        } else {
            phi_902_ = _e499;
        }
        let _e505 = phi_902_;
        let _e506 = bitcast<u64>(_e418[0]);
        let _e507 = u32(_e506);
        let _e509 = u32((_e506 / 4294967296lu));
        if ((_e509 >> bitcast<u32>(31i)) == 0u) {
            phi_931_ = array<u32, 2>();
            phi_932_ = true;
        } else {
            if (_e509 == 2147483648u) {
                if (_e507 == 0u) {
                    phi_921_ = false;
                } else {
                    phi_921_ = true;
                }
                let _e516 = phi_921_;
                phi_922_ = _e516;
            } else {
                phi_922_ = true;
            }
            let _e518 = phi_922_;
            if _e518 {
                phi_929_ = array<u32, 2>(~(_e507), ~(_e509));
                phi_930_ = false;
            } else {
                phi_929_ = array<u32, 2>();
                phi_930_ = true;
            }
            let _e523 = phi_929_;
            let _e525 = phi_930_;
            phi_931_ = _e523;
            phi_932_ = _e525;
        }
        let _e527 = phi_931_;
        let _e529 = phi_932_;
        if _e529 {
            phi_938_ = array<u32, 2>(_e507, (_e509 | 2147483648u));
        } else {
            phi_938_ = _e527;
        }
        let _e533 = phi_938_;
        let _e534 = bitcast<u64>(_e418[1]);
        let _e535 = u32(_e534);
        let _e537 = u32((_e534 / 4294967296lu));
        if ((_e537 >> bitcast<u32>(31i)) == 0u) {
            phi_967_ = array<u32, 2>();
            phi_968_ = true;
        } else {
            if (_e537 == 2147483648u) {
                if (_e535 == 0u) {
                    phi_957_ = false;
                } else {
                    phi_957_ = true;
                }
                let _e544 = phi_957_;
                phi_958_ = _e544;
            } else {
                phi_958_ = true;
            }
            let _e546 = phi_958_;
            if _e546 {
                phi_965_ = array<u32, 2>(~(_e535), ~(_e537));
                phi_966_ = false;
            } else {
                phi_965_ = array<u32, 2>();
                phi_966_ = true;
            }
            let _e551 = phi_965_;
            let _e553 = phi_966_;
            phi_967_ = _e551;
            phi_968_ = _e553;
        }
        let _e555 = phi_967_;
        let _e557 = phi_968_;
        if _e557 {
            phi_974_ = array<u32, 2>(_e535, (_e537 | 2147483648u));
        } else {
            phi_974_ = _e555;
        }
        let _e561 = phi_974_;
        let _e562 = bitcast<u64>(_e418[2]);
        let _e563 = u32(_e562);
        let _e565 = u32((_e562 / 4294967296lu));
        if ((_e565 >> bitcast<u32>(31i)) == 0u) {
            phi_1003_ = array<u32, 2>();
            phi_1004_ = true;
        } else {
            if (_e565 == 2147483648u) {
                if (_e563 == 0u) {
                    phi_993_ = false;
                } else {
                    phi_993_ = true;
                }
                let _e572 = phi_993_;
                phi_994_ = _e572;
            } else {
                phi_994_ = true;
            }
            let _e574 = phi_994_;
            if _e574 {
                phi_1001_ = array<u32, 2>(~(_e563), ~(_e565));
                phi_1002_ = false;
            } else {
                phi_1001_ = array<u32, 2>();
                phi_1002_ = true;
            }
            let _e579 = phi_1001_;
            let _e581 = phi_1002_;
            phi_1003_ = _e579;
            phi_1004_ = _e581;
        }
        let _e583 = phi_1003_;
        let _e585 = phi_1004_;
        if _e585 {
            phi_1010_ = array<u32, 2>(_e563, (_e565 | 2147483648u));
        } else {
            phi_1010_ = _e583;
        }
        let _e589 = phi_1010_;
        keys.member[_e54] = array<array<u32, 2>, 6>(_e449, _e477, _e505, _e533, _e561, _e589);
        local_1 = type_4(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_1016_ = type_16(0u, 3u);
        loop {
            let _e593 = phi_1016_;
            if (_e593.member < _e593.member_1) {
                phi_1017_ = type_16((_e593.member + 1u), _e593.member_1);
                phi_1040_ = type_16(1u, _e593.member);
            } else {
                phi_1017_ = _e593;
                phi_1040_ = type_16(0u, type_16().member_1);
            }
            let _e605 = phi_1017_;
            let _e607 = phi_1040_;
            let _e611 = (bitcast<i32>(_e607.member) != 0i);
            if _e611 {
                let _e614 = local_8.member[_e607.member_1];
                let _e615 = f32(_e614);
                if (f64(_e615) > _e614) {
                    let _e618 = -(_e615);
                    let _e619 = bitcast<u32>(_e618);
                    if ((_e619 & 2139095040u) == 2139095040u) {
                        phi_1072_ = (_e618 < 0f);
                    } else {
                        phi_1072_ = true;
                    }
                    let _e624 = phi_1072_;
                    if _e624 {
                        if (_e618 > 0f) {
                            phi_1090_ = bitcast<f32>((_e619 + 1u));
                        } else {
                            if (_e618 < 0f) {
                                phi_1089_ = bitcast<f32>((_e619 - 1u));
                            } else {
                                phi_1089_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e630 = phi_1089_;
                            phi_1090_ = _e630;
                        }
                        let _e634 = phi_1090_;
                        phi_1091_ = _e634;
                    } else {
                        phi_1091_ = _e618;
                    }
                    let _e636 = phi_1091_;
                    phi_1093_ = -(_e636);
                } else {
                    phi_1093_ = _e615;
                }
                let _e639 = phi_1093_;
                let _e640 = -(290000000000000000000000000000000000000f);
                if (_e639 > _e640) {
                    phi_1099_ = _e639;
                } else {
                    phi_1099_ = _e640;
                }
                let _e643 = phi_1099_;
                if (_e643 < 290000000000000000000000000000000000000f) {
                    phi_1104_ = _e643;
                } else {
                    phi_1104_ = 290000000000000000000000000000000000000f;
                }
                let _e646 = phi_1104_;
                local_1.member[_e607.member_1] = _e646;
                let _e651 = local_8.member_1[_e607.member_1];
                let _e652 = f32(_e651);
                if (f64(_e652) < _e651) {
                    let _e655 = bitcast<u32>(_e652);
                    if ((_e655 & 2139095040u) == 2139095040u) {
                        phi_1135_ = (_e652 < 0f);
                    } else {
                        phi_1135_ = true;
                    }
                    let _e660 = phi_1135_;
                    if _e660 {
                        if (_e652 > 0f) {
                            phi_1153_ = bitcast<f32>((_e655 + 1u));
                        } else {
                            if (_e652 < 0f) {
                                phi_1152_ = bitcast<f32>((_e655 - 1u));
                            } else {
                                phi_1152_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e666 = phi_1152_;
                            phi_1153_ = _e666;
                        }
                        let _e670 = phi_1153_;
                        phi_1154_ = _e670;
                    } else {
                        phi_1154_ = _e652;
                    }
                    let _e672 = phi_1154_;
                    phi_1155_ = _e672;
                } else {
                    phi_1155_ = _e652;
                }
                let _e674 = phi_1155_;
                let _e675 = -(290000000000000000000000000000000000000f);
                if (_e674 > _e675) {
                    phi_1161_ = _e674;
                } else {
                    phi_1161_ = _e675;
                }
                let _e678 = phi_1161_;
                if (_e678 < 290000000000000000000000000000000000000f) {
                    phi_1166_ = _e678;
                } else {
                    phi_1166_ = 290000000000000000000000000000000000000f;
                }
                let _e681 = phi_1166_;
                local_1.member_1[_e607.member_1] = _e681;
            }
            continue;
            continuing {
                phi_1016_ = _e605;
                break if !(_e611);
            }
        }
        let _e685 = local_1;
        local = _e685;
        phi_1199_ = type_16(0u, 3u);
        loop {
            let _e687 = phi_1199_;
            if (_e687.member < _e687.member_1) {
                phi_1200_ = type_16((_e687.member + 1u), _e687.member_1);
                phi_1223_ = type_16(1u, _e687.member);
            } else {
                phi_1200_ = _e687;
                phi_1223_ = type_16(0u, type_16().member_1);
            }
            let _e699 = phi_1200_;
            let _e701 = phi_1223_;
            let _e705 = (bitcast<i32>(_e701.member) != 0i);
            if _e705 {
                let _e708 = local.member[_e701.member_1];
                if (_e708 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1244_ = (_e708 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1244_ = false;
                }
                let _e713 = phi_1244_;
                if _e713 {
                    let _e719 = local_8.member[_e701.member_1];
                    let _e721 = bitcast<u64>(-(_e719));
                    let _e724 = u32((_e721 / 4294967296lu));
                    if ((_e724 >> bitcast<u32>(31i)) == 0u) {
                        phi_1267_ = ((u32(_e721) | _e724) != 0u);
                    } else {
                        phi_1267_ = false;
                    }
                    let _e731 = phi_1267_;
                    if _e731 {
                        phi_1271_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1271_ = 0f;
                    }
                    let _e733 = phi_1271_;
                    phi_1280_ = -(_e733);
                } else {
                    let _e716 = local.member[_e701.member_1];
                    phi_1280_ = _e716;
                }
                let _e736 = phi_1280_;
                local.member[_e701.member_1] = _e736;
                let _e741 = local.member_1[_e701.member_1];
                if (_e741 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1301_ = (_e741 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1301_ = false;
                }
                let _e746 = phi_1301_;
                if _e746 {
                    let _e752 = local_8.member_1[_e701.member_1];
                    let _e753 = bitcast<u64>(_e752);
                    let _e756 = u32((_e753 / 4294967296lu));
                    if ((_e756 >> bitcast<u32>(31i)) == 0u) {
                        phi_1324_ = ((u32(_e753) | _e756) != 0u);
                    } else {
                        phi_1324_ = false;
                    }
                    let _e763 = phi_1324_;
                    if _e763 {
                        phi_1328_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1328_ = 0f;
                    }
                    let _e765 = phi_1328_;
                    phi_1337_ = _e765;
                } else {
                    let _e749 = local.member_1[_e701.member_1];
                    phi_1337_ = _e749;
                }
                let _e767 = phi_1337_;
                local.member_1[_e701.member_1] = _e767;
            }
            continue;
            continuing {
                phi_1199_ = _e699;
                break if !(_e705);
            }
        }
        let _e771 = local;
        boxes.member[_e54] = type_4(array<f32, 3>(_e771.member[0], _e771.member[1], _e771.member[2]), array<f32, 3>(_e771.member_1[0], _e771.member_1[1], _e771.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
