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

@group(0) @binding(6) 
var<storage, read_write> output: type_28;
@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> a_nodes: type_15;
@group(0) @binding(2) 
var<storage> b_nodes: type_15;
@group(0) @binding(3) 
var<storage> cuts: type_10;
@group(0) @binding(7) 
var<storage, read_write> front: type_10;
@group(0) @binding(4) 
var<storage> oriented: type_24;
@group(0) @binding(5) 
var<storage, read_write> control: type_28;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_20;
    var phi_136_: u32;
    var phi_173_: bool;
    var phi_202_: array<u32, 2>;
    var phi_203_: array<u32, 2>;
    var phi_204_: array<u32, 2>;
    var phi_241_: array<u32, 2>;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_338_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_436_: f32;
    var phi_441_: f32;
    var phi_446_: f32;
    var phi_462_: type_25;
    var phi_544_: f32;
    var phi_549_: f32;
    var phi_554_: f32;
    var phi_570_: type_25;
    var phi_760_: f32;
    var phi_766_: f32;
    var phi_773_: f32;
    var phi_782_: f32;
    var phi_789_: f32;
    var phi_797_: f32;
    var phi_806_: f32;
    var phi_813_: f32;
    var phi_821_: f32;
    var phi_914_: f32;
    var phi_921_: f32;
    var phi_927_: f32;
    var phi_933_: f32;
    var phi_952_: f32;
    var phi_959_: f32;
    var phi_965_: f32;
    var phi_971_: f32;
    var phi_990_: f32;
    var phi_997_: f32;
    var phi_1003_: f32;
    var phi_1009_: f32;
    var phi_1028_: f32;
    var phi_1035_: f32;
    var phi_1041_: f32;
    var phi_1047_: f32;
    var phi_1066_: f32;
    var phi_1073_: f32;
    var phi_1079_: f32;
    var phi_1085_: f32;
    var phi_1104_: f32;
    var phi_1111_: f32;
    var phi_1117_: f32;
    var phi_1123_: f32;
    var phi_1138_: f32;
    var phi_1143_: f32;
    var phi_1148_: f32;
    var phi_1153_: f32;
    var phi_1158_: f32;
    var phi_1217_: f32;
    var phi_1240_: f32;
    var phi_1263_: f32;
    var phi_1285_: f32;
    var phi_1301_: f32;
    var phi_1356_: f32;
    var phi_1379_: f32;
    var phi_1402_: f32;
    var phi_1424_: f32;
    var phi_1440_: f32;
    var phi_1495_: f32;
    var phi_1518_: f32;
    var phi_1541_: f32;
    var phi_1563_: f32;
    var phi_1579_: f32;
    var phi_1634_: f32;
    var phi_1657_: f32;
    var phi_1681_: f32;
    var phi_1704_: f32;
    var phi_1720_: f32;
    var phi_1775_: f32;
    var phi_1798_: f32;
    var phi_1822_: f32;
    var phi_1845_: f32;
    var phi_1861_: f32;
    var phi_1916_: f32;
    var phi_1939_: f32;
    var phi_1963_: f32;
    var phi_1986_: f32;
    var phi_2002_: f32;
    var phi_2057_: f32;
    var phi_2080_: f32;
    var phi_2104_: f32;
    var phi_2127_: f32;
    var phi_2143_: f32;
    var phi_2198_: f32;
    var phi_2221_: f32;
    var phi_2245_: f32;
    var phi_2268_: f32;
    var phi_2284_: f32;
    var phi_2339_: f32;
    var phi_2362_: f32;
    var phi_2386_: f32;
    var phi_2409_: f32;
    var phi_2425_: f32;
    var phi_2432_: f32;
    var phi_2437_: f32;
    var phi_2442_: f32;
    var phi_2447_: f32;
    var phi_2452_: f32;
    var phi_2457_: f32;
    var phi_2462_: f32;
    var phi_2467_: f32;
    var phi_2471_: bool;
    var phi_2473_: bool;
    var phi_2474_: bool;
    var phi_2475_: bool;
    var phi_2476_: bool;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e38 = id_2;
    let _e39 = n_2;
    let _e40 = lane_2;
    let _e56 = ((((_e38.y * _e39.x) + _e38.x) * 256u) + _e40);
    let _e58 = params.member.member_2.member_2;
    if (_e58 == 0u) {
        return;
    }
    let _e60 = (_e56 / _e58);
    let _e62 = params.member.member_2.member_2;
    if (_e62 == 0u) {
        return;
    }
    let _e64 = (_e56 % _e62);
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
        if (_e104 == 0u) {
            phi_241_ = array<u32, 2>(0u, 2u);
        } else {
            phi_241_ = array<u32, 2>(1u, 1u);
        }
        let _e107 = phi_241_;
        let _e113 = params.member.member.member[_e107[0]];
        let _e114 = (_e113 - 1u);
        let _e118 = params.member.member.member[_e107[1]];
        let _e119 = (_e118 - 1u);
        let _e123 = params.member.member.member_2[_e107[0]];
        let _e127 = params.member.member.member_2[_e107[1]];
        let _e130 = params.member.member_2.member;
        let _e131 = (_e130 == 1u);
        if _e131 {
            if (_e93[0] == _e93[1]) {
                if (_e98.member_3 == 4294967295u) {
                    phi_294_ = false;
                } else {
                    phi_294_ = true;
                }
                let _e138 = phi_294_;
                phi_295_ = _e138;
            } else {
                phi_295_ = true;
            }
            let _e140 = phi_295_;
            phi_296_ = _e140;
        } else {
            phi_296_ = true;
        }
        let _e142 = phi_296_;
        if _e142 {
            if ((((((_e98.member[0] <= _e101.member_2[0]) && (_e101.member[0] <= _e98.member_2[0])) && (_e98.member[1] <= _e101.member_2[1])) && (_e101.member[1] <= _e98.member_2[1])) && (_e98.member[2] <= _e101.member_2[2])) && (_e101.member[2] <= _e98.member_2[2])) {
                if _e131 {
                    phi_338_ = (_e93[0] == _e93[1]);
                } else {
                    phi_338_ = false;
                }
                let _e174 = phi_338_;
                if _e174 {
                    phi_2475_ = bool();
                    phi_2476_ = true;
                } else {
                    if (_e93[0] >= _e114) {
                        if (_e93[1] >= _e119) {
                            phi_350_ = false;
                        } else {
                            phi_350_ = true;
                        }
                        let _e178 = phi_350_;
                        phi_351_ = _e178;
                    } else {
                        phi_351_ = true;
                    }
                    let _e180 = phi_351_;
                    if _e180 {
                        if (_e93[0] < _e114) {
                            let _e236 = oriented.member[(_e123 + _e93[0])];
                            phi_462_ = type_25(array<f32, 3>(_e236.member.x, _e236.member.y, _e236.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e236.member.w, _e236.member_1.x, _e236.member_1.y), array<f32, 3>(_e236.member_1.z, _e236.member_1.w, _e236.member_2.x), array<f32, 3>(_e236.member_2.y, _e236.member_2.z, _e236.member_2.w)), array<f32, 3>(_e236.member_3.x, _e236.member_3.y, _e236.member_3.z));
                        } else {
                            let _e183 = a_nodes.member[_e93[0]];
                            let _e198 = ((_e183.member[0] * 0.5f) + (_e183.member_2[0] * 0.5f));
                            let _e199 = ((_e183.member[1] * 0.5f) + (_e183.member_2[1] * 0.5f));
                            let _e200 = ((_e183.member[2] * 0.5f) + (_e183.member_2[2] * 0.5f));
                            let _e203 = (_e183.member_2[0] - _e198);
                            let _e205 = (_e183.member_2[1] - _e199);
                            let _e207 = (_e183.member_2[2] - _e200);
                            let _e209 = (_e198 - _e183.member[0]);
                            let _e211 = (_e199 - _e183.member[1]);
                            let _e213 = (_e200 - _e183.member[2]);
                            if (_e203 > _e209) {
                                phi_436_ = _e203;
                            } else {
                                phi_436_ = _e209;
                            }
                            let _e216 = phi_436_;
                            if (_e205 > _e211) {
                                phi_441_ = _e205;
                            } else {
                                phi_441_ = _e211;
                            }
                            let _e219 = phi_441_;
                            if (_e207 > _e213) {
                                phi_446_ = _e207;
                            } else {
                                phi_446_ = _e213;
                            }
                            let _e222 = phi_446_;
                            let _e224 = (1f + (0.000000059604645f * 4f));
                            let _e228 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_462_ = type_25(array<f32, 3>(_e198, _e199, _e200), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e216 * _e224) + _e228), ((_e219 * _e224) + _e228), ((_e222 * _e224) + _e228)));
                        }
                        let _e275 = phi_462_;
                        if (_e93[1] < _e119) {
                            let _e331 = oriented.member[(_e127 + _e93[1])];
                            phi_570_ = type_25(array<f32, 3>(_e331.member.x, _e331.member.y, _e331.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e331.member.w, _e331.member_1.x, _e331.member_1.y), array<f32, 3>(_e331.member_1.z, _e331.member_1.w, _e331.member_2.x), array<f32, 3>(_e331.member_2.y, _e331.member_2.z, _e331.member_2.w)), array<f32, 3>(_e331.member_3.x, _e331.member_3.y, _e331.member_3.z));
                        } else {
                            let _e278 = b_nodes.member[_e93[1]];
                            let _e293 = ((_e278.member[0] * 0.5f) + (_e278.member_2[0] * 0.5f));
                            let _e294 = ((_e278.member[1] * 0.5f) + (_e278.member_2[1] * 0.5f));
                            let _e295 = ((_e278.member[2] * 0.5f) + (_e278.member_2[2] * 0.5f));
                            let _e298 = (_e278.member_2[0] - _e293);
                            let _e300 = (_e278.member_2[1] - _e294);
                            let _e302 = (_e278.member_2[2] - _e295);
                            let _e304 = (_e293 - _e278.member[0]);
                            let _e306 = (_e294 - _e278.member[1]);
                            let _e308 = (_e295 - _e278.member[2]);
                            if (_e298 > _e304) {
                                phi_544_ = _e298;
                            } else {
                                phi_544_ = _e304;
                            }
                            let _e311 = phi_544_;
                            if (_e300 > _e306) {
                                phi_549_ = _e300;
                            } else {
                                phi_549_ = _e306;
                            }
                            let _e314 = phi_549_;
                            if (_e302 > _e308) {
                                phi_554_ = _e302;
                            } else {
                                phi_554_ = _e308;
                            }
                            let _e317 = phi_554_;
                            let _e319 = (1f + (0.000000059604645f * 4f));
                            let _e323 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_570_ = type_25(array<f32, 3>(_e293, _e294, _e295), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e311 * _e319) + _e323), ((_e314 * _e319) + _e323), ((_e317 * _e319) + _e323)));
                        }
                        let _e370 = phi_570_;
                        let _e375 = (_e370.member[0] - _e275.member[0]);
                        let _e378 = (_e370.member[1] - _e275.member[1]);
                        let _e381 = (_e370.member[2] - _e275.member[2]);
                        if (_e375 < 0f) {
                            phi_760_ = -(_e375);
                        } else {
                            phi_760_ = _e375;
                        }
                        let _e570 = phi_760_;
                        if (_e378 < 0f) {
                            phi_766_ = -(_e378);
                        } else {
                            phi_766_ = _e378;
                        }
                        let _e574 = phi_766_;
                        if (_e381 < 0f) {
                            phi_773_ = -(_e381);
                        } else {
                            phi_773_ = _e381;
                        }
                        let _e579 = phi_773_;
                        if (_e275.member_2[0] < 0f) {
                            phi_782_ = -(_e275.member_2[0]);
                        } else {
                            phi_782_ = _e275.member_2[0];
                        }
                        let _e586 = phi_782_;
                        if (_e275.member_2[1] < 0f) {
                            phi_789_ = -(_e275.member_2[1]);
                        } else {
                            phi_789_ = _e275.member_2[1];
                        }
                        let _e591 = phi_789_;
                        if (_e275.member_2[2] < 0f) {
                            phi_797_ = -(_e275.member_2[2]);
                        } else {
                            phi_797_ = _e275.member_2[2];
                        }
                        let _e597 = phi_797_;
                        if (_e370.member_2[0] < 0f) {
                            phi_806_ = -(_e370.member_2[0]);
                        } else {
                            phi_806_ = _e370.member_2[0];
                        }
                        let _e604 = phi_806_;
                        if (_e370.member_2[1] < 0f) {
                            phi_813_ = -(_e370.member_2[1]);
                        } else {
                            phi_813_ = _e370.member_2[1];
                        }
                        let _e609 = phi_813_;
                        if (_e370.member_2[2] < 0f) {
                            phi_821_ = -(_e370.member_2[2]);
                        } else {
                            phi_821_ = _e370.member_2[2];
                        }
                        let _e615 = phi_821_;
                        local = type_20(array<array<f32, 3>, 3>(array<f32, 3>((((_e370.member_1[0][0] * _e275.member_1[0][0]) + (_e370.member_1[0][1] * _e275.member_1[0][1])) + (_e370.member_1[0][2] * _e275.member_1[0][2])), (((_e370.member_1[1][0] * _e275.member_1[0][0]) + (_e370.member_1[1][1] * _e275.member_1[0][1])) + (_e370.member_1[1][2] * _e275.member_1[0][2])), (((_e370.member_1[2][0] * _e275.member_1[0][0]) + (_e370.member_1[2][1] * _e275.member_1[0][1])) + (_e370.member_1[2][2] * _e275.member_1[0][2]))), array<f32, 3>((((_e370.member_1[0][0] * _e275.member_1[1][0]) + (_e370.member_1[0][1] * _e275.member_1[1][1])) + (_e370.member_1[0][2] * _e275.member_1[1][2])), (((_e370.member_1[1][0] * _e275.member_1[1][0]) + (_e370.member_1[1][1] * _e275.member_1[1][1])) + (_e370.member_1[1][2] * _e275.member_1[1][2])), (((_e370.member_1[2][0] * _e275.member_1[1][0]) + (_e370.member_1[2][1] * _e275.member_1[1][1])) + (_e370.member_1[2][2] * _e275.member_1[1][2]))), array<f32, 3>((((_e370.member_1[0][0] * _e275.member_1[2][0]) + (_e370.member_1[0][1] * _e275.member_1[2][1])) + (_e370.member_1[0][2] * _e275.member_1[2][2])), (((_e370.member_1[1][0] * _e275.member_1[2][0]) + (_e370.member_1[1][1] * _e275.member_1[2][1])) + (_e370.member_1[1][2] * _e275.member_1[2][2])), (((_e370.member_1[2][0] * _e275.member_1[2][0]) + (_e370.member_1[2][1] * _e275.member_1[2][1])) + (_e370.member_1[2][2] * _e275.member_1[2][2])))), array<f32, 3>((((_e275.member_1[0][0] * _e375) + (_e275.member_1[0][1] * _e378)) + (_e275.member_1[0][2] * _e381)), (((_e275.member_1[1][0] * _e375) + (_e275.member_1[1][1] * _e378)) + (_e275.member_1[1][2] * _e381)), (((_e275.member_1[2][0] * _e375) + (_e275.member_1[2][1] * _e378)) + (_e275.member_1[2][2] * _e381))), array<f32, 3>((((_e370.member_1[0][0] * _e375) + (_e370.member_1[0][1] * _e378)) + (_e370.member_1[0][2] * _e381)), (((_e370.member_1[1][0] * _e375) + (_e370.member_1[1][1] * _e378)) + (_e370.member_1[1][2] * _e381)), (((_e370.member_1[2][0] * _e375) + (_e370.member_1[2][1] * _e378)) + (_e370.member_1[2][2] * _e381))), array<f32, 3>(_e275.member_2[0], _e275.member_2[1], _e275.member_2[2]), array<f32, 3>(_e370.member_2[0], _e370.member_2[1], _e370.member_2[2]), ((((((_e570 + _e574) + _e579) + (((_e586 + _e591) + _e597) + ((_e604 + _e609) + _e615))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                        let _e642 = local.member[0u][0u];
                        let _e646 = local.member[0u][1u];
                        let _e650 = local.member[0u][2u];
                        let _e654 = local.member[1u][0u];
                        let _e658 = local.member[1u][1u];
                        let _e662 = local.member[1u][2u];
                        let _e666 = local.member[2u][0u];
                        let _e670 = local.member[2u][1u];
                        let _e674 = local.member[2u][2u];
                        let _e676 = local.member_3;
                        let _e681 = local.member_4;
                        let _e687 = local.member_1[0u];
                        if (_e687 < 0f) {
                            phi_914_ = -(_e687);
                        } else {
                            phi_914_ = _e687;
                        }
                        let _e691 = phi_914_;
                        if (_e642 < 0f) {
                            phi_921_ = -(_e642);
                        } else {
                            phi_921_ = _e642;
                        }
                        let _e695 = phi_921_;
                        if (_e646 < 0f) {
                            phi_927_ = -(_e646);
                        } else {
                            phi_927_ = _e646;
                        }
                        let _e699 = phi_927_;
                        if (_e650 < 0f) {
                            phi_933_ = -(_e650);
                        } else {
                            phi_933_ = _e650;
                        }
                        let _e703 = phi_933_;
                        let _e710 = (_e691 - (_e676[0] + (((_e695 * _e681[0]) + (_e699 * _e681[1])) + (_e703 * _e681[2]))));
                        let _e713 = local.member_1[1u];
                        if (_e713 < 0f) {
                            phi_952_ = -(_e713);
                        } else {
                            phi_952_ = _e713;
                        }
                        let _e717 = phi_952_;
                        if (_e654 < 0f) {
                            phi_959_ = -(_e654);
                        } else {
                            phi_959_ = _e654;
                        }
                        let _e721 = phi_959_;
                        if (_e658 < 0f) {
                            phi_965_ = -(_e658);
                        } else {
                            phi_965_ = _e658;
                        }
                        let _e725 = phi_965_;
                        if (_e662 < 0f) {
                            phi_971_ = -(_e662);
                        } else {
                            phi_971_ = _e662;
                        }
                        let _e729 = phi_971_;
                        let _e736 = (_e717 - (_e676[1] + (((_e721 * _e681[0]) + (_e725 * _e681[1])) + (_e729 * _e681[2]))));
                        let _e739 = local.member_1[2u];
                        if (_e739 < 0f) {
                            phi_990_ = -(_e739);
                        } else {
                            phi_990_ = _e739;
                        }
                        let _e743 = phi_990_;
                        if (_e666 < 0f) {
                            phi_997_ = -(_e666);
                        } else {
                            phi_997_ = _e666;
                        }
                        let _e747 = phi_997_;
                        if (_e670 < 0f) {
                            phi_1003_ = -(_e670);
                        } else {
                            phi_1003_ = _e670;
                        }
                        let _e751 = phi_1003_;
                        if (_e674 < 0f) {
                            phi_1009_ = -(_e674);
                        } else {
                            phi_1009_ = _e674;
                        }
                        let _e755 = phi_1009_;
                        let _e762 = (_e743 - (_e676[2] + (((_e747 * _e681[0]) + (_e751 * _e681[1])) + (_e755 * _e681[2]))));
                        let _e765 = local.member_2[0u];
                        if (_e765 < 0f) {
                            phi_1028_ = -(_e765);
                        } else {
                            phi_1028_ = _e765;
                        }
                        let _e769 = phi_1028_;
                        if (_e642 < 0f) {
                            phi_1035_ = -(_e642);
                        } else {
                            phi_1035_ = _e642;
                        }
                        let _e773 = phi_1035_;
                        if (_e654 < 0f) {
                            phi_1041_ = -(_e654);
                        } else {
                            phi_1041_ = _e654;
                        }
                        let _e777 = phi_1041_;
                        if (_e666 < 0f) {
                            phi_1047_ = -(_e666);
                        } else {
                            phi_1047_ = _e666;
                        }
                        let _e781 = phi_1047_;
                        let _e788 = (_e769 - (_e681[0] + (((_e773 * _e676[0]) + (_e777 * _e676[1])) + (_e781 * _e676[2]))));
                        let _e791 = local.member_2[1u];
                        if (_e791 < 0f) {
                            phi_1066_ = -(_e791);
                        } else {
                            phi_1066_ = _e791;
                        }
                        let _e795 = phi_1066_;
                        if (_e646 < 0f) {
                            phi_1073_ = -(_e646);
                        } else {
                            phi_1073_ = _e646;
                        }
                        let _e799 = phi_1073_;
                        if (_e658 < 0f) {
                            phi_1079_ = -(_e658);
                        } else {
                            phi_1079_ = _e658;
                        }
                        let _e803 = phi_1079_;
                        if (_e670 < 0f) {
                            phi_1085_ = -(_e670);
                        } else {
                            phi_1085_ = _e670;
                        }
                        let _e807 = phi_1085_;
                        let _e814 = (_e795 - (_e681[1] + (((_e799 * _e676[0]) + (_e803 * _e676[1])) + (_e807 * _e676[2]))));
                        let _e817 = local.member_2[2u];
                        if (_e817 < 0f) {
                            phi_1104_ = -(_e817);
                        } else {
                            phi_1104_ = _e817;
                        }
                        let _e821 = phi_1104_;
                        if (_e650 < 0f) {
                            phi_1111_ = -(_e650);
                        } else {
                            phi_1111_ = _e650;
                        }
                        let _e825 = phi_1111_;
                        if (_e662 < 0f) {
                            phi_1117_ = -(_e662);
                        } else {
                            phi_1117_ = _e662;
                        }
                        let _e829 = phi_1117_;
                        if (_e674 < 0f) {
                            phi_1123_ = -(_e674);
                        } else {
                            phi_1123_ = _e674;
                        }
                        let _e833 = phi_1123_;
                        let _e840 = (_e821 - (_e681[2] + (((_e825 * _e676[0]) + (_e829 * _e676[1])) + (_e833 * _e676[2]))));
                        if (_e710 > _e736) {
                            phi_1138_ = _e710;
                        } else {
                            phi_1138_ = _e736;
                        }
                        let _e843 = phi_1138_;
                        if (_e843 > _e762) {
                            phi_1143_ = _e843;
                        } else {
                            phi_1143_ = _e762;
                        }
                        let _e846 = phi_1143_;
                        if (_e788 > _e814) {
                            phi_1148_ = _e788;
                        } else {
                            phi_1148_ = _e814;
                        }
                        let _e849 = phi_1148_;
                        if (_e849 > _e840) {
                            phi_1153_ = _e849;
                        } else {
                            phi_1153_ = _e840;
                        }
                        let _e852 = phi_1153_;
                        if (_e846 > _e852) {
                            phi_1158_ = _e846;
                        } else {
                            phi_1158_ = _e852;
                        }
                        let _e855 = phi_1158_;
                        let _e857 = local.member_5;
                        if (_e855 > _e857) {
                            phi_2471_ = true;
                        } else {
                            let _e862 = local.member[1u][0u];
                            let _e865 = local.member_1[2u];
                            let _e870 = local.member[2u][0u];
                            let _e873 = local.member_1[1u];
                            let _e875 = ((_e862 * _e865) - (_e870 * _e873));
                            let _e879 = local.member[2u][0u];
                            if (_e879 < 0f) {
                                phi_1217_ = -(_e879);
                            } else {
                                phi_1217_ = _e879;
                            }
                            let _e883 = phi_1217_;
                            let _e886 = local.member_3[1u];
                            let _e891 = local.member[1u][0u];
                            if (_e891 < 0f) {
                                phi_1240_ = -(_e891);
                            } else {
                                phi_1240_ = _e891;
                            }
                            let _e895 = phi_1240_;
                            let _e898 = local.member_3[2u];
                            let _e904 = local.member[0u][2u];
                            if (_e904 < 0f) {
                                phi_1263_ = -(_e904);
                            } else {
                                phi_1263_ = _e904;
                            }
                            let _e908 = phi_1263_;
                            let _e911 = local.member_4[1u];
                            let _e916 = local.member[0u][1u];
                            if (_e916 < 0f) {
                                phi_1285_ = -(_e916);
                            } else {
                                phi_1285_ = _e916;
                            }
                            let _e920 = phi_1285_;
                            let _e923 = local.member_4[2u];
                            if (_e875 < 0f) {
                                phi_1301_ = -(_e875);
                            } else {
                                phi_1301_ = _e875;
                            }
                            let _e929 = phi_1301_;
                            let _e931 = (_e929 - (((_e883 * _e886) + (_e895 * _e898)) + ((_e908 * _e911) + (_e920 * _e923))));
                            let _e935 = local.member[1u][1u];
                            let _e938 = local.member_1[2u];
                            let _e943 = local.member[2u][1u];
                            let _e946 = local.member_1[1u];
                            let _e948 = ((_e935 * _e938) - (_e943 * _e946));
                            let _e952 = local.member[2u][1u];
                            if (_e952 < 0f) {
                                phi_1356_ = -(_e952);
                            } else {
                                phi_1356_ = _e952;
                            }
                            let _e956 = phi_1356_;
                            let _e959 = local.member_3[1u];
                            let _e964 = local.member[1u][1u];
                            if (_e964 < 0f) {
                                phi_1379_ = -(_e964);
                            } else {
                                phi_1379_ = _e964;
                            }
                            let _e968 = phi_1379_;
                            let _e971 = local.member_3[2u];
                            let _e977 = local.member[0u][0u];
                            if (_e977 < 0f) {
                                phi_1402_ = -(_e977);
                            } else {
                                phi_1402_ = _e977;
                            }
                            let _e981 = phi_1402_;
                            let _e984 = local.member_4[2u];
                            let _e989 = local.member[0u][2u];
                            if (_e989 < 0f) {
                                phi_1424_ = -(_e989);
                            } else {
                                phi_1424_ = _e989;
                            }
                            let _e993 = phi_1424_;
                            let _e996 = local.member_4[0u];
                            if (_e948 < 0f) {
                                phi_1440_ = -(_e948);
                            } else {
                                phi_1440_ = _e948;
                            }
                            let _e1002 = phi_1440_;
                            let _e1004 = (_e1002 - (((_e956 * _e959) + (_e968 * _e971)) + ((_e981 * _e984) + (_e993 * _e996))));
                            let _e1008 = local.member[1u][2u];
                            let _e1011 = local.member_1[2u];
                            let _e1016 = local.member[2u][2u];
                            let _e1019 = local.member_1[1u];
                            let _e1021 = ((_e1008 * _e1011) - (_e1016 * _e1019));
                            let _e1025 = local.member[2u][2u];
                            if (_e1025 < 0f) {
                                phi_1495_ = -(_e1025);
                            } else {
                                phi_1495_ = _e1025;
                            }
                            let _e1029 = phi_1495_;
                            let _e1032 = local.member_3[1u];
                            let _e1037 = local.member[1u][2u];
                            if (_e1037 < 0f) {
                                phi_1518_ = -(_e1037);
                            } else {
                                phi_1518_ = _e1037;
                            }
                            let _e1041 = phi_1518_;
                            let _e1044 = local.member_3[2u];
                            let _e1050 = local.member[0u][1u];
                            if (_e1050 < 0f) {
                                phi_1541_ = -(_e1050);
                            } else {
                                phi_1541_ = _e1050;
                            }
                            let _e1054 = phi_1541_;
                            let _e1057 = local.member_4[0u];
                            let _e1062 = local.member[0u][0u];
                            if (_e1062 < 0f) {
                                phi_1563_ = -(_e1062);
                            } else {
                                phi_1563_ = _e1062;
                            }
                            let _e1066 = phi_1563_;
                            let _e1069 = local.member_4[1u];
                            if (_e1021 < 0f) {
                                phi_1579_ = -(_e1021);
                            } else {
                                phi_1579_ = _e1021;
                            }
                            let _e1075 = phi_1579_;
                            let _e1077 = (_e1075 - (((_e1029 * _e1032) + (_e1041 * _e1044)) + ((_e1054 * _e1057) + (_e1066 * _e1069))));
                            let _e1081 = local.member[2u][0u];
                            let _e1084 = local.member_1[0u];
                            let _e1089 = local.member[0u][0u];
                            let _e1092 = local.member_1[2u];
                            let _e1094 = ((_e1081 * _e1084) - (_e1089 * _e1092));
                            let _e1098 = local.member[0u][0u];
                            if (_e1098 < 0f) {
                                phi_1634_ = -(_e1098);
                            } else {
                                phi_1634_ = _e1098;
                            }
                            let _e1102 = phi_1634_;
                            let _e1105 = local.member_3[2u];
                            let _e1110 = local.member[2u][0u];
                            if (_e1110 < 0f) {
                                phi_1657_ = -(_e1110);
                            } else {
                                phi_1657_ = _e1110;
                            }
                            let _e1114 = phi_1657_;
                            let _e1117 = local.member_3[0u];
                            let _e1123 = local.member[1u][2u];
                            if (_e1123 < 0f) {
                                phi_1681_ = -(_e1123);
                            } else {
                                phi_1681_ = _e1123;
                            }
                            let _e1127 = phi_1681_;
                            let _e1130 = local.member_4[1u];
                            let _e1135 = local.member[1u][1u];
                            if (_e1135 < 0f) {
                                phi_1704_ = -(_e1135);
                            } else {
                                phi_1704_ = _e1135;
                            }
                            let _e1139 = phi_1704_;
                            let _e1142 = local.member_4[2u];
                            if (_e1094 < 0f) {
                                phi_1720_ = -(_e1094);
                            } else {
                                phi_1720_ = _e1094;
                            }
                            let _e1148 = phi_1720_;
                            let _e1150 = (_e1148 - (((_e1102 * _e1105) + (_e1114 * _e1117)) + ((_e1127 * _e1130) + (_e1139 * _e1142))));
                            let _e1154 = local.member[2u][1u];
                            let _e1157 = local.member_1[0u];
                            let _e1162 = local.member[0u][1u];
                            let _e1165 = local.member_1[2u];
                            let _e1167 = ((_e1154 * _e1157) - (_e1162 * _e1165));
                            let _e1171 = local.member[0u][1u];
                            if (_e1171 < 0f) {
                                phi_1775_ = -(_e1171);
                            } else {
                                phi_1775_ = _e1171;
                            }
                            let _e1175 = phi_1775_;
                            let _e1178 = local.member_3[2u];
                            let _e1183 = local.member[2u][1u];
                            if (_e1183 < 0f) {
                                phi_1798_ = -(_e1183);
                            } else {
                                phi_1798_ = _e1183;
                            }
                            let _e1187 = phi_1798_;
                            let _e1190 = local.member_3[0u];
                            let _e1196 = local.member[1u][0u];
                            if (_e1196 < 0f) {
                                phi_1822_ = -(_e1196);
                            } else {
                                phi_1822_ = _e1196;
                            }
                            let _e1200 = phi_1822_;
                            let _e1203 = local.member_4[2u];
                            let _e1208 = local.member[1u][2u];
                            if (_e1208 < 0f) {
                                phi_1845_ = -(_e1208);
                            } else {
                                phi_1845_ = _e1208;
                            }
                            let _e1212 = phi_1845_;
                            let _e1215 = local.member_4[0u];
                            if (_e1167 < 0f) {
                                phi_1861_ = -(_e1167);
                            } else {
                                phi_1861_ = _e1167;
                            }
                            let _e1221 = phi_1861_;
                            let _e1223 = (_e1221 - (((_e1175 * _e1178) + (_e1187 * _e1190)) + ((_e1200 * _e1203) + (_e1212 * _e1215))));
                            let _e1227 = local.member[2u][2u];
                            let _e1230 = local.member_1[0u];
                            let _e1235 = local.member[0u][2u];
                            let _e1238 = local.member_1[2u];
                            let _e1240 = ((_e1227 * _e1230) - (_e1235 * _e1238));
                            let _e1244 = local.member[0u][2u];
                            if (_e1244 < 0f) {
                                phi_1916_ = -(_e1244);
                            } else {
                                phi_1916_ = _e1244;
                            }
                            let _e1248 = phi_1916_;
                            let _e1251 = local.member_3[2u];
                            let _e1256 = local.member[2u][2u];
                            if (_e1256 < 0f) {
                                phi_1939_ = -(_e1256);
                            } else {
                                phi_1939_ = _e1256;
                            }
                            let _e1260 = phi_1939_;
                            let _e1263 = local.member_3[0u];
                            let _e1269 = local.member[1u][1u];
                            if (_e1269 < 0f) {
                                phi_1963_ = -(_e1269);
                            } else {
                                phi_1963_ = _e1269;
                            }
                            let _e1273 = phi_1963_;
                            let _e1276 = local.member_4[0u];
                            let _e1281 = local.member[1u][0u];
                            if (_e1281 < 0f) {
                                phi_1986_ = -(_e1281);
                            } else {
                                phi_1986_ = _e1281;
                            }
                            let _e1285 = phi_1986_;
                            let _e1288 = local.member_4[1u];
                            if (_e1240 < 0f) {
                                phi_2002_ = -(_e1240);
                            } else {
                                phi_2002_ = _e1240;
                            }
                            let _e1294 = phi_2002_;
                            let _e1296 = (_e1294 - (((_e1248 * _e1251) + (_e1260 * _e1263)) + ((_e1273 * _e1276) + (_e1285 * _e1288))));
                            let _e1300 = local.member[0u][0u];
                            let _e1303 = local.member_1[1u];
                            let _e1308 = local.member[1u][0u];
                            let _e1311 = local.member_1[0u];
                            let _e1313 = ((_e1300 * _e1303) - (_e1308 * _e1311));
                            let _e1317 = local.member[1u][0u];
                            if (_e1317 < 0f) {
                                phi_2057_ = -(_e1317);
                            } else {
                                phi_2057_ = _e1317;
                            }
                            let _e1321 = phi_2057_;
                            let _e1324 = local.member_3[0u];
                            let _e1329 = local.member[0u][0u];
                            if (_e1329 < 0f) {
                                phi_2080_ = -(_e1329);
                            } else {
                                phi_2080_ = _e1329;
                            }
                            let _e1333 = phi_2080_;
                            let _e1336 = local.member_3[1u];
                            let _e1342 = local.member[2u][2u];
                            if (_e1342 < 0f) {
                                phi_2104_ = -(_e1342);
                            } else {
                                phi_2104_ = _e1342;
                            }
                            let _e1346 = phi_2104_;
                            let _e1349 = local.member_4[1u];
                            let _e1354 = local.member[2u][1u];
                            if (_e1354 < 0f) {
                                phi_2127_ = -(_e1354);
                            } else {
                                phi_2127_ = _e1354;
                            }
                            let _e1358 = phi_2127_;
                            let _e1361 = local.member_4[2u];
                            if (_e1313 < 0f) {
                                phi_2143_ = -(_e1313);
                            } else {
                                phi_2143_ = _e1313;
                            }
                            let _e1367 = phi_2143_;
                            let _e1369 = (_e1367 - (((_e1321 * _e1324) + (_e1333 * _e1336)) + ((_e1346 * _e1349) + (_e1358 * _e1361))));
                            let _e1373 = local.member[0u][1u];
                            let _e1376 = local.member_1[1u];
                            let _e1381 = local.member[1u][1u];
                            let _e1384 = local.member_1[0u];
                            let _e1386 = ((_e1373 * _e1376) - (_e1381 * _e1384));
                            let _e1390 = local.member[1u][1u];
                            if (_e1390 < 0f) {
                                phi_2198_ = -(_e1390);
                            } else {
                                phi_2198_ = _e1390;
                            }
                            let _e1394 = phi_2198_;
                            let _e1397 = local.member_3[0u];
                            let _e1402 = local.member[0u][1u];
                            if (_e1402 < 0f) {
                                phi_2221_ = -(_e1402);
                            } else {
                                phi_2221_ = _e1402;
                            }
                            let _e1406 = phi_2221_;
                            let _e1409 = local.member_3[1u];
                            let _e1415 = local.member[2u][0u];
                            if (_e1415 < 0f) {
                                phi_2245_ = -(_e1415);
                            } else {
                                phi_2245_ = _e1415;
                            }
                            let _e1419 = phi_2245_;
                            let _e1422 = local.member_4[2u];
                            let _e1427 = local.member[2u][2u];
                            if (_e1427 < 0f) {
                                phi_2268_ = -(_e1427);
                            } else {
                                phi_2268_ = _e1427;
                            }
                            let _e1431 = phi_2268_;
                            let _e1434 = local.member_4[0u];
                            if (_e1386 < 0f) {
                                phi_2284_ = -(_e1386);
                            } else {
                                phi_2284_ = _e1386;
                            }
                            let _e1440 = phi_2284_;
                            let _e1442 = (_e1440 - (((_e1394 * _e1397) + (_e1406 * _e1409)) + ((_e1419 * _e1422) + (_e1431 * _e1434))));
                            let _e1446 = local.member[0u][2u];
                            let _e1449 = local.member_1[1u];
                            let _e1454 = local.member[1u][2u];
                            let _e1457 = local.member_1[0u];
                            let _e1459 = ((_e1446 * _e1449) - (_e1454 * _e1457));
                            let _e1463 = local.member[1u][2u];
                            if (_e1463 < 0f) {
                                phi_2339_ = -(_e1463);
                            } else {
                                phi_2339_ = _e1463;
                            }
                            let _e1467 = phi_2339_;
                            let _e1470 = local.member_3[0u];
                            let _e1475 = local.member[0u][2u];
                            if (_e1475 < 0f) {
                                phi_2362_ = -(_e1475);
                            } else {
                                phi_2362_ = _e1475;
                            }
                            let _e1479 = phi_2362_;
                            let _e1482 = local.member_3[1u];
                            let _e1488 = local.member[2u][1u];
                            if (_e1488 < 0f) {
                                phi_2386_ = -(_e1488);
                            } else {
                                phi_2386_ = _e1488;
                            }
                            let _e1492 = phi_2386_;
                            let _e1495 = local.member_4[0u];
                            let _e1500 = local.member[2u][0u];
                            if (_e1500 < 0f) {
                                phi_2409_ = -(_e1500);
                            } else {
                                phi_2409_ = _e1500;
                            }
                            let _e1504 = phi_2409_;
                            let _e1507 = local.member_4[1u];
                            if (_e1459 < 0f) {
                                phi_2425_ = -(_e1459);
                            } else {
                                phi_2425_ = _e1459;
                            }
                            let _e1513 = phi_2425_;
                            let _e1515 = (_e1513 - (((_e1467 * _e1470) + (_e1479 * _e1482)) + ((_e1492 * _e1495) + (_e1504 * _e1507))));
                            if (_e931 > _e1004) {
                                phi_2432_ = _e931;
                            } else {
                                phi_2432_ = _e1004;
                            }
                            let _e1518 = phi_2432_;
                            if (_e1518 > _e1077) {
                                phi_2437_ = _e1518;
                            } else {
                                phi_2437_ = _e1077;
                            }
                            let _e1521 = phi_2437_;
                            if (_e1150 > _e1223) {
                                phi_2442_ = _e1150;
                            } else {
                                phi_2442_ = _e1223;
                            }
                            let _e1524 = phi_2442_;
                            if (_e1524 > _e1296) {
                                phi_2447_ = _e1524;
                            } else {
                                phi_2447_ = _e1296;
                            }
                            let _e1527 = phi_2447_;
                            if (_e1521 > _e1527) {
                                phi_2452_ = _e1521;
                            } else {
                                phi_2452_ = _e1527;
                            }
                            let _e1530 = phi_2452_;
                            if (_e1369 > _e1442) {
                                phi_2457_ = _e1369;
                            } else {
                                phi_2457_ = _e1442;
                            }
                            let _e1533 = phi_2457_;
                            if (_e1533 > _e1515) {
                                phi_2462_ = _e1533;
                            } else {
                                phi_2462_ = _e1515;
                            }
                            let _e1536 = phi_2462_;
                            if (_e1530 > _e1536) {
                                phi_2467_ = _e1530;
                            } else {
                                phi_2467_ = _e1536;
                            }
                            let _e1539 = phi_2467_;
                            let _e1541 = local.member_5;
                            phi_2471_ = (_e1539 > _e1541);
                        }
                        let _e1544 = phi_2471_;
                        phi_2473_ = !(_e1544);
                        phi_2474_ = false;
                    } else {
                        phi_2473_ = bool();
                        phi_2474_ = true;
                    }
                    let _e1547 = phi_2473_;
                    let _e1549 = phi_2474_;
                    phi_2475_ = _e1547;
                    phi_2476_ = _e1549;
                }
                let _e1551 = phi_2475_;
                let _e1553 = phi_2476_;
                if _e1553 {
                    phi_2480_ = true;
                } else {
                    phi_2480_ = _e1551;
                }
                let _e1555 = phi_2480_;
                phi_2481_ = _e1555;
            } else {
                phi_2481_ = false;
            }
            let _e1557 = phi_2481_;
            if _e1557 {
                let _e1585 = atomicAdd((&control.member[0u]), 1u);
                let _e1588 = atomicMax((&output.member[0u]), (_e1585 + 1u));
                if ((_e1585 + 1u) < _e1585) {
                    let _e1592 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1595 = params.member.member_2.member_3;
                if (_e1585 < _e1595) {
                    let _e1599 = (2u * _e1585);
                    atomicStore((&output.member[(4u + _e1599)]), _e93[0]);
                    atomicStore((&output.member[(_e1599 + 5u)]), _e93[1]);
                }
            } else {
                let _e1560 = params.member.member_2.member_4;
                if (_e1560 > 0u) {
                    let _e1563 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e1563 + 1u) < _e1563) {
                        let _e1567 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e1570 = params.member.member_2.member_4;
                    if (_e1563 < _e1570) {
                        let _e1573 = params.member.member_2.member_5;
                        let _e1575 = params.member.member_2.member_4;
                        let _e1578 = (2u * ((_e1573 * _e1575) + _e1563));
                        front.member[_e1578] = _e93[0];
                        front.member[(_e1578 + 1u)] = _e93[1];
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
