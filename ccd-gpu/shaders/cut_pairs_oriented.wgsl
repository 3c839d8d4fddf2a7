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

struct type_13 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_16 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
    member_9: u32,
    member_10: u32,
    member_11: u32,
    member_12: u32,
    member_13: u32,
    member_14: u32,
    member_15: u32,
    member_16: u32,
    member_17: u32,
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
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_22 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> a_nodes: type_15;
@group(0) @binding(2) 
var<storage> b_nodes: type_15;
@group(0) @binding(3) 
var<storage> cuts: type_10;
@group(0) @binding(4) 
var<storage> oriented: type_24;
@group(0) @binding(5) 
var<storage, read_write> control: type_28;
@group(0) @binding(6) 
var<storage, read_write> output: type_28;
@group(0) @binding(7) 
var<storage, read_write> front: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_20;
    var phi_136_: u32;
    var phi_173_: bool;
    var phi_202_: array<u32, 2>;
    var phi_203_: array<u32, 2>;
    var phi_204_: array<u32, 2>;
    var phi_242_: bool;
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_301_: array<u32, 2>;
    var phi_329_: array<u32, 2>;
    var phi_354_: bool;
    var phi_366_: bool;
    var phi_367_: bool;
    var phi_440_: f32;
    var phi_446_: f32;
    var phi_452_: f32;
    var phi_458_: f32;
    var phi_464_: f32;
    var phi_470_: f32;
    var phi_488_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_514_: type_25;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_596_: f32;
    var phi_602_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_632_: f32;
    var phi_637_: f32;
    var phi_642_: f32;
    var phi_658_: type_25;
    var phi_848_: f32;
    var phi_854_: f32;
    var phi_861_: f32;
    var phi_870_: f32;
    var phi_877_: f32;
    var phi_885_: f32;
    var phi_894_: f32;
    var phi_901_: f32;
    var phi_909_: f32;
    var phi_1002_: f32;
    var phi_1009_: f32;
    var phi_1015_: f32;
    var phi_1021_: f32;
    var phi_1040_: f32;
    var phi_1047_: f32;
    var phi_1053_: f32;
    var phi_1059_: f32;
    var phi_1078_: f32;
    var phi_1085_: f32;
    var phi_1091_: f32;
    var phi_1097_: f32;
    var phi_1116_: f32;
    var phi_1123_: f32;
    var phi_1129_: f32;
    var phi_1135_: f32;
    var phi_1154_: f32;
    var phi_1161_: f32;
    var phi_1167_: f32;
    var phi_1173_: f32;
    var phi_1192_: f32;
    var phi_1199_: f32;
    var phi_1205_: f32;
    var phi_1211_: f32;
    var phi_1226_: f32;
    var phi_1231_: f32;
    var phi_1236_: f32;
    var phi_1241_: f32;
    var phi_1246_: f32;
    var phi_1305_: f32;
    var phi_1328_: f32;
    var phi_1351_: f32;
    var phi_1373_: f32;
    var phi_1389_: f32;
    var phi_1444_: f32;
    var phi_1467_: f32;
    var phi_1490_: f32;
    var phi_1512_: f32;
    var phi_1528_: f32;
    var phi_1583_: f32;
    var phi_1606_: f32;
    var phi_1629_: f32;
    var phi_1651_: f32;
    var phi_1667_: f32;
    var phi_1722_: f32;
    var phi_1745_: f32;
    var phi_1769_: f32;
    var phi_1792_: f32;
    var phi_1808_: f32;
    var phi_1863_: f32;
    var phi_1886_: f32;
    var phi_1910_: f32;
    var phi_1933_: f32;
    var phi_1949_: f32;
    var phi_2004_: f32;
    var phi_2027_: f32;
    var phi_2051_: f32;
    var phi_2074_: f32;
    var phi_2090_: f32;
    var phi_2145_: f32;
    var phi_2168_: f32;
    var phi_2192_: f32;
    var phi_2215_: f32;
    var phi_2231_: f32;
    var phi_2286_: f32;
    var phi_2309_: f32;
    var phi_2333_: f32;
    var phi_2356_: f32;
    var phi_2372_: f32;
    var phi_2427_: f32;
    var phi_2450_: f32;
    var phi_2474_: f32;
    var phi_2497_: f32;
    var phi_2513_: f32;
    var phi_2520_: f32;
    var phi_2525_: f32;
    var phi_2530_: f32;
    var phi_2535_: f32;
    var phi_2540_: f32;
    var phi_2545_: f32;
    var phi_2550_: f32;
    var phi_2555_: f32;
    var phi_2559_: bool;
    var phi_2561_: bool;
    var phi_2562_: bool;
    var phi_2563_: bool;
    var phi_2564_: bool;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e38 = id_2;
    let _e39 = n_2;
    let _e40 = lane_2;
    let _e55 = ((((_e38.y * _e39.x) + _e38.x) * 256u) + _e40);
    let _e58 = params.member.member_2.member_2;
    if (_e58 == 0u) {
        return;
    }
    let _e60 = (_e55 / _e58);
    let _e62 = params.member.member_2.member_2;
    if (_e62 == 0u) {
        return;
    }
    let _e64 = (_e55 % _e62);
    let _e66 = params.member.member_2.member;
    let _e67 = (_e66 == 1u);
    if _e67 {
        phi_136_ = 0u;
    } else {
        phi_136_ = 1u;
    }
    let _e69 = phi_136_;
    let _e70 = (_e69 * 1028u);
    let _e72 = cuts.member[0u];
    if (_e60 < _e72) {
        let _e75 = cuts.member[_e70];
        if (_e64 < _e75) {
            if _e67 {
                phi_173_ = (_e60 <= _e64);
            } else {
                phi_173_ = true;
            }
            let _e79 = phi_173_;
            if _e79 {
                let _e82 = cuts.member[(4u + _e60)];
                let _e86 = cuts.member[((_e70 + 4u) + _e64)];
                phi_202_ = array<u32, 2>(_e82, _e86);
            } else {
                phi_202_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e89 = phi_202_;
            phi_203_ = _e89;
        } else {
            phi_203_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e91 = phi_203_;
        phi_204_ = _e91;
    } else {
        phi_204_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e93 = phi_204_;
    if (_e93[0] != 4294967295u) {
        let _e98 = a_nodes.member[_e93[0]];
        let _e101 = b_nodes.member[_e93[1]];
        let _e104 = params.member.member_2.member;
        if (_e104 == 1u) {
            phi_242_ = (_e93[0] == _e93[1]);
        } else {
            phi_242_ = false;
        }
        let _e110 = phi_242_;
        if _e110 {
            if (_e98.member_3 == 4294967295u) {
                phi_251_ = false;
            } else {
                phi_251_ = true;
            }
            let _e114 = phi_251_;
            phi_252_ = _e114;
        } else {
            phi_252_ = true;
        }
        let _e116 = phi_252_;
        if _e116 {
            if ((((((_e98.member[0] <= _e101.member_2[0]) && (_e101.member[0] <= _e98.member_2[0])) && (_e98.member[1] <= _e101.member_2[1])) && (_e101.member[1] <= _e98.member_2[1])) && (_e98.member[2] <= _e101.member_2[2])) && (_e101.member[2] <= _e98.member_2[2])) {
                let _e146 = params.member.member_2.member;
                let _e150 = params.member.member_2.member;
                if (_e150 == 0u) {
                    phi_301_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_301_ = array<u32, 2>(1u, 1u);
                }
                let _e153 = phi_301_;
                let _e159 = params.member.member.member[_e153[0]];
                let _e160 = (_e159 - 1u);
                let _e164 = params.member.member.member[_e153[1]];
                let _e165 = (_e164 - 1u);
                let _e168 = params.member.member_2.member;
                if (_e168 == 0u) {
                    phi_329_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_329_ = array<u32, 2>(1u, 1u);
                }
                let _e171 = phi_329_;
                let _e177 = params.member.member.member_2[_e171[0]];
                let _e181 = params.member.member.member_2[_e171[1]];
                if (_e146 == 1u) {
                    phi_354_ = (_e93[0] == _e93[1]);
                } else {
                    phi_354_ = false;
                }
                let _e186 = phi_354_;
                if _e186 {
                    phi_2563_ = bool();
                    phi_2564_ = true;
                } else {
                    if (_e93[0] >= _e160) {
                        if (_e93[1] >= _e165) {
                            phi_366_ = false;
                        } else {
                            phi_366_ = true;
                        }
                        let _e190 = phi_366_;
                        phi_367_ = _e190;
                    } else {
                        phi_367_ = true;
                    }
                    let _e192 = phi_367_;
                    if _e192 {
                        if (_e93[0] < _e160) {
                            let _e272 = oriented.member[(_e177 + _e93[0])];
                            phi_514_ = type_25(array<f32, 3>(_e272.member.x, _e272.member.y, _e272.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e272.member.w, _e272.member_1.x, _e272.member_1.y), array<f32, 3>(_e272.member_1.z, _e272.member_1.w, _e272.member_2.x), array<f32, 3>(_e272.member_2.y, _e272.member_2.z, _e272.member_2.w)), array<f32, 3>(_e272.member_3.x, _e272.member_3.y, _e272.member_3.z));
                        } else {
                            let _e195 = a_nodes.member[_e93[0]];
                            let _e210 = ((_e195.member[0] * 0.5f) + (_e195.member_2[0] * 0.5f));
                            let _e211 = ((_e195.member[1] * 0.5f) + (_e195.member_2[1] * 0.5f));
                            let _e212 = ((_e195.member[2] * 0.5f) + (_e195.member_2[2] * 0.5f));
                            if (_e210 < _e195.member_2[0]) {
                                phi_440_ = _e210;
                            } else {
                                phi_440_ = _e195.member_2[0];
                            }
                            let _e216 = phi_440_;
                            if (_e211 < _e195.member_2[1]) {
                                phi_446_ = _e211;
                            } else {
                                phi_446_ = _e195.member_2[1];
                            }
                            let _e220 = phi_446_;
                            if (_e212 < _e195.member_2[2]) {
                                phi_452_ = _e212;
                            } else {
                                phi_452_ = _e195.member_2[2];
                            }
                            let _e224 = phi_452_;
                            if (_e216 > _e195.member[0]) {
                                phi_458_ = _e216;
                            } else {
                                phi_458_ = _e195.member[0];
                            }
                            let _e228 = phi_458_;
                            if (_e220 > _e195.member[1]) {
                                phi_464_ = _e220;
                            } else {
                                phi_464_ = _e195.member[1];
                            }
                            let _e232 = phi_464_;
                            if (_e224 > _e195.member[2]) {
                                phi_470_ = _e224;
                            } else {
                                phi_470_ = _e195.member[2];
                            }
                            let _e236 = phi_470_;
                            let _e239 = (_e195.member_2[0] - _e228);
                            let _e241 = (_e195.member_2[1] - _e232);
                            let _e243 = (_e195.member_2[2] - _e236);
                            let _e245 = (_e228 - _e195.member[0]);
                            let _e247 = (_e232 - _e195.member[1]);
                            let _e249 = (_e236 - _e195.member[2]);
                            if (_e239 > _e245) {
                                phi_488_ = _e239;
                            } else {
                                phi_488_ = _e245;
                            }
                            let _e252 = phi_488_;
                            if (_e241 > _e247) {
                                phi_493_ = _e241;
                            } else {
                                phi_493_ = _e247;
                            }
                            let _e255 = phi_493_;
                            if (_e243 > _e249) {
                                phi_498_ = _e243;
                            } else {
                                phi_498_ = _e249;
                            }
                            let _e258 = phi_498_;
                            let _e260 = (1f + (0.000000059604645f * 4f));
                            let _e264 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_514_ = type_25(array<f32, 3>(_e228, _e232, _e236), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e252 * _e260) + _e264), ((_e255 * _e260) + _e264), ((_e258 * _e260) + _e264)));
                        }
                        let _e311 = phi_514_;
                        if (_e93[1] < _e165) {
                            let _e391 = oriented.member[(_e181 + _e93[1])];
                            phi_658_ = type_25(array<f32, 3>(_e391.member.x, _e391.member.y, _e391.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e391.member.w, _e391.member_1.x, _e391.member_1.y), array<f32, 3>(_e391.member_1.z, _e391.member_1.w, _e391.member_2.x), array<f32, 3>(_e391.member_2.y, _e391.member_2.z, _e391.member_2.w)), array<f32, 3>(_e391.member_3.x, _e391.member_3.y, _e391.member_3.z));
                        } else {
                            let _e314 = b_nodes.member[_e93[1]];
                            let _e329 = ((_e314.member[0] * 0.5f) + (_e314.member_2[0] * 0.5f));
                            let _e330 = ((_e314.member[1] * 0.5f) + (_e314.member_2[1] * 0.5f));
                            let _e331 = ((_e314.member[2] * 0.5f) + (_e314.member_2[2] * 0.5f));
                            if (_e329 < _e314.member_2[0]) {
                                phi_584_ = _e329;
                            } else {
                                phi_584_ = _e314.member_2[0];
                            }
                            let _e335 = phi_584_;
                            if (_e330 < _e314.member_2[1]) {
                                phi_590_ = _e330;
                            } else {
                                phi_590_ = _e314.member_2[1];
                            }
                            let _e339 = phi_590_;
                            if (_e331 < _e314.member_2[2]) {
                                phi_596_ = _e331;
                            } else {
                                phi_596_ = _e314.member_2[2];
                            }
                            let _e343 = phi_596_;
                            if (_e335 > _e314.member[0]) {
                                phi_602_ = _e335;
                            } else {
                                phi_602_ = _e314.member[0];
                            }
                            let _e347 = phi_602_;
                            if (_e339 > _e314.member[1]) {
                                phi_608_ = _e339;
                            } else {
                                phi_608_ = _e314.member[1];
                            }
                            let _e351 = phi_608_;
                            if (_e343 > _e314.member[2]) {
                                phi_614_ = _e343;
                            } else {
                                phi_614_ = _e314.member[2];
                            }
                            let _e355 = phi_614_;
                            let _e358 = (_e314.member_2[0] - _e347);
                            let _e360 = (_e314.member_2[1] - _e351);
                            let _e362 = (_e314.member_2[2] - _e355);
                            let _e364 = (_e347 - _e314.member[0]);
                            let _e366 = (_e351 - _e314.member[1]);
                            let _e368 = (_e355 - _e314.member[2]);
                            if (_e358 > _e364) {
                                phi_632_ = _e358;
                            } else {
                                phi_632_ = _e364;
                            }
                            let _e371 = phi_632_;
                            if (_e360 > _e366) {
                                phi_637_ = _e360;
                            } else {
                                phi_637_ = _e366;
                            }
                            let _e374 = phi_637_;
                            if (_e362 > _e368) {
                                phi_642_ = _e362;
                            } else {
                                phi_642_ = _e368;
                            }
                            let _e377 = phi_642_;
                            let _e379 = (1f + (0.000000059604645f * 4f));
                            let _e383 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_658_ = type_25(array<f32, 3>(_e347, _e351, _e355), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e371 * _e379) + _e383), ((_e374 * _e379) + _e383), ((_e377 * _e379) + _e383)));
                        }
                        let _e430 = phi_658_;
                        let _e435 = (_e430.member[0] - _e311.member[0]);
                        let _e438 = (_e430.member[1] - _e311.member[1]);
                        let _e441 = (_e430.member[2] - _e311.member[2]);
                        if (_e435 < 0f) {
                            phi_848_ = -(_e435);
                        } else {
                            phi_848_ = _e435;
                        }
                        let _e630 = phi_848_;
                        if (_e438 < 0f) {
                            phi_854_ = -(_e438);
                        } else {
                            phi_854_ = _e438;
                        }
                        let _e634 = phi_854_;
                        if (_e441 < 0f) {
                            phi_861_ = -(_e441);
                        } else {
                            phi_861_ = _e441;
                        }
                        let _e639 = phi_861_;
                        if (_e311.member_2[0] < 0f) {
                            phi_870_ = -(_e311.member_2[0]);
                        } else {
                            phi_870_ = _e311.member_2[0];
                        }
                        let _e646 = phi_870_;
                        if (_e311.member_2[1] < 0f) {
                            phi_877_ = -(_e311.member_2[1]);
                        } else {
                            phi_877_ = _e311.member_2[1];
                        }
                        let _e651 = phi_877_;
                        if (_e311.member_2[2] < 0f) {
                            phi_885_ = -(_e311.member_2[2]);
                        } else {
                            phi_885_ = _e311.member_2[2];
                        }
                        let _e657 = phi_885_;
                        if (_e430.member_2[0] < 0f) {
                            phi_894_ = -(_e430.member_2[0]);
                        } else {
                            phi_894_ = _e430.member_2[0];
                        }
                        let _e664 = phi_894_;
                        if (_e430.member_2[1] < 0f) {
                            phi_901_ = -(_e430.member_2[1]);
                        } else {
                            phi_901_ = _e430.member_2[1];
                        }
                        let _e669 = phi_901_;
                        if (_e430.member_2[2] < 0f) {
                            phi_909_ = -(_e430.member_2[2]);
                        } else {
                            phi_909_ = _e430.member_2[2];
                        }
                        let _e675 = phi_909_;
                        local = type_20(array<array<f32, 3>, 3>(array<f32, 3>((((_e430.member_1[0][0] * _e311.member_1[0][0]) + (_e430.member_1[0][1] * _e311.member_1[0][1])) + (_e430.member_1[0][2] * _e311.member_1[0][2])), (((_e430.member_1[1][0] * _e311.member_1[0][0]) + (_e430.member_1[1][1] * _e311.member_1[0][1])) + (_e430.member_1[1][2] * _e311.member_1[0][2])), (((_e430.member_1[2][0] * _e311.member_1[0][0]) + (_e430.member_1[2][1] * _e311.member_1[0][1])) + (_e430.member_1[2][2] * _e311.member_1[0][2]))), array<f32, 3>((((_e430.member_1[0][0] * _e311.member_1[1][0]) + (_e430.member_1[0][1] * _e311.member_1[1][1])) + (_e430.member_1[0][2] * _e311.member_1[1][2])), (((_e430.member_1[1][0] * _e311.member_1[1][0]) + (_e430.member_1[1][1] * _e311.member_1[1][1])) + (_e430.member_1[1][2] * _e311.member_1[1][2])), (((_e430.member_1[2][0] * _e311.member_1[1][0]) + (_e430.member_1[2][1] * _e311.member_1[1][1])) + (_e430.member_1[2][2] * _e311.member_1[1][2]))), array<f32, 3>((((_e430.member_1[0][0] * _e311.member_1[2][0]) + (_e430.member_1[0][1] * _e311.member_1[2][1])) + (_e430.member_1[0][2] * _e311.member_1[2][2])), (((_e430.member_1[1][0] * _e311.member_1[2][0]) + (_e430.member_1[1][1] * _e311.member_1[2][1])) + (_e430.member_1[1][2] * _e311.member_1[2][2])), (((_e430.member_1[2][0] * _e311.member_1[2][0]) + (_e430.member_1[2][1] * _e311.member_1[2][1])) + (_e430.member_1[2][2] * _e311.member_1[2][2])))), array<f32, 3>((((_e311.member_1[0][0] * _e435) + (_e311.member_1[0][1] * _e438)) + (_e311.member_1[0][2] * _e441)), (((_e311.member_1[1][0] * _e435) + (_e311.member_1[1][1] * _e438)) + (_e311.member_1[1][2] * _e441)), (((_e311.member_1[2][0] * _e435) + (_e311.member_1[2][1] * _e438)) + (_e311.member_1[2][2] * _e441))), array<f32, 3>((((_e430.member_1[0][0] * _e435) + (_e430.member_1[0][1] * _e438)) + (_e430.member_1[0][2] * _e441)), (((_e430.member_1[1][0] * _e435) + (_e430.member_1[1][1] * _e438)) + (_e430.member_1[1][2] * _e441)), (((_e430.member_1[2][0] * _e435) + (_e430.member_1[2][1] * _e438)) + (_e430.member_1[2][2] * _e441))), array<f32, 3>(_e311.member_2[0], _e311.member_2[1], _e311.member_2[2]), array<f32, 3>(_e430.member_2[0], _e430.member_2[1], _e430.member_2[2]), ((((((_e630 + _e634) + _e639) + (((_e646 + _e651) + _e657) + ((_e664 + _e669) + _e675))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                        let _e702 = local.member[0u][0u];
                        let _e706 = local.member[0u][1u];
                        let _e710 = local.member[0u][2u];
                        let _e714 = local.member[1u][0u];
                        let _e718 = local.member[1u][1u];
                        let _e722 = local.member[1u][2u];
                        let _e726 = local.member[2u][0u];
                        let _e730 = local.member[2u][1u];
                        let _e734 = local.member[2u][2u];
                        let _e736 = local.member_3;
                        let _e741 = local.member_4;
                        let _e747 = local.member_1[0u];
                        if (_e747 < 0f) {
                            phi_1002_ = -(_e747);
                        } else {
                            phi_1002_ = _e747;
                        }
                        let _e751 = phi_1002_;
                        if (_e702 < 0f) {
                            phi_1009_ = -(_e702);
                        } else {
                            phi_1009_ = _e702;
                        }
                        let _e755 = phi_1009_;
                        if (_e706 < 0f) {
                            phi_1015_ = -(_e706);
                        } else {
                            phi_1015_ = _e706;
                        }
                        let _e759 = phi_1015_;
                        if (_e710 < 0f) {
                            phi_1021_ = -(_e710);
                        } else {
                            phi_1021_ = _e710;
                        }
                        let _e763 = phi_1021_;
                        let _e770 = (_e751 - (_e736[0] + (((_e755 * _e741[0]) + (_e759 * _e741[1])) + (_e763 * _e741[2]))));
                        let _e773 = local.member_1[1u];
                        if (_e773 < 0f) {
                            phi_1040_ = -(_e773);
                        } else {
                            phi_1040_ = _e773;
                        }
                        let _e777 = phi_1040_;
                        if (_e714 < 0f) {
                            phi_1047_ = -(_e714);
                        } else {
                            phi_1047_ = _e714;
                        }
                        let _e781 = phi_1047_;
                        if (_e718 < 0f) {
                            phi_1053_ = -(_e718);
                        } else {
                            phi_1053_ = _e718;
                        }
                        let _e785 = phi_1053_;
                        if (_e722 < 0f) {
                            phi_1059_ = -(_e722);
                        } else {
                            phi_1059_ = _e722;
                        }
                        let _e789 = phi_1059_;
                        let _e796 = (_e777 - (_e736[1] + (((_e781 * _e741[0]) + (_e785 * _e741[1])) + (_e789 * _e741[2]))));
                        let _e799 = local.member_1[2u];
                        if (_e799 < 0f) {
                            phi_1078_ = -(_e799);
                        } else {
                            phi_1078_ = _e799;
                        }
                        let _e803 = phi_1078_;
                        if (_e726 < 0f) {
                            phi_1085_ = -(_e726);
                        } else {
                            phi_1085_ = _e726;
                        }
                        let _e807 = phi_1085_;
                        if (_e730 < 0f) {
                            phi_1091_ = -(_e730);
                        } else {
                            phi_1091_ = _e730;
                        }
                        let _e811 = phi_1091_;
                        if (_e734 < 0f) {
                            phi_1097_ = -(_e734);
                        } else {
                            phi_1097_ = _e734;
                        }
                        let _e815 = phi_1097_;
                        let _e822 = (_e803 - (_e736[2] + (((_e807 * _e741[0]) + (_e811 * _e741[1])) + (_e815 * _e741[2]))));
                        let _e825 = local.member_2[0u];
                        if (_e825 < 0f) {
                            phi_1116_ = -(_e825);
                        } else {
                            phi_1116_ = _e825;
                        }
                        let _e829 = phi_1116_;
                        if (_e702 < 0f) {
                            phi_1123_ = -(_e702);
                        } else {
                            phi_1123_ = _e702;
                        }
                        let _e833 = phi_1123_;
                        if (_e714 < 0f) {
                            phi_1129_ = -(_e714);
                        } else {
                            phi_1129_ = _e714;
                        }
                        let _e837 = phi_1129_;
                        if (_e726 < 0f) {
                            phi_1135_ = -(_e726);
                        } else {
                            phi_1135_ = _e726;
                        }
                        let _e841 = phi_1135_;
                        let _e848 = (_e829 - (_e741[0] + (((_e833 * _e736[0]) + (_e837 * _e736[1])) + (_e841 * _e736[2]))));
                        let _e851 = local.member_2[1u];
                        if (_e851 < 0f) {
                            phi_1154_ = -(_e851);
                        } else {
                            phi_1154_ = _e851;
                        }
                        let _e855 = phi_1154_;
                        if (_e706 < 0f) {
                            phi_1161_ = -(_e706);
                        } else {
                            phi_1161_ = _e706;
                        }
                        let _e859 = phi_1161_;
                        if (_e718 < 0f) {
                            phi_1167_ = -(_e718);
                        } else {
                            phi_1167_ = _e718;
                        }
                        let _e863 = phi_1167_;
                        if (_e730 < 0f) {
                            phi_1173_ = -(_e730);
                        } else {
                            phi_1173_ = _e730;
                        }
                        let _e867 = phi_1173_;
                        let _e874 = (_e855 - (_e741[1] + (((_e859 * _e736[0]) + (_e863 * _e736[1])) + (_e867 * _e736[2]))));
                        let _e877 = local.member_2[2u];
                        if (_e877 < 0f) {
                            phi_1192_ = -(_e877);
                        } else {
                            phi_1192_ = _e877;
                        }
                        let _e881 = phi_1192_;
                        if (_e710 < 0f) {
                            phi_1199_ = -(_e710);
                        } else {
                            phi_1199_ = _e710;
                        }
                        let _e885 = phi_1199_;
                        if (_e722 < 0f) {
                            phi_1205_ = -(_e722);
                        } else {
                            phi_1205_ = _e722;
                        }
                        let _e889 = phi_1205_;
                        if (_e734 < 0f) {
                            phi_1211_ = -(_e734);
                        } else {
                            phi_1211_ = _e734;
                        }
                        let _e893 = phi_1211_;
                        let _e900 = (_e881 - (_e741[2] + (((_e885 * _e736[0]) + (_e889 * _e736[1])) + (_e893 * _e736[2]))));
                        if (_e770 > _e796) {
                            phi_1226_ = _e770;
                        } else {
                            phi_1226_ = _e796;
                        }
                        let _e903 = phi_1226_;
                        if (_e903 > _e822) {
                            phi_1231_ = _e903;
                        } else {
                            phi_1231_ = _e822;
                        }
                        let _e906 = phi_1231_;
                        if (_e848 > _e874) {
                            phi_1236_ = _e848;
                        } else {
                            phi_1236_ = _e874;
                        }
                        let _e909 = phi_1236_;
                        if (_e909 > _e900) {
                            phi_1241_ = _e909;
                        } else {
                            phi_1241_ = _e900;
                        }
                        let _e912 = phi_1241_;
                        if (_e906 > _e912) {
                            phi_1246_ = _e906;
                        } else {
                            phi_1246_ = _e912;
                        }
                        let _e915 = phi_1246_;
                        let _e917 = local.member_5;
                        if (_e915 > _e917) {
                            phi_2559_ = true;
                        } else {
                            let _e922 = local.member[1u][0u];
                            let _e925 = local.member_1[2u];
                            let _e930 = local.member[2u][0u];
                            let _e933 = local.member_1[1u];
                            let _e935 = ((_e922 * _e925) - (_e930 * _e933));
                            let _e939 = local.member[2u][0u];
                            if (_e939 < 0f) {
                                phi_1305_ = -(_e939);
                            } else {
                                phi_1305_ = _e939;
                            }
                            let _e943 = phi_1305_;
                            let _e946 = local.member_3[1u];
                            let _e951 = local.member[1u][0u];
                            if (_e951 < 0f) {
                                phi_1328_ = -(_e951);
                            } else {
                                phi_1328_ = _e951;
                            }
                            let _e955 = phi_1328_;
                            let _e958 = local.member_3[2u];
                            let _e964 = local.member[0u][2u];
                            if (_e964 < 0f) {
                                phi_1351_ = -(_e964);
                            } else {
                                phi_1351_ = _e964;
                            }
                            let _e968 = phi_1351_;
                            let _e971 = local.member_4[1u];
                            let _e976 = local.member[0u][1u];
                            if (_e976 < 0f) {
                                phi_1373_ = -(_e976);
                            } else {
                                phi_1373_ = _e976;
                            }
                            let _e980 = phi_1373_;
                            let _e983 = local.member_4[2u];
                            if (_e935 < 0f) {
                                phi_1389_ = -(_e935);
                            } else {
                                phi_1389_ = _e935;
                            }
                            let _e989 = phi_1389_;
                            let _e991 = (_e989 - (((_e943 * _e946) + (_e955 * _e958)) + ((_e968 * _e971) + (_e980 * _e983))));
                            let _e995 = local.member[1u][1u];
                            let _e998 = local.member_1[2u];
                            let _e1003 = local.member[2u][1u];
                            let _e1006 = local.member_1[1u];
                            let _e1008 = ((_e995 * _e998) - (_e1003 * _e1006));
                            let _e1012 = local.member[2u][1u];
                            if (_e1012 < 0f) {
                                phi_1444_ = -(_e1012);
                            } else {
                                phi_1444_ = _e1012;
                            }
                            let _e1016 = phi_1444_;
                            let _e1019 = local.member_3[1u];
                            let _e1024 = local.member[1u][1u];
                            if (_e1024 < 0f) {
                                phi_1467_ = -(_e1024);
                            } else {
                                phi_1467_ = _e1024;
                            }
                            let _e1028 = phi_1467_;
                            let _e1031 = local.member_3[2u];
                            let _e1037 = local.member[0u][0u];
                            if (_e1037 < 0f) {
                                phi_1490_ = -(_e1037);
                            } else {
                                phi_1490_ = _e1037;
                            }
                            let _e1041 = phi_1490_;
                            let _e1044 = local.member_4[2u];
                            let _e1049 = local.member[0u][2u];
                            if (_e1049 < 0f) {
                                phi_1512_ = -(_e1049);
                            } else {
                                phi_1512_ = _e1049;
                            }
                            let _e1053 = phi_1512_;
                            let _e1056 = local.member_4[0u];
                            if (_e1008 < 0f) {
                                phi_1528_ = -(_e1008);
                            } else {
                                phi_1528_ = _e1008;
                            }
                            let _e1062 = phi_1528_;
                            let _e1064 = (_e1062 - (((_e1016 * _e1019) + (_e1028 * _e1031)) + ((_e1041 * _e1044) + (_e1053 * _e1056))));
                            let _e1068 = local.member[1u][2u];
                            let _e1071 = local.member_1[2u];
                            let _e1076 = local.member[2u][2u];
                            let _e1079 = local.member_1[1u];
                            let _e1081 = ((_e1068 * _e1071) - (_e1076 * _e1079));
                            let _e1085 = local.member[2u][2u];
                            if (_e1085 < 0f) {
                                phi_1583_ = -(_e1085);
                            } else {
                                phi_1583_ = _e1085;
                            }
                            let _e1089 = phi_1583_;
                            let _e1092 = local.member_3[1u];
                            let _e1097 = local.member[1u][2u];
                            if (_e1097 < 0f) {
                                phi_1606_ = -(_e1097);
                            } else {
                                phi_1606_ = _e1097;
                            }
                            let _e1101 = phi_1606_;
                            let _e1104 = local.member_3[2u];
                            let _e1110 = local.member[0u][1u];
                            if (_e1110 < 0f) {
                                phi_1629_ = -(_e1110);
                            } else {
                                phi_1629_ = _e1110;
                            }
                            let _e1114 = phi_1629_;
                            let _e1117 = local.member_4[0u];
                            let _e1122 = local.member[0u][0u];
                            if (_e1122 < 0f) {
                                phi_1651_ = -(_e1122);
                            } else {
                                phi_1651_ = _e1122;
                            }
                            let _e1126 = phi_1651_;
                            let _e1129 = local.member_4[1u];
                            if (_e1081 < 0f) {
                                phi_1667_ = -(_e1081);
                            } else {
                                phi_1667_ = _e1081;
                            }
                            let _e1135 = phi_1667_;
                            let _e1137 = (_e1135 - (((_e1089 * _e1092) + (_e1101 * _e1104)) + ((_e1114 * _e1117) + (_e1126 * _e1129))));
                            let _e1141 = local.member[2u][0u];
                            let _e1144 = local.member_1[0u];
                            let _e1149 = local.member[0u][0u];
                            let _e1152 = local.member_1[2u];
                            let _e1154 = ((_e1141 * _e1144) - (_e1149 * _e1152));
                            let _e1158 = local.member[0u][0u];
                            if (_e1158 < 0f) {
                                phi_1722_ = -(_e1158);
                            } else {
                                phi_1722_ = _e1158;
                            }
                            let _e1162 = phi_1722_;
                            let _e1165 = local.member_3[2u];
                            let _e1170 = local.member[2u][0u];
                            if (_e1170 < 0f) {
                                phi_1745_ = -(_e1170);
                            } else {
                                phi_1745_ = _e1170;
                            }
                            let _e1174 = phi_1745_;
                            let _e1177 = local.member_3[0u];
                            let _e1183 = local.member[1u][2u];
                            if (_e1183 < 0f) {
                                phi_1769_ = -(_e1183);
                            } else {
                                phi_1769_ = _e1183;
                            }
                            let _e1187 = phi_1769_;
                            let _e1190 = local.member_4[1u];
                            let _e1195 = local.member[1u][1u];
                            if (_e1195 < 0f) {
                                phi_1792_ = -(_e1195);
                            } else {
                                phi_1792_ = _e1195;
                            }
                            let _e1199 = phi_1792_;
                            let _e1202 = local.member_4[2u];
                            if (_e1154 < 0f) {
                                phi_1808_ = -(_e1154);
                            } else {
                                phi_1808_ = _e1154;
                            }
                            let _e1208 = phi_1808_;
                            let _e1210 = (_e1208 - (((_e1162 * _e1165) + (_e1174 * _e1177)) + ((_e1187 * _e1190) + (_e1199 * _e1202))));
                            let _e1214 = local.member[2u][1u];
                            let _e1217 = local.member_1[0u];
                            let _e1222 = local.member[0u][1u];
                            let _e1225 = local.member_1[2u];
                            let _e1227 = ((_e1214 * _e1217) - (_e1222 * _e1225));
                            let _e1231 = local.member[0u][1u];
                            if (_e1231 < 0f) {
                                phi_1863_ = -(_e1231);
                            } else {
                                phi_1863_ = _e1231;
                            }
                            let _e1235 = phi_1863_;
                            let _e1238 = local.member_3[2u];
                            let _e1243 = local.member[2u][1u];
                            if (_e1243 < 0f) {
                                phi_1886_ = -(_e1243);
                            } else {
                                phi_1886_ = _e1243;
                            }
                            let _e1247 = phi_1886_;
                            let _e1250 = local.member_3[0u];
                            let _e1256 = local.member[1u][0u];
                            if (_e1256 < 0f) {
                                phi_1910_ = -(_e1256);
                            } else {
                                phi_1910_ = _e1256;
                            }
                            let _e1260 = phi_1910_;
                            let _e1263 = local.member_4[2u];
                            let _e1268 = local.member[1u][2u];
                            if (_e1268 < 0f) {
                                phi_1933_ = -(_e1268);
                            } else {
                                phi_1933_ = _e1268;
                            }
                            let _e1272 = phi_1933_;
                            let _e1275 = local.member_4[0u];
                            if (_e1227 < 0f) {
                                phi_1949_ = -(_e1227);
                            } else {
                                phi_1949_ = _e1227;
                            }
                            let _e1281 = phi_1949_;
                            let _e1283 = (_e1281 - (((_e1235 * _e1238) + (_e1247 * _e1250)) + ((_e1260 * _e1263) + (_e1272 * _e1275))));
                            let _e1287 = local.member[2u][2u];
                            let _e1290 = local.member_1[0u];
                            let _e1295 = local.member[0u][2u];
                            let _e1298 = local.member_1[2u];
                            let _e1300 = ((_e1287 * _e1290) - (_e1295 * _e1298));
                            let _e1304 = local.member[0u][2u];
                            if (_e1304 < 0f) {
                                phi_2004_ = -(_e1304);
                            } else {
                                phi_2004_ = _e1304;
                            }
                            let _e1308 = phi_2004_;
                            let _e1311 = local.member_3[2u];
                            let _e1316 = local.member[2u][2u];
                            if (_e1316 < 0f) {
                                phi_2027_ = -(_e1316);
                            } else {
                                phi_2027_ = _e1316;
                            }
                            let _e1320 = phi_2027_;
                            let _e1323 = local.member_3[0u];
                            let _e1329 = local.member[1u][1u];
                            if (_e1329 < 0f) {
                                phi_2051_ = -(_e1329);
                            } else {
                                phi_2051_ = _e1329;
                            }
                            let _e1333 = phi_2051_;
                            let _e1336 = local.member_4[0u];
                            let _e1341 = local.member[1u][0u];
                            if (_e1341 < 0f) {
                                phi_2074_ = -(_e1341);
                            } else {
                                phi_2074_ = _e1341;
                            }
                            let _e1345 = phi_2074_;
                            let _e1348 = local.member_4[1u];
                            if (_e1300 < 0f) {
                                phi_2090_ = -(_e1300);
                            } else {
                                phi_2090_ = _e1300;
                            }
                            let _e1354 = phi_2090_;
                            let _e1356 = (_e1354 - (((_e1308 * _e1311) + (_e1320 * _e1323)) + ((_e1333 * _e1336) + (_e1345 * _e1348))));
                            let _e1360 = local.member[0u][0u];
                            let _e1363 = local.member_1[1u];
                            let _e1368 = local.member[1u][0u];
                            let _e1371 = local.member_1[0u];
                            let _e1373 = ((_e1360 * _e1363) - (_e1368 * _e1371));
                            let _e1377 = local.member[1u][0u];
                            if (_e1377 < 0f) {
                                phi_2145_ = -(_e1377);
                            } else {
                                phi_2145_ = _e1377;
                            }
                            let _e1381 = phi_2145_;
                            let _e1384 = local.member_3[0u];
                            let _e1389 = local.member[0u][0u];
                            if (_e1389 < 0f) {
                                phi_2168_ = -(_e1389);
                            } else {
                                phi_2168_ = _e1389;
                            }
                            let _e1393 = phi_2168_;
                            let _e1396 = local.member_3[1u];
                            let _e1402 = local.member[2u][2u];
                            if (_e1402 < 0f) {
                                phi_2192_ = -(_e1402);
                            } else {
                                phi_2192_ = _e1402;
                            }
                            let _e1406 = phi_2192_;
                            let _e1409 = local.member_4[1u];
                            let _e1414 = local.member[2u][1u];
                            if (_e1414 < 0f) {
                                phi_2215_ = -(_e1414);
                            } else {
                                phi_2215_ = _e1414;
                            }
                            let _e1418 = phi_2215_;
                            let _e1421 = local.member_4[2u];
                            if (_e1373 < 0f) {
                                phi_2231_ = -(_e1373);
                            } else {
                                phi_2231_ = _e1373;
                            }
                            let _e1427 = phi_2231_;
                            let _e1429 = (_e1427 - (((_e1381 * _e1384) + (_e1393 * _e1396)) + ((_e1406 * _e1409) + (_e1418 * _e1421))));
                            let _e1433 = local.member[0u][1u];
                            let _e1436 = local.member_1[1u];
                            let _e1441 = local.member[1u][1u];
                            let _e1444 = local.member_1[0u];
                            let _e1446 = ((_e1433 * _e1436) - (_e1441 * _e1444));
                            let _e1450 = local.member[1u][1u];
                            if (_e1450 < 0f) {
                                phi_2286_ = -(_e1450);
                            } else {
                                phi_2286_ = _e1450;
                            }
                            let _e1454 = phi_2286_;
                            let _e1457 = local.member_3[0u];
                            let _e1462 = local.member[0u][1u];
                            if (_e1462 < 0f) {
                                phi_2309_ = -(_e1462);
                            } else {
                                phi_2309_ = _e1462;
                            }
                            let _e1466 = phi_2309_;
                            let _e1469 = local.member_3[1u];
                            let _e1475 = local.member[2u][0u];
                            if (_e1475 < 0f) {
                                phi_2333_ = -(_e1475);
                            } else {
                                phi_2333_ = _e1475;
                            }
                            let _e1479 = phi_2333_;
                            let _e1482 = local.member_4[2u];
                            let _e1487 = local.member[2u][2u];
                            if (_e1487 < 0f) {
                                phi_2356_ = -(_e1487);
                            } else {
                                phi_2356_ = _e1487;
                            }
                            let _e1491 = phi_2356_;
                            let _e1494 = local.member_4[0u];
                            if (_e1446 < 0f) {
                                phi_2372_ = -(_e1446);
                            } else {
                                phi_2372_ = _e1446;
                            }
                            let _e1500 = phi_2372_;
                            let _e1502 = (_e1500 - (((_e1454 * _e1457) + (_e1466 * _e1469)) + ((_e1479 * _e1482) + (_e1491 * _e1494))));
                            let _e1506 = local.member[0u][2u];
                            let _e1509 = local.member_1[1u];
                            let _e1514 = local.member[1u][2u];
                            let _e1517 = local.member_1[0u];
                            let _e1519 = ((_e1506 * _e1509) - (_e1514 * _e1517));
                            let _e1523 = local.member[1u][2u];
                            if (_e1523 < 0f) {
                                phi_2427_ = -(_e1523);
                            } else {
                                phi_2427_ = _e1523;
                            }
                            let _e1527 = phi_2427_;
                            let _e1530 = local.member_3[0u];
                            let _e1535 = local.member[0u][2u];
                            if (_e1535 < 0f) {
                                phi_2450_ = -(_e1535);
                            } else {
                                phi_2450_ = _e1535;
                            }
                            let _e1539 = phi_2450_;
                            let _e1542 = local.member_3[1u];
                            let _e1548 = local.member[2u][1u];
                            if (_e1548 < 0f) {
                                phi_2474_ = -(_e1548);
                            } else {
                                phi_2474_ = _e1548;
                            }
                            let _e1552 = phi_2474_;
                            let _e1555 = local.member_4[0u];
                            let _e1560 = local.member[2u][0u];
                            if (_e1560 < 0f) {
                                phi_2497_ = -(_e1560);
                            } else {
                                phi_2497_ = _e1560;
                            }
                            let _e1564 = phi_2497_;
                            let _e1567 = local.member_4[1u];
                            if (_e1519 < 0f) {
                                phi_2513_ = -(_e1519);
                            } else {
                                phi_2513_ = _e1519;
                            }
                            let _e1573 = phi_2513_;
                            let _e1575 = (_e1573 - (((_e1527 * _e1530) + (_e1539 * _e1542)) + ((_e1552 * _e1555) + (_e1564 * _e1567))));
                            if (_e991 > _e1064) {
                                phi_2520_ = _e991;
                            } else {
                                phi_2520_ = _e1064;
                            }
                            let _e1578 = phi_2520_;
                            if (_e1578 > _e1137) {
                                phi_2525_ = _e1578;
                            } else {
                                phi_2525_ = _e1137;
                            }
                            let _e1581 = phi_2525_;
                            if (_e1210 > _e1283) {
                                phi_2530_ = _e1210;
                            } else {
                                phi_2530_ = _e1283;
                            }
                            let _e1584 = phi_2530_;
                            if (_e1584 > _e1356) {
                                phi_2535_ = _e1584;
                            } else {
                                phi_2535_ = _e1356;
                            }
                            let _e1587 = phi_2535_;
                            if (_e1581 > _e1587) {
                                phi_2540_ = _e1581;
                            } else {
                                phi_2540_ = _e1587;
                            }
                            let _e1590 = phi_2540_;
                            if (_e1429 > _e1502) {
                                phi_2545_ = _e1429;
                            } else {
                                phi_2545_ = _e1502;
                            }
                            let _e1593 = phi_2545_;
                            if (_e1593 > _e1575) {
                                phi_2550_ = _e1593;
                            } else {
                                phi_2550_ = _e1575;
                            }
                            let _e1596 = phi_2550_;
                            if (_e1590 > _e1596) {
                                phi_2555_ = _e1590;
                            } else {
                                phi_2555_ = _e1596;
                            }
                            let _e1599 = phi_2555_;
                            let _e1601 = local.member_5;
                            phi_2559_ = (_e1599 > _e1601);
                        }
                        let _e1604 = phi_2559_;
                        phi_2561_ = !(_e1604);
                        phi_2562_ = false;
                    } else {
                        phi_2561_ = bool();
                        phi_2562_ = true;
                    }
                    let _e1607 = phi_2561_;
                    let _e1609 = phi_2562_;
                    phi_2563_ = _e1607;
                    phi_2564_ = _e1609;
                }
                let _e1611 = phi_2563_;
                let _e1613 = phi_2564_;
                if _e1613 {
                    phi_2568_ = true;
                } else {
                    phi_2568_ = _e1611;
                }
                let _e1615 = phi_2568_;
                phi_2569_ = _e1615;
            } else {
                phi_2569_ = false;
            }
            let _e1617 = phi_2569_;
            if _e1617 {
                let _e1645 = atomicAdd((&control.member[0u]), 1u);
                let _e1648 = atomicMax((&output.member[0u]), (_e1645 + 1u));
                if ((_e1645 + 1u) < _e1645) {
                    let _e1652 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1655 = params.member.member_2.member_3;
                if (_e1645 < _e1655) {
                    let _e1659 = (2u * _e1645);
                    atomicStore((&output.member[(4u + _e1659)]), _e93[0]);
                    atomicStore((&output.member[(_e1659 + 5u)]), _e93[1]);
                }
            } else {
                let _e1620 = params.member.member_2.member_4;
                if (_e1620 > 0u) {
                    let _e1623 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e1623 + 1u) < _e1623) {
                        let _e1627 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e1630 = params.member.member_2.member_4;
                    if (_e1623 < _e1630) {
                        let _e1633 = params.member.member_2.member_5;
                        let _e1635 = params.member.member_2.member_4;
                        let _e1638 = (2u * ((_e1633 * _e1635) + _e1623));
                        front.member[_e1638] = _e93[0];
                        front.member[(_e1638 + 1u)] = _e93[1];
                    }
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn cut_pairs_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
