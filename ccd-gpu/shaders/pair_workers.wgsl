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
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_18 {
    member: array<type_16>,
}

struct type_20 {
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

struct type_21 {
    member: type_7,
    member_1: type_8,
    member_2: type_20,
}

struct type_22 {
    member: type_21,
}

struct type_24 {
    member: array<array<u32, 2>, 4>,
    member_1: array<array<u32, 2>, 4>,
}

struct type_25 {
    member: array<u32, 2>,
    member_1: u32,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(6) 
var<storage, read_write> front: type_11;
@group(0) @binding(5) 
var<storage, read_write> pairs: type_28;
@group(0) @binding(1) 
var<storage> a: type_18;
@group(0) @binding(2) 
var<storage> b: type_18;
@group(0) @binding(3) 
var<storage, read_write> control: type_28;
@group(0) @binding(4) 
var<storage, read_write> nodes: type_28;
var<workgroup> shared_: array<atomic<u32>, 22>;
var<workgroup> state: array<u32, 1>;
var<workgroup> stack: array<u32, 2048>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_166_: u32;
    var phi_204_: type_9;
    var phi_205_: type_9;
    var phi_228_: type_9;
    var phi_252_: u32;
    var phi_283_: bool;
    var phi_287_: u32;
    var phi_288_: u32;
    var phi_289_: u32;
    var phi_387_: u32;
    var phi_392_: u32;
    var phi_397_: u32;
    var phi_410_: u32;
    var phi_416_: u32;
    var phi_425_: u32;
    var phi_354_: u32;
    var phi_360_: u32;
    var phi_366_: u32;
    var phi_426_: u32;
    var phi_317_: u32;
    var phi_323_: u32;
    var phi_427_: u32;
    var phi_428_: u32;
    var phi_429_: u32;
    var phi_449_: u32;
    var phi_450_: u32;
    var phi_533_: array<u32, 2>;
    var phi_534_: array<u32, 2>;
    var phi_551_: array<u32, 2>;
    var phi_580_: u32;
    var phi_654_: array<u32, 2>;
    var phi_668_: array<u32, 2>;
    var phi_705_: array<u32, 2>;
    var phi_707_: type_24;
    var phi_708_: type_24;
    var phi_709_: bool;
    var phi_710_: type_24;
    var phi_711_: bool;
    var phi_727_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_882_: array<u32, 2>;
    var phi_911_: array<u32, 2>;
    var phi_940_: array<u32, 2>;
    var phi_969_: array<u32, 2>;
    var phi_971_: type_24;
    var phi_972_: bool;
    var phi_973_: type_24;
    var phi_974_: bool;
    var phi_1147_: array<u32, 2>;
    var phi_1179_: array<u32, 2>;
    var phi_1047_: array<u32, 2>;
    var phi_1079_: array<u32, 2>;
    var phi_1181_: type_24;
    var phi_1182_: type_24;
    var phi_1183_: type_24;
    var phi_1184_: bool;
    var phi_1185_: type_24;
    var phi_1186_: type_24;
    var phi_1187_: bool;
    var phi_1191_: type_24;
    var phi_1202_: array<array<u32, 2>, 4>;
    var phi_1220_: bool;
    var phi_1221_: bool;
    var phi_1225_: u32;
    var phi_1226_: u32;
    var phi_1238_: type_25;
    var phi_1239_: type_25;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1262_: u32;
    var phi_1263_: u32;
    var phi_1275_: type_25;
    var phi_1276_: type_25;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1299_: u32;
    var phi_1300_: u32;
    var phi_1312_: type_25;
    var phi_1313_: type_25;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1336_: u32;
    var phi_1337_: u32;
    var phi_1349_: type_25;
    var phi_1350_: type_25;
    var phi_1366_: bool;
    var phi_1367_: bool;
    var phi_1371_: u32;
    var phi_1372_: u32;
    var phi_1378_: type_25;
    var phi_1379_: type_25;
    var phi_1380_: type_25;
    var phi_1381_: type_25;
    var phi_1382_: type_25;
    var phi_1402_: array<u32, 2>;
    var phi_1403_: array<u32, 2>;
    var phi_1415_: array<u32, 2>;
    var phi_1416_: array<u32, 2>;
    var phi_1433_: array<u32, 2>;
    var phi_1434_: array<u32, 2>;
    var phi_1446_: array<u32, 2>;
    var phi_1447_: array<u32, 2>;
    var phi_1464_: array<u32, 2>;
    var phi_1465_: array<u32, 2>;
    var phi_1477_: array<u32, 2>;
    var phi_1478_: array<u32, 2>;
    var phi_1495_: array<u32, 2>;
    var phi_1496_: array<u32, 2>;
    var phi_1508_: array<u32, 2>;
    var phi_1509_: array<u32, 2>;
    var phi_1553_: u32;
    var phi_1738_: type_9;
    var phi_1743_: type_9;
    var phi_1901_: type_9;
    var phi_1906_: type_9;
    var phi_2064_: type_9;
    var phi_2069_: type_9;
    var phi_2227_: type_9;
    var phi_2232_: type_9;
    var phi_2285_: bool;
    var phi_2286_: bool;
    var phi_2309_: u32;
    var phi_2314_: u32;
    var phi_2340_: u32;
    var phi_2346_: u32;
    var phi_2434_: type_9;
    var phi_2435_: type_9;
    var phi_2458_: type_9;
    var phi_2549_: u32;
    var phi_2552_: type_9;
    var phi_2553_: type_9;
    var phi_2576_: type_9;
    var phi_2657_: type_9;
    var phi_2658_: type_9;
    var phi_2681_: type_9;
    var phi_2773_: bool;
    var phi_2774_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e69 = ((_e55.y * _e56.x) + _e55.x);
    let _e71 = params.member.member_2;
    let _e73 = params.member.member_1;
    let _e76 = (_e73.member_1 % 2u);
    let _e78 = atomicLoad((&control.member[_e73.member_1]));
    if (_e71.member_3 < _e78) {
        phi_166_ = _e71.member_3;
    } else {
        phi_166_ = _e78;
    }
    let _e81 = phi_166_;
    let _e82 = (_e76 * _e71.member_3);
    let _e84 = ((1u - _e76) * _e71.member_3);
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
        atomicStore((&shared_[5u]), 0u);
        atomicStore((&shared_[15u]), 0u);
        atomicStore((&shared_[16u]), 0u);
    }
    phi_204_ = type_9(0u, _e71.member_11);
    loop {
        let _e93 = phi_204_;
        if (_e93.member < _e93.member_1) {
            phi_205_ = type_9((_e93.member + 1u), _e93.member_1);
            phi_228_ = type_9(1u, _e93.member);
        } else {
            phi_205_ = _e93;
            phi_228_ = type_9(0u, type_9().member_1);
        }
        let _e105 = phi_205_;
        let _e107 = phi_228_;
        if (bitcast<i32>(_e107.member) != 0i) {
            if (_e57 == 0u) {
                let _e118 = atomicLoad((&shared_[0u]));
                if (128u < _e118) {
                    phi_252_ = 128u;
                } else {
                    phi_252_ = _e118;
                }
                let _e121 = phi_252_;
                if (_e71.member_9 > 0u) {
                    if (_e107.member_1 >= 16u) {
                        let _e126 = atomicLoad((&control.member[(1024u + _e73.member_1)]));
                        if (_e71.member_9 > 0u) {
                            phi_283_ = ((_e126 * 100u) >= (_e71.member_9 << bitcast<u32>((_e71.member_7 & 31u))));
                        } else {
                            phi_283_ = false;
                        }
                        let _e134 = phi_283_;
                        if _e134 {
                            phi_287_ = 2u;
                        } else {
                            phi_287_ = 0u;
                        }
                        let _e136 = phi_287_;
                        phi_288_ = _e136;
                    } else {
                        phi_288_ = 0u;
                    }
                    let _e138 = phi_288_;
                    phi_289_ = _e138;
                } else {
                    phi_289_ = 0u;
                }
                let _e140 = phi_289_;
                let _e141 = (128u - _e121);
                if (_e140 == 0u) {
                    if (_e141 > 0u) {
                        let _e145 = atomicLoad((&shared_[5u]));
                        if (_e71.member_6 == 0u) {
                            if (_e69 < _e81) {
                                phi_317_ = ((((_e81 - 1u) - _e69) >> bitcast<u32>((_e71.member_7 & 31u))) + 1u);
                            } else {
                                phi_317_ = 0u;
                            }
                            let _e214 = phi_317_;
                            let _e215 = (_e214 - _e145);
                            if (_e141 < _e215) {
                                phi_323_ = _e141;
                            } else {
                                phi_323_ = _e215;
                            }
                            let _e218 = phi_323_;
                            atomicStore((&shared_[3u]), (_e69 + (_e145 << bitcast<u32>((_e71.member_7 & 31u)))));
                            atomicStore((&shared_[4u]), (1u << bitcast<u32>((_e71.member_7 & 31u))));
                            atomicStore((&shared_[5u]), (_e145 + _e218));
                            phi_427_ = _e218;
                        } else {
                            if (_e71.member_6 == 2u) {
                                let _e186 = (((_e81 + (1u << bitcast<u32>((_e71.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e71.member_7 & 31u)));
                                let _e187 = (_e69 * _e186);
                                if (_e81 < _e187) {
                                    phi_354_ = _e81;
                                } else {
                                    phi_354_ = _e187;
                                }
                                let _e190 = phi_354_;
                                let _e191 = (_e81 - _e190);
                                if (_e191 < _e186) {
                                    phi_360_ = _e191;
                                } else {
                                    phi_360_ = _e186;
                                }
                                let _e194 = phi_360_;
                                let _e195 = (_e194 - _e145);
                                if (_e141 < _e195) {
                                    phi_366_ = _e141;
                                } else {
                                    phi_366_ = _e195;
                                }
                                let _e198 = phi_366_;
                                atomicStore((&shared_[3u]), (_e190 + _e145));
                                atomicStore((&shared_[4u]), 1u);
                                atomicStore((&shared_[5u]), (_e145 + _e198));
                                phi_426_ = _e198;
                            } else {
                                if (_e145 == 0u) {
                                    let _e152 = (_e81 >> bitcast<u32>(((_e71.member_7 + 2u) & 31u)));
                                    if (_e71.member_8 < _e152) {
                                        phi_387_ = _e152;
                                    } else {
                                        phi_387_ = _e71.member_8;
                                    }
                                    let _e155 = phi_387_;
                                    if (128u < _e155) {
                                        phi_392_ = 128u;
                                    } else {
                                        phi_392_ = _e155;
                                    }
                                    let _e158 = phi_392_;
                                    if (_e141 < _e158) {
                                        phi_397_ = _e141;
                                    } else {
                                        phi_397_ = _e158;
                                    }
                                    let _e161 = phi_397_;
                                    let _e164 = atomicAdd((&control.member[(512u + _e73.member_1)]), _e161);
                                    if (_e81 < _e164) {
                                        phi_410_ = _e81;
                                    } else {
                                        phi_410_ = _e164;
                                    }
                                    let _e167 = phi_410_;
                                    let _e168 = (_e81 - _e167);
                                    if (_e161 < _e168) {
                                        phi_416_ = _e161;
                                    } else {
                                        phi_416_ = _e168;
                                    }
                                    let _e171 = phi_416_;
                                    atomicStore((&shared_[3u]), _e164);
                                    atomicStore((&shared_[4u]), 1u);
                                    atomicStore((&shared_[5u]), select(0u, 1u, (_e171 < _e161)));
                                    phi_425_ = _e171;
                                } else {
                                    phi_425_ = 0u;
                                }
                                let _e178 = phi_425_;
                                phi_426_ = _e178;
                            }
                            let _e205 = phi_426_;
                            phi_427_ = _e205;
                        }
                        let _e231 = phi_427_;
                        phi_428_ = _e231;
                    } else {
                        phi_428_ = 0u;
                    }
                    let _e233 = phi_428_;
                    phi_429_ = _e233;
                } else {
                    phi_429_ = 0u;
                }
                let _e235 = phi_429_;
                if (_e140 == 0u) {
                    if ((_e121 + _e235) == 0u) {
                        if (_e71.member_9 > 0u) {
                            let _e242 = atomicAdd((&control.member[(1024u + _e73.member_1)]), 1u);
                        }
                        phi_449_ = 1u;
                    } else {
                        phi_449_ = _e140;
                    }
                    let _e244 = phi_449_;
                    phi_450_ = _e244;
                } else {
                    phi_450_ = _e140;
                }
                let _e246 = phi_450_;
                atomicStore((&shared_[1u]), _e121);
                atomicStore((&shared_[2u]), _e235);
                atomicStore((&shared_[6u]), 0u);
                atomicStore((&shared_[7u]), 0u);
                atomicStore((&shared_[8u]), 0u);
                state[0u] = _e246;
            }
            let _e254 = workgroupUniformLoad((&state[0u]));
            if (_e254 != 0u) {
                phi_2285_ = false;
            } else {
                let _e257 = atomicLoad((&shared_[1u]));
                let _e259 = atomicLoad((&shared_[2u]));
                if (_e57 < _e257) {
                    let _e282 = atomicLoad((&shared_[0u]));
                    let _e285 = (2u * ((_e282 - 1u) - _e57));
                    let _e287 = stack[_e285];
                    let _e290 = stack[(_e285 + 1u)];
                    phi_534_ = array<u32, 2>(_e287, _e290);
                } else {
                    if (_e57 < (_e257 + _e259)) {
                        let _e264 = atomicLoad((&shared_[3u]));
                        let _e267 = atomicLoad((&shared_[4u]));
                        let _e271 = (2u * (_e82 + (_e264 + ((_e57 - _e257) * _e267))));
                        let _e274 = atomicLoad((&nodes.member[(4u + _e271)]));
                        let _e277 = atomicLoad((&nodes.member[(_e271 + 5u)]));
                        phi_533_ = array<u32, 2>(_e274, _e277);
                    } else {
                        phi_533_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e280 = phi_533_;
                    phi_534_ = _e280;
                }
                let _e293 = phi_534_;
                let _e296 = params.member.member_2.member;
                let _e300 = params.member.member_2.member;
                if (_e300 == 0u) {
                    phi_551_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_551_ = array<u32, 2>(1u, 1u);
                }
                let _e303 = phi_551_;
                let _e309 = params.member.member.member[_e303[0]];
                let _e310 = (_e309 - 1u);
                let _e314 = params.member.member.member[_e303[1]];
                let _e315 = (_e314 - 1u);
                let _e318 = params.member.member_2.member_1;
                if (_e318 == 0u) {
                    phi_580_ = 1u;
                } else {
                    phi_580_ = 0u;
                }
                let _e321 = phi_580_;
                if (_e293[0] != 4294967295u) {
                    let _e327 = a.member[_e293[0]];
                    let _e329 = b.member[_e293[1]];
                    if (_e296 == 1u) {
                        if (_e293[0] == _e293[1]) {
                            if (_e327.member_3 == 4294967295u) {
                                phi_707_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                            } else {
                                let _e335 = a.member[_e327.member_1];
                                let _e338 = a.member[_e327.member_3];
                                if !((_e335.member_3 == 4294967295u)) {
                                    phi_654_ = array<u32, 2>(_e327.member_1, _e327.member_1);
                                } else {
                                    phi_654_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e345 = phi_654_;
                                let _e352 = type_24(array<array<u32, 2>, 4>(_e345, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                let _e364 = type_24(array<array<u32, 2>, 4>(_e352.member[0], array<u32, 2>(_e327.member_1, _e352.member[1][1]), _e352.member[2], _e352.member[3]), _e352.member_1);
                                let _e365 = array<u32, 2>(_e327.member_1, _e327.member_3);
                                let _e372 = type_24(array<array<u32, 2>, 4>(_e364.member[0], _e365, _e364.member[2], _e364.member[3]), _e364.member_1);
                                if !((_e338.member_3 == 4294967295u)) {
                                    phi_668_ = array<u32, 2>(_e327.member_3, _e327.member_3);
                                } else {
                                    phi_668_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e379 = phi_668_;
                                let _e386 = type_24(array<array<u32, 2>, 4>(_e372.member[0], _e372.member[1], _e379, _e372.member[3]), _e372.member_1);
                                let _e389 = type_24(_e386.member, _e386.member);
                                if ((((((_e335.member[0] <= _e338.member_2[0]) && (_e338.member[0] <= _e335.member_2[0])) && (_e335.member[1] <= _e338.member_2[1])) && (_e338.member[1] <= _e335.member_2[1])) && (_e335.member[2] <= _e338.member_2[2])) && (_e338.member[2] <= _e335.member_2[2])) {
                                    phi_705_ = _e365;
                                } else {
                                    phi_705_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e418 = phi_705_;
                                phi_707_ = type_24(_e389.member, array<array<u32, 2>, 4>(_e389.member_1[0], _e418, _e389.member_1[2], _e389.member_1[3]));
                            }
                            let _e427 = phi_707_;
                            phi_708_ = _e427;
                            phi_709_ = false;
                        } else {
                            phi_708_ = type_24();
                            phi_709_ = true;
                        }
                        let _e429 = phi_708_;
                        let _e431 = phi_709_;
                        phi_710_ = _e429;
                        phi_711_ = _e431;
                    } else {
                        phi_710_ = type_24();
                        phi_711_ = true;
                    }
                    let _e433 = phi_710_;
                    let _e435 = phi_711_;
                    if _e435 {
                        let _e438 = !((_e327.member_3 == 4294967295u));
                        let _e441 = !((_e329.member_3 == 4294967295u));
                        if _e438 {
                            phi_727_ = true;
                        } else {
                            phi_727_ = _e441;
                        }
                        let _e443 = phi_727_;
                        if _e443 {
                            if _e438 {
                                if _e441 {
                                    if (_e321 == 0u) {
                                        let _e471 = ((((_e329.member_2[0] - _e329.member[0]) * (_e329.member_2[1] - _e329.member[1])) * (_e329.member_2[2] - _e329.member[2])) > (((_e327.member_2[0] - _e327.member[0]) * (_e327.member_2[1] - _e327.member[1])) * (_e327.member_2[2] - _e327.member[2])));
                                        phi_771_ = _e471;
                                        phi_772_ = !(_e471);
                                    } else {
                                        phi_771_ = _e441;
                                        phi_772_ = _e438;
                                    }
                                    let _e474 = phi_771_;
                                    let _e476 = phi_772_;
                                    phi_773_ = _e474;
                                    phi_774_ = _e476;
                                } else {
                                    phi_773_ = _e441;
                                    phi_774_ = _e438;
                                }
                                let _e478 = phi_773_;
                                let _e480 = phi_774_;
                                phi_775_ = _e478;
                                phi_776_ = _e480;
                            } else {
                                phi_775_ = _e441;
                                phi_776_ = _e438;
                            }
                            let _e482 = phi_775_;
                            let _e484 = phi_776_;
                            if _e484 {
                                if _e482 {
                                    let _e487 = a.member[_e327.member_1];
                                    let _e492 = a.member[_e327.member_3];
                                    let _e497 = b.member[_e329.member_1];
                                    let _e502 = b.member[_e329.member_3];
                                    let _e507 = array<u32, 2>(_e327.member_1, _e329.member_1);
                                    let _e510 = array<u32, 2>(_e327.member_1, _e329.member_3);
                                    let _e513 = array<u32, 2>(_e327.member_3, _e329.member_1);
                                    let _e516 = array<u32, 2>(_e327.member_3, _e329.member_3);
                                    if ((((((_e487.member[0] <= _e497.member_2[0]) && (_e497.member[0] <= _e487.member_2[0])) && (_e487.member[1] <= _e497.member_2[1])) && (_e497.member[1] <= _e487.member_2[1])) && (_e487.member[2] <= _e497.member_2[2])) && (_e497.member[2] <= _e487.member_2[2])) {
                                        phi_882_ = _e507;
                                    } else {
                                        phi_882_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e542 = phi_882_;
                                    if ((((((_e487.member[0] <= _e502.member_2[0]) && (_e502.member[0] <= _e487.member_2[0])) && (_e487.member[1] <= _e502.member_2[1])) && (_e502.member[1] <= _e487.member_2[1])) && (_e487.member[2] <= _e502.member_2[2])) && (_e502.member[2] <= _e487.member_2[2])) {
                                        phi_911_ = _e510;
                                    } else {
                                        phi_911_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e567 = phi_911_;
                                    if ((((((_e492.member[0] <= _e497.member_2[0]) && (_e497.member[0] <= _e492.member_2[0])) && (_e492.member[1] <= _e497.member_2[1])) && (_e497.member[1] <= _e492.member_2[1])) && (_e492.member[2] <= _e497.member_2[2])) && (_e497.member[2] <= _e492.member_2[2])) {
                                        phi_940_ = _e513;
                                    } else {
                                        phi_940_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e592 = phi_940_;
                                    if ((((((_e492.member[0] <= _e502.member_2[0]) && (_e502.member[0] <= _e492.member_2[0])) && (_e492.member[1] <= _e502.member_2[1])) && (_e502.member[1] <= _e492.member_2[1])) && (_e492.member[2] <= _e502.member_2[2])) && (_e502.member[2] <= _e492.member_2[2])) {
                                        phi_969_ = _e516;
                                    } else {
                                        phi_969_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e617 = phi_969_;
                                    phi_971_ = type_24(array<array<u32, 2>, 4>(_e507, _e510, _e513, _e516), array<array<u32, 2>, 4>(_e542, _e567, _e592, _e617));
                                    phi_972_ = false;
                                } else {
                                    phi_971_ = type_24();
                                    phi_972_ = true;
                                }
                                let _e621 = phi_971_;
                                let _e623 = phi_972_;
                                phi_973_ = _e621;
                                phi_974_ = _e623;
                            } else {
                                phi_973_ = type_24();
                                phi_974_ = true;
                            }
                            let _e625 = phi_973_;
                            let _e627 = phi_974_;
                            if _e627 {
                                if _e484 {
                                    let _e715 = a.member[_e327.member_1];
                                    let _e720 = a.member[_e327.member_3];
                                    let _e724 = array<u32, 2>(_e327.member_1, _e293[1]);
                                    let _e726 = array<u32, 2>(_e327.member_3, _e293[1]);
                                    let _e729 = type_24(array<array<u32, 2>, 4>(_e724, _e726, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e715.member[0] <= _e329.member_2[0]) && (_e329.member[0] <= _e715.member_2[0])) && (_e715.member[1] <= _e329.member_2[1])) && (_e329.member[1] <= _e715.member_2[1])) && (_e715.member[2] <= _e329.member_2[2])) && (_e329.member[2] <= _e715.member_2[2])) {
                                        phi_1047_ = _e724;
                                    } else {
                                        phi_1047_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e756 = phi_1047_;
                                    let _e763 = type_24(_e729.member, array<array<u32, 2>, 4>(_e756, _e729.member_1[1], _e729.member_1[2], _e729.member_1[3]));
                                    if ((((((_e720.member[0] <= _e329.member_2[0]) && (_e329.member[0] <= _e720.member_2[0])) && (_e720.member[1] <= _e329.member_2[1])) && (_e329.member[1] <= _e720.member_2[1])) && (_e720.member[2] <= _e329.member_2[2])) && (_e329.member[2] <= _e720.member_2[2])) {
                                        phi_1079_ = _e726;
                                    } else {
                                        phi_1079_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e790 = phi_1079_;
                                    phi_1181_ = type_24(_e763.member, array<array<u32, 2>, 4>(_e763.member_1[0], _e790, _e763.member_1[2], _e763.member_1[3]));
                                } else {
                                    let _e630 = b.member[_e329.member_1];
                                    let _e635 = b.member[_e329.member_3];
                                    let _e639 = array<u32, 2>(_e293[0], _e329.member_1);
                                    let _e641 = array<u32, 2>(_e293[0], _e329.member_3);
                                    let _e644 = type_24(array<array<u32, 2>, 4>(_e639, _e641, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                                    if ((((((_e327.member[0] <= _e630.member_2[0]) && (_e630.member[0] <= _e327.member_2[0])) && (_e327.member[1] <= _e630.member_2[1])) && (_e630.member[1] <= _e327.member_2[1])) && (_e327.member[2] <= _e630.member_2[2])) && (_e630.member[2] <= _e327.member_2[2])) {
                                        phi_1147_ = _e639;
                                    } else {
                                        phi_1147_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e671 = phi_1147_;
                                    let _e678 = type_24(_e644.member, array<array<u32, 2>, 4>(_e671, _e644.member_1[1], _e644.member_1[2], _e644.member_1[3]));
                                    if ((((((_e327.member[0] <= _e635.member_2[0]) && (_e635.member[0] <= _e327.member_2[0])) && (_e327.member[1] <= _e635.member_2[1])) && (_e635.member[1] <= _e327.member_2[1])) && (_e327.member[2] <= _e635.member_2[2])) && (_e635.member[2] <= _e327.member_2[2])) {
                                        phi_1179_ = _e641;
                                    } else {
                                        phi_1179_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e705 = phi_1179_;
                                    phi_1181_ = type_24(_e678.member, array<array<u32, 2>, 4>(_e678.member_1[0], _e705, _e678.member_1[2], _e678.member_1[3]));
                                }
                                let _e799 = phi_1181_;
                                phi_1182_ = _e799;
                            } else {
                                phi_1182_ = _e625;
                            }
                            let _e801 = phi_1182_;
                            phi_1183_ = _e801;
                            phi_1184_ = false;
                        } else {
                            phi_1183_ = type_24();
                            phi_1184_ = true;
                        }
                        let _e803 = phi_1183_;
                        let _e805 = phi_1184_;
                        phi_1185_ = _e803;
                        phi_1186_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        phi_1187_ = _e805;
                    } else {
                        phi_1185_ = type_24();
                        phi_1186_ = _e433;
                        phi_1187_ = true;
                    }
                    let _e807 = phi_1185_;
                    let _e809 = phi_1186_;
                    let _e811 = phi_1187_;
                    if _e811 {
                        phi_1191_ = _e809;
                    } else {
                        phi_1191_ = _e807;
                    }
                    let _e813 = phi_1191_;
                    let _e817 = params.member.member_2.member_4;
                    if (_e817 > 0u) {
                        phi_1202_ = _e813.member;
                    } else {
                        phi_1202_ = _e813.member_1;
                    }
                    let _e821 = phi_1202_;
                    if (_e813.member_1[0][0] == 4294967295u) {
                        phi_1226_ = 0u;
                    } else {
                        if (_e813.member_1[0][0] >= _e310) {
                            if (_e813.member_1[0][1] >= _e315) {
                                phi_1220_ = false;
                            } else {
                                phi_1220_ = true;
                            }
                            let _e831 = phi_1220_;
                            phi_1221_ = _e831;
                        } else {
                            phi_1221_ = true;
                        }
                        let _e833 = phi_1221_;
                        if _e833 {
                            phi_1225_ = 1u;
                        } else {
                            phi_1225_ = 2u;
                        }
                        let _e835 = phi_1225_;
                        phi_1226_ = _e835;
                    }
                    let _e837 = phi_1226_;
                    let _e838 = type_25(_e813.member_1[0], _e837);
                    if (_e837 == 0u) {
                        if (_e821[0][0] != 4294967295u) {
                            phi_1238_ = type_25(_e821[0], 3u);
                        } else {
                            phi_1238_ = _e838;
                        }
                        let _e844 = phi_1238_;
                        phi_1239_ = _e844;
                    } else {
                        phi_1239_ = _e838;
                    }
                    let _e846 = phi_1239_;
                    if (_e813.member_1[1][0] == 4294967295u) {
                        phi_1263_ = 0u;
                    } else {
                        if (_e813.member_1[1][0] >= _e310) {
                            if (_e813.member_1[1][1] >= _e315) {
                                phi_1257_ = false;
                            } else {
                                phi_1257_ = true;
                            }
                            let _e856 = phi_1257_;
                            phi_1258_ = _e856;
                        } else {
                            phi_1258_ = true;
                        }
                        let _e858 = phi_1258_;
                        if _e858 {
                            phi_1262_ = 1u;
                        } else {
                            phi_1262_ = 2u;
                        }
                        let _e860 = phi_1262_;
                        phi_1263_ = _e860;
                    }
                    let _e862 = phi_1263_;
                    let _e863 = type_25(_e813.member_1[1], _e862);
                    if (_e862 == 0u) {
                        if (_e821[1][0] != 4294967295u) {
                            phi_1275_ = type_25(_e821[1], 3u);
                        } else {
                            phi_1275_ = _e863;
                        }
                        let _e869 = phi_1275_;
                        phi_1276_ = _e869;
                    } else {
                        phi_1276_ = _e863;
                    }
                    let _e871 = phi_1276_;
                    if (_e813.member_1[2][0] == 4294967295u) {
                        phi_1300_ = 0u;
                    } else {
                        if (_e813.member_1[2][0] >= _e310) {
                            if (_e813.member_1[2][1] >= _e315) {
                                phi_1294_ = false;
                            } else {
                                phi_1294_ = true;
                            }
                            let _e881 = phi_1294_;
                            phi_1295_ = _e881;
                        } else {
                            phi_1295_ = true;
                        }
                        let _e883 = phi_1295_;
                        if _e883 {
                            phi_1299_ = 1u;
                        } else {
                            phi_1299_ = 2u;
                        }
                        let _e885 = phi_1299_;
                        phi_1300_ = _e885;
                    }
                    let _e887 = phi_1300_;
                    let _e888 = type_25(_e813.member_1[2], _e887);
                    if (_e887 == 0u) {
                        if (_e821[2][0] != 4294967295u) {
                            phi_1312_ = type_25(_e821[2], 3u);
                        } else {
                            phi_1312_ = _e888;
                        }
                        let _e894 = phi_1312_;
                        phi_1313_ = _e894;
                    } else {
                        phi_1313_ = _e888;
                    }
                    let _e896 = phi_1313_;
                    if (_e813.member_1[3][0] == 4294967295u) {
                        phi_1337_ = 0u;
                    } else {
                        if (_e813.member_1[3][0] >= _e310) {
                            if (_e813.member_1[3][1] >= _e315) {
                                phi_1331_ = false;
                            } else {
                                phi_1331_ = true;
                            }
                            let _e906 = phi_1331_;
                            phi_1332_ = _e906;
                        } else {
                            phi_1332_ = true;
                        }
                        let _e908 = phi_1332_;
                        if _e908 {
                            phi_1336_ = 1u;
                        } else {
                            phi_1336_ = 2u;
                        }
                        let _e910 = phi_1336_;
                        phi_1337_ = _e910;
                    }
                    let _e912 = phi_1337_;
                    let _e913 = type_25(_e813.member_1[3], _e912);
                    if (_e912 == 0u) {
                        if (_e821[3][0] != 4294967295u) {
                            phi_1349_ = type_25(_e821[3], 3u);
                        } else {
                            phi_1349_ = _e913;
                        }
                        let _e919 = phi_1349_;
                        phi_1350_ = _e919;
                    } else {
                        phi_1350_ = _e913;
                    }
                    let _e921 = phi_1350_;
                    if (_e293[0] == 4294967295u) {
                        phi_1372_ = 0u;
                    } else {
                        if (_e293[0] >= _e310) {
                            if (_e293[1] >= _e315) {
                                phi_1366_ = false;
                            } else {
                                phi_1366_ = true;
                            }
                            let _e929 = phi_1366_;
                            phi_1367_ = _e929;
                        } else {
                            phi_1367_ = true;
                        }
                        let _e931 = phi_1367_;
                        if _e931 {
                            phi_1371_ = 1u;
                        } else {
                            phi_1371_ = 2u;
                        }
                        let _e933 = phi_1371_;
                        phi_1372_ = _e933;
                    }
                    let _e935 = phi_1372_;
                    if (_e935 == 2u) {
                        phi_1378_ = type_25(_e293, 2u);
                    } else {
                        phi_1378_ = _e846;
                    }
                    let _e939 = phi_1378_;
                    phi_1379_ = _e939;
                    phi_1380_ = _e921;
                    phi_1381_ = _e896;
                    phi_1382_ = _e871;
                } else {
                    phi_1379_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1380_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1381_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                    phi_1382_ = type_25(array<u32, 2>(4294967295u, 4294967295u), 0u);
                }
                let _e941 = phi_1379_;
                let _e943 = phi_1380_;
                let _e945 = phi_1381_;
                let _e947 = phi_1382_;
                if (_e941.member_1 == 1u) {
                    let _e958 = atomicAdd((&shared_[6u]), 1u);
                    phi_1403_ = array<u32, 2>(_e958, 0u);
                } else {
                    if (_e941.member_1 == 2u) {
                        let _e953 = atomicAdd((&shared_[7u]), 1u);
                        phi_1402_ = array<u32, 2>(_e953, 0u);
                    } else {
                        phi_1402_ = array<u32, 2>(0u, 0u);
                    }
                    let _e956 = phi_1402_;
                    phi_1403_ = _e956;
                }
                let _e961 = phi_1403_;
                if (_e941.member_1 >= 2u) {
                    if (_e71.member_4 > 0u) {
                        let _e965 = atomicAdd((&shared_[8u]), 1u);
                        phi_1415_ = array<u32, 2>(_e961[0], _e965);
                    } else {
                        phi_1415_ = _e961;
                    }
                    let _e969 = phi_1415_;
                    phi_1416_ = _e969;
                } else {
                    phi_1416_ = _e961;
                }
                let _e971 = phi_1416_;
                if (_e947.member_1 == 1u) {
                    let _e981 = atomicAdd((&shared_[6u]), 1u);
                    phi_1434_ = array<u32, 2>(_e981, 0u);
                } else {
                    if (_e947.member_1 == 2u) {
                        let _e976 = atomicAdd((&shared_[7u]), 1u);
                        phi_1433_ = array<u32, 2>(_e976, 0u);
                    } else {
                        phi_1433_ = array<u32, 2>(0u, 0u);
                    }
                    let _e979 = phi_1433_;
                    phi_1434_ = _e979;
                }
                let _e984 = phi_1434_;
                if (_e947.member_1 >= 2u) {
                    if (_e71.member_4 > 0u) {
                        let _e988 = atomicAdd((&shared_[8u]), 1u);
                        phi_1446_ = array<u32, 2>(_e984[0], _e988);
                    } else {
                        phi_1446_ = _e984;
                    }
                    let _e992 = phi_1446_;
                    phi_1447_ = _e992;
                } else {
                    phi_1447_ = _e984;
                }
                let _e994 = phi_1447_;
                if (_e945.member_1 == 1u) {
                    let _e1004 = atomicAdd((&shared_[6u]), 1u);
                    phi_1465_ = array<u32, 2>(_e1004, 0u);
                } else {
                    if (_e945.member_1 == 2u) {
                        let _e999 = atomicAdd((&shared_[7u]), 1u);
                        phi_1464_ = array<u32, 2>(_e999, 0u);
                    } else {
                        phi_1464_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1002 = phi_1464_;
                    phi_1465_ = _e1002;
                }
                let _e1007 = phi_1465_;
                if (_e945.member_1 >= 2u) {
                    if (_e71.member_4 > 0u) {
                        let _e1011 = atomicAdd((&shared_[8u]), 1u);
                        phi_1477_ = array<u32, 2>(_e1007[0], _e1011);
                    } else {
                        phi_1477_ = _e1007;
                    }
                    let _e1015 = phi_1477_;
                    phi_1478_ = _e1015;
                } else {
                    phi_1478_ = _e1007;
                }
                let _e1017 = phi_1478_;
                if (_e943.member_1 == 1u) {
                    let _e1027 = atomicAdd((&shared_[6u]), 1u);
                    phi_1496_ = array<u32, 2>(_e1027, 0u);
                } else {
                    if (_e943.member_1 == 2u) {
                        let _e1022 = atomicAdd((&shared_[7u]), 1u);
                        phi_1495_ = array<u32, 2>(_e1022, 0u);
                    } else {
                        phi_1495_ = array<u32, 2>(0u, 0u);
                    }
                    let _e1025 = phi_1495_;
                    phi_1496_ = _e1025;
                }
                let _e1030 = phi_1496_;
                if (_e943.member_1 >= 2u) {
                    if (_e71.member_4 > 0u) {
                        let _e1034 = atomicAdd((&shared_[8u]), 1u);
                        phi_1508_ = array<u32, 2>(_e1030[0], _e1034);
                    } else {
                        phi_1508_ = _e1030;
                    }
                    let _e1038 = phi_1508_;
                    phi_1509_ = _e1038;
                } else {
                    phi_1509_ = _e1030;
                }
                let _e1040 = phi_1509_;
                workgroupBarrier();
                if (_e57 == 0u) {
                    let _e1043 = atomicLoad((&shared_[6u]));
                    let _e1045 = atomicLoad((&shared_[7u]));
                    let _e1047 = atomicLoad((&shared_[8u]));
                    let _e1049 = atomicLoad((&shared_[1u]));
                    let _e1051 = atomicLoad((&shared_[2u]));
                    let _e1053 = atomicLoad((&shared_[15u]));
                    atomicStore((&shared_[15u]), (_e1053 + 1u));
                    let _e1057 = atomicLoad((&shared_[16u]));
                    atomicStore((&shared_[16u]), ((_e1057 + _e1049) + _e1051));
                    let _e1062 = atomicLoad((&shared_[0u]));
                    let _e1063 = (_e1062 - _e1049);
                    let _e1065 = (_e71.member_10 - _e1063);
                    if (_e1065 < _e1043) {
                        phi_1553_ = _e1065;
                    } else {
                        phi_1553_ = _e1043;
                    }
                    let _e1068 = phi_1553_;
                    atomicStore((&shared_[9u]), _e1063);
                    atomicStore((&shared_[10u]), _e1068);
                    atomicStore((&shared_[0u]), (_e1063 + _e1068));
                    if (_e1043 > _e1068) {
                        let _e1074 = (_e1043 - _e1068);
                        if (_e71.member_12 == 0u) {
                        } else {
                            let _e1078 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1081 = atomicAdd((&control.member[(_e73.member_1 + 1u)]), _e1074);
                        let _e1084 = atomicMax((&nodes.member[0u]), (_e1081 + _e1074));
                        if ((_e1081 + _e1074) < _e1081) {
                            let _e1088 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        atomicStore((&shared_[11u]), _e1081);
                    }
                    if (_e1045 > 0u) {
                        let _e1092 = atomicAdd((&pairs.member[0u]), _e1045);
                        if ((_e1092 + _e1045) < _e1092) {
                            let _e1096 = atomicAdd((&pairs.member[2u]), 1u);
                        }
                        atomicStore((&shared_[12u]), _e1092);
                    }
                    if (_e1047 > 0u) {
                        let _e1100 = atomicAdd((&control.member[1537u]), _e1047);
                        if ((_e1100 + _e1047) < _e1100) {
                            let _e1104 = atomicAdd((&control.member[1538u]), 1u);
                        }
                        atomicStore((&shared_[13u]), _e1100);
                    }
                }
                workgroupBarrier();
                if (_e941.member_1 == 1u) {
                    let _e1167 = atomicLoad((&shared_[10u]));
                    if (_e971[0] < _e1167) {
                        let _e1187 = atomicLoad((&shared_[9u]));
                        let _e1190 = (2u * (_e1187 + _e971[0]));
                        stack[_e1190] = _e941.member[0];
                        stack[(_e1190 + 1u)] = _e941.member[1];
                    } else {
                        let _e1171 = atomicLoad((&shared_[11u]));
                        let _e1174 = ((_e1171 + _e971[0]) - _e1167);
                        if (_e1174 < _e71.member_3) {
                            let _e1177 = (_e84 + _e1174);
                            if (_e1177 < 4294967295u) {
                                let _e1181 = (2u * _e1177);
                                atomicStore((&nodes.member[(4u + _e1181)]), _e941.member[0]);
                                atomicStore((&nodes.member[(_e1181 + 5u)]), _e941.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e941.member_1 == 0u) {
                    } else {
                        if (_e941.member_1 == 2u) {
                            let _e1115 = a.member[_e941.member[0]];
                            let _e1119 = b.member[_e941.member[1]];
                            let _e1123 = params.member.member_2.member;
                            if (_e1123 == 1u) {
                                if (_e1115.member_1 < _e1119.member_1) {
                                    phi_1738_ = type_9(_e1115.member_1, _e1119.member_1);
                                } else {
                                    phi_1738_ = type_9(_e1119.member_1, _e1115.member_1);
                                }
                                let _e1130 = phi_1738_;
                                phi_1743_ = _e1130;
                            } else {
                                phi_1743_ = type_9(_e1115.member_1, _e1119.member_1);
                            }
                            let _e1132 = phi_1743_;
                            let _e1136 = params.member.member_1;
                            let _e1139 = atomicLoad((&shared_[12u]));
                            let _e1141 = (_e1139 + _e971[0]);
                            if (_e1141 < _e1136.member_3) {
                                let _e1143 = (2u * _e1141);
                                atomicStore((&pairs.member[(4u + _e1143)]), _e1132.member);
                                atomicStore((&pairs.member[(_e1143 + 5u)]), _e1132.member_1);
                            }
                        }
                        if (_e71.member_4 > 0u) {
                            let _e1151 = atomicLoad((&shared_[13u]));
                            let _e1153 = (_e1151 + _e971[1]);
                            if (_e1153 < _e71.member_4) {
                                let _e1160 = (2u * ((_e71.member_5 * _e71.member_4) + _e1153));
                                front.member[_e1160] = _e941.member[0];
                                front.member[(_e1160 + 1u)] = _e941.member[1];
                            }
                        }
                    }
                }
                if (_e947.member_1 == 1u) {
                    let _e1257 = atomicLoad((&shared_[10u]));
                    if (_e994[0] < _e1257) {
                        let _e1277 = atomicLoad((&shared_[9u]));
                        let _e1280 = (2u * (_e1277 + _e994[0]));
                        stack[_e1280] = _e947.member[0];
                        stack[(_e1280 + 1u)] = _e947.member[1];
                    } else {
                        let _e1261 = atomicLoad((&shared_[11u]));
                        let _e1264 = ((_e1261 + _e994[0]) - _e1257);
                        if (_e1264 < _e71.member_3) {
                            let _e1267 = (_e84 + _e1264);
                            if (_e1267 < 4294967295u) {
                                let _e1271 = (2u * _e1267);
                                atomicStore((&nodes.member[(4u + _e1271)]), _e947.member[0]);
                                atomicStore((&nodes.member[(_e1271 + 5u)]), _e947.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e947.member_1 == 0u) {
                    } else {
                        if (_e947.member_1 == 2u) {
                            let _e1205 = a.member[_e947.member[0]];
                            let _e1209 = b.member[_e947.member[1]];
                            let _e1213 = params.member.member_2.member;
                            if (_e1213 == 1u) {
                                if (_e1205.member_1 < _e1209.member_1) {
                                    phi_1901_ = type_9(_e1205.member_1, _e1209.member_1);
                                } else {
                                    phi_1901_ = type_9(_e1209.member_1, _e1205.member_1);
                                }
                                let _e1220 = phi_1901_;
                                phi_1906_ = _e1220;
                            } else {
                                phi_1906_ = type_9(_e1205.member_1, _e1209.member_1);
                            }
                            let _e1222 = phi_1906_;
                            let _e1226 = params.member.member_1;
                            let _e1229 = atomicLoad((&shared_[12u]));
                            let _e1231 = (_e1229 + _e994[0]);
                            if (_e1231 < _e1226.member_3) {
                                let _e1233 = (2u * _e1231);
                                atomicStore((&pairs.member[(4u + _e1233)]), _e1222.member);
                                atomicStore((&pairs.member[(_e1233 + 5u)]), _e1222.member_1);
                            }
                        }
                        if (_e71.member_4 > 0u) {
                            let _e1241 = atomicLoad((&shared_[13u]));
                            let _e1243 = (_e1241 + _e994[1]);
                            if (_e1243 < _e71.member_4) {
                                let _e1250 = (2u * ((_e71.member_5 * _e71.member_4) + _e1243));
                                front.member[_e1250] = _e947.member[0];
                                front.member[(_e1250 + 1u)] = _e947.member[1];
                            }
                        }
                    }
                }
                if (_e945.member_1 == 1u) {
                    let _e1347 = atomicLoad((&shared_[10u]));
                    if (_e1017[0] < _e1347) {
                        let _e1367 = atomicLoad((&shared_[9u]));
                        let _e1370 = (2u * (_e1367 + _e1017[0]));
                        stack[_e1370] = _e945.member[0];
                        stack[(_e1370 + 1u)] = _e945.member[1];
                    } else {
                        let _e1351 = atomicLoad((&shared_[11u]));
                        let _e1354 = ((_e1351 + _e1017[0]) - _e1347);
                        if (_e1354 < _e71.member_3) {
                            let _e1357 = (_e84 + _e1354);
                            if (_e1357 < 4294967295u) {
                                let _e1361 = (2u * _e1357);
                                atomicStore((&nodes.member[(4u + _e1361)]), _e945.member[0]);
                                atomicStore((&nodes.member[(_e1361 + 5u)]), _e945.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e945.member_1 == 0u) {
                    } else {
                        if (_e945.member_1 == 2u) {
                            let _e1295 = a.member[_e945.member[0]];
                            let _e1299 = b.member[_e945.member[1]];
                            let _e1303 = params.member.member_2.member;
                            if (_e1303 == 1u) {
                                if (_e1295.member_1 < _e1299.member_1) {
                                    phi_2064_ = type_9(_e1295.member_1, _e1299.member_1);
                                } else {
                                    phi_2064_ = type_9(_e1299.member_1, _e1295.member_1);
                                }
                                let _e1310 = phi_2064_;
                                phi_2069_ = _e1310;
                            } else {
                                phi_2069_ = type_9(_e1295.member_1, _e1299.member_1);
                            }
                            let _e1312 = phi_2069_;
                            let _e1316 = params.member.member_1;
                            let _e1319 = atomicLoad((&shared_[12u]));
                            let _e1321 = (_e1319 + _e1017[0]);
                            if (_e1321 < _e1316.member_3) {
                                let _e1323 = (2u * _e1321);
                                atomicStore((&pairs.member[(4u + _e1323)]), _e1312.member);
                                atomicStore((&pairs.member[(_e1323 + 5u)]), _e1312.member_1);
                            }
                        }
                        if (_e71.member_4 > 0u) {
                            let _e1331 = atomicLoad((&shared_[13u]));
                            let _e1333 = (_e1331 + _e1017[1]);
                            if (_e1333 < _e71.member_4) {
                                let _e1340 = (2u * ((_e71.member_5 * _e71.member_4) + _e1333));
                                front.member[_e1340] = _e945.member[0];
                                front.member[(_e1340 + 1u)] = _e945.member[1];
                            }
                        }
                    }
                }
                if (_e943.member_1 == 1u) {
                    let _e1437 = atomicLoad((&shared_[10u]));
                    if (_e1040[0] < _e1437) {
                        let _e1457 = atomicLoad((&shared_[9u]));
                        let _e1460 = (2u * (_e1457 + _e1040[0]));
                        stack[_e1460] = _e943.member[0];
                        stack[(_e1460 + 1u)] = _e943.member[1];
                    } else {
                        let _e1441 = atomicLoad((&shared_[11u]));
                        let _e1444 = ((_e1441 + _e1040[0]) - _e1437);
                        if (_e1444 < _e71.member_3) {
                            let _e1447 = (_e84 + _e1444);
                            if (_e1447 < 4294967295u) {
                                let _e1451 = (2u * _e1447);
                                atomicStore((&nodes.member[(4u + _e1451)]), _e943.member[0]);
                                atomicStore((&nodes.member[(_e1451 + 5u)]), _e943.member[1]);
                            }
                        }
                    }
                } else {
                    if (_e943.member_1 == 0u) {
                    } else {
                        if (_e943.member_1 == 2u) {
                            let _e1385 = a.member[_e943.member[0]];
                            let _e1389 = b.member[_e943.member[1]];
                            let _e1393 = params.member.member_2.member;
                            if (_e1393 == 1u) {
                                if (_e1385.member_1 < _e1389.member_1) {
                                    phi_2227_ = type_9(_e1385.member_1, _e1389.member_1);
                                } else {
                                    phi_2227_ = type_9(_e1389.member_1, _e1385.member_1);
                                }
                                let _e1400 = phi_2227_;
                                phi_2232_ = _e1400;
                            } else {
                                phi_2232_ = type_9(_e1385.member_1, _e1389.member_1);
                            }
                            let _e1402 = phi_2232_;
                            let _e1406 = params.member.member_1;
                            let _e1409 = atomicLoad((&shared_[12u]));
                            let _e1411 = (_e1409 + _e1040[0]);
                            if (_e1411 < _e1406.member_3) {
                                let _e1413 = (2u * _e1411);
                                atomicStore((&pairs.member[(4u + _e1413)]), _e1402.member);
                                atomicStore((&pairs.member[(_e1413 + 5u)]), _e1402.member_1);
                            }
                        }
                        if (_e71.member_4 > 0u) {
                            let _e1421 = atomicLoad((&shared_[13u]));
                            let _e1423 = (_e1421 + _e1040[1]);
                            if (_e1423 < _e71.member_4) {
                                let _e1430 = (2u * ((_e71.member_5 * _e71.member_4) + _e1423));
                                front.member[_e1430] = _e943.member[0];
                                front.member[(_e1430 + 1u)] = _e943.member[1];
                            }
                        }
                    }
                }
                phi_2285_ = true;
            }
            let _e1467 = phi_2285_;
            phi_2286_ = _e1467;
        } else {
            phi_2286_ = false;
        }
        let _e1469 = phi_2286_;
        continue;
        continuing {
            phi_204_ = _e105;
            break if !(_e1469);
        }
    }
    if (_e57 == 0u) {
        if (_e71.member_6 == 0u) {
            if (_e69 < _e81) {
                phi_2309_ = ((((_e81 - 1u) - _e69) >> bitcast<u32>((_e71.member_7 & 31u))) + 1u);
            } else {
                phi_2309_ = 0u;
            }
            let _e1483 = phi_2309_;
            let _e1485 = atomicLoad((&shared_[5u]));
            phi_2314_ = (_e1483 - _e1485);
        } else {
            phi_2314_ = 0u;
        }
        let _e1488 = phi_2314_;
        atomicStore((&shared_[14u]), _e1488);
        let _e1491 = atomicLoad((&shared_[0u]));
        let _e1492 = (_e1491 + _e1488);
        if (_e71.member_6 == 2u) {
            let _e1519 = (((_e81 + (1u << bitcast<u32>((_e71.member_7 & 31u)))) - 1u) >> bitcast<u32>((_e71.member_7 & 31u)));
            let _e1520 = (_e69 * _e1519);
            if (_e81 < _e1520) {
                phi_2340_ = _e81;
            } else {
                phi_2340_ = _e1520;
            }
            let _e1523 = phi_2340_;
            let _e1524 = (_e81 - _e1523);
            if (_e1524 < _e1519) {
                phi_2346_ = _e1524;
            } else {
                phi_2346_ = _e1519;
            }
            let _e1527 = phi_2346_;
            let _e1534 = ((1540u + (2u * (1u << bitcast<u32>((_e71.member_7 & 31u))))) + (2u * _e69));
            let _e1536 = atomicLoad((&shared_[0u]));
            atomicStore((&control.member[_e1534]), _e1536);
            let _e1540 = atomicLoad((&shared_[5u]));
            atomicStore((&control.member[(_e1534 + 1u)]), (_e1527 - _e1540));
        } else {
            if (_e1492 > 0u) {
                if (_e71.member_12 == 0u) {
                } else {
                    let _e1499 = atomicMax((&control.member[1536u]), 4294967295u);
                }
                let _e1502 = atomicAdd((&control.member[(_e73.member_1 + 1u)]), _e1492);
                let _e1505 = atomicMax((&nodes.member[0u]), (_e1502 + _e1492));
                if ((_e1502 + _e1492) < _e1502) {
                    let _e1509 = atomicAdd((&nodes.member[2u]), 1u);
                }
                atomicStore((&shared_[17u]), _e1502);
            }
        }
        let _e1546 = atomicLoad((&shared_[15u]));
        let _e1548 = atomicAdd((&control.member[(1540u + (2u * _e69))]), _e1546);
        let _e1552 = atomicLoad((&shared_[16u]));
        let _e1554 = atomicAdd((&control.member[((2u * _e69) + 1541u)]), _e1552);
    }
    workgroupBarrier();
    let _e1556 = atomicLoad((&shared_[0u]));
    let _e1558 = atomicLoad((&shared_[17u]));
    let _e1560 = atomicLoad((&shared_[14u]));
    phi_2434_ = type_9(0u, 8u);
    loop {
        let _e1562 = phi_2434_;
        if (_e1562.member < _e1562.member_1) {
            phi_2435_ = type_9((_e1562.member + 1u), _e1562.member_1);
            phi_2458_ = type_9(1u, _e1562.member);
        } else {
            phi_2435_ = _e1562;
            phi_2458_ = type_9(0u, type_9().member_1);
        }
        let _e1574 = phi_2435_;
        let _e1576 = phi_2458_;
        let _e1580 = (bitcast<i32>(_e1576.member) != 0i);
        if _e1580 {
            let _e1582 = ((_e1576.member_1 * 128u) + _e57);
            if (_e1582 < _e1556) {
                let _e1586 = stack[(2u * _e1582)];
                let _e1590 = stack[((2u * _e1582) + 1u)];
                if (_e71.member_6 == 2u) {
                    let _e1622 = ((((((1540u + (2u * (1u << bitcast<u32>((_e71.member_7 & 31u))))) + (2u * (1u << bitcast<u32>((_e71.member_7 & 31u))))) + (1u << bitcast<u32>((_e71.member_7 & 31u)))) + 1u) + (_e69 * 2048u)) + (2u * _e1582));
                    atomicStore((&control.member[_e1622]), _e1586);
                    atomicStore((&control.member[(_e1622 + 1u)]), _e1590);
                } else {
                    let _e1593 = (_e1558 + _e1582);
                    if (_e1593 < _e71.member_3) {
                        let _e1596 = (_e84 + _e1593);
                        if (_e1596 < 4294967295u) {
                            let _e1598 = (2u * _e1596);
                            atomicStore((&nodes.member[(4u + _e1598)]), _e1586);
                            atomicStore((&nodes.member[(_e1598 + 5u)]), _e1590);
                        }
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2434_ = _e1574;
            break if !(_e1580);
        }
    }
    let _e1628 = atomicLoad((&shared_[5u]));
    let _e1629 = (_e1560 / 128u);
    if ((_e1560 % 128u) > 0u) {
        phi_2549_ = (_e1629 + 1u);
    } else {
        phi_2549_ = _e1629;
    }
    let _e1634 = phi_2549_;
    phi_2552_ = type_9(0u, _e1634);
    loop {
        let _e1637 = phi_2552_;
        if (_e1637.member < _e1637.member_1) {
            phi_2553_ = type_9((_e1637.member + 1u), _e1637.member_1);
            phi_2576_ = type_9(1u, _e1637.member);
        } else {
            phi_2553_ = _e1637;
            phi_2576_ = type_9(0u, type_9().member_1);
        }
        let _e1649 = phi_2553_;
        let _e1651 = phi_2576_;
        let _e1655 = (bitcast<i32>(_e1651.member) != 0i);
        if _e1655 {
            let _e1657 = ((_e1651.member_1 * 128u) + _e57);
            if (_e1657 < _e1560) {
                let _e1666 = (2u * ((_e82 + _e69) + ((_e1628 + _e1657) << bitcast<u32>((_e71.member_7 & 31u)))));
                let _e1669 = atomicLoad((&nodes.member[(4u + _e1666)]));
                let _e1672 = atomicLoad((&nodes.member[(_e1666 + 5u)]));
                let _e1674 = ((_e1558 + _e1556) + _e1657);
                if (_e1674 < _e71.member_3) {
                    let _e1677 = (_e84 + _e1674);
                    if (_e1677 < 4294967295u) {
                        let _e1679 = (2u * _e1677);
                        atomicStore((&nodes.member[(4u + _e1679)]), _e1669);
                        atomicStore((&nodes.member[(_e1679 + 5u)]), _e1672);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_2552_ = _e1649;
            break if !(_e1655);
        }
    }
    if (_e71.member_6 == 1u) {
        if (_e1628 == 0u) {
            phi_2657_ = type_9(0u, _e81);
            loop {
                let _e1690 = phi_2657_;
                if (_e1690.member < _e1690.member_1) {
                    phi_2658_ = type_9((_e1690.member + 1u), _e1690.member_1);
                    phi_2681_ = type_9(1u, _e1690.member);
                } else {
                    phi_2658_ = _e1690;
                    phi_2681_ = type_9(0u, type_9().member_1);
                }
                let _e1702 = phi_2658_;
                let _e1704 = phi_2681_;
                if (bitcast<i32>(_e1704.member) != 0i) {
                    let _e1710 = atomicAdd((&control.member[(512u + _e73.member_1)]), 1u);
                    if (_e1710 >= _e81) {
                        phi_2773_ = false;
                    } else {
                        let _e1713 = (2u * (_e82 + _e1710));
                        let _e1716 = atomicLoad((&nodes.member[(4u + _e1713)]));
                        let _e1719 = atomicLoad((&nodes.member[(_e1713 + 5u)]));
                        if (_e71.member_12 == 0u) {
                        } else {
                            let _e1723 = atomicMax((&control.member[1536u]), 4294967295u);
                        }
                        let _e1726 = atomicAdd((&control.member[(_e73.member_1 + 1u)]), 1u);
                        let _e1729 = atomicMax((&nodes.member[0u]), (_e1726 + 1u));
                        if ((_e1726 + 1u) < _e1726) {
                            let _e1733 = atomicAdd((&nodes.member[2u]), 1u);
                        }
                        if (_e1726 < _e71.member_3) {
                            let _e1736 = (_e84 + _e1726);
                            if (_e1736 < 4294967295u) {
                                let _e1738 = (2u * _e1736);
                                atomicStore((&nodes.member[(4u + _e1738)]), _e1716);
                                atomicStore((&nodes.member[(_e1738 + 5u)]), _e1719);
                            }
                        }
                        phi_2773_ = true;
                    }
                    let _e1744 = phi_2773_;
                    phi_2774_ = _e1744;
                } else {
                    phi_2774_ = false;
                }
                let _e1746 = phi_2774_;
                continue;
                continuing {
                    phi_2657_ = _e1702;
                    break if !(_e1746);
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn pair_workers(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
