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

struct type_34 {
    member: array<u32, 31>,
    member_1: u32,
    member_2: u32,
    member_3: bool,
}

struct type_37 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(4) 
var<storage> oriented: type_32;
@group(0) @binding(2) 
var<storage> order: type_11;
@group(0) @binding(3) 
var<storage> nodes: type_25;
@group(0) @binding(1) 
var<storage> leaves: type_22;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_37;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_34;
    var phi_231_: type_9;
    var phi_232_: type_9;
    var phi_255_: type_9;
    var phi_309_: f32;
    var phi_314_: f32;
    var phi_319_: f32;
    var phi_324_: f32;
    var phi_329_: f32;
    var phi_334_: f32;
    var phi_345_: f32;
    var phi_350_: f32;
    var phi_355_: f32;
    var phi_395_: f32;
    var phi_401_: f32;
    var phi_408_: f32;
    var phi_415_: f32;
    var phi_421_: f32;
    var phi_428_: f32;
    var phi_435_: f32;
    var phi_441_: f32;
    var phi_448_: f32;
    var phi_541_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_560_: f32;
    var phi_579_: f32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_617_: f32;
    var phi_624_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_655_: f32;
    var phi_662_: f32;
    var phi_668_: f32;
    var phi_674_: f32;
    var phi_693_: f32;
    var phi_700_: f32;
    var phi_706_: f32;
    var phi_712_: f32;
    var phi_731_: f32;
    var phi_738_: f32;
    var phi_744_: f32;
    var phi_750_: f32;
    var phi_765_: f32;
    var phi_770_: f32;
    var phi_775_: f32;
    var phi_780_: f32;
    var phi_785_: f32;
    var phi_844_: f32;
    var phi_867_: f32;
    var phi_890_: f32;
    var phi_912_: f32;
    var phi_928_: f32;
    var phi_983_: f32;
    var phi_1006_: f32;
    var phi_1029_: f32;
    var phi_1051_: f32;
    var phi_1067_: f32;
    var phi_1122_: f32;
    var phi_1145_: f32;
    var phi_1168_: f32;
    var phi_1190_: f32;
    var phi_1206_: f32;
    var phi_1261_: f32;
    var phi_1284_: f32;
    var phi_1308_: f32;
    var phi_1331_: f32;
    var phi_1347_: f32;
    var phi_1402_: f32;
    var phi_1425_: f32;
    var phi_1449_: f32;
    var phi_1472_: f32;
    var phi_1488_: f32;
    var phi_1543_: f32;
    var phi_1566_: f32;
    var phi_1590_: f32;
    var phi_1613_: f32;
    var phi_1629_: f32;
    var phi_1684_: f32;
    var phi_1707_: f32;
    var phi_1731_: f32;
    var phi_1754_: f32;
    var phi_1770_: f32;
    var phi_1825_: f32;
    var phi_1848_: f32;
    var phi_1872_: f32;
    var phi_1895_: f32;
    var phi_1911_: f32;
    var phi_1966_: f32;
    var phi_1989_: f32;
    var phi_2013_: f32;
    var phi_2036_: f32;
    var phi_2052_: f32;
    var phi_2059_: f32;
    var phi_2064_: f32;
    var phi_2069_: f32;
    var phi_2074_: f32;
    var phi_2079_: f32;
    var phi_2084_: f32;
    var phi_2089_: f32;
    var phi_2094_: f32;
    var phi_2098_: bool;
    var phi_2156_: bool;
    var phi_2171_: bool;
    var phi_2179_: bool;
    var phi_2194_: bool;
    var phi_2206_: u32;
    var phi_2207_: bool;
    var phi_2208_: u32;
    var phi_2209_: bool;
    var phi_2213_: u32;
    var phi_2221_: u32;
    var phi_2222_: bool;
    var phi_2223_: u32;
    var phi_2224_: bool;
    var phi_2228_: u32;
    var phi_2233_: bool;
    var phi_2238_: bool;
    var phi_2250_: u32;
    var phi_2266_: u32;
    var phi_2268_: bool;
    var phi_2269_: bool;
    var phi_2330_: type_9;
    var phi_2384_: type_9;
    var phi_2431_: bool;
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
        local_1 = type_34(array<u32, 31>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, true);
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
                    if (_e155 < _e66.member_1.y) {
                        phi_309_ = _e155;
                    } else {
                        phi_309_ = _e66.member_1.y;
                    }
                    let _e160 = phi_309_;
                    if (_e156 < _e66.member_2.x) {
                        phi_314_ = _e156;
                    } else {
                        phi_314_ = _e66.member_2.x;
                    }
                    let _e163 = phi_314_;
                    if (_e157 < _e66.member_2.y) {
                        phi_319_ = _e157;
                    } else {
                        phi_319_ = _e66.member_2.y;
                    }
                    let _e166 = phi_319_;
                    if (_e160 > _e66.member.x) {
                        phi_324_ = _e160;
                    } else {
                        phi_324_ = _e66.member.x;
                    }
                    let _e169 = phi_324_;
                    if (_e163 > _e66.member.y) {
                        phi_329_ = _e163;
                    } else {
                        phi_329_ = _e66.member.y;
                    }
                    let _e172 = phi_329_;
                    if (_e166 > _e66.member_1.x) {
                        phi_334_ = _e166;
                    } else {
                        phi_334_ = _e66.member_1.x;
                    }
                    let _e175 = phi_334_;
                    let _e176 = (_e66.member_1.y - _e169);
                    let _e177 = (_e66.member_2.x - _e172);
                    let _e178 = (_e66.member_2.y - _e175);
                    let _e179 = (_e169 - _e66.member.x);
                    let _e180 = (_e172 - _e66.member.y);
                    let _e181 = (_e175 - _e66.member_1.x);
                    if (_e176 > _e179) {
                        phi_345_ = _e176;
                    } else {
                        phi_345_ = _e179;
                    }
                    let _e184 = phi_345_;
                    if (_e177 > _e180) {
                        phi_350_ = _e177;
                    } else {
                        phi_350_ = _e180;
                    }
                    let _e187 = phi_350_;
                    if (_e178 > _e181) {
                        phi_355_ = _e178;
                    } else {
                        phi_355_ = _e181;
                    }
                    let _e190 = phi_355_;
                    let _e192 = (1f + (0.000000059604645f * 4f));
                    let _e196 = (0.000000000000000000000000000000000000011754944f * 8f);
                    let _e197 = ((_e184 * _e192) + _e196);
                    let _e198 = ((_e187 * _e192) + _e196);
                    let _e199 = ((_e190 * _e192) + _e196);
                    let _e200 = (_e118.member.x - _e169);
                    let _e201 = (_e118.member.y - _e172);
                    let _e202 = (_e118.member.z - _e175);
                    if (_e200 < 0f) {
                        phi_395_ = -(_e200);
                    } else {
                        phi_395_ = _e200;
                    }
                    let _e221 = phi_395_;
                    if (_e201 < 0f) {
                        phi_401_ = -(_e201);
                    } else {
                        phi_401_ = _e201;
                    }
                    let _e225 = phi_401_;
                    if (_e202 < 0f) {
                        phi_408_ = -(_e202);
                    } else {
                        phi_408_ = _e202;
                    }
                    let _e230 = phi_408_;
                    if (_e197 < 0f) {
                        phi_415_ = -(_e197);
                    } else {
                        phi_415_ = _e197;
                    }
                    let _e235 = phi_415_;
                    if (_e198 < 0f) {
                        phi_421_ = -(_e198);
                    } else {
                        phi_421_ = _e198;
                    }
                    let _e239 = phi_421_;
                    if (_e199 < 0f) {
                        phi_428_ = -(_e199);
                    } else {
                        phi_428_ = _e199;
                    }
                    let _e244 = phi_428_;
                    if (_e118.member_3.x < 0f) {
                        phi_435_ = -(_e118.member_3.x);
                    } else {
                        phi_435_ = _e118.member_3.x;
                    }
                    let _e249 = phi_435_;
                    if (_e118.member_3.y < 0f) {
                        phi_441_ = -(_e118.member_3.y);
                    } else {
                        phi_441_ = _e118.member_3.y;
                    }
                    let _e253 = phi_441_;
                    if (_e118.member_3.z < 0f) {
                        phi_448_ = -(_e118.member_3.z);
                    } else {
                        phi_448_ = _e118.member_3.z;
                    }
                    let _e258 = phi_448_;
                    local = type_28(array<array<f32, 3>, 3>(array<f32, 3>(_e118.member.w, _e118.member_1.z, _e118.member_2.y), array<f32, 3>(_e118.member_1.x, _e118.member_1.w, _e118.member_2.z), array<f32, 3>(_e118.member_1.y, _e118.member_2.x, _e118.member_2.w)), array<f32, 3>(_e200, _e201, _e202), array<f32, 3>((((_e118.member.w * _e200) + (_e118.member_1.x * _e201)) + (_e118.member_1.y * _e202)), (((_e118.member_1.z * _e200) + (_e118.member_1.w * _e201)) + (_e118.member_2.x * _e202)), (((_e118.member_2.y * _e200) + (_e118.member_2.z * _e201)) + (_e118.member_2.w * _e202))), array<f32, 3>(_e197, _e198, _e199), array<f32, 3>(_e118.member_3.x, _e118.member_3.y, _e118.member_3.z), ((((((_e221 + _e225) + _e230) + (((_e235 + _e239) + _e244) + ((_e249 + _e253) + _e258))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e279 = local.member[0u][0u];
                    let _e283 = local.member[0u][1u];
                    let _e287 = local.member[0u][2u];
                    let _e291 = local.member[1u][0u];
                    let _e295 = local.member[1u][1u];
                    let _e299 = local.member[1u][2u];
                    let _e303 = local.member[2u][0u];
                    let _e307 = local.member[2u][1u];
                    let _e311 = local.member[2u][2u];
                    let _e313 = local.member_3;
                    let _e318 = local.member_4;
                    let _e324 = local.member_1[0u];
                    if (_e324 < 0f) {
                        phi_541_ = -(_e324);
                    } else {
                        phi_541_ = _e324;
                    }
                    let _e328 = phi_541_;
                    if (_e279 < 0f) {
                        phi_548_ = -(_e279);
                    } else {
                        phi_548_ = _e279;
                    }
                    let _e332 = phi_548_;
                    if (_e283 < 0f) {
                        phi_554_ = -(_e283);
                    } else {
                        phi_554_ = _e283;
                    }
                    let _e336 = phi_554_;
                    if (_e287 < 0f) {
                        phi_560_ = -(_e287);
                    } else {
                        phi_560_ = _e287;
                    }
                    let _e340 = phi_560_;
                    let _e347 = (_e328 - (_e313[0] + (((_e332 * _e318[0]) + (_e336 * _e318[1])) + (_e340 * _e318[2]))));
                    let _e350 = local.member_1[1u];
                    if (_e350 < 0f) {
                        phi_579_ = -(_e350);
                    } else {
                        phi_579_ = _e350;
                    }
                    let _e354 = phi_579_;
                    if (_e291 < 0f) {
                        phi_586_ = -(_e291);
                    } else {
                        phi_586_ = _e291;
                    }
                    let _e358 = phi_586_;
                    if (_e295 < 0f) {
                        phi_592_ = -(_e295);
                    } else {
                        phi_592_ = _e295;
                    }
                    let _e362 = phi_592_;
                    if (_e299 < 0f) {
                        phi_598_ = -(_e299);
                    } else {
                        phi_598_ = _e299;
                    }
                    let _e366 = phi_598_;
                    let _e373 = (_e354 - (_e313[1] + (((_e358 * _e318[0]) + (_e362 * _e318[1])) + (_e366 * _e318[2]))));
                    let _e376 = local.member_1[2u];
                    if (_e376 < 0f) {
                        phi_617_ = -(_e376);
                    } else {
                        phi_617_ = _e376;
                    }
                    let _e380 = phi_617_;
                    if (_e303 < 0f) {
                        phi_624_ = -(_e303);
                    } else {
                        phi_624_ = _e303;
                    }
                    let _e384 = phi_624_;
                    if (_e307 < 0f) {
                        phi_630_ = -(_e307);
                    } else {
                        phi_630_ = _e307;
                    }
                    let _e388 = phi_630_;
                    if (_e311 < 0f) {
                        phi_636_ = -(_e311);
                    } else {
                        phi_636_ = _e311;
                    }
                    let _e392 = phi_636_;
                    let _e399 = (_e380 - (_e313[2] + (((_e384 * _e318[0]) + (_e388 * _e318[1])) + (_e392 * _e318[2]))));
                    let _e402 = local.member_2[0u];
                    if (_e402 < 0f) {
                        phi_655_ = -(_e402);
                    } else {
                        phi_655_ = _e402;
                    }
                    let _e406 = phi_655_;
                    if (_e279 < 0f) {
                        phi_662_ = -(_e279);
                    } else {
                        phi_662_ = _e279;
                    }
                    let _e410 = phi_662_;
                    if (_e291 < 0f) {
                        phi_668_ = -(_e291);
                    } else {
                        phi_668_ = _e291;
                    }
                    let _e414 = phi_668_;
                    if (_e303 < 0f) {
                        phi_674_ = -(_e303);
                    } else {
                        phi_674_ = _e303;
                    }
                    let _e418 = phi_674_;
                    let _e425 = (_e406 - (_e318[0] + (((_e410 * _e313[0]) + (_e414 * _e313[1])) + (_e418 * _e313[2]))));
                    let _e428 = local.member_2[1u];
                    if (_e428 < 0f) {
                        phi_693_ = -(_e428);
                    } else {
                        phi_693_ = _e428;
                    }
                    let _e432 = phi_693_;
                    if (_e283 < 0f) {
                        phi_700_ = -(_e283);
                    } else {
                        phi_700_ = _e283;
                    }
                    let _e436 = phi_700_;
                    if (_e295 < 0f) {
                        phi_706_ = -(_e295);
                    } else {
                        phi_706_ = _e295;
                    }
                    let _e440 = phi_706_;
                    if (_e307 < 0f) {
                        phi_712_ = -(_e307);
                    } else {
                        phi_712_ = _e307;
                    }
                    let _e444 = phi_712_;
                    let _e451 = (_e432 - (_e318[1] + (((_e436 * _e313[0]) + (_e440 * _e313[1])) + (_e444 * _e313[2]))));
                    let _e454 = local.member_2[2u];
                    if (_e454 < 0f) {
                        phi_731_ = -(_e454);
                    } else {
                        phi_731_ = _e454;
                    }
                    let _e458 = phi_731_;
                    if (_e287 < 0f) {
                        phi_738_ = -(_e287);
                    } else {
                        phi_738_ = _e287;
                    }
                    let _e462 = phi_738_;
                    if (_e299 < 0f) {
                        phi_744_ = -(_e299);
                    } else {
                        phi_744_ = _e299;
                    }
                    let _e466 = phi_744_;
                    if (_e311 < 0f) {
                        phi_750_ = -(_e311);
                    } else {
                        phi_750_ = _e311;
                    }
                    let _e470 = phi_750_;
                    let _e477 = (_e458 - (_e318[2] + (((_e462 * _e313[0]) + (_e466 * _e313[1])) + (_e470 * _e313[2]))));
                    if (_e347 > _e373) {
                        phi_765_ = _e347;
                    } else {
                        phi_765_ = _e373;
                    }
                    let _e480 = phi_765_;
                    if (_e480 > _e399) {
                        phi_770_ = _e480;
                    } else {
                        phi_770_ = _e399;
                    }
                    let _e483 = phi_770_;
                    if (_e425 > _e451) {
                        phi_775_ = _e425;
                    } else {
                        phi_775_ = _e451;
                    }
                    let _e486 = phi_775_;
                    if (_e486 > _e477) {
                        phi_780_ = _e486;
                    } else {
                        phi_780_ = _e477;
                    }
                    let _e489 = phi_780_;
                    if (_e483 > _e489) {
                        phi_785_ = _e483;
                    } else {
                        phi_785_ = _e489;
                    }
                    let _e492 = phi_785_;
                    let _e494 = local.member_5;
                    if (_e492 > _e494) {
                        phi_2098_ = true;
                    } else {
                        let _e499 = local.member[1u][0u];
                        let _e502 = local.member_1[2u];
                        let _e507 = local.member[2u][0u];
                        let _e510 = local.member_1[1u];
                        let _e512 = ((_e499 * _e502) - (_e507 * _e510));
                        let _e516 = local.member[2u][0u];
                        if (_e516 < 0f) {
                            phi_844_ = -(_e516);
                        } else {
                            phi_844_ = _e516;
                        }
                        let _e520 = phi_844_;
                        let _e523 = local.member_3[1u];
                        let _e528 = local.member[1u][0u];
                        if (_e528 < 0f) {
                            phi_867_ = -(_e528);
                        } else {
                            phi_867_ = _e528;
                        }
                        let _e532 = phi_867_;
                        let _e535 = local.member_3[2u];
                        let _e541 = local.member[0u][2u];
                        if (_e541 < 0f) {
                            phi_890_ = -(_e541);
                        } else {
                            phi_890_ = _e541;
                        }
                        let _e545 = phi_890_;
                        let _e548 = local.member_4[1u];
                        let _e553 = local.member[0u][1u];
                        if (_e553 < 0f) {
                            phi_912_ = -(_e553);
                        } else {
                            phi_912_ = _e553;
                        }
                        let _e557 = phi_912_;
                        let _e560 = local.member_4[2u];
                        if (_e512 < 0f) {
                            phi_928_ = -(_e512);
                        } else {
                            phi_928_ = _e512;
                        }
                        let _e566 = phi_928_;
                        let _e568 = (_e566 - (((_e520 * _e523) + (_e532 * _e535)) + ((_e545 * _e548) + (_e557 * _e560))));
                        let _e572 = local.member[1u][1u];
                        let _e575 = local.member_1[2u];
                        let _e580 = local.member[2u][1u];
                        let _e583 = local.member_1[1u];
                        let _e585 = ((_e572 * _e575) - (_e580 * _e583));
                        let _e589 = local.member[2u][1u];
                        if (_e589 < 0f) {
                            phi_983_ = -(_e589);
                        } else {
                            phi_983_ = _e589;
                        }
                        let _e593 = phi_983_;
                        let _e596 = local.member_3[1u];
                        let _e601 = local.member[1u][1u];
                        if (_e601 < 0f) {
                            phi_1006_ = -(_e601);
                        } else {
                            phi_1006_ = _e601;
                        }
                        let _e605 = phi_1006_;
                        let _e608 = local.member_3[2u];
                        let _e614 = local.member[0u][0u];
                        if (_e614 < 0f) {
                            phi_1029_ = -(_e614);
                        } else {
                            phi_1029_ = _e614;
                        }
                        let _e618 = phi_1029_;
                        let _e621 = local.member_4[2u];
                        let _e626 = local.member[0u][2u];
                        if (_e626 < 0f) {
                            phi_1051_ = -(_e626);
                        } else {
                            phi_1051_ = _e626;
                        }
                        let _e630 = phi_1051_;
                        let _e633 = local.member_4[0u];
                        if (_e585 < 0f) {
                            phi_1067_ = -(_e585);
                        } else {
                            phi_1067_ = _e585;
                        }
                        let _e639 = phi_1067_;
                        let _e641 = (_e639 - (((_e593 * _e596) + (_e605 * _e608)) + ((_e618 * _e621) + (_e630 * _e633))));
                        let _e645 = local.member[1u][2u];
                        let _e648 = local.member_1[2u];
                        let _e653 = local.member[2u][2u];
                        let _e656 = local.member_1[1u];
                        let _e658 = ((_e645 * _e648) - (_e653 * _e656));
                        let _e662 = local.member[2u][2u];
                        if (_e662 < 0f) {
                            phi_1122_ = -(_e662);
                        } else {
                            phi_1122_ = _e662;
                        }
                        let _e666 = phi_1122_;
                        let _e669 = local.member_3[1u];
                        let _e674 = local.member[1u][2u];
                        if (_e674 < 0f) {
                            phi_1145_ = -(_e674);
                        } else {
                            phi_1145_ = _e674;
                        }
                        let _e678 = phi_1145_;
                        let _e681 = local.member_3[2u];
                        let _e687 = local.member[0u][1u];
                        if (_e687 < 0f) {
                            phi_1168_ = -(_e687);
                        } else {
                            phi_1168_ = _e687;
                        }
                        let _e691 = phi_1168_;
                        let _e694 = local.member_4[0u];
                        let _e699 = local.member[0u][0u];
                        if (_e699 < 0f) {
                            phi_1190_ = -(_e699);
                        } else {
                            phi_1190_ = _e699;
                        }
                        let _e703 = phi_1190_;
                        let _e706 = local.member_4[1u];
                        if (_e658 < 0f) {
                            phi_1206_ = -(_e658);
                        } else {
                            phi_1206_ = _e658;
                        }
                        let _e712 = phi_1206_;
                        let _e714 = (_e712 - (((_e666 * _e669) + (_e678 * _e681)) + ((_e691 * _e694) + (_e703 * _e706))));
                        let _e718 = local.member[2u][0u];
                        let _e721 = local.member_1[0u];
                        let _e726 = local.member[0u][0u];
                        let _e729 = local.member_1[2u];
                        let _e731 = ((_e718 * _e721) - (_e726 * _e729));
                        let _e735 = local.member[0u][0u];
                        if (_e735 < 0f) {
                            phi_1261_ = -(_e735);
                        } else {
                            phi_1261_ = _e735;
                        }
                        let _e739 = phi_1261_;
                        let _e742 = local.member_3[2u];
                        let _e747 = local.member[2u][0u];
                        if (_e747 < 0f) {
                            phi_1284_ = -(_e747);
                        } else {
                            phi_1284_ = _e747;
                        }
                        let _e751 = phi_1284_;
                        let _e754 = local.member_3[0u];
                        let _e760 = local.member[1u][2u];
                        if (_e760 < 0f) {
                            phi_1308_ = -(_e760);
                        } else {
                            phi_1308_ = _e760;
                        }
                        let _e764 = phi_1308_;
                        let _e767 = local.member_4[1u];
                        let _e772 = local.member[1u][1u];
                        if (_e772 < 0f) {
                            phi_1331_ = -(_e772);
                        } else {
                            phi_1331_ = _e772;
                        }
                        let _e776 = phi_1331_;
                        let _e779 = local.member_4[2u];
                        if (_e731 < 0f) {
                            phi_1347_ = -(_e731);
                        } else {
                            phi_1347_ = _e731;
                        }
                        let _e785 = phi_1347_;
                        let _e787 = (_e785 - (((_e739 * _e742) + (_e751 * _e754)) + ((_e764 * _e767) + (_e776 * _e779))));
                        let _e791 = local.member[2u][1u];
                        let _e794 = local.member_1[0u];
                        let _e799 = local.member[0u][1u];
                        let _e802 = local.member_1[2u];
                        let _e804 = ((_e791 * _e794) - (_e799 * _e802));
                        let _e808 = local.member[0u][1u];
                        if (_e808 < 0f) {
                            phi_1402_ = -(_e808);
                        } else {
                            phi_1402_ = _e808;
                        }
                        let _e812 = phi_1402_;
                        let _e815 = local.member_3[2u];
                        let _e820 = local.member[2u][1u];
                        if (_e820 < 0f) {
                            phi_1425_ = -(_e820);
                        } else {
                            phi_1425_ = _e820;
                        }
                        let _e824 = phi_1425_;
                        let _e827 = local.member_3[0u];
                        let _e833 = local.member[1u][0u];
                        if (_e833 < 0f) {
                            phi_1449_ = -(_e833);
                        } else {
                            phi_1449_ = _e833;
                        }
                        let _e837 = phi_1449_;
                        let _e840 = local.member_4[2u];
                        let _e845 = local.member[1u][2u];
                        if (_e845 < 0f) {
                            phi_1472_ = -(_e845);
                        } else {
                            phi_1472_ = _e845;
                        }
                        let _e849 = phi_1472_;
                        let _e852 = local.member_4[0u];
                        if (_e804 < 0f) {
                            phi_1488_ = -(_e804);
                        } else {
                            phi_1488_ = _e804;
                        }
                        let _e858 = phi_1488_;
                        let _e860 = (_e858 - (((_e812 * _e815) + (_e824 * _e827)) + ((_e837 * _e840) + (_e849 * _e852))));
                        let _e864 = local.member[2u][2u];
                        let _e867 = local.member_1[0u];
                        let _e872 = local.member[0u][2u];
                        let _e875 = local.member_1[2u];
                        let _e877 = ((_e864 * _e867) - (_e872 * _e875));
                        let _e881 = local.member[0u][2u];
                        if (_e881 < 0f) {
                            phi_1543_ = -(_e881);
                        } else {
                            phi_1543_ = _e881;
                        }
                        let _e885 = phi_1543_;
                        let _e888 = local.member_3[2u];
                        let _e893 = local.member[2u][2u];
                        if (_e893 < 0f) {
                            phi_1566_ = -(_e893);
                        } else {
                            phi_1566_ = _e893;
                        }
                        let _e897 = phi_1566_;
                        let _e900 = local.member_3[0u];
                        let _e906 = local.member[1u][1u];
                        if (_e906 < 0f) {
                            phi_1590_ = -(_e906);
                        } else {
                            phi_1590_ = _e906;
                        }
                        let _e910 = phi_1590_;
                        let _e913 = local.member_4[0u];
                        let _e918 = local.member[1u][0u];
                        if (_e918 < 0f) {
                            phi_1613_ = -(_e918);
                        } else {
                            phi_1613_ = _e918;
                        }
                        let _e922 = phi_1613_;
                        let _e925 = local.member_4[1u];
                        if (_e877 < 0f) {
                            phi_1629_ = -(_e877);
                        } else {
                            phi_1629_ = _e877;
                        }
                        let _e931 = phi_1629_;
                        let _e933 = (_e931 - (((_e885 * _e888) + (_e897 * _e900)) + ((_e910 * _e913) + (_e922 * _e925))));
                        let _e937 = local.member[0u][0u];
                        let _e940 = local.member_1[1u];
                        let _e945 = local.member[1u][0u];
                        let _e948 = local.member_1[0u];
                        let _e950 = ((_e937 * _e940) - (_e945 * _e948));
                        let _e954 = local.member[1u][0u];
                        if (_e954 < 0f) {
                            phi_1684_ = -(_e954);
                        } else {
                            phi_1684_ = _e954;
                        }
                        let _e958 = phi_1684_;
                        let _e961 = local.member_3[0u];
                        let _e966 = local.member[0u][0u];
                        if (_e966 < 0f) {
                            phi_1707_ = -(_e966);
                        } else {
                            phi_1707_ = _e966;
                        }
                        let _e970 = phi_1707_;
                        let _e973 = local.member_3[1u];
                        let _e979 = local.member[2u][2u];
                        if (_e979 < 0f) {
                            phi_1731_ = -(_e979);
                        } else {
                            phi_1731_ = _e979;
                        }
                        let _e983 = phi_1731_;
                        let _e986 = local.member_4[1u];
                        let _e991 = local.member[2u][1u];
                        if (_e991 < 0f) {
                            phi_1754_ = -(_e991);
                        } else {
                            phi_1754_ = _e991;
                        }
                        let _e995 = phi_1754_;
                        let _e998 = local.member_4[2u];
                        if (_e950 < 0f) {
                            phi_1770_ = -(_e950);
                        } else {
                            phi_1770_ = _e950;
                        }
                        let _e1004 = phi_1770_;
                        let _e1006 = (_e1004 - (((_e958 * _e961) + (_e970 * _e973)) + ((_e983 * _e986) + (_e995 * _e998))));
                        let _e1010 = local.member[0u][1u];
                        let _e1013 = local.member_1[1u];
                        let _e1018 = local.member[1u][1u];
                        let _e1021 = local.member_1[0u];
                        let _e1023 = ((_e1010 * _e1013) - (_e1018 * _e1021));
                        let _e1027 = local.member[1u][1u];
                        if (_e1027 < 0f) {
                            phi_1825_ = -(_e1027);
                        } else {
                            phi_1825_ = _e1027;
                        }
                        let _e1031 = phi_1825_;
                        let _e1034 = local.member_3[0u];
                        let _e1039 = local.member[0u][1u];
                        if (_e1039 < 0f) {
                            phi_1848_ = -(_e1039);
                        } else {
                            phi_1848_ = _e1039;
                        }
                        let _e1043 = phi_1848_;
                        let _e1046 = local.member_3[1u];
                        let _e1052 = local.member[2u][0u];
                        if (_e1052 < 0f) {
                            phi_1872_ = -(_e1052);
                        } else {
                            phi_1872_ = _e1052;
                        }
                        let _e1056 = phi_1872_;
                        let _e1059 = local.member_4[2u];
                        let _e1064 = local.member[2u][2u];
                        if (_e1064 < 0f) {
                            phi_1895_ = -(_e1064);
                        } else {
                            phi_1895_ = _e1064;
                        }
                        let _e1068 = phi_1895_;
                        let _e1071 = local.member_4[0u];
                        if (_e1023 < 0f) {
                            phi_1911_ = -(_e1023);
                        } else {
                            phi_1911_ = _e1023;
                        }
                        let _e1077 = phi_1911_;
                        let _e1079 = (_e1077 - (((_e1031 * _e1034) + (_e1043 * _e1046)) + ((_e1056 * _e1059) + (_e1068 * _e1071))));
                        let _e1083 = local.member[0u][2u];
                        let _e1086 = local.member_1[1u];
                        let _e1091 = local.member[1u][2u];
                        let _e1094 = local.member_1[0u];
                        let _e1096 = ((_e1083 * _e1086) - (_e1091 * _e1094));
                        let _e1100 = local.member[1u][2u];
                        if (_e1100 < 0f) {
                            phi_1966_ = -(_e1100);
                        } else {
                            phi_1966_ = _e1100;
                        }
                        let _e1104 = phi_1966_;
                        let _e1107 = local.member_3[0u];
                        let _e1112 = local.member[0u][2u];
                        if (_e1112 < 0f) {
                            phi_1989_ = -(_e1112);
                        } else {
                            phi_1989_ = _e1112;
                        }
                        let _e1116 = phi_1989_;
                        let _e1119 = local.member_3[1u];
                        let _e1125 = local.member[2u][1u];
                        if (_e1125 < 0f) {
                            phi_2013_ = -(_e1125);
                        } else {
                            phi_2013_ = _e1125;
                        }
                        let _e1129 = phi_2013_;
                        let _e1132 = local.member_4[0u];
                        let _e1137 = local.member[2u][0u];
                        if (_e1137 < 0f) {
                            phi_2036_ = -(_e1137);
                        } else {
                            phi_2036_ = _e1137;
                        }
                        let _e1141 = phi_2036_;
                        let _e1144 = local.member_4[1u];
                        if (_e1096 < 0f) {
                            phi_2052_ = -(_e1096);
                        } else {
                            phi_2052_ = _e1096;
                        }
                        let _e1150 = phi_2052_;
                        let _e1152 = (_e1150 - (((_e1104 * _e1107) + (_e1116 * _e1119)) + ((_e1129 * _e1132) + (_e1141 * _e1144))));
                        if (_e568 > _e641) {
                            phi_2059_ = _e568;
                        } else {
                            phi_2059_ = _e641;
                        }
                        let _e1155 = phi_2059_;
                        if (_e1155 > _e714) {
                            phi_2064_ = _e1155;
                        } else {
                            phi_2064_ = _e714;
                        }
                        let _e1158 = phi_2064_;
                        if (_e787 > _e860) {
                            phi_2069_ = _e787;
                        } else {
                            phi_2069_ = _e860;
                        }
                        let _e1161 = phi_2069_;
                        if (_e1161 > _e933) {
                            phi_2074_ = _e1161;
                        } else {
                            phi_2074_ = _e933;
                        }
                        let _e1164 = phi_2074_;
                        if (_e1158 > _e1164) {
                            phi_2079_ = _e1158;
                        } else {
                            phi_2079_ = _e1164;
                        }
                        let _e1167 = phi_2079_;
                        if (_e1006 > _e1079) {
                            phi_2084_ = _e1006;
                        } else {
                            phi_2084_ = _e1079;
                        }
                        let _e1170 = phi_2084_;
                        if (_e1170 > _e1152) {
                            phi_2089_ = _e1170;
                        } else {
                            phi_2089_ = _e1152;
                        }
                        let _e1173 = phi_2089_;
                        if (_e1167 > _e1173) {
                            phi_2094_ = _e1167;
                        } else {
                            phi_2094_ = _e1173;
                        }
                        let _e1176 = phi_2094_;
                        let _e1178 = local.member_5;
                        phi_2098_ = (_e1176 > _e1178);
                    }
                    let _e1181 = phi_2098_;
                    if !(_e1181) {
                        let _e1198 = local_1.member_2;
                        let _e1200 = nodes.member[_e1198];
                        let _e1237 = (_e58 == 4294967295u);
                        if _e1237 {
                            phi_2156_ = true;
                        } else {
                            phi_2156_ = (_e1200.member_2.w > _e58);
                        }
                        let _e1241 = phi_2156_;
                        if _e1241 {
                            phi_2171_ = ((((((bitcast<f32>(_e1200.member.x) <= _e66.member_1.y) && (_e66.member.x <= bitcast<f32>(_e1200.member_1.x))) && (bitcast<f32>(_e1200.member.y) <= _e66.member_2.x)) && (_e66.member.y <= bitcast<f32>(_e1200.member_1.y))) && (bitcast<f32>(_e1200.member.z) <= _e66.member_2.y)) && (_e66.member_1.x <= bitcast<f32>(_e1200.member_1.z)));
                        } else {
                            phi_2171_ = false;
                        }
                        let _e1254 = phi_2171_;
                        if _e1237 {
                            phi_2179_ = true;
                        } else {
                            phi_2179_ = ((_e1200.member_3.w & 2147483647u) > _e58);
                        }
                        let _e1257 = phi_2179_;
                        if _e1257 {
                            phi_2194_ = ((((((bitcast<f32>(_e1200.member_2.x) <= _e66.member_1.y) && (_e66.member.x <= bitcast<f32>(_e1200.member_3.x))) && (bitcast<f32>(_e1200.member_2.y) <= _e66.member_2.x)) && (_e66.member.y <= bitcast<f32>(_e1200.member_3.y))) && (bitcast<f32>(_e1200.member_2.z) <= _e66.member_2.y)) && (_e66.member_1.x <= bitcast<f32>(_e1200.member_3.z)));
                        } else {
                            phi_2194_ = false;
                        }
                        let _e1270 = phi_2194_;
                        let _e1272 = ((_e1200.member.w & 2147483648u) != 0u);
                        let _e1274 = ((_e1200.member_1.w & 2147483648u) != 0u);
                        if _e1254 {
                            if _e1272 {
                                phi_2206_ = (_e1200.member.w & 2147483647u);
                                phi_2207_ = false;
                            } else {
                                phi_2206_ = u32();
                                phi_2207_ = true;
                            }
                            let _e1277 = phi_2206_;
                            let _e1279 = phi_2207_;
                            phi_2208_ = _e1277;
                            phi_2209_ = _e1279;
                        } else {
                            phi_2208_ = u32();
                            phi_2209_ = true;
                        }
                        let _e1281 = phi_2208_;
                        let _e1283 = phi_2209_;
                        if _e1283 {
                            phi_2213_ = 4294967295u;
                        } else {
                            phi_2213_ = _e1281;
                        }
                        let _e1285 = phi_2213_;
                        if _e1270 {
                            if _e1274 {
                                phi_2221_ = (_e1200.member_1.w & 2147483647u);
                                phi_2222_ = false;
                            } else {
                                phi_2221_ = u32();
                                phi_2222_ = true;
                            }
                            let _e1288 = phi_2221_;
                            let _e1290 = phi_2222_;
                            phi_2223_ = _e1288;
                            phi_2224_ = _e1290;
                        } else {
                            phi_2223_ = u32();
                            phi_2224_ = true;
                        }
                        let _e1292 = phi_2223_;
                        let _e1294 = phi_2224_;
                        if _e1294 {
                            phi_2228_ = 4294967295u;
                        } else {
                            phi_2228_ = _e1292;
                        }
                        let _e1296 = phi_2228_;
                        if _e1254 {
                            phi_2233_ = !(_e1272);
                        } else {
                            phi_2233_ = false;
                        }
                        let _e1299 = phi_2233_;
                        if _e1270 {
                            phi_2238_ = !(_e1274);
                        } else {
                            phi_2238_ = false;
                        }
                        let _e1302 = phi_2238_;
                        if _e1299 {
                            if _e1302 {
                                let _e1304 = ((_e1200.member_3.w & 2147483648u) != 0u);
                                if _e1304 {
                                    phi_2250_ = _e1200.member_1.w;
                                } else {
                                    phi_2250_ = _e1200.member.w;
                                }
                                let _e1306 = phi_2250_;
                                let _e1308 = local_1.member_1;
                                local_1.member[_e1308] = _e1306;
                                let _e1313 = local_1.member_1;
                                local_1.member_1 = (_e1313 + 1u);
                                if _e1304 {
                                    phi_2266_ = _e1200.member.w;
                                } else {
                                    phi_2266_ = _e1200.member_1.w;
                                }
                                let _e1316 = phi_2266_;
                                local_1.member_2 = _e1316;
                                phi_2268_ = false;
                            } else {
                                phi_2268_ = true;
                            }
                            let _e1319 = phi_2268_;
                            phi_2269_ = _e1319;
                        } else {
                            phi_2269_ = true;
                        }
                        let _e1321 = phi_2269_;
                        if _e1321 {
                            if _e1299 {
                                local_1.member_2 = _e1200.member.w;
                            } else {
                                if _e1302 {
                                    local_1.member_2 = _e1200.member_1.w;
                                } else {
                                    let _e1323 = local_1.member_1;
                                    if (_e1323 > 0u) {
                                        let _e1328 = local_1.member_1;
                                        local_1.member_1 = (_e1328 - 1u);
                                        let _e1331 = local_1.member_1;
                                        let _e1334 = local_1.member[_e1331];
                                        local_1.member_2 = _e1334;
                                    } else {
                                        local_1.member_3 = false;
                                    }
                                }
                            }
                        }
                        if (_e1285 != 4294967295u) {
                            let _e1342 = params.member.member.member_2[1u];
                            let _e1345 = order.member[(_e1342 + _e1285)];
                            let _e1346 = (_e1345 - _e1342);
                            let _e1349 = params.member.member_1.member_3;
                            if (_e90 < _e1346) {
                                phi_2330_ = type_9(_e90, _e1346);
                            } else {
                                phi_2330_ = type_9(_e1346, _e90);
                            }
                            let _e1354 = phi_2330_;
                            let _e1358 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e1358 + 1u) < _e1358) {
                                let _e1362 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e1358 < _e1349) {
                                let _e1364 = (2u * _e1358);
                                atomicStore((&pairs.member[(4u + _e1364)]), _e1354.member);
                                atomicStore((&pairs.member[(_e1364 + 5u)]), _e1354.member_1);
                            }
                        }
                        if (_e1296 != 4294967295u) {
                            let _e1373 = params.member.member.member_2[1u];
                            let _e1376 = order.member[(_e1373 + _e1296)];
                            let _e1377 = (_e1376 - _e1373);
                            let _e1380 = params.member.member_1.member_3;
                            if (_e90 < _e1377) {
                                phi_2384_ = type_9(_e90, _e1377);
                            } else {
                                phi_2384_ = type_9(_e1377, _e90);
                            }
                            let _e1385 = phi_2384_;
                            let _e1389 = atomicAdd((&pairs.member[0u]), 1u);
                            if ((_e1389 + 1u) < _e1389) {
                                let _e1393 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            if (_e1389 < _e1380) {
                                let _e1395 = (2u * _e1389);
                                atomicStore((&pairs.member[(4u + _e1395)]), _e1385.member);
                                atomicStore((&pairs.member[(_e1395 + 5u)]), _e1385.member_1);
                            }
                        }
                    } else {
                        let _e1184 = local_1.member_1;
                        if (_e1184 > 0u) {
                            let _e1189 = local_1.member_1;
                            local_1.member_1 = (_e1189 - 1u);
                            let _e1192 = local_1.member_1;
                            let _e1195 = local_1.member[_e1192];
                            local_1.member_2 = _e1195;
                        } else {
                            local_1.member_3 = false;
                        }
                    }
                }
                phi_2431_ = _e113;
            } else {
                phi_2431_ = false;
            }
            let _e1401 = phi_2431_;
            continue;
            continuing {
                phi_231_ = _e106;
                break if !(_e1401);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn traverse_half_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
