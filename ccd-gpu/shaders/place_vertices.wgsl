struct type_8 {
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

struct type_9 {
    member: type_8,
}

struct type_11 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_13 {
    member: array<type_11>,
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
var<storage> params: type_9;
@group(0) @binding(1) 
var<storage> positions: type_23;
@group(0) @binding(2) 
var<storage, read_write> paths: type_25;
@group(0) @binding(3) 
var<storage, read_write> keys: type_28;
@group(0) @binding(4) 
var<storage, read_write> boxes: type_13;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_11;
    var local_1: type_11;
    var local_2: array<f64, 3>;
    var local_3: array<f64, 3>;
    var local_4: type_20;
    var local_5: type_21;
    var local_6: type_21;
    var phi_167_: f64;
    var phi_174_: f64;
    var phi_181_: f64;
    var phi_189_: f64;
    var phi_196_: f64;
    var phi_203_: f64;
    var phi_233_: type_16;
    var phi_234_: type_16;
    var phi_257_: type_16;
    var phi_284_: bool;
    var phi_301_: f64;
    var phi_302_: f64;
    var phi_303_: f64;
    var phi_330_: bool;
    var phi_347_: f64;
    var phi_348_: f64;
    var phi_349_: f64;
    var phi_403_: type_16;
    var phi_404_: type_16;
    var phi_427_: type_16;
    var phi_475_: bool;
    var phi_492_: f32;
    var phi_493_: f32;
    var phi_494_: f32;
    var phi_496_: f32;
    var phi_513_: bool;
    var phi_530_: f32;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_533_: f32;
    var phi_552_: bool;
    var phi_553_: bool;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_562_: f32;
    var phi_594_: bool;
    var phi_611_: f32;
    var phi_612_: f32;
    var phi_613_: f32;
    var phi_615_: f32;
    var phi_632_: bool;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_681_: f32;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_743_: array<u32, 2>;
    var phi_744_: bool;
    var phi_745_: array<u32, 2>;
    var phi_746_: bool;
    var phi_752_: array<u32, 2>;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_779_: array<u32, 2>;
    var phi_780_: bool;
    var phi_781_: array<u32, 2>;
    var phi_782_: bool;
    var phi_788_: array<u32, 2>;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_815_: array<u32, 2>;
    var phi_816_: bool;
    var phi_817_: array<u32, 2>;
    var phi_818_: bool;
    var phi_824_: array<u32, 2>;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_851_: array<u32, 2>;
    var phi_852_: bool;
    var phi_853_: array<u32, 2>;
    var phi_854_: bool;
    var phi_860_: array<u32, 2>;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_887_: array<u32, 2>;
    var phi_888_: bool;
    var phi_889_: array<u32, 2>;
    var phi_890_: bool;
    var phi_896_: array<u32, 2>;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_923_: array<u32, 2>;
    var phi_924_: bool;
    var phi_925_: array<u32, 2>;
    var phi_926_: bool;
    var phi_932_: array<u32, 2>;
    var phi_938_: type_16;
    var phi_939_: type_16;
    var phi_962_: type_16;
    var phi_994_: bool;
    var phi_1011_: f32;
    var phi_1012_: f32;
    var phi_1013_: f32;
    var phi_1015_: f32;
    var phi_1021_: f32;
    var phi_1026_: f32;
    var phi_1057_: bool;
    var phi_1074_: f32;
    var phi_1075_: f32;
    var phi_1076_: f32;
    var phi_1077_: f32;
    var phi_1083_: f32;
    var phi_1088_: f32;
    var phi_1121_: type_16;
    var phi_1122_: type_16;
    var phi_1145_: type_16;
    var phi_1166_: bool;
    var phi_1189_: bool;
    var phi_1193_: f32;
    var phi_1202_: f32;
    var phi_1223_: bool;
    var phi_1246_: bool;
    var phi_1250_: f32;
    var phi_1259_: f32;
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
    let _e55 = params.member.member[0u];
    if (_e52 < _e55) {
        let _e58 = positions.member[_e52];
        let _e61 = params.member.member[0u];
        let _e64 = positions.member[(_e61 + _e52)];
        if (_e58[0] < _e64[0]) {
            phi_167_ = _e58[0];
        } else {
            phi_167_ = _e64[0];
        }
        let _e69 = phi_167_;
        if (_e58[1] < _e64[1]) {
            phi_174_ = _e58[1];
        } else {
            phi_174_ = _e64[1];
        }
        let _e74 = phi_174_;
        if (_e58[2] < _e64[2]) {
            phi_181_ = _e58[2];
        } else {
            phi_181_ = _e64[2];
        }
        let _e79 = phi_181_;
        if (_e58[0] > _e64[0]) {
            phi_189_ = _e58[0];
        } else {
            phi_189_ = _e64[0];
        }
        let _e84 = phi_189_;
        if (_e58[1] > _e64[1]) {
            phi_196_ = _e58[1];
        } else {
            phi_196_ = _e64[1];
        }
        let _e89 = phi_196_;
        if (_e58[2] > _e64[2]) {
            phi_203_ = _e58[2];
        } else {
            phi_203_ = _e64[2];
        }
        let _e94 = phi_203_;
        let _e96 = params.member.member_19;
        let _e103 = bitcast<f64>(((u64(_e96[1]) * 4294967296lu) + u64(_e96[0])));
        if (_e103 > f64(0f)) {
            local_5 = type_21(array<f64, 3>(_e69, _e74, _e79), array<f64, 3>(_e84, _e89, _e94));
            phi_233_ = type_16(0u, 3u);
            loop {
                let _e113 = phi_233_;
                if (_e113.member < _e113.member_1) {
                    phi_234_ = type_16((_e113.member + 1u), _e113.member_1);
                    phi_257_ = type_16(1u, _e113.member);
                } else {
                    phi_234_ = _e113;
                    phi_257_ = type_16(0u, type_16().member_1);
                }
                let _e125 = phi_234_;
                let _e127 = phi_257_;
                let _e131 = (bitcast<i32>(_e127.member) != 0i);
                if _e131 {
                    let _e134 = local_5.member[_e127.member_1];
                    let _e136 = -((_e134 - _e103));
                    let _e137 = bitcast<u64>(_e136);
                    if ((_e137 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_284_ = (_e136 < 0.0lf);
                    } else {
                        phi_284_ = true;
                    }
                    let _e142 = phi_284_;
                    if _e142 {
                        if (_e136 > 0.0lf) {
                            phi_302_ = bitcast<f64>((_e137 + 1lu));
                        } else {
                            if (_e136 < 0.0lf) {
                                phi_301_ = bitcast<f64>((_e137 - 1lu));
                            } else {
                                phi_301_ = 5e-324lf;
                            }
                            let _e148 = phi_301_;
                            phi_302_ = _e148;
                        }
                        let _e152 = phi_302_;
                        phi_303_ = _e152;
                    } else {
                        phi_303_ = _e136;
                    }
                    let _e154 = phi_303_;
                    local_5.member[_e127.member_1] = -(_e154);
                    let _e160 = local_5.member_1[_e127.member_1];
                    let _e161 = (_e160 + _e103);
                    let _e162 = bitcast<u64>(_e161);
                    if ((_e162 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_330_ = (_e161 < 0.0lf);
                    } else {
                        phi_330_ = true;
                    }
                    let _e167 = phi_330_;
                    if _e167 {
                        if (_e161 > 0.0lf) {
                            phi_348_ = bitcast<f64>((_e162 + 1lu));
                        } else {
                            if (_e161 < 0.0lf) {
                                phi_347_ = bitcast<f64>((_e162 - 1lu));
                            } else {
                                phi_347_ = 5e-324lf;
                            }
                            let _e173 = phi_347_;
                            phi_348_ = _e173;
                        }
                        let _e177 = phi_348_;
                        phi_349_ = _e177;
                    } else {
                        phi_349_ = _e161;
                    }
                    let _e179 = phi_349_;
                    local_5.member_1[_e127.member_1] = _e179;
                }
                continue;
                continuing {
                    phi_233_ = _e125;
                    break if !(_e131);
                }
            }
        } else {
            local_5 = type_21(array<f64, 3>(_e69, _e74, _e79), array<f64, 3>(_e84, _e89, _e94));
        }
        let _e183 = local_5;
        local_6 = _e183;
        local_2 = array<f64, 3>(_e58[0], _e58[1], _e58[2]);
        local_3 = array<f64, 3>(_e64[0], _e64[1], _e64[2]);
        local_4.member = array<f32, 4>(0f, 0f, 0f, 0f);
        local_4.member_1 = array<f32, 4>(0f, 0f, 0f, 0f);
        phi_403_ = type_16(0u, 3u);
        loop {
            let _e195 = phi_403_;
            if (_e195.member < _e195.member_1) {
                phi_404_ = type_16((_e195.member + 1u), _e195.member_1);
                phi_427_ = type_16(1u, _e195.member);
            } else {
                phi_404_ = _e195;
                phi_427_ = type_16(0u, type_16().member_1);
            }
            let _e207 = phi_404_;
            let _e209 = phi_427_;
            let _e213 = (bitcast<i32>(_e209.member) != 0i);
            if _e213 {
                let _e216 = params.member.member_18[_e209.member_1];
                let _e223 = bitcast<f64>(((u64(_e216[1]) * 4294967296lu) + u64(_e216[0])));
                let _e225 = local_2[_e209.member_1];
                let _e226 = (_e225 - _e223);
                let _e227 = f32(_e226);
                if (f64(_e227) > _e226) {
                    let _e230 = -(_e227);
                    let _e231 = bitcast<u32>(_e230);
                    if ((_e231 & 2139095040u) == 2139095040u) {
                        phi_475_ = (_e230 < 0f);
                    } else {
                        phi_475_ = true;
                    }
                    let _e236 = phi_475_;
                    if _e236 {
                        if (_e230 > 0f) {
                            phi_493_ = bitcast<f32>((_e231 + 1u));
                        } else {
                            if (_e230 < 0f) {
                                phi_492_ = bitcast<f32>((_e231 - 1u));
                            } else {
                                phi_492_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e242 = phi_492_;
                            phi_493_ = _e242;
                        }
                        let _e246 = phi_493_;
                        phi_494_ = _e246;
                    } else {
                        phi_494_ = _e230;
                    }
                    let _e248 = phi_494_;
                    phi_496_ = -(_e248);
                } else {
                    phi_496_ = _e227;
                }
                let _e251 = phi_496_;
                let _e252 = f32(_e226);
                if (f64(_e252) < _e226) {
                    let _e255 = bitcast<u32>(_e252);
                    if ((_e255 & 2139095040u) == 2139095040u) {
                        phi_513_ = (_e252 < 0f);
                    } else {
                        phi_513_ = true;
                    }
                    let _e260 = phi_513_;
                    if _e260 {
                        if (_e252 > 0f) {
                            phi_531_ = bitcast<f32>((_e255 + 1u));
                        } else {
                            if (_e252 < 0f) {
                                phi_530_ = bitcast<f32>((_e255 - 1u));
                            } else {
                                phi_530_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e266 = phi_530_;
                            phi_531_ = _e266;
                        }
                        let _e270 = phi_531_;
                        phi_532_ = _e270;
                    } else {
                        phi_532_ = _e252;
                    }
                    let _e272 = phi_532_;
                    phi_533_ = _e272;
                } else {
                    phi_533_ = _e252;
                }
                let _e274 = phi_533_;
                let _e276 = (_e226 - f64(_e251));
                let _e278 = (f64(_e274) - _e226);
                if (_e276 < _e278) {
                    phi_558_ = true;
                } else {
                    if (_e276 == _e278) {
                        if ((bitcast<u32>(_e251) & 1u) == 0u) {
                            phi_552_ = false;
                        } else {
                            phi_552_ = true;
                        }
                        let _e285 = phi_552_;
                        phi_553_ = _e285;
                    } else {
                        phi_553_ = true;
                    }
                    let _e287 = phi_553_;
                    if _e287 {
                        phi_557_ = false;
                    } else {
                        phi_557_ = true;
                    }
                    let _e289 = phi_557_;
                    phi_558_ = _e289;
                }
                let _e291 = phi_558_;
                if _e291 {
                    phi_562_ = _e251;
                } else {
                    phi_562_ = _e274;
                }
                let _e293 = phi_562_;
                local_4.member[_e209.member_1] = _e293;
                let _e297 = local_3[_e209.member_1];
                let _e298 = (_e297 - _e223);
                let _e299 = f32(_e298);
                if (f64(_e299) > _e298) {
                    let _e302 = -(_e299);
                    let _e303 = bitcast<u32>(_e302);
                    if ((_e303 & 2139095040u) == 2139095040u) {
                        phi_594_ = (_e302 < 0f);
                    } else {
                        phi_594_ = true;
                    }
                    let _e308 = phi_594_;
                    if _e308 {
                        if (_e302 > 0f) {
                            phi_612_ = bitcast<f32>((_e303 + 1u));
                        } else {
                            if (_e302 < 0f) {
                                phi_611_ = bitcast<f32>((_e303 - 1u));
                            } else {
                                phi_611_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e314 = phi_611_;
                            phi_612_ = _e314;
                        }
                        let _e318 = phi_612_;
                        phi_613_ = _e318;
                    } else {
                        phi_613_ = _e302;
                    }
                    let _e320 = phi_613_;
                    phi_615_ = -(_e320);
                } else {
                    phi_615_ = _e299;
                }
                let _e323 = phi_615_;
                let _e324 = f32(_e298);
                if (f64(_e324) < _e298) {
                    let _e327 = bitcast<u32>(_e324);
                    if ((_e327 & 2139095040u) == 2139095040u) {
                        phi_632_ = (_e324 < 0f);
                    } else {
                        phi_632_ = true;
                    }
                    let _e332 = phi_632_;
                    if _e332 {
                        if (_e324 > 0f) {
                            phi_650_ = bitcast<f32>((_e327 + 1u));
                        } else {
                            if (_e324 < 0f) {
                                phi_649_ = bitcast<f32>((_e327 - 1u));
                            } else {
                                phi_649_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e338 = phi_649_;
                            phi_650_ = _e338;
                        }
                        let _e342 = phi_650_;
                        phi_651_ = _e342;
                    } else {
                        phi_651_ = _e324;
                    }
                    let _e344 = phi_651_;
                    phi_652_ = _e344;
                } else {
                    phi_652_ = _e324;
                }
                let _e346 = phi_652_;
                let _e348 = (_e298 - f64(_e323));
                let _e350 = (f64(_e346) - _e298);
                if (_e348 < _e350) {
                    phi_677_ = true;
                } else {
                    if (_e348 == _e350) {
                        if ((bitcast<u32>(_e323) & 1u) == 0u) {
                            phi_671_ = false;
                        } else {
                            phi_671_ = true;
                        }
                        let _e357 = phi_671_;
                        phi_672_ = _e357;
                    } else {
                        phi_672_ = true;
                    }
                    let _e359 = phi_672_;
                    if _e359 {
                        phi_676_ = false;
                    } else {
                        phi_676_ = true;
                    }
                    let _e361 = phi_676_;
                    phi_677_ = _e361;
                }
                let _e363 = phi_677_;
                if _e363 {
                    phi_681_ = _e323;
                } else {
                    phi_681_ = _e346;
                }
                let _e365 = phi_681_;
                local_4.member_1[_e209.member_1] = _e365;
            }
            continue;
            continuing {
                phi_403_ = _e207;
                break if !(_e213);
            }
        }
        let _e369 = local_4;
        paths.member[_e52] = type_20(array<f32, 4>(_e369.member[0], _e369.member[1], _e369.member[2], _e369.member[3]), array<f32, 4>(_e369.member_1[0], _e369.member_1[1], _e369.member_1[2], _e369.member_1[3]));
        let _e385 = local_6.member;
        let _e390 = local_6.member_1;
        let _e394 = bitcast<u64>(_e385[0]);
        let _e395 = u32(_e394);
        let _e397 = u32((_e394 / 4294967296lu));
        if ((_e397 >> bitcast<u32>(31i)) == 0u) {
            phi_745_ = array<u32, 2>();
            phi_746_ = true;
        } else {
            if (_e397 == 2147483648u) {
                if (_e395 == 0u) {
                    phi_735_ = false;
                } else {
                    phi_735_ = true;
                }
                let _e404 = phi_735_;
                phi_736_ = _e404;
            } else {
                phi_736_ = true;
            }
            let _e406 = phi_736_;
            if _e406 {
                phi_743_ = array<u32, 2>(~(_e395), ~(_e397));
                phi_744_ = false;
            } else {
                phi_743_ = array<u32, 2>();
                phi_744_ = true;
            }
            let _e411 = phi_743_;
            let _e413 = phi_744_;
            phi_745_ = _e411;
            phi_746_ = _e413;
        }
        let _e415 = phi_745_;
        let _e417 = phi_746_;
        if _e417 {
            phi_752_ = array<u32, 2>(_e395, (_e397 | 2147483648u));
        } else {
            phi_752_ = _e415;
        }
        let _e421 = phi_752_;
        let _e422 = bitcast<u64>(_e385[1]);
        let _e423 = u32(_e422);
        let _e425 = u32((_e422 / 4294967296lu));
        if ((_e425 >> bitcast<u32>(31i)) == 0u) {
            phi_781_ = array<u32, 2>();
            phi_782_ = true;
        } else {
            if (_e425 == 2147483648u) {
                if (_e423 == 0u) {
                    phi_771_ = false;
                } else {
                    phi_771_ = true;
                }
                let _e432 = phi_771_;
                phi_772_ = _e432;
            } else {
                phi_772_ = true;
            }
            let _e434 = phi_772_;
            if _e434 {
                phi_779_ = array<u32, 2>(~(_e423), ~(_e425));
                phi_780_ = false;
            } else {
                phi_779_ = array<u32, 2>();
                phi_780_ = true;
            }
            let _e439 = phi_779_;
            let _e441 = phi_780_;
            phi_781_ = _e439;
            phi_782_ = _e441;
        }
        let _e443 = phi_781_;
        let _e445 = phi_782_;
        if _e445 {
            phi_788_ = array<u32, 2>(_e423, (_e425 | 2147483648u));
        } else {
            phi_788_ = _e443;
        }
        let _e449 = phi_788_;
        let _e450 = bitcast<u64>(_e385[2]);
        let _e451 = u32(_e450);
        let _e453 = u32((_e450 / 4294967296lu));
        if ((_e453 >> bitcast<u32>(31i)) == 0u) {
            phi_817_ = array<u32, 2>();
            phi_818_ = true;
        } else {
            if (_e453 == 2147483648u) {
                if (_e451 == 0u) {
                    phi_807_ = false;
                } else {
                    phi_807_ = true;
                }
                let _e460 = phi_807_;
                phi_808_ = _e460;
            } else {
                phi_808_ = true;
            }
            let _e462 = phi_808_;
            if _e462 {
                phi_815_ = array<u32, 2>(~(_e451), ~(_e453));
                phi_816_ = false;
            } else {
                phi_815_ = array<u32, 2>();
                phi_816_ = true;
            }
            let _e467 = phi_815_;
            let _e469 = phi_816_;
            phi_817_ = _e467;
            phi_818_ = _e469;
        }
        let _e471 = phi_817_;
        let _e473 = phi_818_;
        if _e473 {
            phi_824_ = array<u32, 2>(_e451, (_e453 | 2147483648u));
        } else {
            phi_824_ = _e471;
        }
        let _e477 = phi_824_;
        let _e478 = bitcast<u64>(_e390[0]);
        let _e479 = u32(_e478);
        let _e481 = u32((_e478 / 4294967296lu));
        if ((_e481 >> bitcast<u32>(31i)) == 0u) {
            phi_853_ = array<u32, 2>();
            phi_854_ = true;
        } else {
            if (_e481 == 2147483648u) {
                if (_e479 == 0u) {
                    phi_843_ = false;
                } else {
                    phi_843_ = true;
                }
                let _e488 = phi_843_;
                phi_844_ = _e488;
            } else {
                phi_844_ = true;
            }
            let _e490 = phi_844_;
            if _e490 {
                phi_851_ = array<u32, 2>(~(_e479), ~(_e481));
                phi_852_ = false;
            } else {
                phi_851_ = array<u32, 2>();
                phi_852_ = true;
            }
            let _e495 = phi_851_;
            let _e497 = phi_852_;
            phi_853_ = _e495;
            phi_854_ = _e497;
        }
        let _e499 = phi_853_;
        let _e501 = phi_854_;
        if _e501 {
            phi_860_ = array<u32, 2>(_e479, (_e481 | 2147483648u));
        } else {
            phi_860_ = _e499;
        }
        let _e505 = phi_860_;
        let _e506 = bitcast<u64>(_e390[1]);
        let _e507 = u32(_e506);
        let _e509 = u32((_e506 / 4294967296lu));
        if ((_e509 >> bitcast<u32>(31i)) == 0u) {
            phi_889_ = array<u32, 2>();
            phi_890_ = true;
        } else {
            if (_e509 == 2147483648u) {
                if (_e507 == 0u) {
                    phi_879_ = false;
                } else {
                    phi_879_ = true;
                }
                let _e516 = phi_879_;
                phi_880_ = _e516;
            } else {
                phi_880_ = true;
            }
            let _e518 = phi_880_;
            if _e518 {
                phi_887_ = array<u32, 2>(~(_e507), ~(_e509));
                phi_888_ = false;
            } else {
                phi_887_ = array<u32, 2>();
                phi_888_ = true;
            }
            let _e523 = phi_887_;
            let _e525 = phi_888_;
            phi_889_ = _e523;
            phi_890_ = _e525;
        }
        let _e527 = phi_889_;
        let _e529 = phi_890_;
        if _e529 {
            phi_896_ = array<u32, 2>(_e507, (_e509 | 2147483648u));
        } else {
            phi_896_ = _e527;
        }
        let _e533 = phi_896_;
        let _e534 = bitcast<u64>(_e390[2]);
        let _e535 = u32(_e534);
        let _e537 = u32((_e534 / 4294967296lu));
        if ((_e537 >> bitcast<u32>(31i)) == 0u) {
            phi_925_ = array<u32, 2>();
            phi_926_ = true;
        } else {
            if (_e537 == 2147483648u) {
                if (_e535 == 0u) {
                    phi_915_ = false;
                } else {
                    phi_915_ = true;
                }
                let _e544 = phi_915_;
                phi_916_ = _e544;
            } else {
                phi_916_ = true;
            }
            let _e546 = phi_916_;
            if _e546 {
                phi_923_ = array<u32, 2>(~(_e535), ~(_e537));
                phi_924_ = false;
            } else {
                phi_923_ = array<u32, 2>();
                phi_924_ = true;
            }
            let _e551 = phi_923_;
            let _e553 = phi_924_;
            phi_925_ = _e551;
            phi_926_ = _e553;
        }
        let _e555 = phi_925_;
        let _e557 = phi_926_;
        if _e557 {
            phi_932_ = array<u32, 2>(_e535, (_e537 | 2147483648u));
        } else {
            phi_932_ = _e555;
        }
        let _e561 = phi_932_;
        keys.member[_e52] = array<array<u32, 2>, 6>(_e421, _e449, _e477, _e505, _e533, _e561);
        local_1 = type_11(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_938_ = type_16(0u, 3u);
        loop {
            let _e565 = phi_938_;
            if (_e565.member < _e565.member_1) {
                phi_939_ = type_16((_e565.member + 1u), _e565.member_1);
                phi_962_ = type_16(1u, _e565.member);
            } else {
                phi_939_ = _e565;
                phi_962_ = type_16(0u, type_16().member_1);
            }
            let _e577 = phi_939_;
            let _e579 = phi_962_;
            let _e583 = (bitcast<i32>(_e579.member) != 0i);
            if _e583 {
                let _e586 = local_6.member[_e579.member_1];
                let _e587 = f32(_e586);
                if (f64(_e587) > _e586) {
                    let _e590 = -(_e587);
                    let _e591 = bitcast<u32>(_e590);
                    if ((_e591 & 2139095040u) == 2139095040u) {
                        phi_994_ = (_e590 < 0f);
                    } else {
                        phi_994_ = true;
                    }
                    let _e596 = phi_994_;
                    if _e596 {
                        if (_e590 > 0f) {
                            phi_1012_ = bitcast<f32>((_e591 + 1u));
                        } else {
                            if (_e590 < 0f) {
                                phi_1011_ = bitcast<f32>((_e591 - 1u));
                            } else {
                                phi_1011_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e602 = phi_1011_;
                            phi_1012_ = _e602;
                        }
                        let _e606 = phi_1012_;
                        phi_1013_ = _e606;
                    } else {
                        phi_1013_ = _e590;
                    }
                    let _e608 = phi_1013_;
                    phi_1015_ = -(_e608);
                } else {
                    phi_1015_ = _e587;
                }
                let _e611 = phi_1015_;
                let _e612 = -(290000000000000000000000000000000000000f);
                if (_e611 > _e612) {
                    phi_1021_ = _e611;
                } else {
                    phi_1021_ = _e612;
                }
                let _e615 = phi_1021_;
                if (_e615 < 290000000000000000000000000000000000000f) {
                    phi_1026_ = _e615;
                } else {
                    phi_1026_ = 290000000000000000000000000000000000000f;
                }
                let _e618 = phi_1026_;
                local_1.member[_e579.member_1] = _e618;
                let _e623 = local_6.member_1[_e579.member_1];
                let _e624 = f32(_e623);
                if (f64(_e624) < _e623) {
                    let _e627 = bitcast<u32>(_e624);
                    if ((_e627 & 2139095040u) == 2139095040u) {
                        phi_1057_ = (_e624 < 0f);
                    } else {
                        phi_1057_ = true;
                    }
                    let _e632 = phi_1057_;
                    if _e632 {
                        if (_e624 > 0f) {
                            phi_1075_ = bitcast<f32>((_e627 + 1u));
                        } else {
                            if (_e624 < 0f) {
                                phi_1074_ = bitcast<f32>((_e627 - 1u));
                            } else {
                                phi_1074_ = 0.000000000000000000000000000000000000000000001f;
                            }
                            let _e638 = phi_1074_;
                            phi_1075_ = _e638;
                        }
                        let _e642 = phi_1075_;
                        phi_1076_ = _e642;
                    } else {
                        phi_1076_ = _e624;
                    }
                    let _e644 = phi_1076_;
                    phi_1077_ = _e644;
                } else {
                    phi_1077_ = _e624;
                }
                let _e646 = phi_1077_;
                let _e647 = -(290000000000000000000000000000000000000f);
                if (_e646 > _e647) {
                    phi_1083_ = _e646;
                } else {
                    phi_1083_ = _e647;
                }
                let _e650 = phi_1083_;
                if (_e650 < 290000000000000000000000000000000000000f) {
                    phi_1088_ = _e650;
                } else {
                    phi_1088_ = 290000000000000000000000000000000000000f;
                }
                let _e653 = phi_1088_;
                local_1.member_1[_e579.member_1] = _e653;
            }
            continue;
            continuing {
                phi_938_ = _e577;
                break if !(_e583);
            }
        }
        let _e657 = local_1;
        local = _e657;
        phi_1121_ = type_16(0u, 3u);
        loop {
            let _e659 = phi_1121_;
            if (_e659.member < _e659.member_1) {
                phi_1122_ = type_16((_e659.member + 1u), _e659.member_1);
                phi_1145_ = type_16(1u, _e659.member);
            } else {
                phi_1122_ = _e659;
                phi_1145_ = type_16(0u, type_16().member_1);
            }
            let _e671 = phi_1122_;
            let _e673 = phi_1145_;
            let _e677 = (bitcast<i32>(_e673.member) != 0i);
            if _e677 {
                let _e680 = local.member[_e673.member_1];
                if (_e680 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1166_ = (_e680 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1166_ = false;
                }
                let _e685 = phi_1166_;
                if _e685 {
                    let _e691 = local_6.member[_e673.member_1];
                    let _e693 = bitcast<u64>(-(_e691));
                    let _e696 = u32((_e693 / 4294967296lu));
                    if ((_e696 >> bitcast<u32>(31i)) == 0u) {
                        phi_1189_ = ((u32(_e693) | _e696) != 0u);
                    } else {
                        phi_1189_ = false;
                    }
                    let _e703 = phi_1189_;
                    if _e703 {
                        phi_1193_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1193_ = 0f;
                    }
                    let _e705 = phi_1193_;
                    phi_1202_ = -(_e705);
                } else {
                    let _e688 = local.member[_e673.member_1];
                    phi_1202_ = _e688;
                }
                let _e708 = phi_1202_;
                local.member[_e673.member_1] = _e708;
                let _e713 = local.member_1[_e673.member_1];
                if (_e713 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1223_ = (_e713 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1223_ = false;
                }
                let _e718 = phi_1223_;
                if _e718 {
                    let _e724 = local_6.member_1[_e673.member_1];
                    let _e725 = bitcast<u64>(_e724);
                    let _e728 = u32((_e725 / 4294967296lu));
                    if ((_e728 >> bitcast<u32>(31i)) == 0u) {
                        phi_1246_ = ((u32(_e725) | _e728) != 0u);
                    } else {
                        phi_1246_ = false;
                    }
                    let _e735 = phi_1246_;
                    if _e735 {
                        phi_1250_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1250_ = 0f;
                    }
                    let _e737 = phi_1250_;
                    phi_1259_ = _e737;
                } else {
                    let _e721 = local.member_1[_e673.member_1];
                    phi_1259_ = _e721;
                }
                let _e739 = phi_1259_;
                local.member_1[_e673.member_1] = _e739;
            }
            continue;
            continuing {
                phi_1121_ = _e671;
                break if !(_e677);
            }
        }
        let _e743 = local;
        boxes.member[_e52] = type_11(array<f32, 3>(_e743.member[0], _e743.member[1], _e743.member[2]), array<f32, 3>(_e743.member_1[0], _e743.member_1[1], _e743.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
