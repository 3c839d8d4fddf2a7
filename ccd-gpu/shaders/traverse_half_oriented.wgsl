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

struct type_15 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_16 {
    member: type_7,
    member_1: type_8,
    member_2: type_15,
}

struct type_17 {
    member: type_16,
}

struct type_20 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_23 {
    member: vec4<u32>,
    member_1: vec4<u32>,
    member_2: vec4<u32>,
    member_3: vec4<u32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_30 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_32 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_34 {
    member: array<type_32>,
}

struct type_37 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(3) 
var<storage> nodes: type_25;
@group(0) @binding(1) 
var<storage> leaves: type_22;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_37;
@group(0) @binding(4) 
var<storage> oriented: type_34;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_30;
    var local_1: type_28;
    var phi_231_: type_9;
    var phi_232_: type_9;
    var phi_255_: type_9;
    var phi_315_: f32;
    var phi_320_: f32;
    var phi_325_: f32;
    var phi_365_: f32;
    var phi_371_: f32;
    var phi_378_: f32;
    var phi_385_: f32;
    var phi_391_: f32;
    var phi_398_: f32;
    var phi_405_: f32;
    var phi_411_: f32;
    var phi_418_: f32;
    var phi_511_: f32;
    var phi_518_: f32;
    var phi_524_: f32;
    var phi_530_: f32;
    var phi_549_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_568_: f32;
    var phi_587_: f32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_606_: f32;
    var phi_625_: f32;
    var phi_632_: f32;
    var phi_638_: f32;
    var phi_644_: f32;
    var phi_663_: f32;
    var phi_670_: f32;
    var phi_676_: f32;
    var phi_682_: f32;
    var phi_701_: f32;
    var phi_708_: f32;
    var phi_714_: f32;
    var phi_720_: f32;
    var phi_735_: f32;
    var phi_740_: f32;
    var phi_745_: f32;
    var phi_750_: f32;
    var phi_755_: f32;
    var phi_814_: f32;
    var phi_837_: f32;
    var phi_860_: f32;
    var phi_882_: f32;
    var phi_898_: f32;
    var phi_953_: f32;
    var phi_976_: f32;
    var phi_999_: f32;
    var phi_1021_: f32;
    var phi_1037_: f32;
    var phi_1092_: f32;
    var phi_1115_: f32;
    var phi_1138_: f32;
    var phi_1160_: f32;
    var phi_1176_: f32;
    var phi_1231_: f32;
    var phi_1254_: f32;
    var phi_1278_: f32;
    var phi_1301_: f32;
    var phi_1317_: f32;
    var phi_1372_: f32;
    var phi_1395_: f32;
    var phi_1419_: f32;
    var phi_1442_: f32;
    var phi_1458_: f32;
    var phi_1513_: f32;
    var phi_1536_: f32;
    var phi_1560_: f32;
    var phi_1583_: f32;
    var phi_1599_: f32;
    var phi_1654_: f32;
    var phi_1677_: f32;
    var phi_1701_: f32;
    var phi_1724_: f32;
    var phi_1740_: f32;
    var phi_1795_: f32;
    var phi_1818_: f32;
    var phi_1842_: f32;
    var phi_1865_: f32;
    var phi_1881_: f32;
    var phi_1936_: f32;
    var phi_1959_: f32;
    var phi_1983_: f32;
    var phi_2006_: f32;
    var phi_2022_: f32;
    var phi_2029_: f32;
    var phi_2034_: f32;
    var phi_2039_: f32;
    var phi_2044_: f32;
    var phi_2049_: f32;
    var phi_2054_: f32;
    var phi_2059_: f32;
    var phi_2064_: f32;
    var phi_2068_: bool;
    var phi_2126_: bool;
    var phi_2141_: bool;
    var phi_2149_: bool;
    var phi_2164_: bool;
    var phi_2176_: u32;
    var phi_2177_: bool;
    var phi_2178_: u32;
    var phi_2179_: bool;
    var phi_2183_: u32;
    var phi_2191_: u32;
    var phi_2192_: bool;
    var phi_2193_: u32;
    var phi_2194_: bool;
    var phi_2198_: u32;
    var phi_2203_: bool;
    var phi_2208_: bool;
    var phi_2220_: u32;
    var phi_2236_: u32;
    var phi_2238_: bool;
    var phi_2239_: bool;
    var phi_2300_: type_9;
    var phi_2354_: type_9;
    var phi_2401_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e35 = id_2;
    let _e36 = n_2;
    let _e37 = lane_2;
    let _e50 = ((((_e35.y * _e36.x) + _e35.x) * 128u) + _e37);
    let _e53 = params.member.member_1.member;
    if (_e50 < _e53) {
        let _e57 = params.member.member_1.member_1;
        let _e58 = (_e57 + _e50);
        let _e63 = params.member.member_2.member[0u][1u];
        let _e66 = leaves.member[(_e63 + _e58)];
        let _e82 = params.member.member.member_2[1u];
        let _e86 = params.member.member.member[1u];
        let _e89 = order.member[(_e82 + _e58)];
        let _e90 = (_e89 - _e82);
        local_1 = type_28(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
        phi_231_ = type_9(0u, (_e86 - 1u));
        loop {
            let _e94 = phi_231_;
            if (_e94.member < _e94.member_1) {
                phi_232_ = type_9((_e94.member + 1u), _e94.member_1);
                phi_255_ = type_9(1u, _e94.member);
            } else {
                phi_232_ = _e94;
                phi_255_ = type_9(0u, type_9().member_1);
            }
            let _e106 = phi_232_;
            let _e108 = phi_255_;
            if (bitcast<i32>(_e108.member) != 0i) {
                let _e113 = local_1.member_3;
                if _e113 {
                    let _e115 = local_1.member_2;
                    let _e118 = oriented.member[(_e82 + _e115)];
                    let _e155 = ((_e66.member.x * 0.5f) + (_e66.member_1.y * 0.5f));
                    let _e156 = ((_e66.member.y * 0.5f) + (_e66.member_2.x * 0.5f));
                    let _e157 = ((_e66.member_1.x * 0.5f) + (_e66.member_2.y * 0.5f));
                    let _e158 = (_e66.member_1.y - _e155);
                    let _e159 = (_e66.member_2.x - _e156);
                    let _e160 = (_e66.member_2.y - _e157);
                    let _e161 = (_e155 - _e66.member.x);
                    let _e162 = (_e156 - _e66.member.y);
                    let _e163 = (_e157 - _e66.member_1.x);
                    if (_e158 > _e161) {
                        phi_315_ = _e158;
                    } else {
                        phi_315_ = _e161;
                    }
                    let _e166 = phi_315_;
                    if (_e159 > _e162) {
                        phi_320_ = _e159;
                    } else {
                        phi_320_ = _e162;
                    }
                    let _e169 = phi_320_;
                    if (_e160 > _e163) {
                        phi_325_ = _e160;
                    } else {
                        phi_325_ = _e163;
                    }
                    let _e172 = phi_325_;
                    let _e174 = (1f + (0.000000059604645f * 4f));
                    let _e178 = (0.000000000000000000000000000000000000011754944f * 8f);
                    let _e179 = ((_e166 * _e174) + _e178);
                    let _e180 = ((_e169 * _e174) + _e178);
                    let _e181 = ((_e172 * _e174) + _e178);
                    let _e182 = (_e118.member.x - _e155);
                    let _e183 = (_e118.member.y - _e156);
                    let _e184 = (_e118.member.z - _e157);
                    if (_e182 < 0f) {
                        phi_365_ = -(_e182);
                    } else {
                        phi_365_ = _e182;
                    }
                    let _e203 = phi_365_;
                    if (_e183 < 0f) {
                        phi_371_ = -(_e183);
                    } else {
                        phi_371_ = _e183;
                    }
                    let _e207 = phi_371_;
                    if (_e184 < 0f) {
                        phi_378_ = -(_e184);
                    } else {
                        phi_378_ = _e184;
                    }
                    let _e212 = phi_378_;
                    if (_e179 < 0f) {
                        phi_385_ = -(_e179);
                    } else {
                        phi_385_ = _e179;
                    }
                    let _e217 = phi_385_;
                    if (_e180 < 0f) {
                        phi_391_ = -(_e180);
                    } else {
                        phi_391_ = _e180;
                    }
                    let _e221 = phi_391_;
                    if (_e181 < 0f) {
                        phi_398_ = -(_e181);
                    } else {
                        phi_398_ = _e181;
                    }
                    let _e226 = phi_398_;
                    if (_e118.member_3.x < 0f) {
                        phi_405_ = -(_e118.member_3.x);
                    } else {
                        phi_405_ = _e118.member_3.x;
                    }
                    let _e231 = phi_405_;
                    if (_e118.member_3.y < 0f) {
                        phi_411_ = -(_e118.member_3.y);
                    } else {
                        phi_411_ = _e118.member_3.y;
                    }
                    let _e235 = phi_411_;
                    if (_e118.member_3.z < 0f) {
                        phi_418_ = -(_e118.member_3.z);
                    } else {
                        phi_418_ = _e118.member_3.z;
                    }
                    let _e240 = phi_418_;
                    local = type_30(array<array<f32, 3>, 3>(array<f32, 3>(_e118.member.w, _e118.member_1.z, _e118.member_2.y), array<f32, 3>(_e118.member_1.x, _e118.member_1.w, _e118.member_2.z), array<f32, 3>(_e118.member_1.y, _e118.member_2.x, _e118.member_2.w)), array<f32, 3>(_e182, _e183, _e184), array<f32, 3>((((_e118.member.w * _e182) + (_e118.member_1.x * _e183)) + (_e118.member_1.y * _e184)), (((_e118.member_1.z * _e182) + (_e118.member_1.w * _e183)) + (_e118.member_2.x * _e184)), (((_e118.member_2.y * _e182) + (_e118.member_2.z * _e183)) + (_e118.member_2.w * _e184))), array<f32, 3>(_e179, _e180, _e181), array<f32, 3>(_e118.member_3.x, _e118.member_3.y, _e118.member_3.z), ((((((_e203 + _e207) + _e212) + (((_e217 + _e221) + _e226) + ((_e231 + _e235) + _e240))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e261 = local.member[0u][0u];
                    let _e265 = local.member[0u][1u];
                    let _e269 = local.member[0u][2u];
                    let _e273 = local.member[1u][0u];
                    let _e277 = local.member[1u][1u];
                    let _e281 = local.member[1u][2u];
                    let _e285 = local.member[2u][0u];
                    let _e289 = local.member[2u][1u];
                    let _e293 = local.member[2u][2u];
                    let _e295 = local.member_3;
                    let _e300 = local.member_4;
                    let _e306 = local.member_1[0u];
                    if (_e306 < 0f) {
                        phi_511_ = -(_e306);
                    } else {
                        phi_511_ = _e306;
                    }
                    let _e310 = phi_511_;
                    if (_e261 < 0f) {
                        phi_518_ = -(_e261);
                    } else {
                        phi_518_ = _e261;
                    }
                    let _e314 = phi_518_;
                    if (_e265 < 0f) {
                        phi_524_ = -(_e265);
                    } else {
                        phi_524_ = _e265;
                    }
                    let _e318 = phi_524_;
                    if (_e269 < 0f) {
                        phi_530_ = -(_e269);
                    } else {
                        phi_530_ = _e269;
                    }
                    let _e322 = phi_530_;
                    let _e329 = (_e310 - (_e295[0] + (((_e314 * _e300[0]) + (_e318 * _e300[1])) + (_e322 * _e300[2]))));
                    let _e332 = local.member_1[1u];
                    if (_e332 < 0f) {
                        phi_549_ = -(_e332);
                    } else {
                        phi_549_ = _e332;
                    }
                    let _e336 = phi_549_;
                    if (_e273 < 0f) {
                        phi_556_ = -(_e273);
                    } else {
                        phi_556_ = _e273;
                    }
                    let _e340 = phi_556_;
                    if (_e277 < 0f) {
                        phi_562_ = -(_e277);
                    } else {
                        phi_562_ = _e277;
                    }
                    let _e344 = phi_562_;
                    if (_e281 < 0f) {
                        phi_568_ = -(_e281);
                    } else {
                        phi_568_ = _e281;
                    }
                    let _e348 = phi_568_;
                    let _e355 = (_e336 - (_e295[1] + (((_e340 * _e300[0]) + (_e344 * _e300[1])) + (_e348 * _e300[2]))));
                    let _e358 = local.member_1[2u];
                    if (_e358 < 0f) {
                        phi_587_ = -(_e358);
                    } else {
                        phi_587_ = _e358;
                    }
                    let _e362 = phi_587_;
                    if (_e285 < 0f) {
                        phi_594_ = -(_e285);
                    } else {
                        phi_594_ = _e285;
                    }
                    let _e366 = phi_594_;
                    if (_e289 < 0f) {
                        phi_600_ = -(_e289);
                    } else {
                        phi_600_ = _e289;
                    }
                    let _e370 = phi_600_;
                    if (_e293 < 0f) {
                        phi_606_ = -(_e293);
                    } else {
                        phi_606_ = _e293;
                    }
                    let _e374 = phi_606_;
                    let _e381 = (_e362 - (_e295[2] + (((_e366 * _e300[0]) + (_e370 * _e300[1])) + (_e374 * _e300[2]))));
                    let _e384 = local.member_2[0u];
                    if (_e384 < 0f) {
                        phi_625_ = -(_e384);
                    } else {
                        phi_625_ = _e384;
                    }
                    let _e388 = phi_625_;
                    if (_e261 < 0f) {
                        phi_632_ = -(_e261);
                    } else {
                        phi_632_ = _e261;
                    }
                    let _e392 = phi_632_;
                    if (_e273 < 0f) {
                        phi_638_ = -(_e273);
                    } else {
                        phi_638_ = _e273;
                    }
                    let _e396 = phi_638_;
                    if (_e285 < 0f) {
                        phi_644_ = -(_e285);
                    } else {
                        phi_644_ = _e285;
                    }
                    let _e400 = phi_644_;
                    let _e407 = (_e388 - (_e300[0] + (((_e392 * _e295[0]) + (_e396 * _e295[1])) + (_e400 * _e295[2]))));
                    let _e410 = local.member_2[1u];
                    if (_e410 < 0f) {
                        phi_663_ = -(_e410);
                    } else {
                        phi_663_ = _e410;
                    }
                    let _e414 = phi_663_;
                    if (_e265 < 0f) {
                        phi_670_ = -(_e265);
                    } else {
                        phi_670_ = _e265;
                    }
                    let _e418 = phi_670_;
                    if (_e277 < 0f) {
                        phi_676_ = -(_e277);
                    } else {
                        phi_676_ = _e277;
                    }
                    let _e422 = phi_676_;
                    if (_e289 < 0f) {
                        phi_682_ = -(_e289);
                    } else {
                        phi_682_ = _e289;
                    }
                    let _e426 = phi_682_;
                    let _e433 = (_e414 - (_e300[1] + (((_e418 * _e295[0]) + (_e422 * _e295[1])) + (_e426 * _e295[2]))));
                    let _e436 = local.member_2[2u];
                    if (_e436 < 0f) {
                        phi_701_ = -(_e436);
                    } else {
                        phi_701_ = _e436;
                    }
                    let _e440 = phi_701_;
                    if (_e269 < 0f) {
                        phi_708_ = -(_e269);
                    } else {
                        phi_708_ = _e269;
                    }
                    let _e444 = phi_708_;
                    if (_e281 < 0f) {
                        phi_714_ = -(_e281);
                    } else {
                        phi_714_ = _e281;
                    }
                    let _e448 = phi_714_;
                    if (_e293 < 0f) {
                        phi_720_ = -(_e293);
                    } else {
                        phi_720_ = _e293;
                    }
                    let _e452 = phi_720_;
                    let _e459 = (_e440 - (_e300[2] + (((_e444 * _e295[0]) + (_e448 * _e295[1])) + (_e452 * _e295[2]))));
                    if (_e329 > _e355) {
                        phi_735_ = _e329;
                    } else {
                        phi_735_ = _e355;
                    }
                    let _e462 = phi_735_;
                    if (_e462 > _e381) {
                        phi_740_ = _e462;
                    } else {
                        phi_740_ = _e381;
                    }
                    let _e465 = phi_740_;
                    if (_e407 > _e433) {
                        phi_745_ = _e407;
                    } else {
                        phi_745_ = _e433;
                    }
                    let _e468 = phi_745_;
                    if (_e468 > _e459) {
                        phi_750_ = _e468;
                    } else {
                        phi_750_ = _e459;
                    }
                    let _e471 = phi_750_;
                    if (_e465 > _e471) {
                        phi_755_ = _e465;
                    } else {
                        phi_755_ = _e471;
                    }
                    let _e474 = phi_755_;
                    let _e476 = local.member_5;
                    if (_e474 > _e476) {
                        phi_2068_ = true;
                    } else {
                        let _e481 = local.member[1u][0u];
                        let _e484 = local.member_1[2u];
                        let _e489 = local.member[2u][0u];
                        let _e492 = local.member_1[1u];
                        let _e494 = ((_e481 * _e484) - (_e489 * _e492));
                        let _e498 = local.member[2u][0u];
                        if (_e498 < 0f) {
                            phi_814_ = -(_e498);
                        } else {
                            phi_814_ = _e498;
                        }
                        let _e502 = phi_814_;
                        let _e505 = local.member_3[1u];
                        let _e510 = local.member[1u][0u];
                        if (_e510 < 0f) {
                            phi_837_ = -(_e510);
                        } else {
                            phi_837_ = _e510;
                        }
                        let _e514 = phi_837_;
                        let _e517 = local.member_3[2u];
                        let _e523 = local.member[0u][2u];
                        if (_e523 < 0f) {
                            phi_860_ = -(_e523);
                        } else {
                            phi_860_ = _e523;
                        }
                        let _e527 = phi_860_;
                        let _e530 = local.member_4[1u];
                        let _e535 = local.member[0u][1u];
                        if (_e535 < 0f) {
                            phi_882_ = -(_e535);
                        } else {
                            phi_882_ = _e535;
                        }
                        let _e539 = phi_882_;
                        let _e542 = local.member_4[2u];
                        if (_e494 < 0f) {
                            phi_898_ = -(_e494);
                        } else {
                            phi_898_ = _e494;
                        }
                        let _e548 = phi_898_;
                        let _e550 = (_e548 - (((_e502 * _e505) + (_e514 * _e517)) + ((_e527 * _e530) + (_e539 * _e542))));
                        let _e554 = local.member[1u][1u];
                        let _e557 = local.member_1[2u];
                        let _e562 = local.member[2u][1u];
                        let _e565 = local.member_1[1u];
                        let _e567 = ((_e554 * _e557) - (_e562 * _e565));
                        let _e571 = local.member[2u][1u];
                        if (_e571 < 0f) {
                            phi_953_ = -(_e571);
                        } else {
                            phi_953_ = _e571;
                        }
                        let _e575 = phi_953_;
                        let _e578 = local.member_3[1u];
                        let _e583 = local.member[1u][1u];
                        if (_e583 < 0f) {
                            phi_976_ = -(_e583);
                        } else {
                            phi_976_ = _e583;
                        }
                        let _e587 = phi_976_;
                        let _e590 = local.member_3[2u];
                        let _e596 = local.member[0u][0u];
                        if (_e596 < 0f) {
                            phi_999_ = -(_e596);
                        } else {
                            phi_999_ = _e596;
                        }
                        let _e600 = phi_999_;
                        let _e603 = local.member_4[2u];
                        let _e608 = local.member[0u][2u];
                        if (_e608 < 0f) {
                            phi_1021_ = -(_e608);
                        } else {
                            phi_1021_ = _e608;
                        }
                        let _e612 = phi_1021_;
                        let _e615 = local.member_4[0u];
                        if (_e567 < 0f) {
                            phi_1037_ = -(_e567);
                        } else {
                            phi_1037_ = _e567;
                        }
                        let _e621 = phi_1037_;
                        let _e623 = (_e621 - (((_e575 * _e578) + (_e587 * _e590)) + ((_e600 * _e603) + (_e612 * _e615))));
                        let _e627 = local.member[1u][2u];
                        let _e630 = local.member_1[2u];
                        let _e635 = local.member[2u][2u];
                        let _e638 = local.member_1[1u];
                        let _e640 = ((_e627 * _e630) - (_e635 * _e638));
                        let _e644 = local.member[2u][2u];
                        if (_e644 < 0f) {
                            phi_1092_ = -(_e644);
                        } else {
                            phi_1092_ = _e644;
                        }
                        let _e648 = phi_1092_;
                        let _e651 = local.member_3[1u];
                        let _e656 = local.member[1u][2u];
                        if (_e656 < 0f) {
                            phi_1115_ = -(_e656);
                        } else {
                            phi_1115_ = _e656;
                        }
                        let _e660 = phi_1115_;
                        let _e663 = local.member_3[2u];
                        let _e669 = local.member[0u][1u];
                        if (_e669 < 0f) {
                            phi_1138_ = -(_e669);
                        } else {
                            phi_1138_ = _e669;
                        }
                        let _e673 = phi_1138_;
                        let _e676 = local.member_4[0u];
                        let _e681 = local.member[0u][0u];
                        if (_e681 < 0f) {
                            phi_1160_ = -(_e681);
                        } else {
                            phi_1160_ = _e681;
                        }
                        let _e685 = phi_1160_;
                        let _e688 = local.member_4[1u];
                        if (_e640 < 0f) {
                            phi_1176_ = -(_e640);
                        } else {
                            phi_1176_ = _e640;
                        }
                        let _e694 = phi_1176_;
                        let _e696 = (_e694 - (((_e648 * _e651) + (_e660 * _e663)) + ((_e673 * _e676) + (_e685 * _e688))));
                        let _e700 = local.member[2u][0u];
                        let _e703 = local.member_1[0u];
                        let _e708 = local.member[0u][0u];
                        let _e711 = local.member_1[2u];
                        let _e713 = ((_e700 * _e703) - (_e708 * _e711));
                        let _e717 = local.member[0u][0u];
                        if (_e717 < 0f) {
                            phi_1231_ = -(_e717);
                        } else {
                            phi_1231_ = _e717;
                        }
                        let _e721 = phi_1231_;
                        let _e724 = local.member_3[2u];
                        let _e729 = local.member[2u][0u];
                        if (_e729 < 0f) {
                            phi_1254_ = -(_e729);
                        } else {
                            phi_1254_ = _e729;
                        }
                        let _e733 = phi_1254_;
                        let _e736 = local.member_3[0u];
                        let _e742 = local.member[1u][2u];
                        if (_e742 < 0f) {
                            phi_1278_ = -(_e742);
                        } else {
                            phi_1278_ = _e742;
                        }
                        let _e746 = phi_1278_;
                        let _e749 = local.member_4[1u];
                        let _e754 = local.member[1u][1u];
                        if (_e754 < 0f) {
                            phi_1301_ = -(_e754);
                        } else {
                            phi_1301_ = _e754;
                        }
                        let _e758 = phi_1301_;
                        let _e761 = local.member_4[2u];
                        if (_e713 < 0f) {
                            phi_1317_ = -(_e713);
                        } else {
                            phi_1317_ = _e713;
                        }
                        let _e767 = phi_1317_;
                        let _e769 = (_e767 - (((_e721 * _e724) + (_e733 * _e736)) + ((_e746 * _e749) + (_e758 * _e761))));
                        let _e773 = local.member[2u][1u];
                        let _e776 = local.member_1[0u];
                        let _e781 = local.member[0u][1u];
                        let _e784 = local.member_1[2u];
                        let _e786 = ((_e773 * _e776) - (_e781 * _e784));
                        let _e790 = local.member[0u][1u];
                        if (_e790 < 0f) {
                            phi_1372_ = -(_e790);
                        } else {
                            phi_1372_ = _e790;
                        }
                        let _e794 = phi_1372_;
                        let _e797 = local.member_3[2u];
                        let _e802 = local.member[2u][1u];
                        if (_e802 < 0f) {
                            phi_1395_ = -(_e802);
                        } else {
                            phi_1395_ = _e802;
                        }
                        let _e806 = phi_1395_;
                        let _e809 = local.member_3[0u];
                        let _e815 = local.member[1u][0u];
                        if (_e815 < 0f) {
                            phi_1419_ = -(_e815);
                        } else {
                            phi_1419_ = _e815;
                        }
                        let _e819 = phi_1419_;
                        let _e822 = local.member_4[2u];
                        let _e827 = local.member[1u][2u];
                        if (_e827 < 0f) {
                            phi_1442_ = -(_e827);
                        } else {
                            phi_1442_ = _e827;
                        }
                        let _e831 = phi_1442_;
                        let _e834 = local.member_4[0u];
                        if (_e786 < 0f) {
                            phi_1458_ = -(_e786);
                        } else {
                            phi_1458_ = _e786;
                        }
                        let _e840 = phi_1458_;
                        let _e842 = (_e840 - (((_e794 * _e797) + (_e806 * _e809)) + ((_e819 * _e822) + (_e831 * _e834))));
                        let _e846 = local.member[2u][2u];
                        let _e849 = local.member_1[0u];
                        let _e854 = local.member[0u][2u];
                        let _e857 = local.member_1[2u];
                        let _e859 = ((_e846 * _e849) - (_e854 * _e857));
                        let _e863 = local.member[0u][2u];
                        if (_e863 < 0f) {
                            phi_1513_ = -(_e863);
                        } else {
                            phi_1513_ = _e863;
                        }
                        let _e867 = phi_1513_;
                        let _e870 = local.member_3[2u];
                        let _e875 = local.member[2u][2u];
                        if (_e875 < 0f) {
                            phi_1536_ = -(_e875);
                        } else {
                            phi_1536_ = _e875;
                        }
                        let _e879 = phi_1536_;
                        let _e882 = local.member_3[0u];
                        let _e888 = local.member[1u][1u];
                        if (_e888 < 0f) {
                            phi_1560_ = -(_e888);
                        } else {
                            phi_1560_ = _e888;
                        }
                        let _e892 = phi_1560_;
                        let _e895 = local.member_4[0u];
                        let _e900 = local.member[1u][0u];
                        if (_e900 < 0f) {
                            phi_1583_ = -(_e900);
                        } else {
                            phi_1583_ = _e900;
                        }
                        let _e904 = phi_1583_;
                        let _e907 = local.member_4[1u];
                        if (_e859 < 0f) {
                            phi_1599_ = -(_e859);
                        } else {
                            phi_1599_ = _e859;
                        }
                        let _e913 = phi_1599_;
                        let _e915 = (_e913 - (((_e867 * _e870) + (_e879 * _e882)) + ((_e892 * _e895) + (_e904 * _e907))));
                        let _e919 = local.member[0u][0u];
                        let _e922 = local.member_1[1u];
                        let _e927 = local.member[1u][0u];
                        let _e930 = local.member_1[0u];
                        let _e932 = ((_e919 * _e922) - (_e927 * _e930));
                        let _e936 = local.member[1u][0u];
                        if (_e936 < 0f) {
                            phi_1654_ = -(_e936);
                        } else {
                            phi_1654_ = _e936;
                        }
                        let _e940 = phi_1654_;
                        let _e943 = local.member_3[0u];
                        let _e948 = local.member[0u][0u];
                        if (_e948 < 0f) {
                            phi_1677_ = -(_e948);
                        } else {
                            phi_1677_ = _e948;
                        }
                        let _e952 = phi_1677_;
                        let _e955 = local.member_3[1u];
                        let _e961 = local.member[2u][2u];
                        if (_e961 < 0f) {
                            phi_1701_ = -(_e961);
                        } else {
                            phi_1701_ = _e961;
                        }
                        let _e965 = phi_1701_;
                        let _e968 = local.member_4[1u];
                        let _e973 = local.member[2u][1u];
                        if (_e973 < 0f) {
                            phi_1724_ = -(_e973);
                        } else {
                            phi_1724_ = _e973;
                        }
                        let _e977 = phi_1724_;
                        let _e980 = local.member_4[2u];
                        if (_e932 < 0f) {
                            phi_1740_ = -(_e932);
                        } else {
                            phi_1740_ = _e932;
                        }
                        let _e986 = phi_1740_;
                        let _e988 = (_e986 - (((_e940 * _e943) + (_e952 * _e955)) + ((_e965 * _e968) + (_e977 * _e980))));
                        let _e992 = local.member[0u][1u];
                        let _e995 = local.member_1[1u];
                        let _e1000 = local.member[1u][1u];
                        let _e1003 = local.member_1[0u];
                        let _e1005 = ((_e992 * _e995) - (_e1000 * _e1003));
                        let _e1009 = local.member[1u][1u];
                        if (_e1009 < 0f) {
                            phi_1795_ = -(_e1009);
                        } else {
                            phi_1795_ = _e1009;
                        }
                        let _e1013 = phi_1795_;
                        let _e1016 = local.member_3[0u];
                        let _e1021 = local.member[0u][1u];
                        if (_e1021 < 0f) {
                            phi_1818_ = -(_e1021);
                        } else {
                            phi_1818_ = _e1021;
                        }
                        let _e1025 = phi_1818_;
                        let _e1028 = local.member_3[1u];
                        let _e1034 = local.member[2u][0u];
                        if (_e1034 < 0f) {
                            phi_1842_ = -(_e1034);
                        } else {
                            phi_1842_ = _e1034;
                        }
                        let _e1038 = phi_1842_;
                        let _e1041 = local.member_4[2u];
                        let _e1046 = local.member[2u][2u];
                        if (_e1046 < 0f) {
                            phi_1865_ = -(_e1046);
                        } else {
                            phi_1865_ = _e1046;
                        }
                        let _e1050 = phi_1865_;
                        let _e1053 = local.member_4[0u];
                        if (_e1005 < 0f) {
                            phi_1881_ = -(_e1005);
                        } else {
                            phi_1881_ = _e1005;
                        }
                        let _e1059 = phi_1881_;
                        let _e1061 = (_e1059 - (((_e1013 * _e1016) + (_e1025 * _e1028)) + ((_e1038 * _e1041) + (_e1050 * _e1053))));
                        let _e1065 = local.member[0u][2u];
                        let _e1068 = local.member_1[1u];
                        let _e1073 = local.member[1u][2u];
                        let _e1076 = local.member_1[0u];
                        let _e1078 = ((_e1065 * _e1068) - (_e1073 * _e1076));
                        let _e1082 = local.member[1u][2u];
                        if (_e1082 < 0f) {
                            phi_1936_ = -(_e1082);
                        } else {
                            phi_1936_ = _e1082;
                        }
                        let _e1086 = phi_1936_;
                        let _e1089 = local.member_3[0u];
                        let _e1094 = local.member[0u][2u];
                        if (_e1094 < 0f) {
                            phi_1959_ = -(_e1094);
                        } else {
                            phi_1959_ = _e1094;
                        }
                        let _e1098 = phi_1959_;
                        let _e1101 = local.member_3[1u];
                        let _e1107 = local.member[2u][1u];
                        if (_e1107 < 0f) {
                            phi_1983_ = -(_e1107);
                        } else {
                            phi_1983_ = _e1107;
                        }
                        let _e1111 = phi_1983_;
                        let _e1114 = local.member_4[0u];
                        let _e1119 = local.member[2u][0u];
                        if (_e1119 < 0f) {
                            phi_2006_ = -(_e1119);
                        } else {
                            phi_2006_ = _e1119;
                        }
                        let _e1123 = phi_2006_;
                        let _e1126 = local.member_4[1u];
                        if (_e1078 < 0f) {
                            phi_2022_ = -(_e1078);
                        } else {
                            phi_2022_ = _e1078;
                        }
                        let _e1132 = phi_2022_;
                        let _e1134 = (_e1132 - (((_e1086 * _e1089) + (_e1098 * _e1101)) + ((_e1111 * _e1114) + (_e1123 * _e1126))));
                        if (_e550 > _e623) {
                            phi_2029_ = _e550;
                        } else {
                            phi_2029_ = _e623;
                        }
                        let _e1137 = phi_2029_;
                        if (_e1137 > _e696) {
                            phi_2034_ = _e1137;
                        } else {
                            phi_2034_ = _e696;
                        }
                        let _e1140 = phi_2034_;
                        if (_e769 > _e842) {
                            phi_2039_ = _e769;
                        } else {
                            phi_2039_ = _e842;
                        }
                        let _e1143 = phi_2039_;
                        if (_e1143 > _e915) {
                            phi_2044_ = _e1143;
                        } else {
                            phi_2044_ = _e915;
                        }
                        let _e1146 = phi_2044_;
                        if (_e1140 > _e1146) {
                            phi_2049_ = _e1140;
                        } else {
                            phi_2049_ = _e1146;
                        }
                        let _e1149 = phi_2049_;
                        if (_e988 > _e1061) {
                            phi_2054_ = _e988;
                        } else {
                            phi_2054_ = _e1061;
                        }
                        let _e1152 = phi_2054_;
                        if (_e1152 > _e1134) {
                            phi_2059_ = _e1152;
                        } else {
                            phi_2059_ = _e1134;
                        }
                        let _e1155 = phi_2059_;
                        if (_e1149 > _e1155) {
                            phi_2064_ = _e1149;
                        } else {
                            phi_2064_ = _e1155;
                        }
                        let _e1158 = phi_2064_;
                        let _e1160 = local.member_5;
                        phi_2068_ = (_e1158 > _e1160);
                    }
                    let _e1163 = phi_2068_;
                    if !(_e1163) {
                        let _e1180 = local_1.member_2;
                        let _e1182 = nodes.member[_e1180];
                        let _e1219 = (_e58 == 4294967295u);
                        if _e1219 {
                            phi_2126_ = true;
                        } else {
                            phi_2126_ = (_e1182.member_2.w > _e58);
                        }
                        let _e1223 = phi_2126_;
                        if _e1223 {
                            phi_2141_ = ((((((bitcast<f32>(_e1182.member.x) <= _e66.member_1.y) && (_e66.member.x <= bitcast<f32>(_e1182.member_1.x))) && (bitcast<f32>(_e1182.member.y) <= _e66.member_2.x)) && (_e66.member.y <= bitcast<f32>(_e1182.member_1.y))) && (bitcast<f32>(_e1182.member.z) <= _e66.member_2.y)) && (_e66.member_1.x <= bitcast<f32>(_e1182.member_1.z)));
                        } else {
                            phi_2141_ = false;
                        }
                        let _e1236 = phi_2141_;
                        if _e1219 {
                            phi_2149_ = true;
                        } else {
                            phi_2149_ = ((_e1182.member_3.w & 2147483647u) > _e58);
                        }
                        let _e1239 = phi_2149_;
                        if _e1239 {
                            phi_2164_ = ((((((bitcast<f32>(_e1182.member_2.x) <= _e66.member_1.y) && (_e66.member.x <= bitcast<f32>(_e1182.member_3.x))) && (bitcast<f32>(_e1182.member_2.y) <= _e66.member_2.x)) && (_e66.member.y <= bitcast<f32>(_e1182.member_3.y))) && (bitcast<f32>(_e1182.member_2.z) <= _e66.member_2.y)) && (_e66.member_1.x <= bitcast<f32>(_e1182.member_3.z)));
                        } else {
                            phi_2164_ = false;
                        }
                        let _e1252 = phi_2164_;
                        let _e1254 = ((_e1182.member.w & 2147483648u) != 0u);
                        let _e1256 = ((_e1182.member_1.w & 2147483648u) != 0u);
                        if _e1236 {
                            if _e1254 {
                                phi_2176_ = (_e1182.member.w & 2147483647u);
                                phi_2177_ = false;
                            } else {
                                phi_2176_ = u32();
                                phi_2177_ = true;
                            }
                            let _e1259 = phi_2176_;
                            let _e1261 = phi_2177_;
                            phi_2178_ = _e1259;
                            phi_2179_ = _e1261;
                        } else {
                            phi_2178_ = u32();
                            phi_2179_ = true;
                        }
                        let _e1263 = phi_2178_;
                        let _e1265 = phi_2179_;
                        if _e1265 {
                            phi_2183_ = 4294967295u;
                        } else {
                            phi_2183_ = _e1263;
                        }
                        let _e1267 = phi_2183_;
                        if _e1252 {
                            if _e1256 {
                                phi_2191_ = (_e1182.member_1.w & 2147483647u);
                                phi_2192_ = false;
                            } else {
                                phi_2191_ = u32();
                                phi_2192_ = true;
                            }
                            let _e1270 = phi_2191_;
                            let _e1272 = phi_2192_;
                            phi_2193_ = _e1270;
                            phi_2194_ = _e1272;
                        } else {
                            phi_2193_ = u32();
                            phi_2194_ = true;
                        }
                        let _e1274 = phi_2193_;
                        let _e1276 = phi_2194_;
                        if _e1276 {
                            phi_2198_ = 4294967295u;
                        } else {
                            phi_2198_ = _e1274;
                        }
                        let _e1278 = phi_2198_;
                        if _e1236 {
                            phi_2203_ = !(_e1254);
                        } else {
                            phi_2203_ = false;
                        }
                        let _e1281 = phi_2203_;
                        if _e1252 {
                            phi_2208_ = !(_e1256);
                        } else {
                            phi_2208_ = false;
                        }
                        let _e1284 = phi_2208_;
                        if _e1281 {
                            if _e1284 {
                                let _e1286 = ((_e1182.member_3.w & 2147483648u) != 0u);
                                if _e1286 {
                                    phi_2220_ = _e1182.member_1.w;
                                } else {
                                    phi_2220_ = _e1182.member.w;
                                }
                                let _e1288 = phi_2220_;
                                let _e1290 = local_1.member_1;
                                local_1.member[_e1290] = _e1288;
                                let _e1295 = local_1.member_1;
                                local_1.member_1 = (_e1295 + 1u);
                                if _e1286 {
                                    phi_2236_ = _e1182.member.w;
                                } else {
                                    phi_2236_ = _e1182.member_1.w;
                                }
                                let _e1298 = phi_2236_;
                                local_1.member_2 = _e1298;
                                phi_2238_ = false;
                            } else {
                                phi_2238_ = true;
                            }
                            let _e1301 = phi_2238_;
                            phi_2239_ = _e1301;
                        } else {
                            phi_2239_ = true;
                        }
                        let _e1303 = phi_2239_;
                        if _e1303 {
                            if _e1281 {
                                local_1.member_2 = _e1182.member.w;
                            } else {
                                if _e1284 {
                                    local_1.member_2 = _e1182.member_1.w;
                                } else {
                                    let _e1305 = local_1.member_1;
                                    if (_e1305 > 0u) {
                                        let _e1310 = local_1.member_1;
                                        local_1.member_1 = (_e1310 - 1u);
                                        let _e1313 = local_1.member_1;
                                        let _e1316 = local_1.member[_e1313];
                                        local_1.member_2 = _e1316;
                                    } else {
                                        local_1.member_3 = false;
                                    }
                                }
                            }
                        }
                        if (_e1267 != 4294967295u) {
                            let _e1324 = params.member.member.member_2[1u];
                            let _e1327 = order.member[(_e1324 + _e1267)];
                            let _e1328 = (_e1327 - _e1324);
                            let _e1331 = params.member.member_1.member_3;
                            if (_e90 < _e1328) {
                                phi_2300_ = type_9(_e90, _e1328);
                            } else {
                                phi_2300_ = type_9(_e1328, _e90);
                            }
                            let _e1336 = phi_2300_;
                            let _e1340 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e1340 + 1u) < _e1340) {
                                let _e1344 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e1340 < _e1331) {
                                let _e1346 = (2u * _e1340);
                                atomicStore((&pairs.member[(4u + _e1346)]), _e1336.member);
                                atomicStore((&pairs.member[(_e1346 + 5u)]), _e1336.member_1);
                            }
                        }
                        if (_e1278 != 4294967295u) {
                            let _e1355 = params.member.member.member_2[1u];
                            let _e1358 = order.member[(_e1355 + _e1278)];
                            let _e1359 = (_e1358 - _e1355);
                            let _e1362 = params.member.member_1.member_3;
                            if (_e90 < _e1359) {
                                phi_2354_ = type_9(_e90, _e1359);
                            } else {
                                phi_2354_ = type_9(_e1359, _e90);
                            }
                            let _e1367 = phi_2354_;
                            let _e1371 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e1371 + 1u) < _e1371) {
                                let _e1375 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e1371 < _e1362) {
                                let _e1377 = (2u * _e1371);
                                atomicStore((&pairs.member[(4u + _e1377)]), _e1367.member);
                                atomicStore((&pairs.member[(_e1377 + 5u)]), _e1367.member_1);
                            }
                        }
                    } else {
                        let _e1166 = local_1.member_1;
                        if (_e1166 > 0u) {
                            let _e1171 = local_1.member_1;
                            local_1.member_1 = (_e1171 - 1u);
                            let _e1174 = local_1.member_1;
                            let _e1177 = local_1.member[_e1174];
                            local_1.member_2 = _e1177;
                        } else {
                            local_1.member_3 = false;
                        }
                    }
                }
                phi_2401_ = _e113;
            } else {
                phi_2401_ = false;
            }
            let _e1383 = phi_2401_;
            continue;
            continuing {
                phi_231_ = _e106;
                break if !(_e1383);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
