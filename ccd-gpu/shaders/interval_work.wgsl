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

struct type_26 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage> keys: type_11;
var<workgroup> counters: array<atomic<u32>, 8>;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> sorted: type_19;
@group(0) @binding(3) 
var<storage> survey: type_11;
@group(0) @binding(4) 
var<storage, read_write> work: type_26;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_136_: array<u32, 2>;
    var phi_148_: array<u32, 2>;
    var phi_149_: bool;
    var phi_150_: array<u32, 2>;
    var phi_151_: bool;
    var phi_156_: array<u32, 2>;
    var phi_194_: array<u32, 2>;
    var phi_206_: array<u32, 2>;
    var phi_207_: bool;
    var phi_208_: array<u32, 2>;
    var phi_209_: bool;
    var phi_214_: array<u32, 2>;
    var phi_301_: u32;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_343_: u32;
    var phi_344_: bool;
    var phi_345_: u32;
    var phi_346_: bool;
    var phi_350_: u32;
    var phi_357_: u32;
    var phi_371_: array<u32, 2>;
    var phi_372_: array<u32, 2>;
    var phi_373_: bool;
    var phi_374_: array<u32, 2>;
    var phi_375_: bool;
    var phi_376_: array<u32, 2>;
    var phi_377_: bool;
    var phi_382_: array<u32, 2>;
    var phi_389_: array<u32, 2>;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_278_: u32;
    var phi_288_: u32;
    var phi_390_: array<u32, 2>;
    var phi_398_: u32;
    var phi_401_: array<u32, 3>;
    var phi_428_: u32;
    var phi_431_: type_14;
    var phi_434_: u32;
    var phi_436_: u32;
    var phi_457_: bool;
    var phi_463_: type_15;
    var phi_432_: type_14;
    var phi_477_: type_15;
    var phi_506_: u32;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_509_: u32;
    var phi_510_: bool;
    var phi_435_: u32;
    var phi_437_: u32;
    var phi_511_: bool;
    var local: u32;
    var phi_528_: u32;
    var phi_529_: u32;
    var phi_530_: u32;
    var phi_579_: bool;
    var phi_625_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_678_: bool;
    var phi_684_: bool;
    var phi_704_: u32;
    var phi_705_: u32;
    var phi_754_: u32;
    var phi_757_: type_9;
    var phi_758_: type_9;
    var phi_781_: type_9;
    var phi_802_: u32;
    var phi_818_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e47 = id_2;
    let _e48 = n_2;
    let _e49 = lane_2;
    let _e59 = ((_e47.y * _e48.x) + _e47.x);
    let _e62 = params.member.member_2.member_2;
    if (_e49 == 0u) {
        atomicStore((&counters[0u]), 4294967295u);
        atomicStore((&counters[1u]), 0u);
    }
    workgroupBarrier();
    let _e68 = params.member.member_2.member;
    let _e71 = params.member.member_2.member_1;
    if (_e71 == 0u) {
        phi_136_ = array<u32, 2>(0u, 2u);
    } else {
        phi_136_ = array<u32, 2>(1u, 1u);
    }
    let _e74 = phi_136_;
    if (_e68 == 1u) {
        if (_e62 == 1u) {
            phi_148_ = array<u32, 2>(_e74[1], _e74[0]);
            phi_149_ = false;
        } else {
            phi_148_ = array<u32, 2>();
            phi_149_ = true;
        }
        let _e81 = phi_148_;
        let _e83 = phi_149_;
        phi_150_ = _e81;
        phi_151_ = _e83;
    } else {
        phi_150_ = array<u32, 2>();
        phi_151_ = true;
    }
    let _e85 = phi_150_;
    let _e87 = phi_151_;
    if _e87 {
        phi_156_ = _e74;
    } else {
        phi_156_ = _e85;
    }
    let _e89 = phi_156_;
    let _e92 = ((_e59 * 128u) + _e49);
    let _e96 = params.member.member.member_2[_e89[0]];
    let _e97 = (_e96 + _e92);
    let _e101 = params.member.member.member[_e89[0]];
    if (_e92 < _e101) {
        let _e105 = params.member.member_2.member;
        let _e108 = params.member.member_2.member_1;
        if (_e108 == 0u) {
            phi_194_ = array<u32, 2>(0u, 2u);
        } else {
            phi_194_ = array<u32, 2>(1u, 1u);
        }
        let _e111 = phi_194_;
        if (_e105 == 1u) {
            if (_e62 == 1u) {
                phi_206_ = array<u32, 2>(_e111[1], _e111[0]);
                phi_207_ = false;
            } else {
                phi_206_ = array<u32, 2>();
                phi_207_ = true;
            }
            let _e118 = phi_206_;
            let _e120 = phi_207_;
            phi_208_ = _e118;
            phi_209_ = _e120;
        } else {
            phi_208_ = array<u32, 2>();
            phi_209_ = true;
        }
        let _e122 = phi_208_;
        let _e124 = phi_209_;
        if _e124 {
            phi_214_ = _e111;
        } else {
            phi_214_ = _e122;
        }
        let _e126 = phi_214_;
        let _e129 = keys.member[_e97];
        let _e131 = sorted.member[_e97];
        let _e133 = (_e126[1] << bitcast<u32>(30u));
        let _e134 = (_e129 & 1073741823u);
        if (_e105 == 1u) {
            let _e221 = survey.member[6u];
            if (_e221 == 0u) {
                phi_272_ = _e131.member_1[0];
            } else {
                if (_e221 == 1u) {
                    phi_271_ = _e131.member_1[1];
                } else {
                    phi_271_ = _e131.member_1[2];
                }
                let _e229 = phi_271_;
                phi_272_ = _e229;
            }
            let _e233 = phi_272_;
            let _e234 = bitcast<u32>(_e233);
            if (_e234 == 2147483648u) {
                phi_278_ = 0u;
            } else {
                phi_278_ = _e234;
            }
            let _e237 = phi_278_;
            let _e239 = bitcast<u32>(bitcast<f32>(_e237));
            if ((_e239 >> bitcast<u32>(31i)) == 1u) {
                phi_288_ = ~(_e239);
            } else {
                phi_288_ = (_e239 | 2147483648u);
            }
            let _e246 = phi_288_;
            phi_390_ = array<u32, 2>(((_e133 | _e134) + _e62), (_e133 | (_e246 >> bitcast<u32>(2i))));
        } else {
            if (_e105 == 2u) {
                let _e138 = (_e108 == 1u);
                if _e138 {
                    phi_301_ = (4u + _e62);
                } else {
                    phi_301_ = _e62;
                }
                let _e141 = phi_301_;
                let _e142 = (_e134 & 1023u);
                let _e149 = (((_e134 >> bitcast<u32>(10u)) & 1023u) + (_e141 % 3u));
                let _e151 = ((_e134 >> bitcast<u32>(20u)) + (_e141 / 3u));
                if (_e149 < 1u) {
                    phi_376_ = array<u32, 2>();
                    phi_377_ = true;
                } else {
                    if (_e151 < 1u) {
                        phi_374_ = array<u32, 2>();
                        phi_375_ = true;
                    } else {
                        if (_e149 > 1024u) {
                            phi_372_ = array<u32, 2>();
                            phi_373_ = true;
                        } else {
                            let _e155 = (_e151 > 1024u);
                            if _e155 {
                                phi_371_ = array<u32, 2>();
                            } else {
                                if (_e142 > 0u) {
                                    if _e138 {
                                        if (_e141 == 4u) {
                                            phi_337_ = false;
                                        } else {
                                            phi_337_ = true;
                                        }
                                        let _e159 = phi_337_;
                                        phi_338_ = _e159;
                                    } else {
                                        phi_338_ = true;
                                    }
                                    let _e161 = phi_338_;
                                    if _e161 {
                                        phi_343_ = (_e142 - 1u);
                                        phi_344_ = false;
                                    } else {
                                        phi_343_ = u32();
                                        phi_344_ = true;
                                    }
                                    let _e164 = phi_343_;
                                    let _e166 = phi_344_;
                                    phi_345_ = _e164;
                                    phi_346_ = _e166;
                                } else {
                                    phi_345_ = u32();
                                    phi_346_ = true;
                                }
                                let _e168 = phi_345_;
                                let _e170 = phi_346_;
                                if _e170 {
                                    phi_350_ = _e142;
                                } else {
                                    phi_350_ = _e168;
                                }
                                let _e172 = phi_350_;
                                if ((_e142 + 1u) < 1024u) {
                                    phi_357_ = (_e142 + 1u);
                                } else {
                                    phi_357_ = _e142;
                                }
                                let _e177 = phi_357_;
                                phi_371_ = array<u32, 2>(((((_e151 - 1u) << bitcast<u32>(20u)) | ((_e149 - 1u) << bitcast<u32>(10u))) | _e172), ((((_e151 - 1u) << bitcast<u32>(20u)) | ((_e149 - 1u) << bitcast<u32>(10u))) | _e177));
                            }
                            let _e196 = phi_371_;
                            phi_372_ = _e196;
                            phi_373_ = _e155;
                        }
                        let _e198 = phi_372_;
                        let _e200 = phi_373_;
                        phi_374_ = _e198;
                        phi_375_ = _e200;
                    }
                    let _e202 = phi_374_;
                    let _e204 = phi_375_;
                    phi_376_ = _e202;
                    phi_377_ = _e204;
                }
                let _e206 = phi_376_;
                let _e208 = phi_377_;
                if _e208 {
                    phi_382_ = array<u32, 2>(1u, 0u);
                } else {
                    phi_382_ = _e206;
                }
                let _e210 = phi_382_;
                phi_389_ = array<u32, 2>((_e133 | _e210[0]), (_e133 | _e210[1]));
            } else {
                phi_389_ = array<u32, 2>(_e133, _e133);
            }
            let _e217 = phi_389_;
            phi_390_ = _e217;
        }
        let _e252 = phi_390_;
        if (_e108 == 1u) {
            phi_398_ = (_e97 + 1u);
        } else {
            phi_398_ = 0u;
        }
        let _e258 = phi_398_;
        phi_401_ = array<u32, 3>(_e252[0], _e252[1], _e258);
    } else {
        phi_401_ = array<u32, 3>(4294967295u, 0u, 0u);
    }
    let _e261 = phi_401_;
    if (_e261[0] <= _e261[1]) {
        let _e266 = atomicMin((&counters[0u]), _e261[0]);
        let _e268 = atomicMax((&counters[1u]), _e261[1]);
    }
    workgroupBarrier();
    let _e272 = params.member.member.member_2[3u];
    let _e274 = atomicLoad((&counters[0u]));
    let _e276 = atomicLoad((&counters[1u]));
    if (_e49 < 2u) {
        if (_e49 == 0u) {
            phi_428_ = _e274;
        } else {
            phi_428_ = (_e276 + 1u);
        }
        let _e281 = phi_428_;
        phi_431_ = type_14(0i, 32i);
        phi_434_ = 0u;
        phi_436_ = _e272;
        loop {
            let _e283 = phi_431_;
            let _e285 = phi_434_;
            let _e287 = phi_436_;
            local = _e285;
            local_1 = _e285;
            local_2 = _e285;
            local_3 = _e285;
            if (_e283.member < _e283.member_1) {
                let _e294 = (_e283.member + 1i);
                if ((false == (_e294 > _e283.member)) != false) {
                    phi_457_ = true;
                } else {
                    phi_457_ = false;
                }
                let _e299 = phi_457_;
                if _e299 {
                    phi_463_ = type_15(0u, type_15().member_1);
                } else {
                    phi_463_ = type_15(1u, _e294);
                }
                let _e304 = phi_463_;
                phi_432_ = type_14(_e304.member_1, _e283.member_1);
                phi_477_ = type_15(1u, _e283.member);
            } else {
                phi_432_ = _e283;
                phi_477_ = type_15(0u, type_15().member_1);
            }
            let _e310 = phi_432_;
            let _e312 = phi_477_;
            if (bitcast<i32>(_e312.member) != 0i) {
                if (_e285 >= _e287) {
                    phi_508_ = u32();
                    phi_509_ = u32();
                    phi_510_ = false;
                } else {
                    let _e319 = (_e285 + ((_e287 - _e285) / 2u));
                    let _e321 = keys.member[_e319];
                    if (_e321 < _e281) {
                        phi_506_ = (_e319 + 1u);
                        phi_507_ = _e287;
                    } else {
                        phi_506_ = _e285;
                        phi_507_ = _e319;
                    }
                    let _e325 = phi_506_;
                    let _e327 = phi_507_;
                    phi_508_ = _e325;
                    phi_509_ = _e327;
                    phi_510_ = true;
                }
                let _e329 = phi_508_;
                let _e331 = phi_509_;
                let _e333 = phi_510_;
                phi_435_ = _e329;
                phi_437_ = _e331;
                phi_511_ = _e333;
            } else {
                phi_435_ = u32();
                phi_437_ = u32();
                phi_511_ = false;
            }
            let _e335 = phi_435_;
            let _e337 = phi_437_;
            let _e339 = phi_511_;
            continue;
            continuing {
                phi_431_ = _e310;
                phi_434_ = _e335;
                phi_436_ = _e337;
                break if !(_e339);
            }
        }
        if (_e49 == 0u) {
            let _e344 = params.member.member_2.member_1;
            if (_e344 == 1u) {
                let _e346 = (_e97 + 1u);
                let _e348 = local;
                if (_e346 < _e348) {
                    let _e549 = local_1;
                    phi_528_ = _e549;
                } else {
                    phi_528_ = _e346;
                }
                let _e351 = phi_528_;
                phi_529_ = _e351;
            } else {
                let _e552 = local_2;
                phi_529_ = _e552;
            }
            let _e353 = phi_529_;
            phi_530_ = _e353;
        } else {
            let _e555 = local_3;
            phi_530_ = _e555;
        }
        let _e355 = phi_530_;
        atomicStore((&counters[(2u + _e49)]), _e355);
    }
    workgroupBarrier();
    let _e359 = atomicLoad((&counters[2u]));
    let _e361 = atomicLoad((&counters[3u]));
    let _e363 = survey.member[10u];
    if (_e363 > 0u) {
        phi_579_ = true;
    } else {
        let _e366 = survey.member[9u];
        let _e370 = params.member.member_2.member_3[0u];
        phi_579_ = (_e366 > _e370);
    }
    let _e373 = phi_579_;
    if _e373 {
        phi_673_ = bool();
        phi_674_ = true;
    } else {
        let _e375 = survey.member[15u];
        if (_e375 > 0u) {
            phi_625_ = true;
        } else {
            let _e378 = survey.member[14u];
            let _e382 = params.member.member_2.member_3[1u];
            phi_625_ = (_e378 > _e382);
        }
        let _e385 = phi_625_;
        if _e385 {
            phi_672_ = bool();
        } else {
            let _e387 = survey.member[20u];
            if (_e387 > 0u) {
                phi_671_ = true;
            } else {
                let _e390 = survey.member[19u];
                let _e394 = params.member.member_2.member_3[2u];
                phi_671_ = (_e390 > _e394);
            }
            let _e397 = phi_671_;
            phi_672_ = _e397;
        }
        let _e399 = phi_672_;
        phi_673_ = _e399;
        phi_674_ = _e385;
    }
    let _e401 = phi_673_;
    let _e403 = phi_674_;
    if _e403 {
        phi_678_ = true;
    } else {
        phi_678_ = _e401;
    }
    let _e405 = phi_678_;
    if (_e359 < _e361) {
        phi_684_ = !(_e405);
    } else {
        phi_684_ = false;
    }
    let _e409 = phi_684_;
    if _e409 {
        let _e410 = (_e361 - _e359);
        let _e411 = (_e410 / 1024u);
        if ((_e410 % 1024u) > 0u) {
            phi_704_ = (_e411 + 1u);
        } else {
            phi_704_ = _e411;
        }
        let _e416 = phi_704_;
        phi_705_ = _e416;
    } else {
        phi_705_ = 0u;
    }
    let _e418 = phi_705_;
    if (_e49 == 0u) {
        if (_e418 > 0u) {
            let _e422 = atomicAdd((&work.member[0u]), _e418);
            if ((_e422 + _e418) < _e422) {
                let _e426 = atomicAdd((&work.member[2u]), 1u);
            }
            atomicStore((&counters[5u]), _e422);
        }
    }
    if (_e49 == 0u) {
        if _e405 {
            let _e430 = atomicMax((&work.member[0u]), 4294967295u);
        }
    }
    workgroupBarrier();
    let _e432 = atomicLoad((&counters[5u]));
    let _e433 = (_e418 / 128u);
    if ((_e418 % 128u) > 0u) {
        phi_754_ = (_e433 + 1u);
    } else {
        phi_754_ = _e433;
    }
    let _e438 = phi_754_;
    phi_757_ = type_9(0u, _e438);
    loop {
        let _e441 = phi_757_;
        if (_e441.member < _e441.member_1) {
            phi_758_ = type_9((_e441.member + 1u), _e441.member_1);
            phi_781_ = type_9(1u, _e441.member);
        } else {
            phi_758_ = _e441;
            phi_781_ = type_9(0u, type_9().member_1);
        }
        let _e453 = phi_758_;
        let _e455 = phi_781_;
        let _e459 = (bitcast<i32>(_e455.member) != 0i);
        if _e459 {
            let _e461 = ((_e455.member_1 * 128u) + _e49);
            if (_e461 < _e418) {
                let _e464 = (_e359 + (_e461 * 1024u));
                let _e465 = (_e361 - _e464);
                if (1024u < _e465) {
                    phi_802_ = 1024u;
                } else {
                    phi_802_ = _e465;
                }
                let _e468 = phi_802_;
                let _e469 = (_e468 / 128u);
                if ((_e468 % 128u) > 0u) {
                    phi_818_ = (_e469 + 1u);
                } else {
                    phi_818_ = _e469;
                }
                let _e474 = phi_818_;
                let _e484 = params.member.member_1.member_3;
                let _e485 = (_e432 + _e461);
                if (_e485 < _e484) {
                    let _e487 = (2u * _e485);
                    atomicStore((&work.member[(4u + _e487)]), (((_e62 << bitcast<u32>(28i)) | ((_e474 - 1u) << bitcast<u32>(24i))) | _e59));
                    atomicStore((&work.member[(_e487 + 5u)]), _e464);
                }
            }
        }
        continue;
        continuing {
            phi_757_ = _e453;
            break if !(_e459);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_work(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
