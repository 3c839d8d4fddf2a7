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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
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
    member_3: array<u32, 3>,
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
var<storage> keys: type_10;
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
var<storage> order: type_10;
@group(0) @binding(4) 
var<storage> survey: type_10;
@group(0) @binding(5) 
var<storage> work: type_10;
var<workgroup> boxes: array<type_16, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_146_: u32;
    var phi_158_: u32;
    var phi_196_: bool;
    var phi_237_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_285_: bool;
    var phi_296_: u32;
    var phi_297_: u32;
    var phi_316_: u32;
    var phi_337_: u32;
    var phi_338_: u32;
    var phi_341_: type_12;
    var phi_342_: type_12;
    var phi_365_: type_12;
    var phi_419_: array<u32, 2>;
    var phi_431_: array<u32, 2>;
    var phi_432_: bool;
    var phi_433_: array<u32, 2>;
    var phi_434_: bool;
    var phi_439_: array<u32, 2>;
    var phi_475_: array<u32, 2>;
    var phi_487_: array<u32, 2>;
    var phi_488_: bool;
    var phi_489_: array<u32, 2>;
    var phi_490_: bool;
    var phi_495_: array<u32, 2>;
    var phi_576_: u32;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_618_: u32;
    var phi_619_: bool;
    var phi_620_: u32;
    var phi_621_: bool;
    var phi_625_: u32;
    var phi_632_: u32;
    var phi_646_: array<u32, 2>;
    var phi_647_: array<u32, 2>;
    var phi_648_: bool;
    var phi_649_: array<u32, 2>;
    var phi_650_: bool;
    var phi_651_: array<u32, 2>;
    var phi_652_: bool;
    var phi_657_: array<u32, 2>;
    var phi_664_: array<u32, 2>;
    var phi_546_: f32;
    var phi_547_: f32;
    var phi_553_: u32;
    var phi_563_: u32;
    var phi_665_: array<u32, 2>;
    var phi_673_: u32;
    var phi_676_: array<u32, 3>;
    var phi_693_: type_16;
    var phi_696_: type_12;
    var phi_697_: type_12;
    var phi_720_: type_12;
    var phi_755_: type_16;
    var phi_756_: u32;
    var phi_777_: type_12;
    var phi_778_: type_12;
    var phi_801_: type_12;
    var phi_934_: type_12;
    var phi_935_: bool;
    var phi_936_: type_12;
    var phi_937_: bool;
    var phi_946_: type_12;
    var phi_914_: type_12;
    var phi_947_: type_12;
    var phi_982_: u32;
    var phi_1008_: type_12;
    var phi_1009_: type_12;
    var phi_1032_: type_12;
    var phi_1061_: array<u32, 2>;
    var phi_1073_: array<u32, 2>;
    var phi_1074_: bool;
    var phi_1075_: array<u32, 2>;
    var phi_1076_: bool;
    var phi_1081_: array<u32, 2>;
    var phi_1164_: type_12;
    var phi_1165_: bool;
    var phi_1166_: type_12;
    var phi_1167_: bool;
    var phi_1176_: type_12;
    var phi_1144_: type_12;
    var phi_1177_: type_12;
    var phi_1195_: bool;
    var phi_1196_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e69 = ((_e55.y * _e56.x) + _e55.x);
    let _e72 = (_e56.x * _e56.y);
    let _e75 = params.member.member_1.member_2;
    let _e77 = work.member[0u];
    if (_e75 < _e77) {
        phi_146_ = _e75;
    } else {
        phi_146_ = _e77;
    }
    let _e80 = phi_146_;
    let _e83 = params.member.member_1.member_1;
    if (_e80 > _e83) {
        let _e87 = params.member.member_1.member_1;
        phi_158_ = (_e80 - _e87);
    } else {
        phi_158_ = 0u;
    }
    let _e90 = phi_158_;
    let _e92 = survey.member[10u];
    if (_e92 > 0u) {
        phi_196_ = true;
    } else {
        let _e95 = survey.member[9u];
        let _e99 = params.member.member_2.member_3[0u];
        phi_196_ = (_e95 > _e99);
    }
    let _e102 = phi_196_;
    if _e102 {
        phi_280_ = bool();
        phi_281_ = true;
    } else {
        let _e104 = survey.member[15u];
        if (_e104 > 0u) {
            phi_237_ = true;
        } else {
            let _e107 = survey.member[14u];
            let _e111 = params.member.member_2.member_3[1u];
            phi_237_ = (_e107 > _e111);
        }
        let _e114 = phi_237_;
        if _e114 {
            phi_279_ = bool();
        } else {
            let _e116 = survey.member[20u];
            if (_e116 > 0u) {
                phi_278_ = true;
            } else {
                let _e119 = survey.member[19u];
                let _e123 = params.member.member_2.member_3[2u];
                phi_278_ = (_e119 > _e123);
            }
            let _e126 = phi_278_;
            phi_279_ = _e126;
        }
        let _e128 = phi_279_;
        phi_280_ = _e128;
        phi_281_ = _e114;
    }
    let _e130 = phi_280_;
    let _e132 = phi_281_;
    if _e132 {
        phi_285_ = true;
    } else {
        phi_285_ = _e130;
    }
    let _e134 = phi_285_;
    if _e134 {
        phi_297_ = 0u;
    } else {
        let _e137 = params.member.member_1.member;
        if (_e137 < _e90) {
            phi_296_ = _e137;
        } else {
            phi_296_ = _e90;
        }
        let _e140 = phi_296_;
        phi_297_ = _e140;
    }
    let _e142 = phi_297_;
    let _e146 = params.member.member.member_2[3u];
    if false {
        phi_316_ = (_e142 + 1u);
    } else {
        phi_316_ = _e142;
    }
    let _e149 = phi_316_;
    if (_e149 > _e69) {
        let _e151 = (_e149 - _e69);
        if (_e72 == 0u) {
            return;
        }
        let _e153 = (_e151 / _e72);
        if (_e72 == 0u) {
            return;
        }
        if ((_e151 % _e72) > 0u) {
            phi_337_ = (_e153 + 1u);
        } else {
            phi_337_ = _e153;
        }
        let _e159 = phi_337_;
        phi_338_ = _e159;
    } else {
        phi_338_ = 0u;
    }
    let _e161 = phi_338_;
    phi_341_ = type_12(0u, _e161);
    loop {
        let _e164 = phi_341_;
        if (_e164.member < _e164.member_1) {
            phi_342_ = type_12((_e164.member + 1u), _e164.member_1);
            phi_365_ = type_12(1u, _e164.member);
        } else {
            phi_342_ = _e164;
            phi_365_ = type_12(0u, type_12().member_1);
        }
        let _e176 = phi_342_;
        let _e178 = phi_365_;
        let _e182 = (bitcast<i32>(_e178.member) != 0i);
        if _e182 {
            let _e185 = params.member.member_1.member_1;
            let _e189 = (2u * ((_e185 + _e69) + (_e178.member_1 * _e72)));
            let _e192 = work.member[(4u + _e189)];
            let _e195 = work.member[(_e189 + 5u)];
            let _e197 = (_e192 >> bitcast<u32>(28i));
            let _e202 = (_e192 & 16777215u);
            let _e205 = params.member.member_2.member;
            let _e208 = params.member.member_2.member_1;
            if (_e208 == 0u) {
                phi_419_ = array<u32, 2>(0u, 2u);
            } else {
                phi_419_ = array<u32, 2>(1u, 1u);
            }
            let _e211 = phi_419_;
            if (_e205 == 1u) {
                if (_e197 == 1u) {
                    phi_431_ = array<u32, 2>(_e211[1], _e211[0]);
                    phi_432_ = false;
                } else {
                    phi_431_ = array<u32, 2>();
                    phi_432_ = true;
                }
                let _e218 = phi_431_;
                let _e220 = phi_432_;
                phi_433_ = _e218;
                phi_434_ = _e220;
            } else {
                phi_433_ = array<u32, 2>();
                phi_434_ = true;
            }
            let _e222 = phi_433_;
            let _e224 = phi_434_;
            if _e224 {
                phi_439_ = _e211;
            } else {
                phi_439_ = _e222;
            }
            let _e226 = phi_439_;
            let _e229 = ((_e202 * 128u) + _e57);
            let _e233 = params.member.member.member_2[_e226[0]];
            let _e234 = (_e233 + _e229);
            let _e238 = params.member.member.member[_e226[0]];
            let _e239 = (_e229 < _e238);
            if _e239 {
                let _e242 = params.member.member_2.member;
                let _e245 = params.member.member_2.member_1;
                if (_e245 == 0u) {
                    phi_475_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_475_ = array<u32, 2>(1u, 1u);
                }
                let _e248 = phi_475_;
                if (_e242 == 1u) {
                    if (_e197 == 1u) {
                        phi_487_ = array<u32, 2>(_e248[1], _e248[0]);
                        phi_488_ = false;
                    } else {
                        phi_487_ = array<u32, 2>();
                        phi_488_ = true;
                    }
                    let _e255 = phi_487_;
                    let _e257 = phi_488_;
                    phi_489_ = _e255;
                    phi_490_ = _e257;
                } else {
                    phi_489_ = array<u32, 2>();
                    phi_490_ = true;
                }
                let _e259 = phi_489_;
                let _e261 = phi_490_;
                if _e261 {
                    phi_495_ = _e248;
                } else {
                    phi_495_ = _e259;
                }
                let _e263 = phi_495_;
                let _e266 = keys.member[_e234];
                let _e268 = sorted.member[_e234];
                let _e270 = (_e263[1] << bitcast<u32>(30u));
                let _e271 = (_e266 & 1073741823u);
                if (_e242 == 1u) {
                    let _e358 = survey.member[6u];
                    if (_e358 == 0u) {
                        phi_547_ = _e268.member_1[0];
                    } else {
                        if (_e358 == 1u) {
                            phi_546_ = _e268.member_1[1];
                        } else {
                            phi_546_ = _e268.member_1[2];
                        }
                        let _e366 = phi_546_;
                        phi_547_ = _e366;
                    }
                    let _e370 = phi_547_;
                    let _e371 = bitcast<u32>(_e370);
                    if (_e371 == 2147483648u) {
                        phi_553_ = 0u;
                    } else {
                        phi_553_ = _e371;
                    }
                    let _e374 = phi_553_;
                    let _e376 = bitcast<u32>(bitcast<f32>(_e374));
                    if ((_e376 >> bitcast<u32>(31i)) == 1u) {
                        phi_563_ = ~(_e376);
                    } else {
                        phi_563_ = (_e376 | 2147483648u);
                    }
                    let _e383 = phi_563_;
                    phi_665_ = array<u32, 2>(((_e270 | _e271) + _e197), (_e270 | (_e383 >> bitcast<u32>(2i))));
                } else {
                    if (_e242 == 2u) {
                        let _e275 = (_e245 == 1u);
                        if _e275 {
                            phi_576_ = (4u + _e197);
                        } else {
                            phi_576_ = _e197;
                        }
                        let _e278 = phi_576_;
                        let _e279 = (_e271 & 1023u);
                        let _e286 = (((_e271 >> bitcast<u32>(10u)) & 1023u) + (_e278 % 3u));
                        let _e288 = ((_e271 >> bitcast<u32>(20u)) + (_e278 / 3u));
                        if (_e286 < 1u) {
                            phi_651_ = array<u32, 2>();
                            phi_652_ = true;
                        } else {
                            if (_e288 < 1u) {
                                phi_649_ = array<u32, 2>();
                                phi_650_ = true;
                            } else {
                                if (_e286 > 1024u) {
                                    phi_647_ = array<u32, 2>();
                                    phi_648_ = true;
                                } else {
                                    let _e292 = (_e288 > 1024u);
                                    if _e292 {
                                        phi_646_ = array<u32, 2>();
                                    } else {
                                        if (_e279 > 0u) {
                                            if _e275 {
                                                if (_e278 == 4u) {
                                                    phi_612_ = false;
                                                } else {
                                                    phi_612_ = true;
                                                }
                                                let _e296 = phi_612_;
                                                phi_613_ = _e296;
                                            } else {
                                                phi_613_ = true;
                                            }
                                            let _e298 = phi_613_;
                                            if _e298 {
                                                phi_618_ = (_e279 - 1u);
                                                phi_619_ = false;
                                            } else {
                                                phi_618_ = u32();
                                                phi_619_ = true;
                                            }
                                            let _e301 = phi_618_;
                                            let _e303 = phi_619_;
                                            phi_620_ = _e301;
                                            phi_621_ = _e303;
                                        } else {
                                            phi_620_ = u32();
                                            phi_621_ = true;
                                        }
                                        let _e305 = phi_620_;
                                        let _e307 = phi_621_;
                                        if _e307 {
                                            phi_625_ = _e279;
                                        } else {
                                            phi_625_ = _e305;
                                        }
                                        let _e309 = phi_625_;
                                        if ((_e279 + 1u) < 1024u) {
                                            phi_632_ = (_e279 + 1u);
                                        } else {
                                            phi_632_ = _e279;
                                        }
                                        let _e314 = phi_632_;
                                        phi_646_ = array<u32, 2>(((((_e288 - 1u) << bitcast<u32>(20u)) | ((_e286 - 1u) << bitcast<u32>(10u))) | _e309), ((((_e288 - 1u) << bitcast<u32>(20u)) | ((_e286 - 1u) << bitcast<u32>(10u))) | _e314));
                                    }
                                    let _e333 = phi_646_;
                                    phi_647_ = _e333;
                                    phi_648_ = _e292;
                                }
                                let _e335 = phi_647_;
                                let _e337 = phi_648_;
                                phi_649_ = _e335;
                                phi_650_ = _e337;
                            }
                            let _e339 = phi_649_;
                            let _e341 = phi_650_;
                            phi_651_ = _e339;
                            phi_652_ = _e341;
                        }
                        let _e343 = phi_651_;
                        let _e345 = phi_652_;
                        if _e345 {
                            phi_657_ = array<u32, 2>(1u, 0u);
                        } else {
                            phi_657_ = _e343;
                        }
                        let _e347 = phi_657_;
                        phi_664_ = array<u32, 2>((_e270 | _e347[0]), (_e270 | _e347[1]));
                    } else {
                        phi_664_ = array<u32, 2>(_e270, _e270);
                    }
                    let _e354 = phi_664_;
                    phi_665_ = _e354;
                }
                let _e389 = phi_665_;
                if (_e245 == 1u) {
                    phi_673_ = (_e234 + 1u);
                } else {
                    phi_673_ = 0u;
                }
                let _e395 = phi_673_;
                phi_676_ = array<u32, 3>(_e389[0], _e389[1], _e395);
            } else {
                phi_676_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e398 = phi_676_;
            if _e239 {
                let _e403 = sorted.member[_e234];
                phi_693_ = _e403;
            } else {
                phi_693_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e405 = phi_693_;
            phi_696_ = type_12(0u, (((_e192 >> bitcast<u32>(24i)) & 15u) + 1u));
            loop {
                let _e408 = phi_696_;
                if (_e408.member < _e408.member_1) {
                    phi_697_ = type_12((_e408.member + 1u), _e408.member_1);
                    phi_720_ = type_12(1u, _e408.member);
                } else {
                    phi_697_ = _e408;
                    phi_720_ = type_12(0u, type_12().member_1);
                }
                let _e420 = phi_697_;
                let _e422 = phi_720_;
                let _e426 = (bitcast<i32>(_e422.member) != 0i);
                if _e426 {
                    let _e428 = (_e195 + (_e422.member_1 * 128u));
                    let _e429 = (_e428 + _e57);
                    if (_e429 < _e146) {
                        let _e432 = keys.member[_e429];
                        let _e434 = sorted.member[_e429];
                        phi_755_ = _e434;
                        phi_756_ = _e432;
                    } else {
                        phi_755_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_756_ = 4294967295u;
                    }
                    let _e436 = phi_755_;
                    let _e438 = phi_756_;
                    names[_e57] = _e438;
                    boxes[_e57] = type_16(array<f32, 3>(_e436.member[0], _e436.member[1], _e436.member[2]), array<f32, 3>(_e436.member_1[0], _e436.member_1[1], _e436.member_1[2]));
                    if (_e57 == 0u) {
                        atomicStore((&counters[4u]), 0u);
                    }
                    workgroupBarrier();
                    phi_777_ = type_12(0u, 128u);
                    loop {
                        let _e455 = phi_777_;
                        if (_e455.member < _e455.member_1) {
                            phi_778_ = type_12((_e455.member + 1u), _e455.member_1);
                            phi_801_ = type_12(1u, _e455.member);
                        } else {
                            phi_778_ = _e455;
                            phi_801_ = type_12(0u, type_12().member_1);
                        }
                        let _e467 = phi_778_;
                        let _e469 = phi_801_;
                        let _e473 = (bitcast<i32>(_e469.member) != 0i);
                        if _e473 {
                            let _e475 = names[_e469.member_1];
                            if (_e475 >= _e398[0]) {
                                if (_e475 <= _e398[1]) {
                                    if ((_e428 + _e469.member_1) >= _e398[2]) {
                                        let _e481 = boxes[_e469.member_1];
                                        if ((((((_e405.member[0] <= _e481.member_1[0]) && (_e481.member[0] <= _e405.member_1[0])) && (_e405.member[1] <= _e481.member_1[1])) && (_e481.member[1] <= _e405.member_1[1])) && (_e405.member[2] <= _e481.member_1[2])) && (_e481.member[2] <= _e405.member_1[2])) {
                                            let _e514 = atomicAdd((&counters[4u]), 1u);
                                            if (_e514 < 2048u) {
                                                hits[_e514] = ((_e57 << bitcast<u32>(7i)) | _e469.member_1);
                                            } else {
                                                let _e518 = order.member[_e234];
                                                let _e520 = order.member[(_e428 + _e469.member_1)];
                                                let _e523 = params.member.member_2.member_1;
                                                if (_e523 == 1u) {
                                                    let _e555 = params.member.member.member_2[1u];
                                                    let _e556 = (_e518 - _e555);
                                                    let _e560 = params.member.member.member_2[1u];
                                                    let _e561 = (_e520 - _e560);
                                                    if (_e556 < _e561) {
                                                        phi_914_ = type_12(_e556, _e561);
                                                    } else {
                                                        phi_914_ = type_12(_e561, _e556);
                                                    }
                                                    let _e566 = phi_914_;
                                                    phi_947_ = _e566;
                                                } else {
                                                    let _e527 = params.member.member_2.member;
                                                    if (_e527 == 1u) {
                                                        if (_e197 == 1u) {
                                                            let _e533 = params.member.member.member_2[2u];
                                                            phi_934_ = type_12(_e520, (_e518 - _e533));
                                                            phi_935_ = false;
                                                        } else {
                                                            phi_934_ = type_12();
                                                            phi_935_ = true;
                                                        }
                                                        let _e537 = phi_934_;
                                                        let _e539 = phi_935_;
                                                        phi_936_ = _e537;
                                                        phi_937_ = _e539;
                                                    } else {
                                                        phi_936_ = type_12();
                                                        phi_937_ = true;
                                                    }
                                                    let _e541 = phi_936_;
                                                    let _e543 = phi_937_;
                                                    if _e543 {
                                                        let _e547 = params.member.member.member_2[2u];
                                                        phi_946_ = type_12(_e518, (_e520 - _e547));
                                                    } else {
                                                        phi_946_ = _e541;
                                                    }
                                                    let _e551 = phi_946_;
                                                    phi_947_ = _e551;
                                                }
                                                let _e568 = phi_947_;
                                                let _e573 = params.member.member_1.member_3;
                                                let _e575 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e575 + 1u) < _e575) {
                                                    let _e579 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e575 < _e573) {
                                                    let _e581 = (2u * _e575);
                                                    atomicStore((&pairs.member[(4u + _e581)]), _e568.member);
                                                    atomicStore((&pairs.member[(_e581 + 5u)]), _e568.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_777_ = _e467;
                            break if !(_e473);
                        }
                    }
                    workgroupBarrier();
                    let _e592 = atomicLoad((&counters[4u]));
                    if (2048u < _e592) {
                        phi_982_ = 2048u;
                    } else {
                        phi_982_ = _e592;
                    }
                    let _e595 = phi_982_;
                    if (_e57 == 0u) {
                        if (_e595 > 0u) {
                            let _e599 = atomicAdd((&pairs.member[0u]), _e595);
                            if ((_e599 + _e595) < _e599) {
                                let _e603 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[5u]), _e599);
                        }
                    }
                    workgroupBarrier();
                    let _e606 = atomicLoad((&counters[5u]));
                    phi_1008_ = type_12(0u, 16u);
                    loop {
                        let _e608 = phi_1008_;
                        if (_e608.member < _e608.member_1) {
                            phi_1009_ = type_12((_e608.member + 1u), _e608.member_1);
                            phi_1032_ = type_12(1u, _e608.member);
                        } else {
                            phi_1009_ = _e608;
                            phi_1032_ = type_12(0u, type_12().member_1);
                        }
                        let _e620 = phi_1009_;
                        let _e622 = phi_1032_;
                        if (bitcast<i32>(_e622.member) != 0i) {
                            let _e628 = ((_e622.member_1 * 128u) + _e57);
                            if (_e628 >= _e595) {
                                phi_1195_ = false;
                            } else {
                                let _e631 = hits[_e628];
                                let _e636 = params.member.member_2.member;
                                let _e639 = params.member.member_2.member_1;
                                if (_e639 == 0u) {
                                    phi_1061_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_1061_ = array<u32, 2>(1u, 1u);
                                }
                                let _e642 = phi_1061_;
                                if (_e636 == 1u) {
                                    if (_e197 == 1u) {
                                        phi_1073_ = array<u32, 2>(_e642[1], _e642[0]);
                                        phi_1074_ = false;
                                    } else {
                                        phi_1073_ = array<u32, 2>();
                                        phi_1074_ = true;
                                    }
                                    let _e649 = phi_1073_;
                                    let _e651 = phi_1074_;
                                    phi_1075_ = _e649;
                                    phi_1076_ = _e651;
                                } else {
                                    phi_1075_ = array<u32, 2>();
                                    phi_1076_ = true;
                                }
                                let _e653 = phi_1075_;
                                let _e655 = phi_1076_;
                                if _e655 {
                                    phi_1081_ = _e642;
                                } else {
                                    phi_1081_ = _e653;
                                }
                                let _e657 = phi_1081_;
                                let _e664 = params.member.member.member_2[_e657[0]];
                                let _e669 = order.member[(_e664 + ((_e202 * 128u) + (_e631 >> bitcast<u32>(7i))))];
                                let _e671 = order.member[(_e428 + (_e631 % 128u))];
                                let _e674 = params.member.member_2.member_1;
                                if (_e674 == 1u) {
                                    let _e706 = params.member.member.member_2[1u];
                                    let _e707 = (_e669 - _e706);
                                    let _e711 = params.member.member.member_2[1u];
                                    let _e712 = (_e671 - _e711);
                                    if (_e707 < _e712) {
                                        phi_1144_ = type_12(_e707, _e712);
                                    } else {
                                        phi_1144_ = type_12(_e712, _e707);
                                    }
                                    let _e717 = phi_1144_;
                                    phi_1177_ = _e717;
                                } else {
                                    let _e678 = params.member.member_2.member;
                                    if (_e678 == 1u) {
                                        if (_e197 == 1u) {
                                            let _e684 = params.member.member.member_2[2u];
                                            phi_1164_ = type_12(_e671, (_e669 - _e684));
                                            phi_1165_ = false;
                                        } else {
                                            phi_1164_ = type_12();
                                            phi_1165_ = true;
                                        }
                                        let _e688 = phi_1164_;
                                        let _e690 = phi_1165_;
                                        phi_1166_ = _e688;
                                        phi_1167_ = _e690;
                                    } else {
                                        phi_1166_ = type_12();
                                        phi_1167_ = true;
                                    }
                                    let _e692 = phi_1166_;
                                    let _e694 = phi_1167_;
                                    if _e694 {
                                        let _e698 = params.member.member.member_2[2u];
                                        phi_1176_ = type_12(_e669, (_e671 - _e698));
                                    } else {
                                        phi_1176_ = _e692;
                                    }
                                    let _e702 = phi_1176_;
                                    phi_1177_ = _e702;
                                }
                                let _e719 = phi_1177_;
                                let _e724 = params.member.member_1.member_3;
                                let _e725 = (_e606 + _e628);
                                if (_e725 < _e724) {
                                    let _e727 = (2u * _e725);
                                    atomicStore((&pairs.member[(4u + _e727)]), _e719.member);
                                    atomicStore((&pairs.member[(_e727 + 5u)]), _e719.member_1);
                                }
                                phi_1195_ = true;
                            }
                            let _e733 = phi_1195_;
                            phi_1196_ = _e733;
                        } else {
                            phi_1196_ = false;
                        }
                        let _e735 = phi_1196_;
                        continue;
                        continuing {
                            phi_1008_ = _e620;
                            break if !(_e735);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_696_ = _e420;
                    break if !(_e426);
                }
            }
        }
        continue;
        continuing {
            phi_341_ = _e176;
            break if !(_e182);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
