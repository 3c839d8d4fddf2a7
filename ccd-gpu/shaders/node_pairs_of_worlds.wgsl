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
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_17 {
    member: type_7,
    member_1: type_8,
    member_2: type_16,
}

struct type_18 {
    member: type_17,
}

struct type_20 {
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_32 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_22;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 10>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;
@group(0) @binding(2) 
var<storage> worlds: type_11;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> output: type_32;
var<workgroup> ranges: array<u32, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var phi_168_: u32;
    var phi_205_: u32;
    var phi_206_: u32;
    var phi_214_: u32;
    var phi_230_: u32;
    var phi_253_: u32;
    var phi_254_: u32;
    var phi_257_: type_9;
    var phi_258_: type_9;
    var phi_281_: type_9;
    var phi_328_: u32;
    var phi_329_: u32;
    var phi_337_: u32;
    var phi_351_: u32;
    var phi_408_: array<u32, 2>;
    var phi_432_: type_9;
    var phi_435_: u32;
    var phi_433_: type_9;
    var phi_458_: type_9;
    var phi_436_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_476_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_485_: u32;
    var phi_528_: type_9;
    var phi_531_: u32;
    var phi_529_: type_9;
    var phi_554_: type_9;
    var phi_532_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_572_: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_581_: u32;
    var phi_626_: array<u32, 2>;
    var phi_787_: bool;
    var phi_825_: type_24;
    var phi_834_: bool;
    var phi_857_: u32;
    var phi_860_: type_9;
    var phi_863_: u32;
    var phi_861_: type_9;
    var phi_886_: type_9;
    var phi_864_: u32;
    var local_9: u32;
    var phi_1075_: u32;
    var phi_1078_: type_9;
    var phi_1081_: u32;
    var phi_1079_: type_9;
    var phi_1104_: type_9;
    var phi_1127_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1143_: bool;
    var phi_1147_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1163_: u32;
    var phi_1082_: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_1173_: type_9;
    var phi_1199_: u32;
    var phi_1202_: type_9;
    var phi_1205_: type_9;
    var phi_1203_: type_9;
    var phi_1228_: type_9;
    var phi_1245_: type_9;
    var phi_1248_: type_9;
    var phi_1249_: type_9;
    var phi_1271_: type_9;
    var phi_1305_: type_9;
    var phi_1306_: bool;
    var phi_1246_: type_9;
    var phi_1307_: bool;
    var phi_1315_: u32;
    var phi_1352_: type_9;
    var phi_1353_: type_9;
    var phi_1376_: type_9;
    var phi_1421_: bool;
    var phi_1422_: bool;
    var phi_1206_: type_9;
    var local_13: u32;
    var local_14: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e43 = id_2;
    let _e44 = n_2;
    let _e45 = lane_2;
    let _e55 = ((_e43.y * _e44.x) + _e43.x);
    let _e58 = (_e44.x * _e44.y);
    let _e62 = params.member.member_1.member_2;
    let _e64 = input.member[0u];
    if (_e62 < _e64) {
        phi_168_ = _e62;
    } else {
        phi_168_ = _e64;
    }
    let _e67 = phi_168_;
    let _e68 = (_e45 / 32u);
    let _e69 = (_e45 % 32u);
    let _e72 = params.member.member_1.member_1;
    if (_e67 > _e72) {
        let _e76 = params.member.member_1.member_1;
        let _e77 = (_e67 - _e76);
        let _e80 = params.member.member_2.member_3;
        if (_e80 == 0u) {
            return;
        }
        let _e82 = (_e77 / _e80);
        if (_e80 == 0u) {
            return;
        }
        if ((_e77 % _e80) > 0u) {
            phi_205_ = (_e82 + 1u);
        } else {
            phi_205_ = _e82;
        }
        let _e88 = phi_205_;
        phi_206_ = _e88;
    } else {
        phi_206_ = 0u;
    }
    let _e90 = phi_206_;
    let _e93 = params.member.member_2.member_4;
    if (_e93 < _e90) {
        phi_214_ = _e93;
    } else {
        phi_214_ = _e90;
    }
    let _e96 = phi_214_;
    let _e97 = (_e96 / 4u);
    if ((_e96 % 4u) > 0u) {
        phi_230_ = (_e97 + 1u);
    } else {
        phi_230_ = _e97;
    }
    let _e102 = phi_230_;
    if (_e102 > _e55) {
        let _e104 = (_e102 - _e55);
        if (_e58 == 0u) {
            return;
        }
        let _e106 = (_e104 / _e58);
        if (_e58 == 0u) {
            return;
        }
        if ((_e104 % _e58) > 0u) {
            phi_253_ = (_e106 + 1u);
        } else {
            phi_253_ = _e106;
        }
        let _e112 = phi_253_;
        phi_254_ = _e112;
    } else {
        phi_254_ = 0u;
    }
    let _e114 = phi_254_;
    phi_257_ = type_9(0u, _e114);
    loop {
        let _e117 = phi_257_;
        if (_e117.member < _e117.member_1) {
            phi_258_ = type_9((_e117.member + 1u), _e117.member_1);
            phi_281_ = type_9(1u, _e117.member);
        } else {
            phi_258_ = _e117;
            phi_281_ = type_9(0u, type_9().member_1);
        }
        let _e129 = phi_258_;
        let _e131 = phi_281_;
        let _e135 = (bitcast<i32>(_e131.member) != 0i);
        if _e135 {
            let _e140 = (((_e55 + (_e131.member_1 * _e58)) * 4u) + (_e45 / 32u));
            let _e143 = params.member.member_1.member_1;
            if (_e67 > _e143) {
                let _e147 = params.member.member_1.member_1;
                let _e148 = (_e67 - _e147);
                let _e151 = params.member.member_2.member_3;
                if (_e151 == 0u) {
                    return;
                }
                let _e153 = (_e148 / _e151);
                if (_e151 == 0u) {
                    return;
                }
                if ((_e148 % _e151) > 0u) {
                    phi_328_ = (_e153 + 1u);
                } else {
                    phi_328_ = _e153;
                }
                let _e159 = phi_328_;
                phi_329_ = _e159;
            } else {
                phi_329_ = 0u;
            }
            let _e161 = phi_329_;
            let _e164 = params.member.member_2.member_4;
            if (_e164 < _e161) {
                phi_337_ = _e164;
            } else {
                phi_337_ = _e161;
            }
            let _e167 = phi_337_;
            let _e168 = (_e140 < _e167);
            let _e171 = params.member.member_1.member_1;
            let _e174 = params.member.member_2.member_3;
            if _e168 {
                phi_351_ = (_e140 * _e174);
            } else {
                phi_351_ = 0u;
            }
            let _e177 = phi_351_;
            let _e179 = (2u * (_e171 + _e177));
            let _e182 = input.member[(4u + _e179)];
            let _e185 = input.member[(_e179 + 5u)];
            if (_e45 <= 7u) {
                atomicStore((&counters[_e45]), 0u);
            }
            workgroupBarrier();
            if (_e69 == 0u) {
                firsts[(2u * _e68)] = (_e182 * 32u);
                firsts[((2u * _e68) + 1u)] = (_e185 * 32u);
            }
            let _e198 = params.member.member_2.member_1;
            if (_e198 == 0u) {
                phi_408_ = array<u32, 2>(0u, 2u);
            } else {
                phi_408_ = array<u32, 2>(1u, 1u);
            }
            let _e201 = phi_408_;
            let _e204 = params.member.member_2.member_2;
            let _e205 = (_e204 - 1u);
            let _e208 = params.member.member.member;
            local = array<u32, 3>(_e208[0], _e208[1], _e208[2]);
            let _e216 = ((_e182 * 32u) + _e69);
            let _e218 = local[_e201[0]];
            phi_432_ = type_9(0u, _e205);
            phi_435_ = 1u;
            loop {
                let _e221 = phi_432_;
                let _e223 = phi_435_;
                local_1 = _e223;
                local_2 = _e223;
                local_3 = _e223;
                local_4 = _e223;
                if (_e221.member < _e221.member_1) {
                    phi_433_ = type_9((_e221.member + 1u), _e221.member_1);
                    phi_458_ = type_9(1u, _e221.member);
                } else {
                    phi_433_ = _e221;
                    phi_458_ = type_9(0u, type_9().member_1);
                }
                let _e235 = phi_433_;
                let _e237 = phi_458_;
                let _e240 = (bitcast<i32>(_e237.member) != 0i);
                if _e240 {
                    phi_436_ = (_e223 * 32u);
                } else {
                    phi_436_ = u32();
                }
                let _e243 = phi_436_;
                continue;
                continuing {
                    phi_432_ = _e235;
                    phi_435_ = _e243;
                    break if !(_e240);
                }
            }
            let _e247 = local_1;
            if (_e247 == 0u) {
                return;
            }
            let _e250 = local_2;
            let _e251 = ((_e218 - 1u) / _e250);
            if (_e251 < _e216) {
                phi_476_ = _e251;
            } else {
                phi_476_ = _e216;
            }
            let _e254 = phi_476_;
            let _e256 = local_3;
            let _e257 = (_e254 * _e256);
            let _e259 = local_4;
            let _e261 = (_e257 + (_e259 - 1u));
            let _e262 = (_e218 - 1u);
            if (_e262 < _e261) {
                phi_485_ = _e262;
            } else {
                phi_485_ = _e261;
            }
            let _e265 = phi_485_;
            let _e269 = params.member.member_2.member[0u][_e201[0]];
            let _e272 = worlds.member[(_e269 + _e257)];
            let _e277 = worlds.member[(_e269 + _e265)];
            let _e278 = ((_e272 << bitcast<u32>(16i)) | _e277);
            let _e280 = ((_e185 * 32u) + _e69);
            let _e282 = local[_e201[1]];
            phi_528_ = type_9(0u, _e205);
            phi_531_ = 1u;
            loop {
                let _e285 = phi_528_;
                let _e287 = phi_531_;
                local_5 = _e287;
                local_6 = _e287;
                local_7 = _e287;
                local_8 = _e287;
                if (_e285.member < _e285.member_1) {
                    phi_529_ = type_9((_e285.member + 1u), _e285.member_1);
                    phi_554_ = type_9(1u, _e285.member);
                } else {
                    phi_529_ = _e285;
                    phi_554_ = type_9(0u, type_9().member_1);
                }
                let _e299 = phi_529_;
                let _e301 = phi_554_;
                let _e304 = (bitcast<i32>(_e301.member) != 0i);
                if _e304 {
                    phi_532_ = (_e287 * 32u);
                } else {
                    phi_532_ = u32();
                }
                let _e307 = phi_532_;
                continue;
                continuing {
                    phi_528_ = _e299;
                    phi_531_ = _e307;
                    break if !(_e304);
                }
            }
            let _e311 = local_5;
            if (_e311 == 0u) {
                return;
            }
            let _e314 = local_6;
            let _e315 = ((_e282 - 1u) / _e314);
            if (_e315 < _e280) {
                phi_572_ = _e315;
            } else {
                phi_572_ = _e280;
            }
            let _e318 = phi_572_;
            let _e320 = local_7;
            let _e321 = (_e318 * _e320);
            let _e323 = local_8;
            let _e325 = (_e321 + (_e323 - 1u));
            let _e326 = (_e282 - 1u);
            if (_e326 < _e325) {
                phi_581_ = _e326;
            } else {
                phi_581_ = _e325;
            }
            let _e329 = phi_581_;
            let _e333 = params.member.member_2.member[0u][_e201[1]];
            let _e336 = worlds.member[(_e333 + _e321)];
            let _e341 = worlds.member[(_e333 + _e329)];
            ranges[_e45] = ((_e336 << bitcast<u32>(16i)) | _e341);
            let _e346 = params.member.member_2.member_1;
            if (_e346 == 0u) {
                phi_626_ = array<u32, 2>(0u, 2u);
            } else {
                phi_626_ = array<u32, 2>(1u, 1u);
            }
            let _e349 = phi_626_;
            let _e352 = (_e45 / 32u);
            let _e353 = (_e45 % 32u);
            let _e355 = params.member.member_2.member_2;
            let _e359 = params.member.member_2.member[_e355][_e349[0]];
            let _e362 = nodes.member[(_e359 + _e182)];
            let _e376 = params.member.member_2.member_2;
            let _e380 = params.member.member_2.member[_e376][_e349[1]];
            let _e383 = nodes.member[(_e380 + _e185)];
            let _e397 = params.member.member_2.member_2;
            let _e404 = params.member.member_2.member[(_e397 - 1u)][_e349[0]];
            let _e407 = nodes.member[(_e404 + ((_e182 * 32u) + _e353))];
            let _e424 = params.member.member_2.member_2;
            let _e431 = params.member.member_2.member[(_e424 - 1u)][_e349[1]];
            let _e434 = nodes.member[(_e431 + ((_e185 * 32u) + _e353))];
            if _e168 {
                phi_787_ = ((((((_e407.member.x <= _e383.member_1.y) && (_e383.member.x <= _e407.member_1.y)) && (_e407.member.y <= _e383.member_2.x)) && (_e383.member.y <= _e407.member_2.x)) && (_e407.member_1.x <= _e383.member_2.y)) && (_e383.member_1.x <= _e407.member_2.y));
            } else {
                phi_787_ = false;
            }
            let _e459 = phi_787_;
            if _e168 {
                if ((((((_e434.member.x <= _e362.member_1.y) && (_e362.member.x <= _e434.member_1.y)) && (_e434.member.y <= _e362.member_2.x)) && (_e362.member.y <= _e434.member_2.x)) && (_e434.member_1.x <= _e362.member_2.y)) && (_e362.member_1.x <= _e434.member_2.y)) {
                    let _e473 = atomicAdd((&counters[_e352]), 1u);
                    let _e474 = ((_e352 * 32u) + _e473);
                    columns[_e474] = type_24(array<f32, 3>(_e434.member.x, _e434.member.y, _e434.member_1.x), array<f32, 3>(_e434.member_1.y, _e434.member_2.x, _e434.member_2.y));
                    names[_e474] = _e353;
                }
            }
            if _e459 {
                phi_825_ = type_24(array<f32, 3>(_e407.member.x, _e407.member.y, _e407.member_1.x), array<f32, 3>(_e407.member_1.y, _e407.member_2.x, _e407.member_2.y));
            } else {
                phi_825_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e481 = phi_825_;
            workgroupBarrier();
            let _e484 = params.member.member_2.member_1;
            if (_e484 == 1u) {
                phi_834_ = (_e182 == _e185);
            } else {
                phi_834_ = false;
            }
            let _e488 = phi_834_;
            let _e489 = (_e45 / 32u);
            let _e490 = (_e45 % 32u);
            let _e491 = (_e489 * 32u);
            let _e493 = atomicLoad((&counters[_e489]));
            let _e494 = (_e493 / 4u);
            if ((_e493 % 4u) > 0u) {
                phi_857_ = (_e494 + 1u);
            } else {
                phi_857_ = _e494;
            }
            let _e499 = phi_857_;
            phi_860_ = type_9(0u, _e499);
            phi_863_ = 0u;
            loop {
                let _e502 = phi_860_;
                let _e504 = phi_863_;
                local_9 = _e504;
                local_13 = _e504;
                if (_e502.member < _e502.member_1) {
                    phi_861_ = type_9((_e502.member + 1u), _e502.member_1);
                    phi_886_ = type_9(1u, _e502.member);
                } else {
                    phi_861_ = _e502;
                    phi_886_ = type_9(0u, type_9().member_1);
                }
                let _e516 = phi_861_;
                let _e518 = phi_886_;
                let _e522 = (bitcast<i32>(_e518.member) != 0i);
                if _e522 {
                    let _e523 = (4u * _e518.member_1);
                    let _e526 = columns[(_e491 + _e523)];
                    let _e565 = columns[((_e491 + _e523) + 1u)];
                    let _e606 = columns[((_e491 + _e523) + 2u)];
                    let _e647 = columns[((_e491 + _e523) + 3u)];
                    phi_864_ = (_e504 | ((((select(0u, 1u, ((((((_e481.member[0] <= _e526.member_1[0]) && (_e526.member[0] <= _e481.member_1[0])) && (_e481.member[1] <= _e526.member_1[1])) && (_e526.member[1] <= _e481.member_1[1])) && (_e481.member[2] <= _e526.member_1[2])) && (_e526.member[2] <= _e481.member_1[2]))) << bitcast<u32>((_e523 & 31u))) | (select(0u, 1u, ((((((_e481.member[0] <= _e565.member_1[0]) && (_e565.member[0] <= _e481.member_1[0])) && (_e481.member[1] <= _e565.member_1[1])) && (_e565.member[1] <= _e481.member_1[1])) && (_e481.member[2] <= _e565.member_1[2])) && (_e565.member[2] <= _e481.member_1[2]))) << bitcast<u32>(((_e523 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e481.member[0] <= _e606.member_1[0]) && (_e606.member[0] <= _e481.member_1[0])) && (_e481.member[1] <= _e606.member_1[1])) && (_e606.member[1] <= _e481.member_1[1])) && (_e481.member[2] <= _e606.member_1[2])) && (_e606.member[2] <= _e481.member_1[2]))) << bitcast<u32>(((_e523 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e481.member[0] <= _e647.member_1[0]) && (_e647.member[0] <= _e481.member_1[0])) && (_e481.member[1] <= _e647.member_1[1])) && (_e647.member[1] <= _e481.member_1[1])) && (_e481.member[2] <= _e647.member_1[2])) && (_e647.member[2] <= _e481.member_1[2]))) << bitcast<u32>(((_e523 + 3u) & 31u)))));
                } else {
                    phi_864_ = u32();
                }
                let _e687 = phi_864_;
                continue;
                continuing {
                    phi_860_ = _e516;
                    phi_863_ = _e687;
                    break if !(_e522);
                }
            }
            if (_e493 < 32u) {
                let _e695 = local_9;
                phi_1075_ = (_e695 & ((1u << bitcast<u32>((_e493 & 31u))) - 1u));
            } else {
                let _e1008 = local_13;
                phi_1075_ = _e1008;
            }
            let _e698 = phi_1075_;
            phi_1078_ = type_9(0u, _e493);
            phi_1081_ = _e698;
            loop {
                let _e701 = phi_1078_;
                let _e703 = phi_1081_;
                local_10 = _e703;
                local_11 = _e703;
                local_12 = _e703;
                if (_e701.member < _e701.member_1) {
                    phi_1079_ = type_9((_e701.member + 1u), _e701.member_1);
                    phi_1104_ = type_9(1u, _e701.member);
                } else {
                    phi_1079_ = _e701;
                    phi_1104_ = type_9(0u, type_9().member_1);
                }
                let _e715 = phi_1079_;
                let _e717 = phi_1104_;
                let _e721 = (bitcast<i32>(_e717.member) != 0i);
                if _e721 {
                    let _e724 = names[(_e491 + _e717.member_1)];
                    let _e727 = ranges[(_e491 + _e724)];
                    if ((_e278 >> bitcast<u32>(16i)) <= (_e727 & 65535u)) {
                        phi_1127_ = ((_e727 >> bitcast<u32>(16i)) <= (_e278 & 65535u));
                    } else {
                        phi_1127_ = false;
                    }
                    let _e737 = phi_1127_;
                    if _e488 {
                        let _e738 = (_e490 < _e724);
                        if _e738 {
                            phi_1141_ = bool();
                        } else {
                            if (_e490 == _e724) {
                                phi_1140_ = true;
                            } else {
                                phi_1140_ = false;
                            }
                            let _e741 = phi_1140_;
                            phi_1141_ = _e741;
                        }
                        let _e743 = phi_1141_;
                        phi_1142_ = _e743;
                        phi_1143_ = _e738;
                    } else {
                        phi_1142_ = bool();
                        phi_1143_ = true;
                    }
                    let _e745 = phi_1142_;
                    let _e747 = phi_1143_;
                    if _e747 {
                        phi_1147_ = true;
                    } else {
                        phi_1147_ = _e745;
                    }
                    let _e749 = phi_1147_;
                    if _e749 {
                        if _e737 {
                            phi_1154_ = false;
                        } else {
                            phi_1154_ = true;
                        }
                        let _e751 = phi_1154_;
                        phi_1155_ = _e751;
                    } else {
                        phi_1155_ = true;
                    }
                    let _e753 = phi_1155_;
                    if _e753 {
                        phi_1163_ = (_e703 & ~((1u << bitcast<u32>((_e717.member_1 & 31u)))));
                    } else {
                        phi_1163_ = _e703;
                    }
                    let _e760 = phi_1163_;
                    phi_1082_ = _e760;
                } else {
                    phi_1082_ = u32();
                }
                let _e762 = phi_1082_;
                continue;
                continuing {
                    phi_1078_ = _e715;
                    phi_1081_ = _e762;
                    break if !(_e721);
                }
            }
            let _e765 = local_10;
            let _e768 = local_11;
            let _e769 = countOneBits(_e768);
            if (_e769 > 0u) {
                let _e772 = atomicAdd((&counters[4u]), _e769);
                let _e774 = local_12;
                phi_1173_ = type_9(_e774, _e772);
            } else {
                phi_1173_ = type_9(_e765, 0u);
            }
            let _e777 = phi_1173_;
            workgroupBarrier();
            if (_e45 == 0u) {
                let _e780 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e780;
            }
            let _e783 = workgroupUniformLoad((&n_hits[0u]));
            let _e784 = (_e783 / 512u);
            if ((_e783 % 512u) > 0u) {
                phi_1199_ = (_e784 + 1u);
            } else {
                phi_1199_ = _e784;
            }
            let _e789 = phi_1199_;
            phi_1202_ = type_9(0u, _e789);
            phi_1205_ = _e777;
            loop {
                let _e792 = phi_1202_;
                let _e794 = phi_1205_;
                if (_e792.member < _e792.member_1) {
                    phi_1203_ = type_9((_e792.member + 1u), _e792.member_1);
                    phi_1228_ = type_9(1u, _e792.member);
                } else {
                    phi_1203_ = _e792;
                    phi_1228_ = type_9(0u, type_9().member_1);
                }
                let _e806 = phi_1203_;
                let _e808 = phi_1228_;
                let _e812 = (bitcast<i32>(_e808.member) != 0i);
                if _e812 {
                    let _e813 = (_e45 / 32u);
                    let _e815 = (_e808.member_1 * 512u);
                    phi_1245_ = _e794;
                    phi_1248_ = type_9(0u, countOneBits(_e794.member));
                    loop {
                        let _e820 = phi_1245_;
                        let _e822 = phi_1248_;
                        local_14 = _e820;
                        if (_e822.member < _e822.member_1) {
                            phi_1249_ = type_9((_e822.member + 1u), _e822.member_1);
                            phi_1271_ = type_9(1u, _e822.member);
                        } else {
                            phi_1249_ = _e822;
                            phi_1271_ = type_9(0u, type_9().member_1);
                        }
                        let _e834 = phi_1249_;
                        let _e836 = phi_1271_;
                        if (bitcast<i32>(_e836.member) != 0i) {
                            let _e841 = (_e820.member_1 - _e815);
                            if (_e841 >= 512u) {
                                phi_1305_ = type_9();
                                phi_1306_ = false;
                            } else {
                                let _e850 = names[((_e813 * 32u) + select(firstTrailingBit(_e820.member), 32u, (_e820.member == 0u)))];
                                hits[_e841] = (((_e813 << bitcast<u32>(10i)) | ((_e45 % 32u) << bitcast<u32>(5i))) | _e850);
                                phi_1305_ = type_9((_e820.member & (_e820.member - 1u)), (_e820.member_1 + 1u));
                                phi_1306_ = true;
                            }
                            let _e866 = phi_1305_;
                            let _e868 = phi_1306_;
                            phi_1246_ = _e866;
                            phi_1307_ = _e868;
                        } else {
                            phi_1246_ = type_9();
                            phi_1307_ = false;
                        }
                        let _e870 = phi_1246_;
                        let _e872 = phi_1307_;
                        continue;
                        continuing {
                            phi_1245_ = _e870;
                            phi_1248_ = _e834;
                            break if !(_e872);
                        }
                    }
                    workgroupBarrier();
                    let _e875 = n_hits[0u];
                    let _e876 = (_e875 - _e815);
                    if (512u < _e876) {
                        phi_1315_ = 512u;
                    } else {
                        phi_1315_ = _e876;
                    }
                    let _e879 = phi_1315_;
                    if (_e45 == 0u) {
                        atomicStore((&counters[7u]), _e879);
                    }
                    workgroupBarrier();
                    if (_e45 == 0u) {
                        let _e884 = atomicLoad((&counters[7u]));
                        if (_e884 > 0u) {
                            let _e887 = atomicAdd((&output.member[0u]), _e884);
                            if ((_e887 + _e884) < _e887) {
                                let _e891 = atomicAdd((&output.member[2u]), 1u);
                            }
                            atomicStore((&counters[8u]), _e887);
                        }
                        atomicStore((&counters[5u]), 0u);
                        atomicStore((&counters[6u]), 0u);
                        atomicStore((&counters[7u]), 0u);
                    }
                    workgroupBarrier();
                    let _e897 = atomicLoad((&counters[8u]));
                    phi_1352_ = type_9(0u, 4u);
                    loop {
                        let _e899 = phi_1352_;
                        if (_e899.member < _e899.member_1) {
                            phi_1353_ = type_9((_e899.member + 1u), _e899.member_1);
                            phi_1376_ = type_9(1u, _e899.member);
                        } else {
                            phi_1353_ = _e899;
                            phi_1376_ = type_9(0u, type_9().member_1);
                        }
                        let _e911 = phi_1353_;
                        let _e913 = phi_1376_;
                        if (bitcast<i32>(_e913.member) != 0i) {
                            let _e919 = (_e45 + (_e913.member_1 * 128u));
                            if (_e919 >= _e879) {
                                phi_1421_ = false;
                            } else {
                                let _e922 = hits[_e919];
                                let _e925 = ((_e922 >> bitcast<u32>(10i)) & 3u);
                                let _e932 = firsts[(2u * _e925)];
                                let _e937 = firsts[((2u * _e925) + 1u)];
                                let _e941 = params.member.member_1.member_3;
                                let _e942 = (_e897 + _e919);
                                if (_e942 < _e941) {
                                    let _e944 = (2u * _e942);
                                    atomicStore((&output.member[(4u + _e944)]), (_e932 + ((_e922 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e944 + 5u)]), (_e937 + (_e922 & 31u)));
                                }
                                phi_1421_ = true;
                            }
                            let _e950 = phi_1421_;
                            phi_1422_ = _e950;
                        } else {
                            phi_1422_ = false;
                        }
                        let _e952 = phi_1422_;
                        continue;
                        continuing {
                            phi_1352_ = _e911;
                            break if !(_e952);
                        }
                    }
                    workgroupBarrier();
                    let _e1048 = local_14;
                    phi_1206_ = _e1048;
                } else {
                    phi_1206_ = type_9();
                }
                let _e955 = phi_1206_;
                continue;
                continuing {
                    phi_1202_ = _e806;
                    phi_1205_ = _e955;
                    break if !(_e812);
                }
            }
        }
        continue;
        continuing {
            phi_257_ = _e129;
            break if !(_e135);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
