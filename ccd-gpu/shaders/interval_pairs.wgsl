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
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_21 {
    member: type_16,
    member_1: array<f32, 3>,
}

struct type_22 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_23 {
    member: type_7,
    member_1: type_8,
    member_2: type_22,
}

struct type_24 {
    member: type_23,
}

struct type_25 {
    member: type_21,
    member_1: u32,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(2) 
var<storage> keys: type_11;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_29;
@group(0) @binding(0) 
var<storage> params: type_24;
@group(0) @binding(1) 
var<storage> sorted: type_18;
@group(0) @binding(3) 
var<storage> order: type_11;
@group(0) @binding(4) 
var<storage> survey: type_11;
@group(0) @binding(5) 
var<storage> work: type_11;
var<workgroup> boxes: array<type_16, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var local_1: type_16;
    var local_2: type_21;
    var local_3: array<f32, 3>;
    var local_4: type_16;
    var local_5: type_16;
    var local_6: type_21;
    var local_7: type_16;
    var phi_196_: u32;
    var phi_206_: u32;
    var phi_213_: u32;
    var phi_232_: u32;
    var phi_253_: u32;
    var phi_254_: u32;
    var phi_257_: type_9;
    var phi_258_: type_9;
    var phi_281_: type_9;
    var phi_337_: array<u32, 2>;
    var phi_344_: u32;
    var phi_349_: u32;
    var phi_357_: array<u32, 2>;
    var phi_395_: array<u32, 2>;
    var phi_402_: u32;
    var phi_407_: u32;
    var phi_415_: array<u32, 2>;
    var phi_460_: u32;
    var phi_469_: u32;
    var phi_474_: u32;
    var phi_477_: bool;
    var phi_492_: u32;
    var phi_493_: u32;
    var phi_494_: u32;
    var phi_495_: bool;
    var phi_499_: u32;
    var phi_521_: u32;
    var phi_540_: u32;
    var phi_559_: u32;
    var phi_564_: type_9;
    var phi_565_: type_9;
    var phi_588_: type_9;
    var phi_614_: u32;
    var phi_640_: u32;
    var phi_773_: type_9;
    var phi_776_: type_25;
    var phi_774_: type_9;
    var phi_799_: type_9;
    var phi_809_: type_9;
    var phi_812_: bool;
    var phi_810_: type_9;
    var phi_835_: type_9;
    var phi_857_: f32;
    var phi_874_: bool;
    var phi_813_: bool;
    var local_8: bool;
    var phi_880_: type_25;
    var phi_881_: bool;
    var phi_777_: type_25;
    var phi_882_: bool;
    var phi_890_: u32;
    var local_9: type_25;
    var local_10: type_25;
    var local_11: type_25;
    var phi_900_: u32;
    var local_12: type_25;
    var phi_907_: u32;
    var local_13: type_25;
    var local_14: type_25;
    var local_15: type_25;
    var phi_939_: type_9;
    var phi_940_: type_9;
    var phi_963_: type_9;
    var phi_1014_: f32;
    var phi_1019_: f32;
    var phi_1060_: type_9;
    var phi_1061_: type_9;
    var phi_1084_: type_9;
    var phi_1144_: u32;
    var phi_1145_: u32;
    var phi_1157_: array<u32, 3>;
    var phi_1158_: array<u32, 3>;
    var phi_1225_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1281_: bool;
    var phi_1282_: bool;
    var phi_1288_: u32;
    var phi_1289_: bool;
    var phi_1290_: u32;
    var phi_1291_: bool;
    var phi_1296_: u32;
    var phi_1306_: u32;
    var phi_1320_: array<u32, 2>;
    var phi_1321_: array<u32, 2>;
    var phi_1322_: bool;
    var phi_1323_: array<u32, 2>;
    var phi_1324_: bool;
    var phi_1325_: array<u32, 2>;
    var phi_1326_: bool;
    var phi_1331_: array<u32, 2>;
    var phi_1332_: array<u32, 2>;
    var phi_1340_: array<u32, 2>;
    var phi_1341_: bool;
    var phi_1342_: array<u32, 2>;
    var phi_1343_: bool;
    var phi_1348_: array<u32, 2>;
    var phi_1355_: array<u32, 2>;
    var phi_1192_: f32;
    var phi_1193_: f32;
    var phi_1199_: u32;
    var phi_1209_: u32;
    var phi_1356_: array<u32, 2>;
    var phi_1364_: u32;
    var phi_1367_: array<u32, 3>;
    var phi_1384_: type_16;
    var phi_1387_: type_9;
    var phi_1388_: type_9;
    var phi_1411_: type_9;
    var phi_1446_: type_16;
    var phi_1447_: u32;
    var phi_1468_: type_9;
    var phi_1469_: type_9;
    var phi_1492_: type_9;
    var phi_1616_: u32;
    var phi_1621_: u32;
    var phi_1637_: type_9;
    var phi_1605_: type_9;
    var phi_1638_: type_9;
    var phi_1673_: u32;
    var phi_1699_: type_9;
    var phi_1700_: type_9;
    var phi_1723_: type_9;
    var phi_1754_: array<u32, 2>;
    var phi_1761_: u32;
    var phi_1766_: u32;
    var phi_1774_: array<u32, 2>;
    var phi_1848_: u32;
    var phi_1853_: u32;
    var phi_1869_: type_9;
    var phi_1837_: type_9;
    var phi_1870_: type_9;
    var phi_1888_: bool;
    var phi_1889_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e86 = id_2;
    let _e87 = n_2;
    let _e88 = lane_2;
    let _e100 = ((_e86.y * _e87.x) + _e86.x);
    let _e103 = (_e87.x * _e87.y);
    let _e106 = params.member.member_1.member_2;
    let _e108 = work.member[0u];
    if (_e106 < _e108) {
        phi_196_ = _e106;
    } else {
        phi_196_ = _e108;
    }
    let _e111 = phi_196_;
    let _e113 = params.member.member_1.member_1;
    if (_e111 > _e113) {
        let _e116 = params.member.member_1.member_1;
        phi_206_ = (_e111 - _e116);
    } else {
        phi_206_ = 0u;
    }
    let _e119 = phi_206_;
    let _e121 = params.member.member_1.member;
    if (_e121 < _e119) {
        phi_213_ = _e121;
    } else {
        phi_213_ = _e119;
    }
    let _e124 = phi_213_;
    let _e128 = params.member.member.member_2[3u];
    if false {
        phi_232_ = (_e124 + 1u);
    } else {
        phi_232_ = _e124;
    }
    let _e131 = phi_232_;
    if (_e131 > _e100) {
        let _e133 = (_e131 - _e100);
        if (_e103 == 0u) {
            return;
        }
        let _e135 = (_e133 / _e103);
        if (_e103 == 0u) {
            return;
        }
        if ((_e133 % _e103) > 0u) {
            phi_253_ = (_e135 + 1u);
        } else {
            phi_253_ = _e135;
        }
        let _e141 = phi_253_;
        phi_254_ = _e141;
    } else {
        phi_254_ = 0u;
    }
    let _e143 = phi_254_;
    phi_257_ = type_9(0u, _e143);
    loop {
        let _e146 = phi_257_;
        if (_e146.member < _e146.member_1) {
            phi_258_ = type_9((_e146.member + 1u), _e146.member_1);
            phi_281_ = type_9(1u, _e146.member);
        } else {
            phi_258_ = _e146;
            phi_281_ = type_9(0u, type_9().member_1);
        }
        let _e158 = phi_258_;
        let _e160 = phi_281_;
        let _e164 = (bitcast<i32>(_e160.member) != 0i);
        if _e164 {
            let _e167 = params.member.member_1.member_1;
            let _e171 = (2u * ((_e167 + _e100) + (_e160.member_1 * _e103)));
            let _e174 = work.member[(4u + _e171)];
            let _e177 = work.member[(_e171 + 5u)];
            let _e179 = (_e174 >> bitcast<u32>(24i));
            let _e183 = (_e174 & 16777215u);
            let _e187 = params.member.member_2.member;
            let _e190 = params.member.member_2.member_1;
            if (_e190 == 0u) {
                phi_337_ = array<u32, 2>(0u, 2u);
            } else {
                phi_337_ = array<u32, 2>(1u, 1u);
            }
            let _e193 = phi_337_;
            if (_e187 == 2u) {
                phi_344_ = 8u;
            } else {
                phi_344_ = 1u;
            }
            let _e198 = phi_344_;
            if (_e187 == 2u) {
                phi_349_ = 10u;
            } else {
                phi_349_ = 1u;
            }
            let _e201 = phi_349_;
            if (_e179 >= (_e198 * _e201)) {
                phi_357_ = array<u32, 2>(_e193[1], _e193[0]);
            } else {
                phi_357_ = _e193;
            }
            let _e206 = phi_357_;
            let _e209 = ((_e183 * 128u) + _e88);
            let _e213 = params.member.member.member_2[_e206[0]];
            let _e214 = (_e213 + _e209);
            let _e218 = params.member.member.member[_e206[0]];
            let _e219 = (_e209 < _e218);
            if _e219 {
                let _e222 = params.member.member_2.member;
                let _e225 = params.member.member_2.member_1;
                if (_e225 == 0u) {
                    phi_395_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_395_ = array<u32, 2>(1u, 1u);
                }
                let _e228 = phi_395_;
                if (_e222 == 2u) {
                    phi_402_ = 8u;
                } else {
                    phi_402_ = 1u;
                }
                let _e233 = phi_402_;
                if (_e222 == 2u) {
                    phi_407_ = 10u;
                } else {
                    phi_407_ = 1u;
                }
                let _e236 = phi_407_;
                if (_e179 >= (_e233 * _e236)) {
                    phi_415_ = array<u32, 2>(_e228[1], _e228[0]);
                } else {
                    phi_415_ = _e228;
                }
                let _e241 = phi_415_;
                let _e244 = keys.member[_e214];
                let _e246 = sorted.member[_e214];
                local_7 = type_16(array<f32, 3>(_e246.member[0], _e246.member[1], _e246.member[2]), array<f32, 3>(_e246.member_1[0], _e246.member_1[1], _e246.member_1[2]));
                if (_e222 == 2u) {
                    phi_460_ = ((_e179 % 80u) / 10u);
                } else {
                    phi_460_ = 0u;
                }
                let _e262 = phi_460_;
                if (_e262 == 0u) {
                    if (_e222 == 2u) {
                        phi_469_ = 8u;
                    } else {
                        phi_469_ = 1u;
                    }
                    let _e266 = phi_469_;
                    if (_e222 == 2u) {
                        phi_474_ = 10u;
                    } else {
                        phi_474_ = 1u;
                    }
                    let _e269 = phi_474_;
                    phi_477_ = (_e179 >= (_e266 * _e269));
                } else {
                    phi_477_ = false;
                }
                let _e273 = phi_477_;
                if (_e222 != 2u) {
                    phi_494_ = u32();
                    phi_495_ = true;
                } else {
                    if _e273 {
                        phi_493_ = u32();
                    } else {
                        let _e278 = (((_e244 >> bitcast<u32>(27u)) % 8u) + _e262);
                        if (_e278 < 8u) {
                            phi_492_ = _e278;
                        } else {
                            phi_492_ = 8u;
                        }
                        let _e281 = phi_492_;
                        phi_493_ = _e281;
                    }
                    let _e283 = phi_493_;
                    phi_494_ = _e283;
                    phi_495_ = _e273;
                }
                let _e285 = phi_494_;
                let _e287 = phi_495_;
                if _e287 {
                    phi_499_ = 8u;
                } else {
                    phi_499_ = _e285;
                }
                let _e289 = phi_499_;
                if (_e222 == 2u) {
                    let _e292 = survey.member[6u];
                    if ((_e292 >> bitcast<u32>(31i)) == 1u) {
                        phi_521_ = (_e292 & 2147483647u);
                    } else {
                        phi_521_ = ~(_e292);
                    }
                    let _e299 = phi_521_;
                    let _e300 = bitcast<f32>(_e299);
                    let _e302 = survey.member[7u];
                    if ((_e302 >> bitcast<u32>(31i)) == 1u) {
                        phi_540_ = (_e302 & 2147483647u);
                    } else {
                        phi_540_ = ~(_e302);
                    }
                    let _e309 = phi_540_;
                    let _e310 = bitcast<f32>(_e309);
                    let _e312 = survey.member[8u];
                    if ((_e312 >> bitcast<u32>(31i)) == 1u) {
                        phi_559_ = (_e312 & 2147483647u);
                    } else {
                        phi_559_ = ~(_e312);
                    }
                    let _e319 = phi_559_;
                    let _e320 = bitcast<f32>(_e319);
                    local_5 = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                    phi_564_ = type_9(0u, 3u);
                    loop {
                        let _e322 = phi_564_;
                        if (_e322.member < _e322.member_1) {
                            phi_565_ = type_9((_e322.member + 1u), _e322.member_1);
                            phi_588_ = type_9(1u, _e322.member);
                        } else {
                            phi_565_ = _e322;
                            phi_588_ = type_9(0u, type_9().member_1);
                        }
                        let _e334 = phi_565_;
                        let _e336 = phi_588_;
                        let _e340 = (bitcast<i32>(_e336.member) != 0i);
                        if _e340 {
                            let _e342 = survey.member[_e336.member_1];
                            let _e343 = ~(_e342);
                            if ((_e343 >> bitcast<u32>(31i)) == 1u) {
                                phi_614_ = (_e343 & 2147483647u);
                            } else {
                                phi_614_ = ~(_e343);
                            }
                            let _e350 = phi_614_;
                            local_5.member[_e336.member_1] = bitcast<f32>(_e350);
                            let _e356 = survey.member[(3u + _e336.member_1)];
                            if ((_e356 >> bitcast<u32>(31i)) == 1u) {
                                phi_640_ = (_e356 & 2147483647u);
                            } else {
                                phi_640_ = ~(_e356);
                            }
                            let _e363 = phi_640_;
                            local_5.member_1[_e336.member_1] = bitcast<f32>(_e363);
                        }
                        continue;
                        continuing {
                            phi_564_ = _e334;
                            break if !(_e340);
                        }
                    }
                    let _e368 = local_5;
                    local_6 = type_21(_e368, array<f32, 3>(_e300, _e310, _e320));
                    if (_e262 == 0u) {
                        let _e672 = (_e244 & 134217727u);
                        phi_1157_ = array<u32, 3>((_e672 & 511u), ((_e672 >> bitcast<u32>(9u)) & 511u), (_e672 >> bitcast<u32>(18u)));
                    } else {
                        let _e389 = local_6.member.member_1[0u];
                        let _e393 = local_6.member.member[0u];
                        let _e398 = local_6.member.member_1[1u];
                        let _e402 = local_6.member.member[1u];
                        let _e407 = local_6.member.member_1[2u];
                        let _e411 = local_6.member.member[2u];
                        local_3 = array<f32, 3>(((_e389 * 0.5f) - (_e393 * 0.5f)), ((_e398 * 0.5f) - (_e402 * 0.5f)), ((_e407 * 0.5f) - (_e411 * 0.5f)));
                        phi_773_ = type_9(0u, 9u);
                        phi_776_ = type_25(type_21(type_16(array<f32, 3>(_e368.member[0], _e368.member[1], _e368.member[2]), array<f32, 3>(_e368.member_1[0], _e368.member_1[1], _e368.member_1[2])), array<f32, 3>(_e300, _e310, _e320)), 0u);
                        loop {
                            let _e416 = phi_773_;
                            let _e418 = phi_776_;
                            local_9 = _e418;
                            local_10 = _e418;
                            local_11 = _e418;
                            local_12 = _e418;
                            local_13 = _e418;
                            local_14 = _e418;
                            local_15 = _e418;
                            if (_e416.member < _e416.member_1) {
                                phi_774_ = type_9((_e416.member + 1u), _e416.member_1);
                                phi_799_ = type_9(1u, _e416.member);
                            } else {
                                phi_774_ = _e416;
                                phi_799_ = type_9(0u, type_9().member_1);
                            }
                            let _e430 = phi_774_;
                            let _e432 = phi_799_;
                            if (bitcast<i32>(_e432.member) != 0i) {
                                phi_809_ = type_9(0u, 3u);
                                phi_812_ = true;
                                loop {
                                    let _e438 = phi_809_;
                                    let _e440 = phi_812_;
                                    local_8 = _e440;
                                    if (_e438.member < _e438.member_1) {
                                        phi_810_ = type_9((_e438.member + 1u), _e438.member_1);
                                        phi_835_ = type_9(1u, _e438.member);
                                    } else {
                                        phi_810_ = _e438;
                                        phi_835_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e452 = phi_810_;
                                    let _e454 = phi_835_;
                                    let _e458 = (bitcast<i32>(_e454.member) != 0i);
                                    if _e458 {
                                        let _e460 = local_3[_e454.member_1];
                                        let _e462 = (_e460 * (1f / 512f));
                                        if (_e462 > 0.000000000000000000000000000006310887f) {
                                            phi_857_ = _e462;
                                        } else {
                                            phi_857_ = 0.000000000000000000000000000006310887f;
                                        }
                                        let _e465 = phi_857_;
                                        let _e468 = local_6.member_1[_e454.member_1];
                                        if ((_e468 * bitcast<f32>(((127u - _e432.member_1) << bitcast<u32>(23i)))) > _e465) {
                                            phi_874_ = false;
                                        } else {
                                            phi_874_ = _e440;
                                        }
                                        let _e476 = phi_874_;
                                        phi_813_ = _e476;
                                    } else {
                                        phi_813_ = bool();
                                    }
                                    let _e478 = phi_813_;
                                    continue;
                                    continuing {
                                        phi_809_ = _e452;
                                        phi_812_ = _e478;
                                        break if !(_e458);
                                    }
                                }
                                let _e481 = local_8;
                                if _e481 {
                                    phi_880_ = type_25();
                                    phi_881_ = false;
                                } else {
                                    phi_880_ = type_25(_e418.member, (_e432.member_1 + 1u));
                                    phi_881_ = true;
                                }
                                let _e486 = phi_880_;
                                let _e488 = phi_881_;
                                phi_777_ = _e486;
                                phi_882_ = _e488;
                            } else {
                                phi_777_ = type_25();
                                phi_882_ = false;
                            }
                            let _e490 = phi_777_;
                            let _e492 = phi_882_;
                            continue;
                            continuing {
                                phi_773_ = _e430;
                                phi_776_ = _e490;
                                break if !(_e492);
                            }
                        }
                        let _e497 = (((_e244 >> bitcast<u32>(27u)) % 8u) + _e262);
                        if (_e497 < 8u) {
                            phi_890_ = _e497;
                        } else {
                            phi_890_ = 8u;
                        }
                        let _e500 = phi_890_;
                        let _e502 = local_9;
                        let _e507 = local_10;
                        if (_e507.member_1 < 8u) {
                            let _e511 = local_11;
                            phi_900_ = (_e511.member_1 + 1u);
                        } else {
                            phi_900_ = 8u;
                        }
                        let _e515 = phi_900_;
                        if ((_e500 + 1u) >= _e515) {
                            phi_907_ = 0u;
                        } else {
                            let _e518 = local_12;
                            phi_907_ = (_e518.member_1 - _e500);
                        }
                        let _e522 = phi_907_;
                        let _e526 = bitcast<f32>(((127u - _e522) << bitcast<u32>(23i)));
                        let _e528 = local_13;
                        let _e534 = local_14;
                        let _e540 = local_15;
                        local_2.member = type_16(array<f32, 3>(_e502.member.member.member[0], _e502.member.member.member[1], _e502.member.member.member[2]), array<f32, 3>(_e502.member.member.member_1[0], _e502.member.member.member_1[1], _e502.member.member.member_1[2]));
                        local_2.member_1 = array<f32, 3>((_e528.member.member_1[0] * _e526), (_e534.member.member_1[1] * _e526), (_e540.member.member_1[2] * _e526));
                        local_1.member = array<f32, 3>(0f, 0f, 0f);
                        local_1.member_1 = array<f32, 3>(0f, 0f, 0f);
                        phi_939_ = type_9(0u, 3u);
                        loop {
                            let _e562 = phi_939_;
                            if (_e562.member < _e562.member_1) {
                                phi_940_ = type_9((_e562.member + 1u), _e562.member_1);
                                phi_963_ = type_9(1u, _e562.member);
                            } else {
                                phi_940_ = _e562;
                                phi_963_ = type_9(0u, type_9().member_1);
                            }
                            let _e574 = phi_940_;
                            let _e576 = phi_963_;
                            let _e580 = (bitcast<i32>(_e576.member) != 0i);
                            if _e580 {
                                let _e584 = local_2.member.member[_e576.member_1];
                                let _e588 = local_2.member.member_1[_e576.member_1];
                                let _e593 = (((_e588 * 0.5f) - (_e584 * 0.5f)) * (1f / 512f));
                                let _e596 = local_2.member_1[_e576.member_1];
                                let _e599 = local_2.member_1[_e576.member_1];
                                let _e601 = (_e596 + (_e599 * 0.00390625f));
                                if (_e593 > _e601) {
                                    phi_1014_ = _e593;
                                } else {
                                    phi_1014_ = _e601;
                                }
                                let _e604 = phi_1014_;
                                if (0.000000000000000000000000000006310887f > _e604) {
                                    phi_1019_ = 0.000000000000000000000000000006310887f;
                                } else {
                                    phi_1019_ = _e604;
                                }
                                let _e607 = phi_1019_;
                                local_1.member[_e576.member_1] = (_e584 * 0.25f);
                                local_1.member_1[_e576.member_1] = (1f / _e607);
                            }
                            continue;
                            continuing {
                                phi_939_ = _e574;
                                break if !(_e580);
                            }
                        }
                        let _e615 = local_1;
                        local_4 = _e615;
                        local = array<u32, 3>(0u, 0u, 0u);
                        phi_1060_ = type_9(0u, 3u);
                        loop {
                            let _e617 = phi_1060_;
                            if (_e617.member < _e617.member_1) {
                                phi_1061_ = type_9((_e617.member + 1u), _e617.member_1);
                                phi_1084_ = type_9(1u, _e617.member);
                            } else {
                                phi_1061_ = _e617;
                                phi_1084_ = type_9(0u, type_9().member_1);
                            }
                            let _e629 = phi_1061_;
                            let _e631 = phi_1084_;
                            let _e635 = (bitcast<i32>(_e631.member) != 0i);
                            if _e635 {
                                let _e638 = local_4.member[_e631.member_1];
                                let _e641 = local_7.member[_e631.member_1];
                                let _e646 = local_7.member_1[_e631.member_1];
                                let _e652 = local_4.member_1[_e631.member_1];
                                let _e653 = ((((_e641 * 0.25f) - _e638) + ((_e646 * 0.25f) - _e638)) * _e652);
                                if (_e653 >= 511f) {
                                    phi_1145_ = 511u;
                                } else {
                                    if (_e653 > 0f) {
                                        phi_1144_ = select(select(u32(_e653), 0u, (_e653 < 0f)), 4294967295u, (_e653 > 4294967000f));
                                    } else {
                                        phi_1144_ = 0u;
                                    }
                                    let _e662 = phi_1144_;
                                    phi_1145_ = _e662;
                                }
                                let _e664 = phi_1145_;
                                local[_e631.member_1] = _e664;
                            }
                            continue;
                            continuing {
                                phi_1060_ = _e629;
                                break if !(_e635);
                            }
                        }
                        let _e667 = local;
                        phi_1157_ = array<u32, 3>(_e667[0], _e667[1], _e667[2]);
                    }
                    let _e681 = phi_1157_;
                    phi_1158_ = _e681;
                } else {
                    phi_1158_ = array<u32, 3>(0u, 0u, 0u);
                }
                let _e683 = phi_1158_;
                let _e685 = (_e241[1] << bitcast<u32>(30u));
                if (_e222 == 1u) {
                    let _e807 = survey.member[6u];
                    if (_e807 == 0u) {
                        let _e817 = local_7.member_1[0u];
                        phi_1193_ = _e817;
                    } else {
                        if (_e807 == 1u) {
                            let _e813 = local_7.member_1[1u];
                            phi_1192_ = _e813;
                        } else {
                            let _e811 = local_7.member_1[2u];
                            phi_1192_ = _e811;
                        }
                        let _e815 = phi_1192_;
                        phi_1193_ = _e815;
                    }
                    let _e819 = phi_1193_;
                    let _e820 = bitcast<u32>(_e819);
                    if (_e820 == 2147483648u) {
                        phi_1199_ = 0u;
                    } else {
                        phi_1199_ = _e820;
                    }
                    let _e823 = phi_1199_;
                    let _e825 = bitcast<u32>(bitcast<f32>(_e823));
                    if ((_e825 >> bitcast<u32>(31i)) == 1u) {
                        phi_1209_ = ~(_e825);
                    } else {
                        phi_1209_ = (_e825 | 2147483648u);
                    }
                    let _e832 = phi_1209_;
                    phi_1356_ = array<u32, 2>(((_e685 | (_e244 & 1073741823u)) + _e179), (_e685 | (_e832 >> bitcast<u32>(2i))));
                } else {
                    if (_e222 == 2u) {
                        let _e689 = (_e179 % 80u);
                        let _e691 = (_e689 % 10u);
                        if (_e225 == 1u) {
                            phi_1225_ = ((_e689 / 10u) == 0u);
                        } else {
                            phi_1225_ = false;
                        }
                        let _e695 = phi_1225_;
                        if (_e289 >= 8u) {
                            phi_1342_ = array<u32, 2>();
                            phi_1343_ = true;
                        } else {
                            if _e695 {
                                if (_e691 < 4u) {
                                    phi_1237_ = false;
                                } else {
                                    phi_1237_ = true;
                                }
                                let _e699 = phi_1237_;
                                phi_1238_ = _e699;
                            } else {
                                phi_1238_ = true;
                            }
                            let _e701 = phi_1238_;
                            if _e701 {
                                if (_e691 == 9u) {
                                    phi_1332_ = array<u32, 2>(0u, 134217727u);
                                } else {
                                    let _e705 = (_e683[1] + (_e691 % 3u));
                                    let _e708 = (_e683[2] + (_e691 / 3u));
                                    if (_e705 < 1u) {
                                        phi_1325_ = array<u32, 2>();
                                        phi_1326_ = true;
                                    } else {
                                        if (_e708 < 1u) {
                                            phi_1323_ = array<u32, 2>();
                                            phi_1324_ = true;
                                        } else {
                                            if (_e705 > 512u) {
                                                phi_1321_ = array<u32, 2>();
                                                phi_1322_ = true;
                                            } else {
                                                let _e712 = (_e708 > 512u);
                                                if _e712 {
                                                    phi_1320_ = array<u32, 2>();
                                                } else {
                                                    if (_e683[0] > 0u) {
                                                        if _e695 {
                                                            if (_e691 == 4u) {
                                                                phi_1281_ = false;
                                                            } else {
                                                                phi_1281_ = true;
                                                            }
                                                            let _e717 = phi_1281_;
                                                            phi_1282_ = _e717;
                                                        } else {
                                                            phi_1282_ = true;
                                                        }
                                                        let _e719 = phi_1282_;
                                                        if _e719 {
                                                            phi_1288_ = (_e683[0] - 1u);
                                                            phi_1289_ = false;
                                                        } else {
                                                            phi_1288_ = u32();
                                                            phi_1289_ = true;
                                                        }
                                                        let _e723 = phi_1288_;
                                                        let _e725 = phi_1289_;
                                                        phi_1290_ = _e723;
                                                        phi_1291_ = _e725;
                                                    } else {
                                                        phi_1290_ = u32();
                                                        phi_1291_ = true;
                                                    }
                                                    let _e727 = phi_1290_;
                                                    let _e729 = phi_1291_;
                                                    if _e729 {
                                                        phi_1296_ = _e683[0];
                                                    } else {
                                                        phi_1296_ = _e727;
                                                    }
                                                    let _e732 = phi_1296_;
                                                    if ((_e683[0] + 1u) < 512u) {
                                                        phi_1306_ = (_e683[0] + 1u);
                                                    } else {
                                                        phi_1306_ = _e683[0];
                                                    }
                                                    let _e740 = phi_1306_;
                                                    phi_1320_ = array<u32, 2>(((((_e708 - 1u) << bitcast<u32>(18u)) | ((_e705 - 1u) << bitcast<u32>(9u))) | _e732), ((((_e708 - 1u) << bitcast<u32>(18u)) | ((_e705 - 1u) << bitcast<u32>(9u))) | _e740));
                                                }
                                                let _e759 = phi_1320_;
                                                phi_1321_ = _e759;
                                                phi_1322_ = _e712;
                                            }
                                            let _e761 = phi_1321_;
                                            let _e763 = phi_1322_;
                                            phi_1323_ = _e761;
                                            phi_1324_ = _e763;
                                        }
                                        let _e765 = phi_1323_;
                                        let _e767 = phi_1324_;
                                        phi_1325_ = _e765;
                                        phi_1326_ = _e767;
                                    }
                                    let _e769 = phi_1325_;
                                    let _e771 = phi_1326_;
                                    if _e771 {
                                        phi_1331_ = array<u32, 2>(1u, 0u);
                                    } else {
                                        phi_1331_ = _e769;
                                    }
                                    let _e773 = phi_1331_;
                                    phi_1332_ = _e773;
                                }
                                let _e775 = phi_1332_;
                                phi_1340_ = array<u32, 2>(((_e289 << bitcast<u32>(27u)) | _e775[0]), ((_e289 << bitcast<u32>(27u)) | _e775[1]));
                                phi_1341_ = false;
                            } else {
                                phi_1340_ = array<u32, 2>();
                                phi_1341_ = true;
                            }
                            let _e786 = phi_1340_;
                            let _e788 = phi_1341_;
                            phi_1342_ = _e786;
                            phi_1343_ = _e788;
                        }
                        let _e790 = phi_1342_;
                        let _e792 = phi_1343_;
                        if _e792 {
                            phi_1348_ = array<u32, 2>(1u, 0u);
                        } else {
                            phi_1348_ = _e790;
                        }
                        let _e794 = phi_1348_;
                        phi_1355_ = array<u32, 2>((_e685 | _e794[0]), (_e685 | _e794[1]));
                    } else {
                        phi_1355_ = array<u32, 2>(_e685, _e685);
                    }
                    let _e801 = phi_1355_;
                    phi_1356_ = _e801;
                }
                let _e838 = phi_1356_;
                if (_e225 == 1u) {
                    phi_1364_ = (_e214 + 1u);
                } else {
                    phi_1364_ = 0u;
                }
                let _e844 = phi_1364_;
                phi_1367_ = array<u32, 3>(_e838[0], _e838[1], _e844);
            } else {
                phi_1367_ = array<u32, 3>(4294967295u, 0u, 0u);
            }
            let _e847 = phi_1367_;
            if _e219 {
                let _e852 = sorted.member[_e214];
                phi_1384_ = _e852;
            } else {
                phi_1384_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e854 = phi_1384_;
            phi_1387_ = type_9(0u, ((_e177 >> bitcast<u32>(29i)) + 1u));
            loop {
                let _e857 = phi_1387_;
                if (_e857.member < _e857.member_1) {
                    phi_1388_ = type_9((_e857.member + 1u), _e857.member_1);
                    phi_1411_ = type_9(1u, _e857.member);
                } else {
                    phi_1388_ = _e857;
                    phi_1411_ = type_9(0u, type_9().member_1);
                }
                let _e869 = phi_1388_;
                let _e871 = phi_1411_;
                let _e875 = (bitcast<i32>(_e871.member) != 0i);
                if _e875 {
                    let _e877 = ((_e177 & 536870911u) + (_e871.member_1 * 128u));
                    let _e878 = (_e877 + _e88);
                    if (_e878 < _e128) {
                        let _e881 = keys.member[_e878];
                        let _e883 = sorted.member[_e878];
                        phi_1446_ = _e883;
                        phi_1447_ = _e881;
                    } else {
                        phi_1446_ = type_16(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_1447_ = 4294967295u;
                    }
                    let _e885 = phi_1446_;
                    let _e887 = phi_1447_;
                    names[_e88] = _e887;
                    boxes[_e88] = type_16(array<f32, 3>(_e885.member[0], _e885.member[1], _e885.member[2]), array<f32, 3>(_e885.member_1[0], _e885.member_1[1], _e885.member_1[2]));
                    if (_e88 == 0u) {
                        atomicStore((&counters[0u]), 0u);
                    }
                    workgroupBarrier();
                    phi_1468_ = type_9(0u, 128u);
                    loop {
                        let _e904 = phi_1468_;
                        if (_e904.member < _e904.member_1) {
                            phi_1469_ = type_9((_e904.member + 1u), _e904.member_1);
                            phi_1492_ = type_9(1u, _e904.member);
                        } else {
                            phi_1469_ = _e904;
                            phi_1492_ = type_9(0u, type_9().member_1);
                        }
                        let _e916 = phi_1469_;
                        let _e918 = phi_1492_;
                        let _e922 = (bitcast<i32>(_e918.member) != 0i);
                        if _e922 {
                            let _e924 = names[_e918.member_1];
                            if (_e924 >= _e847[0]) {
                                if (_e924 <= _e847[1]) {
                                    if ((_e877 + _e918.member_1) >= _e847[2]) {
                                        let _e930 = boxes[_e918.member_1];
                                        if ((((((_e854.member[0] <= _e930.member_1[0]) && (_e930.member[0] <= _e854.member_1[0])) && (_e854.member[1] <= _e930.member_1[1])) && (_e930.member[1] <= _e854.member_1[1])) && (_e854.member[2] <= _e930.member_1[2])) && (_e930.member[2] <= _e854.member_1[2])) {
                                            let _e963 = atomicAdd((&counters[0u]), 1u);
                                            if (_e963 < 2048u) {
                                                hits[_e963] = ((_e88 << bitcast<u32>(7i)) | _e918.member_1);
                                            } else {
                                                let _e967 = order.member[_e214];
                                                let _e969 = order.member[(_e877 + _e918.member_1)];
                                                let _e972 = params.member.member_2.member_1;
                                                if (_e972 == 1u) {
                                                    let _e1002 = params.member.member.member_2[1u];
                                                    let _e1003 = (_e967 - _e1002);
                                                    let _e1007 = params.member.member.member_2[1u];
                                                    let _e1008 = (_e969 - _e1007);
                                                    if (_e1003 < _e1008) {
                                                        phi_1605_ = type_9(_e1003, _e1008);
                                                    } else {
                                                        phi_1605_ = type_9(_e1008, _e1003);
                                                    }
                                                    let _e1013 = phi_1605_;
                                                    phi_1638_ = _e1013;
                                                } else {
                                                    let _e976 = params.member.member_2.member;
                                                    if (_e976 == 2u) {
                                                        phi_1616_ = 8u;
                                                    } else {
                                                        phi_1616_ = 1u;
                                                    }
                                                    let _e979 = phi_1616_;
                                                    if (_e976 == 2u) {
                                                        phi_1621_ = 10u;
                                                    } else {
                                                        phi_1621_ = 1u;
                                                    }
                                                    let _e982 = phi_1621_;
                                                    if (_e179 >= (_e979 * _e982)) {
                                                        let _e994 = params.member.member.member_2[2u];
                                                        phi_1637_ = type_9(_e969, (_e967 - _e994));
                                                    } else {
                                                        let _e988 = params.member.member.member_2[2u];
                                                        phi_1637_ = type_9(_e967, (_e969 - _e988));
                                                    }
                                                    let _e998 = phi_1637_;
                                                    phi_1638_ = _e998;
                                                }
                                                let _e1015 = phi_1638_;
                                                let _e1020 = params.member.member_1.member_3;
                                                let _e1022 = atomicAdd((&pairs.member[0u]), 1u);
                                                if ((_e1022 + 1u) < _e1022) {
                                                    let _e1026 = atomicAdd((&pairs.member[2u]), 1u);
                                                }
                                                if (_e1022 < _e1020) {
                                                    let _e1028 = (2u * _e1022);
                                                    atomicStore((&pairs.member[(4u + _e1028)]), _e1015.member);
                                                    atomicStore((&pairs.member[(_e1028 + 5u)]), _e1015.member_1);
                                                }
                                            }
                                        }
                                    }
                                }
                            }
                        }
                        continue;
                        continuing {
                            phi_1468_ = _e916;
                            break if !(_e922);
                        }
                    }
                    workgroupBarrier();
                    let _e1039 = atomicLoad((&counters[0u]));
                    if (2048u < _e1039) {
                        phi_1673_ = 2048u;
                    } else {
                        phi_1673_ = _e1039;
                    }
                    let _e1042 = phi_1673_;
                    if (_e88 == 0u) {
                        if (_e1042 > 0u) {
                            let _e1046 = atomicAdd((&pairs.member[0u]), _e1042);
                            if ((_e1046 + _e1042) < _e1046) {
                                let _e1050 = atomicAdd((&pairs.member[2u]), 1u);
                            }
                            atomicStore((&counters[1u]), _e1046);
                        }
                    }
                    workgroupBarrier();
                    let _e1053 = atomicLoad((&counters[1u]));
                    phi_1699_ = type_9(0u, 16u);
                    loop {
                        let _e1055 = phi_1699_;
                        if (_e1055.member < _e1055.member_1) {
                            phi_1700_ = type_9((_e1055.member + 1u), _e1055.member_1);
                            phi_1723_ = type_9(1u, _e1055.member);
                        } else {
                            phi_1700_ = _e1055;
                            phi_1723_ = type_9(0u, type_9().member_1);
                        }
                        let _e1067 = phi_1700_;
                        let _e1069 = phi_1723_;
                        if (bitcast<i32>(_e1069.member) != 0i) {
                            let _e1075 = ((_e1069.member_1 * 128u) + _e88);
                            if (_e1075 >= _e1042) {
                                phi_1888_ = false;
                            } else {
                                let _e1078 = hits[_e1075];
                                let _e1083 = params.member.member_2.member;
                                let _e1086 = params.member.member_2.member_1;
                                if (_e1086 == 0u) {
                                    phi_1754_ = array<u32, 2>(0u, 2u);
                                } else {
                                    phi_1754_ = array<u32, 2>(1u, 1u);
                                }
                                let _e1089 = phi_1754_;
                                if (_e1083 == 2u) {
                                    phi_1761_ = 8u;
                                } else {
                                    phi_1761_ = 1u;
                                }
                                let _e1094 = phi_1761_;
                                if (_e1083 == 2u) {
                                    phi_1766_ = 10u;
                                } else {
                                    phi_1766_ = 1u;
                                }
                                let _e1097 = phi_1766_;
                                if (_e179 >= (_e1094 * _e1097)) {
                                    phi_1774_ = array<u32, 2>(_e1089[1], _e1089[0]);
                                } else {
                                    phi_1774_ = _e1089;
                                }
                                let _e1102 = phi_1774_;
                                let _e1109 = params.member.member.member_2[_e1102[0]];
                                let _e1114 = order.member[(_e1109 + ((_e183 * 128u) + (_e1078 >> bitcast<u32>(7i))))];
                                let _e1116 = order.member[(_e877 + (_e1078 % 128u))];
                                let _e1119 = params.member.member_2.member_1;
                                if (_e1119 == 1u) {
                                    let _e1149 = params.member.member.member_2[1u];
                                    let _e1150 = (_e1114 - _e1149);
                                    let _e1154 = params.member.member.member_2[1u];
                                    let _e1155 = (_e1116 - _e1154);
                                    if (_e1150 < _e1155) {
                                        phi_1837_ = type_9(_e1150, _e1155);
                                    } else {
                                        phi_1837_ = type_9(_e1155, _e1150);
                                    }
                                    let _e1160 = phi_1837_;
                                    phi_1870_ = _e1160;
                                } else {
                                    let _e1123 = params.member.member_2.member;
                                    if (_e1123 == 2u) {
                                        phi_1848_ = 8u;
                                    } else {
                                        phi_1848_ = 1u;
                                    }
                                    let _e1126 = phi_1848_;
                                    if (_e1123 == 2u) {
                                        phi_1853_ = 10u;
                                    } else {
                                        phi_1853_ = 1u;
                                    }
                                    let _e1129 = phi_1853_;
                                    if (_e179 >= (_e1126 * _e1129)) {
                                        let _e1141 = params.member.member.member_2[2u];
                                        phi_1869_ = type_9(_e1116, (_e1114 - _e1141));
                                    } else {
                                        let _e1135 = params.member.member.member_2[2u];
                                        phi_1869_ = type_9(_e1114, (_e1116 - _e1135));
                                    }
                                    let _e1145 = phi_1869_;
                                    phi_1870_ = _e1145;
                                }
                                let _e1162 = phi_1870_;
                                let _e1167 = params.member.member_1.member_3;
                                let _e1168 = (_e1053 + _e1075);
                                if (_e1168 < _e1167) {
                                    let _e1170 = (2u * _e1168);
                                    atomicStore((&pairs.member[(4u + _e1170)]), _e1162.member);
                                    atomicStore((&pairs.member[(_e1170 + 5u)]), _e1162.member_1);
                                }
                                phi_1888_ = true;
                            }
                            let _e1176 = phi_1888_;
                            phi_1889_ = _e1176;
                        } else {
                            phi_1889_ = false;
                        }
                        let _e1178 = phi_1889_;
                        continue;
                        continuing {
                            phi_1699_ = _e1067;
                            break if !(_e1178);
                        }
                    }
                    workgroupBarrier();
                }
                continue;
                continuing {
                    phi_1387_ = _e869;
                    break if !(_e875);
                }
            }
        }
        continue;
        continuing {
            phi_257_ = _e158;
            break if !(_e164);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn interval_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
