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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
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
}

struct type_24 {
    member: type_21,
    member_1: array<array<u32, 2>, 8>,
}

struct type_25 {
    member: type_7,
    member_1: type_8,
    member_2: type_24,
}

struct type_26 {
    member: type_25,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> boxes: type_18;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_29;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
@group(0) @binding(0) 
var<storage> params: type_26;
@group(0) @binding(2) 
var<storage, read_write> control: type_29;
@group(0) @binding(3) 
var<storage, read_write> nodes: type_29;
@group(0) @binding(5) 
var<storage, read_write> front: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_151_: u32;
    var phi_168_: type_9;
    var phi_169_: type_9;
    var phi_192_: type_9;
    var phi_210_: u32;
    var phi_240_: bool;
    var phi_244_: u32;
    var phi_245_: u32;
    var phi_246_: u32;
    var phi_300_: u32;
    var phi_305_: u32;
    var phi_310_: u32;
    var phi_319_: u32;
    var phi_325_: u32;
    var phi_331_: u32;
    var phi_272_: u32;
    var phi_278_: u32;
    var phi_332_: u32;
    var phi_333_: u32;
    var phi_334_: u32;
    var phi_353_: u32;
    var phi_354_: u32;
    var phi_362_: type_9;
    var phi_363_: type_9;
    var phi_386_: type_9;
    var phi_460_: array<u32, 2>;
    var phi_461_: array<u32, 2>;
    var phi_472_: array<u32, 2>;
    var phi_490_: array<u32, 2>;
    var phi_513_: u32;
    var phi_514_: bool;
    var phi_515_: u32;
    var phi_516_: bool;
    var phi_522_: u32;
    var phi_528_: u32;
    var phi_537_: u32;
    var phi_652_: u32;
    var phi_653_: bool;
    var phi_654_: u32;
    var phi_655_: bool;
    var phi_661_: u32;
    var phi_701_: type_20;
    var phi_702_: bool;
    var phi_703_: type_20;
    var phi_704_: bool;
    var phi_716_: bool;
    var phi_722_: u32;
    var phi_781_: type_9;
    var phi_784_: u32;
    var phi_786_: u32;
    var phi_782_: type_9;
    var phi_809_: type_9;
    var phi_865_: u32;
    var phi_866_: u32;
    var phi_867_: u32;
    var phi_868_: bool;
    var phi_785_: u32;
    var phi_787_: u32;
    var phi_869_: bool;
    var phi_870_: u32;
    var phi_881_: u32;
    var phi_882_: u32;
    var phi_883_: u32;
    var phi_896_: u32;
    var phi_908_: u32;
    var phi_909_: array<u32, 2>;
    var phi_910_: u32;
    var phi_911_: array<u32, 2>;
    var phi_923_: array<u32, 2>;
    var phi_924_: array<u32, 2>;
    var phi_957_: u32;
    var phi_1032_: u32;
    var phi_1035_: type_9;
    var phi_1038_: u32;
    var phi_1040_: u32;
    var phi_1042_: u32;
    var phi_1036_: type_9;
    var phi_1065_: type_9;
    var phi_1091_: u32;
    var phi_1182_: u32;
    var phi_1183_: u32;
    var phi_1184_: u32;
    var phi_1185_: bool;
    var phi_1039_: u32;
    var phi_1041_: u32;
    var phi_1043_: u32;
    var phi_1186_: bool;
    var phi_1187_: bool;
    var phi_1188_: bool;
    var phi_1207_: u32;
    var phi_1211_: u32;
    var phi_1268_: type_9;
    var phi_1269_: type_9;
    var phi_1292_: type_9;
    var phi_1348_: u32;
    var phi_1351_: type_9;
    var phi_1352_: type_9;
    var phi_1375_: type_9;
    var phi_1447_: type_9;
    var phi_1448_: type_9;
    var phi_1471_: type_9;
    var phi_1551_: bool;
    var phi_1552_: bool;
    var local: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e59 = id_2;
    let _e60 = n_2;
    let _e61 = lane_2;
    let _e72 = ((_e59.y * _e60.x) + _e59.x);
    let _e75 = params.member.member_2.member;
    let _e78 = params.member.member_1.member_1;
    let _e80 = (_e78 % 2u);
    let _e83 = atomicLoad((&control.member[_e78]));
    if (_e75.member_3 < _e83) {
        phi_151_ = _e75.member_3;
    } else {
        phi_151_ = _e83;
    }
    let _e86 = phi_151_;
    let _e87 = (_e80 * _e75.member_3);
    let _e89 = ((1u - _e80) * _e75.member_3);
    let _e91 = params.member.member_1.member_3;
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_168_ = type_9(0u, _e75.member_11);
    loop {
        let _e100 = phi_168_;
        if (_e100.member < _e100.member_1) {
            phi_169_ = type_9((_e100.member + 1u), _e100.member_1);
            phi_192_ = type_9(1u, _e100.member);
        } else {
            phi_169_ = _e100;
            phi_192_ = type_9(0u, type_9().member_1);
        }
        let _e112 = phi_169_;
        let _e114 = phi_192_;
        if (bitcast<i32>(_e114.member) != 0i) {
            if (_e61 == 0u) {
                let _e121 = atomicLoad((&shared_[0u]));
                if (4u < _e121) {
                    phi_210_ = 4u;
                } else {
                    phi_210_ = _e121;
                }
                let _e124 = phi_210_;
                if (_e75.member_9 > 0u) {
                    if (_e114.member_1 >= 16u) {
                        let _e130 = atomicLoad((&control.member[(1024u + _e78)]));
                        if (_e75.member_9 > 0u) {
                            phi_240_ = ((_e130 * 100u) >= (_e75.member_9 << bitcast<u32>((_e75.member_7 & 31u))));
                        } else {
                            phi_240_ = false;
                        }
                        let _e139 = phi_240_;
                        if _e139 {
                            phi_244_ = 2u;
                        } else {
                            phi_244_ = 0u;
                        }
                        let _e141 = phi_244_;
                        phi_245_ = _e141;
                    } else {
                        phi_245_ = 0u;
                    }
                    let _e143 = phi_245_;
                    phi_246_ = _e143;
                } else {
                    phi_246_ = 0u;
                }
                let _e145 = phi_246_;
                let _e146 = (4u - _e124);
                if (_e145 == 0u) {
                    if (_e146 > 0u) {
                        let _e150 = atomicLoad((&shared_[5u]));
                        if (_e75.member_6 == 0u) {
                            if (_e72 < _e86) {
                                phi_272_ = ((((_e86 - 1u) - _e72) >> bitcast<u32>((_e75.member_7 & 31u))) + 1u);
                            } else {
                                phi_272_ = 0u;
                            }
                            let _e193 = phi_272_;
                            let _e194 = (_e193 - _e150);
                            if (_e146 < _e194) {
                                phi_278_ = _e146;
                            } else {
                                phi_278_ = _e194;
                            }
                            let _e197 = phi_278_;
                            atomicStore((&shared_[3u]), (_e72 + (_e150 << bitcast<u32>((_e75.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e75.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e150 + _e197));
                            phi_332_ = _e197;
                        } else {
                            if (_e150 == 0u) {
                                let _e158 = (_e86 >> bitcast<u32>(((_e75.member_7 + 2u) & 31u)));
                                if (_e75.member_8 < _e158) {
                                    phi_300_ = _e158;
                                } else {
                                    phi_300_ = _e75.member_8;
                                }
                                let _e161 = phi_300_;
                                if (128u < _e161) {
                                    phi_305_ = 128u;
                                } else {
                                    phi_305_ = _e161;
                                }
                                let _e164 = phi_305_;
                                if (_e146 < _e164) {
                                    phi_310_ = _e146;
                                } else {
                                    phi_310_ = _e164;
                                }
                                let _e167 = phi_310_;
                                let _e170 = atomicAdd((&control.member[(512u + _e78)]), _e167);
                                if (_e86 < _e170) {
                                    phi_319_ = _e86;
                                } else {
                                    phi_319_ = _e170;
                                }
                                let _e173 = phi_319_;
                                let _e174 = (_e86 - _e173);
                                if (_e167 < _e174) {
                                    phi_325_ = _e167;
                                } else {
                                    phi_325_ = _e174;
                                }
                                let _e177 = phi_325_;
                                atomicStore((&shared_[3u]), _e170);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e177 < _e167)));
                                phi_331_ = _e177;
                            } else {
                                phi_331_ = 0u;
                            }
                            let _e184 = phi_331_;
                            phi_332_ = _e184;
                        }
                        let _e210 = phi_332_;
                        phi_333_ = _e210;
                    } else {
                        phi_333_ = 0u;
                    }
                    let _e212 = phi_333_;
                    phi_334_ = _e212;
                } else {
                    phi_334_ = 0u;
                }
                let _e214 = phi_334_;
                if (_e145 == 0u) {
                    if ((_e124 + _e214) == 0u) {
                        if (_e75.member_9 > 0u) {
                            let _e222 = atomicAdd((&control.member[(1024u + _e78)]), 1u);
                        }
                        phi_353_ = 1u;
                    } else {
                        phi_353_ = _e145;
                    }
                    let _e224 = phi_353_;
                    phi_354_ = _e224;
                } else {
                    phi_354_ = _e145;
                }
                let _e226 = phi_354_;
                atomicStore((&shared_[1u]), _e124);
                atomicStore((&shared_[2u]), _e214);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                phi_362_ = type_9(0u, 4u);
                loop {
                    let _e233 = phi_362_;
                    if (_e233.member < _e233.member_1) {
                        phi_363_ = type_9((_e233.member + 1u), _e233.member_1);
                        phi_386_ = type_9(1u, _e233.member);
                    } else {
                        phi_363_ = _e233;
                        phi_386_ = type_9(0u, type_9().member_1);
                    }
                    let _e245 = phi_363_;
                    let _e247 = phi_386_;
                    let _e251 = (bitcast<i32>(_e247.member) != 0i);
                    if _e251 {
                        atomicStore((&shared_[(18u + _e247.member_1)]), 0u);
                    }
                    continue;
                    continuing {
                        phi_362_ = _e245;
                        break if !(_e251);
                    }
                }
                state[0u] = _e226;
            }
            let _e257 = workgroupUniformLoad((&state[0u]));
            if (_e257 != 0u) {
                phi_1187_ = false;
            } else {
                let _e259 = (_e61 / 32u);
                let _e261 = atomicLoad((&shared_[1u]));
                let _e263 = atomicLoad((&shared_[2u]));
                if (_e259 < _e261) {
                    let _e286 = atomicLoad((&shared_[0u]));
                    let _e289 = (2u * ((_e286 - 1u) - _e259));
                    let _e291 = stack[_e289];
                    let _e294 = stack[(_e289 + 1u)];
                    phi_461_ = array<u32, 2>(_e291, _e294);
                } else {
                    if (_e259 < (_e261 + _e263)) {
                        let _e268 = atomicLoad((&shared_[3u]));
                        let _e271 = atomicLoad((&shared_[4u]));
                        let _e275 = (2u * (_e87 + (_e268 + ((_e259 - _e261) * _e271))));
                        let _e278 = atomicLoad((&nodes.member[(4u + _e275)]));
                        let _e281 = atomicLoad((&nodes.member[(_e275 + 5u)]));
                        phi_460_ = array<u32, 2>(_e278, _e281);
                    } else {
                        phi_460_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e284 = phi_460_;
                    phi_461_ = _e284;
                }
                let _e297 = phi_461_;
                let _e298 = (_e61 / 32u);
                let _e299 = (_e61 % 32u);
                let _e301 = (_e297[0] != 4294967295u);
                if _e301 {
                    phi_472_ = _e297;
                } else {
                    phi_472_ = array<u32, 2>(134217728u, 0u);
                }
                let _e303 = phi_472_;
                let _e307 = (_e303[0] >> bitcast<u32>(27u));
                let _e308 = (_e303[0] & 134217727u);
                let _e309 = (_e307 - 1u);
                let _e311 = ((_e308 * 32u) + _e299);
                let _e312 = (_e303[1] * 32u);
                let _e316 = params.member.member_2.member.member;
                if (_e316 == 0u) {
                    phi_490_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_490_ = array<u32, 2>(1u, 1u);
                }
                let _e319 = phi_490_;
                let _e325 = params.member.member.member[_e319[1]];
                let _e326 = (5u * _e309);
                if (_e325 > 0u) {
                    if (_e326 < 32u) {
                        phi_513_ = (((_e325 - 1u) >> bitcast<u32>((_e326 & 31u))) + 1u);
                        phi_514_ = false;
                    } else {
                        phi_513_ = u32();
                        phi_514_ = true;
                    }
                    let _e335 = phi_513_;
                    let _e337 = phi_514_;
                    phi_515_ = _e335;
                    phi_516_ = _e337;
                } else {
                    phi_515_ = u32();
                    phi_516_ = true;
                }
                let _e339 = phi_515_;
                let _e341 = phi_516_;
                if _e341 {
                    phi_522_ = select(0u, 1u, (_e325 > 0u));
                } else {
                    phi_522_ = _e339;
                }
                let _e345 = phi_522_;
                let _e346 = (_e303[1] * 32u);
                if (_e346 < _e345) {
                    phi_528_ = _e345;
                } else {
                    phi_528_ = _e346;
                }
                let _e349 = phi_528_;
                let _e350 = (_e349 - _e346);
                if (_e350 >= 32u) {
                    phi_537_ = 4294967295u;
                } else {
                    phi_537_ = ((1u << bitcast<u32>((_e350 & 31u))) - 1u);
                }
                let _e357 = phi_537_;
                let _e362 = params.member.member_2.member_1[_e309][1u];
                let _e363 = (_e362 + _e312);
                if _e301 {
                    if (((_e357 >> bitcast<u32>((_e299 & 31u))) & 1u) == 1u) {
                        let _e371 = boxes.member[(_e363 + _e299)];
                        let _e388 = params.member.member_2.member_1[_e307][0u];
                        let _e391 = boxes.member[(_e388 + _e308)];
                        if ((((((_e371.member.x <= _e391.member_1.y) && (_e391.member.x <= _e371.member_1.y)) && (_e371.member.y <= _e391.member_2.x)) && (_e391.member.y <= _e371.member_2.x)) && (_e371.member_1.x <= _e391.member_2.y)) && (_e391.member_1.x <= _e371.member_2.y)) {
                            let _e420 = atomicOr((&shared_[(18u + _e298)]), (1u << bitcast<u32>((_e299 & 31u))));
                        }
                    }
                    let _e424 = params.member.member.member[_e319[0]];
                    let _e425 = (5u * _e309);
                    if (_e424 > 0u) {
                        if (_e425 < 32u) {
                            phi_652_ = (((_e424 - 1u) >> bitcast<u32>((_e425 & 31u))) + 1u);
                            phi_653_ = false;
                        } else {
                            phi_652_ = u32();
                            phi_653_ = true;
                        }
                        let _e434 = phi_652_;
                        let _e436 = phi_653_;
                        phi_654_ = _e434;
                        phi_655_ = _e436;
                    } else {
                        phi_654_ = u32();
                        phi_655_ = true;
                    }
                    let _e438 = phi_654_;
                    let _e440 = phi_655_;
                    if _e440 {
                        phi_661_ = select(0u, 1u, (_e424 > 0u));
                    } else {
                        phi_661_ = _e438;
                    }
                    let _e444 = phi_661_;
                    if (_e311 < _e444) {
                        let _e450 = params.member.member_2.member_1[_e309][0u];
                        let _e453 = boxes.member[(_e450 + _e311)];
                        phi_701_ = type_20(array<f32, 3>(_e453.member.x, _e453.member.y, _e453.member_1.x), array<f32, 3>(_e453.member_1.y, _e453.member_2.x, _e453.member_2.y));
                        phi_702_ = true;
                    } else {
                        phi_701_ = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_702_ = false;
                    }
                    let _e470 = phi_701_;
                    let _e472 = phi_702_;
                    phi_703_ = _e470;
                    phi_704_ = _e472;
                } else {
                    phi_703_ = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                    phi_704_ = false;
                }
                let _e474 = phi_703_;
                let _e476 = phi_704_;
                workgroupBarrier();
                if _e476 {
                    let _e480 = params.member.member_2.member.member;
                    if (_e480 == 1u) {
                        phi_716_ = (_e308 == _e303[1]);
                    } else {
                        phi_716_ = false;
                    }
                    let _e484 = phi_716_;
                    if _e484 {
                        phi_722_ = (4294967295u << bitcast<u32>((_e299 & 31u)));
                    } else {
                        phi_722_ = 4294967295u;
                    }
                    let _e489 = phi_722_;
                    let _e494 = params.member.member_2.member_1[_e307][1u];
                    let _e497 = boxes.member[(_e494 + _e303[1])];
                    if ((((((_e474.member[0] <= _e497.member_1.y) && (_e497.member.x <= _e474.member_1[0])) && (_e474.member[1] <= _e497.member_2.x)) && (_e497.member.y <= _e474.member_1[1])) && (_e474.member[2] <= _e497.member_2.y)) && (_e497.member_1.x <= _e474.member_1[2])) {
                        let _e535 = atomicLoad((&shared_[(18u + _e298)]));
                        phi_781_ = type_9(0u, 32u);
                        phi_784_ = 0u;
                        phi_786_ = (_e535 & _e489);
                        loop {
                            let _e538 = phi_781_;
                            let _e540 = phi_784_;
                            let _e542 = phi_786_;
                            local = _e540;
                            if (_e538.member < _e538.member_1) {
                                phi_782_ = type_9((_e538.member + 1u), _e538.member_1);
                                phi_809_ = type_9(1u, _e538.member);
                            } else {
                                phi_782_ = _e538;
                                phi_809_ = type_9(0u, type_9().member_1);
                            }
                            let _e554 = phi_782_;
                            let _e556 = phi_809_;
                            if (bitcast<i32>(_e556.member) != 0i) {
                                if (_e542 == 0u) {
                                    phi_866_ = u32();
                                    phi_867_ = u32();
                                    phi_868_ = false;
                                } else {
                                    let _e563 = select(firstTrailingBit(_e542), 32u, (_e542 == 0u));
                                    let _e568 = boxes.member[(_e363 + _e563)];
                                    if ((((((_e474.member[0] <= _e568.member_1.y) && (_e568.member.x <= _e474.member_1[0])) && (_e474.member[1] <= _e568.member_2.x)) && (_e568.member.y <= _e474.member_1[1])) && (_e474.member[2] <= _e568.member_2.y)) && (_e568.member_1.x <= _e474.member_1[2])) {
                                        phi_865_ = (_e540 | (1u << bitcast<u32>((_e563 & 31u))));
                                    } else {
                                        phi_865_ = _e540;
                                    }
                                    let _e609 = phi_865_;
                                    phi_866_ = _e609;
                                    phi_867_ = (_e542 & (_e542 - 1u));
                                    phi_868_ = true;
                                }
                                let _e611 = phi_866_;
                                let _e613 = phi_867_;
                                let _e615 = phi_868_;
                                phi_785_ = _e611;
                                phi_787_ = _e613;
                                phi_869_ = _e615;
                            } else {
                                phi_785_ = u32();
                                phi_787_ = u32();
                                phi_869_ = false;
                            }
                            let _e617 = phi_785_;
                            let _e619 = phi_787_;
                            let _e621 = phi_869_;
                            continue;
                            continuing {
                                phi_781_ = _e554;
                                phi_784_ = _e617;
                                phi_786_ = _e619;
                                break if !(_e621);
                            }
                        }
                        let _e1141 = local;
                        phi_870_ = _e1141;
                    } else {
                        phi_870_ = 0u;
                    }
                    let _e624 = phi_870_;
                    let _e628 = params.member.member_2.member.member_4;
                    if (_e628 > 0u) {
                        phi_881_ = ((_e357 & _e489) & ~(_e624));
                    } else {
                        phi_881_ = 0u;
                    }
                    let _e634 = phi_881_;
                    phi_882_ = _e624;
                    phi_883_ = _e634;
                } else {
                    phi_882_ = 0u;
                    phi_883_ = 0u;
                }
                let _e636 = phi_882_;
                let _e638 = phi_883_;
                let _e640 = countOneBits(_e638);
                let _e641 = countOneBits(_e636);
                if (_e641 > 0u) {
                    if (_e309 > 1u) {
                        phi_896_ = 1u;
                    } else {
                        phi_896_ = 2u;
                    }
                    let _e645 = phi_896_;
                    if (_e645 == 1u) {
                        let _e652 = atomicAdd((&shared_[6u]), _e641);
                        phi_908_ = _e640;
                        phi_909_ = array<u32, 2>(_e652, 0u);
                    } else {
                        let _e648 = atomicAdd((&shared_[7u]), _e641);
                        phi_908_ = (_e640 + _e641);
                        phi_909_ = array<u32, 2>(_e648, 0u);
                    }
                    let _e655 = phi_908_;
                    let _e657 = phi_909_;
                    phi_910_ = _e655;
                    phi_911_ = _e657;
                } else {
                    phi_910_ = _e640;
                    phi_911_ = array<u32, 2>(0u, 0u);
                }
                let _e659 = phi_910_;
                let _e661 = phi_911_;
                if (_e75.member_4 > 0u) {
                    if (_e659 > 0u) {
                        let _e665 = atomicAdd((&shared_[8u]), _e659);
                        phi_923_ = array<u32, 2>(_e661[0], _e665);
                    } else {
                        phi_923_ = _e661;
                    }
                    let _e669 = phi_923_;
                    phi_924_ = _e669;
                } else {
                    phi_924_ = _e661;
                }
                let _e671 = phi_924_;
                workgroupBarrier();
                if (_e61 == 0u) {
                    let _e674 = atomicLoad((&shared_[6u]));
                    let _e676 = atomicLoad((&shared_[7u]));
                    let _e678 = atomicLoad((&shared_[8u]));
                    let _e680 = atomicLoad((&shared_[1u]));
                    let _e682 = atomicLoad((&shared_[2u]));
                    let _e684 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e684 + 1u));
                    let _e688 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e688 + _e680) + _e682));
                    let _e693 = atomicLoad((&shared_[0u]));
                    let _e694 = (_e693 - _e680);
                    let _e696 = (_e75.member_10 - _e694);
                    if (_e696 < _e674) {
                        phi_957_ = _e696;
                    } else {
                        phi_957_ = _e674;
                    }
                    let _e699 = phi_957_;
                    atomicStore((&shared_[9u]), _e694);
                    atomicStore((&shared_[10u]), _e699);
                    atomicStore((&shared_[0u]), (_e694 + _e699));
                    if (_e674 > _e699) {
                        let _e705 = (_e674 - _e699);
                        if (_e75.member_12 == 0u) {
                        } else {
                            let _e709 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e712 = atomicAdd((&control.member[(_e78 + 1u)]), _e705);
                        let _e715 = atomicMax((&nodes.member[0u]), (_e712 + _e705));
                        if ((_e712 + _e705) < _e712) {
                            let _e719 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e712);
                    }
                    if (_e676 > 0u) {
                        let _e723 = atomicAdd((&pairs.member[0u]), _e676);
                        if ((_e723 + _e676) < _e723) {
                            let _e727 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e723);
                    }
                    if (_e678 > 0u) {
                        let _e731 = atomicAdd((&control.member[1537u]), _e678);
                        if ((_e731 + _e678) < _e731) {
                            let _e735 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e731);
                    }
                }
                workgroupBarrier();
                if (_e309 > 1u) {
                    phi_1032_ = 1u;
                } else {
                    phi_1032_ = 2u;
                }
                let _e742 = phi_1032_;
                phi_1035_ = type_9(0u, 32u);
                phi_1038_ = _e671[1];
                phi_1040_ = _e671[0];
                phi_1042_ = (_e636 | _e638);
                loop {
                    let _e744 = phi_1035_;
                    let _e746 = phi_1038_;
                    let _e748 = phi_1040_;
                    let _e750 = phi_1042_;
                    if (_e744.member < _e744.member_1) {
                        phi_1036_ = type_9((_e744.member + 1u), _e744.member_1);
                        phi_1065_ = type_9(1u, _e744.member);
                    } else {
                        phi_1036_ = _e744;
                        phi_1065_ = type_9(0u, type_9().member_1);
                    }
                    let _e762 = phi_1036_;
                    let _e764 = phi_1065_;
                    if (bitcast<i32>(_e764.member) != 0i) {
                        if (_e750 == 0u) {
                            phi_1182_ = u32();
                            phi_1183_ = u32();
                            phi_1184_ = u32();
                            phi_1185_ = false;
                        } else {
                            let _e771 = select(firstTrailingBit(_e750), 32u, (_e750 == 0u));
                            let _e774 = (_e312 + _e771);
                            let _e777 = ((_e309 << bitcast<u32>(27u)) | _e311);
                            if (((_e638 >> bitcast<u32>((_e771 & 31u))) & 1u) == 1u) {
                                phi_1091_ = 3u;
                            } else {
                                phi_1091_ = _e742;
                            }
                            let _e784 = phi_1091_;
                            if (_e784 == 1u) {
                                let _e814 = atomicLoad((&shared_[10u]));
                                if (_e748 < _e814) {
                                    let _e830 = atomicLoad((&shared_[9u]));
                                    let _e832 = (2u * (_e830 + _e748));
                                    stack[_e832] = _e777;
                                    stack[(_e832 + 1u)] = _e774;
                                } else {
                                    let _e817 = atomicLoad((&shared_[11u]));
                                    let _e819 = ((_e817 + _e748) - _e814);
                                    if (_e819 < _e75.member_3) {
                                        let _e822 = (_e89 + _e819);
                                        if (_e822 < 4294967295u) {
                                            let _e824 = (2u * _e822);
                                            atomicStore((&nodes.member[(4u + _e824)]), _e777);
                                            atomicStore((&nodes.member[(_e824 + 5u)]), _e774);
                                        }
                                    }
                                }
                            } else {
                                if (_e784 == 0u) {
                                } else {
                                    if (_e784 == 2u) {
                                        let _e790 = atomicLoad((&shared_[12u]));
                                        let _e791 = (_e790 + _e748);
                                        if (_e791 < _e91) {
                                            let _e793 = (2u * _e791);
                                            atomicStore((&pairs.member[(4u + _e793)]), (_e777 & 134217727u));
                                            atomicStore((&pairs.member[(_e793 + 5u)]), _e774);
                                        }
                                    }
                                    if (_e75.member_4 > 0u) {
                                        let _e801 = atomicLoad((&shared_[13u]));
                                        let _e802 = (_e801 + _e746);
                                        if (_e802 < _e75.member_4) {
                                            let _e809 = (2u * ((_e75.member_5 * _e75.member_4) + _e802));
                                            front.member[_e809] = _e777;
                                            front.member[(_e809 + 1u)] = _e774;
                                        }
                                    }
                                }
                            }
                            phi_1182_ = (_e746 + select(0u, 1u, (_e784 != 1u)));
                            phi_1183_ = (_e748 + select(0u, 1u, (_e784 != 3u)));
                            phi_1184_ = (_e750 & (_e750 - 1u));
                            phi_1185_ = true;
                        }
                        let _e843 = phi_1182_;
                        let _e845 = phi_1183_;
                        let _e847 = phi_1184_;
                        let _e849 = phi_1185_;
                        phi_1039_ = _e843;
                        phi_1041_ = _e845;
                        phi_1043_ = _e847;
                        phi_1186_ = _e849;
                    } else {
                        phi_1039_ = u32();
                        phi_1041_ = u32();
                        phi_1043_ = u32();
                        phi_1186_ = false;
                    }
                    let _e851 = phi_1039_;
                    let _e853 = phi_1041_;
                    let _e855 = phi_1043_;
                    let _e857 = phi_1186_;
                    continue;
                    continuing {
                        phi_1035_ = _e762;
                        phi_1038_ = _e851;
                        phi_1040_ = _e853;
                        phi_1042_ = _e855;
                        break if !(_e857);
                    }
                }
                phi_1187_ = true;
            }
            let _e860 = phi_1187_;
            phi_1188_ = _e860;
        } else {
            phi_1188_ = false;
        }
        let _e862 = phi_1188_;
        continue;
        continuing {
            phi_168_ = _e112;
            break if !(_e862);
        }
    }
    if (_e61 == 0u) {
        if (_e75.member_6 == 0u) {
            if (_e72 < _e86) {
                phi_1207_ = ((((_e86 - 1u) - _e72) >> bitcast<u32>((_e75.member_7 & 31u))) + 1u);
            } else {
                phi_1207_ = 0u;
            }
            let _e875 = phi_1207_;
            let _e877 = atomicLoad((&shared_[5u]));
            phi_1211_ = (_e875 - _e877);
        } else {
            phi_1211_ = 0u;
        }
        let _e880 = phi_1211_;
        atomicStore((&shared_[14u]), _e880);
        let _e883 = atomicLoad((&shared_[0u]));
        let _e884 = (_e883 + _e880);
        if (_e884 > 0u) {
            if (_e75.member_12 == 0u) {
            } else {
                let _e889 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e892 = atomicAdd((&control.member[(_e78 + 1u)]), _e884);
            let _e895 = atomicMax((&nodes.member[0u]), (_e892 + _e884));
            if ((_e892 + _e884) < _e892) {
                let _e899 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e892);
        }
        let _e904 = atomicLoad((&shared_[15u]));
        let _e906 = atomicAdd((&control.member[(1540u + (2u * _e72))]), _e904);
        let _e910 = atomicLoad((&shared_[16u]));
        let _e912 = atomicAdd((&control.member[((2u * _e72) + 1541u)]), _e910);
    }
    workgroupBarrier();
    let _e914 = atomicLoad((&shared_[0u]));
    let _e916 = atomicLoad((&shared_[17u]));
    let _e918 = atomicLoad((&shared_[14u]));
    phi_1268_ = type_9(0u, 8u);
    loop {
        let _e920 = phi_1268_;
        if (_e920.member < _e920.member_1) {
            phi_1269_ = type_9((_e920.member + 1u), _e920.member_1);
            phi_1292_ = type_9(1u, _e920.member);
        } else {
            phi_1269_ = _e920;
            phi_1292_ = type_9(0u, type_9().member_1);
        }
        let _e932 = phi_1269_;
        let _e934 = phi_1292_;
        let _e938 = (bitcast<i32>(_e934.member) != 0i);
        if _e938 {
            let _e940 = ((_e934.member_1 * 128u) + _e61);
            if (_e940 < _e914) {
                let _e944 = stack[(2u * _e940)];
                let _e948 = stack[((2u * _e940) + 1u)];
                let _e949 = (_e916 + _e940);
                if (_e949 < _e75.member_3) {
                    let _e952 = (_e89 + _e949);
                    if (_e952 < 4294967295u) {
                        let _e954 = (2u * _e952);
                        atomicStore((&nodes.member[(4u + _e954)]), _e944);
                        atomicStore((&nodes.member[(_e954 + 5u)]), _e948);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1268_ = _e932;
            break if !(_e938);
        }
    }
    let _e961 = atomicLoad((&shared_[5u]));
    let _e962 = (_e918 / 128u);
    if ((_e918 % 128u) > 0u) {
        phi_1348_ = (_e962 + 1u);
    } else {
        phi_1348_ = _e962;
    }
    let _e967 = phi_1348_;
    phi_1351_ = type_9(0u, _e967);
    loop {
        let _e970 = phi_1351_;
        if (_e970.member < _e970.member_1) {
            phi_1352_ = type_9((_e970.member + 1u), _e970.member_1);
            phi_1375_ = type_9(1u, _e970.member);
        } else {
            phi_1352_ = _e970;
            phi_1375_ = type_9(0u, type_9().member_1);
        }
        let _e982 = phi_1352_;
        let _e984 = phi_1375_;
        let _e988 = (bitcast<i32>(_e984.member) != 0i);
        if _e988 {
            let _e990 = ((_e984.member_1 * 128u) + _e61);
            if (_e990 < _e918) {
                let _e998 = (2u * ((_e87 + _e72) + ((_e961 + _e990) << bitcast<u32>((_e75.member_7 & 31u)))));
                let _e1001 = atomicLoad((&nodes.member[(4u + _e998)]));
                let _e1004 = atomicLoad((&nodes.member[(_e998 + 5u)]));
                let _e1006 = ((_e916 + _e914) + _e990);
                if (_e1006 < _e75.member_3) {
                    let _e1009 = (_e89 + _e1006);
                    if (_e1009 < 4294967295u) {
                        let _e1011 = (2u * _e1009);
                        atomicStore((&nodes.member[(4u + _e1011)]), _e1001);
                        atomicStore((&nodes.member[(_e1011 + 5u)]), _e1004);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1351_ = _e982;
            break if !(_e988);
        }
    }
    if (_e75.member_6 == 1u) {
        if (_e961 == 0u) {
            phi_1447_ = type_9(0u, _e86);
            loop {
                let _e1022 = phi_1447_;
                if (_e1022.member < _e1022.member_1) {
                    phi_1448_ = type_9((_e1022.member + 1u), _e1022.member_1);
                    phi_1471_ = type_9(1u, _e1022.member);
                } else {
                    phi_1448_ = _e1022;
                    phi_1471_ = type_9(0u, type_9().member_1);
                }
                let _e1034 = phi_1448_;
                let _e1036 = phi_1471_;
                if (bitcast<i32>(_e1036.member) != 0i) {
                    let _e1042 = atomicAdd((&control.member[(512u + _e78)]), 1u);
                    if (_e1042 >= _e86) {
                        phi_1551_ = false;
                    } else {
                        let _e1045 = (2u * (_e87 + _e1042));
                        let _e1048 = atomicLoad((&nodes.member[(4u + _e1045)]));
                        let _e1051 = atomicLoad((&nodes.member[(_e1045 + 5u)]));
                        if (_e75.member_12 == 0u) {
                        } else {
                            let _e1055 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1058 = atomicAdd((&control.member[(_e78 + 1u)]), 1u);
                        let _e1061 = atomicMax((&nodes.member[0u]), (_e1058 + 1u));
                        if ((_e1058 + 1u) < _e1058) {
                            let _e1065 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1058 < _e75.member_3) {
                            let _e1068 = (_e89 + _e1058);
                            if (_e1068 < 4294967295u) {
                                let _e1070 = (2u * _e1068);
                                atomicStore((&nodes.member[(4u + _e1070)]), _e1048);
                                atomicStore((&nodes.member[(_e1070 + 5u)]), _e1051);
                            }
                        }
                        phi_1551_ = true;
                    }
                    let _e1076 = phi_1551_;
                    phi_1552_ = _e1076;
                } else {
                    phi_1552_ = false;
                }
                let _e1078 = phi_1552_;
                continue;
                continuing {
                    phi_1447_ = _e1034;
                    break if !(_e1078);
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn block_workers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
