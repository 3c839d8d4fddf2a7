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
    member_3: array<u32, 2>,
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
    var phi_122_: array<u32, 2>;
    var phi_134_: array<u32, 2>;
    var phi_135_: bool;
    var phi_136_: array<u32, 2>;
    var phi_137_: bool;
    var phi_142_: array<u32, 2>;
    var phi_178_: array<u32, 2>;
    var phi_190_: array<u32, 2>;
    var phi_191_: bool;
    var phi_192_: array<u32, 2>;
    var phi_193_: bool;
    var phi_198_: array<u32, 2>;
    var phi_279_: u32;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_321_: u32;
    var phi_322_: bool;
    var phi_323_: u32;
    var phi_324_: bool;
    var phi_328_: u32;
    var phi_335_: u32;
    var phi_349_: array<u32, 2>;
    var phi_350_: array<u32, 2>;
    var phi_351_: bool;
    var phi_352_: array<u32, 2>;
    var phi_353_: bool;
    var phi_354_: array<u32, 2>;
    var phi_355_: bool;
    var phi_360_: array<u32, 2>;
    var phi_367_: array<u32, 2>;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_256_: u32;
    var phi_266_: u32;
    var phi_368_: array<u32, 2>;
    var phi_376_: u32;
    var phi_379_: array<u32, 3>;
    var phi_406_: u32;
    var phi_409_: type_14;
    var phi_412_: u32;
    var phi_414_: u32;
    var phi_435_: bool;
    var phi_441_: type_15;
    var phi_410_: type_14;
    var phi_455_: type_15;
    var phi_484_: u32;
    var phi_485_: u32;
    var phi_486_: u32;
    var phi_487_: u32;
    var phi_488_: bool;
    var phi_413_: u32;
    var phi_415_: u32;
    var phi_489_: bool;
    var local: u32;
    var phi_506_: u32;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_550_: bool;
    var phi_551_: bool;
    var phi_557_: bool;
    var phi_577_: u32;
    var phi_578_: u32;
    var phi_627_: u32;
    var phi_630_: type_9;
    var phi_631_: type_9;
    var phi_654_: type_9;
    var phi_675_: u32;
    var phi_691_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e43 = id_2;
    let _e44 = n_2;
    let _e45 = lane_2;
    let _e55 = ((_e43.y * _e44.x) + _e43.x);
    let _e58 = params.member.member_2.member_2;
    if (_e45 == 0u) {
        atomicStore((&counters[0u]), 4294967295u);
        atomicStore((&counters[1u]), 0u);
    }
    workgroupBarrier();
    let _e64 = params.member.member_2.member;
    let _e67 = params.member.member_2.member_1;
    if (_e67 == 0u) {
        phi_122_ = array<u32, 2>(0u, 2u);
    } else {
        phi_122_ = array<u32, 2>(1u, 1u);
    }
    let _e70 = phi_122_;
    if (_e64 == 1u) {
        if (_e58 == 1u) {
            phi_134_ = array<u32, 2>(_e70[1], _e70[0]);
            phi_135_ = false;
        } else {
            phi_134_ = array<u32, 2>();
            phi_135_ = true;
        }
        let _e77 = phi_134_;
        let _e79 = phi_135_;
        phi_136_ = _e77;
        phi_137_ = _e79;
    } else {
        phi_136_ = array<u32, 2>();
        phi_137_ = true;
    }
    let _e81 = phi_136_;
    let _e83 = phi_137_;
    if _e83 {
        phi_142_ = _e70;
    } else {
        phi_142_ = _e81;
    }
    let _e85 = phi_142_;
    let _e88 = ((_e55 * 128u) + _e45);
    let _e92 = params.member.member.member_2[_e85[0]];
    let _e93 = (_e92 + _e88);
    let _e97 = params.member.member.member[_e85[0]];
    if (_e88 < _e97) {
        let _e101 = params.member.member_2.member;
        let _e104 = params.member.member_2.member_1;
        if (_e104 == 0u) {
            phi_178_ = array<u32, 2>(0u, 2u);
        } else {
            phi_178_ = array<u32, 2>(1u, 1u);
        }
        let _e107 = phi_178_;
        if (_e101 == 1u) {
            if (_e58 == 1u) {
                phi_190_ = array<u32, 2>(_e107[1], _e107[0]);
                phi_191_ = false;
            } else {
                phi_190_ = array<u32, 2>();
                phi_191_ = true;
            }
            let _e114 = phi_190_;
            let _e116 = phi_191_;
            phi_192_ = _e114;
            phi_193_ = _e116;
        } else {
            phi_192_ = array<u32, 2>();
            phi_193_ = true;
        }
        let _e118 = phi_192_;
        let _e120 = phi_193_;
        if _e120 {
            phi_198_ = _e107;
        } else {
            phi_198_ = _e118;
        }
        let _e122 = phi_198_;
        let _e125 = keys.member[_e93];
        let _e127 = sorted.member[_e93];
        let _e129 = (_e122[1] << bitcast<u32>(30u));
        let _e130 = (_e125 & 1073741823u);
        if (_e101 == 1u) {
            let _e217 = survey.member[6u];
            if (_e217 == 0u) {
                phi_250_ = _e127.member_1[0];
            } else {
                if (_e217 == 1u) {
                    phi_249_ = _e127.member_1[1];
                } else {
                    phi_249_ = _e127.member_1[2];
                }
                let _e225 = phi_249_;
                phi_250_ = _e225;
            }
            let _e229 = phi_250_;
            let _e230 = bitcast<u32>(_e229);
            if (_e230 == 2147483648u) {
                phi_256_ = 0u;
            } else {
                phi_256_ = _e230;
            }
            let _e233 = phi_256_;
            let _e235 = bitcast<u32>(bitcast<f32>(_e233));
            if ((_e235 >> bitcast<u32>(31i)) == 1u) {
                phi_266_ = ~(_e235);
            } else {
                phi_266_ = (_e235 | 2147483648u);
            }
            let _e242 = phi_266_;
            phi_368_ = array<u32, 2>(((_e129 | _e130) + _e58), (_e129 | (_e242 >> bitcast<u32>(2i))));
        } else {
            if (_e101 == 2u) {
                let _e134 = (_e104 == 1u);
                if _e134 {
                    phi_279_ = (4u + _e58);
                } else {
                    phi_279_ = _e58;
                }
                let _e137 = phi_279_;
                let _e138 = (_e130 & 1023u);
                let _e145 = (((_e130 >> bitcast<u32>(10u)) & 1023u) + (_e137 % 3u));
                let _e147 = ((_e130 >> bitcast<u32>(20u)) + (_e137 / 3u));
                if (_e145 < 1u) {
                    phi_354_ = array<u32, 2>();
                    phi_355_ = true;
                } else {
                    if (_e147 < 1u) {
                        phi_352_ = array<u32, 2>();
                        phi_353_ = true;
                    } else {
                        if (_e145 > 1024u) {
                            phi_350_ = array<u32, 2>();
                            phi_351_ = true;
                        } else {
                            let _e151 = (_e147 > 1024u);
                            if _e151 {
                                phi_349_ = array<u32, 2>();
                            } else {
                                if (_e138 > 0u) {
                                    if _e134 {
                                        if (_e137 == 4u) {
                                            phi_315_ = false;
                                        } else {
                                            phi_315_ = true;
                                        }
                                        let _e155 = phi_315_;
                                        phi_316_ = _e155;
                                    } else {
                                        phi_316_ = true;
                                    }
                                    let _e157 = phi_316_;
                                    if _e157 {
                                        phi_321_ = (_e138 - 1u);
                                        phi_322_ = false;
                                    } else {
                                        phi_321_ = u32();
                                        phi_322_ = true;
                                    }
                                    let _e160 = phi_321_;
                                    let _e162 = phi_322_;
                                    phi_323_ = _e160;
                                    phi_324_ = _e162;
                                } else {
                                    phi_323_ = u32();
                                    phi_324_ = true;
                                }
                                let _e164 = phi_323_;
                                let _e166 = phi_324_;
                                if _e166 {
                                    phi_328_ = _e138;
                                } else {
                                    phi_328_ = _e164;
                                }
                                let _e168 = phi_328_;
                                if ((_e138 + 1u) < 1024u) {
                                    phi_335_ = (_e138 + 1u);
                                } else {
                                    phi_335_ = _e138;
                                }
                                let _e173 = phi_335_;
                                phi_349_ = array<u32, 2>(((((_e147 - 1u) << bitcast<u32>(20u)) | ((_e145 - 1u) << bitcast<u32>(10u))) | _e168), ((((_e147 - 1u) << bitcast<u32>(20u)) | ((_e145 - 1u) << bitcast<u32>(10u))) | _e173));
                            }
                            let _e192 = phi_349_;
                            phi_350_ = _e192;
                            phi_351_ = _e151;
                        }
                        let _e194 = phi_350_;
                        let _e196 = phi_351_;
                        phi_352_ = _e194;
                        phi_353_ = _e196;
                    }
                    let _e198 = phi_352_;
                    let _e200 = phi_353_;
                    phi_354_ = _e198;
                    phi_355_ = _e200;
                }
                let _e202 = phi_354_;
                let _e204 = phi_355_;
                if _e204 {
                    phi_360_ = array<u32, 2>(1u, 0u);
                } else {
                    phi_360_ = _e202;
                }
                let _e206 = phi_360_;
                phi_367_ = array<u32, 2>((_e129 | _e206[0]), (_e129 | _e206[1]));
            } else {
                phi_367_ = array<u32, 2>(_e129, _e129);
            }
            let _e213 = phi_367_;
            phi_368_ = _e213;
        }
        let _e248 = phi_368_;
        if (_e104 == 1u) {
            phi_376_ = (_e93 + 1u);
        } else {
            phi_376_ = 0u;
        }
        let _e254 = phi_376_;
        phi_379_ = array<u32, 3>(_e248[0], _e248[1], _e254);
    } else {
        phi_379_ = array<u32, 3>(4294967295u, 0u, 0u);
    }
    let _e257 = phi_379_;
    if (_e257[0] <= _e257[1]) {
        let _e262 = atomicMin((&counters[0u]), _e257[0]);
        let _e264 = atomicMax((&counters[1u]), _e257[1]);
    }
    workgroupBarrier();
    let _e268 = params.member.member.member_2[3u];
    let _e270 = atomicLoad((&counters[0u]));
    let _e272 = atomicLoad((&counters[1u]));
    if (_e45 < 2u) {
        if (_e45 == 0u) {
            phi_406_ = _e270;
        } else {
            phi_406_ = (_e272 + 1u);
        }
        let _e277 = phi_406_;
        phi_409_ = type_14(0i, 32i);
        phi_412_ = 0u;
        phi_414_ = _e268;
        loop {
            let _e279 = phi_409_;
            let _e281 = phi_412_;
            let _e283 = phi_414_;
            local = _e281;
            local_1 = _e281;
            local_2 = _e281;
            local_3 = _e281;
            if (_e279.member < _e279.member_1) {
                let _e290 = (_e279.member + 1i);
                if ((false == (_e290 > _e279.member)) != false) {
                    phi_435_ = true;
                } else {
                    phi_435_ = false;
                }
                let _e295 = phi_435_;
                if _e295 {
                    phi_441_ = type_15(0u, type_15().member_1);
                } else {
                    phi_441_ = type_15(1u, _e290);
                }
                let _e300 = phi_441_;
                phi_410_ = type_14(_e300.member_1, _e279.member_1);
                phi_455_ = type_15(1u, _e279.member);
            } else {
                phi_410_ = _e279;
                phi_455_ = type_15(0u, type_15().member_1);
            }
            let _e306 = phi_410_;
            let _e308 = phi_455_;
            if (bitcast<i32>(_e308.member) != 0i) {
                if (_e281 >= _e283) {
                    phi_486_ = u32();
                    phi_487_ = u32();
                    phi_488_ = false;
                } else {
                    let _e315 = (_e281 + ((_e283 - _e281) / 2u));
                    let _e317 = keys.member[_e315];
                    if (_e317 < _e277) {
                        phi_484_ = (_e315 + 1u);
                        phi_485_ = _e283;
                    } else {
                        phi_484_ = _e281;
                        phi_485_ = _e315;
                    }
                    let _e321 = phi_484_;
                    let _e323 = phi_485_;
                    phi_486_ = _e321;
                    phi_487_ = _e323;
                    phi_488_ = true;
                }
                let _e325 = phi_486_;
                let _e327 = phi_487_;
                let _e329 = phi_488_;
                phi_413_ = _e325;
                phi_415_ = _e327;
                phi_489_ = _e329;
            } else {
                phi_413_ = u32();
                phi_415_ = u32();
                phi_489_ = false;
            }
            let _e331 = phi_413_;
            let _e333 = phi_415_;
            let _e335 = phi_489_;
            continue;
            continuing {
                phi_409_ = _e306;
                phi_412_ = _e331;
                phi_414_ = _e333;
                break if !(_e335);
            }
        }
        if (_e45 == 0u) {
            let _e340 = params.member.member_2.member_1;
            if (_e340 == 1u) {
                let _e342 = (_e93 + 1u);
                let _e344 = local;
                if (_e342 < _e344) {
                    let _e518 = local_1;
                    phi_506_ = _e518;
                } else {
                    phi_506_ = _e342;
                }
                let _e347 = phi_506_;
                phi_507_ = _e347;
            } else {
                let _e521 = local_2;
                phi_507_ = _e521;
            }
            let _e349 = phi_507_;
            phi_508_ = _e349;
        } else {
            let _e524 = local_3;
            phi_508_ = _e524;
        }
        let _e351 = phi_508_;
        atomicStore((&counters[(2u + _e45)]), _e351);
    }
    workgroupBarrier();
    let _e355 = atomicLoad((&counters[2u]));
    let _e357 = atomicLoad((&counters[3u]));
    let _e359 = survey.member[9u];
    let _e361 = survey.member[10u];
    let _e364 = params.member.member_2.member_3;
    if (_e361 > _e364[1]) {
        phi_551_ = true;
    } else {
        if (_e361 == _e364[1]) {
            phi_550_ = (_e359 > _e364[0]);
        } else {
            phi_550_ = false;
        }
        let _e372 = phi_550_;
        phi_551_ = _e372;
    }
    let _e374 = phi_551_;
    if (_e355 < _e357) {
        phi_557_ = !(_e374);
    } else {
        phi_557_ = false;
    }
    let _e378 = phi_557_;
    if _e378 {
        let _e379 = (_e357 - _e355);
        let _e380 = (_e379 / 1024u);
        if ((_e379 % 1024u) > 0u) {
            phi_577_ = (_e380 + 1u);
        } else {
            phi_577_ = _e380;
        }
        let _e385 = phi_577_;
        phi_578_ = _e385;
    } else {
        phi_578_ = 0u;
    }
    let _e387 = phi_578_;
    if (_e45 == 0u) {
        if (_e387 > 0u) {
            let _e391 = atomicAdd((&work.member[0u]), _e387);
            if ((_e391 + _e387) < _e391) {
                let _e395 = atomicAdd((&work.member[2u]), 1u);
            }
            atomicStore((&counters[5u]), _e391);
        }
    }
    if (_e45 == 0u) {
        if _e374 {
            let _e399 = atomicMax((&work.member[0u]), 4294967295u);
        }
    }
    workgroupBarrier();
    let _e401 = atomicLoad((&counters[5u]));
    let _e402 = (_e387 / 128u);
    if ((_e387 % 128u) > 0u) {
        phi_627_ = (_e402 + 1u);
    } else {
        phi_627_ = _e402;
    }
    let _e407 = phi_627_;
    phi_630_ = type_9(0u, _e407);
    loop {
        let _e410 = phi_630_;
        if (_e410.member < _e410.member_1) {
            phi_631_ = type_9((_e410.member + 1u), _e410.member_1);
            phi_654_ = type_9(1u, _e410.member);
        } else {
            phi_631_ = _e410;
            phi_654_ = type_9(0u, type_9().member_1);
        }
        let _e422 = phi_631_;
        let _e424 = phi_654_;
        let _e428 = (bitcast<i32>(_e424.member) != 0i);
        if _e428 {
            let _e430 = ((_e424.member_1 * 128u) + _e45);
            if (_e430 < _e387) {
                let _e433 = (_e355 + (_e430 * 1024u));
                let _e434 = (_e357 - _e433);
                if (1024u < _e434) {
                    phi_675_ = 1024u;
                } else {
                    phi_675_ = _e434;
                }
                let _e437 = phi_675_;
                let _e438 = (_e437 / 128u);
                if ((_e437 % 128u) > 0u) {
                    phi_691_ = (_e438 + 1u);
                } else {
                    phi_691_ = _e438;
                }
                let _e443 = phi_691_;
                let _e453 = params.member.member_1.member_3;
                let _e454 = (_e401 + _e430);
                if (_e454 < _e453) {
                    let _e456 = (2u * _e454);
                    atomicStore((&work.member[(4u + _e456)]), (((_e58 << bitcast<u32>(28i)) | ((_e443 - 1u) << bitcast<u32>(24i))) | _e55));
                    atomicStore((&work.member[(_e456 + 5u)]), _e433);
                }
            }
        }
        continue;
        continuing {
            phi_630_ = _e422;
            break if !(_e428);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_work(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
