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
var<workgroup> counters: array<atomic<u32>, 8>;
var<workgroup> firsts: array<u32, 8>;
var<workgroup> columns: array<type_24, 128>;
var<workgroup> names: array<u32, 128>;
var<workgroup> hits: array<u32, 2048>;
@group(0) @binding(2) 
var<storage> worlds: type_11;
@group(0) @binding(3) 
var<storage> input: type_11;
@group(0) @binding(4) 
var<storage, read_write> output: type_31;
var<workgroup> ranges: array<u32, 128>;

fn function_(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: array<u32, 3>;
    var phi_141_: u32;
    var phi_173_: u32;
    var phi_174_: u32;
    var phi_182_: u32;
    var phi_198_: u32;
    var phi_219_: u32;
    var phi_220_: u32;
    var phi_223_: type_9;
    var phi_224_: type_9;
    var phi_247_: type_9;
    var phi_288_: u32;
    var phi_289_: u32;
    var phi_297_: u32;
    var phi_309_: u32;
    var phi_364_: array<u32, 2>;
    var phi_389_: type_9;
    var phi_392_: u32;
    var phi_390_: type_9;
    var phi_415_: type_9;
    var phi_393_: u32;
    var local_1: u32;
    var local_2: u32;
    var phi_433_: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_442_: u32;
    var phi_485_: type_9;
    var phi_488_: u32;
    var phi_486_: type_9;
    var phi_511_: type_9;
    var phi_489_: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_529_: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_538_: u32;
    var phi_580_: array<u32, 2>;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_789_: type_24;
    var phi_798_: bool;
    var phi_805_: type_9;
    var phi_808_: u32;
    var phi_806_: type_9;
    var phi_831_: type_9;
    var phi_896_: bool;
    var phi_897_: bool;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_903_: bool;
    var phi_920_: bool;
    var phi_938_: u32;
    var phi_939_: u32;
    var phi_940_: u32;
    var phi_941_: u32;
    var phi_809_: u32;
    var phi_944_: type_9;
    var phi_947_: u32;
    var phi_945_: type_9;
    var phi_970_: type_9;
    var phi_1020_: u32;
    var phi_1021_: bool;
    var phi_948_: u32;
    var phi_1022_: bool;
    var phi_1029_: u32;
    var phi_1062_: type_9;
    var phi_1063_: type_9;
    var phi_1086_: type_9;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var local_9: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e42 = id_2;
    let _e43 = n_2;
    let _e44 = lane_2;
    let _e54 = ((_e42.y * _e43.x) + _e42.x);
    let _e57 = (_e43.x * _e43.y);
    let _e60 = params.member.member_1.member_2;
    let _e62 = input.member[0u];
    if (_e60 < _e62) {
        phi_141_ = _e60;
    } else {
        phi_141_ = _e62;
    }
    let _e65 = phi_141_;
    let _e66 = (_e44 / 32u);
    let _e67 = (_e44 % 32u);
    let _e70 = params.member.member_1.member_1;
    if (_e65 > _e70) {
        let _e74 = params.member.member_1.member_1;
        let _e75 = (_e65 - _e74);
        let _e78 = params.member.member_2.member_3;
        if (_e78 == 0u) {
            return;
        }
        let _e80 = (_e75 / _e78);
        if (_e78 == 0u) {
            return;
        }
        if ((_e75 % _e78) > 0u) {
            phi_173_ = (_e80 + 1u);
        } else {
            phi_173_ = _e80;
        }
        let _e86 = phi_173_;
        phi_174_ = _e86;
    } else {
        phi_174_ = 0u;
    }
    let _e88 = phi_174_;
    let _e91 = params.member.member_2.member_4;
    if (_e91 < _e88) {
        phi_182_ = _e91;
    } else {
        phi_182_ = _e88;
    }
    let _e94 = phi_182_;
    let _e95 = (_e94 / 4u);
    if ((_e94 % 4u) > 0u) {
        phi_198_ = (_e95 + 1u);
    } else {
        phi_198_ = _e95;
    }
    let _e100 = phi_198_;
    if (_e100 > _e54) {
        let _e102 = (_e100 - _e54);
        if (_e57 == 0u) {
            return;
        }
        let _e104 = (_e102 / _e57);
        if (_e57 == 0u) {
            return;
        }
        if ((_e102 % _e57) > 0u) {
            phi_219_ = (_e104 + 1u);
        } else {
            phi_219_ = _e104;
        }
        let _e110 = phi_219_;
        phi_220_ = _e110;
    } else {
        phi_220_ = 0u;
    }
    let _e112 = phi_220_;
    phi_223_ = type_9(0u, _e112);
    loop {
        let _e115 = phi_223_;
        if (_e115.member < _e115.member_1) {
            phi_224_ = type_9((_e115.member + 1u), _e115.member_1);
            phi_247_ = type_9(1u, _e115.member);
        } else {
            phi_224_ = _e115;
            phi_247_ = type_9(0u, type_9().member_1);
        }
        let _e127 = phi_224_;
        let _e129 = phi_247_;
        let _e133 = (bitcast<i32>(_e129.member) != 0i);
        if _e133 {
            let _e137 = (((_e54 + (_e129.member_1 * _e57)) * 4u) + _e66);
            let _e140 = params.member.member_1.member_1;
            if (_e65 > _e140) {
                let _e144 = params.member.member_1.member_1;
                let _e145 = (_e65 - _e144);
                let _e148 = params.member.member_2.member_3;
                if (_e148 == 0u) {
                    return;
                }
                let _e150 = (_e145 / _e148);
                if (_e148 == 0u) {
                    return;
                }
                if ((_e145 % _e148) > 0u) {
                    phi_288_ = (_e150 + 1u);
                } else {
                    phi_288_ = _e150;
                }
                let _e156 = phi_288_;
                phi_289_ = _e156;
            } else {
                phi_289_ = 0u;
            }
            let _e158 = phi_289_;
            let _e161 = params.member.member_2.member_4;
            if (_e161 < _e158) {
                phi_297_ = _e161;
            } else {
                phi_297_ = _e158;
            }
            let _e164 = phi_297_;
            let _e165 = (_e137 < _e164);
            let _e168 = params.member.member_1.member_1;
            if _e165 {
                let _e171 = params.member.member_2.member_3;
                phi_309_ = (_e137 * _e171);
            } else {
                phi_309_ = 0u;
            }
            let _e174 = phi_309_;
            let _e176 = (2u * (_e168 + _e174));
            let _e179 = input.member[(4u + _e176)];
            let _e182 = input.member[(_e176 + 5u)];
            if (_e44 < 8u) {
                atomicStore((&counters[_e44]), 0u);
            }
            workgroupBarrier();
            if (_e67 == 0u) {
                firsts[(2u * _e66)] = (_e179 * 32u);
                firsts[((2u * _e66) + 1u)] = (_e182 * 32u);
            }
            let _e195 = params.member.member_2.member_1;
            if (_e195 == 0u) {
                phi_364_ = array<u32, 2>(0u, 2u);
            } else {
                phi_364_ = array<u32, 2>(1u, 1u);
            }
            let _e198 = phi_364_;
            let _e201 = params.member.member_2.member_2;
            let _e202 = (_e201 - 1u);
            let _e205 = params.member.member.member;
            local = array<u32, 3>(_e205[0], _e205[1], _e205[2]);
            let _e214 = ((_e179 * 32u) + _e67);
            let _e216 = local[_e198[0]];
            phi_389_ = type_9(0u, _e202);
            phi_392_ = 1u;
            loop {
                let _e219 = phi_389_;
                let _e221 = phi_392_;
                local_1 = _e221;
                local_2 = _e221;
                local_3 = _e221;
                local_4 = _e221;
                if (_e219.member < _e219.member_1) {
                    phi_390_ = type_9((_e219.member + 1u), _e219.member_1);
                    phi_415_ = type_9(1u, _e219.member);
                } else {
                    phi_390_ = _e219;
                    phi_415_ = type_9(0u, type_9().member_1);
                }
                let _e233 = phi_390_;
                let _e235 = phi_415_;
                let _e238 = (bitcast<i32>(_e235.member) != 0i);
                if _e238 {
                    phi_393_ = (_e221 * 32u);
                } else {
                    phi_393_ = u32();
                }
                let _e241 = phi_393_;
                continue;
                continuing {
                    phi_389_ = _e233;
                    phi_392_ = _e241;
                    break if !(_e238);
                }
            }
            let _e245 = local_1;
            if (_e245 == 0u) {
                return;
            }
            let _e248 = local_2;
            let _e249 = ((_e216 - 1u) / _e248);
            if (_e249 < _e214) {
                phi_433_ = _e249;
            } else {
                phi_433_ = _e214;
            }
            let _e252 = phi_433_;
            let _e254 = local_3;
            let _e255 = (_e252 * _e254);
            let _e257 = local_4;
            let _e259 = (_e255 + (_e257 - 1u));
            let _e260 = (_e216 - 1u);
            if (_e260 < _e259) {
                phi_442_ = _e260;
            } else {
                phi_442_ = _e259;
            }
            let _e263 = phi_442_;
            let _e267 = params.member.member_2.member[0u][_e198[0]];
            let _e270 = worlds.member[(_e267 + _e255)];
            let _e275 = worlds.member[(_e267 + _e263)];
            let _e276 = ((_e270 << bitcast<u32>(16i)) | _e275);
            let _e278 = ((_e182 * 32u) + _e67);
            let _e280 = local[_e198[1]];
            phi_485_ = type_9(0u, _e202);
            phi_488_ = 1u;
            loop {
                let _e283 = phi_485_;
                let _e285 = phi_488_;
                local_5 = _e285;
                local_6 = _e285;
                local_7 = _e285;
                local_8 = _e285;
                if (_e283.member < _e283.member_1) {
                    phi_486_ = type_9((_e283.member + 1u), _e283.member_1);
                    phi_511_ = type_9(1u, _e283.member);
                } else {
                    phi_486_ = _e283;
                    phi_511_ = type_9(0u, type_9().member_1);
                }
                let _e297 = phi_486_;
                let _e299 = phi_511_;
                let _e302 = (bitcast<i32>(_e299.member) != 0i);
                if _e302 {
                    phi_489_ = (_e285 * 32u);
                } else {
                    phi_489_ = u32();
                }
                let _e305 = phi_489_;
                continue;
                continuing {
                    phi_485_ = _e297;
                    phi_488_ = _e305;
                    break if !(_e302);
                }
            }
            let _e309 = local_5;
            if (_e309 == 0u) {
                return;
            }
            let _e312 = local_6;
            let _e313 = ((_e280 - 1u) / _e312);
            if (_e313 < _e278) {
                phi_529_ = _e313;
            } else {
                phi_529_ = _e278;
            }
            let _e316 = phi_529_;
            let _e318 = local_7;
            let _e319 = (_e316 * _e318);
            let _e321 = local_8;
            let _e323 = (_e319 + (_e321 - 1u));
            let _e324 = (_e280 - 1u);
            if (_e324 < _e323) {
                phi_538_ = _e324;
            } else {
                phi_538_ = _e323;
            }
            let _e327 = phi_538_;
            let _e331 = params.member.member_2.member[0u][_e198[1]];
            let _e334 = worlds.member[(_e331 + _e319)];
            let _e339 = worlds.member[(_e331 + _e327)];
            ranges[_e44] = ((_e334 << bitcast<u32>(16i)) | _e339);
            let _e344 = params.member.member_2.member_1;
            if (_e344 == 0u) {
                phi_580_ = array<u32, 2>(0u, 2u);
            } else {
                phi_580_ = array<u32, 2>(1u, 1u);
            }
            let _e347 = phi_580_;
            let _e350 = (_e44 / 32u);
            let _e351 = (_e44 % 32u);
            let _e355 = params.member.member_2.member_2;
            let _e359 = params.member.member_2.member[_e355][_e347[0]];
            let _e362 = nodes.member[(_e359 + _e179)];
            let _e378 = params.member.member_2.member_2;
            let _e382 = params.member.member_2.member[_e378][_e347[1]];
            let _e385 = nodes.member[(_e382 + _e182)];
            let _e401 = params.member.member_2.member_2;
            let _e408 = params.member.member_2.member[(_e401 - 1u)][_e347[0]];
            let _e411 = nodes.member[(_e408 + ((_e179 * 32u) + _e351))];
            let _e430 = params.member.member_2.member_2;
            let _e437 = params.member.member_2.member[(_e430 - 1u)][_e347[1]];
            let _e440 = nodes.member[(_e437 + ((_e182 * 32u) + _e351))];
            if _e165 {
                if ((((((_e440.member.x <= _e362.member_1.y) && (_e362.member.x <= _e440.member_1.y)) && (_e440.member.y <= _e362.member_2.x)) && (_e362.member.y <= _e440.member_2.x)) && (_e440.member_1.x <= _e362.member_2.y)) && (_e362.member_1.x <= _e440.member_2.y)) {
                    let _e466 = atomicAdd((&counters[_e350]), 1u);
                    let _e467 = ((_e350 * 32u) + _e466);
                    columns[_e467] = type_24(array<f32, 3>(_e440.member.x, _e440.member.y, _e440.member_1.x), array<f32, 3>(_e440.member_1.y, _e440.member_2.x, _e440.member_2.y));
                    names[_e467] = _e351;
                }
            }
            workgroupBarrier();
            if _e165 {
                if ((((((_e411.member.x <= _e385.member_1.y) && (_e385.member.x <= _e411.member_1.y)) && (_e411.member.y <= _e385.member_2.x)) && (_e385.member.y <= _e411.member_2.x)) && (_e411.member_1.x <= _e385.member_2.y)) && (_e385.member_1.x <= _e411.member_2.y)) {
                    phi_784_ = false;
                } else {
                    phi_784_ = true;
                }
                let _e485 = phi_784_;
                phi_785_ = _e485;
            } else {
                phi_785_ = true;
            }
            let _e487 = phi_785_;
            if _e487 {
                phi_789_ = type_24(array<f32, 3>(300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f, 300000000000000000000000000000000000000f), array<f32, 3>(-300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f, -300000000000000000000000000000000000000f));
            } else {
                phi_789_ = type_24(array<f32, 3>(_e411.member.x, _e411.member.y, _e411.member_1.x), array<f32, 3>(_e411.member_1.y, _e411.member_2.x, _e411.member_2.y));
            }
            let _e489 = phi_789_;
            let _e492 = params.member.member_2.member_1;
            if (_e492 == 1u) {
                phi_798_ = (_e179 == _e182);
            } else {
                phi_798_ = false;
            }
            let _e496 = phi_798_;
            let _e497 = (_e44 / 32u);
            let _e498 = (_e44 % 32u);
            let _e500 = atomicLoad((&counters[_e497]));
            phi_805_ = type_9(0u, _e500);
            phi_808_ = 0u;
            loop {
                let _e503 = phi_805_;
                let _e505 = phi_808_;
                local_9 = _e505;
                if (_e503.member < _e503.member_1) {
                    phi_806_ = type_9((_e503.member + 1u), _e503.member_1);
                    phi_831_ = type_9(1u, _e503.member);
                } else {
                    phi_806_ = _e503;
                    phi_831_ = type_9(0u, type_9().member_1);
                }
                let _e517 = phi_806_;
                let _e519 = phi_831_;
                let _e523 = (bitcast<i32>(_e519.member) != 0i);
                if _e523 {
                    let _e527 = names[((_e497 * 32u) + _e519.member_1)];
                    let _e531 = columns[((_e497 * 32u) + _e519.member_1)];
                    if ((((((_e489.member[0] <= _e531.member_1[0]) && (_e531.member[0] <= _e489.member_1[0])) && (_e489.member[1] <= _e531.member_1[1])) && (_e531.member[1] <= _e489.member_1[1])) && (_e489.member[2] <= _e531.member_1[2])) && (_e531.member[2] <= _e489.member_1[2])) {
                        if _e496 {
                            let _e563 = (_e498 < _e527);
                            if _e563 {
                                phi_897_ = bool();
                            } else {
                                if (_e498 == _e527) {
                                    phi_896_ = true;
                                } else {
                                    phi_896_ = false;
                                }
                                let _e566 = phi_896_;
                                phi_897_ = _e566;
                            }
                            let _e568 = phi_897_;
                            phi_898_ = _e568;
                            phi_899_ = _e563;
                        } else {
                            phi_898_ = bool();
                            phi_899_ = true;
                        }
                        let _e570 = phi_898_;
                        let _e572 = phi_899_;
                        if _e572 {
                            phi_903_ = true;
                        } else {
                            phi_903_ = _e570;
                        }
                        let _e574 = phi_903_;
                        if _e574 {
                            let _e578 = ranges[((_e497 * 32u) + _e527)];
                            if ((_e276 >> bitcast<u32>(16i)) <= (_e578 & 65535u)) {
                                phi_920_ = ((_e578 >> bitcast<u32>(16i)) <= (_e276 & 65535u));
                            } else {
                                phi_920_ = false;
                            }
                            let _e588 = phi_920_;
                            if _e588 {
                                let _e590 = atomicAdd((&counters[4u]), 1u);
                                if (_e590 < 2048u) {
                                    hits[_e590] = (((_e497 << bitcast<u32>(10i)) | (_e498 << bitcast<u32>(5i))) | _e527);
                                    phi_938_ = _e505;
                                } else {
                                    phi_938_ = (_e505 | (1u << bitcast<u32>((_e519.member_1 & 31u))));
                                }
                                let _e604 = phi_938_;
                                phi_939_ = _e604;
                            } else {
                                phi_939_ = _e505;
                            }
                            let _e606 = phi_939_;
                            phi_940_ = _e606;
                        } else {
                            phi_940_ = _e505;
                        }
                        let _e608 = phi_940_;
                        phi_941_ = _e608;
                    } else {
                        phi_941_ = _e505;
                    }
                    let _e610 = phi_941_;
                    phi_809_ = _e610;
                } else {
                    phi_809_ = u32();
                }
                let _e612 = phi_809_;
                continue;
                continuing {
                    phi_805_ = _e517;
                    phi_808_ = _e612;
                    break if !(_e523);
                }
            }
            phi_944_ = type_9(0u, 32u);
            let _e810 = local_9;
            phi_947_ = _e810;
            loop {
                let _e615 = phi_944_;
                let _e617 = phi_947_;
                if (_e615.member < _e615.member_1) {
                    phi_945_ = type_9((_e615.member + 1u), _e615.member_1);
                    phi_970_ = type_9(1u, _e615.member);
                } else {
                    phi_945_ = _e615;
                    phi_970_ = type_9(0u, type_9().member_1);
                }
                let _e629 = phi_945_;
                let _e631 = phi_970_;
                if (bitcast<i32>(_e631.member) != 0i) {
                    if (_e617 == 0u) {
                        phi_1020_ = u32();
                        phi_1021_ = false;
                    } else {
                        let _e642 = names[((_e66 * 32u) + select(firstTrailingBit(_e617), 32u, (_e617 == 0u)))];
                        let _e651 = params.member.member_1.member_3;
                        let _e653 = atomicAdd((&output.member[0u]), 1u);
                        if ((_e653 + 1u) < _e653) {
                            let _e657 = atomicAdd((&output.member[2u]), 1u);
                        }
                        if (_e653 < _e651) {
                            let _e659 = (2u * _e653);
                            atomicStore((&output.member[(4u + _e659)]), ((_e179 * 32u) + _e67));
                            atomicStore((&output.member[(_e659 + 5u)]), ((_e182 * 32u) + _e642));
                        }
                        phi_1020_ = (_e617 & (_e617 - 1u));
                        phi_1021_ = true;
                    }
                    let _e665 = phi_1020_;
                    let _e667 = phi_1021_;
                    phi_948_ = _e665;
                    phi_1022_ = _e667;
                } else {
                    phi_948_ = u32();
                    phi_1022_ = false;
                }
                let _e669 = phi_948_;
                let _e671 = phi_1022_;
                continue;
                continuing {
                    phi_944_ = _e629;
                    phi_947_ = _e669;
                    break if !(_e671);
                }
            }
            workgroupBarrier();
            let _e674 = atomicLoad((&counters[4u]));
            if (2048u < _e674) {
                phi_1029_ = 2048u;
            } else {
                phi_1029_ = _e674;
            }
            let _e677 = phi_1029_;
            if (_e44 == 0u) {
                atomicStore((&counters[5u]), _e677);
            }
            workgroupBarrier();
            if (_e44 == 0u) {
                let _e682 = atomicLoad((&counters[5u]));
                if (_e682 > 0u) {
                    let _e685 = atomicAdd((&output.member[0u]), _e682);
                    if ((_e685 + _e682) < _e685) {
                        let _e689 = atomicAdd((&output.member[2u]), 1u);
                    }
                    atomicStore((&counters[6u]), _e685);
                }
            }
            workgroupBarrier();
            let _e692 = atomicLoad((&counters[6u]));
            phi_1062_ = type_9(0u, 16u);
            loop {
                let _e694 = phi_1062_;
                if (_e694.member < _e694.member_1) {
                    phi_1063_ = type_9((_e694.member + 1u), _e694.member_1);
                    phi_1086_ = type_9(1u, _e694.member);
                } else {
                    phi_1063_ = _e694;
                    phi_1086_ = type_9(0u, type_9().member_1);
                }
                let _e706 = phi_1063_;
                let _e708 = phi_1086_;
                if (bitcast<i32>(_e708.member) != 0i) {
                    let _e714 = (_e44 + (_e708.member_1 * 128u));
                    if (_e714 >= _e677) {
                        phi_1131_ = false;
                    } else {
                        let _e717 = hits[_e714];
                        let _e720 = ((_e717 >> bitcast<u32>(10i)) & 3u);
                        let _e727 = firsts[(2u * _e720)];
                        let _e732 = firsts[((2u * _e720) + 1u)];
                        let _e736 = params.member.member_1.member_3;
                        let _e737 = (_e692 + _e714);
                        if (_e737 < _e736) {
                            let _e739 = (2u * _e737);
                            atomicStore((&output.member[(4u + _e739)]), (_e727 + ((_e717 >> bitcast<u32>(5i)) & 31u)));
                            atomicStore((&output.member[(_e739 + 5u)]), (_e732 + (_e717 & 31u)));
                        }
                        phi_1131_ = true;
                    }
                    let _e745 = phi_1131_;
                    phi_1132_ = _e745;
                } else {
                    phi_1132_ = false;
                }
                let _e747 = phi_1132_;
                continue;
                continuing {
                    phi_1062_ = _e706;
                    break if !(_e747);
                }
            }
            workgroupBarrier();
        }
        continue;
        continuing {
            phi_223_ = _e127;
            break if !(_e133);
        }
    }
    return;
}

@compute @workgroup_size(128, 1, 1) 
fn node_pairs_of_worlds(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_(id, n, lane);
}
