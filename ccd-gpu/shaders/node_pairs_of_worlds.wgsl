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
var<workgroup> counters: array<atomic<u32>, 8>;
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
    var phi_1099_: bool;
    var phi_1105_: type_9;
    var phi_1108_: u32;
    var phi_1106_: type_9;
    var phi_1131_: type_9;
    var phi_1164_: bool;
    var phi_1172_: u32;
    var phi_1109_: u32;
    var phi_1173_: u32;
    var phi_1174_: u32;
    var phi_1178_: type_9;
    var phi_1181_: u32;
    var phi_1179_: type_9;
    var phi_1204_: type_9;
    var phi_1227_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1247_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1263_: u32;
    var phi_1182_: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_1273_: type_9;
    var phi_1299_: u32;
    var phi_1302_: type_9;
    var phi_1305_: type_9;
    var phi_1303_: type_9;
    var phi_1328_: type_9;
    var phi_1345_: type_9;
    var phi_1348_: type_9;
    var phi_1349_: type_9;
    var phi_1371_: type_9;
    var phi_1405_: type_9;
    var phi_1406_: bool;
    var phi_1346_: type_9;
    var phi_1407_: bool;
    var phi_1415_: u32;
    var phi_1449_: u32;
    var phi_1472_: u32;
    var phi_1479_: type_9;
    var phi_1480_: type_9;
    var phi_1503_: type_9;
    var phi_1548_: bool;
    var phi_1549_: bool;
    var phi_1306_: type_9;
    var local_13: u32;
    var local_14: u32;
    var local_15: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e44 = id_2;
    let _e45 = n_2;
    let _e46 = lane_2;
    let _e56 = ((_e44.y * _e45.x) + _e44.x);
    let _e59 = (_e45.x * _e45.y);
    let _e63 = params.member.member_1.member_2;
    let _e65 = input.member[0u];
    if (_e63 < _e65) {
        phi_168_ = _e63;
    } else {
        phi_168_ = _e65;
    }
    let _e68 = phi_168_;
    let _e69 = (_e46 / 32u);
    let _e70 = (_e46 % 32u);
    let _e73 = params.member.member_1.member_1;
    if (_e68 > _e73) {
        let _e77 = params.member.member_1.member_1;
        let _e78 = (_e68 - _e77);
        let _e81 = params.member.member_2.member_3;
        if (_e81 == 0u) {
            return;
        }
        let _e83 = (_e78 / _e81);
        if (_e81 == 0u) {
            return;
        }
        if ((_e78 % _e81) > 0u) {
            phi_205_ = (_e83 + 1u);
        } else {
            phi_205_ = _e83;
        }
        let _e89 = phi_205_;
        phi_206_ = _e89;
    } else {
        phi_206_ = 0u;
    }
    let _e91 = phi_206_;
    let _e94 = params.member.member_2.member_4;
    if (_e94 < _e91) {
        phi_214_ = _e94;
    } else {
        phi_214_ = _e91;
    }
    let _e97 = phi_214_;
    let _e98 = (_e97 / 4u);
    if ((_e97 % 4u) > 0u) {
        phi_230_ = (_e98 + 1u);
    } else {
        phi_230_ = _e98;
    }
    let _e103 = phi_230_;
    if (_e103 > _e56) {
        let _e105 = (_e103 - _e56);
        if (_e59 == 0u) {
            return;
        }
        let _e107 = (_e105 / _e59);
        if (_e59 == 0u) {
            return;
        }
        if ((_e105 % _e59) > 0u) {
            phi_253_ = (_e107 + 1u);
        } else {
            phi_253_ = _e107;
        }
        let _e113 = phi_253_;
        phi_254_ = _e113;
    } else {
        phi_254_ = 0u;
    }
    let _e115 = phi_254_;
    phi_257_ = type_9(0u, _e115);
    loop {
        let _e118 = phi_257_;
        if (_e118.member < _e118.member_1) {
            phi_258_ = type_9((_e118.member + 1u), _e118.member_1);
            phi_281_ = type_9(1u, _e118.member);
        } else {
            phi_258_ = _e118;
            phi_281_ = type_9(0u, type_9().member_1);
        }
        let _e130 = phi_258_;
        let _e132 = phi_281_;
        let _e136 = (bitcast<i32>(_e132.member) != 0i);
        if _e136 {
            let _e141 = (((_e56 + (_e132.member_1 * _e59)) * 4u) + (_e46 / 32u));
            let _e144 = params.member.member_1.member_1;
            if (_e68 > _e144) {
                let _e148 = params.member.member_1.member_1;
                let _e149 = (_e68 - _e148);
                let _e152 = params.member.member_2.member_3;
                if (_e152 == 0u) {
                    return;
                }
                let _e154 = (_e149 / _e152);
                if (_e152 == 0u) {
                    return;
                }
                if ((_e149 % _e152) > 0u) {
                    phi_328_ = (_e154 + 1u);
                } else {
                    phi_328_ = _e154;
                }
                let _e160 = phi_328_;
                phi_329_ = _e160;
            } else {
                phi_329_ = 0u;
            }
            let _e162 = phi_329_;
            let _e165 = params.member.member_2.member_4;
            if (_e165 < _e162) {
                phi_337_ = _e165;
            } else {
                phi_337_ = _e162;
            }
            let _e168 = phi_337_;
            let _e169 = (_e141 < _e168);
            let _e172 = params.member.member_1.member_1;
            let _e175 = params.member.member_2.member_3;
            if _e169 {
                phi_351_ = (_e141 * _e175);
            } else {
                phi_351_ = 0u;
            }
            let _e178 = phi_351_;
            let _e180 = (2u * (_e172 + _e178));
            let _e183 = input.member[(4u + _e180)];
            let _e186 = input.member[(_e180 + 5u)];
            if (_e46 <= 5u) {
                atomicStore((&counters[_e46]), 0u);
            }
            workgroupBarrier();
            if (_e70 == 0u) {
                firsts[(2u * _e69)] = (_e183 * 32u);
                firsts[((2u * _e69) + 1u)] = (_e186 * 32u);
            }
            let _e199 = params.member.member_2.member_1;
            if (_e199 == 0u) {
                phi_408_ = array<u32, 2>(0u, 2u);
            } else {
                phi_408_ = array<u32, 2>(1u, 1u);
            }
            let _e202 = phi_408_;
            let _e205 = params.member.member_2.member_2;
            let _e206 = (_e205 - 1u);
            let _e209 = params.member.member.member;
            local = array<u32, 3>(_e209[0], _e209[1], _e209[2]);
            let _e217 = ((_e183 * 32u) + _e70);
            let _e219 = local[_e202[0]];
            phi_432_ = type_9(0u, _e206);
            phi_435_ = 1u;
            loop {
                let _e222 = phi_432_;
                let _e224 = phi_435_;
                local_1 = _e224;
                local_2 = _e224;
                local_3 = _e224;
                local_4 = _e224;
                if (_e222.member < _e222.member_1) {
                    phi_433_ = type_9((_e222.member + 1u), _e222.member_1);
                    phi_458_ = type_9(1u, _e222.member);
                } else {
                    phi_433_ = _e222;
                    phi_458_ = type_9(0u, type_9().member_1);
                }
                let _e236 = phi_433_;
                let _e238 = phi_458_;
                let _e241 = (bitcast<i32>(_e238.member) != 0i);
                if _e241 {
                    phi_436_ = (_e224 * 32u);
                } else {
                    phi_436_ = u32();
                }
                let _e244 = phi_436_;
                continue;
                continuing {
                    phi_432_ = _e236;
                    phi_435_ = _e244;
                    break if !(_e241);
                }
            }
            let _e248 = local_1;
            if (_e248 == 0u) {
                return;
            }
            let _e251 = local_2;
            let _e252 = ((_e219 - 1u) / _e251);
            if (_e252 < _e217) {
                phi_476_ = _e252;
            } else {
                phi_476_ = _e217;
            }
            let _e255 = phi_476_;
            let _e257 = local_3;
            let _e258 = (_e255 * _e257);
            let _e260 = local_4;
            let _e262 = (_e258 + (_e260 - 1u));
            let _e263 = (_e219 - 1u);
            if (_e263 < _e262) {
                phi_485_ = _e263;
            } else {
                phi_485_ = _e262;
            }
            let _e266 = phi_485_;
            let _e270 = params.member.member_2.member[0u][_e202[0]];
            let _e273 = worlds.member[(_e270 + _e258)];
            let _e278 = worlds.member[(_e270 + _e266)];
            let _e279 = ((_e273 << bitcast<u32>(16i)) | _e278);
            let _e281 = ((_e186 * 32u) + _e70);
            let _e283 = local[_e202[1]];
            phi_528_ = type_9(0u, _e206);
            phi_531_ = 1u;
            loop {
                let _e286 = phi_528_;
                let _e288 = phi_531_;
                local_5 = _e288;
                local_6 = _e288;
                local_7 = _e288;
                local_8 = _e288;
                if (_e286.member < _e286.member_1) {
                    phi_529_ = type_9((_e286.member + 1u), _e286.member_1);
                    phi_554_ = type_9(1u, _e286.member);
                } else {
                    phi_529_ = _e286;
                    phi_554_ = type_9(0u, type_9().member_1);
                }
                let _e300 = phi_529_;
                let _e302 = phi_554_;
                let _e305 = (bitcast<i32>(_e302.member) != 0i);
                if _e305 {
                    phi_532_ = (_e288 * 32u);
                } else {
                    phi_532_ = u32();
                }
                let _e308 = phi_532_;
                continue;
                continuing {
                    phi_528_ = _e300;
                    phi_531_ = _e308;
                    break if !(_e305);
                }
            }
            let _e312 = local_5;
            if (_e312 == 0u) {
                return;
            }
            let _e315 = local_6;
            let _e316 = ((_e283 - 1u) / _e315);
            if (_e316 < _e281) {
                phi_572_ = _e316;
            } else {
                phi_572_ = _e281;
            }
            let _e319 = phi_572_;
            let _e321 = local_7;
            let _e322 = (_e319 * _e321);
            let _e324 = local_8;
            let _e326 = (_e322 + (_e324 - 1u));
            let _e327 = (_e283 - 1u);
            if (_e327 < _e326) {
                phi_581_ = _e327;
            } else {
                phi_581_ = _e326;
            }
            let _e330 = phi_581_;
            let _e334 = params.member.member_2.member[0u][_e202[1]];
            let _e337 = worlds.member[(_e334 + _e322)];
            let _e342 = worlds.member[(_e334 + _e330)];
            ranges[_e46] = ((_e337 << bitcast<u32>(16i)) | _e342);
            let _e347 = params.member.member_2.member_1;
            if (_e347 == 0u) {
                phi_626_ = array<u32, 2>(0u, 2u);
            } else {
                phi_626_ = array<u32, 2>(1u, 1u);
            }
            let _e350 = phi_626_;
            let _e353 = (_e46 / 32u);
            let _e354 = (_e46 % 32u);
            let _e356 = params.member.member_2.member_2;
            let _e360 = params.member.member_2.member[_e356][_e350[0]];
            let _e363 = nodes.member[(_e360 + _e183)];
            let _e377 = params.member.member_2.member_2;
            let _e381 = params.member.member_2.member[_e377][_e350[1]];
            let _e384 = nodes.member[(_e381 + _e186)];
            let _e398 = params.member.member_2.member_2;
            let _e405 = params.member.member_2.member[(_e398 - 1u)][_e350[0]];
            let _e408 = nodes.member[(_e405 + ((_e183 * 32u) + _e354))];
            let _e425 = params.member.member_2.member_2;
            let _e432 = params.member.member_2.member[(_e425 - 1u)][_e350[1]];
            let _e435 = nodes.member[(_e432 + ((_e186 * 32u) + _e354))];
            if _e169 {
                phi_787_ = ((((((_e408.member.x <= _e384.member_1.y) && (_e384.member.x <= _e408.member_1.y)) && (_e408.member.y <= _e384.member_2.x)) && (_e384.member.y <= _e408.member_2.x)) && (_e408.member_1.x <= _e384.member_2.y)) && (_e384.member_1.x <= _e408.member_2.y));
            } else {
                phi_787_ = false;
            }
            let _e460 = phi_787_;
            if _e169 {
                if ((((((_e435.member.x <= _e363.member_1.y) && (_e363.member.x <= _e435.member_1.y)) && (_e435.member.y <= _e363.member_2.x)) && (_e363.member.y <= _e435.member_2.x)) && (_e435.member_1.x <= _e363.member_2.y)) && (_e363.member_1.x <= _e435.member_2.y)) {
                    let _e474 = atomicAdd((&counters[_e353]), 1u);
                    let _e475 = ((_e353 * 32u) + _e474);
                    columns[_e475] = type_24(array<f32, 3>(_e435.member.x, _e435.member.y, _e435.member_1.x), array<f32, 3>(_e435.member_1.y, _e435.member_2.x, _e435.member_2.y));
                    names[_e475] = _e354;
                }
            }
            if _e460 {
                phi_825_ = type_24(array<f32, 3>(_e408.member.x, _e408.member.y, _e408.member_1.x), array<f32, 3>(_e408.member_1.y, _e408.member_2.x, _e408.member_2.y));
            } else {
                phi_825_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e482 = phi_825_;
            workgroupBarrier();
            let _e485 = params.member.member_2.member_1;
            if (_e485 == 1u) {
                phi_834_ = (_e183 == _e186);
            } else {
                phi_834_ = false;
            }
            let _e489 = phi_834_;
            let _e490 = (_e46 / 32u);
            let _e491 = (_e46 % 32u);
            let _e492 = (_e490 * 32u);
            let _e494 = atomicLoad((&counters[_e490]));
            let _e495 = (_e494 / 4u);
            if ((_e494 % 4u) > 0u) {
                phi_857_ = (_e495 + 1u);
            } else {
                phi_857_ = _e495;
            }
            let _e500 = phi_857_;
            phi_860_ = type_9(0u, _e500);
            phi_863_ = 0u;
            loop {
                let _e503 = phi_860_;
                let _e505 = phi_863_;
                local_9 = _e505;
                local_13 = _e505;
                if (_e503.member < _e503.member_1) {
                    phi_861_ = type_9((_e503.member + 1u), _e503.member_1);
                    phi_886_ = type_9(1u, _e503.member);
                } else {
                    phi_861_ = _e503;
                    phi_886_ = type_9(0u, type_9().member_1);
                }
                let _e517 = phi_861_;
                let _e519 = phi_886_;
                let _e523 = (bitcast<i32>(_e519.member) != 0i);
                if _e523 {
                    let _e524 = (4u * _e519.member_1);
                    let _e527 = columns[(_e492 + _e524)];
                    let _e566 = columns[((_e492 + _e524) + 1u)];
                    let _e607 = columns[((_e492 + _e524) + 2u)];
                    let _e648 = columns[((_e492 + _e524) + 3u)];
                    phi_864_ = (_e505 | ((((select(0u, 1u, ((((((_e482.member[0] <= _e527.member_1[0]) && (_e527.member[0] <= _e482.member_1[0])) && (_e482.member[1] <= _e527.member_1[1])) && (_e527.member[1] <= _e482.member_1[1])) && (_e482.member[2] <= _e527.member_1[2])) && (_e527.member[2] <= _e482.member_1[2]))) << bitcast<u32>((_e524 & 31u))) | (select(0u, 1u, ((((((_e482.member[0] <= _e566.member_1[0]) && (_e566.member[0] <= _e482.member_1[0])) && (_e482.member[1] <= _e566.member_1[1])) && (_e566.member[1] <= _e482.member_1[1])) && (_e482.member[2] <= _e566.member_1[2])) && (_e566.member[2] <= _e482.member_1[2]))) << bitcast<u32>(((_e524 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e482.member[0] <= _e607.member_1[0]) && (_e607.member[0] <= _e482.member_1[0])) && (_e482.member[1] <= _e607.member_1[1])) && (_e607.member[1] <= _e482.member_1[1])) && (_e482.member[2] <= _e607.member_1[2])) && (_e607.member[2] <= _e482.member_1[2]))) << bitcast<u32>(((_e524 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e482.member[0] <= _e648.member_1[0]) && (_e648.member[0] <= _e482.member_1[0])) && (_e482.member[1] <= _e648.member_1[1])) && (_e648.member[1] <= _e482.member_1[1])) && (_e482.member[2] <= _e648.member_1[2])) && (_e648.member[2] <= _e482.member_1[2]))) << bitcast<u32>(((_e524 + 3u) & 31u)))));
                } else {
                    phi_864_ = u32();
                }
                let _e688 = phi_864_;
                continue;
                continuing {
                    phi_860_ = _e517;
                    phi_863_ = _e688;
                    break if !(_e523);
                }
            }
            if (_e494 < 32u) {
                let _e696 = local_9;
                phi_1075_ = (_e696 & ((1u << bitcast<u32>((_e494 & 31u))) - 1u));
            } else {
                let _e1095 = local_13;
                phi_1075_ = _e1095;
            }
            let _e699 = phi_1075_;
            let _e702 = params.member.member.member_1;
            if ((_e702 & 256u) != 0u) {
                if ((bitcast<u32>(_e482.member_1[0]) & 1u) == 1u) {
                    phi_1099_ = true;
                } else {
                    phi_1099_ = !((_e482.member[0] <= _e482.member_1[0]));
                }
                let _e717 = phi_1099_;
                if _e717 {
                    phi_1105_ = type_9(0u, _e494);
                    phi_1108_ = _e699;
                    loop {
                        let _e720 = phi_1105_;
                        let _e722 = phi_1108_;
                        local_14 = _e722;
                        if (_e720.member < _e720.member_1) {
                            phi_1106_ = type_9((_e720.member + 1u), _e720.member_1);
                            phi_1131_ = type_9(1u, _e720.member);
                        } else {
                            phi_1106_ = _e720;
                            phi_1131_ = type_9(0u, type_9().member_1);
                        }
                        let _e734 = phi_1106_;
                        let _e736 = phi_1131_;
                        let _e740 = (bitcast<i32>(_e736.member) != 0i);
                        if _e740 {
                            let _e743 = columns[(_e492 + _e736.member_1)];
                            if ((bitcast<u32>(_e743.member_1[0]) & 1u) == 1u) {
                                phi_1164_ = true;
                            } else {
                                phi_1164_ = !((_e743.member[0] <= _e743.member_1[0]));
                            }
                            let _e754 = phi_1164_;
                            if _e754 {
                                phi_1172_ = (_e722 & ~((1u << bitcast<u32>((_e736.member_1 & 31u)))));
                            } else {
                                phi_1172_ = _e722;
                            }
                            let _e761 = phi_1172_;
                            phi_1109_ = _e761;
                        } else {
                            phi_1109_ = u32();
                        }
                        let _e763 = phi_1109_;
                        continue;
                        continuing {
                            phi_1105_ = _e734;
                            phi_1108_ = _e763;
                            break if !(_e740);
                        }
                    }
                    let _e1106 = local_14;
                    phi_1173_ = _e1106;
                } else {
                    phi_1173_ = _e699;
                }
                let _e766 = phi_1173_;
                phi_1174_ = _e766;
            } else {
                phi_1174_ = _e699;
            }
            let _e768 = phi_1174_;
            phi_1178_ = type_9(0u, _e494);
            phi_1181_ = _e768;
            loop {
                let _e771 = phi_1178_;
                let _e773 = phi_1181_;
                local_10 = _e773;
                local_11 = _e773;
                local_12 = _e773;
                if (_e771.member < _e771.member_1) {
                    phi_1179_ = type_9((_e771.member + 1u), _e771.member_1);
                    phi_1204_ = type_9(1u, _e771.member);
                } else {
                    phi_1179_ = _e771;
                    phi_1204_ = type_9(0u, type_9().member_1);
                }
                let _e785 = phi_1179_;
                let _e787 = phi_1204_;
                let _e791 = (bitcast<i32>(_e787.member) != 0i);
                if _e791 {
                    let _e794 = names[(_e492 + _e787.member_1)];
                    let _e797 = ranges[(_e492 + _e794)];
                    if ((_e279 >> bitcast<u32>(16i)) <= (_e797 & 65535u)) {
                        phi_1227_ = ((_e797 >> bitcast<u32>(16i)) <= (_e279 & 65535u));
                    } else {
                        phi_1227_ = false;
                    }
                    let _e807 = phi_1227_;
                    if _e489 {
                        let _e808 = (_e491 < _e794);
                        if _e808 {
                            phi_1241_ = bool();
                        } else {
                            if (_e491 == _e794) {
                                phi_1240_ = true;
                            } else {
                                phi_1240_ = false;
                            }
                            let _e811 = phi_1240_;
                            phi_1241_ = _e811;
                        }
                        let _e813 = phi_1241_;
                        phi_1242_ = _e813;
                        phi_1243_ = _e808;
                    } else {
                        phi_1242_ = bool();
                        phi_1243_ = true;
                    }
                    let _e815 = phi_1242_;
                    let _e817 = phi_1243_;
                    if _e817 {
                        phi_1247_ = true;
                    } else {
                        phi_1247_ = _e815;
                    }
                    let _e819 = phi_1247_;
                    if _e819 {
                        if _e807 {
                            phi_1254_ = false;
                        } else {
                            phi_1254_ = true;
                        }
                        let _e821 = phi_1254_;
                        phi_1255_ = _e821;
                    } else {
                        phi_1255_ = true;
                    }
                    let _e823 = phi_1255_;
                    if _e823 {
                        phi_1263_ = (_e773 & ~((1u << bitcast<u32>((_e787.member_1 & 31u)))));
                    } else {
                        phi_1263_ = _e773;
                    }
                    let _e830 = phi_1263_;
                    phi_1182_ = _e830;
                } else {
                    phi_1182_ = u32();
                }
                let _e832 = phi_1182_;
                continue;
                continuing {
                    phi_1178_ = _e785;
                    phi_1181_ = _e832;
                    break if !(_e791);
                }
            }
            let _e835 = local_10;
            let _e838 = local_11;
            let _e839 = countOneBits(_e838);
            if (_e839 > 0u) {
                let _e842 = atomicAdd((&counters[4u]), _e839);
                let _e844 = local_12;
                phi_1273_ = type_9(_e844, _e842);
            } else {
                phi_1273_ = type_9(_e835, 0u);
            }
            let _e847 = phi_1273_;
            workgroupBarrier();
            if (_e46 == 0u) {
                let _e850 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e850;
            }
            let _e853 = workgroupUniformLoad((&n_hits[0u]));
            let _e854 = (_e853 / 512u);
            if ((_e853 % 512u) > 0u) {
                phi_1299_ = (_e854 + 1u);
            } else {
                phi_1299_ = _e854;
            }
            let _e859 = phi_1299_;
            phi_1302_ = type_9(0u, _e859);
            phi_1305_ = _e847;
            loop {
                let _e862 = phi_1302_;
                let _e864 = phi_1305_;
                if (_e862.member < _e862.member_1) {
                    phi_1303_ = type_9((_e862.member + 1u), _e862.member_1);
                    phi_1328_ = type_9(1u, _e862.member);
                } else {
                    phi_1303_ = _e862;
                    phi_1328_ = type_9(0u, type_9().member_1);
                }
                let _e876 = phi_1303_;
                let _e878 = phi_1328_;
                let _e882 = (bitcast<i32>(_e878.member) != 0i);
                if _e882 {
                    let _e883 = (_e46 / 32u);
                    let _e885 = (_e878.member_1 * 512u);
                    phi_1345_ = _e864;
                    phi_1348_ = type_9(0u, countOneBits(_e864.member));
                    loop {
                        let _e890 = phi_1345_;
                        let _e892 = phi_1348_;
                        local_15 = _e890;
                        if (_e892.member < _e892.member_1) {
                            phi_1349_ = type_9((_e892.member + 1u), _e892.member_1);
                            phi_1371_ = type_9(1u, _e892.member);
                        } else {
                            phi_1349_ = _e892;
                            phi_1371_ = type_9(0u, type_9().member_1);
                        }
                        let _e904 = phi_1349_;
                        let _e906 = phi_1371_;
                        if (bitcast<i32>(_e906.member) != 0i) {
                            let _e911 = (_e890.member_1 - _e885);
                            if (_e911 >= 512u) {
                                phi_1405_ = type_9();
                                phi_1406_ = false;
                            } else {
                                let _e920 = names[((_e883 * 32u) + select(firstTrailingBit(_e890.member), 32u, (_e890.member == 0u)))];
                                hits[_e911] = (((_e883 << bitcast<u32>(10i)) | ((_e46 % 32u) << bitcast<u32>(5i))) | _e920);
                                phi_1405_ = type_9((_e890.member & (_e890.member - 1u)), (_e890.member_1 + 1u));
                                phi_1406_ = true;
                            }
                            let _e936 = phi_1405_;
                            let _e938 = phi_1406_;
                            phi_1346_ = _e936;
                            phi_1407_ = _e938;
                        } else {
                            phi_1346_ = type_9();
                            phi_1407_ = false;
                        }
                        let _e940 = phi_1346_;
                        let _e942 = phi_1407_;
                        continue;
                        continuing {
                            phi_1345_ = _e940;
                            phi_1348_ = _e904;
                            break if !(_e942);
                        }
                    }
                    workgroupBarrier();
                    let _e945 = n_hits[0u];
                    let _e946 = (_e945 - _e885);
                    if (512u < _e946) {
                        phi_1415_ = 512u;
                    } else {
                        phi_1415_ = _e946;
                    }
                    let _e949 = phi_1415_;
                    if (_e46 == 0u) {
                        atomicStore((&counters[5u]), _e949);
                    }
                    workgroupBarrier();
                    if (_e46 == 0u) {
                        let _e954 = atomicLoad((&counters[5u]));
                        if (_e954 > 0u) {
                            let _e958 = params.member.member.member_1;
                            if ((_e958 & 1024u) != 0u) {
                                let _e968 = atomicAdd((&output.member[0u]), _e954);
                                let _e969 = (_e968 + _e954);
                                if (_e969 < _e968) {
                                    phi_1449_ = 4294967295u;
                                } else {
                                    phi_1449_ = _e969;
                                }
                                let _e972 = phi_1449_;
                                let _e975 = params.member.member_1.member_3;
                                if (_e972 > _e975) {
                                    let _e978 = atomicMax((&output.member[2u]), _e972);
                                }
                                phi_1472_ = _e968;
                            } else {
                                let _e962 = atomicAdd((&output.member[0u]), _e954);
                                if ((_e962 + _e954) < _e962) {
                                    let _e966 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1472_ = _e962;
                            }
                            let _e980 = phi_1472_;
                            atomicStore((&counters[6u]), _e980);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e984 = atomicLoad((&counters[6u]));
                    phi_1479_ = type_9(0u, 4u);
                    loop {
                        let _e986 = phi_1479_;
                        if (_e986.member < _e986.member_1) {
                            phi_1480_ = type_9((_e986.member + 1u), _e986.member_1);
                            phi_1503_ = type_9(1u, _e986.member);
                        } else {
                            phi_1480_ = _e986;
                            phi_1503_ = type_9(0u, type_9().member_1);
                        }
                        let _e998 = phi_1480_;
                        let _e1000 = phi_1503_;
                        if (bitcast<i32>(_e1000.member) != 0i) {
                            let _e1006 = (_e46 + (_e1000.member_1 * 128u));
                            if (_e1006 >= _e949) {
                                phi_1548_ = false;
                            } else {
                                let _e1009 = hits[_e1006];
                                let _e1012 = ((_e1009 >> bitcast<u32>(10i)) & 3u);
                                let _e1019 = firsts[(2u * _e1012)];
                                let _e1024 = firsts[((2u * _e1012) + 1u)];
                                let _e1028 = params.member.member_1.member_3;
                                let _e1029 = (_e984 + _e1006);
                                if (_e1029 < _e1028) {
                                    let _e1031 = (2u * _e1029);
                                    atomicStore((&output.member[(4u + _e1031)]), (_e1019 + ((_e1009 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e1031 + 5u)]), (_e1024 + (_e1009 & 31u)));
                                }
                                phi_1548_ = true;
                            }
                            let _e1037 = phi_1548_;
                            phi_1549_ = _e1037;
                        } else {
                            phi_1549_ = false;
                        }
                        let _e1039 = phi_1549_;
                        continue;
                        continuing {
                            phi_1479_ = _e998;
                            break if !(_e1039);
                        }
                    }
                    workgroupBarrier();
                    let _e1149 = local_15;
                    phi_1306_ = _e1149;
                } else {
                    phi_1306_ = type_9();
                }
                let _e1042 = phi_1306_;
                continue;
                continuing {
                    phi_1302_ = _e876;
                    phi_1305_ = _e1042;
                    break if !(_e882);
                }
            }
        }
        continue;
        continuing {
            phi_257_ = _e130;
            break if !(_e136);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
