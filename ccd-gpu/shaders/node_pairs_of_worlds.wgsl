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
    var phi_170_: u32;
    var phi_207_: u32;
    var phi_208_: u32;
    var phi_216_: u32;
    var phi_232_: u32;
    var phi_255_: u32;
    var phi_256_: u32;
    var phi_259_: type_9;
    var phi_260_: type_9;
    var phi_283_: type_9;
    var phi_330_: u32;
    var phi_331_: u32;
    var phi_339_: u32;
    var phi_353_: u32;
    var phi_410_: array<u32, 2>;
    var phi_434_: type_9;
    var phi_437_: u32;
    var phi_435_: type_9;
    var phi_460_: type_9;
    var phi_438_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_478_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_487_: u32;
    var phi_530_: type_9;
    var phi_533_: u32;
    var phi_531_: type_9;
    var phi_556_: type_9;
    var phi_534_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_574_: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_583_: u32;
    var phi_628_: array<u32, 2>;
    var phi_789_: bool;
    var phi_827_: type_24;
    var phi_836_: bool;
    var phi_859_: u32;
    var phi_862_: type_9;
    var phi_865_: u32;
    var phi_863_: type_9;
    var phi_888_: type_9;
    var phi_866_: u32;
    var local_9: u32;
    var phi_1077_: u32;
    var phi_1101_: bool;
    var phi_1107_: type_9;
    var phi_1110_: u32;
    var phi_1108_: type_9;
    var phi_1133_: type_9;
    var phi_1166_: bool;
    var phi_1174_: u32;
    var phi_1111_: u32;
    var phi_1175_: u32;
    var phi_1176_: u32;
    var phi_1180_: type_9;
    var phi_1183_: u32;
    var phi_1181_: type_9;
    var phi_1206_: type_9;
    var phi_1229_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1249_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1265_: u32;
    var phi_1184_: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_1275_: type_9;
    var phi_1301_: u32;
    var phi_1304_: type_9;
    var phi_1307_: type_9;
    var phi_1305_: type_9;
    var phi_1330_: type_9;
    var phi_1347_: type_9;
    var phi_1350_: type_9;
    var phi_1351_: type_9;
    var phi_1373_: type_9;
    var phi_1407_: type_9;
    var phi_1408_: bool;
    var phi_1348_: type_9;
    var phi_1409_: bool;
    var phi_1417_: u32;
    var phi_1454_: type_9;
    var phi_1455_: type_9;
    var phi_1478_: type_9;
    var phi_1523_: bool;
    var phi_1524_: bool;
    var phi_1308_: type_9;
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
        phi_170_ = _e63;
    } else {
        phi_170_ = _e65;
    }
    let _e68 = phi_170_;
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
            phi_207_ = (_e83 + 1u);
        } else {
            phi_207_ = _e83;
        }
        let _e89 = phi_207_;
        phi_208_ = _e89;
    } else {
        phi_208_ = 0u;
    }
    let _e91 = phi_208_;
    let _e94 = params.member.member_2.member_4;
    if (_e94 < _e91) {
        phi_216_ = _e94;
    } else {
        phi_216_ = _e91;
    }
    let _e97 = phi_216_;
    let _e98 = (_e97 / 4u);
    if ((_e97 % 4u) > 0u) {
        phi_232_ = (_e98 + 1u);
    } else {
        phi_232_ = _e98;
    }
    let _e103 = phi_232_;
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
            phi_255_ = (_e107 + 1u);
        } else {
            phi_255_ = _e107;
        }
        let _e113 = phi_255_;
        phi_256_ = _e113;
    } else {
        phi_256_ = 0u;
    }
    let _e115 = phi_256_;
    phi_259_ = type_9(0u, _e115);
    loop {
        let _e118 = phi_259_;
        if (_e118.member < _e118.member_1) {
            phi_260_ = type_9((_e118.member + 1u), _e118.member_1);
            phi_283_ = type_9(1u, _e118.member);
        } else {
            phi_260_ = _e118;
            phi_283_ = type_9(0u, type_9().member_1);
        }
        let _e130 = phi_260_;
        let _e132 = phi_283_;
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
                    phi_330_ = (_e154 + 1u);
                } else {
                    phi_330_ = _e154;
                }
                let _e160 = phi_330_;
                phi_331_ = _e160;
            } else {
                phi_331_ = 0u;
            }
            let _e162 = phi_331_;
            let _e165 = params.member.member_2.member_4;
            if (_e165 < _e162) {
                phi_339_ = _e165;
            } else {
                phi_339_ = _e162;
            }
            let _e168 = phi_339_;
            let _e169 = (_e141 < _e168);
            let _e172 = params.member.member_1.member_1;
            let _e175 = params.member.member_2.member_3;
            if _e169 {
                phi_353_ = (_e141 * _e175);
            } else {
                phi_353_ = 0u;
            }
            let _e178 = phi_353_;
            let _e180 = (2u * (_e172 + _e178));
            let _e183 = input.member[(4u + _e180)];
            let _e186 = input.member[(_e180 + 5u)];
            if (_e46 <= 7u) {
                atomicStore((&counters[_e46]), 0u);
            }
            workgroupBarrier();
            if (_e70 == 0u) {
                firsts[(2u * _e69)] = (_e183 * 32u);
                firsts[((2u * _e69) + 1u)] = (_e186 * 32u);
            }
            let _e199 = params.member.member_2.member_1;
            if (_e199 == 0u) {
                phi_410_ = array<u32, 2>(0u, 2u);
            } else {
                phi_410_ = array<u32, 2>(1u, 1u);
            }
            let _e202 = phi_410_;
            let _e205 = params.member.member_2.member_2;
            let _e206 = (_e205 - 1u);
            let _e209 = params.member.member.member;
            local = array<u32, 3>(_e209[0], _e209[1], _e209[2]);
            let _e217 = ((_e183 * 32u) + _e70);
            let _e219 = local[_e202[0]];
            phi_434_ = type_9(0u, _e206);
            phi_437_ = 1u;
            loop {
                let _e222 = phi_434_;
                let _e224 = phi_437_;
                local_1 = _e224;
                local_2 = _e224;
                local_3 = _e224;
                local_4 = _e224;
                if (_e222.member < _e222.member_1) {
                    phi_435_ = type_9((_e222.member + 1u), _e222.member_1);
                    phi_460_ = type_9(1u, _e222.member);
                } else {
                    phi_435_ = _e222;
                    phi_460_ = type_9(0u, type_9().member_1);
                }
                let _e236 = phi_435_;
                let _e238 = phi_460_;
                let _e241 = (bitcast<i32>(_e238.member) != 0i);
                if _e241 {
                    phi_438_ = (_e224 * 32u);
                } else {
                    phi_438_ = u32();
                }
                let _e244 = phi_438_;
                continue;
                continuing {
                    phi_434_ = _e236;
                    phi_437_ = _e244;
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
                phi_478_ = _e252;
            } else {
                phi_478_ = _e217;
            }
            let _e255 = phi_478_;
            let _e257 = local_3;
            let _e258 = (_e255 * _e257);
            let _e260 = local_4;
            let _e262 = (_e258 + (_e260 - 1u));
            let _e263 = (_e219 - 1u);
            if (_e263 < _e262) {
                phi_487_ = _e263;
            } else {
                phi_487_ = _e262;
            }
            let _e266 = phi_487_;
            let _e270 = params.member.member_2.member[0u][_e202[0]];
            let _e273 = worlds.member[(_e270 + _e258)];
            let _e278 = worlds.member[(_e270 + _e266)];
            let _e279 = ((_e273 << bitcast<u32>(16i)) | _e278);
            let _e281 = ((_e186 * 32u) + _e70);
            let _e283 = local[_e202[1]];
            phi_530_ = type_9(0u, _e206);
            phi_533_ = 1u;
            loop {
                let _e286 = phi_530_;
                let _e288 = phi_533_;
                local_5 = _e288;
                local_6 = _e288;
                local_7 = _e288;
                local_8 = _e288;
                if (_e286.member < _e286.member_1) {
                    phi_531_ = type_9((_e286.member + 1u), _e286.member_1);
                    phi_556_ = type_9(1u, _e286.member);
                } else {
                    phi_531_ = _e286;
                    phi_556_ = type_9(0u, type_9().member_1);
                }
                let _e300 = phi_531_;
                let _e302 = phi_556_;
                let _e305 = (bitcast<i32>(_e302.member) != 0i);
                if _e305 {
                    phi_534_ = (_e288 * 32u);
                } else {
                    phi_534_ = u32();
                }
                let _e308 = phi_534_;
                continue;
                continuing {
                    phi_530_ = _e300;
                    phi_533_ = _e308;
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
                phi_574_ = _e316;
            } else {
                phi_574_ = _e281;
            }
            let _e319 = phi_574_;
            let _e321 = local_7;
            let _e322 = (_e319 * _e321);
            let _e324 = local_8;
            let _e326 = (_e322 + (_e324 - 1u));
            let _e327 = (_e283 - 1u);
            if (_e327 < _e326) {
                phi_583_ = _e327;
            } else {
                phi_583_ = _e326;
            }
            let _e330 = phi_583_;
            let _e334 = params.member.member_2.member[0u][_e202[1]];
            let _e337 = worlds.member[(_e334 + _e322)];
            let _e342 = worlds.member[(_e334 + _e330)];
            ranges[_e46] = ((_e337 << bitcast<u32>(16i)) | _e342);
            let _e347 = params.member.member_2.member_1;
            if (_e347 == 0u) {
                phi_628_ = array<u32, 2>(0u, 2u);
            } else {
                phi_628_ = array<u32, 2>(1u, 1u);
            }
            let _e350 = phi_628_;
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
                phi_789_ = ((((((_e408.member.x <= _e384.member_1.y) && (_e384.member.x <= _e408.member_1.y)) && (_e408.member.y <= _e384.member_2.x)) && (_e384.member.y <= _e408.member_2.x)) && (_e408.member_1.x <= _e384.member_2.y)) && (_e384.member_1.x <= _e408.member_2.y));
            } else {
                phi_789_ = false;
            }
            let _e460 = phi_789_;
            if _e169 {
                if ((((((_e435.member.x <= _e363.member_1.y) && (_e363.member.x <= _e435.member_1.y)) && (_e435.member.y <= _e363.member_2.x)) && (_e363.member.y <= _e435.member_2.x)) && (_e435.member_1.x <= _e363.member_2.y)) && (_e363.member_1.x <= _e435.member_2.y)) {
                    let _e474 = atomicAdd((&counters[_e353]), 1u);
                    let _e475 = ((_e353 * 32u) + _e474);
                    columns[_e475] = type_24(array<f32, 3>(_e435.member.x, _e435.member.y, _e435.member_1.x), array<f32, 3>(_e435.member_1.y, _e435.member_2.x, _e435.member_2.y));
                    names[_e475] = _e354;
                }
            }
            if _e460 {
                phi_827_ = type_24(array<f32, 3>(_e408.member.x, _e408.member.y, _e408.member_1.x), array<f32, 3>(_e408.member_1.y, _e408.member_2.x, _e408.member_2.y));
            } else {
                phi_827_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e482 = phi_827_;
            workgroupBarrier();
            let _e485 = params.member.member_2.member_1;
            if (_e485 == 1u) {
                phi_836_ = (_e183 == _e186);
            } else {
                phi_836_ = false;
            }
            let _e489 = phi_836_;
            let _e490 = (_e46 / 32u);
            let _e491 = (_e46 % 32u);
            let _e492 = (_e490 * 32u);
            let _e494 = atomicLoad((&counters[_e490]));
            let _e495 = (_e494 / 4u);
            if ((_e494 % 4u) > 0u) {
                phi_859_ = (_e495 + 1u);
            } else {
                phi_859_ = _e495;
            }
            let _e500 = phi_859_;
            phi_862_ = type_9(0u, _e500);
            phi_865_ = 0u;
            loop {
                let _e503 = phi_862_;
                let _e505 = phi_865_;
                local_9 = _e505;
                local_13 = _e505;
                if (_e503.member < _e503.member_1) {
                    phi_863_ = type_9((_e503.member + 1u), _e503.member_1);
                    phi_888_ = type_9(1u, _e503.member);
                } else {
                    phi_863_ = _e503;
                    phi_888_ = type_9(0u, type_9().member_1);
                }
                let _e517 = phi_863_;
                let _e519 = phi_888_;
                let _e523 = (bitcast<i32>(_e519.member) != 0i);
                if _e523 {
                    let _e524 = (4u * _e519.member_1);
                    let _e527 = columns[(_e492 + _e524)];
                    let _e566 = columns[((_e492 + _e524) + 1u)];
                    let _e607 = columns[((_e492 + _e524) + 2u)];
                    let _e648 = columns[((_e492 + _e524) + 3u)];
                    phi_866_ = (_e505 | ((((select(0u, 1u, ((((((_e482.member[0] <= _e527.member_1[0]) && (_e527.member[0] <= _e482.member_1[0])) && (_e482.member[1] <= _e527.member_1[1])) && (_e527.member[1] <= _e482.member_1[1])) && (_e482.member[2] <= _e527.member_1[2])) && (_e527.member[2] <= _e482.member_1[2]))) << bitcast<u32>((_e524 & 31u))) | (select(0u, 1u, ((((((_e482.member[0] <= _e566.member_1[0]) && (_e566.member[0] <= _e482.member_1[0])) && (_e482.member[1] <= _e566.member_1[1])) && (_e566.member[1] <= _e482.member_1[1])) && (_e482.member[2] <= _e566.member_1[2])) && (_e566.member[2] <= _e482.member_1[2]))) << bitcast<u32>(((_e524 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e482.member[0] <= _e607.member_1[0]) && (_e607.member[0] <= _e482.member_1[0])) && (_e482.member[1] <= _e607.member_1[1])) && (_e607.member[1] <= _e482.member_1[1])) && (_e482.member[2] <= _e607.member_1[2])) && (_e607.member[2] <= _e482.member_1[2]))) << bitcast<u32>(((_e524 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e482.member[0] <= _e648.member_1[0]) && (_e648.member[0] <= _e482.member_1[0])) && (_e482.member[1] <= _e648.member_1[1])) && (_e648.member[1] <= _e482.member_1[1])) && (_e482.member[2] <= _e648.member_1[2])) && (_e648.member[2] <= _e482.member_1[2]))) << bitcast<u32>(((_e524 + 3u) & 31u)))));
                } else {
                    phi_866_ = u32();
                }
                let _e688 = phi_866_;
                continue;
                continuing {
                    phi_862_ = _e517;
                    phi_865_ = _e688;
                    break if !(_e523);
                }
            }
            if (_e494 < 32u) {
                let _e696 = local_9;
                phi_1077_ = (_e696 & ((1u << bitcast<u32>((_e494 & 31u))) - 1u));
            } else {
                let _e1078 = local_13;
                phi_1077_ = _e1078;
            }
            let _e699 = phi_1077_;
            let _e702 = params.member.member.member_1;
            if ((_e702 & 256u) != 0u) {
                if ((bitcast<u32>(_e482.member_1[0]) & 1u) == 1u) {
                    phi_1101_ = true;
                } else {
                    phi_1101_ = !((_e482.member[0] <= _e482.member_1[0]));
                }
                let _e717 = phi_1101_;
                if _e717 {
                    phi_1107_ = type_9(0u, _e494);
                    phi_1110_ = _e699;
                    loop {
                        let _e720 = phi_1107_;
                        let _e722 = phi_1110_;
                        local_14 = _e722;
                        if (_e720.member < _e720.member_1) {
                            phi_1108_ = type_9((_e720.member + 1u), _e720.member_1);
                            phi_1133_ = type_9(1u, _e720.member);
                        } else {
                            phi_1108_ = _e720;
                            phi_1133_ = type_9(0u, type_9().member_1);
                        }
                        let _e734 = phi_1108_;
                        let _e736 = phi_1133_;
                        let _e740 = (bitcast<i32>(_e736.member) != 0i);
                        if _e740 {
                            let _e743 = columns[(_e492 + _e736.member_1)];
                            if ((bitcast<u32>(_e743.member_1[0]) & 1u) == 1u) {
                                phi_1166_ = true;
                            } else {
                                phi_1166_ = !((_e743.member[0] <= _e743.member_1[0]));
                            }
                            let _e754 = phi_1166_;
                            if _e754 {
                                phi_1174_ = (_e722 & ~((1u << bitcast<u32>((_e736.member_1 & 31u)))));
                            } else {
                                phi_1174_ = _e722;
                            }
                            let _e761 = phi_1174_;
                            phi_1111_ = _e761;
                        } else {
                            phi_1111_ = u32();
                        }
                        let _e763 = phi_1111_;
                        continue;
                        continuing {
                            phi_1107_ = _e734;
                            phi_1110_ = _e763;
                            break if !(_e740);
                        }
                    }
                    let _e1089 = local_14;
                    phi_1175_ = _e1089;
                } else {
                    phi_1175_ = _e699;
                }
                let _e766 = phi_1175_;
                phi_1176_ = _e766;
            } else {
                phi_1176_ = _e699;
            }
            let _e768 = phi_1176_;
            phi_1180_ = type_9(0u, _e494);
            phi_1183_ = _e768;
            loop {
                let _e771 = phi_1180_;
                let _e773 = phi_1183_;
                local_10 = _e773;
                local_11 = _e773;
                local_12 = _e773;
                if (_e771.member < _e771.member_1) {
                    phi_1181_ = type_9((_e771.member + 1u), _e771.member_1);
                    phi_1206_ = type_9(1u, _e771.member);
                } else {
                    phi_1181_ = _e771;
                    phi_1206_ = type_9(0u, type_9().member_1);
                }
                let _e785 = phi_1181_;
                let _e787 = phi_1206_;
                let _e791 = (bitcast<i32>(_e787.member) != 0i);
                if _e791 {
                    let _e794 = names[(_e492 + _e787.member_1)];
                    let _e797 = ranges[(_e492 + _e794)];
                    if ((_e279 >> bitcast<u32>(16i)) <= (_e797 & 65535u)) {
                        phi_1229_ = ((_e797 >> bitcast<u32>(16i)) <= (_e279 & 65535u));
                    } else {
                        phi_1229_ = false;
                    }
                    let _e807 = phi_1229_;
                    if _e489 {
                        let _e808 = (_e491 < _e794);
                        if _e808 {
                            phi_1243_ = bool();
                        } else {
                            if (_e491 == _e794) {
                                phi_1242_ = true;
                            } else {
                                phi_1242_ = false;
                            }
                            let _e811 = phi_1242_;
                            phi_1243_ = _e811;
                        }
                        let _e813 = phi_1243_;
                        phi_1244_ = _e813;
                        phi_1245_ = _e808;
                    } else {
                        phi_1244_ = bool();
                        phi_1245_ = true;
                    }
                    let _e815 = phi_1244_;
                    let _e817 = phi_1245_;
                    if _e817 {
                        phi_1249_ = true;
                    } else {
                        phi_1249_ = _e815;
                    }
                    let _e819 = phi_1249_;
                    if _e819 {
                        if _e807 {
                            phi_1256_ = false;
                        } else {
                            phi_1256_ = true;
                        }
                        let _e821 = phi_1256_;
                        phi_1257_ = _e821;
                    } else {
                        phi_1257_ = true;
                    }
                    let _e823 = phi_1257_;
                    if _e823 {
                        phi_1265_ = (_e773 & ~((1u << bitcast<u32>((_e787.member_1 & 31u)))));
                    } else {
                        phi_1265_ = _e773;
                    }
                    let _e830 = phi_1265_;
                    phi_1184_ = _e830;
                } else {
                    phi_1184_ = u32();
                }
                let _e832 = phi_1184_;
                continue;
                continuing {
                    phi_1180_ = _e785;
                    phi_1183_ = _e832;
                    break if !(_e791);
                }
            }
            let _e835 = local_10;
            let _e838 = local_11;
            let _e839 = countOneBits(_e838);
            if (_e839 > 0u) {
                let _e842 = atomicAdd((&counters[4u]), _e839);
                let _e844 = local_12;
                phi_1275_ = type_9(_e844, _e842);
            } else {
                phi_1275_ = type_9(_e835, 0u);
            }
            let _e847 = phi_1275_;
            workgroupBarrier();
            if (_e46 == 0u) {
                let _e850 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e850;
            }
            let _e853 = workgroupUniformLoad((&n_hits[0u]));
            let _e854 = (_e853 / 512u);
            if ((_e853 % 512u) > 0u) {
                phi_1301_ = (_e854 + 1u);
            } else {
                phi_1301_ = _e854;
            }
            let _e859 = phi_1301_;
            phi_1304_ = type_9(0u, _e859);
            phi_1307_ = _e847;
            loop {
                let _e862 = phi_1304_;
                let _e864 = phi_1307_;
                if (_e862.member < _e862.member_1) {
                    phi_1305_ = type_9((_e862.member + 1u), _e862.member_1);
                    phi_1330_ = type_9(1u, _e862.member);
                } else {
                    phi_1305_ = _e862;
                    phi_1330_ = type_9(0u, type_9().member_1);
                }
                let _e876 = phi_1305_;
                let _e878 = phi_1330_;
                let _e882 = (bitcast<i32>(_e878.member) != 0i);
                if _e882 {
                    let _e883 = (_e46 / 32u);
                    let _e885 = (_e878.member_1 * 512u);
                    phi_1347_ = _e864;
                    phi_1350_ = type_9(0u, countOneBits(_e864.member));
                    loop {
                        let _e890 = phi_1347_;
                        let _e892 = phi_1350_;
                        local_15 = _e890;
                        if (_e892.member < _e892.member_1) {
                            phi_1351_ = type_9((_e892.member + 1u), _e892.member_1);
                            phi_1373_ = type_9(1u, _e892.member);
                        } else {
                            phi_1351_ = _e892;
                            phi_1373_ = type_9(0u, type_9().member_1);
                        }
                        let _e904 = phi_1351_;
                        let _e906 = phi_1373_;
                        if (bitcast<i32>(_e906.member) != 0i) {
                            let _e911 = (_e890.member_1 - _e885);
                            if (_e911 >= 512u) {
                                phi_1407_ = type_9();
                                phi_1408_ = false;
                            } else {
                                let _e920 = names[((_e883 * 32u) + select(firstTrailingBit(_e890.member), 32u, (_e890.member == 0u)))];
                                hits[_e911] = (((_e883 << bitcast<u32>(10i)) | ((_e46 % 32u) << bitcast<u32>(5i))) | _e920);
                                phi_1407_ = type_9((_e890.member & (_e890.member - 1u)), (_e890.member_1 + 1u));
                                phi_1408_ = true;
                            }
                            let _e936 = phi_1407_;
                            let _e938 = phi_1408_;
                            phi_1348_ = _e936;
                            phi_1409_ = _e938;
                        } else {
                            phi_1348_ = type_9();
                            phi_1409_ = false;
                        }
                        let _e940 = phi_1348_;
                        let _e942 = phi_1409_;
                        continue;
                        continuing {
                            phi_1347_ = _e940;
                            phi_1350_ = _e904;
                            break if !(_e942);
                        }
                    }
                    workgroupBarrier();
                    let _e945 = n_hits[0u];
                    let _e946 = (_e945 - _e885);
                    if (512u < _e946) {
                        phi_1417_ = 512u;
                    } else {
                        phi_1417_ = _e946;
                    }
                    let _e949 = phi_1417_;
                    if (_e46 == 0u) {
                        atomicStore((&counters[7u]), _e949);
                    }
                    workgroupBarrier();
                    if (_e46 == 0u) {
                        let _e954 = atomicLoad((&counters[7u]));
                        if (_e954 > 0u) {
                            let _e957 = atomicAdd((&output.member[0u]), _e954);
                            if ((_e957 + _e954) < _e957) {
                                let _e961 = atomicAdd((&output.member[2u]), 1u);
                            }
                            atomicStore((&counters[8u]), _e957);
                        }
                        atomicStore((&counters[5u]), 0u);
                        atomicStore((&counters[6u]), 0u);
                        atomicStore((&counters[7u]), 0u);
                    }
                    workgroupBarrier();
                    let _e967 = atomicLoad((&counters[8u]));
                    phi_1454_ = type_9(0u, 4u);
                    loop {
                        let _e969 = phi_1454_;
                        if (_e969.member < _e969.member_1) {
                            phi_1455_ = type_9((_e969.member + 1u), _e969.member_1);
                            phi_1478_ = type_9(1u, _e969.member);
                        } else {
                            phi_1455_ = _e969;
                            phi_1478_ = type_9(0u, type_9().member_1);
                        }
                        let _e981 = phi_1455_;
                        let _e983 = phi_1478_;
                        if (bitcast<i32>(_e983.member) != 0i) {
                            let _e989 = (_e46 + (_e983.member_1 * 128u));
                            if (_e989 >= _e949) {
                                phi_1523_ = false;
                            } else {
                                let _e992 = hits[_e989];
                                let _e995 = ((_e992 >> bitcast<u32>(10i)) & 3u);
                                let _e1002 = firsts[(2u * _e995)];
                                let _e1007 = firsts[((2u * _e995) + 1u)];
                                let _e1011 = params.member.member_1.member_3;
                                let _e1012 = (_e967 + _e989);
                                if (_e1012 < _e1011) {
                                    let _e1014 = (2u * _e1012);
                                    atomicStore((&output.member[(4u + _e1014)]), (_e1002 + ((_e992 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e1014 + 5u)]), (_e1007 + (_e992 & 31u)));
                                }
                                phi_1523_ = true;
                            }
                            let _e1020 = phi_1523_;
                            phi_1524_ = _e1020;
                        } else {
                            phi_1524_ = false;
                        }
                        let _e1022 = phi_1524_;
                        continue;
                        continuing {
                            phi_1454_ = _e981;
                            break if !(_e1022);
                        }
                    }
                    workgroupBarrier();
                    let _e1130 = local_15;
                    phi_1308_ = _e1130;
                } else {
                    phi_1308_ = type_9();
                }
                let _e1025 = phi_1308_;
                continue;
                continuing {
                    phi_1304_ = _e876;
                    phi_1307_ = _e1025;
                    break if !(_e882);
                }
            }
        }
        continue;
        continuing {
            phi_259_ = _e130;
            break if !(_e136);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
