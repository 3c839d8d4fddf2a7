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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_18 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_20 {
    member: array<type_18>,
}

struct type_21 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_26 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_35 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(4) 
var<storage> oriented: type_30;
@group(0) @binding(2) 
var<storage> order: type_13;
@group(0) @binding(1) 
var<storage> boxes: type_20;
@group(0) @binding(3) 
var<storage> nodes: type_23;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_35;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: type_32;
    var phi_144_: array<u32, 2>;
    var phi_176_: u32;
    var phi_203_: array<u32, 2>;
    var phi_234_: array<u32, 2>;
    var phi_297_: array<u32, 2>;
    var phi_330_: bool;
    var phi_400_: type_9;
    var phi_401_: type_9;
    var phi_424_: type_9;
    var phi_478_: f32;
    var phi_483_: f32;
    var phi_488_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_503_: f32;
    var phi_514_: f32;
    var phi_519_: f32;
    var phi_524_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_577_: f32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_597_: f32;
    var phi_604_: f32;
    var phi_610_: f32;
    var phi_617_: f32;
    var phi_710_: f32;
    var phi_717_: f32;
    var phi_723_: f32;
    var phi_729_: f32;
    var phi_748_: f32;
    var phi_755_: f32;
    var phi_761_: f32;
    var phi_767_: f32;
    var phi_786_: f32;
    var phi_793_: f32;
    var phi_799_: f32;
    var phi_805_: f32;
    var phi_824_: f32;
    var phi_831_: f32;
    var phi_837_: f32;
    var phi_843_: f32;
    var phi_862_: f32;
    var phi_869_: f32;
    var phi_875_: f32;
    var phi_881_: f32;
    var phi_900_: f32;
    var phi_907_: f32;
    var phi_913_: f32;
    var phi_919_: f32;
    var phi_934_: f32;
    var phi_939_: f32;
    var phi_944_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_1013_: f32;
    var phi_1036_: f32;
    var phi_1059_: f32;
    var phi_1081_: f32;
    var phi_1097_: f32;
    var phi_1152_: f32;
    var phi_1175_: f32;
    var phi_1198_: f32;
    var phi_1220_: f32;
    var phi_1236_: f32;
    var phi_1291_: f32;
    var phi_1314_: f32;
    var phi_1337_: f32;
    var phi_1359_: f32;
    var phi_1375_: f32;
    var phi_1430_: f32;
    var phi_1453_: f32;
    var phi_1477_: f32;
    var phi_1500_: f32;
    var phi_1516_: f32;
    var phi_1571_: f32;
    var phi_1594_: f32;
    var phi_1618_: f32;
    var phi_1641_: f32;
    var phi_1657_: f32;
    var phi_1712_: f32;
    var phi_1735_: f32;
    var phi_1759_: f32;
    var phi_1782_: f32;
    var phi_1798_: f32;
    var phi_1853_: f32;
    var phi_1876_: f32;
    var phi_1900_: f32;
    var phi_1923_: f32;
    var phi_1939_: f32;
    var phi_1994_: f32;
    var phi_2017_: f32;
    var phi_2041_: f32;
    var phi_2064_: f32;
    var phi_2080_: f32;
    var phi_2135_: f32;
    var phi_2158_: f32;
    var phi_2182_: f32;
    var phi_2205_: f32;
    var phi_2221_: f32;
    var phi_2228_: f32;
    var phi_2233_: f32;
    var phi_2238_: f32;
    var phi_2243_: f32;
    var phi_2248_: f32;
    var phi_2253_: f32;
    var phi_2258_: f32;
    var phi_2263_: f32;
    var phi_2267_: bool;
    var phi_2375_: u32;
    var phi_2376_: bool;
    var phi_2377_: u32;
    var phi_2378_: bool;
    var phi_2382_: u32;
    var phi_2390_: u32;
    var phi_2391_: bool;
    var phi_2392_: u32;
    var phi_2393_: bool;
    var phi_2397_: u32;
    var phi_2402_: bool;
    var phi_2407_: bool;
    var phi_2419_: u32;
    var phi_2435_: u32;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2484_: array<u32, 2>;
    var phi_2517_: bool;
    var phi_2560_: array<u32, 2>;
    var phi_2593_: bool;
    var phi_2644_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e37 = id_2;
    let _e38 = n_2;
    let _e39 = lane_2;
    let _e52 = ((((_e37.y * _e38.x) + _e37.x) * 128u) + _e39);
    let _e55 = params.member.member_1.member;
    if (_e52 < _e55) {
        let _e59 = params.member.member_2.member;
        if (_e59 == 0u) {
            phi_144_ = array<u32, 2>(0u, 2u);
        } else {
            phi_144_ = array<u32, 2>(1u, 1u);
        }
        let _e62 = phi_144_;
        let _e67 = params.member.member.member_2[_e62[0]];
        let _e70 = params.member.member_1.member_1;
        let _e72 = ((_e67 + _e70) + _e52);
        let _e75 = params.member.member_2.member_1;
        if (_e75 == 0u) {
            phi_176_ = _e72;
        } else {
            let _e78 = order.member[_e72];
            phi_176_ = _e78;
        }
        let _e80 = phi_176_;
        let _e81 = (_e80 - _e67);
        let _e83 = boxes.member[_e80];
        let _e98 = params.member.member_2.member;
        if (_e98 == 0u) {
            phi_203_ = array<u32, 2>(0u, 2u);
        } else {
            phi_203_ = array<u32, 2>(1u, 1u);
        }
        let _e101 = phi_203_;
        let _e106 = params.member.member.member_2[_e101[1]];
        let _e110 = params.member.member.member[_e101[1]];
        let _e111 = (_e110 - 1u);
        if (_e111 == 0u) {
            let _e115 = params.member.member_2.member;
            if (_e115 == 0u) {
                phi_234_ = array<u32, 2>(0u, 2u);
            } else {
                phi_234_ = array<u32, 2>(1u, 1u);
            }
            let _e118 = phi_234_;
            let _e123 = params.member.member.member_2[_e118[1]];
            let _e125 = order.member[_e123];
            let _e127 = boxes.member[_e125];
            if ((((((_e127.member.x <= _e83.member_1.y) && (_e83.member.x <= _e127.member_1.y)) && (_e127.member.y <= _e83.member_2.x)) && (_e83.member.y <= _e127.member_2.x)) && (_e127.member_1.x <= _e83.member_2.y)) && (_e83.member_1.x <= _e127.member_2.y)) {
                let _e153 = params.member.member_2.member;
                if (_e153 == 0u) {
                    phi_297_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_297_ = array<u32, 2>(1u, 1u);
                }
                let _e156 = phi_297_;
                let _e161 = params.member.member.member_2[_e156[1]];
                let _e163 = order.member[_e161];
                let _e164 = (_e163 - _e161);
                let _e167 = params.member.member_2.member;
                if (_e167 == 0u) {
                    phi_330_ = true;
                } else {
                    phi_330_ = (_e164 > _e81);
                }
                let _e171 = phi_330_;
                if _e171 {
                    let _e174 = params.member.member_1.member_3;
                    let _e176 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e176 + 1u) < _e176) {
                        let _e180 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e176 < _e174) {
                        let _e182 = (2u * _e176);
                        atomicStore((&pairs.member[(4u + _e182)]), _e81);
                        atomicStore((&pairs.member[(_e182 + 5u)]), _e164);
                    }
                }
            }
        }
        local_1 = type_32(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_400_ = type_9(0u, _e111);
        loop {
            let _e189 = phi_400_;
            if (_e189.member < _e189.member_1) {
                phi_401_ = type_9((_e189.member + 1u), _e189.member_1);
                phi_424_ = type_9(1u, _e189.member);
            } else {
                phi_401_ = _e189;
                phi_424_ = type_9(0u, type_9().member_1);
            }
            let _e201 = phi_401_;
            let _e203 = phi_424_;
            if (bitcast<i32>(_e203.member) != 0i) {
                let _e208 = local_1.member_3;
                if _e208 {
                    let _e210 = local_1.member_2;
                    let _e213 = oriented.member[(_e106 + _e210)];
                    let _e250 = ((_e83.member.x * 0.5f) + (_e83.member_1.y * 0.5f));
                    let _e251 = ((_e83.member.y * 0.5f) + (_e83.member_2.x * 0.5f));
                    let _e252 = ((_e83.member_1.x * 0.5f) + (_e83.member_2.y * 0.5f));
                    if (_e250 < _e83.member_1.y) {
                        phi_478_ = _e250;
                    } else {
                        phi_478_ = _e83.member_1.y;
                    }
                    let _e255 = phi_478_;
                    if (_e251 < _e83.member_2.x) {
                        phi_483_ = _e251;
                    } else {
                        phi_483_ = _e83.member_2.x;
                    }
                    let _e258 = phi_483_;
                    if (_e252 < _e83.member_2.y) {
                        phi_488_ = _e252;
                    } else {
                        phi_488_ = _e83.member_2.y;
                    }
                    let _e261 = phi_488_;
                    if (_e255 > _e83.member.x) {
                        phi_493_ = _e255;
                    } else {
                        phi_493_ = _e83.member.x;
                    }
                    let _e264 = phi_493_;
                    if (_e258 > _e83.member.y) {
                        phi_498_ = _e258;
                    } else {
                        phi_498_ = _e83.member.y;
                    }
                    let _e267 = phi_498_;
                    if (_e261 > _e83.member_1.x) {
                        phi_503_ = _e261;
                    } else {
                        phi_503_ = _e83.member_1.x;
                    }
                    let _e270 = phi_503_;
                    let _e271 = (_e83.member_1.y - _e264);
                    let _e272 = (_e83.member_2.x - _e267);
                    let _e273 = (_e83.member_2.y - _e270);
                    let _e274 = (_e264 - _e83.member.x);
                    let _e275 = (_e267 - _e83.member.y);
                    let _e276 = (_e270 - _e83.member_1.x);
                    if (_e271 > _e274) {
                        phi_514_ = _e271;
                    } else {
                        phi_514_ = _e274;
                    }
                    let _e279 = phi_514_;
                    if (_e272 > _e275) {
                        phi_519_ = _e272;
                    } else {
                        phi_519_ = _e275;
                    }
                    let _e282 = phi_519_;
                    if (_e273 > _e276) {
                        phi_524_ = _e273;
                    } else {
                        phi_524_ = _e276;
                    }
                    let _e285 = phi_524_;
                    let _e287 = (1f + (0.000000059604645f * 4f));
                    let _e291 = (0.000000000000000000000000000000000000011754944f * 8f);
                    let _e292 = ((_e279 * _e287) + _e291);
                    let _e293 = ((_e282 * _e287) + _e291);
                    let _e294 = ((_e285 * _e287) + _e291);
                    let _e295 = (_e213.member.x - _e264);
                    let _e296 = (_e213.member.y - _e267);
                    let _e297 = (_e213.member.z - _e270);
                    if (_e295 < 0f) {
                        phi_564_ = -(_e295);
                    } else {
                        phi_564_ = _e295;
                    }
                    let _e316 = phi_564_;
                    if (_e296 < 0f) {
                        phi_570_ = -(_e296);
                    } else {
                        phi_570_ = _e296;
                    }
                    let _e320 = phi_570_;
                    if (_e297 < 0f) {
                        phi_577_ = -(_e297);
                    } else {
                        phi_577_ = _e297;
                    }
                    let _e325 = phi_577_;
                    if (_e292 < 0f) {
                        phi_584_ = -(_e292);
                    } else {
                        phi_584_ = _e292;
                    }
                    let _e330 = phi_584_;
                    if (_e293 < 0f) {
                        phi_590_ = -(_e293);
                    } else {
                        phi_590_ = _e293;
                    }
                    let _e334 = phi_590_;
                    if (_e294 < 0f) {
                        phi_597_ = -(_e294);
                    } else {
                        phi_597_ = _e294;
                    }
                    let _e339 = phi_597_;
                    if (_e213.member_3.x < 0f) {
                        phi_604_ = -(_e213.member_3.x);
                    } else {
                        phi_604_ = _e213.member_3.x;
                    }
                    let _e344 = phi_604_;
                    if (_e213.member_3.y < 0f) {
                        phi_610_ = -(_e213.member_3.y);
                    } else {
                        phi_610_ = _e213.member_3.y;
                    }
                    let _e348 = phi_610_;
                    if (_e213.member_3.z < 0f) {
                        phi_617_ = -(_e213.member_3.z);
                    } else {
                        phi_617_ = _e213.member_3.z;
                    }
                    let _e353 = phi_617_;
                    local = type_26(array<array<f32, 3>, 3>(array<f32, 3>(_e213.member.w, _e213.member_1.z, _e213.member_2.y), array<f32, 3>(_e213.member_1.x, _e213.member_1.w, _e213.member_2.z), array<f32, 3>(_e213.member_1.y, _e213.member_2.x, _e213.member_2.w)), array<f32, 3>(_e295, _e296, _e297), array<f32, 3>((((_e213.member.w * _e295) + (_e213.member_1.x * _e296)) + (_e213.member_1.y * _e297)), (((_e213.member_1.z * _e295) + (_e213.member_1.w * _e296)) + (_e213.member_2.x * _e297)), (((_e213.member_2.y * _e295) + (_e213.member_2.z * _e296)) + (_e213.member_2.w * _e297))), array<f32, 3>(_e292, _e293, _e294), array<f32, 3>(_e213.member_3.x, _e213.member_3.y, _e213.member_3.z), ((((((_e316 + _e320) + _e325) + (((_e330 + _e334) + _e339) + ((_e344 + _e348) + _e353))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e374 = local.member[0u][0u];
                    let _e378 = local.member[0u][1u];
                    let _e382 = local.member[0u][2u];
                    let _e386 = local.member[1u][0u];
                    let _e390 = local.member[1u][1u];
                    let _e394 = local.member[1u][2u];
                    let _e398 = local.member[2u][0u];
                    let _e402 = local.member[2u][1u];
                    let _e406 = local.member[2u][2u];
                    let _e408 = local.member_3;
                    let _e413 = local.member_4;
                    let _e419 = local.member_1[0u];
                    if (_e419 < 0f) {
                        phi_710_ = -(_e419);
                    } else {
                        phi_710_ = _e419;
                    }
                    let _e423 = phi_710_;
                    if (_e374 < 0f) {
                        phi_717_ = -(_e374);
                    } else {
                        phi_717_ = _e374;
                    }
                    let _e427 = phi_717_;
                    if (_e378 < 0f) {
                        phi_723_ = -(_e378);
                    } else {
                        phi_723_ = _e378;
                    }
                    let _e431 = phi_723_;
                    if (_e382 < 0f) {
                        phi_729_ = -(_e382);
                    } else {
                        phi_729_ = _e382;
                    }
                    let _e435 = phi_729_;
                    let _e442 = (_e423 - (_e408[0] + (((_e427 * _e413[0]) + (_e431 * _e413[1])) + (_e435 * _e413[2]))));
                    let _e445 = local.member_1[1u];
                    if (_e445 < 0f) {
                        phi_748_ = -(_e445);
                    } else {
                        phi_748_ = _e445;
                    }
                    let _e449 = phi_748_;
                    if (_e386 < 0f) {
                        phi_755_ = -(_e386);
                    } else {
                        phi_755_ = _e386;
                    }
                    let _e453 = phi_755_;
                    if (_e390 < 0f) {
                        phi_761_ = -(_e390);
                    } else {
                        phi_761_ = _e390;
                    }
                    let _e457 = phi_761_;
                    if (_e394 < 0f) {
                        phi_767_ = -(_e394);
                    } else {
                        phi_767_ = _e394;
                    }
                    let _e461 = phi_767_;
                    let _e468 = (_e449 - (_e408[1] + (((_e453 * _e413[0]) + (_e457 * _e413[1])) + (_e461 * _e413[2]))));
                    let _e471 = local.member_1[2u];
                    if (_e471 < 0f) {
                        phi_786_ = -(_e471);
                    } else {
                        phi_786_ = _e471;
                    }
                    let _e475 = phi_786_;
                    if (_e398 < 0f) {
                        phi_793_ = -(_e398);
                    } else {
                        phi_793_ = _e398;
                    }
                    let _e479 = phi_793_;
                    if (_e402 < 0f) {
                        phi_799_ = -(_e402);
                    } else {
                        phi_799_ = _e402;
                    }
                    let _e483 = phi_799_;
                    if (_e406 < 0f) {
                        phi_805_ = -(_e406);
                    } else {
                        phi_805_ = _e406;
                    }
                    let _e487 = phi_805_;
                    let _e494 = (_e475 - (_e408[2] + (((_e479 * _e413[0]) + (_e483 * _e413[1])) + (_e487 * _e413[2]))));
                    let _e497 = local.member_2[0u];
                    if (_e497 < 0f) {
                        phi_824_ = -(_e497);
                    } else {
                        phi_824_ = _e497;
                    }
                    let _e501 = phi_824_;
                    if (_e374 < 0f) {
                        phi_831_ = -(_e374);
                    } else {
                        phi_831_ = _e374;
                    }
                    let _e505 = phi_831_;
                    if (_e386 < 0f) {
                        phi_837_ = -(_e386);
                    } else {
                        phi_837_ = _e386;
                    }
                    let _e509 = phi_837_;
                    if (_e398 < 0f) {
                        phi_843_ = -(_e398);
                    } else {
                        phi_843_ = _e398;
                    }
                    let _e513 = phi_843_;
                    let _e520 = (_e501 - (_e413[0] + (((_e505 * _e408[0]) + (_e509 * _e408[1])) + (_e513 * _e408[2]))));
                    let _e523 = local.member_2[1u];
                    if (_e523 < 0f) {
                        phi_862_ = -(_e523);
                    } else {
                        phi_862_ = _e523;
                    }
                    let _e527 = phi_862_;
                    if (_e378 < 0f) {
                        phi_869_ = -(_e378);
                    } else {
                        phi_869_ = _e378;
                    }
                    let _e531 = phi_869_;
                    if (_e390 < 0f) {
                        phi_875_ = -(_e390);
                    } else {
                        phi_875_ = _e390;
                    }
                    let _e535 = phi_875_;
                    if (_e402 < 0f) {
                        phi_881_ = -(_e402);
                    } else {
                        phi_881_ = _e402;
                    }
                    let _e539 = phi_881_;
                    let _e546 = (_e527 - (_e413[1] + (((_e531 * _e408[0]) + (_e535 * _e408[1])) + (_e539 * _e408[2]))));
                    let _e549 = local.member_2[2u];
                    if (_e549 < 0f) {
                        phi_900_ = -(_e549);
                    } else {
                        phi_900_ = _e549;
                    }
                    let _e553 = phi_900_;
                    if (_e382 < 0f) {
                        phi_907_ = -(_e382);
                    } else {
                        phi_907_ = _e382;
                    }
                    let _e557 = phi_907_;
                    if (_e394 < 0f) {
                        phi_913_ = -(_e394);
                    } else {
                        phi_913_ = _e394;
                    }
                    let _e561 = phi_913_;
                    if (_e406 < 0f) {
                        phi_919_ = -(_e406);
                    } else {
                        phi_919_ = _e406;
                    }
                    let _e565 = phi_919_;
                    let _e572 = (_e553 - (_e413[2] + (((_e557 * _e408[0]) + (_e561 * _e408[1])) + (_e565 * _e408[2]))));
                    if (_e442 > _e468) {
                        phi_934_ = _e442;
                    } else {
                        phi_934_ = _e468;
                    }
                    let _e575 = phi_934_;
                    if (_e575 > _e494) {
                        phi_939_ = _e575;
                    } else {
                        phi_939_ = _e494;
                    }
                    let _e578 = phi_939_;
                    if (_e520 > _e546) {
                        phi_944_ = _e520;
                    } else {
                        phi_944_ = _e546;
                    }
                    let _e581 = phi_944_;
                    if (_e581 > _e572) {
                        phi_949_ = _e581;
                    } else {
                        phi_949_ = _e572;
                    }
                    let _e584 = phi_949_;
                    if (_e578 > _e584) {
                        phi_954_ = _e578;
                    } else {
                        phi_954_ = _e584;
                    }
                    let _e587 = phi_954_;
                    let _e589 = local.member_5;
                    if (_e587 > _e589) {
                        phi_2267_ = true;
                    } else {
                        let _e594 = local.member[1u][0u];
                        let _e597 = local.member_1[2u];
                        let _e602 = local.member[2u][0u];
                        let _e605 = local.member_1[1u];
                        let _e607 = ((_e594 * _e597) - (_e602 * _e605));
                        let _e611 = local.member[2u][0u];
                        if (_e611 < 0f) {
                            phi_1013_ = -(_e611);
                        } else {
                            phi_1013_ = _e611;
                        }
                        let _e615 = phi_1013_;
                        let _e618 = local.member_3[1u];
                        let _e623 = local.member[1u][0u];
                        if (_e623 < 0f) {
                            phi_1036_ = -(_e623);
                        } else {
                            phi_1036_ = _e623;
                        }
                        let _e627 = phi_1036_;
                        let _e630 = local.member_3[2u];
                        let _e636 = local.member[0u][2u];
                        if (_e636 < 0f) {
                            phi_1059_ = -(_e636);
                        } else {
                            phi_1059_ = _e636;
                        }
                        let _e640 = phi_1059_;
                        let _e643 = local.member_4[1u];
                        let _e648 = local.member[0u][1u];
                        if (_e648 < 0f) {
                            phi_1081_ = -(_e648);
                        } else {
                            phi_1081_ = _e648;
                        }
                        let _e652 = phi_1081_;
                        let _e655 = local.member_4[2u];
                        if (_e607 < 0f) {
                            phi_1097_ = -(_e607);
                        } else {
                            phi_1097_ = _e607;
                        }
                        let _e661 = phi_1097_;
                        let _e663 = (_e661 - (((_e615 * _e618) + (_e627 * _e630)) + ((_e640 * _e643) + (_e652 * _e655))));
                        let _e667 = local.member[1u][1u];
                        let _e670 = local.member_1[2u];
                        let _e675 = local.member[2u][1u];
                        let _e678 = local.member_1[1u];
                        let _e680 = ((_e667 * _e670) - (_e675 * _e678));
                        let _e684 = local.member[2u][1u];
                        if (_e684 < 0f) {
                            phi_1152_ = -(_e684);
                        } else {
                            phi_1152_ = _e684;
                        }
                        let _e688 = phi_1152_;
                        let _e691 = local.member_3[1u];
                        let _e696 = local.member[1u][1u];
                        if (_e696 < 0f) {
                            phi_1175_ = -(_e696);
                        } else {
                            phi_1175_ = _e696;
                        }
                        let _e700 = phi_1175_;
                        let _e703 = local.member_3[2u];
                        let _e709 = local.member[0u][0u];
                        if (_e709 < 0f) {
                            phi_1198_ = -(_e709);
                        } else {
                            phi_1198_ = _e709;
                        }
                        let _e713 = phi_1198_;
                        let _e716 = local.member_4[2u];
                        let _e721 = local.member[0u][2u];
                        if (_e721 < 0f) {
                            phi_1220_ = -(_e721);
                        } else {
                            phi_1220_ = _e721;
                        }
                        let _e725 = phi_1220_;
                        let _e728 = local.member_4[0u];
                        if (_e680 < 0f) {
                            phi_1236_ = -(_e680);
                        } else {
                            phi_1236_ = _e680;
                        }
                        let _e734 = phi_1236_;
                        let _e736 = (_e734 - (((_e688 * _e691) + (_e700 * _e703)) + ((_e713 * _e716) + (_e725 * _e728))));
                        let _e740 = local.member[1u][2u];
                        let _e743 = local.member_1[2u];
                        let _e748 = local.member[2u][2u];
                        let _e751 = local.member_1[1u];
                        let _e753 = ((_e740 * _e743) - (_e748 * _e751));
                        let _e757 = local.member[2u][2u];
                        if (_e757 < 0f) {
                            phi_1291_ = -(_e757);
                        } else {
                            phi_1291_ = _e757;
                        }
                        let _e761 = phi_1291_;
                        let _e764 = local.member_3[1u];
                        let _e769 = local.member[1u][2u];
                        if (_e769 < 0f) {
                            phi_1314_ = -(_e769);
                        } else {
                            phi_1314_ = _e769;
                        }
                        let _e773 = phi_1314_;
                        let _e776 = local.member_3[2u];
                        let _e782 = local.member[0u][1u];
                        if (_e782 < 0f) {
                            phi_1337_ = -(_e782);
                        } else {
                            phi_1337_ = _e782;
                        }
                        let _e786 = phi_1337_;
                        let _e789 = local.member_4[0u];
                        let _e794 = local.member[0u][0u];
                        if (_e794 < 0f) {
                            phi_1359_ = -(_e794);
                        } else {
                            phi_1359_ = _e794;
                        }
                        let _e798 = phi_1359_;
                        let _e801 = local.member_4[1u];
                        if (_e753 < 0f) {
                            phi_1375_ = -(_e753);
                        } else {
                            phi_1375_ = _e753;
                        }
                        let _e807 = phi_1375_;
                        let _e809 = (_e807 - (((_e761 * _e764) + (_e773 * _e776)) + ((_e786 * _e789) + (_e798 * _e801))));
                        let _e813 = local.member[2u][0u];
                        let _e816 = local.member_1[0u];
                        let _e821 = local.member[0u][0u];
                        let _e824 = local.member_1[2u];
                        let _e826 = ((_e813 * _e816) - (_e821 * _e824));
                        let _e830 = local.member[0u][0u];
                        if (_e830 < 0f) {
                            phi_1430_ = -(_e830);
                        } else {
                            phi_1430_ = _e830;
                        }
                        let _e834 = phi_1430_;
                        let _e837 = local.member_3[2u];
                        let _e842 = local.member[2u][0u];
                        if (_e842 < 0f) {
                            phi_1453_ = -(_e842);
                        } else {
                            phi_1453_ = _e842;
                        }
                        let _e846 = phi_1453_;
                        let _e849 = local.member_3[0u];
                        let _e855 = local.member[1u][2u];
                        if (_e855 < 0f) {
                            phi_1477_ = -(_e855);
                        } else {
                            phi_1477_ = _e855;
                        }
                        let _e859 = phi_1477_;
                        let _e862 = local.member_4[1u];
                        let _e867 = local.member[1u][1u];
                        if (_e867 < 0f) {
                            phi_1500_ = -(_e867);
                        } else {
                            phi_1500_ = _e867;
                        }
                        let _e871 = phi_1500_;
                        let _e874 = local.member_4[2u];
                        if (_e826 < 0f) {
                            phi_1516_ = -(_e826);
                        } else {
                            phi_1516_ = _e826;
                        }
                        let _e880 = phi_1516_;
                        let _e882 = (_e880 - (((_e834 * _e837) + (_e846 * _e849)) + ((_e859 * _e862) + (_e871 * _e874))));
                        let _e886 = local.member[2u][1u];
                        let _e889 = local.member_1[0u];
                        let _e894 = local.member[0u][1u];
                        let _e897 = local.member_1[2u];
                        let _e899 = ((_e886 * _e889) - (_e894 * _e897));
                        let _e903 = local.member[0u][1u];
                        if (_e903 < 0f) {
                            phi_1571_ = -(_e903);
                        } else {
                            phi_1571_ = _e903;
                        }
                        let _e907 = phi_1571_;
                        let _e910 = local.member_3[2u];
                        let _e915 = local.member[2u][1u];
                        if (_e915 < 0f) {
                            phi_1594_ = -(_e915);
                        } else {
                            phi_1594_ = _e915;
                        }
                        let _e919 = phi_1594_;
                        let _e922 = local.member_3[0u];
                        let _e928 = local.member[1u][0u];
                        if (_e928 < 0f) {
                            phi_1618_ = -(_e928);
                        } else {
                            phi_1618_ = _e928;
                        }
                        let _e932 = phi_1618_;
                        let _e935 = local.member_4[2u];
                        let _e940 = local.member[1u][2u];
                        if (_e940 < 0f) {
                            phi_1641_ = -(_e940);
                        } else {
                            phi_1641_ = _e940;
                        }
                        let _e944 = phi_1641_;
                        let _e947 = local.member_4[0u];
                        if (_e899 < 0f) {
                            phi_1657_ = -(_e899);
                        } else {
                            phi_1657_ = _e899;
                        }
                        let _e953 = phi_1657_;
                        let _e955 = (_e953 - (((_e907 * _e910) + (_e919 * _e922)) + ((_e932 * _e935) + (_e944 * _e947))));
                        let _e959 = local.member[2u][2u];
                        let _e962 = local.member_1[0u];
                        let _e967 = local.member[0u][2u];
                        let _e970 = local.member_1[2u];
                        let _e972 = ((_e959 * _e962) - (_e967 * _e970));
                        let _e976 = local.member[0u][2u];
                        if (_e976 < 0f) {
                            phi_1712_ = -(_e976);
                        } else {
                            phi_1712_ = _e976;
                        }
                        let _e980 = phi_1712_;
                        let _e983 = local.member_3[2u];
                        let _e988 = local.member[2u][2u];
                        if (_e988 < 0f) {
                            phi_1735_ = -(_e988);
                        } else {
                            phi_1735_ = _e988;
                        }
                        let _e992 = phi_1735_;
                        let _e995 = local.member_3[0u];
                        let _e1001 = local.member[1u][1u];
                        if (_e1001 < 0f) {
                            phi_1759_ = -(_e1001);
                        } else {
                            phi_1759_ = _e1001;
                        }
                        let _e1005 = phi_1759_;
                        let _e1008 = local.member_4[0u];
                        let _e1013 = local.member[1u][0u];
                        if (_e1013 < 0f) {
                            phi_1782_ = -(_e1013);
                        } else {
                            phi_1782_ = _e1013;
                        }
                        let _e1017 = phi_1782_;
                        let _e1020 = local.member_4[1u];
                        if (_e972 < 0f) {
                            phi_1798_ = -(_e972);
                        } else {
                            phi_1798_ = _e972;
                        }
                        let _e1026 = phi_1798_;
                        let _e1028 = (_e1026 - (((_e980 * _e983) + (_e992 * _e995)) + ((_e1005 * _e1008) + (_e1017 * _e1020))));
                        let _e1032 = local.member[0u][0u];
                        let _e1035 = local.member_1[1u];
                        let _e1040 = local.member[1u][0u];
                        let _e1043 = local.member_1[0u];
                        let _e1045 = ((_e1032 * _e1035) - (_e1040 * _e1043));
                        let _e1049 = local.member[1u][0u];
                        if (_e1049 < 0f) {
                            phi_1853_ = -(_e1049);
                        } else {
                            phi_1853_ = _e1049;
                        }
                        let _e1053 = phi_1853_;
                        let _e1056 = local.member_3[0u];
                        let _e1061 = local.member[0u][0u];
                        if (_e1061 < 0f) {
                            phi_1876_ = -(_e1061);
                        } else {
                            phi_1876_ = _e1061;
                        }
                        let _e1065 = phi_1876_;
                        let _e1068 = local.member_3[1u];
                        let _e1074 = local.member[2u][2u];
                        if (_e1074 < 0f) {
                            phi_1900_ = -(_e1074);
                        } else {
                            phi_1900_ = _e1074;
                        }
                        let _e1078 = phi_1900_;
                        let _e1081 = local.member_4[1u];
                        let _e1086 = local.member[2u][1u];
                        if (_e1086 < 0f) {
                            phi_1923_ = -(_e1086);
                        } else {
                            phi_1923_ = _e1086;
                        }
                        let _e1090 = phi_1923_;
                        let _e1093 = local.member_4[2u];
                        if (_e1045 < 0f) {
                            phi_1939_ = -(_e1045);
                        } else {
                            phi_1939_ = _e1045;
                        }
                        let _e1099 = phi_1939_;
                        let _e1101 = (_e1099 - (((_e1053 * _e1056) + (_e1065 * _e1068)) + ((_e1078 * _e1081) + (_e1090 * _e1093))));
                        let _e1105 = local.member[0u][1u];
                        let _e1108 = local.member_1[1u];
                        let _e1113 = local.member[1u][1u];
                        let _e1116 = local.member_1[0u];
                        let _e1118 = ((_e1105 * _e1108) - (_e1113 * _e1116));
                        let _e1122 = local.member[1u][1u];
                        if (_e1122 < 0f) {
                            phi_1994_ = -(_e1122);
                        } else {
                            phi_1994_ = _e1122;
                        }
                        let _e1126 = phi_1994_;
                        let _e1129 = local.member_3[0u];
                        let _e1134 = local.member[0u][1u];
                        if (_e1134 < 0f) {
                            phi_2017_ = -(_e1134);
                        } else {
                            phi_2017_ = _e1134;
                        }
                        let _e1138 = phi_2017_;
                        let _e1141 = local.member_3[1u];
                        let _e1147 = local.member[2u][0u];
                        if (_e1147 < 0f) {
                            phi_2041_ = -(_e1147);
                        } else {
                            phi_2041_ = _e1147;
                        }
                        let _e1151 = phi_2041_;
                        let _e1154 = local.member_4[2u];
                        let _e1159 = local.member[2u][2u];
                        if (_e1159 < 0f) {
                            phi_2064_ = -(_e1159);
                        } else {
                            phi_2064_ = _e1159;
                        }
                        let _e1163 = phi_2064_;
                        let _e1166 = local.member_4[0u];
                        if (_e1118 < 0f) {
                            phi_2080_ = -(_e1118);
                        } else {
                            phi_2080_ = _e1118;
                        }
                        let _e1172 = phi_2080_;
                        let _e1174 = (_e1172 - (((_e1126 * _e1129) + (_e1138 * _e1141)) + ((_e1151 * _e1154) + (_e1163 * _e1166))));
                        let _e1178 = local.member[0u][2u];
                        let _e1181 = local.member_1[1u];
                        let _e1186 = local.member[1u][2u];
                        let _e1189 = local.member_1[0u];
                        let _e1191 = ((_e1178 * _e1181) - (_e1186 * _e1189));
                        let _e1195 = local.member[1u][2u];
                        if (_e1195 < 0f) {
                            phi_2135_ = -(_e1195);
                        } else {
                            phi_2135_ = _e1195;
                        }
                        let _e1199 = phi_2135_;
                        let _e1202 = local.member_3[0u];
                        let _e1207 = local.member[0u][2u];
                        if (_e1207 < 0f) {
                            phi_2158_ = -(_e1207);
                        } else {
                            phi_2158_ = _e1207;
                        }
                        let _e1211 = phi_2158_;
                        let _e1214 = local.member_3[1u];
                        let _e1220 = local.member[2u][1u];
                        if (_e1220 < 0f) {
                            phi_2182_ = -(_e1220);
                        } else {
                            phi_2182_ = _e1220;
                        }
                        let _e1224 = phi_2182_;
                        let _e1227 = local.member_4[0u];
                        let _e1232 = local.member[2u][0u];
                        if (_e1232 < 0f) {
                            phi_2205_ = -(_e1232);
                        } else {
                            phi_2205_ = _e1232;
                        }
                        let _e1236 = phi_2205_;
                        let _e1239 = local.member_4[1u];
                        if (_e1191 < 0f) {
                            phi_2221_ = -(_e1191);
                        } else {
                            phi_2221_ = _e1191;
                        }
                        let _e1245 = phi_2221_;
                        let _e1247 = (_e1245 - (((_e1199 * _e1202) + (_e1211 * _e1214)) + ((_e1224 * _e1227) + (_e1236 * _e1239))));
                        if (_e663 > _e736) {
                            phi_2228_ = _e663;
                        } else {
                            phi_2228_ = _e736;
                        }
                        let _e1250 = phi_2228_;
                        if (_e1250 > _e809) {
                            phi_2233_ = _e1250;
                        } else {
                            phi_2233_ = _e809;
                        }
                        let _e1253 = phi_2233_;
                        if (_e882 > _e955) {
                            phi_2238_ = _e882;
                        } else {
                            phi_2238_ = _e955;
                        }
                        let _e1256 = phi_2238_;
                        if (_e1256 > _e1028) {
                            phi_2243_ = _e1256;
                        } else {
                            phi_2243_ = _e1028;
                        }
                        let _e1259 = phi_2243_;
                        if (_e1253 > _e1259) {
                            phi_2248_ = _e1253;
                        } else {
                            phi_2248_ = _e1259;
                        }
                        let _e1262 = phi_2248_;
                        if (_e1101 > _e1174) {
                            phi_2253_ = _e1101;
                        } else {
                            phi_2253_ = _e1174;
                        }
                        let _e1265 = phi_2253_;
                        if (_e1265 > _e1247) {
                            phi_2258_ = _e1265;
                        } else {
                            phi_2258_ = _e1247;
                        }
                        let _e1268 = phi_2258_;
                        if (_e1262 > _e1268) {
                            phi_2263_ = _e1262;
                        } else {
                            phi_2263_ = _e1268;
                        }
                        let _e1271 = phi_2263_;
                        let _e1273 = local.member_5;
                        phi_2267_ = (_e1271 > _e1273);
                    }
                    let _e1276 = phi_2267_;
                    if !(_e1276) {
                        let _e1293 = local_1.member_2;
                        let _e1295 = nodes.member[_e1293];
                        let _e1340 = ((((((bitcast<f32>(_e1295.member.x) <= _e83.member_1.y) && (_e83.member.x <= bitcast<f32>(_e1295.member_1.x))) && (bitcast<f32>(_e1295.member.y) <= _e83.member_2.x)) && (_e83.member.y <= bitcast<f32>(_e1295.member_1.y))) && (bitcast<f32>(_e1295.member.z) <= _e83.member_2.y)) && (_e83.member_1.x <= bitcast<f32>(_e1295.member_1.z)));
                        let _e1351 = ((((((bitcast<f32>(_e1295.member_2.x) <= _e83.member_1.y) && (_e83.member.x <= bitcast<f32>(_e1295.member_3.x))) && (bitcast<f32>(_e1295.member_2.y) <= _e83.member_2.x)) && (_e83.member.y <= bitcast<f32>(_e1295.member_3.y))) && (bitcast<f32>(_e1295.member_2.z) <= _e83.member_2.y)) && (_e83.member_1.x <= bitcast<f32>(_e1295.member_3.z)));
                        let _e1353 = ((_e1295.member.w & 2147483648u) != 0u);
                        let _e1355 = ((_e1295.member_1.w & 2147483648u) != 0u);
                        if _e1340 {
                            if _e1353 {
                                phi_2375_ = (_e1295.member.w & 2147483647u);
                                phi_2376_ = false;
                            } else {
                                phi_2375_ = u32();
                                phi_2376_ = true;
                            }
                            let _e1358 = phi_2375_;
                            let _e1360 = phi_2376_;
                            phi_2377_ = _e1358;
                            phi_2378_ = _e1360;
                        } else {
                            phi_2377_ = u32();
                            phi_2378_ = true;
                        }
                        let _e1362 = phi_2377_;
                        let _e1364 = phi_2378_;
                        if _e1364 {
                            phi_2382_ = 4294967295u;
                        } else {
                            phi_2382_ = _e1362;
                        }
                        let _e1366 = phi_2382_;
                        if _e1351 {
                            if _e1355 {
                                phi_2390_ = (_e1295.member_1.w & 2147483647u);
                                phi_2391_ = false;
                            } else {
                                phi_2390_ = u32();
                                phi_2391_ = true;
                            }
                            let _e1369 = phi_2390_;
                            let _e1371 = phi_2391_;
                            phi_2392_ = _e1369;
                            phi_2393_ = _e1371;
                        } else {
                            phi_2392_ = u32();
                            phi_2393_ = true;
                        }
                        let _e1373 = phi_2392_;
                        let _e1375 = phi_2393_;
                        if _e1375 {
                            phi_2397_ = 4294967295u;
                        } else {
                            phi_2397_ = _e1373;
                        }
                        let _e1377 = phi_2397_;
                        if _e1340 {
                            phi_2402_ = !(_e1353);
                        } else {
                            phi_2402_ = false;
                        }
                        let _e1380 = phi_2402_;
                        if _e1351 {
                            phi_2407_ = !(_e1355);
                        } else {
                            phi_2407_ = false;
                        }
                        let _e1383 = phi_2407_;
                        if _e1380 {
                            if _e1383 {
                                let _e1385 = ((_e1295.member_3.w & 2147483648u) != 0u);
                                if _e1385 {
                                    phi_2419_ = _e1295.member_1.w;
                                } else {
                                    phi_2419_ = _e1295.member.w;
                                }
                                let _e1387 = phi_2419_;
                                let _e1389 = local_1.member_1;
                                local_1.member[_e1389] = _e1387;
                                let _e1394 = local_1.member_1;
                                local_1.member_1 = (_e1394 + 1u);
                                if _e1385 {
                                    phi_2435_ = _e1295.member.w;
                                } else {
                                    phi_2435_ = _e1295.member_1.w;
                                }
                                let _e1397 = phi_2435_;
                                local_1.member_2 = _e1397;
                                phi_2437_ = false;
                            } else {
                                phi_2437_ = true;
                            }
                            let _e1400 = phi_2437_;
                            phi_2438_ = _e1400;
                        } else {
                            phi_2438_ = true;
                        }
                        let _e1402 = phi_2438_;
                        if _e1402 {
                            if _e1380 {
                                local_1.member_2 = _e1295.member.w;
                            } else {
                                if _e1383 {
                                    local_1.member_2 = _e1295.member_1.w;
                                } else {
                                    let _e1404 = local_1.member_1;
                                    if (_e1404 > 0u) {
                                        let _e1409 = local_1.member_1;
                                        local_1.member_1 = (_e1409 - 1u);
                                        let _e1412 = local_1.member_1;
                                        let _e1415 = local_1.member[_e1412];
                                        local_1.member_2 = _e1415;
                                    } else {
                                        local_1.member_3 = false;
                                    }
                                }
                            }
                        }
                        if (_e1366 != 4294967295u) {
                            let _e1422 = params.member.member_2.member;
                            if (_e1422 == 0u) {
                                phi_2484_ = array<u32, 2>(0u, 2u);
                            } else {
                                phi_2484_ = array<u32, 2>(1u, 1u);
                            }
                            let _e1425 = phi_2484_;
                            let _e1430 = params.member.member.member_2[_e1425[1]];
                            let _e1433 = order.member[(_e1430 + _e1366)];
                            let _e1434 = (_e1433 - _e1430);
                            let _e1437 = params.member.member_2.member;
                            if (_e1437 == 0u) {
                                phi_2517_ = true;
                            } else {
                                phi_2517_ = (_e1434 > _e81);
                            }
                            let _e1441 = phi_2517_;
                            if _e1441 {
                                let _e1444 = params.member.member_1.member_3;
                                let _e1446 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1446 + 1u) < _e1446) {
                                    let _e1450 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1446 < _e1444) {
                                    let _e1452 = (2u * _e1446);
                                    atomicStore((&pairs.member[(4u + _e1452)]), _e81);
                                    atomicStore((&pairs.member[(_e1452 + 5u)]), _e1434);
                                }
                            }
                        }
                        if (_e1377 != 4294967295u) {
                            let _e1460 = params.member.member_2.member;
                            if (_e1460 == 0u) {
                                phi_2560_ = array<u32, 2>(0u, 2u);
                            } else {
                                phi_2560_ = array<u32, 2>(1u, 1u);
                            }
                            let _e1463 = phi_2560_;
                            let _e1468 = params.member.member.member_2[_e1463[1]];
                            let _e1471 = order.member[(_e1468 + _e1377)];
                            let _e1472 = (_e1471 - _e1468);
                            let _e1475 = params.member.member_2.member;
                            if (_e1475 == 0u) {
                                phi_2593_ = true;
                            } else {
                                phi_2593_ = (_e1472 > _e81);
                            }
                            let _e1479 = phi_2593_;
                            if _e1479 {
                                let _e1482 = params.member.member_1.member_3;
                                let _e1484 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1484 + 1u) < _e1484) {
                                    let _e1488 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1484 < _e1482) {
                                    let _e1490 = (2u * _e1484);
                                    atomicStore((&pairs.member[(4u + _e1490)]), _e81);
                                    atomicStore((&pairs.member[(_e1490 + 5u)]), _e1472);
                                }
                            }
                        }
                    } else {
                        let _e1279 = local_1.member_1;
                        if (_e1279 > 0u) {
                            let _e1284 = local_1.member_1;
                            local_1.member_1 = (_e1284 - 1u);
                            let _e1287 = local_1.member_1;
                            let _e1290 = local_1.member[_e1287];
                            local_1.member_2 = _e1290;
                        } else {
                            local_1.member_3 = false;
                        }
                    }
                }
                phi_2644_ = _e208;
            } else {
                phi_2644_ = false;
            }
            let _e1496 = phi_2644_;
            continue;
            continuing {
                phi_400_ = _e201;
                break if !(_e1496);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_full_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
