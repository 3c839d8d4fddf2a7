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

struct type_30 {
    member: array<array<f64, 3>>,
}

struct type_31 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_24;
@group(0) @binding(1) 
var<storage> positions: type_30;
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
    var local_5: type_31;
    var local_6: type_31;
    var phi_172_: f64;
    var phi_179_: f64;
    var phi_186_: f64;
    var phi_194_: f64;
    var phi_201_: f64;
    var phi_208_: f64;
    var phi_238_: type_9;
    var phi_239_: type_9;
    var phi_262_: type_9;
    var phi_289_: bool;
    var phi_306_: f64;
    var phi_307_: f64;
    var phi_308_: f64;
    var phi_335_: bool;
    var phi_352_: f64;
    var phi_353_: f64;
    var phi_354_: f64;
    var phi_409_: type_9;
    var phi_410_: type_9;
    var phi_433_: type_9;
    var phi_491_: bool;
    var phi_508_: f32;
    var phi_509_: f32;
    var phi_510_: f32;
    var phi_512_: f32;
    var phi_529_: bool;
    var phi_546_: f32;
    var phi_547_: f32;
    var phi_548_: f32;
    var phi_549_: f32;
    var phi_568_: bool;
    var phi_569_: bool;
    var phi_573_: bool;
    var phi_574_: bool;
    var phi_578_: f32;
    var phi_611_: bool;
    var phi_628_: f32;
    var phi_629_: f32;
    var phi_630_: f32;
    var phi_632_: f32;
    var phi_649_: bool;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_698_: f32;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_760_: array<u32, 2>;
    var phi_761_: bool;
    var phi_762_: array<u32, 2>;
    var phi_763_: bool;
    var phi_769_: array<u32, 2>;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_796_: array<u32, 2>;
    var phi_797_: bool;
    var phi_798_: array<u32, 2>;
    var phi_799_: bool;
    var phi_805_: array<u32, 2>;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_832_: array<u32, 2>;
    var phi_833_: bool;
    var phi_834_: array<u32, 2>;
    var phi_835_: bool;
    var phi_841_: array<u32, 2>;
    var phi_860_: bool;
    var phi_861_: bool;
    var phi_868_: array<u32, 2>;
    var phi_869_: bool;
    var phi_870_: array<u32, 2>;
    var phi_871_: bool;
    var phi_877_: array<u32, 2>;
    var phi_896_: bool;
    var phi_897_: bool;
    var phi_904_: array<u32, 2>;
    var phi_905_: bool;
    var phi_906_: array<u32, 2>;
    var phi_907_: bool;
    var phi_913_: array<u32, 2>;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_940_: array<u32, 2>;
    var phi_941_: bool;
    var phi_942_: array<u32, 2>;
    var phi_943_: bool;
    var phi_949_: array<u32, 2>;
    var phi_955_: type_9;
    var phi_956_: type_9;
    var phi_979_: type_9;
    var phi_1011_: bool;
    var phi_1028_: f32;
    var phi_1029_: f32;
    var phi_1030_: f32;
    var phi_1032_: f32;
    var phi_1038_: f32;
    var phi_1043_: f32;
    var phi_1074_: bool;
    var phi_1091_: f32;
    var phi_1092_: f32;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_1100_: f32;
    var phi_1105_: f32;
    var phi_1138_: type_9;
    var phi_1139_: type_9;
    var phi_1162_: type_9;
    var phi_1183_: bool;
    var phi_1206_: bool;
    var phi_1210_: f32;
    var phi_1219_: f32;
    var phi_1240_: bool;
    var phi_1263_: bool;
    var phi_1267_: f32;
    var phi_1276_: f32;
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
            phi_172_ = _e60[0];
        } else {
            phi_172_ = _e66[0];
        }
        let _e72 = phi_172_;
        if (_e60[1] < _e66[1]) {
            phi_179_ = _e60[1];
        } else {
            phi_179_ = _e66[1];
        }
        let _e77 = phi_179_;
        if (_e60[2] < _e66[2]) {
            phi_186_ = _e60[2];
        } else {
            phi_186_ = _e66[2];
        }
        let _e82 = phi_186_;
        if (_e60[0] > _e66[0]) {
            phi_194_ = _e60[0];
        } else {
            phi_194_ = _e66[0];
        }
        let _e87 = phi_194_;
        if (_e60[1] > _e66[1]) {
            phi_201_ = _e60[1];
        } else {
            phi_201_ = _e66[1];
        }
        let _e92 = phi_201_;
        if (_e60[2] > _e66[2]) {
            phi_208_ = _e60[2];
        } else {
            phi_208_ = _e66[2];
        }
        let _e97 = phi_208_;
        let _e99 = params.member.member.member_9;
        let _e106 = bitcast<f64>(((u64(_e99[1]) * 4294967296lu) + u64(_e99[0])));
        if (_e106 > f64(0f)) {
            local_5 = type_31(array<f64, 3>(_e72, _e77, _e82), array<f64, 3>(_e87, _e92, _e97));
            phi_238_ = type_9(0u, 3u);
            loop {
                let _e116 = phi_238_;
                if (_e116.member < _e116.member_1) {
                    phi_239_ = type_9((_e116.member + 1u), _e116.member_1);
                    phi_262_ = type_9(1u, _e116.member);
                } else {
                    phi_239_ = _e116;
                    phi_262_ = type_9(0u, type_9().member_1);
                }
                let _e128 = phi_239_;
                let _e130 = phi_262_;
                let _e134 = (bitcast<i32>(_e130.member) != 0i);
                if _e134 {
                    let _e137 = local_5.member[_e130.member_1];
                    let _e139 = -((_e137 - _e106));
                    let _e140 = bitcast<u64>(_e139);
                    if ((_e140 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_289_ = (_e139 < 0.0lf);
                    } else {
                        phi_289_ = true;
                    }
                    let _e145 = phi_289_;
                    if _e145 {
                        if (_e139 > 0.0lf) {
                            phi_307_ = bitcast<f64>((_e140 + 1lu));
                        } else {
                            if (_e139 < 0.0lf) {
                                phi_306_ = bitcast<f64>((_e140 - 1lu));
                            } else {
                                phi_306_ = 5e-324lf;
                            }
                            let _e151 = phi_306_;
                            phi_307_ = _e151;
                        }
                        let _e155 = phi_307_;
                        phi_308_ = _e155;
                    } else {
                        phi_308_ = _e139;
                    }
                    let _e157 = phi_308_;
                    local_5.member[_e130.member_1] = -(_e157);
                    let _e163 = local_5.member_1[_e130.member_1];
                    let _e164 = (_e163 + _e106);
                    let _e165 = bitcast<u64>(_e164);
                    if ((_e165 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_335_ = (_e164 < 0.0lf);
                    } else {
                        phi_335_ = true;
                    }
                    let _e170 = phi_335_;
                    if _e170 {
                        if (_e164 > 0.0lf) {
                            phi_353_ = bitcast<f64>((_e165 + 1lu));
                        } else {
                            if (_e164 < 0.0lf) {
                                phi_352_ = bitcast<f64>((_e165 - 1lu));
                            } else {
                                phi_352_ = 5e-324lf;
                            }
                            let _e176 = phi_352_;
                            phi_353_ = _e176;
                        }
                        let _e180 = phi_353_;
                        phi_354_ = _e180;
                    } else {
                        phi_354_ = _e164;
                    }
                    let _e182 = phi_354_;
                    local_5.member_1[_e130.member_1] = _e182;
                }
                continue;
                continuing {
                    phi_238_ = _e128;
                    break if !(_e134);
                }
            }
        } else {
            local_5 = type_31(array<f64, 3>(_e72, _e77, _e82), array<f64, 3>(_e87, _e92, _e97));
        }
        let _e186 = local_5;
        local_6 = _e186;
        local_2 = array<f64, 3>(_e60[0], _e60[1], _e60[2]);
        local_3 = array<f64, 3>(_e66[0], _e66[1], _e66[2]);
        local_4.member = array<f32, 4>(0f, 0f, 0f, 0f);
        local_4.member_1 = array<f32, 4>(0f, 0f, 0f, 0f);
        phi_409_ = type_9(0u, 3u);
        loop {
            let _e199 = phi_409_;
            if (_e199.member < _e199.member_1) {
                phi_410_ = type_9((_e199.member + 1u), _e199.member_1);
                phi_433_ = type_9(1u, _e199.member);
            } else {
                phi_410_ = _e199;
                phi_433_ = type_9(0u, type_9().member_1);
            }
            let _e211 = phi_410_;
            let _e213 = phi_433_;
            let _e217 = (bitcast<i32>(_e213.member) != 0i);
            if _e217 {
                let _e220 = params.member.member.member_8[_e213.member_1];
                let _e227 = bitcast<f64>(((u64(_e220[1]) * 4294967296lu) + u64(_e220[0])));
                let _e229 = params.member.member.member_10;
                let _e236 = bitcast<f64>(((u64(_e229[1]) * 4294967296lu) + u64(_e229[0])));
                let _e238 = local_2[_e213.member_1];
                let _e240 = ((_e238 - _e227) * _e236);
                let _e241 = f32(_e240);
                if (f64(_e241) > _e240) {
                    let _e244 = -(_e241);
                    let _e245 = bitcast<u32>(_e244);
                    if ((_e245 & 2139095040u) == 2139095040u) {
                        phi_491_ = (_e244 < 0f);
                    } else {
                        phi_491_ = true;
                    }
                    let _e250 = phi_491_;
                    if _e250 {
                        if (_e244 > 0f) {
                            phi_509_ = bitcast<f32>((_e245 + 1u));
                        } else {
                            if (_e244 < 0f) {
                                phi_508_ = bitcast<f32>((_e245 - 1u));
                            } else {
                                phi_508_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e256 = phi_508_;
                            phi_509_ = _e256;
                        }
                        let _e260 = phi_509_;
                        phi_510_ = _e260;
                    } else {
                        phi_510_ = _e244;
                    }
                    let _e262 = phi_510_;
                    phi_512_ = -(_e262);
                } else {
                    phi_512_ = _e241;
                }
                let _e265 = phi_512_;
                let _e266 = f32(_e240);
                if (f64(_e266) < _e240) {
                    let _e269 = bitcast<u32>(_e266);
                    if ((_e269 & 2139095040u) == 2139095040u) {
                        phi_529_ = (_e266 < 0f);
                    } else {
                        phi_529_ = true;
                    }
                    let _e274 = phi_529_;
                    if _e274 {
                        if (_e266 > 0f) {
                            phi_547_ = bitcast<f32>((_e269 + 1u));
                        } else {
                            if (_e266 < 0f) {
                                phi_546_ = bitcast<f32>((_e269 - 1u));
                            } else {
                                phi_546_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e280 = phi_546_;
                            phi_547_ = _e280;
                        }
                        let _e284 = phi_547_;
                        phi_548_ = _e284;
                    } else {
                        phi_548_ = _e266;
                    }
                    let _e286 = phi_548_;
                    phi_549_ = _e286;
                } else {
                    phi_549_ = _e266;
                }
                let _e288 = phi_549_;
                let _e290 = (_e240 - f64(_e265));
                let _e292 = (f64(_e288) - _e240);
                if (_e290 < _e292) {
                    phi_574_ = true;
                } else {
                    if (_e290 == _e292) {
                        if ((bitcast<u32>(_e265) & 1u) == 0u) {
                            phi_568_ = false;
                        } else {
                            phi_568_ = true;
                        }
                        let _e299 = phi_568_;
                        phi_569_ = _e299;
                    } else {
                        phi_569_ = true;
                    }
                    let _e301 = phi_569_;
                    if _e301 {
                        phi_573_ = false;
                    } else {
                        phi_573_ = true;
                    }
                    let _e303 = phi_573_;
                    phi_574_ = _e303;
                }
                let _e305 = phi_574_;
                if _e305 {
                    phi_578_ = _e265;
                } else {
                    phi_578_ = _e288;
                }
                let _e307 = phi_578_;
                local_4.member[_e213.member_1] = _e307;
                let _e311 = local_3[_e213.member_1];
                let _e313 = ((_e311 - _e227) * _e236);
                let _e314 = f32(_e313);
                if (f64(_e314) > _e313) {
                    let _e317 = -(_e314);
                    let _e318 = bitcast<u32>(_e317);
                    if ((_e318 & 2139095040u) == 2139095040u) {
                        phi_611_ = (_e317 < 0f);
                    } else {
                        phi_611_ = true;
                    }
                    let _e323 = phi_611_;
                    if _e323 {
                        if (_e317 > 0f) {
                            phi_629_ = bitcast<f32>((_e318 + 1u));
                        } else {
                            if (_e317 < 0f) {
                                phi_628_ = bitcast<f32>((_e318 - 1u));
                            } else {
                                phi_628_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e329 = phi_628_;
                            phi_629_ = _e329;
                        }
                        let _e333 = phi_629_;
                        phi_630_ = _e333;
                    } else {
                        phi_630_ = _e317;
                    }
                    let _e335 = phi_630_;
                    phi_632_ = -(_e335);
                } else {
                    phi_632_ = _e314;
                }
                let _e338 = phi_632_;
                let _e339 = f32(_e313);
                if (f64(_e339) < _e313) {
                    let _e342 = bitcast<u32>(_e339);
                    if ((_e342 & 2139095040u) == 2139095040u) {
                        phi_649_ = (_e339 < 0f);
                    } else {
                        phi_649_ = true;
                    }
                    let _e347 = phi_649_;
                    if _e347 {
                        if (_e339 > 0f) {
                            phi_667_ = bitcast<f32>((_e342 + 1u));
                        } else {
                            if (_e339 < 0f) {
                                phi_666_ = bitcast<f32>((_e342 - 1u));
                            } else {
                                phi_666_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e353 = phi_666_;
                            phi_667_ = _e353;
                        }
                        let _e357 = phi_667_;
                        phi_668_ = _e357;
                    } else {
                        phi_668_ = _e339;
                    }
                    let _e359 = phi_668_;
                    phi_669_ = _e359;
                } else {
                    phi_669_ = _e339;
                }
                let _e361 = phi_669_;
                let _e363 = (_e313 - f64(_e338));
                let _e365 = (f64(_e361) - _e313);
                if (_e363 < _e365) {
                    phi_694_ = true;
                } else {
                    if (_e363 == _e365) {
                        if ((bitcast<u32>(_e338) & 1u) == 0u) {
                            phi_688_ = false;
                        } else {
                            phi_688_ = true;
                        }
                        let _e372 = phi_688_;
                        phi_689_ = _e372;
                    } else {
                        phi_689_ = true;
                    }
                    let _e374 = phi_689_;
                    if _e374 {
                        phi_693_ = false;
                    } else {
                        phi_693_ = true;
                    }
                    let _e376 = phi_693_;
                    phi_694_ = _e376;
                }
                let _e378 = phi_694_;
                if _e378 {
                    phi_698_ = _e338;
                } else {
                    phi_698_ = _e361;
                }
                let _e380 = phi_698_;
                local_4.member_1[_e213.member_1] = _e380;
            }
            continue;
            continuing {
                phi_409_ = _e211;
                break if !(_e217);
            }
        }
        let _e384 = local_4;
        paths.member[_e52] = type_15(array<f32, 4>(_e384.member[0], _e384.member[1], _e384.member[2], _e384.member[3]), array<f32, 4>(_e384.member_1[0], _e384.member_1[1], _e384.member_1[2], _e384.member_1[3]));
        let _e400 = local_6.member;
        let _e405 = local_6.member_1;
        let _e409 = bitcast<u64>(_e400[0]);
        let _e410 = u32(_e409);
        let _e412 = u32((_e409 / 4294967296lu));
        if ((_e412 >> bitcast<u32>(31i)) == 0u) {
            phi_762_ = array<u32, 2>();
            phi_763_ = true;
        } else {
            if (_e412 == 2147483648u) {
                if (_e410 == 0u) {
                    phi_752_ = false;
                } else {
                    phi_752_ = true;
                }
                let _e419 = phi_752_;
                phi_753_ = _e419;
            } else {
                phi_753_ = true;
            }
            let _e421 = phi_753_;
            if _e421 {
                phi_760_ = array<u32, 2>(~(_e410), ~(_e412));
                phi_761_ = false;
            } else {
                phi_760_ = array<u32, 2>();
                phi_761_ = true;
            }
            let _e426 = phi_760_;
            let _e428 = phi_761_;
            phi_762_ = _e426;
            phi_763_ = _e428;
        }
        let _e430 = phi_762_;
        let _e432 = phi_763_;
        if _e432 {
            phi_769_ = array<u32, 2>(_e410, (_e412 | 2147483648u));
        } else {
            phi_769_ = _e430;
        }
        let _e436 = phi_769_;
        let _e437 = bitcast<u64>(_e400[1]);
        let _e438 = u32(_e437);
        let _e440 = u32((_e437 / 4294967296lu));
        if ((_e440 >> bitcast<u32>(31i)) == 0u) {
            phi_798_ = array<u32, 2>();
            phi_799_ = true;
        } else {
            if (_e440 == 2147483648u) {
                if (_e438 == 0u) {
                    phi_788_ = false;
                } else {
                    phi_788_ = true;
                }
                let _e447 = phi_788_;
                phi_789_ = _e447;
            } else {
                phi_789_ = true;
            }
            let _e449 = phi_789_;
            if _e449 {
                phi_796_ = array<u32, 2>(~(_e438), ~(_e440));
                phi_797_ = false;
            } else {
                phi_796_ = array<u32, 2>();
                phi_797_ = true;
            }
            let _e454 = phi_796_;
            let _e456 = phi_797_;
            phi_798_ = _e454;
            phi_799_ = _e456;
        }
        let _e458 = phi_798_;
        let _e460 = phi_799_;
        if _e460 {
            phi_805_ = array<u32, 2>(_e438, (_e440 | 2147483648u));
        } else {
            phi_805_ = _e458;
        }
        let _e464 = phi_805_;
        let _e465 = bitcast<u64>(_e400[2]);
        let _e466 = u32(_e465);
        let _e468 = u32((_e465 / 4294967296lu));
        if ((_e468 >> bitcast<u32>(31i)) == 0u) {
            phi_834_ = array<u32, 2>();
            phi_835_ = true;
        } else {
            if (_e468 == 2147483648u) {
                if (_e466 == 0u) {
                    phi_824_ = false;
                } else {
                    phi_824_ = true;
                }
                let _e475 = phi_824_;
                phi_825_ = _e475;
            } else {
                phi_825_ = true;
            }
            let _e477 = phi_825_;
            if _e477 {
                phi_832_ = array<u32, 2>(~(_e466), ~(_e468));
                phi_833_ = false;
            } else {
                phi_832_ = array<u32, 2>();
                phi_833_ = true;
            }
            let _e482 = phi_832_;
            let _e484 = phi_833_;
            phi_834_ = _e482;
            phi_835_ = _e484;
        }
        let _e486 = phi_834_;
        let _e488 = phi_835_;
        if _e488 {
            phi_841_ = array<u32, 2>(_e466, (_e468 | 2147483648u));
        } else {
            phi_841_ = _e486;
        }
        let _e492 = phi_841_;
        let _e493 = bitcast<u64>(_e405[0]);
        let _e494 = u32(_e493);
        let _e496 = u32((_e493 / 4294967296lu));
        if ((_e496 >> bitcast<u32>(31i)) == 0u) {
            phi_870_ = array<u32, 2>();
            phi_871_ = true;
        } else {
            if (_e496 == 2147483648u) {
                if (_e494 == 0u) {
                    phi_860_ = false;
                } else {
                    phi_860_ = true;
                }
                let _e503 = phi_860_;
                phi_861_ = _e503;
            } else {
                phi_861_ = true;
            }
            let _e505 = phi_861_;
            if _e505 {
                phi_868_ = array<u32, 2>(~(_e494), ~(_e496));
                phi_869_ = false;
            } else {
                phi_868_ = array<u32, 2>();
                phi_869_ = true;
            }
            let _e510 = phi_868_;
            let _e512 = phi_869_;
            phi_870_ = _e510;
            phi_871_ = _e512;
        }
        let _e514 = phi_870_;
        let _e516 = phi_871_;
        if _e516 {
            phi_877_ = array<u32, 2>(_e494, (_e496 | 2147483648u));
        } else {
            phi_877_ = _e514;
        }
        let _e520 = phi_877_;
        let _e521 = bitcast<u64>(_e405[1]);
        let _e522 = u32(_e521);
        let _e524 = u32((_e521 / 4294967296lu));
        if ((_e524 >> bitcast<u32>(31i)) == 0u) {
            phi_906_ = array<u32, 2>();
            phi_907_ = true;
        } else {
            if (_e524 == 2147483648u) {
                if (_e522 == 0u) {
                    phi_896_ = false;
                } else {
                    phi_896_ = true;
                }
                let _e531 = phi_896_;
                phi_897_ = _e531;
            } else {
                phi_897_ = true;
            }
            let _e533 = phi_897_;
            if _e533 {
                phi_904_ = array<u32, 2>(~(_e522), ~(_e524));
                phi_905_ = false;
            } else {
                phi_904_ = array<u32, 2>();
                phi_905_ = true;
            }
            let _e538 = phi_904_;
            let _e540 = phi_905_;
            phi_906_ = _e538;
            phi_907_ = _e540;
        }
        let _e542 = phi_906_;
        let _e544 = phi_907_;
        if _e544 {
            phi_913_ = array<u32, 2>(_e522, (_e524 | 2147483648u));
        } else {
            phi_913_ = _e542;
        }
        let _e548 = phi_913_;
        let _e549 = bitcast<u64>(_e405[2]);
        let _e550 = u32(_e549);
        let _e552 = u32((_e549 / 4294967296lu));
        if ((_e552 >> bitcast<u32>(31i)) == 0u) {
            phi_942_ = array<u32, 2>();
            phi_943_ = true;
        } else {
            if (_e552 == 2147483648u) {
                if (_e550 == 0u) {
                    phi_932_ = false;
                } else {
                    phi_932_ = true;
                }
                let _e559 = phi_932_;
                phi_933_ = _e559;
            } else {
                phi_933_ = true;
            }
            let _e561 = phi_933_;
            if _e561 {
                phi_940_ = array<u32, 2>(~(_e550), ~(_e552));
                phi_941_ = false;
            } else {
                phi_940_ = array<u32, 2>();
                phi_941_ = true;
            }
            let _e566 = phi_940_;
            let _e568 = phi_941_;
            phi_942_ = _e566;
            phi_943_ = _e568;
        }
        let _e570 = phi_942_;
        let _e572 = phi_943_;
        if _e572 {
            phi_949_ = array<u32, 2>(_e550, (_e552 | 2147483648u));
        } else {
            phi_949_ = _e570;
        }
        let _e576 = phi_949_;
        keys.member[_e52] = array<array<u32, 2>, 6>(_e436, _e464, _e492, _e520, _e548, _e576);
        local_1 = type_19(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_955_ = type_9(0u, 3u);
        loop {
            let _e580 = phi_955_;
            if (_e580.member < _e580.member_1) {
                phi_956_ = type_9((_e580.member + 1u), _e580.member_1);
                phi_979_ = type_9(1u, _e580.member);
            } else {
                phi_956_ = _e580;
                phi_979_ = type_9(0u, type_9().member_1);
            }
            let _e592 = phi_956_;
            let _e594 = phi_979_;
            let _e598 = (bitcast<i32>(_e594.member) != 0i);
            if _e598 {
                let _e601 = local_6.member[_e594.member_1];
                let _e602 = f32(_e601);
                if (f64(_e602) > _e601) {
                    let _e605 = -(_e602);
                    let _e606 = bitcast<u32>(_e605);
                    if ((_e606 & 2139095040u) == 2139095040u) {
                        phi_1011_ = (_e605 < 0f);
                    } else {
                        phi_1011_ = true;
                    }
                    let _e611 = phi_1011_;
                    if _e611 {
                        if (_e605 > 0f) {
                            phi_1029_ = bitcast<f32>((_e606 + 1u));
                        } else {
                            if (_e605 < 0f) {
                                phi_1028_ = bitcast<f32>((_e606 - 1u));
                            } else {
                                phi_1028_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e617 = phi_1028_;
                            phi_1029_ = _e617;
                        }
                        let _e621 = phi_1029_;
                        phi_1030_ = _e621;
                    } else {
                        phi_1030_ = _e605;
                    }
                    let _e623 = phi_1030_;
                    phi_1032_ = -(_e623);
                } else {
                    phi_1032_ = _e602;
                }
                let _e626 = phi_1032_;
                let _e627 = -(290000000000000000000000000000000000000f);
                if (_e626 > _e627) {
                    phi_1038_ = _e626;
                } else {
                    phi_1038_ = _e627;
                }
                let _e630 = phi_1038_;
                if (_e630 < 290000000000000000000000000000000000000f) {
                    phi_1043_ = _e630;
                } else {
                    phi_1043_ = 290000000000000000000000000000000000000f;
                }
                let _e633 = phi_1043_;
                local_1.member[_e594.member_1] = _e633;
                let _e638 = local_6.member_1[_e594.member_1];
                let _e639 = f32(_e638);
                if (f64(_e639) < _e638) {
                    let _e642 = bitcast<u32>(_e639);
                    if ((_e642 & 2139095040u) == 2139095040u) {
                        phi_1074_ = (_e639 < 0f);
                    } else {
                        phi_1074_ = true;
                    }
                    let _e647 = phi_1074_;
                    if _e647 {
                        if (_e639 > 0f) {
                            phi_1092_ = bitcast<f32>((_e642 + 1u));
                        } else {
                            if (_e639 < 0f) {
                                phi_1091_ = bitcast<f32>((_e642 - 1u));
                            } else {
                                phi_1091_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e653 = phi_1091_;
                            phi_1092_ = _e653;
                        }
                        let _e657 = phi_1092_;
                        phi_1093_ = _e657;
                    } else {
                        phi_1093_ = _e639;
                    }
                    let _e659 = phi_1093_;
                    phi_1094_ = _e659;
                } else {
                    phi_1094_ = _e639;
                }
                let _e661 = phi_1094_;
                let _e662 = -(290000000000000000000000000000000000000f);
                if (_e661 > _e662) {
                    phi_1100_ = _e661;
                } else {
                    phi_1100_ = _e662;
                }
                let _e665 = phi_1100_;
                if (_e665 < 290000000000000000000000000000000000000f) {
                    phi_1105_ = _e665;
                } else {
                    phi_1105_ = 290000000000000000000000000000000000000f;
                }
                let _e668 = phi_1105_;
                local_1.member_1[_e594.member_1] = _e668;
            }
            continue;
            continuing {
                phi_955_ = _e592;
                break if !(_e598);
            }
        }
        let _e672 = local_1;
        local = _e672;
        phi_1138_ = type_9(0u, 3u);
        loop {
            let _e674 = phi_1138_;
            if (_e674.member < _e674.member_1) {
                phi_1139_ = type_9((_e674.member + 1u), _e674.member_1);
                phi_1162_ = type_9(1u, _e674.member);
            } else {
                phi_1139_ = _e674;
                phi_1162_ = type_9(0u, type_9().member_1);
            }
            let _e686 = phi_1139_;
            let _e688 = phi_1162_;
            let _e692 = (bitcast<i32>(_e688.member) != 0i);
            if _e692 {
                let _e695 = local.member[_e688.member_1];
                if (_e695 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1183_ = (_e695 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1183_ = false;
                }
                let _e700 = phi_1183_;
                if _e700 {
                    let _e706 = local_6.member[_e688.member_1];
                    let _e708 = bitcast<u64>(-(_e706));
                    let _e711 = u32((_e708 / 4294967296lu));
                    if ((_e711 >> bitcast<u32>(31i)) == 0u) {
                        phi_1206_ = ((u32(_e708) | _e711) != 0u);
                    } else {
                        phi_1206_ = false;
                    }
                    let _e718 = phi_1206_;
                    if _e718 {
                        phi_1210_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1210_ = 0f;
                    }
                    let _e720 = phi_1210_;
                    phi_1219_ = -(_e720);
                } else {
                    let _e703 = local.member[_e688.member_1];
                    phi_1219_ = _e703;
                }
                let _e723 = phi_1219_;
                local.member[_e688.member_1] = _e723;
                let _e728 = local.member_1[_e688.member_1];
                if (_e728 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1240_ = (_e728 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1240_ = false;
                }
                let _e733 = phi_1240_;
                if _e733 {
                    let _e739 = local_6.member_1[_e688.member_1];
                    let _e740 = bitcast<u64>(_e739);
                    let _e743 = u32((_e740 / 4294967296lu));
                    if ((_e743 >> bitcast<u32>(31i)) == 0u) {
                        phi_1263_ = ((u32(_e740) | _e743) != 0u);
                    } else {
                        phi_1263_ = false;
                    }
                    let _e750 = phi_1263_;
                    if _e750 {
                        phi_1267_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1267_ = 0f;
                    }
                    let _e752 = phi_1267_;
                    phi_1276_ = _e752;
                } else {
                    let _e736 = local.member_1[_e688.member_1];
                    phi_1276_ = _e736;
                }
                let _e754 = phi_1276_;
                local.member_1[_e688.member_1] = _e754;
            }
            continue;
            continuing {
                phi_1138_ = _e686;
                break if !(_e692);
            }
        }
        let _e758 = local;
        boxes.member[_e52] = type_19(array<f32, 3>(_e758.member[0], _e758.member[1], _e758.member[2]), array<f32, 3>(_e758.member_1[0], _e758.member_1[1], _e758.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
