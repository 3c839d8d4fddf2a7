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
    member_18: u32,
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
@group(0) @binding(6) 
var<storage, read_write> output: type_28;
@group(0) @binding(3) 
var<storage> cuts: type_10;
@group(0) @binding(4) 
var<storage> oriented: type_24;
@group(0) @binding(5) 
var<storage, read_write> control: type_28;
@group(0) @binding(7) 
var<storage, read_write> front: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_20;
    var phi_148_: u32;
    var phi_185_: bool;
    var phi_214_: array<u32, 2>;
    var phi_215_: array<u32, 2>;
    var phi_216_: array<u32, 2>;
    var phi_267_: bool;
    var phi_268_: bool;
    var phi_269_: bool;
    var phi_270_: bool;
    var phi_274_: bool;
    var phi_352_: array<u32, 2>;
    var phi_383_: array<u32, 2>;
    var phi_415_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_501_: f32;
    var phi_507_: f32;
    var phi_513_: f32;
    var phi_519_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_549_: f32;
    var phi_554_: f32;
    var phi_559_: f32;
    var phi_575_: type_25;
    var phi_645_: f32;
    var phi_651_: f32;
    var phi_657_: f32;
    var phi_663_: f32;
    var phi_669_: f32;
    var phi_675_: f32;
    var phi_693_: f32;
    var phi_698_: f32;
    var phi_703_: f32;
    var phi_719_: type_25;
    var phi_909_: f32;
    var phi_915_: f32;
    var phi_922_: f32;
    var phi_931_: f32;
    var phi_938_: f32;
    var phi_946_: f32;
    var phi_955_: f32;
    var phi_962_: f32;
    var phi_970_: f32;
    var phi_1063_: f32;
    var phi_1070_: f32;
    var phi_1076_: f32;
    var phi_1082_: f32;
    var phi_1101_: f32;
    var phi_1108_: f32;
    var phi_1114_: f32;
    var phi_1120_: f32;
    var phi_1139_: f32;
    var phi_1146_: f32;
    var phi_1152_: f32;
    var phi_1158_: f32;
    var phi_1177_: f32;
    var phi_1184_: f32;
    var phi_1190_: f32;
    var phi_1196_: f32;
    var phi_1215_: f32;
    var phi_1222_: f32;
    var phi_1228_: f32;
    var phi_1234_: f32;
    var phi_1253_: f32;
    var phi_1260_: f32;
    var phi_1266_: f32;
    var phi_1272_: f32;
    var phi_1287_: f32;
    var phi_1292_: f32;
    var phi_1297_: f32;
    var phi_1302_: f32;
    var phi_1307_: f32;
    var phi_1366_: f32;
    var phi_1389_: f32;
    var phi_1412_: f32;
    var phi_1434_: f32;
    var phi_1450_: f32;
    var phi_1505_: f32;
    var phi_1528_: f32;
    var phi_1551_: f32;
    var phi_1573_: f32;
    var phi_1589_: f32;
    var phi_1644_: f32;
    var phi_1667_: f32;
    var phi_1690_: f32;
    var phi_1712_: f32;
    var phi_1728_: f32;
    var phi_1783_: f32;
    var phi_1806_: f32;
    var phi_1830_: f32;
    var phi_1853_: f32;
    var phi_1869_: f32;
    var phi_1924_: f32;
    var phi_1947_: f32;
    var phi_1971_: f32;
    var phi_1994_: f32;
    var phi_2010_: f32;
    var phi_2065_: f32;
    var phi_2088_: f32;
    var phi_2112_: f32;
    var phi_2135_: f32;
    var phi_2151_: f32;
    var phi_2206_: f32;
    var phi_2229_: f32;
    var phi_2253_: f32;
    var phi_2276_: f32;
    var phi_2292_: f32;
    var phi_2347_: f32;
    var phi_2370_: f32;
    var phi_2394_: f32;
    var phi_2417_: f32;
    var phi_2433_: f32;
    var phi_2488_: f32;
    var phi_2511_: f32;
    var phi_2535_: f32;
    var phi_2558_: f32;
    var phi_2574_: f32;
    var phi_2581_: f32;
    var phi_2586_: f32;
    var phi_2591_: f32;
    var phi_2596_: f32;
    var phi_2601_: f32;
    var phi_2606_: f32;
    var phi_2611_: f32;
    var phi_2616_: f32;
    var phi_2620_: bool;
    var phi_2622_: bool;
    var phi_2623_: bool;
    var phi_2624_: bool;
    var phi_2625_: bool;
    var phi_2629_: bool;
    var phi_2630_: bool;
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
        phi_148_ = 0u;
    } else {
        phi_148_ = 1u;
    }
    let _e69 = phi_148_;
    let _e70 = (_e69 * 1028u);
    let _e72 = cuts.member[0u];
    if (_e60 < _e72) {
        let _e75 = cuts.member[_e70];
        if (_e64 < _e75) {
            if _e67 {
                phi_185_ = (_e60 <= _e64);
            } else {
                phi_185_ = true;
            }
            let _e79 = phi_185_;
            if _e79 {
                let _e82 = cuts.member[(4u + _e60)];
                let _e86 = cuts.member[((_e70 + 4u) + _e64)];
                phi_214_ = array<u32, 2>(_e82, _e86);
            } else {
                phi_214_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e89 = phi_214_;
            phi_215_ = _e89;
        } else {
            phi_215_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e91 = phi_215_;
        phi_216_ = _e91;
    } else {
        phi_216_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e93 = phi_216_;
    if (_e93[0] != 4294967295u) {
        let _e99 = params.member.member_2.member;
        if (_e99 == 1u) {
            if (_e93[0] == _e93[1]) {
                let _e106 = a_nodes.member[_e93[0]];
                phi_267_ = (_e106.member_3 == 4294967295u);
                phi_268_ = false;
            } else {
                phi_267_ = bool();
                phi_268_ = true;
            }
            let _e110 = phi_267_;
            let _e112 = phi_268_;
            phi_269_ = _e110;
            phi_270_ = _e112;
        } else {
            phi_269_ = bool();
            phi_270_ = true;
        }
        let _e114 = phi_269_;
        let _e116 = phi_270_;
        if _e116 {
            phi_274_ = false;
        } else {
            phi_274_ = _e114;
        }
        let _e118 = phi_274_;
        if _e118 {
        } else {
            let _e121 = a_nodes.member[_e93[0]];
            let _e124 = b_nodes.member[_e93[1]];
            if ((((((_e121.member[0] <= _e124.member_2[0]) && (_e124.member[0] <= _e121.member_2[0])) && (_e121.member[1] <= _e124.member_2[1])) && (_e124.member[1] <= _e121.member_2[1])) && (_e121.member[2] <= _e124.member_2[2])) && (_e124.member[2] <= _e121.member_2[2])) {
                let _e154 = params.member.member_2.member;
                if (_e154 == 0u) {
                    phi_352_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_352_ = array<u32, 2>(1u, 1u);
                }
                let _e157 = phi_352_;
                let _e163 = params.member.member.member[_e157[0]];
                let _e164 = (_e163 - 1u);
                let _e168 = params.member.member.member[_e157[1]];
                let _e169 = (_e168 - 1u);
                let _e172 = params.member.member_2.member;
                if (_e172 == 0u) {
                    phi_383_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_383_ = array<u32, 2>(1u, 1u);
                }
                let _e175 = phi_383_;
                let _e181 = params.member.member.member_2[_e175[0]];
                let _e185 = params.member.member.member_2[_e175[1]];
                let _e188 = params.member.member_2.member;
                if (_e188 == 1u) {
                    phi_415_ = (_e93[0] == _e93[1]);
                } else {
                    phi_415_ = false;
                }
                let _e194 = phi_415_;
                if _e194 {
                    phi_2624_ = bool();
                    phi_2625_ = true;
                } else {
                    if (_e93[0] >= _e164) {
                        if (_e93[1] >= _e169) {
                            phi_427_ = false;
                        } else {
                            phi_427_ = true;
                        }
                        let _e198 = phi_427_;
                        phi_428_ = _e198;
                    } else {
                        phi_428_ = true;
                    }
                    let _e200 = phi_428_;
                    if _e200 {
                        if (_e93[0] < _e164) {
                            let _e280 = oriented.member[(_e181 + _e93[0])];
                            phi_575_ = type_25(array<f32, 3>(_e280.member.x, _e280.member.y, _e280.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e280.member.w, _e280.member_1.x, _e280.member_1.y), array<f32, 3>(_e280.member_1.z, _e280.member_1.w, _e280.member_2.x), array<f32, 3>(_e280.member_2.y, _e280.member_2.z, _e280.member_2.w)), array<f32, 3>(_e280.member_3.x, _e280.member_3.y, _e280.member_3.z));
                        } else {
                            let _e203 = a_nodes.member[_e93[0]];
                            let _e218 = ((_e203.member[0] * 0.5f) + (_e203.member_2[0] * 0.5f));
                            let _e219 = ((_e203.member[1] * 0.5f) + (_e203.member_2[1] * 0.5f));
                            let _e220 = ((_e203.member[2] * 0.5f) + (_e203.member_2[2] * 0.5f));
                            if (_e218 < _e203.member_2[0]) {
                                phi_501_ = _e218;
                            } else {
                                phi_501_ = _e203.member_2[0];
                            }
                            let _e224 = phi_501_;
                            if (_e219 < _e203.member_2[1]) {
                                phi_507_ = _e219;
                            } else {
                                phi_507_ = _e203.member_2[1];
                            }
                            let _e228 = phi_507_;
                            if (_e220 < _e203.member_2[2]) {
                                phi_513_ = _e220;
                            } else {
                                phi_513_ = _e203.member_2[2];
                            }
                            let _e232 = phi_513_;
                            if (_e224 > _e203.member[0]) {
                                phi_519_ = _e224;
                            } else {
                                phi_519_ = _e203.member[0];
                            }
                            let _e236 = phi_519_;
                            if (_e228 > _e203.member[1]) {
                                phi_525_ = _e228;
                            } else {
                                phi_525_ = _e203.member[1];
                            }
                            let _e240 = phi_525_;
                            if (_e232 > _e203.member[2]) {
                                phi_531_ = _e232;
                            } else {
                                phi_531_ = _e203.member[2];
                            }
                            let _e244 = phi_531_;
                            let _e247 = (_e203.member_2[0] - _e236);
                            let _e249 = (_e203.member_2[1] - _e240);
                            let _e251 = (_e203.member_2[2] - _e244);
                            let _e253 = (_e236 - _e203.member[0]);
                            let _e255 = (_e240 - _e203.member[1]);
                            let _e257 = (_e244 - _e203.member[2]);
                            if (_e247 > _e253) {
                                phi_549_ = _e247;
                            } else {
                                phi_549_ = _e253;
                            }
                            let _e260 = phi_549_;
                            if (_e249 > _e255) {
                                phi_554_ = _e249;
                            } else {
                                phi_554_ = _e255;
                            }
                            let _e263 = phi_554_;
                            if (_e251 > _e257) {
                                phi_559_ = _e251;
                            } else {
                                phi_559_ = _e257;
                            }
                            let _e266 = phi_559_;
                            let _e268 = (1f + (0.000000059604645f * 4f));
                            let _e272 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_575_ = type_25(array<f32, 3>(_e236, _e240, _e244), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e260 * _e268) + _e272), ((_e263 * _e268) + _e272), ((_e266 * _e268) + _e272)));
                        }
                        let _e319 = phi_575_;
                        if (_e93[1] < _e169) {
                            let _e399 = oriented.member[(_e185 + _e93[1])];
                            phi_719_ = type_25(array<f32, 3>(_e399.member.x, _e399.member.y, _e399.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e399.member.w, _e399.member_1.x, _e399.member_1.y), array<f32, 3>(_e399.member_1.z, _e399.member_1.w, _e399.member_2.x), array<f32, 3>(_e399.member_2.y, _e399.member_2.z, _e399.member_2.w)), array<f32, 3>(_e399.member_3.x, _e399.member_3.y, _e399.member_3.z));
                        } else {
                            let _e322 = b_nodes.member[_e93[1]];
                            let _e337 = ((_e322.member[0] * 0.5f) + (_e322.member_2[0] * 0.5f));
                            let _e338 = ((_e322.member[1] * 0.5f) + (_e322.member_2[1] * 0.5f));
                            let _e339 = ((_e322.member[2] * 0.5f) + (_e322.member_2[2] * 0.5f));
                            if (_e337 < _e322.member_2[0]) {
                                phi_645_ = _e337;
                            } else {
                                phi_645_ = _e322.member_2[0];
                            }
                            let _e343 = phi_645_;
                            if (_e338 < _e322.member_2[1]) {
                                phi_651_ = _e338;
                            } else {
                                phi_651_ = _e322.member_2[1];
                            }
                            let _e347 = phi_651_;
                            if (_e339 < _e322.member_2[2]) {
                                phi_657_ = _e339;
                            } else {
                                phi_657_ = _e322.member_2[2];
                            }
                            let _e351 = phi_657_;
                            if (_e343 > _e322.member[0]) {
                                phi_663_ = _e343;
                            } else {
                                phi_663_ = _e322.member[0];
                            }
                            let _e355 = phi_663_;
                            if (_e347 > _e322.member[1]) {
                                phi_669_ = _e347;
                            } else {
                                phi_669_ = _e322.member[1];
                            }
                            let _e359 = phi_669_;
                            if (_e351 > _e322.member[2]) {
                                phi_675_ = _e351;
                            } else {
                                phi_675_ = _e322.member[2];
                            }
                            let _e363 = phi_675_;
                            let _e366 = (_e322.member_2[0] - _e355);
                            let _e368 = (_e322.member_2[1] - _e359);
                            let _e370 = (_e322.member_2[2] - _e363);
                            let _e372 = (_e355 - _e322.member[0]);
                            let _e374 = (_e359 - _e322.member[1]);
                            let _e376 = (_e363 - _e322.member[2]);
                            if (_e366 > _e372) {
                                phi_693_ = _e366;
                            } else {
                                phi_693_ = _e372;
                            }
                            let _e379 = phi_693_;
                            if (_e368 > _e374) {
                                phi_698_ = _e368;
                            } else {
                                phi_698_ = _e374;
                            }
                            let _e382 = phi_698_;
                            if (_e370 > _e376) {
                                phi_703_ = _e370;
                            } else {
                                phi_703_ = _e376;
                            }
                            let _e385 = phi_703_;
                            let _e387 = (1f + (0.000000059604645f * 4f));
                            let _e391 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_719_ = type_25(array<f32, 3>(_e355, _e359, _e363), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e379 * _e387) + _e391), ((_e382 * _e387) + _e391), ((_e385 * _e387) + _e391)));
                        }
                        let _e438 = phi_719_;
                        let _e443 = (_e438.member[0] - _e319.member[0]);
                        let _e446 = (_e438.member[1] - _e319.member[1]);
                        let _e449 = (_e438.member[2] - _e319.member[2]);
                        if (_e443 < 0f) {
                            phi_909_ = -(_e443);
                        } else {
                            phi_909_ = _e443;
                        }
                        let _e638 = phi_909_;
                        if (_e446 < 0f) {
                            phi_915_ = -(_e446);
                        } else {
                            phi_915_ = _e446;
                        }
                        let _e642 = phi_915_;
                        if (_e449 < 0f) {
                            phi_922_ = -(_e449);
                        } else {
                            phi_922_ = _e449;
                        }
                        let _e647 = phi_922_;
                        if (_e319.member_2[0] < 0f) {
                            phi_931_ = -(_e319.member_2[0]);
                        } else {
                            phi_931_ = _e319.member_2[0];
                        }
                        let _e654 = phi_931_;
                        if (_e319.member_2[1] < 0f) {
                            phi_938_ = -(_e319.member_2[1]);
                        } else {
                            phi_938_ = _e319.member_2[1];
                        }
                        let _e659 = phi_938_;
                        if (_e319.member_2[2] < 0f) {
                            phi_946_ = -(_e319.member_2[2]);
                        } else {
                            phi_946_ = _e319.member_2[2];
                        }
                        let _e665 = phi_946_;
                        if (_e438.member_2[0] < 0f) {
                            phi_955_ = -(_e438.member_2[0]);
                        } else {
                            phi_955_ = _e438.member_2[0];
                        }
                        let _e672 = phi_955_;
                        if (_e438.member_2[1] < 0f) {
                            phi_962_ = -(_e438.member_2[1]);
                        } else {
                            phi_962_ = _e438.member_2[1];
                        }
                        let _e677 = phi_962_;
                        if (_e438.member_2[2] < 0f) {
                            phi_970_ = -(_e438.member_2[2]);
                        } else {
                            phi_970_ = _e438.member_2[2];
                        }
                        let _e683 = phi_970_;
                        local = type_20(array<array<f32, 3>, 3>(array<f32, 3>((((_e438.member_1[0][0] * _e319.member_1[0][0]) + (_e438.member_1[0][1] * _e319.member_1[0][1])) + (_e438.member_1[0][2] * _e319.member_1[0][2])), (((_e438.member_1[1][0] * _e319.member_1[0][0]) + (_e438.member_1[1][1] * _e319.member_1[0][1])) + (_e438.member_1[1][2] * _e319.member_1[0][2])), (((_e438.member_1[2][0] * _e319.member_1[0][0]) + (_e438.member_1[2][1] * _e319.member_1[0][1])) + (_e438.member_1[2][2] * _e319.member_1[0][2]))), array<f32, 3>((((_e438.member_1[0][0] * _e319.member_1[1][0]) + (_e438.member_1[0][1] * _e319.member_1[1][1])) + (_e438.member_1[0][2] * _e319.member_1[1][2])), (((_e438.member_1[1][0] * _e319.member_1[1][0]) + (_e438.member_1[1][1] * _e319.member_1[1][1])) + (_e438.member_1[1][2] * _e319.member_1[1][2])), (((_e438.member_1[2][0] * _e319.member_1[1][0]) + (_e438.member_1[2][1] * _e319.member_1[1][1])) + (_e438.member_1[2][2] * _e319.member_1[1][2]))), array<f32, 3>((((_e438.member_1[0][0] * _e319.member_1[2][0]) + (_e438.member_1[0][1] * _e319.member_1[2][1])) + (_e438.member_1[0][2] * _e319.member_1[2][2])), (((_e438.member_1[1][0] * _e319.member_1[2][0]) + (_e438.member_1[1][1] * _e319.member_1[2][1])) + (_e438.member_1[1][2] * _e319.member_1[2][2])), (((_e438.member_1[2][0] * _e319.member_1[2][0]) + (_e438.member_1[2][1] * _e319.member_1[2][1])) + (_e438.member_1[2][2] * _e319.member_1[2][2])))), array<f32, 3>((((_e319.member_1[0][0] * _e443) + (_e319.member_1[0][1] * _e446)) + (_e319.member_1[0][2] * _e449)), (((_e319.member_1[1][0] * _e443) + (_e319.member_1[1][1] * _e446)) + (_e319.member_1[1][2] * _e449)), (((_e319.member_1[2][0] * _e443) + (_e319.member_1[2][1] * _e446)) + (_e319.member_1[2][2] * _e449))), array<f32, 3>((((_e438.member_1[0][0] * _e443) + (_e438.member_1[0][1] * _e446)) + (_e438.member_1[0][2] * _e449)), (((_e438.member_1[1][0] * _e443) + (_e438.member_1[1][1] * _e446)) + (_e438.member_1[1][2] * _e449)), (((_e438.member_1[2][0] * _e443) + (_e438.member_1[2][1] * _e446)) + (_e438.member_1[2][2] * _e449))), array<f32, 3>(_e319.member_2[0], _e319.member_2[1], _e319.member_2[2]), array<f32, 3>(_e438.member_2[0], _e438.member_2[1], _e438.member_2[2]), ((((((_e638 + _e642) + _e647) + (((_e654 + _e659) + _e665) + ((_e672 + _e677) + _e683))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                        let _e710 = local.member[0u][0u];
                        let _e714 = local.member[0u][1u];
                        let _e718 = local.member[0u][2u];
                        let _e722 = local.member[1u][0u];
                        let _e726 = local.member[1u][1u];
                        let _e730 = local.member[1u][2u];
                        let _e734 = local.member[2u][0u];
                        let _e738 = local.member[2u][1u];
                        let _e742 = local.member[2u][2u];
                        let _e744 = local.member_3;
                        let _e749 = local.member_4;
                        let _e755 = local.member_1[0u];
                        if (_e755 < 0f) {
                            phi_1063_ = -(_e755);
                        } else {
                            phi_1063_ = _e755;
                        }
                        let _e759 = phi_1063_;
                        if (_e710 < 0f) {
                            phi_1070_ = -(_e710);
                        } else {
                            phi_1070_ = _e710;
                        }
                        let _e763 = phi_1070_;
                        if (_e714 < 0f) {
                            phi_1076_ = -(_e714);
                        } else {
                            phi_1076_ = _e714;
                        }
                        let _e767 = phi_1076_;
                        if (_e718 < 0f) {
                            phi_1082_ = -(_e718);
                        } else {
                            phi_1082_ = _e718;
                        }
                        let _e771 = phi_1082_;
                        let _e778 = (_e759 - (_e744[0] + (((_e763 * _e749[0]) + (_e767 * _e749[1])) + (_e771 * _e749[2]))));
                        let _e781 = local.member_1[1u];
                        if (_e781 < 0f) {
                            phi_1101_ = -(_e781);
                        } else {
                            phi_1101_ = _e781;
                        }
                        let _e785 = phi_1101_;
                        if (_e722 < 0f) {
                            phi_1108_ = -(_e722);
                        } else {
                            phi_1108_ = _e722;
                        }
                        let _e789 = phi_1108_;
                        if (_e726 < 0f) {
                            phi_1114_ = -(_e726);
                        } else {
                            phi_1114_ = _e726;
                        }
                        let _e793 = phi_1114_;
                        if (_e730 < 0f) {
                            phi_1120_ = -(_e730);
                        } else {
                            phi_1120_ = _e730;
                        }
                        let _e797 = phi_1120_;
                        let _e804 = (_e785 - (_e744[1] + (((_e789 * _e749[0]) + (_e793 * _e749[1])) + (_e797 * _e749[2]))));
                        let _e807 = local.member_1[2u];
                        if (_e807 < 0f) {
                            phi_1139_ = -(_e807);
                        } else {
                            phi_1139_ = _e807;
                        }
                        let _e811 = phi_1139_;
                        if (_e734 < 0f) {
                            phi_1146_ = -(_e734);
                        } else {
                            phi_1146_ = _e734;
                        }
                        let _e815 = phi_1146_;
                        if (_e738 < 0f) {
                            phi_1152_ = -(_e738);
                        } else {
                            phi_1152_ = _e738;
                        }
                        let _e819 = phi_1152_;
                        if (_e742 < 0f) {
                            phi_1158_ = -(_e742);
                        } else {
                            phi_1158_ = _e742;
                        }
                        let _e823 = phi_1158_;
                        let _e830 = (_e811 - (_e744[2] + (((_e815 * _e749[0]) + (_e819 * _e749[1])) + (_e823 * _e749[2]))));
                        let _e833 = local.member_2[0u];
                        if (_e833 < 0f) {
                            phi_1177_ = -(_e833);
                        } else {
                            phi_1177_ = _e833;
                        }
                        let _e837 = phi_1177_;
                        if (_e710 < 0f) {
                            phi_1184_ = -(_e710);
                        } else {
                            phi_1184_ = _e710;
                        }
                        let _e841 = phi_1184_;
                        if (_e722 < 0f) {
                            phi_1190_ = -(_e722);
                        } else {
                            phi_1190_ = _e722;
                        }
                        let _e845 = phi_1190_;
                        if (_e734 < 0f) {
                            phi_1196_ = -(_e734);
                        } else {
                            phi_1196_ = _e734;
                        }
                        let _e849 = phi_1196_;
                        let _e856 = (_e837 - (_e749[0] + (((_e841 * _e744[0]) + (_e845 * _e744[1])) + (_e849 * _e744[2]))));
                        let _e859 = local.member_2[1u];
                        if (_e859 < 0f) {
                            phi_1215_ = -(_e859);
                        } else {
                            phi_1215_ = _e859;
                        }
                        let _e863 = phi_1215_;
                        if (_e714 < 0f) {
                            phi_1222_ = -(_e714);
                        } else {
                            phi_1222_ = _e714;
                        }
                        let _e867 = phi_1222_;
                        if (_e726 < 0f) {
                            phi_1228_ = -(_e726);
                        } else {
                            phi_1228_ = _e726;
                        }
                        let _e871 = phi_1228_;
                        if (_e738 < 0f) {
                            phi_1234_ = -(_e738);
                        } else {
                            phi_1234_ = _e738;
                        }
                        let _e875 = phi_1234_;
                        let _e882 = (_e863 - (_e749[1] + (((_e867 * _e744[0]) + (_e871 * _e744[1])) + (_e875 * _e744[2]))));
                        let _e885 = local.member_2[2u];
                        if (_e885 < 0f) {
                            phi_1253_ = -(_e885);
                        } else {
                            phi_1253_ = _e885;
                        }
                        let _e889 = phi_1253_;
                        if (_e718 < 0f) {
                            phi_1260_ = -(_e718);
                        } else {
                            phi_1260_ = _e718;
                        }
                        let _e893 = phi_1260_;
                        if (_e730 < 0f) {
                            phi_1266_ = -(_e730);
                        } else {
                            phi_1266_ = _e730;
                        }
                        let _e897 = phi_1266_;
                        if (_e742 < 0f) {
                            phi_1272_ = -(_e742);
                        } else {
                            phi_1272_ = _e742;
                        }
                        let _e901 = phi_1272_;
                        let _e908 = (_e889 - (_e749[2] + (((_e893 * _e744[0]) + (_e897 * _e744[1])) + (_e901 * _e744[2]))));
                        if (_e778 > _e804) {
                            phi_1287_ = _e778;
                        } else {
                            phi_1287_ = _e804;
                        }
                        let _e911 = phi_1287_;
                        if (_e911 > _e830) {
                            phi_1292_ = _e911;
                        } else {
                            phi_1292_ = _e830;
                        }
                        let _e914 = phi_1292_;
                        if (_e856 > _e882) {
                            phi_1297_ = _e856;
                        } else {
                            phi_1297_ = _e882;
                        }
                        let _e917 = phi_1297_;
                        if (_e917 > _e908) {
                            phi_1302_ = _e917;
                        } else {
                            phi_1302_ = _e908;
                        }
                        let _e920 = phi_1302_;
                        if (_e914 > _e920) {
                            phi_1307_ = _e914;
                        } else {
                            phi_1307_ = _e920;
                        }
                        let _e923 = phi_1307_;
                        let _e925 = local.member_5;
                        if (_e923 > _e925) {
                            phi_2620_ = true;
                        } else {
                            let _e930 = local.member[1u][0u];
                            let _e933 = local.member_1[2u];
                            let _e938 = local.member[2u][0u];
                            let _e941 = local.member_1[1u];
                            let _e943 = ((_e930 * _e933) - (_e938 * _e941));
                            let _e947 = local.member[2u][0u];
                            if (_e947 < 0f) {
                                phi_1366_ = -(_e947);
                            } else {
                                phi_1366_ = _e947;
                            }
                            let _e951 = phi_1366_;
                            let _e954 = local.member_3[1u];
                            let _e959 = local.member[1u][0u];
                            if (_e959 < 0f) {
                                phi_1389_ = -(_e959);
                            } else {
                                phi_1389_ = _e959;
                            }
                            let _e963 = phi_1389_;
                            let _e966 = local.member_3[2u];
                            let _e972 = local.member[0u][2u];
                            if (_e972 < 0f) {
                                phi_1412_ = -(_e972);
                            } else {
                                phi_1412_ = _e972;
                            }
                            let _e976 = phi_1412_;
                            let _e979 = local.member_4[1u];
                            let _e984 = local.member[0u][1u];
                            if (_e984 < 0f) {
                                phi_1434_ = -(_e984);
                            } else {
                                phi_1434_ = _e984;
                            }
                            let _e988 = phi_1434_;
                            let _e991 = local.member_4[2u];
                            if (_e943 < 0f) {
                                phi_1450_ = -(_e943);
                            } else {
                                phi_1450_ = _e943;
                            }
                            let _e997 = phi_1450_;
                            let _e999 = (_e997 - (((_e951 * _e954) + (_e963 * _e966)) + ((_e976 * _e979) + (_e988 * _e991))));
                            let _e1003 = local.member[1u][1u];
                            let _e1006 = local.member_1[2u];
                            let _e1011 = local.member[2u][1u];
                            let _e1014 = local.member_1[1u];
                            let _e1016 = ((_e1003 * _e1006) - (_e1011 * _e1014));
                            let _e1020 = local.member[2u][1u];
                            if (_e1020 < 0f) {
                                phi_1505_ = -(_e1020);
                            } else {
                                phi_1505_ = _e1020;
                            }
                            let _e1024 = phi_1505_;
                            let _e1027 = local.member_3[1u];
                            let _e1032 = local.member[1u][1u];
                            if (_e1032 < 0f) {
                                phi_1528_ = -(_e1032);
                            } else {
                                phi_1528_ = _e1032;
                            }
                            let _e1036 = phi_1528_;
                            let _e1039 = local.member_3[2u];
                            let _e1045 = local.member[0u][0u];
                            if (_e1045 < 0f) {
                                phi_1551_ = -(_e1045);
                            } else {
                                phi_1551_ = _e1045;
                            }
                            let _e1049 = phi_1551_;
                            let _e1052 = local.member_4[2u];
                            let _e1057 = local.member[0u][2u];
                            if (_e1057 < 0f) {
                                phi_1573_ = -(_e1057);
                            } else {
                                phi_1573_ = _e1057;
                            }
                            let _e1061 = phi_1573_;
                            let _e1064 = local.member_4[0u];
                            if (_e1016 < 0f) {
                                phi_1589_ = -(_e1016);
                            } else {
                                phi_1589_ = _e1016;
                            }
                            let _e1070 = phi_1589_;
                            let _e1072 = (_e1070 - (((_e1024 * _e1027) + (_e1036 * _e1039)) + ((_e1049 * _e1052) + (_e1061 * _e1064))));
                            let _e1076 = local.member[1u][2u];
                            let _e1079 = local.member_1[2u];
                            let _e1084 = local.member[2u][2u];
                            let _e1087 = local.member_1[1u];
                            let _e1089 = ((_e1076 * _e1079) - (_e1084 * _e1087));
                            let _e1093 = local.member[2u][2u];
                            if (_e1093 < 0f) {
                                phi_1644_ = -(_e1093);
                            } else {
                                phi_1644_ = _e1093;
                            }
                            let _e1097 = phi_1644_;
                            let _e1100 = local.member_3[1u];
                            let _e1105 = local.member[1u][2u];
                            if (_e1105 < 0f) {
                                phi_1667_ = -(_e1105);
                            } else {
                                phi_1667_ = _e1105;
                            }
                            let _e1109 = phi_1667_;
                            let _e1112 = local.member_3[2u];
                            let _e1118 = local.member[0u][1u];
                            if (_e1118 < 0f) {
                                phi_1690_ = -(_e1118);
                            } else {
                                phi_1690_ = _e1118;
                            }
                            let _e1122 = phi_1690_;
                            let _e1125 = local.member_4[0u];
                            let _e1130 = local.member[0u][0u];
                            if (_e1130 < 0f) {
                                phi_1712_ = -(_e1130);
                            } else {
                                phi_1712_ = _e1130;
                            }
                            let _e1134 = phi_1712_;
                            let _e1137 = local.member_4[1u];
                            if (_e1089 < 0f) {
                                phi_1728_ = -(_e1089);
                            } else {
                                phi_1728_ = _e1089;
                            }
                            let _e1143 = phi_1728_;
                            let _e1145 = (_e1143 - (((_e1097 * _e1100) + (_e1109 * _e1112)) + ((_e1122 * _e1125) + (_e1134 * _e1137))));
                            let _e1149 = local.member[2u][0u];
                            let _e1152 = local.member_1[0u];
                            let _e1157 = local.member[0u][0u];
                            let _e1160 = local.member_1[2u];
                            let _e1162 = ((_e1149 * _e1152) - (_e1157 * _e1160));
                            let _e1166 = local.member[0u][0u];
                            if (_e1166 < 0f) {
                                phi_1783_ = -(_e1166);
                            } else {
                                phi_1783_ = _e1166;
                            }
                            let _e1170 = phi_1783_;
                            let _e1173 = local.member_3[2u];
                            let _e1178 = local.member[2u][0u];
                            if (_e1178 < 0f) {
                                phi_1806_ = -(_e1178);
                            } else {
                                phi_1806_ = _e1178;
                            }
                            let _e1182 = phi_1806_;
                            let _e1185 = local.member_3[0u];
                            let _e1191 = local.member[1u][2u];
                            if (_e1191 < 0f) {
                                phi_1830_ = -(_e1191);
                            } else {
                                phi_1830_ = _e1191;
                            }
                            let _e1195 = phi_1830_;
                            let _e1198 = local.member_4[1u];
                            let _e1203 = local.member[1u][1u];
                            if (_e1203 < 0f) {
                                phi_1853_ = -(_e1203);
                            } else {
                                phi_1853_ = _e1203;
                            }
                            let _e1207 = phi_1853_;
                            let _e1210 = local.member_4[2u];
                            if (_e1162 < 0f) {
                                phi_1869_ = -(_e1162);
                            } else {
                                phi_1869_ = _e1162;
                            }
                            let _e1216 = phi_1869_;
                            let _e1218 = (_e1216 - (((_e1170 * _e1173) + (_e1182 * _e1185)) + ((_e1195 * _e1198) + (_e1207 * _e1210))));
                            let _e1222 = local.member[2u][1u];
                            let _e1225 = local.member_1[0u];
                            let _e1230 = local.member[0u][1u];
                            let _e1233 = local.member_1[2u];
                            let _e1235 = ((_e1222 * _e1225) - (_e1230 * _e1233));
                            let _e1239 = local.member[0u][1u];
                            if (_e1239 < 0f) {
                                phi_1924_ = -(_e1239);
                            } else {
                                phi_1924_ = _e1239;
                            }
                            let _e1243 = phi_1924_;
                            let _e1246 = local.member_3[2u];
                            let _e1251 = local.member[2u][1u];
                            if (_e1251 < 0f) {
                                phi_1947_ = -(_e1251);
                            } else {
                                phi_1947_ = _e1251;
                            }
                            let _e1255 = phi_1947_;
                            let _e1258 = local.member_3[0u];
                            let _e1264 = local.member[1u][0u];
                            if (_e1264 < 0f) {
                                phi_1971_ = -(_e1264);
                            } else {
                                phi_1971_ = _e1264;
                            }
                            let _e1268 = phi_1971_;
                            let _e1271 = local.member_4[2u];
                            let _e1276 = local.member[1u][2u];
                            if (_e1276 < 0f) {
                                phi_1994_ = -(_e1276);
                            } else {
                                phi_1994_ = _e1276;
                            }
                            let _e1280 = phi_1994_;
                            let _e1283 = local.member_4[0u];
                            if (_e1235 < 0f) {
                                phi_2010_ = -(_e1235);
                            } else {
                                phi_2010_ = _e1235;
                            }
                            let _e1289 = phi_2010_;
                            let _e1291 = (_e1289 - (((_e1243 * _e1246) + (_e1255 * _e1258)) + ((_e1268 * _e1271) + (_e1280 * _e1283))));
                            let _e1295 = local.member[2u][2u];
                            let _e1298 = local.member_1[0u];
                            let _e1303 = local.member[0u][2u];
                            let _e1306 = local.member_1[2u];
                            let _e1308 = ((_e1295 * _e1298) - (_e1303 * _e1306));
                            let _e1312 = local.member[0u][2u];
                            if (_e1312 < 0f) {
                                phi_2065_ = -(_e1312);
                            } else {
                                phi_2065_ = _e1312;
                            }
                            let _e1316 = phi_2065_;
                            let _e1319 = local.member_3[2u];
                            let _e1324 = local.member[2u][2u];
                            if (_e1324 < 0f) {
                                phi_2088_ = -(_e1324);
                            } else {
                                phi_2088_ = _e1324;
                            }
                            let _e1328 = phi_2088_;
                            let _e1331 = local.member_3[0u];
                            let _e1337 = local.member[1u][1u];
                            if (_e1337 < 0f) {
                                phi_2112_ = -(_e1337);
                            } else {
                                phi_2112_ = _e1337;
                            }
                            let _e1341 = phi_2112_;
                            let _e1344 = local.member_4[0u];
                            let _e1349 = local.member[1u][0u];
                            if (_e1349 < 0f) {
                                phi_2135_ = -(_e1349);
                            } else {
                                phi_2135_ = _e1349;
                            }
                            let _e1353 = phi_2135_;
                            let _e1356 = local.member_4[1u];
                            if (_e1308 < 0f) {
                                phi_2151_ = -(_e1308);
                            } else {
                                phi_2151_ = _e1308;
                            }
                            let _e1362 = phi_2151_;
                            let _e1364 = (_e1362 - (((_e1316 * _e1319) + (_e1328 * _e1331)) + ((_e1341 * _e1344) + (_e1353 * _e1356))));
                            let _e1368 = local.member[0u][0u];
                            let _e1371 = local.member_1[1u];
                            let _e1376 = local.member[1u][0u];
                            let _e1379 = local.member_1[0u];
                            let _e1381 = ((_e1368 * _e1371) - (_e1376 * _e1379));
                            let _e1385 = local.member[1u][0u];
                            if (_e1385 < 0f) {
                                phi_2206_ = -(_e1385);
                            } else {
                                phi_2206_ = _e1385;
                            }
                            let _e1389 = phi_2206_;
                            let _e1392 = local.member_3[0u];
                            let _e1397 = local.member[0u][0u];
                            if (_e1397 < 0f) {
                                phi_2229_ = -(_e1397);
                            } else {
                                phi_2229_ = _e1397;
                            }
                            let _e1401 = phi_2229_;
                            let _e1404 = local.member_3[1u];
                            let _e1410 = local.member[2u][2u];
                            if (_e1410 < 0f) {
                                phi_2253_ = -(_e1410);
                            } else {
                                phi_2253_ = _e1410;
                            }
                            let _e1414 = phi_2253_;
                            let _e1417 = local.member_4[1u];
                            let _e1422 = local.member[2u][1u];
                            if (_e1422 < 0f) {
                                phi_2276_ = -(_e1422);
                            } else {
                                phi_2276_ = _e1422;
                            }
                            let _e1426 = phi_2276_;
                            let _e1429 = local.member_4[2u];
                            if (_e1381 < 0f) {
                                phi_2292_ = -(_e1381);
                            } else {
                                phi_2292_ = _e1381;
                            }
                            let _e1435 = phi_2292_;
                            let _e1437 = (_e1435 - (((_e1389 * _e1392) + (_e1401 * _e1404)) + ((_e1414 * _e1417) + (_e1426 * _e1429))));
                            let _e1441 = local.member[0u][1u];
                            let _e1444 = local.member_1[1u];
                            let _e1449 = local.member[1u][1u];
                            let _e1452 = local.member_1[0u];
                            let _e1454 = ((_e1441 * _e1444) - (_e1449 * _e1452));
                            let _e1458 = local.member[1u][1u];
                            if (_e1458 < 0f) {
                                phi_2347_ = -(_e1458);
                            } else {
                                phi_2347_ = _e1458;
                            }
                            let _e1462 = phi_2347_;
                            let _e1465 = local.member_3[0u];
                            let _e1470 = local.member[0u][1u];
                            if (_e1470 < 0f) {
                                phi_2370_ = -(_e1470);
                            } else {
                                phi_2370_ = _e1470;
                            }
                            let _e1474 = phi_2370_;
                            let _e1477 = local.member_3[1u];
                            let _e1483 = local.member[2u][0u];
                            if (_e1483 < 0f) {
                                phi_2394_ = -(_e1483);
                            } else {
                                phi_2394_ = _e1483;
                            }
                            let _e1487 = phi_2394_;
                            let _e1490 = local.member_4[2u];
                            let _e1495 = local.member[2u][2u];
                            if (_e1495 < 0f) {
                                phi_2417_ = -(_e1495);
                            } else {
                                phi_2417_ = _e1495;
                            }
                            let _e1499 = phi_2417_;
                            let _e1502 = local.member_4[0u];
                            if (_e1454 < 0f) {
                                phi_2433_ = -(_e1454);
                            } else {
                                phi_2433_ = _e1454;
                            }
                            let _e1508 = phi_2433_;
                            let _e1510 = (_e1508 - (((_e1462 * _e1465) + (_e1474 * _e1477)) + ((_e1487 * _e1490) + (_e1499 * _e1502))));
                            let _e1514 = local.member[0u][2u];
                            let _e1517 = local.member_1[1u];
                            let _e1522 = local.member[1u][2u];
                            let _e1525 = local.member_1[0u];
                            let _e1527 = ((_e1514 * _e1517) - (_e1522 * _e1525));
                            let _e1531 = local.member[1u][2u];
                            if (_e1531 < 0f) {
                                phi_2488_ = -(_e1531);
                            } else {
                                phi_2488_ = _e1531;
                            }
                            let _e1535 = phi_2488_;
                            let _e1538 = local.member_3[0u];
                            let _e1543 = local.member[0u][2u];
                            if (_e1543 < 0f) {
                                phi_2511_ = -(_e1543);
                            } else {
                                phi_2511_ = _e1543;
                            }
                            let _e1547 = phi_2511_;
                            let _e1550 = local.member_3[1u];
                            let _e1556 = local.member[2u][1u];
                            if (_e1556 < 0f) {
                                phi_2535_ = -(_e1556);
                            } else {
                                phi_2535_ = _e1556;
                            }
                            let _e1560 = phi_2535_;
                            let _e1563 = local.member_4[0u];
                            let _e1568 = local.member[2u][0u];
                            if (_e1568 < 0f) {
                                phi_2558_ = -(_e1568);
                            } else {
                                phi_2558_ = _e1568;
                            }
                            let _e1572 = phi_2558_;
                            let _e1575 = local.member_4[1u];
                            if (_e1527 < 0f) {
                                phi_2574_ = -(_e1527);
                            } else {
                                phi_2574_ = _e1527;
                            }
                            let _e1581 = phi_2574_;
                            let _e1583 = (_e1581 - (((_e1535 * _e1538) + (_e1547 * _e1550)) + ((_e1560 * _e1563) + (_e1572 * _e1575))));
                            if (_e999 > _e1072) {
                                phi_2581_ = _e999;
                            } else {
                                phi_2581_ = _e1072;
                            }
                            let _e1586 = phi_2581_;
                            if (_e1586 > _e1145) {
                                phi_2586_ = _e1586;
                            } else {
                                phi_2586_ = _e1145;
                            }
                            let _e1589 = phi_2586_;
                            if (_e1218 > _e1291) {
                                phi_2591_ = _e1218;
                            } else {
                                phi_2591_ = _e1291;
                            }
                            let _e1592 = phi_2591_;
                            if (_e1592 > _e1364) {
                                phi_2596_ = _e1592;
                            } else {
                                phi_2596_ = _e1364;
                            }
                            let _e1595 = phi_2596_;
                            if (_e1589 > _e1595) {
                                phi_2601_ = _e1589;
                            } else {
                                phi_2601_ = _e1595;
                            }
                            let _e1598 = phi_2601_;
                            if (_e1437 > _e1510) {
                                phi_2606_ = _e1437;
                            } else {
                                phi_2606_ = _e1510;
                            }
                            let _e1601 = phi_2606_;
                            if (_e1601 > _e1583) {
                                phi_2611_ = _e1601;
                            } else {
                                phi_2611_ = _e1583;
                            }
                            let _e1604 = phi_2611_;
                            if (_e1598 > _e1604) {
                                phi_2616_ = _e1598;
                            } else {
                                phi_2616_ = _e1604;
                            }
                            let _e1607 = phi_2616_;
                            let _e1609 = local.member_5;
                            phi_2620_ = (_e1607 > _e1609);
                        }
                        let _e1612 = phi_2620_;
                        phi_2622_ = !(_e1612);
                        phi_2623_ = false;
                    } else {
                        phi_2622_ = bool();
                        phi_2623_ = true;
                    }
                    let _e1615 = phi_2622_;
                    let _e1617 = phi_2623_;
                    phi_2624_ = _e1615;
                    phi_2625_ = _e1617;
                }
                let _e1619 = phi_2624_;
                let _e1621 = phi_2625_;
                if _e1621 {
                    phi_2629_ = true;
                } else {
                    phi_2629_ = _e1619;
                }
                let _e1623 = phi_2629_;
                phi_2630_ = _e1623;
            } else {
                phi_2630_ = false;
            }
            let _e1625 = phi_2630_;
            if _e1625 {
                let _e1652 = atomicAdd((&control.member[0u]), 1u);
                let _e1655 = atomicMax((&output.member[0u]), (_e1652 + 1u));
                if ((_e1652 + 1u) < _e1652) {
                    let _e1659 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1662 = params.member.member_2.member_3;
                if (_e1652 < _e1662) {
                    let _e1666 = (2u * _e1652);
                    atomicStore((&output.member[(4u + _e1666)]), _e93[0]);
                    atomicStore((&output.member[(_e1666 + 5u)]), _e93[1]);
                }
            } else {
                let _e1628 = params.member.member_2.member_4;
                if (_e1628 > 0u) {
                    let _e1631 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e1631 + 1u) < _e1631) {
                        let _e1635 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e1637 = params.member.member_2.member_4;
                    if (_e1631 < _e1637) {
                        let _e1640 = params.member.member_2.member_5;
                        let _e1642 = params.member.member_2.member_4;
                        let _e1645 = (2u * ((_e1640 * _e1642) + _e1631));
                        front.member[_e1645] = _e93[0];
                        front.member[(_e1645 + 1u)] = _e93[1];
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
