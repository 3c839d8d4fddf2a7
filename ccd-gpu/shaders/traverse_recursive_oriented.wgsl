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
    member_4: bool,
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
    var phi_402_: type_9;
    var phi_403_: type_9;
    var phi_426_: type_9;
    var phi_486_: f32;
    var phi_491_: f32;
    var phi_496_: f32;
    var phi_501_: f32;
    var phi_506_: f32;
    var phi_511_: f32;
    var phi_522_: f32;
    var phi_527_: f32;
    var phi_532_: f32;
    var phi_572_: f32;
    var phi_578_: f32;
    var phi_585_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_605_: f32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_625_: f32;
    var phi_718_: f32;
    var phi_725_: f32;
    var phi_731_: f32;
    var phi_737_: f32;
    var phi_756_: f32;
    var phi_763_: f32;
    var phi_769_: f32;
    var phi_775_: f32;
    var phi_794_: f32;
    var phi_801_: f32;
    var phi_807_: f32;
    var phi_813_: f32;
    var phi_832_: f32;
    var phi_839_: f32;
    var phi_845_: f32;
    var phi_851_: f32;
    var phi_870_: f32;
    var phi_877_: f32;
    var phi_883_: f32;
    var phi_889_: f32;
    var phi_908_: f32;
    var phi_915_: f32;
    var phi_921_: f32;
    var phi_927_: f32;
    var phi_942_: f32;
    var phi_947_: f32;
    var phi_952_: f32;
    var phi_957_: f32;
    var phi_962_: f32;
    var phi_1021_: f32;
    var phi_1044_: f32;
    var phi_1067_: f32;
    var phi_1089_: f32;
    var phi_1105_: f32;
    var phi_1160_: f32;
    var phi_1183_: f32;
    var phi_1206_: f32;
    var phi_1228_: f32;
    var phi_1244_: f32;
    var phi_1299_: f32;
    var phi_1322_: f32;
    var phi_1345_: f32;
    var phi_1367_: f32;
    var phi_1383_: f32;
    var phi_1438_: f32;
    var phi_1461_: f32;
    var phi_1485_: f32;
    var phi_1508_: f32;
    var phi_1524_: f32;
    var phi_1579_: f32;
    var phi_1602_: f32;
    var phi_1626_: f32;
    var phi_1649_: f32;
    var phi_1665_: f32;
    var phi_1720_: f32;
    var phi_1743_: f32;
    var phi_1767_: f32;
    var phi_1790_: f32;
    var phi_1806_: f32;
    var phi_1861_: f32;
    var phi_1884_: f32;
    var phi_1908_: f32;
    var phi_1931_: f32;
    var phi_1947_: f32;
    var phi_2002_: f32;
    var phi_2025_: f32;
    var phi_2049_: f32;
    var phi_2072_: f32;
    var phi_2088_: f32;
    var phi_2143_: f32;
    var phi_2166_: f32;
    var phi_2190_: f32;
    var phi_2213_: f32;
    var phi_2229_: f32;
    var phi_2236_: f32;
    var phi_2241_: f32;
    var phi_2246_: f32;
    var phi_2251_: f32;
    var phi_2256_: f32;
    var phi_2261_: f32;
    var phi_2266_: f32;
    var phi_2271_: f32;
    var phi_2275_: bool;
    var phi_2302_: bool;
    var phi_2357_: u32;
    var phi_2383_: bool;
    var phi_2413_: bool;
    var phi_2452_: u32;
    var phi_2453_: bool;
    var phi_2454_: u32;
    var phi_2455_: bool;
    var phi_2459_: u32;
    var phi_2473_: array<u32, 2>;
    var phi_2506_: bool;
    var phi_2536_: bool;
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
        local_1 = type_32(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, false, true);
        phi_402_ = type_9(0u, (2u * _e111));
        loop {
            let _e190 = phi_402_;
            if (_e190.member < _e190.member_1) {
                phi_403_ = type_9((_e190.member + 1u), _e190.member_1);
                phi_426_ = type_9(1u, _e190.member);
            } else {
                phi_403_ = _e190;
                phi_426_ = type_9(0u, type_9().member_1);
            }
            let _e202 = phi_403_;
            let _e204 = phi_426_;
            if (bitcast<i32>(_e204.member) != 0i) {
                let _e209 = local_1.member_4;
                if _e209 {
                    let _e211 = local_1.member_3;
                    if !(_e211) {
                        let _e214 = local_1.member_2;
                        let _e217 = oriented.member[(_e106 + _e214)];
                        let _e254 = ((_e83.member.x * 0.5f) + (_e83.member_1.y * 0.5f));
                        let _e255 = ((_e83.member.y * 0.5f) + (_e83.member_2.x * 0.5f));
                        let _e256 = ((_e83.member_1.x * 0.5f) + (_e83.member_2.y * 0.5f));
                        if (_e254 < _e83.member_1.y) {
                            phi_486_ = _e254;
                        } else {
                            phi_486_ = _e83.member_1.y;
                        }
                        let _e259 = phi_486_;
                        if (_e255 < _e83.member_2.x) {
                            phi_491_ = _e255;
                        } else {
                            phi_491_ = _e83.member_2.x;
                        }
                        let _e262 = phi_491_;
                        if (_e256 < _e83.member_2.y) {
                            phi_496_ = _e256;
                        } else {
                            phi_496_ = _e83.member_2.y;
                        }
                        let _e265 = phi_496_;
                        if (_e259 > _e83.member.x) {
                            phi_501_ = _e259;
                        } else {
                            phi_501_ = _e83.member.x;
                        }
                        let _e268 = phi_501_;
                        if (_e262 > _e83.member.y) {
                            phi_506_ = _e262;
                        } else {
                            phi_506_ = _e83.member.y;
                        }
                        let _e271 = phi_506_;
                        if (_e265 > _e83.member_1.x) {
                            phi_511_ = _e265;
                        } else {
                            phi_511_ = _e83.member_1.x;
                        }
                        let _e274 = phi_511_;
                        let _e275 = (_e83.member_1.y - _e268);
                        let _e276 = (_e83.member_2.x - _e271);
                        let _e277 = (_e83.member_2.y - _e274);
                        let _e278 = (_e268 - _e83.member.x);
                        let _e279 = (_e271 - _e83.member.y);
                        let _e280 = (_e274 - _e83.member_1.x);
                        if (_e275 > _e278) {
                            phi_522_ = _e275;
                        } else {
                            phi_522_ = _e278;
                        }
                        let _e283 = phi_522_;
                        if (_e276 > _e279) {
                            phi_527_ = _e276;
                        } else {
                            phi_527_ = _e279;
                        }
                        let _e286 = phi_527_;
                        if (_e277 > _e280) {
                            phi_532_ = _e277;
                        } else {
                            phi_532_ = _e280;
                        }
                        let _e289 = phi_532_;
                        let _e291 = (1f + (0.000000059604645f * 4f));
                        let _e295 = (0.000000000000000000000000000000000000011754944f * 8f);
                        let _e296 = ((_e283 * _e291) + _e295);
                        let _e297 = ((_e286 * _e291) + _e295);
                        let _e298 = ((_e289 * _e291) + _e295);
                        let _e299 = (_e217.member.x - _e268);
                        let _e300 = (_e217.member.y - _e271);
                        let _e301 = (_e217.member.z - _e274);
                        if (_e299 < 0f) {
                            phi_572_ = -(_e299);
                        } else {
                            phi_572_ = _e299;
                        }
                        let _e320 = phi_572_;
                        if (_e300 < 0f) {
                            phi_578_ = -(_e300);
                        } else {
                            phi_578_ = _e300;
                        }
                        let _e324 = phi_578_;
                        if (_e301 < 0f) {
                            phi_585_ = -(_e301);
                        } else {
                            phi_585_ = _e301;
                        }
                        let _e329 = phi_585_;
                        if (_e296 < 0f) {
                            phi_592_ = -(_e296);
                        } else {
                            phi_592_ = _e296;
                        }
                        let _e334 = phi_592_;
                        if (_e297 < 0f) {
                            phi_598_ = -(_e297);
                        } else {
                            phi_598_ = _e297;
                        }
                        let _e338 = phi_598_;
                        if (_e298 < 0f) {
                            phi_605_ = -(_e298);
                        } else {
                            phi_605_ = _e298;
                        }
                        let _e343 = phi_605_;
                        if (_e217.member_3.x < 0f) {
                            phi_612_ = -(_e217.member_3.x);
                        } else {
                            phi_612_ = _e217.member_3.x;
                        }
                        let _e348 = phi_612_;
                        if (_e217.member_3.y < 0f) {
                            phi_618_ = -(_e217.member_3.y);
                        } else {
                            phi_618_ = _e217.member_3.y;
                        }
                        let _e352 = phi_618_;
                        if (_e217.member_3.z < 0f) {
                            phi_625_ = -(_e217.member_3.z);
                        } else {
                            phi_625_ = _e217.member_3.z;
                        }
                        let _e357 = phi_625_;
                        local = type_26(array<array<f32, 3>, 3>(array<f32, 3>(_e217.member.w, _e217.member_1.z, _e217.member_2.y), array<f32, 3>(_e217.member_1.x, _e217.member_1.w, _e217.member_2.z), array<f32, 3>(_e217.member_1.y, _e217.member_2.x, _e217.member_2.w)), array<f32, 3>(_e299, _e300, _e301), array<f32, 3>((((_e217.member.w * _e299) + (_e217.member_1.x * _e300)) + (_e217.member_1.y * _e301)), (((_e217.member_1.z * _e299) + (_e217.member_1.w * _e300)) + (_e217.member_2.x * _e301)), (((_e217.member_2.y * _e299) + (_e217.member_2.z * _e300)) + (_e217.member_2.w * _e301))), array<f32, 3>(_e296, _e297, _e298), array<f32, 3>(_e217.member_3.x, _e217.member_3.y, _e217.member_3.z), ((((((_e320 + _e324) + _e329) + (((_e334 + _e338) + _e343) + ((_e348 + _e352) + _e357))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                        let _e378 = local.member[0u][0u];
                        let _e382 = local.member[0u][1u];
                        let _e386 = local.member[0u][2u];
                        let _e390 = local.member[1u][0u];
                        let _e394 = local.member[1u][1u];
                        let _e398 = local.member[1u][2u];
                        let _e402 = local.member[2u][0u];
                        let _e406 = local.member[2u][1u];
                        let _e410 = local.member[2u][2u];
                        let _e412 = local.member_3;
                        let _e417 = local.member_4;
                        let _e423 = local.member_1[0u];
                        if (_e423 < 0f) {
                            phi_718_ = -(_e423);
                        } else {
                            phi_718_ = _e423;
                        }
                        let _e427 = phi_718_;
                        if (_e378 < 0f) {
                            phi_725_ = -(_e378);
                        } else {
                            phi_725_ = _e378;
                        }
                        let _e431 = phi_725_;
                        if (_e382 < 0f) {
                            phi_731_ = -(_e382);
                        } else {
                            phi_731_ = _e382;
                        }
                        let _e435 = phi_731_;
                        if (_e386 < 0f) {
                            phi_737_ = -(_e386);
                        } else {
                            phi_737_ = _e386;
                        }
                        let _e439 = phi_737_;
                        let _e446 = (_e427 - (_e412[0] + (((_e431 * _e417[0]) + (_e435 * _e417[1])) + (_e439 * _e417[2]))));
                        let _e449 = local.member_1[1u];
                        if (_e449 < 0f) {
                            phi_756_ = -(_e449);
                        } else {
                            phi_756_ = _e449;
                        }
                        let _e453 = phi_756_;
                        if (_e390 < 0f) {
                            phi_763_ = -(_e390);
                        } else {
                            phi_763_ = _e390;
                        }
                        let _e457 = phi_763_;
                        if (_e394 < 0f) {
                            phi_769_ = -(_e394);
                        } else {
                            phi_769_ = _e394;
                        }
                        let _e461 = phi_769_;
                        if (_e398 < 0f) {
                            phi_775_ = -(_e398);
                        } else {
                            phi_775_ = _e398;
                        }
                        let _e465 = phi_775_;
                        let _e472 = (_e453 - (_e412[1] + (((_e457 * _e417[0]) + (_e461 * _e417[1])) + (_e465 * _e417[2]))));
                        let _e475 = local.member_1[2u];
                        if (_e475 < 0f) {
                            phi_794_ = -(_e475);
                        } else {
                            phi_794_ = _e475;
                        }
                        let _e479 = phi_794_;
                        if (_e402 < 0f) {
                            phi_801_ = -(_e402);
                        } else {
                            phi_801_ = _e402;
                        }
                        let _e483 = phi_801_;
                        if (_e406 < 0f) {
                            phi_807_ = -(_e406);
                        } else {
                            phi_807_ = _e406;
                        }
                        let _e487 = phi_807_;
                        if (_e410 < 0f) {
                            phi_813_ = -(_e410);
                        } else {
                            phi_813_ = _e410;
                        }
                        let _e491 = phi_813_;
                        let _e498 = (_e479 - (_e412[2] + (((_e483 * _e417[0]) + (_e487 * _e417[1])) + (_e491 * _e417[2]))));
                        let _e501 = local.member_2[0u];
                        if (_e501 < 0f) {
                            phi_832_ = -(_e501);
                        } else {
                            phi_832_ = _e501;
                        }
                        let _e505 = phi_832_;
                        if (_e378 < 0f) {
                            phi_839_ = -(_e378);
                        } else {
                            phi_839_ = _e378;
                        }
                        let _e509 = phi_839_;
                        if (_e390 < 0f) {
                            phi_845_ = -(_e390);
                        } else {
                            phi_845_ = _e390;
                        }
                        let _e513 = phi_845_;
                        if (_e402 < 0f) {
                            phi_851_ = -(_e402);
                        } else {
                            phi_851_ = _e402;
                        }
                        let _e517 = phi_851_;
                        let _e524 = (_e505 - (_e417[0] + (((_e509 * _e412[0]) + (_e513 * _e412[1])) + (_e517 * _e412[2]))));
                        let _e527 = local.member_2[1u];
                        if (_e527 < 0f) {
                            phi_870_ = -(_e527);
                        } else {
                            phi_870_ = _e527;
                        }
                        let _e531 = phi_870_;
                        if (_e382 < 0f) {
                            phi_877_ = -(_e382);
                        } else {
                            phi_877_ = _e382;
                        }
                        let _e535 = phi_877_;
                        if (_e394 < 0f) {
                            phi_883_ = -(_e394);
                        } else {
                            phi_883_ = _e394;
                        }
                        let _e539 = phi_883_;
                        if (_e406 < 0f) {
                            phi_889_ = -(_e406);
                        } else {
                            phi_889_ = _e406;
                        }
                        let _e543 = phi_889_;
                        let _e550 = (_e531 - (_e417[1] + (((_e535 * _e412[0]) + (_e539 * _e412[1])) + (_e543 * _e412[2]))));
                        let _e553 = local.member_2[2u];
                        if (_e553 < 0f) {
                            phi_908_ = -(_e553);
                        } else {
                            phi_908_ = _e553;
                        }
                        let _e557 = phi_908_;
                        if (_e386 < 0f) {
                            phi_915_ = -(_e386);
                        } else {
                            phi_915_ = _e386;
                        }
                        let _e561 = phi_915_;
                        if (_e398 < 0f) {
                            phi_921_ = -(_e398);
                        } else {
                            phi_921_ = _e398;
                        }
                        let _e565 = phi_921_;
                        if (_e410 < 0f) {
                            phi_927_ = -(_e410);
                        } else {
                            phi_927_ = _e410;
                        }
                        let _e569 = phi_927_;
                        let _e576 = (_e557 - (_e417[2] + (((_e561 * _e412[0]) + (_e565 * _e412[1])) + (_e569 * _e412[2]))));
                        if (_e446 > _e472) {
                            phi_942_ = _e446;
                        } else {
                            phi_942_ = _e472;
                        }
                        let _e579 = phi_942_;
                        if (_e579 > _e498) {
                            phi_947_ = _e579;
                        } else {
                            phi_947_ = _e498;
                        }
                        let _e582 = phi_947_;
                        if (_e524 > _e550) {
                            phi_952_ = _e524;
                        } else {
                            phi_952_ = _e550;
                        }
                        let _e585 = phi_952_;
                        if (_e585 > _e576) {
                            phi_957_ = _e585;
                        } else {
                            phi_957_ = _e576;
                        }
                        let _e588 = phi_957_;
                        if (_e582 > _e588) {
                            phi_962_ = _e582;
                        } else {
                            phi_962_ = _e588;
                        }
                        let _e591 = phi_962_;
                        let _e593 = local.member_5;
                        if (_e591 > _e593) {
                            phi_2275_ = true;
                        } else {
                            let _e598 = local.member[1u][0u];
                            let _e601 = local.member_1[2u];
                            let _e606 = local.member[2u][0u];
                            let _e609 = local.member_1[1u];
                            let _e611 = ((_e598 * _e601) - (_e606 * _e609));
                            let _e615 = local.member[2u][0u];
                            if (_e615 < 0f) {
                                phi_1021_ = -(_e615);
                            } else {
                                phi_1021_ = _e615;
                            }
                            let _e619 = phi_1021_;
                            let _e622 = local.member_3[1u];
                            let _e627 = local.member[1u][0u];
                            if (_e627 < 0f) {
                                phi_1044_ = -(_e627);
                            } else {
                                phi_1044_ = _e627;
                            }
                            let _e631 = phi_1044_;
                            let _e634 = local.member_3[2u];
                            let _e640 = local.member[0u][2u];
                            if (_e640 < 0f) {
                                phi_1067_ = -(_e640);
                            } else {
                                phi_1067_ = _e640;
                            }
                            let _e644 = phi_1067_;
                            let _e647 = local.member_4[1u];
                            let _e652 = local.member[0u][1u];
                            if (_e652 < 0f) {
                                phi_1089_ = -(_e652);
                            } else {
                                phi_1089_ = _e652;
                            }
                            let _e656 = phi_1089_;
                            let _e659 = local.member_4[2u];
                            if (_e611 < 0f) {
                                phi_1105_ = -(_e611);
                            } else {
                                phi_1105_ = _e611;
                            }
                            let _e665 = phi_1105_;
                            let _e667 = (_e665 - (((_e619 * _e622) + (_e631 * _e634)) + ((_e644 * _e647) + (_e656 * _e659))));
                            let _e671 = local.member[1u][1u];
                            let _e674 = local.member_1[2u];
                            let _e679 = local.member[2u][1u];
                            let _e682 = local.member_1[1u];
                            let _e684 = ((_e671 * _e674) - (_e679 * _e682));
                            let _e688 = local.member[2u][1u];
                            if (_e688 < 0f) {
                                phi_1160_ = -(_e688);
                            } else {
                                phi_1160_ = _e688;
                            }
                            let _e692 = phi_1160_;
                            let _e695 = local.member_3[1u];
                            let _e700 = local.member[1u][1u];
                            if (_e700 < 0f) {
                                phi_1183_ = -(_e700);
                            } else {
                                phi_1183_ = _e700;
                            }
                            let _e704 = phi_1183_;
                            let _e707 = local.member_3[2u];
                            let _e713 = local.member[0u][0u];
                            if (_e713 < 0f) {
                                phi_1206_ = -(_e713);
                            } else {
                                phi_1206_ = _e713;
                            }
                            let _e717 = phi_1206_;
                            let _e720 = local.member_4[2u];
                            let _e725 = local.member[0u][2u];
                            if (_e725 < 0f) {
                                phi_1228_ = -(_e725);
                            } else {
                                phi_1228_ = _e725;
                            }
                            let _e729 = phi_1228_;
                            let _e732 = local.member_4[0u];
                            if (_e684 < 0f) {
                                phi_1244_ = -(_e684);
                            } else {
                                phi_1244_ = _e684;
                            }
                            let _e738 = phi_1244_;
                            let _e740 = (_e738 - (((_e692 * _e695) + (_e704 * _e707)) + ((_e717 * _e720) + (_e729 * _e732))));
                            let _e744 = local.member[1u][2u];
                            let _e747 = local.member_1[2u];
                            let _e752 = local.member[2u][2u];
                            let _e755 = local.member_1[1u];
                            let _e757 = ((_e744 * _e747) - (_e752 * _e755));
                            let _e761 = local.member[2u][2u];
                            if (_e761 < 0f) {
                                phi_1299_ = -(_e761);
                            } else {
                                phi_1299_ = _e761;
                            }
                            let _e765 = phi_1299_;
                            let _e768 = local.member_3[1u];
                            let _e773 = local.member[1u][2u];
                            if (_e773 < 0f) {
                                phi_1322_ = -(_e773);
                            } else {
                                phi_1322_ = _e773;
                            }
                            let _e777 = phi_1322_;
                            let _e780 = local.member_3[2u];
                            let _e786 = local.member[0u][1u];
                            if (_e786 < 0f) {
                                phi_1345_ = -(_e786);
                            } else {
                                phi_1345_ = _e786;
                            }
                            let _e790 = phi_1345_;
                            let _e793 = local.member_4[0u];
                            let _e798 = local.member[0u][0u];
                            if (_e798 < 0f) {
                                phi_1367_ = -(_e798);
                            } else {
                                phi_1367_ = _e798;
                            }
                            let _e802 = phi_1367_;
                            let _e805 = local.member_4[1u];
                            if (_e757 < 0f) {
                                phi_1383_ = -(_e757);
                            } else {
                                phi_1383_ = _e757;
                            }
                            let _e811 = phi_1383_;
                            let _e813 = (_e811 - (((_e765 * _e768) + (_e777 * _e780)) + ((_e790 * _e793) + (_e802 * _e805))));
                            let _e817 = local.member[2u][0u];
                            let _e820 = local.member_1[0u];
                            let _e825 = local.member[0u][0u];
                            let _e828 = local.member_1[2u];
                            let _e830 = ((_e817 * _e820) - (_e825 * _e828));
                            let _e834 = local.member[0u][0u];
                            if (_e834 < 0f) {
                                phi_1438_ = -(_e834);
                            } else {
                                phi_1438_ = _e834;
                            }
                            let _e838 = phi_1438_;
                            let _e841 = local.member_3[2u];
                            let _e846 = local.member[2u][0u];
                            if (_e846 < 0f) {
                                phi_1461_ = -(_e846);
                            } else {
                                phi_1461_ = _e846;
                            }
                            let _e850 = phi_1461_;
                            let _e853 = local.member_3[0u];
                            let _e859 = local.member[1u][2u];
                            if (_e859 < 0f) {
                                phi_1485_ = -(_e859);
                            } else {
                                phi_1485_ = _e859;
                            }
                            let _e863 = phi_1485_;
                            let _e866 = local.member_4[1u];
                            let _e871 = local.member[1u][1u];
                            if (_e871 < 0f) {
                                phi_1508_ = -(_e871);
                            } else {
                                phi_1508_ = _e871;
                            }
                            let _e875 = phi_1508_;
                            let _e878 = local.member_4[2u];
                            if (_e830 < 0f) {
                                phi_1524_ = -(_e830);
                            } else {
                                phi_1524_ = _e830;
                            }
                            let _e884 = phi_1524_;
                            let _e886 = (_e884 - (((_e838 * _e841) + (_e850 * _e853)) + ((_e863 * _e866) + (_e875 * _e878))));
                            let _e890 = local.member[2u][1u];
                            let _e893 = local.member_1[0u];
                            let _e898 = local.member[0u][1u];
                            let _e901 = local.member_1[2u];
                            let _e903 = ((_e890 * _e893) - (_e898 * _e901));
                            let _e907 = local.member[0u][1u];
                            if (_e907 < 0f) {
                                phi_1579_ = -(_e907);
                            } else {
                                phi_1579_ = _e907;
                            }
                            let _e911 = phi_1579_;
                            let _e914 = local.member_3[2u];
                            let _e919 = local.member[2u][1u];
                            if (_e919 < 0f) {
                                phi_1602_ = -(_e919);
                            } else {
                                phi_1602_ = _e919;
                            }
                            let _e923 = phi_1602_;
                            let _e926 = local.member_3[0u];
                            let _e932 = local.member[1u][0u];
                            if (_e932 < 0f) {
                                phi_1626_ = -(_e932);
                            } else {
                                phi_1626_ = _e932;
                            }
                            let _e936 = phi_1626_;
                            let _e939 = local.member_4[2u];
                            let _e944 = local.member[1u][2u];
                            if (_e944 < 0f) {
                                phi_1649_ = -(_e944);
                            } else {
                                phi_1649_ = _e944;
                            }
                            let _e948 = phi_1649_;
                            let _e951 = local.member_4[0u];
                            if (_e903 < 0f) {
                                phi_1665_ = -(_e903);
                            } else {
                                phi_1665_ = _e903;
                            }
                            let _e957 = phi_1665_;
                            let _e959 = (_e957 - (((_e911 * _e914) + (_e923 * _e926)) + ((_e936 * _e939) + (_e948 * _e951))));
                            let _e963 = local.member[2u][2u];
                            let _e966 = local.member_1[0u];
                            let _e971 = local.member[0u][2u];
                            let _e974 = local.member_1[2u];
                            let _e976 = ((_e963 * _e966) - (_e971 * _e974));
                            let _e980 = local.member[0u][2u];
                            if (_e980 < 0f) {
                                phi_1720_ = -(_e980);
                            } else {
                                phi_1720_ = _e980;
                            }
                            let _e984 = phi_1720_;
                            let _e987 = local.member_3[2u];
                            let _e992 = local.member[2u][2u];
                            if (_e992 < 0f) {
                                phi_1743_ = -(_e992);
                            } else {
                                phi_1743_ = _e992;
                            }
                            let _e996 = phi_1743_;
                            let _e999 = local.member_3[0u];
                            let _e1005 = local.member[1u][1u];
                            if (_e1005 < 0f) {
                                phi_1767_ = -(_e1005);
                            } else {
                                phi_1767_ = _e1005;
                            }
                            let _e1009 = phi_1767_;
                            let _e1012 = local.member_4[0u];
                            let _e1017 = local.member[1u][0u];
                            if (_e1017 < 0f) {
                                phi_1790_ = -(_e1017);
                            } else {
                                phi_1790_ = _e1017;
                            }
                            let _e1021 = phi_1790_;
                            let _e1024 = local.member_4[1u];
                            if (_e976 < 0f) {
                                phi_1806_ = -(_e976);
                            } else {
                                phi_1806_ = _e976;
                            }
                            let _e1030 = phi_1806_;
                            let _e1032 = (_e1030 - (((_e984 * _e987) + (_e996 * _e999)) + ((_e1009 * _e1012) + (_e1021 * _e1024))));
                            let _e1036 = local.member[0u][0u];
                            let _e1039 = local.member_1[1u];
                            let _e1044 = local.member[1u][0u];
                            let _e1047 = local.member_1[0u];
                            let _e1049 = ((_e1036 * _e1039) - (_e1044 * _e1047));
                            let _e1053 = local.member[1u][0u];
                            if (_e1053 < 0f) {
                                phi_1861_ = -(_e1053);
                            } else {
                                phi_1861_ = _e1053;
                            }
                            let _e1057 = phi_1861_;
                            let _e1060 = local.member_3[0u];
                            let _e1065 = local.member[0u][0u];
                            if (_e1065 < 0f) {
                                phi_1884_ = -(_e1065);
                            } else {
                                phi_1884_ = _e1065;
                            }
                            let _e1069 = phi_1884_;
                            let _e1072 = local.member_3[1u];
                            let _e1078 = local.member[2u][2u];
                            if (_e1078 < 0f) {
                                phi_1908_ = -(_e1078);
                            } else {
                                phi_1908_ = _e1078;
                            }
                            let _e1082 = phi_1908_;
                            let _e1085 = local.member_4[1u];
                            let _e1090 = local.member[2u][1u];
                            if (_e1090 < 0f) {
                                phi_1931_ = -(_e1090);
                            } else {
                                phi_1931_ = _e1090;
                            }
                            let _e1094 = phi_1931_;
                            let _e1097 = local.member_4[2u];
                            if (_e1049 < 0f) {
                                phi_1947_ = -(_e1049);
                            } else {
                                phi_1947_ = _e1049;
                            }
                            let _e1103 = phi_1947_;
                            let _e1105 = (_e1103 - (((_e1057 * _e1060) + (_e1069 * _e1072)) + ((_e1082 * _e1085) + (_e1094 * _e1097))));
                            let _e1109 = local.member[0u][1u];
                            let _e1112 = local.member_1[1u];
                            let _e1117 = local.member[1u][1u];
                            let _e1120 = local.member_1[0u];
                            let _e1122 = ((_e1109 * _e1112) - (_e1117 * _e1120));
                            let _e1126 = local.member[1u][1u];
                            if (_e1126 < 0f) {
                                phi_2002_ = -(_e1126);
                            } else {
                                phi_2002_ = _e1126;
                            }
                            let _e1130 = phi_2002_;
                            let _e1133 = local.member_3[0u];
                            let _e1138 = local.member[0u][1u];
                            if (_e1138 < 0f) {
                                phi_2025_ = -(_e1138);
                            } else {
                                phi_2025_ = _e1138;
                            }
                            let _e1142 = phi_2025_;
                            let _e1145 = local.member_3[1u];
                            let _e1151 = local.member[2u][0u];
                            if (_e1151 < 0f) {
                                phi_2049_ = -(_e1151);
                            } else {
                                phi_2049_ = _e1151;
                            }
                            let _e1155 = phi_2049_;
                            let _e1158 = local.member_4[2u];
                            let _e1163 = local.member[2u][2u];
                            if (_e1163 < 0f) {
                                phi_2072_ = -(_e1163);
                            } else {
                                phi_2072_ = _e1163;
                            }
                            let _e1167 = phi_2072_;
                            let _e1170 = local.member_4[0u];
                            if (_e1122 < 0f) {
                                phi_2088_ = -(_e1122);
                            } else {
                                phi_2088_ = _e1122;
                            }
                            let _e1176 = phi_2088_;
                            let _e1178 = (_e1176 - (((_e1130 * _e1133) + (_e1142 * _e1145)) + ((_e1155 * _e1158) + (_e1167 * _e1170))));
                            let _e1182 = local.member[0u][2u];
                            let _e1185 = local.member_1[1u];
                            let _e1190 = local.member[1u][2u];
                            let _e1193 = local.member_1[0u];
                            let _e1195 = ((_e1182 * _e1185) - (_e1190 * _e1193));
                            let _e1199 = local.member[1u][2u];
                            if (_e1199 < 0f) {
                                phi_2143_ = -(_e1199);
                            } else {
                                phi_2143_ = _e1199;
                            }
                            let _e1203 = phi_2143_;
                            let _e1206 = local.member_3[0u];
                            let _e1211 = local.member[0u][2u];
                            if (_e1211 < 0f) {
                                phi_2166_ = -(_e1211);
                            } else {
                                phi_2166_ = _e1211;
                            }
                            let _e1215 = phi_2166_;
                            let _e1218 = local.member_3[1u];
                            let _e1224 = local.member[2u][1u];
                            if (_e1224 < 0f) {
                                phi_2190_ = -(_e1224);
                            } else {
                                phi_2190_ = _e1224;
                            }
                            let _e1228 = phi_2190_;
                            let _e1231 = local.member_4[0u];
                            let _e1236 = local.member[2u][0u];
                            if (_e1236 < 0f) {
                                phi_2213_ = -(_e1236);
                            } else {
                                phi_2213_ = _e1236;
                            }
                            let _e1240 = phi_2213_;
                            let _e1243 = local.member_4[1u];
                            if (_e1195 < 0f) {
                                phi_2229_ = -(_e1195);
                            } else {
                                phi_2229_ = _e1195;
                            }
                            let _e1249 = phi_2229_;
                            let _e1251 = (_e1249 - (((_e1203 * _e1206) + (_e1215 * _e1218)) + ((_e1228 * _e1231) + (_e1240 * _e1243))));
                            if (_e667 > _e740) {
                                phi_2236_ = _e667;
                            } else {
                                phi_2236_ = _e740;
                            }
                            let _e1254 = phi_2236_;
                            if (_e1254 > _e813) {
                                phi_2241_ = _e1254;
                            } else {
                                phi_2241_ = _e813;
                            }
                            let _e1257 = phi_2241_;
                            if (_e886 > _e959) {
                                phi_2246_ = _e886;
                            } else {
                                phi_2246_ = _e959;
                            }
                            let _e1260 = phi_2246_;
                            if (_e1260 > _e1032) {
                                phi_2251_ = _e1260;
                            } else {
                                phi_2251_ = _e1032;
                            }
                            let _e1263 = phi_2251_;
                            if (_e1257 > _e1263) {
                                phi_2256_ = _e1257;
                            } else {
                                phi_2256_ = _e1263;
                            }
                            let _e1266 = phi_2256_;
                            if (_e1105 > _e1178) {
                                phi_2261_ = _e1105;
                            } else {
                                phi_2261_ = _e1178;
                            }
                            let _e1269 = phi_2261_;
                            if (_e1269 > _e1251) {
                                phi_2266_ = _e1269;
                            } else {
                                phi_2266_ = _e1251;
                            }
                            let _e1272 = phi_2266_;
                            if (_e1266 > _e1272) {
                                phi_2271_ = _e1266;
                            } else {
                                phi_2271_ = _e1272;
                            }
                            let _e1275 = phi_2271_;
                            let _e1277 = local.member_5;
                            phi_2275_ = (_e1275 > _e1277);
                        }
                        let _e1280 = phi_2275_;
                        let _e1281 = !(_e1280);
                        if _e1281 {
                        } else {
                            let _e1283 = local_1.member_1;
                            if (_e1283 > 0u) {
                                let _e1288 = local_1.member_1;
                                local_1.member_1 = (_e1288 - 1u);
                                let _e1291 = local_1.member_1;
                                let _e1294 = local_1.member[_e1291];
                                local_1.member_2 = _e1294;
                                local_1.member_3 = true;
                            } else {
                                local_1.member_4 = false;
                            }
                        }
                        phi_2302_ = _e1281;
                    } else {
                        phi_2302_ = true;
                    }
                    let _e1298 = phi_2302_;
                    if _e1298 {
                        let _e1300 = local_1.member_2;
                        let _e1302 = nodes.member[_e1300];
                        let _e1340 = local_1.member_3;
                        let _e1341 = (((_e1302.member_3.w & 2147483648u) != 0u) != _e1340);
                        if _e1341 {
                            phi_2357_ = _e1302.member.w;
                        } else {
                            phi_2357_ = _e1302.member_1.w;
                        }
                        let _e1343 = phi_2357_;
                        if _e1341 {
                            phi_2383_ = ((((((bitcast<f32>(_e1302.member.x) <= _e83.member_1.y) && (_e83.member.x <= bitcast<f32>(_e1302.member_1.x))) && (bitcast<f32>(_e1302.member.y) <= _e83.member_2.x)) && (_e83.member.y <= bitcast<f32>(_e1302.member_1.y))) && (bitcast<f32>(_e1302.member.z) <= _e83.member_2.y)) && (_e83.member_1.x <= bitcast<f32>(_e1302.member_1.z)));
                        } else {
                            phi_2383_ = ((((((bitcast<f32>(_e1302.member_2.x) <= _e83.member_1.y) && (_e83.member.x <= bitcast<f32>(_e1302.member_3.x))) && (bitcast<f32>(_e1302.member_2.y) <= _e83.member_2.x)) && (_e83.member.y <= bitcast<f32>(_e1302.member_3.y))) && (bitcast<f32>(_e1302.member_2.z) <= _e83.member_2.y)) && (_e83.member_1.x <= bitcast<f32>(_e1302.member_3.z)));
                        }
                        let _e1367 = phi_2383_;
                        let _e1369 = ((_e1343 & 2147483648u) != 0u);
                        if _e1367 {
                            if _e1369 {
                            } else {
                                let _e1371 = local_1.member_3;
                                if _e1371 {
                                } else {
                                    let _e1373 = local_1.member_2;
                                    let _e1375 = local_1.member_1;
                                    local_1.member[_e1375] = _e1373;
                                    let _e1380 = local_1.member_1;
                                    local_1.member_1 = (_e1380 + 1u);
                                }
                                local_1.member_2 = _e1343;
                                local_1.member_3 = false;
                            }
                            phi_2413_ = _e1369;
                        } else {
                            phi_2413_ = true;
                        }
                        let _e1385 = phi_2413_;
                        if _e1385 {
                            let _e1387 = local_1.member_3;
                            if _e1387 {
                                let _e1390 = local_1.member_1;
                                if (_e1390 > 0u) {
                                    let _e1395 = local_1.member_1;
                                    local_1.member_1 = (_e1395 - 1u);
                                    let _e1398 = local_1.member_1;
                                    let _e1401 = local_1.member[_e1398];
                                    local_1.member_2 = _e1401;
                                    local_1.member_3 = true;
                                } else {
                                    local_1.member_4 = false;
                                }
                            } else {
                                local_1.member_3 = true;
                            }
                        }
                        if _e1367 {
                            if _e1369 {
                                phi_2452_ = (_e1343 & 2147483647u);
                                phi_2453_ = false;
                            } else {
                                phi_2452_ = u32();
                                phi_2453_ = true;
                            }
                            let _e1406 = phi_2452_;
                            let _e1408 = phi_2453_;
                            phi_2454_ = _e1406;
                            phi_2455_ = _e1408;
                        } else {
                            phi_2454_ = u32();
                            phi_2455_ = true;
                        }
                        let _e1410 = phi_2454_;
                        let _e1412 = phi_2455_;
                        if _e1412 {
                            phi_2459_ = 4294967295u;
                        } else {
                            phi_2459_ = _e1410;
                        }
                        let _e1414 = phi_2459_;
                        if (_e1414 != 4294967295u) {
                            let _e1418 = params.member.member_2.member;
                            if (_e1418 == 0u) {
                                phi_2473_ = array<u32, 2>(0u, 2u);
                            } else {
                                phi_2473_ = array<u32, 2>(1u, 1u);
                            }
                            let _e1421 = phi_2473_;
                            let _e1426 = params.member.member.member_2[_e1421[1]];
                            let _e1429 = order.member[(_e1426 + _e1414)];
                            let _e1430 = (_e1429 - _e1426);
                            let _e1433 = params.member.member_2.member;
                            if (_e1433 == 0u) {
                                phi_2506_ = true;
                            } else {
                                phi_2506_ = (_e1430 > _e81);
                            }
                            let _e1437 = phi_2506_;
                            if _e1437 {
                                let _e1440 = params.member.member_1.member_3;
                                let _e1442 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1442 + 1u) < _e1442) {
                                    let _e1446 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1442 < _e1440) {
                                    let _e1448 = (2u * _e1442);
                                    atomicStore((&pairs.member[(4u + _e1448)]), _e81);
                                    atomicStore((&pairs.member[(_e1448 + 5u)]), _e1430);
                                }
                            }
                        }
                    }
                }
                phi_2536_ = _e209;
            } else {
                phi_2536_ = false;
            }
            let _e1454 = phi_2536_;
            continue;
            continuing {
                phi_402_ = _e202;
                break if !(_e1454);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_recursive_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
