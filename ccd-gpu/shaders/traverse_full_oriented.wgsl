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
    var phi_177_: u32;
    var phi_276_: array<u32, 2>;
    var phi_309_: bool;
    var phi_379_: type_9;
    var phi_380_: type_9;
    var phi_403_: type_9;
    var phi_457_: f32;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_472_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_503_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_556_: f32;
    var phi_563_: f32;
    var phi_569_: f32;
    var phi_576_: f32;
    var phi_583_: f32;
    var phi_589_: f32;
    var phi_596_: f32;
    var phi_689_: f32;
    var phi_696_: f32;
    var phi_702_: f32;
    var phi_708_: f32;
    var phi_727_: f32;
    var phi_734_: f32;
    var phi_740_: f32;
    var phi_746_: f32;
    var phi_765_: f32;
    var phi_772_: f32;
    var phi_778_: f32;
    var phi_784_: f32;
    var phi_803_: f32;
    var phi_810_: f32;
    var phi_816_: f32;
    var phi_822_: f32;
    var phi_841_: f32;
    var phi_848_: f32;
    var phi_854_: f32;
    var phi_860_: f32;
    var phi_879_: f32;
    var phi_886_: f32;
    var phi_892_: f32;
    var phi_898_: f32;
    var phi_913_: f32;
    var phi_918_: f32;
    var phi_923_: f32;
    var phi_928_: f32;
    var phi_933_: f32;
    var phi_992_: f32;
    var phi_1015_: f32;
    var phi_1038_: f32;
    var phi_1060_: f32;
    var phi_1076_: f32;
    var phi_1131_: f32;
    var phi_1154_: f32;
    var phi_1177_: f32;
    var phi_1199_: f32;
    var phi_1215_: f32;
    var phi_1270_: f32;
    var phi_1293_: f32;
    var phi_1316_: f32;
    var phi_1338_: f32;
    var phi_1354_: f32;
    var phi_1409_: f32;
    var phi_1432_: f32;
    var phi_1456_: f32;
    var phi_1479_: f32;
    var phi_1495_: f32;
    var phi_1550_: f32;
    var phi_1573_: f32;
    var phi_1597_: f32;
    var phi_1620_: f32;
    var phi_1636_: f32;
    var phi_1691_: f32;
    var phi_1714_: f32;
    var phi_1738_: f32;
    var phi_1761_: f32;
    var phi_1777_: f32;
    var phi_1832_: f32;
    var phi_1855_: f32;
    var phi_1879_: f32;
    var phi_1902_: f32;
    var phi_1918_: f32;
    var phi_1973_: f32;
    var phi_1996_: f32;
    var phi_2020_: f32;
    var phi_2043_: f32;
    var phi_2059_: f32;
    var phi_2114_: f32;
    var phi_2137_: f32;
    var phi_2161_: f32;
    var phi_2184_: f32;
    var phi_2200_: f32;
    var phi_2207_: f32;
    var phi_2212_: f32;
    var phi_2217_: f32;
    var phi_2222_: f32;
    var phi_2227_: f32;
    var phi_2232_: f32;
    var phi_2237_: f32;
    var phi_2242_: f32;
    var phi_2246_: bool;
    var phi_2354_: u32;
    var phi_2355_: bool;
    var phi_2356_: u32;
    var phi_2357_: bool;
    var phi_2361_: u32;
    var phi_2369_: u32;
    var phi_2370_: bool;
    var phi_2371_: u32;
    var phi_2372_: bool;
    var phi_2376_: u32;
    var phi_2381_: bool;
    var phi_2386_: bool;
    var phi_2398_: u32;
    var phi_2414_: u32;
    var phi_2416_: bool;
    var phi_2417_: bool;
    var phi_2463_: array<u32, 2>;
    var phi_2496_: bool;
    var phi_2539_: array<u32, 2>;
    var phi_2572_: bool;
    var phi_2623_: bool;
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
        local_1 = type_32(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
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
                    if (_e237 < _e83.member_1.y) {
                        phi_457_ = _e237;
                    } else {
                        phi_457_ = _e83.member_1.y;
                    }
                    let _e242 = phi_457_;
                    if (_e238 < _e83.member_2.x) {
                        phi_462_ = _e238;
                    } else {
                        phi_462_ = _e83.member_2.x;
                    }
                    let _e245 = phi_462_;
                    if (_e239 < _e83.member_2.y) {
                        phi_467_ = _e239;
                    } else {
                        phi_467_ = _e83.member_2.y;
                    }
                    let _e248 = phi_467_;
                    if (_e242 > _e83.member.x) {
                        phi_472_ = _e242;
                    } else {
                        phi_472_ = _e83.member.x;
                    }
                    let _e251 = phi_472_;
                    if (_e245 > _e83.member.y) {
                        phi_477_ = _e245;
                    } else {
                        phi_477_ = _e83.member.y;
                    }
                    let _e254 = phi_477_;
                    if (_e248 > _e83.member_1.x) {
                        phi_482_ = _e248;
                    } else {
                        phi_482_ = _e83.member_1.x;
                    }
                    let _e257 = phi_482_;
                    let _e258 = (_e83.member_1.y - _e251);
                    let _e259 = (_e83.member_2.x - _e254);
                    let _e260 = (_e83.member_2.y - _e257);
                    let _e261 = (_e251 - _e83.member.x);
                    let _e262 = (_e254 - _e83.member.y);
                    let _e263 = (_e257 - _e83.member_1.x);
                    if (_e258 > _e261) {
                        phi_493_ = _e258;
                    } else {
                        phi_493_ = _e261;
                    }
                    let _e266 = phi_493_;
                    if (_e259 > _e262) {
                        phi_498_ = _e259;
                    } else {
                        phi_498_ = _e262;
                    }
                    let _e269 = phi_498_;
                    if (_e260 > _e263) {
                        phi_503_ = _e260;
                    } else {
                        phi_503_ = _e263;
                    }
                    let _e272 = phi_503_;
                    let _e274 = (1f + (0.000000059604645f * 4f));
                    let _e278 = (0.000000000000000000000000000000000000011754944f * 8f);
                    let _e279 = ((_e266 * _e274) + _e278);
                    let _e280 = ((_e269 * _e274) + _e278);
                    let _e281 = ((_e272 * _e274) + _e278);
                    let _e282 = (_e200.member.x - _e251);
                    let _e283 = (_e200.member.y - _e254);
                    let _e284 = (_e200.member.z - _e257);
                    if (_e282 < 0f) {
                        phi_543_ = -(_e282);
                    } else {
                        phi_543_ = _e282;
                    }
                    let _e303 = phi_543_;
                    if (_e283 < 0f) {
                        phi_549_ = -(_e283);
                    } else {
                        phi_549_ = _e283;
                    }
                    let _e307 = phi_549_;
                    if (_e284 < 0f) {
                        phi_556_ = -(_e284);
                    } else {
                        phi_556_ = _e284;
                    }
                    let _e312 = phi_556_;
                    if (_e279 < 0f) {
                        phi_563_ = -(_e279);
                    } else {
                        phi_563_ = _e279;
                    }
                    let _e317 = phi_563_;
                    if (_e280 < 0f) {
                        phi_569_ = -(_e280);
                    } else {
                        phi_569_ = _e280;
                    }
                    let _e321 = phi_569_;
                    if (_e281 < 0f) {
                        phi_576_ = -(_e281);
                    } else {
                        phi_576_ = _e281;
                    }
                    let _e326 = phi_576_;
                    if (_e200.member_3.x < 0f) {
                        phi_583_ = -(_e200.member_3.x);
                    } else {
                        phi_583_ = _e200.member_3.x;
                    }
                    let _e331 = phi_583_;
                    if (_e200.member_3.y < 0f) {
                        phi_589_ = -(_e200.member_3.y);
                    } else {
                        phi_589_ = _e200.member_3.y;
                    }
                    let _e335 = phi_589_;
                    if (_e200.member_3.z < 0f) {
                        phi_596_ = -(_e200.member_3.z);
                    } else {
                        phi_596_ = _e200.member_3.z;
                    }
                    let _e340 = phi_596_;
                    local = type_26(array<array<f32, 3>, 3>(array<f32, 3>(_e200.member.w, _e200.member_1.z, _e200.member_2.y), array<f32, 3>(_e200.member_1.x, _e200.member_1.w, _e200.member_2.z), array<f32, 3>(_e200.member_1.y, _e200.member_2.x, _e200.member_2.w)), array<f32, 3>(_e282, _e283, _e284), array<f32, 3>((((_e200.member.w * _e282) + (_e200.member_1.x * _e283)) + (_e200.member_1.y * _e284)), (((_e200.member_1.z * _e282) + (_e200.member_1.w * _e283)) + (_e200.member_2.x * _e284)), (((_e200.member_2.y * _e282) + (_e200.member_2.z * _e283)) + (_e200.member_2.w * _e284))), array<f32, 3>(_e279, _e280, _e281), array<f32, 3>(_e200.member_3.x, _e200.member_3.y, _e200.member_3.z), ((((((_e303 + _e307) + _e312) + (((_e317 + _e321) + _e326) + ((_e331 + _e335) + _e340))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e361 = local.member[0u][0u];
                    let _e365 = local.member[0u][1u];
                    let _e369 = local.member[0u][2u];
                    let _e373 = local.member[1u][0u];
                    let _e377 = local.member[1u][1u];
                    let _e381 = local.member[1u][2u];
                    let _e385 = local.member[2u][0u];
                    let _e389 = local.member[2u][1u];
                    let _e393 = local.member[2u][2u];
                    let _e395 = local.member_3;
                    let _e400 = local.member_4;
                    let _e406 = local.member_1[0u];
                    if (_e406 < 0f) {
                        phi_689_ = -(_e406);
                    } else {
                        phi_689_ = _e406;
                    }
                    let _e410 = phi_689_;
                    if (_e361 < 0f) {
                        phi_696_ = -(_e361);
                    } else {
                        phi_696_ = _e361;
                    }
                    let _e414 = phi_696_;
                    if (_e365 < 0f) {
                        phi_702_ = -(_e365);
                    } else {
                        phi_702_ = _e365;
                    }
                    let _e418 = phi_702_;
                    if (_e369 < 0f) {
                        phi_708_ = -(_e369);
                    } else {
                        phi_708_ = _e369;
                    }
                    let _e422 = phi_708_;
                    let _e429 = (_e410 - (_e395[0] + (((_e414 * _e400[0]) + (_e418 * _e400[1])) + (_e422 * _e400[2]))));
                    let _e432 = local.member_1[1u];
                    if (_e432 < 0f) {
                        phi_727_ = -(_e432);
                    } else {
                        phi_727_ = _e432;
                    }
                    let _e436 = phi_727_;
                    if (_e373 < 0f) {
                        phi_734_ = -(_e373);
                    } else {
                        phi_734_ = _e373;
                    }
                    let _e440 = phi_734_;
                    if (_e377 < 0f) {
                        phi_740_ = -(_e377);
                    } else {
                        phi_740_ = _e377;
                    }
                    let _e444 = phi_740_;
                    if (_e381 < 0f) {
                        phi_746_ = -(_e381);
                    } else {
                        phi_746_ = _e381;
                    }
                    let _e448 = phi_746_;
                    let _e455 = (_e436 - (_e395[1] + (((_e440 * _e400[0]) + (_e444 * _e400[1])) + (_e448 * _e400[2]))));
                    let _e458 = local.member_1[2u];
                    if (_e458 < 0f) {
                        phi_765_ = -(_e458);
                    } else {
                        phi_765_ = _e458;
                    }
                    let _e462 = phi_765_;
                    if (_e385 < 0f) {
                        phi_772_ = -(_e385);
                    } else {
                        phi_772_ = _e385;
                    }
                    let _e466 = phi_772_;
                    if (_e389 < 0f) {
                        phi_778_ = -(_e389);
                    } else {
                        phi_778_ = _e389;
                    }
                    let _e470 = phi_778_;
                    if (_e393 < 0f) {
                        phi_784_ = -(_e393);
                    } else {
                        phi_784_ = _e393;
                    }
                    let _e474 = phi_784_;
                    let _e481 = (_e462 - (_e395[2] + (((_e466 * _e400[0]) + (_e470 * _e400[1])) + (_e474 * _e400[2]))));
                    let _e484 = local.member_2[0u];
                    if (_e484 < 0f) {
                        phi_803_ = -(_e484);
                    } else {
                        phi_803_ = _e484;
                    }
                    let _e488 = phi_803_;
                    if (_e361 < 0f) {
                        phi_810_ = -(_e361);
                    } else {
                        phi_810_ = _e361;
                    }
                    let _e492 = phi_810_;
                    if (_e373 < 0f) {
                        phi_816_ = -(_e373);
                    } else {
                        phi_816_ = _e373;
                    }
                    let _e496 = phi_816_;
                    if (_e385 < 0f) {
                        phi_822_ = -(_e385);
                    } else {
                        phi_822_ = _e385;
                    }
                    let _e500 = phi_822_;
                    let _e507 = (_e488 - (_e400[0] + (((_e492 * _e395[0]) + (_e496 * _e395[1])) + (_e500 * _e395[2]))));
                    let _e510 = local.member_2[1u];
                    if (_e510 < 0f) {
                        phi_841_ = -(_e510);
                    } else {
                        phi_841_ = _e510;
                    }
                    let _e514 = phi_841_;
                    if (_e365 < 0f) {
                        phi_848_ = -(_e365);
                    } else {
                        phi_848_ = _e365;
                    }
                    let _e518 = phi_848_;
                    if (_e377 < 0f) {
                        phi_854_ = -(_e377);
                    } else {
                        phi_854_ = _e377;
                    }
                    let _e522 = phi_854_;
                    if (_e389 < 0f) {
                        phi_860_ = -(_e389);
                    } else {
                        phi_860_ = _e389;
                    }
                    let _e526 = phi_860_;
                    let _e533 = (_e514 - (_e400[1] + (((_e518 * _e395[0]) + (_e522 * _e395[1])) + (_e526 * _e395[2]))));
                    let _e536 = local.member_2[2u];
                    if (_e536 < 0f) {
                        phi_879_ = -(_e536);
                    } else {
                        phi_879_ = _e536;
                    }
                    let _e540 = phi_879_;
                    if (_e369 < 0f) {
                        phi_886_ = -(_e369);
                    } else {
                        phi_886_ = _e369;
                    }
                    let _e544 = phi_886_;
                    if (_e381 < 0f) {
                        phi_892_ = -(_e381);
                    } else {
                        phi_892_ = _e381;
                    }
                    let _e548 = phi_892_;
                    if (_e393 < 0f) {
                        phi_898_ = -(_e393);
                    } else {
                        phi_898_ = _e393;
                    }
                    let _e552 = phi_898_;
                    let _e559 = (_e540 - (_e400[2] + (((_e544 * _e395[0]) + (_e548 * _e395[1])) + (_e552 * _e395[2]))));
                    if (_e429 > _e455) {
                        phi_913_ = _e429;
                    } else {
                        phi_913_ = _e455;
                    }
                    let _e562 = phi_913_;
                    if (_e562 > _e481) {
                        phi_918_ = _e562;
                    } else {
                        phi_918_ = _e481;
                    }
                    let _e565 = phi_918_;
                    if (_e507 > _e533) {
                        phi_923_ = _e507;
                    } else {
                        phi_923_ = _e533;
                    }
                    let _e568 = phi_923_;
                    if (_e568 > _e559) {
                        phi_928_ = _e568;
                    } else {
                        phi_928_ = _e559;
                    }
                    let _e571 = phi_928_;
                    if (_e565 > _e571) {
                        phi_933_ = _e565;
                    } else {
                        phi_933_ = _e571;
                    }
                    let _e574 = phi_933_;
                    let _e576 = local.member_5;
                    if (_e574 > _e576) {
                        phi_2246_ = true;
                    } else {
                        let _e581 = local.member[1u][0u];
                        let _e584 = local.member_1[2u];
                        let _e589 = local.member[2u][0u];
                        let _e592 = local.member_1[1u];
                        let _e594 = ((_e581 * _e584) - (_e589 * _e592));
                        let _e598 = local.member[2u][0u];
                        if (_e598 < 0f) {
                            phi_992_ = -(_e598);
                        } else {
                            phi_992_ = _e598;
                        }
                        let _e602 = phi_992_;
                        let _e605 = local.member_3[1u];
                        let _e610 = local.member[1u][0u];
                        if (_e610 < 0f) {
                            phi_1015_ = -(_e610);
                        } else {
                            phi_1015_ = _e610;
                        }
                        let _e614 = phi_1015_;
                        let _e617 = local.member_3[2u];
                        let _e623 = local.member[0u][2u];
                        if (_e623 < 0f) {
                            phi_1038_ = -(_e623);
                        } else {
                            phi_1038_ = _e623;
                        }
                        let _e627 = phi_1038_;
                        let _e630 = local.member_4[1u];
                        let _e635 = local.member[0u][1u];
                        if (_e635 < 0f) {
                            phi_1060_ = -(_e635);
                        } else {
                            phi_1060_ = _e635;
                        }
                        let _e639 = phi_1060_;
                        let _e642 = local.member_4[2u];
                        if (_e594 < 0f) {
                            phi_1076_ = -(_e594);
                        } else {
                            phi_1076_ = _e594;
                        }
                        let _e648 = phi_1076_;
                        let _e650 = (_e648 - (((_e602 * _e605) + (_e614 * _e617)) + ((_e627 * _e630) + (_e639 * _e642))));
                        let _e654 = local.member[1u][1u];
                        let _e657 = local.member_1[2u];
                        let _e662 = local.member[2u][1u];
                        let _e665 = local.member_1[1u];
                        let _e667 = ((_e654 * _e657) - (_e662 * _e665));
                        let _e671 = local.member[2u][1u];
                        if (_e671 < 0f) {
                            phi_1131_ = -(_e671);
                        } else {
                            phi_1131_ = _e671;
                        }
                        let _e675 = phi_1131_;
                        let _e678 = local.member_3[1u];
                        let _e683 = local.member[1u][1u];
                        if (_e683 < 0f) {
                            phi_1154_ = -(_e683);
                        } else {
                            phi_1154_ = _e683;
                        }
                        let _e687 = phi_1154_;
                        let _e690 = local.member_3[2u];
                        let _e696 = local.member[0u][0u];
                        if (_e696 < 0f) {
                            phi_1177_ = -(_e696);
                        } else {
                            phi_1177_ = _e696;
                        }
                        let _e700 = phi_1177_;
                        let _e703 = local.member_4[2u];
                        let _e708 = local.member[0u][2u];
                        if (_e708 < 0f) {
                            phi_1199_ = -(_e708);
                        } else {
                            phi_1199_ = _e708;
                        }
                        let _e712 = phi_1199_;
                        let _e715 = local.member_4[0u];
                        if (_e667 < 0f) {
                            phi_1215_ = -(_e667);
                        } else {
                            phi_1215_ = _e667;
                        }
                        let _e721 = phi_1215_;
                        let _e723 = (_e721 - (((_e675 * _e678) + (_e687 * _e690)) + ((_e700 * _e703) + (_e712 * _e715))));
                        let _e727 = local.member[1u][2u];
                        let _e730 = local.member_1[2u];
                        let _e735 = local.member[2u][2u];
                        let _e738 = local.member_1[1u];
                        let _e740 = ((_e727 * _e730) - (_e735 * _e738));
                        let _e744 = local.member[2u][2u];
                        if (_e744 < 0f) {
                            phi_1270_ = -(_e744);
                        } else {
                            phi_1270_ = _e744;
                        }
                        let _e748 = phi_1270_;
                        let _e751 = local.member_3[1u];
                        let _e756 = local.member[1u][2u];
                        if (_e756 < 0f) {
                            phi_1293_ = -(_e756);
                        } else {
                            phi_1293_ = _e756;
                        }
                        let _e760 = phi_1293_;
                        let _e763 = local.member_3[2u];
                        let _e769 = local.member[0u][1u];
                        if (_e769 < 0f) {
                            phi_1316_ = -(_e769);
                        } else {
                            phi_1316_ = _e769;
                        }
                        let _e773 = phi_1316_;
                        let _e776 = local.member_4[0u];
                        let _e781 = local.member[0u][0u];
                        if (_e781 < 0f) {
                            phi_1338_ = -(_e781);
                        } else {
                            phi_1338_ = _e781;
                        }
                        let _e785 = phi_1338_;
                        let _e788 = local.member_4[1u];
                        if (_e740 < 0f) {
                            phi_1354_ = -(_e740);
                        } else {
                            phi_1354_ = _e740;
                        }
                        let _e794 = phi_1354_;
                        let _e796 = (_e794 - (((_e748 * _e751) + (_e760 * _e763)) + ((_e773 * _e776) + (_e785 * _e788))));
                        let _e800 = local.member[2u][0u];
                        let _e803 = local.member_1[0u];
                        let _e808 = local.member[0u][0u];
                        let _e811 = local.member_1[2u];
                        let _e813 = ((_e800 * _e803) - (_e808 * _e811));
                        let _e817 = local.member[0u][0u];
                        if (_e817 < 0f) {
                            phi_1409_ = -(_e817);
                        } else {
                            phi_1409_ = _e817;
                        }
                        let _e821 = phi_1409_;
                        let _e824 = local.member_3[2u];
                        let _e829 = local.member[2u][0u];
                        if (_e829 < 0f) {
                            phi_1432_ = -(_e829);
                        } else {
                            phi_1432_ = _e829;
                        }
                        let _e833 = phi_1432_;
                        let _e836 = local.member_3[0u];
                        let _e842 = local.member[1u][2u];
                        if (_e842 < 0f) {
                            phi_1456_ = -(_e842);
                        } else {
                            phi_1456_ = _e842;
                        }
                        let _e846 = phi_1456_;
                        let _e849 = local.member_4[1u];
                        let _e854 = local.member[1u][1u];
                        if (_e854 < 0f) {
                            phi_1479_ = -(_e854);
                        } else {
                            phi_1479_ = _e854;
                        }
                        let _e858 = phi_1479_;
                        let _e861 = local.member_4[2u];
                        if (_e813 < 0f) {
                            phi_1495_ = -(_e813);
                        } else {
                            phi_1495_ = _e813;
                        }
                        let _e867 = phi_1495_;
                        let _e869 = (_e867 - (((_e821 * _e824) + (_e833 * _e836)) + ((_e846 * _e849) + (_e858 * _e861))));
                        let _e873 = local.member[2u][1u];
                        let _e876 = local.member_1[0u];
                        let _e881 = local.member[0u][1u];
                        let _e884 = local.member_1[2u];
                        let _e886 = ((_e873 * _e876) - (_e881 * _e884));
                        let _e890 = local.member[0u][1u];
                        if (_e890 < 0f) {
                            phi_1550_ = -(_e890);
                        } else {
                            phi_1550_ = _e890;
                        }
                        let _e894 = phi_1550_;
                        let _e897 = local.member_3[2u];
                        let _e902 = local.member[2u][1u];
                        if (_e902 < 0f) {
                            phi_1573_ = -(_e902);
                        } else {
                            phi_1573_ = _e902;
                        }
                        let _e906 = phi_1573_;
                        let _e909 = local.member_3[0u];
                        let _e915 = local.member[1u][0u];
                        if (_e915 < 0f) {
                            phi_1597_ = -(_e915);
                        } else {
                            phi_1597_ = _e915;
                        }
                        let _e919 = phi_1597_;
                        let _e922 = local.member_4[2u];
                        let _e927 = local.member[1u][2u];
                        if (_e927 < 0f) {
                            phi_1620_ = -(_e927);
                        } else {
                            phi_1620_ = _e927;
                        }
                        let _e931 = phi_1620_;
                        let _e934 = local.member_4[0u];
                        if (_e886 < 0f) {
                            phi_1636_ = -(_e886);
                        } else {
                            phi_1636_ = _e886;
                        }
                        let _e940 = phi_1636_;
                        let _e942 = (_e940 - (((_e894 * _e897) + (_e906 * _e909)) + ((_e919 * _e922) + (_e931 * _e934))));
                        let _e946 = local.member[2u][2u];
                        let _e949 = local.member_1[0u];
                        let _e954 = local.member[0u][2u];
                        let _e957 = local.member_1[2u];
                        let _e959 = ((_e946 * _e949) - (_e954 * _e957));
                        let _e963 = local.member[0u][2u];
                        if (_e963 < 0f) {
                            phi_1691_ = -(_e963);
                        } else {
                            phi_1691_ = _e963;
                        }
                        let _e967 = phi_1691_;
                        let _e970 = local.member_3[2u];
                        let _e975 = local.member[2u][2u];
                        if (_e975 < 0f) {
                            phi_1714_ = -(_e975);
                        } else {
                            phi_1714_ = _e975;
                        }
                        let _e979 = phi_1714_;
                        let _e982 = local.member_3[0u];
                        let _e988 = local.member[1u][1u];
                        if (_e988 < 0f) {
                            phi_1738_ = -(_e988);
                        } else {
                            phi_1738_ = _e988;
                        }
                        let _e992 = phi_1738_;
                        let _e995 = local.member_4[0u];
                        let _e1000 = local.member[1u][0u];
                        if (_e1000 < 0f) {
                            phi_1761_ = -(_e1000);
                        } else {
                            phi_1761_ = _e1000;
                        }
                        let _e1004 = phi_1761_;
                        let _e1007 = local.member_4[1u];
                        if (_e959 < 0f) {
                            phi_1777_ = -(_e959);
                        } else {
                            phi_1777_ = _e959;
                        }
                        let _e1013 = phi_1777_;
                        let _e1015 = (_e1013 - (((_e967 * _e970) + (_e979 * _e982)) + ((_e992 * _e995) + (_e1004 * _e1007))));
                        let _e1019 = local.member[0u][0u];
                        let _e1022 = local.member_1[1u];
                        let _e1027 = local.member[1u][0u];
                        let _e1030 = local.member_1[0u];
                        let _e1032 = ((_e1019 * _e1022) - (_e1027 * _e1030));
                        let _e1036 = local.member[1u][0u];
                        if (_e1036 < 0f) {
                            phi_1832_ = -(_e1036);
                        } else {
                            phi_1832_ = _e1036;
                        }
                        let _e1040 = phi_1832_;
                        let _e1043 = local.member_3[0u];
                        let _e1048 = local.member[0u][0u];
                        if (_e1048 < 0f) {
                            phi_1855_ = -(_e1048);
                        } else {
                            phi_1855_ = _e1048;
                        }
                        let _e1052 = phi_1855_;
                        let _e1055 = local.member_3[1u];
                        let _e1061 = local.member[2u][2u];
                        if (_e1061 < 0f) {
                            phi_1879_ = -(_e1061);
                        } else {
                            phi_1879_ = _e1061;
                        }
                        let _e1065 = phi_1879_;
                        let _e1068 = local.member_4[1u];
                        let _e1073 = local.member[2u][1u];
                        if (_e1073 < 0f) {
                            phi_1902_ = -(_e1073);
                        } else {
                            phi_1902_ = _e1073;
                        }
                        let _e1077 = phi_1902_;
                        let _e1080 = local.member_4[2u];
                        if (_e1032 < 0f) {
                            phi_1918_ = -(_e1032);
                        } else {
                            phi_1918_ = _e1032;
                        }
                        let _e1086 = phi_1918_;
                        let _e1088 = (_e1086 - (((_e1040 * _e1043) + (_e1052 * _e1055)) + ((_e1065 * _e1068) + (_e1077 * _e1080))));
                        let _e1092 = local.member[0u][1u];
                        let _e1095 = local.member_1[1u];
                        let _e1100 = local.member[1u][1u];
                        let _e1103 = local.member_1[0u];
                        let _e1105 = ((_e1092 * _e1095) - (_e1100 * _e1103));
                        let _e1109 = local.member[1u][1u];
                        if (_e1109 < 0f) {
                            phi_1973_ = -(_e1109);
                        } else {
                            phi_1973_ = _e1109;
                        }
                        let _e1113 = phi_1973_;
                        let _e1116 = local.member_3[0u];
                        let _e1121 = local.member[0u][1u];
                        if (_e1121 < 0f) {
                            phi_1996_ = -(_e1121);
                        } else {
                            phi_1996_ = _e1121;
                        }
                        let _e1125 = phi_1996_;
                        let _e1128 = local.member_3[1u];
                        let _e1134 = local.member[2u][0u];
                        if (_e1134 < 0f) {
                            phi_2020_ = -(_e1134);
                        } else {
                            phi_2020_ = _e1134;
                        }
                        let _e1138 = phi_2020_;
                        let _e1141 = local.member_4[2u];
                        let _e1146 = local.member[2u][2u];
                        if (_e1146 < 0f) {
                            phi_2043_ = -(_e1146);
                        } else {
                            phi_2043_ = _e1146;
                        }
                        let _e1150 = phi_2043_;
                        let _e1153 = local.member_4[0u];
                        if (_e1105 < 0f) {
                            phi_2059_ = -(_e1105);
                        } else {
                            phi_2059_ = _e1105;
                        }
                        let _e1159 = phi_2059_;
                        let _e1161 = (_e1159 - (((_e1113 * _e1116) + (_e1125 * _e1128)) + ((_e1138 * _e1141) + (_e1150 * _e1153))));
                        let _e1165 = local.member[0u][2u];
                        let _e1168 = local.member_1[1u];
                        let _e1173 = local.member[1u][2u];
                        let _e1176 = local.member_1[0u];
                        let _e1178 = ((_e1165 * _e1168) - (_e1173 * _e1176));
                        let _e1182 = local.member[1u][2u];
                        if (_e1182 < 0f) {
                            phi_2114_ = -(_e1182);
                        } else {
                            phi_2114_ = _e1182;
                        }
                        let _e1186 = phi_2114_;
                        let _e1189 = local.member_3[0u];
                        let _e1194 = local.member[0u][2u];
                        if (_e1194 < 0f) {
                            phi_2137_ = -(_e1194);
                        } else {
                            phi_2137_ = _e1194;
                        }
                        let _e1198 = phi_2137_;
                        let _e1201 = local.member_3[1u];
                        let _e1207 = local.member[2u][1u];
                        if (_e1207 < 0f) {
                            phi_2161_ = -(_e1207);
                        } else {
                            phi_2161_ = _e1207;
                        }
                        let _e1211 = phi_2161_;
                        let _e1214 = local.member_4[0u];
                        let _e1219 = local.member[2u][0u];
                        if (_e1219 < 0f) {
                            phi_2184_ = -(_e1219);
                        } else {
                            phi_2184_ = _e1219;
                        }
                        let _e1223 = phi_2184_;
                        let _e1226 = local.member_4[1u];
                        if (_e1178 < 0f) {
                            phi_2200_ = -(_e1178);
                        } else {
                            phi_2200_ = _e1178;
                        }
                        let _e1232 = phi_2200_;
                        let _e1234 = (_e1232 - (((_e1186 * _e1189) + (_e1198 * _e1201)) + ((_e1211 * _e1214) + (_e1223 * _e1226))));
                        if (_e650 > _e723) {
                            phi_2207_ = _e650;
                        } else {
                            phi_2207_ = _e723;
                        }
                        let _e1237 = phi_2207_;
                        if (_e1237 > _e796) {
                            phi_2212_ = _e1237;
                        } else {
                            phi_2212_ = _e796;
                        }
                        let _e1240 = phi_2212_;
                        if (_e869 > _e942) {
                            phi_2217_ = _e869;
                        } else {
                            phi_2217_ = _e942;
                        }
                        let _e1243 = phi_2217_;
                        if (_e1243 > _e1015) {
                            phi_2222_ = _e1243;
                        } else {
                            phi_2222_ = _e1015;
                        }
                        let _e1246 = phi_2222_;
                        if (_e1240 > _e1246) {
                            phi_2227_ = _e1240;
                        } else {
                            phi_2227_ = _e1246;
                        }
                        let _e1249 = phi_2227_;
                        if (_e1088 > _e1161) {
                            phi_2232_ = _e1088;
                        } else {
                            phi_2232_ = _e1161;
                        }
                        let _e1252 = phi_2232_;
                        if (_e1252 > _e1234) {
                            phi_2237_ = _e1252;
                        } else {
                            phi_2237_ = _e1234;
                        }
                        let _e1255 = phi_2237_;
                        if (_e1249 > _e1255) {
                            phi_2242_ = _e1249;
                        } else {
                            phi_2242_ = _e1255;
                        }
                        let _e1258 = phi_2242_;
                        let _e1260 = local.member_5;
                        phi_2246_ = (_e1258 > _e1260);
                    }
                    let _e1263 = phi_2246_;
                    if !(_e1263) {
                        let _e1280 = local_1.member_2;
                        let _e1282 = nodes.member[_e1280];
                        let _e1327 = ((((((bitcast<f32>(_e1282.member.x) <= _e83.member_1.y) && (_e83.member.x <= bitcast<f32>(_e1282.member_1.x))) && (bitcast<f32>(_e1282.member.y) <= _e83.member_2.x)) && (_e83.member.y <= bitcast<f32>(_e1282.member_1.y))) && (bitcast<f32>(_e1282.member.z) <= _e83.member_2.y)) && (_e83.member_1.x <= bitcast<f32>(_e1282.member_1.z)));
                        let _e1338 = ((((((bitcast<f32>(_e1282.member_2.x) <= _e83.member_1.y) && (_e83.member.x <= bitcast<f32>(_e1282.member_3.x))) && (bitcast<f32>(_e1282.member_2.y) <= _e83.member_2.x)) && (_e83.member.y <= bitcast<f32>(_e1282.member_3.y))) && (bitcast<f32>(_e1282.member_2.z) <= _e83.member_2.y)) && (_e83.member_1.x <= bitcast<f32>(_e1282.member_3.z)));
                        let _e1340 = ((_e1282.member.w & 2147483648u) != 0u);
                        let _e1342 = ((_e1282.member_1.w & 2147483648u) != 0u);
                        if _e1327 {
                            if _e1340 {
                                phi_2354_ = (_e1282.member.w & 2147483647u);
                                phi_2355_ = false;
                            } else {
                                phi_2354_ = u32();
                                phi_2355_ = true;
                            }
                            let _e1345 = phi_2354_;
                            let _e1347 = phi_2355_;
                            phi_2356_ = _e1345;
                            phi_2357_ = _e1347;
                        } else {
                            phi_2356_ = u32();
                            phi_2357_ = true;
                        }
                        let _e1349 = phi_2356_;
                        let _e1351 = phi_2357_;
                        if _e1351 {
                            phi_2361_ = 4294967295u;
                        } else {
                            phi_2361_ = _e1349;
                        }
                        let _e1353 = phi_2361_;
                        if _e1338 {
                            if _e1342 {
                                phi_2369_ = (_e1282.member_1.w & 2147483647u);
                                phi_2370_ = false;
                            } else {
                                phi_2369_ = u32();
                                phi_2370_ = true;
                            }
                            let _e1356 = phi_2369_;
                            let _e1358 = phi_2370_;
                            phi_2371_ = _e1356;
                            phi_2372_ = _e1358;
                        } else {
                            phi_2371_ = u32();
                            phi_2372_ = true;
                        }
                        let _e1360 = phi_2371_;
                        let _e1362 = phi_2372_;
                        if _e1362 {
                            phi_2376_ = 4294967295u;
                        } else {
                            phi_2376_ = _e1360;
                        }
                        let _e1364 = phi_2376_;
                        if _e1327 {
                            phi_2381_ = !(_e1340);
                        } else {
                            phi_2381_ = false;
                        }
                        let _e1367 = phi_2381_;
                        if _e1338 {
                            phi_2386_ = !(_e1342);
                        } else {
                            phi_2386_ = false;
                        }
                        let _e1370 = phi_2386_;
                        if _e1367 {
                            if _e1370 {
                                let _e1372 = ((_e1282.member_3.w & 2147483648u) != 0u);
                                if _e1372 {
                                    phi_2398_ = _e1282.member_1.w;
                                } else {
                                    phi_2398_ = _e1282.member.w;
                                }
                                let _e1374 = phi_2398_;
                                let _e1376 = local_1.member_1;
                                local_1.member[_e1376] = _e1374;
                                let _e1381 = local_1.member_1;
                                local_1.member_1 = (_e1381 + 1u);
                                if _e1372 {
                                    phi_2414_ = _e1282.member.w;
                                } else {
                                    phi_2414_ = _e1282.member_1.w;
                                }
                                let _e1384 = phi_2414_;
                                local_1.member_2 = _e1384;
                                phi_2416_ = false;
                            } else {
                                phi_2416_ = true;
                            }
                            let _e1387 = phi_2416_;
                            phi_2417_ = _e1387;
                        } else {
                            phi_2417_ = true;
                        }
                        let _e1389 = phi_2417_;
                        if _e1389 {
                            if _e1367 {
                                local_1.member_2 = _e1282.member.w;
                            } else {
                                if _e1370 {
                                    local_1.member_2 = _e1282.member_1.w;
                                } else {
                                    let _e1391 = local_1.member_1;
                                    if (_e1391 > 0u) {
                                        let _e1396 = local_1.member_1;
                                        local_1.member_1 = (_e1396 - 1u);
                                        let _e1399 = local_1.member_1;
                                        let _e1402 = local_1.member[_e1399];
                                        local_1.member_2 = _e1402;
                                    } else {
                                        local_1.member_3 = false;
                                    }
                                }
                            }
                        }
                        if (_e1353 != 4294967295u) {
                            let _e1409 = params.member.member_2.member;
                            if (_e1409 == 0u) {
                                phi_2463_ = array<u32, 2>(0u, 2u);
                            } else {
                                phi_2463_ = array<u32, 2>(1u, 1u);
                            }
                            let _e1412 = phi_2463_;
                            let _e1417 = params.member.member.member_2[_e1412[1]];
                            let _e1420 = order.member[(_e1417 + _e1353)];
                            let _e1421 = (_e1420 - _e1417);
                            let _e1424 = params.member.member_2.member;
                            if (_e1424 == 0u) {
                                phi_2496_ = true;
                            } else {
                                phi_2496_ = (_e1421 > _e100);
                            }
                            let _e1428 = phi_2496_;
                            if _e1428 {
                                let _e1431 = params.member.member_1.member_3;
                                let _e1433 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1433 + 1u) < _e1433) {
                                    let _e1437 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1433 < _e1431) {
                                    let _e1439 = (2u * _e1433);
                                    atomicStore((&pairs.member[(4u + _e1439)]), _e100);
                                    atomicStore((&pairs.member[(_e1439 + 5u)]), _e1421);
                                }
                            }
                        }
                        if (_e1364 != 4294967295u) {
                            let _e1447 = params.member.member_2.member;
                            if (_e1447 == 0u) {
                                phi_2539_ = array<u32, 2>(0u, 2u);
                            } else {
                                phi_2539_ = array<u32, 2>(1u, 1u);
                            }
                            let _e1450 = phi_2539_;
                            let _e1455 = params.member.member.member_2[_e1450[1]];
                            let _e1458 = order.member[(_e1455 + _e1364)];
                            let _e1459 = (_e1458 - _e1455);
                            let _e1462 = params.member.member_2.member;
                            if (_e1462 == 0u) {
                                phi_2572_ = true;
                            } else {
                                phi_2572_ = (_e1459 > _e100);
                            }
                            let _e1466 = phi_2572_;
                            if _e1466 {
                                let _e1469 = params.member.member_1.member_3;
                                let _e1471 = atomicAdd((&pairs.member[0u]), 1u);
                                if ((_e1471 + 1u) < _e1471) {
                                    let _e1475 = atomicAdd((&pairs.member[2u]), 1u);
                                }
                                if (_e1471 < _e1469) {
                                    let _e1477 = (2u * _e1471);
                                    atomicStore((&pairs.member[(4u + _e1477)]), _e100);
                                    atomicStore((&pairs.member[(_e1477 + 5u)]), _e1459);
                                }
                            }
                        }
                    } else {
                        let _e1266 = local_1.member_1;
                        if (_e1266 > 0u) {
                            let _e1271 = local_1.member_1;
                            local_1.member_1 = (_e1271 - 1u);
                            let _e1274 = local_1.member_1;
                            let _e1277 = local_1.member[_e1274];
                            local_1.member_2 = _e1277;
                        } else {
                            local_1.member_3 = false;
                        }
                    }
                }
                phi_2623_ = _e195;
            } else {
                phi_2623_ = false;
            }
            let _e1483 = phi_2623_;
            continue;
            continuing {
                phi_379_ = _e188;
                break if !(_e1483);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_full_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
