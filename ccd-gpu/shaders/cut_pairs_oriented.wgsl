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
    var phi_424_: f32;
    var phi_430_: f32;
    var phi_436_: f32;
    var phi_442_: f32;
    var phi_448_: f32;
    var phi_454_: f32;
    var phi_472_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_498_: type_25;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_598_: f32;
    var phi_616_: f32;
    var phi_621_: f32;
    var phi_626_: f32;
    var phi_642_: type_25;
    var phi_832_: f32;
    var phi_838_: f32;
    var phi_845_: f32;
    var phi_854_: f32;
    var phi_861_: f32;
    var phi_869_: f32;
    var phi_878_: f32;
    var phi_885_: f32;
    var phi_893_: f32;
    var phi_986_: f32;
    var phi_993_: f32;
    var phi_999_: f32;
    var phi_1005_: f32;
    var phi_1024_: f32;
    var phi_1031_: f32;
    var phi_1037_: f32;
    var phi_1043_: f32;
    var phi_1062_: f32;
    var phi_1069_: f32;
    var phi_1075_: f32;
    var phi_1081_: f32;
    var phi_1100_: f32;
    var phi_1107_: f32;
    var phi_1113_: f32;
    var phi_1119_: f32;
    var phi_1138_: f32;
    var phi_1145_: f32;
    var phi_1151_: f32;
    var phi_1157_: f32;
    var phi_1176_: f32;
    var phi_1183_: f32;
    var phi_1189_: f32;
    var phi_1195_: f32;
    var phi_1210_: f32;
    var phi_1215_: f32;
    var phi_1220_: f32;
    var phi_1225_: f32;
    var phi_1230_: f32;
    var phi_1289_: f32;
    var phi_1312_: f32;
    var phi_1335_: f32;
    var phi_1357_: f32;
    var phi_1373_: f32;
    var phi_1428_: f32;
    var phi_1451_: f32;
    var phi_1474_: f32;
    var phi_1496_: f32;
    var phi_1512_: f32;
    var phi_1567_: f32;
    var phi_1590_: f32;
    var phi_1613_: f32;
    var phi_1635_: f32;
    var phi_1651_: f32;
    var phi_1706_: f32;
    var phi_1729_: f32;
    var phi_1753_: f32;
    var phi_1776_: f32;
    var phi_1792_: f32;
    var phi_1847_: f32;
    var phi_1870_: f32;
    var phi_1894_: f32;
    var phi_1917_: f32;
    var phi_1933_: f32;
    var phi_1988_: f32;
    var phi_2011_: f32;
    var phi_2035_: f32;
    var phi_2058_: f32;
    var phi_2074_: f32;
    var phi_2129_: f32;
    var phi_2152_: f32;
    var phi_2176_: f32;
    var phi_2199_: f32;
    var phi_2215_: f32;
    var phi_2270_: f32;
    var phi_2293_: f32;
    var phi_2317_: f32;
    var phi_2340_: f32;
    var phi_2356_: f32;
    var phi_2411_: f32;
    var phi_2434_: f32;
    var phi_2458_: f32;
    var phi_2481_: f32;
    var phi_2497_: f32;
    var phi_2504_: f32;
    var phi_2509_: f32;
    var phi_2514_: f32;
    var phi_2519_: f32;
    var phi_2524_: f32;
    var phi_2529_: f32;
    var phi_2534_: f32;
    var phi_2539_: f32;
    var phi_2543_: bool;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2547_: bool;
    var phi_2548_: bool;
    var phi_2552_: bool;
    var phi_2553_: bool;
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
                    phi_2547_ = bool();
                    phi_2548_ = true;
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
                            let _e260 = oriented.member[(_e123 + _e93[0])];
                            phi_498_ = type_25(array<f32, 3>(_e260.member.x, _e260.member.y, _e260.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e260.member.w, _e260.member_1.x, _e260.member_1.y), array<f32, 3>(_e260.member_1.z, _e260.member_1.w, _e260.member_2.x), array<f32, 3>(_e260.member_2.y, _e260.member_2.z, _e260.member_2.w)), array<f32, 3>(_e260.member_3.x, _e260.member_3.y, _e260.member_3.z));
                        } else {
                            let _e183 = a_nodes.member[_e93[0]];
                            let _e198 = ((_e183.member[0] * 0.5f) + (_e183.member_2[0] * 0.5f));
                            let _e199 = ((_e183.member[1] * 0.5f) + (_e183.member_2[1] * 0.5f));
                            let _e200 = ((_e183.member[2] * 0.5f) + (_e183.member_2[2] * 0.5f));
                            if (_e198 < _e183.member_2[0]) {
                                phi_424_ = _e198;
                            } else {
                                phi_424_ = _e183.member_2[0];
                            }
                            let _e204 = phi_424_;
                            if (_e199 < _e183.member_2[1]) {
                                phi_430_ = _e199;
                            } else {
                                phi_430_ = _e183.member_2[1];
                            }
                            let _e208 = phi_430_;
                            if (_e200 < _e183.member_2[2]) {
                                phi_436_ = _e200;
                            } else {
                                phi_436_ = _e183.member_2[2];
                            }
                            let _e212 = phi_436_;
                            if (_e204 > _e183.member[0]) {
                                phi_442_ = _e204;
                            } else {
                                phi_442_ = _e183.member[0];
                            }
                            let _e216 = phi_442_;
                            if (_e208 > _e183.member[1]) {
                                phi_448_ = _e208;
                            } else {
                                phi_448_ = _e183.member[1];
                            }
                            let _e220 = phi_448_;
                            if (_e212 > _e183.member[2]) {
                                phi_454_ = _e212;
                            } else {
                                phi_454_ = _e183.member[2];
                            }
                            let _e224 = phi_454_;
                            let _e227 = (_e183.member_2[0] - _e216);
                            let _e229 = (_e183.member_2[1] - _e220);
                            let _e231 = (_e183.member_2[2] - _e224);
                            let _e233 = (_e216 - _e183.member[0]);
                            let _e235 = (_e220 - _e183.member[1]);
                            let _e237 = (_e224 - _e183.member[2]);
                            if (_e227 > _e233) {
                                phi_472_ = _e227;
                            } else {
                                phi_472_ = _e233;
                            }
                            let _e240 = phi_472_;
                            if (_e229 > _e235) {
                                phi_477_ = _e229;
                            } else {
                                phi_477_ = _e235;
                            }
                            let _e243 = phi_477_;
                            if (_e231 > _e237) {
                                phi_482_ = _e231;
                            } else {
                                phi_482_ = _e237;
                            }
                            let _e246 = phi_482_;
                            let _e248 = (1f + (0.000000059604645f * 4f));
                            let _e252 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_498_ = type_25(array<f32, 3>(_e216, _e220, _e224), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e240 * _e248) + _e252), ((_e243 * _e248) + _e252), ((_e246 * _e248) + _e252)));
                        }
                        let _e299 = phi_498_;
                        if (_e93[1] < _e119) {
                            let _e379 = oriented.member[(_e127 + _e93[1])];
                            phi_642_ = type_25(array<f32, 3>(_e379.member.x, _e379.member.y, _e379.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e379.member.w, _e379.member_1.x, _e379.member_1.y), array<f32, 3>(_e379.member_1.z, _e379.member_1.w, _e379.member_2.x), array<f32, 3>(_e379.member_2.y, _e379.member_2.z, _e379.member_2.w)), array<f32, 3>(_e379.member_3.x, _e379.member_3.y, _e379.member_3.z));
                        } else {
                            let _e302 = b_nodes.member[_e93[1]];
                            let _e317 = ((_e302.member[0] * 0.5f) + (_e302.member_2[0] * 0.5f));
                            let _e318 = ((_e302.member[1] * 0.5f) + (_e302.member_2[1] * 0.5f));
                            let _e319 = ((_e302.member[2] * 0.5f) + (_e302.member_2[2] * 0.5f));
                            if (_e317 < _e302.member_2[0]) {
                                phi_568_ = _e317;
                            } else {
                                phi_568_ = _e302.member_2[0];
                            }
                            let _e323 = phi_568_;
                            if (_e318 < _e302.member_2[1]) {
                                phi_574_ = _e318;
                            } else {
                                phi_574_ = _e302.member_2[1];
                            }
                            let _e327 = phi_574_;
                            if (_e319 < _e302.member_2[2]) {
                                phi_580_ = _e319;
                            } else {
                                phi_580_ = _e302.member_2[2];
                            }
                            let _e331 = phi_580_;
                            if (_e323 > _e302.member[0]) {
                                phi_586_ = _e323;
                            } else {
                                phi_586_ = _e302.member[0];
                            }
                            let _e335 = phi_586_;
                            if (_e327 > _e302.member[1]) {
                                phi_592_ = _e327;
                            } else {
                                phi_592_ = _e302.member[1];
                            }
                            let _e339 = phi_592_;
                            if (_e331 > _e302.member[2]) {
                                phi_598_ = _e331;
                            } else {
                                phi_598_ = _e302.member[2];
                            }
                            let _e343 = phi_598_;
                            let _e346 = (_e302.member_2[0] - _e335);
                            let _e348 = (_e302.member_2[1] - _e339);
                            let _e350 = (_e302.member_2[2] - _e343);
                            let _e352 = (_e335 - _e302.member[0]);
                            let _e354 = (_e339 - _e302.member[1]);
                            let _e356 = (_e343 - _e302.member[2]);
                            if (_e346 > _e352) {
                                phi_616_ = _e346;
                            } else {
                                phi_616_ = _e352;
                            }
                            let _e359 = phi_616_;
                            if (_e348 > _e354) {
                                phi_621_ = _e348;
                            } else {
                                phi_621_ = _e354;
                            }
                            let _e362 = phi_621_;
                            if (_e350 > _e356) {
                                phi_626_ = _e350;
                            } else {
                                phi_626_ = _e356;
                            }
                            let _e365 = phi_626_;
                            let _e367 = (1f + (0.000000059604645f * 4f));
                            let _e371 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_642_ = type_25(array<f32, 3>(_e335, _e339, _e343), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e359 * _e367) + _e371), ((_e362 * _e367) + _e371), ((_e365 * _e367) + _e371)));
                        }
                        let _e418 = phi_642_;
                        let _e423 = (_e418.member[0] - _e299.member[0]);
                        let _e426 = (_e418.member[1] - _e299.member[1]);
                        let _e429 = (_e418.member[2] - _e299.member[2]);
                        if (_e423 < 0f) {
                            phi_832_ = -(_e423);
                        } else {
                            phi_832_ = _e423;
                        }
                        let _e618 = phi_832_;
                        if (_e426 < 0f) {
                            phi_838_ = -(_e426);
                        } else {
                            phi_838_ = _e426;
                        }
                        let _e622 = phi_838_;
                        if (_e429 < 0f) {
                            phi_845_ = -(_e429);
                        } else {
                            phi_845_ = _e429;
                        }
                        let _e627 = phi_845_;
                        if (_e299.member_2[0] < 0f) {
                            phi_854_ = -(_e299.member_2[0]);
                        } else {
                            phi_854_ = _e299.member_2[0];
                        }
                        let _e634 = phi_854_;
                        if (_e299.member_2[1] < 0f) {
                            phi_861_ = -(_e299.member_2[1]);
                        } else {
                            phi_861_ = _e299.member_2[1];
                        }
                        let _e639 = phi_861_;
                        if (_e299.member_2[2] < 0f) {
                            phi_869_ = -(_e299.member_2[2]);
                        } else {
                            phi_869_ = _e299.member_2[2];
                        }
                        let _e645 = phi_869_;
                        if (_e418.member_2[0] < 0f) {
                            phi_878_ = -(_e418.member_2[0]);
                        } else {
                            phi_878_ = _e418.member_2[0];
                        }
                        let _e652 = phi_878_;
                        if (_e418.member_2[1] < 0f) {
                            phi_885_ = -(_e418.member_2[1]);
                        } else {
                            phi_885_ = _e418.member_2[1];
                        }
                        let _e657 = phi_885_;
                        if (_e418.member_2[2] < 0f) {
                            phi_893_ = -(_e418.member_2[2]);
                        } else {
                            phi_893_ = _e418.member_2[2];
                        }
                        let _e663 = phi_893_;
                        local = type_20(array<array<f32, 3>, 3>(array<f32, 3>((((_e418.member_1[0][0] * _e299.member_1[0][0]) + (_e418.member_1[0][1] * _e299.member_1[0][1])) + (_e418.member_1[0][2] * _e299.member_1[0][2])), (((_e418.member_1[1][0] * _e299.member_1[0][0]) + (_e418.member_1[1][1] * _e299.member_1[0][1])) + (_e418.member_1[1][2] * _e299.member_1[0][2])), (((_e418.member_1[2][0] * _e299.member_1[0][0]) + (_e418.member_1[2][1] * _e299.member_1[0][1])) + (_e418.member_1[2][2] * _e299.member_1[0][2]))), array<f32, 3>((((_e418.member_1[0][0] * _e299.member_1[1][0]) + (_e418.member_1[0][1] * _e299.member_1[1][1])) + (_e418.member_1[0][2] * _e299.member_1[1][2])), (((_e418.member_1[1][0] * _e299.member_1[1][0]) + (_e418.member_1[1][1] * _e299.member_1[1][1])) + (_e418.member_1[1][2] * _e299.member_1[1][2])), (((_e418.member_1[2][0] * _e299.member_1[1][0]) + (_e418.member_1[2][1] * _e299.member_1[1][1])) + (_e418.member_1[2][2] * _e299.member_1[1][2]))), array<f32, 3>((((_e418.member_1[0][0] * _e299.member_1[2][0]) + (_e418.member_1[0][1] * _e299.member_1[2][1])) + (_e418.member_1[0][2] * _e299.member_1[2][2])), (((_e418.member_1[1][0] * _e299.member_1[2][0]) + (_e418.member_1[1][1] * _e299.member_1[2][1])) + (_e418.member_1[1][2] * _e299.member_1[2][2])), (((_e418.member_1[2][0] * _e299.member_1[2][0]) + (_e418.member_1[2][1] * _e299.member_1[2][1])) + (_e418.member_1[2][2] * _e299.member_1[2][2])))), array<f32, 3>((((_e299.member_1[0][0] * _e423) + (_e299.member_1[0][1] * _e426)) + (_e299.member_1[0][2] * _e429)), (((_e299.member_1[1][0] * _e423) + (_e299.member_1[1][1] * _e426)) + (_e299.member_1[1][2] * _e429)), (((_e299.member_1[2][0] * _e423) + (_e299.member_1[2][1] * _e426)) + (_e299.member_1[2][2] * _e429))), array<f32, 3>((((_e418.member_1[0][0] * _e423) + (_e418.member_1[0][1] * _e426)) + (_e418.member_1[0][2] * _e429)), (((_e418.member_1[1][0] * _e423) + (_e418.member_1[1][1] * _e426)) + (_e418.member_1[1][2] * _e429)), (((_e418.member_1[2][0] * _e423) + (_e418.member_1[2][1] * _e426)) + (_e418.member_1[2][2] * _e429))), array<f32, 3>(_e299.member_2[0], _e299.member_2[1], _e299.member_2[2]), array<f32, 3>(_e418.member_2[0], _e418.member_2[1], _e418.member_2[2]), ((((((_e618 + _e622) + _e627) + (((_e634 + _e639) + _e645) + ((_e652 + _e657) + _e663))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                        let _e690 = local.member[0u][0u];
                        let _e694 = local.member[0u][1u];
                        let _e698 = local.member[0u][2u];
                        let _e702 = local.member[1u][0u];
                        let _e706 = local.member[1u][1u];
                        let _e710 = local.member[1u][2u];
                        let _e714 = local.member[2u][0u];
                        let _e718 = local.member[2u][1u];
                        let _e722 = local.member[2u][2u];
                        let _e724 = local.member_3;
                        let _e729 = local.member_4;
                        let _e735 = local.member_1[0u];
                        if (_e735 < 0f) {
                            phi_986_ = -(_e735);
                        } else {
                            phi_986_ = _e735;
                        }
                        let _e739 = phi_986_;
                        if (_e690 < 0f) {
                            phi_993_ = -(_e690);
                        } else {
                            phi_993_ = _e690;
                        }
                        let _e743 = phi_993_;
                        if (_e694 < 0f) {
                            phi_999_ = -(_e694);
                        } else {
                            phi_999_ = _e694;
                        }
                        let _e747 = phi_999_;
                        if (_e698 < 0f) {
                            phi_1005_ = -(_e698);
                        } else {
                            phi_1005_ = _e698;
                        }
                        let _e751 = phi_1005_;
                        let _e758 = (_e739 - (_e724[0] + (((_e743 * _e729[0]) + (_e747 * _e729[1])) + (_e751 * _e729[2]))));
                        let _e761 = local.member_1[1u];
                        if (_e761 < 0f) {
                            phi_1024_ = -(_e761);
                        } else {
                            phi_1024_ = _e761;
                        }
                        let _e765 = phi_1024_;
                        if (_e702 < 0f) {
                            phi_1031_ = -(_e702);
                        } else {
                            phi_1031_ = _e702;
                        }
                        let _e769 = phi_1031_;
                        if (_e706 < 0f) {
                            phi_1037_ = -(_e706);
                        } else {
                            phi_1037_ = _e706;
                        }
                        let _e773 = phi_1037_;
                        if (_e710 < 0f) {
                            phi_1043_ = -(_e710);
                        } else {
                            phi_1043_ = _e710;
                        }
                        let _e777 = phi_1043_;
                        let _e784 = (_e765 - (_e724[1] + (((_e769 * _e729[0]) + (_e773 * _e729[1])) + (_e777 * _e729[2]))));
                        let _e787 = local.member_1[2u];
                        if (_e787 < 0f) {
                            phi_1062_ = -(_e787);
                        } else {
                            phi_1062_ = _e787;
                        }
                        let _e791 = phi_1062_;
                        if (_e714 < 0f) {
                            phi_1069_ = -(_e714);
                        } else {
                            phi_1069_ = _e714;
                        }
                        let _e795 = phi_1069_;
                        if (_e718 < 0f) {
                            phi_1075_ = -(_e718);
                        } else {
                            phi_1075_ = _e718;
                        }
                        let _e799 = phi_1075_;
                        if (_e722 < 0f) {
                            phi_1081_ = -(_e722);
                        } else {
                            phi_1081_ = _e722;
                        }
                        let _e803 = phi_1081_;
                        let _e810 = (_e791 - (_e724[2] + (((_e795 * _e729[0]) + (_e799 * _e729[1])) + (_e803 * _e729[2]))));
                        let _e813 = local.member_2[0u];
                        if (_e813 < 0f) {
                            phi_1100_ = -(_e813);
                        } else {
                            phi_1100_ = _e813;
                        }
                        let _e817 = phi_1100_;
                        if (_e690 < 0f) {
                            phi_1107_ = -(_e690);
                        } else {
                            phi_1107_ = _e690;
                        }
                        let _e821 = phi_1107_;
                        if (_e702 < 0f) {
                            phi_1113_ = -(_e702);
                        } else {
                            phi_1113_ = _e702;
                        }
                        let _e825 = phi_1113_;
                        if (_e714 < 0f) {
                            phi_1119_ = -(_e714);
                        } else {
                            phi_1119_ = _e714;
                        }
                        let _e829 = phi_1119_;
                        let _e836 = (_e817 - (_e729[0] + (((_e821 * _e724[0]) + (_e825 * _e724[1])) + (_e829 * _e724[2]))));
                        let _e839 = local.member_2[1u];
                        if (_e839 < 0f) {
                            phi_1138_ = -(_e839);
                        } else {
                            phi_1138_ = _e839;
                        }
                        let _e843 = phi_1138_;
                        if (_e694 < 0f) {
                            phi_1145_ = -(_e694);
                        } else {
                            phi_1145_ = _e694;
                        }
                        let _e847 = phi_1145_;
                        if (_e706 < 0f) {
                            phi_1151_ = -(_e706);
                        } else {
                            phi_1151_ = _e706;
                        }
                        let _e851 = phi_1151_;
                        if (_e718 < 0f) {
                            phi_1157_ = -(_e718);
                        } else {
                            phi_1157_ = _e718;
                        }
                        let _e855 = phi_1157_;
                        let _e862 = (_e843 - (_e729[1] + (((_e847 * _e724[0]) + (_e851 * _e724[1])) + (_e855 * _e724[2]))));
                        let _e865 = local.member_2[2u];
                        if (_e865 < 0f) {
                            phi_1176_ = -(_e865);
                        } else {
                            phi_1176_ = _e865;
                        }
                        let _e869 = phi_1176_;
                        if (_e698 < 0f) {
                            phi_1183_ = -(_e698);
                        } else {
                            phi_1183_ = _e698;
                        }
                        let _e873 = phi_1183_;
                        if (_e710 < 0f) {
                            phi_1189_ = -(_e710);
                        } else {
                            phi_1189_ = _e710;
                        }
                        let _e877 = phi_1189_;
                        if (_e722 < 0f) {
                            phi_1195_ = -(_e722);
                        } else {
                            phi_1195_ = _e722;
                        }
                        let _e881 = phi_1195_;
                        let _e888 = (_e869 - (_e729[2] + (((_e873 * _e724[0]) + (_e877 * _e724[1])) + (_e881 * _e724[2]))));
                        if (_e758 > _e784) {
                            phi_1210_ = _e758;
                        } else {
                            phi_1210_ = _e784;
                        }
                        let _e891 = phi_1210_;
                        if (_e891 > _e810) {
                            phi_1215_ = _e891;
                        } else {
                            phi_1215_ = _e810;
                        }
                        let _e894 = phi_1215_;
                        if (_e836 > _e862) {
                            phi_1220_ = _e836;
                        } else {
                            phi_1220_ = _e862;
                        }
                        let _e897 = phi_1220_;
                        if (_e897 > _e888) {
                            phi_1225_ = _e897;
                        } else {
                            phi_1225_ = _e888;
                        }
                        let _e900 = phi_1225_;
                        if (_e894 > _e900) {
                            phi_1230_ = _e894;
                        } else {
                            phi_1230_ = _e900;
                        }
                        let _e903 = phi_1230_;
                        let _e905 = local.member_5;
                        if (_e903 > _e905) {
                            phi_2543_ = true;
                        } else {
                            let _e910 = local.member[1u][0u];
                            let _e913 = local.member_1[2u];
                            let _e918 = local.member[2u][0u];
                            let _e921 = local.member_1[1u];
                            let _e923 = ((_e910 * _e913) - (_e918 * _e921));
                            let _e927 = local.member[2u][0u];
                            if (_e927 < 0f) {
                                phi_1289_ = -(_e927);
                            } else {
                                phi_1289_ = _e927;
                            }
                            let _e931 = phi_1289_;
                            let _e934 = local.member_3[1u];
                            let _e939 = local.member[1u][0u];
                            if (_e939 < 0f) {
                                phi_1312_ = -(_e939);
                            } else {
                                phi_1312_ = _e939;
                            }
                            let _e943 = phi_1312_;
                            let _e946 = local.member_3[2u];
                            let _e952 = local.member[0u][2u];
                            if (_e952 < 0f) {
                                phi_1335_ = -(_e952);
                            } else {
                                phi_1335_ = _e952;
                            }
                            let _e956 = phi_1335_;
                            let _e959 = local.member_4[1u];
                            let _e964 = local.member[0u][1u];
                            if (_e964 < 0f) {
                                phi_1357_ = -(_e964);
                            } else {
                                phi_1357_ = _e964;
                            }
                            let _e968 = phi_1357_;
                            let _e971 = local.member_4[2u];
                            if (_e923 < 0f) {
                                phi_1373_ = -(_e923);
                            } else {
                                phi_1373_ = _e923;
                            }
                            let _e977 = phi_1373_;
                            let _e979 = (_e977 - (((_e931 * _e934) + (_e943 * _e946)) + ((_e956 * _e959) + (_e968 * _e971))));
                            let _e983 = local.member[1u][1u];
                            let _e986 = local.member_1[2u];
                            let _e991 = local.member[2u][1u];
                            let _e994 = local.member_1[1u];
                            let _e996 = ((_e983 * _e986) - (_e991 * _e994));
                            let _e1000 = local.member[2u][1u];
                            if (_e1000 < 0f) {
                                phi_1428_ = -(_e1000);
                            } else {
                                phi_1428_ = _e1000;
                            }
                            let _e1004 = phi_1428_;
                            let _e1007 = local.member_3[1u];
                            let _e1012 = local.member[1u][1u];
                            if (_e1012 < 0f) {
                                phi_1451_ = -(_e1012);
                            } else {
                                phi_1451_ = _e1012;
                            }
                            let _e1016 = phi_1451_;
                            let _e1019 = local.member_3[2u];
                            let _e1025 = local.member[0u][0u];
                            if (_e1025 < 0f) {
                                phi_1474_ = -(_e1025);
                            } else {
                                phi_1474_ = _e1025;
                            }
                            let _e1029 = phi_1474_;
                            let _e1032 = local.member_4[2u];
                            let _e1037 = local.member[0u][2u];
                            if (_e1037 < 0f) {
                                phi_1496_ = -(_e1037);
                            } else {
                                phi_1496_ = _e1037;
                            }
                            let _e1041 = phi_1496_;
                            let _e1044 = local.member_4[0u];
                            if (_e996 < 0f) {
                                phi_1512_ = -(_e996);
                            } else {
                                phi_1512_ = _e996;
                            }
                            let _e1050 = phi_1512_;
                            let _e1052 = (_e1050 - (((_e1004 * _e1007) + (_e1016 * _e1019)) + ((_e1029 * _e1032) + (_e1041 * _e1044))));
                            let _e1056 = local.member[1u][2u];
                            let _e1059 = local.member_1[2u];
                            let _e1064 = local.member[2u][2u];
                            let _e1067 = local.member_1[1u];
                            let _e1069 = ((_e1056 * _e1059) - (_e1064 * _e1067));
                            let _e1073 = local.member[2u][2u];
                            if (_e1073 < 0f) {
                                phi_1567_ = -(_e1073);
                            } else {
                                phi_1567_ = _e1073;
                            }
                            let _e1077 = phi_1567_;
                            let _e1080 = local.member_3[1u];
                            let _e1085 = local.member[1u][2u];
                            if (_e1085 < 0f) {
                                phi_1590_ = -(_e1085);
                            } else {
                                phi_1590_ = _e1085;
                            }
                            let _e1089 = phi_1590_;
                            let _e1092 = local.member_3[2u];
                            let _e1098 = local.member[0u][1u];
                            if (_e1098 < 0f) {
                                phi_1613_ = -(_e1098);
                            } else {
                                phi_1613_ = _e1098;
                            }
                            let _e1102 = phi_1613_;
                            let _e1105 = local.member_4[0u];
                            let _e1110 = local.member[0u][0u];
                            if (_e1110 < 0f) {
                                phi_1635_ = -(_e1110);
                            } else {
                                phi_1635_ = _e1110;
                            }
                            let _e1114 = phi_1635_;
                            let _e1117 = local.member_4[1u];
                            if (_e1069 < 0f) {
                                phi_1651_ = -(_e1069);
                            } else {
                                phi_1651_ = _e1069;
                            }
                            let _e1123 = phi_1651_;
                            let _e1125 = (_e1123 - (((_e1077 * _e1080) + (_e1089 * _e1092)) + ((_e1102 * _e1105) + (_e1114 * _e1117))));
                            let _e1129 = local.member[2u][0u];
                            let _e1132 = local.member_1[0u];
                            let _e1137 = local.member[0u][0u];
                            let _e1140 = local.member_1[2u];
                            let _e1142 = ((_e1129 * _e1132) - (_e1137 * _e1140));
                            let _e1146 = local.member[0u][0u];
                            if (_e1146 < 0f) {
                                phi_1706_ = -(_e1146);
                            } else {
                                phi_1706_ = _e1146;
                            }
                            let _e1150 = phi_1706_;
                            let _e1153 = local.member_3[2u];
                            let _e1158 = local.member[2u][0u];
                            if (_e1158 < 0f) {
                                phi_1729_ = -(_e1158);
                            } else {
                                phi_1729_ = _e1158;
                            }
                            let _e1162 = phi_1729_;
                            let _e1165 = local.member_3[0u];
                            let _e1171 = local.member[1u][2u];
                            if (_e1171 < 0f) {
                                phi_1753_ = -(_e1171);
                            } else {
                                phi_1753_ = _e1171;
                            }
                            let _e1175 = phi_1753_;
                            let _e1178 = local.member_4[1u];
                            let _e1183 = local.member[1u][1u];
                            if (_e1183 < 0f) {
                                phi_1776_ = -(_e1183);
                            } else {
                                phi_1776_ = _e1183;
                            }
                            let _e1187 = phi_1776_;
                            let _e1190 = local.member_4[2u];
                            if (_e1142 < 0f) {
                                phi_1792_ = -(_e1142);
                            } else {
                                phi_1792_ = _e1142;
                            }
                            let _e1196 = phi_1792_;
                            let _e1198 = (_e1196 - (((_e1150 * _e1153) + (_e1162 * _e1165)) + ((_e1175 * _e1178) + (_e1187 * _e1190))));
                            let _e1202 = local.member[2u][1u];
                            let _e1205 = local.member_1[0u];
                            let _e1210 = local.member[0u][1u];
                            let _e1213 = local.member_1[2u];
                            let _e1215 = ((_e1202 * _e1205) - (_e1210 * _e1213));
                            let _e1219 = local.member[0u][1u];
                            if (_e1219 < 0f) {
                                phi_1847_ = -(_e1219);
                            } else {
                                phi_1847_ = _e1219;
                            }
                            let _e1223 = phi_1847_;
                            let _e1226 = local.member_3[2u];
                            let _e1231 = local.member[2u][1u];
                            if (_e1231 < 0f) {
                                phi_1870_ = -(_e1231);
                            } else {
                                phi_1870_ = _e1231;
                            }
                            let _e1235 = phi_1870_;
                            let _e1238 = local.member_3[0u];
                            let _e1244 = local.member[1u][0u];
                            if (_e1244 < 0f) {
                                phi_1894_ = -(_e1244);
                            } else {
                                phi_1894_ = _e1244;
                            }
                            let _e1248 = phi_1894_;
                            let _e1251 = local.member_4[2u];
                            let _e1256 = local.member[1u][2u];
                            if (_e1256 < 0f) {
                                phi_1917_ = -(_e1256);
                            } else {
                                phi_1917_ = _e1256;
                            }
                            let _e1260 = phi_1917_;
                            let _e1263 = local.member_4[0u];
                            if (_e1215 < 0f) {
                                phi_1933_ = -(_e1215);
                            } else {
                                phi_1933_ = _e1215;
                            }
                            let _e1269 = phi_1933_;
                            let _e1271 = (_e1269 - (((_e1223 * _e1226) + (_e1235 * _e1238)) + ((_e1248 * _e1251) + (_e1260 * _e1263))));
                            let _e1275 = local.member[2u][2u];
                            let _e1278 = local.member_1[0u];
                            let _e1283 = local.member[0u][2u];
                            let _e1286 = local.member_1[2u];
                            let _e1288 = ((_e1275 * _e1278) - (_e1283 * _e1286));
                            let _e1292 = local.member[0u][2u];
                            if (_e1292 < 0f) {
                                phi_1988_ = -(_e1292);
                            } else {
                                phi_1988_ = _e1292;
                            }
                            let _e1296 = phi_1988_;
                            let _e1299 = local.member_3[2u];
                            let _e1304 = local.member[2u][2u];
                            if (_e1304 < 0f) {
                                phi_2011_ = -(_e1304);
                            } else {
                                phi_2011_ = _e1304;
                            }
                            let _e1308 = phi_2011_;
                            let _e1311 = local.member_3[0u];
                            let _e1317 = local.member[1u][1u];
                            if (_e1317 < 0f) {
                                phi_2035_ = -(_e1317);
                            } else {
                                phi_2035_ = _e1317;
                            }
                            let _e1321 = phi_2035_;
                            let _e1324 = local.member_4[0u];
                            let _e1329 = local.member[1u][0u];
                            if (_e1329 < 0f) {
                                phi_2058_ = -(_e1329);
                            } else {
                                phi_2058_ = _e1329;
                            }
                            let _e1333 = phi_2058_;
                            let _e1336 = local.member_4[1u];
                            if (_e1288 < 0f) {
                                phi_2074_ = -(_e1288);
                            } else {
                                phi_2074_ = _e1288;
                            }
                            let _e1342 = phi_2074_;
                            let _e1344 = (_e1342 - (((_e1296 * _e1299) + (_e1308 * _e1311)) + ((_e1321 * _e1324) + (_e1333 * _e1336))));
                            let _e1348 = local.member[0u][0u];
                            let _e1351 = local.member_1[1u];
                            let _e1356 = local.member[1u][0u];
                            let _e1359 = local.member_1[0u];
                            let _e1361 = ((_e1348 * _e1351) - (_e1356 * _e1359));
                            let _e1365 = local.member[1u][0u];
                            if (_e1365 < 0f) {
                                phi_2129_ = -(_e1365);
                            } else {
                                phi_2129_ = _e1365;
                            }
                            let _e1369 = phi_2129_;
                            let _e1372 = local.member_3[0u];
                            let _e1377 = local.member[0u][0u];
                            if (_e1377 < 0f) {
                                phi_2152_ = -(_e1377);
                            } else {
                                phi_2152_ = _e1377;
                            }
                            let _e1381 = phi_2152_;
                            let _e1384 = local.member_3[1u];
                            let _e1390 = local.member[2u][2u];
                            if (_e1390 < 0f) {
                                phi_2176_ = -(_e1390);
                            } else {
                                phi_2176_ = _e1390;
                            }
                            let _e1394 = phi_2176_;
                            let _e1397 = local.member_4[1u];
                            let _e1402 = local.member[2u][1u];
                            if (_e1402 < 0f) {
                                phi_2199_ = -(_e1402);
                            } else {
                                phi_2199_ = _e1402;
                            }
                            let _e1406 = phi_2199_;
                            let _e1409 = local.member_4[2u];
                            if (_e1361 < 0f) {
                                phi_2215_ = -(_e1361);
                            } else {
                                phi_2215_ = _e1361;
                            }
                            let _e1415 = phi_2215_;
                            let _e1417 = (_e1415 - (((_e1369 * _e1372) + (_e1381 * _e1384)) + ((_e1394 * _e1397) + (_e1406 * _e1409))));
                            let _e1421 = local.member[0u][1u];
                            let _e1424 = local.member_1[1u];
                            let _e1429 = local.member[1u][1u];
                            let _e1432 = local.member_1[0u];
                            let _e1434 = ((_e1421 * _e1424) - (_e1429 * _e1432));
                            let _e1438 = local.member[1u][1u];
                            if (_e1438 < 0f) {
                                phi_2270_ = -(_e1438);
                            } else {
                                phi_2270_ = _e1438;
                            }
                            let _e1442 = phi_2270_;
                            let _e1445 = local.member_3[0u];
                            let _e1450 = local.member[0u][1u];
                            if (_e1450 < 0f) {
                                phi_2293_ = -(_e1450);
                            } else {
                                phi_2293_ = _e1450;
                            }
                            let _e1454 = phi_2293_;
                            let _e1457 = local.member_3[1u];
                            let _e1463 = local.member[2u][0u];
                            if (_e1463 < 0f) {
                                phi_2317_ = -(_e1463);
                            } else {
                                phi_2317_ = _e1463;
                            }
                            let _e1467 = phi_2317_;
                            let _e1470 = local.member_4[2u];
                            let _e1475 = local.member[2u][2u];
                            if (_e1475 < 0f) {
                                phi_2340_ = -(_e1475);
                            } else {
                                phi_2340_ = _e1475;
                            }
                            let _e1479 = phi_2340_;
                            let _e1482 = local.member_4[0u];
                            if (_e1434 < 0f) {
                                phi_2356_ = -(_e1434);
                            } else {
                                phi_2356_ = _e1434;
                            }
                            let _e1488 = phi_2356_;
                            let _e1490 = (_e1488 - (((_e1442 * _e1445) + (_e1454 * _e1457)) + ((_e1467 * _e1470) + (_e1479 * _e1482))));
                            let _e1494 = local.member[0u][2u];
                            let _e1497 = local.member_1[1u];
                            let _e1502 = local.member[1u][2u];
                            let _e1505 = local.member_1[0u];
                            let _e1507 = ((_e1494 * _e1497) - (_e1502 * _e1505));
                            let _e1511 = local.member[1u][2u];
                            if (_e1511 < 0f) {
                                phi_2411_ = -(_e1511);
                            } else {
                                phi_2411_ = _e1511;
                            }
                            let _e1515 = phi_2411_;
                            let _e1518 = local.member_3[0u];
                            let _e1523 = local.member[0u][2u];
                            if (_e1523 < 0f) {
                                phi_2434_ = -(_e1523);
                            } else {
                                phi_2434_ = _e1523;
                            }
                            let _e1527 = phi_2434_;
                            let _e1530 = local.member_3[1u];
                            let _e1536 = local.member[2u][1u];
                            if (_e1536 < 0f) {
                                phi_2458_ = -(_e1536);
                            } else {
                                phi_2458_ = _e1536;
                            }
                            let _e1540 = phi_2458_;
                            let _e1543 = local.member_4[0u];
                            let _e1548 = local.member[2u][0u];
                            if (_e1548 < 0f) {
                                phi_2481_ = -(_e1548);
                            } else {
                                phi_2481_ = _e1548;
                            }
                            let _e1552 = phi_2481_;
                            let _e1555 = local.member_4[1u];
                            if (_e1507 < 0f) {
                                phi_2497_ = -(_e1507);
                            } else {
                                phi_2497_ = _e1507;
                            }
                            let _e1561 = phi_2497_;
                            let _e1563 = (_e1561 - (((_e1515 * _e1518) + (_e1527 * _e1530)) + ((_e1540 * _e1543) + (_e1552 * _e1555))));
                            if (_e979 > _e1052) {
                                phi_2504_ = _e979;
                            } else {
                                phi_2504_ = _e1052;
                            }
                            let _e1566 = phi_2504_;
                            if (_e1566 > _e1125) {
                                phi_2509_ = _e1566;
                            } else {
                                phi_2509_ = _e1125;
                            }
                            let _e1569 = phi_2509_;
                            if (_e1198 > _e1271) {
                                phi_2514_ = _e1198;
                            } else {
                                phi_2514_ = _e1271;
                            }
                            let _e1572 = phi_2514_;
                            if (_e1572 > _e1344) {
                                phi_2519_ = _e1572;
                            } else {
                                phi_2519_ = _e1344;
                            }
                            let _e1575 = phi_2519_;
                            if (_e1569 > _e1575) {
                                phi_2524_ = _e1569;
                            } else {
                                phi_2524_ = _e1575;
                            }
                            let _e1578 = phi_2524_;
                            if (_e1417 > _e1490) {
                                phi_2529_ = _e1417;
                            } else {
                                phi_2529_ = _e1490;
                            }
                            let _e1581 = phi_2529_;
                            if (_e1581 > _e1563) {
                                phi_2534_ = _e1581;
                            } else {
                                phi_2534_ = _e1563;
                            }
                            let _e1584 = phi_2534_;
                            if (_e1578 > _e1584) {
                                phi_2539_ = _e1578;
                            } else {
                                phi_2539_ = _e1584;
                            }
                            let _e1587 = phi_2539_;
                            let _e1589 = local.member_5;
                            phi_2543_ = (_e1587 > _e1589);
                        }
                        let _e1592 = phi_2543_;
                        phi_2545_ = !(_e1592);
                        phi_2546_ = false;
                    } else {
                        phi_2545_ = bool();
                        phi_2546_ = true;
                    }
                    let _e1595 = phi_2545_;
                    let _e1597 = phi_2546_;
                    phi_2547_ = _e1595;
                    phi_2548_ = _e1597;
                }
                let _e1599 = phi_2547_;
                let _e1601 = phi_2548_;
                if _e1601 {
                    phi_2552_ = true;
                } else {
                    phi_2552_ = _e1599;
                }
                let _e1603 = phi_2552_;
                phi_2553_ = _e1603;
            } else {
                phi_2553_ = false;
            }
            let _e1605 = phi_2553_;
            if _e1605 {
                let _e1633 = atomicAdd((&control.member[0u]), 1u);
                let _e1636 = atomicMax((&output.member[0u]), (_e1633 + 1u));
                if ((_e1633 + 1u) < _e1633) {
                    let _e1640 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1643 = params.member.member_2.member_3;
                if (_e1633 < _e1643) {
                    let _e1647 = (2u * _e1633);
                    atomicStore((&output.member[(4u + _e1647)]), _e93[0]);
                    atomicStore((&output.member[(_e1647 + 5u)]), _e93[1]);
                }
            } else {
                let _e1608 = params.member.member_2.member_4;
                if (_e1608 > 0u) {
                    let _e1611 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e1611 + 1u) < _e1611) {
                        let _e1615 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e1618 = params.member.member_2.member_4;
                    if (_e1611 < _e1618) {
                        let _e1621 = params.member.member_2.member_5;
                        let _e1623 = params.member.member_2.member_4;
                        let _e1626 = (2u * ((_e1621 * _e1623) + _e1611));
                        front.member[_e1626] = _e93[0];
                        front.member[(_e1626 + 1u)] = _e93[1];
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
