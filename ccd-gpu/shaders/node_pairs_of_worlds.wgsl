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
    member: u32,
    member_1: u32,
}

struct type_17 {
    member: array<array<u32, 4>, 8>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
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
    member: vec2<f32>,
    member_1: vec2<f32>,
    member_2: vec2<f32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_31 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_19;
@group(0) @binding(1) 
var<storage> nodes: type_23;
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_25, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(3) 
var<storage> input: type_10;
@group(0) @binding(2) 
var<storage> worlds: type_10;
@group(0) @binding(4) 
var<storage, read_write> output: type_31;
var<workgroup> ranges: array<u32, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var phi_134_: u32;
    var phi_146_: array<u32, 2>;
    var phi_196_: u32;
    var phi_197_: u32;
    var phi_205_: u32;
    var phi_221_: u32;
    var phi_242_: u32;
    var phi_243_: u32;
    var phi_246_: type_13;
    var phi_247_: type_13;
    var phi_270_: type_13;
    var phi_311_: u32;
    var phi_312_: u32;
    var phi_320_: u32;
    var phi_332_: u32;
    var phi_383_: type_13;
    var phi_386_: u32;
    var phi_384_: type_13;
    var phi_409_: type_13;
    var phi_387_: u32;
    var local: u32;
    var local_1: u32;
    var phi_427_: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_436_: u32;
    var phi_473_: type_13;
    var phi_476_: u32;
    var phi_474_: type_13;
    var phi_499_: type_13;
    var phi_477_: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_517_: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_526_: u32;
    var phi_568_: array<u32, 2>;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_777_: type_25;
    var phi_786_: bool;
    var phi_791_: type_13;
    var phi_792_: type_13;
    var phi_815_: type_13;
    var phi_831_: bool;
    var phi_889_: bool;
    var phi_940_: u32;
    var phi_973_: type_13;
    var phi_974_: type_13;
    var phi_997_: type_13;
    var phi_1042_: bool;
    var phi_1043_: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e39 = id_2;
    let _e40 = n_2;
    let _e41 = lane_2;
    let _e51 = ((_e39.y * _e40.x) + _e39.x);
    let _e54 = (_e40.x * _e40.y);
    let _e57 = params.member.member_1.member_2;
    let _e59 = input.member[0u];
    if (_e57 < _e59) {
        phi_134_ = _e57;
    } else {
        phi_134_ = _e59;
    }
    let _e62 = phi_134_;
    let _e63 = (_e41 / 32u);
    let _e64 = (_e41 % 32u);
    let _e67 = params.member.member_2.member_1;
    if (_e67 == 0u) {
        phi_146_ = array<u32, 2>(0u, 2u);
    } else {
        phi_146_ = array<u32, 2>(1u, 1u);
    }
    let _e70 = phi_146_;
    let _e76 = params.member.member.member[_e70[0]];
    let _e80 = params.member.member.member[_e70[1]];
    let _e83 = params.member.member_2.member_2;
    let _e84 = (_e83 - 1u);
    let _e87 = params.member.member_1.member_1;
    if (_e62 > _e87) {
        let _e91 = params.member.member_1.member_1;
        let _e92 = (_e62 - _e91);
        let _e95 = params.member.member_2.member_3;
        if (_e95 == 0u) {
            return;
        }
        let _e97 = (_e92 / _e95);
        if (_e95 == 0u) {
            return;
        }
        if ((_e92 % _e95) > 0u) {
            phi_196_ = (_e97 + 1u);
        } else {
            phi_196_ = _e97;
        }
        let _e103 = phi_196_;
        phi_197_ = _e103;
    } else {
        phi_197_ = 0u;
    }
    let _e105 = phi_197_;
    let _e108 = params.member.member_2.member_4;
    if (_e108 < _e105) {
        phi_205_ = _e108;
    } else {
        phi_205_ = _e105;
    }
    let _e111 = phi_205_;
    let _e112 = (_e111 / 4u);
    if ((_e111 % 4u) > 0u) {
        phi_221_ = (_e112 + 1u);
    } else {
        phi_221_ = _e112;
    }
    let _e117 = phi_221_;
    if (_e117 > _e51) {
        let _e119 = (_e117 - _e51);
        if (_e54 == 0u) {
            return;
        }
        let _e121 = (_e119 / _e54);
        if (_e54 == 0u) {
            return;
        }
        if ((_e119 % _e54) > 0u) {
            phi_242_ = (_e121 + 1u);
        } else {
            phi_242_ = _e121;
        }
        let _e127 = phi_242_;
        phi_243_ = _e127;
    } else {
        phi_243_ = 0u;
    }
    let _e129 = phi_243_;
    phi_246_ = type_13(0u, _e129);
    loop {
        let _e132 = phi_246_;
        if (_e132.member < _e132.member_1) {
            phi_247_ = type_13((_e132.member + 1u), _e132.member_1);
            phi_270_ = type_13(1u, _e132.member);
        } else {
            phi_247_ = _e132;
            phi_270_ = type_13(0u, type_13().member_1);
        }
        let _e144 = phi_247_;
        let _e146 = phi_270_;
        let _e150 = (bitcast<i32>(_e146.member) != 0i);
        if _e150 {
            let _e154 = (((_e51 + (_e146.member_1 * _e54)) * 4u) + _e63);
            let _e157 = params.member.member_1.member_1;
            if (_e62 > _e157) {
                let _e161 = params.member.member_1.member_1;
                let _e162 = (_e62 - _e161);
                let _e165 = params.member.member_2.member_3;
                if (_e165 == 0u) {
                    return;
                }
                let _e167 = (_e162 / _e165);
                if (_e165 == 0u) {
                    return;
                }
                if ((_e162 % _e165) > 0u) {
                    phi_311_ = (_e167 + 1u);
                } else {
                    phi_311_ = _e167;
                }
                let _e173 = phi_311_;
                phi_312_ = _e173;
            } else {
                phi_312_ = 0u;
            }
            let _e175 = phi_312_;
            let _e178 = params.member.member_2.member_4;
            if (_e178 < _e175) {
                phi_320_ = _e178;
            } else {
                phi_320_ = _e175;
            }
            let _e181 = phi_320_;
            let _e182 = (_e154 < _e181);
            let _e185 = params.member.member_1.member_1;
            if _e182 {
                let _e188 = params.member.member_2.member_3;
                phi_332_ = (_e154 * _e188);
            } else {
                phi_332_ = 0u;
            }
            let _e191 = phi_332_;
            let _e193 = (2u * (_e185 + _e191));
            let _e196 = input.member[(4u + _e193)];
            let _e199 = input.member[(_e193 + 5u)];
            if (_e41 < 8u) {
                atomicStore((&counters[_e41]), 0u);
            }
            workgroupBarrier();
            if (_e64 == 0u) {
                firsts[(2u * _e63)] = (_e196 * 32u);
                firsts[((2u * _e63) + 1u)] = (_e199 * 32u);
            }
            let _e212 = ((_e196 * 32u) + _e64);
            phi_383_ = type_13(0u, _e84);
            phi_386_ = 1u;
            loop {
                let _e215 = phi_383_;
                let _e217 = phi_386_;
                local = _e217;
                local_1 = _e217;
                local_2 = _e217;
                local_3 = _e217;
                if (_e215.member < _e215.member_1) {
                    phi_384_ = type_13((_e215.member + 1u), _e215.member_1);
                    phi_409_ = type_13(1u, _e215.member);
                } else {
                    phi_384_ = _e215;
                    phi_409_ = type_13(0u, type_13().member_1);
                }
                let _e229 = phi_384_;
                let _e231 = phi_409_;
                let _e234 = (bitcast<i32>(_e231.member) != 0i);
                if _e234 {
                    phi_387_ = (_e217 * 32u);
                } else {
                    phi_387_ = u32();
                }
                let _e237 = phi_387_;
                continue;
                continuing {
                    phi_383_ = _e229;
                    phi_386_ = _e237;
                    break if !(_e234);
                }
            }
            let _e241 = local;
            if (_e241 == 0u) {
                return;
            }
            let _e244 = local_1;
            let _e245 = ((_e76 - 1u) / _e244);
            if (_e245 < _e212) {
                phi_427_ = _e245;
            } else {
                phi_427_ = _e212;
            }
            let _e248 = phi_427_;
            let _e250 = local_2;
            let _e251 = (_e248 * _e250);
            let _e253 = local_3;
            let _e255 = (_e251 + (_e253 - 1u));
            let _e256 = (_e76 - 1u);
            if (_e256 < _e255) {
                phi_436_ = _e256;
            } else {
                phi_436_ = _e255;
            }
            let _e259 = phi_436_;
            let _e263 = params.member.member_2.member[0u][_e70[0]];
            let _e266 = worlds.member[(_e263 + _e251)];
            let _e271 = worlds.member[(_e263 + _e259)];
            let _e272 = ((_e266 << bitcast<u32>(16i)) | _e271);
            let _e275 = ((_e199 * 32u) + _e64);
            phi_473_ = type_13(0u, _e84);
            phi_476_ = 1u;
            loop {
                let _e278 = phi_473_;
                let _e280 = phi_476_;
                local_4 = _e280;
                local_5 = _e280;
                local_6 = _e280;
                local_7 = _e280;
                if (_e278.member < _e278.member_1) {
                    phi_474_ = type_13((_e278.member + 1u), _e278.member_1);
                    phi_499_ = type_13(1u, _e278.member);
                } else {
                    phi_474_ = _e278;
                    phi_499_ = type_13(0u, type_13().member_1);
                }
                let _e292 = phi_474_;
                let _e294 = phi_499_;
                let _e297 = (bitcast<i32>(_e294.member) != 0i);
                if _e297 {
                    phi_477_ = (_e280 * 32u);
                } else {
                    phi_477_ = u32();
                }
                let _e300 = phi_477_;
                continue;
                continuing {
                    phi_473_ = _e292;
                    phi_476_ = _e300;
                    break if !(_e297);
                }
            }
            let _e304 = local_4;
            if (_e304 == 0u) {
                return;
            }
            let _e307 = local_5;
            let _e308 = ((_e80 - 1u) / _e307);
            if (_e308 < _e275) {
                phi_517_ = _e308;
            } else {
                phi_517_ = _e275;
            }
            let _e311 = phi_517_;
            let _e313 = local_6;
            let _e314 = (_e311 * _e313);
            let _e316 = local_7;
            let _e318 = (_e314 + (_e316 - 1u));
            let _e319 = (_e80 - 1u);
            if (_e319 < _e318) {
                phi_526_ = _e319;
            } else {
                phi_526_ = _e318;
            }
            let _e322 = phi_526_;
            let _e326 = params.member.member_2.member[0u][_e70[1]];
            let _e329 = worlds.member[(_e326 + _e314)];
            let _e334 = worlds.member[(_e326 + _e322)];
            ranges[_e41] = ((_e329 << bitcast<u32>(16i)) | _e334);
            let _e339 = params.member.member_2.member_1;
            if (_e339 == 0u) {
                phi_568_ = array<u32, 2>(0u, 2u);
            } else {
                phi_568_ = array<u32, 2>(1u, 1u);
            }
            let _e342 = phi_568_;
            let _e345 = (_e41 / 32u);
            let _e346 = (_e41 % 32u);
            let _e350 = params.member.member_2.member_2;
            let _e354 = params.member.member_2.member[_e350][_e342[0]];
            let _e357 = nodes.member[(_e354 + _e196)];
            let _e373 = params.member.member_2.member_2;
            let _e377 = params.member.member_2.member[_e373][_e342[1]];
            let _e380 = nodes.member[(_e377 + _e199)];
            let _e396 = params.member.member_2.member_2;
            let _e403 = params.member.member_2.member[(_e396 - 1u)][_e342[0]];
            let _e406 = nodes.member[(_e403 + ((_e196 * 32u) + _e346))];
            let _e425 = params.member.member_2.member_2;
            let _e432 = params.member.member_2.member[(_e425 - 1u)][_e342[1]];
            let _e435 = nodes.member[(_e432 + ((_e199 * 32u) + _e346))];
            if _e182 {
                if ((((((_e435.member.x <= _e357.member_1.y) && (_e357.member.x <= _e435.member_1.y)) && (_e435.member.y <= _e357.member_2.x)) && (_e357.member.y <= _e435.member_2.x)) && (_e435.member_1.x <= _e357.member_2.y)) && (_e357.member_1.x <= _e435.member_2.y)) {
                    let _e461 = atomicAdd((&counters[_e345]), 1u);
                    let _e462 = ((_e345 * 32u) + _e461);
                    columns[_e462] = type_25(array<f32, 3>(_e435.member.x, _e435.member.y, _e435.member_1.x), array<f32, 3>(_e435.member_1.y, _e435.member_2.x, _e435.member_2.y));
                    names[_e462] = _e346;
                }
            }
            workgroupBarrier();
            if _e182 {
                if ((((((_e406.member.x <= _e380.member_1.y) && (_e380.member.x <= _e406.member_1.y)) && (_e406.member.y <= _e380.member_2.x)) && (_e380.member.y <= _e406.member_2.x)) && (_e406.member_1.x <= _e380.member_2.y)) && (_e380.member_1.x <= _e406.member_2.y)) {
                    phi_772_ = false;
                } else {
                    phi_772_ = true;
                }
                let _e480 = phi_772_;
                phi_773_ = _e480;
            } else {
                phi_773_ = true;
            }
            let _e482 = phi_773_;
            if _e482 {
                phi_777_ = type_25(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_777_ = type_25(array<f32, 3>(_e406.member.x, _e406.member.y, _e406.member_1.x), array<f32, 3>(_e406.member_1.y, _e406.member_2.x, _e406.member_2.y));
            }
            let _e484 = phi_777_;
            let _e487 = params.member.member_2.member_1;
            if (_e487 == 1u) {
                phi_786_ = (_e196 == _e199);
            } else {
                phi_786_ = false;
            }
            let _e491 = phi_786_;
            let _e493 = atomicLoad((&counters[_e63]));
            phi_791_ = type_13(0u, _e493);
            loop {
                let _e496 = phi_791_;
                if (_e496.member < _e496.member_1) {
                    phi_792_ = type_13((_e496.member + 1u), _e496.member_1);
                    phi_815_ = type_13(1u, _e496.member);
                } else {
                    phi_792_ = _e496;
                    phi_815_ = type_13(0u, type_13().member_1);
                }
                let _e508 = phi_792_;
                let _e510 = phi_815_;
                let _e514 = (bitcast<i32>(_e510.member) != 0i);
                if _e514 {
                    let _e518 = names[((_e63 * 32u) + _e510.member_1)];
                    if _e491 {
                        phi_831_ = (_e64 <= _e518);
                    } else {
                        phi_831_ = true;
                    }
                    let _e521 = phi_831_;
                    let _e525 = columns[((_e63 * 32u) + _e510.member_1)];
                    if ((((((_e484.member[0] <= _e525.member_1[0]) && (_e525.member[0] <= _e484.member_1[0])) && (_e484.member[1] <= _e525.member_1[1])) && (_e525.member[1] <= _e484.member_1[1])) && (_e484.member[2] <= _e525.member_1[2])) && (_e525.member[2] <= _e484.member_1[2])) {
                        if _e521 {
                            let _e560 = ranges[((_e63 * 32u) + _e518)];
                            if ((_e272 >> bitcast<u32>(16i)) <= (_e560 & 65535u)) {
                                phi_889_ = ((_e560 >> bitcast<u32>(16i)) <= (_e272 & 65535u));
                            } else {
                                phi_889_ = false;
                            }
                            let _e570 = phi_889_;
                            if _e570 {
                                let _e572 = atomicAdd((&counters[4u]), 1u);
                                if (_e572 < 2048u) {
                                    hits[_e572] = (((_e63 << bitcast<u32>(10i)) | (_e64 << bitcast<u32>(5i))) | _e518);
                                } else {
                                    let _e580 = params.member.member_1.member_3;
                                    let _e582 = atomicAdd((&output.member[0u]), 1u);
                                    if ((_e582 + 1u) < _e582) {
                                        let _e586 = atomicAdd((&output.member[2u]), 1u);
                                    }
                                    if (_e582 < _e580) {
                                        let _e588 = (2u * _e582);
                                        atomicStore((&output.member[(4u + _e588)]), ((_e196 * 32u) + _e64));
                                        atomicStore((&output.member[(_e588 + 5u)]), ((_e199 * 32u) + _e518));
                                    }
                                }
                            }
                        }
                    }
                }
                continue;
                continuing {
                    phi_791_ = _e508;
                    break if !(_e514);
                }
            }
            workgroupBarrier();
            let _e602 = atomicLoad((&counters[4u]));
            if (2048u < _e602) {
                phi_940_ = 2048u;
            } else {
                phi_940_ = _e602;
            }
            let _e605 = phi_940_;
            if (_e41 == 0u) {
                atomicStore((&counters[5u]), _e605);
            }
            workgroupBarrier();
            if (_e41 == 0u) {
                let _e610 = atomicLoad((&counters[5u]));
                if (_e610 > 0u) {
                    let _e613 = atomicAdd((&output.member[0u]), _e610);
                    if ((_e613 + _e610) < _e613) {
                        let _e617 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e613);
                }
            }
            workgroupBarrier();
            let _e620 = atomicLoad((&counters[6u]));
            phi_973_ = type_13(0u, 16u);
            loop {
                let _e622 = phi_973_;
                if (_e622.member < _e622.member_1) {
                    phi_974_ = type_13((_e622.member + 1u), _e622.member_1);
                    phi_997_ = type_13(1u, _e622.member);
                } else {
                    phi_974_ = _e622;
                    phi_997_ = type_13(0u, type_13().member_1);
                }
                let _e634 = phi_974_;
                let _e636 = phi_997_;
                if (bitcast<i32>(_e636.member) != 0i) {
                    let _e642 = (_e41 + (_e636.member_1 * 128u));
                    if (_e642 >= _e605) {
                        phi_1042_ = false;
                    } else {
                        let _e645 = hits[_e642];
                        let _e648 = ((_e645 >> bitcast<u32>(10i)) & 3u);
                        let _e655 = firsts[(2u * _e648)];
                        let _e660 = firsts[((2u * _e648) + 1u)];
                        let _e664 = params.member.member_1.member_3;
                        let _e665 = (_e620 + _e642);
                        if (_e665 < _e664) {
                            let _e667 = (2u * _e665);
                            atomicStore((&output.member[(4u + _e667)]), (_e655 + ((_e645 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[(_e667 + 5u)]), (_e660 + (_e645 & 31u)));
                        }
                        phi_1042_ = true;
                    }
                    let _e673 = phi_1042_;
                    phi_1043_ = _e673;
                } else {
                    phi_1043_ = false;
                }
                let _e675 = phi_1043_;
                continue;
                continuing {
                    phi_973_ = _e634;
                    break if !(_e675);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_246_ = _e144;
            break if !(_e150);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
