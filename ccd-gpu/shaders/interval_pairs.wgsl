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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_21 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_22 {
    member: type_7,
    member_1: type_8,
    member_2: type_21,
}

struct type_23 {
    member: type_22,
}

struct type_27 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage> keys: type_11;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_27;
@group(0) @binding(0) 
var<storage> params: type_23;
@group(0) @binding(1) 
var<storage> sorted: type_18;
@group(0) @binding(3) 
var<storage> order: type_11;
@group(0) @binding(4) 
var<storage> survey: type_11;
@group(0) @binding(5) 
var<storage> work: type_11;
var<workgroup> boxes: array<type_16, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_154_: u32;
    var phi_164_: u32;
    var phi_171_: u32;
    var phi_190_: u32;
    var phi_211_: u32;
    var phi_212_: u32;
    var phi_215_: type_9;
    var phi_216_: type_9;
    var phi_239_: type_9;
    var phi_295_: array<u32, 2>;
    var phi_307_: array<u32, 2>;
    var phi_308_: bool;
    var phi_309_: array<u32, 2>;
    var phi_310_: bool;
    var phi_315_: array<u32, 2>;
    var phi_353_: array<u32, 2>;
    var phi_365_: array<u32, 2>;
    var phi_366_: bool;
    var phi_367_: array<u32, 2>;
    var phi_368_: bool;
    var phi_373_: array<u32, 2>;
    var phi_460_: u32;
    var phi_496_: bool;
    var phi_497_: bool;
    var phi_502_: u32;
    var phi_503_: bool;
    var phi_504_: u32;
    var phi_505_: bool;
    var phi_509_: u32;
    var phi_516_: u32;
    var phi_530_: array<u32, 2>;
    var phi_531_: array<u32, 2>;
    var phi_532_: bool;
    var phi_533_: array<u32, 2>;
    var phi_534_: bool;
    var phi_535_: array<u32, 2>;
    var phi_536_: bool;
    var phi_541_: array<u32, 2>;
    var phi_548_: array<u32, 2>;
    var phi_430_: f32;
    var phi_431_: f32;
    var phi_437_: u32;
    var phi_447_: u32;
    var phi_549_: array<u32, 2>;
    var phi_557_: u32;
    var phi_560_: array<u32, 3>;
    var phi_577_: type_16;
    var phi_580_: type_9;
    var phi_581_: type_9;
    var phi_604_: type_9;
    var phi_639_: type_16;
    var phi_640_: u32;
    var phi_661_: type_9;
    var phi_662_: type_9;
    var phi_685_: type_9;
    var phi_818_: type_9;
    var phi_819_: bool;
    var phi_820_: type_9;
    var phi_821_: bool;
    var phi_830_: type_9;
    var phi_798_: type_9;
    var phi_831_: type_9;
    var phi_866_: u32;
    var phi_892_: type_9;
    var phi_893_: type_9;
    var phi_916_: type_9;
    var phi_947_: array<u32, 2>;
    var phi_959_: array<u32, 2>;
    var phi_960_: bool;
    var phi_961_: array<u32, 2>;
    var phi_962_: bool;
    var phi_967_: array<u32, 2>;
    var phi_1050_: type_9;
    var phi_1051_: bool;
    var phi_1052_: type_9;
    var phi_1053_: bool;
    var phi_1062_: type_9;
    var phi_1030_: type_9;
    var phi_1063_: type_9;
    var phi_1081_: bool;
    var phi_1082_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e51 = id_2;
    let _e52 = n_2;
    let _e53 = lane_2;
    let _e65 = ((_e51.y * _e52.x) + _e51.x);
    let _e68 = (_e52.x * _e52.y);
    let _e71 = params.member.member_1.member_2;
    let _e73 = work.member[0u];
    if (_e71 < _e73) {
        phi_154_ = _e71;
    } else {
        phi_154_ = _e73;
    }
    let _e76 = phi_154_;
    let _e78 = params.member.member_1.member_1;
    if (_e76 > _e78) {
        let _e81 = params.member.member_1.member_1;
        phi_164_ = (_e76 - _e81);
    } else {
        phi_164_ = 0u;
    }
    let _e84 = phi_164_;
    let _e86 = params.member.member_1.member;
    if (_e86 < _e84) {
        phi_171_ = _e86;
    } else {
        phi_171_ = _e84;
    }
    let _e89 = phi_171_;
    let _e93 = params.member.member.member_2[3u];
    if false {
        phi_190_ = (_e89 + 1u);
    } else {
        phi_190_ = _e89;
    }
    let _e96 = phi_190_;
    if (_e96 > _e65) {
        let _e98 = (_e96 - _e65);
        if (_e68 == 0u) {
            return;
        }
        let _e100 = (_e98 / _e68);
        if (_e68 == 0u) {
            return;
        }
        if ((_e98 % _e68) > 0u) {
            phi_211_ = (_e100 + 1u);
        } else {
            phi_211_ = _e100;
        }
        let _e106 = phi_211_;
        phi_212_ = _e106;
    } else {
        phi_212_ = 0u;
    }
    let _e108 = phi_212_;
    phi_215_ = type_9(0u, _e108);
    loop {
        let _e111 = phi_215_;
        if (_e111.member < _e111.member_1) {
            phi_216_ = type_9((_e111.member + 1u), _e111.member_1);
            phi_239_ = type_9(1u, _e111.member);
        } else {
            phi_216_ = _e111;
            phi_239_ = type_9(0u, type_9().member_1);
        }
        let _e123 = phi_216_;
        let _e125 = phi_239_;
        let _e129 = (bitcast<i32>(_e125.member) != 0i);
        if _e129 {
            let _e132 = params.member.member_1.member_1;
            let _e136 = (2u * ((_e132 + _e65) + (_e125.member_1 * _e68)));
            let _e139 = work.member[(4u + _e136)];
            let _e142 = work.member[(_e136 + 5u)];
            let _e144 = (_e139 >> bitcast<u32>(28i));
            let _e149 = (_e139 & 16777215u);
            let _e152 = params.member.member_2.member;
            let _e155 = params.member.member_2.member_1;
            if (_e155 == 0u) {
                phi_295_ = array<u32, 2>(0u, 2u);
            } else {
                phi_295_ = array<u32, 2>(1u, 1u);
            }
            let _e158 = phi_295_;
            if (_e152 == 1u) {
                if (_e144 == 1u) {
                    phi_307_ = array<u32, 2>(_e158[1], _e158[0]);
                    phi_308_ = false;
                } else {
                    phi_307_ = array<u32, 2>();
                    phi_308_ = true;
                }
                let _e165 = phi_307_;
                let _e167 = phi_308_;
                phi_309_ = _e165;
                phi_310_ = _e167;
            } else {
                phi_309_ = array<u32, 2>();
                phi_310_ = true;
            }
            let _e169 = phi_309_;
            let _e171 = phi_310_;
            if _e171 {
                phi_315_ = _e158;
            } else {
                phi_315_ = _e169;
            }
            let _e173 = phi_315_;
            let _e176 = ((_e149 * 128u) + _e53);
            let _e180 = params.member.member.member_2[_e173[0]];
            let _e181 = (_e180 + _e176);
            let _e185 = params.member.member.member[_e173[0]];
            let _e186 = (_e176 < _e185);
            if _e186 {
                let _e189 = params.member.member_2.member;
                let _e192 = params.member.member_2.member_1;
                if (_e192 == 0u) {
                    phi_353_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_353_ = array<u32, 2>(1u, 1u);
                }
                let _e195 = phi_353_;
                if (_e189 == 1u) {
                    if (_e144 == 1u) {
                        phi_365_ = array<u32, 2>(_e195[1], _e195[0]);
                        phi_366_ = false;
                    } else {
                        phi_365_ = array<u32, 2>();
                        phi_366_ = true;
                    }
                    let _e202 = phi_365_;
                    let _e204 = phi_366_;
                    phi_367_ = _e202;
                    phi_368_ = _e204;
                } else {
                    phi_367_ = array<u32, 2>();
                    phi_368_ = true;
                }
                let _e206 = phi_367_;
                let _e208 = phi_368_;
                if _e208 {
                    phi_373_ = _e195;
                } else {
                    phi_373_ = _e206;
                }
                let _e210 = phi_373_;
                let _e213 = keys.member[_e181];
                let _e215 = sorted.member[_e181];
                let _e217 = (_e210[1] << bitcast<u32>(30u));
                let _e218 = (_e213 & 1073741823u);
                if (_e189 == 1u) {
                    let _e305 = survey.member[6u];
                    if (_e305 == 0u) {
                        phi_431_ = _e215.member_1[0];
                    } else {
                        if (_e305 == 1u) {
                            phi_430_ = _e215.member_1[1];
                        } else {
                            phi_430_ = _e215.member_1[2];
                        }
                        let _e313 = phi_430_;
                        phi_431_ = _e313;
                    }
                    let _e317 = phi_431_;
                    let _e318 = bitcast<u32>(_e317);
                    if (_e318 == 2147483648u) {
                        phi_437_ = 0u;
                    } else {
                        phi_437_ = _e318;
                    }
                    let _e321 = phi_437_;
                    let _e323 = bitcast<u32>(bitcast<f32>(_e321));
                    if ((_e323 >> bitcast<u32>(31i)) == 1u) {
                        phi_447_ = ~(_e323);
                    } else {
                        phi_447_ = (_e323 | 2147483648u);
                    }
                    let _e330 = phi_447_;
                    phi_549_ = array<u32, 2>(((_e217 | _e218) + _e144), (_e217 | (_e330 >> bitcast<u32>(2i))));
                } else {
                    if (_e189 == 2u) {
                        let _e222 = (_e192 == 1u);
                        if _e222 {
                            phi_460_ = (4u + _e144);
                        } else {
                            phi_460_ = _e144;
                        }
                        let _e225 = phi_460_;
                        let _e226 = (_e218 & 1023u);
                        let _e233 = (((_e218 >> bitcast<u32>(10u)) & 1023u) + (_e225 % 3u));
                        let _e235 = ((_e218 >> bitcast<u32>(20u)) + (_e225 / 3u));
                        if (_e233 < 1u) {
                            phi_535_ = array<u32, 2>();
                            phi_536_ = true;
                        } else {
                            if (_e235 < 1u) {
                                phi_533_ = array<u32, 2>();
                                phi_534_ = true;
                            } else {
                                if (_e233 > 1024u) {
                                    phi_531_ = array<u32, 2>();
                                    phi_532_ = true;
                                } else {
                                    let _e239 = (_e235 > 1024u);
                                    if _e239 {
                                        phi_530_ = array<u32, 2>();
                                    } else {
                                        if (_e226 > 0u) {
                                            if _e222 {
                                                if (_e225 == 4u) {
                                                    phi_496_ = false;
                                                } else {
                                                    phi_496_ = true;
                                                }
                                                let _e243 = phi_496_;
                                                phi_497_ = _e243;
                                            } else {
                                                phi_497_ = true;
                                            }
                                            let _e245 = phi_497_;
                                            if _e245 {
                                                phi_502_ = (_e226 - 1u);
                                                phi_503_ = false;
                                            } else {
                                                phi_502_ = u32();
                                                phi_503_ = true;
                                            }
                                            let _e248 = phi_502_;
                                            let _e250 = phi_503_;
                                            phi_504_ = _e248;
                                            phi_505_ = _e250;
                                        } else {
                                            phi_504_ = u32();
                                            phi_505_ = true;
                                        }
                                        let _e252 = phi_504_;
                                        let _e254 = phi_505_;
                                        if _e254 {
                                            phi_509_ = _e226;
                                        } else {
                                            phi_509_ = _e252;
                                        }
                                        let _e256 = phi_509_;
                                        if ((_e226 + 1u) < 1024u) {
                                            phi_516_ = (_e226 + 1u);
                                        } else {
                                            phi_516_ = _e226;
                                        }
                                        let _e261 = phi_516_;
                                        phi_530_ = array<u32, 2>(((((_e235 - 1u) << bitcast<u32>(20u)) | ((_e233 - 1u) << bitcast<u32>(10u))) | _e256), ((((_e235 - 1u) << bitcast<u32>(20u)) | ((_e233 - 1u) << bitcast<u32>(10u))) | _e261));
                                    }
                                    let _e280 = phi_530_;
                                    phi_531_ = _e280;
                                    phi_532_ = _e239;
                                }
                                let _e282 = phi_531_;
                                let _e284 = phi_532_;
                                phi_533_ = _e282;
                                phi_534_ = _e284;
                            }
                            let _e286 = phi_533_;
                            let _e288 = phi_534_;
                            phi_535_ = _e286;
                            phi_536_ = _e288;
                        }
                        let _e290 = phi_535_;
                        let _e292 = phi_536_;
                        if _e292 {
                            phi_541_ = array<u32, 2>(1u, 0u);
                        } else {
                            phi_541_ = _e290;
                        }
                        let _e294 = phi_541_;
                        phi_548_ = array<u32, 2>((_e217 | _e294[0]), (_e217 | _e294[1]));
                    } else {
                        phi_548_ = array<u32, 2>(_e217, _e217);
                    }
                    let _e301 = phi_548_;
                    phi_549_ = _e301;
                }
                let _e336 = phi_549_;
                if (_e192 == 1u) {
                    phi_557_ = (_e181 + 1u);
                } else {
                    phi_557_ = 0u;
                }
                let _e342 = phi_557_;
                phi_560_ = array<u32, 3>(_e336[0], _e336[1], _e342);
            } else {
                phi_560_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e345 = phi_560_;
            if _e186 {
                let _e350 = sorted.member[_e181];
                phi_577_ = _e350;
            } else {
                phi_577_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e352 = phi_577_;
            phi_580_ = type_9(0u, (((_e139 >> bitcast<u32>(24i)) & 15u) + 1u));
            loop {
                let _e355 = phi_580_;
                if (_e355.member < _e355.member_1) {
                    phi_581_ = type_9((_e355.member + 1u), _e355.member_1);
                    phi_604_ = type_9(1u, _e355.member);
                } else {
                    phi_581_ = _e355;
                    phi_604_ = type_9(0u, type_9().member_1);
                }
                let _e367 = phi_581_;
                let _e369 = phi_604_;
                let _e373 = (bitcast<i32>(_e369.member) != 0i);
                if _e373 {
                    let _e375 = (_e142 + (_e369.member_1 * 128u));
                    let _e376 = (_e375 + _e53);
                    if (_e376 < _e93) {
                        let _e379 = keys.member[_e376];
                        let _e381 = sorted.member[_e376];
                        phi_639_ = _e381;
                        phi_640_ = _e379;
                    } else {
                        phi_639_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_640_ = 4294967295u;
                    }
                    let _e383 = phi_639_;
                    let _e385 = phi_640_;
                    names[_e53] = _e385;
                    boxes[_e53] = type_16(array<f32, 3>(_e383.member[0], _e383.member[1], _e383.member[2]), array<f32, 3>(_e383.member_1[0], _e383.member_1[1], _e383.member_1[2]));
                    if (_e53 == 0u) {
                        atomicStore((&counters[4u]), 0u);
                    }
                    workgroupBarrier();
                    phi_661_ = type_9(0u, 128u);
                    loop {
                        let _e402 = phi_661_;
                        if (_e402.member < _e402.member_1) {
                            phi_662_ = type_9((_e402.member + 1u), _e402.member_1);
                            phi_685_ = type_9(1u, _e402.member);
                        } else {
                            phi_662_ = _e402;
                            phi_685_ = type_9(0u, type_9().member_1);
                        }
                        let _e414 = phi_662_;
                        let _e416 = phi_685_;
                        let _e420 = (bitcast<i32>(_e416.member) != 0i);
                        if _e420 {
                            let _e422 = names[_e416.member_1];
                            if (_e422 >= _e345[0]) {
                                if (_e422 <= _e345[1]) {
                                    if ((_e375 + _e416.member_1) >= _e345[2]) {
                                        let _e428 = boxes[_e416.member_1];
                                        if ((((((_e352.member[0] <= _e428.member_1[0]) && (_e428.member[0] <= _e352.member_1[0])) && (_e352.member[1] <= _e428.member_1[1])) && (_e428.member[1] <= _e352.member_1[1])) && (_e352.member[2] <= _e428.member_1[2])) && (_e428.member[2] <= _e352.member_1[2])) {
                                            let _e461 = atomicAdd((&counters[4u]), 1u);
                                            if (_e461 < 2048u) {
                                                hits[_e461] = ((_e53 << bitcast<u32>(7i)) | _e416.member_1);
                                            } else {
                                                let _e465 = order.member[_e181];
                                                let _e467 = order.member[(_e375 + _e416.member_1)];
                                                let _e470 = params.member.member_2.member_1;
                                                if (_e470 == 1u) {
                                                    let _e502 = params.member.member.member_2[1u];
                                                    let _e503 = (_e465 - _e502);
                                                    let _e507 = params.member.member.member_2[1u];
                                                    let _e508 = (_e467 - _e507);
                                                    if (_e503 < _e508) {
                                                        phi_798_ = type_9(_e503, _e508);
                                                    } else {
                                                        phi_798_ = type_9(_e508, _e503);
                                                    }
                                                    let _e513 = phi_798_;
                                                    phi_831_ = _e513;
                                                } else {
                                                    let _e474 = params.member.member_2.member;
                                                    if (_e474 == 1u) {
                                                        if (_e144 == 1u) {
                                                            let _e480 = params.member.member.member_2[2u];
                                                            phi_818_ = type_9(_e467, (_e465 - _e480));
                                                            phi_819_ = false;
                                                        } else {
                                                            phi_818_ = type_9();
                                                            phi_819_ = true;
                                                        }
                                                        let _e484 = phi_818_;
                                                        let _e486 = phi_819_;
                                                        phi_820_ = _e484;
                                                        phi_821_ = _e486;
                                                    } else {
                                                        phi_820_ = type_9();
                                                        phi_821_ = true;
                                                    }
                                                    let _e488 = phi_820_;
                                                    let _e490 = phi_821_;
                                                    if _e490 {
                                                        let _e494 = params.member.member.member_2[2u];
                                                        phi_830_ = type_9(_e465, (_e467 - _e494));
                                                    } else {
                                                        phi_830_ = _e488;
                                                    }
                                                    let _e498 = phi_830_;
                                                    phi_831_ = _e498;
                                                }
                                                let _e515 = phi_831_;
                                                let _e520 = params.member.member_1.member_3;
                                                let _e522 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e522 + 1u) < _e522) {
                                                    let _e526 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e522 < _e520) {
                                                    let _e528 = (2u * _e522);
                                                    atomicStore((&pairs.member[(4u + _e528)]), _e515.member);
                                                    atomicStore((&pairs.member[(_e528 + 5u)]), _e515.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_661_ = _e414;
                            break if !(_e420);
                        }
                    }
                    workgroupBarrier();
                    let _e539 = atomicLoad((&counters[4u]));
                    if (2048u < _e539) {
                        phi_866_ = 2048u;
                    } else {
                        phi_866_ = _e539;
                    }
                    let _e542 = phi_866_;
                    if (_e53 == 0u) {
                        if (_e542 > 0u) {
                            let _e546 = atomicAdd((&pairs.member[0u]), _e542);
                            if ((_e546 + _e542) < _e546) {
                                let _e550 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[5u]), _e546);
                        }
                    }
                    workgroupBarrier();
                    let _e553 = atomicLoad((&counters[5u]));
                    phi_892_ = type_9(0u, 16u);
                    loop {
                        let _e555 = phi_892_;
                        if (_e555.member < _e555.member_1) {
                            phi_893_ = type_9((_e555.member + 1u), _e555.member_1);
                            phi_916_ = type_9(1u, _e555.member);
                        } else {
                            phi_893_ = _e555;
                            phi_916_ = type_9(0u, type_9().member_1);
                        }
                        let _e567 = phi_893_;
                        let _e569 = phi_916_;
                        if (bitcast<i32>(_e569.member) != 0i) {
                            let _e575 = ((_e569.member_1 * 128u) + _e53);
                            if (_e575 >= _e542) {
                                phi_1081_ = false;
                            } else {
                                let _e578 = hits[_e575];
                                let _e583 = params.member.member_2.member;
                                let _e586 = params.member.member_2.member_1;
                                if (_e586 == 0u) {
                                    phi_947_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_947_ = array<u32, 2>(1u, 1u);
                                }
                                let _e589 = phi_947_;
                                if (_e583 == 1u) {
                                    if (_e144 == 1u) {
                                        phi_959_ = array<u32, 2>(_e589[1], _e589[0]);
                                        phi_960_ = false;
                                    } else {
                                        phi_959_ = array<u32, 2>();
                                        phi_960_ = true;
                                    }
                                    let _e596 = phi_959_;
                                    let _e598 = phi_960_;
                                    phi_961_ = _e596;
                                    phi_962_ = _e598;
                                } else {
                                    phi_961_ = array<u32, 2>();
                                    phi_962_ = true;
                                }
                                let _e600 = phi_961_;
                                let _e602 = phi_962_;
                                if _e602 {
                                    phi_967_ = _e589;
                                } else {
                                    phi_967_ = _e600;
                                }
                                let _e604 = phi_967_;
                                let _e611 = params.member.member.member_2[_e604[0]];
                                let _e616 = order.member[(_e611 + ((_e149 * 128u) + (_e578 >> bitcast<u32>(7i))))];
                                let _e618 = order.member[(_e375 + (_e578 % 128u))];
                                let _e621 = params.member.member_2.member_1;
                                if (_e621 == 1u) {
                                    let _e653 = params.member.member.member_2[1u];
                                    let _e654 = (_e616 - _e653);
                                    let _e658 = params.member.member.member_2[1u];
                                    let _e659 = (_e618 - _e658);
                                    if (_e654 < _e659) {
                                        phi_1030_ = type_9(_e654, _e659);
                                    } else {
                                        phi_1030_ = type_9(_e659, _e654);
                                    }
                                    let _e664 = phi_1030_;
                                    phi_1063_ = _e664;
                                } else {
                                    let _e625 = params.member.member_2.member;
                                    if (_e625 == 1u) {
                                        if (_e144 == 1u) {
                                            let _e631 = params.member.member.member_2[2u];
                                            phi_1050_ = type_9(_e618, (_e616 - _e631));
                                            phi_1051_ = false;
                                        } else {
                                            phi_1050_ = type_9();
                                            phi_1051_ = true;
                                        }
                                        let _e635 = phi_1050_;
                                        let _e637 = phi_1051_;
                                        phi_1052_ = _e635;
                                        phi_1053_ = _e637;
                                    } else {
                                        phi_1052_ = type_9();
                                        phi_1053_ = true;
                                    }
                                    let _e639 = phi_1052_;
                                    let _e641 = phi_1053_;
                                    if _e641 {
                                        let _e645 = params.member.member.member_2[2u];
                                        phi_1062_ = type_9(_e616, (_e618 - _e645));
                                    } else {
                                        phi_1062_ = _e639;
                                    }
                                    let _e649 = phi_1062_;
                                    phi_1063_ = _e649;
                                }
                                let _e666 = phi_1063_;
                                let _e671 = params.member.member_1.member_3;
                                let _e672 = (_e553 + _e575);
                                if (_e672 < _e671) {
                                    let _e674 = (2u * _e672);
                                    atomicStore((&pairs.member[(4u + _e674)]), _e666.member);
                                    atomicStore((&pairs.member[(_e674 + 5u)]), _e666.member_1);
                                }
                                phi_1081_ = true;
                            }
                            let _e680 = phi_1081_;
                            phi_1082_ = _e680;
                        } else {
                            phi_1082_ = false;
                        }
                        let _e682 = phi_1082_;
                        continue;
                        continuing {
                            phi_892_ = _e567;
                            break if !(_e682);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_580_ = _e367;
                    break if !(_e373);
                }
            }
        }
        continue;
        continuing {
            phi_215_ = _e123;
            break if !(_e129);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
