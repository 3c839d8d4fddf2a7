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

struct type_15 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_17 {
    member: array<type_15>,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: array<u32, 2>,
    member_4: u32,
}

struct type_19 {
    member: type_7,
    member_1: type_8,
    member_2: type_18,
}

struct type_20 {
    member: type_19,
}

struct type_22 {
    member: array<u32, 5>,
    member_1: u32,
}

struct type_23 {
    member: array<u32, 3>,
    member_1: u32,
    member_2: array<u32, 3>,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
@group(0) @binding(0) 
var<storage> params: type_20;
@group(0) @binding(2) 
var<storage> regions: type_11;
@group(0) @binding(5) 
var<storage, read_write> vf: type_28;
@group(0) @binding(6) 
var<storage, read_write> ee: type_28;
@group(0) @binding(7) 
var<storage, read_write> counts: type_28;
var<workgroup> shared_: array<atomic<u32>, 12>;
@group(0) @binding(1) 
var<storage> triangles: type_25;
@group(0) @binding(3) 
var<storage> boxes: type_17;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_150_: u32;
    var phi_160_: u32;
    var phi_167_: u32;
    var phi_188_: u32;
    var phi_209_: u32;
    var phi_210_: u32;
    var phi_213_: type_9;
    var phi_214_: type_9;
    var phi_237_: type_9;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_337_: bool;
    var phi_341_: bool;
    var phi_459_: bool;
    var phi_460_: bool;
    var phi_464_: bool;
    var phi_483_: bool;
    var phi_490_: bool;
    var phi_498_: bool;
    var phi_508_: bool;
    var phi_515_: bool;
    var phi_523_: bool;
    var phi_534_: bool;
    var phi_541_: bool;
    var phi_549_: bool;
    var phi_555_: bool;
    var phi_556_: bool;
    var phi_592_: bool;
    var phi_593_: bool;
    var phi_644_: bool;
    var phi_651_: bool;
    var phi_659_: bool;
    var phi_700_: u32;
    var phi_701_: u32;
    var phi_718_: bool;
    var phi_725_: bool;
    var phi_733_: bool;
    var phi_774_: u32;
    var phi_775_: u32;
    var phi_793_: bool;
    var phi_800_: bool;
    var phi_808_: bool;
    var phi_849_: u32;
    var phi_850_: u32;
    var phi_853_: u32;
    var phi_854_: u32;
    var phi_855_: u32;
    var phi_856_: u32;
    var phi_898_: bool;
    var phi_905_: bool;
    var phi_913_: bool;
    var phi_954_: u32;
    var phi_955_: u32;
    var phi_972_: bool;
    var phi_979_: bool;
    var phi_987_: bool;
    var phi_1028_: u32;
    var phi_1029_: u32;
    var phi_1047_: bool;
    var phi_1054_: bool;
    var phi_1062_: bool;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_1108_: u32;
    var phi_1109_: u32;
    var phi_1110_: u32;
    var phi_1111_: u32;
    var phi_1159_: type_15;
    var phi_1181_: type_15;
    var phi_1203_: type_15;
    var phi_1233_: type_15;
    var phi_1240_: bool;
    var phi_1246_: bool;
    var phi_1279_: bool;
    var phi_1285_: bool;
    var phi_1320_: bool;
    var phi_1326_: bool;
    var phi_1376_: type_15;
    var phi_1383_: bool;
    var phi_1389_: bool;
    var phi_1423_: bool;
    var phi_1429_: bool;
    var phi_1464_: bool;
    var phi_1470_: bool;
    var phi_1521_: type_15;
    var phi_1528_: bool;
    var phi_1534_: bool;
    var phi_1569_: bool;
    var phi_1575_: bool;
    var phi_1610_: bool;
    var phi_1616_: bool;
    var phi_1648_: u32;
    var phi_1649_: u32;
    var phi_1650_: u32;
    var phi_1651_: u32;
    var phi_1654_: type_22;
    var phi_1655_: type_22;
    var phi_1656_: type_22;
    var phi_1657_: bool;
    var phi_1658_: type_22;
    var phi_1659_: type_22;
    var phi_1660_: bool;
    var phi_1661_: type_22;
    var phi_1662_: type_22;
    var phi_1663_: bool;
    var phi_1667_: type_22;
    var phi_1716_: u32;
    var phi_1717_: u32;
    var phi_1718_: u32;
    var phi_1719_: u32;
    var phi_1720_: u32;
    var phi_1721_: type_9;
    var phi_1776_: type_9;
    var phi_1779_: u32;
    var phi_1777_: type_9;
    var phi_1802_: type_9;
    var phi_1893_: u32;
    var phi_1894_: u32;
    var phi_1907_: u32;
    var phi_1908_: u32;
    var phi_1915_: type_9;
    var phi_1877_: u32;
    var phi_1878_: u32;
    var phi_1919_: type_9;
    var phi_1858_: u32;
    var phi_1859_: u32;
    var phi_1920_: type_9;
    var phi_1937_: u32;
    var phi_1780_: u32;
    var phi_1940_: type_9;
    var phi_1943_: u32;
    var phi_1941_: type_9;
    var phi_1966_: type_9;
    var phi_2057_: u32;
    var phi_2058_: u32;
    var phi_2071_: u32;
    var phi_2072_: u32;
    var phi_2079_: type_9;
    var phi_2041_: u32;
    var phi_2042_: u32;
    var phi_2083_: type_9;
    var phi_2022_: u32;
    var phi_2023_: u32;
    var phi_2084_: type_9;
    var phi_2099_: u32;
    var phi_1944_: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e48 = id_2;
    let _e49 = n_2;
    let _e50 = lane_2;
    let _e63 = ((_e48.y * _e49.x) + _e48.x);
    let _e66 = (_e49.x * _e49.y);
    let _e70 = params.member.member_2.member_1;
    let _e72 = params.member.member_1.member_2;
    let _e74 = input.member[0u];
    if (_e72 < _e74) {
        phi_150_ = _e72;
    } else {
        phi_150_ = _e74;
    }
    let _e77 = phi_150_;
    let _e79 = params.member.member_1.member_1;
    if (_e77 > _e79) {
        let _e82 = params.member.member_1.member_1;
        phi_160_ = (_e77 - _e82);
    } else {
        phi_160_ = 0u;
    }
    let _e85 = phi_160_;
    let _e87 = params.member.member_1.member;
    if (_e87 < _e85) {
        phi_167_ = _e87;
    } else {
        phi_167_ = _e85;
    }
    let _e90 = phi_167_;
    if (_e50 < 5u) {
        atomicStore((&shared_[_e50]), 0u);
    }
    workgroupBarrier();
    let _e93 = (_e90 / 128u);
    if ((_e90 % 128u) > 0u) {
        phi_188_ = (_e93 + 1u);
    } else {
        phi_188_ = _e93;
    }
    let _e98 = phi_188_;
    if (_e98 > _e63) {
        let _e100 = (_e98 - _e63);
        if (_e66 == 0u) {
            return;
        }
        let _e102 = (_e100 / _e66);
        if (_e66 == 0u) {
            return;
        }
        if ((_e100 % _e66) > 0u) {
            phi_209_ = (_e102 + 1u);
        } else {
            phi_209_ = _e102;
        }
        let _e108 = phi_209_;
        phi_210_ = _e108;
    } else {
        phi_210_ = 0u;
    }
    let _e110 = phi_210_;
    phi_213_ = type_9(0u, _e110);
    loop {
        let _e113 = phi_213_;
        if (_e113.member < _e113.member_1) {
            phi_214_ = type_9((_e113.member + 1u), _e113.member_1);
            phi_237_ = type_9(1u, _e113.member);
        } else {
            phi_214_ = _e113;
            phi_237_ = type_9(0u, type_9().member_1);
        }
        let _e125 = phi_214_;
        let _e127 = phi_237_;
        let _e131 = (bitcast<i32>(_e127.member) != 0i);
        if _e131 {
            let _e135 = (((_e63 + (_e127.member_1 * _e66)) * 128u) + _e50);
            if (_e50 == 0u) {
                atomicStore((&shared_[5u]), 0u);
                atomicStore((&shared_[6u]), 0u);
            }
            workgroupBarrier();
            if (_e135 < _e90) {
                let _e141 = params.member.member_1.member_1;
                let _e143 = (2u * (_e141 + _e135));
                let _e146 = input.member[(4u + _e143)];
                let _e149 = input.member[(_e143 + 5u)];
                let _e154 = triangles.member[_e146];
                let _e156 = triangles.member[_e149];
                let _e158 = params.member.member.member_1;
                if ((_e158 & 2u) != 0u) {
                    if ((_e154.member_3 / 4u) != (_e156.member_3 / 4u)) {
                        phi_330_ = true;
                    } else {
                        if ((_e154.member_3 & 2u) == 0u) {
                            phi_329_ = false;
                        } else {
                            phi_329_ = true;
                        }
                        let _e169 = phi_329_;
                        phi_330_ = _e169;
                    }
                    let _e171 = phi_330_;
                    if _e171 {
                        phi_337_ = (((_e154.member_3 & _e156.member_3) & 1u) == 0u);
                    } else {
                        phi_337_ = false;
                    }
                    let _e176 = phi_337_;
                    phi_341_ = _e176;
                } else {
                    phi_341_ = true;
                }
                let _e178 = phi_341_;
                if _e178 {
                    let _e180 = params.member.member.member_1;
                    if ((_e180 & 4u) != 0u) {
                        let _e186 = params.member.member_2.member_4;
                        let _e188 = regions.member[_e186];
                        let _e191 = regions.member[(_e186 + 1u)];
                        let _e196 = ((_e186 + 4u) + (2u * (_e154.member_3 >> bitcast<u32>(2i))));
                        let _e201 = ((_e186 + 4u) + (2u * (_e156.member_3 >> bitcast<u32>(2i))));
                        let _e203 = regions.member[_e196];
                        let _e205 = regions.member[_e201];
                        let _e214 = regions.member[((((_e186 + 4u) + (2u * _e188)) + (_e203 * _e191)) + (_e205 / 32u))];
                        let _e217 = regions.member[(_e196 + 1u)];
                        let _e220 = regions.member[(_e201 + 1u)];
                        if (_e217 == _e220) {
                            if (((_e214 >> bitcast<u32>(((_e205 % 32u) & 31u))) & 1u) == 1u) {
                                phi_459_ = true;
                            } else {
                                phi_459_ = ((_e154.member_3 >> bitcast<u32>(2i)) == (_e156.member_3 >> bitcast<u32>(2i)));
                            }
                            let _e234 = phi_459_;
                            phi_460_ = _e234;
                        } else {
                            phi_460_ = false;
                        }
                        let _e236 = phi_460_;
                        phi_464_ = _e236;
                    } else {
                        phi_464_ = true;
                    }
                    let _e238 = phi_464_;
                    if _e238 {
                        let _e240 = params.member.member_2.member;
                        if ((_e240 & 1u) != 0u) {
                            if (_e156.member[0] == _e154.member[0]) {
                                phi_483_ = true;
                            } else {
                                phi_483_ = (_e156.member[0] == _e154.member[0]);
                            }
                            let _e250 = phi_483_;
                            if (_e156.member[1] == _e154.member[0]) {
                                phi_490_ = true;
                            } else {
                                phi_490_ = (_e156.member[1] == _e154.member[0]);
                            }
                            let _e255 = phi_490_;
                            if (_e156.member[2] == _e154.member[0]) {
                                phi_498_ = true;
                            } else {
                                phi_498_ = (_e156.member[2] == _e154.member[0]);
                            }
                            let _e261 = phi_498_;
                            if (_e156.member[0] == _e154.member[1]) {
                                phi_508_ = true;
                            } else {
                                phi_508_ = (_e156.member[0] == _e154.member[1]);
                            }
                            let _e270 = phi_508_;
                            if (_e156.member[1] == _e154.member[1]) {
                                phi_515_ = true;
                            } else {
                                phi_515_ = (_e156.member[1] == _e154.member[1]);
                            }
                            let _e275 = phi_515_;
                            if (_e156.member[2] == _e154.member[1]) {
                                phi_523_ = true;
                            } else {
                                phi_523_ = (_e156.member[2] == _e154.member[1]);
                            }
                            let _e281 = phi_523_;
                            if (_e156.member[0] == _e154.member[2]) {
                                phi_534_ = true;
                            } else {
                                phi_534_ = (_e156.member[0] == _e154.member[2]);
                            }
                            let _e291 = phi_534_;
                            if (_e156.member[1] == _e154.member[2]) {
                                phi_541_ = true;
                            } else {
                                phi_541_ = (_e156.member[1] == _e154.member[2]);
                            }
                            let _e296 = phi_541_;
                            if (_e156.member[2] == _e154.member[2]) {
                                phi_549_ = true;
                            } else {
                                phi_549_ = (_e156.member[2] == _e154.member[2]);
                            }
                            let _e302 = phi_549_;
                            if ((((_e250 || _e255) || _e261) || ((_e270 || _e275) || _e281)) || ((_e291 || _e296) || _e302)) {
                                phi_555_ = false;
                            } else {
                                phi_555_ = true;
                            }
                            let _e306 = phi_555_;
                            phi_556_ = _e306;
                        } else {
                            phi_556_ = true;
                        }
                        let _e308 = phi_556_;
                        if _e308 {
                            let _e310 = params.member.member_2.member;
                            if ((_e310 & 2u) != 0u) {
                                let _e314 = regions.member[_e146];
                                let _e316 = regions.member[_e149];
                                if (_e314 == _e316) {
                                    phi_592_ = (_e314 != 4294967295u);
                                } else {
                                    phi_592_ = false;
                                }
                                let _e320 = phi_592_;
                                phi_593_ = _e320;
                            } else {
                                phi_593_ = false;
                            }
                            let _e322 = phi_593_;
                            if _e322 {
                                phi_1654_ = type_22();
                            } else {
                                let _e325 = countOneBits((_e154.member_1 & 7u));
                                let _e328 = countOneBits((_e156.member_1 & 7u));
                                let _e331 = params.member.member.member[2u];
                                if (_e149 < _e331) {
                                    if (_e325 > 0u) {
                                        let _e336 = params.member.member.member_2[2u];
                                        let _e339 = boxes.member[(_e336 + _e149)];
                                        if ((_e154.member_1 & 1u) == 1u) {
                                            if (_e156.member[0] == _e154.member[0]) {
                                                phi_644_ = true;
                                            } else {
                                                phi_644_ = (_e156.member[0] == _e154.member[0]);
                                            }
                                            let _e350 = phi_644_;
                                            if (_e156.member[1] == _e154.member[0]) {
                                                phi_651_ = true;
                                            } else {
                                                phi_651_ = (_e156.member[1] == _e154.member[0]);
                                            }
                                            let _e355 = phi_651_;
                                            if (_e156.member[2] == _e154.member[0]) {
                                                phi_659_ = true;
                                            } else {
                                                phi_659_ = (_e156.member[2] == _e154.member[0]);
                                            }
                                            let _e361 = phi_659_;
                                            if ((_e350 || _e355) || _e361) {
                                                phi_700_ = 0u;
                                            } else {
                                                let _e364 = boxes.member[_e154.member[0]];
                                                phi_700_ = select(0u, 1u, ((((((_e364.member[0] <= _e339.member_1[0]) && (_e339.member[0] <= _e364.member_1[0])) && (_e364.member[1] <= _e339.member_1[1])) && (_e339.member[1] <= _e364.member_1[1])) && (_e364.member[2] <= _e339.member_1[2])) && (_e339.member[2] <= _e364.member_1[2])));
                                            }
                                            let _e402 = phi_700_;
                                            phi_701_ = _e402;
                                        } else {
                                            phi_701_ = 0u;
                                        }
                                        let _e404 = phi_701_;
                                        if (((_e154.member_1 >> bitcast<u32>(1u)) & 1u) == 1u) {
                                            if (_e156.member[0] == _e154.member[1]) {
                                                phi_718_ = true;
                                            } else {
                                                phi_718_ = (_e156.member[0] == _e154.member[1]);
                                            }
                                            let _e417 = phi_718_;
                                            if (_e156.member[1] == _e154.member[1]) {
                                                phi_725_ = true;
                                            } else {
                                                phi_725_ = (_e156.member[1] == _e154.member[1]);
                                            }
                                            let _e422 = phi_725_;
                                            if (_e156.member[2] == _e154.member[1]) {
                                                phi_733_ = true;
                                            } else {
                                                phi_733_ = (_e156.member[2] == _e154.member[1]);
                                            }
                                            let _e428 = phi_733_;
                                            if ((_e417 || _e422) || _e428) {
                                                phi_774_ = 0u;
                                            } else {
                                                let _e431 = boxes.member[_e154.member[1]];
                                                phi_774_ = (select(0u, 1u, ((((((_e431.member[0] <= _e339.member_1[0]) && (_e339.member[0] <= _e431.member_1[0])) && (_e431.member[1] <= _e339.member_1[1])) && (_e339.member[1] <= _e431.member_1[1])) && (_e431.member[2] <= _e339.member_1[2])) && (_e339.member[2] <= _e431.member_1[2]))) << bitcast<u32>(1u));
                                            }
                                            let _e471 = phi_774_;
                                            phi_775_ = _e471;
                                        } else {
                                            phi_775_ = 0u;
                                        }
                                        let _e473 = phi_775_;
                                        if (((_e154.member_1 >> bitcast<u32>(2u)) & 1u) == 1u) {
                                            if (_e156.member[0] == _e154.member[2]) {
                                                phi_793_ = true;
                                            } else {
                                                phi_793_ = (_e156.member[0] == _e154.member[2]);
                                            }
                                            let _e487 = phi_793_;
                                            if (_e156.member[1] == _e154.member[2]) {
                                                phi_800_ = true;
                                            } else {
                                                phi_800_ = (_e156.member[1] == _e154.member[2]);
                                            }
                                            let _e492 = phi_800_;
                                            if (_e156.member[2] == _e154.member[2]) {
                                                phi_808_ = true;
                                            } else {
                                                phi_808_ = (_e156.member[2] == _e154.member[2]);
                                            }
                                            let _e498 = phi_808_;
                                            if ((_e487 || _e492) || _e498) {
                                                phi_849_ = 0u;
                                            } else {
                                                let _e501 = boxes.member[_e154.member[2]];
                                                phi_849_ = (select(0u, 1u, ((((((_e501.member[0] <= _e339.member_1[0]) && (_e339.member[0] <= _e501.member_1[0])) && (_e501.member[1] <= _e339.member_1[1])) && (_e339.member[1] <= _e501.member_1[1])) && (_e501.member[2] <= _e339.member_1[2])) && (_e339.member[2] <= _e501.member_1[2]))) << bitcast<u32>(2u));
                                            }
                                            let _e541 = phi_849_;
                                            phi_850_ = _e541;
                                        } else {
                                            phi_850_ = 0u;
                                        }
                                        let _e543 = phi_850_;
                                        phi_853_ = _e325;
                                        phi_854_ = ((_e404 | _e473) | _e543);
                                    } else {
                                        phi_853_ = 0u;
                                        phi_854_ = 0u;
                                    }
                                    let _e546 = phi_853_;
                                    let _e548 = phi_854_;
                                    phi_855_ = _e546;
                                    phi_856_ = _e548;
                                } else {
                                    phi_855_ = 0u;
                                    phi_856_ = 0u;
                                }
                                let _e550 = phi_855_;
                                let _e552 = phi_856_;
                                let _e555 = params.member.member.member[2u];
                                if (_e146 < _e555) {
                                    if (_e328 > 0u) {
                                        let _e561 = params.member.member.member_2[2u];
                                        let _e564 = boxes.member[(_e561 + _e146)];
                                        if ((_e156.member_1 & 1u) == 1u) {
                                            if (_e154.member[0] == _e156.member[0]) {
                                                phi_898_ = true;
                                            } else {
                                                phi_898_ = (_e154.member[0] == _e156.member[0]);
                                            }
                                            let _e575 = phi_898_;
                                            if (_e154.member[1] == _e156.member[0]) {
                                                phi_905_ = true;
                                            } else {
                                                phi_905_ = (_e154.member[1] == _e156.member[0]);
                                            }
                                            let _e580 = phi_905_;
                                            if (_e154.member[2] == _e156.member[0]) {
                                                phi_913_ = true;
                                            } else {
                                                phi_913_ = (_e154.member[2] == _e156.member[0]);
                                            }
                                            let _e586 = phi_913_;
                                            if ((_e575 || _e580) || _e586) {
                                                phi_954_ = 0u;
                                            } else {
                                                let _e589 = boxes.member[_e156.member[0]];
                                                phi_954_ = select(0u, 1u, ((((((_e589.member[0] <= _e564.member_1[0]) && (_e564.member[0] <= _e589.member_1[0])) && (_e589.member[1] <= _e564.member_1[1])) && (_e564.member[1] <= _e589.member_1[1])) && (_e589.member[2] <= _e564.member_1[2])) && (_e564.member[2] <= _e589.member_1[2])));
                                            }
                                            let _e627 = phi_954_;
                                            phi_955_ = _e627;
                                        } else {
                                            phi_955_ = 0u;
                                        }
                                        let _e629 = phi_955_;
                                        if (((_e156.member_1 >> bitcast<u32>(1u)) & 1u) == 1u) {
                                            if (_e154.member[0] == _e156.member[1]) {
                                                phi_972_ = true;
                                            } else {
                                                phi_972_ = (_e154.member[0] == _e156.member[1]);
                                            }
                                            let _e642 = phi_972_;
                                            if (_e154.member[1] == _e156.member[1]) {
                                                phi_979_ = true;
                                            } else {
                                                phi_979_ = (_e154.member[1] == _e156.member[1]);
                                            }
                                            let _e647 = phi_979_;
                                            if (_e154.member[2] == _e156.member[1]) {
                                                phi_987_ = true;
                                            } else {
                                                phi_987_ = (_e154.member[2] == _e156.member[1]);
                                            }
                                            let _e653 = phi_987_;
                                            if ((_e642 || _e647) || _e653) {
                                                phi_1028_ = 0u;
                                            } else {
                                                let _e656 = boxes.member[_e156.member[1]];
                                                phi_1028_ = (select(0u, 1u, ((((((_e656.member[0] <= _e564.member_1[0]) && (_e564.member[0] <= _e656.member_1[0])) && (_e656.member[1] <= _e564.member_1[1])) && (_e564.member[1] <= _e656.member_1[1])) && (_e656.member[2] <= _e564.member_1[2])) && (_e564.member[2] <= _e656.member_1[2]))) << bitcast<u32>(1u));
                                            }
                                            let _e696 = phi_1028_;
                                            phi_1029_ = _e696;
                                        } else {
                                            phi_1029_ = 0u;
                                        }
                                        let _e698 = phi_1029_;
                                        if (((_e156.member_1 >> bitcast<u32>(2u)) & 1u) == 1u) {
                                            if (_e154.member[0] == _e156.member[2]) {
                                                phi_1047_ = true;
                                            } else {
                                                phi_1047_ = (_e154.member[0] == _e156.member[2]);
                                            }
                                            let _e712 = phi_1047_;
                                            if (_e154.member[1] == _e156.member[2]) {
                                                phi_1054_ = true;
                                            } else {
                                                phi_1054_ = (_e154.member[1] == _e156.member[2]);
                                            }
                                            let _e717 = phi_1054_;
                                            if (_e154.member[2] == _e156.member[2]) {
                                                phi_1062_ = true;
                                            } else {
                                                phi_1062_ = (_e154.member[2] == _e156.member[2]);
                                            }
                                            let _e723 = phi_1062_;
                                            if ((_e712 || _e717) || _e723) {
                                                phi_1103_ = 0u;
                                            } else {
                                                let _e726 = boxes.member[_e156.member[2]];
                                                phi_1103_ = (select(0u, 1u, ((((((_e726.member[0] <= _e564.member_1[0]) && (_e564.member[0] <= _e726.member_1[0])) && (_e726.member[1] <= _e564.member_1[1])) && (_e564.member[1] <= _e726.member_1[1])) && (_e726.member[2] <= _e564.member_1[2])) && (_e564.member[2] <= _e726.member_1[2]))) << bitcast<u32>(2u));
                                            }
                                            let _e766 = phi_1103_;
                                            phi_1104_ = _e766;
                                        } else {
                                            phi_1104_ = 0u;
                                        }
                                        let _e768 = phi_1104_;
                                        phi_1108_ = (_e550 + _e328);
                                        phi_1109_ = (_e552 | (((_e629 | _e698) | _e768) << bitcast<u32>(3i)));
                                    } else {
                                        phi_1108_ = _e550;
                                        phi_1109_ = _e552;
                                    }
                                    let _e774 = phi_1108_;
                                    let _e776 = phi_1109_;
                                    phi_1110_ = _e774;
                                    phi_1111_ = _e776;
                                } else {
                                    phi_1110_ = _e550;
                                    phi_1111_ = _e552;
                                }
                                let _e778 = phi_1110_;
                                let _e780 = phi_1111_;
                                let _e784 = countOneBits((_e154.member_1 >> bitcast<u32>(3i)));
                                let _e788 = countOneBits((_e156.member_1 >> bitcast<u32>(3i)));
                                if (_e784 > 0u) {
                                    if (_e788 > 0u) {
                                        let _e795 = params.member.member.member_2[1u];
                                        if (((_e156.member_1 >> bitcast<u32>(3u)) & 1u) == 1u) {
                                            let _e811 = boxes.member[(_e795 + _e156.member_2[0])];
                                            phi_1159_ = _e811;
                                        } else {
                                            phi_1159_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e813 = phi_1159_;
                                        if (((_e156.member_1 >> bitcast<u32>(4u)) & 1u) == 1u) {
                                            let _e821 = boxes.member[(_e795 + _e156.member_2[1])];
                                            phi_1181_ = _e821;
                                        } else {
                                            phi_1181_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e823 = phi_1181_;
                                        if (((_e156.member_1 >> bitcast<u32>(5u)) & 1u) == 1u) {
                                            let _e831 = boxes.member[(_e795 + _e156.member_2[2])];
                                            phi_1203_ = _e831;
                                        } else {
                                            phi_1203_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e833 = phi_1203_;
                                        if (((_e154.member_1 >> bitcast<u32>(3u)) & 1u) == 1u) {
                                            let _e849 = boxes.member[(_e795 + _e154.member_2[0])];
                                            phi_1233_ = _e849;
                                        } else {
                                            phi_1233_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e851 = phi_1233_;
                                        if (_e156.member[0] == _e154.member[0]) {
                                            phi_1240_ = true;
                                        } else {
                                            phi_1240_ = (_e156.member[0] == _e154.member[1]);
                                        }
                                        let _e855 = phi_1240_;
                                        if (_e156.member[1] == _e154.member[0]) {
                                            phi_1246_ = true;
                                        } else {
                                            phi_1246_ = (_e156.member[1] == _e154.member[1]);
                                        }
                                        let _e859 = phi_1246_;
                                        if (_e156.member[1] == _e154.member[0]) {
                                            phi_1279_ = true;
                                        } else {
                                            phi_1279_ = (_e156.member[1] == _e154.member[1]);
                                        }
                                        let _e902 = phi_1279_;
                                        if (_e156.member[2] == _e154.member[0]) {
                                            phi_1285_ = true;
                                        } else {
                                            phi_1285_ = (_e156.member[2] == _e154.member[1]);
                                        }
                                        let _e906 = phi_1285_;
                                        if (_e156.member[2] == _e154.member[0]) {
                                            phi_1320_ = true;
                                        } else {
                                            phi_1320_ = (_e156.member[2] == _e154.member[1]);
                                        }
                                        let _e952 = phi_1320_;
                                        if (_e156.member[0] == _e154.member[0]) {
                                            phi_1326_ = true;
                                        } else {
                                            phi_1326_ = (_e156.member[0] == _e154.member[1]);
                                        }
                                        let _e956 = phi_1326_;
                                        if (((_e154.member_1 >> bitcast<u32>(4u)) & 1u) == 1u) {
                                            let _e1006 = boxes.member[(_e795 + _e154.member_2[1])];
                                            phi_1376_ = _e1006;
                                        } else {
                                            phi_1376_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e1008 = phi_1376_;
                                        if (_e156.member[0] == _e154.member[1]) {
                                            phi_1383_ = true;
                                        } else {
                                            phi_1383_ = (_e156.member[0] == _e154.member[2]);
                                        }
                                        let _e1012 = phi_1383_;
                                        if (_e156.member[1] == _e154.member[1]) {
                                            phi_1389_ = true;
                                        } else {
                                            phi_1389_ = (_e156.member[1] == _e154.member[2]);
                                        }
                                        let _e1016 = phi_1389_;
                                        if (_e156.member[1] == _e154.member[1]) {
                                            phi_1423_ = true;
                                        } else {
                                            phi_1423_ = (_e156.member[1] == _e154.member[2]);
                                        }
                                        let _e1061 = phi_1423_;
                                        if (_e156.member[2] == _e154.member[1]) {
                                            phi_1429_ = true;
                                        } else {
                                            phi_1429_ = (_e156.member[2] == _e154.member[2]);
                                        }
                                        let _e1065 = phi_1429_;
                                        if (_e156.member[2] == _e154.member[1]) {
                                            phi_1464_ = true;
                                        } else {
                                            phi_1464_ = (_e156.member[2] == _e154.member[2]);
                                        }
                                        let _e1111 = phi_1464_;
                                        if (_e156.member[0] == _e154.member[1]) {
                                            phi_1470_ = true;
                                        } else {
                                            phi_1470_ = (_e156.member[0] == _e154.member[2]);
                                        }
                                        let _e1115 = phi_1470_;
                                        if (((_e154.member_1 >> bitcast<u32>(5u)) & 1u) == 1u) {
                                            let _e1166 = boxes.member[(_e795 + _e154.member_2[2])];
                                            phi_1521_ = _e1166;
                                        } else {
                                            phi_1521_ = type_15(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
                                        }
                                        let _e1168 = phi_1521_;
                                        if (_e156.member[0] == _e154.member[2]) {
                                            phi_1528_ = true;
                                        } else {
                                            phi_1528_ = (_e156.member[0] == _e154.member[0]);
                                        }
                                        let _e1172 = phi_1528_;
                                        if (_e156.member[1] == _e154.member[2]) {
                                            phi_1534_ = true;
                                        } else {
                                            phi_1534_ = (_e156.member[1] == _e154.member[0]);
                                        }
                                        let _e1176 = phi_1534_;
                                        if (_e156.member[1] == _e154.member[2]) {
                                            phi_1569_ = true;
                                        } else {
                                            phi_1569_ = (_e156.member[1] == _e154.member[0]);
                                        }
                                        let _e1222 = phi_1569_;
                                        if (_e156.member[2] == _e154.member[2]) {
                                            phi_1575_ = true;
                                        } else {
                                            phi_1575_ = (_e156.member[2] == _e154.member[0]);
                                        }
                                        let _e1226 = phi_1575_;
                                        if (_e156.member[2] == _e154.member[2]) {
                                            phi_1610_ = true;
                                        } else {
                                            phi_1610_ = (_e156.member[2] == _e154.member[0]);
                                        }
                                        let _e1272 = phi_1610_;
                                        if (_e156.member[0] == _e154.member[2]) {
                                            phi_1616_ = true;
                                        } else {
                                            phi_1616_ = (_e156.member[0] == _e154.member[0]);
                                        }
                                        let _e1276 = phi_1616_;
                                        phi_1648_ = (_e778 + (_e784 * _e788));
                                        phi_1649_ = (_e780 | (((((((select(0u, 1u, (!((_e855 || _e859)) && ((((((_e851.member[0] <= _e813.member_1[0]) && (_e813.member[0] <= _e851.member_1[0])) && (_e851.member[1] <= _e813.member_1[1])) && (_e813.member[1] <= _e851.member_1[1])) && (_e851.member[2] <= _e813.member_1[2])) && (_e813.member[2] <= _e851.member_1[2])))) | (select(0u, 1u, (!((_e902 || _e906)) && ((((((_e851.member[0] <= _e823.member_1[0]) && (_e823.member[0] <= _e851.member_1[0])) && (_e851.member[1] <= _e823.member_1[1])) && (_e823.member[1] <= _e851.member_1[1])) && (_e851.member[2] <= _e823.member_1[2])) && (_e823.member[2] <= _e851.member_1[2])))) << bitcast<u32>(1i))) | (select(0u, 1u, (!((_e952 || _e956)) && ((((((_e851.member[0] <= _e833.member_1[0]) && (_e833.member[0] <= _e851.member_1[0])) && (_e851.member[1] <= _e833.member_1[1])) && (_e833.member[1] <= _e851.member_1[1])) && (_e851.member[2] <= _e833.member_1[2])) && (_e833.member[2] <= _e851.member_1[2])))) << bitcast<u32>(2i))) | (((select(0u, 1u, (!((_e1012 || _e1016)) && ((((((_e1008.member[0] <= _e813.member_1[0]) && (_e813.member[0] <= _e1008.member_1[0])) && (_e1008.member[1] <= _e813.member_1[1])) && (_e813.member[1] <= _e1008.member_1[1])) && (_e1008.member[2] <= _e813.member_1[2])) && (_e813.member[2] <= _e1008.member_1[2])))) << bitcast<u32>(3i)) | (select(0u, 1u, (!((_e1061 || _e1065)) && ((((((_e1008.member[0] <= _e823.member_1[0]) && (_e823.member[0] <= _e1008.member_1[0])) && (_e1008.member[1] <= _e823.member_1[1])) && (_e823.member[1] <= _e1008.member_1[1])) && (_e1008.member[2] <= _e823.member_1[2])) && (_e823.member[2] <= _e1008.member_1[2])))) << bitcast<u32>(4i))) | (select(0u, 1u, (!((_e1111 || _e1115)) && ((((((_e1008.member[0] <= _e833.member_1[0]) && (_e833.member[0] <= _e1008.member_1[0])) && (_e1008.member[1] <= _e833.member_1[1])) && (_e833.member[1] <= _e1008.member_1[1])) && (_e1008.member[2] <= _e833.member_1[2])) && (_e833.member[2] <= _e1008.member_1[2])))) << bitcast<u32>(5i)))) | (select(0u, 1u, (!((_e1172 || _e1176)) && ((((((_e1168.member[0] <= _e813.member_1[0]) && (_e813.member[0] <= _e1168.member_1[0])) && (_e1168.member[1] <= _e813.member_1[1])) && (_e813.member[1] <= _e1168.member_1[1])) && (_e1168.member[2] <= _e813.member_1[2])) && (_e813.member[2] <= _e1168.member_1[2])))) << bitcast<u32>(6i))) | (select(0u, 1u, (!((_e1222 || _e1226)) && ((((((_e1168.member[0] <= _e823.member_1[0]) && (_e823.member[0] <= _e1168.member_1[0])) && (_e1168.member[1] <= _e823.member_1[1])) && (_e823.member[1] <= _e1168.member_1[1])) && (_e1168.member[2] <= _e823.member_1[2])) && (_e823.member[2] <= _e1168.member_1[2])))) << bitcast<u32>(7i))) | (select(0u, 1u, (!((_e1272 || _e1276)) && ((((((_e1168.member[0] <= _e833.member_1[0]) && (_e833.member[0] <= _e1168.member_1[0])) && (_e1168.member[1] <= _e833.member_1[1])) && (_e833.member[1] <= _e1168.member_1[1])) && (_e1168.member[2] <= _e833.member_1[2])) && (_e833.member[2] <= _e1168.member_1[2])))) << bitcast<u32>(8i))) << bitcast<u32>(6u)));
                                    } else {
                                        phi_1648_ = _e778;
                                        phi_1649_ = _e780;
                                    }
                                    let _e1323 = phi_1648_;
                                    let _e1325 = phi_1649_;
                                    phi_1650_ = _e1323;
                                    phi_1651_ = _e1325;
                                } else {
                                    phi_1650_ = _e778;
                                    phi_1651_ = _e780;
                                }
                                let _e1327 = phi_1650_;
                                let _e1329 = phi_1651_;
                                phi_1654_ = type_22(array<u32, 5>(1u, 0u, 0u, _e1327, 0u), _e1329);
                            }
                            let _e1333 = phi_1654_;
                            phi_1655_ = type_22(array<u32, 5>(1u, 0u, 1u, 0u, 0u), 0u);
                            phi_1656_ = _e1333;
                            phi_1657_ = _e322;
                        } else {
                            phi_1655_ = type_22(array<u32, 5>(1u, 1u, 0u, 0u, 0u), 0u);
                            phi_1656_ = type_22();
                            phi_1657_ = true;
                        }
                        let _e1335 = phi_1655_;
                        let _e1337 = phi_1656_;
                        let _e1339 = phi_1657_;
                        phi_1658_ = _e1335;
                        phi_1659_ = _e1337;
                        phi_1660_ = _e1339;
                    } else {
                        phi_1658_ = type_22(array<u32, 5>(0u, 0u, 0u, 0u, 0u), 0u);
                        phi_1659_ = type_22();
                        phi_1660_ = true;
                    }
                    let _e1341 = phi_1658_;
                    let _e1343 = phi_1659_;
                    let _e1345 = phi_1660_;
                    phi_1661_ = _e1341;
                    phi_1662_ = _e1343;
                    phi_1663_ = _e1345;
                } else {
                    phi_1661_ = type_22(array<u32, 5>(0u, 0u, 0u, 0u, 0u), 0u);
                    phi_1662_ = type_22();
                    phi_1663_ = true;
                }
                let _e1347 = phi_1661_;
                let _e1349 = phi_1662_;
                let _e1351 = phi_1663_;
                if _e1351 {
                    phi_1667_ = _e1347;
                } else {
                    phi_1667_ = _e1349;
                }
                let _e1353 = phi_1667_;
                if (_e1353.member[0] == 0u) {
                } else {
                    let _e1366 = atomicAdd((&shared_[0u]), _e1353.member[0]);
                }
                if (_e1353.member[1] == 0u) {
                } else {
                    let _e1369 = atomicAdd((&shared_[1u]), _e1353.member[1]);
                }
                if (_e1353.member[2] == 0u) {
                } else {
                    let _e1372 = atomicAdd((&shared_[2u]), _e1353.member[2]);
                }
                if (_e1353.member[3] == 0u) {
                } else {
                    let _e1375 = atomicAdd((&shared_[3u]), _e1353.member[3]);
                }
                if (_e1353.member[4] == 0u) {
                } else {
                    let _e1378 = atomicAdd((&shared_[4u]), _e1353.member[4]);
                }
                if (_e1353.member_1 == 0u) {
                    phi_1716_ = 0u;
                    phi_1717_ = 0u;
                } else {
                    let _e1384 = atomicAdd((&shared_[5u]), countOneBits((_e1353.member_1 & 63u)));
                    let _e1388 = atomicAdd((&shared_[6u]), countOneBits((_e1353.member_1 & 4294967232u)));
                    phi_1716_ = _e1388;
                    phi_1717_ = _e1384;
                }
                let _e1390 = phi_1716_;
                let _e1392 = phi_1717_;
                phi_1718_ = _e1390;
                phi_1719_ = _e1392;
                phi_1720_ = _e1353.member_1;
                phi_1721_ = type_9(_e146, _e149);
            } else {
                phi_1718_ = 0u;
                phi_1719_ = 0u;
                phi_1720_ = 0u;
                phi_1721_ = type_9(0u, 0u);
            }
            let _e1394 = phi_1718_;
            let _e1396 = phi_1719_;
            let _e1398 = phi_1720_;
            let _e1400 = phi_1721_;
            workgroupBarrier();
            if (_e50 == 0u) {
                let _e1403 = atomicLoad((&shared_[5u]));
                let _e1405 = atomicLoad((&shared_[6u]));
                if (_e1403 > 0u) {
                    let _e1408 = atomicAdd((&vf.member[0u]), _e1403);
                    if ((_e1408 + _e1403) < _e1408) {
                        let _e1412 = atomicAdd((&vf.member[2u]), 1u);
                    }
                    atomicStore((&shared_[7u]), _e1408);
                }
                if (_e1405 > 0u) {
                    let _e1416 = atomicAdd((&ee.member[0u]), _e1405);
                    if ((_e1416 + _e1405) < _e1416) {
                        let _e1420 = atomicAdd((&ee.member[2u]), 1u);
                    }
                    atomicStore((&shared_[8u]), _e1416);
                }
            }
            workgroupBarrier();
            if (_e1398 == 0u) {
            } else {
                let _e1424 = atomicLoad((&shared_[7u]));
                let _e1427 = atomicLoad((&shared_[8u]));
                phi_1776_ = type_9(0u, 6u);
                phi_1779_ = (_e1396 + _e1424);
                loop {
                    let _e1430 = phi_1776_;
                    let _e1432 = phi_1779_;
                    if (_e1430.member < _e1430.member_1) {
                        phi_1777_ = type_9((_e1430.member + 1u), _e1430.member_1);
                        phi_1802_ = type_9(1u, _e1430.member);
                    } else {
                        phi_1777_ = _e1430;
                        phi_1802_ = type_9(0u, type_9().member_1);
                    }
                    let _e1444 = phi_1777_;
                    let _e1446 = phi_1802_;
                    let _e1450 = (bitcast<i32>(_e1446.member) != 0i);
                    if _e1450 {
                        if (((_e1398 >> bitcast<u32>((_e1446.member_1 & 31u))) & 1u) == 1u) {
                            let _e1459 = triangles.member[_e1400.member];
                            let _e1461 = triangles.member[_e1400.member_1];
                            if (_e1446.member_1 < 3u) {
                                if (_e1446.member_1 == 0u) {
                                    phi_1859_ = _e1459.member[0];
                                } else {
                                    if (_e1446.member_1 == 1u) {
                                        phi_1858_ = _e1459.member[1];
                                    } else {
                                        phi_1858_ = _e1459.member[2];
                                    }
                                    let _e1512 = phi_1858_;
                                    phi_1859_ = _e1512;
                                }
                                let _e1515 = phi_1859_;
                                phi_1920_ = type_9(_e1515, _e1400.member_1);
                            } else {
                                if (_e1446.member_1 < 6u) {
                                    let _e1494 = (_e1446.member_1 - 3u);
                                    if (_e1494 == 0u) {
                                        phi_1878_ = _e1461.member[0];
                                    } else {
                                        if (_e1494 == 1u) {
                                            phi_1877_ = _e1461.member[1];
                                        } else {
                                            phi_1877_ = _e1461.member[2];
                                        }
                                        let _e1500 = phi_1877_;
                                        phi_1878_ = _e1500;
                                    }
                                    let _e1503 = phi_1878_;
                                    phi_1919_ = type_9(_e1503, _e1400.member);
                                } else {
                                    let _e1468 = (_e1446.member_1 - 6u);
                                    let _e1469 = (_e1468 / 3u);
                                    if (_e1469 == 0u) {
                                        phi_1894_ = _e1459.member_2[0];
                                    } else {
                                        if (_e1469 == 1u) {
                                            phi_1893_ = _e1459.member_2[1];
                                        } else {
                                            phi_1893_ = _e1459.member_2[2];
                                        }
                                        let _e1475 = phi_1893_;
                                        phi_1894_ = _e1475;
                                    }
                                    let _e1478 = phi_1894_;
                                    let _e1479 = (_e1468 % 3u);
                                    if (_e1479 == 0u) {
                                        phi_1908_ = _e1461.member_2[0];
                                    } else {
                                        if (_e1479 == 1u) {
                                            phi_1907_ = _e1461.member_2[1];
                                        } else {
                                            phi_1907_ = _e1461.member_2[2];
                                        }
                                        let _e1485 = phi_1907_;
                                        phi_1908_ = _e1485;
                                    }
                                    let _e1488 = phi_1908_;
                                    if (_e1478 < _e1488) {
                                        phi_1915_ = type_9(_e1478, _e1488);
                                    } else {
                                        phi_1915_ = type_9(_e1488, _e1478);
                                    }
                                    let _e1493 = phi_1915_;
                                    phi_1919_ = _e1493;
                                }
                                let _e1506 = phi_1919_;
                                phi_1920_ = _e1506;
                            }
                            let _e1518 = phi_1920_;
                            let _e1522 = params.member.member_1.member_3;
                            if (_e1432 < _e1522) {
                                let _e1524 = (2u * _e1432);
                                atomicStore((&vf.member[(4u + _e1524)]), _e1518.member);
                                atomicStore((&vf.member[(_e1524 + 5u)]), _e1518.member_1);
                            }
                            phi_1937_ = (_e1432 + 1u);
                        } else {
                            phi_1937_ = _e1432;
                        }
                        let _e1531 = phi_1937_;
                        phi_1780_ = _e1531;
                    } else {
                        phi_1780_ = u32();
                    }
                    let _e1533 = phi_1780_;
                    continue;
                    continuing {
                        phi_1776_ = _e1444;
                        phi_1779_ = _e1533;
                        break if !(_e1450);
                    }
                }
                phi_1940_ = type_9(6u, 15u);
                phi_1943_ = (_e1394 + _e1427);
                loop {
                    let _e1536 = phi_1940_;
                    let _e1538 = phi_1943_;
                    if (_e1536.member < _e1536.member_1) {
                        phi_1941_ = type_9((_e1536.member + 1u), _e1536.member_1);
                        phi_1966_ = type_9(1u, _e1536.member);
                    } else {
                        phi_1941_ = _e1536;
                        phi_1966_ = type_9(0u, type_9().member_1);
                    }
                    let _e1550 = phi_1941_;
                    let _e1552 = phi_1966_;
                    let _e1556 = (bitcast<i32>(_e1552.member) != 0i);
                    if _e1556 {
                        if (((_e1398 >> bitcast<u32>((_e1552.member_1 & 31u))) & 1u) == 1u) {
                            let _e1565 = triangles.member[_e1400.member];
                            let _e1567 = triangles.member[_e1400.member_1];
                            if (_e1552.member_1 < 3u) {
                                if (_e1552.member_1 == 0u) {
                                    phi_2023_ = _e1565.member[0];
                                } else {
                                    if (_e1552.member_1 == 1u) {
                                        phi_2022_ = _e1565.member[1];
                                    } else {
                                        phi_2022_ = _e1565.member[2];
                                    }
                                    let _e1618 = phi_2022_;
                                    phi_2023_ = _e1618;
                                }
                                let _e1621 = phi_2023_;
                                phi_2084_ = type_9(_e1621, _e1400.member_1);
                            } else {
                                if (_e1552.member_1 < 6u) {
                                    let _e1600 = (_e1552.member_1 - 3u);
                                    if (_e1600 == 0u) {
                                        phi_2042_ = _e1567.member[0];
                                    } else {
                                        if (_e1600 == 1u) {
                                            phi_2041_ = _e1567.member[1];
                                        } else {
                                            phi_2041_ = _e1567.member[2];
                                        }
                                        let _e1606 = phi_2041_;
                                        phi_2042_ = _e1606;
                                    }
                                    let _e1609 = phi_2042_;
                                    phi_2083_ = type_9(_e1609, _e1400.member);
                                } else {
                                    let _e1574 = (_e1552.member_1 - 6u);
                                    let _e1575 = (_e1574 / 3u);
                                    if (_e1575 == 0u) {
                                        phi_2058_ = _e1565.member_2[0];
                                    } else {
                                        if (_e1575 == 1u) {
                                            phi_2057_ = _e1565.member_2[1];
                                        } else {
                                            phi_2057_ = _e1565.member_2[2];
                                        }
                                        let _e1581 = phi_2057_;
                                        phi_2058_ = _e1581;
                                    }
                                    let _e1584 = phi_2058_;
                                    let _e1585 = (_e1574 % 3u);
                                    if (_e1585 == 0u) {
                                        phi_2072_ = _e1567.member_2[0];
                                    } else {
                                        if (_e1585 == 1u) {
                                            phi_2071_ = _e1567.member_2[1];
                                        } else {
                                            phi_2071_ = _e1567.member_2[2];
                                        }
                                        let _e1591 = phi_2071_;
                                        phi_2072_ = _e1591;
                                    }
                                    let _e1594 = phi_2072_;
                                    if (_e1584 < _e1594) {
                                        phi_2079_ = type_9(_e1584, _e1594);
                                    } else {
                                        phi_2079_ = type_9(_e1594, _e1584);
                                    }
                                    let _e1599 = phi_2079_;
                                    phi_2083_ = _e1599;
                                }
                                let _e1612 = phi_2083_;
                                phi_2084_ = _e1612;
                            }
                            let _e1624 = phi_2084_;
                            if (_e1538 < _e70) {
                                let _e1628 = (2u * _e1538);
                                atomicStore((&ee.member[(4u + _e1628)]), _e1624.member);
                                atomicStore((&ee.member[(_e1628 + 5u)]), _e1624.member_1);
                            }
                            phi_2099_ = (_e1538 + 1u);
                        } else {
                            phi_2099_ = _e1538;
                        }
                        let _e1635 = phi_2099_;
                        phi_1944_ = _e1635;
                    } else {
                        phi_1944_ = u32();
                    }
                    let _e1637 = phi_1944_;
                    continue;
                    continuing {
                        phi_1940_ = _e1550;
                        phi_1943_ = _e1637;
                        break if !(_e1556);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_213_ = _e125;
            break if !(_e131);
        }
    }
    workgroupBarrier();
    if (_e50 < 5u) {
        let _e1642 = atomicLoad((&shared_[_e50]));
        if (_e1642 > 0u) {
            let _e1644 = (_e50 * 4u);
            let _e1646 = atomicAdd((&counts.member[_e1644]), _e1642);
            if ((_e1646 + _e1642) < _e1646) {
                let _e1651 = atomicAdd((&counts.member[(_e1644 + 2u)]), 1u);
            }
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn expand_triangles(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
