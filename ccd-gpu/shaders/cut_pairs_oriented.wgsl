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
    member_18: u32,
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

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> a_nodes: type_15;
@group(0) @binding(2) 
var<storage> b_nodes: type_15;
@group(0) @binding(3) 
var<storage> cuts: type_10;
@group(0) @binding(4) 
var<storage> oriented: type_24;
@group(0) @binding(5) 
var<storage, read_write> control: type_28;
@group(0) @binding(6) 
var<storage, read_write> output: type_28;
@group(0) @binding(7) 
var<storage, read_write> front: type_10;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_20;
    var phi_147_: u32;
    var phi_184_: bool;
    var phi_213_: array<u32, 2>;
    var phi_214_: array<u32, 2>;
    var phi_215_: array<u32, 2>;
    var phi_260_: bool;
    var phi_269_: bool;
    var phi_270_: bool;
    var phi_322_: array<u32, 2>;
    var phi_353_: array<u32, 2>;
    var phi_385_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_501_: f32;
    var phi_519_: f32;
    var phi_524_: f32;
    var phi_529_: f32;
    var phi_545_: type_25;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_627_: f32;
    var phi_633_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_663_: f32;
    var phi_668_: f32;
    var phi_673_: f32;
    var phi_689_: type_25;
    var phi_879_: f32;
    var phi_885_: f32;
    var phi_892_: f32;
    var phi_901_: f32;
    var phi_908_: f32;
    var phi_916_: f32;
    var phi_925_: f32;
    var phi_932_: f32;
    var phi_940_: f32;
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
    var phi_1147_: f32;
    var phi_1154_: f32;
    var phi_1160_: f32;
    var phi_1166_: f32;
    var phi_1185_: f32;
    var phi_1192_: f32;
    var phi_1198_: f32;
    var phi_1204_: f32;
    var phi_1223_: f32;
    var phi_1230_: f32;
    var phi_1236_: f32;
    var phi_1242_: f32;
    var phi_1257_: f32;
    var phi_1262_: f32;
    var phi_1267_: f32;
    var phi_1272_: f32;
    var phi_1277_: f32;
    var phi_1336_: f32;
    var phi_1359_: f32;
    var phi_1382_: f32;
    var phi_1404_: f32;
    var phi_1420_: f32;
    var phi_1475_: f32;
    var phi_1498_: f32;
    var phi_1521_: f32;
    var phi_1543_: f32;
    var phi_1559_: f32;
    var phi_1614_: f32;
    var phi_1637_: f32;
    var phi_1660_: f32;
    var phi_1682_: f32;
    var phi_1698_: f32;
    var phi_1753_: f32;
    var phi_1776_: f32;
    var phi_1800_: f32;
    var phi_1823_: f32;
    var phi_1839_: f32;
    var phi_1894_: f32;
    var phi_1917_: f32;
    var phi_1941_: f32;
    var phi_1964_: f32;
    var phi_1980_: f32;
    var phi_2035_: f32;
    var phi_2058_: f32;
    var phi_2082_: f32;
    var phi_2105_: f32;
    var phi_2121_: f32;
    var phi_2176_: f32;
    var phi_2199_: f32;
    var phi_2223_: f32;
    var phi_2246_: f32;
    var phi_2262_: f32;
    var phi_2317_: f32;
    var phi_2340_: f32;
    var phi_2364_: f32;
    var phi_2387_: f32;
    var phi_2403_: f32;
    var phi_2458_: f32;
    var phi_2481_: f32;
    var phi_2505_: f32;
    var phi_2528_: f32;
    var phi_2544_: f32;
    var phi_2551_: f32;
    var phi_2556_: f32;
    var phi_2561_: f32;
    var phi_2566_: f32;
    var phi_2571_: f32;
    var phi_2576_: f32;
    var phi_2581_: f32;
    var phi_2586_: f32;
    var phi_2590_: bool;
    var phi_2592_: bool;
    var phi_2593_: bool;
    var phi_2594_: bool;
    var phi_2595_: bool;
    var phi_2599_: bool;
    var phi_2634_: bool;
    var phi_2635_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e38 = id_2;
    let _e39 = n_2;
    let _e40 = lane_2;
    let _e55 = ((((_e38.y * _e39.x) + _e38.x) * 256u) + _e40);
    let _e58 = params.member.member_2.member_2;
    if (_e58 == 0u) {
        return;
    }
    let _e60 = (_e55 / _e58);
    let _e62 = params.member.member_2.member_2;
    if (_e62 == 0u) {
        return;
    }
    let _e64 = (_e55 % _e62);
    let _e66 = params.member.member_2.member;
    let _e67 = (_e66 == 1u);
    if _e67 {
        phi_147_ = 0u;
    } else {
        phi_147_ = 1u;
    }
    let _e69 = phi_147_;
    let _e70 = (_e69 * 1028u);
    let _e72 = cuts.member[0u];
    if (_e60 < _e72) {
        let _e75 = cuts.member[_e70];
        if (_e64 < _e75) {
            if _e67 {
                phi_184_ = (_e60 <= _e64);
            } else {
                phi_184_ = true;
            }
            let _e79 = phi_184_;
            if _e79 {
                let _e82 = cuts.member[(4u + _e60)];
                let _e86 = cuts.member[((_e70 + 4u) + _e64)];
                phi_213_ = array<u32, 2>(_e82, _e86);
            } else {
                phi_213_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e89 = phi_213_;
            phi_214_ = _e89;
        } else {
            phi_214_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e91 = phi_214_;
        phi_215_ = _e91;
    } else {
        phi_215_ = array<u32, 2>(4294967295u, 4294967295u);
    }
    let _e93 = phi_215_;
    if (_e93[0] != 4294967295u) {
        let _e99 = a_nodes.member[_e93[0]];
        let _e102 = b_nodes.member[_e93[1]];
        let _e105 = params.member.member_2.member;
        if (_e105 == 1u) {
            phi_260_ = (_e93[0] == _e93[1]);
        } else {
            phi_260_ = false;
        }
        let _e111 = phi_260_;
        if _e111 {
            if (_e99.member_3 == 4294967295u) {
                phi_269_ = false;
            } else {
                phi_269_ = true;
            }
            let _e115 = phi_269_;
            phi_270_ = _e115;
        } else {
            phi_270_ = true;
        }
        let _e117 = phi_270_;
        if _e117 {
            if ((((((_e99.member[0] <= _e102.member_2[0]) && (_e102.member[0] <= _e99.member_2[0])) && (_e99.member[1] <= _e102.member_2[1])) && (_e102.member[1] <= _e99.member_2[1])) && (_e99.member[2] <= _e102.member_2[2])) && (_e102.member[2] <= _e99.member_2[2])) {
                let _e147 = params.member.member_2.member;
                if (_e147 == 0u) {
                    phi_322_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_322_ = array<u32, 2>(1u, 1u);
                }
                let _e150 = phi_322_;
                let _e156 = params.member.member.member[_e150[0]];
                let _e157 = (_e156 - 1u);
                let _e161 = params.member.member.member[_e150[1]];
                let _e162 = (_e161 - 1u);
                let _e165 = params.member.member_2.member;
                if (_e165 == 0u) {
                    phi_353_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_353_ = array<u32, 2>(1u, 1u);
                }
                let _e168 = phi_353_;
                let _e174 = params.member.member.member_2[_e168[0]];
                let _e178 = params.member.member.member_2[_e168[1]];
                let _e181 = params.member.member_2.member;
                if (_e181 == 1u) {
                    phi_385_ = (_e93[0] == _e93[1]);
                } else {
                    phi_385_ = false;
                }
                let _e187 = phi_385_;
                if _e187 {
                    phi_2594_ = bool();
                    phi_2595_ = true;
                } else {
                    if (_e93[0] >= _e157) {
                        if (_e93[1] >= _e162) {
                            phi_397_ = false;
                        } else {
                            phi_397_ = true;
                        }
                        let _e191 = phi_397_;
                        phi_398_ = _e191;
                    } else {
                        phi_398_ = true;
                    }
                    let _e193 = phi_398_;
                    if _e193 {
                        if (_e93[0] < _e157) {
                            let _e273 = oriented.member[(_e174 + _e93[0])];
                            phi_545_ = type_25(array<f32, 3>(_e273.member.x, _e273.member.y, _e273.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e273.member.w, _e273.member_1.x, _e273.member_1.y), array<f32, 3>(_e273.member_1.z, _e273.member_1.w, _e273.member_2.x), array<f32, 3>(_e273.member_2.y, _e273.member_2.z, _e273.member_2.w)), array<f32, 3>(_e273.member_3.x, _e273.member_3.y, _e273.member_3.z));
                        } else {
                            let _e196 = a_nodes.member[_e93[0]];
                            let _e211 = ((_e196.member[0] * 0.5f) + (_e196.member_2[0] * 0.5f));
                            let _e212 = ((_e196.member[1] * 0.5f) + (_e196.member_2[1] * 0.5f));
                            let _e213 = ((_e196.member[2] * 0.5f) + (_e196.member_2[2] * 0.5f));
                            if (_e211 < _e196.member_2[0]) {
                                phi_471_ = _e211;
                            } else {
                                phi_471_ = _e196.member_2[0];
                            }
                            let _e217 = phi_471_;
                            if (_e212 < _e196.member_2[1]) {
                                phi_477_ = _e212;
                            } else {
                                phi_477_ = _e196.member_2[1];
                            }
                            let _e221 = phi_477_;
                            if (_e213 < _e196.member_2[2]) {
                                phi_483_ = _e213;
                            } else {
                                phi_483_ = _e196.member_2[2];
                            }
                            let _e225 = phi_483_;
                            if (_e217 > _e196.member[0]) {
                                phi_489_ = _e217;
                            } else {
                                phi_489_ = _e196.member[0];
                            }
                            let _e229 = phi_489_;
                            if (_e221 > _e196.member[1]) {
                                phi_495_ = _e221;
                            } else {
                                phi_495_ = _e196.member[1];
                            }
                            let _e233 = phi_495_;
                            if (_e225 > _e196.member[2]) {
                                phi_501_ = _e225;
                            } else {
                                phi_501_ = _e196.member[2];
                            }
                            let _e237 = phi_501_;
                            let _e240 = (_e196.member_2[0] - _e229);
                            let _e242 = (_e196.member_2[1] - _e233);
                            let _e244 = (_e196.member_2[2] - _e237);
                            let _e246 = (_e229 - _e196.member[0]);
                            let _e248 = (_e233 - _e196.member[1]);
                            let _e250 = (_e237 - _e196.member[2]);
                            if (_e240 > _e246) {
                                phi_519_ = _e240;
                            } else {
                                phi_519_ = _e246;
                            }
                            let _e253 = phi_519_;
                            if (_e242 > _e248) {
                                phi_524_ = _e242;
                            } else {
                                phi_524_ = _e248;
                            }
                            let _e256 = phi_524_;
                            if (_e244 > _e250) {
                                phi_529_ = _e244;
                            } else {
                                phi_529_ = _e250;
                            }
                            let _e259 = phi_529_;
                            let _e261 = (1f + (0.000000059604645f * 4f));
                            let _e265 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_545_ = type_25(array<f32, 3>(_e229, _e233, _e237), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e253 * _e261) + _e265), ((_e256 * _e261) + _e265), ((_e259 * _e261) + _e265)));
                        }
                        let _e312 = phi_545_;
                        if (_e93[1] < _e162) {
                            let _e392 = oriented.member[(_e178 + _e93[1])];
                            phi_689_ = type_25(array<f32, 3>(_e392.member.x, _e392.member.y, _e392.member.z), array<array<f32, 3>, 3>(array<f32, 3>(_e392.member.w, _e392.member_1.x, _e392.member_1.y), array<f32, 3>(_e392.member_1.z, _e392.member_1.w, _e392.member_2.x), array<f32, 3>(_e392.member_2.y, _e392.member_2.z, _e392.member_2.w)), array<f32, 3>(_e392.member_3.x, _e392.member_3.y, _e392.member_3.z));
                        } else {
                            let _e315 = b_nodes.member[_e93[1]];
                            let _e330 = ((_e315.member[0] * 0.5f) + (_e315.member_2[0] * 0.5f));
                            let _e331 = ((_e315.member[1] * 0.5f) + (_e315.member_2[1] * 0.5f));
                            let _e332 = ((_e315.member[2] * 0.5f) + (_e315.member_2[2] * 0.5f));
                            if (_e330 < _e315.member_2[0]) {
                                phi_615_ = _e330;
                            } else {
                                phi_615_ = _e315.member_2[0];
                            }
                            let _e336 = phi_615_;
                            if (_e331 < _e315.member_2[1]) {
                                phi_621_ = _e331;
                            } else {
                                phi_621_ = _e315.member_2[1];
                            }
                            let _e340 = phi_621_;
                            if (_e332 < _e315.member_2[2]) {
                                phi_627_ = _e332;
                            } else {
                                phi_627_ = _e315.member_2[2];
                            }
                            let _e344 = phi_627_;
                            if (_e336 > _e315.member[0]) {
                                phi_633_ = _e336;
                            } else {
                                phi_633_ = _e315.member[0];
                            }
                            let _e348 = phi_633_;
                            if (_e340 > _e315.member[1]) {
                                phi_639_ = _e340;
                            } else {
                                phi_639_ = _e315.member[1];
                            }
                            let _e352 = phi_639_;
                            if (_e344 > _e315.member[2]) {
                                phi_645_ = _e344;
                            } else {
                                phi_645_ = _e315.member[2];
                            }
                            let _e356 = phi_645_;
                            let _e359 = (_e315.member_2[0] - _e348);
                            let _e361 = (_e315.member_2[1] - _e352);
                            let _e363 = (_e315.member_2[2] - _e356);
                            let _e365 = (_e348 - _e315.member[0]);
                            let _e367 = (_e352 - _e315.member[1]);
                            let _e369 = (_e356 - _e315.member[2]);
                            if (_e359 > _e365) {
                                phi_663_ = _e359;
                            } else {
                                phi_663_ = _e365;
                            }
                            let _e372 = phi_663_;
                            if (_e361 > _e367) {
                                phi_668_ = _e361;
                            } else {
                                phi_668_ = _e367;
                            }
                            let _e375 = phi_668_;
                            if (_e363 > _e369) {
                                phi_673_ = _e363;
                            } else {
                                phi_673_ = _e369;
                            }
                            let _e378 = phi_673_;
                            let _e380 = (1f + (0.000000059604645f * 4f));
                            let _e384 = (0.000000000000000000000000000000000000011754944f * 8f);
                            phi_689_ = type_25(array<f32, 3>(_e348, _e352, _e356), array<array<f32, 3>, 3>(array<f32, 3>(1f, 0f, 0f), array<f32, 3>(0f, 1f, 0f), array<f32, 3>(0f, 0f, 1f)), array<f32, 3>(((_e372 * _e380) + _e384), ((_e375 * _e380) + _e384), ((_e378 * _e380) + _e384)));
                        }
                        let _e431 = phi_689_;
                        let _e436 = (_e431.member[0] - _e312.member[0]);
                        let _e439 = (_e431.member[1] - _e312.member[1]);
                        let _e442 = (_e431.member[2] - _e312.member[2]);
                        if (_e436 < 0f) {
                            phi_879_ = -(_e436);
                        } else {
                            phi_879_ = _e436;
                        }
                        let _e631 = phi_879_;
                        if (_e439 < 0f) {
                            phi_885_ = -(_e439);
                        } else {
                            phi_885_ = _e439;
                        }
                        let _e635 = phi_885_;
                        if (_e442 < 0f) {
                            phi_892_ = -(_e442);
                        } else {
                            phi_892_ = _e442;
                        }
                        let _e640 = phi_892_;
                        if (_e312.member_2[0] < 0f) {
                            phi_901_ = -(_e312.member_2[0]);
                        } else {
                            phi_901_ = _e312.member_2[0];
                        }
                        let _e647 = phi_901_;
                        if (_e312.member_2[1] < 0f) {
                            phi_908_ = -(_e312.member_2[1]);
                        } else {
                            phi_908_ = _e312.member_2[1];
                        }
                        let _e652 = phi_908_;
                        if (_e312.member_2[2] < 0f) {
                            phi_916_ = -(_e312.member_2[2]);
                        } else {
                            phi_916_ = _e312.member_2[2];
                        }
                        let _e658 = phi_916_;
                        if (_e431.member_2[0] < 0f) {
                            phi_925_ = -(_e431.member_2[0]);
                        } else {
                            phi_925_ = _e431.member_2[0];
                        }
                        let _e665 = phi_925_;
                        if (_e431.member_2[1] < 0f) {
                            phi_932_ = -(_e431.member_2[1]);
                        } else {
                            phi_932_ = _e431.member_2[1];
                        }
                        let _e670 = phi_932_;
                        if (_e431.member_2[2] < 0f) {
                            phi_940_ = -(_e431.member_2[2]);
                        } else {
                            phi_940_ = _e431.member_2[2];
                        }
                        let _e676 = phi_940_;
                        local = type_20(array<array<f32, 3>, 3>(array<f32, 3>((((_e431.member_1[0][0] * _e312.member_1[0][0]) + (_e431.member_1[0][1] * _e312.member_1[0][1])) + (_e431.member_1[0][2] * _e312.member_1[0][2])), (((_e431.member_1[1][0] * _e312.member_1[0][0]) + (_e431.member_1[1][1] * _e312.member_1[0][1])) + (_e431.member_1[1][2] * _e312.member_1[0][2])), (((_e431.member_1[2][0] * _e312.member_1[0][0]) + (_e431.member_1[2][1] * _e312.member_1[0][1])) + (_e431.member_1[2][2] * _e312.member_1[0][2]))), array<f32, 3>((((_e431.member_1[0][0] * _e312.member_1[1][0]) + (_e431.member_1[0][1] * _e312.member_1[1][1])) + (_e431.member_1[0][2] * _e312.member_1[1][2])), (((_e431.member_1[1][0] * _e312.member_1[1][0]) + (_e431.member_1[1][1] * _e312.member_1[1][1])) + (_e431.member_1[1][2] * _e312.member_1[1][2])), (((_e431.member_1[2][0] * _e312.member_1[1][0]) + (_e431.member_1[2][1] * _e312.member_1[1][1])) + (_e431.member_1[2][2] * _e312.member_1[1][2]))), array<f32, 3>((((_e431.member_1[0][0] * _e312.member_1[2][0]) + (_e431.member_1[0][1] * _e312.member_1[2][1])) + (_e431.member_1[0][2] * _e312.member_1[2][2])), (((_e431.member_1[1][0] * _e312.member_1[2][0]) + (_e431.member_1[1][1] * _e312.member_1[2][1])) + (_e431.member_1[1][2] * _e312.member_1[2][2])), (((_e431.member_1[2][0] * _e312.member_1[2][0]) + (_e431.member_1[2][1] * _e312.member_1[2][1])) + (_e431.member_1[2][2] * _e312.member_1[2][2])))), array<f32, 3>((((_e312.member_1[0][0] * _e436) + (_e312.member_1[0][1] * _e439)) + (_e312.member_1[0][2] * _e442)), (((_e312.member_1[1][0] * _e436) + (_e312.member_1[1][1] * _e439)) + (_e312.member_1[1][2] * _e442)), (((_e312.member_1[2][0] * _e436) + (_e312.member_1[2][1] * _e439)) + (_e312.member_1[2][2] * _e442))), array<f32, 3>((((_e431.member_1[0][0] * _e436) + (_e431.member_1[0][1] * _e439)) + (_e431.member_1[0][2] * _e442)), (((_e431.member_1[1][0] * _e436) + (_e431.member_1[1][1] * _e439)) + (_e431.member_1[1][2] * _e442)), (((_e431.member_1[2][0] * _e436) + (_e431.member_1[2][1] * _e439)) + (_e431.member_1[2][2] * _e442))), array<f32, 3>(_e312.member_2[0], _e312.member_2[1], _e312.member_2[2]), array<f32, 3>(_e431.member_2[0], _e431.member_2[1], _e431.member_2[2]), ((((((_e631 + _e635) + _e640) + (((_e647 + _e652) + _e658) + ((_e665 + _e670) + _e676))) * 2f) * (0.000000059604645f * 128f)) + (0.000000000000000000000000000000000000011754944f * 128f)));
                        let _e703 = local.member[0u][0u];
                        let _e707 = local.member[0u][1u];
                        let _e711 = local.member[0u][2u];
                        let _e715 = local.member[1u][0u];
                        let _e719 = local.member[1u][1u];
                        let _e723 = local.member[1u][2u];
                        let _e727 = local.member[2u][0u];
                        let _e731 = local.member[2u][1u];
                        let _e735 = local.member[2u][2u];
                        let _e737 = local.member_3;
                        let _e742 = local.member_4;
                        let _e748 = local.member_1[0u];
                        if (_e748 < 0f) {
                            phi_1033_ = -(_e748);
                        } else {
                            phi_1033_ = _e748;
                        }
                        let _e752 = phi_1033_;
                        if (_e703 < 0f) {
                            phi_1040_ = -(_e703);
                        } else {
                            phi_1040_ = _e703;
                        }
                        let _e756 = phi_1040_;
                        if (_e707 < 0f) {
                            phi_1046_ = -(_e707);
                        } else {
                            phi_1046_ = _e707;
                        }
                        let _e760 = phi_1046_;
                        if (_e711 < 0f) {
                            phi_1052_ = -(_e711);
                        } else {
                            phi_1052_ = _e711;
                        }
                        let _e764 = phi_1052_;
                        let _e771 = (_e752 - (_e737[0] + (((_e756 * _e742[0]) + (_e760 * _e742[1])) + (_e764 * _e742[2]))));
                        let _e774 = local.member_1[1u];
                        if (_e774 < 0f) {
                            phi_1071_ = -(_e774);
                        } else {
                            phi_1071_ = _e774;
                        }
                        let _e778 = phi_1071_;
                        if (_e715 < 0f) {
                            phi_1078_ = -(_e715);
                        } else {
                            phi_1078_ = _e715;
                        }
                        let _e782 = phi_1078_;
                        if (_e719 < 0f) {
                            phi_1084_ = -(_e719);
                        } else {
                            phi_1084_ = _e719;
                        }
                        let _e786 = phi_1084_;
                        if (_e723 < 0f) {
                            phi_1090_ = -(_e723);
                        } else {
                            phi_1090_ = _e723;
                        }
                        let _e790 = phi_1090_;
                        let _e797 = (_e778 - (_e737[1] + (((_e782 * _e742[0]) + (_e786 * _e742[1])) + (_e790 * _e742[2]))));
                        let _e800 = local.member_1[2u];
                        if (_e800 < 0f) {
                            phi_1109_ = -(_e800);
                        } else {
                            phi_1109_ = _e800;
                        }
                        let _e804 = phi_1109_;
                        if (_e727 < 0f) {
                            phi_1116_ = -(_e727);
                        } else {
                            phi_1116_ = _e727;
                        }
                        let _e808 = phi_1116_;
                        if (_e731 < 0f) {
                            phi_1122_ = -(_e731);
                        } else {
                            phi_1122_ = _e731;
                        }
                        let _e812 = phi_1122_;
                        if (_e735 < 0f) {
                            phi_1128_ = -(_e735);
                        } else {
                            phi_1128_ = _e735;
                        }
                        let _e816 = phi_1128_;
                        let _e823 = (_e804 - (_e737[2] + (((_e808 * _e742[0]) + (_e812 * _e742[1])) + (_e816 * _e742[2]))));
                        let _e826 = local.member_2[0u];
                        if (_e826 < 0f) {
                            phi_1147_ = -(_e826);
                        } else {
                            phi_1147_ = _e826;
                        }
                        let _e830 = phi_1147_;
                        if (_e703 < 0f) {
                            phi_1154_ = -(_e703);
                        } else {
                            phi_1154_ = _e703;
                        }
                        let _e834 = phi_1154_;
                        if (_e715 < 0f) {
                            phi_1160_ = -(_e715);
                        } else {
                            phi_1160_ = _e715;
                        }
                        let _e838 = phi_1160_;
                        if (_e727 < 0f) {
                            phi_1166_ = -(_e727);
                        } else {
                            phi_1166_ = _e727;
                        }
                        let _e842 = phi_1166_;
                        let _e849 = (_e830 - (_e742[0] + (((_e834 * _e737[0]) + (_e838 * _e737[1])) + (_e842 * _e737[2]))));
                        let _e852 = local.member_2[1u];
                        if (_e852 < 0f) {
                            phi_1185_ = -(_e852);
                        } else {
                            phi_1185_ = _e852;
                        }
                        let _e856 = phi_1185_;
                        if (_e707 < 0f) {
                            phi_1192_ = -(_e707);
                        } else {
                            phi_1192_ = _e707;
                        }
                        let _e860 = phi_1192_;
                        if (_e719 < 0f) {
                            phi_1198_ = -(_e719);
                        } else {
                            phi_1198_ = _e719;
                        }
                        let _e864 = phi_1198_;
                        if (_e731 < 0f) {
                            phi_1204_ = -(_e731);
                        } else {
                            phi_1204_ = _e731;
                        }
                        let _e868 = phi_1204_;
                        let _e875 = (_e856 - (_e742[1] + (((_e860 * _e737[0]) + (_e864 * _e737[1])) + (_e868 * _e737[2]))));
                        let _e878 = local.member_2[2u];
                        if (_e878 < 0f) {
                            phi_1223_ = -(_e878);
                        } else {
                            phi_1223_ = _e878;
                        }
                        let _e882 = phi_1223_;
                        if (_e711 < 0f) {
                            phi_1230_ = -(_e711);
                        } else {
                            phi_1230_ = _e711;
                        }
                        let _e886 = phi_1230_;
                        if (_e723 < 0f) {
                            phi_1236_ = -(_e723);
                        } else {
                            phi_1236_ = _e723;
                        }
                        let _e890 = phi_1236_;
                        if (_e735 < 0f) {
                            phi_1242_ = -(_e735);
                        } else {
                            phi_1242_ = _e735;
                        }
                        let _e894 = phi_1242_;
                        let _e901 = (_e882 - (_e742[2] + (((_e886 * _e737[0]) + (_e890 * _e737[1])) + (_e894 * _e737[2]))));
                        if (_e771 > _e797) {
                            phi_1257_ = _e771;
                        } else {
                            phi_1257_ = _e797;
                        }
                        let _e904 = phi_1257_;
                        if (_e904 > _e823) {
                            phi_1262_ = _e904;
                        } else {
                            phi_1262_ = _e823;
                        }
                        let _e907 = phi_1262_;
                        if (_e849 > _e875) {
                            phi_1267_ = _e849;
                        } else {
                            phi_1267_ = _e875;
                        }
                        let _e910 = phi_1267_;
                        if (_e910 > _e901) {
                            phi_1272_ = _e910;
                        } else {
                            phi_1272_ = _e901;
                        }
                        let _e913 = phi_1272_;
                        if (_e907 > _e913) {
                            phi_1277_ = _e907;
                        } else {
                            phi_1277_ = _e913;
                        }
                        let _e916 = phi_1277_;
                        let _e918 = local.member_5;
                        if (_e916 > _e918) {
                            phi_2590_ = true;
                        } else {
                            let _e923 = local.member[1u][0u];
                            let _e926 = local.member_1[2u];
                            let _e931 = local.member[2u][0u];
                            let _e934 = local.member_1[1u];
                            let _e936 = ((_e923 * _e926) - (_e931 * _e934));
                            let _e940 = local.member[2u][0u];
                            if (_e940 < 0f) {
                                phi_1336_ = -(_e940);
                            } else {
                                phi_1336_ = _e940;
                            }
                            let _e944 = phi_1336_;
                            let _e947 = local.member_3[1u];
                            let _e952 = local.member[1u][0u];
                            if (_e952 < 0f) {
                                phi_1359_ = -(_e952);
                            } else {
                                phi_1359_ = _e952;
                            }
                            let _e956 = phi_1359_;
                            let _e959 = local.member_3[2u];
                            let _e965 = local.member[0u][2u];
                            if (_e965 < 0f) {
                                phi_1382_ = -(_e965);
                            } else {
                                phi_1382_ = _e965;
                            }
                            let _e969 = phi_1382_;
                            let _e972 = local.member_4[1u];
                            let _e977 = local.member[0u][1u];
                            if (_e977 < 0f) {
                                phi_1404_ = -(_e977);
                            } else {
                                phi_1404_ = _e977;
                            }
                            let _e981 = phi_1404_;
                            let _e984 = local.member_4[2u];
                            if (_e936 < 0f) {
                                phi_1420_ = -(_e936);
                            } else {
                                phi_1420_ = _e936;
                            }
                            let _e990 = phi_1420_;
                            let _e992 = (_e990 - (((_e944 * _e947) + (_e956 * _e959)) + ((_e969 * _e972) + (_e981 * _e984))));
                            let _e996 = local.member[1u][1u];
                            let _e999 = local.member_1[2u];
                            let _e1004 = local.member[2u][1u];
                            let _e1007 = local.member_1[1u];
                            let _e1009 = ((_e996 * _e999) - (_e1004 * _e1007));
                            let _e1013 = local.member[2u][1u];
                            if (_e1013 < 0f) {
                                phi_1475_ = -(_e1013);
                            } else {
                                phi_1475_ = _e1013;
                            }
                            let _e1017 = phi_1475_;
                            let _e1020 = local.member_3[1u];
                            let _e1025 = local.member[1u][1u];
                            if (_e1025 < 0f) {
                                phi_1498_ = -(_e1025);
                            } else {
                                phi_1498_ = _e1025;
                            }
                            let _e1029 = phi_1498_;
                            let _e1032 = local.member_3[2u];
                            let _e1038 = local.member[0u][0u];
                            if (_e1038 < 0f) {
                                phi_1521_ = -(_e1038);
                            } else {
                                phi_1521_ = _e1038;
                            }
                            let _e1042 = phi_1521_;
                            let _e1045 = local.member_4[2u];
                            let _e1050 = local.member[0u][2u];
                            if (_e1050 < 0f) {
                                phi_1543_ = -(_e1050);
                            } else {
                                phi_1543_ = _e1050;
                            }
                            let _e1054 = phi_1543_;
                            let _e1057 = local.member_4[0u];
                            if (_e1009 < 0f) {
                                phi_1559_ = -(_e1009);
                            } else {
                                phi_1559_ = _e1009;
                            }
                            let _e1063 = phi_1559_;
                            let _e1065 = (_e1063 - (((_e1017 * _e1020) + (_e1029 * _e1032)) + ((_e1042 * _e1045) + (_e1054 * _e1057))));
                            let _e1069 = local.member[1u][2u];
                            let _e1072 = local.member_1[2u];
                            let _e1077 = local.member[2u][2u];
                            let _e1080 = local.member_1[1u];
                            let _e1082 = ((_e1069 * _e1072) - (_e1077 * _e1080));
                            let _e1086 = local.member[2u][2u];
                            if (_e1086 < 0f) {
                                phi_1614_ = -(_e1086);
                            } else {
                                phi_1614_ = _e1086;
                            }
                            let _e1090 = phi_1614_;
                            let _e1093 = local.member_3[1u];
                            let _e1098 = local.member[1u][2u];
                            if (_e1098 < 0f) {
                                phi_1637_ = -(_e1098);
                            } else {
                                phi_1637_ = _e1098;
                            }
                            let _e1102 = phi_1637_;
                            let _e1105 = local.member_3[2u];
                            let _e1111 = local.member[0u][1u];
                            if (_e1111 < 0f) {
                                phi_1660_ = -(_e1111);
                            } else {
                                phi_1660_ = _e1111;
                            }
                            let _e1115 = phi_1660_;
                            let _e1118 = local.member_4[0u];
                            let _e1123 = local.member[0u][0u];
                            if (_e1123 < 0f) {
                                phi_1682_ = -(_e1123);
                            } else {
                                phi_1682_ = _e1123;
                            }
                            let _e1127 = phi_1682_;
                            let _e1130 = local.member_4[1u];
                            if (_e1082 < 0f) {
                                phi_1698_ = -(_e1082);
                            } else {
                                phi_1698_ = _e1082;
                            }
                            let _e1136 = phi_1698_;
                            let _e1138 = (_e1136 - (((_e1090 * _e1093) + (_e1102 * _e1105)) + ((_e1115 * _e1118) + (_e1127 * _e1130))));
                            let _e1142 = local.member[2u][0u];
                            let _e1145 = local.member_1[0u];
                            let _e1150 = local.member[0u][0u];
                            let _e1153 = local.member_1[2u];
                            let _e1155 = ((_e1142 * _e1145) - (_e1150 * _e1153));
                            let _e1159 = local.member[0u][0u];
                            if (_e1159 < 0f) {
                                phi_1753_ = -(_e1159);
                            } else {
                                phi_1753_ = _e1159;
                            }
                            let _e1163 = phi_1753_;
                            let _e1166 = local.member_3[2u];
                            let _e1171 = local.member[2u][0u];
                            if (_e1171 < 0f) {
                                phi_1776_ = -(_e1171);
                            } else {
                                phi_1776_ = _e1171;
                            }
                            let _e1175 = phi_1776_;
                            let _e1178 = local.member_3[0u];
                            let _e1184 = local.member[1u][2u];
                            if (_e1184 < 0f) {
                                phi_1800_ = -(_e1184);
                            } else {
                                phi_1800_ = _e1184;
                            }
                            let _e1188 = phi_1800_;
                            let _e1191 = local.member_4[1u];
                            let _e1196 = local.member[1u][1u];
                            if (_e1196 < 0f) {
                                phi_1823_ = -(_e1196);
                            } else {
                                phi_1823_ = _e1196;
                            }
                            let _e1200 = phi_1823_;
                            let _e1203 = local.member_4[2u];
                            if (_e1155 < 0f) {
                                phi_1839_ = -(_e1155);
                            } else {
                                phi_1839_ = _e1155;
                            }
                            let _e1209 = phi_1839_;
                            let _e1211 = (_e1209 - (((_e1163 * _e1166) + (_e1175 * _e1178)) + ((_e1188 * _e1191) + (_e1200 * _e1203))));
                            let _e1215 = local.member[2u][1u];
                            let _e1218 = local.member_1[0u];
                            let _e1223 = local.member[0u][1u];
                            let _e1226 = local.member_1[2u];
                            let _e1228 = ((_e1215 * _e1218) - (_e1223 * _e1226));
                            let _e1232 = local.member[0u][1u];
                            if (_e1232 < 0f) {
                                phi_1894_ = -(_e1232);
                            } else {
                                phi_1894_ = _e1232;
                            }
                            let _e1236 = phi_1894_;
                            let _e1239 = local.member_3[2u];
                            let _e1244 = local.member[2u][1u];
                            if (_e1244 < 0f) {
                                phi_1917_ = -(_e1244);
                            } else {
                                phi_1917_ = _e1244;
                            }
                            let _e1248 = phi_1917_;
                            let _e1251 = local.member_3[0u];
                            let _e1257 = local.member[1u][0u];
                            if (_e1257 < 0f) {
                                phi_1941_ = -(_e1257);
                            } else {
                                phi_1941_ = _e1257;
                            }
                            let _e1261 = phi_1941_;
                            let _e1264 = local.member_4[2u];
                            let _e1269 = local.member[1u][2u];
                            if (_e1269 < 0f) {
                                phi_1964_ = -(_e1269);
                            } else {
                                phi_1964_ = _e1269;
                            }
                            let _e1273 = phi_1964_;
                            let _e1276 = local.member_4[0u];
                            if (_e1228 < 0f) {
                                phi_1980_ = -(_e1228);
                            } else {
                                phi_1980_ = _e1228;
                            }
                            let _e1282 = phi_1980_;
                            let _e1284 = (_e1282 - (((_e1236 * _e1239) + (_e1248 * _e1251)) + ((_e1261 * _e1264) + (_e1273 * _e1276))));
                            let _e1288 = local.member[2u][2u];
                            let _e1291 = local.member_1[0u];
                            let _e1296 = local.member[0u][2u];
                            let _e1299 = local.member_1[2u];
                            let _e1301 = ((_e1288 * _e1291) - (_e1296 * _e1299));
                            let _e1305 = local.member[0u][2u];
                            if (_e1305 < 0f) {
                                phi_2035_ = -(_e1305);
                            } else {
                                phi_2035_ = _e1305;
                            }
                            let _e1309 = phi_2035_;
                            let _e1312 = local.member_3[2u];
                            let _e1317 = local.member[2u][2u];
                            if (_e1317 < 0f) {
                                phi_2058_ = -(_e1317);
                            } else {
                                phi_2058_ = _e1317;
                            }
                            let _e1321 = phi_2058_;
                            let _e1324 = local.member_3[0u];
                            let _e1330 = local.member[1u][1u];
                            if (_e1330 < 0f) {
                                phi_2082_ = -(_e1330);
                            } else {
                                phi_2082_ = _e1330;
                            }
                            let _e1334 = phi_2082_;
                            let _e1337 = local.member_4[0u];
                            let _e1342 = local.member[1u][0u];
                            if (_e1342 < 0f) {
                                phi_2105_ = -(_e1342);
                            } else {
                                phi_2105_ = _e1342;
                            }
                            let _e1346 = phi_2105_;
                            let _e1349 = local.member_4[1u];
                            if (_e1301 < 0f) {
                                phi_2121_ = -(_e1301);
                            } else {
                                phi_2121_ = _e1301;
                            }
                            let _e1355 = phi_2121_;
                            let _e1357 = (_e1355 - (((_e1309 * _e1312) + (_e1321 * _e1324)) + ((_e1334 * _e1337) + (_e1346 * _e1349))));
                            let _e1361 = local.member[0u][0u];
                            let _e1364 = local.member_1[1u];
                            let _e1369 = local.member[1u][0u];
                            let _e1372 = local.member_1[0u];
                            let _e1374 = ((_e1361 * _e1364) - (_e1369 * _e1372));
                            let _e1378 = local.member[1u][0u];
                            if (_e1378 < 0f) {
                                phi_2176_ = -(_e1378);
                            } else {
                                phi_2176_ = _e1378;
                            }
                            let _e1382 = phi_2176_;
                            let _e1385 = local.member_3[0u];
                            let _e1390 = local.member[0u][0u];
                            if (_e1390 < 0f) {
                                phi_2199_ = -(_e1390);
                            } else {
                                phi_2199_ = _e1390;
                            }
                            let _e1394 = phi_2199_;
                            let _e1397 = local.member_3[1u];
                            let _e1403 = local.member[2u][2u];
                            if (_e1403 < 0f) {
                                phi_2223_ = -(_e1403);
                            } else {
                                phi_2223_ = _e1403;
                            }
                            let _e1407 = phi_2223_;
                            let _e1410 = local.member_4[1u];
                            let _e1415 = local.member[2u][1u];
                            if (_e1415 < 0f) {
                                phi_2246_ = -(_e1415);
                            } else {
                                phi_2246_ = _e1415;
                            }
                            let _e1419 = phi_2246_;
                            let _e1422 = local.member_4[2u];
                            if (_e1374 < 0f) {
                                phi_2262_ = -(_e1374);
                            } else {
                                phi_2262_ = _e1374;
                            }
                            let _e1428 = phi_2262_;
                            let _e1430 = (_e1428 - (((_e1382 * _e1385) + (_e1394 * _e1397)) + ((_e1407 * _e1410) + (_e1419 * _e1422))));
                            let _e1434 = local.member[0u][1u];
                            let _e1437 = local.member_1[1u];
                            let _e1442 = local.member[1u][1u];
                            let _e1445 = local.member_1[0u];
                            let _e1447 = ((_e1434 * _e1437) - (_e1442 * _e1445));
                            let _e1451 = local.member[1u][1u];
                            if (_e1451 < 0f) {
                                phi_2317_ = -(_e1451);
                            } else {
                                phi_2317_ = _e1451;
                            }
                            let _e1455 = phi_2317_;
                            let _e1458 = local.member_3[0u];
                            let _e1463 = local.member[0u][1u];
                            if (_e1463 < 0f) {
                                phi_2340_ = -(_e1463);
                            } else {
                                phi_2340_ = _e1463;
                            }
                            let _e1467 = phi_2340_;
                            let _e1470 = local.member_3[1u];
                            let _e1476 = local.member[2u][0u];
                            if (_e1476 < 0f) {
                                phi_2364_ = -(_e1476);
                            } else {
                                phi_2364_ = _e1476;
                            }
                            let _e1480 = phi_2364_;
                            let _e1483 = local.member_4[2u];
                            let _e1488 = local.member[2u][2u];
                            if (_e1488 < 0f) {
                                phi_2387_ = -(_e1488);
                            } else {
                                phi_2387_ = _e1488;
                            }
                            let _e1492 = phi_2387_;
                            let _e1495 = local.member_4[0u];
                            if (_e1447 < 0f) {
                                phi_2403_ = -(_e1447);
                            } else {
                                phi_2403_ = _e1447;
                            }
                            let _e1501 = phi_2403_;
                            let _e1503 = (_e1501 - (((_e1455 * _e1458) + (_e1467 * _e1470)) + ((_e1480 * _e1483) + (_e1492 * _e1495))));
                            let _e1507 = local.member[0u][2u];
                            let _e1510 = local.member_1[1u];
                            let _e1515 = local.member[1u][2u];
                            let _e1518 = local.member_1[0u];
                            let _e1520 = ((_e1507 * _e1510) - (_e1515 * _e1518));
                            let _e1524 = local.member[1u][2u];
                            if (_e1524 < 0f) {
                                phi_2458_ = -(_e1524);
                            } else {
                                phi_2458_ = _e1524;
                            }
                            let _e1528 = phi_2458_;
                            let _e1531 = local.member_3[0u];
                            let _e1536 = local.member[0u][2u];
                            if (_e1536 < 0f) {
                                phi_2481_ = -(_e1536);
                            } else {
                                phi_2481_ = _e1536;
                            }
                            let _e1540 = phi_2481_;
                            let _e1543 = local.member_3[1u];
                            let _e1549 = local.member[2u][1u];
                            if (_e1549 < 0f) {
                                phi_2505_ = -(_e1549);
                            } else {
                                phi_2505_ = _e1549;
                            }
                            let _e1553 = phi_2505_;
                            let _e1556 = local.member_4[0u];
                            let _e1561 = local.member[2u][0u];
                            if (_e1561 < 0f) {
                                phi_2528_ = -(_e1561);
                            } else {
                                phi_2528_ = _e1561;
                            }
                            let _e1565 = phi_2528_;
                            let _e1568 = local.member_4[1u];
                            if (_e1520 < 0f) {
                                phi_2544_ = -(_e1520);
                            } else {
                                phi_2544_ = _e1520;
                            }
                            let _e1574 = phi_2544_;
                            let _e1576 = (_e1574 - (((_e1528 * _e1531) + (_e1540 * _e1543)) + ((_e1553 * _e1556) + (_e1565 * _e1568))));
                            if (_e992 > _e1065) {
                                phi_2551_ = _e992;
                            } else {
                                phi_2551_ = _e1065;
                            }
                            let _e1579 = phi_2551_;
                            if (_e1579 > _e1138) {
                                phi_2556_ = _e1579;
                            } else {
                                phi_2556_ = _e1138;
                            }
                            let _e1582 = phi_2556_;
                            if (_e1211 > _e1284) {
                                phi_2561_ = _e1211;
                            } else {
                                phi_2561_ = _e1284;
                            }
                            let _e1585 = phi_2561_;
                            if (_e1585 > _e1357) {
                                phi_2566_ = _e1585;
                            } else {
                                phi_2566_ = _e1357;
                            }
                            let _e1588 = phi_2566_;
                            if (_e1582 > _e1588) {
                                phi_2571_ = _e1582;
                            } else {
                                phi_2571_ = _e1588;
                            }
                            let _e1591 = phi_2571_;
                            if (_e1430 > _e1503) {
                                phi_2576_ = _e1430;
                            } else {
                                phi_2576_ = _e1503;
                            }
                            let _e1594 = phi_2576_;
                            if (_e1594 > _e1576) {
                                phi_2581_ = _e1594;
                            } else {
                                phi_2581_ = _e1576;
                            }
                            let _e1597 = phi_2581_;
                            if (_e1591 > _e1597) {
                                phi_2586_ = _e1591;
                            } else {
                                phi_2586_ = _e1597;
                            }
                            let _e1600 = phi_2586_;
                            let _e1602 = local.member_5;
                            phi_2590_ = (_e1600 > _e1602);
                        }
                        let _e1605 = phi_2590_;
                        phi_2592_ = !(_e1605);
                        phi_2593_ = false;
                    } else {
                        phi_2592_ = bool();
                        phi_2593_ = true;
                    }
                    let _e1608 = phi_2592_;
                    let _e1610 = phi_2593_;
                    phi_2594_ = _e1608;
                    phi_2595_ = _e1610;
                }
                let _e1612 = phi_2594_;
                let _e1614 = phi_2595_;
                if _e1614 {
                    phi_2599_ = true;
                } else {
                    phi_2599_ = _e1612;
                }
                let _e1616 = phi_2599_;
                if _e1616 {
                    let _e1618 = atomicAdd((&control.member[0u]), 1u);
                    let _e1621 = atomicMax((&output.member[0u]), (_e1618 + 1u));
                    if ((_e1618 + 1u) < _e1618) {
                        let _e1625 = atomicAdd((&output.member[2u]), 1u);
                    }
                    let _e1628 = params.member.member_2.member_3;
                    if (_e1618 < _e1628) {
                        let _e1632 = (2u * _e1618);
                        atomicStore((&output.member[(4u + _e1632)]), _e93[0]);
                        atomicStore((&output.member[(_e1632 + 5u)]), _e93[1]);
                    }
                    phi_2634_ = false;
                } else {
                    phi_2634_ = true;
                }
                let _e1638 = phi_2634_;
                phi_2635_ = _e1638;
            } else {
                phi_2635_ = true;
            }
            let _e1640 = phi_2635_;
            if _e1640 {
                let _e1643 = params.member.member_2.member_4;
                if (_e1643 > 0u) {
                    let _e1646 = atomicAdd((&control.member[1537u]), 1u);
                    if ((_e1646 + 1u) < _e1646) {
                        let _e1650 = atomicAdd((&control.member[1538u]), 1u);
                    }
                    let _e1652 = params.member.member_2.member_4;
                    if (_e1646 < _e1652) {
                        let _e1655 = params.member.member_2.member_5;
                        let _e1657 = params.member.member_2.member_4;
                        let _e1660 = (2u * ((_e1655 * _e1657) + _e1646));
                        front.member[_e1660] = _e93[0];
                        front.member[(_e1660 + 1u)] = _e93[1];
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
