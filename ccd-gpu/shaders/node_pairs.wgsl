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
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> n_hits: array<u32, 1>;
var<workgroup> hits: array<u32, 512>;
var<workgroup> firsts: array<u32, 8>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_156_: u32;
    var phi_193_: u32;
    var phi_194_: u32;
    var phi_202_: u32;
    var phi_218_: u32;
    var phi_241_: u32;
    var phi_242_: u32;
    var phi_245_: type_9;
    var phi_246_: type_9;
    var phi_269_: type_9;
    var phi_316_: u32;
    var phi_317_: u32;
    var phi_325_: u32;
    var phi_339_: u32;
    var phi_399_: array<u32, 2>;
    var phi_560_: bool;
    var phi_598_: type_24;
    var phi_607_: bool;
    var phi_630_: u32;
    var phi_633_: type_9;
    var phi_636_: u32;
    var phi_634_: type_9;
    var phi_659_: type_9;
    var phi_637_: u32;
    var local: u32;
    var phi_848_: u32;
    var phi_872_: bool;
    var phi_878_: type_9;
    var phi_881_: u32;
    var phi_879_: type_9;
    var phi_904_: type_9;
    var phi_937_: bool;
    var phi_945_: u32;
    var phi_882_: u32;
    var phi_946_: u32;
    var phi_947_: u32;
    var phi_954_: type_9;
    var phi_957_: u32;
    var phi_955_: type_9;
    var phi_980_: type_9;
    var phi_1003_: bool;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1010_: bool;
    var phi_1018_: bool;
    var phi_1026_: u32;
    var phi_958_: u32;
    var phi_1027_: u32;
    var phi_1037_: type_9;
    var phi_1063_: u32;
    var phi_1066_: type_9;
    var phi_1069_: type_9;
    var phi_1067_: type_9;
    var phi_1092_: type_9;
    var phi_1109_: type_9;
    var phi_1112_: type_9;
    var phi_1113_: type_9;
    var phi_1135_: type_9;
    var phi_1169_: type_9;
    var phi_1170_: bool;
    var phi_1110_: type_9;
    var phi_1171_: bool;
    var phi_1179_: u32;
    var phi_1213_: u32;
    var phi_1236_: u32;
    var phi_1243_: type_9;
    var phi_1244_: type_9;
    var phi_1267_: type_9;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1070_: type_9;
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
        phi_156_ = _e56;
    } else {
        phi_156_ = _e58;
    }
    let _e61 = phi_156_;
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
            phi_193_ = (_e76 + 1u);
        } else {
            phi_193_ = _e76;
        }
        let _e82 = phi_193_;
        phi_194_ = _e82;
    } else {
        phi_194_ = 0u;
    }
    let _e84 = phi_194_;
    let _e87 = params.member.member_2.member_4;
    if (_e87 < _e84) {
        phi_202_ = _e87;
    } else {
        phi_202_ = _e84;
    }
    let _e90 = phi_202_;
    let _e91 = (_e90 / 4u);
    if ((_e90 % 4u) > 0u) {
        phi_218_ = (_e91 + 1u);
    } else {
        phi_218_ = _e91;
    }
    let _e96 = phi_218_;
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
            phi_241_ = (_e100 + 1u);
        } else {
            phi_241_ = _e100;
        }
        let _e106 = phi_241_;
        phi_242_ = _e106;
    } else {
        phi_242_ = 0u;
    }
    let _e108 = phi_242_;
    phi_245_ = type_9(0u, _e108);
    loop {
        let _e111 = phi_245_;
        if (_e111.member < _e111.member_1) {
            phi_246_ = type_9((_e111.member + 1u), _e111.member_1);
            phi_269_ = type_9(1u, _e111.member);
        } else {
            phi_246_ = _e111;
            phi_269_ = type_9(0u, type_9().member_1);
        }
        let _e123 = phi_246_;
        let _e125 = phi_269_;
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
                    phi_316_ = (_e147 + 1u);
                } else {
                    phi_316_ = _e147;
                }
                let _e153 = phi_316_;
                phi_317_ = _e153;
            } else {
                phi_317_ = 0u;
            }
            let _e155 = phi_317_;
            let _e158 = params.member.member_2.member_4;
            if (_e158 < _e155) {
                phi_325_ = _e158;
            } else {
                phi_325_ = _e155;
            }
            let _e161 = phi_325_;
            let _e162 = (_e134 < _e161);
            let _e165 = params.member.member_1.member_1;
            let _e168 = params.member.member_2.member_3;
            if _e162 {
                phi_339_ = (_e134 * _e168);
            } else {
                phi_339_ = 0u;
            }
            let _e171 = phi_339_;
            let _e173 = (2u * (_e165 + _e171));
            let _e176 = input.member[(4u + _e173)];
            let _e179 = input.member[(_e173 + 5u)];
            if (_e41 <= 5u) {
                atomicStore((&counters[_e41]), 0u);
            }
            workgroupBarrier();
            if ((_e41 % 32u) == 0u) {
                firsts[(2u * _e62)] = (_e176 * 32u);
                firsts[((2u * _e62) + 1u)] = (_e179 * 32u);
            }
            let _e192 = params.member.member_2.member_1;
            if (_e192 == 0u) {
                phi_399_ = array<u32, 2>(0u, 2u);
            } else {
                phi_399_ = array<u32, 2>(1u, 1u);
            }
            let _e195 = phi_399_;
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
                phi_560_ = ((((((_e253.member.x <= _e229.member_1.y) && (_e229.member.x <= _e253.member_1.y)) && (_e253.member.y <= _e229.member_2.x)) && (_e229.member.y <= _e253.member_2.x)) && (_e253.member_1.x <= _e229.member_2.y)) && (_e229.member_1.x <= _e253.member_2.y));
            } else {
                phi_560_ = false;
            }
            let _e305 = phi_560_;
            if _e162 {
                if ((((((_e280.member.x <= _e208.member_1.y) && (_e208.member.x <= _e280.member_1.y)) && (_e280.member.y <= _e208.member_2.x)) && (_e208.member.y <= _e280.member_2.x)) && (_e280.member_1.x <= _e208.member_2.y)) && (_e208.member_1.x <= _e280.member_2.y)) {
                    let _e319 = atomicAdd((&counters[_e198]), 1u);
                    let _e320 = ((_e198 * 32u) + _e319);
                    columns[_e320] = type_24(array<f32, 3>(_e280.member.x, _e280.member.y, _e280.member_1.x), array<f32, 3>(_e280.member_1.y, _e280.member_2.x, _e280.member_2.y));
                    names[_e320] = _e199;
                }
            }
            if _e305 {
                phi_598_ = type_24(array<f32, 3>(_e253.member.x, _e253.member.y, _e253.member_1.x), array<f32, 3>(_e253.member_1.y, _e253.member_2.x, _e253.member_2.y));
            } else {
                phi_598_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            }
            let _e327 = phi_598_;
            workgroupBarrier();
            let _e330 = params.member.member_2.member_1;
            if (_e330 == 1u) {
                phi_607_ = (_e176 == _e179);
            } else {
                phi_607_ = false;
            }
            let _e334 = phi_607_;
            let _e335 = (_e41 / 32u);
            let _e336 = (_e41 % 32u);
            let _e337 = (_e335 * 32u);
            let _e339 = atomicLoad((&counters[_e335]));
            let _e340 = (_e339 / 4u);
            if ((_e339 % 4u) > 0u) {
                phi_630_ = (_e340 + 1u);
            } else {
                phi_630_ = _e340;
            }
            let _e345 = phi_630_;
            phi_633_ = type_9(0u, _e345);
            phi_636_ = 0u;
            loop {
                let _e348 = phi_633_;
                let _e350 = phi_636_;
                local = _e350;
                local_1 = _e350;
                if (_e348.member < _e348.member_1) {
                    phi_634_ = type_9((_e348.member + 1u), _e348.member_1);
                    phi_659_ = type_9(1u, _e348.member);
                } else {
                    phi_634_ = _e348;
                    phi_659_ = type_9(0u, type_9().member_1);
                }
                let _e362 = phi_634_;
                let _e364 = phi_659_;
                let _e368 = (bitcast<i32>(_e364.member) != 0i);
                if _e368 {
                    let _e369 = (4u * _e364.member_1);
                    let _e372 = columns[(_e337 + _e369)];
                    let _e411 = columns[((_e337 + _e369) + 1u)];
                    let _e452 = columns[((_e337 + _e369) + 2u)];
                    let _e493 = columns[((_e337 + _e369) + 3u)];
                    phi_637_ = (_e350 | ((((select(0u, 1u, ((((((_e327.member[0] <= _e372.member_1[0]) && (_e372.member[0] <= _e327.member_1[0])) && (_e327.member[1] <= _e372.member_1[1])) && (_e372.member[1] <= _e327.member_1[1])) && (_e327.member[2] <= _e372.member_1[2])) && (_e372.member[2] <= _e327.member_1[2]))) << bitcast<u32>((_e369 & 31u))) | (select(0u, 1u, ((((((_e327.member[0] <= _e411.member_1[0]) && (_e411.member[0] <= _e327.member_1[0])) && (_e327.member[1] <= _e411.member_1[1])) && (_e411.member[1] <= _e327.member_1[1])) && (_e327.member[2] <= _e411.member_1[2])) && (_e411.member[2] <= _e327.member_1[2]))) << bitcast<u32>(((_e369 + 1u) & 31u)))) | (select(0u, 1u, ((((((_e327.member[0] <= _e452.member_1[0]) && (_e452.member[0] <= _e327.member_1[0])) && (_e327.member[1] <= _e452.member_1[1])) && (_e452.member[1] <= _e327.member_1[1])) && (_e327.member[2] <= _e452.member_1[2])) && (_e452.member[2] <= _e327.member_1[2]))) << bitcast<u32>(((_e369 + 2u) & 31u)))) | (select(0u, 1u, ((((((_e327.member[0] <= _e493.member_1[0]) && (_e493.member[0] <= _e327.member_1[0])) && (_e327.member[1] <= _e493.member_1[1])) && (_e493.member[1] <= _e327.member_1[1])) && (_e327.member[2] <= _e493.member_1[2])) && (_e493.member[2] <= _e327.member_1[2]))) << bitcast<u32>(((_e369 + 3u) & 31u)))));
                } else {
                    phi_637_ = u32();
                }
                let _e533 = phi_637_;
                continue;
                continuing {
                    phi_633_ = _e362;
                    phi_636_ = _e533;
                    break if !(_e368);
                }
            }
            if (_e339 < 32u) {
                let _e541 = local;
                phi_848_ = (_e541 & ((1u << bitcast<u32>((_e339 & 31u))) - 1u));
            } else {
                let _e898 = local_1;
                phi_848_ = _e898;
            }
            let _e544 = phi_848_;
            let _e547 = params.member.member.member_1;
            if ((_e547 & 256u) != 0u) {
                if ((bitcast<u32>(_e327.member_1[0]) & 1u) == 1u) {
                    phi_872_ = true;
                } else {
                    phi_872_ = !((_e327.member[0] <= _e327.member_1[0]));
                }
                let _e562 = phi_872_;
                if _e562 {
                    phi_878_ = type_9(0u, _e339);
                    phi_881_ = _e544;
                    loop {
                        let _e565 = phi_878_;
                        let _e567 = phi_881_;
                        local_2 = _e567;
                        if (_e565.member < _e565.member_1) {
                            phi_879_ = type_9((_e565.member + 1u), _e565.member_1);
                            phi_904_ = type_9(1u, _e565.member);
                        } else {
                            phi_879_ = _e565;
                            phi_904_ = type_9(0u, type_9().member_1);
                        }
                        let _e579 = phi_879_;
                        let _e581 = phi_904_;
                        let _e585 = (bitcast<i32>(_e581.member) != 0i);
                        if _e585 {
                            let _e588 = columns[(_e337 + _e581.member_1)];
                            if ((bitcast<u32>(_e588.member_1[0]) & 1u) == 1u) {
                                phi_937_ = true;
                            } else {
                                phi_937_ = !((_e588.member[0] <= _e588.member_1[0]));
                            }
                            let _e599 = phi_937_;
                            if _e599 {
                                phi_945_ = (_e567 & ~((1u << bitcast<u32>((_e581.member_1 & 31u)))));
                            } else {
                                phi_945_ = _e567;
                            }
                            let _e606 = phi_945_;
                            phi_882_ = _e606;
                        } else {
                            phi_882_ = u32();
                        }
                        let _e608 = phi_882_;
                        continue;
                        continuing {
                            phi_878_ = _e579;
                            phi_881_ = _e608;
                            break if !(_e585);
                        }
                    }
                    let _e909 = local_2;
                    phi_946_ = _e909;
                } else {
                    phi_946_ = _e544;
                }
                let _e611 = phi_946_;
                phi_947_ = _e611;
            } else {
                phi_947_ = _e544;
            }
            let _e613 = phi_947_;
            if _e334 {
                phi_954_ = type_9(0u, _e339);
                phi_957_ = _e613;
                loop {
                    let _e616 = phi_954_;
                    let _e618 = phi_957_;
                    local_3 = _e618;
                    if (_e616.member < _e616.member_1) {
                        phi_955_ = type_9((_e616.member + 1u), _e616.member_1);
                        phi_980_ = type_9(1u, _e616.member);
                    } else {
                        phi_955_ = _e616;
                        phi_980_ = type_9(0u, type_9().member_1);
                    }
                    let _e630 = phi_955_;
                    let _e632 = phi_980_;
                    let _e636 = (bitcast<i32>(_e632.member) != 0i);
                    if _e636 {
                        let _e639 = names[(_e337 + _e632.member_1)];
                        if _e334 {
                            let _e640 = (_e336 < _e639);
                            if _e640 {
                                phi_1004_ = bool();
                            } else {
                                if (_e336 == _e639) {
                                    phi_1003_ = true;
                                } else {
                                    phi_1003_ = false;
                                }
                                let _e643 = phi_1003_;
                                phi_1004_ = _e643;
                            }
                            let _e645 = phi_1004_;
                            phi_1005_ = _e645;
                            phi_1006_ = _e640;
                        } else {
                            phi_1005_ = bool();
                            phi_1006_ = true;
                        }
                        let _e647 = phi_1005_;
                        let _e649 = phi_1006_;
                        if _e649 {
                            phi_1010_ = true;
                        } else {
                            phi_1010_ = _e647;
                        }
                        let _e651 = phi_1010_;
                        if _e651 {
                            phi_1018_ = false;
                        } else {
                            phi_1018_ = true;
                        }
                        let _e653 = phi_1018_;
                        if _e653 {
                            phi_1026_ = (_e618 & ~((1u << bitcast<u32>((_e632.member_1 & 31u)))));
                        } else {
                            phi_1026_ = _e618;
                        }
                        let _e660 = phi_1026_;
                        phi_958_ = _e660;
                    } else {
                        phi_958_ = u32();
                    }
                    let _e662 = phi_958_;
                    continue;
                    continuing {
                        phi_954_ = _e630;
                        phi_957_ = _e662;
                        break if !(_e636);
                    }
                }
                let _e925 = local_3;
                phi_1027_ = _e925;
            } else {
                phi_1027_ = _e613;
            }
            let _e665 = phi_1027_;
            let _e667 = countOneBits(_e665);
            if (_e667 > 0u) {
                let _e670 = atomicAdd((&counters[4u]), _e667);
                phi_1037_ = type_9(_e665, _e670);
            } else {
                phi_1037_ = type_9(_e665, 0u);
            }
            let _e673 = phi_1037_;
            workgroupBarrier();
            if (_e41 == 0u) {
                let _e676 = atomicLoad((&counters[4u]));
                n_hits[0u] = _e676;
            }
            let _e679 = workgroupUniformLoad((&n_hits[0u]));
            let _e680 = (_e679 / 512u);
            if ((_e679 % 512u) > 0u) {
                phi_1063_ = (_e680 + 1u);
            } else {
                phi_1063_ = _e680;
            }
            let _e685 = phi_1063_;
            phi_1066_ = type_9(0u, _e685);
            phi_1069_ = _e673;
            loop {
                let _e688 = phi_1066_;
                let _e690 = phi_1069_;
                if (_e688.member < _e688.member_1) {
                    phi_1067_ = type_9((_e688.member + 1u), _e688.member_1);
                    phi_1092_ = type_9(1u, _e688.member);
                } else {
                    phi_1067_ = _e688;
                    phi_1092_ = type_9(0u, type_9().member_1);
                }
                let _e702 = phi_1067_;
                let _e704 = phi_1092_;
                let _e708 = (bitcast<i32>(_e704.member) != 0i);
                if _e708 {
                    let _e709 = (_e41 / 32u);
                    let _e711 = (_e704.member_1 * 512u);
                    phi_1109_ = _e690;
                    phi_1112_ = type_9(0u, countOneBits(_e690.member));
                    loop {
                        let _e716 = phi_1109_;
                        let _e718 = phi_1112_;
                        local_4 = _e716;
                        if (_e718.member < _e718.member_1) {
                            phi_1113_ = type_9((_e718.member + 1u), _e718.member_1);
                            phi_1135_ = type_9(1u, _e718.member);
                        } else {
                            phi_1113_ = _e718;
                            phi_1135_ = type_9(0u, type_9().member_1);
                        }
                        let _e730 = phi_1113_;
                        let _e732 = phi_1135_;
                        if (bitcast<i32>(_e732.member) != 0i) {
                            let _e737 = (_e716.member_1 - _e711);
                            if (_e737 >= 512u) {
                                phi_1169_ = type_9();
                                phi_1170_ = false;
                            } else {
                                let _e746 = names[((_e709 * 32u) + select(firstTrailingBit(_e716.member), 32u, (_e716.member == 0u)))];
                                hits[_e737] = (((_e709 << bitcast<u32>(10i)) | ((_e41 % 32u) << bitcast<u32>(5i))) | _e746);
                                phi_1169_ = type_9((_e716.member & (_e716.member - 1u)), (_e716.member_1 + 1u));
                                phi_1170_ = true;
                            }
                            let _e762 = phi_1169_;
                            let _e764 = phi_1170_;
                            phi_1110_ = _e762;
                            phi_1171_ = _e764;
                        } else {
                            phi_1110_ = type_9();
                            phi_1171_ = false;
                        }
                        let _e766 = phi_1110_;
                        let _e768 = phi_1171_;
                        continue;
                        continuing {
                            phi_1109_ = _e766;
                            phi_1112_ = _e730;
                            break if !(_e768);
                        }
                    }
                    workgroupBarrier();
                    let _e771 = n_hits[0u];
                    let _e772 = (_e771 - _e711);
                    if (512u < _e772) {
                        phi_1179_ = 512u;
                    } else {
                        phi_1179_ = _e772;
                    }
                    let _e775 = phi_1179_;
                    if (_e41 == 0u) {
                        atomicStore((&counters[5u]), _e775);
                    }
                    workgroupBarrier();
                    if (_e41 == 0u) {
                        let _e780 = atomicLoad((&counters[5u]));
                        if (_e780 > 0u) {
                            let _e784 = params.member.member.member_1;
                            if ((_e784 & 1024u) != 0u) {
                                let _e794 = atomicAdd((&output.member[0u]), _e780);
                                let _e795 = (_e794 + _e780);
                                if (_e795 < _e794) {
                                    phi_1213_ = 4294967295u;
                                } else {
                                    phi_1213_ = _e795;
                                }
                                let _e798 = phi_1213_;
                                let _e801 = params.member.member_1.member_3;
                                if (_e798 > _e801) {
                                    let _e804 = atomicMax((&output.member[2u]), _e798);
                                }
                                phi_1236_ = _e794;
                            } else {
                                let _e788 = atomicAdd((&output.member[0u]), _e780);
                                if ((_e788 + _e780) < _e788) {
                                    let _e792 = atomicAdd((&output.member[2u]), 1u);
                                }
                                phi_1236_ = _e788;
                            }
                            let _e806 = phi_1236_;
                            atomicStore((&counters[6u]), _e806);
                        }
                        atomicStore((&counters[5u]), 0u);
                    }
                    workgroupBarrier();
                    let _e810 = atomicLoad((&counters[6u]));
                    phi_1243_ = type_9(0u, 4u);
                    loop {
                        let _e812 = phi_1243_;
                        if (_e812.member < _e812.member_1) {
                            phi_1244_ = type_9((_e812.member + 1u), _e812.member_1);
                            phi_1267_ = type_9(1u, _e812.member);
                        } else {
                            phi_1244_ = _e812;
                            phi_1267_ = type_9(0u, type_9().member_1);
                        }
                        let _e824 = phi_1244_;
                        let _e826 = phi_1267_;
                        if (bitcast<i32>(_e826.member) != 0i) {
                            let _e832 = (_e41 + (_e826.member_1 * 128u));
                            if (_e832 >= _e775) {
                                phi_1312_ = false;
                            } else {
                                let _e835 = hits[_e832];
                                let _e838 = ((_e835 >> bitcast<u32>(10i)) & 3u);
                                let _e845 = firsts[(2u * _e838)];
                                let _e850 = firsts[((2u * _e838) + 1u)];
                                let _e854 = params.member.member_1.member_3;
                                let _e855 = (_e810 + _e832);
                                if (_e855 < _e854) {
                                    let _e857 = (2u * _e855);
                                    atomicStore((&output.member[(4u + _e857)]), (_e845 + ((_e835 >> bitcast<u32>(5i)) & 31u)));
                                    atomicStore((&output.member[(_e857 + 5u)]), (_e850 + (_e835 & 31u)));
                                }
                                phi_1312_ = true;
                            }
                            let _e863 = phi_1312_;
                            phi_1313_ = _e863;
                        } else {
                            phi_1313_ = false;
                        }
                        let _e865 = phi_1313_;
                        continue;
                        continuing {
                            phi_1243_ = _e824;
                            break if !(_e865);
                        }
                    }
                    workgroupBarrier();
                    let _e950 = local_4;
                    phi_1070_ = _e950;
                } else {
                    phi_1070_ = type_9();
                }
                let _e868 = phi_1070_;
                continue;
                continuing {
                    phi_1066_ = _e702;
                    phi_1069_ = _e868;
                    break if !(_e708);
                }
            }
        }
        continue;
        continuing {
            phi_245_ = _e123;
            break if !(_e129);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
