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
@group(0) @binding(7) 
var<storage, read_write> front: type_11;
@group(0) @binding(3) 
var<storage> oriented: type_25;
@group(0) @binding(4) 
var<storage, read_write> control: type_29;
var<workgroup> shared_: array<atomic<u32>, 22>;
@group(0) @binding(5) 
var<storage, read_write> nodes: type_29;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_21;
    var phi_164_: array<u32, 2>;
    var phi_246_: array<u32, 2>;
    var phi_274_: array<u32, 2>;
    var phi_299_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_385_: f32;
    var phi_391_: f32;
    var phi_397_: f32;
    var phi_403_: f32;
    var phi_409_: f32;
    var phi_415_: f32;
    var phi_433_: f32;
    var phi_438_: f32;
    var phi_443_: f32;
    var phi_459_: type_26;
    var phi_529_: f32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_559_: f32;
    var phi_577_: f32;
    var phi_582_: f32;
    var phi_587_: f32;
    var phi_603_: type_26;
    var phi_793_: f32;
    var phi_799_: f32;
    var phi_806_: f32;
    var phi_815_: f32;
    var phi_822_: f32;
    var phi_830_: f32;
    var phi_839_: f32;
    var phi_846_: f32;
    var phi_854_: f32;
    var phi_947_: f32;
    var phi_954_: f32;
    var phi_960_: f32;
    var phi_966_: f32;
    var phi_985_: f32;
    var phi_992_: f32;
    var phi_998_: f32;
    var phi_1004_: f32;
    var phi_1023_: f32;
    var phi_1030_: f32;
    var phi_1036_: f32;
    var phi_1042_: f32;
    var phi_1061_: f32;
    var phi_1068_: f32;
    var phi_1074_: f32;
    var phi_1080_: f32;
    var phi_1099_: f32;
    var phi_1106_: f32;
    var phi_1112_: f32;
    var phi_1118_: f32;
    var phi_1137_: f32;
    var phi_1144_: f32;
    var phi_1150_: f32;
    var phi_1156_: f32;
    var phi_1171_: f32;
    var phi_1176_: f32;
    var phi_1181_: f32;
    var phi_1186_: f32;
    var phi_1191_: f32;
    var phi_1250_: f32;
    var phi_1273_: f32;
    var phi_1296_: f32;
    var phi_1318_: f32;
    var phi_1334_: f32;
    var phi_1389_: f32;
    var phi_1412_: f32;
    var phi_1435_: f32;
    var phi_1457_: f32;
    var phi_1473_: f32;
    var phi_1528_: f32;
    var phi_1551_: f32;
    var phi_1574_: f32;
    var phi_1596_: f32;
    var phi_1612_: f32;
    var phi_1667_: f32;
    var phi_1690_: f32;
    var phi_1714_: f32;
    var phi_1737_: f32;
    var phi_1753_: f32;
    var phi_1808_: f32;
    var phi_1831_: f32;
    var phi_1855_: f32;
    var phi_1878_: f32;
    var phi_1894_: f32;
    var phi_1949_: f32;
    var phi_1972_: f32;
    var phi_1996_: f32;
    var phi_2019_: f32;
    var phi_2035_: f32;
    var phi_2090_: f32;
    var phi_2113_: f32;
    var phi_2137_: f32;
    var phi_2160_: f32;
    var phi_2176_: f32;
    var phi_2231_: f32;
    var phi_2254_: f32;
    var phi_2278_: f32;
    var phi_2301_: f32;
    var phi_2317_: f32;
    var phi_2372_: f32;
    var phi_2395_: f32;
    var phi_2419_: f32;
    var phi_2442_: f32;
    var phi_2458_: f32;
    var phi_2465_: f32;
    var phi_2470_: f32;
    var phi_2475_: f32;
    var phi_2480_: f32;
    var phi_2485_: f32;
    var phi_2490_: f32;
    var phi_2495_: f32;
    var phi_2500_: f32;
    var phi_2504_: bool;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var phi_2513_: bool;
    var phi_2526_: array<u32, 2>;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2565_: u32;
    var phi_2566_: u32;
    var phi_2567_: u32;
    var phi_2568_: u32;
    var phi_2569_: u32;
    var phi_2586_: array<u32, 2>;
    var phi_2587_: array<u32, 2>;
    var phi_2599_: array<u32, 2>;
    var phi_2600_: array<u32, 2>;
    var phi_2739_: type_9;
    var phi_2744_: type_9;
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
    let _e68 = params.member.member_1.member;
    if (_e63 < _e68) {
        let _e75 = (2u * (((1u - _e65.member_5) * _e65.member_4) + _e63));
        let _e77 = front.member[_e75];
        let _e80 = front.member[(_e75 + 1u)];
        phi_164_ = array<u32, 2>(_e77, _e80);
    } else {
        phi_164_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e83 = phi_164_;
    let _e85 = params.member.member_2;
    if (_e48 == 0u) {
        atomicStore((&shared_[6u]), 0u);
        atomicStore((&shared_[7u]), 0u);
        atomicStore((&shared_[8u]), 0u);
    }
    workgroupBarrier();
    if (_e83[0] != 4294967295u) {
        let _e94 = a_nodes.member[_e83[0]];
        let _e97 = b_nodes.member[_e83[1]];
        if ((((((_e94.member[0] <= _e97.member_2[0]) && (_e97.member[0] <= _e94.member_2[0])) && (_e94.member[1] <= _e97.member_2[1])) && (_e97.member[1] <= _e94.member_2[1])) && (_e94.member[2] <= _e97.member_2[2])) && (_e97.member[2] <= _e94.member_2[2])) {
            let _e127 = params.member.member_2.member;
            let _e131 = params.member.member_2.member;
            if (_e131 == 0u) {
                phi_246_ = array<u32, 2>(0u, 2u);
            } else {
                phi_246_ = array<u32, 2>(1u, 1u);
            }
            let _e134 = phi_246_;
            let _e140 = params.member.member.member[_e134[0]];
            let _e141 = (_e140 - 1u);
            let _e145 = params.member.member.member[_e134[1]];
            let _e146 = (_e145 - 1u);
            let _e149 = params.member.member_2.member;
            if (_e149 == 0u) {
                phi_274_ = array<u32, 2>(0u, 2u);
            } else {
                phi_274_ = array<u32, 2>(1u, 1u);
            }
            let _e152 = phi_274_;
            let _e158 = params.member.member.member_2[_e152[0]];
            let _e162 = params.member.member.member_2[_e152[1]];
            if (_e127 == 1u) {
                phi_299_ = (_e83[0] == _e83[1]);
            } else {
                phi_299_ = false;
            }
            let _e167 = phi_299_;
            if _e167 {
                phi_2508_ = bool();
                phi_2509_ = true;
            } else {
                if (_e83[0] >= _e141) {
                    if (_e83[1] >= _e146) {
                        phi_311_ = false;
                    } else {
                        phi_311_ = true;
                    }
                    let _e171 = phi_311_;
                    phi_312_ = _e171;
                } else {
                    phi_312_ = true;
                }
                let _e173 = phi_312_;
                if _e173 {
                    if (_e83[0] < _e141) {
                        let _e253 = oriented.member[(_e158 + _e83[0])];
                        phi_459_ = type_26(array<f32, 3>(_e253.member.x, _e253.member.y, _e253.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e253.member.w, _e253.member_1.x, _e253.member_1.y), array<f32, 3>(_e253.member_1.z, _e253.member_1.w, _e253.member_2.x), array<f32, 3>(_e253.member_2.y, _e253.member_2.z, _e253.member_2.w)), array<f32, 3>(_e253.member_3.x, _e253.member_3.y, _e253.member_3.z));
                    } else {
                        let _e176 = a_nodes.member[_e83[0]];
                        let _e191 = ((_e176.member[0] * 0.5f) + (_e176.member_2[0] * 0.5f));
                        let _e192 = ((_e176.member[1] * 0.5f) + (_e176.member_2[1] * 0.5f));
                        let _e193 = ((_e176.member[2] * 0.5f) + (_e176.member_2[2] * 0.5f));
                        if (_e191 < _e176.member_2[0]) {
                            phi_385_ = _e191;
                        } else {
                            phi_385_ = _e176.member_2[0];
                        }
                        let _e197 = phi_385_;
                        if (_e192 < _e176.member_2[1]) {
                            phi_391_ = _e192;
                        } else {
                            phi_391_ = _e176.member_2[1];
                        }
                        let _e201 = phi_391_;
                        if (_e193 < _e176.member_2[2]) {
                            phi_397_ = _e193;
                        } else {
                            phi_397_ = _e176.member_2[2];
                        }
                        let _e205 = phi_397_;
                        if (_e197 > _e176.member[0]) {
                            phi_403_ = _e197;
                        } else {
                            phi_403_ = _e176.member[0];
                        }
                        let _e209 = phi_403_;
                        if (_e201 > _e176.member[1]) {
                            phi_409_ = _e201;
                        } else {
                            phi_409_ = _e176.member[1];
                        }
                        let _e213 = phi_409_;
                        if (_e205 > _e176.member[2]) {
                            phi_415_ = _e205;
                        } else {
                            phi_415_ = _e176.member[2];
                        }
                        let _e217 = phi_415_;
                        let _e220 = (_e176.member_2[0] - _e209);
                        let _e222 = (_e176.member_2[1] - _e213);
                        let _e224 = (_e176.member_2[2] - _e217);
                        let _e226 = (_e209 - _e176.member[0]);
                        let _e228 = (_e213 - _e176.member[1]);
                        let _e230 = (_e217 - _e176.member[2]);
                        if (_e220 > _e226) {
                            phi_433_ = _e220;
                        } else {
                            phi_433_ = _e226;
                        }
                        let _e233 = phi_433_;
                        if (_e222 > _e228) {
                            phi_438_ = _e222;
                        } else {
                            phi_438_ = _e228;
                        }
                        let _e236 = phi_438_;
                        if (_e224 > _e230) {
                            phi_443_ = _e224;
                        } else {
                            phi_443_ = _e230;
                        }
                        let _e239 = phi_443_;
                        let _e241 = (1f + (0.000000059604645f * 4f));
                        let _e245 = (0.000000000000000000000000000000000000011754944f * 8f);
                        phi_459_ = type_26(array<f32, 3>(_e209, _e213, _e217), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e233 * _e241) + _e245), ((_e236 * _e241) + _e245), ((_e239 * _e241) + _e245)));
                    }
                    let _e292 = phi_459_;
                    if (_e83[1] < _e146) {
                        let _e372 = oriented.member[(_e162 + _e83[1])];
                        phi_603_ = type_26(array<f32, 3>(_e372.member.x, _e372.member.y, _e372.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e372.member.w, _e372.member_1.x, _e372.member_1.y), array<f32, 3>(_e372.member_1.z, _e372.member_1.w, _e372.member_2.x), array<f32, 3>(_e372.member_2.y, _e372.member_2.z, _e372.member_2.w)), array<f32, 3>(_e372.member_3.x, _e372.member_3.y, _e372.member_3.z));
                    } else {
                        let _e295 = b_nodes.member[_e83[1]];
                        let _e310 = ((_e295.member[0] * 0.5f) + (_e295.member_2[0] * 0.5f));
                        let _e311 = ((_e295.member[1] * 0.5f) + (_e295.member_2[1] * 0.5f));
                        let _e312 = ((_e295.member[2] * 0.5f) + (_e295.member_2[2] * 0.5f));
                        if (_e310 < _e295.member_2[0]) {
                            phi_529_ = _e310;
                        } else {
                            phi_529_ = _e295.member_2[0];
                        }
                        let _e316 = phi_529_;
                        if (_e311 < _e295.member_2[1]) {
                            phi_535_ = _e311;
                        } else {
                            phi_535_ = _e295.member_2[1];
                        }
                        let _e320 = phi_535_;
                        if (_e312 < _e295.member_2[2]) {
                            phi_541_ = _e312;
                        } else {
                            phi_541_ = _e295.member_2[2];
                        }
                        let _e324 = phi_541_;
                        if (_e316 > _e295.member[0]) {
                            phi_547_ = _e316;
                        } else {
                            phi_547_ = _e295.member[0];
                        }
                        let _e328 = phi_547_;
                        if (_e320 > _e295.member[1]) {
                            phi_553_ = _e320;
                        } else {
                            phi_553_ = _e295.member[1];
                        }
                        let _e332 = phi_553_;
                        if (_e324 > _e295.member[2]) {
                            phi_559_ = _e324;
                        } else {
                            phi_559_ = _e295.member[2];
                        }
                        let _e336 = phi_559_;
                        let _e339 = (_e295.member_2[0] - _e328);
                        let _e341 = (_e295.member_2[1] - _e332);
                        let _e343 = (_e295.member_2[2] - _e336);
                        let _e345 = (_e328 - _e295.member[0]);
                        let _e347 = (_e332 - _e295.member[1]);
                        let _e349 = (_e336 - _e295.member[2]);
                        if (_e339 > _e345) {
                            phi_577_ = _e339;
                        } else {
                            phi_577_ = _e345;
                        }
                        let _e352 = phi_577_;
                        if (_e341 > _e347) {
                            phi_582_ = _e341;
                        } else {
                            phi_582_ = _e347;
                        }
                        let _e355 = phi_582_;
                        if (_e343 > _e349) {
                            phi_587_ = _e343;
                        } else {
                            phi_587_ = _e349;
                        }
                        let _e358 = phi_587_;
                        let _e360 = (1f + (0.000000059604645f * 4f));
                        let _e364 = (0.000000000000000000000000000000000000011754944f * 8f);
                        phi_603_ = type_26(array<f32, 3>(_e328, _e332, _e336), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e352 * _e360) + _e364), ((_e355 * _e360) + _e364), ((_e358 * _e360) + _e364)));
                    }
                    let _e411 = phi_603_;
                    let _e416 = (_e411.member[0] - _e292.member[0]);
                    let _e419 = (_e411.member[1] - _e292.member[1]);
                    let _e422 = (_e411.member[2] - _e292.member[2]);
                    if (_e416 < 0f) {
                        phi_793_ = -(_e416);
                    } else {
                        phi_793_ = _e416;
                    }
                    let _e611 = phi_793_;
                    if (_e419 < 0f) {
                        phi_799_ = -(_e419);
                    } else {
                        phi_799_ = _e419;
                    }
                    let _e615 = phi_799_;
                    if (_e422 < 0f) {
                        phi_806_ = -(_e422);
                    } else {
                        phi_806_ = _e422;
                    }
                    let _e620 = phi_806_;
                    if (_e292.member_2[0] < 0f) {
                        phi_815_ = -(_e292.member_2[0]);
                    } else {
                        phi_815_ = _e292.member_2[0];
                    }
                    let _e627 = phi_815_;
                    if (_e292.member_2[1] < 0f) {
                        phi_822_ = -(_e292.member_2[1]);
                    } else {
                        phi_822_ = _e292.member_2[1];
                    }
                    let _e632 = phi_822_;
                    if (_e292.member_2[2] < 0f) {
                        phi_830_ = -(_e292.member_2[2]);
                    } else {
                        phi_830_ = _e292.member_2[2];
                    }
                    let _e638 = phi_830_;
                    if (_e411.member_2[0] < 0f) {
                        phi_839_ = -(_e411.member_2[0]);
                    } else {
                        phi_839_ = _e411.member_2[0];
                    }
                    let _e645 = phi_839_;
                    if (_e411.member_2[1] < 0f) {
                        phi_846_ = -(_e411.member_2[1]);
                    } else {
                        phi_846_ = _e411.member_2[1];
                    }
                    let _e650 = phi_846_;
                    if (_e411.member_2[2] < 0f) {
                        phi_854_ = -(_e411.member_2[2]);
                    } else {
                        phi_854_ = _e411.member_2[2];
                    }
                    let _e656 = phi_854_;
                    local = type_21(array<array<f32, 3>, 3>(array<f32, 3>((((_e411.member_1[0][0] * _e292.member_1[0][0]) + (_e411.member_1[0][1] * _e292.member_1[0][1])) + (_e411.member_1[0][2] * _e292.member_1[0][2])), (((_e411.member_1[1][0] * _e292.member_1[0][0]) + (_e411.member_1[1][1] * _e292.member_1[0][1])) + (_e411.member_1[1][2] * _e292.member_1[0][2])), (((_e411.member_1[2][0] * _e292.member_1[0][0]) + (_e411.member_1[2][1] * _e292.member_1[0][1])) + (_e411.member_1[2][2] * _e292.member_1[0][2]))), array<f32, 3>((((_e411.member_1[0][0] * _e292.member_1[1][0]) + (_e411.member_1[0][1] * _e292.member_1[1][1])) + (_e411.member_1[0][2] * _e292.member_1[1][2])), (((_e411.member_1[1][0] * _e292.member_1[1][0]) + (_e411.member_1[1][1] * _e292.member_1[1][1])) + (_e411.member_1[1][2] * _e292.member_1[1][2])), (((_e411.member_1[2][0] * _e292.member_1[1][0]) + (_e411.member_1[2][1] * _e292.member_1[1][1])) + (_e411.member_1[2][2] * _e292.member_1[1][2]))), array<f32, 3>((((_e411.member_1[0][0] * _e292.member_1[2][0]) + (_e411.member_1[0][1] * _e292.member_1[2][1])) + (_e411.member_1[0][2] * _e292.member_1[2][2])), (((_e411.member_1[1][0] * _e292.member_1[2][0]) + (_e411.member_1[1][1] * _e292.member_1[2][1])) + (_e411.member_1[1][2] * _e292.member_1[2][2])), (((_e411.member_1[2][0] * _e292.member_1[2][0]) + (_e411.member_1[2][1] * _e292.member_1[2][1])) + (_e411.member_1[2][2] * _e292.member_1[2][2])))), array<f32, 3>((((_e292.member_1[0][0] * _e416) + (_e292.member_1[0][1] * _e419)) + (_e292.member_1[0][2] * _e422)), (((_e292.member_1[1][0] * _e416) + (_e292.member_1[1][1] * _e419)) + (_e292.member_1[1][2] * _e422)), (((_e292.member_1[2][0] * _e416) + (_e292.member_1[2][1] * _e419)) + (_e292.member_1[2][2] * _e422))), array<f32, 3>((((_e411.member_1[0][0] * _e416) + (_e411.member_1[0][1] * _e419)) + (_e411.member_1[0][2] * _e422)), (((_e411.member_1[1][0] * _e416) + (_e411.member_1[1][1] * _e419)) + (_e411.member_1[1][2] * _e422)), (((_e411.member_1[2][0] * _e416) + (_e411.member_1[2][1] * _e419)) + (_e411.member_1[2][2] * _e422))), array<f32, 3>(_e292.member_2[0], _e292.member_2[1], _e292.member_2[2]), array<f32, 3>(_e411.member_2[0], _e411.member_2[1], _e411.member_2[2]), ((((((_e611 + _e615) + _e620) + (((_e627 + _e632) + _e638) + ((_e645 + _e650) + _e656))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                    let _e683 = local.member[0u][0u];
                    let _e687 = local.member[0u][1u];
                    let _e691 = local.member[0u][2u];
                    let _e695 = local.member[1u][0u];
                    let _e699 = local.member[1u][1u];
                    let _e703 = local.member[1u][2u];
                    let _e707 = local.member[2u][0u];
                    let _e711 = local.member[2u][1u];
                    let _e715 = local.member[2u][2u];
                    let _e717 = local.member_3;
                    let _e722 = local.member_4;
                    let _e728 = local.member_1[0u];
                    if (_e728 < 0f) {
                        phi_947_ = -(_e728);
                    } else {
                        phi_947_ = _e728;
                    }
                    let _e732 = phi_947_;
                    if (_e683 < 0f) {
                        phi_954_ = -(_e683);
                    } else {
                        phi_954_ = _e683;
                    }
                    let _e736 = phi_954_;
                    if (_e687 < 0f) {
                        phi_960_ = -(_e687);
                    } else {
                        phi_960_ = _e687;
                    }
                    let _e740 = phi_960_;
                    if (_e691 < 0f) {
                        phi_966_ = -(_e691);
                    } else {
                        phi_966_ = _e691;
                    }
                    let _e744 = phi_966_;
                    let _e751 = (_e732 - (_e717[0] + (((_e736 * _e722[0]) + (_e740 * _e722[1])) + (_e744 * _e722[2]))));
                    let _e754 = local.member_1[1u];
                    if (_e754 < 0f) {
                        phi_985_ = -(_e754);
                    } else {
                        phi_985_ = _e754;
                    }
                    let _e758 = phi_985_;
                    if (_e695 < 0f) {
                        phi_992_ = -(_e695);
                    } else {
                        phi_992_ = _e695;
                    }
                    let _e762 = phi_992_;
                    if (_e699 < 0f) {
                        phi_998_ = -(_e699);
                    } else {
                        phi_998_ = _e699;
                    }
                    let _e766 = phi_998_;
                    if (_e703 < 0f) {
                        phi_1004_ = -(_e703);
                    } else {
                        phi_1004_ = _e703;
                    }
                    let _e770 = phi_1004_;
                    let _e777 = (_e758 - (_e717[1] + (((_e762 * _e722[0]) + (_e766 * _e722[1])) + (_e770 * _e722[2]))));
                    let _e780 = local.member_1[2u];
                    if (_e780 < 0f) {
                        phi_1023_ = -(_e780);
                    } else {
                        phi_1023_ = _e780;
                    }
                    let _e784 = phi_1023_;
                    if (_e707 < 0f) {
                        phi_1030_ = -(_e707);
                    } else {
                        phi_1030_ = _e707;
                    }
                    let _e788 = phi_1030_;
                    if (_e711 < 0f) {
                        phi_1036_ = -(_e711);
                    } else {
                        phi_1036_ = _e711;
                    }
                    let _e792 = phi_1036_;
                    if (_e715 < 0f) {
                        phi_1042_ = -(_e715);
                    } else {
                        phi_1042_ = _e715;
                    }
                    let _e796 = phi_1042_;
                    let _e803 = (_e784 - (_e717[2] + (((_e788 * _e722[0]) + (_e792 * _e722[1])) + (_e796 * _e722[2]))));
                    let _e806 = local.member_2[0u];
                    if (_e806 < 0f) {
                        phi_1061_ = -(_e806);
                    } else {
                        phi_1061_ = _e806;
                    }
                    let _e810 = phi_1061_;
                    if (_e683 < 0f) {
                        phi_1068_ = -(_e683);
                    } else {
                        phi_1068_ = _e683;
                    }
                    let _e814 = phi_1068_;
                    if (_e695 < 0f) {
                        phi_1074_ = -(_e695);
                    } else {
                        phi_1074_ = _e695;
                    }
                    let _e818 = phi_1074_;
                    if (_e707 < 0f) {
                        phi_1080_ = -(_e707);
                    } else {
                        phi_1080_ = _e707;
                    }
                    let _e822 = phi_1080_;
                    let _e829 = (_e810 - (_e722[0] + (((_e814 * _e717[0]) + (_e818 * _e717[1])) + (_e822 * _e717[2]))));
                    let _e832 = local.member_2[1u];
                    if (_e832 < 0f) {
                        phi_1099_ = -(_e832);
                    } else {
                        phi_1099_ = _e832;
                    }
                    let _e836 = phi_1099_;
                    if (_e687 < 0f) {
                        phi_1106_ = -(_e687);
                    } else {
                        phi_1106_ = _e687;
                    }
                    let _e840 = phi_1106_;
                    if (_e699 < 0f) {
                        phi_1112_ = -(_e699);
                    } else {
                        phi_1112_ = _e699;
                    }
                    let _e844 = phi_1112_;
                    if (_e711 < 0f) {
                        phi_1118_ = -(_e711);
                    } else {
                        phi_1118_ = _e711;
                    }
                    let _e848 = phi_1118_;
                    let _e855 = (_e836 - (_e722[1] + (((_e840 * _e717[0]) + (_e844 * _e717[1])) + (_e848 * _e717[2]))));
                    let _e858 = local.member_2[2u];
                    if (_e858 < 0f) {
                        phi_1137_ = -(_e858);
                    } else {
                        phi_1137_ = _e858;
                    }
                    let _e862 = phi_1137_;
                    if (_e691 < 0f) {
                        phi_1144_ = -(_e691);
                    } else {
                        phi_1144_ = _e691;
                    }
                    let _e866 = phi_1144_;
                    if (_e703 < 0f) {
                        phi_1150_ = -(_e703);
                    } else {
                        phi_1150_ = _e703;
                    }
                    let _e870 = phi_1150_;
                    if (_e715 < 0f) {
                        phi_1156_ = -(_e715);
                    } else {
                        phi_1156_ = _e715;
                    }
                    let _e874 = phi_1156_;
                    let _e881 = (_e862 - (_e722[2] + (((_e866 * _e717[0]) + (_e870 * _e717[1])) + (_e874 * _e717[2]))));
                    if (_e751 > _e777) {
                        phi_1171_ = _e751;
                    } else {
                        phi_1171_ = _e777;
                    }
                    let _e884 = phi_1171_;
                    if (_e884 > _e803) {
                        phi_1176_ = _e884;
                    } else {
                        phi_1176_ = _e803;
                    }
                    let _e887 = phi_1176_;
                    if (_e829 > _e855) {
                        phi_1181_ = _e829;
                    } else {
                        phi_1181_ = _e855;
                    }
                    let _e890 = phi_1181_;
                    if (_e890 > _e881) {
                        phi_1186_ = _e890;
                    } else {
                        phi_1186_ = _e881;
                    }
                    let _e893 = phi_1186_;
                    if (_e887 > _e893) {
                        phi_1191_ = _e887;
                    } else {
                        phi_1191_ = _e893;
                    }
                    let _e896 = phi_1191_;
                    let _e898 = local.member_5;
                    if (_e896 > _e898) {
                        phi_2504_ = true;
                    } else {
                        let _e903 = local.member[1u][0u];
                        let _e906 = local.member_1[2u];
                        let _e911 = local.member[2u][0u];
                        let _e914 = local.member_1[1u];
                        let _e916 = ((_e903 * _e906) - (_e911 * _e914));
                        let _e920 = local.member[2u][0u];
                        if (_e920 < 0f) {
                            phi_1250_ = -(_e920);
                        } else {
                            phi_1250_ = _e920;
                        }
                        let _e924 = phi_1250_;
                        let _e927 = local.member_3[1u];
                        let _e932 = local.member[1u][0u];
                        if (_e932 < 0f) {
                            phi_1273_ = -(_e932);
                        } else {
                            phi_1273_ = _e932;
                        }
                        let _e936 = phi_1273_;
                        let _e939 = local.member_3[2u];
                        let _e945 = local.member[0u][2u];
                        if (_e945 < 0f) {
                            phi_1296_ = -(_e945);
                        } else {
                            phi_1296_ = _e945;
                        }
                        let _e949 = phi_1296_;
                        let _e952 = local.member_4[1u];
                        let _e957 = local.member[0u][1u];
                        if (_e957 < 0f) {
                            phi_1318_ = -(_e957);
                        } else {
                            phi_1318_ = _e957;
                        }
                        let _e961 = phi_1318_;
                        let _e964 = local.member_4[2u];
                        if (_e916 < 0f) {
                            phi_1334_ = -(_e916);
                        } else {
                            phi_1334_ = _e916;
                        }
                        let _e970 = phi_1334_;
                        let _e972 = (_e970 - (((_e924 * _e927) + (_e936 * _e939)) + ((_e949 * _e952) + (_e961 * _e964))));
                        let _e976 = local.member[1u][1u];
                        let _e979 = local.member_1[2u];
                        let _e984 = local.member[2u][1u];
                        let _e987 = local.member_1[1u];
                        let _e989 = ((_e976 * _e979) - (_e984 * _e987));
                        let _e993 = local.member[2u][1u];
                        if (_e993 < 0f) {
                            phi_1389_ = -(_e993);
                        } else {
                            phi_1389_ = _e993;
                        }
                        let _e997 = phi_1389_;
                        let _e1000 = local.member_3[1u];
                        let _e1005 = local.member[1u][1u];
                        if (_e1005 < 0f) {
                            phi_1412_ = -(_e1005);
                        } else {
                            phi_1412_ = _e1005;
                        }
                        let _e1009 = phi_1412_;
                        let _e1012 = local.member_3[2u];
                        let _e1018 = local.member[0u][0u];
                        if (_e1018 < 0f) {
                            phi_1435_ = -(_e1018);
                        } else {
                            phi_1435_ = _e1018;
                        }
                        let _e1022 = phi_1435_;
                        let _e1025 = local.member_4[2u];
                        let _e1030 = local.member[0u][2u];
                        if (_e1030 < 0f) {
                            phi_1457_ = -(_e1030);
                        } else {
                            phi_1457_ = _e1030;
                        }
                        let _e1034 = phi_1457_;
                        let _e1037 = local.member_4[0u];
                        if (_e989 < 0f) {
                            phi_1473_ = -(_e989);
                        } else {
                            phi_1473_ = _e989;
                        }
                        let _e1043 = phi_1473_;
                        let _e1045 = (_e1043 - (((_e997 * _e1000) + (_e1009 * _e1012)) + ((_e1022 * _e1025) + (_e1034 * _e1037))));
                        let _e1049 = local.member[1u][2u];
                        let _e1052 = local.member_1[2u];
                        let _e1057 = local.member[2u][2u];
                        let _e1060 = local.member_1[1u];
                        let _e1062 = ((_e1049 * _e1052) - (_e1057 * _e1060));
                        let _e1066 = local.member[2u][2u];
                        if (_e1066 < 0f) {
                            phi_1528_ = -(_e1066);
                        } else {
                            phi_1528_ = _e1066;
                        }
                        let _e1070 = phi_1528_;
                        let _e1073 = local.member_3[1u];
                        let _e1078 = local.member[1u][2u];
                        if (_e1078 < 0f) {
                            phi_1551_ = -(_e1078);
                        } else {
                            phi_1551_ = _e1078;
                        }
                        let _e1082 = phi_1551_;
                        let _e1085 = local.member_3[2u];
                        let _e1091 = local.member[0u][1u];
                        if (_e1091 < 0f) {
                            phi_1574_ = -(_e1091);
                        } else {
                            phi_1574_ = _e1091;
                        }
                        let _e1095 = phi_1574_;
                        let _e1098 = local.member_4[0u];
                        let _e1103 = local.member[0u][0u];
                        if (_e1103 < 0f) {
                            phi_1596_ = -(_e1103);
                        } else {
                            phi_1596_ = _e1103;
                        }
                        let _e1107 = phi_1596_;
                        let _e1110 = local.member_4[1u];
                        if (_e1062 < 0f) {
                            phi_1612_ = -(_e1062);
                        } else {
                            phi_1612_ = _e1062;
                        }
                        let _e1116 = phi_1612_;
                        let _e1118 = (_e1116 - (((_e1070 * _e1073) + (_e1082 * _e1085)) + ((_e1095 * _e1098) + (_e1107 * _e1110))));
                        let _e1122 = local.member[2u][0u];
                        let _e1125 = local.member_1[0u];
                        let _e1130 = local.member[0u][0u];
                        let _e1133 = local.member_1[2u];
                        let _e1135 = ((_e1122 * _e1125) - (_e1130 * _e1133));
                        let _e1139 = local.member[0u][0u];
                        if (_e1139 < 0f) {
                            phi_1667_ = -(_e1139);
                        } else {
                            phi_1667_ = _e1139;
                        }
                        let _e1143 = phi_1667_;
                        let _e1146 = local.member_3[2u];
                        let _e1151 = local.member[2u][0u];
                        if (_e1151 < 0f) {
                            phi_1690_ = -(_e1151);
                        } else {
                            phi_1690_ = _e1151;
                        }
                        let _e1155 = phi_1690_;
                        let _e1158 = local.member_3[0u];
                        let _e1164 = local.member[1u][2u];
                        if (_e1164 < 0f) {
                            phi_1714_ = -(_e1164);
                        } else {
                            phi_1714_ = _e1164;
                        }
                        let _e1168 = phi_1714_;
                        let _e1171 = local.member_4[1u];
                        let _e1176 = local.member[1u][1u];
                        if (_e1176 < 0f) {
                            phi_1737_ = -(_e1176);
                        } else {
                            phi_1737_ = _e1176;
                        }
                        let _e1180 = phi_1737_;
                        let _e1183 = local.member_4[2u];
                        if (_e1135 < 0f) {
                            phi_1753_ = -(_e1135);
                        } else {
                            phi_1753_ = _e1135;
                        }
                        let _e1189 = phi_1753_;
                        let _e1191 = (_e1189 - (((_e1143 * _e1146) + (_e1155 * _e1158)) + ((_e1168 * _e1171) + (_e1180 * _e1183))));
                        let _e1195 = local.member[2u][1u];
                        let _e1198 = local.member_1[0u];
                        let _e1203 = local.member[0u][1u];
                        let _e1206 = local.member_1[2u];
                        let _e1208 = ((_e1195 * _e1198) - (_e1203 * _e1206));
                        let _e1212 = local.member[0u][1u];
                        if (_e1212 < 0f) {
                            phi_1808_ = -(_e1212);
                        } else {
                            phi_1808_ = _e1212;
                        }
                        let _e1216 = phi_1808_;
                        let _e1219 = local.member_3[2u];
                        let _e1224 = local.member[2u][1u];
                        if (_e1224 < 0f) {
                            phi_1831_ = -(_e1224);
                        } else {
                            phi_1831_ = _e1224;
                        }
                        let _e1228 = phi_1831_;
                        let _e1231 = local.member_3[0u];
                        let _e1237 = local.member[1u][0u];
                        if (_e1237 < 0f) {
                            phi_1855_ = -(_e1237);
                        } else {
                            phi_1855_ = _e1237;
                        }
                        let _e1241 = phi_1855_;
                        let _e1244 = local.member_4[2u];
                        let _e1249 = local.member[1u][2u];
                        if (_e1249 < 0f) {
                            phi_1878_ = -(_e1249);
                        } else {
                            phi_1878_ = _e1249;
                        }
                        let _e1253 = phi_1878_;
                        let _e1256 = local.member_4[0u];
                        if (_e1208 < 0f) {
                            phi_1894_ = -(_e1208);
                        } else {
                            phi_1894_ = _e1208;
                        }
                        let _e1262 = phi_1894_;
                        let _e1264 = (_e1262 - (((_e1216 * _e1219) + (_e1228 * _e1231)) + ((_e1241 * _e1244) + (_e1253 * _e1256))));
                        let _e1268 = local.member[2u][2u];
                        let _e1271 = local.member_1[0u];
                        let _e1276 = local.member[0u][2u];
                        let _e1279 = local.member_1[2u];
                        let _e1281 = ((_e1268 * _e1271) - (_e1276 * _e1279));
                        let _e1285 = local.member[0u][2u];
                        if (_e1285 < 0f) {
                            phi_1949_ = -(_e1285);
                        } else {
                            phi_1949_ = _e1285;
                        }
                        let _e1289 = phi_1949_;
                        let _e1292 = local.member_3[2u];
                        let _e1297 = local.member[2u][2u];
                        if (_e1297 < 0f) {
                            phi_1972_ = -(_e1297);
                        } else {
                            phi_1972_ = _e1297;
                        }
                        let _e1301 = phi_1972_;
                        let _e1304 = local.member_3[0u];
                        let _e1310 = local.member[1u][1u];
                        if (_e1310 < 0f) {
                            phi_1996_ = -(_e1310);
                        } else {
                            phi_1996_ = _e1310;
                        }
                        let _e1314 = phi_1996_;
                        let _e1317 = local.member_4[0u];
                        let _e1322 = local.member[1u][0u];
                        if (_e1322 < 0f) {
                            phi_2019_ = -(_e1322);
                        } else {
                            phi_2019_ = _e1322;
                        }
                        let _e1326 = phi_2019_;
                        let _e1329 = local.member_4[1u];
                        if (_e1281 < 0f) {
                            phi_2035_ = -(_e1281);
                        } else {
                            phi_2035_ = _e1281;
                        }
                        let _e1335 = phi_2035_;
                        let _e1337 = (_e1335 - (((_e1289 * _e1292) + (_e1301 * _e1304)) + ((_e1314 * _e1317) + (_e1326 * _e1329))));
                        let _e1341 = local.member[0u][0u];
                        let _e1344 = local.member_1[1u];
                        let _e1349 = local.member[1u][0u];
                        let _e1352 = local.member_1[0u];
                        let _e1354 = ((_e1341 * _e1344) - (_e1349 * _e1352));
                        let _e1358 = local.member[1u][0u];
                        if (_e1358 < 0f) {
                            phi_2090_ = -(_e1358);
                        } else {
                            phi_2090_ = _e1358;
                        }
                        let _e1362 = phi_2090_;
                        let _e1365 = local.member_3[0u];
                        let _e1370 = local.member[0u][0u];
                        if (_e1370 < 0f) {
                            phi_2113_ = -(_e1370);
                        } else {
                            phi_2113_ = _e1370;
                        }
                        let _e1374 = phi_2113_;
                        let _e1377 = local.member_3[1u];
                        let _e1383 = local.member[2u][2u];
                        if (_e1383 < 0f) {
                            phi_2137_ = -(_e1383);
                        } else {
                            phi_2137_ = _e1383;
                        }
                        let _e1387 = phi_2137_;
                        let _e1390 = local.member_4[1u];
                        let _e1395 = local.member[2u][1u];
                        if (_e1395 < 0f) {
                            phi_2160_ = -(_e1395);
                        } else {
                            phi_2160_ = _e1395;
                        }
                        let _e1399 = phi_2160_;
                        let _e1402 = local.member_4[2u];
                        if (_e1354 < 0f) {
                            phi_2176_ = -(_e1354);
                        } else {
                            phi_2176_ = _e1354;
                        }
                        let _e1408 = phi_2176_;
                        let _e1410 = (_e1408 - (((_e1362 * _e1365) + (_e1374 * _e1377)) + ((_e1387 * _e1390) + (_e1399 * _e1402))));
                        let _e1414 = local.member[0u][1u];
                        let _e1417 = local.member_1[1u];
                        let _e1422 = local.member[1u][1u];
                        let _e1425 = local.member_1[0u];
                        let _e1427 = ((_e1414 * _e1417) - (_e1422 * _e1425));
                        let _e1431 = local.member[1u][1u];
                        if (_e1431 < 0f) {
                            phi_2231_ = -(_e1431);
                        } else {
                            phi_2231_ = _e1431;
                        }
                        let _e1435 = phi_2231_;
                        let _e1438 = local.member_3[0u];
                        let _e1443 = local.member[0u][1u];
                        if (_e1443 < 0f) {
                            phi_2254_ = -(_e1443);
                        } else {
                            phi_2254_ = _e1443;
                        }
                        let _e1447 = phi_2254_;
                        let _e1450 = local.member_3[1u];
                        let _e1456 = local.member[2u][0u];
                        if (_e1456 < 0f) {
                            phi_2278_ = -(_e1456);
                        } else {
                            phi_2278_ = _e1456;
                        }
                        let _e1460 = phi_2278_;
                        let _e1463 = local.member_4[2u];
                        let _e1468 = local.member[2u][2u];
                        if (_e1468 < 0f) {
                            phi_2301_ = -(_e1468);
                        } else {
                            phi_2301_ = _e1468;
                        }
                        let _e1472 = phi_2301_;
                        let _e1475 = local.member_4[0u];
                        if (_e1427 < 0f) {
                            phi_2317_ = -(_e1427);
                        } else {
                            phi_2317_ = _e1427;
                        }
                        let _e1481 = phi_2317_;
                        let _e1483 = (_e1481 - (((_e1435 * _e1438) + (_e1447 * _e1450)) + ((_e1460 * _e1463) + (_e1472 * _e1475))));
                        let _e1487 = local.member[0u][2u];
                        let _e1490 = local.member_1[1u];
                        let _e1495 = local.member[1u][2u];
                        let _e1498 = local.member_1[0u];
                        let _e1500 = ((_e1487 * _e1490) - (_e1495 * _e1498));
                        let _e1504 = local.member[1u][2u];
                        if (_e1504 < 0f) {
                            phi_2372_ = -(_e1504);
                        } else {
                            phi_2372_ = _e1504;
                        }
                        let _e1508 = phi_2372_;
                        let _e1511 = local.member_3[0u];
                        let _e1516 = local.member[0u][2u];
                        if (_e1516 < 0f) {
                            phi_2395_ = -(_e1516);
                        } else {
                            phi_2395_ = _e1516;
                        }
                        let _e1520 = phi_2395_;
                        let _e1523 = local.member_3[1u];
                        let _e1529 = local.member[2u][1u];
                        if (_e1529 < 0f) {
                            phi_2419_ = -(_e1529);
                        } else {
                            phi_2419_ = _e1529;
                        }
                        let _e1533 = phi_2419_;
                        let _e1536 = local.member_4[0u];
                        let _e1541 = local.member[2u][0u];
                        if (_e1541 < 0f) {
                            phi_2442_ = -(_e1541);
                        } else {
                            phi_2442_ = _e1541;
                        }
                        let _e1545 = phi_2442_;
                        let _e1548 = local.member_4[1u];
                        if (_e1500 < 0f) {
                            phi_2458_ = -(_e1500);
                        } else {
                            phi_2458_ = _e1500;
                        }
                        let _e1554 = phi_2458_;
                        let _e1556 = (_e1554 - (((_e1508 * _e1511) + (_e1520 * _e1523)) + ((_e1533 * _e1536) + (_e1545 * _e1548))));
                        if (_e972 > _e1045) {
                            phi_2465_ = _e972;
                        } else {
                            phi_2465_ = _e1045;
                        }
                        let _e1559 = phi_2465_;
                        if (_e1559 > _e1118) {
                            phi_2470_ = _e1559;
                        } else {
                            phi_2470_ = _e1118;
                        }
                        let _e1562 = phi_2470_;
                        if (_e1191 > _e1264) {
                            phi_2475_ = _e1191;
                        } else {
                            phi_2475_ = _e1264;
                        }
                        let _e1565 = phi_2475_;
                        if (_e1565 > _e1337) {
                            phi_2480_ = _e1565;
                        } else {
                            phi_2480_ = _e1337;
                        }
                        let _e1568 = phi_2480_;
                        if (_e1562 > _e1568) {
                            phi_2485_ = _e1562;
                        } else {
                            phi_2485_ = _e1568;
                        }
                        let _e1571 = phi_2485_;
                        if (_e1410 > _e1483) {
                            phi_2490_ = _e1410;
                        } else {
                            phi_2490_ = _e1483;
                        }
                        let _e1574 = phi_2490_;
                        if (_e1574 > _e1556) {
                            phi_2495_ = _e1574;
                        } else {
                            phi_2495_ = _e1556;
                        }
                        let _e1577 = phi_2495_;
                        if (_e1571 > _e1577) {
                            phi_2500_ = _e1571;
                        } else {
                            phi_2500_ = _e1577;
                        }
                        let _e1580 = phi_2500_;
                        let _e1582 = local.member_5;
                        phi_2504_ = (_e1580 > _e1582);
                    }
                    let _e1585 = phi_2504_;
                    phi_2506_ = !(_e1585);
                    phi_2507_ = false;
                } else {
                    phi_2506_ = bool();
                    phi_2507_ = true;
                }
                let _e1588 = phi_2506_;
                let _e1590 = phi_2507_;
                phi_2508_ = _e1588;
                phi_2509_ = _e1590;
            }
            let _e1592 = phi_2508_;
            let _e1594 = phi_2509_;
            if _e1594 {
                phi_2513_ = true;
            } else {
                phi_2513_ = _e1592;
            }
            let _e1596 = phi_2513_;
            if _e1596 {
                let _e1599 = params.member.member_2.member;
                if (_e1599 == 0u) {
                    phi_2526_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_2526_ = array<u32, 2>(1u, 1u);
                }
                let _e1602 = phi_2526_;
                let _e1608 = params.member.member.member[_e1602[0]];
                let _e1613 = params.member.member.member[_e1602[1]];
                if (_e83[0] == 4294967295u) {
                    phi_2566_ = 0u;
                } else {
                    if (_e83[0] >= (_e1608 - 1u)) {
                        if (_e83[1] >= (_e1613 - 1u)) {
                            phi_2560_ = false;
                        } else {
                            phi_2560_ = true;
                        }
                        let _e1622 = phi_2560_;
                        phi_2561_ = _e1622;
                    } else {
                        phi_2561_ = true;
                    }
                    let _e1624 = phi_2561_;
                    if _e1624 {
                        phi_2565_ = 1u;
                    } else {
                        phi_2565_ = 2u;
                    }
                    let _e1626 = phi_2565_;
                    phi_2566_ = _e1626;
                }
                let _e1628 = phi_2566_;
                phi_2567_ = _e1628;
            } else {
                phi_2567_ = 3u;
            }
            let _e1630 = phi_2567_;
            phi_2568_ = _e1630;
        } else {
            phi_2568_ = 3u;
        }
        let _e1632 = phi_2568_;
        phi_2569_ = _e1632;
    } else {
        phi_2569_ = 0u;
    }
    let _e1634 = phi_2569_;
    if (_e1634 == 1u) {
        let _e1644 = atomicAdd((&shared_[6u]), 1u);
        phi_2587_ = array<u32, 2>(_e1644, 0u);
    } else {
        if (_e1634 == 2u) {
            let _e1639 = atomicAdd((&shared_[7u]), 1u);
            phi_2586_ = array<u32, 2>(_e1639, 0u);
        } else {
            phi_2586_ = array<u32, 2>(0u, 0u);
        }
        let _e1642 = phi_2586_;
        phi_2587_ = _e1642;
    }
    let _e1647 = phi_2587_;
    if (_e1634 >= 2u) {
        if (_e85.member_4 > 0u) {
            let _e1651 = atomicAdd((&shared_[8u]), 1u);
            phi_2599_ = array<u32, 2>(_e1647[0], _e1651);
        } else {
            phi_2599_ = _e1647;
        }
        let _e1655 = phi_2599_;
        phi_2600_ = _e1655;
    } else {
        phi_2600_ = _e1647;
    }
    let _e1657 = phi_2600_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e1660 = atomicLoad((&shared_[6u]));
        let _e1662 = atomicLoad((&shared_[7u]));
        if (_e1660 > 0u) {
            let _e1665 = atomicAdd((&control.member[0u]), _e1660);
            let _e1668 = atomicMax((&nodes.member[0u]), (_e1665 + _e1660));
            if ((_e1665 + _e1660) < _e1665) {
                let _e1672 = atomicAdd((&nodes.member[2u]), 1u);
            }
            atomicStore((&shared_[11u]), _e1665);
        }
        if (_e1662 > 0u) {
            let _e1676 = atomicAdd((&pairs.member[0u]), _e1662);
            if ((_e1676 + _e1662) < _e1676) {
                let _e1680 = atomicAdd((&pairs.member[2u]), 1u);
            }
            atomicStore((&shared_[12u]), _e1676);
        }
        let _e1683 = atomicLoad((&shared_[8u]));
        if (_e1683 > 0u) {
            let _e1686 = atomicLoad((&shared_[8u]));
            let _e1688 = atomicAdd((&control.member[1537u]), _e1686);
            if ((_e1688 + _e1686) < _e1688) {
                let _e1692 = atomicAdd((&control.member[1538u]), 1u);
            }
            atomicStore((&shared_[13u]), _e1688);
        }
    }
    workgroupBarrier();
    if (_e1634 == 1u) {
        let _e1749 = atomicLoad((&shared_[11u]));
        let _e1751 = (_e1749 + _e1657[0]);
        if (_e1751 < _e85.member_3) {
            if (_e1751 < 4294967295u) {
                let _e1757 = (2u * _e1751);
                atomicStore((&nodes.member[(4u + _e1757)]), _e83[0]);
                atomicStore((&nodes.member[(_e1757 + 5u)]), _e83[1]);
            }
        }
    } else {
        if (_e1634 == 0u) {
        } else {
            let _e1698 = params.member.member_1.member_3;
            if (_e1634 == 2u) {
                let _e1702 = a_nodes.member[_e83[0]];
                let _e1706 = b_nodes.member[_e83[1]];
                if (_e85.member == 1u) {
                    if (_e1702.member_1 < _e1706.member_1) {
                        phi_2739_ = type_9(_e1702.member_1, _e1706.member_1);
                    } else {
                        phi_2739_ = type_9(_e1706.member_1, _e1702.member_1);
                    }
                    let _e1715 = phi_2739_;
                    phi_2744_ = _e1715;
                } else {
                    phi_2744_ = type_9(_e1702.member_1, _e1706.member_1);
                }
                let _e1717 = phi_2744_;
                let _e1721 = atomicLoad((&shared_[12u]));
                let _e1723 = (_e1721 + _e1657[0]);
                if (_e1723 < _e1698) {
                    let _e1725 = (2u * _e1723);
                    atomicStore((&pairs.member[(4u + _e1725)]), _e1717.member);
                    atomicStore((&pairs.member[(_e1725 + 5u)]), _e1717.member_1);
                }
            }
            if (_e85.member_4 > 0u) {
                let _e1733 = atomicLoad((&shared_[13u]));
                let _e1735 = (_e1733 + _e1657[1]);
                if (_e1735 < _e85.member_4) {
                    let _e1742 = (2u * ((_e85.member_5 * _e85.member_4) + _e1735));
                    front.member[_e1742] = _e83[0];
                    front.member[(_e1742 + 1u)] = _e83[1];
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
