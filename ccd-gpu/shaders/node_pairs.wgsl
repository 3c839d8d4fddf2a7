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

struct type_16 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_31 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_18;
@group(0) @binding(1) 
var<storage> nodes: type_22;
@group(0) @binding(2) 
var<storage> input: type_11;
@group(0) @binding(3) 
var<storage, read_write> output: type_31;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> counters: array<atomic<u32>, 10>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_158_: u32;
    var phi_195_: u32;
    var phi_196_: u32;
    var phi_204_: u32;
    var phi_220_: u32;
    var phi_243_: u32;
    var phi_244_: u32;
    var phi_247_: type_9;
    var phi_248_: type_9;
    var phi_271_: type_9;
    var phi_318_: u32;
    var phi_319_: u32;
    var phi_327_: u32;
    var phi_341_: u32;
    var phi_401_: array<u32, 2>;
    var phi_562_: bool;
    var phi_600_: type_24;
    var phi_609_: bool;
    var phi_632_: u32;
    var phi_635_: type_9;
    var phi_638_: u32;
    var phi_636_: type_9;
    var phi_661_: type_9;
    var phi_639_: u32;
    var local: u32;
    var phi_850_: u32;
    var phi_874_: bool;
    var phi_880_: type_9;
    var phi_883_: u32;
    var phi_881_: type_9;
    var phi_906_: type_9;
    var phi_939_: bool;
    var phi_947_: u32;
    var phi_884_: u32;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_956_: type_9;
    var phi_959_: u32;
    var phi_957_: type_9;
    var phi_982_: type_9;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1012_: bool;
    var phi_1020_: bool;
    var phi_1028_: u32;
    var phi_960_: u32;
    var phi_1029_: u32;
    var phi_1039_: type_9;
    var phi_1065_: u32;
    var phi_1068_: type_9;
    var phi_1071_: type_9;
    var phi_1069_: type_9;
    var phi_1094_: type_9;
    var phi_1111_: type_9;
    var phi_1114_: type_9;
    var phi_1115_: type_9;
    var phi_1137_: type_9;
    var phi_1171_: type_9;
    var phi_1172_: bool;
    var phi_1112_: type_9;
    var phi_1173_: bool;
    var phi_1181_: u32;
    var phi_1218_: type_9;
    var phi_1219_: type_9;
    var phi_1242_: type_9;
    var phi_1287_: bool;
    var phi_1288_: bool;
    var phi_1072_: type_9;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: type_9;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e39 = id_2;
    let _e40 = n_2;
    let _e41 = lane_2;
    let _e50 = ((_e39.y * _e40.x) + _e39.x);
    let _e53 = (_e40.x * _e40.y);
    let _e56 = params.member.member_1.member_2;
    let _e58 = input.member[0u];
    if (_e56 < _e58) {
        phi_158_ = _e56;
    } else {
        phi_158_ = _e58;
    }
    let _e61 = phi_158_;
    let _e62 = (_e41 / 32u);
    let _e66 = params.member.member_1.member_1;
    if (_e61 > _e66) {
        let _e70 = params.member.member_1.member_1;
        let _e71 = (_e61 - _e70);
        let _e74 = params.member.member_2.member_3;
        if (_e74 == 0u) {
            return;
        }
        let _e76 = (_e71 / _e74);
        if (_e74 == 0u) {
            return;
        }
        if ((_e71 % _e74) > 0u) {
            phi_195_ = (_e76 + 1u);
        } else {
            phi_195_ = _e76;
        }
        let _e82 = phi_195_;
        phi_196_ = _e82;
    } else {
        phi_196_ = 0u;
    }
    let _e84 = phi_196_;
    let _e87 = params.member.member_2.member_4;
    if (_e87 < _e84) {
        phi_204_ = _e87;
    } else {
        phi_204_ = _e84;
    }
    let _e90 = phi_204_;
    let _e91 = (_e90 / 4u);
    if ((_e90 % 4u) > 0u) {
        phi_220_ = (_e91 + 1u);
    } else {
        phi_220_ = _e91;
    }
    let _e96 = phi_220_;
    if (_e96 > _e50) {
        let _e98 = (_e96 - _e50);
        if (_e53 == 0u) {
            return;
        }
        let _e100 = (_e98 / _e53);
        if (_e53 == 0u) {
            return;
        }
        if ((_e98 % _e53) > 0u) {
            phi_243_ = (_e100 + 1u);
        } else {
            phi_243_ = _e100;
        }
        let _e106 = phi_243_;
        phi_244_ = _e106;
    } else {
        phi_244_ = 0u;
    }
    let _e108 = phi_244_;
    phi_247_ = type_9(0u, _e108);
    loop {
        let _e111 = phi_247_;
        if (_e111.member < _e111.member_1) {
            phi_248_ = type_9((_e111.member + 1u), _e111.member_1);
            phi_271_ = type_9(1u, _e111.member);
        } else {
            phi_248_ = _e111;
            phi_271_ = type_9(0u, type_9().member_1);
        }
        let _e123 = phi_248_;
        let _e125 = phi_271_;
        let _e129 = (bitcast<i32>(_e125.member) != 0i);
        if _e129 {
            let _e134 = (((_e50 + (_e125.member_1 * _e53)) * 4u) + (_e41 / 32u));
            let _e137 = params.member.member_1.member_1;
            if (_e61 > _e137) {
                let _e141 = params.member.member_1.member_1;
                let _e142 = (_e61 - _e141);
                let _e145 = params.member.member_2.member_3;
                if (_e145 == 0u) {
                    return;
                }
                let _e147 = (_e142 / _e145);
                if (_e145 == 0u) {
                    return;
                }
                if ((_e142 % _e145) > 0u) {
                    phi_318_ = (_e147 + 1u);
                } else {
                    phi_318_ = _e147;
                }
                let _e153 = phi_318_;
                phi_319_ = _e153;
            } else {
                phi_319_ = 0u;
            }
            let _e155 = phi_319_;
            let _e158 = params.member.member_2.member_4;
            if (_e158 < _e155) {
                phi_327_ = _e158;
            } else {
                phi_327_ = _e155;
            }
            let _e161 = phi_327_;
            let _e162 = (_e134 < _e161);
            let _e165 = params.member.member_1.member_1;
            let _e168 = params.member.member_2.member_3;
            if _e162 {
                phi_341_ = (_e134 * _e168);
            } else {
                phi_341_ = 0u;
            }
            let _e171 = phi_341_;
            let _e173 = (2u * (_e165 + _e171));
            let _e176 = input.member[(4u + _e173)];
            let _e179 = input.member[(_e173 + 5u)];
            if (_e41 <= 7u) {
                atomicStore((&counters[_e41]), 0u);
            }
            workgroupBarrier();
            if ((_e41 % 32u) == 0u) {
                firsts[(2u * _e62)] = (_e176 * 32u);
                firsts[((2u * _e62) + 1u)] = (_e179 * 32u);
            }
            let _e192 = params.member.member_2.member_1;
            if (_e192 == 0u) {
                phi_401_ = array<u32, 2>(0u, 2u);
            } else {
                phi_401_ = array<u32, 2>(1u, 1u);
            }
            let _e195 = phi_401_;
            let _e198 = (_e41 / 32u);
            let _e199 = (_e41 % 32u);
            let _e201 = params.member.member_2.member_2;
            let _e205 = params.member.member_2.member[_e201][_e195[0]];
            let _e208 = nodes.member[(_e205 + _e176)];
            let _e222 = params.member.member_2.member_2;
            let _e226 = params.member.member_2.member[_e222][_e195[1]];
            let _e229 = nodes.member[(_e226 + _e179)];
            let _e243 = params.member.member_2.member_2;
            let _e250 = params.member.member_2.member[(_e243 - 1u)][_e195[0]];
            let _e253 = nodes.member[(_e250 + ((_e176 * 32u) + _e199))];
            let _e270 = params.member.member_2.member_2;
            let _e277 = params.member.member_2.member[(_e270 - 1u)][_e195[1]];
            let _e280 = nodes.member[(_e277 + ((_e179 * 32u) + _e199))];
            if _e162 {
                phi_562_ = ((((((_e253.member.x <= _e229.member_1.y) && (_e229.member.x <= _e253.member_1.y)) && (_e253.member.y <= _e229.member_2.x)) && (_e229.member.y <= _e253.member_2.x)) && (_e253.member_1.x <= _e229.member_2.y)) && (_e229.member_1.x <= _e253.member_2.y));
            } else {
                phi_562_ = false;
            }
            let _e305 = phi_562_;
            if _e162 {
                if ((((((_e280.member.x <= _e208.member_1.y) && (_e208.member.x <= _e280.member_1.y)) && (_e280.member.y <= _e208.member_2.x)) && (_e208.member.y <= _e280.member_2.x)) && (_e280.member_1.x <= _e208.member_2.y)) && (_e208.member_1.x <= _e280.member_2.y)) {
                    let _e319 = atomicAdd((&counters[_e198]), 1u);
                    let _e320 = ((_e198 * 32u) + _e319);
                    columns[_e320] = type_24(array<f32, 3>(_e280.member.x, _e280.member.y, _e280.member_1.x), array<f32, 3>(_e280.member_1.y, _e280.member_2.x, _e280.member_2.y));
                    names[_e320] = _e199;
                }
            }
            if _e305 {
                phi_600_ = type_24(array<f32, 3>(_e253.member.x, _e253.member.y, _e253.member_1.x), array<f32, 3>(_e253.member_1.y, _e253.member_2.x, _e253.member_2.y));
            } else {
                phi_600_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e327 = phi_600_;
            workgroupBarrier();
            let _e330 = params.member.member_2.member_1;
            if (_e330 == 1u) {
                phi_609_ = (_e176 == _e179);
            } else {
                phi_609_ = false;
            }
            let _e334 = phi_609_;
            let _e335 = (_e41 / 32u);
            let _e336 = (_e41 % 32u);
            let _e337 = (_e335 * 32u);
            let _e339 = atomicLoad((&counters[_e335]));
            let _e340 = (_e339 / 4u);
            if ((_e339 % 4u) > 0u) {
                phi_632_ = (_e340 + 1u);
            } else {
                phi_632_ = _e340;
            }
            let _e345 = phi_632_;
            phi_635_ = type_9(0u, _e345);
            phi_638_ = 0u;
            loop {
                let _e348 = phi_635_;
                let _e350 = phi_638_;
                local = _e350;
                local_1 = _e350;
                if (_e348.member < _e348.member_1) {
                    phi_636_ = type_9((_e348.member + 1u), _e348.member_1);
                    phi_661_ = type_9(1u, _e348.member);
                } else {
                    phi_636_ = _e348;
                    phi_661_ = type_9(0u, type_9().member_1);
                }
                let _e362 = phi_636_;
                let _e364 = phi_661_;
                let _e368 = (bitcast<i32>(_e364.member) != 0i);
                if _e368 {
                    let _e369 = (4u * _e364.member_1);
                    let _e372 = columns[(_e337 + _e369)];
                    let _e411 = columns[((_e337 + _e369) + 1u)];
                    let _e452 = columns[((_e337 + _e369) + 2u)];
                    let _e493 = columns[((_e337 + _e369) + 3u)];
                    phi_639_ = (_e350 | ((((select(0u, 1u, ((((((_e327.member[0] <= _e372.member_1[0]) && (_e372.member[0] <= _e327.member_1[0])) && (_e327.member[1] <= _e372.member_1[1])) && (_e372.member[1] <= _e327.member_1[1])) && (_e327.member[2] <= _e372.member_1[2])) && (_e372.member[2] <= _e327.member_1[2]))) << bitcast<u32>((_e369 & 31u))) | (select(0u, 1u, ((((((_e327.member[0] <= _e411.member_1[0]) && (_e411.member[0] <= _e327.member_1[0])) && (_e327.member[1] <= _e411.member_1[1])) && (_e411.member[1] <= _e327.member_1[1])) && (_e327.member[2] <= _e411.member_1[2])) && (_e411.member[2] <= _e327.member_1[2]))) << bitcast<u32>(((_e369 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e327.member[0] <= _e452.member_1[0]) && (_e452.member[0] <= _e327.member_1[0])) && (_e327.member[1] <= _e452.member_1[1])) && (_e452.member[1] <= _e327.member_1[1])) && (_e327.member[2] <= _e452.member_1[2])) && (_e452.member[2] <= _e327.member_1[2]))) << bitcast<u32>(((_e369 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e327.member[0] <= _e493.member_1[0]) && (_e493.member[0] <= _e327.member_1[0])) && (_e327.member[1] <= _e493.member_1[1])) && (_e493.member[1] <= _e327.member_1[1])) && (_e327.member[2] <= _e493.member_1[2])) && (_e493.member[2] <= _e327.member_1[2]))) << bitcast<u32>(((_e369 + 3u) & 31u)))));
                } else {
                    phi_639_ = u32();
                }
                let _e533 = phi_639_;
                continue;
                continuing {
                    phi_635_ = _e362;
                    phi_638_ = _e533;
                    break if !(_e368);
                }
            }
            if (_e339 < 32u) {
                let _e541 = local;
                phi_850_ = (_e541 & ((1u << bitcast<u32>((_e339 & 31u))) - 1u));
            } else {
                let _e881 = local_1;
                phi_850_ = _e881;
            }
            let _e544 = phi_850_;
            let _e547 = params.member.member.member_1;
            if ((_e547 & 256u) != 0u) {
                if ((bitcast<u32>(_e327.member_1[0]) & 1u) == 1u) {
                    phi_874_ = true;
                } else {
                    phi_874_ = !((_e327.member[0] <= _e327.member_1[0]));
                }
                let _e562 = phi_874_;
                if _e562 {
                    phi_880_ = type_9(0u, _e339);
                    phi_883_ = _e544;
                    loop {
                        let _e565 = phi_880_;
                        let _e567 = phi_883_;
                        local_2 = _e567;
                        if (_e565.member < _e565.member_1) {
                            phi_881_ = type_9((_e565.member + 1u), _e565.member_1);
                            phi_906_ = type_9(1u, _e565.member);
                        } else {
                            phi_881_ = _e565;
                            phi_906_ = type_9(0u, type_9().member_1);
                        }
                        let _e579 = phi_881_;
                        let _e581 = phi_906_;
                        let _e585 = (bitcast<i32>(_e581.member) != 0i);
                        if _e585 {
                            let _e588 = columns[(_e337 + _e581.member_1)];
                            if ((bitcast<u32>(_e588.member_1[0]) & 1u) == 1u) {
                                phi_939_ = true;
                            } else {
                                phi_939_ = !((_e588.member[0] <= _e588.member_1[0]));
                            }
                            let _e599 = phi_939_;
                            if _e599 {
                                phi_947_ = (_e567 & ~((1u << bitcast<u32>((_e581.member_1 & 31u)))));
                            } else {
                                phi_947_ = _e567;
                            }
                            let _e606 = phi_947_;
                            phi_884_ = _e606;
                        } else {
                            phi_884_ = u32();
                        }
                        let _e608 = phi_884_;
                        continue;
                        continuing {
                            phi_880_ = _e579;
                            phi_883_ = _e608;
                            break if !(_e585);
                        }
                    }
                    let _e892 = local_2;
                    phi_948_ = _e892;
                } else {
                    phi_948_ = _e544;
                }
                let _e611 = phi_948_;
                phi_949_ = _e611;
            } else {
                phi_949_ = _e544;
            }
            let _e613 = phi_949_;
            if _e334 {
                phi_956_ = type_9(0u, _e339);
                phi_959_ = _e613;
                loop {
                    let _e616 = phi_956_;
                    let _e618 = phi_959_;
                    local_3 = _e618;
                    if (_e616.member < _e616.member_1) {
                        phi_957_ = type_9((_e616.member + 1u), _e616.member_1);
                        phi_982_ = type_9(1u, _e616.member);
                    } else {
                        phi_957_ = _e616;
                        phi_982_ = type_9(0u, type_9().member_1);
                    }
                    let _e630 = phi_957_;
                    let _e632 = phi_982_;
                    let _e636 = (bitcast<i32>(_e632.member) != 0i);
                    if _e636 {
                        let _e639 = names[(_e337 + _e632.member_1)];
                        if _e334 {
                            let _e640 = (_e336 < _e639);
                            if _e640 {
                                phi_1006_ = bool();
                            } else {
                                if (_e336 == _e639) {
                                    phi_1005_ = true;
                                } else {
                                    phi_1005_ = false;
                                }
                                let _e643 = phi_1005_;
                                phi_1006_ = _e643;
                            }
                            let _e645 = phi_1006_;
                            phi_1007_ = _e645;
                            phi_1008_ = _e640;
                        } else {
                            phi_1007_ = bool();
                            phi_1008_ = true;
                        }
                        let _e647 = phi_1007_;
                        let _e649 = phi_1008_;
                        if _e649 {
                            phi_1012_ = true;
                        } else {
                            phi_1012_ = _e647;
                        }
                        let _e651 = phi_1012_;
                        if _e651 {
                            phi_1020_ = false;
                        } else {
                            phi_1020_ = true;
                        }
                        let _e653 = phi_1020_;
                        if _e653 {
                            phi_1028_ = (_e618 & ~((1u << bitcast<u32>((_e632.member_1 & 31u)))));
                        } else {
                            phi_1028_ = _e618;
                        }
                        let _e660 = phi_1028_;
                        phi_960_ = _e660;
                    } else {
                        phi_960_ = u32();
                    }
                    let _e662 = phi_960_;
                    continue;
                    continuing {
                        phi_956_ = _e630;
                        phi_959_ = _e662;
                        break if !(_e636);
                    }
                }
                let _e908 = local_3;
                phi_1029_ = _e908;
            } else {
                phi_1029_ = _e613;
            }
            let _e665 = phi_1029_;
            let _e667 = countOneBits(_e665);
            if (_e667 > 0u) {
                let _e670 = atomicAdd((&counters[4u]), _e667);
                phi_1039_ = type_9(_e665, _e670);
            } else {
                phi_1039_ = type_9(_e665, 0u);
            }
            let _e673 = phi_1039_;
            workgroupBarrier();
            if (_e41 == 0u) {
                let _e676 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e676;
            }
            let _e679 = workgroupUniformLoad((&n_hits[0u]));
            let _e680 = (_e679 / 512u);
            if ((_e679 % 512u) > 0u) {
                phi_1065_ = (_e680 + 1u);
            } else {
                phi_1065_ = _e680;
            }
            let _e685 = phi_1065_;
            phi_1068_ = type_9(0u, _e685);
            phi_1071_ = _e673;
            loop {
                let _e688 = phi_1068_;
                let _e690 = phi_1071_;
                if (_e688.member < _e688.member_1) {
                    phi_1069_ = type_9((_e688.member + 1u), _e688.member_1);
                    phi_1094_ = type_9(1u, _e688.member);
                } else {
                    phi_1069_ = _e688;
                    phi_1094_ = type_9(0u, type_9().member_1);
                }
                let _e702 = phi_1069_;
                let _e704 = phi_1094_;
                let _e708 = (bitcast<i32>(_e704.member) != 0i);
                if _e708 {
                    let _e709 = (_e41 / 32u);
                    let _e711 = (_e704.member_1 * 512u);
                    phi_1111_ = _e690;
                    phi_1114_ = type_9(0u, countOneBits(_e690.member));
                    loop {
                        let _e716 = phi_1111_;
                        let _e718 = phi_1114_;
                        local_4 = _e716;
                        if (_e718.member < _e718.member_1) {
                            phi_1115_ = type_9((_e718.member + 1u), _e718.member_1);
                            phi_1137_ = type_9(1u, _e718.member);
                        } else {
                            phi_1115_ = _e718;
                            phi_1137_ = type_9(0u, type_9().member_1);
                        }
                        let _e730 = phi_1115_;
                        let _e732 = phi_1137_;
                        if (bitcast<i32>(_e732.member) != 0i) {
                            let _e737 = (_e716.member_1 - _e711);
                            if (_e737 >= 512u) {
                                phi_1171_ = type_9();
                                phi_1172_ = false;
                            } else {
                                let _e746 = names[((_e709 * 32u) + select(firstTrailingBit(_e716.member), 32u, (_e716.member == 0u)))];
                                hits[_e737] = (((_e709 << bitcast<u32>(10i)) | ((_e41 % 32u) << bitcast<u32>(5i))) | _e746);
                                phi_1171_ = type_9((_e716.member & (_e716.member - 1u)), (_e716.member_1 + 1u));
                                phi_1172_ = true;
                            }
                            let _e762 = phi_1171_;
                            let _e764 = phi_1172_;
                            phi_1112_ = _e762;
                            phi_1173_ = _e764;
                        } else {
                            phi_1112_ = type_9();
                            phi_1173_ = false;
                        }
                        let _e766 = phi_1112_;
                        let _e768 = phi_1173_;
                        continue;
                        continuing {
                            phi_1111_ = _e766;
                            phi_1114_ = _e730;
                            break if !(_e768);
                        }
                    }
                    workgroupBarrier();
                    let _e771 = n_hits[0u];
                    let _e772 = (_e771 - _e711);
                    if (512u < _e772) {
                        phi_1181_ = 512u;
                    } else {
                        phi_1181_ = _e772;
                    }
                    let _e775 = phi_1181_;
                    if (_e41 == 0u) {
                        atomicStore((&counters[7u]), _e775);
                    }
                    workgroupBarrier();
                    if (_e41 == 0u) {
                        let _e780 = atomicLoad((&counters[7u]));
                        if (_e780 > 0u) {
                            let _e783 = atomicAdd((&output.member[0u]), _e780);
                            if ((_e783 + _e780) < _e783) {
                                let _e787 = atomicAdd((&output.member[2u]), 1u);
                            }
                            atomicStore((&counters[8u]), _e783);
                        }
                        atomicStore((&counters[5u]), 0u);
                        atomicStore((&counters[6u]), 0u);
                        atomicStore((&counters[7u]), 0u);
                    }
                    workgroupBarrier();
                    let _e793 = atomicLoad((&counters[8u]));
                    phi_1218_ = type_9(0u, 4u);
                    loop {
                        let _e795 = phi_1218_;
                        if (_e795.member < _e795.member_1) {
                            phi_1219_ = type_9((_e795.member + 1u), _e795.member_1);
                            phi_1242_ = type_9(1u, _e795.member);
                        } else {
                            phi_1219_ = _e795;
                            phi_1242_ = type_9(0u, type_9().member_1);
                        }
                        let _e807 = phi_1219_;
                        let _e809 = phi_1242_;
                        if (bitcast<i32>(_e809.member) != 0i) {
                            let _e815 = (_e41 + (_e809.member_1 * 128u));
                            if (_e815 >= _e775) {
                                phi_1287_ = false;
                            } else {
                                let _e818 = hits[_e815];
                                let _e821 = ((_e818 >> bitcast<u32>(10i)) & 3u);
                                let _e828 = firsts[(2u * _e821)];
                                let _e833 = firsts[((2u * _e821) + 1u)];
                                let _e837 = params.member.member_1.member_3;
                                let _e838 = (_e793 + _e815);
                                if (_e838 < _e837) {
                                    let _e840 = (2u * _e838);
                                    atomicStore((&output.member[(4u + _e840)]), (_e828 + ((_e818 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e840 + 5u)]), (_e833 + (_e818 & 31u)));
                                }
                                phi_1287_ = true;
                            }
                            let _e846 = phi_1287_;
                            phi_1288_ = _e846;
                        } else {
                            phi_1288_ = false;
                        }
                        let _e848 = phi_1288_;
                        continue;
                        continuing {
                            phi_1218_ = _e807;
                            break if !(_e848);
                        }
                    }
                    workgroupBarrier();
                    let _e931 = local_4;
                    phi_1072_ = _e931;
                } else {
                    phi_1072_ = type_9();
                }
                let _e851 = phi_1072_;
                continue;
                continuing {
                    phi_1068_ = _e702;
                    phi_1071_ = _e851;
                    break if !(_e708);
                }
            }
        }
        continue;
        continuing {
            phi_247_ = _e123;
            break if !(_e129);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
