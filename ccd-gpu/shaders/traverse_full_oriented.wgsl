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
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_28 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_32 {
    member: array<type_30>,
}

struct type_35 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> boxes: type_20;
@group(0) @binding(2) 
var<storage> order: type_13;
@group(0) @binding(3) 
var<storage> nodes: type_23;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_35;
@group(0) @binding(4) 
var<storage> oriented: type_32;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_26;
    var phi_144_: array<u32, 2>;
    var phi_177_: u32;
    var phi_276_: array<u32, 2>;
    var phi_309_: bool;
    var phi_379_: type_9;
    var phi_380_: type_9;
    var phi_403_: type_9;
    var phi_463_: f32;
    var phi_468_: f32;
    var phi_473_: f32;
    var phi_513_: f32;
    var phi_519_: f32;
    var phi_526_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_546_: f32;
    var phi_553_: f32;
    var phi_559_: f32;
    var phi_566_: f32;
    var phi_659_: f32;
    var phi_666_: f32;
    var phi_672_: f32;
    var phi_678_: f32;
    var phi_697_: f32;
    var phi_704_: f32;
    var phi_710_: f32;
    var phi_716_: f32;
    var phi_735_: f32;
    var phi_742_: f32;
    var phi_748_: f32;
    var phi_754_: f32;
    var phi_773_: f32;
    var phi_780_: f32;
    var phi_786_: f32;
    var phi_792_: f32;
    var phi_811_: f32;
    var phi_818_: f32;
    var phi_824_: f32;
    var phi_830_: f32;
    var phi_849_: f32;
    var phi_856_: f32;
    var phi_862_: f32;
    var phi_868_: f32;
    var phi_883_: f32;
    var phi_888_: f32;
    var phi_893_: f32;
    var phi_898_: f32;
    var phi_903_: f32;
    var phi_962_: f32;
    var phi_985_: f32;
    var phi_1008_: f32;
    var phi_1030_: f32;
    var phi_1046_: f32;
    var phi_1101_: f32;
    var phi_1124_: f32;
    var phi_1147_: f32;
    var phi_1169_: f32;
    var phi_1185_: f32;
    var phi_1240_: f32;
    var phi_1263_: f32;
    var phi_1286_: f32;
    var phi_1308_: f32;
    var phi_1324_: f32;
    var phi_1379_: f32;
    var phi_1402_: f32;
    var phi_1426_: f32;
    var phi_1449_: f32;
    var phi_1465_: f32;
    var phi_1520_: f32;
    var phi_1543_: f32;
    var phi_1567_: f32;
    var phi_1590_: f32;
    var phi_1606_: f32;
    var phi_1661_: f32;
    var phi_1684_: f32;
    var phi_1708_: f32;
    var phi_1731_: f32;
    var phi_1747_: f32;
    var phi_1802_: f32;
    var phi_1825_: f32;
    var phi_1849_: f32;
    var phi_1872_: f32;
    var phi_1888_: f32;
    var phi_1943_: f32;
    var phi_1966_: f32;
    var phi_1990_: f32;
    var phi_2013_: f32;
    var phi_2029_: f32;
    var phi_2084_: f32;
    var phi_2107_: f32;
    var phi_2131_: f32;
    var phi_2154_: f32;
    var phi_2170_: f32;
    var phi_2177_: f32;
    var phi_2182_: f32;
    var phi_2187_: f32;
    var phi_2192_: f32;
    var phi_2197_: f32;
    var phi_2202_: f32;
    var phi_2207_: f32;
    var phi_2212_: f32;
    var phi_2216_: bool;
    var phi_2324_: u32;
    var phi_2325_: bool;
    var phi_2326_: u32;
    var phi_2327_: bool;
    var phi_2331_: u32;
    var phi_2339_: u32;
    var phi_2340_: bool;
    var phi_2341_: u32;
    var phi_2342_: bool;
    var phi_2346_: u32;
    var phi_2351_: bool;
    var phi_2356_: bool;
    var phi_2368_: u32;
    var phi_2384_: u32;
    var phi_2386_: bool;
    var phi_2387_: bool;
    var phi_2433_: array<u32, 2>;
    var phi_2466_: bool;
    var phi_2509_: array<u32, 2>;
    var phi_2542_: bool;
    var phi_2593_: bool;
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
        let _e68 = params.member.member.member_2[_e62[0]];
        let _e71 = params.member.member_1.member_1;
        let _e73 = ((_e68 + _e71) + _e52);
        let _e76 = params.member.member_2.member_1;
        if (_e76 == 0u) {
            phi_177_ = _e73;
        } else {
            let _e79 = order.member[_e73];
            phi_177_ = _e79;
        }
        let _e81 = phi_177_;
        let _e83 = boxes.member[_e81];
        let _e99 = params.member.member.member_2[_e62[0]];
        let _e100 = (_e81 - _e99);
        let _e104 = params.member.member.member_2[_e62[1]];
        let _e108 = params.member.member.member[_e62[1]];
        let _e109 = (_e108 - 1u);
        if (_e109 == 0u) {
            let _e112 = order.member[_e104];
            let _e114 = boxes.member[_e112];
            if ((((((_e114.member.x <= _e83.member_1.y) && (_e83.member.x <= _e114.member_1.y)) && (_e114.member.y <= _e83.member_2.x)) && (_e83.member.y <= _e114.member_2.x)) && (_e114.member_1.x <= _e83.member_2.y)) && (_e83.member_1.x <= _e114.member_2.y)) {
                let _e140 = params.member.member_2.member;
                if (_e140 == 0u) {
                    phi_276_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_276_ = array<u32, 2>(1u, 1u);
                }
                let _e143 = phi_276_;
                let _e148 = params.member.member.member_2[_e143[1]];
                let _e150 = order.member[_e148];
                let _e151 = (_e150 - _e148);
                let _e154 = params.member.member_2.member;
                if (_e154 == 0u) {
                    phi_309_ = true;
                } else {
                    phi_309_ = (_e151 > _e100);
                }
                let _e158 = phi_309_;
                if _e158 {
                    let _e161 = params.member.member_1.member_3;
                    let _e163 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e163 + 1u) < _e163) {
                        let _e167 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e163 < _e161) {
                        let _e169 = (2u * _e163);
                        atomicStore((&pairs.member[(4u + _e169)]), _e100);
                        atomicStore((&pairs.member[(_e169 + 5u)]), _e151);
                    }
                }
            }
        }
        local_1 = type_26(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_379_ = type_9(0u, _e109);
        loop {
            let _e176 = phi_379_;
            if (_e176.member < _e176.member_1) {
                phi_380_ = type_9((_e176.member + 1u), _e176.member_1);
                phi_403_ = type_9(1u, _e176.member);
            } else {
                phi_380_ = _e176;
                phi_403_ = type_9(0u, type_9().member_1);
            }
            let _e188 = phi_380_;
            let _e190 = phi_403_;
            if (bitcast<i32>(_e190.member) != 0i) {
                let _e195 = local_1.member_3;
                if _e195 {
                    let _e197 = local_1.member_2;
                    let _e200 = oriented.member[(_e104 + _e197)];
                    let _e237 = ((_e83.member.x * 0.5f) + (_e83.member_1.y * 0.5f));
                    let _e238 = ((_e83.member.y * 0.5f) + (_e83.member_2.x * 0.5f));
                    let _e239 = ((_e83.member_1.x * 0.5f) + (_e83.member_2.y * 0.5f));
                    let _e240 = (_e83.member_1.y - _e237);
                    let _e241 = (_e83.member_2.x - _e238);
                    let _e242 = (_e83.member_2.y - _e239);
                    let _e243 = (_e237 - _e83.member.x);
                    let _e244 = (_e238 - _e83.member.y);
                    let _e245 = (_e239 - _e83.member_1.x);
                    if (_e240 > _e243) {
                        phi_463_ = _e240;
                    } else {
                        phi_463_ = _e243;
                    }
                    let _e248 = phi_463_;
                    if (_e241 > _e244) {
                        phi_468_ = _e241;
                    } else {
                        phi_468_ = _e244;
                    }
                    let _e251 = phi_468_;
                    if (_e242 > _e245) {
                        phi_473_ = _e242;
                    } else {
                        phi_473_ = _e245;
                    }
                    let _e254 = phi_473_;
                    let _e256 = (1f + (0.000000059604645f * 4f));
                    let _e260 = (0.000000000000000000000000000000000000011754944f * 8f);
                    let _e261 = ((_e248 * _e256) + _e260);
                    let _e262 = ((_e251 * _e256) + _e260);
                    let _e263 = ((_e254 * _e256) + _e260);
                    let _e264 = (_e200.member.x - _e237);
                    let _e265 = (_e200.member.y - _e238);
                    let _e266 = (_e200.member.z - _e239);
                    if (_e264 < 0f) {
                        phi_513_ = -(_e264);
                    } else {
                        phi_513_ = _e264;
                    }
                    let _e285 = phi_513_;
                    if (_e265 < 0f) {
                        phi_519_ = -(_e265);
                    } else {
                        phi_519_ = _e265;
                    }
                    let _e289 = phi_519_;
                    if (_e266 < 0f) {
                        phi_526_ = -(_e266);
                    } else {
                        phi_526_ = _e266;
                    }
                    let _e294 = phi_526_;
                    if (_e261 < 0f) {
                        phi_533_ = -(_e261);
                    } else {
                        phi_533_ = _e261;
                    }
                    let _e299 = phi_533_;
                    if (_e262 < 0f) {
                        phi_539_ = -(_e262);
                    } else {
                        phi_539_ = _e262;
                    }
                    let _e303 = phi_539_;
                    if (_e263 < 0f) {
                        phi_546_ = -(_e263);
                    } else {
                        phi_546_ = _e263;
                    }
                    let _e308 = phi_546_;
                    if (_e200.member_3.x < 0f) {
                        phi_553_ = -(_e200.member_3.x);
                    } else {
                        phi_553_ = _e200.member_3.x;
                    }
                    let _e313 = phi_553_;
                    if (_e200.member_3.y < 0f) {
                        phi_559_ = -(_e200.member_3.y);
                    } else {
                        phi_559_ = _e200.member_3.y;
                    }
                    let _e317 = phi_559_;
                    if (_e200.member_3.z < 0f) {
                        phi_566_ = -(_e200.member_3.z);
                    } else {
                        phi_566_ = _e200.member_3.z;
                    }
                    let _e322 = phi_566_;
                    local = type_28(array<array<f32, 3>, 3>(array<f32, 3>(_e200.member.w, _e200.member_1.z, _e200.member_2.y), array<f32, 3>(_e200.member_1.x, _e200.member_1.w, _e200.member_2.z), array<f32, 3>(_e200.member_1.y, _e200.member_2.x, _e200.member_2.w)), array<f32, 3>(_e264, _e265, _e266), array<f32, 3>((((_e200.member.w * _e264) + (_e200.member_1.x * _e265)) + (_e200.member_1.y * _e266)), (((_e200.member_1.z * _e264) + (_e200.member_1.w * _e265)) + (_e200.member_2.x * _e266)), (((_e200.member_2.y * _e264) + (_e200.member_2.z * _e265)) + (_e200.member_2.w * _e266))), array<f32, 3>(_e261, _e262, _e263), array<f32, 3>(_e200.member_3.x, _e200.member_3.y, _e200.member_3.z), ((((((_e285 + _e289) + _e294) + (((_e299 + _e303) + _e308) + ((_e313 + _e317) + _e322))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e343 = local.member[0u][0u];
                    let _e347 = local.member[0u][1u];
                    let _e351 = local.member[0u][2u];
                    let _e355 = local.member[1u][0u];
                    let _e359 = local.member[1u][1u];
                    let _e363 = local.member[1u][2u];
                    let _e367 = local.member[2u][0u];
                    let _e371 = local.member[2u][1u];
                    let _e375 = local.member[2u][2u];
                    let _e377 = local.member_3;
                    let _e382 = local.member_4;
                    let _e388 = local.member_1[0u];
                    if (_e388 < 0f) {
                        phi_659_ = -(_e388);
                    } else {
                        phi_659_ = _e388;
                    }
                    let _e392 = phi_659_;
                    if (_e343 < 0f) {
                        phi_666_ = -(_e343);
                    } else {
                        phi_666_ = _e343;
                    }
                    let _e396 = phi_666_;
                    if (_e347 < 0f) {
                        phi_672_ = -(_e347);
                    } else {
                        phi_672_ = _e347;
                    }
                    let _e400 = phi_672_;
                    if (_e351 < 0f) {
                        phi_678_ = -(_e351);
                    } else {
                        phi_678_ = _e351;
                    }
                    let _e404 = phi_678_;
                    let _e411 = (_e392 - (_e377[0] + (((_e396 * _e382[0]) + (_e400 * _e382[1])) + (_e404 * _e382[2]))));
                    let _e414 = local.member_1[1u];
                    if (_e414 < 0f) {
                        phi_697_ = -(_e414);
                    } else {
                        phi_697_ = _e414;
                    }
                    let _e418 = phi_697_;
                    if (_e355 < 0f) {
                        phi_704_ = -(_e355);
                    } else {
                        phi_704_ = _e355;
                    }
                    let _e422 = phi_704_;
                    if (_e359 < 0f) {
                        phi_710_ = -(_e359);
                    } else {
                        phi_710_ = _e359;
                    }
                    let _e426 = phi_710_;
                    if (_e363 < 0f) {
                        phi_716_ = -(_e363);
                    } else {
                        phi_716_ = _e363;
                    }
                    let _e430 = phi_716_;
                    let _e437 = (_e418 - (_e377[1] + (((_e422 * _e382[0]) + (_e426 * _e382[1])) + (_e430 * _e382[2]))));
                    let _e440 = local.member_1[2u];
                    if (_e440 < 0f) {
                        phi_735_ = -(_e440);
                    } else {
                        phi_735_ = _e440;
                    }
                    let _e444 = phi_735_;
                    if (_e367 < 0f) {
                        phi_742_ = -(_e367);
                    } else {
                        phi_742_ = _e367;
                    }
                    let _e448 = phi_742_;
                    if (_e371 < 0f) {
                        phi_748_ = -(_e371);
                    } else {
                        phi_748_ = _e371;
                    }
                    let _e452 = phi_748_;
                    if (_e375 < 0f) {
                        phi_754_ = -(_e375);
                    } else {
                        phi_754_ = _e375;
                    }
                    let _e456 = phi_754_;
                    let _e463 = (_e444 - (_e377[2] + (((_e448 * _e382[0]) + (_e452 * _e382[1])) + (_e456 * _e382[2]))));
                    let _e466 = local.member_2[0u];
                    if (_e466 < 0f) {
                        phi_773_ = -(_e466);
                    } else {
                        phi_773_ = _e466;
                    }
                    let _e470 = phi_773_;
                    if (_e343 < 0f) {
                        phi_780_ = -(_e343);
                    } else {
                        phi_780_ = _e343;
                    }
                    let _e474 = phi_780_;
                    if (_e355 < 0f) {
                        phi_786_ = -(_e355);
                    } else {
                        phi_786_ = _e355;
                    }
                    let _e478 = phi_786_;
                    if (_e367 < 0f) {
                        phi_792_ = -(_e367);
                    } else {
                        phi_792_ = _e367;
                    }
                    let _e482 = phi_792_;
                    let _e489 = (_e470 - (_e382[0] + (((_e474 * _e377[0]) + (_e478 * _e377[1])) + (_e482 * _e377[2]))));
                    let _e492 = local.member_2[1u];
                    if (_e492 < 0f) {
                        phi_811_ = -(_e492);
                    } else {
                        phi_811_ = _e492;
                    }
                    let _e496 = phi_811_;
                    if (_e347 < 0f) {
                        phi_818_ = -(_e347);
                    } else {
                        phi_818_ = _e347;
                    }
                    let _e500 = phi_818_;
                    if (_e359 < 0f) {
                        phi_824_ = -(_e359);
                    } else {
                        phi_824_ = _e359;
                    }
                    let _e504 = phi_824_;
                    if (_e371 < 0f) {
                        phi_830_ = -(_e371);
                    } else {
                        phi_830_ = _e371;
                    }
                    let _e508 = phi_830_;
                    let _e515 = (_e496 - (_e382[1] + (((_e500 * _e377[0]) + (_e504 * _e377[1])) + (_e508 * _e377[2]))));
                    let _e518 = local.member_2[2u];
                    if (_e518 < 0f) {
                        phi_849_ = -(_e518);
                    } else {
                        phi_849_ = _e518;
                    }
                    let _e522 = phi_849_;
                    if (_e351 < 0f) {
                        phi_856_ = -(_e351);
                    } else {
                        phi_856_ = _e351;
                    }
                    let _e526 = phi_856_;
                    if (_e363 < 0f) {
                        phi_862_ = -(_e363);
                    } else {
                        phi_862_ = _e363;
                    }
                    let _e530 = phi_862_;
                    if (_e375 < 0f) {
                        phi_868_ = -(_e375);
                    } else {
                        phi_868_ = _e375;
                    }
                    let _e534 = phi_868_;
                    let _e541 = (_e522 - (_e382[2] + (((_e526 * _e377[0]) + (_e530 * _e377[1])) + (_e534 * _e377[2]))));
                    if (_e411 > _e437) {
                        phi_883_ = _e411;
                    } else {
                        phi_883_ = _e437;
                    }
                    let _e544 = phi_883_;
                    if (_e544 > _e463) {
                        phi_888_ = _e544;
                    } else {
                        phi_888_ = _e463;
                    }
                    let _e547 = phi_888_;
                    if (_e489 > _e515) {
                        phi_893_ = _e489;
                    } else {
                        phi_893_ = _e515;
                    }
                    let _e550 = phi_893_;
                    if (_e550 > _e541) {
                        phi_898_ = _e550;
                    } else {
                        phi_898_ = _e541;
                    }
                    let _e553 = phi_898_;
                    if (_e547 > _e553) {
                        phi_903_ = _e547;
                    } else {
                        phi_903_ = _e553;
                    }
                    let _e556 = phi_903_;
                    let _e558 = local.member_5;
                    if (_e556 > _e558) {
                        phi_2216_ = true;
                    } else {
                        let _e563 = local.member[1u][0u];
                        let _e566 = local.member_1[2u];
                        let _e571 = local.member[2u][0u];
                        let _e574 = local.member_1[1u];
                        let _e576 = ((_e563 * _e566) - (_e571 * _e574));
                        let _e580 = local.member[2u][0u];
                        if (_e580 < 0f) {
                            phi_962_ = -(_e580);
                        } else {
                            phi_962_ = _e580;
                        }
                        let _e584 = phi_962_;
                        let _e587 = local.member_3[1u];
                        let _e592 = local.member[1u][0u];
                        if (_e592 < 0f) {
                            phi_985_ = -(_e592);
                        } else {
                            phi_985_ = _e592;
                        }
                        let _e596 = phi_985_;
                        let _e599 = local.member_3[2u];
                        let _e605 = local.member[0u][2u];
                        if (_e605 < 0f) {
                            phi_1008_ = -(_e605);
                        } else {
                            phi_1008_ = _e605;
                        }
                        let _e609 = phi_1008_;
                        let _e612 = local.member_4[1u];
                        let _e617 = local.member[0u][1u];
                        if (_e617 < 0f) {
                            phi_1030_ = -(_e617);
                        } else {
                            phi_1030_ = _e617;
                        }
                        let _e621 = phi_1030_;
                        let _e624 = local.member_4[2u];
                        if (_e576 < 0f) {
                            phi_1046_ = -(_e576);
                        } else {
                            phi_1046_ = _e576;
                        }
                        let _e630 = phi_1046_;
                        let _e632 = (_e630 - (((_e584 * _e587) + (_e596 * _e599)) + ((_e609 * _e612) + (_e621 * _e624))));
                        let _e636 = local.member[1u][1u];
                        let _e639 = local.member_1[2u];
                        let _e644 = local.member[2u][1u];
                        let _e647 = local.member_1[1u];
                        let _e649 = ((_e636 * _e639) - (_e644 * _e647));
                        let _e653 = local.member[2u][1u];
                        if (_e653 < 0f) {
                            phi_1101_ = -(_e653);
                        } else {
                            phi_1101_ = _e653;
                        }
                        let _e657 = phi_1101_;
                        let _e660 = local.member_3[1u];
                        let _e665 = local.member[1u][1u];
                        if (_e665 < 0f) {
                            phi_1124_ = -(_e665);
                        } else {
                            phi_1124_ = _e665;
                        }
                        let _e669 = phi_1124_;
                        let _e672 = local.member_3[2u];
                        let _e678 = local.member[0u][0u];
                        if (_e678 < 0f) {
                            phi_1147_ = -(_e678);
                        } else {
                            phi_1147_ = _e678;
                        }
                        let _e682 = phi_1147_;
                        let _e685 = local.member_4[2u];
                        let _e690 = local.member[0u][2u];
                        if (_e690 < 0f) {
                            phi_1169_ = -(_e690);
                        } else {
                            phi_1169_ = _e690;
                        }
                        let _e694 = phi_1169_;
                        let _e697 = local.member_4[0u];
                        if (_e649 < 0f) {
                            phi_1185_ = -(_e649);
                        } else {
                            phi_1185_ = _e649;
                        }
                        let _e703 = phi_1185_;
                        let _e705 = (_e703 - (((_e657 * _e660) + (_e669 * _e672)) + ((_e682 * _e685) + (_e694 * _e697))));
                        let _e709 = local.member[1u][2u];
                        let _e712 = local.member_1[2u];
                        let _e717 = local.member[2u][2u];
                        let _e720 = local.member_1[1u];
                        let _e722 = ((_e709 * _e712) - (_e717 * _e720));
                        let _e726 = local.member[2u][2u];
                        if (_e726 < 0f) {
                            phi_1240_ = -(_e726);
                        } else {
                            phi_1240_ = _e726;
                        }
                        let _e730 = phi_1240_;
                        let _e733 = local.member_3[1u];
                        let _e738 = local.member[1u][2u];
                        if (_e738 < 0f) {
                            phi_1263_ = -(_e738);
                        } else {
                            phi_1263_ = _e738;
                        }
                        let _e742 = phi_1263_;
                        let _e745 = local.member_3[2u];
                        let _e751 = local.member[0u][1u];
                        if (_e751 < 0f) {
                            phi_1286_ = -(_e751);
                        } else {
                            phi_1286_ = _e751;
                        }
                        let _e755 = phi_1286_;
                        let _e758 = local.member_4[0u];
                        let _e763 = local.member[0u][0u];
                        if (_e763 < 0f) {
                            phi_1308_ = -(_e763);
                        } else {
                            phi_1308_ = _e763;
                        }
                        let _e767 = phi_1308_;
                        let _e770 = local.member_4[1u];
                        if (_e722 < 0f) {
                            phi_1324_ = -(_e722);
                        } else {
                            phi_1324_ = _e722;
                        }
                        let _e776 = phi_1324_;
                        let _e778 = (_e776 - (((_e730 * _e733) + (_e742 * _e745)) + ((_e755 * _e758) + (_e767 * _e770))));
                        let _e782 = local.member[2u][0u];
                        let _e785 = local.member_1[0u];
                        let _e790 = local.member[0u][0u];
                        let _e793 = local.member_1[2u];
                        let _e795 = ((_e782 * _e785) - (_e790 * _e793));
                        let _e799 = local.member[0u][0u];
                        if (_e799 < 0f) {
                            phi_1379_ = -(_e799);
                        } else {
                            phi_1379_ = _e799;
                        }
                        let _e803 = phi_1379_;
                        let _e806 = local.member_3[2u];
                        let _e811 = local.member[2u][0u];
                        if (_e811 < 0f) {
                            phi_1402_ = -(_e811);
                        } else {
                            phi_1402_ = _e811;
                        }
                        let _e815 = phi_1402_;
                        let _e818 = local.member_3[0u];
                        let _e824 = local.member[1u][2u];
                        if (_e824 < 0f) {
                            phi_1426_ = -(_e824);
                        } else {
                            phi_1426_ = _e824;
                        }
                        let _e828 = phi_1426_;
                        let _e831 = local.member_4[1u];
                        let _e836 = local.member[1u][1u];
                        if (_e836 < 0f) {
                            phi_1449_ = -(_e836);
                        } else {
                            phi_1449_ = _e836;
                        }
                        let _e840 = phi_1449_;
                        let _e843 = local.member_4[2u];
                        if (_e795 < 0f) {
                            phi_1465_ = -(_e795);
                        } else {
                            phi_1465_ = _e795;
                        }
                        let _e849 = phi_1465_;
                        let _e851 = (_e849 - (((_e803 * _e806) + (_e815 * _e818)) + ((_e828 * _e831) + (_e840 * _e843))));
                        let _e855 = local.member[2u][1u];
                        let _e858 = local.member_1[0u];
                        let _e863 = local.member[0u][1u];
                        let _e866 = local.member_1[2u];
                        let _e868 = ((_e855 * _e858) - (_e863 * _e866));
                        let _e872 = local.member[0u][1u];
                        if (_e872 < 0f) {
                            phi_1520_ = -(_e872);
                        } else {
                            phi_1520_ = _e872;
                        }
                        let _e876 = phi_1520_;
                        let _e879 = local.member_3[2u];
                        let _e884 = local.member[2u][1u];
                        if (_e884 < 0f) {
                            phi_1543_ = -(_e884);
                        } else {
                            phi_1543_ = _e884;
                        }
                        let _e888 = phi_1543_;
                        let _e891 = local.member_3[0u];
                        let _e897 = local.member[1u][0u];
                        if (_e897 < 0f) {
                            phi_1567_ = -(_e897);
                        } else {
                            phi_1567_ = _e897;
                        }
                        let _e901 = phi_1567_;
                        let _e904 = local.member_4[2u];
                        let _e909 = local.member[1u][2u];
                        if (_e909 < 0f) {
                            phi_1590_ = -(_e909);
                        } else {
                            phi_1590_ = _e909;
                        }
                        let _e913 = phi_1590_;
                        let _e916 = local.member_4[0u];
                        if (_e868 < 0f) {
                            phi_1606_ = -(_e868);
                        } else {
                            phi_1606_ = _e868;
                        }
                        let _e922 = phi_1606_;
                        let _e924 = (_e922 - (((_e876 * _e879) + (_e888 * _e891)) + ((_e901 * _e904) + (_e913 * _e916))));
                        let _e928 = local.member[2u][2u];
                        let _e931 = local.member_1[0u];
                        let _e936 = local.member[0u][2u];
                        let _e939 = local.member_1[2u];
                        let _e941 = ((_e928 * _e931) - (_e936 * _e939));
                        let _e945 = local.member[0u][2u];
                        if (_e945 < 0f) {
                            phi_1661_ = -(_e945);
                        } else {
                            phi_1661_ = _e945;
                        }
                        let _e949 = phi_1661_;
                        let _e952 = local.member_3[2u];
                        let _e957 = local.member[2u][2u];
                        if (_e957 < 0f) {
                            phi_1684_ = -(_e957);
                        } else {
                            phi_1684_ = _e957;
                        }
                        let _e961 = phi_1684_;
                        let _e964 = local.member_3[0u];
                        let _e970 = local.member[1u][1u];
                        if (_e970 < 0f) {
                            phi_1708_ = -(_e970);
                        } else {
                            phi_1708_ = _e970;
                        }
                        let _e974 = phi_1708_;
                        let _e977 = local.member_4[0u];
                        let _e982 = local.member[1u][0u];
                        if (_e982 < 0f) {
                            phi_1731_ = -(_e982);
                        } else {
                            phi_1731_ = _e982;
                        }
                        let _e986 = phi_1731_;
                        let _e989 = local.member_4[1u];
                        if (_e941 < 0f) {
                            phi_1747_ = -(_e941);
                        } else {
                            phi_1747_ = _e941;
                        }
                        let _e995 = phi_1747_;
                        let _e997 = (_e995 - (((_e949 * _e952) + (_e961 * _e964)) + ((_e974 * _e977) + (_e986 * _e989))));
                        let _e1001 = local.member[0u][0u];
                        let _e1004 = local.member_1[1u];
                        let _e1009 = local.member[1u][0u];
                        let _e1012 = local.member_1[0u];
                        let _e1014 = ((_e1001 * _e1004) - (_e1009 * _e1012));
                        let _e1018 = local.member[1u][0u];
                        if (_e1018 < 0f) {
                            phi_1802_ = -(_e1018);
                        } else {
                            phi_1802_ = _e1018;
                        }
                        let _e1022 = phi_1802_;
                        let _e1025 = local.member_3[0u];
                        let _e1030 = local.member[0u][0u];
                        if (_e1030 < 0f) {
                            phi_1825_ = -(_e1030);
                        } else {
                            phi_1825_ = _e1030;
                        }
                        let _e1034 = phi_1825_;
                        let _e1037 = local.member_3[1u];
                        let _e1043 = local.member[2u][2u];
                        if (_e1043 < 0f) {
                            phi_1849_ = -(_e1043);
                        } else {
                            phi_1849_ = _e1043;
                        }
                        let _e1047 = phi_1849_;
                        let _e1050 = local.member_4[1u];
                        let _e1055 = local.member[2u][1u];
                        if (_e1055 < 0f) {
                            phi_1872_ = -(_e1055);
                        } else {
                            phi_1872_ = _e1055;
                        }
                        let _e1059 = phi_1872_;
                        let _e1062 = local.member_4[2u];
                        if (_e1014 < 0f) {
                            phi_1888_ = -(_e1014);
                        } else {
                            phi_1888_ = _e1014;
                        }
                        let _e1068 = phi_1888_;
                        let _e1070 = (_e1068 - (((_e1022 * _e1025) + (_e1034 * _e1037)) + ((_e1047 * _e1050) + (_e1059 * _e1062))));
                        let _e1074 = local.member[0u][1u];
                        let _e1077 = local.member_1[1u];
                        let _e1082 = local.member[1u][1u];
                        let _e1085 = local.member_1[0u];
                        let _e1087 = ((_e1074 * _e1077) - (_e1082 * _e1085));
                        let _e1091 = local.member[1u][1u];
                        if (_e1091 < 0f) {
                            phi_1943_ = -(_e1091);
                        } else {
                            phi_1943_ = _e1091;
                        }
                        let _e1095 = phi_1943_;
                        let _e1098 = local.member_3[0u];
                        let _e1103 = local.member[0u][1u];
                        if (_e1103 < 0f) {
                            phi_1966_ = -(_e1103);
                        } else {
                            phi_1966_ = _e1103;
                        }
                        let _e1107 = phi_1966_;
                        let _e1110 = local.member_3[1u];
                        let _e1116 = local.member[2u][0u];
                        if (_e1116 < 0f) {
                            phi_1990_ = -(_e1116);
                        } else {
                            phi_1990_ = _e1116;
                        }
                        let _e1120 = phi_1990_;
                        let _e1123 = local.member_4[2u];
                        let _e1128 = local.member[2u][2u];
                        if (_e1128 < 0f) {
                            phi_2013_ = -(_e1128);
                        } else {
                            phi_2013_ = _e1128;
                        }
                        let _e1132 = phi_2013_;
                        let _e1135 = local.member_4[0u];
                        if (_e1087 < 0f) {
                            phi_2029_ = -(_e1087);
                        } else {
                            phi_2029_ = _e1087;
                        }
                        let _e1141 = phi_2029_;
                        let _e1143 = (_e1141 - (((_e1095 * _e1098) + (_e1107 * _e1110)) + ((_e1120 * _e1123) + (_e1132 * _e1135))));
                        let _e1147 = local.member[0u][2u];
                        let _e1150 = local.member_1[1u];
                        let _e1155 = local.member[1u][2u];
                        let _e1158 = local.member_1[0u];
                        let _e1160 = ((_e1147 * _e1150) - (_e1155 * _e1158));
                        let _e1164 = local.member[1u][2u];
                        if (_e1164 < 0f) {
                            phi_2084_ = -(_e1164);
                        } else {
                            phi_2084_ = _e1164;
                        }
                        let _e1168 = phi_2084_;
                        let _e1171 = local.member_3[0u];
                        let _e1176 = local.member[0u][2u];
                        if (_e1176 < 0f) {
                            phi_2107_ = -(_e1176);
                        } else {
                            phi_2107_ = _e1176;
                        }
                        let _e1180 = phi_2107_;
                        let _e1183 = local.member_3[1u];
                        let _e1189 = local.member[2u][1u];
                        if (_e1189 < 0f) {
                            phi_2131_ = -(_e1189);
                        } else {
                            phi_2131_ = _e1189;
                        }
                        let _e1193 = phi_2131_;
                        let _e1196 = local.member_4[0u];
                        let _e1201 = local.member[2u][0u];
                        if (_e1201 < 0f) {
                            phi_2154_ = -(_e1201);
                        } else {
                            phi_2154_ = _e1201;
                        }
                        let _e1205 = phi_2154_;
                        let _e1208 = local.member_4[1u];
                        if (_e1160 < 0f) {
                            phi_2170_ = -(_e1160);
                        } else {
                            phi_2170_ = _e1160;
                        }
                        let _e1214 = phi_2170_;
                        let _e1216 = (_e1214 - (((_e1168 * _e1171) + (_e1180 * _e1183)) + ((_e1193 * _e1196) + (_e1205 * _e1208))));
                        if (_e632 > _e705) {
                            phi_2177_ = _e632;
                        } else {
                            phi_2177_ = _e705;
                        }
                        let _e1219 = phi_2177_;
                        if (_e1219 > _e778) {
                            phi_2182_ = _e1219;
                        } else {
                            phi_2182_ = _e778;
                        }
                        let _e1222 = phi_2182_;
                        if (_e851 > _e924) {
                            phi_2187_ = _e851;
                        } else {
                            phi_2187_ = _e924;
                        }
                        let _e1225 = phi_2187_;
                        if (_e1225 > _e997) {
                            phi_2192_ = _e1225;
                        } else {
                            phi_2192_ = _e997;
                        }
                        let _e1228 = phi_2192_;
                        if (_e1222 > _e1228) {
                            phi_2197_ = _e1222;
                        } else {
                            phi_2197_ = _e1228;
                        }
                        let _e1231 = phi_2197_;
                        if (_e1070 > _e1143) {
                            phi_2202_ = _e1070;
                        } else {
                            phi_2202_ = _e1143;
                        }
                        let _e1234 = phi_2202_;
                        if (_e1234 > _e1216) {
                            phi_2207_ = _e1234;
                        } else {
                            phi_2207_ = _e1216;
                        }
                        let _e1237 = phi_2207_;
                        if (_e1231 > _e1237) {
                            phi_2212_ = _e1231;
                        } else {
                            phi_2212_ = _e1237;
                        }
                        let _e1240 = phi_2212_;
                        let _e1242 = local.member_5;
                        phi_2216_ = (_e1240 > _e1242);
                    }
                    let _e1245 = phi_2216_;
                    if !(_e1245) {
                        let _e1262 = local_1.member_2;
                        let _e1264 = nodes.member[_e1262];
                        let _e1309 = ((((((bitcast<f32>(_e1264.member.x) <= _e83.member_1.y) && (_e83.member.x <= bitcast<f32>(_e1264.member_1.x))) && (bitcast<f32>(_e1264.member.y) <= _e83.member_2.x)) && (_e83.member.y <= bitcast<f32>(_e1264.member_1.y))) && (bitcast<f32>(_e1264.member.z) <= _e83.member_2.y)) && (_e83.member_1.x <= bitcast<f32>(_e1264.member_1.z)));
                        let _e1320 = ((((((bitcast<f32>(_e1264.member_2.x) <= _e83.member_1.y) && (_e83.member.x <= bitcast<f32>(_e1264.member_3.x))) && (bitcast<f32>(_e1264.member_2.y) <= _e83.member_2.x)) && (_e83.member.y <= bitcast<f32>(_e1264.member_3.y))) && (bitcast<f32>(_e1264.member_2.z) <= _e83.member_2.y)) && (_e83.member_1.x <= bitcast<f32>(_e1264.member_3.z)));
                        let _e1322 = ((_e1264.member.w & 2147483648u) != 0u);
                        let _e1324 = ((_e1264.member_1.w & 2147483648u) != 0u);
                        if _e1309 {
                            if _e1322 {
                                phi_2324_ = (_e1264.member.w & 2147483647u);
                                phi_2325_ = false;
                            } else {
                                phi_2324_ = u32();
                                phi_2325_ = true;
                            }
                            let _e1327 = phi_2324_;
                            let _e1329 = phi_2325_;
                            phi_2326_ = _e1327;
                            phi_2327_ = _e1329;
                        } else {
                            phi_2326_ = u32();
                            phi_2327_ = true;
                        }
                        let _e1331 = phi_2326_;
                        let _e1333 = phi_2327_;
                        if _e1333 {
                            phi_2331_ = 4294967295u;
                        } else {
                            phi_2331_ = _e1331;
                        }
                        let _e1335 = phi_2331_;
                        if _e1320 {
                            if _e1324 {
                                phi_2339_ = (_e1264.member_1.w & 2147483647u);
                                phi_2340_ = false;
                            } else {
                                phi_2339_ = u32();
                                phi_2340_ = true;
                            }
                            let _e1338 = phi_2339_;
                            let _e1340 = phi_2340_;
                            phi_2341_ = _e1338;
                            phi_2342_ = _e1340;
                        } else {
                            phi_2341_ = u32();
                            phi_2342_ = true;
                        }
                        let _e1342 = phi_2341_;
                        let _e1344 = phi_2342_;
                        if _e1344 {
                            phi_2346_ = 4294967295u;
                        } else {
                            phi_2346_ = _e1342;
                        }
                        let _e1346 = phi_2346_;
                        if _e1309 {
                            phi_2351_ = !(_e1322);
                        } else {
                            phi_2351_ = false;
                        }
                        let _e1349 = phi_2351_;
                        if _e1320 {
                            phi_2356_ = !(_e1324);
                        } else {
                            phi_2356_ = false;
                        }
                        let _e1352 = phi_2356_;
                        if _e1349 {
                            if _e1352 {
                                let _e1354 = ((_e1264.member_3.w & 2147483648u) != 0u);
                                if _e1354 {
                                    phi_2368_ = _e1264.member_1.w;
                                } else {
                                    phi_2368_ = _e1264.member.w;
                                }
                                let _e1356 = phi_2368_;
                                let _e1358 = local_1.member_1;
                                local_1.member[_e1358] = _e1356;
                                let _e1363 = local_1.member_1;
                                local_1.member_1 = (_e1363 + 1u);
                                if _e1354 {
                                    phi_2384_ = _e1264.member.w;
                                } else {
                                    phi_2384_ = _e1264.member_1.w;
                                }
                                let _e1366 = phi_2384_;
                                local_1.member_2 = _e1366;
                                phi_2386_ = false;
                            } else {
                                phi_2386_ = true;
                            }
                            let _e1369 = phi_2386_;
                            phi_2387_ = _e1369;
                        } else {
                            phi_2387_ = true;
                        }
                        let _e1371 = phi_2387_;
                        if _e1371 {
                            if _e1349 {
                                local_1.member_2 = _e1264.member.w;
                            } else {
                                if _e1352 {
                                    local_1.member_2 = _e1264.member_1.w;
                                } else {
                                    let _e1373 = local_1.member_1;
                                    if (_e1373 > 0u) {
                                        let _e1378 = local_1.member_1;
                                        local_1.member_1 = (_e1378 - 1u);
                                        let _e1381 = local_1.member_1;
                                        let _e1384 = local_1.member[_e1381];
                                        local_1.member_2 = _e1384;
                                    } else {
                                        local_1.member_3 = false;
                                    }
                                }
                            }
                        }
                        if (_e1335 != 4294967295u) {
                            let _e1391 = params.member.member_2.member;
                            if (_e1391 == 0u) {
                                phi_2433_ = array<u32, 2>(0u, 2u);
                            } else {
                                phi_2433_ = array<u32, 2>(1u, 1u);
                            }
                            let _e1394 = phi_2433_;
                            let _e1399 = params.member.member.member_2[_e1394[1]];
                            let _e1402 = order.member[(_e1399 + _e1335)];
                            let _e1403 = (_e1402 - _e1399);
                            let _e1406 = params.member.member_2.member;
                            if (_e1406 == 0u) {
                                phi_2466_ = true;
                            } else {
                                phi_2466_ = (_e1403 > _e100);
                            }
                            let _e1410 = phi_2466_;
                            if _e1410 {
                                let _e1413 = params.member.member_1.member_3;
                                let _e1415 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1415 + 1u) < _e1415) {
                                    let _e1419 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1415 < _e1413) {
                                    let _e1421 = (2u * _e1415);
                                    atomicStore((&pairs.member[(4u + _e1421)]), _e100);
                                    atomicStore((&pairs.member[(_e1421 + 5u)]), _e1403);
                                }
                            }
                        }
                        if (_e1346 != 4294967295u) {
                            let _e1429 = params.member.member_2.member;
                            if (_e1429 == 0u) {
                                phi_2509_ = array<u32, 2>(0u, 2u);
                            } else {
                                phi_2509_ = array<u32, 2>(1u, 1u);
                            }
                            let _e1432 = phi_2509_;
                            let _e1437 = params.member.member.member_2[_e1432[1]];
                            let _e1440 = order.member[(_e1437 + _e1346)];
                            let _e1441 = (_e1440 - _e1437);
                            let _e1444 = params.member.member_2.member;
                            if (_e1444 == 0u) {
                                phi_2542_ = true;
                            } else {
                                phi_2542_ = (_e1441 > _e100);
                            }
                            let _e1448 = phi_2542_;
                            if _e1448 {
                                let _e1451 = params.member.member_1.member_3;
                                let _e1453 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1453 + 1u) < _e1453) {
                                    let _e1457 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1453 < _e1451) {
                                    let _e1459 = (2u * _e1453);
                                    atomicStore((&pairs.member[(4u + _e1459)]), _e100);
                                    atomicStore((&pairs.member[(_e1459 + 5u)]), _e1441);
                                }
                            }
                        }
                    } else {
                        let _e1248 = local_1.member_1;
                        if (_e1248 > 0u) {
                            let _e1253 = local_1.member_1;
                            local_1.member_1 = (_e1253 - 1u);
                            let _e1256 = local_1.member_1;
                            let _e1259 = local_1.member[_e1256];
                            local_1.member_2 = _e1259;
                        } else {
                            local_1.member_3 = false;
                        }
                    }
                }
                phi_2593_ = _e195;
            } else {
                phi_2593_ = false;
            }
            let _e1465 = phi_2593_;
            continue;
            continuing {
                phi_379_ = _e188;
                break if !(_e1465);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_full_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
