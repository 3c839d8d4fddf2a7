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

struct type_14 {
    member: f32,
    member_1: f32,
}

struct type_16 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_23 {
    member: u32,
}

struct type_24 {
    member: type_7,
    member_1: type_8,
    member_2: type_23,
}

struct type_25 {
    member: type_24,
}

struct type_28 {
    member: array<array<array<u32, 2>, 6>>,
}

struct type_31 {
    member: array<array<f64, 3>>,
}

struct type_32 {
    member: array<f64, 3>,
    member_1: array<f64, 3>,
}

@group(0) @binding(0) 
var<storage> params: type_25;
@group(0) @binding(1) 
var<storage> positions: type_31;
@group(0) @binding(2) 
var<storage, read_write> paths: type_18;
@group(0) @binding(3) 
var<storage, read_write> keys: type_28;
@group(0) @binding(4) 
var<storage, read_write> boxes: type_22;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_20;
    var local_1: type_20;
    var local_2: array<f64, 3>;
    var local_3: array<f64, 3>;
    var local_4: type_16;
    var local_5: type_32;
    var local_6: array<f64, 3>;
    var local_7: array<f64, 3>;
    var local_8: type_32;
    var local_9: type_32;
    var phi_195_: type_9;
    var phi_196_: type_9;
    var phi_219_: type_9;
    var phi_251_: bool;
    var phi_252_: bool;
    var phi_259_: array<u32, 2>;
    var phi_260_: bool;
    var phi_261_: array<u32, 2>;
    var phi_262_: bool;
    var phi_268_: array<u32, 2>;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_301_: array<u32, 2>;
    var phi_302_: bool;
    var phi_303_: array<u32, 2>;
    var phi_304_: bool;
    var phi_310_: array<u32, 2>;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_374_: type_9;
    var phi_375_: type_9;
    var phi_398_: type_9;
    var phi_425_: bool;
    var phi_442_: f64;
    var phi_443_: f64;
    var phi_444_: f64;
    var phi_471_: bool;
    var phi_488_: f64;
    var phi_489_: f64;
    var phi_490_: f64;
    var phi_534_: type_9;
    var phi_535_: type_9;
    var phi_558_: type_9;
    var phi_645_: bool;
    var phi_646_: u32;
    var phi_647_: bool;
    var phi_648_: u32;
    var phi_649_: bool;
    var phi_650_: u32;
    var phi_651_: bool;
    var phi_652_: u32;
    var phi_665_: type_14;
    var phi_713_: bool;
    var phi_714_: u32;
    var phi_715_: bool;
    var phi_716_: u32;
    var phi_717_: bool;
    var phi_718_: u32;
    var phi_719_: bool;
    var phi_720_: u32;
    var phi_733_: type_14;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_763_: f32;
    var phi_825_: bool;
    var phi_826_: u32;
    var phi_827_: bool;
    var phi_828_: u32;
    var phi_829_: bool;
    var phi_830_: u32;
    var phi_831_: bool;
    var phi_832_: u32;
    var phi_845_: type_14;
    var phi_893_: bool;
    var phi_894_: u32;
    var phi_895_: bool;
    var phi_896_: u32;
    var phi_897_: bool;
    var phi_898_: u32;
    var phi_899_: bool;
    var phi_900_: u32;
    var phi_913_: type_14;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_943_: f32;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_1005_: array<u32, 2>;
    var phi_1006_: bool;
    var phi_1007_: array<u32, 2>;
    var phi_1008_: bool;
    var phi_1014_: array<u32, 2>;
    var phi_1033_: bool;
    var phi_1034_: bool;
    var phi_1041_: array<u32, 2>;
    var phi_1042_: bool;
    var phi_1043_: array<u32, 2>;
    var phi_1044_: bool;
    var phi_1050_: array<u32, 2>;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1077_: array<u32, 2>;
    var phi_1078_: bool;
    var phi_1079_: array<u32, 2>;
    var phi_1080_: bool;
    var phi_1086_: array<u32, 2>;
    var phi_1105_: bool;
    var phi_1106_: bool;
    var phi_1113_: array<u32, 2>;
    var phi_1114_: bool;
    var phi_1115_: array<u32, 2>;
    var phi_1116_: bool;
    var phi_1122_: array<u32, 2>;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1149_: array<u32, 2>;
    var phi_1150_: bool;
    var phi_1151_: array<u32, 2>;
    var phi_1152_: bool;
    var phi_1158_: array<u32, 2>;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1185_: array<u32, 2>;
    var phi_1186_: bool;
    var phi_1187_: array<u32, 2>;
    var phi_1188_: bool;
    var phi_1194_: array<u32, 2>;
    var phi_1200_: type_9;
    var phi_1201_: type_9;
    var phi_1224_: type_9;
    var phi_1285_: bool;
    var phi_1286_: u32;
    var phi_1287_: bool;
    var phi_1288_: u32;
    var phi_1289_: bool;
    var phi_1290_: u32;
    var phi_1291_: bool;
    var phi_1292_: u32;
    var phi_1305_: type_14;
    var phi_1312_: f32;
    var phi_1317_: f32;
    var phi_1378_: bool;
    var phi_1379_: u32;
    var phi_1380_: bool;
    var phi_1381_: u32;
    var phi_1382_: bool;
    var phi_1383_: u32;
    var phi_1384_: bool;
    var phi_1385_: u32;
    var phi_1398_: type_14;
    var phi_1405_: f32;
    var phi_1410_: f32;
    var phi_1443_: type_9;
    var phi_1444_: type_9;
    var phi_1467_: type_9;
    var phi_1488_: bool;
    var phi_1511_: bool;
    var phi_1515_: f32;
    var phi_1524_: f32;
    var phi_1545_: bool;
    var phi_1568_: bool;
    var phi_1572_: f32;
    var phi_1581_: f32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e69 = ((((_e55.y * _e56.x) + _e55.x) * 256u) + _e57);
    let _e73 = params.member.member.member[0u];
    if (_e69 < _e73) {
        let _e77 = positions.member[_e69];
        let _e80 = params.member.member.member[0u];
        let _e83 = positions.member[(_e80 + _e69)];
        local_6 = array<f64, 3>(_e77[0], _e77[1], _e77[2]);
        local_7 = array<f64, 3>(_e83[0], _e83[1], _e83[2]);
        let _e94 = local_6;
        local_8.member = _e94;
        let _e96 = local_7;
        local_8.member_1 = _e96;
        phi_195_ = type_9(0u, 3u);
        loop {
            let _e98 = phi_195_;
            if (_e98.member < _e98.member_1) {
                phi_196_ = type_9((_e98.member + 1u), _e98.member_1);
                phi_219_ = type_9(1u, _e98.member);
            } else {
                phi_196_ = _e98;
                phi_219_ = type_9(0u, type_9().member_1);
            }
            let _e110 = phi_196_;
            let _e112 = phi_219_;
            let _e116 = (bitcast<i32>(_e112.member) != 0i);
            if _e116 {
                let _e118 = local_6[_e112.member_1];
                let _e119 = bitcast<u64>(_e118);
                let _e120 = u32(_e119);
                let _e122 = u32((_e119 / 4294967296lu));
                if ((_e122 >> bitcast<u32>(31i)) == 0u) {
                    phi_261_ = array<u32, 2>();
                    phi_262_ = true;
                } else {
                    if (_e122 == 2147483648u) {
                        if (_e120 == 0u) {
                            phi_251_ = false;
                        } else {
                            phi_251_ = true;
                        }
                        let _e129 = phi_251_;
                        phi_252_ = _e129;
                    } else {
                        phi_252_ = true;
                    }
                    let _e131 = phi_252_;
                    if _e131 {
                        phi_259_ = array<u32, 2>(~(_e120), ~(_e122));
                        phi_260_ = false;
                    } else {
                        phi_259_ = array<u32, 2>();
                        phi_260_ = true;
                    }
                    let _e136 = phi_259_;
                    let _e138 = phi_260_;
                    phi_261_ = _e136;
                    phi_262_ = _e138;
                }
                let _e140 = phi_261_;
                let _e142 = phi_262_;
                if _e142 {
                    phi_268_ = array<u32, 2>(_e120, (_e122 | 2147483648u));
                } else {
                    phi_268_ = _e140;
                }
                let _e146 = phi_268_;
                let _e148 = local_7[_e112.member_1];
                let _e149 = bitcast<u64>(_e148);
                let _e150 = u32(_e149);
                let _e152 = u32((_e149 / 4294967296lu));
                if ((_e152 >> bitcast<u32>(31i)) == 0u) {
                    phi_303_ = array<u32, 2>();
                    phi_304_ = true;
                } else {
                    if (_e152 == 2147483648u) {
                        if (_e150 == 0u) {
                            phi_293_ = false;
                        } else {
                            phi_293_ = true;
                        }
                        let _e159 = phi_293_;
                        phi_294_ = _e159;
                    } else {
                        phi_294_ = true;
                    }
                    let _e161 = phi_294_;
                    if _e161 {
                        phi_301_ = array<u32, 2>(~(_e150), ~(_e152));
                        phi_302_ = false;
                    } else {
                        phi_301_ = array<u32, 2>();
                        phi_302_ = true;
                    }
                    let _e166 = phi_301_;
                    let _e168 = phi_302_;
                    phi_303_ = _e166;
                    phi_304_ = _e168;
                }
                let _e170 = phi_303_;
                let _e172 = phi_304_;
                if _e172 {
                    phi_310_ = array<u32, 2>(_e150, (_e152 | 2147483648u));
                } else {
                    phi_310_ = _e170;
                }
                let _e176 = phi_310_;
                if (_e146[1] > _e176[1]) {
                    phi_327_ = true;
                } else {
                    if (_e146[1] == _e176[1]) {
                        phi_326_ = (_e146[0] > _e176[0]);
                    } else {
                        phi_326_ = false;
                    }
                    let _e187 = phi_326_;
                    phi_327_ = _e187;
                }
                let _e189 = phi_327_;
                if _e189 {
                    let _e191 = local_7[_e112.member_1];
                    local_8.member[_e112.member_1] = _e191;
                    let _e195 = local_6[_e112.member_1];
                    local_8.member_1[_e112.member_1] = _e195;
                }
            }
            continue;
            continuing {
                phi_195_ = _e110;
                break if !(_e116);
            }
        }
        let _e200 = params.member.member.member_9;
        let _e207 = bitcast<f64>(((u64(_e200[1]) * 4294967296lu) + u64(_e200[0])));
        if (_e207 > f64(0f)) {
            let _e211 = local_8;
            local_5 = _e211;
            phi_374_ = type_9(0u, 3u);
            loop {
                let _e213 = phi_374_;
                if (_e213.member < _e213.member_1) {
                    phi_375_ = type_9((_e213.member + 1u), _e213.member_1);
                    phi_398_ = type_9(1u, _e213.member);
                } else {
                    phi_375_ = _e213;
                    phi_398_ = type_9(0u, type_9().member_1);
                }
                let _e225 = phi_375_;
                let _e227 = phi_398_;
                let _e231 = (bitcast<i32>(_e227.member) != 0i);
                if _e231 {
                    let _e234 = local_5.member[_e227.member_1];
                    let _e236 = -((_e234 - _e207));
                    let _e237 = bitcast<u64>(_e236);
                    if ((_e237 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_425_ = (_e236 < 0.0lf);
                    } else {
                        phi_425_ = true;
                    }
                    let _e242 = phi_425_;
                    if _e242 {
                        if (_e236 > 0.0lf) {
                            phi_443_ = bitcast<f64>((_e237 + 1lu));
                        } else {
                            if (_e236 < 0.0lf) {
                                phi_442_ = bitcast<f64>((_e237 - 1lu));
                            } else {
                                phi_442_ = 5e-324lf;
                            }
                            let _e248 = phi_442_;
                            phi_443_ = _e248;
                        }
                        let _e252 = phi_443_;
                        phi_444_ = _e252;
                    } else {
                        phi_444_ = _e236;
                    }
                    let _e254 = phi_444_;
                    local_5.member[_e227.member_1] = -(_e254);
                    let _e260 = local_5.member_1[_e227.member_1];
                    let _e261 = (_e260 + _e207);
                    let _e262 = bitcast<u64>(_e261);
                    if ((_e262 & 9218868437227405312lu) == 9218868437227405312lu) {
                        phi_471_ = (_e261 < 0.0lf);
                    } else {
                        phi_471_ = true;
                    }
                    let _e267 = phi_471_;
                    if _e267 {
                        if (_e261 > 0.0lf) {
                            phi_489_ = bitcast<f64>((_e262 + 1lu));
                        } else {
                            if (_e261 < 0.0lf) {
                                phi_488_ = bitcast<f64>((_e262 - 1lu));
                            } else {
                                phi_488_ = 5e-324lf;
                            }
                            let _e273 = phi_488_;
                            phi_489_ = _e273;
                        }
                        let _e277 = phi_489_;
                        phi_490_ = _e277;
                    } else {
                        phi_490_ = _e261;
                    }
                    let _e279 = phi_490_;
                    local_5.member_1[_e227.member_1] = _e279;
                }
                continue;
                continuing {
                    phi_374_ = _e225;
                    break if !(_e231);
                }
            }
        } else {
            let _e210 = local_8;
            local_5 = _e210;
        }
        let _e283 = local_5;
        local_9 = _e283;
        local_2 = array<f64, 3>(_e77[0], _e77[1], _e77[2]);
        local_3 = array<f64, 3>(_e83[0], _e83[1], _e83[2]);
        local_4.member = array<f32, 4>(0f, 0f, 0f, 0f);
        local_4.member_1 = array<f32, 4>(0f, 0f, 0f, 0f);
        phi_534_ = type_9(0u, 3u);
        loop {
            let _e296 = phi_534_;
            if (_e296.member < _e296.member_1) {
                phi_535_ = type_9((_e296.member + 1u), _e296.member_1);
                phi_558_ = type_9(1u, _e296.member);
            } else {
                phi_535_ = _e296;
                phi_558_ = type_9(0u, type_9().member_1);
            }
            let _e308 = phi_535_;
            let _e310 = phi_558_;
            let _e314 = (bitcast<i32>(_e310.member) != 0i);
            if _e314 {
                let _e317 = params.member.member.member_8[_e310.member_1];
                let _e324 = bitcast<f64>(((u64(_e317[1]) * 4294967296lu) + u64(_e317[0])));
                let _e326 = params.member.member.member_10;
                let _e333 = bitcast<f64>(((u64(_e326[1]) * 4294967296lu) + u64(_e326[0])));
                let _e335 = local_2[_e310.member_1];
                let _e337 = ((_e335 - _e324) * _e333);
                let _e338 = bitcast<u64>(_e337);
                let _e339 = u32(_e338);
                let _e341 = u32((_e338 / 4294967296lu));
                let _e342 = (_e341 & 2147483648u);
                let _e345 = ((_e341 >> bitcast<u32>(20i)) & 2047u);
                let _e351 = (((_e341 & 1048575u) << bitcast<u32>(3i)) | (_e339 >> bitcast<u32>(29i)));
                let _e352 = (_e339 & 536870911u);
                if (_e345 == 2047u) {
                    phi_651_ = false;
                    phi_652_ = (2139095040u | _e351);
                } else {
                    if (_e345 > 1150u) {
                        phi_649_ = true;
                        phi_650_ = 2139095039u;
                    } else {
                        if (_e345 > 896u) {
                            phi_647_ = (_e352 != 0u);
                            phi_648_ = (((_e345 - 896u) << bitcast<u32>(23i)) | _e351);
                        } else {
                            if (_e345 >= 873u) {
                                let _e360 = (8388608u | _e351);
                                let _e361 = (897u - _e345);
                                phi_645_ = (((_e360 & ((1u << bitcast<u32>((_e361 & 31u))) - 1u)) | _e352) != 0u);
                                phi_646_ = (_e360 >> bitcast<u32>((_e361 & 31u)));
                            } else {
                                phi_645_ = (((_e341 & 2147483647u) | _e339) != 0u);
                                phi_646_ = 0u;
                            }
                            let _e373 = phi_645_;
                            let _e375 = phi_646_;
                            phi_647_ = _e373;
                            phi_648_ = _e375;
                        }
                        let _e382 = phi_647_;
                        let _e384 = phi_648_;
                        phi_649_ = _e382;
                        phi_650_ = _e384;
                    }
                    let _e386 = phi_649_;
                    let _e388 = phi_650_;
                    phi_651_ = _e386;
                    phi_652_ = _e388;
                }
                let _e391 = phi_651_;
                let _e393 = phi_652_;
                let _e395 = bitcast<f32>((_e342 | _e393));
                let _e399 = bitcast<f32>(((_e342 | _e393) + select(0u, 1u, _e391)));
                if (_e342 == 0u) {
                    phi_665_ = type_14(_e395, _e399);
                } else {
                    phi_665_ = type_14(_e399, _e395);
                }
                let _e404 = phi_665_;
                let _e406 = bitcast<u64>(_e337);
                let _e407 = u32(_e406);
                let _e409 = u32((_e406 / 4294967296lu));
                let _e410 = (_e409 & 2147483648u);
                let _e413 = ((_e409 >> bitcast<u32>(20i)) & 2047u);
                let _e419 = (((_e409 & 1048575u) << bitcast<u32>(3i)) | (_e407 >> bitcast<u32>(29i)));
                let _e420 = (_e407 & 536870911u);
                if (_e413 == 2047u) {
                    phi_719_ = false;
                    phi_720_ = (2139095040u | _e419);
                } else {
                    if (_e413 > 1150u) {
                        phi_717_ = true;
                        phi_718_ = 2139095039u;
                    } else {
                        if (_e413 > 896u) {
                            phi_715_ = (_e420 != 0u);
                            phi_716_ = (((_e413 - 896u) << bitcast<u32>(23i)) | _e419);
                        } else {
                            if (_e413 >= 873u) {
                                let _e428 = (8388608u | _e419);
                                let _e429 = (897u - _e413);
                                phi_713_ = (((_e428 & ((1u << bitcast<u32>((_e429 & 31u))) - 1u)) | _e420) != 0u);
                                phi_714_ = (_e428 >> bitcast<u32>((_e429 & 31u)));
                            } else {
                                phi_713_ = (((_e409 & 2147483647u) | _e407) != 0u);
                                phi_714_ = 0u;
                            }
                            let _e441 = phi_713_;
                            let _e443 = phi_714_;
                            phi_715_ = _e441;
                            phi_716_ = _e443;
                        }
                        let _e450 = phi_715_;
                        let _e452 = phi_716_;
                        phi_717_ = _e450;
                        phi_718_ = _e452;
                    }
                    let _e454 = phi_717_;
                    let _e456 = phi_718_;
                    phi_719_ = _e454;
                    phi_720_ = _e456;
                }
                let _e459 = phi_719_;
                let _e461 = phi_720_;
                let _e463 = bitcast<f32>((_e410 | _e461));
                let _e467 = bitcast<f32>(((_e410 | _e461) + select(0u, 1u, _e459)));
                if (_e410 == 0u) {
                    phi_733_ = type_14(_e463, _e467);
                } else {
                    phi_733_ = type_14(_e467, _e463);
                }
                let _e472 = phi_733_;
                let _e475 = (_e337 - f64(_e404.member));
                let _e477 = (f64(_e472.member_1) - _e337);
                if (_e475 < _e477) {
                    phi_759_ = true;
                } else {
                    if (_e475 == _e477) {
                        if ((bitcast<u32>(_e404.member) & 1u) == 0u) {
                            phi_753_ = false;
                        } else {
                            phi_753_ = true;
                        }
                        let _e484 = phi_753_;
                        phi_754_ = _e484;
                    } else {
                        phi_754_ = true;
                    }
                    let _e486 = phi_754_;
                    if _e486 {
                        phi_758_ = false;
                    } else {
                        phi_758_ = true;
                    }
                    let _e488 = phi_758_;
                    phi_759_ = _e488;
                }
                let _e490 = phi_759_;
                if _e490 {
                    phi_763_ = _e404.member;
                } else {
                    phi_763_ = _e472.member_1;
                }
                let _e492 = phi_763_;
                local_4.member[_e310.member_1] = _e492;
                let _e496 = local_3[_e310.member_1];
                let _e498 = ((_e496 - _e324) * _e333);
                let _e499 = bitcast<u64>(_e498);
                let _e500 = u32(_e499);
                let _e502 = u32((_e499 / 4294967296lu));
                let _e503 = (_e502 & 2147483648u);
                let _e506 = ((_e502 >> bitcast<u32>(20i)) & 2047u);
                let _e512 = (((_e502 & 1048575u) << bitcast<u32>(3i)) | (_e500 >> bitcast<u32>(29i)));
                let _e513 = (_e500 & 536870911u);
                if (_e506 == 2047u) {
                    phi_831_ = false;
                    phi_832_ = (2139095040u | _e512);
                } else {
                    if (_e506 > 1150u) {
                        phi_829_ = true;
                        phi_830_ = 2139095039u;
                    } else {
                        if (_e506 > 896u) {
                            phi_827_ = (_e513 != 0u);
                            phi_828_ = (((_e506 - 896u) << bitcast<u32>(23i)) | _e512);
                        } else {
                            if (_e506 >= 873u) {
                                let _e521 = (8388608u | _e512);
                                let _e522 = (897u - _e506);
                                phi_825_ = (((_e521 & ((1u << bitcast<u32>((_e522 & 31u))) - 1u)) | _e513) != 0u);
                                phi_826_ = (_e521 >> bitcast<u32>((_e522 & 31u)));
                            } else {
                                phi_825_ = (((_e502 & 2147483647u) | _e500) != 0u);
                                phi_826_ = 0u;
                            }
                            let _e534 = phi_825_;
                            let _e536 = phi_826_;
                            phi_827_ = _e534;
                            phi_828_ = _e536;
                        }
                        let _e543 = phi_827_;
                        let _e545 = phi_828_;
                        phi_829_ = _e543;
                        phi_830_ = _e545;
                    }
                    let _e547 = phi_829_;
                    let _e549 = phi_830_;
                    phi_831_ = _e547;
                    phi_832_ = _e549;
                }
                let _e552 = phi_831_;
                let _e554 = phi_832_;
                let _e556 = bitcast<f32>((_e503 | _e554));
                let _e560 = bitcast<f32>(((_e503 | _e554) + select(0u, 1u, _e552)));
                if (_e503 == 0u) {
                    phi_845_ = type_14(_e556, _e560);
                } else {
                    phi_845_ = type_14(_e560, _e556);
                }
                let _e565 = phi_845_;
                let _e567 = bitcast<u64>(_e498);
                let _e568 = u32(_e567);
                let _e570 = u32((_e567 / 4294967296lu));
                let _e571 = (_e570 & 2147483648u);
                let _e574 = ((_e570 >> bitcast<u32>(20i)) & 2047u);
                let _e580 = (((_e570 & 1048575u) << bitcast<u32>(3i)) | (_e568 >> bitcast<u32>(29i)));
                let _e581 = (_e568 & 536870911u);
                if (_e574 == 2047u) {
                    phi_899_ = false;
                    phi_900_ = (2139095040u | _e580);
                } else {
                    if (_e574 > 1150u) {
                        phi_897_ = true;
                        phi_898_ = 2139095039u;
                    } else {
                        if (_e574 > 896u) {
                            phi_895_ = (_e581 != 0u);
                            phi_896_ = (((_e574 - 896u) << bitcast<u32>(23i)) | _e580);
                        } else {
                            if (_e574 >= 873u) {
                                let _e589 = (8388608u | _e580);
                                let _e590 = (897u - _e574);
                                phi_893_ = (((_e589 & ((1u << bitcast<u32>((_e590 & 31u))) - 1u)) | _e581) != 0u);
                                phi_894_ = (_e589 >> bitcast<u32>((_e590 & 31u)));
                            } else {
                                phi_893_ = (((_e570 & 2147483647u) | _e568) != 0u);
                                phi_894_ = 0u;
                            }
                            let _e602 = phi_893_;
                            let _e604 = phi_894_;
                            phi_895_ = _e602;
                            phi_896_ = _e604;
                        }
                        let _e611 = phi_895_;
                        let _e613 = phi_896_;
                        phi_897_ = _e611;
                        phi_898_ = _e613;
                    }
                    let _e615 = phi_897_;
                    let _e617 = phi_898_;
                    phi_899_ = _e615;
                    phi_900_ = _e617;
                }
                let _e620 = phi_899_;
                let _e622 = phi_900_;
                let _e624 = bitcast<f32>((_e571 | _e622));
                let _e628 = bitcast<f32>(((_e571 | _e622) + select(0u, 1u, _e620)));
                if (_e571 == 0u) {
                    phi_913_ = type_14(_e624, _e628);
                } else {
                    phi_913_ = type_14(_e628, _e624);
                }
                let _e633 = phi_913_;
                let _e636 = (_e498 - f64(_e565.member));
                let _e638 = (f64(_e633.member_1) - _e498);
                if (_e636 < _e638) {
                    phi_939_ = true;
                } else {
                    if (_e636 == _e638) {
                        if ((bitcast<u32>(_e565.member) & 1u) == 0u) {
                            phi_933_ = false;
                        } else {
                            phi_933_ = true;
                        }
                        let _e645 = phi_933_;
                        phi_934_ = _e645;
                    } else {
                        phi_934_ = true;
                    }
                    let _e647 = phi_934_;
                    if _e647 {
                        phi_938_ = false;
                    } else {
                        phi_938_ = true;
                    }
                    let _e649 = phi_938_;
                    phi_939_ = _e649;
                }
                let _e651 = phi_939_;
                if _e651 {
                    phi_943_ = _e565.member;
                } else {
                    phi_943_ = _e633.member_1;
                }
                let _e653 = phi_943_;
                local_4.member_1[_e310.member_1] = _e653;
            }
            continue;
            continuing {
                phi_534_ = _e308;
                break if !(_e314);
            }
        }
        let _e657 = local_4;
        paths.member[_e69] = type_16(array<f32, 4>(_e657.member[0], _e657.member[1], _e657.member[2], _e657.member[3]), array<f32, 4>(_e657.member_1[0], _e657.member_1[1], _e657.member_1[2], _e657.member_1[3]));
        let _e673 = local_9.member;
        let _e678 = local_9.member_1;
        let _e682 = bitcast<u64>(_e673[0]);
        let _e683 = u32(_e682);
        let _e685 = u32((_e682 / 4294967296lu));
        if ((_e685 >> bitcast<u32>(31i)) == 0u) {
            phi_1007_ = array<u32, 2>();
            phi_1008_ = true;
        } else {
            if (_e685 == 2147483648u) {
                if (_e683 == 0u) {
                    phi_997_ = false;
                } else {
                    phi_997_ = true;
                }
                let _e692 = phi_997_;
                phi_998_ = _e692;
            } else {
                phi_998_ = true;
            }
            let _e694 = phi_998_;
            if _e694 {
                phi_1005_ = array<u32, 2>(~(_e683), ~(_e685));
                phi_1006_ = false;
            } else {
                phi_1005_ = array<u32, 2>();
                phi_1006_ = true;
            }
            let _e699 = phi_1005_;
            let _e701 = phi_1006_;
            phi_1007_ = _e699;
            phi_1008_ = _e701;
        }
        let _e703 = phi_1007_;
        let _e705 = phi_1008_;
        if _e705 {
            phi_1014_ = array<u32, 2>(_e683, (_e685 | 2147483648u));
        } else {
            phi_1014_ = _e703;
        }
        let _e709 = phi_1014_;
        let _e710 = bitcast<u64>(_e673[1]);
        let _e711 = u32(_e710);
        let _e713 = u32((_e710 / 4294967296lu));
        if ((_e713 >> bitcast<u32>(31i)) == 0u) {
            phi_1043_ = array<u32, 2>();
            phi_1044_ = true;
        } else {
            if (_e713 == 2147483648u) {
                if (_e711 == 0u) {
                    phi_1033_ = false;
                } else {
                    phi_1033_ = true;
                }
                let _e720 = phi_1033_;
                phi_1034_ = _e720;
            } else {
                phi_1034_ = true;
            }
            let _e722 = phi_1034_;
            if _e722 {
                phi_1041_ = array<u32, 2>(~(_e711), ~(_e713));
                phi_1042_ = false;
            } else {
                phi_1041_ = array<u32, 2>();
                phi_1042_ = true;
            }
            let _e727 = phi_1041_;
            let _e729 = phi_1042_;
            phi_1043_ = _e727;
            phi_1044_ = _e729;
        }
        let _e731 = phi_1043_;
        let _e733 = phi_1044_;
        if _e733 {
            phi_1050_ = array<u32, 2>(_e711, (_e713 | 2147483648u));
        } else {
            phi_1050_ = _e731;
        }
        let _e737 = phi_1050_;
        let _e738 = bitcast<u64>(_e673[2]);
        let _e739 = u32(_e738);
        let _e741 = u32((_e738 / 4294967296lu));
        if ((_e741 >> bitcast<u32>(31i)) == 0u) {
            phi_1079_ = array<u32, 2>();
            phi_1080_ = true;
        } else {
            if (_e741 == 2147483648u) {
                if (_e739 == 0u) {
                    phi_1069_ = false;
                } else {
                    phi_1069_ = true;
                }
                let _e748 = phi_1069_;
                phi_1070_ = _e748;
            } else {
                phi_1070_ = true;
            }
            let _e750 = phi_1070_;
            if _e750 {
                phi_1077_ = array<u32, 2>(~(_e739), ~(_e741));
                phi_1078_ = false;
            } else {
                phi_1077_ = array<u32, 2>();
                phi_1078_ = true;
            }
            let _e755 = phi_1077_;
            let _e757 = phi_1078_;
            phi_1079_ = _e755;
            phi_1080_ = _e757;
        }
        let _e759 = phi_1079_;
        let _e761 = phi_1080_;
        if _e761 {
            phi_1086_ = array<u32, 2>(_e739, (_e741 | 2147483648u));
        } else {
            phi_1086_ = _e759;
        }
        let _e765 = phi_1086_;
        let _e766 = bitcast<u64>(_e678[0]);
        let _e767 = u32(_e766);
        let _e769 = u32((_e766 / 4294967296lu));
        if ((_e769 >> bitcast<u32>(31i)) == 0u) {
            phi_1115_ = array<u32, 2>();
            phi_1116_ = true;
        } else {
            if (_e769 == 2147483648u) {
                if (_e767 == 0u) {
                    phi_1105_ = false;
                } else {
                    phi_1105_ = true;
                }
                let _e776 = phi_1105_;
                phi_1106_ = _e776;
            } else {
                phi_1106_ = true;
            }
            let _e778 = phi_1106_;
            if _e778 {
                phi_1113_ = array<u32, 2>(~(_e767), ~(_e769));
                phi_1114_ = false;
            } else {
                phi_1113_ = array<u32, 2>();
                phi_1114_ = true;
            }
            let _e783 = phi_1113_;
            let _e785 = phi_1114_;
            phi_1115_ = _e783;
            phi_1116_ = _e785;
        }
        let _e787 = phi_1115_;
        let _e789 = phi_1116_;
        if _e789 {
            phi_1122_ = array<u32, 2>(_e767, (_e769 | 2147483648u));
        } else {
            phi_1122_ = _e787;
        }
        let _e793 = phi_1122_;
        let _e794 = bitcast<u64>(_e678[1]);
        let _e795 = u32(_e794);
        let _e797 = u32((_e794 / 4294967296lu));
        if ((_e797 >> bitcast<u32>(31i)) == 0u) {
            phi_1151_ = array<u32, 2>();
            phi_1152_ = true;
        } else {
            if (_e797 == 2147483648u) {
                if (_e795 == 0u) {
                    phi_1141_ = false;
                } else {
                    phi_1141_ = true;
                }
                let _e804 = phi_1141_;
                phi_1142_ = _e804;
            } else {
                phi_1142_ = true;
            }
            let _e806 = phi_1142_;
            if _e806 {
                phi_1149_ = array<u32, 2>(~(_e795), ~(_e797));
                phi_1150_ = false;
            } else {
                phi_1149_ = array<u32, 2>();
                phi_1150_ = true;
            }
            let _e811 = phi_1149_;
            let _e813 = phi_1150_;
            phi_1151_ = _e811;
            phi_1152_ = _e813;
        }
        let _e815 = phi_1151_;
        let _e817 = phi_1152_;
        if _e817 {
            phi_1158_ = array<u32, 2>(_e795, (_e797 | 2147483648u));
        } else {
            phi_1158_ = _e815;
        }
        let _e821 = phi_1158_;
        let _e822 = bitcast<u64>(_e678[2]);
        let _e823 = u32(_e822);
        let _e825 = u32((_e822 / 4294967296lu));
        if ((_e825 >> bitcast<u32>(31i)) == 0u) {
            phi_1187_ = array<u32, 2>();
            phi_1188_ = true;
        } else {
            if (_e825 == 2147483648u) {
                if (_e823 == 0u) {
                    phi_1177_ = false;
                } else {
                    phi_1177_ = true;
                }
                let _e832 = phi_1177_;
                phi_1178_ = _e832;
            } else {
                phi_1178_ = true;
            }
            let _e834 = phi_1178_;
            if _e834 {
                phi_1185_ = array<u32, 2>(~(_e823), ~(_e825));
                phi_1186_ = false;
            } else {
                phi_1185_ = array<u32, 2>();
                phi_1186_ = true;
            }
            let _e839 = phi_1185_;
            let _e841 = phi_1186_;
            phi_1187_ = _e839;
            phi_1188_ = _e841;
        }
        let _e843 = phi_1187_;
        let _e845 = phi_1188_;
        if _e845 {
            phi_1194_ = array<u32, 2>(_e823, (_e825 | 2147483648u));
        } else {
            phi_1194_ = _e843;
        }
        let _e849 = phi_1194_;
        keys.member[_e69] = array<array<u32, 2>, 6>(_e709, _e737, _e765, _e793, _e821, _e849);
        local_1 = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
        phi_1200_ = type_9(0u, 3u);
        loop {
            let _e853 = phi_1200_;
            if (_e853.member < _e853.member_1) {
                phi_1201_ = type_9((_e853.member + 1u), _e853.member_1);
                phi_1224_ = type_9(1u, _e853.member);
            } else {
                phi_1201_ = _e853;
                phi_1224_ = type_9(0u, type_9().member_1);
            }
            let _e865 = phi_1201_;
            let _e867 = phi_1224_;
            let _e871 = (bitcast<i32>(_e867.member) != 0i);
            if _e871 {
                let _e874 = local_9.member[_e867.member_1];
                let _e875 = bitcast<u64>(_e874);
                let _e876 = u32(_e875);
                let _e878 = u32((_e875 / 4294967296lu));
                let _e879 = (_e878 & 2147483648u);
                let _e882 = ((_e878 >> bitcast<u32>(20i)) & 2047u);
                let _e888 = (((_e878 & 1048575u) << bitcast<u32>(3i)) | (_e876 >> bitcast<u32>(29i)));
                let _e889 = (_e876 & 536870911u);
                if (_e882 == 2047u) {
                    phi_1291_ = false;
                    phi_1292_ = (2139095040u | _e888);
                } else {
                    if (_e882 > 1150u) {
                        phi_1289_ = true;
                        phi_1290_ = 2139095039u;
                    } else {
                        if (_e882 > 896u) {
                            phi_1287_ = (_e889 != 0u);
                            phi_1288_ = (((_e882 - 896u) << bitcast<u32>(23i)) | _e888);
                        } else {
                            if (_e882 >= 873u) {
                                let _e897 = (8388608u | _e888);
                                let _e898 = (897u - _e882);
                                phi_1285_ = (((_e897 & ((1u << bitcast<u32>((_e898 & 31u))) - 1u)) | _e889) != 0u);
                                phi_1286_ = (_e897 >> bitcast<u32>((_e898 & 31u)));
                            } else {
                                phi_1285_ = (((_e878 & 2147483647u) | _e876) != 0u);
                                phi_1286_ = 0u;
                            }
                            let _e910 = phi_1285_;
                            let _e912 = phi_1286_;
                            phi_1287_ = _e910;
                            phi_1288_ = _e912;
                        }
                        let _e919 = phi_1287_;
                        let _e921 = phi_1288_;
                        phi_1289_ = _e919;
                        phi_1290_ = _e921;
                    }
                    let _e923 = phi_1289_;
                    let _e925 = phi_1290_;
                    phi_1291_ = _e923;
                    phi_1292_ = _e925;
                }
                let _e928 = phi_1291_;
                let _e930 = phi_1292_;
                let _e932 = bitcast<f32>((_e879 | _e930));
                let _e936 = bitcast<f32>(((_e879 | _e930) + select(0u, 1u, _e928)));
                if (_e879 == 0u) {
                    phi_1305_ = type_14(_e932, _e936);
                } else {
                    phi_1305_ = type_14(_e936, _e932);
                }
                let _e941 = phi_1305_;
                let _e943 = -(290000000000000000000000000000000000000f);
                if (_e941.member > _e943) {
                    phi_1312_ = _e941.member;
                } else {
                    phi_1312_ = _e943;
                }
                let _e946 = phi_1312_;
                if (_e946 < 290000000000000000000000000000000000000f) {
                    phi_1317_ = _e946;
                } else {
                    phi_1317_ = 290000000000000000000000000000000000000f;
                }
                let _e949 = phi_1317_;
                local_1.member[_e867.member_1] = _e949;
                let _e954 = local_9.member_1[_e867.member_1];
                let _e955 = bitcast<u64>(_e954);
                let _e956 = u32(_e955);
                let _e958 = u32((_e955 / 4294967296lu));
                let _e959 = (_e958 & 2147483648u);
                let _e962 = ((_e958 >> bitcast<u32>(20i)) & 2047u);
                let _e968 = (((_e958 & 1048575u) << bitcast<u32>(3i)) | (_e956 >> bitcast<u32>(29i)));
                let _e969 = (_e956 & 536870911u);
                if (_e962 == 2047u) {
                    phi_1384_ = false;
                    phi_1385_ = (2139095040u | _e968);
                } else {
                    if (_e962 > 1150u) {
                        phi_1382_ = true;
                        phi_1383_ = 2139095039u;
                    } else {
                        if (_e962 > 896u) {
                            phi_1380_ = (_e969 != 0u);
                            phi_1381_ = (((_e962 - 896u) << bitcast<u32>(23i)) | _e968);
                        } else {
                            if (_e962 >= 873u) {
                                let _e977 = (8388608u | _e968);
                                let _e978 = (897u - _e962);
                                phi_1378_ = (((_e977 & ((1u << bitcast<u32>((_e978 & 31u))) - 1u)) | _e969) != 0u);
                                phi_1379_ = (_e977 >> bitcast<u32>((_e978 & 31u)));
                            } else {
                                phi_1378_ = (((_e958 & 2147483647u) | _e956) != 0u);
                                phi_1379_ = 0u;
                            }
                            let _e990 = phi_1378_;
                            let _e992 = phi_1379_;
                            phi_1380_ = _e990;
                            phi_1381_ = _e992;
                        }
                        let _e999 = phi_1380_;
                        let _e1001 = phi_1381_;
                        phi_1382_ = _e999;
                        phi_1383_ = _e1001;
                    }
                    let _e1003 = phi_1382_;
                    let _e1005 = phi_1383_;
                    phi_1384_ = _e1003;
                    phi_1385_ = _e1005;
                }
                let _e1008 = phi_1384_;
                let _e1010 = phi_1385_;
                let _e1012 = bitcast<f32>((_e959 | _e1010));
                let _e1016 = bitcast<f32>(((_e959 | _e1010) + select(0u, 1u, _e1008)));
                if (_e959 == 0u) {
                    phi_1398_ = type_14(_e1012, _e1016);
                } else {
                    phi_1398_ = type_14(_e1016, _e1012);
                }
                let _e1021 = phi_1398_;
                let _e1023 = -(290000000000000000000000000000000000000f);
                if (_e1021.member_1 > _e1023) {
                    phi_1405_ = _e1021.member_1;
                } else {
                    phi_1405_ = _e1023;
                }
                let _e1026 = phi_1405_;
                if (_e1026 < 290000000000000000000000000000000000000f) {
                    phi_1410_ = _e1026;
                } else {
                    phi_1410_ = 290000000000000000000000000000000000000f;
                }
                let _e1029 = phi_1410_;
                local_1.member_1[_e867.member_1] = _e1029;
            }
            continue;
            continuing {
                phi_1200_ = _e865;
                break if !(_e871);
            }
        }
        let _e1033 = local_1;
        local = _e1033;
        phi_1443_ = type_9(0u, 3u);
        loop {
            let _e1035 = phi_1443_;
            if (_e1035.member < _e1035.member_1) {
                phi_1444_ = type_9((_e1035.member + 1u), _e1035.member_1);
                phi_1467_ = type_9(1u, _e1035.member);
            } else {
                phi_1444_ = _e1035;
                phi_1467_ = type_9(0u, type_9().member_1);
            }
            let _e1047 = phi_1444_;
            let _e1049 = phi_1467_;
            let _e1053 = (bitcast<i32>(_e1049.member) != 0i);
            if _e1053 {
                let _e1056 = local.member[_e1049.member_1];
                if (_e1056 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1488_ = (_e1056 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1488_ = false;
                }
                let _e1061 = phi_1488_;
                if _e1061 {
                    let _e1067 = local_9.member[_e1049.member_1];
                    let _e1069 = bitcast<u64>(-(_e1067));
                    let _e1072 = u32((_e1069 / 4294967296lu));
                    if ((_e1072 >> bitcast<u32>(31i)) == 0u) {
                        phi_1511_ = ((u32(_e1069) | _e1072) != 0u);
                    } else {
                        phi_1511_ = false;
                    }
                    let _e1079 = phi_1511_;
                    if _e1079 {
                        phi_1515_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1515_ = 0f;
                    }
                    let _e1081 = phi_1515_;
                    phi_1524_ = -(_e1081);
                } else {
                    let _e1064 = local.member[_e1049.member_1];
                    phi_1524_ = _e1064;
                }
                let _e1084 = phi_1524_;
                local.member[_e1049.member_1] = _e1084;
                let _e1089 = local.member_1[_e1049.member_1];
                if (_e1089 < 0.000000000000000000000000000000000000011754944f) {
                    phi_1545_ = (_e1089 > -(0.000000000000000000000000000000000000011754944f));
                } else {
                    phi_1545_ = false;
                }
                let _e1094 = phi_1545_;
                if _e1094 {
                    let _e1100 = local_9.member_1[_e1049.member_1];
                    let _e1101 = bitcast<u64>(_e1100);
                    let _e1104 = u32((_e1101 / 4294967296lu));
                    if ((_e1104 >> bitcast<u32>(31i)) == 0u) {
                        phi_1568_ = ((u32(_e1101) | _e1104) != 0u);
                    } else {
                        phi_1568_ = false;
                    }
                    let _e1111 = phi_1568_;
                    if _e1111 {
                        phi_1572_ = 0.000000000000000000000000000000000000011754944f;
                    } else {
                        phi_1572_ = 0f;
                    }
                    let _e1113 = phi_1572_;
                    phi_1581_ = _e1113;
                } else {
                    let _e1097 = local.member_1[_e1049.member_1];
                    phi_1581_ = _e1097;
                }
                let _e1115 = phi_1581_;
                local.member_1[_e1049.member_1] = _e1115;
            }
            continue;
            continuing {
                phi_1443_ = _e1047;
                break if !(_e1053);
            }
        }
        let _e1119 = local;
        boxes.member[_e69] = type_20(array<f32, 3>(_e1119.member[0], _e1119.member[1], _e1119.member[2]), array<f32, 3>(_e1119.member_1[0], _e1119.member_1[1], _e1119.member_1[2]));
    }
    return;
}

@compute @workgroup_size(256, 1, 1) 
fn place_vertices(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
