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
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_19 {
    member: array<u32, 64>,
    member_1: array<u32, 64>,
    member_2: u32,
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
    member_18: u32,
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

struct type_27 {
    member: array<atomic<u32>>,
}

@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(0) 
var<storage> params: type_22;
@group(0) @binding(1) 
var<storage> a_nodes: type_17;
@group(0) @binding(2) 
var<storage> b_nodes: type_17;
@group(0) @binding(4) 
var<storage, read_write> rounds: type_27;
@group(0) @binding(5) 
var<storage, read_write> output: type_27;
@group(0) @binding(6) 
var<storage, read_write> pairs: type_27;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_19;
    var phi_204_: u32;
    var phi_241_: bool;
    var phi_270_: array<u32, 2>;
    var phi_271_: array<u32, 2>;
    var phi_272_: array<u32, 2>;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_328_: bool;
    var phi_390_: bool;
    var phi_394_: array<u32, 2>;
    var phi_395_: array<u32, 2>;
    var phi_396_: array<u32, 2>;
    var phi_397_: array<u32, 2>;
    var phi_142_: u32;
    var phi_171_: array<u32, 2>;
    var phi_398_: array<u32, 2>;
    var phi_544_: array<u32, 2>;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_585_: u32;
    var phi_586_: u32;
    var phi_682_: u32;
    var phi_637_: type_9;
    var phi_642_: type_9;
    var phi_755_: type_9;
    var phi_756_: type_9;
    var phi_779_: type_9;
    var phi_814_: array<u32, 2>;
    var phi_828_: u32;
    var phi_902_: array<u32, 2>;
    var phi_916_: array<u32, 2>;
    var phi_953_: array<u32, 2>;
    var phi_955_: type_24;
    var phi_956_: type_24;
    var phi_957_: bool;
    var phi_958_: type_24;
    var phi_959_: bool;
    var phi_975_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1021_: bool;
    var phi_1022_: bool;
    var phi_1023_: bool;
    var phi_1024_: bool;
    var phi_1130_: array<u32, 2>;
    var phi_1159_: array<u32, 2>;
    var phi_1188_: array<u32, 2>;
    var phi_1217_: array<u32, 2>;
    var phi_1219_: type_24;
    var phi_1220_: bool;
    var phi_1221_: type_24;
    var phi_1222_: bool;
    var phi_1395_: array<u32, 2>;
    var phi_1427_: array<u32, 2>;
    var phi_1295_: array<u32, 2>;
    var phi_1327_: array<u32, 2>;
    var phi_1429_: type_24;
    var phi_1430_: type_24;
    var phi_1431_: type_24;
    var phi_1432_: bool;
    var phi_1433_: type_24;
    var phi_1434_: type_24;
    var phi_1435_: bool;
    var phi_1439_: type_24;
    var phi_1452_: array<u32, 2>;
    var phi_1488_: bool;
    var phi_1489_: bool;
    var phi_1493_: u32;
    var phi_1494_: u32;
    var phi_1590_: u32;
    var phi_1545_: type_9;
    var phi_1550_: type_9;
    var phi_1669_: array<u32, 2>;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1710_: u32;
    var phi_1711_: u32;
    var phi_1807_: u32;
    var phi_1762_: type_9;
    var phi_1767_: type_9;
    var phi_1886_: array<u32, 2>;
    var phi_1922_: bool;
    var phi_1923_: bool;
    var phi_1927_: u32;
    var phi_1928_: u32;
    var phi_2024_: u32;
    var phi_1979_: type_9;
    var phi_1984_: type_9;
    var phi_2103_: array<u32, 2>;
    var phi_2139_: bool;
    var phi_2140_: bool;
    var phi_2144_: u32;
    var phi_2145_: u32;
    var phi_2241_: u32;
    var phi_2196_: type_9;
    var phi_2201_: type_9;
    var phi_2309_: bool;
    var phi_2310_: bool;
    var phi_2313_: type_9;
    var phi_2314_: type_9;
    var phi_2337_: type_9;
    var phi_2372_: array<u32, 2>;
    var phi_2415_: bool;
    var phi_2416_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e32 = id_2;
    let _e33 = n_2;
    let _e34 = lane_2;
    let _e48 = ((((_e32.y * _e33.x) + _e32.x) * 128u) + _e34);
    let _e52 = params.member.member_1.member_1;
    if (_e52 > 0u) {
        let _e168 = params.member.member_1.member_1;
        let _e170 = atomicLoad((&rounds.member[_e168]));
        let _e173 = params.member.member_1.member_2;
        if (_e173 < _e170) {
            phi_142_ = _e173;
        } else {
            phi_142_ = _e170;
        }
        let _e176 = phi_142_;
        if (_e48 < _e176) {
            let _e178 = (2u * _e48);
            let _e181 = input.member[(4u + _e178)];
            let _e184 = input.member[(_e178 + 5u)];
            phi_171_ = array<u32, 2>(_e181, _e184);
        } else {
            phi_171_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e187 = phi_171_;
        phi_398_ = _e187;
    } else {
        let _e56 = params.member.member_2.member_2;
        let _e59 = params.member.member_2.member_2;
        if (_e48 < (_e56 * _e59)) {
            let _e63 = params.member.member_2.member_2;
            if (_e63 == 0u) {
                return;
            }
            let _e65 = (_e48 / _e63);
            let _e67 = params.member.member_2.member_2;
            if (_e67 == 0u) {
                return;
            }
            let _e69 = (_e48 % _e67);
            let _e71 = params.member.member_2.member;
            let _e72 = (_e71 == 1u);
            if _e72 {
                phi_204_ = 0u;
            } else {
                phi_204_ = 1u;
            }
            let _e74 = phi_204_;
            let _e75 = (_e74 * 1028u);
            let _e77 = input.member[0u];
            if (_e65 < _e77) {
                let _e80 = input.member[_e75];
                if (_e69 < _e80) {
                    if _e72 {
                        phi_241_ = (_e65 <= _e69);
                    } else {
                        phi_241_ = true;
                    }
                    let _e84 = phi_241_;
                    if _e84 {
                        let _e87 = input.member[(4u + _e65)];
                        let _e91 = input.member[((_e75 + 4u) + _e69)];
                        phi_270_ = array<u32, 2>(_e87, _e91);
                    } else {
                        phi_270_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e94 = phi_270_;
                    phi_271_ = _e94;
                } else {
                    phi_271_ = array<u32, 2>(4294967295u, 4294967295u);
                }
                let _e96 = phi_271_;
                phi_272_ = _e96;
            } else {
                phi_272_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e98 = phi_272_;
            if (_e98[0] != 4294967295u) {
                let _e103 = params.member.member_2.member;
                if (_e103 == 1u) {
                    if (_e98[0] == _e98[1]) {
                        let _e110 = a_nodes.member[_e98[0]];
                        phi_321_ = (_e110.member_3 == 4294967295u);
                        phi_322_ = false;
                    } else {
                        phi_321_ = bool();
                        phi_322_ = true;
                    }
                    let _e114 = phi_321_;
                    let _e116 = phi_322_;
                    phi_323_ = _e114;
                    phi_324_ = _e116;
                } else {
                    phi_323_ = bool();
                    phi_324_ = true;
                }
                let _e118 = phi_323_;
                let _e120 = phi_324_;
                if _e120 {
                    phi_328_ = false;
                } else {
                    phi_328_ = _e118;
                }
                let _e122 = phi_328_;
                if _e122 {
                    phi_395_ = array<u32, 2>(4294967295u, 4294967295u);
                } else {
                    let _e125 = a_nodes.member[_e98[0]];
                    let _e128 = b_nodes.member[_e98[1]];
                    if ((((((_e125.member[0] <= _e128.member_2[0]) && (_e128.member[0] <= _e125.member_2[0])) && (_e125.member[1] <= _e128.member_2[1])) && (_e128.member[1] <= _e125.member_2[1])) && (_e125.member[2] <= _e128.member_2[2])) && (_e128.member[2] <= _e125.member_2[2])) {
                        phi_390_ = true;
                    } else {
                        phi_390_ = false;
                    }
                    let _e157 = phi_390_;
                    if _e157 {
                        phi_394_ = _e98;
                    } else {
                        phi_394_ = array<u32, 2>(4294967295u, 4294967295u);
                    }
                    let _e159 = phi_394_;
                    phi_395_ = _e159;
                }
                let _e161 = phi_395_;
                phi_396_ = _e161;
            } else {
                phi_396_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e163 = phi_396_;
            phi_397_ = _e163;
        } else {
            phi_397_ = array<u32, 2>(4294967295u, 4294967295u);
        }
        let _e165 = phi_397_;
        phi_398_ = _e165;
    }
    let _e189 = phi_398_;
    local = type_19(array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u);
    let _e192 = params.member.member_2.member;
    if (_e192 == 0u) {
        phi_544_ = array<u32, 2>(0u, 2u);
    } else {
        phi_544_ = array<u32, 2>(1u, 1u);
    }
    let _e195 = phi_544_;
    let _e201 = params.member.member.member[_e195[0]];
    let _e206 = params.member.member.member[_e195[1]];
    if (_e189[0] == 4294967295u) {
        phi_586_ = 0u;
    } else {
        if (_e189[0] >= (_e201 - 1u)) {
            if (_e189[1] >= (_e206 - 1u)) {
                phi_580_ = false;
            } else {
                phi_580_ = true;
            }
            let _e215 = phi_580_;
            phi_581_ = _e215;
        } else {
            phi_581_ = true;
        }
        let _e217 = phi_581_;
        if _e217 {
            phi_585_ = 1u;
        } else {
            phi_585_ = 2u;
        }
        let _e219 = phi_585_;
        phi_586_ = _e219;
    }
    let _e221 = phi_586_;
    if (_e221 == 2u) {
        let _e273 = params.member.member_1.member_3;
        let _e276 = a_nodes.member[_e189[0]];
        let _e280 = b_nodes.member[_e189[1]];
        let _e284 = params.member.member_2.member;
        if (_e284 == 1u) {
            if (_e276.member_1 < _e280.member_1) {
                phi_637_ = type_9(_e276.member_1, _e280.member_1);
            } else {
                phi_637_ = type_9(_e280.member_1, _e276.member_1);
            }
            let _e291 = phi_637_;
            phi_642_ = _e291;
        } else {
            phi_642_ = type_9(_e276.member_1, _e280.member_1);
        }
        let _e293 = phi_642_;
        let _e297 = atomicAdd((&pairs.member[0u]), 1u);
        if ((_e297 + 1u) < _e297) {
            let _e301 = atomicAdd((&pairs.member[2u]), 1u);
        }
        if (_e297 < _e273) {
            let _e303 = (2u * _e297);
            atomicStore((&pairs.member[(4u + _e303)]), _e293.member);
            atomicStore((&pairs.member[(_e303 + 5u)]), _e293.member_1);
        }
    } else {
        if (_e221 == 1u) {
            let _e226 = params.member.member_2.member_10;
            let _e228 = local.member_2;
            if (64u < _e226) {
                phi_682_ = 64u;
            } else {
                phi_682_ = _e226;
            }
            let _e231 = phi_682_;
            let _e232 = (_e228 < _e231);
            if _e232 {
                let _e235 = local.member_2;
                local.member[_e235] = _e189[0];
                let _e240 = local.member_2;
                local.member_1[_e240] = _e189[1];
                let _e245 = local.member_2;
                local.member_2 = (_e245 + 1u);
            }
            if _e232 {
            } else {
                let _e249 = params.member.member_1.member_1;
                let _e252 = atomicAdd((&rounds.member[(_e249 + 1u)]), 1u);
                let _e255 = atomicMax((&output.member[0u]), (_e252 + 1u));
                if ((_e252 + 1u) < _e252) {
                    let _e259 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e262 = params.member.member_2.member_3;
                if (_e252 < _e262) {
                    let _e266 = (2u * _e252);
                    atomicStore((&output.member[(4u + _e266)]), _e189[0]);
                    atomicStore((&output.member[(_e266 + 5u)]), _e189[1]);
                }
            }
        }
    }
    let _e310 = params.member.member_2.member_12;
    phi_755_ = type_9(0u, _e310);
    loop {
        let _e313 = phi_755_;
        if (_e313.member < _e313.member_1) {
            phi_756_ = type_9((_e313.member + 1u), _e313.member_1);
            phi_779_ = type_9(1u, _e313.member);
        } else {
            phi_756_ = _e313;
            phi_779_ = type_9(0u, type_9().member_1);
        }
        let _e325 = phi_756_;
        let _e327 = phi_779_;
        if (bitcast<i32>(_e327.member) != 0i) {
            let _e332 = local.member_2;
            if (_e332 > 0u) {
                let _e336 = local.member_2;
                local.member_2 = (_e336 - 1u);
                let _e339 = local.member_2;
                let _e342 = local.member[_e339];
                let _e345 = local.member_1[_e339];
                phi_814_ = array<u32, 2>(_e342, _e345);
            } else {
                phi_814_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e348 = phi_814_;
            if (_e348[0] == 4294967295u) {
                phi_2309_ = false;
            } else {
                let _e353 = params.member.member_2.member_1;
                if (_e353 == 0u) {
                    phi_828_ = 1u;
                } else {
                    phi_828_ = 0u;
                }
                let _e356 = phi_828_;
                let _e359 = params.member.member_2.member;
                let _e364 = a_nodes.member[_e348[0]];
                let _e366 = b_nodes.member[_e348[1]];
                if (_e359 == 1u) {
                    if (_e348[0] == _e348[1]) {
                        if (_e364.member_3 == 4294967295u) {
                            phi_955_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                        } else {
                            let _e372 = a_nodes.member[_e364.member_1];
                            let _e375 = a_nodes.member[_e364.member_3];
                            if !((_e372.member_3 == 4294967295u)) {
                                phi_902_ = array<u32, 2>(_e364.member_1, _e364.member_1);
                            } else {
                                phi_902_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e382 = phi_902_;
                            let _e389 = type_24(array<array<u32, 2>, 4>(_e382, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member[3]), type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1);
                            let _e401 = type_24(array<array<u32, 2>, 4>(_e389.member[0], array<u32, 2>(_e364.member_1, _e389.member[1][1]), _e389.member[2], _e389.member[3]), _e389.member_1);
                            let _e402 = array<u32, 2>(_e364.member_1, _e364.member_3);
                            let _e409 = type_24(array<array<u32, 2>, 4>(_e401.member[0], _e402, _e401.member[2], _e401.member[3]), _e401.member_1);
                            if !((_e375.member_3 == 4294967295u)) {
                                phi_916_ = array<u32, 2>(_e364.member_3, _e364.member_3);
                            } else {
                                phi_916_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e416 = phi_916_;
                            let _e423 = type_24(array<array<u32, 2>, 4>(_e409.member[0], _e409.member[1], _e416, _e409.member[3]), _e409.member_1);
                            let _e426 = type_24(_e423.member, _e423.member);
                            if ((((((_e372.member[0] <= _e375.member_2[0]) && (_e375.member[0] <= _e372.member_2[0])) && (_e372.member[1] <= _e375.member_2[1])) && (_e375.member[1] <= _e372.member_2[1])) && (_e372.member[2] <= _e375.member_2[2])) && (_e375.member[2] <= _e372.member_2[2])) {
                                phi_953_ = _e402;
                            } else {
                                phi_953_ = array<u32, 2>(4294967295u, 4294967295u);
                            }
                            let _e455 = phi_953_;
                            phi_955_ = type_24(_e426.member, array<array<u32, 2>, 4>(_e426.member_1[0], _e455, _e426.member_1[2], _e426.member_1[3]));
                        }
                        let _e464 = phi_955_;
                        phi_956_ = _e464;
                        phi_957_ = false;
                    } else {
                        phi_956_ = type_24();
                        phi_957_ = true;
                    }
                    let _e466 = phi_956_;
                    let _e468 = phi_957_;
                    phi_958_ = _e466;
                    phi_959_ = _e468;
                } else {
                    phi_958_ = type_24();
                    phi_959_ = true;
                }
                let _e470 = phi_958_;
                let _e472 = phi_959_;
                if _e472 {
                    let _e475 = !((_e364.member_3 == 4294967295u));
                    let _e478 = !((_e366.member_3 == 4294967295u));
                    if _e475 {
                        phi_975_ = true;
                    } else {
                        phi_975_ = _e478;
                    }
                    let _e480 = phi_975_;
                    if _e480 {
                        if _e475 {
                            if _e478 {
                                if (_e356 == 0u) {
                                    let _e508 = ((((_e366.member_2[0] - _e366.member[0]) * (_e366.member_2[1] - _e366.member[1])) * (_e366.member_2[2] - _e366.member[2])) > (((_e364.member_2[0] - _e364.member[0]) * (_e364.member_2[1] - _e364.member[1])) * (_e364.member_2[2] - _e364.member[2])));
                                    phi_1019_ = _e508;
                                    phi_1020_ = !(_e508);
                                } else {
                                    phi_1019_ = _e478;
                                    phi_1020_ = _e475;
                                }
                                let _e511 = phi_1019_;
                                let _e513 = phi_1020_;
                                phi_1021_ = _e511;
                                phi_1022_ = _e513;
                            } else {
                                phi_1021_ = _e478;
                                phi_1022_ = _e475;
                            }
                            let _e515 = phi_1021_;
                            let _e517 = phi_1022_;
                            phi_1023_ = _e515;
                            phi_1024_ = _e517;
                        } else {
                            phi_1023_ = _e478;
                            phi_1024_ = _e475;
                        }
                        let _e519 = phi_1023_;
                        let _e521 = phi_1024_;
                        if _e521 {
                            if _e519 {
                                let _e524 = a_nodes.member[_e364.member_1];
                                let _e529 = a_nodes.member[_e364.member_3];
                                let _e534 = b_nodes.member[_e366.member_1];
                                let _e539 = b_nodes.member[_e366.member_3];
                                let _e544 = array<u32, 2>(_e364.member_1, _e366.member_1);
                                let _e547 = array<u32, 2>(_e364.member_1, _e366.member_3);
                                let _e550 = array<u32, 2>(_e364.member_3, _e366.member_1);
                                let _e553 = array<u32, 2>(_e364.member_3, _e366.member_3);
                                if ((((((_e524.member[0] <= _e534.member_2[0]) && (_e534.member[0] <= _e524.member_2[0])) && (_e524.member[1] <= _e534.member_2[1])) && (_e534.member[1] <= _e524.member_2[1])) && (_e524.member[2] <= _e534.member_2[2])) && (_e534.member[2] <= _e524.member_2[2])) {
                                    phi_1130_ = _e544;
                                } else {
                                    phi_1130_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e579 = phi_1130_;
                                if ((((((_e524.member[0] <= _e539.member_2[0]) && (_e539.member[0] <= _e524.member_2[0])) && (_e524.member[1] <= _e539.member_2[1])) && (_e539.member[1] <= _e524.member_2[1])) && (_e524.member[2] <= _e539.member_2[2])) && (_e539.member[2] <= _e524.member_2[2])) {
                                    phi_1159_ = _e547;
                                } else {
                                    phi_1159_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e604 = phi_1159_;
                                if ((((((_e529.member[0] <= _e534.member_2[0]) && (_e534.member[0] <= _e529.member_2[0])) && (_e529.member[1] <= _e534.member_2[1])) && (_e534.member[1] <= _e529.member_2[1])) && (_e529.member[2] <= _e534.member_2[2])) && (_e534.member[2] <= _e529.member_2[2])) {
                                    phi_1188_ = _e550;
                                } else {
                                    phi_1188_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e629 = phi_1188_;
                                if ((((((_e529.member[0] <= _e539.member_2[0]) && (_e539.member[0] <= _e529.member_2[0])) && (_e529.member[1] <= _e539.member_2[1])) && (_e539.member[1] <= _e529.member_2[1])) && (_e529.member[2] <= _e539.member_2[2])) && (_e539.member[2] <= _e529.member_2[2])) {
                                    phi_1217_ = _e553;
                                } else {
                                    phi_1217_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e654 = phi_1217_;
                                phi_1219_ = type_24(array<array<u32, 2>, 4>(_e544, _e547, _e550, _e553), array<array<u32, 2>, 4>(_e579, _e604, _e629, _e654));
                                phi_1220_ = false;
                            } else {
                                phi_1219_ = type_24();
                                phi_1220_ = true;
                            }
                            let _e658 = phi_1219_;
                            let _e660 = phi_1220_;
                            phi_1221_ = _e658;
                            phi_1222_ = _e660;
                        } else {
                            phi_1221_ = type_24();
                            phi_1222_ = true;
                        }
                        let _e662 = phi_1221_;
                        let _e664 = phi_1222_;
                        if _e664 {
                            if _e521 {
                                let _e749 = a_nodes.member[_e364.member_1];
                                let _e754 = a_nodes.member[_e364.member_3];
                                if ((((((_e749.member[0] <= _e366.member_2[0]) && (_e366.member[0] <= _e749.member_2[0])) && (_e749.member[1] <= _e366.member_2[1])) && (_e366.member[1] <= _e749.member_2[1])) && (_e749.member[2] <= _e366.member_2[2])) && (_e366.member[2] <= _e749.member_2[2])) {
                                    phi_1295_ = array<u32, 2>(_e364.member_1, _e348[1]);
                                } else {
                                    phi_1295_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e787 = phi_1295_;
                                let _e794 = type_24(type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(_e787, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                if ((((((_e754.member[0] <= _e366.member_2[0]) && (_e366.member[0] <= _e754.member_2[0])) && (_e754.member[1] <= _e366.member_2[1])) && (_e366.member[1] <= _e754.member_2[1])) && (_e754.member[2] <= _e366.member_2[2])) && (_e366.member[2] <= _e754.member_2[2])) {
                                    phi_1327_ = array<u32, 2>(_e364.member_3, _e348[1]);
                                } else {
                                    phi_1327_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e821 = phi_1327_;
                                phi_1429_ = type_24(_e794.member, array<array<u32, 2>, 4>(_e794.member_1[0], _e821, _e794.member_1[2], _e794.member_1[3]));
                            } else {
                                let _e667 = b_nodes.member[_e366.member_1];
                                let _e672 = b_nodes.member[_e366.member_3];
                                if ((((((_e364.member[0] <= _e667.member_2[0]) && (_e667.member[0] <= _e364.member_2[0])) && (_e364.member[1] <= _e667.member_2[1])) && (_e667.member[1] <= _e364.member_2[1])) && (_e364.member[2] <= _e667.member_2[2])) && (_e667.member[2] <= _e364.member_2[2])) {
                                    phi_1395_ = array<u32, 2>(_e348[0], _e366.member_1);
                                } else {
                                    phi_1395_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e705 = phi_1395_;
                                let _e712 = type_24(type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member, array<array<u32, 2>, 4>(_e705, type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[1], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[2], type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u))).member_1[3]));
                                if ((((((_e364.member[0] <= _e672.member_2[0]) && (_e672.member[0] <= _e364.member_2[0])) && (_e364.member[1] <= _e672.member_2[1])) && (_e672.member[1] <= _e364.member_2[1])) && (_e364.member[2] <= _e672.member_2[2])) && (_e672.member[2] <= _e364.member_2[2])) {
                                    phi_1427_ = array<u32, 2>(_e348[0], _e366.member_3);
                                } else {
                                    phi_1427_ = array<u32, 2>(4294967295u, 4294967295u);
                                }
                                let _e739 = phi_1427_;
                                phi_1429_ = type_24(_e712.member, array<array<u32, 2>, 4>(_e712.member_1[0], _e739, _e712.member_1[2], _e712.member_1[3]));
                            }
                            let _e830 = phi_1429_;
                            phi_1430_ = _e830;
                        } else {
                            phi_1430_ = _e662;
                        }
                        let _e832 = phi_1430_;
                        phi_1431_ = _e832;
                        phi_1432_ = false;
                    } else {
                        phi_1431_ = type_24();
                        phi_1432_ = true;
                    }
                    let _e834 = phi_1431_;
                    let _e836 = phi_1432_;
                    phi_1433_ = _e834;
                    phi_1434_ = type_24(array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)), array<array<u32, 2>, 4>(array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u), array<u32, 2>(4294967295u, 4294967295u)));
                    phi_1435_ = _e836;
                } else {
                    phi_1433_ = type_24();
                    phi_1434_ = _e470;
                    phi_1435_ = true;
                }
                let _e838 = phi_1433_;
                let _e840 = phi_1434_;
                let _e842 = phi_1435_;
                if _e842 {
                    phi_1439_ = _e840;
                } else {
                    phi_1439_ = _e838;
                }
                let _e844 = phi_1439_;
                let _e849 = params.member.member_2.member;
                if (_e849 == 0u) {
                    phi_1452_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_1452_ = array<u32, 2>(1u, 1u);
                }
                let _e852 = phi_1452_;
                let _e858 = params.member.member.member[_e852[0]];
                let _e863 = params.member.member.member[_e852[1]];
                if (_e844.member_1[0][0] == 4294967295u) {
                    phi_1494_ = 0u;
                } else {
                    if (_e844.member_1[0][0] >= (_e858 - 1u)) {
                        if (_e844.member_1[0][1] >= (_e863 - 1u)) {
                            phi_1488_ = false;
                        } else {
                            phi_1488_ = true;
                        }
                        let _e872 = phi_1488_;
                        phi_1489_ = _e872;
                    } else {
                        phi_1489_ = true;
                    }
                    let _e874 = phi_1489_;
                    if _e874 {
                        phi_1493_ = 1u;
                    } else {
                        phi_1493_ = 2u;
                    }
                    let _e876 = phi_1493_;
                    phi_1494_ = _e876;
                }
                let _e878 = phi_1494_;
                if (_e878 == 2u) {
                    let _e930 = params.member.member_1.member_3;
                    let _e933 = a_nodes.member[_e844.member_1[0][0]];
                    let _e937 = b_nodes.member[_e844.member_1[0][1]];
                    let _e941 = params.member.member_2.member;
                    if (_e941 == 1u) {
                        if (_e933.member_1 < _e937.member_1) {
                            phi_1545_ = type_9(_e933.member_1, _e937.member_1);
                        } else {
                            phi_1545_ = type_9(_e937.member_1, _e933.member_1);
                        }
                        let _e948 = phi_1545_;
                        phi_1550_ = _e948;
                    } else {
                        phi_1550_ = type_9(_e933.member_1, _e937.member_1);
                    }
                    let _e950 = phi_1550_;
                    let _e954 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e954 + 1u) < _e954) {
                        let _e958 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e954 < _e930) {
                        let _e960 = (2u * _e954);
                        atomicStore((&pairs.member[(4u + _e960)]), _e950.member);
                        atomicStore((&pairs.member[(_e960 + 5u)]), _e950.member_1);
                    }
                } else {
                    if (_e878 == 1u) {
                        let _e883 = params.member.member_2.member_10;
                        let _e885 = local.member_2;
                        if (64u < _e883) {
                            phi_1590_ = 64u;
                        } else {
                            phi_1590_ = _e883;
                        }
                        let _e888 = phi_1590_;
                        let _e889 = (_e885 < _e888);
                        if _e889 {
                            let _e892 = local.member_2;
                            local.member[_e892] = _e844.member_1[0][0];
                            let _e897 = local.member_2;
                            local.member_1[_e897] = _e844.member_1[0][1];
                            let _e902 = local.member_2;
                            local.member_2 = (_e902 + 1u);
                        }
                        if _e889 {
                        } else {
                            let _e906 = params.member.member_1.member_1;
                            let _e909 = atomicAdd((&rounds.member[(_e906 + 1u)]), 1u);
                            let _e912 = atomicMax((&output.member[0u]), (_e909 + 1u));
                            if ((_e909 + 1u) < _e909) {
                                let _e916 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e919 = params.member.member_2.member_3;
                            if (_e909 < _e919) {
                                let _e923 = (2u * _e909);
                                atomicStore((&output.member[(4u + _e923)]), _e844.member_1[0][0]);
                                atomicStore((&output.member[(_e923 + 5u)]), _e844.member_1[0][1]);
                            }
                        }
                    }
                }
                let _e968 = params.member.member_2.member;
                if (_e968 == 0u) {
                    phi_1669_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_1669_ = array<u32, 2>(1u, 1u);
                }
                let _e971 = phi_1669_;
                let _e977 = params.member.member.member[_e971[0]];
                let _e982 = params.member.member.member[_e971[1]];
                if (_e844.member_1[1][0] == 4294967295u) {
                    phi_1711_ = 0u;
                } else {
                    if (_e844.member_1[1][0] >= (_e977 - 1u)) {
                        if (_e844.member_1[1][1] >= (_e982 - 1u)) {
                            phi_1705_ = false;
                        } else {
                            phi_1705_ = true;
                        }
                        let _e991 = phi_1705_;
                        phi_1706_ = _e991;
                    } else {
                        phi_1706_ = true;
                    }
                    let _e993 = phi_1706_;
                    if _e993 {
                        phi_1710_ = 1u;
                    } else {
                        phi_1710_ = 2u;
                    }
                    let _e995 = phi_1710_;
                    phi_1711_ = _e995;
                }
                let _e997 = phi_1711_;
                if (_e997 == 2u) {
                    let _e1049 = params.member.member_1.member_3;
                    let _e1052 = a_nodes.member[_e844.member_1[1][0]];
                    let _e1056 = b_nodes.member[_e844.member_1[1][1]];
                    let _e1060 = params.member.member_2.member;
                    if (_e1060 == 1u) {
                        if (_e1052.member_1 < _e1056.member_1) {
                            phi_1762_ = type_9(_e1052.member_1, _e1056.member_1);
                        } else {
                            phi_1762_ = type_9(_e1056.member_1, _e1052.member_1);
                        }
                        let _e1067 = phi_1762_;
                        phi_1767_ = _e1067;
                    } else {
                        phi_1767_ = type_9(_e1052.member_1, _e1056.member_1);
                    }
                    let _e1069 = phi_1767_;
                    let _e1073 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e1073 + 1u) < _e1073) {
                        let _e1077 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e1073 < _e1049) {
                        let _e1079 = (2u * _e1073);
                        atomicStore((&pairs.member[(4u + _e1079)]), _e1069.member);
                        atomicStore((&pairs.member[(_e1079 + 5u)]), _e1069.member_1);
                    }
                } else {
                    if (_e997 == 1u) {
                        let _e1002 = params.member.member_2.member_10;
                        let _e1004 = local.member_2;
                        if (64u < _e1002) {
                            phi_1807_ = 64u;
                        } else {
                            phi_1807_ = _e1002;
                        }
                        let _e1007 = phi_1807_;
                        let _e1008 = (_e1004 < _e1007);
                        if _e1008 {
                            let _e1011 = local.member_2;
                            local.member[_e1011] = _e844.member_1[1][0];
                            let _e1016 = local.member_2;
                            local.member_1[_e1016] = _e844.member_1[1][1];
                            let _e1021 = local.member_2;
                            local.member_2 = (_e1021 + 1u);
                        }
                        if _e1008 {
                        } else {
                            let _e1025 = params.member.member_1.member_1;
                            let _e1028 = atomicAdd((&rounds.member[(_e1025 + 1u)]), 1u);
                            let _e1031 = atomicMax((&output.member[0u]), (_e1028 + 1u));
                            if ((_e1028 + 1u) < _e1028) {
                                let _e1035 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e1038 = params.member.member_2.member_3;
                            if (_e1028 < _e1038) {
                                let _e1042 = (2u * _e1028);
                                atomicStore((&output.member[(4u + _e1042)]), _e844.member_1[1][0]);
                                atomicStore((&output.member[(_e1042 + 5u)]), _e844.member_1[1][1]);
                            }
                        }
                    }
                }
                let _e1087 = params.member.member_2.member;
                if (_e1087 == 0u) {
                    phi_1886_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_1886_ = array<u32, 2>(1u, 1u);
                }
                let _e1090 = phi_1886_;
                let _e1096 = params.member.member.member[_e1090[0]];
                let _e1101 = params.member.member.member[_e1090[1]];
                if (_e844.member_1[2][0] == 4294967295u) {
                    phi_1928_ = 0u;
                } else {
                    if (_e844.member_1[2][0] >= (_e1096 - 1u)) {
                        if (_e844.member_1[2][1] >= (_e1101 - 1u)) {
                            phi_1922_ = false;
                        } else {
                            phi_1922_ = true;
                        }
                        let _e1110 = phi_1922_;
                        phi_1923_ = _e1110;
                    } else {
                        phi_1923_ = true;
                    }
                    let _e1112 = phi_1923_;
                    if _e1112 {
                        phi_1927_ = 1u;
                    } else {
                        phi_1927_ = 2u;
                    }
                    let _e1114 = phi_1927_;
                    phi_1928_ = _e1114;
                }
                let _e1116 = phi_1928_;
                if (_e1116 == 2u) {
                    let _e1168 = params.member.member_1.member_3;
                    let _e1171 = a_nodes.member[_e844.member_1[2][0]];
                    let _e1175 = b_nodes.member[_e844.member_1[2][1]];
                    let _e1179 = params.member.member_2.member;
                    if (_e1179 == 1u) {
                        if (_e1171.member_1 < _e1175.member_1) {
                            phi_1979_ = type_9(_e1171.member_1, _e1175.member_1);
                        } else {
                            phi_1979_ = type_9(_e1175.member_1, _e1171.member_1);
                        }
                        let _e1186 = phi_1979_;
                        phi_1984_ = _e1186;
                    } else {
                        phi_1984_ = type_9(_e1171.member_1, _e1175.member_1);
                    }
                    let _e1188 = phi_1984_;
                    let _e1192 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e1192 + 1u) < _e1192) {
                        let _e1196 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e1192 < _e1168) {
                        let _e1198 = (2u * _e1192);
                        atomicStore((&pairs.member[(4u + _e1198)]), _e1188.member);
                        atomicStore((&pairs.member[(_e1198 + 5u)]), _e1188.member_1);
                    }
                } else {
                    if (_e1116 == 1u) {
                        let _e1121 = params.member.member_2.member_10;
                        let _e1123 = local.member_2;
                        if (64u < _e1121) {
                            phi_2024_ = 64u;
                        } else {
                            phi_2024_ = _e1121;
                        }
                        let _e1126 = phi_2024_;
                        let _e1127 = (_e1123 < _e1126);
                        if _e1127 {
                            let _e1130 = local.member_2;
                            local.member[_e1130] = _e844.member_1[2][0];
                            let _e1135 = local.member_2;
                            local.member_1[_e1135] = _e844.member_1[2][1];
                            let _e1140 = local.member_2;
                            local.member_2 = (_e1140 + 1u);
                        }
                        if _e1127 {
                        } else {
                            let _e1144 = params.member.member_1.member_1;
                            let _e1147 = atomicAdd((&rounds.member[(_e1144 + 1u)]), 1u);
                            let _e1150 = atomicMax((&output.member[0u]), (_e1147 + 1u));
                            if ((_e1147 + 1u) < _e1147) {
                                let _e1154 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e1157 = params.member.member_2.member_3;
                            if (_e1147 < _e1157) {
                                let _e1161 = (2u * _e1147);
                                atomicStore((&output.member[(4u + _e1161)]), _e844.member_1[2][0]);
                                atomicStore((&output.member[(_e1161 + 5u)]), _e844.member_1[2][1]);
                            }
                        }
                    }
                }
                let _e1206 = params.member.member_2.member;
                if (_e1206 == 0u) {
                    phi_2103_ = array<u32, 2>(0u, 2u);
                } else {
                    phi_2103_ = array<u32, 2>(1u, 1u);
                }
                let _e1209 = phi_2103_;
                let _e1215 = params.member.member.member[_e1209[0]];
                let _e1220 = params.member.member.member[_e1209[1]];
                if (_e844.member_1[3][0] == 4294967295u) {
                    phi_2145_ = 0u;
                } else {
                    if (_e844.member_1[3][0] >= (_e1215 - 1u)) {
                        if (_e844.member_1[3][1] >= (_e1220 - 1u)) {
                            phi_2139_ = false;
                        } else {
                            phi_2139_ = true;
                        }
                        let _e1229 = phi_2139_;
                        phi_2140_ = _e1229;
                    } else {
                        phi_2140_ = true;
                    }
                    let _e1231 = phi_2140_;
                    if _e1231 {
                        phi_2144_ = 1u;
                    } else {
                        phi_2144_ = 2u;
                    }
                    let _e1233 = phi_2144_;
                    phi_2145_ = _e1233;
                }
                let _e1235 = phi_2145_;
                if (_e1235 == 2u) {
                    let _e1287 = params.member.member_1.member_3;
                    let _e1290 = a_nodes.member[_e844.member_1[3][0]];
                    let _e1294 = b_nodes.member[_e844.member_1[3][1]];
                    let _e1298 = params.member.member_2.member;
                    if (_e1298 == 1u) {
                        if (_e1290.member_1 < _e1294.member_1) {
                            phi_2196_ = type_9(_e1290.member_1, _e1294.member_1);
                        } else {
                            phi_2196_ = type_9(_e1294.member_1, _e1290.member_1);
                        }
                        let _e1305 = phi_2196_;
                        phi_2201_ = _e1305;
                    } else {
                        phi_2201_ = type_9(_e1290.member_1, _e1294.member_1);
                    }
                    let _e1307 = phi_2201_;
                    let _e1311 = atomicAdd((&pairs.member[0u]), 1u);
                    if ((_e1311 + 1u) < _e1311) {
                        let _e1315 = atomicAdd((&pairs.member[2u]), 1u);
                    }
                    if (_e1311 < _e1287) {
                        let _e1317 = (2u * _e1311);
                        atomicStore((&pairs.member[(4u + _e1317)]), _e1307.member);
                        atomicStore((&pairs.member[(_e1317 + 5u)]), _e1307.member_1);
                    }
                } else {
                    if (_e1235 == 1u) {
                        let _e1240 = params.member.member_2.member_10;
                        let _e1242 = local.member_2;
                        if (64u < _e1240) {
                            phi_2241_ = 64u;
                        } else {
                            phi_2241_ = _e1240;
                        }
                        let _e1245 = phi_2241_;
                        let _e1246 = (_e1242 < _e1245);
                        if _e1246 {
                            let _e1249 = local.member_2;
                            local.member[_e1249] = _e844.member_1[3][0];
                            let _e1254 = local.member_2;
                            local.member_1[_e1254] = _e844.member_1[3][1];
                            let _e1259 = local.member_2;
                            local.member_2 = (_e1259 + 1u);
                        }
                        if _e1246 {
                        } else {
                            let _e1263 = params.member.member_1.member_1;
                            let _e1266 = atomicAdd((&rounds.member[(_e1263 + 1u)]), 1u);
                            let _e1269 = atomicMax((&output.member[0u]), (_e1266 + 1u));
                            if ((_e1266 + 1u) < _e1266) {
                                let _e1273 = atomicAdd((&output.member[2u]), 1u);
                            }
                            let _e1276 = params.member.member_2.member_3;
                            if (_e1266 < _e1276) {
                                let _e1280 = (2u * _e1266);
                                atomicStore((&output.member[(4u + _e1280)]), _e844.member_1[3][0]);
                                atomicStore((&output.member[(_e1280 + 5u)]), _e844.member_1[3][1]);
                            }
                        }
                    }
                }
                phi_2309_ = true;
            }
            let _e1323 = phi_2309_;
            phi_2310_ = _e1323;
        } else {
            phi_2310_ = false;
        }
        let _e1325 = phi_2310_;
        continue;
        continuing {
            phi_755_ = _e325;
            break if !(_e1325);
        }
    }
    phi_2313_ = type_9(0u, 64u);
    loop {
        let _e1328 = phi_2313_;
        if (_e1328.member < _e1328.member_1) {
            phi_2314_ = type_9((_e1328.member + 1u), _e1328.member_1);
            phi_2337_ = type_9(1u, _e1328.member);
        } else {
            phi_2314_ = _e1328;
            phi_2337_ = type_9(0u, type_9().member_1);
        }
        let _e1340 = phi_2314_;
        let _e1342 = phi_2337_;
        if (bitcast<i32>(_e1342.member) != 0i) {
            let _e1347 = local.member_2;
            if (_e1347 > 0u) {
                let _e1351 = local.member_2;
                local.member_2 = (_e1351 - 1u);
                let _e1354 = local.member_2;
                let _e1357 = local.member[_e1354];
                let _e1360 = local.member_1[_e1354];
                phi_2372_ = array<u32, 2>(_e1357, _e1360);
            } else {
                phi_2372_ = array<u32, 2>(4294967295u, 4294967295u);
            }
            let _e1363 = phi_2372_;
            if (_e1363[0] == 4294967295u) {
                phi_2415_ = false;
            } else {
                let _e1368 = params.member.member_1.member_1;
                let _e1371 = atomicAdd((&rounds.member[(_e1368 + 1u)]), 1u);
                let _e1374 = atomicMax((&output.member[0u]), (_e1371 + 1u));
                if ((_e1371 + 1u) < _e1371) {
                    let _e1378 = atomicAdd((&output.member[2u]), 1u);
                }
                let _e1381 = params.member.member_2.member_3;
                if (_e1371 < _e1381) {
                    let _e1385 = (2u * _e1371);
                    atomicStore((&output.member[(4u + _e1385)]), _e1363[0]);
                    atomicStore((&output.member[(_e1385 + 5u)]), _e1363[1]);
                }
                phi_2415_ = true;
            }
            let _e1391 = phi_2415_;
            phi_2416_ = _e1391;
        } else {
            phi_2416_ = false;
        }
        let _e1393 = phi_2416_;
        continue;
        continuing {
            phi_2313_ = _e1340;
            break if !(_e1393);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn descend_stacks(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
