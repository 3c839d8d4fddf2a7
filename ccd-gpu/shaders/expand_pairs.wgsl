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

struct type_12 {
    member: u32,
    member_1: u32,
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

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_24 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(3) 
var<storage> input: type_10;
@group(0) @binding(4) 
var<storage, read_write> levels: type_24;
@group(0) @binding(5) 
var<storage, read_write> output: type_24;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_24;
var<workgroup> counters: array<atomic<u32>, 4>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_104_: array<u32, 2>;
    var phi_130_: u32;
    var phi_148_: u32;
    var phi_168_: u32;
    var phi_171_: type_12;
    var phi_172_: type_12;
    var phi_195_: type_12;
    var phi_305_: array<u32, 2>;
    var phi_341_: array<u32, 2>;
    var phi_351_: array<u32, 2>;
    var phi_353_: array<array<u32, 2>, 4>;
    var phi_354_: array<array<u32, 2>, 4>;
    var phi_355_: bool;
    var phi_356_: array<array<u32, 2>, 4>;
    var phi_357_: bool;
    var phi_369_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_390_: bool;
    var phi_395_: bool;
    var phi_436_: bool;
    var phi_437_: bool;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_443_: bool;
    var phi_445_: bool;
    var phi_454_: bool;
    var phi_459_: bool;
    var phi_500_: bool;
    var phi_501_: bool;
    var phi_502_: bool;
    var phi_503_: bool;
    var phi_507_: bool;
    var phi_517_: bool;
    var phi_518_: bool;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_626_: array<u32, 2>;
    var phi_656_: array<u32, 2>;
    var phi_686_: array<u32, 2>;
    var phi_716_: array<u32, 2>;
    var phi_718_: array<array<u32, 2>, 4>;
    var phi_719_: bool;
    var phi_720_: array<array<u32, 2>, 4>;
    var phi_721_: bool;
    var phi_880_: array<u32, 2>;
    var phi_912_: array<u32, 2>;
    var phi_787_: array<u32, 2>;
    var phi_819_: array<u32, 2>;
    var phi_914_: array<array<u32, 2>, 4>;
    var phi_915_: array<array<u32, 2>, 4>;
    var phi_916_: array<array<u32, 2>, 4>;
    var phi_917_: bool;
    var phi_918_: array<array<u32, 2>, 4>;
    var phi_919_: bool;
    var phi_923_: array<array<u32, 2>, 4>;
    var phi_924_: array<array<u32, 2>, 4>;
    var phi_925_: bool;
    var phi_929_: array<array<u32, 2>, 4>;
    var phi_946_: bool;
    var phi_947_: bool;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_958_: array<u32, 2>;
    var phi_959_: array<u32, 2>;
    var phi_960_: array<u32, 2>;
    var phi_961_: array<u32, 2>;
    var phi_962_: array<u32, 2>;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_983_: u32;
    var phi_984_: u32;
    var phi_993_: u32;
    var phi_996_: u32;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1017_: u32;
    var phi_1018_: u32;
    var phi_1027_: u32;
    var phi_1030_: u32;
    var phi_1046_: bool;
    var phi_1047_: bool;
    var phi_1051_: u32;
    var phi_1052_: u32;
    var phi_1061_: u32;
    var phi_1064_: u32;
    var phi_1080_: bool;
    var phi_1081_: bool;
    var phi_1085_: u32;
    var phi_1086_: u32;
    var phi_1095_: u32;
    var phi_1098_: u32;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1169_: u32;
    var phi_1170_: u32;
    var phi_1233_: type_12;
    var phi_1238_: type_12;
    var phi_1271_: bool;
    var phi_1272_: bool;
    var phi_1276_: u32;
    var phi_1277_: u32;
    var phi_1340_: type_12;
    var phi_1345_: type_12;
    var phi_1378_: bool;
    var phi_1379_: bool;
    var phi_1383_: u32;
    var phi_1384_: u32;
    var phi_1447_: type_12;
    var phi_1452_: type_12;
    var phi_1485_: bool;
    var phi_1486_: bool;
    var phi_1490_: u32;
    var phi_1491_: u32;
    var phi_1554_: type_12;
    var phi_1559_: type_12;
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
        phi_104_ = array<u32, 2>(0u, 2u);
    } else {
        phi_104_ = array<u32, 2>(1u, 1u);
    }
    let _e55 = phi_104_;
    let _e61 = params.member.member.member[_e55[0]];
    let _e62 = (_e61 - 1u);
    let _e66 = params.member.member.member[_e55[1]];
    let _e67 = (_e66 - 1u);
    let _e70 = params.member.member_2.member_1;
    if (_e70 == 0u) {
        phi_130_ = 1u;
    } else {
        phi_130_ = 0u;
    }
    let _e73 = phi_130_;
    let _e75 = atomicLoad((&levels.member[_e52]));
    let _e78 = params.member.member_1.member_2;
    if (_e78 < _e75) {
        phi_148_ = _e78;
    } else {
        phi_148_ = _e75;
    }
    let _e81 = phi_148_;
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
        phi_168_ = (_e87 + 1u);
    } else {
        phi_168_ = _e87;
    }
    let _e93 = phi_168_;
    phi_171_ = type_12(0u, _e93);
    loop {
        let _e96 = phi_171_;
        if (_e96.member < _e96.member_1) {
            phi_172_ = type_12((_e96.member + 1u), _e96.member_1);
            phi_195_ = type_12(1u, _e96.member);
        } else {
            phi_172_ = _e96;
            phi_195_ = type_12(0u, type_12().member_1);
        }
        let _e108 = phi_172_;
        let _e110 = phi_195_;
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
                            phi_353_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                        } else {
                            let _e140 = a_nodes.member[_e132.member_1];
                            let _e143 = a_nodes.member[_e132.member_3];
                            if !((_e140.member_3 == 4294967295u)) {
                                phi_305_ = array<u32, 2>(_e132.member_1, _e132.member_1);
                            } else {
                                phi_305_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e151 = phi_305_;
                            if ((((((_e140.member[0] <= _e143.member_2[0]) && (_e143.member[0] <= _e140.member_2[0])) && (_e140.member[1] <= _e143.member_2[1])) && (_e143.member[1] <= _e140.member_2[1])) && (_e140.member[2] <= _e143.member_2[2])) && (_e143.member[2] <= _e140.member_2[2])) {
                                phi_341_ = array<u32, 2>(_e132.member_1, _e132.member_3);
                            } else {
                                phi_341_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e183 = phi_341_;
                            if !((_e143.member_3 == 4294967295u)) {
                                phi_351_ = array<u32, 2>(_e132.member_3, _e132.member_3);
                            } else {
                                phi_351_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e191 = phi_351_;
                            phi_353_ = array<array<u32, 2>, 4>(_e151, _e183, _e191, array<u32, 2>(4294967295u, 4294967295u));
                        }
                        let _e194 = phi_353_;
                        phi_354_ = _e194;
                        phi_355_ = false;
                    } else {
                        phi_354_ = array<array<u32, 2>, 4>();
                        phi_355_ = true;
                    }
                    let _e196 = phi_354_;
                    let _e198 = phi_355_;
                    phi_356_ = _e196;
                    phi_357_ = _e198;
                } else {
                    phi_356_ = array<array<u32, 2>, 4>();
                    phi_357_ = true;
                }
                let _e200 = phi_356_;
                let _e202 = phi_357_;
                if _e202 {
                    if (_e132.member_3 == 4294967295u) {
                        phi_369_ = false;
                    } else {
                        phi_369_ = !((_e134.member_3 == 4294967295u));
                    }
                    let _e209 = phi_369_;
                    if _e209 {
                        if (_e73 == 1u) {
                            phi_377_ = false;
                        } else {
                            phi_377_ = true;
                        }
                        let _e212 = phi_377_;
                        phi_378_ = _e212;
                    } else {
                        phi_378_ = true;
                    }
                    let _e214 = phi_378_;
                    if _e214 {
                        if (_e132.member_3 == 4294967295u) {
                            phi_390_ = false;
                        } else {
                            phi_390_ = !((_e134.member_3 == 4294967295u));
                        }
                        let _e221 = phi_390_;
                        if _e221 {
                            phi_395_ = (_e73 == 1u);
                        } else {
                            phi_395_ = false;
                        }
                        let _e224 = phi_395_;
                        if _e224 {
                            phi_438_ = bool();
                            phi_439_ = true;
                        } else {
                            let _e226 = (_e132.member_3 == 4294967295u);
                            if _e226 {
                                phi_437_ = bool();
                            } else {
                                if _e221 {
                                    phi_436_ = ((((_e134.member_2[0] - _e134.member[0]) * (_e134.member_2[1] - _e134.member[1])) * (_e134.member_2[2] - _e134.member[2])) > (((_e132.member_2[0] - _e132.member[0]) * (_e132.member_2[1] - _e132.member[1])) * (_e132.member_2[2] - _e132.member[2])));
                                } else {
                                    phi_436_ = false;
                                }
                                let _e255 = phi_436_;
                                phi_437_ = _e255;
                            }
                            let _e257 = phi_437_;
                            phi_438_ = _e257;
                            phi_439_ = _e226;
                        }
                        let _e259 = phi_438_;
                        let _e261 = phi_439_;
                        if _e261 {
                            phi_443_ = true;
                        } else {
                            phi_443_ = _e259;
                        }
                        let _e263 = phi_443_;
                        phi_445_ = !(_e263);
                    } else {
                        phi_445_ = true;
                    }
                    let _e266 = phi_445_;
                    if (_e132.member_3 == 4294967295u) {
                        phi_454_ = false;
                    } else {
                        phi_454_ = !((_e134.member_3 == 4294967295u));
                    }
                    let _e273 = phi_454_;
                    if _e273 {
                        phi_459_ = (_e73 == 1u);
                    } else {
                        phi_459_ = false;
                    }
                    let _e276 = phi_459_;
                    if _e276 {
                        phi_502_ = bool();
                        phi_503_ = true;
                    } else {
                        let _e278 = (_e132.member_3 == 4294967295u);
                        if _e278 {
                            phi_501_ = bool();
                        } else {
                            if _e273 {
                                phi_500_ = ((((_e134.member_2[0] - _e134.member[0]) * (_e134.member_2[1] - _e134.member[1])) * (_e134.member_2[2] - _e134.member[2])) > (((_e132.member_2[0] - _e132.member[0]) * (_e132.member_2[1] - _e132.member[1])) * (_e132.member_2[2] - _e132.member[2])));
                            } else {
                                phi_500_ = false;
                            }
                            let _e307 = phi_500_;
                            phi_501_ = _e307;
                        }
                        let _e309 = phi_501_;
                        phi_502_ = _e309;
                        phi_503_ = _e278;
                    }
                    let _e311 = phi_502_;
                    let _e313 = phi_503_;
                    if _e313 {
                        phi_507_ = true;
                    } else {
                        phi_507_ = _e311;
                    }
                    let _e315 = phi_507_;
                    if _e266 {
                        if (_e132.member_3 == 4294967295u) {
                            phi_517_ = false;
                        } else {
                            phi_517_ = true;
                        }
                        let _e319 = phi_517_;
                        phi_518_ = _e319;
                    } else {
                        phi_518_ = true;
                    }
                    let _e321 = phi_518_;
                    if _e321 {
                        if _e315 {
                            if (_e134.member_3 == 4294967295u) {
                                phi_530_ = false;
                            } else {
                                phi_530_ = true;
                            }
                            let _e325 = phi_530_;
                            phi_531_ = _e325;
                        } else {
                            phi_531_ = true;
                        }
                        let _e327 = phi_531_;
                        if _e327 {
                            if _e266 {
                                if _e315 {
                                    let _e330 = a_nodes.member[_e132.member_1];
                                    let _e335 = a_nodes.member[_e132.member_3];
                                    let _e340 = b_nodes.member[_e134.member_1];
                                    let _e345 = b_nodes.member[_e134.member_3];
                                    if ((((((_e330.member[0] <= _e340.member_2[0]) && (_e340.member[0] <= _e330.member_2[0])) && (_e330.member[1] <= _e340.member_2[1])) && (_e340.member[1] <= _e330.member_2[1])) && (_e330.member[2] <= _e340.member_2[2])) && (_e340.member[2] <= _e330.member_2[2])) {
                                        phi_626_ = array<u32, 2>(_e132.member_1, _e134.member_1);
                                    } else {
                                        phi_626_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e375 = phi_626_;
                                    if ((((((_e330.member[0] <= _e345.member_2[0]) && (_e345.member[0] <= _e330.member_2[0])) && (_e330.member[1] <= _e345.member_2[1])) && (_e345.member[1] <= _e330.member_2[1])) && (_e330.member[2] <= _e345.member_2[2])) && (_e345.member[2] <= _e330.member_2[2])) {
                                        phi_656_ = array<u32, 2>(_e132.member_1, _e134.member_3);
                                    } else {
                                        phi_656_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e403 = phi_656_;
                                    if ((((((_e335.member[0] <= _e340.member_2[0]) && (_e340.member[0] <= _e335.member_2[0])) && (_e335.member[1] <= _e340.member_2[1])) && (_e340.member[1] <= _e335.member_2[1])) && (_e335.member[2] <= _e340.member_2[2])) && (_e340.member[2] <= _e335.member_2[2])) {
                                        phi_686_ = array<u32, 2>(_e132.member_3, _e134.member_1);
                                    } else {
                                        phi_686_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e431 = phi_686_;
                                    if ((((((_e335.member[0] <= _e345.member_2[0]) && (_e345.member[0] <= _e335.member_2[0])) && (_e335.member[1] <= _e345.member_2[1])) && (_e345.member[1] <= _e335.member_2[1])) && (_e335.member[2] <= _e345.member_2[2])) && (_e345.member[2] <= _e335.member_2[2])) {
                                        phi_716_ = array<u32, 2>(_e132.member_3, _e134.member_3);
                                    } else {
                                        phi_716_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e459 = phi_716_;
                                    phi_718_ = array<array<u32, 2>, 4>(_e375, _e403, _e431, _e459);
                                    phi_719_ = false;
                                } else {
                                    phi_718_ = array<array<u32, 2>, 4>();
                                    phi_719_ = true;
                                }
                                let _e462 = phi_718_;
                                let _e464 = phi_719_;
                                phi_720_ = _e462;
                                phi_721_ = _e464;
                            } else {
                                phi_720_ = array<array<u32, 2>, 4>();
                                phi_721_ = true;
                            }
                            let _e466 = phi_720_;
                            let _e468 = phi_721_;
                            if _e468 {
                                if _e266 {
                                    let _e540 = a_nodes.member[_e132.member_1];
                                    let _e545 = a_nodes.member[_e132.member_3];
                                    if ((((((_e540.member[0] <= _e134.member_2[0]) && (_e134.member[0] <= _e540.member_2[0])) && (_e540.member[1] <= _e134.member_2[1])) && (_e134.member[1] <= _e540.member_2[1])) && (_e540.member[2] <= _e134.member_2[2])) && (_e134.member[2] <= _e540.member_2[2])) {
                                        phi_787_ = array<u32, 2>(_e132.member_1, _e129);
                                    } else {
                                        phi_787_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e576 = phi_787_;
                                    if ((((((_e545.member[0] <= _e134.member_2[0]) && (_e134.member[0] <= _e545.member_2[0])) && (_e545.member[1] <= _e134.member_2[1])) && (_e134.member[1] <= _e545.member_2[1])) && (_e545.member[2] <= _e134.member_2[2])) && (_e134.member[2] <= _e545.member_2[2])) {
                                        phi_819_ = array<u32, 2>(_e132.member_3, _e129);
                                    } else {
                                        phi_819_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e605 = phi_819_;
                                    phi_914_ = array<array<u32, 2>, 4>(_e576, _e605, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                } else {
                                    let _e471 = b_nodes.member[_e134.member_1];
                                    let _e476 = b_nodes.member[_e134.member_3];
                                    if ((((((_e132.member[0] <= _e471.member_2[0]) && (_e471.member[0] <= _e132.member_2[0])) && (_e132.member[1] <= _e471.member_2[1])) && (_e471.member[1] <= _e132.member_2[1])) && (_e132.member[2] <= _e471.member_2[2])) && (_e471.member[2] <= _e132.member_2[2])) {
                                        phi_880_ = array<u32, 2>(_e126, _e134.member_1);
                                    } else {
                                        phi_880_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e507 = phi_880_;
                                    if ((((((_e132.member[0] <= _e476.member_2[0]) && (_e476.member[0] <= _e132.member_2[0])) && (_e132.member[1] <= _e476.member_2[1])) && (_e476.member[1] <= _e132.member_2[1])) && (_e132.member[2] <= _e476.member_2[2])) && (_e476.member[2] <= _e132.member_2[2])) {
                                        phi_912_ = array<u32, 2>(_e126, _e134.member_3);
                                    } else {
                                        phi_912_ = array<u32, 2>(4294967295u, 4294967295u);
                                    }
                                    let _e536 = phi_912_;
                                    phi_914_ = array<array<u32, 2>, 4>(_e507, _e536, array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                                }
                                let _e608 = phi_914_;
                                phi_915_ = _e608;
                            } else {
                                phi_915_ = _e466;
                            }
                            let _e610 = phi_915_;
                            phi_916_ = _e610;
                            phi_917_ = false;
                        } else {
                            phi_916_ = array<array<u32, 2>, 4>();
                            phi_917_ = true;
                        }
                        let _e612 = phi_916_;
                        let _e614 = phi_917_;
                        phi_918_ = _e612;
                        phi_919_ = _e614;
                    } else {
                        phi_918_ = array<array<u32, 2>, 4>();
                        phi_919_ = true;
                    }
                    let _e616 = phi_918_;
                    let _e618 = phi_919_;
                    phi_923_ = array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u));
                    phi_924_ = _e616;
                    phi_925_ = _e618;
                } else {
                    phi_923_ = _e200;
                    phi_924_ = array<array<u32, 2>, 4>();
                    phi_925_ = true;
                }
                let _e620 = phi_923_;
                let _e622 = phi_924_;
                let _e624 = phi_925_;
                if _e624 {
                    phi_929_ = _e620;
                } else {
                    phi_929_ = _e622;
                }
                let _e626 = phi_929_;
                if (_e126 == 4294967295u) {
                    phi_952_ = 0u;
                } else {
                    if (_e126 >= _e62) {
                        if (_e129 >= _e67) {
                            phi_946_ = false;
                        } else {
                            phi_946_ = true;
                        }
                        let _e635 = phi_946_;
                        phi_947_ = _e635;
                    } else {
                        phi_947_ = true;
                    }
                    let _e637 = phi_947_;
                    if _e637 {
                        phi_951_ = 1u;
                    } else {
                        phi_951_ = 2u;
                    }
                    let _e639 = phi_951_;
                    phi_952_ = _e639;
                }
                let _e641 = phi_952_;
                if (_e641 == 2u) {
                    phi_958_ = array<u32, 2>(_e126, _e129);
                } else {
                    phi_958_ = _e626[0];
                }
                let _e645 = phi_958_;
                phi_959_ = _e626[3];
                phi_960_ = _e626[2];
                phi_961_ = _e626[1];
                phi_962_ = _e645;
            } else {
                phi_959_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_960_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_961_ = array<u32, 2>(4294967295u, 4294967295u);
                phi_962_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e647 = phi_959_;
            let _e649 = phi_960_;
            let _e651 = phi_961_;
            let _e653 = phi_962_;
            if (_e653[0] == 4294967295u) {
                phi_984_ = 0u;
            } else {
                if (_e653[0] >= _e62) {
                    if (_e653[1] >= _e67) {
                        phi_978_ = false;
                    } else {
                        phi_978_ = true;
                    }
                    let _e661 = phi_978_;
                    phi_979_ = _e661;
                } else {
                    phi_979_ = true;
                }
                let _e663 = phi_979_;
                if _e663 {
                    phi_983_ = 1u;
                } else {
                    phi_983_ = 2u;
                }
                let _e665 = phi_983_;
                phi_984_ = _e665;
            }
            let _e667 = phi_984_;
            if (_e667 == 0u) {
                phi_996_ = 0u;
            } else {
                if (_e667 == 1u) {
                    phi_993_ = 0u;
                } else {
                    phi_993_ = 1u;
                }
                let _e671 = phi_993_;
                let _e673 = atomicAdd((&counters[_e671]), 1u);
                phi_996_ = _e673;
            }
            let _e675 = phi_996_;
            if (_e651[0] == 4294967295u) {
                phi_1018_ = 0u;
            } else {
                if (_e651[0] >= _e62) {
                    if (_e651[1] >= _e67) {
                        phi_1012_ = false;
                    } else {
                        phi_1012_ = true;
                    }
                    let _e683 = phi_1012_;
                    phi_1013_ = _e683;
                } else {
                    phi_1013_ = true;
                }
                let _e685 = phi_1013_;
                if _e685 {
                    phi_1017_ = 1u;
                } else {
                    phi_1017_ = 2u;
                }
                let _e687 = phi_1017_;
                phi_1018_ = _e687;
            }
            let _e689 = phi_1018_;
            if (_e689 == 0u) {
                phi_1030_ = 0u;
            } else {
                if (_e689 == 1u) {
                    phi_1027_ = 0u;
                } else {
                    phi_1027_ = 1u;
                }
                let _e693 = phi_1027_;
                let _e695 = atomicAdd((&counters[_e693]), 1u);
                phi_1030_ = _e695;
            }
            let _e697 = phi_1030_;
            if (_e649[0] == 4294967295u) {
                phi_1052_ = 0u;
            } else {
                if (_e649[0] >= _e62) {
                    if (_e649[1] >= _e67) {
                        phi_1046_ = false;
                    } else {
                        phi_1046_ = true;
                    }
                    let _e705 = phi_1046_;
                    phi_1047_ = _e705;
                } else {
                    phi_1047_ = true;
                }
                let _e707 = phi_1047_;
                if _e707 {
                    phi_1051_ = 1u;
                } else {
                    phi_1051_ = 2u;
                }
                let _e709 = phi_1051_;
                phi_1052_ = _e709;
            }
            let _e711 = phi_1052_;
            if (_e711 == 0u) {
                phi_1064_ = 0u;
            } else {
                if (_e711 == 1u) {
                    phi_1061_ = 0u;
                } else {
                    phi_1061_ = 1u;
                }
                let _e715 = phi_1061_;
                let _e717 = atomicAdd((&counters[_e715]), 1u);
                phi_1064_ = _e717;
            }
            let _e719 = phi_1064_;
            if (_e647[0] == 4294967295u) {
                phi_1086_ = 0u;
            } else {
                if (_e647[0] >= _e62) {
                    if (_e647[1] >= _e67) {
                        phi_1080_ = false;
                    } else {
                        phi_1080_ = true;
                    }
                    let _e727 = phi_1080_;
                    phi_1081_ = _e727;
                } else {
                    phi_1081_ = true;
                }
                let _e729 = phi_1081_;
                if _e729 {
                    phi_1085_ = 1u;
                } else {
                    phi_1085_ = 2u;
                }
                let _e731 = phi_1085_;
                phi_1086_ = _e731;
            }
            let _e733 = phi_1086_;
            if (_e733 == 0u) {
                phi_1098_ = 0u;
            } else {
                if (_e733 == 1u) {
                    phi_1095_ = 0u;
                } else {
                    phi_1095_ = 1u;
                }
                let _e737 = phi_1095_;
                let _e739 = atomicAdd((&counters[_e737]), 1u);
                phi_1098_ = _e739;
            }
            let _e741 = phi_1098_;
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
                phi_1170_ = 0u;
            } else {
                if (_e653[0] >= _e62) {
                    if (_e653[1] >= _e67) {
                        phi_1164_ = false;
                    } else {
                        phi_1164_ = true;
                    }
                    let _e778 = phi_1164_;
                    phi_1165_ = _e778;
                } else {
                    phi_1165_ = true;
                }
                let _e780 = phi_1165_;
                if _e780 {
                    phi_1169_ = 1u;
                } else {
                    phi_1169_ = 2u;
                }
                let _e782 = phi_1169_;
                phi_1170_ = _e782;
            }
            let _e784 = phi_1170_;
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
                            phi_1233_ = type_12(_e789.member_1, _e793.member_1);
                        } else {
                            phi_1233_ = type_12(_e793.member_1, _e789.member_1);
                        }
                        let _e804 = phi_1233_;
                        phi_1238_ = _e804;
                    } else {
                        phi_1238_ = type_12(_e789.member_1, _e793.member_1);
                    }
                    let _e806 = phi_1238_;
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
                phi_1277_ = 0u;
            } else {
                if (_e651[0] >= _e62) {
                    if (_e651[1] >= _e67) {
                        phi_1271_ = false;
                    } else {
                        phi_1271_ = true;
                    }
                    let _e838 = phi_1271_;
                    phi_1272_ = _e838;
                } else {
                    phi_1272_ = true;
                }
                let _e840 = phi_1272_;
                if _e840 {
                    phi_1276_ = 1u;
                } else {
                    phi_1276_ = 2u;
                }
                let _e842 = phi_1276_;
                phi_1277_ = _e842;
            }
            let _e844 = phi_1277_;
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
                            phi_1340_ = type_12(_e849.member_1, _e853.member_1);
                        } else {
                            phi_1340_ = type_12(_e853.member_1, _e849.member_1);
                        }
                        let _e864 = phi_1340_;
                        phi_1345_ = _e864;
                    } else {
                        phi_1345_ = type_12(_e849.member_1, _e853.member_1);
                    }
                    let _e866 = phi_1345_;
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
                phi_1384_ = 0u;
            } else {
                if (_e649[0] >= _e62) {
                    if (_e649[1] >= _e67) {
                        phi_1378_ = false;
                    } else {
                        phi_1378_ = true;
                    }
                    let _e898 = phi_1378_;
                    phi_1379_ = _e898;
                } else {
                    phi_1379_ = true;
                }
                let _e900 = phi_1379_;
                if _e900 {
                    phi_1383_ = 1u;
                } else {
                    phi_1383_ = 2u;
                }
                let _e902 = phi_1383_;
                phi_1384_ = _e902;
            }
            let _e904 = phi_1384_;
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
                            phi_1447_ = type_12(_e909.member_1, _e913.member_1);
                        } else {
                            phi_1447_ = type_12(_e913.member_1, _e909.member_1);
                        }
                        let _e924 = phi_1447_;
                        phi_1452_ = _e924;
                    } else {
                        phi_1452_ = type_12(_e909.member_1, _e913.member_1);
                    }
                    let _e926 = phi_1452_;
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
                phi_1491_ = 0u;
            } else {
                if (_e647[0] >= _e62) {
                    if (_e647[1] >= _e67) {
                        phi_1485_ = false;
                    } else {
                        phi_1485_ = true;
                    }
                    let _e958 = phi_1485_;
                    phi_1486_ = _e958;
                } else {
                    phi_1486_ = true;
                }
                let _e960 = phi_1486_;
                if _e960 {
                    phi_1490_ = 1u;
                } else {
                    phi_1490_ = 2u;
                }
                let _e962 = phi_1490_;
                phi_1491_ = _e962;
            }
            let _e964 = phi_1491_;
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
                            phi_1554_ = type_12(_e969.member_1, _e973.member_1);
                        } else {
                            phi_1554_ = type_12(_e973.member_1, _e969.member_1);
                        }
                        let _e984 = phi_1554_;
                        phi_1559_ = _e984;
                    } else {
                        phi_1559_ = type_12(_e969.member_1, _e973.member_1);
                    }
                    let _e986 = phi_1559_;
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
            phi_171_ = _e108;
            break if !(_e114);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
