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
    var phi_133_: array<u32, 2>;
    var phi_145_: array<u32, 2>;
    var phi_146_: bool;
    var phi_147_: array<u32, 2>;
    var phi_148_: bool;
    var phi_153_: array<u32, 2>;
    var phi_191_: array<u32, 2>;
    var phi_203_: array<u32, 2>;
    var phi_204_: bool;
    var phi_205_: array<u32, 2>;
    var phi_206_: bool;
    var phi_211_: array<u32, 2>;
    var phi_298_: u32;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_340_: u32;
    var phi_341_: bool;
    var phi_342_: u32;
    var phi_343_: bool;
    var phi_347_: u32;
    var phi_354_: u32;
    var phi_368_: array<u32, 2>;
    var phi_369_: array<u32, 2>;
    var phi_370_: bool;
    var phi_371_: array<u32, 2>;
    var phi_372_: bool;
    var phi_373_: array<u32, 2>;
    var phi_374_: bool;
    var phi_379_: array<u32, 2>;
    var phi_386_: array<u32, 2>;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_275_: u32;
    var phi_285_: u32;
    var phi_387_: array<u32, 2>;
    var phi_395_: u32;
    var phi_398_: array<u32, 3>;
    var phi_425_: u32;
    var phi_428_: type_14;
    var phi_431_: u32;
    var phi_433_: u32;
    var phi_454_: bool;
    var phi_460_: type_15;
    var phi_429_: type_14;
    var phi_474_: type_15;
    var phi_503_: u32;
    var phi_504_: u32;
    var phi_505_: u32;
    var phi_506_: u32;
    var phi_507_: bool;
    var phi_432_: u32;
    var phi_434_: u32;
    var phi_508_: bool;
    var local: u32;
    var phi_525_: u32;
    var phi_526_: u32;
    var phi_527_: u32;
    var phi_554_: u32;
    var phi_555_: u32;
    var phi_594_: u32;
    var phi_597_: type_9;
    var phi_598_: type_9;
    var phi_621_: type_9;
    var phi_642_: u32;
    var phi_658_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e42 = id_2;
    let _e43 = n_2;
    let _e44 = lane_2;
    let _e54 = ((_e42.y * _e43.x) + _e42.x);
    let _e57 = params.member.member_2.member_2;
    if (_e44 == 0u) {
        atomicStore((&counters[0u]), 4294967295u);
        atomicStore((&counters[1u]), 0u);
    }
    workgroupBarrier();
    let _e63 = params.member.member_2.member;
    let _e66 = params.member.member_2.member_1;
    if (_e66 == 0u) {
        phi_133_ = array<u32, 2>(0u, 2u);
    } else {
        phi_133_ = array<u32, 2>(1u, 1u);
    }
    let _e69 = phi_133_;
    if (_e63 == 1u) {
        if (_e57 == 1u) {
            phi_145_ = array<u32, 2>(_e69[1], _e69[0]);
            phi_146_ = false;
        } else {
            phi_145_ = array<u32, 2>();
            phi_146_ = true;
        }
        let _e76 = phi_145_;
        let _e78 = phi_146_;
        phi_147_ = _e76;
        phi_148_ = _e78;
    } else {
        phi_147_ = array<u32, 2>();
        phi_148_ = true;
    }
    let _e80 = phi_147_;
    let _e82 = phi_148_;
    if _e82 {
        phi_153_ = _e69;
    } else {
        phi_153_ = _e80;
    }
    let _e84 = phi_153_;
    let _e87 = ((_e54 * 128u) + _e44);
    let _e91 = params.member.member.member_2[_e84[0]];
    let _e92 = (_e91 + _e87);
    let _e96 = params.member.member.member[_e84[0]];
    if (_e87 < _e96) {
        let _e100 = params.member.member_2.member;
        let _e103 = params.member.member_2.member_1;
        if (_e103 == 0u) {
            phi_191_ = array<u32, 2>(0u, 2u);
        } else {
            phi_191_ = array<u32, 2>(1u, 1u);
        }
        let _e106 = phi_191_;
        if (_e100 == 1u) {
            if (_e57 == 1u) {
                phi_203_ = array<u32, 2>(_e106[1], _e106[0]);
                phi_204_ = false;
            } else {
                phi_203_ = array<u32, 2>();
                phi_204_ = true;
            }
            let _e113 = phi_203_;
            let _e115 = phi_204_;
            phi_205_ = _e113;
            phi_206_ = _e115;
        } else {
            phi_205_ = array<u32, 2>();
            phi_206_ = true;
        }
        let _e117 = phi_205_;
        let _e119 = phi_206_;
        if _e119 {
            phi_211_ = _e106;
        } else {
            phi_211_ = _e117;
        }
        let _e121 = phi_211_;
        let _e124 = keys.member[_e92];
        let _e126 = sorted.member[_e92];
        let _e128 = (_e121[1] << bitcast<u32>(30u));
        let _e129 = (_e124 & 1073741823u);
        if (_e100 == 1u) {
            let _e216 = survey.member[6u];
            if (_e216 == 0u) {
                phi_269_ = _e126.member_1[0];
            } else {
                if (_e216 == 1u) {
                    phi_268_ = _e126.member_1[1];
                } else {
                    phi_268_ = _e126.member_1[2];
                }
                let _e224 = phi_268_;
                phi_269_ = _e224;
            }
            let _e228 = phi_269_;
            let _e229 = bitcast<u32>(_e228);
            if (_e229 == 2147483648u) {
                phi_275_ = 0u;
            } else {
                phi_275_ = _e229;
            }
            let _e232 = phi_275_;
            let _e234 = bitcast<u32>(bitcast<f32>(_e232));
            if ((_e234 >> bitcast<u32>(31i)) == 1u) {
                phi_285_ = ~(_e234);
            } else {
                phi_285_ = (_e234 | 2147483648u);
            }
            let _e241 = phi_285_;
            phi_387_ = array<u32, 2>(((_e128 | _e129) + _e57), (_e128 | (_e241 >> bitcast<u32>(2i))));
        } else {
            if (_e100 == 2u) {
                let _e133 = (_e103 == 1u);
                if _e133 {
                    phi_298_ = (4u + _e57);
                } else {
                    phi_298_ = _e57;
                }
                let _e136 = phi_298_;
                let _e137 = (_e129 & 1023u);
                let _e144 = (((_e129 >> bitcast<u32>(10u)) & 1023u) + (_e136 % 3u));
                let _e146 = ((_e129 >> bitcast<u32>(20u)) + (_e136 / 3u));
                if (_e144 < 1u) {
                    phi_373_ = array<u32, 2>();
                    phi_374_ = true;
                } else {
                    if (_e146 < 1u) {
                        phi_371_ = array<u32, 2>();
                        phi_372_ = true;
                    } else {
                        if (_e144 > 1024u) {
                            phi_369_ = array<u32, 2>();
                            phi_370_ = true;
                        } else {
                            let _e150 = (_e146 > 1024u);
                            if _e150 {
                                phi_368_ = array<u32, 2>();
                            } else {
                                if (_e137 > 0u) {
                                    if _e133 {
                                        if (_e136 == 4u) {
                                            phi_334_ = false;
                                        } else {
                                            phi_334_ = true;
                                        }
                                        let _e154 = phi_334_;
                                        phi_335_ = _e154;
                                    } else {
                                        phi_335_ = true;
                                    }
                                    let _e156 = phi_335_;
                                    if _e156 {
                                        phi_340_ = (_e137 - 1u);
                                        phi_341_ = false;
                                    } else {
                                        phi_340_ = u32();
                                        phi_341_ = true;
                                    }
                                    let _e159 = phi_340_;
                                    let _e161 = phi_341_;
                                    phi_342_ = _e159;
                                    phi_343_ = _e161;
                                } else {
                                    phi_342_ = u32();
                                    phi_343_ = true;
                                }
                                let _e163 = phi_342_;
                                let _e165 = phi_343_;
                                if _e165 {
                                    phi_347_ = _e137;
                                } else {
                                    phi_347_ = _e163;
                                }
                                let _e167 = phi_347_;
                                if ((_e137 + 1u) < 1024u) {
                                    phi_354_ = (_e137 + 1u);
                                } else {
                                    phi_354_ = _e137;
                                }
                                let _e172 = phi_354_;
                                phi_368_ = array<u32, 2>(((((_e146 - 1u) << bitcast<u32>(20u)) | ((_e144 - 1u) << bitcast<u32>(10u))) | _e167), ((((_e146 - 1u) << bitcast<u32>(20u)) | ((_e144 - 1u) << bitcast<u32>(10u))) | _e172));
                            }
                            let _e191 = phi_368_;
                            phi_369_ = _e191;
                            phi_370_ = _e150;
                        }
                        let _e193 = phi_369_;
                        let _e195 = phi_370_;
                        phi_371_ = _e193;
                        phi_372_ = _e195;
                    }
                    let _e197 = phi_371_;
                    let _e199 = phi_372_;
                    phi_373_ = _e197;
                    phi_374_ = _e199;
                }
                let _e201 = phi_373_;
                let _e203 = phi_374_;
                if _e203 {
                    phi_379_ = array<u32, 2>(1u, 0u);
                } else {
                    phi_379_ = _e201;
                }
                let _e205 = phi_379_;
                phi_386_ = array<u32, 2>((_e128 | _e205[0]), (_e128 | _e205[1]));
            } else {
                phi_386_ = array<u32, 2>(_e128, _e128);
            }
            let _e212 = phi_386_;
            phi_387_ = _e212;
        }
        let _e247 = phi_387_;
        if (_e103 == 1u) {
            phi_395_ = (_e92 + 1u);
        } else {
            phi_395_ = 0u;
        }
        let _e253 = phi_395_;
        phi_398_ = array<u32, 3>(_e247[0], _e247[1], _e253);
    } else {
        phi_398_ = array<u32, 3>(4294967295u, 0u, 0u);
    }
    let _e256 = phi_398_;
    if (_e256[0] <= _e256[1]) {
        let _e261 = atomicMin((&counters[0u]), _e256[0]);
        let _e263 = atomicMax((&counters[1u]), _e256[1]);
    }
    workgroupBarrier();
    let _e267 = params.member.member.member_2[3u];
    let _e269 = atomicLoad((&counters[0u]));
    let _e271 = atomicLoad((&counters[1u]));
    if (_e44 < 2u) {
        if (_e44 == 0u) {
            phi_425_ = _e269;
        } else {
            phi_425_ = (_e271 + 1u);
        }
        let _e276 = phi_425_;
        phi_428_ = type_14(0i, 32i);
        phi_431_ = 0u;
        phi_433_ = _e267;
        loop {
            let _e278 = phi_428_;
            let _e280 = phi_431_;
            let _e282 = phi_433_;
            local = _e280;
            local_1 = _e280;
            local_2 = _e280;
            local_3 = _e280;
            if (_e278.member < _e278.member_1) {
                let _e289 = (_e278.member + 1i);
                if ((false == (_e289 > _e278.member)) != false) {
                    phi_454_ = true;
                } else {
                    phi_454_ = false;
                }
                let _e294 = phi_454_;
                if _e294 {
                    phi_460_ = type_15(0u, type_15().member_1);
                } else {
                    phi_460_ = type_15(1u, _e289);
                }
                let _e299 = phi_460_;
                phi_429_ = type_14(_e299.member_1, _e278.member_1);
                phi_474_ = type_15(1u, _e278.member);
            } else {
                phi_429_ = _e278;
                phi_474_ = type_15(0u, type_15().member_1);
            }
            let _e305 = phi_429_;
            let _e307 = phi_474_;
            if (bitcast<i32>(_e307.member) != 0i) {
                if (_e280 >= _e282) {
                    phi_505_ = u32();
                    phi_506_ = u32();
                    phi_507_ = false;
                } else {
                    let _e314 = (_e280 + ((_e282 - _e280) / 2u));
                    let _e316 = keys.member[_e314];
                    if (_e316 < _e276) {
                        phi_503_ = (_e314 + 1u);
                        phi_504_ = _e282;
                    } else {
                        phi_503_ = _e280;
                        phi_504_ = _e314;
                    }
                    let _e320 = phi_503_;
                    let _e322 = phi_504_;
                    phi_505_ = _e320;
                    phi_506_ = _e322;
                    phi_507_ = true;
                }
                let _e324 = phi_505_;
                let _e326 = phi_506_;
                let _e328 = phi_507_;
                phi_432_ = _e324;
                phi_434_ = _e326;
                phi_508_ = _e328;
            } else {
                phi_432_ = u32();
                phi_434_ = u32();
                phi_508_ = false;
            }
            let _e330 = phi_432_;
            let _e332 = phi_434_;
            let _e334 = phi_508_;
            continue;
            continuing {
                phi_428_ = _e305;
                phi_431_ = _e330;
                phi_433_ = _e332;
                break if !(_e334);
            }
        }
        if (_e44 == 0u) {
            let _e339 = params.member.member_2.member_1;
            if (_e339 == 1u) {
                let _e341 = (_e92 + 1u);
                let _e343 = local;
                if (_e341 < _e343) {
                    let _e494 = local_1;
                    phi_525_ = _e494;
                } else {
                    phi_525_ = _e341;
                }
                let _e346 = phi_525_;
                phi_526_ = _e346;
            } else {
                let _e497 = local_2;
                phi_526_ = _e497;
            }
            let _e348 = phi_526_;
            phi_527_ = _e348;
        } else {
            let _e500 = local_3;
            phi_527_ = _e500;
        }
        let _e350 = phi_527_;
        atomicStore((&counters[(2u + _e44)]), _e350);
    }
    workgroupBarrier();
    let _e354 = atomicLoad((&counters[2u]));
    let _e356 = atomicLoad((&counters[3u]));
    if (_e354 < _e356) {
        let _e358 = (_e356 - _e354);
        let _e359 = (_e358 / 1024u);
        if ((_e358 % 1024u) > 0u) {
            phi_554_ = (_e359 + 1u);
        } else {
            phi_554_ = _e359;
        }
        let _e364 = phi_554_;
        phi_555_ = _e364;
    } else {
        phi_555_ = 0u;
    }
    let _e366 = phi_555_;
    if (_e44 == 0u) {
        if (_e366 > 0u) {
            let _e370 = atomicAdd((&work.member[0u]), _e366);
            if ((_e370 + _e366) < _e370) {
                let _e374 = atomicAdd((&work.member[2u]), 1u);
            }
            atomicStore((&counters[5u]), _e370);
        }
    }
    workgroupBarrier();
    let _e377 = atomicLoad((&counters[5u]));
    let _e378 = (_e366 / 128u);
    if ((_e366 % 128u) > 0u) {
        phi_594_ = (_e378 + 1u);
    } else {
        phi_594_ = _e378;
    }
    let _e383 = phi_594_;
    phi_597_ = type_9(0u, _e383);
    loop {
        let _e386 = phi_597_;
        if (_e386.member < _e386.member_1) {
            phi_598_ = type_9((_e386.member + 1u), _e386.member_1);
            phi_621_ = type_9(1u, _e386.member);
        } else {
            phi_598_ = _e386;
            phi_621_ = type_9(0u, type_9().member_1);
        }
        let _e398 = phi_598_;
        let _e400 = phi_621_;
        let _e404 = (bitcast<i32>(_e400.member) != 0i);
        if _e404 {
            let _e406 = ((_e400.member_1 * 128u) + _e44);
            if (_e406 < _e366) {
                let _e409 = (_e354 + (_e406 * 1024u));
                let _e410 = (_e356 - _e409);
                if (1024u < _e410) {
                    phi_642_ = 1024u;
                } else {
                    phi_642_ = _e410;
                }
                let _e413 = phi_642_;
                let _e414 = (_e413 / 128u);
                if ((_e413 % 128u) > 0u) {
                    phi_658_ = (_e414 + 1u);
                } else {
                    phi_658_ = _e414;
                }
                let _e419 = phi_658_;
                let _e429 = params.member.member_1.member_3;
                let _e430 = (_e377 + _e406);
                if (_e430 < _e429) {
                    let _e432 = (2u * _e430);
                    atomicStore((&work.member[(4u + _e432)]), (((_e57 << bitcast<u32>(28i)) | ((_e419 - 1u) << bitcast<u32>(24i))) | _e54));
                    atomicStore((&work.member[(_e432 + 5u)]), _e409);
                }
            }
        }
        continue;
        continuing {
            phi_597_ = _e398;
            break if !(_e404);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_work(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
