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
    var phi_123_: array<u32, 2>;
    var phi_135_: array<u32, 2>;
    var phi_136_: bool;
    var phi_137_: array<u32, 2>;
    var phi_138_: bool;
    var phi_143_: array<u32, 2>;
    var phi_179_: array<u32, 2>;
    var phi_191_: array<u32, 2>;
    var phi_192_: bool;
    var phi_193_: array<u32, 2>;
    var phi_194_: bool;
    var phi_199_: array<u32, 2>;
    var phi_280_: u32;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_322_: u32;
    var phi_323_: bool;
    var phi_324_: u32;
    var phi_325_: bool;
    var phi_329_: u32;
    var phi_336_: u32;
    var phi_350_: array<u32, 2>;
    var phi_351_: array<u32, 2>;
    var phi_352_: bool;
    var phi_353_: array<u32, 2>;
    var phi_354_: bool;
    var phi_355_: array<u32, 2>;
    var phi_356_: bool;
    var phi_361_: array<u32, 2>;
    var phi_368_: array<u32, 2>;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_257_: u32;
    var phi_267_: u32;
    var phi_369_: array<u32, 2>;
    var phi_377_: u32;
    var phi_380_: array<u32, 3>;
    var phi_407_: u32;
    var phi_410_: type_14;
    var phi_413_: u32;
    var phi_415_: u32;
    var phi_436_: bool;
    var phi_442_: type_15;
    var phi_411_: type_14;
    var phi_456_: type_15;
    var phi_485_: u32;
    var phi_486_: u32;
    var phi_487_: u32;
    var phi_488_: u32;
    var phi_489_: bool;
    var phi_414_: u32;
    var phi_416_: u32;
    var phi_490_: bool;
    var local: u32;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_509_: u32;
    var phi_553_: bool;
    var phi_594_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_642_: bool;
    var phi_648_: bool;
    var phi_668_: u32;
    var phi_669_: u32;
    var phi_718_: u32;
    var phi_721_: type_9;
    var phi_722_: type_9;
    var phi_745_: type_9;
    var phi_766_: u32;
    var phi_782_: u32;
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
        phi_123_ = array<u32, 2>(0u, 2u);
    } else {
        phi_123_ = array<u32, 2>(1u, 1u);
    }
    let _e74 = phi_123_;
    if (_e68 == 1u) {
        if (_e62 == 1u) {
            phi_135_ = array<u32, 2>(_e74[1], _e74[0]);
            phi_136_ = false;
        } else {
            phi_135_ = array<u32, 2>();
            phi_136_ = true;
        }
        let _e81 = phi_135_;
        let _e83 = phi_136_;
        phi_137_ = _e81;
        phi_138_ = _e83;
    } else {
        phi_137_ = array<u32, 2>();
        phi_138_ = true;
    }
    let _e85 = phi_137_;
    let _e87 = phi_138_;
    if _e87 {
        phi_143_ = _e74;
    } else {
        phi_143_ = _e85;
    }
    let _e89 = phi_143_;
    let _e92 = ((_e59 * 128u) + _e49);
    let _e96 = params.member.member.member_2[_e89[0]];
    let _e97 = (_e96 + _e92);
    let _e101 = params.member.member.member[_e89[0]];
    if (_e92 < _e101) {
        let _e105 = params.member.member_2.member;
        let _e108 = params.member.member_2.member_1;
        if (_e108 == 0u) {
            phi_179_ = array<u32, 2>(0u, 2u);
        } else {
            phi_179_ = array<u32, 2>(1u, 1u);
        }
        let _e111 = phi_179_;
        if (_e105 == 1u) {
            if (_e62 == 1u) {
                phi_191_ = array<u32, 2>(_e111[1], _e111[0]);
                phi_192_ = false;
            } else {
                phi_191_ = array<u32, 2>();
                phi_192_ = true;
            }
            let _e118 = phi_191_;
            let _e120 = phi_192_;
            phi_193_ = _e118;
            phi_194_ = _e120;
        } else {
            phi_193_ = array<u32, 2>();
            phi_194_ = true;
        }
        let _e122 = phi_193_;
        let _e124 = phi_194_;
        if _e124 {
            phi_199_ = _e111;
        } else {
            phi_199_ = _e122;
        }
        let _e126 = phi_199_;
        let _e129 = keys.member[_e97];
        let _e131 = sorted.member[_e97];
        let _e133 = (_e126[1] << bitcast<u32>(30u));
        let _e134 = (_e129 & 1073741823u);
        if (_e105 == 1u) {
            let _e221 = survey.member[6u];
            if (_e221 == 0u) {
                phi_251_ = _e131.member_1[0];
            } else {
                if (_e221 == 1u) {
                    phi_250_ = _e131.member_1[1];
                } else {
                    phi_250_ = _e131.member_1[2];
                }
                let _e229 = phi_250_;
                phi_251_ = _e229;
            }
            let _e233 = phi_251_;
            let _e234 = bitcast<u32>(_e233);
            if (_e234 == 2147483648u) {
                phi_257_ = 0u;
            } else {
                phi_257_ = _e234;
            }
            let _e237 = phi_257_;
            let _e239 = bitcast<u32>(bitcast<f32>(_e237));
            if ((_e239 >> bitcast<u32>(31i)) == 1u) {
                phi_267_ = ~(_e239);
            } else {
                phi_267_ = (_e239 | 2147483648u);
            }
            let _e246 = phi_267_;
            phi_369_ = array<u32, 2>(((_e133 | _e134) + _e62), (_e133 | (_e246 >> bitcast<u32>(2i))));
        } else {
            if (_e105 == 2u) {
                let _e138 = (_e108 == 1u);
                if _e138 {
                    phi_280_ = (4u + _e62);
                } else {
                    phi_280_ = _e62;
                }
                let _e141 = phi_280_;
                let _e142 = (_e134 & 1023u);
                let _e149 = (((_e134 >> bitcast<u32>(10u)) & 1023u) + (_e141 % 3u));
                let _e151 = ((_e134 >> bitcast<u32>(20u)) + (_e141 / 3u));
                if (_e149 < 1u) {
                    phi_355_ = array<u32, 2>();
                    phi_356_ = true;
                } else {
                    if (_e151 < 1u) {
                        phi_353_ = array<u32, 2>();
                        phi_354_ = true;
                    } else {
                        if (_e149 > 1024u) {
                            phi_351_ = array<u32, 2>();
                            phi_352_ = true;
                        } else {
                            let _e155 = (_e151 > 1024u);
                            if _e155 {
                                phi_350_ = array<u32, 2>();
                            } else {
                                if (_e142 > 0u) {
                                    if _e138 {
                                        if (_e141 == 4u) {
                                            phi_316_ = false;
                                        } else {
                                            phi_316_ = true;
                                        }
                                        let _e159 = phi_316_;
                                        phi_317_ = _e159;
                                    } else {
                                        phi_317_ = true;
                                    }
                                    let _e161 = phi_317_;
                                    if _e161 {
                                        phi_322_ = (_e142 - 1u);
                                        phi_323_ = false;
                                    } else {
                                        phi_322_ = u32();
                                        phi_323_ = true;
                                    }
                                    let _e164 = phi_322_;
                                    let _e166 = phi_323_;
                                    phi_324_ = _e164;
                                    phi_325_ = _e166;
                                } else {
                                    phi_324_ = u32();
                                    phi_325_ = true;
                                }
                                let _e168 = phi_324_;
                                let _e170 = phi_325_;
                                if _e170 {
                                    phi_329_ = _e142;
                                } else {
                                    phi_329_ = _e168;
                                }
                                let _e172 = phi_329_;
                                if ((_e142 + 1u) < 1024u) {
                                    phi_336_ = (_e142 + 1u);
                                } else {
                                    phi_336_ = _e142;
                                }
                                let _e177 = phi_336_;
                                phi_350_ = array<u32, 2>(((((_e151 - 1u) << bitcast<u32>(20u)) | ((_e149 - 1u) << bitcast<u32>(10u))) | _e172), ((((_e151 - 1u) << bitcast<u32>(20u)) | ((_e149 - 1u) << bitcast<u32>(10u))) | _e177));
                            }
                            let _e196 = phi_350_;
                            phi_351_ = _e196;
                            phi_352_ = _e155;
                        }
                        let _e198 = phi_351_;
                        let _e200 = phi_352_;
                        phi_353_ = _e198;
                        phi_354_ = _e200;
                    }
                    let _e202 = phi_353_;
                    let _e204 = phi_354_;
                    phi_355_ = _e202;
                    phi_356_ = _e204;
                }
                let _e206 = phi_355_;
                let _e208 = phi_356_;
                if _e208 {
                    phi_361_ = array<u32, 2>(1u, 0u);
                } else {
                    phi_361_ = _e206;
                }
                let _e210 = phi_361_;
                phi_368_ = array<u32, 2>((_e133 | _e210[0]), (_e133 | _e210[1]));
            } else {
                phi_368_ = array<u32, 2>(_e133, _e133);
            }
            let _e217 = phi_368_;
            phi_369_ = _e217;
        }
        let _e252 = phi_369_;
        if (_e108 == 1u) {
            phi_377_ = (_e97 + 1u);
        } else {
            phi_377_ = 0u;
        }
        let _e258 = phi_377_;
        phi_380_ = array<u32, 3>(_e252[0], _e252[1], _e258);
    } else {
        phi_380_ = array<u32, 3>(4294967295u, 0u, 0u);
    }
    let _e261 = phi_380_;
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
            phi_407_ = _e274;
        } else {
            phi_407_ = (_e276 + 1u);
        }
        let _e281 = phi_407_;
        phi_410_ = type_14(0i, 32i);
        phi_413_ = 0u;
        phi_415_ = _e272;
        loop {
            let _e283 = phi_410_;
            let _e285 = phi_413_;
            let _e287 = phi_415_;
            local = _e285;
            local_1 = _e285;
            local_2 = _e285;
            local_3 = _e285;
            if (_e283.member < _e283.member_1) {
                let _e294 = (_e283.member + 1i);
                if ((false == (_e294 > _e283.member)) != false) {
                    phi_436_ = true;
                } else {
                    phi_436_ = false;
                }
                let _e299 = phi_436_;
                if _e299 {
                    phi_442_ = type_15(0u, type_15().member_1);
                } else {
                    phi_442_ = type_15(1u, _e294);
                }
                let _e304 = phi_442_;
                phi_411_ = type_14(_e304.member_1, _e283.member_1);
                phi_456_ = type_15(1u, _e283.member);
            } else {
                phi_411_ = _e283;
                phi_456_ = type_15(0u, type_15().member_1);
            }
            let _e310 = phi_411_;
            let _e312 = phi_456_;
            if (bitcast<i32>(_e312.member) != 0i) {
                if (_e285 >= _e287) {
                    phi_487_ = u32();
                    phi_488_ = u32();
                    phi_489_ = false;
                } else {
                    let _e319 = (_e285 + ((_e287 - _e285) / 2u));
                    let _e321 = keys.member[_e319];
                    if (_e321 < _e281) {
                        phi_485_ = (_e319 + 1u);
                        phi_486_ = _e287;
                    } else {
                        phi_485_ = _e285;
                        phi_486_ = _e319;
                    }
                    let _e325 = phi_485_;
                    let _e327 = phi_486_;
                    phi_487_ = _e325;
                    phi_488_ = _e327;
                    phi_489_ = true;
                }
                let _e329 = phi_487_;
                let _e331 = phi_488_;
                let _e333 = phi_489_;
                phi_414_ = _e329;
                phi_416_ = _e331;
                phi_490_ = _e333;
            } else {
                phi_414_ = u32();
                phi_416_ = u32();
                phi_490_ = false;
            }
            let _e335 = phi_414_;
            let _e337 = phi_416_;
            let _e339 = phi_490_;
            continue;
            continuing {
                phi_410_ = _e310;
                phi_413_ = _e335;
                phi_415_ = _e337;
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
                    phi_507_ = _e549;
                } else {
                    phi_507_ = _e346;
                }
                let _e351 = phi_507_;
                phi_508_ = _e351;
            } else {
                let _e552 = local_2;
                phi_508_ = _e552;
            }
            let _e353 = phi_508_;
            phi_509_ = _e353;
        } else {
            let _e555 = local_3;
            phi_509_ = _e555;
        }
        let _e355 = phi_509_;
        atomicStore((&counters[(2u + _e49)]), _e355);
    }
    workgroupBarrier();
    let _e359 = atomicLoad((&counters[2u]));
    let _e361 = atomicLoad((&counters[3u]));
    let _e363 = survey.member[10u];
    if (_e363 > 0u) {
        phi_553_ = true;
    } else {
        let _e366 = survey.member[9u];
        let _e370 = params.member.member_2.member_3[0u];
        phi_553_ = (_e366 > _e370);
    }
    let _e373 = phi_553_;
    if _e373 {
        phi_637_ = bool();
        phi_638_ = true;
    } else {
        let _e375 = survey.member[15u];
        if (_e375 > 0u) {
            phi_594_ = true;
        } else {
            let _e378 = survey.member[14u];
            let _e382 = params.member.member_2.member_3[1u];
            phi_594_ = (_e378 > _e382);
        }
        let _e385 = phi_594_;
        if _e385 {
            phi_636_ = bool();
        } else {
            let _e387 = survey.member[20u];
            if (_e387 > 0u) {
                phi_635_ = true;
            } else {
                let _e390 = survey.member[19u];
                let _e394 = params.member.member_2.member_3[2u];
                phi_635_ = (_e390 > _e394);
            }
            let _e397 = phi_635_;
            phi_636_ = _e397;
        }
        let _e399 = phi_636_;
        phi_637_ = _e399;
        phi_638_ = _e385;
    }
    let _e401 = phi_637_;
    let _e403 = phi_638_;
    if _e403 {
        phi_642_ = true;
    } else {
        phi_642_ = _e401;
    }
    let _e405 = phi_642_;
    if (_e359 < _e361) {
        phi_648_ = !(_e405);
    } else {
        phi_648_ = false;
    }
    let _e409 = phi_648_;
    if _e409 {
        let _e410 = (_e361 - _e359);
        let _e411 = (_e410 / 1024u);
        if ((_e410 % 1024u) > 0u) {
            phi_668_ = (_e411 + 1u);
        } else {
            phi_668_ = _e411;
        }
        let _e416 = phi_668_;
        phi_669_ = _e416;
    } else {
        phi_669_ = 0u;
    }
    let _e418 = phi_669_;
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
        phi_718_ = (_e433 + 1u);
    } else {
        phi_718_ = _e433;
    }
    let _e438 = phi_718_;
    phi_721_ = type_9(0u, _e438);
    loop {
        let _e441 = phi_721_;
        if (_e441.member < _e441.member_1) {
            phi_722_ = type_9((_e441.member + 1u), _e441.member_1);
            phi_745_ = type_9(1u, _e441.member);
        } else {
            phi_722_ = _e441;
            phi_745_ = type_9(0u, type_9().member_1);
        }
        let _e453 = phi_722_;
        let _e455 = phi_745_;
        let _e459 = (bitcast<i32>(_e455.member) != 0i);
        if _e459 {
            let _e461 = ((_e455.member_1 * 128u) + _e49);
            if (_e461 < _e418) {
                let _e464 = (_e359 + (_e461 * 1024u));
                let _e465 = (_e361 - _e464);
                if (1024u < _e465) {
                    phi_766_ = 1024u;
                } else {
                    phi_766_ = _e465;
                }
                let _e468 = phi_766_;
                let _e469 = (_e468 / 128u);
                if ((_e468 % 128u) > 0u) {
                    phi_782_ = (_e469 + 1u);
                } else {
                    phi_782_ = _e469;
                }
                let _e474 = phi_782_;
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
            phi_721_ = _e453;
            break if !(_e459);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_work(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
