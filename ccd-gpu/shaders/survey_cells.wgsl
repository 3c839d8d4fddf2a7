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

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: array<u32, 3>,
}

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_25 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage> keys: type_11;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> sorted: type_19;
@group(0) @binding(3) 
var<storage, read_write> survey: type_25;
var<workgroup> sums: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_17;
    var phi_164_: type_9;
    var phi_167_: u32;
    var phi_165_: type_9;
    var phi_190_: type_9;
    var phi_237_: u32;
    var phi_238_: bool;
    var phi_242_: u32;
    var phi_249_: u32;
    var phi_263_: array<u32, 2>;
    var phi_264_: array<u32, 2>;
    var phi_265_: bool;
    var phi_266_: array<u32, 2>;
    var phi_267_: bool;
    var phi_268_: array<u32, 2>;
    var phi_269_: bool;
    var phi_274_: array<u32, 2>;
    var phi_285_: type_14;
    var phi_288_: u32;
    var phi_290_: u32;
    var phi_311_: bool;
    var phi_317_: type_15;
    var phi_286_: type_14;
    var phi_331_: type_15;
    var phi_360_: u32;
    var phi_361_: u32;
    var phi_362_: u32;
    var phi_363_: u32;
    var phi_364_: bool;
    var phi_289_: u32;
    var phi_291_: u32;
    var phi_365_: bool;
    var phi_369_: type_14;
    var phi_372_: u32;
    var phi_374_: u32;
    var phi_395_: bool;
    var phi_401_: type_15;
    var phi_370_: type_14;
    var phi_415_: type_15;
    var phi_444_: u32;
    var phi_445_: u32;
    var phi_446_: u32;
    var phi_447_: u32;
    var phi_448_: bool;
    var phi_373_: u32;
    var phi_375_: u32;
    var phi_449_: bool;
    var local_1: u32;
    var local_2: u32;
    var phi_452_: u32;
    var phi_168_: u32;
    var local_3: u32;
    var phi_458_: u32;
    var phi_478_: u32;
    var phi_497_: u32;
    var phi_516_: u32;
    var phi_520_: type_9;
    var phi_521_: type_9;
    var phi_544_: type_9;
    var phi_686_: f32;
    var phi_691_: f32;
    var phi_700_: f32;
    var phi_705_: f32;
    var phi_708_: f32;
    var phi_721_: type_14;
    var phi_724_: u32;
    var phi_726_: u32;
    var phi_747_: bool;
    var phi_753_: type_15;
    var phi_722_: type_14;
    var phi_767_: type_15;
    var phi_796_: u32;
    var phi_797_: u32;
    var phi_798_: u32;
    var phi_799_: u32;
    var phi_800_: bool;
    var phi_725_: u32;
    var phi_727_: u32;
    var phi_801_: bool;
    var phi_804_: type_14;
    var phi_807_: u32;
    var phi_809_: u32;
    var phi_830_: bool;
    var phi_836_: type_15;
    var phi_805_: type_14;
    var phi_850_: type_15;
    var phi_879_: u32;
    var phi_880_: u32;
    var phi_881_: u32;
    var phi_882_: u32;
    var phi_883_: bool;
    var phi_808_: u32;
    var phi_810_: u32;
    var phi_884_: bool;
    var local_4: u32;
    var local_5: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e46 = id_2;
    let _e47 = n_2;
    let _e48 = lane_2;
    let _e59 = ((((_e46.y * _e47.x) + _e46.x) * 256u) + _e48);
    if (_e48 < 3u) {
        atomicStore((&sums[_e48]), 0u);
    }
    workgroupBarrier();
    let _e64 = params.member.member_2.member_1;
    let _e67 = params.member.member_1.member;
    if (_e59 < _e67) {
        let _e72 = params.member.member.member_2[_e64];
        let _e75 = params.member.member_1.member_1;
        let _e77 = (_e72 + (_e59 * _e75));
        let _e79 = keys.member[_e77];
        let _e83 = params.member.member.member_2[3u];
        let _e84 = (_e79 & 1073741823u);
        let _e85 = (_e84 & 1023u);
        let _e92 = (_e64 << bitcast<u32>(30i));
        phi_164_ = type_9(0u, 9u);
        phi_167_ = 0u;
        loop {
            let _e94 = phi_164_;
            let _e96 = phi_167_;
            local_3 = _e96;
            if (_e94.member < _e94.member_1) {
                phi_165_ = type_9((_e94.member + 1u), _e94.member_1);
                phi_190_ = type_9(1u, _e94.member);
            } else {
                phi_165_ = _e94;
                phi_190_ = type_9(0u, type_9().member_1);
            }
            let _e108 = phi_165_;
            let _e110 = phi_190_;
            let _e114 = (bitcast<i32>(_e110.member) != 0i);
            if _e114 {
                let _e116 = (((_e84 >> bitcast<u32>(10u)) & 1023u) + (_e110.member_1 % 3u));
                let _e118 = ((_e84 >> bitcast<u32>(20u)) + (_e110.member_1 / 3u));
                if (_e116 < 1u) {
                    phi_268_ = array<u32, 2>();
                    phi_269_ = true;
                } else {
                    if (_e118 < 1u) {
                        phi_266_ = array<u32, 2>();
                        phi_267_ = true;
                    } else {
                        if (_e116 > 1024u) {
                            phi_264_ = array<u32, 2>();
                            phi_265_ = true;
                        } else {
                            let _e122 = (_e118 > 1024u);
                            if _e122 {
                                phi_263_ = array<u32, 2>();
                            } else {
                                if (_e85 > 0u) {
                                    phi_237_ = (_e85 - 1u);
                                    phi_238_ = false;
                                } else {
                                    phi_237_ = u32();
                                    phi_238_ = true;
                                }
                                let _e126 = phi_237_;
                                let _e128 = phi_238_;
                                if _e128 {
                                    phi_242_ = _e85;
                                } else {
                                    phi_242_ = _e126;
                                }
                                let _e130 = phi_242_;
                                if ((_e85 + 1u) < 1024u) {
                                    phi_249_ = (_e85 + 1u);
                                } else {
                                    phi_249_ = _e85;
                                }
                                let _e135 = phi_249_;
                                phi_263_ = array<u32, 2>(((((_e118 - 1u) << bitcast<u32>(20u)) | ((_e116 - 1u) << bitcast<u32>(10u))) | _e130), ((((_e118 - 1u) << bitcast<u32>(20u)) | ((_e116 - 1u) << bitcast<u32>(10u))) | _e135));
                            }
                            let _e154 = phi_263_;
                            phi_264_ = _e154;
                            phi_265_ = _e122;
                        }
                        let _e156 = phi_264_;
                        let _e158 = phi_265_;
                        phi_266_ = _e156;
                        phi_267_ = _e158;
                    }
                    let _e160 = phi_266_;
                    let _e162 = phi_267_;
                    phi_268_ = _e160;
                    phi_269_ = _e162;
                }
                let _e164 = phi_268_;
                let _e166 = phi_269_;
                if _e166 {
                    phi_274_ = array<u32, 2>(1u, 0u);
                } else {
                    phi_274_ = _e164;
                }
                let _e168 = phi_274_;
                if (_e168[0] <= _e168[1]) {
                    phi_285_ = type_14(0i, 32i);
                    phi_288_ = 0u;
                    phi_290_ = _e83;
                    loop {
                        let _e175 = phi_285_;
                        let _e177 = phi_288_;
                        let _e179 = phi_290_;
                        local_1 = _e177;
                        if (_e175.member < _e175.member_1) {
                            let _e186 = (_e175.member + 1i);
                            if ((false == (_e186 > _e175.member)) != false) {
                                phi_311_ = true;
                            } else {
                                phi_311_ = false;
                            }
                            let _e191 = phi_311_;
                            if _e191 {
                                phi_317_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_317_ = type_15(1u, _e186);
                            }
                            let _e196 = phi_317_;
                            phi_286_ = type_14(_e196.member_1, _e175.member_1);
                            phi_331_ = type_15(1u, _e175.member);
                        } else {
                            phi_286_ = _e175;
                            phi_331_ = type_15(0u, type_15().member_1);
                        }
                        let _e202 = phi_286_;
                        let _e204 = phi_331_;
                        if (bitcast<i32>(_e204.member) != 0i) {
                            if (_e177 >= _e179) {
                                phi_362_ = u32();
                                phi_363_ = u32();
                                phi_364_ = false;
                            } else {
                                let _e211 = (_e177 + ((_e179 - _e177) / 2u));
                                let _e213 = keys.member[_e211];
                                if (_e213 < ((_e92 | _e168[1]) + 1u)) {
                                    phi_360_ = (_e211 + 1u);
                                    phi_361_ = _e179;
                                } else {
                                    phi_360_ = _e177;
                                    phi_361_ = _e211;
                                }
                                let _e217 = phi_360_;
                                let _e219 = phi_361_;
                                phi_362_ = _e217;
                                phi_363_ = _e219;
                                phi_364_ = true;
                            }
                            let _e221 = phi_362_;
                            let _e223 = phi_363_;
                            let _e225 = phi_364_;
                            phi_289_ = _e221;
                            phi_291_ = _e223;
                            phi_365_ = _e225;
                        } else {
                            phi_289_ = u32();
                            phi_291_ = u32();
                            phi_365_ = false;
                        }
                        let _e227 = phi_289_;
                        let _e229 = phi_291_;
                        let _e231 = phi_365_;
                        continue;
                        continuing {
                            phi_285_ = _e202;
                            phi_288_ = _e227;
                            phi_290_ = _e229;
                            break if !(_e231);
                        }
                    }
                    phi_369_ = type_14(0i, 32i);
                    phi_372_ = 0u;
                    phi_374_ = _e83;
                    loop {
                        let _e235 = phi_369_;
                        let _e237 = phi_372_;
                        let _e239 = phi_374_;
                        local_2 = _e237;
                        if (_e235.member < _e235.member_1) {
                            let _e246 = (_e235.member + 1i);
                            if ((false == (_e246 > _e235.member)) != false) {
                                phi_395_ = true;
                            } else {
                                phi_395_ = false;
                            }
                            let _e251 = phi_395_;
                            if _e251 {
                                phi_401_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_401_ = type_15(1u, _e246);
                            }
                            let _e256 = phi_401_;
                            phi_370_ = type_14(_e256.member_1, _e235.member_1);
                            phi_415_ = type_15(1u, _e235.member);
                        } else {
                            phi_370_ = _e235;
                            phi_415_ = type_15(0u, type_15().member_1);
                        }
                        let _e262 = phi_370_;
                        let _e264 = phi_415_;
                        if (bitcast<i32>(_e264.member) != 0i) {
                            if (_e237 >= _e239) {
                                phi_446_ = u32();
                                phi_447_ = u32();
                                phi_448_ = false;
                            } else {
                                let _e271 = (_e237 + ((_e239 - _e237) / 2u));
                                let _e273 = keys.member[_e271];
                                if (_e273 < (_e92 | _e168[0])) {
                                    phi_444_ = (_e271 + 1u);
                                    phi_445_ = _e239;
                                } else {
                                    phi_444_ = _e237;
                                    phi_445_ = _e271;
                                }
                                let _e277 = phi_444_;
                                let _e279 = phi_445_;
                                phi_446_ = _e277;
                                phi_447_ = _e279;
                                phi_448_ = true;
                            }
                            let _e281 = phi_446_;
                            let _e283 = phi_447_;
                            let _e285 = phi_448_;
                            phi_373_ = _e281;
                            phi_375_ = _e283;
                            phi_449_ = _e285;
                        } else {
                            phi_373_ = u32();
                            phi_375_ = u32();
                            phi_449_ = false;
                        }
                        let _e287 = phi_373_;
                        let _e289 = phi_375_;
                        let _e291 = phi_449_;
                        continue;
                        continuing {
                            phi_369_ = _e262;
                            phi_372_ = _e287;
                            phi_374_ = _e289;
                            break if !(_e291);
                        }
                    }
                    let _e294 = local_1;
                    let _e296 = local_2;
                    phi_452_ = (_e96 + (_e294 - _e296));
                } else {
                    phi_452_ = _e96;
                }
                let _e300 = phi_452_;
                phi_168_ = _e300;
            } else {
                phi_168_ = u32();
            }
            let _e302 = phi_168_;
            continue;
            continuing {
                phi_164_ = _e108;
                phi_167_ = _e302;
                break if !(_e114);
            }
        }
        let _e305 = local_3;
        let _e306 = (_e305 - 1u);
        if (16777215u < _e306) {
            phi_458_ = 16777215u;
        } else {
            phi_458_ = _e306;
        }
        let _e309 = phi_458_;
        let _e311 = atomicAdd((&sums[0u]), _e309);
        let _e313 = atomicLoad((&survey.member[6u]));
        if ((_e313 >> bitcast<u32>(31i)) == 1u) {
            phi_478_ = (_e313 & 2147483647u);
        } else {
            phi_478_ = ~(_e313);
        }
        let _e320 = phi_478_;
        let _e321 = bitcast<f32>(_e320);
        let _e323 = atomicLoad((&survey.member[7u]));
        if ((_e323 >> bitcast<u32>(31i)) == 1u) {
            phi_497_ = (_e323 & 2147483647u);
        } else {
            phi_497_ = ~(_e323);
        }
        let _e330 = phi_497_;
        let _e331 = bitcast<f32>(_e330);
        let _e333 = atomicLoad((&survey.member[8u]));
        if ((_e333 >> bitcast<u32>(31i)) == 1u) {
            phi_516_ = (_e333 & 2147483647u);
        } else {
            phi_516_ = ~(_e333);
        }
        let _e340 = phi_516_;
        let _e341 = bitcast<f32>(_e340);
        phi_520_ = type_9(0u, 3u);
        loop {
            let _e343 = phi_520_;
            if (_e343.member < _e343.member_1) {
                phi_521_ = type_9((_e343.member + 1u), _e343.member_1);
                phi_544_ = type_9(1u, _e343.member);
            } else {
                phi_521_ = _e343;
                phi_544_ = type_9(0u, type_9().member_1);
            }
            let _e355 = phi_521_;
            let _e357 = phi_544_;
            let _e360 = (bitcast<i32>(_e357.member) != 0i);
            if _e360 {
            }
            continue;
            continuing {
                phi_520_ = _e355;
                break if !(_e360);
            }
        }
        let _e363 = sorted.member[_e77];
        local = type_17(array<f32, 3>(_e363.member[0], _e363.member[1], _e363.member[2]), array<f32, 3>(_e363.member_1[0], _e363.member_1[1], _e363.member_1[2]));
        let _e377 = local.member_1[0u];
        let _e381 = local.member[0u];
        let _e383 = ((_e377 * 0.5f) - (_e381 * 0.5f));
        let _e386 = local.member_1[1u];
        let _e390 = local.member[1u];
        let _e392 = ((_e386 * 0.5f) - (_e390 * 0.5f));
        let _e395 = local.member_1[2u];
        let _e399 = local.member[2u];
        let _e401 = ((_e395 * 0.5f) - (_e399 * 0.5f));
        if (_e331 > _e321) {
            phi_686_ = _e331;
        } else {
            phi_686_ = _e321;
        }
        let _e404 = phi_686_;
        if (_e341 > _e404) {
            phi_691_ = _e341;
        } else {
            phi_691_ = _e404;
        }
        let _e407 = phi_691_;
        if (_e407 > 0f) {
            if (_e392 > _e383) {
                phi_700_ = _e392;
            } else {
                phi_700_ = _e383;
            }
            let _e411 = phi_700_;
            if (_e401 > _e411) {
                phi_705_ = _e401;
            } else {
                phi_705_ = _e411;
            }
            let _e414 = phi_705_;
            phi_708_ = ((_e414 / _e407) * 65536f);
        } else {
            phi_708_ = 0f;
        }
        let _e418 = phi_708_;
        let _e425 = atomicAdd((&sums[1u]), select(select(u32(_e418), 0u, (_e418 < 0f)), 4294967295u, (_e418 > 4294967000f)));
        phi_721_ = type_14(0i, 32i);
        phi_724_ = 0u;
        phi_726_ = _e83;
        loop {
            let _e428 = phi_721_;
            let _e430 = phi_724_;
            let _e432 = phi_726_;
            local_4 = _e430;
            if (_e428.member < _e428.member_1) {
                let _e439 = (_e428.member + 1i);
                if ((false == (_e439 > _e428.member)) != false) {
                    phi_747_ = true;
                } else {
                    phi_747_ = false;
                }
                let _e444 = phi_747_;
                if _e444 {
                    phi_753_ = type_15(0u, type_15().member_1);
                } else {
                    phi_753_ = type_15(1u, _e439);
                }
                let _e449 = phi_753_;
                phi_722_ = type_14(_e449.member_1, _e428.member_1);
                phi_767_ = type_15(1u, _e428.member);
            } else {
                phi_722_ = _e428;
                phi_767_ = type_15(0u, type_15().member_1);
            }
            let _e455 = phi_722_;
            let _e457 = phi_767_;
            if (bitcast<i32>(_e457.member) != 0i) {
                if (_e430 >= _e432) {
                    phi_798_ = u32();
                    phi_799_ = u32();
                    phi_800_ = false;
                } else {
                    let _e464 = (_e430 + ((_e432 - _e430) / 2u));
                    let _e466 = keys.member[_e464];
                    if (_e466 < (_e79 + 1u)) {
                        phi_796_ = (_e464 + 1u);
                        phi_797_ = _e432;
                    } else {
                        phi_796_ = _e430;
                        phi_797_ = _e464;
                    }
                    let _e470 = phi_796_;
                    let _e472 = phi_797_;
                    phi_798_ = _e470;
                    phi_799_ = _e472;
                    phi_800_ = true;
                }
                let _e474 = phi_798_;
                let _e476 = phi_799_;
                let _e478 = phi_800_;
                phi_725_ = _e474;
                phi_727_ = _e476;
                phi_801_ = _e478;
            } else {
                phi_725_ = u32();
                phi_727_ = u32();
                phi_801_ = false;
            }
            let _e480 = phi_725_;
            let _e482 = phi_727_;
            let _e484 = phi_801_;
            continue;
            continuing {
                phi_721_ = _e455;
                phi_724_ = _e480;
                phi_726_ = _e482;
                break if !(_e484);
            }
        }
        phi_804_ = type_14(0i, 32i);
        phi_807_ = 0u;
        phi_809_ = _e83;
        loop {
            let _e487 = phi_804_;
            let _e489 = phi_807_;
            let _e491 = phi_809_;
            local_5 = _e489;
            if (_e487.member < _e487.member_1) {
                let _e498 = (_e487.member + 1i);
                if ((false == (_e498 > _e487.member)) != false) {
                    phi_830_ = true;
                } else {
                    phi_830_ = false;
                }
                let _e503 = phi_830_;
                if _e503 {
                    phi_836_ = type_15(0u, type_15().member_1);
                } else {
                    phi_836_ = type_15(1u, _e498);
                }
                let _e508 = phi_836_;
                phi_805_ = type_14(_e508.member_1, _e487.member_1);
                phi_850_ = type_15(1u, _e487.member);
            } else {
                phi_805_ = _e487;
                phi_850_ = type_15(0u, type_15().member_1);
            }
            let _e514 = phi_805_;
            let _e516 = phi_850_;
            if (bitcast<i32>(_e516.member) != 0i) {
                if (_e489 >= _e491) {
                    phi_881_ = u32();
                    phi_882_ = u32();
                    phi_883_ = false;
                } else {
                    let _e523 = (_e489 + ((_e491 - _e489) / 2u));
                    let _e525 = keys.member[_e523];
                    if (_e525 < _e79) {
                        phi_879_ = (_e523 + 1u);
                        phi_880_ = _e491;
                    } else {
                        phi_879_ = _e489;
                        phi_880_ = _e523;
                    }
                    let _e529 = phi_879_;
                    let _e531 = phi_880_;
                    phi_881_ = _e529;
                    phi_882_ = _e531;
                    phi_883_ = true;
                }
                let _e533 = phi_881_;
                let _e535 = phi_882_;
                let _e537 = phi_883_;
                phi_808_ = _e533;
                phi_810_ = _e535;
                phi_884_ = _e537;
            } else {
                phi_808_ = u32();
                phi_810_ = u32();
                phi_884_ = false;
            }
            let _e539 = phi_808_;
            let _e541 = phi_810_;
            let _e543 = phi_884_;
            continue;
            continuing {
                phi_804_ = _e514;
                phi_807_ = _e539;
                phi_809_ = _e541;
                break if !(_e543);
            }
        }
        let _e546 = local_4;
        let _e548 = local_5;
        let _e551 = atomicMax((&sums[2u]), (_e546 - _e548));
    }
    workgroupBarrier();
    let _e552 = (5u * _e64);
    if (_e48 < 2u) {
        let _e562 = ((9u + _e552) + (2u * _e48));
        let _e564 = atomicLoad((&sums[_e48]));
        let _e566 = atomicAdd((&survey.member[_e562]), _e564);
        if ((_e566 + _e564) < _e566) {
            let _e571 = atomicAdd((&survey.member[(_e562 + 1u)]), 1u);
        }
    } else {
        if (_e48 == 2u) {
            let _e558 = atomicLoad((&sums[2u]));
            let _e560 = atomicMax((&survey.member[(_e552 + 13u)]), _e558);
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn survey_cells(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
