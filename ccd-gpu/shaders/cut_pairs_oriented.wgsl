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
    member: type_7,
    member_1: type_8,
    member_2: type_8,
}

struct type_17 {
    member: type_16,
}

struct type_19 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_21 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_27 {
    member: array<atomic<u32>>,
}

@group(0) @binding(7) 
var<storage, read_write> output: type_27;
@group(0) @binding(0) 
var<storage> params: type_17;
@group(0) @binding(1) 
var<storage> a_nodes: type_15;
@group(0) @binding(2) 
var<storage> b_nodes: type_15;
@group(0) @binding(3) 
var<storage> a_cut: type_10;
@group(0) @binding(4) 
var<storage> b_cut: type_10;
@group(0) @binding(5) 
var<storage> oriented: type_23;
@group(0) @binding(6) 
var<storage, read_write> levels: type_27;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var phi_205_: array<u32, 2>;
    var phi_258_: bool;
    var phi_259_: bool;
    var phi_260_: bool;
    var phi_300_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_398_: f32;
    var phi_403_: f32;
    var phi_408_: f32;
    var phi_424_: type_24;
    var phi_506_: f32;
    var phi_511_: f32;
    var phi_516_: f32;
    var phi_532_: type_24;
    var phi_722_: f32;
    var phi_728_: f32;
    var phi_735_: f32;
    var phi_744_: f32;
    var phi_751_: f32;
    var phi_759_: f32;
    var phi_768_: f32;
    var phi_775_: f32;
    var phi_783_: f32;
    var phi_876_: f32;
    var phi_883_: f32;
    var phi_889_: f32;
    var phi_895_: f32;
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
    var phi_1100_: f32;
    var phi_1105_: f32;
    var phi_1110_: f32;
    var phi_1115_: f32;
    var phi_1120_: f32;
    var phi_1179_: f32;
    var phi_1202_: f32;
    var phi_1225_: f32;
    var phi_1247_: f32;
    var phi_1263_: f32;
    var phi_1318_: f32;
    var phi_1341_: f32;
    var phi_1364_: f32;
    var phi_1386_: f32;
    var phi_1402_: f32;
    var phi_1457_: f32;
    var phi_1480_: f32;
    var phi_1503_: f32;
    var phi_1525_: f32;
    var phi_1541_: f32;
    var phi_1596_: f32;
    var phi_1619_: f32;
    var phi_1643_: f32;
    var phi_1666_: f32;
    var phi_1682_: f32;
    var phi_1737_: f32;
    var phi_1760_: f32;
    var phi_1784_: f32;
    var phi_1807_: f32;
    var phi_1823_: f32;
    var phi_1878_: f32;
    var phi_1901_: f32;
    var phi_1925_: f32;
    var phi_1948_: f32;
    var phi_1964_: f32;
    var phi_2019_: f32;
    var phi_2042_: f32;
    var phi_2066_: f32;
    var phi_2089_: f32;
    var phi_2105_: f32;
    var phi_2160_: f32;
    var phi_2183_: f32;
    var phi_2207_: f32;
    var phi_2230_: f32;
    var phi_2246_: f32;
    var phi_2301_: f32;
    var phi_2324_: f32;
    var phi_2348_: f32;
    var phi_2371_: f32;
    var phi_2387_: f32;
    var phi_2394_: f32;
    var phi_2399_: f32;
    var phi_2404_: f32;
    var phi_2409_: f32;
    var phi_2414_: f32;
    var phi_2419_: f32;
    var phi_2424_: f32;
    var phi_2429_: f32;
    var phi_2433_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2442_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e34 = id_2;
    let _e35 = n_2;
    let _e36 = lane_2;
    let _e51 = ((((_e34.y * _e35.x) + _e34.x) * 256u) + _e36);
    let _e54 = params.member.member_2.member_2;
    if (_e54 == 0u) {
        return;
    }
    let _e56 = (_e51 / _e54);
    let _e59 = params.member.member_2.member_2;
    if (_e59 == 0u) {
        return;
    }
    let _e61 = (_e51 % _e59);
    let _e63 = a_cut.member[0u];
    if (_e56 < _e63) {
        let _e66 = b_cut.member[0u];
        if (_e61 < _e66) {
            let _e70 = a_cut.member[(4u + _e56)];
            let _e73 = b_cut.member[(4u + _e61)];
            let _e75 = a_nodes.member[_e70];
            let _e77 = b_nodes.member[_e73];
            let _e80 = params.member.member_2.member;
            if (_e80 == 0u) {
                phi_205_ = array<u32, 2>(0u, 2u);
            } else {
                phi_205_ = array<u32, 2>(1u, 1u);
            }
            let _e83 = phi_205_;
            let _e89 = params.member.member.member[_e83[0]];
            let _e90 = (_e89 - 1u);
            let _e94 = params.member.member.member[_e83[1]];
            let _e95 = (_e94 - 1u);
            let _e99 = params.member.member.member_2[_e83[0]];
            let _e103 = params.member.member.member_2[_e83[1]];
            let _e106 = params.member.member_2.member;
            let _e107 = (_e106 == 1u);
            if _e107 {
                if (_e56 < _e61) {
                    phi_259_ = true;
                } else {
                    if (_e56 == _e61) {
                        phi_258_ = !((_e75.member_3 == 4294967295u));
                    } else {
                        phi_258_ = false;
                    }
                    let _e114 = phi_258_;
                    phi_259_ = _e114;
                }
                let _e116 = phi_259_;
                phi_260_ = _e116;
            } else {
                phi_260_ = true;
            }
            let _e118 = phi_260_;
            if _e118 {
                if ((((((_e75.member[0] <= _e77.member_2[0]) && (_e77.member[0] <= _e75.member_2[0])) && (_e75.member[1] <= _e77.member_2[1])) && (_e77.member[1] <= _e75.member_2[1])) && (_e75.member[2] <= _e77.member_2[2])) && (_e77.member[2] <= _e75.member_2[2])) {
                    if _e107 {
                        phi_300_ = (_e70 == _e73);
                    } else {
                        phi_300_ = false;
                    }
                    let _e148 = phi_300_;
                    if _e148 {
                        phi_2437_ = bool();
                        phi_2438_ = true;
                    } else {
                        if (_e70 >= _e90) {
                            if (_e73 >= _e95) {
                                phi_312_ = false;
                            } else {
                                phi_312_ = true;
                            }
                            let _e152 = phi_312_;
                            phi_313_ = _e152;
                        } else {
                            phi_313_ = true;
                        }
                        let _e154 = phi_313_;
                        if _e154 {
                            if (_e70 < _e90) {
                                let _e210 = oriented.member[(_e99 + _e70)];
                                phi_424_ = type_24(array<f32, 3>(_e210.member.x, _e210.member.y, _e210.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e210.member.w, _e210.member_1.x, _e210.member_1.y), array<f32, 3>(_e210.member_1.z, _e210.member_1.w, _e210.member_2.x), array<f32, 3>(_e210.member_2.y, _e210.member_2.z, _e210.member_2.w)), array<f32, 3>(_e210.member_3.x, _e210.member_3.y, _e210.member_3.z));
                            } else {
                                let _e157 = a_nodes.member[_e70];
                                let _e172 = ((_e157.member[0] * 0.5f) + (_e157.member_2[0] * 0.5f));
                                let _e173 = ((_e157.member[1] * 0.5f) + (_e157.member_2[1] * 0.5f));
                                let _e174 = ((_e157.member[2] * 0.5f) + (_e157.member_2[2] * 0.5f));
                                let _e177 = (_e157.member_2[0] - _e172);
                                let _e179 = (_e157.member_2[1] - _e173);
                                let _e181 = (_e157.member_2[2] - _e174);
                                let _e183 = (_e172 - _e157.member[0]);
                                let _e185 = (_e173 - _e157.member[1]);
                                let _e187 = (_e174 - _e157.member[2]);
                                if (_e177 > _e183) {
                                    phi_398_ = _e177;
                                } else {
                                    phi_398_ = _e183;
                                }
                                let _e190 = phi_398_;
                                if (_e179 > _e185) {
                                    phi_403_ = _e179;
                                } else {
                                    phi_403_ = _e185;
                                }
                                let _e193 = phi_403_;
                                if (_e181 > _e187) {
                                    phi_408_ = _e181;
                                } else {
                                    phi_408_ = _e187;
                                }
                                let _e196 = phi_408_;
                                let _e198 = (1f + (0.000000059604645f * 4f));
                                let _e202 = (0.000000000000000000000000000000000000011754944f * 8f);
                                phi_424_ = type_24(array<f32, 3>(_e172, _e173, _e174), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e190 * _e198) + _e202), ((_e193 * _e198) + _e202), ((_e196 * _e198) + _e202)));
                            }
                            let _e249 = phi_424_;
                            if (_e73 < _e95) {
                                let _e305 = oriented.member[(_e103 + _e73)];
                                phi_532_ = type_24(array<f32, 3>(_e305.member.x, _e305.member.y, _e305.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e305.member.w, _e305.member_1.x, _e305.member_1.y), array<f32, 3>(_e305.member_1.z, _e305.member_1.w, _e305.member_2.x), array<f32, 3>(_e305.member_2.y, _e305.member_2.z, _e305.member_2.w)), array<f32, 3>(_e305.member_3.x, _e305.member_3.y, _e305.member_3.z));
                            } else {
                                let _e252 = b_nodes.member[_e73];
                                let _e267 = ((_e252.member[0] * 0.5f) + (_e252.member_2[0] * 0.5f));
                                let _e268 = ((_e252.member[1] * 0.5f) + (_e252.member_2[1] * 0.5f));
                                let _e269 = ((_e252.member[2] * 0.5f) + (_e252.member_2[2] * 0.5f));
                                let _e272 = (_e252.member_2[0] - _e267);
                                let _e274 = (_e252.member_2[1] - _e268);
                                let _e276 = (_e252.member_2[2] - _e269);
                                let _e278 = (_e267 - _e252.member[0]);
                                let _e280 = (_e268 - _e252.member[1]);
                                let _e282 = (_e269 - _e252.member[2]);
                                if (_e272 > _e278) {
                                    phi_506_ = _e272;
                                } else {
                                    phi_506_ = _e278;
                                }
                                let _e285 = phi_506_;
                                if (_e274 > _e280) {
                                    phi_511_ = _e274;
                                } else {
                                    phi_511_ = _e280;
                                }
                                let _e288 = phi_511_;
                                if (_e276 > _e282) {
                                    phi_516_ = _e276;
                                } else {
                                    phi_516_ = _e282;
                                }
                                let _e291 = phi_516_;
                                let _e293 = (1f + (0.000000059604645f * 4f));
                                let _e297 = (0.000000000000000000000000000000000000011754944f * 8f);
                                phi_532_ = type_24(array<f32, 3>(_e267, _e268, _e269), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e285 * _e293) + _e297), ((_e288 * _e293) + _e297), ((_e291 * _e293) + _e297)));
                            }
                            let _e344 = phi_532_;
                            let _e349 = (_e344.member[0] - _e249.member[0]);
                            let _e352 = (_e344.member[1] - _e249.member[1]);
                            let _e355 = (_e344.member[2] - _e249.member[2]);
                            if (_e349 < 0f) {
                                phi_722_ = -(_e349);
                            } else {
                                phi_722_ = _e349;
                            }
                            let _e544 = phi_722_;
                            if (_e352 < 0f) {
                                phi_728_ = -(_e352);
                            } else {
                                phi_728_ = _e352;
                            }
                            let _e548 = phi_728_;
                            if (_e355 < 0f) {
                                phi_735_ = -(_e355);
                            } else {
                                phi_735_ = _e355;
                            }
                            let _e553 = phi_735_;
                            if (_e249.member_2[0] < 0f) {
                                phi_744_ = -(_e249.member_2[0]);
                            } else {
                                phi_744_ = _e249.member_2[0];
                            }
                            let _e560 = phi_744_;
                            if (_e249.member_2[1] < 0f) {
                                phi_751_ = -(_e249.member_2[1]);
                            } else {
                                phi_751_ = _e249.member_2[1];
                            }
                            let _e565 = phi_751_;
                            if (_e249.member_2[2] < 0f) {
                                phi_759_ = -(_e249.member_2[2]);
                            } else {
                                phi_759_ = _e249.member_2[2];
                            }
                            let _e571 = phi_759_;
                            if (_e344.member_2[0] < 0f) {
                                phi_768_ = -(_e344.member_2[0]);
                            } else {
                                phi_768_ = _e344.member_2[0];
                            }
                            let _e578 = phi_768_;
                            if (_e344.member_2[1] < 0f) {
                                phi_775_ = -(_e344.member_2[1]);
                            } else {
                                phi_775_ = _e344.member_2[1];
                            }
                            let _e583 = phi_775_;
                            if (_e344.member_2[2] < 0f) {
                                phi_783_ = -(_e344.member_2[2]);
                            } else {
                                phi_783_ = _e344.member_2[2];
                            }
                            let _e589 = phi_783_;
                            local = type_19(array<array<f32, 3>, 3>(array<f32, 3>((((_e344.member_1[0][0] * _e249.member_1[0][0]) + (_e344.member_1[0][1] * _e249.member_1[0][1])) + (_e344.member_1[0][2] * _e249.member_1[0][2])), (((_e344.member_1[1][0] * _e249.member_1[0][0]) + (_e344.member_1[1][1] * _e249.member_1[0][1])) + (_e344.member_1[1][2] * _e249.member_1[0][2])), (((_e344.member_1[2][0] * _e249.member_1[0][0]) + (_e344.member_1[2][1] * _e249.member_1[0][1])) + (_e344.member_1[2][2] * _e249.member_1[0][2]))), array<f32, 3>((((_e344.member_1[0][0] * _e249.member_1[1][0]) + (_e344.member_1[0][1] * _e249.member_1[1][1])) + (_e344.member_1[0][2] * _e249.member_1[1][2])), (((_e344.member_1[1][0] * _e249.member_1[1][0]) + (_e344.member_1[1][1] * _e249.member_1[1][1])) + (_e344.member_1[1][2] * _e249.member_1[1][2])), (((_e344.member_1[2][0] * _e249.member_1[1][0]) + (_e344.member_1[2][1] * _e249.member_1[1][1])) + (_e344.member_1[2][2] * _e249.member_1[1][2]))), array<f32, 3>((((_e344.member_1[0][0] * _e249.member_1[2][0]) + (_e344.member_1[0][1] * _e249.member_1[2][1])) + (_e344.member_1[0][2] * _e249.member_1[2][2])), (((_e344.member_1[1][0] * _e249.member_1[2][0]) + (_e344.member_1[1][1] * _e249.member_1[2][1])) + (_e344.member_1[1][2] * _e249.member_1[2][2])), (((_e344.member_1[2][0] * _e249.member_1[2][0]) + (_e344.member_1[2][1] * _e249.member_1[2][1])) + (_e344.member_1[2][2] * _e249.member_1[2][2])))), array<f32, 3>((((_e249.member_1[0][0] * _e349) + (_e249.member_1[0][1] * _e352)) + (_e249.member_1[0][2] * _e355)), (((_e249.member_1[1][0] * _e349) + (_e249.member_1[1][1] * _e352)) + (_e249.member_1[1][2] * _e355)), (((_e249.member_1[2][0] * _e349) + (_e249.member_1[2][1] * _e352)) + (_e249.member_1[2][2] * _e355))), array<f32, 3>((((_e344.member_1[0][0] * _e349) + (_e344.member_1[0][1] * _e352)) + (_e344.member_1[0][2] * _e355)), (((_e344.member_1[1][0] * _e349) + (_e344.member_1[1][1] * _e352)) + (_e344.member_1[1][2] * _e355)), (((_e344.member_1[2][0] * _e349) + (_e344.member_1[2][1] * _e352)) + (_e344.member_1[2][2] * _e355))), array<f32, 3>(_e249.member_2[0], _e249.member_2[1], _e249.member_2[2]), array<f32, 3>(_e344.member_2[0], _e344.member_2[1], _e344.member_2[2]), ((((((_e544 + _e548) + _e553) + (((_e560 + _e565) + _e571) + ((_e578 + _e583) + _e589))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                            let _e616 = local.member[0u][0u];
                            let _e620 = local.member[0u][1u];
                            let _e624 = local.member[0u][2u];
                            let _e628 = local.member[1u][0u];
                            let _e632 = local.member[1u][1u];
                            let _e636 = local.member[1u][2u];
                            let _e640 = local.member[2u][0u];
                            let _e644 = local.member[2u][1u];
                            let _e648 = local.member[2u][2u];
                            let _e650 = local.member_3;
                            let _e655 = local.member_4;
                            let _e661 = local.member_1[0u];
                            if (_e661 < 0f) {
                                phi_876_ = -(_e661);
                            } else {
                                phi_876_ = _e661;
                            }
                            let _e665 = phi_876_;
                            if (_e616 < 0f) {
                                phi_883_ = -(_e616);
                            } else {
                                phi_883_ = _e616;
                            }
                            let _e669 = phi_883_;
                            if (_e620 < 0f) {
                                phi_889_ = -(_e620);
                            } else {
                                phi_889_ = _e620;
                            }
                            let _e673 = phi_889_;
                            if (_e624 < 0f) {
                                phi_895_ = -(_e624);
                            } else {
                                phi_895_ = _e624;
                            }
                            let _e677 = phi_895_;
                            let _e684 = (_e665 - (_e650[0] + (((_e669 * _e655[0]) + (_e673 * _e655[1])) + (_e677 * _e655[2]))));
                            let _e687 = local.member_1[1u];
                            if (_e687 < 0f) {
                                phi_914_ = -(_e687);
                            } else {
                                phi_914_ = _e687;
                            }
                            let _e691 = phi_914_;
                            if (_e628 < 0f) {
                                phi_921_ = -(_e628);
                            } else {
                                phi_921_ = _e628;
                            }
                            let _e695 = phi_921_;
                            if (_e632 < 0f) {
                                phi_927_ = -(_e632);
                            } else {
                                phi_927_ = _e632;
                            }
                            let _e699 = phi_927_;
                            if (_e636 < 0f) {
                                phi_933_ = -(_e636);
                            } else {
                                phi_933_ = _e636;
                            }
                            let _e703 = phi_933_;
                            let _e710 = (_e691 - (_e650[1] + (((_e695 * _e655[0]) + (_e699 * _e655[1])) + (_e703 * _e655[2]))));
                            let _e713 = local.member_1[2u];
                            if (_e713 < 0f) {
                                phi_952_ = -(_e713);
                            } else {
                                phi_952_ = _e713;
                            }
                            let _e717 = phi_952_;
                            if (_e640 < 0f) {
                                phi_959_ = -(_e640);
                            } else {
                                phi_959_ = _e640;
                            }
                            let _e721 = phi_959_;
                            if (_e644 < 0f) {
                                phi_965_ = -(_e644);
                            } else {
                                phi_965_ = _e644;
                            }
                            let _e725 = phi_965_;
                            if (_e648 < 0f) {
                                phi_971_ = -(_e648);
                            } else {
                                phi_971_ = _e648;
                            }
                            let _e729 = phi_971_;
                            let _e736 = (_e717 - (_e650[2] + (((_e721 * _e655[0]) + (_e725 * _e655[1])) + (_e729 * _e655[2]))));
                            let _e739 = local.member_2[0u];
                            if (_e739 < 0f) {
                                phi_990_ = -(_e739);
                            } else {
                                phi_990_ = _e739;
                            }
                            let _e743 = phi_990_;
                            if (_e616 < 0f) {
                                phi_997_ = -(_e616);
                            } else {
                                phi_997_ = _e616;
                            }
                            let _e747 = phi_997_;
                            if (_e628 < 0f) {
                                phi_1003_ = -(_e628);
                            } else {
                                phi_1003_ = _e628;
                            }
                            let _e751 = phi_1003_;
                            if (_e640 < 0f) {
                                phi_1009_ = -(_e640);
                            } else {
                                phi_1009_ = _e640;
                            }
                            let _e755 = phi_1009_;
                            let _e762 = (_e743 - (_e655[0] + (((_e747 * _e650[0]) + (_e751 * _e650[1])) + (_e755 * _e650[2]))));
                            let _e765 = local.member_2[1u];
                            if (_e765 < 0f) {
                                phi_1028_ = -(_e765);
                            } else {
                                phi_1028_ = _e765;
                            }
                            let _e769 = phi_1028_;
                            if (_e620 < 0f) {
                                phi_1035_ = -(_e620);
                            } else {
                                phi_1035_ = _e620;
                            }
                            let _e773 = phi_1035_;
                            if (_e632 < 0f) {
                                phi_1041_ = -(_e632);
                            } else {
                                phi_1041_ = _e632;
                            }
                            let _e777 = phi_1041_;
                            if (_e644 < 0f) {
                                phi_1047_ = -(_e644);
                            } else {
                                phi_1047_ = _e644;
                            }
                            let _e781 = phi_1047_;
                            let _e788 = (_e769 - (_e655[1] + (((_e773 * _e650[0]) + (_e777 * _e650[1])) + (_e781 * _e650[2]))));
                            let _e791 = local.member_2[2u];
                            if (_e791 < 0f) {
                                phi_1066_ = -(_e791);
                            } else {
                                phi_1066_ = _e791;
                            }
                            let _e795 = phi_1066_;
                            if (_e624 < 0f) {
                                phi_1073_ = -(_e624);
                            } else {
                                phi_1073_ = _e624;
                            }
                            let _e799 = phi_1073_;
                            if (_e636 < 0f) {
                                phi_1079_ = -(_e636);
                            } else {
                                phi_1079_ = _e636;
                            }
                            let _e803 = phi_1079_;
                            if (_e648 < 0f) {
                                phi_1085_ = -(_e648);
                            } else {
                                phi_1085_ = _e648;
                            }
                            let _e807 = phi_1085_;
                            let _e814 = (_e795 - (_e655[2] + (((_e799 * _e650[0]) + (_e803 * _e650[1])) + (_e807 * _e650[2]))));
                            if (_e684 > _e710) {
                                phi_1100_ = _e684;
                            } else {
                                phi_1100_ = _e710;
                            }
                            let _e817 = phi_1100_;
                            if (_e817 > _e736) {
                                phi_1105_ = _e817;
                            } else {
                                phi_1105_ = _e736;
                            }
                            let _e820 = phi_1105_;
                            if (_e762 > _e788) {
                                phi_1110_ = _e762;
                            } else {
                                phi_1110_ = _e788;
                            }
                            let _e823 = phi_1110_;
                            if (_e823 > _e814) {
                                phi_1115_ = _e823;
                            } else {
                                phi_1115_ = _e814;
                            }
                            let _e826 = phi_1115_;
                            if (_e820 > _e826) {
                                phi_1120_ = _e820;
                            } else {
                                phi_1120_ = _e826;
                            }
                            let _e829 = phi_1120_;
                            let _e831 = local.member_5;
                            if (_e829 > _e831) {
                                phi_2433_ = true;
                            } else {
                                let _e836 = local.member[1u][0u];
                                let _e839 = local.member_1[2u];
                                let _e844 = local.member[2u][0u];
                                let _e847 = local.member_1[1u];
                                let _e849 = ((_e836 * _e839) - (_e844 * _e847));
                                let _e853 = local.member[2u][0u];
                                if (_e853 < 0f) {
                                    phi_1179_ = -(_e853);
                                } else {
                                    phi_1179_ = _e853;
                                }
                                let _e857 = phi_1179_;
                                let _e860 = local.member_3[1u];
                                let _e865 = local.member[1u][0u];
                                if (_e865 < 0f) {
                                    phi_1202_ = -(_e865);
                                } else {
                                    phi_1202_ = _e865;
                                }
                                let _e869 = phi_1202_;
                                let _e872 = local.member_3[2u];
                                let _e878 = local.member[0u][2u];
                                if (_e878 < 0f) {
                                    phi_1225_ = -(_e878);
                                } else {
                                    phi_1225_ = _e878;
                                }
                                let _e882 = phi_1225_;
                                let _e885 = local.member_4[1u];
                                let _e890 = local.member[0u][1u];
                                if (_e890 < 0f) {
                                    phi_1247_ = -(_e890);
                                } else {
                                    phi_1247_ = _e890;
                                }
                                let _e894 = phi_1247_;
                                let _e897 = local.member_4[2u];
                                if (_e849 < 0f) {
                                    phi_1263_ = -(_e849);
                                } else {
                                    phi_1263_ = _e849;
                                }
                                let _e903 = phi_1263_;
                                let _e905 = (_e903 - (((_e857 * _e860) + (_e869 * _e872)) + ((_e882 * _e885) + (_e894 * _e897))));
                                let _e909 = local.member[1u][1u];
                                let _e912 = local.member_1[2u];
                                let _e917 = local.member[2u][1u];
                                let _e920 = local.member_1[1u];
                                let _e922 = ((_e909 * _e912) - (_e917 * _e920));
                                let _e926 = local.member[2u][1u];
                                if (_e926 < 0f) {
                                    phi_1318_ = -(_e926);
                                } else {
                                    phi_1318_ = _e926;
                                }
                                let _e930 = phi_1318_;
                                let _e933 = local.member_3[1u];
                                let _e938 = local.member[1u][1u];
                                if (_e938 < 0f) {
                                    phi_1341_ = -(_e938);
                                } else {
                                    phi_1341_ = _e938;
                                }
                                let _e942 = phi_1341_;
                                let _e945 = local.member_3[2u];
                                let _e951 = local.member[0u][0u];
                                if (_e951 < 0f) {
                                    phi_1364_ = -(_e951);
                                } else {
                                    phi_1364_ = _e951;
                                }
                                let _e955 = phi_1364_;
                                let _e958 = local.member_4[2u];
                                let _e963 = local.member[0u][2u];
                                if (_e963 < 0f) {
                                    phi_1386_ = -(_e963);
                                } else {
                                    phi_1386_ = _e963;
                                }
                                let _e967 = phi_1386_;
                                let _e970 = local.member_4[0u];
                                if (_e922 < 0f) {
                                    phi_1402_ = -(_e922);
                                } else {
                                    phi_1402_ = _e922;
                                }
                                let _e976 = phi_1402_;
                                let _e978 = (_e976 - (((_e930 * _e933) + (_e942 * _e945)) + ((_e955 * _e958) + (_e967 * _e970))));
                                let _e982 = local.member[1u][2u];
                                let _e985 = local.member_1[2u];
                                let _e990 = local.member[2u][2u];
                                let _e993 = local.member_1[1u];
                                let _e995 = ((_e982 * _e985) - (_e990 * _e993));
                                let _e999 = local.member[2u][2u];
                                if (_e999 < 0f) {
                                    phi_1457_ = -(_e999);
                                } else {
                                    phi_1457_ = _e999;
                                }
                                let _e1003 = phi_1457_;
                                let _e1006 = local.member_3[1u];
                                let _e1011 = local.member[1u][2u];
                                if (_e1011 < 0f) {
                                    phi_1480_ = -(_e1011);
                                } else {
                                    phi_1480_ = _e1011;
                                }
                                let _e1015 = phi_1480_;
                                let _e1018 = local.member_3[2u];
                                let _e1024 = local.member[0u][1u];
                                if (_e1024 < 0f) {
                                    phi_1503_ = -(_e1024);
                                } else {
                                    phi_1503_ = _e1024;
                                }
                                let _e1028 = phi_1503_;
                                let _e1031 = local.member_4[0u];
                                let _e1036 = local.member[0u][0u];
                                if (_e1036 < 0f) {
                                    phi_1525_ = -(_e1036);
                                } else {
                                    phi_1525_ = _e1036;
                                }
                                let _e1040 = phi_1525_;
                                let _e1043 = local.member_4[1u];
                                if (_e995 < 0f) {
                                    phi_1541_ = -(_e995);
                                } else {
                                    phi_1541_ = _e995;
                                }
                                let _e1049 = phi_1541_;
                                let _e1051 = (_e1049 - (((_e1003 * _e1006) + (_e1015 * _e1018)) + ((_e1028 * _e1031) + (_e1040 * _e1043))));
                                let _e1055 = local.member[2u][0u];
                                let _e1058 = local.member_1[0u];
                                let _e1063 = local.member[0u][0u];
                                let _e1066 = local.member_1[2u];
                                let _e1068 = ((_e1055 * _e1058) - (_e1063 * _e1066));
                                let _e1072 = local.member[0u][0u];
                                if (_e1072 < 0f) {
                                    phi_1596_ = -(_e1072);
                                } else {
                                    phi_1596_ = _e1072;
                                }
                                let _e1076 = phi_1596_;
                                let _e1079 = local.member_3[2u];
                                let _e1084 = local.member[2u][0u];
                                if (_e1084 < 0f) {
                                    phi_1619_ = -(_e1084);
                                } else {
                                    phi_1619_ = _e1084;
                                }
                                let _e1088 = phi_1619_;
                                let _e1091 = local.member_3[0u];
                                let _e1097 = local.member[1u][2u];
                                if (_e1097 < 0f) {
                                    phi_1643_ = -(_e1097);
                                } else {
                                    phi_1643_ = _e1097;
                                }
                                let _e1101 = phi_1643_;
                                let _e1104 = local.member_4[1u];
                                let _e1109 = local.member[1u][1u];
                                if (_e1109 < 0f) {
                                    phi_1666_ = -(_e1109);
                                } else {
                                    phi_1666_ = _e1109;
                                }
                                let _e1113 = phi_1666_;
                                let _e1116 = local.member_4[2u];
                                if (_e1068 < 0f) {
                                    phi_1682_ = -(_e1068);
                                } else {
                                    phi_1682_ = _e1068;
                                }
                                let _e1122 = phi_1682_;
                                let _e1124 = (_e1122 - (((_e1076 * _e1079) + (_e1088 * _e1091)) + ((_e1101 * _e1104) + (_e1113 * _e1116))));
                                let _e1128 = local.member[2u][1u];
                                let _e1131 = local.member_1[0u];
                                let _e1136 = local.member[0u][1u];
                                let _e1139 = local.member_1[2u];
                                let _e1141 = ((_e1128 * _e1131) - (_e1136 * _e1139));
                                let _e1145 = local.member[0u][1u];
                                if (_e1145 < 0f) {
                                    phi_1737_ = -(_e1145);
                                } else {
                                    phi_1737_ = _e1145;
                                }
                                let _e1149 = phi_1737_;
                                let _e1152 = local.member_3[2u];
                                let _e1157 = local.member[2u][1u];
                                if (_e1157 < 0f) {
                                    phi_1760_ = -(_e1157);
                                } else {
                                    phi_1760_ = _e1157;
                                }
                                let _e1161 = phi_1760_;
                                let _e1164 = local.member_3[0u];
                                let _e1170 = local.member[1u][0u];
                                if (_e1170 < 0f) {
                                    phi_1784_ = -(_e1170);
                                } else {
                                    phi_1784_ = _e1170;
                                }
                                let _e1174 = phi_1784_;
                                let _e1177 = local.member_4[2u];
                                let _e1182 = local.member[1u][2u];
                                if (_e1182 < 0f) {
                                    phi_1807_ = -(_e1182);
                                } else {
                                    phi_1807_ = _e1182;
                                }
                                let _e1186 = phi_1807_;
                                let _e1189 = local.member_4[0u];
                                if (_e1141 < 0f) {
                                    phi_1823_ = -(_e1141);
                                } else {
                                    phi_1823_ = _e1141;
                                }
                                let _e1195 = phi_1823_;
                                let _e1197 = (_e1195 - (((_e1149 * _e1152) + (_e1161 * _e1164)) + ((_e1174 * _e1177) + (_e1186 * _e1189))));
                                let _e1201 = local.member[2u][2u];
                                let _e1204 = local.member_1[0u];
                                let _e1209 = local.member[0u][2u];
                                let _e1212 = local.member_1[2u];
                                let _e1214 = ((_e1201 * _e1204) - (_e1209 * _e1212));
                                let _e1218 = local.member[0u][2u];
                                if (_e1218 < 0f) {
                                    phi_1878_ = -(_e1218);
                                } else {
                                    phi_1878_ = _e1218;
                                }
                                let _e1222 = phi_1878_;
                                let _e1225 = local.member_3[2u];
                                let _e1230 = local.member[2u][2u];
                                if (_e1230 < 0f) {
                                    phi_1901_ = -(_e1230);
                                } else {
                                    phi_1901_ = _e1230;
                                }
                                let _e1234 = phi_1901_;
                                let _e1237 = local.member_3[0u];
                                let _e1243 = local.member[1u][1u];
                                if (_e1243 < 0f) {
                                    phi_1925_ = -(_e1243);
                                } else {
                                    phi_1925_ = _e1243;
                                }
                                let _e1247 = phi_1925_;
                                let _e1250 = local.member_4[0u];
                                let _e1255 = local.member[1u][0u];
                                if (_e1255 < 0f) {
                                    phi_1948_ = -(_e1255);
                                } else {
                                    phi_1948_ = _e1255;
                                }
                                let _e1259 = phi_1948_;
                                let _e1262 = local.member_4[1u];
                                if (_e1214 < 0f) {
                                    phi_1964_ = -(_e1214);
                                } else {
                                    phi_1964_ = _e1214;
                                }
                                let _e1268 = phi_1964_;
                                let _e1270 = (_e1268 - (((_e1222 * _e1225) + (_e1234 * _e1237)) + ((_e1247 * _e1250) + (_e1259 * _e1262))));
                                let _e1274 = local.member[0u][0u];
                                let _e1277 = local.member_1[1u];
                                let _e1282 = local.member[1u][0u];
                                let _e1285 = local.member_1[0u];
                                let _e1287 = ((_e1274 * _e1277) - (_e1282 * _e1285));
                                let _e1291 = local.member[1u][0u];
                                if (_e1291 < 0f) {
                                    phi_2019_ = -(_e1291);
                                } else {
                                    phi_2019_ = _e1291;
                                }
                                let _e1295 = phi_2019_;
                                let _e1298 = local.member_3[0u];
                                let _e1303 = local.member[0u][0u];
                                if (_e1303 < 0f) {
                                    phi_2042_ = -(_e1303);
                                } else {
                                    phi_2042_ = _e1303;
                                }
                                let _e1307 = phi_2042_;
                                let _e1310 = local.member_3[1u];
                                let _e1316 = local.member[2u][2u];
                                if (_e1316 < 0f) {
                                    phi_2066_ = -(_e1316);
                                } else {
                                    phi_2066_ = _e1316;
                                }
                                let _e1320 = phi_2066_;
                                let _e1323 = local.member_4[1u];
                                let _e1328 = local.member[2u][1u];
                                if (_e1328 < 0f) {
                                    phi_2089_ = -(_e1328);
                                } else {
                                    phi_2089_ = _e1328;
                                }
                                let _e1332 = phi_2089_;
                                let _e1335 = local.member_4[2u];
                                if (_e1287 < 0f) {
                                    phi_2105_ = -(_e1287);
                                } else {
                                    phi_2105_ = _e1287;
                                }
                                let _e1341 = phi_2105_;
                                let _e1343 = (_e1341 - (((_e1295 * _e1298) + (_e1307 * _e1310)) + ((_e1320 * _e1323) + (_e1332 * _e1335))));
                                let _e1347 = local.member[0u][1u];
                                let _e1350 = local.member_1[1u];
                                let _e1355 = local.member[1u][1u];
                                let _e1358 = local.member_1[0u];
                                let _e1360 = ((_e1347 * _e1350) - (_e1355 * _e1358));
                                let _e1364 = local.member[1u][1u];
                                if (_e1364 < 0f) {
                                    phi_2160_ = -(_e1364);
                                } else {
                                    phi_2160_ = _e1364;
                                }
                                let _e1368 = phi_2160_;
                                let _e1371 = local.member_3[0u];
                                let _e1376 = local.member[0u][1u];
                                if (_e1376 < 0f) {
                                    phi_2183_ = -(_e1376);
                                } else {
                                    phi_2183_ = _e1376;
                                }
                                let _e1380 = phi_2183_;
                                let _e1383 = local.member_3[1u];
                                let _e1389 = local.member[2u][0u];
                                if (_e1389 < 0f) {
                                    phi_2207_ = -(_e1389);
                                } else {
                                    phi_2207_ = _e1389;
                                }
                                let _e1393 = phi_2207_;
                                let _e1396 = local.member_4[2u];
                                let _e1401 = local.member[2u][2u];
                                if (_e1401 < 0f) {
                                    phi_2230_ = -(_e1401);
                                } else {
                                    phi_2230_ = _e1401;
                                }
                                let _e1405 = phi_2230_;
                                let _e1408 = local.member_4[0u];
                                if (_e1360 < 0f) {
                                    phi_2246_ = -(_e1360);
                                } else {
                                    phi_2246_ = _e1360;
                                }
                                let _e1414 = phi_2246_;
                                let _e1416 = (_e1414 - (((_e1368 * _e1371) + (_e1380 * _e1383)) + ((_e1393 * _e1396) + (_e1405 * _e1408))));
                                let _e1420 = local.member[0u][2u];
                                let _e1423 = local.member_1[1u];
                                let _e1428 = local.member[1u][2u];
                                let _e1431 = local.member_1[0u];
                                let _e1433 = ((_e1420 * _e1423) - (_e1428 * _e1431));
                                let _e1437 = local.member[1u][2u];
                                if (_e1437 < 0f) {
                                    phi_2301_ = -(_e1437);
                                } else {
                                    phi_2301_ = _e1437;
                                }
                                let _e1441 = phi_2301_;
                                let _e1444 = local.member_3[0u];
                                let _e1449 = local.member[0u][2u];
                                if (_e1449 < 0f) {
                                    phi_2324_ = -(_e1449);
                                } else {
                                    phi_2324_ = _e1449;
                                }
                                let _e1453 = phi_2324_;
                                let _e1456 = local.member_3[1u];
                                let _e1462 = local.member[2u][1u];
                                if (_e1462 < 0f) {
                                    phi_2348_ = -(_e1462);
                                } else {
                                    phi_2348_ = _e1462;
                                }
                                let _e1466 = phi_2348_;
                                let _e1469 = local.member_4[0u];
                                let _e1474 = local.member[2u][0u];
                                if (_e1474 < 0f) {
                                    phi_2371_ = -(_e1474);
                                } else {
                                    phi_2371_ = _e1474;
                                }
                                let _e1478 = phi_2371_;
                                let _e1481 = local.member_4[1u];
                                if (_e1433 < 0f) {
                                    phi_2387_ = -(_e1433);
                                } else {
                                    phi_2387_ = _e1433;
                                }
                                let _e1487 = phi_2387_;
                                let _e1489 = (_e1487 - (((_e1441 * _e1444) + (_e1453 * _e1456)) + ((_e1466 * _e1469) + (_e1478 * _e1481))));
                                if (_e905 > _e978) {
                                    phi_2394_ = _e905;
                                } else {
                                    phi_2394_ = _e978;
                                }
                                let _e1492 = phi_2394_;
                                if (_e1492 > _e1051) {
                                    phi_2399_ = _e1492;
                                } else {
                                    phi_2399_ = _e1051;
                                }
                                let _e1495 = phi_2399_;
                                if (_e1124 > _e1197) {
                                    phi_2404_ = _e1124;
                                } else {
                                    phi_2404_ = _e1197;
                                }
                                let _e1498 = phi_2404_;
                                if (_e1498 > _e1270) {
                                    phi_2409_ = _e1498;
                                } else {
                                    phi_2409_ = _e1270;
                                }
                                let _e1501 = phi_2409_;
                                if (_e1495 > _e1501) {
                                    phi_2414_ = _e1495;
                                } else {
                                    phi_2414_ = _e1501;
                                }
                                let _e1504 = phi_2414_;
                                if (_e1343 > _e1416) {
                                    phi_2419_ = _e1343;
                                } else {
                                    phi_2419_ = _e1416;
                                }
                                let _e1507 = phi_2419_;
                                if (_e1507 > _e1489) {
                                    phi_2424_ = _e1507;
                                } else {
                                    phi_2424_ = _e1489;
                                }
                                let _e1510 = phi_2424_;
                                if (_e1504 > _e1510) {
                                    phi_2429_ = _e1504;
                                } else {
                                    phi_2429_ = _e1510;
                                }
                                let _e1513 = phi_2429_;
                                let _e1515 = local.member_5;
                                phi_2433_ = (_e1513 > _e1515);
                            }
                            let _e1518 = phi_2433_;
                            phi_2435_ = !(_e1518);
                            phi_2436_ = false;
                        } else {
                            phi_2435_ = bool();
                            phi_2436_ = true;
                        }
                        let _e1521 = phi_2435_;
                        let _e1523 = phi_2436_;
                        phi_2437_ = _e1521;
                        phi_2438_ = _e1523;
                    }
                    let _e1525 = phi_2437_;
                    let _e1527 = phi_2438_;
                    if _e1527 {
                        phi_2442_ = true;
                    } else {
                        phi_2442_ = _e1525;
                    }
                    let _e1529 = phi_2442_;
                    if _e1529 {
                        let _e1531 = atomicAdd((&levels.member[0u]), 1u);
                        let _e1534 = atomicMax((&output.member[0u]), (_e1531 + 1u));
                        if ((_e1531 + 1u) < _e1531) {
                            let _e1538 = atomicAdd((&output.member[2u]), 1u);
                        }
                        let _e1541 = params.member.member_2.member_3;
                        if (_e1531 < _e1541) {
                            let _e1543 = (2u * _e1531);
                            atomicStore((&output.member[(4u + _e1543)]), _e70);
                            atomicStore((&output.member[(_e1543 + 5u)]), _e73);
                        }
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
