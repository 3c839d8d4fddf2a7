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

struct type_12 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_17 {
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

struct type_18 {
    member: type_7,
    member_1: type_8,
    member_2: type_17,
}

struct type_19 {
    member: type_18,
}

struct type_21 {
    member: array<array<f32, 3>, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: array<f32, 3>,
    member_5: f32,
}

struct type_23 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: array<array<f32, 3>, 3>,
    member_2: array<f32, 3>,
}

struct type_29 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> a_nodes: type_16;
@group(0) @binding(2) 
var<storage> b_nodes: type_16;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_29;
@group(0) @binding(4) 
var<storage, read_write> control: type_29;
var<workgroup> shared_: array<atomic<u32>, 18>;
@group(0) @binding(3) 
var<storage> oriented: type_25;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_29;
@group(0) @binding(7) 
var<storage, read_write> front: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_21;
    var phi_136_: array<u32, 2>;
    var phi_271_: bool;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_357_: f32;
    var phi_363_: f32;
    var phi_369_: f32;
    var phi_375_: f32;
    var phi_381_: f32;
    var phi_387_: f32;
    var phi_405_: f32;
    var phi_410_: f32;
    var phi_415_: f32;
    var phi_431_: type_26;
    var phi_501_: f32;
    var phi_507_: f32;
    var phi_513_: f32;
    var phi_519_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_549_: f32;
    var phi_554_: f32;
    var phi_559_: f32;
    var phi_575_: type_26;
    var phi_765_: f32;
    var phi_771_: f32;
    var phi_778_: f32;
    var phi_787_: f32;
    var phi_794_: f32;
    var phi_802_: f32;
    var phi_811_: f32;
    var phi_818_: f32;
    var phi_826_: f32;
    var phi_919_: f32;
    var phi_926_: f32;
    var phi_932_: f32;
    var phi_938_: f32;
    var phi_957_: f32;
    var phi_964_: f32;
    var phi_970_: f32;
    var phi_976_: f32;
    var phi_995_: f32;
    var phi_1002_: f32;
    var phi_1008_: f32;
    var phi_1014_: f32;
    var phi_1033_: f32;
    var phi_1040_: f32;
    var phi_1046_: f32;
    var phi_1052_: f32;
    var phi_1071_: f32;
    var phi_1078_: f32;
    var phi_1084_: f32;
    var phi_1090_: f32;
    var phi_1109_: f32;
    var phi_1116_: f32;
    var phi_1122_: f32;
    var phi_1128_: f32;
    var phi_1143_: f32;
    var phi_1148_: f32;
    var phi_1153_: f32;
    var phi_1158_: f32;
    var phi_1163_: f32;
    var phi_1222_: f32;
    var phi_1245_: f32;
    var phi_1268_: f32;
    var phi_1290_: f32;
    var phi_1306_: f32;
    var phi_1361_: f32;
    var phi_1384_: f32;
    var phi_1407_: f32;
    var phi_1429_: f32;
    var phi_1445_: f32;
    var phi_1500_: f32;
    var phi_1523_: f32;
    var phi_1546_: f32;
    var phi_1568_: f32;
    var phi_1584_: f32;
    var phi_1639_: f32;
    var phi_1662_: f32;
    var phi_1686_: f32;
    var phi_1709_: f32;
    var phi_1725_: f32;
    var phi_1780_: f32;
    var phi_1803_: f32;
    var phi_1827_: f32;
    var phi_1850_: f32;
    var phi_1866_: f32;
    var phi_1921_: f32;
    var phi_1944_: f32;
    var phi_1968_: f32;
    var phi_1991_: f32;
    var phi_2007_: f32;
    var phi_2062_: f32;
    var phi_2085_: f32;
    var phi_2109_: f32;
    var phi_2132_: f32;
    var phi_2148_: f32;
    var phi_2203_: f32;
    var phi_2226_: f32;
    var phi_2250_: f32;
    var phi_2273_: f32;
    var phi_2289_: f32;
    var phi_2344_: f32;
    var phi_2367_: f32;
    var phi_2391_: f32;
    var phi_2414_: f32;
    var phi_2430_: f32;
    var phi_2437_: f32;
    var phi_2442_: f32;
    var phi_2447_: f32;
    var phi_2452_: f32;
    var phi_2457_: f32;
    var phi_2462_: f32;
    var phi_2467_: f32;
    var phi_2472_: f32;
    var phi_2476_: bool;
    var phi_2478_: bool;
    var phi_2479_: bool;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2485_: bool;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2506_: u32;
    var phi_2507_: u32;
    var phi_2508_: u32;
    var phi_2509_: u32;
    var phi_2510_: u32;
    var phi_2511_: array<u32, 2>;
    var phi_2528_: array<u32, 2>;
    var phi_2529_: array<u32, 2>;
    var phi_2541_: array<u32, 2>;
    var phi_2542_: array<u32, 2>;
    var phi_2680_: type_12;
    var phi_2685_: type_12;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e46 = id_2;
    let _e47 = n_2;
    let _e48 = lane_2;
    let _e63 = ((((_e46.y * _e47.x) + _e46.x) * 128u) + _e48);
    let _e65 = params.member.member_2;
    if (_e65.member == 0u) {
        phi_136_ = array<u32, 2>(0u, 2u);
    } else {
        phi_136_ = array<u32, 2>(1u, 1u);
    }
    let _e69 = phi_136_;
    let _e75 = params.member.member.member[_e69[0]];
    let _e76 = (_e75 - 1u);
    let _e80 = params.member.member.member[_e69[1]];
    let _e81 = (_e80 - 1u);
    let _e87 = params.member.member.member_2[_e69[0]];
    let _e91 = params.member.member.member_2[_e69[1]];
    if (_e48 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    let _e98 = params.member.member_1.member;
    if (_e63 < _e98) {
        let _e105 = (2u * (((1u - _e65.member_5) * _e65.member_4) + _e63));
        let _e107 = front.member[_e105];
        let _e110 = front.member[(_e105 + 1u)];
        let _e113 = a_nodes.member[_e107];
        let _e115 = b_nodes.member[_e110];
        if ((((((_e113.member[0] <= _e115.member_2[0]) && (_e115.member[0] <= _e113.member_2[0])) && (_e113.member[1] <= _e115.member_2[1])) && (_e115.member[1] <= _e113.member_2[1])) && (_e113.member[2] <= _e115.member_2[2])) && (_e115.member[2] <= _e113.member_2[2])) {
            if (_e65.member == 1u) {
                phi_271_ = (_e107 == _e110);
            } else {
                phi_271_ = false;
            }
            let _e145 = phi_271_;
            if _e145 {
                phi_2480_ = bool();
                phi_2481_ = true;
            } else {
                if (_e107 >= _e76) {
                    if (_e110 >= _e81) {
                        phi_283_ = false;
                    } else {
                        phi_283_ = true;
                    }
                    let _e149 = phi_283_;
                    phi_284_ = _e149;
                } else {
                    phi_284_ = true;
                }
                let _e151 = phi_284_;
                if _e151 {
                    if (_e107 < _e76) {
                        let _e231 = oriented.member[(_e87 + _e107)];
                        phi_431_ = type_26(array<f32, 3>(_e231.member.x, _e231.member.y, _e231.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e231.member.w, _e231.member_1.x, _e231.member_1.y), array<f32, 3>(_e231.member_1.z, _e231.member_1.w, _e231.member_2.x), array<f32, 3>(_e231.member_2.y, _e231.member_2.z, _e231.member_2.w)), array<f32, 3>(_e231.member_3.x, _e231.member_3.y, _e231.member_3.z));
                    } else {
                        let _e154 = a_nodes.member[_e107];
                        let _e169 = ((_e154.member[0] * 0.5f) + (_e154.member_2[0] * 0.5f));
                        let _e170 = ((_e154.member[1] * 0.5f) + (_e154.member_2[1] * 0.5f));
                        let _e171 = ((_e154.member[2] * 0.5f) + (_e154.member_2[2] * 0.5f));
                        if (_e169 < _e154.member_2[0]) {
                            phi_357_ = _e169;
                        } else {
                            phi_357_ = _e154.member_2[0];
                        }
                        let _e175 = phi_357_;
                        if (_e170 < _e154.member_2[1]) {
                            phi_363_ = _e170;
                        } else {
                            phi_363_ = _e154.member_2[1];
                        }
                        let _e179 = phi_363_;
                        if (_e171 < _e154.member_2[2]) {
                            phi_369_ = _e171;
                        } else {
                            phi_369_ = _e154.member_2[2];
                        }
                        let _e183 = phi_369_;
                        if (_e175 > _e154.member[0]) {
                            phi_375_ = _e175;
                        } else {
                            phi_375_ = _e154.member[0];
                        }
                        let _e187 = phi_375_;
                        if (_e179 > _e154.member[1]) {
                            phi_381_ = _e179;
                        } else {
                            phi_381_ = _e154.member[1];
                        }
                        let _e191 = phi_381_;
                        if (_e183 > _e154.member[2]) {
                            phi_387_ = _e183;
                        } else {
                            phi_387_ = _e154.member[2];
                        }
                        let _e195 = phi_387_;
                        let _e198 = (_e154.member_2[0] - _e187);
                        let _e200 = (_e154.member_2[1] - _e191);
                        let _e202 = (_e154.member_2[2] - _e195);
                        let _e204 = (_e187 - _e154.member[0]);
                        let _e206 = (_e191 - _e154.member[1]);
                        let _e208 = (_e195 - _e154.member[2]);
                        if (_e198 > _e204) {
                            phi_405_ = _e198;
                        } else {
                            phi_405_ = _e204;
                        }
                        let _e211 = phi_405_;
                        if (_e200 > _e206) {
                            phi_410_ = _e200;
                        } else {
                            phi_410_ = _e206;
                        }
                        let _e214 = phi_410_;
                        if (_e202 > _e208) {
                            phi_415_ = _e202;
                        } else {
                            phi_415_ = _e208;
                        }
                        let _e217 = phi_415_;
                        let _e219 = (1f + (0.000000059604645f * 4f));
                        let _e223 = (0.000000000000000000000000000000000000011754944f * 8f);
                        phi_431_ = type_26(array<f32, 3>(_e187, _e191, _e195), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e211 * _e219) + _e223), ((_e214 * _e219) + _e223), ((_e217 * _e219) + _e223)));
                    }
                    let _e270 = phi_431_;
                    if (_e110 < _e81) {
                        let _e350 = oriented.member[(_e91 + _e110)];
                        phi_575_ = type_26(array<f32, 3>(_e350.member.x, _e350.member.y, _e350.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e350.member.w, _e350.member_1.x, _e350.member_1.y), array<f32, 3>(_e350.member_1.z, _e350.member_1.w, _e350.member_2.x), array<f32, 3>(_e350.member_2.y, _e350.member_2.z, _e350.member_2.w)), array<f32, 3>(_e350.member_3.x, _e350.member_3.y, _e350.member_3.z));
                    } else {
                        let _e273 = b_nodes.member[_e110];
                        let _e288 = ((_e273.member[0] * 0.5f) + (_e273.member_2[0] * 0.5f));
                        let _e289 = ((_e273.member[1] * 0.5f) + (_e273.member_2[1] * 0.5f));
                        let _e290 = ((_e273.member[2] * 0.5f) + (_e273.member_2[2] * 0.5f));
                        if (_e288 < _e273.member_2[0]) {
                            phi_501_ = _e288;
                        } else {
                            phi_501_ = _e273.member_2[0];
                        }
                        let _e294 = phi_501_;
                        if (_e289 < _e273.member_2[1]) {
                            phi_507_ = _e289;
                        } else {
                            phi_507_ = _e273.member_2[1];
                        }
                        let _e298 = phi_507_;
                        if (_e290 < _e273.member_2[2]) {
                            phi_513_ = _e290;
                        } else {
                            phi_513_ = _e273.member_2[2];
                        }
                        let _e302 = phi_513_;
                        if (_e294 > _e273.member[0]) {
                            phi_519_ = _e294;
                        } else {
                            phi_519_ = _e273.member[0];
                        }
                        let _e306 = phi_519_;
                        if (_e298 > _e273.member[1]) {
                            phi_525_ = _e298;
                        } else {
                            phi_525_ = _e273.member[1];
                        }
                        let _e310 = phi_525_;
                        if (_e302 > _e273.member[2]) {
                            phi_531_ = _e302;
                        } else {
                            phi_531_ = _e273.member[2];
                        }
                        let _e314 = phi_531_;
                        let _e317 = (_e273.member_2[0] - _e306);
                        let _e319 = (_e273.member_2[1] - _e310);
                        let _e321 = (_e273.member_2[2] - _e314);
                        let _e323 = (_e306 - _e273.member[0]);
                        let _e325 = (_e310 - _e273.member[1]);
                        let _e327 = (_e314 - _e273.member[2]);
                        if (_e317 > _e323) {
                            phi_549_ = _e317;
                        } else {
                            phi_549_ = _e323;
                        }
                        let _e330 = phi_549_;
                        if (_e319 > _e325) {
                            phi_554_ = _e319;
                        } else {
                            phi_554_ = _e325;
                        }
                        let _e333 = phi_554_;
                        if (_e321 > _e327) {
                            phi_559_ = _e321;
                        } else {
                            phi_559_ = _e327;
                        }
                        let _e336 = phi_559_;
                        let _e338 = (1f + (0.000000059604645f * 4f));
                        let _e342 = (0.000000000000000000000000000000000000011754944f * 8f);
                        phi_575_ = type_26(array<f32, 3>(_e306, _e310, _e314), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e330 * _e338) + _e342), ((_e333 * _e338) + _e342), ((_e336 * _e338) + _e342)));
                    }
                    let _e389 = phi_575_;
                    let _e394 = (_e389.member[0] - _e270.member[0]);
                    let _e397 = (_e389.member[1] - _e270.member[1]);
                    let _e400 = (_e389.member[2] - _e270.member[2]);
                    if (_e394 < 0f) {
                        phi_765_ = -(_e394);
                    } else {
                        phi_765_ = _e394;
                    }
                    let _e589 = phi_765_;
                    if (_e397 < 0f) {
                        phi_771_ = -(_e397);
                    } else {
                        phi_771_ = _e397;
                    }
                    let _e593 = phi_771_;
                    if (_e400 < 0f) {
                        phi_778_ = -(_e400);
                    } else {
                        phi_778_ = _e400;
                    }
                    let _e598 = phi_778_;
                    if (_e270.member_2[0] < 0f) {
                        phi_787_ = -(_e270.member_2[0]);
                    } else {
                        phi_787_ = _e270.member_2[0];
                    }
                    let _e605 = phi_787_;
                    if (_e270.member_2[1] < 0f) {
                        phi_794_ = -(_e270.member_2[1]);
                    } else {
                        phi_794_ = _e270.member_2[1];
                    }
                    let _e610 = phi_794_;
                    if (_e270.member_2[2] < 0f) {
                        phi_802_ = -(_e270.member_2[2]);
                    } else {
                        phi_802_ = _e270.member_2[2];
                    }
                    let _e616 = phi_802_;
                    if (_e389.member_2[0] < 0f) {
                        phi_811_ = -(_e389.member_2[0]);
                    } else {
                        phi_811_ = _e389.member_2[0];
                    }
                    let _e623 = phi_811_;
                    if (_e389.member_2[1] < 0f) {
                        phi_818_ = -(_e389.member_2[1]);
                    } else {
                        phi_818_ = _e389.member_2[1];
                    }
                    let _e628 = phi_818_;
                    if (_e389.member_2[2] < 0f) {
                        phi_826_ = -(_e389.member_2[2]);
                    } else {
                        phi_826_ = _e389.member_2[2];
                    }
                    let _e634 = phi_826_;
                    local = type_21(array<array<f32, 3>, 3>(array<f32, 3>((((_e389.member_1[0][0] * _e270.member_1[0][0]) + (_e389.member_1[0][1] * _e270.member_1[0][1])) + (_e389.member_1[0][2] * _e270.member_1[0][2])), (((_e389.member_1[1][0] * _e270.member_1[0][0]) + (_e389.member_1[1][1] * _e270.member_1[0][1])) + (_e389.member_1[1][2] * _e270.member_1[0][2])), (((_e389.member_1[2][0] * _e270.member_1[0][0]) + (_e389.member_1[2][1] * _e270.member_1[0][1])) + (_e389.member_1[2][2] * _e270.member_1[0][2]))), array<f32, 3>((((_e389.member_1[0][0] * _e270.member_1[1][0]) + (_e389.member_1[0][1] * _e270.member_1[1][1])) + (_e389.member_1[0][2] * _e270.member_1[1][2])), (((_e389.member_1[1][0] * _e270.member_1[1][0]) + (_e389.member_1[1][1] * _e270.member_1[1][1])) + (_e389.member_1[1][2] * _e270.member_1[1][2])), (((_e389.member_1[2][0] * _e270.member_1[1][0]) + (_e389.member_1[2][1] * _e270.member_1[1][1])) + (_e389.member_1[2][2] * _e270.member_1[1][2]))), array<f32, 3>((((_e389.member_1[0][0] * _e270.member_1[2][0]) + (_e389.member_1[0][1] * _e270.member_1[2][1])) + (_e389.member_1[0][2] * _e270.member_1[2][2])), (((_e389.member_1[1][0] * _e270.member_1[2][0]) + (_e389.member_1[1][1] * _e270.member_1[2][1])) + (_e389.member_1[1][2] * _e270.member_1[2][2])), (((_e389.member_1[2][0] * _e270.member_1[2][0]) + (_e389.member_1[2][1] * _e270.member_1[2][1])) + (_e389.member_1[2][2] * _e270.member_1[2][2])))), array<f32, 3>((((_e270.member_1[0][0] * _e394) + (_e270.member_1[0][1] * _e397)) + (_e270.member_1[0][2] * _e400)), (((_e270.member_1[1][0] * _e394) + (_e270.member_1[1][1] * _e397)) + (_e270.member_1[1][2] * _e400)), (((_e270.member_1[2][0] * _e394) + (_e270.member_1[2][1] * _e397)) + (_e270.member_1[2][2] * _e400))), array<f32, 3>((((_e389.member_1[0][0] * _e394) + (_e389.member_1[0][1] * _e397)) + (_e389.member_1[0][2] * _e400)), (((_e389.member_1[1][0] * _e394) + (_e389.member_1[1][1] * _e397)) + (_e389.member_1[1][2] * _e400)), (((_e389.member_1[2][0] * _e394) + (_e389.member_1[2][1] * _e397)) + (_e389.member_1[2][2] * _e400))), array<f32, 3>(_e270.member_2[0], _e270.member_2[1], _e270.member_2[2]), array<f32, 3>(_e389.member_2[0], _e389.member_2[1], _e389.member_2[2]), ((((((_e589 + _e593) + _e598) + (((_e605 + _e610) + _e616) + ((_e623 + _e628) + _e634))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e661 = local.member[0u][0u];
                    let _e665 = local.member[0u][1u];
                    let _e669 = local.member[0u][2u];
                    let _e673 = local.member[1u][0u];
                    let _e677 = local.member[1u][1u];
                    let _e681 = local.member[1u][2u];
                    let _e685 = local.member[2u][0u];
                    let _e689 = local.member[2u][1u];
                    let _e693 = local.member[2u][2u];
                    let _e695 = local.member_3;
                    let _e700 = local.member_4;
                    let _e706 = local.member_1[0u];
                    if (_e706 < 0f) {
                        phi_919_ = -(_e706);
                    } else {
                        phi_919_ = _e706;
                    }
                    let _e710 = phi_919_;
                    if (_e661 < 0f) {
                        phi_926_ = -(_e661);
                    } else {
                        phi_926_ = _e661;
                    }
                    let _e714 = phi_926_;
                    if (_e665 < 0f) {
                        phi_932_ = -(_e665);
                    } else {
                        phi_932_ = _e665;
                    }
                    let _e718 = phi_932_;
                    if (_e669 < 0f) {
                        phi_938_ = -(_e669);
                    } else {
                        phi_938_ = _e669;
                    }
                    let _e722 = phi_938_;
                    let _e729 = (_e710 - (_e695[0] + (((_e714 * _e700[0]) + (_e718 * _e700[1])) + (_e722 * _e700[2]))));
                    let _e732 = local.member_1[1u];
                    if (_e732 < 0f) {
                        phi_957_ = -(_e732);
                    } else {
                        phi_957_ = _e732;
                    }
                    let _e736 = phi_957_;
                    if (_e673 < 0f) {
                        phi_964_ = -(_e673);
                    } else {
                        phi_964_ = _e673;
                    }
                    let _e740 = phi_964_;
                    if (_e677 < 0f) {
                        phi_970_ = -(_e677);
                    } else {
                        phi_970_ = _e677;
                    }
                    let _e744 = phi_970_;
                    if (_e681 < 0f) {
                        phi_976_ = -(_e681);
                    } else {
                        phi_976_ = _e681;
                    }
                    let _e748 = phi_976_;
                    let _e755 = (_e736 - (_e695[1] + (((_e740 * _e700[0]) + (_e744 * _e700[1])) + (_e748 * _e700[2]))));
                    let _e758 = local.member_1[2u];
                    if (_e758 < 0f) {
                        phi_995_ = -(_e758);
                    } else {
                        phi_995_ = _e758;
                    }
                    let _e762 = phi_995_;
                    if (_e685 < 0f) {
                        phi_1002_ = -(_e685);
                    } else {
                        phi_1002_ = _e685;
                    }
                    let _e766 = phi_1002_;
                    if (_e689 < 0f) {
                        phi_1008_ = -(_e689);
                    } else {
                        phi_1008_ = _e689;
                    }
                    let _e770 = phi_1008_;
                    if (_e693 < 0f) {
                        phi_1014_ = -(_e693);
                    } else {
                        phi_1014_ = _e693;
                    }
                    let _e774 = phi_1014_;
                    let _e781 = (_e762 - (_e695[2] + (((_e766 * _e700[0]) + (_e770 * _e700[1])) + (_e774 * _e700[2]))));
                    let _e784 = local.member_2[0u];
                    if (_e784 < 0f) {
                        phi_1033_ = -(_e784);
                    } else {
                        phi_1033_ = _e784;
                    }
                    let _e788 = phi_1033_;
                    if (_e661 < 0f) {
                        phi_1040_ = -(_e661);
                    } else {
                        phi_1040_ = _e661;
                    }
                    let _e792 = phi_1040_;
                    if (_e673 < 0f) {
                        phi_1046_ = -(_e673);
                    } else {
                        phi_1046_ = _e673;
                    }
                    let _e796 = phi_1046_;
                    if (_e685 < 0f) {
                        phi_1052_ = -(_e685);
                    } else {
                        phi_1052_ = _e685;
                    }
                    let _e800 = phi_1052_;
                    let _e807 = (_e788 - (_e700[0] + (((_e792 * _e695[0]) + (_e796 * _e695[1])) + (_e800 * _e695[2]))));
                    let _e810 = local.member_2[1u];
                    if (_e810 < 0f) {
                        phi_1071_ = -(_e810);
                    } else {
                        phi_1071_ = _e810;
                    }
                    let _e814 = phi_1071_;
                    if (_e665 < 0f) {
                        phi_1078_ = -(_e665);
                    } else {
                        phi_1078_ = _e665;
                    }
                    let _e818 = phi_1078_;
                    if (_e677 < 0f) {
                        phi_1084_ = -(_e677);
                    } else {
                        phi_1084_ = _e677;
                    }
                    let _e822 = phi_1084_;
                    if (_e689 < 0f) {
                        phi_1090_ = -(_e689);
                    } else {
                        phi_1090_ = _e689;
                    }
                    let _e826 = phi_1090_;
                    let _e833 = (_e814 - (_e700[1] + (((_e818 * _e695[0]) + (_e822 * _e695[1])) + (_e826 * _e695[2]))));
                    let _e836 = local.member_2[2u];
                    if (_e836 < 0f) {
                        phi_1109_ = -(_e836);
                    } else {
                        phi_1109_ = _e836;
                    }
                    let _e840 = phi_1109_;
                    if (_e669 < 0f) {
                        phi_1116_ = -(_e669);
                    } else {
                        phi_1116_ = _e669;
                    }
                    let _e844 = phi_1116_;
                    if (_e681 < 0f) {
                        phi_1122_ = -(_e681);
                    } else {
                        phi_1122_ = _e681;
                    }
                    let _e848 = phi_1122_;
                    if (_e693 < 0f) {
                        phi_1128_ = -(_e693);
                    } else {
                        phi_1128_ = _e693;
                    }
                    let _e852 = phi_1128_;
                    let _e859 = (_e840 - (_e700[2] + (((_e844 * _e695[0]) + (_e848 * _e695[1])) + (_e852 * _e695[2]))));
                    if (_e729 > _e755) {
                        phi_1143_ = _e729;
                    } else {
                        phi_1143_ = _e755;
                    }
                    let _e862 = phi_1143_;
                    if (_e862 > _e781) {
                        phi_1148_ = _e862;
                    } else {
                        phi_1148_ = _e781;
                    }
                    let _e865 = phi_1148_;
                    if (_e807 > _e833) {
                        phi_1153_ = _e807;
                    } else {
                        phi_1153_ = _e833;
                    }
                    let _e868 = phi_1153_;
                    if (_e868 > _e859) {
                        phi_1158_ = _e868;
                    } else {
                        phi_1158_ = _e859;
                    }
                    let _e871 = phi_1158_;
                    if (_e865 > _e871) {
                        phi_1163_ = _e865;
                    } else {
                        phi_1163_ = _e871;
                    }
                    let _e874 = phi_1163_;
                    let _e876 = local.member_5;
                    if (_e874 > _e876) {
                        phi_2476_ = true;
                    } else {
                        let _e881 = local.member[1u][0u];
                        let _e884 = local.member_1[2u];
                        let _e889 = local.member[2u][0u];
                        let _e892 = local.member_1[1u];
                        let _e894 = ((_e881 * _e884) - (_e889 * _e892));
                        let _e898 = local.member[2u][0u];
                        if (_e898 < 0f) {
                            phi_1222_ = -(_e898);
                        } else {
                            phi_1222_ = _e898;
                        }
                        let _e902 = phi_1222_;
                        let _e905 = local.member_3[1u];
                        let _e910 = local.member[1u][0u];
                        if (_e910 < 0f) {
                            phi_1245_ = -(_e910);
                        } else {
                            phi_1245_ = _e910;
                        }
                        let _e914 = phi_1245_;
                        let _e917 = local.member_3[2u];
                        let _e923 = local.member[0u][2u];
                        if (_e923 < 0f) {
                            phi_1268_ = -(_e923);
                        } else {
                            phi_1268_ = _e923;
                        }
                        let _e927 = phi_1268_;
                        let _e930 = local.member_4[1u];
                        let _e935 = local.member[0u][1u];
                        if (_e935 < 0f) {
                            phi_1290_ = -(_e935);
                        } else {
                            phi_1290_ = _e935;
                        }
                        let _e939 = phi_1290_;
                        let _e942 = local.member_4[2u];
                        if (_e894 < 0f) {
                            phi_1306_ = -(_e894);
                        } else {
                            phi_1306_ = _e894;
                        }
                        let _e948 = phi_1306_;
                        let _e950 = (_e948 - (((_e902 * _e905) + (_e914 * _e917)) + ((_e927 * _e930) + (_e939 * _e942))));
                        let _e954 = local.member[1u][1u];
                        let _e957 = local.member_1[2u];
                        let _e962 = local.member[2u][1u];
                        let _e965 = local.member_1[1u];
                        let _e967 = ((_e954 * _e957) - (_e962 * _e965));
                        let _e971 = local.member[2u][1u];
                        if (_e971 < 0f) {
                            phi_1361_ = -(_e971);
                        } else {
                            phi_1361_ = _e971;
                        }
                        let _e975 = phi_1361_;
                        let _e978 = local.member_3[1u];
                        let _e983 = local.member[1u][1u];
                        if (_e983 < 0f) {
                            phi_1384_ = -(_e983);
                        } else {
                            phi_1384_ = _e983;
                        }
                        let _e987 = phi_1384_;
                        let _e990 = local.member_3[2u];
                        let _e996 = local.member[0u][0u];
                        if (_e996 < 0f) {
                            phi_1407_ = -(_e996);
                        } else {
                            phi_1407_ = _e996;
                        }
                        let _e1000 = phi_1407_;
                        let _e1003 = local.member_4[2u];
                        let _e1008 = local.member[0u][2u];
                        if (_e1008 < 0f) {
                            phi_1429_ = -(_e1008);
                        } else {
                            phi_1429_ = _e1008;
                        }
                        let _e1012 = phi_1429_;
                        let _e1015 = local.member_4[0u];
                        if (_e967 < 0f) {
                            phi_1445_ = -(_e967);
                        } else {
                            phi_1445_ = _e967;
                        }
                        let _e1021 = phi_1445_;
                        let _e1023 = (_e1021 - (((_e975 * _e978) + (_e987 * _e990)) + ((_e1000 * _e1003) + (_e1012 * _e1015))));
                        let _e1027 = local.member[1u][2u];
                        let _e1030 = local.member_1[2u];
                        let _e1035 = local.member[2u][2u];
                        let _e1038 = local.member_1[1u];
                        let _e1040 = ((_e1027 * _e1030) - (_e1035 * _e1038));
                        let _e1044 = local.member[2u][2u];
                        if (_e1044 < 0f) {
                            phi_1500_ = -(_e1044);
                        } else {
                            phi_1500_ = _e1044;
                        }
                        let _e1048 = phi_1500_;
                        let _e1051 = local.member_3[1u];
                        let _e1056 = local.member[1u][2u];
                        if (_e1056 < 0f) {
                            phi_1523_ = -(_e1056);
                        } else {
                            phi_1523_ = _e1056;
                        }
                        let _e1060 = phi_1523_;
                        let _e1063 = local.member_3[2u];
                        let _e1069 = local.member[0u][1u];
                        if (_e1069 < 0f) {
                            phi_1546_ = -(_e1069);
                        } else {
                            phi_1546_ = _e1069;
                        }
                        let _e1073 = phi_1546_;
                        let _e1076 = local.member_4[0u];
                        let _e1081 = local.member[0u][0u];
                        if (_e1081 < 0f) {
                            phi_1568_ = -(_e1081);
                        } else {
                            phi_1568_ = _e1081;
                        }
                        let _e1085 = phi_1568_;
                        let _e1088 = local.member_4[1u];
                        if (_e1040 < 0f) {
                            phi_1584_ = -(_e1040);
                        } else {
                            phi_1584_ = _e1040;
                        }
                        let _e1094 = phi_1584_;
                        let _e1096 = (_e1094 - (((_e1048 * _e1051) + (_e1060 * _e1063)) + ((_e1073 * _e1076) + (_e1085 * _e1088))));
                        let _e1100 = local.member[2u][0u];
                        let _e1103 = local.member_1[0u];
                        let _e1108 = local.member[0u][0u];
                        let _e1111 = local.member_1[2u];
                        let _e1113 = ((_e1100 * _e1103) - (_e1108 * _e1111));
                        let _e1117 = local.member[0u][0u];
                        if (_e1117 < 0f) {
                            phi_1639_ = -(_e1117);
                        } else {
                            phi_1639_ = _e1117;
                        }
                        let _e1121 = phi_1639_;
                        let _e1124 = local.member_3[2u];
                        let _e1129 = local.member[2u][0u];
                        if (_e1129 < 0f) {
                            phi_1662_ = -(_e1129);
                        } else {
                            phi_1662_ = _e1129;
                        }
                        let _e1133 = phi_1662_;
                        let _e1136 = local.member_3[0u];
                        let _e1142 = local.member[1u][2u];
                        if (_e1142 < 0f) {
                            phi_1686_ = -(_e1142);
                        } else {
                            phi_1686_ = _e1142;
                        }
                        let _e1146 = phi_1686_;
                        let _e1149 = local.member_4[1u];
                        let _e1154 = local.member[1u][1u];
                        if (_e1154 < 0f) {
                            phi_1709_ = -(_e1154);
                        } else {
                            phi_1709_ = _e1154;
                        }
                        let _e1158 = phi_1709_;
                        let _e1161 = local.member_4[2u];
                        if (_e1113 < 0f) {
                            phi_1725_ = -(_e1113);
                        } else {
                            phi_1725_ = _e1113;
                        }
                        let _e1167 = phi_1725_;
                        let _e1169 = (_e1167 - (((_e1121 * _e1124) + (_e1133 * _e1136)) + ((_e1146 * _e1149) + (_e1158 * _e1161))));
                        let _e1173 = local.member[2u][1u];
                        let _e1176 = local.member_1[0u];
                        let _e1181 = local.member[0u][1u];
                        let _e1184 = local.member_1[2u];
                        let _e1186 = ((_e1173 * _e1176) - (_e1181 * _e1184));
                        let _e1190 = local.member[0u][1u];
                        if (_e1190 < 0f) {
                            phi_1780_ = -(_e1190);
                        } else {
                            phi_1780_ = _e1190;
                        }
                        let _e1194 = phi_1780_;
                        let _e1197 = local.member_3[2u];
                        let _e1202 = local.member[2u][1u];
                        if (_e1202 < 0f) {
                            phi_1803_ = -(_e1202);
                        } else {
                            phi_1803_ = _e1202;
                        }
                        let _e1206 = phi_1803_;
                        let _e1209 = local.member_3[0u];
                        let _e1215 = local.member[1u][0u];
                        if (_e1215 < 0f) {
                            phi_1827_ = -(_e1215);
                        } else {
                            phi_1827_ = _e1215;
                        }
                        let _e1219 = phi_1827_;
                        let _e1222 = local.member_4[2u];
                        let _e1227 = local.member[1u][2u];
                        if (_e1227 < 0f) {
                            phi_1850_ = -(_e1227);
                        } else {
                            phi_1850_ = _e1227;
                        }
                        let _e1231 = phi_1850_;
                        let _e1234 = local.member_4[0u];
                        if (_e1186 < 0f) {
                            phi_1866_ = -(_e1186);
                        } else {
                            phi_1866_ = _e1186;
                        }
                        let _e1240 = phi_1866_;
                        let _e1242 = (_e1240 - (((_e1194 * _e1197) + (_e1206 * _e1209)) + ((_e1219 * _e1222) + (_e1231 * _e1234))));
                        let _e1246 = local.member[2u][2u];
                        let _e1249 = local.member_1[0u];
                        let _e1254 = local.member[0u][2u];
                        let _e1257 = local.member_1[2u];
                        let _e1259 = ((_e1246 * _e1249) - (_e1254 * _e1257));
                        let _e1263 = local.member[0u][2u];
                        if (_e1263 < 0f) {
                            phi_1921_ = -(_e1263);
                        } else {
                            phi_1921_ = _e1263;
                        }
                        let _e1267 = phi_1921_;
                        let _e1270 = local.member_3[2u];
                        let _e1275 = local.member[2u][2u];
                        if (_e1275 < 0f) {
                            phi_1944_ = -(_e1275);
                        } else {
                            phi_1944_ = _e1275;
                        }
                        let _e1279 = phi_1944_;
                        let _e1282 = local.member_3[0u];
                        let _e1288 = local.member[1u][1u];
                        if (_e1288 < 0f) {
                            phi_1968_ = -(_e1288);
                        } else {
                            phi_1968_ = _e1288;
                        }
                        let _e1292 = phi_1968_;
                        let _e1295 = local.member_4[0u];
                        let _e1300 = local.member[1u][0u];
                        if (_e1300 < 0f) {
                            phi_1991_ = -(_e1300);
                        } else {
                            phi_1991_ = _e1300;
                        }
                        let _e1304 = phi_1991_;
                        let _e1307 = local.member_4[1u];
                        if (_e1259 < 0f) {
                            phi_2007_ = -(_e1259);
                        } else {
                            phi_2007_ = _e1259;
                        }
                        let _e1313 = phi_2007_;
                        let _e1315 = (_e1313 - (((_e1267 * _e1270) + (_e1279 * _e1282)) + ((_e1292 * _e1295) + (_e1304 * _e1307))));
                        let _e1319 = local.member[0u][0u];
                        let _e1322 = local.member_1[1u];
                        let _e1327 = local.member[1u][0u];
                        let _e1330 = local.member_1[0u];
                        let _e1332 = ((_e1319 * _e1322) - (_e1327 * _e1330));
                        let _e1336 = local.member[1u][0u];
                        if (_e1336 < 0f) {
                            phi_2062_ = -(_e1336);
                        } else {
                            phi_2062_ = _e1336;
                        }
                        let _e1340 = phi_2062_;
                        let _e1343 = local.member_3[0u];
                        let _e1348 = local.member[0u][0u];
                        if (_e1348 < 0f) {
                            phi_2085_ = -(_e1348);
                        } else {
                            phi_2085_ = _e1348;
                        }
                        let _e1352 = phi_2085_;
                        let _e1355 = local.member_3[1u];
                        let _e1361 = local.member[2u][2u];
                        if (_e1361 < 0f) {
                            phi_2109_ = -(_e1361);
                        } else {
                            phi_2109_ = _e1361;
                        }
                        let _e1365 = phi_2109_;
                        let _e1368 = local.member_4[1u];
                        let _e1373 = local.member[2u][1u];
                        if (_e1373 < 0f) {
                            phi_2132_ = -(_e1373);
                        } else {
                            phi_2132_ = _e1373;
                        }
                        let _e1377 = phi_2132_;
                        let _e1380 = local.member_4[2u];
                        if (_e1332 < 0f) {
                            phi_2148_ = -(_e1332);
                        } else {
                            phi_2148_ = _e1332;
                        }
                        let _e1386 = phi_2148_;
                        let _e1388 = (_e1386 - (((_e1340 * _e1343) + (_e1352 * _e1355)) + ((_e1365 * _e1368) + (_e1377 * _e1380))));
                        let _e1392 = local.member[0u][1u];
                        let _e1395 = local.member_1[1u];
                        let _e1400 = local.member[1u][1u];
                        let _e1403 = local.member_1[0u];
                        let _e1405 = ((_e1392 * _e1395) - (_e1400 * _e1403));
                        let _e1409 = local.member[1u][1u];
                        if (_e1409 < 0f) {
                            phi_2203_ = -(_e1409);
                        } else {
                            phi_2203_ = _e1409;
                        }
                        let _e1413 = phi_2203_;
                        let _e1416 = local.member_3[0u];
                        let _e1421 = local.member[0u][1u];
                        if (_e1421 < 0f) {
                            phi_2226_ = -(_e1421);
                        } else {
                            phi_2226_ = _e1421;
                        }
                        let _e1425 = phi_2226_;
                        let _e1428 = local.member_3[1u];
                        let _e1434 = local.member[2u][0u];
                        if (_e1434 < 0f) {
                            phi_2250_ = -(_e1434);
                        } else {
                            phi_2250_ = _e1434;
                        }
                        let _e1438 = phi_2250_;
                        let _e1441 = local.member_4[2u];
                        let _e1446 = local.member[2u][2u];
                        if (_e1446 < 0f) {
                            phi_2273_ = -(_e1446);
                        } else {
                            phi_2273_ = _e1446;
                        }
                        let _e1450 = phi_2273_;
                        let _e1453 = local.member_4[0u];
                        if (_e1405 < 0f) {
                            phi_2289_ = -(_e1405);
                        } else {
                            phi_2289_ = _e1405;
                        }
                        let _e1459 = phi_2289_;
                        let _e1461 = (_e1459 - (((_e1413 * _e1416) + (_e1425 * _e1428)) + ((_e1438 * _e1441) + (_e1450 * _e1453))));
                        let _e1465 = local.member[0u][2u];
                        let _e1468 = local.member_1[1u];
                        let _e1473 = local.member[1u][2u];
                        let _e1476 = local.member_1[0u];
                        let _e1478 = ((_e1465 * _e1468) - (_e1473 * _e1476));
                        let _e1482 = local.member[1u][2u];
                        if (_e1482 < 0f) {
                            phi_2344_ = -(_e1482);
                        } else {
                            phi_2344_ = _e1482;
                        }
                        let _e1486 = phi_2344_;
                        let _e1489 = local.member_3[0u];
                        let _e1494 = local.member[0u][2u];
                        if (_e1494 < 0f) {
                            phi_2367_ = -(_e1494);
                        } else {
                            phi_2367_ = _e1494;
                        }
                        let _e1498 = phi_2367_;
                        let _e1501 = local.member_3[1u];
                        let _e1507 = local.member[2u][1u];
                        if (_e1507 < 0f) {
                            phi_2391_ = -(_e1507);
                        } else {
                            phi_2391_ = _e1507;
                        }
                        let _e1511 = phi_2391_;
                        let _e1514 = local.member_4[0u];
                        let _e1519 = local.member[2u][0u];
                        if (_e1519 < 0f) {
                            phi_2414_ = -(_e1519);
                        } else {
                            phi_2414_ = _e1519;
                        }
                        let _e1523 = phi_2414_;
                        let _e1526 = local.member_4[1u];
                        if (_e1478 < 0f) {
                            phi_2430_ = -(_e1478);
                        } else {
                            phi_2430_ = _e1478;
                        }
                        let _e1532 = phi_2430_;
                        let _e1534 = (_e1532 - (((_e1486 * _e1489) + (_e1498 * _e1501)) + ((_e1511 * _e1514) + (_e1523 * _e1526))));
                        if (_e950 > _e1023) {
                            phi_2437_ = _e950;
                        } else {
                            phi_2437_ = _e1023;
                        }
                        let _e1537 = phi_2437_;
                        if (_e1537 > _e1096) {
                            phi_2442_ = _e1537;
                        } else {
                            phi_2442_ = _e1096;
                        }
                        let _e1540 = phi_2442_;
                        if (_e1169 > _e1242) {
                            phi_2447_ = _e1169;
                        } else {
                            phi_2447_ = _e1242;
                        }
                        let _e1543 = phi_2447_;
                        if (_e1543 > _e1315) {
                            phi_2452_ = _e1543;
                        } else {
                            phi_2452_ = _e1315;
                        }
                        let _e1546 = phi_2452_;
                        if (_e1540 > _e1546) {
                            phi_2457_ = _e1540;
                        } else {
                            phi_2457_ = _e1546;
                        }
                        let _e1549 = phi_2457_;
                        if (_e1388 > _e1461) {
                            phi_2462_ = _e1388;
                        } else {
                            phi_2462_ = _e1461;
                        }
                        let _e1552 = phi_2462_;
                        if (_e1552 > _e1534) {
                            phi_2467_ = _e1552;
                        } else {
                            phi_2467_ = _e1534;
                        }
                        let _e1555 = phi_2467_;
                        if (_e1549 > _e1555) {
                            phi_2472_ = _e1549;
                        } else {
                            phi_2472_ = _e1555;
                        }
                        let _e1558 = phi_2472_;
                        let _e1560 = local.member_5;
                        phi_2476_ = (_e1558 > _e1560);
                    }
                    let _e1563 = phi_2476_;
                    phi_2478_ = !(_e1563);
                    phi_2479_ = false;
                } else {
                    phi_2478_ = bool();
                    phi_2479_ = true;
                }
                let _e1566 = phi_2478_;
                let _e1568 = phi_2479_;
                phi_2480_ = _e1566;
                phi_2481_ = _e1568;
            }
            let _e1570 = phi_2480_;
            let _e1572 = phi_2481_;
            if _e1572 {
                phi_2485_ = true;
            } else {
                phi_2485_ = _e1570;
            }
            let _e1574 = phi_2485_;
            if _e1574 {
                if (_e107 == 4294967295u) {
                    phi_2507_ = 0u;
                } else {
                    if (_e107 >= _e76) {
                        if (_e110 >= _e81) {
                            phi_2501_ = false;
                        } else {
                            phi_2501_ = true;
                        }
                        let _e1579 = phi_2501_;
                        phi_2502_ = _e1579;
                    } else {
                        phi_2502_ = true;
                    }
                    let _e1581 = phi_2502_;
                    if _e1581 {
                        phi_2506_ = 1u;
                    } else {
                        phi_2506_ = 2u;
                    }
                    let _e1583 = phi_2506_;
                    phi_2507_ = _e1583;
                }
                let _e1585 = phi_2507_;
                phi_2508_ = _e1585;
            } else {
                phi_2508_ = 3u;
            }
            let _e1587 = phi_2508_;
            phi_2509_ = _e1587;
        } else {
            phi_2509_ = 3u;
        }
        let _e1589 = phi_2509_;
        phi_2510_ = _e1589;
        phi_2511_ = array<u32, 2>(_e107, _e110);
    } else {
        phi_2510_ = 0u;
        phi_2511_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e1591 = phi_2510_;
    let _e1593 = phi_2511_;
    if (_e1591 == 1u) {
        let _e1603 = atomicAdd((&shared_[6u]), 1u);
        phi_2529_ = array<u32, 2>(_e1603, 0u);
    } else {
        if (_e1591 == 2u) {
            let _e1598 = atomicAdd((&shared_[7u]), 1u);
            phi_2528_ = array<u32, 2>(_e1598, 0u);
        } else {
            phi_2528_ = array<u32, 2>(0u, 0u);
        }
        let _e1601 = phi_2528_;
        phi_2529_ = _e1601;
    }
    let _e1606 = phi_2529_;
    if (_e1591 >= 2u) {
        if (_e65.member_4 > 0u) {
            let _e1610 = atomicAdd((&shared_[8u]), 1u);
            phi_2541_ = array<u32, 2>(_e1606[0], _e1610);
        } else {
            phi_2541_ = _e1606;
        }
        let _e1614 = phi_2541_;
        phi_2542_ = _e1614;
    } else {
        phi_2542_ = _e1606;
    }
    let _e1616 = phi_2542_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e1619 = atomicLoad((&shared_[6u]));
        let _e1621 = atomicLoad((&shared_[7u]));
        if (_e1619 > 0u) {
            let _e1624 = atomicAdd((&control.member[0u]), _e1619);
            let _e1627 = atomicMax((&nodes.member[0u]), (_e1624 + _e1619));
            if ((_e1624 + _e1619) < _e1624) {
                let _e1631 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e1624);
        }
        if (_e1621 > 0u) {
            let _e1635 = atomicAdd((&pairs.member[0u]), _e1621);
            if ((_e1635 + _e1621) < _e1635) {
                let _e1639 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e1635);
        }
        let _e1642 = atomicLoad((&shared_[8u]));
        if (_e1642 > 0u) {
            let _e1645 = atomicLoad((&shared_[8u]));
            let _e1647 = atomicAdd((&control.member[1537u]), _e1645);
            if ((_e1647 + _e1645) < _e1647) {
                let _e1651 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e1647);
        }
    }
    workgroupBarrier();
    if (_e1591 == 1u) {
        let _e1716 = atomicLoad((&shared_[11u]));
        let _e1718 = (_e1716 + _e1616[0]);
        if (_e1718 < _e65.member_3) {
            if (_e1718 < 4294967295u) {
                let _e1724 = (2u * _e1718);
                atomicStore((&nodes.member[(4u + _e1724)]), _e1593[0]);
                atomicStore((&nodes.member[(_e1724 + 5u)]), _e1593[1]);
            }
        }
    } else {
        if (_e1591 == 0u) {
        } else {
            if (_e1591 == 2u) {
                let _e1658 = a_nodes.member[_e1593[0]];
                let _e1662 = b_nodes.member[_e1593[1]];
                let _e1666 = params.member.member_2.member;
                if (_e1666 == 1u) {
                    if (_e1658.member_1 < _e1662.member_1) {
                        phi_2680_ = type_12(_e1658.member_1, _e1662.member_1);
                    } else {
                        phi_2680_ = type_12(_e1662.member_1, _e1658.member_1);
                    }
                    let _e1673 = phi_2680_;
                    phi_2685_ = _e1673;
                } else {
                    phi_2685_ = type_12(_e1658.member_1, _e1662.member_1);
                }
                let _e1675 = phi_2685_;
                let _e1678 = params.member.member_1.member_3;
                let _e1680 = atomicLoad((&shared_[12u]));
                let _e1682 = (_e1680 + _e1616[0]);
                if (_e1682 < _e1678) {
                    let _e1686 = (2u * _e1682);
                    atomicStore((&pairs.member[(4u + _e1686)]), _e1675.member);
                    atomicStore((&pairs.member[(_e1686 + 5u)]), _e1675.member_1);
                }
            }
            let _e1693 = params.member.member_2.member_4;
            if (_e1693 > 0u) {
                let _e1697 = atomicLoad((&shared_[13u]));
                let _e1699 = (_e1697 + _e1616[1]);
                let _e1701 = params.member.member_2.member_4;
                if (_e1699 < _e1701) {
                    let _e1704 = params.member.member_2.member_5;
                    let _e1706 = params.member.member_2.member_4;
                    let _e1709 = (2u * ((_e1704 * _e1706) + _e1699));
                    front.member[_e1709] = _e1593[0];
                    front.member[(_e1709 + 1u)] = _e1593[1];
                }
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn resume_front_oriented(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
