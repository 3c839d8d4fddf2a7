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

struct type_15 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_8,
}

struct type_19 {
    member: type_18,
}

struct type_23 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> levels: type_23;
@group(0) @binding(5) 
var<storage, read_write> output: type_23;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_23;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_102_: array<u32, 2>;
    var phi_128_: u32;
    var phi_146_: u32;
    var phi_166_: u32;
    var phi_169_: type_9;
    var phi_170_: type_9;
    var phi_193_: type_9;
    var phi_303_: array<u32, 2>;
    var phi_339_: array<u32, 2>;
    var phi_349_: array<u32, 2>;
    var phi_351_: array<array<u32, 2>, 4>;
    var phi_352_: array<array<u32, 2>, 4>;
    var phi_353_: bool;
    var phi_354_: array<array<u32, 2>, 4>;
    var phi_355_: bool;
    var phi_367_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_388_: bool;
    var phi_393_: bool;
    var phi_434_: bool;
    var phi_435_: bool;
    var phi_436_: bool;
    var phi_437_: bool;
    var phi_441_: bool;
    var phi_443_: bool;
    var phi_452_: bool;
    var phi_457_: bool;
    var phi_498_: bool;
    var phi_499_: bool;
    var phi_500_: bool;
    var phi_501_: bool;
    var phi_505_: bool;
    var phi_515_: bool;
    var phi_516_: bool;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_624_: array<u32, 2>;
    var phi_654_: array<u32, 2>;
    var phi_684_: array<u32, 2>;
    var phi_714_: array<u32, 2>;
    var phi_716_: array<array<u32, 2>, 4>;
    var phi_717_: bool;
    var phi_718_: array<array<u32, 2>, 4>;
    var phi_719_: bool;
    var phi_878_: array<u32, 2>;
    var phi_910_: array<u32, 2>;
    var phi_785_: array<u32, 2>;
    var phi_817_: array<u32, 2>;
    var phi_912_: array<array<u32, 2>, 4>;
    var phi_913_: array<array<u32, 2>, 4>;
    var phi_914_: array<array<u32, 2>, 4>;
    var phi_915_: bool;
    var phi_916_: array<array<u32, 2>, 4>;
    var phi_917_: bool;
    var phi_921_: array<array<u32, 2>, 4>;
    var phi_922_: array<array<u32, 2>, 4>;
    var phi_923_: bool;
    var phi_927_: array<array<u32, 2>, 4>;
    var phi_944_: bool;
    var phi_945_: bool;
    var phi_949_: u32;
    var phi_950_: u32;
    var phi_956_: array<u32, 2>;
    var phi_957_: array<u32, 2>;
    var phi_958_: array<u32, 2>;
    var phi_959_: array<u32, 2>;
    var phi_960_: array<u32, 2>;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_981_: u32;
    var phi_982_: u32;
    var phi_991_: u32;
    var phi_994_: u32;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1015_: u32;
    var phi_1016_: u32;
    var phi_1025_: u32;
    var phi_1028_: u32;
    var phi_1044_: bool;
    var phi_1045_: bool;
    var phi_1049_: u32;
    var phi_1050_: u32;
    var phi_1059_: u32;
    var phi_1062_: u32;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1083_: u32;
    var phi_1084_: u32;
    var phi_1093_: u32;
    var phi_1096_: u32;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1167_: u32;
    var phi_1168_: u32;
    var phi_1231_: type_9;
    var phi_1236_: type_9;
    var phi_1269_: bool;
    var phi_1270_: bool;
    var phi_1274_: u32;
    var phi_1275_: u32;
    var phi_1338_: type_9;
    var phi_1343_: type_9;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1381_: u32;
    var phi_1382_: u32;
    var phi_1445_: type_9;
    var phi_1450_: type_9;
    var phi_1483_: bool;
    var phi_1484_: bool;
    var phi_1488_: u32;
    var phi_1489_: u32;
    var phi_1552_: type_9;
    var phi_1557_: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e29 = id_2;
    let _e30 = n_2;
    let _e31 = lane_2;
    let _e46 = (_e30.x * _e30.y);
    let _e49 = params.member.member_2.member;
    let _e52 = params.member.member_1.member_1;
    if (_e49 == 0u) {
        phi_102_ = array<u32, 2>(0u, 2u);
    } else {
        phi_102_ = array<u32, 2>(1u, 1u);
    }
    let _e55 = phi_102_;
    let _e61 = params.member.member.member[_e55[0]];
    let _e62 = (_e61 - 1u);
    let _e66 = params.member.member.member[_e55[1]];
    let _e67 = (_e66 - 1u);
    let _e70 = params.member.member_2.member_1;
    if (_e70 == 0u) {
        phi_128_ = 1u;
    } else {
        phi_128_ = 0u;
    }
    let _e73 = phi_128_;
    let _e75 = atomicLoad((&levels.member[_e52]));
    let _e78 = params.member.member_1.member_2;
    if (_e78 < _e75) {
        phi_146_ = _e78;
    } else {
        phi_146_ = _e75;
    }
    let _e81 = phi_146_;
    let _e84 = params.member.member_1.member_2;
    let _e85 = (_e46 * 128u);
    if (_e85 == 0u) {
        return;
    }
    let _e87 = (_e84 / _e85);
    if (_e85 == 0u) {
        return;
    }
    if ((_e84 % _e85) > 0u) {
        phi_166_ = (_e87 + 1u);
    } else {
        phi_166_ = _e87;
    }
    let _e93 = phi_166_;
    phi_169_ = type_9(0u, _e93);
    loop {
        let _e96 = phi_169_;
        if (_e96.member < _e96.member_1) {
            phi_170_ = type_9((_e96.member + 1u), _e96.member_1);
            phi_193_ = type_9(1u, _e96.member);
        } else {
            phi_170_ = _e96;
            phi_193_ = type_9(0u, type_9().member_1);
        }
        let _e108 = phi_170_;
        let _e110 = phi_193_;
        let _e114 = (bitcast<i32>(_e110.member) != 0i);
        if _e114 {
            let _e118 = (((((_e29.y * _e30.x) + _e29.x) + (_e110.member_1 * _e46)) * 128u) + _e31);
            if (_e31 == 0u) {
                atomicStore((&counters[0u]), 0u);
                atomicStore((&counters[1u]), 0u);
            }
            workgroupBarrier();
            if (_e118 < _e81) {
                let _e123 = (2u * _e118);
                let _e126 = input.member[(4u + _e123)];
                let _e129 = input.member[(_e123 + 5u)];
                let _e132 = a_nodes.member[_e126];
                let _e134 = b_nodes.member[_e129];
                if (_e49 == 1u) {
                    if (_e126 == _e129) {
                        if (_e132.member_3 == 4294967295u) {
                            phi_351_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                        } else {
                            let _e140 = a_nodes.member[_e132.member_1];
                            let _e143 = a_nodes.member[_e132.member_3];
                            if !((_e140.member_3 == 4294967295u)) {
                                phi_303_ = array<u32, 2>(_e132.member_1, _e132.member_1);
                            } else {
                                phi_303_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e151 = phi_303_;
                            if ((((((_e140.member[0] <= _e143.member_2[0]) && (_e143.member[0] <= _e140.member_2[0])) && (_e140.member[1] <= _e143.member_2[1])) && (_e143.member[1] <= _e140.member_2[1])) && (_e140.member[2] <= _e143.member_2[2])) && (_e143.member[2] <= _e140.member_2[2])) {
                                phi_339_ = array<u32, 2>(_e132.member_1, _e132.member_3);
                            } else {
                                phi_339_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e183 = phi_339_;
                            if !((_e143.member_3 == 4294967295u)) {
                                phi_349_ = array<u32, 2>(_e132.member_3, _e132.member_3);
                            } else {
                                phi_349_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e191 = phi_349_;
                            phi_351_ = array<array<u32, 2>, 4>(_e151, _e183, _e191, array<u32, 2>(4294967295u, 4294967295u));
                        }
                        let _e194 = phi_351_;
                        phi_352_ = _e194;
                        phi_353_ = false;
                    } else {
                        phi_352_ = array<array<u32, 2>, 4>();
                        phi_353_ = true;
                    }
                    let _e196 = phi_352_;
                    let _e198 = phi_353_;
                    phi_354_ = _e196;
                    phi_355_ = _e198;
                } else {
                    phi_354_ = array<array<u32, 2>, 4>();
                    phi_355_ = true;
                }
                let _e200 = phi_354_;
                let _e202 = phi_355_;
                if _e202 {
                    if (_e132.member_3 == 4294967295u) {
                        phi_367_ = false;
                    } else {
                        phi_367_ = !((_e134.member_3 == 4294967295u));
                    }
                    let _e209 = phi_367_;
                    if _e209 {
                        if (_e73 == 1u) {
                            phi_375_ = false;
                        } else {
                            phi_375_ = true;
                        }
                        let _e212 = phi_375_;
                        phi_376_ = _e212;
                    } else {
                        phi_376_ = true;
                    }
                    let _e214 = phi_376_;
                    if _e214 {
                        if (_e132.member_3 == 4294967295u) {
                            phi_388_ = false;
                        } else {
                            phi_388_ = !((_e134.member_3 == 4294967295u));
                        }
                        let _e221 = phi_388_;
                        if _e221 {
                            phi_393_ = (_e73 == 1u);
                        } else {
                            phi_393_ = false;
                        }
                        let _e224 = phi_393_;
                        if _e224 {
                            phi_436_ = bool();
                            phi_437_ = true;
                        } else {
                            let _e226 = (_e132.member_3 == 4294967295u);
                            if _e226 {
                                phi_435_ = bool();
                            } else {
                                if _e221 {
                                    phi_434_ = ((((_e134.member_2[0] - _e134.member[0]) * (_e134.member_2[1] - _e134.member[1])) * (_e134.member_2[2] - _e134.member[2])) > (((_e132.member_2[0] - _e132.member[0]) * (_e132.member_2[1] - _e132.member[1])) * (_e132.member_2[2] - _e132.member[2])));
                                } else {
                                    phi_434_ = false;
                                }
                                let _e255 = phi_434_;
                                phi_435_ = _e255;
                            }
                            let _e257 = phi_435_;
                            phi_436_ = _e257;
                            phi_437_ = _e226;
                        }
                        let _e259 = phi_436_;
                        let _e261 = phi_437_;
                        if _e261 {
                            phi_441_ = true;
                        } else {
                            phi_441_ = _e259;
                        }
                        let _e263 = phi_441_;
                        phi_443_ = !(_e263);
                    } else {
                        phi_443_ = true;
                    }
                    let _e266 = phi_443_;
                    if (_e132.member_3 == 4294967295u) {
                        phi_452_ = false;
                    } else {
                        phi_452_ = !((_e134.member_3 == 4294967295u));
                    }
                    let _e273 = phi_452_;
                    if _e273 {
                        phi_457_ = (_e73 == 1u);
                    } else {
                        phi_457_ = false;
                    }
                    let _e276 = phi_457_;
                    if _e276 {
                        phi_500_ = bool();
                        phi_501_ = true;
                    } else {
                        let _e278 = (_e132.member_3 == 4294967295u);
                        if _e278 {
                            phi_499_ = bool();
                        } else {
                            if _e273 {
                                phi_498_ = ((((_e134.member_2[0] - _e134.member[0]) * (_e134.member_2[1] - _e134.member[1])) * (_e134.member_2[2] - _e134.member[2])) > (((_e132.member_2[0] - _e132.member[0]) * (_e132.member_2[1] - _e132.member[1])) * (_e132.member_2[2] - _e132.member[2])));
                            } else {
                                phi_498_ = false;
                            }
                            let _e307 = phi_498_;
                            phi_499_ = _e307;
                        }
                        let _e309 = phi_499_;
                        phi_500_ = _e309;
                        phi_501_ = _e278;
                    }
                    let _e311 = phi_500_;
                    let _e313 = phi_501_;
                    if _e313 {
                        phi_505_ = true;
                    } else {
                        phi_505_ = _e311;
                    }
                    let _e315 = phi_505_;
                    if _e266 {
                        if (_e132.member_3 == 4294967295u) {
                            phi_515_ = false;
                        } else {
                            phi_515_ = true;
                        }
                        let _e319 = phi_515_;
                        phi_516_ = _e319;
                    } else {
                        phi_516_ = true;
                    }
                    let _e321 = phi_516_;
                    if _e321 {
                        if _e315 {
                            if (_e134.member_3 == 4294967295u) {
                                phi_528_ = false;
                            } else {
                                phi_528_ = true;
                            }
                            let _e325 = phi_528_;
                            phi_529_ = _e325;
                        } else {
                            phi_529_ = true;
                        }
                        let _e327 = phi_529_;
                        if _e327 {
                            if _e266 {
                                if _e315 {
                                    let _e330 = a_nodes.member[_e132.member_1];
                                    let _e335 = a_nodes.member[_e132.member_3];
                                    let _e340 = b_nodes.member[_e134.member_1];
                                    let _e345 = b_nodes.member[_e134.member_3];
                                    if ((((((_e330.member[0] <= _e340.member_2[0]) && (_e340.member[0] <= _e330.member_2[0])) && (_e330.member[1] <= _e340.member_2[1])) && (_e340.member[1] <= _e330.member_2[1])) && (_e330.member[2] <= _e340.member_2[2])) && (_e340.member[2] <= _e330.member_2[2])) {
                                        phi_624_ = array<u32, 2>(_e132.member_1, _e134.member_1);
                                    } else {
                                        phi_624_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e375 = phi_624_;
                                    if ((((((_e330.member[0] <= _e345.member_2[0]) && (_e345.member[0] <= _e330.member_2[0])) && (_e330.member[1] <= _e345.member_2[1])) && (_e345.member[1] <= _e330.member_2[1])) && (_e330.member[2] <= _e345.member_2[2])) && (_e345.member[2] <= _e330.member_2[2])) {
                                        phi_654_ = array<u32, 2>(_e132.member_1, _e134.member_3);
                                    } else {
                                        phi_654_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e403 = phi_654_;
                                    if ((((((_e335.member[0] <= _e340.member_2[0]) && (_e340.member[0] <= _e335.member_2[0])) && (_e335.member[1] <= _e340.member_2[1])) && (_e340.member[1] <= _e335.member_2[1])) && (_e335.member[2] <= _e340.member_2[2])) && (_e340.member[2] <= _e335.member_2[2])) {
                                        phi_684_ = array<u32, 2>(_e132.member_3, _e134.member_1);
                                    } else {
                                        phi_684_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e431 = phi_684_;
                                    if ((((((_e335.member[0] <= _e345.member_2[0]) && (_e345.member[0] <= _e335.member_2[0])) && (_e335.member[1] <= _e345.member_2[1])) && (_e345.member[1] <= _e335.member_2[1])) && (_e335.member[2] <= _e345.member_2[2])) && (_e345.member[2] <= _e335.member_2[2])) {
                                        phi_714_ = array<u32, 2>(_e132.member_3, _e134.member_3);
                                    } else {
                                        phi_714_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e459 = phi_714_;
                                    phi_716_ = array<array<u32, 2>, 4>(_e375, _e403, _e431, _e459);
                                    phi_717_ = false;
                                } else {
                                    phi_716_ = array<array<u32, 2>, 4>();
                                    phi_717_ = true;
                                }
                                let _e462 = phi_716_;
                                let _e464 = phi_717_;
                                phi_718_ = _e462;
                                phi_719_ = _e464;
                            } else {
                                phi_718_ = array<array<u32, 2>, 4>();
                                phi_719_ = true;
                            }
                            let _e466 = phi_718_;
                            let _e468 = phi_719_;
                            if _e468 {
                                if _e266 {
                                    let _e540 = a_nodes.member[_e132.member_1];
                                    let _e545 = a_nodes.member[_e132.member_3];
                                    if ((((((_e540.member[0] <= _e134.member_2[0]) && (_e134.member[0] <= _e540.member_2[0])) && (_e540.member[1] <= _e134.member_2[1])) && (_e134.member[1] <= _e540.member_2[1])) && (_e540.member[2] <= _e134.member_2[2])) && (_e134.member[2] <= _e540.member_2[2])) {
                                        phi_785_ = array<u32, 2>(_e132.member_1, _e129);
                                    } else {
                                        phi_785_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e576 = phi_785_;
                                    if ((((((_e545.member[0] <= _e134.member_2[0]) && (_e134.member[0] <= _e545.member_2[0])) && (_e545.member[1] <= _e134.member_2[1])) && (_e134.member[1] <= _e545.member_2[1])) && (_e545.member[2] <= _e134.member_2[2])) && (_e134.member[2] <= _e545.member_2[2])) {
                                        phi_817_ = array<u32, 2>(_e132.member_3, _e129);
                                    } else {
                                        phi_817_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e605 = phi_817_;
                                    phi_912_ = array<array<u32, 2>, 4>(_e576, _e605, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                } else {
                                    let _e471 = b_nodes.member[_e134.member_1];
                                    let _e476 = b_nodes.member[_e134.member_3];
                                    if ((((((_e132.member[0] <= _e471.member_2[0]) && (_e471.member[0] <= _e132.member_2[0])) && (_e132.member[1] <= _e471.member_2[1])) && (_e471.member[1] <= _e132.member_2[1])) && (_e132.member[2] <= _e471.member_2[2])) && (_e471.member[2] <= _e132.member_2[2])) {
                                        phi_878_ = array<u32, 2>(_e126, _e134.member_1);
                                    } else {
                                        phi_878_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e507 = phi_878_;
                                    if ((((((_e132.member[0] <= _e476.member_2[0]) && (_e476.member[0] <= _e132.member_2[0])) && (_e132.member[1] <= _e476.member_2[1])) && (_e476.member[1] <= _e132.member_2[1])) && (_e132.member[2] <= _e476.member_2[2])) && (_e476.member[2] <= _e132.member_2[2])) {
                                        phi_910_ = array<u32, 2>(_e126, _e134.member_3);
                                    } else {
                                        phi_910_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e536 = phi_910_;
                                    phi_912_ = array<array<u32, 2>, 4>(_e507, _e536, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                }
                                let _e608 = phi_912_;
                                phi_913_ = _e608;
                            } else {
                                phi_913_ = _e466;
                            }
                            let _e610 = phi_913_;
                            phi_914_ = _e610;
                            phi_915_ = false;
                        } else {
                            phi_914_ = array<array<u32, 2>, 4>();
                            phi_915_ = true;
                        }
                        let _e612 = phi_914_;
                        let _e614 = phi_915_;
                        phi_916_ = _e612;
                        phi_917_ = _e614;
                    } else {
                        phi_916_ = array<array<u32, 2>, 4>();
                        phi_917_ = true;
                    }
                    let _e616 = phi_916_;
                    let _e618 = phi_917_;
                    phi_921_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                    phi_922_ = _e616;
                    phi_923_ = _e618;
                } else {
                    phi_921_ = _e200;
                    phi_922_ = array<array<u32, 2>, 4>();
                    phi_923_ = true;
                }
                let _e620 = phi_921_;
                let _e622 = phi_922_;
                let _e624 = phi_923_;
                if _e624 {
                    phi_927_ = _e620;
                } else {
                    phi_927_ = _e622;
                }
                let _e626 = phi_927_;
                if (_e126 == 4294967295u) {
                    phi_950_ = 0u;
                } else {
                    if (_e126 >= _e62) {
                        if (_e129 >= _e67) {
                            phi_944_ = false;
                        } else {
                            phi_944_ = true;
                        }
                        let _e635 = phi_944_;
                        phi_945_ = _e635;
                    } else {
                        phi_945_ = true;
                    }
                    let _e637 = phi_945_;
                    if _e637 {
                        phi_949_ = 1u;
                    } else {
                        phi_949_ = 2u;
                    }
                    let _e639 = phi_949_;
                    phi_950_ = _e639;
                }
                let _e641 = phi_950_;
                if (_e641 == 2u) {
                    phi_956_ = array<u32, 2>(_e126, _e129);
                } else {
                    phi_956_ = _e626[0];
                }
                let _e645 = phi_956_;
                phi_957_ = _e626[3];
                phi_958_ = _e626[2];
                phi_959_ = _e626[1];
                phi_960_ = _e645;
            } else {
                phi_957_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_958_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_959_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_960_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e647 = phi_957_;
            let _e649 = phi_958_;
            let _e651 = phi_959_;
            let _e653 = phi_960_;
            if (_e653[0] == 4294967295u) {
                phi_982_ = 0u;
            } else {
                if (_e653[0] >= _e62) {
                    if (_e653[1] >= _e67) {
                        phi_976_ = false;
                    } else {
                        phi_976_ = true;
                    }
                    let _e661 = phi_976_;
                    phi_977_ = _e661;
                } else {
                    phi_977_ = true;
                }
                let _e663 = phi_977_;
                if _e663 {
                    phi_981_ = 1u;
                } else {
                    phi_981_ = 2u;
                }
                let _e665 = phi_981_;
                phi_982_ = _e665;
            }
            let _e667 = phi_982_;
            if (_e667 == 0u) {
                phi_994_ = 0u;
            } else {
                if (_e667 == 1u) {
                    phi_991_ = 0u;
                } else {
                    phi_991_ = 1u;
                }
                let _e671 = phi_991_;
                let _e673 = atomicAdd((&counters[_e671]), 1u);
                phi_994_ = _e673;
            }
            let _e675 = phi_994_;
            if (_e651[0] == 4294967295u) {
                phi_1016_ = 0u;
            } else {
                if (_e651[0] >= _e62) {
                    if (_e651[1] >= _e67) {
                        phi_1010_ = false;
                    } else {
                        phi_1010_ = true;
                    }
                    let _e683 = phi_1010_;
                    phi_1011_ = _e683;
                } else {
                    phi_1011_ = true;
                }
                let _e685 = phi_1011_;
                if _e685 {
                    phi_1015_ = 1u;
                } else {
                    phi_1015_ = 2u;
                }
                let _e687 = phi_1015_;
                phi_1016_ = _e687;
            }
            let _e689 = phi_1016_;
            if (_e689 == 0u) {
                phi_1028_ = 0u;
            } else {
                if (_e689 == 1u) {
                    phi_1025_ = 0u;
                } else {
                    phi_1025_ = 1u;
                }
                let _e693 = phi_1025_;
                let _e695 = atomicAdd((&counters[_e693]), 1u);
                phi_1028_ = _e695;
            }
            let _e697 = phi_1028_;
            if (_e649[0] == 4294967295u) {
                phi_1050_ = 0u;
            } else {
                if (_e649[0] >= _e62) {
                    if (_e649[1] >= _e67) {
                        phi_1044_ = false;
                    } else {
                        phi_1044_ = true;
                    }
                    let _e705 = phi_1044_;
                    phi_1045_ = _e705;
                } else {
                    phi_1045_ = true;
                }
                let _e707 = phi_1045_;
                if _e707 {
                    phi_1049_ = 1u;
                } else {
                    phi_1049_ = 2u;
                }
                let _e709 = phi_1049_;
                phi_1050_ = _e709;
            }
            let _e711 = phi_1050_;
            if (_e711 == 0u) {
                phi_1062_ = 0u;
            } else {
                if (_e711 == 1u) {
                    phi_1059_ = 0u;
                } else {
                    phi_1059_ = 1u;
                }
                let _e715 = phi_1059_;
                let _e717 = atomicAdd((&counters[_e715]), 1u);
                phi_1062_ = _e717;
            }
            let _e719 = phi_1062_;
            if (_e647[0] == 4294967295u) {
                phi_1084_ = 0u;
            } else {
                if (_e647[0] >= _e62) {
                    if (_e647[1] >= _e67) {
                        phi_1078_ = false;
                    } else {
                        phi_1078_ = true;
                    }
                    let _e727 = phi_1078_;
                    phi_1079_ = _e727;
                } else {
                    phi_1079_ = true;
                }
                let _e729 = phi_1079_;
                if _e729 {
                    phi_1083_ = 1u;
                } else {
                    phi_1083_ = 2u;
                }
                let _e731 = phi_1083_;
                phi_1084_ = _e731;
            }
            let _e733 = phi_1084_;
            if (_e733 == 0u) {
                phi_1096_ = 0u;
            } else {
                if (_e733 == 1u) {
                    phi_1093_ = 0u;
                } else {
                    phi_1093_ = 1u;
                }
                let _e737 = phi_1093_;
                let _e739 = atomicAdd((&counters[_e737]), 1u);
                phi_1096_ = _e739;
            }
            let _e741 = phi_1096_;
            workgroupBarrier();
            if (_e31 == 0u) {
                let _e744 = atomicLoad((&counters[0u]));
                let _e746 = atomicLoad((&counters[1u]));
                if (_e744 > 0u) {
                    let _e750 = atomicAdd((&levels.member[(_e52 + 1u)]), _e744);
                    let _e753 = atomicMax((&output.member[0u]), (_e750 + _e744));
                    if ((_e750 + _e744) < _e750) {
                        let _e757 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[2u]), _e750);
                }
                if (_e746 > 0u) {
                    let _e761 = atomicAdd((&pairs.member[0u]), _e746);
                    if ((_e761 + _e746) < _e761) {
                        let _e765 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    atomicStore((&counters[3u]), _e761);
                }
            }
            workgroupBarrier();
            let _e768 = atomicLoad((&counters[2u]));
            let _e770 = atomicLoad((&counters[3u]));
            if (_e653[0] == 4294967295u) {
                phi_1168_ = 0u;
            } else {
                if (_e653[0] >= _e62) {
                    if (_e653[1] >= _e67) {
                        phi_1162_ = false;
                    } else {
                        phi_1162_ = true;
                    }
                    let _e778 = phi_1162_;
                    phi_1163_ = _e778;
                } else {
                    phi_1163_ = true;
                }
                let _e780 = phi_1163_;
                if _e780 {
                    phi_1167_ = 1u;
                } else {
                    phi_1167_ = 2u;
                }
                let _e782 = phi_1167_;
                phi_1168_ = _e782;
            }
            let _e784 = phi_1168_;
            if (_e784 == 1u) {
                let _e823 = params.member.member_2.member_3;
                let _e824 = (_e768 + _e675);
                if (_e824 < _e823) {
                    let _e826 = (2u * _e824);
                    atomicStore((&output.member[(4u + _e826)]), _e653[0]);
                    atomicStore((&output.member[(_e826 + 5u)]), _e653[1]);
                }
            } else {
                if (_e784 == 2u) {
                    let _e789 = a_nodes.member[_e653[0]];
                    let _e793 = b_nodes.member[_e653[1]];
                    let _e797 = params.member.member_2.member;
                    if (_e797 == 1u) {
                        if (_e789.member_1 < _e793.member_1) {
                            phi_1231_ = type_9(_e789.member_1, _e793.member_1);
                        } else {
                            phi_1231_ = type_9(_e793.member_1, _e789.member_1);
                        }
                        let _e804 = phi_1231_;
                        phi_1236_ = _e804;
                    } else {
                        phi_1236_ = type_9(_e789.member_1, _e793.member_1);
                    }
                    let _e806 = phi_1236_;
                    let _e809 = params.member.member_1.member_3;
                    let _e810 = (_e770 + _e675);
                    if (_e810 < _e809) {
                        let _e814 = (2u * _e810);
                        atomicStore((&pairs.member[(4u + _e814)]), _e806.member);
                        atomicStore((&pairs.member[(_e814 + 5u)]), _e806.member_1);
                    }
                }
            }
            if (_e651[0] == 4294967295u) {
                phi_1275_ = 0u;
            } else {
                if (_e651[0] >= _e62) {
                    if (_e651[1] >= _e67) {
                        phi_1269_ = false;
                    } else {
                        phi_1269_ = true;
                    }
                    let _e838 = phi_1269_;
                    phi_1270_ = _e838;
                } else {
                    phi_1270_ = true;
                }
                let _e840 = phi_1270_;
                if _e840 {
                    phi_1274_ = 1u;
                } else {
                    phi_1274_ = 2u;
                }
                let _e842 = phi_1274_;
                phi_1275_ = _e842;
            }
            let _e844 = phi_1275_;
            if (_e844 == 1u) {
                let _e883 = params.member.member_2.member_3;
                let _e884 = (_e768 + _e697);
                if (_e884 < _e883) {
                    let _e886 = (2u * _e884);
                    atomicStore((&output.member[(4u + _e886)]), _e651[0]);
                    atomicStore((&output.member[(_e886 + 5u)]), _e651[1]);
                }
            } else {
                if (_e844 == 2u) {
                    let _e849 = a_nodes.member[_e651[0]];
                    let _e853 = b_nodes.member[_e651[1]];
                    let _e857 = params.member.member_2.member;
                    if (_e857 == 1u) {
                        if (_e849.member_1 < _e853.member_1) {
                            phi_1338_ = type_9(_e849.member_1, _e853.member_1);
                        } else {
                            phi_1338_ = type_9(_e853.member_1, _e849.member_1);
                        }
                        let _e864 = phi_1338_;
                        phi_1343_ = _e864;
                    } else {
                        phi_1343_ = type_9(_e849.member_1, _e853.member_1);
                    }
                    let _e866 = phi_1343_;
                    let _e869 = params.member.member_1.member_3;
                    let _e870 = (_e770 + _e697);
                    if (_e870 < _e869) {
                        let _e874 = (2u * _e870);
                        atomicStore((&pairs.member[(4u + _e874)]), _e866.member);
                        atomicStore((&pairs.member[(_e874 + 5u)]), _e866.member_1);
                    }
                }
            }
            if (_e649[0] == 4294967295u) {
                phi_1382_ = 0u;
            } else {
                if (_e649[0] >= _e62) {
                    if (_e649[1] >= _e67) {
                        phi_1376_ = false;
                    } else {
                        phi_1376_ = true;
                    }
                    let _e898 = phi_1376_;
                    phi_1377_ = _e898;
                } else {
                    phi_1377_ = true;
                }
                let _e900 = phi_1377_;
                if _e900 {
                    phi_1381_ = 1u;
                } else {
                    phi_1381_ = 2u;
                }
                let _e902 = phi_1381_;
                phi_1382_ = _e902;
            }
            let _e904 = phi_1382_;
            if (_e904 == 1u) {
                let _e943 = params.member.member_2.member_3;
                let _e944 = (_e768 + _e719);
                if (_e944 < _e943) {
                    let _e946 = (2u * _e944);
                    atomicStore((&output.member[(4u + _e946)]), _e649[0]);
                    atomicStore((&output.member[(_e946 + 5u)]), _e649[1]);
                }
            } else {
                if (_e904 == 2u) {
                    let _e909 = a_nodes.member[_e649[0]];
                    let _e913 = b_nodes.member[_e649[1]];
                    let _e917 = params.member.member_2.member;
                    if (_e917 == 1u) {
                        if (_e909.member_1 < _e913.member_1) {
                            phi_1445_ = type_9(_e909.member_1, _e913.member_1);
                        } else {
                            phi_1445_ = type_9(_e913.member_1, _e909.member_1);
                        }
                        let _e924 = phi_1445_;
                        phi_1450_ = _e924;
                    } else {
                        phi_1450_ = type_9(_e909.member_1, _e913.member_1);
                    }
                    let _e926 = phi_1450_;
                    let _e929 = params.member.member_1.member_3;
                    let _e930 = (_e770 + _e719);
                    if (_e930 < _e929) {
                        let _e934 = (2u * _e930);
                        atomicStore((&pairs.member[(4u + _e934)]), _e926.member);
                        atomicStore((&pairs.member[(_e934 + 5u)]), _e926.member_1);
                    }
                }
            }
            if (_e647[0] == 4294967295u) {
                phi_1489_ = 0u;
            } else {
                if (_e647[0] >= _e62) {
                    if (_e647[1] >= _e67) {
                        phi_1483_ = false;
                    } else {
                        phi_1483_ = true;
                    }
                    let _e958 = phi_1483_;
                    phi_1484_ = _e958;
                } else {
                    phi_1484_ = true;
                }
                let _e960 = phi_1484_;
                if _e960 {
                    phi_1488_ = 1u;
                } else {
                    phi_1488_ = 2u;
                }
                let _e962 = phi_1488_;
                phi_1489_ = _e962;
            }
            let _e964 = phi_1489_;
            if (_e964 == 1u) {
                let _e1003 = params.member.member_2.member_3;
                let _e1004 = (_e768 + _e741);
                if (_e1004 < _e1003) {
                    let _e1006 = (2u * _e1004);
                    atomicStore((&output.member[(4u + _e1006)]), _e647[0]);
                    atomicStore((&output.member[(_e1006 + 5u)]), _e647[1]);
                }
            } else {
                if (_e964 == 2u) {
                    let _e969 = a_nodes.member[_e647[0]];
                    let _e973 = b_nodes.member[_e647[1]];
                    let _e977 = params.member.member_2.member;
                    if (_e977 == 1u) {
                        if (_e969.member_1 < _e973.member_1) {
                            phi_1552_ = type_9(_e969.member_1, _e973.member_1);
                        } else {
                            phi_1552_ = type_9(_e973.member_1, _e969.member_1);
                        }
                        let _e984 = phi_1552_;
                        phi_1557_ = _e984;
                    } else {
                        phi_1557_ = type_9(_e969.member_1, _e973.member_1);
                    }
                    let _e986 = phi_1557_;
                    let _e989 = params.member.member_1.member_3;
                    let _e990 = (_e770 + _e741);
                    if (_e990 < _e989) {
                        let _e994 = (2u * _e990);
                        atomicStore((&pairs.member[(4u + _e994)]), _e986.member);
                        atomicStore((&pairs.member[(_e994 + 5u)]), _e986.member_1);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_169_ = _e108;
            break if !(_e114);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
