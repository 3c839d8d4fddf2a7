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
    var phi_353_: u32;
    var phi_358_: u32;
    var phi_363_: u32;
    var phi_376_: u32;
    var phi_382_: u32;
    var phi_391_: u32;
    var phi_321_: u32;
    var phi_327_: u32;
    var phi_392_: u32;
    var phi_393_: u32;
    var phi_394_: u32;
    var phi_414_: u32;
    var phi_415_: u32;
    var phi_429_: type_9;
    var phi_430_: type_9;
    var phi_453_: type_9;
    var phi_536_: array<u32, 2>;
    var phi_537_: array<u32, 2>;
    var phi_554_: array<u32, 2>;
    var phi_572_: array<u32, 2>;
    var phi_595_: u32;
    var phi_596_: bool;
    var phi_597_: u32;
    var phi_598_: bool;
    var phi_604_: u32;
    var phi_610_: u32;
    var phi_619_: u32;
    var phi_736_: u32;
    var phi_737_: bool;
    var phi_738_: u32;
    var phi_739_: bool;
    var phi_745_: u32;
    var phi_786_: type_20;
    var phi_787_: bool;
    var phi_788_: type_20;
    var phi_789_: bool;
    var phi_801_: bool;
    var phi_807_: u32;
    var phi_867_: type_9;
    var phi_870_: u32;
    var phi_872_: u32;
    var phi_868_: type_9;
    var phi_895_: type_9;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_954_: bool;
    var phi_871_: u32;
    var phi_873_: u32;
    var phi_955_: bool;
    var phi_956_: u32;
    var phi_967_: u32;
    var phi_968_: u32;
    var phi_969_: u32;
    var phi_983_: u32;
    var phi_995_: u32;
    var phi_996_: array<u32, 2>;
    var phi_997_: u32;
    var phi_998_: array<u32, 2>;
    var phi_1010_: array<u32, 2>;
    var phi_1011_: array<u32, 2>;
    var phi_1055_: u32;
    var phi_1142_: u32;
    var phi_1145_: type_9;
    var phi_1148_: u32;
    var phi_1150_: u32;
    var phi_1152_: u32;
    var phi_1146_: type_9;
    var phi_1175_: type_9;
    var phi_1201_: u32;
    var phi_1306_: u32;
    var phi_1307_: u32;
    var phi_1308_: u32;
    var phi_1309_: bool;
    var phi_1149_: u32;
    var phi_1151_: u32;
    var phi_1153_: u32;
    var phi_1310_: bool;
    var phi_1311_: bool;
    var phi_1312_: bool;
    var phi_1335_: u32;
    var phi_1340_: u32;
    var phi_1413_: type_9;
    var phi_1414_: type_9;
    var phi_1437_: type_9;
    var phi_1497_: u32;
    var phi_1500_: type_9;
    var phi_1501_: type_9;
    var phi_1524_: type_9;
    var phi_1605_: type_9;
    var phi_1606_: type_9;
    var phi_1629_: type_9;
    var phi_1721_: bool;
    var phi_1722_: bool;
    var local: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e59 = id_2;
    let _e60 = n_2;
    let _e61 = lane_2;
    let _e72 = ((_e59.y * _e60.x) + _e59.x);
    let _e75 = params.member.member_2.member;
    let _e77 = params.member.member_1;
    let _e80 = (_e77.member_1 % 2u);
    let _e82 = atomicLoad((&control.member[_e77.member_1]));
    if (_e75.member_3 < _e82) {
        phi_170_ = _e75.member_3;
    } else {
        phi_170_ = _e82;
    }
    let _e85 = phi_170_;
    let _e86 = (_e80 * _e75.member_3);
    let _e88 = ((1u - _e80) * _e75.member_3);
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_208_ = type_9(0u, _e75.member_11);
    loop {
        let _e97 = phi_208_;
        if (_e97.member < _e97.member_1) {
            phi_209_ = type_9((_e97.member + 1u), _e97.member_1);
            phi_232_ = type_9(1u, _e97.member);
        } else {
            phi_209_ = _e97;
            phi_232_ = type_9(0u, type_9().member_1);
        }
        let _e109 = phi_209_;
        let _e111 = phi_232_;
        if (bitcast<i32>(_e111.member) != 0i) {
            if (_e61 == 0u) {
                let _e122 = atomicLoad((&shared_[0u]));
                if (4u < _e122) {
                    phi_256_ = 4u;
                } else {
                    phi_256_ = _e122;
                }
                let _e125 = phi_256_;
                if (_e75.member_9 > 0u) {
                    if (_e111.member_1 >= 16u) {
                        let _e130 = atomicLoad((&control.member[(1024u + _e77.member_1)]));
                        if (_e75.member_9 > 0u) {
                            phi_287_ = ((_e130 * 100u) >= (_e75.member_9 << bitcast<u32>((_e75.member_7 & 31u))));
                        } else {
                            phi_287_ = false;
                        }
                        let _e138 = phi_287_;
                        if _e138 {
                            phi_291_ = 2u;
                        } else {
                            phi_291_ = 0u;
                        }
                        let _e140 = phi_291_;
                        phi_292_ = _e140;
                    } else {
                        phi_292_ = 0u;
                    }
                    let _e142 = phi_292_;
                    phi_293_ = _e142;
                } else {
                    phi_293_ = 0u;
                }
                let _e144 = phi_293_;
                let _e145 = (4u - _e125);
                if (_e144 == 0u) {
                    if (_e145 > 0u) {
                        let _e149 = atomicLoad((&shared_[5u]));
                        if (_e75.member_6 == 0u) {
                            if (_e72 < _e85) {
                                phi_321_ = ((((_e85 - 1u) - _e72) >> bitcast<u32>((_e75.member_7 & 31u))) + 1u);
                            } else {
                                phi_321_ = 0u;
                            }
                            let _e190 = phi_321_;
                            let _e191 = (_e190 - _e149);
                            if (_e145 < _e191) {
                                phi_327_ = _e145;
                            } else {
                                phi_327_ = _e191;
                            }
                            let _e194 = phi_327_;
                            atomicStore((&shared_[3u]), (_e72 + (_e149 << bitcast<u32>((_e75.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e75.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e149 + _e194));
                            phi_392_ = _e194;
                        } else {
                            if (_e149 == 0u) {
                                let _e155 = (_e85 >> bitcast<u32>(((_e75.member_7 + 2u) & 31u)));
                                if (_e75.member_8 < _e155) {
                                    phi_353_ = _e155;
                                } else {
                                    phi_353_ = _e75.member_8;
                                }
                                let _e158 = phi_353_;
                                if (128u < _e158) {
                                    phi_358_ = 128u;
                                } else {
                                    phi_358_ = _e158;
                                }
                                let _e161 = phi_358_;
                                if (_e145 < _e161) {
                                    phi_363_ = _e145;
                                } else {
                                    phi_363_ = _e161;
                                }
                                let _e164 = phi_363_;
                                let _e167 = atomicAdd((&control.member[(512u + _e77.member_1)]), _e164);
                                if (_e85 < _e167) {
                                    phi_376_ = _e85;
                                } else {
                                    phi_376_ = _e167;
                                }
                                let _e170 = phi_376_;
                                let _e171 = (_e85 - _e170);
                                if (_e164 < _e171) {
                                    phi_382_ = _e164;
                                } else {
                                    phi_382_ = _e171;
                                }
                                let _e174 = phi_382_;
                                atomicStore((&shared_[3u]), _e167);
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), select(0u, 1u, (_e174 < _e164)));
                                phi_391_ = _e174;
                            } else {
                                phi_391_ = 0u;
                            }
                            let _e181 = phi_391_;
                            phi_392_ = _e181;
                        }
                        let _e207 = phi_392_;
                        phi_393_ = _e207;
                    } else {
                        phi_393_ = 0u;
                    }
                    let _e209 = phi_393_;
                    phi_394_ = _e209;
                } else {
                    phi_394_ = 0u;
                }
                let _e211 = phi_394_;
                if (_e144 == 0u) {
                    if ((_e125 + _e211) == 0u) {
                        if (_e75.member_9 > 0u) {
                            let _e218 = atomicAdd((&control.member[(1024u + _e77.member_1)]), 1u);
                        }
                        phi_414_ = 1u;
                    } else {
                        phi_414_ = _e144;
                    }
                    let _e220 = phi_414_;
                    phi_415_ = _e220;
                } else {
                    phi_415_ = _e144;
                }
                let _e222 = phi_415_;
                atomicStore((&shared_[1u]), _e125);
                atomicStore((&shared_[2u]), _e211);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                phi_429_ = type_9(0u, 4u);
                loop {
                    let _e229 = phi_429_;
                    if (_e229.member < _e229.member_1) {
                        phi_430_ = type_9((_e229.member + 1u), _e229.member_1);
                        phi_453_ = type_9(1u, _e229.member);
                    } else {
                        phi_430_ = _e229;
                        phi_453_ = type_9(0u, type_9().member_1);
                    }
                    let _e241 = phi_430_;
                    let _e243 = phi_453_;
                    let _e247 = (bitcast<i32>(_e243.member) != 0i);
                    if _e247 {
                        atomicStore((&shared_[(18u + _e243.member_1)]), 0u);
                    }
                    continue;
                    continuing {
                        phi_429_ = _e241;
                        break if !(_e247);
                    }
                }
                state[0u] = _e222;
            }
            let _e253 = workgroupUniformLoad((&state[0u]));
            if (_e253 != 0u) {
                phi_1311_ = false;
            } else {
                let _e255 = (_e61 / 32u);
                let _e257 = atomicLoad((&shared_[1u]));
                let _e259 = atomicLoad((&shared_[2u]));
                if (_e255 < _e257) {
                    let _e282 = atomicLoad((&shared_[0u]));
                    let _e285 = (2u * ((_e282 - 1u) - _e255));
                    let _e287 = stack[_e285];
                    let _e290 = stack[(_e285 + 1u)];
                    phi_537_ = array<u32, 2>(_e287, _e290);
                } else {
                    if (_e255 < (_e257 + _e259)) {
                        let _e264 = atomicLoad((&shared_[3u]));
                        let _e267 = atomicLoad((&shared_[4u]));
                        let _e271 = (2u * (_e86 + (_e264 + ((_e255 - _e257) * _e267))));
                        let _e274 = atomicLoad((&nodes.member[(4u + _e271)]));
                        let _e277 = atomicLoad((&nodes.member[(_e271 + 5u)]));
                        phi_536_ = array<u32, 2>(_e274, _e277);
                    } else {
                        phi_536_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e280 = phi_536_;
                    phi_537_ = _e280;
                }
                let _e293 = phi_537_;
                let _e294 = (_e61 / 32u);
                let _e295 = (_e61 % 32u);
                let _e297 = (_e293[0] != 4294967295u);
                if _e297 {
                    phi_554_ = _e293;
                } else {
                    phi_554_ = array<u32, 2>(134217728u, 0u);
                }
                let _e299 = phi_554_;
                let _e303 = (_e299[0] >> bitcast<u32>(27u));
                let _e304 = (_e299[0] & 134217727u);
                let _e305 = (_e303 - 1u);
                let _e307 = ((_e304 * 32u) + _e295);
                let _e308 = (_e299[1] * 32u);
                let _e312 = params.member.member_2.member.member;
                if (_e312 == 0u) {
                    phi_572_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_572_ = array<u32, 2>(1u, 1u);
                }
                let _e315 = phi_572_;
                let _e321 = params.member.member.member[_e315[1]];
                let _e322 = (5u * _e305);
                if (_e321 > 0u) {
                    if (_e322 < 32u) {
                        phi_595_ = (((_e321 - 1u) >> bitcast<u32>((_e322 & 31u))) + 1u);
                        phi_596_ = false;
                    } else {
                        phi_595_ = u32();
                        phi_596_ = true;
                    }
                    let _e331 = phi_595_;
                    let _e333 = phi_596_;
                    phi_597_ = _e331;
                    phi_598_ = _e333;
                } else {
                    phi_597_ = u32();
                    phi_598_ = true;
                }
                let _e335 = phi_597_;
                let _e337 = phi_598_;
                if _e337 {
                    phi_604_ = select(0u, 1u, (_e321 > 0u));
                } else {
                    phi_604_ = _e335;
                }
                let _e341 = phi_604_;
                let _e342 = (_e299[1] * 32u);
                if (_e342 < _e341) {
                    phi_610_ = _e341;
                } else {
                    phi_610_ = _e342;
                }
                let _e345 = phi_610_;
                let _e346 = (_e345 - _e342);
                if (_e346 >= 32u) {
                    phi_619_ = 4294967295u;
                } else {
                    phi_619_ = ((1u << bitcast<u32>((_e346 & 31u))) - 1u);
                }
                let _e353 = phi_619_;
                let _e358 = params.member.member_2.member_1[_e305][1u];
                let _e359 = (_e358 + _e308);
                if _e297 {
                    if (((_e353 >> bitcast<u32>((_e295 & 31u))) & 1u) == 1u) {
                        let _e367 = boxes.member[(_e359 + _e295)];
                        let _e384 = params.member.member_2.member_1[_e303][0u];
                        let _e387 = boxes.member[(_e384 + _e304)];
                        if ((((((_e367.member.x <= _e387.member_1.y) && (_e387.member.x <= _e367.member_1.y)) && (_e367.member.y <= _e387.member_2.x)) && (_e387.member.y <= _e367.member_2.x)) && (_e367.member_1.x <= _e387.member_2.y)) && (_e387.member_1.x <= _e367.member_2.y)) {
                            let _e416 = atomicOr((&shared_[(18u + _e294)]), (1u << bitcast<u32>((_e295 & 31u))));
                        }
                    }
                    let _e420 = params.member.member.member[_e315[0]];
                    let _e421 = (5u * _e305);
                    if (_e420 > 0u) {
                        if (_e421 < 32u) {
                            phi_736_ = (((_e420 - 1u) >> bitcast<u32>((_e421 & 31u))) + 1u);
                            phi_737_ = false;
                        } else {
                            phi_736_ = u32();
                            phi_737_ = true;
                        }
                        let _e430 = phi_736_;
                        let _e432 = phi_737_;
                        phi_738_ = _e430;
                        phi_739_ = _e432;
                    } else {
                        phi_738_ = u32();
                        phi_739_ = true;
                    }
                    let _e434 = phi_738_;
                    let _e436 = phi_739_;
                    if _e436 {
                        phi_745_ = select(0u, 1u, (_e420 > 0u));
                    } else {
                        phi_745_ = _e434;
                    }
                    let _e440 = phi_745_;
                    if (_e307 < _e440) {
                        let _e446 = params.member.member_2.member_1[_e305][0u];
                        let _e449 = boxes.member[(_e446 + _e307)];
                        phi_786_ = type_20(array<f32, 3>(_e449.member.x, _e449.member.y, _e449.member_1.x), array<f32, 3>(_e449.member_1.y, _e449.member_2.x, _e449.member_2.y));
                        phi_787_ = true;
                    } else {
                        phi_786_ = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                        phi_787_ = false;
                    }
                    let _e466 = phi_786_;
                    let _e468 = phi_787_;
                    phi_788_ = _e466;
                    phi_789_ = _e468;
                } else {
                    phi_788_ = type_20(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                    phi_789_ = false;
                }
                let _e470 = phi_788_;
                let _e472 = phi_789_;
                workgroupBarrier();
                if _e472 {
                    let _e476 = params.member.member_2.member.member;
                    if (_e476 == 1u) {
                        phi_801_ = (_e304 == _e299[1]);
                    } else {
                        phi_801_ = false;
                    }
                    let _e480 = phi_801_;
                    if _e480 {
                        phi_807_ = (4294967295u << bitcast<u32>((_e295 & 31u)));
                    } else {
                        phi_807_ = 4294967295u;
                    }
                    let _e485 = phi_807_;
                    let _e490 = params.member.member_2.member_1[_e303][1u];
                    let _e493 = boxes.member[(_e490 + _e299[1])];
                    if ((((((_e470.member[0] <= _e493.member_1.y) && (_e493.member.x <= _e470.member_1[0])) && (_e470.member[1] <= _e493.member_2.x)) && (_e493.member.y <= _e470.member_1[1])) && (_e470.member[2] <= _e493.member_2.y)) && (_e493.member_1.x <= _e470.member_1[2])) {
                        let _e531 = atomicLoad((&shared_[(18u + _e294)]));
                        phi_867_ = type_9(0u, 32u);
                        phi_870_ = 0u;
                        phi_872_ = (_e531 & _e485);
                        loop {
                            let _e534 = phi_867_;
                            let _e536 = phi_870_;
                            let _e538 = phi_872_;
                            local = _e536;
                            if (_e534.member < _e534.member_1) {
                                phi_868_ = type_9((_e534.member + 1u), _e534.member_1);
                                phi_895_ = type_9(1u, _e534.member);
                            } else {
                                phi_868_ = _e534;
                                phi_895_ = type_9(0u, type_9().member_1);
                            }
                            let _e550 = phi_868_;
                            let _e552 = phi_895_;
                            if (bitcast<i32>(_e552.member) != 0i) {
                                if (_e538 == 0u) {
                                    phi_952_ = u32();
                                    phi_953_ = u32();
                                    phi_954_ = false;
                                } else {
                                    let _e559 = select(firstTrailingBit(_e538), 32u, (_e538 == 0u));
                                    let _e564 = boxes.member[(_e359 + _e559)];
                                    if ((((((_e470.member[0] <= _e564.member_1.y) && (_e564.member.x <= _e470.member_1[0])) && (_e470.member[1] <= _e564.member_2.x)) && (_e564.member.y <= _e470.member_1[1])) && (_e470.member[2] <= _e564.member_2.y)) && (_e564.member_1.x <= _e470.member_1[2])) {
                                        phi_951_ = (_e536 | (1u << bitcast<u32>((_e559 & 31u))));
                                    } else {
                                        phi_951_ = _e536;
                                    }
                                    let _e605 = phi_951_;
                                    phi_952_ = _e605;
                                    phi_953_ = (_e538 & (_e538 - 1u));
                                    phi_954_ = true;
                                }
                                let _e607 = phi_952_;
                                let _e609 = phi_953_;
                                let _e611 = phi_954_;
                                phi_871_ = _e607;
                                phi_873_ = _e609;
                                phi_955_ = _e611;
                            } else {
                                phi_871_ = u32();
                                phi_873_ = u32();
                                phi_955_ = false;
                            }
                            let _e613 = phi_871_;
                            let _e615 = phi_873_;
                            let _e617 = phi_955_;
                            continue;
                            continuing {
                                phi_867_ = _e550;
                                phi_870_ = _e613;
                                phi_872_ = _e615;
                                break if !(_e617);
                            }
                        }
                        let _e1142 = local;
                        phi_956_ = _e1142;
                    } else {
                        phi_956_ = 0u;
                    }
                    let _e620 = phi_956_;
                    let _e624 = params.member.member_2.member.member_4;
                    if (_e624 > 0u) {
                        phi_967_ = ((_e353 & _e485) & ~(_e620));
                    } else {
                        phi_967_ = 0u;
                    }
                    let _e630 = phi_967_;
                    phi_968_ = _e620;
                    phi_969_ = _e630;
                } else {
                    phi_968_ = 0u;
                    phi_969_ = 0u;
                }
                let _e632 = phi_968_;
                let _e634 = phi_969_;
                let _e636 = countOneBits(_e634);
                let _e637 = countOneBits(_e632);
                if (_e637 > 0u) {
                    if (_e305 > 1u) {
                        phi_983_ = 1u;
                    } else {
                        phi_983_ = 2u;
                    }
                    let _e641 = phi_983_;
                    if (_e641 == 1u) {
                        let _e648 = atomicAdd((&shared_[6u]), _e637);
                        phi_995_ = _e636;
                        phi_996_ = array<u32, 2>(_e648, 0u);
                    } else {
                        let _e644 = atomicAdd((&shared_[7u]), _e637);
                        phi_995_ = (_e636 + _e637);
                        phi_996_ = array<u32, 2>(_e644, 0u);
                    }
                    let _e651 = phi_995_;
                    let _e653 = phi_996_;
                    phi_997_ = _e651;
                    phi_998_ = _e653;
                } else {
                    phi_997_ = _e636;
                    phi_998_ = array<u32, 2>(0u, 0u);
                }
                let _e655 = phi_997_;
                let _e657 = phi_998_;
                if (_e75.member_4 > 0u) {
                    if (_e655 > 0u) {
                        let _e661 = atomicAdd((&shared_[8u]), _e655);
                        phi_1010_ = array<u32, 2>(_e657[0], _e661);
                    } else {
                        phi_1010_ = _e657;
                    }
                    let _e665 = phi_1010_;
                    phi_1011_ = _e665;
                } else {
                    phi_1011_ = _e657;
                }
                let _e667 = phi_1011_;
                workgroupBarrier();
                if (_e61 == 0u) {
                    let _e670 = atomicLoad((&shared_[6u]));
                    let _e672 = atomicLoad((&shared_[7u]));
                    let _e674 = atomicLoad((&shared_[8u]));
                    let _e676 = atomicLoad((&shared_[1u]));
                    let _e678 = atomicLoad((&shared_[2u]));
                    let _e680 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e680 + 1u));
                    let _e684 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e684 + _e676) + _e678));
                    let _e689 = atomicLoad((&shared_[0u]));
                    let _e690 = (_e689 - _e676);
                    let _e692 = (_e75.member_10 - _e690);
                    if (_e692 < _e670) {
                        phi_1055_ = _e692;
                    } else {
                        phi_1055_ = _e670;
                    }
                    let _e695 = phi_1055_;
                    atomicStore((&shared_[9u]), _e690);
                    atomicStore((&shared_[10u]), _e695);
                    atomicStore((&shared_[0u]), (_e690 + _e695));
                    if (_e670 > _e695) {
                        let _e701 = (_e670 - _e695);
                        if (_e75.member_12 == 0u) {
                        } else {
                            let _e705 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e708 = atomicAdd((&control.member[(_e77.member_1 + 1u)]), _e701);
                        let _e711 = atomicMax((&nodes.member[0u]), (_e708 + _e701));
                        if ((_e708 + _e701) < _e708) {
                            let _e715 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e708);
                    }
                    if (_e672 > 0u) {
                        let _e719 = atomicAdd((&pairs.member[0u]), _e672);
                        if ((_e719 + _e672) < _e719) {
                            let _e723 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e719);
                    }
                    if (_e674 > 0u) {
                        let _e727 = atomicAdd((&control.member[1537u]), _e674);
                        if ((_e727 + _e674) < _e727) {
                            let _e731 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e727);
                    }
                }
                workgroupBarrier();
                if (_e305 > 1u) {
                    phi_1142_ = 1u;
                } else {
                    phi_1142_ = 2u;
                }
                let _e738 = phi_1142_;
                phi_1145_ = type_9(0u, 32u);
                phi_1148_ = _e667[1];
                phi_1150_ = _e667[0];
                phi_1152_ = (_e632 | _e634);
                loop {
                    let _e740 = phi_1145_;
                    let _e742 = phi_1148_;
                    let _e744 = phi_1150_;
                    let _e746 = phi_1152_;
                    if (_e740.member < _e740.member_1) {
                        phi_1146_ = type_9((_e740.member + 1u), _e740.member_1);
                        phi_1175_ = type_9(1u, _e740.member);
                    } else {
                        phi_1146_ = _e740;
                        phi_1175_ = type_9(0u, type_9().member_1);
                    }
                    let _e758 = phi_1146_;
                    let _e760 = phi_1175_;
                    if (bitcast<i32>(_e760.member) != 0i) {
                        if (_e746 == 0u) {
                            phi_1306_ = u32();
                            phi_1307_ = u32();
                            phi_1308_ = u32();
                            phi_1309_ = false;
                        } else {
                            let _e767 = select(firstTrailingBit(_e746), 32u, (_e746 == 0u));
                            let _e770 = (_e308 + _e767);
                            let _e773 = ((_e305 << bitcast<u32>(27u)) | _e307);
                            if (((_e634 >> bitcast<u32>((_e767 & 31u))) & 1u) == 1u) {
                                phi_1201_ = 3u;
                            } else {
                                phi_1201_ = _e738;
                            }
                            let _e780 = phi_1201_;
                            if (_e780 == 1u) {
                                let _e813 = atomicLoad((&shared_[10u]));
                                if (_e744 < _e813) {
                                    let _e829 = atomicLoad((&shared_[9u]));
                                    let _e831 = (2u * (_e829 + _e744));
                                    stack[_e831] = _e773;
                                    stack[(_e831 + 1u)] = _e770;
                                } else {
                                    let _e816 = atomicLoad((&shared_[11u]));
                                    let _e818 = ((_e816 + _e744) - _e813);
                                    if (_e818 < _e75.member_3) {
                                        let _e821 = (_e88 + _e818);
                                        if (_e821 < 4294967295u) {
                                            let _e823 = (2u * _e821);
                                            atomicStore((&nodes.member[(4u + _e823)]), _e773);
                                            atomicStore((&nodes.member[(_e823 + 5u)]), _e770);
                                        }
                                    }
                                }
                            } else {
                                if (_e780 == 0u) {
                                } else {
                                    if (_e780 == 2u) {
                                        let _e786 = params.member.member_1;
                                        let _e789 = atomicLoad((&shared_[12u]));
                                        let _e790 = (_e789 + _e744);
                                        if (_e790 < _e786.member_3) {
                                            let _e792 = (2u * _e790);
                                            atomicStore((&pairs.member[(4u + _e792)]), (_e773 & 134217727u));
                                            atomicStore((&pairs.member[(_e792 + 5u)]), _e770);
                                        }
                                    }
                                    if (_e75.member_4 > 0u) {
                                        let _e800 = atomicLoad((&shared_[13u]));
                                        let _e801 = (_e800 + _e742);
                                        if (_e801 < _e75.member_4) {
                                            let _e808 = (2u * ((_e75.member_5 * _e75.member_4) + _e801));
                                            front.member[_e808] = _e773;
                                            front.member[(_e808 + 1u)] = _e770;
                                        }
                                    }
                                }
                            }
                            phi_1306_ = (_e742 + select(0u, 1u, (_e780 != 1u)));
                            phi_1307_ = (_e744 + select(0u, 1u, (_e780 != 3u)));
                            phi_1308_ = (_e746 & (_e746 - 1u));
                            phi_1309_ = true;
                        }
                        let _e842 = phi_1306_;
                        let _e844 = phi_1307_;
                        let _e846 = phi_1308_;
                        let _e848 = phi_1309_;
                        phi_1149_ = _e842;
                        phi_1151_ = _e844;
                        phi_1153_ = _e846;
                        phi_1310_ = _e848;
                    } else {
                        phi_1149_ = u32();
                        phi_1151_ = u32();
                        phi_1153_ = u32();
                        phi_1310_ = false;
                    }
                    let _e850 = phi_1149_;
                    let _e852 = phi_1151_;
                    let _e854 = phi_1153_;
                    let _e856 = phi_1310_;
                    continue;
                    continuing {
                        phi_1145_ = _e758;
                        phi_1148_ = _e850;
                        phi_1150_ = _e852;
                        phi_1152_ = _e854;
                        break if !(_e856);
                    }
                }
                phi_1311_ = true;
            }
            let _e859 = phi_1311_;
            phi_1312_ = _e859;
        } else {
            phi_1312_ = false;
        }
        let _e861 = phi_1312_;
        continue;
        continuing {
            phi_208_ = _e109;
            break if !(_e861);
        }
    }
    if (_e61 == 0u) {
        if (_e75.member_6 == 0u) {
            if (_e72 < _e85) {
                phi_1335_ = ((((_e85 - 1u) - _e72) >> bitcast<u32>((_e75.member_7 & 31u))) + 1u);
            } else {
                phi_1335_ = 0u;
            }
            let _e875 = phi_1335_;
            let _e877 = atomicLoad((&shared_[5u]));
            phi_1340_ = (_e875 - _e877);
        } else {
            phi_1340_ = 0u;
        }
        let _e880 = phi_1340_;
        atomicStore((&shared_[14u]), _e880);
        let _e883 = atomicLoad((&shared_[0u]));
        let _e884 = (_e883 + _e880);
        if (_e884 > 0u) {
            if (_e75.member_12 == 0u) {
            } else {
                let _e889 = atomicMax((&control.member[1536u]), 4294967295u);
            }
            let _e892 = atomicAdd((&control.member[(_e77.member_1 + 1u)]), _e884);
            let _e895 = atomicMax((&nodes.member[0u]), (_e892 + _e884));
            if ((_e892 + _e884) < _e892) {
                let _e899 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[17u]), _e892);
        }
        let _e904 = atomicLoad((&shared_[15u]));
        let _e906 = atomicAdd((&control.member[(1540u + (2u * _e72))]), _e904);
        let _e910 = atomicLoad((&shared_[16u]));
        let _e912 = atomicAdd((&control.member[((2u * _e72) + 1541u)]), _e910);
    }
    workgroupBarrier();
    let _e914 = atomicLoad((&shared_[0u]));
    let _e916 = atomicLoad((&shared_[17u]));
    let _e918 = atomicLoad((&shared_[14u]));
    phi_1413_ = type_9(0u, 8u);
    loop {
        let _e920 = phi_1413_;
        if (_e920.member < _e920.member_1) {
            phi_1414_ = type_9((_e920.member + 1u), _e920.member_1);
            phi_1437_ = type_9(1u, _e920.member);
        } else {
            phi_1414_ = _e920;
            phi_1437_ = type_9(0u, type_9().member_1);
        }
        let _e932 = phi_1414_;
        let _e934 = phi_1437_;
        let _e938 = (bitcast<i32>(_e934.member) != 0i);
        if _e938 {
            let _e940 = ((_e934.member_1 * 128u) + _e61);
            if (_e940 < _e914) {
                let _e944 = stack[(2u * _e940)];
                let _e948 = stack[((2u * _e940) + 1u)];
                let _e949 = (_e916 + _e940);
                if (_e949 < _e75.member_3) {
                    let _e952 = (_e88 + _e949);
                    if (_e952 < 4294967295u) {
                        let _e954 = (2u * _e952);
                        atomicStore((&nodes.member[(4u + _e954)]), _e944);
                        atomicStore((&nodes.member[(_e954 + 5u)]), _e948);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1413_ = _e932;
            break if !(_e938);
        }
    }
    let _e961 = atomicLoad((&shared_[5u]));
    let _e962 = (_e918 / 128u);
    if ((_e918 % 128u) > 0u) {
        phi_1497_ = (_e962 + 1u);
    } else {
        phi_1497_ = _e962;
    }
    let _e967 = phi_1497_;
    phi_1500_ = type_9(0u, _e967);
    loop {
        let _e970 = phi_1500_;
        if (_e970.member < _e970.member_1) {
            phi_1501_ = type_9((_e970.member + 1u), _e970.member_1);
            phi_1524_ = type_9(1u, _e970.member);
        } else {
            phi_1501_ = _e970;
            phi_1524_ = type_9(0u, type_9().member_1);
        }
        let _e982 = phi_1501_;
        let _e984 = phi_1524_;
        let _e988 = (bitcast<i32>(_e984.member) != 0i);
        if _e988 {
            let _e990 = ((_e984.member_1 * 128u) + _e61);
            if (_e990 < _e918) {
                let _e999 = (2u * ((_e86 + _e72) + ((_e961 + _e990) << bitcast<u32>((_e75.member_7 & 31u)))));
                let _e1002 = atomicLoad((&nodes.member[(4u + _e999)]));
                let _e1005 = atomicLoad((&nodes.member[(_e999 + 5u)]));
                let _e1007 = ((_e916 + _e914) + _e990);
                if (_e1007 < _e75.member_3) {
                    let _e1010 = (_e88 + _e1007);
                    if (_e1010 < 4294967295u) {
                        let _e1012 = (2u * _e1010);
                        atomicStore((&nodes.member[(4u + _e1012)]), _e1002);
                        atomicStore((&nodes.member[(_e1012 + 5u)]), _e1005);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_1500_ = _e982;
            break if !(_e988);
        }
    }
    if (_e75.member_6 == 1u) {
        if (_e961 == 0u) {
            phi_1605_ = type_9(0u, _e85);
            loop {
                let _e1023 = phi_1605_;
                if (_e1023.member < _e1023.member_1) {
                    phi_1606_ = type_9((_e1023.member + 1u), _e1023.member_1);
                    phi_1629_ = type_9(1u, _e1023.member);
                } else {
                    phi_1606_ = _e1023;
                    phi_1629_ = type_9(0u, type_9().member_1);
                }
                let _e1035 = phi_1606_;
                let _e1037 = phi_1629_;
                if (bitcast<i32>(_e1037.member) != 0i) {
                    let _e1043 = atomicAdd((&control.member[(512u + _e77.member_1)]), 1u);
                    if (_e1043 >= _e85) {
                        phi_1721_ = false;
                    } else {
                        let _e1046 = (2u * (_e86 + _e1043));
                        let _e1049 = atomicLoad((&nodes.member[(4u + _e1046)]));
                        let _e1052 = atomicLoad((&nodes.member[(_e1046 + 5u)]));
                        if (_e75.member_12 == 0u) {
                        } else {
                            let _e1056 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1059 = atomicAdd((&control.member[(_e77.member_1 + 1u)]), 1u);
                        let _e1062 = atomicMax((&nodes.member[0u]), (_e1059 + 1u));
                        if ((_e1059 + 1u) < _e1059) {
                            let _e1066 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1059 < _e75.member_3) {
                            let _e1069 = (_e88 + _e1059);
                            if (_e1069 < 4294967295u) {
                                let _e1071 = (2u * _e1069);
                                atomicStore((&nodes.member[(4u + _e1071)]), _e1049);
                                atomicStore((&nodes.member[(_e1071 + 5u)]), _e1052);
                            }
                        }
                        phi_1721_ = true;
                    }
                    let _e1077 = phi_1721_;
                    phi_1722_ = _e1077;
                } else {
                    phi_1722_ = false;
                }
                let _e1079 = phi_1722_;
                continue;
                continuing {
                    phi_1605_ = _e1035;
                    break if !(_e1079);
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
