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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_22 {
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

struct type_24 {
    member: type_22,
    member_1: array<array<u32, 2>, 8>,
}

struct type_25 {
    member: type_7,
    member_1: type_8,
    member_2: type_24,
}

struct type_26 {
    member: type_25,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> boxes: type_18;
@group(0) @binding(4) 
var<storage, read_write> pairs: type_29;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;
@group(0) @binding(0) 
var<storage> params: type_26;
@group(0) @binding(2) 
var<storage, read_write> control: type_29;
@group(0) @binding(3) 
var<storage, read_write> nodes: type_29;
@group(0) @binding(5) 
var<storage, read_write> front: type_11;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_170_: u32;
    var phi_208_: type_9;
    var phi_209_: type_9;
    var phi_232_: type_9;
    var phi_256_: u32;
    var phi_287_: bool;
    var phi_291_: u32;
    var phi_292_: u32;
    var phi_293_: u32;
    var phi_391_: u32;
    var phi_396_: u32;
    var phi_401_: u32;
    var phi_414_: u32;
    var phi_420_: u32;
    var phi_429_: u32;
    var phi_358_: u32;
    var phi_364_: u32;
    var phi_370_: u32;
    var phi_430_: u32;
    var phi_321_: u32;
    var phi_327_: u32;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_433_: u32;
    var phi_453_: u32;
    var phi_454_: u32;
    var phi_468_: type_9;
    var phi_469_: type_9;
    var phi_492_: type_9;
    var phi_575_: array<u32, 2>;
    var phi_576_: array<u32, 2>;
    var phi_593_: array<u32, 2>;
    var phi_611_: array<u32, 2>;
    var phi_634_: u32;
    var phi_635_: bool;
    var phi_636_: u32;
    var phi_637_: bool;
    var phi_643_: u32;
    var phi_649_: u32;
    var phi_658_: u32;
    var phi_775_: u32;
    var phi_776_: bool;
    var phi_777_: u32;
    var phi_778_: bool;
    var phi_784_: u32;
    var phi_825_: type_20;
    var phi_826_: bool;
    var phi_827_: type_20;
    var phi_828_: bool;
    var phi_840_: bool;
    var phi_846_: u32;
    var phi_906_: type_9;
    var phi_909_: u32;
    var phi_911_: u32;
    var phi_907_: type_9;
    var phi_934_: type_9;
    var phi_990_: u32;
    var phi_991_: u32;
    var phi_992_: u32;
    var phi_993_: bool;
    var phi_910_: u32;
    var phi_912_: u32;
    var phi_994_: bool;
    var phi_995_: u32;
    var phi_1006_: u32;
    var phi_1007_: u32;
    var phi_1008_: u32;
    var phi_1022_: u32;
    var phi_1034_: u32;
    var phi_1035_: array<u32, 2>;
    var phi_1036_: u32;
    var phi_1037_: array<u32, 2>;
    var phi_1049_: array<u32, 2>;
    var phi_1050_: array<u32, 2>;
    var phi_1094_: u32;
    var phi_1181_: u32;
    var phi_1184_: type_9;
    var phi_1187_: u32;
    var phi_1189_: u32;
    var phi_1191_: u32;
    var phi_1185_: type_9;
    var phi_1214_: type_9;
    var phi_1240_: u32;
    var phi_1345_: u32;
    var phi_1346_: u32;
    var phi_1347_: u32;
    var phi_1348_: bool;
    var phi_1188_: u32;
    var phi_1190_: u32;
    var phi_1192_: u32;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1374_: u32;
    var phi_1379_: u32;
    var phi_1405_: u32;
    var phi_1411_: u32;
    var phi_1499_: type_9;
    var phi_1500_: type_9;
    var phi_1523_: type_9;
    var phi_1614_: u32;
    var phi_1617_: type_9;
    var phi_1618_: type_9;
    var phi_1641_: type_9;
    var phi_1722_: type_9;
    var phi_1723_: type_9;
    var phi_1746_: type_9;
    var phi_1838_: bool;
    var phi_1839_: bool;
    var local: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e60 = id_2;
    let _e61 = n_2;
    let _e62 = lane_2;
    let _e73 = ((_e60.y * _e61.x) + _e60.x);
    let _e76 = params.member.member_2.member;
    let _e78 = params.member.member_1;
    let _e81 = (_e78.member_1 % 2u);
    let _e83 = atomicLoad((&control.member[_e78.member_1]));
    if (_e76.member_3 < _e83) {
        phi_170_ = _e76.member_3;
    } else {
        phi_170_ = _e83;
    }
    let _e86 = phi_170_;
    let _e87 = (_e81 * _e76.member_3);
    let _e89 = ((1u - _e81) * _e76.member_3);
    if (_e62 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_208_ = type_9(0u, _e76.member_11);
    loop {
        let _e98 = phi_208_;
        if (_e98.member < _e98.member_1) {
            phi_209_ = type_9((_e98.member + 1u), _e98.member_1);
            phi_232_ = type_9(1u, _e98.member);
        } else {
            phi_209_ = _e98;
            phi_232_ = type_9(0u, type_9().member_1);
        }
        let _e110 = phi_209_;
        let _e112 = phi_232_;
        if (bitcast<i32>(_e112.member) != 0i) {
            if (_e62 == 0u) {
                let _e123 = atomicLoad((&shared_[0u]));
                if (4u < _e123) {
                    phi_256_ = 4u;
                } else {
                    phi_256_ = _e123;
                }
                let _e126 = phi_256_;
                if (_e76.member_9 > 0u) {
                    if (_e112.member_1 >= 16u) {
                        let _e131 = atomicLoad((&control.member[(1024u + _e78.member_1)]));
                        if (_e76.member_9 > 0u) {
                            phi_287_ = ((_e131 * 100u) >= (_e76.member_9 << bitcast<u32>((_e76.member_7 & 31u))));
                        } else {
                            phi_287_ = false;
                        }
                        let _e139 = phi_287_;
                        if _e139 {
                            phi_291_ = 2u;
                        } else {
                            phi_291_ = 0u;
                        }
                        let _e141 = phi_291_;
                        phi_292_ = _e141;
                    } else {
                        phi_292_ = 0u;
                    }
                    let _e143 = phi_292_;
                    phi_293_ = _e143;
                } else {
                    phi_293_ = 0u;
                }
                let _e145 = phi_293_;
                let _e146 = (4u - _e126);
                if (_e145 == 0u) {
                    if (_e146 > 0u) {
                        let _e150 = atomicLoad((&shared_[5u]));
                        if (_e76.member_6 == 0u) {
                            if (_e73 < _e86) {
                                phi_321_ = ((((_e86 - 1u) - _e73) >> bitcast<u32>((_e76.member_7 & 31u))) + 1u);
                            } else {
                                phi_321_ = 0u;
                            }
                            let _e219 = phi_321_;
                            let _e220 = (_e219 - _e150);
                            if (_e146 < _e220) {
                                phi_327_ = _e146;
                            } else {
                                phi_327_ = _e220;
                            }
                            let _e223 = phi_327_;
                            atomicStore((&shared_[3u]), (_e73 + (_e150 << bitcast<u32>((_e76.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e76.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e150 + _e223));
                            phi_431_ = _e223;
                        } else {
                            if (_e76.member_6 == 2u) {
                                let _e191 = (((_e86 + (1u << bitcast<u32>((_e76.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e76.member_7 & 31u)));
                                let _e192 = (_e73 * _e191);
                                if (_e86 < _e192) {
                                    phi_358_ = _e86;
                                } else {
                                    phi_358_ = _e192;
                                }
                                let _e195 = phi_358_;
                                let _e196 = (_e86 - _e195);
                                if (_e196 < _e191) {
                                    phi_364_ = _e196;
                                } else {
                                    phi_364_ = _e191;
                                }
                                let _e199 = phi_364_;
                                let _e200 = (_e199 - _e150);
                                if (_e146 < _e200) {
                                    phi_370_ = _e146;
                                } else {
                                    phi_370_ = _e200;
                                }
                                let _e203 = phi_370_;
                                atomicStore((&shared_[3u]), (_e195 + _e150));
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), (_e150 + _e203));
                                phi_430_ = _e203;
                            } else {
                                if (_e150 == 0u) {
                                    let _e157 = (_e86 >> bitcast<u32>(((_e76.member_7 + 2u) & 31u)));
                                    if (_e76.member_8 < _e157) {
                                        phi_391_ = _e157;
                                    } else {
                                        phi_391_ = _e76.member_8;
                                    }
                                    let _e160 = phi_391_;
                                    if (128u < _e160) {
                                        phi_396_ = 128u;
                                    } else {
                                        phi_396_ = _e160;
                                    }
                                    let _e163 = phi_396_;
                                    if (_e146 < _e163) {
                                        phi_401_ = _e146;
                                    } else {
                                        phi_401_ = _e163;
                                    }
                                    let _e166 = phi_401_;
                                    let _e169 = atomicAdd((&control.member[(512u + _e78.member_1)]), _e166);
                                    if (_e86 < _e169) {
                                        phi_414_ = _e86;
                                    } else {
                                        phi_414_ = _e169;
                                    }
                                    let _e172 = phi_414_;
                                    let _e173 = (_e86 - _e172);
                                    if (_e166 < _e173) {
                                        phi_420_ = _e166;
                                    } else {
                                        phi_420_ = _e173;
                                    }
                                    let _e176 = phi_420_;
                                    atomicStore((&shared_[3u]), _e169);
                                    atomicStore((&shared_[4u]), 1u);
                                    atomicStore((&shared_[5u]), select(0u, 1u, (_e176 < _e166)));
                                    phi_429_ = _e176;
                                } else {
                                    phi_429_ = 0u;
                                }
                                let _e183 = phi_429_;
                                phi_430_ = _e183;
                            }
                            let _e210 = phi_430_;
                            phi_431_ = _e210;
                        }
                        let _e236 = phi_431_;
                        phi_432_ = _e236;
                    } else {
                        phi_432_ = 0u;
                    }
                    let _e238 = phi_432_;
                    phi_433_ = _e238;
                } else {
                    phi_433_ = 0u;
                }
                let _e240 = phi_433_;
                if (_e145 == 0u) {
                    if ((_e126 + _e240) == 0u) {
                        if (_e76.member_9 > 0u) {
                            let _e247 = atomicAdd((&control.member[(1024u + _e78.member_1)]), 1u);
                        }
                        phi_453_ = 1u;
                    } else {
                        phi_453_ = _e145;
                    }
                    let _e249 = phi_453_;
                    phi_454_ = _e249;
                } else {
                    phi_454_ = _e145;
                }
                let _e251 = phi_454_;
                atomicStore((&shared_[1u]), _e126);
                atomicStore((&shared_[2u]), _e240);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                phi_468_ = type_9(0u, 4u);
                loop {
                    let _e258 = phi_468_;
                    if (_e258.member < _e258.member_1) {
                        phi_469_ = type_9((_e258.member + 1u), _e258.member_1);
                        phi_492_ = type_9(1u, _e258.member);
                    } else {
                        phi_469_ = _e258;
                        phi_492_ = type_9(0u, type_9().member_1);
                    }
                    let _e270 = phi_469_;
                    let _e272 = phi_492_;
                    let _e276 = (bitcast<i32>(_e272.member) != 0i);
                    if _e276 {
                        atomicStore((&shared_[(18u + _e272.member_1)]), 0u);
                    }
                    continue;
                    continuing {
                        phi_468_ = _e270;
                        break if !(_e276);
                    }
                }
                state[0u] = _e251;
            }
            let _e282 = workgroupUniformLoad((&state[0u]));
            if (_e282 != 0u) {
                phi_1350_ = false;
            } else {
                let _e284 = (_e62 / 32u);
                let _e286 = atomicLoad((&shared_[1u]));
                let _e288 = atomicLoad((&shared_[2u]));
                if (_e284 < _e286) {
                    let _e311 = atomicLoad((&shared_[0u]));
                    let _e314 = (2u * ((_e311 - 1u) - _e284));
                    let _e316 = stack[_e314];
                    let _e319 = stack[(_e314 + 1u)];
                    phi_576_ = array<u32, 2>(_e316, _e319);
                } else {
                    if (_e284 < (_e286 + _e288)) {
                        let _e293 = atomicLoad((&shared_[3u]));
                        let _e296 = atomicLoad((&shared_[4u]));
                        let _e300 = (2u * (_e87 + (_e293 + ((_e284 - _e286) * _e296))));
                        let _e303 = atomicLoad((&nodes.member[(4u + _e300)]));
                        let _e306 = atomicLoad((&nodes.member[(_e300 + 5u)]));
                        phi_575_ = array<u32, 2>(_e303, _e306);
                    } else {
                        phi_575_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e309 = phi_575_;
                    phi_576_ = _e309;
                }
                let _e322 = phi_576_;
                let _e323 = (_e62 / 32u);
                let _e324 = (_e62 % 32u);
                let _e326 = (_e322[0] != 4294967295u);
                if _e326 {
                    phi_593_ = _e322;
                } else {
                    phi_593_ = array<u32, 2>(134217728u, 0u);
                }
                let _e328 = phi_593_;
                let _e332 = (_e328[0] >> bitcast<u32>(27u));
                let _e333 = (_e328[0] & 134217727u);
                let _e334 = (_e332 - 1u);
                let _e336 = ((_e333 * 32u) + _e324);
                let _e337 = (_e328[1] * 32u);
                let _e341 = params.member.member_2.member.member;
                if (_e341 == 0u) {
                    phi_611_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_611_ = array<u32, 2>(1u, 1u);
                }
                let _e344 = phi_611_;
                let _e350 = params.member.member.member[_e344[1]];
                let _e351 = (5u * _e334);
                if (_e350 > 0u) {
                    if (_e351 < 32u) {
                        phi_634_ = (((_e350 - 1u) >> bitcast<u32>((_e351 & 31u))) + 1u);
                        phi_635_ = false;
                    } else {
                        phi_634_ = u32();
                        phi_635_ = true;
                    }
                    let _e360 = phi_634_;
                    let _e362 = phi_635_;
                    phi_636_ = _e360;
                    phi_637_ = _e362;
                } else {
                    phi_636_ = u32();
                    phi_637_ = true;
                }
                let _e364 = phi_636_;
                let _e366 = phi_637_;
                if _e366 {
                    phi_643_ = select(0u, 1u, (_e350 > 0u));
                } else {
                    phi_643_ = _e364;
                }
                let _e370 = phi_643_;
                let _e371 = (_e328[1] * 32u);
                if (_e371 < _e370) {
                    phi_649_ = _e370;
                } else {
                    phi_649_ = _e371;
                }
                let _e374 = phi_649_;
                let _e375 = (_e374 - _e371);
                if (_e375 >= 32u) {
                    phi_658_ = 4294967295u;
                } else {
                    phi_658_ = ((1u << bitcast<u32>((_e375 & 31u))) - 1u);
                }
                let _e382 = phi_658_;
                let _e387 = params.member.member_2.member_1[_e334][1u];
                let _e388 = (_e387 + _e337);
                if _e326 {
                    if (((_e382 >> bitcast<u32>((_e324 & 31u))) & 1u) == 1u) {
                        let _e396 = boxes.member[(_e388 + _e324)];
                        let _e413 = params.member.member_2.member_1[_e332][0u];
                        let _e416 = boxes.member[(_e413 + _e333)];
                        if ((((((_e396.member.x <= _e416.member_1.y) && (_e416.member.x <= _e396.member_1.y)) && (_e396.member.y <= _e416.member_2.x)) && (_e416.member.y <= _e396.member_2.x)) && (_e396.member_1.x <= _e416.member_2.y)) && (_e416.member_1.x <= _e396.member_2.y)) {
                            let _e445 = atomicOr((&shared_[(18u + _e323)]), (1u << bitcast<u32>((_e324 & 31u))));
                        }
                    }
                    let _e449 = params.member.member.member[_e344[0]];
                    let _e450 = (5u * _e334);
                    if (_e449 > 0u) {
                        if (_e450 < 32u) {
                            phi_775_ = (((_e449 - 1u) >> bitcast<u32>((_e450 & 31u))) + 1u);
                            phi_776_ = false;
                        } else {
                            phi_775_ = u32();
                            phi_776_ = true;
                        }
                        let _e459 = phi_775_;
                        let _e461 = phi_776_;
                        phi_777_ = _e459;
                        phi_778_ = _e461;
                    } else {
                        phi_777_ = u32();
                        phi_778_ = true;
                    }
                    let _e463 = phi_777_;
                    let _e465 = phi_778_;
                    if _e465 {
                        phi_784_ = select(0u, 1u, (_e449 > 0u));
                    } else {
                        phi_784_ = _e463;
                    }
                    let _e469 = phi_784_;
                    if (_e336 < _e469) {
                        let _e475 = params.member.member_2.member_1[_e334][0u];
                        let _e478 = boxes.member[(_e475 + _e336)];
                        phi_825_ = type_20(array<f32, 3>(_e478.member.x, _e478.member.y, _e478.member_1.x), array<f32, 3>(_e478.member_1.y, _e478.member_2.x, _e478.member_2.y));
                        phi_826_ = true;
                    } else {
                        phi_825_ = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_826_ = false;
                    }
                    let _e495 = phi_825_;
                    let _e497 = phi_826_;
                    phi_827_ = _e495;
                    phi_828_ = _e497;
                } else {
                    phi_827_ = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                    phi_828_ = false;
                }
                let _e499 = phi_827_;
                let _e501 = phi_828_;
                workgroupBarrier();
                if _e501 {
                    let _e505 = params.member.member_2.member.member;
                    if (_e505 == 1u) {
                        phi_840_ = (_e333 == _e328[1]);
                    } else {
                        phi_840_ = false;
                    }
                    let _e509 = phi_840_;
                    if _e509 {
                        phi_846_ = (4294967295u << bitcast<u32>((_e324 & 31u)));
                    } else {
                        phi_846_ = 4294967295u;
                    }
                    let _e514 = phi_846_;
                    let _e519 = params.member.member_2.member_1[_e332][1u];
                    let _e522 = boxes.member[(_e519 + _e328[1])];
                    if ((((((_e499.member[0] <= _e522.member_1.y) && (_e522.member.x <= _e499.member_1[0])) && (_e499.member[1] <= _e522.member_2.x)) && (_e522.member.y <= _e499.member_1[1])) && (_e499.member[2] <= _e522.member_2.y)) && (_e522.member_1.x <= _e499.member_1[2])) {
                        let _e560 = atomicLoad((&shared_[(18u + _e323)]));
                        phi_906_ = type_9(0u, 32u);
                        phi_909_ = 0u;
                        phi_911_ = (_e560 & _e514);
                        loop {
                            let _e563 = phi_906_;
                            let _e565 = phi_909_;
                            let _e567 = phi_911_;
                            local = _e565;
                            if (_e563.member < _e563.member_1) {
                                phi_907_ = type_9((_e563.member + 1u), _e563.member_1);
                                phi_934_ = type_9(1u, _e563.member);
                            } else {
                                phi_907_ = _e563;
                                phi_934_ = type_9(0u, type_9().member_1);
                            }
                            let _e579 = phi_907_;
                            let _e581 = phi_934_;
                            if (bitcast<i32>(_e581.member) != 0i) {
                                if (_e567 == 0u) {
                                    phi_991_ = u32();
                                    phi_992_ = u32();
                                    phi_993_ = false;
                                } else {
                                    let _e588 = select(firstTrailingBit(_e567), 32u, (_e567 == 0u));
                                    let _e593 = boxes.member[(_e388 + _e588)];
                                    if ((((((_e499.member[0] <= _e593.member_1.y) && (_e593.member.x <= _e499.member_1[0])) && (_e499.member[1] <= _e593.member_2.x)) && (_e593.member.y <= _e499.member_1[1])) && (_e499.member[2] <= _e593.member_2.y)) && (_e593.member_1.x <= _e499.member_1[2])) {
                                        phi_990_ = (_e565 | (1u << bitcast<u32>((_e588 & 31u))));
                                    } else {
                                        phi_990_ = _e565;
                                    }
                                    let _e634 = phi_990_;
                                    phi_991_ = _e634;
                                    phi_992_ = (_e567 & (_e567 - 1u));
                                    phi_993_ = true;
                                }
                                let _e636 = phi_991_;
                                let _e638 = phi_992_;
                                let _e640 = phi_993_;
                                phi_910_ = _e636;
                                phi_912_ = _e638;
                                phi_994_ = _e640;
                            } else {
                                phi_910_ = u32();
                                phi_912_ = u32();
                                phi_994_ = false;
                            }
                            let _e642 = phi_910_;
                            let _e644 = phi_912_;
                            let _e646 = phi_994_;
                            continue;
                            continuing {
                                phi_906_ = _e579;
                                phi_909_ = _e642;
                                phi_911_ = _e644;
                                break if !(_e646);
                            }
                        }
                        let _e1234 = local;
                        phi_995_ = _e1234;
                    } else {
                        phi_995_ = 0u;
                    }
                    let _e649 = phi_995_;
                    let _e653 = params.member.member_2.member.member_4;
                    if (_e653 > 0u) {
                        phi_1006_ = ((_e382 & _e514) & ~(_e649));
                    } else {
                        phi_1006_ = 0u;
                    }
                    let _e659 = phi_1006_;
                    phi_1007_ = _e649;
                    phi_1008_ = _e659;
                } else {
                    phi_1007_ = 0u;
                    phi_1008_ = 0u;
                }
                let _e661 = phi_1007_;
                let _e663 = phi_1008_;
                let _e665 = countOneBits(_e663);
                let _e666 = countOneBits(_e661);
                if (_e666 > 0u) {
                    if (_e334 > 1u) {
                        phi_1022_ = 1u;
                    } else {
                        phi_1022_ = 2u;
                    }
                    let _e670 = phi_1022_;
                    if (_e670 == 1u) {
                        let _e677 = atomicAdd((&shared_[6u]), _e666);
                        phi_1034_ = _e665;
                        phi_1035_ = array<u32, 2>(_e677, 0u);
                    } else {
                        let _e673 = atomicAdd((&shared_[7u]), _e666);
                        phi_1034_ = (_e665 + _e666);
                        phi_1035_ = array<u32, 2>(_e673, 0u);
                    }
                    let _e680 = phi_1034_;
                    let _e682 = phi_1035_;
                    phi_1036_ = _e680;
                    phi_1037_ = _e682;
                } else {
                    phi_1036_ = _e665;
                    phi_1037_ = array<u32, 2>(0u, 0u);
                }
                let _e684 = phi_1036_;
                let _e686 = phi_1037_;
                if (_e76.member_4 > 0u) {
                    if (_e684 > 0u) {
                        let _e690 = atomicAdd((&shared_[8u]), _e684);
                        phi_1049_ = array<u32, 2>(_e686[0], _e690);
                    } else {
                        phi_1049_ = _e686;
                    }
                    let _e694 = phi_1049_;
                    phi_1050_ = _e694;
                } else {
                    phi_1050_ = _e686;
                }
                let _e696 = phi_1050_;
                workgroupBarrier();
                if (_e62 == 0u) {
                    let _e699 = atomicLoad((&shared_[6u]));
                    let _e701 = atomicLoad((&shared_[7u]));
                    let _e703 = atomicLoad((&shared_[8u]));
                    let _e705 = atomicLoad((&shared_[1u]));
                    let _e707 = atomicLoad((&shared_[2u]));
                    let _e709 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e709 + 1u));
                    let _e713 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e713 + _e705) + _e707));
                    let _e718 = atomicLoad((&shared_[0u]));
                    let _e719 = (_e718 - _e705);
                    let _e721 = (_e76.member_10 - _e719);
                    if (_e721 < _e699) {
                        phi_1094_ = _e721;
                    } else {
                        phi_1094_ = _e699;
                    }
                    let _e724 = phi_1094_;
                    atomicStore((&shared_[9u]), _e719);
                    atomicStore((&shared_[10u]), _e724);
                    atomicStore((&shared_[0u]), (_e719 + _e724));
                    if (_e699 > _e724) {
                        let _e730 = (_e699 - _e724);
                        if (_e76.member_12 == 0u) {
                        } else {
                            let _e734 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e737 = atomicAdd((&control.member[(_e78.member_1 + 1u)]), _e730);
                        let _e740 = atomicMax((&nodes.member[0u]), (_e737 + _e730));
                        if ((_e737 + _e730) < _e737) {
                            let _e744 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e737);
                    }
                    if (_e701 > 0u) {
                        let _e748 = atomicAdd((&pairs.member[0u]), _e701);
                        if ((_e748 + _e701) < _e748) {
                            let _e752 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e748);
                    }
                    if (_e703 > 0u) {
                        let _e756 = atomicAdd((&control.member[1537u]), _e703);
                        if ((_e756 + _e703) < _e756) {
                            let _e760 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e756);
                    }
                }
                workgroupBarrier();
                if (_e334 > 1u) {
                    phi_1181_ = 1u;
                } else {
                    phi_1181_ = 2u;
                }
                let _e767 = phi_1181_;
                phi_1184_ = type_9(0u, 32u);
                phi_1187_ = _e696[1];
                phi_1189_ = _e696[0];
                phi_1191_ = (_e661 | _e663);
                loop {
                    let _e769 = phi_1184_;
                    let _e771 = phi_1187_;
                    let _e773 = phi_1189_;
                    let _e775 = phi_1191_;
                    if (_e769.member < _e769.member_1) {
                        phi_1185_ = type_9((_e769.member + 1u), _e769.member_1);
                        phi_1214_ = type_9(1u, _e769.member);
                    } else {
                        phi_1185_ = _e769;
                        phi_1214_ = type_9(0u, type_9().member_1);
                    }
                    let _e787 = phi_1185_;
                    let _e789 = phi_1214_;
                    if (bitcast<i32>(_e789.member) != 0i) {
                        if (_e775 == 0u) {
                            phi_1345_ = u32();
                            phi_1346_ = u32();
                            phi_1347_ = u32();
                            phi_1348_ = false;
                        } else {
                            let _e796 = select(firstTrailingBit(_e775), 32u, (_e775 == 0u));
                            let _e799 = (_e337 + _e796);
                            let _e802 = ((_e334 << bitcast<u32>(27u)) | _e336);
                            if (((_e663 >> bitcast<u32>((_e796 & 31u))) & 1u) == 1u) {
                                phi_1240_ = 3u;
                            } else {
                                phi_1240_ = _e767;
                            }
                            let _e809 = phi_1240_;
                            if (_e809 == 1u) {
                                let _e842 = atomicLoad((&shared_[10u]));
                                if (_e773 < _e842) {
                                    let _e858 = atomicLoad((&shared_[9u]));
                                    let _e860 = (2u * (_e858 + _e773));
                                    stack[_e860] = _e802;
                                    stack[(_e860 + 1u)] = _e799;
                                } else {
                                    let _e845 = atomicLoad((&shared_[11u]));
                                    let _e847 = ((_e845 + _e773) - _e842);
                                    if (_e847 < _e76.member_3) {
                                        let _e850 = (_e89 + _e847);
                                        if (_e850 < 4294967295u) {
                                            let _e852 = (2u * _e850);
                                            atomicStore((&nodes.member[(4u + _e852)]), _e802);
                                            atomicStore((&nodes.member[(_e852 + 5u)]), _e799);
                                        }
                                    }
                                }
                            } else {
                                if (_e809 == 0u) {
                                } else {
                                    if (_e809 == 2u) {
                                        let _e815 = params.member.member_1;
                                        let _e818 = atomicLoad((&shared_[12u]));
                                        let _e819 = (_e818 + _e773);
                                        if (_e819 < _e815.member_3) {
                                            let _e821 = (2u * _e819);
                                            atomicStore((&pairs.member[(4u + _e821)]), (_e802 & 134217727u));
                                            atomicStore((&pairs.member[(_e821 + 5u)]), _e799);
                                        }
                                    }
                                    if (_e76.member_4 > 0u) {
                                        let _e829 = atomicLoad((&shared_[13u]));
                                        let _e830 = (_e829 + _e771);
                                        if (_e830 < _e76.member_4) {
                                            let _e837 = (2u * ((_e76.member_5 * _e76.member_4) + _e830));
                                            front.member[_e837] = _e802;
                                            front.member[(_e837 + 1u)] = _e799;
                                        }
                                    }
                                }
                            }
                            phi_1345_ = (_e771 + select(0u, 1u, (_e809 != 1u)));
                            phi_1346_ = (_e773 + select(0u, 1u, (_e809 != 3u)));
                            phi_1347_ = (_e775 & (_e775 - 1u));
                            phi_1348_ = true;
                        }
                        let _e871 = phi_1345_;
                        let _e873 = phi_1346_;
                        let _e875 = phi_1347_;
                        let _e877 = phi_1348_;
                        phi_1188_ = _e871;
                        phi_1190_ = _e873;
                        phi_1192_ = _e875;
                        phi_1349_ = _e877;
                    } else {
                        phi_1188_ = u32();
                        phi_1190_ = u32();
                        phi_1192_ = u32();
                        phi_1349_ = false;
                    }
                    let _e879 = phi_1188_;
                    let _e881 = phi_1190_;
                    let _e883 = phi_1192_;
                    let _e885 = phi_1349_;
                    continue;
                    continuing {
                        phi_1184_ = _e787;
                        phi_1187_ = _e879;
                        phi_1189_ = _e881;
                        phi_1191_ = _e883;
                        break if !(_e885);
                    }
                }
                phi_1350_ = true;
            }
            let _e888 = phi_1350_;
            phi_1351_ = _e888;
        } else {
            phi_1351_ = false;
        }
        let _e890 = phi_1351_;
        continue;
        continuing {
            phi_208_ = _e110;
            break if !(_e890);
        }
    }
    if (_e62 == 0u) {
        if (_e76.member_6 == 0u) {
            if (_e73 < _e86) {
                phi_1374_ = ((((_e86 - 1u) - _e73) >> bitcast<u32>((_e76.member_7 & 31u))) + 1u);
            } else {
                phi_1374_ = 0u;
            }
            let _e904 = phi_1374_;
            let _e906 = atomicLoad((&shared_[5u]));
            phi_1379_ = (_e904 - _e906);
        } else {
            phi_1379_ = 0u;
        }
        let _e909 = phi_1379_;
        atomicStore((&shared_[14u]), _e909);
        let _e912 = atomicLoad((&shared_[0u]));
        let _e913 = (_e912 + _e909);
        if (_e76.member_6 == 2u) {
            let _e940 = (((_e86 + (1u << bitcast<u32>((_e76.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e76.member_7 & 31u)));
            let _e941 = (_e73 * _e940);
            if (_e86 < _e941) {
                phi_1405_ = _e86;
            } else {
                phi_1405_ = _e941;
            }
            let _e944 = phi_1405_;
            let _e945 = (_e86 - _e944);
            if (_e945 < _e940) {
                phi_1411_ = _e945;
            } else {
                phi_1411_ = _e940;
            }
            let _e948 = phi_1411_;
            let _e955 = ((1540u + (2u * (1u << bitcast<u32>((_e76.member_7 & 31u))))) + (2u * _e73));
            let _e957 = atomicLoad((&shared_[0u]));
            atomicStore((&control.member[_e955]), _e957);
            let _e961 = atomicLoad((&shared_[5u]));
            atomicStore((&control.member[(_e955 + 1u)]), (_e948 - _e961));
        } else {
            if (_e913 > 0u) {
                if (_e76.member_12 == 0u) {
                } else {
                    let _e920 = atomicMax((&control.member[1536u]), 4294967295u);
                }
                let _e923 = atomicAdd((&control.member[(_e78.member_1 + 1u)]), _e913);
                let _e926 = atomicMax((&nodes.member[0u]), (_e923 + _e913));
                if ((_e923 + _e913) < _e923) {
                    let _e930 = atomicAdd((&nodes.member[2u]), 1u);
                }
                atomicStore((&shared_[17u]), _e923);
            }
        }
        let _e967 = atomicLoad((&shared_[15u]));
        let _e969 = atomicAdd((&control.member[(1540u + (2u * _e73))]), _e967);
        let _e973 = atomicLoad((&shared_[16u]));
        let _e975 = atomicAdd((&control.member[((2u * _e73) + 1541u)]), _e973);
    }
    workgroupBarrier();
    let _e977 = atomicLoad((&shared_[0u]));
    let _e979 = atomicLoad((&shared_[17u]));
    let _e981 = atomicLoad((&shared_[14u]));
    phi_1499_ = type_9(0u, 8u);
    loop {
        let _e983 = phi_1499_;
        if (_e983.member < _e983.member_1) {
            phi_1500_ = type_9((_e983.member + 1u), _e983.member_1);
            phi_1523_ = type_9(1u, _e983.member);
        } else {
            phi_1500_ = _e983;
            phi_1523_ = type_9(0u, type_9().member_1);
        }
        let _e995 = phi_1500_;
        let _e997 = phi_1523_;
        let _e1001 = (bitcast<i32>(_e997.member) != 0i);
        if _e1001 {
            let _e1003 = ((_e997.member_1 * 128u) + _e62);
            if (_e1003 < _e977) {
                let _e1007 = stack[(2u * _e1003)];
                let _e1011 = stack[((2u * _e1003) + 1u)];
                if (_e76.member_6 == 2u) {
                    let _e1043 = ((((((1540u + (2u * (1u << bitcast<u32>((_e76.member_7 & 31u))))) + (2u * (1u << bitcast<u32>((_e76.member_7 & 31u))))) + (1u << bitcast<u32>((_e76.member_7 & 31u)))) + 1u) + (_e73 * 2048u)) + (2u * _e1003));
                    atomicStore((&control.member[_e1043]), _e1007);
                    atomicStore((&control.member[(_e1043 + 1u)]), _e1011);
                } else {
                    let _e1014 = (_e979 + _e1003);
                    if (_e1014 < _e76.member_3) {
                        let _e1017 = (_e89 + _e1014);
                        if (_e1017 < 4294967295u) {
                            let _e1019 = (2u * _e1017);
                            atomicStore((&nodes.member[(4u + _e1019)]), _e1007);
                            atomicStore((&nodes.member[(_e1019 + 5u)]), _e1011);
                        }
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1499_ = _e995;
            break if !(_e1001);
        }
    }
    let _e1049 = atomicLoad((&shared_[5u]));
    let _e1050 = (_e981 / 128u);
    if ((_e981 % 128u) > 0u) {
        phi_1614_ = (_e1050 + 1u);
    } else {
        phi_1614_ = _e1050;
    }
    let _e1055 = phi_1614_;
    phi_1617_ = type_9(0u, _e1055);
    loop {
        let _e1058 = phi_1617_;
        if (_e1058.member < _e1058.member_1) {
            phi_1618_ = type_9((_e1058.member + 1u), _e1058.member_1);
            phi_1641_ = type_9(1u, _e1058.member);
        } else {
            phi_1618_ = _e1058;
            phi_1641_ = type_9(0u, type_9().member_1);
        }
        let _e1070 = phi_1618_;
        let _e1072 = phi_1641_;
        let _e1076 = (bitcast<i32>(_e1072.member) != 0i);
        if _e1076 {
            let _e1078 = ((_e1072.member_1 * 128u) + _e62);
            if (_e1078 < _e981) {
                let _e1087 = (2u * ((_e87 + _e73) + ((_e1049 + _e1078) << bitcast<u32>((_e76.member_7 & 31u)))));
                let _e1090 = atomicLoad((&nodes.member[(4u + _e1087)]));
                let _e1093 = atomicLoad((&nodes.member[(_e1087 + 5u)]));
                let _e1095 = ((_e979 + _e977) + _e1078);
                if (_e1095 < _e76.member_3) {
                    let _e1098 = (_e89 + _e1095);
                    if (_e1098 < 4294967295u) {
                        let _e1100 = (2u * _e1098);
                        atomicStore((&nodes.member[(4u + _e1100)]), _e1090);
                        atomicStore((&nodes.member[(_e1100 + 5u)]), _e1093);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1617_ = _e1070;
            break if !(_e1076);
        }
    }
    if (_e76.member_6 == 1u) {
        if (_e1049 == 0u) {
            phi_1722_ = type_9(0u, _e86);
            loop {
                let _e1111 = phi_1722_;
                if (_e1111.member < _e1111.member_1) {
                    phi_1723_ = type_9((_e1111.member + 1u), _e1111.member_1);
                    phi_1746_ = type_9(1u, _e1111.member);
                } else {
                    phi_1723_ = _e1111;
                    phi_1746_ = type_9(0u, type_9().member_1);
                }
                let _e1123 = phi_1723_;
                let _e1125 = phi_1746_;
                if (bitcast<i32>(_e1125.member) != 0i) {
                    let _e1131 = atomicAdd((&control.member[(512u + _e78.member_1)]), 1u);
                    if (_e1131 >= _e86) {
                        phi_1838_ = false;
                    } else {
                        let _e1134 = (2u * (_e87 + _e1131));
                        let _e1137 = atomicLoad((&nodes.member[(4u + _e1134)]));
                        let _e1140 = atomicLoad((&nodes.member[(_e1134 + 5u)]));
                        if (_e76.member_12 == 0u) {
                        } else {
                            let _e1144 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1147 = atomicAdd((&control.member[(_e78.member_1 + 1u)]), 1u);
                        let _e1150 = atomicMax((&nodes.member[0u]), (_e1147 + 1u));
                        if ((_e1147 + 1u) < _e1147) {
                            let _e1154 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1147 < _e76.member_3) {
                            let _e1157 = (_e89 + _e1147);
                            if (_e1157 < 4294967295u) {
                                let _e1159 = (2u * _e1157);
                                atomicStore((&nodes.member[(4u + _e1159)]), _e1137);
                                atomicStore((&nodes.member[(_e1159 + 5u)]), _e1140);
                            }
                        }
                        phi_1838_ = true;
                    }
                    let _e1165 = phi_1838_;
                    phi_1839_ = _e1165;
                } else {
                    phi_1839_ = false;
                }
                let _e1167 = phi_1839_;
                continue;
                continuing {
                    phi_1722_ = _e1123;
                    break if !(_e1167);
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn block_workers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
