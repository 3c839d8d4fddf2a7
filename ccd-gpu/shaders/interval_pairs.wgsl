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
    member_3: array<u32, 2>,
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
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> names: array<u32, 128>;
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
    var phi_145_: u32;
    var phi_157_: u32;
    var phi_193_: bool;
    var phi_194_: bool;
    var phi_205_: u32;
    var phi_206_: u32;
    var phi_225_: u32;
    var phi_246_: u32;
    var phi_247_: u32;
    var phi_250_: type_9;
    var phi_251_: type_9;
    var phi_274_: type_9;
    var phi_328_: array<u32, 2>;
    var phi_340_: array<u32, 2>;
    var phi_341_: bool;
    var phi_342_: array<u32, 2>;
    var phi_343_: bool;
    var phi_348_: array<u32, 2>;
    var phi_384_: array<u32, 2>;
    var phi_396_: array<u32, 2>;
    var phi_397_: bool;
    var phi_398_: array<u32, 2>;
    var phi_399_: bool;
    var phi_404_: array<u32, 2>;
    var phi_485_: u32;
    var phi_521_: bool;
    var phi_522_: bool;
    var phi_527_: u32;
    var phi_528_: bool;
    var phi_529_: u32;
    var phi_530_: bool;
    var phi_534_: u32;
    var phi_541_: u32;
    var phi_555_: array<u32, 2>;
    var phi_556_: array<u32, 2>;
    var phi_557_: bool;
    var phi_558_: array<u32, 2>;
    var phi_559_: bool;
    var phi_560_: array<u32, 2>;
    var phi_561_: bool;
    var phi_566_: array<u32, 2>;
    var phi_573_: array<u32, 2>;
    var phi_455_: f32;
    var phi_456_: f32;
    var phi_462_: u32;
    var phi_472_: u32;
    var phi_574_: array<u32, 2>;
    var phi_582_: u32;
    var phi_585_: array<u32, 3>;
    var phi_602_: type_16;
    var phi_605_: type_9;
    var phi_606_: type_9;
    var phi_629_: type_9;
    var phi_664_: type_16;
    var phi_665_: u32;
    var phi_686_: type_9;
    var phi_687_: type_9;
    var phi_710_: type_9;
    var phi_843_: type_9;
    var phi_844_: bool;
    var phi_845_: type_9;
    var phi_846_: bool;
    var phi_855_: type_9;
    var phi_823_: type_9;
    var phi_856_: type_9;
    var phi_891_: u32;
    var phi_917_: type_9;
    var phi_918_: type_9;
    var phi_941_: type_9;
    var phi_970_: array<u32, 2>;
    var phi_982_: array<u32, 2>;
    var phi_983_: bool;
    var phi_984_: array<u32, 2>;
    var phi_985_: bool;
    var phi_990_: array<u32, 2>;
    var phi_1073_: type_9;
    var phi_1074_: bool;
    var phi_1075_: type_9;
    var phi_1076_: bool;
    var phi_1085_: type_9;
    var phi_1053_: type_9;
    var phi_1086_: type_9;
    var phi_1104_: bool;
    var phi_1105_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e52 = id_2;
    let _e53 = n_2;
    let _e54 = lane_2;
    let _e66 = ((_e52.y * _e53.x) + _e52.x);
    let _e69 = (_e53.x * _e53.y);
    let _e72 = params.member.member_1.member_2;
    let _e74 = work.member[0u];
    if (_e72 < _e74) {
        phi_145_ = _e72;
    } else {
        phi_145_ = _e74;
    }
    let _e77 = phi_145_;
    let _e80 = params.member.member_1.member_1;
    if (_e77 > _e80) {
        let _e84 = params.member.member_1.member_1;
        phi_157_ = (_e77 - _e84);
    } else {
        phi_157_ = 0u;
    }
    let _e87 = phi_157_;
    let _e89 = survey.member[9u];
    let _e91 = survey.member[10u];
    let _e94 = params.member.member_2.member_3;
    if (_e91 > _e94[1]) {
        phi_194_ = true;
    } else {
        if (_e91 == _e94[1]) {
            phi_193_ = (_e89 > _e94[0]);
        } else {
            phi_193_ = false;
        }
        let _e102 = phi_193_;
        phi_194_ = _e102;
    }
    let _e104 = phi_194_;
    if _e104 {
        phi_206_ = 0u;
    } else {
        let _e107 = params.member.member_1.member;
        if (_e107 < _e87) {
            phi_205_ = _e107;
        } else {
            phi_205_ = _e87;
        }
        let _e110 = phi_205_;
        phi_206_ = _e110;
    }
    let _e112 = phi_206_;
    let _e116 = params.member.member.member_2[3u];
    if false {
        phi_225_ = (_e112 + 1u);
    } else {
        phi_225_ = _e112;
    }
    let _e119 = phi_225_;
    if (_e119 > _e66) {
        let _e121 = (_e119 - _e66);
        if (_e69 == 0u) {
            return;
        }
        let _e123 = (_e121 / _e69);
        if (_e69 == 0u) {
            return;
        }
        if ((_e121 % _e69) > 0u) {
            phi_246_ = (_e123 + 1u);
        } else {
            phi_246_ = _e123;
        }
        let _e129 = phi_246_;
        phi_247_ = _e129;
    } else {
        phi_247_ = 0u;
    }
    let _e131 = phi_247_;
    phi_250_ = type_9(0u, _e131);
    loop {
        let _e134 = phi_250_;
        if (_e134.member < _e134.member_1) {
            phi_251_ = type_9((_e134.member + 1u), _e134.member_1);
            phi_274_ = type_9(1u, _e134.member);
        } else {
            phi_251_ = _e134;
            phi_274_ = type_9(0u, type_9().member_1);
        }
        let _e146 = phi_251_;
        let _e148 = phi_274_;
        let _e152 = (bitcast<i32>(_e148.member) != 0i);
        if _e152 {
            let _e155 = params.member.member_1.member_1;
            let _e159 = (2u * ((_e155 + _e66) + (_e148.member_1 * _e69)));
            let _e162 = work.member[(4u + _e159)];
            let _e165 = work.member[(_e159 + 5u)];
            let _e167 = (_e162 >> bitcast<u32>(28i));
            let _e172 = (_e162 & 16777215u);
            let _e175 = params.member.member_2.member;
            let _e178 = params.member.member_2.member_1;
            if (_e178 == 0u) {
                phi_328_ = array<u32, 2>(0u, 2u);
            } else {
                phi_328_ = array<u32, 2>(1u, 1u);
            }
            let _e181 = phi_328_;
            if (_e175 == 1u) {
                if (_e167 == 1u) {
                    phi_340_ = array<u32, 2>(_e181[1], _e181[0]);
                    phi_341_ = false;
                } else {
                    phi_340_ = array<u32, 2>();
                    phi_341_ = true;
                }
                let _e188 = phi_340_;
                let _e190 = phi_341_;
                phi_342_ = _e188;
                phi_343_ = _e190;
            } else {
                phi_342_ = array<u32, 2>();
                phi_343_ = true;
            }
            let _e192 = phi_342_;
            let _e194 = phi_343_;
            if _e194 {
                phi_348_ = _e181;
            } else {
                phi_348_ = _e192;
            }
            let _e196 = phi_348_;
            let _e199 = ((_e172 * 128u) + _e54);
            let _e203 = params.member.member.member_2[_e196[0]];
            let _e204 = (_e203 + _e199);
            let _e208 = params.member.member.member[_e196[0]];
            let _e209 = (_e199 < _e208);
            if _e209 {
                let _e212 = params.member.member_2.member;
                let _e215 = params.member.member_2.member_1;
                if (_e215 == 0u) {
                    phi_384_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_384_ = array<u32, 2>(1u, 1u);
                }
                let _e218 = phi_384_;
                if (_e212 == 1u) {
                    if (_e167 == 1u) {
                        phi_396_ = array<u32, 2>(_e218[1], _e218[0]);
                        phi_397_ = false;
                    } else {
                        phi_396_ = array<u32, 2>();
                        phi_397_ = true;
                    }
                    let _e225 = phi_396_;
                    let _e227 = phi_397_;
                    phi_398_ = _e225;
                    phi_399_ = _e227;
                } else {
                    phi_398_ = array<u32, 2>();
                    phi_399_ = true;
                }
                let _e229 = phi_398_;
                let _e231 = phi_399_;
                if _e231 {
                    phi_404_ = _e218;
                } else {
                    phi_404_ = _e229;
                }
                let _e233 = phi_404_;
                let _e236 = keys.member[_e204];
                let _e238 = sorted.member[_e204];
                let _e240 = (_e233[1] << bitcast<u32>(30u));
                let _e241 = (_e236 & 1073741823u);
                if (_e212 == 1u) {
                    let _e328 = survey.member[6u];
                    if (_e328 == 0u) {
                        phi_456_ = _e238.member_1[0];
                    } else {
                        if (_e328 == 1u) {
                            phi_455_ = _e238.member_1[1];
                        } else {
                            phi_455_ = _e238.member_1[2];
                        }
                        let _e336 = phi_455_;
                        phi_456_ = _e336;
                    }
                    let _e340 = phi_456_;
                    let _e341 = bitcast<u32>(_e340);
                    if (_e341 == 2147483648u) {
                        phi_462_ = 0u;
                    } else {
                        phi_462_ = _e341;
                    }
                    let _e344 = phi_462_;
                    let _e346 = bitcast<u32>(bitcast<f32>(_e344));
                    if ((_e346 >> bitcast<u32>(31i)) == 1u) {
                        phi_472_ = ~(_e346);
                    } else {
                        phi_472_ = (_e346 | 2147483648u);
                    }
                    let _e353 = phi_472_;
                    phi_574_ = array<u32, 2>(((_e240 | _e241) + _e167), (_e240 | (_e353 >> bitcast<u32>(2i))));
                } else {
                    if (_e212 == 2u) {
                        let _e245 = (_e215 == 1u);
                        if _e245 {
                            phi_485_ = (4u + _e167);
                        } else {
                            phi_485_ = _e167;
                        }
                        let _e248 = phi_485_;
                        let _e249 = (_e241 & 1023u);
                        let _e256 = (((_e241 >> bitcast<u32>(10u)) & 1023u) + (_e248 % 3u));
                        let _e258 = ((_e241 >> bitcast<u32>(20u)) + (_e248 / 3u));
                        if (_e256 < 1u) {
                            phi_560_ = array<u32, 2>();
                            phi_561_ = true;
                        } else {
                            if (_e258 < 1u) {
                                phi_558_ = array<u32, 2>();
                                phi_559_ = true;
                            } else {
                                if (_e256 > 1024u) {
                                    phi_556_ = array<u32, 2>();
                                    phi_557_ = true;
                                } else {
                                    let _e262 = (_e258 > 1024u);
                                    if _e262 {
                                        phi_555_ = array<u32, 2>();
                                    } else {
                                        if (_e249 > 0u) {
                                            if _e245 {
                                                if (_e248 == 4u) {
                                                    phi_521_ = false;
                                                } else {
                                                    phi_521_ = true;
                                                }
                                                let _e266 = phi_521_;
                                                phi_522_ = _e266;
                                            } else {
                                                phi_522_ = true;
                                            }
                                            let _e268 = phi_522_;
                                            if _e268 {
                                                phi_527_ = (_e249 - 1u);
                                                phi_528_ = false;
                                            } else {
                                                phi_527_ = u32();
                                                phi_528_ = true;
                                            }
                                            let _e271 = phi_527_;
                                            let _e273 = phi_528_;
                                            phi_529_ = _e271;
                                            phi_530_ = _e273;
                                        } else {
                                            phi_529_ = u32();
                                            phi_530_ = true;
                                        }
                                        let _e275 = phi_529_;
                                        let _e277 = phi_530_;
                                        if _e277 {
                                            phi_534_ = _e249;
                                        } else {
                                            phi_534_ = _e275;
                                        }
                                        let _e279 = phi_534_;
                                        if ((_e249 + 1u) < 1024u) {
                                            phi_541_ = (_e249 + 1u);
                                        } else {
                                            phi_541_ = _e249;
                                        }
                                        let _e284 = phi_541_;
                                        phi_555_ = array<u32, 2>(((((_e258 - 1u) << bitcast<u32>(20u)) | ((_e256 - 1u) << bitcast<u32>(10u))) | _e279), ((((_e258 - 1u) << bitcast<u32>(20u)) | ((_e256 - 1u) << bitcast<u32>(10u))) | _e284));
                                    }
                                    let _e303 = phi_555_;
                                    phi_556_ = _e303;
                                    phi_557_ = _e262;
                                }
                                let _e305 = phi_556_;
                                let _e307 = phi_557_;
                                phi_558_ = _e305;
                                phi_559_ = _e307;
                            }
                            let _e309 = phi_558_;
                            let _e311 = phi_559_;
                            phi_560_ = _e309;
                            phi_561_ = _e311;
                        }
                        let _e313 = phi_560_;
                        let _e315 = phi_561_;
                        if _e315 {
                            phi_566_ = array<u32, 2>(1u, 0u);
                        } else {
                            phi_566_ = _e313;
                        }
                        let _e317 = phi_566_;
                        phi_573_ = array<u32, 2>((_e240 | _e317[0]), (_e240 | _e317[1]));
                    } else {
                        phi_573_ = array<u32, 2>(_e240, _e240);
                    }
                    let _e324 = phi_573_;
                    phi_574_ = _e324;
                }
                let _e359 = phi_574_;
                if (_e215 == 1u) {
                    phi_582_ = (_e204 + 1u);
                } else {
                    phi_582_ = 0u;
                }
                let _e365 = phi_582_;
                phi_585_ = array<u32, 3>(_e359[0], _e359[1], _e365);
            } else {
                phi_585_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e368 = phi_585_;
            if _e209 {
                let _e373 = sorted.member[_e204];
                phi_602_ = _e373;
            } else {
                phi_602_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e375 = phi_602_;
            phi_605_ = type_9(0u, (((_e162 >> bitcast<u32>(24i)) & 15u) + 1u));
            loop {
                let _e378 = phi_605_;
                if (_e378.member < _e378.member_1) {
                    phi_606_ = type_9((_e378.member + 1u), _e378.member_1);
                    phi_629_ = type_9(1u, _e378.member);
                } else {
                    phi_606_ = _e378;
                    phi_629_ = type_9(0u, type_9().member_1);
                }
                let _e390 = phi_606_;
                let _e392 = phi_629_;
                let _e396 = (bitcast<i32>(_e392.member) != 0i);
                if _e396 {
                    let _e398 = (_e165 + (_e392.member_1 * 128u));
                    let _e399 = (_e398 + _e54);
                    if (_e399 < _e116) {
                        let _e402 = keys.member[_e399];
                        let _e404 = sorted.member[_e399];
                        phi_664_ = _e404;
                        phi_665_ = _e402;
                    } else {
                        phi_664_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_665_ = 4294967295u;
                    }
                    let _e406 = phi_664_;
                    let _e408 = phi_665_;
                    names[_e54] = _e408;
                    boxes[_e54] = type_16(array<f32, 3>(_e406.member[0], _e406.member[1], _e406.member[2]), array<f32, 3>(_e406.member_1[0], _e406.member_1[1], _e406.member_1[2]));
                    if (_e54 == 0u) {
                        atomicStore((&counters[4u]), 0u);
                    }
                    workgroupBarrier();
                    phi_686_ = type_9(0u, 128u);
                    loop {
                        let _e425 = phi_686_;
                        if (_e425.member < _e425.member_1) {
                            phi_687_ = type_9((_e425.member + 1u), _e425.member_1);
                            phi_710_ = type_9(1u, _e425.member);
                        } else {
                            phi_687_ = _e425;
                            phi_710_ = type_9(0u, type_9().member_1);
                        }
                        let _e437 = phi_687_;
                        let _e439 = phi_710_;
                        let _e443 = (bitcast<i32>(_e439.member) != 0i);
                        if _e443 {
                            let _e445 = names[_e439.member_1];
                            if (_e445 >= _e368[0]) {
                                if (_e445 <= _e368[1]) {
                                    if ((_e398 + _e439.member_1) >= _e368[2]) {
                                        let _e451 = boxes[_e439.member_1];
                                        if ((((((_e375.member[0] <= _e451.member_1[0]) && (_e451.member[0] <= _e375.member_1[0])) && (_e375.member[1] <= _e451.member_1[1])) && (_e451.member[1] <= _e375.member_1[1])) && (_e375.member[2] <= _e451.member_1[2])) && (_e451.member[2] <= _e375.member_1[2])) {
                                            let _e484 = atomicAdd((&counters[4u]), 1u);
                                            if (_e484 < 2048u) {
                                                hits[_e484] = ((_e54 << bitcast<u32>(7i)) | _e439.member_1);
                                            } else {
                                                let _e488 = order.member[_e204];
                                                let _e490 = order.member[(_e398 + _e439.member_1)];
                                                let _e493 = params.member.member_2.member_1;
                                                if (_e493 == 1u) {
                                                    let _e525 = params.member.member.member_2[1u];
                                                    let _e526 = (_e488 - _e525);
                                                    let _e530 = params.member.member.member_2[1u];
                                                    let _e531 = (_e490 - _e530);
                                                    if (_e526 < _e531) {
                                                        phi_823_ = type_9(_e526, _e531);
                                                    } else {
                                                        phi_823_ = type_9(_e531, _e526);
                                                    }
                                                    let _e536 = phi_823_;
                                                    phi_856_ = _e536;
                                                } else {
                                                    let _e497 = params.member.member_2.member;
                                                    if (_e497 == 1u) {
                                                        if (_e167 == 1u) {
                                                            let _e503 = params.member.member.member_2[2u];
                                                            phi_843_ = type_9(_e490, (_e488 - _e503));
                                                            phi_844_ = false;
                                                        } else {
                                                            phi_843_ = type_9();
                                                            phi_844_ = true;
                                                        }
                                                        let _e507 = phi_843_;
                                                        let _e509 = phi_844_;
                                                        phi_845_ = _e507;
                                                        phi_846_ = _e509;
                                                    } else {
                                                        phi_845_ = type_9();
                                                        phi_846_ = true;
                                                    }
                                                    let _e511 = phi_845_;
                                                    let _e513 = phi_846_;
                                                    if _e513 {
                                                        let _e517 = params.member.member.member_2[2u];
                                                        phi_855_ = type_9(_e488, (_e490 - _e517));
                                                    } else {
                                                        phi_855_ = _e511;
                                                    }
                                                    let _e521 = phi_855_;
                                                    phi_856_ = _e521;
                                                }
                                                let _e538 = phi_856_;
                                                let _e543 = params.member.member_1.member_3;
                                                let _e545 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e545 + 1u) < _e545) {
                                                    let _e549 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e545 < _e543) {
                                                    let _e551 = (2u * _e545);
                                                    atomicStore((&pairs.member[(4u + _e551)]), _e538.member);
                                                    atomicStore((&pairs.member[(_e551 + 5u)]), _e538.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_686_ = _e437;
                            break if !(_e443);
                        }
                    }
                    workgroupBarrier();
                    let _e562 = atomicLoad((&counters[4u]));
                    if (2048u < _e562) {
                        phi_891_ = 2048u;
                    } else {
                        phi_891_ = _e562;
                    }
                    let _e565 = phi_891_;
                    if (_e54 == 0u) {
                        if (_e565 > 0u) {
                            let _e569 = atomicAdd((&pairs.member[0u]), _e565);
                            if ((_e569 + _e565) < _e569) {
                                let _e573 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[5u]), _e569);
                        }
                    }
                    workgroupBarrier();
                    let _e576 = atomicLoad((&counters[5u]));
                    phi_917_ = type_9(0u, 16u);
                    loop {
                        let _e578 = phi_917_;
                        if (_e578.member < _e578.member_1) {
                            phi_918_ = type_9((_e578.member + 1u), _e578.member_1);
                            phi_941_ = type_9(1u, _e578.member);
                        } else {
                            phi_918_ = _e578;
                            phi_941_ = type_9(0u, type_9().member_1);
                        }
                        let _e590 = phi_918_;
                        let _e592 = phi_941_;
                        if (bitcast<i32>(_e592.member) != 0i) {
                            let _e598 = ((_e592.member_1 * 128u) + _e54);
                            if (_e598 >= _e565) {
                                phi_1104_ = false;
                            } else {
                                let _e601 = hits[_e598];
                                let _e606 = params.member.member_2.member;
                                let _e609 = params.member.member_2.member_1;
                                if (_e609 == 0u) {
                                    phi_970_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_970_ = array<u32, 2>(1u, 1u);
                                }
                                let _e612 = phi_970_;
                                if (_e606 == 1u) {
                                    if (_e167 == 1u) {
                                        phi_982_ = array<u32, 2>(_e612[1], _e612[0]);
                                        phi_983_ = false;
                                    } else {
                                        phi_982_ = array<u32, 2>();
                                        phi_983_ = true;
                                    }
                                    let _e619 = phi_982_;
                                    let _e621 = phi_983_;
                                    phi_984_ = _e619;
                                    phi_985_ = _e621;
                                } else {
                                    phi_984_ = array<u32, 2>();
                                    phi_985_ = true;
                                }
                                let _e623 = phi_984_;
                                let _e625 = phi_985_;
                                if _e625 {
                                    phi_990_ = _e612;
                                } else {
                                    phi_990_ = _e623;
                                }
                                let _e627 = phi_990_;
                                let _e634 = params.member.member.member_2[_e627[0]];
                                let _e639 = order.member[(_e634 + ((_e172 * 128u) + (_e601 >> bitcast<u32>(7i))))];
                                let _e641 = order.member[(_e398 + (_e601 % 128u))];
                                let _e644 = params.member.member_2.member_1;
                                if (_e644 == 1u) {
                                    let _e676 = params.member.member.member_2[1u];
                                    let _e677 = (_e639 - _e676);
                                    let _e681 = params.member.member.member_2[1u];
                                    let _e682 = (_e641 - _e681);
                                    if (_e677 < _e682) {
                                        phi_1053_ = type_9(_e677, _e682);
                                    } else {
                                        phi_1053_ = type_9(_e682, _e677);
                                    }
                                    let _e687 = phi_1053_;
                                    phi_1086_ = _e687;
                                } else {
                                    let _e648 = params.member.member_2.member;
                                    if (_e648 == 1u) {
                                        if (_e167 == 1u) {
                                            let _e654 = params.member.member.member_2[2u];
                                            phi_1073_ = type_9(_e641, (_e639 - _e654));
                                            phi_1074_ = false;
                                        } else {
                                            phi_1073_ = type_9();
                                            phi_1074_ = true;
                                        }
                                        let _e658 = phi_1073_;
                                        let _e660 = phi_1074_;
                                        phi_1075_ = _e658;
                                        phi_1076_ = _e660;
                                    } else {
                                        phi_1075_ = type_9();
                                        phi_1076_ = true;
                                    }
                                    let _e662 = phi_1075_;
                                    let _e664 = phi_1076_;
                                    if _e664 {
                                        let _e668 = params.member.member.member_2[2u];
                                        phi_1085_ = type_9(_e639, (_e641 - _e668));
                                    } else {
                                        phi_1085_ = _e662;
                                    }
                                    let _e672 = phi_1085_;
                                    phi_1086_ = _e672;
                                }
                                let _e689 = phi_1086_;
                                let _e694 = params.member.member_1.member_3;
                                let _e695 = (_e576 + _e598);
                                if (_e695 < _e694) {
                                    let _e697 = (2u * _e695);
                                    atomicStore((&pairs.member[(4u + _e697)]), _e689.member);
                                    atomicStore((&pairs.member[(_e697 + 5u)]), _e689.member_1);
                                }
                                phi_1104_ = true;
                            }
                            let _e703 = phi_1104_;
                            phi_1105_ = _e703;
                        } else {
                            phi_1105_ = false;
                        }
                        let _e705 = phi_1105_;
                        continue;
                        continuing {
                            phi_917_ = _e590;
                            break if !(_e705);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_605_ = _e390;
                    break if !(_e396);
                }
            }
        }
        continue;
        continuing {
            phi_250_ = _e146;
            break if !(_e152);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
